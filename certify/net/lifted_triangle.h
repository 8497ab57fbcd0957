#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "certify/base/error.h"
#include "certify/net/document.h"
#include "certify/net/labels.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify {

/// Labels at one precision, by label number.
class LabelTable {
 public:
  /// values[i] is label number numbers[i], of which there are `count` in the document. Fault, if there are not as many
  /// values as numbers, or one is not of a label.
  LabelTable(const std::vector<std::uint32_t>& numbers, std::vector<BallIsometry> values, std::size_t count)
      : values_(std::move(values)), place_(count, kNone) {
    ensure(numbers.size() == values_.size(), "labels and values are not as many");
    for (std::uint32_t i = 0; i < numbers.size(); ++i) {
      ensure(1 <= numbers[i] && numbers[i] <= count, "a value of a label that does not exist");
      place_[numbers[i] - 1] = i;
    }
  }

  /// Fault, if the number was not given to the constructor; number 0, the identity, never is.
  [[nodiscard]] const BallIsometry& operator[](std::uint32_t number) const {
    return looked_up(values_, looked_up(place_, std::size_t{number} - 1, kMissing), kMissing);
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr const char* kMissing = "a label was not evaluated, place";

  std::vector<BallIsometry> values_;
  std::vector<std::uint32_t> place_;  ///< By label number minus 1.
};

/// The measures of one triangle in the chart it lives in, in balls; reused from triangle to triangle so that nothing is
/// allocated. What is measured is returned, and stays until it is measured again. Fault, if nothing was loaded.
///
/// A corner is z = (a w + b)/(b̄ w + ā) for the vertex w and its label (a, b), |a|² − |b|² = 1. Its gap 1 − |z|² is
/// (1 − |w|²)/|b̄ w + ā|², a quotient that loses nothing where |z| is near 1.
class LiftedTriangle {
 public:
  /// Reads triangle t: corners z_i, gaps A_i = 1 − |z_i|², and squared differences D_i = |z_j − z_i|² for j = i + 1
  /// (mod 3), for which sinh²(length/2) = D_i/(A_i A_j).
  void load(const NetDocument& document, const LabelTable& labels, std::uint32_t t, slong precision);

  [[nodiscard]] const Ball& gap(std::uint32_t corner) const {
    ensure_loaded(corner);
    return gap_[corner];
  }
  [[nodiscard]] const Ball& squared_difference(std::uint32_t edge) const {
    ensure_loaded(edge);
    return squared_difference_[edge];
  }

  /// Positive exactly if the triangle is strictly counterclockwise in the hyperbolic plane.
  ///
  /// It is det(x, y, 1 + |z|²) of the corners, a positive multiple of the determinant in the hyperboloid model.
  const Ball& measure_orientation(slong precision);

  /// The circumradius R: sinh²R = numerator/denominator; R < ε exactly if slack = sinh²ε · denominator − numerator is
  /// positive (for corners that are not all on one line; where there is no circumcircle it is negative).
  struct Circumradius {
    Ball numerator;
    Ball denominator;
    Ball slack;
  };
  /// With a, b, c = sinh² of half the sides, sinh²R = 4abc/(2(ab + bc + ca) − a² − b² − c²); there is a circumcircle
  /// exactly if the denominator is positive (docs/proof.md, Lemma 5). Both are multiplied by (A_0 A_1 A_2)².
  const Circumradius& measure_circumradius(arb_srcptr sinh_squared, slong precision);

  /// Of edge i, from corner i to corner j: gap_product = A_i A_j, and lack = sinh²(ε/2) A_i A_j − D_i, positive exactly
  /// if the edge is shorter than ε.
  struct Edge {
    Ball gap_product;
    Ball lack;
  };
  /// `half_sinh_squared` is sinh²(ε/2).
  const Edge& measure_edge(arb_srcptr half_sinh_squared, std::uint32_t edge, slong precision);

  /// A positive multiple of Im (z3−z1)(z2−z0)/((z3−z0)(z2−z1)), z0 z2 the given edge of the triangle t that was loaded,
  /// z3 the third corner of t on its left, z1 the far corner of the neighbour on its right, lifted to the chart of t.
  const Ball& measure_cross_ratio(const NetDocument& document, const LabelTable& labels, std::uint32_t edge,
                                  slong precision);

 private:
  /// The direction in which a label takes a point.
  enum class Way { forth, back };

  /// Takes z to its image under a label, in place; stretch_ becomes |b̄ z + ā|² of the old z.
  void move(ComplexBall& z, const BallIsometry& label, Way way, slong precision);

  /// Fault, unless there is a triangle, and it has this corner, or edge.
  void ensure_loaded(std::uint32_t corner = 0) const {
    ensure(triangle_ && corner < 3, "a triangle is measured that was not loaded, or a fourth side of it");
  }

  std::optional<std::uint32_t> triangle_;
  Ball orientation_;
  Circumradius circumradius_;
  Edge edge_;
  Ball cross_ratio_;
  std::array<Ball, 3> squared_difference_;
  std::array<Ball, 3> gap_;
  std::array<ComplexBall, 3> corner_;
  ComplexBall far_;
  std::array<ComplexBall, 3> side_;  ///< z_j − z_i.
  ComplexBall to_far_;
  ComplexBall across_;
  ComplexBall product_;
  ComplexBall other_product_;
  Ball stretch_;
  std::array<Ball, 4> t_;
};

/// num/den as an interval of binary64, outward; everything up from 0 if den may be 0.
///
/// Both quantities are nonnegative by what they are, so ends below 0 count as 0.
[[nodiscard]] Interval quotient(const Ball& numerator, const Ball& denominator);
/// The quotient of two enclosures.
[[nodiscard]] Interval quotient(Interval n, Interval d);

/// From an interval of sinh² of a length to one of `factor` times the length, outward.
[[nodiscard]] Interval length_interval(Interval squared_sinh, slong factor);

/// The sign of LiftedTriangle::measure_orientation for triangle t, exactly; nullopt if its numbers are too large to
/// calculate with.
[[nodiscard]] std::optional<int> exact_orientation(const NetDocument& document, const LabelEvaluator& evaluator,
                                                   std::uint32_t t);
/// The sign of LiftedTriangle::measure_cross_ratio for the edge of a dart, likewise.
[[nodiscard]] std::optional<int> exact_cross_ratio_sign(const NetDocument& document, const LabelEvaluator& evaluator,
                                                        std::uint32_t dart);

}  // namespace epsnet::certify
