#include "netgen/nets/dirichlet_polygon.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "certify/check.h"
#include "kernel/plane.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"

namespace epsnet::dirichlet_polygon_test {
namespace {

/// The area of a convex polygon around 0.
double area(const std::vector<Complex<double>>& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Complex<double>& u = polygon[k];
    const Complex<double>& v = polygon[(k + 1) % polygon.size()];
    sum += 2 * std::atan2(cross(u, v), 1 - dot(u, v));
  }
  return sum;
}

void expect_dirichlet(const DirichletPolygon& polygon, std::uint32_t genus, const std::string& name) {
  const std::size_t n = polygon.sides.size();
  ASSERT_EQ(polygon.vertices.size(), n);
  // A vertex for every triangle of the one-vertex triangulation, 4g − 2 times 3 corners, less the ties.
  EXPECT_EQ(n, 12 * genus - 6 - 2 * polygon.ties) << name;
  EXPECT_NEAR(area(polygon.vertices), 4 * std::numbers::pi * (genus - 1), 1e-7) << name;
  for (std::size_t k = 0; k < n; ++k) {
    const DirichletPolygon::Side& side = polygon.sides[k];
    ASSERT_LT(side.partner, n);
    const DirichletPolygon::Side& partner = polygon.sides[side.partner];
    EXPECT_EQ(partner.partner, k) << name;
    EXPECT_NE(side.partner, k) << name;
    EXPECT_NEAR(partner.distance, side.distance, 1e-9) << name;
    // Paired sides have equal lengths.
    const auto length = [&](std::size_t s) { return distance(polygon.vertices[s], polygon.vertices[(s + 1) % n]); };
    EXPECT_NEAR(length(k), length(side.partner), 1e-6) << name;
  }
}

/// The words are the pairings, evaluated with 1024 bits: γ0 is at twice the distance of the side, in the direction of
/// its middle; partners have inverse words; and 0 is no nearer to any corner than what γ makes of it.
void expect_words(const DirichletPolygon& polygon, const Surface& surface, const Complex<Rational>& base,
                  const std::string& name) {
  const auto to_base = Isometry<Mp1024>::translation(convert<Mp1024>(-base));
  const std::size_t n = polygon.sides.size();
  for (std::size_t k = 0; k < n; ++k) {
    Isometry<Mp1024> gamma;
    for (const SideId s : polygon.sides[k].word) gamma = surface.crossing_as<Mp1024>(s) * gamma;
    const auto lift = convert<double>(to_base(gamma(convert<Mp1024>(base))));
    EXPECT_NEAR(distance(Complex<double>{}, lift), 2 * polygon.sides[k].distance, 1e-6) << name;
    for (const std::size_t end : {k, (k + 1) % n}) {
      const Complex<double>& corner = polygon.vertices[end];
      EXPECT_NEAR(distance(corner, lift), distance(corner, Complex<double>{}), 1e-5) << name;
    }
    EXPECT_EQ(concatenated(surface, polygon.sides[k].word, polygon.sides[polygon.sides[k].partner].word), Word{});
  }
}

/// Proves the triangulation that gives the sides, and counts its ties.
void expect_proved(const DirichletPolygon& polygon, const std::string& name) {
  const certify::Certificate certificate = certify::check(polygon.triangulation);
  EXPECT_EQ(certificate.verdict, certify::Verdict::verified) << name << ": " << certificate.message;
  EXPECT_EQ(certificate.counts.exact_ties, polygon.ties) << name;
  EXPECT_EQ(polygon.triangulation.vertices.size(), 1U);
}

TEST(DirichletPolygon, ClosesUpOnEveryThickSurface) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    if (named.name.find("thin") == std::string::npos && named.name.find("short") == std::string::npos &&
        named.surface.genus() < 6) {
      expect_dirichlet(dirichlet_polygon(named.surface, std::nullopt), named.surface.genus(), named.name);
    }
  }
}

TEST(DirichletPolygon, OfARegularSurfaceIsItsPolygon) {
  for (const std::uint32_t genus : {2u, 3u, 10u}) {
    const Surface surface = Surface::regular(genus);
    const DirichletPolygon polygon = dirichlet_polygon(surface, std::nullopt);
    expect_proved(polygon, "regular");
    expect_words(polygon, surface, {}, "regular");
    EXPECT_EQ(polygon.sides.size(), 4 * genus);
    EXPECT_EQ(polygon.ties, 4 * genus - 3);
    expect_dirichlet(polygon, genus, "regular");
    for (std::size_t k = 0; k < polygon.sides.size(); ++k) {
      EXPECT_EQ(polygon.sides[k].partner, (k + 2 * genus) % (4 * genus));
      EXPECT_EQ(polygon.sides[k].word.size(), 1U) << "across one side";
      EXPECT_NEAR(std::cosh(polygon.sides[k].distance), 1 / std::tan(std::numbers::pi / (4 * genus)), 1e-12);
    }
  }
}

TEST(DirichletPolygon, HasTiesAtAPointOnAnAxisOfSymmetryAlone) {
  for (const std::uint32_t genus : {2u, 5u}) {
    const Surface surface = Surface::regular(genus);
    // A point on an axis of symmetry has ties, another one has none.
    std::vector<std::uint32_t> ties;
    for (const Complex<Rational>& base :
         {Complex<Rational>{Rational(1, 4), Rational(0)}, {Rational(3, 10), Rational(-1, 5)}}) {
      const DirichletPolygon polygon = dirichlet_polygon(surface, BasePoint{TileId(0), base});
      expect_dirichlet(polygon, genus, "regular");
      expect_proved(polygon, "regular");
      expect_words(polygon, surface, base, "regular");
      ties.push_back(polygon.ties);
    }
    EXPECT_GT(ties[0], 0U);
    EXPECT_EQ(ties[1], 0U);
  }
}

TEST(DirichletPolygon, LooksTheSameFromPointsThatASymmetryExchanges) {
  const Surface bolza = Surface::regular(2);
  const DirichletPolygon one = dirichlet_polygon(bolza, BasePoint{TileId(0), {Rational(1, 4), Rational(1, 7)}});
  const DirichletPolygon quarter_turn =
      dirichlet_polygon(bolza, BasePoint{TileId(0), {Rational(-1, 7), Rational(1, 4)}});
  const auto distances = [](const DirichletPolygon& polygon) {
    std::vector<double> result;
    for (const DirichletPolygon::Side& side : polygon.sides) result.push_back(side.distance);
    std::sort(result.begin(), result.end());
    return result;
  };
  const std::vector<double> expected = distances(one);
  const std::vector<double> found = distances(quarter_turn);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12);
}

TEST(DirichletPolygon, BaseOfASymmetricOctagonIsItsCentre) {
  const DirichletPolygon polygon = dirichlet_polygon(random_octagon(123), BasePoint{TileId(0), {0, 0}});
  expect_dirichlet(polygon, 2, "octagon");
  expect_proved(polygon, "octagon");
  expect_words(polygon, random_octagon(123), {}, "octagon");
  // Symmetric with respect to the centre.
  const std::size_t n = polygon.sides.size();
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_NEAR(polygon.sides[k].distance, polygon.sides[(k + n / 2) % n].distance, 1e-12);
  }
}

TEST(DirichletPolygon, IsProvedForABasePointThatIsNoVertex) {
  const Surface surface = random_octagon(7);
  const Complex<Rational> base{Rational(1, 10), Rational(-1, 3)};
  const DirichletPolygon polygon = dirichlet_polygon(surface, BasePoint{TileId(0), base});
  expect_dirichlet(polygon, 2, "base point");
  expect_proved(polygon, "base point");
  expect_words(polygon, surface, base, "base point");
}

TEST(DirichletPolygon, IsProvedInAThinCollar) {
  // A cuff of length 1/1000, in whose collar the domain is long and narrow.
  FenchelNielsen coordinates = random_coordinates(PantsGraph::parse("0-1 0-1 0-1"), 3);
  coordinates.lengths[1] = Rational(1, 1000);
  const DirichletPolygon polygon = dirichlet_polygon(fenchel_nielsen_surface(coordinates), std::nullopt);
  EXPECT_EQ(polygon.sides.size(), 18U - 2 * polygon.ties);
  expect_proved(polygon, "thin");
}

TEST(DirichletPolygon, SidesAreExactWhereBinary64HoldsNoVertex) {
  // Vertices may be nearer than e^-100 to the boundary of the disk, too near for binary64; sides and distances are not.
  const Rational length(1, boost::multiprecision::pow(boost::multiprecision::mpz_int(10), 20));
  const Surface surface =
      fenchel_nielsen_surface({PantsGraph::parse("0-0 0-1 1-1"), {1, length, 2}, {Rational(1, 10), 0, Rational(1, 2)}});
  const DirichletPolygon polygon = dirichlet_polygon(surface, std::nullopt);
  expect_proved(polygon, "very short");
  ASSERT_EQ(polygon.sides.size(), 18 - 2 * polygon.ties);
  for (std::size_t k = 0; k < polygon.sides.size(); ++k) {
    const DirichletPolygon::Side& partner = polygon.sides[polygon.sides[k].partner];
    EXPECT_EQ(partner.partner, k);
    EXPECT_NEAR(partner.distance, polygon.sides[k].distance, 1e-9);
  }
}

/// Whether two words are paths from tile 0 to the same tile, and the same element.
bool same_path(const Surface& surface, const Word& u, const Word& v) {
  const TileId end = u.empty() ? TileId(0) : surface.tile_of_side(surface.partner(u.back()));
  if (!is_path(surface, TileId(0), end, u) || !is_path(surface, TileId(0), end, v)) return false;
  const Isometry<Mp1024> quotient = isometry_of(surface, u) * inverse(isometry_of(surface, v));
  return norm(quotient.b) < ldexp(Mp1024(1), -500);
}

TEST(Words, AroundATileAgainAndAgainAreShort) {
  const Surface klein = named_surface("klein");  // Three heptagons meet at every vertex.
  // Across side 0, and around tile 0 through its neighbours: each is entered beside the side that leads back to tile 0.
  Word word{SideId(0)};
  SideId home = klein.partner(word[0]);
  for (int i = 0; i < 30 * 7 + 3; ++i) {
    word.push_back(klein.previous_side(home));
    home = klein.previous_side(klein.partner(word.back()));
  }
  const Word shorter = concatenated(klein, {}, word);
  EXPECT_LE(shorter.size(), 64U);
  EXPECT_TRUE(same_path(klein, word, shorter));
}

RC_GTEST_PROP(WordsProperty, OfTrivalentMapsStayTheSameElement, ()) {
  static const Surface surfaces[] = {named_surface("klein"), named_surface("fricke-macbeath"),
                                     named_surface("fermat-quartic")};
  const Surface& surface = surfaces[test::any_index(3u)];
  // Mostly along rows of tiles: the exit is two or three sides from the entry.
  Word word{SideId(test::any_index(surface.regular_tile()->p))};
  const auto length = test::any_index<std::size_t>(200);
  while (word.size() < length) {
    SideId s = surface.partner(word.back());
    const std::uint32_t steps = test::any_index(8u) == 0 ? 4 : 2 + test::any_index(2u);
    for (std::uint32_t i = 0; i < steps; ++i) s = surface.next_side(s);
    word.push_back(s);
  }
  const Word shorter = concatenated(surface, {}, word);
  RC_ASSERT(shorter.size() <= word.size());
  RC_ASSERT(same_path(surface, word, shorter));
}

TEST(DirichletPolygon, OfTheFrickeMacbeathCurveFromAnyTile) {
  const Surface surface = named_surface("fricke-macbeath");
  const DirichletPolygon first = dirichlet_polygon(surface, centre_of_tile(surface, TileId(0)));
  expect_dirichlet(first, 7, "0");
  // All tiles are the same under isometries.
  const DirichletPolygon other = dirichlet_polygon(surface, centre_of_tile(surface, TileId(50)));
  EXPECT_EQ(other.sides.size(), first.sides.size());
  EXPECT_EQ(other.ties, first.ties);
}

TEST(DirichletPolygon, JsonHasEverySide) {
  const std::string json = dirichlet_json(dirichlet_polygon(Surface::regular(2), std::nullopt));
  EXPECT_EQ(json.rfind("{\"format\": \"epsnet-dirichlet\", \"version\": 1,", 0), 0U);
  EXPECT_NE(json.find("\"ties\": 5"), std::string::npos);
  EXPECT_NE(json.find("\"partner\": 7"), std::string::npos);
}

TEST(DirichletPolygon, JsonReadsBackTheSame) {
  for (const Surface& surface : {Surface::regular(2), random_octagon(123)}) {
    const std::string json = dirichlet_json(dirichlet_polygon(surface, std::nullopt));
    EXPECT_EQ(dirichlet_json(parse_dirichlet_json(json, "test")), json);
    // A truncated text is not JSON; a text with a changed number is another domain, or none.
    EXPECT_THROW((void)parse_dirichlet_json(std::string_view(json).substr(0, json.size() - 3), "test"),
                 DirichletFileError);
  }
  for (const char* text : {"", "[]", "{}", "1", "{\"format\": \"epsnet-net\"}", "\xff"}) {
    try {
      (void)parse_dirichlet_json(text, "test");
      ADD_FAILURE() << text;
    } catch (const DirichletFileError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("test: ", 0), 0U) << error.what();
    }
  }
}

}  // namespace
}  // namespace epsnet::dirichlet_polygon_test
