#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <gmpxx.h>
#include <vector>

/// What the kinds of algebraic numbers share: the integers of which they are combinations.
namespace epsnet::exact {

/// The last one is not 0.
using Integers = std::vector<mpz_class>;

inline void trim(Integers& x) {
  while (!x.empty() && x.back() == 0) x.pop_back();
}

/// x + y.
inline Integers sum(Integers x, const Integers& y) {
  x.resize(std::max(x.size(), y.size()));
  for (std::size_t i = 0; i < y.size(); ++i) x[i] += y[i];
  trim(x);
  return x;
}

/// Of a real number, times some power of 2: nearer to it than the error, or no farther.
struct Approximation {
  mpz_class value;
  mpz_class error;
};

/// A real algebraic integer, to be compared with others of another field (docs/proof.md, Lemma 45).
struct RealNumber {
  unsigned long n = 1;     ///< It is in an extension of ℚ(2cos(2π/n)),
  std::size_t degree = 1;  ///< of this degree at most.
  std::size_t bits = 1;    ///< Its conjugates are at most 2^bits.
  /// 2^k times the number.
  std::function<Approximation(mp_bitcnt_t k)> approximation;
  Integers field;  ///< Numbers of which these are equal are in one such extension. Empty: an integer.
};

inline RealNumber real_number(const mpz_class& n) {
  return {1, 1, mpz_sizeinbase(n.get_mpz_t(), 2), [n](mp_bitcnt_t k) { return Approximation{n << k, 0}; }, {}};
}

/// k such that 2^k is not less than the sum of the absolute values.
inline std::size_t sum_bits(const Integers& x) {
  mpz_class sum;
  for (const mpz_class& n : x) sum += abs(n);
  return mpz_sizeinbase(sum.get_mpz_t(), 2);
}

}  // namespace epsnet::exact
