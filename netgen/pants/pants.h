#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/pants/document.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/surface/surface.h"

/// Pants decompositions of any surface, and its Fenchel–Nielsen coordinates, proved; Dehn twists and the flow of
/// twists. docs/fenchel-nielsen.md says how, and has the conventions; docs/proof.md, section 19, is the proof.
namespace epsnet {

/// A curve is not closed, or null-homotopic; or pants cannot be cut from it: it is a power of another one, not simple,
/// or not disjoint from the others. what() says which, and begins with the curve's number.
class CurveError : public Error {
 public:
  /// For curve `number`, counted from 0.
  CurveError(std::size_t number, const std::string& problem)
      : Error(certify::ErrorParts{.place = "curve " + std::to_string(number), .problem = problem}), number_(number) {}
  /// The number of the curve.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::size_t number_;
};

/// Options of a pants decomposition.
struct PantsOptions {
  /// Closed paths. The closed geodesics in their free homotopy classes become cuffs. Further ones are chosen.
  std::vector<Word> curves = {};
  /// Without curves: whether to take the pants of which fenchel_nielsen_surface made the surface, if it did.
  bool own = true;
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called occasionally, if given.
};

/// A pants decomposition of a surface along closed geodesics, and its Fenchel–Nielsen coordinates with the conventions
/// of FenchelNielsen. What is here is proved: it is also in the `document`, a pants file with a net of the surface,
/// which has the `certificate`.
struct PantsDecomposition : Certified<certify::PantsDocument> {
  /// A cuff of the decomposition, an edge of the graph.
  struct Cuff {
    Word curve;                  ///< A closed path in its class, with the pants of the edge's first end on the left.
    certify::Interval length{};  ///< Encloses the length.
    certify::Interval twist{};   ///< Encloses the twist, modulo the length: the number nearest to 0, without a marking.
    /// e^{length/2}, if it is rational: the length exactly.
    std::optional<Rational> exact_root;
    Word across;  ///< A path across it, from the tile of the first end's pants to that of the second end's.
  };
  PantsGraph graph;
  std::vector<Cuff> cuffs;  ///< By edge; without given curves or the surface's own, the shortest first.
  /// By pair of pants: closed paths α₀, α₁, α₂ from one tile, freely homotopic to the cuffs 0, 1, 2, with the pants on
  /// their left; α₀α₁α₂ is null-homotopic.
  std::vector<std::array<Word, 3>> pants;
  bool own = false;  ///< Whether they are the pants of which fenchel_nielsen_surface made the surface.

  /// Returns the coordinates: the middle of each interval.
  [[nodiscard]] FenchelNielsen coordinates() const;
};

/// Returns a pants decomposition of a surface: along given curves, which others complete; or else along its own cuffs,
/// if fenchel_nielsen_surface made it; or else along short closed geodesics: each time the shortest that is simple and
/// disjoint from those before, as long as they can be found in a spectrum, and then what shortest arcs between them
/// bound.
///
/// Throws CurveError for curves from which pants cannot be cut; NetError or LimitError if no decomposition is found or
/// proved, as for curves beyond the numbers of the generator. Time is that of the spectrum, about e^L for the longest
/// cuff, and about the area of the surface for each cuff.
[[nodiscard]] PantsDecomposition pants_decomposition(const Surface& surface, const PantsOptions& options = {});

/// Returns the pants decomposition of a surface that the words of a pants file give, which may be about another surface
/// of tiles that are glued alike: another metric on one marked surface. Twists are then real numbers, not reduced
/// modulo the lengths: the paths across the cuffs say which. Of two surfaces of which one is the other after n Dehn
/// twists along a cuff (`dehn_twisted`), the twists there differ by n times its length.
///
/// Throws SurfaceError if the file is not verified, or the tiles are others; and as pants_decomposition.
[[nodiscard]] PantsDecomposition marked_pants(const Surface& surface, const certify::PantsDocument& marking,
                                              const PantsOptions& options = {});

/// Throws CurveError, if closed paths are not simple closed geodesics, disjoint and different, none of them a power.
void require_disjoint_curves(const Surface& surface, std::span<const Word> curves);

/// Returns the edges of a pants graph as PantsGraph::parse reads them.
[[nodiscard]] std::string graph_text(const PantsGraph& graph);

// Dehn twists: a surface with another marking, and the flow of twists.

/// The greatest power of a Dehn twist.
inline constexpr std::int32_t kMostTwists = 1000;

/// Returns by side s a path with the ends of the path that crosses s: what the Dehn twist along a simple closed curve
/// makes of it. That of a path is the product of those of its letters. A path that meets the curve turns left, as often
/// around it as `power` says; right, if it is negative. Throws CurveError for a curve that is not simple, LimitError
/// for a power beyond kMostTwists.
[[nodiscard]] ById<SideId, Word> dehn_twist_words(const Surface& surface, const Word& curve, std::int32_t power = 1);

/// Returns the surface with another marking. Its tiles are triangles: those into which the diagonals from corner 0 cut
/// the tiles, in this order, glued alike, but each is as long and thin as the Dehn twist makes it, and vertices are
/// moved so that no triangle turns over. There is an isometry f to the given surface that takes the path across a side
/// to its image under the twist: words stand for other elements, and the surface is the same.
///
/// Exact: over the field of the surface, if it is over one. Throws CurveError as above, SurfaceError if its tiles are
/// regular, and LimitError if no such triangles are found.
[[nodiscard]] Surface dehn_twisted(const Surface& surface, const Word& curve, std::int32_t power = 1);

/// Returns the surface after a twist by a length along a simple closed curve: cut along its geodesic and glued anew,
/// the other side moved to the left by `by`, as seen from either side. It is one of fenchel_nielsen_surface, with its
/// rounding. Throws as pants_decomposition and fenchel_nielsen_surface.
[[nodiscard]] Surface twisted(const Surface& surface, const Word& curve, const Rational& by,
                              const PantsOptions& options = {});

}  // namespace epsnet
