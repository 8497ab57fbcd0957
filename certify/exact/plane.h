#pragma once

#include <gmpxx.h>
#include <utility>

/// Points of the disk with rational coordinates and isometries with Gaussian integers as entries, exactly.
namespace epsnet::exact {

struct Gaussian {
  mpz_class re;
  mpz_class im;
};

inline Gaussian operator+(const Gaussian& x, const Gaussian& y) { return {x.re + y.re, x.im + y.im}; }
inline Gaussian operator-(const Gaussian& x, const Gaussian& y) { return {x.re - y.re, x.im - y.im}; }
inline Gaussian operator-(const Gaussian& x) { return {-x.re, -x.im}; }
inline Gaussian operator*(const Gaussian& x, const Gaussian& y) {
  return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}
inline Gaussian operator*(const mpz_class& n, const Gaussian& x) { return {n * x.re, n * x.im}; }
inline Gaussian conjugate(const Gaussian& x) { return {x.re, -x.im}; }
inline mpz_class norm(const Gaussian& x) { return x.re * x.re + x.im * x.im; }

/// The point n/m of the complex plane, m > 0.
struct Point {
  Gaussian n;
  mpz_class m;
};

inline Point lowest_terms(Gaussian n, mpz_class m) {
  mpz_class common = gcd(gcd(n.re, n.im), m);
  if (common > 1) {
    for (mpz_class* x : {&n.re, &n.im, &m}) *x /= common;
  }
  return {std::move(n), std::move(m)};
}

/// m² − |n|²: positive inside of the disk.
inline mpz_class gap(const Point& z) { return z.m * z.m - norm(z.n); }

/// |z − w|² times the squares of both denominators.
inline mpz_class squared_difference(const Point& z, const Point& w) { return norm(w.m * z.n - z.m * w.n); }

/// The sign of det(X(u), X(v), X(w)), X(z) = (2 Re z, 2 Im z, 1 + |z|²): 1 for counterclockwise.
inline int orientation(const Point& u, const Point& v, const Point& w) {
  const auto last = [](const Point& z) { return mpz_class(z.m * z.m + norm(z.n)); };
  const auto minor = [](const Point& z, const Point& other) {
    return mpz_class((z.n.re * other.n.im - z.n.im * other.n.re) * z.m * other.m);
  };
  return sgn(mpz_class(minor(u, v) * last(w) + minor(v, w) * last(u) + minor(w, u) * last(v)));
}

/// z ↦ (az + b)/(b̄z + ā), |a| > |b|; real multiples are the same.
struct Isometry {
  Gaussian a{1, 0};
  Gaussian b{0, 0};
};

inline Isometry compose(const Isometry& f, const Isometry& g) {
  return {f.a * g.a + f.b * conjugate(g.b), f.a * g.b + f.b * conjugate(g.a)};
}

inline Isometry inverse(const Isometry& f) { return {conjugate(f.a), -f.b}; }

inline void reduce(Isometry& f) {
  const mpz_class common = gcd(gcd(f.a.re, f.a.im), gcd(f.b.re, f.b.im));
  if (common <= 1) return;
  for (mpz_class* x : {&f.a.re, &f.a.im, &f.b.re, &f.b.im}) *x /= common;
}

inline bool is_identity(const Isometry& f) { return f.a.im == 0 && f.b.re == 0 && f.b.im == 0; }

/// z ↦ (z + c)/(1 + c̄z).
inline Isometry translation_to(const Point& c) { return {{c.m, 0}, c.n}; }

inline std::size_t bits(const mpz_class& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); }
inline std::size_t bits(const Gaussian& x) { return bits(x.re) + bits(x.im); }
inline std::size_t bits(const Isometry& f) { return bits(f.a) + bits(f.b); }
inline std::size_t bits(const Point& z) { return bits(z.n) + bits(z.m); }

}  // namespace epsnet::exact
