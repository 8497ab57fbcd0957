#include "certify/lifted/lorentz.h"

namespace epsnet::certify {

BallMatrix lorentz_matrix(const BallIsometry& f, slong precision) {
  // With w = 2z and t = 1 + |z|²: w' = a² w + b² w̄ + 2ab t, t' = 2 Re(a b̄ w) + (|a|² + |b|²) t.
  ComplexBall a2, b2, ab, a_conj_b;
  acb_sqr(a2.get(), f.a.get(), precision);
  acb_sqr(b2.get(), f.b.get(), precision);
  acb_mul(ab.get(), f.a.get(), f.b.get(), precision);
  acb_conj(a_conj_b.get(), f.b.get());
  acb_mul(a_conj_b.get(), a_conj_b.get(), f.a.get(), precision);
  BallMatrix m;
  arb_add(m[0][0].get(), a2.re(), b2.re(), precision);
  arb_sub(m[0][1].get(), b2.im(), a2.im(), precision);
  arb_mul_2exp_si(m[0][2].get(), ab.re(), 1);
  arb_add(m[1][0].get(), a2.im(), b2.im(), precision);
  arb_sub(m[1][1].get(), a2.re(), b2.re(), precision);
  arb_mul_2exp_si(m[1][2].get(), ab.im(), 1);
  arb_mul_2exp_si(m[2][0].get(), a_conj_b.re(), 1);
  arb_mul_2exp_si(m[2][1].get(), a_conj_b.im(), 1);
  arb_neg(m[2][1].get(), m[2][1].get());
  // |a|² + |b|² = 1 + 2|b|².
  arb_ptr last = m[2][2].get();
  half_displacement_squared(last, f, precision);
  arb_mul_2exp_si(last, last, 1);
  arb_add_ui(last, last, 1, precision);
  return m;
}

BallVector apply(const BallMatrix& m, const BallVector& x, slong precision) {
  BallVector result;
  for (std::size_t i = 0; i < 3; ++i) dot(result[i], m[i], x, precision);
  return result;
}

BallVector unit_vector(const BallIsometry& label, double x, double y, slong precision) {
  const Precision scope(precision);
  const Ball re = Ball::exactly(x);
  const Ball im = Ball::exactly(y);
  const Ball norm = sqr(re) + sqr(im);
  const Ball gap = 1 - norm;
  return apply(lorentz_matrix(label, precision), {twice(re) / gap, twice(im) / gap, (norm + 1) / gap}, precision);
}

void choose_sign(BallIsometry& f) {
  if (certainly_negative(real(f.a)) == Tri::yes) f = {-f.a, -f.b};
}

Ball cosh_half_length(const BallIsometry& f) { return abs(real(f.a)); }

BallVector traceless_row(const BallIsometry& f) { return {-imaginary(f.b), real(f.b), -imaginary(f.a)}; }

BallVector axis_row(const BallIsometry& f, slong precision) {
  // Of Lorentz square sinh²(l/2) = (Re a)² − 1.
  const Precision scope(precision);
  const Ball scale = rsqrt(sqr(real(f.a)) - 1);
  BallVector row = traceless_row(f);
  for (Ball& x : row) x = x * scale;
  return row;
}

}  // namespace epsnet::certify
