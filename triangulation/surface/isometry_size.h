#pragma once

#include <algorithm>
#include <cmath>

#include "kernel/isometry.h"
#include "kernel/numbers.h"

/// How large isometries and their entries are, for bounds of errors (docs/error-bounds.md, E5).
namespace epsnet {

/// The integer e with 2^e ≤ |x| < 2^(e+1); a very small one for 0.
template <class T>
[[nodiscard]] double binary_exponent(const T& x) {
  return x == 0 ? -1e18 : static_cast<double>(mpfr_get_exp(x.backend().data()) - 1);
}

/// An upper bound of log2 of the operator norm |a| + |b| ≤ 2|a| of a normalised isometry, at most 2.5 too large. No
/// arithmetic, exponents only.
template <class T>
[[nodiscard]] double log2_norm(const Isometry<T>& f) {
  return 2.5 + std::max(binary_exponent(f.a.x), binary_exponent(f.a.y));
}

/// ν(f) = |a| + |b|.
[[nodiscard]] inline double size_of(const Isometry<double>& f) { return std::sqrt(norm(f.a)) + std::sqrt(norm(f.b)); }

}  // namespace epsnet
