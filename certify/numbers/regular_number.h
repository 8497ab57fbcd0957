#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/exact.h"

/// The numbers of the regular 4g-gon, exactly: Z[ζ, s] with ζ = e^{iπ/(2g)} and s = √(a² − 1), a = cot(π/(4g)).
///
/// a = −ζ^g(ζ + ζ² + … + ζ^{2g−1}) is in Z[ζ], so all crossings are over this ring (docs/proof.md, section 9). A number
/// is kept as the expression that makes it; `sign` evaluates that as often as it takes: bounds of all conjugates,
/// images in finite fields, and balls.
namespace epsnet::certify {

/// What the numbers of one genus have in common.
class RegularRing {
 public:
  /// `sign` takes its work off the budget.
  explicit RegularRing(std::uint32_t genus, Budget budget = {});

  [[nodiscard]] std::uint32_t genus() const { return genus_; }
  [[nodiscard]] const Budget& budget() const { return budget_; }

  /// Where embeddings of Q(ζ, s) in C send ζ and s: to e^{iθ}, θ = kπ/(2g), and to a root of cot²(θ/2) − 1, real or
  /// imaginary. One stands for four: θ and −θ, two roots. Logarithms have the base 2^(1/kLogScale), rounded up.
  struct Embeddings {
    std::int64_t log_s;
    std::int64_t log_inverse_sine;  ///< Of 1/sin(θ/2).
    bool s_is_real;
  };
  static constexpr std::int64_t kLogScale = 1024;
  [[nodiscard]] const std::vector<Embeddings>& embeddings() const { return embeddings_; }

  /// A homomorphism to the field of p elements: where ζ and s go.
  class Residues;
  /// Of different primes, in a fixed order. For any number of threads.
  [[nodiscard]] const Residues& residues(std::size_t i) const;

  ~RegularRing();
  RegularRing(const RegularRing&) = delete;
  RegularRing& operator=(const RegularRing&) = delete;

 private:
  std::uint32_t genus_;
  Budget budget_;
  std::vector<Embeddings> embeddings_;
  mutable std::mutex mutex_;
  mutable std::deque<Residues> residues_;  ///< Those that were asked for. References stay valid.
};

/// How a number is made of others.
struct RegularExpression;

/// A number of the ring. The ring must outlive it.
struct RegularNumber {
  const RegularRing* ring;
  std::shared_ptr<const RegularExpression> expression;  ///< Null: 0.
};

/// A Gaussian integer as a number of the ring; i = ζ^g.
[[nodiscard]] RegularNumber regular_number(const RegularRing& ring, const Gaussian& x);
/// ζ^k, and s.
[[nodiscard]] RegularNumber power_of_zeta(const RegularRing& ring, std::int64_t k);
[[nodiscard]] RegularNumber regular_s(const RegularRing& ring);

/// Which way a path turns around a corner of the tile: crossing side k is followed by k + 2g + 1 or k + 2g − 1.
enum class Turn { counterclockwise, clockwise };
/// The product of `count` ≥ 1 crossings that turn around one corner; the first is that of `side` (docs/proof.md, Lemma
/// 9.2).
[[nodiscard]] Isometry<RegularNumber> regular_turn(const RegularRing& ring, std::uint32_t side, std::uint32_t count,
                                                   Turn turn);
/// log2 of the product of all conjugates of an entry of that, roughly.
[[nodiscard]] std::size_t regular_turn_bits(const RegularRing& ring, std::uint32_t count);

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

/// Expressions have no divisor to be taken out.
inline void reduce(Isometry<RegularNumber>& /*f*/) {}

/// Upper bounds of |x| in the ring's embeddings, in their order, as logarithms (docs/proof.md, behind Lemma 9.1); x is
/// not the null expression. O(embeddings) for each part of the expression.
[[nodiscard]] std::vector<std::int64_t> log_bounds(const RegularNumber& x);

/// The logarithm of x > 0, rounded down to that of a power of 2.
[[nodiscard]] std::int64_t log_rounded_down(std::uint64_t x);

/// The sign of a real number, exactly: 0 if it is 0 in enough finite fields (docs/proof.md, Lemma 9.1), otherwise by
/// balls of more and more bits, which must end. Time: the size of the expression times the bits of its norm;
/// BudgetSpent, if that is too much.
[[nodiscard]] int sign(const RegularNumber& x);

/// a = cot(π/(4g)) = cosh ρ and s = √(a² − 1) = sinh ρ, ρ the distance of the centre from the sides.
void set_regular_apothem(arb_ptr cosh, arb_ptr sinh, std::uint32_t genus, slong precision);
/// e^{ikπ/(2g)}.
void set_regular_direction(acb_ptr result, std::uint32_t genus, std::uint32_t k, slong precision);

}  // namespace epsnet::certify
