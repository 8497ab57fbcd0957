#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <string>
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

/// That 2^k times the number is as near to its approximation as that says, by one of 500 bits more.
void expect_approximated(const RealNumber& x, mp_bitcnt_t k) {
  constexpr mp_bitcnt_t kMore = 500;
  const Approximation rough = x.approximation(k);
  const Approximation fine = x.approximation(k + kMore);
  EXPECT_LE(abs(mpz_class((rough.value << kMore) - fine.value)), (rough.error << kMore) + fine.error) << k;
}

/// Numbers of which all roundings add up, and those whose large parts cancel.
TEST(SecondCheckersAlgebraic, ApproximationsAreAsNearAsTheySay) {
  for (const auto& [p, q] : kTiles) {
    const RealField field(p, q, false);
    SCOPED_TRACE(field.n());
    for (mp_bitcnt_t k = 0; k < 40; ++k) {
      const auto& rough = field.values(k);
      const auto& fine = field.values(k + 500);
      for (const long factor : {1, -1000}) {
        Cosines x(field.degree());
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = factor * cmp(fine[i], rough[i] << 500);
        trim(x);
        Cosines near_zero;
        if (field.degree() > 1) near_zero = {mpz_class(-(factor * field.values(64)[1]) >> 64), factor};
        for (const Cosines& u : {Cosines{}, x}) {
          for (const Cosines& v : {x, near_zero, Cosines{factor}}) {
            if (u.empty() && v.empty()) continue;
            expect_approximated(real_number(Algebraic(field, u, v)), k);
          }
        }
      }
    }
  }
}

/// The conjugates of u + vs: 2cos(2πj/n) for 2cos(2π/n), j without a common divisor with n, and both roots for s.
TEST(SecondCheckersAlgebraic, BoundsHoldForAllConjugates) {
  for (const auto& [p, q] : kTiles) {
    const RealField field(p, q, false);
    SCOPED_TRACE(field.n());
    const auto n = static_cast<long>(field.n());
    const auto value = [&](const Cosines& x, long j) {
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += x[i].get_d() * (i == 0 ? 1 : twice_cosine(field, j * static_cast<long>(i) % n));
      return sum;
    };
    const mpz_class large = (mpz_class(1) << 40) - 1;
    Cosines all(field.degree());
    for (mpz_class& c : all) c = large;
    for (const Cosines& u : {Cosines{}, Cosines{3}, Cosines{large}, all}) {
      for (const Cosines& v : {Cosines{}, Cosines{1}, Cosines{large}, all}) {
        if (u.empty() && v.empty()) continue;
        const RealNumber x = real_number(Algebraic(field, u, v));
        if (u.size() > 1 || !v.empty()) {
          EXPECT_EQ(x.n, field.n());
          EXPECT_EQ(x.degree, v.empty() ? 1U : 2U);
          EXPECT_EQ(x.field, field.name());
        }
        for (long j = 1; j < n; ++j) {
          if (std::gcd(j, n) != 1) continue;
          // Of a negative square the root is imaginary.
          const double square = value(field.square_of_s(), j);
          const double of_v = std::abs(value(v, j)) * std::sqrt(std::abs(square));
          const double of_u = std::abs(value(u, j));
          EXPECT_LE(square < 0 ? std::hypot(of_u, of_v) : of_u + of_v, std::ldexp(1, static_cast<int>(x.bits)));
        }
      }
    }
  }
}

TEST(SecondCheckersAlgebraic, DegreesOfCosinesAreThoseOfTheirConjugates) {
  for (unsigned long n = 1; n < 100; ++n) {
    std::size_t conjugates = 0;
    for (unsigned long k = 1; k <= std::max(n / 2, 1UL); ++k) conjugates += std::gcd(k, n) == 1 ? 1 : 0;
    EXPECT_EQ(degree_of_cosines(n), conjugates) << n;
  }
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

/// What is wrong with the surface, or "".
std::string outcome(Tiles kind, const std::vector<std::array<Index, 2>>& pairs) {
  const Net net = tiles_of(kind, pairs);
  NetRules<Algebraic> rules(net);
  try {
    rules.rules()[0].ask();
    return "";
  } catch (const Refutation& refutation) {
    return refutation.what;
  }
}

/// Calls visit(pairs) for each way of gluing the sides that are left in pairs.
void each_gluing(const std::vector<Index>& sides, std::vector<std::array<Index, 2>>& pairs, const auto& visit) {
  if (sides.empty()) return visit();
  for (std::size_t i = 1; i < sides.size(); ++i) {
    std::vector<Index> left(sides.begin() + 1, sides.end());
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i - 1));
    pairs.push_back({sides[0], sides[i]});
    each_gluing(left, pairs, visit);
    pairs.pop_back();
  }
}

/// All gluings of a decagon's sides. Behind the corner where a side starts comes the one behind the side that it is
/// glued to.
TEST(SecondCheckersRegularSurfaces, HaveCornersThatMakeAFullTurn) {
  constexpr Index kSides = 10;
  std::vector<std::array<Index, 2>> pairs;
  std::array<int, kSides + 1> good{};
  each_gluing({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, pairs, [&] {
    std::array<Index, kSides> next{};
    for (const auto& [s, other] : pairs) {
      next.at(s) = (other + 1) % kSides;
      next.at(other) = (s + 1) % kSides;
    }
    for (Index q = 3; q <= kSides; ++q) {
      bool is_full = true;
      for (Index first = 0; first < kSides; ++first) {
        Index corners = 1;
        for (Index s = next.at(first); s != first; s = next.at(s)) ++corners;
        is_full = is_full && corners == q;
      }
      ASSERT_EQ(outcome({kSides, q}, pairs).empty(), is_full) << q << ": " << outcome({kSides, q}, pairs);
      good.at(q) += is_full ? 1 : 0;
    }
  });
  // V − 5 + 1 = 2 − 2g for two vertices or for four.
  EXPECT_GT(good[5], 0);
}

/// A tetrahedron, and tori of one square, one hexagon and two triangles.
TEST(SecondCheckersRegularSurfaces, AreHyperbolic) {
  constexpr const char* kNone = "there are no such tiles in the hyperbolic plane";
  EXPECT_EQ(outcome({3, 3}, {{0, 5}, {1, 8}, {2, 11}, {3, 10}, {4, 6}, {7, 9}}), kNone);
  EXPECT_EQ(outcome({4, 4}, opposite_sides(4)), kNone);
  EXPECT_EQ(outcome({6, 3}, opposite_sides(6)), kNone);
  EXPECT_EQ(outcome({3, 6}, {{0, 3}, {1, 4}, {2, 5}}), kNone);
  EXPECT_EQ(outcome({8, 8}, opposite_sides(8)), "");
  EXPECT_EQ(outcome({10, 5}, opposite_sides(10)), "");
}

}  // namespace
}  // namespace epsnet::exact::second_checkers_algebraic_test
