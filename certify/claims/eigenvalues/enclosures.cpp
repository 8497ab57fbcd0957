#include "certify/claims/eigenvalues/enclosures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string>

#include "certify/base/error.h"
#include "certify/claims/eigenvalues/forms.h"
#include "certify/net/structure.h"

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

namespace {

constexpr std::int64_t kGreatestStep = 1'000'000;
/// Of the roots of numbers of a file.
constexpr slong kBitsOfRoots = 128;
/// Of so many directions all signs are tried, of others slopes are added up (Lemma 37.10).
constexpr std::size_t kGroup = 4;

/// The sum of the steps across the sides.
std::int64_t step(const EigenvaluesDocument::Direction& direction, std::span<const std::uint32_t> word) {
  std::int64_t result = 0;
  for (const std::uint32_t side : word) result += looked_up(direction.steps, side, "there is no side");
  return result;
}

Problem direction_problem(const EigenvaluesDocument::Direction& direction, std::size_t sides, std::size_t vertices) {
  const auto& [steps, heights] = direction;
  if (steps.size() != sides)
    return std::to_string(steps.size()) + " steps, expected one for each of " + counted(sides, "side", "sides");
  if (!std::all_of(steps.begin(), steps.end(),
                   [](auto step) { return -kGreatestStep <= step && step <= kGreatestStep; }))
    return "a step is not from -10^6 to 10^6";
  if (heights.size() != vertices) {
    return std::to_string(heights.size()) + " heights, expected one for each of " +
           counted(vertices, "vertex", "vertices");
  }
  if (!std::all_of(heights.begin(), heights.end(), [](double height) { return std::isfinite(height); }))
    return "a height is not finite";
  return std::nullopt;
}

}  // namespace

Problem box_problem(const EigenvaluesDocument::Box& box, const NetDocument& net, std::size_t sides) {
  const auto radius = parse_decimal(box.radius);
  if (!radius || *radius <= 0) return "box: the radius " + in_quotes(box.radius) + " is not a decimal > 0";
  const std::size_t vertices = net.vertices.size();
  if (box.directions.size() + vertices > 2 + net.triangles.size() / 2)
    return "box: " + counted(box.directions.size(), "direction", "directions") + ", expected at most twice the genus";
  return first_row_problem("box.directions", box.directions, [&](const EigenvaluesDocument::Direction& direction) {
    return direction_problem(direction, sides, vertices);
  });
}

Problem homomorphism_problem(const EigenvaluesDocument::Box& box, const SurfaceSides& sides) {
  const auto name = [&](const char* what, std::uint32_t side) {
    return what + std::to_string(sides.corner[side]) + " of tile " + std::to_string(sides.tile[side]);
  };
  const std::vector<std::uint32_t> vertices = sides.vertices();
  return first_row_problem(
      "box.directions", box.directions, [&](const EigenvaluesDocument::Direction& direction) -> Problem {
        for (std::uint32_t side = 0; side < sides.partner.size(); ++side) {
          if (step(direction, std::array{side, sides.partner[side]}) != 0)
            return "the steps of " + name("side ", side) + " and its partner do not add up to 0";
        }
        for (const std::uint32_t first : vertices) {
          std::int64_t around = 0;
          std::uint32_t side = first;
          do {
            around += step(direction, std::array{side});
            side = sides.next_around(side);
          } while (side != first);
          if (around != 0) return "the steps across the sides around " + name("vertex ", first) + " do not add up to 0";
        }
        return std::nullopt;
      });
}

namespace {

/// Values in the corners of a triangle, in its chart.
using Heights = std::array<Ball, 3>;

/// By direction and number of a label.
std::vector<std::vector<std::int64_t>> steps_of_labels(const EigenvaluesDocument& document, const Budget& budget) {
  std::vector<std::vector<std::int64_t>> result;
  for (const EigenvaluesDocument::Direction& direction : document.box->directions) {
    std::vector<std::int64_t>& of_labels = result.emplace_back(1, 0);
    for (const NetDocument::Label& label : document.net.labels) {
      budget.spend(memory_work(sizeof(std::int64_t)) + 10 * label.word.size());
      of_labels.push_back(step(direction, label.word));
    }
  }
  return result;
}

/// Of Σ ±h_k, with any signs. Requires: at least one.
Ball greatest_slope(const FlatTriangle& triangle, std::span<const Heights> heights) {
  Ball result;
  for (std::size_t signs = 0; signs < std::size_t{1} << (heights.size() - 1); ++signs) {
    Heights sum = heights.back();
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) sum[i] += (signs >> k & 1) != 0 ? -heights[k][i] : heights[k][i];
    }
    result = max(result, triangle.greatest_slope(sum));
  }
  return result;
}

}  // namespace

std::optional<Ball> root_distance(const EigenvaluesDocument& document, const std::vector<BallIsometry>& labels,
                                  const Budget& budget) {
  const NetDocument& net = document.net;
  const auto& directions = document.box->directions;
  const std::size_t triangles = net.triangles.size();
  budget.spend((400 + 80 * directions.size()) * ball_work(static_cast<std::uint64_t>(Precision::bits())), triangles);
  const std::vector<std::vector<std::int64_t>> steps = steps_of_labels(document, budget);
  Ball slope;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const auto triangle = FlatTriangle::of(flat_sides(net, labels, t, 0).front());
    if (!triangle) return std::nullopt;
    std::vector<Heights> heights(directions.size());
    for (std::size_t k = 0; k < directions.size(); ++k) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        heights[k][i] = Ball::exactly(looked_up(directions[k].heights, start(net, 3 * t + i), "there is no vertex")) +
                        Ball::exactly(looked_up(steps[k], corner_label(net, 3 * t + i), "there is no label"));
      }
    }
    Ball of_all;
    for (std::span<const Heights> rest(heights); !rest.empty();) {
      const std::size_t size = std::min(kGroup, rest.size());
      of_all += greatest_slope(*triangle, rest.first(size));
      rest = rest.subspan(size);
    }
    slope = max(slope, of_all);
  }
  return twice(pi()) * Ball::rounded(decimal(document.box->radius)) * slope;
}

double least_beside(double x, double distance) {
  if (distance == 0) return x;
  const Precision scope(kBitsOfRoots);
  const Ball root = sqrt(Ball::exactly(x)) - Ball::exactly(distance);
  return certainly_less(Ball(), root) == Tri::yes ? lower_end(sqr(root)) : 0;
}

double greatest_beside(double x, double distance) {
  if (distance == 0) return x;
  const Precision scope(kBitsOfRoots);
  return upper_end(sqr(sqrt(Ball::exactly(x)) + Ball::exactly(distance)));
}

}  // namespace epsnet::certify
