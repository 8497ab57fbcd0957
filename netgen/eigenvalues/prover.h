#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "netgen/eigenvalues/solver.h"
#include "netgen/eigenvalues/trace_matrices.h"

/// Numbers of eigenvalues in intervals by test functions. docs/eigenvalues.md says why.
namespace epsnet {

/// Where at most so many eigenvalues can be, there is none, provably.
inline constexpr double kOpen = 0.98;

/// Coefficients as they are in a file, and their three sums Σ λ^p f̂².
struct Trial {
  std::vector<double> coefficients;
  std::array<Real, 3> sums;
  std::vector<Real> known;  ///< By known eigenvalue: what it adds at least to the first sum, by `certify`'s balls.
};

/// Finds test functions that prove numbers of eigenvalues, as far as sampled minima and maxima are right.
class Prover {
 public:
  /// `matrices` are those of trace_matrices for this space. Each of the disjoint intervals `known` contains an
  /// eigenvalue. Throws NetError if the first matrix is singular.
  Prover(TestSpace space, std::vector<RealMatrix> matrices, std::vector<certify::Interval> known = {});

  [[nodiscard]] const TestSpace& space() const { return space_; }
  [[nodiscard]] const std::vector<certify::Interval>& known() const { return known_; }

  /// The bound for the number of eigenvalues at λ that are not known: the least Σ f̂² over all but the known ones with
  /// f̂(λ) = 1.
  [[nodiscard]] double most_at(double lambda) const;

  /// The test function with the least Σ f̂² over all eigenvalues but the known ones outside of an interval that is 1 at
  /// several points there, so that it is flat between near ones. Nothing for points that are too near.
  [[nodiscard]] std::optional<Trial> flat_on(const std::vector<double>& points, certify::Interval in);
  /// The same for one point.
  [[nodiscard]] Trial best_at(double lambda, certify::Interval in) {
    return trial(solver_outside(in).solve(space_.values(Real(lambda))));
  }

  /// The best test function for sums of P f̂², P = ρ − λ, or (ρ − λ)(λ − σ) for σ > 0, relative to its value at λ.
  class Weighted {
   public:
    Weighted(const Prover& prover, certify::Interval in);
    [[nodiscard]] certify::Interval in() const { return in_; }
    [[nodiscard]] std::optional<Trial> best_at(double lambda) const;
    [[nodiscard]] Real sum(const Trial& trial) const;
    [[nodiscard]] Real weight(const Real& lambda) const;

   private:
    const Prover& prover_;
    certify::Interval in_;
    std::optional<Solver> solver_;
  };

  /// The least m for which the test function proves "at most m in the interval"; infinite if it vanishes there.
  [[nodiscard]] double most_in(const Trial& trial, certify::Interval in) const;
  /// The greatest m for which it proves "at least m if all are within"; 0 if it proves nothing.
  [[nodiscard]] double least_in(const Weighted& weighted, const Trial& trial, certify::Interval within) const;

  /// The least b, and a test function, for which Σ P f̂² = 0, P = b − λ for σ = 0 and otherwise (b − λ)(λ − σ): for
  /// every greater b one eigenvalue lies in (σ, b). The one next to a guess. By inverse iteration.
  [[nodiscard]] std::optional<std::pair<Trial, double>> first_behind(double sigma, double guess) const;

 private:
  /// The values of test functions at the ends and in the middle of a known interval.
  struct KnownValues {
    RealVector lower;
    RealVector middle;
    RealVector upper;
  };

  /// For sums over all eigenvalues but the known ones outside of an interval.
  [[nodiscard]] const Solver& solver_outside(certify::Interval in);
  /// What f̂² is at least in a known interval by the ball that `certify` computes for it. This is a little less than the
  /// least value, even less than 0 around a zero, and statements are so near to their bounds that the difference
  /// counts.
  [[nodiscard]] static Real least_square(const RealVector& c, const KnownValues& known);
  /// Rounds the coefficients, relative to the greatest.
  [[nodiscard]] Trial trial(RealVector c) const;
  /// f̂(λ)²
  [[nodiscard]] Real square(const Trial& trial, const Real& lambda) const;
  /// The greatest value of a function on an interval, sampled; the samples around the greatest one are refined.
  template <class Function>
  [[nodiscard]] Real extreme(certify::Interval in, const Function& function) const;

  TestSpace space_;
  std::vector<RealMatrix> matrices_;
  std::vector<certify::Interval> known_;
  std::vector<KnownValues> known_values_;
  Solver solver_;                                ///< For sums over unknown eigenvalues.
  std::map<std::vector<bool>, Solver> solvers_;  ///< By which known eigenvalues the sums leave out.
};

}  // namespace epsnet
