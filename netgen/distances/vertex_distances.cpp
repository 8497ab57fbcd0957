#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <mpfr.h>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "certify/check.h"
#include "certify/net/numbering.h"
#include "certify/numbers/parallel.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {
namespace {

using certify::Interval;
using certify::NetDocument;

constexpr std::uint32_t kNone = 0xffffffff;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUlp = kUnitRoundoff;
/// A factor that turns the rounded result of a few operations into an upper bound.
constexpr double kUp = 1 + 0x1p-40;

/// The bits of T do not suffice, or cannot distinguish too many lifts of triangles.
struct TooFewBits {};

/// An isometry of determinant 1, and a bound of its error: |δa| + |δb| ≤ error.
template <class T>
struct Bounded {
  Isometry<T> isometry;
  double norm = 1;  ///< At least |a| + |b|, which is submultiplicative.
  double error = 0;
};

/// Returns an upper bound of |a| + |b|.
template <class T>
double norm_of(const Isometry<T>& f) {
  const Isometry<double> g = convert<double>(f);
  return (std::sqrt(norm(g.a)) + std::sqrt(norm(g.b))) * kUp;
}

template <class T>
double unit_roundoff() {
  return std::ldexp(1.0, -kMantissaBits<T>);
}

/// Returns an isometry divided by the root of its determinant. Its numbers have errors of a few units; the division
/// loses twice the logarithm of its norm.
template <class T>
Bounded<T> made(const Isometry<T>& f) {
  const double norm = norm_of(f);
  return {f, norm, 64 * unit_roundoff<T>() * norm * norm * norm};
}

template <class T>
Bounded<T> product(const Bounded<T>& f, const Bounded<T>& g) {
  // Each number of the product is a sum of four products.
  const double error =
      (f.error * g.norm + (f.norm + f.error) * g.error + 16 * unit_roundoff<T>() * f.norm * g.norm) * kUp;
  const Isometry<T> isometry = f.isometry * g.isometry;
  return {isometry, norm_of(isometry), error};
}

template <class T>
Bounded<T> inverse_of(const Bounded<T>& f) {
  return {inverse(f.isometry), f.norm, f.error};
}

/// The labels of a net at one precision.
template <class T>
class Labels {
 public:
  Labels(const NetDocument& net, const Surface& surface) {
    std::vector<Bounded<T>> crossings;
    for (const SideId s : surface.side_ids()) crossings.push_back(made(surface.crossing_as<T>(s)));
    std::vector<Bounded<T>> frames;
    for (const NetDocument::Chart& chart : net.charts) {
      frames.push_back(made(normalized(Isometry<T>::translation(rounded<T>(chart.centre)))));
    }
    labels_.resize(1);
    for (const NetDocument::Label& label : net.labels) {
      Bounded<T> path = frames[label.from];
      for (const std::uint32_t side : label.word) path = product(crossings[side], path);
      labels_.push_back(product(inverse_of(frames[label.to]), path));
    }
  }

  [[nodiscard]] const Bounded<T>& operator[](std::uint32_t number) const { return labels_[number]; }

 private:
  std::vector<Bounded<T>> labels_;
};

/// A net, with the data that all searches use.
struct SearchedNet {
  explicit SearchedNet(const NetDocument& net_document) : net(net_document) {
    if (const auto problem = certify::malformation(net)) throw NetGeometryError(*problem);
    if (const auto dart = unpaired_dart(net)) {
      throw NetGeometryError("triangles[" + std::to_string(*dart / 3) + "]: dart " + std::to_string(*dart) +
                             " and its opposite do not belong together");
    }
    dart_from.assign(net.vertices.size(), kNone);
    for (std::uint32_t d = 0; d < 3 * net.triangles.size(); ++d) dart_from[certify::start(net, d)] = d;
    for (const NetDocument::Vertex& v : net.vertices) {
      const Mp256 height = 1 - Mp256(v.x) * v.x - Mp256(v.y) * v.y;
      scale.push_back(1 / std::sqrt(static_cast<double>(height)));
    }
  }

  [[nodiscard]] const NetDocument::Vertex& vertex(std::uint32_t v) const { return net.vertices[v]; }

  const NetDocument& net;
  std::vector<std::uint32_t> dart_from;  ///< By vertex: a dart that leaves it.
  std::vector<double> scale;             ///< By vertex at z: 1/√(1 − |z|²).
};

/// The lifts of charts that searches have met, in the disk of one chart, each stored once.
template <class T>
class Places {
 public:
  /// A lift of a chart, in binary64: `isometry` takes its points z to the disk.
  struct Place {
    Isometry<double> isometry;
    /// A bound of the error with which binary64 computes w(z) = az + b − c(b̄z + ā), for any |c|, |z| < 1.
    double error;
  };
  /// The lift of the chart itself.
  static constexpr std::uint32_t kOwn = 0;

  Places(const NetDocument& net, const Labels<T>& labels, std::uint32_t chart, double shortest_curve)
      : net_(net), labels_(labels), shortest_curve_(shortest_curve), newest_(net.charts.size(), kNone) {
    (void)found({}, chart);
  }

  [[nodiscard]] const Place& operator[](std::uint32_t place) const { return places_[place]; }

  /// Whether the lift of a point z in one place of its chart is certainly nearer to the point c of the central chart
  /// than its lift in another place.
  [[nodiscard]] bool is_nearer(std::uint32_t place, std::uint32_t other, const Complex<double>& z,
                               const Complex<double>& c) const {
    const auto size = [&](const Bounded<T>& f, double& error) {
      const Complex<T> from = convert<T>(c);
      const Complex<T> to = convert<T>(z);
      const Complex<T> w = (f.isometry.a * to + f.isometry.b) - from * (conj(f.isometry.b) * to + conj(f.isometry.a));
      T result = norm(w);
      // As for Place, and two units for the square.
      const double lost = 32 * unit_roundoff<T>() * f.norm + 2 * f.error;
      error += (2 * std::sqrt(static_cast<double>(result)) + lost) * lost + 4 * unit_roundoff<T>() * f.norm * f.norm;
      return result;
    };
    double error = 0;
    const T here = size(precise_[place], error);
    const T there = size(precise_[other], error);
    return static_cast<double>(T(there - here)) > 2 * error;
  }

  /// Returns the lift of the chart from which label `number` leads to a lifted chart; 0 is the identity.
  [[nodiscard]] std::uint32_t before(std::uint32_t place, std::uint32_t number) {
    return number == 0 ? place : step(place, number, false);
  }
  /// Returns the lift of the chart to which the label leads from a lifted chart.
  [[nodiscard]] std::uint32_t after(std::uint32_t place, std::uint32_t number) {
    return number == 0 ? place : step(place, number, true);
  }

 private:
  std::uint32_t step(std::uint32_t place, std::uint32_t number, bool inverted) {
    const std::uint64_t key = (std::uint64_t{place} << 32) | (std::uint64_t{number} << 1) | (inverted ? 1 : 0);
    const auto [known, is_new] = steps_.try_emplace(key, kNone);
    if (!is_new) return known->second;
    const NetDocument::Label& label = net_.labels[number - 1];
    const Bounded<T>& by = labels_[number];
    const Bounded<T> result = product(precise_[place], inverted ? inverse_of(by) : by);
    return known->second = found(result, inverted ? label.to : label.from);
  }

  /// Returns the number of a lift of a chart; adds it if it is new.
  ///
  /// For lifts f and fh, h ≠ 1 of length l in the group of the surface, fh − f has the determinant 2 − tr h, at least
  /// 4 sinh²(l/4) in size, and so has −fh − f; so |δa| + |δb| is more than l/2 for both.
  std::uint32_t found(const Bounded<T>& f, std::uint32_t chart) {
    // Accurate enough for binary64 and for the comparisons below. !(<) also holds if the error is NaN.
    if (!(f.error < std::ldexp(f.norm, -60)) || !std::isfinite(f.norm)) throw TooFewBits();
    for (std::uint32_t i = newest_[chart]; i != kNone; i = older_[i]) {
      const Isometry<T>& a = f.isometry;
      const Isometry<T>& b = precise_[i].isometry;
      const double difference = std::min(norm_of(Isometry<T>{a.a - b.a, a.b - b.b}),  //
                                         norm_of(Isometry<T>{a.a + b.a, a.b + b.b}));
      const double error = f.error + precise_[i].error;
      if (difference / (kUp * kUp) > error * kUp) continue;
      if ((difference + error) * kUp >= shortest_curve_ / 2) throw TooFewBits();
      return i;
    }
    const auto number = static_cast<std::uint32_t>(precise_.size());
    precise_.push_back(f);
    // Both parts of w lose 4.3u(|a| + |b|), one of them is multiplied and subtracted: 13.4u(|a| + |b|) in all, and 2u
    // of rounding a and b.
    places_.push_back({convert<double>(f.isometry), (16 * kUlp * f.norm + 2 * f.error) * kUp});
    older_.push_back(newest_[chart]);
    newest_[chart] = number;
    return number;
  }

  const NetDocument& net_;
  const Labels<T>& labels_;
  double shortest_curve_;
  std::vector<Bounded<T>> precise_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> older_;   ///< By place: another lift of the same chart, or none.
  std::vector<std::uint32_t> newest_;  ///< By chart.
  std::unordered_map<std::uint64_t, std::uint32_t> steps_;
};

/// Returns the natural logarithm of x ≥ 1, off by at most (2.5 + 3 log x) units of roundoff. It only uses + − × ÷, so
/// it is the same on every machine.
double log_of(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752) {
    m *= 2;
    --exponent;
  }
  // log m = 2 artanh f, |f| < 0.1716: the omitted terms are less than 10⁻¹⁸.
  const double f = (m - 1) / (m + 1);
  const double g = f * f;
  double sum = 0;
  for (int k = 21; k >= 1; k -= 2) sum = sum * g + 1.0 / k;
  return exponent * 0.69314718055994531 + 2 * f * sum;
}

/// Returns 2 arsinh s, to within `error`.
struct Length2Arsinh {
  double value;
  double error;
};
Length2Arsinh length_with_error(double s) {
  // s + √(1 + s²) is off by 3.1 units.
  const double value = 2 * log_of(s + std::sqrt(1 + s * s));
  return {value, kUlp * (16 + 4 * value)};
}

/// Finds the distances from one vertex after the other.
template <class T>
class Search {
 public:
  explicit Search(const SearchedNet& net)
      : net_(net), newest_(net.net.triangles.size(), kNone), nearest_(net.net.vertices.size()) {}

  /// Searches from vertex p. Requires: `places` has the chart of p in its centre.
  void run(std::uint32_t p, Places<T>& places) {
    for (const Lift& lift : lifts_) newest_[lift.triangle] = kNone;
    lifts_.clear();
    queue_.clear();
    std::fill(nearest_.begin(), nearest_.end(), Interval{kInfinity, kInfinity});
    source_ = p;
    places_ = &places;

    const std::uint32_t dart = net_.dart_from[p];
    reach(dart / 3, places.after(Places<T>::kOwn, certify::corner_label(net_.net, dart)));
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
      const Lift lift = lifts_[queue_.back().second];
      const std::uint32_t number = queue_.back().second;
      queue_.pop_back();
      if (is_dominated(lift, number)) continue;
      for (std::uint32_t side = 0; side < 3; ++side) {
        const std::uint32_t here = 3 * lift.triangle + side;
        const std::uint32_t there = certify::next_dart(certify::opposite(net_.net, here));
        const std::uint32_t corner = places.before(lift.place, certify::corner_label(net_.net, here));
        reach(there / 3, places.after(corner, certify::corner_label(net_.net, there)));
      }
    }
  }

  /// Returns the distance of vertex v from the last source.
  [[nodiscard]] Interval distance(std::uint32_t v) const {
    if (v == source_) return {0, 0};
    const Length2Arsinh lower = length_with_error(nearest_[v].lower);
    const Length2Arsinh upper = length_with_error(nearest_[v].upper);
    return {std::max(0.0, lower.value - lower.error), upper.value + upper.error};
  }

 private:
  /// A lift of a triangle, with enclosures of sinh(d/2) for the distances d of its corners from the source.
  struct Lift {
    std::uint32_t triangle;
    std::uint32_t place;  ///< Of the chart of its corner 0.
    std::uint32_t older;  ///< Another lift of the same triangle, or none.
    std::array<Interval, 3> corner;
  };

  void reach(std::uint32_t triangle, std::uint32_t place) {
    for (std::uint32_t i = newest_[triangle]; i != kNone; i = lifts_[i].older) {
      if (lifts_[i].place == place) return;
    }
    Lift lift{triangle, place, newest_[triangle], {}};
    double key = kInfinity;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t v = net_.net.triangles[triangle].vertex[i];
      lift.corner[i] =
          sinh_half_distance(v, (*places_)[places_->before(place, certify::corner_label(net_.net, 3 * triangle + i))]);
      nearest_[v].lower = std::min(nearest_[v].lower, lift.corner[i].lower);
      nearest_[v].upper = std::min(nearest_[v].upper, lift.corner[i].upper);
      key = std::min(key, lift.corner[i].lower);
    }
    if (is_dominated(lift, kNone)) return;  // Its neighbours need not be visited.
    const auto number = static_cast<std::uint32_t>(lifts_.size());
    if (number > kMostLifts + kMostLiftsOfOne * newest_.size()) throw TooFewBits();
    newest_[triangle] = number;
    lifts_.push_back(lift);
    queue_.emplace_back(key, number);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
  }

  /// Whether another lift of the triangle certainly has all its corners nearer: then this one lies on the other side of
  /// the bisector of two lifts of the source, and no shortest path from the source leads through it.
  [[nodiscard]] bool is_dominated(const Lift& lift, std::uint32_t number) const {
    for (std::uint32_t i = newest_[lift.triangle]; i != kNone; i = lifts_[i].older) {
      if (i != number && dominates(lifts_[i], lift)) return true;
    }
    return false;
  }

  [[nodiscard]] bool dominates(const Lift& other, const Lift& lift) const {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (other.corner[i].lower >= lift.corner[i].upper) return false;
    }
    // Behind a short closed geodesic distances may be too close for binary64.
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (other.corner[i].upper < lift.corner[i].lower) continue;
      const NetDocument::Vertex& v = net_.vertex(net_.net.triangles[lift.triangle].vertex[i]);
      const NetDocument::Vertex& from = net_.vertex(source_);
      const std::uint32_t label = certify::corner_label(net_.net, 3 * lift.triangle + i);
      const std::uint32_t farther_place = places_->before(lift.place, label);
      const std::uint32_t nearer_place = places_->before(other.place, label);
      if (!places_->is_nearer(nearer_place, farther_place, {v.x, v.y}, {from.x, from.y})) return false;
    }
    return true;
  }

  /// Returns sinh(d/2) = |w|/√((1 − |c|²)(1 − |z|²)), w = az + b − c(b̄z + ā), for the source at c and the vertex at z.
  [[nodiscard]] Interval sinh_half_distance(std::uint32_t v, const typename Places<T>::Place& place) const {
    const NetDocument::Vertex& from = net_.vertex(source_);
    const Complex<double> z{net_.vertex(v).x, net_.vertex(v).y};
    const auto& [a, b] = place.isometry;
    const Complex<double> w = (a * z + b) - Complex<double>{from.x, from.y} * (conj(b) * z + conj(a));
    const double scale = net_.scale[source_] * net_.scale[v];
    // The root loses 3u, scales 2.6u each, products u.
    const double value = std::sqrt(norm(w)) * scale;
    const double error = place.error * scale * kUp + 16 * kUlp * value;
    return {std::max(0.0, value - error), value + error};
  }

  static constexpr std::size_t kMostLifts = 100'000;
  static constexpr std::size_t kMostLiftsOfOne = 50;

  const SearchedNet& net_;
  std::uint32_t source_ = kNone;
  Places<T>* places_ = nullptr;
  std::vector<Lift> lifts_;
  std::vector<std::uint32_t> newest_;                    ///< By triangle: its last lift.
  std::vector<Interval> nearest_;                        ///< By vertex: of sinh(d/2).
  std::vector<std::pair<double, std::uint32_t>> queue_;  ///< A heap, the nearest lift on top; its number breaks ties.
};

/// Rows whose vertices are in one chart.
using Chunk = std::vector<std::uint32_t>;

/// Divides the rows into chunks. They do not depend on the number of threads, so the result does not either.
std::vector<Chunk> chunks_of(const NetDocument& net, const std::vector<std::uint32_t>& from) {
  constexpr std::size_t kLargest = 64;
  std::vector<std::uint32_t> rows(from.size());
  std::iota(rows.begin(), rows.end(), 0U);
  const auto chart = [&](std::uint32_t row) { return net.vertices[from[row]].chart; };
  std::stable_sort(rows.begin(), rows.end(), [&](std::uint32_t a, std::uint32_t b) { return chart(a) < chart(b); });
  std::vector<Chunk> chunks;
  for (const std::uint32_t row : rows) {
    if (chunks.empty() || chunks.back().size() == kLargest || chart(chunks.back().front()) != chart(row)) {
      chunks.emplace_back();
    }
    chunks.back().push_back(row);
  }
  return chunks;
}

/// Frees the memory that MPFR keeps for a thread.
struct MpfrCaches {
  MpfrCaches() = default;
  MpfrCaches(const MpfrCaches&) = delete;
  MpfrCaches& operator=(const MpfrCaches&) = delete;
  ~MpfrCaches() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

class TableMaker {
 public:
  TableMaker(const NetDocument& net, DistanceTable& table, const DistanceTableOptions& options)
      : searched_(net), surface_(from_document(net.surface)), table_(table), options_(options) {
    for (const auto* list : {&table.from, &table.to}) {
      for (const std::uint32_t v : *list) require_vertex(v);
    }
    shortest_curve_ = kInfinity;
    for (const Tile& tile : surface_.tiles()) shortest_curve_ = std::min(shortest_curve_, curve_bound(tile));
    if (shortest_curve_ < 1e-70) throw LimitError("closed geodesics of the surface may be shorter than 1e-70");
    table.enclosures.resize(table.from.size() * table.to.size());
  }

  void run() {
    std::vector<Chunk> chunks = chunks_of(searched_.net, table_.from);
    chunks = make<Mp256>(chunks);
    if (!chunks.empty()) chunks = make<Mp1024>(chunks);
    if (!chunks.empty()) chunks = make<Mp4096>(chunks);
    if (!chunks.empty()) {
      throw LimitError("the search for distances from vertex " + std::to_string(table_.from[chunks[0][0]]) +
                       " was given up: too many lifts of triangles are at distances that 4096 bits do not tell apart");
    }
  }

 private:
  void require_vertex(std::uint32_t v) const {
    const std::size_t count = searched_.net.vertices.size();
    if (v >= count) {
      throw NetGeometryError("vertex " + std::to_string(v) + " does not exist, the net has " + std::to_string(count));
    }
    if (searched_.dart_from[v] == kNone) {
      throw NetGeometryError("vertex " + std::to_string(v) + " is a corner of no triangle");
    }
  }

  /// Computes the rows of the chunks; returns the chunks for which the bits of T do not suffice.
  template <class T>
  std::vector<Chunk> make(const std::vector<Chunk>& chunks) {
    const Labels<T> labels(searched_.net, surface_);
    const unsigned threads = certify::thread_count(options_.threads);
    std::vector<std::optional<Search<T>>> searches(std::min<std::size_t>(threads, chunks.size()));
    std::vector<char> failed(chunks.size(), 0);
    std::atomic<std::size_t> rows_done = table_.from.size();
    for (const Chunk& chunk : chunks) rows_done -= chunk.size();
    certify::for_each_parallel(chunks.size(), threads, [&](unsigned worker, std::size_t i) {
      const MpfrCaches caches;
      if (!searches[worker]) searches[worker].emplace(searched_);
      Search<T>& search = *searches[worker];
      try {
        Places<T> places(searched_.net, labels, searched_.vertex(table_.from[chunks[i].front()]).chart,
                         shortest_curve_);
        for (const std::uint32_t row : chunks[i]) {
          search.run(table_.from[row], places);
          for (std::size_t column = 0; column < table_.to.size(); ++column) {
            table_.enclosures[row * table_.to.size() + column] = search.distance(table_.to[column]);
          }
          ++rows_done;
          if (worker == 0 && options_.progress) {
            options_.progress("distances",
                              static_cast<double>(rows_done.load()) / static_cast<double>(table_.from.size()));
          }
        }
      } catch (const TooFewBits&) {
        failed[i] = 1;
      }
    });
    std::vector<Chunk> rest;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      if (failed[i] != 0) rest.push_back(chunks[i]);
    }
    return rest;
  }

  SearchedNet searched_;
  Surface surface_;
  DistanceTable& table_;
  const DistanceTableOptions& options_;
  double shortest_curve_ = 0;
};

}  // namespace

double DistanceTable::error() const {
  double result = 0;
  for (const Interval& x : enclosures) result = std::max(result, (x.upper - x.lower) / 2 * kUp);
  return result;
}

DistanceTable vertex_distances(const NetDocument& net, const std::vector<std::uint32_t>& from,
                               const std::vector<std::uint32_t>& to, const DistanceTableOptions& options) {
  DistanceTable table{from, to, {}};
  TableMaker(net, table, options).run();
  return table;
}

DistanceTable distances_from(const NetDocument& net, const std::vector<std::uint32_t>& from,
                             const DistanceTableOptions& options) {
  std::vector<std::uint32_t> all(net.vertices.size());
  std::iota(all.begin(), all.end(), 0U);
  return vertex_distances(net, from, all, options);
}

std::vector<double> rounded_distances_from(const certify::NetDocument& net, std::uint32_t vertex) {
  const DistanceTable table = distances_from(net, {vertex});
  std::vector<double> result;
  result.reserve(table.to.size());
  for (std::size_t v = 0; v < table.to.size(); ++v) result.push_back(table.distance(0, v));
  return result;
}

std::vector<double> distances_for_page(const certify::NetDocument& net,
                                       const std::optional<certify::Certificate>& certificate) {
  constexpr std::size_t kMostVertices = 100'000;
  if (!certificate || certificate->verdict != certify::Verdict::verified) return {};
  if (net.vertices.size() > kMostVertices) {
    throw LimitError("more than " + std::to_string(kMostVertices) + " vertices");
  }
  return rounded_distances_from(net, 0);
}

}  // namespace epsnet
