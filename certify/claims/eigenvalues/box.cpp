#include "certify/claims/eigenvalues/box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "certify/base/lookup.h"
#include "certify/claims/eigenvalues/forms.h"
#include "certify/net/structure.h"

namespace epsnet::certify {
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
      budget.spend(10 + 10 * label.word.size());
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
