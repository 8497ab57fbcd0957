#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "certify/base/interval.h"
#include "triangulation/surface/id.h"

/// JSON with bounds. nlohmann::json would print numbers rounded to nearest, so a bound is stored as a binary value that
/// contains its decimal.
namespace epsnet {

using Json = nlohmann::ordered_json;

/// A number of something is a number in JSON, too.
template <class Kind>
void to_json(Json& json, Id<Kind> id) {
  json = id.number();
}

/// Returns the two ends as the decimals of certify::to_string; an infinite end is null.
[[nodiscard]] Json interval_json(certify::Interval x);

/// Returns an upper bound as a decimal, rounded upward; null if it is infinite.
[[nodiscard]] Json upper_bound_json(double x);

/// Returns the text on one line, in UTF-8; binary values are copied unchanged.
[[nodiscard]] std::string json_text(const Json& value);

}  // namespace epsnet
