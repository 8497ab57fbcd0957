#pragma once

#include <optional>
#include <string_view>

#include "kernel/numbers.h"

namespace epsnet {

/// The exact value of a decimal or rational as docs/format.md defines it ("-0.25", "1e-3", "1/10"): 0.1 is 1/10.
/// Nothing for any other text, and for more than 10,000 characters.
[[nodiscard]] std::optional<Rational> parse_decimal(std::string_view text);

}  // namespace epsnet
