#include "certify/exact/algebraic.h"

#include <algorithm>
#include <cstdlib>
#include <mpfr.h>
#include <numeric>
#include <string>
#include <utility>

#include "certify/exact/plane.h"

namespace epsnet::exact {
namespace {

constexpr mp_bitcnt_t kFirstBits = 128;

/// The prime numbers that divide n, each once.
std::vector<unsigned long> primes_of(unsigned long n) {
  std::vector<unsigned long> primes;
  for (unsigned long p = 2; n > 1; ++p) {
    if (p * p > n) p = n;
    if (n % p == 0) primes.push_back(p);
    while (n % p == 0) n /= p;
  }
  return primes;
}

unsigned long euler_phi(unsigned long n) {
  unsigned long phi = n;
  for (const unsigned long prime : primes_of(n)) phi -= phi / prime;
  return phi;
}

/// The cyclotomic polynomial Π (1 − x^d)^μ(n/d), d | n, n > 1: the coefficients of 1, x, …, x^h, 2h its degree.
std::vector<long> half_of_cyclotomic(unsigned long n, const std::vector<unsigned long>& primes, std::size_t h) {
  std::vector<long> series(h + 1);
  series[0] = 1;
  for (unsigned long subset = 0; subset < 1UL << primes.size(); ++subset) {
    unsigned long d = n;
    bool divides = false;
    for (std::size_t i = 0; i < primes.size(); ++i) {
      if ((subset >> i & 1) == 0) continue;
      d /= primes[i];
      divides = !divides;
    }
    if (divides) {
      for (std::size_t k = d; k <= h; ++k) series[k] += series[k - d];
    } else {
      for (std::size_t k = h; k >= d; --k) series[k] -= series[k - d];
    }
  }
  return series;
}

}  // namespace

std::size_t degree_of_cosines(unsigned long n) { return n <= 2 ? 1 : euler_phi(n) / 2; }

RealField::RealField(unsigned long p, unsigned long q, bool half_turns)
    : p_(p), q_(q), n_(std::lcm(4UL, std::lcm(q, half_turns ? 2 * p : p))) {
  const std::vector<unsigned long> primes = primes_of(n_);
  const std::size_t phi = euler_phi(n_);
  if (phi / 2 > kMaxDegree) {
    throw TooLarge{"the numbers of its tiles are of degree " + std::to_string(phi / 2) + ", more than " +
                   std::to_string(kMaxDegree)};
  }
  relation_ = half_of_cyclotomic(n_, primes, phi / 2);
  std::reverse(relation_.begin(), relation_.end());
  const Algebraic c_p = cosine(static_cast<long>(n_ / p_));
  const Algebraic c_q = cosine(static_cast<long>(n_ / q_));
  square_of_s_ = ((2 - c_q) * (c_p + c_q)).u();
}

Algebraic RealField::cosine(long k) const {
  const auto order = static_cast<long>(n_);
  k = std::abs(k) % order;
  k = std::min(k, order - k);
  if (k == 0) return 2;
  Cosines x(static_cast<std::size_t>(k) + 1);
  x.back() = 1;
  reduce(x);
  return {*this, x, {}};
}

Algebraic RealField::s() const { return {*this, {}, {1}}; }

void RealField::reduce(Cosines& x) const {
  const auto h = static_cast<long>(degree());
  for (auto m = static_cast<long>(x.size()) - 1; m >= h; --m) {
    const mpz_class top = std::exchange(x[static_cast<std::size_t>(m)], 0);
    if (top == 0) continue;
    // With P = Σ r_|j| ζ^j = 0: less top · P for m = h, else top · (ζ^i + ζ^−i) P, i = m − h. The numbers of ζ^k, k >=
    // 0.
    for (const long i : {m - h, h - m}) {
      for (long j = -h; j <= h; ++j) {
        const long r = relation_[static_cast<std::size_t>(std::abs(j))];
        if (r != 0 && i + j >= 0 && i + j < m) x[static_cast<std::size_t>(i + j)] -= r * top;
      }
      if (m == h) break;
    }
  }
  trim(x);
}

Cosines RealField::product(const Cosines& x, const Cosines& y) const {
  if (x.empty() || y.empty()) return {};
  Cosines result(x.size() + y.size() - 1);
  mpz_class term;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      term = x[i] * y[j];
      result[i + j] += term;
      // 2cos α · 2cos β = 2cos(α + β) + 2cos(α − β).
      if (i > 0 && j > 0) result[i > j ? i - j : j - i] += i == j ? mpz_class(2 * term) : term;
    }
  }
  reduce(result);
  return result;
}

const std::vector<mpz_class>& RealField::values(mp_bitcnt_t bits) const {
  const auto [found, is_new] = values_.try_emplace(bits);
  std::vector<mpz_class>& values = found->second;
  if (!is_new) return values;
  // 64 bits more than are asked for: the few roundings, of numbers below 8, add up to less than 2^−(bits + 50). The
  // root magnifies that by less than 2^20, as s² > 2^−30: p and q are at most 10,000.
  mpfr_t angle, cosine, cosine_p, cosine_q;
  mpfr_inits2(static_cast<mpfr_prec_t>(bits) + 64, angle, cosine, cosine_p, cosine_q, nullptr);
  const auto set_cosine = [&](mpfr_t result, unsigned long k) {  // 2cos(2πk/n), k < n.
    mpfr_const_pi(angle, MPFR_RNDN);
    mpfr_mul_ui(angle, angle, 2 * k, MPFR_RNDN);
    mpfr_div_ui(angle, angle, n_, MPFR_RNDN);
    mpfr_cos(result, angle, MPFR_RNDN);
    mpfr_mul_2ui(result, result, 1, MPFR_RNDN);
  };
  const auto keep = [&](mpfr_t x) {
    mpfr_mul_2ui(x, x, bits, MPFR_RNDN);
    values.emplace_back();
    mpfr_get_z(values.back().get_mpz_t(), x, MPFR_RNDN);
  };
  values.emplace_back(mpz_class(1) << bits);
  for (unsigned long k = 1; k < degree(); ++k) {
    set_cosine(cosine, k);
    keep(cosine);
  }
  set_cosine(cosine_p, n_ / p_);
  set_cosine(cosine_q, n_ / q_);
  mpfr_add(cosine_p, cosine_p, cosine_q, MPFR_RNDN);
  mpfr_ui_sub(cosine_q, 2, cosine_q, MPFR_RNDN);
  mpfr_mul(cosine, cosine_p, cosine_q, MPFR_RNDN);
  mpfr_sqrt(cosine, cosine, MPFR_RNDN);
  keep(cosine);
  mpfr_clears(angle, cosine, cosine_p, cosine_q, nullptr);
  return values;
}

Algebraic::Algebraic(const mpz_class& n) : u_{n} { trim(u_); }
Algebraic::Algebraic(const RealField& field, Cosines u, Cosines v)
    : field_(&field), u_(std::move(u)), v_(std::move(v)) {}

Algebraic operator+(const Algebraic& x, const Algebraic& y) {
  Algebraic result = x.field_ == nullptr ? y : x;
  const Algebraic& other = x.field_ == nullptr ? x : y;
  result.u_ = sum(std::move(result.u_), other.u_);
  result.v_ = sum(std::move(result.v_), other.v_);
  return result;
}

Algebraic operator-(const Algebraic& x, const Algebraic& y) { return x + (-y); }

Algebraic operator-(const Algebraic& x) {
  Algebraic result = x;
  for (Cosines* part : {&result.u_, &result.v_}) {
    for (mpz_class& n : *part) n = -n;
  }
  return result;
}

Algebraic operator*(const Algebraic& x, const Algebraic& y) {
  const RealField* field = x.field_ == nullptr ? y.field_ : x.field_;
  if (field == nullptr) return x.u_.empty() || y.u_.empty() ? 0 : Algebraic(mpz_class(x.u_[0] * y.u_[0]));
  const auto times = [&](const Cosines& a, const Cosines& b) { return field->product(a, b); };
  return {*field, sum(times(x.u_, y.u_), times(times(x.v_, y.v_), field->square_of_s())),
          sum(times(x.u_, y.v_), times(x.v_, y.u_))};
}

Approximation Algebraic::approximation(mp_bitcnt_t bits) const {
  const std::vector<mpz_class>& values = field_->values(bits);
  const auto linear = [&](const Cosines& x) {
    Approximation result;
    for (std::size_t i = 0; i < x.size(); ++i) {
      result.value += x[i] * values[i];
      result.error += abs(x[i]);
    }
    return result;
  };
  const Approximation u = linear(u_);
  const Approximation v = linear(v_);
  // |v s − V S| <= |v| |s − S| + S |v − V|.
  const mpz_class& root = values.back();
  return {(u.value << bits) + v.value * root, (u.error << bits) + abs(v.value) + v.error * (root + 1)};
}

int sgn(const Algebraic& x) {
  if (x.u_.empty() && x.v_.empty()) return 0;
  if (x.is_integer()) return sgn(x.u_[0]);
  for (mp_bitcnt_t bits = kFirstBits;; bits *= 2) {
    const Approximation found = x.approximation(bits);
    if (abs(found.value) > found.error) return sgn(found.value);
    if (bits > kFirstBits || x.u_.empty() || x.v_.empty()) continue;
    // Lemma 9: u + vs = 0 only if u² = v²s², and then it is 0 or 2u.
    const Algebraic u(*x.field_, x.u_, {});
    const Algebraic v(*x.field_, x.v_, {});
    const Algebraic difference = u * u - v * v * Algebraic(*x.field_, x.field_->square_of_s(), {});
    if (difference.u_.empty()) return sgn(u) == sgn(v) ? sgn(u) : 0;
  }
}

Interval enclosure(const Algebraic& x) {
  if (sgn(x) == 0) return 0;
  if (x.is_integer()) return Interval(mpq_class(x.u_[0]));
  for (mp_bitcnt_t bits = 2 * kFirstBits;; bits *= 2) {
    const Approximation found = x.approximation(bits);
    if (abs(found.value) > found.error << Interval::kBits) {
      return {found.value - found.error, found.value + found.error, static_cast<mpfr_exp_t>(2 * bits)};
    }
  }
}

RealNumber real_number(const Algebraic& x) {
  if (x.is_integer()) return real_number(x.u_.empty() ? mpz_class(0) : x.u_[0]);
  // Cosines are at most 2, and so are their conjugates; those of s are roots of the conjugates of s².
  const std::size_t bits_of_s = (sum_bits(x.field_->square_of_s()) + 1) / 2 + 1;
  return {x.field_->n(), x.v_.empty() ? 1U : 2U, std::max(sum_bits(x.u_) + 1, sum_bits(x.v_) + 1 + bits_of_s) + 1,
          [x](mp_bitcnt_t k) {
            const Approximation found = x.approximation(k);
            return Approximation{found.value >> k, (found.error >> k) + 2};
          },
          x.field_->name()};
}

void take_common(const Algebraic& x, mpz_class& common) {
  for (const mpz_class& n : x.u_) take_common(n, common);
  for (const mpz_class& n : x.v_) take_common(n, common);
}

void divide(Algebraic& x, const mpz_class& divisor) {
  for (mpz_class& n : x.u_) divide(n, divisor);
  for (mpz_class& n : x.v_) divide(n, divisor);
}

std::size_t bits(const Algebraic& x) {
  std::size_t sum = 1;
  for (const Cosines* part : {&x.u_, &x.v_}) {
    for (const mpz_class& n : *part) sum += bits(n);
  }
  return x.is_integer() ? sum : sum * x.field_->degree();
}

}  // namespace epsnet::exact
