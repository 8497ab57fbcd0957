#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/net/document.h"
#include "triangulation/surface/error.h"
#include "triangulation/surface/surface.h"

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
/// proved; distances and vertices are rounded. The time is that of the one-vertex Delaunay triangulation, mostly its
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

}  // namespace epsnet
