#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "certify/exact/interval.h"
#include "certify/exact/net_structure.h"

/// The triangles of a net, halved, with flat ones in their place (docs/proof.md, section 17.1).
namespace epsnet::exact {

/// On the hyperboloid, counterclockwise.
using Corners = std::array<Vector, 3>;

/// By dart of the halved triangles: the number of its side, of the vertex where it starts, and the opposite dart.
struct HalvedNet {
  std::vector<Index> side;
  std::vector<Index> start;
  std::vector<Index> opposite;
};

/// The dart from a corner to the next midpoint, the first one of a triangle (corner, midpoint, midpoint before).
[[nodiscard]] inline Index first_half(Index dart) { return 12 * (dart / 3) + 3 * (dart % 3); }
/// From a midpoint to the corner where the dart ends.
[[nodiscard]] inline Index second_half(Index dart) { return first_half(next(dart)) + 2; }

/// The rule `map` is verified.
[[nodiscard]] HalvedNet halved(const NetStructure& net, Index halvings);

/// How many there are, whatever the net is.
struct HalvedSize {
  std::size_t triangles;
  std::size_t sides;
  std::size_t vertices;
};
[[nodiscard]] HalvedSize halved_size(const Net& net, Index halvings);

/// Calls visit(t, corners) for all triangles that halvings make of this one, t their numbers.
template <class Visit>
void each_halved(std::size_t t, const Corners& corners, Index halvings, const Visit& visit) {
  if (halvings == 0) {
    visit(t, corners);
    return;
  }
  Corners middle;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) middle[i][k] = corners[i][k] + corners[(i + 1) % 3][k];
    const Interval& z = middle[i][2];
    const Interval size = sqrt(square(z) - square(middle[i][0]) - square(middle[i][1]));
    for (Interval& x : middle[i]) x = x / size;
  }
  for (std::size_t i = 0; i < 3; ++i)
    each_halved(4 * t + i, {corners[i], middle[i], middle[(i + 2) % 3]}, halvings - 1, visit);
  each_halved(4 * t + 3, middle, halvings - 1, visit);
}

/// Quadratic forms on the functions that are linear on a triangle.
struct LocalForms {
  using Matrix = std::array<std::array<Interval, 3>, 3>;
  Matrix energy;
  Matrix mass;
};

/// The flat triangle with the same corners.
class FlatTriangle {
 public:
  /// Throws TooLarge unless there is certainly a circumscribed circle.
  explicit FlatTriangle(const Corners& corners);

  /// Of |∇f| on T, f linear on the flat triangle with these values in the corners, a bound (Lemma 37.10).
  [[nodiscard]] Interval slope(const std::array<Interval, 3>& values) const;
  /// 0.1893² l² C(1 + R) of Lemma 33.
  [[nodiscard]] Interval interpolation() const;
  /// Of 𝒜 and 𝒩, by the values in the midpoints of the sides opposite to corners 0, 1, 2.
  [[nodiscard]] LocalForms lower_forms() const;
  /// Of 𝒜₁ and 𝒩₁, Lemma 35, by the values in corners 0, 1, 2.
  [[nodiscard]] LocalForms upper_forms() const;

 private:
  /// Of a basis: 180/|T| times ∫ x_i x_j f f′ for f = f′ of the corners k and i, and f ≠ f′ without k and with k.
  struct Moments {
    long own;
    long other;
    long without;
    long with;
  };
  /// (i, j): Σ_k l_k² ∫ x_i x_j f f′.
  [[nodiscard]] LocalForms::Matrix omega(const Moments& moments) const;
  /// The matrix of ∫ ∇x_i·∇x_j times a number.
  [[nodiscard]] LocalForms::Matrix gradients(const Interval& factor) const;

  std::array<Interval, 3> squares_;     ///< l_k²
  std::array<Interval, 3> cotangents_;  ///< Of the angles.
  Interval area_;
  Interval radius_;       ///< R
  Interval cosh_;         ///< C
  Interval mean_square_;  ///< X
  Interval spread_;       ///< Λ
};

}  // namespace epsnet::exact
