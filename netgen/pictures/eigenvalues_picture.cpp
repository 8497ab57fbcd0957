#include <algorithm>
#include <cmath>

#include "certify/base/text.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg.h"

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;
using Step = EigenvaluesPicture::Step;

constexpr const char* kNotCounted = "#8a94a0";
constexpr const char* kWeyl = "#5d6b7a";

/// A round number, 1, 2 or 5 times a power of ten: about a seventh of the range.
double tick_step(double range) {
  const double power = std::pow(10, std::floor(std::log10(range / 7)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (range / (factor * power) <= 9) return factor * power;
  }
  return 10 * power;
}

/// What a row says: from λ on there are at least so many, or up to λ at most so many.
struct Bounds {
  std::vector<Step> least;
  std::vector<Step> most;
};

Bounds bounds_of(const EigenvaluesDocument& document) {
  Bounds result;
  std::uint32_t count = 0;
  for (const EigenvaluesDocument::Enclosure& row : document.eigenvalues) {
    result.most.push_back({row.in.lower, count});
    count += row.count;
    result.least.push_back({row.in.upper, count});
  }
  result.most.push_back({document.next, count});
  for (const EigenvaluesDocument::AtMost& row : document.at_most) result.most.push_back({row.below, row.count});
  for (const EigenvaluesDocument::AtLeast& row : document.at_least) result.least.push_back({row.below, row.count});
  return result;
}

/// Leaves out the steps that say nothing new.
void keep_stairs(Bounds& bounds) {
  const auto by_place = [](const Step& x, const Step& y) {
    return x.lambda != y.lambda ? x.lambda < y.lambda : x.count < y.count;
  };
  std::vector<Step> least;
  std::sort(bounds.least.begin(), bounds.least.end(), by_place);
  for (const Step& step : bounds.least)
    if (least.empty() ? step.count > 0 : step.count > least.back().count) least.push_back(step);
  std::vector<Step> most;
  std::sort(bounds.most.begin(), bounds.most.end(), by_place);
  for (auto step = bounds.most.rbegin(); step != bounds.most.rend(); ++step)
    if (most.empty() || step->count < most.back().count) most.push_back(*step);
  std::reverse(most.begin(), most.end());
  bounds = {std::move(least), std::move(most)};
}

class EigenvaluesDrawing {
 public:
  EigenvaluesDrawing(const EigenvaluesPicture& picture, std::uint32_t size)
      : picture_(picture), size_(size), unit_(size / 1000.0), end_(picture.end) {
    double highest = std::max(1.0, picture.weyl * end_);
    for (const std::vector<Step>* steps : {&picture.least, &picture.most})
      for (const auto& [lambda, count] : *steps)
        if (lambda <= end_) highest = std::max(highest, static_cast<double>(count));
    top_ = 1.12 * highest;
  }

  [[nodiscard]] std::string svg() const {
    return head() + bands() + grid() + weyl() + stairs() + places() + labels() + legend() + "</svg>\n";
  }

 private:
  static constexpr double kFont = 15;
  static constexpr double kLeft = 62;
  static constexpr double kRight = 978;
  static constexpr double kTop = 152;
  static constexpr double kBottom = 560;
  static constexpr double kHeight = 620;

  [[nodiscard]] std::string length(double units) const { return fixed(units * unit_, 2); }
  [[nodiscard]] double x(double lambda) const { return kLeft + (kRight - kLeft) * std::min(lambda / end_, 1.0); }
  [[nodiscard]] double y(double count) const { return kBottom - (kBottom - kTop) * count / top_; }

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
           "</title>\n<desc>Eigenvalues of the Laplacian: intervals that contain them, and how many are at least and "
           "at "
           "most below each place.</desc>\n<rect class=\"background\" width=\"" +
           width + "\" height=\"" + height + "\" fill=\"" + palette::kPaper + "\"/>\n";
  }

  [[nodiscard]] std::string bands() const {
    std::string out =
        std::string("<g class=\"enclosures\" fill=\"") + palette::kCoveringDisks + "\" fill-opacity=\"0.3\">\n";
    for (const auto& [in, count] : picture_.eigenvalues) out += area(x(in.lower), x(in.upper), kTop, kBottom, 2);
    out += std::string("</g>\n<g class=\"beyond\" fill=\"") + kNotCounted + "\" fill-opacity=\"0.25\">\n";
    return out + area(x(picture_.next), kRight, kTop, kBottom, 0) + "</g>\n";
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
    std::string beside = text_group("counts", "end");
    std::string across;
    const double count_step = std::max(1.0, tick_step(top_));
    for (double tick = 0; tick <= top_; tick += count_step) {
      across += line(kLeft, y(tick), kRight, y(tick));
      beside += text(kLeft - 8, y(tick) + 0.35 * kFont, certify::shortest(tick));
    }
    std::string out = stroke("grid", across, "#d5dbe2", 1) + below + beside + "</g>\n";
    if (end_ > 0.25) out += stroke("quarter", line(x(0.25), kTop, x(0.25), kBottom), palette::kEdges, 1.2, kDashes);
    return out + stroke("axes", lines + line(kLeft, kTop, kLeft, kBottom) + line(kLeft, kBottom, kRight, kBottom),
                        palette::kEdges, 1.2);
  }

  [[nodiscard]] std::string weyl() const {
    return stroke("weyl", line(x(0), y(0), x(end_), y(picture_.weyl * end_)), kWeyl, 1.6,
                  "stroke-linecap=\"round\" stroke-dasharray=\"0.1 5\" ");
  }

  /// The line of what is counted at most is wide, so that it can be seen behind that of what is counted at least.
  [[nodiscard]] std::string stairs() const {
    std::string most;
    double from = 0;
    for (const auto& [lambda, count] : picture_.most) {
      const double to = std::min(lambda, end_);
      most += (most.empty() ? 'M' : 'L') + length(x(from)) + ' ' + length(y(count)) + 'H' + length(x(to));
      from = to;
      if (lambda >= end_) break;
    }
    std::string least = 'M' + length(x(0)) + ' ' + length(y(0));
    for (const auto& [lambda, count] : picture_.least)
      if (lambda <= end_) least += 'H' + length(x(lambda)) + 'V' + length(y(count));
    return stroke("most", most, palette::kCombinatorialDirichlet, 5) +
           stroke("least", least + 'H' + length(kRight), palette::kPaths, 2);
  }

  [[nodiscard]] std::string places() const {
    std::string out = std::string("<g class=\"places\" fill=\"") + palette::kDirichlet + "\">\n";
    for (const auto& [in, count] : picture_.eigenvalues)
      out += area(x(in.lower), x(in.upper), kBottom - 9, kBottom + 9, 3);
    return out + "</g>\n";
  }

  /// The number above each band with several eigenvalues; one that would be at the last one's place is higher.
  [[nodiscard]] std::string labels() const {
    std::string out = text_group("numbers", "middle");
    double last = -1000;
    double row = 0;
    for (const auto& [in, count] : picture_.eigenvalues) {
      if (count == 1) continue;
      const std::string number = std::to_string(count);
      const double width = 0.6 * kFont * static_cast<double>(number.size());
      const double middle = (x(in.lower) + x(in.upper)) / 2;
      row = middle - width / 2 < last ? std::fmod(row + 1, 3) : 0;
      last = middle + width / 2 + 4;
      out += text(middle, kTop - 8 - 17 * row, number);
    }
    return out + "</g>\n";
  }

  [[nodiscard]] std::string legend() const {
    Legend legend(1.25 * unit_);
    legend.add(Mark::area, palette::kDirichlet,
               "intervals that contain the eigenvalues, and above each their number, if it is not 1");
    legend.add(Mark::line, palette::kPaths, "at least so many eigenvalues are less than \u03bb");
    legend.add(Mark::line, palette::kCombinatorialDirichlet, "at most so many eigenvalues are less than \u03bb");
    const std::string weyl = picture_.weyl == 1 ? "" : certify::shortest(picture_.weyl);
    legend.add(Mark::line, kWeyl, "dotted: Weyl's law, about (g \u2212 1)\u03bb = " + weyl + "\u03bb");
    legend.add(Mark::area, kNotCounted, "not counted; the dashed line is at 1/4");
    return legend.group();
  }

  static constexpr const char* kDashes = "stroke-dasharray=\"4 4\" ";

  const EigenvaluesPicture& picture_;
  std::uint32_t size_;
  double unit_;
  double end_;
  double top_;
};

}  // namespace

EigenvalueCount eigenvalues_below(const EigenvaluesDocument& document, double x) {
  EigenvalueCount result;
  const auto at_least = [&](bool applies, std::uint32_t count) {
    if (applies) result.least = std::max(result.least, count);
  };
  const auto at_most = [&](bool applies, std::uint32_t count) {
    if (applies) result.most = std::min(result.most.value_or(count), count);
  };
  std::uint32_t count = 0;
  for (const EigenvaluesDocument::Enclosure& row : document.eigenvalues) {
    at_most(row.in.lower >= x, count);
    count += row.count;
    at_least(row.in.upper < x, count);
  }
  at_most(document.next >= x, count);
  for (const EigenvaluesDocument::AtMost& row : document.at_most) at_most(row.below >= x, row.count);
  for (const EigenvaluesDocument::AtLeast& row : document.at_least) at_least(row.below <= x, row.count);
  return result;
}

EigenvaluesPicture picture_of(const EigenvaluesDocument& document) {
  Bounds bounds = bounds_of(document);
  keep_stairs(bounds);
  EigenvaluesPicture result;
  result.eigenvalues = document.eigenvalues;
  result.next = document.next;
  result.least = std::move(bounds.least);
  result.most = std::move(bounds.most);
  double last = 1.12 * document.next;
  std::uint64_t count = 0;
  for (const EigenvaluesDocument::Enclosure& row : document.eigenvalues) {
    last = std::max(last, 1.06 * row.in.upper);
    count += row.count;
  }
  // A file may have any numbers; more cannot be drawn.
  constexpr double kGreatest = 1e9;
  if (last > 0) result.end = std::clamp(last, 1 / kGreatest, kGreatest);
  // V − E + F = 2 − 2g, and E = 3F/2.
  const auto vertices = static_cast<double>(document.net.vertices.size());
  result.weyl = (static_cast<double>(document.net.triangles.size()) / 2 - vertices) / 2;
  result.title = count == 0 ? "Eigenvalues of the Laplacian: none less than " + certify::shortest(document.next)
                            : "The first " + std::to_string(count) + " eigenvalues of the Laplacian";
  return result;
}

std::string draw_svg(const EigenvaluesPicture& picture, std::uint32_t size) {
  return EigenvaluesDrawing(picture, size).svg();
}

}  // namespace epsnet
