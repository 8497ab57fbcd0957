#pragma once

#include <cstdint>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/document.h"

namespace epsnet::certify {

/// What the counts and functions of a document say of the numbers of eigenvalues, if they are true (docs/proof.md,
/// section 17.1). Comparisons of binary64 and sums of integers alone, but for distances other than 0: exact.
class CountedEigenvalues {
 public:
  /// Roots of eigenvalues are at most `distance` from those that are counted. O(n log n) for n rows. The document must
  /// outlive it. Requires: the distance is 0 if there are eigenfunctions.
  explicit CountedEigenvalues(const EigenvaluesDocument& document, double distance = 0);

  /// At least so many eigenvalues are ≤ x. O(log n).
  [[nodiscard]] std::int64_t least_up_to(double x) const;
  /// At most so many are < x; the greatest number if nothing is said. O(log n).
  [[nodiscard]] std::int64_t most_below(double x) const;

  /// The first claim of the document that does not follow; nullopt if all do.
  [[nodiscard]] Problem problem() const;

 private:
  /// Of the rows of `at_least` up to one of them, or of those of `at_most` from one of them on.
  struct Extremes {
    double below;
    std::int64_t count;    ///< The greatest (least) count,
    std::int64_t without;  ///< and that of a count less the functions before `below`.
  };

  /// How many functions have intervals that begin before x; that end at x or before; that end before x.
  [[nodiscard]] std::int64_t beginning_before(double x) const;
  [[nodiscard]] std::int64_t ending_up_to(double x) const;
  [[nodiscard]] std::int64_t ending_before(double x) const;

  const EigenvaluesDocument& document_;
  std::vector<std::int64_t> functions_;  ///< By number of rows: the functions of the first so many.
  std::vector<Extremes> at_least_;       ///< By `below`, ascending.
  std::vector<Extremes> at_most_;
};

}  // namespace epsnet::certify
