#include "netgen/base/options.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "netgen/base/gmp.h"

namespace epsnet {
namespace {

[[noreturn]] void reject(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown(text.substr(0, kShown));
  if (text.size() > kShown) {
    shown += "...";
  }
  throw std::invalid_argument("expected a positive number such as 0.1, 1e-3 or 1/10, not \"" + shown + "\"");
}

Rational parse(const std::string& text) {
  const std::optional<Rational> value = parse_decimal(text);
  if (!value || *value <= 0) {
    reject(text);
  }
  return *value;
}

std::string shortest_decimal(double value) {
  if (!std::isfinite(value) || value <= 0) {
    reject(std::to_string(value));
  }
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

}  // namespace

Length::Length(std::string text) : text_(std::move(text)), value_(parse(text_)) {}

Length::Length(double value) : Length(shortest_decimal(value)) {}

}  // namespace epsnet
