#include "netgen/eigenvalues/eigenfunction_values.h"

#include <cmath>
#include <cstdint>

namespace epsnet {
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
