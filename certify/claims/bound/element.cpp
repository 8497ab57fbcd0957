#include "certify/claims/bound/element.h"

#include <utility>

#include "certify/lifted/lorentz.h"

namespace epsnet::certify {

Element element_of(BallIsometry isometry, slong precision) {
  const Precision scope(precision);
  BallVector row = traceless_row(isometry);
  Ball square = norm(isometry.b) - sqr(imaginary(isometry.a));
  return {std::move(isometry), std::move(row), std::move(square)};
}

Ball displacement(const Element& element, const BallVector& p, slong precision) {
  Ball result;
  dot(result, element.normal_row, p, precision);
  arb_sqr(result.get(), result.get(), precision);
  arb_add(result.get(), result.get(), element.square.get(), precision);
  return result;
}

}  // namespace epsnet::certify
