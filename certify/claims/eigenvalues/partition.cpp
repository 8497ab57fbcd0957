#include "certify/claims/eigenvalues/partition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epsnet::certify {
namespace {

using Point = std::complex<double>;

/// The sums over all lifts in a cell: all points within ρ of its centre.
class PartitionCell {
 public:
  PartitionCell(double reach, double radius)
      : reach_(reach),
        cosh_(std::cosh(reach)),
        sinh_(std::sinh(reach)),
        scale_(2 * std::pow(std::sinh(radius / 2), 2)) {}

  /// A lift, seen from the centre: C = cosh d, and the vector ∇C.
  void add(Point z) {
    const double gap = 1 - std::norm(z);
    const double beyond_one = 2 * std::norm(z) / gap;  // C − 1
    const Point vector = 2.0 * z / gap;
    const double sinh = std::sqrt(std::norm(vector));
    const double greatest_sinh = sinh * cosh_ + (1 + beyond_one) * sinh_;  // Of d + ρ.
    const double greatest_cosh = (1 + beyond_one) * cosh_ + sinh * sinh_;
    const double change = reach_ * greatest_sinh;
    const double turn = reach_ * greatest_cosh;  // Of the gradient.
    const double most = 1 - (beyond_one - change) / scale_;
    if (most <= 0) return;
    const double least = std::max(0.0, 1 - (beyond_one + change) / scale_);
    const double here = std::max(0.0, 1 - beyond_one / scale_);
    const double steepest = (sinh + turn) / scale_;
    const double flattest = std::max(0.0, sinh - turn) / scale_;
    squares_ += least * least;
    slopes_ += 2 * most * steepest;
    gradient_ += here * vector;
    turns_ += (most - least) * (sinh + turn) + here * turn;
    // Δh² = 2|∇h|² − 4hC/β, or 0 where h is 0.
    double low = 2 * flattest * flattest - 4 * most * greatest_cosh / scale_;
    double high = 2 * steepest * steepest - 4 * least * std::max(1.0, 1 + beyond_one - change) / scale_;
    if (least == 0) {
      low = std::min(low, 0.0);
      high = std::max(high, 0.0);
    }
    laplacians_ += std::max(std::abs(low), std::abs(high));
    lowest_ += low;
    highest_ += high;
  }

  [[nodiscard]] PartitionBounds bounds() const {
    if (squares_ <= 0) return {kInfinity, kInfinity};
    const double gradient = 2 * (std::abs(gradient_) + turns_) / scale_;
    const double laplacian = std::max(std::abs(lowest_), std::abs(highest_));
    return {(laplacians_ + laplacian) / squares_ +
                (2 * slopes_ * gradient + 2 * gradient * gradient) / (squares_ * squares_),
            (slopes_ + gradient) / squares_};
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  double reach_;  ///< ρ
  double cosh_;
  double sinh_;
  double scale_;        ///< β = cosh R − 1
  double squares_ = 0;  ///< Of h, at least.
  double slopes_ = 0;   ///< 2h|∇h|, at most.
  Point gradient_;      ///< Σ h∇C, at the centre,
  double turns_ = 0;    ///< and how far it may be from there.
  double laplacians_ = 0;
  double lowest_ = 0;
  double highest_ = 0;
};

}  // namespace

PartitionBounds partition_bounds(const std::vector<Point>& lifts, double epsilon, double radius) {
  constexpr double kSide = 0.05;  // Of the squares, relative to the disk.
  const double disk = std::tanh(epsilon / 2);
  const double side = kSide * disk;
  const double half_diagonal = side * 0.70710679;
  // In the disk with its cells, lengths are at most 2/(1 − |z|²) times as long. The rest is for rounding.
  const double reach = 2 * half_diagonal / (1 - std::pow(disk + side, 2)) * (1 + 1e-6) + 1e-9;
  PartitionBounds result;
  const int most = static_cast<int>(std::ceil(1 / kSide)) + 1;
  for (int i = -most; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) {
      const Point centre(i * side, j * side);
      if (std::abs(centre) > disk + half_diagonal) continue;
      PartitionCell cell(reach, radius);
      for (const Point& lift : lifts) cell.add((lift - centre) / (1.0 - std::conj(centre) * lift));
      const PartitionBounds here = cell.bounds();
      result.laplacians = std::max(result.laplacians, here.laplacians);
      result.gradients = std::max(result.gradients, here.gradients);
    }
  }
  constexpr double kRounding = 1 + 1e-6;
  return {result.laplacians * kRounding, result.gradients * kRounding};
}

}  // namespace epsnet::certify
