#pragma once

#include <array>
#include <gmpxx.h>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/exact.h"
#include "certify/numbers/isometry.h"

/// The numbers of a surface over a number field, exactly: ℤ[α, i], α a real root of a monic polynomial over ℤ.
///
/// The polynomial need not be irreducible (docs/proof.md, Lemma 9.3).
namespace epsnet::certify {

/// What Descartes' rule of signs says of the roots between two numbers.
struct RootCount {
  std::size_t changes = 0;  ///< 1: there is one, which is simple; 0: there is none (Lemma 9.2).
  int first_sign = 0;       ///< Of the polynomial between the lower number and the least of these roots.
};

/// Of the coefficients of (1 + x)^d f((lower + upper·x)/(1 + x)), d the degree of f. `f` has the coefficients of f from
/// that of 1 on.
[[nodiscard]] RootCount count_roots(const std::vector<mpz_class>& f, const mpq_class& lower, const mpq_class& upper);

/// ℤ[α]. Arithmetic and `sign` take their work off the budget; BudgetSpent, if that is too much. For any number of
/// threads.
class NumberField {
 public:
  /// α is the root of f between the two, of which count_roots says that there is one. f is monic.
  NumberField(const std::vector<mpz_class>& f, const std::array<mpq_class, 2>& between, Budget budget = {});

  [[nodiscard]] std::size_t degree() const { return static_cast<std::size_t>(fmpz_poly_degree(f_.get())); }
  [[nodiscard]] const Polynomial& f() const { return f_; }
  /// As given.
  [[nodiscard]] const std::array<mpq_class, 2>& between() const { return between_; }
  [[nodiscard]] const Budget& budget() const { return budget_; }
  /// The value at α, to about as many bits as balls have: relative to the coefficients.
  [[nodiscard]] Ball value(const Polynomial& x) const;
  /// Modulo f.
  void reduce(Polynomial& x) const;

 private:
  /// α to so many bits after the point.
  [[nodiscard]] Ball root(slong bits) const;
  /// Makes the next of the roots.
  void refine() const;

  Polynomial f_;
  std::array<mpq_class, 2> between_;
  Polynomial derivative_;
  Budget budget_;
  mutable std::mutex mutex_;
  /// By bits, each twice the ones before; the derivative is known to within a third on each of them.
  mutable std::map<slong, Ball> roots_;
};

/// The number re + im·i; the degrees are less than that of the field. The field must outlive the number.
struct FieldNumber {
  const NumberField* field;
  Polynomial re;
  Polynomial im = {};
};

/// A Gaussian integer, and e₀ + e₁α + ….
[[nodiscard]] FieldNumber field_number(const NumberField& field, const Gaussian& x);
[[nodiscard]] FieldNumber field_number(const NumberField& field, const std::vector<mpz_class>& coefficients);

// Numbers of the same field only.
[[nodiscard]] FieldNumber operator+(FieldNumber x, FieldNumber y);
[[nodiscard]] FieldNumber operator-(FieldNumber x, FieldNumber y);
[[nodiscard]] FieldNumber operator*(const FieldNumber& x, const FieldNumber& y);
[[nodiscard]] FieldNumber operator*(const mpz_class& x, const FieldNumber& y);
[[nodiscard]] FieldNumber operator*(const Gaussian& x, const FieldNumber& y);
[[nodiscard]] FieldNumber conjugate(FieldNumber x);
/// |x|², a real number.
[[nodiscard]] FieldNumber norm(const FieldNumber& x);
/// x + x̄ and −i(x − x̄), real numbers.
[[nodiscard]] FieldNumber twice_real(const FieldNumber& x);
[[nodiscard]] FieldNumber twice_imaginary(const FieldNumber& x);

/// The sign of a real number, exactly (Lemma 9.3).
[[nodiscard]] int sign(const FieldNumber& x);

/// The number of bits of all coefficients.
[[nodiscard]] std::size_t bits(const FieldNumber& x);
/// A real number, to about as many bits as balls have, relative to its size unless that is below 2^−bits(x).
[[nodiscard]] Ball real_ball(const FieldNumber& x);

// As of isometries in Gaussian integers (exact.h).

[[nodiscard]] inline std::size_t bits(const Isometry<FieldNumber>& f) { return bits(f.a) + bits(f.b); }
[[nodiscard]] inline FieldNumber determinant(const Isometry<FieldNumber>& f) { return norm(f.a) - norm(f.b); }
[[nodiscard]] inline bool is_identity(const Isometry<FieldNumber>& f) {
  return sign(twice_imaginary(f.a)) == 0 && sign(twice_real(f.b)) == 0 && sign(twice_imaginary(f.b)) == 0;
}
void reduce(Isometry<FieldNumber>& f);
/// The isometry, scaled to determinant 1, to about `precision` bits. `determinant` is that of f.
[[nodiscard]] BallIsometry to_balls(const Isometry<FieldNumber>& f, const FieldNumber& determinant, slong precision);

}  // namespace epsnet::certify
