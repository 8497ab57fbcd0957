#pragma once

#include <cstdint>
#include <string>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/verdict/report.h"

/// The claim of an eigenvalues file: how many eigenvalues of the Laplacian lie where (docs/proof.md, section 17).
namespace epsnet::certify {

struct Claim;

/// What an eigenvalues document must satisfy before any rule makes sense: what a spectrum must (geodesics/check.h); n
/// even from 8 to 16, K from 1 to 64, L ≤ 2K + n/2; K + 1 finite coefficients for each statement, not all 0; intervals
/// in order in [0, ¼ + 9/δ²]; for each eigenfunction 2M + 1 finite coefficients by vertex, M from 1 to 200, not all 0,
/// a radius of more than ε and less than 2, 0 < lower end ≤ λ ≤ upper end; windows in increasing order, disjoint, up to
/// `eigenvalues_up_to`.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const EigenvaluesDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const EigenvaluesDocument& document);

/// The names of its own rules, in order: those of the spectrum (geodesics/check.h), and then
///
/// * `traces`: the sums of squares over the eigenvalues that the trace formula gives are positive;
/// * `most`, `least`: the inequalities of the statements `at_most` and `at_least`;
/// * `eigenfunctions`: each function proves an eigenvalue in its interval; never refuted;
/// * `windows`: the claims about the windows, and that no eigenvalue is elsewhere, follow from the statements.
///
/// Time: that of the spectrum's rules, and some (10·geodesics + 10⁵·statements) operations of balls; for an
/// eigenfunction of order M (vertices·M²·10³).
[[nodiscard]] RuleNames own_rules(const EigenvaluesDocument& document);

[[nodiscard]] Claim claim_of(const EigenvaluesDocument& document);

}  // namespace epsnet::certify
