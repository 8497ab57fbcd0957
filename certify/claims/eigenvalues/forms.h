#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/document.h"
#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/inertia.h"
#include "certify/numbers/isometry.h"

/// The matrices of an eigenvalues file: phases of sections across sides, the halved net, the energy and the mass of
/// functions on a hyperbolic triangle, bounded by those of linear functions on the flat triangle with the same corners,
/// and entries of binary64 (docs/proof.md, section 17). Balls round to the precision of the caller.
namespace epsnet::certify {

// Phases of the sides of a surface, and the flat line bundle that they are (docs/proof.md, section 17.3). Exact.

/// What is wrong with the phases of so many sides; nullopt if there is one for each, written as a decimal without
/// exponent or as a rational of at most 40 characters, of absolute value less than 1, and all are multiples of 1/n for
/// some n ≤ 10¹⁸.
[[nodiscard]] Problem phases_problem(const std::vector<std::string>& phases, std::size_t sides);

/// A number of turns modulo 1, as a multiple of 1/n, n the denominator of a line bundle: less than n.
using Phase = std::uint64_t;

/// A section of it is multiplied by e^{2πiθ} across a side of phase θ.
class LineBundle {
 public:
  /// That of functions: all phases are 0.
  LineBundle() = default;
  /// By side of the surface. Requires: no problem.
  explicit LineBundle(const std::vector<std::string>& phases);

  /// The least n of which all phases are multiples of 1/n.
  [[nodiscard]] std::uint64_t denominator() const { return denominator_; }
  [[nodiscard]] Phase sum(Phase x, Phase y) const { return x < denominator_ - y ? x + y : x - (denominator_ - y); }
  [[nodiscard]] Phase difference(Phase x, Phase y) const { return x < y ? x + (denominator_ - y) : x - y; }
  /// e^{2πiφ}, with parts that are exact if they are 0 or ±1. Balls round to the precision of the caller.
  [[nodiscard]] ComplexBall turn(Phase phase) const;
  /// The sum of those of the sides.
  [[nodiscard]] Phase of(std::span<const std::uint32_t> word) const;

  /// The first pair of sides, or else the first vertex of the surface, at which phases do not add up to an integer;
  /// nullopt if there is none: then that of a word only depends on the element that is its value. O(number of sides).
  [[nodiscard]] Problem problem(const SurfaceSides& sides) const;

 private:
  std::uint64_t denominator_ = 1;
  std::vector<Phase> phases_;  ///< By side; empty: 0.
};

// A net whose triangles are divided into four, several times (docs/proof.md, section 17.1).

/// How many sides and vertices there are after `halvings`.
struct HalvedSizes {
  std::uint64_t sides;
  std::uint64_t vertices;
};

/// Requires: at most 12 halvings.
[[nodiscard]] HalvedSizes halved_sizes(const NetDocument& net, std::uint32_t halvings);

/// Which triangles, sides and vertices meet.
struct HalvedNet {
  /// By triangle: the number of the side from corner i to corner i + 1, and of the vertex at corner i.
  std::vector<std::array<std::uint32_t, 3>> sides;
  std::vector<std::array<std::uint32_t, 3>> vertices;
  /// The phase of what leads from values of sections in the frame of the side, or vertex, to those in the triangle's
  /// (docs/proof.md, section 17.3).
  std::vector<std::array<Phase, 3>> side_phases;
  std::vector<std::array<Phase, 3>> vertex_phases;
};

/// O(number of triangles and of letters of the labels). Requires: the rule `map` is verified, and `phases` if there are
/// any; the sizes are less than 2³⁰.
[[nodiscard]] HalvedNet halved_net(const NetDocument& net, std::uint32_t halvings, const LineBundle& bundle = {});

/// By triangle of the halved net that triangle `t` of the net contains, 4^halvings of them: the squares of the sides of
/// its flat triangle, 4 sinh²(d/2), the one opposite to corner i at i. Balls round to the precision of the caller.
///
/// `labels` are the values of the net's labels, number k ≥ 1 at k − 1.
[[nodiscard]] std::vector<std::array<Ball, 3>> flat_sides(const NetDocument& net,
                                                          const std::vector<BallIsometry>& labels, std::uint32_t t,
                                                          std::uint32_t halvings);

/// A symmetric form of the values of a function in three points: of the squares of each, and of the products of the
/// other two.
struct SymmetricForm {
  std::array<Ball, 3> square;
  std::array<Ball, 3> product;
};

/// A flat triangle by its sides.
class FlatTriangle {
 public:
  /// By the squares of the sides, the one opposite to corner i at i; nothing unless it is certain that they are those
  /// of a triangle.
  [[nodiscard]] static std::optional<FlatTriangle> of(const std::array<Ball, 3>& squares);

  /// The energy a∫|∇v|² for the values of v in the midpoints of the sides (Lemma 32).
  [[nodiscard]] SymmetricForm least_energy() const;
  /// The mass ∫(C − κω)v² for these.
  [[nodiscard]] SymmetricForm greatest_mass() const;
  /// 0.1893² l² C(1 + R) (Lemma 33).
  [[nodiscard]] Ball interpolation_constant() const;

  /// A bound for |∇f| on T, by the values of f in the corners (Lemma 37.10).
  [[nodiscard]] Ball greatest_slope(const std::array<Ball, 3>& values) const;

  /// The energy and mass of Lemma 35 for the values of f in the corners.
  [[nodiscard]] SymmetricForm greatest_energy() const;
  [[nodiscard]] SymmetricForm least_mass() const;

 private:
  explicit FlatTriangle(const std::array<Ball, 3>& squares);

  /// The greatest eigenvalue of the mean of the inverse of B − c is at most that.
  [[nodiscard]] Ball mean_of_inverse(const Ball& c) const;

  std::array<Ball, 3> squares_;     ///< l_i²
  Ball area_;                       ///< |T|
  std::array<Ball, 3> cotangents_;  ///< Of the angles.
  Ball radius_;                     ///< R
  Ball cosh_;                       ///< C
  Ball mean_power_;                 ///< ω̄
  Ball trace_;                      ///< X
  Ball greater_;                    ///< Λ
};

// Entries of matrices in binary64, from numbers that are known better. Nothing overflows: numbers of triangles and of
// files are far from the greatest binary64.

/// A ball as a number of binary64: all its points are at most `error` from `value`.
struct Rounded {
  explicit Rounded(const Ball& x) {
    const Interval in = outer_interval(x);
    value = in.lower / 2 + in.upper / 2;
    error = above(above(in.upper - in.lower));
  }
  double value;
  double error;
};

/// x − σy at place (i, j) or (j, i), σ exact: how far it may be from the number that x and y stand for.
[[nodiscard]] inline MatrixEntry difference_entry(std::uint32_t i, std::uint32_t j, const Rounded& x, double sigma,
                                                  const Rounded& y) {
  const double product = sigma * y.value;
  const double value = x.value - product;
  const double errors = above(x.error + above(sigma * y.error));
  const double rounding = above(above(std::abs(product) + std::abs(value)) * 0x1p-52);
  return {std::max(i, j), std::min(i, j), value, above(errors + rounding)};
}

/// x times a number of absolute value at most 1.
[[nodiscard]] inline MatrixEntry multiple_of(const MatrixEntry& x, const Rounded& factor) {
  const double value = x.value * factor.value;
  const double errors = above(above(std::abs(x.value) * factor.error) + x.error);
  return {x.row, x.column, value, above(errors + above(std::abs(value)) * 0x1p-52)};
}

}  // namespace epsnet::certify
