#pragma once

#include <gmpxx.h>
#include <map>
#include <vector>

#include "certify/exact/flat_triangles.h"
#include "certify/exact/inertia.h"
#include "certify/exact/net_structure.h"

namespace epsnet::exact {

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
