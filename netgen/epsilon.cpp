#include "epsnet/netgen/epsilon.h"

#include <mpfr.h>

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

/// sinh²(ε/divisor), rounded towards −∞ or +∞ at some precision. Every operation is monotonous and rounded in the same
/// direction.
void sinh2(mpfr_t result, const Rational& epsilon, unsigned long divisor, mpfr_rnd_t direction) {
  mpfr_set_q(result, epsilon.backend().data(), direction);
  mpfr_div_ui(result, result, divisor, direction);
  mpfr_sinh(result, result, direction);
  mpfr_sqr(result, result, direction);
}

template <class T>
std::array<T, 2> enclosure(const Rational& epsilon, unsigned long divisor) {
  std::array<T, 2> ends;
  for (const std::size_t end : {0u, 1u}) {
    mpfr_t value;
    mpfr_init2(value, kMantissaBits<T>);
    sinh2(value, epsilon, divisor, end == 0 ? MPFR_RNDD : MPFR_RNDU);
    if constexpr (std::is_same_v<T, double>) {
      ends[end] = mpfr_get_d(value, end == 0 ? MPFR_RNDD : MPFR_RNDU);
    } else {
      mpfr_set(ends[end].backend().data(), value, MPFR_RNDN);  // Exact: the field has more bits.
    }
    mpfr_clear(value);
  }
  return ends;
}

}  // namespace

Epsilon::Epsilon(std::string text) : text_(std::move(text)), value_(parse(text_)) {
  if (value_ <= 0) {
    reject(text_);
  }
}

Epsilon::Epsilon(double value) : Epsilon(shortest_decimal(value)) {}

Threshold sinh2_threshold(const Epsilon& epsilon, unsigned divisor) {
  const std::array<double, 2> ends = enclosure<double>(epsilon.value(), divisor);
  return {ends[0], ends[1], enclosure<Mp256>(epsilon.value(), divisor), enclosure<Mp1024>(epsilon.value(), divisor),
          enclosure<Mp4096>(epsilon.value(), divisor)};
}

}  // namespace epsnet
