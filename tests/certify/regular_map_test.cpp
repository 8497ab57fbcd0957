#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/net/structure.h"

/// Surfaces of the kind "map": regular tiles, glued in any way that q of them meet at every vertex.
namespace epsnet::certify::regular_map_test {
namespace {

NetDocument file(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

/// {10, 5}, genus 2: one decagon, opposite sides glued.
SurfaceDocument decagon() {
  SurfaceDocument surface;
  surface.map_tile = {10, 5};
  for (std::uint32_t k = 0; k < 5; ++k) surface.gluing.push_back({0, k, 0, k + 5});
  return surface;
}

/// {7, 3}, genus 3: 24 heptagons.
SurfaceDocument klein() { return file("map-klein.json").surface; }

std::string problem(const SurfaceDocument& surface) { return structure_problem(surface).value_or("none"); }

std::string refuted(const SurfaceDocument& surface) {
  EXPECT_EQ(problem(surface), "none");
  const SurfaceOutcome outcome = check_surface(surface);
  EXPECT_EQ(outcome.report.verdict, Verdict::refuted);
  return outcome.report.text;
}

TEST(RegularMaps, AreSurfacesByCounting) {
  const SurfaceOutcome one = check_surface(decagon());
  EXPECT_EQ(one.report.verdict, Verdict::verified);
  EXPECT_EQ(one.genus, 2U);
  const SurfaceOutcome many = check_surface(klein());
  EXPECT_EQ(many.report.verdict, Verdict::verified);
  EXPECT_EQ(many.genus, 3U);
  EXPECT_EQ(many.report.text,
            "a closed hyperbolic surface of genus 3: 24 times the regular 7-gon with interior angles 2*pi/3, 3 corners "
            "around every vertex");
}

TEST(RegularMaps, AVertexWithAnotherNumberOfCornersIsRefuted) {
  SurfaceDocument surface = klein();
  surface.map_tile.q = 4;
  EXPECT_EQ(refuted(surface), "3 corners meet at vertex 0 of tile 0, expected q = 4");
  surface = klein();
  // Two rows exchange their ends: a permutation without fixed sides as before, but not the same vertices.
  std::swap(surface.gluing[0].other_side, surface.gluing[1].other_side);
  std::swap(surface.gluing[0].other_tile, surface.gluing[1].other_tile);
  EXPECT_NE(refuted(surface).find("corners meet at vertex"), std::string::npos);
}

/// All ways to glue the sides that are left of one polygon in pairs.
void for_each_gluing(std::vector<std::uint32_t> left, SurfaceDocument& surface,
                     const std::function<void(const SurfaceDocument&)>& body) {
  if (left.empty()) return body(surface);
  for (std::size_t k = 1; k < left.size(); ++k) {
    std::vector<std::uint32_t> others = left;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    others.erase(others.begin());
    surface.gluing.push_back({0, left[0], 0, left[k]});
    for_each_gluing(others, surface, body);
    surface.gluing.pop_back();
  }
}

TEST(RegularMaps, OfOneDecagonHaveTheSameNumberOfCornersAroundEveryVertex) {
  std::map<std::size_t, int> met;
  SurfaceDocument surface;
  const auto ask = [&](const SurfaceDocument& glued) {
    // Corner k is where side k begins. Side k from there is the end of its partner l, so corner l + 1.
    std::array<std::uint32_t, 10> next{};
    for (const auto& [t, k, u, l] : glued.gluing) {
      next[k] = (l + 1) % 10;
      next[l] = (k + 1) % 10;
    }
    std::multiset<std::uint32_t> corners;
    for (std::uint32_t k = 0; k < 10; ++k) {
      std::uint32_t around = 1;
      for (std::uint32_t c = next[k]; c != k; c = next[c]) ++around;
      corners.insert(around);
    }
    const std::uint32_t q = glued.map_tile.q;
    const SurfaceOutcome outcome = check_surface(glued);
    const bool regular = corners.count(q) == 10;
    ASSERT_EQ(outcome.report.verdict, regular ? Verdict::verified : Verdict::refuted) << outcome.report.text;
    if (regular) {
      // V − 5 + 1 = 2 − 2g.
      EXPECT_EQ(outcome.genus, (6 - 10 / q) / 2);
    }
    ++met[regular ? 10 : corners.count(q) == 0 ? 0 : 1];
  };
  for (std::uint32_t q = 3; q <= 10; ++q) {
    surface.map_tile = {10, q};
    for_each_gluing({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, surface, ask);
  }
  for (const std::size_t kind : {0U, 1U, 10U}) EXPECT_GT(met[kind], 0) << kind;
}

TEST(RegularMaps, AreHyperbolic) {
  // The sphere with the faces of a cube has three squares around each corner, and the torus four.
  SurfaceDocument torus;
  torus.map_tile = {4, 4};
  torus.gluing = {{0, 0, 0, 2}, {0, 1, 0, 3}};
  EXPECT_EQ(refuted(torus),
            "there is no hyperbolic regular 4-gon with interior angles 2*pi/4: 1/p + 1/q is not less than 1/2");
  for (const std::uint32_t p : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 100U, ~0U}) {
    for (const std::uint32_t q : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 100U, ~0U}) {
      const bool hyperbolic = p > 0 && q > 0 && mpq_class(1, p) + mpq_class(1, q) < mpq_class(1, 2);
      EXPECT_EQ((RegularTile{p, q}.is_hyperbolic()), hyperbolic) << p << ", " << q;
    }
  }
}

TEST(RegularMaps, AreConnected) {
  SurfaceDocument surface = decagon();
  for (std::uint32_t k = 0; k < 5; ++k) surface.gluing.push_back({1, k, 1, k + 5});
  EXPECT_EQ(refuted(surface), "the surface is not connected: no path of glued sides leads from tile 0 to tile 1");
}

TEST(RegularMaps, WithoutStructureAreNone) {
  SurfaceDocument surface = decagon();
  surface.gluing[3] = {0, 3, 0, 3};
  EXPECT_EQ(problem(surface), "surface.gluing[3]: side 3 of tile 0 occurs twice, expected every side once");
  surface = decagon();
  surface.gluing[4] = {0, 4, 0, 8};
  EXPECT_EQ(problem(surface), "surface.gluing[4]: side 8 of tile 0 occurs twice, expected every side once");
  surface = decagon();
  surface.gluing[2].other_side = 10;
  EXPECT_EQ(problem(surface), "surface.gluing[2]: side 10 does not exist, expected less than 10");
  surface = decagon();
  surface.gluing[2].other_tile = 1;
  EXPECT_EQ(problem(surface), "surface.gluing[2]: tile 1 does not exist, expected less than 1");
  surface = decagon();
  surface.gluing.pop_back();
  EXPECT_EQ(problem(surface), "surface.gluing: 8 sides occur, expected a multiple of 10");
  surface.gluing.clear();
  EXPECT_EQ(problem(surface), "surface.gluing: no row, expected at least one");
  for (const std::uint32_t number : {3U, 4U, 9'999U, 10'000U}) EXPECT_EQ(map_number_problem(number), std::nullopt);
  for (const std::uint32_t number : {1U, 2U, 10'001U, ~0U}) {
    const std::string found = std::to_string(number) + " found, expected at least 3 and at most 10000";
    surface = decagon();
    surface.map_tile.p = number;
    EXPECT_EQ(problem(surface), "surface.p: " + found);
    surface = decagon();
    surface.map_tile.q = number;
    EXPECT_EQ(problem(surface), "surface.q: " + found);
  }
  surface = decagon();
  surface.tiles.emplace_back(10);
  EXPECT_EQ(problem(surface), "surface.tiles: a map has none");
}

RegularNumber integer(const RegularRing& ring, long value) { return regular_number(ring, {value, 0}); }

bool is_zero(const RegularNumber& x) { return sign(norm(x)) == 0; }

/// Up to a positive factor.
bool same(const Isometry<RegularNumber>& f, const Isometry<RegularNumber>& g) {
  const RegularNumber quotient = f.a * conjugate(g.a);
  return is_zero(f.a * g.b - f.b * g.a) && sign(twice_imaginary(quotient)) == 0 && sign(twice_real(quotient)) == 1 &&
         sign(twice_imaginary(f.b * conjugate(g.b))) == 0;
}

TEST(RegularMaps, TurnsAreProductsOfCrossings) {
  for (const SurfaceDocument& surface : {decagon(), klein(), file("map-bring.json").surface}) {
    const SurfaceSides sides(surface);
    const RegularCrossings crossings(surface.map_tile, sides.partner);
    for (std::uint32_t first = 0; first < sides.partner.size(); first += 3) {
      for (const Turn turn : {Turn::clockwise, Turn::counterclockwise}) {
        SCOPED_TRACE(std::to_string(surface.map_tile.p) + ", side " + std::to_string(first));
        std::uint32_t side = first;
        auto product = crossings.turn(first, 1, Turn::clockwise);
        for (std::uint32_t count = 1; count <= surface.map_tile.q + 1; ++count) {
          EXPECT_TRUE(same(crossings.turn(first, count, turn), product)) << count;
          EXPECT_EQ(is_zero(product.b), count == surface.map_tile.q) << count;
          side = turn == Turn::clockwise ? sides.next_around(side) : sides.previous[sides.partner[side]];
          product = compose(crossings.turn(side, 1, Turn::clockwise), product);
        }
      }
    }
  }
}

TEST(RegularMaps, BallsContainTheExactCrossings) {
  for (const SurfaceDocument& surface : {decagon(), klein()}) {
    const SurfaceSides sides(surface);
    const RegularCrossings crossings(surface.map_tile, sides.partner);
    const RegularRing& ring = crossings.ring();
    for (std::uint32_t side = 0; side < sides.partner.size(); ++side) {
      const Precision scope(64);
      const BallIsometry balls = crossings.balls(side, 64);
      const Isometry<RegularNumber> exact = crossings.exact(std::array{side});
      // a conj(exact.a) > 0 in balls of the one and of the other: the quotient b/a is the same number.
      const auto value = [&](const RegularNumber& x) {
        const auto part = [&](const Polynomial& p) {
          ComplexBall sum;
          for (slong k = 0; k < fmpz_poly_length(p.get()); ++k) {
            sum = sum + Ball::exactly(fmpz_poly_get_coeff_si(p.get(), k)) *
                            root_of_unity(static_cast<std::uint32_t>(k), ring.order());
          }
          return sum;
        };
        return part(x.u) + sqrt(real(part(ring.square_of_s()))) * part(x.v);
      };
      const ComplexBall difference = value(exact.b) * balls.a + -(value(exact.a) * balls.b);
      EXPECT_TRUE(arb_contains_zero(difference.re()) && arb_contains_zero(difference.im())) << side;
      EXPECT_LT(mag_get_d(arb_radref(difference.re())), 1e-9);
      const ComplexBall same_direction = value(exact.a) * conjugate(balls.a);
      EXPECT_EQ(certainly_positive(real(same_direction)), Tri::yes);
      EXPECT_TRUE(arb_contains_zero(same_direction.im()));
    }
  }
}

TEST(RegularMaps, PowersMayBeOddWhereSidesOfOneParityAreGluedToTheOther) {
  // An octagon of type {8, 8} with opposite sides glued, all of whose crossings have even powers, and one with pairs
  // of sides whose numbers have an odd sum. Its one vertex makes eight ties, which are exact.
  NetDocument net = file("map-of-one-octagon-with-odd-sums-of-sides.json");
  const Certificate certificate = check(net);
  EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
  EXPECT_EQ(certificate.ties.size(), 5U);
  EXPECT_EQ(std::count_if(net.surface.gluing.begin(), net.surface.gluing.end(),
                          [](const auto& row) { return (row.side + row.other_side) % 2 != 0; }),
            2);
  const auto order = [](const SurfaceDocument& surface) {
    return RegularCrossings(surface.map_tile, SurfaceSides(surface).partner).ring().order();
  };
  EXPECT_EQ(order(net.surface), 16U);
  net.surface.gluing.clear();
  for (std::uint32_t k = 0; k < 4; ++k) net.surface.gluing.push_back({0, k, 0, k + 4});
  EXPECT_EQ(order(net.surface), 8U);
}

TEST(RegularMaps, TheRootMayBeANumberOfTheField) {
  // {4, 6} and {6, 10} have s = 2 sin(π/q)·2 sin(π/p) sinh ρ = 1; the sign of u + vs is exact all the same.
  const auto crossings_of = [](std::uint32_t p, std::uint32_t q) { return RegularCrossings({p, q}, {}); };
  for (const auto& [p, q] : {std::pair{4U, 6U}, std::pair{6U, 10U}}) {
    const RegularCrossings crossings = crossings_of(p, q);
    const RegularRing& ring = crossings.ring();
    EXPECT_FALSE(ring.has_new_root());
    const RegularNumber s = regular_number(ring, {}, std::array{PowerOfZeta{1, 0}});
    EXPECT_EQ(sign(s - integer(ring, 1)), 0);
    EXPECT_EQ(sign(integer(ring, 1) - s), 0);
    EXPECT_EQ(sign(s + integer(ring, 1)), 1);
    EXPECT_EQ(sign(integer(ring, -1) - s), -1);
    EXPECT_EQ(sign(s - integer(ring, 2)), -1);
    EXPECT_EQ(sign(mpz_class(3) * s - integer(ring, 2)), 1);
    EXPECT_EQ(sign(s), 1);
    EXPECT_EQ(sign(s - s), 0);
  }
  for (const auto& [p, q] : {std::pair{7U, 3U}, std::pair{8U, 8U}, std::pair{5U, 4U}, std::pair{402U, 201U}}) {
    EXPECT_TRUE(crossings_of(p, q).ring().has_new_root()) << p;
  }
}

TEST(RegularMaps, OfOnePolygonWithOppositeSidesGluedIsTheRegularSurface) {
  const NetDocument regular = file("regular-2-4-rotated-vertices.json");
  NetDocument map = regular;
  map.surface.regular_genus = 0;
  map.surface.map_tile = {8, 8};
  for (std::uint32_t k = 0; k < 4; ++k) map.surface.gluing.push_back({0, k, 0, k + 4});
  const Certificate certificate = check(map);
  EXPECT_EQ(certificate.verdict, Verdict::verified);
  EXPECT_EQ(certificate.ties, check(regular).ties);
}

}  // namespace
}  // namespace epsnet::certify::regular_map_test
