#pragma once

#include <epsnet/certify/ball.h>
#include <epsnet/certify/exact.h>
#if __has_include(<flint/fmpz_poly.h>)
#include <flint/fmpz_poly.h>
#else
#include <fmpz_poly.h>
#endif

#include <cstdint>

/// The numbers of the regular 4g-gon, exactly: Z[ζ, s] with ζ = e^{iπ/(2g)} and s = √(a² − 1), a = cot(π/(4g)).
///
/// a = i(ζ + 1)/(ζ − 1) = −ζ^g(ζ + ζ² + … + ζ^{2g−1}) is in Z[ζ], so all crossings are over this ring (docs/proof.md,
/// section 9). A number is A + B s; A and B are polynomials in ζ of degree less than 2g, calculated with modulo
/// ζ^{2g} + 1 = 0. That is not the least relation of ζ: different polynomials may be the same number.
namespace epsnet::certify {

/// Owner of FLINT's polynomials with integer coefficients.
class IntegerPolynomial {
 public:
  IntegerPolynomial() { fmpz_poly_init(value_); }
  IntegerPolynomial(const IntegerPolynomial& other) {
    fmpz_poly_init(value_);
    fmpz_poly_set(value_, other.value_);
  }
  IntegerPolynomial(IntegerPolynomial&& other) noexcept {
    fmpz_poly_init(value_);
    fmpz_poly_swap(value_, other.value_);
  }
  IntegerPolynomial& operator=(const IntegerPolynomial& other) {
    fmpz_poly_set(value_, other.value_);
    return *this;
  }
  IntegerPolynomial& operator=(IntegerPolynomial&& other) noexcept {
    fmpz_poly_swap(value_, other.value_);
    return *this;
  }
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }

  [[nodiscard]] fmpz_poly_struct* get() { return value_; }
  [[nodiscard]] const fmpz_poly_struct* get() const { return value_; }

 private:
  fmpz_poly_t value_;
};

/// What the numbers of one genus have in common.
class RegularRing {
 public:
  explicit RegularRing(std::uint32_t genus);

  [[nodiscard]] std::uint32_t genus() const { return genus_; }
  /// cot(π/(4g)) and s² as polynomials in ζ.
  [[nodiscard]] const IntegerPolynomial& cotangent() const { return cotangent_; }
  [[nodiscard]] const IntegerPolynomial& s_squared() const { return s_squared_; }
  /// The least polynomial of ζ over Q, the cyclotomic polynomial of order 4g.
  [[nodiscard]] const IntegerPolynomial& cyclotomic() const { return cyclotomic_; }

 private:
  std::uint32_t genus_;
  IntegerPolynomial cotangent_;
  IntegerPolynomial s_squared_;
  IntegerPolynomial cyclotomic_;
};

/// even + odd · s. The ring must outlive its numbers.
struct RegularNumber {
  const RegularRing* ring;
  IntegerPolynomial even;
  IntegerPolynomial odd;
};

/// A Gaussian integer as a number of the ring; i = ζ^g.
[[nodiscard]] RegularNumber regular_number(const RegularRing& ring, const Gaussian& x);

// Numbers of the same ring only.
[[nodiscard]] RegularNumber operator+(const RegularNumber& x, const RegularNumber& y);
[[nodiscard]] RegularNumber operator-(const RegularNumber& x, const RegularNumber& y);
[[nodiscard]] RegularNumber operator*(const RegularNumber& x, const RegularNumber& y);
[[nodiscard]] RegularNumber operator*(const mpz_class& x, const RegularNumber& y);
[[nodiscard]] RegularNumber operator*(const Gaussian& x, const RegularNumber& y);
/// ζ ↦ ζ⁻¹; s is real.
[[nodiscard]] RegularNumber conjugate(const RegularNumber& x);
/// |x|², a real number.
[[nodiscard]] RegularNumber norm(const RegularNumber& x);
/// x + x̄ and −i(x − x̄), real numbers.
[[nodiscard]] RegularNumber twice_real(const RegularNumber& x);
[[nodiscard]] RegularNumber twice_imaginary(const RegularNumber& x);

/// The same isometry with the common divisor of its coefficients taken out.
void reduce(Isometry<RegularNumber>& f);

/// Whether the number is 0, exactly: A + B s = 0 if and only if A = B = 0, since s is not in Q(ζ) (docs/proof.md, Lemma
/// 9).
[[nodiscard]] bool is_zero(const RegularNumber& x);
/// The sign of a real number: 0 exactly, otherwise by balls of more and more bits, which must end.
[[nodiscard]] int sign(const RegularNumber& x);

/// a = cot(π/(4g)) = cosh ρ and s = √(a² − 1) = sinh ρ, ρ the distance of the centre from the sides.
void set_regular_apothem(arb_ptr cosh, arb_ptr sinh, std::uint32_t genus, slong precision);
/// e^{ikπ/(2g)}.
void set_regular_direction(acb_ptr result, std::uint32_t genus, std::uint32_t k, slong precision);

}  // namespace epsnet::certify
