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

/// Which way a path turns around a corner of a regular tile: side k is followed by side k + 2g + 1 or k + 2g − 1.
enum class Turn { counterclockwise, clockwise };

/// Of the regular 4g-gon, the tile with opposite sides glued; everything exact is over its ring.
///
/// Words turn around corners, and a turn has a closed form: what is exact takes time by turns, not by letters.
class RegularCrossings {
 public:
  using Number = RegularNumber;
  static constexpr std::size_t kMaxExactBits = RationalCrossings::kMaxExactBits;

  explicit RegularCrossings(std::uint32_t genus, const Budget& budget = {});

  [[nodiscard]] std::size_t size() const { return ring_->order(); }
  [[nodiscard]] const RegularRing& ring() const { return *ring_; }
  [[nodiscard]] BallIsometry balls(std::uint32_t side, slong precision) const {
    return regular_crossing(genus(), side, precision);
  }
  [[nodiscard]] static std::uint64_t ball_work(std::uint32_t /*side*/, std::uint64_t precision) {
    return 4 * function_work(precision);
  }
  [[nodiscard]] static std::uint64_t letter_work() { return 20; }
  /// Numbers take their own work off the budget.
  [[nodiscard]] static std::uint64_t exact_work(std::size_t /*value_bits*/) { return 4000; }
  [[nodiscard]] Isometry<RegularNumber> exact(std::span<const std::uint32_t> word) const;
  /// The product of `count` ≥ 1 crossings that turn around one corner, the first one that of `side`, times a positive
  /// number of the ring, the same for all turns (docs/proof.md, Lemma 9.1).
  [[nodiscard]] Isometry<RegularNumber> turn(std::uint32_t side, std::uint32_t count, Turn turn) const;
  [[nodiscard]] Isometry<RegularNumber> embed(const ExactIsometry& f) const;
  [[nodiscard]] std::size_t product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const;

 private:
  [[nodiscard]] std::uint32_t genus() const { return ring_->order() / 4; }

  std::unique_ptr<const RegularRing> ring_;  ///< Numbers point to it, also after a move.
};

using Crossings = std::variant<RationalCrossings, RegularCrossings>;

[[nodiscard]] inline BallIsometry ball_crossing(const Crossings& crossings, std::uint32_t side, slong precision) {
  return std::visit([&](const auto& kind) { return kind.balls(side, precision); }, crossings);
}

}  // namespace epsnet::certify
