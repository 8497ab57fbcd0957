#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "certify/claims/geodesics/double_double.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/precision.h"

/// Cones of functionals by rays on their boundaries, for balls and for numbers of twice the length of binary64
/// (docs/proof.md, Lemma 14).
namespace epsnet::certify {

/// By its values at three points.
template <class Number>
using Functional = std::array<Number, 3>;

/// x₀y₀ + x₁y₁ + …
template <std::size_t N>
[[nodiscard]] Ball sum_of_products(const std::array<Ball, N>& x, const std::array<Ball, N>& y) {
  Ball result;
  arb_dot(result.get(), nullptr, 0, x[0].get(), 1, y[0].get(), 1, N, Precision::bits());
  return result;
}

/// The ray between two on which the third value vanishes; that has different signs at the two.
template <class Number>
[[nodiscard]] Functional<Number> meeting(const Functional<Number>& x, const Functional<Number>& y) {
  const bool positive = certain_sign(x[2]) > 0;
  const std::array<Number, 2> weights{positive ? -y[2] : y[2], positive ? x[2] : -x[2]};
  Functional<Number> result;
  for (std::size_t i = 0; i < 2; ++i) result[i] = sum_of_products(weights, std::array<Number, 2>{x[i], y[i]});
  return result;
}

/// Adds to `part` rays of a cone that contains all functionals of the given one, whose rays are in cyclic order, of
/// which the third value is 0 or has the sign `wanted`, 1 or −1; none only if there certainly are no such functionals.
/// `sides` is only used on the way.
template <class Number>
void clip_cone(std::span<const Functional<Number>> rays, int wanted, std::vector<int>& sides,
               std::vector<Functional<Number>>& part) {
  const std::size_t count = rays.size();
  sides.resize(count);
  for (std::size_t i = 0; i < count; ++i) sides[i] = wanted * certain_sign(rays[i][2]);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i == 0 ? count - 1 : i - 1;
    const std::size_t after = i + 1 == count ? 0 : i + 1;
    // One that is certainly out, next to one of which that is not known: the edge between may be partly in.
    if (sides[i] >= 0 || sides[before] == 0 || sides[after] == 0) part.push_back(rays[i]);
    if (sides[i] * sides[after] < 0) part.push_back(meeting(rays[i], rays[after]));
  }
}

}  // namespace epsnet::certify
