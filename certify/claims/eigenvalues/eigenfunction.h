#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/eigenvalues/local_functions.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"

/// Functions around the vertices of a net that nearly fit together (docs/proof.md, section 17).
namespace epsnet::certify {

// How far the functions around two vertices are from each other where both count (docs/proof.md, Lemma 37.4).

/// For the rounding of sums and products of at most 2²⁰ numbers that are not negative, in binary64, and of what they
/// are made of.
constexpr double kRoom = 1 + 0x1p-30;

inline double square(double x) { return x * x; }

/// Bounds for a function and its gradient.
struct FunctionBounds {
  double value = 0;
  double gradient = 0;
};

/// Bounds in a disk for functions with Δf = −λf, by their values at n = 2J points of its boundary. Infinite where
/// nothing follows, NaN where more bits are needed.
class DiskWaves {
 public:
  /// `s` is tanh² of half the disk's radius; by m < J, F_m(s) is at least `least_factors`, if that is positive; `roots`
  /// are cos and sin of 2πk/n, k < n, less than 2⁻⁵³ away.
  DiskWaves(const Ball& lambda, const Ball& s, const std::vector<double>& least_factors,
            const std::vector<double>& roots);

  /// For values each of which may be wrong by `error`, of a function that is at most `total` everywhere.
  [[nodiscard]] FunctionBounds bounds(const std::vector<double>& values, double error, double total) const;

 private:
  std::vector<FunctionBounds> weights_ = {};  ///< By m < J, what the size of a coefficient is multiplied with.
  FunctionBounds all_ = {};                   ///< The sums over −J < m < J,
  FunctionBounds root_ = {};                  ///< and the roots of the sums of squares.
  FunctionBounds beyond_ = {};                ///< The same for all that is not less than J, together.
  double tail_ = 0;                           ///< T, for C = 1.
  const std::vector<double>& roots_;
};

/// Bounds for the differences of functions in the disks of pairs.
class Mismatch {
 public:
  Mismatch(const Overlaps& overlaps, const LocalValues& values, const Ball& lambda)
      : overlaps_(overlaps), values_(values), lambda_(lambda) {}

  /// By function of the row; `totals` are those of both vertices together. Not finite as above.
  [[nodiscard]] std::vector<FunctionBounds> operator()(const Overlaps::Pair& pair,
                                                       const std::vector<double>& totals) const;
  /// About how many nanoseconds that takes.
  [[nodiscard]] std::uint64_t work(const Overlaps::Pair& pair) const;

 private:
  [[nodiscard]] std::vector<std::vector<double>> differences(const Overlaps::Pair& pair) const;
  [[nodiscard]] std::vector<double> least_factors(const Overlaps::Pair& pair) const;

  const Overlaps& overlaps_;
  const LocalValues& values_;
  const Ball& lambda_;
};

/// An upper bound for I of Lemma 37.3: for the integral over a surface of this area of a function that is at most the
/// k-th of these values, which are not negative, on the k-th of some parts, each of an area of at most `disk`.
[[nodiscard]] double greatest_integral(std::vector<double> values, double disk, double area);

/// A bound δ such that at least as many eigenvalues of −Δ on the surface as the row has functions, perhaps 0 among
/// them, lie in [λ − δ, λ + δ]; infinity if the functions prove none. Nothing if more bits are needed, or the
/// eigenvalue is too large for the disks. Balls round to the precision of the caller. BudgetSpent.
///
/// Requires: the rules of the net are verified, and the structure is right; `overlaps` are those of the net, the row's
/// radius and order.
[[nodiscard]] std::optional<double> eigenvalue_error(const Overlaps& overlaps,
                                                     const EigenvaluesDocument::Eigenfunctions& given,
                                                     std::uint64_t genus, const Budget& budget, unsigned threads);

}  // namespace epsnet::certify
