#include "netgen/eigenvalues/eigenfunction.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/eigenfunction.h"
#include "certify/claims/eigenvalues/near_vertices.h"
#include "certify/net/label_evaluator.h"
#include "certify/net/surface_check.h"
#include "certify/numbers/parallel.h"

namespace epsnet {
namespace {

using certify::Ball;
using Vector = std::vector<double>;
using Point = std::complex<double>;
using Eigenfunction = certify::EigenvaluesDocument::Eigenfunction;

constexpr long kBits = 128;
constexpr std::size_t kMostCandidates = 10;

double rounded(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }
Point rounded(const certify::ComplexBall& z) { return {rounded(certify::real(z)), rounded(certify::imaginary(z))}; }

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

/// Sums in a fixed order, four at a time, which the processor can add at once.
double dot(const double* x, const double* y, std::size_t count) {
  double sums[4] = {0, 0, 0, 0};
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    for (std::size_t i = 0; i < 4; ++i) sums[i] += x[k + i] * y[k + i];
  }
  for (; k < count; ++k) sums[0] += x[k] * y[k];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}
double dot(const Vector& x, const Vector& y) { return dot(x.data(), y.data(), x.size()); }

double norm(const Vector& x) { return std::sqrt(dot(x, x)); }

void add(double* to, double factor, const double* from, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) to[k] += factor * from[k];
}
void add(Vector& to, double factor, const Vector& from) { add(to.data(), factor, from.data(), to.size()); }

void normalize(Vector& x) {
  const double scale = 1 / norm(x);
  for (double& value : x) value *= scale;
}

/// The eigenvalues of a symmetric tridiagonal matrix, in increasing order, and eigenvectors of norm 1, by the QR method
/// with Wilkinson's shifts.
std::vector<std::pair<double, Vector>> eigenvectors(Vector diagonal, Vector beside) {
  const std::size_t size = diagonal.size();
  std::vector<Vector> vectors(size, Vector(size));  // As rows.
  for (std::size_t i = 0; i < size; ++i) vectors[i][i] = 1;
  const auto is_small = [&](std::size_t k) {
    return std::abs(beside[k]) <= 0x1p-53 * (std::abs(diagonal[k]) + std::abs(diagonal[k + 1]));
  };
  std::size_t most_steps = 60 * size;
  for (std::size_t last = size - 1; last > 0 && most_steps > 0; --most_steps) {
    std::size_t first = last;  // Of the block that is not split yet.
    while (first > 0 && !is_small(first - 1)) --first;
    if (first == last) {
      --last;
      continue;
    }
    const double half = (diagonal[last - 1] - diagonal[last]) / 2;
    const double square = beside[last - 1] * beside[last - 1];
    const double shift = diagonal[last] - square / (half + std::copysign(std::sqrt(half * half + square), half));
    // Rotations of rows k and k + 1, each of which makes 0 what the one before has left beside the diagonals.
    double x = diagonal[first] - shift;
    double bulge = beside[first];
    for (std::size_t k = first; k < last; ++k) {
      const double r = std::sqrt(x * x + bulge * bulge);
      const double c = r > 0 ? x / r : 1;
      const double s = r > 0 ? bulge / r : 0;
      if (k > first) beside[k - 1] = r;
      const double upper = diagonal[k];
      const double lower = diagonal[k + 1];
      const double between = beside[k];
      diagonal[k] = c * c * upper + 2 * c * s * between + s * s * lower;
      diagonal[k + 1] = s * s * upper - 2 * c * s * between + c * c * lower;
      beside[k] = (c * c - s * s) * between + c * s * (lower - upper);
      x = beside[k];
      if (k + 1 < last) {
        bulge = s * beside[k + 1];
        beside[k + 1] *= c;
      }
      for (std::size_t i = 0; i < size; ++i) {
        const double value = vectors[k][i];
        vectors[k][i] = c * value + s * vectors[k + 1][i];
        vectors[k + 1][i] = c * vectors[k + 1][i] - s * value;
      }
    }
  }
  std::vector<std::pair<double, Vector>> result;
  for (std::size_t i = 0; i < size; ++i) result.emplace_back(diagonal[i], std::move(vectors[i]));
  std::sort(result.begin(), result.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  return result;
}

}  // namespace

EigenfunctionSearch::EigenfunctionSearch(const certify::EigenvaluesDocument& document, unsigned threads,
                                         Progress progress)
    : document_(document),
      threads_(certify::thread_count(threads)),
      progress_(std::move(progress)),
      epsilon_(certify::decimal(document.net.epsilon).get_d()),
      radius_(1.3 * epsilon_),
      scale_(1 / std::tanh(0.8 * epsilon_)),
      order_(76),
      each_(2 * std::size_t{order_} + 1) {
  constexpr std::size_t kMostVertices = 150;
  if (document.net.vertices.size() > kMostVertices) return;
  const certify::Precision scope(kBits);
  auto surface = certify::check_surface(document.net.surface, threads_);
  genus_ = static_cast<std::uint32_t>(surface.genus);
  const auto parts = certify::label_parts(std::move(surface.crossings), document.net.charts, {});
  std::vector<std::uint32_t> numbers(document.net.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  labels_ = certify::LabelEvaluator(document.net, parts).evaluate(numbers, kBits, 4 * kBits, threads_);
  add_circles();
}

/// Two circles around each vertex, of more than ε, so that all their points are within ε of another vertex; two, as a
/// function may vanish on one of them. They are as wide as the disks in which certify compares functions.
void EigenfunctionSearch::add_circles() {
  const double outer = 1.6 * epsilon_;
  const auto near =
      certify::near_vertices(document_, labels_, Ball::exactly(outer) + Ball::exactly(1.01 * epsilon_), {});
  if (!near) return;
  const std::uint32_t around = 2 * order_ + 20;
  for (const double radius : {outer, 1.4 * epsilon_}) {
    for (std::uint32_t k = 0; k < around; ++k)
      points_.push_back(std::polar(std::tanh(radius / 2), 2 * std::numbers::pi * k / around));
  }
  for (const auto& others : *near) {
    std::vector<std::pair<Point, Point>> isometries;
    isometries.reserve(others.size());
    for (const certify::NearVertex& other : others)
      isometries.emplace_back(rounded(other.isometry.a), rounded(other.isometry.b));
    for (const Point& z : points_) {
      Point best = 1;
      std::uint32_t vertex = 0;
      for (std::size_t i = 0; i < others.size(); ++i) {
        const auto& [a, b] = isometries[i];
        const Point w = (std::conj(a) * z - b) / (a - std::conj(b) * z);
        if (std::norm(w) >= std::norm(best)) continue;
        best = w;
        vertex = others[i].vertex;
      }
      nearest_.push_back(vertex);
      points_of_nearest_.push_back(best);
    }
  }
}

void EigenfunctionSearch::set_values(double lambda, Point z, double* row) const {
  const double s = std::norm(z);
  Vector factors(order_ + 2);
  factors[order_ + 1] = radial_factor(lambda, s, order_ + 1);
  factors[order_] = radial_factor(lambda, s, order_);
  for (std::uint32_t m = order_; m > 0; --m)
    factors[m - 1] = (1 + s) * factors[m] - s * (1 + lambda / (m * (m + 1.0))) * factors[m + 1];
  row[0] = factors[0];
  Point power = 1;
  for (std::size_t m = 1; m <= order_; ++m) {
    power *= scale_ * z;
    row[2 * m - 1] = factors[m] * power.real();
    row[2 * m] = factors[m] * power.imag();
  }
}

/// The differences of the functions of each vertex and its neighbours on its circles: a linear map of coefficients.
class EigenfunctionSearch::Differences {
 public:
  Differences(const EigenfunctionSearch& search, double lambda)
      : search_(search),
        own_(search.points_.size() * search.each_),
        others_(search.points_of_nearest_.size() * search.each_) {
    const std::size_t each = search.each_;
    for (std::size_t k = 0; k < search.points_.size(); ++k)
      search.set_values(lambda, search.points_[k], own_.data() + k * each);
    for (std::size_t k = 0; k < search.points_of_nearest_.size(); ++k)
      search.set_values(lambda, search.points_of_nearest_[k], others_.data() + k * each);
    weight_ = 1 / std::sqrt(static_cast<double>(search.points_.size()));
  }

  [[nodiscard]] Vector operator()(const Vector& c) const {
    const std::size_t each = search_.each_;
    Vector result(search_.nearest_.size());
    for_each_row([&](std::size_t k, std::size_t vertex, const double* own, const double* other) {
      result[k] = weight_ *
                  (dot(other, c.data() + search_.nearest_[k] * each, each) - dot(own, c.data() + vertex * each, each));
    });
    return result;
  }

  [[nodiscard]] Vector transposed(const Vector& r) const {
    const std::size_t each = search_.each_;
    Vector result(search_.size());
    for_each_row([&](std::size_t k, std::size_t vertex, const double* own, const double* other) {
      add(result.data() + search_.nearest_[k] * each, weight_ * r[k], other, each);
      add(result.data() + vertex * each, -weight_ * r[k], own, each);
    });
    return result;
  }

 private:
  template <class Function>
  void for_each_row(const Function& function) const {
    const std::size_t points = search_.points_.size();
    for (std::size_t k = 0; k < search_.nearest_.size(); ++k)
      function(k, k / points, own_.data() + k % points * search_.each_, others_.data() + k * search_.each_);
  }

  const EigenfunctionSearch& search_;
  Vector own_;     ///< By point: the values of functions of norm 1, the same ones around each vertex.
  Vector others_;  ///< By vertex and point, for the nearest other vertex.
  double weight_;
};

Vector EigenfunctionSearch::any_coefficients() const {
  Vector c(size());
  for (std::size_t i = 0; i < size(); ++i) c[i] = static_cast<double>(i * i % 101) - 50;
  return c;
}

/// By Lanczos's method for AᵀA, A the differences, with all vectors made orthogonal again. Most eigenvalues are near 1,
/// those of high waves, which neighbours do not pass on; the least ones are few.
std::vector<EigenfunctionSearch::Candidate> EigenfunctionSearch::best(double lambda, Vector c,
                                                                      std::size_t count) const {
  // About so many eigenvalues are less than λ, by Weyl's law, and as many waves are to be told apart.
  const double waves = (genus_ - 1) * lambda;
  const auto steps = static_cast<std::size_t>(100 + 10 * std::min(waves, 30.0));
  const Differences differences(*this, lambda);
  normalize(c);
  std::vector<Vector> basis{std::move(c)};
  Vector diagonal(steps);
  Vector beside(steps - 1);
  for (std::size_t i = 0; i < steps; ++i) {
    Vector next = differences.transposed(differences(basis[i]));
    for (int round = 0; round < 2; ++round) {
      for (std::size_t j = 0; j <= i; ++j) {
        const double product = dot(basis[j], next);
        if (round == 0 && j == i) diagonal[i] = product;
        if (round == 0 && j + 1 == i) beside[j] = product;
        add(next, -product, basis[j]);
      }
    }
    if (i + 1 == steps) break;
    normalize(next);
    basis.push_back(std::move(next));
  }
  const auto pairs = eigenvectors(std::move(diagonal), std::move(beside));
  std::vector<Vector> least(kMostCandidates, Vector(size()));
  for (std::size_t i = 0; i < kMostCandidates; ++i) {
    for (std::size_t j = 0; j < steps; ++j) add(least[i], pairs[i].second[j], basis[j]);
  }
  const double step = 1e-5 * lambda;
  const Differences above(*this, lambda + step);
  const Differences below(*this, lambda - step);
  std::vector<Candidate> result;
  for (std::size_t i = 0; i < count; ++i) {
    // Products are rounded: corrections from the differences themselves.
    Vector own = least[i];
    const Vector gradient = differences.transposed(differences(own));
    for (std::size_t j = 0; j < kMostCandidates; ++j) {
      if (pairs[j].first > 2 * pairs[i].first) add(own, -dot(least[j], gradient) / pairs[j].first, least[j]);
    }
    normalize(own);
    // By Gauss and Newton's method, as the differences for the best coefficients of any λ are orthogonal to all that
    // coefficients can change.
    const Vector r = differences(own);
    Vector slope = above(own);
    add(slope, -1, below(own));
    result.push_back({std::move(own), norm(r), lambda - dot(r, r) * 2 * step / dot(r, slope)});
  }
  return result;
}

std::vector<double> EigenfunctionSearch::around(double lambda) const {
  std::vector<double> result;
  if (points_of_nearest_.empty()) return result;
  for (const Candidate& candidate : best(lambda, any_coefficients(), kMostCandidates)) {
    if (candidate.lambda > 0) result.push_back(candidate.lambda);
  }
  std::sort(result.begin(), result.end(),
            [&](double x, double y) { return std::abs(x - lambda) < std::abs(y - lambda); });
  return result;
}

std::optional<Eigenfunction> EigenfunctionSearch::near(double lambda) const {
  if (points_of_nearest_.empty()) return std::nullopt;
  std::optional<std::pair<double, Candidate>> found;
  constexpr int kMostSteps = 16;
  constexpr double kRounding = 3e-14;
  bool failed = false;
  constexpr double kGreatest = 1e4;  // Beyond, no solution around a vertex is a number.
  for (int i = 0; i < kMostSteps && lambda > 0 && lambda < kGreatest; ++i) {
    if (progress_) progress_("eigenfunctions", static_cast<double>(i) / kMostSteps);
    const double at = lambda;
    Candidate next = std::move(best(at, found ? found->second.coefficients : any_coefficients(), 1).front());
    lambda = next.lambda;
    if (!found || next.differences < found->second.differences / 2) {
      found.emplace(at, std::move(next));
      failed = false;
    } else {
      // The step after one that leads astray leads back, so only two of them are the end.
      if (failed || found->second.differences < kRounding) break;
      failed = true;
    }
  }
  if (!found) return std::nullopt;
  Eigenfunction result{{}, found->first, radius_, std::move(found->second.coefficients)};
  for (std::size_t i = 0; i < result.coefficients.size(); ++i)
    result.coefficients[i] *= std::pow(scale_, static_cast<int>((i % each_ + 1) / 2));
  const certify::Precision scope(kBits);
  const auto error = certify::eigenvalue_error(document_, result, labels_, genus_, {}, threads_);
  if (!error || !certify::is_finite(*error)) return std::nullopt;
  const double margin = certify::outer_interval(*error).upper * (1 + 1e-9);
  constexpr double kGreatestMargin = 1e-3;  // Less than distances of eigenvalues: more says nothing of use.
  if (margin > kGreatestMargin) return std::nullopt;
  result.in = {std::nextafter(result.lambda - margin, -HUGE_VAL), std::nextafter(result.lambda + margin, HUGE_VAL)};
  if (result.in.lower <= 0) return std::nullopt;
  return result;
}

}  // namespace epsnet
