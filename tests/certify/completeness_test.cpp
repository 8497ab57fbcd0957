#include <gtest/gtest.h>

#include "certify/check.h"
#include "certify/claims/geodesics/completeness_check.h"
#include "certify/net/surface_sides.h"
#include "tests/certify/lifted_reference.h"
#include "tests/certify/turned.h"

/// Rule `complete`: what it looks at against its definition in docs/proof.md, and lengths that are nearly the bound.
namespace epsnet::certify {
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

struct Counts {
  std::uint64_t visits = 0;
  std::uint64_t candidates = 0;
  std::uint64_t deep = 0;
};

/// What the rule looks at, for a bound L: for a vertex that a short loop makes deep (Lemma 13) that loop; for every
/// other the lifted triangles of Lemma 15 with sinh(D/2) = sinh(L/2) cosh ε, and of the elements found those, one of
/// each two inverse ones, that are not 1 nor longer than L and whose axis comes within ε of the vertex.
Counts expected_counts(const NetDocument& net, Real bound) {
  const Reference reference(net);
  const Real epsilon = std::stold(net.epsilon);
  const Real distance_bound = 2 * std::asinh(std::sinh(bound / 2) * std::cosh(epsilon));
  const auto is_within = [&](const Move& f) { return std::abs(f.first.real()) < std::cosh(bound / 2) + 1e-12L; };
  Counts counts;
  const auto firsts = first_darts(net);
  for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
    const Complex place(net.vertices[v].x, net.vertices[v].y);
    bool deep = false;
    for (std::uint32_t dart = 0; dart < 3 * net.triangles.size() && !deep; ++dart) {
      if (start(net, dart) != v || start(net, next_dart(dart)) != v || opposite(net, dart) < dart) continue;
      const Move loop = with_sign(inverted(reference.label(corner_label(net, dart))) *
                                  reference.label(corner_label(net, next_dart(dart))));
      const Real sinh_half = std::sqrt(loop.first.real() * loop.first.real() - 1);
      deep = sinh_half < 1 && std::asinh(std::abs(side_of_axis(loop, place))) + epsilon < std::asinh(1 / sinh_half);
      if (deep && is_within(loop)) ++counts.candidates;
    }
    if (deep) {
      ++counts.deep;
      continue;
    }
    const Wanted all = wanted(reference, firsts[v], distance_bound);
    EXPECT_GT(all.gap, 1e-9) << "too near to be told in long double";
    counts.visits += all.triangles;
    for (const auto& [key, element] : all.elements) {
      const Move f = with_sign(element);
      if (f.second.imag() < -1e-12L || !is_within(f) || key == key_of({1, 0})) continue;
      if (std::abs(side_of_axis(f, place)) <= std::sinh(epsilon)) ++counts.candidates;
    }
  }
  return counts;
}

void expect_counts(const GeodesicsDocument& document, Real bound, const std::string& what) {
  const Certificate certificate = check(document, {.threads = 1});
  ASSERT_EQ(certificate.verdict, Verdict::verified) << what << ": " << certificate.message;
  const Counts expected = expected_counts(document.net, bound);
  EXPECT_EQ(certificate.geodesics->lifted_triangles, expected.visits) << what;
  EXPECT_EQ(certificate.geodesics->candidates, expected.candidates) << what;
  EXPECT_EQ(certificate.geodesics->deep_vertices, expected.deep) << what;
}

GeodesicsDocument bolza_systole(const std::string& name) {
  GeodesicsDocument document;
  document.net = read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
  document.geodesics = {{0, {0}, {3.057, 3.0572}, true}};
  return document;
}

TEST(Completeness, LooksForASystoleAtWhatTheLemmasSay) {
  expect_counts(bolza_systole("regular-2-10-vertices.json"), 2 * std::acosh(1 + std::sqrt(Real{2})), "the systole");
}

TEST(Completeness, LooksForASpectrumAtWhatTheLemmasSay) {
  for (const char* name : {"regular-2-10-vertices.json", "regular-2-4-rotated-vertices.json"}) {
    GeodesicsDocument none = bolza_systole(name);
    none.claim = GeodesicsDocument::Claim::spectrum;
    none.geodesics.clear();
    for (const char* up_to : {"3", "0.5"}) {
      none.up_to = up_to;
      expect_counts(none, std::stold(none.up_to), name);
    }
  }
}

TEST(Completeness, LooksForSmallCurvesAtWhatTheLemmasSay) {
  GeodesicsDocument cuffs = load("three-cuffs.json");
  expect_counts(cuffs, 2 * std::asinh(Real{1}), "three cuffs");
  cuffs.claim = GeodesicsDocument::Claim::spectrum;
  cuffs.pieces.clear();
  cuffs.up_to = "1.9";
  expect_counts(cuffs, std::stold(cuffs.up_to), "the spectrum of three cuffs");
  // Another radius, with which fewer vertices are deep.
  for (const char* epsilon : {"1.02", "1.05"}) {
    GeodesicsDocument wider = load("three-cuffs.json");
    wider.net.epsilon = epsilon;
    if (outcome(wider) == "VERIFIED") expect_counts(wider, 2 * std::asinh(Real{1}), epsilon);
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
  expect_counts(none, std::stold(none.up_to), "a chart for every vertex");
}

TEST(Completeness, FindsAGeodesicThatOnlyTheWholeBoundReaches) {
  // A net of one vertex, ε little more than its covering radius, and a systole as far from the vertex as can be: the
  // search finds it with the bound D of Lemma 14, and with 0.98 D no more. The surface, of cuffs 0.739, 0.909, 1.331
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

TEST(Completeness, EndsTheSearchOfAVertexAtAnElementThatIsNotDecided) {
  // Whatever is found after it: to 64 bits it is not known whether systoles, of length 2 arcosh(1 + √2) =
  // 3.057141838961996322544912369587…, are within these bounds.
  GeodesicsDocument none = bolza_systole("regular-2-10-vertices.json");
  none.claim = GeodesicsDocument::Claim::spectrum;
  none.geodesics.clear();
  none.up_to = "3.0571";
  const std::uint64_t all = check(none, {.threads = 1}).geodesics->lifted_triangles;
  for (const auto& [up_to, expected] : {std::pair{"3.057141838961996322544912369", "VERIFIED"},
                                        {"3.057141838961996322544912370", "REFUTED: complete"}}) {
    none.up_to = up_to;
    const Certificate coarse = check(none, {.threads = 1, .max_precision = 64});
    EXPECT_EQ(coarse.verdict, Verdict::undecided) << up_to;
    EXPECT_EQ(coarse.rule, "complete") << up_to;
    EXPECT_LT(coarse.geodesics->lifted_triangles, all / 2) << up_to;
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

/// What the rule says at one precision, of elements known to another one, somewhere in their balls; nothing if the
/// table of the list's chords is not complete.
std::optional<Verdict> verdict_at(const GeodesicsDocument& document, slong precision, slong of_table = 0,
                                  std::mt19937* random = nullptr) {
  const LiftedNet lifted(document.net, document.geodesics, precision);
  const LiftedNet of_list(document.net, document.geodesics, of_table == 0 ? precision : of_table);
  const auto firsts = first_darts(lifted.net());
  std::vector<ChordTable::Member> members;
  for (std::size_t i = 0; i < document.geodesics.size(); ++i) {
    members.push_back({firsts[document.geodesics[i].vertex], of_list.element(i)});
    BallIsometry& element = members.back().element;
    if (random != nullptr) element = blurred_somehow(element, static_cast<int>((*random)() % 64), *random);
  }
  const ChordTable table(of_list.plane(), std::move(members), 1);
  if (!table.complete()) return std::nullopt;
  CompletenessCheck check(document, lifted.evaluator(), {.max_visits = 20'000});
  return check.check(lifted.plane(), table, 1).verdict;
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

/// What the rule looks at with another ε in the file, at one precision.
Counts counts_at(GeodesicsDocument document, const mpq_class& epsilon, slong precision) {
  document.net.epsilon = epsilon.get_str();
  const LiftedNet lifted(document.net, precision);
  const ChordTable table(lifted.plane(), {}, 1);
  CompletenessCheck check(document, lifted.evaluator(), {.max_visits = 20'000});
  (void)check.check(lifted.plane(), table, 1);
  return {check.visits(), check.candidates(), check.deep_vertices()};
}

/// Two numbers that differ by 2^−k, between which the count changes.
std::array<mpq_class, 2> where_it_changes(mpq_class low, mpq_class high, int k,
                                          const std::function<std::uint64_t(const mpq_class&)>& count) {
  const std::uint64_t before = count(low);
  EXPECT_NE(count(high), before);
  for (; k > 0; --k) {
    const mpq_class middle = (low + high) / 2;
    (count(middle) == before ? low : high) = middle;
  }
  return {low, high};
}

TEST(Completeness, AVertexIsDeepAndAnAxisFarOnlyForCertain) {
  GeodesicsDocument none = load("three-cuffs.json");
  none.geodesics.clear();
  const auto deep = [&](const mpq_class& epsilon, slong precision) { return counts_at(none, epsilon, precision).deep; };
  const auto edge = where_it_changes({1, 2}, 2, 80, [&](const mpq_class& x) { return deep(x, 256); });
  EXPECT_GT(deep(edge[0], 256), deep(edge[1], 256)) << "with a larger radius less is deep";
  for (slong precision = 24; precision <= 64; precision += 8) EXPECT_LE(deep(edge[1], precision), deep(edge[1], 256));

  GeodesicsDocument curve = as_spectrum(load("one-curve-of-2-arsinh-1.json"), "1.77");
  curve.geodesics.clear();
  const auto near = [&](const mpq_class& epsilon, slong precision) {
    return counts_at(curve, epsilon, precision).candidates;
  };
  const auto reach =
      where_it_changes(mpq_class(5, 8), mpq_class(11, 16), 64, [&](const mpq_class& x) { return near(x, 256); });
  EXPECT_LT(near(reach[0], 256), near(reach[1], 256)) << "with a larger radius more is near";
  for (slong precision = 52; precision <= 64; precision += 4) {
    EXPECT_GE(near(reach[1], precision), near(reach[1], 256)) << precision;
  }
}

struct Answers {
  int decided = 0;
  int open = 0;
};

/// With all numbers of bits up to 64, and others for the list, every answer is the one expected or none.
Answers answers(const GeodesicsDocument& document, Verdict expected, const std::string& what) {
  Answers result;
  std::mt19937 random(1);
  const auto ask = [&](slong precision, slong of_table, std::mt19937* blur) {
    const auto found = verdict_at(document, precision, of_table, blur);
    if (!found) return;
    EXPECT_TRUE(*found == expected || *found == Verdict::undecided)
        << what << ", " << precision << " and " << of_table << " bits";
    ++(*found == expected ? result.decided : result.open);
  };
  for (slong precision = 8; precision <= 64; ++precision) ask(precision, precision, nullptr);
  for (slong precision = 9; precision <= 128; precision += 7) {
    ask(precision, 128, nullptr);
    ask(128, precision, nullptr);
    ask(128, 128, &random);
    ask(64, 128, &random);
  }
  return result;
}

TEST(Completeness, IsNotSaidOfSmallCurvesWithFewBits) {
  for (const char* name : {"three-cuffs.json", "one-curve-of-2-arsinh-1.json", "two-cuffs-that-differ-by-1e-14.json"}) {
    const GeodesicsDocument good = load(name);
    EXPECT_GT(answers(good, Verdict::verified, name).open, 10) << name;
    for (std::uint32_t i = 0; i < good.geodesics.size(); ++i) {
      EXPECT_GT(answers(without(good, i), Verdict::refuted, name).decided, 10) << name << " without " << i;
    }
  }
}

TEST(Completeness, OfASystoleIsNotSaidWithFewBits) {
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
      const auto found = verdict_at(as_systole(cuffs, i), precision, 128);
      ASSERT_TRUE(found.has_value());
      EXPECT_TRUE(*found == expected || *found == Verdict::undecided) << i << ", " << precision << " bits";
      decided += precision < 46 && *found == expected ? 1 : 0;
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

TEST(Completeness, KnowsALoopWhoseLabelsAreNoneOfThemTrivial) {
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
        const auto found = verdict_at(as_systole(cuffs, i), precision, 128);
        ASSERT_TRUE(found.has_value());
        EXPECT_TRUE(*found == expected || *found == Verdict::undecided) << i << ", " << precision << " bits";
        decided += precision < 60 && *found == expected ? 1 : 0;
      }
    }
    EXPECT_GT(decided, 2);
  }
}

TEST(Completeness, OfASpectrumIsNotSaidWithFewBits) {
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
}  // namespace epsnet::certify
