#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <rapidcheck/gtest.h>
#include <string>
#include <utility>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "tests/kernel/random_points.h"
#include "tests/kernel/rational_points.h"
#include "tests/support/scale.h"

namespace epsnet::isometry_test {
namespace {

using test::rational_isometry;
using test::rational_point;
using test::rational_rotation;

/// True for the same map: pairs (a, b) that differ by a real factor.
bool same(const Isometry<Rational>& f, const Isometry<Rational>& g) {
  // Compared at three points.
  const Complex<Rational> p{Rational(1, 3), Rational(1, 5)};
  const Complex<Rational> q{Rational(-2, 7), Rational(1, 2)};
  return f(p) == g(p) && f(q) == g(q) && f({}) == g({});
}

RC_GTEST_PROP(IsometryProperty, StaysInTheDisk, ()) {
  const Isometry<Rational> f = rational_isometry();
  RC_ASSERT(f.determinant() > 0);
  RC_ASSERT(norm(f(rational_point())) < 1);
}
RC_GTEST_PROP(IsometryProperty, KeepsDistances, ()) {
  const auto p = rational_point(), q = rational_point();
  const Isometry<Rational> f = rational_isometry();
  RC_ASSERT(sinh2_half_distance(f(p), f(q)) == sinh2_half_distance(p, q));
}
RC_GTEST_PROP(IsometryProperty, ProductIsComposition, ()) {
  const Isometry<Rational> f = rational_isometry(), g = rational_isometry();
  const auto z = rational_point();
  RC_ASSERT((f * g)(z) == f(g(z)));
}
RC_GTEST_PROP(IsometryProperty, ProductIsAssociative, ()) {
  const Isometry<Rational> f = rational_isometry(), g = rational_isometry(), h = rational_isometry();
  const Isometry<Rational> left = (f * g) * h;
  const Isometry<Rational> right = f * (g * h);
  RC_ASSERT(left.a == right.a);
  RC_ASSERT(left.b == right.b);
}
RC_GTEST_PROP(IsometryProperty, IdentityIsNeutral, ()) {
  const Isometry<Rational> f = rational_isometry();
  const Isometry<Rational> one;
  RC_ASSERT((one * f).a == f.a && (one * f).b == f.b);
  RC_ASSERT((f * one).a == f.a && (f * one).b == f.b);
}
RC_GTEST_PROP(IsometryProperty, InverseUndoesIt, ()) {
  const Isometry<Rational> f = rational_isometry();
  const auto z = rational_point();
  RC_ASSERT(inverse(f)(f(z)) == z);
  RC_ASSERT(f(inverse(f)(z)) == z);
  RC_ASSERT(classify(f * inverse(f)) == IsometryKind::identity);
}
RC_GTEST_PROP(IsometryProperty, InverseOfAProductIsTheReversedProduct, ()) {
  const Isometry<Rational> f = rational_isometry(), g = rational_isometry();
  RC_ASSERT(same(inverse(f * g), inverse(g) * inverse(f)));
}
RC_GTEST_PROP(IsometryProperty, DeterminantIsMultiplicative, ()) {
  const Isometry<Rational> f = rational_isometry(), g = rational_isometry();
  RC_ASSERT((f * g).determinant() == f.determinant() * g.determinant());
}
RC_GTEST_PROP(IsometryProperty, NormalizedIsTheSameIsometry, ()) {
  const Isometry<Mp256> f = convert<Mp256>(rational_isometry());
  const Isometry<Mp256> n = normalized(f);
  const Mp256 tiny = test::power_of_two<Mp256>(-240);
  RC_ASSERT(abs(Mp256(n.determinant() - 1)) < tiny);
  RC_ASSERT(n.a.x > 0 || (n.a.x == 0 && n.a.y > 0));
  const auto z = convert<Mp256>(rational_point());
  RC_ASSERT(norm(n(z) - f(z)) < tiny * tiny);
  const Isometry<Mp256> of_opposite = normalized(Isometry<Mp256>{-f.a, -f.b});
  RC_ASSERT(of_opposite.a == n.a && of_opposite.b == n.b);
}

RC_GTEST_PROP(SegmentToSegmentProperty, TakesEndsToEndsExactly, ()) {
  const auto p = rational_point(), q = rational_point();
  RC_PRE(!(p == q));
  const Isometry<Rational> g = rational_isometry();
  const Isometry<Rational> f = segment_to_segment(p, q, g(p), g(q));
  RC_ASSERT(f(p) == g(p));
  RC_ASSERT(f(q) == g(q));
  // An isometry that keeps the orientation is determined by two points.
  RC_ASSERT(same(f, g));
}
RC_GTEST_PROP(SegmentToSegmentProperty, ReversesASegmentExactly, ()) {
  // The half turn about the midpoint: in the coordinates of p the segments are opposite.
  const auto p = rational_point(), q = rational_point();
  RC_PRE(!(p == q));
  const Isometry<Rational> f = segment_to_segment(p, q, q, p);
  RC_ASSERT(f(p) == q);
  RC_ASSERT(f(q) == p);
  RC_ASSERT(f.determinant() > 0);
  RC_ASSERT(classify(f) == IsometryKind::elliptic);
}
TEST(SegmentToSegment, TurnsByEveryQuarter) {
  const Complex<Rational> o{};
  const Complex<Rational> e{Rational(1, 2), Rational(0)};
  const std::array<Complex<Rational>, 4> ends{{e, {Rational(0), Rational(1, 2)}, -e, {Rational(0), Rational(-1, 2)}}};
  for (const Complex<Rational>& end : ends) {
    const Isometry<Rational> f = segment_to_segment(o, e, o, end);
    EXPECT_EQ(f(o), o);
    EXPECT_EQ(f(e), end);
  }
}

TEST(IsometryImage, IsWithinTheBoundE5) {
  // docs/error-bounds.md, E5; Atlas uses almost three times as much.
  test::Random random(5);
  double worst = 0;
  for (int i = test::scaled(20'000); i > 0; --i) {
    // Near the identity, or a move of up to 40 from the origin.
    const Mp256 r = random() % 4 == 0 ? Mp256(test::uniform<Mp256>(random))
                                      : Mp256(1 - test::power_of_two<Mp256>(-test::integer(random, 1, 58)));
    const Isometry<Mp256> f = normalized(Isometry<Mp256>::translation(r * test::direction<Mp256>(random)) *
                                         Isometry<Mp256>{test::direction<Mp256>(random), {}});
    const Isometry<double> rounded = convert<double>(f);
    // Often the point that goes farthest: the one opposite to f⁻¹(0), where the denominator is smallest.
    const Complex<double> back = inverse(rounded)(Complex<double>{});
    const Complex<double> z =
        random() % 2 == 0 ? test::point<double>(random, 0.75) : 0.7499999 / std::sqrt(norm(back) + 1e-300) * back;
    if (norm(z) > 0.5625) {
      continue;
    }
    const double a = std::sqrt(norm(rounded.a));
    const double b = std::sqrt(norm(rounded.b));
    const double bound = kUnitRoundoff * (5.7 * (a + b) / (a - 0.75 * b) + 7);
    const Complex<Mp256> off = convert<Mp256>(rounded(z)) - f(convert<Mp256>(z));
    const double ratio = std::sqrt(static_cast<double>(norm(off))) / bound;
    worst = std::max(worst, ratio);
    ASSERT_LT(ratio, 1) << "|a| = " << a;
  }
  EXPECT_GT(worst, 0.05) << "the bound is of no use, or the inputs are too easy";
  RecordProperty("worst_ratio", std::to_string(worst));
}

// Kinds, displacement lengths, axes.

TEST(Classify, TellsTheKindEvenNextToParabolic) {
  using R = Rational;
  EXPECT_EQ(classify(Isometry<R>{}), IsometryKind::identity);
  EXPECT_EQ(classify(Isometry<R>{{R(-3), R(0)}, {}}), IsometryKind::identity);
  EXPECT_EQ(classify(Isometry<R>{{R(0), R(1)}, {}}), IsometryKind::elliptic);
  EXPECT_EQ(classify(Isometry<R>{{R(1), R(-1, 1000000)}, {}}), IsometryKind::elliptic);
  EXPECT_EQ(classify(Isometry<R>{{R(1), R(1)}, {R(0), R(1)}}), IsometryKind::parabolic);
  EXPECT_EQ(classify(Isometry<R>{{R(1), R(3, 4)}, {R(9, 20), R(3, 5)}}), IsometryKind::parabolic);
  EXPECT_EQ(classify(Isometry<R>::translation({R(1, 1000000), R(0)})), IsometryKind::hyperbolic);
  // By less than any binary64 number from parabolic, on either side.
  const R tiny(1, boost::multiprecision::pow(boost::multiprecision::mpz_int(10), 400));
  EXPECT_EQ(classify(Isometry<R>{{R(1), R(1)}, {R(0), R(1) + tiny}}), IsometryKind::hyperbolic);
  EXPECT_EQ(classify(Isometry<R>{{R(1), R(1)}, {R(0), R(1) - tiny}}), IsometryKind::elliptic);
  EXPECT_EQ(classify(Isometry<double>::translation({0, 1e-150})), IsometryKind::hyperbolic);
}

RC_GTEST_PROP(ClassifyProperty, AgreesWithTheTrace, ()) {
  // (Re a)² against |a|² − |b|², thesis I.1.1.
  const Isometry<Rational> f = rational_isometry();
  const int by_trace = sign(Rational(f.a.x * f.a.x - f.determinant()));
  RC_ASSERT(sign(isometry_discriminant(f)) == by_trace);
  RC_ASSERT((classify(f) == IsometryKind::hyperbolic) == (by_trace > 0));
  RC_ASSERT((classify(f) == IsometryKind::elliptic) == (by_trace < 0));
}
RC_GTEST_PROP(ClassifyProperty, InvariantUnderConjugationInverseAndScale, ()) {
  // A rotation, a parabolic isometry or a translation, anywhere.
  const Isometry<Rational> g = rational_isometry();
  const Rational t(*rc::gen::inRange(1, 50), 50 * 2);
  const std::array<std::pair<Isometry<Rational>, IsometryKind>, 4> models{{
      {{}, IsometryKind::identity},
      {{{Rational(1), t}, {}}, IsometryKind::elliptic},
      {{{Rational(1), t}, {t, Rational(0)}}, IsometryKind::parabolic},
      {Isometry<Rational>::translation({t, Rational(0)}), IsometryKind::hyperbolic},
  }};
  for (const auto& [model, kind] : models) {
    const Isometry<Rational> f = g * model * inverse(g);
    RC_ASSERT(classify(f) == kind);
    RC_ASSERT(classify(inverse(f)) == kind);
    RC_ASSERT(classify(Isometry<Rational>{Rational(-7, 3) * f.a, Rational(-7, 3) * f.b}) == kind);
  }
}

/// The translation by ℓ along the real axis, moved by g.
template <class T>
Isometry<T> translation_by(const T& length, const Isometry<T>& g) {
  using std::tanh;
  return g * Isometry<T>::translation({T(tanh(T(length / T(2)))), T(0)}) * inverse(g);
}

TEST(DisplacementLength, IsAccurateForShortAndLongOnes) {
  for (const double length : {1e-150, 1e-15, 1e-9, 1e-4, 0.1, 1.0, 5.0, 12.0}) {
    // u times the growth of errors: |a|²/(|a|² − |b|²) = cosh²(ℓ/2).
    const double cosh2 = std::cosh(length / 2) * std::cosh(length / 2);
    const double tolerance = 8 * 0x1p-53 * cosh2;
    const double t = std::tanh(length / 2);
    for (const Complex<double> c : {Complex<double>{t, 0}, Complex<double>{0, -t}, Complex<double>{0.6 * t, 0.8 * t}}) {
      EXPECT_NEAR(displacement_length(Isometry<double>::translation(c)) / length, 1, tolerance) << length;
    }
  }
  // The textbook's formula has lost half of the digits of 1e-9 long ago.
  const Isometry<double> f = normalized(Isometry<double>::translation({std::tanh(0.5e-9), 0}));
  EXPECT_EQ(std::acosh(f.a.x), 0);
  EXPECT_NEAR(displacement_length(f) / 1e-9, 1, 1e-15);
}

TEST(DisplacementLength, IsZeroForOtherKinds) {
  EXPECT_EQ(displacement_length(Isometry<double>{}), 0);
  EXPECT_EQ(displacement_length(Isometry<double>{{1, 1}, {0, 1}}), 0);
  EXPECT_EQ(displacement_length(Isometry<double>{{0, 1}, {}}), 0);
  EXPECT_FALSE(axis(Isometry<double>{}).has_value());
  EXPECT_FALSE(axis(Isometry<double>{{1, 1}, {0, 1}}).has_value());
  EXPECT_FALSE(axis(Isometry<double>{{0, 1}, {}}).has_value());
}

RC_GTEST_PROP(DisplacementLengthProperty, InvariantUnderConjugationInverseAndScale, ()) {
  const Mp256 length = Mp256(*rc::gen::inRange(1, 1000)) / Mp256(*rc::gen::element(100, 1000000, 1000000000));
  const Isometry<Mp256> g = convert<Mp256>(rational_isometry());
  const Isometry<Mp256> f = translation_by(length, g);
  const Mp256 tolerance = test::power_of_two<Mp256>(-180);
  RC_ASSERT(abs(Mp256(displacement_length(f) / length - 1)) < tolerance);
  RC_ASSERT(abs(Mp256(displacement_length(inverse(f)) / length - 1)) < tolerance);
  RC_ASSERT(abs(Mp256(displacement_length(normalized(f)) / length - 1)) < tolerance);
  // n times the length for the n-th power.
  RC_ASSERT(abs(Mp256(displacement_length(f * f * f) / (3 * length) - 1)) < tolerance);
}
RC_GTEST_PROP(DisplacementLengthProperty, IsTheLeastDistanceThatPointsMove, ()) {
  const Isometry<Mp256> f = convert<Mp256>(rational_isometry());
  const auto z = convert<Mp256>(rational_point());
  const Mp256 tolerance = test::power_of_two<Mp256>(-200);
  RC_ASSERT(distance(z, f(z)) >= displacement_length(f) - tolerance);
}

/// A hyperbolic isometry with any axis.
Isometry<Rational> rational_translation() {
  const Isometry<Rational> g = rational_isometry();
  return g * Isometry<Rational>::translation({Rational(*rc::gen::inRange(1, 97), 97), Rational(0)}) * inverse(g);
}

RC_GTEST_PROP(AxisProperty, IsThereForHyperbolicIsometriesAlone, ()) {
  const Isometry<Rational> f = rational_isometry();
  RC_ASSERT(axis(convert<Mp256>(f)).has_value() == (classify(f) == IsometryKind::hyperbolic));
}
RC_GTEST_PROP(AxisProperty, JoinsTheFixedPoints, ()) {
  const Isometry<Mp256> f = convert<Mp256>(rational_translation());
  const std::optional<Axis<Mp256>> line = axis(f);
  RC_ASSERT(line.has_value());
  const Mp256 tiny = test::power_of_two<Mp256>(-400);
  for (const Complex<Mp256>& end : {line->from, line->to}) {
    RC_ASSERT(abs(Mp256(norm(end) - 1)) < test::power_of_two<Mp256>(-200));
    RC_ASSERT(norm(f(end) - end) < tiny);
  }
  // `to` attracts: from any point the images come closer to it than to `from`, under the inverse the other way round.
  Complex<Mp256> forth = convert<Mp256>(rational_point());
  Complex<Mp256> back = forth;
  Isometry<Mp256> power = normalized(f);
  while (displacement_length(power) < 20) {
    power = normalized(power * power);
  }
  forth = power(forth);
  back = inverse(power)(back);
  RC_ASSERT(norm(forth - line->to) < norm(forth - line->from));
  RC_ASSERT(norm(back - line->from) < norm(back - line->to));
}
RC_GTEST_PROP(AxisProperty, ItsPointsMoveByTheDisplacementLength, ()) {
  const Isometry<Mp256> f = convert<Mp256>(rational_translation());
  const std::optional<Axis<Mp256>> line = axis(f);
  RC_ASSERT(line.has_value());
  // The point of the axis next to 0: on the ray of the middle m of the ends, at |m|/(1 + √(1 − |m|²)).
  const Complex<Mp256> m = Mp256(0.5) * (line->from + line->to);
  const Complex<Mp256> p = Mp256(1 / (1 + sqrt(Mp256(1 - norm(m))))) * m;
  RC_ASSERT(abs(Mp256(distance(p, f(p)) - displacement_length(f))) < test::power_of_two<Mp256>(-150));
  RC_ASSERT(abs(orientation_determinant(line->from, line->to, p)) < test::power_of_two<Mp256>(-150));
}
TEST(Axis, OfATranslationAlongTheRealAxis) {
  for (const double sign : {1.0, -1.0}) {  // Both pairs (a, b) of the isometry.
    const std::optional<Axis<double>> line = axis(Isometry<double>{{sign, 0}, {sign * 0.5, 0}});
    ASSERT_TRUE(line.has_value());
    EXPECT_EQ(line->from, (Complex<double>{-1, 0}));
    EXPECT_EQ(line->to, (Complex<double>{1, 0}));
  }
}

}  // namespace
}  // namespace epsnet::isometry_test
