#pragma once

#include "certify/net/document.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

/// Rule `map`: the triangles and their opposite darts are a connected closed oriented combinatorial surface of the
/// given genus whose vertices are the vertices of the document, each with one cycle of darts (docs/proof.md, section
/// 3). Exact, O(n). Needs a document without structure problem. The report does not depend on the number of threads.
[[nodiscard]] RuleReport check_map(const NetDocument& document, std::uint64_t genus, unsigned threads = 1);

}  // namespace epsnet::certify
