#pragma once

#include <epsnet/certify/crossings.h>
#include <epsnet/certify/document.h>

#include <cstdint>
#include <span>
#include <vector>

namespace epsnet::certify {

/// What the labels are made of: the crossings of the sides and the frames of the charts.
struct LabelParts {
  Crossings crossings;
  std::vector<ExactIsometry> frames;  ///< By chart: from the chart to its tile.
};

/// A label or its inverse.
struct SignedLabel {
  std::uint32_t number;
  bool inverted;
};

/// Evaluates labels of one document.
class LabelEvaluator {
 public:
  /// Both must outlive the evaluator. O(letters of all words). Words are reduced freely: a side followed by its partner
  /// is no path, so the values stay the same.
  LabelEvaluator(const Document& document, const LabelParts& parts);

  /// L = F_to⁻¹ ∘ g ∘ F_from of the label numbers given (each ≥ 1, increasing), each with a relative error of about
  /// 2^−precision: long words are worked out with more bits, up to `cap` (or a little above `precision`, if that is
  /// more); beyond, the balls are wider, never wrong. Result number i belongs to numbers[i]. Uses `threads` threads.
  [[nodiscard]] std::vector<BallIsometry> evaluate(std::span<const std::uint32_t> numbers, slong precision, slong cap,
                                                   unsigned threads) const;

  /// The same exactly, for any label number, over the ring of the crossings, which are those of the document.
  template <class CrossingsOfAKind>
  [[nodiscard]] Isometry<typename CrossingsOfAKind::Number> evaluate_exactly(const CrossingsOfAKind& crossings,
                                                                             std::uint32_t number) const {
    if (number == 0) return crossings.embed(exact_identity());
    const Label& label = document_.labels[number - 1];
    auto result = compose(crossings.exact(words_[number - 1]), crossings.embed(parts_.frames[label.from]));
    result = compose(crossings.embed(inverse(parts_.frames[label.to])), result);
    reduce(result);
    return result;
  }

  /// About the number of bits of evaluate_exactly(number), without evaluating; 0 for the identity, number 0.
  [[nodiscard]] std::size_t exact_bits(std::uint32_t number) const { return number == 0 ? 0 : exact_bits_[number - 1]; }

  /// The word of a label number, freely reduced; empty for the identity, number 0.
  [[nodiscard]] std::span<const std::uint32_t> word(std::uint32_t number) const {
    return number == 0 ? std::span<const std::uint32_t>() : words_[number - 1];
  }

  /// The word of a product of labels, the last one applied first, freely reduced. The charts fit, so that all frames
  /// but the first and the last cancel.
  [[nodiscard]] std::vector<std::uint32_t> word(std::span<const SignedLabel> product) const;

  [[nodiscard]] const Crossings& crossings() const { return parts_.crossings; }

 private:
  /// Crosses one more side, and back again if it was the last one.
  void append(std::vector<std::uint32_t>& word, std::uint32_t side) const;

  const Document& document_;
  const LabelParts& parts_;
  std::vector<std::vector<std::uint32_t>> words_;  ///< By label number minus 1, freely reduced.
  std::vector<std::size_t> exact_bits_;
  std::vector<std::uint32_t> partner_;  ///< By side: the one it is glued to.
};

}  // namespace epsnet::certify
