#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <flint/fmpq.h>
#include <gmpxx.h>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/arb.h>
#else
#include <acb.h>
#include <arb.h>
#endif

#include "certify/base/error.h"
#include "certify/base/interval.h"

/// Real and complex balls with operators, and comparisons that cannot be misread.
///
/// The inclusion principle: a function of balls returns a ball that contains the value of the function at every choice
/// of points in the arguments; where the function has no value the ball is not finite. Objects passed twice mean the
/// same number twice. Enclosing is Arb's business; this header owns memory, rounds, and asks the right questions.
namespace epsnet::certify {

/// A binary64 below (above) x, a unit in the last place or two away: |x| 2⁻⁵² is at least such a unit, and where it
/// underflows the least positive number is one. NaN if x is NaN, and below +∞, above −∞.
[[nodiscard]] inline double below(double x) { return x - (std::fabs(x) * 0x1p-52 + 0x1p-1074); }
[[nodiscard]] inline double above(double x) { return x + (std::fabs(x) * 0x1p-52 + 0x1p-1074); }

/// An answer about balls. There is no conversion to bool: `unknown` is not `no`.
enum class Tri { no, yes, unknown };

[[nodiscard]] constexpr Tri operator!(Tri x) { return x == Tri::unknown ? x : x == Tri::yes ? Tri::no : Tri::yes; }

/// `no` as soon as one is, else `unknown` if one is.
[[nodiscard]] constexpr Tri both(Tri x, Tri y) {
  if (x == Tri::no || y == Tri::no) return Tri::no;
  return x == Tri::yes ? y : x;
}

/// `yes` as soon as one is, else `unknown` if one is.
[[nodiscard]] constexpr Tri either(Tri x, Tri y) { return !both(!x, !y); }

/// Owns a value of FLINT. `Type` names its struct and the functions that make, copy, exchange and free it.
template <class Type>
class Owner {
 public:
  using Struct = typename Type::Struct;

  Owner() { Type::init(&value_); }
  Owner(const Owner& other) : Owner() { Type::set(&value_, &other.value_); }
  Owner(Owner&& other) noexcept : Owner() { Type::swap(&value_, &other.value_); }
  Owner& operator=(const Owner& other) {
    Type::set(&value_, &other.value_);
    return *this;
  }
  Owner& operator=(Owner&& other) noexcept {
    Type::swap(&value_, &other.value_);
    return *this;
  }
  ~Owner() { Type::clear(&value_); }

  [[nodiscard]] Struct* get() { return &value_; }
  [[nodiscard]] const Struct* get() const { return &value_; }

 private:
  Struct value_;
};

struct IntegerType {
  using Struct = fmpz;
  static void init(fmpz* x) { fmpz_init(x); }
  static void set(fmpz* x, const fmpz* y) { fmpz_set(x, y); }
  static void swap(fmpz* x, fmpz* y) { fmpz_swap(x, y); }
  static void clear(fmpz* x) { fmpz_clear(x); }
};

/// An integer of FLINT, to hand over to it or back to GMP.
class Integer : public Owner<IntegerType> {
 public:
  Integer() = default;
  explicit Integer(const mpz_class& value) { fmpz_set_mpz(get(), value.get_mpz_t()); }
  [[nodiscard]] mpz_class value() const {
    mpz_class result;
    fmpz_get_mpz(result.get_mpz_t(), get());
    return result;
  }
};

/// The bits to which operators and functions of balls round, in this thread, as long as the object lives. The innermost
/// one counts; Fault where there is none.
class Precision {
 public:
  explicit Precision(slong bits) : outer_(std::exchange(bits_, bits)) {}
  ~Precision() { bits_ = outer_; }
  Precision(const Precision&) = delete;
  Precision& operator=(const Precision&) = delete;

  /// 0 where there is none.
  [[nodiscard]] static slong current() { return bits_; }
  [[nodiscard]] static slong bits() {
    if (bits_ <= 0) throw Fault("balls without a precision");
    return bits_;
  }

 private:
  static inline constinit thread_local slong bits_ = 0;
  slong outer_;
};

struct BallType {
  using Struct = arb_struct;
  static void init(arb_ptr x) { arb_init(x); }
  static void set(arb_ptr x, arb_srcptr y) { arb_set(x, y); }
  static void swap(arb_ptr x, arb_ptr y) { arb_swap(x, y); }
  static void clear(arb_ptr x) { arb_clear(x); }
};

/// A real ball, 0 at first. Numbers enter by name: an integer or a binary64 as itself, others rounded.
class Ball : public Owner<BallType> {
 public:
  Ball() = default;
  explicit Ball(arb_srcptr value) { arb_set(get(), value); }
  [[nodiscard]] static Ball exactly(std::integral auto value) {
    Ball result;
    if constexpr (std::unsigned_integral<decltype(value)>) {
      arb_set_ui(result.get(), value);
    } else {
      arb_set_si(result.get(), value);
    }
    return result;
  }
  [[nodiscard]] static Ball exactly(std::same_as<double> auto value) {
    Ball result;
    arb_set_d(result.get(), value);
    return result;
  }
  [[nodiscard]] static Ball rounded(const mpz_class& value) {
    Ball result;
    arb_set_round_fmpz(result.get(), Integer(value).get(), Precision::bits());
    return result;
  }
  [[nodiscard]] static Ball rounded(const mpq_class& value);
};

/// The ball that an operation of Arb leaves, rounded.
[[nodiscard]] inline Ball ball_of(void (*operation)(arb_ptr, arb_srcptr, slong), const Ball& x) {
  Ball result;
  operation(result.get(), x.get(), Precision::bits());
  return result;
}
[[nodiscard]] inline Ball ball_of(void (*operation)(arb_ptr, arb_srcptr, arb_srcptr, slong), const Ball& x,
                                  const Ball& y) {
  Ball result;
  operation(result.get(), x.get(), y.get(), Precision::bits());
  return result;
}
[[nodiscard]] inline Ball ball_of(void (*constant)(arb_ptr, slong)) {
  Ball result;
  constant(result.get(), Precision::bits());
  return result;
}

[[nodiscard]] inline Ball operator+(const Ball& x, const Ball& y) { return ball_of(arb_add, x, y); }
[[nodiscard]] inline Ball operator-(const Ball& x, const Ball& y) { return ball_of(arb_sub, x, y); }
[[nodiscard]] inline Ball operator*(const Ball& x, const Ball& y) { return ball_of(arb_mul, x, y); }
[[nodiscard]] inline Ball operator/(const Ball& x, const Ball& y) { return ball_of(arb_div, x, y); }
[[nodiscard]] inline Ball operator+(const Ball& x, std::integral auto n) { return x + Ball::exactly(n); }
[[nodiscard]] inline Ball operator-(const Ball& x, std::integral auto n) { return x - Ball::exactly(n); }
[[nodiscard]] inline Ball operator/(const Ball& x, std::integral auto n) { return x / Ball::exactly(n); }
[[nodiscard]] inline Ball operator+(std::integral auto n, const Ball& x) { return Ball::exactly(n) + x; }
[[nodiscard]] inline Ball operator-(std::integral auto n, const Ball& x) { return Ball::exactly(n) - x; }
[[nodiscard]] inline Ball operator*(std::integral auto n, const Ball& x) { return Ball::exactly(n) * x; }
[[nodiscard]] inline Ball operator/(std::integral auto n, const Ball& x) { return Ball::exactly(n) / x; }
[[nodiscard]] inline Ball operator-(Ball x) {
  arb_neg(x.get(), x.get());
  return x;
}
inline Ball& operator+=(Ball& x, const Ball& y) { return x = x + y; }

/// x·2^exponent, exactly.
[[nodiscard]] inline Ball scaled(Ball x, slong exponent) {
  arb_mul_2exp_si(x.get(), x.get(), exponent);
  return x;
}
[[nodiscard]] inline Ball half(Ball x) { return scaled(std::move(x), -1); }
[[nodiscard]] inline Ball twice(Ball x) { return scaled(std::move(x), 1); }
[[nodiscard]] inline Ball abs(Ball x) {
  arb_abs(x.get(), x.get());
  return x;
}
[[nodiscard]] inline Ball min(const Ball& x, const Ball& y) { return ball_of(arb_min, x, y); }
[[nodiscard]] inline Ball max(const Ball& x, const Ball& y) { return ball_of(arb_max, x, y); }
/// The square of a wide ball has points below 0, which are no squares.
[[nodiscard]] inline Ball sqr(const Ball& x) { return ball_of(arb_sqr, x); }
/// Not finite unless x ≥ 0 is certain.
[[nodiscard]] inline Ball sqrt(const Ball& x) { return ball_of(arb_sqrt, x); }
/// Of a number that is known to be ≥ 0, whatever other points the ball has.
[[nodiscard]] inline Ball sqrt_of_nonnegative(const Ball& x) { return ball_of(arb_sqrtpos, x); }
/// 1/√x. Not finite unless x > 0 is certain.
[[nodiscard]] inline Ball rsqrt(const Ball& x) { return ball_of(arb_rsqrt, x); }
[[nodiscard]] inline Ball sinh(const Ball& x) { return ball_of(arb_sinh, x); }
[[nodiscard]] inline Ball cosh(const Ball& x) { return ball_of(arb_cosh, x); }
[[nodiscard]] inline Ball exp(const Ball& x) { return ball_of(arb_exp, x); }
[[nodiscard]] inline Ball power(const Ball& x, std::uint64_t exponent) {
  Ball result;
  arb_pow_ui(result.get(), x.get(), exponent, Precision::bits());
  return result;
}
[[nodiscard]] inline Ball asinh(const Ball& x) { return ball_of(arb_asinh, x); }
/// Not finite unless x ≥ 1 is certain.
[[nodiscard]] inline Ball acosh(const Ball& x) { return ball_of(arb_acosh, x); }
[[nodiscard]] inline Ball atan(const Ball& x) { return ball_of(arb_atan, x); }
/// The angle of x + iy in (−π, π].
[[nodiscard]] inline Ball atan2(const Ball& y, const Ball& x) { return ball_of(arb_atan2, y, x); }
[[nodiscard]] inline Ball pi() { return ball_of(arb_const_pi); }
[[nodiscard]] inline Ball ln2() { return ball_of(arb_const_log2); }

inline Ball Ball::rounded(const mpq_class& value) { return rounded(value.get_num()) / rounded(value.get_den()); }

struct ComplexBallType {
  using Struct = acb_struct;
  static void init(acb_ptr x) { acb_init(x); }
  static void set(acb_ptr x, acb_srcptr y) { acb_set(x, y); }
  static void swap(acb_ptr x, acb_ptr y) { acb_swap(x, y); }
  static void clear(acb_ptr x) { acb_clear(x); }
};

class ComplexBall : public Owner<ComplexBallType> {
 public:
  ComplexBall() = default;
  ComplexBall(const Ball& re, const Ball& im) { acb_set_arb_arb(get(), re.get(), im.get()); }

  [[nodiscard]] arb_ptr re() { return acb_realref(get()); }
  [[nodiscard]] arb_srcptr re() const { return acb_realref(get()); }
  [[nodiscard]] arb_ptr im() { return acb_imagref(get()); }
  [[nodiscard]] arb_srcptr im() const { return acb_imagref(get()); }
};

[[nodiscard]] inline Ball real(const ComplexBall& z) { return Ball(z.re()); }
[[nodiscard]] inline Ball imaginary(const ComplexBall& z) { return Ball(z.im()); }
[[nodiscard]] inline ComplexBall conjugate(ComplexBall z) {
  acb_conj(z.get(), z.get());
  return z;
}
[[nodiscard]] inline ComplexBall operator-(ComplexBall z) {
  acb_neg(z.get(), z.get());
  return z;
}
[[nodiscard]] inline ComplexBall operator+(ComplexBall x, const ComplexBall& y) {
  acb_add(x.get(), x.get(), y.get(), Precision::bits());
  return x;
}
[[nodiscard]] inline ComplexBall operator*(const ComplexBall& x, const ComplexBall& y) {
  ComplexBall result;
  acb_mul(result.get(), x.get(), y.get(), Precision::bits());
  return result;
}
[[nodiscard]] inline ComplexBall operator*(const Ball& x, ComplexBall z) {
  acb_mul_arb(z.get(), z.get(), x.get(), Precision::bits());
  return z;
}
/// |z|².
[[nodiscard]] inline Ball norm(const ComplexBall& z) { return sqr(real(z)) + sqr(imaginary(z)); }
/// e^{2πik/n}.
[[nodiscard]] inline ComplexBall root_of_unity(std::uint32_t k, std::uint32_t n) {
  ComplexBall result;
  fmpq_t turns;
  fmpq_init(turns);
  fmpq_set_si(turns, 2 * slong{k}, n);
  arb_sin_cos_pi_fmpq(result.im(), result.re(), turns, Precision::bits());
  fmpq_clear(turns);
  return result;
}

/// x < y: `yes` and `no` hold for every choice of points in the balls. Not finite (NaN above all) is `unknown`.
[[nodiscard]] inline Tri certainly_less(const Ball& x, const Ball& y) {
  if (!arb_is_finite(x.get()) || !arb_is_finite(y.get())) return Tri::unknown;
  if (arb_lt(x.get(), y.get())) return Tri::yes;
  return arb_ge(x.get(), y.get()) ? Tri::no : Tri::unknown;
}

/// x > 0. Not finite is `unknown`.
[[nodiscard]] inline Tri certainly_positive(const Ball& x) {
  if (!arb_is_finite(x.get())) return Tri::unknown;
  if (arb_is_positive(x.get())) return Tri::yes;
  return arb_is_nonpositive(x.get()) ? Tri::no : Tri::unknown;
}

/// x < 0. Not finite is `unknown`.
[[nodiscard]] inline Tri certainly_negative(const Ball& x) {
  if (!arb_is_finite(x.get())) return Tri::unknown;
  if (arb_is_negative(x.get())) return Tri::yes;
  return arb_is_nonnegative(x.get()) ? Tri::no : Tri::unknown;
}

/// 1 or −1 if all points of the ball have this sign; else 0, which says nothing. 0 if not finite.
[[nodiscard]] inline int certain_sign(const Ball& x) {
  return certainly_positive(x) == Tri::yes ? 1 : certainly_negative(x) == Tri::yes ? -1 : 0;
}

/// True only if the ball is the single point 0. False says nothing; false if not finite.
[[nodiscard]] inline bool is_exactly_zero(const Ball& x) { return arb_is_zero(x.get()) != 0; }

/// False for NaN and for balls with an infinite end. Says nothing about the value.
[[nodiscard]] inline bool is_finite(const Ball& x) { return arb_is_finite(x.get()) != 0; }

/// True only if no point of one ball is a point of the other, so that the values differ. False says nothing; false for
/// NaN.
[[nodiscard]] inline bool certainly_different(const ComplexBall& x, const ComplexBall& y) {
  return acb_overlaps(x.get(), y.get()) == 0;
}

/// The integer in the ball, if there is exactly one and it is of the size of a machine word. Returns nullopt if not
/// finite.
[[nodiscard]] inline std::optional<slong> only_integer(const Ball& x) {
  Integer integer;
  const bool unique = arb_get_unique_fmpz(integer.get(), x.get()) != 0 && fmpz_fits_si(integer.get()) != 0;
  return unique ? std::optional(fmpz_get_si(integer.get())) : std::nullopt;
}

/// An interval that contains the ball; everything if the ball is not finite.
///
/// Each end is rounded outward by Arb (arf_get_d with a direction), so the result holds even for ends that overflow.
[[nodiscard]] inline Interval outer_interval(const Ball& x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!arb_is_finite(x.get())) return {-kInfinity, kInfinity};
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, x.get(), 64);
  const double lower = arf_get_d(end, ARF_RND_FLOOR);
  arb_get_ubound_arf(end, x.get(), 64);
  const double upper = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
  return {lower, upper};
}

[[nodiscard]] inline double lower_end(const Ball& x) { return outer_interval(x).lower; }
[[nodiscard]] inline double upper_end(const Ball& x) { return outer_interval(x).upper; }

/// An interval around a ball that is finite, in less time and a little wider: the midpoint in binary64, widened by the
/// radius and by units in the last place: of each end for the rounding of the sum, and of the end and of the radius for
/// that of the midpoint, which is no larger than both together.
[[nodiscard]] inline Interval fast_interval(const Ball& x) {
  const double middle = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR);
  const double radius = above(mag_get_d(arb_radref(x.get())));
  return {below(below(middle - radius)), above(above(middle + radius))};
}

/// Sorts by a number of each item, of which `ball` gives an enclosure by reference, in increasing order; false if balls
/// do not tell that the numbers are all different and in this order.
template <class Item, class BallOf>
[[nodiscard]] bool sort_certainly(std::vector<Item>& items, const BallOf& ball) {
  std::sort(items.begin(), items.end(), [&](const Item& x, const Item& y) {
    return arf_cmp(arb_midref(ball(x).get()), arb_midref(ball(y).get())) < 0;
  });
  const auto in_doubt = [&](const Item& x, const Item& y) { return certainly_less(ball(x), ball(y)) != Tri::yes; };
  return std::adjacent_find(items.begin(), items.end(), in_doubt) == items.end();
}

// How many bits balls have, and when exact arithmetic takes over.

/// Bits that a question is asked with first: they decide nearly all.
inline constexpr long kFirstPrecision = 64;

/// Bits from which on exact arithmetic is tried on what balls leave open. No precision of balls decides an exact tie;
/// but an exact answer takes as much time as many passes with balls, and near ties are decided by a few more bits. A
/// net has as many edges as one likes, and its near ties do not reach 256 bits.
inline constexpr long kExactFromForEdges = 256;

/// Calls attempt(precision) with `first` bits, with twice as many, and so on, the last time with `cap` bits (once, if
/// `cap` is not more than `first`), until it returns true: decided. Returns whether it did. Balls round to as many
/// bits.
template <class Attempt>
bool with_rising_precision(long cap, const Attempt& attempt, long first = kFirstPrecision) {
  for (long precision = std::min(first, cap);; precision = std::min(2 * precision, cap)) {
    const Precision scope(precision);
    if (attempt(precision)) return true;
    if (precision >= cap) return false;
  }
}

}  // namespace epsnet::certify
