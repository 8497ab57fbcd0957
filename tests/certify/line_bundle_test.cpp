#include <cmath>
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <random>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "certify/claims/eigenvalues/forms.h"

/// Phases are rational numbers modulo 1.
namespace epsnet::certify::line_bundle_test {
namespace {

mpq_class modulo_1(const mpq_class& x) {
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return mpq_class(x - floor);
}

/// Of a bundle, a number of turns: at least 0 and less than 1.
mpq_class turns(const LineBundle& bundle, Phase phase) {
  EXPECT_LT(phase, bundle.denominator());
  mpq_class result(mpz_class(std::to_string(phase)), mpz_class(std::to_string(bundle.denominator())));
  result.canonicalize();
  return result;
}

/// Multiples of 1/n, n ≤ most, of either sign, some of them 0.
std::vector<mpq_class> random_phases(std::size_t count, std::uint64_t most, std::mt19937_64& random) {
  const std::uint64_t n = 1 + random() % most;
  std::vector<mpq_class> result;
  for (std::size_t i = 0; i < count; ++i) {
    mpq_class phase(mpz_class(std::to_string(random() % n)), mpz_class(std::to_string(n)));
    phase.canonicalize();
    if (random() % 2 == 0) phase = -phase;
    result.push_back(random() % 5 == 0 ? mpq_class(0) : phase);
  }
  return result;
}

RC_GTEST_PROP(LineBundles, AddPhasesAsRationalNumbers, ()) {
  const auto most = *rc::gen::element<std::uint64_t>(3, 12, 1'000'000, 1'000'000'000'000'000'000U);
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint32_t>());
  const std::vector<mpq_class> values = random_phases(6, most, random);
  std::vector<std::string> texts;
  mpz_class denominator = 1;
  for (const mpq_class& value : values) {
    texts.push_back(value.get_str());
    denominator = lcm(denominator, value.get_den());
  }
  RC_ASSERT(phases_problem(texts, texts.size()).value_or("") == "");
  const LineBundle bundle(texts);
  RC_ASSERT(mpz_class(std::to_string(bundle.denominator())) == denominator);
  std::vector<std::uint32_t> word;
  mpq_class sum;
  for (std::uint32_t letters = *rc::gen::inRange(0U, 9U); letters > 0; --letters) {
    word.push_back(static_cast<std::uint32_t>(random() % values.size()));
    sum += values[word.back()];
  }
  RC_ASSERT(turns(bundle, bundle.of(word)) == modulo_1(sum));
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const Phase x = bundle.of(std::vector{i});
    RC_ASSERT(turns(bundle, x) == modulo_1(values[i]));
    for (std::uint32_t k = 0; k < values.size(); ++k) {
      const Phase y = bundle.of(std::vector{k});
      RC_ASSERT(turns(bundle, bundle.sum(x, y)) == modulo_1(mpq_class(values[i] + values[k])));
      RC_ASSERT(turns(bundle, bundle.difference(x, y)) == modulo_1(mpq_class(values[i] - values[k])));
    }
    const Precision scope(64);
    const ComplexBall turn = bundle.turn(x);
    const double angle = 2 * M_PI * values[i].get_d();
    const Interval cosine = outer_interval(real(turn));
    const Interval sine = outer_interval(imaginary(turn));
    RC_ASSERT(std::abs(cosine.lower - std::cos(angle)) < 1e-12 && std::abs(cosine.upper - std::cos(angle)) < 1e-12);
    RC_ASSERT(std::abs(sine.lower - std::sin(angle)) < 1e-12 && std::abs(sine.upper - std::sin(angle)) < 1e-12);
  }
}

TEST(LineBundles, OfFunctionsHaveNoPhases) {
  const LineBundle bundle;
  EXPECT_EQ(bundle.denominator(), 1U);
  EXPECT_EQ(bundle.of(std::vector<std::uint32_t>{3, 8, 3}), 0U);
}

TEST(LineBundles, QuartersOfATurnAreExact) {
  const Precision scope(64);
  const LineBundle bundle(std::vector<std::string>{"1/4", "-1/4", "0.5", "-0.5", "0"});
  const std::vector<std::pair<int, int>> wanted{{0, 1}, {0, -1}, {-1, 0}, {-1, 0}, {1, 0}};
  for (std::uint32_t i = 0; i < wanted.size(); ++i) {
    const ComplexBall turn = bundle.turn(bundle.of(std::vector{i}));
    EXPECT_NE(arb_equal_si(turn.re(), wanted[i].first), 0) << i;
    EXPECT_NE(arb_equal_si(turn.im(), wanted[i].second), 0) << i;
  }
}

TEST(LineBundles, AreWrittenInAtMostFortyCharacters) {
  const auto problem = [](const std::string& phase) { return phases_problem({phase}, 1).value_or(""); };
  const std::string forty = "0.50000000000000000000000000000000000000";
  ASSERT_EQ(forty.size(), 40U);
  EXPECT_EQ(problem(forty), "");
  EXPECT_NE(problem(forty + "0"), "");
  // Denominators up to 10¹⁸, odd ones as well.
  EXPECT_EQ(problem("1/1000000000000000000"), "");
  EXPECT_EQ(problem("1/999999999999999999"), "");
  EXPECT_NE(problem("1/1000000000000000001"), "");
}

}  // namespace
}  // namespace epsnet::certify::line_bundle_test
