#pragma once

#include <functional>
#include <span>

#include "certify/base/interval.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/eigenvalues/trace_forms.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"

namespace epsnet::certify {

/// The test functions of a document, of which `up_to` is a decimal.
[[nodiscard]] TestFunctions test_functions(const EigenvaluesDocument& document);

/// ¼ + 9/δ², up to which values of the functions are enclosed.
[[nodiscard]] mpq_class greatest_eigenvalue(const TestFunctions& functions);

/// f̂² on intervals (docs/proof.md, Lemma 34).
class SquaredTestFunction {
 public:
  SquaredTestFunction(const TestFunctions& functions, std::span<const double> coefficients);

  /// Contains f̂(λ)² for all λ in the interval. Requires: δ²(λ − ¼) ≤ 9 for its upper end.
  [[nodiscard]] Ball on(Interval lambda) const;
  /// The cost of `on`, in operations of balls.
  [[nodiscard]] std::uint64_t operations() const { return 3 * coefficients_.size() * coefficients_.size() + 200; }

 private:
  Ball step_;
  std::uint32_t order_;
  std::vector<Ball> coefficients_;
};

/// Whether a function is positive everywhere on an interval; `enclose` contains its values on a part of it. `no` if it
/// is certainly not at some point; `unknown` if that takes more than some thousand parts.
[[nodiscard]] Tri is_positive_on(Interval interval, const std::function<Ball(Interval)>& enclose);

}  // namespace epsnet::certify
