#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/exact.h"

/// The numbers of regular polygons, exactly: ℤ[ζ, s] with ζ = e^{2πi/n} and s² a positive number of ℤ[ζ].
///
/// Regular tiles have such a ring (certify/net/labels.h, docs/proof.md, section 9).
namespace epsnet::certify {

/// coefficient·ζ^power.
struct PowerOfZeta {
  std::int64_t coefficient;
  std::int64_t power;
};

/// One ring. Arithmetic and `sign` take their work off the budget; BudgetSpent, if that is too much.
class RegularRing {
 public:
  /// ζ = e^{2πi/order}, 4 divides the order; s > 0 has the given square.
  RegularRing(std::uint32_t order, std::span<const PowerOfZeta> square_of_s, Budget budget = {});

  [[nodiscard]] std::uint32_t order() const { return order_; }
  [[nodiscard]] const Polynomial& square_of_s() const { return square_of_s_; }
  /// Whether s is known not to be in ℚ(ζ), so that u + vs = 0 means u = v = 0. O(order) at worst.
  [[nodiscard]] bool has_new_root() const { return has_new_root_; }
  [[nodiscard]] const Budget& budget() const { return budget_; }

  /// The polynomial in ζ. O(order + terms).
  [[nodiscard]] Polynomial polynomial(std::span<const PowerOfZeta> terms) const;
  /// Whether the polynomial, of degree less than order/2, is 0 at ζ.
  [[nodiscard]] bool is_zero(const Polynomial& x) const;
  struct Roots {
    ComplexBall zeta;
    Ball s;
  };
  /// ζ and s, to as many bits as balls have at least. For any number of threads.
  [[nodiscard]] Roots roots() const;

 private:
  std::uint32_t order_;
  Budget budget_;
  Polynomial cyclotomic_;
  Polynomial square_of_s_;
  bool has_new_root_;
  mutable std::mutex mutex_;
  mutable std::map<slong, Roots> roots_;  ///< By bits.
};

/// The number u(ζ) + v(ζ)s. The degrees are less than order/2, as ζ^{order/2} = −1; different polynomials may be equal
/// at ζ. The ring must outlive the number.
struct RegularNumber {
  const RegularRing* ring;
  Polynomial u;
  Polynomial v = {};
};

/// A Gaussian integer, and u + vs.
[[nodiscard]] RegularNumber regular_number(const RegularRing& ring, const Gaussian& x);
[[nodiscard]] RegularNumber regular_number(const RegularRing& ring, std::span<const PowerOfZeta> u,
                                           std::span<const PowerOfZeta> v);

// Numbers of the same ring only.
[[nodiscard]] RegularNumber operator+(RegularNumber x, RegularNumber y);
[[nodiscard]] RegularNumber operator-(RegularNumber x, RegularNumber y);
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

/// No divisor is looked for.
inline void reduce(Isometry<RegularNumber>& /*f*/) {}

/// A real number, to about as many bits as balls have, relative to its coefficients.
[[nodiscard]] Ball real_ball(const RegularNumber& x);
/// The sign of u + vs, u and v real numbers, exactly: of what is not 0 by balls of more and more bits, which must end.
[[nodiscard]] int sign(const RegularNumber& x);

}  // namespace epsnet::certify
