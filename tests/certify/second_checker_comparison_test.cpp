#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/claims/comparison/fields.h"
#include "certify/claims/isometries/conjugation.h"
#include "certify/exact/algebraic.h"
#include "certify/exact/checker.h"
#include "certify/exact/document.h"
#include "certify/exact/isometry_rules.h"
#include "certify/exact/json.h"
#include "certify/exact/net_rules.h"
#include "certify/exact/number_field.h"
#include "certify/file/file.h"
#include "tests/certify/biquadratic.h"
#include "tests/certify/claim_files.h"

/// Comparison files, asked of both checkers. Each rule is broken by a file in which nothing else is wrong.
namespace epsnet::certify::comparison_test {
namespace {

using Document = ComparisonDocument;
using Word = Document::Word;

Document read(const std::string& name) {
  return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/comparisons/" + name + ".json");
}

/// Bolza's surface as a regular octagon, and as a map of type {8, 3}: numbers of two rings of roots of unity.
Document bolza() { return read("bolza-octagons-8-3"); }
/// Rational tiles: an octagon and its mirror image.
Document mirror_image() { return read("mirror-image"); }
/// Two octagons, with their closed geodesics up to 4.
Document octagons() { return read("octagons"); }
/// Isospectral covers.
Document sunada() { return read("sunada"); }

/// "VERDICT", or "VERDICT: rule", of both checkers; both, if they differ.
std::string both(const Document& document) {
  constexpr std::array<const char*, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  std::ostringstream out;
  write_file(document, out);
  const exact::Result result = exact::check(out.str());
  std::string second = kNames.at(static_cast<std::size_t>(result.verdict));
  if (!result.rule.empty()) second += ": " + result.rule;
  std::string first = outcome(document);
  if (first == "MALFORMED: structure") first = "MALFORMED";
  return first == second ? first : first + "; " + second;
}

/// The element, seen from elsewhere.
Word conjugate(const Document& document, const Word& word, const Word& by) {
  return joined(joined(by, word), reversed(document.other.net, by));
}

/// The claim that a surface is not isometric to itself.
Document against_itself(const GeodesicsDocument& spectrum) {
  Document document;
  document.relation = Document::Relation::different;
  static_cast<GeodesicsDocument&>(document) = spectrum;
  document.other = spectrum;
  return document;
}

/// The closed geodesics of a list that are not longer.
GeodesicsDocument shortened(GeodesicsDocument spectrum, const std::string& up_to) {
  std::erase_if(spectrum.geodesics, [&](const auto& geodesic) { return geodesic.length.lower > std::stod(up_to); });
  spectrum.up_to = up_to;
  return in_order(std::move(spectrum));
}

/// The list with intervals that are longer by 0.01 at each end.
GeodesicsDocument widened(GeodesicsDocument spectrum) {
  for (auto& geodesic : spectrum.geodesics)
    geodesic.length = {geodesic.length.lower - 0.01, geodesic.length.upper + 0.01};
  return in_order(std::move(spectrum));
}

TEST(SecondCheckerOfComparisons, TrueFilesAreVerified) {
  for (const char* name : {"bolza-octagons-8-3", "bolza-over-a-field", "mirror-image", "wollmilchsau",
                           "cover-of-an-octagon", "octagons", "genera", "sunada"}) {
    EXPECT_EQ(both(read(name)), "VERIFIED") << name;
  }
}

TEST(SecondCheckerOfComparisons, TheClaimIsInWords) {
  EXPECT_EQ(checked(mirror_image()).claim, "the two surfaces are isometric");
  EXPECT_EQ(checked(octagons()).claim, "the two surfaces are not isometric");
}

// Isometric.

TEST(SecondCheckerOfComparisons, AnyLiftAndAnyPathsWillDo) {
  for (Document document : {bolza(), mirror_image(), read("bolza-over-a-field")}) {
    const Word turned = document.isometry.images[0];
    for (Word& image : document.isometry.images) image = conjugate(document, image, turned);
    EXPECT_EQ(both(document), "VERIFIED");
  }
  // Paths that begin with x conjugate the generators by x, and their images by that of x.
  Document document = read("wollmilchsau");
  ASSERT_GT(document.isometry.paths.size(), 1U);
  for (Word& path : document.isometry.paths) path = joined(document.isometry.pair[0], path);
  EXPECT_EQ(both(document), "REFUTED: isometric");
  for (std::size_t k = 2; k < document.isometry.images.size(); ++k) {
    document.isometry.images[k] = conjugate(document, document.isometry.images[k], document.isometry.images[0]);
  }
  EXPECT_EQ(both(document), "VERIFIED");
}

TEST(SecondCheckerOfComparisons, AnImageOfEachElementIsExamined) {
  for (const Document& good : {bolza(), mirror_image(), read("bolza-over-a-field")}) {
    for (std::size_t k = 0; k < good.isometry.images.size(); ++k) {
      Document document = good;
      Word& image = document.isometry.images[k];
      // The same trace, but other traces of products.
      image = reversed(good.other.net, image);
      EXPECT_EQ(both(document), "REFUTED: isometric") << k;
      document = good;
      const auto other = std::find_if(good.isometry.images.begin(), good.isometry.images.end(), [&](const Word& word) {
        return word != good.isometry.images[k] && word != reversed(good.other.net, good.isometry.images[k]);
      });
      ASSERT_NE(other, good.isometry.images.end());
      document.isometry.images[k] = conjugate(good, good.isometry.images[k], *other);
      EXPECT_EQ(both(document), "REFUTED: isometric") << k;
    }
  }
}

TEST(SecondCheckerOfComparisons, TheIdentityIsNoImage) {
  Document document = mirror_image();
  document.isometry.images.back().clear();
  EXPECT_EQ(both(document), "REFUTED: isometric");
}

TEST(SecondCheckerOfComparisons, TheOrientationIsThatOfTheFile) {
  for (Document document : {bolza(), mirror_image(), read("bolza-over-a-field"), read("wollmilchsau")}) {
    document.isometry.preserves_orientation = !document.isometry.preserves_orientation;
    EXPECT_EQ(both(document), "REFUTED: isometric");
  }
}

TEST(SecondCheckerOfComparisons, ThePairIsInAnyOrder) {
  for (Document document : {bolza(), mirror_image()}) {
    std::swap(document.isometry.pair[0], document.isometry.pair[1]);
    std::swap(document.isometry.images[0], document.isometry.images[1]);
    EXPECT_EQ(both(document), "VERIFIED");
    document.isometry.preserves_orientation = !document.isometry.preserves_orientation;
    EXPECT_EQ(both(document), "REFUTED: isometric");
  }
}

TEST(SecondCheckerOfComparisons, NumbersThatAreTooLargeAreNotCompared) {
  const auto power = [](const Word& word) {
    Word result;
    while (result.size() < 300'000) result.insert(result.end(), word.begin(), word.end());
    return result;
  };
  const Document good = mirror_image();
  for (std::size_t k = 0; k < good.isometry.images.size(); ++k) {
    Document document = good;
    document.isometry.images[k] = power(document.isometry.images[k]);
    EXPECT_EQ(outcome(document), "UNDECIDED: isometric") << k;
    if (k < 2) document.isometry.pair[k] = power(document.isometry.pair[k]);
    EXPECT_EQ(outcome(document), "UNDECIDED: isometric") << k;
  }
}

TEST(SecondCheckerOfComparisons, TheAxesOfThePairCross) {
  Document document = mirror_image();
  document.isometry.pair[1] = document.isometry.pair[0];
  document.isometry.images[1] = document.isometry.images[0];
  for (const bool preserves_orientation : {true, false}) {
    document.isometry.preserves_orientation = preserves_orientation;
    EXPECT_EQ(both(document), "REFUTED: isometric");
  }
}

TEST(SecondCheckerOfComparisons, AnotherSurfaceHasOtherTraces) {
  Document document = mirror_image();
  document.other.net = octagons().other.net;
  EXPECT_EQ(both(document), "REFUTED: isometric");
}

TEST(SecondCheckerOfComparisons, ACoveringOfTwoSheetsIsNoIsometry) {
  // The identity of the plane takes the group of the cover into that of the octagon, whose sides have the numbers
  // modulo 8 of those of the two tiles above.
  Document document = read("cover-of-an-octagon");
  document.other.net = mirror_image().net;
  const SurfaceSides sides(document.net.surface);
  std::vector<Word> words = document.isometry.pair;
  for (const Word& word : generator_words(sides, document.isometry.paths, {})) words.push_back(word);
  for (Word& word : words) {
    for (std::uint32_t& s : word) s %= 8;
  }
  document.isometry.images = words;
  document.isometry.preserves_orientation = true;
  EXPECT_EQ(both(document), "REFUTED: isometric");
  EXPECT_EQ(checked(document).message, "the genera are 3 and 2");
}

TEST(SecondCheckerOfComparisons, TheOtherNetIsExamined) {
  Document document = mirror_image();
  document.other.net.epsilon = "0.5";
  EXPECT_EQ(both(document), "REFUTED: other");
  document = mirror_image();
  document.net.epsilon = "0.5";
  EXPECT_EQ(both(document), "REFUTED: covering");
}

TEST(SecondCheckerOfComparisons, TheOtherNetIsVerifiedAndNotOnlyNotRefuted) {
  // Epsilon is the shortest edge of the other net to 2600 digits: neither checker knows which of the two is more.
  const Document genera = read("genera");
  Document document = genera;
  static_cast<GeodesicsDocument&>(document) = genera.other;
  document.other = static_cast<const GeodesicsDocument&>(genera);
  EXPECT_EQ(both(document), "VERIFIED");
  document.other.net = read_file<NetDocument>(
      EPSNET_TEST_DATA "/certify/undecided/packing-epsilon-is-the-edge-length-to-2600-digits.json");
  EXPECT_EQ(both(document), "UNDECIDED: other");
}

TEST(DeepSecondCheckerOfComparisons, LettersOfBothListsHaveALimitInAll) {
  for (const std::size_t labels : {4U, 6U}) {
    Document document = octagons();
    for (NetDocument* net : {&document.net, &document.other.net}) {
      Word million;  // There and back.
      while (million.size() < 1'000'000) {
        million.push_back(0);
        million.push_back(reversed(*net, {0})[0]);
      }
      for (std::size_t i = 0; i < labels; ++i) net->labels.push_back({0, 0, million});
    }
    std::ostringstream out;
    write_file(document, out);
    const auto read_by_first = [&] { static_cast<void>(parse_file<ClaimDocument>(out.str(), "it")); };
    if (2 * labels < 10) {
      EXPECT_NO_THROW(read_by_first());
      EXPECT_EQ(exact::check(out.str()).verdict, exact::Verdict::verified);
    } else {
      EXPECT_THROW(read_by_first(), MalformedError);
      EXPECT_EQ(exact::check(out.str()).verdict, exact::Verdict::malformed);
    }
  }
}

TEST(SecondCheckerOfComparisons, WordsLeadWhereTheyShould) {
  const Document good = read("wollmilchsau");
  Document document = good;
  document.isometry.images.pop_back();
  EXPECT_EQ(both(document), "MALFORMED");
  document = good;
  document.isometry.images.push_back({});
  EXPECT_EQ(both(document), "MALFORMED");
  document = good;
  document.isometry.paths.pop_back();
  EXPECT_EQ(both(document), "MALFORMED");
  document = good;
  document.isometry.pair.push_back({});
  EXPECT_EQ(both(document), "MALFORMED");
  document = good;
  ASSERT_FALSE(document.isometry.paths[1].empty());
  document.isometry.paths[1].clear();
  EXPECT_EQ(both(document), "MALFORMED");
  document = good;
  document.isometry.pair[0].pop_back();
  EXPECT_EQ(both(document), "MALFORMED");
  document = good;
  document.isometry.images[3].push_back(1'000'000);
  EXPECT_EQ(both(document), "MALFORMED");
  document = good;
  document.other.net.collars.emplace();
  EXPECT_EQ(both(document), "MALFORMED");
}

TEST(SecondCheckerOfComparisons, LongPathsOfManyGeneratorsAreNotWrittenOut) {
  const Document document = mirror_image();
  const std::vector<Word> path{Word(6'000'000, 0)};
  EXPECT_THROW((void)generator_words(SurfaceSides(document.net.surface), path, Budget(1'000'000)), BudgetSpent);
  std::ostringstream out;
  write_file(document.net, out);
  const exact::Net net = exact::read_net(exact::parse_json(out.str()));
  EXPECT_THROW((void)exact::NetStructure(net).generators(path), exact::TooLarge);
}

// Different.

TEST(SecondCheckerOfComparisons, ASurfaceIsNotDifferentFromItself) {
  EXPECT_EQ(both(against_itself(octagons())), "UNDECIDED: different");
  EXPECT_EQ(both(against_itself(sunada())), "UNDECIDED: different");
  EXPECT_EQ(both(against_itself(sunada().other)), "UNDECIDED: different");
  // The only isometry of this one is the identity.
  auto alone = read_file<IsometriesDocument>(std::string(EPSNET_TEST_DATA) + "/isometries/fenchel-nielsen-3-1.json");
  EXPECT_EQ(both(against_itself(alone)), "UNDECIDED: different");
}

TEST(SecondCheckerOfComparisons, ASurfaceIsNotDifferentWithAnotherMarking) {
  // An octagon after a Dehn twist, and before: the pair of loops that is found first has images in the other order.
  EXPECT_EQ(both(read("dehn-twisted-different")), "UNDECIDED: different");
}

TEST(SecondCheckerOfComparisons, OnlyLengthsThatBothListsCoverAreCompared) {
  Document document = against_itself(octagons());
  document.other = shortened(document.other, "3");
  ASSERT_LT(document.other.geodesics.size(), document.geodesics.size());
  EXPECT_EQ(both(document), "UNDECIDED: different");
  document.other = octagons();
  static_cast<GeodesicsDocument&>(document) = shortened(document.other, "3");
  EXPECT_EQ(both(document), "UNDECIDED: different");
}

TEST(SecondCheckerOfComparisons, LengthsAreAnywhereInTheirIntervals) {
  Document document = against_itself(octagons());
  document.other = widened(document.other);
  EXPECT_EQ(both(document), "UNDECIDED: different");
  document = against_itself(octagons());
  static_cast<GeodesicsDocument&>(document) = widened(document);
  EXPECT_EQ(both(document), "UNDECIDED: different");
  // The last one, as it is known so badly that it comes first.
  document = against_itself(octagons());
  document.geodesics.back().length.lower = 0.1;
  static_cast<GeodesicsDocument&>(document) = in_order(document);
  EXPECT_EQ(both(document), "UNDECIDED: different");
}

TEST(SecondCheckerOfComparisons, EitherSurfaceMayHaveMoreClosedGeodesics) {
  const Document good = octagons();
  Document document = against_itself(good.other);
  document.other = good;
  EXPECT_EQ(both(document), "VERIFIED");
  // With lists so short that they end where they begin to differ, only one of them has more.
  const auto first = shortened(good, "2.9");
  const auto other = shortened(good.other, "2.9");
  ASSERT_NE(first.geodesics.size(), other.geodesics.size());
  document = against_itself(first);
  document.other = other;
  EXPECT_EQ(both(document), "VERIFIED");
  document = against_itself(other);
  document.other = first;
  EXPECT_EQ(both(document), "VERIFIED");
}

TEST(SecondCheckerOfComparisons, AListThatEndsEarlierMayHaveFewer) {
  // The systole of the other surface is shorter than 2, that of the first one is not.
  Document document = against_itself(shortened(octagons(), "2"));
  ASSERT_TRUE(document.geodesics.empty());
  document.other = octagons().other;
  EXPECT_EQ(both(document), "VERIFIED");
}

TEST(SecondCheckerOfComparisons, BothListsAreExamined) {
  Document document = against_itself(octagons());
  document.geodesics.erase(document.geodesics.begin());
  static_cast<GeodesicsDocument&>(document) = in_order(document);
  EXPECT_EQ(both(document), "REFUTED: complete");
  document = against_itself(octagons());
  document.other.geodesics.erase(document.other.geodesics.begin());
  document.other = in_order(document.other);
  EXPECT_EQ(both(document), "REFUTED: other");
}

TEST(SecondCheckerOfComparisons, CrossingsTellIsospectralSurfacesApart) {
  const Document good = sunada();
  ASSERT_EQ(good.geodesics.size(), good.other.geodesics.size());
  Document document = against_itself(good.other);
  document.other = good;
  EXPECT_EQ(both(document), "VERIFIED");
  // Lists of different lengths have different crossings on one surface, too.
  document = against_itself(good);
  document.other = shortened(good, "3.8");
  ASSERT_LT(document.other.geodesics.size(), good.geodesics.size());
  EXPECT_EQ(both(document), "UNDECIDED: different");
  static_cast<GeodesicsDocument&>(document) = document.other;
  document.other = good;
  EXPECT_EQ(both(document), "UNDECIDED: different");
}

TEST(SecondCheckerOfComparisons, TheMirrorImageIsNotDifferent) {
  // Of an octagon whose isometries all preserve the orientation, though the file says that it is.
  EXPECT_EQ(both(read("mirror-image-different")), "UNDECIDED: different");
}

// Traces as the second checker compares them.

exact::Trace trace(int t, int scale = 1) {
  return {exact::real_number(mpz_class(t * t * scale)), exact::real_number(mpz_class(scale)), (t > 0) - (t < 0)};
}

/// Of x, y, xy; and of two other elements with 1, x, y, xy.
std::vector<exact::Trace> traces() {
  std::vector<exact::Trace> result;
  for (const int t : {3, 4, 5, 1, 2, 0, 6, 7, 8, 9, 10}) result.push_back(trace(t));
  return result;
}

bool are_conjugate(const std::vector<exact::Trace>& from, const std::vector<exact::Trace>& to) {
  try {
    exact::expect_conjugate({1, from}, {1, to});
    return true;
  } catch (const exact::Refutation&) {
    return false;
  }
}

TEST(SecondCheckerOfComparisons, TracesAreEqualUpToOneSignForEachElement) {
  EXPECT_TRUE(are_conjugate(traces(), traces()));
  for (std::size_t i = 0; i < traces().size(); ++i) {
    std::vector<exact::Trace> other = traces();
    other[i] = trace(11);
    EXPECT_FALSE(are_conjugate(traces(), other)) << i;
    other = traces();
    if (other[i].sign == 0) continue;
    other[i].sign = -1;
    EXPECT_FALSE(are_conjugate(traces(), other)) << i;
  }
  for (const std::size_t first : {3U, 7U}) {
    std::vector<exact::Trace> other = traces();
    for (std::size_t i = first; i < first + 4; ++i) other[i].sign = -other[i].sign;
    EXPECT_TRUE(are_conjugate(traces(), other)) << first;
  }
  std::vector<exact::Trace> scaled;
  for (const int t : {3, 4, 5, 1, 2, 0, 6, 7, 8, 9, 10}) scaled.push_back(trace(t, 7));
  EXPECT_TRUE(are_conjugate(traces(), scaled));
}

TEST(SecondCheckerOfComparisons, TracesAreThoseOfThePairItsProductAndProductsWithIt) {
  std::ostringstream out;
  write_file(mirror_image().net, out);
  const exact::Net net = exact::read_net(exact::parse_json(out.str()));
  exact::NetRules<mpz_class> rules(net);
  rules.rules().front().ask();
  const std::vector<Word> words{{0}, {1, 2}, {3}, {2, 1}};
  const exact::Traces found = exact::traces_of(rules, words);
  const auto x = exact::positive_element(rules, words[0]);
  const auto y = exact::positive_element(rules, words[1]);
  EXPECT_EQ(found.crossing_sign, exact::crossing_sign(x, y));
  std::vector<exact::Isometry<mpz_class>> elements{x, y, rules.product(x, y)};
  for (std::size_t n = 2; n < words.size(); ++n) {
    const auto g = exact::positive_element(rules, words[n]);
    for (const auto& f : {exact::Isometry<mpz_class>(), x, y, rules.product(x, y)}) {
      elements.push_back(rules.product(f, g));
    }
  }
  ASSERT_EQ(found.traces.size(), elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto& [a, b] = elements[i];
    const mpz_class determinant = a.re * a.re + a.im * a.im - b.re * b.re - b.im * b.im;
    EXPECT_EQ(found.traces[i].square.approximation(0).value, a.re * a.re) << i;
    EXPECT_EQ(found.traces[i].determinant.approximation(0).value, determinant) << i;
    EXPECT_EQ(found.traces[i].sign, sgn(a.re)) << i;
  }
}

TEST(SecondCheckerOfComparisons, NumbersMayBeMuchCloserThanTheirConjugatesAreLarge) {
  const auto is_one = [](const auto& x) {
    const exact::Trace one = trace(1);
    return are_conjugate({exact::Trace{real_number(x), one.determinant, 1}}, {one});
  };
  // x⁴ + 2⁶⁰x + 1 has a root near −2⁻⁶⁰ and three near 2²⁰ in size.
  const exact::NumberField quartic({1, mpz_class(1) << 60, 0, 0, 1}, -1, 0);
  EXPECT_FALSE(is_one(exact::FieldNumber(quartic, {1, 0, 0, 1})));
  EXPECT_TRUE(is_one(exact::FieldNumber(quartic, {1})));
  // Powers of 2 − 2cos(2π/n) are small, those of the conjugates are not.
  const exact::RealField cosines(100, 100, false);
  const exact::Algebraic small = exact::Algebraic(2) - cosines.cosine(1);
  exact::Algebraic power = 1;
  for (int i = 0; i < 60; ++i) power = power * small;
  EXPECT_FALSE(is_one(exact::Algebraic(1) + power));
  EXPECT_FALSE(is_one(exact::Algebraic(1) + power * cosines.s()));
  EXPECT_TRUE(is_one(exact::Algebraic(1) + power - power));
}

TEST(SecondCheckerOfComparisons, TheDegreeIsThatOfBothFieldsTogether) {
  // x₀ + x₁√p = −(x₂ + x₃√p)√q, but for a small number.
  const auto are_equal = [](const auto& left, const auto& left_root, const auto& right, const auto& one) {
    return are_conjugate({exact::Trace{real_number(left), real_number(right), 1}},
                         {exact::Trace{real_number(one), real_number(left_root), 1}});
  };
  const exact::NumberField two({-2, 0, 1}, 1, 2);
  const exact::NumberField five({-5, 0, 1}, 2, 3);
  for (const auto& x : biquadratic::powers_with_five(15)) {
    EXPECT_FALSE(are_equal(exact::FieldNumber(two, {x[2], x[3]}), exact::FieldNumber(five, {0, 1}),
                           exact::FieldNumber(two, {-x[0], -x[1]}), exact::FieldNumber(five, {1})));
  }
  // √2 and √3 as cosines of orders 8 and 12; order 24 has both, with degree 4.
  const exact::RealField eight(8, 8, false);
  const exact::RealField twelve(12, 12, false);
  for (const auto& x : biquadratic::powers_with_three(15)) {
    const auto in_eight = [&](const mpz_class& a, const mpz_class& b) {
      return exact::Algebraic(a) + exact::Algebraic(b) * eight.cosine(1);
    };
    EXPECT_FALSE(are_equal(in_eight(x[2], x[3]), twelve.cosine(1), in_eight(-x[0], -x[1]), exact::Algebraic(1)));
  }
}

/// A number that is known no better than to some multiple of itself until more than 1000 bits are asked for.
exact::RealNumber hardly_known(exact::RealNumber x) {
  x.approximation = [precise = x.approximation](mp_bitcnt_t k) {
    if (k > 1000) return precise(k);
    return exact::Approximation{0, 2 * abs(precise(k).value) + 2};
  };
  return x;
}

TEST(SecondCheckerOfComparisons, NumbersAreWithinTheErrorsOfTheirApproximations) {
  const exact::RealNumber zero = exact::real_number(mpz_class(0));
  for (const int x : {1, 5, 1000}) {
    for (const int y : {1, 3, 1000}) {
      const exact::RealNumber first = hardly_known(exact::real_number(mpz_class(x)));
      const exact::RealNumber other = hardly_known(exact::real_number(mpz_class(y)));
      const exact::RealNumber product = exact::real_number(mpz_class(x * y));
      const exact::RealNumber one = exact::real_number(mpz_class(1));
      // xy = 0 · 0, and xy = xy · 1.
      EXPECT_FALSE(are_conjugate({{first, zero, 1}}, {{zero, other, 1}}));
      EXPECT_TRUE(are_conjugate({{first, product, 1}}, {{one, other, 1}}));
    }
  }
}

TEST(SecondCheckerOfComparisons, EitherFieldMayHaveTheIntegers) {
  // As above, with the fields exchanged, and with the products on other sides.
  const auto expect_different = [](const exact::RealNumber& x, const exact::RealNumber& y, const exact::RealNumber& u,
                                   const exact::RealNumber& v) {
    EXPECT_FALSE(are_conjugate({{x, u, 1}}, {{v, y, 1}}));
    EXPECT_FALSE(are_conjugate({{u, x, 1}}, {{y, v, 1}}));
    EXPECT_FALSE(are_conjugate({{y, v, 1}}, {{u, x, 1}}));
    EXPECT_FALSE(are_conjugate({{v, y, 1}}, {{x, u, 1}}));
  };
  const exact::RealNumber one = exact::real_number(mpz_class(1));
  const exact::NumberField two({-2, 0, 1}, 1, 2);
  const exact::NumberField five({-5, 0, 1}, 2, 3);
  for (const auto& x : biquadratic::powers_with_five(15)) {
    expect_different(real_number(exact::FieldNumber(two, {x[0], x[1]})), one,
                     real_number(exact::FieldNumber(two, {-x[2], -x[3]})),
                     real_number(exact::FieldNumber(five, {0, 1})));
  }
  const exact::RealField eight(8, 8, false);
  const exact::RealField twelve(12, 12, false);
  for (const auto& x : biquadratic::powers_with_three(15)) {
    const auto in_eight = [&](const mpz_class& a, const mpz_class& b) {
      return real_number(exact::Algebraic(a) + exact::Algebraic(b) * eight.cosine(1));
    };
    expect_different(in_eight(x[0], x[1]), one, in_eight(-x[2], -x[3]), real_number(twelve.cosine(1)));
  }
}

TEST(SecondCheckerOfComparisons, TheSpectraAreSpectra) {
  Document document = octagons();
  document.other.claim = GeodesicsDocument::Claim::systole;
  document.other.up_to.clear();
  document.other.clusters.clear();
  document.other.geodesics.resize(1);
  EXPECT_EQ(both(document), "MALFORMED");
}

}  // namespace
}  // namespace epsnet::certify::comparison_test
