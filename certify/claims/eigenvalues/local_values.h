#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "certify/numbers/ball.h"

/// Values of functions around the vertices of a net, in integers: a hundred times as fast as balls, with errors that
/// are known beforehand and are less than what rounding the coefficients to binary64 changes (docs/proof.md,
/// Lemma 37.7).
namespace epsnet::certify {

/// Where a function around a vertex is asked for: the point z of the disk that has the vertex in its centre, s = |z|²,
/// and x = s/(1 − s). With s₀ the greatest that s may be, x₀ = s₀/(1 − s₀), and X = min(1, 2x₀): z/√s₀ in multiples of
/// 2⁻⁶²; s and x/X in multiples of 2⁻⁶¹; each less than one of them away.
struct LocalPoint {
  /// Nothing if the balls do not tell, or |z|² may be greater than `greatest`.
  [[nodiscard]] static std::optional<LocalPoint> of(const ComplexBall& z, const Ball& greatest);

  std::int64_t x;
  std::int64_t y;
  std::int64_t s;
  std::int64_t ratio;
};

/// F_0, …, F_M: tanh(ρ/2)^m F_m(tanh²(ρ/2)) e^{imθ}, in polar coordinates, is an eigenfunction of −Δ on the hyperbolic
/// plane, with the eigenvalue λ.
class RadialFactors {
 public:
  /// For points with this s₀. Nothing if s₀ may be more than ½, or λ is too large for it and the order, or if more bits
  /// are needed. Requires: λ > 0.
  [[nodiscard]] static std::optional<RadialFactors> make(const Ball& lambda, std::uint32_t order, const Ball& greatest);

  [[nodiscard]] std::uint32_t order() const { return static_cast<std::uint32_t>(weights_.size()); }
  /// By m, in multiples of 2⁻⁶¹.
  void set(const LocalPoint& point, std::vector<std::int64_t>& factors) const;
  /// By m, how far they may be from there; all are at most 2²⁰.
  [[nodiscard]] const std::vector<double>& errors() const { return errors_; }
  /// About how many nanoseconds `set` takes.
  [[nodiscard]] std::uint64_t work() const { return 4 * (last_.size() + next_.size()) + 10 * std::uint64_t{order()}; }

 private:
  using Polynomial = std::vector<std::int64_t>;
  RadialFactors() = default;

  Polynomial last_;                    ///< F_M, of the ratio.
  Polynomial next_;                    ///< F_{M + 1}
  std::vector<std::int64_t> weights_;  ///< By m − 1: λ/(m(m + 1)), in multiples of 2^−`weight_bits_`.
  int weight_bits_ = 0;
  std::vector<double> errors_;
};

/// The functions of a row.
class LocalValues {
 public:
  /// For points with this s₀. Nothing as above, or if a coefficient is too large.
  [[nodiscard]] static std::optional<LocalValues> make(const EigenvaluesDocument::Eigenfunctions& row,
                                                       std::size_t vertices, const Ball& greatest);

  [[nodiscard]] std::size_t count() const { return scales_.size(); }
  [[nodiscard]] const RadialFactors& factors() const { return factors_; }

  /// The value of each function, in multiples of its unit; `factors` are those of the point.
  void set(std::size_t vertex, const LocalPoint& point, const std::vector<std::int64_t>& factors,
           std::vector<std::int64_t>& values) const;
  /// The unit in which a function's values are given, a power of 2.
  [[nodiscard]] double unit(std::size_t function) const { return scales_[function].unit; }
  /// How far values of a function around a vertex may be from what is set.
  [[nodiscard]] double error(std::size_t function, std::size_t vertex) const {
    return scales_[function].unit * scales_[function].errors[vertex];
  }
  /// About how many nanoseconds `set` takes.
  [[nodiscard]] std::uint64_t work() const { return count() * (10 + 6 * std::uint64_t{factors_.order()}); }

 private:
  struct Coefficient {
    std::int64_t real;
    std::int64_t imaginary;
  };
  struct Scale {
    double unit;
    std::vector<double> errors;  ///< By vertex, in units.
  };

  explicit LocalValues(RadialFactors factors) : factors_(std::move(factors)) {}

  RadialFactors factors_;
  std::vector<Scale> scales_;              ///< By function.
  std::vector<Coefficient> coefficients_;  ///< By vertex, function and m, times √s₀^m, in units.
};

}  // namespace epsnet::certify
