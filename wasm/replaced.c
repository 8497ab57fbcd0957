/* Instead of files of FLINT that use its generic rings, whose tables of functions reach 2,300 files more, with all of
   FLINT's factorization: REPLACED in wasm/flint. The results are unique, so they are the same. */
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

/* fmpz_poly/divexact.c: the quotient of an exact division. */
void _fmpz_poly_divexact(fmpz* quotient, const fmpz* dividend, slong dividend_length, const fmpz* divisor,
                         slong divisor_length) {
  _fmpz_poly_div(quotient, dividend, dividend_length, divisor, divisor_length, 0);
}

void fmpz_poly_divexact(fmpz_poly_t quotient, const fmpz_poly_t dividend, const fmpz_poly_t divisor) {
  fmpz_poly_div(quotient, dividend, divisor);
}

/* fmpz_poly/gcd_modular.c: the greatest common divisor with a positive leading coefficient. */
void _fmpz_poly_gcd_modular(fmpz* divisor, const fmpz* first, slong first_length, const fmpz* second,
                            slong second_length) {
  _fmpz_poly_gcd_subresultant(divisor, first, first_length, second, second_length);
}

void fmpz_poly_gcd_modular(fmpz_poly_t divisor, const fmpz_poly_t first, const fmpz_poly_t second) {
  fmpz_poly_gcd_subresultant(divisor, first, second);
}

/* x, y = y, x − q y */
static void step(fmpq_poly_t x, fmpq_poly_t y, const fmpq_poly_t q) {
  fmpq_poly_t product;
  fmpq_poly_init(product);
  fmpq_poly_mul(product, q, y);
  fmpq_poly_sub(x, x, product);
  fmpq_poly_swap(x, y);
  fmpq_poly_clear(product);
}

/* fmpq_poly/xgcd.c: the monic greatest common divisor g = s·first + t·second, with s and t of least degree, by Euclid's
   algorithm; 0 if both are 0. */
void fmpq_poly_xgcd(fmpq_poly_t g, fmpq_poly_t s, fmpq_poly_t t, const fmpq_poly_t first, const fmpq_poly_t second) {
  fmpq_poly_t r0, r1, s0, s1, t0, t1, quotient, rest;
  fmpq_t lead;
  fmpq_init(lead);
  fmpq_poly_init(r0), fmpq_poly_init(r1), fmpq_poly_init(s0), fmpq_poly_init(s1), fmpq_poly_init(t0);
  fmpq_poly_init(t1), fmpq_poly_init(quotient), fmpq_poly_init(rest);
  fmpq_poly_set(r0, first);
  fmpq_poly_set(r1, second);
  fmpq_poly_set_si(s0, 1);
  fmpq_poly_set_si(t1, 1);
  while (!fmpq_poly_is_zero(r1)) {
    fmpq_poly_divrem(quotient, rest, r0, r1);
    fmpq_poly_swap(r0, r1);
    fmpq_poly_swap(r1, rest);
    step(s0, s1, quotient);
    step(t0, t1, quotient);
  }
  if (fmpq_poly_is_zero(r0)) {
    fmpq_poly_zero(s0);
    fmpq_poly_zero(t0);
  } else {
    fmpq_poly_get_coeff_fmpq(lead, r0, fmpq_poly_degree(r0));
    fmpq_poly_scalar_div_fmpq(r0, r0, lead);
    fmpq_poly_scalar_div_fmpq(s0, s0, lead);
    fmpq_poly_scalar_div_fmpq(t0, t0, lead);
  }
  fmpq_poly_swap(g, r0), fmpq_poly_swap(s, s0), fmpq_poly_swap(t, t0);
  fmpq_poly_clear(r0), fmpq_poly_clear(r1), fmpq_poly_clear(s0), fmpq_poly_clear(s1), fmpq_poly_clear(t0);
  fmpq_poly_clear(t1), fmpq_poly_clear(quotient), fmpq_poly_clear(rest);
  fmpq_clear(lead);
}
