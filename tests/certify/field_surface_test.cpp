#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/rules.h"
#include "certify/net/structure.h"
#include "tests/certify/over_field.h"

/// Surfaces over a number field: each is one that is known with rational tiles, or has one clause broken.
namespace epsnet::certify::field_surface_test {
namespace {

using test::has_crossings;
using test::over_field;
using Field = SurfaceDocument::Field;

std::string data(const std::string& name) { return std::string(EPSNET_TEST_DATA) + "/" + name; }

SurfaceDocument octagon() { return read_file<NetDocument>(data("certify/verified/octagon-1-vertex.json")).surface; }
/// Of four tiles.
SurfaceDocument heptagons() {
  return read_file<IsometriesDocument>(data("isometries/fenchel-nielsen-3-1.json")).net.surface;
}

TEST(FieldSurface, IsTheRationalOne) {
  for (const SurfaceDocument& surface : {octagon(), heptagons()}) {
    const SurfaceDocument same = over_field(surface);
    EXPECT_EQ(structure_problem(same), std::nullopt);
    const SurfaceOutcome expected = check_surface(surface);
    const SurfaceOutcome found = check_surface(same);
    EXPECT_EQ(found.report.text, expected.report.text);
    EXPECT_EQ(found.genus, expected.genus);
    const auto& crossings = std::get<FieldCrossings>(found.crossings);
    for (std::uint32_t s = 0; s < crossings.size(); ++s) {
      const BallIsometry f = ball_crossing(expected.crossings, s, 100);
      const BallIsometry g = ball_crossing(found.crossings, s, 100);
      const Precision scope(100);
      // Up to the sign of both numbers.
      const Ball same_sign = norm(f.a + -g.a) + norm(f.b + -g.b);
      const Ball other_sign = norm(f.a + g.a) + norm(f.b + g.b);
      EXPECT_LT(std::min(upper_end(same_sign), upper_end(other_sign)), 1e-50) << s;
    }
    for (std::uint32_t t = 0; t < surface.tiles.size(); ++t) {
      const auto disk = inscribed_disk(surface, t, 256);
      const auto other = inscribed_disk(same, t, 256);
      ASSERT_TRUE(disk && other);
      EXPECT_NEAR(lower_end(disk->sinh_radius), lower_end(other->sinh_radius), 1e-15) << t;
      const mpq_class off =
          mpq_class(disk->centre.n.re, disk->centre.m) - mpq_class(other->centre.n.re, other->centre.m);
      EXPECT_LT(abs(off), 1e-30);
    }
  }
}

/// Every net of the folder on rational tiles has the verdict of the same net over a field.
TEST(FieldSurface, NetsHaveTheVerdictsOfRationalOnes) {
  int compared = 0;
  for (const char* folder : {"certify/verified", "certify/refuted", "forgeries"}) {
    for (const auto& entry : std::filesystem::directory_iterator(data(folder))) {
      if (entry.path().extension() != ".json") continue;
      const ClaimDocument claim = read_file<ClaimDocument>(entry.path());
      const auto* net = std::get_if<NetDocument>(&claim);
      if (net == nullptr || net->surface.tiles.empty() || structure_problem(*net)) continue;
      const Certificate expected = check(claim, {.threads = 1});
      if (!has_crossings(net->surface)) continue;
      NetDocument same = *net;
      same.surface = over_field(net->surface);
      const Certificate found = check(same, {.threads = 1});
      EXPECT_EQ(found.verdict, expected.verdict) << entry.path();
      EXPECT_EQ(found.rule, expected.rule) << entry.path();
      if (expected.rule != "surface") {
        EXPECT_EQ(found.message, expected.message) << entry.path();
      }
      ++compared;
    }
  }
  EXPECT_GE(compared, 30);
}

TEST(FieldSurface, IsTheSameAfterItIsWrittenAndRead) {
  const SurfaceDocument surface = over_field(heptagons());
  std::ostringstream text;
  write_file(surface, text);
  EXPECT_EQ(parse_file<SurfaceDocument>(text.str(), "surface"), surface);
}

/// What rule `surface` says of a surface over a field after a change.
std::string said_of(SurfaceDocument surface, const std::function<void(Field&)>& change) {
  change(surface.field);
  EXPECT_EQ(structure_problem(surface), std::nullopt);
  const RuleReport report = check_surface(surface).report;
  return std::string(name(report.verdict)) + ": " + report.text;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string vertex(std::size_t k, std::size_t t) {
  return "REFUTED: vertex " + std::to_string(k) + " of tile " + std::to_string(t) + " is not inside the light cone";
}

TEST(FieldSurface, EveryVertexIsInsideOfTheLightCone) {
  for (const SurfaceDocument& surface : {over_field(octagon()), over_field(heptagons())}) {
    for (std::size_t t = 0; t < surface.field.polygons.size(); ++t) {
      for (std::size_t k = 0; k < surface.field.polygons[t].size(); ++k) {
        const auto changed = [&](const std::function<void(std::array<SurfaceDocument::FieldNumber, 3>&)>& change) {
          return said_of(surface, [&](Field& field) { change(field.polygons[t][k]); });
        };
        EXPECT_EQ(changed([](auto& v) {
                    for (auto& number : v) {
                      for (mpz_class& x : number) x = -x;
                    }
                  }),
                  vertex(k, t));
        // On the light cone, and outside.
        EXPECT_EQ(changed([](auto& v) { v = {{{3}, {4}, {5}}}; }), vertex(k, t));
        EXPECT_EQ(changed([](auto& v) { v = {{{3}, {4}, {0, 1}}}; }), vertex(k, t));
      }
    }
  }
}

TEST(FieldSurface, EveryNumberOfACrossingCounts) {
  for (const SurfaceDocument& surface : {over_field(octagon()), over_field(heptagons())}) {
    for (std::size_t i = 0; i < surface.gluing.size(); ++i) {
      for (std::size_t part = 0; part < 4; ++part) {
        const std::string said = said_of(surface, [&](Field& field) { field.crossings[i][part][0] += 1; });
        EXPECT_TRUE(says(said, "REFUTED: side ") && says(said, "to which the crossing does not take it")) << said;
      }
      // The inverse of the Lorentz transformation's sign: |a| < |b|.
      const std::string said = said_of(surface, [&](Field& field) {
        auto& [a, a_im, b, b_im] = field.crossings[i];
        std::swap(a, b);
        std::swap(a_im, b_im);
      });
      EXPECT_TRUE(says(said, "to which the crossing does not take it")) << said;
    }
  }
}

/// A crossing followed by a turn about a point.
std::array<SurfaceDocument::FieldNumber, 4> turned(const ExactIsometry& crossing, const ExactPoint& about) {
  const ExactIsometry there = translation_to(about);
  const ExactIsometry f = compose(compose(compose(there, ExactIsometry{{2, 1}, {0, 0}}), inverse(there)), crossing);
  return {test::times_root(f.a.re), test::times_root(f.a.im), test::times_root(f.b.re), test::times_root(f.b.im)};
}

TEST(FieldSurface, CrossingsTakeBothEndsOfASide) {
  const SurfaceDocument rational = octagon();
  const auto corner = [&](std::uint32_t k) { return exact_point(rational.tiles[0][k % 8]); };
  for (std::size_t i = 0; i < rational.gluing.size(); ++i) {
    const auto& [t, k, u, l] = rational.gluing[i];
    const ExactIsometry f = crossing(corner(k), corner(k + 1), corner(l), corner(l + 1));
    for (const std::uint32_t end : {l, l + 1}) {
      const std::string said =
          said_of(over_field(rational), [&](Field& field) { field.crossings[i] = turned(f, corner(end)); });
      EXPECT_TRUE(says(said, "to which the crossing does not take it")) << said;
    }
  }
}

// Reflected in an axis of the disk, the image has one of its two coordinates right, and is as long.
TEST(FieldSurface, CrossingsTakeASideToThePartnerAndNotToAReflectionOfIt) {
  // Partners are the sides with the larger numbers: the lower half of the tile, then the upper half.
  for (const std::ptrdiff_t first : {0, 4}) {
    SurfaceDocument rational = octagon();
    std::rotate(rational.tiles[0].begin(), rational.tiles[0].begin() + first, rational.tiles[0].end());
    for (const int axis : {0, 1}) {
      const auto corner = [&](std::uint32_t k) { return exact_point(rational.tiles[0][k % 8]); };
      const auto reflected = [&](std::uint32_t k) {
        RationalPoint z = rational.tiles[0][k % 8];
        (axis == 0 ? z.y : z.x) *= -1;
        return exact_point(z);
      };
      for (std::size_t i = 0; i < rational.gluing.size(); ++i) {
        const auto& [t, k, u, l] = rational.gluing[i];
        const ExactIsometry f = crossing(corner(k), corner(k + 1), reflected(l), reflected(l + 1));
        const std::string said = said_of(over_field(rational), [&](Field& field) {
          field.crossings[i] = {test::times_root(f.a.re), test::times_root(f.a.im), test::times_root(f.b.re),
                                test::times_root(f.b.im)};
        });
        EXPECT_TRUE(says(said, "to which the crossing does not take it")) << said;
      }
    }
  }
}

TEST(FieldSurface, TheRootIsTheOneOfItsInterval) {
  const SurfaceDocument surface = over_field(octagon());
  const auto with = [&](std::vector<mpz_class> polynomial, const mpq_class& lower, const mpq_class& upper) {
    return said_of(surface, [&](Field& field) {
      field.polynomial = std::move(polynomial);
      field.root = {lower, upper};
    });
  };
  EXPECT_TRUE(says(with({-2, 0, 1}, 1, {3, 2}), "VERIFIED"));
  EXPECT_EQ(with({-2, 0, 1}, {3, 2}, 2), "REFUTED: the polynomial has no root in the interval");
  EXPECT_EQ(with({2, -3, 1}, 0, 3).substr(0, 35), "UNDECIDED: the polynomial may have ");
  EXPECT_EQ(with({4, 0, -4, 0, 1}, 1, 2).substr(0, 35), "UNDECIDED: the polynomial may have ");
  // −√2: vertices times 2 − √2 > 0 and crossings times −√2 are the same ones.
  EXPECT_TRUE(says(with({-2, 0, 1}, -2, -1), "VERIFIED"));
  // √3: they are not the same vectors, but multiples.
  EXPECT_TRUE(says(with({-3, 0, 1}, 1, 2), "VERIFIED"));
}

TEST(FieldSurface, ThePolynomialIsMonicOfDegree1To64) {
  for (const std::size_t degree : {1U, 2U, 63U, 64U, 65U}) {
    std::vector<mpz_class> polynomial(degree + 1, -2);
    for (const int last : {-1, 0, 1, 2}) {
      polynomial.back() = last;
      EXPECT_EQ(polynomial_problem(polynomial), degree > 64 ? "66 coefficients, expected 2 to 65"
                                                : last != 1 ? Problem("the last coefficient is not 1")
                                                            : std::nullopt);
    }
  }
  EXPECT_TRUE(polynomial_problem({1}).has_value());
  EXPECT_TRUE(polynomial_problem({}).has_value());
}

TEST(FieldSurface, HasAStructure) {
  const SurfaceDocument surface = over_field(octagon());
  const auto problem = [&](const std::function<void(SurfaceDocument&)>& change) {
    SurfaceDocument changed = surface;
    change(changed);
    return structure_problem(changed).value_or("none");
  };
  EXPECT_EQ(problem([](auto&) {}), "none");
  EXPECT_EQ(problem([](auto& s) { s.field.polynomial = {1}; }), "surface.polynomial: 1 coefficients, expected 2 to 65");
  EXPECT_EQ(problem([](auto& s) {
              s.field.polynomial = {-2, 0, 2};
            }),
            "surface.polynomial: the last coefficient is not 1");
  EXPECT_EQ(problem([](auto& s) { s.field.root = {1, 1}; }), "surface.root: the ends of the interval are not in order");
  const auto counts = [&](const std::string& row, const auto& number_of) {
    for (const std::size_t size : {1U, 2U}) EXPECT_EQ(problem([&](auto& s) { number_of(s).resize(size); }), "none");
    for (const std::size_t size : {0U, 3U}) {
      EXPECT_EQ(problem([&](auto& s) { number_of(s).resize(size); }),
                row + ": a number of the field has " + std::to_string(size) + " coefficients, expected 1 to 2");
    }
  };
  for (std::size_t k = 0; k < 8; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      counts(
          "surface.polygons[0]", [&](auto& s) -> auto& { return s.field.polygons[0][k][i]; });
    }
  }
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t i = 0; i < 4; ++i) {
      counts(
          "surface.crossings[" + std::to_string(row) + "]", [&](auto& s) -> auto& {
            return s.field.crossings[row][i];
          });
    }
  }
  EXPECT_EQ(problem([](auto& s) { s.field.crossings.pop_back(); }),
            "surface.crossings: 3 rows, expected 4, as gluing has");
  EXPECT_EQ(problem([](auto& s) { s.field.crossings.push_back(s.field.crossings[0]); }),
            "surface.crossings: 5 rows, expected 4, as gluing has");
  EXPECT_EQ(problem([](auto& s) { s.field.polygons[0].resize(2); }),
            "surface.polygons[0]: has 2 vertices, expected at least 3");
  EXPECT_EQ(problem([](auto& s) { s.tiles = octagon().tiles; }), "surface: tiles of two kinds, expected one");
  EXPECT_EQ(problem([](auto& s) { s.regular_genus = 2; }), "surface: tiles of two kinds, expected one");
  EXPECT_EQ(problem([](auto& s) { s.map_tile = {8, 8}; }), "surface: tiles of two kinds, expected one");
}

}  // namespace
}  // namespace epsnet::certify::field_surface_test
