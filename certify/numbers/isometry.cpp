#include "certify/numbers/isometry.h"

namespace epsnet::certify {
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

BallIsometry inverse(const BallIsometry& f) {
  BallIsometry result;
  acb_conj(result.a.get(), f.a.get());
  acb_neg(result.b.get(), f.b.get());
  return result;
}

BallIsometry to_balls(const ExactIsometry& f, slong precision) {
  BallIsometry result;
  Ball scale;
  set_integer(scale.get(), determinant(f), precision);
  arb_rsqrt(scale.get(), scale.get(), precision);
  set_integer(result.a.re(), f.a.re, precision);
  set_integer(result.a.im(), f.a.im, precision);
  set_integer(result.b.re(), f.b.re, precision);
  set_integer(result.b.im(), f.b.im, precision);
  acb_mul_arb(result.a.get(), result.a.get(), scale.get(), precision);
  acb_mul_arb(result.b.get(), result.b.get(), scale.get(), precision);
  return result;
}

void half_displacement_squared(arb_ptr result, const BallIsometry& f, slong precision) {
  // arb_sqr squares one ball, so the result is never below 0 by more than rounding.
  Ball square;
  arb_sqr(result, f.b.re(), precision);
  arb_sqr(square.get(), f.b.im(), precision);
  arb_add(result, result, square.get(), precision);
}

}  // namespace epsnet::certify
