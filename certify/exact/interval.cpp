#include "certify/exact/interval.h"

#include <algorithm>

#include "certify/exact/plane.h"

namespace epsnet::exact {

/// (cosh 2x − 1)/2 = Σ 2^(2i−1) x^(2i)/(2i)!
SquaredSinh squared_sinh(const mpq_class& x) {
  if (x == 0) return {};
  if (x > 1000) throw TooLarge{"a length is greater than 1000"};
  // So many bits that the first term, x², has 256.
  const auto size = static_cast<long>(bits(x.get_den())) - static_cast<long>(bits(x.get_num()));
  const auto k = static_cast<mp_bitcnt_t>(256 + 2 * std::max(size, 0L));
  if (k > 100'000) throw TooLarge{"a length is too small"};
  const mpz_class scale = mpz_class(1) << k;
  const mpz_class low = x.get_num() * x.get_num() * scale / (x.get_den() * x.get_den());
  const mpz_class high = low + 1;
  // Terms t_1 = x² and t_(i+1) = t_i 4x²/((2i + 1)(2i + 2)), rounded down and up; quotients of integers are rounded
  // down.
  mpz_class lower = low, upper = high, t = low, u = high;
  for (unsigned long i = 1;; ++i) {
    const mpz_class divisor = mpz_class((2 * i + 1) * (2 * i + 2)) << k;
    t = t * low * 4 / divisor;
    u = u * high * 4 / divisor + 1;
    lower += t;
    upper += u;
    // From here on each term is less than half of the one before: the rest is less than the last one.
    if (t == 0 && high * 8 < divisor) break;
  }
  return {.lower = lower, .upper = upper + u, .k = k};
}

}  // namespace epsnet::exact
