#include <gtest/gtest.h>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/claims/geodesics/crossing_search.h"
#include "certify/net/numbering.h"
#include "tests/certify/lifted_reference.h"
#include "tests/certify/turned.h"

/// Rule `complete`: what it looks at against its definition in docs/proof.md, and lengths that are nearly the bound.
namespace epsnet::certify::completeness_test {
namespace {

GeodesicsDocument load(const std::string& name) {
  return read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/" + name);
}

std::string outcome(const GeodesicsDocument& document) {
  const Certificate certificate = check(document, {.threads = 2, .max_precision = 1024});
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

/// The list without geodesic i.
GeodesicsDocument without(GeodesicsDocument document, std::uint32_t i) {
  document.geodesics.erase(document.geodesics.begin() + i);
  document.clusters.clear();
  for (std::uint32_t k = 0; k < document.geodesics.size(); ++k) document.clusters.push_back({k, 1, true});
  for (GeodesicsDocument::Piece& piece : document.pieces) {
    std::erase_if(piece.boundaries, [&](const auto& side) { return side.first == i; });
    for (auto& [geodesic, side] : piece.boundaries) geodesic -= geodesic > i ? 1 : 0;
  }
  return document;
}

/// How many loop edges are inside the collars of their cores by this margin, in long double.
std::uint64_t loops_in_collars(const NetDocument& net, Real margin) {
  const Reference reference(net);
  std::uint64_t result = 0;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t v = start(net, dart);
    if (start(net, next_dart(dart)) != v || opposite(net, dart) < dart) continue;
    const Move loop = with_sign(inverted(reference.label(corner_label(net, dart))) *
                                reference.label(corner_label(net, next_dart(dart))));
    const Real sinh_half = std::sqrt(loop.first.real() * loop.first.real() - 1);
    const Real distance = std::abs(side_of_axis(loop, Complex(net.vertices[v].x, net.vertices[v].y)));
    if (sinh_half < 1 && std::asinh(distance) + margin < std::asinh(1 / sinh_half)) ++result;
  }
  return result;
}

GeodesicsDocument bolza_systole(const std::string& name) {
  GeodesicsDocument document;
  document.net = read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
  document.geodesics = {{0, {0}, {3.057, 3.0572}, true}};
  return document;
}

TEST(Completeness, ALoopInsideItsCollarIsLookedAt) {
  for (const char* name : {"three-cuffs.json", "two-cuffs-that-differ-by-1e-14.json", "one-cuff-of-1e-3-to-6.5.json"}) {
    const GeodesicsDocument document = load(name);
    const Certificate certificate = check(document);
    EXPECT_EQ(certificate.verdict, Verdict::verified) << name;
    // Vertices are moved by less than 0.3.
    EXPECT_GE(certificate.geodesics->deep_vertices, loops_in_collars(document.net, 0.3)) << name;
    EXPECT_LE(certificate.geodesics->deep_vertices, loops_in_collars(document.net, -0.3)) << name;
    EXPECT_GT(certificate.geodesics->deep_vertices, 2U) << name;
  }
}

/// A net in one chart, with a chart for every vertex, of which it is the centre.
NetDocument with_charts_of_their_own(const NetDocument& net) {
  NetDocument result = net;
  result.labels.clear();
  for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
    const NetDocument::Vertex& vertex = net.vertices[v];
    result.charts.push_back({net.charts[0].tile, {mpq_class(vertex.x), mpq_class(vertex.y)}});
    result.vertices[v] = {0, 0, v + 1};
  }
  for (NetDocument::Triangle& triangle : result.triangles) {
    for (std::size_t i = 1; i < 3; ++i) {
      std::uint32_t& label = triangle.label[i - 1];
      std::vector<std::uint32_t> word;
      if (label != 0) word = net.labels[label - 1].word;
      result.labels.push_back({triangle.vertex[i] + 1, triangle.vertex[0] + 1, std::move(word)});
      label = static_cast<std::uint32_t>(result.labels.size());
    }
  }
  return result;
}

TEST(Completeness, AnEdgeBetweenTwoVerticesMakesNoneDeep) {
  // From chart to chart an edge is a translation, shorter than many a closed geodesic.
  GeodesicsDocument none = bolza_systole("octagon-33-vertices.json");
  ASSERT_EQ(none.net.charts.size(), 1U);
  none.net = with_charts_of_their_own(none.net);
  none.claim = GeodesicsDocument::Claim::spectrum;
  none.geodesics.clear();
  none.up_to = "0.4";
  const Certificate certificate = check(none);
  EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
  EXPECT_EQ(certificate.geodesics->deep_vertices, 0U);
}

TEST(Completeness, FindsAGeodesicThatOnlyTheWholeBoundReaches) {
  // A net of one vertex, ε little more than its covering radius, and a systole as far from the vertex as can be. The
  // surface, of cuffs 0.739, 0.909, 1.331
  // and twists 0.026, 0.327, 0.034 on the graph 0-0 0-1 1-1, was found by trying many.
  const GeodesicsDocument systole = load("systole-far-from-the-only-vertex.json");
  ASSERT_EQ(systole.net.vertices.size(), 1U);
  EXPECT_EQ(outcome(systole), "VERIFIED");
  GeodesicsDocument spectrum = systole;
  spectrum.claim = GeodesicsDocument::Claim::spectrum;
  spectrum.clusters = {{0, 1, true}};
  spectrum.up_to = "0.739001";
  EXPECT_EQ(outcome(spectrum), "VERIFIED");
  EXPECT_EQ(outcome(without(spectrum, 0)), "REFUTED: complete");
  spectrum.up_to = "0.738999";
  EXPECT_EQ(outcome(spectrum), "REFUTED: geodesics");
  EXPECT_EQ(outcome(without(spectrum, 0)), "VERIFIED");
}

TEST(Completeness, IsOpenWhereBallsDoNotTellALengthFromTheBound) {
  // To 64 bits it is not known whether systoles, of length 2 arcosh(1 + √2) =
  // 3.057141838961996322544912369587…, are within these bounds.
  GeodesicsDocument none = bolza_systole("regular-2-10-vertices.json");
  none.claim = GeodesicsDocument::Claim::spectrum;
  none.geodesics.clear();
  for (const auto& [up_to, expected] : {std::pair{"3.057141838961996322544912369", "VERIFIED"},
                                        {"3.057141838961996322544912370", "REFUTED: complete"}}) {
    none.up_to = up_to;
    const Certificate coarse = check(none, {.threads = 1, .max_precision = 64});
    EXPECT_EQ(coarse.verdict, Verdict::undecided) << up_to;
    EXPECT_EQ(coarse.rule, "complete") << up_to;
    EXPECT_EQ(outcome(none), expected) << up_to;
  }
}

// The bound 2 arsinh 1 is a length itself on some surfaces, and nearly one on others.

TEST(Completeness, ACurveOfLength2Arsinh1IsSmallAndOneThatIsLongerBy1e20IsNot) {
  const GeodesicsDocument exactly = load("one-curve-of-2-arsinh-1.json");
  const GeodesicsDocument less = load("one-curve-of-2-arsinh-1-less-1e-20.json");
  const GeodesicsDocument more = load("no-curve-of-2-arsinh-1-and-1e-20-more.json");
  EXPECT_EQ(outcome(exactly), "VERIFIED");
  EXPECT_EQ(outcome(without(exactly, 0)), "REFUTED: complete");
  EXPECT_EQ(outcome(less), "VERIFIED");
  EXPECT_EQ(outcome(without(less, 0)), "REFUTED: complete");
  EXPECT_EQ(outcome(more), "VERIFIED");
  GeodesicsDocument listed = more;
  listed.geodesics = exactly.geodesics;
  listed.clusters = exactly.clusters;
  listed.pieces = exactly.pieces;
  EXPECT_EQ(outcome(listed), "REFUTED: geodesics") << "longer than 2 arsinh 1";
  const auto with_64_bits = [](const GeodesicsDocument& document) {
    const Certificate certificate = check(document, {.threads = 1, .max_precision = 64});
    return std::string(name(certificate.verdict)) + ": " + certificate.rule;
  };
  EXPECT_EQ(with_64_bits(listed), "REFUTED: geodesics") << "by exact numbers alone";
  // A conjugate whose word is too long for those.
  std::vector<std::uint32_t>& word = listed.geodesics[0].word;
  const std::vector<std::uint32_t> short_word = word;
  word.insert(word.begin(), 100'000, 1);
  word.insert(word.end(), 100'000, SurfaceSides(listed.net.surface).partner[1]);
  listed.geodesics[0].length = {1, 3};
  EXPECT_EQ(with_64_bits(listed), "UNDECIDED: geodesics");
  listed.geodesics[0] = exactly.geodesics[0];
  ASSERT_EQ(listed.geodesics[0].word, short_word);
  // It is the shortest of its surface, and no spectrum up to less has it.
  listed.claim = GeodesicsDocument::Claim::spectrum;
  listed.pieces.clear();
  listed.up_to = "1.76274717404";
  EXPECT_EQ(outcome(listed), "VERIFIED");
  EXPECT_EQ(outcome(without(listed, 0)), "REFUTED: complete");
  listed.up_to = "1.76274717403";
  EXPECT_EQ(outcome(listed), "REFUTED: geodesics");
  EXPECT_EQ(outcome(without(listed, 0)), "VERIFIED");
}

// Balls of few bits: they decide nothing, or less and less, but nothing wrongly.

/// cosh(L/2) of the document's claim, by its definition.
Ball cosh_half_bound(const GeodesicsDocument& document, const LiftedNet& lifted) {
  if (document.claim == GeodesicsDocument::Claim::systole) return cosh_half_length(lifted.element(0));
  if (document.claim == GeodesicsDocument::Claim::thick_thin) return sqrt(Ball::exactly(2));
  return cosh(half(Ball::rounded(decimal(document.up_to))));
}

/// What the search says at one precision, of a list of elements known to that, or less, somewhere in their balls.
Verdict verdict_at(const GeodesicsDocument& document, slong precision, std::mt19937* random = nullptr) {
  const Precision scope(precision);
  const LiftedNet lifted(document.net, document.geodesics, precision);
  const auto firsts = first_darts(lifted.net());
  const auto member = [&](std::size_t i) -> CrossingPass::Member {
    BallIsometry element = lifted.element(i);
    if (random != nullptr) element = blurred_somehow(element, static_cast<int>((*random)() % 64), *random);
    return {firsts[document.geodesics[i].vertex], element};
  };
  const CrossingPass pass(document, lifted.evaluator(), lifted.plane(), cosh_half_bound(document, lifted), member, 1);
  if (!pass.complete()) return Verdict::undecided;
  const Completeness found = pass.search(20'000, 1, [](double) {});
  EXPECT_EQ(found.complete == Tri::no, !found.missing.empty());
  return found.complete == Tri::yes  ? Verdict::verified
         : found.complete == Tri::no ? Verdict::refuted
                                     : Verdict::undecided;
}

/// The claim that geodesic i is a systole.
GeodesicsDocument as_systole(GeodesicsDocument document, std::size_t i) {
  document.claim = GeodesicsDocument::Claim::systole;
  document.geodesics = {document.geodesics[i]};
  document.clusters.clear();
  document.pieces.clear();
  document.up_to.clear();
  return document;
}

GeodesicsDocument as_spectrum(GeodesicsDocument document, const std::string& up_to) {
  document.claim = GeodesicsDocument::Claim::spectrum;
  document.pieces.clear();
  document.up_to = up_to;
  return document;
}

struct Answers {
  int decided = 0;
  int open = 0;
};

/// With all numbers of bits up to 96, and lists known to fewer, every answer is the one expected or none.
Answers answers(const GeodesicsDocument& document, Verdict expected, const std::string& what) {
  Answers result;
  std::mt19937 random(1);
  const auto ask = [&](slong precision, std::mt19937* blur) {
    const Verdict found = verdict_at(document, precision, blur);
    EXPECT_TRUE(found == expected || found == Verdict::undecided) << what << ", " << precision << " bits";
    ++(found == expected ? result.decided : result.open);
  };
  for (slong precision = 8; precision <= 96; ++precision) ask(precision, nullptr);
  for (int trial = 0; trial < 10; ++trial) {
    ask(128, &random);
    ask(64, &random);
  }
  return result;
}

TEST(DeepCompleteness, IsNotSaidOfSmallCurvesWithFewBits) {
  for (const char* name : {"three-cuffs.json", "one-curve-of-2-arsinh-1.json", "two-cuffs-that-differ-by-1e-14.json"}) {
    const GeodesicsDocument good = load(name);
    EXPECT_GT(answers(good, Verdict::verified, name).open, 10) << name;
    for (std::uint32_t i = 0; i < good.geodesics.size(); ++i) {
      EXPECT_GT(answers(without(good, i), Verdict::refuted, name).decided, 10) << name << " without " << i;
    }
  }
}

TEST(DeepCompleteness, OfASystoleIsNotSaidWithFewBits) {
  const GeodesicsDocument cuffs = load("two-cuffs-that-differ-by-1e-14.json");
  EXPECT_EQ(outcome(as_systole(cuffs, 0)), "VERIFIED");
  EXPECT_EQ(outcome(as_systole(cuffs, 1)), "REFUTED: complete");
  const GeodesicsDocument systole = bolza_systole("regular-2-10-vertices.json");
  for (const auto& [document, expected] : {std::pair{as_systole(cuffs, 0), Verdict::verified},
                                           {as_systole(cuffs, 1), Verdict::refuted},
                                           {as_systole(cuffs, 2), Verdict::refuted},
                                           {systole, Verdict::verified}}) {
    const Answers found = answers(document, expected, "systole");
    EXPECT_GT(found.decided, 0);
    EXPECT_GT(found.decided + found.open, 20);
  }
}

TEST(Completeness, KnowsALoopByTheLabelsOfBothOfItsEnds) {
  // Loops are turned until they lead from corner 1 to corner 2, whose labels are none of them the identity.
  GeodesicsDocument cuffs = load("two-cuffs-that-differ-by-1e-14.json");
  NetDocument& net = cuffs.net;
  int loops = 0;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const auto has_loop = [&](std::uint32_t dart) {
      return start(net, dart) == start(net, next_dart(dart)) && dart < opposite(net, dart);
    };
    if (!has_loop(3 * t) && !has_loop(3 * t + 1) && !has_loop(3 * t + 2)) continue;
    for (; !has_loop(3 * t + 1); net = turned(net, t)) {
    }
    ++loops;
  }
  EXPECT_GT(loops, 8);
  EXPECT_EQ(outcome(cuffs), "VERIFIED");
  // Where balls do not tell the two cuffs apart the words of the loops do.
  int decided = 0;
  for (slong precision = 36; precision <= 64; ++precision) {
    for (const auto& [i, expected] : {std::pair{0U, Verdict::verified}, {1U, Verdict::refuted}}) {
      const Verdict found = verdict_at(as_systole(cuffs, i), precision);
      EXPECT_TRUE(found == expected || found == Verdict::undecided) << i << ", " << precision << " bits";
      decided += found == expected ? 1 : 0;
    }
  }
  EXPECT_GT(decided, 3);
}

/// The same net with a lift of vertex v: the one across a side of its tile, in a chart of which it is the centre.
NetDocument with_lift_across(NetDocument net, std::uint32_t v, std::uint32_t side) {
  const Crossings crossings = check_surface(net.surface).crossings;
  const SurfaceSides sides(net.surface);
  const NetDocument::Vertex vertex = net.vertices[v];
  const NetDocument::Chart chart = net.charts[vertex.chart];
  EXPECT_EQ(sides.tile[side], chart.tile);
  const std::uint32_t back = sides.partner[side];
  // n/d, exactly.
  const ExactIsometry across = std::get<RationalCrossings>(crossings).exact(std::vector{side});
  const ExactIsometry to_tile = compose(across, translation_to(exact_point(chart.centre)));
  const auto place = moved(to_tile, exact_point(vertex.x, vertex.y));
  const Gaussian scaled = place.n * conjugate(place.d);
  NetDocument::Chart there{sides.tile[back],
                           {mpq_class(scaled.re, norm(place.d)), mpq_class(scaled.im, norm(place.d))}};
  there.centre.x.canonicalize();
  there.centre.y.canonicalize();
  const auto c = static_cast<std::uint32_t>(net.charts.size());
  net.charts.push_back(there);
  net.vertices[v] = {0, 0, c};
  for (NetDocument::Triangle& triangle : net.triangles) {
    for (std::size_t i = 1; i < 3; ++i) {
      if (triangle.vertex[0] != v && triangle.vertex[i] != v) continue;
      std::uint32_t& label = triangle.label[i - 1];
      std::vector<std::uint32_t> word;
      if (label != 0) word = net.labels[label - 1].word;
      if (triangle.vertex[i] == v) word.insert(word.begin(), back);
      if (triangle.vertex[0] == v) word.push_back(side);
      net.labels.push_back({net.vertices[triangle.vertex[i]].chart, net.vertices[triangle.vertex[0]].chart, word});
      label = static_cast<std::uint32_t>(net.labels.size());
    }
  }
  return net;
}

TEST(DeepCompleteness, KnowsALoopWhoseLabelsAreNoneOfThemTrivial) {
  // Cuffs so short that all vertices near them are deep: nothing but their loops is looked at. Every vertex is taken to
  // another of its lifts, and loops are turned until they lead from corner 1 to corner 2.
  std::mt19937 random(1);
  for (int trial = 0; trial < 4; ++trial) {
    GeodesicsDocument cuffs = load("two-short-cuffs-that-differ-by-1e-17.json");
    NetDocument& net = cuffs.net;
    const SurfaceSides sides(net.surface);
    for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
      for (int n = 0; n < 2; ++n) {
        const std::uint32_t tile = net.charts[net.vertices[v].chart].tile;
        const std::uint32_t side =
            sides.first[tile] + static_cast<std::uint32_t>(random() % net.surface.tiles[tile].size());
        net = with_lift_across(net, v, side);
        for (GeodesicsDocument::ClosedGeodesic& geodesic : cuffs.geodesics) {
          if (geodesic.vertex != v) continue;
          geodesic.word.insert(geodesic.word.begin(), sides.partner[side]);
          geodesic.word.push_back(side);
        }
      }
    }
    for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
      const auto has_loop = [&](std::uint32_t dart) { return start(net, dart) == start(net, next_dart(dart)); };
      if (!has_loop(3 * t) && !has_loop(3 * t + 1) && !has_loop(3 * t + 2)) continue;
      for (; !has_loop(3 * t + 1); net = turned(net, t)) {
      }
    }
    ASSERT_EQ(outcome(cuffs), "VERIFIED");
    int decided = 0;
    for (slong precision = 40; precision <= 64; precision += 8) {
      for (const auto& [i, expected] : {std::pair{0U, Verdict::verified}, {1U, Verdict::refuted}}) {
        const Verdict found = verdict_at(as_systole(cuffs, i), precision);
        EXPECT_TRUE(found == expected || found == Verdict::undecided) << i << ", " << precision << " bits";
        decided += found == expected ? 1 : 0;
      }
    }
    EXPECT_GT(decided, 2);
  }
}

TEST(DeepCompleteness, OfASpectrumIsNotSaidWithFewBits) {
  const GeodesicsDocument cuffs = load("two-cuffs-that-differ-by-1e-14.json");
  // Between the cuffs, below the first, above the second.
  const GeodesicsDocument one = without(without(cuffs, 2), 1);
  const GeodesicsDocument other = without(without(cuffs, 2), 0);
  for (const auto& [document, expected] : {std::pair{as_spectrum(one, "0.500000000000005"), Verdict::verified},
                                           {as_spectrum(other, "0.500000000000005"), Verdict::refuted},
                                           {as_spectrum(one, "0.50000000000002"), Verdict::refuted},
                                           {as_spectrum(without(one, 0), "0.499999999999995"), Verdict::verified},
                                           {as_spectrum(without(one, 0), "0.500000000000005"), Verdict::refuted}}) {
    const Answers found = answers(document, expected, document.up_to);
    EXPECT_GT(found.decided, 10);
    EXPECT_GT(found.open, 0);
  }
}

}  // namespace
}  // namespace epsnet::certify::completeness_test
