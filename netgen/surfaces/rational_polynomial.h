#pragma once

#include <flint/fmpq_poly.h>
#include <gmpxx.h>

#include "certify/numbers/polynomial.h"

namespace epsnet {

struct RationalPolynomialType {
  using Struct = fmpq_poly_struct;
  static void init(Struct* x) { fmpq_poly_init(x); }
  static void set(Struct* x, const Struct* y) { fmpq_poly_set(x, y); }
  static void swap(Struct* x, Struct* y) { fmpq_poly_swap(x, y); }
  static void clear(Struct* x) { fmpq_poly_clear(x); }
};

/// A polynomial over ℚ.
using RationalPolynomial = certify::Owner<RationalPolynomialType>;

[[nodiscard]] inline mpz_class denominator_of(const RationalPolynomial& x) {
  certify::Integer result;
  fmpq_poly_get_denominator(result.get(), x.get());
  return result.value();
}

[[nodiscard]] inline mpq_class coefficient(const RationalPolynomial& x, slong k) {
  fmpq_t value;
  fmpq_init(value);
  fmpq_poly_get_coeff_fmpq(value, x.get(), k);
  mpq_class result;
  fmpq_get_mpq(result.get_mpq_t(), value);
  fmpq_clear(value);
  return result;
}

}  // namespace epsnet
