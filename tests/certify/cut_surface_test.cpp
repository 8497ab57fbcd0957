#include <gtest/gtest.h>
#include <map>
#include <numeric>

#include "certify/claims/geodesics/axis_crossings.h"
#include "tests/certify/lifted_reference.h"

/// The pieces that simple closed geodesics leave of the Bolza surface, against its homology.
namespace epsnet::certify::cut_surface_test {
namespace {

using Word = std::vector<std::uint32_t>;
using Pieces = std::vector<GeodesicsDocument::Piece>;

/// The simple closed geodesics of the regular octagon of length at most 6, up to orientation.
const std::vector<Word> kSimple{{5, 3, 0},
                                {3, 0, 5, 2, 4, 7},
                                {2, 1, 4, 6},
                                {6, 0, 7, 4, 2},
                                {7, 2, 3},
                                {2, 5, 2, 7, 6},
                                {6, 0, 5, 2, 2},
                                {3, 6, 3, 0, 7},
                                {2, 0, 3, 6},
                                {6, 0, 2, 7, 4, 2},
                                {2, 1, 6},
                                {7, 0, 3},
                                {7, 7, 1, 3},
                                {6, 1, 6, 3, 0, 2},
                                {2, 7, 2, 5, 0, 6},
                                {1, 4, 7, 6},
                                {7, 4, 2, 7, 4, 1, 0, 3},
                                {3, 0, 2, 7},
                                {6, 1, 6, 3, 0, 3, 5, 2},
                                {5, 0, 5, 2},
                                {6, 1, 4, 1, 3, 0, 5, 2},
                                {7, 5, 0, 3, 0, 3},
                                {5, 2, 7, 2},
                                {4, 2},
                                {7, 1, 6, 1, 3},
                                {1, 4, 7, 4, 6},
                                {7, 4, 1, 7, 2},
                                {7, 5, 2, 7, 4, 2, 3},
                                {6, 4, 7, 4, 2},
                                {6, 1, 4, 6, 3},
                                {0, 5, 0, 3, 6},
                                {5, 7, 2, 5, 0},
                                {2, 3, 0, 3, 6},
                                {3, 0, 5, 0, 7},
                                {7, 5, 2, 0, 5, 2},
                                {2, 4, 3, 6},
                                {7, 5, 2, 7, 4},
                                {2, 3},
                                {3, 2, 5, 2, 7},
                                {1, 4, 7, 1, 6},
                                {6, 0, 5, 5, 2},
                                {7, 4, 7, 2, 5, 2},
                                {7, 2, 2},
                                {7, 4, 7, 2, 7, 0, 3},
                                {0, 5, 3, 0, 5, 2},
                                {6, 3, 0, 5, 0, 3},
                                {0, 1},
                                {1, 2}};

/// The class of a word in H₁ = ℤ⁴: side k + 4 is side k backward.
std::array<int, 4> homology(const Word& word) {
  std::array<int, 4> result{};
  for (const std::uint32_t side : word) result[side % 4] += side < 4 ? 1 : -1;
  return result;
}

class Bolza {
 public:
  explicit Bolza(const std::string& name, slong precision = 128)
      : lifted_(read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name), geodesics(),
                precision) {}

  static std::vector<GeodesicsDocument::ClosedGeodesic> geodesics() {
    std::vector<GeodesicsDocument::ClosedGeodesic> result;
    for (const Word& word : kSimple) result.push_back({0, word, {1, 6}, true});
    return result;
  }

  /// Of elements known to so many bits; with `random` to so many or a few more or less, and anywhere in their balls.
  /// Nothing if it is not known which edges one of them crosses.
  [[nodiscard]] std::optional<std::vector<AxisCrossings>> crossings(const std::vector<std::uint32_t>& curves,
                                                                    int bits = 1000,
                                                                    std::mt19937* random = nullptr) const {
    std::vector<AxisCrossings> result;
    for (const std::uint32_t i : curves) {
      const BallIsometry f = lifted_.element(i);
      auto found = axis_crossings(moved_, first_darts(lifted_.net())[0],
                                  random != nullptr ? blurred_somehow(f, bits, *random) : blurred(f, bits));
      if (!found) return std::nullopt;
      result.push_back(*std::move(found));
    }
    return result;
  }

  [[nodiscard]] std::optional<Pieces> cut(const std::vector<AxisCrossings>& curves) const {
    return cut_surface(moved_, curves);
  }
  [[nodiscard]] std::optional<Pieces> cut(const std::vector<std::uint32_t>& curves) const {
    const auto found = crossings(curves);
    EXPECT_TRUE(found);
    return found ? cut(*found) : std::nullopt;
  }

  /// By pairs of curves, whether they have no point in common.
  [[nodiscard]] std::vector<std::vector<bool>> disjoint() const {
    std::vector<std::uint32_t> all(kSimple.size());
    std::iota(all.begin(), all.end(), 0U);
    const auto found = crossings(all);
    std::vector<std::vector<bool>> result(all.size(), std::vector<bool>(all.size(), true));
    for (const std::uint32_t i : all) {
      for (const std::uint32_t j : all) {
        for (std::size_t k = 0; k < found->at(i).darts.size(); ++k) {
          for (std::size_t m = 0; m < found->at(j).darts.size(); ++m) {
            if (found->at(i).darts[k] / 3 != found->at(j).darts[m] / 3) continue;
            const Real product = lorentz(middle(found->at(i).axes[k]), middle(found->at(j).axes[m]));
            if (std::abs(product) < 1 - 1e-9L) result[i][j] = false;
          }
        }
      }
    }
    return result;
  }

 private:
  LiftedNet lifted_;
  MovedNet moved_{lifted_.plane()};
};

/// What holds for the pieces of a surface of genus 2 cut along disjoint simple geodesics, no two the same: each side of
/// each bounds one piece; χ of all is −2, that of each negative; the boundary of a piece is 0 in homology, and nothing
/// else is among the curves, so that there is one piece more than they have relations.
void expect_pieces(const Pieces& pieces, const std::vector<std::uint32_t>& curves) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  int euler = 0;
  for (const GeodesicsDocument::Piece& piece : pieces) {
    std::array<int, 4> boundary{};
    for (const auto& [geodesic, side] : piece.boundaries) {
      ++sides[{geodesic, side}];
      const auto around = homology(kSimple[curves[geodesic]]);
      for (std::size_t k = 0; k < 4; ++k) boundary[k] += side == 0 ? around[k] : -around[k];
    }
    EXPECT_EQ(boundary, (std::array<int, 4>{}));
    const int chi = 2 - 2 * static_cast<int>(piece.genus) - static_cast<int>(piece.boundaries.size());
    EXPECT_LT(chi, 0);
    euler += chi;
    EXPECT_TRUE(std::is_sorted(piece.boundaries.begin(), piece.boundaries.end()));
  }
  EXPECT_EQ(euler, -2);
  EXPECT_EQ(sides.size(), 2 * curves.size());
  for (const auto& [side, count] : sides) EXPECT_EQ(count, 1);
  // The relations, by elimination over ℚ.
  std::vector<std::array<double, 4>> rows;
  for (const std::uint32_t i : curves) {
    const auto h = homology(kSimple[i]);
    rows.push_back({double(h[0]), double(h[1]), double(h[2]), double(h[3])});
  }
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 4 && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && std::abs(rows[pivot][column]) < 1e-9) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const double factor = rows[i][column] / rows[rank][column];
      for (std::size_t k = 0; k < 4; ++k) rows[i][k] -= factor * rows[rank][k];
    }
    ++rank;
  }
  EXPECT_EQ(pieces.size(), 1 + curves.size() - rank);
}

/// All sets of one, two or three disjoint curves.
std::vector<std::vector<std::uint32_t>> sets_of_disjoint(const Bolza& bolza) {
  const auto disjoint = bolza.disjoint();
  std::vector<std::vector<std::uint32_t>> result;
  for (std::uint32_t i = 0; i < kSimple.size(); ++i) {
    result.push_back({i});
    for (std::uint32_t j = 0; j < i; ++j) {
      if (!disjoint[i][j]) continue;
      result.push_back({i, j});
      for (std::uint32_t k = 0; k < j; ++k) {
        if (disjoint[i][k] && disjoint[j][k]) result.push_back({i, j, k});
      }
    }
  }
  return result;
}

TEST(CutSurface, LeavesThePiecesThatHomologySays) {
  // Which curves are simple and disjoint does not depend on the metric, if the octagon is glued in the same way.
  for (const char* name :
       {"regular-2-10-vertices.json", "regular-2-4-rotated-vertices.json", "octagon-9-vertices.json"}) {
    const Bolza bolza(name, 512);
    std::array<int, 4> sizes{};
    for (const std::vector<std::uint32_t>& curves : sets_of_disjoint(bolza)) {
      const auto pieces = bolza.cut(curves);
      ASSERT_TRUE(pieces.has_value());
      expect_pieces(*pieces, curves);
      ++sizes[curves.size()];
    }
    EXPECT_EQ(sizes[1], 48);
    EXPECT_GT(sizes[2], 20);
    EXPECT_GT(sizes[3], 10);
    EXPECT_EQ(bolza.cut(std::vector<std::uint32_t>{}), (Pieces{{2, {}}}));
  }
}

TEST(CutSurface, SaysNothingRatherThanSomethingWrong) {
  // The less is known of the curves, the less often balls tell which edges they cross and in which order they cut off a
  // corner.
  std::uint32_t some = 0;
  std::uint32_t none = 0;
  const Bolza exact("regular-2-10-vertices.json");
  const auto sets = sets_of_disjoint(exact);
  std::mt19937 random(1);
  for (const slong precision : {64, 128}) {
    const Bolza bolza("regular-2-10-vertices.json", precision);
    for (std::size_t s = 0; s < sets.size(); s += 7) {
      const auto expected = exact.cut(sets[s]);
      const auto ask = [&](int bits, std::mt19937* somehow) {
        const auto curves = bolza.crossings(sets[s], bits, somehow);
        const auto pieces = curves ? bolza.cut(*curves) : std::nullopt;
        ++(pieces ? some : none);
        EXPECT_TRUE(!pieces || pieces == expected) << s << ": " << bits << " bits";
      };
      for (int bits = 0; bits < 40; bits += 2) {
        ask(bits, nullptr);
        ask(bits, &random);
      }
    }
  }
  EXPECT_GT(some, 20U);
  EXPECT_GT(none, 10U);
}

TEST(CutSurface, LeavesOpenInWhichOrderArcsLie) {
  // A curve and itself, which balls do not tell apart, alone and with another one.
  const Bolza bolza("regular-2-10-vertices.json");
  for (const auto& set : sets_of_disjoint(bolza)) {
    if (set.size() > 2) continue;
    std::vector<std::uint32_t> twice = set;
    twice.push_back(set[0]);
    EXPECT_TRUE(bolza.cut(set).has_value());
    EXPECT_FALSE(bolza.cut(twice).has_value()) << set[0];
  }
}

}  // namespace
}  // namespace epsnet::certify::cut_surface_test
