#include "certify/numbers/field_number.h"

#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif
#include <algorithm>
#include <limits>
#include <utility>

namespace epsnet::certify {
namespace {

/// Of the first enclosure of a root, which bisection finds; Newton's method goes on.
constexpr slong kFirstRootBits = 64;

std::uint64_t length(const Polynomial& x) { return static_cast<std::uint64_t>(fmpz_poly_length(x.get())); }

/// The work of a product of polynomials, which FLINT packs into one integer each.
std::uint64_t polynomial_product_work(const Polynomial& x, const Polynomial& y) {
  const std::uint64_t longer = std::max(length(x), length(y));
  const std::uint64_t bits =
      bits_of_coefficients(x) + bits_of_coefficients(y) + static_cast<std::uint64_t>(std::bit_width(longer));
  return product_work(2 * longer * bits) + 40 * longer;
}

/// The work of the remainder of x by f, which is monic and not longer: a coefficient of the quotient after the other is
/// multiplied with all of f, and each may have as many bits more as those of f have.
std::uint64_t remainder_work(const Polynomial& x, const Polynomial& f) {
  const std::uint64_t quotient = length(x) - length(f) + 1;
  const std::uint64_t limbs_of_quotient = (bits_of_coefficients(x) + quotient * bits_of_coefficients(f) / 2) / 64 + 1;
  const std::uint64_t limbs_of_f = bits_of_coefficients(f) / 64 + 1;
  return polynomial_product_work(x, f) + quotient * length(f) * (20 + 2 * limbs_of_quotient * limbs_of_f);
}

/// The work of a greatest common divisor of x and f: that of short ones is found by subresultants, whose coefficients
/// grow.
std::uint64_t divisor_work(const Polynomial& x, const Polynomial& f) {
  constexpr std::uint64_t kShort = 6;
  return length(f) *
         (1500 + (length(f) < kShort ? 50 : 15) * product_work(bits_of_coefficients(x) + bits_of_coefficients(f)));
}

Polynomial polynomial(const std::vector<mpz_class>& coefficients) {
  Polynomial result;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    fmpz_poly_set_coeff_fmpz(result.get(), static_cast<slong>(i), Integer(coefficients[i]).get());
  }
  return result;
}

/// In balls of as many bits as there are.
Ball evaluated(const Polynomial& x, const Ball& at) {
  Ball result;
  arb_fmpz_poly_evaluate_arb(result.get(), x.get(), at.get(), Precision::bits());
  return result;
}

Ball midpoint(Ball x) {
  arb_get_mid_arb(x.get(), x.get());
  return x;
}

Ball hull(const mpq_class& lower, const mpq_class& upper) {
  const Ball first = Ball::rounded(lower);
  const Ball last = Ball::rounded(upper);
  Ball result;
  arb_union(result.get(), first.get(), last.get(), Precision::bits());
  return result;
}

/// Whether x is known to within a third of its size.
bool is_steady(const Ball& x) { return certainly_positive(abs(x) - 3 * abs(x - midpoint(x))) == Tri::yes; }

/// Of two balls that meet.
Ball intersection(const Ball& x, const Ball& y) {
  Ball result;
  arb_intersection(result.get(), x.get(), y.get(), Precision::bits());
  return result;
}

Ball radius(const Ball& x) {
  Ball result;
  arb_get_rad_arb(result.get(), x.get());
  return result;
}

/// Whether x is narrower than y by a quarter at least.
bool is_narrower(const Ball& x, const Ball& y) { return certainly_positive(3 * radius(y) - 4 * radius(x)) == Tri::yes; }

bool is_known_to(const Ball& x, slong bits) { return mag_cmp_2exp_si(arb_radref(x.get()), -bits) <= 0; }

Polynomial product(const NumberField& field, const Polynomial& x, const Polynomial& y) {
  Polynomial result;
  if (is_zero(x) || is_zero(y)) return result;
  field.budget().spend(polynomial_product_work(x, y));
  fmpz_poly_mul(result.get(), x.get(), y.get());
  field.reduce(result);
  return result;
}

/// The sign of the value, if balls of so many bits tell it; 0 if not.
int sign_in_balls(const NumberField& field, const Polynomial& x, slong precision) {
  field.budget().spend(ball_work(static_cast<std::uint64_t>(precision)), field.degree());
  return certain_sign(field.value(x));
}

}  // namespace

RootCount count_roots(const std::vector<mpz_class>& f, const mpq_class& lower, const mpq_class& upper) {
  // With L = l/m and U = u/m the coefficients are those of Σ f_i (l + ux)^i (m + mx)^(d − i), up to m^d.
  const mpz_class m = lcm(lower.get_den(), upper.get_den());
  const Polynomial ends =
      polynomial({lower.get_num() * (m / lower.get_den()), upper.get_num() * (m / upper.get_den())});
  const Polynomial scale = polynomial({m, m});
  Polynomial result;
  Polynomial power = polynomial({1});
  for (std::size_t i = f.size(); i-- > 0;) {
    fmpz_poly_mul(result.get(), result.get(), ends.get());
    result = sum(std::move(result), multiple(f[i], power));
    fmpz_poly_mul(power.get(), power.get(), scale.get());
  }
  RootCount count;
  int last = 0;
  for (slong i = 0; i < fmpz_poly_length(result.get()); ++i) {
    const int sign = fmpz_sgn(fmpz_poly_get_coeff_ptr(result.get(), i));
    if (sign == 0) continue;
    if (last == 0) count.first_sign = sign;
    if (sign == -last) ++count.changes;
    last = sign;
  }
  return count;
}

namespace {

/// Of f(x).

int sign_at(const std::vector<mpz_class>& f, const mpq_class& x) {
  mpz_class value;
  mpz_class power = 1;
  for (std::size_t i = f.size(); i-- > 0;) {
    value = value * x.get_num() + f[i] * power;
    power *= x.get_den();
  }
  return sgn(value);
}

}  // namespace

NumberField::NumberField(const std::vector<mpz_class>& f, const std::array<mpq_class, 2>& between, Budget budget)
    : f_(polynomial(f)), between_(between), budget_(std::move(budget)) {
  fmpz_poly_derivative(derivative_.get(), f_.get());
  auto [lower, upper] = between;
  const int below = count_roots(f, lower, upper).first_sign;
  // Bisection, until the derivative hardly changes between the two.
  for (slong bits = kFirstRootBits;; ++bits) {
    const Precision scope(4 * bits);
    const Ball x = hull(lower, upper);
    if (is_known_to(x, kFirstRootBits) && is_steady(evaluated(derivative_, x))) {
      roots_.emplace(kFirstRootBits, x);
      return;
    }
    const mpq_class middle = (lower + upper) / 2;
    budget_.spend(product_work(f.size() * (bits_of_coefficients(f_) + mpz_sizeinbase(middle.get_den_mpz_t(), 2) +
                                           mpz_sizeinbase(middle.get_num_mpz_t(), 2))),
                  f.size());
    const int at_middle = sign_at(f, middle);
    if (at_middle != -below) lower = middle;
    if (at_middle != below) upper = middle;
  }
}

Ball NumberField::root(slong bits) const {
  const std::lock_guard lock(mutex_);
  // Twice as many bits each time, so that neither the ball nor the work depends on what was asked for before.
  while (roots_.rbegin()->first < bits) refine();
  return roots_.lower_bound(bits)->second;
}

void NumberField::refine() const {
  const slong bits = 2 * roots_.rbegin()->first;
  Ball x = roots_.rbegin()->second;
  // α = m − f(m)/f′(y) for any m and some y between m and α: each step at least halves the error, near the end squares
  // it; unless f(m) is not known well enough, as large coefficients cancel.
  for (slong precision = bits + 64; !is_known_to(x, bits);) {
    budget_.spend(4 * ball_work(static_cast<std::uint64_t>(precision)), degree());
    const Precision scope(precision);
    const Ball m = midpoint(x);
    const Ball closer = intersection(x, m - evaluated(f_, m) / evaluated(derivative_, x));
    if (is_narrower(closer, x)) {
      x = closer;
    } else {
      precision += precision / 2;
    }
  }
  roots_.emplace(bits, x);
}

Ball NumberField::value(const Polynomial& x) const {
  const slong precision = Precision::bits();
  const Precision scope(precision + 32);
  return evaluated(x, root(precision + 32));
}

void NumberField::reduce(Polynomial& x) const {
  if (length(x) < length(f_)) return;
  budget_.spend(remainder_work(x, f_));
  fmpz_poly_rem(x.get(), x.get(), f_.get());
}

FieldNumber field_number(const NumberField& field, const Gaussian& x) {
  return {&field, polynomial({x.re}), polynomial({x.im})};
}

FieldNumber field_number(const NumberField& field, const std::vector<mpz_class>& coefficients) {
  return {&field, polynomial(coefficients)};
}

FieldNumber operator+(FieldNumber x, FieldNumber y) {
  return {x.field, sum(std::move(x.re), std::move(y.re)), sum(std::move(x.im), std::move(y.im))};
}

FieldNumber operator-(FieldNumber x, FieldNumber y) {
  return std::move(x) + FieldNumber{y.field, negative(std::move(y.re)), negative(std::move(y.im))};
}

FieldNumber operator*(const FieldNumber& x, const FieldNumber& y) {
  const auto times = [&](const Polynomial& p, const Polynomial& q) { return product(*x.field, p, q); };
  return {x.field, sum(times(x.re, y.re), negative(times(x.im, y.im))), sum(times(x.re, y.im), times(x.im, y.re))};
}

FieldNumber operator*(const mpz_class& x, const FieldNumber& y) {
  return {y.field, multiple(x, y.re), multiple(x, y.im)};
}

FieldNumber operator*(const Gaussian& x, const FieldNumber& y) {
  return {y.field, sum(multiple(x.re, y.re), negative(multiple(x.im, y.im))),
          sum(multiple(x.re, y.im), multiple(x.im, y.re))};
}

FieldNumber conjugate(FieldNumber x) { return {x.field, std::move(x.re), negative(std::move(x.im))}; }

FieldNumber norm(const FieldNumber& x) {
  return {x.field, sum(product(*x.field, x.re, x.re), product(*x.field, x.im, x.im))};
}

FieldNumber twice_real(const FieldNumber& x) { return {x.field, multiple(2, x.re)}; }

FieldNumber twice_imaginary(const FieldNumber& x) { return {x.field, multiple(2, x.im)}; }

int sign(const FieldNumber& x) {
  const NumberField& field = *x.field;
  if (fmpz_poly_length(x.re.get()) <= 1) return is_zero(x.re) ? 0 : fmpz_sgn(fmpz_poly_lead(x.re.get()));
  int result = 0;
  const slong first = 64 + 2 * static_cast<slong>(bits_of_coefficients(x.re));
  {
    const Precision scope(first);
    result = sign_in_balls(field, x.re, first);
  }
  if (result != 0) return result;
  // Of x and f: the greatest common divisor and what is left of f. One of them is 0 at α, and not both.
  field.budget().spend(divisor_work(x.re, field.f()));
  Polynomial divisor;
  fmpz_poly_gcd(divisor.get(), x.re.get(), field.f().get());
  Polynomial rest;
  fmpz_poly_div(rest.get(), field.f().get(), divisor.get());
  bool zero = false;
  const auto attempt = [&](slong precision) {
    zero = sign_in_balls(field, rest, precision) != 0;
    result = sign_in_balls(field, x.re, precision);
    return zero || result != 0;
  };
  with_rising_precision(std::numeric_limits<slong>::max() / 2, attempt, first);
  return zero ? 0 : result;
}

std::size_t bits(const FieldNumber& x) {
  const auto size = [](const Polynomial& p) {
    return static_cast<std::size_t>(fmpz_poly_length(p.get())) * (8 + bits_of_coefficients(p));
  };
  return size(x.re) + size(x.im);
}

Ball real_ball(const FieldNumber& x) {
  const slong precision = Precision::bits();
  const Precision scope(precision + 2 * static_cast<slong>(bits_of_coefficients(x.re)));
  x.field->budget().spend(ball_work(static_cast<std::uint64_t>(Precision::bits())), x.field->degree());
  return x.field->value(x.re);
}

void reduce(Isometry<FieldNumber>& f) {
  Integer common;
  for (const Polynomial* x : {&f.a.re, &f.a.im, &f.b.re, &f.b.im}) {
    Integer content;
    fmpz_poly_content(content.get(), x->get());
    fmpz_gcd(common.get(), common.get(), content.get());
  }
  if (fmpz_cmp_si(common.get(), 1) <= 0) return;
  for (Polynomial* x : {&f.a.re, &f.a.im, &f.b.re, &f.b.im}) {
    fmpz_poly_scalar_divexact_fmpz(x->get(), x->get(), common.get());
  }
}

BallIsometry to_balls(const Isometry<FieldNumber>& f, const FieldNumber& determinant, slong precision) {
  const Precision scope(precision + 32);
  const Ball scale = rsqrt(real_ball(determinant));
  const auto part = [&](const Polynomial& x) { return scale * real_ball({f.a.field, x}); };
  BallIsometry result;
  arb_set_round(result.a.re(), part(f.a.re).get(), precision);
  arb_set_round(result.a.im(), part(f.a.im).get(), precision);
  arb_set_round(result.b.re(), part(f.b.re).get(), precision);
  arb_set_round(result.b.im(), part(f.b.im).get(), precision);
  return result;
}

}  // namespace epsnet::certify
