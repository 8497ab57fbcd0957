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
#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "triangulation/surface/error.h"

namespace epsnet::certify {
struct SurfaceSides;
}

/// A net document as points and isometries, for pictures and summaries. Nothing here is proved.
namespace epsnet {

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

/// Returns the surface with tiles that are listed: regular ones with vertices rounded to 256 bits. For pictures only.
[[nodiscard]] certify::SurfaceDocument with_rounded_tiles(const certify::SurfaceDocument& surface);

/// Returns the first dart d with opposite(d) = d or opposite(opposite(d)) ≠ d; nullopt if there is none. Requires:
/// indices are in range (certify::structure_problem). O(triangles).
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
  /// (certify::structure_problem), if `opposite` is not a fixed-point-free involution, or if a label needs more than
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

  /// The sides of the tiles (certify/net/surface_sides.h).
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

}  // namespace epsnet
