#include "netgen/surfaces/fenchel_nielsen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <rapidcheck/gtest.h>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include "netgen/base/gmp.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"

namespace epsnet::fenchel_nielsen_test {
namespace {

using test::any_index;
using test::any_share;
using testing::HasSubstr;

/// The isometry of a path that returns to its first tile.
Isometry<Mp1024> value_of(const Surface& surface, const Word& word) {
  Isometry<Mp1024> result;
  for (const SideId s : word) {
    result = surface.crossing_as<Mp1024>(s) * result;
  }
  return normalized(result);
}

/// The length of the closed geodesic of a path that returns to its first tile.
Mp1024 length_of(const Surface& surface, const Word& word) {
  return 2 * acosh(Mp1024(abs(value_of(surface, word).a.x)));
}

/// The cuffs of a heptagon as paths: D1, D2 and D3⁻¹ up to conjugation.
Word cuff_word(const Surface& surface, PantsGraph::End end) {
  const auto side = [&](std::uint32_t k) { return surface.side_number(TileId(end.pants), k); };
  return end.cuff == 0 ? Word{side(5), side(2)} : end.cuff == 1 ? Word{side(0)} : Word{side(5)};
}

SideId cuff_side(const Surface& surface, PantsGraph::End end) {
  constexpr std::array<std::uint32_t, 3> kSides{6, 1, 4};
  return surface.side_number(TileId(end.pants), kSides[end.cuff]);
}

PantsGraph any_graph(std::uint32_t genus) {
  switch (any_index(4u)) {
    case 0:
      return PantsGraph::chain(genus);
    case 1:
      return PantsGraph::ring(genus);
    case 2:
      return PantsGraph::tree(genus);
    default:
      return PantsGraph::random(genus, any_index(1000u));
  }
}

/// Logarithmically uniform between 1e-10 and 30, with six digits.
Rational any_length() {
  const int exponent = static_cast<int>(any_index(11u)) - 10;
  const Rational mantissa(1000 + any_index(9000u), 1000);
  const Rational length =
      exponent < 0 ? Rational(mantissa / pow(boost::multiprecision::mpz_int(10), static_cast<unsigned>(-exponent)))
                   : mantissa * 3;
  return length;
}

FenchelNielsen any_coordinates(std::uint32_t largest_genus) {
  PantsGraph graph = any_graph(2 + any_index(largest_genus - 1));
  FenchelNielsen result{std::move(graph), {}, {}};
  for (std::size_t e = 0; e < result.graph.edges().size(); ++e) {
    result.lengths.push_back(any_length());
    result.twists.push_back(result.lengths.back() * Rational(static_cast<int>(any_index(80'001u)) - 40'000, 1000));
  }
  return result;
}

TEST(PantsGraph, NamedGraphsAreTrivalentAndConnected) {
  for (const std::uint32_t genus : {2u, 3u, 4u, 7u, 100u}) {
    for (const PantsGraph& graph : {PantsGraph::chain(genus), PantsGraph::ring(genus), PantsGraph::tree(genus),
                                    PantsGraph::random(genus, 1), PantsGraph::random(genus, 2)}) {
      EXPECT_EQ(graph.genus(), genus);
      EXPECT_EQ(graph.edges().size(), 3 * genus - 3);
    }
  }
}

TEST(PantsGraph, LoopsAndDoubleEdgesAreAllowed) {
  const PantsGraph dumbbell = PantsGraph::parse("0-0, 0-1 1-1");
  EXPECT_EQ(dumbbell.edges(), PantsGraph::chain(2).edges());
  EXPECT_EQ(dumbbell.edges()[0], (PantsGraph::Edge{{{0, 0}, {0, 1}}}));
  EXPECT_EQ(dumbbell.edge_at(1, 0), 1U);
  EXPECT_EQ(PantsGraph::parse("0-1 0-1 1-0").edges(), PantsGraph::ring(2).edges());
}

TEST(PantsGraph, ASeedGivesOneGraphAndAnotherSeedAnotherOne) {
  EXPECT_EQ(PantsGraph::random(10, 1).edges(), PantsGraph::random(10, 1).edges());
  EXPECT_NE(PantsGraph::random(10, 1).edges(), PantsGraph::random(10, 2).edges());
}

void expect_graph_error(const std::string& edges, const std::string& problem) {
  try {
    (void)PantsGraph::parse(edges);
    ADD_FAILURE() << edges;
  } catch (const PantsGraphError& error) {
    EXPECT_THAT(error.what(), HasSubstr(problem)) << edges;
  }
}

TEST(PantsGraph, WhatIsNoneIsNamed) {
  expect_graph_error("", "3g - 3 edges");
  expect_graph_error("0-1 0-1", "3g - 3 edges");
  expect_graph_error("0-1 0-1 0-1 0-1", "3g - 3 edges");
  expect_graph_error("0-0 0-0 1-1", "node 0 has more than three edges");
  expect_graph_error("0-1 0-1 0-2", "node 2");
  expect_graph_error("0-1 0-1 0-1 2-3 2-3 2-3", "not connected: 2 of 4");
  expect_graph_error("0-1 0-x 0-1", "not \"0-x\"");
  expect_graph_error("0 0-1 0-1", "not \"0\"");
  expect_graph_error("0-1-1 0-1 0-1", "not \"0-1-1\"");
  expect_graph_error("0-99999999999 0-1 0-1", "99999999999");
  EXPECT_THROW((void)PantsGraph::chain(1), PantsGraphError);
  EXPECT_THROW((void)PantsGraph::random(0, 1), PantsGraphError);
  EXPECT_THROW((void)PantsGraph::tree(4'000'000'000u), PantsGraphError);
}

TEST(FenchelNielsen, AFullTurnIsTheSameSurface) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::ring(3), 4);
  const Surface surface = fenchel_nielsen_surface(coordinates);
  coordinates.twists[1] += 40 * coordinates.lengths[1];
  coordinates.twists[2] -= coordinates.lengths[2];
  EXPECT_EQ(fenchel_nielsen_surface(coordinates).tiles(), surface.tiles());
  EXPECT_EQ(fenchel_nielsen_surface(coordinates).about(), surface.about());
}

FenchelNielsen with(const char* graph, std::vector<Rational> lengths, std::vector<Rational> twists) {
  return {PantsGraph::parse(graph), std::move(lengths), std::move(twists)};
}

/// Two equal pairs of pants, glued with no twist: the symmetries of one of them, a triangle's, which also exchange
/// front and back, and the exchange of the two. With twists by half of the lengths, marks still meet perpendiculars.
TEST(FenchelNielsen, SymmetriesOfTwistsAreExact) {
  const std::vector<std::pair<FenchelNielsen, std::size_t>> surfaces{
      {with("0-1 0-1 0-1", {2, 2, 2}, {0, 0, 0}), 24},
      {with("0-1 0-1 0-1", {2, 2, 2}, {1, 1, 1}), 24},
      {with("0-1 0-1 0-1", {2, 2, 2}, {2, -1, 3}), 8},
      {with("0-1 0-1 0-1", {2, 3, Rational(5, 2)}, {0, 0, 0}), 4},
      {with("0-0 0-1 1-1", {2, 1, 2}, {0, 0, 0}), 8},
      {with("0-1 0-1 0-1", {2, 2, 2}, {Rational(1, 10), Rational(2, 10), Rational(3, 10)}), 2},
  };
  for (const auto& [coordinates, order] : surfaces) {
    EXPECT_TRUE(rounded_symmetric_twists(coordinates).empty());
    EXPECT_EQ(isometries(fenchel_nielsen_surface(coordinates)).size(), order);
  }
}

/// What a request makes, with all isometries.
void expect_isometries(const std::string& request, std::size_t order, bool is_rational) {
  const FenchelNielsen coordinates = resolve(parse_fenchel_nielsen(request));
  EXPECT_TRUE(rounded_symmetric_twists(coordinates).empty()) << request;
  const Surface surface = fenchel_nielsen_surface(coordinates);
  EXPECT_EQ(surface.is_rational(), is_rational) << request;
  EXPECT_EQ(surface.vertex_class_count(), 3 * surface.genus() - 3) << request;
  EXPECT_EQ(isometries(surface).size(), order) << request;
}

/// With twists 0 the reflection of all pairs of pants is one of the surface; in genus 2 there is the hyperelliptic
/// involution; two pairs of pants with the same three lengths can be exchanged, and equal cuffs.
TEST(FenchelNielsen, DecimalsBetweenUnequalPantsKeepTheirSymmetries) {
  constexpr bool kRational = true;
  expect_isometries(R"({"graph": "0-0 0-1 1-1", "lengths": [2, 3, 4], "twists": [0]})", 4, kRational);
  expect_isometries(R"({"graph": "0-0 0-1 1-1", "lengths": [2, 3, 4], "twists": [1, 1.5, 2]})", 4, kRational);
  // Cuffs 2 and 3 can be exchanged; this turns cuffs 1 and 4 by half of their lengths.
  expect_isometries(R"({"graph": "0-0 0-1 1-2 1-2 2-3 3-3", "lengths": [2, 3, 1.5, 1.5, 2.5, 4], "twists": [0]})", 4,
                    kRational);
  expect_isometries(R"({"graph": "chain", "genus": 4, "lengths": [1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8],
                        "twists": [0]})",
                    2, kRational);
  // One root stays irrational where each pair of pants has others on all sides.
  expect_isometries(R"({"graph": "0-1 0-2 0-3 1-2 1-3 2-3", "lengths": [1, 2, 3, 4, 5, 6], "twists": [0]})", 2,
                    !kRational);
}

TEST(FenchelNielsen, ExactLengthsAreExact) {
  constexpr bool kRational = true;
  expect_isometries(R"json({"graph": "theta", "lengths": ["2*arcosh(3/2)"], "twists": [0]})json", 24, !kRational);
  expect_isometries(R"json({"graph": "theta", "lengths": ["2*arcosh(3/2)"], "twists": ["arcosh(3/2)"]})json", 24,
                    !kRational);
  expect_isometries(R"json({"graph": "theta", "lengths": ["2*log(3)"], "twists": ["log(3)"]})json", 24, kRational);
  expect_isometries(
      R"json({"graph": "theta", "lengths": ["2*arcosh(3/2)", "2*log(3)", "arcosh(1 + sqrt(2))"], "twists": [0]})json",
      4, !kRational);
  expect_isometries(
      R"json({"graph": "0-0 0-1 1-1", "lengths": ["2*arsinh(1)", "2*log(3)", "2*arsinh(1)"], "twists": [0]})json", 8,
      !kRational);
}

/// The exact surface and one with twists that are a little more, which are rounded.
TEST(FenchelNielsen, ExactSurfacesAreNearToRoundedOnes) {
  for (
      const char* request : {
          R"({"graph": "0-0 0-1 1-1", "lengths": [2, 3, 4], "twists": [0, 0.7, -2]})",
          R"({"graph": "0-1 0-2 0-3 1-2 1-3 2-3", "lengths": [1, 2, 3, 2.5, 1.5, 0.5],
               "twists": [0, 0.5, -1, 0, 0.3, 0]})",
          R"json({"graph": "theta", "lengths": ["2*arcosh(3/2)", "2*log(7)", 2.5], "twists": ["log(3/2)", 0, 0.3]})json",
          R"json({"graph": "0-0 0-1 1-1", "lengths": ["arcosh(7)", "2*arcosh(5/4)", "2*arsinh(1/2)"],
                   "twists": ["-log(5/4)", "arsinh(1/9)", 0]})json",
      }) {
    const FenchelNielsen exact = resolve(parse_fenchel_nielsen(request));
    FenchelNielsen rounded{exact.graph, exact.lengths, exact.twists};
    for (Rational& twist : rounded.twists) twist += Rational(1, 1'000'000'000'000'000);
    const Surface one = fenchel_nielsen_surface(exact);
    const Surface other = fenchel_nielsen_surface(rounded);
    EXPECT_EQ(one.gluing(), other.gluing());
    for (std::size_t e = 0; e < exact.lengths.size(); ++e) {
      const auto& [first, second] = exact.graph.edges()[e];
      EXPECT_LT(abs(length_of(one, cuff_word(one, first)) - Mp1024(exact.lengths[e])), ldexp(Mp1024(1), -47));
      // Over the cuff, around one of the other pair of pants, and back around one of this.
      for (std::uint32_t k = 0; k < 3; ++k) {
        Word word{cuff_side(one, first)};
        for (const SideId s : cuff_word(one, {second.pants, k})) word.push_back(s);
        word.push_back(cuff_side(one, second));
        for (const SideId s : cuff_word(one, {first.pants, (first.cuff + 1) % 3})) word.push_back(s);
        EXPECT_LT(abs(length_of(one, word) - length_of(other, word)), 1e-13) << request << e << k;
      }
    }
  }
}

TEST(FenchelNielsen, TwistsThatAreNotExactAreNamed) {
  // Ten pairs of pants with others on all sides, and fifteen lengths.
  FenchelNielsen coordinates{PantsGraph::ring(6), {}, std::vector<Rational>(15, Rational(1, 3))};
  for (int e = 0; e < 15; ++e) coordinates.lengths.emplace_back(100 + e, 100);
  coordinates.twists[1] = 0;
  EXPECT_EQ(rounded_symmetric_twists(coordinates), std::vector<std::size_t>{1});
  // Whatever is not symmetric is rounded anyway.
  EXPECT_TRUE(rounded_symmetric_twists(with("0-0 0-1 1-1", {2, 1, 3}, {1.5, Rational(1, 3), 0.25})).empty());
}

/// A. Strohmaier and V. Uski, An algorithm for the computation of eigenvalues, spectral zeta functions and
/// zeta-determinants on hyperbolic surfaces, 2013: lengths 2 arcosh(3 + 2√2) and twice 2 arcosh(1 + √2), twists of ½, 0
/// and 0 turns.
TEST(FenchelNielsen, PublishedCoordinatesAreThoseOfBolzasSurface) {
  const Surface surface =
      fenchel_nielsen_surface(resolve({"theta",
                                       std::nullopt,
                                       std::nullopt,
                                       {"2*arcosh(3+2*sqrt(2))", "2*arcosh(1+sqrt(2))", "2*arcosh(1+sqrt(2))"},
                                       {"arcosh(3+2*sqrt(2))", "0", "0"}}));
  EXPECT_EQ(isometric(surface, named_surface("bolza")).kind, IsometricAnswer::Kind::yes);
}

/// Klein's quartic: six of its systoles cut it into four pairs of pants, the vertices of a tetrahedron, with twists of
/// ⅛ turn. The order of cuffs is that of a tetrahedron seen from outside; in another order they give another surface.
TEST(FenchelNielsen, PublishedCoordinatesAreThoseOfKleinsQuarticIfCuffsAreInOrder) {
  const Rational length("39359462488303282/10000000000000000");
  const std::vector<Rational> lengths(6, length);
  const std::vector<Rational> twists(6, length / 8);
  const FenchelNielsen in_order = with("0-1 0-2 1-3 0-3 1-2 2-3", lengths, twists);
  const IsometricAnswer answer = isometric(fenchel_nielsen_surface(in_order), named_surface("klein"));
  ASSERT_TRUE(answer.near);
  EXPECT_LT(answer.near->difference, 1e-11);
  EXPECT_FALSE(symmetry_lost_by_order(in_order));

  const FenchelNielsen other = with("0-1 0-2 0-3 1-2 1-3 2-3", lengths, twists);
  EXPECT_LT(unproved::systole(fenchel_nielsen_surface(other)).geodesics.front().length.upper, 2.9);
  EXPECT_TRUE(symmetry_lost_by_order(other));
}

TEST(FenchelNielsen, ASymmetryThatTheOrderOfCuffsLosesIsNamed) {
  using Images = std::vector<std::uint32_t>;
  // Two edges between the same pairs of pants are exchanged, which turns these around but not their neighbours.
  const FenchelNielsen ring = with("0-1 1-2 1-2 2-3 3-0 3-0", {1, 2, 2, 1, 2, 3}, {0, 1, 1, 0, 1, 1});
  EXPECT_EQ(symmetry_lost_by_order(ring), (Images{0, 2, 1, 3, 4, 5}));
  // Not if the two have other lengths or twists; a twist by a turn is none.
  EXPECT_FALSE(symmetry_lost_by_order(with("0-1 1-2 1-2 2-3 3-0 3-0", {1, 2, 4, 1, 2, 3}, {0, 1, 1, 0, 1, 1})));
  EXPECT_FALSE(
      symmetry_lost_by_order(with("0-1 1-2 1-2 2-3 3-0 3-0", {1, 2, 2, 1, 2, 3}, {0, 1, Rational(1, 2), 0, 1, 1})));
  EXPECT_TRUE(symmetry_lost_by_order(with("0-1 1-2 1-2 2-3 3-0 3-0", {1, 2, 2, 1, 2, 3}, {0, 1, 3, 0, 1, 1})));
  // All pairs of pants are turned around, or such with loops.
  EXPECT_FALSE(symmetry_lost_by_order(with("0-1 0-1 0-1", {2, 2, 2}, {1, 1, 1})));
  EXPECT_FALSE(symmetry_lost_by_order(with("0-0 0-1 1-1", {2, 2, 2}, {1, 1, 1})));
  // Random coordinates have no symmetry to lose.
  EXPECT_FALSE(symmetry_lost_by_order(random_coordinates(PantsGraph::random(20, 1), 1)));
}

TEST(FenchelNielsen, ExactLengthsThatAreNoneAreNamed) {
  const auto expect = [](const std::string& length, const std::string& problem) {
    try {
      (void)fenchel_nielsen_surface(
          resolve({"theta", std::nullopt, std::nullopt, {length, "2*arcosh(3)", "2*arcosh(4)"}, {"0"}}));
      ADD_FAILURE() << length;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(problem)) << length;
    }
  };
  expect("arcosh(1/2)", "lengths: the arcosh of a number that is less than 1 in \"arcosh(1/2)\"");
  expect("log(-3)", "the log of a number that is not positive");
  expect("-2*arcosh(3)", "zero or negative");
  expect("arcosh(3)/3", "its denominator a power of 2, not \"arcosh(3)/3\"");
  expect("65*arcosh(3)", "at most 64");
  expect("arcosh(3", "expected a length such as");
  expect("arcosh(3)+1", "expected a length such as");
  expect("arcosh(3*x)", "expected");
  expect("arcosh(root(x^65-2,1))", "expected a power of at most 64");
  expect("arcosh(root(x^64-3,1)+root(x^3-2,1))", "in a field of degree 192, expected at most 64");
}

TEST(FenchelNielsen, TheSurfaceSaysWhatItIs) {
  const Surface surface = fenchel_nielsen_surface({PantsGraph::ring(2), {1, 1, 2}, {0, 0, 0}});
  EXPECT_THAT(surface.about(), HasSubstr("0.0-1.0 r="));
  EXPECT_THAT(surface.about(), HasSubstr(" s="));
}

void expect_surface_error(const FenchelNielsen& coordinates, const std::string& problem) {
  try {
    (void)fenchel_nielsen_surface(coordinates);
    ADD_FAILURE() << problem;
  } catch (const SurfaceError& error) {
    EXPECT_THAT(error.what(), HasSubstr(problem));
  }
}

TEST(FenchelNielsen, BadCoordinatesAreNamed) {
  const FenchelNielsen good = random_coordinates(PantsGraph::chain(2), 1);
  FenchelNielsen bad = good;
  bad.lengths[1] = 0;
  expect_surface_error(bad, "edge 1 (0-1): a length must be at least 1e-25");
  bad.lengths[1] = -1;
  expect_surface_error(bad, "zero or negative");
  bad.lengths[1] = 101;
  expect_surface_error(bad, "at most 100, not more");
  bad = good;
  bad.lengths.pop_back();
  expect_surface_error(bad, "2 lengths for a pants graph with 3 edges");
  bad = good;
  bad.twists.emplace_back(0);
  expect_surface_error(bad, "4 twists for a pants graph with 3 edges");
  bad = good;
  bad.twists[2] = pow(boost::multiprecision::mpz_int(10), 101);
  expect_surface_error(bad, "edge 2 (1-1): a twist");
}

RC_GTEST_PROP(FenchelNielsenProperty, CuffsHaveTheirLengths, ()) {
  const FenchelNielsen coordinates = any_coordinates(5);
  const Surface surface = fenchel_nielsen_surface(coordinates);  // Checks that it is one.
  RC_ASSERT(surface.genus() == coordinates.graph.genus());
  RC_ASSERT(surface.vertex_class_count() == 3 * surface.genus() - 3);
  for (std::size_t e = 0; e < coordinates.lengths.size(); ++e) {
    const Mp1024 asked(coordinates.lengths[e]);
    for (const PantsGraph::End& end : coordinates.graph.edges()[e]) {
      const Mp1024 got = length_of(surface, cuff_word(surface, end));
      RC_ASSERT(abs(got - asked) <= ldexp(asked, -50));
    }
  }
}

/// Whatever the lengths are, twists of 0 and of half of the length give a surface, exactly or with a warning.
RC_GTEST_PROP(FenchelNielsenProperty, SymmetricTwistsGiveASurface, ()) {
  FenchelNielsen coordinates = any_coordinates(4);
  for (std::size_t e = 0; e < coordinates.twists.size(); ++e) {
    if (any_index(4u) == 0) continue;
    coordinates.twists[e] = any_index(2u) == 0 ? Rational(0) : Rational(coordinates.lengths[e] / 2);
    if (e > 0 && any_index(2u) == 0) coordinates.lengths[e] = coordinates.lengths[e - 1];
  }
  const Surface surface = fenchel_nielsen_surface(coordinates);
  RC_ASSERT(surface.genus() == coordinates.graph.genus());
  for (std::size_t e = 0; e < coordinates.lengths.size(); ++e) {
    const Mp1024 asked(coordinates.lengths[e]);
    for (const PantsGraph::End& end : coordinates.graph.edges()[e]) {
      RC_ASSERT(abs(length_of(surface, cuff_word(surface, end)) - asked) <= ldexp(asked, -50));
    }
  }
}

/// Two cuffs of one pair of pants at distance d (their common perpendicular), glued with a shift x: the closed
/// geodesic that crosses the cuff once has cosh(length/2) = cosh(d/2) cosh(x/2), as the product of translations along
/// perpendicular axes. The marks are half a cuff apart on the second cuff, where the mark is the foot of another
/// perpendicular; turns around the cuff shift by its length.
RC_GTEST_PROP(FenchelNielsenProperty, TwistsAreShiftsOfTheMarks, ()) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::chain(2), any_index(1'000'000u));
  coordinates.twists[0] *= any_index(2u) == 0 ? 1 : -1;
  const Surface surface = fenchel_nielsen_surface(coordinates);
  const Mp1024 cuff(coordinates.lengths[0]);
  const Mp1024 third(coordinates.lengths[1]);
  // The right-angled hexagon with alternating sides cuff/2, cuff/2, third/2.
  const Mp1024 c = cosh(Mp1024(cuff / 2));
  const Mp1024 cosh_d = (cosh(Mp1024(third / 2)) + c * c) / (c * c - 1);
  const Mp1024 cosh_half_d = sqrt(Mp1024((cosh_d + 1) / 2));
  std::vector<Mp1024> expected, got;
  for (int turns = -3; turns <= 3; ++turns) {
    const Mp1024 shift = Mp1024(coordinates.twists[0]) + cuff * (turns + Mp1024(0.5));
    expected.push_back(2 * acosh(Mp1024(cosh_half_d * cosh(Mp1024(shift / 2)))));
    Word word{cuff_side(surface, {0, 0})};
    for (int i = 0; i < std::abs(turns); ++i) {
      Word turn = cuff_word(surface, {0, 1});
      if (turns < 0) turn = reversed(surface, turn);
      for (const SideId side : turn) word.push_back(side);
    }
    got.push_back(length_of(surface, word));
  }
  // Where the counting of turns starts depends on the cut; the shortest ones are in both lists.
  std::sort(expected.begin(), expected.end());
  std::sort(got.begin(), got.end());
  for (std::size_t i = 0; i < 3; ++i) {
    RC_ASSERT(abs(expected[i] - got[i]) < ldexp(Mp1024(1), -45));
  }
}

// ---- Requests ----

void expect_request_error(const std::string& json, const std::string& problem) {
  try {
    (void)resolve(parse_fenchel_nielsen(json));
    ADD_FAILURE() << json;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(problem)) << json;
  }
}

TEST(FenchelNielsenRequest, NumbersAreExact) {
  const FenchelNielsen got = resolve(parse_fenchel_nielsen(
      R"({"graph": "0-1 0-1 0-1", "lengths": [0.1, "1/3", 1e-12], "twists": [ -0.25 , 0, "2"]})"));
  EXPECT_EQ(got.lengths, (std::vector<Rational>{Rational(1, 10), Rational(1, 3), Rational(1, 1'000'000'000'000)}));
  EXPECT_EQ(got.twists, (std::vector<Rational>{Rational(-1, 4), 0, 2}));
}

TEST(FenchelNielsenRequest, WhatIsLeftOutIsDrawn) {
  const FenchelNielsen got = resolve(parse_fenchel_nielsen(R"({"genus": 7, "seed": 3})"));
  EXPECT_EQ(got.graph.edges(), PantsGraph::random(7, 3).edges());
  EXPECT_EQ(got.lengths, random_coordinates(got.graph, 3).lengths);
  const FenchelNielsen one =
      resolve(parse_fenchel_nielsen(R"({"graph": "ring", "genus": 2, "lengths": ["0.5"], "seed": 1})"));
  EXPECT_EQ(one.lengths, (std::vector<Rational>(3, Rational(1, 2))));
  for (const Rational& twist : one.twists) {
    EXPECT_TRUE(twist >= 0 && twist < Rational(1, 2));
  }
}

TEST(FenchelNielsenRequest, WhatIsGivenIsCheckedBeforeASeedIsAskedFor) {
  const auto blamed = [](const std::string& json) {
    try {
      (void)resolve(parse_fenchel_nielsen(json));
    } catch (const FenchelNielsenRequestError& error) {
      return error.member();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(blamed(R"({"genus": 1})"), "genus");
  EXPECT_EQ(blamed(R"({"genus": 4000000000})"), "genus");
  EXPECT_EQ(blamed("{}"), "genus");
  EXPECT_EQ(blamed(R"({"genus": 2, "lengths": [1, 2]})"), "lengths");
  EXPECT_EQ(blamed(R"({"genus": 2, "twists": ["x"]})"), "twists");
  EXPECT_EQ(blamed(R"({"graph": "star", "genus": 2})"), "graph");
  EXPECT_EQ(blamed(R"({"graph": "0-0 0-0 1-1"})"), "graph");
  EXPECT_EQ(blamed(R"({"genus": 2, "lengths": [1], "twists": [0]})"), "nothing");
  EXPECT_EQ(blamed(R"({"genus": 2, "graph": "random", "lengths": [1], "twists": [0]})"), "seed");
  EXPECT_EQ(blamed(R"({"genus": 3, "lengths": [1], "twists": [0]})"), "graph");
  EXPECT_EQ(blamed(R"({"lengths": [1, 1, 1, 1, 1, 1], "twists": [0]})"), "graph");
  EXPECT_EQ(blamed(R"({"genus": 3, "graph": "theta", "seed": 1})"), "graph");
  EXPECT_EQ(resolve(parse_fenchel_nielsen(R"({"graph": "theta", "seed": 1})")).graph.genus(), 2U);
  EXPECT_EQ(blamed(R"({"graph": "ring", "genus": 2, "lengths": [1], "twists": [0]})"), "nothing");
}

TEST(FenchelNielsenRequest, BadOnesAreNamed) {
  expect_request_error("",
                       "expected an object with members graph, genus, seed, lengths, twists, not the end of the text");
  expect_request_error("[]", "expected an object");
  expect_request_error("{", "expected");
  expect_request_error(R"({"genus": 2, "seed": 1} x)", "something follows the object");
  expect_request_error(R"({"Genus": 2})", "unknown member \"Genus\"");
  expect_request_error(R"({"genus": 2, "seed": 1, "genus": 3})", "member \"genus\" occurs twice");
  expect_request_error(R"({"genus": -2})", "genus: an integer");
  expect_request_error(R"({"genus": 02})", "genus: an integer");
  expect_request_error(R"({"seed": 18446744073709551616})", "seed: an integer");
  expect_request_error(R"({"genus": })", "expected genus: an integer, not \"}\"");
  expect_request_error(R"({"genus": 2, "seed" 1})", "not JSON");
  expect_request_error(R"({"genus": 2, "lengths": [1 2]})", "not JSON");
  expect_request_error(R"({"genus": 2})", "seed: needed to draw a pants graph and lengths and twists, or give them");
  expect_request_error(R"({"genus": 2, "lengths": [1, 2, 3]})", "seed: needed to draw a pants graph and twists, or");
  expect_request_error(R"({"graph": "theta", "lengths": [1, 2, 3]})", "seed: needed to draw twists, or give them");
  expect_request_error(R"({"graph": "theta", "twists": [1, 2, 3]})", "seed: needed to draw lengths, or give them");
  expect_request_error(R"({"seed": 2})", "genus: needed");
  expect_request_error(R"({"genus": 3, "graph": "0-1 0-1 0-1", "seed": 1})", "the pants graph has genus 2");
  expect_request_error(R"({"graph": "star", "genus": 2})", "expected chain, ring, tree, theta, random");
  expect_request_error(R"({"graph": "ring", "genus": 2, "lengths": [1, 2], "seed": 1})", "expected 1 or 3");
  expect_request_error(R"({"graph": "ring", "genus": 2, "lengths": [NaN], "seed": 1})", "lengths");
  expect_request_error(R"({"graph": "ring", "genus": 2, "lengths": ["abc"], "seed": 1})", "not \"abc\"");
  expect_request_error(R"({"graph": "ring", "genus": 2, "lengths": 1, "seed": 1})", "lengths: an array");
}

}  // namespace
}  // namespace epsnet::fenchel_nielsen_test
