#pragma once

#include <flint/fmpq_poly.h>
#include <gmpxx.h>
#include <string>
#include <string_view>
#include <vector>

#include "certify/net/document.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/polynomial.h"

/// Real numbers as texts, in the least number field that has them.
namespace epsnet {

struct RationalPolynomialType {
  using Struct = fmpq_poly_struct;
  static void init(Struct* x) { fmpq_poly_init(x); }
  static void set(Struct* x, const Struct* y) { fmpq_poly_set(x, y); }
  static void swap(Struct* x, Struct* y) { fmpq_poly_swap(x, y); }
  static void clear(Struct* x) { fmpq_poly_clear(x); }
};

/// A polynomial over ℚ.
using RationalPolynomial = certify::Owner<RationalPolynomialType>;

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
