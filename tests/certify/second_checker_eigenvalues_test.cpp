#if __has_include(<flint/acb_hypgeom.h>)
#include <flint/acb_hypgeom.h>
#else
#include <acb_hypgeom.h>
#endif
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/claims/eigenvalues/eigenfunction.h"
#include "certify/claims/eigenvalues/enclosures.h"
#include "certify/claims/eigenvalues/fields.h"
#include "certify/claims/eigenvalues/forms.h"
#include "certify/claims/eigenvalues/local_functions.h"
#include "certify/exact/checker.h"
#include "certify/exact/claim_rules.h"
#include "certify/exact/eigenfunctions.h"
#include "certify/exact/flat_triangles.h"
#include "certify/exact/inertia.h"
#include "certify/file/file.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "tests/certify/claim_files.h"
#include "tests/support/scale.h"

/// Both checkers of eigenvalues beside the definitions of docs/proof.md, section 17, in binary64, by quadrature and
/// dense matrices. What is computed here is written from the lemmas, and shares no code with either.
namespace epsnet::exact::second_checker_eigenvalues_test {
namespace {

using Document = certify::EigenvaluesDocument;
using certify::Ball;
using certify::NetDocument;
using certify::Precision;
using Complexd = std::complex<double>;
using Point3 = std::array<double, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;
using Dense = std::vector<std::vector<double>>;

Document file(const std::string& name) {
  return certify::read_file<Document>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/" + name + ".json");
}
std::string text(const Document& document) {
  std::ostringstream out;
  certify::write_file(document, out);
  return out.str();
}

double middle(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }
double middle(const Interval& x) { return x.lower() / 2 + x.upper() / 2; }
Interval interval(double x) { return Interval(mpq_class(x)); }

// Flat triangles, with their circumcentres at 0.

double dot(const std::array<double, 2>& u, const std::array<double, 2>& v) { return u[0] * v[0] + u[1] * v[1]; }
/// Eigenvalues of a symmetric matrix of two rows, the greater one first.
std::array<double, 2> eigenvalues_of(const std::array<double, 3>& m) {
  const double mean = (m[0] + m[2]) / 2;
  const double root = std::hypot((m[0] - m[2]) / 2, m[1]);
  return {mean + root, mean - root};
}

/// T♭ by its corners on the circle of radius R around 0; it is in the plane z = C of the space of the hyperboloid.
struct Triangle {
  std::array<std::array<double, 2>, 3> corner;
  double radius;

  [[nodiscard]] double cosh() const { return std::sqrt(1 + radius * radius); }
  /// The square of the side opposite to corner k.
  [[nodiscard]] double square(std::size_t k) const {
    const auto& p = corner[(k + 1) % 3];
    const auto& q = corner[(k + 2) % 3];
    return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
  }
  [[nodiscard]] double area() const {
    const auto& [p, q, r] = corner;
    return ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
  }
  /// Of the barycentric coordinate of corner k.
  [[nodiscard]] std::array<double, 2> gradient(std::size_t k) const {
    const auto& p = corner[(k + 1) % 3];
    const auto& q = corner[(k + 2) % 3];
    return {(p[1] - q[1]) / (2 * area()), (q[0] - p[0]) / (2 * area())};
  }
  /// ∫ f(x, p), x the barycentric coordinates of p: Gauss's rule with 10 nodes each way.
  template <class Function>
  [[nodiscard]] double integral(const Function& f) const {
    static constexpr std::array<double, 5> kNodes{0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                                                  0.8650633666889845, 0.9739065285171717};
    static constexpr std::array<double, 5> kWeights{0.2955242247147529, 0.2692667193099963, 0.2190863625159820,
                                                    0.1494513491505806, 0.0666713443086881};
    double sum = 0;
    for (std::size_t i = 0; i < 10; ++i) {
      for (std::size_t j = 0; j < 10; ++j) {
        const double u = (1 + (i < 5 ? kNodes[i] : -kNodes[i - 5])) / 2;
        const double v = (1 + (j < 5 ? kNodes[j] : -kNodes[j - 5])) / 2;
        const std::array<double, 3> x{1 - u, u * (1 - v), u * v};
        std::array<double, 2> p{};
        for (std::size_t k = 0; k < 3; ++k) {
          p[0] += x[k] * corner[k][0];
          p[1] += x[k] * corner[k][1];
        }
        sum += kWeights[i % 5] * kWeights[j % 5] / 4 * u * f(x, p);
      }
    }
    return 2 * area() * sum;
  }
  /// ω = ϱ² − 1, ϱ² = −⟨p, p⟩.
  [[nodiscard]] double omega(const std::array<double, 2>& p) const { return cosh() * cosh() - dot(p, p) - 1; }

  /// The metric of the hyperbolic triangle at p/ϱ, pulled back: by the derivative of p/ϱ, in the form ⟨ , ⟩.
  [[nodiscard]] std::array<double, 3> metric(const std::array<double, 2>& p) const {
    const double rho = std::sqrt(1 + omega(p));
    std::array<Point3, 2> derivative{};
    for (std::size_t i = 0; i < 2; ++i) {
      const double slope = -p[i] / rho;  // Of ϱ.
      const Point3 whole{p[0], p[1], cosh()};
      for (std::size_t k = 0; k < 3; ++k) derivative[i][k] = (k == i ? 1 : 0) / rho - whole[k] * slope / (rho * rho);
    }
    const auto product = [&](std::size_t i, std::size_t j) {
      const auto& u = derivative[i];
      const auto& v = derivative[j];
      return u[0] * v[0] + u[1] * v[1] - u[2] * v[2];
    };
    return {product(0, 0), product(0, 1), product(1, 1)};
  }
  /// b, and B = b times the inverse of the metric.
  [[nodiscard]] double density(const std::array<double, 2>& p) const {
    const auto g = metric(p);
    return std::sqrt(g[0] * g[2] - g[1] * g[1]);
  }
  [[nodiscard]] std::array<double, 3> energy_form(const std::array<double, 2>& p) const {
    const auto g = metric(p);
    const double b = std::sqrt(g[0] * g[2] - g[1] * g[1]);
    return {g[2] / b, -g[1] / b, g[0] / b};
  }

  /// The mean of a matrix with two rows.
  template <class Function>
  [[nodiscard]] std::array<double, 3> mean(const Function& f) const {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = integral([&](const auto&, const auto& p) { return f(p)[i]; }) / area();
    return result;
  }
};

/// By angles on the circle; counterclockwise.
Triangle triangle(double radius, std::array<double, 3> angles) {
  std::sort(angles.begin(), angles.end());
  Triangle result{{}, radius};
  for (std::size_t k = 0; k < 3; ++k) result.corner[k] = {radius * std::cos(angles[k]), radius * std::sin(angles[k])};
  return result;
}

/// By the squares of the sides.
Triangle triangle(const std::array<double, 3>& squares) {
  const auto& [a, b, c] = squares;
  const double area = std::sqrt(4 * a * b - (a + b - c) * (a + b - c)) / 4;
  Triangle result{{}, std::sqrt(a * b * c) / (4 * area)};
  const double side = std::sqrt(c);
  const std::array<double, 2> third{(b + c - a) / (2 * side), 2 * area / side};
  // The centre is on the bisector of the third side, as far from its ends as from the third corner.
  const double height = (third[0] * third[0] + third[1] * third[1] - side * third[0]) / (2 * third[1]);
  result.corner = {{{-side / 2, -height}, {side / 2, -height}, {third[0] - side / 2, third[1] - height}}};
  return result;
}

/// What a checker makes of a triangle.
struct Forms {
  Matrix least_energy, greatest_mass, greatest_energy, least_mass;
  double interpolation;
};

Matrix matrix(const certify::SymmetricForm& form) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i][i] = middle(form.square[i]);
    result[(i + 1) % 3][(i + 2) % 3] = result[(i + 2) % 3][(i + 1) % 3] = middle(form.product[i]);
  }
  return result;
}
Matrix matrix(const LocalForms::Matrix& form) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = middle(form[i][j]);
  }
  return result;
}

Forms of_first(const Triangle& t) {
  const Precision scope(128);
  const auto flat =
      certify::FlatTriangle::of({Ball::exactly(t.square(0)), Ball::exactly(t.square(1)), Ball::exactly(t.square(2))})
          .value();
  return {matrix(flat.least_energy()), matrix(flat.greatest_mass()), matrix(flat.greatest_energy()),
          matrix(flat.least_mass()), middle(flat.interpolation_constant())};
}
Forms of_second(const Triangle& t) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    // On the hyperboloid, moved along it.
    const double x = t.corner[k][0];
    const double z = std::sqrt(1 + dot(t.corner[k], t.corner[k]));
    corners[k] = {interval(1.25 * x + 0.75 * z), interval(t.corner[k][1]), interval(0.75 * x + 1.25 * z)};
  }
  const FlatTriangle flat(corners);
  const LocalForms lower = flat.lower_forms();
  const LocalForms upper = flat.upper_forms();
  return {matrix(lower.energy), matrix(lower.mass), matrix(upper.energy), matrix(upper.mass),
          middle(flat.interpolation())};
}

/// X and Λ of Lemma 32, as it defines them: the mean of s², and the greater eigenvalue of the mean of (p − O)(p − O)ᵀ.
struct Spread {
  explicit Spread(const Triangle& t) {
    const auto moments = t.mean([](const auto& p) { return std::array{p[0] * p[0], p[0] * p[1], p[1] * p[1]}; });
    mean = moments[0] + moments[2];
    greater = eigenvalues_of(moments)[0];
  }
  double mean;
  double greater;
};

/// a of Lemma 32.
double least_factor(const Triangle& t) {
  const Spread spread(t);
  const double big = t.cosh();
  const double c = 1 / (1 + t.radius);
  return c + 1 / (1 / (1 - c) - spread.mean / (2 * big * (1 - c) * (big - c)) +
                  spread.greater / ((1 - c * big) * (big - c)));
}
double greatest_factor(const Triangle& t) {
  const Spread spread(t);
  return 1 - spread.mean / (2 * t.cosh() * t.cosh()) + spread.greater / t.cosh();
}
/// C − κω, by its values at ω = 0, which is C, and at ω = R², which is C⁻².
double greatest_density(const Triangle& t, const std::array<double, 2>& p) {
  const double big = t.cosh();
  return big - (big - 1 / (big * big)) / (t.radius * t.radius) * t.omega(p);
}
/// The tangent of C(1 + ω)^(−3/2) at the mean of ω.
double least_density(const Triangle& t, double mean, const std::array<double, 2>& p) {
  return t.cosh() * std::pow(1 + mean, -1.5) * (1 - 1.5 * (t.omega(p) - mean) / (1 + mean));
}
double mean_omega(const Triangle& t) {
  return t.integral([&](const auto&, const auto& p) { return t.omega(p); }) / t.area();
}
double longest_square(const Triangle& t) { return std::max({t.square(0), t.square(1), t.square(2)}); }

/// The forms of the lemmas, by quadrature.
Forms expected(const Triangle& t) {
  const double least = least_factor(t);
  const double greatest = greatest_factor(t);
  const double mean = mean_omega(t);
  Forms forms{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double stiffness = t.area() * dot(t.gradient(i), t.gradient(j));
      forms.least_energy[i][j] = least * 4 * stiffness;
      forms.greatest_energy[i][j] = greatest * stiffness;
      forms.greatest_mass[i][j] = t.integral(
          [&](const auto& x, const auto& p) { return greatest_density(t, p) * (1 - 2 * x[i]) * (1 - 2 * x[j]); });
      forms.least_mass[i][j] =
          t.integral([&](const auto& x, const auto& p) { return least_density(t, mean, p) * x[i] * x[j]; });
    }
  }
  forms.interpolation = 0.1893 * 0.1893 * longest_square(t) * t.cosh() * (1 + t.radius);
  return forms;
}

rc::Gen<Triangle> triangles(double greatest_radius) {
  return rc::gen::map(
      rc::gen::tuple(rc::gen::inRange(0, 1000), rc::gen::inRange(0, 1000), rc::gen::inRange(0, 1000),
                     rc::gen::inRange(0, 1000)),
      [=](const auto& numbers) {
        const auto [r, first, second, third] = numbers;
        // Gaps of at least 0.5 between the three angles: also triangles without their circumcentres.
        const double free = 2 * std::numbers::pi - 1.5;
        const double total = first + second + third + 1.0;
        const double a = 0.5 + free * first / total;
        return triangle(0.05 + (greatest_radius - 0.05) * r / 1000, {0.1, 0.1 + a, 0.6 + a + free * second / total});
      });
}

void expect_near(const Matrix& found, const Matrix& wanted, const char* what) {
  double size = 0;
  for (const auto& row : wanted) {
    for (const double x : row) size = std::max(size, std::abs(x));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!(std::abs(found[i][j] - wanted[i][j]) <= 1e-9 * size))
        RC_FAIL(std::string(what) + ": " + std::to_string(i) + ", " + std::to_string(j) + ": " +
                std::to_string(found[i][j]) + ", expected " + std::to_string(wanted[i][j]));
    }
  }
}

RC_GTEST_PROP(FlatTriangles, FormsOfBothCheckersAreThoseOfTheLemmas, ()) {
  const Triangle t = *triangles(1.5);
  const Forms wanted = expected(t);
  for (const Forms& found : {of_first(t), of_second(t)}) {
    expect_near(found.least_energy, wanted.least_energy, "a of Lemma 32");
    expect_near(found.greatest_mass, wanted.greatest_mass, "the mass of Lemma 33");
    expect_near(found.greatest_energy, wanted.greatest_energy, "the energy of Lemma 35");
    expect_near(found.least_mass, wanted.least_mass, "the mass of Lemma 35");
    RC_ASSERT(std::abs(found.interpolation / wanted.interpolation - 1) < 1e-9);
  }
}

/// The least a for which Lemma 32 (a) can hold, and the least factor for Lemma 35, by the metric itself.
struct TrueFactors {
  explicit TrueFactors(const Triangle& t) {
    const double c = 1 / (1 + t.radius);
    const auto inverse = t.mean([&](const auto& p) {
      const auto b = t.energy_form(p);
      const double determinant = (b[0] - c) * (b[2] - c) - b[1] * b[1];
      return std::array{(b[2] - c) / determinant, -b[1] / determinant, (b[0] - c) / determinant};
    });
    least = c + 1 / eigenvalues_of(inverse)[0];
    greatest = eigenvalues_of(t.mean([&](const auto& p) { return t.energy_form(p); }))[0];
  }
  double least;
  double greatest;
};

RC_GTEST_PROP(FlatTriangles, FactorsBoundTheMeansOfTheTrueMetric, ()) {
  const Triangle t = *triangles(1.0);
  const TrueFactors factors(t);
  RC_ASSERT(least_factor(t) <= factors.least * (1 + 1e-12));
  RC_ASSERT(greatest_factor(t) >= factors.greatest * (1 - 1e-12));
  const double mean = mean_omega(t);
  bool bounded = true;
  static_cast<void>(t.integral([&](const auto&, const auto& p) {
    const double b = t.density(p);
    bounded = bounded && b <= greatest_density(t, p) * (1 + 1e-12) && b >= least_density(t, mean, p) * (1 - 1e-12);
    return 0.0;
  }));
  RC_ASSERT(bounded);
}

/// No factor is much too large: terms in R² are as they should be.
TEST(FlatTriangles, FactorsAreNearlyThoseOfTheTrueMetric) {
  for (const double radius : {0.05, 0.2, 0.4}) {
    const Triangle t = triangle(radius, {0.1, 2.2, 4.3});
    const TrueFactors factors(t);
    EXPECT_LE(factors.least - least_factor(t), 0.06 * std::pow(radius, 3)) << radius;
    EXPECT_LE(greatest_factor(t) - factors.greatest, 0.06 * std::pow(radius, 4)) << radius;
    // And equal to those of a polynomial that touches C(1 + ω)^(−3/2) twice, or once.
    EXPECT_NEAR(greatest_density(t, {0, 0}), t.density({0, 0}), 1e-12);
    EXPECT_NEAR(greatest_density(t, t.corner[1]), t.density(t.corner[1]), 1e-12);
    const std::array<double, 2> mean_place{std::sqrt(radius * radius - mean_omega(t)), 0};
    EXPECT_NEAR(least_density(t, mean_omega(t), mean_place), t.density(mean_place), 1e-12);
  }
}

/// A polynomial of degree 3, and its gradient.
struct Polynomial {
  std::array<double, 10> c;
  [[nodiscard]] double operator()(const std::array<double, 2>& p) const {
    const auto [x, y] = p;
    return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y + c[6] * x * x * x +
           c[7] * x * x * y + c[8] * x * y * y + c[9] * y * y * y;
  }
  [[nodiscard]] std::array<double, 2> gradient(const std::array<double, 2>& p) const {
    const auto [x, y] = p;
    return {c[1] + 2 * c[3] * x + c[4] * y + 3 * c[6] * x * x + 2 * c[7] * x * y + c[8] * y * y,
            c[2] + c[4] * x + 2 * c[5] * y + c[7] * x * x + 2 * c[8] * x * y + 3 * c[9] * y * y};
  }
};

double value(const Matrix& form, const std::array<double, 3>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += form[i][j] * v[i] * v[j];
  }
  return sum;
}

/// Lemmas 33 and 35 on one triangle, for functions that are not linear.
RC_GTEST_PROP(FlatTriangles, EnergyAndMassOfFunctionsAreBounded, ()) {
  const Triangle t = *triangles(1.2);
  Polynomial f{};
  for (double& c : f.c) c = *rc::gen::inRange(-100, 101) / 100.0;
  // The means on the sides opposite to the corners, by Simpson's rule.
  std::array<double, 3> means{};
  std::array<double, 3> values{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& p = t.corner[(k + 1) % 3];
    const auto& q = t.corner[(k + 2) % 3];
    means[k] = (f(p) + 4 * f({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2}) + f(q)) / 6;
    values[k] = f(t.corner[k]);
  }
  std::array<double, 2> slope{};  // Of the linear function with these means.
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 2; ++i) slope[i] += -2 * means[k] * t.gradient(k)[i];
  }
  const auto linear = [&](const std::array<double, 3>& x) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += means[k] * (1 - 2 * x[k]);
    return sum;
  };
  const auto energy = [&](const auto& gradient) {
    return t.integral([&](const auto&, const auto& p) {
      const auto b = t.energy_form(p);
      const std::array<double, 2> g = gradient(p);
      return b[0] * g[0] * g[0] + 2 * b[1] * g[0] * g[1] + b[2] * g[1] * g[1];
    });
  };
  const double rest = t.integral([&](const auto&, const auto& p) {
    const auto g = f.gradient(p);
    const std::array<double, 2> w{g[0] - slope[0], g[1] - slope[1]};
    return dot(w, w);
  }) / (1 + t.radius);
  const double rest_mass = t.integral([&](const auto& x, const auto& p) {
    const double w = f(p) - linear(x);
    return t.density(p) * w * w;
  });
  const double linear_mass =
      t.integral([&](const auto& x, const auto& p) { return t.density(p) * linear(x) * linear(x); });
  const auto at_corners = [&](const std::array<double, 3>& x) {
    return x[0] * values[0] + x[1] * values[1] + x[2] * values[2];
  };
  const double mass =
      t.integral([&](const auto& x, const auto& p) { return t.density(p) * at_corners(x) * at_corners(x); });
  std::array<double, 2> gradient{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 2; ++i) gradient[i] += values[k] * t.gradient(k)[i];
  }
  for (const Forms& forms : {of_first(t), of_second(t)}) {
    const double whole = energy([&](const auto& p) { return f.gradient(p); });
    RC_ASSERT(whole >= (value(forms.least_energy, means) + rest) * (1 - 1e-9));
    RC_ASSERT(rest_mass <= forms.interpolation * rest * (1 + 1e-9));
    RC_ASSERT(linear_mass <= value(forms.greatest_mass, means) * (1 + 1e-9));
    RC_ASSERT(mass >= value(forms.least_mass, values) * (1 - 1e-9));
    RC_ASSERT(energy([&](const auto&) { return gradient; }) <= value(forms.greatest_energy, values) * (1 + 1e-9));
  }
}

/// The first checker's numbers of wide balls contain those of the triangles that the balls contain.
RC_GTEST_PROP(FlatTriangles, OfWideBallsContainThoseOfTheirPoints, ()) {
  const Precision scope(128);
  const Triangle t = *triangles(1.5);
  const double width = *rc::gen::element(1e-3, 1e-5, 1e-9);
  std::array<Ball, 3> wide;
  for (std::size_t k = 0; k < 3; ++k) {
    wide[k] = Ball::exactly(t.square(k));
    arb_add_error(wide[k].get(), Ball::exactly(t.square(k) * width).get());
  }
  const auto all = certify::FlatTriangle::of(wide);
  if (!all) return;
  const auto expect_in = [](const Ball& x, const Ball& found, const char* what) {
    if (arb_contains(found.get(), x.get()) == 0) RC_FAIL(std::string(what) + " is too narrow");
  };
  for (int corner = 0; corner < 8; ++corner) {
    std::array<Ball, 3> squares;
    for (std::size_t k = 0; k < 3; ++k)
      squares[k] = Ball::exactly(t.square(k) * (1 + (corner >> k & 1 ? 0.999 : -0.999) * width));
    const auto one = certify::FlatTriangle::of(squares);
    RC_ASSERT(one.has_value());
    const auto expect_form_in = [&](const certify::SymmetricForm& x, const certify::SymmetricForm& found,
                                    const char* what) {
      for (std::size_t k = 0; k < 3; ++k) {
        expect_in(x.square[k], found.square[k], what);
        expect_in(x.product[k], found.product[k], what);
      }
    };
    expect_form_in(one->least_energy(), all->least_energy(), "the energy of Lemma 32");
    expect_form_in(one->greatest_mass(), all->greatest_mass(), "the mass of Lemma 33");
    expect_form_in(one->greatest_energy(), all->greatest_energy(), "the energy of Lemma 35");
    expect_form_in(one->least_mass(), all->least_mass(), "the mass of Lemma 35");
    expect_in(one->interpolation_constant(), all->interpolation_constant(), "the constant of Lemma 33");
  }
}

TEST(FlatTriangles, AreNotMadeOfThreePointsOnALine) {
  const Precision scope(128);
  const auto first = [](double a, double b, double c) {
    return certify::FlatTriangle::of({Ball::exactly(a), Ball::exactly(b), Ball::exactly(c)}).has_value();
  };
  EXPECT_TRUE(first(1, 1, 1));
  EXPECT_FALSE(first(1, 1, 4));
  EXPECT_FALSE(first(1, 1, 5));
  EXPECT_FALSE(first(-1, 1, 1));
  EXPECT_FALSE(first(1, -1, -1));
  EXPECT_FALSE(first(0, 1, 1));
  for (const int signs : {0, 1, 2, 3, 4, 5, 6, 7}) {
    const auto side = [&](int k) { return (signs >> k & 1) != 0 ? -1.0 : 1.0; };
    EXPECT_EQ(first(side(0), side(1), side(2)), signs == 0) << signs;
    EXPECT_FALSE(first(side(0), 0, side(2))) << signs;
    EXPECT_FALSE(first(side(0), 0, 0)) << signs;
  }
  EXPECT_FALSE(first(0, 0, 0));
  // Perhaps triangles, perhaps not: a square may be negative, or so large that there is no triangle.
  for (const double radius : {4.0, 1.0, 1.5}) {
    Ball wide = Ball::exactly(radius == 1.5 ? 2.75 : 1.0);
    arb_add_error(wide.get(), Ball::exactly(radius).get());
    EXPECT_FALSE(certify::FlatTriangle::of({wide, Ball::exactly(1), Ball::exactly(1)}).has_value());
    EXPECT_FALSE(certify::FlatTriangle::of({Ball::exactly(1), Ball::exactly(1), wide}).has_value());
  }
  const auto corners = [](double x, double y) {
    const auto at = [](double s, double t) {
      return Vector{interval(s), interval(t), sqrt(interval(1 + s * s + t * t))};
    };
    return Corners{at(0, 0), at(0.5, 0), at(x, y)};
  };
  EXPECT_NO_THROW(FlatTriangle(corners(0.25, 0.5)));
  EXPECT_THROW(FlatTriangle(corners(1, 0)), TooLarge);
  // Its corners span a plane, but no spacelike one: on a horocycle and beyond, no circle.
  EXPECT_THROW(FlatTriangle(corners(100, 0.01)), TooLarge);
}

// Halved nets.

TEST(HalvedNets, OfTwoTrianglesAreThoseOfTheFormat) {
  NetDocument net;
  net.vertices.resize(3);
  net.triangles.resize(2);
  net.triangles[0].vertex = {0, 1, 2};
  net.triangles[0].opposite = {5, 4, 3};
  net.triangles[1].vertex = {0, 2, 1};
  net.triangles[1].opposite = {2, 1, 0};
  const auto whole = certify::halved_net(net, 0);
  using Rows = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(whole.sides, (Rows{{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(whole.vertices, (Rows{{0, 1, 2}, {0, 2, 1}}));
  const auto halved_once = certify::halved_net(net, 1);
  // Triangles (v_i, m_i, m_{i−1}) and (m_0, m_1, m_2); midpoints of sides 0, 1, 2 are 3, 4, 5.
  EXPECT_EQ(halved_once.vertices,
            (Rows{{0, 3, 5}, {1, 4, 3}, {2, 5, 4}, {3, 4, 5}, {0, 5, 3}, {2, 4, 5}, {1, 3, 4}, {5, 4, 3}}));
  EXPECT_EQ(halved_once.sides,
            (Rows{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {4, 7, 1}, {2, 9, 0}, {8, 10, 6}, {5, 11, 3}, {10, 11, 9}}));
  const auto sizes = certify::halved_sizes(net, 1);
  EXPECT_EQ(sizes.sides, 12U);
  EXPECT_EQ(sizes.vertices, 6U);
}

Net exact_net(const NetDocument& net) {
  Net result;
  result.vertices.resize(net.vertices.size());
  for (const NetDocument::Triangle& t : net.triangles)
    result.triangles.push_back(
        {{t.vertex[0], t.vertex[1], t.vertex[2]}, {t.opposite[0], t.opposite[1], t.opposite[2]}, {}});
  return result;
}

/// What the second checker says of the same, for nets whose numbers do not matter.
HalvedNet exactly_halved(const NetDocument& net, Index halvings) {
  // Tiles that are well-formed.
  std::ostringstream out;
  certify::write_file(net, out);
  const Net read = read_net(parse_json(out.str()));
  return halved(NetStructure(read), halvings);
}

TEST(HalvedNets, OfBothCheckersAreTheSame) {
  for (const char* name : {"octagon-5-of-one-vertex", "bolza", "octagon-5-with-a-function"}) {
    const NetDocument net = file(name).net;
    for (const std::uint32_t halvings : {0U, 1U, 2U, 3U}) {
      const auto first = certify::halved_net(net, halvings);
      const HalvedNet second = exactly_halved(net, halvings);
      ASSERT_EQ(second.side.size(), 3 * first.sides.size());
      ASSERT_EQ(second.start.size(), 3 * first.sides.size());
      const auto sizes = certify::halved_sizes(net, halvings);
      const HalvedSize others = halved_size(exact_net(net), halvings);
      EXPECT_EQ(others.sides, sizes.sides);
      EXPECT_EQ(others.vertices, sizes.vertices);
      EXPECT_EQ(others.triangles, first.sides.size());
      // Each side is in two triangles, between the same vertices.
      std::vector<std::vector<std::size_t>> darts(sizes.sides);
      std::vector<bool> seen(sizes.vertices);
      for (std::size_t dart = 0; dart < second.side.size(); ++dart) {
        ASSERT_EQ(second.side[dart], first.sides[dart / 3][dart % 3]) << name << ' ' << halvings << ' ' << dart;
        ASSERT_EQ(second.start[dart], first.vertices[dart / 3][dart % 3]) << name << ' ' << halvings << ' ' << dart;
        ASSERT_LT(second.side[dart], sizes.sides);
        ASSERT_LT(second.start[dart], sizes.vertices);
        darts[second.side[dart]].push_back(dart);
        seen[second.start[dart]] = true;
      }
      EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](bool there) { return there; }));
      const auto after = [&](std::size_t dart) { return dart / 3 * 3 + (dart % 3 + 1) % 3; };
      std::size_t least = 0;
      for (const auto& two : darts) {
        ASSERT_EQ(two.size(), 2U);
        EXPECT_EQ(second.start[two[0]], second.start[after(two[1])]);
        EXPECT_EQ(second.start[two[1]], second.start[after(two[0])]);
        // In the order of the smaller dart.
        EXPECT_LE(least, two[0]);
        least = two[0];
      }
      EXPECT_EQ(sizes.vertices + first.sides.size() + 2, sizes.sides);  // Genus 2.
    }
  }
}

// Corners of nets in binary64.

std::vector<certify::BallIsometry> labels_of(const NetDocument& net, slong bits) {
  const auto parts = certify::label_parts(certify::check_surface(net.surface).crossings, net.charts, {});
  std::vector<std::uint32_t> numbers(net.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  return certify::LabelEvaluator(net, parts).evaluate(numbers, bits, 4 * bits, 1);
}
Complexd middle(const certify::ComplexBall& z) { return {middle(certify::real(z)), middle(certify::imaginary(z))}; }

Point3 corner(const NetDocument& net, const std::vector<certify::BallIsometry>& labels, std::uint32_t dart) {
  const auto& vertex = net.vertices[net.triangles[dart / 3].vertex[dart % 3]];
  Complexd z{vertex.x, vertex.y};
  const std::uint32_t label = certify::corner_label(net, dart);
  if (label > 0) {
    const Complexd a = middle(labels[label - 1].a);
    const Complexd b = middle(labels[label - 1].b);
    z = (a * z + b) / (std::conj(b) * z + std::conj(a));
  }
  return {2 * z.real() / (1 - std::norm(z)), 2 * z.imag() / (1 - std::norm(z)),
          (1 + std::norm(z)) / (1 - std::norm(z))};
}

Point3 between(const Point3& v, const Point3& w) {
  const Point3 sum{v[0] + w[0], v[1] + w[1], v[2] + w[2]};
  const double size = std::sqrt(sum[2] * sum[2] - sum[0] * sum[0] - sum[1] * sum[1]);
  return {sum[0] / size, sum[1] / size, sum[2] / size};
}
/// By number of the halved triangle, its corners.
void add_halved(const std::array<Point3, 3>& v, std::uint32_t halvings, std::vector<std::array<Point3, 3>>& result) {
  if (halvings == 0) {
    result.push_back(v);
    return;
  }
  const std::array<Point3, 3> m{between(v[0], v[1]), between(v[1], v[2]), between(v[2], v[0])};
  add_halved({v[0], m[0], m[2]}, halvings - 1, result);
  add_halved({v[1], m[1], m[0]}, halvings - 1, result);
  add_halved({v[2], m[2], m[1]}, halvings - 1, result);
  add_halved(m, halvings - 1, result);
}
double flat_square(const Point3& v, const Point3& w) {
  const double product = v[0] * w[0] + v[1] * w[1] - v[2] * w[2];
  return 2 * (-product - 1);  // 4 sinh²(d/2) = 2(cosh d − 1)
}
std::vector<std::array<double, 3>> squares_of(const NetDocument& net, std::uint32_t halvings) {
  const auto labels = labels_of(net, 128);
  std::vector<std::array<Point3, 3>> corners;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    add_halved({corner(net, labels, 3 * t), corner(net, labels, 3 * t + 1), corner(net, labels, 3 * t + 2)}, halvings,
               corners);
  }
  std::vector<std::array<double, 3>> squares;
  for (const auto& v : corners)
    squares.push_back({flat_square(v[1], v[2]), flat_square(v[2], v[0]), flat_square(v[0], v[1])});
  return squares;
}

TEST(HalvedNets, HaveMidpointsForCorners) {
  const Precision scope(128);
  for (const char* name : {"octagon-5-of-one-vertex", "bolza"}) {
    const NetDocument net = file(name).net;
    const auto labels = labels_of(net, 128);
    const auto wanted = squares_of(net, 2);
    for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
      const auto found = certify::flat_sides(net, labels, t, 2);
      ASSERT_EQ(found.size(), 16U);
      for (std::size_t small = 0; small < 16; ++small) {
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(middle(found[small][k]), wanted[16 * t + small][k], 1e-10) << name << ' ' << t << ' ' << small;
      }
    }
    // The same corners in the second checker's order.
    Corners corners;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Point3 v = corner(net, labels, 3 + i);
      corners[i] = {interval(v[0]), interval(v[1]), interval(v[2])};
    }
    std::size_t visited = 0;
    each_halved(1, corners, 2, [&](std::size_t small, const Corners& its) {
      EXPECT_EQ(small, 16 + visited);
      ++visited;
      for (std::size_t k = 0; k < 3; ++k) {
        Vector side;
        for (std::size_t i = 0; i < 3; ++i) side[i] = its[(k + 2) % 3][i] - its[(k + 1) % 3][i];
        EXPECT_NEAR(middle(lorentz_product(side, side)), wanted[small][k], 1e-10) << name << ' ' << small;
      }
    });
    EXPECT_EQ(visited, 16U);
  }
}

// Dense matrices.

/// The pivots of elimination without exchanges.
std::vector<double> pivots(Dense m) {
  std::vector<double> result;
  for (std::size_t k = 0; k < m.size(); ++k) {
    result.push_back(m[k][k]);
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const double factor = m[i][k] / m[k][k];
      if (factor == 0) continue;
      for (std::size_t j = k + 1; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return result;
}
std::size_t negative(const Dense& m) {
  const auto all = pivots(m);
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](double d) { return d < 0; }));
}

/// 𝒜 and 𝒩, or 𝒜₁ and 𝒩₁, of a whole net.
struct Pencil {
  Dense energy, mass;
  double constant = 0;  ///< H

  [[nodiscard]] std::size_t negative_at(double sigma) const {
    Dense m = energy;
    for (std::size_t i = 0; i < m.size(); ++i) {
      for (std::size_t j = 0; j < m.size(); ++j) m[i][j] -= sigma * mass[i][j];
    }
    return negative(m);
  }
  /// The σ from which on n of the eigenvalues of 𝒜 − σ𝒩 are negative.
  [[nodiscard]] double threshold(std::size_t n) const {
    double low = 0;
    double high = 1000;
    for (int i = 0; i < 46; ++i) {
      const double sigma = low + (high - low) / 2;
      (negative_at(sigma) >= n ? high : low) = sigma;
    }
    return high;
  }
};

Dense dense(std::size_t size) { return Dense(size, std::vector<double>(size)); }

Pencil pencil(const NetDocument& net, std::uint32_t halvings, bool of_sides) {
  const HalvedNet numbers = exactly_halved(net, halvings);
  const auto squares = squares_of(net, halvings);
  const HalvedSize size = halved_size(exact_net(net), halvings);
  const std::size_t rows = of_sides ? size.sides : size.vertices;
  Pencil result{dense(rows), dense(rows)};
  for (std::size_t t = 0; t < squares.size(); ++t) {
    const Triangle flat = triangle(squares[t]);
    const Forms forms = expected(flat);
    std::array<std::size_t, 3> row{};
    for (std::size_t k = 0; k < 3; ++k)
      row[k] = of_sides ? numbers.side[3 * t + (k + 1) % 3] : numbers.start[3 * t + k];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        result.energy[row[i]][row[j]] += (of_sides ? forms.least_energy : forms.greatest_energy)[i][j];
        result.mass[row[i]][row[j]] += (of_sides ? forms.greatest_mass : forms.least_mass)[i][j];
      }
    }
    result.constant = std::max(result.constant, forms.interpolation);
  }
  return result;
}

TEST(Matrices, OfConstantsHaveNoEnergyAndTheAreaForMass) {
  for (const char* name : {"octagon-5-of-one-vertex", "octagon-5-from-a-quarter"}) {
    const NetDocument net = file(name).net;
    const double area = 4 * std::numbers::pi;
    for (const bool of_sides : {false, true}) {
      double before = HUGE_VAL;
      for (const std::uint32_t halvings : {0U, 1U, 2U}) {
        double energy = 0;
        double mass = 0;
        for (const auto& squares : squares_of(net, halvings)) {
          for (const Forms& forms : {of_first(triangle(squares)), of_second(triangle(squares))}) {
            energy += std::abs(value(of_sides ? forms.least_energy : forms.greatest_energy, {1, 1, 1})) / 2;
            mass += value(of_sides ? forms.greatest_mass : forms.least_mass, {1, 1, 1}) / 2;
          }
        }
        EXPECT_LT(energy, 1e-9);
        const double excess = (of_sides ? mass - area : area - mass) / area;
        EXPECT_GT(excess, 0) << name << ' ' << halvings;
        EXPECT_LT(excess, before / 2) << name << ' ' << halvings;
        before = excess;
      }
      EXPECT_LT(before, name[10] == 'o' ? 0.1 : 0.005);
    }
  }
}

/// The net with one count and nothing claimed.
Document with_count(const NetDocument& net, std::uint32_t halvings, bool at_most) {
  Document document;
  document.net = net;
  document.halvings = halvings;
  const auto sizes = certify::halved_sizes(net, halvings);
  auto& order = at_most ? document.side_order : document.vertex_order;
  order.resize(at_most ? sizes.sides : sizes.vertices);
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(halvings));  // NOLINT: the same in every run.
  return document;
}

/// What both checkers say.
std::string both(const Document& document) {
  const certify::Certificate first = certify::check(document, {.threads = 1});
  const Result second = check(text(document));
  const std::string one = std::string(certify::name(first.verdict)) + (first.rule.empty() ? "" : ": " + first.rule);
  static constexpr std::array<const char*, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  const std::string other =
      kNames.at(static_cast<std::size_t>(second.verdict)) + (second.rule.empty() ? "" : ": " + second.rule);
  return one == other ? one : one + " (" + first.message + "), but " + other + " (" + second.message + ")";
}

struct Halved {
  const char* name;
  std::uint32_t halvings;
};

/// The whole of Lemmas 31 to 36: forms, numbers of sides and vertices, orders, sums over triangles, also of those with
/// one vertex in two corners: both checkers count as a dense matrix in binary64 does, to a millionth.
class Thresholds : public testing::TestWithParam<Halved> {};

TEST_P(Thresholds, OfBothCheckersAreThoseOfDenseMatrices) {
  const auto& [name, halvings] = GetParam();
  const NetDocument net = std::string(name).starts_with("fenchel-nielsen")
                              ? certify::read_file<certify::IsometriesDocument>(std::string(EPSNET_TEST_DATA) +
                                                                                "/isometries/" + name + ".json")
                                    .net
                              : file(name).net;
  const Pencil sides = pencil(net, halvings, true);
  for (const std::uint32_t count : {0U, 2U}) {
    const double sigma = sides.threshold(count + 2);
    SCOPED_TRACE(sigma);
    Document document = with_count(net, halvings, true);
    const double below = sigma * (1 - 1e-6);
    document.at_most = {{below / 8, count, below}};
    EXPECT_EQ(both(document), "VERIFIED");
    document.at_most[0].sigma = sigma * (1 + 1e-6);
    EXPECT_EQ(both(document), "UNDECIDED: most");
    if (count > 0) continue;
    // τ = σ/(1 + Hσ)
    document.at_most[0] = {below / (1 + sides.constant * below) * (1 - 1e-9), count, below};
    EXPECT_EQ(both(document), "VERIFIED");
    document.at_most[0].below = below / (1 + sides.constant * below) * (1 + 1e-9);
    EXPECT_EQ(both(document), "UNDECIDED: most");
  }
  const Pencil vertices = pencil(net, halvings, false);
  for (const std::uint32_t count : {1U, 3U}) {
    if (vertices.energy.size() < count + 1) continue;
    const double below = vertices.threshold(count + 1);
    SCOPED_TRACE(below);
    Document document = with_count(net, halvings, false);
    document.at_least = {{below * (1 + 1e-6), count}};
    EXPECT_EQ(both(document), "VERIFIED");
    document.at_least = {{below * (1 - 1e-6), count}};
    EXPECT_EQ(both(document), "UNDECIDED: least");
  }
}

INSTANTIATE_TEST_SUITE_P(Nets, Thresholds,
                         testing::Values(Halved{"octagon-5-of-one-vertex", 0}, Halved{"octagon-5-of-one-vertex", 1},
                                         Halved{"octagon-5-from-a-quarter", 0}, Halved{"octagon-5-with-a-function", 0},
                                         Halved{"bolza-with-three-functions", 1},
                                         // Triangles with one vertex in two corners.
                                         Halved{"fenchel-nielsen-3-1", 0}));

/// With the triangles numbered from another one on.
NetDocument with_first_triangle(const NetDocument& net, std::uint32_t first) {
  std::vector<std::uint32_t> order(net.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::rotate(order.begin(), order.begin() + first, order.end());
  return certify::with_triangles_in_order(net, order);
}

/// H is that of the worst triangle, whichever it is.
TEST(Matrices, TheConstantIsThatOfTheWorstTriangle) {
  for (const auto& [name, halvings] : {Halved{"octagon-5-with-a-function", 0}, {"octagon-5-of-one-vertex", 1}}) {
    const NetDocument whole = file(name).net;
    double greatest = 0;
    for (const auto& squares : squares_of(whole, halvings))
      greatest = std::max(greatest, expected(triangle(squares)).interpolation);
    for (std::uint32_t first = 0; first < whole.triangles.size(); ++first) {
      // So many are counted that nothing but H matters.
      Document document = with_count(with_first_triangle(whole, first), halvings, true);
      constexpr double kSigma = 7.3;
      const auto count = static_cast<std::uint32_t>(document.side_order.size());
      document.at_most = {{kSigma / (1 + greatest * kSigma) * (1 - 1e-9), count, kSigma}};
      EXPECT_EQ(both(document), "VERIFIED") << name << ' ' << first;
      document.at_most[0].below *= 1 + 2e-9;
      EXPECT_EQ(both(document), "UNDECIDED: most") << name << ' ' << first;
    }
  }
}

// Sections of flat line bundles.

/// The values of a section by which a triangle's three are known: of its corners, or of its sides, each a number of
/// all and a unit, by which it is multiplied in the frame of the triangle of the net.
struct Values {
  std::vector<std::size_t> number;
  std::vector<Complexd> unit;
  std::size_t count = 0;
};

/// By dart of the halved triangles: e^{2πip} with f_T = e^{2πip} f_{T′} for the triangles T, T′ of the net on its two
/// sides. By the label of a corner, f_T is e^{2πiφ} times the function of the corner's vertex.
std::vector<Complexd> transitions(const NetDocument& net, const std::vector<double>& phases, std::uint32_t halvings) {
  const auto of_corner = [&](std::uint32_t dart) {
    const std::uint32_t label = certify::corner_label(net, dart);
    double sum = 0;
    if (label > 0) {
      for (const std::uint32_t side : net.labels[label - 1].word) sum += phases[side];
    }
    return sum;
  };
  std::vector<Complexd> result;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t other = net.triangles[dart / 3].opposite[dart % 3];
    const std::uint32_t end = other / 3 * 3 + (other % 3 + 1) % 3;
    result.push_back(std::polar(1.0, 2 * std::numbers::pi * (of_corner(dart) - of_corner(end))));
  }
  for (; halvings > 0; --halvings) {
    // The side from corner i to corner i + 1 is a side of both small triangles there, the first and the last one.
    std::vector<Complexd> halves(4 * result.size(), 1);
    for (std::size_t dart = 0; dart < result.size(); ++dart) {
      const std::size_t t = dart / 3;
      halves[3 * (4 * t + dart % 3)] = result[dart];
      halves[3 * (4 * t + (dart + 1) % 3) + 2] = result[dart];
    }
    result = std::move(halves);
  }
  return result;
}

/// From one dart to the next around its vertex, or across its side, as long as there are new ones; a value that is met
/// again is the same.
Values values_of(const HalvedNet& net, const std::vector<Complexd>& transitions, bool of_sides) {
  Values result{std::vector<std::size_t>(transitions.size()), std::vector<Complexd>(transitions.size()), 0};
  for (std::size_t first = 0; first < transitions.size(); ++first) {
    if (result.unit[first] != 0.0) continue;
    Complexd unit = 1;
    std::size_t dart = first;
    do {
      result.number[dart] = result.count;
      result.unit[dart] = unit;
      const std::size_t other = net.opposite[dart];
      // The function beyond the dart is that of its own triangle, divided by the transition.
      unit /= transitions[dart];
      dart = of_sides ? other : other / 3 * 3 + (other % 3 + 1) % 3;
    } while (dart != first);
    EXPECT_LT(std::abs(unit - 1.0), 1e-12);
    ++result.count;
  }
  return result;
}

/// With rows for the real and the imaginary parts.
Pencil pencil_of_sections(const NetDocument& net, const std::vector<double>& phases, std::uint32_t halvings,
                          bool of_sides) {
  const auto squares = squares_of(net, halvings);
  const Values values = values_of(exactly_halved(net, halvings), transitions(net, phases, halvings), of_sides);
  Pencil result{dense(2 * values.count), dense(2 * values.count)};
  const auto add = [&](Dense& sum, std::size_t row, std::size_t column, Complexd x) {
    sum[2 * row][2 * column] += x.real();
    sum[2 * row + 1][2 * column + 1] += x.real();
    sum[2 * row + 1][2 * column] += x.imag();
    sum[2 * row][2 * column + 1] -= x.imag();
  };
  for (std::size_t t = 0; t < squares.size(); ++t) {
    const Forms forms = expected(triangle(squares[t]));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto dart = [&](std::size_t k) { return 3 * t + (of_sides ? (k + 1) % 3 : k); };
        // ∫ |f|² is the sum of conj(x_i u_i) h_ij u_j x_j.
        const Complexd units = std::conj(values.unit[dart(i)]) * values.unit[dart(j)];
        const std::size_t row = values.number[dart(i)];
        const std::size_t column = values.number[dart(j)];
        add(result.energy, row, column, units * (of_sides ? forms.least_energy : forms.greatest_energy)[i][j]);
        add(result.mass, row, column, units * (of_sides ? forms.greatest_mass : forms.least_mass)[i][j]);
      }
    }
  }
  return result;
}

struct Bundle {
  const char* name;
  std::uint32_t halvings;
  /// Across sides 0 to 3 of the octagon, which is glued to itself by opposite sides.
  std::array<mpq_class, 4> phases;
};

/// Section 17.3: both checkers count as a dense Hermitian matrix does, to a millionth.
class ThresholdsOfSections : public testing::TestWithParam<Bundle> {};

TEST_P(ThresholdsOfSections, OfBothCheckersAreThoseOfDenseMatrices) {
  const auto& [name, halvings, phases] = GetParam();
  const NetDocument net = file(name).net;
  std::vector<double> of_sides;
  std::vector<std::string> written;
  for (const int sign : {1, -1}) {
    for (const mpq_class& phase : phases) {
      of_sides.push_back(sign * phase.get_d());
      written.push_back(mpq_class(sign * phase).get_str());
    }
  }
  const auto outcome = [&](Document document) {
    document.phases = written;
    return both(document);
  };
  const Pencil sides = pencil_of_sections(net, of_sides, halvings, true);
  for (const std::uint32_t count : {0U, 1U, 4U}) {
    const double sigma = sides.threshold(2 * (count + 1) - 1);
    SCOPED_TRACE(sigma);
    Document document = with_count(net, halvings, true);
    document.at_most = {{sigma / 8, count, sigma * (1 - 1e-6)}};
    EXPECT_EQ(outcome(document), "VERIFIED");
    document.at_most[0].sigma = sigma * (1 + 1e-6);
    EXPECT_EQ(outcome(document), "UNDECIDED: most");
  }
  const Pencil vertices = pencil_of_sections(net, of_sides, halvings, false);
  for (const std::uint32_t count : {1U, 2U, 5U}) {
    if (vertices.energy.size() < 2 * std::size_t{count}) continue;
    const double below = vertices.threshold(2 * count - 1);
    SCOPED_TRACE(below);
    Document document = with_count(net, halvings, false);
    document.at_least = {{below * (1 + 1e-6), count}};
    EXPECT_EQ(outcome(document), "VERIFIED");
    document.at_least = {{below * (1 - 1e-6), count}};
    EXPECT_EQ(outcome(document), "UNDECIDED: least");
  }
}

const std::array<mpq_class, 4> kSome{mpq_class(3, 10), mpq_class(1, 7), mpq_class(-9, 20), mpq_class(2, 3)};
const std::array<mpq_class, 4> kHalves{mpq_class(1, 2), 0, mpq_class(-1, 2), mpq_class(1, 2)};
const std::array<mpq_class, 4> kThirds{mpq_class(1, 3), 0, mpq_class(2, 3), 0};
const std::array<mpq_class, 4> kQuarters{mpq_class(1, 4), 0, mpq_class(1, 2), mpq_class(-1, 4)};

INSTANTIATE_TEST_SUITE_P(
    Bundles, ThresholdsOfSections,
    testing::Values(Bundle{"octagon-5-of-one-vertex", 0, kSome}, Bundle{"octagon-5-of-one-vertex", 1, kSome},
                    Bundle{"octagon-5-of-one-vertex", 2, kSome}, Bundle{"octagon-5-with-a-function", 0, kSome},
                    Bundle{"octagon-5-of-one-vertex", 1, kHalves}, Bundle{"octagon-5-of-one-vertex", 1, kThirds},
                    Bundle{"octagon-5-of-one-vertex", 1, kQuarters}));

// Inertia of the second checker.

/// Random forms on triples of rows: what the second checker counts is what pivots in another order say.
RC_GTEST_PROP(SecondCheckersInertia, CountsAsDenseMatricesDo, ()) {
  const auto size = static_cast<std::size_t>(*rc::gen::inRange(1, 40));
  const auto triangles = static_cast<std::size_t>(*rc::gen::inRange(1, 60));
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const auto number = [&] { return static_cast<double>(static_cast<int>(random() % 2001) - 1000) / 500; };
  std::vector<Inertia::Rows> rows(triangles);
  for (auto& three : rows) {
    for (Index& row : three) row = static_cast<Index>(random() % size);
  }
  Inertia inertia(rows, size, 1'000'000);
  const double sigma = 1.5;
  Dense m = dense(size);
  // Each row has something on its diagonal.
  for (std::size_t t = 0; t < triangles; ++t) {
    LocalForms forms;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const double energy = number();
        const double mass = number();
        forms.energy[i][j] = forms.energy[j][i] = interval(energy);
        forms.mass[i][j] = forms.mass[j][i] = interval(mass);
        m[rows[t][i]][rows[t][j]] += energy - sigma * mass;
        if (i != j) m[rows[t][j]][rows[t][i]] += energy - sigma * mass;
      }
    }
    inertia.add(t, forms);
  }
  // Backwards, and with the first column in another place.
  Dense turned = dense(size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) turned[i][j] = m[size - 1 - i][size - 1 - j];
  }
  const auto all = pivots(turned);
  const bool clear = std::all_of(all.begin(), all.end(), [](double d) { return std::abs(d) > 1e-4; });
  std::size_t proved = 0;
  for (const auto bound : {Inertia::Bound::at_most, Inertia::Bound::at_least}) {
    try {
      const std::size_t found = inertia.negative(interval(sigma), bound);
      ++proved;
      if (clear) RC_ASSERT(found == negative(turned));
      // Rows that are empty have the eigenvalue 0, which counts neither way.
    } catch (const TooLarge&) {
    }
  }
  RC_TAG(proved == 2 && clear);
}

TEST(SecondCheckersInertia, EntriesAreWhatIsWorst) {
  const auto count = [](double low, double high, Inertia::Bound bound) {
    Inertia inertia({{0, 0, 0}}, 1, 1000);
    LocalForms forms;
    forms.energy[0][0] = Interval(mpz_class(std::ldexp(low, 40)), mpz_class(std::ldexp(high, 40)), 40);
    inertia.add(0, forms);
    return inertia.negative(interval(1), bound);
  };
  const double tiny = 0x1p-22;
  EXPECT_EQ(count(tiny, 2 * tiny, Inertia::Bound::at_most), 0U);
  EXPECT_EQ(count(-2 * tiny, -tiny, Inertia::Bound::at_least), 1U);
  EXPECT_EQ(count(-2 * tiny, -tiny, Inertia::Bound::at_most), 1U);
  EXPECT_EQ(count(tiny, 2 * tiny, Inertia::Bound::at_least), 0U);
  // Of either sign: perhaps negative, and perhaps not.
  EXPECT_EQ(count(-tiny, tiny, Inertia::Bound::at_most), 1U);
  EXPECT_EQ(count(-tiny, tiny, Inertia::Bound::at_least), 0U);
}

TEST(SecondCheckersInertia, EntriesBesideTheDiagonalMayBeWide) {
  const auto count = [](double error, Inertia::Bound bound) {
    Inertia inertia({{0, 1, 1}}, 2, 1000);
    LocalForms forms;
    // (1, x; x, 1), |x| ≤ error, or its negative.
    const double diagonal = bound == Inertia::Bound::at_most ? 1 : -1;
    forms.energy[0][0] = forms.energy[1][1] = interval(diagonal);
    forms.energy[0][1] = forms.energy[1][0] = Interval(mpz_class(0), mpz_class(std::ldexp(error, 60)), 60);
    inertia.add(0, forms);
    return inertia.negative(interval(1), bound);
  };
  EXPECT_EQ(count(0x1p-40, Inertia::Bound::at_most), 0U);
  EXPECT_EQ(count(0x1p-40, Inertia::Bound::at_least), 2U);
  for (const double error : {0x1p-28, 0x1p-4}) {
    EXPECT_THROW(count(error, Inertia::Bound::at_most), TooLarge) << error;
    EXPECT_THROW(count(error, Inertia::Bound::at_least), TooLarge) << error;
  }
}

/// Less than the shift, 2⁻³¹: a matrix that is perhaps indefinite.
TEST(SecondCheckersInertia, TheShiftIsOnTheDiagonal) {
  const auto count = [](double diagonal, Inertia::Bound bound) {
    Inertia inertia({{0, 1, 1}}, 2, 1000);
    LocalForms forms;
    forms.energy[0][0] = forms.energy[1][1] = interval(diagonal);
    forms.energy[0][1] = forms.energy[1][0] = Interval(mpz_class(0), mpz_class(256), 40);  // To 2⁻³².
    inertia.add(0, forms);
    try {
      return static_cast<int>(inertia.negative(interval(1), bound));
    } catch (const TooLarge&) {
      return bound == Inertia::Bound::at_most ? 2 : 0;
    }
  };
  EXPECT_GE(count(0x1p-33, Inertia::Bound::at_most), 1);
  EXPECT_LE(count(-0x1p-33, Inertia::Bound::at_least), 1);
  EXPECT_EQ(count(0x1p-20, Inertia::Bound::at_most), 0);
  EXPECT_EQ(count(-0x1p-20, Inertia::Bound::at_least), 2);
}

/// Each error is less than the shift; those of the last row are more together.
TEST(SecondCheckersInertia, ErrorsOfARowAddUp) {
  const auto count = [](Index rows) {
    std::vector<Inertia::Rows> triangles;
    for (Index k = 1; k < rows; ++k) triangles.push_back({0, k, k});
    Inertia inertia(triangles, rows, 100'000);
    for (std::size_t k = 0; k + 1 < rows; ++k) {
      LocalForms forms;
      forms.energy[0][0] = interval(k == 0 ? 1 : 0);
      forms.energy[1][1] = interval(1);
      // To 0.4·2⁻³¹.
      forms.energy[0][1] = forms.energy[1][0] = Interval(mpz_class(0), mpz_class(4), 31) / 10;
      inertia.add(k, forms);
    }
    return inertia.negative(interval(1), Inertia::Bound::at_most);
  };
  EXPECT_EQ(count(2), 0U);
  EXPECT_THROW(count(5), TooLarge);
}

/// The last row has so many quotients that what they leave is more than the shift.
TEST(SecondCheckersInertia, WhatQuotientsLeaveAddsUp) {
  const auto count = [](Index columns) {
    std::vector<Inertia::Rows> triangles;
    for (Index k = 0; k < columns; ++k) triangles.push_back({k, columns, columns});
    Inertia inertia(std::move(triangles), columns + 1, 10'000'000);
    for (Index k = 0; k < columns; ++k) {
      LocalForms forms;
      forms.energy[0][0] = interval(1000);
      forms.energy[1][1] = interval(k == 0 ? 1000 : 0);
      forms.energy[0][1] = forms.energy[1][0] = interval(0.05 + k * 0x1p-40);
      inertia.add(k, forms);
    }
    return inertia.negative(interval(1), Inertia::Bound::at_most);
  };
  EXPECT_EQ(count(2000), 0U);
  EXPECT_THROW(count(70'000), TooLarge);
}

TEST(SecondCheckersInertia, SmallAndLargeNumbersAreNotDecided) {
  const auto count = [](double x, double y) {
    Inertia inertia({{0, 1, 1}}, 2, 1000);
    LocalForms forms;
    forms.energy[0][0] = interval(x);
    forms.energy[0][1] = forms.energy[1][0] = interval(y / 2);
    forms.energy[1][1] = interval(1);
    inertia.add(0, forms);
    return inertia.negative(interval(1), Inertia::Bound::at_most);
  };
  EXPECT_EQ(count(1, 0.5), 0U);
  EXPECT_EQ(count(-1, 0.5), 1U);
  EXPECT_THROW(count(0, 1), TooLarge);
  EXPECT_THROW(count(0x1p-31, 1), TooLarge);
  EXPECT_THROW(count(1e9, 1), TooLarge);
  EXPECT_THROW(count(1e300, 1), TooLarge);
  EXPECT_THROW(count(-1e9, 1), TooLarge);
  EXPECT_THROW(count(1e-7, 1e9), TooLarge);
}

/// A column of c entries below its diagonal takes (c + 1)² multiplications.
TEST(SecondCheckersInertia, TakesNoMoreMultiplicationsThanAreAllowed) {
  const std::vector<Inertia::Rows> arrow{{0, 1, 3}, {1, 2, 3}, {0, 2, 3}};
  EXPECT_NO_THROW(Inertia(arrow, 4, 16 + 9 + 4 + 1));
  EXPECT_THROW(Inertia(arrow, 4, 16 + 9 + 4), LeftOut);
  // The first column fills those behind it.
  const std::vector<Inertia::Rows> star{{0, 1, 1}, {0, 2, 2}, {0, 3, 3}};
  EXPECT_THROW(Inertia(star, 4, 16 + 9 + 4), LeftOut);
  const std::vector<Inertia::Rows> last{{0, 3, 3}, {1, 3, 3}, {2, 3, 3}};
  EXPECT_NO_THROW(Inertia(last, 4, 4 + 4 + 4 + 1));
}

// Enclosures.

struct Counted {
  const Document& document;

  /// A(x) of docs/proof.md, as it is written.
  [[nodiscard]] std::int64_t least_up_to(double x) const {
    std::int64_t best = 0;
    const auto with = [&](double y, std::int64_t count) {
      for (const auto& row : document.eigenfunctions) {
        if (y <= row.in.lower && row.in.upper <= x) count += static_cast<std::int64_t>(row.functions.size());
      }
      best = std::max(best, count);
    };
    with(0, 0);
    for (const auto& row : document.at_least) {
      if (row.below <= x) with(row.below, row.count);
    }
    return best;
  }
  /// B(x); nothing if no row says anything.
  [[nodiscard]] std::optional<std::int64_t> most_below(double x) const {
    if (x == 0) return 0;
    std::optional<std::int64_t> best;
    for (const auto& row : document.at_most) {
      if (row.below < x) continue;
      std::int64_t count = row.count;
      for (const auto& function : document.eigenfunctions) {
        if (x <= function.in.lower && function.in.upper < row.below)
          count -= static_cast<std::int64_t>(function.functions.size());
      }
      best = best ? std::min(*best, count) : count;
    }
    return best;
  }
  [[nodiscard]] bool follows() const {
    const auto at_most = [&](double x, std::int64_t n) { return most_below(x) && *most_below(x) <= n; };
    std::int64_t before = 0;
    for (const auto& row : document.eigenvalues) {
      if (!at_most(row.in.lower, before)) return false;
      before += row.count;
      if (least_up_to(row.in.upper) < before) return false;
    }
    return at_most(document.next, before);
  }
};

bool second_says_so(const Document& document) {
  EigenvaluesDocument same{};
  const auto range = [](const certify::Interval& in) { return Range{mpq_class(in.lower), mpq_class(in.upper)}; };
  for (const auto& row : document.eigenvalues) same.eigenvalues.push_back({range(row.in), row.count});
  same.next = document.next;
  for (const auto& row : document.at_most) same.at_most.push_back({row.below, row.count, row.sigma});
  for (const auto& row : document.at_least) same.at_least.push_back({row.below, row.count});
  for (const auto& row : document.eigenfunctions)
    same.eigenfunctions.push_back(
        {range(row.in), row.lambda, row.radius, std::vector<Coefficients>(row.functions.size())});
  try {
    check_enclosures(same);
    return true;
  } catch (const Refutation&) {
    return false;
  }
}

/// Rows with small integers, among which ties are frequent, and half of which are about the same eigenvalues.
Document random_rows(std::mt19937& random) {
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  std::vector<std::uint32_t> eigenvalues(below(6));
  for (auto& x : eigenvalues) x = 1 + below(9);
  const auto less = [&](double x) {
    return static_cast<std::uint32_t>(
        std::count_if(eigenvalues.begin(), eigenvalues.end(), [&](std::uint32_t y) { return y < x; }));
  };
  Document document;
  for (std::uint32_t i = below(4); i > 0; --i) {
    const double y = 1 + below(10);
    document.at_most.push_back({y, less(y) + (below(4) == 0 ? below(3) : 0), y});
  }
  for (std::uint32_t i = below(4); i > 0; --i) {
    const double y = 1 + below(10);
    if (less(y) > 0) document.at_least.push_back({y, 1 + below(less(y))});
  }
  double from = 1;
  while (below(4) != 0 && from < 9) {
    const double low = from + below(3);
    const double high = low + below(below(3) == 0 ? 7 : 3) * 0.5;
    document.eigenfunctions.push_back({{low, high}, low, 1, std::vector<Document::Coefficients>(1 + below(2))});
    from = high + 0.5 + 0.5 * below(2);
  }
  for (std::uint32_t i = below(4); i > 0; --i) {
    const double low = below(9);
    document.eigenvalues.push_back({{low, low + below(4) * 0.5}, 1 + below(2)});
  }
  document.next = below(3) == 0 ? 0 : below(11);
  return document;
}

TEST(Enclosures, OfBothCheckersAreThoseOfTheDefinition) {
  std::mt19937 random(5);  // NOLINT: the same in every run.
  int following = 0;
  const int cases = 3 * test::scaled(4000);
  for (int i = 0; i < cases; ++i) {
    Document document = random_rows(random);
    Counted counted{document};
    // Half of the claims are what follows, or nearly.
    if (i % 2 == 0) {
      std::int64_t before = 0;
      for (auto& row : document.eigenvalues) {
        while (row.in.lower > 0 && !(counted.most_below(row.in.lower).value_or(99) <= before)) row.in.lower -= 0.5;
        while (row.in.upper < 12 && counted.least_up_to(row.in.upper) < before + row.count) row.in.upper += 0.5;
        before += row.count;
      }
      while (document.next > 0 && !(counted.most_below(document.next).value_or(99) <= before)) document.next -= 0.5;
    }
    const certify::CountedEigenvalues found(document);
    for (double x = 0; x <= 12; x += 0.25) {
      ASSERT_EQ(found.least_up_to(x), counted.least_up_to(x)) << i << ' ' << x;
      const auto most = counted.most_below(x);
      ASSERT_EQ(found.most_below(x), most ? std::max<std::int64_t>(*most, 0) : std::numeric_limits<std::int64_t>::max())
          << i << ' ' << x;
    }
    const bool follows = counted.follows();
    following += follows ? 1 : 0;
    ASSERT_EQ(!found.problem().has_value(), follows) << i << ": " << found.problem().value_or("");
    ASSERT_EQ(second_says_so(document), follows) << i;
  }
  EXPECT_GT(following, cases / 20);
  EXPECT_LT(following, cases * 9 / 10);
}

// Eigenfunctions.

/// A lift of a vertex, from another one.
struct Near {
  std::uint32_t vertex;
  Complexd a, b;
};
using NearOfAll = std::vector<std::vector<Near>>;

NearOfAll near_of(const std::vector<std::vector<certify::NearVertex>>& found) {
  NearOfAll result;
  for (const auto& lifts : found) {
    result.emplace_back();
    for (const auto& lift : lifts)
      result.back().push_back({lift.vertex, middle(lift.isometry.a), middle(lift.isometry.b)});
  }
  return result;
}

/// Lemmas 37.1 to 37.6 in binary64.
class Reference {
 public:
  Reference(const Document::Eigenfunctions& row, double epsilon, double genus, const NearOfAll& near)
      : row_(row),
        epsilon_(epsilon),
        genus_(genus),
        near_(near),
        each_(row.functions[0].size() / near.size()),
        order_(each_ / 2) {}

  /// F_m(s) by its series.
  [[nodiscard]] double factor(std::size_t m, double s) const {
    const double x = s / (1 - s);
    double term = 1;
    double sum = 0;
    for (int k = 0; k < 400 && std::abs(term) > 1e-18; ++k) {
      sum += term;
      term *= -x * (row_.lambda + k * k + k) / ((static_cast<double>(m) + 1 + k) * (k + 1));
    }
    return sum;
  }
  /// At a point of the disk with the vertex in its centre.
  [[nodiscard]] std::vector<double> functions(std::size_t vertex, Complexd z) const {
    std::vector<double> sums(row_.functions.size());
    Complexd power = 1;
    for (std::size_t m = 0; m <= order_; ++m, power *= z) {
      const double radial = factor(m, std::norm(z));
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto [alpha, beta] = coefficient(i, vertex, m);
        sums[i] += (alpha * power.real() + beta * power.imag()) * radial;
      }
    }
    return sums;
  }

  struct Bound {
    double value = 0;
    double gradient = 0;
  };
  /// Lemma 37.4.
  [[nodiscard]] std::vector<Bound> mismatch(std::uint32_t vertex, const Near& near) const {
    const double d = 2 * std::asinh(std::abs(near.b));
    const Complexd centre = near.b / std::conj(near.a);  // Where the lift is.
    const Complexd midpoint = centre / std::abs(centre) * std::tanh(d / 4);
    const double radius = std::acosh((std::cosh(epsilon_) + std::cosh(row_.radius)) / (2 * std::cosh(d / 2)));
    const double t = std::tanh(radius / 2);
    const auto j = static_cast<double>(order_);
    const std::size_t n = 2 * order_;
    const double wider = std::asinh((j + 1) / std::sqrt(row_.lambda));
    const double z = t / std::tanh(wider / 2);
    std::vector<std::vector<double>> values(row_.functions.size());
    for (std::size_t k = 0; k < n; ++k) {
      const Complexd around = std::polar(t, 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
      const Complexd x = (around + midpoint) / (1.0 + std::conj(midpoint) * around);
      const Complexd from_other = (std::conj(near.a) * x - near.b) / (-std::conj(near.b) * x + near.a);
      const auto other = functions(near.vertex, from_other);
      const auto own = functions(vertex, x);
      for (std::size_t i = 0; i < values.size(); ++i) values[i].push_back(other[i] - own[i]);
    }
    std::vector<Bound> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double total = this->total(i, vertex) + this->total(i, near.vertex);
      const double tail =
          2 * total * std::exp(row_.lambda * (std::cosh(wider) - 1) / (j + 1)) * std::pow(z, j) / (1 - z);
      Bound bound{tail, tail * ((j + z / (1 - z)) / t + row_.lambda * t)};
      for (int m = 1 - static_cast<int>(order_); m < static_cast<int>(order_); ++m) {
        Complexd sum = 0;
        for (std::size_t k = 0; k < n; ++k)
          sum += values[i][k] *
                 std::polar(1.0, -2 * std::numbers::pi * m * static_cast<double>(k) / static_cast<double>(n));
        const double size = std::abs(m);
        const double e =
            (std::abs(sum) / static_cast<double>(n) + tail) / std::abs(factor(static_cast<std::size_t>(size), t * t));
        bound.value += e;
        bound.gradient += e * (size / t + row_.lambda * t);
      }
      result.push_back(bound);
    }
    return result;
  }

  /// q of Lemma 37.6, and δ; infinite if nothing is proved.
  [[nodiscard]] double least_square() const {
    double sinh_eta = std::min(std::sinh(epsilon_), 1 / std::sqrt(row_.lambda));
    for (const auto& lifts : near_) {
      for (const Near& lift : lifts) sinh_eta = std::min(sinh_eta, std::abs(lift.b));
    }
    const double eta = std::asinh(sinh_eta);
    const double s = std::pow(std::tanh(eta / 2), 2);
    const auto product = [&](std::size_t i, std::size_t j) {
      double sum = 0;
      for (std::size_t k = 0; k < near_.size(); ++k) {
        for (std::size_t m = 0; m <= order_; ++m) {
          const auto [alpha, beta] = coefficient(i, k, m);
          const auto [other_alpha, other_beta] = coefficient(j, k, m);
          const double next = static_cast<double>(m) + 1;
          sum += (m == 0 ? 2 : 1) * std::numbers::pi * (alpha * other_alpha + beta * other_beta) *
                 std::exp(-2 * row_.lambda * (std::cosh(eta) - 1) / next) * 2 * std::pow(s, next) / next;
        }
      }
      return sum;
    };
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < row_.functions.size(); ++i) {
      double q = product(i, i);
      for (std::size_t j = 0; j < row_.functions.size(); ++j) q -= j == i ? 0 : std::abs(product(i, j));
      least = std::min(least, q);
    }
    return least;
  }
  [[nodiscard]] double error(const std::vector<certify::PartitionBounds>& partition) const {
    const std::size_t count = row_.functions.size();
    std::vector<std::vector<Bound>> greatest(count, std::vector<Bound>(near_.size()));
    for (std::uint32_t k = 0; k < near_.size(); ++k) {
      for (const Near& lift : near_[k]) {
        if (lift.vertex < k) continue;  // The same pair from its other end.
        const auto bounds = mismatch(k, lift);
        for (const std::uint32_t end : {k, lift.vertex}) {
          for (std::size_t i = 0; i < count; ++i) {
            greatest[i][end].value = std::max(greatest[i][end].value, bounds[i].value);
            greatest[i][end].gradient = std::max(greatest[i][end].gradient, bounds[i].gradient);
          }
        }
      }
    }
    std::vector<double> residuals(near_.size());
    std::vector<double> errors(near_.size());
    for (std::size_t k = 0; k < near_.size(); ++k) {
      for (std::size_t i = 0; i < count; ++i) {
        residuals[k] += std::pow(
            greatest[i][k].value * partition[k].laplacians + 2 * greatest[i][k].gradient * partition[k].gradients, 2);
        errors[k] += std::pow(greatest[i][k].value, 2);
      }
    }
    const double q = least_square();
    const double norm = q > 0 ? std::sqrt(q) - std::sqrt(integral(errors)) : -1;
    return norm > 0 ? std::sqrt(integral(residuals)) / norm : HUGE_VAL;
  }
  /// The greatest of a function that is at most values[k] where vertex k is nearest: the greatest Σ a_k values[k] with
  /// 0 <= a_k <= the area of a disk, and all of them together the area of the surface.
  [[nodiscard]] double integral(std::vector<double> values) const {
    std::sort(values.begin(), values.end(), std::greater<>());
    const double disk = 2 * std::numbers::pi * (std::cosh(epsilon_) - 1);
    double left = 4 * std::numbers::pi * (genus_ - 1);
    double sum = 0;
    for (const double value : values) {
      sum += std::min(left, disk) * value;
      left -= std::min(left, disk);
    }
    return sum;
  }
  [[nodiscard]] std::size_t order() const { return order_; }

 private:
  [[nodiscard]] std::array<double, 2> coefficient(std::size_t i, std::size_t vertex, std::size_t m) const {
    const double* own = row_.functions[i].data() + vertex * each_;
    return m == 0 ? std::array{own[0], 0.0} : std::array{own[2 * m - 1], own[2 * m]};
  }
  [[nodiscard]] double total(std::size_t i, std::size_t vertex) const {
    double sum = 0;
    for (std::size_t m = 0; m <= order_; ++m)
      sum += std::hypot(coefficient(i, vertex, m)[0], coefficient(i, vertex, m)[1]);
    return sum;
  }

  const Document::Eigenfunctions& row_;
  double epsilon_;
  double genus_;
  const NearOfAll& near_;
  std::size_t each_;
  std::size_t order_;
};

/// Lemma 37.2 on squares with a twentieth of the radius of the disk for sides, in the disk and `margin` sides around
/// it.
certify::PartitionBounds partition_by_squares(const std::vector<Complexd>& lifts, double epsilon, double radius,
                                              double margin) {
  const double edge = std::tanh(epsilon / 2);
  const double side = edge / 20;
  const double beta = std::cosh(radius) - 1;
  // Half of a diagonal, where lengths are greatest.
  const double rho = side / std::sqrt(2.0) * 2 / (1 - (edge + side) * (edge + side));
  certify::PartitionBounds result;
  for (int i = -22; i <= 22; ++i) {
    for (int j = -22; j <= 22; ++j) {
      const Complexd centre(i * side, j * side);
      if (std::abs(centre) > edge + margin * side) continue;
      double b = 0;                 // B at least,
      double slopes = 0;            // and at most: s,
      double changes = 0;           // Σ |Δh²|,
      std::array<double, 2> sum{};  // between which Σ Δh² is,
      Complexd vector = 0;          // and Σ h∇C at the centre,
      double beside = 0;            // from which it is nowhere farther.
      for (const Complexd& lift : lifts) {
        const Complexd z = (lift - centre) / (1.0 - std::conj(centre) * lift);
        const double d = 2 * std::atanh(std::abs(z));
        const double by = rho * std::sinh(d + rho);
        const double turned = rho * std::cosh(d + rho);
        const auto h = [&](double cosh) { return std::max(0.0, 1 - (cosh - 1) / beta); };
        const double most = 1 - (std::cosh(d) - by - 1) / beta;
        if (most <= 0) continue;
        const double least = h(std::cosh(d) + by);
        const double steepest = std::sinh(d) + turned;
        const double flattest = std::max(0.0, std::sinh(d) - turned);
        b += least * least;
        slopes += 2 * most * steepest / beta;
        double low = 2 * std::pow(flattest / beta, 2) - 4 * most * std::cosh(d + rho) / beta;
        double high = 2 * std::pow(steepest / beta, 2) - 4 * least * std::max(1.0, std::cosh(d) - by) / beta;
        if (least == 0) {
          low = std::min(low, 0.0);
          high = std::max(high, 0.0);
        }
        changes += std::max(std::abs(low), std::abs(high));
        sum[0] += low;
        sum[1] += high;
        vector += h(std::cosh(d)) * std::sinh(d) * (z == 0.0 ? Complexd(0) : z / std::abs(z));
        beside += (most - least) * steepest + h(std::cosh(d)) * turned;
      }
      const double slope = 2 * (std::abs(vector) + beside) / beta;  // |∇B|
      const double change = std::max(std::abs(sum[0]), std::abs(sum[1]));
      result.gradients = std::max(result.gradients, (slopes + slope) / b);
      result.laplacians =
          std::max(result.laplacians, (changes + change) / b + (2 * slopes * slope + 2 * slope * slope) / (b * b));
    }
  }
  return result;
}

/// A document with its lifts, and what both checkers say of rows of functions.
struct Functions {
  static constexpr slong kBits = 128;

  explicit Functions(const std::string& name) : document(file(name)), labels(labels_of(document.net, kBits)) {
    const Precision scope(kBits);
    epsilon = certify::decimal(document.net.epsilon).get_d();
    const Ball reach =
        Ball::exactly(document.eigenfunctions[0].radius) + Ball::rounded(certify::decimal(document.net.epsilon));
    lifts = certify::near_vertices(document.net, labels, reach, {}, 1).value();
    near = near_of(lifts);
  }
  /// What the first checker proves, and the second one with all lifts or the first few of each vertex. They differ in
  /// the squares that they take at the edge of a disk.
  [[nodiscard]] double reference(const Document::Eigenfunctions& row) const {
    return reference(row, near, std::sqrt(0.5));
  }
  [[nodiscard]] double second_reference(const Document::Eigenfunctions& row, std::size_t most = 1000) const {
    NearOfAll few = near;
    for (auto& around : few) around.resize(std::min(around.size(), most), Near{});
    return reference(row, few, 1);
  }
  [[nodiscard]] double reference(const Document::Eigenfunctions& row, const NearOfAll& lifts_of, double margin,
                                 std::uint64_t genus = 2) const {
    std::vector<certify::PartitionBounds> bounds;
    for (const auto& around : lifts_of)
      bounds.push_back(partition_by_squares(places(around), epsilon, row.radius, margin));
    return Reference(row, epsilon, static_cast<double>(genus), lifts_of).error(bounds);
  }
  /// Of the lifts, and of the vertex itself.
  [[nodiscard]] static std::vector<Complexd> places(const std::vector<Near>& around) {
    std::vector<Complexd> result{0};
    for (const Near& lift : around) result.push_back(lift.b / std::conj(lift.a));
    return result;
  }
  [[nodiscard]] double first(const Document::Eigenfunctions& row, std::uint64_t genus = 2) const {
    const Precision scope(kBits);
    const auto order = static_cast<std::uint32_t>(row.functions[0].size() / document.net.vertices.size() / 2);
    const auto overlaps = certify::Overlaps::make(document.net, labels, row.radius, order, row.lambda, {}, 1);
    return certify::eigenvalue_error(overlaps.value(), row, genus, {}, 1).value_or(std::nan(""));
  }
  [[nodiscard]] double second(const Document::Eigenfunctions& row, std::size_t most = 1000,
                              std::uint64_t genus = 2) const {
    NearLifts same;
    const auto exact = [](const certify::ComplexBall& z) {
      const auto part = [](const Ball& x) {
        certify::Integer mantissa;
        certify::Integer exponent;
        arf_get_fmpz_2exp(mantissa.get(), exponent.get(), arb_midref(x.get()));
        return Interval(mantissa.value(), mantissa.value(), -exponent.value().get_si());
      };
      return Complex<Interval>{part(certify::real(z)), part(certify::imaginary(z))};
    };
    for (const auto& around : lifts) {
      same.emplace_back();
      for (const auto& lift : around) {
        if (same.back().size() == most) break;
        same.back().push_back({lift.vertex, Motion{exact(lift.isometry.a), exact(lift.isometry.b)}});
      }
    }
    EigenvaluesDocument::Eigenfunctions other{{row.in.lower, row.in.upper}, row.lambda, row.radius, {}};
    for (const auto& function : row.functions) other.functions.emplace_back(function.begin(), function.end());
    try {
      const auto minus_euler = static_cast<long>(2 * genus - 2);
      return eigenvalue_error(other, certify::decimal(document.net.epsilon), same, minus_euler).upper();
    } catch (const TooLarge&) {
      return HUGE_VAL;
    }
  }

  Document document;
  std::vector<certify::BallIsometry> labels;
  double epsilon;
  std::vector<std::vector<certify::NearVertex>> lifts;
  NearOfAll near;
};

TEST(Eigenfunctions, OfOneEigenvalueAreAsWrongAsTheLemmasSay) {
  const Functions functions("octagon-5-with-a-function");
  Document::Eigenfunctions row = functions.document.eigenfunctions[0];
  const double wanted = functions.reference(row);
  EXPECT_GT(wanted, 1e-4);
  EXPECT_LT(wanted, 0.02);
  EXPECT_NEAR(functions.first(row) / wanted, 1, 1e-5);
  EXPECT_NEAR(functions.second(row) / functions.second_reference(row), 1, 1e-5);
}

/// The bounds around the vertices are integrated over 4π(g − 1): half of nine disks count for genus 2, all of them
/// for 3.
TEST(SlowEigenfunctions, OfTheSecondCheckerAreAsWrongAsTheAreaIsLarge) {
  const Functions functions("octagon-5-with-a-function");
  const Document::Eigenfunctions& row = functions.document.eigenfunctions[0];
  for (const std::uint64_t genus : {3U, 4U}) {
    const double wanted = functions.reference(row, functions.near, 1, genus);
    EXPECT_NEAR(functions.second(row, 1000, genus) / wanted, 1, 1e-5) << genus;
  }
}

/// Lemma 37.6 has no unit: δ is that of the functions times any factor, also where squares of bounds are no numbers of
/// binary64. (The greatest squares come first, whatever their size: I of Lemma 37.3.)
TEST(SlowEigenfunctions, AreAsWrongTimesAnyFactor) {
  const Functions functions("octagon-5-with-a-function");
  const Document::Eigenfunctions& row = functions.document.eigenfunctions[0];
  const double wanted = functions.second(row);
  for (const int power : {600, -600}) {
    Document::Eigenfunctions other = row;
    for (double& c : other.functions[0]) c = std::ldexp(c, power);
    EXPECT_NEAR(functions.second(other) / wanted, 1, 1e-9) << power;
  }
}

/// I of Lemma 37.3, exactly: of the corners of {0 <= a_k <= disk, Σ a_k <= area}, which have one a_k between 0 and the
/// area of a disk at most.
mpq_class greatest_by_corners(const std::vector<double>& values, const mpq_class& disk, const mpq_class& area) {
  mpq_class greatest = 0;
  for (std::size_t full = 0; full < (std::size_t{1} << values.size()); ++full) {
    mpq_class sum = 0;
    mpq_class left = area;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if ((full >> k & 1) == 0) continue;
      sum += disk * mpq_class(values[k]);
      left -= disk;
    }
    if (left < 0) continue;
    greatest = std::max(greatest, sum);
    const mpq_class rest = std::min(left, disk);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if ((full >> k & 1) == 0) greatest = std::max(greatest, mpq_class(sum + rest * mpq_class(values[k])));
    }
  }
  return greatest;
}

RC_GTEST_PROP(Integrals, AreTheGreatestOfAllPartsOfTheArea, ()) {
  const auto number = [](int most) { return *rc::gen::inRange(0, 1 << 30) * std::ldexp(1.0, most - 30); };
  std::vector<double> values(static_cast<std::size_t>(*rc::gen::inRange(1, 8)));
  for (double& value : values) value = *rc::gen::inRange(0, 4) == 0 ? 0 : number(3);
  const double disk = number(1) + 0.1;
  const double area = number(4) + 0.1;
  const mpq_class wanted = greatest_by_corners(values, disk, area);
  const mpq_class found(certify::greatest_integral(values, disk, area));
  RC_ASSERT(found >= wanted);
  RC_ASSERT(found <= wanted * mpq_class(1 + 0x1p-25));
}

/// Number k is the vertex that was number order[k].
Document with_vertices_in_order(Document document, const std::vector<std::uint32_t>& order) {
  const Document given = document;
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    document.net.vertices[k] = given.net.vertices[order[k]];
  }
  for (auto& triangle : document.net.triangles) {
    for (std::uint32_t& vertex : triangle.vertex) vertex = place[vertex];
  }
  for (auto& row : document.eigenfunctions) {
    for (Document::Coefficients& function : row.functions) {
      const Document::Coefficients old = function;
      const std::size_t each = old.size() / order.size();
      for (std::size_t i = 0; i < old.size(); ++i) function[i] = old[order[i / each] * each + i % each];
    }
  }
  return document;
}

/// δ is the same whichever vertex and whichever triangle is the first one.
TEST(SlowEigenfunctions, AreAsWrongInOtherNumbers) {
  Functions functions("octagon-5-with-a-function");
  const Document given = functions.document;
  const double wanted = functions.first(given.eigenfunctions[0]);
  std::vector<std::uint32_t> order(given.net.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  for (std::uint32_t shift = 0; shift < order.size(); ++shift) {
    functions.document = with_vertices_in_order(given, order);
    functions.document.net = with_first_triangle(functions.document.net, 5 * shift % 22);
    EXPECT_NEAR(functions.first(functions.document.eigenfunctions[0]) / wanted, 1, 1e-6) << shift;
    std::rotate(order.begin(), order.begin() + 1, order.end());
  }
}

/// The last two vertices meet once, and their functions differ more than others do.
TEST(SlowEigenfunctions, AreAsWrongAsTheLastTwoVerticesSay) {
  Functions functions("octagon-5-with-a-function");
  const auto count = static_cast<std::uint32_t>(functions.near.size());
  const auto meetings = [&](std::uint32_t v, std::uint32_t w) {
    return std::count_if(functions.near[v].begin(), functions.near[v].end(),
                         [&](const Near& lift) { return lift.vertex == w; });
  };
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  bool found = false;
  for (std::uint32_t v = 0; v < count && !found; ++v) {
    for (std::uint32_t w = 0; w < count && !found; ++w) {
      if (w == v || meetings(v, w) != 1 || meetings(w, w) != 0) continue;
      found = true;
      std::erase_if(order, [&](std::uint32_t x) { return x == v || x == w; });
      order.push_back(v);
      order.push_back(w);
    }
  }
  ASSERT_TRUE(found);
  functions.document = with_vertices_in_order(functions.document, order);
  const Precision scope(Functions::kBits);
  functions.lifts = certify::near_vertices(functions.document.net, functions.labels, Ball::exactly(1.9), {}, 1).value();
  functions.near = near_of(functions.lifts);
  Document::Eigenfunctions row = functions.document.eigenfunctions[0];
  const std::size_t each = row.functions[0].size() / count;
  row.functions[0][(count - 2) * each] += 1e-5;
  // So large a genus that the bounds around all vertices count.
  constexpr std::uint64_t kGenus = 4;
  const double wanted = functions.reference(row, functions.near, std::sqrt(0.5), kGenus);
  EXPECT_GT(wanted, 0.1);
  EXPECT_LT(wanted, 1);
  EXPECT_NEAR(functions.first(row, kGenus) / wanted, 1, 1e-5);
}

TEST(SlowSecondCheckersEigenfunctions, ThatProveLessAreUndecided) {
  const Functions functions("octagon-5-with-a-function");
  const double error = functions.second(functions.document.eigenfunctions[0]);
  const auto outcome = [&](double below, double above) {
    Document document = functions.document;
    auto& row = document.eigenfunctions[0];
    row.in = {row.lambda - below, row.lambda + above};
    document.eigenvalues[0].in = row.in;
    const Result result = check(text(document));
    return result.verdict == Verdict::verified ? "VERIFIED" : result.rule;
  };
  const double more = error * (1 + 1e-9);
  const double less = error * (1 - 1e-9);
  EXPECT_EQ(outcome(more, more), "VERIFIED");
  EXPECT_EQ(outcome(less, more), "eigenfunctions");
  EXPECT_EQ(outcome(more, less), "eigenfunctions");
}

/// A row that proves nothing of its interval is seen beside one that proves its own, whichever comes first. No
/// eigenvalue is in [2.2, 2.3] or [3.2, 3.3]: they are 2.775… and 3.706….
TEST(SlowSecondCheckersEigenfunctions, EachRowIsAsked) {
  const Document given = file("octagon-5-with-a-function");
  const Document::Eigenfunctions& good = given.eigenfunctions[0];
  for (const bool first : {false, true}) {
    for (const bool few : {false, true}) {
      Document::Eigenfunctions other = good;
      other.lambda = first ? 2.25 : 3.25;
      other.in = {other.lambda - 0.05, other.lambda + 0.05};
      if (few) other.functions = {Document::Coefficients(27, 1)};
      Document document = given;
      document.eigenfunctions = {first ? other : good, first ? good : other};
      const Result result = check(text(document));
      EXPECT_EQ(result.verdict, Verdict::undecided) << first << ' ' << few;
      EXPECT_EQ(result.rule, "eigenfunctions") << first << ' ' << few;
    }
  }
}

TEST(Eigenfunctions, OfSeveralEigenvaluesAreAsWrongAsTheLemmasSay) {
  const Functions functions("bolza-with-three-functions");
  const Document::Eigenfunctions row = functions.document.eigenfunctions[0];
  ASSERT_EQ(row.functions.size(), 3U);
  const double of_three = functions.reference(row);
  EXPECT_LT(of_three, 0.05);
  EXPECT_NEAR(functions.first(row) / of_three, 1, 1e-5);
  constexpr double kWrong = 0.01;
  // Two that are nearly one: δ grows.
  Document::Eigenfunctions nearly = row;
  nearly.functions.pop_back();
  const double of_two = functions.reference(nearly);
  for (std::size_t i = 0; i < nearly.functions[0].size(); ++i)
    nearly.functions[1][i] = -0.8 * row.functions[0][i] + 0.6 * row.functions[1][i];
  const double dependent = functions.reference(nearly);
  EXPECT_GT(dependent, 2 * of_two);
  EXPECT_NEAR(functions.first(nearly) / dependent, 1, 1e-5);
  // Both so wrong that the norm is smaller for it.
  for (std::size_t i = 0; i < 2; ++i) nearly.functions[i][0] += kWrong;
  const double wrong = functions.second_reference(nearly);
  EXPECT_GT(wrong, 10);
  ASSERT_LT(wrong, HUGE_VAL);
  EXPECT_NEAR(functions.second(nearly) / wrong, 1, 1e-5);
  EXPECT_NEAR(functions.first(nearly) / functions.reference(nearly), 1, 1e-4);
  std::swap(nearly.functions[0], nearly.functions[1]);
  EXPECT_NEAR(functions.first(nearly) / functions.reference(nearly), 1, 1e-4);
  std::swap(nearly.functions[0], nearly.functions[1]);
  // One twice, with another factor, is one.
  for (std::size_t i = 0; i < nearly.functions[0].size(); ++i) nearly.functions[1][i] = -0.5 * row.functions[0][i];
  EXPECT_EQ(functions.second_reference(nearly, 0), HUGE_VAL);
  EXPECT_FALSE(functions.first(nearly) < HUGE_VAL);
  EXPECT_EQ(functions.second(nearly, 0), HUGE_VAL);
}

/// Sums of |Δψ_q| and |∇ψ_q| over all lifts at a point, by the formulas of the proof of Lemma 37.2; and the sums of the
/// absolute values of their terms.
struct Sums {
  certify::PartitionBounds sums;
  certify::PartitionBounds terms;

  void include(const Sums& other) {
    for (const auto part : {&Sums::sums, &Sums::terms}) {
      (this->*part).laplacians = std::max((this->*part).laplacians, (other.*part).laplacians);
      (this->*part).gradients = std::max((this->*part).gradients, (other.*part).gradients);
    }
  }
};
Sums partition_at(const std::vector<Complexd>& lifts, double radius, Complexd x) {
  const double beta = std::cosh(radius) - 1;
  struct Term {
    double square;
    Complexd gradient;
    double laplacian;
  };
  std::vector<Term> terms;
  double sum = 0;
  Complexd gradient = 0;
  double laplacian = 0;
  for (const Complexd& lift : lifts) {
    const Complexd z = (lift - x) / (1.0 - std::conj(x) * lift);
    const double cosh = (1 + std::norm(z)) / (1 - std::norm(z));
    const double h = 1 - (cosh - 1) / beta;
    if (h <= 0) continue;
    const Complexd slope = 2.0 * z / (1 - std::norm(z)) / beta;  // Of h, towards the lift.
    terms.push_back({h * h, 2 * h * slope, 2 * std::norm(slope) - 2 * h * 2 * cosh / beta});
    sum += terms.back().square;
    gradient += terms.back().gradient;
    laplacian += terms.back().laplacian;
  }
  Sums result;
  double laplacians = 0;
  double gradients = 0;
  for (const Term& term : terms) {
    const Complexd of_psi = term.gradient / sum - term.square * gradient / (sum * sum);
    const double product = (term.gradient * std::conj(gradient)).real();
    result.sums.gradients += std::abs(of_psi);
    result.sums.laplacians +=
        std::abs(term.laplacian / sum - 2 * product / (sum * sum) - term.square * laplacian / (sum * sum) +
                 2 * term.square * std::norm(gradient) / (sum * sum * sum));
    laplacians += std::abs(term.laplacian);
    gradients += std::abs(term.gradient);
  }
  const double steepness = std::abs(gradient);
  result.terms.gradients = (gradients + steepness) / sum;
  result.terms.laplacians =
      (laplacians + std::abs(laplacian)) / sum + (2 * gradients * steepness + 2 * steepness * steepness) / (sum * sum);
  return result;
}

/// The greatest sums at random points within ε of 0.
Sums sampled(const std::vector<Complexd>& lifts, double epsilon, double radius, std::mt19937& random) {
  Sums greatest;
  for (int i = 0; i < 2000; ++i) {
    const double rho = epsilon * std::sqrt(static_cast<double>(random() % 1001) / 1000);
    const Complexd x = std::polar(std::tanh(rho / 2), static_cast<double>(random() % 1000) * 0.00628319);
    greatest.include(partition_at(lifts, radius, x));
  }
  return greatest;
}

/// The first checker's bounds for the partition of unity, beside what they bound. Those of the second one are in δ.
TEST(Partitions, OfUnityAreNoSteeperThanTheBoundsSay) {
  std::mt19937 random(2);  // NOLINT: the same in every run.
  for (const char* name : {"octagon-5-with-a-function", "bolza-with-three-functions"}) {
    const Functions functions(name);
    const auto& row = functions.document.eigenfunctions[0];
    for (std::size_t k = 0; k < functions.near.size(); k += 2) {
      const auto places = Functions::places(functions.near[k]);
      const certify::PartitionBounds bounds = certify::partition_bounds(places, functions.epsilon, row.radius);
      const Sums greatest = sampled(places, functions.epsilon, row.radius, random);
      EXPECT_LE(greatest.sums.laplacians, bounds.laplacians) << name << ' ' << k;
      EXPECT_LE(greatest.sums.gradients, bounds.gradients) << name << ' ' << k;
    }
  }
}

/// ε and R.
constexpr std::array<std::array<double, 2>, 3> kDisks{{{0.1, 0.5}, {0.5, 0.9}, {0.1, 1.5}}};

/// 0, and others not near that.
std::vector<Complexd> random_lifts(std::size_t count, double within, std::mt19937& random) {
  std::vector<Complexd> lifts{0};
  while (lifts.size() < count) {
    const double rho = 0.2 + (within - 0.2) * std::sqrt(static_cast<double>(random() % 1000) / 1000);
    lifts.push_back(std::polar(std::tanh(rho / 2), static_cast<double>(random() % 1000) * 0.00628319));
  }
  return lifts;
}

/// Lifts anywhere: the sums of the terms are nearly reached, as cells are small.
TEST(Partitions, OfUnityAreNearlyAsSteepAsTheBoundsSay) {
  std::mt19937 random(3);  // NOLINT: the same in every run.
  for (const std::size_t count : {1U, 2U, 5U, 12U, 40U}) {
    for (const auto& [epsilon, radius] : kDisks) {
      const std::vector<Complexd> lifts = random_lifts(count, epsilon + radius, random);
      const certify::PartitionBounds bounds = certify::partition_bounds(lifts, epsilon, radius);
      const certify::PartitionBounds by_squares = partition_by_squares(lifts, epsilon, radius, std::sqrt(0.5));
      EXPECT_NEAR(bounds.laplacians / by_squares.laplacians, 1, 1e-5) << count << ' ' << epsilon << ' ' << radius;
      EXPECT_NEAR(bounds.gradients / by_squares.gradients, 1, 1e-5) << count << ' ' << epsilon << ' ' << radius;
      // A millionth is for rounding.
      EXPECT_GE(bounds.laplacians, by_squares.laplacians * (1 + 0.99e-6)) << count << ' ' << epsilon << ' ' << radius;
      EXPECT_GE(bounds.gradients, by_squares.gradients * (1 + 0.99e-6)) << count << ' ' << epsilon << ' ' << radius;
      const Sums greatest = sampled(lifts, epsilon, radius, random);
      EXPECT_LE(greatest.terms.laplacians, bounds.laplacians) << count << ' ' << epsilon << ' ' << radius;
      EXPECT_LE(greatest.terms.gradients, bounds.gradients) << count << ' ' << epsilon << ' ' << radius;
      EXPECT_GE(greatest.terms.laplacians, bounds.laplacians / (epsilon < 0.2 ? 1.5 : 2.5))
          << count << ' ' << epsilon << ' ' << radius;
      EXPECT_GE(greatest.terms.gradients, bounds.gradients / 1.7) << count << ' ' << epsilon << ' ' << radius;
    }
  }
}

/// The second checker is given lifts anywhere of one vertex, whose function hardly changes; so all that is of the
/// partition is in δ.
TEST(Partitions, OfUnityAreThoseOfTheSecondChecker) {
  std::mt19937 random(4);  // NOLINT: the same in every run.
  for (const std::size_t count : {2U, 12U, 24U}) {
    for (const auto& [epsilon, radius] : kDisks) {
      const std::vector<Complexd> lifts = random_lifts(count, epsilon + radius, random);
      NearOfAll near(1);
      NearLifts same(1);
      for (std::size_t i = 1; i < lifts.size(); ++i) {
        const double a = 1 / std::sqrt(1 - std::norm(lifts[i]));
        near[0].push_back({0, a, a * lifts[i]});
        const Interval x = interval(lifts[i].real());
        const Interval y = interval(lifts[i].imag());
        const Interval scale = 1 / sqrt(1 - square(x) - square(y));
        same[0].push_back({0, Motion{{scale, 0}, {scale * x, scale * y}}});
      }
      constexpr std::size_t kOrder = 12;
      Document::Eigenfunctions row{{0.5, 1.5}, 0x1p-10, radius, {Document::Coefficients(2 * kOrder + 1)}};
      row.functions[0][0] = 1;
      EigenvaluesDocument::Eigenfunctions other{{mpq_class(1, 2), 2}, mpq_class(1, 1024), radius, {}};
      other.functions.emplace_back(row.functions[0].begin(), row.functions[0].end());
      const double wanted = Reference(row, epsilon, 2, near).error({partition_by_squares(lifts, epsilon, radius, 1)});
      ASSERT_LT(wanted, HUGE_VAL) << count << ' ' << epsilon << ' ' << radius;
      const double found = eigenvalue_error(other, mpq_class(epsilon), same, 2).upper();
      EXPECT_NEAR(found / wanted, 1, 1e-5) << count << ' ' << epsilon << ' ' << radius;
      // A millionth is for rounding, and δ is a linear function of the bounds.
      EXPECT_GE(found, wanted * (1 + 0.99e-6)) << count << ' ' << epsilon << ' ' << radius;
    }
  }
}

/// On disks so large that F_0 is negative at their boundary: a radial function around one vertex, and the same function
/// around another one, with an error.
TEST(Eigenfunctions, OnDisksBeyondAZeroOfARadialFunctionAreAsWrongAsTheLemmasSay) {
  constexpr double kEpsilon = 0.5;
  constexpr double kRadius = 0.9;
  constexpr std::size_t kOrder = 24;
  constexpr std::size_t kEach = 2 * kOrder + 1;
  const double place = 0.25;  // Of the other vertex.
  const double a = 1 / std::sqrt(1 - place * place);
  const NearOfAll near{{{1, a, a * place}}, {{0, a, -a * place}}};
  Document::Eigenfunctions row{{29, 31}, 30, kRadius, {Document::Coefficients(2 * kEach)}};
  row.functions[0][0] = 1;
  const Reference functions(row, kEpsilon, 2, near);
  // Its waves around the other vertex, from values on a circle.
  constexpr std::size_t kPoints = 64;
  const double t = std::tanh(0.4);
  for (std::size_t m = 0; m <= kOrder; ++m) {
    double sum = 0;
    for (std::size_t k = 0; k < kPoints; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kPoints;
      const Complexd z = std::polar(t, angle);
      sum += functions.functions(0, (z + place) / (1.0 + place * z))[0] * std::cos(static_cast<double>(m) * angle);
    }
    const double wave = (m == 0 ? 1 : 2) * sum / kPoints / (std::pow(t, m) * functions.factor(m, t * t));
    row.functions[0][kEach + (m == 0 ? 0 : 2 * m - 1)] = wave;
  }
  row.functions[0][kEach] += 1e-3;
  const double cosh_disk = (std::cosh(kEpsilon) + std::cosh(kRadius)) / (2 * a);
  ASSERT_LT(functions.factor(0, (cosh_disk - 1) / (cosh_disk + 1)), -0.1);

  NearLifts same;
  for (const auto& lifts : near) {
    const Interval z = interval(lifts[0].b.real() < 0 ? -place : place);
    const Interval scale = 1 / sqrt(1 - square(z));
    same.push_back({{lifts[0].vertex, Motion{{scale, 0}, {scale * z, 0}}}});
  }
  EigenvaluesDocument::Eigenfunctions other{{29, 31}, 30, mpq_class(kRadius), {}};
  other.functions.emplace_back(row.functions[0].begin(), row.functions[0].end());
  const double wanted = Reference(row, kEpsilon, 2, near)
                            .error({partition_by_squares(Functions::places(near[0]), kEpsilon, kRadius, 1),
                                    partition_by_squares(Functions::places(near[1]), kEpsilon, kRadius, 1)});
  ASSERT_LT(wanted, HUGE_VAL);
  EXPECT_NEAR(eigenvalue_error(other, mpq_class(kEpsilon), same, 2).upper() / wanted, 1, 1e-5);
}

/// What the second checker says of a function of two lifts of one vertex, with so many waves, or why it gives up.
std::string given_up(double lambda, double radius, std::size_t order, const Interval& place) {
  const Interval scale = 1 / sqrt(1 - square(place));
  const NearLifts near{{{0, Motion{{scale, 0}, {scale * place, 0}}}}};
  EigenvaluesDocument::Eigenfunctions row{{mpq_class(1, 2), 2}, mpq_class(lambda), mpq_class(radius), {}};
  row.functions.emplace_back(2 * order + 1);
  row.functions[0][0] = 1;
  try {
    static_cast<void>(eigenvalue_error(row, mpq_class(0.5), near, 2));
  } catch (const TooLarge& problem) {
    return problem.what;
  }
  return "";
}

/// 2F1 as FLINT has it, to more bits than intervals have: F_m(s).
Interval radial_factor(double lambda, slong m, double s) {
  constexpr slong kBits = Interval::kBits + 150;
  acb_t a, b, c, x, r, value;
  for (acb_ptr z : {a, b, c, x, r, value}) acb_init(z);
  acb_set_d(r, 0.25 - lambda);  // (ir)²
  acb_sqrt(r, r, kBits);
  acb_set_d(c, 0.5);
  acb_sub(a, c, r, kBits);
  acb_add(b, c, r, kBits);
  acb_set_si(c, m + 1);
  acb_set_d(x, s);
  acb_sub_si(x, x, 1, kBits);
  acb_set_d(value, s);
  acb_div(x, value, x, kBits);  // −s/(1 − s)
  acb_hypgeom_2f1(value, a, b, c, x, 0, kBits);
  EXPECT_GT(arb_rel_accuracy_bits(acb_realref(value)), Interval::kBits + 30);
  certify::Integer mantissa;
  certify::Integer exponent;
  arf_get_fmpz_2exp(mantissa.get(), exponent.get(), arb_midref(acb_realref(value)));
  for (acb_ptr z : {a, b, c, x, r, value}) acb_clear(z);
  return {mantissa.value(), mantissa.value(), -exponent.value().get_si()};
}

/// Lemma 37.1 (a): all factors are enclosed, also where the series are cut off early; and nearly to the bits used where
/// they converge fast.
TEST(SecondCheckersRadialFactors, AreEnclosed) {
  for (const double lambda : {0.0625, 0.25, 1.5, 30.0, 900.0}) {
    for (const long order : {1L, 2L, 7L, 24L}) {
      const RadialFactors factors(interval(lambda), order);
      for (const double s : {0x1p-10, 0.125, 0.375, 0.4990234375, 0.5}) {
        const std::vector<Interval> found = factors(interval(s));
        ASSERT_EQ(found.size(), static_cast<std::size_t>(order) + 1);
        for (long m = 0; m <= order; ++m) {
          const Interval& factor = found[static_cast<std::size_t>(m)];
          const Interval wanted = radial_factor(lambda, m, s);
          EXPECT_TRUE(is_less(factor, wanted) == Answer::unknown && is_less(wanted, factor) == Answer::unknown)
              << lambda << ' ' << order << ' ' << s << ' ' << m << ": " << middle(factor) << ", " << middle(wanted);
          if (s < 0.2 && lambda < 100) {
            EXPECT_LT((factor - wanted).upper(), 1e-35);
          }
        }
      }
    }
  }
}

/// From (i + 1)(m + 1) >= λ on, terms decrease; a series has 500 of them before the rest if x = 1 and m is small.
TEST(SecondCheckersRadialFactors, AreGivenUpIfTermsMayIncreaseWhereTheSeriesEnd) {
  EXPECT_NO_THROW(RadialFactors(interval(1001), 1));
  EXPECT_THROW(RadialFactors(interval(1003), 1), TooLarge);
  EXPECT_THROW(RadialFactors(hull(interval(1000), interval(1003)), 1), TooLarge);
  EXPECT_NO_THROW(RadialFactors(interval(1502), 2));
  EXPECT_THROW(RadialFactors(interval(1504), 2), TooLarge);
  const RadialFactors factors(interval(1), 3);
  EXPECT_NO_THROW(static_cast<void>(factors(interval(0.5))));
  EXPECT_THROW(static_cast<void>(factors(interval(0.5 + 0x1p-50))), TooLarge);
  EXPECT_THROW(static_cast<void>(factors(hull(interval(0.25), interval(0.5 + 0x1p-50)))), TooLarge);
}

TEST(SecondChecker, GivesUpFunctionsThatItsLemmasAreNotFor) {
  const Interval place = interval(0.25);
  EXPECT_EQ(given_up(0x1p-10, 0.9, 12, place), "");
  // Lifts whose places are not known.
  const Interval wide = hull(place, place + interval(0x1p-40));
  EXPECT_EQ(given_up(0x1p-10, 0.9, 12, wide), "lifts are not known well enough");
  const Interval known = hull(place, place + interval(0x1p-50));
  EXPECT_EQ(given_up(0x1p-10, 0.9, 12, known), "");
  // Disks that are too large for so few waves: z of Lemma 37.4 is not less than 1.
  EXPECT_EQ(given_up(9, 0.9, 1, place), "a disk is too large");
  EXPECT_EQ(given_up(0x1p-10, 0.9, 1, place), "a sum of functions may be 0");
  // Points with |z|² beyond ½.
  EXPECT_EQ(given_up(0x1p-10, 2.5, 60, place), "a function is asked for too far from its vertex");
}

/// A bound that is not known counts, whichever vertex it belongs to: on the circle of Lemma 37.4 F_0 may be 0, so that
/// nothing follows for the lifts of the last vertex. The other vertices, whose functions are 0, have disks enough for
/// all of the area.
TEST(SecondChecker, GivesUpFunctionsWhereARadialFactorMayBeZero) {
  constexpr double kLambda = 12;
  constexpr double kEpsilon = 0.9;
  constexpr double kRadius = 1.2;
  constexpr std::size_t kOrder = 24;
  constexpr std::size_t kEach = 2 * kOrder + 1;
  constexpr std::size_t kVertices = 6;
  const RadialFactors factors(interval(kLambda), kOrder);
  const auto factor_at_circle = [&](double place) {
    const double cosh_disk = (std::cosh(kEpsilon) + std::cosh(kRadius)) / 2 * std::sqrt(1 - place * place);
    return middle(factors(interval((cosh_disk - 1) / (cosh_disk + 1)))[0]);
  };
  double low = 0.4;
  double high = 0.7;
  ASSERT_LT(factor_at_circle(low), 0);
  ASSERT_GT(factor_at_circle(high), 0);
  for (int i = 0; i < 60; ++i) {
    const double place = (low + high) / 2;
    (factor_at_circle(place) < 0 ? low : high) = place;
  }
  NearLifts near;
  for (Index vertex = 0; vertex < kVertices; ++vertex) {
    const bool last = vertex + 1 == kVertices;
    const Interval place = last ? hull(interval(low - 0x1p-48), interval(low + 0x1p-48)) : interval(0.25);
    const Interval scale = 1 / sqrt(1 - square(place));
    near.push_back({{vertex, Motion{{scale, 0}, {scale * place, 0}}}});
  }
  EigenvaluesDocument::Eigenfunctions row{{mpq_class(11), 13}, mpq_class(kLambda), mpq_class(kRadius), {}};
  row.functions.emplace_back(kVertices * kEach);
  row.functions[0][(kVertices - 1) * kEach] = 1;
  EXPECT_THROW(static_cast<void>(eigenvalue_error(row, mpq_class(kEpsilon), near, 2)), TooLarge);
}

/// One lift alone is 1 where it counts. Lifts that do not cover the disk bound nothing.
TEST(Partitions, OfUnityCoverTheDisk) {
  const auto infinite = [](const certify::PartitionBounds& bounds) {
    return bounds.laplacians == HUGE_VAL && bounds.gradients == HUGE_VAL;
  };
  EXPECT_FALSE(infinite(certify::partition_bounds({0}, 0.5, 0.9)));
  EXPECT_TRUE(infinite(certify::partition_bounds({}, 0.5, 0.9)));
  EXPECT_TRUE(infinite(certify::partition_bounds({std::tanh(0.3)}, 0.5, 0.9)));
}

/// Lemma 37.4 itself: where both functions count, they differ by no more.
TEST(Eigenfunctions, DifferByNoMoreThanTheLemmaSays) {
  const Functions functions("octagon-5-with-a-function");
  const auto& row = functions.document.eigenfunctions[0];
  const Reference reference(row, functions.epsilon, 2, functions.near);
  std::mt19937 random(1);  // NOLINT: the same in every run.
  for (const std::uint32_t k : {0U, 3U}) {
    for (std::size_t i = 0; i < functions.near[k].size(); i += 4) {
      const Near& lift = functions.near[k][i];
      const double bound = reference.mismatch(k, lift)[0].value;
      const double steepest = reference.mismatch(k, lift)[0].gradient;
      const auto difference = [&](Complexd x) {
        const Complexd there = (std::conj(lift.a) * x - lift.b) / (-std::conj(lift.b) * x + lift.a);
        return reference.functions(lift.vertex, there)[0] - reference.functions(k, x)[0];
      };
      double greatest = 0;
      for (int j = 0; j < 60; ++j) {
        const double rho = functions.epsilon * std::sqrt(static_cast<double>(random() % 1000) / 1000);
        const Complexd x = std::polar(std::tanh(rho / 2), static_cast<double>(random() % 1000) * 0.00628);
        const Complexd there = (std::conj(lift.a) * x - lift.b) / (-std::conj(lift.b) * x + lift.a);
        if (2 * std::atanh(std::abs(there)) > row.radius) continue;
        greatest = std::max(greatest, std::abs(difference(x)));
        const double step = 1e-4;
        const double slope = std::abs(difference(x + step) - difference(x)) / step * (1 - std::norm(x)) / 2;
        EXPECT_LE(slope, steepest * 1.01);
      }
      EXPECT_LE(greatest, bound) << k << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace epsnet::exact::second_checker_eigenvalues_test
