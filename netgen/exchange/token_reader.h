#pragma once

#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "certify/base/text.h"
#include "kernel/numbers.h"
#include "netgen/base/gmp.h"
#include "netgen/exchange/exchange.h"

namespace epsnet {

/// Reads the tokens of a text, separated by white space, one after the other. Throws ExchangeError for anything
/// unexpected.
class TokenReader {
 public:
  /// Keeps a reference to the text, which must outlive the reader. `name` stands for the text in messages.
  TokenReader(std::string_view text, std::string_view name) : rest_(text), name_(name) {}
  template <std::same_as<std::string> Text>
  TokenReader(Text&&, std::string_view) = delete;  // A temporary string would not outlive the reader.

  /// Returns the next token; `expected` completes the message if there is none.
  std::string_view next(const std::string& expected) {
    skip_white_space();
    if (rest_.empty()) fail("the text ends here, expected " + expected);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kWhiteSpace));
    rest_.remove_prefix(word.size());
    return word;
  }

  /// Requires that the text ends here; `last` is the name of what it should have ended with.
  void expect_end(const std::string& last) {
    skip_white_space();
    if (rest_.empty()) return;
    fail(certify::in_quotes(next("")) + " follows " + last + ", expected the end of the text");
  }

  /// Reads an unsigned number of 32 bits.
  std::uint32_t index(const std::string& expected) {
    const std::string_view word = next(expected);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      fail(certify::in_quotes(word) + " found, expected " + expected);
    }
    return value;
  }

  Rational rational(const std::string& expected) {
    const std::string_view word = next(expected);
    const std::optional<mpq_class> value = certify::parse_rational(word);
    if (!value) {
      fail(certify::in_quotes(word) + " found, expected " + expected +
           ": a rational number p/q or p of at most 10^6 digits (decimals are not accepted)");
    }
    return from_gmp(*value);
  }

  /// Returns the line of the last token.
  [[nodiscard]] std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& message) const { fail_at(line_, message); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const {
    const std::string number = std::to_string(line);
    throw ExchangeError(name_ + ":" + number + ": " + message,
                        certify::ErrorParts{.file = name_, .place = number, .problem = message});
  }

 private:
  static constexpr std::string_view kWhiteSpace = " \t\n\v\f\r";

  void skip_white_space() {
    const std::size_t length = std::min(rest_.find_first_not_of(kWhiteSpace), rest_.size());
    line_ +=
        static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
    rest_.remove_prefix(length);
  }

  std::string_view rest_;
  std::string name_;
  std::size_t line_ = 1;
};

}  // namespace epsnet
