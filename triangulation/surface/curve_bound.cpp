#include "triangulation/surface/curve_bound.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "kernel/lorentz.h"

namespace epsnet {
namespace {

/// Sides and the sinh of distances, up to factors that are put right at the end.
template <class T>
struct Measured {
  explicit Measured(const Tile& tile) {
    for (const Complex<Rational>& z : tile) {
      vertices.push_back(on_hyperboloid(convert<T>(z)));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const LorentzVector<T>& start = vertices[i];
      const LorentzVector<T>& end = vertices[next(i)];
      normals.push_back(lorentz_cross(start, end));
      cosh.push_back(-lorentz_product(start, end));
      farthest = std::max(farthest, start.t);
    }
  }

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }

  /// sinh² of the length of side i.
  [[nodiscard]] T side(std::size_t i) const { return cosh[i] * cosh[i] - 1; }

  /// sinh² of the distance of side j from the line of side i.
  [[nodiscard]] T distance(std::size_t i, std::size_t j) const {
    // The distances of its ends, times sinh of side i. In between their sinh is A cosh t + B sinh t.
    const T start = lorentz_product(normals[i], vertices[j]);
    const T end = lorentz_product(normals[i], vertices[next(j)]);
    const T low = std::min(start, end);
    const T high = std::max(start, end);
    const T least =
        high >= low * cosh[j] ? T(low * low) : T((2 * low * high * cosh[j] - low * low - high * high) / side(j));
    return least / side(i);
  }

  /// sinh² of the distance from the midpoint of side j to side i; corner `far` is the end of j that is not on i,
  /// `other` the end of i that is not on j.
  [[nodiscard]] T from_midpoint(std::size_t i, std::size_t j, std::size_t far, std::size_t other) const {
    if (-lorentz_product(vertices[far], vertices[other]) >= cosh[i] * cosh[j]) {
      return (cosh[j] - 1) / 2;  // The angle is not acute: half of side j.
    }
    const T end = lorentz_product(normals[i], vertices[far]);
    return end * end / (side(i) * (2 * cosh[j] + 2));
  }

  std::vector<LorentzVector<T>> vertices;
  std::vector<LorentzVector<T>> normals;
  std::vector<T> cosh;
  T farthest = 0;  ///< cosh of the largest distance of a vertex from 0.
};

/// sinh² of the bound.
template <class T>
T squared_bound(const Measured<T>& tile) {
  T bound = 1;
  for (std::size_t i = 0; i < tile.size(); ++i) {
    const std::size_t j = tile.next(i);
    bound = std::min({bound, T((tile.cosh[i] - 1) / 2), tile.from_midpoint(i, j, tile.next(j), i),
                      tile.from_midpoint(j, i, i, tile.next(j))});
    for (std::size_t k = 0; k + 1 < i; ++k) {
      if (tile.next(i) != k) {
        bound = std::min(bound, std::max(tile.distance(i, k), tile.distance(k, i)));
      }
    }
  }
  return bound;
}

/// The bound from its sinh².
double bound_from(double square) { return 0.99 * std::asinh(std::sqrt(square)); }

/// The bound, computed in T, if no vertex is farther than `farthest` (cosh of the distance from 0) and the bound is at
/// least `least` (sinh²).
template <class T>
std::optional<double> bound_in(const Tile& tile, double farthest, double least) {
  const Measured<T> measured(tile);
  if (!(measured.farthest <= farthest)) {
    return std::nullopt;
  }
  const auto square = static_cast<double>(squared_bound(measured));
  return square >= least ? std::optional(bound_from(square)) : std::nullopt;
}

}  // namespace

double curve_bound(const Tile& tile) {
  // Where vertices are near and the bound is large, few bits are off by less than a hundredth.
  if (const auto bound = bound_in<double>(tile, 100, 1e-4)) {
    return *bound;
  }
  if (const auto bound = bound_in<Mp256>(tile, 1e10, 1e-20)) {
    return *bound;
  }
  // 300 digits are enough for vertices so near and bounds so large.
  constexpr double kLeast = 1e-90;
  return std::max(kLeast, bound_in<Mp1024>(tile, 1e95, 0).value_or(kLeast));
}

}  // namespace epsnet
