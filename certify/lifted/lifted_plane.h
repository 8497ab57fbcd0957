#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "certify/base/error.h"
#include "certify/net/labels.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/isometry.h"

/// The lifted triangulation at one precision: each triangle in its chart, and what leads across its darts.
namespace epsnet::certify {

// The hyperboloid model in ball arithmetic.
//
// A point z of the disk is the vector X = (2x, 2y, 1 + |z|²)/(1 − |z|²) with ⟨X, X⟩ = −1, where ⟨u, v⟩ = u₀v₀ + u₁v₁ −
// u₂v₂; −⟨X, Y⟩ is the cosh of the distance. Linear functionals are kept as rows, so that their value is the plain dot
// product: the row of ⟨n, ·⟩ is (n₀, n₁, −n₂).

/// The unit vector of the point L(x + iy).
[[nodiscard]] BallVector unit_vector(const BallIsometry& label, double x, double y, slong precision);

/// The matrix of an isometry.
using BallMatrix = std::array<BallVector, 3>;

[[nodiscard]] BallMatrix lorentz_matrix(const BallIsometry& f, slong precision);
[[nodiscard]] BallVector apply(const BallMatrix& m, const BallVector& x, slong precision);

/// The same isometry with Re a > 0; the sign of (a, b) means nothing. Unchanged if balls do not tell: whoever compares
/// Re a afterwards asks for its sign first, or for cosh_half_length.
void choose_sign(BallIsometry& f);

/// cosh(l/2) = |Re a| for the translation length l, whatever the sign of (a, b).
[[nodiscard]] Ball cosh_half_length(const BallIsometry& f);

/// The row of the traceless part of f, (i Im a, b), which is the image of the vector (−Im b, Re b, Im a).
[[nodiscard]] BallVector traceless_row(const BallIsometry& f);

/// The row of the unit normal of the axis of f, positive on the left of the axis directed like the translation. f is
/// hyperbolic with Re a = cosh(l/2), l its translation length. Not finite if balls do not tell Re a > 1.
[[nodiscard]] BallVector axis_row(const BallIsometry& f, slong precision);

/// One precision's view of a net that passed `check`. Reads only after construction, so threads may share it. Fault, if
/// there is no such label, dart, triangle or chart.
class LiftedPlane {
 public:
  /// `net`, which must outlive the plane, may have labels that no triangle uses. O(size of the net) time and memory,
  /// about 1 kB a triangle.
  LiftedPlane(const NetDocument& net, const LabelEvaluator& evaluator, const LabelParts& parts, slong precision,
              slong cap, unsigned threads);
  LiftedPlane(const NetDocument&& net, const LabelEvaluator& evaluator, const LabelParts& parts, slong precision,
              slong cap, unsigned threads) = delete;

  [[nodiscard]] slong precision() const { return precision_; }
  [[nodiscard]] const NetDocument& net() const { return net_; }
  /// Takes the work of so many operations of balls off the budget.
  void spend(std::uint64_t operations, std::uint64_t times = 1) const {
    budget_.spend(operations * ball_work(static_cast<std::uint64_t>(precision_)), times);
  }
  /// The same for so many steps in which nothing is computed.
  void pass(std::uint64_t steps) const { budget_.spend(2, steps); }
  /// The same for memory for so many balls.
  void keep(std::uint64_t balls, std::uint64_t times = 1) const {
    budget_.spend(memory_work(balls * (48 + static_cast<std::uint64_t>(precision_) / 8)), times);
  }

  /// The value of a label number; 0 is the identity.
  [[nodiscard]] const BallIsometry& label(std::uint32_t number) const {
    return looked_up(labels_, number, "there is no value of label number");
  }
  /// The corner where the dart starts, as a unit vector in the chart of its triangle.
  [[nodiscard]] const BallVector& corner(std::uint32_t dart) const { return looked_up(corners_, dart, kNoDart); }

  /// From the chart of a dart's triangle to that of the triangle across.
  struct Transition {
    BallIsometry isometry;
    BallMatrix matrix;
  };
  /// Nothing where the two charts are the same and the transition is the identity.
  [[nodiscard]] const Transition* transition(std::uint32_t dart) const {
    const std::uint32_t number = looked_up(transition_of_, dart, kNoDart);
    return number == 0 ? nullptr : &transitions_[number - 1];
  }

  /// Whether two elements of the surface's group, written in one chart, are the same; signs are chosen (choose_sign).
  ///
  /// `yes` by discreteness (docs/proof.md, Lemma 2), `no` by disjoint balls.
  [[nodiscard]] Tri same(std::uint32_t chart, const BallIsometry& f, const BallIsometry& g) const;

 private:
  static constexpr const char* kNoDart = "there is no dart";

  void evaluate_labels(const LabelEvaluator& evaluator, slong cap, unsigned threads);
  void find_transitions();
  void find_disks(const LabelParts& parts, slong cap);

  const NetDocument& net_;
  const Budget& budget_;
  slong precision_;
  std::vector<BallIsometry> labels_;
  std::vector<BallVector> corners_;
  std::vector<Transition> transitions_;
  std::vector<std::uint32_t> transition_of_;  ///< By dart, plus 1; 0 for the identity.

  /// A disk inside the tile of a chart: `base` takes 0 to its centre, in the chart's coordinates.
  struct Disk {
    BallIsometry base;
    Ball sinh_radius;
  };
  std::vector<std::optional<Disk>> disks_;  ///< By chart.
};

// To find what has equal numbers.

/// Items by intervals that enclose a number each has. Items whose numbers may be equal are found together: the
/// intervals of two equal numbers have a point in common, so no pair of equal numbers is missed, however wide the
/// intervals are.
///
/// Fault, if the ends of an interval are in the wrong order.
class IntervalIndex {
 public:
  /// O(log n).
  void insert(Interval x, std::uint32_t item);

  /// Every item whose interval meets x, in ascending order, and perhaps some whose interval is as near to x as it is
  /// wide. O(k log k + c log n) for k of them and intervals whose widths have c different exponents.
  [[nodiscard]] std::vector<std::uint32_t> near(Interval x) const;

 private:
  /// By an exponent e of the width, which is less than 2^e: the lower ends. So an upper end is less than 2^e higher,
  /// and one wide interval does not slow down the search among narrow ones.
  std::map<int, std::multimap<double, std::uint32_t>> by_width_;
  std::vector<std::uint32_t> unbounded_;  ///< Items about whose numbers binary64 says nothing.
};

inline void IntervalIndex::insert(Interval x, std::uint32_t item) {
  ensure(!(x.lower > x.upper), "an interval with its ends exchanged");
  const double width = above(x.upper - x.lower);
  // NaN and infinity are no widths.
  if (!std::isfinite(width)) {
    unbounded_.push_back(item);
    return;
  }
  int exponent = 0;
  (void)std::frexp(width, &exponent);
  by_width_[exponent].emplace(x.lower, item);
}

inline std::vector<std::uint32_t> IntervalIndex::near(Interval x) const {
  ensure(!(x.lower > x.upper), "an interval with its ends exchanged");
  std::vector<std::uint32_t> found = unbounded_;
  for (const auto& [exponent, items] : by_width_) {
    const auto last = items.upper_bound(x.upper);
    for (auto item = items.lower_bound(below(x.lower - std::ldexp(1.0, exponent))); item != last; ++item) {
      found.push_back(item->second);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace epsnet::certify
