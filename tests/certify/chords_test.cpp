#include "certify/claims/geodesics/chords.h"

#include <functional>
#include <gtest/gtest.h>
#include <map>

#include "certify/claims/geodesics/chord_table.h"
#include "tests/certify/lifted_reference.h"

/// Chords of closed geodesics against all lifted triangles near an axis, found without looking at sides; and tables of
/// chords where balls do not decide.
namespace epsnet::certify {
namespace {

NetDocument net_of(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

/// A triangle and an element in its chart.
using PairKey = std::pair<std::uint32_t, Key>;

/// All pairs of a triangle and the element in its chart for lifted triangles that the axis meets, as closed sets, with
/// the sides of the corners: −1, 1, or 0 for a corner on the axis. The segment from v to the foot on the axis and the
/// axis lead through triangles with a corner at most d(v, axis) + R away from the axis.
std::map<PairKey, std::array<int, 3>> pairs_of(const Reference& reference, std::uint32_t first_dart,
                                               const Move& element) {
  const NetDocument& net = reference.net();
  const auto conjugated = [](const Move& f, const Move& g) { return f * g * inverted(f); };
  const Move start_element = conjugated(reference.label(corner_label(net, first_dart)), element);
  const Real reach = std::sinh(std::asinh(std::abs(side_of_axis(start_element, reference.corner(first_dart)))) +
                               reference.largest_circumradius());
  std::map<PairKey, std::array<int, 3>> found;
  std::set<PairKey> known;
  std::deque<std::pair<std::uint32_t, Move>> open;
  const auto add = [&](std::uint32_t triangle, const Move& g) {
    if (!known.insert({triangle, key_of(g)}).second) return;
    std::array<int, 3> sides{};
    Real nearest = 1e9;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Real side = side_of_axis(with_sign(g), reference.corner(3 * triangle + i));
      nearest = std::min(nearest, std::abs(side));
      sides[i] = side > 1e-9 ? 1 : side < -1e-9 ? -1 : 0;
    }
    if (nearest > reach) return;
    open.emplace_back(triangle, g);
    const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
    if (*least <= 0 && *most >= 0) found[{triangle, key_of(g)}] = sides;
  };
  add(first_dart / 3, start_element);
  for (; !open.empty(); open.pop_front()) {
    const auto [triangle, g] = open.front();
    for (std::uint32_t dart = 3 * triangle; dart < 3 * triangle + 3; ++dart) {
      add(opposite(net, dart) / 3, conjugated(reference.transition(dart), g));
    }
  }
  return found;
}

/// Words at a vertex: side pairings of the octagon and products of them, with axes through vertices among them.
std::vector<GeodesicsDocument::ClosedGeodesic> words_at(std::uint32_t vertex,
                                                        const std::vector<std::vector<std::uint32_t>>& words) {
  std::vector<GeodesicsDocument::ClosedGeodesic> result;
  for (const auto& word : words) result.push_back({vertex, word, {1, 2}, true});
  return result;
}

using Words = std::vector<std::vector<std::uint32_t>>;

const Words kWords{{0}, {1}, {7}, {0, 1}, {0, 3}, {0, 2, 5}, {0, 1, 6, 6}, {3, 0, 1, 7}, {2, 2, 0, 5}, {0, 0, 1}};

BallIsometry carried(const BallIsometry& f, const BallIsometry& g) {
  BallIsometry result = compose(compose(f, g, 128), inverse(f), 128);
  choose_sign(result);
  return result;
}

struct Tested {
  const char* name;
  std::vector<std::uint32_t> vertices;
};

const std::vector<Tested> kTested{{"regular-2-10-vertices.json", {0, 1, 5}},
                                  {"regular-2-4-rotated-vertices.json", {0, 2}}};

TEST(Chords, AreThePairsOfAllTrianglesThatTheAxisMeets) {
  std::uint32_t found_lists = 0;
  std::uint32_t touching = 0;
  std::uint32_t walked = 0;
  for (const auto& [name, vertices] : kTested) {
    const NetDocument net = net_of(name);
    const Reference reference(net);
    for (const std::uint32_t v : vertices) {
      const LiftedNet lifted(net, words_at(v, kWords));
      const LiftedPlane& plane = lifted.plane();
      const std::uint32_t first = first_darts(net)[v];
      for (std::size_t i = 0; i < kWords.size(); ++i) {
        const std::string what = std::string(name) + " vertex " + std::to_string(v) + " word " + std::to_string(i);
        const BallIsometry element = lifted.element(i);
        const auto expected = pairs_of(reference, first, middle(element));
        const auto list = find_chords(plane, first, element);
        ASSERT_TRUE(list.has_value()) << what;
        ++found_lists;
        std::map<PairKey, std::array<int, 3>> found;
        for (const Chord& chord : list->chords) {
          EXPECT_TRUE(found.try_emplace({chord.triangle, key_of(middle(chord.element))}, chord.side).second) << what;
          const auto [least, most] = std::minmax_element(chord.side.begin(), chord.side.end());
          EXPECT_EQ(chord.is_certain(), *least < 0 && *most > 0);
          if (!chord.is_certain()) ++touching;
        }
        // What is 0 here, is so to 30 bits: the ends of a triangle that the axis nearly misses.
        for (const auto& [pair, sides] : expected) {
          const bool met = std::find(sides.begin(), sides.end(), 1) != sides.end() &&
                           std::find(sides.begin(), sides.end(), -1) != sides.end() &&
                           std::find(sides.begin(), sides.end(), 0) == sides.end();
          EXPECT_TRUE(!met || found.contains(pair)) << what;
        }
        for (const auto& [pair, sides] : found) {
          ASSERT_TRUE(expected.contains(pair)) << what;
          for (std::uint32_t k = 0; k < 3; ++k) {
            EXPECT_TRUE(sides[k] == expected.at(pair)[k] || expected.at(pair)[k] == 0) << what;
          }
        }
        // The way to each chord.
        BallIsometry here = carried(plane.label(corner_label(net, first)), element);
        std::uint32_t triangle = first / 3;
        const auto across = [&](std::uint32_t dart) {
          EXPECT_EQ(dart / 3, triangle) << what;
          if (const auto* transition = plane.transition(dart)) here = carried(transition->isometry, here);
          triangle = opposite(net, dart) / 3;
        };
        for (const std::uint32_t dart : list->approach) across(dart);
        walked += !list->approach.empty() ? 1 : 0;
        for (const Chord& chord : list->chords) {
          if (chord.parent != Chord::kNone) {
            triangle = list->chords[chord.parent].triangle;
            here = list->chords[chord.parent].element;
            across(chord.dart);
          }
          EXPECT_EQ(triangle, chord.triangle) << what;
          EXPECT_EQ(key_of(middle(here)), key_of(middle(chord.element))) << what;
        }
      }
    }
  }
  EXPECT_GT(found_lists, 40U);
  EXPECT_GT(touching, 0U) << "axes through vertices";
  EXPECT_GT(walked, 5U) << "axes that do not meet the first triangle";
}

TEST(Chords, EndWhereTheVisitorSaysSo) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const LiftedNet lifted(net, words_at(0, kWords));
  const std::uint32_t first = first_darts(net)[0];
  const auto all = find_chords(lifted.plane(), first, lifted.element(6));
  ASSERT_TRUE(all.has_value());
  for (std::size_t last = 1; last <= all->chords.size(); ++last) {
    std::vector<PairKey> seen;
    const auto list = find_chords(lifted.plane(), first, lifted.element(6), [&](const Chord& chord) {
      seen.emplace_back(chord.triangle, key_of(middle(chord.element)));
      return seen.size() < last;
    });
    ASSERT_TRUE(list.has_value());
    ASSERT_EQ(seen.size(), last);
    for (std::size_t i = 0; i < last; ++i) {
      EXPECT_EQ(seen[i], PairKey(all->chords[i].triangle, key_of(middle(all->chords[i].element))));
    }
  }
}

/// Whether the balls of a chord's element hold this one, of which one sign is meant.
bool may_be(const Chord& chord, const Key& element) {
  const BallIsometry& f = chord.element;
  const std::array<Ball, 4> numbers{real(f.a), imaginary(f.a), real(f.b), imaginary(f.b)};
  for (std::size_t i = 0; i < 4; ++i) {
    const Interval x = outer_interval(numbers[i]);
    if (1e-6 * static_cast<double>(element[i] + 1) < x.lower || x.upper < 1e-6 * static_cast<double>(element[i] - 1)) {
      return false;
    }
  }
  return true;
}

/// That a list holds each of the pairs, and what it says of every chord.
void expect_all(const ChordList& list, const std::map<PairKey, std::array<int, 3>>& expected, const std::string& what) {
  for (const Chord& chord : list.chords) {
    EXPECT_EQ(chord.is_certain(), std::find(chord.side.begin(), chord.side.end(), 1) != chord.side.end() &&
                                      std::find(chord.side.begin(), chord.side.end(), -1) != chord.side.end())
        << what;
    EXPECT_EQ(certainly_positive(real(chord.element.a)), Tri::yes) << what;
  }
  // A chord for each, no chord for two: whoever comes last may push others on.
  std::vector<const PairKey*> taken(list.chords.size(), nullptr);
  const std::function<bool(const PairKey&, std::vector<char>&)> place = [&](const PairKey& pair,
                                                                            std::vector<char>& tried) {
    for (std::size_t i = 0; i < list.chords.size(); ++i) {
      const Chord& chord = list.chords[i];
      if (tried[i] != 0 || chord.triangle != pair.first || !may_be(chord, pair.second)) continue;
      tried[i] = 1;
      if (taken[i] != nullptr && !place(*taken[i], tried)) continue;
      taken[i] = &pair;
      return true;
    }
    return false;
  };
  for (const auto& [pair, sides] : expected) {
    std::vector<char> tried(list.chords.size(), 0);
    EXPECT_TRUE(place(pair, tried)) << what;
  }
}

TEST(Chords, AreAllFoundOrNone) {
  // The less is known of an element, the less often balls tell sides and equality: then more pairs may be found, or
  // nothing is said; never are some missing.
  std::mt19937 random(1);
  std::uint32_t some = 0;
  std::uint32_t none = 0;
  for (const auto& [name, vertices] : kTested) {
    const NetDocument net = net_of(name);
    const Reference reference(net);
    for (const std::uint32_t v : vertices) {
      const LiftedNet lifted(net, words_at(v, kWords));
      const std::uint32_t first = first_darts(net)[v];
      for (std::size_t i = 0; i < kWords.size(); ++i) {
        const auto expected = pairs_of(reference, first, middle(lifted.element(i)));
        for (int bits = 0; bits < 45; ++bits) {
          for (const bool somehow : {false, true}) {
            const BallIsometry element =
                somehow ? blurred_somehow(lifted.element(i), bits, random) : blurred(lifted.element(i), bits);
            const auto list = find_chords(lifted.plane(), first, element);
            ++(list ? some : none);
            const std::string what = std::string(name) + ": word " + std::to_string(i) + ", " + std::to_string(bits);
            if (list) expect_all(*list, expected, what + " bits");
          }
        }
      }
    }
  }
  EXPECT_GT(some, 1000U);
  EXPECT_GT(none, 500U);
}

TEST(Chords, AreNotFoundWhereOneMayBeAnother) {
  // A geodesic with strands so near to each other, and an element of so few bits, that one strand's may be the other's.
  std::mt19937 random(1);
  int found = 0;
  for (const Words& words : {Words{{0, 0, 3, 0}}, Words{{4, 4, 3, 3}}}) {
    const NetDocument net = net_of("regular-2-4-rotated-vertices.json");
    const LiftedNet lifted(net, words_at(0, words));
    const std::uint32_t first = first_darts(net)[0];
    const auto expected = pairs_of(Reference(net), first, middle(lifted.element(0)));
    for (int trial = 0; trial < 2000; ++trial) {
      const int bits = -2 + static_cast<int>(random() % 16);
      std::size_t visits = 0;
      const auto list = find_chords(lifted.plane(), first, blurred_somehow(lifted.element(0), bits, random),
                                    [&](const Chord&) { return ++visits < 1000; });
      if (!list || visits == 1000) continue;
      expect_all(*list, expected, std::to_string(words[0][0]) + ", " + std::to_string(trial));
      ++found;
    }
  }
  EXPECT_GT(found, 5);
}

/// The translation by 2 along the line from p to q.
Move along(Complex p, Complex q) {
  const Move to_p{1 / std::sqrt(1 - std::norm(p)), p / std::sqrt(1 - std::norm(p))};
  const Complex w = image(inverted(to_p), q);
  return to_p * Move{std::cosh(Real{1}), std::sinh(Real{1}) * w / std::abs(w)} * inverted(to_p);
}

/// The key of an axis (chords.cpp).
Real key_number(const Move& f) {
  const Real sinh = std::sqrt(f.first.real() * f.first.real() - 1);
  return std::abs(-577 * f.second.imag() + 341 * f.second.real() - 199 * f.first.imag()) / sinh;
}

BallIsometry to_ball(const Move& f) {
  BallIsometry result;
  const auto set = [](arb_ptr x, Real value) {
    arb_set_d(x, static_cast<double>(value));
    Ball rest;
    arb_set_d(rest.get(), static_cast<double>(value - Real{static_cast<double>(value)}));
    arb_add(x, x, rest.get(), 128);
  };
  set(result.a.re(), f.first.real());
  set(result.a.im(), f.first.imag());
  set(result.b.re(), f.second.real());
  set(result.b.im(), f.second.imag());
  choose_sign(result);
  return result;
}

TEST(Chords, AreToldApartWhereTheirKeysAreEqual) {
  // Lines, of no element of the group, that meet two lifts of a triangle so that the keys are equal there: chords are
  // two all the same.
  const NetDocument net = net_of("regular-2-4-rotated-vertices.json");
  const Reference reference(net);
  const LiftedNet lifted(net);
  int found = 0;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const auto inside = [&](Real weight) {
      Complex sum = 0;
      const std::array<Real, 3> weights{weight, (1 - weight) / 2, (1 - weight) / 2};
      for (std::uint32_t i = 0; i < 3; ++i) sum += weights[i] * reference.corner(3 * t + i);
      return sum;
    };
    for (const Lift& lift : reference.lifts(t, inside(0.4L), 2.5L)) {
      if (lift.triangle != t || key_of(lift.to_chart) == key_of({1, 0})) continue;
      const auto line = [&](Real weight) {
        return along(inside(weight), image(inverted(lift.to_chart), inside(0.3L)));
      };
      const auto there = [&](Real weight) { return lift.to_chart * line(weight) * inverted(lift.to_chart); };
      const auto difference = [&](Real weight) { return key_number(line(weight)) - key_number(there(weight)); };
      Real low = 0.15L, high = 0.85L;
      if (difference(low) * difference(high) > 0) continue;
      const bool rises = difference(low) < 0;
      for (int step = 0; step < 60; ++step) {
        const Real middle = (low + high) / 2;
        ((difference(middle) < 0) == rises ? low : high) = middle;
      }
      // As seen from the vertex where dart 3t starts, in whose chart the triangle is.
      int seen = 0;
      bool is_there = false;
      const auto list = find_chords(lifted.plane(), 3 * t, blurred(to_ball(line(low)), 40), [&](const Chord& chord) {
        EXPECT_NEAR((chord.key.lower + chord.key.upper) / 2, static_cast<double>(key_number(middle(chord.element))),
                    1e-6);
        is_there = is_there || (chord.triangle == t && key_of(middle(chord.element)) == key_of(there(low)));
        return !is_there && ++seen < 40;
      });
      EXPECT_TRUE(list.has_value()) << t;
      EXPECT_TRUE(is_there) << t;
      ++found;
    }
  }
  EXPECT_GT(found, 3);
}

TEST(Chords, AreNotFoundWhereAllCornersMayLieOnOneSide) {
  // Two triangles back to back, which are no triangulation: one corner on the axis, so that its side is not decided.
  NetDocument net;
  net.epsilon = "1";
  net.surface.regular_genus = 2;
  net.charts = {{0, {0, 0}}};
  net.triangles = {{{0, 1, 2}, {5, 4, 3}, {0, 0}}, {{0, 2, 1}, {2, 1, 0}, {0, 0}}};
  const LiftedNet any(net_of("regular-2-10-vertices.json"), words_at(0, {{0}}));
  const Complex b = middle(any.element(0)).second;
  const Complex along = b / std::abs(b);
  const auto found = [&](Complex y, Complex z) {
    net.vertices = {{0, 0, 0}};
    for (const Complex point : {y * along, z * along}) {
      net.vertices.push_back({static_cast<double>(point.real()), static_cast<double>(point.imag()), 0});
    }
    const LiftedNet lifted(net, words_at(0, {{0}}));
    return find_chords(lifted.plane(), 0, lifted.element(0)).has_value();
  };
  EXPECT_TRUE(found({0.1L, 0.3L}, {0.1L, -0.3L}));
  EXPECT_TRUE(found({0.1L, -0.3L}, {0.1L, 0.3L}));
  EXPECT_FALSE(found({0.1L, 0.3L}, {-0.1L, 0.3L})) << "left";
  EXPECT_FALSE(found({0.1L, -0.3L}, {-0.1L, -0.3L})) << "right";
}

TEST(Chords, AreNotFoundForWhatHasNoAxis) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const LiftedNet lifted(net, words_at(0, kWords));
  const std::uint32_t first = first_darts(net)[0];
  EXPECT_FALSE(find_chords(lifted.plane(), first, identity_isometry()).has_value());
  BallIsometry turned = lifted.element(0);
  EXPECT_TRUE(find_chords(lifted.plane(), first, turned).has_value());
  mag_set_d(arb_radref(turned.a.re()), 5);
  EXPECT_FALSE(find_chords(lifted.plane(), first, turned).has_value()) << "no sign is chosen";
}

TEST(Chords, TheFirstDartLeavesTheVertex) {
  for (const char* name : {"regular-2-10-vertices.json", "octagon-1-vertex.json"}) {
    const NetDocument net = net_of(name);
    const auto darts = first_darts(net);
    ASSERT_EQ(darts.size(), net.vertices.size());
    for (std::uint32_t v = 0; v < darts.size(); ++v) {
      EXPECT_EQ(start(net, darts[v]), v);
      for (std::uint32_t dart = 0; dart < darts[v]; ++dart) EXPECT_NE(start(net, dart), v);
    }
  }
}

TEST(Chords, TranslationLengthsAreRoundedOutward) {
  BallIsometry f = identity_isometry();
  for (const int sign : {1, -1}) {
    arb_set_d(f.a.re(), sign * std::cosh(1.5));
    const Interval length = translation_length(f, 128);
    EXPECT_NEAR(length.lower, 3, 1e-14);
    EXPECT_NEAR(length.upper, 3, 1e-14);
    EXPECT_LT(length.lower, length.upper);
  }
  arb_set_d(f.a.re(), 1.5);
  mag_set_d(arb_radref(f.a.re()), 0.25);
  EXPECT_LE(translation_length(f, 128).lower, 2 * std::acosh(1.25));
  EXPECT_GT(translation_length(f, 128).lower, 1);
  EXPECT_GE(translation_length(f, 128).upper, 2 * std::acosh(1.75));
  EXPECT_LT(translation_length(f, 128).upper, 3);
  mag_set_d(arb_radref(f.a.re()), 1);
  const Interval unknown = translation_length(f, 128);
  EXPECT_EQ(unknown.lower, 0);
  EXPECT_EQ(unknown.upper, std::numeric_limits<double>::infinity());
}

// Tables.

/// The words' chords at vertex 0 of the Bolza surface.
class Table {
 public:
  explicit Table(const Words& words, std::uint32_t vertex = 0, slong precision = 128)
      : lifted(net_of("regular-2-10-vertices.json"), words_at(vertex, words), precision) {
    std::vector<ChordTable::Member> members;
    for (std::size_t i = 0; i < words.size(); ++i) {
      members.push_back({first_darts(lifted.net())[vertex], lifted.element(i)});
    }
    table.emplace(lifted.plane(), std::move(members), 1);
  }

  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  LiftedNet lifted;
  std::optional<ChordTable> table;
};

constexpr Interval kAnyLength{0.5, 8};

TEST(ChordTable, IsCompleteOnlyWithTheChordsOfAllMembers) {
  EXPECT_TRUE(Table(Words{{0}, {0, 1}}).table->complete());
  EXPECT_FALSE(Table(Words{{0}, {}}).table->complete());
  EXPECT_FALSE(Table(Words{{}, {0}}).table->complete());
  EXPECT_FALSE(Table(Words{{0}, {}, {0, 1}}).table->complete());
}

TEST(ChordTable, KnowsWhichChordsLieInATriangle) {
  const Table tested(Words{{0}, {0, 1}, {0, 3}, {0, 1, 6, 6}}, 5);
  const ChordTable& table = *tested.table;
  std::size_t chords = 0;
  for (std::uint32_t t = 0; t < tested.lifted.net().triangles.size(); ++t) {
    std::size_t here = 0;
    for (std::uint32_t i = 0; i < table.size(); ++i) {
      for (const ChordTable::Place place : table.in_triangle(t, i)) {
        EXPECT_EQ(place.geodesic, i);
        EXPECT_EQ(table.chord(place).triangle, t);
        ++here;
      }
    }
    EXPECT_EQ(here, table.in_triangle(t).size());
    chords += here;
  }
  std::size_t all = 0;
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    all += table.list(i).chords.size();
    EXPECT_EQ(table.first_dart(i), first_darts(tested.lifted.net())[5]);
  }
  EXPECT_EQ(chords, all);
}

TEST(ChordTable, SaysNeitherYesNorNoOfAChordThatIsNotKnown) {
  const Table tested(Words{{0}, {0, 1}});
  const ChordTable& table = *tested.table;
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (Chord chord : table.list(i).chords) {
      EXPECT_EQ(table.find(chord, kAnyLength).found, Tri::yes);
      EXPECT_EQ(table.find(chord, kAnyLength, i).found, Tri::no);
      EXPECT_EQ(table.find(chord, kAnyLength, 1 - i).found, Tri::yes);
      EXPECT_EQ(table.find(chord, {0.5, 1}).found, Tri::no) << "all are longer";
      for (const bool turned : {false, true}) {
        Chord wide = chord;
        if (turned) wide.element = inverse(wide.element);
        wide.element = blurred(wide.element, -3);
        EXPECT_EQ(table.find(wide, kAnyLength).found, Tri::unknown);
        EXPECT_EQ(table.find(wide, kAnyLength, i).found, Tri::no) << "other axes";
      }
      // Exponents that are too many, too large or not bounded decide nothing.
      EXPECT_EQ(table.find(chord, {1, 1e3}).found, Tri::unknown);
      EXPECT_EQ(table.find(chord, {1e8, 1e8}).found, Tri::unknown);
      EXPECT_EQ(table.find(chord, {1, std::numeric_limits<double>::infinity()}).found, Tri::unknown);
    }
  }
}

TEST(ChordTable, FindsAChordAtTheEndsOfALengthThatIsNotWellKnown) {
  const LiftedNet lifted(net_of("regular-2-10-vertices.json"), words_at(0, {{0}}));
  BallIsometry wide = lifted.element(0);
  for (arb_ptr x : {wide.a.re(), wide.a.im(), wide.b.re(), wide.b.im()}) arb_add_error_2exp_si(x, -20);
  const ChordTable table(lifted.plane(), {{first_darts(lifted.net())[0], wide}}, 1);
  ASSERT_TRUE(table.complete());
  const auto [lower, upper] = table.length(0);
  ASSERT_GT(upper - lower, 1e-7);
  const ChordTable exact(lifted.plane(), {{first_darts(lifted.net())[0], lifted.element(0)}}, 1);
  const Chord& chord = exact.list(0).chords.front();
  for (const Interval length : {Interval{lower, lower}, {upper, upper}, {lower, upper}, {0, upper}, {lower, 8}}) {
    EXPECT_EQ(table.find(chord, length).found, Tri::yes) << length.lower << ", " << length.upper;
  }
  EXPECT_EQ(table.find(chord, {lower - 1e-5, lower - 1e-6}).found, Tri::no);
  EXPECT_EQ(table.find(chord, {upper + 1e-6, upper + 1e-5}).found, Tri::no);
}

TEST(ChordTable, FindsAPowerAtTheEndsOfItsLength) {
  const Table tested(Words{{0}, {0, 0, 0}, {0, 0, 0, 0, 0, 0}});
  const ChordTable& table = *tested.table;
  const double once = (table.length(0).lower + table.length(0).upper) / 2;
  for (const std::uint32_t i : {1U, 2U}) {
    const std::uint32_t power = 3 * i;
    const Chord& chord = table.list(i).chords.front();
    const auto find = [&](double lower, double upper) { return table.find(chord, {lower * once, upper * once}, i); };
    for (const auto& [lower, upper] :
         {std::pair{power - 1e-9, power + 1e-9}, {power - 1e-9, power + 0.9}, {power - 0.9, power + 1e-9}}) {
      const ChordTable::Match match = find(lower, upper);
      EXPECT_EQ(match.found, Tri::yes);
      EXPECT_EQ(match.power, i == 1 || match.geodesic == 0 ? power : 2);
    }
    EXPECT_EQ(table.find(chord, table.length(i), i).found, Tri::yes);
    EXPECT_EQ(find(power + 0.01, power + 0.99).found, Tri::no) << "no whole number between";
    EXPECT_EQ(find(0.5, 0.9).found, Tri::no);
  }
  // The third power is no power of the sixth.
  EXPECT_EQ(table.find(table.list(1).chords.front(), table.length(1), 0).geodesic, 1U);
}

/// What a table says of geodesic i: whether another one is it or its root, whether it crosses itself, and another one.
std::array<Tri, 3> answers(const ChordTable& table, std::uint32_t i) {
  return {table.find_other(i).found, table.crosses_itself(i), table.crosses_another(i)};
}

/// Words at one vertex, and what is true of each.
struct TrueAnswers {
  Words words;
  std::vector<std::array<Tri, 3>> expected;
};

/// Geodesics on one axis have the product 1, which balls do not tell from less.
std::vector<TrueAnswers> true_answers() {
  constexpr Tri kNo = Tri::no, kYes = Tri::yes, kOpen = Tri::unknown;
  return {{{{0}, {4}}, {{kYes, kNo, kOpen}, {kYes, kNo, kOpen}}},
          {{{0}, {1, 0, 5}, {2}}, {{kYes, kNo, kYes}, {kYes, kNo, kYes}, {kNo, kNo, kYes}}},
          {{{0}, {2}, {1, 0, 5}}, {{kYes, kNo, kYes}, {kNo, kNo, kYes}, {kYes, kNo, kYes}}},
          {{{2}, {0}, {1, 0, 5}}, {{kNo, kNo, kYes}, {kYes, kNo, kYes}, {kYes, kNo, kYes}}},
          {{{0, 0}, {4}}, {{kYes, kNo, kOpen}, {kNo, kNo, kOpen}}},
          {{{0, 1}, {0, 3}}, {{kNo, kNo, kYes}, {kNo, kNo, kYes}}},
          {{{0, 1, 6, 6}, {1}}, {{kNo, kYes, kYes}, {kNo, kNo, kYes}}},
          {{{0, 1, 4, 5}}, {{kNo, kNo, kNo}}},
          {{{0, 2}, {0, 0, 2}}, {{kNo, kNo, kYes}, {kNo, kNo, kYes}}}};
}

TEST(ChordTable, FindsPowersAndCrossingsWhateverTheBits) {
  for (const auto& [words, expected] : true_answers()) {
    int complete = 0;
    for (slong precision = 8; precision <= 128; precision += precision < 64 ? 1 : 64) {
      const Table tested(words, 0, precision);
      if (!tested.table->complete()) continue;
      ++complete;
      for (std::uint32_t i = 0; i < words.size(); ++i) {
        const auto found = answers(*tested.table, i);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_TRUE(found[k] == expected[i][k] || (precision < 64 && found[k] == Tri::unknown))
              << "words " << words[0].size() << ", " << i << ", question " << k << ", " << precision << " bits";
        }
      }
    }
    EXPECT_GT(complete, 20);
  }
}

TEST(ChordTable, FindsPowersAndCrossingsHoweverWellEachGeodesicIsKnown) {
  std::mt19937 random(1);
  for (const auto& [words, expected] : true_answers()) {
    const Table exact(words);
    int complete = 0;
    for (int trial = 0; trial < 120; ++trial) {
      std::vector<ChordTable::Member> members;
      for (std::size_t i = 0; i < words.size(); ++i) {
        const BallIsometry element = exact.lifted.element(i);
        const int bits = static_cast<int>(random() % 40);
        members.push_back(
            {first_darts(exact.lifted.net())[0], bits > 30 ? element : blurred_somehow(element, bits, random)});
      }
      const ChordTable table(exact.lifted.plane(), std::move(members), 1);
      if (!table.complete()) continue;
      ++complete;
      for (std::uint32_t i = 0; i < words.size(); ++i) {
        const auto found = answers(table, i);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_TRUE(found[k] == expected[i][k] || found[k] == Tri::unknown)
              << "words " << words[0].size() << ", " << i << ", question " << k << ", trial " << trial;
        }
        // What is listed is found, whichever chord is asked about.
        for (const Chord& chord : exact.table->list(i).chords) {
          EXPECT_NE(table.find(chord, exact.table->length(i)).found, Tri::no) << i << ", trial " << trial;
        }
        for (const Chord& chord : table.list(i).chords) {
          EXPECT_NE(table.find(chord, exact.table->length(i)).found, Tri::no) << i << ", trial " << trial;
        }
      }
    }
    EXPECT_GT(complete, 20);
  }
}

TEST(ChordTable, ComparesAxesThatLeadAlongEdges) {
  // The net's vertex is the centre of the 12-gon, and side pairings lead along edges: no chord has corners on both
  // sides, so that any of them may be missing of another list.
  const NetDocument net = net_of("regular-3-centre.json");
  const Words words{{0}, {6}, {1}, {1, 0, 7}, {0, 0}};
  const LiftedNet lifted(net, words_at(0, words));
  std::mt19937 random(1);
  const auto table_of = [&](const std::vector<std::size_t>& listed, int bits) {
    std::vector<ChordTable::Member> members;
    for (const std::size_t i : listed) {
      const BallIsometry f = lifted.element(i);
      members.push_back({first_darts(net)[0], bits < 60 ? blurred_somehow(f, bits, random) : f});
    }
    return ChordTable(lifted.plane(), std::move(members), 1);
  };
  const std::vector<std::pair<std::vector<std::size_t>, std::vector<Tri>>> cases{
      {{0, 1}, {Tri::yes, Tri::yes}},
      {{0, 2}, {Tri::no, Tri::no}},
      {{0, 3}, {Tri::yes, Tri::yes}},
      {{2, 0, 1}, {Tri::no, Tri::yes, Tri::yes}},
      {{4, 1, 2}, {Tri::yes, Tri::no, Tri::no}},
      {{0}, {Tri::no}}};
  for (const auto& [listed, expected] : cases) {
    const ChordTable exact = table_of(listed, 1000);
    ASSERT_TRUE(exact.complete());
    for (const Chord& chord : exact.list(0).chords) EXPECT_FALSE(chord.is_certain());
    for (std::size_t i = 0; i < listed.size(); ++i) {
      EXPECT_EQ(exact.find_other(static_cast<std::uint32_t>(i)).found, expected[i]) << listed[0] << ", " << i;
    }
    for (int trial = 0; trial < 200; ++trial) {
      const ChordTable table = table_of(listed, trial % 40);
      if (!table.complete()) continue;
      for (std::size_t i = 0; i < listed.size(); ++i) {
        const Tri found = table.find_other(static_cast<std::uint32_t>(i)).found;
        EXPECT_TRUE(found == expected[i] || found == Tri::unknown) << listed[0] << ", " << i << ", trial " << trial;
      }
    }
  }
}

TEST(ChordTable, FindsTheOnlyCrossingInWhateverOrderChordsAreFound) {
  // Chords begin near the vertex. What a geodesic crosses does not depend on that.
  const Words words{{0, 1, 6, 6}, {0, 1}, {0, 3}, {0}, {1}};
  for (const char* name : {"regular-2-10-vertices.json", "octagon-9-vertices.json", "octagon-33-vertices.json"}) {
    const NetDocument net = net_of(name);
    std::vector<std::vector<Tri>> all;
    for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
      const LiftedNet lifted(net, words_at(v, words), 512);
      const auto table_of = [&](std::initializer_list<std::size_t> listed) {
        std::vector<ChordTable::Member> members;
        for (const std::size_t i : listed) members.push_back({first_darts(net)[v], lifted.element(i)});
        ChordTable table(lifted.plane(), std::move(members), 1);
        EXPECT_TRUE(table.complete()) << name << v << ": " << *listed.begin();
        return table;
      };
      std::vector<Tri>& found = all.emplace_back();
      for (std::size_t i = 0; i < words.size(); ++i) {
        found.push_back(table_of({i}).crosses_itself(0));
        for (std::size_t k = 0; k < i; ++k) {
          const ChordTable table = table_of({i, k});
          found.push_back(table.crosses_another(0));
          EXPECT_EQ(table.crosses_another(1), found.back()) << name << ", vertex " << v << ": " << i << ", " << k;
        }
      }
      EXPECT_EQ(found, all.front()) << name << ", vertex " << v;
    }
    EXPECT_NE(std::find(all[0].begin(), all[0].end(), Tri::no), all[0].end());
    EXPECT_NE(std::find(all[0].begin(), all[0].end(), Tri::yes), all[0].end());
  }
}

TEST(ChordTable, AChordThatMayBeMissedTellsNothingOfAnother) {
  // Vertices on axes, moved by 10⁻⁹. Of two lists of one geodesic that which is known to fewer bits has more chords:
  // triangles that the axis only nearly meets.
  int more = 0;
  for (const char* name : {"regular-2-10-vertices.json", "regular-2-4-rotated-vertices.json"}) {
    NetDocument net = net_of(name);
    for (std::size_t v = 0; v < net.vertices.size(); ++v) {
      net.vertices[v].x += 1e-9 * static_cast<double>(v + 1);
      net.vertices[v].y -= 1e-9 * static_cast<double>(v + 2);
    }
    const LiftedNet lifted(net, words_at(0, kWords));
    const std::uint32_t dart = first_darts(net)[0];
    for (std::size_t i = 0; i < kWords.size(); ++i) {
      for (int bits = 8; bits < 40; ++bits) {
        const BallIsometry element = lifted.element(i);
        const ChordTable table(lifted.plane(), {{dart, blurred(element, bits)}, {dart, element}}, 1);
        if (!table.complete()) continue;
        more += table.list(0).chords.size() > table.list(1).chords.size() ? 1 : 0;
        EXPECT_NE(table.find_other(0).found, Tri::no) << name << ": " << i << ", " << bits << " bits";
        EXPECT_NE(table.find_other(1).found, Tri::no) << name << ": " << i << ", " << bits << " bits";
      }
    }
  }
  EXPECT_GT(more, 20);
}

TEST(ChordTable, AnAxisBesideEdgesIsFoundWhicheverChordIsTheFirst) {
  // Vertices are 10⁻¹² off the axes that led along edges. With few bits all triangles along an edge may be met, and
  // none certainly; those on one side of it are not.
  NetDocument net = net_of("regular-2-26-vertices.json");
  for (std::size_t v = 0; v < net.vertices.size(); ++v) {
    net.vertices[v].x += 1e-12 * static_cast<double>(v + 1);
    net.vertices[v].y -= 1e-12 * static_cast<double>(v + 2);
  }
  int beside = 0;
  for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
    const LiftedNet lifted(net, words_at(v, {{0}, {1}, {2}, {3}}));
    for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
      if (start(net, dart) != v) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const BallIsometry element = lifted.element(i);
        const ChordTable table(lifted.plane(), {{dart, blurred(element, 25)}, {dart, element}}, 1);
        if (!table.complete()) continue;
        const std::vector<Chord>& chords = table.list(0).chords;
        if (std::any_of(chords.begin(), chords.end(), [](const Chord& chord) { return chord.is_certain(); })) continue;
        beside += table.find(chords[0], table.length(0), 0).found == Tri::no ? 1 : 0;
        EXPECT_EQ(table.find_other(0).found, Tri::yes) << i << ", dart " << dart;
      }
    }
  }
  EXPECT_GT(beside, 50);
}

TEST(ChordTable, APowerIsFoundWithItsRootOrNotDenied) {
  std::mt19937 random(1);
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const std::uint32_t dart = first_darts(net)[0];
  int yes = 0;
  int open = 0;
  for (std::uint32_t power = 1; power <= 6; ++power) {
    const Words words{{1}, std::vector<std::uint32_t>(power, 0), {0}};
    const LiftedNet lifted(net, words_at(0, words), 256);
    for (int trial = 0; trial < 150; ++trial) {
      const BallIsometry root = trial == 0 ? lifted.element(2) : blurred_somehow(lifted.element(2), trial % 30, random);
      const ChordTable table(lifted.plane(), {{dart, lifted.element(0)}, {dart, lifted.element(1)}, {dart, root}}, 1);
      if (!table.complete()) continue;
      const ChordTable::Match match = table.find_other(1);
      EXPECT_NE(match.found, Tri::no) << power << ", trial " << trial;
      (match.found == Tri::yes ? yes : open) += 1;
      if (match.found != Tri::yes) continue;
      EXPECT_EQ(match.geodesic, 2U) << power << ", trial " << trial;
      EXPECT_EQ(match.power, power) << trial;
    }
  }
  EXPECT_GT(yes, 100);
  EXPECT_GT(open, 5);
}

}  // namespace
}  // namespace epsnet::certify
