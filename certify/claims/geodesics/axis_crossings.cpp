#include "certify/claims/geodesics/axis_crossings.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "certify/claims/geodesics/chords.h"
#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

/// Operations of balls that a triangle takes.
constexpr std::uint64_t kStepOperations = 20;

/// The vector that belongs to a row, and the other way round.
BallVector dual(BallVector row) {
  row[2] = -std::move(row[2]);
  return row;
}

/// A functional in the chart beyond a dart.
void carry(const LiftedPlane& plane, std::uint32_t dart, BallVector& row) {
  if (const auto* transition = plane.transition(dart)) {
    row = dual(apply(transition->matrix, dual(std::move(row)), plane.precision()));
  }
}

int side(const MovedNet& net, const BallVector& axis, std::uint32_t corner) {
  Ball value;
  dot(value, axis, net.corner(corner), net.plane().precision());
  return certain_sign(value);
}

bool may_be_equal(const BallVector& x, const BallVector& y) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (arb_overlaps(x[i].get(), y[i].get()) == 0) return false;
  }
  return true;
}

/// Where an axis leaves a triangle.
struct Exit {
  std::uint32_t dart;
  BallIsometry element;  ///< In the chart of the triangle,
  BallVector axis;       ///< and its axis.
};

/// The dart across which an axis leaves a triangle that it certainly cuts: its end is on the left of the axis and its
/// start on the right, and the third corner on one of the sides.
std::optional<std::uint32_t> exit_of(const MovedNet& net, std::uint32_t triangle, const BallVector& axis) {
  std::array<int, 3> sides{};
  for (std::uint32_t i = 0; i < 3; ++i) sides[i] = side(net, axis, 3 * triangle + i);
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (sides[i] < 0 && sides[(i + 1) % 3] > 0 && sides[(i + 2) % 3] != 0) return 3 * triangle + i;
  }
  return std::nullopt;
}

/// A triangle that the axis certainly cuts: nearly always one of those that it meets where the vertices are not moved.
std::optional<Exit> find_exit(const MovedNet& net, std::uint32_t first_dart, const BallIsometry& element) {
  std::optional<Exit> exit;
  (void)find_chords(net.plane(), first_dart, element, [&](const Chord& chord) {
    if (const auto dart = exit_of(net, chord.triangle, chord.axis)) exit = Exit{*dart, chord.element, chord.axis};
    return !exit;
  });
  return exit;
}

}  // namespace

std::optional<AxisCrossings> axis_crossings(const MovedNet& net, std::uint32_t first_dart,
                                            const BallIsometry& element) {
  const LiftedPlane& plane = net.plane();
  const std::optional<Exit> first = find_exit(net, first_dart, element);
  if (!first) return std::nullopt;
  const std::uint32_t chart = chart_of_triangle(plane.net(), first->dart / 3);
  AxisCrossings result;
  BallVector axis = first->axis;
  BallIsometry to_here = identity_isometry();
  std::uint32_t dart = first->dart;
  for (;;) {
    plane.spend(kStepOperations);
    plane.keep(4);
    result.darts.push_back(dart);
    result.axes.push_back(axis);
    if (const auto* transition = plane.transition(dart)) {
      to_here = compose(transition->isometry, to_here, plane.precision());
    }
    carry(plane, dart, axis);
    // The axis leaves the next triangle between the third corner and that of the other two on the other side.
    const std::uint32_t back = opposite(plane.net(), dart);
    const int third = side(net, axis, previous_dart(back));
    if (third == 0) return std::nullopt;
    dart = third > 0 ? next_dart(back) : previous_dart(back);
    if (dart != first->dart || !may_be_equal(axis, result.axes[0])) continue;
    BallIsometry period = inverse(to_here);
    choose_sign(period);
    const Tri same = plane.same(chart, period, first->element);
    if (same == Tri::yes) return result;
    if (same == Tri::unknown) return std::nullopt;
  }
}

BallIsometry element_across(const LiftedPlane& plane, std::span<const std::uint32_t> darts) {
  BallIsometry to_end = identity_isometry();
  for (const std::uint32_t dart : darts) {
    if (const auto* transition = plane.transition(dart)) {
      to_end = compose(transition->isometry, to_end, plane.precision());
    }
  }
  BallIsometry result = inverse(to_end);
  choose_sign(result);
  return result;
}

Tri crosses(const MovedNet& net, const BallIsometry& element, std::span<const std::uint32_t> darts) {
  net.plane().spend(kStepOperations, darts.size());
  BallVector axis = axis_row(element, net.plane().precision());
  Tri result = Tri::yes;
  for (const std::uint32_t dart : darts) {
    const int left = side(net, axis, next_dart(dart));
    const int right = side(net, axis, dart);
    if (left < 0 || right > 0) return Tri::no;
    if (left == 0 || right == 0) result = Tri::unknown;
    carry(net.plane(), dart, axis);
  }
  return result;
}

Tri crosses_itself(const LiftedPlane& plane, const AxisCrossings& crossings) {
  const auto triangle = [&](std::uint32_t i) { return crossings.darts[i] / 3; };
  std::vector<std::uint32_t> by_triangle(crossings.darts.size());
  std::iota(by_triangle.begin(), by_triangle.end(), 0U);
  std::stable_sort(by_triangle.begin(), by_triangle.end(),
                   [&](std::uint32_t x, std::uint32_t y) { return triangle(x) < triangle(y); });
  Tri result = Tri::no;
  for (std::size_t i = 0; i < by_triangle.size(); ++i) {
    for (std::size_t k = i; k-- > 0 && triangle(by_triangle[k]) == triangle(by_triangle[i]);) {
      plane.spend(4);
      const Ball product =
          lorentz_product(crossings.axes[by_triangle[i]], crossings.axes[by_triangle[k]], plane.precision());
      result = either(result, certainly_less(abs(product), Ball::exactly(1)));
      if (result == Tri::yes) return result;
    }
  }
  return result;
}

}  // namespace epsnet::certify
