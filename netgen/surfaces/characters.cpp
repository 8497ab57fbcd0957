#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "certify/base/text.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

/// The phases of a file are multiples of 1/n for an n of at most that (docs/format.md).
constexpr long kGreatestDenominator = 1'000'000'000'000'000'000;
constexpr std::size_t kMostCharacters = 40;

/// The graph of the vertices and the pairs of sides of the fundamental polygon. Vertex v is where the sides of relation
/// v are crossed around; side k leads from its vertex to that of its partner.
struct PolygonGraph {
  explicit PolygonGraph(const Surface& surface) : polygon(polygon_sides(surface)), vertex(polygon.side.size()) {
    for (std::uint32_t v = 0; v < polygon.relations.size(); ++v) {
      for (const std::uint32_t k : polygon.relations[v]) vertex[k] = v;
    }
    std::vector<bool> reached(polygon.relations.size());
    std::vector<bool> in_tree(polygon.side.size());
    std::vector<std::uint32_t> found{0};
    reached[0] = true;
    for (std::size_t next = 0; next < found.size(); ++next) {
      for (const std::uint32_t k : polygon.relations[found[next]]) {
        const std::uint32_t back = polygon.partner[k];
        if (reached[vertex[back]]) continue;
        reached[vertex[back]] = in_tree[k] = in_tree[back] = true;
        found.push_back(vertex[back]);
        towards_root.push_back(back);
      }
    }
    for (std::uint32_t k = 0; k < polygon.side.size(); ++k) {
      if (k < polygon.partner[k] && !in_tree[k]) free.push_back(k);
    }
  }

  PolygonSides polygon;
  std::vector<std::uint32_t> vertex;        ///< By side of the polygon.
  std::vector<std::uint32_t> towards_root;  ///< The sides of the tree, each from a vertex to an earlier one.
  std::vector<std::uint32_t> free;          ///< The first sides of the other pairs.
};

/// The number of (−1/2, 1/2] that differs by an integer.
Rational reduced(const Rational& turns) {
  const mpq_class shifted = to_gmp(turns) - mpq_class(1, 2);
  mpz_class whole;
  mpz_cdiv_q(whole.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  return from_gmp(mpq_class(shifted - whole + mpq_class(1, 2)));
}

}  // namespace

std::vector<SideId> character_sides(const Surface& surface) {
  const PolygonGraph graph(surface);
  std::vector<SideId> result;
  for (const std::uint32_t k : graph.free) result.push_back(graph.polygon.side[k]);
  return result;
}

ById<SideId, Rational> phases_of_sides(const Surface& surface, const std::vector<Rational>& turns) {
  const PolygonGraph graph(surface);
  const PolygonSides& polygon = graph.polygon;
  if (turns.size() != graph.free.size()) {
    std::string sides;
    for (const std::uint32_t k : graph.free) sides += (sides.empty() ? "" : ", ") + to_string(polygon.side[k]);
    throw CharacterError(std::to_string(turns.size()) + (turns.size() == 1 ? " phase" : " phases") +
                         " found, expected " + std::to_string(graph.free.size()) + ", those of the sides " + sides);
  }
  std::vector<Rational> of_polygon(polygon.side.size());
  const auto set = [&](std::uint32_t k, const Rational& phase) {
    of_polygon[k] = reduced(phase);
    of_polygon[polygon.partner[k]] = reduced(-phase);
  };
  for (std::size_t i = 0; i < turns.size(); ++i) set(graph.free[i], turns[i]);
  // From the leaves to the root: all other sides around the vertex have their phases.
  for (auto k = graph.towards_root.rbegin(); k != graph.towards_root.rend(); ++k) {
    Rational around = 0;
    for (const std::uint32_t other : polygon.relations[graph.vertex[*k]]) {
      if (other != *k) around += of_polygon[other];
    }
    set(*k, -around);
  }
  mpz_class multiple = 1;
  for (const Rational& phase : of_polygon) {
    const mpz_class denominator = to_gmp(phase).get_den();
    mpz_lcm(multiple.get_mpz_t(), multiple.get_mpz_t(), denominator.get_mpz_t());
    if (multiple > kGreatestDenominator)
      throw CharacterError("the phases are not multiples of 1/n for any n of at most 10^18");
  }
  ById<SideId, Rational> result(surface.side_count());
  for (std::size_t k = 0; k < of_polygon.size(); ++k) result[polygon.side[k]] = of_polygon[k];
  return result;
}

double phase_of_word(const ById<SideId, Rational>& phases, const std::vector<std::uint32_t>& letters) {
  Rational sum = 0;
  for (const std::uint32_t letter : letters) sum += phases[SideId(letter)];
  return static_cast<double>(reduced(sum));
}

std::vector<PhasedStep> phased_steps(const Surface& surface, GraphNodes nodes, const ById<SideId, Rational>& phases) {
  std::vector<PhasedStep> result;
  result.reserve(surface.side_count());
  if (nodes == GraphNodes::faces) {
    for (const SideId side : surface.side_ids()) {
      result.push_back({surface.tile_of_side(side).number(), surface.tile_of_side(surface.partner(side)).number(),
                        reduced(-phases[side])});
    }
    return result;
  }
  // By corner, the phase of the value that is 1 in the first tile with the vertex: around it, each side that is crossed
  // adds its own.
  ById<SideId, std::optional<Rational>> seen(surface.side_count());
  for (const SideId first : surface.side_ids()) {
    Rational turns = 0;
    for (SideId corner = first; !seen[corner]; corner = surface.next_side(surface.partner(corner))) {
      seen[corner] = turns;
      turns += phases[corner];
    }
  }
  for (const SideId side : surface.side_ids()) {
    const SideId next = surface.next_side(side);
    result.push_back(
        {surface.vertex_class(side), surface.vertex_class(next), reduced(Rational(*seen[next] - *seen[side]))});
  }
  return result;
}

Rational parse_turns(std::string_view text) {
  const std::optional<Rational> value = text.size() <= kMostCharacters ? parse_decimal(text) : std::nullopt;
  if (!value) {
    throw CharacterError("expected a phase in turns, a decimal or a fraction such as 0.25 or -1/3, not " +
                         certify::in_quotes(std::string(text)));
  }
  return *value;
}

}  // namespace epsnet
