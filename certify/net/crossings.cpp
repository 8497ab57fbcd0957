#include "certify/net/crossings.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace epsnet::certify {
namespace {

using Powers = std::vector<PowerOfZeta>;

Powers operator*(const Powers& x, const Powers& y) {
  Powers result;
  for (const PowerOfZeta& f : x) {
    for (const PowerOfZeta& g : y) result.push_back({f.coefficient * g.coefficient, f.power + g.power});
  }
  return result;
}

/// 4 sin²(π/q), for the power ξ = e^{iπ/q}.
Powers square_of_twice_sine(std::int64_t xi) { return {{2, 0}, {-1, 2 * xi}, {-1, -2 * xi}}; }

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

RegularCrossings::RegularCrossings(RegularTile tile, std::vector<std::uint32_t> partner, const Budget& budget)
    : tile_(tile), partner_(std::move(partner)) {
  const std::int64_t p = tile.p;
  const std::int64_t q = tile.q;
  const std::int64_t order = std::lcm(std::lcm(2 * p, 2 * q), std::int64_t{4});
  at_p_ = order / (2 * p);
  at_q_ = order / (2 * q);
  // If all crossings, and with them their products, have even powers only, these are enough.
  bool even = order % 8 == 0 && (at_p_ + at_q_) % 2 == 0;
  for (std::uint32_t s = 0; even && s < partner_.size(); ++s) {
    even = at_p_ % 2 == 0 || (s % tile.p + partner_[s] % tile.p) % 2 == 0;
  }
  step_ = even ? 2 : 1;
  // s = 2 sin(π/q)·2 sin(π/p) sinh ρ, and (2 sin(π/p) sinh ρ)² = 2 cos(2π/p) + 2 cos(2π/q).
  Powers square =
      square_of_twice_sine(at_q_) * Powers{{1, 2 * at_p_}, {1, -2 * at_p_}, {1, 2 * at_q_}, {1, -2 * at_q_}};
  for (PowerOfZeta& term : square) term.power /= step_;
  ring_ = std::make_unique<RegularRing>(static_cast<std::uint32_t>(order / step_), square, budget);
}

RegularCrossings::CornerTurn RegularCrossings::crossing_of(std::uint32_t side) const {
  CornerTurn result{Turn::clockwise, 0, side % tile_.p, 0};
  result.last = result.first - 1;
  go_on(result, side);
  return result;
}

std::uint32_t RegularCrossings::following(std::uint32_t side, Turn turn) const {
  const std::uint32_t p = tile_.p;
  const std::uint32_t other = partner_[side];
  return other - other % p + (other % p + (turn == Turn::clockwise ? 1 : p - 1)) % p;
}

void RegularCrossings::go_on(CornerTurn& turn, std::uint32_t side) const {
  const std::uint32_t p = tile_.p;
  turn.last += turn.turn == Turn::clockwise ? 1 : -1;
  turn.last += (partner_[side] % p + p - side % p) % p;
  ++turn.count;
}

std::vector<RegularCrossings::CornerTurn> RegularCrossings::turns_of(std::span<const std::uint32_t> word) const {
  std::vector<CornerTurn> turns;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const auto goes_on = [&](Turn turn) {
      if (i == 0 || following(word[i - 1], turn) != word[i]) return false;
      return turns.back().count == 1 || turns.back().turn == turn;
    };
    const bool clockwise = goes_on(Turn::clockwise);
    if (!clockwise && !goes_on(Turn::counterclockwise)) {
      turns.push_back(crossing_of(word[i]));
      continue;
    }
    turns.back().turn = clockwise ? Turn::clockwise : Turn::counterclockwise;
    go_on(turns.back(), word[i]);
  }
  return turns;
}

Isometry<RegularNumber> RegularCrossings::exact(std::span<const std::uint32_t> word) const {
  if (word.empty()) return embed(exact_identity());
  const std::vector<CornerTurn> turns = turns_of(word);
  return compose_range(0, turns.size(), [&](std::size_t i) { return product(turns[i]); });
}

Isometry<RegularNumber> RegularCrossings::turn(std::uint32_t side, std::uint32_t count, Turn turn) const {
  CornerTurn result = crossing_of(side);
  result.turn = turn;
  while (result.count < count) {
    side = following(side, turn);
    go_on(result, side);
  }
  return product(result);
}

Isometry<RegularNumber> RegularCrossings::product(const CornerTurn& turn) const {
  const bool clockwise = turn.turn == Turn::clockwise;
  const std::int64_t j = turn.count;
  const std::int64_t xi = clockwise ? at_q_ : -at_q_;
  const std::int64_t eta = clockwise ? at_p_ : -at_p_;
  const std::int64_t sign = clockwise && j % 2 != 0 ? -1 : 1;
  const Powers to_a{{sign, at_p_ * (turn.last - turn.first)}};
  const Powers to_b{{sign, at_p_ * (turn.last + turn.first)}};
  Powers a = to_a * square_of_twice_sine(at_q_) *
             Powers{{1, (j + 1) * xi}, {-1, -(j + 1) * xi}, {1, 2 * eta + (j - 1) * xi}, {-1, 2 * eta - (j - 1) * xi}};
  // i = e^{iπ/2}; clockwise −2 sin(π/q)·(e^{iπj/q} − e^{−iπj/q}), otherwise the conjugate.
  const std::int64_t quarter = at_p_ * tile_.p / 2;
  Powers b =
      to_b * Powers{{clockwise ? 1 : -1, quarter}} * Powers{{1, xi}, {-1, -xi}} * Powers{{1, j * xi}, {-1, -j * xi}};
  for (Powers* powers : {&a, &b}) {
    for (PowerOfZeta& term : *powers) term.power /= step_;
  }
  return {regular_number(*ring_, a, {}), regular_number(*ring_, {}, b)};
}

Isometry<RegularNumber> RegularCrossings::embed(const ExactIsometry& f) const {
  return {regular_number(*ring_, f.a), regular_number(*ring_, f.b)};
}

std::size_t RegularCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  // A turn adds some four bits to each coefficient. Many turns of few bits take as long as few of many.
  const std::size_t order = ring_->order();
  const std::size_t turn_bits = std::max<std::size_t>(2048, 4 * order);
  return 2 * order * frame_bits + turn_bits * turns_of(word).size();
}

}  // namespace epsnet::certify
