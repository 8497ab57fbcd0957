#include "certify/claims/geodesics/cut_surface.h"

#include <gtest/gtest.h>
#include <map>

#include "certify/claims/geodesics/exact_side.h"
#include "tests/certify/lifted_reference.h"

/// The pieces that simple closed geodesics leave of the Bolza surface, against its homology.
namespace epsnet::certify {
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
  /// The curves' words begin with a detour, which is gone back at their ends.
  explicit Bolza(const std::string& name, slong precision = 128, const Word& detour = {})
      : lifted_(read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name), geodesics(detour),
                precision) {}

  static std::vector<GeodesicsDocument::ClosedGeodesic> geodesics(const Word& detour) {
    std::vector<GeodesicsDocument::ClosedGeodesic> result;
    for (const Word& word : kSimple) {
      Word all = detour;
      all.insert(all.end(), word.begin(), word.end());
      for (auto side = detour.rbegin(); side != detour.rend(); ++side) all.push_back((*side + 4) % 8);
      result.push_back({0, all, {1, 6}, true});
    }
    return result;
  }

  /// Of elements known to so many bits; with `random` to so many or a few more or less, and anywhere in their balls.
  [[nodiscard]] ChordTable table(const std::vector<std::uint32_t>& curves, int bits = 1000,
                                 std::mt19937* random = nullptr) const {
    std::vector<ChordTable::Member> members;
    for (const std::uint32_t i : curves) {
      const BallIsometry f = lifted_.element(i);
      members.push_back(
          {first_darts(lifted_.net())[0], random != nullptr ? blurred_somehow(f, bits, *random) : blurred(f, bits)});
    }
    return {lifted_.plane(), std::move(members), 1};
  }

  [[nodiscard]] std::optional<Pieces> cut(const std::vector<std::uint32_t>& curves, const ChordTable& chords) const {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t i : curves) numbers.push_back(lifted_.element_number(i));
    return cut_surface(lifted_.plane(), lifted_.evaluator(), chords, numbers);
  }

  /// Of a corner of the triangle of a chord of the table of one curve.
  [[nodiscard]] std::optional<int> exact_side_of(std::uint32_t curve, const ChordTable& chords, ChordTable::Place place,
                                                 std::uint32_t corner) const {
    return exact_side(lifted_.net(), lifted_.evaluator(), chords, lifted_.element_number(curve), place, corner);
  }

  /// By pairs of curves, whether they have no point in common.
  [[nodiscard]] std::vector<std::vector<bool>> disjoint() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < kSimple.size(); ++i) all.push_back(i);
    const ChordTable chords = table(all);
    std::vector<std::vector<bool>> result(all.size(), std::vector<bool>(all.size(), true));
    for (std::uint32_t t = 0; t < lifted_.net().triangles.size(); ++t) {
      for (const auto x : chords.in_triangle(t)) {
        for (const auto y : chords.in_triangle(t)) {
          const Vector m = middle(chords.chord(x).axis);
          const Vector n = middle(chords.chord(y).axis);
          if (std::abs(lorentz(m, n)) < 1 - 1e-9L) result[x.geodesic][y.geodesic] = false;
        }
      }
    }
    return result;
  }

 private:
  LiftedNet lifted_;
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
      const auto pieces = bolza.cut(curves, bolza.table(curves));
      ASSERT_TRUE(pieces.has_value());
      expect_pieces(*pieces, curves);
      ++sizes[curves.size()];
    }
    EXPECT_EQ(sizes[1], 48);
    EXPECT_GT(sizes[2], 20);
    EXPECT_GT(sizes[3], 10);
    EXPECT_EQ(bolza.cut({}, bolza.table({})), (Pieces{{2, {}}}));
  }
}

TEST(CutSurface, SaysNothingRatherThanSomethingWrong) {
  // The less is known of the curves, the less often balls tell on which side a corner lies and in which order curves
  // cut off a corner.
  std::uint32_t some = 0;
  std::uint32_t none = 0;
  const Bolza exact("regular-2-10-vertices.json");
  const auto sets = sets_of_disjoint(exact);
  std::mt19937 random(1);
  for (const slong precision : {64, 128}) {
    const Bolza bolza("regular-2-10-vertices.json", precision);
    for (std::size_t s = 0; s < sets.size(); s += 7) {
      const auto expected = exact.cut(sets[s], exact.table(sets[s]));
      const auto ask = [&](int bits, std::mt19937* somehow) {
        const ChordTable chords = bolza.table(sets[s], bits, somehow);
        if (!chords.complete()) return;
        const auto pieces = bolza.cut(sets[s], chords);
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
    EXPECT_TRUE(bolza.cut(set, bolza.table(set)).has_value());
    EXPECT_FALSE(bolza.cut(twice, bolza.table(twice)).has_value()) << set[0];
  }
}

/// With few bits, where few of a curve's corners lie certainly on a side. From `least_found` bits on nothing else is
/// open.
void expect_exact_sides(const std::string& name, int least_bits, int least_found, std::size_t step,
                        const Word& detour) {
  const Bolza exact(name, 512);
  const auto sets = sets_of_disjoint(exact);
  const Bolza bolza(name, 128, detour);
  std::mt19937 random(1);
  int exactly = 0;
  int approached = 0;
  for (std::size_t s = 0; s < sets.size(); s += step) {
    std::optional<std::optional<Pieces>> expected;
    for (int bits = least_bits; bits < least_bits + 16; bits += 2) {
      for (std::mt19937* somehow : {static_cast<std::mt19937*>(nullptr), &random}) {
        const ChordTable chords = bolza.table(sets[s], bits, somehow);
        if (!chords.complete()) continue;
        int open = 0;
        for (std::size_t i = 0; i < chords.size(); ++i) {
          approached += chords.list(i).approach.empty() ? 0 : 1;
          for (const Chord& chord : chords.list(i).chords) {
            open += static_cast<int>(std::count(chord.side.begin(), chord.side.end(), 0));
          }
        }
        if (open == 0) continue;
        if (!expected) expected = exact.cut(sets[s], exact.table(sets[s]));
        const auto pieces = bolza.cut(sets[s], chords);
        exactly += pieces ? 1 : 0;
        EXPECT_TRUE(pieces || bits < least_found) << name << ": " << s << ", " << bits << " bits";
        EXPECT_TRUE(!pieces || pieces == *expected) << name << ": " << s << ", " << bits << " bits";
      }
    }
  }
  EXPECT_GT(exactly, 3) << name;
  EXPECT_GT(approached, 3) << name;
}

TEST(CutSurface, AsksExactNumbersOnWhichSideACornerLies) {
  for (const Word& detour : {Word{}, Word{1, 3}}) {
    expect_exact_sides("regular-2-10-vertices.json", 4, 16, 1, detour);
    // Vertices that are not the centres of their charts, within rounding of an axis.
    expect_exact_sides("regular-2-26-vertices.json", 24, 30, 12, detour);
  }
}

TEST(CutSurface, AsksOnlyFor128BitsForCornersOnACurve) {
  // Side 0 pairs opposite sides of the octagon: its axis leads through the centre, a vertex.
  const Bolza coarse("regular-2-10-vertices.json", 64);
  const Bolza fine("regular-2-10-vertices.json", 128);
  std::uint32_t through = 0;
  for (std::uint32_t i = 0; i < kSimple.size(); ++i) {
    const ChordTable chords = coarse.table({i});
    bool touches = false;
    for (const Chord& chord : chords.list(0).chords) {
      touches = touches || std::find(chord.side.begin(), chord.side.end(), 0) != chord.side.end();
    }
    EXPECT_EQ(coarse.cut({i}, chords).has_value(), !touches) << i;
    if (touches) ++through;
  }
  EXPECT_GT(through, 2U);
}

TEST(ExactSide, IsWhatBallsSayAndLeftOnTheAxis) {
  int on_axis = 0;
  for (const char* name :
       {"regular-2-10-vertices.json", "regular-2-4-rotated-vertices.json", "octagon-9-vertices.json"}) {
    const LiftedNet lifted(read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name),
                           Bolza::geodesics({}), 512);
    std::vector<ChordTable::Member> members;
    for (std::uint32_t i = 0; i < 12; ++i) members.push_back({first_darts(lifted.net())[0], lifted.element(i)});
    const ChordTable table(lifted.plane(), std::move(members), 1);
    ASSERT_TRUE(table.complete());
    for (std::uint32_t i = 0; i < table.size(); ++i) {
      for (std::uint32_t k = 0; k < table.list(i).chords.size(); ++k) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
          const int side = table.list(i).chords[k].side[corner];
          on_axis += side == 0 ? 1 : 0;
          EXPECT_EQ(exact_side(lifted.net(), lifted.evaluator(), table, lifted.element_number(i), {i, k}, corner),
                    side == 0 ? 1 : side)
              << name << ": geodesic " << i << ", chord " << k << ", corner " << corner;
        }
      }
    }
  }
  EXPECT_GT(on_axis, 5);
}

TEST(ExactSide, OfAWordTooLongNothingIsSaid) {
  // The table has the curve of a short word; the number that is said to be its label's has so many letters before it
  // that the exact product would be too large.
  const Word detour(6000, 0);
  const Bolza of_long_words("regular-2-10-vertices.json", 128, detour);
  const Bolza of_short_words("regular-2-10-vertices.json");
  int with_corner_on_axis = 0;
  for (std::uint32_t i = 0; i < kSimple.size(); ++i) {
    const ChordTable table = of_short_words.table({i});
    bool on_axis = false;
    for (const Chord& chord : table.list(0).chords) {
      on_axis = on_axis || std::find(chord.side.begin(), chord.side.end(), 0) != chord.side.end();
    }
    EXPECT_EQ(of_long_words.exact_side_of(i, table, {0, 0}, 0), std::nullopt);
    if (!on_axis) continue;
    ++with_corner_on_axis;
    EXPECT_NE(of_short_words.cut({i}, table), std::nullopt);
    EXPECT_EQ(of_long_words.cut({i}, table), std::nullopt);
  }
  EXPECT_GT(with_corner_on_axis, 3);
}

}  // namespace
}  // namespace epsnet::certify
