#include "netgen/exchange/domain_format.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/exchange/ear_clipping.h"
#include "netgen/exchange/token_reader.h"
#include "triangulation/surface/glued_polygons.h"

namespace epsnet {
namespace {

constexpr std::size_t kManySides = 256;

struct Domain {
  Tile polygon;
  std::vector<Gluing> gluing;
};

std::vector<Gluing> read_pairing(TokenReader& words, std::uint32_t size) {
  std::vector<std::uint32_t> partner;
  std::vector<std::size_t> line;
  const std::string range =
      ", from 0 to " + std::to_string(size - 1) + " (the text claims " + std::to_string(size) + " sides)";
  // The vectors grow with the text, not with the number of sides that it claims.
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::string expected = "the index of the side paired with side " + std::to_string(k) + range;
    partner.push_back(words.index(expected));
    line.push_back(words.line());
    if (partner[k] >= size) words.fail(std::to_string(partner[k]) + " found, expected " + expected);
    if (partner[k] == k) words.fail("side " + std::to_string(k) + " is paired with itself");
  }
  std::vector<Gluing> gluing;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (partner[partner[k]] != k) {
      words.fail_at(line[k], "side " + std::to_string(k) + " is paired with side " + std::to_string(partner[k]) +
                                 ", but side " + std::to_string(partner[k]) + " with side " +
                                 std::to_string(partner[partner[k]]));
    }
    if (k < partner[k]) gluing.push_back({0, k, 0, partner[k]});
  }
  return gluing;
}

Domain parse(std::string_view text, std::string_view name) {
  TokenReader words(text, name);
  const std::uint32_t size = words.index("the number of sides, an even number from 8 to 2^32 - 2");
  if (size < 8 || size % 2 != 0) {
    words.fail(std::to_string(size) + " sides found, expected an even number, at least 8 (genus 2)");
  }
  Domain domain;
  domain.gluing = read_pairing(words, size);
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::string vertex = "vertex " + std::to_string(k);
    const Complex<Rational> z{words.rational("the x coordinate of " + vertex),
                              words.rational("the y coordinate of " + vertex)};
    if (disk_gap(scaled(z)) <= 0) {
      words.fail(vertex + " lies outside of the open unit disk, expected |z| < 1, found |z|^2 = " +
                 certify::shortest(static_cast<double>(Mp256(norm(z)))));
    }
    domain.polygon.push_back(z);
  }
  words.expect_end("the last vertex");
  return domain;
}

Surface make_surface(Domain domain) {
  std::vector<Tile> tiles{std::move(domain.polygon)};
  std::vector<Gluing> gluing;
  {
    GluedPolygons polygon(tiles, domain.gluing);
    polygon.check_vertices();
    const std::optional<std::string> problem = polygon.convexity_problem();
    if (!problem) return {std::move(tiles), std::move(domain.gluing)};
    if (tiles[0].size() > kMaxNonConvexSides) {
      throw SurfaceError(*problem + "; polygons that are not convex may have at most " +
                         std::to_string(kMaxNonConvexSides) + " sides");
    }
    // "Intersects itself" is a better message than "lengths differ", so that test comes first. For large polygons the
    // quick tests come first, so that junk does not reach the quadratic one.
    if (tiles[0].size() > kManySides) {
      polygon.check_lengths();
      polygon.check_angles();
    }
    if (const auto pair = crossing_sides(polygon.klein_points())) {
      throw SurfaceError("the polygon intersects itself: side " + std::to_string(pair->first) + " meets side " +
                         std::to_string(pair->second));
    }
    if (polygon.clockwise(TileId(0))) throw SurfaceError(*problem);
    polygon.check_lengths();
    polygon.check_angles();
    PolygonTriangulation triangulation = clip_ears(polygon.klein_points());
    const Tile vertices = std::move(tiles[0]);
    tiles.clear();
    for (const auto& [a, b, c] : triangulation.triangles) tiles.push_back({vertices[a], vertices[b], vertices[c]});
    gluing = std::move(triangulation.diagonals);
    for (const Gluing& pair : domain.gluing) {
      const auto [tile, side] = triangulation.place_of_side[pair.side];
      const auto [other_tile, other_side] = triangulation.place_of_side[pair.other_side];
      gluing.push_back({tile, side, other_tile, other_side});
    }
  }
  return {std::move(tiles), std::move(gluing)};
}

}  // namespace

Surface read_domain(std::string_view text, std::string_view name) {
  Domain domain = parse(text, name);
  try {
    return make_surface(std::move(domain));
  } catch (const SurfaceError& error) {
    throw ExchangeError(certify::ErrorParts{.file = std::string(name), .problem = error.what()});
  }
}

std::string write_domain(const Surface& surface) {
  if (!surface.is_rational()) {
    throw ExchangeError(
        "a polygon over a number field or a regular one has no rational vertices, so the domain format cannot hold it");
  }
  if (surface.tiles().size() != 1) {
    throw ExchangeError("the domain format holds one polygon, the surface has " +
                        std::to_string(surface.tiles().size()) + " tiles; the triangulation format holds them");
  }
  std::string text = std::to_string(surface.side_count()) + "\n";
  for (const SideId s : surface.side_ids()) text += to_string(surface.partner(s)) + "\n";
  const auto fraction = [](const Rational& value) { return numerator(value).str() + "/" + denominator(value).str(); };
  for (const auto& [x, y] : surface.tiles()[0]) text += fraction(x) + " " + fraction(y) + "\n";
  return text;
}

}  // namespace epsnet
