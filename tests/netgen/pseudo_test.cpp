#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/collars.h"
#include "netgen/nets/refine.h"
#include "netgen/nets/triangulations.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/operations.h"

/// Pseudo epsilon-nets: the generator, and every clause of the certifier's rules `collars` and `thick` broken alone.
namespace epsnet::pseudo_test {
namespace {

using certify::Certificate;
using certify::NetDocument;
using certify::Verdict;
using test::any_index;
using test::any_share;
using testing::HasSubstr;

const NetOptions kPseudo{.pseudo = true, .check = {.threads = 1}};

/// A surface of genus 2, or of the genus of a graph, whose first cuffs have these lengths.
Surface with_cuffs(const std::vector<Rational>& lengths, PantsGraph graph = PantsGraph::chain(2)) {
  FenchelNielsen coordinates = random_coordinates(std::move(graph), 3);
  for (std::size_t e = 0; e < lengths.size(); ++e) test::set_cuff_length(coordinates, e, lengths[e]);
  return fenchel_nielsen_surface(coordinates);
}

Rational power_of_ten(int digits) {
  return Rational(1, pow(boost::multiprecision::mpz_int(10), static_cast<unsigned>(digits)));
}

/// Theorem III.14: a pseudo net has fewer vertices, whatever the systole.
double most_vertices_of_pseudo_net(std::uint32_t genus, double epsilon) {
  return 16 * (genus - 1.0) / (epsilon * epsilon) + 3 * genus - 3;
}

/// The number of vertices of a net that is verified as a pseudo net with so many collars.
std::size_t expect_verified(const Surface& surface, const std::string& epsilon, std::size_t collars,
                            const NetOptions& options = kPseudo, const Variant& variant = {}) {
  try {
    const VariantNet net = compute_variant(surface, Length(epsilon), variant, options);
    const Certificate certificate = certify::check(net.document, options.check);
    EXPECT_EQ(certificate.verdict, Verdict::verified);
    EXPECT_EQ(certificate.rules.size(), 9U);
    EXPECT_EQ(certificate.counts.collars, collars) << epsilon;
    EXPECT_EQ(net.statistics.collars, collars);
    EXPECT_LT(static_cast<double>(net.document.vertices.size()),
              most_vertices_of_pseudo_net(surface.genus(), std::stod(epsilon)));
    return net.document.vertices.size();
  } catch (const NetError& error) {
    ADD_FAILURE() << "epsilon " << epsilon << ": " << error.what();
    return 0;
  }
}

TEST(PseudoNet, OneShortCuffIsOneCollar) {
  for (const char* graph : {"0-0 0-1 1-1", "0-1 0-1 0-1"}) {
    for (const int digits : {1, 2, 4, 8, 12, 25}) {
      for (const std::size_t cuff : {0u, 1u}) {  // Cuff 1 of the first graph separates.
        std::vector<Rational> lengths(2, Rational(3, 2));
        lengths[cuff] = power_of_ten(digits);
        const Surface surface = with_cuffs(lengths, PantsGraph::parse(graph));
        expect_verified(surface, "0.34", 1);
        expect_verified(surface, "0.25", 1);
      }
    }
  }
}

TEST(PseudoNet, TheNumberOfVerticesDoesNotGrowAsCuffsShrink) {
  const Rational longest(9, 100);
  const auto vertices = static_cast<double>(expect_verified(with_cuffs({longest, longest, longest}), "0.1", 3));
  for (const int digits : {2, 4, 8, 12}) {
    const Rational length = power_of_ten(digits);
    EXPECT_NEAR(static_cast<double>(expect_verified(with_cuffs({length, length, length}), "0.1", 3)), vertices,
                0.05 * vertices);
  }
}

TEST(PseudoNet, EveryShortCuffIsACollarInHigherGenus) {
  for (const std::uint32_t genus : {3u, 5u}) {
    for (const PantsGraph& graph : {PantsGraph::chain(genus), PantsGraph::ring(genus), PantsGraph::random(genus, 2)}) {
      expect_verified(with_cuffs({power_of_ten(4), power_of_ten(12)}, graph), "0.34", 2);
      const std::vector<Rational> all_short(3 * genus - 3, power_of_ten(8));
      expect_verified(with_cuffs(all_short, graph), "0.25", all_short.size());
    }
  }
}

TEST(PseudoNet, ACuffIsACollarIfAndOnlyIfItIsShorterThanEpsilon) {
  // l_ε is 0.3534… for ε = 1/4.
  expect_verified(with_cuffs({Rational(2499999, 10000000)}), "0.25", 1);
  expect_verified(with_cuffs({Rational(2500001, 10000000)}), "0.25", 0);
  expect_verified(with_cuffs({Rational(3, 10), Rational(353, 1000), Rational(354, 1000)}), "0.25", 0);
  for (const int digits : {3, 6, 9, 12, 15}) {
    expect_verified(with_cuffs({Rational(1, 4) - power_of_ten(digits)}), "0.25", 1);
    expect_verified(with_cuffs({Rational(1, 4) - power_of_ten(digits)}, PantsGraph::ring(2)), "0.25", 1);
    expect_verified(with_cuffs({Rational(1, 4) + power_of_ten(digits)}), "0.25", 0);
  }
}

TEST(PseudoNet, CollarsAreFoundFromAfar) {
  // The start is one vertex inside a pair of pants; the first insertion in a collar is undone.
  for (const int digits : {1, 4, 12, 25}) {
    for (const Insertion insertion : {Insertion::cavity, Insertion::flips}) {
      const Surface surface = with_cuffs({power_of_ten(digits), power_of_ten(digits)});
      NetOptions options = kPseudo;
      options.base = centre_of_tile(surface, TileId(0));
      const Variant variant{.insertion = insertion};
      expect_verified(surface, "0.2", 2, options, variant);
      EXPECT_GE(compute_variant(surface, Length("0.2"), variant, options).statistics.undone, 1U);
    }
  }
}

TEST(PseudoNet, WithoutShortCurvesItIsTheNet) {
  std::vector<Surface> surfaces{random_octagon(123), random_octagon(7), Surface::regular(2), Surface::regular(3)};
  for (const Surface& surface : surfaces) {
    for (const char* epsilon : {"0.34", "0.2"}) {
      expect_verified(surface, epsilon, 0);
      NetDocument pseudo = compute_net(surface, Length(epsilon), kPseudo).document;
      EXPECT_TRUE(pseudo.collars && pseudo.collars->empty());
      pseudo.collars.reset();
      EXPECT_EQ(pseudo, compute_net(surface, Length(epsilon)).document);
    }
  }
}

TEST(PseudoNet, EpsilonIsAtMostLnSqrt2) {
  // ln √2 = 0.346573590279972654708…
  EXPECT_TRUE(allows_pseudo_nets(Length("0.34657359027997265470")));
  EXPECT_FALSE(allows_pseudo_nets(Length("0.34657359027997265471")));
  EXPECT_TRUE(allows_pseudo_nets(Length("1e-300")));
  EXPECT_FALSE(allows_pseudo_nets(Length("1e300")));
  const Surface surface = with_cuffs({power_of_ten(2)});
  EXPECT_THROW((void)compute_net(surface, Length("0.34657359027997265471"), kPseudo), std::invalid_argument);
  expect_verified(surface, "0.34657359027997265470", 1);
}

TEST(PseudoNet, FileReadsBackTheSame) {
  const NetDocument net = compute_net(with_cuffs({power_of_ten(12)}), Length("0.34"), kPseudo).document;
  std::ostringstream out;
  certify::write_file(net, out);
  EXPECT_EQ(certify::parse_file<certify::NetDocument>(out.str(), "net"), net);
  EXPECT_EQ(net, compute_net(with_cuffs({power_of_ten(12)}), Length("0.34"), kPseudo).document);
}

RC_GTEST_PROP(PseudoNetProperty, FenchelNielsenSurfacesAreVerified, ()) {
  const std::uint32_t genus = 2 + any_index(3u);
  const FenchelNielsen coordinates = test::any_coordinates(genus, 1e-14, 5);
  const Surface surface = fenchel_nielsen_surface(coordinates);
  const Length epsilon(std::round((0.2 + 0.14 * any_share()) * 1e4) / 1e4);
  NetOptions options = kPseudo;
  const Variant variant{.insertion = any_index(2u) == 0 ? Insertion::cavity : Insertion::flips};
  if (any_index(2u) == 0) {
    options.base = centre_of_tile(surface, TileId(any_index(surface.tiles().size())));
  }
  const VariantNet net = compute_variant(surface, epsilon, variant, options);
  const Certificate certificate = certify::check(net.document, options.check);
  const auto short_cuffs = std::count_if(coordinates.lengths.begin(), coordinates.lengths.end(),
                                         [&](const Rational& length) { return length < epsilon.value(); });
  RC_ASSERT(certificate.verdict == Verdict::verified);
  RC_ASSERT(certificate.counts.collars >= static_cast<std::uint64_t>(short_cuffs));
  RC_ASSERT(certificate.counts.collars <= 3 * genus - 3);
  RC_ASSERT(static_cast<double>(net.document.vertices.size()) <
            most_vertices_of_pseudo_net(genus, static_cast<double>(epsilon.value())));
}

// ---- What the certifier refuses ----

/// Two collars, of lengths 1/100 and 1/10.
const NetDocument& good() {
  static const NetDocument net =
      compute_net(with_cuffs({Rational(1, 100), Rational(1, 10)}), Length("0.34"), kPseudo).document;
  return net;
}

/// The verdict and, if it is not VERIFIED, rule and message.
std::string outcome(const NetDocument& document, long max_precision = 2048) {
  const Certificate certificate = certify::check(document, {.threads = 1, .max_precision = max_precision});
  return verdict_line(certificate);
}

TEST(PseudoCertificate, SaysWhatItIs) {
  const Certificate certificate = certify::check(good());
  EXPECT_EQ(certificate.verdict, Verdict::verified);
  EXPECT_THAT(certificate.claim, HasSubstr("pseudo"));
  EXPECT_EQ(certificate.counts.collars, 2U);
  ASSERT_TRUE(certificate.enclosures && certificate.enclosures->shortest_core);
  EXPECT_NEAR(certificate.enclosures->shortest_core->lower, 0.01, 1e-14);
  std::vector<std::string> rules;
  for (const auto& report : certificate.rules) rules.push_back(report.rule);
  EXPECT_EQ(rules, (std::vector<std::string>{"surface", "map", "gluing", "collars", "orientation", "delaunay",
                                             "covering", "packing", "thick"}));
  const Certificate plain = certify::check(compute_net(random_octagon(1), Length("0.5")).document);
  EXPECT_EQ(plain.claim, "an epsilon-net");
  EXPECT_FALSE(plain.counts.collars.has_value());
}

TEST(PseudoCertificate, EpsilonIsAtMostLnSqrt2) {
  NetDocument net = good();
  net.epsilon = "0.34657359027997265471";
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: collars: epsilon: it is greater than ln sqrt(2)"));
  net.epsilon = "1e9999";
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: collars: epsilon"));
}

TEST(PseudoCertificate, CollarsAreDisjoint) {
  NetDocument net = good();
  net.collars->push_back(net.collars->front());
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: collars: collar 2"));
  EXPECT_THAT(outcome(net), HasSubstr("is named twice"));
  net = good();
  (*net.collars)[0].triangles[1] = (*net.collars)[0].triangles[0];
  EXPECT_THAT(outcome(net), HasSubstr("is named twice"));
  net = good();
  (*net.collars)[1].triangles[0] = (*net.collars)[0].triangles[0];
  EXPECT_THAT(outcome(net), HasSubstr("is named twice"));
  net = good();
  (*net.collars)[0].vertices[1] = (*net.collars)[0].vertices[0];
  EXPECT_THAT(outcome(net), HasSubstr("is named twice"));
}

TEST(PseudoCertificate, TrianglesHaveTheirCorners) {
  NetDocument net = good();
  std::swap((*net.collars)[0].triangles[0], (*net.collars)[0].triangles[1]);
  EXPECT_THAT(outcome(net), HasSubstr("has not two corners at the first vertex"));
  net = good();
  // A triangle without loop in place of the second one.
  std::uint32_t t = 0;
  while (std::set<std::uint32_t>(net.triangles[t].vertex.begin(), net.triangles[t].vertex.end()).size() < 3) ++t;
  (*net.collars)[0].triangles[1] = t;
  EXPECT_THAT(outcome(net), HasSubstr("has not two corners at the second vertex"));
}

TEST(PseudoCertificate, TrianglesAreGluedToAnAnnulus) {
  // Nets of few vertices have many triangles ppq and qqp, most of them not glued along two edges.
  std::size_t seen = 0;
  for (const std::int32_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    NetDocument net = compute_net(random_octagon(seed), Length("2")).document;
    net.epsilon = "0.3";
    const auto find = [&](std::uint32_t p, std::uint32_t q) {
      std::vector<std::uint32_t> result;
      for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
        const auto& v = net.triangles[t].vertex;
        if (std::count(v.begin(), v.end(), p) == 2 && std::count(v.begin(), v.end(), q) == 1) result.push_back(t);
      }
      return result;
    };
    for (std::uint32_t p = 0; p < net.vertices.size(); ++p) {
      for (std::uint32_t q = 0; q < net.vertices.size(); ++q) {
        for (const std::uint32_t t : find(p, q)) {
          for (const std::uint32_t u : find(q, p)) {
            net.collars = {{{}, {0, 1}, {p, q}, {t, u}}};
            const std::string text = outcome(net);
            EXPECT_THAT(text, HasSubstr("REFUTED: collars"));
            seen += text.find("are not glued along two edges") != std::string::npos ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(seen, 0U);
}

TEST(PseudoCertificate, TheCoreIsTheLoop) {
  const std::string refused = "REFUTED: collars: collar 0";
  NetDocument net = good();
  std::vector<std::uint32_t>& word = (*net.collars)[0].core;
  const std::vector<std::uint32_t> core = word;
  word.insert(word.end(), core.begin(), core.end());
  EXPECT_THAT(outcome(net), HasSubstr(refused));  // The core squared: no longer than ε either.
  EXPECT_THAT(outcome(net), HasSubstr("is not the core"));
  word.clear();
  EXPECT_THAT(outcome(net), HasSubstr("is not the core"));
  // Another curve through the same tile: some side pairing.
  for (const certify::NetDocument::Label& label : net.labels) {
    const std::uint32_t tile = net.charts[net.vertices[(*net.collars)[0].vertices[0]].chart].tile;
    if (net.charts[label.from].tile != tile || net.charts[label.to].tile != tile || label.word.empty()) continue;
    const bool same = label.word == core;
    word = label.word;
    if (!same && word.size() != core.size()) {
      EXPECT_NE(outcome(net), "VERIFIED");
    }
  }
  // The inverse is the same curve.
  word = letters_of(reversed(with_cuffs({Rational(1, 100), Rational(1, 10)}), word_of_letters(core)));
  EXPECT_EQ(outcome(net), "VERIFIED");
}

TEST(PseudoCertificate, TheLengthIsEnclosed) {
  NetDocument net = good();
  auto& length = (*net.collars)[1].length;
  length = {0, 1};
  EXPECT_EQ(outcome(net), "VERIFIED");
  length = {0.11, 0.2};
  EXPECT_THAT(outcome(net), HasSubstr("less than the file says"));
  length = {0, 0.09};
  EXPECT_THAT(outcome(net), HasSubstr("more than the file says"));
}

TEST(PseudoCertificate, TheCoreIsNoLongerThanEpsilon) {
  NetDocument net = compute_net(with_cuffs({Rational(1, 10)}), Length("0.34"), kPseudo).document;
  net.epsilon = "0.05";
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: collars: collar 0"));
  EXPECT_THAT(outcome(net), HasSubstr("greater than epsilon"));
}

/// Vertex p of collar 1 moved by a hyperbolic distance in a direction; its coordinate was 0. Labels fit as before.
std::string outcome_moved(double distance, double angle) {
  NetDocument net = good();
  certify::NetDocument::Vertex& vertex = net.vertices[(*net.collars)[1].vertices[0]];
  EXPECT_EQ(vertex.x, 0);
  EXPECT_EQ(vertex.y, 0);
  vertex.x = std::tanh(distance / 2) * std::cos(angle);
  vertex.y = std::tanh(distance / 2) * std::sin(angle);
  return outcome(net);
}

TEST(PseudoCertificate, VerticesLieOnBothSidesInTheThickPartAndCover) {
  // d_ε = arcosh(sinh 0.17/sinh 0.05) = 1.897…. The vertex moves in every direction: into the thin part, too far away
  // from it, and across the core.
  std::size_t thin = 0;
  std::size_t uncovering = 0;
  std::size_t same_side = 0;
  std::size_t fine = 0;
  constexpr int kDirections = 64;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * k / kDirections;
    const auto says = [&](double distance, const char* text) {
      return outcome_moved(distance, angle).find(text) != std::string::npos ? 1u : 0u;
    };
    thin += says(1e-6, "is in the epsilon-thin part");
    uncovering += says(0.5, "does not cover the thick part");
    same_side += says(4, "are not on different sides");
    fine += says(1e-13, "VERIFIED");
  }
  EXPECT_GT(thin, kDirections / 4);
  EXPECT_LT(thin, 3 * kDirections / 4);
  EXPECT_GT(uncovering, kDirections / 4);
  EXPECT_GT(same_side, 0U);
  EXPECT_EQ(fine, kDirections);
}

TEST(PseudoCertificate, ACollarThatIsNotNamedIsNotCovered) {
  NetDocument net = good();
  net.collars->erase(net.collars->begin());
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: covering"));
  net.collars.reset();
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: covering"));
  // In a collar as wide as ε/4 the triangles are small, but the two vertices are close.
  net = compute_net(with_cuffs({Rational(2499999, 10000000)}), Length("0.25"), kPseudo).document;
  EXPECT_EQ(outcome(net), "VERIFIED");
  net.collars->clear();
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: packing"));
}

TEST(PseudoCertificate, VerticesOfNoCollarAreThick) {
  // A net of the whole surface has vertices in the thin part.
  NetDocument net = compute_net(with_cuffs({Rational(1, 10)}), Length("0.34")).document;
  EXPECT_EQ(outcome(net), "VERIFIED");
  net.collars.emplace();
  EXPECT_THAT(outcome(net), HasSubstr("REFUTED: thick: the edge of dart"));
}

TEST(PseudoCertificate, TrianglesOfCollarsNeedACircumcircle) {
  // An annulus cut by edges that turn around the core: the triangles are not Delaunay, and at last have no
  // circumcircle.
  const Surface surface = with_cuffs({Rational(3, 10)});
  const Length epsilon("0.34");
  Triangulation triangulation(surface);
  make_delaunay(triangulation);
  Collars collars(triangulation, epsilon);
  (void)refine(triangulation, epsilon, kPseudo, {}, &collars);
  ASSERT_EQ(collars.count(), 1U);
  std::string covering;
  for (int turns = 0; turns < 100 && covering.find("has no circumcircle") == std::string::npos; ++turns) {
    // Of the two edges from side to side, the one that comes after the loop, always.
    const auto [t, u] = collars.documents().front().triangles;
    std::uint32_t loop = 0;
    const auto& v = triangulation.triangle(TriangleId(t)).vertex;
    while (v[loop] != v[next(loop)]) ++loop;
    (void)flip(triangulation, make_dart(TriangleId(t), next(loop)));
    NetDocument net = net_document(triangulation, epsilon);
    net.collars = collars.documents();
    const Certificate certificate = certify::check(net, {.threads = 1});
    ASSERT_EQ(certificate.rules.size(), 9U) << certificate.message;
    EXPECT_EQ(certificate.rules[3].verdict, Verdict::verified);
    covering = certificate.rules[6].text;
  }
  EXPECT_THAT(covering, HasSubstr("has no circumcircle"));
}

TEST(PseudoCertificate, FewBitsLeaveShortCoresUndecided) {
  EXPECT_THAT(outcome(good(), 64), HasSubstr("UNDECIDED: collars: collar 0"));
  EXPECT_EQ(outcome(good(), 128), "VERIFIED");
}

TEST(PseudoCertificate, WhatIsNoCollarIsMalformed) {
  const auto broken = [](const auto& change) {
    NetDocument net = good();
    change(net.collars->front());
    EXPECT_EQ(certify::check(net).rule, "structure");
    return outcome(net);
  };
  const std::string malformed = "MALFORMED: collars[0]: ";
  EXPECT_THAT(broken([](certify::NetDocument::Collar& c) { c.vertices[1] = 100000; }),
              HasSubstr(malformed + "vertex 100000"));
  EXPECT_THAT(broken([](certify::NetDocument::Collar& c) { c.triangles[0] = 100000; }),
              HasSubstr(malformed + "triangle 100000"));
  EXPECT_THAT(broken([](certify::NetDocument::Collar& c) { c.core = {1000}; }), HasSubstr(malformed + "side 1000"));
  EXPECT_THAT(broken([](certify::NetDocument::Collar& c) { c.core = {13}; }),
              HasSubstr(malformed + "letter 0 is side 13 of tile 1"));
  EXPECT_THAT(broken([](certify::NetDocument::Collar& c) { std::swap(c.length[0], c.length[1]); }),
              HasSubstr("is not an interval"));
  for (const double number : {-1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THAT(broken([&](certify::NetDocument::Collar& c) { c.length[0] = number; }),
                HasSubstr("is not an interval"));
    EXPECT_THAT(broken([&](certify::NetDocument::Collar& c) { c.length[1] = number; }),
                HasSubstr("is not an interval"));
  }
}

TEST(PseudoCertificate, MembersOfCollarsAreRead) {
  std::ostringstream out;
  certify::write_file(good(), out);
  const std::string text = out.str();
  const auto complaint = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.rfind(from), from.size(), to);
    try {
      (void)certify::parse_file<certify::NetDocument>(changed, "test");
    } catch (const certify::MalformedError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(complaint("\"core\"", "\"core\""), "none");
  EXPECT_THAT(complaint("\"core\"", "\"cure\""), HasSubstr("unknown member \"cure\""));
  EXPECT_THAT(complaint("\"triangles\":[", "\"triangles\":[0,"), HasSubstr("too many elements"));
  EXPECT_THAT(complaint("\"vertices\":[", "\"vertices\":[-"), HasSubstr("an index"));
  EXPECT_THAT(complaint("\"length\":[", "\"length\":[\"0\","), HasSubstr("a finite binary64"));
  EXPECT_THAT(complaint("\"collars\"", "\"collar\""), HasSubstr("unknown member \"collar\""));
}

}  // namespace
}  // namespace epsnet::pseudo_test
