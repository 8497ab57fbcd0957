#include <algorithm>
#include <string>
#include <utility>

#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/points.h"

namespace epsnet {
namespace {

/// sinh²(d/2) of lengths d that differ by a smaller share of themselves are equal here.
Mp1024 tolerance() { return ldexp(Mp1024(1), -300); }

Mp1024 sinh2_from_0(const Complex<Mp1024>& z) { return sinh2_half_distance(Complex<Mp1024>{}, z); }

}  // namespace

Isometry<Mp1024> isometry_of(const Surface& surface, const Word& word) {
  Isometry<Mp1024> result;
  for (const SideId side : word) result = normalized(surface.crossing_as<Mp1024>(side) * result);
  return result;
}

BasePoint rounded_point(const Surface& surface, TileId tile, const Complex<Mp1024>& z) {
  constexpr int kBits = 100;
  constexpr int kMostTiles = 100'000;
  // The corners of a regular surface's tile are rounded to 256 bits.
  const Mp1024 slack = ldexp(Mp1024(1), -240);
  Complex<Mp1024> here = z;
  for (int tiles = 0; tiles < kMostTiles; ++tiles) {
    const Tile& corners = surface.tile(tile);
    const auto is_beyond = [&](std::uint32_t k) {
      return orientation_determinant(convert<Mp1024>(corners[k]), convert<Mp1024>(corners[(k + 1) % corners.size()]),
                                     here) < -slack;
    };
    std::uint32_t k = 0;
    while (k < corners.size() && !is_beyond(k)) ++k;
    if (k == corners.size()) {
      const auto rounded = [&](const Mp1024& x) {
        return Rational(Mp1024(ldexp(round(Mp1024(ldexp(x, kBits))), -kBits)));
      };
      return in_its_tile(surface, {tile, {rounded(here.x), rounded(here.y)}});
    }
    const SideId side = surface.side_number(tile, k);
    here = surface.crossing_as<Mp1024>(side)(here);
    tile = surface.tile_of_side(surface.partner(side));
  }
  throw SurfaceError("a point is more than " + std::to_string(kMostTiles) + " tiles away from the tile it is given in");
}

DomainFrame::DomainFrame(const Surface& surface, const DirichletPolygon& polygon) {
  const certify::NetDocument& net = polygon.triangulation;
  const certify::NetDocument::Vertex& vertex = net.vertices[0];
  const certify::NetDocument::Chart& chart = net.charts[vertex.chart];
  tile_ = TileId(chart.tile);
  const auto number = [](const mpq_class& x) { return Mp1024(from_gmp(x)); };
  const Complex<Mp1024> centre{number(chart.centre.x), number(chart.centre.y)};
  from_tile_ = normalized(Isometry<Mp1024>::translation(-Complex<Mp1024>{Mp1024(vertex.x), Mp1024(vertex.y)}) *
                          Isometry<Mp1024>::translation(-centre));
  for (const DirichletPolygon::Side& side : polygon.sides) {
    pairings_.push_back(normalized(from_tile_ * isometry_of(surface, side.word) * inverse(from_tile_)));
    partners_.push_back(side.partner);
  }
  const std::size_t n = pairings_.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Complex<Mp1024> origin{};
    const auto centre_of_triangle = circumcentre(origin, pairings_[(k + n - 1) % n](origin), pairings_[k](origin));
    if (!centre_of_triangle) throw NetError("a vertex of the Dirichlet domain is farther away than 1024 bits can tell");
    vertices_.push_back(*centre_of_triangle);
  }
}

std::vector<std::uint32_t> DomainFrame::farthest_vertices() const {
  Mp1024 greatest(0);
  for (const Complex<Mp1024>& z : vertices_) greatest = std::max(greatest, sinh2_from_0(z));
  std::vector<std::uint32_t> result;
  std::vector<bool> done(vertices_.size(), false);
  for (std::uint32_t k = 0; k < vertices_.size(); ++k) {
    if (done[k] || sinh2_from_0(vertices_[k]) < (1 - tolerance()) * greatest) continue;
    result.push_back(k);
    // Side k and its partner are glued end to start.
    for (std::uint32_t same = k; !done[same];) {
      done[same] = true;
      same = (partners_[same] + 1) % static_cast<std::uint32_t>(vertices_.size());
    }
  }
  return result;
}

std::optional<std::uint32_t> DomainFrame::side_towards(const Complex<Mp1024>& z) const {
  std::optional<std::uint32_t> result;
  Mp1024 least = (1 - tolerance()) * sinh2_from_0(z);
  for (std::uint32_t k = 0; k < pairings_.size(); ++k) {
    const Mp1024 own = sinh2_half_distance(pairings_[k](Complex<Mp1024>{}), z);
    if (own >= least) continue;
    least = own;
    result = k;
  }
  return result;
}

std::vector<BasePoint> farthest_points(const Surface& surface, const DirichletPolygon& polygon) {
  const DomainFrame frame(surface, polygon);
  std::vector<BasePoint> result;
  for (const std::uint32_t k : frame.farthest_vertices()) {
    result.push_back(rounded_point(surface, frame.tile(), inverse(frame.from_tile())(frame.vertices()[k])));
  }
  return result;
}

}  // namespace epsnet
