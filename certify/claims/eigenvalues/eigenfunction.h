#pragma once

#include <cstdint>
#include <optional>

#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/eigenvalues/overlaps.h"
#include "certify/numbers/budget.h"

/// Functions around the vertices of a net that nearly fit together (docs/proof.md, section 17).
namespace epsnet::certify {

/// A bound δ such that at least as many eigenvalues of −Δ on the surface as the row has functions, perhaps 0 among
/// them, lie in [λ − δ, λ + δ]; infinity if the functions prove none. Nothing if more bits are needed, or the
/// eigenvalue is too large for the disks. Balls round to the precision of the caller. BudgetSpent.
///
/// Requires: the rules of the net are verified, and the structure is right; `overlaps` are those of the net, the row's
/// radius and order.
[[nodiscard]] std::optional<double> eigenvalue_error(const Overlaps& overlaps,
                                                     const EigenvaluesDocument::Eigenfunctions& given,
                                                     std::uint64_t genus, const Budget& budget, unsigned threads);

}  // namespace epsnet::certify
