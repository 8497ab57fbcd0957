#include <epsnet/certify/regular_number.h>
#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif

namespace epsnet::certify {
namespace {

/// Owner of one FLINT integer.
class Integer {
 public:
  Integer() { fmpz_init(value_); }
  explicit Integer(const mpz_class& value) {
    fmpz_init(value_);
    fmpz_set_mpz(value_, value.get_mpz_t());
  }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(value_); }
  [[nodiscard]] fmpz* get() { return value_; }

 private:
  fmpz_t value_;
};

slong half_order(const RegularRing& ring) { return 2 * static_cast<slong>(ring.genus()); }

/// The remainder modulo ζ^n + 1 of a polynomial of degree less than 2n.
void fold(IntegerPolynomial& x, slong n) {
  Integer low, high;
  for (slong k = fmpz_poly_length(x.get()) - 1; k >= n; --k) {
    fmpz_poly_get_coeff_fmpz(high.get(), x.get(), k);
    fmpz_poly_get_coeff_fmpz(low.get(), x.get(), k - n);
    fmpz_sub(low.get(), low.get(), high.get());
    fmpz_poly_set_coeff_fmpz(x.get(), k - n, low.get());
  }
  fmpz_poly_truncate(x.get(), n);
}

IntegerPolynomial product(const IntegerPolynomial& x, const IntegerPolynomial& y, slong n) {
  IntegerPolynomial result;
  fmpz_poly_mul(result.get(), x.get(), y.get());
  fold(result, n);
  return result;
}

IntegerPolynomial sum(const IntegerPolynomial& x, const IntegerPolynomial& y) {
  IntegerPolynomial result;
  fmpz_poly_add(result.get(), x.get(), y.get());
  return result;
}

IntegerPolynomial difference(const IntegerPolynomial& x, const IntegerPolynomial& y) {
  IntegerPolynomial result;
  fmpz_poly_sub(result.get(), x.get(), y.get());
  return result;
}

/// ζ^k ↦ ζ^−k = −ζ^(n−k) for 0 < k < n.
IntegerPolynomial conjugate(const IntegerPolynomial& x, slong n) {
  IntegerPolynomial result;
  Integer coefficient;
  for (slong k = 0; k < fmpz_poly_length(x.get()); ++k) {
    fmpz_poly_get_coeff_fmpz(coefficient.get(), x.get(), k);
    if (k != 0) fmpz_neg(coefficient.get(), coefficient.get());
    fmpz_poly_set_coeff_fmpz(result.get(), k == 0 ? 0 : n - k, coefficient.get());
  }
  return result;
}

/// i x: i = ζ^(n/2).
IntegerPolynomial turned(const IntegerPolynomial& x, slong n) {
  IntegerPolynomial result;
  fmpz_poly_shift_left(result.get(), x.get(), n / 2);
  fold(result, n);
  return result;
}

RegularNumber turned(const RegularNumber& x) {
  const slong n = half_order(*x.ring);
  return {x.ring, turned(x.even, n), turned(x.odd, n)};
}

bool is_zero(const IntegerPolynomial& x, const RegularRing& ring) {
  IntegerPolynomial remainder;
  fmpz_poly_rem(remainder.get(), x.get(), ring.cyclotomic().get());
  return fmpz_poly_is_zero(remainder.get()) != 0;
}

/// The value of a real number.
void evaluate(arb_ptr result, const RegularNumber& x, slong precision) {
  const std::uint32_t genus = x.ring->genus();
  ComplexBall zeta, even, odd;
  Ball cosh, sinh;
  set_regular_apothem(cosh.get(), sinh.get(), genus, precision);
  set_regular_direction(zeta.get(), genus, 1, precision);
  arb_fmpz_poly_evaluate_acb(even.get(), x.even.get(), zeta.get(), precision);
  arb_fmpz_poly_evaluate_acb(odd.get(), x.odd.get(), zeta.get(), precision);
  arb_mul(result, odd.re(), sinh.get(), precision);
  arb_add(result, result, even.re(), precision);
}

}  // namespace

RegularRing::RegularRing(std::uint32_t genus) : genus_(genus) {
  const slong n = half_order(*this);
  fmpz_poly_cyclotomic(cyclotomic_.get(), 2 * static_cast<ulong>(n));
  for (slong k = 1; k < n; ++k) fmpz_poly_set_coeff_si(cotangent_.get(), k, -1);
  cotangent_ = turned(cotangent_, n);
  s_squared_ = product(cotangent_, cotangent_, n);
  IntegerPolynomial one;
  fmpz_poly_one(one.get());
  s_squared_ = difference(s_squared_, one);
}

RegularNumber regular_number(const RegularRing& ring, const Gaussian& x) {
  RegularNumber result{&ring, {}, {}};
  Integer re(x.re), im(x.im);
  fmpz_poly_set_coeff_fmpz(result.even.get(), 0, re.get());
  fmpz_poly_set_coeff_fmpz(result.even.get(), half_order(ring) / 2, im.get());
  return result;
}

RegularNumber operator+(const RegularNumber& x, const RegularNumber& y) {
  return {x.ring, sum(x.even, y.even), sum(x.odd, y.odd)};
}

RegularNumber operator-(const RegularNumber& x, const RegularNumber& y) {
  return {x.ring, difference(x.even, y.even), difference(x.odd, y.odd)};
}

RegularNumber operator*(const RegularNumber& x, const RegularNumber& y) {
  const slong n = half_order(*x.ring);
  const IntegerPolynomial both_odd = product(product(x.odd, y.odd, n), x.ring->s_squared(), n);
  return {x.ring, sum(product(x.even, y.even, n), both_odd), sum(product(x.even, y.odd, n), product(x.odd, y.even, n))};
}

RegularNumber operator*(const mpz_class& x, const RegularNumber& y) {
  RegularNumber result{y.ring, {}, {}};
  Integer factor(x);
  fmpz_poly_scalar_mul_fmpz(result.even.get(), y.even.get(), factor.get());
  fmpz_poly_scalar_mul_fmpz(result.odd.get(), y.odd.get(), factor.get());
  return result;
}

RegularNumber operator*(const Gaussian& x, const RegularNumber& y) { return x.re * y + x.im * turned(y); }

RegularNumber conjugate(const RegularNumber& x) {
  const slong n = half_order(*x.ring);
  return {x.ring, conjugate(x.even, n), conjugate(x.odd, n)};
}

RegularNumber norm(const RegularNumber& x) { return x * conjugate(x); }

RegularNumber twice_real(const RegularNumber& x) { return x + conjugate(x); }

RegularNumber twice_imaginary(const RegularNumber& x) { return turned(conjugate(x) - x); }

void reduce(Isometry<RegularNumber>& f) {
  Integer divisor, content;
  const std::array parts{&f.a.even, &f.a.odd, &f.b.even, &f.b.odd};
  for (const IntegerPolynomial* part : parts) {
    fmpz_poly_content(content.get(), part->get());
    fmpz_gcd(divisor.get(), divisor.get(), content.get());
  }
  for (IntegerPolynomial* part : parts) {
    fmpz_poly_scalar_divexact_fmpz(part->get(), part->get(), divisor.get());
  }
}

bool is_zero(const RegularNumber& x) { return is_zero(x.even, *x.ring) && is_zero(x.odd, *x.ring); }

int sign(const RegularNumber& x) {
  if (is_zero(x)) return 0;
  Ball value;
  for (slong precision = 128;; precision *= 2) {
    evaluate(value.get(), x, precision);
    const Tri positive = certainly_positive(value.get());
    if (positive != Tri::unknown) return positive == Tri::yes ? 1 : -1;
  }
}

void set_regular_apothem(arb_ptr cosh, arb_ptr sinh, std::uint32_t genus, slong precision) {
  arb_const_pi(cosh, precision);
  arb_div_ui(cosh, cosh, 4 * static_cast<ulong>(genus), precision);
  arb_cot(cosh, cosh, precision);
  arb_sqr(sinh, cosh, precision);
  arb_sub_ui(sinh, sinh, 1, precision);
  arb_sqrt(sinh, sinh, precision);
}

void set_regular_direction(acb_ptr result, std::uint32_t genus, std::uint32_t k, slong precision) {
  fmpq_t turns;
  fmpq_init(turns);
  fmpq_set_si(turns, k, 2 * static_cast<ulong>(genus));
  arb_sin_cos_pi_fmpq(acb_imagref(result), acb_realref(result), turns, precision);
  fmpq_clear(turns);
}

}  // namespace epsnet::certify
