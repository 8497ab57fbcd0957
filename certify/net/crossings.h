#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "certify/numbers/budget.h"
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

using Crossings = std::variant<RationalCrossings, RegularCrossings>;

[[nodiscard]] inline BallIsometry ball_crossing(const Crossings& crossings, std::uint32_t side, slong precision) {
  return std::visit([&](const auto& kind) { return kind.balls(side, precision); }, crossings);
}

}  // namespace epsnet::certify
