#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/curves/document.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// Closed curves of a surface up to free homotopy: how often they meet, their classes in homology, what fills; angles
/// of their geodesics, and derivatives of their lengths. docs/curves.md says how and why.
namespace epsnet {

class RadialGraph;

/// A closed curve up to free homotopy, with a direction.
struct ClosedCurve {
  /// Of the primitive curve of which it is a power: a list that depends on the free homotopy class alone
  /// (docs/curves.md). Two curves are freely homotopic if these lists and their powers are equal. Empty for a
  /// null-homotopic one.
  std::vector<std::uint32_t> root;
  std::uint32_t power = 1;                         ///< The greatest k for which it is a k-th power.
  std::uint64_t self_intersections = 0;            ///< The least number of double points in general position.
  std::vector<std::int64_t> homology;              ///< By curve of the homology basis: a coefficient of its class.
  std::optional<std::uint32_t> genus_on_the_left;  ///< If it is simple and separates the surface.

  [[nodiscard]] bool is_null_homotopic() const { return root.empty(); }
  /// Whether a simple curve is freely homotopic to it.
  [[nodiscard]] bool is_simple() const { return self_intersections == 0; }
  /// Whether it is simple, not null-homotopic, and cuts the surface into two pieces.
  [[nodiscard]] bool is_separating() const { return genus_on_the_left.has_value(); }
};

/// How often two closed curves meet.
struct IntersectionNumbers {
  std::uint64_t geometric = 0;  ///< The least number of points where curves of their classes in general position meet.
  std::int64_t algebraic = 0;   ///< The second one counts 1 where it crosses the first from its right to its left.
};

/// A point where the closed geodesics of two curves cross.
struct GeodesicCrossing {
  /// From the direction of the first one counterclockwise to that of the second one, in radians: positive where the
  /// second one crosses from right to left. Contains the angle.
  certify::Interval angle{};
};

/// What words alone decide of closed curves: nothing depends on the metric, and nothing is rounded, but for `crossings`
/// and `twist_derivative`.
///
/// Functions throw SurfaceError for words that are not paths from a tile to itself.
class CurveTopology {
 public:
  /// O(sides + g³) for genus g.
  explicit CurveTopology(const Surface& surface);

  /// Closed paths from tile 0, a₁, b₁, a₂, b₂, …, whose classes are a symplectic basis of H₁(S; ℤ): b_i crosses a_i
  /// once from right to left, and all other algebraic numbers are 0.
  [[nodiscard]] const std::vector<Word>& homology_basis() const { return basis_; }

  /// O(n²) for a word of n letters.
  [[nodiscard]] ClosedCurve curve(const Word& word) const;
  /// A path from tile 0 to itself that is freely homotopic to a curve; shorter than the given one, as a rule.
  [[nodiscard]] Word word(const ClosedCurve& curve) const;
  /// 1 if two curves go along one closed geodesic in one direction, −1 in opposite directions, and 0 otherwise.
  [[nodiscard]] int same_geodesic(const ClosedCurve& first, const ClosedCurve& second) const;

  /// O(nm) for words of n and m letters.
  [[nodiscard]] IntersectionNumbers intersections(const ClosedCurve& first, const ClosedCurve& second) const;

  /// Where the closed geodesics cross that two curves are powers of; for one geodesic, where it crosses itself, each
  /// point once. Angles have some 50 bits. Throws LimitError if words are too long for that.
  [[nodiscard]] std::vector<GeodesicCrossing> crossings(const ClosedCurve& first, const ClosedCurve& second) const;

  /// The derivative of the length of a curve's geodesic with respect to a twist along a simple one, as the other side
  /// is moved to the left by a length (`twisted`, pants.h): −Σ cos θ over the crossings, θ the angle from the direction
  /// of the simple one to the direction in which the line of the curve leads from its right to its left (S. Wolpert,
  /// The Fenchel–Nielsen deformation, Ann. of Math. 115, 1982). Contains it.
  [[nodiscard]] certify::Interval twist_derivative(const ClosedCurve& curve, const ClosedCurve& along) const;

  /// Whether all components of the complement of the geodesics are disks. O(n²) for words of n letters together.
  [[nodiscard]] bool fill(std::span<const ClosedCurve> curves) const;

 private:
  friend class MappingClassGroup;

  std::shared_ptr<const RadialGraph> graph_;
  std::vector<Word> basis_;
  std::vector<std::vector<std::int64_t>> coordinates_;  ///< By basis curve of the graph: in the homology basis.
};

/// Options of `curves`.
struct CurvesOptions {
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called occasionally, if given.
};

/// Returns what is known of a list of closed curves, none of them null-homotopic, with a proof: the curves of the
/// document are the given ones and, after them, the homology basis. If `fill` says that the given ones fill, that is
/// claimed.
///
/// Throws CurveError (pants.h) for a null-homotopic curve or a word that is not a path from a tile to itself, and
/// NotCertifiedError if the proof fails. O(n²) for n curves and letters.
[[nodiscard]] Certified<certify::CurvesDocument> curves(const Surface& surface, std::span<const Word> words,
                                                        const CurvesOptions& options = {});

namespace unproved {
[[nodiscard]] certify::CurvesDocument curves(const Surface& surface, std::span<const Word> words,
                                             const CurvesOptions& options = {});
}  // namespace unproved

}  // namespace epsnet
