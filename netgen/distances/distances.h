#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/bound/document.h"
#include "certify/claims/distance/document.h"
#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// Distances in a surface: between two points, with all shortest geodesics; the diameter, the radius, the largest
/// embedded disk; tables of distances between the vertices of a net. docs/distances.md says how and why.
namespace epsnet {

// Two points.

struct DirichletPolygon;

/// Options of a distance.
struct DistanceOptions {
  /// The largest width of the enclosure (hyperbolic length). The enclosure is as narrow as binary64 numbers allow; it
  /// is an error if it is wider than this.
  double width = 1e-12;
};

/// Returns a vertex of a net of this surface as a point of the tile in which it lies, exactly. Throws NetError if there
/// is no such vertex. Unless the surface `is_rational`, it has the coordinates of the tile of its
/// chart, and may be beyond a side of that tile.
[[nodiscard]] BasePoint point_of_vertex(const Surface& surface, const certify::NetDocument& net, std::uint32_t vertex);

/// Returns the point of a triangle of a net with these weights. Lift the triangle; the point lies on the ray of the
/// weighted sum of the Lorentz vectors (x, y, t) of its corners, on the hyperboloid x² + y² − t² = −1. (1, 1, 1) is the
/// centroid, (1, 1, 0) the midpoint of side 0. Coordinates in the tile of the triangle's chart are rounded to multiples
/// of 2⁻¹⁰⁰, except that a single positive weight gives that vertex exactly. Throws NetError for the reasons of
/// point_of_vertex, and if a weight is negative or all are 0.
[[nodiscard]] BasePoint point_of_triangle(const Surface& surface, const certify::NetDocument& net,
                                          std::uint32_t triangle, const std::array<Rational, 3>& weights);

/// Returns the distance of p and q, and all geodesics between them of length up to the upper end of the enclosure, as
/// paths from p to q. The points may be anywhere in the disks of their tiles. If they are the same point of the surface
/// (is_same_point), the distance is 0, and `point` is p.
///
/// Deterministic. The time is that of the Dirichlet domain of p and of the proof, however far away q is and however
/// short closed geodesics are. Throws SurfaceError for what is no point of the surface. Throws NetError if the
/// enclosure is wider than `options.width`, or if it has more than 5000 paths, as across a cuff shorter than 10⁻¹⁰;
/// NotCertifiedError, which is one, if the proof fails. Throws LimitError.
[[nodiscard]] Certified<certify::DistanceDocument> distance(const Surface& surface, const BasePoint& p,
                                                            const BasePoint& q, const DistanceOptions& options = {});

/// The same; the Dirichlet domain of p is at hand.
[[nodiscard]] Certified<certify::DistanceDocument> distance(const Surface& surface, const BasePoint& p,
                                                            const DirichletPolygon& domain_of_p, const BasePoint& q,
                                                            const DistanceOptions& options = {});

// The diameter of a surface, its radius, and its largest embedded disk. All functions are deterministic. They throw
// NetError if the limit of cells is too low; NotCertifiedError, which is one, if the proof fails; and LimitError if the
// surface is beyond the numbers of the generator.

/// The least allowed width.
inline constexpr double kLeastBoundWidth = 1e-12;

/// Options of an enclosure of a function's extremum over a surface.
struct BoundOptions {
  double width = 1e-6;                 ///< The largest width of the enclosure; at least kLeastBoundWidth.
  std::uint64_t most_cells = 200'000;  ///< The most cells made.
  unsigned threads = 0;                ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};              ///< Called occasionally, if given.
};

/// Returns the one-vertex Delaunay triangulation as a net; its ε is larger than its largest circumradius. The largest
/// circumradius is the eccentricity of the vertex: the greatest distance of a point from it (docs/proof.md, Lemma 5.2).
/// The vertex may be anywhere in the disk of its tile. Throws SurfaceError if it is no point of the surface.
[[nodiscard]] Certified<certify::NetDocument> eccentricity_net(const Surface& surface, const BasePoint& vertex);

/// Encloses the diameter: the greatest distance of two points. Branch and bound over the positions of one of them, in
/// a domain of the surface's isometries if these are found (docs/distances.md gives the number of cells). Throws
/// std::invalid_argument for a width below kLeastBoundWidth.
[[nodiscard]] Certified<certify::BoundDocument> diameter(const Surface& surface, const BoundOptions& options = {});

/// Encloses the radius: the least eccentricity, which is the least r such that a disk of radius r covers the surface.
/// Throws std::invalid_argument for a width below kLeastBoundWidth.
[[nodiscard]] Certified<certify::BoundDocument> radius(const Surface& surface, const BoundOptions& options = {});

/// Encloses the radius of the largest embedded disk: the greatest injectivity radius of a point. Throws
/// std::invalid_argument for a width below kLeastBoundWidth.
[[nodiscard]] Certified<certify::BoundDocument> largest_embedded_disk(const Surface& surface,
                                                                      const BoundOptions& options = {});

namespace unproved {

/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::DistanceDocument distance(const Surface& surface, const BasePoint& p, const BasePoint& q,
                                                 const DistanceOptions& options = {});
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::DistanceDocument distance(const Surface& surface, const BasePoint& p,
                                                 const DirichletPolygon& domain_of_p, const BasePoint& q,
                                                 const DistanceOptions& options = {});
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::NetDocument eccentricity_net(const Surface& surface, const BasePoint& vertex);
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::BoundDocument diameter(const Surface& surface, const BoundOptions& options = {});
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::BoundDocument radius(const Surface& surface, const BoundOptions& options = {});
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::BoundDocument largest_embedded_disk(const Surface& surface, const BoundOptions& options = {});

}  // namespace unproved

// The vertices of a net, one to many and many to many (docs/distances.md, "One to many").

/// How a table of distances is computed.
struct DistanceTableOptions {
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The table is the same for any number.
  Progress progress = {};  ///< Called occasionally, from the calling thread, if given.
};

/// Distances from some vertices of a net to others, in hyperbolic length.
struct DistanceTable {
  std::vector<std::uint32_t> from;  ///< The vertex of each row.
  std::vector<std::uint32_t> to;    ///< The vertex of each column.
  /// Row by row: intervals that contain the distances. The distance of a vertex from itself is [0, 0].
  std::vector<certify::Interval> enclosures;

  /// Returns the interval that contains the distance of `from[row]` and `to[column]`.
  [[nodiscard]] const certify::Interval& enclosure(std::size_t row, std::size_t column) const {
    return enclosures[row * to.size() + column];
  }
  /// Returns the middle of that interval.
  [[nodiscard]] double distance(std::size_t row, std::size_t column) const {
    const certify::Interval& x = enclosure(row, column);
    return x.lower + (x.upper - x.lower) / 2;
  }
  /// Returns a bound for the errors of all `distance`s: the greatest difference between one and an end of its interval.
  [[nodiscard]] double error() const;
};

/// Returns the memory that a table takes, in bytes.
[[nodiscard]] constexpr double distance_table_bytes(std::size_t rows, std::size_t columns) {
  return static_cast<double>(rows) * static_cast<double>(columns) * sizeof(certify::Interval);
}

/// Returns the distances between vertices of a net, each to within about 10⁻¹³, whatever its size.
///
/// The intervals hold if the triangles of the net triangulate its surface, which certify::check proves (its rules
/// surface, map, gluing and orientation). The net need not be Delaunay or an ε-net. The table has no certificate;
/// `distance` makes one for a single pair.
///
/// One search of the lifted triangles around each row's vertex, O(t log t) for the t lifts that it meets, somewhat more
/// than the number of triangles. Deterministic: the same for any number of threads. Throws NetGeometryError if the
/// document is not a net or there is no such vertex, SurfaceError if it has no surface, LimitError if closed geodesics
/// may be shorter than 10⁻⁷⁰, or where a search meets more than 50 lifts of each triangle.
[[nodiscard]] DistanceTable vertex_distances(const certify::NetDocument& net, const std::vector<std::uint32_t>& from,
                                             const std::vector<std::uint32_t>& to,
                                             const DistanceTableOptions& options = {});

/// Like vertex_distances, to all vertices in their order.
[[nodiscard]] DistanceTable distances_from(const certify::NetDocument& net, const std::vector<std::uint32_t>& from,
                                           const DistanceTableOptions& options = {});

/// Returns the distances of all vertices from one, in their order, rounded: the middles of their intervals. Throws as
/// vertex_distances.
[[nodiscard]] std::vector<double> rounded_distances_from(const certify::NetDocument& net, std::uint32_t vertex);

/// Returns the distances from vertex 0 by which a page colours a net; none unless the net is verified. Throws
/// LimitError for a net of more than 100,000 vertices, where a page would take seconds longer, and as vertex_distances.
[[nodiscard]] std::vector<double> distances_for_page(const certify::NetDocument& net,
                                                     const std::optional<certify::Certificate>& certificate);

/// Which part of a table is written.
enum class TableEntries {
  distances,  ///< The middles of the intervals.
  bounds,     ///< The ends of the intervals.
};

/// Writes NumPy's format .npy, version 1.0: an array of little-endian binary64 numbers of the shape (rows, columns), or
/// (rows, columns, 2) for bounds.
void write_npy(const DistanceTable& table, TableEntries entries, std::ostream& out);

/// Writes comma-separated values (RFC 4180), row by row, with the columns from, to, distance, or from, to, lower,
/// upper. Reals have enough digits to read back the same.
void write_csv(const DistanceTable& table, TableEntries entries, std::ostream& out);

// What elements of the group do with points. Nothing here is proved: numbers have 1024 bits, and are rounded once.

/// A geodesic loop at a point, up to its direction.
struct PointLoop {
  Word word;      ///< A closed path from the tile of the point that is homotopic to it.
  double length;  ///< Rounded to nearest.
};

/// Returns the geodesic loops at a point that are at most this long, the shortest first. Throws SurfaceError if the
/// point is not strictly inside its tile, LimitError for more than 200,000. O(loops · sides of the Dirichlet domain).
[[nodiscard]] std::vector<PointLoop> loops_at(const Surface& surface, const BasePoint& point, double up_to);

/// Returns the end of the geodesic of some length that leaves a point in a direction, the angle with the x-axis in the
/// disk of its tile, with coordinates that are multiples of 2⁻¹⁰⁰, in the tile where it ends. Requires: the length is
/// from 0 to 300. Throws SurfaceError if that is more than 100,000 tiles away.
[[nodiscard]] BasePoint point_along(const Surface& surface, const BasePoint& from, double direction, double length);

/// Returns the points that an isometry f other than the identity leaves where they are, which preserves the orientation
/// and is given by a lift with f∘γ∘f⁻¹ = γ′ for the elements γ of `words` and γ′ of `images`, paths from tile 0 to
/// itself; the elements γ have two axes at least. Coordinates are multiples of 2⁻¹⁰⁰. Throws LimitError if that takes
/// more than 200,000 elements.
[[nodiscard]] std::vector<BasePoint> fixed_points(const Surface& surface, const std::vector<Word>& words,
                                                  const std::vector<Word>& images);

}  // namespace epsnet
