#include "certify/numbers/ball_vector.h"

namespace epsnet::certify {

BallVector cross_product(const BallVector& u, const BallVector& v, slong precision) {
  BallVector result;
  Ball product;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    arb_mul(result[i].get(), u[j].get(), v[k].get(), precision);
    arb_mul(product.get(), u[k].get(), v[j].get(), precision);
    arb_sub(result[i].get(), result[i].get(), product.get(), precision);
  }
  return result;
}

Ball lorentz_product(const BallVector& u, const BallVector& v, slong precision) {
  Ball result, last;
  arb_mul(last.get(), u[2].get(), v[2].get(), precision);
  arb_neg(last.get(), last.get());
  arb_dot(result.get(), last.get(), 0, u[0].get(), 1, v[0].get(), 1, 2, precision);
  return result;
}

}  // namespace epsnet::certify
