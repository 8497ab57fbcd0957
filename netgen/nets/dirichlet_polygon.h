#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/document/document.h"
#include "triangulation/error.h"
#include "triangulation/triangulation.h"

namespace epsnet {

/// The Dirichlet domain of a base point as a combinatorial object: dual to the Delaunay triangulation with the base
/// point as its one vertex (thesis I.3.3). That triangulation is proved: certify::check says VERIFIED.
struct DirichletPolygon {
  /// Side k, counterclockwise, lies on the bisector of the base point 0 and its image γ0; γ is the isometry of a word
  /// (docs/format.md: side numbers of the surface), from the coordinates of the base point's tile to themselves.
  struct Side {
    Word word;
    std::uint32_t partner;  ///< The side that γ⁻¹ takes this one to: that of γ⁻¹.
    double distance;        ///< Of the base point from the line of the side: half the displacement of 0 by γ.
  };
  std::vector<Side> sides;
  /// Vertex k is the start of side k, in the disk with the base point at 0, directions as in its tile, rounded.
  std::vector<Complex<double>> vertices;
  /// How many edges of the triangulation are exact ties: sides of length 0, which are left out.
  std::uint32_t ties = 0;
  /// The triangulation itself as a net of one vertex; ε is larger than all circumradii, so that it is one.
  certify::NetDocument triangulation;
};

/// The Dirichlet domain of a point of a surface; without one, of the surface's first vertex (the centre, if it is
/// regular). Proved: the words, the partners, and which sides there are; distances and vertices are rounded. The time
/// is that of the one-vertex Delaunay triangulation, mostly its labels: milliseconds for genus 2, tenths of a second
/// for genus 20. Throws SurfaceError (a base point not inside of its tile), LimitError, NetError, also if the
/// triangulation is not verified.
[[nodiscard]] DirichletPolygon dirichlet_polygon(const Surface& surface, const std::optional<BasePoint>& base);

/// As JSON (docs/format.md, "Dirichlet domain").
[[nodiscard]] std::string dirichlet_json(const DirichletPolygon& polygon);

/// A text that is not what dirichlet_json writes; what() is "NAME: what was wrong, what was expected".
class DirichletFileError : public Error {
 public:
  using Error::Error;
};

/// Reads what dirichlet_json writes; the triangulation, which is not in it, is empty. `name` stands for the file in
/// messages. Throws DirichletFileError.
[[nodiscard]] DirichletPolygon parse_dirichlet_json(std::string_view text, const std::string& name);

}  // namespace epsnet
