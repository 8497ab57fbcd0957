#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <random>
#include <string>

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/numbers/ball.h"
#include "tests/certify/far_words.h"
#include "tests/certify/reference.h"

/// When an element is the identity, and labels that 64 bits do not tell from those that they are.
namespace epsnet::certify::gluing_check_test {
namespace {

NetDocument load(const std::string& name) { return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/" + name); }

Ball ball(double value, double radius = 0) {
  Ball result;
  arb_set_d(result.get(), value);
  if (radius > 0) {
    Ball error;
    arb_set_d(error.get(), radius);
    arb_add_error(result.get(), error.get());
  }
  return result;
}

/// The translation that moves 0 by 2 arsinh(displacement), in the direction of the angle.
BallIsometry translation(double displacement, double angle, double radius = 0) {
  BallIsometry f;
  arb_set_d(f.a.re(), std::sqrt(1 + displacement * displacement));
  arb_set(f.b.re(), ball(displacement * std::cos(angle), radius).get());
  arb_set(f.b.im(), ball(displacement * std::sin(angle), radius).get());
  return f;
}

TEST(GluingCheck, AnElementThatMovesTheCentreByLessThanTheDiskIsTheIdentity) {
  for (const double sinh_radius : {0.01, 0.3, 0.9, 1.0, 2.5}) {
    for (const double angle : {0.0, 1.0, M_PI / 2, 3.0, -1.5, -2.5}) {
      const auto answer = [&](double displacement, double radius) {
        return is_identity(translation(displacement, angle, radius), ball(sinh_radius), 128);
      };
      EXPECT_EQ(answer(0, 0), Tri::yes);
      EXPECT_EQ(answer(0, 0.5 * sinh_radius), Tri::yes);
      EXPECT_EQ(answer(0.99 * sinh_radius, 0), Tri::yes);
      EXPECT_EQ(answer(1.01 * sinh_radius, 0), Tri::no);
      EXPECT_EQ(answer(5 * sinh_radius, 0), Tri::no);
      // All that is known is that it moves the centre by less than some more.
      EXPECT_EQ(answer(0, 1.01 * sinh_radius), Tri::unknown);
      EXPECT_EQ(answer(0, 100), Tri::unknown);
    }
  }
  BallIsometry nothing = translation(0, 0);
  arb_indeterminate(nothing.b.re());
  EXPECT_EQ(is_identity(nothing, ball(1), 128), Tri::unknown);
}

/// All closed paths of at most so many letters that begin in the tile and lead nowhere back.
std::vector<std::vector<std::uint32_t>> loops_at(const SurfaceSides& sides, std::uint32_t tile, std::size_t length) {
  std::vector<std::vector<std::uint32_t>> paths{{}};
  std::vector<std::vector<std::uint32_t>> result;
  for (std::size_t first = 0, n = 0; n < length; ++n) {
    const std::size_t last = paths.size();
    for (; first < last; ++first) {
      const std::uint32_t here = paths[first].empty() ? tile : sides.tile[sides.partner[paths[first].back()]];
      for (std::uint32_t side = 0; side < sides.tile.size(); ++side) {
        if (sides.tile[side] != here || (!paths[first].empty() && sides.partner[paths[first].back()] == side)) continue;
        paths.push_back(paths[first]);
        paths.back().push_back(side);
        if (sides.tile[sides.partner[side]] == tile) result.push_back(paths.back());
      }
    }
  }
  return result;
}

TEST(SlowGluingCheck, ALabelAndAShortLoopAreNotTheLabel) {
  // Far out in a collar a loop around it moves points by little. Whether it is 1 is asked where the inscribed disk is.
  int asked = 0;
  const NetDocument net = read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) +
                                                       "/geodesics/two-short-cuffs-that-differ-by-1e-17.json")
                              .net;
  const SurfaceSides sides(net.surface);
  for (std::size_t t = 0; t < net.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::uint32_t number = net.triangles[t].label[i];
      if (number == 0) continue;
      const NetDocument::Label& label = net.labels[number - 1];
      for (const auto& loop : loops_at(sides, net.charts[label.to].tile, 2)) {
        NetDocument wrong = net;
        wrong.labels.push_back(label);
        wrong.labels.back().word.insert(wrong.labels.back().word.end(), loop.begin(), loop.end());
        wrong.triangles[t].label[i] = static_cast<std::uint32_t>(wrong.labels.size());
        const Certificate certificate = check(wrong, {.threads = 1});
        EXPECT_EQ(certificate.verdict, Verdict::refuted) << "triangle " << t;
        EXPECT_EQ(certificate.rule, "gluing") << "triangle " << t;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 300);
}

TEST(GluingCheck, LabelsThat64BitsDoNotTellAreUndecided) {
  // Every label once, in front of it a word that goes far away, around a corner of a tile there and back.
  for (const char* name : {"certify/verified/octagon-9-vertices.json", "forgeries/collars.json"}) {
    const NetDocument good = load(name);
    for (std::size_t l = 0; l < good.labels.size(); l += 9) {
      NetDocument document = good;
      document.labels[l].word =
          with_far_relator(document.surface, good.charts[good.labels[l].from].tile, good.labels[l].word);
      bool used = false;
      for (const NetDocument::Triangle& t : good.triangles) used = used || t.label[0] == l + 1 || t.label[1] == l + 1;
      const Certificate coarse = check(document, {.threads = 1, .max_precision = 64});
      EXPECT_EQ(coarse.rules.at(2).verdict, used ? Verdict::undecided : Verdict::verified) << coarse.rules.at(2).text;
      const Certificate fine = check(document, {.threads = 1});
      EXPECT_EQ(fine.rules.at(2).verdict, Verdict::verified) << fine.rules.at(2).text;
    }
  }
}

/// What the rule works with.
struct Setting {
  explicit Setting(const NetDocument& document)
      : parts{check_surface(document.surface).crossings, chart_frames(document.charts, {}), {}},
        evaluator(document, parts) {}
  [[nodiscard]] RuleReport report(const NetDocument& document) const {
    return check_gluing(document, evaluator, parts, 256, 1).report;
  }
  LabelParts parts;
  LabelEvaluator evaluator;
};

/// Whether L_a L_b⁻¹ = L_c L_d⁻¹, without rounding.
class ExactEquations {
 public:
  explicit ExactEquations(const Setting& setting) : setting_(setting) {}

  bool hold(const std::array<std::uint32_t, 4>& labels) {
    const auto [found, is_new] = known_.try_emplace(labels);
    if (is_new) {
      const auto quotient = [&](std::uint32_t x, std::uint32_t y) { return compose(value(x), inverse(value(y))); };
      const auto [a, b, c, d] = labels;
      found->second = is_identity(compose(inverse(quotient(c, d)), quotient(a, b)));
    }
    return found->second;
  }

 private:
  [[nodiscard]] ExactIsometry value(std::uint32_t number) const {
    return setting_.evaluator.evaluate_exactly(std::get<RationalCrossings>(setting_.parts.crossings), number);
  }

  const Setting& setting_;
  std::map<std::array<std::uint32_t, 4>, bool> known_;
};

/// The first dart, the smaller one of its edge, across which the triangles do not fit.
std::optional<std::uint32_t> first_misfit(const NetDocument& document, ExactEquations& equations) {
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    const std::uint32_t other = opposite(document, dart);
    if (dart < other && !equations.hold({corner_label(document, dart), corner_label(document, next_dart(other)),
                                         corner_label(document, next_dart(dart)), corner_label(document, other)})) {
      return dart;
    }
  }
  return std::nullopt;
}

TEST(GluingCheck, TheFirstEdgeAcrossWhichTrianglesDoNotFitIsNamed) {
  // Some corners of one or two triangles get the label of any others, or none. All is in one chart, so any label may
  // stand anywhere.
  std::mt19937 random(1);
  for (const char* name : {"octagon-9-vertices.json", "octagon-1-vertex.json"}) {
    const NetDocument good = load(std::string("certify/verified/") + name);
    const Setting setting(good);
    ExactEquations equations(setting);
    ASSERT_EQ(first_misfit(good, equations), std::nullopt);
    int fit = 0;
    for (int trial = 0; trial < 600; ++trial) {
      NetDocument document = good;
      const auto any_triangle = [&] { return random() % good.triangles.size(); };
      auto& label = document.triangles[any_triangle()].label;
      switch (trial % 6) {
        case 0:
          label = {0, 0};
          break;
        case 1:
          label[1] = label[0];
          break;
        case 2:
          label[random() % 2] = 0;
          break;
        case 3:
          label = good.triangles[any_triangle()].label;
          break;
        case 4:
          std::swap(label[0], label[1]);
          break;
        default:
          label[random() % 2] = static_cast<std::uint32_t>(random() % (good.labels.size() + 1));
      }
      if (trial % 4 == 0) document.triangles[any_triangle()].label[random() % 2] = 0;
      const auto misfit = first_misfit(document, equations);
      const RuleReport report = setting.report(document);
      fit += !misfit;
      ASSERT_EQ(report.verdict, misfit ? Verdict::refuted : Verdict::verified) << trial << report.text;
      if (misfit) {
        ASSERT_TRUE(report.text.starts_with("the edge of dart " + std::to_string(*misfit) + " ")) << report.text;
      }
    }
    EXPECT_LT(fit, 300);
  }
}

TEST(GluingCheck, EveryEdgeOfSeveralBlocksIsAsked) {
  // More than 16,384 triangles, the length of a block; one corner has the label of another element.
  for (const char* name : {"octagon-9-vertices.json", "octagon-33-vertices.json"}) {
    const NetDocument one = load(std::string("certify/verified/") + name);
    const NetDocument good = copies(one, 1 + 16'400 / static_cast<std::uint32_t>(one.triangles.size()));
    const Setting setting(good);
    EXPECT_EQ(setting.report(good).verdict, Verdict::verified);
    ExactEquations equations(setting);
    for (const std::size_t t : {std::size_t{0}, std::size_t{16'383}, std::size_t{16'384}, good.triangles.size() - 1}) {
      for (std::size_t i = 0; i < 2; ++i) {
        NetDocument document = good;
        std::uint32_t& number = document.triangles[t].label[i];
        number = number % static_cast<std::uint32_t>(one.labels.size()) + 1;
        const auto misfit = first_misfit(document, equations);
        ASSERT_TRUE(misfit.has_value());
        const std::string text = setting.report(document).text;
        EXPECT_TRUE(text.starts_with("the edge of dart " + std::to_string(*misfit) + " ")) << text;
      }
    }
  }
}

TEST(GluingCheck, WithoutADiskNothingIsDecided) {
  const NetDocument good = load("certify/verified/octagon-9-vertices.json");
  const Setting setting(good);
  NetDocument flat = good;
  for (RationalPoint& corner : flat.surface.tiles[0]) corner.y = 0;
  EXPECT_EQ(setting.report(flat).verdict, Verdict::undecided) << setting.report(flat).text;
}

TEST(GluingCheck, TheBaseLeadsToTheCentreOfTheDiskFromAnyChart) {
  const SurfaceDocument surface = load("certify/verified/octagon-9-vertices.json").surface;
  const auto disk = inscribed_disk(surface, 0, 256);
  ASSERT_TRUE(disk.has_value());
  for (const RationalPoint& centre : {RationalPoint{0, 0}, RationalPoint{mpq_class(1, 3), mpq_class(-1, 7)}}) {
    const ExactIsometry frame = translation_to(exact_point(centre));
    // From 0 in the coordinates of the chart to the disk's centre in those of the tile.
    const Move both = rounded(frame) * middle(base_of(*disk, frame, 128));
    const auto part = [&](const mpz_class& x) { return static_cast<Real>(mpq_class(x, disk->centre.m).get_d()); };
    EXPECT_LT(std::abs(image(both, 0) - Complex(part(disk->centre.n.re), part(disk->centre.n.im))), 1e-15);
  }
}

}  // namespace
}  // namespace epsnet::certify::gluing_check_test
