#include <epsnet/certify/text.h>

#include <algorithm>
#include <charconv>

namespace epsnet::certify {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The number of digits at the start of the text.
std::size_t leading_digits(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
}

mpz_class integer(std::string_view digits) { return mpz_class(std::string(digits), 10); }

}  // namespace

std::optional<mpq_class> parse_rational(std::string_view text) {
  if (text.size() > kMaxRationalDigits + 2) return std::nullopt;
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t length = leading_digits(text);
  if (length == 0) return std::nullopt;
  const std::string_view numerator = text.substr(0, length);
  std::string_view denominator = "1";
  if (length < text.size()) {
    if (text[length] != '/') return std::nullopt;
    denominator = text.substr(length + 1);
    if (denominator.empty() || leading_digits(denominator) != denominator.size()) return std::nullopt;
    if (numerator.size() + denominator.size() > kMaxRationalDigits) return std::nullopt;
  } else if (numerator.size() > kMaxRationalDigits) {
    return std::nullopt;
  }
  mpq_class value;
  value.get_num() = integer(numerator);
  value.get_den() = integer(denominator);
  if (value.get_den() == 0) return std::nullopt;
  value.canonicalize();
  if (negative) value = -value;
  return value;
}

std::optional<mpq_class> parse_decimal(std::string_view text) {
  if (text.find('/') != std::string_view::npos) return parse_rational(text);
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t whole = leading_digits(text);
  if (whole == 0) return std::nullopt;
  std::string digits(text.substr(0, whole));
  text.remove_prefix(whole);
  long exponent = 0;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const std::size_t fraction = leading_digits(text);
    if (fraction == 0) return std::nullopt;
    digits += text.substr(0, fraction);
    text.remove_prefix(fraction);
    exponent = -static_cast<long>(fraction);
  }
  if (digits.size() > kMaxRationalDigits) return std::nullopt;
  if (text.starts_with('e') || text.starts_with('E')) {
    text.remove_prefix(1);
    const bool negative_exponent = text.starts_with('-');
    if (negative_exponent || text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || text.size() > 4 || leading_digits(text) != text.size()) return std::nullopt;
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    exponent += negative_exponent ? -value : value;
    text = {};
  }
  if (!text.empty()) return std::nullopt;
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  mpq_class value(integer(digits));
  if (exponent < 0) {
    value.get_den() = power;
    value.canonicalize();
  } else {
    value.get_num() *= power;
  }
  if (negative) value = -value;
  return value;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, kShown)) result += (c >= ' ' && c <= '~' && c != '"' && c != '\\') ? c : '?';
  if (text.size() > kShown) result += "...";
  return result + '"';
}

std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end);
}

}  // namespace epsnet::certify
