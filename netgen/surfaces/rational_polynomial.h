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

[[nodiscard]] inline mpq_class coefficient(const RationalPolynomial& x, slong k) {
  mpq_class result;
  fmpq_poly_get_coeff_mpq(result.get_mpq_t(), x.get(), k);
  return result;
}

}  // namespace epsnet
