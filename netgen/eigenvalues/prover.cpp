#include "netgen/eigenvalues/prover.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "netgen/nets/certified_net.h"

namespace epsnet {
namespace {

using certify::Interval;

/// What rounding may add to quotients of sums and extreme values.
constexpr double kMargin = 0x1p-50;

/// Σ P f̂² for the sums Σ λ^p f̂².
Real combined(const std::array<Real, 3>& x, Interval in) {
  const Real rho = in.upper;
  const Real sigma = in.lower;
  return in.lower == 0 ? Real(rho * x[0] - x[1]) : Real((rho + sigma) * x[1] - x[2] - rho * sigma * x[0]);
}

RealMatrix weighted_matrix(const std::vector<RealMatrix>& matrices, Interval in) {
  RealMatrix result = matrices[0];
  for (std::size_t j = 0; j < result.size(); ++j) {
    for (std::size_t k = 0; k < result.size(); ++k)
      result[j][k] = combined({matrices[0][j][k], matrices[1][j][k], matrices[2][j][k]}, in);
  }
  return result;
}

/// For the form Σ f̂² over all eigenvalues but some known ones. Each of these keeps a small share, and one for the slope
/// of f̂ there, so that the form is positive although they are known in intervals only. Throws NetError if it is
/// singular.
Solver solver_without(const std::vector<Interval>& known, const TestSpace& space, RealMatrix matrix) {
  constexpr double kShare = 1e-5;
  for (const Interval& in : known) {
    const RealVector lower = space.values(Real(in.lower));
    const RealVector upper = space.values(Real(in.upper));
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      for (std::size_t k = 0; k < matrix.size(); ++k) {
        const Real value = (lower[j] + upper[j]) * (lower[k] + upper[k]) / 4;
        const Real change = (lower[j] - upper[j]) * (lower[k] - upper[k]);
        matrix[j][k] += change / kShare - (1 - kShare) * value;
      }
    }
  }
  auto solver = Solver::of(std::move(matrix));
  if (!solver) throw NetError("the trace formula gives a singular matrix");
  return *std::move(solver);
}

[[nodiscard]] bool are_disjoint(Interval x, Interval y) { return x.upper < y.lower || y.upper < x.lower; }

}  // namespace

Prover::Prover(TestSpace space, std::vector<RealMatrix> matrices, std::vector<Interval> known)
    : space_(std::move(space)),
      matrices_(std::move(matrices)),
      known_(std::move(known)),
      solver_(solver_without(known_, space_, matrices_[0])) {
  for (const Interval& in : known_) {
    const Real middle = (Real(in.lower) + Real(in.upper)) / 2;
    known_values_.push_back({space_.values(Real(in.lower)), space_.values(middle), space_.values(Real(in.upper))});
  }
}

double Prover::most_at(double lambda) const {
  const RealVector values = space_.values(Real(lambda));
  return static_cast<double>(1 / dot(values, solver_.solve(values)));
}

const Solver& Prover::solver_outside(Interval in) {
  std::vector<bool> left_out;
  std::vector<Interval> outside;
  for (const Interval& known : known_) {
    left_out.push_back(are_disjoint(known, in));
    if (left_out.back()) outside.push_back(known);
  }
  if (outside.size() == known_.size()) return solver_;
  const auto found = solvers_.find(left_out);
  if (found != solvers_.end()) return found->second;
  return solvers_.emplace(std::move(left_out), solver_without(outside, space_, matrices_[0])).first->second;
}

std::optional<Trial> Prover::flat_on(const std::vector<double>& points, Interval in) {
  const Solver& outside = solver_outside(in);
  std::vector<RealVector> values;
  std::vector<RealVector> solved;
  for (const double x : points) {
    values.push_back(space_.values(Real(x)));
    solved.push_back(outside.solve(values.back()));
  }
  RealMatrix products(points.size(), RealVector(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) products[i][j] = dot(values[i], solved[j]);
  }
  const auto solver = Solver::of(products);
  if (!solver) return std::nullopt;
  const RealVector factors = solver->solve(RealVector(points.size(), Real(1)));
  RealVector c(values.front().size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < c.size(); ++k) c[k] += factors[i] * solved[i][k];
  }
  return trial(std::move(c));
}

Prover::Weighted::Weighted(const Prover& prover, Interval in)
    : prover_(prover), in_(in), solver_(Solver::of(weighted_matrix(prover.matrices_, in))) {}

std::optional<Trial> Prover::Weighted::best_at(double lambda) const {
  if (!solver_) return std::nullopt;
  return prover_.trial(solver_->solve(prover_.space_.values(Real(lambda))));
}

Real Prover::Weighted::sum(const Trial& trial) const { return combined(trial.sums, in_); }

Real Prover::Weighted::weight(const Real& lambda) const {
  return in_.lower == 0 ? Real(in_.upper - lambda) : Real((in_.upper - lambda) * (lambda - in_.lower));
}

template <class Function>
Real Prover::extreme(Interval in, const Function& function) const {
  const auto parameter = [](double x) { return std::sqrt(std::max(x, 0.0)); };
  const double waves = (parameter(in.upper) - parameter(in.lower)) * static_cast<double>(space_.support);
  int parts = 4 + static_cast<int>(2 * waves);
  double lower = in.lower;
  double upper = in.upper;
  std::optional<Real> greatest;
  for (int round = 0; round < 12 && lower < upper; ++round, parts = 4) {
    int best = 0;
    std::optional<Real> best_value;
    for (int i = 0; i <= parts; ++i) {
      const double x = i == parts ? upper : lower + (upper - lower) * i / parts;
      const Real value = function(Real(x));
      if (!best_value || value > *best_value) {
        best_value = value;
        best = i;
      }
    }
    if (!greatest || *best_value > *greatest) greatest = best_value;
    const double width = (upper - lower) / parts;
    const double middle = lower + width * best;
    // At an end of the interval the function is monotone.
    if ((best == 0 && lower == in.lower) || (best == parts && upper == in.upper)) break;
    lower = std::max(lower, middle - width);
    upper = std::min(upper, middle + width);
  }
  return greatest ? *greatest : function(Real(in.lower));
}

double Prover::most_in(const Trial& trial, Interval in) const {
  const Real least = extreme(in, [&](const Real& x) { return Real(-square(trial, x)); });
  if (least >= 0) return HUGE_VAL;
  Real sum = trial.sums[0];
  for (std::size_t i = 0; i < known_.size(); ++i) {
    if (are_disjoint(known_[i], in)) sum -= trial.known[i];
  }
  const Real ratio = std::max(Real(0), sum) / -least * (1 + kMargin);
  return std::floor(static_cast<double>(ratio));
}

double Prover::least_in(const Weighted& weighted, const Trial& trial, Interval within) const {
  const Real sum = weighted.sum(trial);
  if (sum <= 0) return 0;
  const Real greatest = extreme(within, [&](const Real& x) { return Real(weighted.weight(x) * square(trial, x)); });
  if (greatest <= 0) return 0;
  return std::min(std::ceil(static_cast<double>(Real(sum / greatest * (1 - kMargin)))), 1e6);
}

std::optional<std::pair<Trial, double>> Prover::first_behind(double sigma, double guess) const {
  const std::size_t size = matrices_[0].size();
  RealMatrix left = matrices_[1];
  RealMatrix right = matrices_[0];
  for (std::size_t j = 0; sigma > 0 && j < size; ++j) {
    for (std::size_t k = 0; k < size; ++k) {
      left[j][k] = matrices_[2][j][k] - sigma * matrices_[1][j][k];
      right[j][k] = matrices_[1][j][k] - sigma * matrices_[0][j][k];
    }
  }
  RealMatrix shifted = left;
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = 0; k < size; ++k) shifted[j][k] -= guess * right[j][k];
  }
  const auto solver = Solver::of(shifted);
  if (!solver) return std::nullopt;
  RealVector c = space_.values(Real(guess));
  constexpr int kRounds = 60;
  for (int round = 0; round < kRounds; ++round) {
    RealVector image(size);
    for (std::size_t j = 0; j < size; ++j) image[j] = dot(right[j], c);
    c = solver->solve(image);
    const Real scale = 1 / boost::multiprecision::sqrt(dot(c, c));
    for (Real& x : c) x *= scale;
  }
  Trial result = trial(std::move(c));
  const auto& sums = result.sums;
  const Real above = sigma > 0 ? Real(sums[2] - sigma * sums[1]) : sums[1];
  const Real below = sigma > 0 ? Real(sums[1] - sigma * sums[0]) : sums[0];
  if (below <= 0) return std::nullopt;
  return std::pair(std::move(result), static_cast<double>(Real(above / below)));
}

Real Prover::least_square(const RealVector& c, const KnownValues& known) {
  using boost::multiprecision::abs;
  // Balls (of a middle and a radius, which has 30 bits) of the two factors of f̂² = sincⁿ·g², of which sinc^{n/2} is the
  // first value. That of g is from its Taylor series at the middle.
  constexpr double kRadius = 1 + 0x1p-24;
  const Real lower = dot(c, known.lower) / known.lower.front();
  const Real middle = abs(dot(c, known.middle)) / known.middle.front();
  const Real upper = dot(c, known.upper) / known.upper.front();
  const Real bend = abs(Real(abs(lower + upper) - 2 * middle));
  const Real radius = (abs(Real(lower - upper)) / 2 + bend) * kRadius;
  const Real square = middle * middle;
  const Real square_radius = (2 * middle + radius) * radius * kRadius;
  const Real power = known.middle.front() * known.middle.front();
  const Real power_radius = (known.lower.front() * known.lower.front() - power) * kRadius;
  return power * square * (1 - kMargin) - (power + power_radius) * square_radius - square * power_radius;
}

Trial Prover::trial(RealVector c) const {
  using boost::multiprecision::abs;
  Real greatest = 0;
  for (const Real& x : c) greatest = std::max(greatest, Real(abs(x)));
  Trial result;
  for (Real& x : c) {
    result.coefficients.push_back(static_cast<double>(Real(x / greatest)));
    x = result.coefficients.back();
  }
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t j = 0; j < c.size(); ++j) result.sums[p] += c[j] * dot(matrices_[p][j], c);
  }
  for (const KnownValues& known : known_values_) result.known.push_back(least_square(c, known));
  return result;
}

Real Prover::square(const Trial& trial, const Real& lambda) const {
  const RealVector values = space_.values(lambda);
  Real result = 0;
  for (std::size_t k = 0; k < values.size(); ++k) result += trial.coefficients[k] * values[k];
  return result * result;
}

}  // namespace epsnet
