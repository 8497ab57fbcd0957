#pragma once

#include <array>
#include <optional>

#include "certify/numbers/ball.h"

/// The energy and the mass of functions on a hyperbolic triangle, bounded by those of linear functions on the flat
/// triangle with the same corners (docs/proof.md, section 17.1). Balls round to the precision of the caller.
namespace epsnet::certify {

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

}  // namespace epsnet::certify
