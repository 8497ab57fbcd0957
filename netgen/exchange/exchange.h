#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "certify/document/document.h"
#include "netgen/base/length.h"
#include "netgen/lifts/layout.h"
#include "triangulation/error.h"
#include "triangulation/surface.h"

/// Surfaces and nets in the text formats of other programs (docs/exchange-formats.md): CGAL's, exactly, in and out;
/// meshes, rounded to binary64, out.
namespace epsnet {

/// A text is not what its format says, or something cannot be written in a format. what() is one line: of a text
/// "NAME:LINE: what was wrong, what was expected", NAME alone where no line is to blame.
class ExchangeError : public Error {
 public:
  using Error::Error;
};

/// The exact formats in which surfaces are exchanged.
enum class ExchangeFormat {
  automatic,      ///< Whichever the text is: no text is of two formats.
  domain,         ///< A fundamental polygon: side pairings and rational vertices.
  triangulation,  ///< A triangulation by cross-ratios, with an anchor, none, or one of each triangle.
};

/// The largest text that is imported, in bytes.
inline constexpr std::size_t kMaxTextBytes = std::size_t{256} << 20;

/// The surface that a text describes, checked completely and exactly; any genus from 2 on.
///
/// A strictly convex polygon becomes the one tile of the surface, any other simple polygon is cut into triangles; the
/// tiles of a triangulation are its triangles. `name` stands for the text in messages; an error after a guess says what
/// was guessed. Throws ExchangeError. Whatever the text claims, memory is linear in its length; so is time, up to
/// logarithmic factors, but for polygons that are not convex, which may have at most 4096 sides.
[[nodiscard]] Surface import_surface(std::string_view text, std::string_view name,
                                     ExchangeFormat format = ExchangeFormat::automatic);

/// The same for a file, read once, so that it may be a pipe. Throws certify::FileError if it cannot be read.
[[nodiscard]] Surface import_surface_file(const std::filesystem::path& path,
                                          ExchangeFormat format = ExchangeFormat::automatic);

/// The tiles of a surface as the triangles of a net: exactly this triangulation, with nothing moved, added or flipped.
/// Whether it is an ε-net is for certify::check to say.
///
/// Triangle t is tile t, its dart i side i of the tile; vertices are the surface's vertex classes, in their order. Each
/// is the origin of a chart of its own, whose exact centre is the corner of a tile, so that nothing is rounded.
/// Throws ExchangeError unless all tiles are triangles, and if words grow beyond what a net file may hold
/// (docs/format.md): about the sum of the squares of all degrees. Time and memory are proportional to that.
[[nodiscard]] certify::NetDocument net_of_tiles(const Surface& surface, const Length& epsilon);

/// The domain format of a surface of one tile, every coordinate as `p/q`, as CGAL writes it. Throws ExchangeError if
/// there are several tiles, or if it is a regular polygon, whose vertices are not rational. O(size).
[[nodiscard]] std::string write_domain(const Surface& surface);

/// The tiles of a surface as a triangulation by cross-ratios with one anchor; those with more than three sides are cut
/// by the diagonals from their vertex 0. Throws ExchangeError for a regular polygon, before anything is written.
void write_triangulation(const Surface& surface, std::ostream& out);

/// The triangulation of a net by its exact cross-ratios with one anchor. Nothing is proved (certify does that), but
/// nothing is written that is not a map of triangles that fit: throws ExchangeError if the document is not well-formed,
/// if its surface is a regular polygon, or if the sides of two triangles differ where they are glued.
void write_triangulation(const certify::NetDocument& net, std::ostream& out);

// Meshes. Nothing here is proved. All throw NetGeometryError if the document is not a net, take O(n log n) time, and
// write equal bytes for equal documents.

/// OFF: one lift of every triangle of a net to the Poincaré disk, as `epsnet draw` draws them, in the plane z = 0.
/// Throws NetGeometryError.
void write_off(const certify::NetDocument& net, std::ostream& out);

/// VTK's XML format of unstructured grids, as text: the same lifts, with the circumradius and the number of every
/// triangle and the number of every vertex. For finite elements the cells also have the glued surface: the vertices of
/// the net that their corners are, and coordinates of their own (NetGeometry::centred_corners). Throws
/// NetGeometryError.
void write_vtu(const certify::NetDocument& net, std::ostream& out);

/// Gmsh's format MSH 2.2, as text: the glued surface for finite elements. Its nodes are the vertices of the net, each
/// once, placed where a lift of it is drawn; what counts are the coordinates that each element has of its own, the data
/// `corners` (NetGeometry::centred_corners, as three points). Throws NetGeometryError.
void write_gmsh(const certify::NetDocument& net, std::ostream& out);

/// A number for each vertex of a net.
struct VertexData {
  std::string name;            ///< Letters, digits, spaces.
  std::vector<double> values;  ///< By vertex.
};

/// The same as write_vtu with one more array of numbers at points. Throws NetGeometryError, std::invalid_argument
/// unless there are as many numbers as vertices.
void write_vtu_with(const VertexData& data, const certify::NetDocument& net, std::ostream& out);

/// Tab-separated lines "u v length": the edges of the surface with their hyperbolic lengths, in the order of their
/// first darts. Loops and parallel edges are there, too. Throws NetGeometryError.
void write_edges(const certify::NetDocument& net, std::ostream& out);

/// A JSON object with the lifts, the isometries that glue their sides, and the labels (docs/exchange-formats.md).
/// Throws NetGeometryError.
void write_mesh_json(const certify::NetDocument& net, std::ostream& out);

}  // namespace epsnet
