#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "certify/base/error.h"
#include "certify/net/document.h"
#include "certify/net/numbering.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/field_number.h"
#include "certify/numbers/isometry.h"
#include "certify/numbers/regular_number.h"

/// The crossings of a surface's sides, in balls of any precision and exactly. Each kind of surface has a ring of its
/// own, `Number`, over which everything about it is exact; the geometry (exact.h) is the same.
namespace epsnet::certify {

/// Of tiles with rational vertices.
class RationalCrossings {
 public:
  using Number = Gaussian;
  /// Exact arithmetic is not tried on numbers of more bits in all. Words of thousands of letters may exceed it.
  static constexpr std::size_t kMaxExactBits = std::size_t{1} << 23;

  RationalCrossings() = default;
  /// By side number.
  explicit RationalCrossings(std::vector<ExactIsometry> crossings) : crossings_(std::move(crossings)) {}

  [[nodiscard]] std::size_t size() const { return crossings_.size(); }
  [[nodiscard]] BallIsometry balls(std::uint32_t side, slong precision) const {
    return to_balls(crossings_[side], precision);
  }
  /// Estimated work of `balls`.
  [[nodiscard]] std::uint64_t ball_work(std::uint32_t side, std::uint64_t precision) const {
    return to_balls_work(bits(crossings_[side]), precision);
  }
  /// Estimated work of `product_bits` per letter of the word.
  [[nodiscard]] static std::uint64_t letter_work() { return 20; }
  /// Estimated work of `exact` and of calculations with its value, which has `value_bits` bits.
  [[nodiscard]] static std::uint64_t exact_work(std::size_t value_bits) {
    return 4000 + 100 * certify::product_work(value_bits);
  }
  /// The value of a word.
  [[nodiscard]] ExactIsometry exact(std::span<const std::uint32_t> word) const;
  [[nodiscard]] static ExactIsometry embed(const ExactIsometry& f) { return f; }
  /// About the bits of the value of a word between two frames that have `frame_bits` together.
  [[nodiscard]] std::size_t product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const;

 private:
  std::vector<ExactIsometry> crossings_;
};

/// Which way a path turns around a vertex of regular tiles: a side is followed by the one after its partner
/// (clockwise), or by the one before it.
enum class Turn { clockwise, counterclockwise };

/// Of regular tiles that are all the same; everything exact is over the ring of the tile.
///
/// Words turn around vertices, and a turn has a closed form: what is exact takes time by turns, not by letters.
class RegularCrossings {
 public:
  using Number = RegularNumber;
  static constexpr std::size_t kMaxExactBits = RationalCrossings::kMaxExactBits;

  /// Requires: a hyperbolic tile; partners of sides, which are numbered through all tiles.
  RegularCrossings(RegularTile tile, std::vector<std::uint32_t> partner, const Budget& budget = {});

  [[nodiscard]] std::size_t size() const { return partner_.size(); }
  [[nodiscard]] const RegularRing& ring() const { return *ring_; }
  [[nodiscard]] BallIsometry balls(std::uint32_t side, slong precision) const {
    return regular_crossing(tile_, side % tile_.p, partner_[side] % tile_.p, precision);
  }
  [[nodiscard]] static std::uint64_t ball_work(std::uint32_t /*side*/, std::uint64_t precision) {
    return 4 * function_work(precision);
  }
  [[nodiscard]] static std::uint64_t letter_work() { return 20; }
  /// Numbers take their own work off the budget.
  [[nodiscard]] static std::uint64_t exact_work(std::size_t /*value_bits*/) { return 4000; }
  [[nodiscard]] Isometry<RegularNumber> exact(std::span<const std::uint32_t> word) const;
  /// The product of `count` ≥ 1 crossings that turn around one vertex, the first one that of `side`, times a positive
  /// number, the same for all turns (docs/proof.md, Lemma 9.1).
  [[nodiscard]] Isometry<RegularNumber> turn(std::uint32_t side, std::uint32_t count, Turn turn) const;
  [[nodiscard]] Isometry<RegularNumber> embed(const ExactIsometry& f) const;
  [[nodiscard]] std::size_t product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const;

 private:
  /// Some crossings that turn around one vertex.
  struct CornerTurn {
    Turn turn;
    std::uint32_t count;
    std::int64_t first;  ///< The corner at which the first side starts.
    std::int64_t last;   ///< That of the partner of the last, with p added for each time around a tile.
  };
  /// The turn of one crossing.
  [[nodiscard]] CornerTurn crossing_of(std::uint32_t side) const;
  [[nodiscard]] std::uint32_t following(std::uint32_t side, Turn turn) const;
  /// The turn goes on across `side`.
  void go_on(CornerTurn& turn, std::uint32_t side) const;
  /// The turns that a word is made of, each as long as it can be; shorter ones would have the same product.
  [[nodiscard]] std::vector<CornerTurn> turns_of(std::span<const std::uint32_t> word) const;
  [[nodiscard]] Isometry<RegularNumber> product(const CornerTurn& turn) const;

  RegularTile tile_;
  std::vector<std::uint32_t> partner_;
  std::int64_t at_p_;                        ///< e^{iπ/p} and e^{iπ/q} are these powers of a root of unity,
  std::int64_t at_q_;                        ///< of which ζ is the power number
  std::int64_t step_;                        ///< 1 or 2: odd powers are not always needed.
  std::unique_ptr<const RegularRing> ring_;  ///< Numbers point to it, also after a move.
};

/// Of tiles over a number field.
class FieldCrossings {
 public:
  using Number = FieldNumber;
  static constexpr std::size_t kMaxExactBits = RationalCrossings::kMaxExactBits;

  /// By side number. Determinants |a|² − |b|² are positive, and numbers those of the field.
  FieldCrossings(std::unique_ptr<const NumberField> field, std::vector<Isometry<FieldNumber>> crossings);

  [[nodiscard]] std::size_t size() const { return crossings_.size(); }
  [[nodiscard]] BallIsometry balls(std::uint32_t side, slong precision) const {
    return to_balls(crossings_[side], determinants_[side], precision);
  }
  /// Numbers take their own work off the budget.
  [[nodiscard]] static std::uint64_t ball_work(std::uint32_t /*side*/, std::uint64_t precision) {
    return 32 * certify::ball_work(precision);
  }
  [[nodiscard]] static std::uint64_t letter_work() { return 20; }
  [[nodiscard]] static std::uint64_t exact_work(std::size_t /*value_bits*/) { return 4000; }
  [[nodiscard]] Isometry<FieldNumber> exact(std::span<const std::uint32_t> word) const;
  [[nodiscard]] Isometry<FieldNumber> embed(const ExactIsometry& f) const;
  [[nodiscard]] std::size_t product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const;

 private:
  std::unique_ptr<const NumberField> field_;  ///< Numbers point to it, also after a move.
  std::vector<Isometry<FieldNumber>> crossings_;
  std::vector<FieldNumber> determinants_;
};

using Crossings = std::variant<RationalCrossings, RegularCrossings, FieldCrossings>;

[[nodiscard]] inline BallIsometry ball_crossing(const Crossings& crossings, std::uint32_t side, slong precision) {
  return std::visit([&](const auto& kind) { return kind.balls(side, precision); }, crossings);
}

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
