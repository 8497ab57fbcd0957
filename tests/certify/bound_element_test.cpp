#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>

#include "certify/claims/bound/element.h"

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

}  // namespace
}  // namespace epsnet::certify::bound_element_test
