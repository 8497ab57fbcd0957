#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cfloat>
#include <limits>

#include "kernel/complex.h"

/// The fields that the kernel computes in.
namespace epsnet {

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

}  // namespace epsnet
