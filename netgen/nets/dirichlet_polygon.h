#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/net/document.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

/// Dirichlet domains: exact as combinatorial objects, and as numbers.
namespace epsnet {

/// The Dirichlet domain of a base point as a combinatorial object: the dual of the Delaunay triangulation whose one
/// vertex is the base point (thesis I.3.3). That triangulation is proved: certify::check says VERIFIED.
struct DirichletPolygon {
  /// Side k, counterclockwise, lies on the bisector of the base point 0 and its image γ0; γ is the isometry of a word
  /// (docs/format.md: side numbers of the surface), from the coordinates of the base point's tile to themselves.
  struct Side {
    Word word;
    std::uint32_t partner;  ///< The image of this side under γ⁻¹, which is the side of γ⁻¹.
    double distance;        ///< From the base point to the line of the side: half the displacement of 0 by γ.
  };
  std::vector<Side> sides;
  /// Vertex k is the start of side k, in the disk with the base point at 0, directions as in its tile, rounded.
  std::vector<Complex<double>> vertices;
  /// The number of edges that are exact ties. They are dual to sides of length 0, which `sides` leaves out.
  std::uint32_t ties = 0;
  /// The triangulation itself as a net of one vertex. Its ε is larger than all circumradii.
  certify::NetDocument triangulation;
};

/// Returns the Dirichlet domain of a base point, which may be anywhere in the disk of its tile. The default is the
/// surface's first vertex, or the centre of a regular surface. The set of sides, their words and their partners are
/// exact; distances and vertices are rounded. The time is that of the one-vertex Delaunay triangulation, mostly its
/// labels: milliseconds for genus 2, tenths of a second for genus 20. Throws SurfaceError if the base point is no point
/// of the surface. Throws LimitError. Throws NetError, for example if the triangulation is not verified.
[[nodiscard]] DirichletPolygon dirichlet_polygon(const Surface& surface, const std::optional<BasePoint>& base);

/// Returns the polygon as JSON (docs/format.md, "Dirichlet domain").
[[nodiscard]] std::string dirichlet_json(const DirichletPolygon& polygon);

/// A text is not in the format of dirichlet_json. what() is "NAME: what was wrong, what was expected".
class DirichletFileError : public Error {
 public:
  using Error::Error;
};

/// Reads the format of dirichlet_json. The result's triangulation is empty, as the format does not contain it. `name`
/// stands for the file in messages. Throws DirichletFileError.
[[nodiscard]] DirichletPolygon parse_dirichlet_json(std::string_view text, const std::string& name);

// A domain as numbers of 1024 bits, in the Poincaré disk with the base point at 0. Nothing of this is proved.

/// Returns the isometry of a word, from the coordinates of the tile where the path starts to those of the tile where it
/// ends. Requires: the word is a path.
[[nodiscard]] Isometry<Mp1024> isometry_of(const Surface& surface, const Word& word);

/// Returns a point near one that is given by 1024 bits, in the tile that contains it, with coordinates that are
/// multiples of 2⁻¹⁰⁰. Throws SurfaceError if it is more than 100,000 tiles away.
[[nodiscard]] BasePoint rounded_point(const Surface& surface, TileId tile, const Complex<Mp1024>& z);

/// The domain, with its side pairings.
class DomainFrame {
 public:
  /// Requires: `polygon` is a Dirichlet domain of the surface, with its triangulation.
  DomainFrame(const Surface& surface, const DirichletPolygon& polygon);

  /// The tile of the base point.
  [[nodiscard]] TileId tile() const { return tile_; }
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

  /// Returns the sides k₁, k₂, … by which side_towards leads from the domain to the one that contains a point: then
  /// … γ_{k₂}⁻¹ γ_{k₁}⁻¹ takes the point into the domain. Nullopt if they are more than 10,000.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> walk(Complex<Mp1024> z) const;

 private:
  TileId tile_;
  Isometry<Mp1024> from_tile_;
  std::vector<Isometry<Mp1024>> pairings_;
  std::vector<Complex<Mp1024>> vertices_;
  std::vector<std::uint32_t> partners_;
};

/// Returns the points of the surface that are farthest from the base point of a domain, rounded as rounded_point does.
[[nodiscard]] std::vector<BasePoint> farthest_points(const Surface& surface, const DirichletPolygon& polygon);

}  // namespace epsnet
