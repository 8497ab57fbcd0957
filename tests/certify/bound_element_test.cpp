#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "certify/claims/bound/triangles.h"

/// Displacements of isometries that are not known exactly.
namespace epsnet::certify::bound_element_test {
namespace {

using Complex = std::complex<double>;

constexpr slong kPrecision = 128;

/// z ↦ (az + b)/(b̄z + ā), |a|² − |b|² = 1.
struct Isometry {
  Complex a, b;
};

/// Along the line through 0 and e^{it} by the length l, moved to the side by the distance s.
Isometry along(double l, double t, double s) {
  const auto product = [](const Isometry& f, const Isometry& g) {
    return Isometry{f.a * g.a + f.b * std::conj(g.b), f.a * g.b + f.b * std::conj(g.a)};
  };
  const auto translation = [](double length, double angle) {
    return Isometry{std::cosh(length / 2), std::sinh(length / 2) * std::polar(1.0, angle)};
  };
  const double side = t + std::acos(0.0);
  return product(product(translation(s, side), translation(l, t)), translation(-s, side));
}

/// Contains both numbers.
void set_both(arb_ptr result, double x, double y) {
  Ball other;
  arb_set_d(result, x);
  arb_set_d(other.get(), y);
  arb_union(result, result, other.get(), kPrecision);
}

/// Contains both isometries.
BallIsometry both_of(const Isometry& f, const Isometry& g) {
  BallIsometry result;
  set_both(result.a.re(), f.a.real(), g.a.real());
  set_both(result.a.im(), f.a.imag(), g.a.imag());
  set_both(result.b.re(), f.b.real(), g.b.real());
  set_both(result.b.im(), f.b.imag(), g.b.imag());
  return result;
}

/// A point of the disk as a unit vector (2x, 2y, 1 + |z|²)/(1 − |z|²).
BallVector unit_vector(Complex z) {
  const double gap = 1 - std::norm(z);
  return {Ball::exactly(2 * z.real() / gap), Ball::exactly(2 * z.imag() / gap),
          Ball::exactly((1 + std::norm(z)) / gap)};
}

/// sinh²(d(z, fz)/2).
double displacement(const Isometry& f, Complex z) {
  const Complex w = (f.a * z + f.b) / (std::conj(f.b) * z + std::conj(f.a));
  return std::norm(z - w) / ((1 - std::norm(z)) * (1 - std::norm(w)));
}

/// At the axis the square alone counts; away from it also the distance from the axis.
TEST(BoundElement, TheDisplacementContainsThatOfEveryIsometryInTheBall) {
  for (const double width : {1e-2, 1e-4, 1e-6}) {
    for (const double t : {0.0, 0.7, 2.0, 4.0}) {
      for (const double s : {0.0, 0.5, -1.0}) {
        for (const double l : {0.5, 2.0, 6.0}) {
          const Isometry f = along(l, t, s), g = along(l + width, t, s);
          const Element element = element_of(both_of(f, g), kPrecision);
          for (const double from_axis : {0.0, 1e-3, 0.3, 1.0}) {
            const Complex z = std::tanh((s + from_axis) / 2) * std::polar(1.0, t + std::acos(0.0));
            const Interval interval = outer_interval(displacement(element, unit_vector(z), kPrecision));
            const double of_f = displacement(f, z), of_g = displacement(g, z);
            const double rounding = 1e-12 * (1 + of_g);
            EXPECT_LT(interval.lower, std::min(of_f, of_g) + rounding) << width << " " << l << " " << from_axis;
            EXPECT_GT(interval.upper, std::max(of_f, of_g) - rounding) << width << " " << l << " " << from_axis;
            // And it is no wider than a few times what there is in the ball.
            EXPECT_LT(interval.upper - interval.lower, 1e3 * std::abs(of_g - of_f));
          }
        }
      }
    }
  }
}

/// Of an isometry that is known, whatever the point: the displacement is that.
TEST(BoundElement, TheDisplacementIsThatOfTheIsometry) {
  for (const double l : {0.1, 1.0, 5.0}) {
    const Isometry f = along(l, 1.1, 0.4);
    const Element element = element_of(both_of(f, f), kPrecision);
    for (const Complex z : {Complex(0, 0), Complex(0.3, -0.2), Complex(-0.7, 0.5)}) {
      const Interval interval = outer_interval(displacement(element, unit_vector(z), kPrecision));
      EXPECT_NEAR(interval.lower, displacement(f, z), 1e-12 * (1 + displacement(f, z)));
      EXPECT_NEAR(interval.upper, displacement(f, z), 1e-12 * (1 + displacement(f, z)));
    }
  }
}

/// Of several, whichever is the first one.
TEST(BoundElement, TheLeastDisplacementIsThatOfTheElementThatMovesThePointLeast) {
  std::vector<BallIsometry> elements;
  double least = HUGE_VAL;
  const Complex z(0.3, -0.2);
  for (const double l : {2.0, 0.75, 3.0, 1.0}) {
    const Isometry f = along(l, 1.1 * l, 0.4);
    elements.push_back(both_of(f, f));
    least = std::min(least, displacement(f, z));
  }
  for (std::size_t first = 0; first < elements.size(); ++first) {
    const Interval found = outer_interval(least_displacement(elements, unit_vector(z), kPrecision));
    EXPECT_NEAR(found.lower, least, 1e-12) << first;
    EXPECT_NEAR(found.upper, least, 1e-12) << first;
    std::rotate(elements.begin(), elements.begin() + 1, elements.end());
  }
}

// Displacements in frames, and the recognition of equal products (docs/proof.md, Lemma 21.1).

/// The translation by the length l along the line from 0 to e^{it}.
BallIsometry translation(double l, double t) {
  const Precision scope(kPrecision);
  const Ball half = Ball::exactly(l / 2);
  BallIsometry result;
  arb_cosh(result.a.re(), half.get(), kPrecision);
  arb_sinh(result.b.re(), half.get(), kPrecision);
  Ball sine;
  Ball cosine;
  arb_sin_cos(sine.get(), cosine.get(), Ball::exactly(t).get(), kPrecision);
  arb_mul(result.b.im(), result.b.re(), sine.get(), kPrecision);
  arb_mul(result.b.re(), result.b.re(), cosine.get(), kPrecision);
  return result;
}

BallIsometry product(const BallIsometry& f, const BallIsometry& g) { return compose(f, g, kPrecision); }

/// f moved to the distance r from 0 in the direction t.
BallIsometry moved(const BallIsometry& f, double r, double t) {
  const BallIsometry way = translation(r, t);
  return product(product(way, f), inverse(way));
}

/// The point at the distance r from 0 in the direction t.
BallVector place(double r, double t) { return unit_vector(translation(r, t), 0, 0, kPrecision); }

TEST(BoundFrame, ItsCentreIsTheOrigin) {
  for (const double r : {0.0, 1.0, 12.0}) {
    const BallVector origin = place(r, 0.7);
    const Frame frame(origin, kPrecision);
    const Frame::Point centre = frame.point(origin);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LE(centre[i].lower, i == 2 ? 1 : 0);
      EXPECT_GE(centre[i].upper, i == 2 ? 1 : 0);
      EXPECT_LT(centre[i].upper - centre[i].lower, 1e-12);
    }
    for (const double step : {0.0, 0.5, 3.0}) {
      const Interval distance = frame.cosh_distance(place(r + step, 0.7));
      EXPECT_NEAR(distance.lower, std::cosh(step), 1e-12 * std::cosh(step));
      EXPECT_NEAR(distance.upper, std::cosh(step), 1e-12 * std::cosh(step));
    }
  }
}

/// Far from the centre of the disk as well, where coordinates in binary64 would have no digit left.
TEST(BoundFrame, TheDisplacementContainsThatInBallsAndIsNarrow) {
  for (const double r : {0.0, 2.0, 25.0}) {
    Frame frame(place(r, 0.7), kPrecision);
    std::uint32_t number = 0;
    for (const double length : {1e-4, 1.0, 6.0}) {
      for (const double angle : {0.0, 1.0, 2.5}) {
        const Element element = element_of(moved(translation(length, angle), r, 0.7), kPrecision);
        for (const double step : {-0.9, 0.0, 0.4}) {
          const BallVector p = place(r + step, 0.7);
          const Interval exact = outer_interval(displacement(element, p, kPrecision));
          const Interval found = frame.displacement(number, element, frame.point(p));
          EXPECT_LE(found.lower, exact.lower * (1 + 1e-15)) << r << " " << length << " " << angle << " " << step;
          EXPECT_GE(found.upper, exact.upper * (1 - 1e-15)) << r << " " << length << " " << angle << " " << step;
          EXPECT_LT(found.upper - found.lower, 1e-12 * (1 + exact.upper));
        }
        EXPECT_EQ(frame.elements(), ++number);
      }
    }
  }
}

TEST(BoundFrame, PointsNearEachOtherHaveOneFrame) {
  Frames frames(kPrecision);
  const Frame* const first = &frames.near(place(0, 0));
  EXPECT_EQ(&frames.near(place(0.5, 2)), first);
  const Frame* const second = &frames.near(place(5, 1));
  EXPECT_NE(second, first);
  EXPECT_EQ(&frames.near(place(5.3, 1)), second);
  EXPECT_EQ(&frames.near(place(0.3, 4)), first);
  EXPECT_EQ(frames.size(), 2U);
  EXPECT_NE(&frames.near(place(20, 1)), second);
  EXPECT_EQ(frames.size(), 3U);
}

/// Two translations that generate a free group, in which no point near 0 is moved by less than 1.
class BoundElements : public testing::Test {
 protected:
  const Precision scope{kPrecision};
  const BallIsometry f = translation(4, 0.1);
  const BallIsometry g = translation(5, 1.7);
  Elements elements{place(0, 0), sqr(sinh(Ball::exactly(0.5))), {f, g}, kPrecision};
};

TEST_F(BoundElements, ProductsInAnyOrderAreOneElementAndTheirInverses) {
  const Elements::Id fg = elements.add(product(f, g));
  EXPECT_EQ(elements.add(product(f, g)), fg);
  EXPECT_EQ(elements.add(inverse(product(f, g))), fg ^ 1U);
  EXPECT_EQ(elements.add(product(inverse(g), inverse(f))), fg ^ 1U);
  const Elements::Id fgf = elements.add(product(product(f, g), f));
  EXPECT_EQ(elements.add(product(f, product(g, f))), fgf);
  EXPECT_EQ(elements.add(product(inverse(g), product(g, product(f, product(g, f))))), fgf);
  EXPECT_NE(fgf / 2, fg / 2);
  // The matrix of the other sign is the same isometry.
  BallIsometry negative = product(f, g);
  acb_neg(negative.a.get(), negative.a.get());
  acb_neg(negative.b.get(), negative.b.get());
  EXPECT_EQ(elements.add(negative), fg);
}

TEST_F(BoundElements, DifferentWordsAreDifferentElements) {
  const std::vector<BallIsometry> letters{f, g, inverse(f), inverse(g)};
  std::set<Elements::Id> ids;
  std::size_t words = 0;
  const auto add_words = [&](const auto& self, const BallIsometry& word, std::size_t last, int length) -> void {
    ++words;
    ids.insert(elements.add(word));
    if (length == 4) return;
    for (std::size_t i = 0; i < letters.size(); ++i) {
      if (i != (last + 2) % 4) self(self, product(word, letters[i]), i, length + 1);
    }
  };
  for (std::size_t i = 0; i < letters.size(); ++i) add_words(add_words, letters[i], i, 1);
  EXPECT_EQ(words, 4U + 12 + 36 + 108);
  EXPECT_EQ(ids.size(), words);
  for (const Elements::Id id : ids) EXPECT_TRUE(ids.contains(id ^ 1U));
}

/// Elements are looked for by a number; those that share it are told apart by the lemma.
TEST_F(BoundElements, DifferentOnesOfTheSameNumberAreTwo) {
  const auto scale = [](double t) { return std::cos(t) + 0.618 * std::sin(t); };
  const double other = 0.9;
  const double length = 2 * std::asinh(std::sinh(2.0) * scale(0.1) / scale(other));
  const Elements::Id first = elements.add(f);
  const Elements::Id second = elements.add(translation(length, other));
  EXPECT_NE(first / 2, second / 2);
  EXPECT_EQ(elements.add(f), first);
  EXPECT_EQ(elements.add(translation(length, other)), second);
}

/// So a chain of products, there and back, loses no bits.
TEST_F(BoundElements, AChainOfProductsIsAsPreciseAsItsShortestWay) {
  const Elements::Id start = elements.add(product(f, g));
  const slong bits = arb_rel_accuracy_bits(elements.isometry(start).a.re());
  Elements::Id here = start;
  for (int i = 0; i < 30; ++i) {
    for (const BallIsometry& step : {f, g, inverse(g), inverse(f)}) {
      here = elements.add(product(elements.isometry(here), step));
    }
    EXPECT_EQ(here, start);
  }
  EXPECT_EQ(arb_rel_accuracy_bits(elements.isometry(here).a.re()), bits);
}

/// A chain that comes to new elements all the time, and never back, is enclosed along the edges.
TEST_F(BoundElements, WhatHasLostBitsIsEnclosedAlongEdges) {
  const BallIsometry fg = product(f, g);
  BallIsometry wide = product(fg, fg);
  arb_add_error_2exp_si(wide.a.re(), -70);
  arb_add_error_2exp_si(wide.b.re(), -70);
  const Elements::Id known = elements.add(wide);
  EXPECT_TRUE(elements.all_told());
  EXPECT_GE(arb_rel_accuracy_bits(elements.isometry(known).a.re()), kPrecision - 20);
  EXPECT_EQ(elements.add(product(fg, fg)), known);
  // Without edges it stays what it is.
  Elements without{place(0, 0), sqr(sinh(Ball::exactly(0.5))), {}, kPrecision};
  EXPECT_LT(arb_rel_accuracy_bits(without.isometry(without.add(wide)).a.re()), kPrecision - 20);
}

/// What balls do not tell is kept as another element, which is as true.
TEST_F(BoundElements, WhatBallsDoNotTellIsNotRecognized) {
  const Elements::Id known = elements.add(f);
  BallIsometry wide = f;
  arb_add_error_2exp_si(wide.b.re(), -5);
  EXPECT_NE(elements.add(wide) / 2, known / 2);
  EXPECT_FALSE(elements.all_told());
  // If the shortest loop is not known to be longer than what the two differ by.
  Elements doubtful{place(0, 0), Ball::exactly(0), {f, g}, kPrecision};
  EXPECT_NE(doubtful.add(f) / 2, doubtful.add(f) / 2);
}

}  // namespace
}  // namespace epsnet::certify::bound_element_test
