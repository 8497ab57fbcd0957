#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "certify/base/interval.h"

/// JSON with bounds: numbers that nlohmann::json would round to nearest are binary values, which hold their decimals.
namespace epsnet {

using Json = nlohmann::ordered_json;

/// The ends as the decimals of certify::to_string; null for one that is infinite.
[[nodiscard]] Json interval_json(certify::Interval x);

/// A bound from above as a decimal, rounded upward; null if it is infinite.
[[nodiscard]] Json upper_bound_json(double x);

/// On one line, in UTF-8; binary values as they stand.
[[nodiscard]] std::string json_text(const Json& value);

}  // namespace epsnet
