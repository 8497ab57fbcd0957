#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <gmpxx.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/net/document.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

namespace epsnet::certify {
struct SurfaceSides;
}

/// A net document as points and isometries, its triangles laid out in the Poincaré disk, and where points are in it.
namespace epsnet {

// Corners and labels as numbers, for pictures and summaries. Nothing here is proved.

/// The document is not a net, or its numbers are too large for pictures and summaries. what() is one line.
class NetGeometryError : public Error {
 public:
  using Error::Error;
};

/// The order in which triangles are lifted (thesis IV.5).
enum class DrawOrder {
  weight,  ///< Next the triangle across the edge uv of least |u|² + |v|²: looks like the Dirichlet domain (figure
           ///< IV.9).
  breadth_first,  ///< By the number of edges crossed: the combinatorial Dirichlet domain (figure IV.10, bottom).
};

/// Returns the surface with rational tiles: others with vertices rounded to 256 bits. For pictures only.
[[nodiscard]] certify::SurfaceDocument with_rounded_tiles(const certify::SurfaceDocument& surface);

/// Returns the first dart d with opposite(d) = d or opposite(opposite(d)) ≠ d; nullopt if there is none. Requires:
/// indices are in range (certify::malformation). O(triangles).
[[nodiscard]] std::optional<std::uint32_t> unpaired_dart(const certify::NetDocument& document);

/// The factors of labels, rounded to the bits of T (Mp256, Mp1024, Mp4096). Isometries have determinant 1. Their
/// entries are as large as e^(d/2) for points at distance d from the origin, and lose about four times the logarithm of
/// that in accuracy.
template <class T>
struct Parts {
  std::vector<Isometry<T>> crossings;  ///< By side number: from the coordinates of its tile to those of its partner's.
  std::vector<Isometry<T>> frames;     ///< By chart: from its coordinates to those of its tile.

  /// Evaluates the factors.
  Parts(const certify::NetDocument& document, const certify::SurfaceSides& sides);
};

/// Returns log2(|a| + |b|), which is about half the displacement of 0, in bits; infinity instead of NaN. Requires: |a|²
/// − |b|² = 1.
template <class T>
[[nodiscard]] double size_in_bits(const Isometry<T>& f);

/// An isometry to at least 120 bits, enough for products of many of them, and rounded to binary64.
struct PreciseIsometry {
  Isometry<Mp256> precise;
  Isometry<double> rounded;

  PreciseIsometry() = default;
  /// Rounds an isometry.
  explicit PreciseIsometry(const Isometry<Mp256>& f) : precise(f), rounded(convert<double>(f)) {}
};

/// The corners, labels and crossings of a net document as numbers. Refers to the document, which must outlive it.
class NetGeometry {
 public:
  /// Evaluates all labels. Throws NetGeometryError if the structure of the document is broken
  /// (certify::malformation), if `opposite` is not a fixed-point-free involution, or if a label needs more than
  /// 4096 bits. O(triangles + letters of all words).
  explicit NetGeometry(const certify::NetDocument& document);
  explicit NetGeometry(const certify::NetDocument&&) = delete;  // A temporary would not outlive the object.

  /// The document as given.
  [[nodiscard]] const certify::NetDocument& document() const { return *document_; }

  /// Returns the label with this number (certify::corner_label; 0 is the identity), from the chart of the vertex to the
  /// chart of the triangle. Its determinant is 1.
  [[nodiscard]] const PreciseIsometry& label(std::uint32_t number) const {
    assert(number < labels_.size());
    return labels_[number];
  }
  /// Returns the three corners of a triangle, counterclockwise, in the chart of its vertex 0.
  [[nodiscard]] std::array<Complex<double>, 3> corners(std::uint32_t triangle) const;

  /// Returns the corners in coordinates for finite elements: moved by an isometry that takes the circumcentre to 0 and
  /// corner 0 to the positive real axis. The corners then lie on a Euclidean circle around 0. The Euclidean angle α
  /// opposite to an edge of length a satisfies sin α = sinh(a/2)/sinh R, where R is the circumradius. In a net a ≥ ε ≥
  /// R, so sin α ≥ 1/(2 cosh(ε/2)). If there is no circumcircle, the isometry takes corner 0 to 0.
  [[nodiscard]] std::array<Complex<double>, 3> centred_corners(std::uint32_t triangle) const;

  /// Returns the hyperbolic circumradius of a triangle; infinity if its corners lie on no circle.
  [[nodiscard]] double circumradius(std::uint32_t triangle) const;

  /// Returns the hyperbolic length of the edge of a dart. Dart 3t + i runs from corner i of triangle t to the next
  /// corner.
  [[nodiscard]] double edge_length(std::uint32_t dart) const;

  /// The sides of the tiles (certify/net/numbering.h).
  [[nodiscard]] const certify::SurfaceSides& sides() const { return *sides_; }
  /// Returns the genus of the surface, from V − E + F = 2 − 2g for its tiles; 0 if that gives no genus.
  [[nodiscard]] std::uint32_t genus() const { return genus_; }
  /// ε, exactly.
  [[nodiscard]] const mpq_class& epsilon() const { return epsilon_; }
  /// Returns ε for display: as the document writes it if that is short, else rounded to binary64.
  [[nodiscard]] std::string epsilon_text() const;

 private:
  const certify::NetDocument* document_;
  std::vector<PreciseIsometry> labels_;
  std::shared_ptr<const certify::SurfaceSides> sides_;
  std::uint32_t genus_;
  mpq_class epsilon_;
};

// Lifts of the triangles to the Poincaré disk.

/// One lift to the Poincaré disk of every triangle of a net. Their union is connected, with one vertex at the centre.
struct Lifts {
  /// A triangle in the disk.
  struct LiftedTriangle {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> placement;  ///< By corner: index in `placements`.
    std::array<Complex<double>, 3> corner;
  };
  std::vector<LiftedTriangle> lifted;       ///< In the order of lifting.
  std::vector<std::uint32_t> place;         ///< By triangle: its index in `lifted`.
  std::vector<PreciseIsometry> placements;  ///< From the chart of a corner's vertex to the disk.
};

/// Lifts all triangles. The directions at the centre are those of the centre's chart, so drawings of different nets of
/// one surface match if they start with the same vertex. Each lift is as accurate as its labels: products along the way
/// are taken with 256 bits and rounded once. Throws NetGeometryError if the triangles are not connected, if a corner is
/// not in the disk, or if there is no such vertex. O(n log n) by weight, else O(n).
[[nodiscard]] Lifts lift_triangles(const NetGeometry& geometry, DrawOrder order, std::uint32_t centre = 0);

/// Returns for each dart whether it is on the boundary of the drawing. An edge has one lift in the drawing if its two
/// triangles are neighbours there, and otherwise two, both on the boundary.
[[nodiscard]] std::vector<bool> boundary_darts(const NetGeometry& geometry, const Lifts& lifts);

/// A lift of one triangle, to 256 bits.
struct Placement {
  std::uint32_t triangle;
  Isometry<Mp256> isometry;  ///< From the chart of its corner 0 to the disk.
};

/// Returns the translation, from the chart of a vertex to the disk, that takes the vertex to 0. Throws NetGeometryError
/// if there is no such vertex.
[[nodiscard]] Isometry<Mp256> to_centre(const NetGeometry& geometry, std::uint32_t vertex);

/// Returns a lift of a triangle at a vertex; `frame` takes the chart of the vertex to the disk. Throws NetGeometryError
/// if the vertex is not a corner of any triangle. O(triangles).
[[nodiscard]] Placement placement_at(const NetGeometry& geometry, std::uint32_t vertex, const Isometry<Mp256>& frame);

/// Returns the lifted triangle across the side from corner `side` to the next corner.
[[nodiscard]] Placement neighbour(const NetGeometry& geometry, const Placement& placement, std::uint32_t side);

// Location of points in the triangles.

/// A triangle that contains a point, and the position of the point in it.
struct PointLocation {
  /// Inside the triangle, on a side, or at a corner. A point on a side lies in several triangles.
  enum class Place { inside, side, corner };
  Place place;
  std::uint32_t triangle;
  /// The number of the side (from this corner to the next one) or of the corner; 0 if the point is inside.
  std::uint32_t number;
  /// The lift of the triangle that contains the point, as a path from the tile of the point to the tile of the
  /// triangle's chart.
  Word word;
  /// By corner: the weights of point_of_triangle, scaled to the sum 1; rounded.
  std::array<double, 3> weights;
  /// By corner: its hyperbolic distance from the point, within the triangle; rounded. If a triangle is obtuse, a vertex
  /// of another triangle may be nearer.
  std::array<double, 3> distances;

  /// Returns the nearest corner.
  [[nodiscard]] std::uint32_t nearest_corner() const;
};

/// Locates points in a net. Construct it once for many points.
class Locator {
 public:
  /// Evaluates all labels. Throws the exceptions of triangulation_of.
  explicit Locator(const certify::NetDocument& net);
  /// Moves; what was moved from can be assigned to and destroyed.
  Locator(Locator&&) noexcept;
  /// Moves likewise.
  Locator& operator=(Locator&&) noexcept;
  /// Frees what was evaluated.
  ~Locator();

  /// Returns a triangle that contains a point, which may be anywhere in the disk of its tile. Proved signs, in binary64
  /// and up to 4096 bits, decide the triangle and the position; a sign that is still unknown counts as "on a side". The
  /// search is a straight walk from a triangle near the point's tile, which ends in every triangulation. Throws
  /// SurfaceError if it is no point of the surface, LimitError if it is too far from all triangles.
  [[nodiscard]] PointLocation locate(const BasePoint& point);

 private:
  class Triangles;
  std::unique_ptr<Triangles> triangles_;
};

}  // namespace epsnet
