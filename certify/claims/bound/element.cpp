#include "certify/claims/bound/element.h"

#include <cmath>
#include <utility>

#include "certify/base/lookup.h"
#include "certify/lifted/lifted_plane.h"

namespace epsnet::certify {
namespace {

/// Operations of balls for one edge of a step of a path.
constexpr std::uint64_t kOperationsOfAStep = 4;

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

Elements::Elements(BallVector point, Ball shortest_loop, const std::vector<BallIsometry>& edges, slong precision,
                   Budget budget)
    : point_(std::move(point)),
      shortest_loop_(std::move(shortest_loop)),
      precision_(precision),
      budget_(std::move(budget)) {
  for (const BallIsometry& edge : edges) {
    for (const BallIsometry& step : {edge, inverse(edge)}) {
      const BallVector end = apply(lorentz_matrix(step, precision), point_, precision);
      steps_.push_back({step, end, nearly(end)});
    }
  }
}

bool Elements::are_equal(const BallIsometry& f, const BallIsometry& g) const {
  const BallIsometry quotient = compose(inverse(f), g, precision_);
  return certainly_less(displacement(element_of(quotient, precision_), point_, precision_), shortest_loop_) == Tri::yes;
}

BallIsometry Elements::enclosed_along_edges(BallIsometry g) const {
  const auto away = [&](const BallVector& p, const BallVector& q) {
    return fast_interval(-lorentz_product(p, q, precision_)).upper;
  };
  BallVector goal = apply(lorentz_matrix(g, precision_), point_, precision_);
  BallIsometry path = identity_isometry();
  double distance = away(point_, goal);
  constexpr int kMostSteps = 1000;
  for (int i = 0; i < kMostSteps; ++i) {
    budget_.spend(kOperationsOfAStep * ball_work(static_cast<std::uint64_t>(precision_)), steps_.size() + 1);
    const Step* nearest = nullptr;
    const std::array<double, 3> near_goal = nearly(goal);
    for (const Step& step : steps_) {
      if (is_farther(step.nearly, near_goal, distance)) continue;
      const double left = away(step.end, goal);
      if (!(left < distance)) continue;
      distance = left;
      nearest = &step;
    }
    if (nearest == nullptr) break;
    path = compose(path, nearest->isometry, precision_);
    goal = apply(lorentz_matrix(inverse(nearest->isometry), precision_), goal, precision_);
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
  elements_.push_back(element_of(is_precise ? std::move(g) : enclosed_along_edges(std::move(g)), precision_));
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

}  // namespace epsnet::certify
