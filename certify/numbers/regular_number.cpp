#include "certify/numbers/regular_number.h"

#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_poly.h>
#else
#include <acb_poly.h>
#endif
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

#include "certify/numbers/ball.h"

namespace epsnet::certify {
namespace {

/// Modulo X^half + 1, of a polynomial of degree less than 2·half.
void reduce(Polynomial& x, slong half) {
  if (fmpz_poly_length(x.get()) <= half) return;
  Polynomial high;
  fmpz_poly_shift_right(high.get(), x.get(), half);
  fmpz_poly_truncate(x.get(), half);
  fmpz_poly_sub(x.get(), x.get(), high.get());
}

slong half_order(const RegularNumber& x) { return static_cast<slong>(x.ring->order() / 2); }

Polynomial product(const RegularRing& ring, const Polynomial& x, const Polynomial& y) {
  Polynomial result;
  if (fmpz_poly_is_zero(x.get()) || fmpz_poly_is_one(y.get())) return x;
  if (fmpz_poly_is_zero(y.get())) return y;
  const auto length = static_cast<std::uint64_t>(std::min(fmpz_poly_length(x.get()), fmpz_poly_length(y.get())));
  const std::uint64_t bits =
      bits_of_coefficients(x) + bits_of_coefficients(y) + static_cast<std::uint64_t>(std::bit_width(length));
  const auto longer = static_cast<std::uint64_t>(std::max(fmpz_poly_length(x.get()), fmpz_poly_length(y.get())));
  ring.budget().spend(product_work(longer * bits) + 4 * longer);
  fmpz_poly_mul(result.get(), x.get(), y.get());
  reduce(result, static_cast<slong>(ring.order() / 2));
  return result;
}

/// The value at ζ.
ComplexBall value_at(const Polynomial& x, const ComplexBall& zeta) {
  const slong precision = Precision::bits();
  ComplexBall result;
  acb_poly_t polynomial;
  acb_poly_init(polynomial);
  acb_poly_set_fmpz_poly(polynomial, x.get(), precision);
  acb_poly_evaluate(result.get(), polynomial, zeta.get(), precision);
  acb_poly_clear(polynomial);
  return result;
}

/// The sign of a number that is not 0: some precision tells it.
int sign_of_nonzero(const RegularNumber& x) {
  const slong first = 64 + static_cast<slong>(std::max(bits_of_coefficients(x.u), bits_of_coefficients(x.v)));
  Tri answer = Tri::unknown;
  const auto attempt = [&](slong precision) {
    x.ring->budget().spend(4 * ball_work(static_cast<std::uint64_t>(precision)), x.ring->order());
    answer = certainly_positive(real_ball(x));
    return answer != Tri::unknown;
  };
  with_rising_precision(std::numeric_limits<slong>::max() / 2, attempt, first);
  return answer == Tri::yes ? 1 : -1;
}

/// Whether an automorphism of ℚ(ζ) makes s² negative. If s were in ℚ(ζ), its image would be real as s is, and have a
/// square ≥ 0.
bool has_negative_conjugate(std::uint32_t order, std::span<const PowerOfZeta> square, const Budget& budget) {
  constexpr slong kBits = 64;
  const Precision scope(kBits);
  for (std::uint32_t j = order / 2 - 1; j > 0; --j) {
    if (std::gcd(j, order) != 1) continue;
    budget.spend(function_work(kBits), square.size());
    Ball value;
    for (const auto& [coefficient, power] : square) {
      const std::int64_t n = order;
      value += coefficient * real(root_of_unity(static_cast<std::uint32_t>((power * j % n + n) % n), order));
    }
    if (certainly_negative(value) == Tri::yes) return true;
  }
  return false;
}

}  // namespace

RegularRing::RegularRing(std::uint32_t order, std::span<const PowerOfZeta> square_of_s, Budget budget)
    : order_(order),
      budget_(std::move(budget)),
      square_of_s_(polynomial(square_of_s)),
      has_new_root_(has_negative_conjugate(order, square_of_s, budget_)) {
  fmpz_poly_cyclotomic(cyclotomic_.get(), order);
}

Polynomial RegularRing::polynomial(std::span<const PowerOfZeta> terms) const {
  const auto order = static_cast<std::int64_t>(order_);
  Polynomial result;
  for (const auto& [coefficient, power] : terms) {
    const slong exponent = (power % order + order) % order;
    const slong place = exponent % (order / 2);
    const slong before = fmpz_poly_get_coeff_si(result.get(), place);
    fmpz_poly_set_coeff_si(result.get(), place, exponent == place ? before + coefficient : before - coefficient);
  }
  return result;
}

RegularRing::Roots RegularRing::roots() const {
  const std::lock_guard lock(mutex_);
  // Few precisions, so that few are kept.
  const auto bits = static_cast<slong>(std::bit_ceil(static_cast<std::uint64_t>(Precision::bits())));
  const auto [found, is_new] = roots_.try_emplace(bits);
  Roots& roots = found->second;
  if (is_new) {
    const Precision scope(bits);
    roots.zeta = root_of_unity(1, order_);
    roots.s = sqrt(real(value_at(square_of_s_, roots.zeta)));
  }
  return roots;
}

bool RegularRing::is_zero(const Polynomial& x) const {
  const auto quotient =
      static_cast<std::uint64_t>(std::max<slong>(fmpz_poly_length(x.get()) - fmpz_poly_degree(cyclotomic_.get()), 0));
  budget_.spend(product_work(bits_of_coefficients(x) + 64) * order_, quotient);
  Polynomial rest;
  fmpz_poly_rem(rest.get(), x.get(), cyclotomic_.get());
  return fmpz_poly_is_zero(rest.get()) != 0;
}

RegularNumber regular_number(const RegularRing& ring, const Gaussian& x) {
  RegularNumber result{&ring, {}};
  fmpz_poly_set_coeff_fmpz(result.u.get(), 0, Integer(x.re).get());
  // i = ζ^(order/4).
  fmpz_poly_set_coeff_fmpz(result.u.get(), static_cast<slong>(ring.order() / 4), Integer(x.im).get());
  return result;
}

RegularNumber regular_number(const RegularRing& ring, std::span<const PowerOfZeta> u, std::span<const PowerOfZeta> v) {
  return {&ring, ring.polynomial(u), ring.polynomial(v)};
}

RegularNumber operator+(RegularNumber x, RegularNumber y) {
  return {x.ring, sum(std::move(x.u), std::move(y.u)), sum(std::move(x.v), std::move(y.v))};
}

RegularNumber operator-(RegularNumber x, RegularNumber y) {
  return std::move(x) + RegularNumber{y.ring, negative(std::move(y.u)), negative(std::move(y.v))};
}

RegularNumber operator*(const RegularNumber& x, const RegularNumber& y) {
  const auto times = [&](const Polynomial& p, const Polynomial& q) { return product(*x.ring, p, q); };
  return {x.ring, sum(times(x.u, y.u), times(times(x.v, y.v), x.ring->square_of_s())),
          sum(times(x.u, y.v), times(x.v, y.u))};
}

RegularNumber operator*(const mpz_class& x, const RegularNumber& y) { return Gaussian{x, 0} * y; }

RegularNumber operator*(const Gaussian& x, const RegularNumber& y) {
  // i = ζ^(order/4).
  const auto times = [&](const Polynomial& p) {
    Polynomial turned;
    fmpz_poly_shift_left(turned.get(), p.get(), half_order(y) / 2);
    reduce(turned, half_order(y));
    return sum(multiple(x.re, p), multiple(x.im, turned));
  };
  if (x.im == 0) return {y.ring, multiple(x.re, y.u), multiple(x.re, y.v)};
  return {y.ring, times(y.u), times(y.v)};
}

RegularNumber conjugate(const RegularNumber& x) {
  // ζ^−k = −ζ^(half − k).
  const auto conjugated = [&](const Polynomial& p) {
    Polynomial result;
    fmpz_poly_reverse(result.get(), p.get(), half_order(x) + 1);
    reduce(result, half_order(x));
    return negative(std::move(result));
  };
  return {x.ring, conjugated(x.u), conjugated(x.v)};
}

RegularNumber norm(const RegularNumber& x) { return x * conjugate(x); }

RegularNumber twice_real(const RegularNumber& x) { return x + conjugate(x); }

RegularNumber twice_imaginary(const RegularNumber& x) { return Gaussian{0, 1} * (conjugate(x) - x); }

Ball real_ball(const RegularNumber& x) {
  const auto [zeta, s] = x.ring->roots();
  return real(value_at(x.u, zeta)) + real(value_at(x.v, zeta)) * s;
}

int sign(const RegularNumber& x) {
  const RegularRing& ring = *x.ring;
  const bool no_v = ring.is_zero(x.v);
  if (ring.is_zero(x.u)) return no_v ? 0 : sign_of_nonzero({&ring, {}, x.v});
  if (ring.has_new_root() || no_v) return sign_of_nonzero(x);
  // If (u + vs)(u − vs) = 0, then u + vs = 0 or 2u.
  const RegularNumber other{&ring, x.u, negative(x.v)};
  if (!ring.is_zero((x * other).u)) return sign_of_nonzero(x);
  const int sign_of_u = sign_of_nonzero({&ring, x.u});
  return sign_of_nonzero({&ring, x.v}) == sign_of_u ? sign_of_u : 0;
}

}  // namespace epsnet::certify
