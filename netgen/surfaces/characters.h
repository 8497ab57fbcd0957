#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "kernel/numbers.h"
#include "triangulation/surface/surface.h"

/// Characters of a surface: homomorphisms χ of its group to the unit circle, given by phases.
///
/// Phases are in turns: θ stands for e^{2πiθ}, and θ + 1 for the same. A function on the plane with f(γz) = χ(γ) f(z)
/// is a function f_t in the coordinates of each tile t with f_{t'}(c_s z) = e^{2πiθ_s} f_t(z), where c_s is the
/// crossing of side s from tile t to tile t', and θ_s the phase of the side. The sides that are glued to each other
/// have opposite phases, and those that are crossed around a vertex of the surface have the sum 0, up to integers.
namespace epsnet {

/// Numbers that are no character of a surface; what() says why.
class CharacterError : public Error {
 public:
  using Error::Error;
};

/// Returns the 2g sides of which the phases determine a character, and may be any numbers: of each pair of sides of
/// fundamental_polygon the first one, in their order, without the pairs of a spanning tree of the graph whose vertices
/// are those of the polygon on the surface and whose edges are the pairs. The tree is that of a breadth-first search.
/// If all corners of the polygon are one vertex, no pair is left out. O(sides).
[[nodiscard]] std::vector<SideId> character_sides(const Surface& surface);

/// Returns the phases of all sides, in (−1/2, 1/2], from those of character_sides, in turns. Sides inside of the
/// fundamental polygon have phase 0. Throws CharacterError if there are not 2g, or if there is no n ≤ 10¹⁸ of which all
/// are multiples of 1/n: files have no such phases. O(sides).
[[nodiscard]] ById<SideId, Rational> phases_of_sides(const Surface& surface, const std::vector<Rational>& turns);

/// Returns the phase of a word, the sum of those of its sides: in (−1/2, 1/2], exact before it is rounded. Requires:
/// the sides are there.
[[nodiscard]] double phase_of_word(const ById<SideId, Rational>& phases, const std::vector<std::uint32_t>& letters);

/// The nodes of a graph on a surface.
enum class GraphNodes {
  vertices,  ///< Joined by edges.
  faces,     ///< Tiles or triangles, joined where they have an edge in common.
};

/// A step along an edge of a graph on a surface: f at its end, in the coordinates of the node `from`, is e^{2πi·turns}
/// times f in those of the node `to`.
struct PhasedStep {
  std::uint32_t from;
  std::uint32_t to;
  Rational turns;  ///< In (−1/2, 1/2].
};

/// Returns the steps along all edges in both directions, by side of a tile: those of tiles across the side; those of
/// vertices along it, from its start to its end. The coordinates of a tile are its own, those of a vertex are those of
/// the first tile that has it. `phases` are those of phases_of_sides. O(sides).
[[nodiscard]] std::vector<PhasedStep> phased_steps(const Surface& surface, GraphNodes nodes,
                                                   const ById<SideId, Rational>& phases);

/// Reads a number of turns, a decimal or a fraction of at most 40 characters: "0.25", "-1/3". Throws CharacterError for
/// any other text.
[[nodiscard]] Rational parse_turns(std::string_view text);

}  // namespace epsnet
