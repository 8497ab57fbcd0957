#pragma once

#include <gmpxx.h>
#include <utility>

/// Points of the disk and isometries, exactly: R is a ring of real numbers, the integers for rational tiles, Algebraic
/// for regular ones, and FieldNumber for tiles over a number field.
namespace epsnet::exact {

// Integers that divide a number, and its size; the other rings have the same functions.

inline void take_common(const mpz_class& x, mpz_class& common) { common = gcd(common, x); }
inline void divide(mpz_class& x, const mpz_class& divisor) { x /= divisor; }
inline std::size_t bits(const mpz_class& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); }

/// Divides numbers by the integers that divide all of them.
template <class... R>
void reduce(R&... x) {
  mpz_class common;
  (take_common(x, common), ...);
  if (common > 1) (divide(x, common), ...);
}

template <class R>
struct Complex {
  R re;
  R im;

  friend Complex operator+(const Complex& x, const Complex& y) { return {x.re + y.re, x.im + y.im}; }
  friend Complex operator-(const Complex& x, const Complex& y) { return {x.re - y.re, x.im - y.im}; }
  friend Complex operator-(const Complex& x) { return {-x.re, -x.im}; }
  friend Complex operator*(const Complex& x, const Complex& y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend Complex operator*(const R& n, const Complex& x) { return {n * x.re, n * x.im}; }
  friend Complex conjugate(const Complex& x) { return {x.re, -x.im}; }
  friend R norm(const Complex& x) { return x.re * x.re + x.im * x.im; }
  friend bool is_zero(const Complex& x) { return sgn(x.re) == 0 && sgn(x.im) == 0; }
  friend std::size_t bits(const Complex& x) { return bits(x.re) + bits(x.im); }
};

/// The point n/m of the complex plane, m > 0.
template <class R>
struct Point {
  Complex<R> n;
  R m;

  /// m² − |n|²: positive inside of the disk.
  friend R gap(const Point& z) { return z.m * z.m - norm(z.n); }
  /// |z − w|² times the squares of both denominators.
  friend R squared_difference(const Point& z, const Point& w) { return norm(w.m * z.n - z.m * w.n); }
  friend std::size_t bits(const Point& z) { return bits(z.n) + bits(z.m); }
};

/// The same point, in a larger ring.
template <class R>
Point<R> point(const Point<mpz_class>& z) {
  return {{R(z.n.re), R(z.n.im)}, R(z.m)};
}

template <class R>
Point<R> lowest_terms(Complex<R> n, R m) {
  reduce(n.re, n.im, m);
  return {std::move(n), std::move(m)};
}

/// A vector of Minkowski space up to a positive factor. If t > 0 and N = t² − x² − y² > 0, it is the point (x + iy)/(t
/// + √N) of the disk.
template <class R>
struct MinkowskiVector {
  R x;
  R y;
  R t;

  friend R lorentz_product(const MinkowskiVector& u, const MinkowskiVector& v) {
    return u.x * v.x + u.y * v.y - u.t * v.t;
  }
  /// Positive for points in counterclockwise order.
  friend R determinant(const MinkowskiVector& u, const MinkowskiVector& v, const MinkowskiVector& w) {
    const auto minor = [](const MinkowskiVector& p, const MinkowskiVector& q) { return R(p.x * q.y - p.y * q.x); };
    return minor(u, v) * w.t + minor(v, w) * u.t + minor(w, u) * v.t;
  }
  /// Of vectors with t != 0: whether one is a multiple of the other.
  friend bool are_parallel(const MinkowskiVector& u, const MinkowskiVector& v) {
    return sgn(R(u.x * v.t - u.t * v.x)) == 0 && sgn(R(u.y * v.t - u.t * v.y)) == 0;
  }
  friend std::size_t bits(const MinkowskiVector& v) { return bits(v.x) + bits(v.y) + bits(v.t); }
};

/// (2 Re z, 2 Im z, 1 + |z|²) m².
template <class R>
MinkowskiVector<R> minkowski_vector(const Point<R>& z) {
  return {2 * z.m * z.n.re, 2 * z.m * z.n.im, z.m * z.m + norm(z.n)};
}

/// Positive for counterclockwise.
template <class R>
R area(const Point<R>& u, const Point<R>& v, const Point<R>& w) {
  return determinant(minkowski_vector(u), minkowski_vector(v), minkowski_vector(w));
}

/// z ↦ (az + b)/(b̄z + ā), |a| > |b|; real multiples are the same.
template <class R>
struct Isometry {
  Complex<R> a{R(1), R(0)};
  Complex<R> b{R(0), R(0)};

  friend Isometry compose(const Isometry& f, const Isometry& g) {
    return {f.a * g.a + f.b * conjugate(g.b), f.a * g.b + f.b * conjugate(g.a)};
  }
  friend Isometry inverse(const Isometry& f) { return {conjugate(f.a), -f.b}; }
  friend void reduce(Isometry& f) { reduce(f.a.re, f.a.im, f.b.re, f.b.im); }
  friend bool is_identity(const Isometry& f) { return sgn(f.a.im) == 0 && is_zero(f.b); }
  /// Real multiples of each other have parallel a, which is less to compute than f⁻¹g.
  friend bool are_equal(const Isometry& f, const Isometry& g) {
    return sgn(R(f.a.re * g.a.im - f.a.im * g.a.re)) == 0 && is_identity(compose(inverse(f), g));
  }
  friend std::size_t bits(const Isometry& f) { return bits(f.a) + bits(f.b); }
};

/// Lemma 9.4: the vector of the image.
template <class R>
MinkowskiVector<R> image(const Isometry<R>& f, const MinkowskiVector<R>& v) {
  const Complex<R> w{v.x, v.y};
  const Complex<R> z = f.a * f.a * w + R(2 * v.t) * (f.a * f.b) + f.b * f.b * conjugate(w);
  return {z.re, z.im, (norm(f.a) + norm(f.b)) * v.t + 2 * (f.a * conjugate(f.b) * w).re};
}

/// z ↦ (z + c)/(1 + c̄z).
template <class R>
Isometry<R> translation_to(const Point<R>& c) {
  return {{c.m, R(0)}, c.n};
}

}  // namespace epsnet::exact
