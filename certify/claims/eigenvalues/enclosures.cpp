#include "certify/claims/eigenvalues/enclosures.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

#include "certify/claims/eigenvalues/box.h"

namespace epsnet::certify {
namespace {

using Row = EigenvaluesDocument::Eigenfunctions;

}  // namespace

CountedEigenvalues::CountedEigenvalues(const EigenvaluesDocument& document, double distance)
    : document_(document), functions_{0} {
  for (const Row& row : document.eigenfunctions)
    functions_.push_back(functions_.back() + static_cast<std::int64_t>(row.functions.size()));
  const auto by_place = [](const Extremes& x, const Extremes& y) { return x.below < y.below; };
  for (const auto& [below, count] : document.at_least)
    at_least_.push_back({greatest_beside(below, distance), count, count - beginning_before(below)});
  std::sort(at_least_.begin(), at_least_.end(), by_place);
  for (std::size_t i = 1; i < at_least_.size(); ++i) {
    at_least_[i].count = std::max(at_least_[i].count, at_least_[i - 1].count);
    at_least_[i].without = std::max(at_least_[i].without, at_least_[i - 1].without);
  }
  for (const auto& [below, count, sigma] : document.at_most)
    at_most_.push_back({least_beside(below, distance), count, count - ending_before(below)});
  std::sort(at_most_.begin(), at_most_.end(), by_place);
  for (std::size_t i = at_most_.size(); i-- > 1;) {
    at_most_[i - 1].count = std::min(at_most_[i - 1].count, at_most_[i].count);
    at_most_[i - 1].without = std::min(at_most_[i - 1].without, at_most_[i].without);
  }
}

std::int64_t CountedEigenvalues::beginning_before(double x) const {
  const auto& rows = document_.eigenfunctions;
  const auto end = std::partition_point(rows.begin(), rows.end(), [&](const Row& row) { return row.in.lower < x; });
  return functions_[static_cast<std::size_t>(end - rows.begin())];
}

std::int64_t CountedEigenvalues::ending_up_to(double x) const {
  const auto& rows = document_.eigenfunctions;
  const auto end = std::partition_point(rows.begin(), rows.end(), [&](const Row& row) { return row.in.upper <= x; });
  return functions_[static_cast<std::size_t>(end - rows.begin())];
}

std::int64_t CountedEigenvalues::ending_before(double x) const {
  const auto& rows = document_.eigenfunctions;
  const auto end = std::partition_point(rows.begin(), rows.end(), [&](const Row& row) { return row.in.upper < x; });
  return functions_[static_cast<std::size_t>(end - rows.begin())];
}

std::int64_t CountedEigenvalues::least_up_to(double x) const {
  const std::int64_t functions = ending_up_to(x);
  const auto end =
      std::partition_point(at_least_.begin(), at_least_.end(), [&](const Extremes& row) { return row.below <= x; });
  if (end == at_least_.begin()) return functions;
  // With the functions from `below` to x, if there are any.
  return std::max({functions, std::prev(end)->count, std::prev(end)->without + functions});
}

std::int64_t CountedEigenvalues::most_below(double x) const {
  if (x <= 0) return 0;
  const auto first =
      std::partition_point(at_most_.begin(), at_most_.end(), [&](const Extremes& row) { return row.below < x; });
  if (first == at_most_.end()) return std::numeric_limits<std::int64_t>::max();
  // Without the functions from x to `below`, if there are any.
  return std::max<std::int64_t>(0, std::min(first->count, first->without + beginning_before(x)));
}

Problem CountedEigenvalues::problem() const {
  std::int64_t before = 0;
  // The n-th of those that are counted, from lambda_0 on if there are phases.
  const std::int64_t first = document_.phases.empty() ? 1 : 0;
  const auto index = [&](std::int64_t n) { return "lambda_" + std::to_string(n - 1 + first); };
  for (std::size_t i = 0; i < document_.eigenvalues.size(); ++i) {
    const auto& [in, count] = document_.eigenvalues[i];
    const std::string row = "eigenvalues[" + std::to_string(i) + "]: that ";
    if (most_below(in.lower) > before)
      return row + index(before + 1) + " is at least " + shortest(in.lower) + " does not follow";
    before += count;
    if (least_up_to(in.upper) < before)
      return row + index(before) + " is at most " + shortest(in.upper) + " does not follow";
  }
  if (most_below(document_.next) > before)
    return "next: that " + index(before + 1) + " is at least " + shortest(document_.next) + " does not follow";
  return std::nullopt;
}

}  // namespace epsnet::certify
