#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "certify/net/document.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/isometry.h"

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

// Which lifts of the vertices of a net are near each other. Balls round to the precision of the caller.

/// A lift of a vertex, seen from another vertex.
struct NearVertex {
  std::uint32_t vertex;
  /// From the disk with this vertex in its centre to the disk with the other one in its centre. Each is the disk of the
  /// vertex's chart, translated.
  BallIsometry isometry;
  Ball sinh_squared;  ///< sinh²(d/2), d the distance of the two.
};

/// By vertex: all lifts of vertices nearer than `distance`, but itself, and perhaps some that are as far to the balls'
/// precision. Nothing if balls do not tell which of them are the same. BudgetSpent.
///
/// Requires: the rules of the net are verified; `labels` are the values of its labels, number k ≥ 1 at k − 1. Time: the
/// square of the number of these lifts, by vertex.
[[nodiscard]] std::optional<std::vector<std::vector<NearVertex>>> near_vertices(const NetDocument& net,
                                                                                const std::vector<BallIsometry>& labels,
                                                                                const Ball& distance,
                                                                                const Budget& budget, unsigned threads);

// A partition of unity by functions around lifts of vertices (docs/proof.md, Lemma 37.2).

/// Upper bounds for the sums of |Δψ_q| and of |∇ψ_q| over all q.
struct PartitionBounds {
  double laplacians = 0;
  double gradients = 0;
};

/// Within ε of the centre of a disk, where the functions of these lifts, of which one is the centre itself, count
/// within R of them. Infinite where they do not cover the disk. In binary64, with room for its errors. Time: some 1,500
/// cells, times the number of lifts.
///
/// Requires: 0 < ε < R < 2, ε rounded up; the lifts are known to 10⁻¹², and are all that are within ε + R.
[[nodiscard]] PartitionBounds partition_bounds(const std::vector<std::complex<double>>& lifts, double epsilon,
                                               double radius);

/// Where functions around the vertices of a net meet: what is the same for all rows of functions with one radius R.
class Overlaps {
 public:
  /// Two lifts of vertices less than ε + R apart, and the disk around their midpoint that contains all points within ε
  /// of one and R of the other (docs/proof.md, Lemma 37.4).
  struct Pair {
    std::uint32_t vertex;
    std::uint32_t other;
    std::uint32_t waves;  ///< J
    std::size_t first;    ///< Of its points.
    LocalPoint edge;      ///< A point of the disk's boundary, seen from the midpoint, as what it takes to get factors.
    Ball s;               ///< tanh² of half the disk's radius.
  };
  /// One of 2J points on the boundary of a disk, seen from both vertices.
  struct Point {
    LocalPoint own;
    LocalPoint other;
  };

  /// For functions of this order, of eigenvalues up to λ. Nothing if more bits are needed. BudgetSpent. Requires: the
  /// rules of the net are verified; `labels` are those of the net.
  [[nodiscard]] static std::optional<Overlaps> make(const NetDocument& net, const std::vector<BallIsometry>& labels,
                                                    double radius, std::uint32_t order, double lambda,
                                                    const Budget& budget, unsigned threads);

  /// s₀: tanh² of half the greatest distance of a point from its vertex.
  [[nodiscard]] const Ball& greatest() const { return greatest_; }
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  /// Of a pair, the k-th at the angle 2πk/n from the direction of the midpoint's disk, n their number.
  [[nodiscard]] std::span<const Point> points(const Pair& pair) const {
    return std::span(points_).subspan(pair.first, std::size_t{2} * pair.waves);
  }
  /// cos and sin of 2πk/n, k < n = 2J, for the J of some pair: less than 2⁻⁵³ away.
  [[nodiscard]] const std::vector<double>& roots_of_unity(std::uint32_t waves) const { return roots_[waves]; }
  /// By vertex.
  [[nodiscard]] const std::vector<PartitionBounds>& partition() const { return partition_; }
  /// The least sinh of half the distance of two of the lifts, but at most sinh ε.
  [[nodiscard]] const Ball& sinh_disk() const { return sinh_disk_; }
  /// An upper bound for the area of a disk of radius ε.
  [[nodiscard]] double disk_area() const { return disk_area_; }

 private:
  Ball greatest_;
  std::vector<Pair> pairs_;
  std::vector<Point> points_;
  std::vector<std::vector<double>> roots_;  ///< By J; empty where no pair has it.
  std::vector<PartitionBounds> partition_;
  Ball sinh_disk_;
  double disk_area_ = 0;
};

}  // namespace epsnet::certify
