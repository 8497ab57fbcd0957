#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Closed ways across edges, given by the codes of the darts crossed (DartOrder). That which crosses the opposite darts
/// in the opposite order is the way back; the code of the opposite dart of code c is c ^ 1.
namespace epsnet::certify {

/// A cyclic sequence, up to rotation and to the way back.
struct LeastSequence {
  std::vector<std::uint32_t> root;  ///< The least of all rotations of the way and of the way back, without repetitions.
  std::uint32_t exponent = 1;       ///< How many times the root is run through.
};

/// The least period of a cyclic sequence that is not empty: a divisor of its length.
[[nodiscard]] std::size_t period_of(std::span<const std::uint32_t> codes);

/// O(n) but for the divisors of n.
[[nodiscard]] LeastSequence least_sequence(std::span<const std::uint32_t> codes);

/// The least sequences of a list of geodesics.
class SequenceTable {
 public:
  explicit SequenceTable(std::vector<LeastSequence> sequences);

  [[nodiscard]] std::size_t size() const { return sequences_.size(); }

  /// Whether a geodesic has this root, which it runs through once.
  [[nodiscard]] bool contains(const std::vector<std::uint32_t>& root) const;

  struct Match {
    std::uint32_t geodesic = 0;
    std::uint32_t power = 0;
  };
  /// Another geodesic, of which this one is a power.
  [[nodiscard]] std::optional<Match> find_other(std::uint32_t geodesic) const;

 private:
  [[nodiscard]] std::span<const std::uint32_t> with_root(const std::vector<std::uint32_t>& root) const;

  std::vector<LeastSequence> sequences_;
  std::vector<std::uint32_t> order_;  ///< Geodesics by their roots.
};

}  // namespace epsnet::certify
