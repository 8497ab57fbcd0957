#include "netgen/base/json_text.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "certify/base/interval.h"

namespace epsnet {
namespace {

Json end_json(double x, const std::string& decimal) {
  if (!std::isfinite(x)) return nullptr;
  return Json::binary(std::vector<std::uint8_t>(decimal.begin(), decimal.end()));
}

template <class Text>
std::string joined(const Json& values, const Text& text) {
  std::string result;
  for (const auto& item : values.items()) result += (result.empty() ? "" : ",") + text(item);
  return result;
}

}  // namespace

Json interval_json(certify::Interval x) {
  return Json::array({end_json(x.lower, certify::decimal_below(x.lower)), upper_bound_json(x.upper)});
}

Json upper_bound_json(double x) { return end_json(x, certify::decimal_above(x)); }

std::string json_text(const Json& value) {
  if (value.is_binary()) return {value.get_binary().begin(), value.get_binary().end()};
  if (value.is_array()) return "[" + joined(value, [](const auto& item) { return json_text(item.value()); }) + "]";
  if (!value.is_object()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  const auto member = [](const auto& item) { return json_text(Json(item.key())) + ":" + json_text(item.value()); };
  return "{" + joined(value, member) + "}";
}

}  // namespace epsnet
