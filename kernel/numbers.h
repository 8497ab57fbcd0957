#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cfloat>
#include <cmath>
#include <limits>

/// The numbers that the kernel computes with: complex numbers over a field, and the fields.
namespace epsnet {

/// A complex number over any ordered field: binary64, multiprecision or rational.
///
/// std::complex is specified for the built-in floating point types alone; this one has just the field operations, and
/// its product is the textbook formula (no special cases for infinities), so that error bounds can be derived from the
/// source.
template <class T>
struct Complex {
  T x{};  ///< Real part.
  T y{};  ///< Imaginary part.

  bool operator==(const Complex&) const = default;
};

template <class T>
[[nodiscard]] constexpr Complex<T> operator+(const Complex<T>& u, const Complex<T>& v) {
  return {u.x + v.x, u.y + v.y};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator-(const Complex<T>& u, const Complex<T>& v) {
  return {u.x - v.x, u.y - v.y};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator-(const Complex<T>& u) {
  return {-u.x, -u.y};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator*(const Complex<T>& u, const Complex<T>& v) {
  return {u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator*(const T& s, const Complex<T>& v) {
  return {s * v.x, s * v.y};
}

/// Complex conjugate x − iy.
template <class T>
[[nodiscard]] constexpr Complex<T> conj(const Complex<T>& u) {
  return {u.x, -u.y};
}
/// Squared modulus x² + y².
template <class T>
[[nodiscard]] constexpr T norm(const Complex<T>& u) {
  return u.x * u.x + u.y * u.y;
}
/// Re(ū v), the scalar product of u and v as vectors of the plane.
template <class T>
[[nodiscard]] constexpr T dot(const Complex<T>& u, const Complex<T>& v) {
  return u.x * v.x + u.y * v.y;
}
/// Im(ū v), twice the signed area of the triangle (0, u, v).
template <class T>
[[nodiscard]] constexpr T cross(const Complex<T>& u, const Complex<T>& v) {
  return u.x * v.y - u.y * v.x;
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator/(const Complex<T>& u, const Complex<T>& v) {
  // One division and two products: divisions are expensive in binary64 and beyond, and this quotient is accurate
  // enough.
  const T reciprocal = T(1) / norm(v);
  return {dot(v, u) * reciprocal, cross(v, u) * reciprocal};
}

/// The number with both coordinates converted to another field.
template <class To, class From>
[[nodiscard]] constexpr Complex<To> convert(const Complex<From>& u) {
  return {static_cast<To>(u.x), static_cast<To>(u.y)};
}

static_assert(std::numeric_limits<double>::is_iec559, "the error bounds are proved for IEEE-754 binary64");
static_assert(FLT_EVAL_METHOD == 0, "the error bounds are proved for expressions that are rounded at every step");

/// Exact rational numbers (GMP).
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Multiprecision numbers (MPFR) with a mantissa of at least `Bits` bits, round to nearest, stored inside the object.
template <unsigned Bits>
using Multiprecision = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<(Bits * 3 + 9) / 10 + 2, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// The stages above binary64 in which staged predicates and constructions work, in this order.
using Mp256 = Multiprecision<256>;
/// The second stage.
using Mp1024 = Multiprecision<1024>;
/// The last stage.
using Mp4096 = Multiprecision<4096>;

/// The unit roundoff of a binary64 operation, 2⁻⁵³.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// The mantissa bits of a field, for the a-priori error bounds of the multiprecision stages.
template <class T>
inline constexpr int kMantissaBits = 0;
template <>
inline constexpr int kMantissaBits<double> = 53;
template <>
inline constexpr int kMantissaBits<Mp256> = 256;
template <>
inline constexpr int kMantissaBits<Mp1024> = 1024;
template <>
inline constexpr int kMantissaBits<Mp4096> = 4096;

/// The sign of a number: −1, 0 or 1.
template <class T>
[[nodiscard]] int sign(const T& a) {
  return (a > 0) - (a < 0);
}

/// A number as the unevaluated sum of two binary64 numbers, the second at most half of an ulp of the first: about 106
/// bits, at the price of a dozen binary64 operations each.
///
/// Sums are off by at most 3.1u² of themselves, u = 2⁻⁵³, products by 7u², as long as nothing overflows or underflows
/// (M. Joldeş, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic, ACM Trans. Math. Softw. 44 (2017), Algorithms 6 and 11).
struct DoubleDouble {
  double high = 0;  ///< The number rounded to binary64.
  double low = 0;   ///< The rest.

  /// 0.
  DoubleDouble() = default;
  /// A binary64 number, exactly.
  constexpr explicit DoubleDouble(double value) : high(value) {}
  /// The sum high + low. Requires: `low` is at most half an ulp of `high`.
  constexpr DoubleDouble(double high_part, double low_part) : high(high_part), low(low_part) {}
  /// Rounded twice: off by at most u² of the value.
  explicit DoubleDouble(const Mp256& value)
      : high(static_cast<double>(value)), low(static_cast<double>(value - high)) {}

  /// Rounded to binary64.
  constexpr explicit operator double() const { return high; }
};

namespace double_double_detail {

/// a + b without error, for any a and b.
constexpr DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b without error. Requires: |a| ≥ |b|.
constexpr DoubleDouble exact_sum_of_ordered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

}  // namespace double_double_detail

/// −a, exactly.
[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

/// a + b, off by at most 3.1u² of itself.
[[nodiscard]] constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  using double_double_detail::exact_sum, double_double_detail::exact_sum_of_ordered;
  const DoubleDouble high = exact_sum(a.high, b.high);
  const DoubleDouble low = exact_sum(a.low, b.low);
  const DoubleDouble sum = exact_sum_of_ordered(high.high, high.low + low.high);
  return exact_sum_of_ordered(sum.high, low.low + sum.low);
}

/// a − b, off by at most 3.1u² of itself.
[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

/// a b, off by at most 7u² of itself.
[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const double high = a.high * b.high;
  const double high_error = std::fma(a.high, b.high, -high);
  const double low = std::fma(a.low, b.high, a.high * b.low);
  return double_double_detail::exact_sum_of_ordered(high, high_error + low);
}

}  // namespace epsnet
