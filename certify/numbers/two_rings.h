#pragma once

#include <algorithm>
#include <cstdint>
#include <gmpxx.h>
#include <numeric>
#include <optional>

#include "certify/numbers/budget.h"
#include "certify/numbers/exact.h"
#include "certify/numbers/field_number.h"
#include "certify/numbers/regular_number.h"

/// Real numbers of two different rings compared exactly, without a ring that contains both (docs/proof.md, Lemma 45).
namespace epsnet::certify {

/// The products xy and x'y' of numbers x, x' of one ring and y, y' of another.
template <class X, class Y>
struct ProductPair {
  X x;
  Y y;
  X other_x;
  Y other_y;
};

/// What is known of a real number of a ring: an algebraic integer.
struct RealNumber {
  std::uint64_t order;    ///< It is in an extension of ℚ(ζ) ∩ ℝ, ζ a root of unity of this order,
  std::uint64_t degree;   ///< of this degree at most.
  std::uint64_t bits;     ///< Its conjugates are at most 2^bits.
  std::uint64_t storage;  ///< The bits of all its integers, about.
};

[[nodiscard]] RealNumber real_number(const mpz_class& x);
[[nodiscard]] RealNumber real_number(const RegularNumber& x);
[[nodiscard]] RealNumber real_number(const FieldNumber& x);

/// Whether two numbers are known to be of one ring.
template <class X, class Y>
[[nodiscard]] bool of_one_ring(const X& /*x*/, const Y& /*y*/) {
  return false;
}
[[nodiscard]] bool of_one_ring(const RegularNumber& x, const RegularNumber& y);
[[nodiscard]] bool of_one_ring(const FieldNumber& x, const FieldNumber& y);

/// The degree of ℚ(ζ) ∩ ℝ, ζ a root of unity of this order.
[[nodiscard]] std::uint64_t cyclotomic_degree(std::uint64_t order);

/// Its value, with a relative error of 2^−precision of the bound of its conjugates, about.
[[nodiscard]] inline Ball value(const mpz_class& x) { return Ball::rounded(x); }
[[nodiscard]] inline Ball value(const RegularNumber& x) { return real_ball(x); }
[[nodiscard]] inline Ball value(const FieldNumber& x) { return x.field->value(x.re); }

/// Whether a number δ is 0 of which it is known that all conjugates are at most 2^bits, and that there are at most
/// `degree`; `enclosure` returns a ball of δ with the current precision. Nothing, if that takes too many bits.
template <class Enclosure>
[[nodiscard]] std::optional<bool> is_zero(std::uint64_t degree, std::uint64_t bits, const Enclosure& enclosure) {
  constexpr std::uint64_t kMostBits = std::uint64_t{1} << 21;
  if (bits > kMostBits / degree) return std::nullopt;
  // δ ≠ 0 is at least 2^(−bits (degree − 1)).
  const auto least = static_cast<slong>(bits * (degree - 1));
  std::optional<bool> answer;
  const auto attempt = [&](slong) {
    const Ball delta = enclosure();
    if (certain_sign(delta) != 0) {
      answer = false;
    } else if (certainly_less(abs(delta), scaled(Ball::exactly(1), -least)) == Tri::yes) {
      answer = true;
    }
    return answer.has_value();
  };
  with_rising_precision(4 * (least + static_cast<slong>(bits) + 256), attempt, 128 + static_cast<slong>(bits));
  return answer;
}

/// Whether xy = x'y'. Nothing, if that takes too many bits. BudgetSpent, if it is too much work.
template <class X, class Y>
[[nodiscard]] std::optional<bool> products_agree(const ProductPair<X, Y>& pair, const Budget& budget) {
  const RealNumber x = real_number(pair.x);
  const RealNumber y = real_number(pair.y);
  const RealNumber other_x = real_number(pair.other_x);
  const RealNumber other_y = real_number(pair.other_y);
  const std::uint64_t bits = std::max(x.bits + y.bits, other_x.bits + other_y.bits) + 1;
  const std::uint64_t storage = x.storage + y.storage + other_x.storage + other_y.storage;
  const std::uint64_t of_x = std::max(x.degree, other_x.degree);
  const std::uint64_t of_y = std::max(y.degree, other_y.degree);
  const std::uint64_t degree = cyclotomic_degree(std::lcm(x.order, y.order)) *
                               (of_one_ring(pair.x, pair.y) ? std::max(of_x, of_y) : of_x * of_y);
  return is_zero(degree, bits, [&] {
    const auto precision = static_cast<std::uint64_t>(Precision::bits());
    budget.spend(function_work(precision) + product_work(storage),
                 cyclotomic_degree(x.order) * of_x + cyclotomic_degree(y.order) * of_y);
    return value(pair.x) * value(pair.y) - value(pair.other_x) * value(pair.other_y);
  });
}

}  // namespace epsnet::certify
