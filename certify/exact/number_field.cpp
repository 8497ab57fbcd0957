#include "certify/exact/number_field.h"

#include <algorithm>
#include <string>
#include <utility>

#include "certify/exact/plane.h"

namespace epsnet::exact {
namespace {

/// Of the polynomial and the ends of the interval, times the degree.
constexpr std::size_t kMaxBitsOfField = std::size_t{1} << 20;
constexpr mp_bitcnt_t kFirstBitsOfRoot = 128;

std::size_t bits_of(const Polynomial& x) {
  std::size_t sum = 0;
  for (const mpz_class& n : x) sum += bits(n);
  return sum;
}

std::size_t largest_bits(const Polynomial& x) {
  std::size_t most = 0;
  for (const mpz_class& n : x) most = std::max(most, bits(n));
  return most;
}

/// Of so many products of integers of so many bits, in units of half a nanosecond.
std::size_t work_of_products(std::size_t count, std::size_t bits_of_x, std::size_t bits_of_y) {
  return 4 * count * (1 + bits_of_x / 64) * (1 + bits_of_y / 64);
}

void make_primitive(Polynomial& x) {
  mpz_class common;
  for (const mpz_class& n : x) take_common(n, common);
  if (!x.empty() && sgn(x.back()) < 0) common = -common;
  for (mpz_class& n : x) divide(n, common);
}

Polynomial plain_product(const Polynomial& x, const Polynomial& y) {
  if (x.empty() || y.empty()) return {};
  Polynomial result(x.size() + y.size() - 1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      mpz_addmul(result[i + j].get_mpz_t(), x[i].get_mpz_t(), y[j].get_mpz_t());
    }
  }
  return result;
}

/// Of a division by a monic polynomial: leaves the rest in x.
Polynomial divide_by_monic(Polynomial& x, const Polynomial& divisor) {
  const std::size_t degree = divisor.size() - 1;
  Polynomial quotient(x.size() > degree ? x.size() - degree : 0);
  while (x.size() > degree) {
    mpz_class& top = quotient[x.size() - divisor.size()];
    top = std::move(x.back());
    x.pop_back();
    for (std::size_t i = 0; top != 0 && i < degree; ++i) {
      mpz_submul(x[x.size() - degree + i].get_mpz_t(), top.get_mpz_t(), divisor[i].get_mpz_t());
    }
  }
  trim(x);
  return quotient;
}

/// The primitive one of positive leading coefficient; y is not 0.
Polynomial greatest_common_divisor(Polynomial x, Polynomial y) {
  make_primitive(y);
  while (!y.empty()) {
    while (x.size() >= y.size()) {
      const mpz_class common = gcd(x.back(), y.back());
      const mpz_class of_x = y.back() / common;
      const mpz_class of_y = x.back() / common;
      for (mpz_class& n : x) n *= of_x;
      for (std::size_t i = 0; i < y.size(); ++i) x[x.size() - y.size() + i] -= of_y * y[i];
      trim(x);
    }
    make_primitive(x);
    std::swap(x, y);
  }
  return x;
}

/// (1 + x)^d f((L + Ux)/(1 + x)) times denominator^d, L = lower/denominator, U = upper/denominator.
Polynomial moved_to_positive(const Polynomial& f, const mpz_class& lower, const mpz_class& upper,
                             const mpz_class& denominator) {
  Polynomial result;
  Polynomial power{1};
  for (std::size_t k = f.size(); k-- > 0;) {
    result = sum(plain_product(result, {lower, upper}), plain_product({f[k]}, power));
    power = plain_product(power, {denominator, denominator});
  }
  return result;
}

int changes_of_sign(const Polynomial& x) {
  int changes = 0;
  int last = 0;
  for (const mpz_class& n : x) {
    if (sgn(n) * last < 0) ++changes;
    if (sgn(n) != 0) last = sgn(n);
  }
  return changes;
}

}  // namespace

NumberField::NumberField(Polynomial f, const mpq_class& lower, const mpq_class& upper, std::size_t work)
    : f_(std::move(f)), denominator_(lcm(lower.get_den(), upper.get_den())), work_left_(work), factor_(f_) {
  lower_ = lower.get_num() * (denominator_ / lower.get_den());
  upper_ = upper.get_num() * (denominator_ / upper.get_den());
  const std::size_t bits_of_interval = bits(lower_) + bits(upper_) + bits(denominator_);
  if (degree() * (bits_of(f_) + bits_of_interval) > kMaxBitsOfField) {
    throw TooLarge{"the numbers that say which field it is are too large"};
  }
  const Polynomial moved = moved_to_positive(f_, lower_, upper_, denominator_);
  const int changes = changes_of_sign(moved);
  if (changes == 0) throw Refutation{"the polynomial has no root in the interval"};
  if (changes > 1) {
    throw TooLarge{"the polynomial may have several roots in the interval, by " + std::to_string(changes) +
                   " changes of sign: give a shorter one"};
  }
  const auto first = std::find_if(moved.begin(), moved.end(), [](const mpz_class& n) { return n != 0; });
  sign_below_ = sgn(*first);
  exponent_ = -static_cast<long>(bits_of_interval);
  floor_ = compare(0, 0) < 0 ? -1 : 0;
}

void NumberField::spend(std::size_t work) const {
  if (work > work_left_) throw TooLarge{"its numbers, of degree " + std::to_string(degree()) + ", take too much work"};
  work_left_ -= work;
}

Integers NumberField::name() const {
  Integers result = f_;
  result.insert(result.end(), {lower_, upper_, denominator_});
  return result;
}

/// A root z of x^d + Σ f_(d−i) x^(d−i) is at most 2 max |f_(d−i)|^(1/i): else Σ |f_(d−i) z^(d−i)| < |z|^d Σ 2^−i.
std::size_t NumberField::bits_of_roots() const {
  std::size_t most = 0;
  for (std::size_t i = 1; i <= degree(); ++i) most = std::max(most, (bits(f_[degree() - i]) + i - 1) / i);
  return most + 1;
}

Polynomial NumberField::reduced(Polynomial x) const {
  divide_by_monic(x, factor_);
  return x;
}

Polynomial NumberField::product(const Polynomial& x, const Polynomial& y) const {
  const Polynomial plain = plain_product(x, y);
  Polynomial result = reduced(plain);
  spend(work_of_products(x.size() * y.size(), largest_bits(x), largest_bits(y)));
  if (plain.size() >= factor_.size()) {
    const std::size_t steps = plain.size() - factor_.size() + 1;
    spend(work_of_products(steps * factor_.size(), largest_bits(factor_), largest_bits(result)));
  }
  return result;
}

mpz_class NumberField::scaled_value(const mpz_class& n, long e) const {
  if (e < 0) return scaled_value(n << static_cast<mp_bitcnt_t>(-e), 0);
  const auto shift = static_cast<mp_bitcnt_t>(e);
  spend(degree() * degree() * (bits(n) + shift));
  mpz_class value = f_.back();
  for (std::size_t i = 1; i < f_.size(); ++i) value = value * n + (f_[f_.size() - 1 - i] << (i * shift));
  return value;
}

int NumberField::compare(const mpz_class& n, long e) const {
  const mpz_class scaled = (n << static_cast<mp_bitcnt_t>(std::max(-e, 0L))) * denominator_;
  const auto end = static_cast<mp_bitcnt_t>(std::max(e, 0L));
  if (scaled <= lower_ << end) return 1;
  if (scaled >= upper_ << end) return -1;
  return sgn(scaled_value(n, e)) * sign_below_;
}

/// Quadratic interval refinement: where the secant is 0 there will be the root, up to step_ bits, and twice as many
/// next time; if it is not there, the interval is halved. Whatever is guessed, compare decides.
void NumberField::refine() const {
  const mpz_class left = scaled_value(floor_, exponent_);
  const mpz_class drop = left - scaled_value(floor_ + 1, exponent_);
  const mpz_class last = (mpz_class(1) << step_) - 1;
  mpz_class part = 0;
  if (drop != 0) mpz_fdiv_q(part.get_mpz_t(), mpz_class(left << step_).get_mpz_t(), drop.get_mpz_t());
  part = std::clamp<mpz_class>(part, 0, last);
  const mpz_class guess = (floor_ << step_) + part;
  const long finer = exponent_ + static_cast<long>(step_);
  if (compare(guess, finer) >= 0 && compare(guess + 1, finer) < 0) {
    floor_ = guess;
    exponent_ = finer;
    step_ *= 2;
    return;
  }
  const mpz_class middle = 2 * floor_ + 1;
  ++exponent_;
  floor_ = compare(middle, exponent_) >= 0 ? middle : mpz_class(2 * floor_);
  step_ = std::max(step_ / 2, 1UL);
}

mpz_class NumberField::root(mp_bitcnt_t bits) const {
  while (exponent_ < static_cast<long>(bits)) refine();
  return floor_ >> (static_cast<mp_bitcnt_t>(exponent_) - bits);
}

const std::vector<Approximation>& NumberField::powers(mp_bitcnt_t bits) const {
  const auto found = powers_.find(bits);
  if (found != powers_.end()) return found->second;
  const mpz_class n = root(bits);
  const mpz_class most = abs(n) + 1;
  spend(work_of_products(degree(), exact::bits(n), exact::bits(n)));
  std::vector<Approximation> powers{{mpz_class(1) << bits, 0}};
  while (powers.size() < degree()) {
    // |v n − V A| <= |v| |n − A| + |A| |v − V|, and |n − A| <= 1.
    const Approximation& last = powers.back();
    powers.push_back({(last.value * n) >> bits, ((abs(last.value) + most * last.error) >> bits) + 2});
  }
  return powers_.emplace(bits, std::move(powers)).first->second;
}

Approximation NumberField::approximation(const Polynomial& x, mp_bitcnt_t bits) const {
  const std::vector<Approximation>& powers = this->powers(bits);
  spend(work_of_products(2 * x.size(), largest_bits(x), bits));
  Approximation result;
  for (std::size_t i = 0; i < x.size(); ++i) {
    result.value += x[i] * powers[i].value;
    result.error += abs(x[i]) * powers[i].error;
  }
  return result;
}

bool NumberField::excludes_zero(const Polynomial& x, mp_bitcnt_t bits) const {
  const Approximation found = approximation(x, bits);
  return abs(found.value) > found.error;
}

bool NumberField::is_zero(const Polynomial& x) const {
  Polynomial rest = reduced(x);
  if (rest.empty()) return true;
  // As of a determinant of so many rows, of so many bits each.
  spend(degree() * degree() * degree() * (largest_bits(rest) + largest_bits(factor_)));
  const Polynomial h = greatest_common_divisor(factor_, rest);
  if (h.size() == 1) return false;
  // It divides a monic polynomial, so it is monic.
  Polynomial k = factor_;
  k = divide_by_monic(k, h);
  for (mp_bitcnt_t bits = kFirstBitsOfRoot;; bits *= 2) {
    const bool is_not_zero = excludes_zero(h, bits);
    if (!is_not_zero && !excludes_zero(k, bits)) continue;
    factor_ = is_not_zero ? k : h;
    return !is_not_zero;
  }
}

FieldNumber::FieldNumber(const NumberField& field, const Polynomial& x) : field_(&field), x_(field.reduced(x)) {}

FieldNumber operator+(const FieldNumber& x, const FieldNumber& y) {
  FieldNumber result = x.field_ == nullptr ? y : x;
  const FieldNumber& other = x.field_ == nullptr ? x : y;
  result.x_ = sum(std::move(result.x_), other.x_);
  return result;
}

FieldNumber operator-(const FieldNumber& x, const FieldNumber& y) { return x + (-y); }

FieldNumber operator-(const FieldNumber& x) {
  FieldNumber result = x;
  for (mpz_class& n : result.x_) n = -n;
  return result;
}

FieldNumber operator*(const FieldNumber& x, const FieldNumber& y) {
  FieldNumber result = x.field_ == nullptr ? y : x;
  result.x_ = x.is_integer() || y.is_integer() ? plain_product(x.x_, y.x_) : result.field_->product(x.x_, y.x_);
  return result;
}

int sgn(const FieldNumber& x) {
  if (x.is_integer()) return x.x_.empty() ? 0 : sgn(x.x_[0]);
  const mp_bitcnt_t usual = 2 * largest_bits(x.x_);
  bool may_be_zero = true;
  for (mp_bitcnt_t bits = kFirstBitsOfRoot;; bits *= 2) {
    const Approximation found = x.field_->approximation(x.x_, bits);
    if (abs(found.value) > found.error) return sgn(found.value);
    if (bits < usual || !may_be_zero) continue;
    if (x.field_->is_zero(x.x_)) return 0;
    may_be_zero = false;
  }
}

Interval enclosure(const FieldNumber& x) {
  if (sgn(x) == 0) return 0;
  if (x.is_integer()) return Interval(mpq_class(x.x_[0]));
  for (mp_bitcnt_t bits = 2 * kFirstBitsOfRoot;; bits *= 2) {
    const Approximation found = x.field_->approximation(x.x_, bits);
    if (abs(found.value) > found.error << Interval::kBits) {
      return {found.value - found.error, found.value + found.error, static_cast<mpfr_exp_t>(bits)};
    }
  }
}

RealNumber real_number(const FieldNumber& x) {
  if (x.is_integer()) return real_number(x.x_.empty() ? mpz_class(0) : x.x_[0]);
  return {1, x.field_->degree(), sum_bits(x.x_) + (x.x_.size() - 1) * x.field_->bits_of_roots(),
          [x](mp_bitcnt_t k) { return x.field_->approximation(x.x_, k); }, x.field_->name()};
}

void take_common(const FieldNumber& x, mpz_class& common) {
  for (const mpz_class& n : x.x_) take_common(n, common);
}

void divide(FieldNumber& x, const mpz_class& divisor) {
  for (mpz_class& n : x.x_) divide(n, divisor);
}

std::size_t bits(const FieldNumber& x) {
  const std::size_t sum = 1 + bits_of(x.x_);
  return x.is_integer() ? sum : sum * x.field_->degree();
}

}  // namespace epsnet::exact
