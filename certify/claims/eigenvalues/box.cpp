#include "certify/claims/eigenvalues/box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "certify/base/lookup.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify {
namespace {

constexpr std::int64_t kGreatestStep = 1'000'000;
constexpr slong kBits = 128;

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

std::int64_t step(const EigenvaluesDocument::Direction& direction, std::span<const std::uint32_t> word) {
  std::int64_t result = 0;
  for (const std::uint32_t side : word) result += looked_up(direction.steps, side, "there is no side");
  return result;
}

double least_beside(double x, double distance) {
  if (distance == 0) return x;
  const Precision scope(kBits);
  const Ball root = sqrt(Ball::exactly(x)) - Ball::exactly(distance);
  return certainly_less(Ball(), root) == Tri::yes ? lower_end(sqr(root)) : 0;
}

double greatest_beside(double x, double distance) {
  if (distance == 0) return x;
  const Precision scope(kBits);
  return upper_end(sqr(sqrt(Ball::exactly(x)) + Ball::exactly(distance)));
}

}  // namespace epsnet::certify
