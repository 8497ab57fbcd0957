#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/claims/bound/triangles.h"
#include "certify/claims/isometries/conjugation.h"
#include "certify/exact/checker.h"
#include "certify/exact/claim_rules.h"
#include "certify/exact/rough_interval.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "tests/certify/claim_files.h"
#include "tests/certify/moving_vertex.h"
#include "tests/certify/over_field.h"

/// False claims, each with the rule by which the second checker refutes it; and true ones beside them that it verifies.
namespace epsnet::exact::second_checker_claims_test {
namespace {

using certify::BoundDocument;
using certify::DistanceDocument;
using certify::GeodesicsDocument;
using certify::IsometriesDocument;
using certify::NetDocument;
using Word = std::vector<std::uint32_t>;

template <class Document>
Document load(const std::string& name) {
  return certify::read_file<Document>(std::string(EPSNET_TEST_DATA) + "/" + name + ".json");
}

template <class Document>
Result result_of(const Document& document) {
  std::ostringstream out;
  certify::write_file(document, out);
  return check(out.str());
}

/// "VERDICT", or "VERDICT: rule".
template <class Document>
std::string outcome(const Document& document) {
  constexpr std::array<const char*, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  const Result result = result_of(document);
  return kNames.at(static_cast<std::size_t>(result.verdict)) + (result.rule.empty() ? "" : ": " + result.rule);
}

/// The same of the first checker.
template <class Document>
std::string first_outcome(const Document& document) {
  const certify::Certificate certificate = certify::check(document, {.threads = 1});
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

double after(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double before(double x) { return std::nextafter(x, 0.0); }

Word joined(Word first, const Word& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// The path back.
Word reversed(const NetDocument& net, Word word) {
  const certify::SurfaceSides sides(net.surface);
  std::reverse(word.begin(), word.end());
  for (std::uint32_t& s : word) s = sides.partner[s];
  return word;
}

// Lists of geodesics.

/// The part of a spectrum up to a length, which is none of its lengths.
GeodesicsDocument up_to(const std::string& name, const std::string& length) {
  GeodesicsDocument document = load<GeodesicsDocument>("geodesics/" + name);
  document.up_to = length;
  std::erase_if(document.geodesics, [&](const auto& row) { return row.length.lower > std::stod(length); });
  return in_order(std::move(document));
}

/// Of a surface without symmetries.
GeodesicsDocument octagon() { return up_to("octagon-5-to-6", "3.6"); }
/// Of the Bolza surface, with squares of its twelve systoles among the loops that are looked at.
GeodesicsDocument bolza() { return up_to("bolza-to-6.2", "6.2"); }

TEST(SlowSecondCheckerOfGeodesics, VerifiesAListUpToAnyLength) {
  EXPECT_GE(octagon().geodesics.size(), 9U);
  EXPECT_EQ(outcome(octagon()), "VERIFIED");
  EXPECT_EQ(outcome(bolza()), "VERIFIED");
}

TEST(SlowSecondCheckerOfGeodesics, MissesWhicheverIsLeftOut) {
  const GeodesicsDocument good = octagon();
  for (std::size_t i = 0; i < good.geodesics.size(); ++i) {
    GeodesicsDocument document = good;
    document.geodesics.erase(document.geodesics.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(outcome(in_order(document)), "REFUTED: complete") << i;
  }
}

TEST(SlowSecondCheckerOfGeodesics, LengthsAreBetweenTheirEndsToTheLastPlace) {
  const GeodesicsDocument good = octagon();
  for (std::size_t i = 0; i < good.geodesics.size(); ++i) {
    const certify::Interval length = good.geodesics[i].length;
    GeodesicsDocument document = good;
    document.geodesics[i].length = {after(length.upper), 1 + length.upper};
    EXPECT_EQ(outcome(in_order(document)), "REFUTED: geodesics") << i;
    document.geodesics[i].length = {before(before(length.lower)), before(length.lower)};
    EXPECT_EQ(outcome(in_order(document)), "REFUTED: geodesics") << i;
  }
  GeodesicsDocument document = good;
  document.up_to = certify::decimal_below(before(good.geodesics.back().length.lower));
  EXPECT_EQ(outcome(document), "REFUTED: geodesics");
}

TEST(SlowSecondCheckerOfGeodesics, OneListedTwiceIsRefutedHoweverItIsSpelled) {
  const GeodesicsDocument good = octagon();
  const auto& rows = good.geodesics;
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    const Word& word = rows[i].word;
    const Word& other = rows[i == 0 ? 1 : 0].word;
    std::vector<Word> spellings{word, reversed(good.net, word)};
    if (rows[i].vertex == rows[i == 0 ? 1 : 0].vertex) {
      spellings.push_back(joined(joined(other, word), reversed(good.net, other)));
    }
    for (const Word& spelling : spellings) {
      GeodesicsDocument document = good;
      document.geodesics.push_back(rows[i]);
      document.geodesics.back().word = spelling;
      EXPECT_EQ(outcome(in_order(document)), "REFUTED: distinct") << i;
    }
  }
}

TEST(SlowSecondCheckerOfGeodesics, APowerIsNotWhatAListLacks) {
  const GeodesicsDocument good = bolza();
  constexpr std::size_t kPlace = 7;
  GeodesicsDocument::ClosedGeodesic square = good.geodesics[kPlace];
  square.word = joined(square.word, square.word);
  square.length = {2 * square.length.lower, 2 * square.length.upper};
  GeodesicsDocument document = good;
  document.geodesics.push_back(square);
  EXPECT_EQ(outcome(in_order(document)), "REFUTED: distinct");
  // Before what it is the square of, as little is said of its length.
  document.geodesics.back().length.lower = 1;
  EXPECT_EQ(outcome(in_order(document)), "REFUTED: distinct");
  document.geodesics.back().length.lower = square.length.lower;
  document.geodesics.erase(document.geodesics.begin() + kPlace);
  EXPECT_EQ(outcome(in_order(document)), "REFUTED: complete");
}

TEST(SlowSecondCheckerOfGeodesics, HigherPowersAreNotWhatAListLacks) {
  // Squares and cubes of cuffs that are 0.5 long; those of shorter ones: PowersOfPowersAreThoseOfTheirRoot.
  GeodesicsDocument good = load<GeodesicsDocument>("geodesics/two-cuffs-that-differ-by-1e-14");
  ASSERT_EQ(outcome(good), "VERIFIED");
  for (std::size_t i = 0; i < good.geodesics.size(); ++i) {
    for (const int times : {2, 3, 4}) {
      GeodesicsDocument document = good;
      GeodesicsDocument::ClosedGeodesic power = good.geodesics[i];
      if (times * power.length.upper > 1.7) continue;
      for (int k = 1; k < times; ++k) power.word = joined(power.word, good.geodesics[i].word);
      power.length = {before(times * power.length.lower), after(times * power.length.upper)};
      document.geodesics.push_back(power);
      const auto place = static_cast<std::uint32_t>(document.geodesics.size() - 1);
      document.pieces[0].boundaries.emplace_back(place, 0);
      document.pieces[0].boundaries.emplace_back(place, 1);
      std::vector<std::uint32_t> order(document.geodesics.size());
      std::iota(order.begin(), order.end(), 0U);
      std::stable_sort(order.begin(), order.end(), [&](auto x, auto y) {
        return document.geodesics[x].length.lower < document.geodesics[y].length.lower;
      });
      for (auto& piece : document.pieces) {
        for (auto& [geodesic, side] : piece.boundaries) {
          geodesic = static_cast<std::uint32_t>(std::find(order.begin(), order.end(), geodesic) - order.begin());
        }
      }
      EXPECT_EQ(outcome(in_order(document)), "REFUTED: distinct") << i << ", " << times << " times";
    }
  }
}

TEST(SlowSecondCheckerOfGeodesics, PowersOfPowersAreThoseOfTheirRoot) {
  // Two curves, 0.04 and 0.05 long, and no others up to 1. A power is one of other powers, too, that no list has: the
  // twelfth one is the square of the sixth.
  GeodesicsDocument good = load<GeodesicsDocument>("forgeries/spectrum-with-a-figure-eight");
  good.up_to = "1";
  good.geodesics.resize(2);
  good = in_order(std::move(good));
  ASSERT_EQ(outcome(good), "VERIFIED");
  for (const auto& row : good.geodesics) {
    for (const int times : {2, 3, 4, 6, 8, 9, 12}) {
      GeodesicsDocument document = good;
      GeodesicsDocument::ClosedGeodesic power = row;
      for (int k = 1; k < times; ++k) power.word = joined(power.word, row.word);
      power.length = {before(times * row.length.lower), after(times * row.length.upper)};
      document.geodesics.push_back(power);
      document = in_order(std::move(document));
      EXPECT_EQ(outcome(document), "REFUTED: distinct") << row.length.lower << ", " << times << " times";
      EXPECT_EQ(first_outcome(document), "REFUTED: distinct") << row.length.lower << ", " << times << " times";
    }
  }
}

TEST(SlowSecondCheckerOfGeodesics, AWrongSimpleIsRefuted) {
  // Two figure eights among geodesics that are simple.
  const auto good = load<GeodesicsDocument>("forgeries/spectrum-with-a-figure-eight");
  for (const std::size_t i : {std::size_t{5}, std::size_t{6}, std::size_t{7}}) {
    GeodesicsDocument document = good;
    document.geodesics[i].simple = !document.geodesics[i].simple;
    EXPECT_EQ(good.geodesics[i].simple, i == 5);
    EXPECT_EQ(outcome(document), "REFUTED: simple") << i;
  }
  GeodesicsDocument document = good;
  for (auto& row : document.geodesics) row.simple = true;
  EXPECT_EQ(outcome(document), "REFUTED: simple");
}

TEST(SlowSecondCheckerOfGeodesics, SimpleIsAskedOfEveryRowAndOfASystole) {
  for (const std::string name : {"forgeries/spectrum", "forgeries/systole", "forgeries/small-curves"}) {
    const auto good = load<GeodesicsDocument>(name);
    for (std::size_t i = 0; i < good.geodesics.size(); ++i) {
      ASSERT_TRUE(good.geodesics[i].simple);
      GeodesicsDocument document = good;
      document.geodesics[i].simple = false;
      EXPECT_EQ(outcome(document), "REFUTED: simple") << name << ", " << i;
      EXPECT_EQ(first_outcome(document), "REFUTED: simple") << name << ", " << i;
    }
  }
}

TEST(SlowSecondCheckerOfGeodesics, EqualLengthsAreNotOnlyEqualInTheirFirstDigits) {
  // Two lengths that differ by 10⁻¹²⁰: as enclosures do not tell.
  auto document = load<GeodesicsDocument>("geodesics/systoles-that-differ-by-1e-120");
  ASSERT_EQ(document.geodesics[0].word, (Word{0, 5}));
  document.claim = GeodesicsDocument::Claim::spectrum;
  document.up_to = "2.9236";
  document.geodesics.push_back(document.geodesics[0]);
  document.geodesics[1].word = {3, 6};
  document.clusters = {{0, 2, true}};
  EXPECT_EQ(outcome(document), "REFUTED: equal");
  EXPECT_EQ(first_outcome(document), "REFUTED: equal");
}

/// 2 arsinh 1, the number with so many digits that is next to it below or above.
std::string two_arsinh_1(std::size_t digits, mpfr_rnd_t direction) {
  mpfr_t x;
  mpfr_init2(x, 1024);
  mpfr_set_ui(x, 1, MPFR_RNDN);
  mpfr_asinh(x, x, MPFR_RNDN);
  mpfr_mul_ui(x, x, 2, MPFR_RNDN);
  mpfr_exp_t exponent = 0;
  char* text = mpfr_get_str(nullptr, &exponent, 10, digits, x, direction);
  std::string result(text);
  EXPECT_EQ(exponent, 1);
  mpfr_free_str(text);
  mpfr_clear(x);
  return result.insert(1, ".");
}

TEST(SlowSecondCheckerOfGeodesics, ABoundThatIsNearlyALengthDecidesNothing) {
  // The spectrum is one geodesic, of the length 2 arsinh 1.
  auto document = load<GeodesicsDocument>("geodesics/one-curve-of-2-arsinh-1");
  document.claim = GeodesicsDocument::Claim::spectrum;
  document.pieces.clear();
  document.up_to = two_arsinh_1(60, MPFR_RNDU);
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.up_to = two_arsinh_1(60, MPFR_RNDD);
  EXPECT_EQ(outcome(document), "REFUTED: geodesics");
  for (const mpfr_rnd_t direction : {MPFR_RNDU, MPFR_RNDD}) {
    document.up_to = two_arsinh_1(100, direction);
    EXPECT_EQ(outcome(document), "UNDECIDED: geodesics");
  }
}

TEST(SlowSecondCheckerOfGeodesics, ASystoleIsKnownUpToLessThanAFactorOf2) {
  auto document = load<GeodesicsDocument>("forgeries/systole");
  const double upper = document.geodesics[0].length.upper;
  document.geodesics[0].length = {upper / 2, upper};
  EXPECT_EQ(outcome(document), "MALFORMED");
  EXPECT_EQ(first_outcome(document).substr(0, 9), "MALFORMED");
  document.geodesics[0].length = {after(upper / 2), upper};
  EXPECT_EQ(outcome(document), "VERIFIED");
  EXPECT_EQ(first_outcome(document), "VERIFIED");
}

TEST(SlowSecondCheckerOfGeodesics, EveryLengthOfAClusterIsComparedExactly) {
  // The last of two or three.
  const GeodesicsDocument all = octagon();
  for (std::size_t i = 0; i + 2 < all.geodesics.size(); ++i) {
    GeodesicsDocument document = all;
    auto& rows = document.geodesics;
    rows[i].length.upper = rows[i + 1].length.upper;
    rows[i + 1].length.lower = rows[i].length.lower;
    document = in_order(document);
    EXPECT_EQ(document.clusters[i].count, 2U);
    document.clusters[i].equal = true;
    EXPECT_EQ(outcome(document), "REFUTED: equal") << i;
    EXPECT_EQ(first_outcome(document), "REFUTED: equal") << i;
  }
  // One longer length, wherever it is in a cluster of equal ones.
  const GeodesicsDocument equal = bolza();
  for (const std::size_t place : {std::size_t{0}, std::size_t{12}}) {
    GeodesicsDocument document = equal;
    auto& rows = document.geodesics;
    std::rotate(rows.begin() + static_cast<std::ptrdiff_t>(place), rows.begin() + 12, rows.begin() + 13);
    const double upper = rows[place].length.upper;
    for (std::size_t i = 0; i <= 12; ++i) rows[i].length = {3, upper};
    document = in_order(document);
    document.clusters[0].equal = true;
    EXPECT_EQ(outcome(document), "REFUTED: equal") << place;
  }
}

TEST(SlowSecondCheckerOfGeodesics, LengthsThatTouchAreOneRun) {
  GeodesicsDocument document = octagon();
  auto& rows = document.geodesics;
  rows[0].length.upper = rows[1].length.lower;
  const GeodesicsDocument one_run = in_order(document);
  ASSERT_EQ(one_run.clusters[0].count, 2U);
  EXPECT_EQ(outcome(one_run), "VERIFIED");
  EXPECT_EQ(first_outcome(one_run), "VERIFIED");
  document.clusters[0] = {0, 1, false};
  ASSERT_EQ(document.clusters[1].first, 1U);
  EXPECT_EQ(outcome(document), "MALFORMED");
  rows[0].length.upper = before(rows[1].length.lower);
  EXPECT_EQ(outcome(document), "VERIFIED");
  // A run goes on to the end of the longest of the enclosures before.
  rows[0].length.upper = rows[2].length.lower;
  ASSERT_EQ(in_order(document).clusters[0].count, 3U);
  EXPECT_EQ(outcome(in_order(document)), "VERIFIED");
}

/// The list up to 3.6 by a net with one vertex, near the boundary of the disk of its chart.
GeodesicsDocument with_a_vertex_far_out(double x) {
  GeodesicsDocument document = octagon();
  document.net = load<certify::EigenvaluesDocument>("eigenvalues/octagon-5-of-one-vertex").net;
  for (auto& row : document.geodesics) row.vertex = 0;
  certify::NetDocument::Chart& chart = document.net.charts[0];
  certify::NetDocument::Vertex& vertex = document.net.vertices[0];
  EXPECT_TRUE(vertex.x == 0 && vertex.y == 0 && chart.centre.y == 0);
  // From the new centre c, x is where the old one is: (x + c)/(1 + cx).
  const mpq_class place(x);
  vertex.x = x;
  chart.centre.x = (chart.centre.x - place) / (1 - chart.centre.x * place);
  return document;
}

TEST(SlowSecondCheckerOfGeodesics, AVertexMayBeFarOutInItsChart) {
  GeodesicsDocument document = with_a_vertex_far_out(1 - 0x1p-20);
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.geodesics.erase(document.geodesics.begin() + 4);
  EXPECT_EQ(outcome(in_order(document)), "REFUTED: complete");
}

TEST(SlowSecondCheckerOfGeodesics, ALongerGeodesicIsNoSystole) {
  const GeodesicsDocument all = octagon();
  for (std::size_t i = 0; i < all.geodesics.size(); ++i) {
    GeodesicsDocument document = all;
    document.claim = GeodesicsDocument::Claim::systole;
    document.geodesics = {all.geodesics[i]};
    document.clusters.clear();
    document.up_to.clear();
    EXPECT_EQ(outcome(document), i == 0 ? "VERIFIED" : "REFUTED: complete") << i;
  }
}

TEST(SlowSecondCheckerOfGeodesics, ASystoleMayBeShorterByLittle) {
  // By 10⁻¹²⁰: as enclosures do not tell.
  auto document = load<GeodesicsDocument>("geodesics/systoles-that-differ-by-1e-120");
  EXPECT_EQ(outcome(document), "VERIFIED");
  EXPECT_EQ(first_outcome(document), "VERIFIED");
  ASSERT_EQ(document.geodesics[0].word, (Word{0, 5}));
  document.geodesics[0].word = {3, 6};
  EXPECT_EQ(outcome(document), "REFUTED: complete");
  EXPECT_EQ(first_outcome(document), "REFUTED: complete");
}

TEST(SlowSecondCheckerOfGeodesics, LeftAndRightOfASeparatingCurveAreNotExchanged) {
  // A piece of genus 2 on the left of a curve, and a pair of pants on its right, which another curve closes.
  const auto good = load<GeodesicsDocument>("geodesics/separating-curve");
  ASSERT_EQ(outcome(good), "VERIFIED");
  GeodesicsDocument document = good;
  for (auto& piece : document.pieces) {
    for (auto& [geodesic, side] : piece.boundaries) side = 1 - side;
  }
  EXPECT_EQ(outcome(document), "REFUTED: pieces");
  EXPECT_EQ(first_outcome(document), "REFUTED: pieces");
  // Directed the other way.
  for (auto& row : document.geodesics) row.word = reversed(document.net, row.word);
  EXPECT_EQ(outcome(document), "VERIFIED");
  EXPECT_EQ(first_outcome(document), "VERIFIED");
}

// Distances.

TEST(SlowSecondCheckerOfDistances, EveryPathIsAsLongAsTheFileSays) {
  const auto good = load<DistanceDocument>("distances/four-equal");
  DistanceDocument document = good;
  document.distance.lower = after(good.distance.upper);
  document.distance.upper = 2 * good.distance.upper;
  EXPECT_EQ(outcome(document), "REFUTED: paths");
  document.distance = {0.5 * good.distance.lower, before(good.distance.lower)};
  EXPECT_EQ(outcome(document), "REFUTED: paths");
  for (std::size_t i = 0; i < good.paths.size(); ++i) {
    document = good;
    document.paths[i] = joined(document.paths[i], joined(document.paths[0], reversed(good.net, document.paths[1])));
    EXPECT_EQ(outcome(document), "REFUTED: paths") << i;
    document = good;
    document.paths.erase(document.paths.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(outcome(document), "REFUTED: nearest") << i;
    document = good;
    document.paths.push_back(joined(good.paths[i], joined({0}, reversed(good.net, {0}))));
    EXPECT_EQ(outcome(document), "REFUTED: paths") << i;
  }
}

TEST(SlowSecondCheckerOfDistances, AllLengthsAreEqualIfTheFileSaysSo) {
  const auto good = load<DistanceDocument>("distances/four-equal");
  ASSERT_TRUE(good.equal);
  // Another point nearby, not on the axis of symmetry: all four paths are still the only ones, of different lengths.
  DistanceDocument document = good;
  document.point.z.x += mpq_class(1, 1'000'000);
  document.point.z.y += mpq_class(1, 3'000'000);
  document.distance = {good.distance.lower - 1e-5, good.distance.upper + 1e-5};
  EXPECT_EQ(outcome(document), "REFUTED: equal");
  // Whichever comes first.
  for (std::size_t i = 1; i < good.paths.size(); ++i) {
    std::rotate(document.paths.begin(), document.paths.begin() + 1, document.paths.end());
    EXPECT_EQ(outcome(document), "REFUTED: equal") << i;
  }
  document.equal = false;
  EXPECT_EQ(outcome(document), "VERIFIED");
  // On the axis, two and two of them are equal.
  document = good;
  document.point.z.x += mpq_class(1, 1'000'000);
  document.distance = {good.distance.lower - 1e-5, good.distance.upper + 1e-5};
  do {
    EXPECT_EQ(outcome(document), "REFUTED: equal");
  } while (std::next_permutation(document.paths.begin(), document.paths.end()));
}

TEST(SlowSecondCheckerOfDistances, EveryDartLeadsToANeighbour) {
  // Of two triangles with a common edge, the points between their circumcentres are nearer to the ends of the edge than
  // to all other lifts of the vertex. Of two shortest paths one is left out: the one behind the loop of the dart, and
  // behind that of no other dart.
  const auto good = load<DistanceDocument>("distances/octagon");
  const certify::Reference reference(good.net);
  const auto word = [&](std::uint32_t dart) {
    const std::uint32_t label = certify::corner_label(good.net, dart);
    return label == 0 ? Word{} : good.net.labels[label - 1].word;
  };
  const auto unit = [](const certify::Vector& x) {
    const certify::Real size = std::sqrt(-certify::lorentz(x, x));
    return certify::Vector{x[0] / size, x[1] / size, x[2] / size};
  };
  const certify::RationalPoint& centre = good.net.charts[0].centre;
  const certify::Complex c(centre.x.get_d(), centre.y.get_d());
  const certify::Complex p(good.net.vertices[0].x, good.net.vertices[0].y);
  for (std::uint32_t dart = 0; dart < 3 * good.net.triangles.size(); ++dart) {
    const auto here = unit(reference.circumcentre(dart / 3));
    const auto there = certify::image(certify::inverted(reference.transition(dart)),
                                      unit(reference.circumcentre(certify::opposite(good.net, dart) / 3)));
    const auto between = unit({here[0] + there[0], here[1] + there[1], here[2] + there[2]});
    // In the chart of the vertex, and in the tile.
    const certify::Complex x = certify::image(certify::inverted(reference.label(certify::corner_label(good.net, dart))),
                                              certify::point_of(between));
    const certify::Complex q = (x + c) / (certify::Real{1} + std::conj(c) * x);
    DistanceDocument document = good;
    document.equal = false;
    document.point.z = {mpq_class(static_cast<double>(q.real())), mpq_class(static_cast<double>(q.imag()))};
    const certify::Real length =
        std::max(certify::distance(p, x), certify::distance(certify::image(reference.element(dart), p), x));
    document.distance = {0, static_cast<double>(length) + 1e-10};
    document.paths = {Word{}};
    EXPECT_EQ(outcome(document), "REFUTED: nearest") << dart;
    EXPECT_EQ(first_outcome(document), "REFUTED: nearest") << dart;
    document.paths.push_back(joined(word(certify::next_dart(dart)), reversed(good.net, word(dart))));
    EXPECT_EQ(outcome(document), "VERIFIED") << dart;
    EXPECT_EQ(first_outcome(document), "VERIFIED") << dart;
  }
}

TEST(SlowSecondCheckerOfDistances, ALengthThatIsNearlyAnEndDecidesNothing) {
  // Of all points on a segment one is as far along the path as an end of `distance`: it lies between two that are so
  // near each other that numbers of 256 bits do not tell.
  const auto octagon = load<DistanceDocument>("distances/octagon");
  for (const bool upper : {false, true}) {
    DistanceDocument document = octagon;
    (upper ? document.distance.lower : document.distance.upper) *= upper ? 0.5 : 1.1;
    ASSERT_EQ(outcome(document), "VERIFIED");
    const mpq_class start = document.point.z.x;
    mpq_class good = 0;
    mpq_class bad = 0;
    for (const int sign : {1, -1}) {
      document.point.z.x = start + mpq_class(sign, 1000);
      if (outcome(document) == "REFUTED: paths") bad = mpq_class(sign, 1000);
    }
    ASSERT_NE(bad, 0);
    std::string last;
    for (int k = 0; k < 400; ++k) {
      const mpq_class middle = (good + bad) / 2;
      document.point.z.x = start + middle;
      last = outcome(document);
      if (last == "VERIFIED") {
        good = middle;
      } else if (last == "REFUTED: paths") {
        bad = middle;
      } else {
        break;
      }
    }
    EXPECT_EQ(last, "UNDECIDED: paths") << upper;
  }
}

TEST(SlowSecondCheckerOfDistances, EqualLengthsAreNotOnlyEqualInTheirFirstDigits) {
  auto document = load<DistanceDocument>("distances/four-equal");
  ASSERT_TRUE(document.equal);
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, 200);
  document.point.z.x += mpq_class(1, power);
  EXPECT_EQ(outcome(document), "REFUTED: equal");
  EXPECT_EQ(first_outcome(document), "REFUTED: equal");
}

TEST(SlowSecondCheckerOfDistances, AWiderEnclosureNeedsAllPathsInIt) {
  const auto good = load<DistanceDocument>("distances/four-equal");
  DistanceDocument document = good;
  document.distance.upper *= 2;
  EXPECT_EQ(outcome(document), "REFUTED: nearest");
  const auto zero = load<DistanceDocument>("distances/zero");
  document = zero;
  document.point.z.x += mpq_class(1, 1'000'000'000);
  EXPECT_EQ(outcome(document), "REFUTED: paths");
}

TEST(SlowSecondCheckerOfDistances, ALongerPathIsMissingIfItIsNotTooLong) {
  // On a surface without symmetries but one. What is behind the loop of a dart is the path listed.
  DistanceDocument document = load<DistanceDocument>("distances/octagon");
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.equal = false;
  const double least = document.distance.upper;
  double found = 2 * least;
  const auto outcome_up_to = [&](double upper) {
    document.distance.upper = upper;
    return first_outcome(document);
  };
  ASSERT_EQ(outcome_up_to(found), "REFUTED: nearest");
  double good = least;
  while (found - good > 1e-9) {
    const double middle = (found + good) / 2;
    (outcome_up_to(middle) == "VERIFIED" ? good : found) = middle;
  }
  for (const double upper : {good, found, 1.1 * found, 2 * least}) {
    EXPECT_EQ(outcome_up_to(upper), upper == good ? "VERIFIED" : "REFUTED: nearest");
    EXPECT_EQ(outcome(document), first_outcome(document)) << upper;
  }
}

TEST(SlowSecondCheckerOfDistances, APathThatIsNearlyTooLongIsNotForgotten) {
  // Of all points on a segment one is so far along a path that is not listed as `distance` goes: it lies between two
  // that are so near each other that intervals do not tell.
  DistanceDocument document = load<DistanceDocument>("distances/octagon");
  document.equal = false;
  document.distance = {0.5 * document.distance.lower, 1.1 * document.distance.upper};
  ASSERT_EQ(outcome(document), "VERIFIED");
  const mpq_class start = document.point.z.x;
  mpq_class good = 0;
  mpq_class bad = 0;
  for (int k = 1; k < 40 && bad == 0; ++k) {
    for (const int sign : {1, -1}) {
      document.point.z.x = start + mpq_class(sign * k, 100);
      if (outcome(document) == "REFUTED: nearest") bad = mpq_class(sign * k, 100);
    }
  }
  ASSERT_NE(bad, 0);
  std::string last;
  for (int k = 0; k < 400 && last != "UNDECIDED: nearest"; ++k) {
    const mpq_class middle = (good + bad) / 2;
    document.point.z.x = start + middle;
    last = outcome(document);
    if (last == "VERIFIED") {
      good = middle;
    } else if (last == "REFUTED: nearest") {
      bad = middle;
    } else {
      break;
    }
  }
  EXPECT_EQ(last, "UNDECIDED: nearest");
}

TEST(SlowSecondCheckerOfDistances, AListThatTakesTooLongToCompareIsUndecided) {
  // Twenty thousand elements, all different, all in the enclosure: the first is compared with none, the last with all.
  auto document = load<DistanceDocument>("distances/four-equal");
  const certify::SurfaceSides sides(document.net.surface);
  ASSERT_EQ(sides.first.size(), 1U);
  document.equal = false;
  document.distance = {1e-3, 200};
  document.paths.clear();
  const auto count = static_cast<std::uint32_t>(sides.partner.size());
  std::vector<Word> words{{}};
  for (std::size_t i = 0; document.paths.size() < 20'000; ++i) {
    for (std::uint32_t s = 0; s < count; ++s) {
      // Without turning back, and far from relators: letters of one half alone.
      if (s < sides.partner[s]) words.push_back(joined(words[i], {s}));
    }
    document.paths.push_back(words[i + 1]);
  }
  const Result result = result_of(document);
  EXPECT_EQ(result.rule, "paths");
  EXPECT_EQ(result.message, "comparing 20000 paths, two at a time, takes more than 4000000000 bits");
}

// Bounds.

const std::vector<std::string> kBounds{"octagon-diameter", "octagon-radius", "octagon-embedded-disk",
                                       "regular-diameter"};

BoundDocument bound(const std::string& name) { return load<BoundDocument>("bounds/" + name); }

TEST(SlowSecondCheckerOfBounds, TheValueAtTheVertexIsOnTheRightSide) {
  for (const std::string& name : kBounds) {
    BoundDocument document = bound(name);
    const bool radius = document.claim == BoundDocument::Claim::radius;
    double& value = radius ? document.value.upper : document.value.lower;
    const certify::Certificate net = certify::check(document.net, {.threads = 1});
    const certify::Interval known =
        document.claim == BoundDocument::Claim::embedded_disk
            ? certify::Interval{net.enclosures->shortest_loop->lower / 2, net.enclosures->shortest_loop->upper / 2}
            : net.enclosures->largest_circumradius;
    value = radius ? known.upper + 1e-13 : known.lower - 1e-13;
    EXPECT_EQ(outcome(document), "VERIFIED") << name;
    value = radius ? known.lower - 1e-13 : known.upper + 1e-13;
    document.value.lower = std::min(document.value.lower, document.value.upper);
    document.value.upper = std::max(document.value.lower, document.value.upper);
    const std::string refuted = std::string("REFUTED: ") + (radius ? "upper" : "lower");
    EXPECT_EQ(outcome(document), refuted) << name;
    // Whichever darts the edge that decides has.
    std::mt19937 random(14);
    std::vector<std::uint32_t> order{0, 1, 2, 3, 4, 5};
    for (int k = 0; k < 12; ++k) {
      std::shuffle(order.begin(), order.end(), random);
      document.net = certify::with_triangles_in_order(bound(name).net, order);
      EXPECT_EQ(outcome(document), refuted) << name;
    }
  }
}

TEST(SlowSecondCheckerOfBounds, EveryCellIsBounded) {
  for (const std::string& name : kBounds) {
    BoundDocument document = bound(name);
    // A bound that no triangulation gives at the vertex of the net, where the function is best.
    if (document.claim == BoundDocument::Claim::radius) {
      document.value.lower = document.value.upper;
    } else {
      document.value.upper = document.value.lower;
    }
    EXPECT_EQ(outcome(document), "REFUTED: cells") << name;
  }
}

/// Numbers of a kind, each said of the claim that both checkers make: what one verifies, the other does.
struct Comparison {
  int verified = 0;
  int refuted = 0;

  void expect_same(const BoundDocument& document, const std::string& what) {
    const std::string first = first_outcome(document);
    EXPECT_EQ(outcome(document), first) << what;
    verified += first == "VERIFIED" ? 1 : 0;
    refuted += first == "REFUTED: cells" ? 1 : 0;
  }
};

/// Other steps make other triangles, the same ones for both checkers.
TEST(SlowSecondCheckerOfBounds, ABaseIsWhatItsStepsMakeOfTheNet) {
  for (const std::string name : {"octagon-diameter-base", "octagon-radius-base", "octagon-embedded-disk-base"}) {
    const BoundDocument good = bound(name);
    Comparison comparison;
    for (std::size_t k = 0; k < good.base.size(); ++k) {
      BoundDocument document = good;
      document.base[k] ^= 2U;
      if (first_outcome(document) == "MALFORMED: structure") continue;
      comparison.expect_same(document, name + ", step " + std::to_string(k));
    }
    EXPECT_GT(comparison.refuted + comparison.verified, 10) << name;
  }
}

/// Both checkers have the triangles of a base, or of a domain, at the same places: the least distance from the value to
/// its bound with which the worst cell is bounded is the same.
TEST(SlowSecondCheckerOfBounds, ABasesTrianglesAreWhereTheFirstCheckerHasThem) {
  // The last two also of elements that are products of many, on tiles {7, 3} and with a cuff of 10⁻³.
  for (const std::string name :
       {"octagon-diameter-base", "octagon-radius-base", "octagon-embedded-disk-base", "klein-diameter",
        "thin-embedded-disk", "octagon-diameter-domain", "octagon-radius-domain", "octagon-embedded-disk-domain",
        "bolza-radius-domain", "two-tiles-embedded-disk-domain"}) {
    const BoundDocument good = bound(name);
    const auto with = [&](double distance) {
      BoundDocument document = good;
      if (good.claim == BoundDocument::Claim::radius) {
        document.value.lower = good.value.upper - distance;
      } else {
        document.value.upper = good.value.lower + distance;
      }
      return document;
    };
    double refuted = 0;
    double verified = 1;
    ASSERT_EQ(first_outcome(with(verified)), "VERIFIED") << name;
    while (verified - refuted > 1e-7) {
      const double middle = (refuted + verified) / 2;
      (first_outcome(with(middle)) == "VERIFIED" ? verified : refuted) = middle;
    }
    EXPECT_EQ(outcome(with(verified + 1e-7)), "VERIFIED") << name << ", " << verified;
    EXPECT_EQ(outcome(with(refuted - 1e-7)), "REFUTED: cells") << name << ", " << refuted;
  }
}

/// Other isometries, and another centre, make other triangles, the same ones for both checkers.
TEST(SlowSecondCheckerOfBounds, ADomainIsThatOfItsCentreAndIsometries) {
  for (const std::string name : {"octagon-diameter-domain", "octagon-embedded-disk-domain", "bolza-radius-domain"}) {
    const BoundDocument good = bound(name);
    Comparison comparison;
    int refuted_domains = 0;
    const auto expect_same = [&](const BoundDocument& document, const std::string& what) {
      refuted_domains += outcome(document) == "REFUTED: domain" ? 1 : 0;
      comparison.expect_same(document, name + ", " + what);
    };
    for (const double x : {-0.5, -0.1, 0.0, 0.1, 0.3}) {
      for (const double y : {-0.4, 0.05, 0.2}) {
        BoundDocument document = good;
        document.symmetry->centre = {x, y};
        expect_same(document, "centre " + std::to_string(x) + ", " + std::to_string(y));
        document.symmetry->centre = {good.symmetry->centre[0] + x / 100, good.symmetry->centre[1] + y / 100};
        expect_same(document, "centre moved by a hundredth of that");
      }
    }
    for (std::size_t i = 0; i < good.symmetry->isometries.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        BoundDocument document = good;
        std::swap(document.symmetry->isometries[i], document.symmetry->isometries[k]);
        expect_same(document, "sides " + std::to_string(i) + " and " + std::to_string(k));
      }
      if (good.symmetry->isometries.size() == 3) continue;
      BoundDocument document = good;
      document.symmetry->isometries.erase(document.symmetry->isometries.begin() + static_cast<std::ptrdiff_t>(i));
      document.cells.erase(document.cells.begin() + static_cast<std::ptrdiff_t>(i));
      expect_same(document, "without side " + std::to_string(i));
    }
    EXPECT_GT(refuted_domains, 5) << name;
    EXPECT_GT(comparison.refuted + comparison.verified, 5) << name;
  }
}

/// A row is an isometry only if the images of the generators are those of one and the same lift.
TEST(SlowSecondCheckerOfBounds, ADomainIsOfIsometries) {
  for (const std::string name : {"octagon-diameter-domain", "bolza-radius-domain", "two-tiles-embedded-disk-domain"}) {
    const BoundDocument good = bound(name);
    ASSERT_EQ(outcome(good), "VERIFIED") << name;
    const std::size_t rows = good.symmetry->isometries.size();
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 2; k < good.symmetry->isometries[i].images.size(); ++k) {
        BoundDocument document = good;
        auto& images = document.symmetry->isometries[i].images;
        const auto& other = good.symmetry->isometries[(i + 1) % rows].images[k];
        if (images[k] == other) continue;
        images[k] = other;
        EXPECT_EQ(outcome(document), "REFUTED: isometries") << name << ", image " << k << " of isometry " << i;
      }
    }
  }
}

/// The best value for which the cells are bounded is the same number for both checkers, so where few digits do not
/// tell, more are asked.
TEST(SlowSecondCheckerOfBounds, TheBestValueIsTheSameToTheLastDigit) {
  for (const std::string name : {"octagon-diameter-base", "octagon-radius-base", "octagon-embedded-disk-base",
                                 "octagon-diameter-domain", "bolza-radius-domain"}) {
    BoundDocument document = bound(name);
    const bool is_radius = document.claim == BoundDocument::Claim::radius;
    double& end = is_radius ? document.value.lower : document.value.upper;
    double good = end;
    double bad = is_radius ? document.value.upper : document.value.lower;
    for (double middle = std::midpoint(good, bad); middle != good && middle != bad; middle = std::midpoint(good, bad)) {
      end = middle;
      (outcome(document) == "VERIFIED" ? good : bad) = middle;
    }
    end = good;
    EXPECT_EQ(first_outcome(document), "VERIFIED") << name;
    end = bad;
    EXPECT_EQ(outcome(document), "REFUTED: cells") << name;
    EXPECT_EQ(first_outcome(document), "REFUTED: cells") << name;
  }
}

/// A base of which each triangle is one cell, bounded by the triangulation of the net.
BoundDocument with_base(const std::vector<std::uint32_t>& steps) {
  BoundDocument document = bound("octagon-diameter-base");
  document.triangulations.clear();
  document.base = steps;
  const auto splits = std::count_if(steps.begin(), steps.end(), [](std::uint32_t step) { return step % 2 == 1; });
  document.cells.assign(document.net.triangles.size() + 2 * static_cast<std::size_t>(splits), {3});
  return document;
}

TEST(SlowSecondCheckerOfBounds, EveryStepOfABaseIsThatOfTheFormat) {
  // The least bound that holds at all corners is the same for both checkers, whichever edges are flipped and split:
  // also those of two triangles that have other edges in common, as there are many between six triangles.
  std::mt19937 random(15);
  int met = 0;
  for (int run = 0; run < 60; ++run) {
    std::vector<std::uint32_t> steps;
    std::uint32_t darts = 18;
    for (int k = 0; k < 2 + run % 5; ++k) {
      steps.push_back(static_cast<std::uint32_t>(random() % (2 * darts)));
      if (steps.back() % 2 == 1) darts += 6;
    }
    BoundDocument document = with_base(steps);
    const auto first = [&](double upper) {
      document.value.upper = upper;
      return first_outcome(document);
    };
    double refuted = document.value.lower;
    double verified = 20;
    if (first(verified) != "VERIFIED" || first(refuted) == "VERIFIED") continue;
    while (verified - refuted > 1e-6) {
      const double middle = (refuted + verified) / 2;
      (first(middle) == "VERIFIED" ? verified : refuted) = middle;
    }
    ++met;
    document.value.upper = verified + 1e-6;
    EXPECT_EQ(outcome(document), "VERIFIED") << run;
    document.value.upper = refuted - 1e-6;
    EXPECT_EQ(outcome(document), "REFUTED: cells") << run;
  }
  EXPECT_GT(met, 20);
}

TEST(SlowSecondCheckerOfBounds, PointsOfABaseAreKnownHoweverManySplitsLeadToThem) {
  // The edge from each midpoint to the end of the first edge is split next.
  std::vector<std::uint32_t> steps{1};
  for (std::uint32_t from_middle = 18; steps.size() < 200; from_middle += 6) steps.push_back(2 * from_middle + 1);
  BoundDocument document = with_base(steps);
  document.value.upper = 20;
  EXPECT_EQ(outcome(document), "VERIFIED");
  EXPECT_EQ(first_outcome(document), "VERIFIED");
}

TEST(SlowSecondCheckerOfBounds, ElementsAreKnownAlsoFarAway) {
  // On a surface of genus 3 with cuffs of 0.1: the longest edge of its net has a length of 44.
  EXPECT_EQ(outcome(bound("thin-diameter")), "VERIFIED");
}

TEST(SlowSecondCheckerOfBounds, AnEdgeWithOneTriangleOnBothSidesIsNotFlippedAndNotSplit) {
  // Dart 0 is split at m; flips of three of the four edges at m leave dart 22, within the triangle of darts 21 to 23.
  const std::vector<std::uint32_t> to_one_edge{1, 2, 0, 2};
  for (const std::uint32_t step : {44U, 45U}) {
    std::vector<std::uint32_t> steps = to_one_edge;
    BoundDocument document = with_base(steps);
    document.value.upper = 20;
    EXPECT_EQ(outcome(document), "VERIFIED");
    steps.push_back(step);
    document = with_base(steps);
    document.value.upper = 20;
    EXPECT_EQ(outcome(document), "REFUTED: triangulations");
    EXPECT_EQ(first_outcome(document), "REFUTED: triangulations");
  }
}

TEST(SlowSecondCheckerOfBounds, ABaseIsWhereTheVertexIs) {
  // The one vertex at other coordinates z, in a chart moved to c so that it is the same point: (z + c)/(1 + c̄z).
  for (const std::string name : {"octagon-diameter-base", "octagon-radius-base", "octagon-embedded-disk-base"}) {
    for (const auto& [x, y] : {std::pair{0.25, 0.5}, std::pair{-0.75, 0.125}}) {
      BoundDocument document = bound(name);
      NetDocument::Vertex& vertex = document.net.vertices[0];
      ASSERT_EQ(std::pair(vertex.x, vertex.y), std::pair(0.0, 0.0));
      vertex.x = x;
      vertex.y = y;
      // c − kc̄ = e with k = pz and e = p − z, p the point.
      certify::RationalPoint& centre = document.net.charts[vertex.chart].centre;
      const mpq_class zx(x), zy(y), px = centre.x, py = centre.y;
      const mpq_class kx = px * zx - py * zy, ky = px * zy + py * zx;
      const mpq_class ex = px - zx, ey = py - zy;
      const mpq_class scale = 1 - kx * kx - ky * ky;
      centre.x = (ex + kx * ex + ky * ey) / scale;
      centre.y = (ey + ky * ex - kx * ey) / scale;
      EXPECT_EQ(outcome(document), "VERIFIED") << name;
    }
  }
}

TEST(SlowSecondCheckerOfBounds, ACellNeedsABoundThatHoldsThere) {
  // Each cell with the bound of another one of its triangle, or another side or dart.
  for (const std::string& name : kBounds) {
    const BoundDocument good = bound(name);
    Comparison comparison;
    for (std::size_t t = 0; t < good.cells.size(); ++t) {
      std::vector<std::uint32_t> bounds;
      for (const std::uint32_t entry : good.cells[t]) {
        if (entry >= 3) bounds.push_back(entry);
      }
      std::size_t leaf = 0;
      for (std::size_t k = 0; k < good.cells[t].size(); ++k) {
        if (good.cells[t][k] < 3) continue;
        BoundDocument document = good;
        if (++leaf % 3 == 1) continue;
        document.cells[t][k] = bounds[leaf % bounds.size()];
        if (t % 2 == 0 && good.claim == BoundDocument::Claim::radius)
          document.cells[t][k] = static_cast<std::uint32_t>(3 + leaf % 3);
        comparison.expect_same(document, name + ", triangle " + std::to_string(t) + ", entry " + std::to_string(k));
        if (good.claim == BoundDocument::Claim::radius && leaf > 8) break;  // Each takes a tenth of a second.
      }
    }
    EXPECT_GT(comparison.refuted, 5) << name;
  }
}

TEST(SlowSecondCheckerOfBounds, ARadiusIsBoundedUpToTheSameValueByBothCheckers) {
  // Cells bounded at the midpoint of another one of their sides: the farthest point of a cell is an end of the side or
  // the corner opposite to it.
  const BoundDocument good = bound("octagon-radius");
  int found = 0;
  std::uint32_t leaf = 0;
  for (std::size_t t = 0; t < good.cells.size(); ++t) {
    for (std::size_t k = 0; k < good.cells[t].size(); ++k) {
      const std::uint32_t entry = good.cells[t][k];
      if (entry < 3 || ++leaf % 3 != 0) continue;
      BoundDocument document = good;
      document.cells[t][k] = 3 + (entry - 3) / 3 * 3 + (entry + 1 + leaf % 2) % 3;
      const auto verified = [&](double lower) {
        document.value.lower = lower;
        return first_outcome(document) == "VERIFIED";
      };
      double low = 1e-3;
      double high = good.value.lower;
      if (!verified(low) || verified(high)) continue;
      for (int i = 0; i < 7; ++i) (verified((low + high) / 2) ? low : high) = (low + high) / 2;
      ++found;
      document.value.lower = low;
      EXPECT_EQ(outcome(document), "VERIFIED") << t << ", entry " << k;
      document.value.lower = high;
      EXPECT_EQ(outcome(document), "REFUTED: cells") << t << ", entry " << k;
    }
  }
  EXPECT_GE(found, 4);
}

/// The midpoint of a side of a cell as a bound for a radius: the entry of a file, the least eccentricity that it
/// proves, and whether the ends of the side are farther from it than the corner opposite to it.
struct MidpointBound {
  std::uint32_t entry;
  double least;
  bool ends_are_farthest;
};

TEST(SlowSecondCheckerOfBounds, NoPointOfACellIsBeyondTheReachOfItsMidpoint) {
  // A triangle is cut once. Of a cell that has an obtuse angle, the ends of the opposite side are the farthest points.
  const BoundDocument good = bound("octagon-radius");
  const certify::Reference reference(good.net);
  std::vector<certify::Triangulation> triangulations{certify::triangulation_of(reference)};
  for (const auto& [parent, flips] : good.triangulations) {
    triangulations.push_back(triangulations[parent]);
    for (const std::uint32_t dart : flips) certify::flip(triangulations.back(), dart);
  }
  const auto bounds_of = [&](const auto& cell) {
    std::vector<MidpointBound> result;
    for (std::uint32_t side = 0; side < 3; ++side) {
      const auto half = certify::halves(cell, side)[0];
      const auto midpoint = half[(side + 1) % 3];
      const auto to_end = static_cast<double>(certify::distance(midpoint, half[side]));
      const auto to_opposite = static_cast<double>(certify::distance(midpoint, half[(side + 2) % 3]));
      for (std::uint32_t k = 0; k < triangulations.size(); ++k) {
        if (!certify::is_delaunay(triangulations[k], midpoint)) continue;
        const double least = certify::circumradius(triangulations[k], midpoint) - std::max(to_end, to_opposite);
        if (least > 1e-3) result.push_back({3 + side + 3 * k, least, to_end > to_opposite + 1e-3});
        break;  // Others that are Delaunay there are the same.
      }
    }
    return result;
  };
  std::array<int, 2> found{};
  for (std::uint32_t t = 0; t < good.net.triangles.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const auto cells = certify::halves(reference.corners(t), side);
      for (const MidpointBound& first : bounds_of(cells[0])) {
        for (const MidpointBound& second : bounds_of(cells[1])) {
          const MidpointBound& worse = first.least < second.least ? first : second;
          if (worse.least > good.value.lower - 1e-3 || ++found.at(worse.ends_are_farthest ? 1 : 0) > 4) continue;
          BoundDocument document = good;
          document.cells[t] = {side, first.entry, second.entry};
          document.value.lower = worse.least * (1 - 1e-9);
          EXPECT_EQ(outcome(document), "VERIFIED") << t << " " << side;
          EXPECT_EQ(first_outcome(document), "VERIFIED") << t << " " << side;
          document.value.lower = worse.least * (1 + 1e-9);
          EXPECT_EQ(outcome(document), "REFUTED: cells") << t << " " << side;
          EXPECT_EQ(first_outcome(document), "REFUTED: cells") << t << " " << side;
        }
      }
    }
  }
  EXPECT_GT(found[0], 3);
  EXPECT_GT(found[1], 3);
}

// Triangulations with one vertex.

/// Lemma 25 in binary64, by angles: of triangles with the sides of hyperbolic ones and of Euclidean ones.
struct AngledTriangulation {
  std::vector<Index> opposite;
  std::vector<double> h;  ///< sinh²(d/2), by dart.

  [[nodiscard]] std::array<double, 3> sides(std::size_t t) const { return {h[3 * t], h[3 * t + 1], h[3 * t + 2]}; }
  /// π less the angles.
  [[nodiscard]] double area(std::size_t t) const {
    double result = M_PI;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto cosh = [&](std::size_t k) { return 1 + 2 * sides(t).at((i + k) % 3); };
      const auto sinh = [&](std::size_t k) { return std::sqrt(cosh(k) * cosh(k) - 1); };
      result -= std::acos((cosh(1) * cosh(2) - cosh(0)) / (sinh(1) * sinh(2)));
    }
    return result;
  }
  /// Opposite to side i of the triangle with the sides √a, √b, √c.
  [[nodiscard]] double flat_angle(std::size_t t, std::size_t i) const {
    const auto side = [&](std::size_t k) { return sides(t).at((i + k) % 3); };
    return std::acos((side(1) + side(2) - side(0)) / (2 * std::sqrt(side(1) * side(2))));
  }
  /// sinh² of the circumradius: 2R = √a/sin α in the flat triangle, of which the circle has that radius.
  [[nodiscard]] double squared_radius(std::size_t t) const {
    const double sine = std::sin(flat_angle(t, 0));
    return sides(t)[0] / (sine * sine);
  }
  [[nodiscard]] bool is_delaunay() const {
    const std::size_t triangles = h.size() / 3;
    double excess = -M_PI * (static_cast<double>(triangles) - 2);
    for (std::size_t t = 0; t < triangles; ++t) {
      if (std::isnan(flat_angle(t, 0))) return false;
      excess += area(t);
    }
    for (std::size_t t = 0; t < triangles; ++t) {
      if (!(excess < area(t))) return false;
    }
    for (std::size_t dart = 0; dart < h.size(); ++dart) {
      const Index other = opposite[dart];
      if (!(flat_angle(dart / 3, dart % 3) + flat_angle(other / 3, other % 3) < M_PI)) return false;
    }
    return true;
  }
  [[nodiscard]] double greatest_squared_radius() const {
    double result = 0;
    for (std::size_t t = 0; t < h.size() / 3; ++t) result = std::max(result, squared_radius(t));
    return result;
  }
};

TEST(TriangulationsWithOneVertex, AreDelaunayAndWideForBothCheckersIfTheirAnglesSaySo) {
  AngledTriangulation triangulation{{3, 17, 8, 0, 16, 11, 12, 15, 2, 14, 13, 5, 6, 10, 9, 7, 4, 1}, {}};
  std::mt19937 random(1);  // NOLINT: the same in every run.
  const certify::Precision scope(128);
  std::array<int, 2> met{};
  for (int run = 0; run < 500; ++run) {
    triangulation.h.assign(18, 0);
    // About those of which the areas decide: triangles with sides of 22 have the area 4π/5.
    const double size = 5 + static_cast<double>(random() % 1000) / 20;
    for (std::size_t dart = 0; dart < 18; ++dart) {
      const Index other = triangulation.opposite[dart];
      const double factor = 1 + static_cast<double>(random() % 1000) / 2000;
      triangulation.h[dart] = other < dart ? triangulation.h[other] : size * factor;
    }
    std::vector<certify::Ball> balls;
    std::vector<Interval> intervals;
    std::vector<RoughInterval> rough;
    for (const double x : triangulation.h) {
      balls.push_back(certify::Ball::exactly(x));
      intervals.emplace_back(mpq_class(x));
      rough.emplace_back(intervals.back());
    }
    const bool delaunay = triangulation.is_delaunay();
    const double radius = delaunay ? triangulation.greatest_squared_radius() : 1e-3;
    for (const double least : {radius * (1 - 1e-9), radius * (1 + 1e-9)}) {
      const bool expected = delaunay && least < radius;
      ++met.at(expected ? 1 : 0);
      EXPECT_EQ(is_delaunay_and_wide(triangulation.opposite, intervals, Interval(mpq_class(least))),
                expected ? Answer::yes : Answer::no)
          << run;
      EXPECT_EQ(is_delaunay_and_wide(triangulation.opposite, rough, RoughInterval(mpq_class(least))),
                expected ? Answer::yes : Answer::no)
          << run;
      EXPECT_EQ(certify::is_delaunay_and_wide(triangulation.opposite, balls, certify::Ball::exactly(least)),
                expected ? certify::Tri::yes : certify::Tri::no)
          << run;
    }
  }
  EXPECT_GT(met[0], 50);
  EXPECT_GT(met[1], 50);
}

TEST(SecondCheckerOfBounds, ThreePointsFitInNoSmallerDiskThanTheLeastOne) {
  // The least disk around three points is that around the middle of the longest side if the third point is in it, and
  // else the circumdisk. In binary64, by the law of cosines for half of a triangle.
  std::mt19937 random(20);
  std::array<int, 2> met{};
  for (int run = 0; run < 2000; ++run) {
    std::array<std::complex<double>, 3> z;
    const double size = std::pow(10, -static_cast<double>(run % 3));
    for (auto& point : z) {
      point =
          std::polar(size * 0.9 * static_cast<double>(random() % 1000) / 1000, static_cast<double>(random() % 6283));
    }
    std::array<double, 3> h{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto p = z[i], q = z[(i + 1) % 3];
      h[i] = std::norm(p - q) / ((1 - std::norm(p)) * (1 - std::norm(q)));
    }
    if (*std::min_element(h.begin(), h.end()) < 1e-9) continue;
    const std::size_t longest = static_cast<std::size_t>(std::max_element(h.begin(), h.end()) - h.begin());
    const double x = h[(longest + 1) % 3], y = h[(longest + 2) % 3], half = h[longest];
    // sinh²(m/2) of the median m: cosh m = (cosh d + cosh d′)/(2 cosh r), cosh d = 1 + 2 sinh²(d/2), sinh²r = half.
    const double median = (1 + x + y) / std::sqrt(1 + half);
    const bool in_it = median * median <= 1 + half;
    const double k = 4 * x * y - (x + y - half) * (x + y - half);
    const double least = in_it ? half : 4 * x * y * half / k;
    if (std::abs(median * median / (1 + half) - 1) < 1e-6 * half) continue;
    ++met.at(in_it ? 1 : 0);
    const auto exactly = [](double value) { return Interval(mpq_class(value)); };
    const auto fits = [&]<class Number>(Number, double most) {
      const auto number = [&](double value) { return Number(exactly(value)); };
      return fits_in_disk(number(h[0]), number(h[1]), number(h[2]), number(most));
    };
    EXPECT_EQ(fits(Interval(), least * (1 + 1e-9)), Answer::yes) << run;
    EXPECT_EQ(fits(Interval(), least * (1 - 1e-9)), Answer::no) << run;
    EXPECT_EQ(fits(RoughInterval(), least * (1 + 1e-9)), Answer::yes) << run;
    EXPECT_EQ(fits(RoughInterval(), least * (1 - 1e-9)), Answer::no) << run;
  }
  EXPECT_GT(met[0], 300);
  EXPECT_GT(met[1], 300);
}

TEST(SlowSecondCheckerOfBounds, LongEdgesDoNotBoundACell) {
  // Two flips of edges of one triangle make long ones, which are the first, second or third side of triangles.
  const BoundDocument good = bound("octagon-diameter");
  Comparison comparison;
  const auto darts = static_cast<std::uint32_t>(3 * good.net.triangles.size());
  const auto first_cell =
      std::find_if(good.cells[0].begin(), good.cells[0].end(), [](auto entry) { return entry >= 3; });
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    for (const std::uint32_t next : {certify::next_dart(dart), certify::previous_dart(dart)}) {
      BoundDocument document = good;
      document.triangulations.push_back({0, {dart, next}});
      document.cells[0].at(static_cast<std::size_t>(first_cell - good.cells[0].begin())) =
          static_cast<std::uint32_t>(3 + document.triangulations.size());
      comparison.expect_same(document, "dart " + std::to_string(dart));
    }
  }
  EXPECT_GT(comparison.refuted, 20);
}

TEST(SlowSecondCheckerOfBounds, NoFlipMayBeLeftOut) {
  for (const std::string& name : kBounds) {
    const BoundDocument good = bound(name);
    Comparison comparison;
    const std::size_t step = good.claim == BoundDocument::Claim::radius ? 7 : 2;
    for (std::size_t k = 0; k < good.triangulations.size(); k += step) {
      BoundDocument document = good;
      auto& flips = document.triangulations[k].flips;
      if (flips.empty()) continue;
      flips.erase(flips.begin() + static_cast<std::ptrdiff_t>(k % flips.size()));
      comparison.expect_same(document, name + ", triangulation " + std::to_string(k));
    }
    EXPECT_TRUE(comparison.refuted > 2 || good.triangulations.size() < 10) << name;
  }
}

TEST(SlowSecondCheckerOfBounds, ManyTriangulationsOfManyDartsAreUndecided) {
  BoundDocument document = bound("octagon-diameter");
  document.triangulations.resize(1'400'000, {0, {}});
  const Result result = result_of(document);
  EXPECT_EQ(result.rule, "triangulations");
  EXPECT_EQ(result.message, "the triangulations have 25200018 darts, and this checker takes 25000000");
}

// Isometries.

IsometriesDocument isometries(const std::string& name) { return load<IsometriesDocument>("isometries/" + name); }

TEST(SlowSecondCheckerOfIsometries, RefutesImagesThatAreNone) {
  const IsometriesDocument good = isometries("octagon-5");
  for (std::size_t k = 0; k < good.isometries[0].images.size(); ++k) {
    IsometriesDocument document = good;
    Word& image = document.isometries[0].images[k];
    image = reversed(good.net, image);
    EXPECT_EQ(outcome(document), "REFUTED: isometries") << k;
    if (k % 2 != 0) continue;
    // A conjugate, whose trace is the same; that of products is not.
    document = good;
    const Word other = good.isometries[0].images[k < 4 ? 4 : 2];
    Word& conjugate = document.isometries[0].images[k];
    conjugate = joined(joined(other, conjugate), reversed(good.net, other));
    EXPECT_EQ(outcome(document), "REFUTED: isometries") << k;
  }
}

TEST(SlowSecondCheckerOfIsometries, RefutesWrongOrientationsOfEachOne) {
  const IsometriesDocument good = isometries("bolza");
  for (std::size_t i = 0; i < good.isometries.size(); ++i) {
    IsometriesDocument document = good;
    document.isometries[i].preserves_orientation = !document.isometries[i].preserves_orientation;
    EXPECT_EQ(outcome(document), "REFUTED: isometries") << i;
  }
  IsometriesDocument document = isometries("octagon-5");
  document.pair[1] = document.pair[0];
  EXPECT_EQ(outcome(document), "REFUTED: isometries");
}

TEST(SlowSecondCheckerOfIsometries, AnyLiftAndAnyPathsWillDo) {
  IsometriesDocument document = isometries("octagon-5");
  const Word turned = document.pair[0];
  for (Word& image : document.isometries[0].images) {
    image = joined(joined(turned, image), reversed(document.net, turned));
  }
  EXPECT_EQ(outcome(document), "VERIFIED");
  document = isometries("fenchel-nielsen-3-1");
  for (Word& path : document.paths) path = joined(document.pair[0], path);
  EXPECT_EQ(outcome(document), "VERIFIED");
  // Two tiles with an involution.
  document = isometries("fenchel-nielsen-2");
  for (Word& path : document.paths) path = joined(document.pair[0], path);
  EXPECT_EQ(outcome(document), "REFUTED: isometries");
  std::vector<Word>& images = document.isometries[0].images;
  for (std::size_t k = 2; k < images.size(); ++k) {
    images[k] = joined(joined(images[0], images[k]), reversed(document.net, images[0]));
  }
  EXPECT_EQ(outcome(document), "VERIFIED");
}

/// With so short a spectrum that nothing is known of other isometries, which rule `most` says last.
IsometriesDocument with_systoles_alone(IsometriesDocument document) {
  const double systole = document.geodesics[0].length.upper;
  std::erase_if(document.geodesics, [&](const auto& row) { return row.length.lower > systole; });
  document.up_to = certify::decimal_above(systole + 1e-6);
  document.clusters = {{0, static_cast<std::uint32_t>(document.geodesics.size()), false}};
  document.isometries.clear();
  document.order = 1;
  return document;
}

/// The identity as an isometry of a surface of one tile, by generators without partners.
IsometriesDocument::Isometry identity(const IsometriesDocument& document) {
  const certify::SurfaceSides sides(document.net.surface);
  IsometriesDocument::Isometry result{true, document.pair};
  for (std::uint32_t s = 0; s < sides.partner.size(); ++s) {
    if (s < sides.partner[s]) result.images.push_back({s});
  }
  return result;
}

TEST(SlowSecondCheckerOfIsometries, EachProductOfTheBasisTellsImages) {
  // Opposite sides of an octagon are glued. The half turn about the centre of a side takes the generators x and y
  // through it to their inverses, and so does g ↦ s g s⁻¹ with all others: only the product with xy tells.
  for (const std::string name : {"octagon-5", "bolza"}) {
    const IsometriesDocument good = with_systoles_alone(isometries(name));
    for (const std::uint32_t side : {0U, 5U}) {
      if (side != 0 && name == "bolza") continue;
      const std::uint32_t next = (side + 1) % 8;
      for (const Word& other : {Word{side, (next + 4) % 8}, Word{(next + 4) % 8, side}}) {
        IsometriesDocument document = good;
        document.pair = {{side}, other};
        document.isometries = {identity(document)};
        EXPECT_EQ(outcome(document), first_outcome(document));
        const IsometriesDocument same = document;
        for (const std::uint32_t by : {side, (side + 4) % 8}) {
          document = same;
          for (std::size_t k = 2; k < 6; ++k) {
            Word& image = document.isometries[0].images[k];
            image = joined(joined({by}, image), {(by + 4) % 8});
          }
          EXPECT_EQ(outcome(document), "REFUTED: isometries") << name << side << by;
          EXPECT_EQ(first_outcome(document), "REFUTED: isometries") << name << side << by;
        }
      }
    }
  }
}

TEST(SlowSecondCheckerOfIsometries, EachImageIsTold) {
  // Of the identity one image is the inverse, or another generator, of equal length on a regular octagon.
  for (const std::string name : {"octagon-5", "bolza"}) {
    const IsometriesDocument good = with_systoles_alone(isometries(name));
    for (std::size_t k = 0; k < 6; ++k) {
      for (const auto s : {static_cast<std::uint32_t>(k + 2) % 8, static_cast<std::uint32_t>(k + 1) % 8, 0U}) {
        IsometriesDocument document = good;
        document.isometries = {identity(document)};
        document.isometries[0].images[k] = {s};
        const bool same = document.isometries[0].images == identity(document).images;
        const std::string expected = same ? "UNDECIDED: most" : "REFUTED: isometries";
        EXPECT_EQ(outcome(document).substr(0, 9), expected.substr(0, 9)) << name << k << s;
        EXPECT_EQ(first_outcome(document).substr(0, 9), expected.substr(0, 9)) << name << k << s;
      }
    }
  }
}

TEST(SlowSecondCheckerOfIsometries, TheTraceOfAnElementItselfTells) {
  // On surfaces of octagons with opposite sides glued, x and y as below, the product of 4, 7, 1, 3 has the same traces
  // with x, y and xy as 3 has, but for one sign; its own trace is greater.
  for (const std::string name : {"octagon-5", "bolza"}) {
    IsometriesDocument document = with_systoles_alone(isometries(name));
    document.pair = {{0}, {7, 5}};
    document.isometries = {identity(document)};
    ASSERT_EQ(document.isometries[0].images[5], (Word{3}));
    EXPECT_EQ(outcome(document).substr(0, 9), "UNDECIDED");
    document.isometries[0].images[5] = {4, 7, 1, 3};
    EXPECT_EQ(outcome(document), "REFUTED: isometries") << name;
    EXPECT_EQ(first_outcome(document), "REFUTED: isometries") << name;
  }
}

TEST(SlowSecondCheckerOfIsometries, ThePairKeepsTheSignsOfItsTraces) {
  // All lengths of the images of x, y and xy are those of x, y and xy, but the axes of the images do not cross: the
  // trace of their product is negative.
  IsometriesDocument document = with_systoles_alone(isometries("bolza"));
  for (const auto& [other, image] : {std::pair{Word{2}, Word{1, 7, 4}}, {Word{3}, Word{2, 5}}}) {
    document.pair = {{0}, other};
    document.isometries = {identity(document)};
    document.isometries[0].images[1] = image;
    const Result result = result_of(document);
    EXPECT_EQ(result.verdict, Verdict::refuted);
    EXPECT_EQ(result.rule, "isometries");
    EXPECT_EQ(result.message, "isometry 0 changes traces");
  }
}

TEST(SlowSecondCheckerOfIsometries, TheAxesOfThePairCross) {
  // A simple closed geodesic and a lift of it elsewhere.
  for (const std::string name : {"octagon-5", "bolza"}) {
    for (std::uint32_t s = 1; s < 8; ++s) {
      if (s == 4) continue;
      IsometriesDocument document = with_systoles_alone(isometries(name));
      document.pair = {{0}, {s, s, 0, (s + 4) % 8, (s + 4) % 8}};
      EXPECT_EQ(outcome(document), "REFUTED: isometries") << name << s;
      EXPECT_EQ(first_outcome(document), "REFUTED: isometries") << name << s;
    }
  }
}

TEST(SlowSecondCheckerOfIsometries, TheOrderIsThatOfTheGroup) {
  const IsometriesDocument good = isometries("bolza");
  for (const auto& [order, expected] :
       {std::pair{95U, "REFUTED: least"}, {48U, "REFUTED: least"}, {97U, "REFUTED: most"}, {192U, "REFUTED: most"}}) {
    IsometriesDocument document = good;
    document.order = order;
    EXPECT_EQ(outcome(document), expected) << order;
  }
  IsometriesDocument document = isometries("octagon-5");
  document.isometries.clear();
  document.order = 1;
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
  document = good;
  std::erase_if(document.isometries, [](const auto& isometry) { return !isometry.preserves_orientation; });
  EXPECT_EQ(outcome(document), "UNDECIDED: least");
  document.order = static_cast<std::uint32_t>(
      certify::orbit_size(certify::SurfaceSides(document.net.surface), document, certify::Budget()));
  ASSERT_GE(document.order, 2U);
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
  document = isometries("octagon-5");
  std::fill(document.cocycle.begin(), document.cocycle.end(), 0);
  EXPECT_EQ(outcome(document), "UNDECIDED: least");
}

TEST(SlowSecondCheckerOfIsometries, ACocycleHasTheSum0AroundEachVertex) {
  const IsometriesDocument good = isometries("fenchel-nielsen-3-1");
  const certify::SurfaceSides sides(good.net.surface);
  std::size_t k = 0;
  std::size_t edges = 0;
  std::size_t loops = 0;
  for (std::uint32_t s = 0; s < sides.partner.size(); ++s) {
    if (s > sides.partner[s]) continue;
    IsometriesDocument document = good;
    ++document.cocycle[k++];
    // What a loop at a vertex adds it takes away.
    const bool is_loop = vertex_of(sides, s) == vertex_of(sides, sides.partner[s]);
    if (is_loop && ++loops > 1) continue;
    edges += is_loop ? 0 : 1;
    EXPECT_EQ(outcome(document), is_loop ? "VERIFIED" : "MALFORMED") << s;
  }
  EXPECT_GT(edges, 0U);
}

TEST(SlowSecondCheckerOfIsometries, OneLeftOutOfTheSpectrumIsMissed) {
  IsometriesDocument document = isometries("octagon-5");
  document.geodesics.pop_back();
  document.clusters.pop_back();
  EXPECT_EQ(outcome(document), "REFUTED: complete");
}

// Pseudo nets.

/// Collars about geodesics of the lengths 1/8 and 1/4.
NetDocument two_collars() { return load<NetDocument>("forgeries/collars"); }

/// Of the rule `collars`: verified if a later one fails, which are asked afterwards.
Verdict collars(const NetDocument& document) {
  const Result result = result_of(document);
  return result.rule == "collars" ? result.verdict : Verdict::verified;
}

/// The same by the first checker.
Verdict collars_by_the_first(const NetDocument& document) {
  for (const certify::RuleReport& rule : certify::check(document, {.threads = 1}).rules) {
    if (rule.rule == "collars")
      return rule.verdict == certify::Verdict::verified ? Verdict::verified : Verdict::refuted;
  }
  return Verdict::undecided;
}

std::string text_of(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

TEST(SlowSecondCheckerOfPseudoNets, EpsilonLiesBetweenTheEndsThatBothCheckersFind) {
  // A vertex of a collar at some distance from the core: for small epsilon it does not cover what it should, or the
  // core is longer; for large epsilon it is in the thin part. Both ends, to a billionth.
  int ends = 0;
  for (const std::size_t c : {std::size_t{0}, std::size_t{1}}) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      for (const double angle : {0.0, 2.0}) {
        NetDocument document = two_collars();
        document.collars = {{(*document.collars)[c]}};
        NetDocument::Vertex& vertex = document.vertices[(*document.collars)[0].vertices[i]];
        vertex.x = 0.05 * std::cos(angle);
        vertex.y = 0.05 * std::sin(angle);
        const auto verified = [&](double epsilon) {
          document.epsilon = text_of(epsilon);
          return collars_by_the_first(document) == Verdict::verified;
        };
        double some = 0.05;
        while (some < 0.34 && !verified(some)) some += 0.03;
        if (some >= 0.34) continue;
        for (double outside : {0.04, 0.3465}) {
          if (verified(outside)) continue;
          double inside = some;
          for (int k = 0; k < 36; ++k) (verified((inside + outside) / 2) ? inside : outside) = (inside + outside) / 2;
          ++ends;
          document.epsilon = text_of(inside + (inside - outside) * 100);
          EXPECT_EQ(collars(document), Verdict::verified) << document.epsilon;
          document.epsilon = text_of(outside - (inside - outside) * 100);
          EXPECT_EQ(collars(document), Verdict::refuted) << document.epsilon;
        }
      }
    }
  }
  EXPECT_GE(ends, 8);
}

TEST(SlowSecondCheckerOfPseudoNets, ACoreIsAsLongAsTheFileSaysAndGoneAroundOnce) {
  for (std::size_t c = 0; c < 2; ++c) {
    const double length = c == 0 ? 0.125 : 0.25;
    for (const auto& [lower, upper, expected] :
         {std::tuple{length * (1 + 1e-12), 1.0, Verdict::refuted},
          std::tuple{0.0, length * (1 - 1e-12), Verdict::refuted},
          std::tuple{length * (1 - 1e-12), length * (1 + 1e-12), Verdict::verified}}) {
      NetDocument document = two_collars();
      (*document.collars)[c].length = {lower, upper};
      EXPECT_EQ(collars(document), expected) << lower << ", " << upper;
    }
    NetDocument document = two_collars();
    Word& core = (*document.collars)[c].core;
    const Word once = core;
    core = reversed(document, once);
    EXPECT_EQ(collars(document), Verdict::verified);
    core = joined(once, once);
    EXPECT_EQ(collars(document), Verdict::refuted);
    core.clear();
    EXPECT_EQ(collars(document), Verdict::refuted);
  }
}

TEST(SlowSecondCheckerOfPseudoNets, ACoreIsShorterThanEpsilon) {
  NetDocument document = two_collars();
  document.collars = {{(*document.collars)[0]}};
  document.epsilon = text_of(0.125 * (1 - 1e-12));
  const Result result = result_of(document);
  EXPECT_EQ(result.verdict, Verdict::refuted);
  EXPECT_EQ(result.message, "the length of the core is greater than epsilon");
  const certify::Certificate first = certify::check(document, {.threads = 1});
  EXPECT_EQ(first.verdict, certify::Verdict::refuted);
  EXPECT_NE(first.message.find("greater than epsilon"), std::string::npos) << first.message;
  document.epsilon = text_of(0.125 * (1 + 1e-12));
  EXPECT_NE(result_of(document).message, result.message);
}

TEST(SlowSecondCheckerOfPseudoNets, VerticesLieOnDifferentSidesOfTheCore) {
  // Moved about, also to the core and over it.
  std::array<int, 2> met{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (int k = 0; k < 12; ++k) {
        NetDocument document = two_collars();
        NetDocument::Vertex& vertex = document.vertices[(*document.collars)[c].vertices[i]];
        const double r = std::array{0.003, 0.02, 0.1, 0.4}[static_cast<std::size_t>(k % 4)];
        vertex.x = r * std::cos(M_PI / 6 * k + 0.1);
        vertex.y = r * std::sin(M_PI / 6 * k + 0.1);
        const Verdict expected = collars_by_the_first(document);
        EXPECT_EQ(collars(document), expected) << c << i << k;
        ++met.at(expected == Verdict::verified ? 0 : 1);
      }
    }
  }
  EXPECT_GT(met[0], 3);
  EXPECT_GT(met[1], 3);
}

TEST(SlowSecondCheckerOfPseudoNets, EpsilonIsAtMostLnOfRootTwo) {
  // ln √2 = 0.34657359027997265470861606072908828…
  NetDocument document = two_collars();
  document.collars = std::vector<NetDocument::Collar>{};
  document.epsilon = "0.34657359027997265470861606072909";
  EXPECT_EQ(collars(document), Verdict::refuted);
  document.epsilon = "0.34657359027997265470861606072908";
  EXPECT_EQ(collars(document), Verdict::verified);
}

TEST(SlowSecondCheckerOfPseudoNets, WithoutItsCollarsANetDoesNotCover) {
  NetDocument document = two_collars();
  ASSERT_EQ(outcome(document), "VERIFIED");
  document.collars->clear();
  EXPECT_EQ(outcome(document), "REFUTED: covering");
}

/// Every net of the folders on rational tiles has the verdict of the same net over a number field.
TEST(SecondChecker, NetsOverAFieldHaveTheVerdictsOfRationalOnes) {
  int compared = 0;
  for (const char* folder : {"certify/verified", "certify/refuted", "forgeries"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(EPSNET_TEST_DATA) + "/" + folder)) {
      if (entry.path().extension() != ".json") continue;
      const certify::ClaimDocument claim = certify::read_file<certify::ClaimDocument>(entry.path());
      const auto* net = std::get_if<NetDocument>(&claim);
      if (net == nullptr || net->surface.tiles.empty() || !certify::test::has_crossings(net->surface)) continue;
      NetDocument same = *net;
      same.surface = certify::test::over_field(net->surface);
      EXPECT_EQ(outcome(same), outcome(*net)) << entry.path();
      ++compared;
    }
  }
  EXPECT_GE(compared, 30);
}

}  // namespace
}  // namespace epsnet::exact::second_checker_claims_test
