#include "netgen/pictures/pictures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kernel/lorentz.h"
#include "netgen/pictures/svg.h"

namespace epsnet {
namespace {

using Point = PolygonPicture::Point;
using Segment = PolygonPicture::Segment;

/// A point that is drawn: those beyond what binary64 tells from the unit circle are brought back inside.
Point visible(const Point& z) {
  constexpr double kFarthest = 1 - 1e-9;
  const double radius = std::sqrt(norm(z));
  return radius > kFarthest ? kFarthest / radius * z : z;
}

Point midpoint(const Segment& segment) {
  const LorentzVector<double> sum = on_hyperboloid(visible(segment[0])) + on_hyperboloid(visible(segment[1]));
  return in_disk((1 / std::sqrt(-lorentz_product(sum, sum))) * sum);
}

/// The golden angle keeps the hues of neighbouring pairs apart.
std::string pair_colour(std::uint32_t pair) {
  return "hsl(" + fixed(std::fmod(20 + pair * 137.508, 360), 0) + ",60%,42%)";
}

class PolygonDrawing {
 public:
  PolygonDrawing(const PolygonPicture& picture, std::uint32_t size)
      : picture_(picture),
        size_(size),
        unit_(std::max(size, 700U) / 1000.0),
        paper_(size),
        pair_(picture.sides.size()) {
    for (std::uint32_t k = 0; k < pair_.size(); ++k) {
      const std::uint32_t partner = picture.sides[k].partner;
      pair_[k] = partner < k ? pair_[partner] : pairs_++;
    }
  }

  [[nodiscard]] std::string svg() const {
    std::string body = domain() + disks() + inner() + sides();
    for (const PolygonPicture::Curve& curve : picture_.curves) body += curve_group(curve);
    for (const PolygonPicture::Mark& mark : picture_.marks) body += mark_group(mark);
    return head() + body + legend() + "</svg>\n";
  }

 private:
  [[nodiscard]] std::string path_of(const std::vector<Segment>& segments) const {
    Path path(paper_);
    for (const Segment& segment : segments) {
      path.move(visible(segment[0]));
      path.geodesic(visible(segment[0]), visible(segment[1]));
    }
    return path.data();
  }

  [[nodiscard]] std::string width(double units) const { return fixed(units * unit_, 2); }

  [[nodiscard]] std::string domain() const {
    Path path(paper_);
    if (!picture_.sides.empty()) path.move(visible(picture_.sides[0].ends[0]));
    for (const PolygonPicture::Side& side : picture_.sides) path.geodesic(visible(side.ends[0]), visible(side.ends[1]));
    path.close();
    return "<path class=\"domain\" fill=\"#f1f5f9\" d=\"" + path.data() + "\"/>\n";
  }

  [[nodiscard]] std::string disks() const {
    std::string out;
    for (const PolygonPicture::Disk& disk : picture_.disks) {
      Path path(paper_);
      path.circle({0, 0}, disk.radius);
      out += "<path class=\"disk-of-radius\" fill=\"" + disk.colour + "\" fill-opacity=\"0.18\" stroke=\"" +
             disk.colour + "\" stroke-width=\"" + width(2.5) + "\" d=\"" + path.data() + "\"/>\n";
    }
    return out;
  }

  [[nodiscard]] std::string inner() const {
    if (picture_.inner.empty()) return "";
    return std::string("<path class=\"inner\" fill=\"none\" stroke=\"") + palette::kEdges + "\" stroke-width=\"" +
           width(0.8) + "\" d=\"" + path_of(picture_.inner) + "\"/>\n";
  }

  [[nodiscard]] std::string sides() const {
    std::string lines =
        "<g class=\"sides\" fill=\"none\" stroke-linecap=\"round\" stroke-width=\"" + width(3.5) + "\">\n";
    std::string labels = "<g class=\"labels\" font-family=\"sans-serif\" font-size=\"" + width(kFont) +
                         "\" text-anchor=\"middle\" stroke=\"" + palette::kPaper + "\" stroke-width=\"" + width(3) +
                         "\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
    std::vector<std::pair<Point, double>> placed;  // Labels: the middle and half of the width.
    for (std::size_t k = 0; k < picture_.sides.size(); ++k) {
      const PolygonPicture::Side& side = picture_.sides[k];
      const std::string colour = pair_colour(pair_[k]);
      lines += "<path stroke=\"" + colour + "\" d=\"" + path_of({side.ends}) + "\"/>\n";
      const Point chord = visible(side.ends[1]) - visible(side.ends[0]);
      const double length = std::sqrt(norm(chord));
      // A label that is wider than its side would stand at others.
      if (length * paper_.radius() < 0.8 * kFont * unit_) continue;
      // Outside: on the right of the side.
      const Point outward = (1.2 * kFont * unit_ / (paper_.radius() * length)) * Point{chord.y, -chord.x};
      const Point place = midpoint(side.ends) + outward;
      // Nor one that would lie on another, as at a corner that points inward.
      const double half_width = 0.3 * kFont * unit_ * static_cast<double>(side.name.size()) / paper_.radius();
      const auto is_covered = [&](const std::pair<Point, double>& other) {
        return std::abs(other.first.x - place.x) < other.second + half_width &&
               std::abs(other.first.y - place.y) < kFont * unit_ / paper_.radius();
      };
      if (std::any_of(placed.begin(), placed.end(), is_covered)) continue;
      placed.emplace_back(place, half_width);
      labels += text(place, side.name, colour);
    }
    return lines + "</g>\n" + labels + "</g>\n";
  }

  /// A text with its middle at a place, within a group that has the font.
  [[nodiscard]] std::string text(const Point& z, const std::string& what, const std::string& colour) const {
    const double x = paper_.middle() + paper_.radius() * z.x;
    const double y = paper_.middle() - paper_.radius() * z.y + 0.35 * kFont * unit_;
    return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" fill=\"" + colour + "\">" + escaped(what) +
           "</text>\n";
  }

  /// A margin of white makes it stand out from whatever is behind it.
  [[nodiscard]] std::string curve_group(const PolygonPicture::Curve& curve) const {
    const std::string data = path_of(curve.segments);
    const auto stroke = [&](const char* colour, double units) {
      return std::string("<path stroke=\"") + colour + "\" stroke-width=\"" + width(units) + "\" d=\"" + data +
             "\"/>\n";
    };
    return "<g class=\"curve\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>" +
           escaped(curve.name) + "</title>\n" + stroke(palette::kPaper, 8.5) + stroke(curve.colour.c_str(), 5) +
           "</g>\n";
  }

  [[nodiscard]] std::string mark_group(const PolygonPicture::Mark& mark) const {
    std::string out =
        "<g class=\"mark\" font-family=\"sans-serif\" font-size=\"" + width(1.2 * kFont) +
        "\" font-weight=\"bold\" text-anchor=\"middle\" stroke=\"" + palette::kPaper + "\" stroke-width=\"" + width(3) +
        "\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n<title>" + escaped(mark.name) + "</title>\n";
    for (const Point& z : mark.places) {
      const Point at = visible(z);
      out += "<circle cx=\"" + fixed(paper_.middle() + paper_.radius() * at.x, 1) + "\" cy=\"" +
             fixed(paper_.middle() - paper_.radius() * at.y, 1) + "\" r=\"" + width(8) + "\" fill=\"" + mark.colour +
             "\"/>\n";
      const double shift = 1.5 * kFont * unit_ / paper_.radius();
      if (!mark.label.empty()) out += text(at + Point{shift, shift}, mark.label, mark.colour);
    }
    return out + "</g>\n";
  }

  [[nodiscard]] std::string legend() const {
    Legend legend(1.3 * unit_);
    for (const PolygonPicture::Mark& mark : picture_.marks) legend.add(epsnet::Mark::dot, mark.colour, mark.name);
    for (const PolygonPicture::Curve& curve : picture_.curves) legend.add(epsnet::Mark::line, curve.colour, curve.name);
    for (const PolygonPicture::Disk& disk : picture_.disks) legend.add(epsnet::Mark::area, disk.colour, disk.name);
    for (const std::string& what : picture_.left_out) legend.add_text_row("left out: " + what);
    constexpr std::uint32_t kMostPairs = 16;  // More rows would lie on the domain.
    if (pairs_ > kMostPairs || pairs_ == 0) {
      if (pairs_ > 0) legend.add_text_row("sides of one colour are glued to each other");
      return legend.group();
    }
    legend.add_text_row("glued sides:");
    std::vector<std::pair<std::string, std::string>> named;
    for (std::size_t k = 0; k < pair_.size(); ++k) {
      const PolygonPicture::Side& side = picture_.sides[k];
      if (side.partner < k) continue;
      named.emplace_back(pair_colour(pair_[k]), side.name + " " + picture_.sides[side.partner].name);
    }
    legend.add_areas(named, 58);
    return legend.group();
  }

  [[nodiscard]] std::string head() const {
    const std::string size = std::to_string(size_);
    const std::string middle = fixed(paper_.middle(), 1);
    std::string desc = "A polygon in the Poincare disk. Sides of one colour are glued to each other.";
    for (const std::string& what : picture_.left_out) desc += " Left out: " + what + ".";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" + size + "\" viewBox=\"0 0 " +
           size + " " + size + "\">\n<title>" + escaped(picture_.title) + "</title>\n<desc>" + escaped(desc) +
           "</desc>\n<rect class=\"background\" width=\"" + size + "\" height=\"" + size + "\" fill=\"" +
           palette::kPaper + "\"/>\n<circle class=\"disk\" cx=\"" + middle + "\" cy=\"" + middle + "\" r=\"" +
           fixed(paper_.radius(), 2) + "\" fill=\"#fff\" stroke=\"#8a94a0\" stroke-width=\"" + width(0.8) + "\"/>\n";
  }

  static constexpr double kFont = 16;

  const PolygonPicture& picture_;
  std::uint32_t size_;
  double unit_;
  Paper paper_;
  std::vector<std::uint32_t> pair_;  ///< By side.
  std::uint32_t pairs_ = 0;
};

}  // namespace

std::string draw_svg(const PolygonPicture& picture, std::uint32_t size) { return PolygonDrawing(picture, size).svg(); }

}  // namespace epsnet
