#include "certify/net/labels.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "certify/file/file.h"
#include "certify/net/rules.h"
#include "tests/certify/over_field.h"

/// The values of words, over the ring of each kind of surface, and the words of labels.
namespace epsnet::certify::labels_test {
namespace {

NetDocument load(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

bool is_zero(const RegularNumber& x) { return sign(norm(x)) == 0; }

/// Up to a real factor, so as isometries.
bool same(const Isometry<RegularNumber>& f, const Isometry<RegularNumber>& g) {
  return is_zero(f.a * g.b - f.b * g.a) && sign(twice_imaginary(f.a * conjugate(g.a))) == 0 &&
         sign(twice_imaginary(f.b * conjugate(g.b))) == 0;
}

TEST(Labels, ExactWordsOnRegularTilesAreTheProductsOfTheirLetters) {
  // Sides glued in any way; words that turn around vertices, in both directions, and other ones.
  std::mt19937 random(1);
  for (const auto& [p, q, tiles] : {std::array{8U, 8U, 1U}, std::array{7U, 3U, 2U}, std::array{4U, 5U, 3U}}) {
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<std::uint32_t> order(std::size_t{p} * tiles), partner(order.size());
      std::iota(order.begin(), order.end(), 0U);
      std::shuffle(order.begin(), order.end(), random);
      for (std::size_t k = 0; k < order.size(); ++k) partner[order[k]] = order[k ^ 1U];
      const RegularCrossings crossings({p, q}, partner);
      std::vector<std::uint32_t> word{order[0]};
      auto product = crossings.exact(word);
      for (int letter = 0; letter < 12; ++letter) {
        const std::uint32_t other = partner[word.back()];
        const std::uint32_t first = other - other % p;
        // The side after the partner, the one before it, or any.
        const std::uint32_t step = std::array{1U, p - 1, static_cast<std::uint32_t>(random() % p)}[random() % 3];
        word.push_back(first + (other - first + step) % p);
        product = compose(crossings.exact(std::array{word.back()}), product);
        EXPECT_TRUE(same(crossings.exact(word), product)) << p << ", letter " << letter;
      }
    }
  }
}

TEST(Labels, OverAFieldTheyAreTheRationalOnes) {
  NetDocument net = load("octagon-9-vertices.json");
  net.charts[0].centre = {mpq_class(1, 3), mpq_class(-1, 7)};
  NetDocument same_net = net;
  same_net.surface = test::over_field(net.surface);
  const LabelParts rational{check_surface(net.surface).crossings, chart_frames(net.charts, {})};
  const LabelParts field{check_surface(same_net.surface).crossings, chart_frames(net.charts, {})};
  const LabelEvaluator evaluator(net, rational);
  const LabelEvaluator same_evaluator(same_net, field);
  for (std::uint32_t number = 0; number <= net.labels.size(); ++number) {
    const ExactIsometry f = evaluator.evaluate_exactly(std::get<RationalCrossings>(rational.crossings), number);
    const auto g = same_evaluator.evaluate_exactly(std::get<FieldCrossings>(field.crossings), number);
    const NumberField& numbers = *g.a.field;
    EXPECT_TRUE(is_identity(compose(inverse(g), {field_number(numbers, f.a), field_number(numbers, f.b)}))) << number;
  }
}

TEST(Labels, HaveTheirWordsFreelyReduced) {
  NetDocument net = load("octagon-9-vertices.json");
  // Opposite sides of the octagon are glued: 0 with 4, 1 with 5, …
  net.labels[0].word = {0, 1, 5, 2, 6, 4, 3};
  net.labels[1].word = {7, 5};
  const LabelParts parts{check_surface(net.surface).crossings, chart_frames(net.charts, {})};
  const LabelEvaluator evaluator(net, parts);
  using Word = std::vector<std::uint32_t>;
  const auto word = [&](std::uint32_t number) {
    const auto letters = evaluator.word(number);
    return Word(letters.begin(), letters.end());
  };
  EXPECT_EQ(word(0), Word());
  EXPECT_EQ(word(1), Word{3});
  EXPECT_EQ(word(2), (Word{7, 5}));
  // The last factor comes first.
  EXPECT_EQ(evaluator.word(std::array{SignedLabel{2, false}, SignedLabel{1, false}}), Word{5});
  EXPECT_EQ(evaluator.word(std::array{SignedLabel{1, false}, SignedLabel{2, false}}), (Word{7, 5, 3}));
  EXPECT_EQ(evaluator.word(std::array{SignedLabel{2, true}, SignedLabel{0, false}}), (Word{1, 3}));
  EXPECT_EQ(evaluator.word(std::array{SignedLabel{2, true}, SignedLabel{2, false}}), Word());
}

}  // namespace
}  // namespace epsnet::certify::labels_test
