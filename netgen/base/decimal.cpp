#include "netgen/base/decimal.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace epsnet {
namespace {

using boost::multiprecision::mpz_int;

/// The digits at the front of `text`, which are taken off.
std::string_view take_digits(std::string_view& text) {
  const std::size_t n = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, n);
  text.remove_prefix(n);
  return digits;
}

/// True if `text` starts with `c`, which is taken off.
bool take(std::string_view& text, char c) {
  const bool found = text.starts_with(c);
  text.remove_prefix(found ? 1 : 0);
  return found;
}

mpz_int integer(std::string_view digits) {
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size());
  // A leading 0 would mean octal.
  return first == digits.size() ? mpz_int(0) : mpz_int(std::string(digits.substr(first)));
}

/// Without the sign.
std::optional<Rational> parse_unsigned(std::string_view text) {
  const std::string_view whole = take_digits(text);
  if (whole.empty()) {
    return std::nullopt;
  }
  if (take(text, '/')) {
    const mpz_int denominator = integer(take_digits(text));
    return text.empty() && denominator != 0 ? std::optional(Rational(integer(whole), denominator)) : std::nullopt;
  }
  std::string digits(whole);
  int exponent = 0;
  if (take(text, '.')) {
    const std::string_view fraction = take_digits(text);
    if (fraction.empty()) {
      return std::nullopt;
    }
    digits += fraction;
    exponent -= static_cast<int>(fraction.size());
  }
  if (take(text, 'e') || take(text, 'E')) {
    const bool negative = take(text, '-');
    if (!negative) {
      (void)take(text, '+');
    }
    const std::string_view power = take_digits(text);
    if (power.empty() || power.size() > 4) {
      return std::nullopt;
    }
    const int value = std::atoi(std::string(power).c_str());
    exponent += negative ? -value : value;
  }
  if (!text.empty()) {
    return std::nullopt;
  }
  const mpz_int scale = boost::multiprecision::pow(mpz_int(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(integer(digits), scale) : Rational(mpz_int(integer(digits) * scale));
}

}  // namespace

std::optional<Rational> parse_decimal(std::string_view text) {
  constexpr std::size_t kLongest = 10'000;
  if (text.size() > kLongest) {
    return std::nullopt;
  }
  const bool negative = take(text, '-');
  const std::optional<Rational> size = parse_unsigned(text);
  return size && negative ? std::optional(Rational(-*size)) : size;
}

}  // namespace epsnet
