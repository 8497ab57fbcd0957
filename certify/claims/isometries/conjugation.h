#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/isometries/document.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/numbers/budget.h"
#include "certify/verdict/report.h"

/// Isometries of the plane that take some elements of groups to others, decided exactly (docs/proof.md, Lemmas 38 and
/// 39).
namespace epsnet::certify {

/// Numbers of sides that a path crosses.
using SideWord = std::vector<std::uint32_t>;

/// What is wrong with paths from tile 0 to each tile.
[[nodiscard]] Problem paths_problem(const SurfaceSides& sides, const std::vector<SideWord>& paths);

/// What is wrong with some words from tile 0 to itself, of which there should be so many.
[[nodiscard]] Problem loops_problem(const SurfaceSides& sides, const std::vector<SideWord>& words, std::size_t count);

/// The generators g_s = paths[t] · s · paths[t']⁻¹ of the surface's group, by side s less than its partner. O(their
/// letters), which may be as many as sides times letters of paths; BudgetSpent, if that is too much memory.
[[nodiscard]] std::vector<SideWord> generator_words(const SurfaceSides& sides, const std::vector<SideWord>& paths,
                                                    const Budget& budget);

/// Words from tile 0 to itself; the second one is perhaps in another group.
struct ElementPair {
  SideWord from;
  SideWord to;
};

/// Whether there is an isometry f of the plane with f ∘ x ∘ f⁻¹ = x' for the elements x of all pairs and their partners
/// x'. Nothing, if their numbers are too large; BudgetSpent, if that is too much work.
///
/// Requires: two pairs or more; all elements but the identity are hyperbolic, and the first two `from` have no end of
/// their axes in common.
[[nodiscard]] std::optional<bool> are_conjugate(const Crossings& crossings, std::span<const ElementPair> pairs,
                                                const Budget& budget);

/// The same where `to` are words of another surface, with numbers of another ring (docs/proof.md, Lemma 45).
[[nodiscard]] std::optional<bool> are_conjugate(const Crossings& from, const Crossings& to,
                                                std::span<const ElementPair> pairs, const Budget& budget);

/// 1 or −1 if the axes of two elements cross, with opposite signs for the mirror images of the two; 0 if they do not
/// cross. Each is directed like the translation. Nothing, if the numbers are too large; BudgetSpent.
[[nodiscard]] std::optional<int> crossing_sign(const Crossings& crossings, std::span<const std::uint32_t> word,
                                               std::span<const std::uint32_t> other, const Budget& budget);

// Isometries of a surface.

/// What is wrong with the words of some isometries.
[[nodiscard]] Problem isometries_problem(const SurfaceSides& sides, const IsometryRows& rows);

/// About the least number of bytes of a file with these.
[[nodiscard]] std::uint64_t least_bytes(const IsometryRows& rows);

/// The rule `isometries`: whether each row is one, exactly. BudgetSpent, if that is too much work.
///
/// Requires: rows without problem, of the surface of the crossings.
[[nodiscard]] RuleReport isometries_report(const Crossings& crossings, const SurfaceSides& sides,
                                           const IsometryRows& rows, const Budget& budget);

// How many isometries some generate, by what they do with a function of words (docs/proof.md, Lemma 40).

/// By side: the values of a function of words at single letters, given for those that are less than their partners.
[[nodiscard]] std::vector<std::uint32_t> cocycle_by_side(const SurfaceSides& sides,
                                                         const std::vector<std::uint32_t>& values);

/// A number that the order of the group that the document's isometries generate is not less than; no more than one
/// above the document's `order` are counted. O(order · letters of all images); BudgetSpent, if that is too much work.
///
/// Requires: a document without structure problem, whose isometries are isometries.
[[nodiscard]] std::uint64_t orbit_size(const SurfaceSides& sides, const IsometriesDocument& document,
                                       const Budget& budget);

}  // namespace epsnet::certify
