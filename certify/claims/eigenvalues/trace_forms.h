#pragma once

#include <array>
#include <cstdint>
#include <gmpxx.h>
#include <optional>
#include <span>
#include <vector>

#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/verdict/report.h"

/// Selberg's trace formula for test functions of compact support (docs/proof.md, section 17).
namespace epsnet::certify {

/// The functions f̂(λ) = sinc(δr/2)^{n/2} Σ c_k cos(kδr), k = 0, …, K, where λ = ¼ + r² and δ = L/(2K + n/2). The
/// Fourier transform of f̂² vanishes outside of [−L, L].
struct TestFunctions {
  mpq_class support;          ///< L
  std::uint32_t order = 8;    ///< n, even, at least 8.
  std::uint32_t degree = 32;  ///< K

  /// δ
  [[nodiscard]] mpq_class step() const { return support / pieces(); }
  /// L/δ
  [[nodiscard]] std::uint32_t pieces() const { return 2 * degree + order / 2; }
};

/// a₀, …, a_{2K} with (Σ c_k cos kx)² = Σ a_m cos mx.
[[nodiscard]] std::vector<Ball> squared_cosine_sum(std::span<const double> coefficients);

/// The sums of λ^p f̂(λ)², p = 0, 1, 2, over all eigenvalues λ but λ = 0, as quadratic forms of the coefficients of f̂.
class TraceForms {
 public:
  /// `lengths` are those of all primitive closed geodesics of length at most L, up to orientation, of a surface of this
  /// genus. Nothing if they do not tell on which pieces of the splines their multiples lie. BudgetSpent. Time: linear
  /// in the number of the multiples, and some (L/δ)·precision².
  [[nodiscard]] static std::optional<TraceForms> of(const TestFunctions& functions, std::uint32_t genus,
                                                    std::span<const Ball> lengths, const Budget& budget);

  /// F₀, F₁, F₂ of the coefficients.
  [[nodiscard]] std::array<Ball, 3> operator()(std::span<const double> coefficients) const;

 private:
  explicit TraceForms(std::array<std::vector<Ball>, 3> moments) : moments_(std::move(moments)) {}

  /// By p and m = 0, …, 2K: the sum of λ^p sinc(δr/2)ⁿ cos(mδr).
  std::array<std::vector<Ball>, 3> moments_;
};

/// Rule `traces`, of the three sums of all statements: a sum of squares that is certainly negative refutes that the
/// list of geodesics is complete.
[[nodiscard]] RuleReport traces_report(std::span<const std::array<Ball, 3>> sums);

}  // namespace epsnet::certify
