#pragma once

#include "certify/document/report.h"
#include "certify/file/reader.h"

namespace epsnet::certify {

/// What check, check_geodesics, check_distance or check_cover says of a document, whichever it is.
[[nodiscard]] Certificate check_claim(const ClaimDocument& document, const CheckOptions& options = {});

/// The net of a document.
[[nodiscard]] const NetDocument& net_of(const ClaimDocument& document);

}  // namespace epsnet::certify
