#include "netgen/exchange/anchor_search.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "kernel/plane.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"
#include "tests/support/triangulations.h"

namespace epsnet::anchor_search_test {
namespace {

using testing::HasSubstr;

/// A stream without its anchor, and the surface that is made of it.
void expect_found(TriangulationStream stream) {
  const Surface before = develop(stream, "before");
  stream.anchors.clear();
  const TriangulationStream::Anchor anchor = find_anchor(stream, "f.txt");
  EXPECT_EQ(anchor.points[0], (Complex<Rational>{0, 0}));
  const Surface after = develop(stream, "f.txt");
  // Cross-ratios are exactly the same, and so are lengths, which cross-ratios alone do not determine.
  EXPECT_EQ(triangulation_stream(after).edges, triangulation_stream(before).edges);
  for (std::uint32_t t = 0; t < before.tiles().size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(sinh2_half_distance(after.tiles()[t][i], after.tiles()[t][(i + 1) % 3]),
                sinh2_half_distance(before.tiles()[t][i], before.tiles()[t][(i + 1) % 3]));
    }
  }
}

std::string complaint(TriangulationStream stream) {
  stream.anchors.clear();
  try {
    static_cast<void>(develop(stream, "f.txt"));
  } catch (const ExchangeError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(AnchorSearch, FindsTheDiskOfAllSamples) {
  for (const auto& path : test::data_files("triangulations")) {
    SCOPED_TRACE(path);
    expect_found(read_triangulation_stream(test::file_text(path), "sample"));
  }
}

TEST(AnchorSearch, FindsTheDiskOfPolygons) {
  for (const auto& path : test::data_files("polygons")) {
    SCOPED_TRACE(path);
    expect_found(triangulation_stream(test::imported(path)));
  }
}

TEST(AnchorSearch, FindsTheDiskOfNets) {
  expect_found(triangulation_stream(compute_net(random_octagon(123), Length("0.2")).document));
}

RC_GTEST_PROP(AnchorSearchProperty, FindsTheDiskOfOctagons, (std::int32_t seed)) {
  TriangulationStream stream = triangulation_stream(random_octagon(seed));
  stream.anchors.clear();
  RC_ASSERT(develop(stream, "octagon").genus() == 2U);
}

TEST(AnchorSearch, EveryCrossRatioCounts) {
  for (const auto& path : test::data_files("triangulations")) {
    const TriangulationStream stream = read_triangulation_stream(test::file_text(path), "sample");
    for (std::size_t e = 0; e < stream.edges.size(); e += 7) {
      TriangulationStream bad = stream;
      bad.edges[e].cross_ratio.x += Rational(1, 1000);
      EXPECT_NE(complaint(bad), "accepted") << e;
      for (const int value : {0, 1}) {
        bad.edges[e].cross_ratio = {value, 0};
        EXPECT_NE(complaint(bad), "accepted") << e;
      }
    }
  }
}

TEST(AnchorSearch, SaysThatThereIsNoDisk) {
  TriangulationStream stream = triangulation_stream(random_octagon(1));
  stream.edges.back().cross_ratio.y += Rational(1, 1000);
  EXPECT_THAT(complaint(stream), HasSubstr("the cross-ratios keep no circle of the plane"));
}

/// A symmetric octagon with rational vertices in the disk of radius √ρ, as a triangulation: its cross-ratios are in
/// Q(i) for every ρ, but rational points in the unit disk have these cross-ratios only if ρ is a sum of two squares.
TriangulationStream octagon_of_square_radius(const Rational& rho) {
  using Point = Complex<Rational>;
  const Point one{1, 0};
  const Rational inverse = 1 / rho;
  const auto thousandths = [&](double x) {
    return Rational(static_cast<int>(x * 1000 * std::sqrt(static_cast<double>(Mp256(rho)))), 1000);
  };
  std::vector<Point> z{{thousandths(0.84), 0},
                       {thousandths(0.6), thousandths(0.59)},
                       {0, thousandths(0.84)},
                       {thousandths(-0.6), thousandths(0.6)}};
  // As closed_up in surfaces.h, with products of points divided by ρ.
  const Point w = (z[3] + z[0]) / (one + inverse * conj(z[0]) * z[3]);
  const Point first = (one - inverse * z[0] * conj(z[1])) * (one - inverse * z[1] * conj(z[2]));
  const Rational lambda = rho * (first * (one + inverse * conj(z[0]) * z[2])).y / (first * (z[0] + z[2]) * conj(w)).y;
  const Point moved = lambda * w;
  z[3] = (moved - z[0]) / (one - inverse * conj(z[0]) * moved);
  for (std::size_t k = 0; k < 4; ++k) z.push_back(-z[k]);

  TriangulationStream stream = triangulation_stream(random_octagon(1));
  for (auto& edge : stream.edges) {
    // Triangle t has the corners 0, t + 1, t + 2.
    const auto corner = [&](std::uint32_t dart, std::uint32_t k) {
      const std::uint32_t i = (dart % 3 + k) % 3;
      return i == 0 ? z[0] : z[dart / 3 + i];
    };
    const auto ratio = [&](const Point& p, const Point& from, const Point& to) {
      const auto seen = [&](const Point& q) { return (q - p) / (one - inverse * conj(p) * q); };
      return seen(to) / seen(from);
    };
    const Point sigma = ratio(corner(edge.dart, 0), corner(edge.dart, 1), corner(edge.dart, 2));
    const Point tau = ratio(corner(edge.opposite, 1), corner(edge.opposite, 0), corner(edge.opposite, 2));
    edge.cross_ratio = (sigma - tau) / (sigma * (one - tau));
  }
  return stream;
}

TEST(AnchorSearch, SaysWhereThereIsNoRationalDisk) {
  for (const int rho : {1, 2, 5, 13}) EXPECT_EQ(complaint(octagon_of_square_radius(rho)), "accepted");
  EXPECT_EQ(complaint(octagon_of_square_radius(Rational(13, 10))), "accepted");
  for (const int rho : {3, 7, 21, 35}) {
    EXPECT_THAT(complaint(octagon_of_square_radius(rho)), HasSubstr("there is no anchor, and there can be none"))
        << rho;
  }
}

TEST(AnchorSearch, SaysWhatToWriteWhereNoneIsFound) {
  // The norm of a Gaussian integer with prime factors of 100 digits that no cross-ratio separates cannot be factored.
  const Integer p = norm(Complex<Integer>{boost::multiprecision::pow(Integer(10), 50) + 9, 4});
  const Integer q = norm(Complex<Integer>{boost::multiprecision::pow(Integer(10), 50) + 57, 10});
  EXPECT_THAT(complaint(octagon_of_square_radius(Rational(p * q, boost::multiprecision::pow(Integer(10), 200)))),
              HasSubstr("expected, in place of \"no\": \"yes\", a dart and the three points of its triangle"));
}

TEST(TwoSquares, ASmallNumberHasARootOrAnObstacle) {
  for (int n = 1; n < 2000; ++n) {
    bool is_sum = false;
    for (int x = 0; x * x <= n; ++x) {
      for (int y = 0; x * x + y * y <= n; ++y) is_sum |= x * x + y * y == n;
    }
    const TwoSquares found = two_squares(n, {});
    EXPECT_EQ(found.root.has_value(), is_sum) << n;
    EXPECT_EQ(found.obstacle.has_value(), !is_sum) << n;
    if (found.root) {
      EXPECT_EQ(norm(*found.root), n);
    }
    if (found.obstacle) {
      EXPECT_EQ(*found.obstacle % 4, 3) << n;
    }
  }
  EXPECT_FALSE(two_squares(0, {}).root || two_squares(0, {}).obstacle);
}

TEST(TwoSquares, ProductsOfLargePrimesNeedAHint) {
  const Complex<Integer> p{Integer("1000000000000000000000000000057"), Integer("1000000000000000000000000000100")};
  const Complex<Integer> q{Integer("2000000000000000000000000000000"), Integer("3000000000000000000000000000001")};
  const Integer n = norm(p) * norm(q);
  const TwoSquares found = two_squares(n, {p * Complex<Integer>{3, 5}, q * Complex<Integer>{1, 4}});
  ASSERT_TRUE(found.root.has_value());
  EXPECT_EQ(norm(*found.root), n);
  EXPECT_FALSE(two_squares(n, {}).root || two_squares(n, {}).obstacle);
}

RC_GTEST_PROP(TwoSquaresProperty, HintsAreEnough, ()) {
  Complex<Integer> n{1, 0};
  std::vector<Complex<Integer>> hints;
  for (int k = 0; k < 5; ++k) {
    const auto x = *rc::gen::nonZero<std::int64_t>();
    const auto y = *rc::gen::arbitrary<std::int64_t>();
    n = n * Complex<Integer>{x, y};
    hints.push_back({x, y});
  }
  const TwoSquares found = two_squares(norm(n), hints);
  RC_ASSERT(found.root.has_value());
  RC_ASSERT(norm(*found.root) == norm(n));
}

}  // namespace
}  // namespace epsnet::anchor_search_test
