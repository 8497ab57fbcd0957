#include "certify/claims/eigenvalues/forms.h"

namespace epsnet::certify {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 3> kOthers{{{1, 2}, {2, 0}, {0, 1}}};

Ball sum(const std::array<Ball, 3>& x) { return x[0] + x[1] + x[2]; }

/// 180/|T| times the integrals of x_i x_j times products of two values, where i, j are the ends of a side and k is the
/// third corner.
struct Integrals {
  long square_beside;    ///< Of the value of i, or of j,
  long square_opposite;  ///< of that of k,
  long product_beside;   ///< of those of i and j,
  long product_across;   ///< of that of k and one of the others.
};
/// Values in the midpoint opposite to each corner.
constexpr Integrals kMidpoints{3, 7, -1, 1};
/// Values in the corners.
constexpr Integrals kCorners{3, 1, 2, 1};

/// factor·∫ ω v² (Lemma 31).
SymmetricForm power_mass(const std::array<Ball, 3>& squares, const Integrals& integrals, const Ball& factor) {
  SymmetricForm result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [j, k] = kOthers[i];
    // The side opposite to i has ends j and k; i is at an end of the others.
    const Ball others = squares[j] + squares[k];
    result.square[i] = factor * (integrals.square_opposite * squares[i] + integrals.square_beside * others);
    result.product[i] = factor * (integrals.product_beside * squares[i] + integrals.product_across * others);
  }
  return result;
}

/// factor·∫ |∇v|² for the values in the corners, or a fourth of that for those in the midpoints.
SymmetricForm energy(const std::array<Ball, 3>& cotangents, const Ball& factor) {
  SymmetricForm result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [j, k] = kOthers[i];
    result.square[i] = factor * half(cotangents[j] + cotangents[k]);
    result.product[i] = -(factor * half(cotangents[i]));
  }
  return result;
}

}  // namespace

std::optional<FlatTriangle> FlatTriangle::of(const std::array<Ball, 3>& squares) {
  const Ball product = 4 * squares[0] * squares[1] - sqr(squares[0] + squares[1] - squares[2]);  // 16|T|²
  for (const Ball& x : {squares[0], squares[1], squares[2], product}) {
    if (certainly_positive(x) != Tri::yes) return std::nullopt;
  }
  FlatTriangle triangle(squares);
  if (certainly_less(triangle.cosh_, 1 + triangle.radius_) != Tri::yes) return std::nullopt;
  return triangle;
}

FlatTriangle::FlatTriangle(const std::array<Ball, 3>& squares)
    : squares_(squares),
      area_(scaled(sqrt(4 * squares[0] * squares[1] - sqr(squares[0] + squares[1] - squares[2])), -2)) {
  const Ball squared_radius = squares[0] * squares[1] * squares[2] / (16 * sqr(area_));
  radius_ = sqrt(squared_radius);
  cosh_ = sqrt(1 + squared_radius);
  mean_power_ = sum(squares) / 12;
  trace_ = squared_radius - mean_power_;
  Ball parts;  // ΣA_k²
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [i, j] = kOthers[k];
    cotangents_[k] = (squares[i] + squares[j] - squares[k]) / (4 * area_);
    parts += sqr(scaled(squares[k] * cotangents_[k], -2));
  }
  greater_ = half(trace_) + sqrt_of_nonnegative(scaled(sqr(trace_), -2) - (4 * parts - sqr(area_)) / 36);
}

Ball FlatTriangle::mean_of_inverse(const Ball& c) const {
  const Ball across = 1 - c;
  const Ball beyond = cosh_ - c;
  return 1 / across - trace_ / (2 * cosh_ * across * beyond) + greater_ / ((1 - c * cosh_) * beyond);
}

SymmetricForm FlatTriangle::least_energy() const {
  const Ball c = 1 / (1 + radius_);
  return energy(cotangents_, 4 * (c + 1 / mean_of_inverse(c)));
}

SymmetricForm FlatTriangle::greatest_mass() const {
  const Ball squared = sqr(cosh_);
  const Ball kappa = (squared + cosh_ + 1) / (squared * (cosh_ + 1));
  SymmetricForm result = power_mass(squares_, kMidpoints, -(kappa * area_ / 180));
  for (Ball& x : result.square) x += cosh_ * area_ / 3;
  return result;
}

Ball FlatTriangle::interpolation_constant() const {
  const Ball kappa = Ball::exactly(1893) / 10'000;
  return sqr(kappa) * max(max(squares_[0], squares_[1]), squares_[2]) * cosh_ * (1 + radius_);
}

SymmetricForm FlatTriangle::greatest_energy() const { return energy(cotangents_, mean_of_inverse(Ball())); }

SymmetricForm FlatTriangle::least_mass() const {
  const Ball mean = 1 + mean_power_;
  const Ball density = cosh_ / (mean * sqrt(mean));
  const Ball slope = half(Ball::exactly(3)) / mean;
  SymmetricForm result = power_mass(squares_, kCorners, -(density * slope * area_ / 180));
  const Ball constant = density * (1 + slope * mean_power_) * area_ / 12;
  for (Ball& x : result.square) x += twice(constant);
  for (Ball& x : result.product) x += constant;
  return result;
}

}  // namespace epsnet::certify
