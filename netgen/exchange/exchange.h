#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "certify/net/document.h"
#include "netgen/base/options.h"
#include "netgen/lifts/lifts.h"
#include "netgen/surfaces/group.h"
#include "triangulation/surface/surface.h"

/// Surfaces and nets in the text formats of other programs (docs/exchange-formats.md): CGAL's, exactly, in and out;
/// meshes, rounded to binary64, out.
namespace epsnet {

/// A text violates its format, or an object cannot be written in a format. what() is one line. For a text it is
/// "NAME:LINE: what was wrong, what was expected", or "NAME: …" if the error has no line.
class ExchangeError : public Error {
 public:
  using Error::Error;
};

/// The exact formats in which surfaces are exchanged.
enum class ExchangeFormat {
  automatic,      ///< Detected from the text: no text fits two formats.
  domain,         ///< A fundamental polygon: side pairings and rational vertices.
  triangulation,  ///< A triangulation by cross-ratios, with no anchor, one, or one per triangle.
};

/// The largest text that is imported, in bytes.
inline constexpr std::size_t kMaxTextBytes = std::size_t{256} << 20;

/// Reads the surface that a text describes, and checks it completely and exactly. Any genus from 2 on.
///
/// A strictly convex polygon becomes the one tile of the surface. Any other simple polygon is cut into triangles; it
/// may have at most 4096 sides. The tiles of a triangulation are its triangles. `name` stands for the text in messages;
/// if the format was detected, an error names it. Throws ExchangeError. Whatever the text claims, memory is linear in
/// its length. Time is linear up to logarithmic factors, except for polygons that are not convex.
[[nodiscard]] Surface import_surface(std::string_view text, std::string_view name,
                                     ExchangeFormat format = ExchangeFormat::automatic);

/// Returns the tiles of a surface as the triangles of a net: exactly this triangulation, with nothing moved, added or
/// flipped. certify::check decides whether it is an ε-net.
///
/// Triangle t is tile t, its dart i side i of the tile; vertices are the surface's vertex classes, in their order. Each
/// vertex is the origin of its own chart, whose exact centre is the corner of a tile, so nothing is rounded. Throws
/// ExchangeError unless all tiles are triangles, and if the words exceed the limits of a net file (docs/format.md). The
/// words have about the sum of the squares of all degrees as their total length; time and memory are proportional to
/// that.
[[nodiscard]] certify::NetDocument net_of_tiles(const Surface& surface, const Length& epsilon);

/// Returns the domain format of a surface of one tile, every coordinate as `p/q`, as CGAL writes it. Throws
/// ExchangeError if there are several tiles, or for a regular polygon, whose vertices are not rational. O(size).
[[nodiscard]] std::string write_domain(const Surface& surface);

/// Writes the tiles of a surface as a triangulation by cross-ratios with one anchor. Tiles with more than three sides
/// are cut by the diagonals from their vertex 0. Throws ExchangeError for a regular polygon, before anything is
/// written.
void write_triangulation(const Surface& surface, std::ostream& out);

/// Writes the triangulation of a net by its exact cross-ratios with one anchor. Nothing is proved; certify does that.
/// Throws ExchangeError if the document is not well-formed, if its surface is a regular polygon, or if two glued sides
/// of triangles differ.
void write_triangulation(const certify::NetDocument& net, std::ostream& out);

// Meshes. Nothing here is proved. All throw NetGeometryError if the document is not a net, take O(n log n) time, and
// write equal bytes for equal documents.

/// Writes OFF: one lift of every triangle of a net to the Poincaré disk, as `epsnet draw` draws them, in the plane z =
/// 0. Throws NetGeometryError.
void write_off(const certify::NetDocument& net, std::ostream& out);

/// Writes VTK's XML format of unstructured grids, as text: the same lifts, with the circumradius and number of every
/// triangle and the number of every vertex and the weight of the metric there. For finite elements the cells also
/// describe the glued surface: each cell has the net vertices of its corners, and its own coordinates
/// (NetGeometry::centred_corners). Throws NetGeometryError.
void write_vtu(const certify::NetDocument& net, std::ostream& out);

/// Writes Gmsh's format MSH 4.1, as text: one lift of every triangle as a planar mesh. The lines on its boundary have
/// the number of their side, from 1 on; `$Periodic` says which sides are glued; nodes have the data `weight`, the
/// factor 4/(1 - |z|²)² of the metric, and `vertex`. Throws NetGeometryError.
void write_gmsh(const certify::NetDocument& net, std::ostream& out);

/// Writes MSH 2.2 of the glued surface: the nodes are the vertices of the net, each once, all at 0, since no places fit
/// all triangles. The geometry is in each element's own coordinates, the data `corners` (NetGeometry::centred_corners,
/// as three points). Throws NetGeometryError.
void write_gmsh_glued(const certify::NetDocument& net, std::ostream& out);

/// Writes Medit's format, for FreeFEM: the same planar mesh as write_gmsh. Edges on its boundary are labelled by side,
/// vertices by the vertex of the net, both from 1 on. Throws NetGeometryError.
void write_medit(const certify::NetDocument& net, std::ostream& out);

/// Writes MFEM's mesh format 1.0: the glued surface, with discontinuous nodes, the corners of one lift of every
/// triangle. Throws NetGeometryError; ExchangeError if an edge is a loop or two edges have the same ends, since MFEM
/// knows edges by their ends.
void write_mfem(const certify::NetDocument& net, std::ostream& out);

/// A number for each vertex of a net.
struct VertexData {
  std::string name;            ///< Letters, digits, spaces.
  std::vector<double> values;  ///< By vertex.
};

/// Like write_vtu, with an additional array of numbers at points. Throws NetGeometryError. Throws std::invalid_argument
/// unless there are as many numbers as vertices.
void write_vtu_with(const VertexData& data, const certify::NetDocument& net, std::ostream& out);

/// Writes tab-separated lines "u v length": the edges of the surface with their hyperbolic lengths, in the order of
/// their first darts. They include loops and parallel edges. Throws NetGeometryError.
void write_edges(const certify::NetDocument& net, std::ostream& out);

/// Writes tab-separated lines "u v left right length": the edges of a surface, each a pair of sides of tiles, in the
/// order of their first sides: the vertices at both ends, the tiles on both sides, the hyperbolic length, rounded.
void write_edges(const Surface& surface, std::ostream& out);

/// Writes the adjacency matrix of the triangles of a net as a symmetric integer MatrixMarket file: how many edges join
/// two nodes. A loop counts twice, so sums of rows are degrees. That of the tiles of a surface is its lattice_matrix
/// (netgen/eigenvalues/eigenvalues.h). Throws NetGeometryError.
void write_adjacency(const certify::NetDocument& net, GraphNodes nodes, std::ostream& out);

/// Writes a JSON object with the lifts, the isometries that glue their sides, and the labels
/// (docs/exchange-formats.md). Throws NetGeometryError.
void write_mesh_json(const certify::NetDocument& net, std::ostream& out);

}  // namespace epsnet
