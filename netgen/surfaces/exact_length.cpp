#include "netgen/surfaces/exact_length.h"

#include <array>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/number_field.h"
#include "triangulation/surface/exact_points.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

/// Of the multiple of a length, and of the denominator.
constexpr unsigned kMostTimes = 64;

[[noreturn]] void fail_length(std::string_view text) {
  throw SurfaceError(
      "expected a length such as 0.5, 2*arcosh(3/2), 2*arsinh(1) or log(3)/2, the multiple at most 64 "
      "and its denominator a power of 2, not " +
      certify::in_quotes(text));
}

/// Where the parenthesis that is open before `first` is closed; npos, if it is not.
std::size_t closing(std::string_view text, std::size_t first) {
  int depth = 1;
  for (std::size_t i = first; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i;
  }
  return std::string_view::npos;
}

/// The fraction in front of a function, as in "2*", "-", "1/2*" or "".
std::optional<Rational> fraction_before(std::string_view text) {
  if (text.empty()) return 1;
  if (text == "-") return -1;
  if (!text.ends_with('*')) return std::nullopt;
  return parse_decimal(text.substr(0, text.size() - 1));
}

/// The fraction behind a function, as in "/2", "*3" or "".
std::optional<Rational> fraction_after(std::string_view text) {
  if (text.empty()) return 1;
  std::optional<Rational> number = parse_decimal(text.substr(1));
  if (!number || *number == 0 || (text[0] != '*' && text[0] != '/')) return std::nullopt;
  return text[0] == '*' ? *number : Rational(1 / *number);
}

bool is_power_of_2(const Integer& x) { return x > 0 && boost::multiprecision::lsb(x) == boost::multiprecision::msb(x); }

/// The coefficients of the Chebyshev polynomial, from that of 1 on: cosh(nx) = T(cosh x).
std::vector<Integer> chebyshev(unsigned n) {
  std::vector<Integer> before{1};
  std::vector<Integer> now{0, 1};
  if (n == 0) return before;
  for (unsigned i = 1; i < n; ++i) {
    std::vector<Integer> next(now.size() + 1);
    for (std::size_t k = 0; k < now.size(); ++k) next[k + 1] += 2 * now[k];
    for (std::size_t k = 0; k < before.size(); ++k) next[k] -= before[k];
    before = std::exchange(now, std::move(next));
  }
  return now;
}

}  // namespace

std::optional<ExactLength> parse_exact_length(std::string_view given) {
  std::string text;
  for (const char c : given) {
    if (c != ' ') text += c;
  }
  for (const std::string_view name : {"arcosh(", "arsinh(", "log("}) {
    const std::size_t start = text.find(name);
    if (start == std::string::npos) continue;
    const std::size_t first = start + name.size();
    const std::size_t end = closing(text, first);
    if (end == std::string::npos) fail_length(given);
    const std::string x = "(" + text.substr(first, end - first) + ")";
    const auto before = fraction_before(std::string_view(text).substr(0, start));
    const auto after = fraction_after(std::string_view(text).substr(end + 1));
    if (!before || !after) fail_length(given);
    ExactLength result{x, *before * *after, 0};
    // 2 arsinh(x) = arcosh(1 + 2x²), and log(x) = arcosh((x + 1/x)/2).
    if (name == "arsinh(") {
      result.cosh = "(1+2*" + x + "^2)";
      result.times /= 2;
    } else if (name == "log(") {
      result.cosh = "((" + x + "+1/" + x + ")/2)";
    }
    if (!is_power_of_2(denominator(result.times)) || denominator(result.times) > kMostTimes ||
        abs(result.times) > kMostTimes) {
      fail_length(given);
    }
    const Mp1024 sign = name == "arcosh(" ? Mp1024(1) : real_value(x) - (name == "log(" ? 1 : 0);
    const Mp1024 cosh = real_value(result.cosh);
    if (name == "log(" && sign <= -1) {
      throw SurfaceError("the log of a number that is not positive in " + certify::in_quotes(given));
    }
    if (cosh < 1) throw SurfaceError("the arcosh of a number that is less than 1 in " + certify::in_quotes(given));
    if (sign < 0) result.times = -result.times;
    result.approximate = result.times * Rational(Mp1024(acosh(cosh)));
    return result;
  }
  return std::nullopt;
}

std::string cosh_text(const ExactLength& length, const Rational& factor) {
  const Rational times = abs(Rational(length.times * factor));
  std::string x = length.cosh;
  for (Integer halves = denominator(times); halves > 1; halves /= 2) x = "(sqrt(2*" + x + "+2)/2)";
  const auto n = static_cast<unsigned>(numerator(times));
  if (n == 1) return x;
  const std::vector<Integer> coefficients = chebyshev(n);
  std::string result;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    if (coefficients[k] == 0) continue;
    if (!result.empty()) result += '+';
    result += "(" + coefficients[k].str() + ")*" + x + "^" + std::to_string(k);
  }
  return "(" + result + ")";
}

std::optional<Rational> rational_value(const std::string& text) {
  NumberFieldReader reader;
  reader.add(text);
  const RationalPolynomial& x = reader.numbers().back();
  if (fmpq_poly_degree(x.get()) > 0) return std::nullopt;
  if (fmpq_poly_length(x.get()) == 0) return 0;
  certify::Integer above;
  fmpz_set(above.get(), fmpq_poly_numref(x.get()));
  mpq_class result(above.value(), denominator_of(x));
  result.canonicalize();
  return from_gmp(result);
}

Mp1024 real_value(const std::string& text) {
  NumberFieldReader reader;
  reader.add(text);
  const certify::Ball value = reader.value(reader.numbers().back());
  Mp1024 result;
  arf_get_mpfr(result.backend().data(), arb_midref(value.get()), MPFR_RNDN);
  return result;
}

}  // namespace epsnet
