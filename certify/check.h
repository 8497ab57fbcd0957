#pragma once

#include "certify/file/reader.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

/// Returns the certificate of `check`, `check_geodesics`, `check_distance` or `check_bound`, depending on the kind of
/// the document.
[[nodiscard]] Certificate check_claim(const ClaimDocument& document, const CheckOptions& options = {});

/// Returns the net of a document.
[[nodiscard]] const NetDocument& net_of(const ClaimDocument& document);

}  // namespace epsnet::certify
