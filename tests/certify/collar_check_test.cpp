#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "certify/check.h"
#include "certify/claims/net/claim.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/net/structure.h"
#include "tests/certify/far_words.h"

/// Rule `collars` alone, on documents that the rules before it may refuse: so each clause stands on its own.
namespace epsnet::certify::collar_check_test {
namespace {

/// A pseudo net of genus 2 with collars about geodesics of the lengths 1/8 and 1/4.
NetDocument two_collars() { return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/forgeries/collars.json"); }

/// What the rule works with.
struct Setting {
  explicit Setting(const NetDocument& document)
      : parts{check_surface(document.surface).crossings, chart_frames(document.charts, {})},
        evaluator(document, parts) {}
  LabelParts parts;
  LabelEvaluator evaluator;
};

RuleReport report(const NetDocument& document, long max_precision = 8192) {
  const Setting setting(document);
  return check_collars(document, setting.evaluator, setting.parts, max_precision).report;
}
std::string text(const NetDocument& document) { return report(document).text; }

std::uint32_t& opposite_of(NetDocument& document, std::uint32_t dart) {
  return document.triangles[dart / 3].opposite[dart % 3];
}

/// The dart of triangle t that goes from a vertex to itself.
std::uint32_t loop(const NetDocument& document, std::uint32_t t) {
  std::uint32_t dart = 3 * t;
  while (start(document, dart) != start(document, next_dart(dart))) ++dart;
  return dart;
}

BallIsometry label(const Setting& setting, const NetDocument& document, std::uint32_t dart) {
  const std::uint32_t number = corner_label(document, dart);
  if (number == 0) return identity_isometry();
  return setting.evaluator.evaluate(std::array{number}, 256, 1024, 1).front();
}

/// The length of the loop at a vertex of a collar whose coordinate is 0: how far the loop moves it.
double loop_length(const NetDocument& document, std::size_t c, std::size_t i) {
  const Setting setting(document);
  const std::uint32_t dart = loop(document, (*document.collars)[c].triangles[i]);
  const BallIsometry moves =
      compose(inverse(label(setting, document, dart)), label(setting, document, next_dart(dart)), 256);
  Ball squared;
  half_displacement_squared(squared.get(), moves, 256);
  return 2 * std::asinh(std::sqrt(outer_interval(squared).lower));
}

std::string decimal(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

TEST(CollarCheck, TheTrueOnesAreVerified) {
  EXPECT_EQ(report(two_collars()).verdict, Verdict::verified) << text(two_collars());
}

TEST(CollarMembers, AreThoseThatTheFileNames) {
  NetDocument document = two_collars();
  const std::vector<NetDocument::Collar> collars = *document.collars;
  for (const std::size_t count : {2U, 1U, 0U}) {
    document.collars->resize(count);
    const CollarMembers members(document);
    EXPECT_TRUE(members.pseudo());
    for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
      bool named = false;
      for (std::size_t c = 0; c < count; ++c)
        named = named || t == collars[c].triangles[0] || t == collars[c].triangles[1];
      EXPECT_EQ(members.has_triangle(t), named) << t;
    }
    for (std::uint32_t u = 0; u < document.vertices.size(); ++u) {
      bool named = false;
      for (std::uint32_t v = 0; v < document.vertices.size(); ++v) {
        bool partners = false;
        for (std::size_t c = 0; c < count; ++c) {
          partners = partners || collars[c].vertices == std::array{u, v} || collars[c].vertices == std::array{v, u};
        }
        EXPECT_EQ(members.are_partners(u, v), partners) << u << ' ' << v;
        named = named || partners;
      }
      EXPECT_EQ(members.has_vertex(u), named) << u;
    }
  }
  document.collars.reset();
  EXPECT_FALSE(CollarMembers(document).pseudo());
}

TEST(CollarMembers, AreExemptFromPackingAndCoveringAlone) {
  const NetDocument good = two_collars();
  EXPECT_EQ(check(good, {.threads = 1}).verdict, Verdict::verified);
  // Without the collars the edges between their vertices are too short, and their triangles too large.
  NetDocument document = good;
  document.collars->clear();
  std::map<std::string, Verdict> verdicts;
  for (const RuleReport& rule : check(document, {.threads = 1}).rules) verdicts[rule.rule] = rule.verdict;
  EXPECT_EQ(verdicts.at("collars"), Verdict::verified);
  EXPECT_EQ(verdicts.at("covering"), Verdict::refuted);
  // A vertex of a collar moved over the core: its loops are shorter than ε, and it is in no collar now.
  document.epsilon = "0.3";
  NetDocument::Vertex& vertex = document.vertices[(*good.collars)[0].vertices[0]];
  bool thick = true;
  for (int k = 0; k < 12 && thick; ++k) {
    vertex.x = 0.2 * std::cos(M_PI / 6 * k);
    vertex.y = 0.2 * std::sin(M_PI / 6 * k);
    for (const RuleReport& rule : check(document, {.threads = 1}).rules) {
      thick = thick && (rule.rule != "thick" || rule.verdict != Verdict::refuted);
    }
  }
  EXPECT_FALSE(thick);
}

TEST(CollarCheck, GluedAlongOneEdgeOnlyIsNoAnnulus) {
  // Between p → p → q and q → q → p two edges are shared. Each is led elsewhere, to a smaller and to a larger dart.
  const NetDocument good = two_collars();
  for (std::size_t c = 0; c < 2; ++c) {
    const std::uint32_t dart = loop(good, (*good.collars)[c].triangles[0]);
    for (const std::uint32_t edge : {next_dart(dart), previous_dart(dart)}) {
      for (const std::uint32_t elsewhere : {0U, static_cast<std::uint32_t>(3 * good.triangles.size() - 1)}) {
        NetDocument document = good;
        opposite_of(document, edge) = elsewhere;
        const RuleReport found = report(document);
        EXPECT_EQ(found.verdict, Verdict::refuted);
        EXPECT_NE(found.text.find("collar " + std::to_string(c)), std::string::npos) << found.text;
        EXPECT_NE(found.text.find("not glued along two edges to an annulus"), std::string::npos) << found.text;
      }
    }
  }
}

TEST(CollarCheck, EveryCornerOfItsTrianglesIsThatOfTheCollar) {
  // Any other vertex at any of the six corners, of a smaller and of a larger number.
  const NetDocument good = two_collars();
  const auto last = static_cast<std::uint32_t>(good.vertices.size() - 1);
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        for (const std::uint32_t other : {c == 0 ? 2U : 0U, c == 0 ? 5U : 2U, last}) {
          NetDocument document = good;
          document.triangles[(*good.collars)[c].triangles[i]].vertex[corner] = other;
          const RuleReport found = report(document);
          EXPECT_EQ(found.verdict, Verdict::refuted);
          EXPECT_NE(
              found.text.find(i == 0 ? "has not two corners at the first vertex" : "has not two corners at the second"),
              std::string::npos)
              << found.text;
        }
      }
    }
  }
}

TEST(CollarCheck, NoTriangleAndNoVertexIsNamedTwice) {
  const NetDocument good = two_collars();
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      NetDocument document = good;
      (*document.collars)[1].triangles[k] = (*good.collars)[0].triangles[i];
      EXPECT_NE(text(document).find("collar 1 "), std::string::npos) << text(document);
      EXPECT_NE(text(document).find("triangle " + std::to_string((*good.collars)[0].triangles[i]) + " is named twice"),
                std::string::npos)
          << text(document);
      document = good;
      (*document.collars)[1].vertices[k] = (*good.collars)[0].vertices[i];
      EXPECT_NE(text(document).find("vertex " + std::to_string((*good.collars)[0].vertices[i]) + " is named twice"),
                std::string::npos)
          << text(document);
    }
    NetDocument document = good;
    (*document.collars)[i].triangles[1] = (*good.collars)[i].triangles[0];
    EXPECT_NE(text(document).find("is named twice"), std::string::npos) << text(document);
    document = good;
    (*document.collars)[i].vertices[1] = (*good.collars)[i].vertices[0];
    EXPECT_NE(text(document).find("is named twice"), std::string::npos) << text(document);
  }
}

TEST(CollarCheck, TheLengthLiesBetweenTheEndsThatTheFileSays) {
  // Cores of exactly 1/8 and 1/4 (but for the rounding of the surface, below 10⁻¹⁵).
  for (std::size_t c = 0; c < 2; ++c) {
    const double length = c == 0 ? 0.125 : 0.25;
    NetDocument document = two_collars();
    (*document.collars)[c].length = {length * (1 + 1e-12), 1};
    EXPECT_NE(text(document).find("less than the file says"), std::string::npos) << text(document);
    (*document.collars)[c].length = {0, length * (1 - 1e-12)};
    EXPECT_NE(text(document).find("more than the file says"), std::string::npos) << text(document);
    (*document.collars)[c].length = {length * (1 - 1e-12), length * (1 + 1e-12)};
    EXPECT_EQ(report(document).verdict, Verdict::verified) << text(document);
  }
}

TEST(CollarCheck, ItsTrianglesAreThoseThatItNames) {
  // Any other triangle of the net, which has not those corners, though the one before or after it may.
  const NetDocument good = two_collars();
  for (std::uint32_t t = 0; t < good.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 2; ++i) {
      NetDocument document = good;
      const auto& others = (*good.collars)[1].triangles;
      if (t == (*good.collars)[0].triangles[i] || t == others[0] || t == others[1]) continue;
      (*document.collars)[0].triangles[i] = t;
      const bool both = t == (*good.collars)[0].triangles[1 - i];
      EXPECT_NE(text(document).find(both     ? "is named twice"
                                    : i == 0 ? "has not two corners at the first vertex"
                                             : "has not two corners at the second"),
                std::string::npos)
          << t << ": " << text(document);
    }
  }
}

/// The same net with every vertex in a chart of its own, centred there.
NetDocument recharted(NetDocument document) {
  const std::vector<NetDocument::Label> old_labels = document.labels;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers;
  std::vector<NetDocument::Chart> charts;
  for (NetDocument::Vertex& vertex : document.vertices) {
    // (z + c)/(1 + c̄ z).
    const auto& [tile, c] = document.charts[vertex.chart];
    const mpq_class x(vertex.x), y(vertex.y);
    const mpq_class re = 1 + c.x * x + c.y * y, im = c.x * y - c.y * x, scale = re * re + im * im;
    const mpq_class u = x + c.x, v = y + c.y;
    charts.push_back({tile, {(u * re + v * im) / scale, (v * re - u * im) / scale}});
    vertex = {0, 0, static_cast<std::uint32_t>(charts.size() - 1)};
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

/// Collar c alone, its vertex i moved by 0.01 in one of twelve directions to where its loop is the shortest, or
/// longest.
NetDocument with_vertex_moved(std::size_t c, std::size_t i, bool nearer) {
  std::optional<NetDocument> best;
  for (int k = 0; k < 12; ++k) {
    NetDocument document = two_collars();
    document.collars = {{(*document.collars)[c]}};
    NetDocument::Vertex& vertex = document.vertices[(*document.collars)[0].vertices[i]];
    vertex.x = 0.01 * std::cos(M_PI / 6 * k);
    vertex.y = 0.01 * std::sin(M_PI / 6 * k);
    document = recharted(document);
    if (!best || (loop_length(document, 0, i) < loop_length(*best, 0, i)) == nearer) best = document;
  }
  return *best;
}

TEST(CollarCheck, AVertexIsThickUntilItsLoopIsShorterThanEpsilon) {
  // ε a billionth below and above the length of the loop, for the vertex nearer to the core.
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      NetDocument document = with_vertex_moved(c, i, true);
      const double length = loop_length(document, 0, i);
      ASSERT_LT(length, loop_length(document, 0, 1 - i));
      const std::string thin =
          "vertex " + std::to_string((*document.collars)[0].vertices[i]) + " is in the epsilon-thin part";
      document.epsilon = decimal(length * (1 - 1e-9));
      EXPECT_EQ(text(document).find(thin), std::string::npos) << text(document);
      document.epsilon = decimal(length * (1 + 1e-9));
      EXPECT_NE(text(document).find(thin), std::string::npos) << text(document);
    }
  }
}

TEST(CollarCheck, AVertexThat64BitsDoNotTellFromTheThinPartIsUndecided) {
  // ε is the length of a vertex's loop to 30 digits, rounded down and up.
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      NetDocument document = with_vertex_moved(c, i, true);
      const Setting setting(document);
      const std::uint32_t dart = loop(document, (*document.collars)[0].triangles[i]);
      const BallIsometry moves =
          compose(inverse(label(setting, document, dart)), label(setting, document, next_dart(dart)), 256);
      Ball length, unit;
      half_displacement_squared(length.get(), moves, 256);
      arb_sqrt(length.get(), length.get(), 256);
      arb_asinh(length.get(), length.get(), 256);
      arb_mul_2exp_si(length.get(), length.get(), 1);
      mpz_class digits;
      mpz_ui_pow_ui(digits.get_mpz_t(), 10, 30);
      const Precision scope(256);
      unit = Ball::rounded(digits);
      arb_mul(length.get(), length.get(), unit.get(), 256);
      arb_floor(length.get(), length.get(), 256);
      fmpz_t floor;
      fmpz_init(floor);
      ASSERT_NE(arb_get_unique_fmpz(floor, length.get()), 0);
      mpz_class whole;
      fmpz_get_mpz(whole.get_mpz_t(), floor);
      fmpz_clear(floor);
      for (const int more : {0, 1}) {
        document.epsilon = mpz_class(whole + more).get_str() + "/" + digits.get_str();
        EXPECT_EQ(report(document, 64).verdict, Verdict::undecided) << text(document);
        const bool thin = text(document).find("vertex " + std::to_string((*document.collars)[0].vertices[i]) +
                                              " is in the epsilon-thin part") != std::string::npos;
        EXPECT_EQ(thin, more == 1) << text(document);
      }
    }
  }
}

TEST(CollarCheck, ACoreThat64BitsDoNotTellIsUndecided) {
  for (std::size_t c = 0; c < 2; ++c) {
    NetDocument document = two_collars();
    document.collars = {{(*document.collars)[c]}};
    NetDocument::Collar& collar = (*document.collars)[0];
    collar.core = with_far_relator(document.surface, document.charts[document.vertices[collar.vertices[0]].chart].tile,
                                   collar.core);
    EXPECT_EQ(report(document, 64).verdict, Verdict::undecided);
    EXPECT_EQ(report(document).verdict, Verdict::verified) << text(document);
  }
}

TEST(CollarCheck, TheCoreIsGoneAroundOnce) {
  for (const NetDocument& good : {two_collars(), recharted(two_collars())}) {
    for (std::size_t c = 0; c < 2; ++c) {
      const std::vector<std::uint32_t> core = (*good.collars)[c].core;
      NetDocument document = good;
      std::vector<std::uint32_t>& word = (*document.collars)[c].core;
      word.insert(word.end(), core.begin(), core.end());
      EXPECT_NE(text(document).find("collar " + std::to_string(c)), std::string::npos) << text(document);
      word.clear();
      EXPECT_NE(text(document).find("collar " + std::to_string(c)), std::string::npos) << text(document);
      EXPECT_EQ(report(document).verdict, Verdict::refuted);
    }
  }
}

TEST(CollarCheck, AVertexCoversUntilItsReachIsEpsilon) {
  // 2 arsinh(sinh(l/4) cosh d) + d − d_ε = ε, with cosh d = sinh(loop/2)/sinh(l/2) and cosh d_ε = sinh(ε/2)/sinh(l/2):
  // ε a billionth above and below, for the vertex farther from the core.
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      NetDocument document = with_vertex_moved(c, i, false);
      const double l = c == 0 ? 0.125 : 0.25;
      ASSERT_GT(loop_length(document, 0, i), loop_length(document, 0, 1 - i));
      const double d = std::acosh(std::sinh(loop_length(document, 0, i) / 2) / std::sinh(l / 2));
      const auto lack = [&](double epsilon) {
        return 2 * std::asinh(std::sinh(l / 4) * std::cosh(d)) + d -
               std::acosh(std::sinh(epsilon / 2) / std::sinh(l / 2)) - epsilon;
      };
      double low = l * (1 + 1e-9);
      double high = 0.3465;
      ASSERT_GT(lack(low), 0);
      ASSERT_LT(lack(high), 0);
      for (int k = 0; k < 100; ++k) (lack((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
      const std::string far = "vertex " + std::to_string((*document.collars)[0].vertices[i]) + " does not cover";
      document.epsilon = decimal(low * (1 + 1e-9));
      EXPECT_EQ(text(document).find(far), std::string::npos) << text(document);
      document.epsilon = decimal(low * (1 - 1e-9));
      EXPECT_NE(text(document).find(far), std::string::npos) << text(document);
    }
  }
}

TEST(CollarCheck, EpsilonIsAtMostLnOfRootTwo) {
  // ln √2 = 0.34657359027997265470861606072908828…
  NetDocument document = two_collars();
  document.epsilon = "0.34657359027997265470861606072909";
  EXPECT_EQ(report(document).verdict, Verdict::refuted);
  EXPECT_NE(text(document).find("greater than ln sqrt(2)"), std::string::npos);
  document.epsilon = "0.34657359027997265470861606072908";
  EXPECT_EQ(text(document).find("greater than ln sqrt(2)"), std::string::npos) << text(document);
  document.collars = std::vector<NetDocument::Collar>{};
  EXPECT_EQ(report(document).verdict, Verdict::verified) << text(document);
  EXPECT_EQ(text(document), "there are none, and epsilon is at most ln sqrt(2)");
  // 64 bits do not tell ln √2 from its first 32 digits; 128 do.
  EXPECT_EQ(report(document, 64).verdict, Verdict::undecided);
  EXPECT_EQ(report(document, 128).verdict, Verdict::verified);
}

TEST(CollarCheck, ChartsAreOnlyNames) {
  // The vertices moved about, also to the core and over it: as coordinates, and as the centres of charts.
  std::map<std::string, int> met;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (int k = 0; k < 24; ++k) {
        NetDocument document = two_collars();
        NetDocument::Vertex& vertex = document.vertices[(*document.collars)[c].vertices[i]];
        const double r = std::array{0.003, 0.02, 0.1, 0.4}[static_cast<std::size_t>(k % 4)];
        vertex.x = r * std::cos(M_PI / 6 * (k / 4) + 0.1);
        vertex.y = r * std::sin(M_PI / 6 * (k / 4) + 0.1);
        const RuleReport moved = report(document);
        const RuleReport centred = report(recharted(document));
        EXPECT_EQ(moved.verdict, centred.verdict) << moved.text << '\n' << centred.text;
        EXPECT_EQ(moved.text, centred.text);
        for (const char* what : {"thin part", "does not cover", "different sides", "annuli"})
          met[what] += moved.text.find(what) != std::string::npos;
      }
    }
  }
  for (const auto& [what, times] : met) EXPECT_GT(times, 0) << what;
}

TEST(CollarCheck, TheShortestCoreIsThatOfTheShorterCollar) {
  for (const bool exchanged : {false, true}) {
    NetDocument document = two_collars();
    if (exchanged) std::swap((*document.collars)[0], (*document.collars)[1]);
    const Setting setting(document);
    const CollarsOutcome outcome = check_collars(document, setting.evaluator, setting.parts, 8192);
    ASSERT_TRUE(outcome.shortest_core.has_value());
    EXPECT_NEAR(outcome.shortest_core->lower, 0.125, 1e-13);
    EXPECT_LT(outcome.shortest_core->lower, outcome.shortest_core->upper);
    // As if there were no other one.
    document.collars = {(*document.collars)[exchanged ? 1 : 0]};
    const Setting alone(document);
    EXPECT_EQ(outcome.shortest_core, check_collars(document, alone.evaluator, alone.parts, 8192).shortest_core);
  }
}

TEST(CollarCheck, WithoutADiskItIsUndecided) {
  NetDocument document = two_collars();
  const Setting setting(document);
  for (SurfaceDocument::Tile& tile : document.surface.tiles) {
    for (RationalPoint& corner : tile) corner.y = 0;
  }
  EXPECT_EQ(check_collars(document, setting.evaluator, setting.parts, 8192).report.verdict, Verdict::undecided);
}

/// The same with vertex 1 and triangle 1 of every collar first; cores are the loops there.
NetDocument from_the_other_side(NetDocument document) {
  const Setting setting(document);
  for (NetDocument::Collar& collar : *document.collars) {
    std::swap(collar.vertices[0], collar.vertices[1]);
    std::swap(collar.triangles[0], collar.triangles[1]);
    const std::uint32_t dart = loop(document, collar.triangles[0]);
    collar.core = setting.evaluator.word(std::array{SignedLabel{corner_label(document, dart), true},
                                                    SignedLabel{corner_label(document, next_dart(dart)), false}});
  }
  return document;
}

TEST(CollarCheck, EitherVertexMayBeTheFirst) {
  // One vertex moved about, also over the core.
  int same_side = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (int k = 0; k < 24; ++k) {
        NetDocument document = two_collars();
        NetDocument::Vertex& vertex = document.vertices[(*document.collars)[c].vertices[i]];
        const double r = std::array{0.003, 0.02, 0.1, 0.4}[static_cast<std::size_t>(k % 4)];
        vertex.x = r * std::cos(M_PI / 6 * (k / 4) + 0.1);
        vertex.y = r * std::sin(M_PI / 6 * (k / 4) + 0.1);
        const NetDocument other = from_the_other_side(document);
        EXPECT_EQ(report(document).verdict, report(other).verdict) << text(document) << '\n' << text(other);
        const char* const what = "not on different sides";
        same_side += text(document).find(what) != std::string::npos;
        EXPECT_EQ(text(document).find(what) == std::string::npos, text(other).find(what) == std::string::npos);
      }
    }
  }
  EXPECT_GT(same_side, 0);
}

TEST(CollarCheck, WithoutWorkItIsUndecided) {
  const NetDocument document = two_collars();
  Setting setting(document);
  setting.parts.budget = Budget(100);
  EXPECT_EQ(check_collars(document, setting.evaluator, setting.parts, 8192).report.verdict, Verdict::undecided);
}

}  // namespace
}  // namespace epsnet::certify::collar_check_test
