#pragma once

#include <array>
#include <gmpxx.h>
#include <mpfr.h>
#include <optional>
#include <string>
#include <vector>

/// Intervals whose ends MPFR rounds outward. What is not a number stays so, and comparisons with it are unknown.
namespace epsnet::exact {

// Numbers compared with sinh² of rational numbers.

/// What is wrong with the claim.
struct Refutation {
  std::string what;
};

/// A question that is too large for exact numbers, or too close for the digits used.
struct TooLarge {
  std::string what;
};

/// A question that is left to others, for what the file says or for its size.
struct LeftOut {
  std::string what;
};

enum class Answer { no, yes, unknown };

[[nodiscard]] inline Answer operator!(Answer x) {
  return x == Answer::unknown ? x : x == Answer::yes ? Answer::no : Answer::yes;
}
[[nodiscard]] inline Answer both(Answer x, Answer y) {
  if (x == Answer::no || y == Answer::no) return Answer::no;
  return x == Answer::yes && y == Answer::yes ? Answer::yes : Answer::unknown;
}
[[nodiscard]] inline Answer either(Answer x, Answer y) { return !both(!x, !y); }

/// Numbers below and above sinh²x, lower/2^k and upper/2^k.
struct SquaredSinh {
  mpz_class lower;
  mpz_class upper;
  mp_bitcnt_t k = 0;
};

/// 0 <= x. To 256 bits. Throws TooLarge if x is more than 1000 or close to 0.
[[nodiscard]] SquaredSinh squared_sinh(const mpq_class& x);

/// Whether numerator/denominator < sinh²x, numerator >= 0; no if the denominator is not positive. The two are equal
/// only if both are 0.
template <class R>
[[nodiscard]] Answer is_less(const R& numerator, const R& denominator, const SquaredSinh& s) {
  const R scaled = mpz_class(mpz_class(1) << s.k) * numerator;
  if (sgn(R(scaled - s.lower * denominator)) < 0) return Answer::yes;
  return sgn(R(scaled - s.upper * denominator)) >= 0 ? Answer::no : Answer::unknown;
}

class Interval {
 public:
  static constexpr mpfr_prec_t kBits = 384;

  Interval() { begin(); }
  Interval(long n) {  // NOLINT(google-explicit-constructor): numbers in formulas.
    begin();
    mpfr_set_si(lower_, n, MPFR_RNDD);
    mpfr_set_si(upper_, n, MPFR_RNDU);
  }
  explicit Interval(const mpq_class& x) {
    begin();
    mpfr_set_q(lower_, x.get_mpq_t(), MPFR_RNDD);
    mpfr_set_q(upper_, x.get_mpq_t(), MPFR_RNDU);
  }
  /// From lower/2^exponent to upper/2^exponent.
  Interval(const mpz_class& lower, const mpz_class& upper, mpfr_exp_t exponent) {
    begin();
    mpfr_set_z_2exp(lower_, lower.get_mpz_t(), -exponent, MPFR_RNDD);
    mpfr_set_z_2exp(upper_, upper.get_mpz_t(), -exponent, MPFR_RNDU);
  }
  Interval(const Interval& other) {
    begin();
    *this = other;
  }
  Interval& operator=(const Interval& other) {
    mpfr_set(lower_, other.lower_, MPFR_RNDD);
    mpfr_set(upper_, other.upper_, MPFR_RNDU);
    return *this;
  }

  friend Interval operator+(const Interval& x, const Interval& y) {
    Interval z;
    mpfr_add(z.lower_, x.lower_, y.lower_, MPFR_RNDD);
    mpfr_add(z.upper_, x.upper_, y.upper_, MPFR_RNDU);
    return z;
  }
  friend Interval operator-(const Interval& x) {
    Interval z;
    mpfr_neg(z.lower_, x.upper_, MPFR_RNDD);
    mpfr_neg(z.upper_, x.lower_, MPFR_RNDU);
    return z;
  }
  friend Interval operator-(const Interval& x, const Interval& y) { return x + (-y); }
  friend Interval operator*(const Interval& x, const Interval& y) {
    const bool positive = mpfr_sgn(y.lower_) >= 0;
    if (!positive && mpfr_sgn(y.upper_) > 0) {
      const bool both_signs = mpfr_sgn(x.lower_) < 0 && mpfr_sgn(x.upper_) > 0;
      return both_signs ? hull_of(mpfr_mul, x, y) : y * x;
    }
    // y has one sign: the ends come from one end of x each.
    const auto& low = positive ? x.lower_ : x.upper_;
    const auto& high = positive ? x.upper_ : x.lower_;
    Interval z;
    mpfr_mul(z.lower_, low, mpfr_sgn(low) < 0 ? y.upper_ : y.lower_, MPFR_RNDD);
    mpfr_mul(z.upper_, high, mpfr_sgn(high) < 0 ? y.lower_ : y.upper_, MPFR_RNDU);
    return z;
  }
  friend Interval operator/(const Interval& x, const Interval& y) {
    return mpfr_sgn(y.lower_) * mpfr_sgn(y.upper_) > 0 ? hull_of(mpfr_div, x, y) : not_a_number();
  }

  /// The least interval that contains both.
  friend Interval hull(const Interval& x, const Interval& y) {
    if (mpfr_unordered_p(x.lower_, y.lower_) != 0 || mpfr_unordered_p(x.upper_, y.upper_) != 0) return not_a_number();
    Interval z;
    mpfr_min(z.lower_, x.lower_, y.lower_, MPFR_RNDD);
    mpfr_max(z.upper_, x.upper_, y.upper_, MPFR_RNDU);
    return z;
  }
  friend Interval max(const Interval& x, const Interval& y) {
    if (mpfr_unordered_p(x.lower_, y.lower_) != 0 || mpfr_unordered_p(x.upper_, y.upper_) != 0) return not_a_number();
    Interval z;
    mpfr_max(z.lower_, x.lower_, y.lower_, MPFR_RNDD);
    mpfr_max(z.upper_, x.upper_, y.upper_, MPFR_RNDU);
    return z;
  }
  friend Interval power(const Interval& x, unsigned long exponent) {
    Interval z(1);
    for (unsigned long i = 0; i < exponent; ++i) z = z * x;
    return z;
  }

  friend Interval square(const Interval& x) {
    Interval z = x * x;
    if (mpfr_sgn(z.lower_) < 0) mpfr_set_zero(z.lower_, 1);
    return z;
  }
  /// Of a number that is known not to be negative.
  friend Interval sqrt(Interval x) {
    if (mpfr_sgn(x.lower_) < 0) mpfr_set_zero(x.lower_, 1);
    return increasing(mpfr_sqrt, x);
  }
  friend Interval sinh(const Interval& x) { return increasing(mpfr_sinh, x); }
  friend Interval arsinh(const Interval& x) { return increasing(mpfr_asinh, x); }
  friend Interval arctan(const Interval& x) { return increasing(mpfr_atan, x); }
  /// Of a number from 0 to π, and of one from 0 to π/2.
  friend Interval cos(const Interval& x) { return decreasing(mpfr_cos, x); }
  friend Interval sin(const Interval& x) { return increasing(mpfr_sin, x); }
  /// Of a number that is not negative.
  friend Interval cosh(const Interval& x) { return increasing(mpfr_cosh, x); }
  friend Interval exp(const Interval& x) { return increasing(mpfr_exp, x); }
  friend Interval log(const Interval& x) { return increasing(mpfr_log, x); }

  friend Answer is_less(const Interval& x, const Interval& y) {
    if (mpfr_less_p(x.upper_, y.lower_) != 0) return Answer::yes;
    return mpfr_greaterequal_p(x.lower_, y.upper_) != 0 ? Answer::no : Answer::unknown;
  }

  /// Whether the upper end is a greater one, an order of intervals whose ends are numbers.
  static bool has_greater_upper_end(const Interval& x, const Interval& y) {
    return mpfr_greater_p(x.upper_, y.upper_) != 0;
  }

  /// Whether both ends are numbers, and none is infinite.
  [[nodiscard]] bool is_bounded() const { return mpfr_number_p(lower_) != 0 && mpfr_number_p(upper_) != 0; }

  /// One number, about in the middle.
  [[nodiscard]] Interval middle() const {
    Interval z;
    mpfr_add(z.lower_, lower_, upper_, MPFR_RNDN);
    mpfr_div_2ui(z.lower_, z.lower_, 1, MPFR_RNDN);
    mpfr_set(z.upper_, z.lower_, MPFR_RNDN);
    return z;
  }

  // Numbers of binary64 that are not more and not less than the ends.
  [[nodiscard]] double lower() const { return mpfr_get_d(lower_, MPFR_RNDD); }
  [[nodiscard]] double upper() const { return mpfr_get_d(upper_, MPFR_RNDU); }

  static Interval pi() {
    Interval z;
    mpfr_const_pi(z.lower_, MPFR_RNDD);
    mpfr_const_pi(z.upper_, MPFR_RNDU);
    return z;
  }

 private:
  static Interval not_a_number() {
    Interval z;
    mpfr_set_nan(z.lower_);
    mpfr_set_nan(z.upper_);
    return z;
  }

  template <class Function>
  static Interval increasing(const Function& function, const Interval& x) {
    Interval z;
    function(z.lower_, x.lower_, MPFR_RNDD);
    function(z.upper_, x.upper_, MPFR_RNDU);
    return z;
  }

  template <class Function>
  static Interval decreasing(const Function& function, const Interval& x) {
    Interval z;
    function(z.lower_, x.upper_, MPFR_RNDD);
    function(z.upper_, x.lower_, MPFR_RNDU);
    return z;
  }

  /// The values of an operation, monotone in each of its operands, on the four pairs of ends.
  template <class Operation>
  static Interval hull_of(const Operation& operation, const Interval& x, const Interval& y) {
    Interval z = not_a_number();  // As yet: the first end is taken as it is.
    Interval t;
    bool first = true;
    for (const auto* p : {&x.lower_, &x.upper_}) {
      for (const auto* q : {&y.lower_, &y.upper_}) {
        operation(t.lower_, *p, *q, MPFR_RNDD);
        operation(t.upper_, *p, *q, MPFR_RNDU);
        if (mpfr_nan_p(t.lower_) != 0) return not_a_number();
        if (first || mpfr_less_p(t.lower_, z.lower_) != 0) mpfr_set(z.lower_, t.lower_, MPFR_RNDD);
        if (first || mpfr_greater_p(t.upper_, z.upper_) != 0) mpfr_set(z.upper_, t.upper_, MPFR_RNDU);
        first = false;
      }
    }
    return z;
  }

  /// The limbs of both ends are here: nothing is allocated.
  void begin() {
    mpfr_custom_init_set(lower_, MPFR_ZERO_KIND, 0, kBits, limbs_.data());
    mpfr_custom_init_set(upper_, MPFR_ZERO_KIND, 0, kBits, limbs_.data() + kLimbs);
  }

  static constexpr std::size_t kLimbs = kBits / GMP_NUMB_BITS;
  std::array<mp_limb_t, 2 * kLimbs> limbs_{};
  mpfr_t lower_;
  mpfr_t upper_;
};

/// A vector of the space of the hyperboloid.
using Vector = std::array<Interval, 3>;

inline Interval enclosure(const mpz_class& x) { return Interval(mpq_class(x)); }

/// The x with Σ_j matrix[i][j] x_j = right[i] for all i, as many as there are unknowns. Nothing unless the matrix
/// certainly has an inverse, by elimination. O(n³) for n unknowns; throws LeftOut for more than 500.
[[nodiscard]] std::optional<std::vector<Interval>> solution(std::vector<std::vector<Interval>> matrix,
                                                            std::vector<Interval> right);

}  // namespace epsnet::exact
