#pragma once

#include <cstdint>
#include <gmpxx.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "netgen/curves/closed_curves.h"
#include "netgen/isometries/isometries.h"
#include "triangulation/surface/surface.h"

/// Mapping classes: isotopy classes of homeomorphisms of a surface to itself that preserve the orientation, as products
/// of Dehn twists. docs/curves.md has the conventions.
namespace epsnet {

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
  explicit MappingClassGroup(const Surface& surface);

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

}  // namespace epsnet
