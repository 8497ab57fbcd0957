#include "epsnet/netgen/epsilon.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace epsnet {
namespace {

[[noreturn]] void reject(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown(text.substr(0, kShown));
  if (text.size() > kShown) {
    shown += "...";
  }
  throw std::invalid_argument("epsilon must be a positive number such as 0.1, 1e-3 or 1/10, not \"" + shown + "\"");
}

/// The digits at the front of `text`, which are taken off.
std::string_view take_digits(std::string_view& text) {
  const std::size_t n = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, n);
  text.remove_prefix(n);
  return digits;
}

boost::multiprecision::mpz_int integer(std::string_view digits) {
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size());
  // A leading 0 would mean octal.
  return first == digits.size() ? boost::multiprecision::mpz_int(0)
                                : boost::multiprecision::mpz_int(std::string(digits.substr(first)));
}

/// The grammar is that of docs/format.md, "decimal", without the sign: ε is positive.
Rational parse(std::string_view text) {
  using boost::multiprecision::mpz_int;
  constexpr std::size_t kLongest = 10'000;
  std::string_view rest = text;
  const std::string_view whole = take_digits(rest);
  if (whole.empty() || text.size() > kLongest) {
    reject(text);
  }
  if (rest.starts_with('/')) {
    rest.remove_prefix(1);
    const mpz_int denominator = integer(take_digits(rest));
    if (!rest.empty() || denominator == 0) {
      reject(text);
    }
    return Rational(integer(whole), denominator);
  }
  std::string digits(whole);
  int exponent = 0;
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    const std::string_view fraction = take_digits(rest);
    if (fraction.empty()) {
      reject(text);
    }
    digits += fraction;
    exponent -= static_cast<int>(fraction.size());
  }
  if (rest.starts_with('e') || rest.starts_with('E')) {
    rest.remove_prefix(1);
    const bool negative = rest.starts_with('-');
    if (negative || rest.starts_with('+')) {
      rest.remove_prefix(1);
    }
    const std::string_view power = take_digits(rest);
    if (power.empty() || power.size() > 4) {
      reject(text);
    }
    const int value = std::stoi(std::string(power));
    exponent += negative ? -value : value;
  }
  if (!rest.empty()) {
    reject(text);
  }
  const mpz_int scale = boost::multiprecision::pow(mpz_int(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(integer(digits), scale) : Rational(mpz_int(integer(digits) * scale));
}

std::string shortest_decimal(double value) {
  if (!std::isfinite(value) || value <= 0) {
    reject(std::to_string(value));
  }
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

}  // namespace

Epsilon::Epsilon(std::string text) : text_(std::move(text)), value_(parse(text_)) {
  if (value_ <= 0) {
    reject(text_);
  }
}

Epsilon::Epsilon(double value) : Epsilon(shortest_decimal(value)) {}

}  // namespace epsnet
