#include "certify/claims/isometries/frames.h"

#include <algorithm>
#include <array>

#include "certify/net/numbering.h"

namespace epsnet::certify {
namespace {

/// Where two lines cross, of which the rows are given.
struct LinePoint {
  BallVector vector;
  int sign;  ///< Of the factor from the product of the rows to the vector.
};

/// Nullopt if it is not certain that they cross.
std::optional<LinePoint> line_point(const BallVector& row, const BallVector& other, slong precision) {
  BallVector product = cross_product(row, other, precision);
  const Ball scale = rsqrt(-lorentz_product(product, product, precision));
  const int sign = certain_sign(product[2]);
  if (sign == 0 || !is_finite(scale)) return std::nullopt;
  for (Ball& x : product) x = sign * (x * scale);
  return LinePoint{std::move(product), sign};
}

/// A part of a closed geodesic in a triangle.
struct Chord {
  std::uint32_t triangle;
  std::uint32_t geodesic;
  const BallVector* axis;
  Ball along;      ///< From the beginning of the period to where the triangle is entered.
  BallVector row;  ///< Of which the value at a point of the axis is sinh of the distance from there.
};

class Finder {
 public:
  Finder(const MovedNet& net, std::span<const AxisCrossings> geodesics)
      : net_(net), precision_(net.plane().precision()), points_(geodesics.size()) {
    for (std::uint32_t i = 0; i < geodesics.size() && known_; ++i) add_chords(i, geodesics[i]);
  }

  std::optional<std::vector<std::vector<CrossingPoint>>> run() {
    std::stable_sort(chords_.begin(), chords_.end(),
                     [](const Chord& x, const Chord& y) { return x.triangle < y.triangle; });
    for (auto y = chords_.begin(); y != chords_.end() && known_; ++y) {
      for (auto x = y; x != chords_.begin() && std::prev(x)->triangle == y->triangle && known_;) meet(*--x, *y);
    }
    if (!known_) return std::nullopt;
    return std::move(points_);
  }

 private:
  [[nodiscard]] BallVector edge(std::uint32_t dart) const {
    return cross_product(net_.corner(dart), net_.corner(next_dart(dart)), precision_);
  }

  [[nodiscard]] Ball value(const BallVector& row, const BallVector& point) const {
    Ball result;
    dot(result, row, point, precision_);
    return result;
  }

  void add_chords(std::uint32_t geodesic, const AxisCrossings& crossings) {
    const auto& [darts, axes] = crossings;
    net_.plane().spend(80, darts.size());
    net_.plane().keep(4, darts.size());
    Ball along;
    for (std::size_t k = 0; k < darts.size(); ++k) {
      const std::uint32_t entry = opposite(net_.plane().net(), darts[k == 0 ? darts.size() - 1 : k - 1]);
      const auto start = line_point(axes[k], edge(entry), precision_);
      const auto end = line_point(axes[k], edge(darts[k]), precision_);
      if (!start || !end) {
        known_ = false;
        return;
      }
      const BallVector normal{axes[k][0], axes[k][1], -axes[k][2]};
      BallVector row = cross_product(normal, start->vector, precision_);
      const Ball length = asinh(value(row, end->vector));
      chords_.push_back({darts[k] / 3, geodesic, &axes[k], along, std::move(row)});
      along += length;
    }
  }

  /// Two chords of one triangle.
  void meet(const Chord& x, const Chord& y) {
    net_.plane().spend(60);
    const Ball product = lorentz_product(*x.axis, *y.axis, precision_);
    const Tri cross = certainly_less(abs(product), Ball::exactly(1));
    if (cross == Tri::no) return;
    const auto point = cross == Tri::yes ? line_point(*x.axis, *y.axis, precision_) : std::nullopt;
    if (!point) {
      known_ = false;
      return;
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      const int side = certain_sign(value(edge(3 * x.triangle + i), point->vector));
      if (side < 0) return;
      if (side == 0) known_ = false;
    }
    const Ball cosine = point->sign * product;
    net_.plane().keep(4);
    points_[x.geodesic].push_back({x.along + asinh(value(x.row, point->vector)), cosine, y.geodesic});
    points_[y.geodesic].push_back({y.along + asinh(value(y.row, point->vector)), -cosine, x.geodesic});
  }

  const MovedNet& net_;
  slong precision_;
  bool known_ = true;
  std::vector<Chord> chords_;
  std::vector<std::vector<CrossingPoint>> points_;
};

bool may_be_equal(const Ball& x, const Ball& y) { return arb_overlaps(x.get(), y.get()) != 0; }

bool may_be_integer(const Ball& x) { return !is_finite(x) || arb_contains_int(x.get()) != 0; }

/// A frame of the plane at a point of a closed geodesic: its direction, or the other one, and an orientation.
struct Frame {
  std::size_t geodesic;
  std::size_t point;
  int direction;
  int orientation;
};

/// Operations of balls for a look at two crossing points, and for their distances.
constexpr std::uint64_t kAlikeOperations = 10;
constexpr std::uint64_t kDistanceOperations = 36;

class Comparison {
 public:
  Comparison(const LiftedPlane& plane, const CrossingGeodesics& geodesics, const Frame& from, const Frame& to)
      : plane_(plane), geodesics_(geodesics), from_(from), to_(to) {}

  /// Whether an isometry may take one frame to the other: it takes crossing points to such points.
  [[nodiscard]] bool possible() const {
    const auto& here = points(from_);
    const auto& there = points(to_);
    if (!alike(here[from_.point], there[to_.point])) return false;
    return std::all_of(here.begin(), here.end(), [&](const CrossingPoint& x) {
      plane_.spend(kAlikeOperations, there.size());
      return std::any_of(there.begin(), there.end(),
                         [&](const CrossingPoint& y) { return alike(x, y) && as_far(x, y); });
    });
  }

 private:
  [[nodiscard]] const std::vector<CrossingPoint>& points(const Frame& frame) const {
    return geodesics_.points[frame.geodesic];
  }

  [[nodiscard]] bool alike(const CrossingPoint& x, const CrossingPoint& y) const {
    return may_be_equal(geodesics_.lengths[x.other], geodesics_.lengths[y.other]) &&
           may_be_equal(x.cosine, to_.orientation * y.cosine);
  }

  /// Whether two points may be equally far from the frames, modulo the length of the geodesic.
  [[nodiscard]] bool as_far(const CrossingPoint& x, const CrossingPoint& y) const {
    plane_.spend(kDistanceOperations);
    const Ball here = x.along - points(from_)[from_.point].along;
    const Ball there = to_.direction * (y.along - points(to_)[to_.point].along);
    return may_be_integer((here - there) / geodesics_.lengths[from_.geodesic]);
  }

  const LiftedPlane& plane_;
  const CrossingGeodesics& geodesics_;
  const Frame& from_;
  const Frame& to_;
};

/// Whether an isometry may take one closed geodesic of the list to another: it takes crossing points to such points.
bool may_correspond(const CrossingGeodesics& geodesics, std::size_t one, std::size_t other) {
  return geodesics.points[one].size() == geodesics.points[other].size() &&
         may_be_equal(geodesics.lengths[one], geodesics.lengths[other]);
}

}  // namespace

std::optional<std::vector<std::vector<CrossingPoint>>> crossing_points(const MovedNet& net,
                                                                       std::span<const AxisCrossings> geodesics) {
  return Finder(net, geodesics).run();
}

std::uint64_t possible_frames(const LiftedPlane& plane, const CrossingGeodesics& geodesics, std::size_t geodesic,
                              std::size_t point) {
  const Frame from{geodesic, point, 1, 1};
  const std::size_t size = geodesics.points[geodesic].size();
  std::uint64_t result = 0;
  plane.spend(1, geodesics.points.size());
  for (std::size_t i = 0; i < geodesics.points.size(); ++i) {
    if (!may_correspond(geodesics, geodesic, i)) continue;
    for (std::size_t k = 0; k < size; ++k) {
      plane.spend(4 * kAlikeOperations);
      for (const auto& [direction, orientation] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        const Frame to{i, k, direction, orientation};
        if (Comparison(plane, geodesics, from, to).possible()) ++result;
      }
    }
  }
  return result;
}

double most_frames_work(const LiftedPlane& plane, const CrossingGeodesics& geodesics, std::size_t geodesic) {
  double like = 0;
  for (std::size_t i = 0; i < geodesics.points.size(); ++i) like += may_correspond(geodesics, geodesic, i) ? 1 : 0;
  const auto size = static_cast<double>(geodesics.points[geodesic].size());
  const double pairs = size * size * (kAlikeOperations + kDistanceOperations);
  return 4 * like * size * (pairs + kAlikeOperations) *
         static_cast<double>(ball_work(static_cast<std::uint64_t>(plane.precision())));
}

}  // namespace epsnet::certify
