#include "certify/exact/json.h"

#include <algorithm>

namespace epsnet::exact {
namespace {

constexpr int kMaxDepth = 8;
constexpr std::size_t kMaxDigits = 1'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the digits at the beginning of the text away.
std::string_view take_digits(std::string_view& text) {
  const std::string_view digits = text.substr(0, text.find_first_not_of("0123456789"));
  text.remove_prefix(digits.size());
  return digits;
}

bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

mpz_class integer(std::string_view digits) { return mpz_class(std::string(digits), 10); }

/// A number as it is written, -?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?: the integer `digits` times 10^exponent.
struct Written {
  bool good = false;  ///< The text is of this form.
  bool negative = false;
  std::string digits = {};  ///< Before and after the point.
  long exponent = 0;        ///< Cut off at 10^15, which no digits of a file make up for.
  std::size_t exponent_digits = 0;
};

Written as_written(std::string_view text) {
  Written result;
  result.negative = take(text, '-');
  result.digits = take_digits(text);
  result.good = !result.digits.empty();
  if (take(text, '.')) {
    const std::string_view fraction = take_digits(text);
    result.good = result.good && !fraction.empty();
    result.digits += fraction;
    result.exponent = -static_cast<long>(fraction.size());
  }
  if (take(text, 'e') || take(text, 'E')) {
    const bool down = take(text, '-');
    if (!down) take(text, '+');
    std::string_view power = take_digits(text);
    result.exponent_digits = power.size();
    result.good = result.good && !power.empty();
    power.remove_prefix(std::min(power.find_first_not_of('0'), power.size()));
    const long size = power.empty() ? 0 : power.size() > 15 ? 1'000'000'000'000'000 : std::stol(std::string(power));
    result.exponent += down ? -size : size;
  }
  result.good = result.good && text.empty();
  return result;
}

/// Its absolute value, not in lowest terms.
mpq_class magnitude(const Written& number) {
  mpq_class result(integer(number.digits));
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(number.exponent)));
  (number.exponent < 0 ? result.get_den() : result.get_num()) *= power;
  return result;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Json document() {
    Json result = value(0);
    skip_space();
    if (at_ != text_.size()) fail("text after the end of the document");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Malformed("byte " + std::to_string(at_) + ": " + what);
  }

  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\n\r").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  void expect(char c) {
    if (!next_is(c)) fail(std::string("expected '") + c + "'");
    ++at_;
  }

  bool next_is(char c) {
    skip_space();
    return at_ < text_.size() && text_[at_] == c;
  }

  Json value(int depth) {
    skip_space();
    Json result;
    const char c = peek();
    if ((c == '{' || c == '[') && depth == kMaxDepth) fail("nested too deep");
    if (c == '{') {
      object(result, depth + 1);
    } else if (c == '[') {
      array(result, depth + 1);
    } else if (c == '"') {
      result.kind = Json::Kind::string;
      result.text = string();
    } else {
      scalar(result);
    }
    return result;
  }

  void object(Json& result, int depth) {
    result.kind = Json::Kind::object;
    expect('{');
    if (!next_is('}')) {
      do {
        skip_space();
        std::string name = string();
        for (const Json::Member& other : result.members) {
          if (other.name == name) fail("a member occurs twice");
        }
        // No object of the format has more members; without a limit the search above would take quadratic time.
        if (result.members.size() == 16) fail("an object with too many members");
        expect(':');
        result.members.push_back({std::move(name), value(depth)});
      } while (next_is(',') && ++at_ != 0);
    }
    expect('}');
  }

  void array(Json& result, int depth) {
    result.kind = Json::Kind::array;
    expect('[');
    if (!next_is(']')) {
      do {
        result.elements.push_back(value(depth));
      } while (next_is(',') && ++at_ != 0);
    }
    expect(']');
  }

  void scalar(Json& result) {
    const std::size_t start = at_;
    while (at_ < text_.size() && std::string_view(" \t\n\r,]}:").find(text_[at_]) == std::string_view::npos) ++at_;
    result.text = text_.substr(start, at_ - start);
    result.kind = Json::Kind::literal;
    if (result.text == "true" || result.text == "false" || result.text == "null") return;
    result.kind = Json::Kind::number;
    const Written number = as_written(result.text);
    // Of several digits before the point the first is not 0.
    const std::size_t first = number.negative ? 1 : 0;
    const bool zeros = result.text.size() > first + 1 && result.text[first] == '0' && is_digit(result.text[first + 1]);
    if (!number.good || zeros) {
      at_ = start;
      fail("not a value");
    }
  }

  std::uint32_t hexadecimal() {
    std::uint32_t code = 0;
    for (int i = 0; i < 4; ++i, ++at_) {
      const char c = peek();
      const std::size_t digit = std::string_view("0123456789abcdef").find(c >= 'A' && c <= 'F' ? char(c + 32) : c);
      if (c == '\0' || digit == std::string_view::npos) fail("expected four hexadecimal digits");
      code = 16 * code + static_cast<std::uint32_t>(digit);
    }
    return code;
  }

  void escape(std::string& result) {
    const char c = peek();
    ++at_;
    const std::size_t simple = std::string_view("\"\\/bfnrt").find(c);
    if (c != '\0' && simple != std::string_view::npos) {
      result += "\"\\/\b\f\n\r\t"[simple];
      return;
    }
    if (c != 'u') fail("an escape that JSON does not have");
    std::uint32_t code = hexadecimal();
    if (code >= 0xDC00 && code <= 0xDFFF) fail("a lone surrogate");
    if (code >= 0xD800 && code <= 0xDBFF) {
      if (text_.substr(at_, 2) != "\\u") fail("a lone surrogate");
      at_ += 2;
      const std::uint32_t low = hexadecimal();
      if (low < 0xDC00 || low > 0xDFFF) fail("a lone surrogate");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    append_utf8(result, code);
  }

  static void append_utf8(std::string& result, std::uint32_t code) {
    const auto byte = [&](std::uint32_t x) { result += static_cast<char>(static_cast<unsigned char>(x)); };
    if (code < 0x80) return byte(code);
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    byte((more == 1 ? 0xC0U : more == 2 ? 0xE0U : 0xF0U) | code >> (6 * more));
    for (int i = more; i-- > 0;) byte(0x80U | (code >> (6 * i) & 0x3FU));
  }

  /// One character of more than a byte, which must be shortest, no surrogate, and at most U+10FFFF.
  void multibyte(std::string& result) {
    const auto byte = [&](std::size_t i) -> std::uint32_t {
      return at_ + i < text_.size() ? static_cast<unsigned char>(text_[at_ + i]) : 0U;
    };
    const std::uint32_t first = byte(0);
    const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    std::uint32_t code = first & (more == 3 ? 0x07U : more == 2 ? 0x0FU : 0x1FU);
    bool good = first >= 0xC2 && first <= 0xF4;
    for (std::size_t i = 1; i <= more; ++i) {
      good = good && (byte(i) & 0xC0U) == 0x80U;
      code = code << 6 | (byte(i) & 0x3FU);
    }
    const std::uint32_t least = more == 3 ? 0x10000 : more == 2 ? 0x800 : 0x80;
    if (!good || code < least || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF))
      fail("bytes that are not UTF-8");
    result += text_.substr(at_, more + 1);
    at_ += more + 1;
  }

  std::string string() {
    expect('"');
    std::string result;
    while (true) {
      if (at_ == text_.size()) fail("a string without end");
      const char c = text_[at_];
      if (c == '"') break;
      if (static_cast<unsigned char>(c) < 0x20) fail("a control character in a string");
      if (static_cast<unsigned char>(c) >= 0x80) {
        multibyte(result);
        continue;
      }
      ++at_;
      if (c == '\\') {
        escape(result);
      } else {
        result += c;
      }
    }
    ++at_;
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

[[noreturn]] void wrong(const Json& value, const char* expected) {
  throw Malformed("'" + value.text.substr(0, 40) + "' found, expected " + expected);
}

const std::string& string_of(const Json& value, const char* expected) {
  if (value.kind != Json::Kind::string) wrong(value, expected);
  return value.text;
}

}  // namespace

Json parse_json(std::string_view text) { return Parser(text).document(); }

std::uint32_t to_index(const Json& value) {
  const bool digits = value.kind == Json::Kind::number && std::all_of(value.text.begin(), value.text.end(), is_digit);
  if (!digits || value.text.size() > 10) wrong(value, "an index");
  const std::uint64_t index = std::stoull(value.text);
  if (index > 0xFFFFFFFFU) wrong(value, "an index");
  return static_cast<std::uint32_t>(index);
}

mpz_class to_small_integer(const Json& value) {
  std::string_view text = value.text;
  const bool negative = take(text, '-');
  const bool digits = value.kind == Json::Kind::number && !text.empty() && text.size() <= 16 &&
                      std::all_of(text.begin(), text.end(), is_digit);
  if (!digits || (negative && text == "0")) wrong(value, "an integer of at most 2^53");
  const mpz_class result = integer(text);
  if (result > mpz_class(0x1p53)) wrong(value, "an integer of at most 2^53");
  return negative ? mpz_class(-result) : result;
}

mpq_class to_rational(const Json& value) {
  std::string_view text = string_of(value, "a rational in a string");
  const bool negative = take(text, '-');
  const std::string_view numerator = take_digits(text);
  std::string_view denominator = "1";
  std::size_t digits = numerator.size();
  if (take(text, '/')) {
    denominator = take_digits(text);
    digits += denominator.size();
  }
  if (numerator.empty() || denominator.empty() || !text.empty() || digits > kMaxDigits) wrong(value, "a rational");
  mpq_class result(integer(numerator), integer(denominator));
  if (result.get_den() == 0) wrong(value, "a rational");
  result.canonicalize();
  return negative ? mpq_class(-result) : result;
}

mpz_class to_integer(const Json& value) {
  std::string_view text = string_of(value, "an integer in a string");
  const bool negative = take(text, '-');
  const std::string_view digits = take_digits(text);
  if (digits.empty() || !text.empty() || digits.size() > kMaxDigits) wrong(value, "an integer");
  const mpz_class result = integer(digits);
  return negative ? mpz_class(-result) : result;
}

mpq_class to_decimal(const Json& value) {
  const std::string& text = string_of(value, "a decimal in a string");
  if (text.find('/') != std::string::npos) return to_rational(value);
  const Written number = as_written(text);
  if (!number.good || number.exponent_digits > 4 || number.digits.size() > kMaxDigits) wrong(value, "a decimal");
  mpq_class result = magnitude(number);
  result.canonicalize();
  return number.negative ? mpq_class(-result) : result;
}

Binary64 to_binary64(const Json& value) {
  if (value.kind != Json::Kind::number) wrong(value, "a number");
  const Written number = as_written(value.text);
  const mpz_class digits = integer(number.digits);
  if (digits == 0) return {};
  const auto size = static_cast<long>(mpz_sizeinbase(digits.get_mpz_t(), 10));  // Or one more than the digits.
  if (size + number.exponent < -330) return {};  // Less than 10^-330, half of the least binary64 is more.
  if (size + number.exponent > 330) wrong(value, "a finite binary64 number");
  const mpq_class exact = magnitude(number);
  const mpz_class& numerator = exact.get_num();
  const mpz_class& denominator = exact.get_den();
  // The quotient by 2^k has 53 bits, or k is that of the subnormal numbers.
  const auto bits = [](const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  long k = std::max(bits(numerator) - bits(denominator) - 53, -1074L);
  mpz_class quotient, remainder, divisor;
  for (;; ++k) {
    const mpz_class dividend = k < 0 ? mpz_class(numerator << static_cast<mp_bitcnt_t>(-k)) : numerator;
    divisor = k < 0 ? denominator : mpz_class(denominator << static_cast<mp_bitcnt_t>(k));
    mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());
    if (bits(quotient) <= 53) break;
  }
  const int half = cmp(2 * remainder, divisor);
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0)) ++quotient;
  if (bits(quotient) + k > 1024) wrong(value, "a finite binary64 number");
  return {number.negative ? mpz_class(-quotient) : quotient, k};
}

}  // namespace epsnet::exact
