#pragma once

#include <epsnet/certify/ball.h>
#include <epsnet/certify/document.h>
#include <epsnet/certify/label_evaluator.h>

#include <array>
#include <cstdint>
#include <vector>

namespace epsnet::certify {

/// Labels at one precision, by label number. Numbers that were not asked for must not be looked up.
class LabelTable {
 public:
  /// values[i] is label number numbers[i]; `count` is the number of labels of the document.
  LabelTable(const std::vector<std::uint32_t>& numbers, std::vector<BallIsometry> values, std::size_t count)
      : values_(std::move(values)), index_(count + 1) {
    for (std::size_t i = 0; i < numbers.size(); ++i) index_[numbers[i]] = static_cast<std::uint32_t>(i);
  }

  [[nodiscard]] const BallIsometry& operator[](std::uint32_t number) const { return values_[index_[number]]; }

 private:
  std::vector<BallIsometry> values_;
  std::vector<std::uint32_t> index_;
};

/// The measures of one triangle in the chart it lives in, in balls; reused from triangle to triangle so that nothing is
/// allocated.
///
/// A corner is z = n/d with n = a w + b, d = b̄ w + ā for the vertex w and its label (a, b), |a|² − |b|² = 1. So
/// |d|² − |n|² = 1 − |w|² =: A, the corner's gap. Nothing is divided: every quantity below is homogeneous. With all
/// labels the identity, n = w and d = 1, which has code of its own because almost all triangles are so.
class LiftedTriangle {
 public:
  /// Reads triangle t: gaps, and squared differences D_i = |n_i d_j − n_j d_i|² of corners i and j = i + 1 (mod 3), for
  /// which sinh²(length/2) = D_i/(A_i A_j).
  void load(const Document& document, const LabelTable& labels, std::uint32_t t, slong precision);

  /// orientation: positive exactly if the triangle is strictly counterclockwise in the hyperbolic plane.
  ///
  /// It is det(x, y, (1 + |z|²)/2) of the corners, a positive multiple of the determinant in the hyperboloid model.
  void measure_orientation(slong precision);

  /// The circumradius R: sinh²R = radius_numerator/radius_denominator, R > ε or no circumcircle at all exactly if
  /// radius_numerator > radius_limit = sinh²ε · radius_denominator (for corners that are not all on one line).
  ///
  /// With a, b, c = sinh² of half the sides, sinh²R = 4abc/(2(ab + bc + ca) − a² − b² − c²); there is a circumcircle
  /// exactly if the denominator is positive (docs/proof.md, Lemma 5). Both are multiplied by (A_0 A_1 A_2)².
  void measure_circumradius(arb_srcptr sinh_squared, slong precision);

  /// length_limit = half_sinh_squared · A_i A_j, gap_product = A_i A_j, for edge i from corner i to corner j.
  void measure_edge(arb_srcptr half_sinh_squared, std::uint32_t edge, slong precision);

  /// cross_ratio: a positive multiple of Im (z3−z1)(z2−z0)/((z3−z0)(z2−z1)), z0 z2 the edge of the dart 3t + edge,
  /// z3 the third corner of t on its left, z1 the far corner of the neighbour on its right, lifted to the chart of t.
  void measure_cross_ratio(const Document& document, const LabelTable& labels, std::uint32_t t, std::uint32_t edge,
                           slong precision);

  Ball orientation;
  Ball radius_numerator;
  Ball radius_denominator;
  Ball radius_limit;
  Ball length_limit;
  Ball gap_product;
  Ball cross_ratio;
  std::array<Ball, 3> squared_difference;
  std::array<Ball, 3> gap;

 private:
  struct Corner {
    ComplexBall n;
    ComplexBall d;
  };

  void place(Corner& corner, const Vertex& vertex, const BallIsometry* label, slong precision);
  void difference(ComplexBall& result, const Corner& x, const Corner& y, slong precision);

  std::array<Corner, 3> corner_;
  bool identity_ = true;  ///< All three labels are the identity: every d is 1.
  Corner far_;
  std::array<ComplexBall, 3> side_;  ///< z_j − z_i of the edges (homogeneous).
  ComplexBall to_far_;
  ComplexBall across_;
  ComplexBall z_;
  ComplexBall product_;
  ComplexBall other_product_;
  std::array<Ball, 4> t_;
};

/// num/den as an interval of binary64, outward; everything up from 0 if den may be 0.
///
/// Both quantities are nonnegative by what they are, so ends below 0 count as 0.
[[nodiscard]] Interval quotient(arb_srcptr numerator, arb_srcptr denominator);

/// The sign of LiftedTriangle::orientation for triangle t, exactly.
[[nodiscard]] int exact_orientation(const Document& document, const LabelEvaluator& evaluator, std::uint32_t t);
/// The sign of LiftedTriangle::cross_ratio for the edge of a dart, exactly.
[[nodiscard]] int exact_cross_ratio_sign(const Document& document, const LabelEvaluator& evaluator, std::uint32_t dart);

/// Whether the numbers that these two make are of a size to calculate with.
[[nodiscard]] bool exact_orientation_is_feasible(const Document& document, const LabelEvaluator& evaluator,
                                                 std::uint32_t t);
[[nodiscard]] bool exact_cross_ratio_is_feasible(const Document& document, const LabelEvaluator& evaluator,
                                                 std::uint32_t dart);

}  // namespace epsnet::certify
