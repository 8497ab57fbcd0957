#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/claims/net/claim.h"
#include "certify/exact/document.h"
#include "certify/exact/isometry_rules.h"
#include "certify/exact/json.h"
#include "certify/exact/net_rules.h"
#include "certify/exact/pair_search.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "tests/certify/claim_files.h"

/// The second checker's rules of nets, each asked alone, of documents that need not be nets: as the first checker
/// answers. And what these rules are made of, by its definition.
namespace epsnet::exact::rules_test {
namespace {

using certify::NetDocument;
using certify::Verdict;
using Verdicts = std::map<std::string, Verdict>;

NetDocument load(const std::string& name) {
  return certify::read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/" + name + ".json");
}

Net parsed(const NetDocument& document) {
  std::ostringstream out;
  certify::write_file(document, out);
  return read_net(parse_json(out.str()));
}

Verdict answer(const Rule& rule) {
  try {
    rule.ask();
    return Verdict::verified;
  } catch (const Refutation&) {
    return Verdict::refuted;
  } catch (const TooLarge&) {
    return Verdict::undecided;
  }
}

/// Of all rules but `map` and `gluing`, which the others do not need.
Verdicts of_second(const Net& net) {
  NetRules<mpz_class> rules(net);
  Verdicts result;
  for (const Rule& rule : rules.rules()) {
    const std::string name = rule.name;
    if (name != "map" && name != "gluing") result[name] = answer(rule);
  }
  return result;
}

/// Of the rule `collars`, if it is one, and of those of the geometry.
Verdicts of_first(const NetDocument& document) {
  const certify::LabelParts parts{
      certify::check_surface(document.surface).crossings, certify::chart_frames(document.charts, {}), {}};
  const certify::LabelEvaluator evaluator(document, parts);
  Verdicts result;
  if (document.collars) result["collars"] = certify::check_collars(document, evaluator, parts, 8192).report.verdict;
  for (const certify::RuleReport& report : certify::check_geometry(document, evaluator, {}, 1).reports)
    result[report.rule] = report.verdict;
  return result;
}

/// The same net with its vertices in the opposite order.
NetDocument with_vertices_reversed(NetDocument document) {
  const auto last = static_cast<std::uint32_t>(document.vertices.size() - 1);
  std::reverse(document.vertices.begin(), document.vertices.end());
  for (NetDocument::Triangle& triangle : document.triangles) {
    for (std::uint32_t& v : triangle.vertex) v = last - v;
  }
  for (NetDocument::Collar& collar : *document.collars) {
    for (std::uint32_t& v : collar.vertices) v = last - v;
  }
  return document;
}

/// The pseudo net with the collars about geodesics of the lengths 1/8 and 1/4 of which the numbers are given.
NetDocument with_collars(const std::vector<std::size_t>& numbers) {
  NetDocument document = load("forgeries/collars");
  const std::vector<NetDocument::Collar> all = *document.collars;
  document.collars->clear();
  for (const std::size_t c : numbers) document.collars->push_back(all[c]);
  return document;
}

/// A net of one vertex as a pseudo net without collars.
NetDocument loops() {
  NetDocument document = load("certify/verified/octagon-1-vertex");
  document.collars.emplace();
  return document;
}

TEST(SecondCheckersGeometry, EachRuleAnswersAsThatOfTheFirstChecker) {
  std::mt19937 random(20261128);
  const auto between = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(random()) / 4294967296.0;
  };
  const std::vector<NetDocument> nets{load("certify/verified/octagon-9-vertices"), with_collars({}), with_collars({0}),
                                      with_collars({1}), loops()};
  std::map<std::pair<std::string, Verdict>, int> met;
  for (int k = 0; k < 200; ++k) {
    // One vertex moved, often far; of pseudo nets often one of a collar, or a neighbour onto one.
    NetDocument document = nets[static_cast<std::size_t>(k) % nets.size()];
    std::vector<std::uint32_t> order(document.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    document = certify::with_triangles_in_order(document, order);
    const std::size_t some = document.collars && random() % 2 == 0 ? 5 : document.vertices.size();
    NetDocument::Vertex& vertex = document.vertices[random() % std::min(some, document.vertices.size())];
    const double size = std::pow(10, between(-3, 0));
    vertex.x += between(-size, size);
    vertex.y += between(-size, size);
    if (vertex.x * vertex.x + vertex.y * vertex.y >= 0.98) continue;
    // Epsilon is at most ln √2 in the rule `collars`, without which the second checker knows none.
    const bool collars = document.collars && !document.collars->empty();
    document.epsilon = std::to_string(std::exp(between(std::log(0.05), std::log(collars ? 0.346 : 3))));
    const Verdicts second = of_second(parsed(document));
    for (const auto& [rule, verdict] : of_first(document)) {
      if (verdict == Verdict::undecided) continue;
      EXPECT_EQ(second.at(rule), verdict) << k << ' ' << rule << ' ' << document.epsilon;
      ++met[{rule, verdict}];
    }
  }
  for (const char* rule : {"collars", "orientation", "delaunay", "covering", "packing", "thick"}) {
    for (const Verdict verdict : {Verdict::verified, Verdict::refuted}) {
      EXPECT_GT((met[{rule, verdict}]), 3) << rule << ' ' << certify::name(verdict);
    }
  }
}

TEST(SecondCheckersGeometry, TrianglesOfCollarsNeedACircumcircleAndNoMore) {
  // A vertex of a collar moves away from the core, until the triangles of the collar have no circumcircle.
  std::map<Verdict, int> met;
  for (const std::size_t c : {0U, 1U}) {
    NetDocument document = with_collars({c});
    for (const std::size_t i : {0U, 1U}) {
      for (int k = 0; k < 40; ++k) {
        NetDocument moved = document;
        NetDocument::Vertex& vertex = moved.vertices[(*document.collars)[0].vertices[i]];
        const double r = 0.19 * (1 + k % 5);
        vertex.x = r * std::cos(M_PI / 4 * (k / 5));
        vertex.y = r * std::sin(M_PI / 4 * (k / 5));
        const Net net = parsed(moved);
        NetRules<mpz_class> rules(net);
        for (const Rule& rule : rules.rules()) {
          if (rule.name == std::string("surface")) rule.ask();
        }
        for (const std::uint32_t t : (*document.collars)[0].triangles) {
          // Three points have a circumcircle if the circle through them does not meet that of the disk.
          std::array<std::complex<double>, 3> z;
          for (std::uint32_t n = 0; n < 3; ++n) {
            const Point<mpz_class> p = rules.corner(3 * t + n);
            z[n] = {mpq_class(p.n.re, p.m).get_d(), mpq_class(p.n.im, p.m).get_d()};
          }
          const auto u = z[1] - z[0], v = z[2] - z[0];
          const double area = std::imag(std::conj(u) * v);
          const auto centre = std::complex<double>(0, 1) * (u * std::norm(v) - v * std::norm(u)) / (2 * area);
          const double reach = std::abs(z[0] + centre) + std::abs(centre);
          if (std::abs(reach - 1) < 1e-6) continue;
          EXPECT_EQ(rules.has_circumcircle(t), reach < 1) << c << i << k;
          // What has none is no smaller than any length.
          if (reach > 1) {
            EXPECT_EQ(rules.circumradius_is_less(t, squared_sinh(500)), Answer::no);
          }
          ++met[reach < 1 ? Verdict::verified : Verdict::refuted];
        }
      }
    }
  }
  for (const auto& [verdict, times] : met) EXPECT_GT(times, 10) << certify::name(verdict);
  EXPECT_EQ(met.size(), 2U);
}

/// That the rule `collars`, asked alone, answers as the first checker's.
Verdict expect_same_collars(const NetDocument& document, const Net& net) {
  const Verdict verdict = of_first(document).at("collars");
  EXPECT_EQ(of_second(net).at("collars"), verdict);
  return verdict;
}
void expect_no_collars(const NetDocument& document) {
  EXPECT_EQ(expect_same_collars(document, parsed(document)), Verdict::refuted);
}

TEST(SecondCheckersCollars, AreMadeOfTheTrianglesThatTheyName) {
  const NetDocument good = with_collars({0, 1});
  expect_same_collars(good, parsed(good));
  for (const std::size_t c : {0U, 1U}) {
    for (const std::size_t i : {0U, 1U}) {
      for (std::uint32_t t = 0; t < good.triangles.size(); t += 7) {
        NetDocument document = good;
        if (t == (*document.collars)[c].triangles[i]) continue;
        (*document.collars)[c].triangles[i] = t;
        expect_no_collars(document);
      }
      // A copy of a vertex at one corner, with a larger or a smaller number.
      for (const bool reversed : {false, true}) {
        for (const std::size_t corner : {0U, 1U, 2U}) {
          NetDocument document = good;
          std::uint32_t& vertex = document.triangles[(*good.collars)[c].triangles[i]].vertex[corner];
          document.vertices.push_back(document.vertices[vertex]);
          vertex = static_cast<std::uint32_t>(document.vertices.size() - 1);
          if (reversed) document = with_vertices_reversed(document);
          expect_no_collars(document);
        }
      }
    }
  }
}

TEST(SecondCheckersCollars, AreAnnuliOfTwoTrianglesWithTwoEdgesInCommon) {
  const NetDocument good = with_collars({0, 1});
  const auto last = static_cast<std::uint32_t>(3 * good.triangles.size() - 1);
  for (const std::size_t c : {0U, 1U}) {
    for (const std::uint32_t t : (*good.collars)[c].triangles) {
      for (std::uint32_t dart = 3 * t; dart < 3 * t + 3; ++dart) {
        for (const std::uint32_t elsewhere : {0U, last}) {
          NetDocument document = good;
          document.triangles[t].opposite[dart % 3] = elsewhere;
          expect_same_collars(document, parsed(document));
        }
      }
    }
    const std::uint32_t first = (*good.collars)[c].triangles[0];
    std::uint32_t loop = 3 * first;
    while (certify::start(good, loop) != certify::start(good, certify::next_dart(loop))) ++loop;
    for (const std::uint32_t dart : {certify::next_dart(loop), certify::previous_dart(loop)}) {
      for (const std::uint32_t elsewhere : {0U, last}) {
        NetDocument document = good;
        document.triangles[first].opposite[dart % 3] = elsewhere;
        expect_no_collars(document);
      }
    }
  }
}

TEST(SecondCheckersCollars, HaveTheirVerticesOnDifferentSidesOfTheCoreWhereverTheyAre) {
  std::map<Verdict, int> met;
  for (const std::size_t c : {0U, 1U}) {
    for (const std::size_t i : {0U, 1U}) {
      for (int k = 0; k < 36; ++k) {
        NetDocument document = with_collars({c});
        NetDocument::Vertex& vertex = document.vertices[(*document.collars)[0].vertices[i]];
        const double r = std::array{0.003, 0.02, 0.1}[static_cast<std::size_t>(k % 3)];
        vertex.x = r * std::cos(M_PI / 6 * k + 0.1);
        vertex.y = r * std::sin(M_PI / 6 * k + 0.1);
        ++met[expect_same_collars(document, parsed(document))];
      }
    }
    // One vertex where a lift of the other one is, which is thick and covers as before, only on the other side.
    NetDocument document = with_collars({c});
    const Net net = parsed(document);
    NetRules<mpz_class> rules(net);
    for (const Rule& rule : rules.rules()) {
      if (rule.name == std::string("surface")) rule.ask();
    }
    const auto& [p, q] = (*document.collars)[0].vertices;
    Index far = 3 * (*document.collars)[0].triangles[0];
    while (certify::start(document, far) != q) ++far;
    ASSERT_EQ(net.vertices[rules.start(far / 3 * 3)].chart, net.vertices[p].chart);
    const Point<mpz_class> z = rules.corner(far);
    document.vertices[p].x = mpq_class(z.n.re, z.m).get_d();
    document.vertices[p].y = mpq_class(z.n.im, z.m).get_d();
    expect_no_collars(document);
  }
  EXPECT_GT(met[Verdict::verified], 10);
  EXPECT_GT(met[Verdict::refuted], 10);
}

/// An octagon whose angles add up to 2π, with the symmetries of a square.
Net square_octagon(const std::vector<std::array<Index, 2>>& pairs) {
  Net net;
  net.epsilon = 1;
  auto& tile = net.tiles.emplace_back();
  for (const auto& [x, y] : {std::pair{5, -4}, {5, 4}, {4, 5}, {-4, 5}, {-5, 4}, {-5, -4}, {-4, -5}, {4, -5}})
    tile.push_back(RationalPoint{{x, y}, 7});
  for (const auto& [s, other] : pairs) net.gluing.push_back({0, s, 0, other});
  return net;
}

/// Sides 0 and 2, 1 and 3: p to 0, half a turn, 0 to q′.
TEST(SecondCheckersRationalCrossings, TakeTheEndsOfSidesToThoseOfTheirPartners) {
  for (const Net& net :
       {square_octagon({{0, 4}, {1, 5}, {2, 6}, {3, 7}}), square_octagon({{0, 2}, {1, 3}, {4, 6}, {5, 7}})}) {
    NetRules<mpz_class> rules(net);
    rules.rules()[0].ask();
    const auto start = [&](Index s) { return net.tiles[rules.tile_of(s)][rules.vertex_of(s)]; };
    const auto end = [&](Index s) { return start(rules.side_after(s)); };
    for (Index s = 0; s < rules.sides(); ++s) {
      const Index other = rules.partner(s);
      const Isometry<mpz_class> g = rules.value({s});
      EXPECT_EQ(sgn(mpz_class(norm(g.a) - norm(g.b))), 1) << s;
      EXPECT_EQ(sgn(mpz_class(squared_difference(rules.image(g, start(s)), end(other)))), 0) << s;
      EXPECT_EQ(sgn(mpz_class(squared_difference(rules.image(g, end(s)), start(other)))), 0) << s;
    }
  }
}

TEST(SecondCheckersLabels, AreTheValuesOfTheirWordsBetweenTheirCharts) {
  const Net net = parsed(load("forgeries/collars"));
  NetRules<mpz_class> rules(net);
  for (const Rule& rule : rules.rules()) {
    if (rule.name == std::string("surface")) rule.ask();
  }
  // Asked for in any order, and twice.
  for (const bool again : {false, true}) {
    const auto count = static_cast<Index>(net.labels.size());
    for (Index k = 0; k < count; ++k) {
      const Index n = k * 5 % count;
      const Label& label = net.labels[n];
      Isometry<mpz_class> value = rules.frame(label.from);
      for (const Index side : label.word) value = compose(rules.value({side}), value);
      value = compose(inverse(rules.frame(label.to)), value);
      EXPECT_TRUE(are_equal(rules.label(n + 1), value)) << k << again;
    }
    EXPECT_TRUE(is_identity(rules.label(0)));
  }
}

using RationalIsometry = Isometry<mpz_class>;

RationalIsometry conjugated(const RationalIsometry& f, const RationalIsometry& g) {
  return compose(f, compose(g, inverse(f)));
}

RationalIsometry random_isometry(std::mt19937& random) {
  const auto number = [&] { return static_cast<long>(random() % 19) - 9; };
  for (;;) {
    const RationalIsometry f{{number(), number()}, {number(), number()}};
    if (norm(f.a) > norm(f.b)) return f;
  }
}

/// The image of 1 or −1.
std::complex<double> at_end(const RationalIsometry& f, int end) {
  const std::complex<double> a(f.a.re.get_d(), f.a.im.get_d()), b(f.b.re.get_d(), f.b.im.get_d());
  const double z = end;
  return (a * z + b) / (std::conj(b) * z + std::conj(a));
}

TEST(Conjugation, TheCrossingSignIsThatOfTheEndsOfTheAxes) {
  // Both move points along the images of the real line under isometries f and g. The axes cross if the ends of one lie
  // on both sides of the other, and the sign says on which the end is to which it moves points.
  std::mt19937 random(39);
  std::map<int, int> met;
  for (int k = 0; k < 1000; ++k) {
    const RationalIsometry f = random_isometry(random);
    const RationalIsometry g = random_isometry(random);
    const RationalIsometry x = conjugated(f, {{5, 0}, {1 + k % 4, 0}});
    const RationalIsometry y = conjugated(g, {{7, 0}, {1 + k % 5, 0}});
    // Seen from the first axis: the ends of the other, above the real line or below.
    const RationalIsometry h = compose(inverse(f), g);
    const double ahead = at_end(h, 1).imag();
    const double behind = at_end(h, -1).imag();
    if (std::abs(ahead) < 1e-9 || std::abs(behind) < 1e-9) continue;
    const int expected = (ahead > 0) == (behind > 0) ? 0 : ahead > 0 ? -1 : 1;
    EXPECT_EQ(crossing_sign(x, y), expected) << k;
    EXPECT_EQ(crossing_sign(y, x), -expected) << k;
    ++met[expected];
    // Axes with an end in common do not cross: a parabolic element that fixes 1 takes one to the other.
    const RationalIsometry fixes{{1, k + 1}, {0, -(k + 1)}};
    EXPECT_EQ(crossing_sign(x, conjugated(f, conjugated(fixes, {{3, 0}, {1, 0}}))), 0) << k;
  }
  for (const int sign : {-1, 0, 1}) EXPECT_GT(met[sign], 50) << sign;
}

bool may_be_equal(const Motion& f, const Motion& g) { return may_be_identity(compose(inverse(f), g)); }
Motion negated(const Motion& f) { return {-f.a, -f.b}; }

TEST(SecondCheckersPairs, AreMovedByIsometriesAndCarryAllElementsAlong) {
  std::mt19937 random(41);
  int crossing = 0;
  for (int k = 0; k < 300; ++k) {
    const RationalIsometry x = conjugated(random_isometry(random), {{5, 0}, {1 + k % 4, 0}});
    const RationalIsometry y = conjugated(random_isometry(random), {{7, 0}, {1 + k % 5, 0}});
    const Basis basis(enclose(x), enclose(y));
    const bool axes_cross = crossing_sign(x, y) != 0;
    EXPECT_EQ(basis.axes_cross() == Answer::yes, axes_cross) << k;
    if (!axes_cross) continue;
    ++crossing;
    // The normals are those of the isometries, whichever of their two matrices is given.
    const RationalIsometry f = random_isometry(random);
    const Motion fx = enclose(conjugated(f, x));
    const Motion fy = enclose(conjugated(f, y));
    const Basis image(fx, fy);
    for (const Basis& other : {image, Basis(negated(fx), fy), Basis(fx, negated(fy))}) {
      EXPECT_TRUE(other.may_be_image_of(basis)) << k;
      const RationalIsometry g = random_isometry(random);
      const Coordinates coordinates(enclose(g), basis);
      EXPECT_TRUE(may_be_equal(coordinates.in(basis), enclose(g))) << k;
      EXPECT_TRUE(may_be_equal(coordinates.in(other), enclose(conjugated(f, g)))) << k;
    }
    // No isometry takes the axes to others with another angle, or elements to longer ones.
    if (!may_be_equal(basis.uv, 0)) {
      EXPECT_FALSE(Basis(fx, inverse(fy)).may_be_image_of(basis)) << k;
    }
    EXPECT_FALSE(Basis(compose(fx, fx), fy).may_be_image_of(basis)) << k;
    EXPECT_FALSE(Basis(fx, compose(fy, fy)).may_be_image_of(basis)) << k;
  }
  EXPECT_GT(crossing, 50);
}

}  // namespace
}  // namespace epsnet::exact::rules_test
