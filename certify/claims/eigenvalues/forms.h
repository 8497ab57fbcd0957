#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/line_bundle.h"
#include "certify/net/document.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/isometry.h"

/// The energy and the mass of functions on a hyperbolic triangle, bounded by those of linear functions on the flat
/// triangle with the same corners (docs/proof.md, section 17.1). Balls round to the precision of the caller.
namespace epsnet::certify {

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

}  // namespace epsnet::certify
