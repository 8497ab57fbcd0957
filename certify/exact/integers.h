#pragma once

#include <algorithm>
#include <cstddef>
#include <gmpxx.h>
#include <vector>

/// What the kinds of algebraic numbers share: the integers of which they are combinations.
namespace epsnet::exact {

/// The last one is not 0.
using Integers = std::vector<mpz_class>;

inline void trim(Integers& x) {
  while (!x.empty() && x.back() == 0) x.pop_back();
}

/// x + factor · y.
inline Integers sum(Integers x, int factor, const Integers& y) {
  x.resize(std::max(x.size(), y.size()));
  for (std::size_t i = 0; i < y.size(); ++i) x[i] += factor * y[i];
  trim(x);
  return x;
}

/// Of a real number, times some power of 2: nearer to it than the error, or no farther.
struct Approximation {
  mpz_class value;
  mpz_class error;
};

}  // namespace epsnet::exact
