#pragma once

#include "certify/net/document.h"
#include "certify/net/labels.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

/// Rule `map`: the triangles and their opposite darts are a connected closed oriented combinatorial surface of the
/// given genus whose vertices are the vertices of the document, each with one cycle of darts (docs/proof.md, section
/// 3). Exact, O(n). Needs a document without structure problem. The report does not depend on the number of threads.
[[nodiscard]] RuleReport check_map(const NetDocument& document, std::uint64_t genus, unsigned threads = 1);

struct GluingOutcome {
  RuleReport report;
  std::uint64_t identities = 0;      ///< Different group equations that had to be decided.
  std::uint64_t max_precision = 64;  ///< Bits.
};

/// Whether an element of the group of the surface is 1, given as an isometry of the disk with the centre of a disk
/// inside of a tile, whose radius has this sinh, at 0 (docs/proof.md, Lemma 2).
[[nodiscard]] Tri is_identity(const BallIsometry& element, const Ball& sinh_radius, slong precision);

/// Rule `gluing`: across every edge the two triangles fit, L_{t,i} L_{t',j+1}⁻¹ = L_{t,i+1} L_{t',j}⁻¹ in the group of
/// the surface (corner i of t is corner j + 1 of t', corner i + 1 is corner j).
///
/// An element of the group that moves the centre of a disk inside a tile by less than twice the radius is 1, so balls
/// decide equality (docs/proof.md, section 4). Needs rules `surface` and `map`. O(n log n) for look-ups and one
/// evaluation for each different equation.
[[nodiscard]] GluingOutcome check_gluing(const NetDocument& document, const LabelEvaluator& evaluator,
                                         const LabelParts& parts, long max_precision, unsigned threads);

}  // namespace epsnet::certify
