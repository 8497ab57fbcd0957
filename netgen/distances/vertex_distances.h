#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/document.h"
#include "netgen/base/progress.h"

/// Distances between the vertices of a net, one to many and many to many. docs/distances.md, "One to many", says how.
namespace epsnet {

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

}  // namespace epsnet
