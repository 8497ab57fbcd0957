#include "netgen/eigenvalues/eigenfunction.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <thread>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/eigenfunction.h"
#include "certify/claims/eigenvalues/near_vertices.h"
#include "certify/net/label_evaluator.h"
#include "certify/net/surface_check.h"

namespace epsnet {
namespace {

using certify::Ball;
using Vector = std::vector<double>;
using Point = std::complex<double>;
using Eigenfunction = certify::EigenvaluesDocument::Eigenfunction;

constexpr long kBits = 128;

double rounded(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }
Point rounded(const certify::ComplexBall& z) { return {rounded(certify::real(z)), rounded(certify::imaginary(z))}; }

double norm(const Vector& x) { return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0)); }

void normalize(Vector& x) {
  const double scale = 1 / norm(x);
  for (double& value : x) value *= scale;
}

/// F_m(s) by its series.
double radial_factor(double lambda, double s, std::uint32_t m) {
  const double x = s / (1 - s);
  double sum = 1;
  double term = 1;
  for (double i = 0; i < 500 && std::abs(term) > 1e-18; ++i) {
    term *= -x * (i * (i + 1) + lambda) / ((m + 1 + i) * (i + 1));
    sum += term;
  }
  return sum;
}

/// A symmetric positive definite matrix, of which the lower half counts, factored by Cholesky's method.
class Cholesky {
 public:
  /// Nothing if a pivot is not positive.
  static std::optional<Cholesky> of(std::vector<Vector> matrix) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const double rest = matrix[i][j] - dot(matrix[i], matrix[j], j);
        if (j < i) {
          matrix[i][j] = rest / matrix[j][j];
        } else if (rest > 0) {
          matrix[i][i] = std::sqrt(rest);
        } else {
          return std::nullopt;
        }
      }
    }
    return Cholesky(std::move(matrix));
  }

  [[nodiscard]] Vector solve(Vector x) const {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = (x[i] - dot(factor_[i], x, i)) / factor_[i][i];
    for (std::size_t i = x.size(); i-- > 0;) {
      x[i] /= factor_[i][i];
      for (std::size_t j = 0; j < i; ++j) x[j] -= factor_[i][j] * x[i];
    }
    return x;
  }

 private:
  explicit Cholesky(std::vector<Vector> factor) : factor_(std::move(factor)) {}

  /// Of the first entries. Four sums at a time: their order is fixed, and the processor can add them at once.
  static double dot(const Vector& x, const Vector& y, std::size_t count) {
    double sums[4] = {0, 0, 0, 0};
    std::size_t k = 0;
    for (; k + 4 <= count; k += 4) {
      for (std::size_t i = 0; i < 4; ++i) sums[i] += x[k + i] * y[k + i];
    }
    for (; k < count; ++k) sums[0] += x[k] * y[k];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }

  std::vector<Vector> factor_;
};

}  // namespace

EigenfunctionSearch::EigenfunctionSearch(const certify::EigenvaluesDocument& document, unsigned threads,
                                         Progress progress)
    : document_(document),
      threads_(threads != 0 ? threads : std::max(std::thread::hardware_concurrency(), 1U)),
      progress_(std::move(progress)),
      radius_(1.3 * certify::decimal(document.net.epsilon).get_d()),
      scale_(1 / std::tanh(radius_ / 2)),
      order_(76),
      each_(2 * std::size_t{order_} + 1) {
  constexpr std::size_t kGreatestSize = 4000;
  if (size() > kGreatestSize) return;
  const certify::Precision scope(kBits);
  auto surface = certify::check_surface(document.net.surface, threads_);
  genus_ = static_cast<std::uint32_t>(surface.genus);
  const auto parts = certify::label_parts(std::move(surface.crossings), document.net.charts, {});
  std::vector<std::uint32_t> numbers(document.net.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  labels_ = certify::LabelEvaluator(document.net, parts).evaluate(numbers, kBits, 4 * kBits, threads_);
  add_pairs();
}

/// The circles of docs/proof.md, Lemma 37.4.
void EigenfunctionSearch::add_pairs() {
  const double epsilon = certify::decimal(document_.net.epsilon).get_d();
  const Ball distance = Ball::exactly(epsilon) + Ball::exactly(radius_);
  const auto near = certify::near_vertices(document_, labels_, distance, {});
  if (!near) return;
  const std::uint32_t points = 2 * order_ + 20;
  for (std::uint32_t vertex = 0; vertex < near->size(); ++vertex) {
    for (const certify::NearVertex& other : (*near)[vertex]) {
      if (other.vertex < vertex) continue;
      const Point a = rounded(other.isometry.a);
      const Point b = rounded(other.isometry.b);
      const double length = std::abs(a);
      const Point middle = a * b / (length * (length + 1));
      const double cosh_radius = (std::cosh(epsilon) + std::cosh(radius_)) / (2 * length);
      const double t = std::sqrt((cosh_radius - 1) / (cosh_radius + 1));
      Pair& pair = pairs_.emplace_back(Pair{vertex, other.vertex, {}, {}});
      for (std::uint32_t k = 0; k < points; ++k) {
        const Point around = std::polar(t, 2 * std::numbers::pi * k / points);
        const Point z = (around + middle) / (1.0 + std::conj(middle) * around);
        pair.in_first.push_back(z);
        pair.in_second.push_back((std::conj(a) * z - b) / (a - std::conj(b) * z));
      }
    }
  }
}

void EigenfunctionSearch::add_values(double lambda, Point z, double sign, double* row) const {
  const double s = std::norm(z);
  Vector factors(order_ + 2);
  factors[order_ + 1] = radial_factor(lambda, s, order_ + 1);
  factors[order_] = radial_factor(lambda, s, order_);
  for (std::uint32_t m = order_; m > 0; --m)
    factors[m - 1] = (1 + s) * factors[m] - s * (1 + lambda / (m * (m + 1.0))) * factors[m + 1];
  row[0] += sign * factors[0];
  Point power = 1;
  for (std::size_t m = 1; m <= order_; ++m) {
    power *= scale_ * z;
    row[2 * m - 1] += sign * factors[m] * power.real();
    row[2 * m] += sign * factors[m] * power.imag();
  }
}

std::vector<Vector> EigenfunctionSearch::rows(const Pair& pair, double lambda) const {
  std::vector<Vector> result(pair.in_first.size(), Vector(pair.first == pair.second ? each_ : 2 * each_));
  for (std::size_t k = 0; k < result.size(); ++k) {
    add_values(lambda, pair.in_first[k], -1, result[k].data());
    add_values(lambda, pair.in_second[k], 1, result[k].data() + (result[k].size() - each_));
  }
  return result;
}

Vector EigenfunctionSearch::differences(double lambda, const Vector& c) const {
  Vector result;
  for (const Pair& pair : pairs_) {
    for (const Vector& row : rows(pair, lambda)) {
      double sum = 0;
      for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * c[column(pair, i)];
      result.push_back(sum);
    }
  }
  return result;
}

std::optional<Vector> EigenfunctionSearch::best(double lambda) const {
  std::vector<Vector> matrix(size(), Vector(size()));
  for (const Pair& pair : pairs_) {
    for (const Vector& row : rows(pair, lambda)) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        Vector& target = matrix[column(pair, i)];
        const double factor = row[i];
        for (std::size_t block = 0; block <= i / each_; ++block) {
          double* const to = target.data() + column(pair, block * each_);
          const double* const from = row.data() + block * each_;
          for (std::size_t j = 0; j < each_; ++j) to[j] += factor * from[j];
        }
      }
    }
  }
  double greatest = 0;
  for (std::size_t i = 0; i < size(); ++i) greatest = std::max(greatest, matrix[i][i]);
  for (std::size_t i = 0; i < size(); ++i) matrix[i][i] += 1e-14 * greatest;  // Else rounding may make it indefinite.
  const auto factor = Cholesky::of(std::move(matrix));
  if (!factor) return std::nullopt;
  Vector c(size());
  for (std::size_t i = 0; i < size(); ++i) c[i] = static_cast<double>(i * i % 101) - 50;
  for (int i = 0; i < 6; ++i) {
    c = factor->solve(std::move(c));
    normalize(c);
  }
  // The products of rows are rounded: corrections from the differences themselves.
  for (int i = 0; i < 2; ++i) {
    const Vector r = differences(lambda, c);
    Vector gradient(size());
    std::size_t k = 0;
    for (const Pair& pair : pairs_) {
      for (const Vector& row : rows(pair, lambda)) {
        for (std::size_t j = 0; j < row.size(); ++j) gradient[column(pair, j)] += row[j] * r[k];
        ++k;
      }
    }
    const Vector correction = factor->solve(std::move(gradient));
    for (std::size_t j = 0; j < size(); ++j) c[j] -= correction[j];
    normalize(c);
  }
  return c;
}

std::optional<Eigenfunction> EigenfunctionSearch::near(double lambda) const {
  std::optional<std::pair<double, Vector>> found;
  double least = HUGE_VAL;
  constexpr int kMostSteps = 8;
  for (int i = 0; i < kMostSteps && lambda > 0 && !pairs_.empty(); ++i) {
    if (progress_) progress_("eigenfunctions", static_cast<double>(i) / kMostSteps);
    auto c = best(lambda);
    if (!c) break;
    const Vector r = differences(lambda, *c);
    if (norm(r) > least / 2) break;
    least = norm(r);
    // The derivative of the differences by λ; by Gauss and Newton's method, as the differences for the best
    // coefficients of any λ are orthogonal to all that coefficients can change.
    const double step = 1e-5 * lambda;
    const Vector above = differences(lambda + step, *c);
    const Vector below = differences(lambda - step, *c);
    double product = 0;
    for (std::size_t k = 0; k < r.size(); ++k) product += r[k] * (above[k] - below[k]) / (2 * step);
    found.emplace(lambda, *std::move(c));
    lambda -= least * least / product;
  }
  if (!found) return std::nullopt;
  Eigenfunction result{{}, found->first, radius_, std::move(found->second)};
  for (std::size_t i = 0; i < result.coefficients.size(); ++i)
    result.coefficients[i] *= std::pow(scale_, static_cast<int>((i % each_ + 1) / 2));
  const certify::Precision scope(kBits);
  const auto error = certify::eigenvalue_error(document_, result, labels_, genus_, {}, threads_);
  if (!error || !certify::is_finite(*error)) return std::nullopt;
  const double margin = certify::outer_interval(*error).upper * (1 + 1e-9);
  result.in = {std::nextafter(result.lambda - margin, -HUGE_VAL), std::nextafter(result.lambda + margin, HUGE_VAL)};
  if (result.in.lower <= 0) return std::nullopt;
  return result;
}

}  // namespace epsnet
