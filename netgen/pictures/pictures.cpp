#include "netgen/pictures/pictures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/lifts/lifts.h"
#include "netgen/pictures/curves.h"
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
    const Legend legend = this->legend();
    std::string body = domain() + disks() + inner() + sides(legend);
    for (const PolygonPicture::Curve& curve : picture_.curves) body += curve_group(curve);
    for (const PolygonPicture::Mark& mark : picture_.marks) body += mark_group(mark);
    return head() + body + legend.group() + "</svg>\n";
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

  [[nodiscard]] std::string sides(const Legend& legend) const {
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
      const double half_width = 0.3 * kFont * unit_ * static_cast<double>(side.name.size()) / paper_.radius();
      // Nor one that would lie on another, as at a corner that points inward.
      const auto is_covered = [&](const Point& place) {
        return std::any_of(placed.begin(), placed.end(), [&](const std::pair<Point, double>& other) {
          return std::abs(other.first.x - place.x) < other.second + half_width &&
                 std::abs(other.first.y - place.y) < kFont * unit_ / paper_.radius();
        });
      };
      // Outside, which is on the right of the side, if there is room, else inside.
      const Point outward = (1.2 * kFont * unit_ / (paper_.radius() * length)) * Point{chord.y, -chord.x};
      for (const Point& place : {midpoint(side.ends) + outward, midpoint(side.ends) - outward}) {
        if (is_covered(place) || !has_room(place, half_width, legend)) continue;
        placed.emplace_back(place, half_width);
        labels += text(place, side.name, colour);
        break;
      }
    }
    return lines + "</g>\n" + labels + "</g>\n";
  }

  /// Whether a label is in the picture and beside the legend.
  [[nodiscard]] bool has_room(const Point& place, double half_width, const Legend& legend) const {
    const double left = paper_.middle() + paper_.radius() * (place.x - half_width);
    const double right = paper_.middle() + paper_.radius() * (place.x + half_width);
    const double top = paper_.middle() - paper_.radius() * place.y - 0.5 * kFont * unit_;
    const bool is_beside = left > legend.width() || top > legend.height();
    return is_beside && left > 0 && right < size_ && top > 0 && top + kFont * unit_ < size_;
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
             fixed(paper_.middle() - paper_.radius() * at.y, 1) + "\" r=\"" + width(mark.radius) + "\" fill=\"" +
             mark.colour + "\"/>\n";
      const double shift = 1.5 * kFont * unit_ / paper_.radius();
      if (!mark.label.empty()) out += text(at + Point{shift, shift}, mark.label, mark.colour);
    }
    return out + "</g>\n";
  }

  [[nodiscard]] Legend legend() const {
    Legend legend(1.3 * unit_);
    for (const PolygonPicture::Mark& mark : picture_.marks) legend.add(epsnet::Mark::dot, mark.colour, mark.name);
    for (const PolygonPicture::Curve& curve : picture_.curves) legend.add(epsnet::Mark::line, curve.colour, curve.name);
    for (const PolygonPicture::Disk& disk : picture_.disks) legend.add(epsnet::Mark::area, disk.colour, disk.name);
    for (const std::string& what : picture_.left_out) legend.add_text_row("left out: " + what);
    constexpr std::uint32_t kMostPairs = 16;  // More rows would lie on the domain.
    if (pairs_ > kMostPairs || pairs_ == 0) {
      if (pairs_ > 0) legend.add_text_row("sides of one colour are glued to each other");
      return legend;
    }
    legend.add_text_row("glued sides:");
    std::vector<std::pair<std::string, std::string>> named;
    for (std::size_t k = 0; k < pair_.size(); ++k) {
      const PolygonPicture::Side& side = picture_.sides[k];
      if (side.partner < k) continue;
      named.emplace_back(pair_colour(pair_[k]), side.name + " " + picture_.sides[side.partner].name);
    }
    legend.add_areas(named, 58);
    return legend;
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

namespace {

using Point = Complex<double>;

constexpr std::uint32_t kNone = 0xffffffff;

/// Returns the name of a layer in the legend, for closed geodesics with their number and lengths.
std::string legend_name(const Layer& layer) {
  if (layer.parts.empty()) return layer.name;
  double shortest = layer.parts[0].length;
  double longest = shortest;
  for (const Layer::Part& part : layer.parts) {
    shortest = std::min(shortest, part.length);
    longest = std::max(longest, part.length);
  }
  // Four digits distinguish lengths of different clusters, and hide the rounding of equal lengths.
  const std::string from = fixed(shortest, 4);
  const std::string to = fixed(longest, 4);
  return layer.name + ": " + std::to_string(layer.parts.size()) +
         (from == to ? " of length " + from : " of lengths " + from + " to " + to);
}

class Picture {
 public:
  Picture(const certify::NetDocument& document, const DrawOptions& options)
      : document_(document),
        geometry_(document),
        options_(options),
        paper_(options.size),
        lifts_(lift_triangles(geometry_, options.order, options.centre)),
        epsilon_(geometry_.epsilon().get_d()),
        on_boundary_(boundary_darts(geometry_, lifts_)) {
    if (options.colouring == Colouring::values) {
      if (options.values.size() != document.vertices.size()) throw std::invalid_argument("a value for each vertex");
      greatest_value_ = *std::max_element(options.values.begin(), options.values.end());
    }
    // Edges of a net are about 1.4 ε long. Strokes must leave the triangles of fine nets white.
    const double edge = 1.4 * epsilon_ * paper_.scale({});
    const double unit = options.size / 1000.0;
    edge_width_ = std::clamp(0.03 * edge, 0.08 * unit, 1.2 * unit);
    dot_width_ = std::clamp(0.09 * edge, 0.2 * unit, 6.0 * unit);
    outline_width_ = 1.6 * unit;
  }

  [[nodiscard]] std::string svg() {
    std::string body = domain_path();
    if (options_.colouring != Colouring::none) body += colour_group();
    if (options_.covering_disks)
      body += disk_group("covering", "disks of radius epsilon", palette::kCoveringDisks, epsilon_);
    if (options_.packing_disks)
      body += disk_group("packing", "disks of radius epsilon/2", palette::kPackingDisks, epsilon_ / 2);
    for (const Layer& layer : options_.layers) body += area_group(layer);
    if (options_.triangles) body += edge_group();
    if (options_.combinatorial_dirichlet) body += combinatorial_dirichlet_path();
    for (const Layer& layer : options_.layers)
      if (!layer.in_front) body += curve_group(layer);
    for (const Layer& layer : options_.layers)
      if (!layer.left_out.empty()) left_out_.push_back(layer.name + ": " + layer.left_out);
    if (options_.dirichlet) body += dirichlet_group();
    if (options_.vertices) body += dot_group();
    for (const Layer& layer : options_.layers)
      if (layer.in_front) body += curve_group(layer);
    if (options_.legend) body += legend_group();
    return head() + body + "</svg>\n";
  }

  /// Returns what svg() could not draw, as "name: reason".
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }

 private:
  [[nodiscard]] const Lifts::LiftedTriangle& lifted(std::uint32_t dart) const {
    return lifts_.lifted[lifts_.place[dart / 3]];
  }
  [[nodiscard]] const Point& start(std::uint32_t dart) const { return lifted(dart).corner[dart % 3]; }
  [[nodiscard]] const Point& end(std::uint32_t dart) const { return lifted(dart).corner[certify::next_dart(dart) % 3]; }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t dart) const { return certify::opposite(document_, dart); }

  /// Returns the boundary dart that follows a boundary dart around the drawing: turns around its end, inside the
  /// drawing.
  [[nodiscard]] std::uint32_t next_on_boundary(std::uint32_t dart) const {
    std::uint32_t next = certify::next_dart(dart);
    for (std::size_t turns = 0; !on_boundary_[next]; ++turns) {
      if (turns > on_boundary_.size()) throw NetGeometryError("the triangles do not fit around a vertex");
      next = certify::next_dart(opposite(next));
    }
    return next;
  }

  /// Returns the drawn domain as an area. Its outline has the interior on the left; holes run the other way round.
  [[nodiscard]] std::string domain_path() const {
    return "<path class=\"domain\" fill=\"#eef2f7\" d=\"" + outline() + "\"/>\n";
  }

  [[nodiscard]] std::string outline() const {
    Path path(paper_);
    std::vector<bool> done(on_boundary_.size(), false);
    for (std::uint32_t first = 0; first < on_boundary_.size(); ++first) {
      if (!on_boundary_[first] || done[first]) continue;
      path.move(start(first));
      for (std::uint32_t dart = first; !done[dart]; dart = next_on_boundary(dart)) {
        done[dart] = true;
        path.geodesic(start(dart), end(dart));
      }
      path.close();
    }
    return path.data();
  }

  /// Returns the outline of the same triangles lifted breadth first.
  [[nodiscard]] std::string combinatorial_dirichlet_path() const {
    DrawOptions options = options_;
    options.order = DrawOrder::breadth_first;
    const std::string data =
        options_.order == DrawOrder::breadth_first ? outline() : Picture(document_, options).outline();
    return std::string("<path class=\"combinatorial-dirichlet\" fill=\"none\" stroke=\"") +
           palette::kCombinatorialDirichlet + "\" stroke-width=\"" + fixed(outline_width_, 3) + "\" d=\"" + data +
           "\"/>\n";
  }

  void add_triangle(Path& path, const Lifts::LiftedTriangle& triangle) const {
    const auto& [a, b, c] = triangle.corner;
    path.move(a);
    path.geodesic(a, b);
    path.geodesic(b, c);
    path.geodesic(c, a);
    path.close();
  }

  [[nodiscard]] bool is_visible(const Lifts::LiftedTriangle& triangle) const {
    const auto& [a, b, c] = triangle.corner;
    return std::max({norm(a - b), norm(b - c), norm(c - a)}) * paper_.radius() * paper_.radius() > 0.01;
  }

  [[nodiscard]] std::uint32_t chart_of(std::uint32_t triangle) const {
    return certify::chart_of_triangle(document_, triangle);
  }

  /// Returns the value of a triangle as a share of the greatest value, rounded down to bands so that lines of equal
  /// values can be seen.
  [[nodiscard]] double band_of(std::uint32_t triangle) const {
    constexpr double kBands = 24;
    if (!(greatest_value_ > 0)) return 0;
    double sum = 0;
    for (const std::uint32_t v : document_.triangles[triangle].vertex) sum += options_.values[v];
    return std::floor(kBands * sum / (3 * greatest_value_)) / kBands;
  }

  [[nodiscard]] std::string colour_of(std::uint32_t triangle) const {
    if (options_.colouring == Colouring::chart) return chart_colour(chart_of(triangle));
    if (options_.colouring == Colouring::values) return shade(band_of(triangle));
    return shade(2 * geometry_.circumradius(triangle) / epsilon_ - 1);
  }

  /// All triangles of a colour are one path, with a hairline around it that covers the seams left by anti-aliasing.
  [[nodiscard]] std::string colour_group() const {
    std::map<std::string, Path> paths;
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted)
      if (is_visible(triangle))
        add_triangle(paths.try_emplace(colour_of(triangle.triangle), paper_).first->second, triangle);
    std::string out = "<g class=\"colours\" stroke-width=\"0.3\" stroke-linejoin=\"round\">\n";
    for (const auto& [colour, path] : paths)
      out += "<path fill=\"" + colour + "\" stroke=\"" + colour + "\" d=\"" + path.data() + "\"/>\n";
    return out + "</g>\n";
  }

  /// Returns the disks around all drawn lifts of vertices, as one area.
  [[nodiscard]] std::string disk_group(const char* name, const char* title, const char* colour, double radius) const {
    std::set<PaperPoint> drawn;
    Path path(paper_);
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted)
      for (const Point& z : triangle.corner)
        if (drawn.insert(paper_.place(z)).second) path.circle(z, radius);
    return std::string("<path class=\"") + name + "\" fill=\"" + colour + "\" fill-opacity=\"0.15\" stroke=\"" +
           colour + "\" stroke-width=\"" + fixed(0.6 * edge_width_, 3) + "\" d=\"" + path.data() + "\"><title>" +
           title + "</title></path>\n";
  }

  [[nodiscard]] std::string area_group(const Layer& layer) const {
    if (layer.triangles.empty()) return "";
    Path path(paper_);
    for (const std::uint32_t triangle : layer.triangles) add_triangle(path, lifts_.lifted[lifts_.place[triangle]]);
    return "<path class=\"layer\" fill=\"" + layer.colour + "\" fill-opacity=\"0.6\" d=\"" + path.data() +
           "\"><title>" + escaped(layer.name) + "</title></path>\n";
  }

  [[nodiscard]] Point placed(std::uint32_t dart, const Point& z) const {
    return lifts_.placements[lifted(dart).placement[dart % 3]].rounded(z);
  }

  [[nodiscard]] PathsByWidth curves_of(const Layer& layer, double width) const {
    PathsByWidth paths(paper_, width);
    for (const Arc& arc : layer.arcs) paths.add_tapered(placed(arc.dart, arc.from), placed(arc.dart, arc.to));
    for (const std::uint32_t dart : layer.darts) paths.add_tapered(start(dart), end(dart));
    return paths;
  }

  [[nodiscard]] PathsByWidth spots_of(const Layer& layer, double width) const {
    PathsByWidth dots(paper_, width);
    for (const Spot& spot : layer.spots) {
      const Point z = placed(spot.dart, spot.z);
      dots.at(1 - norm(z)).dot(z);
    }
    return dots;
  }

  [[nodiscard]] std::string curve_group(const Layer& layer) const {
    if (layer.arcs.empty() && layer.darts.empty()) return "";
    const double unit = options_.size / 1000.0;
    const double width = layer.in_front ? 5 * unit : 1.4 * outline_width_;
    std::string out = "<g class=\"layer\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>" +
                      escaped(layer.name) + "</title>\n";
    const auto append = [&](const std::string& colour, const PathsByWidth& paths) {
      out += "<g stroke=\"" + colour + "\">\n";
      paths.append_to(out);
      out += "</g>\n";
    };
    // A margin of white makes it stand out from whatever is behind it.
    if (layer.in_front) append(palette::kPaper, curves_of(layer, width + 3 * unit));
    append(layer.colour, curves_of(layer, width));
    if (!layer.spots.empty()) append(palette::kPaper, spots_of(layer, 17 * unit));
    if (!layer.spots.empty()) append(layer.colour, spots_of(layer, 13 * unit));
    return out + "</g>\n";
  }

  /// Returns an edge that leaves the end of a dart, is not drawn yet, and is of the same kind (on the boundary or not);
  /// kNone if none is found.
  [[nodiscard]] std::uint32_t unfinished_edge_at_end(std::uint32_t dart, const std::vector<bool>& done) const {
    std::uint32_t next = certify::next_dart(dart);
    for (int turns = 0; turns < 32; ++turns) {
      if (on_boundary_[next] == on_boundary_[dart] && !done[next]) return next;
      if (on_boundary_[next]) return kNone;
      next = certify::next_dart(opposite(next));
    }
    return kNone;
  }

  [[nodiscard]] std::string edge_group() {
    PathsByWidth inner(paper_, edge_width_);
    PathsByWidth outline(paper_, std::min(1.8 * edge_width_, outline_width_));
    std::vector<bool> done(on_boundary_.size(), false);
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted) {
      for (std::uint32_t first = 3 * triangle.triangle; first < 3 * triangle.triangle + 3; ++first) {
        // Long lines, drawn without lifting the pen, make a short file.
        for (std::uint32_t dart = first; dart != kNone && !done[dart]; dart = unfinished_edge_at_end(dart, done)) {
          done[dart] = true;
          if (!on_boundary_[dart]) done[opposite(dart)] = true;
          if (!(on_boundary_[dart] ? outline : inner).add_tapered(start(dart), end(dart))) ++edges_left_out_;
        }
      }
    }
    std::string out = std::string("<g class=\"edges\" fill=\"none\" stroke=\"") + palette::kEdges +
                      "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    inner.append_to(out);
    out +=
        "</g>\n<g class=\"outline\" fill=\"none\" stroke=\"#1d2b3a\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n";
    outline.append_to(out);
    return out + "</g>\n";
  }

  /// Whether all vertices get a dot. Dots of less than half a pixel would be a grey veil, so they are left out.
  [[nodiscard]] bool shows_all_vertices() const { return dot_width_ >= 0.5; }

  [[nodiscard]] std::string dot_group() {
    PathsByWidth dots(paper_, dot_width_);
    // The dot in the centre has a white rim, so that it can be seen on dark triangles.
    const double base_width = std::max(1.6 * dot_width_, 0.006 * options_.size);
    PathsByWidth base(paper_, base_width);
    PathsByWidth rim(paper_, 1.5 * base_width);
    std::set<PaperPoint> drawn;
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Point& z = triangle.corner[i];
        const double share = std::max(0.0, 1 - norm(z));
        const bool is_base = document_.triangles[triangle.triangle].vertex[i] == options_.centre;
        if (!is_base && !shows_all_vertices()) continue;
        if (dot_width_ * share < 0.1 || !drawn.insert(paper_.place(z)).second) continue;
        (is_base ? base : dots).at(share).dot(z);
        if (is_base) rim.at(share).dot(z);
      }
    }
    std::string out;
    const auto append = [&](const char* name, const char* colour, const PathsByWidth& paths) {
      out +=
          std::string("<g class=\"") + name + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-linecap=\"round\">\n";
      paths.append_to(out);
      out += "</g>\n";
    };
    append("vertices", palette::kVertices, dots);
    append("rim", palette::kPaper, rim);
    append("base-vertex", palette::kCentre, base);
    return out;
  }

  /// Returns the vertices of the Dirichlet domain; none if they cannot be computed, and then left_out_ has the reason.
  [[nodiscard]] std::vector<Point> domain() {
    try {
      return dirichlet_domain(geometry_, options_.centre);
    } catch (const DomainNotDrawn& error) {
      left_out_.emplace_back(error.what());
      return {};
    }
  }

  [[nodiscard]] std::string dirichlet_group() {
    const std::vector<Point> domain = this->domain();
    shows_domain_ = !domain.empty();
    if (!shows_domain_) return "";
    PathsByWidth paths(paper_, 1.4 * outline_width_);
    for (std::size_t i = 0; i < domain.size(); ++i) paths.add_tapered(domain[i], domain[(i + 1) % domain.size()]);
    std::string out = std::string("<g class=\"dirichlet\" fill=\"none\" stroke=\"") + palette::kDirichlet +
                      "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
                      "<title>Dirichlet domain of vertex " +
                      std::to_string(options_.centre) + "</title>\n";
    paths.append_to(out);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string legend_group() const {
    Legend legend(std::max(options_.size, 700U) / 1000.0);
    if (options_.triangles) legend.add(Mark::line, palette::kEdges, "triangles");
    if (options_.vertices && shows_all_vertices()) legend.add(Mark::dot, palette::kVertices, "vertices");
    if (options_.vertices) legend.add(Mark::dot, palette::kCentre, "vertex " + std::to_string(options_.centre));
    if (shows_domain_) legend.add(Mark::line, palette::kDirichlet, "Dirichlet domain");
    if (options_.combinatorial_dirichlet)
      legend.add(Mark::line, palette::kCombinatorialDirichlet, "combinatorial Dirichlet domain");
    if (options_.covering_disks)
      legend.add(Mark::area, palette::kCoveringDisks, "disks of radius " + geometry_.epsilon_text());
    if (options_.packing_disks)
      legend.add(Mark::area, palette::kPackingDisks, "disks of radius " + geometry_.epsilon_text() + "/2");
    for (const Layer& layer : options_.layers) {
      if (!layer.left_out.empty()) continue;
      legend.add(layer.triangles.empty() ? Mark::line : Mark::area, layer.colour, legend_name(layer));
    }
    if (options_.colouring == Colouring::circumradius) {
      for (const double share : {0.0, 0.33, 0.67, 1.0})
        legend.add(Mark::area, shade(share),
                   "circumradius " + fixed((1 + share) / 2, 2) + " epsilon" + (share == 0 ? " or less" : ""));
    }
    if (options_.colouring == Colouring::values) {
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
        legend.add(Mark::area, shade(share), options_.values_name + " " + fixed(share * greatest_value_, 2));
    }
    if (options_.colouring == Colouring::chart) add_charts(legend);
    for (const std::string& what : left_out_) legend.add_text_row("left out: " + what);
    return legend.group();
  }

  /// Adds the colours of the charts of triangles, as far as there is room.
  void add_charts(Legend& legend) const {
    constexpr std::size_t kMost = 16;
    std::set<std::uint32_t> charts;
    for (std::uint32_t t = 0; t < document_.triangles.size(); ++t) charts.insert(chart_of(t));
    std::vector<std::pair<std::string, std::string>> named;
    for (const std::uint32_t chart : charts)
      if (named.size() < kMost) named.emplace_back(chart_colour(chart), std::to_string(chart));
    legend.add_text_row("triangles by chart:");
    legend.add_areas(named);
    if (charts.size() > kMost) legend.add_text_row("and " + std::to_string(charts.size() - kMost) + " more charts");
  }

  [[nodiscard]] std::string head() const {
    const std::string size = std::to_string(options_.size);
    const std::string middle = fixed(paper_.middle(), 1);
    const std::string title = "Delaunay triangulation with " + std::to_string(document_.vertices.size()) +
                              " vertices and " + std::to_string(document_.triangles.size()) + " triangles, epsilon " +
                              geometry_.epsilon_text();
    std::string desc = "One lift of every triangle in the Poincare disk, connected, by " +
                       std::string(options_.order == DrawOrder::weight ? "least weight |u|^2+|v|^2 of the edge crossed"
                                                                       : "breadth-first search") +
                       ", with vertex " + std::to_string(options_.centre) + " in the centre. Edges are geodesics.";
    if (shows_domain_) desc += " Red: the Dirichlet domain of vertex " + std::to_string(options_.centre) + ".";
    if (edges_left_out_ > 0)
      desc += " " + std::to_string(edges_left_out_) + " edges shorter than 0.1 pixel are left out.";
    for (const std::string& what : left_out_) desc += " Left out: " + escaped(what) + ".";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" + size + "\" viewBox=\"0 0 " +
           size + " " + size + "\">\n<title>" + title + "</title>\n<desc>" + desc +
           "</desc>\n<rect class=\"background\" width=\"" + size + "\" height=\"" + size + "\" fill=\"" +
           palette::kPaper + "\"/>\n<circle class=\"disk\" cx=\"" + middle + "\" cy=\"" + middle + "\" r=\"" +
           fixed(paper_.radius(), 2) + "\" fill=\"#fff\" stroke=\"#8a94a0\" stroke-width=\"" +
           fixed(0.8 * options_.size / 1000, 2) + "\"/>\n";
  }

  const certify::NetDocument& document_;
  NetGeometry geometry_;
  DrawOptions options_;
  Paper paper_;
  Lifts lifts_;
  double epsilon_;
  std::vector<bool> on_boundary_;  ///< By dart.
  double edge_width_ = 0;          ///< In pixels, in the centre.
  double dot_width_ = 0;
  double outline_width_ = 0;
  double greatest_value_ = 0;
  std::uint64_t edges_left_out_ = 0;
  bool shows_domain_ = false;
  std::vector<std::string> left_out_;
};

}  // namespace

std::string draw_svg(const certify::NetDocument& document, const DrawOptions& options,
                     std::vector<std::string>* left_out) {
  Picture picture(document, options);
  std::string svg = picture.svg();
  if (left_out != nullptr) left_out->insert(left_out->end(), picture.left_out().begin(), picture.left_out().end());
  return svg;
}

}  // namespace epsnet
