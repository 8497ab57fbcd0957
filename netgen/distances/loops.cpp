#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kernel/lorentz.h"
#include "kernel/plane.h"
#include "netgen/distances/distances.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/error.h"

/// Loops at a point, points along geodesics, fixed points of isometries: what elements of the group do with points.
namespace epsnet {
namespace {

using Point = Complex<Mp1024>;
using Move = Isometry<Mp1024>;

constexpr std::size_t kMostElements = 200'000;

/// An element of the group, in the frame of a Dirichlet domain.
struct Element {
  Move move;
  std::vector<std::uint32_t> sides;  ///< The element is the product of their pairings.
  double length;                     ///< How far it moves the base point.
};

/// Where an element takes the base point, to 2^-30: no two elements take it to points so near to each other.
using ImageKey = std::array<double, 2>;

ImageKey key_of(const Move& move) {
  // Coordinates of the hyperboloid, which the plane stretches everywhere. The constant keeps 0 away from a jump.
  const LorentzVector<Mp1024> image = on_hyperboloid(move(Point{}));
  const auto cell = [](const Mp1024& x) { return std::floor(std::ldexp(x.convert_to<double>(), 30) + 0.37); };
  return {cell(image.x), cell(image.y)};
}

/// The elements that move the base point by at most `up_to`, the identity first. They are connected by side pairings: a
/// geodesic from the base point to its image passes through images of the domain whose base points are nearer.
std::vector<Element> elements_up_to(const DomainFrame& frame, double up_to) {
  const double limit = up_to + 1e-9;  // Ways through corners of domains.
  std::vector<Element> elements{{Move{}, {}, 0}};
  std::set<ImageKey> found{key_of(Move{})};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::uint32_t side = 0; side < frame.pairings().size(); ++side) {
      Element next{normalized(elements[i].move * frame.pairings()[side]), {}, 0};
      next.length = distance(Point{}, next.move(Point{})).convert_to<double>();
      if (next.length > limit || !found.insert(key_of(next.move)).second) continue;
      if (elements.size() == kMostElements) {
        throw LimitError("more than " + std::to_string(kMostElements) + " elements of the group move the point by " +
                         std::to_string(up_to) + " or less");
      }
      next.sides = elements[i].sides;
      next.sides.push_back(side);
      elements.push_back(std::move(next));
    }
  }
  return elements;
}

/// The path of a product of side pairings: that of the last factor comes first.
Word word_of(const DirichletPolygon& polygon, const std::vector<std::uint32_t>& sides) {
  Word word;
  for (auto side = sides.rbegin(); side != sides.rend(); ++side) {
    const Word& part = polygon.sides[*side].word;
    word.insert(word.end(), part.begin(), part.end());
  }
  return word;
}

/// The image of a point in the domain, and the element that takes it there, after `move`.
void reduce(const DomainFrame& frame, Move& move, Point& z) {
  constexpr int kMostSteps = 10'000;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto side = frame.side_towards(z);
    if (!side) return;
    const Move back = inverse(frame.pairings()[*side]);
    const Point next = back(z);
    if (!(norm(next) < norm(z))) return;  // On the boundary, up to rounding.
    z = next;
    move = normalized(back * move);
  }
  throw LimitError("a point is too far from the Dirichlet domain");
}

/// The square root of a complex number of modulus 1, up to the sign.
Point root_of_unit(const Point& u) {
  const Point sum = Point{Mp1024(1), Mp1024(0)} + u;
  const Mp1024 size = sqrt(norm(sum));
  if (size < Mp1024(1e-100)) return {Mp1024(0), Mp1024(1)};
  return Mp1024(1 / size) * sum;
}

/// The isometry that takes three points of the unit circle to three others in the same cyclic order.
Move from_circle_points(const std::array<Point, 3>& from, const std::array<Point, 3>& to) {
  // As matrices (p q; r s): z -> (z - z0)(z1 - z2)/((z - z2)(z1 - z0)), the second one inverted.
  const auto matrix = [](const std::array<Point, 3>& z) {
    const Point u = z[1] - z[2];
    const Point v = z[1] - z[0];
    return std::array<Point, 4>{u, -(u * z[0]), v, -(v * z[2])};
  };
  const auto m = matrix(from);
  const auto n = matrix(to);
  const Point p = n[3] * m[0] - n[1] * m[2];
  const Point q = n[3] * m[1] - n[1] * m[3];
  const Point s = n[0] * m[3] - n[2] * m[1];
  const Point c = q / p;
  Point turn = p / s;
  turn = Mp1024(1 / sqrt(norm(turn))) * turn;
  const Point a = root_of_unit(turn);
  return normalized(Move{a, a * c});
}

/// A lift of the isometry f with fwf^-1 = image for all words: elements have the ends of their axes on the circle.
Move lift_of(const Surface& surface, const std::vector<Word>& words, const std::vector<Word>& images) {
  std::array<Point, 3> from;
  std::array<Point, 3> to;
  std::size_t known = 0;
  for (std::size_t i = 0; i < words.size() && known < 3; ++i) {
    const auto before = axis(isometry_of(surface, words[i]));
    const auto after = axis(isometry_of(surface, images[i]));
    if (!before || !after) throw LimitError("the generators are too large to follow the isometry");
    const auto is_end = [&](const Point& z) { return norm(before->to - z) < Mp1024(1e-60); };
    if (known == 2 && (is_end(from[0]) || is_end(from[1]))) continue;  // The same axis: the group is discrete.
    if (known == 0) {
      from = {before->from, before->to, {}};
      to = {after->from, after->to, {}};
      known = 2;
    } else {
      from[2] = before->to;
      to[2] = after->to;
      known = 3;
    }
  }
  if (known < 3) throw LimitError("the generators have one axis");
  return from_circle_points(from, to);
}

/// The point that an isometry fixes, if it turns the plane around one.
std::optional<Point> centre_of(const Move& f) {
  const Mp1024 square = 1 - f.a.x * f.a.x;
  if (!(square > Mp1024(1e-60))) return std::nullopt;
  const Mp1024 root = sqrt(square);
  const Mp1024 below = f.a.y < 0 ? Mp1024(f.a.y - root) : Mp1024(f.a.y + root);
  return Point{Mp1024(-f.b.y / below), Mp1024(f.b.x / below)};
}

}  // namespace

std::vector<PointLoop> loops_at(const Surface& surface, const BasePoint& point, double up_to) {
  require_inside(surface, point);
  const DirichletPolygon polygon = dirichlet_polygon(surface, point);
  const DomainFrame frame(surface, polygon);
  std::vector<PointLoop> loops;
  for (const Element& element : elements_up_to(frame, up_to)) {
    if (element.sides.empty() || element.length > up_to) continue;
    // A loop and the same backwards are one.
    if (key_of(inverse(element.move)) < key_of(element.move)) continue;
    loops.push_back({word_of(polygon, element.sides), element.length});
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const PointLoop& a, const PointLoop& b) { return a.length < b.length; });
  return loops;
}

BasePoint point_along(const Surface& surface, const BasePoint& from, double direction, double length) {
  const Mp1024 angle(direction);
  const Mp1024 radius = tanh(Mp1024(length) / 2);
  const Point z{Mp1024(radius * cos(angle)), Mp1024(radius * sin(angle))};
  return rounded_point(surface, from.tile, Move::translation(convert<Mp1024>(from.z))(z));
}

std::vector<BasePoint> fixed_points(const Surface& surface, const std::vector<Word>& words,
                                    const std::vector<Word>& images) {
  const DirichletPolygon polygon = dirichlet_polygon(surface, centre_of_tile(surface, TileId(0)));
  const DomainFrame frame(surface, polygon);
  Move lift = normalized(frame.from_tile() * lift_of(surface, words, images) * inverse(frame.from_tile()));
  Point image = lift(Point{});
  reduce(frame, lift, image);
  Mp1024 radius(0);
  for (const Point& vertex : frame.vertices()) radius = std::max(radius, distance(Point{}, vertex));
  // A fixed point in the domain is at most `radius` from the base point and from its image.
  const double most = 2 * radius.convert_to<double>() + distance(Point{}, image).convert_to<double>();
  const std::vector<Element> elements = elements_up_to(frame, most);
  std::vector<Isometry<double>> rounded;
  for (const Element& element : elements) {
    if (element.length <= 2 * radius + 1e-6) rounded.push_back(convert<double>(element.move));
  }
  std::vector<Point> found;
  for (const Element& element : elements) {
    const auto centre = centre_of(normalized(element.move * lift));
    if (!centre || distance(Point{}, *centre) > radius + 1e-6 || frame.side_towards(Mp1024(1 - 1e-12) * *centre))
      continue;
    const auto z = convert<double>(*centre);
    const bool is_known = std::any_of(found.begin(), found.end(), [&](const Point& other) {
      const auto w = convert<double>(other);
      return std::any_of(rounded.begin(), rounded.end(),
                         [&](const Isometry<double>& g) { return distance(g(w), z) < 1e-5; });
    });
    if (!is_known) found.push_back(*centre);
  }
  std::vector<BasePoint> points;
  for (const Point& z : found) points.push_back(rounded_point(surface, frame.tile(), inverse(frame.from_tile())(z)));
  return points;
}

}  // namespace epsnet
