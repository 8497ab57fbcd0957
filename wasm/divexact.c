/* Instead of FLINT's fmpz_poly/divexact.c, which does the same by FLINT's generic rings; their tables of functions
   reach 2,300 files more, with all of FLINT's factorization. The quotient of an exact division is unique. */
#include <flint/fmpz_poly.h>

void _fmpz_poly_divexact(fmpz* quotient, const fmpz* dividend, slong dividend_length, const fmpz* divisor,
                         slong divisor_length) {
  _fmpz_poly_div(quotient, dividend, dividend_length, divisor, divisor_length, 0);
}

void fmpz_poly_divexact(fmpz_poly_t quotient, const fmpz_poly_t dividend, const fmpz_poly_t divisor) {
  fmpz_poly_div(quotient, dividend, divisor);
}
