#pragma once

#include "certify/net/document.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

/// Rule `map`: the triangles and their opposite darts are a connected closed oriented combinatorial surface of the
/// given genus whose vertices are the vertices of the document, each with one cycle of darts (docs/proof.md, section
/// 3). Exact, O(n). Needs a document without structure problem.
[[nodiscard]] RuleReport check_map(const NetDocument& document, std::uint64_t genus);

}  // namespace epsnet::certify
