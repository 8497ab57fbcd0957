#pragma once

#include "tests/assurance/file_mutants/numbers.h"

/// The hyperbolic plane over an exact ring F: points n/d of the disk as pairs of complex numbers, isometries up to real
/// factors. There are no divisions.
namespace epsnet::attack {

template <class F>
struct Complex {
  F re{0};
  F im{0};
  friend Complex operator+(const Complex& x, const Complex& y) { return {F(x.re + y.re), F(x.im + y.im)}; }
  friend Complex operator-(const Complex& x, const Complex& y) { return {F(x.re - y.re), F(x.im - y.im)}; }
  friend Complex operator-(const Complex& x) { return {F(-x.re), F(-x.im)}; }
  friend Complex operator*(const Complex& x, const Complex& y) {
    return {F(x.re * y.re - x.im * y.im), F(x.re * y.im + x.im * y.re)};
  }
};
template <class F>
[[nodiscard]] Complex<F> conj(const Complex<F>& x) {
  return {x.re, F(-x.im)};
}
template <class F>
[[nodiscard]] F norm(const Complex<F>& x) {
  return F(x.re * x.re + x.im * x.im);
}

/// Divides two complex numbers by their common integer factors.
template <class F>
void reduce(Complex<F>& x, Complex<F>& y) {
  mpz_class content = 0;
  for (const F* n : {&x.re, &x.im, &y.re, &y.im}) take_content(*n, content);
  if (content <= 1) return;
  for (F* n : {&x.re, &x.im, &y.re, &y.im}) divide(*n, content);
}

/// n/d.
template <class F>
struct Point {
  Complex<F> n;
  Complex<F> d;
};
/// (1 − |z|²)|d|².
template <class F>
[[nodiscard]] F gap(const Point<F>& z) {
  return F(norm(z.d) - norm(z.n));
}
/// Returns (z − w) times both denominators.
template <class F>
[[nodiscard]] Complex<F> difference(const Point<F>& z, const Point<F>& w) {
  return z.n * w.d - w.n * z.d;
}

/// z ↦ (az + b)/(b̄z + ā).
template <class F>
struct Isometry {
  Complex<F> a{F(1), F(0)};
  Complex<F> b{};
  Point<F> operator()(const Point<F>& z) const { return {a * z.n + b * z.d, conj(b) * z.n + conj(a) * z.d}; }
};
/// Returns the composition: first g, then f.
template <class F>
[[nodiscard]] Isometry<F> operator*(const Isometry<F>& f, const Isometry<F>& g) {
  Isometry<F> h{f.a * g.a + f.b * conj(g.b), f.a * g.b + f.b * conj(g.a)};
  reduce(h.a, h.b);
  return h;
}
template <class F>
[[nodiscard]] Isometry<F> inverse(const Isometry<F>& f) {
  return {conj(f.a), -f.b};
}
template <class F>
[[nodiscard]] bool is_identity(const Isometry<F>& f) {
  return sign(f.b.re) == 0 && sign(f.b.im) == 0 && sign(f.a.im) == 0;
}
template <class F>
[[nodiscard]] bool same(const Isometry<F>& f, const Isometry<F>& g) {
  return is_identity(inverse(f) * g);
}
/// |a|² − |b|².
template <class F>
[[nodiscard]] F determinant(const Isometry<F>& f) {
  return F(norm(f.a) - norm(f.b));
}
/// 1 if u, v, w are counterclockwise: with u moved to 0, the angle from v to w is in (0, π).
template <class F>
[[nodiscard]] int turn(const Point<F>& u, const Point<F>& v, const Point<F>& w) {
  const auto moved = [&](const Point<F>& z) {  // p/q, up to a rotation by what is the same for v and w.
    return difference(z, u) * conj(Complex<F>(conj(u.d) * z.d - conj(u.n) * z.n));
  };
  return sign((conj(moved(v)) * moved(w)).im);
}

/// The functional of the axis of g at z, times 1 − |z|² and |d|²: positive on its left if Re a > 0.
template <class F>
[[nodiscard]] F side_of_axis(const Isometry<F>& g, const Point<F>& z) {
  const F twice = (conj(g.b) * z.n * conj(z.d)).im;
  return F(twice + twice - (norm(z.d) + norm(z.n)) * g.a.im);
}

}  // namespace epsnet::attack
