#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "certify/exact/claim_documents.h"
#include "certify/exact/interval.h"

/// Selberg's trace formula for the test functions of an eigenvalues file (docs/proof.md, sections 17 and 17.1).
namespace epsnet::exact {

/// f(λ) = sinc(δr/2)^(n/2) Σ c_k cos(kδr), λ = ¼ + r².
class TestFunction {
 public:
  TestFunction(const EigenvaluesDocument& document, const Coefficients& coefficients);

  /// Contains f(λ)² for all λ in the range, δ²(λ − ¼) <= 9 (Lemma 34).
  [[nodiscard]] Interval squared_on(const Range& lambda) const;

 private:
  Interval step_;
  unsigned long order_;
  std::vector<Interval> polynomial_;  ///< Σ c_k T_k: f is it at cos(δr), times the power of sinc.
};

/// δ
[[nodiscard]] mpq_class step_of(const EigenvaluesDocument& document);

/// The sums of λ^p f(λ)², p = 0, 1, 2, over all eigenvalues λ but 0.
class TraceFormula {
 public:
  /// The lengths are those of all primitive closed geodesics of length at most L of a surface of genus g,
  /// `minus_euler` = 2g − 2. Throws TooLarge.
  TraceFormula(const EigenvaluesDocument& document, const std::vector<Interval>& lengths, long minus_euler);

  [[nodiscard]] std::array<Interval, 3> sums(const Coefficients& coefficients) const;

 private:
  /// By interval [jδ, (j + 1)δ]: coefficients of the powers of x = u/δ − j − ½, but of u/δ for j = 0.
  using Piecewise = std::vector<std::vector<Interval>>;

  void add_length(const Interval& length);
  void add_integral(std::size_t j, long minus_euler);
  /// Of f², with respect to r.
  [[nodiscard]] Piecewise transform(const Coefficients& coefficients) const;

  const EigenvaluesDocument& document_;
  Interval step_;
  std::size_t pieces_;
  long terms_left_ = 1'000'000;
  Piecewise form_;  ///< What the trace formula makes of a function with these coefficients, by piece and power.
  std::array<std::vector<std::vector<Interval>>, 2> splines_;  ///< Around 0 and around ½, by piece of β_n and power.
};

}  // namespace epsnet::exact
