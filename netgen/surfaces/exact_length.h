#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kernel/numbers.h"

/// Lengths that are given exactly, as 2*arcosh(3/2).
namespace epsnet {

/// The length times·arcosh(cosh).
struct ExactLength {
  std::string cosh;      ///< At least 1; a text of NumberFieldReader.
  Rational times;        ///< Its denominator is a power of 2.
  Rational approximate;  ///< The length, to about 1,000 bits.

  bool operator==(const ExactLength&) const = default;
};

/// Reads n*arcosh(x), n*arsinh(x) or n*log(x) with n a fraction, also in front of or behind it as in arcosh(x)/2, of
/// which the denominator is a power of 2. Returns nullopt if none of the three functions is in the text. Throws
/// SurfaceError, which says what is wrong.
[[nodiscard]] std::optional<ExactLength> parse_exact_length(std::string_view text);

/// cosh(factor·length) as a text of NumberFieldReader. Requires: a denominator of the factor that is a power of 2.
[[nodiscard]] std::string cosh_text(const ExactLength& length, const Rational& factor);

/// The value of a text of NumberFieldReader: if it is rational; and to 1,024 bits.
[[nodiscard]] std::optional<Rational> rational_value(const std::string& text);
[[nodiscard]] Mp1024 real_value(const std::string& text);

}  // namespace epsnet
