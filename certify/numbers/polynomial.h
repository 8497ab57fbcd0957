#pragma once

#include <cstdint>
#include <cstdlib>
#include <flint/fmpz_poly.h>

#include "certify/numbers/ball.h"

namespace epsnet::certify {

struct PolynomialType {
  using Struct = fmpz_poly_struct;
  static void init(Struct* x) { fmpz_poly_init(x); }
  static void set(Struct* x, const Struct* y) { fmpz_poly_set(x, y); }
  static void swap(Struct* x, Struct* y) { fmpz_poly_swap(x, y); }
  static void clear(Struct* x) { fmpz_poly_clear(x); }
};

/// A polynomial over ℤ.
using Polynomial = Owner<PolynomialType>;

[[nodiscard]] inline bool is_zero(const Polynomial& x) { return fmpz_poly_is_zero(x.get()) != 0; }

[[nodiscard]] inline bool are_equal(const Polynomial& x, const Polynomial& y) {
  return fmpz_poly_equal(x.get(), y.get()) != 0;
}

/// The most bits of a coefficient.
[[nodiscard]] inline std::uint64_t bits_of_coefficients(const Polynomial& x) {
  return static_cast<std::uint64_t>(std::abs(fmpz_poly_max_bits(x.get())));
}

[[nodiscard]] inline Polynomial sum(Polynomial x, Polynomial y) {
  if (is_zero(x)) return y;
  if (!is_zero(y)) fmpz_poly_add(x.get(), x.get(), y.get());
  return x;
}

[[nodiscard]] inline Polynomial negative(Polynomial x) {
  fmpz_poly_neg(x.get(), x.get());
  return x;
}

[[nodiscard]] inline Polynomial multiple(const mpz_class& x, const Polynomial& y) {
  Polynomial result;
  fmpz_poly_scalar_mul_fmpz(result.get(), y.get(), Integer(x).get());
  return result;
}

}  // namespace epsnet::certify
