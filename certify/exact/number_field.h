#pragma once

#include <gmpxx.h>
#include <map>
#include <vector>

#include "certify/exact/algebraic.h"
#include "certify/exact/interval.h"

/// The real numbers of surfaces over a number field, exactly (docs/proof.md, section 9.1).
namespace epsnet::exact {

/// The coefficients of 1, x, x², ….
using Polynomial = Integers;

/// ℤ[α] for the one root α of a polynomial f in an interval. f need not be irreducible.
class NumberField {
 public:
  /// Half a minute of work with the field and its numbers, and what a triangle of a net may take besides.
  static constexpr std::size_t kUsualWork = std::size_t{1} << 36;
  static constexpr std::size_t kWorkOfATriangle = std::size_t{1} << 21;

  /// f is monic, of degree 1 to 64, and lower < upper. Throws Refutation if f has no root between them, and TooLarge if
  /// Descartes' rule (Lemma 9.2) does not say that it has exactly one, or if the numbers are too large. All that is
  /// asked of it later takes work, and throws TooLarge if that is not left.
  NumberField(Polynomial f, const mpq_class& lower, const mpq_class& upper, std::size_t work = kUsualWork);
  NumberField(const NumberField&) = delete;
  NumberField& operator=(const NumberField&) = delete;

  [[nodiscard]] std::size_t degree() const { return f_.size() - 1; }

  /// Numbers that only fields of the same root have.
  [[nodiscard]] Integers name() const;
  /// k such that all complex roots of f are at most 2^k.
  [[nodiscard]] std::size_t bits_of_roots() const;

  /// A polynomial of less than this degree with the same value at α.
  [[nodiscard]] Polynomial reduced(Polynomial x) const;
  [[nodiscard]] Polynomial product(const Polynomial& x, const Polynomial& y) const;

  /// 2^bits x(α), x of less than this degree.
  [[nodiscard]] Approximation approximation(const Polynomial& x, mp_bitcnt_t bits) const;
  /// Whether x(α) = 0 (Lemma 9.3).
  [[nodiscard]] bool is_zero(const Polynomial& x) const;

 private:
  /// The sign of α − n/2^e.
  [[nodiscard]] int compare(const mpz_class& n, long e) const;
  /// 2^(e·degree) f(n/2^e), or f(n/2^e) if e < 0.
  [[nodiscard]] mpz_class scaled_value(const mpz_class& n, long e) const;
  /// The greatest n <= 2^bits α.
  [[nodiscard]] mpz_class root(mp_bitcnt_t bits) const;
  /// Makes exponent_ larger.
  void refine() const;
  /// 2^bits times 1, α, α², ….
  [[nodiscard]] const std::vector<Approximation>& powers(mp_bitcnt_t bits) const;
  [[nodiscard]] bool excludes_zero(const Polynomial& x, mp_bitcnt_t bits) const;
  /// Takes so much from the work that is left. Throws TooLarge.
  void spend(std::size_t work) const;

  Polynomial f_;
  mpz_class lower_;  ///< lower_/denominator_ < α < upper_/denominator_
  mpz_class upper_;
  mpz_class denominator_;
  int sign_below_ = 0;  ///< Of f between lower_ and α.

  mutable std::size_t work_left_;
  mutable mpz_class floor_;  ///< floor_ <= 2^exponent_ α < floor_ + 1
  mutable long exponent_ = 0;
  mutable unsigned long step_ = 1;  ///< By so many bits exponent_ will grow, if the secant is near enough to f.
  mutable Polynomial factor_;       ///< The least known one of f of which α is a root.
  mutable std::map<mp_bitcnt_t, std::vector<Approximation>> powers_;
};

/// x(α). An integer belongs to every field; other numbers of one formula to the same one, which must live as long.
/// Products, signs and enclosures throw TooLarge if too little work is left.
class FieldNumber {
 public:
  FieldNumber(long n = 0) : FieldNumber(mpz_class(n)) {}  // NOLINT(google-explicit-constructor): numbers in formulas.
  FieldNumber(const mpz_class& n) : x_{n} { trim(x_); }   // NOLINT(google-explicit-constructor)
  FieldNumber(const NumberField& field, const Polynomial& x);

  friend FieldNumber operator+(const FieldNumber& x, const FieldNumber& y);
  friend FieldNumber operator-(const FieldNumber& x, const FieldNumber& y);
  friend FieldNumber operator-(const FieldNumber& x);
  friend FieldNumber operator*(const FieldNumber& x, const FieldNumber& y);

  /// The sign, exactly.
  friend int sgn(const FieldNumber& x);
  friend Interval enclosure(const FieldNumber& x);
  /// Of copies of the number; the field must live as long.
  friend RealNumber real_number(const FieldNumber& x);

  friend void take_common(const FieldNumber& x, mpz_class& common);
  friend void divide(FieldNumber& x, const mpz_class& divisor);
  /// Bits of all integers, as often as the degree says: the cost of a product.
  friend std::size_t bits(const FieldNumber& x);

 private:
  [[nodiscard]] bool is_integer() const { return x_.size() <= 1; }

  const NumberField* field_ = nullptr;  ///< None for integers.
  Polynomial x_;
};

}  // namespace epsnet::exact
