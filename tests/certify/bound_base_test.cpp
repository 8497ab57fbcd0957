#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "certify/claims/bound/triangles.h"
#include "certify/net/numbering.h"

/// Flips and splits of triangulations (docs/proof.md, Lemma 21.2).
namespace epsnet::certify::bound_base_test {
namespace {

/// Elements of a group that is not commutative: matrices of integers modulo a prime, which are equal only if they are.
struct Matrix {
  std::uint64_t a = 1, b = 0, c = 0, d = 1;
  bool operator==(const Matrix&) const = default;
};
constexpr std::uint64_t kPrime = 1'000'003;
Matrix operator*(const Matrix& x, const Matrix& y) {
  return {(x.a * y.a + x.b * y.c) % kPrime, (x.a * y.b + x.b * y.d) % kPrime, (x.c * y.a + x.d * y.c) % kPrime,
          (x.c * y.b + x.d * y.d) % kPrime};
}
/// Of determinant 1.
Matrix inverse(const Matrix& x) { return {x.d, (kPrime - x.b) % kPrime, (kPrime - x.c) % kPrime, x.a}; }

/// Two triangles with one vertex, a torus, and elements as free as that allows.
class Steps : public testing::Test {
 protected:
  void SetUp() override {
    base = {{{3, 4, 5, 0, 1, 2}, {0, 2, 4, 1, 3, 5}}, std::vector<std::uint32_t>(6), {}};
    // Around the triangles fgh = 1 and f⁻¹g⁻¹h⁻¹ = 1: f and g commute.
    const Matrix f{1, 5, 0, 1}, g{1, 7, 0, 1};
    elements = {f, g, inverse(f * g), Matrix{}};
  }
  [[nodiscard]] Matrix along(std::uint32_t number) const {
    return number % 2 == 0 ? elements[number / 2] : inverse(elements[number / 2]);
  }
  void expect_consistent() const {
    const Map& map = base.map;
    ASSERT_EQ(base.start.size(), map.opposite.size());
    for (std::uint32_t d = 0; d < map.opposite.size(); ++d) {
      const std::uint32_t e = map.opposite[d];
      EXPECT_NE(e, d);
      EXPECT_EQ(map.opposite[e], d);
      EXPECT_EQ(along(map.element[d]) * along(map.element[e]), Matrix{}) << d;
      EXPECT_EQ(base.start[d], base.start[next_dart(e)]) << d;
    }
    for (std::uint32_t d = 0; d < map.opposite.size(); d += 3) {
      EXPECT_EQ(along(map.element[d]) * along(map.element[d + 1]) * along(map.element[d + 2]), Matrix{}) << d;
    }
  }

  Base base;
  std::vector<Matrix> elements;
};

TEST_F(Steps, KeepOppositesInverseAndTrianglesClosed) {
  expect_consistent();
  std::mt19937 random(3);
  int flips = 0;
  for (int step = 0; step < 200; ++step) {
    const auto d = static_cast<std::uint32_t>(random() % base.map.opposite.size());
    if (d / 3 == base.map.opposite[d] / 3) continue;
    if (step % 4 == 0) {
      const std::size_t triangles = base.start.size() / 3;
      split(base, d, 6);
      EXPECT_EQ(base.start.size() / 3, triangles + 2);
    } else {
      const Product product = flip(base, d, static_cast<std::uint32_t>(elements.size()));
      elements.push_back(along(product.first) * along(product.second));
      ++flips;
    }
    expect_consistent();
  }
  EXPECT_GT(flips, 50);
}

TEST_F(Steps, ASplitHasANewVertexBetweenTheEndsOfItsEdge) {
  split(base, 1, 6);
  ASSERT_EQ(base.midpoints.size(), 1U);
  EXPECT_EQ(base.midpoints[0].from, 0U);
  EXPECT_EQ(base.midpoints[0].to, 0U);
  EXPECT_EQ(base.midpoints[0].element, 2U);
  // From a to m the identity, from m on to b what led there.
  EXPECT_EQ(along(base.map.element[1]), Matrix{});
  EXPECT_EQ(base.start[next_dart(1)], 1U);
  EXPECT_EQ(along(base.map.element[6]), elements[1]);
  EXPECT_EQ(base.start[6], 1U);
  int darts = 0;
  for (const std::uint32_t vertex : base.start) darts += vertex == 1 ? 1 : 0;
  EXPECT_EQ(darts, 4);
}

}  // namespace
}  // namespace epsnet::certify::bound_base_test
