#include "netgen/surfaces/simplest_rational.h"

#include <array>

#include "triangulation/surface/exact_points.h"

namespace epsnet {

Rational simplest_between(Rational low, Rational high) {
  // Follows the continued fractions of both ends as long as they agree; these are the last two convergents.
  std::array<Rational, 2> above{1, 0};
  std::array<Rational, 2> below{0, 1};
  for (;;) {
    const Integer whole = numerator(low) / denominator(low);
    const bool ends = Rational(whole) == low || Rational(whole + 1) <= high;
    const Rational digit = Rational(whole) == low ? Rational(whole) : ends ? Rational(whole + 1) : Rational(whole);
    above = {above[0] * digit + above[1], above[0]};
    below = {below[0] * digit + below[1], below[0]};
    if (ends) return above[0] / below[0];
    const Rational new_low = 1 / (high - digit);
    high = 1 / (low - digit);
    low = new_low;
  }
}

Rational simplest_near(const Mp1024& x, int bits) {
  const Mp1024 margin = boost::multiprecision::ldexp(x, -bits);
  return simplest_between(Rational(Mp1024(x - margin)), Rational(Mp1024(x + margin)));
}

std::optional<Rational> rational_root(const Rational& x) {
  const Integer above = sqrt(numerator(x));
  const Integer below = sqrt(denominator(x));
  if (above * above != numerator(x) || below * below != denominator(x)) return std::nullopt;
  return Rational(above, below);
}

}  // namespace epsnet
