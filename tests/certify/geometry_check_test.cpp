#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/geometry_pass.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "tests/certify/reference.h"
#include "tests/certify/turned.h"

/// What is measured of lifted triangles, against the definitions in binary64, and the rules about them alone, on
/// documents that need not be nets.
namespace epsnet::certify::geometry_check_test {
namespace {

using Point = std::complex<double>;

NetDocument load(const std::string& name) { return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/" + name); }

struct Setting {
  explicit Setting(const NetDocument& document, const Budget& budget = {})
      : parts{check_surface(document.surface).crossings, chart_frames(document.charts, budget), budget},
        evaluator(document, parts) {}
  LabelParts parts;
  LabelEvaluator evaluator;
};

void expect_equal(const GeometryOutcome& a, const GeometryOutcome& b) {
  ASSERT_EQ(a.reports.size(), b.reports.size());
  for (std::size_t i = 0; i < a.reports.size(); ++i) EXPECT_EQ(to_string(a.reports[i]), to_string(b.reports[i]));
  EXPECT_EQ(a.ties, b.ties);
  EXPECT_EQ(a.triangles_beyond_64_bits, b.triangles_beyond_64_bits);
  EXPECT_EQ(a.max_precision, b.max_precision);
  EXPECT_EQ(a.enclosures.epsilon, b.enclosures.epsilon);
  EXPECT_EQ(a.enclosures.largest_circumradius, b.enclosures.largest_circumradius);
  EXPECT_EQ(a.enclosures.longest_edge, b.enclosures.longest_edge);
  EXPECT_EQ(a.enclosures.shortest_edge, b.enclosures.shortest_edge);
  EXPECT_EQ(a.enclosures.shortest_loop, b.enclosures.shortest_loop);
}

/// In balls alone, and the same with the filter.
GeometryOutcome outcome(const NetDocument& document, unsigned threads = 1) {
  const Setting setting(document);
  GeometryOutcome result = check_geometry(document, setting.evaluator, {.filter = false}, threads);
  expect_equal(check_geometry(document, setting.evaluator, {.filter = true}, threads), result);
  return result;
}

/// The same points with every vertex in a chart of its own, centred about half the way to it: coordinates and labels
/// are all different from 0. Needs one chart in the file for each tile, with the centre 0.
NetDocument halfway(NetDocument document) {
  const std::vector<NetDocument::Label> old_labels = document.labels;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers;
  std::vector<NetDocument::Chart> charts;
  for (NetDocument::Vertex& vertex : document.vertices) {
    const Point z(vertex.x, vertex.y);
    const Point c(vertex.x / 2 + 0.01, vertex.y / 2 - 0.02);
    const Point rest = (z - c) / (1.0 - std::conj(c) * z);
    charts.push_back({document.charts[vertex.chart].tile, {mpq_class(c.real()), mpq_class(c.imag())}});
    vertex = {rest.real(), rest.imag(), static_cast<std::uint32_t>(charts.size() - 1)};
  }
  document.charts = charts;
  document.labels.clear();
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

NetDocument nine() { return load("certify/verified/octagon-9-vertices.json"); }
NetDocument square() { return load("certify/verified/square-of-cocircular-vertices.json"); }

/// True nets, and the same with vertices moved so far that triangles turn over and edges cease to be Delaunay.
std::vector<NetDocument> documents() {
  std::vector<NetDocument> result{nine(), halfway(nine()), load("certify/verified/octagon-33-vertices.json"),
                                  halfway(load("certify/verified/octagon-33-vertices.json")), halfway(square())};
  const std::size_t count = result.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (const double by : {0.05, 0.4}) {
      NetDocument document = result[i];
      for (std::size_t v = 0; v < document.vertices.size(); v += 3) {
        NetDocument::Vertex& vertex = document.vertices[v];
        const Point z = Point(vertex.x, vertex.y) * (1 - by) + std::polar(by * 0.8, static_cast<double>(v));
        vertex.x = z.real();
        vertex.y = z.imag();
      }
      result.push_back(document);
    }
  }
  return result;
}

/// det(x, y, 1 + |z|²).
double orientation_of(const Reference& reference, std::uint32_t t) {
  std::array<Vector, 3> rows{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Complex z = reference.corner(3 * t + i);
    rows[i] = {z.real(), z.imag(), 1 + std::norm(z)};
  }
  return static_cast<double>(determinant(rows[0], rows[1], rows[2]));
}

/// Im (z3−z1)(z2−z0)/((z3−z0)(z2−z1)).
double cross_ratio_of(const Reference& reference, std::uint32_t dart) {
  const Complex z0 = reference.corner(dart), z1 = reference.far_corner(dart);
  const Complex z2 = reference.corner(next_dart(dart)), z3 = reference.corner(previous_dart(dart));
  return static_cast<double>(((z3 - z1) * (z2 - z0) / ((z3 - z0) * (z2 - z1))).imag());
}

/// sinh² of half the length of the edge of a dart.
double squared_of(const Reference& reference, std::uint32_t dart) {
  return static_cast<double>(squared_half_sinh(reference.corner(dart), reference.corner(next_dart(dart))));
}

/// 1 − |z|² of the corner where a dart starts.
double gap_of(const Reference& reference, std::uint32_t dart) {
  return static_cast<double>(1 - std::norm(reference.corner(dart)));
}

double middle(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

TEST(LiftedTriangle, MeasuresAreWhatTheyAreDefinedToBe) {
  std::map<std::string, int> met;
  for (const NetDocument& document : documents()) {
    const Reference reference(document);
    std::vector<std::uint32_t> numbers(document.labels.size());
    std::iota(numbers.begin(), numbers.end(), 1U);
    const LabelTable labels(numbers, reference.evaluator().evaluate(numbers, 128, 512, 1), numbers.size());
    const double epsilon = 0.7;
    Ball ball, half;
    arb_set_d(ball.get(), std::pow(std::sinh(epsilon), 2));
    arb_set_d(half.get(), std::pow(std::sinh(epsilon / 2), 2));
    LiftedTriangle lifted;
    for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
      lifted.load(document, labels, t, 128);
      const double orientation = orientation_of(reference, t);
      EXPECT_NEAR(middle(lifted.measure_orientation(128)), orientation, 1e-9);
      if (std::fabs(orientation) > 1e-9) {
        EXPECT_EQ(exact_orientation(document, reference.evaluator(), t), orientation > 0 ? 1 : -1);
        ++met[orientation > 0 ? "counterclockwise" : "clockwise"];
      }
      const auto& circumradius = lifted.measure_circumradius(ball.get(), 128);
      // sinh R = 2 sinh(a/2) sinh(b/2) sinh(c/2)/√(…), scaled by the gaps.
      double gaps = 1;
      std::array<double, 3> s{};
      for (std::uint32_t i = 0; i < 3; ++i) {
        s[i] = squared_of(reference, 3 * t + i);
        gaps *= std::pow(gap_of(reference, 3 * t + i), 2);
        EXPECT_NEAR(middle(lifted.gap(i)), gap_of(reference, 3 * t + i), 1e-12);
      }
      const double numerator = 4 * s[0] * s[1] * s[2] * gaps;
      const double denominator =
          (2 * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]) - s[0] * s[0] - s[1] * s[1] - s[2] * s[2]) * gaps;
      const double slack = std::pow(std::sinh(epsilon), 2) * denominator - numerator;
      EXPECT_NEAR(middle(circumradius.numerator), numerator, 1e-9 * (1 + numerator));
      EXPECT_NEAR(middle(circumradius.denominator), denominator, 1e-9);
      EXPECT_NEAR(middle(circumradius.slack), slack, 1e-9);
      ++met[denominator > 0 ? "circle" : "no circle"];
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t dart = 3 * t + i;
        const auto& edge = lifted.measure_edge(half.get(), i, 128);
        const double product = gap_of(reference, dart) * gap_of(reference, next_dart(dart));
        EXPECT_NEAR(middle(edge.gap_product), product, 1e-12);
        EXPECT_NEAR(middle(edge.lack), (std::pow(std::sinh(epsilon / 2), 2) - s[i]) * product, 1e-9);
        const Ball& ratio = lifted.measure_cross_ratio(document, labels, i, 128);
        const double cross = cross_ratio_of(reference, dart);
        if (std::fabs(cross) > 1e-6) {
          EXPECT_EQ(middle(ratio) > 0, cross > 0) << cross;
          EXPECT_EQ(exact_cross_ratio_sign(document, reference.evaluator(), dart), cross > 0 ? 1 : -1);
          ++met[cross > 0 ? "not Delaunay" : "Delaunay"];
          const std::uint32_t other = opposite(document, dart);
          const std::uint32_t here = corner_label(document, dart), there = corner_label(document, next_dart(other));
          ++met[here == there ? "common label" : here < there ? "greater label" : "smaller label"];
        }
      }
    }
  }
  for (const char* what : {"counterclockwise", "clockwise", "circle", "no circle", "Delaunay", "not Delaunay",
                           "common label", "greater label", "smaller label"}) {
    EXPECT_GT(met[what], 10) << what;
  }
}

TEST(LiftedTriangle, QuotientsContainEveryQuotient) {
  // Balls with wide radii, far apart in size: the interval contains the quotients of the ends, and is hardly wider.
  const auto ball = [](double middle, double radius) {
    Ball x, r;
    arb_set_d(x.get(), middle);
    arb_set_d(r.get(), radius);
    arb_add_error(x.get(), r.get());
    return x;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double n : {1.0 / 3, 1e-200, 7.3e150, 1.0}) {
    for (const double d : {1.0 / 7, 3e-100, 2e100, 1.0}) {
      for (const double r : {0.0, 1e-17, 1e-9, 0.5}) {
        for (const double s : {0.0, 1e-17, 1e-9, 0.5}) {
          const Interval interval = quotient(ball(n, n * r), ball(d, d * s));
          const mpq_class least = (mpq_class(n) - mpq_class(n * r)) / (mpq_class(d) + mpq_class(d * s));
          const mpq_class most = (mpq_class(n) + mpq_class(n * r)) / (mpq_class(d) - mpq_class(d * s));
          EXPECT_LE(mpq_class(interval.lower), least);
          EXPECT_GE(mpq_class(interval.upper), most);
          EXPECT_GE(interval.lower, least.get_d() * (1 - 1e-8));
          EXPECT_LE(interval.upper, most.get_d() * (1 + 1e-8));
        }
      }
    }
  }
  const auto expect = [&](const Ball& n, const Ball& d, double lower, double upper) {
    const Interval interval = quotient(n, d);
    EXPECT_EQ(interval.lower, lower);
    EXPECT_EQ(interval.upper, upper);
  };
  Ball none;
  arb_indeterminate(none.get());
  expect(none, ball(1, 0), 0, kInfinity);
  expect(ball(1, 0), none, 0, kInfinity);
  expect(ball(1, 0), ball(-1, 0.5), 0, kInfinity);
  expect(none, none, 0, kInfinity);
  EXPECT_EQ(quotient(Interval{kInfinity, kInfinity}, Interval{1, kInfinity}), (Interval{0, kInfinity}));
  // Both are nonnegative, whatever their enclosures say.
  for (const double lower : {-3.0, 0.0}) {
    EXPECT_EQ(quotient(Interval{lower, 1}, Interval{1, 2}).lower, 0);
    EXPECT_EQ(quotient(Interval{1, 2}, Interval{lower, 1}).upper, kInfinity);
  }
  EXPECT_GE(quotient(Interval{-3, -1}, Interval{1, 2}).upper, 0);
  const Interval open = quotient(ball(1, 0.5), ball(1, 2));
  EXPECT_GT(open.lower, 0.16);
  EXPECT_LE(open.lower, 0.5 / 3);
  EXPECT_EQ(open.upper, kInfinity);
  const Interval from_zero = quotient(ball(1, 2), ball(1, 0));
  EXPECT_EQ(from_zero.lower, 0);
  EXPECT_GE(from_zero.upper, 3);
  EXPECT_LT(from_zero.upper, 3.001);
}

TEST(LiftedTriangle, QuotientsAreRoundedOutward) {
  // Midpoints of 64 bits, which binary64 rounds, and radii about the size of what it leaves.
  std::mt19937_64 random(1);
  struct Number {
    Ball ball;
    mpq_class lower, upper;
  };
  const auto number = [&] {
    Number result;
    const mpz_class middle = mpz_class(static_cast<unsigned long>(random())) | (mpz_class(1) << 63);
    const auto exponent = static_cast<slong>(random() % 40) - 80;
    const Precision scope(128);
    result.ball = Ball::rounded(middle);
    arb_mul_2exp_si(result.ball.get(), result.ball.get(), exponent);
    if (random() % 4 != 0) arb_add_error_2exp_si(result.ball.get(), exponent + static_cast<slong>(random() % 14));
    // Some are nearly as wide as they are large.
    if (random() % 8 == 0) arb_add_error_2exp_si(result.ball.get(), exponent + 63);
    const mpq_class scaled = mpq_class(middle) / mpq_class(mpz_class(1) << static_cast<unsigned>(-exponent));
    const mpq_class radius(mag_get_d(arb_radref(result.ball.get())));
    result.lower = scaled - radius;
    result.upper = scaled + radius;
    return result;
  };
  for (int trial = 0; trial < 3000; ++trial) {
    const Number x = number();
    const Number y = number();
    const Interval found = quotient(x.ball, y.ball);
    EXPECT_LE(mpq_class(found.lower), x.lower / y.upper);
    EXPECT_TRUE(std::isinf(found.upper) || mpq_class(found.upper) >= x.upper / y.lower);
    EXPECT_TRUE(std::isfinite(found.upper) || y.lower * 1e9 < y.upper);
    const bool is_narrow = y.lower * 2 > y.upper && x.lower * 2 > x.upper;
    EXPECT_TRUE(!is_narrow || found.upper - found.lower < 1e-10 * found.upper);
  }
}

const RuleReport& rule(const GeometryOutcome& outcome, const std::string& name) {
  return *std::find_if(outcome.reports.begin(), outcome.reports.end(),
                       [&](const RuleReport& report) { return report.rule == name; });
}

TEST(LiftedTriangle, QuotientsOfNumbersAreRoundedOutward) {
  for (int n = 1; n < 60; ++n) {
    for (int d = 1; d < 60; ++d) {
      const Interval found = quotient(Interval{double(n), double(n)}, Interval{double(d), double(d)});
      const mpq_class exact = mpq_class(n) / d;
      EXPECT_LT(mpq_class(found.lower), exact) << n << "/" << d;
      EXPECT_GT(mpq_class(found.upper), exact) << n << "/" << d;
      EXPECT_LT(found.upper - found.lower, 1e-13);
    }
  }
}

TEST(LiftedTriangle, LengthsAreRoundedOutward) {
  for (int i = 1; i < 400; ++i) {
    const double value = i < 200 ? i / 64.0 : std::ldexp(1.3, i - 300);
    for (const slong factor : {1L, 2L}) {
      Ball length;
      arb_set_d(length.get(), value);
      arb_sqrt(length.get(), length.get(), 400);
      arb_asinh(length.get(), length.get(), 400);
      arb_mul_si(length.get(), length.get(), factor, 400);
      const Interval exact = outer_interval(length);
      const Interval found = length_interval({value, value}, factor);
      EXPECT_EQ(found, exact) << value;
      EXPECT_EQ(length_interval({value, HUGE_VAL}, factor), (Interval{exact.lower, HUGE_VAL})) << value;
      EXPECT_EQ(length_interval({-value, value}, factor), (Interval{0, exact.upper})) << value;
    }
  }
}

TEST(GeometryCheck, EveryTriangleOfSeveralBlocksIsAsked) {
  // 4,400 triangles; one of them is turned over, or its neighbour is another: about the ends of blocks of 2,048.
  const NetDocument good = copies(nine(), 200);
  ASSERT_EQ(good.triangles.size(), 4400U);
  for (const RuleReport& report : outcome(good).reports) EXPECT_EQ(report.verdict, Verdict::verified) << report.text;
  for (const std::size_t t : {0U, 1023U, 2046U, 2047U, 2048U, 4095U, 4096U, 4399U}) {
    NetDocument document = good;
    NetDocument::Triangle& triangle = document.triangles[t];
    std::swap(triangle.vertex[1], triangle.vertex[2]);
    std::swap(triangle.label[0], triangle.label[1]);
    const RuleReport report = rule(outcome(document, 2), "orientation");
    EXPECT_EQ(report.verdict, Verdict::refuted) << t;
    EXPECT_TRUE(report.text.starts_with("triangle " + std::to_string(t) + " ")) << report.text;
  }
}

TEST(GeometryCheck, EveryCircumradiusAndLengthOfSeveralBlocksIsMeasured) {
  // The copy of one triangle has a vertex of its own, far away.
  const NetDocument good = copies(nine(), 200);
  for (const std::size_t t : {0U, 2046U, 2047U, 2048U, 4095U, 4096U, 4399U}) {
    NetDocument document = good;
    const std::uint32_t old = document.triangles[t].vertex[0];
    document.vertices.push_back(document.vertices[old]);
    document.vertices.back().x = -0.9;
    document.vertices.back().y = 0.3;
    document.triangles[t].vertex[0] = static_cast<std::uint32_t>(document.vertices.size() - 1);
    const GeometryOutcome found = outcome(document);
    const bool refuted = std::any_of(found.reports.begin(), found.reports.end(),
                                     [](const RuleReport& report) { return report.verdict == Verdict::refuted; });
    EXPECT_TRUE(refuted) << t << found.reports[0].text << found.reports[2].text;
  }
}

/// The net with a corner of one triangle moved; its neighbours stay where they are.
NetDocument with_moved_corner(NetDocument document, std::size_t t, std::size_t corner, Point by) {
  const NetDocument::Vertex& old = document.vertices[document.triangles[t].vertex[corner]];
  const NetDocument::Vertex moved{old.x + by.real(), old.y + by.imag(), old.chart};
  document.triangles[t].vertex[corner] = static_cast<std::uint32_t>(document.vertices.size());
  document.vertices.push_back(moved);
  return document;
}

TEST(GeometryCheck, MeasuresAreTheSameWithTheFilterWhicheverTriangleIsTheExtreme) {
  // `outcome` compares. Triangles whose corners carry the identity are those that the filter answers.
  const NetDocument one = load("certify/verified/octagon-33-vertices.json");
  const NetDocument many = copies(one, 2 + 4096 / static_cast<std::uint32_t>(one.triangles.size()));
  const auto is_plain = [](const NetDocument::Triangle& triangle) {
    return triangle.label == std::array<std::uint32_t, 2>{0, 0};
  };
  std::set<double> shortest, longest, widest;
  const auto ask = [&](const NetDocument& document) {
    const GeometryOutcome found = outcome(document, 2);
    shortest.insert(found.enclosures.shortest_edge->lower);
    longest.insert(found.enclosures.longest_edge.lower);
    widest.insert(found.enclosures.largest_circumradius.lower);
  };
  ask(one);
  for (std::size_t t = 0; t < one.triangles.size(); ++t) {
    if (!is_plain(one.triangles[t])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const Point by : {Point{0.02, 0.01}, {-0.015, 0.02}, {0.07, -0.05}}) ask(with_moved_corner(one, t, i, by));
    }
  }
  // The first of those that the filter answers as the extreme.
  std::size_t first = 0;
  while (!is_plain(one.triangles[first])) ++first;
  for (std::size_t k = 0; k < 32; ++k) {
    ask(with_moved_corner(one, first, k % 3,
                          std::polar(0.05 * static_cast<double>(1 + k / 8), 0.8 * static_cast<double>(k))));
  }
  // Any ε: what is refuted is refuted, whoever is asked.
  for (int hundredths = 1; hundredths < 200; hundredths += 2) {
    NetDocument document = one;
    document.epsilon = mpq_class(hundredths, 100).get_str();
    ask(document);
  }
  // A little more than the length of each edge that the filter answers.
  const Reference reference(one);
  for (std::uint32_t dart = 0; dart < 3 * one.triangles.size(); ++dart) {
    if (!is_plain(one.triangles[dart / 3])) continue;
    NetDocument document = one;
    document.epsilon = mpq_class(2.02 * std::asinh(std::sqrt(squared_of(reference, dart)))).get_str();
    ask(document);
  }
  EXPECT_GT(shortest.size(), 10U);
  EXPECT_GT(longest.size(), 5U);
  EXPECT_GT(widest.size(), 10U);
  for (const std::size_t near : {0U, 2040U, 2048U, 4088U, 4096U}) {
    std::size_t t = near;
    while (!is_plain(many.triangles[t])) ++t;
    ask(with_moved_corner(many, t, 0, {0.07, -0.05}));
    ask(with_moved_corner(many, t, 1, {-0.02, 0.03}));
  }
}

TEST(GeometryCheck, AnOpenQuestionOfAnyEdgeLeavesItsRuleOpen) {
  // ε is the length of the shortest edge, to within 2⁻¹⁰⁰. The edge has each of the three numbers in its triangle.
  NetDocument document = load("certify/verified/octagon-33-vertices.json");
  const auto packing = [&](const mpq_class& epsilon, slong bits) {
    document.epsilon = epsilon.get_str();
    const Setting setting(document);
    return rule(check_geometry(document, setting.evaluator, {.max_precision = bits, .filter = false}, 1), "packing");
  };
  mpq_class low(*parse_decimal(document.epsilon)), high = low * 2;
  ASSERT_EQ(packing(low, 256).verdict, Verdict::verified);
  for (int step = 0; step < 100; ++step) {
    const mpq_class middle = (low + high) / 2;
    (packing(middle, 256).verdict == Verdict::refuted ? high : low) = middle;
  }
  const std::string prefix = "the edge of dart ";
  const std::string refuted = packing(high, 256).text;
  ASSERT_TRUE(refuted.starts_with(prefix)) << refuted;
  const auto dart = static_cast<std::uint32_t>(std::stoul(refuted.substr(prefix.size())));
  for (std::uint32_t turn = 0; turn < 3; ++turn) {
    const RuleReport report = packing(low, 64);
    EXPECT_EQ(report.verdict, Verdict::undecided) << turn;
    const std::uint32_t here = dart / 3 * 3 + (dart % 3 + 2 * turn) % 3;
    EXPECT_TRUE(report.text.starts_with(prefix + std::to_string(here) + " from ")) << report.text;
    document = turned(document, dart / 3);
  }
}

TEST(GeometryCheck, TiesOfSeveralBlocksAreAllFoundAndInOrder) {
  const NetDocument one = square();
  const GeometryOutcome single = outcome(one);
  ASSERT_EQ(single.ties.size(), 1U);
  const auto darts = static_cast<std::uint32_t>(3 * one.triangles.size());
  const NetDocument many = copies(one, 2100);  // In blocks of 1, 2, 4, ..., 2,048.
  const GeometryOutcome found = outcome(many, 2);
  std::vector<std::uint32_t> expected;
  for (std::uint32_t k = 0; k < 2100; ++k) expected.push_back(single.ties[0] + k * darts);
  EXPECT_EQ(found.ties, expected);
  for (const RuleReport& report : found.reports) EXPECT_EQ(report.verdict, Verdict::verified) << report.text;
}

TEST(GeometryCheck, AnEdgeThatMissesATieIsFoundAmongTies) {
  // Copies of the square; in one of them a corner is moved by a unit in the last place, to where the diagonal is wrong.
  const NetDocument one = square();
  const std::uint32_t tie = outcome(one).ties.at(0);
  const auto darts = static_cast<std::uint32_t>(3 * one.triangles.size());
  for (const std::uint32_t k : {0U, 1U, 2U, 3U, 6U, 7U, 19U}) {
    int refuted = 0;
    for (const double direction : {-1.0, 1.0}) {
      NetDocument document = copies(one, 20);
      const std::uint32_t corner = previous_dart(tie) + k * darts;
      const std::uint32_t vertex = start(document, corner);
      document.vertices.push_back(document.vertices[vertex]);
      NetDocument::Vertex& moved = document.vertices.back();
      moved.x = std::nextafter(moved.x, direction);
      for (std::uint32_t t = k * darts / 3; t < (k + 1) * darts / 3; ++t) {
        for (std::uint32_t& v : document.triangles[t].vertex) {
          if (v == vertex) v = static_cast<std::uint32_t>(document.vertices.size() - 1);
        }
      }
      const RuleReport report = rule(outcome(document), "delaunay");
      if (report.verdict != Verdict::refuted) continue;
      ++refuted;
      EXPECT_TRUE(report.text.starts_with("the edge of dart " + std::to_string(tie + k * darts) + " ")) << report.text;
    }
    EXPECT_EQ(refuted, 1) << k;
  }
}

TEST(GeometryCheck, WhatIsNotAskedIsNotVerified) {
  // Ties that are left when the orientation is refuted.
  NetDocument document = copies(square(), 2);
  NetDocument::Triangle& triangle = document.triangles.front();
  std::swap(triangle.vertex[1], triangle.vertex[2]);
  std::swap(triangle.label[0], triangle.label[1]);
  const GeometryOutcome found = outcome(document);
  EXPECT_EQ(rule(found, "orientation").verdict, Verdict::refuted);
  EXPECT_NE(rule(found, "delaunay").verdict, Verdict::verified);
}

TEST(GeometryCheck, WithLessWorkItIsUndecidedAndNeverMore) {
  const NetDocument document = square();
  int left_open = 0;
  int decided = 0;
  for (double work = 1000; work < 1e9; work *= 1.2) {
    const Budget budget(static_cast<std::uint64_t>(work));
    try {
      const Setting setting(document, budget);
      const GeometryOutcome found = check_geometry(document, setting.evaluator, {}, 1);
      if (rule(found, "delaunay").verdict == Verdict::verified) {
        EXPECT_EQ(found.ties.size(), 1U);
        ++decided;
      } else {
        EXPECT_EQ(rule(found, "delaunay").verdict, Verdict::undecided);
        left_open += rule(found, "orientation").verdict == Verdict::verified;
      }
    } catch (const BudgetSpent&) {
    }
  }
  EXPECT_GT(left_open, 0);
  EXPECT_GT(decided, 0);
}

/// sinh²(d/2) is what is compared: for short edges (d/2)² is nearly that, and too small.
TEST(GeometryCheck, ShortEdgesAreComparedWithEpsilonAsLongOnesAre) {
  NetDocument document = load("certify/verified/octagon-33-vertices.json");
  // A triangle without labels; its first edge is shortened.
  const auto plain = std::find_if(document.triangles.begin(), document.triangles.end(), [](const auto& triangle) {
    return triangle.label == std::array<std::uint32_t, 2>{0, 0};
  });
  ASSERT_NE(plain, document.triangles.end());
  const NetDocument::Vertex& from = document.vertices[plain->vertex[0]];
  NetDocument::Vertex& to = document.vertices[plain->vertex[1]];
  for (double step = 0.25; step > 1e-4; step *= 0.7) {
    to = {from.x - step * from.x, from.y - step * from.y, from.chart};
    const double length =
        2 * std::asinh(std::abs(Point(to.x - from.x, to.y - from.y)) /
                       std::sqrt((1 - std::norm(Point(from.x, from.y))) * (1 - std::norm(Point(to.x, to.y)))));
    // Four times nearer to the length than the number whose square half would be.
    const double margin = 1 + length * length / 100;
    document.epsilon = mpq_class(length * margin).get_str();
    const RuleReport packing = rule(outcome(document), "packing");
    EXPECT_EQ(packing.verdict, Verdict::refuted) << length;
    document.epsilon = mpq_class(length / margin).get_str();
    EXPECT_NE(rule(outcome(document), "packing").verdict, Verdict::refuted) << length;
  }
}

TEST(GeometryCheck, EveryEdgeBelongsToTheRuleOfItsEnds) {
  // Packing asks of different vertices, unless they are those of one collar; thick of one vertex of no collar, in a
  // pseudo net.
  NetDocument document;
  document.vertices.resize(4);
  for (std::uint32_t u = 0; u < 4; ++u) {
    for (std::uint32_t v = 0; v < 4; ++v) {
      for (std::uint32_t w = 0; w < 4; ++w)
        document.triangles.push_back({.vertex = {u, v, w}, .opposite = {}, .label = {}});
    }
  }
  for (const int kind : {0, 1, 2}) {
    if (kind > 0) document.collars.emplace();
    if (kind > 1) document.collars->push_back({.core = {}, .length = {}, .vertices = {1, 3}, .triangles = {0, 1}});
    const CollarMembers collars(document);
    for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
      Questions packing = 0, thick = 0;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t u = document.triangles[t].vertex[i], v = document.triangles[t].vertex[(i + 1) % 3];
        const bool partners = kind > 1 && u + v == 4 && u != v;
        const bool in_collar = kind > 1 && (u == 1 || u == 3);
        if (u != v && !partners) packing = static_cast<Questions>(packing | length_bit(i));
        if (u == v && kind > 0 && !in_collar) thick = static_cast<Questions>(thick | length_bit(i));
      }
      using namespace geometry;
      EXPECT_EQ(questions_of(document, collars, kOrientation, t), kOrientationBit);
      EXPECT_EQ(questions_of(document, collars, kDelaunay, t), kDelaunayBits);
      EXPECT_EQ(questions_of(document, collars, kCovering, t), kCoveringBit);
      EXPECT_EQ(questions_of(document, collars, kPacking, t), packing) << kind << ", triangle " << t;
      EXPECT_EQ(questions_of(document, collars, kThick, t), thick) << kind << ", triangle " << t;
    }
  }
}

TEST(GeometryCheck, OnlyPseudoNetsHaveThickLoops) {
  // A net of one vertex has loops only, and ε may be greater than any of them.
  NetDocument one = load("certify/verified/octagon-1-vertex.json");
  one.epsilon = "9";
  EXPECT_EQ(check(one).verdict, Verdict::verified) << check(one).message;
  // As a pseudo net without collars it says that no loop is shorter than ε.
  NetDocument pseudo = one;
  pseudo.collars = std::vector<NetDocument::Collar>{};
  const GeometryOutcome found = outcome(pseudo);
  EXPECT_EQ(rule(found, "thick").verdict, Verdict::refuted);
  pseudo.epsilon = "0.1";
  EXPECT_EQ(rule(outcome(pseudo), "thick").verdict, Verdict::verified);
}

/// Whether the interval holds the number that a ball of many bits encloses.
bool holds(Interval x, const Ball& value) {
  Ball lower, upper;
  arb_set_d(lower.get(), x.lower);
  arb_set_d(upper.get(), x.upper);
  return certainly_less(lower, value) == Tri::yes && certainly_less(value, upper) == Tri::yes;
}

TEST(GeometryCheck, EnclosuresHoldWhat256BitsTell) {
  for (const char* name : {"octagon-9-vertices.json", "octagon-33-vertices.json", "octagon-1-vertex.json",
                           "g2-small-1-vertex.json", "regular-2-10-vertices.json", "regular-3-centre.json"}) {
    const NetDocument document = load(std::string("certify/verified/") + name);
    const Setting setting(document);
    std::vector<std::uint32_t> numbers(document.labels.size());
    std::iota(numbers.begin(), numbers.end(), 1U);
    const LabelTable labels(numbers, setting.evaluator.evaluate(numbers, 256, 4096, 1), numbers.size());
    // sinh² of the largest circumradius, and of half the longest edge, the shortest edge and the shortest loop.
    std::optional<Ball> radius, longest, edge, loop;
    const auto keep = [](std::optional<Ball>& extreme, const Ball& x, int sign) {
      if (!extreme || (sign > 0 ? certainly_less(*extreme, x) : certainly_less(x, *extreme)) == Tri::yes) {
        extreme = x;
      }
    };
    LiftedTriangle lifted;
    Ball one;
    arb_one(one.get());
    for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
      lifted.load(document, labels, t, 256);
      const auto& circumradius = lifted.measure_circumradius(one.get(), 256);
      Ball square;
      arb_div(square.get(), circumradius.numerator.get(), circumradius.denominator.get(), 256);
      keep(radius, square, 1);
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Ball& product = lifted.measure_edge(one.get(), i, 256).gap_product;
        arb_div(square.get(), lifted.squared_difference(i).get(), product.get(), 256);
        keep(longest, square, 1);
        const std::uint32_t dart = 3 * t + i;
        keep(start(document, dart) == start(document, next_dart(dart)) ? loop : edge, square, -1);
      }
    }
    const auto length = [](Ball square, slong factor) {
      arb_sqrt(square.get(), square.get(), 256);
      arb_asinh(square.get(), square.get(), 256);
      arb_mul_si(square.get(), square.get(), factor, 256);
      return square;
    };
    const GeometryOutcome found = outcome(document);
    EXPECT_TRUE(holds(found.enclosures.largest_circumradius, length(*radius, 1))) << name;
    EXPECT_TRUE(holds(found.enclosures.longest_edge, length(*longest, 2))) << name;
    ASSERT_EQ(found.enclosures.shortest_edge.has_value(), edge.has_value()) << name;
    ASSERT_EQ(found.enclosures.shortest_loop.has_value(), loop.has_value()) << name;
    EXPECT_TRUE(!edge || holds(*found.enclosures.shortest_edge, length(*edge, 2))) << name;
    EXPECT_TRUE(!loop || holds(*found.enclosures.shortest_loop, length(*loop, 2))) << name;
  }
}

TEST(GeometryCheck, EnclosuresContainWhatIsMeasured) {
  const NetDocument document = nine();
  const Reference reference(document);
  double longest = 0;
  double shortest = 100;
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    const double length = 2 * std::asinh(std::sqrt(squared_of(reference, dart)));
    longest = std::max(longest, length);
    shortest = std::min(shortest, length);
  }
  const GeometryOutcome found = outcome(document);
  EXPECT_NEAR(found.enclosures.longest_edge.lower, longest, 1e-12);
  EXPECT_NEAR(found.enclosures.longest_edge.upper, longest, 1e-12);
  EXPECT_LT(found.enclosures.longest_edge.lower, found.enclosures.longest_edge.upper);
  EXPECT_NEAR(found.enclosures.shortest_edge->lower, shortest, 1e-12);
  EXPECT_NEAR(found.enclosures.shortest_edge->upper, shortest, 1e-12);
  EXPECT_LT(found.enclosures.shortest_edge->lower, found.enclosures.shortest_edge->upper);
}

}  // namespace
}  // namespace epsnet::certify::geometry_check_test
