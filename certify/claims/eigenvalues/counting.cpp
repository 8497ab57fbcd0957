#include "certify/claims/eigenvalues/counting.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace epsnet::certify {
namespace {

using AtLeast = EigenvaluesDocument::AtLeast;
using Eigenfunction = EigenvaluesDocument::Eigenfunction;

bool contains(Interval x, Interval y) { return x.lower <= y.lower && y.upper <= x.upper; }

}  // namespace

std::vector<Interval> disjoint(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](Interval x, Interval y) { return std::tie(x.upper, x.lower) < std::tie(y.upper, y.lower); });
  std::vector<Interval> result;
  for (const Interval& in : intervals) {
    if (result.empty() || result.back().upper < in.lower) result.push_back(in);
  }
  return result;
}

Counting::Counting(const EigenvaluesDocument& document) : document_(document) {
  for (const auto& row : document.at_most) by_upper_.push_back({row.in, row.count, {}});
  std::sort(by_upper_.begin(), by_upper_.end(), [](const auto& x, const auto& y) { return x.in.upper < y.in.upper; });
}

std::optional<std::uint64_t> Counting::most(Interval closed) const {
  // By statement: the least sum of counts of statements that cover from the lower end to its own upper end.
  std::vector<std::optional<std::uint64_t>> cost(by_upper_.size());
  std::optional<std::uint64_t> best;
  const auto improve = [](std::optional<std::uint64_t>& least, std::uint64_t value) {
    if (!least || value < *least) least = value;
  };
  for (std::size_t i = 0; i < by_upper_.size(); ++i) {
    const auto& [in, count, none] = by_upper_[i];
    if (in.lower <= closed.lower) {
      improve(cost[i], count);
    } else {
      for (std::size_t j = 0; j < i; ++j) {
        if (cost[j] && by_upper_[j].in.upper >= in.lower) improve(cost[i], *cost[j] + count);
      }
    }
    if (cost[i] && in.upper >= closed.upper) improve(best, *cost[i]);
  }
  return best;
}

bool Counting::at_least(std::uint32_t count, Interval window) const {
  std::vector<Interval> known;
  for (const Eigenfunction& row : document_.eigenfunctions) {
    if (contains(window, row.in)) known.push_back(row.in);
  }
  if (count <= disjoint(std::move(known)).size()) return true;
  return std::any_of(document_.at_least.begin(), document_.at_least.end(), [&](const AtLeast& row) {
    return row.count >= count && contains(window, row.within) && none_between(row.in.lower, row.within.lower) &&
           none_between(row.within.upper, row.in.upper);
  });
}

bool Counting::not_all_in(Interval part, Interval window, std::uint32_t count) const {
  if (const auto there = most(part); there && *there < count) return true;
  const auto& functions = document_.eigenfunctions;
  if (std::any_of(functions.begin(), functions.end(), [&](const Eigenfunction& row) {
        return contains(window, row.in) && (row.in.upper < part.lower || part.upper < row.in.lower);
      })) {
    return true;
  }
  return std::any_of(document_.at_least.begin(), document_.at_least.end(), [&](const AtLeast& row) {
    return row.count > count && contains(row.within, part) && none_between(row.in.lower, window.lower) &&
           none_between(window.upper, row.in.upper);
  });
}

Problem Counting::window_problem(const EigenvaluesDocument::Window& window) const {
  if (const auto there = most(window.in); !there || *there > window.most) {
    return "at most " + std::to_string(window.most) +
           " eigenvalues: " + (there ? "only at most " + std::to_string(*there) + " follows" : "no bound follows");
  }
  if (!at_least(window.least, window.in)) {
    return "at least " + std::to_string(window.least) + (window.least == 1 ? " eigenvalue" : " eigenvalues") +
           " does not follow";
  }
  const Interval in = window.in;
  if (window.smallest.upper < in.upper && !not_all_in({window.smallest.upper, in.upper}, in, window.most)) {
    return "that the smallest eigenvalue lies in " + to_string(window.smallest) + " does not follow";
  }
  if (in.lower < window.greatest.lower && !not_all_in({in.lower, window.greatest.lower}, in, window.most)) {
    return "that the greatest eigenvalue lies in " + to_string(window.greatest) + " does not follow";
  }
  return std::nullopt;
}

Problem Counting::problem() const {
  double end = 0;
  for (std::size_t i = 0; i <= document_.windows.size(); ++i) {
    const bool last = i == document_.windows.size();
    const Interval gap{end, last ? document_.eigenvalues_up_to : document_.windows[i].in.lower};
    if (!none_between(gap.lower, gap.upper))
      return "that there is no eigenvalue between the windows, in " + to_string(gap) + ", does not follow";
    if (last) break;
    if (const auto problem = window_problem(document_.windows[i]))
      return "window " + std::to_string(i) + ": " + *problem;
    end = document_.windows[i].in.upper;
  }
  return std::nullopt;
}

}  // namespace epsnet::certify
