#pragma once

#include <optional>
#include <string>

#include "certify/base/error.h"
#include "certify/documents.h"
#include "certify/verdict/report.h"

/// The checker: decides whether a document proves what it claims (docs/proof.md).
///
/// What each claim says, and the rules it must satisfy, is in docs/format.md; its arguments are in the folder of the
/// claim in certify/claims.
namespace epsnet::certify {

/// Returns what makes the verdict of a document `malformed`, as `check` finds it before it asks any rule; nullopt if
/// nothing does. O(size of the document), by up to so many threads.
[[nodiscard]] std::optional<std::string> malformation(const AnyClaim& document, unsigned threads = 1);

/// Checks all rules. Returns a certificate for a document of any content. Throws only if the machine fails
/// (std::bad_alloc, std::system_error) or this program has a bug (Fault); then there is no verdict.
///
/// The verdict is malformed if the structure is broken; else refuted if any evaluated rule is refuted, and the first
/// such rule is named; else undecided if any rule is undecided or was not evaluated; else verified. Rules that cannot
/// change the verdict are left undecided. A claim's own rules are asked if those of its net are verified.
///
/// For a net O(n log n) time, n the size of the document, at fixed precision; for geodesics of length up to L also the
/// lifted triangles visited, about e^L; for a distance O(paths · triangles) more, however long the paths are; for
/// bounds O(cells) more. Once the total work exceeds `max_work`, the remaining rules are undecided. A rule that was
/// refuted before stays refuted. The number of threads changes nothing.
[[nodiscard]] Certificate check(const AnyClaim& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
