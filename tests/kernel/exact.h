#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <utility>

#include "kernel/numbers.h"

namespace epsnet::test {

/// An exact number m·2ᵉ: every binary64 and multiprecision number is one, and + − × stay exact. The oracle of the
/// predicates; an order of magnitude faster than Rational, which exact_test.cpp holds it against.
class Dyadic {
 public:
  using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

  Dyadic() = default;
  Dyadic(Integer mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}
  explicit Dyadic(int value) : mantissa_(value) {}
  explicit Dyadic(double value) {
    if (value != 0) {
      int exponent = 0;
      const double fraction = std::frexp(value, &exponent);
      mantissa_ = static_cast<long>(std::ldexp(fraction, 53));
      exponent_ = exponent - 53;
    }
  }
  template <unsigned Digits>
  explicit Dyadic(const boost::multiprecision::number<
                  boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
                  boost::multiprecision::et_off>& value) {
    if (value != 0) {
      exponent_ = mpfr_get_z_2exp(mantissa_.backend().data(), value.backend().data());
    }
  }

  /// This number times 2ⁿ.
  [[nodiscard]] Dyadic times_power_of_two(long n) const { return {mantissa_, exponent_ + n}; }
  [[nodiscard]] Rational rational() const {
    Rational result(mantissa_);
    mpq_t& q = result.backend().data();
    if (exponent_ >= 0) {
      mpq_mul_2exp(q, q, static_cast<mp_bitcnt_t>(exponent_));
    } else {
      mpq_div_2exp(q, q, static_cast<mp_bitcnt_t>(-exponent_));
    }
    return result;
  }

  friend Dyadic operator-(const Dyadic& x) { return {Integer(-x.mantissa_), x.exponent_}; }
  friend Dyadic operator*(const Dyadic& x, const Dyadic& y) {
    return {Integer(x.mantissa_ * y.mantissa_), x.exponent_ + y.exponent_};
  }
  friend Dyadic operator+(const Dyadic& x, const Dyadic& y) {
    if (x.mantissa_ == 0) {
      return y;
    }
    if (y.mantissa_ == 0) {
      return x;
    }
    if (x.exponent_ < y.exponent_) {
      return y + x;
    }
    const auto shift = static_cast<unsigned long>(x.exponent_ - y.exponent_);
    return {Integer((x.mantissa_ << shift) + y.mantissa_), y.exponent_};
  }
  friend Dyadic operator-(const Dyadic& x, const Dyadic& y) { return x + -y; }
  friend bool operator==(const Dyadic& x, const Dyadic& y) { return (x - y).mantissa_ == 0; }
  friend bool operator<(const Dyadic& x, const Dyadic& y) { return (x - y).mantissa_ < 0; }
  friend bool operator>(const Dyadic& x, const Dyadic& y) { return y < x; }
  friend bool operator<=(const Dyadic& x, const Dyadic& y) { return !(y < x); }
  friend bool operator>=(const Dyadic& x, const Dyadic& y) { return !(x < y); }
  friend bool operator>(const Dyadic& x, int zero) { return x.mantissa_ > zero; }
  friend bool operator<(const Dyadic& x, int zero) { return x.mantissa_ < zero; }

 private:
  // Compared with 0 above, which needs no exponent; nothing else is.
  Integer mantissa_ = 0;
  long exponent_ = 0;
};

}  // namespace epsnet::test
