#include "certify/lifted/lifted_plane.h"

#include <gtest/gtest.h>

#include "tests/certify/lifted_reference.h"

/// Vectors, axes and lifted triangles of certify/geodesics against the same in long double; and when two elements are
/// said to be the same.
namespace epsnet::certify::lifted_plane_test {
namespace {

constexpr double kNear = 1e-9;

NetDocument net_of(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

void expect_near(const Vector& x, const Vector& y, const std::string& what) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(static_cast<double>(x[i]), static_cast<double>(y[i]), kNear) << what;
}

Real dot_of(const BallVector& row, const Vector& x) {
  const Vector r = middle(row);
  return r[0] * x[0] + r[1] * x[1] + r[2] * x[2];
}

const std::vector<Complex> kPoints{{0, 0}, {0.3L, 0.1L}, {-0.2L, 0.55L}, {-0.1L, -0.7L}, {0.62L, -0.4L}};

TEST(Lorentz, MatricesMoveVectorsAsIsometriesMovePoints) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const Reference reference(net);
  const LiftedNet lifted(net);
  for (std::uint32_t k = 0; k <= net.labels.size(); ++k) {
    const BallIsometry& label = lifted.plane().label(k);
    const BallMatrix matrix = lorentz_matrix(label, 128);
    for (const Complex z : kPoints) {
      const auto x = static_cast<double>(z.real());
      const auto y = static_cast<double>(z.imag());
      const Vector expected = vector_of(image(reference.label(k), Complex(x, y)));
      const BallVector unit = unit_vector(label, x, y, 128);
      expect_near(middle(unit), expected, "unit_vector");
      expect_near(middle(apply(matrix, unit_vector(identity_isometry(), x, y, 128), 128)), expected, "matrix");
    }
  }
}

TEST(Lorentz, AnAxisIsPositiveOnTheLeftByTheSinhOfTheDistance) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const LiftedNet lifted(net);
  std::uint32_t tested = 0;
  for (std::uint32_t k = 1; k <= net.labels.size(); ++k) {
    const NetDocument::Label& label = net.labels[k - 1];
    if (label.from != label.to) continue;
    for (const bool inverted : {false, true}) {
      BallIsometry f = inverted ? inverse(lifted.plane().label(k)) : lifted.plane().label(k);
      choose_sign(f);
      const BallVector row = axis_row(f, 128);
      for (const Complex z : kPoints) {
        EXPECT_NEAR(static_cast<double>(dot_of(row, vector_of(z))), static_cast<double>(side_of_axis(middle(f), z)),
                    kNear);
      }
      ++tested;
    }
  }
  EXPECT_GT(tested, 4U);
  // Along the real axis to the right: i/2 is on the left.
  BallIsometry shift = identity_isometry();
  arb_set_d(shift.a.re(), std::cosh(1.0));
  arb_set_d(shift.b.re(), std::sinh(1.0));
  EXPECT_NEAR(static_cast<double>(dot_of(axis_row(shift, 64), vector_of({0, 0.5L}))), 4.0 / 3, kNear);
  EXPECT_FALSE(is_finite(axis_row(identity_isometry(), 64)[0])) << "no axis";
}

TEST(Lorentz, SignsAreChosenWhereBallsTellThem) {
  BallIsometry f;
  arb_set_d(f.a.re(), -3);
  arb_set_d(f.a.im(), 1);
  arb_set_d(f.b.re(), 2);
  arb_set_d(f.b.im(), -5);
  EXPECT_EQ(middle(cosh_half_length(f).get()), 3);
  choose_sign(f);
  EXPECT_EQ(middle(f), (Move{{3, -1}, {-2, 5}}));
  choose_sign(f);
  EXPECT_EQ(middle(f), (Move{{3, -1}, {-2, 5}}));
  arb_set_d(f.a.re(), -3);
  mag_set_d(arb_radref(f.a.re()), 4);
  choose_sign(f);
  EXPECT_EQ(middle(f), (Move{{-3, -1}, {-2, 5}})) << "0 is in the ball";
}

TEST(LiftedPlane, PlacesCorners) {
  for (const char* name : {"regular-2-10-vertices.json", "octagon-9-vertices.json"}) {
    const NetDocument net = net_of(name);
    const Reference reference(net);
    const LiftedNet lifted(net);
    for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
      const std::string what = std::string(name) + " dart " + std::to_string(dart);
      expect_near(middle(lifted.plane().corner(dart)), vector_of(reference.corner(dart)), what);
    }
  }
}

TEST(LiftedPlane, LeadsAcrossEveryDart) {
  for (const char* name : {"regular-2-10-vertices.json", "octagon-9-vertices.json"}) {
    const NetDocument net = net_of(name);
    const Reference reference(net);
    const LiftedNet lifted(net);
    std::uint32_t without = 0;
    for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
      const std::uint32_t other = opposite(net, dart);
      const Move expected = reference.transition(dart);
      const LiftedPlane::Transition* transition = lifted.plane().transition(dart);
      if (transition == nullptr) {
        ++without;
        EXPECT_EQ(key_of(expected), key_of({1, 0}));
        expect_near(middle(lifted.plane().corner(dart)), middle(lifted.plane().corner(next_dart(other))), "start");
        expect_near(middle(lifted.plane().corner(next_dart(dart))), middle(lifted.plane().corner(other)), "end");
        continue;
      }
      EXPECT_EQ(key_of(middle(transition->isometry)), key_of(expected));
      expect_near(middle(apply(transition->matrix, lifted.plane().corner(dart), 128)),
                  middle(lifted.plane().corner(next_dart(other))), "start");
      expect_near(middle(apply(transition->matrix, lifted.plane().corner(next_dart(dart)), 128)),
                  middle(lifted.plane().corner(other)), "end");
    }
    EXPECT_GT(without, 0U) << name;
    EXPECT_LT(without, 3 * net.triangles.size()) << name;
  }
}

// Which elements are the same. The chart is that of the centre of the regular octagon; its side pairings move the
// centre by exactly twice the radius of the inscribed disk, the least that any element but 1 does.

/// The element of a word at the centre of the regular octagon.
BallIsometry element_of(const LiftedNet& lifted, std::size_t i) {
  BallIsometry result = lifted.plane().label(lifted.element_number(i));
  choose_sign(result);
  return result;
}

/// The number of the chart at the centre, and a vertex of it.
std::uint32_t central_chart(const NetDocument& net) {
  for (std::uint32_t c = 0; c < net.charts.size(); ++c) {
    if (exact_point(net.charts[c].centre).n == Gaussian{}) return c;
  }
  ADD_FAILURE() << "no chart at the centre";
  return 0;
}

std::vector<GeodesicsDocument::ClosedGeodesic> words_at_centre(const NetDocument& net,
                                                               const std::vector<std::vector<std::uint32_t>>& words) {
  std::uint32_t v = 0;
  while (net.vertices[v].chart != central_chart(net)) ++v;
  std::vector<GeodesicsDocument::ClosedGeodesic> result;
  for (const auto& word : words) result.push_back({v, word, {1, 2}, true});
  return result;
}

/// The ball of both points.
void cover(arb_ptr x, arb_srcptr y) { arb_union(x, x, y, 64); }

BallIsometry both(BallIsometry f, const BallIsometry& g) {
  cover(f.a.re(), g.a.re());
  cover(f.a.im(), g.a.im());
  cover(f.b.re(), g.b.re());
  cover(f.b.im(), g.b.im());
  return f;
}

TEST(LiftedPlane, TellsElementsApart) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  // Sides 0 and 1 have one a and different b, the products of two one b and different a.
  const LiftedNet lifted(net, words_at_centre(net, {{0}, {1}, {0, 1}, {1, 0}, {0, 1, 5, 1}, {4}}));
  const std::uint32_t chart = central_chart(net);
  const LiftedPlane& plane = lifted.plane();
  std::vector<BallIsometry> elements{identity_isometry()};
  for (std::size_t i = 0; i < 6; ++i) elements.push_back(element_of(lifted, i));
  EXPECT_EQ(key_of(middle(elements[3]))[2], key_of(middle(elements[4]))[2]);
  EXPECT_EQ(key_of(middle(elements[3]))[3], key_of(middle(elements[4]))[3]);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::size_t k = 0; k < elements.size(); ++k) {
      // Word 4 is word 2.
      const bool equal = i == k || (i == 3 && k == 5) || (i == 5 && k == 3);
      EXPECT_EQ(plane.same(chart, elements[i], elements[k]), equal ? Tri::yes : Tri::no) << i << ", " << k;
      if (equal) continue;
      BallIsometry turned = elements[i];
      acb_neg(turned.a.get(), turned.a.get());
      acb_neg(turned.b.get(), turned.b.get());
      EXPECT_EQ(plane.same(chart, turned, elements[k]), Tri::unknown) << "no sign is chosen";
      EXPECT_EQ(plane.same(chart, elements[k], turned), Tri::unknown) << "no sign is chosen";
      EXPECT_EQ(plane.same(chart, both(elements[i], elements[k]), elements[k]), Tri::unknown) << i << ", " << k;
      EXPECT_EQ(plane.same(chart, elements[i], both(elements[i], elements[k])), Tri::unknown) << i << ", " << k;
    }
  }
}

TEST(LiftedPlane, ElementsAreTheSameIfTheyMoveTheCentreByLessThanTheDiskIsWide) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const LiftedNet lifted(net, words_at_centre(net, {{0}}));
  const std::uint32_t chart = central_chart(net);
  const BallIsometry one = identity_isometry();
  const BallIsometry side = element_of(lifted, 0);
  // b of the side pairing is −sinh r, r the radius of the disk: a ball up to there holds two elements, one just short
  // of it holds 1 alone.
  for (const auto& [share, expected] : {std::pair{1.000001, Tri::unknown}, {0.999999, Tri::yes}, {0.5, Tri::yes}}) {
    BallIsometry wide = one;
    mag_set_d(arb_radref(wide.b.re()), std::abs(static_cast<double>(middle(side.b.re()))) * share);
    EXPECT_EQ(lifted.plane().same(chart, one, wide), expected) << share;
    EXPECT_EQ(lifted.plane().same(chart, wide, one), expected) << share;
  }
}

/// f, with b anywhere within a distance.
BallIsometry with_wide_b(BallIsometry f, double radius) {
  for (arb_ptr x : {f.b.re(), f.b.im()}) mag_set_d(arb_radref(x), radius);
  return f;
}

TEST(LiftedPlane, EveryChartHasItsDisk) {
  // The same question in every chart, to which the translation from the central one carries it.
  NetDocument net = net_of("regular-2-10-vertices.json");
  for (const RationalPoint& centre : {RationalPoint{{1, 2}, 0}, {0, {-1, 3}}, {{-3, 5}, {2, 7}}}) {
    net.charts.push_back({0, centre});
  }
  const LiftedNet lifted(net, words_at_centre(net, {{0}}));
  const double least = std::abs(static_cast<double>(middle(element_of(lifted, 0).b.re())));
  const BallIsometry one = identity_isometry();
  for (std::uint32_t c = 0; c < net.charts.size(); ++c) {
    const BallIsometry there = inverse(to_balls(translation_to(exact_point(net.charts[c].centre)), 128));
    const auto carried = [&](const BallIsometry& f) { return compose(compose(there, f, 128), inverse(there), 128); };
    EXPECT_EQ(lifted.plane().same(c, one, one), Tri::yes) << c;
    EXPECT_EQ(lifted.plane().same(c, one, carried(with_wide_b(one, 1e-6 * least))), Tri::yes) << c;
    EXPECT_EQ(lifted.plane().same(c, one, carried(with_wide_b(one, 1.000001 * least))), Tri::unknown) << c;
    // What moves 0 little may move the centre of the tile far.
    EXPECT_EQ(lifted.plane().same(c, one, with_wide_b(one, 10)), Tri::unknown) << c;
  }
}

TEST(LiftedPlane, ElementsOfWhichNoSignIsKnownAreNotToldApart) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const LiftedNet lifted(net, words_at_centre(net, {{0}, {1}}));
  const std::uint32_t chart = central_chart(net);
  const BallIsometry f = element_of(lifted, 0);
  BallIsometry g = element_of(lifted, 1);
  EXPECT_EQ(lifted.plane().same(chart, f, g), Tri::no);
  // b tells them apart, or (−a, −b).
  mag_set_d(arb_radref(g.a.re()), 10);
  EXPECT_EQ(lifted.plane().same(chart, f, g), Tri::unknown);
  EXPECT_EQ(lifted.plane().same(chart, g, f), Tri::unknown);
}

TEST(LiftedPlane, WithoutADiskNoElementsAreTheSame) {
  // A tile that is too thin for a disk to be found in it: the group is not discrete for all that is known.
  const NetDocument net = net_of("octagon-9-vertices.json");
  SurfaceOutcome surface = check_surface(net.surface, 1);
  LabelParts parts{std::move(surface.crossings), {}, {}};
  for (const NetDocument::Chart& chart : net.charts) parts.frames.push_back(translation_to(exact_point(chart.centre)));
  const LabelEvaluator evaluator(net, parts);
  NetDocument thin = net;
  const mpq_class height(mpz_class(1), mpz_class("1" + std::string(60, '0')));
  thin.surface.tiles = {{{0, 0}, {{1, 2}, 0}, {{1, 4}, height}}};
  const LiftedPlane plane(thin, evaluator, parts, 128, 64, 1);
  const LiftedPlane known(net, evaluator, parts, 128, 64, 1);
  const BallIsometry one = identity_isometry();
  EXPECT_EQ(known.same(0, one, one), Tri::yes);
  EXPECT_EQ(plane.same(0, one, one), Tri::unknown);
  EXPECT_EQ(plane.same(0, one, with_wide_b(one, 1)), Tri::unknown);
}

}  // namespace
}  // namespace epsnet::certify::lifted_plane_test
