#include "certify/check.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>

#include "certify/base/text.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"

namespace epsnet::certify::check_test {
namespace {

NetDocument load(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}
NetDocument nine() { return load("octagon-9-vertices.json"); }
NetDocument one() { return load("octagon-1-vertex.json"); }
NetDocument square() { return load("square-of-cocircular-vertices.json"); }

/// The verdict and, if it is not VERIFIED, the rule.
std::string outcome(const NetDocument& document) {
  const Certificate certificate = check(document, {.threads = 1});
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

/// The same net with every vertex in a chart of its own, centred there: all coordinates become 0, all labels
/// non-trivial. Needs charts with the centre 0 in the file.
NetDocument recharted(NetDocument document) {
  std::vector<NetDocument::Label> old_labels = document.labels;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers;
  document.labels.clear();
  std::vector<NetDocument::Chart> charts;
  for (NetDocument::Vertex& vertex : document.vertices) {
    charts.push_back({document.charts[vertex.chart].tile, {mpq_class(vertex.x), mpq_class(vertex.y)}});
    vertex = {0, 0, static_cast<std::uint32_t>(charts.size() - 1)};
  }
  document.charts = charts;
  for (NetDocument::Triangle& triangle : document.triangles) {
    for (std::size_t i = 1; i < 3; ++i) {
      const std::uint32_t from = triangle.vertex[i];
      const std::uint32_t to = triangle.vertex[0];
      std::uint32_t& number = triangle.label[i - 1];
      if (number == 0 && from == to) continue;
      const auto [found, is_new] = numbers.try_emplace({from, to, number}, document.labels.size() + 1);
      if (is_new)
        document.labels.push_back({from, to, number == 0 ? std::vector<std::uint32_t>{} : old_labels[number - 1].word});
      number = found->second;
    }
  }
  return document;
}

TEST(Check, GoodNetsAreVerified) {
  EXPECT_EQ(outcome(nine()), "VERIFIED");
  EXPECT_EQ(outcome(one()), "VERIFIED");
  EXPECT_EQ(outcome(square()), "VERIFIED");
}

TEST(Check, CertificateTellsWhatWasMeasured) {
  const Certificate certificate = check(nine());
  EXPECT_EQ(certificate.rules.size(), 7U);
  EXPECT_EQ(certificate.counts.vertices, 9U);
  EXPECT_EQ(certificate.counts.edges, 33U);
  EXPECT_EQ(certificate.counts.triangles, 22U);
  EXPECT_EQ(certificate.counts.genus, 2U);
  ASSERT_TRUE(certificate.enclosures.has_value());
  const Enclosures& e = *certificate.enclosures;
  EXPECT_NEAR(e.largest_circumradius.lower, 0.954362312811241, 1e-14);
  EXPECT_LT(e.largest_circumradius.upper - e.largest_circumradius.lower, 1e-14);
  ASSERT_TRUE(e.shortest_edge.has_value());
  EXPECT_NEAR(e.shortest_edge->lower, 1.041236299642140, 1e-14);
  EXPECT_FALSE(e.shortest_loop.has_value());
  EXPECT_LE(e.area.lower, 4 * M_PI);
  EXPECT_GE(e.area.upper, 4 * M_PI);
  EXPECT_EQ(e.epsilon.lower, 1);
}

TEST(Check, EnclosuresContainWhatTheyEnclose) {
  // To 40 digits, from the exact coordinates by forgeries_plane.py: far more than an interval of binary64 is wide.
  const auto expect_inside = [](const Interval& interval, const char* digits) {
    const mpq_class value = *parse_decimal(digits);
    EXPECT_LT(mpq_class(interval.lower), value) << digits;
    EXPECT_GT(mpq_class(interval.upper), value) << digits;
    EXPECT_LT(interval.upper - interval.lower, 1e-13) << digits;
  };
  const Enclosures many = *check(nine()).enclosures;
  expect_inside(many.largest_circumradius, "0.9543623128112414981872315665145624387619");
  expect_inside(many.longest_edge, "1.8410224381231801470489596493727404089153");
  expect_inside(*many.shortest_edge, "1.0412362996421404483535806177967111982709");
  expect_inside(many.area, "12.5663706143591729538505735331180115367886");
  const Enclosures single = *check(one()).enclosures;
  expect_inside(single.largest_circumradius, "2.0590999697225564331035948126407819717945");
  expect_inside(single.longest_edge, "4.0797060416419684426529192127625876285379");
  expect_inside(*single.shortest_loop, "2.6397814615933125164441319754793701420491");
  EXPECT_FALSE(single.shortest_edge.has_value());
  expect_inside(check(load("regular-3-centre.json")).enclosures->area, "25.1327412287183459077011470662360230735773");
  NetDocument document = nine();
  document.epsilon = "1.01";
  expect_inside(check(document).enclosures->epsilon, "1.01");
  const Certificate collars = check(read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/forgeries/collars.json"));
  ASSERT_TRUE(collars.enclosures->shortest_core.has_value());
  EXPECT_NEAR(collars.enclosures->shortest_core->lower, 0.125, 1e-13);
}

TEST(Check, ChartsAreOnlyNames) {
  for (const NetDocument& document : {nine(), square()}) {
    const NetDocument moved = recharted(document);
    const Certificate before = check(document);
    const Certificate after = check(moved);
    EXPECT_EQ(after.verdict, Verdict::verified) << after.message;
    // The general formulas with labels against the special ones without: one number, two enclosures.
    EXPECT_LE(after.enclosures->largest_circumradius.lower, before.enclosures->largest_circumradius.upper);
    EXPECT_LE(before.enclosures->largest_circumradius.lower, after.enclosures->largest_circumradius.upper);
    EXPECT_LE(after.enclosures->shortest_edge->lower, before.enclosures->shortest_edge->upper);
    EXPECT_LE(before.enclosures->shortest_edge->lower, after.enclosures->shortest_edge->upper);
    EXPECT_LE(after.enclosures->longest_edge.lower, before.enclosures->longest_edge.upper);
    EXPECT_LE(before.enclosures->longest_edge.lower, after.enclosures->longest_edge.upper);
  }
}

TEST(Check, ExactTiesAreDecidedAndCounted) {
  EXPECT_EQ(check(square()).counts.exact_ties, 1U);
  EXPECT_EQ(check(recharted(square())).counts.exact_ties, 1U);
  EXPECT_EQ(check(square()).ties.size(), 1U);
  EXPECT_EQ(check(nine()).counts.exact_ties, 0U);
}

TEST(Check, NearTiesAreDecidedEitherWay) {
  // The square's corners (±3/16, ±3/16): move one by one unit in the last place, inward or outward. Exactly one of the
  // two ways makes the diagonal that the file has the wrong one.
  std::size_t verified = 0;
  std::size_t refuted = 0;
  for (const double direction : {-1.0, 1.0}) {
    NetDocument document = square();
    for (NetDocument::Vertex& vertex : document.vertices) {
      if (vertex.x == 0.1875 && vertex.y == 0.1875) vertex.x = std::nextafter(vertex.x, direction);
    }
    const Certificate certificate = check(document);
    EXPECT_EQ(certificate.counts.exact_ties, 0U);
    verified += certificate.verdict == Verdict::verified;
    refuted += certificate.verdict == Verdict::refuted && certificate.rule == "delaunay";
  }
  EXPECT_EQ(verified, 1U);
  EXPECT_EQ(refuted, 1U);
}

TEST(Check, ThreadsDoNotMatter) {
  for (const char* file : {"octagon-33-vertices.json", "square-of-cocircular-vertices.json"}) {
    NetDocument document = load(file);
    for (const char* epsilon : {"0.75", "0.5", "0.3"}) {
      document.epsilon = epsilon;
      const Certificate single = check(document, {.threads = 1});
      const Certificate several = check(document, {.threads = 7});
      EXPECT_EQ(single.verdict, several.verdict);
      EXPECT_EQ(single.message, several.message);
      for (std::size_t i = 0; i < single.rules.size(); ++i) EXPECT_EQ(single.rules[i].text, several.rules[i].text);
    }
  }
}

TEST(Check, VacuousDocumentsAreRejected) {
  EXPECT_EQ(outcome({}), "MALFORMED: structure");
  NetDocument document = nine();
  document.vertices.clear();
  document.triangles.clear();
  EXPECT_EQ(outcome(document), "REFUTED: map");
  document = nine();
  document.triangles.clear();
  EXPECT_EQ(outcome(document), "REFUTED: map");
  document = nine();
  document.surface = {};
  EXPECT_EQ(outcome(document), "MALFORMED: structure");
}

TEST(Check, NumbersThatAreNoneAreMalformed) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1.0, -2.0}) {
    NetDocument document = nine();
    document.vertices[4].y = bad;
    EXPECT_EQ(outcome(document), "MALFORMED: structure");
  }
  for (const char* bad : {"", "nan", "-1", "0", "1e99999"}) {
    NetDocument document = nine();
    document.epsilon = bad;
    EXPECT_EQ(outcome(document), "MALFORMED: structure");
  }
}

TEST(Check, ExtremeEpsilonsEnd) {
  NetDocument document = nine();
  document.epsilon = "1e-9999";
  EXPECT_EQ(outcome(document), "REFUTED: covering");
  document.epsilon = "1e9999";
  const Certificate certificate = check(document);
  EXPECT_NE(certificate.verdict, Verdict::verified);
}

TEST(Check, MoreBitsDecideMore) {
  // The shortest edge to 30 digits (mpmath), rounded down: shorter by less than 64 bits can see.
  NetDocument document = nine();
  document.epsilon = "1.041236299642140448353580617796";
  const Certificate coarse = check(document, {.threads = 1, .max_precision = 64});
  EXPECT_EQ(coarse.verdict, Verdict::undecided);
  EXPECT_EQ(coarse.rule, "packing");
  const Certificate fine = check(document, {.threads = 1, .max_precision = 256});
  EXPECT_EQ(fine.verdict, Verdict::verified) << fine.message;
  EXPECT_GT(fine.counts.triangles_beyond_64_bits, 0U);
  EXPECT_EQ(fine.counts.max_precision_used, 128U);
}

TEST(Check, WhatBallsDoNotTellIsUndecided) {
  // The largest radius and the shortest edge, rounded down and up after 30 digits: 64 bits do not tell them from ε.
  struct Case {
    const char* epsilon;
    const char* rule;
    Verdict verdict;
  };
  for (const auto& [epsilon, rule, verdict] : {Case{"0.954362312811241498187231566514", "covering", Verdict::refuted},
                                               Case{"0.954362312811241498187231566515", "covering", Verdict::verified},
                                               Case{"1.041236299642140448353580617796", "packing", Verdict::verified},
                                               Case{"1.041236299642140448353580617797", "packing", Verdict::refuted}}) {
    for (const NetDocument& net : {nine(), recharted(nine())}) {
      NetDocument document = net;
      document.epsilon = epsilon;
      const Certificate coarse = check(document, {.threads = 1, .max_precision = 64});
      EXPECT_EQ(coarse.verdict, Verdict::undecided) << epsilon;
      EXPECT_EQ(coarse.rule, rule);
      for (const RuleReport& report : coarse.rules) {
        EXPECT_EQ(report.verdict, report.rule == rule ? Verdict::undecided : Verdict::verified) << report.rule;
      }
      const Certificate fine = check(document, {.threads = 1, .max_precision = 128});
      EXPECT_EQ(fine.verdict, verdict) << epsilon;
      EXPECT_EQ(fine.rule, verdict == Verdict::verified ? "" : rule);
      EXPECT_EQ(fine.counts.triangles_beyond_64_bits, 1U);
    }
  }
}

TEST(Check, ExactTiesNeedNoBits) {
  // Ties in charts that are not centred in the vertices are decided exactly, with the least precision that there is.
  const NetDocument plain = square();
  for (const NetDocument& document : {plain, recharted(plain)}) {
    const Certificate certificate = check(document, {.threads = 1, .max_precision = 64});
    EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
    ASSERT_EQ(certificate.ties.size(), 1U);
    // The tie is the diagonal between opposite corners of the square.
    const std::uint32_t dart = certificate.ties[0];
    EXPECT_LT(dart, opposite(document, dart));
    const NetDocument::Vertex& u = plain.vertices[start(document, dart)];
    const NetDocument::Vertex& v = plain.vertices[start(document, next_dart(dart))];
    EXPECT_EQ(u.x, -v.x);
    EXPECT_EQ(u.y, -v.y);
  }
}

TEST(Check, TiesMissedByFarLessThanBallsTellAreNone) {
  // One corner of the square 10⁻²⁰⁰ farther in or out: decided exactly, one way or the other, and no tie.
  mpq_class step(1);
  mpz_ui_pow_ui(step.get_den_mpz_t(), 10, 200);
  int verified = 0;
  int refuted = 0;
  for (std::size_t v = 0; v < square().vertices.size(); ++v) {
    if (std::abs(square().vertices[v].x) != 0.1875 || std::abs(square().vertices[v].y) != 0.1875) continue;
    for (const int way : {-1, 1}) {
      NetDocument document = recharted(square());
      document.charts[v].centre.x += way * step;
      const Certificate certificate = check(document, {.threads = 1});
      EXPECT_EQ(certificate.counts.exact_ties, 0U);
      EXPECT_TRUE(certificate.ties.empty());
      EXPECT_EQ(certificate.counts.max_precision_used, 256U);
      verified += certificate.verdict == Verdict::verified;
      refuted += certificate.verdict == Verdict::refuted && certificate.rule == "delaunay";
    }
  }
  EXPECT_EQ(verified, 4);
  EXPECT_EQ(refuted, 4);
}

/// The same net with corner 1 of a triangle as its corner 0, if the triangle lies in one copy of the tile: then its
/// labels are those of empty words.
NetDocument with_triangle_turned(NetDocument document, std::uint32_t t) {
  NetDocument::Triangle& triangle = document.triangles[t];
  for (NetDocument::Triangle& other : document.triangles) {
    for (std::uint32_t& dart : other.opposite) {
      if (dart / 3 == t) dart = previous_dart(dart);
    }
  }
  std::rotate(triangle.vertex.begin(), triangle.vertex.begin() + 1, triangle.vertex.end());
  std::rotate(triangle.opposite.begin(), triangle.opposite.begin() + 1, triangle.opposite.end());
  for (std::size_t i = 1; i < 3; ++i) {
    const std::uint32_t from = document.vertices[triangle.vertex[i]].chart;
    const std::uint32_t to = document.vertices[triangle.vertex[0]].chart;
    if (from != to) document.labels.push_back({from, to, {}});
    triangle.label[i - 1] = from == to ? 0 : static_cast<std::uint32_t>(document.labels.size());
  }
  return document;
}

TEST(Check, TiesAreDecidedAtEveryEdgeOfATriangle) {
  // The diagonal as each edge of each of its two triangles; as it is, and with a corner of the square 10⁻⁴⁰ or 10⁻²⁰⁰
  // farther in or out, which balls decide, or exact numbers.
  for (const bool charts : {false, true}) {
    NetDocument document = charts ? recharted(square()) : square();
    const std::uint32_t tie = check(document, {.threads = 1}).ties.at(0);
    const std::uint32_t here = tie / 3;
    const std::uint32_t there = opposite(document, tie) / 3;
    const std::uint32_t corner = start(document, previous_dart(tie));
    for (int turn = 0; turn < 9; ++turn) {
      document = with_triangle_turned(document, turn % 3 == 0 ? here : there);
      for (const long precision : {64L, 8192L}) {
        const Certificate certificate = check(document, {.threads = 1, .max_precision = precision});
        EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
        ASSERT_EQ(certificate.ties.size(), 1U);
        const std::uint32_t dart = certificate.ties[0];
        EXPECT_EQ(dart / 3, std::min(here, there));
        EXPECT_EQ(opposite(document, dart) / 3, std::max(here, there));
      }
      for (const unsigned long digits : {40UL, 200UL}) {
        if (!charts) continue;
        mpq_class step(1);
        mpz_ui_pow_ui(step.get_den_mpz_t(), 10, digits);
        std::map<Verdict, int> met;
        for (const int way : {-1, 1}) {
          NetDocument moved = document;
          moved.charts[corner].centre.x += way * step;
          const Certificate certificate = check(moved, {.threads = 1});
          ++met[certificate.verdict];
          EXPECT_TRUE(certificate.ties.empty());
          if (certificate.verdict == Verdict::refuted) {
            EXPECT_EQ(certificate.rule, "delaunay");
          }
        }
        EXPECT_EQ(met[Verdict::verified], 1);
        EXPECT_EQ(met[Verdict::refuted], 1);
      }
    }
  }
}

/// The same net with words for the labels of a triangle that go around the octagon's corner so many times before that
/// exact numbers are too large.
NetDocument with_long_words(NetDocument document, std::uint32_t t) {
  for (const std::uint32_t number : document.triangles[t].label) {
    if (number == 0) continue;
    std::vector<std::uint32_t> around;
    for (int k = 0; k < 4000; ++k) around.insert(around.end(), {0, 5, 2, 7, 4, 1, 6, 3});
    std::vector<std::uint32_t>& word = document.labels[number - 1].word;
    word.insert(word.begin(), around.begin(), around.end());
  }
  return document;
}

RuleReport report(const Certificate& certificate, const std::string& rule) {
  for (const RuleReport& found : certificate.rules) {
    if (found.rule == rule) return found;
  }
  return {};
}

TEST(Check, WhatExactNumbersAreTooLargeForIsUndecided) {
  NetDocument document = recharted(square());
  const CheckOptions options{.threads = 1, .max_precision = 64};
  const std::uint32_t tie = check(document, options).ties.at(0);
  Certificate certificate = check(with_long_words(document, tie / 3), options);
  EXPECT_EQ(certificate.verdict, Verdict::undecided);
  EXPECT_EQ(certificate.rule, "delaunay");
  EXPECT_EQ(certificate.counts.exact_ties, 0U);
  // The third corner of its triangle moved to the centre of the square, on the diagonal.
  const std::uint32_t corner = start(document, previous_dart(tie));
  document.charts[corner].centre = {0, 0};
  certificate = check(document, options);
  EXPECT_EQ(certificate.verdict, Verdict::refuted);
  EXPECT_EQ(certificate.rule, "orientation");
  certificate = check(with_long_words(document, tie / 3), options);
  EXPECT_EQ(report(certificate, "orientation").verdict, Verdict::undecided);
}

TEST(Check, WhatIsNotAskedAnyMoreIsNotVerified) {
  // The shortest edge is ε for 64 bits, and a vertex elsewhere makes triangles clockwise: then nobody asks further.
  const NetDocument good = nine();
  int met = 0;
  for (std::size_t v = 0; v < good.vertices.size(); ++v) {
    NetDocument document = good;
    document.epsilon = "1.041236299642140448353580617796";
    document.vertices[v].x = -document.vertices[v].x + 0.01;
    const Certificate certificate = check(document, {.threads = 1});
    EXPECT_EQ(certificate.verdict, Verdict::refuted);
    const RuleReport packing = report(certificate, "packing");
    met += certificate.rule == "orientation" && packing.verdict == Verdict::undecided &&
           packing.text == "not decided, as rule orientation is refuted";
  }
  EXPECT_GT(met, 0);
}

TEST(Check, VerticesAtTheEndsOfBinary64AreRefuted) {
  NetDocument document = nine();
  document.vertices[2] = {std::nextafter(1.0, 0.0), 0, 0};
  EXPECT_EQ(check(document).verdict, Verdict::refuted);
  document.vertices[2] = {5e-324, -5e-324, 0};
  EXPECT_EQ(check(document).verdict, Verdict::refuted);
}

TEST(Check, TwoVerticesAtOnePlaceAreRefuted) {
  NetDocument document = nine();
  document.vertices[2] = document.vertices[5];
  const Certificate certificate = check(document);
  EXPECT_EQ(certificate.verdict, Verdict::refuted);
}

TEST(Check, LongWordsThatCancelAreTheSameElement) {
  // s … s s' … s' in front of a word changes nothing; no balls could follow it that far out and back.
  NetDocument document = nine();
  const std::uint32_t side = document.labels[0].word[0];
  const std::uint32_t partner = (side + 4) % 8;
  std::vector<std::uint32_t>& word = document.labels[0].word;
  std::vector<std::uint32_t> longer(100'000, side);
  longer.insert(longer.end(), 100'000, partner);
  longer.insert(longer.end(), word.begin(), word.end());
  word = longer;
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Check, RelationOfTheGroupIsTheIdentity) {
  // Around the octagon's only vertex: a word of eight letters that is trivial in the group but not as a word.
  NetDocument document = one();
  std::vector<std::uint32_t> relation;
  std::uint32_t side = 0;
  do {
    relation.push_back(side);
    side = ((side + 4) % 8 + 1) % 8;
  } while (side != 0);
  ASSERT_EQ(relation.size(), 8U);
  std::vector<std::uint32_t>& word = document.labels[0].word;
  word.insert(word.begin(), relation.begin(), relation.end());
  EXPECT_EQ(outcome(document), "VERIFIED");
  word.erase(word.begin());  // Seven of eight letters are not.
  EXPECT_EQ(outcome(document), "REFUTED: gluing");
}

// Single defects, each in every place: none may be verified.

TEST(Mutation, EveryWrongOppositeDartIsRefuted) {
  const NetDocument good = nine();
  for (std::size_t dart = 0; dart < 66; ++dart) {
    for (const std::uint32_t wrong : {0U, 17U, 65U}) {
      NetDocument document = good;
      std::uint32_t& opposite = document.triangles[dart / 3].opposite[dart % 3];
      if (opposite == wrong) continue;
      opposite = wrong;
      EXPECT_EQ(outcome(document), "REFUTED: map");
    }
  }
}

TEST(Mutation, EveryWrongVertexOfACornerIsRefuted) {
  const NetDocument good = nine();
  for (std::size_t corner = 0; corner < 66; ++corner) {
    NetDocument document = good;
    std::uint32_t& vertex = document.triangles[corner / 3].vertex[corner % 3];
    vertex = (vertex + 1) % 9;
    EXPECT_EQ(outcome(document), "REFUTED: map");
  }
}

TEST(SlowMutation, EveryWrongLabelNumberIsRefuted) {
  // Some words of this file are different words of one element of the group (found apart from this program, with
  // mpmath at 300 bits): such a label may stand for the other.
  const auto element = [](std::uint32_t number) {
    switch (number) {
      case 7:
        return 5U;
      case 11:
      case 12:  // The relation of the surface, so the identity.
      case 15:
      case 22:
        return 0U;
      case 18:
        return 17U;
      case 26:
        return 16U;
      default:
        return number;
    }
  };
  const NetDocument good = nine();
  for (std::size_t corner = 0; corner < 44; ++corner) {
    for (std::uint32_t wrong = 0; wrong <= good.labels.size(); ++wrong) {
      NetDocument document = good;
      std::uint32_t& number = document.triangles[corner / 2].label[corner % 2];
      const bool same = element(number) == element(wrong);
      number = wrong;
      EXPECT_EQ(outcome(document), same ? "VERIFIED" : "REFUTED: gluing") << corner << ' ' << wrong;
    }
  }
}

TEST(Mutation, EveryWrongLetterIsRefuted) {
  const NetDocument good = nine();
  for (std::size_t l = 0; l < good.labels.size(); ++l) {
    for (std::size_t i = 0; i < good.labels[l].word.size(); ++i) {
      NetDocument document = good;
      std::uint32_t& letter = document.labels[l].word[i];
      letter = (letter + 4) % 8;
      // A label that no triangle uses may say anything.
      bool used = false;
      for (const NetDocument::Triangle& t : good.triangles) used = used || t.label[0] == l + 1 || t.label[1] == l + 1;
      EXPECT_EQ(outcome(document), used ? "REFUTED: gluing" : "VERIFIED");
    }
  }
}

TEST(Mutation, TrianglesTurnedOverAreRefuted) {
  // Corners 1 and 2 exchanged in every triangle: the same triangles, clockwise.
  NetDocument document = nine();
  for (NetDocument::Triangle& t : document.triangles) {
    std::swap(t.vertex[1], t.vertex[2]);
    std::swap(t.label[0], t.label[1]);
    std::swap(t.opposite[0], t.opposite[2]);
    for (std::uint32_t& dart : t.opposite) dart = dart / 3 * 3 + (2 - dart % 3);
  }
  EXPECT_EQ(outcome(document), "REFUTED: orientation");
}

TEST(Mutation, EveryVertexMovedFarIsRefuted) {
  const NetDocument good = nine();
  for (std::size_t v = 0; v < good.vertices.size(); ++v) {
    NetDocument document = good;
    document.vertices[v].x = std::nextafter(document.vertices[v].x, 1.0);
    EXPECT_EQ(outcome(document), "VERIFIED") << "one unit in the last place is still a net";
    document.vertices[v].x = -document.vertices[v].x + 0.01;
    EXPECT_EQ(check(document).verdict, Verdict::refuted);
  }
}

TEST(Mutation, RotatedTrianglesStayVerified) {
  // Corner 0 of every triangle becomes its corner 2. Needs labels L_i relative to the new corner 0; possible here where
  // the labels of a triangle are all the identity.
  NetDocument document = load("octagon-33-vertices.json");
  std::vector<bool> turn(document.triangles.size());
  for (std::size_t t = 0; t < turn.size(); ++t) {
    turn[t] = document.triangles[t].label == std::array<std::uint32_t, 2>{0, 0};
  }
  for (std::size_t t = 0; t < turn.size(); ++t) {
    NetDocument::Triangle& triangle = document.triangles[t];
    for (std::uint32_t& dart : triangle.opposite) {
      if (turn[dart / 3]) dart = next_dart(dart);
    }
    if (!turn[t]) continue;
    triangle.vertex = {triangle.vertex[2], triangle.vertex[0], triangle.vertex[1]};
    triangle.opposite = {triangle.opposite[2], triangle.opposite[0], triangle.opposite[1]};
  }
  EXPECT_EQ(outcome(document), "VERIFIED");
}

}  // namespace
}  // namespace epsnet::certify::check_test
