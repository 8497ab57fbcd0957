#include "netgen/pictures/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/pictures/svg.h"

namespace epsnet {
namespace {

using Point = Complex<Mp256>;

/// Lengths below 2⁻¹²⁰ count as rounding; a picture shows nothing as small.
const Mp256& tolerance() {
  static const Mp256 value = ldexp(Mp256(1), -120);
  return value;
}

/// Returns the corners of a lifted triangle in Klein coordinates.
std::array<Point, 3> klein_corners(const NetGeometry& geometry, const Placement& placement) {
  std::array<Point, 3> result;
  const certify::NetDocument& document = geometry.document();
  for (std::uint32_t i = 0; i < 3; ++i) {
    const certify::NetDocument::Vertex& v = document.vertices[document.triangles[placement.triangle].vertex[i]];
    const std::uint32_t label = certify::corner_label(document, 3 * placement.triangle + i);
    result[i] = to_klein((placement.isometry * geometry.label(label).precise)({Mp256(v.x), Mp256(v.y)}));
  }
  return result;
}

/// Returns twice the area of the triangle u, v, w: positive if w is on the left of the line from u to v.
Mp256 side_of(const Point& u, const Point& v, const Point& w) { return cross(v - u, w - u); }

/// Whether side_of says that w is on the line or on its left, to within rounding. The comparison is that of the
/// distance of w from the line, as Klein coordinates shrink u and v to nearly one point if they are far from the
/// origin.
bool is_left(const Point& u, const Point& v, const Mp256& side_of_w) {
  return side_of_w >= 0 || side_of_w * side_of_w <= tolerance() * tolerance() * norm(v - u);
}

/// Returns the lift that an isometry of the disk takes a lift to.
Placement moved(const Isometry<Mp256>& by, const Placement& placement) {
  return {placement.triangle, normalized(by * placement.isometry)};
}

/// Returns a lifted triangle that contains 0. It is found by a visibility walk from another one: each step crosses a
/// side that separates the triangle from 0, which ends in a Delaunay triangulation (thesis Theorem II.3). Returns
/// nullopt if the walk takes too many steps.
std::optional<Placement> walk_to_0(const NetGeometry& geometry, Placement placement) {
  const std::size_t most = 1000 + 20 * geometry.document().triangles.size();
  for (std::size_t steps = 0; steps < most; ++steps) {
    const std::array<Point, 3> corners = klein_corners(geometry, placement);
    const auto has_0_on_its_left = [&](std::uint32_t i) {
      const Point& u = corners[i];
      const Point& v = corners[(i + 1) % 3];
      return is_left(u, v, side_of(u, v, {}));
    };
    std::uint32_t i = 0;
    while (i < 3 && has_0_on_its_left(i)) ++i;
    if (i == 3) return placement;
    placement = neighbour(geometry, placement, i);
  }
  return std::nullopt;
}

/// A curve cannot be drawn with a reasonable amount of work, or with 256 bits, although the net may be sound.
class CurveNotFollowed : public NetGeometryError {
 public:
  using NetGeometryError::NetGeometryError;
};

template <class T>
T required(std::optional<T> result) {
  if (!result)
    throw CurveNotFollowed(
        "it crosses too many triangles to be followed; it may wind around a very short closed geodesic");
  return *std::move(result);
}

/// A part of a segment; `from` and `to` are shares of its length.
struct Part {
  Mp256 from = 0;
  Mp256 to = 1;
  [[nodiscard]] bool touches() const { return to - from >= -tolerance(); }
  [[nodiscard]] bool has_length() const { return to - from > tolerance(); }
};

/// Returns the part of the segment from p to q that is in a triangle.
Part part_inside(const std::array<Point, 3>& corners, const Point& p, const Point& q) {
  Part part;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Point& u = corners[i];
    const Point& v = corners[(i + 1) % 3];
    const Mp256 at_p = side_of(u, v, p);
    const Mp256 at_q = side_of(u, v, q);
    const bool p_inside = is_left(u, v, at_p);
    const bool q_inside = is_left(u, v, at_q);
    if (p_inside && q_inside) continue;
    if (!p_inside && !q_inside) return {1, 0};
    // The share is in [0, 1] even if an end lies on the side to within rounding; the triangles around it are then
    // touched.
    const Mp256 share = std::clamp(Mp256(at_p / (at_p - at_q)), Mp256(0), Mp256(1));
    if (q_inside) {
      part.from = std::max(part.from, share);
    } else {
      part.to = std::min(part.to, share);
    }
  }
  return part;
}

/// Returns a key that distinguishes lifts of a triangle: the place of corner 0.
std::tuple<std::uint32_t, Mp256, Mp256> key(const Placement& placement, const Point& corner) {
  return {placement.triangle, floor(ldexp(corner.x, 110)), floor(ldexp(corner.y, 110))};
}

void append(Layer& layer, const std::vector<Arc>& arcs) {
  layer.arcs.insert(layer.arcs.end(), arcs.begin(), arcs.end());
}

/// The tiles of the surface of a net, each in its own coordinates, with a lift of a triangle near it.
struct Tiles {
  explicit Tiles(const NetGeometry& geometry);

  Parts<Mp256> parts;
  std::vector<std::vector<Point>> corners;  ///< By tile.
  std::vector<Placement> near;              ///< By tile.
};

Tiles::Tiles(const NetGeometry& geometry) : parts(geometry.document(), geometry.sides()) {
  const certify::NetDocument& document = geometry.document();
  const certify::SurfaceSides& sides = geometry.sides();
  const certify::SurfaceDocument surface = with_rounded_tiles(document.surface);
  for (const certify::SurfaceDocument::Tile& tile : surface.tiles) {
    std::vector<Point>& points = corners.emplace_back();
    for (const certify::RationalPoint& z : tile) points.push_back(rounded<Mp256>(z));
  }
  if (document.vertices.empty()) throw NetGeometryError("there is no vertex");
  // Goes from tile to tile: the lift of a triangle near a side is also near the neighbour's side.
  const std::uint32_t chart = document.vertices[0].chart;
  std::vector<bool> done(corners.size(), false);
  near.resize(corners.size());
  std::queue<std::uint32_t> pending;
  const auto reach = [&](std::uint32_t tile, const Placement& placement) {
    done[tile] = true;
    near[tile] = placement;
    pending.push(tile);
  };
  reach(document.charts[chart].tile, placement_at(geometry, 0, parts.frames[chart]));
  for (; !pending.empty(); pending.pop()) {
    const std::uint32_t tile = pending.front();
    for (std::uint32_t k = 0; k < corners[tile].size(); ++k) {
      const std::uint32_t s = sides.first[tile] + k;
      const std::uint32_t other = sides.tile[sides.partner[s]];
      if (done[other]) continue;
      const auto from_corner = Isometry<Mp256>::translation(corners[tile][k]);
      const Placement there = required(walk_to_0(geometry, moved(inverse(from_corner), near[tile])));
      reach(other, moved(parts.crossings[s] * from_corner, there));
    }
  }
}

}  // namespace

namespace {

/// Returns the segment between two points of a lifted triangle in the chart of its corner 0; or, if the points are near
/// the unit circle there, in the chart of the corner where they are farthest from it.
Arc arc_between(const NetGeometry& geometry, const Placement& placement, const Point& p, const Point& q) {
  constexpr double kNear = 0.9;
  Arc best{};
  double least = 2;
  for (std::uint32_t i = 0; i < 3 && least > kNear; ++i) {
    const std::uint32_t dart = 3 * placement.triangle + i;
    const std::uint32_t label = certify::corner_label(geometry.document(), dart);
    const Isometry<Mp256> back = inverse(placement.isometry * geometry.label(label).precise);
    const Arc arc{dart, convert<double>(back(p)), convert<double>(back(q))};
    const double farthest = std::max(norm(arc.from), norm(arc.to));
    if (farthest < least) {
      least = farthest;
      best = arc;
    }
  }
  return best;
}

/// Cuts the segment from 0 to a point of the positive real axis (Klein coordinates) and appends its arcs. Requires:
/// `first` contains 0. Returns false if the segment meets more than `most` triangles.
bool append_arcs(std::vector<Arc>& arcs, const NetGeometry& geometry, const Placement& first, const Mp256& end,
                 std::size_t most) {
  const Point to{end, 0};
  std::vector<std::pair<Mp256, Arc>> pieces;  // With the shares at which they start.
  std::set<std::tuple<std::uint32_t, Mp256, Mp256>> seen;
  std::deque<Placement> pending{first};
  for (; !pending.empty(); pending.pop_front()) {
    if (seen.size() > most) return false;
    const Placement& placement = pending.front();
    const std::array<Point, 3> corners = klein_corners(geometry, placement);
    const Part part = part_inside(corners, {}, to);
    if (!part.touches() || !seen.insert(key(placement, corners[0])).second) continue;
    if (part.has_length()) {
      pieces.emplace_back(part.from,
                          arc_between(geometry, placement, from_klein(part.from * to), from_klein(part.to * to)));
    }
    for (std::uint32_t side = 0; side < 3; ++side) pending.push_back(neighbour(geometry, placement, side));
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& piece : pieces) arcs.push_back(piece.second);
  return true;
}

/// Returns an isometry that takes p to 0 and q to the positive real axis.
Isometry<Mp256> to_real_axis(const Point& p, const Point& q, const Mp256& length) {
  return length > 0 ? segment_to_segment(p, q, {}, {Mp256(tanh(length / 2)), 0}) : Isometry<Mp256>::translation(-p);
}

}  // namespace

std::optional<CutSegment> cut_segment(const NetGeometry& geometry, const Placement& near, const Complex<Mp256>& p,
                                      const Complex<Mp256>& q) {
  // The segment is followed in steps along the real axis; the start of each step is moved to 0. At a distance of 40
  // from the origin, as at the other end of a thin collar, everything is as small as rounding in Klein coordinates.
  constexpr int kLongestStep = 8;
  const Mp256 length = distance(p, q);
  // A longer segment is not worth drawing; an end on the unit circle is infinitely far away.
  constexpr int kLongest = 1000;
  if (!(length <= kLongest)) return std::nullopt;
  const Mp256 steps = std::max(Mp256(1), Mp256(ceil(length / kLongestStep)));
  const Mp256 step = length / steps;
  const auto forward = Isometry<Mp256>::translation({Mp256(tanh(step / 2)), 0});
  // A segment may cross a triangle many times, and if lifts do not fit together, infinitely often.
  const std::size_t most = 10000 + 20 * geometry.document().triangles.size();
  Isometry<Mp256> frame = normalized(to_real_axis(p, q, length));
  std::optional<Placement> here = walk_to_0(geometry, moved(frame, near));
  std::vector<Arc> arcs;
  for (int i = 0; here && i < steps; ++i) {
    if (!append_arcs(arcs, geometry, *here, tanh(step), most)) return std::nullopt;
    here = walk_to_0(geometry, moved(inverse(forward), *here));
    frame = normalized(inverse(forward) * frame);
  }
  if (!here) return std::nullopt;
  return CutSegment{std::move(arcs), moved(inverse(frame), *here)};
}

namespace {

/// Adds a segment to a layer; `near` becomes a lift at its end. Throws NetGeometryError if cut_segment returns nullopt.
void append_segment(Layer& layer, const NetGeometry& geometry, Placement& near, const Complex<Mp256>& p,
                    const Complex<Mp256>& q) {
  CutSegment segment = required(cut_segment(geometry, near, p, q));
  append(layer, segment.arcs);
  near = std::move(segment.end);
}

}  // namespace

namespace {

/// Returns the layer with the curves that `add_curves` adds. If one of them is not followed, the layer has no curves,
/// but the reason.
template <class AddCurves>
Layer with_curves(Layer layer, const AddCurves& add_curves) {
  try {
    add_curves(layer);
  } catch (const CurveNotFollowed& error) {
    layer.arcs.clear();
    layer.spots.clear();
    layer.parts.clear();
    layer.left_out = error.what();
  }
  return layer;
}

}  // namespace

Layer tile_layer(const NetGeometry& geometry) {
  return with_curves({.name = "fundamental tiles", .colour = palette::kTiles}, [&](Layer& layer) {
    const certify::SurfaceSides& sides = geometry.sides();
    Tiles tiles(geometry);
    for (std::uint32_t s = 0; s < sides.partner.size(); ++s) {
      if (sides.partner[s] < s) continue;
      const std::uint32_t tile = sides.tile[s];
      const std::vector<Point>& corners = tiles.corners[tile];
      const std::size_t k = sides.corner[s];
      append_segment(layer, geometry, tiles.near[tile], corners[k], corners[(k + 1) % corners.size()]);
    }
  });
}

namespace {

/// A vertex of a domain may be so far out in a thin collar that binary64 cannot distinguish it from a point of the unit
/// circle. Moves it to a distance of 32 from the centre, beyond which nothing can be seen.
Point within_sight(const Complex<double>& z) {
  const double farthest = std::tanh(16.0);
  const double radius = std::sqrt(norm(z));
  return convert<Mp256>(radius > farthest ? farthest / radius * z : z);
}

}  // namespace

Layer dirichlet_layer(const NetGeometry& geometry, std::uint32_t vertex) {
  const std::vector<Complex<double>> domain = dirichlet_domain(geometry, vertex);
  const std::string name = "Dirichlet domain of vertex " + std::to_string(vertex);
  return with_curves({.name = name, .colour = palette::kDirichlet}, [&](Layer& layer) {
    Placement near = placement_at(geometry, vertex, to_centre(geometry, vertex));
    for (std::size_t i = 0; i < domain.size(); ++i) {
      append_segment(layer, geometry, near, within_sight(domain[i]), within_sight(domain[(i + 1) % domain.size()]));
    }
  });
}

Layer combinatorial_dirichlet_layer(const NetGeometry& geometry, std::uint32_t vertex) {
  Layer layer{.name = "combinatorial Dirichlet domain of vertex " + std::to_string(vertex),
              .colour = palette::kCombinatorialDirichlet};
  const Lifts lifts = lift_triangles(geometry, DrawOrder::breadth_first, vertex);
  const std::vector<bool> on_boundary = boundary_darts(geometry, lifts);
  for (std::uint32_t dart = 0; dart < on_boundary.size(); ++dart)
    if (on_boundary[dart]) layer.darts.push_back(dart);
  return layer;
}

namespace {

/// The axis of a closed path of a tile, in the tile's coordinates.
struct ClosedPath {
  Isometry<Mp256> element;
  Mp256 length;
  Isometry<Mp256> from_diameter;  ///< Takes the diameter from −1 to 1 to the axis, 0 to the foot of the base point.

  /// Returns the point at a place along the axis and a distance from it, positive on the left (hyperbolic lengths).
  [[nodiscard]] Point at(const Mp256& along, const Mp256& distance) const {
    const auto shift = Isometry<Mp256>::translation({Mp256(tanh(along / 2)), 0});
    return from_diameter(shift({0, Mp256(tanh(distance / 2))}));
  }
};

/// Returns the axis of a closed path of a tile, given by its word; places along it are counted from the foot of `base`,
/// a point of the tile's disk.
ClosedPath closed_path(const NetGeometry& geometry, const Tiles& tiles, std::uint32_t home,
                       const std::vector<std::uint32_t>& word, const Point& base) {
  const certify::SurfaceSides& sides = geometry.sides();
  std::uint32_t tile = home;
  Isometry<Mp256> g;
  for (const std::uint32_t side : word) {
    if (sides.tile[side] != tile) throw NetGeometryError("a word is no path of sides");
    g = normalized(tiles.parts.crossings[side] * g);
    tile = sides.tile[sides.partner[side]];
  }
  const auto ends = axis(g);
  if (tile != home || word.empty()) throw NetGeometryError("a word is no closed geodesic");
  if (!ends) throw CurveNotFollowed("a closed geodesic is too short for 256 bits");
  // The foot is X minus its component along the normal of the axis, scaled back to the hyperboloid.
  const LorentzVector<Mp256> normal = axis_normal(g);
  const LorentzVector<Mp256> x = on_hyperboloid(base);
  const LorentzVector<Mp256> on_axis = x + Mp256(-lorentz_product(normal, x) / isometry_discriminant(g)) * normal;
  const Point foot = in_disk(Mp256(1 / sqrt(Mp256(-lorentz_product(on_axis, on_axis)))) * on_axis);
  // The direction of the axis, seen from its foot: a rotation by half the angle, applied twice.
  const Point direction = inverse(Isometry<Mp256>::translation(foot))(ends->to);
  const Point half = direction.x > 0 ? Point{direction.x + 1, direction.y} : Point{direction.y, 1 - direction.x};
  return {g, displacement_length(g), normalized(Isometry<Mp256>::translation(foot) * Isometry<Mp256>{half, {}})};
}

/// Adds one period of the two curves at a distance from an axis, as chords.
void append_equidistants(Layer& layer, const NetGeometry& geometry, const Placement& start, const ClosedPath& path,
                         const Mp256& distance) {
  constexpr int kChords = 48;
  for (const Mp256& height : {distance, Mp256(-distance)}) {
    Placement near = start;
    for (int i = 0; i < kChords; ++i) {
      append_segment(layer, geometry, near, path.at(path.length * i / kChords, height),
                     path.at(path.length * (i + 1) / kChords, height));
    }
  }
}

}  // namespace

std::vector<Layer> collar_layers(const NetGeometry& geometry) {
  const certify::NetDocument& net = geometry.document();
  if (!net.collars || net.collars->empty()) return {};
  Layer triangles{.name = "triangles of collars", .colour = palette::kCollarTriangles};
  for (const certify::NetDocument::Collar& collar : *net.collars) {
    triangles.triangles.insert(triangles.triangles.end(), collar.triangles.begin(), collar.triangles.end());
  }
  const Layer boundaries =
      with_curves({.name = "epsilon-collars", .colour = palette::kEpsilonCollars}, [&](Layer& layer) {
        const Tiles tiles(geometry);
        const Mp256 half_epsilon = rounded<Mp256>(geometry.epsilon()) / 2;
        for (const certify::NetDocument::Collar& collar : *net.collars) {
          // The boundaries are followed from a vertex of the collar, which is near them.
          const certify::NetDocument::Vertex& vertex = net.vertices[collar.vertices[0]];
          const Isometry<Mp256>& frame = tiles.parts.frames[vertex.chart];
          const Placement start = placement_at(geometry, collar.vertices[0], frame);
          const ClosedPath core = closed_path(geometry, tiles, net.charts[vertex.chart].tile, collar.core,
                                              frame({Mp256(vertex.x), Mp256(vertex.y)}));
          // sinh(ε/2) = sinh(ℓ/2) cosh d (thesis Theorem I.24).
          const Mp256 ratio = sinh(half_epsilon) / sinh(Mp256(core.length / 2));
          if (ratio > 1) append_equidistants(layer, geometry, start, core, acosh(ratio));
        }
      });
  return {triangles, boundaries};
}

namespace {

/// Throws NetGeometryError unless the curves of a net, called `what`, are on the surface that is drawn.
void require_same_surface(const NetGeometry& geometry, const certify::NetDocument& source, const char* what) {
  certify::SurfaceDocument surface = geometry.document().surface;
  surface.about = source.surface.about;
  if (source.surface != surface) throw NetGeometryError(std::string("these are ") + what + " of another surface");
}

/// The tile in which the word of a closed geodesic starts.
std::uint32_t tile_of(const certify::NetDocument& net, const certify::GeodesicsDocument::ClosedGeodesic& geodesic) {
  return net.charts[net.vertices[geodesic.vertex].chart].tile;
}

/// How many closed geodesics at the beginning of a file are shortest ones of the surface, as it claims: those of a
/// systole, or those of a spectrum whose lengths it does not tell apart.
std::size_t count_of_shortest(const certify::GeodesicsDocument& geodesics) {
  if (geodesics.claim == certify::GeodesicsDocument::Claim::systole) return geodesics.geodesics.size();
  return geodesics.has_up_to() && !geodesics.clusters.empty() ? geodesics.clusters[0].count : 0;
}

/// Closed geodesics of a file, from `first` on, before `end`.
struct GeodesicsRun {
  std::size_t first;
  std::size_t end;
};

/// Returns some closed geodesics of a file, all of them or none shortest ones, as a layer.
Layer geodesics_layer(const NetGeometry& geometry, const certify::GeodesicsDocument& geodesics, GeodesicsRun run) {
  const certify::NetDocument& source = geodesics.net;
  require_same_surface(geometry, source, "geodesics");
  const bool is_shortest = run.first < count_of_shortest(geodesics);
  const Layer layer{.name = is_shortest ? "shortest closed geodesics" : "closed geodesics",
                    .colour = is_shortest ? palette::kShortestGeodesics : palette::kGeodesics,
                    .in_front = true};
  return with_curves(layer, [&](Layer& result) {
    const Tiles tiles(geometry);
    for (std::size_t i = run.first; i < run.end; ++i) {
      const certify::GeodesicsDocument::ClosedGeodesic& geodesic = geodesics.geodesics.at(i);
      const std::uint32_t tile = tile_of(source, geodesic);
      const ClosedPath path = closed_path(geometry, tiles, tile, geodesic.word, {0, 0});
      Placement near = tiles.near[tile];
      result.parts.push_back({"geodesic " + std::to_string(i) + (geodesic.simple ? ", simple" : ""),
                              path.length.convert_to<double>(), result.arcs.size()});
      append_segment(result, geometry, near, path.at(0, 0), path.at(path.length, 0));
    }
  });
}

}  // namespace

std::vector<Layer> geodesics_layers(const NetGeometry& geometry, const certify::GeodesicsDocument& geodesics) {
  const certify::NetDocument& source = geodesics.net;
  const std::size_t shortest = count_of_shortest(geodesics);
  const std::size_t count = geodesics.geodesics.size();
  std::vector<Layer> layers;
  if (shortest > 0) layers.push_back(geodesics_layer(geometry, geodesics, {0, shortest}));
  if (shortest < count || count == 0) layers.push_back(geodesics_layer(geometry, geodesics, {shortest, count}));
  if (geodesics.claim != certify::GeodesicsDocument::Claim::thick_thin) return layers;
  const Layer collars{.name = "collars of small curves", .colour = palette::kSmallCurveCollars};
  layers.push_back(with_curves(collars, [&](Layer& layer) {
    const Tiles tiles(geometry);
    for (const certify::GeodesicsDocument::ClosedGeodesic& geodesic : geodesics.geodesics) {
      const std::uint32_t tile = tile_of(source, geodesic);
      const ClosedPath path = closed_path(geometry, tiles, tile, geodesic.word, {0, 0});
      append_equidistants(layer, geometry, tiles.near[tile], path, asinh(Mp256(1 / sinh(Mp256(path.length / 2)))));
    }
  }));
  return layers;
}

Layer distance_layer(const NetGeometry& geometry, const certify::DistanceDocument& distance) {
  const certify::NetDocument& source = distance.net;
  require_same_surface(geometry, source, "paths");
  return with_curves({.name = "shortest paths", .colour = palette::kPaths, .in_front = true}, [&](Layer& layer) {
    const Tiles tiles(geometry);
    const certify::NetDocument::Vertex& vertex = source.vertices[0];
    const certify::NetDocument::Chart& chart = source.charts[vertex.chart];
    const Point start =
        Isometry<Mp256>::translation(rounded<Mp256>(chart.centre))(Point{Mp256(vertex.x), Mp256(vertex.y)});
    for (const std::vector<std::uint32_t>& path : distance.paths) {
      Isometry<Mp256> value;
      for (const std::uint32_t side : path) value = normalized(tiles.parts.crossings[side] * value);
      Placement near = tiles.near[chart.tile];
      const std::size_t first = layer.arcs.size();
      append_segment(layer, geometry, near, start, inverse(value)(rounded<Mp256>(distance.point.z)));
      if (layer.arcs.size() == first) continue;  // Of length 0.
      layer.spots.push_back({layer.arcs[first].dart, layer.arcs[first].from});
      layer.spots.push_back({layer.arcs.back().dart, layer.arcs.back().to});
    }
  });
}

Layer tile_layer(const certify::NetDocument& net) { return tile_layer(NetGeometry(net)); }

Layer dirichlet_layer(const certify::NetDocument& net, std::uint32_t vertex) {
  return dirichlet_layer(NetGeometry(net), vertex);
}

Layer combinatorial_dirichlet_layer(const certify::NetDocument& net, std::uint32_t vertex) {
  return combinatorial_dirichlet_layer(NetGeometry(net), vertex);
}

std::vector<Layer> collar_layers(const certify::NetDocument& net) { return collar_layers(NetGeometry(net)); }

std::vector<Layer> geodesics_layers(const certify::NetDocument& net, const certify::GeodesicsDocument& geodesics) {
  return geodesics_layers(NetGeometry(net), geodesics);
}

Layer geodesic_layer(const certify::NetDocument& net, const certify::GeodesicsDocument& geodesics, std::size_t number) {
  return geodesics_layer(NetGeometry(net), geodesics, {number, number + 1});
}

Layer distance_layer(const certify::NetDocument& net, const certify::DistanceDocument& distance) {
  return distance_layer(NetGeometry(net), distance);
}

}  // namespace epsnet
