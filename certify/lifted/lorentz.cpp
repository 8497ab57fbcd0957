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
  arb_add(m.rows[0][0], a2.re(), b2.re(), precision);
  arb_sub(m.rows[0][1], b2.im(), a2.im(), precision);
  arb_mul_2exp_si(m.rows[0][2], ab.re(), 1);
  arb_add(m.rows[1][0], a2.im(), b2.im(), precision);
  arb_sub(m.rows[1][1], a2.re(), b2.re(), precision);
  arb_mul_2exp_si(m.rows[1][2], ab.im(), 1);
  arb_mul_2exp_si(m.rows[2][0], a_conj_b.re(), 1);
  arb_mul_2exp_si(m.rows[2][1], a_conj_b.im(), 1);
  arb_neg(m.rows[2][1], m.rows[2][1]);
  // |a|² + |b|² = 1 + 2|b|².
  half_displacement_squared(m.rows[2][2], f, precision);
  arb_mul_2exp_si(m.rows[2][2], m.rows[2][2], 1);
  arb_add_ui(m.rows[2][2], m.rows[2][2], 1, precision);
  return m;
}

BallVector apply(const BallMatrix& m, const BallVector& x, slong precision) {
  BallVector result;
  for (std::size_t i = 0; i < 3; ++i) dot(result[i], m.rows[i], x, precision);
  return result;
}

BallVector unit_vector(const BallIsometry& label, double x, double y, slong precision) {
  BallVector z;
  Ball gap, square;
  arb_set_d(z[0], x);
  arb_set_d(z[1], y);
  arb_sqr(gap.get(), z[0], precision);
  arb_sqr(square.get(), z[1], precision);
  arb_add(gap.get(), gap.get(), square.get(), precision);
  arb_add_ui(z[2], gap.get(), 1, precision);
  arb_sub_ui(gap.get(), gap.get(), 1, precision);
  arb_neg(gap.get(), gap.get());
  for (std::size_t i = 0; i < 2; ++i) arb_mul_2exp_si(z[i], z[i], 1);
  for (std::size_t i = 0; i < 3; ++i) arb_div(z[i], z[i], gap.get(), precision);
  return apply(lorentz_matrix(label, precision), z, precision);
}

void choose_sign(BallIsometry& f) {
  if (certainly_negative(f.a.re()) != Tri::yes) return;
  acb_neg(f.a.get(), f.a.get());
  acb_neg(f.b.get(), f.b.get());
}

Ball cosh_half_length(const BallIsometry& f) {
  Ball result;
  arb_abs(result.get(), f.a.re());
  return result;
}

BallVector axis_row(const BallIsometry& f, slong precision) {
  // The traceless part of f, (i Im a, b), is the image of the vector (−Im b, Re b, Im a), of Lorentz square sinh²(l/2)
  // = (Re a)² − 1.
  Ball scale;
  arb_sqr(scale.get(), f.a.re(), precision);
  arb_sub_ui(scale.get(), scale.get(), 1, precision);
  arb_rsqrt(scale.get(), scale.get(), precision);
  BallVector row;
  arb_neg(row[0], f.b.im());
  arb_set(row[1], f.b.re());
  arb_neg(row[2], f.a.im());
  for (std::size_t i = 0; i < 3; ++i) arb_mul(row[i], row[i], scale.get(), precision);
  return row;
}

}  // namespace epsnet::certify
