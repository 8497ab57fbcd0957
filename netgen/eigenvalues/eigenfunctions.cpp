#include "netgen/eigenvalues/eigenfunctions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "kernel/plane.h"

namespace epsnet {
namespace {

using Vector = LorentzVector<double>;

/// From a least to a greatest value.
struct Range {
  double least;
  double greatest;
};

/// About the greatest sums at points that are not farther than `reach` from one point.
class SumsNear {
 public:
  SumsNear(double reach, double radius)
      : reach_(reach), cosh_(std::cosh(reach)), sinh_(std::sinh(reach)), beta_(std::cosh(radius) - 1) {}

  [[nodiscard]] PartitionSums operator()(const Vector& x, const std::vector<Vector>& lifts) const {
    double squares = 0;     // Σ h² for h = max(0, 1 − (C − 1)/β) and C = cosh d(x, q), at least.
    double slopes = 0;      // Σ |∇h²|, at most.
    Vector gradient;        // β/2 Σ ∇h² at x,
    double change = 0;      // and how far it may be from there.
    double laplacians = 0;  // Σ |Δh²|, at most.
    Range laplacian{0, 0};  // Σ Δh²
    for (const Vector& q : lifts) {
      const double cosh = std::max(1.0, -lorentz_product(x, q));
      const double sinh = std::sqrt(cosh * cosh - 1);
      // At the distances d ± reach.
      const Range coshs{sinh > sinh_ ? cosh * cosh_ - sinh * sinh_ : 1, cosh * cosh_ + sinh * sinh_};
      const Range sinhs{std::max(0.0, sinh * cosh_ - cosh * sinh_), sinh * cosh_ + cosh * sinh_};
      const double most = height(coshs.least);
      if (most <= 0) continue;
      const double least = height(coshs.greatest);
      const double here = height(cosh);
      squares += least * least;
      slopes += 2 * most * sinhs.greatest / beta_;
      // ∇C is the component of −q in the tangential plane.
      gradient = gradient + here * (q + -cosh * x);
      change += (most - least) * sinhs.greatest + here * reach_ * coshs.greatest;
      // Δh² = 2|∇h|² − 4hC/β, or 0 where h is 0.
      Range range{2 * std::pow(sinhs.least / beta_, 2) - 4 * most * coshs.greatest / beta_,
                  2 * std::pow(sinhs.greatest / beta_, 2) - 4 * least * coshs.least / beta_};
      if (least == 0) range = {std::min(0.0, range.least), std::max(0.0, range.greatest)};
      laplacians += std::max(-range.least, range.greatest);
      laplacian = {laplacian.least + range.least, laplacian.greatest + range.greatest};
    }
    if (squares <= 0) return {HUGE_VAL, HUGE_VAL};
    const double slope = 2 / beta_ * (std::sqrt(std::max(0.0, lorentz_product(gradient, gradient))) + change);
    return {(laplacians + std::max(-laplacian.least, laplacian.greatest)) / squares +
                2 * slope * (slopes + slope) / (squares * squares),
            (slopes + slope) / squares};
  }

 private:
  [[nodiscard]] double height(double cosh) const { return std::max(0.0, 1 - (cosh - 1) / beta_); }

  double reach_;
  double cosh_;
  double sinh_;
  double beta_;
};

}  // namespace

PartitionSums partition_sums(const std::vector<std::complex<double>>& lifts, double epsilon, double radius) {
  constexpr int kRings = 10;
  // The proof has squares with a twentieth of the disk's radius for sides, some of them beyond its boundary.
  const double disk = std::tanh(epsilon / 2);
  const double reach = 0.0708 * disk / (1 - std::pow(1.05 * disk, 2));
  const SumsNear sums_near(reach, radius);
  std::vector<Vector> vectors;
  vectors.reserve(lifts.size());
  for (const std::complex<double>& z : lifts) vectors.push_back(on_hyperboloid<double>({z.real(), z.imag()}));
  PartitionSums result;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double distance = (epsilon + reach) * ring / kRings;
    const int count = std::max(1, 6 * ring);
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * k / count;
      const Vector x{std::sinh(distance) * std::cos(angle), std::sinh(distance) * std::sin(angle), std::cosh(distance)};
      const PartitionSums here = sums_near(x, vectors);
      result.laplacians = std::max(result.laplacians, here.laplacians);
      result.gradients = std::max(result.gradients, here.gradients);
    }
  }
  // Between the points there is a little more.
  constexpr double kBetween = 1.05;
  return {kBetween * result.laplacians, kBetween * result.gradients};
}

namespace {

/// F_m(s) by its series in −s/(1 − s), which converges for s < ½; docs/proof.md, Lemma 37.1.
double factor_by_series(double lambda, double s, std::uint32_t m) {
  constexpr int kMostTerms = 500;
  constexpr double kSmall = 1e-18;
  const double x = s / (1 - s);
  double sum = 1;
  double term = 1;
  for (double i = 0; i < kMostTerms && std::abs(term) > kSmall; ++i) {
    term *= -x * (i * (i + 1) + lambda) / ((m + 1 + i) * (i + 1));
    sum += term;
  }
  return sum;
}

}  // namespace

EigenfunctionValues::EigenfunctionValues(const certify::EigenvaluesDocument& document, std::size_t row,
                                         std::size_t function)
    : lambda_(document.eigenfunctions.at(row).lambda),
      coefficients_(document.eigenfunctions.at(row).functions.at(function)),
      each_(coefficients_.size() / document.net.vertices.size()) {}

double EigenfunctionValues::at(std::size_t vertex, std::complex<double> z) const {
  const double s = std::norm(z);
  const double* const coefficients = coefficients_.data() + vertex * each_;
  const auto order = static_cast<std::uint32_t>(each_ / 2);
  // The factors F_m from the highest m down, and the sum of the terms by Horner's rule: z^m = z · z^(m−1).
  double above = factor_by_series(lambda_, s, order + 1);
  double factor = factor_by_series(lambda_, s, order);
  std::complex<double> sum = 0;
  for (std::uint32_t m = order; m > 0; --m) {
    // Re((α − iβ) z^m) = t^m (α cos mθ + β sin mθ).
    const std::size_t beta = std::size_t{2} * m;
    sum = (sum + factor * std::complex<double>(coefficients[beta - 1], -coefficients[beta])) * z;
    const double below = (1 + s) * factor - s * (1 + lambda_ / (m * (m + 1.0))) * above;
    above = factor;
    factor = below;
  }
  return coefficients[0] * factor + sum.real();
}

}  // namespace epsnet
