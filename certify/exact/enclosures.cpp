#include "certify/exact/enclosures.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "certify/exact/net_structure.h"

namespace epsnet::exact {
namespace {

using Count = std::int64_t;

/// What the rows say of numbers of eigenvalues, each in logarithmic time.
class Counts {
 public:
  explicit Counts(const EigenvaluesDocument& document) : document_(document), functions_{0} {
    for (const auto& row : document.eigenfunctions)
      functions_.push_back(functions_.back() + static_cast<Count>(row.functions.size()));
    at_least_.push_back({0, 0, 0});
    for (const auto& row : document.at_least)
      at_least_.push_back({row.below, row.count, row.count - functions_from(row.below)});
    sort(at_least_);
    for (std::size_t i = 1; i < at_least_.size(); ++i) {
      at_least_[i].alone = std::max(at_least_[i].alone, at_least_[i - 1].alone);
      at_least_[i].beside = std::max(at_least_[i].beside, at_least_[i - 1].beside);
    }
    for (const auto& row : document.at_most)
      at_most_.push_back({row.below, row.count, row.count - functions_below(row.below)});
    sort(at_most_);
    for (std::size_t i = at_most_.size(); i-- > 1;) {
      at_most_[i - 1].alone = std::min(at_most_[i - 1].alone, at_most_[i].alone);
      at_most_[i - 1].beside = std::min(at_most_[i - 1].beside, at_most_[i].beside);
    }
  }

  /// A(x): of the greatest for y <= x, those with functions from y on to x and those without.
  [[nodiscard]] Count least_up_to(const mpq_class& x) const {
    const auto after =
        std::upper_bound(at_least_.begin(), at_least_.end(), x, [](const auto& z, const Bound& y) { return z < y.at; });
    const Bound& best = *(after - 1);
    return std::max(best.alone, best.beside + functions_up_to(x));
  }

  /// B(x): of the least for y >= x; and B(0) = 0.
  [[nodiscard]] Count most_below(const mpq_class& x) const {
    if (x <= 0) return 0;
    const auto best =
        std::lower_bound(at_most_.begin(), at_most_.end(), x, [](const Bound& y, const auto& z) { return y.at < z; });
    if (best == at_most_.end()) return std::numeric_limits<Count>::max();
    return std::min(best->alone, best->beside + functions_from(x));
  }

 private:
  /// For all numbers up to y, or from y on.
  struct Bound {
    mpq_class at;
    Count alone;
    Count beside;  ///< Less functions on one side.
  };
  static void sort(std::vector<Bound>& bounds) {
    std::sort(bounds.begin(), bounds.end(), [](const Bound& x, const Bound& y) { return x.at < y.at; });
  }

  /// Of the rows before the first one for which this does not hold.
  template <class Condition>
  [[nodiscard]] Count functions_while(const Condition& holds) const {
    const auto& rows = document_.eigenfunctions;
    const auto end = std::partition_point(rows.begin(), rows.end(), [&](const auto& row) { return holds(row.in); });
    return functions_[static_cast<std::size_t>(end - rows.begin())];
  }
  /// Of rows that are not x <= lo.
  [[nodiscard]] Count functions_from(const mpq_class& x) const {
    return functions_while([&](const Range& in) { return in[0] < x; });
  }
  [[nodiscard]] Count functions_up_to(const mpq_class& x) const {
    return functions_while([&](const Range& in) { return in[1] <= x; });
  }
  [[nodiscard]] Count functions_below(const mpq_class& x) const {
    return functions_while([&](const Range& in) { return in[1] < x; });
  }

  const EigenvaluesDocument& document_;
  std::vector<Count> functions_;  ///< In the rows before.
  std::vector<Bound> at_least_;
  std::vector<Bound> at_most_;
};

}  // namespace

void check_enclosures(const EigenvaluesDocument& document) {
  const Counts counts(document);
  Count before = 0;
  for (std::size_t i = 0; i < document.eigenvalues.size(); ++i) {
    const auto& [in, count] = document.eigenvalues[i];
    const std::string name = "row " + number(i) + " of eigenvalues";
    if (counts.most_below(in[0]) > before) throw Refutation{name + " may be less than its interval"};
    before += count;
    if (counts.least_up_to(in[1]) < before) throw Refutation{name + " may be more than its interval"};
  }
  if (counts.most_below(document.next) > before) throw Refutation{"there may be another eigenvalue less than next"};
}

}  // namespace epsnet::exact
