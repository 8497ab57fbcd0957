#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/claims/isometries/conjugation.h"
#include "certify/claims/isometries/fields.h"
#include "certify/file/file.h"
#include "tests/certify/claim_files.h"

/// Isometries files. Each rule is broken by a file in which nothing else is wrong.
namespace epsnet::certify::isometries_test {
namespace {

using testing::HasSubstr;
using Document = IsometriesDocument;
using Word = Document::Word;

Document read(const std::string& name) {
  return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/isometries/" + name + ".json");
}

/// 96 isometries, of which 48 preserve the orientation.
Document bolza() { return read("bolza"); }
/// The hyperelliptic involution and nothing else.
Document octagon() { return read("octagon-5"); }
/// Nothing but the identity; several tiles.
Document fenchel_nielsen() { return read("fenchel-nielsen-3-1"); }

Certificate checked(const Document& document) { return check(document, {.threads = 2, .max_precision = 256}); }

/// "VERDICT", or "VERDICT: rule".
std::string outcome(const Document& document) {
  const Certificate certificate = checked(document);
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

std::string structure(const Document& document) {
  const Certificate certificate = checked(document);
  EXPECT_EQ(certificate.verdict, Verdict::malformed);
  return certificate.message;
}

/// The isometries that preserve the orientation, of those listed.
Document without_reflections(Document document) {
  std::erase_if(document.isometries, [](const auto& isometry) { return !isometry.preserves_orientation; });
  return document;
}

TEST(Isometries, TrueFilesAreVerified) {
  EXPECT_EQ(outcome(bolza()), "VERIFIED");
  EXPECT_EQ(outcome(octagon()), "VERIFIED");
  EXPECT_EQ(outcome(fenchel_nielsen()), "VERIFIED");
}

TEST(Isometries, TheClaimIsInWords) {
  EXPECT_EQ(checked(bolza()).claim, "the surface has exactly 96 isometries, half of which preserve the orientation");
  EXPECT_EQ(checked(octagon()).claim, "the surface has exactly 2 isometries, all of which preserve the orientation");
}

TEST(Isometries, AnyLiftOfAnIsometryWillDo) {
  Document document = octagon();
  const Word turned = document.pair[0];
  for (Word& image : document.isometries[0].images) {
    image = joined(joined(turned, image), reversed(document, turned));
  }
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Isometries, AnyPathsWillDo) {
  Document document = fenchel_nielsen();
  ASSERT_TRUE(document.isometries.empty());
  for (Word& path : document.paths) path = joined(document.pair[0], path);
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Isometries, OnSeveralTilesElementsAreThoseOfThePaths) {
  // Two tiles with an involution f. Paths that begin with a closed one, w, conjugate all elements by it, and their
  // images by f w f⁻¹.
  Document document = read("fenchel-nielsen-2");
  ASSERT_EQ(document.paths.size(), 2U);
  EXPECT_EQ(outcome(document), "VERIFIED");
  EXPECT_EQ(orbit_size(SurfaceSides(document.net.surface), document, {}), 2U);
  for (Word& path : document.paths) path = joined(document.pair[0], path);
  EXPECT_EQ(outcome(document), "REFUTED: isometries");
  std::vector<Word>& images = document.isometries[0].images;
  for (std::size_t k = 2; k < images.size(); ++k) {
    images[k] = joined(joined(images[0], images[k]), reversed(document, images[0]));
  }
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Isometries, TheIdentityMayBeListed) {
  Document document = octagon();
  Document::Isometry& identity = document.isometries.emplace_back();
  identity.images = document.pair;
  const SurfaceSides sides(document.net.surface);
  for (std::uint32_t s = 0; s < sides.partner.size(); ++s) {
    if (s < sides.partner[s]) identity.images.push_back({s});
  }
  EXPECT_EQ(outcome(document), "VERIFIED");
  identity.preserves_orientation = false;
  EXPECT_EQ(outcome(document), "REFUTED: isometries");
}

// The spectrum.

TEST(Isometries, AGeodesicLeftOutIsMissedByTheRuleOfTheSpectrum) {
  Document document = octagon();
  document.geodesics.pop_back();
  document.clusters.pop_back();
  EXPECT_EQ(outcome(document), "REFUTED: complete");
}

// Rule isometries.

TEST(Isometries, AnImageWithAnotherWordIsRefuted) {
  for (std::size_t k = 0; k < 6; ++k) {
    Document document = octagon();
    Word& image = document.isometries[0].images.at(k);
    image = reversed(document, image);
    // With either orientation: that of a pair whose images are wrong says nothing.
    for (const bool preserves_orientation : {true, false}) {
      document.isometries[0].preserves_orientation = preserves_orientation;
      EXPECT_EQ(outcome(document), "REFUTED: isometries") << k;
    }
  }
}

TEST(Isometries, ThePairIsInAnyOrder) {
  for (const Document& good : {bolza(), octagon()}) {
    Document document = good;
    std::swap(document.pair[0], document.pair[1]);
    for (auto& isometry : document.isometries) std::swap(isometry.images[0], isometry.images[1]);
    EXPECT_EQ(outcome(document), "VERIFIED");
    for (auto& isometry : document.isometries) {
      isometry.preserves_orientation = !isometry.preserves_orientation;
      EXPECT_EQ(outcome(document), "REFUTED: isometries");
      isometry.preserves_orientation = !isometry.preserves_orientation;
    }
  }
}

TEST(Isometries, WithNumbersThatAreTooLargeAreUndecided) {
  const auto power = [](const Word& word) {
    Word result;
    while (result.size() < 300'000) result.insert(result.end(), word.begin(), word.end());
    return result;
  };
  for (const std::size_t k : {0U, 1U, 5U}) {
    Document document = octagon();
    document.isometries[0].images[k] = power(document.isometries[0].images[k]);
    EXPECT_EQ(outcome(document), "UNDECIDED: isometries") << k;
  }
  for (const std::size_t k : {0U, 1U}) {
    Document document = octagon();
    document.pair[k] = power(document.pair[k]);
    EXPECT_EQ(outcome(document), "UNDECIDED: isometries") << k;
  }
}

TEST(Isometries, AnImageThatIsConjugateIsRefuted) {
  // Its trace is the same, that of products is not.
  for (std::size_t k = 0; k < 6; ++k) {
    Document document = octagon();
    Word& image = document.isometries[0].images.at(k);
    const Word other = document.isometries[0].images.at(k < 4 ? 4 : 2);
    image = joined(joined(other, image), reversed(document, other));
    EXPECT_EQ(outcome(document), "REFUTED: isometries") << k;
  }
}

TEST(Isometries, AnOrientationThatIsTheOtherOneIsRefuted) {
  for (std::size_t i = 0; i < bolza().isometries.size(); ++i) {
    Document document = bolza();
    document.isometries[i].preserves_orientation = !document.isometries[i].preserves_orientation;
    EXPECT_EQ(outcome(document), "REFUTED: isometries") << i;
  }
}

TEST(Isometries, APairOfWhichTheAxesDoNotCrossIsRefuted) {
  Document document = octagon();
  document.pair[1] = document.pair[0];
  const Certificate certificate = checked(document);
  EXPECT_EQ(certificate.verdict, Verdict::refuted);
  EXPECT_THAT(certificate.message, HasSubstr("do not cross"));
}

// Rule least.

TEST(Isometries, TooFewGeneratorsAreUndecided) { EXPECT_EQ(outcome(without_reflections(bolza())), "UNDECIDED: least"); }

TEST(Isometries, MoreThanTheOrderIsRefuted) {
  Document document = bolza();
  document.order = 95;
  EXPECT_EQ(outcome(document), "REFUTED: least");
}

TEST(Isometries, ACocycleThatTellsNothingApartIsUndecided) {
  Document document = octagon();
  std::fill(document.cocycle.begin(), document.cocycle.end(), 0);
  EXPECT_EQ(outcome(document), "UNDECIDED: least");
}

TEST(Isometries, AnyCocycleOfTheClassWillDo) {
  // Two that differ by what a path changes of a function of the tiles have the same sums along closed paths.
  Document document = read("fenchel-nielsen-2");
  const SurfaceSides sides(document.net.surface);
  ASSERT_EQ(sides.first.size(), 2U);
  std::size_t k = 0;
  for (std::uint32_t s = 0; s < sides.partner.size(); ++s) {
    if (s > sides.partner[s]) continue;
    document.cocycle[k++] += 12345 * (sides.tile[s] - sides.tile[sides.partner[s]]);
  }
  EXPECT_EQ(orbit_size(sides, document, {}), 2U);
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Isometries, OfASumModulo2To32AreToldApart) {
  Document document = octagon();
  EXPECT_EQ(orbit_size(SurfaceSides(document.net.surface), document, {}), 2U);
  // The involution takes every class to its opposite, and 2³¹ is its own one.
  for (std::uint32_t& value : document.cocycle) value = std::uint32_t{1} << 31;
  EXPECT_EQ(orbit_size(SurfaceSides(document.net.surface), document, {}), 1U);
}

// Rule most.

TEST(Isometries, AGroupWithoutItsReflectionsIsUndecided) {
  Document document = without_reflections(bolza());
  document.order = static_cast<std::uint32_t>(orbit_size(SurfaceSides(document.net.surface), document, {}));
  ASSERT_GE(document.order, 2U);
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
}

TEST(Isometries, WithoutTheInvolutionTheGroupIsUndecided) {
  Document document = octagon();
  document.isometries.clear();
  document.order = 1;
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
}

/// What is said of a file in which nothing but the identity is left.
std::string message_of_the_identity(Document document) {
  document.isometries.clear();
  document.order = 1;
  const Certificate certificate = check(document, {.threads = 2, .max_precision = 128});
  EXPECT_EQ(certificate.rule, "most");
  return certificate.message;
}

TEST(Isometries, AreFollowedWhereOneGeodesicLooksTheSame) {
  // On the chiral surface T11.2 of Conder's list, what is seen along one geodesic has twice as many symmetries.
  EXPECT_EQ(outcome(read("chiral-11")), "VERIFIED");
  EXPECT_EQ(outcome(read("cover-of-bolza")), "VERIFIED");
  Document document = read("chiral-11");
  document.isometries.pop_back();
  document.order = static_cast<std::uint32_t>(orbit_size(SurfaceSides(document.net.surface), document, {}));
  ASSERT_LT(document.order, 160U);
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
}

TEST(Isometries, AreNotLostWhereTheyAreFollowed) {
  // All are followed to all geodesics, as there are too many of them.
  EXPECT_EQ(message_of_the_identity(read("chiral-11")), "there are at most 160, with 128 bits");
  EXPECT_EQ(message_of_the_identity(read("cover-of-bolza")), "there are at most 2, with 128 bits");
  EXPECT_EQ(message_of_the_identity(bolza()), "there are at most 96, with 128 bits");
  EXPECT_EQ(message_of_the_identity(octagon()), "there are at most 2, with 128 bits");
}

TEST(Isometries, LessThanTheOrderIsRefuted) {
  Document document = bolza();
  document.order = 192;
  EXPECT_EQ(outcome(document), "REFUTED: most");
}

TEST(Isometries, GeodesicsOfWhichNoTwoCrossDecideNothing) {
  Document document = octagon();
  document.geodesics.resize(1);
  document.clusters.resize(1);
  document.up_to = std::to_string(document.geodesics[0].length.upper + 1e-5);
  ASSERT_TRUE(document.geodesics[0].simple);
  const Certificate certificate = checked(document);
  EXPECT_EQ(certificate.rule, "most");
  EXPECT_THAT(certificate.message, HasSubstr("no two of the geodesics cross"));
}

TEST(Isometries, GeodesicsAreAskedAsLongAsThereIsWork) {
  // None of them tells that there is nothing but the identity: all are asked, with more and more bits.
  Document document = octagon();
  document.isometries.clear();
  document.order = 1;
  const auto message_with = [&](std::uint64_t work) {
    const Certificate certificate = check(document, {.threads = 2, .max_precision = 256, .max_work = work});
    EXPECT_EQ(certificate.verdict, Verdict::undecided);
    return certificate.message;
  };
  const std::uint64_t all = checked(document).counts.work;
  EXPECT_EQ(message_with(all), "there are at most 2, with 256 bits");
  // One for each length is asked, at one of its crossing points.
  const std::string asked = " of " + std::to_string(document.clusters.size()) + " geodesics; ";
  std::size_t within = 0;
  for (std::uint64_t part = 1; part < 50; ++part) {
    const std::string message = message_with(all * part / 50);
    EXPECT_THAT(message, HasSubstr("needs more work than a file of this size may take"));
    if (message.find(asked) != std::string::npos) ++within;
  }
  EXPECT_GT(within, 0U);
}

// Structure.

TEST(Isometries, WhatIsMalformedIsNamed) {
  Document document = octagon();
  document.order = 0;
  EXPECT_THAT(structure(document), HasSubstr("order: 0"));

  document = fenchel_nielsen();
  document.paths.pop_back();
  EXPECT_THAT(structure(document), HasSubstr("paths: "));

  for (std::size_t t = 0; t < fenchel_nielsen().paths.size(); ++t) {
    document = fenchel_nielsen();
    document.paths[t].push_back(1'000'000);
    EXPECT_THAT(structure(document), HasSubstr("paths[" + std::to_string(t) + "]: "));
  }

  document = fenchel_nielsen();
  std::swap(document.paths[1], document.paths[2]);
  EXPECT_THAT(structure(document), HasSubstr("paths[1]: the word ends in tile 2"));

  document = octagon();
  document.pair.pop_back();
  EXPECT_THAT(structure(document), HasSubstr("pair: 1 words, expected 2"));

  document = fenchel_nielsen();
  document.pair[1].pop_back();
  EXPECT_THAT(structure(document), HasSubstr("pair: word 1: the word ends in tile"));

  document = octagon();
  document.isometries[0].images.pop_back();
  EXPECT_THAT(structure(document), HasSubstr("isometries[0]: 5 words, expected 6"));

  document = octagon();
  document.isometries[0].images[2] = {8};
  EXPECT_THAT(structure(document), HasSubstr("isometries[0]: word 2: "));

  document = octagon();
  document.cocycle.push_back(0);
  EXPECT_THAT(structure(document), HasSubstr("cocycle: 5 numbers, expected one for each pair of sides, 4"));

  document = octagon();
  document.cocycle.pop_back();
  EXPECT_THAT(structure(document), HasSubstr("cocycle: 3 numbers, expected one for each pair of sides, 4"));

  document = octagon();
  document.claim = GeodesicsDocument::Claim::thick_thin;
  EXPECT_THAT(structure(document), HasSubstr("claim: expected a spectrum"));
}

TEST(Isometries, ACocycleHasTheSum0AroundEachVertex) {
  const SurfaceSides sides(fenchel_nielsen().net.surface);
  std::size_t k = 0;
  std::size_t edges = 0;
  for (std::uint32_t s = 0; s < sides.partner.size(); ++s) {
    if (s > sides.partner[s]) continue;
    Document document = fenchel_nielsen();
    ++document.cocycle[k++];
    // What a loop at a vertex adds it takes away.
    if (vertex_of(sides, s) == vertex_of(sides, sides.partner[s])) continue;
    ++edges;
    EXPECT_THAT(structure(document), HasSubstr("cocycle: the sum around the vertex"));
  }
  EXPECT_GT(edges, 0U);
}

// Conjugation.

Crossings regular_crossings() { return RegularCrossings({8, 8}, {4, 5, 6, 7, 0, 1, 2, 3}); }

TEST(Conjugation, OfARegularOctagonRotationsAndReflectionsAreFound) {
  const Crossings crossings = regular_crossings();
  std::vector<ElementPair> rotation;
  std::vector<ElementPair> reflection;
  for (std::uint32_t s = 0; s < 4; ++s) {
    rotation.push_back({{s}, {s + 1}});
    reflection.push_back({{s}, {(8 - s) % 8}});
  }
  EXPECT_EQ(are_conjugate(crossings, rotation, {}), true);
  EXPECT_EQ(are_conjugate(crossings, reflection, {}), true);
  const auto sign = [&](std::uint32_t x, std::uint32_t y) {
    return crossing_sign(crossings, std::vector{x}, std::vector{y}, {});
  };
  const int first = sign(0, 1).value();
  EXPECT_NE(first, 0);
  EXPECT_EQ(sign(1, 2), first);
  EXPECT_EQ(sign(1, 0), -first);
  EXPECT_EQ(sign(0, 7), -first);
  EXPECT_EQ(sign(0, 5), -first);
  EXPECT_EQ(sign(4, 5), first);
  EXPECT_EQ(sign(0, 0), 0);
  EXPECT_EQ(sign(0, 4), 0);
}

TEST(Conjugation, WhereOneSignOfATraceDiffersThereIsNone) {
  const Crossings crossings = regular_crossings();
  // Axes that cross at the centre at the angles π/4 and 3π/4.
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {{1}, {1}}}, {}), true);
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {{1}, {5}}}, {}), false);
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {{1}, {1}}, {{2}, {6}}}, {}), false);
}

TEST(Conjugation, TheTraceOfAnElementItselfCounts) {
  const Crossings crossings = regular_crossings();
  // A commutator of two elements has the traces of the identity with each of them and with their product, but for one
  // sign.
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {{1}, {1}}, {{}, {4, 1, 0, 5}}}, {}), false);
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {{1}, {1}}, {{4, 1, 0, 5}, {}}}, {}), false);
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {{1}, {1}}, {{2, 5}, {4, 2, 0, 5}}}, {}),
            false);
}

TEST(Conjugation, ThePairKeepsTheSignsOfItsTraces) {
  const Crossings crossings = regular_crossings();
  // All lengths of the images of x, y and xy are those of x, y and xy, but the axes of the images do not cross: the
  // trace of their product is negative.
  for (const auto& [other, image] : {std::pair{Word{2}, Word{1, 7, 4}}, {Word{3}, Word{2, 5}}}) {
    EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {other, other}}, {}), true);
    EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {other, image}}, {}), false);
    EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {0}}, {image, other}}, {}), false);
    EXPECT_EQ(crossing_sign(crossings, std::vector{0U}, image, {}), 0);
  }
}

/// A word of a regular octagon with opposite sides glued, in binary64.
std::array<std::complex<double>, 2> value_of(const Word& word) {
  const double cosh = 1 / std::tan(M_PI / 8);
  std::complex<double> a = 1;
  std::complex<double> b = 0;
  for (const std::uint32_t s : word) {
    const std::complex<double> c = -std::sqrt(cosh * cosh - 1) * std::polar(1.0, M_PI * s / 4);
    // The crossing after what was before.
    const std::complex<double> next_a = cosh * a + c * std::conj(b);
    b = cosh * b + c * std::conj(a);
    a = next_a;
  }
  if (a.real() < 0) return {-a, -b};
  return {a, b};
}

/// 1 or −1 if the axes of two elements cross, by the ends of the second one on either side of the first; 0 if not.
int side_of_crossing(const std::array<std::complex<double>, 2>& f, const std::array<std::complex<double>, 2>& g) {
  // The fixed points, to which and from which an element with Re a > 0 translates.
  const auto ends = [](const auto& h) {
    const auto [a, b] = h;
    const double root = std::sqrt(std::norm(b) - a.imag() * a.imag());
    const std::complex<double> i(0, a.imag());
    return std::pair{(i + root) / std::conj(b), (i - root) / std::conj(b)};
  };
  const auto [to, from] = ends(f);
  const auto side = [&, to = to, from = from](std::complex<double> z) {
    return (std::conj(to - from) * (z - from)).imag();
  };
  const auto [left, right] = ends(g);
  const double x = side(left);
  const double y = side(right);
  if (std::abs(x) < 1e-9 || std::abs(y) < 1e-9 || (x > 0) == (y > 0)) return 0;
  return x > 0 ? 1 : -1;
}

TEST(Conjugation, AxesCrossIfTheEndsOfOneAreOnBothSidesOfTheOther) {
  const Crossings crossings = regular_crossings();
  const auto sign = [&](const Word& x, const Word& y) { return crossing_sign(crossings, x, y, {}).value(); };
  const int first = sign({0}, {1}) * side_of_crossing(value_of({0}), value_of({1}));
  ASSERT_NE(first, 0);
  std::uint32_t random = 1;
  const auto any_word = [&] {
    Word word;
    while (word.size() < 1 + random % 5) {
      random = 1664525 * random + 1013904223;
      const std::uint32_t s = random >> 29;
      if (word.empty() || word.back() != (s + 4) % 8) word.push_back(s);
    }
    return word;
  };
  std::array<int, 3> count{};
  for (int i = 0; i < 400; ++i) {
    const Word x = any_word();
    const Word y = any_word();
    const int expected = first * side_of_crossing(value_of(x), value_of(y));
    EXPECT_EQ(sign(x, y), expected) << i;
    ++count.at(static_cast<std::size_t>(1 + expected));
  }
  EXPECT_GT(*std::min_element(count.begin(), count.end()), 20);
}

TEST(Conjugation, EachOfTheTracesOfThePairCounts) {
  const Crossings crossings = regular_crossings();
  const auto inverse = [](Word word) {
    std::reverse(word.begin(), word.end());
    for (std::uint32_t& s : word) s = (s + 4) % 8;
    return word;
  };
  // The product is a conjugate of that of x and y, and one of the two is left as it is.
  const Word x{0};
  const Word y{1};
  const auto has_other_trace = [](const Word& word, const Word& other) {
    return std::abs(value_of(word)[0].real() - value_of(other)[0].real()) > 1e-6;
  };
  int count = 0;
  for (std::uint32_t s = 0; s < 64; ++s) {
    const Word by{s / 8, s % 8};
    const Word product = joined(joined(by, joined(x, y)), inverse(by));
    const Word other_x = joined(product, inverse(y));
    const Word other_y = joined(inverse(x), product);
    if (!has_other_trace(x, other_x) || !has_other_trace(y, other_y)) continue;
    ++count;
    EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{x, other_x}, {y, y}}, {}), false) << s;
    EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{x, x}, {y, other_y}}, {}), false) << s;
  }
  EXPECT_GT(count, 20);
}

double trace_of_product(const std::array<std::complex<double>, 2>& f, const std::array<std::complex<double>, 2>& g) {
  return (f[0] * g[0] + f[1] * std::conj(g[1])).real();
}

TEST(Conjugation, ComparesTheTracesOfFourProductsWithOneSign) {
  // Of all pairs of short words, those that have three of the four traces in common or all of them up to signs.
  const Crossings crossings = regular_crossings();
  std::vector<Word> words{{}};
  for (std::size_t i = 0; words.size() < 1 + 8 + 56 + 392; ++i) {
    for (std::uint32_t s = 0; s < 8; ++s) {
      if (words[i].empty() || words[i].back() != (s + 4) % 8) words.push_back(joined(words[i], {s}));
    }
  }
  int same = 0;
  int different = 0;
  for (const auto& [x, y] : {std::pair{Word{0}, Word{1}}, {Word{0}, Word{2}}, {Word{0}, Word{0, 5}}}) {
    const auto fx = value_of(x);
    const auto fy = value_of(y);
    const std::array<std::complex<double>, 2> fxy{fx[0] * fy[0] + fx[1] * std::conj(fy[1]),
                                                  fx[0] * fy[1] + fx[1] * std::conj(fy[0])};
    std::vector<std::array<double, 4>> traces;
    for (const Word& word : words) {
      const auto g = value_of(word);
      traces.push_back({g[0].real(), trace_of_product(fx, g), trace_of_product(fy, g), trace_of_product(fxy, g)});
    }
    for (std::size_t i = 9; i < words.size(); i += 7) {
      for (std::size_t j = 9; j < words.size(); ++j) {
        int up_to_sign = 0;
        bool plus = true;
        bool minus = true;
        for (std::size_t k = 0; k < 4; ++k) {
          const double u = traces[i].at(k);
          const double v = traces[j].at(k);
          if (std::abs(std::abs(u) - std::abs(v)) < 1e-6 * std::abs(u) + 1e-9) ++up_to_sign;
          plus = plus && std::abs(u - v) < 1e-6 * std::abs(u) + 1e-9;
          minus = minus && std::abs(u + v) < 1e-6 * std::abs(u) + 1e-9;
        }
        if (up_to_sign < 3) continue;
        ++(plus || minus ? same : different);
        EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{x, x}, {y, y}, {words[i], words[j]}}, {}),
                  plus || minus)
            << i << ", " << j;
      }
    }
  }
  EXPECT_GT(same, 50);
  EXPECT_GT(different, 50);
}

TEST(Conjugation, OfTheIdentityIsTheIdentity) {
  const Crossings crossings = regular_crossings();
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {1}}, {{1}, {2}}, {{}, {3, 7}}}, {}), true);
  EXPECT_EQ(are_conjugate(crossings, std::vector<ElementPair>{{{0}, {1}}, {{1}, {2}}, {{}, {3}}}, {}), false);
}

}  // namespace
}  // namespace epsnet::certify::isometries_test
