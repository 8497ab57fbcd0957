#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "certify/base/lookup.h"
#include "certify/net/crossings.h"
#include "certify/net/document.h"
#include "certify/net/surface_sides.h"
#include "certify/numbers/budget.h"

namespace epsnet::certify {

/// What the labels are made of: the crossings of the sides and the frames of the charts; and the account of work.
struct LabelParts {
  Crossings crossings;
  std::vector<ExactIsometry> frames;  ///< By chart: from the chart to its tile.
  Budget budget = {};
};

/// The frames of charts. BudgetSpent, if that is too much work.
[[nodiscard]] std::vector<ExactIsometry> chart_frames(const std::vector<NetDocument::Chart>& charts,
                                                      const Budget& budget);

/// The parts of the labels of a document with these charts. BudgetSpent, if that is too much work.
[[nodiscard]] LabelParts label_parts(Crossings crossings, const std::vector<NetDocument::Chart>& charts,
                                     const Budget& budget);

/// A label or its inverse.
struct SignedLabel {
  std::uint32_t number;
  bool inverted;
};

/// Evaluates labels of one document, and the cores of its collars: words from the tile of the first vertex's chart to
/// itself, which are labels from that chart to itself, with the numbers after those of the file.
///
/// All that it does is taken off the budget first; BudgetSpent, if that is too much. Fault, if a number is that of no
/// label and of no core.
class LabelEvaluator {
 public:
  /// The parts, those of the document, must outlive the evaluator. Fault, if they are of another one. O(letters of all
  /// words). Words are reduced freely: a side followed by its partner is no path, so the values stay the same.
  LabelEvaluator(const NetDocument& document, const LabelParts& parts);
  LabelEvaluator(const NetDocument& document, const LabelParts&& parts) = delete;

  /// L = F_to⁻¹ ∘ g ∘ F_from of the label numbers given, none of them 0, each with a relative error of about
  /// 2^−precision: long words are worked out with more bits, up to `cap` (or a little above `precision`, if that is
  /// more); beyond, the balls are wider, never wrong. Result number i belongs to numbers[i]. Uses `threads` threads.
  [[nodiscard]] std::vector<BallIsometry> evaluate(std::span<const std::uint32_t> numbers, slong precision, slong cap,
                                                   unsigned threads) const;

  /// The same exactly, for any label number, over the ring of the crossings, which are those of the document.
  template <class CrossingsOfAKind>
  [[nodiscard]] Isometry<typename CrossingsOfAKind::Number> evaluate_exactly(const CrossingsOfAKind& crossings,
                                                                             std::uint32_t number) const {
    if (number == 0) return crossings.embed(exact_identity());
    parts_.budget.spend(CrossingsOfAKind::exact_work(exact_bits(number)));
    const NetDocument::Label& label = label_at(number);
    auto result = compose(crossings.exact(label.word), crossings.embed(parts_.frames[label.from]));
    result = compose(crossings.embed(inverse(parts_.frames[label.to])), result);
    reduce(result);
    return result;
  }

  /// About the number of bits of evaluate_exactly(number), without evaluating; 0 for the identity, number 0.
  [[nodiscard]] std::size_t exact_bits(std::uint32_t number) const {
    return number == 0 ? 0 : looked_up(exact_bits_, number - 1, kMissing);
  }

  /// The label number of the core of a collar.
  [[nodiscard]] std::uint32_t core_number(std::size_t collar) const {
    const std::size_t number = first_core_ + collar;
    if (number > labels_.size()) throw_fault("there is no collar", collar);
    return static_cast<std::uint32_t>(number);
  }

  /// The word of a label number, freely reduced; empty for the identity, number 0.
  [[nodiscard]] std::span<const std::uint32_t> word(std::uint32_t number) const {
    return number == 0 ? std::span<const std::uint32_t>() : label_at(number).word;
  }

  /// The word of a product of labels, the last one applied first, freely reduced. The charts fit, so that all frames
  /// but the first and the last cancel.
  [[nodiscard]] std::vector<std::uint32_t> word(std::span<const SignedLabel> product) const;

  [[nodiscard]] const Crossings& crossings() const { return parts_.crossings; }
  [[nodiscard]] const Budget& budget() const { return parts_.budget; }

 private:
  static constexpr const char* kMissing = "there is no label, place";

  [[nodiscard]] const NetDocument::Label& label_at(std::uint32_t number) const {
    return looked_up(labels_, std::size_t{number} - 1, kMissing);
  }
  /// The values of these labels, worked out with so many bits.
  [[nodiscard]] std::vector<BallIsometry> multiplied(std::span<const std::uint32_t> numbers, slong precision,
                                                     unsigned threads) const;
  /// Crosses one more side, and back again if it was the last one.
  void append(std::vector<std::uint32_t>& word, std::uint32_t side) const;
  void add(std::uint32_t from, std::uint32_t to, const std::vector<std::uint32_t>& word);

  const LabelParts& parts_;
  std::vector<NetDocument::Label> labels_;  ///< By label number minus 1, words freely reduced.
  std::vector<std::size_t> exact_bits_;
  std::size_t first_core_ = 0;
  std::vector<std::uint32_t> partner_;  ///< By side: the one it is glued to.
};

}  // namespace epsnet::certify
