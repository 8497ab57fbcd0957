#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/surface.h"

namespace epsnet::named_maps_test {
namespace {

/// The faces, edges and vertices of a surface of regular tiles.
struct Numbers {
  std::size_t faces;
  std::size_t edges;
  std::size_t vertices;
  bool operator==(const Numbers&) const = default;
};

Numbers numbers(const Surface& surface) {
  return {surface.tiles().size(), surface.side_count() / 2, surface.vertex_class_count()};
}

std::string problem(const DartMap& map) {
  try {
    (void)surface_of_map(map);
  } catch (const SurfaceError& error) {
    return error.what();
  }
  return "none";
}

/// How many systoles there are, up to orientation, of a length in (low, high); verified.
std::size_t systoles(const std::string& name, double low, double high) {
  const certify::GeodesicsDocument list = unproved::spectrum(named_surface(name), Length(std::to_string(high)));
  EXPECT_EQ(certify::check(list).verdict, certify::Verdict::verified);
  EXPECT_GT(list.geodesics.front().length.lower, low);
  return list.geodesics.size();
}

TEST(NamedSurfaces, HaveTheirGenusAndType) {
  for (const auto& [name, genus, p, q, faces] :
       {std::tuple{"bolza", 2U, 8U, 8U, 1U}, std::tuple{"klein", 3U, 7U, 3U, 24U}, std::tuple{"bring", 4U, 5U, 4U, 24U},
        std::tuple{"fermat-quartic", 3U, 8U, 3U, 12U}, std::tuple{"fricke-macbeath", 7U, 7U, 3U, 72U},
        std::tuple{"wiman-2", 2U, 10U, 5U, 1U}, std::tuple{"wiman-1000", 1000U, 4002U, 2001U, 1U},
        std::tuple{"accola-maclachlan-2", 2U, 6U, 4U, 4U}, std::tuple{"accola-maclachlan-7", 7U, 16U, 4U, 4U}}) {
    SCOPED_TRACE(name);
    const Surface surface = named_surface(name);
    EXPECT_EQ(surface.genus(), genus);
    EXPECT_EQ(*surface.regular_tile(), (RegularTile{p, q}));
    EXPECT_EQ(numbers(surface), (Numbers{faces, faces * p / 2, faces * p / q}));
    EXPECT_EQ(surface.about().substr(0, std::string(name).size()), name);
    EXPECT_EQ(to_document(from_document(to_document(surface))), to_document(surface));
  }
}

TEST(NamedSurfaces, AreListedAndNothingElseIs) {
  EXPECT_EQ(named_surfaces().size(), 7U);
  for (const NamedSurface& surface : named_surfaces()) {
    EXPECT_TRUE(surface.description.ends_with(".")) << surface.name;
    EXPECT_FALSE(surface.source.empty()) << surface.name;
  }
  for (const char* name : {"", "Klein", "wiman", "wiman-", "wiman-G", "wiman-2x", "wiman-1", "wiman-1001", "wiman--3",
                           "accola-maclachlan-99999999999", "klein-3"}) {
    EXPECT_THROW((void)named_surface(name), SurfaceError) << name;
  }
}

/// Every rotation of a regular map takes each dart to each other one: as many rotations as darts.
TEST(NamedSurfaces, HaveTheRotationsOfTheirGroups) {
  for (const auto& [name, order] :
       {std::pair{"klein", 168U}, std::pair{"bring", 120U}, std::pair{"fermat-quartic", 96U},
        std::pair{"fricke-macbeath", 504U}, std::pair{"wiman-5", 22U}, std::pair{"accola-maclachlan-5", 48U}}) {
    const Surface surface = named_surface(name);
    ASSERT_EQ(surface.side_count(), order) << name;
    std::uint32_t rotations = 0;
    for (std::uint32_t image = 0; image < order; ++image) {
      // The rotation that takes side 0 to `image`, if there is one: followed along sides and across them.
      const SideId unknown(order);
      ById<SideId, SideId> to(order, unknown);
      std::vector<SideId> pending{SideId(0)};
      to[SideId(0)] = SideId(image);
      bool is_map = true;
      while (is_map && !pending.empty()) {
        const SideId s = pending.back();
        pending.pop_back();
        for (const auto& [next, next_image] : {std::pair{surface.next_side(s), surface.next_side(to[s])},
                                               std::pair{surface.partner(s), surface.partner(to[s])}}) {
          if (to[next] == unknown) {
            to[next] = next_image;
            pending.push_back(next);
          }
          is_map = is_map && to[next] == next_image;
        }
      }
      if (is_map) ++rotations;
    }
    EXPECT_EQ(rotations, order) << name;
  }
}

/// The lengths and numbers of docs/using-epsnet.md.
TEST(NamedSurfaces, HaveTheirSystoles) {
  EXPECT_EQ(systoles("bolza", 3.05714, 3.05715), 12U);
  EXPECT_EQ(systoles("klein", 3.93594, 3.93595), 21U);
  EXPECT_EQ(systoles("fermat-quartic", 3.79784, 3.79785), 16U);
  EXPECT_EQ(systoles("bring", 4.6031, 4.6032), 20U);
  EXPECT_EQ(systoles("fricke-macbeath", 5.79629, 5.7963), 126U);
}

TEST(NamedSurfaces, HaveVerifiedNets) {
  for (const char* name : {"klein", "bring", "fermat-quartic", "wiman-2", "wiman-5", "accola-maclachlan-3"}) {
    for (const char* epsilon : {"0.4", "1.2", "20"}) {
      SCOPED_TRACE(std::string(name) + ", epsilon " + epsilon);
      EXPECT_EQ(certified_net(named_surface(name), Length(epsilon)).certificate.verdict, certify::Verdict::verified);
    }
  }
}

TEST(NamedSurfaces, OfGenus100HaveVerifiedNets) {
  for (const char* name : {"wiman-100", "accola-maclachlan-100"}) {
    const CertifiedNet net = certified_net(named_surface(name), Length("20"));
    EXPECT_EQ(net.certificate.verdict, certify::Verdict::verified) << name;
    EXPECT_EQ(net.document.vertices.size(), 1U) << name;
  }
}

TEST(NamedSurfaces, HaveNetsOfPointsThatAreNoCentres) {
  const Surface klein = named_surface("klein");
  const std::vector<BasePoint> points{{TileId(5), {Rational(1, 7), Rational(1, 9)}}, {TileId(0), {0, 0}}};
  EXPECT_EQ(certified_net(klein, Length("0.5"), {.points = points}).certificate.verdict, certify::Verdict::verified);
}

/// The map with the roles of faces and vertices exchanged is the same surface.
TEST(SurfaceOfMap, OfTheDualMapHasTheSameSystole) {
  // Of Klein's {7, 3}, x is a turn of a face, and xy of a vertex.
  const Permutation x{1, 2, 3, 4, 5, 6, 0, 7};
  const Permutation y{7, 6, 3, 2, 5, 4, 1, 0};
  Permutation xy(8);
  for (std::uint32_t i = 0; i < 8; ++i) xy[i] = y[x[i]];
  const Surface dual = surface_of_map(map_of_group(xy, y));
  EXPECT_EQ(*dual.regular_tile(), (RegularTile{3, 7}));
  EXPECT_EQ(numbers(dual), (Numbers{56, 84, 24}));
  const certify::GeodesicsDocument list = unproved::spectrum(dual, Length("3.93595"));
  EXPECT_EQ(certify::check(list).verdict, certify::Verdict::verified);
  EXPECT_EQ(list.geodesics.size(), 21U);
}

TEST(SurfaceOfMap, OfOnePolygonWithOppositeSidesIsTheRegularOne) {
  const DartMap map = parse_map(R"({"rotation": [1, 2, 3, 4, 5, 6, 7, 0], "edges": [4, 5, 6, 7, 0, 1, 2, 3]})");
  EXPECT_EQ(to_document(surface_of_map(map)), to_document(Surface::regular(2)));
}

TEST(SurfaceOfMap, SaysWhichPermutationIsWrong) {
  const DartMap good = parse_map(R"({"edges": [4, 5, 6, 7, 0, 1, 2, 3], "rotation": [1, 2, 3, 4, 5, 6, 7, 0]})");
  EXPECT_EQ(problem(good), "none");
  DartMap map = good;
  map.rotation[2] = 1;
  EXPECT_EQ(problem(map), "rotation: darts 0 and 2 have the same image, 1");
  map = good;
  map.rotation[2] = 8;
  EXPECT_EQ(problem(map), "rotation: the image of dart 2 is 8, there are only 8 darts");
  map = good;
  map.edges[7] = 4;
  EXPECT_EQ(problem(map), "edges: darts 0 and 7 have the same image, 4");
  map = good;
  map.edges.pop_back();
  EXPECT_EQ(problem(map), "edges: 7 darts, but rotation has 8");
  map = good;
  std::swap(map.edges[0], map.edges[4]);
  EXPECT_EQ(problem(map), "edges: dart 0 is its own image");
  map = good;
  map.edges = {1, 2, 0, 4, 3, 6, 5, 7};
  EXPECT_EQ(problem(map), "edges: dart 0 goes to dart 1, which does not go back");
  map = good;
  map.rotation = {1, 2, 0, 4, 5, 6, 7, 3};
  EXPECT_EQ(problem(map),
            "rotation: the number of sides of the face of dart 0 has 3, that of dart 3 has 5, expected as many");
  EXPECT_EQ(problem({}), "rotation: no dart, expected at least one");
  // Two octagons, one glued to itself in another way: vertices with other numbers of corners.
  map = good;
  map.edges = {1, 0, 3, 2, 6, 7, 4, 5};
  EXPECT_NE(problem(map).find("edges, then rotation: the number of corners at the vertex"), std::string::npos);
  // The torus.
  EXPECT_EQ(problem({{1, 2, 3, 0}, {2, 3, 0, 1}}), "there is no hyperbolic map of type {4, 4}");
  // Two copies.
  map = good;
  for (std::uint32_t dart = 0; dart < 8; ++dart) {
    map.rotation.push_back(good.rotation[dart] + 8);
    map.edges.push_back(good.edges[dart] + 8);
  }
  EXPECT_NE(problem(map).find("connected"), std::string::npos) << problem(map);
}

TEST(SurfaceOfMap, IsNotReadFromOtherTexts) {
  for (const char* text :
       {"", "[]", "{}", R"({"rotation": [0]})", R"({"edges": [0]})",
        R"({"rotation": [0], "rotation": [0], "edges": []})", R"({"rotation": [0], "edges": [0], "x": 1})",
        R"({"rotation": [-1], "edges": [0]})", R"({"rotation": [0.5], "edges": [0]})",
        R"({"rotation": ["0"], "edges": [0]})", R"({"rotation": [4294967296], "edges": [0]})",
        R"({"rotation": [[0]], "edges": [0]})", R"({"rotation": 0, "edges": [0]})",
        R"({"rotation": [0], "edges": [0]} x)", R"({"rotation": [0], "edges": [0)"}) {
    EXPECT_THROW((void)parse_map(text), MapError) << text;
  }
}

}  // namespace
}  // namespace epsnet::named_maps_test
