#pragma once

#include <epsnet/certify/ball.h>
#include <epsnet/certify/document.h>
#include <epsnet/certify/exact.h>

#include <cstdint>
#include <span>
#include <vector>

/// Isometries of the Poincaré disk in ball arithmetic.
namespace epsnet::certify {

/// z ↦ (a z + b)/(b̄ z + ā), |a|² − |b|² = 1.
struct BallIsometry {
  ComplexBall a;
  ComplexBall b;
};

[[nodiscard]] BallIsometry identity_isometry();
/// f ∘ g; the products are rounded to `precision` bits.
[[nodiscard]] BallIsometry compose(const BallIsometry& f, const BallIsometry& g, slong precision);
[[nodiscard]] BallIsometry inverse(const BallIsometry& f);
/// The exact isometry, scaled to determinant 1, to about `precision` bits.
[[nodiscard]] BallIsometry to_balls(const ExactIsometry& f, slong precision);
/// |f(0)|²/(1 − |f(0)|²) = |b|² = sinh²(d/2), d the distance of 0 and f(0).
void half_displacement_squared(arb_ptr result, const BallIsometry& f, slong precision);

/// What the labels are made of: the crossings of the sides and the frames of the charts, exactly.
struct ExactParts {
  std::vector<ExactIsometry> crossings;  ///< By side number.
  std::vector<ExactIsometry> frames;     ///< By chart: from the chart to its tile.
};

/// Evaluates labels of one document.
class LabelEvaluator {
 public:
  /// Both must outlive the evaluator. O(letters of all words). Words are reduced freely: a side followed by its partner
  /// is no path, so the values stay the same.
  LabelEvaluator(const Document& document, const ExactParts& parts);

  /// L = F_to⁻¹ ∘ g ∘ F_from of the label numbers given (each ≥ 1, increasing), each with a relative error of about
  /// 2^−precision: long words are worked out with more bits, up to `cap` (or a little above `precision`, if that is
  /// more); beyond, the balls are wider, never wrong. Result number i belongs to numbers[i]. Uses `threads` threads.
  [[nodiscard]] std::vector<BallIsometry> evaluate(std::span<const std::uint32_t> numbers, slong precision, slong cap,
                                                   unsigned threads) const;

  /// The same exactly, for label number k ≥ 1.
  [[nodiscard]] ExactIsometry evaluate_exactly(std::uint32_t number) const;

  /// About the number of bits of evaluate_exactly(number), without evaluating; 0 for the identity, number 0.
  [[nodiscard]] std::size_t exact_bits(std::uint32_t number) const { return number == 0 ? 0 : exact_bits_[number - 1]; }

 private:
  const Document& document_;
  const ExactParts& parts_;
  std::vector<std::vector<std::uint32_t>> words_;  ///< By label number minus 1, freely reduced.
  std::vector<std::size_t> exact_bits_;
};

}  // namespace epsnet::certify
