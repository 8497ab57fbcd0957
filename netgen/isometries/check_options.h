#pragma once

#include <cstdint>
#include <limits>

#include "certify/check.h"
#include "netgen/isometries/isometries.h"

namespace epsnet {

/// How documents that were made here are checked.
[[nodiscard]] inline certify::CheckOptions check_options(const IsometryOptions& options) {
  certify::CheckOptions result;
  result.threads = options.threads;
  result.max_work = std::numeric_limits<std::uint64_t>::max();  // No limit, as the document was made here.
  result.max_precision = 1024;
  result.progress = options.progress;
  return result;
}

}  // namespace epsnet
