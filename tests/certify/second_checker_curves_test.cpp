#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/claims/curves/crossings.h"
#include "certify/exact/checker.h"
#include "certify/exact/closed_walks.h"
#include "certify/exact/document.h"
#include "certify/exact/interval.h"
#include "certify/exact/json.h"
#include "certify/exact/net_structure.h"
#include "certify/file/file.h"
#include "tests/certify/claim_files.h"
#include "tests/certify/far_words.h"
#include "tests/certify/lifted_reference.h"

/// Curves files, asked of both checkers. Each rule is broken by a file in which nothing else is wrong.
namespace epsnet::certify::curves_test {
namespace {

using testing::HasSubstr;
using Document = CurvesDocument;
using Word = std::vector<std::uint32_t>;

Document read(const std::string& name) {
  return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/curves/" + name + ".json");
}

std::string text_of(const AnyClaim& document) {
  std::ostringstream out;
  write_file(document, out);
  return out.str();
}

/// "VERDICT", or "VERDICT: rule", of both checkers; both, if they differ.
std::string both(const Document& document) {
  constexpr std::array<const char*, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  const exact::Result result = exact::check(text_of(document));
  std::string second = kNames.at(static_cast<std::size_t>(result.verdict));
  if (!result.rule.empty()) second += ": " + result.rule;
  std::string first = outcome(document);
  if (first == "MALFORMED: structure") first = "MALFORMED";
  return first == second ? first : first + "; " + second;
}

Document octagon() { return read("octagon-5"); }

template <class Change>
Document changed(Document document, const Change& change) {
  change(document);
  return document;
}

std::string message(const Document& document) { return checked(document).message; }

template <class AnyDocument>
auto& pair_of(AnyDocument& document, std::uint32_t i, std::uint32_t j) {
  return *std::find_if(document.pairs.begin(), document.pairs.end(),
                       [&](const auto& pair) { return pair.first == i && pair.second == j; });
}

// The regular 4g-gon, opposite sides glued: letter k is the loop through the middles of sides k and k + 2g.

NetDocument regular_net(std::uint32_t genus) {
  const std::string name = genus == 2 ? "regular-2-10-vertices" : "regular-3-centre";
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name + ".json");
}

/// The loops of letters 0 to 2g − 1, which are diameters of the polygon: each two cross in its centre, and the
/// direction of a later one is on the left of that of an earlier one.
Document diameters(std::uint32_t genus) {
  Document document{.net = regular_net(genus), .curves = {}, .pairs = {}, .basis = {}, .filling = {}};
  // cosh of half of the length is twice cosh²(r) − 1, for the inscribed radius r.
  const double angle = std::acos(-1.0) / (4.0 * genus);
  const double length = 2 * std::acosh(1 / std::tan(angle));
  for (std::uint32_t k = 0; k < 2 * genus; ++k) {
    std::vector<std::int64_t> homology(2 * genus);
    homology[k] = 1;
    document.curves.push_back({0, {k}, {length - 1e-9, length + 1e-9}, 1, 0, homology});
    document.basis.push_back(k);
    for (std::uint32_t j = k + 1; j < 2 * genus; ++j) document.pairs.push_back({k, j, 1, 1});
  }
  return document;
}

TEST(Curves, TrueFiles) {
  for (const char* name : {"octagon-5", "bolza", "klein"}) {
    EXPECT_EQ(both(read(name)), "VERIFIED") << name;
  }
}

TEST(Curves, DiametersOfARegularPolygonCrossInItsCentre) {
  for (const std::uint32_t genus : {2U, 3U}) EXPECT_EQ(both(diameters(genus)), "VERIFIED") << genus;
}

TEST(Curves, Structure) {
  const Document good = read("octagon-5");
  const auto problem = [&](const auto& change) {
    const Document document = changed(good, change);
    EXPECT_EQ(exact::check(text_of(document)).verdict, exact::Verdict::malformed);
    return structure_complaint(document);
  };
  using D = Document;
  constexpr std::int64_t kTooMuch = (std::int64_t{1} << 53) + 1;
  EXPECT_THAT(problem([](D& d) { d.net.collars.emplace(); }), HasSubstr("expected a net of the whole surface"));
  EXPECT_THAT(problem([](D& d) { d.curves[2].vertex = 9; }), HasSubstr("curves[2]: vertex 9 does not exist"));
  EXPECT_THAT(problem([](D& d) { d.curves[2].word.push_back(8); }), HasSubstr("curves[2]: "));
  EXPECT_THAT(problem([](D& d) { d.curves[2].length.lower = 0; }), HasSubstr("is not 0 < lo <= hi"));
  EXPECT_THAT(problem([](D& d) { std::swap(d.curves[2].length.lower, d.curves[2].length.upper); }),
              HasSubstr("is not 0 < lo <= hi"));
  EXPECT_THAT(problem([](D& d) { d.curves[2].power = 0; }), HasSubstr("power: 0, expected at least 1"));
  EXPECT_THAT(problem([](D& d) { d.curves[2].self_intersections = static_cast<std::uint64_t>(kTooMuch); }),
              HasSubstr("self_intersections: 9007199254740993 is larger than 2^53"));
  EXPECT_THAT(problem([](D& d) { d.curves[2].homology.push_back(0); }), HasSubstr("homology: 5 integers"));
  EXPECT_THAT(problem([](D& d) { d.curves[2].homology.pop_back(); }), HasSubstr("homology: 3 integers"));
  EXPECT_THAT(problem([](D& d) { d.curves[2].homology[1] = -kTooMuch; }), HasSubstr("is larger than 2^53"));
  EXPECT_THAT(problem([](D& d) { d.pairs.pop_back(); }), HasSubstr("pairs: 54 rows"));
  EXPECT_THAT(problem([](D& d) { d.pairs.push_back(d.pairs.back()); }), HasSubstr("pairs: 56 rows"));
  EXPECT_THAT(problem([](D& d) { std::swap(d.pairs[9], d.pairs[10]); }),
              HasSubstr("pairs[9]: curves 1 and 2, expected 0 and 10"));
  EXPECT_THAT(problem([](D& d) { ++d.pairs[9].second; }), HasSubstr("pairs[9]: curves 0 and 11, expected 0 and 10"));
  EXPECT_THAT(problem([](D& d) { ++d.pairs[3].first; }), HasSubstr("pairs[3]: curves 1 and 4, expected 0 and 4"));
  EXPECT_THAT(problem([](D& d) { std::swap(d.pairs[3].first, d.pairs[3].second); }),
              HasSubstr("pairs[3]: curves 4 and 0, expected 0 and 4"));
  EXPECT_THAT(problem([](D& d) { d.pairs[3].intersections = static_cast<std::uint64_t>(kTooMuch); }),
              HasSubstr("intersections: "));
  EXPECT_THAT(problem([](D& d) { d.pairs[3].algebraic = -kTooMuch; }), HasSubstr("algebraic: "));
  EXPECT_THAT(problem([](D& d) { d.basis[1] = 11; }), HasSubstr("basis[1]: curve 11 does not exist"));
  EXPECT_THAT(problem([](D& d) { d.basis[1] = d.basis[0]; }), HasSubstr("occurs twice"));
  EXPECT_THAT(problem([](D& d) { d.filling[0].back() = 11; }), HasSubstr("filling[0]: curve 11 does not exist"));
  EXPECT_THAT(problem([](D& d) { std::swap(d.filling[1][0], d.filling[1][1]); }),
              HasSubstr("expected ascending order"));
  EXPECT_THAT(problem([](D& d) { d.filling[1][1] = d.filling[1][0]; }), HasSubstr("expected ascending order"));
  EXPECT_EQ(both(changed(octagon(), [](D& d) { d.curves[2].homology[1] = kTooMuch - 1; })), "REFUTED: homology");
}

TEST(Curves, IntegersAreIntegers) {
  const std::string text = text_of(octagon());
  const std::string member = "\"algebraic\":";
  const std::size_t first = text.find(member) + member.size();
  const auto with = [&](const std::string& number) {
    return text.substr(0, first) + number + text.substr(text.find('}', first));
  };
  const std::string own = text.substr(first, text.find('}', first) - first);
  ASSERT_EQ(reading_complaint<Document>(with(own)), "");
  EXPECT_EQ(exact::check(with(own)).verdict, exact::Verdict::verified);
  for (const char* number : {"0.0", "1e0", "-0", "01", "+1", "\"1\"", "true", "[]", "-", "null", "9007199254740993",
                             "-9007199254740993", "99999999999999999999999", "-99999999999999999999999"}) {
    EXPECT_NE(reading_complaint<Document>(with(number)), "") << number;
    EXPECT_EQ(exact::check(with(number)).verdict, exact::Verdict::malformed) << number;
  }
  for (const char* number : {"-9007199254740992", "9007199254740992", "7"}) {
    EXPECT_EQ(reading_complaint<Document>(with(number)), "") << number;
    EXPECT_EQ(exact::check(with(number)).verdict, exact::Verdict::refuted) << number;
  }
}

// Rule lengths.

TEST(Curves, LengthsAreThoseOfTheGeodesicsAsAWhole) {
  const Document good = octagon();
  for (const std::size_t i : {0U, 6U, 10U}) {
    EXPECT_EQ(both(changed(good,
                           [&](Document& d) {
                             d.curves[i].length = {1e-3, d.curves[i].length.lower};
                           })),
              "REFUTED: lengths");
    EXPECT_EQ(both(changed(good,
                           [&](Document& d) {
                             d.curves[i].length = {d.curves[i].length.upper, 1000};
                           })),
              "REFUTED: lengths");
    EXPECT_EQ(both(changed(good, [&](Document& d) { d.curves[i].length = {1e-3, 1000}; })), "VERIFIED");
  }
  EXPECT_THAT(message(changed(good,
                              [](Document& d) {
                                d.curves[0].length = {5, 1000};
                              })),
              HasSubstr("curve 0 is null-homotopic, or shorter than a length in [5, 1000]"));
  EXPECT_THAT(message(changed(good,
                              [](Document& d) {
                                d.curves[0].length = {1, 2};
                              })),
              HasSubstr("curve 0 has a length in [2.539"));
  // Curve 6 runs twice through the geodesic of curve 4.
  ASSERT_EQ(good.curves[6].power, 2U);
  EXPECT_EQ(both(changed(good, [](Document& d) { d.curves[6].length = d.curves[4].length; })), "REFUTED: lengths");
}

TEST(Curves, NoneIsNullHomotopic) {
  const Document good = octagon();
  const SurfaceSides sides(good.net.surface);
  Word around;  // A vertex of the octagon.
  std::uint32_t s = 0;
  do {
    around.push_back(s);
    s = sides.next_around(s);
  } while (s != 0);
  for (const Word& word : {Word{}, Word{0, sides.partner[0]}, around, joined(around, around)}) {
    EXPECT_EQ(both(changed(good,
                           [&](Document& d) {
                             d.curves[5].word = word;
                             d.curves[5].length = {1e-3, 1000};
                           })),
              "REFUTED: lengths");
  }
}

TEST(Curves, WideBallsDecideNothing) {
  // A word with a detour to somewhere so many sides away, and lengths around the true one and beside it.
  Document document = octagon();
  const auto [vertex, word, length, power, self_intersections, homology] = document.curves[0];
  int open = 0;
  int decided = 0;
  for (std::size_t detour = 1; detour < 40; ++detour) {
    document.curves[0].word = with_far_relator(document.net.surface, 0, word, detour);
    const auto said = [&](Interval claimed) {
      document.curves[0].length = claimed;
      const RuleReport rule = check(document, {.threads = 1, .max_precision = 64}).rules.at(7);
      EXPECT_EQ(rule.rule, "lengths");
      return rule.verdict;
    };
    const Verdict good = said({length.lower - 1e-3, length.upper + 1e-3});
    EXPECT_NE(good, Verdict::refuted) << detour;
    EXPECT_NE(said({length.upper, length.upper + 1e-3}), Verdict::verified) << detour;
    EXPECT_NE(said({length.lower - 1e-3, length.lower}), Verdict::verified) << detour;
    ++(good == Verdict::verified ? decided : open);
  }
  EXPECT_GT(decided, 3);
  EXPECT_GT(open, 3);
}

// Rule powers.

TEST(Curves, PowersAreTheGreatest) {
  const Document good = octagon();
  for (const std::size_t i : {0U, 6U, 7U}) {
    for (const std::uint32_t by : {1U, 2U}) {
      EXPECT_EQ(both(changed(good, [&](Document& d) { d.curves[i].power += by; })), "REFUTED: powers");
    }
  }
  EXPECT_EQ(both(changed(good, [](Document& d) { d.curves[6].power = 1; })), "REFUTED: powers");
  EXPECT_THAT(message(changed(good, [](Document& d) { d.curves[6].power = 1; })),
              HasSubstr("curve 6 is power 2 of a primitive one"));
}

/// A word that ends within a period is no power: 011 011 01. (Its walk is as the word says, as no two letters turn
/// back.)
TEST(Curves, APowerEndsWithItsRoot) {
  Document document = octagon();
  ASSERT_EQ(std::count(document.basis.begin(), document.basis.end(), 5U), 0);
  document.curves[5].word = {0, 1, 1, 0, 1, 1, 0, 1};
  document.curves[5].length = {1e-3, 1000};
  document.curves[5].power = 2;
  EXPECT_EQ(both(document), "REFUTED: powers");
  // The other numbers are those of another curve.
  document.curves[5].power = 1;
  EXPECT_EQ(both(document), "REFUTED: intersections");
}

// Rule intersections.

TEST(Curves, IntersectionsAreCounted) {
  const Document good = octagon();
  for (std::size_t i = 0; i < good.curves.size(); ++i) {
    EXPECT_EQ(both(changed(good, [&](Document& d) { ++d.curves[i].self_intersections; })), "REFUTED: intersections");
  }
  for (std::size_t k = 0; k < good.pairs.size(); k += 3) {
    EXPECT_EQ(both(changed(good, [&](Document& d) { d.pairs[k].intersections += 2; })), "REFUTED: intersections");
    EXPECT_EQ(both(changed(good, [&](Document& d) { d.pairs[k].algebraic += 2; })), "REFUTED: intersections");
    if (good.pairs[k].algebraic == 0) continue;
    EXPECT_EQ(both(changed(good, [&](Document& d) { d.pairs[k].algebraic = -d.pairs[k].algebraic; })),
              "REFUTED: intersections");
  }
}

TEST(Curves, PowersOfOneGeodesic) {
  // Curve 10 crosses itself once; δ and δ⁻² of it.
  Document document = octagon();
  const auto s = static_cast<std::uint64_t>(1);
  ASSERT_EQ(document.curves[4].self_intersections, s);
  ASSERT_EQ(document.curves[6].power, 2U);
  EXPECT_EQ(document.curves[6].self_intersections, 2 * 2 * s + 2 - 1);
  EXPECT_EQ(pair_of(document, 4, 6).intersections, 2 * 2 * s);
  EXPECT_EQ(pair_of(document, 4, 6).algebraic, 0);
  // Curve 9 is curve 3 once more, a simple one.
  EXPECT_EQ(pair_of(document, 3, 9).intersections, 0U);
  EXPECT_EQ(document.curves[7].self_intersections, 3U - 1U);
}

/// The inverse of a curve has the opposite algebraic numbers and class, and else the same.
TEST(Curves, InversesAndConjugates) {
  const Document good = octagon();
  for (std::uint32_t i = 0; i < good.curves.size(); ++i) {
    if (std::count(good.basis.begin(), good.basis.end(), i) > 0) continue;
    Document inverse = good;
    inverse.curves[i].word = reversed(good, good.curves[i].word);
    EXPECT_EQ(both(inverse),
              good.curves[i].homology == std::vector<std::int64_t>(4) ? "VERIFIED" : "REFUTED: intersections");
    for (std::int64_t& coefficient : inverse.curves[i].homology) coefficient = -coefficient;
    for (CurvesDocument::Pair& pair : inverse.pairs) {
      if (pair.first == i || pair.second == i) pair.algebraic = -pair.algebraic;
    }
    EXPECT_EQ(both(inverse), "VERIFIED") << i;
    Document conjugate = good;
    const Word by{1, 6, 6};
    conjugate.curves[i].word = joined(joined(by, good.curves[i].word), reversed(good, by));
    EXPECT_EQ(both(conjugate), "VERIFIED") << i;
  }
}

// Rule homology.

TEST(Curves, ClassesAreThoseOfTheBasis) {
  const Document good = octagon();
  for (std::size_t i = 0; i < good.curves.size(); ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_EQ(both(changed(good, [&](Document& d) { ++d.curves[i].homology[j]; })), "REFUTED: homology");
    }
  }
}

/// Some curves of a document, as a basis and nothing else.
Document basis_alone(const Document& document, const std::vector<std::uint32_t>& curves) {
  Document result{.net = document.net, .curves = {}, .pairs = {}, .basis = {}, .filling = {}};
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    result.curves.push_back(document.curves[curves[i]]);
    result.curves[i].homology.assign(curves.size(), 0);
    result.curves[i].homology[i] = 1;
    result.basis.push_back(i);
    for (std::uint32_t j = i + 1; j < curves.size(); ++j) {
      CurvesDocument::Pair pair = pair_of(document, std::min(curves[i], curves[j]), std::max(curves[i], curves[j]));
      if (curves[i] > curves[j]) pair.algebraic = -pair.algebraic;
      pair.first = i;
      pair.second = j;
      result.pairs.push_back(pair);
    }
  }
  return result;
}

/// A coefficient may have products with one curve of the basis alone, whichever that is.
TEST(Curves, ClassesAreThoseOfASymplecticBasis) {
  const Document good = read("one-fills");
  ASSERT_EQ(both(good), "VERIFIED");
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_EQ(both(changed(good, [&](Document& d) { ++d.curves[0].homology[j]; })), "REFUTED: homology") << j;
  }
}

TEST(Curves, ABasisOfASubgroupIsNone) {
  // All classes are as said, but curve 7 is the third power of curve 5.
  const Document good = octagon();
  std::vector<std::uint32_t> curves = good.basis;
  for (std::uint32_t& curve : curves) {
    const std::uint32_t other = std::exchange(curve, 5);
    if (both(basis_alone(good, curves)) == "VERIFIED") {
      curve = 7;
      EXPECT_EQ(both(basis_alone(good, curves)), "REFUTED: homology");
      return;
    }
    curve = other;
  }
  FAIL() << "curve 5 is in no basis";
}

TEST(Curves, ABasisHasAUnimodularMatrix) {
  const Document good = octagon();
  // Fewer or more curves than 2g.
  EXPECT_EQ(both(changed(good,
                         [](Document& d) {
                           d.basis.clear();
                           for (auto& curve : d.curves) curve.homology.clear();
                         })),
            "REFUTED: homology");
  EXPECT_EQ(both(changed(good,
                         [](Document& d) {
                           d.basis.push_back(0);
                           for (auto& curve : d.curves) curve.homology.push_back(0);
                         })),
            "REFUTED: homology");
  // Curve 7 is the third power of curve 5, so determinants with it are divisible by 9.
  const auto with = [&](std::size_t place, std::uint32_t curve) {
    return message(changed(good, [&](Document& d) { d.basis[place] = curve; }));
  };
  std::size_t found = 0;
  for (std::size_t place = 0; place < 4; ++place) {
    EXPECT_EQ(both(changed(good, [&](Document& d) { d.basis[place] = 7; })), "REFUTED: homology");
    if (with(place, 5).find("determinant") != std::string::npos) continue;
    EXPECT_THAT(with(place, 7), HasSubstr("have the determinant 9"));
    ++found;
  }
  EXPECT_GT(found, 0U);
  // Curve 9 is curve 3 once more.
  ASSERT_EQ(good.basis.back(), 9U);
  EXPECT_THAT(with(0, 3), HasSubstr("determinant 0"));
}

/// Each curve has its own class, whatever the classes are: only the determinant, which is 0, tells that there are
/// others.
TEST(Curves, ABasisIsIndependent) {
  const Document good = octagon();
  // Curve 5 is a combination of curves 1, 2 and 9, and curve 3 is curve 9.
  ASSERT_EQ(good.curves[5].homology, (std::vector<std::int64_t>{1, -1, 0, -1}));
  for (const std::vector<std::uint32_t>& curves : {std::vector<std::uint32_t>{1, 2, 5, 9}, {3, 2, 4, 9}}) {
    EXPECT_EQ(both(basis_alone(good, curves)), "REFUTED: homology");
  }
}

/// The first two curves of a basis may cross so often that its matrix has no minor 1 there: 0, 2; −2, 0.
TEST(Curves, ABasisMayBeginWithCurvesThatCrossTwice) {
  Document document = octagon();
  std::rotate(document.basis.begin(), document.basis.begin() + 2, document.basis.end());
  for (auto& curve : document.curves)
    std::rotate(curve.homology.begin(), curve.homology.begin() + 2, curve.homology.end());
  ASSERT_EQ(pair_of(document, document.basis[0], document.basis[1]).algebraic, 2);
  EXPECT_EQ(both(document), "VERIFIED");
}

/// In another order, and with a curve backwards, it is a basis as well.
TEST(Curves, ABasisMayBeInAnyOrder) {
  Document document = octagon();
  std::swap(document.basis[0], document.basis[2]);
  for (auto& curve : document.curves) std::swap(curve.homology[0], curve.homology[2]);
  EXPECT_EQ(both(document), "VERIFIED");
}

// Rule filling.

/// Of the geodesics of diameters in a regular polygon, all 2g are needed: each is disjoint from a closed curve.
TEST(Curves, DiametersFillTogether) {
  for (const std::uint32_t genus : {2U, 3U}) {
    Document document = diameters(genus);
    document.filling = {document.basis};
    EXPECT_EQ(both(document), "VERIFIED");
    for (std::uint32_t left_out = 0; left_out < 2 * genus; ++left_out) {
      document.filling = {document.basis, document.basis};
      document.filling[1].erase(document.filling[1].begin() + left_out);
      EXPECT_EQ(both(document), "REFUTED: filling");
      EXPECT_THAT(message(document), HasSubstr("set 1 does not fill"));
    }
  }
}

TEST(Curves, PowersAndInversesFillLikeTheirRoots) {
  Document document = read("octagon-5");
  // Curves 6 and 9 run through the geodesics of 4 and 3.
  document.filling = {{1, 3, 4}, {1, 3, 6}, {1, 4, 9}, {1, 3, 4, 6, 9}};
  EXPECT_EQ(both(document), "VERIFIED");
  for (const std::vector<std::uint32_t>& set :
       std::vector<std::vector<std::uint32_t>>{{}, {0}, {4}, {6}, {4, 6}, {3, 9}, {0, 5}, {3, 4}, {3, 6, 9}}) {
    document.filling = {set};
    EXPECT_EQ(both(document), "REFUTED: filling");
  }
}

/// With a set all larger sets fill; a curve that is disjoint from a set that fills is none; and the complement is at
/// least one disk: 2 − 2g = −I + b with b ≥ 1.
TEST(Curves, SetsThatFillMeetAllCurves) {
  Document document = read("octagon-5");
  std::vector<bool> fills;
  for (std::uint32_t bits = 0; bits < 64; ++bits) {
    std::vector<std::uint32_t> set;
    for (std::uint32_t i = 0; i < 6; ++i) {
      if ((bits >> i & 1U) != 0) set.push_back(i);
    }
    document.filling = {set};
    const std::string verdict = both(document);
    EXPECT_THAT(verdict, testing::AnyOf("VERIFIED", "REFUTED: filling"));
    fills.push_back(verdict == "VERIFIED");
    std::uint64_t crossings = 0;
    for (const std::uint32_t i : set) crossings += document.curves[i].self_intersections;
    for (const auto& pair : document.pairs) {
      const auto is_in = [&](std::uint32_t i) { return std::count(set.begin(), set.end(), i) > 0; };
      if (is_in(pair.first) && is_in(pair.second)) crossings += pair.intersections;
    }
    EXPECT_TRUE(!fills[bits] || crossings >= 3) << bits;
    for (std::uint32_t i = 0; i < 6; ++i) {
      EXPECT_TRUE(fills[bits] || (bits >> i & 1U) == 0 || !fills[bits & ~(1U << i)]) << bits;
    }
    for (std::uint32_t i = 0; fills[bits] && i < document.curves.size(); ++i) {
      std::uint64_t common = document.curves[i].self_intersections;
      for (const std::uint32_t j : set) {
        if (i != j) common += pair_of(document, std::min(i, j), std::max(i, j)).intersections;
      }
      EXPECT_GT(common, 0U);
    }
  }
  EXPECT_GT(std::count(fills.begin(), fills.end(), true), 3);
}

/// A geodesic that crosses itself fills alone, if what it cuts off is a disk each time.
TEST(Curves, OneCurveMayFill) {
  Document document = read("one-fills");
  ASSERT_EQ(document.filling, (std::vector<std::vector<std::uint32_t>>{{0}}));
  EXPECT_EQ(both(document), "VERIFIED");
}

// The order of crossing points along geodesics, where balls do not tell it.

Ball ball(double middle, double radius) {
  Ball result = Ball::exactly(middle);
  mag_set_d(arb_radref(result.get()), radius);
  return result;
}

using CrossingPoints = std::vector<std::vector<CrossingPoint>>;

class CrossingsOfCurves : public testing::Test {
 private:
  Precision precision_{128};
};

/// A crossing with geodesic `other`, as its point number `place`.
CrossingPoint crossing(const Ball& along, std::uint32_t other, std::uint32_t place, std::uint32_t chord = 0,
                       int turn = 1) {
  return {along, Ball(), other, place, chord, turn};
}

std::optional<bool> all_fill(const CrossingPoints& points, std::int64_t euler) {
  const NetDocument net = read("octagon-5").net;
  const LiftedNet lifted(net);
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  return fill(lifted.plane(), points, all, euler);
}

TEST_F(CrossingsOfCurves, PointsThatAreNotToldApartAreOneIfAllCrossThere) {
  // Geodesic 0 crosses 1 and 2, which do not cross each other.
  const auto points = [](double radius) -> CrossingPoints {
    return {{crossing(ball(1, radius), 1, 0), crossing(ball(1.25, radius), 2, 0)},
            {crossing(ball(1, 0), 0, 0, 0, -1)},
            {crossing(ball(1, 0), 0, 1, 0, -1)}};
  };
  EXPECT_TRUE(all_fill(points(0.01), -2).has_value());
  EXPECT_EQ(all_fill(points(0.5), -2), std::nullopt);
}

TEST_F(CrossingsOfCurves, AllBallsBeforeAndBehindCount) {
  // Geodesics 0, 1 and 2 cross each other in one point, and 0 crosses 3 elsewhere.
  const auto points = [](const Ball& first, const Ball& second, const Ball& third) -> CrossingPoints {
    return {{crossing(first, 1, 0), crossing(second, 2, 0), crossing(third, 3, 0)},
            {crossing(ball(1, 0), 0, 0, 0, -1), crossing(ball(1, 0), 2, 1)},
            {crossing(ball(1, 0), 0, 1, 0, -1), crossing(ball(1, 0), 1, 1, 0, -1)},
            {crossing(ball(1, 0), 0, 2, 0, -1)}};
  };
  EXPECT_TRUE(all_fill(points(ball(1, 0), ball(1, 0), ball(2, 0)), -2).has_value());
  // One ball is as wide as to contain all, before or behind those that differ.
  EXPECT_EQ(all_fill(points(ball(1.5, 2), ball(2, 0), ball(2.5, 0)), -2), std::nullopt);
  EXPECT_EQ(all_fill(points(ball(2, 0), ball(2.5, 2), ball(1, 0)), -2), std::nullopt);
}

TEST_F(CrossingsOfCurves, ChordsAreInOrderWhateverTheBalls) {
  // Lines of a torus with four common points, in the same order along both; the complement is four disks.
  const auto points = [](const std::array<std::uint32_t, 4>& chords, const std::array<double, 4>& along,
                         double radius) {
    CrossingPoints result(2);
    for (std::uint32_t k = 0; k < 4; ++k) {
      result[0].push_back(crossing(ball(along[k], radius), 1, k, chords[k]));
      result[1].push_back(crossing(ball(k, 0), 0, k, k, -1));
    }
    return result;
  };
  EXPECT_EQ(all_fill(points({0, 1, 2, 3}, {0, 1, 2, 3}, 0), 0), true);
  EXPECT_EQ(all_fill(points({0, 2, 1, 3}, {0, 2, 1, 3}, 0), 0), false);
  EXPECT_EQ(all_fill(points({0, 1, 2, 3}, {0, 2, 1, 3}, 5), 0), true);
}

// Walks in the radial graph, of words alone.

/// A surface, and closed words of it.
class Words {
 public:
  explicit Words(NetDocument net, unsigned seed)
      : document_(std::move(net)),
        sides_(document_.surface),
        net_(exact::read_net(exact::parse_json(text_of(document_)))),
        structure_(std::make_unique<exact::NetStructure>(net_)),
        random_(seed) {}

  [[nodiscard]] exact::RadialGraph graph() const {
    const auto tiles = static_cast<long>(sides_.first.size());
    const auto edges = static_cast<long>(sides_.partner.size() / 2);
    return {*structure_, static_cast<long>(sides_.vertices().size()) - edges + tiles};
  }

  /// A random closed path from tile 0.
  Word closed(std::size_t letters) {
    Word word;
    std::uint32_t tile = 0;
    const auto step = [&] {
      word.push_back(random_side(tile));
      tile = sides_.tile[sides_.partner[word.back()]];
    };
    for (std::size_t k = 0; k < letters; ++k) step();
    while (tile != 0) step();
    return word;
  }

  /// A path that is freely homotopic: with detours, from another letter on.
  Word homotopic(Word word) {
    for (int k = 0; k < 6; ++k) {
      const std::size_t place = random(word.size() + 1);
      const std::uint32_t side = random_side(tile_at(word, place));
      Word detour{side, sides_.partner[side]};
      if (random(2) == 0) {
        detour.clear();  // Around the vertex where the side starts.
        for (std::uint32_t s = side; detour.empty() || s != side; s = sides_.next_around(s)) detour.push_back(s);
        if (random(2) == 0) detour = reversed(document_, detour);
        if (sides_.tile[detour.front()] != tile_at(word, place)) continue;
      }
      word.insert(word.begin() + static_cast<std::ptrdiff_t>(place), detour.begin(), detour.end());
      std::rotate(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(random(word.size())), word.end());
    }
    return word;
  }

  std::size_t random(std::size_t below) { return random_() % below; }
  [[nodiscard]] Word back(const Word& word) const { return reversed(document_, word); }

 private:
  std::uint32_t random_side(std::uint32_t tile) {
    const std::size_t next = tile + 1 < sides_.first.size() ? sides_.first[tile + 1] : sides_.tile.size();
    return sides_.first[tile] + static_cast<std::uint32_t>(random(next - sides_.first[tile]));
  }

  [[nodiscard]] std::uint32_t tile_at(const Word& word, std::size_t place) const {
    if (word.empty()) return 0;
    return place < word.size() ? sides_.tile[word[place]] : sides_.tile[sides_.partner[word.back()]];
  }

  NetDocument document_;
  SurfaceSides sides_;
  exact::Net net_;
  std::unique_ptr<exact::NetStructure> structure_;
  std::mt19937 random_;
};

exact::RadialGraph::Walk least_of(const exact::RadialGraph::Walk& walk) {
  exact::RadialGraph::Walk least = walk;
  exact::RadialGraph::Walk turned = walk;
  for (std::size_t k = 0; k < walk.size(); ++k) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    least = std::min(least, turned);
  }
  return least;
}

std::vector<NetDocument> surfaces() {
  return {read("octagon-5").net, read("klein").net, regular_net(2), regular_net(3)};
}

/// Lemma 51: there is one rightmost walk in a class.
TEST(ClosedWalks, OfOneClassAreTheSame) {
  for (const NetDocument& net : surfaces()) {
    Words words(net, 1);
    std::size_t trivial = 0;
    for (int k = 0; k < 200; ++k) {
      exact::RadialGraph graph = words.graph();
      const Word word = words.closed(1 + words.random(12));
      const auto walk = graph.rightmost(graph.walk(word));
      EXPECT_EQ(least_of(graph.rightmost(graph.walk(words.homotopic(word)))), least_of(walk));
      trivial += walk.empty() ? 1 : 0;
      const Word twice = words.homotopic(joined(word, word));
      const auto double_walk = graph.rightmost(graph.walk(twice));
      EXPECT_EQ(least_of(double_walk), least_of(joined(walk, walk)));
      EXPECT_TRUE(graph.rightmost(graph.walk(words.homotopic(joined(word, words.back(word))))).empty());
    }
    EXPECT_LT(trivial, 100U);
  }
}

/// Closed walks of up to four steps, also those that shorten only around all of the walk: twice a walk is deformed to
/// twice what the walk is deformed to.
TEST(ClosedWalks, TwiceAWalkIsDeformedLikeTheWalk) {
  for (const char* name : {"octagon-5", "klein"}) {
    const Words words(read(name).net, 1);
    exact::RadialGraph graph = words.graph();
    const std::uint32_t edges = name == std::string("klein") ? 12 : 8;
    for (std::uint32_t number = 0; number < edges * edges * edges * edges; ++number) {
      exact::RadialGraph::Walk walk;
      std::uint32_t rest = number;
      for (std::uint32_t k = 0; k < 4; ++k, rest /= edges) walk.push_back(2 * (rest % edges) + k % 2);
      const auto once = graph.rightmost(walk);
      ASSERT_EQ(least_of(graph.rightmost(joined(walk, walk))), least_of(joined(once, once))) << number;
    }
  }
}

/// Whether the closed geodesics of words, primitive ones that differ, fill.
bool geodesics_fill(exact::RadialGraph graph, const std::vector<Word>& words) {
  std::vector<exact::RadialGraph::Walk> walks;
  for (const Word& word : words) walks.push_back(graph.rightmost(graph.walk(word)));
  std::vector<const exact::RadialGraph::Walk*> all;
  std::vector<exact::RadialGraph::Joint> joints;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    all.push_back(&walks[i]);
    for (std::size_t j = i; j < walks.size(); ++j) {
      for (const auto& [step, other] : graph.crossings(walks[i], walks[j], i == j).steps)
        joints.push_back({i, step, j, other});
    }
  }
  return graph.generate(all, joints);
}

/// A side between corners that are one vertex is a closed curve. Geodesics of words without it do not fill. The sides
/// of this octagon are glued in pairs 0 3, 1 5, 2 7 and 4 6, not opposite ones.
TEST(ClosedWalks, ThatDoNotCrossASideDoNotFill) {
  const auto net = read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/g2-small-1-vertex.json");
  const SurfaceSides sides(net.surface);
  ASSERT_EQ(sides.vertices().size(), 1U);
  ASSERT_EQ(sides.partner, (std::vector<std::uint32_t>{3, 5, 7, 0, 6, 1, 4, 2}));
  const Words words(net, 1);
  EXPECT_TRUE(geodesics_fill(words.graph(), {{0}, {1}, {2}, {4}}));
  // Connected, without sides 1 and 5.
  EXPECT_FALSE(geodesics_fill(words.graph(), {{0}, {2}, {7, 4}, {0, 4}}));
}

/// Two loops that cross once are in a torus with a hole. Its simple closed curve of the class (p, q), p, q > 0, is a
/// word of p letters and q others, spread evenly. Two of them cross as often as their classes say, also where they run
/// beside each other farther than once around, one way or the other.
TEST(ClosedWalks, OfATorusCrossAsOftenAsTheirClassesSay) {
  const Words words(regular_net(2), 1);
  struct Simple {
    long p;
    long q;
    exact::RadialGraph::Walk walk;
  };
  std::vector<Simple> curves;
  for (long p = 1; p <= 5; ++p) {
    for (long q = 1; q <= 5; ++q) {
      if (std::gcd(p, q) != 1) continue;
      Word word;
      for (long k = 0; k < p + q; ++k) word.push_back((k + 1) * q / (p + q) > k * q / (p + q) ? 1 : 0);
      exact::RadialGraph graph = words.graph();
      curves.push_back({p, q, graph.rightmost(graph.walk(word))});
      curves.push_back({-p, -q, graph.rightmost(graph.walk(words.back(word)))});
    }
  }
  for (const Simple& x : curves) {
    exact::RadialGraph graph = words.graph();
    for (const Simple& y : curves) {
      const long algebraic = x.p * y.q - x.q * y.p;
      if (algebraic == 0) continue;
      const exact::WalkCrossings found = graph.crossings(x.walk, y.walk, false);
      EXPECT_EQ(found.steps.size(), static_cast<std::size_t>(std::abs(algebraic)))
          << x.p << ' ' << x.q << ", " << y.p << ' ' << y.q;
      EXPECT_EQ(found.signs, algebraic) << x.p << ' ' << x.q << ", " << y.p << ' ' << y.q;
    }
  }
}

/// Random words in a regular polygon: their classes are counts of letters, the algebraic number is bilinear in these,
/// and the other numbers are those of walks, which the first checker finds in the plane.
TEST(Curves, BothCheckersAgreeOnRandomWords) {
  for (const std::uint32_t genus : {2U, 3U}) {
    Words words(regular_net(genus), genus);
    exact::RadialGraph graph = words.graph();
    Document document = diameters(genus);
    struct Root {
      exact::RadialGraph::Walk walk;
      std::uint32_t power;
    };
    std::vector<Root> roots;
    const auto add_root = [&](const Word& word) {
      const auto walk = graph.rightmost(graph.walk(word));
      std::uint32_t power = 1;
      for (std::uint32_t k = 2; k <= walk.size(); ++k) {
        const std::size_t period = walk.size() / k;
        if (walk.size() % k == 0 &&
            std::equal(walk.begin() + static_cast<std::ptrdiff_t>(period), walk.end(), walk.begin()))
          power = k;
      }
      roots.push_back({{walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(walk.size() / power)}, power});
      return !walk.empty();
    };
    for (const auto& curve : document.curves) ASSERT_TRUE(add_root(curve.word));
    while (document.curves.size() < 18) {
      Word word = words.closed(1 + words.random(9));
      if (words.random(4) == 0) word = joined(word, word);
      if (!add_root(word)) {
        roots.pop_back();
        continue;
      }
      CurvesDocument::Curve curve{0, word, {1e-3, 1000}, roots.back().power, 0, {}};
      curve.homology.resize(2 * genus);
      for (const std::uint32_t s : word) curve.homology[s % (2 * genus)] += s < 2 * genus ? 1 : -1;
      document.curves.push_back(curve);
    }
    document.pairs.clear();
    const auto self = [&](const exact::RadialGraph::Walk& walk) {
      return graph.crossings(walk, walk, true).steps.size() / 2;
    };
    for (std::uint32_t i = 0; i < document.curves.size(); ++i) {
      CurvesDocument::Curve& curve = document.curves[i];
      const std::uint64_t k = roots[i].power;
      curve.self_intersections = k * k * self(roots[i].walk) + k - 1;
      for (std::uint32_t j = i + 1; j < document.curves.size(); ++j) {
        const auto back = graph.rightmost(graph.walk(words.back(document.curves[j].word)));
        const auto root_of_back =
            least_of({back.begin(), back.begin() + static_cast<std::ptrdiff_t>(back.size() / roots[j].power)});
        const bool same = least_of(roots[i].walk) == least_of(roots[j].walk) || least_of(roots[i].walk) == root_of_back;
        const std::uint64_t crossings =
            same ? 2 * self(roots[i].walk) : graph.crossings(roots[i].walk, roots[j].walk, false).steps.size();
        std::int64_t algebraic = 0;
        for (std::size_t p = 0; p < 2 * genus; ++p) {
          for (std::size_t q = 0; q < 2 * genus; ++q) {
            const int sign = p == q ? 0 : p < q ? 1 : -1;
            algebraic += sign * curve.homology[p] * document.curves[j].homology[q];
          }
        }
        document.pairs.push_back({i, j, k * roots[j].power * crossings, algebraic});
      }
    }
    EXPECT_EQ(both(document), "VERIFIED");
    std::size_t fill = 0;
    for (std::size_t size = 1; size <= 8; ++size) {
      for (int k = 0; k < 3; ++k) {
        std::set<std::uint32_t> set;
        while (set.size() < size) set.insert(static_cast<std::uint32_t>(words.random(document.curves.size())));
        document.filling = {{set.begin(), set.end()}};
        const std::string verdict = both(document);
        EXPECT_THAT(verdict, testing::AnyOf("VERIFIED", "REFUTED: filling"));
        fill += verdict == "VERIFIED" ? 1 : 0;
      }
    }
    EXPECT_GT(fill, 3U);
    EXPECT_LT(fill, 22U);
  }
}

TEST(ClosedWalks, TooManyStepsAreLeftUndecided) {
  Words words(regular_net(2), 7);
  exact::RadialGraph graph = words.graph();
  const auto long_walk = graph.rightmost(graph.walk(words.closed(20'000)));
  EXPECT_THROW((void)graph.crossings(long_walk, long_walk, true), exact::TooLarge);
}

}  // namespace
}  // namespace epsnet::certify::curves_test
