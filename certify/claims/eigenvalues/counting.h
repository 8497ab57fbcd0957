#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/document.h"

namespace epsnet::certify {

/// Of these intervals, in the order of their ends, upper ends first, each one that has no point in common with those
/// taken before: as many disjoint ones as there are. O(n log n).
[[nodiscard]] std::vector<Interval> disjoint(std::vector<Interval> intervals);

/// What follows for the windows of a file once all its statements of both kinds are proved (docs/proof.md, Lemma 37).
/// Comparisons of binary64 and sums of integers alone: exact. About (number of statements)² for each question.
class Counting {
 public:
  explicit Counting(const EigenvaluesDocument& document);

  /// The first claim of the windows that does not follow; nullopt if all do.
  [[nodiscard]] Problem problem() const;

 private:
  /// The least number of eigenvalues in the closed interval that the statements allow at most; nothing if they do not
  /// cover it.
  [[nodiscard]] std::optional<std::uint64_t> most(Interval closed) const;
  /// Whether there is none strictly between the two ends.
  [[nodiscard]] bool none_between(double lower, double upper) const {
    return lower >= upper || most({lower, upper}) == 0U;
  }
  /// Whether there are at least so many in the window.
  [[nodiscard]] bool at_least(std::uint32_t count, Interval window) const;
  /// Whether not all of the `count` eigenvalues in the window lie in this part of it.
  [[nodiscard]] bool not_all_in(Interval part, Interval window, std::uint32_t count) const;
  [[nodiscard]] Problem window_problem(const EigenvaluesDocument::Window& window) const;

  const EigenvaluesDocument& document_;
  std::vector<EigenvaluesDocument::AtMost> by_upper_;  ///< Without coefficients, by the upper ends.
};

}  // namespace epsnet::certify
