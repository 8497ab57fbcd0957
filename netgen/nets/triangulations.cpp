#include "netgen/nets/triangulations.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "netgen/base/gmp.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

/// Contracts the darts for which `contracts` is true, moving their starts into their ends, if these are different
/// vertices.
template <class Contracts>
class Reduction {
 public:
  Reduction(Triangulation& triangulation, const Contracts& contracts)
      : triangulation_(triangulation), contracts_(contracts) {}

  std::uint32_t run() {
    const std::uint32_t vertices = triangulation_.vertex_count();
    constexpr int kMostMoves = 10'000;
    for (int moves = 0;;) {
      // Contractions make others possible, so passes are repeated until nothing changes.
      while (contract_where_possible()) {
      }
      const std::optional<Dart> d = remaining();
      if (!d) {
        return vertices - triangulation_.vertex_count();
      }
      if (!approach(*d) || ++moves > kMostMoves) {
        throw NetError("the surface's own vertices are closer to each other than epsilon, and vertex " +
                       to_string(from(*d)) + " could not be moved into vertex " + to_string(to(*d)));
      }
    }
  }

 private:
  [[nodiscard]] VertexId from(Dart d) const { return triangulation_.corner(d).vertex; }
  [[nodiscard]] VertexId to(Dart d) const { return from(next_dart(d)); }

  bool contract_where_possible() {
    bool changed = false;
    // Contractions take triangles away.
    for (TriangleId t(0); t.number() < triangulation_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3 && t.number() < triangulation_.triangle_count(); ++i) {
        const Dart d = make_dart(t, i);
        if (from(d) != to(d) && contracts_(d)) {
          if (const std::optional<Dart> merged = contract(triangulation_, d)) {
            restore(*merged);
            changed = true;
          }
        }
      }
    }
    return changed;
  }

  [[nodiscard]] std::optional<Dart> remaining() {
    for (const TriangleId t : triangulation_.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (const Dart d = make_dart(t, i); from(d) != to(d) && contracts_(d)) {
          return d;
        }
      }
    }
    return std::nullopt;
  }

  /// Moves the start of d towards its end, by the largest possible power of ½ of the way.
  bool approach(Dart d) {
    const Vertex start = triangulation_.vertex(from(d));
    const LabelId label = triangulation_.label_along(d);
    const Complex<Mp1024> one{1, 0};
    const Complex<Mp1024> a = convert<Mp1024>(start.z);
    const Complex<Mp1024> b = convert<Mp1024>(triangulation_.lift_in<Mp256>({to(d), label}));
    const Complex<Mp1024> way = (b - a) / (one - conj(a) * b);
    const Mp1024 size = sqrt(norm(way));
    Mp1024 length = atanh(size);
    for (int halvings = 0; halvings < 60; ++halvings) {
      length /= 2;
      const Complex<Mp1024> step = Mp1024(tanh(length) / size) * way;
      const Complex<Mp1024> target = (step + a) / (one + conj(a) * step);
      const auto point = triangulation_.lifted_point(start.chart, target, Atlas::Precision::binary64);
      if (point && move_vertex(triangulation_, d, *point)) {
        restore(d);
        return true;
      }
    }
    return false;
  }

  /// Makes the triangulation Delaunay again after a change of the triangles around the start of d.
  void restore(Dart d) {
    pending_.clear();
    for (const Dart x : triangulation_.star(d)) {
      pending_.push_back(x);
      pending_.push_back(next_dart(x));
    }
    (void)restore_delaunay(triangulation_, pending_);
  }

  Triangulation& triangulation_;
  const Contracts& contracts_;
  std::vector<Dart> pending_;
};

bool too_close(Triangulation& triangulation, Dart d, const Threshold& apart) {
  return triangulation.compare_distance(triangulation.corner(d), triangulation.corner(next_dart(d)), apart) <= 0;
}

/// Inserts the two vertices for every core that is found at a vertex of no collar and was not handled before; returns
/// whether there was one.
bool handle_collars(Triangulation& triangulation, Collars& collars) {
  const std::size_t before = collars.count();
  // The triangles that are inserted follow.
  for (TriangleId t(0); t.number() < triangulation.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Corner corner = triangulation.corner(t, i);
      if (collars.has_vertex(corner.vertex)) {
        continue;
      }
      const std::optional<Core> core = collars.core_at(make_dart(t, i));
      if (core && !collars.is_handled(*core, t, corner.label)) {
        collars.insert_pair(*core, t, corner.label, nullptr);
      }
    }
  }
  return collars.count() > before;
}

}  // namespace

DelaunayStart delaunay_start(const Surface& surface, const std::optional<BasePoint>& base) {
  DelaunayStart start{Triangulation(surface, base), 0};
  // The triangulation of regular tiles by their centres is Delaunay; detecting its ties would take all bits.
  const bool is_delaunay = surface.is_regular() && (!base || base->z == Complex<Rational>{});
  if (!is_delaunay) start.flips = make_delaunay(start.triangulation);
  return start;
}

namespace {

bool is_strictly_inside(const Surface& surface, const BasePoint& point) {
  try {
    require_inside(surface, point);
    return true;
  } catch (const SurfaceError&) {
    return false;
  }
}

/// Makes a point the next vertex of a Delaunay triangulation, in a chart of its own. Throws ClosePointsError if it is a
/// vertex already.
InsertedVertex insert_point(Triangulation& triangulation, const BasePoint& point) {
  const std::uint32_t v = triangulation.vertex_count();
  const LiftedPoint lifted = triangulation.lifted_point(point, TriangleId(0));
  const Location location = locate(triangulation, TriangleId(0), lifted, Walk::straight);
  if (location.type == Location::Type::vertex) {
    throw ClosePointsError(triangulation.corner(location.dart).vertex.number(), v);
  }
  const auto inserted = insert_by_flips(triangulation, TriangleId(0), lifted, Walk::straight, kAnySteps);
  if (!inserted) throw NetError("point " + std::to_string(v) + " could not be made a vertex");
  return *inserted;
}

}  // namespace

DelaunayStart delaunay_start_of_point(const Surface& surface, const std::optional<BasePoint>& point) {
  if (point) require_on_surface(surface, *point);
  // Cut by the centres of its tiles, a map is Delaunay, and few corners are near each other.
  const bool is_map = surface.is_regular() && surface.tiles().size() > 1;
  if (!point || (is_strictly_inside(surface, *point) && (!is_map || point->z == Complex<Rational>{}))) {
    DelaunayStart start = delaunay_start(surface, point);
    start.removed = reduce_to_vertex_0(start.triangulation);
    return start;
  }
  // On the boundary of its tile, or beyond: the second vertex, into which the first one moves, which is another point.
  std::optional<BasePoint> other = centre_of_tile(surface, point->tile);
  if (is_same_point(surface, *other, *point)) other.reset();
  DelaunayStart start = delaunay_start(surface, other);
  start.removed = reduce_to_vertex_0(start.triangulation);
  start.flips += insert_point(start.triangulation, *point).flips;
  const auto leaves_the_first = [&](Dart d) { return start.triangulation.corner(d).vertex == VertexId(0); };
  start.removed += Reduction(start.triangulation, leaves_the_first).run();
  return start;
}

DelaunayStart delaunay_start_of_points(const Surface& surface, const std::vector<BasePoint>& points,
                                       const Threshold& apart) {
  for (const BasePoint& point : points) require_on_surface(surface, point);
  DelaunayStart start = delaunay_start_of_point(surface, points.front());
  Triangulation& triangulation = start.triangulation;
  for (std::uint32_t v = 1; v < points.size(); ++v) {
    const InsertedVertex inserted = insert_point(triangulation, points[v]);
    start.flips += inserted.flips;
    // The nearest other vertex is a neighbour.
    for (const Dart d : triangulation.star(inserted.dart)) {
      const std::uint32_t other = triangulation.corner(next_dart(d)).vertex.number();
      if (other != v && too_close(triangulation, d, apart)) throw ClosePointsError(other, v);
    }
  }
  return start;
}

std::uint32_t reduce_to_packing(Triangulation& triangulation, const Threshold& apart) {
  const auto contracts = [&](Dart d) { return too_close(triangulation, d, apart); };
  return Reduction(triangulation, contracts).run();
}

std::uint32_t clear_collars(Triangulation& triangulation, const Threshold& apart, Collars& collars) {
  const auto contracts = [&](Dart d) {
    return !collars.has_vertex(triangulation.corner(d).vertex) &&
           (too_close(triangulation, d, apart) || collars.core_at(d).has_value());
  };
  std::uint32_t removed = 0;
  // While it is moved, a vertex may enter another collar.
  while (handle_collars(triangulation, collars)) {
    removed += Reduction(triangulation, contracts).run();
  }
  return removed;
}

std::uint32_t reduce_to_vertex_0(Triangulation& triangulation) {
  const auto leaves_another = [&](Dart d) { return triangulation.corner(d).vertex != VertexId(0); };
  return Reduction(triangulation, leaves_another).run();
}

namespace {

/// Numbers the used members of a large set in the order of their first use.
class Renumbering {
 public:
  explicit Renumbering(std::size_t size) : number_(size, kUnused) {}
  [[nodiscard]] std::uint32_t operator()(std::uint32_t i) {
    if (number_[i] == kUnused) {
      number_[i] = static_cast<std::uint32_t>(used_.size());
      used_.push_back(i);
    }
    return number_[i];
  }
  [[nodiscard]] const std::vector<std::uint32_t>& used() const { return used_; }

 private:
  static constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number_;
  std::vector<std::uint32_t> used_;
};

}  // namespace

certify::NetDocument net_document(const Triangulation& triangulation, const Length& epsilon) {
  const Atlas& atlas = triangulation.atlas();
  certify::NetDocument net;
  net.surface = to_document(triangulation.surface());
  net.epsilon = epsilon.text();
  Renumbering chart_number(atlas.charts().count());
  Renumbering label_number(atlas.labels().count());
  (void)label_number(kIdentity);
  net.vertices.reserve(triangulation.vertex_count());
  for (const VertexId v : triangulation.vertices()) {
    const Vertex& vertex = triangulation.vertex(v);
    net.vertices.push_back({vertex.z.x, vertex.z.y, chart_number(vertex.chart.number())});
  }
  net.triangles.reserve(triangulation.triangle_count());
  for (const TriangleId t : triangulation.triangles()) {
    const Triangle& triangle = triangulation.triangle(t);
    const auto& [a, b, c] = triangle.vertex;
    net.triangles.push_back({{a.number(), b.number(), c.number()},
                             {document_dart(triangle.opposite[0]), document_dart(triangle.opposite[1]),
                              document_dart(triangle.opposite[2])},
                             {label_number(triangle.label(1)), label_number(triangle.label(2))}});
  }
  for (const std::uint32_t c : chart_number.used()) {
    const Chart& chart = atlas.charts()[ChartId(c)];
    net.charts.push_back({chart.tile.number(), to_gmp(chart.centre)});
  }
  for (const LabelId l : label_number.used()) {
    if (l != kIdentity) {
      const LabelTable::Entry& label = atlas.labels()[l];
      net.labels.push_back(
          {chart_number(label.from.number()), chart_number(label.to.number()), letters_of(label.word)});
    }
  }
  return net;
}

namespace {

[[noreturn]] void refuse_net(const std::string& what) { throw TriangulationError(what); }

void add_charts(const certify::NetDocument& net, Atlas& atlas) {
  for (const certify::NetDocument::Chart& chart : net.charts) {
    const std::string name = "chart " + std::to_string(atlas.charts().count());
    if (chart.tile >= atlas.surface().tiles().size()) {
      refuse_net(name + " is in tile " + std::to_string(chart.tile) + ", the surface has " +
                 std::to_string(atlas.surface().tiles().size()));
    }
    const Complex<Rational> centre = from_gmp(chart.centre);
    if (norm(centre) >= 1) refuse_net(name + " has its centre outside of the unit disk");
    (void)atlas.add_chart({TileId(chart.tile), centre});
  }
}

/// Throws TriangulationError unless the word leads from the tile of chart `from` to that of chart `to`.
void check_label(const certify::NetDocument::Label& label, const std::string& name, const Atlas& atlas) {
  for (const std::uint32_t chart : {label.from, label.to}) {
    if (chart >= atlas.charts().count()) {
      refuse_net(name + " names chart " + std::to_string(chart) + ", there are " +
                 std::to_string(atlas.charts().count()));
    }
  }
  const Surface& surface = atlas.surface();
  TileId tile = atlas.charts()[ChartId(label.from)].tile;
  for (const SideId side : word_of_letters(label.word)) {
    if (side.number() >= surface.side_count() || surface.tile_of_side(side) != tile) {
      refuse_net(name + " crosses side " + to_string(side) + ", which tile " + to_string(tile) + " does not have");
    }
    tile = surface.tile_of_side(surface.partner(side));
  }
  if (tile != atlas.charts()[ChartId(label.to)].tile) {
    refuse_net(name + " ends in tile " + to_string(tile) + ", its chart is in tile " +
               to_string(atlas.charts()[ChartId(label.to)].tile));
  }
}

/// Returns the labels of an atlas that are the labels of a document, by their numbers in the document.
std::vector<LabelId> add_labels(const certify::NetDocument& net, Atlas& atlas) {
  std::vector<LabelId> labels{kIdentity};
  for (const certify::NetDocument::Label& label : net.labels) {
    check_label(label, "label " + std::to_string(labels.size()), atlas);
    labels.push_back(atlas.label(ChartId(label.from), ChartId(label.to), word_of_letters(label.word)));
  }
  return labels;
}

/// A triangle of a document of `count` triangles.
Triangle triangle_of(const certify::NetDocument::Triangle& triangle, std::size_t count,
                     const std::vector<LabelId>& labels, const std::string& name) {
  for (const std::uint32_t dart : triangle.opposite) {
    if (dart / 3 >= count) {
      refuse_net(name + " is glued to dart " + std::to_string(dart) + ", there are " + std::to_string(3 * count));
    }
  }
  for (const std::uint32_t label : triangle.label) {
    if (label >= labels.size()) {
      refuse_net(name + " has label " + std::to_string(label) + ", there are " + std::to_string(labels.size()));
    }
    if (labels[label] > kLargestLabel) throw LimitError("more than 2^24 labels");
  }
  const auto& [first, second, third] = triangle.opposite;
  const auto& [a, b, c] = triangle.vertex;
  return {{VertexId(a), VertexId(b), VertexId(c)},
          {triangulation_dart(first), triangulation_dart(second), triangulation_dart(third)},
          Triangle::packed(labels[triangle.label[0]], labels[triangle.label[1]])};
}

}  // namespace

Triangulation triangulation_of(const certify::NetDocument& net) {
  Atlas atlas(from_document(net.surface));
  add_charts(net, atlas);
  const std::vector<LabelId> labels = add_labels(net, atlas);
  std::vector<Vertex> vertices;
  vertices.reserve(net.vertices.size());
  for (const certify::NetDocument::Vertex& vertex : net.vertices) {
    vertices.push_back({{vertex.x, vertex.y}, ChartId(vertex.chart)});
  }
  std::vector<Triangle> triangles;
  triangles.reserve(net.triangles.size());
  for (const certify::NetDocument::Triangle& triangle : net.triangles) {
    triangles.push_back(
        triangle_of(triangle, net.triangles.size(), labels, "triangle " + std::to_string(triangles.size())));
  }
  return assembled(std::move(atlas), vertices, triangles);
}

}  // namespace epsnet
