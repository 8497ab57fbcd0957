#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/document.h"
#include "certify/net/numbering.h"
#include "netgen/eigenvalues/eigenfunctions.h"
#include "netgen/lifts/lifts.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg.h"

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;
using Step = EigenvaluesPicture::Step;

constexpr const char* kNotCounted = "#8a94a0";
constexpr const char* kWeyl = "#5d6b7a";

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
  if (document.box) return result;  // Other rows are of its centre.
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

class EigenvaluesDrawing : Diagram {
 public:
  EigenvaluesDrawing(const EigenvaluesPicture& picture, std::uint32_t size)
      : Diagram(size, 620), picture_(picture), end_(picture.end) {
    double highest = std::max(1.0, picture.weyl * end_);
    for (const std::vector<Step>* steps : {&picture.least, &picture.most})
      for (const auto& [lambda, count] : *steps)
        if (lambda <= end_) highest = std::max(highest, static_cast<double>(count));
    top_ = 1.12 * highest;
  }

  [[nodiscard]] std::string svg() const {
    return head(
               picture_.title,
               "Eigenvalues of the Laplacian: intervals that contain them, and how many are at least and at most below "
               "each place.") +
           bands() + grid() + weyl() + stairs() + places() + labels() + legend() + "</svg>\n";
  }

 private:
  static constexpr double kLeft = 62;
  static constexpr double kRight = 978;
  static constexpr double kTop = 152;
  static constexpr double kBottom = 560;

  [[nodiscard]] double x(double lambda) const { return kLeft + (kRight - kLeft) * std::min(lambda / end_, 1.0); }
  [[nodiscard]] double y(double count) const { return kBottom - (kBottom - kTop) * count / top_; }

  /// An area of at least a width that can be seen.
  [[nodiscard]] std::string area(double from, double to, double upper, double lower, double least) const {
    const double missing = std::max(0.0, least - (to - from));
    return "<rect x=\"" + length(from - missing / 2) + "\" y=\"" + length(upper) + "\" width=\"" +
           length(to - from + missing) + "\" height=\"" + length(lower - upper) + "\"/>\n";
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
    Legend legend(1.25 * unit());
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
  if (document.box) return result;  // Other rows are of its centre.
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
  const std::string what = std::string("of the Laplacian") + (document.phases.empty() ? "" : " with phases");
  result.title = count == 0 ? "Eigenvalues " + what + ": none less than " + certify::shortest(document.next)
                            : "The first " + std::to_string(count) + " eigenvalues " + what;
  return result;
}

std::string draw_svg(const EigenvaluesPicture& picture, std::uint32_t size) {
  return EigenvaluesDrawing(picture, size).svg();
}

namespace {

using certify::EigenvaluesDocument;

/// There are so many bands of each sign.
constexpr int kBandsOfSign = 12;

/// The colour of a band: band k ≥ 0 is that of values from k to k + 1 of `kBandsOfSign`; k < 0 is that of −1 − k with
/// the other sign.
std::string band_colour(int band) {
  using Colour = std::array<double, 3>;
  constexpr std::array<Colour, 4> kPositive{{{247, 242, 236}, {246, 178, 140}, {214, 84, 71}, {122, 8, 38}}};
  constexpr std::array<Colour, 4> kNegative{{{238, 243, 247}, {152, 198, 224}, {62, 134, 192}, {10, 52, 112}}};
  const auto& stops = band < 0 ? kNegative : kPositive;
  const double s = 3 * ((band < 0 ? -1 - band : band) + 0.5) / kBandsOfSign;
  const auto stop = static_cast<std::size_t>(s);
  std::string out = "#";
  for (std::size_t i = 0; i < 3; ++i) {
    const double from = stops[stop][i];
    const auto value = static_cast<unsigned>(std::lround(from + (s - std::floor(s)) * (stops[stop + 1][i] - from)));
    out += "0123456789abcdef"[value / 16];
    out += "0123456789abcdef"[value % 16];
  }
  return out;
}

using Place = Complex<double>;

/// A point of a triangle with the value there.
struct Sample {
  Place z;              ///< In the picture.
  double value;         ///< In bands.
  std::uint32_t sides;  ///< Bit i: it is on side i of the triangle.
  PaperPoint on_paper;
};

/// A point on the geodesic disk with the weights in the hyperboloid.
Place weighted(const std::array<Place, 3>& corners, const std::array<double, 3>& weights) {
  double x = 0;
  double y = 0;
  double t = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double scale = weights[i] / (1 - norm(corners[i]));
    x += scale * 2 * corners[i].x;
    y += scale * 2 * corners[i].y;
    t += scale * (1 + norm(corners[i]));
  }
  const double length = std::sqrt(std::max(t * t - x * x - y * y, 0.0));
  return {x / (t + length), y / (t + length)};
}

/// A triangle of the net with samples in n + 1 rows, row i of i + 1 of them: corner 0, then on to the side from corner
/// 1 to corner 2.
struct SampledTriangle {
  std::uint32_t n;
  std::vector<Sample> samples;

  [[nodiscard]] const Sample& at(std::uint32_t row, std::uint32_t k) const { return samples[row * (row + 1) / 2 + k]; }
};

/// The boundary of one band in one triangle: the edges of its parts, less those between two parts.
class Outline {
 public:
  void add(const Sample& from, const Sample& to) {
    if (from.on_paper == to.on_paper) return;
    const auto back = edges_.find({to.on_paper, from.on_paper});
    if (back != edges_.end()) {
      edges_.erase(back);
    } else {
      edges_.emplace(std::pair(from.on_paper, to.on_paper), Edge{from.z, to.z, from.sides & to.sides});
    }
  }

  /// Adds the loops to a path.
  void append_to(Path& path) {
    while (!edges_.empty()) {
      std::vector<Edge> loop;
      const PaperPoint start = edges_.begin()->first.first;
      PaperPoint at = start;
      for (auto next = edges_.begin(); next != edges_.end() && next->first.first == at;) {
        // Edges one after the other on a side of the triangle are one.
        if (!loop.empty() && (loop.back().sides & next->second.sides) != 0) {
          loop.back().to = next->second.to;
        } else {
          loop.push_back(next->second);
        }
        at = next->first.second;
        edges_.erase(next);
        if (at == start) break;
        next = edges_.lower_bound({at, {INT64_MIN, INT64_MIN}});
      }
      assert(at == start);  // As many edges begin at each point as end there.
      path.move(loop.front().from);
      for (const Edge& edge : loop) {
        if (edge.sides != 0) {
          path.geodesic(edge.from, edge.to);
        } else {
          path.line(edge.to);
        }
      }
      path.close();
    }
  }

 private:
  struct Edge {
    Place from;
    Place to;
    std::uint32_t sides;
  };
  std::multimap<std::pair<PaperPoint, PaperPoint>, Edge> edges_;  ///< The same one twice, where parts are too small.
};

class EigenfunctionDrawing {
 public:
  EigenfunctionDrawing(const EigenvaluesDocument& document, std::size_t index,
                       const EigenfunctionPictureOptions& options)
      : document_(document),
        index_(index),
        place_(eigenfunction_place(document, index)),
        options_(options),
        function_(document, place_.row, place_.function),
        geometry_(document.net),
        lifts_(lift_triangles(geometry_, options.order, options.centre)),
        paper_(options.size) {
    for (std::uint32_t k = 0; k < lifts_.lifted.size(); ++k) triangles_.push_back(sampled(lifts_.lifted[k]));
    double greatest = 0;
    for (const SampledTriangle& triangle : triangles_)
      for (const Sample& sample : triangle.samples) greatest = std::max(greatest, std::abs(sample.value));
    const double scale = greatest > 0 && std::isfinite(greatest) ? kBandsOfSign / greatest : 0;
    for (SampledTriangle& triangle : triangles_)
      for (Sample& sample : triangle.samples) sample.value *= scale;
  }

  [[nodiscard]] std::string svg() const { return head() + bands() + outline() + nodal_lines() + legend() + "</svg>\n"; }

 private:
  /// The side of a small triangle, in pixels, is about that.
  static constexpr double kStep = 10;
  static constexpr double kMostParts = 48;

  [[nodiscard]] SampledTriangle sampled(const Lifts::LiftedTriangle& lifted) const {
    const auto& [a, b, c] = lifted.corner;
    const double longest = paper_.radius() * std::sqrt(std::max({norm(a - b), norm(b - c), norm(c - a)}));
    SampledTriangle result{static_cast<std::uint32_t>(std::clamp(std::ceil(longest / kStep), 1.0, kMostParts)), {}};
    // Points are those of the chart of corner 0, which is near them; the picture's disk has less digits far outside.
    const std::array<Place, 3> corners = geometry_.corners(lifted.triangle);
    const Isometry<double>& to_picture = lifts_.placements[lifted.placement[0]].rounded;
    const double n = result.n;
    for (std::uint32_t i = 0; i <= result.n; ++i) {
      for (std::uint32_t k = 0; k <= i; ++k) {
        const Place w = weighted(corners, {(n - i) / n, (i - k) / n, k / n});
        const Place z = to_picture(w);
        const std::uint32_t sides = (k == 0 ? 1U : 0U) | (i == result.n ? 2U : 0U) | (k == i ? 4U : 0U);
        result.samples.push_back({z, value(lifted.triangle, w), sides, paper_.place(z)});
      }
    }
    return result;
  }

  /// The value at a point of the chart of corner 0 of a triangle: that of the function around the nearest corner.
  [[nodiscard]] double value(std::uint32_t triangle, const Place& w) const {
    Place nearest{1, 0};
    std::uint32_t vertex = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t v = document_.net.triangles[triangle].vertex[i];
      const Isometry<double>& label = geometry_.label(certify::corner_label(document_.net, 3 * triangle + i)).rounded;
      const certify::NetDocument::Vertex& centre = document_.net.vertices[v];
      const Place z = Isometry<double>::translation({-centre.x, -centre.y})(inverse(label)(w));
      if (norm(z) >= norm(nearest)) continue;
      nearest = z;
      vertex = v;
    }
    return function_.at(vertex, {nearest.x, nearest.y});
  }

  /// Calls `function` for each small triangle with the points on its boundary, counterclockwise: its corners, and where
  /// a value is a whole number of bands, as if it were linear.
  template <class Function>
  void for_each_part(const SampledTriangle& triangle, const Function& function) const {
    const auto part = [&](const Sample& a, const Sample& b, const Sample& c) {
      std::vector<Sample> boundary;
      add_side(boundary, a, b);
      add_side(boundary, b, c);
      add_side(boundary, c, a);
      function(boundary);
    };
    for (std::uint32_t i = 0; i < triangle.n; ++i) {
      for (std::uint32_t k = 0; k <= i; ++k) {
        part(triangle.at(i, k), triangle.at(i + 1, k), triangle.at(i + 1, k + 1));
        if (k < i) part(triangle.at(i, k), triangle.at(i + 1, k + 1), triangle.at(i, k + 1));
      }
    }
  }

  /// Adds a and what is between a and b. The points are the same for b and a.
  void add_side(std::vector<Sample>& boundary, const Sample& a, const Sample& b) const {
    boundary.push_back(a);
    const bool up = a.value < b.value;
    const Sample& low = up ? a : b;
    const Sample& high = up ? b : a;
    const double first = std::floor(low.value) + 1;
    const auto count = static_cast<int>(std::ceil(high.value) - first);
    for (int j = 0; j < count; ++j) {
      const double level = first + (up ? j : count - 1 - j);
      const double share = (level - low.value) / (high.value - low.value);
      const Place z = low.z + share * (high.z - low.z);
      boundary.push_back({z, level, a.sides & b.sides, paper_.place(z)});
    }
  }

  /// All parts of a colour are one path, with a hairline around it that covers the seams left by anti-aliasing.
  [[nodiscard]] std::string bands() const {
    std::map<int, Path> paths;
    for (const SampledTriangle& triangle : triangles_) {
      std::map<int, Outline> outlines;
      for_each_part(triangle, [&](const std::vector<Sample>& boundary) { add_bands(outlines, boundary); });
      for (auto& [band, outline] : outlines) outline.append_to(paths.try_emplace(band, paper_).first->second);
    }
    std::string out = "<g class=\"values\" stroke-width=\"0.4\" stroke-linejoin=\"round\">\n";
    for (const auto& [band, path] : paths) {
      const std::string colour = band_colour(band);
      out += "<path fill=\"" + colour + "\" stroke=\"" + colour + "\" d=\"" + path.data() + "\"/>\n";
    }
    return out + "</g>\n";
  }

  static void add_bands(std::map<int, Outline>& outlines, const std::vector<Sample>& boundary) {
    double least = kBandsOfSign;
    double greatest = -kBandsOfSign;
    for (const Sample& sample : boundary) {
      least = std::min(least, sample.value);
      greatest = std::max(greatest, sample.value);
    }
    const int last = std::min(static_cast<int>(std::ceil(greatest)) - 1, kBandsOfSign - 1);
    const int first = std::clamp(static_cast<int>(std::floor(least)), -kBandsOfSign, std::max(last, -kBandsOfSign));
    for (int band = first; band <= std::max(first, last); ++band) {
      std::vector<Sample> polygon;
      for (const Sample& sample : boundary)
        if (band <= sample.value && sample.value <= band + 1) polygon.push_back(sample);
      for (std::size_t i = 0; polygon.size() > 2 && i < polygon.size(); ++i)
        outlines[band].add(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }

  [[nodiscard]] std::string nodal_lines() const {
    PathsByWidth paths(paper_, 2.2 * options_.size / 1000.0);
    PaperPoint pen{};
    for (const SampledTriangle& triangle : triangles_) {
      for_each_part(triangle, [&](const std::vector<Sample>& boundary) {
        std::vector<Sample> zeros;
        for (const Sample& sample : boundary)
          if (sample.value == 0) zeros.push_back(sample);
        if (zeros.size() != 2) return;
        // On without lifting the pen, if possible: that makes a short file.
        if (zeros[1].on_paper == pen) std::swap(zeros[0], zeros[1]);
        if (paths.add_tapered(zeros[0].z, zeros[1].z)) pen = zeros[1].on_paper;
      });
    }
    std::string out = std::string("<g class=\"nodal-lines\" fill=\"none\" stroke=\"") + palette::kVertices +
                      "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    paths.append_to(out);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string outline() const {
    PathsByWidth paths(paper_, options_.size / 1000.0);
    const std::vector<bool> on_boundary = boundary_darts(geometry_, lifts_);
    for (std::uint32_t dart = 0; dart < on_boundary.size(); ++dart) {
      if (!on_boundary[dart]) continue;
      const auto& corner = lifts_.lifted[lifts_.place[dart / 3]].corner;
      paths.add_tapered(corner[dart % 3], corner[certify::next_dart(dart) % 3]);
    }
    std::string out = std::string("<g class=\"outline\" fill=\"none\" stroke=\"") + palette::kEdges +
                      "\" stroke-linecap=\"round\">\n";
    paths.append_to(out);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string name() const {
    return "\u03bb_" + std::to_string(index_) + " in " + to_string(document_.eigenfunctions[place_.row].in);
  }

  [[nodiscard]] std::string legend() const {
    Legend legend(std::max(options_.size, 700U) / 1000.0);
    legend.add_text_row(name());
    if (place_.count > 1) {
      legend.add_text_row("one of " + std::to_string(place_.count) + " for \u03bb_" + std::to_string(place_.first) +
                          " to \u03bb_" + std::to_string(place_.first + place_.count - 1));
    }
    legend.add_areas(
        {{band_colour(-kBandsOfSign), "\u2212"}, {band_colour(-1), "0"}, {band_colour(kBandsOfSign - 1), "+"}}, 30);
    legend.add(Mark::line, palette::kVertices, "nodal lines");
    return legend.group();
  }

  [[nodiscard]] std::string head() const {
    const std::string size = std::to_string(options_.size);
    const std::string middle = fixed(paper_.middle(), 1);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" + size + "\" viewBox=\"0 0 " +
           size + " " + size + "\">\n<title>Eigenfunction of the Laplacian, " + name() +
           "</title>\n<desc>On one lift of every triangle of a net in the Poincare disk, with vertex " +
           std::to_string(options_.centre) +
           " in the centre; values from their least to their greatest, from blue to red, and black lines where it is "
           "0.</desc>\n<rect class=\"background\" width=\"" +
           size + "\" height=\"" + size + "\" fill=\"" + palette::kPaper + "\"/>\n<circle class=\"disk\" cx=\"" +
           middle + "\" cy=\"" + middle + "\" r=\"" + fixed(paper_.radius(), 2) +
           "\" fill=\"#fff\" stroke=\"#8a94a0\" stroke-width=\"" + fixed(0.8 * options_.size / 1000, 2) + "\"/>\n";
  }

  const EigenvaluesDocument& document_;
  std::size_t index_;
  EigenfunctionPlace place_;
  EigenfunctionPictureOptions options_;
  EigenfunctionValues function_;
  NetGeometry geometry_;
  Lifts lifts_;
  Paper paper_;
  std::vector<SampledTriangle> triangles_;  ///< In the order of the lifts.
};

/// The rows of functions in an interval.
std::vector<std::size_t> rows_in(const EigenvaluesDocument& document, certify::Interval in) {
  std::vector<std::size_t> result;
  for (std::size_t r = 0; r < document.eigenfunctions.size(); ++r) {
    const certify::Interval inner = document.eigenfunctions[r].in;
    if (in.lower <= inner.lower && inner.upper <= in.upper) result.push_back(r);
  }
  return result;
}

std::string range_text(std::uint64_t first, std::uint64_t last) {
  const std::string from = "lambda_" + std::to_string(first);
  return first == last ? from : from + " to lambda_" + std::to_string(last);
}

/// Of which eigenvalues a document has functions.
std::string functions_text(const EigenvaluesDocument& document) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
  std::uint64_t first = 1;
  std::uint64_t count = 0;
  for (const EigenvaluesDocument::Enclosure& row : document.eigenvalues) {
    std::uint64_t functions = 0;
    for (const std::size_t r : rows_in(document, row.in)) functions += document.eigenfunctions[r].functions.size();
    functions = std::min<std::uint64_t>(functions, row.count);
    if (functions > 0) {
      if (ranges.empty() || ranges.back().second + 1 < first) ranges.emplace_back(first, first);
      ranges.back().second = first + functions - 1;
    }
    count += functions;
    first += row.count;
  }
  if (!document.phases.empty()) return "files with phases have no eigenfunctions";
  if (count == 0) return "the file has no eigenfunctions, which take 3 digits or more";
  std::string text = "the file has " + std::to_string(count) + (count == 1 ? ", that of " : ", those of ");
  for (std::size_t i = 0; i < ranges.size(); ++i)
    text += (i == 0 ? "" : ", ") + range_text(ranges[i].first, ranges[i].second);
  return text;
}

}  // namespace

EigenfunctionPlace eigenfunction_place(const EigenvaluesDocument& document, std::size_t index) {
  std::uint64_t first = 1;
  for (const EigenvaluesDocument::Enclosure& row : document.eigenvalues) {
    if (index >= first && index - first < row.count) {
      std::size_t function = index - first;
      for (const std::size_t r : rows_in(document, row.in)) {
        const std::size_t functions = document.eigenfunctions[r].functions.size();
        if (function < functions) return {r, function, static_cast<std::uint32_t>(first), row.count};
        function -= functions;
      }
    }
    first += row.count;
  }
  throw std::out_of_range("no eigenfunction of lambda_" + std::to_string(index) + ": " + functions_text(document));
}

std::vector<double> eigenfunction_at_vertices(const EigenvaluesDocument& document, std::size_t index) {
  const EigenfunctionPlace place = eigenfunction_place(document, index);
  const std::vector<double>& coefficients = document.eigenfunctions[place.row].functions[place.function];
  const std::size_t each = coefficients.size() / document.net.vertices.size();
  std::vector<double> result;
  result.reserve(document.net.vertices.size());
  for (std::size_t v = 0; v < document.net.vertices.size(); ++v) result.push_back(coefficients[v * each]);
  return result;
}

std::string eigenfunction_svg(const EigenvaluesDocument& document, std::size_t index,
                              const EigenfunctionPictureOptions& options) {
  return EigenfunctionDrawing(document, index, options).svg();
}

namespace {

class BandsDrawing : Diagram {
 public:
  BandsDrawing(const BandsPicture& picture, std::uint32_t size) : Diagram(size, 620), picture_(picture) {
    double greatest = 0;
    for (const auto& step : picture.bands) {
      for (const certify::Interval& in : step) greatest = std::max(greatest, in.upper);
    }
    if (greatest > 0 && std::isfinite(greatest)) top_ = 1.06 * greatest;
  }

  [[nodiscard]] std::string svg() const {
    return head("Bands", "Eigenvalues of the Laplacian with phases along a path: intervals that contain them.") +
           grid() + lines() + intervals() + marks() + "</svg>\n";
  }

 private:
  static constexpr double kLeft = 62;
  static constexpr double kRight = 978;
  static constexpr double kTop = 24;
  static constexpr double kBottom = 572;
  static constexpr std::array<const char*, 4> kColours{palette::kPaths, palette::kDirichlet, palette::kCoveringDisks,
                                                       palette::kCombinatorialDirichlet};

  [[nodiscard]] double x(std::size_t step) const {
    const std::size_t last = std::max<std::size_t>(picture_.bands.size(), 2) - 1;
    return kLeft + (kRight - kLeft) * static_cast<double>(step) / static_cast<double>(last);
  }
  [[nodiscard]] double y(double lambda) const { return kBottom - (kBottom - kTop) * std::min(lambda / top_, 1.0); }

  [[nodiscard]] std::string grid() const {
    const double step = tick_step(top_);
    std::string across;
    std::string beside = text_group("eigenvalues", "end");
    for (double tick = 0; tick <= top_; tick += step) {
      across += line(kLeft, y(tick), kRight, y(tick));
      beside += text(kLeft - 8, y(tick) + 0.35 * kFont, certify::shortest(std::stod(fixed(tick, 6))));
    }
    return stroke("grid", across, "#d5dbe2", 1) + beside + text(kLeft - 8, kTop - 6, "\u03bb") + "</g>\n";
  }

  [[nodiscard]] static const char* colour(std::size_t band) { return kColours[band % kColours.size()]; }
  [[nodiscard]] std::size_t count() const {
    std::size_t result = picture_.bands.empty() ? 0 : picture_.bands.front().size();
    for (const auto& step : picture_.bands) result = std::min(result, step.size());
    return result;
  }

  [[nodiscard]] std::string lines() const {
    std::string out;
    for (std::size_t band = 0; band < count(); ++band) {
      std::string data;
      for (std::size_t step = 0; step < picture_.bands.size(); ++step) {
        const auto [lower, upper] = picture_.bands[step][band];
        data += (data.empty() ? 'M' : 'L') + length(x(step)) + ' ' + length(y(lower / 2 + upper / 2));
      }
      out += stroke("band", data, colour(band), 1);
    }
    return out;
  }

  [[nodiscard]] std::string intervals() const {
    std::string out;
    for (std::size_t band = 0; band < count(); ++band) {
      std::string data;
      for (std::size_t step = 0; step < picture_.bands.size(); ++step) {
        const auto [lower, upper] = picture_.bands[step][band];
        const double missing = std::max(0.0, 1.5 - (y(lower) - y(upper))) / 2;
        data += line(x(step), y(lower) + missing, x(step), y(upper) - missing);
      }
      out += stroke("intervals", data, colour(band), 4);
    }
    return out;
  }

  [[nodiscard]] std::string marks() const {
    std::string lines;
    std::string names = text_group("marks", "middle");
    for (const BandsPicture::Mark& mark : picture_.marks) {
      if (mark.step >= picture_.bands.size()) continue;
      lines += line(x(mark.step), kTop, x(mark.step), kBottom);
      // The last name ends there: it may be long.
      const bool last = mark.step > 0 && mark.step + 1 == picture_.bands.size();
      names += text(x(mark.step), kBottom + 24, mark.name, last ? " text-anchor=\"end\"" : "");
    }
    return stroke("axes", lines + line(kLeft, kBottom, kRight, kBottom) + line(kLeft, kTop, kLeft, kBottom),
                  palette::kEdges, 1) +
           names + "</g>\n";
  }

  const BandsPicture& picture_;
  double top_ = 1;
};

}  // namespace

std::string draw_svg(const BandsPicture& picture, std::uint32_t size) { return BandsDrawing(picture, size).svg(); }

}  // namespace epsnet
