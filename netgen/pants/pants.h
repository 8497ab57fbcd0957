#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/base/interval.h"
#include "netgen/base/progress.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/surface/error.h"
#include "triangulation/surface/surface.h"

/// Pants decompositions of any surface, and its Fenchel–Nielsen coordinates, proved. docs/fenchel-nielsen.md says how
/// and why.
namespace epsnet {

/// A curve is none from which pants can be cut: not closed, trivial, a power of another one, not simple, or not
/// disjoint from the others. what() says which, and begins with the curve's number.
class CurveError : public Error {
 public:
  /// For curve `number`, counted from 0.
  CurveError(std::size_t number, const std::string& problem)
      : Error("curve " + std::to_string(number) + ": " + problem), number_(number), problem_(problem) {}
  /// The number of the curve.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// The problem, without the number.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  std::size_t number_;
  std::string problem_;
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
/// of FenchelNielsen. What is here is proved.
struct PantsDecomposition {
  /// A cuff of the decomposition, an edge of the graph.
  struct Cuff {
    Word curve;                  ///< A closed path in its class, with the pants of the edge's first end on the left.
    certify::Interval length{};  ///< Encloses the length.
    certify::Interval twist{};   ///< Encloses the twist, modulo the length: the number nearest to 0.
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

/// Throws CurveError, if closed paths are not simple closed geodesics, disjoint and different, none of them a power.
void require_disjoint_curves(const Surface& surface, std::span<const Word> curves);

/// Returns the edges of a pants graph as PantsGraph::parse reads them.
[[nodiscard]] std::string graph_text(const PantsGraph& graph);

}  // namespace epsnet
