#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "certify/base/interval.h"

/// Linear programmes about gradients of lengths, in binary64: nothing here is proved.
namespace epsnet {

[[nodiscard]] inline double middle_of(const certify::Interval& x) { return x.lower + (x.upper - x.lower) / 2; }

/// Maximizes the last variable of a linear programme: at_least ≤ rows · variables ≤ at_most, and variables between
/// `least` and `greatest`. Nothing if there is no solution.
[[nodiscard]] std::optional<std::vector<double>> maximize_last(const std::vector<std::vector<double>>& rows,
                                                               const std::vector<double>& at_least,
                                                               const std::vector<double>& at_most,
                                                               const std::vector<double>& least,
                                                               const std::vector<double>& greatest);

/// λ > 0 with the sum 1 and Σ λ_i g_i = 0, about, of which the least one is as great as possible. Nothing if that is
/// not positive or hardly so.
[[nodiscard]] std::optional<std::vector<double>> balance(std::span<const std::vector<certify::Interval>> gradients);

/// Those that are a basis of what the gradients span, as far as binary64 tells.
[[nodiscard]] std::vector<std::size_t> independent(std::span<const std::vector<certify::Interval>> gradients);

}  // namespace epsnet
