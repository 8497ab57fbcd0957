#include "triangulation/mesh/threshold.h"

#include <cassert>
#include <mpfr.h>
#include <type_traits>
#include <utility>

namespace epsnet {
namespace {

template <class T>
std::array<T, 2> enclosure(const Rational& x) {
  std::array<T, 2> ends;
  for (const std::size_t end : {0u, 1u}) {
    // Every operation is monotonous, and rounded in the same direction.
    const mpfr_rnd_t direction = end == 0 ? MPFR_RNDD : MPFR_RNDU;
    mpfr_t value;
    // With bits to spare, so that the two ends are neighbours whatever x is (the near-origin stages need that).
    mpfr_init2(value, kMantissaBits<T> + 64);
    mpfr_set_q(value, x.backend().data(), direction);
    mpfr_sinh(value, value, direction);
    mpfr_sqr(value, value, direction);
    if constexpr (std::is_same_v<T, double>) {
      ends[end] = mpfr_get_d(value, direction);
    } else {
      mpfr_set(ends[end].backend().data(), value, direction);
    }
    mpfr_clear(value);
  }
  return ends;
}

template <class T>
const std::array<T, 2>& computed_once(std::optional<std::array<T, 2>>& ends, const Rational& x) {
  if (!ends) {
    ends = enclosure<T>(x);
  }
  return *ends;
}

}  // namespace

Threshold::Threshold(Rational x) : x_(std::move(x)), ends_(enclosure<double>(x_)) { assert(x_ > 0); }

template <>
const std::array<double, 2>& Threshold::at<double>() const {
  return ends_;
}
template <>
const std::array<Mp256, 2>& Threshold::at<Mp256>() const {
  return computed_once(at_256_, x_);
}
template <>
const std::array<Mp1024, 2>& Threshold::at<Mp1024>() const {
  return computed_once(at_1024_, x_);
}
template <>
const std::array<Mp4096, 2>& Threshold::at<Mp4096>() const {
  return computed_once(at_4096_, x_);
}

}  // namespace epsnet
