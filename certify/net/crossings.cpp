#include "certify/net/crossings.h"

#include <algorithm>
#include <array>

namespace epsnet::certify {
namespace {

/// c = 2 − ζ − ζ⁻¹ > 0, and s² = (c sinh ρ)² = 2c(ζ + ζ⁻¹). Times c², what turns are made of has few powers of ζ.
constexpr std::array<PowerOfZeta, 3> kScale{{{2, 0}, {-1, 1}, {-1, -1}}};
constexpr std::array<PowerOfZeta, 5> kSquareOfS{{{-4, 0}, {4, 1}, {4, -1}, {-2, 2}, {-2, -2}}};

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

RegularCrossings::RegularCrossings(std::uint32_t genus, const Budget& budget)
    : ring_(std::make_unique<RegularRing>(4 * genus, kSquareOfS, budget)) {}

Isometry<RegularNumber> RegularCrossings::exact(std::span<const std::uint32_t> word) const {
  if (word.empty()) return embed(exact_identity());
  const std::vector<CornerTurn> turns = turns_of(genus(), word);
  return compose_range(0, turns.size(),
                       [&](std::size_t i) { return turn(turns[i].side, turns[i].count, turns[i].turn); });
}

Isometry<RegularNumber> RegularCrossings::turn(std::uint32_t side, std::uint32_t count, Turn turn) const {
  const std::int64_t g = genus();
  const std::int64_t j = count;
  const std::int64_t up = turn == Turn::counterclockwise ? 1 : -1;
  const std::int64_t all = up * (j - 1) * (2 * g + 1);
  const std::int64_t a = all + up * g * j;
  const std::int64_t b = all + side + up * g * (j - 1);
  std::vector<PowerOfZeta> scaled_a;
  for (const PowerOfZeta& x : {PowerOfZeta{1, a - up * j}, PowerOfZeta{1, a + up * (2 - j)}, PowerOfZeta{-2, a + up}}) {
    for (const PowerOfZeta& y : kScale) scaled_a.push_back({x.coefficient * y.coefficient, x.power + y.power});
  }
  const std::array<PowerOfZeta, 4> scaled_b{{{-1, b}, {1, b + up}, {1, b - up * j}, {-1, b + up * (1 - j)}}};
  return {regular_number(*ring_, scaled_a, {}), regular_number(*ring_, {}, scaled_b)};
}

Isometry<RegularNumber> RegularCrossings::embed(const ExactIsometry& f) const {
  return {regular_number(*ring_, f.a), regular_number(*ring_, f.b)};
}

std::size_t RegularCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  // A turn adds some four bits to each coefficient. Many turns of few bits take as long as few of many.
  const std::size_t turn_bits = std::max<std::size_t>(2048, 4 * size());
  return 2 * size() * frame_bits + turn_bits * turns_of(genus(), word).size();
}

}  // namespace epsnet::certify
