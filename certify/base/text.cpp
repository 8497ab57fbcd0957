#include "certify/base/text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <system_error>

#include "certify/base/error.h"

namespace epsnet::certify {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The number of digits at the start of the text.
std::size_t leading_digits(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
}

mpz_class integer(std::string_view digits) { return mpz_class(std::string(digits), 10); }

mpz_class power_of_ten(unsigned long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

/// The parts of a JSON number, -?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?.
struct JsonNumber {
  bool negative = false;
  std::string_view whole;
  std::string_view fraction;
  bool negative_exponent = false;
  std::string_view exponent;
};

std::optional<JsonNumber> split_json_number(std::string_view text) {
  JsonNumber number;
  const auto take = [&](std::string_view characters) {
    if (text.empty() || characters.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
  };
  const auto take_digits = [&] {
    const std::string_view digits = text.substr(0, leading_digits(text));
    text.remove_prefix(digits.size());
    return digits;
  };
  number.negative = take("-");
  number.whole = take_digits();
  if (number.whole.empty() || (number.whole.size() > 1 && number.whole.front() == '0')) return std::nullopt;
  if (take(".")) {
    number.fraction = take_digits();
    if (number.fraction.empty()) return std::nullopt;
  }
  if (take("eE")) {
    number.negative_exponent = text.starts_with('-');
    take("+-");
    number.exponent = take_digits();
    if (number.exponent.empty()) return std::nullopt;
  }
  if (!text.empty()) return std::nullopt;
  return number;
}

using Integer128 = unsigned __int128;

/// A power of 5 with 64 bits, shifted, and ⌊2¹²⁷/power⌋ or, if that is 2⁶⁴, 2⁶⁴ − 1.
struct PowerOfFive {
  std::uint64_t power;
  int shift;
  std::uint64_t reciprocal;
};

/// As far as powers have 64 bits.
constexpr auto kPowersOfFive = [] {
  std::array<PowerOfFive, 28> powers{};
  std::uint64_t power = 1;
  for (PowerOfFive& entry : powers) {
    const int shift = std::countl_zero(power);
    const Integer128 reciprocal = (Integer128{1} << 127) / (power << shift);
    entry = {power << shift, shift, static_cast<std::uint64_t>(reciprocal - (reciprocal >> 64))};
    power *= 5;
  }
  return powers;
}();

/// |x| as the nearest binary64, ties to even, if it has few digits, of which at most 27 stand behind the point, as
/// nearly all numbers of files have. By a quotient of integers: no floating-point operation here rounds.
std::optional<double> nearest_of_few_digits(const JsonNumber& number) {
  std::uint64_t digits = 0;
  for (const std::string_view part : {number.whole, number.fraction}) {
    for (const char c : part) {
      if (digits > (std::numeric_limits<std::uint64_t>::max() - 9) / 10) return std::nullopt;
      digits = 10 * digits + static_cast<std::uint64_t>(c - '0');
    }
  }
  if (digits == 0) return 0;
  if (number.exponent.size() > 3 || number.fraction.size() >= kPowersOfFive.size()) return std::nullopt;
  int exponent = 0;
  for (const char c : number.exponent) exponent = 10 * exponent + (c - '0');
  const int places = static_cast<int>(number.fraction.size()) + (number.negative_exponent ? exponent : -exponent);
  if (places < 0 || places >= static_cast<int>(kPowersOfFive.size())) return std::nullopt;
  // |x| = n/power · 2^(power_shift − shift − places); both have 64 bits. 2⁶² < Q = 2⁶³n/power < 2⁶⁴.
  const auto& [power, power_shift, reciprocal] = kPowersOfFive[static_cast<std::size_t>(places)];
  const int shift = std::countl_zero(digits);
  const std::uint64_t n = digits << shift;
  // q ≤ Q < q + 2, as the reciprocal is less than 1 too small, and so is q.
  auto q = static_cast<std::uint64_t>((static_cast<Integer128>(n) * reciprocal) >> 64);
  // 53 bits are kept.
  const int dropped = 10 + static_cast<int>(q >> 63);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  std::uint64_t rest = q & (2 * half - 1);
  bool up = rest > half;
  if (rest == half || rest == half - 1) {  // It may matter what Q is.
    const Integer128 dividend = static_cast<Integer128>(n) << 63;
    q = static_cast<std::uint64_t>(dividend / power);
    rest = q & (2 * half - 1);
    const bool exact = static_cast<Integer128>(q) * power == dividend;
    up = rest > half || (rest == half && (!exact || ((q >> dropped) & 1) != 0));
  }
  const std::uint64_t mantissa = (q >> dropped) + (up ? 1 : 0);
  const int scale = dropped - 63 + power_shift - shift - places;  // From −153 to 11.
  return static_cast<double>(mantissa) * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + scale) << 52);
}

/// The same for every number; infinity if that is the nearest.
double nearest_of_many_digits(const JsonNumber& number) {
  std::string digits(number.whole);
  digits += number.fraction;
  const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
  if (zeros == digits.size()) return 0;
  long exponent = 0;
  // An exponent that does not fit in 64 bits outweighs the digits of any file.
  const bool huge =
      std::from_chars(number.exponent.data(), number.exponent.data() + number.exponent.size(), exponent).ec ==
      std::errc::result_out_of_range;
  constexpr long kFar = 1L << 62;
  if (huge || exponent > kFar) exponent = kFar;
  if (number.negative_exponent) exponent = -exponent;
  // |x| = 0.d₁d₂… · 10^exponent with d₁ ≠ 0.
  exponent += static_cast<long>(number.whole.size()) - static_cast<long>(zeros);
  if (exponent > 309) return HUGE_VAL;  // |x| ≥ 10³⁰⁹ > 2¹⁰²⁴.
  if (exponent < -323) return 0;        // |x| < 10⁻³²⁴ < 2⁻¹⁰⁷⁵, half of the least subnormal number.
  digits.erase(0, zeros);
  // A tie is an integer below 2¹⁰²⁵ or a multiple of 2⁻¹⁰⁷⁵, and has at most 1075 digits: of those after that it only
  // matters whether they are 0.
  constexpr std::size_t kDigits = 1100;
  if (digits.size() > kDigits) {
    const bool more = digits.find_first_not_of('0', kDigits) != std::string::npos;
    digits.resize(kDigits);
    if (more) digits += '1';
  }
  // |x| as a quotient.
  mpz_class dividend = integer(digits);
  mpz_class divisor = 1;
  exponent -= static_cast<long>(digits.size());
  (exponent < 0 ? divisor : dividend) *= power_of_ten(static_cast<unsigned long>(std::abs(exponent)));
  // The last place: a quotient by it has 53 bits, or 54, or fewer if the number is subnormal.
  const auto bits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  long place = std::max(bits(dividend) - bits(divisor) - 53, -1074L);
  (place < 0 ? dividend : divisor) <<= static_cast<unsigned long>(std::abs(place));
  mpz_class quotient = dividend / divisor;
  if (bits(quotient) > 53) {
    divisor *= 2;
    quotient /= 2;
    ++place;
  }
  const mpz_class remainder = dividend - quotient * divisor;
  const int half = cmp(2 * remainder, divisor);
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0)) ++quotient;
  return std::ldexp(quotient.get_d(), static_cast<int>(place));
}

/// The length of the character in UTF-8 that the text begins with; 0 if it begins with none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc0 || lead >= 0xf8 || text.size() < length) return 0;
  std::uint32_t code = lead & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return 0;
    code = code << 6U | (byte(i) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code >= kLeast[length] && code <= 0x10ffff && !surrogate ? length : 0;
}

/// The same of a character that is printable: no control character, of which U+0080 to U+009f take two bytes.
std::size_t printable_length(std::string_view text) {
  const std::size_t length = character_length(text);
  const auto first = static_cast<unsigned char>(text.front());
  const bool control =
      length == 2 ? first == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0 : first < 0x20 || first == 0x7f;
  return control ? 0 : length;
}

/// The optimal string alignment distance.
std::size_t typing_errors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        d[i][k] = i + k;
        continue;
      }
      d[i][k] = std::min({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        d[i][k] = std::min(d[i][k], d[i - 2][k - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::optional<mpq_class> parse_rational(std::string_view text) {
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

mpq_class decimal(std::string_view text) { return value_of(parse_decimal(text), "a decimal that is none"); }

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
  const mpz_class power = power_of_ten(static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
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

std::optional<double> parse_binary64(std::string_view text) {
  const auto number = split_json_number(text);
  if (!number) return std::nullopt;
  const auto few = nearest_of_few_digits(*number);
  const double value = few ? *few : nearest_of_many_digits(*number);
  if (std::isinf(value)) return std::nullopt;
  return number->negative ? -value : value;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, kShown)) result += (c >= ' ' && c <= '~' && c != '"' && c != '\\') ? c : '?';
  if (text.size() > kShown) result += "...";
  return result + '"';
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = printable_length(text);
    result += length == 0 ? "?" : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::string path_in_quotes(std::string_view path) {
  std::string text = printable(path);
  for (char& c : text) {
    if (c == '"' || c == '\\') c = '?';
  }
  return '"' + text + '"';
}

std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end);
}

std::string nearest_name(const std::string& typed, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 40;
  if (typed.empty() || typed.size() > kLongest) return "";
  const auto bare = [](const std::string& name) {
    return name.substr(std::min(name.find_first_not_of('-'), name.size()));
  };
  const std::string meant = bare(typed);
  std::size_t least = meant.size() / 3 + 1;
  std::string nearest;
  for (const std::string& name : names) {
    const std::string candidate = bare(name);
    const std::size_t errors = meant.size() > 1 && candidate.starts_with(meant) ? 0 : typing_errors(meant, candidate);
    if (errors < least || (errors == least && nearest.empty() && errors < candidate.size())) {
      least = errors;
      nearest = name;
    }
  }
  return nearest;
}

}  // namespace epsnet::certify
