#include <algorithm>
#include <cmath>

#include "certify/base/text.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/pictures/legend.h"
#include "netgen/pictures/palette.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg_path.h"
#include "netgen/surfaces/surface_file.h"

namespace epsnet {
namespace {

using Window = certify::EigenvaluesDocument::Window;

/// A round number, 1, 2 or 5 times a power of ten: about a seventh of the range.
double tick_step(double range) {
  const double power = std::pow(10, std::floor(std::log10(range / 7)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (range / (factor * power) <= 9) return factor * power;
  }
  return 10 * power;
}

class EigenvaluesDrawing {
 public:
  EigenvaluesDrawing(const EigenvaluesPicture& picture, std::uint32_t size)
      : picture_(picture), size_(size), unit_(size / 1000.0), end_(picture.samples.back().lambda) {
    for (const auto& [lambda, bound] : picture.samples) {
      if (lambda <= picture.up_to) top_ = std::max(top_, 1.12 * bound);
    }
  }

  [[nodiscard]] std::string svg() const {
    return head() + bands() + grid() + curve() + places() + labels() + legend() + "</svg>\n";
  }

 private:
  static constexpr double kFont = 15;
  static constexpr double kLeft = 62;
  static constexpr double kRight = 978;
  static constexpr double kTop = 152;
  static constexpr double kBottom = 560;
  static constexpr double kHeight = 620;

  [[nodiscard]] std::string length(double units) const { return fixed(units * unit_, 2); }
  [[nodiscard]] double x(double lambda) const { return kLeft + (kRight - kLeft) * lambda / end_; }
  [[nodiscard]] double y(double bound) const { return kBottom - (kBottom - kTop) * bound / top_; }

  [[nodiscard]] std::string line(double x0, double y0, double x1, double y1) const {
    return "M" + length(x0) + ' ' + length(y0) + 'L' + length(x1) + ' ' + length(y1);
  }
  [[nodiscard]] std::string stroke(const char* name, const std::string& data, const char* colour, double width,
                                   const char* more = "") const {
    return std::string("<path class=\"") + name + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
           length(width) + "\" " + more + "d=\"" + data + "\"/>\n";
  }
  /// An area of at least a width that can be seen.
  [[nodiscard]] std::string area(double from, double to, double upper, double lower, double least) const {
    const double missing = std::max(0.0, least - (to - from));
    return "<rect x=\"" + length(from - missing / 2) + "\" y=\"" + length(upper) + "\" width=\"" +
           length(to - from + missing) + "\" height=\"" + length(lower - upper) + "\"/>\n";
  }
  [[nodiscard]] std::string text(double at_x, double at_y, const std::string& what) const {
    return "<text x=\"" + length(at_x) + "\" y=\"" + length(at_y) + "\">" + escaped(what) + "</text>\n";
  }
  [[nodiscard]] std::string text_group(const char* name, const char* anchor) const {
    return std::string("<g class=\"") + name + "\" font-family=\"sans-serif\" font-size=\"" + length(kFont) +
           "\" fill=\"#1d2b3a\" text-anchor=\"" + anchor + "\">\n";
  }

  [[nodiscard]] std::string head() const {
    const std::string width = std::to_string(size_);
    const std::string height = std::to_string(std::lround(kHeight * unit_));
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height + "\">\n<title>" + escaped(picture_.title) +
           "</title>\n<desc>Numbers of eigenvalues of the Laplacian: a bound at each place, and the intervals that "
           "contain all of them.</desc>\n<rect class=\"background\" width=\"" +
           width + "\" height=\"" + height + "\" fill=\"" + palette::kPaper + "\"/>\n";
  }

  [[nodiscard]] std::string bands() const {
    std::string out =
        std::string("<g class=\"windows\" fill=\"") + palette::kCoveringDisks + "\" fill-opacity=\"0.3\">\n";
    for (const Window& window : picture_.windows) out += area(x(window.in.lower), x(window.in.upper), kTop, kBottom, 2);
    out += "</g>\n<g class=\"beyond\" fill=\"#8a94a0\" fill-opacity=\"0.25\">\n";
    return out + area(x(picture_.up_to), kRight, kTop, kBottom, 0) + "</g>\n";
  }

  [[nodiscard]] std::string grid() const {
    std::string lines;
    std::string below = text_group("eigenvalues", "middle");
    const double step = tick_step(end_);
    for (double tick = 0; tick <= end_; tick += step) {
      lines += line(x(tick), kBottom, x(tick), kBottom + 5);
      below += text(x(tick), kBottom + 22, certify::shortest(std::stod(fixed(tick, 6))));
    }
    below += text((kLeft + kRight) / 2, kBottom + 47, "\u03bb") + "</g>\n";
    std::string beside = text_group("bounds", "end");
    std::string across;
    const double bound_step = std::max(1.0, tick_step(top_));
    for (double tick = 0; tick <= top_; tick += bound_step) {
      across += line(kLeft, y(tick), kRight, y(tick));
      beside += text(kLeft - 8, y(tick) + 0.35 * kFont, certify::shortest(tick));
    }
    std::string out = stroke("grid", across, "#d5dbe2", 1) + below + beside + "</g>\n";
    if (end_ > 0.25) out += stroke("quarter", line(x(0.25), kTop, x(0.25), kBottom), palette::kEdges, 1.2, kDashes);
    return out + stroke("one", line(kLeft, y(1), kRight, y(1)), palette::kVertices, 1.4) +
           stroke("axes", lines + line(kLeft, kTop, kLeft, kBottom) + line(kLeft, kBottom, kRight, kBottom),
                  palette::kEdges, 1.2);
  }

  [[nodiscard]] std::string curve() const {
    std::string data;
    for (const auto& [lambda, bound] : picture_.samples) {
      if (bound > top_) continue;
      data += (data.empty() ? 'M' : 'L') + length(x(lambda)) + ' ' + length(y(bound));
    }
    return stroke("bound", data, palette::kPaths, 2.4, "stroke-linejoin=\"round\" ");
  }

  /// Where the eigenvalues of windows with a known number are.
  [[nodiscard]] std::string places() const {
    std::string out = std::string("<g class=\"places\" fill=\"") + palette::kDirichlet + "\">\n";
    for (const Window& window : picture_.windows) {
      if (window.least < window.most) continue;
      const bool single = window.most == 1;
      const double from = single ? window.greatest.lower : window.in.lower;
      const double to = single ? window.smallest.upper : window.in.upper;
      out += area(x(from), x(to), kBottom - 9, kBottom + 9, 3);
    }
    return out + "</g>\n";
  }

  /// The number of eigenvalues above each band; one that would be at the last one's place is higher.
  [[nodiscard]] std::string labels() const {
    std::string out = text_group("numbers", "middle");
    double last = -1000;
    double row = 0;
    for (const Window& window : picture_.windows) {
      std::string number = std::to_string(window.most);
      if (window.least < window.most) number = std::to_string(window.least) + "\u2013" + number;
      const double width = 0.6 * kFont * static_cast<double>(number.size());
      const double middle = (x(window.in.lower) + x(window.in.upper)) / 2;
      row = middle - width / 2 < last ? std::fmod(row + 1, 3) : 0;
      last = middle + width / 2 + 4;
      out += text(middle, kTop - 8 - 17 * row, number);
    }
    return out + "</g>\n";
  }

  [[nodiscard]] std::string legend() const {
    Legend legend(1.25 * unit_);
    legend.add(
        Mark::line, palette::kPaths,
        picture_.without_known
            ? "I(\u03bb), a bound for the number of eigenvalues at \u03bb that no eigenfunction shows: where it is "
              "less than 1, there is no other"
            : "I(\u03bb), a bound for the number of eigenvalues at \u03bb: where it is less than 1, there is none");
    legend.add(Mark::area, palette::kCoveringDisks,
               "windows, and above each the number of its eigenvalues: there is no "
               "other one");
    legend.add(Mark::area, palette::kDirichlet, "where eigenvalues are that are counted");
    legend.add(Mark::area, "#8a94a0", "nothing is claimed here; the dashed line is at 1/4");
    return legend.group();
  }

  static constexpr const char* kDashes = "stroke-dasharray=\"4 4\" ";

  const EigenvaluesPicture& picture_;
  std::uint32_t size_;
  double unit_;
  double end_;
  double top_ = 1.5;
};

}  // namespace

EigenvaluesPicture picture_of(const certify::EigenvaluesDocument& document) {
  EigenvaluesPicture result;
  result.up_to = document.eigenvalues_up_to;
  result.windows = document.windows;
  result.without_known = !document.eigenfunctions.empty();
  result.title = "Eigenvalues of the Laplacian up to " + certify::shortest(result.up_to);
  constexpr int kParts = 500;
  constexpr int kPartsOfWindow = 24;
  constexpr double kBeyond = 1.04;
  std::vector<double> places;
  for (int i = 0; i <= kParts; ++i) places.push_back(kBeyond * result.up_to * i / kParts);
  for (const Window& window : document.windows) {
    const double width = window.in.upper - window.in.lower;
    for (int i = -kPartsOfWindow / 2; i <= 3 * kPartsOfWindow / 2; ++i)
      places.push_back(std::clamp(window.in.lower + width * i / kPartsOfWindow, 0.0, places[kParts]));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const std::vector<double> bounds = eigenvalue_bounds(from_document(document.net.surface), document, places);
  for (std::size_t i = 0; i < places.size(); ++i) result.samples.push_back({places[i], bounds[i]});
  return result;
}

std::string draw_svg(const EigenvaluesPicture& picture, std::uint32_t size) {
  return EigenvaluesDrawing(picture, size).svg();
}

}  // namespace epsnet
