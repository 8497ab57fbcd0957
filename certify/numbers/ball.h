#pragma once

#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/arb.h>
#else
#include <acb.h>
#include <arb.h>
#endif
#include <algorithm>
#include <gmpxx.h>
#include <limits>
#include <optional>
#include <vector>

#include "certify/base/interval.h"
#include "certify/numbers/rounding.h"

/// Owners of Arb's real and complex balls, and comparisons that cannot be misread.
///
/// The inclusion principle: a function of balls returns a ball that contains the value of the function at every choice
/// of points in the arguments. Working precision is always said, in bits. Objects passed twice mean the same number
/// twice. Enclosing is Arb's business; this header only owns memory and asks the right questions.
namespace epsnet::certify {

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

class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(const Ball& other) {
    arb_init(value_);
    arb_set(value_, other.value_);
  }
  Ball(Ball&& other) noexcept {
    arb_init(value_);
    arb_swap(value_, other.value_);
  }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  [[nodiscard]] arb_ptr get() { return value_; }
  [[nodiscard]] arb_srcptr get() const { return value_; }

 private:
  arb_t value_;
};

class ComplexBall {
 public:
  ComplexBall() { acb_init(value_); }
  ComplexBall(const ComplexBall& other) {
    acb_init(value_);
    acb_set(value_, other.value_);
  }
  ComplexBall(ComplexBall&& other) noexcept {
    acb_init(value_);
    acb_swap(value_, other.value_);
  }
  ComplexBall& operator=(const ComplexBall& other) {
    acb_set(value_, other.value_);
    return *this;
  }
  ComplexBall& operator=(ComplexBall&& other) noexcept {
    acb_swap(value_, other.value_);
    return *this;
  }
  ~ComplexBall() { acb_clear(value_); }

  [[nodiscard]] acb_ptr get() { return value_; }
  [[nodiscard]] acb_srcptr get() const { return value_; }
  [[nodiscard]] arb_ptr re() { return acb_realref(value_); }
  [[nodiscard]] arb_srcptr re() const { return acb_realref(value_); }
  [[nodiscard]] arb_ptr im() { return acb_imagref(value_); }
  [[nodiscard]] arb_srcptr im() const { return acb_imagref(value_); }

 private:
  acb_t value_;
};

/// x < y: `yes` and `no` hold for every choice of points in the balls. Not finite (NaN above all) is `unknown`.
[[nodiscard]] inline Tri certainly_less(arb_srcptr x, arb_srcptr y) {
  if (!arb_is_finite(x) || !arb_is_finite(y)) return Tri::unknown;
  if (arb_lt(x, y)) return Tri::yes;
  return arb_ge(x, y) ? Tri::no : Tri::unknown;
}

/// x > 0. Not finite is `unknown`.
[[nodiscard]] inline Tri certainly_positive(arb_srcptr x) {
  if (!arb_is_finite(x)) return Tri::unknown;
  if (arb_is_positive(x)) return Tri::yes;
  return arb_is_nonpositive(x) ? Tri::no : Tri::unknown;
}

/// x < 0. Not finite is `unknown`.
[[nodiscard]] inline Tri certainly_negative(arb_srcptr x) {
  if (!arb_is_finite(x)) return Tri::unknown;
  if (arb_is_negative(x)) return Tri::yes;
  return arb_is_nonnegative(x) ? Tri::no : Tri::unknown;
}

/// 1 or −1 if all points of the ball have this sign; else 0, which says nothing. 0 if not finite.
[[nodiscard]] inline int certain_sign(arb_srcptr x) {
  return certainly_positive(x) == Tri::yes ? 1 : certainly_negative(x) == Tri::yes ? -1 : 0;
}

/// True only if the ball is the single point 0. False says nothing; false if not finite.
[[nodiscard]] inline bool is_exactly_zero(arb_srcptr x) { return arb_is_zero(x) != 0; }

/// False for NaN and for balls with an infinite end. Says nothing about the value.
[[nodiscard]] inline bool is_finite(arb_srcptr x) { return arb_is_finite(x) != 0; }

/// True only if no point of one ball is a point of the other, so that the values differ. False says nothing; false for
/// NaN.
[[nodiscard]] inline bool certainly_different(acb_srcptr x, acb_srcptr y) { return acb_overlaps(x, y) == 0; }

/// The integer in the ball, if there is exactly one and it is of the size of a machine word. Returns nullopt if not
/// finite.
[[nodiscard]] inline std::optional<slong> only_integer(arb_srcptr x) {
  fmpz_t integer;
  fmpz_init(integer);
  const bool unique = arb_get_unique_fmpz(integer, x) != 0 && fmpz_fits_si(integer) != 0;
  const std::optional<slong> result = unique ? std::optional(fmpz_get_si(integer)) : std::nullopt;
  fmpz_clear(integer);
  return result;
}

/// The integer, rounded to `precision` bits with a radius that covers the rounding.
inline void set_integer(arb_ptr result, const mpz_class& value, slong precision) {
  fmpz_t integer;
  fmpz_init(integer);
  fmpz_set_mpz(integer, value.get_mpz_t());
  arb_set_round_fmpz(result, integer, precision);
  fmpz_clear(integer);
}

/// The rational number, as a ball of about `precision` bits.
inline void set_rational(arb_ptr result, const mpq_class& value, slong precision) {
  Ball denominator;
  set_integer(result, value.get_num(), precision);
  set_integer(denominator.get(), value.get_den(), precision);
  arb_div(result, result, denominator.get(), precision);
}

/// An interval that contains the ball; everything if the ball is not finite.
///
/// Each end is rounded outward by Arb (arf_get_d with a direction), so the result holds even for ends that overflow.
[[nodiscard]] inline Interval outer_interval(arb_srcptr x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!arb_is_finite(x)) return {-kInfinity, kInfinity};
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, x, 64);
  const double lower = arf_get_d(end, ARF_RND_FLOOR);
  arb_get_ubound_arf(end, x, 64);
  const double upper = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
  return {lower, upper};
}

/// An interval around a ball that is finite, in less time and a little wider: the midpoint in binary64, widened by the
/// radius and by units in the last place: of each end for the rounding of the sum, and of the end and of the radius for
/// that of the midpoint, which is no larger than both together.
[[nodiscard]] inline Interval fast_interval(arb_srcptr x) {
  const double middle = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  const double radius = above(mag_get_d(arb_radref(x)));
  return {below(below(middle - radius)), above(above(middle + radius))};
}

/// Sorts by a number of each item, of which `ball` gives an enclosure, in increasing order; false if balls do not tell
/// that the numbers are all different and in this order.
template <class Item, class BallOf>
[[nodiscard]] bool sort_certainly(std::vector<Item>& items, const BallOf& ball) {
  std::sort(items.begin(), items.end(),
            [&](const Item& x, const Item& y) { return arf_cmp(arb_midref(ball(x)), arb_midref(ball(y))) < 0; });
  const auto in_doubt = [&](const Item& x, const Item& y) { return certainly_less(ball(x), ball(y)) != Tri::yes; };
  return std::adjacent_find(items.begin(), items.end(), in_doubt) == items.end();
}

}  // namespace epsnet::certify
