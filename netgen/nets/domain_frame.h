#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "netgen/nets/dirichlet_polygon.h"

/// A Dirichlet domain as numbers of 1024 bits, in the Poincaré disk with the base point at 0. Nothing here is proved.
namespace epsnet {

/// Returns the isometry of a word, from the coordinates of the tile where the path starts to those of the tile where it
/// ends. Requires: the word is a path.
[[nodiscard]] Isometry<Mp1024> isometry_of(const Surface& surface, const Word& word);

/// Returns a point near one that is given by 1024 bits, in the tile that contains it, with coordinates that are
/// multiples of 2⁻¹⁰⁰. Throws SurfaceError if it is more than 100,000 tiles away.
[[nodiscard]] BasePoint rounded_point(const Surface& surface, std::uint32_t tile, const Complex<Mp1024>& z);

/// The domain, with its side pairings.
class DomainFrame {
 public:
  /// Requires: `polygon` is a Dirichlet domain of the surface, with its triangulation.
  DomainFrame(const Surface& surface, const DirichletPolygon& polygon);

  /// The tile of the base point.
  [[nodiscard]] std::uint32_t tile() const { return tile_; }
  /// From the coordinates of that tile to the disk with the base point at 0; turned as the polygon's vertices are.
  [[nodiscard]] const Isometry<Mp1024>& from_tile() const { return from_tile_; }
  /// By side: its γ. Beyond the side lies the image of the domain under γ.
  [[nodiscard]] const std::vector<Isometry<Mp1024>>& pairings() const { return pairings_; }
  /// By side: the vertex of the domain where the side starts.
  [[nodiscard]] const std::vector<Complex<Mp1024>>& vertices() const { return vertices_; }

  /// Returns the vertices that are farthest from the base point, one for each point of the surface: these are the
  /// points of the surface that are farthest from it. Distances that agree to 300 bits count as equal.
  [[nodiscard]] std::vector<std::uint32_t> farthest_vertices() const;

  /// Returns the side whose line separates a point from the domain, the one whose γ0 is nearest to the point; nullopt
  /// if the point is in the domain.
  [[nodiscard]] std::optional<std::uint32_t> side_towards(const Complex<Mp1024>& z) const;

 private:
  std::uint32_t tile_;
  Isometry<Mp1024> from_tile_;
  std::vector<Isometry<Mp1024>> pairings_;
  std::vector<Complex<Mp1024>> vertices_;
  std::vector<std::uint32_t> partners_;
};

/// Returns the points of the surface that are farthest from the base point of a domain, rounded as rounded_point does.
[[nodiscard]] std::vector<BasePoint> farthest_points(const Surface& surface, const DirichletPolygon& polygon);

}  // namespace epsnet
