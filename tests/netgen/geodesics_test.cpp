#include "netgen/geodesics/geodesics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "netgen/geodesics/axis_catalogue.h"
#include "netgen/geodesics/cutting_search.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/netgen/unfolding.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/operations.h"

namespace epsnet::geodesics_test {
namespace {

// What keeps a reference cannot be made from a temporary.
static_assert(std::is_constructible_v<Unfolding, Triangulation&, double>);
static_assert(!std::is_constructible_v<Unfolding, Triangulation, double>);
static_assert(std::is_constructible_v<CuttingSearch, Triangulation&, std::vector<bool>>);
static_assert(!std::is_constructible_v<CuttingSearch, Triangulation, std::vector<bool>>);
static_assert(std::is_constructible_v<AxisCatalogue<Mp256>, Triangulation&>);
static_assert(!std::is_constructible_v<AxisCatalogue<Mp256>, Triangulation>);

using ClosedGeodesic = certify::GeodesicsDocument::ClosedGeodesic;
using certify::GeodesicsDocument;
using test::any_index;

double length_of(const ClosedGeodesic& geodesic) { return (geodesic.length.lower + geodesic.length.upper) / 2; }

std::vector<double> lengths_of(const GeodesicsDocument& document) {
  std::vector<double> result;
  for (const ClosedGeodesic& geodesic : document.geodesics) result.push_back(length_of(geodesic));
  return result;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance * a[i]) << i;
}

/// The length of the closed geodesic of a word from a tile to itself; 0 if the word is not hyperbolic.
double length_of_word(const Surface& surface, const Word& word) {
  Isometry<Mp1024> value;
  for (const SideId s : word) value = surface.crossing_as<Mp1024>(s) * value;
  return static_cast<double>(displacement_length(value));
}

TEST(Systole, OfTheGeneralisedBolzaSurfaces) {
  for (const std::uint32_t g : {2U, 3U, 4U, 5U, 7U, 10U}) {
    const GeodesicsDocument document = unproved::systole(Surface::regular(g));
    ASSERT_EQ(document.geodesics.size(), 1U);
    const double expected = 2 * std::acosh(1 + 2 * std::cos(std::numbers::pi / (2.0 * g)));
    EXPECT_NEAR(length_of(document.geodesics[0]), expected, 1e-13 * expected) << "genus " << g;
    EXPECT_TRUE(document.geodesics[0].simple);
    const certify::Interval length = document.geodesics[0].length;
    EXPECT_LE(length.upper - length.lower, 1e-10 * length.lower);
  }
}

TEST(Systole, OfAThinSurfaceIsItsShortCuff) {
  for (const Rational& cuff : {Rational(1, 10), Rational(1, 10'000), Rational(1, 1'000'000'000'000)}) {
    FenchelNielsen coordinates = random_coordinates(PantsGraph::random(4, 7), 7);
    coordinates.lengths[5] = cuff;
    const GeodesicsDocument document = unproved::systole(fenchel_nielsen_surface(coordinates));
    const auto expected = static_cast<double>(cuff);
    EXPECT_NEAR(length_of(document.geodesics[0]), expected, 1e-14 * expected);
  }
}

/// cosh(length/2) = m + n√2 with integers m and n (Aurich, Bogomolny and Steiner, "Periodic orbits on the regular
/// hyperbolic octagon", Physica D 48, 1991). The numbers are those that tests/certify/geodesics_test.cpp counts by
/// brute force; the second one, 12, is a theorem of Saha and Sanki too ("Complexity in Bolza surface",
/// arXiv:2311.18483).
TEST(Spectrum, OfTheBolzaSurface) {
  const GeodesicsDocument document = unproved::spectrum(Surface::regular(2), Length("5.9"));
  ASSERT_EQ(document.clusters.size(), 3U);
  const double root = std::sqrt(2.0);
  const std::vector<std::pair<std::uint32_t, double>> expected{{12, 1 + root}, {12, 3 + 2 * root}, {24, 5 + 3 * root}};
  for (std::size_t i = 0; i < 3; ++i) {
    const certify::GeodesicsDocument::Cluster& cluster = document.clusters[i];
    EXPECT_EQ(cluster.count, expected[i].first);
    EXPECT_TRUE(cluster.equal);
    EXPECT_NEAR(length_of(document.geodesics[cluster.first]), 2 * std::acosh(expected[i].second), 1e-13);
  }
}

TEST(Spectrum, WordsAreClosedGeodesicsOfTheirLengths) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const GeodesicsDocument document = unproved::spectrum(named.surface, Length("3"));
    for (const ClosedGeodesic& geodesic : document.geodesics) {
      EXPECT_NEAR(length_of_word(named.surface, word_of_letters(geodesic.word)), length_of(geodesic), 1e-12)
          << named.name;
    }
  }
}

/// Every word of at most five sides of a fundamental octagon that is short enough is a listed geodesic or a power of
/// one.
TEST(Spectrum, HasEveryShortWordOfAnOctagon) {
  for (const std::int32_t seed : {1, 5, 9}) {
    const Surface surface = random_octagon(seed);
    const std::vector<double> listed = lengths_of(unproved::spectrum(surface, Length("5")));
    std::vector<Isometry<Mp256>> generators;
    for (const SideId s : surface.side_ids()) generators.push_back(surface.crossing_as<Mp256>(s));
    std::vector<Isometry<Mp256>> words{{}};
    int found = 0;
    for (int letters = 1; letters <= 5; ++letters) {
      std::vector<Isometry<Mp256>> longer;
      for (const Isometry<Mp256>& word : words) {
        for (const Isometry<Mp256>& generator : generators) {
          longer.push_back(generator * word);
          const auto length = static_cast<double>(displacement_length(longer.back()));
          if (length < 1e-3 || length > 4.999) continue;
          ++found;
          EXPECT_TRUE(std::any_of(listed.begin(), listed.end(),
                                  [&](double primitive) {
                                    const double multiple = std::round(length / primitive);
                                    return std::abs(length - multiple * primitive) < 1e-12;
                                  }))
              << "seed " << seed << ", length " << length;
        }
      }
      words = std::move(longer);
    }
    EXPECT_GT(found, 100);
  }
}

struct ElementOfPath {
  ReturnPath path;
  Isometry<Mp256> element;
};

/// The elements of all closed geodesics of length at most `up_to`, by length, many for one geodesic: by a search
/// through all triangles around each vertex.
std::vector<ElementOfPath> all_elements(Triangulation& triangulation, AxisCatalogue<Mp256>& catalogue, double up_to) {
  const Unfolding unfolding(triangulation, 1);
  const double displacement = 2 * std::asinh(std::sinh(up_to / 2) * std::cosh(1.0));
  std::vector<ElementOfPath> result;
  for (const VertexId v : triangulation.vertices()) {
    for (const ReturnPath& path : unfolding.returns(v, {displacement, up_to})) {
      result.push_back({path, catalogue.element(path)});
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const ElementOfPath& x, const ElementOfPath& y) {
    return displacement_length(x.element) < displacement_length(y.element);
  });
  return result;
}

/// Cutting sequences and triangles around vertices give the same lists, also where many geodesics pass through vertices
/// and have equal lengths, and in collars.
TEST(Spectrum, IsWhatASearchAroundVerticesFinds) {
  std::vector<std::pair<Surface, double>> surfaces{
      {random_octagon(5), 7.5}, {Surface::regular(2), 8}, {Surface::regular(3), 6}};
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(3, 3), 3);
  surfaces.emplace_back(fenchel_nielsen_surface(coordinates), 6);
  coordinates.lengths[1] = Rational(1, 5);
  coordinates.twists[1] = 0;
  surfaces.emplace_back(fenchel_nielsen_surface(coordinates), 6);
  for (const auto& [surface, up_to] : surfaces) {
    Triangulation triangulation = triangulated_net(surface, Length("1")).triangulation;
    AxisCatalogue<Mp256> catalogue(triangulation);
    std::vector<double> expected;
    for (const ElementOfPath& e : all_elements(triangulation, catalogue, up_to)) {
      const std::size_t known = catalogue.geodesics().size();
      (void)catalogue.find_or_add(e.path, e.element);
      if (catalogue.geodesics().size() > known) expected.push_back(static_cast<double>(displacement_length(e.element)));
    }
    const GeodesicsDocument document = unproved::spectrum(surface, Length(std::to_string(up_to)));
    ASSERT_GT(expected.size(), 30U);
    expect_near(lengths_of(document), expected, 1e-13);
    const auto simple = [](const auto& list) {
      return std::count_if(list.begin(), list.end(), [](const auto& geodesic) { return geodesic.simple; });
    };
    EXPECT_EQ(simple(document.geodesics), simple(catalogue.geodesics()));
  }
}

TEST(AxisCatalogue, TellsManyElementsApart) {
  const Surface surface = random_octagon(5);
  Triangulation triangulation = triangulated_net(surface, Length("1")).triangulation;
  AxisCatalogue<Mp256> catalogue(triangulation);
  const std::vector<ElementOfPath> elements = all_elements(triangulation, catalogue, 7);
  for (const ElementOfPath& e : elements) (void)catalogue.find_or_add(e.path, e.element);
  EXPECT_GT(elements.size(), 600U);
  EXPECT_GE(catalogue.geodesics().size(), 97U);
}

TEST(AxisCatalogue, KnowsPowersAndInverses) {
  const Surface surface = random_octagon(5);
  Triangulation triangulation = triangulated_net(surface, Length("1")).triangulation;
  AxisCatalogue<Mp256> catalogue(triangulation);
  for (const ElementOfPath& e : all_elements(triangulation, catalogue, 7)) {
    const std::uint32_t number = catalogue.find_or_add(e.path, e.element);
    const Isometry<Mp256> square = e.element * e.element;
    EXPECT_EQ(catalogue.find_or_add(e.path, square), number);
    EXPECT_EQ(catalogue.find_or_add(e.path, inverse(square * e.element)), number);
  }
}

/// A cuff without a twist passes along edges and through vertices, and triangles beside it only touch it.
TEST(Spectrum, FindsACuffAlongEdges) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(4, 35), 35);
  coordinates.twists[35 % coordinates.twists.size()] = 0;
  const std::vector<double> lengths =
      lengths_of(unproved::spectrum(fenchel_nielsen_surface(coordinates), Length("3.5")));
  for (const Rational& cuff : coordinates.lengths) {
    const auto length = static_cast<double>(cuff);
    EXPECT_TRUE(length > 3.5 ||
                std::any_of(lengths.begin(), lengths.end(), [&](double x) { return std::abs(x - length) < 1e-9; }))
        << length;
  }
}

/// Twists of 0 and equal lengths give a symmetric surface, but its coordinates are rounded: lengths that ought to be
/// equal differ in late digits, and the certifier sees that.
TEST(Spectrum, ClaimsNoEqualityOfRoundedLengths) {
  const PantsGraph ring = PantsGraph::ring(3);
  const std::size_t cuffs = ring.edges().size();
  const FenchelNielsen coordinates{
      .graph = ring, .lengths = std::vector<Rational>(cuffs, 2), .twists = std::vector<Rational>(cuffs, 0)};
  const GeodesicsDocument document = unproved::spectrum(fenchel_nielsen_surface(coordinates), Length("4"));
  EXPECT_GT(document.geodesics.size(), cuffs);
  EXPECT_EQ(certify::check(document).verdict, certify::Verdict::verified);
}

/// On a surface with a pair of pants whose cuffs a, b, c are short, the figure eight around a and b has cosh(ℓ/2) = 2
/// cosh(a/2) cosh(b/2) + cosh(c/2) (Buser, (4.2.3)), and is not simple.
TEST(Spectrum, KnowsFiguresOfEight) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::parse("0-1 0-1 0-1"), 1);
  coordinates.lengths = {1, Rational(11, 10), Rational(12, 10)};
  const GeodesicsDocument document = unproved::spectrum(fenchel_nielsen_surface(coordinates), Length("4.3"));
  for (const auto& [a, b, c] : std::vector<std::array<double, 3>>{{1, 1.1, 1.2}, {1, 1.2, 1.1}, {1.1, 1.2, 1}}) {
    const double expected = 2 * std::acosh(2 * std::cosh(a / 2) * std::cosh(b / 2) + std::cosh(c / 2));
    const auto eights = std::count_if(document.geodesics.begin(), document.geodesics.end(), [&](const auto& geodesic) {
      return std::abs(length_of(geodesic) - expected) < 1e-12 && !geodesic.simple;
    });
    EXPECT_EQ(eights, 2) << "one in each pair of pants";
  }
  EXPECT_TRUE(document.geodesics[0].simple && document.geodesics[1].simple && document.geodesics[2].simple);
}

RC_GTEST_PROP(SpectrumProperty, DoesNotDependOnTheNet, ()) {
  const test::NamedSurface& named = test::any_tiled_surface();
  const Length up_to(std::to_string(10 + any_index(25)) + "/10");
  GeodesicsOptions options;
  options.threads = 1;
  const GeodesicsDocument a = unproved::spectrum(named.surface, up_to, options);
  options.epsilon = Length(std::to_string(5 + any_index(8)) + "/10");
  const GeodesicsDocument b = unproved::spectrum(named.surface, up_to, options);
  expect_near(lengths_of(a), lengths_of(b), 1e-14);
  std::vector<bool> simple_a;
  for (const auto& geodesic : a.geodesics) simple_a.push_back(geodesic.simple);
  for (std::size_t i = 0; i < a.clusters.size(); ++i) {
    if (a.clusters[i].count == 1) {
      RC_ASSERT(a.geodesics[a.clusters[i].first].simple == b.geodesics[a.clusters[i].first].simple);
    }
  }
}

RC_GTEST_PROP(SpectrumProperty, DoesNotDependOnTheThreads, ()) {
  const test::NamedSurface& named = test::any_tiled_surface();
  GeodesicsOptions options;
  options.threads = 1;
  const GeodesicsDocument one = unproved::spectrum(named.surface, Length("3"), options);
  options.threads = 3;
  RC_ASSERT(unproved::spectrum(named.surface, Length("3"), options) == one);
}

/// A twist by a full turn gives another marking of the same surface.
RC_GTEST_PROP(SpectrumProperty, IsThatOfTheSurfaceAndNotOfItsMarking, ()) {
  const std::uint32_t genus = 2 + any_index(3U);
  const std::uint64_t seed = any_index(1000U);
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(genus, seed), seed);
  const auto cuff = any_index(coordinates.lengths.size());
  coordinates.twists[cuff] = 0;
  const std::vector<double> a = lengths_of(unproved::spectrum(fenchel_nielsen_surface(coordinates), Length("3.5")));
  coordinates.twists[cuff] = coordinates.lengths[cuff];
  // The surface made is within 2⁻⁵⁰ of the one asked for.
  expect_near(a, lengths_of(unproved::spectrum(fenchel_nielsen_surface(coordinates), Length("3.5"))), 1e-10);
}

/// Cuffs that are all short cut the surface into its pairs of pants.
RC_GTEST_PROP(ThickThinProperty, FindsThePairsOfPants, ()) {
  const std::uint32_t genus = 2 + any_index(4U);
  const std::uint64_t seed = any_index(1000U);
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(genus, seed), seed);
  for (Rational& length : coordinates.lengths) length = Rational(1 + any_index(100), 1000);
  const GeodesicsDocument document = unproved::thick_thin(fenchel_nielsen_surface(coordinates));
  std::vector<double> cuffs;
  for (const Rational& length : coordinates.lengths) cuffs.push_back(static_cast<double>(length));
  std::sort(cuffs.begin(), cuffs.end());
  expect_near(lengths_of(document), cuffs, 1e-12);
  RC_ASSERT(document.pieces.size() == 2 * genus - 2);
  for (const certify::GeodesicsDocument::Piece& piece : document.pieces) {
    RC_ASSERT(piece.genus == 0U);
    RC_ASSERT(piece.boundaries.size() == 3U);
  }
}

RC_GTEST_PROP(ThickThinProperty, PiecesMakeUpTheSurface, ()) {
  const std::uint32_t genus = 2 + any_index(5U);
  const std::uint64_t seed = any_index(1000U);
  const GeodesicsDocument document =
      unproved::thick_thin(fenchel_nielsen_surface(random_coordinates(PantsGraph::random(genus, seed), seed)));
  RC_ASSERT(document.geodesics.size() <= 3 * genus - 3);
  int characteristic = 0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const certify::GeodesicsDocument::Piece& piece : document.pieces) {
    characteristic += 2 - 2 * static_cast<int>(piece.genus) - static_cast<int>(piece.boundaries.size());
    sides.insert(piece.boundaries.begin(), piece.boundaries.end());
  }
  RC_ASSERT(characteristic == 2 - 2 * static_cast<int>(genus));
  RC_ASSERT(sides.size() == 2 * document.geodesics.size());
  for (const auto& geodesic : document.geodesics) RC_ASSERT(geodesic.simple);
}

TEST(ThickThin, OfASurfaceWithoutSmallCurvesIsThickInOnePiece) {
  const GeodesicsDocument document = unproved::thick_thin(Surface::regular(3));
  EXPECT_TRUE(document.geodesics.empty());
  ASSERT_EQ(document.pieces.size(), 1U);
  EXPECT_EQ(document.pieces[0], (certify::GeodesicsDocument::Piece{3, {}}));
}

/// A separating curve: a handle on each side. They are nearly the modular torus, whose systole, 2 arcosh(3/2), is
/// longer than 2 arsinh 1.
TEST(CutSurface, AlongASeparatingCuff) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::parse("0-0 0-1 1-1"), 1);
  coordinates.lengths = {Rational(19'248, 10'000), Rational(1, 100), Rational(19'248, 10'000)};
  coordinates.twists = {0, 0, 0};
  const GeodesicsDocument document = unproved::thick_thin(fenchel_nielsen_surface(coordinates));
  ASSERT_EQ(document.pieces.size(), 2U);
  EXPECT_EQ(document.pieces[0], (certify::GeodesicsDocument::Piece{1, {{0, 0}}}));
  EXPECT_EQ(document.pieces[1], (certify::GeodesicsDocument::Piece{1, {{0, 1}}}));
}

/// Without curves there is one piece, of the genus of the surface.
TEST(CutSurface, AlongNothing) {
  const Surface surface = random_octagon(1);
  EXPECT_EQ(cut_surface(Triangulation(surface), {}), (std::vector<certify::GeodesicsDocument::Piece>{{2, {}}}));
}

TEST(CuttingSearch, CrossesNoMoreEdgesThanItMay) {
  Triangulation triangulation = triangulated_net(random_octagon(5), Length("1")).triangulation;
  const CuttingSearch search(triangulation, std::vector<bool>(4 * std::size_t{triangulation.triangle_count()}));
  EXPECT_FALSE(search.paths(0, 6, 1'000'000).empty());
  EXPECT_THROW((void)search.paths(0, 6, 100), NetError);
}

/// Each path is closed, short enough, and begins with its least dart; no two belong to one geodesic.
RC_GTEST_PROP(CuttingSearchProperty, PathsAreClosed, ()) {
  const Surface surface = random_octagon(any_index<std::int32_t>(1000));
  Triangulation triangulation = triangulated_net(surface, Length("1")).triangulation;
  const CuttingSearch search(triangulation, std::vector<bool>(4 * std::size_t{triangulation.triangle_count()}));
  AxisCatalogue<Mp256> catalogue(triangulation);
  std::set<std::vector<Dart>> cycles;
  const std::size_t start = any_index(search.starts());
  for (const CuttingPath& path : search.paths(start, 4, 1'000'000)) {
    for (std::size_t i = 0; i < path.darts.size(); ++i) {
      const Dart after = path.darts[(i + 1) % path.darts.size()];
      RC_ASSERT(triangle_of(triangulation.opposite(path.darts[i])) == triangle_of(after));
      RC_ASSERT(after != triangulation.opposite(path.darts[i]));
    }
    const Dart first = path.darts[0];
    RC_ASSERT(displacement_length(catalogue.element({first, path.darts, first})) < 4.001);
    std::vector<Dart> cycle = path.darts;
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    RC_ASSERT(cycles.insert(cycle).second);
  }
}

/// Each way leads from the vertex to a lift of it no farther away than asked.
RC_GTEST_PROP(UnfoldingProperty, WaysComeBack, ()) {
  const Surface surface = random_octagon(any_index<std::int32_t>(1000));
  Triangulation triangulation(surface);
  (void)make_delaunay(triangulation);
  const VertexId v = test::any_vertex(triangulation);
  const Unfolding unfolding(triangulation, 5);
  for (const ReturnPath& path : unfolding.returns(v, {4, 4})) {
    const auto vertex_at = [&](Dart d) { return triangulation.corner(triangle_of(d), corner_of(d)).vertex; };
    RC_ASSERT(vertex_at(path.start) == v);
    RC_ASSERT(vertex_at(path.end) == v);
    TriangleId triangle = triangle_of(path.start);
    for (const Dart d : path.darts) {
      RC_ASSERT(triangle_of(d) == triangle);
      triangle = triangle_of(triangulation.opposite(d));
    }
    RC_ASSERT(triangle == triangle_of(path.end));
  }
}

}  // namespace
}  // namespace epsnet::geodesics_test
