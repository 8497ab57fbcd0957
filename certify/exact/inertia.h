#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <gmpxx.h>
#include <vector>

#include "certify/exact/flat_triangles.h"
#include "certify/exact/net_structure.h"

/// Matrices of forms on a halved net, also of sections of line bundles, and how many negative eigenvalues they have.
namespace epsnet::exact {

/// The matrix K of 𝒜 − σ𝒩, sums over triangles, and how many negative eigenvalues it has (Lemma 36 of docs/proof.md).
///
/// It is factored in integers, row by row, each from left to right: D has 1 and −1 on its diagonal, entries of L are
/// multiples of 2⁻⁵⁰. What the rounded quotients leave is K − LDLᵀ, which so is known exactly.
class Inertia {
 public:
  using Rows = std::array<Index, 3>;

  /// Real: all e^{iφ} are 1 or −1. Complex: each row becomes two, that of the real part and that of the imaginary one.
  enum class Values { real, complex };

  /// By triangle, the rows of its three functions, in the order of elimination. Throws LeftOut if one factorisation
  /// takes more than so many multiplications.
  Inertia(std::vector<Rows> rows, std::size_t functions, std::size_t most_operations, Values values = Values::real);

  void add(std::size_t triangle, const LocalForms& forms);

  /// (cos φ, sin φ)
  using Turn = std::array<Interval, 2>;
  /// The same of complex values, which are those of the rows times e^{iφ} of the three functions.
  void add(std::size_t triangle, const LocalForms& forms, const std::array<Turn, 3>& turns);

  enum class Bound { at_most, at_least };
  /// A number n for which (a) holds, or (b): 𝒜 − σ𝒩 is negative definite on no subspace of more than n dimensions, or
  /// on one of n. Throws TooLarge if the digits used prove none.
  [[nodiscard]] std::size_t negative(const Interval& sigma, Bound bound) const;

 private:
  /// On and left of the diagonal.
  struct Entry {
    Index column;
    Interval energy;
    Interval mass;
  };
  class Factorisation;

  /// Calls visit(k) for the columns k < i of row i of L with entries, in any order. `seen` is i for them afterwards.
  template <class Visit>
  void each_column(std::size_t i, std::vector<Index>& seen, const Visit& visit) const;
  [[nodiscard]] Index row_of(Index row, Index part) const { return parts_ * row + part; }
  /// Nothing right of the diagonal.
  void add(Index row, Index column, const Interval& energy, const Interval& mass);
  void find_columns(std::size_t most_operations);

  Index parts_;  ///< Of each row: 1 or 2.
  std::vector<Rows> rows_;
  std::vector<std::vector<Entry>> entries_;  ///< By row, by column.
  std::vector<Index> parent_;                ///< By column of L: the first row below the diagonal with an entry.
  std::vector<std::size_t> below_;           ///< By column of L: how many entries are below the diagonal.
};

// Sections of line bundles.

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
