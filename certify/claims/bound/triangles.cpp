#include "certify/claims/bound/triangles.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "certify/base/error.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/numbering.h"

namespace epsnet::certify {

namespace {

/// The work of looking at an edge for a step of a path; operations of balls for one that may be the next, and for the
/// step.
constexpr std::uint64_t kLookWork = 10;
constexpr std::uint64_t kNearOperations = 4;
constexpr std::uint64_t kPathOperations = 80;

std::array<double, 3> nearly(const BallVector& p) {
  return {fast_interval(p[0]).lower, fast_interval(p[1]).lower, fast_interval(p[2]).lower};
}

/// Whether two points seem to be farther from each other than this, the cosh of a distance: then balls need not tell.
bool is_farther(const std::array<double, 3>& p, const std::array<double, 3>& q, double cosh_distance) {
  constexpr double kRounding = 1e-14;
  return (1 - kRounding) * p[2] * q[2] - p[0] * q[0] - p[1] * q[1] > cosh_distance;
}

/// A number of an isometry with Re a > 0 that few others share, and its inverse has with the other sign. NaN if balls
/// do not tell it well.
double number_of(const BallIsometry& g) {
  const Ball number = real(g.b) + Ball::exactly(0.618) * imaginary(g.b) + Ball::exactly(0.377) * imaginary(g.a);
  const Interval x = fast_interval(number);
  constexpr double kNear = 1e-12;
  return x.upper - x.lower < kNear * (1 + std::fabs(x.lower)) ? x.lower : std::nan("");
}

}  // namespace

Element element_of(BallIsometry isometry, slong precision) {
  const Precision scope(precision);
  BallVector row = traceless_row(isometry);
  Ball square = norm(isometry.b) - sqr(imaginary(isometry.a));
  return {std::move(isometry), std::move(row), std::move(square)};
}

Ball displacement(const Element& element, const BallVector& p, slong precision) {
  Ball result;
  dot(result, element.normal_row, p, precision);
  arb_sqr(result.get(), result.get(), precision);
  arb_add(result.get(), result.get(), element.square.get(), precision);
  return result;
}

Ball least_displacement(const std::vector<BallIsometry>& elements, const BallVector& p, slong precision) {
  const Precision scope(precision);
  std::optional<Ball> least;
  for (const BallIsometry& g : elements) {
    Ball own = displacement(element_of(g, precision), p, precision);
    least = least ? min(*least, own) : std::move(own);
  }
  return value_of(least, "there is no element");
}

Elements::Elements(BallVector point, Ball shortest_loop, const std::vector<BallIsometry>& edges, slong precision,
                   Budget budget)
    : point_(std::move(point)),
      shortest_loop_(std::move(shortest_loop)),
      precision_(precision),
      budget_(std::move(budget)) {
  const slong fine = path_precision(precision);
  for (const BallIsometry& edge : edges) {
    for (const BallIsometry& step : {edge, inverse(edge)}) {
      const BallVector end = apply(lorentz_matrix(step, fine), point_, fine);
      steps_.push_back({step, end, nearly(end)});
    }
  }
}

bool Elements::are_equal(const BallIsometry& f, const BallIsometry& g) const {
  const BallIsometry quotient = compose(inverse(f), g, precision_);
  return certainly_less(displacement(element_of(quotient, precision_), point_, precision_), shortest_loop_) == Tri::yes;
}

BallIsometry Elements::enclosed_along_edges(const BallIsometry& g) const {
  const auto away = [&](const BallVector& p, const BallVector& q) {
    return fast_interval(-lorentz_product(p, q, precision_)).upper;
  };
  const slong fine = path_precision(precision_);
  const BallVector image = apply(lorentz_matrix(g, precision_), point_, precision_);
  BallVector goal = image;  // As seen from the end of the path.
  BallIsometry path = identity_isometry();
  double distance = away(point_, goal);
  constexpr int kMostSteps = 1000;
  for (int i = 0; i < kMostSteps; ++i) {
    const std::uint64_t ball = ball_work(static_cast<std::uint64_t>(fine));
    budget_.spend(kLookWork, steps_.size());
    budget_.spend(kPathOperations * ball);
    const Step* nearest = nullptr;
    const std::array<double, 3> near_goal = nearly(goal);
    for (const Step& step : steps_) {
      if (is_farther(step.nearly, near_goal, distance)) continue;
      budget_.spend(kNearOperations * ball);
      const double left = away(step.end, goal);
      if (!(left < distance)) continue;
      distance = left;
      nearest = &step;
    }
    if (nearest == nullptr) break;
    path = compose(path, nearest->isometry, fine);
    goal = apply(lorentz_matrix(inverse(path), fine), image, fine);
  }
  choose_sign(path);
  return are_equal(path, g) ? path : g;
}

Elements::Id Elements::add(BallIsometry g) {
  const Precision scope(precision_);
  choose_sign(g);
  double number = number_of(g);
  const bool inverted = number < 0;
  if (inverted) {
    g = inverse(g);
    number = -number;
  }
  const auto known = static_cast<Id>(elements_.size());
  if (!std::isnan(number)) {
    const double reach = 1e-9 * (1 + number);
    // More elements may share the number, by chance or by malice: what is not found is kept twice.
    int looks = 4;
    for (auto found = by_number_.lower_bound(number - reach);
         found != by_number_.end() && found->first < number + reach && looks > 0; ++found, --looks) {
      if (are_equal(elements_[found->second].isometry, g)) return 2 * found->second + (inverted ? 1 : 0);
    }
    by_number_.emplace(number, known);
  }
  all_told_ = all_told_ && !std::isnan(number);
  // Few bits lost are left to the products to come.
  const bool is_precise = arb_rel_accuracy_bits(g.a.re()) >= precision_ - precision_ / 4;
  elements_.push_back(element_of(is_precise ? std::move(g) : enclosed_along_edges(g), precision_));
  return 2 * known + (inverted ? 1 : 0);
}

const Element& Elements::element(Id id) const { return looked_up(elements_, id / 2, "there is no element"); }

BallIsometry Elements::isometry(Id id) const {
  const BallIsometry& g = element(id).isometry;
  return id % 2 == 0 ? g : inverse(g);
}

namespace {

Frame::Point in_binary64(const BallVector& x) {
  return {fast_interval(x[0]), fast_interval(x[1]), fast_interval(x[2])};
}

Interval dot(const Frame::Point& row, const Frame::Point& x) { return row[0] * x[0] + row[1] * x[1] + row[2] * x[2]; }

/// The translation along a line that takes (u, t) to (0, 0, 1): with I + uuᵀ/(1 + t), −u and t. Its inverse takes
/// (−u, t) there.
BallMatrix to_centre(const BallVector& p) {
  const Ball& t = p[2];
  BallMatrix m;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) m[i][k] = p[i] * p[k] / (t + 1);
    m[i][i] = m[i][i] + 1;
    m[i][2] = m[2][i] = -p[i];
  }
  m[2][2] = t;
  return m;
}

}  // namespace

Frame::Frame(const BallVector& origin, slong precision) : precision_(precision) {
  const Precision scope(precision);
  to_frame_ = to_centre(origin);
  from_frame_ = to_centre({-origin[0], -origin[1], origin[2]});
}

Interval Frame::cosh_distance(const BallVector& p) const {
  Ball result;
  certify::dot(result, to_frame_[2], p, precision_);
  return fast_interval(result);
}

Frame::Point Frame::point(const BallVector& p) const { return in_binary64(apply(to_frame_, p, precision_)); }

Interval Frame::displacement(std::uint32_t k, const Element& element, const Point& p) {
  const auto [found, is_new] = elements_.try_emplace(k);
  if (is_new) {
    // A row r is r times the inverse in the coordinates of the frame; the matrix is symmetric.
    found->second = {in_binary64(apply(from_frame_, element.normal_row, precision_)), fast_interval(element.square)};
  }
  return found->second.square + sqr(dot(found->second.row, p));
}

Frame& Frames::near(const BallVector& p) {
  constexpr double kFar = 1.5;  // cosh of the distance.
  const auto is_near = [&](const Frame& frame) { return frame.cosh_distance(p).upper < kFar; };
  if (last_ < frames_.size() && is_near(frames_[last_])) return frames_[last_];
  for (last_ = 0; last_ < frames_.size(); ++last_) {
    if (is_near(frames_[last_])) return frames_[last_];
  }
  return frames_.emplace_back(p, precision_);
}

Product flip(Map& map, std::uint32_t d, std::uint32_t diagonal) {
  const std::uint32_t e = map.opposite[d];
  const std::array<std::uint32_t, 4> from{previous_dart(d), next_dart(e), previous_dart(e), next_dart(d)};
  const std::array<std::uint32_t, 4> to{next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)};
  const Map old = {{map.opposite[from[0]], map.opposite[from[1]], map.opposite[from[2]], map.opposite[from[3]]},
                   {map.element[from[0]], map.element[from[1]], map.element[from[2]], map.element[from[3]]}};
  for (std::size_t i = 0; i < 4; ++i) {
    std::uint32_t across = old.opposite[i];
    for (std::size_t k = 0; k < 4; ++k) {
      if (old.opposite[i] == from[k]) across = to[k];
    }
    map.opposite[to[i]] = across;
    map.opposite[across] = to[i];
    map.element[to[i]] = old.element[i];
  }
  map.element[e] = 2 * diagonal;
  map.element[d] = 2 * diagonal + 1;
  // From c to a, and on to x.
  return {old.element[0], old.element[1]};
}

Product flip(Base& base, std::uint32_t d, std::uint32_t diagonal) {
  const std::uint32_t e = base.map.opposite[d];
  const std::uint32_t a = base.start[d];
  const std::uint32_t b = base.start[e];
  const std::uint32_t c = base.start[previous_dart(d)];
  const std::uint32_t x = base.start[previous_dart(e)];
  base.start[d] = base.start[next_dart(e)] = x;
  base.start[e] = base.start[next_dart(d)] = c;
  base.start[previous_dart(d)] = a;
  base.start[previous_dart(e)] = b;
  return flip(base.map, d, diagonal);
}

void split(Base& base, std::uint32_t d, std::uint32_t one) {
  std::vector<std::uint32_t>& opposite = base.map.opposite;
  std::vector<std::uint32_t>& element = base.map.element;
  const std::uint32_t e = opposite[d];
  const auto m = static_cast<std::uint32_t>(base.midpoints.size()) + 1;
  base.midpoints.push_back({base.start[d], base.start[e], element[d]});
  // The darts of mbc and max, and those of abc and bax whose edges they take over: bc and ax.
  const auto mbc = static_cast<std::uint32_t>(opposite.size());
  const std::uint32_t max = mbc + 3;
  const std::uint32_t bc = next_dart(d);
  const std::uint32_t ax = next_dart(e);
  opposite.resize(mbc + 6);
  element.resize(mbc + 6);
  base.start.insert(base.start.end(), {m, base.start[e], base.start[previous_dart(d)],  //
                                       m, base.start[d], base.start[previous_dart(e)]});
  base.start[bc] = base.start[ax] = m;
  const auto glue = [&](std::uint32_t dart, std::uint32_t other, std::uint32_t along) {
    opposite[dart] = other;
    opposite[other] = dart;
    element[dart] = along;
    element[other] = along ^ 1U;
  };
  // The two edges may be opposite to each other: then both are glued when the second one is.
  const std::array<std::uint32_t, 2> across{opposite[bc], opposite[ax] == bc ? mbc + 1 : opposite[ax]};
  const std::array<std::uint32_t, 2> along{element[bc], element[ax]};
  const std::uint32_t to_b = element[d];
  glue(mbc + 1, across[0], along[0]);
  glue(max + 1, across[1], along[1]);
  glue(mbc, e, to_b);
  glue(d, max, one);
  // The new vertex is next to a: from it to c as from a, and likewise to x.
  glue(mbc + 2, bc, element[previous_dart(d)]);
  glue(ax, max + 2, along[1]);
}

namespace {

/// π in the arithmetic of the caller.
template <class Number>
Number half_turn() {
  return pi();
}
template <>
Interval half_turn<Interval>() {
  return {0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1};
}

template <class Number>
SidesIn<Number> sides_of(std::span<const Number> h, std::size_t t) {
  return h.subspan(3 * t).template first<3>();
}

/// Whether a triangle's circumradius is at least r: 4abc ≥ K sinh²r.
template <class Number>
Tri is_wide(SidesIn<Number> sides, const Number& k, const Number& least) {
  return !certainly_less(4 * (sides[0] * sides[1] * sides[2]), k * least);
}

/// The sides a, b, c: b + c − a, c + a − b, a + b − c, whose signs are those of the cosines of the opposite angles.
template <class Number>
std::array<Number, 3> excesses(SidesIn<Number> sides) {
  return {sides[1] + sides[2] - sides[0], sides[2] + sides[0] - sides[1], sides[0] + sides[1] - sides[2]};
}

template <class Number>
Tri fits_in(SidesIn<Number> sides, const Number& most) {
  Tri short_enough = Tri::yes;
  for (const Number& side : sides) short_enough = both(short_enough, !certainly_less(most, side));
  if (short_enough == Tri::no) return Tri::no;
  // With sides that fit, a triangle that is not acute does.
  const std::array<Number, 3> excess = excesses(sides);
  Tri acute = Tri::yes;
  for (const Number& x : excess) acute = both(acute, certainly_positive(x));
  if (acute == Tri::no) return short_enough;
  // 4abc ≤ sinh²(r) K with K = 4ab − (a + b − c)²; K > 0 follows, as abc > 0 for an acute triangle.
  const Number four_ab = 4 * (sides[0] * sides[1]);
  const Number k = four_ab - sqr(excess[2]);
  const Tri larger = certainly_less(k * most, four_ab * sides[2]);
  if (certainly_positive(k) == Tri::yes && larger == Tri::no) return Tri::yes;
  return acute == Tri::yes && larger == Tri::yes ? Tri::no : Tri::unknown;
}

template <class Number>
MeasuresIn<Number> measures_in(SidesIn<Number> sides) {
  MeasuresIn<Number> result;
  result.cotangent = excesses(sides);
  const Number four_ab = 4 * (sides[0] * sides[1]);
  result.k = four_ab - sqr(result.cotangent[2]);
  const Number root = sqrt(result.k);
  for (Number& cotangent : result.cotangent) cotangent = cotangent / root;
  // tan(A/2) = √(K + 4abc)/(2 + a + b + c).
  result.area = 2 * atan(sqrt(four_ab * sides[2] + result.k) / (2 + (sides[0] + sides[1] + sides[2])));
  return result;
}

template <class Number>
Tri all_counterclockwise_in(std::span<const Number> areas) {
  // The area of the surface is 2π(2g − 2) = π(F − 2).
  Number excess = -(static_cast<int>(areas.size() - 2) * half_turn<Number>());
  for (const Number& area : areas) excess = excess + area;
  Tri result = Tri::yes;
  for (const Number& area : areas) result = both(result, certainly_less(excess, area));
  return result;
}

template <class Number>
Tri is_delaunay_and_wide_in(std::span<const std::uint32_t> opposite, std::span<const Number> h, const Number& least) {
  std::vector<Number> areas, cotangent;
  Tri result = Tri::yes;
  Tri wide = Tri::no;
  for (std::size_t t = 0; t < h.size() / 3; ++t) {
    MeasuresIn<Number> triangle = measures_in(sides_of(h, t));
    result = both(result, certainly_positive(triangle.k));
    wide = either(wide, is_wide(sides_of(h, t), triangle.k, least));
    areas.push_back(std::move(triangle.area));
    for (Number& side : triangle.cotangent) cotangent.push_back(std::move(side));
  }
  for (std::size_t d = 0; d < h.size(); ++d) {
    result = both(result, certainly_positive(cotangent[d] + cotangent[opposite[d]]));
  }
  return both(both(result, wide), all_counterclockwise_in<Number>(areas));
}

}  // namespace

Tri fits(Sides sides, const Ball& most) { return fits_in(sides, most); }
Tri fits(SidesIn<Interval> sides, const Interval& most) { return fits_in(sides, most); }

TriangleMeasures measures(Sides sides) { return measures_in(sides); }
MeasuresIn<Interval> measures(SidesIn<Interval> sides) { return measures_in(sides); }

Tri all_counterclockwise(std::span<const Ball> areas) { return all_counterclockwise_in(areas); }
Tri all_counterclockwise(std::span<const Interval> areas) { return all_counterclockwise_in(areas); }

Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Ball> h, const Ball& least) {
  return is_delaunay_and_wide_in(opposite, h, least);
}
Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Interval> h, const Interval& least) {
  return is_delaunay_and_wide_in(opposite, h, least);
}

}  // namespace epsnet::certify
