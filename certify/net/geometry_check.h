#pragma once

#include <vector>

#include "certify/net/labels.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

struct GeometryOutcome {
  std::vector<RuleReport> reports;  ///< orientation, delaunay, covering, packing; thick, if it is a pseudo net.
  std::vector<std::uint32_t> ties;  ///< The smaller darts of the edges that are exact ties, in order.
  std::uint64_t triangles_beyond_64_bits = 0;
  std::uint64_t max_precision = 64;
  Enclosures enclosures;  ///< But for the area and the cores.
};

/// Rules `orientation`, `delaunay`, `covering` and `packing`: every lifted triangle is strictly counterclockwise, no
/// edge has a cross-ratio with positive imaginary part, every circumradius is at most ε, every edge between different
/// vertices is at least ε long (docs/proof.md, sections 5 to 7). In a pseudo net triangles of collars need a
/// circumcircle only, the edges between the two vertices of a collar may have any length, and rule `thick` says that
/// loops at other vertices are at least ε long (section 10).
///
/// Balls of 64 bits first, then twice as many for what they left open, and so on up to max_precision; exact ties of the
/// first two rules are decided exactly, in file order. What cannot change the first refuted rule, or the triangle that
/// refutes it, is left undecided, and so is what the budget does not allow. Needs rules `surface` and `map`. O(n) time;
/// the result does not depend on the number of threads. `progress` as in CheckOptions.
[[nodiscard]] GeometryOutcome check_geometry(const NetDocument& document, const LabelEvaluator& evaluator,
                                             const CheckOptions& options, unsigned threads);

}  // namespace epsnet::certify
