#pragma once

#include <cctype>
#include <cstdint>
#include <gmpxx.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "certify/base/text.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// Reads sums, differences, products, quotients and powers of numbers, with parentheses. What the operations are, and
/// what numbers may be besides decimals, says the class that is derived. All members throw SurfaceError, which names
/// the character.
template <class Number>
class ArithmeticParser {
 public:
  explicit ArithmeticParser(std::string_view text) : text_(text) {}
  ArithmeticParser(const ArithmeticParser&) = delete;
  ArithmeticParser& operator=(const ArithmeticParser&) = delete;
  virtual ~ArithmeticParser() = default;

  /// Reads all of the text.
  [[nodiscard]] Number read() {
    Number result = sum_of_products();
    (void)take("");
    if (at_ != text_.size()) fail("an operator");
    return result;
  }

 protected:
  [[nodiscard]] virtual Number constant(const mpq_class& x) = 0;
  [[nodiscard]] virtual Number negative(Number x) = 0;
  [[nodiscard]] virtual Number sum(Number x, const Number& y) = 0;
  [[nodiscard]] virtual Number product(const Number& x, const Number& y) = 0;
  /// Fails if there is none.
  [[nodiscard]] virtual Number quotient(const Number& x, const Number& y) = 0;
  /// Reads a number that is no decimal, if there is one.
  [[nodiscard]] virtual std::optional<Number> named_number() = 0;
  /// What a number may be, for messages.
  [[nodiscard]] virtual std::string expected_number() const = 0;

  [[noreturn]] void fail(const std::string& expected) const {
    throw SurfaceError(certify::in_quotes(text_) + ": expected " + expected + " at character " +
                       std::to_string(at_ + 1));
  }

  /// Takes the token, if it is next, after white space.
  bool take(std::string_view token) {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }
  void expect(std::string_view token) {
    if (!take(token)) fail("'" + std::string(token) + "'");
  }

  /// Of digits and perhaps a point.
  mpq_class decimal() {
    (void)take("");
    const std::size_t first = at_;
    while (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.'))
      ++at_;
    constexpr std::size_t kMostDigits = 10'000;
    const auto value =
        at_ - first > kMostDigits ? std::nullopt : certify::parse_decimal(text_.substr(first, at_ - first));
    if (!value) {
      at_ = first;
      fail(expected_number());
    }
    return *value;
  }

  /// Not negative, and at most a million.
  long integer() {
    constexpr long kGreatest = 1'000'000;
    const std::size_t first = at_;
    const mpq_class value = decimal();
    if (value.get_den() != 1 || value > kGreatest) {
      at_ = first;
      fail("an integer of at most a million");
    }
    return value.get_num().get_si();
  }

  /// a/b of "a*pi/b)".
  mpq_class angle() {
    const long sign = take("-") ? -1 : 1;
    long times = 1;
    if (!take("pi")) {
      times = integer();
      expect("*");
      expect("pi");
    }
    const long by = take("/") ? integer() : 1;
    if (by == 0) fail("a number other than 0 before this");
    expect(")");
    mpq_class result(sign * times, by);
    result.canonicalize();
    return result;
  }

  Number sum_of_products() {
    Number result = product_of_powers();
    while (true) {
      if (take("+")) {
        result = sum(std::move(result), product_of_powers());
      } else if (take("-")) {
        result = sum(std::move(result), negative(product_of_powers()));
      } else {
        return result;
      }
    }
  }

  /// The next character, and what begins at a character and ends here.
  [[nodiscard]] std::size_t place() const { return at_; }
  [[nodiscard]] std::string text_from(std::size_t first) const { return std::string(text_.substr(first, at_ - first)); }

 private:
  Number product_of_powers() {
    Number result = power();
    while (true) {
      if (take("*")) {
        result = product(result, power());
      } else if (take("/")) {
        result = quotient(result, power());
      } else {
        return result;
      }
    }
  }

  /// -x^2 is -(x^2).
  Number power() {
    if (take("-")) return negative(at_depth([&] { return power(); }));
    Number base = at_depth([&] { return factor(); });
    if (!take("^")) return base;
    constexpr long kGreatestPower = 64;
    const long exponent = integer();
    if (exponent > kGreatestPower) fail("a power of at most " + std::to_string(kGreatestPower) + " before this");
    Number result = constant(1);
    for (long i = 0; i < exponent; ++i) result = product(result, base);
    return result;
  }

  template <class Read>
  Number at_depth(const Read& read) {
    constexpr int kMostDepth = 100;
    if (++depth_ > kMostDepth) fail("fewer parentheses, or signs before a number,");
    Number result = read();
    --depth_;
    return result;
  }

  Number factor() {
    if (take("(")) {
      Number result = sum_of_products();
      expect(")");
      return result;
    }
    if (auto named = named_number()) return *std::move(named);
    return constant(decimal());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace epsnet
