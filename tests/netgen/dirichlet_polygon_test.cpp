#include "epsnet/netgen/dirichlet_polygon.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "epsnet/kernel/plane.h"
#include "support/triangulations.h"

namespace epsnet {
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

TEST(DirichletPolygon, OfEverySurface) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    if (named.name.find("thin") == std::string::npos && named.name.find("short") == std::string::npos &&
        named.surface.genus() < 6) {
      expect_dirichlet(dirichlet_polygon(named.surface, std::nullopt), named.surface.genus(), named.name);
    }
  }
}

TEST(DirichletPolygon, OfARegularSurfaceIsItsPolygon) {
  for (const std::uint32_t genus : {2u, 3u, 5u}) {
    const DirichletPolygon polygon = dirichlet_polygon(Surface::regular(genus), std::nullopt);
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

TEST(DirichletPolygon, BaseOfASymmetricOctagonIsItsCentre) {
  const DirichletPolygon polygon = dirichlet_polygon(random_octagon(123), BasePoint{0, {0, 0}});
  expect_dirichlet(polygon, 2, "octagon");
  // Symmetric with respect to the centre.
  const std::size_t n = polygon.sides.size();
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_NEAR(polygon.sides[k].distance, polygon.sides[(k + n / 2) % n].distance, 1e-12);
  }
}

TEST(DirichletPolygon, JsonHasEverySide) {
  const std::string json = dirichlet_json(dirichlet_polygon(Surface::regular(2), std::nullopt));
  EXPECT_EQ(json.rfind("{\"format\": \"epsnet-dirichlet\", \"version\": 1,", 0), 0U);
  EXPECT_NE(json.find("\"ties\": 5"), std::string::npos);
  EXPECT_NE(json.find("\"partner\": 7"), std::string::npos);
}

}  // namespace
}  // namespace epsnet
