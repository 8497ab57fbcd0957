#include <cmath>
#include <gtest/gtest.h>

#include "certify/check.h"
#include "certify/file/reader.h"
#include "certify/net/numbering.h"
#include "certify/net/triangulation_check.h"
#include "certify/numbers/ball.h"
#include "tests/certify/far_words.h"

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

}  // namespace
}  // namespace epsnet::certify::gluing_check_test
