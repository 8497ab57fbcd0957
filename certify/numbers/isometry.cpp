#include "certify/numbers/isometry.h"

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

namespace {

/// a·b + c·conj(d).
void multiply_add(acb_ptr result, acb_srcptr a, acb_srcptr b, acb_srcptr c, acb_srcptr d, slong precision) {
  ComplexBall conjugate_d;
  acb_conj(conjugate_d.get(), d);
  acb_mul(result, a, b, precision);
  acb_addmul(result, c, conjugate_d.get(), precision);
}

}  // namespace

BallIsometry identity_isometry() {
  BallIsometry f;
  acb_one(f.a.get());
  return f;
}

BallIsometry compose(const BallIsometry& f, const BallIsometry& g, slong precision) {
  BallIsometry result;
  multiply_add(result.a.get(), f.a.get(), g.a.get(), f.b.get(), g.b.get(), precision);
  multiply_add(result.b.get(), f.a.get(), g.b.get(), f.b.get(), g.a.get(), precision);
  return result;
}

BallIsometry inverse(const BallIsometry& f) { return {conjugate(f.a), -f.b}; }

BallIsometry to_balls(const ExactIsometry& f, slong precision) {
  const Precision scope(precision);
  const Ball scale = rsqrt(Ball::rounded(determinant(f)));
  const auto scaled = [&](const Gaussian& z) { return scale * ComplexBall(Ball::rounded(z.re), Ball::rounded(z.im)); };
  return {scaled(f.a), scaled(f.b)};
}

namespace {

Ball cosh_of_apothem(RegularTile tile) {
  return real(root_of_unity(1, 2 * tile.q)) / imaginary(root_of_unity(1, 2 * tile.p));
}

}  // namespace

BallIsometry regular_crossing(RegularTile tile, std::uint32_t k, std::uint32_t l, slong precision) {
  const Precision scope(precision);
  const Ball cosh = cosh_of_apothem(tile);
  if (l < k) l += tile.p;
  // As powers of e^{iπ/(2p)}, where i is the p-th.
  const std::uint32_t order = 4 * tile.p;
  return {cosh * root_of_unity((order + 2 * l - 2 * k - tile.p) % order, order),
          sqrt(sqr(cosh) - 1) * root_of_unity((2 * l + 2 * k + tile.p) % order, order)};
}

Ball sinh_of_apothem(RegularTile tile, slong precision) {
  const Precision scope(precision);
  return sqrt(sqr(cosh_of_apothem(tile)) - 1);
}

void half_displacement_squared(arb_ptr result, const BallIsometry& f, slong precision) {
  Ball square;
  arb_sqr(result, f.b.re(), precision);
  arb_sqr(square.get(), f.b.im(), precision);
  arb_add(result, result, square.get(), precision);
}

}  // namespace epsnet::certify
