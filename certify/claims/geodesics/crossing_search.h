#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/geodesics/sequences.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify {

/// More than what underflows of a product.
inline constexpr double kUnderflow = 0x1p-900;

/// A number within `radius` of high + low, two numbers of binary64, |low| ≤ 2⁻⁵³ |high|: some hundred bits, in a fifth
/// of the time that balls take. Nothing is known of a number whose members are not finite. docs/proof.md, Lemma 14.1,
/// bounds the errors; it asks for rounding to nearest (RoundingToNearest).
struct DoubleDouble {
  double high = 0;
  double low = 0;
  double radius = 0;

  [[nodiscard]] DoubleDouble operator-() const { return {-high, -low, radius}; }
};

/// A number that encloses the ball.
[[nodiscard]] DoubleDouble to_double_double(const Ball& x);

[[nodiscard]] inline bool is_finite(const DoubleDouble& x) { return std::isfinite(x.high) && std::isfinite(x.radius); }

/// 1 or −1 if the number certainly has this sign; else 0, which says nothing.
[[nodiscard]] inline int certain_sign(const DoubleDouble& x) {
  // |low| is at most half of |high|.
  if (!(std::fabs(x.high) > 2 * x.radius)) return 0;
  return x.high > 0 ? 1 : -1;
}

/// An interval around a number that is finite.
[[nodiscard]] inline Interval fast_interval(const DoubleDouble& x) {
  // |low| is less than the units by which each end is moved once more.
  return {below(below(x.high) - x.radius), above(above(x.high) + x.radius)};
}

/// x₀y₀ + x₁y₁ + …, of up to three products.
template <std::size_t N>
[[nodiscard]] DoubleDouble sum_of_products(const std::array<DoubleDouble, N>& x, const std::array<DoubleDouble, N>& y) {
  static_assert(N <= 3, "the bounds for errors are those of three products");
  double sum = 0;        // Of the products of the high parts, rounded,
  double rest = 0;       // and what is to be added to it.
  double size = 0;       // Of the absolute values of these products.
  double inherited = 0;  // The error of the factors.
  for (std::size_t i = 0; i < N; ++i) {
    // T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18, 1971.
    const auto split = [](double a) {
      const double scaled = 0x1.0000002p+27 * a;
      const double upper = scaled - (scaled - a);
      return std::array{upper, a - upper};
    };
    const double product = x[i].high * y[i].high;
    const auto [a, b] = split(x[i].high);
    const auto [c, d] = split(y[i].high);
    const double error = ((a * c - product) + a * d + b * c) + b * d;
    rest += error + (x[i].high * y[i].low + x[i].low * y[i].high);
    // D. E. Knuth, The Art of Computer Programming 2, 4.2.2, Theorem B.
    const double before = sum;
    sum += product;
    const double part = sum - before;
    rest += (before - (sum - part)) + (product - part);
    size += std::fabs(product);
    inherited += std::fabs(x[i].high) * y[i].radius + std::fabs(y[i].high) * x[i].radius + x[i].radius * y[i].radius;
  }
  const double high = sum + rest;
  const double part = high - sum;
  const double low = (sum - (high - part)) + (rest - part);
  return {high, low, (0x1p-98 * size + inherited) * (1 + 0x1p-40) + kUnderflow};
}

// Cones of functionals by rays on their boundaries, for balls and for numbers of twice the length of binary64
// (docs/proof.md, Lemma 14).

/// By its values at three points.
template <class Number>
using Functional = std::array<Number, 3>;

/// x₀y₀ + x₁y₁ + …
template <std::size_t N>
[[nodiscard]] Ball sum_of_products(const std::array<Ball, N>& x, const std::array<Ball, N>& y) {
  Ball result;
  arb_dot(result.get(), nullptr, 0, x[0].get(), 1, y[0].get(), 1, N, Precision::bits());
  return result;
}

/// The ray between two on which the third value vanishes; that has different signs at the two.
template <class Number>
[[nodiscard]] Functional<Number> meeting(const Functional<Number>& x, const Functional<Number>& y) {
  const bool positive = certain_sign(x[2]) > 0;
  const std::array<Number, 2> weights{positive ? -y[2] : y[2], positive ? x[2] : -x[2]};
  Functional<Number> result;
  for (std::size_t i = 0; i < 2; ++i) result[i] = sum_of_products(weights, std::array<Number, 2>{x[i], y[i]});
  return result;
}

/// Adds to `part` rays of a cone that contains all functionals of the given one, whose rays are in cyclic order, of
/// which the third value is 0 or has the sign `wanted`, 1 or −1; none only if there certainly are no such functionals.
/// `sides` is only used on the way.
template <class Number>
void clip_cone(std::span<const Functional<Number>> rays, int wanted, std::vector<int>& sides,
               std::vector<Functional<Number>>& part) {
  const std::size_t count = rays.size();
  sides.resize(count);
  for (std::size_t i = 0; i < count; ++i) sides[i] = wanted * certain_sign(rays[i][2]);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i == 0 ? count - 1 : i - 1;
    const std::size_t after = i + 1 == count ? 0 : i + 1;
    // One that is certainly out, next to one of which that is not known: the edge between may be partly in.
    if (sides[i] >= 0 || sides[before] == 0 || sides[after] == 0) part.push_back(rays[i]);
    if (sides[i] * sides[after] < 0) part.push_back(meeting(rays[i], rays[after]));
  }
}

// The distance of two geodesic segments, in intervals of binary64 that are rounded outward.

/// Of two segments, from s to e and from r to l: enclosures of the cosh of the distances of their ends and of their
/// lengths.
struct SegmentPair {
  Interval e_l;
  Interval s_l;
  Interval e_r;
  Interval s_r;
  Interval l_r;
  Interval e_s;
};

/// A lower bound of cosh² of the distance of two segments that do not cross each other: the least of four distances of
/// an end from the other segment, and that of the lines, if it is possibly attained on the segments.
[[nodiscard]] double cosh2_below(SegmentPair pair);

/// What is asked at every closed geodesic that is found, in the order of the search.
enum class Search { go_on, stop };

struct SearchOutcome {
  bool complete = false;  ///< All were reported; false if this precision or `limit` does not suffice.
  bool limit_reached = false;
  std::uint64_t visits = 0;  ///< Darts crossed.
};

/// The closed geodesics of a triangulated surface by the sequences of edges that they cross: the search for least
/// cyclic sequences of darts, one edge to begin at after the other (docs/proof.md, section 11).
class CrossingSearch {
 public:
  /// The net and the order of its darts must outlive the search. Closed geodesics that cross only edges that are last
  /// in the order need not be found. `cosh_half` is cosh(L/2).
  CrossingSearch(const MovedNet& net, const DartOrder& order, const Ball& cosh_half);

  /// A cyclic sequence, by the codes of the darts.
  using Report = std::function<Search(const std::vector<std::uint32_t>&)>;

  /// In how many parts the search is done. The first edges have most of the work, and have a part for each choice of
  /// the first turns.
  [[nodiscard]] std::size_t size() const { return parts_.size(); }

  /// Reports the least sequence of each primitive closed geodesic of length at most L that belongs to a part, in one of
  /// the two directions. Duplicates and other sequences are possible; all are less than their other rotations.
  /// Thread-safe.
  ///
  /// Depth first, with memory proportional to the depth. A visit is a dart crossed.
  [[nodiscard]] SearchOutcome run(std::size_t part, std::uint64_t limit, const Report& report) const;

 private:
  /// The ways from an edge on; the first turns are given, to the left or to the right.
  struct Part {
    std::uint32_t first;  ///< The code of the first dart.
    std::vector<bool> to_left;
  };
  template <class Number>
  class Way;
  struct Limits;

  template <class Number>
  [[nodiscard]] std::optional<Limits> limits(std::uint32_t first, Way<Number>& way) const;
  template <class Number>
  [[nodiscard]] SearchOutcome run_with(const std::vector<std::array<Number, 3>>& beyond, const Part& part,
                                       std::uint64_t limit, const Report& report) const;

  const MovedNet& net_;
  const DartOrder& order_;
  Ball length_;  ///< L
  std::vector<Part> parts_;
  std::vector<std::array<DoubleDouble, 3>> beyond_;  ///< As the net has it, by dart; empty if it has too many bits.
};

/// What is known of the closed geodesics that a list lacks.
struct Completeness {
  Tri complete = Tri::unknown;
  bool limit_reached = false;
  std::uint64_t visits = 0;
  std::uint64_t candidates = 0;  ///< Sequences of closed geodesics that are perhaps short enough.
  std::string missing;           ///< Of one that is missing, in words.
};

/// The edges at the vertex of a loop edge, by the darts that leave it, of which both ends certainly lie in the collar
/// of the loop's core: if l is its length and sinh(l/2) < 1, nearer to the same lift of the core than w, sinh w =
/// 1/sinh(l/2) (docs/proof.md, Lemma 13). Nullopt if the precision is too low to tell a very short core from none.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> edges_in_collar(const MovedNet& net, std::uint32_t loop);

/// A list of closed geodesics at one precision, by the edges that they cross (docs/proof.md, section 11).
class CrossingPass {
 public:
  /// One geodesic's element, in the chart of the vertex that the dart leaves.
  struct Member {
    std::uint32_t first_dart;
    BallIsometry element;
  };

  /// All must outlive the pass. The evaluator's document is the net with the words of the list as further labels.
  /// `cosh_half` is cosh(L/2), `member(i)` makes member i of the document's list. Several threads work.
  CrossingPass(const GeodesicsDocument& document, const LabelEvaluator& evaluator, const LiftedPlane& plane,
               const Ball& cosh_half, const std::function<Member(std::size_t)>& member, unsigned threads);

  /// Whether it is known which edges each geodesic of the list crosses, and which edges lie in collars; otherwise
  /// nothing of what follows may be asked.
  [[nodiscard]] bool complete() const { return table_.has_value(); }

  /// The list.
  [[nodiscard]] const SequenceTable& table() const { return *table_; }
  /// By geodesic: whether it crosses itself; and, for a thick-thin decomposition, another one.
  [[nodiscard]] const std::vector<Meetings>& meetings() const { return meetings_; }
  /// The geodesics of a thick-thin decomposition, or the first cluster of a local maximum; nothing else is kept.
  [[nodiscard]] const std::vector<AxisCrossings>& geodesics() const { return geodesics_; }
  [[nodiscard]] const MovedNet& net() const { return moved_; }
  /// How many loop edges are inside the collars of their cores.
  [[nodiscard]] std::size_t loops() const { return loops_.size(); }

  /// Searches for what the list lacks, across at most `limit` edges. Calls progress(share done) now and then, from the
  /// calling thread. The result does not depend on the number of threads.
  [[nodiscard]] Completeness search(std::uint64_t limit, unsigned threads,
                                    const std::function<void(double)>& progress) const;

 private:
  [[nodiscard]] std::vector<std::uint32_t> codes_of(const std::vector<std::uint32_t>& darts) const;
  [[nodiscard]] std::vector<std::uint32_t> codes_of_loop(std::uint32_t loop) const;
  [[nodiscard]] Tri is_in_order(const std::vector<std::uint32_t>& codes, Completeness& part) const;
  [[nodiscard]] Tri is_to_be_listed(const BallIsometry& element, const std::vector<std::uint32_t>& darts) const;

  const GeodesicsDocument& document_;
  const LabelEvaluator& evaluator_;
  std::uint32_t first_element_;  ///< The label number of the first geodesic's word.
  const LiftedPlane& plane_;
  const NetDocument& net_;
  ExactTraces traces_;
  Ball cosh_half_;
  MovedNet moved_;
  std::vector<std::uint32_t> loops_;  ///< One dart of each loop edge that is inside the collar of its core.
  std::optional<DartOrder> order_;
  std::optional<CrossingSearch> search_;
  std::optional<SequenceTable> table_;
  std::vector<Meetings> meetings_;
  std::vector<AxisCrossings> geodesics_;
};

}  // namespace epsnet::certify
