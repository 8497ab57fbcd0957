#pragma once

#include <gmpxx.h>
#include <mpfr.h>
#include <optional>
#include <string_view>

#include "certify/base/text.h"
#include "certify/net/document.h"
#include "kernel/numbers.h"

/// Conversions between the numbers of documents, which are GMP's own classes, and the numbers of the kernel.
namespace epsnet {

[[nodiscard]] inline mpq_class to_gmp(const Rational& q) { return mpq_class(q.backend().data()); }
[[nodiscard]] inline certify::RationalPoint to_gmp(const Complex<Rational>& z) { return {to_gmp(z.x), to_gmp(z.y)}; }

[[nodiscard]] inline Rational from_gmp(const mpq_class& q) { return Rational(q.get_mpq_t()); }
[[nodiscard]] inline Complex<Rational> from_gmp(const certify::RationalPoint& z) {
  return {from_gmp(z.x), from_gmp(z.y)};
}

/// Returns the exact value of a decimal or rational as docs/format.md defines it ("-0.25", "1e-3", "1/10"): 0.1 is
/// 1/10. Returns nullopt for any other text, and beyond the limits of files.
[[nodiscard]] inline std::optional<Rational> parse_decimal(std::string_view text) {
  const std::optional<mpq_class> value = certify::parse_decimal(text);
  return value ? std::optional(from_gmp(*value)) : std::nullopt;
}

/// Returns the nearest number of a multiprecision field.
template <class T>
[[nodiscard]] T rounded(const mpq_class& q) {
  T x;
  mpfr_set_q(x.backend().data(), q.get_mpq_t(), MPFR_RNDN);
  return x;
}
template <class T>
[[nodiscard]] Complex<T> rounded(const certify::RationalPoint& z) {
  return {rounded<T>(z.x), rounded<T>(z.y)};
}

}  // namespace epsnet
