#include "certify/numbers/ball_vector.h"

namespace epsnet::certify {

BallVector cross_product(const BallVector& u, const BallVector& v, slong precision) {
  BallVector result;
  Ball product;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    arb_mul(result[i], u[j], v[k], precision);
    arb_mul(product.get(), u[k], v[j], precision);
    arb_sub(result[i], result[i], product.get(), precision);
  }
  return result;
}

void lorentz_product(arb_ptr result, const BallVector& u, const BallVector& v, slong precision) {
  Ball last;
  arb_mul(last.get(), u[2], v[2], precision);
  arb_neg(last.get(), last.get());
  arb_dot(result, last.get(), 0, u[0], 1, v[0], 1, 2, precision);
}

}  // namespace epsnet::certify
