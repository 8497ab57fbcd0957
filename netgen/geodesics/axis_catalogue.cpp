#include "netgen/geodesics/axis_catalogue.h"

#include <map>
#include <string>

#include "netgen/nets/certified_net.h"

namespace epsnet {
namespace {

// A limit that no walk reaches: a closed geodesic crosses a few triangles per unit of length, and walks across thin
// collars take some tens of steps.
constexpr std::size_t kMostSteps = 100'000;

/// A value smaller than this, relative to what it was computed from, counts as 0. This is far above the rounding and
/// far below any other value that occurs in a group with closed geodesics of moderate length.
template <class T>
T zero_level() {
  return boost::multiprecision::ldexp(T(1), std::is_same_v<T, Mp256> ? -80 : -200);
}

/// Returns the Euclidean square.
template <class T>
T size2(const LorentzVector<T>& v) {
  return v.x * v.x + v.y * v.y + v.t * v.t;
}

}  // namespace

template <class T>
bool AxisCatalogue<T>::same_axis(const Isometry<T>& f, const Isometry<T>& g) {
  const Vector u = axis_normal(f);
  const Vector v = axis_normal(g);
  const T level = zero_level<T>();
  return size2(lorentz_cross(u, v)) <= level * level * size2(u) * size2(v);
}

/// Returns a number of an axis that does not depend on its direction: the absolute product of its normal, scaled to
/// Euclidean length 1, with a fixed vector, rounded. The vector is on no line of symmetry of common surfaces, so that
/// axes rarely share a number.
template <class T>
double AxisCatalogue<T>::key(const Isometry<T>& f) {
  const Vector normal = axis_normal(f);
  const Vector weights{T(0.71), T(0.53), T(0.47)};
  using boost::multiprecision::abs;
  using boost::multiprecision::sqrt;
  return static_cast<double>(T(abs(lorentz_product(weights, normal)) / sqrt(size2(normal))));
}

/// Unit normals u, v of two lines have |⟨u, v⟩| < 1 exactly if the lines cross.
template <class T>
bool AxisCatalogue<T>::axes_cross(const Isometry<T>& f, const Isometry<T>& g) {
  const T product = lorentz_product(axis_normal(f), axis_normal(g));
  return product * product < isometry_discriminant(f) * isometry_discriminant(g);
}

/// Returns by ∘ f ∘ by⁻¹, with Re a > 0.
template <class T>
Isometry<T> AxisCatalogue<T>::conjugate(const Isometry<T>& by, const Isometry<T>& f) {
  const Isometry<T> result = by * f * inverse(by);
  return result.a.x < 0 ? Isometry<T>{-result.a, -result.b} : result;
}

template <class T>
Isometry<T> AxisCatalogue<T>::label(LabelId l) {
  return l == kIdentity ? Isometry<T>{} : triangulation_.isometry_in<T>(l);
}

template <class T>
const typename AxisCatalogue<T>::Corners& AxisCatalogue<T>::corners(TriangleId t) {
  if (!corners_[t]) {
    corners_[t].emplace();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [vertex, l] = triangulation_.corner(t, i);
      const Complex<T> z = convert<T>(triangulation_.vertex(vertex).z);
      const Vector x = on_hyperboloid(z);
      (*corners_[t])[i] = l == kIdentity ? x : image(label(l), x);
    }
  }
  return *corners_[t];
}

template <class T>
typename AxisCatalogue<T>::Vector AxisCatalogue<T>::carried(Dart d, const Vector& x) {
  const LabelId l = triangulation_.transition(d);
  return l == kIdentity ? x : image(inverse(label(l)), x);
}

template <class T>
typename AxisCatalogue<T>::Place AxisCatalogue<T>::beyond(Dart d, const Isometry<T>& element) {
  const LabelId l = triangulation_.transition(d);
  return {triangle_of(triangulation_.opposite(d)), l == kIdentity ? element : conjugate(inverse(label(l)), element)};
}

template <class T>
Isometry<T> AxisCatalogue<T>::element(const ReturnPath& path) {
  Isometry<T> result = label(triangulation_.corner(triangle_of(path.end), corner_of(path.end)).label);
  for (std::size_t i = path.darts.size(); i-- > 0;) {
    const LabelId l = triangulation_.transition(path.darts[i]);
    if (l != kIdentity) result = label(l) * result;
  }
  result = result * inverse(label(triangulation_.corner(triangle_of(path.start), corner_of(path.start)).label));
  return result.a.x < 0 ? Isometry<T>{-result.a, -result.b} : result;
}

template <class T>
T AxisCatalogue<T>::distance_from_axis(Dart start, const Isometry<T>& element) {
  const T side = lorentz_product(axis_normal(element), corners(triangle_of(start))[corner_of(start)]);
  using boost::multiprecision::abs;
  using boost::multiprecision::asinh;
  using boost::multiprecision::sqrt;
  return asinh(T(abs(side) / sqrt(isometry_discriminant(element))));
}

/// Walks from a vertex to the triangle that contains the point of the axis nearest to it (visibility walk).
template <class T>
typename AxisCatalogue<T>::Place AxisCatalogue<T>::walk_to_axis(Dart start, const Isometry<T>& element) {
  Place place{triangle_of(start), element};
  const Vector x = corners(triangle_of(start))[corner_of(start)];
  const Vector axis = axis_normal(element);
  // The point is x minus its component along the normal of the axis; the length of the vector does not matter.
  const T component = lorentz_product(axis, x) / isometry_discriminant(element);
  Vector foot = x + T(-component) * axis;
  std::uint32_t entered = 3;
  for (std::size_t steps = 0; steps < kMostSteps; ++steps) {
    const Corners& y = corners(place.triangle);
    std::uint32_t leave = 3;
    for (std::uint32_t i = 0; i < 3 && leave == 3; ++i) {
      // A foot on an edge or a vertex counts as inside every triangle there. Where `passage` sees the axis beside an
      // edge, however short that is, the foot is not on the edge: it is tested a million times as finely.
      const Vector edge = lorentz_cross(y[i], y[next(i)]);
      const T level =
          boost::multiprecision::ldexp(zero_level<T>(), -20) * boost::multiprecision::sqrt(size2(edge)) * foot.t;
      if (i != entered && lorentz_product(edge, foot) < -level) leave = i;
    }
    if (leave == 3) return place;
    const Dart d = make_dart(place.triangle, leave);
    place = beyond(d, place.element);
    entered = corner_of(triangulation_.opposite(d));
    foot = carried(d, foot);
  }
  throw NetError("the axis of a closed geodesic was not reached in " + std::to_string(kMostSteps) + " steps");
}

template <class T>
std::optional<std::uint32_t> AxisCatalogue<T>::find(const Place& place) {
  // This margin is far above the rounding and the tolerance of same_axis; a margin that is too large only costs time.
  constexpr double kMargin = 1e-12;
  const std::multimap<double, Known>& known = axes_in_[place.triangle];
  const double wanted = key(place.element);
  for (auto i = known.lower_bound(wanted - kMargin); i != known.end() && i->first <= wanted + kMargin; ++i) {
    if (same_axis(i->second.element, place.element)) return i->second.geodesic;
  }
  return std::nullopt;
}

template <class T>
typename AxisCatalogue<T>::Passage AxisCatalogue<T>::passage(const Place& place) {
  Passage result;
  const Vector axis = axis_normal(place.element);
  const T size = boost::multiprecision::sqrt(lorentz_product(axis, axis));
  std::array<T, 3> side;
  std::array<bool, 3> left;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Vector& x = corners(place.triangle)[i];
    side[i] = lorentz_product(axis, x);
    // By the sinh of the distance, so that all triangles at a vertex see it on the same side.
    const bool on_axis = boost::multiprecision::abs(side[i]) <= zero_level<T>() * size;
    if (on_axis) side[i] = 0;
    if (on_axis) result.vertex = i;
    left[i] = side[i] >= 0;
  }
  if (left[0] == left[1] && left[1] == left[2]) return result;
  const std::uint32_t cut = left[1] == left[2] ? 0 : left[0] == left[2] ? 1 : 2;
  // The geodesic leaves where the boundary, followed counterclockwise, passes from its right to its left.
  std::uint32_t leave = 0;
  while (left[leave] || !left[next(leave)]) ++leave;
  const T position = side[cut] / (side[cut] - side[next(cut)]);
  result.step = Step{place.triangle, place.element, cut, left[cut], position};
  result.leave = make_dart(place.triangle, leave);
  return result;
}

template <class T>
typename AxisCatalogue<T>::Place AxisCatalogue<T>::cut_triangle(Place place) {
  const Passage first = passage(place);
  if (first.step || !first.vertex) return place;
  // All around the vertex there is a triangle with a corner on the right: the vertex counts as on the left.
  Dart d = make_dart(place.triangle, *first.vertex);
  for (std::size_t steps = 0; steps < kMostSteps; ++steps) {
    place = beyond(d, place.element);
    d = next_dart(triangulation_.opposite(d));
    if (passage(place).step) return place;
  }
  throw NetError("a closed geodesic was not found at a vertex that it passes through");
}

/// Follows one period, from a triangle that contains a point of the axis.
template <class T>
typename AxisCatalogue<T>::Period AxisCatalogue<T>::follow(Place place) {
  Period period;
  std::vector<Step>& steps = period.steps;
  place = cut_triangle(place);
  while (steps.size() < kMostSteps) {
    // The period ends with the element that it started with, not with another lift of the same geodesic.
    if (!steps.empty() && place.triangle == steps[0].triangle && same_axis(place.element, steps[0].element))
      return period;
    const Passage here = passage(place);
    period.meets_vertex = period.meets_vertex || here.vertex;
    if (!here.step) break;
    steps.push_back(*here.step);
    place = beyond(here.leave, place.element);
  }
  throw NetError("a closed geodesic could not be followed through the triangulation");
}

template <class T>
bool AxisCatalogue<T>::is_simple(const std::vector<Step>& steps) {
  std::map<TriangleId, std::vector<const Step*>> by_triangle;
  for (const Step& step : steps) {
    std::vector<const Step*>& others = by_triangle[step.triangle];
    for (const Step* other : others) {
      if (axes_cross(other->element, step.element)) return false;
    }
    others.push_back(&step);
  }
  return true;
}

template <class T>
std::uint32_t AxisCatalogue<T>::find_or_add(const ReturnPath& path, const Isometry<T>& element) {
  const Place place = walk_to_axis(path.start, element);
  if (const auto known = find(place)) return *known;
  Period period = follow(place);
  std::vector<Step>& steps = period.steps;
  // The geodesic may have been pushed out of the triangle at this place.
  for (const Step& step : steps) {
    if (const auto known = find({step.triangle, step.element})) return *known;
  }
  const auto number = static_cast<std::uint32_t>(geodesics_.size());
  const auto enter = [&](const std::vector<Step>& passed) {
    for (const Step& step : passed) axes_in_[step.triangle].emplace(key(step.element), Known{number, step.element});
  };
  enter(steps);
  // In the other direction it is pushed to the other side, where the inverse of the element will find it.
  if (period.meets_vertex) enter(follow({place.triangle, inverse(place.element)}).steps);
  const bool simple = is_simple(steps);
  geodesics_.push_back({displacement_length(element), path, std::move(steps), simple});
  return number;
}

template class AxisCatalogue<Mp256>;
template class AxisCatalogue<Mp1024>;

}  // namespace epsnet
