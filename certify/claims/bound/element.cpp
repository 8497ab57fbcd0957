#include "certify/claims/bound/element.h"

#include <utility>

namespace epsnet::certify {

Element element_of(BallIsometry isometry, slong precision) {
  Element result;
  arb_neg(result.normal_row[0], isometry.b.im());
  arb_set(result.normal_row[1], isometry.b.re());
  arb_neg(result.normal_row[2], isometry.a.im());
  Ball im_square;
  half_displacement_squared(result.square.get(), isometry, precision);
  arb_sqr(im_square.get(), isometry.a.im(), precision);
  arb_sub(result.square.get(), result.square.get(), im_square.get(), precision);
  result.isometry = std::move(isometry);
  return result;
}

void set_displacement(arb_ptr result, const Element& element, const BallVector& p, slong precision) {
  dot(result, element.normal_row, p, precision);
  arb_sqr(result, result, precision);
  arb_add(result, result, element.square.get(), precision);
}

}  // namespace epsnet::certify
