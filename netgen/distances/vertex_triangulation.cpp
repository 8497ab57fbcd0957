#include "netgen/distances/vertex_triangulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "certify/net/numbering.h"
#include "netgen/nets/triangulations.h"

namespace epsnet {
namespace {

std::uint32_t next_of(std::uint32_t dart) { return dart % 3 == 2 ? dart - 2 : dart + 1; }
std::uint32_t previous_of(std::uint32_t dart) { return dart % 3 == 0 ? dart + 2 : dart - 1; }

template <class To, class From>
LorentzVector<To> rounded(const LorentzVector<From>& v) {
  return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.t)};
}

/// Returns cot γ for the angle γ opposite to a dart in the Euclidean triangle with the sides sinh(d/2), whose squares
/// `side` gives. It is made larger by the share `slack` of these squares, to be on that side of rounding.
///
/// The circumcentre lies at a distance δ from the edge, on the side of the triangle if δ > 0, with sinh δ = tanh(d/2)
/// cot γ, as cosh R = cosh δ cosh(d/2) and sinh R = sinh(d/2)/sin γ. Without a circumcircle the longest edge is to be
/// flipped.
template <class T, class Side>
T cotangent(std::uint32_t dart, const Side& side, double slack) {
  const T c = side(dart);
  const T a = side(next_of(dart));
  const T b = side(previous_of(dart));
  const T excess = a + b - c + slack * (a + b + c);
  const T square = 4 * a * b - excess * excess;
  using std::sqrt;
  if (square > 0) return excess / sqrt(square);
  constexpr double kLarge = 1e300;
  return excess > 0 ? T(kLarge) : T(-kLarge);
}

/// Returns the sides of a triangle, the longest last.
template <class T, class Side>
std::array<T, 3> sorted_sides(std::uint32_t triangle, const Side& side) {
  std::array<T, 3> sides{side(3 * triangle), side(3 * triangle + 1), side(3 * triangle + 2)};
  if (sides[0] > sides[2]) std::swap(sides[0], sides[2]);
  if (sides[1] > sides[2]) std::swap(sides[1], sides[2]);
  return sides;
}

/// Returns sinh²R = 4abc/K with K = 4ab − (a + b − c)² (docs/proof.md, Lemma 5); for an obtuse triangle R is the radius
/// of the disk whose diameter is the longest edge, c. The excess a + b − c is taken larger by `slack`.
template <class T>
T enclosure(const T& a, const T& b, const T& c, const T& slack) {
  const T excess = a + b - c + slack;
  if (excess <= 0) return c;
  // (a + b − c)²/(4ab) = cos²γ ≤ 1.
  const T rest = 1 - (excess / (2 * a)) * (excess / (2 * b));
  return rest > 0 ? T(c / rest) : T(std::numeric_limits<double>::max());
}

/// Whether p is a point of the hyperboloid, to within rounding.
[[maybe_unused]] bool is_point(const LorentzVector<EdgeElements::Number>& p) {
  return p.t > 0 && abs(EdgeElements::Number(lorentz_product(p, p) + 1)) < ldexp(p.t * p.t, -256);
}

}  // namespace

EdgeElements::Id EdgeElements::add(const Isometry<Number>& g) {
  // Equal elements from different products agree to hundreds of bits. Different ones f and g, with entries up to M,
  // agree to far fewer: M|f − g| is at least about |f⁻¹g − 1|, which is as large as a closed geodesic is long.
  LorentzVector<Number> normal = axis_normal(g.a.x < 0 ? Isometry<Number>{-g.a, -g.b} : g);
  static constexpr int kBits = 256;
  const auto on_grid = [](const Number& x) { return Number(floor(Number(ldexp(x, +kBits)) + Number(0.5))); };
  std::array<Number, 3> key{on_grid(normal.x), on_grid(normal.y), on_grid(normal.t)};
  const bool inverted = key[0] < 0 || (key[0] == 0 && key[1] < 0);
  if (inverted) {
    normal = Number(-1) * normal;
    for (Number& x : key) x = 0 - x;
  }
  const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(elements_.size()));
  if (is_new) {
    elements_.push_back({inverted ? epsnet::inverse(g) : g, normal, isometry_discriminant(g)});
  }
  return 2 * found->second + (inverted ? 1 : 0);
}

EdgeElements::Number EdgeElements::displacement(Id id, const LorentzVector<Number>& p) const {
  const Element& element = this->element(id / 2);
  const Number height = lorentz_product(element.normal, p);
  return element.square + height * height;
}

Isometry<EdgeElements::Number> EdgeElements::isometry(Id id) const {
  const Isometry<Number>& g = element(id / 2).isometry;
  return id % 2 == 0 ? g : epsnet::inverse(g);
}

Frame::Frame(const EdgeElements& elements, const LorentzVector<EdgeElements::Number>& origin)
    : elements_(elements), origin_(origin) {
  assert(is_point(origin));
  const Isometry<EdgeElements::Number> to_origin =
      normalized(Isometry<EdgeElements::Number>::translation(-in_disk(origin)));
  axes_ = {image(to_origin, {1, 0, 0}), image(to_origin, {0, 1, 0}), image(to_origin, {0, 0, 1})};
}

Frame::Point Frame::moved(const LorentzVector<EdgeElements::Number>& v) const {
  return rounded<double>(v.x * axes_[0] + v.y * axes_[1] + v.t * axes_[2]);
}

Frame::Point Frame::point(const LorentzVector<EdgeElements::Number>& p) const {
  const Point v = moved(p);
  const double scale = 1 / std::sqrt((v.t - v.x) * (v.t + v.x) - v.y * v.y);
  return scale * v;
}

double Frame::cosh_distance(const LorentzVector<EdgeElements::Number>& p) const {
  return static_cast<double>(EdgeElements::Number(-lorentz_product(origin_, p)));
}

double Frame::displacement(EdgeElements::Id id, const Point& p) {
  const std::size_t k = id / 2;
  constexpr std::size_t kOfPage = std::tuple_size_v<Page>;
  if (k / kOfPage >= pages_.size()) pages_.resize(elements_.size() / kOfPage + 1);
  std::unique_ptr<Page>& page = pages_[k / kOfPage];
  if (!page) page = std::make_unique<Page>();
  Axis& axis = (*page)[k % kOfPage];
  if (axis.square < 0) {
    axis.normal = moved(elements_.element(k).normal);
    axis.square = static_cast<double>(elements_.element(k).square);
  }
  const double height = lorentz_product(axis.normal, p);
  return axis.square + height * height;
}

std::vector<std::uint32_t> VertexTriangulation::key() const {
  std::vector<std::uint32_t> edges;
  for (std::uint32_t d = 0; d < opposite.size(); ++d) {
    if (d < opposite[d]) edges.push_back(element[d] / 2);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void VertexTriangulation::flip(EdgeElements& elements, std::uint32_t d) {
  // The triangles abc and bax with the edge ab become xca and cxb: each of the outer edges moves on by one place.
  const std::uint32_t e = opposite[d];
  assert(d / 3 != e / 3);
  const std::array<std::uint32_t, 4> from{previous_of(d), next_of(e), previous_of(e), next_of(d)};
  const std::array<std::uint32_t, 4> to{next_of(d), previous_of(d), next_of(e), previous_of(e)};
  std::array<std::uint32_t, 4> across{};
  std::array<EdgeElements::Id, 4> moved{};
  for (std::size_t i = 0; i < 4; ++i) {
    across[i] = opposite[from[i]];
    moved[i] = element[from[i]];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const auto* inner = std::find(from.begin(), from.end(), across[i]);
    const std::uint32_t other = inner == from.end() ? across[i] : to[static_cast<std::size_t>(inner - from.begin())];
    opposite[to[i]] = other;
    opposite[other] = to[i];
    element[to[i]] = moved[i];
  }
  // The new edge leads from c to a and on to x.
  const EdgeElements::Id diagonal = elements.product(moved[0], moved[1]);
  element[e] = diagonal;
  element[d] = EdgeElements::inverse(diagonal);
}

void VertexTriangulation::split(EdgeElements& elements, std::uint32_t d) {
  // The triangles abc and bax with the edge ab become amc, bmx and mbc, max, the new vertex m next to a.
  const std::uint32_t e = opposite[d];
  assert(d / 3 != e / 3);
  const auto n = static_cast<std::uint32_t>(opposite.size());
  const EdgeElements::Id one = elements.add({{1, 0}, {0, 0}});
  const std::uint32_t bc = next_of(d);
  const std::uint32_t ca = previous_of(d);
  const std::uint32_t ax = next_of(e);
  const auto glue = [&](std::uint32_t dart, std::uint32_t other, EdgeElements::Id along) {
    opposite[dart] = other;
    opposite[other] = dart;
    element[dart] = along;
    element[other] = EdgeElements::inverse(along);
  };
  opposite.resize(n + 6);
  element.resize(n + 6);
  const EdgeElements::Id ab = element[d];
  // An outer edge may be the same one as another: what is opposite to it moves as well.
  const auto across = [&](std::uint32_t dart) { return dart == bc ? n + 1 : dart == ax ? n + 4 : dart; };
  const std::array<std::uint32_t, 2> old{across(opposite[bc]), across(opposite[ax])};
  const std::array<EdgeElements::Id, 2> along{element[bc], element[ax]};
  glue(n + 1, old[0], along[0]);
  glue(n + 4, old[1], along[1]);
  glue(d, n + 3, one);
  glue(n, e, ab);
  glue(bc, n + 2, EdgeElements::inverse(element[ca]));
  glue(ax, n + 5, along[1]);
}

PlacedTriangulation::PlacedTriangulation(const VertexTriangulation& triangulation, Frame& frame,
                                         const LorentzVector<Number>& p)
    : triangulation_(triangulation),
      elements_(frame.elements()),
      point_(p),
      displacement_(triangulation.opposite.size()) {
  assert(is_point(p));
  const Frame::Point local = frame.point(p);
  constexpr double kFar = 2;  // cosh of the distance.
  const bool is_far = !(local.t < kFar);
  for (std::uint32_t d = 0; d < displacement_.size(); ++d) {
    const std::uint32_t e = triangulation.opposite[d];
    displacement_[d] = d > e    ? displacement_[e]
                       : is_far ? static_cast<double>(exact_displacement(d))
                                : frame.displacement(triangulation.element[d], local);
  }
}

PlacedTriangulation::Number PlacedTriangulation::exact_displacement(std::uint32_t dart) const {
  return elements_.displacement(triangulation_.element[dart], point_);
}

double PlacedTriangulation::largest_enclosure() const {
  // If one side is much shorter than the others, the difference of these has few digits in binary64. The triangles that
  // may have the greatest radius are evaluated again.
  std::vector<double> most(displacement_.size() / 3);
  double least = 0;
  for (std::uint32_t t = 0; t < most.size(); ++t) {
    const auto [a, b, c] = sorted_sides<double>(t, [&](std::uint32_t d) { return displacement_[d]; });
    constexpr double kRounding = 1e-13;
    most[t] = enclosure(a, b, c, kRounding * c) * (1 + kRounding);
    least = std::max(least, enclosure(a, b, c, -kRounding * c) * (1 - kRounding));
  }
  Number largest = 0;
  for (std::uint32_t t = 0; t < most.size(); ++t) {
    if (most[t] < least) continue;
    const auto [a, b, c] = sorted_sides<Number>(t, [&](std::uint32_t d) { return exact_displacement(d); });
    largest = std::max(largest, enclosure<Number>(a, b, c, 0));
  }
  return static_cast<double>(largest);
}

double PlacedTriangulation::shortest_edge() const {
  return *std::min_element(displacement_.begin(), displacement_.end());
}

bool PlacedTriangulation::counterclockwise() const {
  // They are if the areas of the triangles add up to that of the surface, 2π(E − V − F) with E = 3F/2, and not to more.
  const double area = std::numbers::pi * (static_cast<double>(displacement_.size()) / 3 - 2);
  double sum = 0;
  for (std::uint32_t t = 0; t < displacement_.size() / 3; ++t) {
    const auto [a, b, c] = sorted_sides<double>(t, [&](std::uint32_t d) { return displacement_[d]; });
    // cos(A/2) = (1 + cosh a + cosh b + cosh c)/(4 cosh(a/2) cosh(b/2) cosh(c/2)) for the sides a, b, c; so tan(A/2) is
    // √(K + 4abc)/(2 + a + b + c) for these, with K as in docs/proof.md, Lemma 5.
    const double scale = 1 / (2 + a + b + c);
    const double excess = scale * (a + b - c);
    const double square = 4 * (scale * a) * (scale * b) * (1 + c) - excess * excess;
    const double part = square > 0 ? 2 * std::atan(std::sqrt(square)) : 0;
    // Too small to matter in the sum.
    constexpr double kSmall = 1e-6;
    if (part < kSmall && !counterclockwise(t)) return false;
    sum += part;
  }
  constexpr double kSurplus = 1e-7;
  return sum < area + kSurplus;
}

bool PlacedTriangulation::counterclockwise(std::uint32_t triangle) const {
  const std::uint32_t d = 3 * triangle;
  const auto lift = [&](EdgeElements::Id id) { return image(elements_.isometry(id), point_); };
  const LorentzVector<Number> second = lift(triangulation_.element[d]);
  const LorentzVector<Number> third = lift(EdgeElements::inverse(triangulation_.element[d + 2]));
  return lorentz_product(lorentz_cross(point_, second), third) > 0;
}

bool PlacedTriangulation::locally_delaunay(std::uint32_t dart, double tie) const {
  const std::uint32_t other = triangulation_.opposite[dart];
  const auto rounded_sides = [&](std::uint32_t d) { return displacement_[d]; };
  const auto sides = [&](std::uint32_t d) { return exact_displacement(d); };
  constexpr double kRounding = 1e-13;
  const auto rounded_sum = [&](double slack) {
    return cotangent<double>(dart, rounded_sides, slack) + cotangent<double>(other, rounded_sides, slack);
  };
  if (rounded_sum(kRounding) < 0) return false;
  if (rounded_sum(-kRounding) >= 0) return true;
  return cotangent<Number>(dart, sides, tie) + cotangent<Number>(other, sides, tie) >= 0;
}

std::vector<std::uint32_t> PlacedTriangulation::flips() const {
  const std::vector<std::uint32_t>& opposite = triangulation_.opposite;
  constexpr double kTie = 1e-100;
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t d = 0; d < opposite.size(); ++d) {
    if (d < opposite[d] && d / 3 != opposite[d] / 3 && !locally_delaunay(d, kTie)) candidates.push_back(d);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](std::uint32_t d, std::uint32_t e) { return displacement_[d] > displacement_[e]; });
  std::vector<bool> taken(opposite.size() / 3);
  std::vector<std::uint32_t> result;
  for (const std::uint32_t d : candidates) {
    if (taken[d / 3] || taken[opposite[d] / 3]) continue;
    taken[d / 3] = taken[opposite[d] / 3] = true;
    result.push_back(d);
  }
  return result;
}

bool PlacedTriangulation::is_strictly_delaunay() const {
  constexpr double kMargin = 1e-60;
  for (std::uint32_t d = 0; d < triangulation_.opposite.size(); ++d) {
    if (d < triangulation_.opposite[d] && !locally_delaunay(d, -kMargin)) return false;
  }
  return true;
}

VertexTriangulation vertex_triangulation(Triangulation& triangulation, EdgeElements& elements) {
  VertexTriangulation result;
  const std::uint32_t darts = 3 * triangulation.triangle_count();
  for (std::uint32_t d = 0; d < darts; ++d) {
    result.opposite.push_back(document_dart(triangulation.opposite(triangulation_dart(d))));
    const LabelId along = triangulation.label_along(triangulation_dart(d));
    result.element.push_back(elements.add(triangulation.isometry_in<EdgeElements::Number>(along)));
  }
  return result;
}

namespace {

using certify::next_dart;
using certify::previous_dart;

CellBase::Number cosh_distance(const CellBase::Point& p, const CellBase::Point& q) { return -lorentz_product(p, q); }

CellBase::Point midpoint(const CellBase::Point& p, const CellBase::Point& q) {
  const CellBase::Number half = sqrt(CellBase::Number((1 + cosh_distance(p, q)) / 2));
  return CellBase::Number(1 / (2 * half)) * (p + q);
}

}  // namespace

CellBase::CellBase(VertexTriangulation map, const Point& vertex, EdgeElements& elements)
    : elements_(elements), map_(std::move(map)), start_(map_.opposite.size()), points_{vertex}, side_(start_.size()) {
  for (std::uint32_t d = 0; d < start_.size(); ++d) measure(d);
}

CellBase::Point CellBase::end(std::uint32_t dart) const {
  return image(elements_.isometry(map_.element[dart]), points_[start_[next_dart(dart)]]);
}

void CellBase::measure(std::uint32_t dart) {
  const Number side = (cosh_distance(points_[start_[dart]], end(dart)) - 1) / 2;
  side_[dart] = side_[map_.opposite[dart]] = static_cast<double>(side);
}

PlacedTriangle CellBase::triangle(std::uint32_t t) const {
  const std::uint32_t d = 3 * t;
  const Isometry<Number> back = elements_.isometry(EdgeElements::inverse(map_.element[d + 2]));
  PlacedTriangle result{{points_[start_[d]], end(d), image(back, points_[start_[d + 2]])}, {}};
  for (std::size_t i = 0; i < 3; ++i) result.cosh[i] = cosh_distance(result.corner[i], result.corner[(i + 1) % 3]);
  return result;
}

bool CellBase::locally_delaunay(std::uint32_t dart) const {
  // The cosine of the angle opposite to a dart in the Euclidean triangle with the sides sinh(d/2), at most: the two
  // angles are at most π together. What rounding does not tell stays as it is.
  const auto cosine = [&](std::uint32_t d) {
    constexpr double kRounding = 1e-13;
    const double a = side_[next_dart(d)];
    const double b = side_[previous_dart(d)];
    const double c = side_[d];
    return (a + b - c + kRounding * (a + b + c)) / (2 * std::sqrt(a * b));
  };
  return cosine(dart) + cosine(map_.opposite[dart]) >= 0;
}

void CellBase::flip(std::uint32_t dart) {
  const std::uint32_t d = dart;
  const std::uint32_t e = map_.opposite[d];
  const std::uint32_t a = start_[d];
  const std::uint32_t b = start_[e];
  const std::uint32_t c = start_[previous_dart(d)];
  const std::uint32_t x = start_[previous_dart(e)];
  map_.flip(elements_, d);
  // The triangles xca and cxb.
  start_[d] = x;
  start_[next_dart(d)] = c;
  start_[previous_dart(d)] = a;
  start_[e] = c;
  start_[next_dart(e)] = x;
  start_[previous_dart(e)] = b;
  for (const std::uint32_t k : {d, next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)}) measure(k);
  steps_.push_back(2 * d);
}

void CellBase::split(std::uint32_t dart) {
  const std::uint32_t d = dart;
  const std::uint32_t e = map_.opposite[d];
  const auto n = static_cast<std::uint32_t>(start_.size());
  points_.push_back(midpoint(points_[start_[d]], end(d)));
  map_.split(elements_, d);
  // The triangles amc, bmx, mbc, max.
  const auto m = static_cast<std::uint32_t>(points_.size() - 1);
  start_.insert(start_.end(), {m, start_[e], start_[previous_dart(d)], m, start_[d], start_[previous_dart(e)]});
  start_[next_dart(d)] = start_[next_dart(e)] = m;
  side_.resize(start_.size());
  for (const std::uint32_t k : {d, next_dart(d), previous_dart(d), e, next_dart(e), previous_dart(e), n + 1, n + 4})
    measure(k);
  steps_.push_back(2 * d + 1);
}

void CellBase::make_delaunay(std::vector<std::uint32_t> darts) {
  constexpr int kMostFlips = 1000;
  for (int flips = 0; !darts.empty() && flips < kMostFlips;) {
    const std::uint32_t d = darts.back();
    darts.pop_back();
    const std::uint32_t e = map_.opposite[d];
    if (d / 3 == e / 3 || locally_delaunay(d)) continue;
    flip(d);
    ++flips;
    darts.insert(darts.end(), {next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)});
  }
}

void CellBase::refine(std::size_t most_triangles) {
  const double longest = 2 * std::asinh(std::sqrt(*std::max_element(side_.begin(), side_.end())));
  const double most = std::pow(std::sinh(std::max(2.0, longest / 8) / 2), 2);
  constexpr std::size_t kMostTriangles = 10'000;
  while (triangle_count() + 2 <= std::min(most_triangles, kMostTriangles)) {
    const auto top = std::max_element(side_.begin(), side_.end());
    if (*top <= most) return;
    auto d = static_cast<std::uint32_t>(top - side_.begin());
    std::uint32_t e = map_.opposite[d];
    if (d / 3 == e / 3) return;
    // The midpoint is stored next to the start of the dart: near the net's vertex, where few bits are lost.
    if (cosh_distance(points_[0], points_[start_[e]]) < cosh_distance(points_[0], points_[start_[d]])) std::swap(d, e);
    split(d);
    make_delaunay({next_dart(d), previous_dart(d), next_dart(e), previous_dart(e), triangle_count() * 3 - 5,
                   triangle_count() * 3 - 2});
  }
}

}  // namespace epsnet
