#pragma once

#include <cctype>
#include <cstdint>
#include <flint/fmpq_poly.h>
#include <gmpxx.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/document.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/exact.h"
#include "triangulation/surface/surface.h"

/// Real numbers as texts, in the least number field that has them.
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

struct RationalPolynomialType {
  using Struct = fmpq_poly_struct;
  static void init(Struct* x) { fmpq_poly_init(x); }
  static void set(Struct* x, const Struct* y) { fmpq_poly_set(x, y); }
  static void swap(Struct* x, Struct* y) { fmpq_poly_swap(x, y); }
  static void clear(Struct* x) { fmpq_poly_clear(x); }
};

/// A polynomial over ℚ.
using RationalPolynomial = certify::Owner<RationalPolynomialType>;
/// The polynomial of degree 0, or 0.
[[nodiscard]] RationalPolynomial constant(const mpq_class& x);

[[nodiscard]] inline mpz_class denominator_of(const RationalPolynomial& x) {
  certify::Integer result;
  fmpq_poly_get_denominator(result.get(), x.get());
  return result.value();
}

/// A real number field ℚ(α) that grows with the numbers that are read: sums, differences, products, quotients and
/// integer powers of integers, fractions, decimals (which are exact), sqrt(x), cos(a*pi/b), sin(a*pi/b), and
/// root(f,r), the real root of a polynomial in x with rational coefficients that is nearest to the decimal r.
class NumberFieldReader {
 public:
  /// The largest degree of a field; files have none of more.
  static constexpr slong kMostDegree = 64;

  NumberFieldReader();

  /// Reads a number. Throws SurfaceError, which says what is wrong, also of a field of more than kMostDegree.
  void add(std::string_view text);

  /// The minimal polynomial of α, monic over ℤ, and an interval that isolates α.
  [[nodiscard]] certify::SurfaceDocument::Field field() const;
  /// The numbers in the order in which they were read, as polynomials in α.
  [[nodiscard]] const std::vector<RationalPolynomial>& numbers() const { return numbers_; }

  [[nodiscard]] RationalPolynomial product(const RationalPolynomial& x, const RationalPolynomial& y) const;
  /// To 4,096 bits.
  [[nodiscard]] certify::Ball value(const RationalPolynomial& x) const;

 private:
  friend class NumberFieldParser;

  /// A number that is named by a word of the text, so that it is adjoined once.
  struct Named {
    std::string name;
    RationalPolynomial value;
  };

  [[nodiscard]] slong degree() const { return fmpz_poly_degree(f_.get()); }
  [[nodiscard]] RationalPolynomial quotient(const RationalPolynomial& x, const RationalPolynomial& y) const;
  /// The root t, near which it is known, of t^m + p[m − 1] t^(m−1) + …, in the field that has it as well.
  [[nodiscard]] RationalPolynomial adjoined(const std::vector<RationalPolynomial>& p, const certify::Ball& t);
  /// As `adjoined`, but for coefficients without fractions.
  [[nodiscard]] RationalPolynomial adjoined_integer(const std::vector<RationalPolynomial>& p, const certify::Ball& t);
  /// The field becomes ℚ(θ), θ the root of h near which it is known. Numbers of the field, polynomials in α, which is
  /// this polynomial in θ, become polynomials in the new α, and so does `also`, a polynomial in θ.
  void move_to(const certify::Polynomial& h, const certify::Ball& theta, const RationalPolynomial& alpha,
               RationalPolynomial& also);

  certify::Polynomial f_;
  certify::Ball alpha_;
  std::vector<Named> named_;
  std::vector<RationalPolynomial> numbers_;
};

/// A polynomial with these coefficients, in the variable or number of this name, as NumberFieldReader reads it.
[[nodiscard]] std::string polynomial_text(const std::vector<mpz_class>& coefficients, const std::string& name);

}  // namespace epsnet
