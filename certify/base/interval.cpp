#include "certify/base/interval.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "certify/base/error.h"
#include "certify/base/text.h"

namespace epsnet::certify {
namespace {

enum class Direction { down, up };

/// d₁.d₂d₃… · 10^exponent.
struct Decimal {
  std::string digits;
  int exponent;
};

/// Of "d.ddde+dd".
Decimal split(std::string_view scientific) {
  const std::size_t e = scientific.find('e');
  Decimal result{std::string(scientific.substr(0, 1)), std::atoi(scientific.substr(e + 1).data())};
  if (e > 1) result.digits += scientific.substr(2, e - 2);
  return result;
}

template <class... Precision>
Decimal scientific(double x, Precision... precision) {
  char buffer[800];
  *std::to_chars(buffer, buffer + sizeof buffer - 1, x, std::chars_format::scientific, precision...).ptr = '\0';
  return split(buffer);
}

/// A binary64 has at most 767 significant digits.
Decimal exact(double x) { return scientific(x, 766); }

/// So many digits of x, the last one increased if others that are not 0 are dropped and the direction is up.
Decimal rounded(const Decimal& x, std::size_t count, Direction direction) {
  Decimal result{x.digits.substr(0, count), x.exponent};
  if (direction == Direction::up && x.digits.find_first_not_of('0', count) != std::string::npos) {
    const std::size_t last = result.digits.find_last_not_of('9');
    if (last == std::string::npos) return {"1", x.exponent + 1};
    ++result.digits[last];
    result.digits.resize(last + 1);
  }
  result.digits.resize(result.digits.find_last_not_of('0') + 1);
  return result;
}

/// In full or with an exponent, whichever is shorter.
std::string to_string(const Decimal& x) {
  const auto count = static_cast<int>(x.digits.size());
  std::string full = x.digits;
  if (x.exponent < 0) {
    full = "0." + std::string(static_cast<std::size_t>(-x.exponent - 1), '0') + full;
  } else if (x.exponent < count - 1) {
    full.insert(static_cast<std::size_t>(x.exponent) + 1, ".");
  } else {
    full.append(static_cast<std::size_t>(x.exponent) + 1 - x.digits.size(), '0');
  }
  std::string with_exponent = x.digits.substr(0, 1);
  if (count > 1) with_exponent += "." + x.digits.substr(1);
  const int size = std::abs(x.exponent);
  with_exponent += (x.exponent < 0 ? "e-" : "e+") + std::string(size < 10 ? "0" : "") + std::to_string(size);
  return full.size() <= with_exponent.size() ? full : with_exponent;
}

/// Rounds |x|: downward if x ≥ 0 is rounded down, or a negative x up.
Direction of_magnitude(double x, Direction direction) {
  return (direction == Direction::down) == (x > 0) ? Direction::down : Direction::up;
}

bool is_plain(double x) { return x == 0 || !std::isfinite(x); }

/// 18 digits are enough. The tie between x > 0 and the binary64 beside it is at least 2⁻⁵⁴ x away, which is attained
/// below powers of two; the decimal of n digits next to x is less than 10^(1 − n) x away; and 10¹⁷ ≥ 2⁵⁴ > 10¹⁶.
/// Fewer digits than those of the shortest decimal that reads back as x, on either side, are not.
std::string outward(double x, Direction direction) {
  if (is_plain(x)) return shortest(x);
  const double magnitude = std::fabs(x);
  const Decimal all = exact(magnitude);
  for (std::size_t count = scientific(magnitude).digits.size();; ++count) {
    const std::string text = to_string(rounded(all, count, of_magnitude(x, direction)));
    if (parse_binary64(text) == magnitude) return (x < 0 ? "-" : "") + text;
  }
}

std::string outward(double x, unsigned digits, Direction direction) {
  if (is_plain(x)) return shortest(x);
  const Decimal result = rounded(exact(std::fabs(x)), digits, of_magnitude(x, direction));
  return (x < 0 ? "-" : "") + to_string(result);
}

}  // namespace

std::string to_string(Interval x) {
  return std::string("[").append(decimal_below(x.lower)).append(", ").append(decimal_above(x.upper)).append("]");
}

std::string decimal_below(double x) { return outward(x, Direction::down); }
std::string decimal_above(double x) { return outward(x, Direction::up); }
std::string decimal_below(double x, unsigned digits) { return outward(x, digits, Direction::down); }
std::string decimal_above(double x, unsigned digits) { return outward(x, digits, Direction::up); }

bool rounds_to_nearest() {
  // Nothing of this is computed by the compiler.
  volatile double one = 1, half = 0x1p-53, least = 0x1p-1022;
  // Of two ties the first is rounded down and the second up only by ties to even, of all directions of IEEE 754.
  const bool even = one + half == 1 && (one + 2 * half) + half == 1 + 0x1p-51;
  const bool gradual = (least / 2) * 2 == least;
  return even && gradual;
}

RoundingToNearest::RoundingToNearest() {
  ensure(std::fegetenv(&before_) == 0, "the floating-point environment is not told");
  std::fesetenv(FE_DFL_ENV);
  if (rounds_to_nearest()) return;
  std::fesetenv(&before_);
  throw Fault("binary64 numbers are not rounded to nearest");
}

RoundingToNearest::~RoundingToNearest() { std::fesetenv(&before_); }

}  // namespace epsnet::certify
