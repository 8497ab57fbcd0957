#pragma once

#include <cstddef>
#include <vector>

#include "certify/exact/claim_documents.h"
#include "certify/exact/loops.h"

namespace epsnet::exact {

/// Lemma 15.4 of docs/proof.md: the components of the surface without closed geodesics, in any order. The geodesics are
/// simple, pairwise disjoint, and given by a loop each, from its start to its end. Throws TooLarge.
template <class R>
[[nodiscard]] std::vector<Piece> pieces(NetRules<R>& net, const Loops<R>& loops,
                                        const std::vector<std::size_t>& geodesics);

}  // namespace epsnet::exact
