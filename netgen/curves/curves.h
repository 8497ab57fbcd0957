#pragma once

#include <cstddef>
#include <cstdint>
#include <gmpxx.h>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/curves/document.h"
#include "certify/claims/geodesics/document.h"
#include "netgen/base/options.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/pants/pants.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/surface/surface.h"

/// Closed curves of a surface up to free homotopy: how often they meet, their classes in homology, what fills; mapping
/// classes as products of Dehn twists; lengths of closed geodesics as functions of Fenchel–Nielsen coordinates;
/// surfaces of which the systole is greatest among those near them. docs/curves.md says how and why, and has the
/// conventions.
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

  /// Whether it can be contracted to a point.
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
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::CurvesDocument curves(const Surface& surface, std::span<const Word> words,
                                             const CurvesOptions& options = {});
}  // namespace unproved

// Mapping classes: isotopy classes of homeomorphisms of a surface to itself that preserve the orientation.

/// A power of the Dehn twist along a simple closed curve: who comes to the curve turns left, so often around it.
struct DehnTwist {
  Word curve;
  std::int32_t power = 1;
};

/// A product of Dehn twists; the last one acts first.
using MappingClass = std::vector<DehnTwist>;

/// The mapping class of what a product does, undone.
[[nodiscard]] MappingClass inverse(const MappingClass& f);
/// f ∘ g: g acts first.
[[nodiscard]] MappingClass product(MappingClass f, const MappingClass& g);

/// A text is no product of Dehn twists; what() says where and why.
class MappingClassError : public Error {
 public:
  using Error::Error;
};

/// A simple closed curve with a name.
struct NamedCurve {
  std::string name;
  Word curve;
};

/// The mapping class group of a surface. What mapping classes do is decided by words alone, exactly, but for the search
/// for the places where a curve passes through tiles, with 512 bits (`dehn_twist_words`, pants.h).
class MappingClassGroup {
 public:
  /// That of a surface.
  explicit MappingClassGroup(const Surface& surface);

  /// The topology of curves that its words refer to.
  [[nodiscard]] const CurveTopology& topology() const { return topology_; }

  /// a₁, …, a_g, b₁, …, b_g, c₁, …, c_{g−1}: curves with a_i and b_i those of the homology basis. b_i meets a_i, and
  /// c_i meets b_i and b_{i+1}, once; no two others meet. Twists along them generate the group (W. Lickorish, A finite
  /// set of generators for the homeotopy group of a 2-manifold, 1964); those along a₁, a₂, all b_i and all c_i do so
  /// (S. Humphries, Generators for the mapping class group, 1979).
  [[nodiscard]] const std::vector<NamedCurve>& generators() const { return generators_; }

  /// Reads a product such as "a1 b2^-1 C1 (1 6)^2": a name of `generators`, or in upper case its inverse, or a word
  /// in parentheses, each with an exponent or without. Throws MappingClassError.
  [[nodiscard]] MappingClass parse(std::string_view text) const;

  /// What a mapping class makes of a curve. Throws CurveError (pants.h), with the number of the twist, for one
  /// along a curve that is not simple; LimitError if words become too long, as they may grow exponentially.
  [[nodiscard]] ClosedCurve image(const MappingClass& f, const ClosedCurve& curve) const;

  /// By row and column: the coefficients of the images of the homology basis, as columns. A symplectic matrix. O(g²)
  /// for each twist. Throws CurveError as `image`.
  [[nodiscard]] std::vector<std::vector<mpz_class>> homology(const MappingClass& f) const;

  /// Whether it is isotopic to the identity. Throws as `image`.
  ///
  /// It is if and only if the curves of the chain a₁, b₁, c₁, b₂, c₂, …, b_g are each freely homotopic to their images,
  /// with their directions: these fill the surface, each meets the next one once, and no others meet; so what fixes
  /// them fixes all points where they meet and all segments between, and the rest are disks (B. Farb and D. Margalit, A
  /// Primer on Mapping Class Groups, Proposition 2.8).
  [[nodiscard]] bool is_identity(const MappingClass& f) const;

  /// The least n > 0 for which fⁿ is the identity; nothing if there is none. Throws as `image`.
  ///
  /// A mapping class of finite order has at most order 4g + 2, and its order is that of what it does to homology
  /// (the same book, Theorems 6.8 and 7.5).
  [[nodiscard]] std::optional<std::uint32_t> order(const MappingClass& f) const;

  /// Whether it is the mapping class of an isometry, which preserves the orientation. Throws as `image`.
  [[nodiscard]] bool is_isometry(const MappingClass& f, const SurfaceIsometry& isometry) const;

 private:
  /// Images of the words of sides under a twist.
  using Images = ById<SideId, Word>;
  /// A closed curve up to free homotopy, as a walk of the graph.
  using Walk = std::vector<std::uint32_t>;

  [[nodiscard]] std::vector<Images> images_of(const MappingClass& f) const;
  [[nodiscard]] Walk image(const std::vector<Images>& f, Walk curve) const;

  [[nodiscard]] const RadialGraph& graph() const { return *topology_.graph_; }

  Surface surface_;
  CurveTopology topology_;
  std::vector<NamedCurve> generators_;
  std::vector<Walk> chain_;  ///< a₁, b₁, c₁, b₂, c₂, …, b_g
};

/// Returns the surface with the marking that a mapping class makes: there is an isometry to the given surface that
/// takes the path of a word to its image under f. It is `dehn_twisted` (pants.h) for each twist, the first one first;
/// its tiles are triangles. The identity leaves the surface as it is. Throws as dehn_twisted.
[[nodiscard]] Surface with_marking(const Surface& surface, const MappingClass& f);

// Lengths and their derivatives.

/// Fenchel–Nielsen coordinates of which intervals are known: first the lengths of all cuffs, then the twists.
struct EnclosedCoordinates {
  PantsGraph graph;
  std::vector<certify::Interval> values;
};

/// The coordinates of pants of which fenchel_nielsen_surface made the surface. Throws SurfaceError for other ones.
[[nodiscard]] EnclosedCoordinates enclosed_coordinates(const PantsDecomposition& pants);

/// The length of a closed geodesic, and its derivatives.
struct LengthDerivatives {
  certify::Interval length{};
  std::vector<certify::Interval> gradient;             ///< By coordinate.
  std::vector<std::vector<certify::Interval>> second;  ///< By two coordinates; empty unless asked for.
};

/// Encloses the derivatives of the length of a closed path's geodesic, at all coordinates in these intervals. The word
/// is one of a surface that fenchel_nielsen_surface made of such coordinates: numbers of the sides of its heptagons.
///
/// Throws LimitError if intervals are too wide, or the geodesic too long. O(letters · n) for n coordinates that are
/// known exactly, and O(letters · n²) for intervals or with second derivatives.
[[nodiscard]] LengthDerivatives length_derivatives(const EnclosedCoordinates& coordinates, const Word& word,
                                                   bool second = false);

/// The same on any surface, for the coordinates of `pants`, a pants decomposition of it. If fenchel_nielsen_surface did
/// not make it, heptagons with about these coordinates stand beside it, and which of their paths is the given one is
/// found with 512 bits, not proved. Derivatives with respect to a length are those for a fixed twist, which is taken
/// from −½ to less than ½ of the length: another marking has others. `threads`: 0 is as many as the machine has cores.
///
/// Throws as above, SurfaceError if the path is not closed, or null-homotopic, LimitError also if the path is not found
/// again, and as fenchel_nielsen_surface and pants_decomposition. Time is that of the pants of the heptagons.
[[nodiscard]] LengthDerivatives length_derivatives(const Surface& surface, const PantsDecomposition& pants,
                                                   const Word& word, bool second = false, unsigned threads = 0);

// Local maxima of the systole: the climb to one, that one is near, and that an exact surface is one.

// The climb.

/// Options of the search for a local maximum.
struct MaximizeOptions {
  std::uint32_t steps = 200;  ///< At most so many surfaces.
  unsigned threads = 0;       ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};     ///< Called occasionally, if given.
};

/// That there is a local maximum of the systole near a surface. Distances are the greatest differences of its
/// coordinates, lengths and twists; twists are real numbers here.
struct NearMaximum {
  double distance = 0;  ///< There is one that is nearer than that.
  double slope = 0;     ///< Near the surface the systole is less by at least so much for each unit of distance, but for
                        ///< terms of second order.
};

/// A surface at which the systole seems to be greatest among those near it.
struct SystoleMaximum {
  Surface surface;                  ///< In heptagons, one for each pair of pants.
  EnclosedCoordinates coordinates;  ///< Of the surface.
  certify::Interval systole{};      ///< Proved by both checkers.
  std::vector<Word> systoles;       ///< The closed geodesics that are longer by at most 10⁻⁹.
  /// What balls prove; nothing if they do not.
  std::optional<NearMaximum> proof;
  std::uint32_t steps = 0;  ///< How many surfaces were looked at.
};

/// Climbs from a surface in its Fenchel–Nielsen coordinates: each time a linear programme says how all short closed
/// geodesics get longer together. Deterministic.
///
/// Throws as pants_decomposition and fenchel_nielsen_surface, and NetError if a step fails. Time is that of a spectrum
/// a little beyond the systole, for each of some 20 to 100 steps.
[[nodiscard]] SystoleMaximum maximize_systole(const Surface& start, const MaximizeOptions& options = {});

/// Proves that a local maximum is near a surface, by closed geodesics that are about as long as its systole, of which
/// the lower end of `systole` is a bound. Nothing if it does not follow.
[[nodiscard]] std::optional<NearMaximum> near_maximum(const EnclosedCoordinates& coordinates,
                                                      const certify::Interval& systole, std::span<const Word> systoles);

// Exact surfaces.

/// It is not proved that the systole has a local maximum; what() says what fails. It may have one all the same.
class NotMaximalError : public NetError {
 public:
  using NetError::NetError;
};

/// Returns all closed geodesics that are hardly longer than the systole, those first that are as long as it, and what
/// proves that the systole is greater than that of any other surface near this one: the gradients of the lengths of the
/// shortest ones span, and with some positive weights their sum is 0.
///
/// Throws as `systole`, and NotMaximalError if this is not so, or the shortest ones are not known to be of exactly
/// equal length: coordinates that are rounded do not do. Time: a spectrum up to the systole, and the pairs of shortest
/// geodesics.
[[nodiscard]] Certified<certify::GeodesicsDocument> local_maximum(const Surface& surface,
                                                                  const GeodesicsOptions& options = {});

namespace unproved {
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::GeodesicsDocument local_maximum(const Surface& surface, const GeodesicsOptions& options = {});
}  // namespace unproved

// Gradients of lengths: whether 0 is inside of their hull. The first two are computed in binary64, and prove nothing.

/// Numbers λ > 0 with the sum 1 and Σ λ_i g_i = 0, about, of which the least one is as great as possible. Nothing if
/// that is not positive or hardly so. A linear programme.
[[nodiscard]] std::optional<std::vector<double>> balance(std::span<const std::vector<certify::Interval>> gradients);

/// Those gradients that are a basis of what all span, as far as binary64 tells. O(n d²).
[[nodiscard]] std::vector<std::size_t> independent(std::span<const std::vector<certify::Interval>> gradients);

/// A number m > 0 such that for every u some gradient g has g·u ≤ −m·max |u_j|: to first order the least of functions
/// with these gradients falls so fast in all directions. Nothing if none is found, as where 0 is not inside of the hull
/// of the gradients. Each gradient is one of an interval for each coordinate. O(n d² + d³) but for linear programmes.
[[nodiscard]] std::optional<double> slope_of_least(std::span<const std::vector<certify::Interval>> gradients);

}  // namespace epsnet
