#include <algorithm>
#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/isometries/conjugation.h"
#include "certify/net/rules.h"
#include "netgen/isometries/isometries.h"
#include "netgen/isometries/matches.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// Questions about elements, which the checker answers by other code.
namespace epsnet::exact_conjugacy_test {
namespace {

certify::Crossings crossings_of(const Surface& surface) {
  return certify::check_surface(to_document(surface)).crossings;
}

/// What the checker says.
std::optional<bool> checked(const certify::Crossings& crossings, const std::vector<ElementPair>& pairs) {
  std::vector<certify::ElementPair> letters;
  for (const ElementPair& pair : pairs) letters.push_back({letters_of(pair.from), letters_of(pair.to)});
  return certify::are_conjugate(crossings, letters, {});
}

class ExactConjugacy : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] static Surface surface() {
    const std::string name = GetParam();
    return name == "octagon" ? random_octagon(5) : named_surface(name);
  }
};

TEST_P(ExactConjugacy, IsWhatTheCheckerSays) {
  const Surface surface = ExactConjugacy::surface();
  const certify::Crossings crossings = crossings_of(surface);
  const std::vector<Word> words = generator_words(surface);
  const IsometryGroup group = isometries(surface);
  const std::size_t step = 1 + group.size() / 3;
  int others = 0;
  for (std::size_t i = 0; i < group.size(); i += step) {
    std::vector<ElementPair> pairs;
    const SurfaceIsometry isometry = group.isometry(static_cast<std::uint32_t>(i));
    for (std::size_t k = 0; k < words.size(); ++k) pairs.push_back({words[k], isometry.images[k]});
    EXPECT_EQ(are_conjugate(surface, surface, pairs), true) << i;
    EXPECT_EQ(checked(crossings, pairs), true) << i;
    for (std::size_t k = 0; k < 3; ++k) {
      const Word image = pairs[k].to;
      const Word& next = pairs[(k + 1) % words.size()].to;
      for (const Word& wrong : {reversed(surface, image), next, concatenated(surface, image, next),
                                concatenated(surface, concatenated(surface, next, image), reversed(surface, next))}) {
        pairs[k].to = wrong;
        const auto answer = are_conjugate(surface, surface, pairs);
        EXPECT_EQ(answer, checked(crossings, pairs)) << i << ", " << k;
        if (answer == false) ++others;
      }
      pairs[k].to = image;
    }
  }
  EXPECT_GT(others, 10);
}

TEST_P(ExactConjugacy, AxesCrossWhereTheCheckerSaysSo) {
  const Surface surface = ExactConjugacy::surface();
  const certify::Crossings crossings = crossings_of(surface);
  std::vector<Word> words = generator_words(surface);
  words.resize(std::min<std::size_t>(words.size(), 8));
  for (std::size_t k = words.size(); k-- > 1;) words.push_back(concatenated(surface, words[k], words[k - 1]));
  int crossing = 0;
  int apart = 0;
  for (const Word& first : words) {
    EXPECT_EQ(axes_cross(surface, first, first), false);
    for (const Word& second : words) {
      const auto sign = certify::crossing_sign(crossings, letters_of(first), letters_of(second), {});
      ASSERT_TRUE(sign.has_value());
      EXPECT_EQ(axes_cross(surface, first, second), *sign != 0);
      ++(*sign != 0 ? crossing : apart);
    }
  }
  EXPECT_GT(crossing, 0);
  EXPECT_GT(apart, 0);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, ExactConjugacy, testing::Values("octagon", "bolza", "klein", "bring"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(ExactConjugacyOfWords, RotationsAndReflectionsOfARegularOctagon) {
  const Surface surface = Surface::regular(2);
  const auto answer = [&](const std::vector<std::array<std::vector<std::uint32_t>, 2>>& letters) {
    std::vector<ElementPair> pairs;
    for (const auto& [from, to] : letters) pairs.push_back({word_of_letters(from), word_of_letters(to)});
    return are_conjugate(surface, surface, pairs);
  };
  EXPECT_EQ(answer({{{{0}, {1}}}, {{{1}, {2}}}, {{{2}, {3}}}, {{{3}, {4}}}}), true);
  EXPECT_EQ(answer({{{{0}, {0}}}, {{{1}, {7}}}, {{{2}, {6}}}, {{{3}, {5}}}}), true);
  // Axes that cross at the centre at the angles π/4 and 3π/4.
  EXPECT_EQ(answer({{{{0}, {0}}}, {{{1}, {5}}}}), false);
  // A third element that is turned over.
  EXPECT_EQ(answer({{{{0}, {0}}}, {{{1}, {1}}}, {{{2}, {6}}}}), false);
  // 1 has no axis.
  EXPECT_EQ(answer({{{{0}, {1}}}, {{{1}, {2}}}, {{{}, {3, 7}}}}), true);
  EXPECT_EQ(answer({{{{0}, {1}}}, {{{1}, {2}}}, {{{}, {3}}}}), false);
}

TEST(ExactConjugacyOfWords, NumbersOfTooManyBitsAreNotCompared) {
  const Surface octagon = random_octagon(5);
  const Surface regular = Surface::regular(2);
  const std::vector<ElementPair> pairs{{word_of_letters({0}), word_of_letters({0})},
                                       {word_of_letters({1}), word_of_letters({1})}};
  EXPECT_EQ(are_conjugate(octagon, octagon, pairs), true);
  for (const Surface& surface : {octagon, regular}) {
    const Word far(1'000'000, SideId(0));
    EXPECT_EQ(are_conjugate(surface, surface, std::vector<ElementPair>{pairs[0], pairs[1], {far, far}}), std::nullopt);
    EXPECT_EQ(axes_cross(surface, pairs[0].from, far), std::nullopt);
  }
}

// Against the isometry that was found, with its images changed, and against another surface.
TEST(ExactConjugacyOfDifferentKinds, IsDecidedInACommonField) {
  const Surface bolza = Surface::regular(2);
  const Surface same =
      surface_of_matrices(
          parse_matrices("model su11\n1+sqrt(2) 0 sqrt(2+2*sqrt(2)) 0\n1+sqrt(2) 0 sqrt(1+sqrt(2)) sqrt(1+sqrt(2))\n"
                         "1+sqrt(2) 0 0 sqrt(2+2*sqrt(2))\n1+sqrt(2) 0 -sqrt(1+sqrt(2)) sqrt(1+sqrt(2))\n"))
          .surface;
  const IsometricAnswer answer = isometric(bolza, same);
  ASSERT_EQ(answer.kind, IsometricAnswer::Kind::yes);
  const std::vector<Word> words = generator_words(bolza);
  std::vector<ElementPair> pairs;
  for (std::size_t k = 0; k < words.size(); ++k) pairs.push_back({words[k], answer.isometry->images[k]});
  EXPECT_EQ(are_conjugate(bolza, same, pairs), true);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    std::vector<ElementPair> wrong = pairs;
    wrong[k].to = reversed(same, pairs[k].to);
    EXPECT_EQ(are_conjugate(bolza, same, wrong), false) << k;
    wrong[k].to = concatenated(same, pairs[k].to, pairs[k].to);
    EXPECT_EQ(are_conjugate(bolza, same, wrong), false) << k;
  }
  const Surface octagon = random_octagon(5);
  const std::vector<Word> others = generator_words(octagon);
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k].to = others[k];
  EXPECT_EQ(are_conjugate(bolza, octagon, pairs), false);
}

TEST(ExactConjugacyOfDifferentKinds, IsNotDecidedInAFieldThatIsTooLarge) {
  const Surface wiman = named_surface("wiman-50");
  const Surface octagon = random_octagon(5);
  const std::vector<Word> words = generator_words(wiman);
  const std::vector<Word> others = generator_words(octagon);
  const std::vector<ElementPair> pairs{{words[0], others[0]}, {words[1], others[1]}};
  EXPECT_EQ(are_conjugate(wiman, octagon, pairs), std::nullopt);
}

}  // namespace
}  // namespace epsnet::exact_conjugacy_test
