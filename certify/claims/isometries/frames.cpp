#include "certify/claims/isometries/frames.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "certify/claims/geodesics/fields.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/numbering.h"
#include "certify/numbers/parallel.h"

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
  std::uint32_t number;  ///< Of those of the geodesic.
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
      chords_.push_back({darts[k] / 3, geodesic, static_cast<std::uint32_t>(k), &axes[k], along, std::move(row)});
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
    const auto x_place = static_cast<std::uint32_t>(points_[x.geodesic].size());
    const auto y_place = static_cast<std::uint32_t>(points_[y.geodesic].size()) + (x.geodesic == y.geodesic ? 1 : 0);
    points_[x.geodesic].push_back(
        {x.along + asinh(value(x.row, point->vector)), cosine, y.geodesic, y_place, x.number, point->sign});
    points_[y.geodesic].push_back(
        {y.along + asinh(value(y.row, point->vector)), -cosine, x.geodesic, x_place, y.number, -point->sign});
  }

  const MovedNet& net_;
  slong precision_;
  bool known_ = true;
  std::vector<Chord> chords_;
  std::vector<std::vector<CrossingPoint>> points_;
};

bool may_be_equal(const Ball& x, const Ball& y) { return arb_overlaps(x.get(), y.get()) != 0; }

bool may_be_integer(const Ball& x) { return !is_finite(x) || arb_contains_int(x.get()) != 0; }

/// A crossing point of a closed geodesic: with its direction and the orientation 1, a frame of the plane.
struct Passage {
  std::size_t geodesic;
  std::size_t point;
};

/// Any frame at one: the geodesic's direction, or the other one, and an orientation.
struct Frame : Passage {
  int direction;
  int orientation;
};

/// Operations of balls for a look at two crossing points, and for their distances; for a point in an index, and a look
/// into one.
constexpr std::uint64_t kAlikeOperations = 10;
constexpr std::uint64_t kDistanceOperations = 36;
constexpr std::uint64_t kIndexOperations = 20;

/// The crossing points of each geodesic by their angles: of many points only some have the angle of a given one.
/// Those of a geodesic are sorted when they are first asked for.
class PointsByAngle {
 public:
  PointsByAngle(const LiftedPlane& plane, const CrossingGeodesics& geodesics)
      : plane_(plane), geodesics_(geodesics), indexes_(geodesics.points.size()) {}

  /// The numbers of all points of a geodesic at which the cosine may be that of `x` times 1 or −1, and perhaps of
  /// others, in order.
  [[nodiscard]] std::vector<std::uint32_t> near(std::size_t geodesic, const CrossingPoint& x, int orientation) {
    plane_.spend(kIndexOperations);
    if (!indexes_[geodesic]) add(geodesic);
    return indexes_[geodesic]->near(outer_interval(orientation * x.cosine));
  }

 private:
  void add(std::size_t geodesic) {
    const auto& points = geodesics_.points[geodesic];
    plane_.spend(kIndexOperations, points.size());
    plane_.keep(1, points.size());
    IntervalIndex& index = indexes_[geodesic].emplace();
    for (std::uint32_t k = 0; k < points.size(); ++k) index.insert(outer_interval(points[k].cosine), k);
  }

  const LiftedPlane& plane_;
  const CrossingGeodesics& geodesics_;
  std::vector<std::optional<IntervalIndex>> indexes_;
};

class Comparison {
 public:
  /// All must live longer.
  Comparison(const LiftedPlane& plane, const CrossingGeodesics& geodesics, PointsByAngle& by_angle, const Passage& from,
             const Frame& to)
      : plane_(plane), geodesics_(geodesics), by_angle_(by_angle), from_(from), to_(to) {}

  /// Whether an isometry may take one frame to the other: it takes crossing points to such points.
  [[nodiscard]] bool possible() const {
    const auto& here = points(from_);
    const auto& there = points(to_);
    if (!alike(here[from_.point], there[to_.point])) return false;
    return std::all_of(here.begin(), here.end(), [&](const CrossingPoint& x) {
      const std::vector<std::uint32_t> near = points_near(x);
      return std::any_of(near.begin(), near.end(), [&](std::uint32_t k) { return may_be_image(x, there[k]); });
    });
  }

  /// The points to which an isometry that takes one frame to the other may take a point.
  [[nodiscard]] std::vector<const CrossingPoint*> images(const CrossingPoint& x) const {
    const auto& there = points(to_);
    std::vector<const CrossingPoint*> result;
    for (const std::uint32_t k : points_near(x)) {
      if (may_be_image(x, there[k])) result.push_back(&there[k]);
    }
    return result;
  }

  /// Whether two points may be equally far from the frames, modulo the length of the geodesic.
  [[nodiscard]] bool as_far(const CrossingPoint& x, const CrossingPoint& y) const {
    plane_.spend(kDistanceOperations);
    const Ball here = x.along - points(from_)[from_.point].along;
    const Ball there = to_.direction * (y.along - points(to_)[to_.point].along);
    return may_be_integer((here - there) / geodesics_.lengths[from_.geodesic]);
  }

 private:
  /// The points along the other geodesic that may have the angle of a point.
  [[nodiscard]] std::vector<std::uint32_t> points_near(const CrossingPoint& x) const {
    std::vector<std::uint32_t> result = by_angle_.near(to_.geodesic, x, to_.orientation);
    plane_.spend(kAlikeOperations, result.size());
    return result;
  }

  [[nodiscard]] bool may_be_image(const CrossingPoint& x, const CrossingPoint& y) const {
    return alike(x, y) && as_far(x, y);
  }

  [[nodiscard]] const std::vector<CrossingPoint>& points(const Passage& passage) const {
    return geodesics_.points[passage.geodesic];
  }

  [[nodiscard]] bool alike(const CrossingPoint& x, const CrossingPoint& y) const {
    return may_be_equal(geodesics_.lengths[x.other], geodesics_.lengths[y.other]) &&
           may_be_equal(x.cosine, to_.orientation * y.cosine);
  }

  const LiftedPlane& plane_;
  const CrossingGeodesics& geodesics_;
  PointsByAngle& by_angle_;
  const Passage& from_;
  const Frame& to_;
};

/// Whether an isometry may take one closed geodesic of the list to another: it takes crossing points to such points.
bool may_correspond(const CrossingGeodesics& geodesics, std::size_t one, std::size_t other) {
  return geodesics.points[one].size() == geodesics.points[other].size() &&
         may_be_equal(geodesics.lengths[one], geodesics.lengths[other]);
}

/// The frames, of geodesics from `first_target` on, to which an isometry may take the frame of a geodesic at one of its
/// points.
std::vector<Frame> images_of_frame(const LiftedPlane& plane, const CrossingGeodesics& geodesics,
                                   PointsByAngle& by_angle, const Passage& from, std::size_t first_target = 0) {
  const std::size_t size = geodesics.points[from.geodesic].size();
  std::vector<Frame> result;
  plane.spend(1, geodesics.points.size());
  for (std::size_t i = first_target; i < geodesics.points.size(); ++i) {
    if (!may_correspond(geodesics, from.geodesic, i)) continue;
    for (std::size_t k = 0; k < size; ++k) {
      plane.spend(4 * kAlikeOperations);
      for (const auto& [direction, orientation] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        const Frame to{{i, k}, direction, orientation};
        if (Comparison(plane, geodesics, by_angle, from, to).possible()) result.push_back(to);
      }
    }
  }
  return result;
}

/// An isometry that takes one frame to another, followed along the geodesics that cross that of the frame, those that
/// cross them, and so on.
class FollowedIsometry {
 public:
  /// `plane` and `geodesics` must live longer.
  FollowedIsometry(const LiftedPlane& plane, const CrossingGeodesics& geodesics, const Passage& from, const Frame& to)
      : plane_(plane), geodesics_(geodesics) {
    take(from, to);
  }

  /// Whether a geodesic is left that has not been compared with its image.
  [[nodiscard]] bool goes_on() const { return compared_ < frames_.size(); }

  /// Compares one more geodesic with its image, and returns whether there still may be such an isometry.
  [[nodiscard]] bool step(PointsByAngle& by_angle) {
    const auto [from, to] = frames_[compared_++];
    if (!may_correspond(geodesics_, from.geodesic, to.geodesic)) return false;
    const Comparison comparison(plane_, geodesics_, by_angle, from, to);
    for (const CrossingPoint& x : geodesics_.points[from.geodesic]) {
      const auto images = comparison.images(x);
      if (images.empty()) return false;
      // Of several ones it is not known which one is the image.
      if (images.size() == 1 && !take_other(by_angle, x, *images.front(), to)) return false;
    }
    return true;
  }

 private:
  struct FramePair {
    Passage from;
    Frame to;
  };

  void take(const Passage& from, const Frame& to) {
    plane_.keep(3);
    pair_of_.emplace(from.geodesic, frames_.size());
    frames_.push_back({from, to});
  }

  /// Takes the geodesic that crosses at x to the one that crosses at y, and returns whether that may be.
  [[nodiscard]] bool take_other(PointsByAngle& by_angle, const CrossingPoint& x, const CrossingPoint& y,
                                const Frame& to) {
    const int direction = to.orientation * to.direction * x.turn * y.turn;
    const Passage other{x.other, x.place};
    const Frame image{{y.other, y.place}, direction, to.orientation};
    const auto known = pair_of_.find(other.geodesic);
    if (known == pair_of_.end()) {
      take(other, image);
      return true;
    }
    const auto& [from, taken_to] = frames_[known->second];
    if (taken_to.geodesic != image.geodesic || taken_to.direction != image.direction) return false;
    return Comparison(plane_, geodesics_, by_angle, from, taken_to)
        .as_far(geodesics_.points[other.geodesic][other.point], geodesics_.points[image.geodesic][image.point]);
  }

  const LiftedPlane& plane_;
  const CrossingGeodesics& geodesics_;
  std::vector<FramePair> frames_;
  std::map<std::size_t, std::size_t> pair_of_;  ///< By geodesic that is taken to another one.
  std::size_t compared_ = 0;
};

}  // namespace

GeodesicsInNet::GeodesicsInNet(const GeodesicsDocument& document, const LabelParts& parts)
    : document_(document),
      parts_(parts),
      net_(with_geodesics_as_labels(document)),
      evaluator_(net_, parts),
      first_darts_(first_darts(net_)) {}

LiftedPlane GeodesicsInNet::plane(slong precision, slong cap, unsigned threads) const {
  return {net_, evaluator_, parts_, precision, cap, threads};
}

std::optional<CrossingGeodesics> GeodesicsInNet::crossings(const LiftedPlane& plane, unsigned threads) const {
  const MovedNet net(plane);
  if (!net.valid()) return std::nullopt;
  const std::size_t count = document_.geodesics.size();
  CrossingGeodesics result;
  result.lengths.resize(count);
  std::vector<AxisCrossings> periods(count);
  for_each_parallel(count, threads, [&](unsigned, std::size_t i) {
    BallIsometry element = inverse(plane.label(static_cast<std::uint32_t>(document_.net.labels.size() + 1 + i)));
    choose_sign(element);
    result.lengths[i] = twice(acosh(cosh_half_length(element)));
    auto crossings = axis_crossings(net, first_darts_[document_.geodesics[i].vertex], element);
    if (crossings) periods[i] = *std::move(crossings);
  });
  if (std::any_of(periods.begin(), periods.end(), [](const auto& period) { return period.darts.empty(); })) {
    return std::nullopt;
  }
  auto points = crossing_points(net, periods);
  if (!points) return std::nullopt;
  result.points = *std::move(points);
  return result;
}

std::optional<std::vector<std::vector<CrossingPoint>>> crossing_points(const MovedNet& net,
                                                                       std::span<const AxisCrossings> geodesics) {
  return Finder(net, geodesics).run();
}

std::uint64_t possible_frames(const LiftedPlane& plane, const CrossingGeodesics& geodesics, std::size_t geodesic,
                              std::size_t point) {
  PointsByAngle by_angle(plane, geodesics);
  return images_of_frame(plane, geodesics, by_angle, {geodesic, point}).size();
}

namespace {

/// The frames, of geodesics from `first_target` on, to which an isometry may take one, followed until no more than
/// `enough` are left.
std::uint64_t followed_from(const LiftedPlane& plane, const CrossingGeodesics& geodesics, const Passage& from,
                            std::uint64_t enough, std::size_t first_target = 0) {
  PointsByAngle by_angle(plane, geodesics);
  std::vector<FollowedIsometry> left;
  for (const Frame& to : images_of_frame(plane, geodesics, by_angle, from, first_target))
    left.emplace_back(plane, geodesics, from, to);
  // Step by step with all: most of those that are no isometries end early.
  for (bool goes_on = true; goes_on && left.size() > enough;) {
    goes_on = false;
    std::vector<FollowedIsometry> next;
    for (FollowedIsometry& isometry : left) {
      if (isometry.goes_on()) {
        if (!isometry.step(by_angle)) continue;
        goes_on = true;
      }
      next.push_back(std::move(isometry));
    }
    left = std::move(next);
  }
  return left.size();
}

/// Of each set of geodesics that crossings join, the first one of those with the fewest crossing points.
std::vector<std::size_t> representatives(const LiftedPlane& plane, const CrossingGeodesics& geodesics) {
  std::vector<std::size_t> result;
  std::vector<bool> seen(geodesics.points.size());
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first] || geodesics.points[first].empty()) continue;
    std::vector<std::size_t> joined{first};
    seen[first] = true;
    std::size_t best = first;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      const auto& points = geodesics.points[joined[i]];
      if (points.size() < geodesics.points[best].size()) best = joined[i];
      plane.spend(1, points.size());
      for (const CrossingPoint& x : points) {
        if (seen[x.other]) continue;
        seen[x.other] = true;
        joined.push_back(x.other);
      }
    }
    result.push_back(best);
  }
  return result;
}

}  // namespace

std::uint64_t followed_frames(const LiftedPlane& plane, const CrossingGeodesics& geodesics, std::uint64_t enough) {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const std::size_t geodesic : representatives(plane, geodesics)) {
    least = std::min(least, followed_from(plane, geodesics, {geodesic, 0}, enough));
    if (least <= enough) break;
  }
  return least;
}

namespace {

/// Whether, for one crossing point of a surface, no frame of another one is left.
bool leaves_no_frame(const LiftedPlane& plane, const CrossingGeodesics& a, const CrossingGeodesics& b) {
  // As one list: frames of the first surface are compared with those of the other one alone.
  const std::size_t size = a.points.size();
  CrossingGeodesics both = a;
  both.lengths.insert(both.lengths.end(), b.lengths.begin(), b.lengths.end());
  for (std::vector<CrossingPoint> points : b.points) {
    for (CrossingPoint& x : points) x.other += static_cast<std::uint32_t>(size);
    both.points.push_back(std::move(points));
  }
  const auto starts = representatives(plane, a);
  return std::any_of(starts.begin(), starts.end(), [&](std::size_t geodesic) {
    return followed_from(plane, both, {geodesic, 0}, 0, size) == 0;
  });
}

}  // namespace

bool no_isometry(const LiftedPlane& plane, const CrossingGeodesics& first, const CrossingGeodesics& other) {
  return leaves_no_frame(plane, first, other) || leaves_no_frame(plane, other, first);
}

}  // namespace epsnet::certify
