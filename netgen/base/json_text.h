#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "certify/base/interval.h"
#include "triangulation/surface/surface.h"

/// JSON with bounds. nlohmann::json would print numbers rounded to nearest, so a bound is stored as a binary value that
/// contains its decimal.
namespace epsnet {

using Json = nlohmann::ordered_json;

/// A number of something is a number in JSON, too.
template <class Kind>
void to_json(Json& json, Id<Kind> id) {
  json = id.number();
}

/// Returns a bound as the binary value of its decimal; null if it is infinite.
[[nodiscard]] inline Json bound_json(double x, const std::string& decimal) {
  if (!std::isfinite(x)) return nullptr;
  return Json::binary(std::vector<std::uint8_t>(decimal.begin(), decimal.end()));
}

/// Returns an upper bound as a decimal, rounded upward; null if it is infinite.
[[nodiscard]] inline Json upper_bound_json(double x) { return bound_json(x, certify::decimal_above(x)); }

/// Returns the two ends as the decimals of certify::to_string; an infinite end is null.
[[nodiscard]] inline Json interval_json(certify::Interval x) {
  return Json::array({bound_json(x.lower, certify::decimal_below(x.lower)), upper_bound_json(x.upper)});
}

/// Returns the text on one line, in UTF-8; binary values are copied unchanged.
[[nodiscard]] inline std::string json_text(const Json& value) {
  if (value.is_binary()) return {value.get_binary().begin(), value.get_binary().end()};
  if (!value.is_structured()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string members;
  for (const auto& item : value.items()) {
    if (!members.empty()) members += ',';
    if (value.is_object()) members += json_text(Json(item.key())) + ':';
    members += json_text(item.value());
  }
  return value.is_object() ? '{' + members + '}' : '[' + members + ']';
}

}  // namespace epsnet
