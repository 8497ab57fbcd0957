#include "netgen/pictures/dirichlet.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet {
namespace {

using Point = Complex<Mp1024>;

/// Returns the surface with the same tiles in the same coordinates, renumbered so that the given corner is corner 0 of
/// tile 0. Its point is then the first vertex of the surface.
certify::SurfaceDocument with_first_corner(certify::SurfaceDocument surface, std::uint32_t tile, std::uint32_t corner) {
  std::swap(surface.tiles[0], surface.tiles[tile]);
  certify::SurfaceDocument::Tile& first = surface.tiles[0];
  const auto size = static_cast<std::uint32_t>(first.size());
  std::rotate(first.begin(), first.begin() + corner, first.end());
  const auto renumber = [&](std::uint32_t& t, std::uint32_t& side) {
    t = t == tile ? 0 : t == 0 ? tile : t;
    if (t == 0) side = (side + size - corner) % size;
  };
  for (certify::SurfaceDocument::Gluing& g : surface.gluing) {
    renumber(g.tile, g.side);
    renumber(g.other_tile, g.other_side);
  }
  return surface;
}

/// Returns the corner of a chart's tile that is the chart's centre, if there is one.
std::optional<std::uint32_t> corner_at(const certify::SurfaceDocument& surface,
                                       const certify::NetDocument::Chart& chart) {
  if (surface.tiles.empty()) return std::nullopt;
  const certify::SurfaceDocument::Tile& tile = surface.tiles[chart.tile];
  const auto found = std::find(tile.begin(), tile.end(), chart.centre);
  if (found == tile.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - tile.begin());
}

/// A point of the surface in the tile that contains it.
struct TilePoint {
  std::uint32_t tile;
  Point z;
  Isometry<Mp1024> from_chart;  ///< From the coordinates of the chart in which the point was given to the tile's.
};

/// Tiles in the Klein model, and the crossings between them.
class Tiles {
 public:
  explicit Tiles(const NetGeometry& geometry)
      : sides_(geometry.sides()), parts_(geometry.document(), geometry.sides()) {
    const certify::SurfaceDocument surface = with_rounded_tiles(geometry.document().surface);
    for (const certify::SurfaceDocument::Tile& tile : surface.tiles) {
      std::vector<Point>& corners = corners_.emplace_back();
      for (const certify::RationalPoint& z : tile) corners.push_back(to_klein(rounded<Mp1024>(z)));
    }
  }

  /// Finds the tile of a point of a chart along the straight line from the middle of the chart's tile.
  [[nodiscard]] TilePoint locate(std::uint32_t chart, std::uint32_t tile, const Point& z) const {
    Isometry<Mp1024> g = parts_.frames[chart];
    Point start = from_klein(middle(tile));
    Point target = g(z);
    constexpr int kMostSteps = 1'000'000;
    for (int steps = 0; steps < kMostSteps; ++steps) {
      const std::optional<std::uint32_t> exit = exit_side(tile, to_klein(start), to_klein(target));
      if (!exit) return {tile, target, g};
      const std::uint32_t side = sides_.first[tile] + *exit;
      const Isometry<Mp1024>& crossing = parts_.crossings[side];
      g = normalized(crossing * g);
      start = crossing(start);
      target = crossing(target);
      tile = sides_.tile[sides_.partner[side]];
    }
    throw NetGeometryError("no tile contains the centre of the Dirichlet domain");
  }

  /// Returns the point itself if it is inside the tile, otherwise a point beside it that is.
  [[nodiscard]] Point inside(const TilePoint& point) const {
    const std::vector<Point>& corners = corners_[point.tile];
    const Point k = to_klein(point.z);
    const Mp1024 tiny = ldexp(Mp1024(1), -200);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point& u = corners[i];
      if (cross(corners[(i + 1) % corners.size()] - u, k - u) > tiny) continue;
      const Mp1024 share = ldexp(Mp1024(1), -60);
      return from_klein(k + share * (middle(point.tile) - k));
    }
    return point.z;
  }

 private:
  [[nodiscard]] Point middle(std::uint32_t tile) const {
    Point sum{};
    for (const Point& k : corners_[tile]) sum = sum + k;
    return Mp1024(1 / Mp1024(corners_[tile].size())) * sum;
  }

  /// Returns the side through which a segment leaves a tile; nullopt if it ends in the tile (Klein model). The segment
  /// starts inside the tile or beyond one of its sides.
  [[nodiscard]] std::optional<std::uint32_t> exit_side(std::uint32_t tile, const Point& from, const Point& to) const {
    static const Mp1024 kTiny = ldexp(Mp1024(1), -300);
    const Point direction = to - from;
    Mp1024 exit_at = 1 - kTiny;
    std::optional<std::uint32_t> exit;
    const std::vector<Point>& corners = corners_[tile];
    for (std::uint32_t side = 0; side < corners.size(); ++side) {
      const Point& u = corners[side];
      const Point along = corners[(side + 1) % corners.size()] - u;
      const Mp1024 slope = cross(along, direction);
      if (!(slope < -kTiny * norm(along))) continue;
      const Mp1024 at = cross(along, from - u) / -slope;
      if (at < exit_at) {
        exit_at = at;
        exit = side;
      }
    }
    return exit;
  }

  const certify::SurfaceSides& sides_;
  Parts<Mp1024> parts_;
  std::vector<std::vector<Point>> corners_;  ///< By tile, Klein model.
};

/// Returns x rounded down to 300 bits after the point.
Rational dyadic(const Mp1024& x) { return Rational(Mp1024(ldexp(floor(ldexp(x, 300)), -300))); }

/// Returns the points rotated by an isometry that fixes 0.
std::vector<Complex<double>> rotated(const Isometry<double>& f, std::vector<Complex<double>> points) {
  const Complex<double> turn = (1 / norm(f.a)) * (f.a * f.a);
  for (Complex<double>& z : points) z = turn * z;
  return points;
}

std::vector<Complex<double>> domain_of_vertex(const NetGeometry& geometry, const certify::NetDocument::Vertex& v) {
  const certify::NetDocument& net = geometry.document();
  const certify::NetDocument::Chart& chart = net.charts[v.chart];
  if (v.x == 0 && v.y == 0) {
    if (const auto corner = corner_at(net.surface, chart)) {
      const Surface surface = from_document(with_first_corner(net.surface, chart.tile, *corner));
      return dirichlet_polygon(surface, std::nullopt).vertices;
    }
    if (certify::regular_tile(net.surface) && chart.centre.x == 0 && chart.centre.y == 0)
      return dirichlet_polygon(from_document(net.surface), BasePoint{TileId(chart.tile), {0, 0}}).vertices;
  }
  const Tiles tiles(geometry);
  const Point z{Mp1024(v.x), Mp1024(v.y)};
  const TilePoint point = tiles.locate(v.chart, chart.tile, z);
  const Point base = tiles.inside(point);
  const BasePoint exact{TileId(point.tile), {dyadic(base.x), dyadic(base.y)}};
  DirichletPolygon polygon = dirichlet_polygon(from_document(net.surface), exact);
  // Both isometries lead from the chart to a disk with the vertex at 0.
  const Isometry<Mp1024> wanted = normalized(Isometry<Mp1024>::translation(-z));
  const Isometry<Mp1024> found = normalized(Isometry<Mp1024>::translation(-point.z) * point.from_chart);
  return rotated(convert<double>(wanted * inverse(found)), std::move(polygon.vertices));
}

}  // namespace

std::vector<Complex<double>> dirichlet_domain(const NetGeometry& geometry, std::uint32_t vertex) {
  constexpr std::uint32_t kMostGenus = 100;
  const std::string name = "the Dirichlet domain of vertex " + std::to_string(vertex);
  if (vertex >= geometry.document().vertices.size())
    throw NetGeometryError("vertex " + std::to_string(vertex) + " does not exist");
  if (geometry.genus() > kMostGenus) {
    throw DomainNotDrawn(name + " is drawn up to genus " + std::to_string(kMostGenus) + ", not " +
                         std::to_string(geometry.genus()));
  }
  try {
    return domain_of_vertex(geometry, geometry.document().vertices[vertex]);
  } catch (const SurfaceError& error) {
    throw NetGeometryError(name + ": " + error.what());
  } catch (const Error& error) {
    throw DomainNotDrawn(name + ": " + error.what());
  }
}

}  // namespace epsnet
