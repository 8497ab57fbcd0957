#include <gtest/gtest.h>

#include "certify/claims/geodesics/sequences.h"
#include "tests/certify/lifted_reference.h"

/// Exact comparisons of lengths against long double, on a surface over each ring; and on surfaces where a length is
/// 2 arsinh 1, or nearly that.
namespace epsnet::certify::exact_traces_test {
namespace {

using Word = std::vector<std::uint32_t>;

const std::vector<Word> kWords{{0},       {1},          {4},          {2},          {0, 1},         {1, 0},
                               {0, 3},    {0, 0},       {2, 2},       {0, 2, 5},    {0, 1, 6, 6},   {3, 0, 1, 7},
                               {0, 0, 1}, {1, 0, 0, 5}, {2, 2, 0, 5}, {7, 3, 2, 1}, {0, 1, 2, 1, 5}};

NetDocument net_of(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/" + name);
}

TEST(ExactTraces, OrderLengths) {
  for (const char* name : {"verified/regular-2-10-vertices.json", "verified/octagon-9-vertices.json"}) {
    std::vector<GeodesicsDocument::ClosedGeodesic> geodesics;
    for (const Word& word : kWords) geodesics.push_back({0, word, {1, 2}, true});
    const LiftedNet lifted(net_of(name), geodesics, 512);
    const ExactTraces traces(lifted.evaluator());
    int ties = 0;
    for (std::size_t i = 0; i < kWords.size(); ++i) {
      for (std::size_t k = 0; k < kWords.size(); ++k) {
        const Real difference =
            middle(cosh_half_length(lifted.element(i)).get()) - middle(cosh_half_length(lifted.element(k)).get());
        const int expected = difference > 1e-12L ? 1 : difference < -1e-12L ? -1 : 0;
        EXPECT_EQ(traces.compare(kWords[i], kWords[k]), expected) << name << ": " << i << ", " << k;
        if (i != k && expected == 0) ++ties;
      }
      const Real difference = middle(cosh_half_length(lifted.element(i)).get()) - std::sqrt(Real{2});
      EXPECT_EQ(traces.compare_with_short(kWords[i]), difference > 0 ? 1 : -1) << name << ": " << i;
    }
    EXPECT_GT(ties, 3) << name;
  }
}

TEST(ExactTraces, TellALengthFrom2Arsinh1) {
  for (const auto& [name, expected] : {std::pair{"one-curve-of-2-arsinh-1.json", 0},
                                       {"one-curve-of-2-arsinh-1-less-1e-20.json", -1},
                                       {"no-curve-of-2-arsinh-1-and-1e-20-more.json", 1}}) {
    const LiftedNet lifted(read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/" + name).net);
    const ExactTraces traces(lifted.evaluator());
    EXPECT_EQ(traces.compare_with_short(Word{0}), expected) << name;
    EXPECT_EQ(traces.compare_with_short(Word{4}), expected) << name;
    EXPECT_EQ(traces.compare_with_short(Word{1, 0, 5}), expected) << name;
    EXPECT_EQ(traces.compare_with_short(Word{0, 0}), 1) << name;
  }
}

TEST(ExactTraces, SayNothingOfWordsThatAreTooLong) {
  const LiftedNet lifted(net_of("verified/octagon-9-vertices.json"));
  const ExactTraces traces(lifted.evaluator());
  Word lengthy;
  for (int i = 0; i < 150'000; ++i) lengthy.push_back(i % 2 == 0 ? 0 : 1);
  Word longer = lengthy;
  longer.push_back(0);
  const Word one{0};
  EXPECT_EQ(traces.compare(one, lengthy), std::nullopt);
  EXPECT_EQ(traces.compare(lengthy, one), std::nullopt);
  EXPECT_EQ(traces.compare(longer, lengthy), std::nullopt);
  EXPECT_EQ(traces.compare_with_short(lengthy), std::nullopt);
  EXPECT_EQ(traces.compare(lengthy, lengthy), 0) << "one word";
  EXPECT_EQ(traces.compare({}, one), std::nullopt) << "1 has no axis";
  EXPECT_EQ(traces.compare(one, {}), std::nullopt) << "1 has no axis";
  EXPECT_EQ(traces.compare_with_short({}), std::nullopt) << "1 has no axis";
}

}  // namespace
}  // namespace epsnet::certify::exact_traces_test
