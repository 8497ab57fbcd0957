#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>
#include <vector>

#include "certify/exact/algebraic.h"
#include "certify/exact/net_rules.h"

/// The second checker's numbers of regular tiles, and its crossings.
namespace epsnet::exact::second_checkers_algebraic_test {
namespace {

double twice_cosine(const RealField& field, long k) {
  return 2 * std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(field.n()));
}

/// That the enclosure of x meets the interval around the value.
void expect_near(const Algebraic& x, double value) {
  const Interval found = enclosure(x);
  EXPECT_EQ(is_less(found, Interval(mpq_class(value - 1e-9))), Answer::no) << value;
  EXPECT_EQ(is_less(Interval(mpq_class(value + 1e-9)), found), Answer::no) << value;
}

struct Tiles {
  Index p, q;
};
constexpr std::array<Tiles, 10> kTiles{
    {{8, 8}, {12, 12}, {7, 3}, {3, 7}, {5, 4}, {4, 6}, {6, 10}, {9, 5}, {3, 100}, {84, 84}}};

TEST(SecondCheckersAlgebraic, ProductsAreThoseOfCosines) {
  for (const auto& [p, q] : kTiles) {
    for (const bool half_turns : {false, true}) {
      const RealField field(p, q, half_turns);
      SCOPED_TRACE(field.n());
      const auto n = static_cast<long>(field.n());
      for (long j = 0; j < n; j += 1 + n / 30) {
        expect_near(field.cosine(j), twice_cosine(field, j));
        for (long k = -n; k < 2 * n; k += 1 + n / 20) {
          EXPECT_EQ(sgn(field.cosine(j) * field.cosine(k) - field.cosine(j + k) - field.cosine(j - k)), 0);
        }
      }
      // Nothing but 0 is 0: the first cosines are independent.
      Algebraic sum;
      for (std::size_t k = 0; k < field.degree(); ++k) sum = sum + field.cosine(static_cast<long>(k) + 1);
      EXPECT_NE(sgn(sum), 0);
    }
  }
}

TEST(SecondCheckersAlgebraic, TheRootIsPositiveAndSquaresToItsSquare) {
  for (const auto& [p, q] : kTiles) {
    const RealField field(p, q, true);
    SCOPED_TRACE(field.n());
    const Algebraic s = field.s();
    EXPECT_EQ(sgn(s), 1);
    EXPECT_EQ(sgn(-s), -1);
    const double c_p = 2 * std::cos(2 * std::numbers::pi / p);
    const double c_q = 2 * std::cos(2 * std::numbers::pi / q);
    expect_near(s * s, (2 - c_q) * (c_p + c_q));
    expect_near(s, std::sqrt((2 - c_q) * (c_p + c_q)));
    expect_near((field.cosine(1) + s) * (field.cosine(1) - 3 * s) + 5,
                (twice_cosine(field, 1) + std::sqrt((2 - c_q) * (c_p + c_q))) *
                        (twice_cosine(field, 1) - 3 * std::sqrt((2 - c_q) * (c_p + c_q))) +
                    5);
  }
}

/// For {4, 6} and {6, 10} the root is 1, and a number can be written in several ways.
TEST(SecondCheckersAlgebraic, ARootThatIsInTheFieldOfTheCosines) {
  for (const auto& [p, q] : {Tiles{4, 6}, Tiles{6, 10}}) {
    const RealField field(p, q, false);
    const Algebraic s = field.s();
    const Algebraic c = field.cosine(1) - 1;
    EXPECT_EQ(sgn(s - 1), 0);
    EXPECT_EQ(sgn(c * s - c), 0);
    EXPECT_EQ(sgn(c * s + c), sgn(c));
    EXPECT_EQ(sgn(-c - c * s), -sgn(c));
    EXPECT_EQ(is_less(enclosure(c * s - c), Interval(0)), Answer::no);
    EXPECT_EQ(is_less(Interval(0), enclosure(c * s - c)), Answer::no);
  }
}

TEST(SecondCheckersAlgebraic, SignsOfNumbersNearZero) {
  const RealField field(8, 8, false);  // √2 and its root of two.
  const Algebraic x = field.cosine(1) - 1;
  expect_near(x, std::numbers::sqrt2 - 1);
  Algebraic power = 1;
  for (int k = 1; k <= 500; ++k) {
    power = power * x;
    EXPECT_EQ(sgn(power), 1);
    EXPECT_EQ(sgn(power * field.s() - power), sgn(field.s() - 1));
    EXPECT_EQ(sgn(-power), -1);
  }
  // (√2 − 1)^500 is about 2^−636.
  const Interval found = enclosure(power);
  EXPECT_EQ(is_less(found, Interval(1, 1, 635)), Answer::yes);
  EXPECT_EQ(is_less(Interval(1, 1, 637), found), Answer::yes);
}

TEST(SecondCheckersAlgebraic, CommonIntegersAreTakenOut) {
  const RealField field(7, 3, false);
  Algebraic x = 6 * field.cosine(1) + 10 * field.s();
  Algebraic y = 14;
  reduce(x, y);
  EXPECT_EQ(sgn(x - 3 * field.cosine(1) - 5 * field.s()), 0);
  EXPECT_EQ(sgn(y - 7), 0);
}

TEST(SecondCheckersAlgebraic, DegreesThatAreTooLargeAreNotTried) {
  EXPECT_THROW(RealField(10'000, 9'999, true), TooLarge);
  EXPECT_THROW(RealField(4'000, 4'000, false), TooLarge);
  EXPECT_EQ(RealField(84, 84, false).degree(), 12U);
}

TEST(SecondCheckersIntervals, ProductsAreThoseOfTheirEnds) {
  // All intervals with ends from −2 to 3.
  for (long a = -2; a <= 3; ++a) {
    for (long b = a; b <= 3; ++b) {
      for (long c = -2; c <= 3; ++c) {
        for (long d = c; d <= 3; ++d) {
          const Interval product = Interval(a, b, 0) * Interval(c, d, 0);
          EXPECT_EQ(product.lower(), static_cast<double>(std::min({a * c, a * d, b * c, b * d})));
          EXPECT_EQ(product.upper(), static_cast<double>(std::max({a * c, a * d, b * c, b * d})));
        }
      }
    }
  }
}

Net tiles_of(Tiles kind, const std::vector<std::array<Index, 2>>& pairs) {
  Net net;
  net.regular = RegularTiles{kind.p, kind.q};
  for (const auto& [s, other] : pairs) net.gluing.push_back({s / kind.p, s % kind.p, other / kind.p, other % kind.p});
  net.epsilon = 1;
  for (Index t = 0; t < net.tile_count(); ++t) net.charts.emplace_back(t, RationalPoint{{0, 0}, 1});
  return net;
}

/// Sides s and s + p/2 of one tile.
std::vector<std::array<Index, 2>> opposite_sides(Index p) {
  std::vector<std::array<Index, 2>> pairs;
  for (Index s = 0; s < p / 2; ++s) pairs.push_back({s, s + p / 2});
  return pairs;
}

/// Two tiles, side s of the first glued to side 2s of the second, modulo p.
std::vector<std::array<Index, 2>> sides_of_a_double(Index p) {
  std::vector<std::array<Index, 2>> pairs;
  for (Index s = 0; s < p; ++s) pairs.push_back({s, p + (2 * s) % p});
  return pairs;
}

TEST(SecondCheckersCrossings, MultiplyToTheIdentityAroundEveryCorner) {
  struct Case {
    Tiles tiles;
    std::vector<std::array<Index, 2>> pairs;
  };
  const std::vector<Case> cases{{{8, 8}, opposite_sides(8)},
                                {{12, 12}, opposite_sides(12)},
                                {{10, 5}, opposite_sides(10)},
                                {{14, 7}, opposite_sides(14)},
                                // Sides whose numbers have an odd sum.
                                {{8, 8}, {{0, 2}, {1, 4}, {3, 6}, {5, 7}}},
                                {{8, 8}, {{0, 3}, {1, 4}, {2, 6}, {5, 7}}},
                                // Two tiles of an odd number of sides.
                                {{5, 10}, sides_of_a_double(5)},
                                {{7, 14}, sides_of_a_double(7)}};
  for (const Case& test : cases) {
    const Net net = tiles_of(test.tiles, test.pairs);
    NetRules<Algebraic> rules(net);
    SCOPED_TRACE(number(test.tiles.p) + ", " + number(test.tiles.q));
    for (Index first = 0; first < rules.sides(); ++first) {
      std::vector<Index> word;
      Index s = first;
      do {
        EXPECT_TRUE(word.empty() || !is_identity(rules.value(rules.tile_of(first), word)));
        word.push_back(s);
        s = rules.side_after(rules.partner(s));
      } while (s != first);
      ASSERT_EQ(word.size(), test.tiles.q);
      EXPECT_TRUE(is_identity(rules.value(rules.tile_of(first), word)));
      // cosh²ρ = |a|²/(|a|² − |b|²).
      const Isometry<Algebraic> g = rules.value(rules.tile_of(first), {first});
      const double cosh = std::cos(std::numbers::pi / test.tiles.q) / std::sin(std::numbers::pi / test.tiles.p);
      const Interval quotient = enclosure(norm(g.a)) / enclosure(norm(g.a) - norm(g.b));
      EXPECT_EQ(is_less(quotient, Interval(mpq_class(cosh * cosh - 1e-9))), Answer::no);
      EXPECT_EQ(is_less(Interval(mpq_class(cosh * cosh + 1e-9)), quotient), Answer::no);
      // The centre comes behind the side of the other tile: g(0) = b/ā = i e^{iπ(l + k)/p} sinh ρ/ā.
      const Complex<Algebraic> image = g.b * g.a;
      const double angle = 2 * std::numbers::pi * rules.vertex_of(rules.partner(first)) / test.tiles.p;
      const Interval length = sqrt(enclosure(norm(image)));
      EXPECT_EQ(is_less(enclosure(image.re) / length, Interval(mpq_class(std::cos(angle) - 1e-9))), Answer::no);
      EXPECT_EQ(is_less(Interval(mpq_class(std::cos(angle) + 1e-9)), enclosure(image.re) / length), Answer::no);
      EXPECT_EQ(is_less(enclosure(image.im) / length, Interval(mpq_class(std::sin(angle) - 1e-9))), Answer::no);
      EXPECT_EQ(is_less(Interval(mpq_class(std::sin(angle) + 1e-9)), enclosure(image.im) / length), Answer::no);
    }
  }
}

}  // namespace
}  // namespace epsnet::exact::second_checkers_algebraic_test
