#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "certify/net/label_evaluator.h"

namespace epsnet::certify {

/// Compares translation lengths without rounding: 4 cosh²(l/2) = tr²/det, and traces and determinants are numbers of
/// the ring of the surface's crossings.
///
/// A word here leads from a tile to itself, is freely reduced, and does not evaluate to the identity: an element of the
/// group that is hyperbolic. An element and its conjugates have one length, so frames of charts do not matter. Nothing
/// is returned where a word is too long to be evaluated exactly; BudgetSpent, if that is too much work.
class ExactTraces {
 public:
  /// The evaluator must outlive the traces.
  explicit ExactTraces(const LabelEvaluator& evaluator)
      : crossings_(evaluator.crossings()), budget_(evaluator.budget()) {}
  explicit ExactTraces(const LabelEvaluator&& evaluator) = delete;

  /// The sign of l(word) − l(other).
  [[nodiscard]] std::optional<int> compare(std::span<const std::uint32_t> word,
                                           std::span<const std::uint32_t> other) const;

  /// The sign of l(word) − 2 arsinh 1.
  [[nodiscard]] std::optional<int> compare_with_short(std::span<const std::uint32_t> word) const;

 private:
  const Crossings& crossings_;
  const Budget& budget_;
};

}  // namespace epsnet::certify
