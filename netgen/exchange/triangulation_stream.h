#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string_view>
#include <vector>

#include "certify/net/document.h"
#include "netgen/exchange/exchange.h"
#include "triangulation/surface/surface.h"

/// CGAL's text formats for geometric triangulations of closed hyperbolic surfaces: a combinatorial map, the exact
/// cross-ratio of every edge, and a lift of one triangle, of all, or of none (docs/exchange-formats.md).
namespace epsnet {

/// The contents of the text, member by member.
struct TriangulationStream {
  /// A triangle, as its three darts counterclockwise.
  using Triangle = std::array<std::uint32_t, 3>;

  /// Two darts glued to each other, in opposite directions.
  struct Edge {
    std::uint32_t dart;
    std::uint32_t opposite;
    /// [z0, z1, z2, z3] (`cross_ratio` in kernel/plane.h) with z0 and z2 the ends of the edge, z1 the third vertex of
    /// the triangle on its right, z3 that on its left. The same for both directions of the edge.
    Complex<Rational> cross_ratio;
    bool operator==(const Edge&) const = default;
  };

  /// Where a triangle lies in the Poincaré disk: without it a triangulation is known up to Möbius maps of the complex
  /// plane only, and not as points of a disk.
  struct Anchor {
    std::uint32_t dart;
    std::array<Complex<Rational>, 3> points;  ///< The start and the end of the dart, the third vertex.
    bool operator==(const Anchor&) const = default;
  };

  /// None; one; or one for each triangle, in their order, each in a disk of its own.
  std::vector<Anchor> anchors;
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  bool operator==(const TriangulationStream&) const = default;
};

/// Whether the text is a triangulation and not a polygon in the domain format, by its first eleven tokens. No text is
/// both: the second token of a triangulation is `yes` or `no`, or there is a fraction among the six coordinates of the
/// first triangle's anchor (points of the open disk, not all 0), where a polygon with enough sides has indices.
[[nodiscard]] bool is_triangulation_stream(std::string_view text);

/// Reads the text and checks its combinatorics: every dart belongs to one triangle and to one edge. `name` stands for
/// the text in messages. Throws ExchangeError. Memory is linear in the length of the text, whatever numbers it
/// contains.
[[nodiscard]] TriangulationStream read_triangulation_stream(std::string_view text, std::string_view name);

/// Returns the surface of a triangulation: tile t is triangle t in coordinates of its own, and its side i is dart i of
/// the triangle. The tile of an anchor has the coordinates of the anchor; if the stream has no anchor, one is found
/// (anchor_search.h).
///
/// Everything is checked exactly: triangles are counterclockwise and in the disk, cross-ratios are as given, and the
/// angles around every vertex add up to 2π (see `Surface`). Requires: the combinatorics that read_triangulation_stream
/// checks. Throws ExchangeError, also if there is no anchor and none is found, if a coordinate has more than 10^6
/// digits, or if all together have more than a thousand times as many digits as the stream.
[[nodiscard]] Surface develop(const TriangulationStream& stream, std::string_view name);

/// Returns the tiles of a surface as a triangulation; tiles with more than three sides are cut by the diagonals from
/// their vertex 0. Dart 3t + i is side i of triangle t; triangle 0 is the anchor.
[[nodiscard]] TriangulationStream triangulation_stream(const Surface& surface);

/// Returns the exact triangulation of a net: the coordinates of its vertices are dyadic numbers, its charts and labels
/// are rational. Dart 3t + i is dart i of triangle t; triangle 0 is the anchor.
///
/// Nothing is proved (certify does that), but the result is a map of triangles that fit: throws ExchangeError if the
/// document is not well-formed or if two glued sides differ in length.
[[nodiscard]] TriangulationStream triangulation_stream(const certify::NetDocument& net);

/// Writes the text: each number as `p/q` or `p` in lowest terms, each triangle as CGAL writes it: a dart, the previous
/// one, the next one. With an anchor for each triangle it is the format of CGAL's Delaunay class.
void write_triangulation_stream(const TriangulationStream& stream, std::ostream& out);

}  // namespace epsnet
