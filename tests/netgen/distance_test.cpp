#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/check.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/surface/surface.h"

namespace epsnet::distance_test {
namespace {

using certify::DistanceDocument;
using certify::Interval;
using test::any_index;
using test::any_share;
using testing::HasSubstr;

/// Returns the outcome of the checker: "VERIFIED", or the reason for another verdict.
std::string verdict(const DistanceDocument& document) {
  return certify::verdict_line(certify::check(document, {.threads = 1}));
}

/// Returns a random point strictly inside a random tile.
BasePoint any_place(const Surface& surface) {
  const TileId tile(any_index(surface.tiles().size()));
  const Complex<Rational> centre = centre_of_tile(surface, tile).z;
  const Tile& corners = surface.tile(tile);
  const Complex<Rational>& corner = corners[any_index(corners.size())];
  // Towards a corner, in the Klein model, where tiles are convex.
  const auto share = 0.95 * any_share();
  const Complex<double> place =
      from_klein((1 - share) * to_klein(convert<double>(centre)) + share * to_klein(convert<double>(corner)));
  BasePoint point{tile, {Rational(place.x), Rational(place.y)}};
  try {
    require_inside(surface, point);
  } catch (const SurfaceError&) {
    point.z = centre;  // A tile as thin as that.
  }
  return point;
}

Interval distance_of(const Surface& surface, const BasePoint& p, const BasePoint& q) {
  return unproved::distance(surface, p, q).distance;
}

/// Returns the length of a path, computed independently.
double length_of_path(const Surface& surface, const BasePoint& p, const BasePoint& q, const Word& word) {
  Complex<Mp1024> z = convert<Mp1024>(p.z);
  for (const SideId side : word) z = surface.crossing_as<Mp1024>(side)(z);
  return static_cast<double>(distance(z, convert<Mp1024>(q.z)));
}

/// The least distance of q from the places that tiles have after at most `crossings` crossings, by brute force in
/// binary64, for surfaces of one tile; places are told apart by their coordinates.
double least_by_words(const Surface& surface, const BasePoint& p, const BasePoint& q, int crossings) {
  std::vector<Isometry<double>> sides;
  for (const SideId s : surface.side_ids()) sides.push_back(convert<double>(surface.crossing_as<Mp256>(s)));
  const Complex<double> from = convert<double>(p.z);
  const Complex<double> to = convert<double>(q.z);
  double least = distance(from, to);
  std::set<std::pair<long, long>> seen;
  std::vector<Isometry<double>> level{Isometry<double>{}};
  for (int i = 0; i < crossings; ++i) {
    std::vector<Isometry<double>> next;
    for (const Isometry<double>& element : level) {
      for (const Isometry<double>& side : sides) {
        const Isometry<double> product = normalized(side * element);
        const Complex<double> place = product(from);
        if (!seen.emplace(std::lround(place.x * 1e9), std::lround(place.y * 1e9)).second) continue;
        least = std::min(least, distance(place, to));
        next.push_back(product);
      }
    }
    level = std::move(next);
  }
  return least;
}

TEST(Distance, OfPointsNearEachOtherIsThatOfTheDisk) {
  const Surface bolza = Surface::regular(2);
  const DistanceDocument document =
      unproved::distance(bolza, {TileId(0), {0, 0}}, {TileId(0), {Rational(3, 10), Rational(1, 10)}});
  EXPECT_EQ(verdict(document), "VERIFIED");
  EXPECT_EQ(document.paths, std::vector<std::vector<std::uint32_t>>{{}});
  const double expected = 2 * std::atanh(std::sqrt(0.1));
  EXPECT_NEAR(document.distance.lower, expected, 1e-15);
  EXPECT_LT(document.distance.upper - document.distance.lower, 1e-15);
}

TEST(Distance, ToItselfIsZero) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const BasePoint p = centre_of_tile(named.surface, TileId(0));
    const DistanceDocument document = unproved::distance(named.surface, p, p);
    EXPECT_EQ(document.distance, (Interval{0, 0})) << named.name;
    EXPECT_EQ(document.paths, std::vector<std::vector<std::uint32_t>>{{}}) << named.name;
    EXPECT_EQ(verdict(document), "VERIFIED") << named.name;
  }
}

TEST(Distance, OfPointsCloserThanBinary64CanSay) {
  const Surface bolza = Surface::regular(2);
  Rational tiny(1);
  for (int i = 0; i < 400; ++i) tiny /= 10;
  const DistanceDocument document = unproved::distance(bolza, {TileId(0), {0, 0}}, {TileId(0), {tiny, 0}});
  EXPECT_EQ(document.distance.lower, 0);
  EXPECT_LT(document.distance.upper, 1e-60);
  EXPECT_EQ(verdict(document), "VERIFIED");
}

/// From the centre of an octagon with rational corners, symmetric to rotations by right angles, to the vertex of the
/// surface, which is all corners: four of them are nearest.
TEST(Distance, AllShortestPathsAreFound) {
  const Rational far(5, 6);
  const Rational near(3, 5);
  const std::vector<Complex<Rational>> corners{{far, 0}, {near, near}, {0, far}, {-near, near}};
  Tile tile = corners;
  for (const Complex<Rational>& corner : corners) tile.push_back(-corner);
  const Surface surface({tile}, {{0, 0, 0, 4}, {0, 1, 0, 5}, {0, 2, 0, 6}, {0, 3, 0, 7}});
  const BasePoint centre{TileId(0), {0, 0}};
  for (const Complex<Rational>& corner : tile) {
    const BasePoint end{TileId(0), corner};
    const DistanceDocument document = unproved::distance(surface, centre, end);
    EXPECT_EQ(document.paths.size(), 4U);
    EXPECT_TRUE(document.equal);
    EXPECT_EQ(verdict(document), "VERIFIED");
    EXPECT_NEAR(document.distance.lower, 2 * std::atanh(5.0 / 6), 1e-14);
    // And back, from a vertex that is no point inside of a tile.
    const DistanceDocument back = unproved::distance(surface, end, centre);
    EXPECT_EQ(back.paths.size(), 4U);
    EXPECT_TRUE(back.equal);
    EXPECT_EQ(verdict(back), "VERIFIED");
    EXPECT_EQ(back.distance, document.distance);
  }
  // All corners are one point.
  const DistanceDocument same = unproved::distance(surface, {TileId(0), tile[0]}, {TileId(0), tile[1]});
  EXPECT_EQ(same.distance, (Interval{0, 0}));
  EXPECT_EQ(verdict(same), "VERIFIED");
}

/// A point of a side, exactly: a side is an arc of a circle through rational points orthogonal to the unit circle, and
/// so through the inverse 1/z̄ of its start; a line of rational slope through the start meets it in another one.
Complex<Rational> point_of_side(const Complex<Rational>& from, const Complex<Rational>& to) {
  // The centre c of the circle: 2 Re(c̄z) = 1 + |z|² for both ends.
  const Rational twice = 2 * cross(from, to);
  const Rational a = 1 + norm(from);
  const Rational b = 1 + norm(to);
  const Complex<Rational> centre{(a * to.y - b * from.y) / twice, (b * from.x - a * to.x) / twice};
  // The direction of the middle of the arc, seen from the start, to a few bits.
  const Complex<Mp256> outward = convert<Mp256>(from + Rational(1, 2) * (to - from) - centre);
  const Mp256 radius = sqrt(norm(convert<Mp256>(from - centre)));
  const Complex<Mp256> middle = convert<Mp256>(centre) + Mp256(radius / sqrt(norm(outward))) * outward;
  const Complex<Mp256> aim = middle - convert<Mp256>(from);
  const auto few_bits = [](const Mp256& x) { return Rational(Mp256(ldexp(round(ldexp(x, 20)), -20))); };
  const Complex<Rational> slope{few_bits(aim.x), few_bits(aim.y)};
  // |from + s slope − c|² = |from − c|².
  const Rational s = -2 * dot(from - centre, slope) / norm(slope);
  return from + s * slope;
}

TEST(Distance, OfPointsOnSidesAndCornersOfTiles) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const Surface& surface = named.surface;
    if (surface.is_regular() || surface.genus() > 3) continue;
    const Tile& tile = surface.tiles()[0];
    const BasePoint on_side{TileId(0), point_of_side(tile[0], tile[1])};
    ASSERT_EQ(orientation_determinant(tile[0], tile[1], on_side.z), 0);
    ASSERT_NO_THROW((void)in_its_tile(surface, on_side));
    EXPECT_THROW(require_inside(surface, on_side), SurfaceError);
    const BasePoint corner{TileId(0), tile[1]};
    const BasePoint inside = centre_of_tile(surface, TileId(0));
    for (const auto& [p, q] : {std::pair(on_side, corner), std::pair(corner, on_side), std::pair(on_side, inside)}) {
      const DistanceDocument document = unproved::distance(surface, p, q);
      EXPECT_EQ(verdict(document), "VERIFIED") << named.name;
      EXPECT_LT(document.distance.upper - document.distance.lower, 1e-12) << named.name;
      EXPECT_NEAR(length_of_path(surface, p, q, word_of_letters(document.paths[0])), document.distance.lower, 1e-12)
          << named.name;
    }
    // The same point, as the neighbour has it.
    const SideId side = surface.side_number(TileId(0), 0);
    const BasePoint beyond{surface.tile_of_side(surface.partner(side)), surface.crossing(side)(on_side.z)};
    EXPECT_TRUE(is_same_point(surface, on_side, beyond)) << named.name;
    EXPECT_FALSE(is_same_point(surface, on_side, corner)) << named.name;
    const DistanceDocument same = unproved::distance(surface, on_side, beyond);
    EXPECT_EQ(same.distance, (Interval{0, 0})) << named.name;
    EXPECT_EQ(verdict(same), "VERIFIED") << named.name;
  }
}

TEST(Points, ThatAreManyTilesAwayAreBroughtBackExactly) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const Surface& surface = named.surface;
    if (surface.is_regular() || surface.genus() > 3) continue;
    const BasePoint p = centre_of_tile(surface, TileId(0));
    BasePoint there = p;
    for (std::uint32_t i = 0; i < 50; ++i) {
      const std::uint32_t k = (i % 7) % static_cast<std::uint32_t>(surface.tile(there.tile).size());
      const SideId side = surface.side_number(there.tile, k);
      there = {surface.tile_of_side(surface.partner(side)), surface.crossing(side)(there.z)};
    }
    const BasePoint back = in_its_tile(surface, there);
    EXPECT_EQ(back.tile, p.tile) << named.name;
    EXPECT_EQ(back.z, p.z) << named.name;
    EXPECT_TRUE(is_same_point(surface, p, there)) << named.name;
  }
}

TEST(Distance, OfAPointOutsideOfItsTileIsThatOfThePointInTheTileWhereItLies) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const Surface& surface = named.surface;
    if (surface.is_regular() || surface.genus() > 3) continue;
    const BasePoint p = centre_of_tile(surface, TileId(0));
    const SideId side = surface.side_number(TileId(0), 1);
    const BasePoint q = centre_of_tile(surface, surface.tile_of_side(surface.partner(side)));
    const BasePoint outside{TileId(0), surface.crossing(surface.partner(side))(q.z)};
    const BasePoint back = in_its_tile(surface, outside);
    EXPECT_EQ(back.tile, q.tile) << named.name;
    EXPECT_EQ(back.z, q.z) << named.name;
    const DistanceDocument expected = unproved::distance(surface, p, q);
    for (const auto& [from, to] : {std::pair(p, outside), std::pair(outside, p)}) {
      const DistanceDocument document = unproved::distance(surface, from, to);
      EXPECT_EQ(verdict(document), "VERIFIED") << named.name;
      EXPECT_NEAR(document.distance.lower, expected.distance.lower, 1e-12) << named.name;
    }
  }
}

TEST(Distance, AcrossAThinCuffAndAlongIt) {
  for (const Rational& cuff : {Rational(1, 10'000), Rational(1, 100'000'000), Rational(1, 1'000'000'000'000)}) {
    FenchelNielsen coordinates = random_coordinates(PantsGraph::random(2, 7), 7);
    test::set_cuff_length(coordinates, 1, cuff);
    const Surface surface = fenchel_nielsen_surface(coordinates);
    std::vector<BasePoint> places;
    for (const TileId tile : surface.tile_ids()) places.push_back(centre_of_tile(surface, tile));
    for (const BasePoint& p : places) {
      for (const BasePoint& q : places) {
        const DistanceDocument document = unproved::distance(surface, p, q);
        EXPECT_EQ(verdict(document), "VERIFIED") << cuff;
        EXPECT_LT(document.distance.upper - document.distance.lower, 1e-12);
      }
    }
  }
}

TEST(Distance, ErrorsSayWhichPointAndWhy) {
  const Surface bolza = Surface::regular(2);
  const BasePoint centre{TileId(0), {0, 0}};
  const auto complaint = [&](const BasePoint& point, const DistanceOptions& options = {}) -> std::string {
    try {
      (void)unproved::distance(bolza, centre, point, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint({TileId(1), {0, 0}}), HasSubstr("the point is in tile 1, the surface has 1 tile"));
  EXPECT_THAT(complaint({TileId(0), {1, 0}}), HasSubstr("the point is not inside of the unit disk"));
  EXPECT_THAT(complaint({TileId(0), {2, 0}}), HasSubstr("the point is not inside of the unit disk"));
  EXPECT_EQ(complaint({TileId(0), {Rational(9, 10), 0}}), "") << "beyond a side of the tile";
  EXPECT_THAT(complaint({TileId(0), {Rational(1, 2), 0}}, {.width = 1e-17}), HasSubstr("wider than 1e-17"));
}

TEST(Distance, AVertexOfANetIsAPointOfATile) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const certify::NetDocument net = compute_net(named.surface, Length("0.7")).document;
    const Surface surface = from_document(net.surface);
    for (std::uint32_t v = 0; v < std::min<std::size_t>(net.vertices.size(), 20); ++v) {
      const BasePoint point = point_of_vertex(surface, net, v);
      const BasePoint own = in_its_tile(surface, point);
      EXPECT_TRUE(own.tile == point.tile && own.z == point.z) << named.name;
      EXPECT_NO_THROW(require_on_surface(surface, point)) << named.name;
    }
    EXPECT_THROW((void)point_of_vertex(surface, net, static_cast<std::uint32_t>(net.vertices.size())), NetError);
  }
}

/// The symmetries of the octagon preserve distances on the Bolza surface.
TEST(Distance, OnTheBolzaSurfaceIsSymmetricAndTheLeastThatWordsGive) {
  const Surface bolza = Surface::regular(2);
  const std::vector<Complex<Rational>> places{{0, 0},
                                              {Rational(3, 5), 0},
                                              {Rational(1, 3), Rational(1, 5)},
                                              {Rational(-3, 5), Rational(1, 7)},
                                              {Rational(-2, 5), Rational(-2, 5)},
                                              {Rational(1, 4), Rational(-3, 5)}};
  for (const Complex<Rational>& p : places) {
    for (const Complex<Rational>& q : places) {
      const DistanceDocument document = unproved::distance(bolza, {TileId(0), p}, {TileId(0), q});
      EXPECT_EQ(verdict(document), "VERIFIED");
      EXPECT_NEAR(document.distance.lower, least_by_words(bolza, {TileId(0), p}, {TileId(0), q}, 4), 1e-12);
      const auto turned = [](const Complex<Rational>& z) { return Complex<Rational>{Rational(-z.y), z.x}; };
      const auto mirrored = [](const Complex<Rational>& z) { return Complex<Rational>{z.y, z.x}; };
      EXPECT_EQ(distance_of(bolza, {TileId(0), turned(p)}, {TileId(0), turned(q)}), document.distance);
      EXPECT_EQ(distance_of(bolza, {TileId(0), mirrored(p)}, {TileId(0), mirrored(q)}), document.distance);
    }
  }
}

/// The picture is drawn in the triangulation of the file itself, and in another net of the surface.
TEST(Distance, APictureShowsThePathsInFullLength) {
  const Surface& surface = test::gallery()[1].surface;
  const DistanceDocument document = unproved::distance(surface, {TileId(0), {Rational(1, 10), Rational(-1, 3)}},
                                                       {TileId(0), {Rational(-2, 5), Rational(1, 5)}});
  for (const certify::NetDocument& net : {document.net, compute_net(surface, Length("0.5")).document}) {
    const Layer layer = distance_layer(net, document);
    double length = 0;
    for (const Arc& arc : layer.arcs) length += distance(arc.from, arc.to);
    EXPECT_NEAR(length, document.distance.lower * static_cast<double>(document.paths.size()), 1e-9);
  }
  const certify::NetDocument other = compute_net(test::gallery()[0].surface, Length("0.5")).document;
  EXPECT_THROW((void)distance_layer(other, document), NetGeometryError);
}

/// Edges of a Delaunay triangulation to nearest vertices are shortest (docs/proof.md, Lemma 6).
TEST(Distance, OfAVertexToANearestOneIsTheLengthOfAnEdge) {
  const Surface surface = test::gallery()[0].surface;
  const CertifiedNet net = certified_net(surface, Length("0.8"));
  ASSERT_TRUE(net.certificate.enclosures->shortest_edge.has_value());
  double least = 100;
  std::vector<BasePoint> places;
  for (std::uint32_t v = 0; v < net.document.vertices.size(); ++v)
    places.push_back(point_of_vertex(surface, net.document, v));
  for (const BasePoint& p : places) {
    for (const BasePoint& q : places) {
      if (&p < &q) least = std::min(least, distance_of(surface, p, q).lower);
    }
  }
  EXPECT_NEAR(least, net.certificate.enclosures->shortest_edge->lower, 1e-12);
}

RC_GTEST_PROP(DistanceProperty, IsVerifiedAndThePathsHaveItsLength, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  const BasePoint p = any_place(surface);
  const BasePoint q = any_place(surface);
  const DistanceDocument document = unproved::distance(surface, p, q);
  RC_ASSERT(verdict(document) == "VERIFIED");
  RC_ASSERT(document.distance.upper - document.distance.lower <= 1e-12);
  for (const std::vector<std::uint32_t>& letters : document.paths) {
    const double length = length_of_path(surface, p, q, word_of_letters(letters));
    RC_ASSERT(std::abs(length - document.distance.lower) <= 1e-13 * std::max(1.0, length));
  }
}

RC_GTEST_PROP(DistanceProperty, IsSymmetric, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  const BasePoint p = any_place(surface);
  const BasePoint q = any_place(surface);
  const DistanceDocument there = unproved::distance(surface, p, q);
  const DistanceDocument back = unproved::distance(surface, q, p);
  RC_ASSERT(there.distance == back.distance);
  RC_ASSERT(there.paths.size() == back.paths.size());
  for (const std::vector<std::uint32_t>& letters : back.paths) {
    const double length = length_of_path(surface, p, q, reversed(surface, word_of_letters(letters)));
    RC_ASSERT(std::abs(length - there.distance.lower) <= 1e-13 * std::max(1.0, length));
  }
}

RC_GTEST_PROP(DistanceProperty, SatisfiesTheTriangleInequality, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  const BasePoint p = any_place(surface);
  const BasePoint q = any_place(surface);
  const BasePoint r = any_place(surface);
  const Interval pq = distance_of(surface, p, q);
  const Interval qr = distance_of(surface, q, r);
  const Interval pr = distance_of(surface, p, r);
  RC_ASSERT(pr.lower <= (pq.upper + qr.upper) * (1 + 1e-15));
}

/// A point that moves by δ in its tile changes the distance by at most δ.
RC_GTEST_PROP(DistanceProperty, IsLipschitz, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  const BasePoint p = any_place(surface);
  const BasePoint q = any_place(surface);
  BasePoint moved = q;
  moved.z = Rational(1 - std::ldexp(1.0, -static_cast<int>(any_index(60u)) - 2)) * q.z;
  try {
    require_inside(surface, moved);
  } catch (const SurfaceError&) {
    RC_DISCARD("outside of the tile");
  }
  const auto step = static_cast<double>(distance(convert<Mp256>(q.z), convert<Mp256>(moved.z)));
  const Interval before = distance_of(surface, p, q);
  const Interval after = distance_of(surface, p, moved);
  RC_ASSERT(std::abs(before.lower - after.lower) <= step * (1 + 1e-12) + 1e-14 * std::max(1.0, before.upper));
}

RC_GTEST_PROP(DistanceProperty, IsTheLeastThatWordsGive, ()) {
  const Surface& surface = test::gallery()[any_index(3u)].surface;
  if (surface.genus() != 2 || surface.tiles().size() != 1) RC_DISCARD("not an octagon");
  const BasePoint p = any_place(surface);
  const BasePoint q = any_place(surface);
  const double least = least_by_words(surface, p, q, 4);
  RC_ASSERT(std::abs(least - distance_of(surface, p, q).lower) <= 1e-9);
}

// ---- What is printed ----

/// The decimals of the first "[lower, upper]" after `start` in a text, exactly.
std::pair<mpq_class, mpq_class> ends_after(const std::string& text, const std::string& start) {
  const std::size_t from = text.find("[", text.find(start)) + 1;
  const std::size_t comma = text.find(", ", from);
  const std::size_t to = text.find("]", comma);
  return {certify::parse_decimal(text.substr(from, comma - from)).value(),
          certify::parse_decimal(text.substr(comma + 2, to - comma - 2)).value()};
}

/// Whether a number of 300 digits is in an interval that was printed.
bool is_between(const Mp1024& x, const std::pair<mpq_class, mpq_class>& ends) {
  const auto number = [](const mpq_class& q) { return Mp1024(from_gmp(q)); };
  return number(ends.first) <= x && x <= number(ends.second);
}

/// The circumradius of a triangle of a document, of its definition, with 300 digits.
Mp1024 circumradius(const Surface& surface, const certify::NetDocument& net, std::size_t t) {
  const certify::NetDocument::Triangle& triangle = net.triangles[t];
  std::array<Complex<Mp1024>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const certify::NetDocument::Vertex& v = net.vertices[triangle.vertex[i]];
    const certify::RationalPoint& c = net.charts[v.chart].centre;
    const Complex<Mp1024> centre{Mp1024(from_gmp(c.x)), Mp1024(from_gmp(c.y))};
    corners[i] = Isometry<Mp1024>::translation(centre)(Complex<Mp1024>{Mp1024(v.x), Mp1024(v.y)});
    if (i == 0 || triangle.label[i - 1] == 0) continue;
    for (const SideId side : word_of_letters(net.labels[triangle.label[i - 1] - 1].word))
      corners[i] = surface.crossing_as<Mp1024>(side)(corners[i]);
  }
  const auto sinh2 = sinh2_circumradius(corners[0], corners[1], corners[2]);
  return asinh(sqrt(Mp1024(sinh2.numerator / sinh2.denominator)));
}

RC_GTEST_PROP(PrintedProperty, ContainsTheDistanceAndTheCircumradius, ()) {
  const Surface surface = random_octagon(any_index(1000));
  const BasePoint p = any_place(surface);
  const BasePoint q = any_place(surface);
  const DistanceDocument document = unproved::distance(surface, p, q);
  const certify::Certificate certificate = certify::check(document, {.threads = 1});
  RC_ASSERT(certificate.verdict == certify::Verdict::verified);
  Complex<Mp1024> z = convert<Mp1024>(p.z);
  for (const SideId side : word_of_letters(document.paths.front())) z = surface.crossing_as<Mp1024>(side)(z);
  RC_ASSERT(is_between(distance(z, convert<Mp1024>(q.z)), ends_after(certificate.claim, "lies in ")));
  Mp1024 largest = 0;
  for (std::size_t t = 0; t < document.net.triangles.size(); ++t)
    largest = std::max(largest, circumradius(surface, document.net, t));
  const auto& rules = certificate.rules;
  const auto covering = std::find_if(rules.begin(), rules.end(), [](const auto& r) { return r.rule == "covering"; });
  RC_ASSERT(is_between(largest, ends_after(to_string(*covering), "the largest lies in ")));
}

RC_GTEST_PROP(PrintedProperty, ContainsEpsilon, ()) {
  static const certify::NetDocument net =
      unproved::distance(random_octagon(1), {TileId(0), {0, 0}}, {TileId(0), {Rational(1, 10), Rational(0)}}).net;
  certify::NetDocument document = net;
  document.epsilon = *rc::gen::element(std::string("1"), std::string("2"), std::string("37")) + "." +
                     std::to_string(*rc::gen::inRange<std::uint64_t>(1'000'000'000'000'000, 9'999'999'999'999'999));
  const certify::Certificate certificate = certify::check(document, {.threads = 1});
  RC_ASSERT(certificate.enclosures.has_value());
  const auto [lower, upper] = ends_after(to_string(certificate.enclosures->epsilon), "");
  const mpq_class epsilon = certify::parse_decimal(document.epsilon).value();
  RC_ASSERT(lower <= epsilon);
  RC_ASSERT(epsilon <= upper);
}

}  // namespace
}  // namespace epsnet::distance_test
