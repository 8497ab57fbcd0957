#pragma once

#include <array>
#include <cstdint>
#include <gmpxx.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/document/document.h"
#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "netgen/lifts/layout.h"

namespace epsnet::certify {
struct SurfaceSides;
}

/// A net document as points and isometries, for pictures and summaries. Nothing here is proved.
namespace epsnet {

/// The tile of a regular surface with its vertices rounded to 256 bits, and its gluing, as if it were a rational one:
/// for pictures.
[[nodiscard]] certify::SurfaceDocument rounded_polygon(std::uint32_t regular_genus);

/// The first dart whose opposite is itself or does not lead back; nothing if `opposite` is an involution without fixed
/// points. Requires indices in range (certify::structure_problem). O(triangles).
[[nodiscard]] std::optional<std::uint32_t> unpaired_dart(const certify::NetDocument& document);

/// What labels are made of, rounded to the bits of T (Mp256, Mp1024, Mp4096). Isometries have determinant 1. Their
/// entries are as large as e^(d/2) for points at distance d from the origin, and lose about four times the logarithm of
/// that in accuracy.
template <class T>
struct Parts {
  std::vector<Isometry<T>> crossings;  ///< By side number: from the coordinates of its tile to those of its partner's.
  std::vector<Isometry<T>> frames;     ///< By chart: from its coordinates to those of its tile.

  /// Evaluates them.
  Parts(const certify::NetDocument& document, const certify::SurfaceSides& sides);
};

/// log2 of |a| + |b| for |a|² − |b|² = 1: half the displacement of 0, in bits, and a little more. Infinite if it is not
/// a number.
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

/// The corners, labels and crossings of a net document in numbers. Refers to the document, which must outlive it.
class NetGeometry {
 public:
  /// Evaluates all labels. Throws NetGeometryError if the structure of the document is broken
  /// (certify::structure_problem), if `opposite` is not a fixed-point-free involution, or if a label needs more than
  /// 4096 bits. O(triangles + letters of all words).
  explicit NetGeometry(const certify::NetDocument& document);
  explicit NetGeometry(const certify::NetDocument&&) = delete;  // It would be gone.

  /// The document as given.
  [[nodiscard]] const certify::NetDocument& document() const { return *document_; }

  /// The label with this number (certify::corner_label; 0 is the identity), from the chart of its vertex to the chart
  /// of its triangle. Determinant 1.
  [[nodiscard]] const PreciseIsometry& label(std::uint32_t number) const { return labels_[number]; }
  /// The three corners of a triangle, counterclockwise, in the chart of its vertex 0.
  [[nodiscard]] std::array<Complex<double>, 3> corners(std::uint32_t triangle) const;

  /// The same, moved by an isometry that takes the circumcentre to 0 and corner 0 to the positive real axis: the
  /// corners are on a Euclidean circle around 0, too, and opposite to an edge of length a is the Euclidean angle α with
  /// sin α = sinh(a/2)/sinh R, R the circumradius. In a net a ≥ ε ≥ R, so that sin α ≥ 1/(2 cosh(ε/2)): coordinates for
  /// finite elements. Where there is no circumcircle, corner 0 is taken to 0.
  [[nodiscard]] std::array<Complex<double>, 3> centred_corners(std::uint32_t triangle) const;

  /// The hyperbolic circumradius of a triangle; infinity if its corners lie on no circle.
  [[nodiscard]] double circumradius(std::uint32_t triangle) const;

  /// The hyperbolic length of the edge that a dart (3t + i: from corner i of triangle t to the next one) runs along.
  [[nodiscard]] double edge_length(std::uint32_t dart) const;

  /// The sides of the tiles (certify/document/surface_sides.h).
  [[nodiscard]] const certify::SurfaceSides& sides() const { return *sides_; }
  /// Of the surface, from V − E + F = 2 − 2g for its tiles; 0 if that gives no genus.
  [[nodiscard]] std::uint32_t genus() const { return genus_; }
  /// ε, exactly.
  [[nodiscard]] const mpq_class& epsilon() const { return epsilon_; }
  /// ε for people: as the document writes it if that is short, else rounded to binary64.
  [[nodiscard]] std::string epsilon_text() const;

 private:
  const certify::NetDocument* document_;
  std::vector<PreciseIsometry> labels_;
  std::shared_ptr<const certify::SurfaceSides> sides_;
  std::uint32_t genus_;
  mpq_class epsilon_;
};

}  // namespace epsnet
