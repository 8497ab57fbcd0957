#pragma once

#include <gmpxx.h>
#include <utility>

/// Points of the disk and isometries, exactly: R is a ring of real numbers, the integers for rational tiles and
/// Algebraic for regular ones.
namespace epsnet::exact {

// Integers that divide a number, and its size; Algebraic has the same functions.

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

/// The sign of det(X(u), X(v), X(w)), X(z) = (2 Re z, 2 Im z, 1 + |z|²): 1 for counterclockwise.
template <class R>
int orientation(const Point<R>& u, const Point<R>& v, const Point<R>& w) {
  const auto last = [](const Point<R>& z) { return R(z.m * z.m + norm(z.n)); };
  const auto minor = [](const Point<R>& z, const Point<R>& other) {
    return R((z.n.re * other.n.im - z.n.im * other.n.re) * z.m * other.m);
  };
  return sgn(R(minor(u, v) * last(w) + minor(v, w) * last(u) + minor(w, u) * last(v)));
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

/// z ↦ (z + c)/(1 + c̄z).
template <class R>
Isometry<R> translation_to(const Point<R>& c) {
  return {{c.m, R(0)}, c.n};
}

}  // namespace epsnet::exact
