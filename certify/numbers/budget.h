#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>

/// The work, in time and memory, that checking one file may take.
///
/// What is counted are estimates made from sizes alone (bits, letters, visits), never seconds, so that a verdict is the
/// same on every machine and for any number of threads. A unit is about what a processor core does in a nanosecond.
namespace epsnet::certify {

/// Thrown when more work is needed than is left. Handlers must discard all results since the last schedule-independent
/// point, and answer UNDECIDED.
class BudgetSpent : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override {
    return "needs more work than a file of this size may take";
  }
};

/// An account of work that its copies share.
///
/// Whether work done in parallel stays within the budget depends on the sum alone: then no `spend` throws, and
/// otherwise at least one does.
class Budget {
 public:
  /// Without limit.
  Budget() = default;
  explicit Budget(std::uint64_t work) : left_(std::make_shared<std::atomic<std::uint64_t>>(work)) {}

  /// Takes `times` times `work` off the account before it is done; BudgetSpent, and nothing is left, if that is more
  /// than is left. For any number of threads.
  void spend(std::uint64_t work, std::uint64_t times = 1) const {
    if (!left_ || work == 0) return;
    std::uint64_t left = left_->load(std::memory_order_relaxed);
    do {
      if (times > left / work) {
        left_->store(0, std::memory_order_relaxed);
        throw BudgetSpent();
      }
    } while (!left_->compare_exchange_weak(left, left - work * times, std::memory_order_relaxed));
  }

  /// BudgetSpent, and nothing is left, if `times` times `work` is more than is left; else takes nothing: for memory
  /// that is given back before the next step. Not while others spend.
  void require(std::uint64_t work, std::uint64_t times) const {
    if (left_ && work > 0 && times > left() / work) {
      left_->store(0, std::memory_order_relaxed);
      throw BudgetSpent();
    }
  }

  /// What is left.
  [[nodiscard]] std::uint64_t left() const {
    return left_ ? left_->load(std::memory_order_relaxed) : std::numeric_limits<std::uint64_t>::max();
  }

 private:
  std::shared_ptr<std::atomic<std::uint64_t>> left_;
};

/// A product of two integers of so many bits. Fits what GMP takes, from 64 to 2²⁴ bits, within a factor of two.
[[nodiscard]] constexpr std::uint64_t product_work(std::uint64_t bits) {
  const std::uint64_t limbs = bits / 64 + 1;
  const auto log = static_cast<std::uint64_t>(std::bit_width(limbs));
  return limbs * std::min(limbs, 1 + log * log * log / 16);
}

/// An operation of balls of so many bits.
[[nodiscard]] constexpr std::uint64_t ball_work(std::uint64_t precision) { return 20 + product_work(precision); }

/// An elementary function of a ball, or a constant such as π.
[[nodiscard]] constexpr std::uint64_t function_work(std::uint64_t precision) {
  return 500 + 8 * (1 + precision / 65'536) * product_work(precision);
}

/// So many bytes kept: a budget of 2·10¹⁰ units is a gigabyte.
[[nodiscard]] constexpr std::uint64_t memory_work(std::uint64_t bytes) { return 20 * bytes; }

/// The work that a file may take, by its least number of bytes.
[[nodiscard]] constexpr std::uint64_t work_allowed(std::uint64_t bytes) { return 15'000'000'000 + 8'000 * bytes; }

}  // namespace epsnet::certify
