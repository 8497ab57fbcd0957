#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "certify/net/label_evaluator.h"
#include "certify/numbers/ball.h"

/// Functions around the vertices of a net that nearly fit together (docs/proof.md, section 17). Balls round to the
/// precision of the caller.
namespace epsnet::certify {

/// F_0, …, F_M: tanh(ρ/2)^m F_m(tanh²(ρ/2)) e^{imθ}, in polar coordinates, is an eigenfunction of −Δ on the hyperbolic
/// plane, with the eigenvalue λ.
class RadialFactors {
 public:
  /// For s up to `greatest`, at most ½, or up to the upper end of its ball. Requires: λ > 0.
  RadialFactors(const Ball& lambda, std::uint32_t order, const Ball& greatest);

  /// Their values at s ≥ 0. Not finite unless s is certainly not too large, or if 500 terms of the series are not
  /// enough.
  [[nodiscard]] std::vector<Ball> operator()(const Ball& s) const;
  /// The cost of that, in operations of balls.
  [[nodiscard]] std::uint64_t operations() const {
    return 2 * (last_.coefficients.size() + next_.coefficients.size()) + 4 * std::uint64_t{order_};
  }

 private:
  /// F_m is their polynomial in s/(1 − s), up to the error, for s up to the greatest.
  struct Series {
    std::vector<Ball> coefficients;
    Ball error;
  };
  [[nodiscard]] Series series(const Ball& lambda, std::uint32_t m) const;
  [[nodiscard]] static Ball value(const Series& series, const Ball& x);

  std::uint32_t order_;
  Ball greatest_;
  Series last_;                ///< F_M
  Series next_;                ///< F_{M + 1}
  std::vector<Ball> weights_;  ///< By m: 1 + λ/(m(m + 1)).
};

/// A bound δ such that at least as many eigenvalues of −Δ on the surface as the row has functions, perhaps 0 among
/// them, lie in [λ − δ, λ + δ]; infinity if the functions prove none. Nothing if more bits are needed. BudgetSpent.
///
/// Requires: the rules of the net are verified, and the structure is right; `labels` are those of the net.
[[nodiscard]] std::optional<Ball> eigenvalue_error(const NetDocument& net,
                                                   const EigenvaluesDocument::Eigenfunctions& row,
                                                   const std::vector<BallIsometry>& labels, std::uint64_t genus,
                                                   const Budget& budget, unsigned threads);

}  // namespace epsnet::certify
