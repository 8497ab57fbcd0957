#include "certify/claims/geodesics/axis_crossings.h"

#include <algorithm>
#include <array>

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

/// A line that leaves a triangle.
struct Exit {
  std::uint32_t dart;
  BallIsometry element;  ///< In the chart of the triangle,
  BallVector axis;       ///< and its axis.
};

using Sides = std::array<int, 3>;

/// The sides of a line on which the corners of a triangle certainly lie.
Sides sides(const MovedNet& net, std::uint32_t triangle, const BallVector& line) {
  Sides result{};
  for (std::uint32_t i = 0; i < 3; ++i) result[i] = side(net, line, 3 * triangle + i);
  return result;
}

/// The number of the edge across which a line leaves a triangle that it certainly cuts: its end is on the left of the
/// line and its start on the right, and the third corner on one of the sides.
std::optional<std::uint32_t> exit_edge(const Sides& sides) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (sides[i] < 0 && sides[(i + 1) % 3] > 0 && sides[(i + 2) % 3] != 0) return i;
  }
  return std::nullopt;
}

/// From a point of the first triangle along the perpendicular to the axis, to a triangle that the axis certainly cuts.
std::optional<Exit> find_exit(const MovedNet& net, std::uint32_t first_dart, const BallIsometry& element) {
  const LiftedPlane& plane = net.plane();
  const Precision scope(plane.precision());
  std::uint32_t triangle = first_dart / 3;
  const BallIsometry& to_triangle = plane.label(corner_label(plane.net(), first_dart));
  BallIsometry here =
      compose(compose(to_triangle, element, plane.precision()), inverse(to_triangle), plane.precision());
  choose_sign(here);
  BallVector axis = axis_row(here, plane.precision());
  // On no symmetry of the triangle.
  BallVector point, foot;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = 31 * net.corner(first_dart)[i] + 22 * net.corner(next_dart(first_dart))[i] +
               11 * net.corner(previous_dart(first_dart))[i];
  }
  Ball distance;
  dot(distance, axis, point, plane.precision());
  const BallVector normal = dual(axis);
  for (std::size_t i = 0; i < 3; ++i) foot[i] = point[i] - distance * normal[i];
  BallVector perpendicular = cross_product(point, foot, plane.precision());
  for (;;) {
    plane.spend(kStepOperations);
    const Sides of_axis = sides(net, triangle, axis);
    if (const auto edge = exit_edge(of_axis)) return Exit{3 * triangle + *edge, std::move(here), std::move(axis)};
    if (of_axis[0] == 0 || of_axis[0] != of_axis[1] || of_axis[1] != of_axis[2]) return std::nullopt;
    const auto edge = exit_edge(sides(net, triangle, perpendicular));
    if (!edge) return std::nullopt;
    const std::uint32_t dart = 3 * triangle + *edge;
    if (const auto* transition = plane.transition(dart)) {
      const BallIsometry& across = transition->isometry;
      here = compose(compose(across, here, plane.precision()), inverse(across), plane.precision());
      choose_sign(here);
    }
    carry(plane, dart, axis);
    carry(plane, dart, perpendicular);
    triangle = opposite(plane.net(), dart) / 3;
  }
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

std::vector<Meetings> find_meetings(const LiftedPlane& plane, std::span<const AxisCrossings> geodesics) {
  struct Chord {
    std::uint32_t triangle;
    std::size_t geodesic;
    const BallVector* axis;
  };
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < geodesics.size(); ++i) {
    for (std::size_t k = 0; k < geodesics[i].darts.size(); ++k) {
      chords.push_back({geodesics[i].darts[k] / 3, i, &geodesics[i].axes[k]});
    }
  }
  std::stable_sort(chords.begin(), chords.end(),
                   [](const Chord& x, const Chord& y) { return x.triangle < y.triangle; });
  std::vector<Meetings> result(geodesics.size());
  for (auto y = chords.begin(); y != chords.end(); ++y) {
    for (auto x = y; x != chords.begin() && std::prev(x)->triangle == y->triangle;) {
      --x;
      const bool same = x->geodesic == y->geodesic;
      Tri& of_x = same ? result[x->geodesic].itself : result[x->geodesic].another;
      Tri& of_y = same ? of_x : result[y->geodesic].another;
      if (of_x == Tri::yes && of_y == Tri::yes) continue;
      plane.spend(4);
      const Tri cross = certainly_less(abs(lorentz_product(*x->axis, *y->axis, plane.precision())), Ball::exactly(1));
      of_x = either(of_x, cross);
      of_y = either(of_y, cross);
    }
  }
  return result;
}

Interval translation_length(const BallIsometry& element, slong precision) {
  const Precision scope(precision);
  const Interval interval = outer_interval(twice(acosh(cosh_half_length(element))));
  return {std::max(interval.lower, 0.0), interval.upper};
}

std::vector<std::uint32_t> first_darts(const NetDocument& net) {
  std::vector<std::uint32_t> darts(net.vertices.size());
  for (std::uint32_t dart = 3 * static_cast<std::uint32_t>(net.triangles.size()); dart-- > 0;) {
    darts[start(net, dart)] = dart;
  }
  return darts;
}

}  // namespace epsnet::certify
