#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <gmpxx.h>
#include <map>
#include <vector>

#include "certify/exact/interval.h"

/// The real numbers that regular tiles need, exactly (docs/proof.md, section 9).
namespace epsnet::exact {

// What the kinds of algebraic numbers share: the integers of which they are combinations.

/// The last one is not 0.
using Integers = std::vector<mpz_class>;

inline void trim(Integers& x) {
  while (!x.empty() && x.back() == 0) x.pop_back();
}

/// x + y.
inline Integers sum(Integers x, const Integers& y) {
  x.resize(std::max(x.size(), y.size()));
  for (std::size_t i = 0; i < y.size(); ++i) x[i] += y[i];
  trim(x);
  return x;
}

/// Of a real number, times some power of 2: nearer to it than the error, or no farther.
struct Approximation {
  mpz_class value;
  mpz_class error;
};

/// A real algebraic integer, to be compared with others of another field (docs/proof.md, Lemma 45).
struct RealNumber {
  unsigned long n = 1;     ///< It is in an extension of ℚ(2cos(2π/n)),
  std::size_t degree = 1;  ///< of this degree at most.
  std::size_t bits = 1;    ///< Its conjugates are at most 2^bits.
  /// 2^k times the number.
  std::function<Approximation(mp_bitcnt_t k)> approximation;
  Integers field;  ///< Numbers of which these are equal are in one such extension. Empty: an integer.
};

inline RealNumber real_number(const mpz_class& n) {
  return {1, 1, mpz_sizeinbase(n.get_mpz_t(), 2), [n](mp_bitcnt_t k) { return Approximation{n << k, 0}; }, {}};
}

/// k such that 2^k is not less than the sum of the absolute values.
inline std::size_t sum_bits(const Integers& x) {
  mpz_class sum;
  for (const mpz_class& n : x) sum += abs(n);
  return mpz_sizeinbase(sum.get_mpz_t(), 2);
}

// The numbers of regular tiles.

class Algebraic;

/// x_0 + Σ x_k 2cos(2πk/n), k >= 1.
using Cosines = Integers;

/// The degree of ℚ(2cos(2π/n)). O(√n).
[[nodiscard]] std::size_t degree_of_cosines(unsigned long n);

/// ℤ[2cos(2π/n), s] for regular p-gons with the angles 2π/q. With d_m = 2 sin(π/m), s = d_p d_q sinh ρ and so
/// s² = (2 − 2cos(2π/q))(2cos(2π/p) + 2cos(2π/q)).
class RealField {
 public:
  /// n = lcm(4, q, p), or lcm(4, q, 2p) if `half_turns`. p, q >= 3, (p − 2)(q − 2) > 4. Throws TooLarge if the field of
  /// the cosines has a degree of more than kMaxDegree.
  RealField(unsigned long p, unsigned long q, bool half_turns);
  RealField(const RealField&) = delete;
  RealField& operator=(const RealField&) = delete;

  static constexpr std::size_t kMaxDegree = 64;

  [[nodiscard]] unsigned long n() const { return n_; }
  /// Numbers that only fields of the same numbers have.
  [[nodiscard]] Integers name() const { return {p_, q_, n_}; }
  /// Of the field of the cosines: numbers are given by this many first cosines.
  [[nodiscard]] std::size_t degree() const { return relation_.size() - 1; }
  /// 2 cos(2πk/n).
  [[nodiscard]] Algebraic cosine(long k) const;
  [[nodiscard]] Algebraic s() const;

  [[nodiscard]] Cosines product(const Cosines& x, const Cosines& y) const;
  [[nodiscard]] const Cosines& square_of_s() const { return square_of_s_; }

  /// 2^bits times 1, 2cos(2π/n), 2cos(4π/n), … and, the last one, s: integers that are wrong by less than 1.
  [[nodiscard]] const std::vector<mpz_class>& values(mp_bitcnt_t bits) const;

 private:
  /// Normal form: fewer than degree() + 1 numbers.
  void reduce(Cosines& x) const;

  unsigned long p_;
  unsigned long q_;
  unsigned long n_;
  /// The cyclotomic polynomial: 0 = r_0 + Σ r_k 2cos(2πk/n), of which the last r_k is 1.
  std::vector<long> relation_;
  Cosines square_of_s_;
  mutable std::map<mp_bitcnt_t, std::vector<mpz_class>> values_;
};

/// u + vs. An integer belongs to every field; other numbers of one formula to the same one, which must live as long.
class Algebraic {
 public:
  Algebraic(long n = 0) : Algebraic(mpz_class(n)) {}  // NOLINT(google-explicit-constructor): numbers in formulas.
  Algebraic(const mpz_class& n);                      // NOLINT(google-explicit-constructor)
  Algebraic(const RealField& field, Cosines u, Cosines v);

  [[nodiscard]] const Cosines& u() const { return u_; }

  friend Algebraic operator+(const Algebraic& x, const Algebraic& y);
  friend Algebraic operator-(const Algebraic& x, const Algebraic& y);
  friend Algebraic operator-(const Algebraic& x);
  friend Algebraic operator*(const Algebraic& x, const Algebraic& y);

  /// The sign, exactly.
  friend int sgn(const Algebraic& x);
  friend Interval enclosure(const Algebraic& x);
  /// Of copies of the number; the field must live as long.
  friend RealNumber real_number(const Algebraic& x);

  friend void take_common(const Algebraic& x, mpz_class& common);
  friend void divide(Algebraic& x, const mpz_class& divisor);
  /// Bits of all integers, as often as the degree says: the cost of a product.
  friend std::size_t bits(const Algebraic& x);

 private:
  /// Of 2^(2 bits) times the number.
  [[nodiscard]] Approximation approximation(mp_bitcnt_t bits) const;
  [[nodiscard]] bool is_integer() const { return u_.size() <= 1 && v_.empty(); }

  const RealField* field_ = nullptr;  ///< None for integers.
  Cosines u_;
  Cosines v_;
};

}  // namespace epsnet::exact
