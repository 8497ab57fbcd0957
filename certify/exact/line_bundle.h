#pragma once

#include <gmpxx.h>
#include <map>
#include <vector>

#include "certify/exact/flat_triangles.h"
#include "certify/exact/inertia.h"
#include "certify/exact/net_structure.h"

namespace epsnet::exact {

/// The sides whose numbers must add up to one of the group: those of a pair, or those that are crossed around a corner.
/// Calls visit(sides, name) for each of these sets.
template <class Visit>
void each_relation(const NetStructure& net, const Visit& visit) {
  for (Index s = 0; s < net.sides(); ++s)
    visit(std::vector<Index>{s, net.partner(s)}, net.side_name(s) + " and its partner");
  std::vector<bool> seen(net.sides());
  for (Index first = 0; first < net.sides(); ++first) {
    if (seen[first]) continue;
    std::vector<Index> around;
    // Across the side that leaves a corner, to the next corner of the same vertex.
    for (Index s = first; !seen[s]; s = net.side_after(net.partner(s))) {
      seen[s] = true;
      around.push_back(s);
    }
    visit(around, "what is crossed around " + net.corner_name(first));
  }
}

/// A flat line bundle by the phases of the sides, in turns, and its sections on the halved triangles (docs/proof.md,
/// section 17.3). In each triangle they are functions in its frame. All phases are exact, modulo 1.
class LineBundle {
 public:
  /// The net must live as long.
  LineBundle(std::vector<mpq_class> phases, const NetStructure& net);

  /// The rule `phases`. Throws Refutation.
  void check() const;

  /// Whether all phases are multiples of ½.
  [[nodiscard]] Inertia::Values values() const;

  /// By dart, what takes values of the vertex where it starts, or of its side, to its triangle's frame.
  [[nodiscard]] std::vector<mpq_class> of_starts(const HalvedNet& halved, Index halvings) const;
  [[nodiscard]] std::vector<mpq_class> of_sides(const HalvedNet& halved, Index halvings) const;

  /// e^{2πiφ}, 0 <= φ < 1. Parts that are 0 or ±1 are so exactly.
  [[nodiscard]] static Inertia::Turn turn(const mpq_class& phase);

 private:
  [[nodiscard]] mpq_class of_label(Index label) const;
  /// By dart: what takes sections from the frame of the triangle beyond to that of its own.
  [[nodiscard]] std::vector<mpq_class> across(Index halvings) const;

  std::vector<mpq_class> phases_;
  const NetStructure& net_;
};

}  // namespace epsnet::exact
