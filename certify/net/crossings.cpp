#include "certify/net/crossings.h"

#include <algorithm>

namespace epsnet::certify {
namespace {

struct CornerTurn {
  std::uint32_t side;  ///< The first one crossed.
  std::uint32_t count;
  Turn turn;
};

/// The turns that a word is made of, each as long as it can be; shorter ones would have the same product.
std::vector<CornerTurn> turns_of(std::uint32_t genus, std::span<const std::uint32_t> word) {
  std::vector<CornerTurn> turns;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (i > 0) {
      CornerTurn& last = turns.back();
      const std::uint32_t step = (word[i] + 4 * genus - word[i - 1]) % (4 * genus);
      const bool counterclockwise = step == 2 * genus + 1;
      const Turn turn = counterclockwise ? Turn::counterclockwise : Turn::clockwise;
      if ((counterclockwise || step == 2 * genus - 1) && (last.count == 1 || last.turn == turn)) {
        ++last.count;
        last.turn = turn;
        continue;
      }
    }
    turns.push_back({word[i], 1, Turn::counterclockwise});
  }
  return turns;
}

}  // namespace

ExactIsometry RationalCrossings::exact(std::span<const std::uint32_t> word) const {
  if (word.empty()) return exact_identity();
  return compose_range(0, word.size(), [&](std::size_t i) { return crossings_[word[i]]; });
}

std::size_t RationalCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  std::size_t sum = frame_bits;
  for (const std::uint32_t side : word) sum += bits(crossings_[side]);
  return sum;
}

BallIsometry RegularCrossings::balls(std::uint32_t side, slong precision) const {
  const std::uint32_t genus = ring_->genus();
  BallIsometry result;
  Ball sinh;
  set_regular_apothem(result.a.re(), sinh.get(), genus, precision);
  set_regular_direction(result.b.get(), genus, side, precision);
  acb_mul_arb(result.b.get(), result.b.get(), sinh.get(), precision);
  acb_neg(result.b.get(), result.b.get());
  return result;
}

Isometry<RegularNumber> RegularCrossings::exact(std::span<const std::uint32_t> word) const {
  if (word.empty()) return embed(exact_identity());
  const std::vector<CornerTurn> turns = turns_of(ring_->genus(), word);
  return compose_range(0, turns.size(), [&](std::size_t i) {
    return regular_turn(*ring_, turns[i].side, turns[i].count, turns[i].turn);
  });
}

Isometry<RegularNumber> RegularCrossings::embed(const ExactIsometry& f) const {
  return {regular_number(*ring_, f.a), regular_number(*ring_, f.b)};
}

std::size_t RegularCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  // Frames count in every embedding. Many turns of few bits take as long as few of many.
  constexpr std::size_t kLeastBits = 512;
  std::size_t sum = 2 * ring_->embeddings().size() * frame_bits;
  for (const CornerTurn& turn : turns_of(ring_->genus(), word)) {
    sum += std::max(kLeastBits, regular_turn_bits(*ring_, turn.count));
  }
  return sum;
}

}  // namespace epsnet::certify
