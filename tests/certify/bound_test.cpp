#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "certify/claims/bound/triangles.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "tests/certify/claim_files.h"
#include "tests/certify/moving_vertex.h"
#include "tests/certify/reference.h"
#include "tests/certify/turned.h"

/// Bound files. Each rule is broken by a file in which nothing else is wrong.
namespace epsnet::certify::bound_test {
namespace {

using testing::HasSubstr;
using Claim = BoundDocument::Claim;

BoundDocument load(const std::string& name) {
  return read_file<BoundDocument>(std::string(EPSNET_TEST_DATA) + "/bounds/" + name + ".json");
}

/// The diameter of the regular surface of genus 2, to all digits.
BoundDocument regular() { return load("regular-diameter"); }
/// The diameter of a random octagon, to within 1/2.
BoundDocument octagon() { return load("octagon-diameter"); }
/// The largest embedded disk of the same, to within 1/100.
BoundDocument disk() { return load("octagon-embedded-disk"); }

/// The radius of another octagon, to within 3/10.
BoundDocument octagon_radius() { return load("octagon-radius"); }

std::vector<BoundDocument> all_files() { return {regular(), octagon(), disk()}; }

/// The same claims, with cells cut from a base.
BoundDocument octagon_from_base() { return load("octagon-diameter-base"); }
std::vector<BoundDocument> files_with_base() {
  return {octagon_from_base(), load("octagon-embedded-disk-base"), load("octagon-radius-base")};
}

/// And with cells cut from a domain: of the hyperelliptic involution, and of the 96 isometries of Bolza's surface.
BoundDocument octagon_from_domain() { return load("octagon-diameter-domain"); }
BoundDocument bolza_from_domain() { return load("bolza-radius-domain"); }
std::vector<BoundDocument> files_with_domain() {
  // The vertex of the last one is in another tile than the words of its isometries.
  return {octagon_from_domain(), load("octagon-embedded-disk-domain"), load("octagon-radius-domain"),
          bolza_from_domain(), load("two-tiles-embedded-disk-domain")};
}

std::vector<BoundDocument> all_files_and_domains() {
  std::vector<BoundDocument> result = all_files();
  for (BoundDocument& document : files_with_domain()) result.push_back(std::move(document));
  return result;
}

/// arcosh(cot²(π/8)): from the centre of the octagon to its corner.
double regular_diameter() { return std::acosh(std::pow(std::tan(std::numbers::pi / 8), -2)); }

/// What the net says of its vertex: its eccentricity, or its injectivity radius, half of the shortest loop.
Interval at_vertex(const BoundDocument& document) {
  const Certificate certificate = check(document.net, {.threads = 2});
  if (document.claim != Claim::embedded_disk) return certificate.enclosures->largest_circumradius;
  const Interval loop = *certificate.enclosures->shortest_loop;
  return {loop.lower / 2, loop.upper / 2};
}

double above(double x) { return std::nextafter(x, 2 * x); }
double below(double x) { return std::nextafter(x, 0.0); }

/// How many of the documents that `change` makes, one for every leaf, are refuted by the rule `cells`; all others are
/// verified.
std::size_t refuted_by_cells(const BoundDocument& document,
                             const std::function<std::vector<std::uint32_t>(std::uint32_t)>& others) {
  std::size_t refuted = 0;
  for (std::size_t t = 0; t < document.cells.size(); ++t) {
    for (std::size_t i = 0; i < document.cells[t].size(); ++i) {
      const std::uint32_t leaf = document.cells[t][i];
      if (leaf < 3) continue;
      for (const std::uint32_t other : others(leaf)) {
        BoundDocument changed = document;
        changed.cells[t][i] = other;
        const Certificate certificate = checked(changed);
        if (certificate.verdict == Verdict::verified) continue;
        EXPECT_EQ(certificate.verdict, Verdict::refuted);
        EXPECT_EQ(certificate.rule, "cells");
        EXPECT_THAT(certificate.message, HasSubstr("of triangle " + std::to_string(t) + " is not bounded by"));
        ++refuted;
      }
    }
  }
  return refuted;
}

TEST(Bound, FilesAreVerifiedByTheRulesOfTheNetAndThreeMore) {
  for (const BoundDocument& document : all_files()) {
    const Certificate certificate = checked(document);
    EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
    ASSERT_EQ(certificate.rules.size(), 10U);
    EXPECT_EQ(certificate.rules[7].rule, "lower");
    EXPECT_EQ(certificate.rules[8].rule, "triangulations");
    EXPECT_EQ(certificate.rules[9].rule, "cells");
    const bool diameter = document.claim == Claim::diameter;
    EXPECT_EQ(certificate.claim, std::string(diameter ? "the diameter" : "the radius of the largest embedded disk") +
                                     " lies in " + to_string(document.value));
  }
  EXPECT_LT(regular().value.lower, regular_diameter());
  EXPECT_GT(regular().value.upper, regular_diameter());
}

TEST(BoundFromABase, IsVerified) {
  for (const BoundDocument& document : files_with_base()) {
    ASSERT_FALSE(document.base.empty());
    const Certificate certificate = checked(document);
    EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
    EXPECT_THAT(certificate.rules[8].text, HasSubstr("; the base: "));
  }
}

/// Steps lead to other points and triangles, whose cells are not bounded.
TEST(BoundFromABase, AnotherStepIsNotVerifiedUnlessItIsTrue) {
  int refuted = 0;
  for (const BoundDocument& good : files_with_base()) {
    const double value = good.claim == Claim::radius ? good.value.upper : good.value.lower;
    for (std::size_t k = 0; k < good.base.size(); ++k) {
      BoundDocument document = good;
      document.base[k] ^= 2U;
      const std::string found = outcome(document);
      EXPECT_THAT(found, testing::AnyOf("VERIFIED", "REFUTED: cells", "REFUTED: triangulations"));
      refuted += found == "REFUTED: cells" ? 1 : 0;
      // What is verified is true: then no such file proves a bound on the other side of the value at the vertex.
      (good.claim == Claim::radius ? document.value.lower : document.value.upper) = value;
      EXPECT_THAT(outcome(document), testing::AnyOf("REFUTED: cells", "REFUTED: triangulations"));
    }
  }
  EXPECT_GT(refuted, 10);
}

/// Cells that are left out would leave a part of the surface without bound.
TEST(BoundFromABase, HasARowOfCellsForEachTriangle) {
  for (const BoundDocument& good : files_with_base()) {
    const auto triangles = std::to_string(good.cells.size());
    BoundDocument document = good;
    document.cells.pop_back();
    EXPECT_THAT(structure_complaint(document), HasSubstr("expected one for each of the " + triangles + " triangles"));
    document = good;
    document.base.push_back(1);
    EXPECT_THAT(structure_complaint(document), HasSubstr("cells: " + triangles + " elements, expected one for each"));
    document = good;
    const auto last = static_cast<std::uint32_t>(3 * good.cells.size());
    document.base.push_back(2 * last);
    EXPECT_THAT(structure_complaint(document), HasSubstr("base[" + std::to_string(good.base.size()) + "]: dart " +
                                                         std::to_string(last) + " does not exist"));
    // Darts of triangles that are made only later.
    document = good;
    document.base.insert(document.base.begin(), 2 * (last - 1));
    EXPECT_THAT(structure_complaint(document), HasSubstr("base[0]: dart"));
  }
}

/// A vertex with one edge: the edge has one triangle on both sides.
TEST(BoundFromABase, AnEdgeOfOneTriangleIsNeitherFlippedNorSplit) {
  BoundDocument document = octagon();
  const std::uint32_t darts = static_cast<std::uint32_t>(3 * document.net.triangles.size());
  // So weak a bound that all triangles prove it.
  document.value.upper = 30;
  document.cells.assign(document.cells.size() + 2, {3});
  // The new vertex m has the edges to a, c, b and x, of which all but one are flipped away.
  const std::uint32_t d = 0;
  const std::uint32_t e = opposite(document.net, d);
  const std::uint32_t to_c = next_dart(d);
  const std::uint32_t to_x = next_dart(e);
  document.base = {2 * d + 1, 2 * to_c, 2 * to_x, 2 * d};
  EXPECT_EQ(outcome(document), "VERIFIED");
  for (const std::uint32_t kind : {0U, 1U}) {
    BoundDocument wrong = document;
    if (kind == 1) wrong.cells.resize(wrong.cells.size() + 2, {3});
    std::vector<std::uint32_t> found;
    for (std::uint32_t dart = 0; dart < darts + 6; ++dart) {
      wrong.base = document.base;
      wrong.base.push_back(2 * dart + kind);
      const std::string of_dart = outcome(wrong);
      if (of_dart == "VERIFIED") continue;
      EXPECT_EQ(of_dart, "REFUTED: triangulations");
      found.push_back(dart);
      EXPECT_THAT(checked(wrong).message,
                  HasSubstr("base: dart " + std::to_string(dart) +
                            " has the same triangle on both sides and cannot be " + (kind == 0 ? "flipped" : "split")));
    }
    // Both darts of the edge.
    ASSERT_EQ(found.size(), 2U) << kind;
    EXPECT_EQ(found[0] / 3, found[1] / 3) << kind;
  }
}

/// The triangles around the centre.
Domain::Placed placed_domain(const BoundDocument& document, slong precision) {
  const LabelParts parts = label_parts(check_surface(document.net.surface).crossings, document.net.charts, Budget());
  return Domain(document.net, *document.symmetry, parts).place(precision, precision, 1);
}

std::vector<std::array<BallVector, 3>> domain_of(const BoundDocument& document) {
  Domain::Placed placed = placed_domain(document, 256);
  EXPECT_EQ(placed.surrounds, Tri::yes);
  return std::move(placed.triangles);
}

double cosh_distance(const BallVector& p, const BallVector& q) {
  return -fast_interval(lorentz_product(p, q, 256)).lower;
}

TEST(BoundInADomain, IsVerifiedByTwoMoreRules) {
  for (const BoundDocument& document : files_with_domain()) {
    const Certificate certificate = checked(document);
    EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
    ASSERT_EQ(certificate.rules.size(), 12U);
    EXPECT_EQ(certificate.rules[9].rule, "isometries");
    EXPECT_EQ(certificate.rules[10].rule, "domain");
    EXPECT_EQ(certificate.rules[10].text,
              std::to_string(document.symmetry->isometries.size()) + " sides around the centre");
    EXPECT_EQ(certificate.rules[11].rule, "cells");
  }
}

TEST(BoundInADomain, EnclosesTheSameNumberAsOneOfTheWholeSurface) {
  const auto expect_overlap = [](Interval x, Interval y) {
    EXPECT_LT(x.lower, y.upper);
    EXPECT_LT(y.lower, x.upper);
  };
  expect_overlap(octagon_from_domain().value, octagon().value);
  expect_overlap(load("octagon-embedded-disk-domain").value, disk().value);
  expect_overlap(load("octagon-radius-domain").value, octagon_radius().value);
}

/// The domain of the isometries of Bolza's surface is the triangle of the mirrors, with the angles π/2, π/3 and π/8:
/// cosh a = cos α/sin β for the legs, and cot α cot β for the side opposite to the right angle.
TEST(BoundInADomain, OfReflectionsIsTheTriangleOfTheirMirrors) {
  const double third = std::numbers::pi / 3;
  const double eighth = std::numbers::pi / 8;
  std::vector<double> sides;
  for (const auto& [centre, p, q] : domain_of(bolza_from_domain())) sides.push_back(cosh_distance(p, q));
  std::sort(sides.begin(), sides.end());
  ASSERT_EQ(sides.size(), 3U);
  EXPECT_NEAR(sides[0], std::cos(eighth) / std::sin(third), 1e-12);
  EXPECT_NEAR(sides[1], std::cos(third) / std::sin(eighth), 1e-12);
  EXPECT_NEAR(sides[2], 1 / (std::tan(third) * std::tan(eighth)), 1e-12);
}

/// Wherever the centre is between the mirrors; elsewhere they do not surround it.
TEST(BoundInADomain, OfReflectionsDoesNotDependOnTheCentre) {
  BoundDocument document = bolza_from_domain();
  const double right_angle = 1 / (std::tan(std::numbers::pi / 3) * std::tan(std::numbers::pi / 8));
  int inside = 0;
  int outside = 0;
  for (int x = -14; x <= 6; x += 2) {
    for (int y = -14; y <= 6; y += 2) {
      document.symmetry->centre = {x / 100.0, y / 100.0};
      const std::string verdict = outcome(document);
      if (verdict == "REFUTED: domain") {
        ++outside;
        continue;
      }
      double longest = 1;
      for (const auto& [centre, p, q] : domain_of(document)) longest = std::max(longest, cosh_distance(p, q));
      EXPECT_NEAR(longest, right_angle, 1e-12) << x << " " << y << ": " << verdict;
      ++inside;
    }
  }
  EXPECT_GT(inside, 3);
  EXPECT_GT(outside, 20);
}

/// The domains of a group of order n have the area 4π(g − 1)/n: they meet at their sides alone.
TEST(BoundInADomain, HasTheAreaOfTheSurfaceDividedByTheOrder) {
  for (const BoundDocument& document : files_with_domain()) {
    double area = 0;
    for (const auto& [centre, p, q] : domain_of(document)) {
      const auto half = [](const BallVector& u, const BallVector& v) { return (cosh_distance(u, v) - 1) / 2; };
      const double a = half(p, q);
      const double b = half(q, centre);
      const double c = half(centre, p);
      const double k = 4 * a * b - std::pow(a + b - c, 2);
      area += 2 * std::atan(std::sqrt(k + 4 * a * b * c) / (2 + a + b + c));
    }
    const double order = document == bolza_from_domain() ? 96 : 2;
    EXPECT_NEAR(area, 4 * std::numbers::pi / order, 1e-9);
  }
}

TEST(BoundInADomain, CellsAreThoseOfTheirOwnTriangles) {
  for (const BoundDocument& good : files_with_domain()) {
    for (std::size_t t = 0; t < good.cells.size(); ++t) {
      BoundDocument document = good;
      document.cells[t] = {good.claim == Claim::radius ? 3U : 4U};
      if (document.cells[t] == good.cells[t]) continue;
      const Certificate certificate = checked(document);
      if (certificate.verdict == Verdict::verified) continue;
      EXPECT_EQ(outcome(document), "REFUTED: cells");
      EXPECT_THAT(certificate.message, HasSubstr("of triangle " + std::to_string(t) + " is not bounded"));
    }
  }
}

TEST(BoundInADomain, RowsThatAreNoIsometriesAreRefuted) {
  for (const BoundDocument& good : files_with_domain()) {
    for (std::size_t i = 0; i < good.symmetry->isometries.size(); ++i) {
      BoundDocument document = good;
      bool& preserves = document.symmetry->isometries[i].preserves_orientation;
      preserves = !preserves;
      EXPECT_EQ(outcome(document), "REFUTED: isometries") << i;
      preserves = !preserves;
      auto& images = document.symmetry->isometries[i].images;
      for (std::size_t k = 2; k < images.size(); ++k) {
        std::swap(images[k], images[1]);
        const bool is_changed = images[k] != images[1];
        EXPECT_EQ(outcome(document), is_changed ? "REFUTED: isometries" : "VERIFIED") << i << " " << k;
        std::swap(images[k], images[1]);
      }
    }
    BoundDocument document = good;
    document.symmetry->pair[1] = document.symmetry->pair[0];
    EXPECT_EQ(outcome(document), "REFUTED: isometries");
  }
}

TEST(BoundInADomain, SidesThatDoNotSurroundTheCentreAreRefuted) {
  for (const BoundDocument& good : files_with_domain()) {
    BoundDocument document = good;
    std::reverse(document.symmetry->isometries.begin(), document.symmetry->isometries.end());
    EXPECT_EQ(outcome(document), "REFUTED: domain");
    if (good.symmetry->isometries.size() < 6) continue;
    document = good;
    document.symmetry->isometries.resize(3);
    document.cells.resize(3);
    EXPECT_EQ(outcome(document), "REFUTED: domain");
  }
  // Half of a turn and more: the sides of one half alone, whose first and last lines do not meet there.
  BoundDocument document = octagon_from_domain();
  auto& rows = document.symmetry->isometries;
  const std::size_t half = rows.size() / 2;
  rows.resize(half);
  document.cells.resize(half);
  EXPECT_EQ(outcome(document), "REFUTED: domain");
}

/// Of a domain of many sides some lines do not meet.
TEST(BoundInADomain, LinesThatDoNotMeetAreRefuted) {
  const BoundDocument good = octagon_from_domain();
  const auto& rows = good.symmetry->isometries;
  int apart = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = i + 2; k < rows.size(); ++k) {
      BoundDocument document = good;
      document.symmetry->isometries = {rows[i], rows[k], rows[(k + 1) % rows.size()]};
      document.cells.resize(3);
      const Domain::Placed placed = placed_domain(document, 256);
      EXPECT_EQ(outcome(document) == "REFUTED: domain", placed.surrounds == Tri::no) << i << " " << k;
      apart += placed.surrounds == Tri::no ? 1 : 0;
    }
  }
  EXPECT_GT(apart, 10);
}

/// With few bits nothing is decided wrongly: what is said of the corners then is true of them.
TEST(BoundInADomain, FewBitsDecideNothingWrongly) {
  int rounded_away = 0;  // The determinant is computed in another order here.
  for (const BoundDocument& document : files_with_domain()) {
    const std::vector<std::array<BallVector, 3>> known = domain_of(document);
    int decided = 0;
    int open = 0;
    for (slong precision = 2; precision <= 100; ++precision) {
      const Domain::Placed placed = placed_domain(document, precision);
      EXPECT_NE(placed.surrounds, Tri::no) << precision;
      if (placed.surrounds != Tri::yes) {
        EXPECT_TRUE(placed.triangles.empty());
        ++open;
        continue;
      }
      ++decided;
      ASSERT_EQ(placed.triangles.size(), known.size());
      for (std::size_t t = 0; t < known.size(); ++t) {
        const auto& [o, p, q] = placed.triangles[t];
        const Precision scope(precision);
        const Tri turns = certainly_positive(o[0] * (p[1] * q[2] - p[2] * q[1]) + o[1] * (p[2] * q[0] - p[0] * q[2]) +
                                             o[2] * (p[0] * q[1] - p[1] * q[0]));
        EXPECT_NE(turns, Tri::no) << precision;
        rounded_away += turns == Tri::unknown ? 1 : 0;
        for (std::size_t corner = 0; corner < 3; ++corner) {
          for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NE(arb_overlaps(placed.triangles[t][corner][i].get(), known[t][corner][i].get()), 0) << precision;
          }
        }
      }
    }
    EXPECT_GT(decided, 10);
    EXPECT_GT(open, 5);
  }
  EXPECT_LE(rounded_away, 4);
}

/// A line that is there twice meets itself nowhere in particular.
TEST(BoundInADomain, EqualSidesAreNotDecided) {
  BoundDocument document = bolza_from_domain();
  document.symmetry->isometries.push_back(document.symmetry->isometries.back());
  document.cells.push_back(document.cells.back());
  EXPECT_EQ(outcome(document), "UNDECIDED: domain");
}

TEST(BoundInADomain, EveryDefectIsMalformed) {
  const auto complaint = [](const std::function<void(BoundDocument&)>& change) {
    BoundDocument document = bolza_from_domain();
    change(document);
    return structure_complaint(document);
  };
  using Document = BoundDocument;
  EXPECT_THAT(complaint([](Document& d) { d.base = {1}; }), HasSubstr("base: expected none beside a symmetry"));
  EXPECT_THAT(complaint([](Document& d) {
                d.symmetry->centre = {0.6, 0.8};
              }),
              HasSubstr("symmetry: centre: not in the disk"));
  EXPECT_THAT(complaint([](Document& d) { d.symmetry->isometries.pop_back(); }),
              HasSubstr("symmetry: isometries: 2 rows, expected at least 3"));
  EXPECT_THAT(complaint([](Document& d) { d.symmetry->isometries[1].images.pop_back(); }),
              HasSubstr("symmetry: isometries[1]: 5 words, expected 6"));
  EXPECT_THAT(complaint([](Document& d) { d.symmetry->pair.pop_back(); }), HasSubstr("symmetry: pair: 1 words"));
  EXPECT_THAT(complaint([](Document& d) { d.symmetry->paths.clear(); }), HasSubstr("symmetry: paths: 0 words"));
  EXPECT_THAT(complaint([](Document& d) { d.symmetry->pair[0] = {99}; }), HasSubstr("symmetry: pair: word 0"));
  EXPECT_THAT(complaint([](Document& d) { d.cells.pop_back(); }),
              HasSubstr("cells: 2 elements, expected one for each of the 3 triangles"));
}

TEST(Bound, ANetThatIsNotValidIsRefutedByItsOwnRule) {
  BoundDocument document = regular();
  document.net.epsilon = "0.1";
  EXPECT_EQ(outcome(document), "REFUTED: covering");
}

TEST(Bound, ALowerBoundAboveTheValueAtTheVertexIsRefuted) {
  for (BoundDocument document : all_files()) {
    document.value.lower += 1e-12;
    document.value.upper += 1e-12;
    EXPECT_EQ(outcome(document), "REFUTED: lower");
  }
}

/// The largest bound for which the rule at the vertex has this verdict, of those from `least` up to a greater one for
/// which it does not. Every bound is decided, and none above it has the verdict again.
double last_with(const std::string& wanted, double least, double greatest, const BoundDocument& document) {
  const bool radius = document.claim == Claim::radius;
  const auto verdict = [&](double bound) {
    BoundDocument changed = document;
    (radius ? changed.value.upper : changed.value.lower) = bound;
    changed.value.lower = std::min(changed.value.lower, changed.value.upper);
    changed.value.upper = std::max(changed.value.lower, changed.value.upper);
    return verdict_of(radius ? "upper" : "lower", changed);
  };
  double last = 0;
  bool ended = false;
  for (double bound = least; bound <= greatest; bound = above(bound)) {
    const std::string found = verdict(bound);
    EXPECT_TRUE(found == "VERIFIED" || found == "REFUTED") << bound << ": " << found;
    if (found != wanted) ended = true;
    if (found == wanted) {
      EXPECT_FALSE(ended) << bound;
      last = bound;
    }
  }
  EXPECT_TRUE(ended);
  return last;
}

/// To the last bit: the enclosure that is printed has several binary64 numbers inside, and balls decide all of them.
TEST(Bound, TheLowerBoundIsComparedWithTheValueAtTheVertex) {
  for (const BoundDocument& document : all_files()) {
    const Interval found = at_vertex(document);
    ASSERT_LT(above(found.lower), below(found.upper));
    const double last = last_with("VERIFIED", below(found.lower), above(found.upper), document);
    EXPECT_GE(last, found.lower);
    EXPECT_LT(last, found.upper);
  }
}

/// The net with the triangle of a dart begun so that this dart is number i of it.
NetDocument turned_until(NetDocument net, std::uint32_t dart, std::uint32_t i) {
  for (std::uint32_t turns = (dart % 3 + 3 - i) % 3; turns > 0; --turns) net = turned(std::move(net), dart / 3);
  return net;
}

/// With the triangles numbered from another one on.
BoundDocument renumbered(BoundDocument document, std::uint32_t shift) {
  const auto count = static_cast<std::uint32_t>(document.net.triangles.size());
  const auto new_dart = [&](std::uint32_t dart) { return (dart + 3 * shift) % (3 * count); };
  for (auto& triangle : document.net.triangles) {
    for (std::uint32_t& dart : triangle.opposite) dart = new_dart(dart);
  }
  for (auto& row : document.triangulations) {
    for (std::uint32_t& dart : row.flips) dart = new_dart(dart);
  }
  std::rotate(document.net.triangles.rbegin(), document.net.triangles.rbegin() + shift, document.net.triangles.rend());
  std::rotate(document.cells.rbegin(), document.cells.rbegin() + shift, document.cells.rend());
  return document;
}

/// Whichever of the sides of its two triangles the shortest edge is.
TEST(Bound, TheShortestEdgeIsFoundWhereverItIs) {
  BoundDocument document = disk();
  const NetDocument net = document.net;
  const Reference reference(net);
  std::uint32_t shortest = 0;
  Real least = 1e9;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const auto z = reference.corners(dart / 3);
    const Real length = squared_half_sinh(z[dart % 3], z[(dart + 1) % 3]);
    if (length < least) shortest = dart;
    least = std::min(least, length);
  }
  const Interval found = at_vertex(document);
  for (const std::uint32_t i : {0U, 1U, 2U}) {
    document.net = turned_until(turned_until(net, shortest, i), opposite(net, shortest), i);
    document.value = {found.lower - 1e-9, 10};
    EXPECT_EQ(verdict_of("lower", document), "VERIFIED") << i;
    document.value = {found.upper + 1e-9, 10};
    EXPECT_EQ(verdict_of("lower", document), "REFUTED") << i;
  }
}

/// Of all triangles the one whose circumcircle is the greatest, or whose edge is the shortest, may be any.
TEST(Bound, TheTriangleThatDecidesAtTheVertexMayBeAny) {
  for (const BoundDocument& good : {octagon(), disk(), octagon_radius()}) {
    const bool radius = good.claim == Claim::radius;
    const Interval found = at_vertex(good);
    for (std::uint32_t shift = 0; shift < good.net.triangles.size(); ++shift) {
      BoundDocument document = renumbered(good, shift);
      const auto verdict = [&](double bound) {
        document.value = radius ? Interval{bound / 2, bound} : Interval{bound, 2 * bound};
        return verdict_of(radius ? "upper" : "lower", document);
      };
      EXPECT_EQ(verdict(found.lower - 1e-9), radius ? "REFUTED" : "VERIFIED") << shift;
      EXPECT_EQ(verdict(found.upper + 1e-9), radius ? "VERIFIED" : "REFUTED") << shift;
    }
  }
}

/// Where the bound of a cell is the value to the last digits, intervals decide as balls do, or not at all.
TEST(SlowBound, IntervalsDecideCellsAsBallsDo) {
  std::vector<BoundDocument> files{octagon(), disk(), octagon_radius()};
  for (BoundDocument document : files) {
    const bool radius = document.claim == Claim::radius;
    double& bound = radius ? document.value.lower : document.value.upper;
    const auto holds = [&](bool filter) {
      const Certificate certificate = check(document, {.threads = 2, .filter = filter});
      return certificate.rules.size() == 10 && certificate.rules[9].verdict == Verdict::verified;
    };
    (radius ? document.value.upper : document.value.lower) = radius ? 10 : 1e-3;
    double good = bound;
    double bad = radius ? bound + 0.5 : bound - 0.5;
    bound = bad;
    ASSERT_FALSE(holds(false));
    while (std::abs(good - bad) > 1e-15) {
      bound = good / 2 + bad / 2;
      if (bound == good || bound == bad) break;
      (holds(true) ? good : bad) = bound;
    }
    bound = good;
    for (int i = 0; i < 4; ++i) bound = below(bound);
    for (int i = 0; i < 9; ++i, bound = above(bound)) EXPECT_EQ(holds(true), holds(false)) << bound;
  }
}

/// The eccentricity of the centre of the regular octagon, arcosh(cot²(π/8)), rounded down.
TEST(Bound, TheLowerBoundIsComparedWithAKnownValueAtTheVertex) {
  Ball value;
  arb_const_pi(value.get(), 300);
  arb_mul_2exp_si(value.get(), value.get(), -3);
  arb_cot(value.get(), value.get(), 300);
  arb_sqr(value.get(), value.get(), 300);
  arb_acosh(value.get(), value.get(), 300);
  const double rounded = outer_interval(value).lower;
  EXPECT_EQ(last_with("VERIFIED", rounded - 1e-15, rounded + 1e-15, regular()), rounded);
}

/// The rule that has no work left is the one that is open.
TEST(Bound, WithoutWorkTheRuleThatIsAskedIsUndecided) {
  std::vector<std::string> open;
  const std::uint64_t all = checked(regular()).counts.work;
  const std::uint64_t net = check(regular().net, {.threads = 2}).counts.work;
  for (std::uint64_t work = net; work < all; work += (all - net) / 200 + 1) {
    const Certificate certificate = check(regular(), {.threads = 2, .max_work = work});
    EXPECT_EQ(certificate.verdict, Verdict::undecided);
    ASSERT_FALSE(certificate.rules.empty());
    EXPECT_EQ(certificate.rule, certificate.rules.back().rule);
    EXPECT_THAT(certificate.message, HasSubstr("more work"));
    if (open.empty() || open.back() != certificate.rule) open.push_back(certificate.rule);
  }
  EXPECT_THAT(open, testing::ElementsAre("lower", "triangulations", "cells"));
}

/// The vertex need not be the centre of its chart: what is said is the same as in a chart of which it is.
TEST(Bound, TheVertexMayBeAnywhereInItsChart) {
  for (BoundDocument moved : {octagon(), disk()}) {
    const mpq_class x(1, 512), y(1, 1024);
    NetDocument::Chart& chart = moved.net.charts[0];
    ASSERT_EQ(moved.net.charts.size(), 1U);
    // (z + c)/(1 + c̄z).
    const mpq_class a = chart.centre.x, b = chart.centre.y;
    const mpq_class re = 1 + a * x + b * y, im = a * y - b * x;
    const mpq_class square = re * re + im * im;
    BoundDocument centred = moved;
    centred.net.charts[0].centre = {((x + a) * re + (y + b) * im) / square, ((y + b) * re - (x + a) * im) / square};
    moved.net.vertices[0] = {x.get_d(), y.get_d(), 0};
    const Interval found = at_vertex(centred);
    const auto holds = [&](BoundDocument& document, double bound) {
      document.value = {found.lower, bound};
      return outcome(document) == "VERIFIED";
    };
    double good = found.lower + 1;
    double bad = found.lower;
    ASSERT_TRUE(holds(centred, good));
    ASSERT_FALSE(holds(centred, bad));
    while (std::abs(good - bad) > 1e-10) {
      const double middle = (good + bad) / 2;
      (holds(centred, middle) ? good : bad) = middle;
    }
    EXPECT_TRUE(holds(moved, good));
    EXPECT_FALSE(holds(moved, bad));
  }
}

TEST(Bound, AnUpperBoundBelowThatOfACellIsRefuted) {
  for (BoundDocument document : all_files()) {
    document.value.lower -= 1e-6;
    document.value.upper -= 1e-9;
    EXPECT_EQ(outcome(document), "REFUTED: cells");
    document.value.upper = document.value.lower;
    EXPECT_EQ(outcome(document), "REFUTED: cells");
  }
}

TEST(Bound, WiderBoundsHold) {
  for (BoundDocument document : all_files()) {
    document.value.lower = std::numeric_limits<double>::denorm_min();
    document.value.upper += 1;
    EXPECT_EQ(outcome(document), "VERIFIED");
  }
}

TEST(Bound, ACellWithTheTriangulationOfTheNetMayBeRefuted) {
  const auto net = [](std::uint32_t leaf) {
    return leaf == 3 ? std::vector<std::uint32_t>{} : std::vector<std::uint32_t>{3};
  };
  // On the regular surface hardly any cell is bounded to all digits by a triangulation that is not its own.
  EXPECT_GT(refuted_by_cells(regular(), net), 30U);
  EXPECT_GT(refuted_by_cells(octagon(), net), 10U);
}

TEST(DeepBound, ACellWithAnotherDartMayBeRefuted) {
  const auto darts = static_cast<std::uint32_t>(3 * disk().net.triangles.size());
  const auto others = [&](std::uint32_t leaf) {
    std::vector<std::uint32_t> result;
    const std::uint32_t first = leaf - (leaf - 3) % darts;
    for (std::uint32_t dart = 0; dart < darts; ++dart) {
      if (first + dart != leaf) result.push_back(first + dart);
    }
    return result;
  };
  std::size_t leaves = 0;
  for (const auto& row : disk().cells) {
    for (const std::uint32_t entry : row) leaves += entry >= 3 ? 1 : 0;
  }
  // The dart on the other side of the edge does it too; most of the sixteen others do not.
  EXPECT_GT(refuted_by_cells(disk(), others), 8 * leaves);
}

TEST(SlowBound, AFlipThatIsLeftOutIsRefuted) {
  for (const BoundDocument& document : all_files()) {
    std::size_t refuted = 0;
    for (std::size_t k = 0; k < document.triangulations.size(); ++k) {
      for (std::size_t i = 0; i < document.triangulations[k].flips.size(); ++i) {
        BoundDocument without = document;
        auto& flips = without.triangulations[k].flips;
        flips.erase(flips.begin() + static_cast<std::ptrdiff_t>(i));
        const std::string found = outcome(without);
        if (found == "VERIFIED") continue;
        EXPECT_EQ(found, "REFUTED: cells");
        ++refuted;
      }
    }
    EXPECT_GT(refuted, document.triangulations.size() / 2);
  }
}

/// A triangle that is glued to itself would leave a corner alone, a second vertex.
TEST(Bound, OfATriangulationWithOneVertexEveryDartCanBeFlipped) {
  std::mt19937 random(7);
  for (BoundDocument document : all_files()) {
    const auto darts = static_cast<std::uint32_t>(3 * document.net.triangles.size());
    for (int row = 0; row < 20; ++row) {
      std::vector<std::uint32_t> flips(100);
      for (std::uint32_t& flip : flips) flip = static_cast<std::uint32_t>(random()) % darts;
      document.triangulations.push_back({static_cast<std::uint32_t>(document.triangulations.size()), flips});
    }
    EXPECT_EQ(check(document, {.threads = 2, .max_work = std::uint64_t{1} << 50}).verdict, Verdict::verified);
  }
}

/// Two flips of an edge turn it by half a turn; so four are none, whatever follows.
TEST(Bound, FourFlipsOfAnEdgeAreNone) {
  for (const BoundDocument& document : all_files()) {
    const auto darts = static_cast<std::uint32_t>(3 * document.net.triangles.size());
    BoundDocument turned = document;
    for (std::size_t k = 0; k < turned.triangulations.size(); ++k) {
      auto& flips = turned.triangulations[k].flips;
      flips.insert(flips.begin(), 4, static_cast<std::uint32_t>(k) % darts);
    }
    EXPECT_EQ(outcome(turned), "VERIFIED");
  }
}

/// The same triangulations, each by a detour: flips that are undone again. Its elements are products of elements that
/// lead so far that no bits are left by which they were recognized on the way back.
BoundDocument with_detours(BoundDocument document, std::uint32_t length) {
  length *= 4;
  const auto darts = static_cast<std::uint32_t>(3 * document.net.triangles.size());
  for (auto& [parent, flips] : document.triangulations) {
    for (std::uint32_t k = 0; k < length; ++k) flips.push_back((7 * k + 3 * length) % darts);
    for (std::uint32_t k = length; k-- > 0;) flips.insert(flips.end(), 3, (7 * k + 3 * length) % darts);
  }
  return document;
}

/// What is true is not refuted and what is false not verified, however wide the balls are.
TEST(Bound, WideBallsDecideNothing) {
  std::vector<BoundDocument> files = all_files();
  files.push_back(octagon_radius());
  for (const BoundDocument& good : files) {
    BoundDocument wrong = good;
    if (good.claim == Claim::radius) {
      wrong.value.lower *= 1 + 1e-13;
    } else {
      wrong.value.lower -= 1e-6;
      wrong.value.upper -= 1e-9;
    }
    int decided = 0;
    int open = 0;
    for (std::uint32_t length = 0; length < 20; length += 1 + length / 3) {
      const CheckOptions bits{.threads = 1, .max_precision = 128, .max_work = std::uint64_t{1} << 50};
      const Verdict of_good = check(with_detours(good, length), bits).verdict;
      const Verdict of_wrong = check(with_detours(wrong, length), bits).verdict;
      EXPECT_TRUE(of_good == Verdict::verified || of_good == Verdict::undecided) << length;
      EXPECT_TRUE(of_wrong == Verdict::refuted || of_wrong == Verdict::undecided) << length;
      ++(of_good == Verdict::undecided ? open : decided);
    }
    EXPECT_GT(decided, 0);
    EXPECT_GT(open, 1);
    // More bits decide.
    const CheckOptions all{.threads = 1, .max_work = std::uint64_t{1} << 50};
    EXPECT_EQ(check(with_detours(good, 19), all).verdict, Verdict::verified);
    EXPECT_EQ(check(with_detours(wrong, 19), all).verdict, Verdict::refuted);
  }
}

/// A flip, and flips that twist two triangles with two common edges around each other; all others stay what they are.
std::vector<std::uint32_t> twists(const NetDocument& net, std::uint32_t count) {
  const auto darts = static_cast<std::uint32_t>(3 * net.triangles.size());
  for (std::uint32_t first = 0; first < darts; ++first) {
    Map map;
    for (std::uint32_t d = 0; d < darts; ++d) map.opposite.push_back(opposite(net, d));
    map.element.resize(darts);
    (void)flip(map, first, 0);
    const auto other = [&](std::uint32_t d) -> std::optional<std::uint32_t> {
      for (const std::uint32_t e : {next_dart(d), previous_dart(d)}) {
        if (map.opposite[e] / 3 == map.opposite[d] / 3) return e;
      }
      return std::nullopt;
    };
    std::uint32_t d = 0;
    while (d < darts && !other(d)) ++d;
    if (d == darts) continue;
    std::vector<std::uint32_t> flips{first};
    for (std::uint32_t i = 0; i < count; ++i) {
      flips.push_back(d);
      (void)flip(map, d, 0);
      d = other(d).value();
    }
    return flips;
  }
  ADD_FAILURE() << "no two triangles have two common edges after a flip";
  return {};
}

TEST(Bound, ATriangleThatIsOpenIsNotForgottenForLaterOnes) {
  // Twists there and back: bits are lost of two triangles, and it does not matter which of all are the last.
  BoundDocument document = octagon();
  const auto verdict = [](const BoundDocument& d, slong bits) {
    return check(d, {.threads = 1, .max_precision = bits, .max_work = std::uint64_t{1} << 50}).verdict;
  };
  for (std::uint32_t shift = 0; shift < 6; ++shift) {
    EXPECT_EQ(verdict(renumbered(document, shift), 8192), Verdict::verified) << shift;
  }
  document.triangulations = {{}};
  for (auto& row : document.cells) row = {3 + 1};
  document.value.upper = 8;
  for (const std::uint32_t count : {0U, 15U, 120U}) {
    auto& flips = document.triangulations[0].flips;
    flips = twists(document.net, count);
    for (std::size_t k = flips.size(); k-- > 0;) {
      const std::uint32_t undone = flips[k];
      flips.insert(flips.end(), 3, undone);
    }
    const Verdict expected = count < 120 ? Verdict::verified : Verdict::undecided;
    for (std::uint32_t shift = 0; shift < 6; ++shift) {
      EXPECT_EQ(verdict(renumbered(document, shift), 128), expected) << count << ", " << shift;
    }
  }
}

TEST(Bound, ARefutedRuleCountsMoreThanOneThatIsOpen) {
  for (BoundDocument document : all_files()) {
    document.value.lower += 1e-12;
    document.value.upper += 1e-12;
    const CheckOptions bits{.threads = 1, .max_precision = 128, .max_work = std::uint64_t{1} << 50};
    const Certificate certificate = check(with_detours(document, 19), bits);
    EXPECT_EQ(certificate.rules[9].verdict, Verdict::undecided);
    EXPECT_EQ(certificate.verdict, Verdict::refuted);
    EXPECT_EQ(certificate.rule, "lower");
  }
}

TEST(Bound, ClaimsThatAreExchangedAreNotVerified) {
  for (BoundDocument document : {regular(), octagon()}) {
    document.claim = Claim::embedded_disk;
    EXPECT_EQ(outcome(document), "REFUTED: lower");
  }
  BoundDocument document = disk();
  document.claim = Claim::diameter;
  EXPECT_EQ(outcome(document), "MALFORMED: structure");
  // With leaves that exist it is the radius that is too small.
  for (auto& row : document.cells) row = {3};
  EXPECT_EQ(outcome(document), "REFUTED: cells");
}

/// Whatever is changed, what is verified is true.
TEST(SlowBound, NoChangeMakesAFalseClaimVerified) {
  std::mt19937 random(1);
  const auto below = [&](std::size_t bound) { return static_cast<std::uint32_t>(random() % bound); };
  const BoundDocument good = regular();
  std::size_t verified = 0;
  for (int run = 0; run < 500; ++run) {
    BoundDocument document = good;
    for (std::uint32_t changes = 1 + below(3); changes > 0; --changes) {
      auto& cells = document.cells[below(document.cells.size())];
      auto& row = document.triangulations[below(document.triangulations.size())];
      switch (below(5)) {
        case 0:
          cells[below(cells.size())] = 3 + below(document.triangulations.size() + 1);
          break;
        case 1:
          cells[below(cells.size())] = below(3);
          break;
        case 2:
          row.flips.insert(row.flips.begin() + below(row.flips.size() + 1), below(18));
          break;
        case 3:
          row.parent = below(document.triangulations.size());
          break;
        default: {
          const double shift = std::ldexp(below(3) - 1.0, -static_cast<int>(below(50)));
          (below(2) == 0 ? document.value.lower : document.value.upper) += shift;
        }
      }
    }
    if (checked(document).verdict != Verdict::verified) continue;
    ++verified;
    EXPECT_LT(document.value.lower, regular_diameter());
    EXPECT_GT(document.value.upper, regular_diameter());
  }
  EXPECT_GT(verified, 10U);
}

TEST(Bound, ThreadsDoNotMatter) {
  for (const BoundDocument& document : all_files_and_domains()) {
    const Certificate one = check(document, {.threads = 1});
    const Certificate three = check(document, {.threads = 3});
    ASSERT_EQ(one.rules.size(), three.rules.size());
    for (std::size_t i = 0; i < one.rules.size(); ++i) EXPECT_EQ(to_string(one.rules[i]), to_string(three.rules[i]));
    EXPECT_EQ(one.counts.work, three.counts.work);
  }
}

TEST(BoundOfARadius, IsVerified) {
  const Certificate certificate = checked(octagon_radius());
  EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
  ASSERT_EQ(certificate.rules.size(), 10U);
  EXPECT_EQ(certificate.rules[7].rule, "upper");
  EXPECT_EQ(certificate.rules[8].rule, "triangulations");
  EXPECT_EQ(certificate.rules[9].rule, "cells");
  EXPECT_EQ(certificate.claim, "the radius lies in " + to_string(octagon_radius().value));
}

TEST(BoundOfARadius, AnUpperBoundBelowTheValueAtTheVertexIsRefuted) {
  BoundDocument document = octagon_radius();
  document.value.upper -= 1e-12;
  EXPECT_EQ(outcome(document), "REFUTED: upper");
}

TEST(BoundOfARadius, TheUpperBoundIsComparedWithTheValueAtTheVertex) {
  const BoundDocument document = octagon_radius();
  const Interval found = at_vertex(document);
  ASSERT_LT(above(found.lower), below(found.upper));
  const double last = last_with("REFUTED", below(found.lower), above(found.upper), document);
  EXPECT_GE(last, found.lower);
  EXPECT_LT(last, found.upper);
}

TEST(BoundOfARadius, ALowerBoundAboveThatOfACellIsRefuted) {
  BoundDocument document = octagon_radius();
  document.value.lower = document.value.upper;
  EXPECT_EQ(outcome(document), "REFUTED: cells");
  // It is what the worst cell proves, but for roundings.
  document = octagon_radius();
  document.value.lower *= 1 + 1e-13;
  EXPECT_EQ(outcome(document), "REFUTED: cells");
  document.value.lower = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(outcome(document), "VERIFIED");
}

/// A triangulation that is not Delaunay at the midpoint would have circumradii that are no eccentricity.
TEST(BoundOfARadius, ACellWithATriangulationThatIsNotItsOwnIsRefuted) {
  BoundDocument good = octagon_radius();
  // So small a bound that every midpoint of a side proves it.
  good.value.lower = 1e-3;
  const auto numbers = static_cast<std::uint32_t>(3 * good.triangulations.size() + 3);
  const auto next = [&](std::uint32_t leaf) { return std::vector<std::uint32_t>{3 + leaf % numbers}; };
  std::size_t leaves = 0;
  for (const auto& row : good.cells) {
    for (const std::uint32_t entry : row) leaves += entry >= 3 ? 1 : 0;
  }
  // The Delaunay triangulation of a point is the only one, but for ties.
  EXPECT_EQ(refuted_by_cells(good, next), leaves);
}

TEST(BoundOfARadius, AFlipThatIsLeftOutIsRefuted) {
  const BoundDocument good = octagon_radius();
  for (std::size_t k = 0; k < good.triangulations.size(); ++k) {
    BoundDocument without = good;
    without.triangulations[k].flips.pop_back();
    EXPECT_EQ(outcome(without), "REFUTED: cells");
  }
}

/// The eccentricity at one point says nothing of cells that are large.
TEST(BoundOfARadius, ACellThatIsNotCutIsRefuted) {
  const BoundDocument good = octagon_radius();
  for (std::size_t t = 0; t < good.cells.size(); ++t) {
    BoundDocument document = good;
    for (std::uint32_t entry = 3; entry < 15; ++entry) {
      document.cells[t] = {entry};
      EXPECT_EQ(outcome(document), "REFUTED: cells");
    }
  }
}

TEST(Bound, TooLittleWorkOrPrecisionIsUndecided) {
  for (const BoundDocument& document : all_files_and_domains()) {
    const std::uint64_t all = checked(document).counts.work;
    EXPECT_EQ(check(document, {.threads = 2, .max_work = all}).verdict, Verdict::verified);
    for (const std::uint64_t work : {all - 1, all / 2, all / 10, std::uint64_t{1000}}) {
      EXPECT_EQ(check(document, {.threads = 2, .max_work = work}).verdict, Verdict::undecided) << work;
    }
  }
}

TEST(Bound, EveryDefectOfADocumentIsMalformed) {
  const auto complaint = [](const BoundDocument& good, const std::function<void(BoundDocument&)>& change) {
    BoundDocument document = good;
    change(document);
    return structure_complaint(document);
  };
  using Document = BoundDocument;
  std::vector<BoundDocument> files = all_files();
  files.push_back(octagon_radius());
  for (const BoundDocument& good : files) {
    const std::size_t rows = good.triangulations.size();
    const std::size_t triangles = good.net.triangles.size();
    const std::size_t of_each = good.claim == Claim::embedded_disk ? 3 * triangles
                                : good.claim == Claim::radius      ? 3
                                                                   : 1;
    const auto bounds = static_cast<std::uint32_t>((rows + 1) * of_each);
    const std::string last = "triangulations[" + std::to_string(rows - 1) + "]: ";
    EXPECT_THAT(
        complaint(good,
                  [](Document& d) { d.triangulations.back().flips.insert(d.triangulations.back().flips.begin(), 18); }),
        HasSubstr(last + "dart 18 does not exist"));
    EXPECT_THAT(complaint(good,
                          [](Document& d) {
                            d.net.vertices.clear();
                            d.net.triangles.clear();
                          }),
                HasSubstr("vertices"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.net.vertices.push_back(d.net.vertices[0]); }),
                HasSubstr("net: 2 vertices, expected one"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.net.collars.emplace(); }), HasSubstr("net: collars, a pseudo net"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.net.vertices[0].x = 2; }), HasSubstr("vertices[0]"));
    for (const Interval wrong : {Interval{2, 1}, {0, 1}, {-1, 1}, {0, 0}}) {
      EXPECT_THAT(complaint(good, [&](Document& d) { d.value = wrong; }),
                  HasSubstr("value: " + to_string(wrong) + " is not 0 < lo <= hi"));
    }
    EXPECT_THAT(complaint(good, [](Document& d) { d.triangulations[0].parent = 1; }),
                HasSubstr("triangulations[0]: is made from number 1, expected one before its own, 1"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.triangulations[4].parent = 7; }),
                HasSubstr("triangulations[4]: is made from number 7, expected one before its own, 5"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.triangulations[2].flips.push_back(18); }),
                HasSubstr("triangulations[2]: dart 18 does not exist"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.cells.pop_back(); }),
                HasSubstr("cells: 5 elements, expected one for each of the 6 triangles"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.cells.push_back({3}); }), HasSubstr("cells: 7 elements"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.cells[1].push_back(3); }),
                HasSubstr("cells[1]: more numbers than the subdivision has"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.cells[3].pop_back(); }),
                HasSubstr("cells[3]: the subdivision ends early, 1 cells are missing"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.cells[0].back() = 0; }),
                HasSubstr("cells[0]: the subdivision ends early, 2 cells are missing"));
    EXPECT_THAT(complaint(good, [](Document& d) { d.cells[2].clear(); }), HasSubstr("cells[2]"));
    EXPECT_THAT(complaint(good, [&](Document& d) { d.cells[5].back() = 3 + bounds; }),
                HasSubstr("cells[5]: " + std::to_string(3 + bounds) + " names nothing that bounds a cell"));
    EXPECT_THAT(complaint(good, [&](Document& d) { d.cells[5].back() = ~std::uint32_t{0}; }), HasSubstr("cells[5]"));
  }
}

/// A triangle is cut once, and its two cells are bounded by the net's own triangulation or two of its darts: the least
/// upper bound for which that holds is the one of the corner where the bound is greatest. Whether other cells allow it.
bool expect_least_upper_bound(BoundDocument document, std::uint32_t t, const std::vector<std::uint32_t>& cells,
                              double expected) {
  if (expected < document.value.upper + 1e-3) return false;
  document.cells[t] = cells;
  document.value.upper = expected * (1 + 1e-9);
  EXPECT_EQ(outcome(document), "VERIFIED") << t << " " << cells[0];
  document.value.upper = expected * (1 - 1e-9);
  EXPECT_EQ(outcome(document), "REFUTED: cells") << t << " " << cells[0];
  return true;
}

TEST(Bound, CellsOfAnEmbeddedDiskAreBoundedAtTheirThreeCorners) {
  const BoundDocument good = disk();
  const Reference reference(good.net);
  const Triangulation triangulation = triangulation_of(reference);
  int tried = 0;
  for (std::uint32_t t = 0; t < good.net.triangles.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t first = (t + 5 * side) % 18, second = (7 * t + side) % 18;
      double bound = 0;
      const auto cells = halves(reference.corners(t), side);
      for (std::size_t i = 0; i < 3; ++i) {
        bound = std::max({bound, half_displacement(triangulation, first, cells[0][i]),
                          half_displacement(triangulation, second, cells[1][i])});
      }
      tried += expect_least_upper_bound(good, t, {side, 3 + first, 3 + second}, bound) ? 1 : 0;
    }
  }
  EXPECT_GT(tried, 12);
}

/// At its first corner, the vertex itself, an edge of a triangulation with short edges moves a cell least. The
/// diagonals that flips make are longer there.
TEST(Bound, CellsOfAnEmbeddedDiskAreBoundedAtTheCornerWhereTheyBegin) {
  BoundDocument document = disk();
  const Reference reference(document.net);
  document.triangulations.push_back({});
  const auto row = static_cast<std::uint32_t>(document.triangulations.size());
  int found = 0;
  for (std::uint32_t t = 0; t < document.net.triangles.size(); ++t) {
    const auto cells = halves(reference.corners(t), 1);
    for (std::uint32_t dart = 0; dart < 18; ++dart) {
      const Triangulation flipped = triangulation_of(reference, {dart});
      const auto at = [&](std::size_t cell, std::size_t i) { return half_displacement(flipped, dart, cells[cell][i]); };
      const double bound = at(0, 0);
      if (bound < 1e-3 + std::max({at(0, 1), at(0, 2), at(1, 1), at(1, 2)})) continue;
      document.triangulations.back().flips = {dart};
      const std::uint32_t entry = 3 + 18 * row + dart;
      found += expect_least_upper_bound(document, t, {1, entry, entry}, bound) ? 1 : 0;
    }
  }
  EXPECT_GT(found, 0);
}

TEST(Bound, CellsOfADiameterAreBoundedAtTheirThreeCorners) {
  const BoundDocument good = octagon();
  const Reference reference(good.net);
  const Triangulation triangulation = triangulation_of(reference);
  int tried = 0;
  for (std::uint32_t t = 0; t < good.net.triangles.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      double bound = 0;
      for (const auto& cell : halves(reference.corners(t), side)) {
        for (const auto corner : cell) bound = std::max(bound, radius(triangulation, corner));
      }
      tried += expect_least_upper_bound(good, t, {side, 3, 3}, bound) ? 1 : 0;
    }
  }
  EXPECT_GT(tried, 12);
}

/// Also if its triangulation is that of the cell before it, and its first corner is the only one that matters.
TEST(Bound, CellsOfADiameterAreBoundedAtTheCornerWhereTheyBegin) {
  BoundDocument document = octagon();
  const Reference reference(document.net);
  document.triangulations.push_back({});
  const std::uint32_t entry = 3 + static_cast<std::uint32_t>(document.triangulations.size());
  std::mt19937 random(3);
  int found = 0;
  for (int run = 0; run < 10000; ++run) {
    std::vector<std::uint32_t> flips(1 + random() % 12);
    for (std::uint32_t& flip : flips) flip = static_cast<std::uint32_t>(random()) % 18;
    const auto t = static_cast<std::uint32_t>(random()) % 6, side = static_cast<std::uint32_t>(random()) % 3;
    const Triangulation flipped = triangulation_of(reference, flips);
    const auto cells = halves(reference.corners(t), side);
    const double bound = radius(flipped, cells[1][0]);
    double others = 0;
    for (const auto corner : cells[0]) others = std::max(others, radius(flipped, corner));
    for (const auto corner : {cells[1][1], cells[1][2]}) others = std::max(others, radius(flipped, corner));
    // Long edges have few digits in binary64.
    if (bound < others + 1e-3 || bound > 7) continue;
    document.triangulations.back().flips = flips;
    found += expect_least_upper_bound(document, t, {side, entry, entry}, bound) ? 1 : 0;
  }
  EXPECT_GT(found, 5);
}

/// A radius is bounded by the eccentricity of a midpoint less the distance to the farthest corner: that is an end of
/// the side or the corner opposite to it.
TEST(BoundOfARadius, NoPointOfACellIsBeyondTheReachOfItsMidpoint) {
  const BoundDocument good = octagon_radius();
  const Reference reference(good.net);
  std::vector<std::vector<std::uint32_t>> flips{{}};
  for (const auto& [parent, more] : good.triangulations) {
    flips.push_back(flips[parent]);
    flips.back().insert(flips.back().end(), more.begin(), more.end());
  }
  int opposite_is_farthest = 0;
  for (std::uint32_t k = 0; k < flips.size(); ++k) {
    const Triangulation triangulation = triangulation_of(reference, flips[k]);
    for (std::uint32_t t = 0; t < good.net.triangles.size(); ++t) {
      for (std::uint32_t side = 0; side < 3; ++side) {
        const auto half = halves(reference.corners(t), side)[0];
        const Complex midpoint = half[(side + 1) % 3];
        if (!is_delaunay(triangulation, midpoint)) continue;
        const Real to_end = distance(midpoint, half[side]);
        const Real to_opposite = distance(midpoint, half[(side + 2) % 3]);
        const double expected =
            circumradius(triangulation, midpoint) - static_cast<double>(std::max(to_end, to_opposite));
        if (expected < 1e-3) continue;
        opposite_is_farthest += to_end < to_opposite ? 1 : 0;
        BoundDocument document = good;
        document.cells[t] = {3 + side + 3 * k};
        document.value.lower = expected * (1 - 1e-9);
        EXPECT_EQ(outcome(document), "VERIFIED") << t << " " << side << " " << k;
        document.value.lower = expected * (1 + 1e-9);
        EXPECT_EQ(outcome(document), "REFUTED: cells") << t << " " << side << " " << k;
      }
    }
  }
  EXPECT_GT(opposite_is_farthest, 0);
}

/// One triangle is bounded by the net's own triangulation, to which a detour leads: however many bits are left of it,
/// an upper bound that is a little too small is not verified, and one that is a little too large not refuted.
void expect_no_wrong_verdict(BoundDocument document, std::uint32_t t, std::uint32_t side, std::uint32_t entry,
                             double least) {
  ASSERT_GT(least, document.value.upper);
  document.cells[t] = {side, entry, entry};
  document.triangulations.push_back({});
  const auto verdict = [&](double factor) {
    document.value.upper = least * factor;
    return check(document, {.threads = 1, .max_precision = 128, .max_work = std::uint64_t{1} << 50}).verdict;
  };
  int open = 0;
  for (std::uint32_t length = 0; length < 50; ++length) {
    auto& flips = document.triangulations.back().flips;
    flips.clear();
    for (std::uint32_t k = 0; k < 4 * length; ++k) flips.push_back(7 * k % 18);
    for (std::uint32_t k = 4 * length; k-- > 0;) flips.insert(flips.end(), 3, 7 * k % 18);
    EXPECT_NE(verdict(1 - 1e-9), Verdict::verified) << length;
    EXPECT_NE(verdict(1 + 1e-9), Verdict::refuted) << length;
    open += verdict(1 + 1e-9) == Verdict::undecided ? 1 : 0;
  }
  EXPECT_GT(open, 3);
}

TEST(Bound, OneTriangleWithWideBallsIsNotDecidedWrongly) {
  const BoundDocument of_disk = disk();
  const Reference disk_reference(of_disk.net);
  double bound = 0;
  for (const auto& cell : halves(disk_reference.corners(0), 1)) {
    for (const auto corner : cell)
      bound = std::max(bound, half_displacement(triangulation_of(disk_reference), 0, corner));
  }
  const auto rows_of_disk = static_cast<std::uint32_t>(of_disk.triangulations.size());
  expect_no_wrong_verdict(of_disk, 0, 1, 3 + 18 * (rows_of_disk + 1), bound);

  const BoundDocument of_diameter = octagon();
  const Reference diameter_reference(of_diameter.net);
  bound = 0;
  for (const auto& cell : halves(diameter_reference.corners(0), 1)) {
    for (const auto corner : cell) bound = std::max(bound, radius(triangulation_of(diameter_reference), corner));
  }
  const auto rows = static_cast<std::uint32_t>(of_diameter.triangulations.size());
  expect_no_wrong_verdict(of_diameter, 0, 1, 3 + rows + 1, bound);
}

TEST(Bound, InfiniteOrUnorderedBoundsAreMalformed) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Interval wrong : {Interval{1, kInfinity}, {std::nan(""), 3}, {1, std::nan("")}}) {
    BoundDocument document = regular();
    document.value = wrong;
    EXPECT_EQ(outcome(document), "MALFORMED: structure");
  }
}

TEST(BoundFile, WhatIsWrittenIsRead) {
  for (const BoundDocument& document : all_files_and_domains()) {
    EXPECT_EQ(parse_file<BoundDocument>(written(document), "test"), document);
    EXPECT_EQ(std::get<BoundDocument>(parse_file<ClaimDocument>(written(document), "test")), document);
  }
}

TEST(BoundFile, HasExactlyItsMembers) {
  const std::string text = written(octagon());
  const auto complaint = [&](const std::string& old, const std::string& by) -> std::string {
    std::string changed = text;
    const std::size_t place = changed.find(old);
    EXPECT_NE(place, std::string::npos) << old;
    changed.replace(place, old.size(), by);
    return reading_complaint<BoundDocument>(changed);
  };
  EXPECT_EQ(complaint("\"claim\":\"diameter\"", "\"claim\":\"embedded-disk\""), "");
  EXPECT_THAT(complaint("\"claim\":\"diameter\"", "\"claim\":\"girth\""),
              HasSubstr("\"claim\" is \"girth\", expected \"diameter\", \"radius\" or \"embedded-disk\""));
  EXPECT_THAT(complaint("\"claim\":\"diameter\",\n", ""), HasSubstr("missing member \"claim\""));
  EXPECT_THAT(complaint("\"claim\"", "\"claim\":\"diameter\",\"claim\""), HasSubstr("repeated member"));
  EXPECT_THAT(complaint("\"claim\"", "\"p\":0,\"claim\""), HasSubstr("unknown member \"p\""));
  EXPECT_THAT(complaint("\"value\":[", "\"value\":[0,"), HasSubstr("value: too many elements"));
  EXPECT_THAT(complaint("\"triangulations\":[\n[", "\"triangulations\":[\n[],["),
              HasSubstr("triangulations[0]: has 0 elements, expected [k, d, …], a triangulation and darts"));
  EXPECT_THAT(complaint("\"triangulations\":[\n[0", "\"triangulations\":[\n[-1"), HasSubstr("triangulations[0]"));
  EXPECT_THAT(complaint("\"cells\":[\n[", "\"cells\":[\n[1.5,"), HasSubstr("cells[0]"));
  EXPECT_THAT(complaint("\"epsnet-cover\"", "\"epsnet-distance\""), HasSubstr("format"));
  EXPECT_THAT(complaint("\"version\":1", "\"version\":2"), HasSubstr("version 2 is not a version"));
}

}  // namespace
}  // namespace epsnet::certify::bound_test
