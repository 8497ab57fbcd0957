#include "certify/claims/geodesics/axis_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "certify/net/numbering.h"

namespace epsnet::certify {

namespace {

/// The translation that takes 0 to x + iy.
BallIsometry translation_to(double x, double y) {
  const Ball re = Ball::exactly(x);
  const Ball im = Ball::exactly(y);
  const Ball scale = rsqrt(1 - sqr(re) - sqr(im));
  return {{scale, Ball()}, {re * scale, im * scale}};
}

}  // namespace

MovedNet::MovedNet(const LiftedPlane& plane) : plane_(plane) {
  const NetDocument& net = plane.net();
  const std::size_t darts = 3 * net.triangles.size();
  plane.spend(400, darts);
  plane.keep(8, darts);
  shortest_.assign(net.vertices.size(), std::numeric_limits<double>::infinity());
  const Precision scope(plane.precision());
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    const Ball value = half(-lorentz_product(plane.corner(dart), plane.corner(next_dart(dart)), plane.precision()) - 1);
    // With so few bits nothing would be known of the triangles.
    if (certainly_positive(value) != Tri::yes) return;
    const double length = std::sqrt(arf_get_d(arb_midref(value.get()), ARF_RND_NEAR));
    for (const std::uint32_t v : {start(net, dart), start(net, next_dart(dart))}) {
      shortest_[v] = std::min(shortest_[v], length);
    }
  }
  corners_.resize(darts);
  constexpr int kTries = 12;
  double share = 0.125;
  for (int tries = 0; tries < kTries && !valid_; ++tries, share /= 2) valid_ = place(share);
  if (valid_) measure();
}

/// Moves the vertices; false if not all triangles certainly are counterclockwise.
bool MovedNet::place(double share) {
  const NetDocument& net = plane_.net();
  std::mt19937 random;
  const auto moved_by = [&](double size) { return size * (std::ldexp(static_cast<double>(random()), -31) - 1); };
  // In the chart with the vertex at its origin, as next to other numbers small ones would be lost.
  std::vector<std::array<double, 2>> moves(net.vertices.size());
  for (std::uint32_t v = 0; v < moves.size(); ++v) {
    for (double& x : moves[v]) x = moved_by(share * shortest_[v]);
    if (!(std::hypot(moves[v][0], moves[v][1]) < 0.5)) return false;
  }
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const std::uint32_t v = start(net, dart);
    const BallIsometry from_origin = compose(plane_.label(corner_label(net, dart)),
                                             translation_to(net.vertices[v].x, net.vertices[v].y), plane_.precision());
    corners_[dart] = unit_vector(from_origin, moves[v][0], moves[v][1], plane_.precision());
    // Else it is no point of the plane.
    if (certainly_positive(corners_[dart][2]) != Tri::yes) return false;
  }
  Ball determinant;
  for (std::uint32_t dart = 0; dart < corners_.size(); dart += 3) {
    dot(determinant, cross_product(corners_[dart], corners_[dart + 1], plane_.precision()), corners_[dart + 2],
        plane_.precision());
    if (certainly_positive(determinant) != Tri::yes) return false;
  }
  return true;
}

void MovedNet::measure() {
  const slong precision = plane_.precision();
  beyond_.resize(corners_.size());
  cosh_.resize(corners_.size());
  const Precision scope(precision);
  Ball volume;
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const BallVector& right = corners_[dart];
    const BallVector& left = corners_[next_dart(dart)];
    const BallVector& apex = corners_[previous_dart(dart)];
    cosh_[dart] = outer_interval(-lorentz_product(left, right, precision));
    const std::uint32_t other = opposite(plane_.net(), dart);
    BallVector x = corners_[previous_dart(other)];
    if (const auto* transition = plane_.transition(other)) x = apply(transition->matrix, x, precision);
    // Cramer's rule.
    const std::array<BallVector, 3> lines = {cross_product(right, apex, precision),
                                             cross_product(apex, left, precision),
                                             cross_product(left, right, precision)};
    dot(volume, lines[0], left, precision);
    for (std::size_t i = 0; i < 3; ++i) {
      dot(beyond_[dart][i], lines[i], x, precision);
      beyond_[dart][i] = beyond_[dart][i] / volume;
    }
  }
}

DartOrder::DartOrder(const MovedNet& net, const std::vector<bool>& inner) : code_(inner.size()) {
  const NetDocument& document = net.plane().net();
  std::vector<std::uint32_t> edges;
  for (std::uint32_t dart = 0; dart < inner.size(); ++dart) {
    if (dart < opposite(document, dart)) edges.push_back(dart);
  }
  // Any order is right. Short edges first: fewer geodesics cross them, and later searches have fewer edges to cross.
  std::stable_sort(edges.begin(), edges.end(), [&](std::uint32_t x, std::uint32_t y) {
    return inner[x] != inner[y] ? inner[y] : net.cosh_length(x).lower < net.cosh_length(y).lower;
  });
  for (const std::uint32_t edge : edges) {
    starts_ += inner[edge] ? 0 : 1;
    for (const std::uint32_t dart : {edge, opposite(document, edge)}) {
      code_[dart] = static_cast<std::uint32_t>(darts_.size());
      darts_.push_back(dart);
    }
  }
}

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
    std::uint64_t known = 0;
    for (auto x = y; x != chords.begin() && std::prev(x)->triangle == y->triangle;) {
      --x;
      const bool same = x->geodesic == y->geodesic;
      Tri& of_x = same ? result[x->geodesic].itself : result[x->geodesic].another;
      Tri& of_y = same ? of_x : result[y->geodesic].another;
      if (of_x == Tri::yes && of_y == Tri::yes) {
        ++known;
        continue;
      }
      plane.spend(4);
      const Tri cross = certainly_less(abs(lorentz_product(*x->axis, *y->axis, plane.precision())), Ball::exactly(1));
      of_x = either(of_x, cross);
      of_y = either(of_y, cross);
    }
    plane.pass(known);
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

namespace {

/// Where a geodesic separates a corner of a triangle from the other two.
struct Arc {
  std::uint32_t geodesic;
  bool corner_is_left;
  Ball distance;  ///< sinh of that of the corner from the geodesic.
};

/// Sets of numbers that are joined.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t find(std::size_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void join(std::size_t x, std::size_t y) { parent_[std::max(find(x), find(y))] = std::min(find(x), find(y)); }

 private:
  std::vector<std::size_t> parent_;
};

class Cutter {
 public:
  Cutter(const MovedNet& net, const std::vector<AxisCrossings>& geodesics)
      : moved_(net), net_(net.plane().net()), geodesics_(geodesics), arcs_(3 * net_.triangles.size()) {}

  std::optional<std::vector<GeodesicsDocument::Piece>> run() {
    for (std::uint32_t i = 0; i < geodesics_.size(); ++i) add_arcs(i);
    // Arcs are disjoint: one that lies between another and the corner is nearer to it.
    for (std::vector<Arc>& arcs : arcs_) {
      if (!sort_certainly(arcs, [](const Arc& arc) -> const Ball& { return arc.distance; })) return std::nullopt;
    }
    number_cells();
    return pieces();
  }

 private:
  /// Between two darts that follow each other a geodesic cuts off the corner that they have in common.
  void add_arcs(std::uint32_t geodesic) {
    const auto& [darts, axes] = geodesics_[geodesic];
    moved_.plane().spend(10, darts.size());
    for (std::size_t k = 0; k < darts.size(); ++k) {
      const std::uint32_t entry = opposite(net_, darts[k == 0 ? darts.size() - 1 : k - 1]);
      // Darts are crossed with their starts on the right.
      const bool corner_is_left = darts[k] != next_dart(entry);
      const std::uint32_t corner = corner_is_left ? entry : darts[k];
      Ball distance;
      dot(distance, axes[k], moved_.corner(corner), moved_.plane().precision());
      arcs_[corner].push_back({geodesic, corner_is_left, abs(std::move(distance))});
    }
  }

  /// Cells of triangle t: the central one, then those around corner 0 outward from it, then corner 1, corner 2.
  void number_cells() {
    for (std::uint32_t t = 0; t < net_.triangles.size(); ++t) {
      central_.push_back(cells_++);
      for (std::uint32_t i = 0; i < 3; ++i) {
        around_.push_back(cells_);
        cells_ += arcs_[3 * t + i].size();
      }
    }
  }

  /// The cell that is number `k` from the corner where the dart starts.
  [[nodiscard]] std::size_t cell(std::uint32_t dart, std::size_t k) const {
    return k < arcs_[dart].size() ? around_[dart] + k : central_[dart / 3];
  }

  /// The cell at segment k of the dart's edge, counted from where it starts.
  [[nodiscard]] std::size_t cell_at(std::uint32_t dart, std::size_t k) const {
    const std::size_t here = arcs_[dart].size();
    return k <= here ? cell(dart, k) : cell(next_dart(dart), segments(dart) - 1 - k);
  }

  [[nodiscard]] std::size_t segments(std::uint32_t dart) const {
    return arcs_[dart].size() + arcs_[next_dart(dart)].size() + 1;
  }

  std::optional<std::vector<GeodesicsDocument::Piece>> pieces() {
    Partition partition(cells_);
    for (std::uint32_t dart = 0; dart < arcs_.size(); ++dart) {
      const std::uint32_t other = opposite(net_, dart);
      const std::size_t count = segments(dart);
      // Never, if all sides and orders are certain: then the arcs of two triangles fit across their edge.
      if (segments(other) != count) return std::nullopt;
      for (std::size_t k = 0; k < count; ++k) partition.join(cell_at(dart, k), cell_at(other, count - 1 - k));
    }
    // χ of each component: vertices − segments of edges + cells, all open.
    std::map<std::size_t, long> euler;
    for (std::size_t c = 0; c < cells_; ++c) ++euler[partition.find(c)];
    for (const std::uint32_t dart : first_darts(net_)) ++euler[partition.find(cell_at(dart, 0))];
    for (std::uint32_t dart = 0; dart < arcs_.size(); ++dart) {
      if (opposite(net_, dart) < dart) continue;
      for (std::size_t k = 0; k < segments(dart); ++k) --euler[partition.find(cell_at(dart, k))];
    }
    return components(partition, euler);
  }

  std::optional<std::vector<GeodesicsDocument::Piece>> components(Partition& partition,
                                                                  const std::map<std::size_t, long>& euler) const {
    std::map<std::size_t, GeodesicsDocument::Piece> by_root;
    for (const auto& [root, unused] : euler) by_root[root];
    std::vector<std::size_t> component(2 * geodesics_.size(), cells_);
    for (std::uint32_t dart = 0; dart < arcs_.size(); ++dart) {
      for (std::size_t k = 0; k < arcs_[dart].size(); ++k) {
        const Arc& arc = arcs_[dart][k];
        const std::size_t inner = partition.find(cell(dart, k));
        const std::size_t outer = partition.find(cell(dart, k + 1));
        for (const std::uint32_t side : {0U, 1U}) {
          const std::size_t found = arc.corner_is_left == (side == 0) ? inner : outer;
          std::size_t& known = component[2 * std::size_t{arc.geodesic} + side];
          if (known == cells_) by_root[found].boundaries.emplace_back(arc.geodesic, side);
          // Never, if all sides and orders are certain: a side of a geodesic is in one component.
          if (known != cells_ && known != found) return std::nullopt;
          known = found;
        }
      }
    }
    std::vector<GeodesicsDocument::Piece> result;
    for (auto& [root, piece] : by_root) {
      const long twice_genus = 2 - euler.at(root) - static_cast<long>(piece.boundaries.size());
      if (twice_genus < 0 || twice_genus % 2 != 0) return std::nullopt;
      piece.genus = static_cast<std::uint32_t>(twice_genus / 2);
      std::sort(piece.boundaries.begin(), piece.boundaries.end());
      result.push_back(std::move(piece));
    }
    return result;
  }

  const MovedNet& moved_;
  const NetDocument& net_;
  const std::vector<AxisCrossings>& geodesics_;
  std::vector<std::vector<Arc>> arcs_;  ///< By dart: those around the corner where it starts.
  std::vector<std::size_t> central_;    ///< By triangle.
  std::vector<std::size_t> around_;     ///< By dart: the first cell around its corner.
  std::size_t cells_ = 0;
};

}  // namespace

std::optional<std::vector<GeodesicsDocument::Piece>> cut_surface(const MovedNet& net,
                                                                 const std::vector<AxisCrossings>& geodesics) {
  return Cutter(net, geodesics).run();
}

}  // namespace epsnet::certify
