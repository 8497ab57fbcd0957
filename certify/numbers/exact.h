#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <flint/fmpz_poly.h>
#include <gmpxx.h>
#include <span>
#include <type_traits>
#include <vector>

#include "certify/base/tile.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"

/// The hyperbolic plane without rounding: points, isometries and predicates over a ring of complex numbers.
///
/// The ring `Number` is the Gaussian integers Z[i] for surfaces with rational tiles, and Z[ζ, s] for regular ones
/// (regular_number.h). It has +, −, ·, products with integers and Gaussian integers, `conjugate`, `twice_real`,
/// `twice_imaginary` and `norm` (which are real), and the `sign` of a real number.
///
/// A point of the Poincaré disk is n/m with n ∈ Z[i], m ∈ Z, m > 0; a moved point is n/d with n, d in the ring. Nothing
/// is divided, so numbers grow with every product: that is for closing up (once per surface) and for ties (rare).
namespace epsnet::certify {

/// re + im·i.
struct Gaussian {
  mpz_class re;
  mpz_class im;
  bool operator==(const Gaussian&) const = default;
};

[[nodiscard]] Gaussian operator+(const Gaussian& x, const Gaussian& y);
[[nodiscard]] Gaussian operator-(const Gaussian& x, const Gaussian& y);
[[nodiscard]] Gaussian operator*(const Gaussian& x, const Gaussian& y);
[[nodiscard]] Gaussian operator*(const mpz_class& x, const Gaussian& y);
[[nodiscard]] Gaussian conjugate(const Gaussian& x);
/// |x|².
[[nodiscard]] mpz_class norm(const Gaussian& x);
[[nodiscard]] inline mpz_class twice_real(const Gaussian& x) { return 2 * x.re; }
[[nodiscard]] inline mpz_class twice_imaginary(const Gaussian& x) { return 2 * x.im; }
[[nodiscard]] inline int sign(const mpz_class& x) { return sgn(x); }

/// The point n/m of the disk, m > 0.
struct ExactPoint {
  Gaussian n;
  mpz_class m;
};

[[nodiscard]] ExactPoint exact_point(const RationalPoint& point);
/// A binary64 is a rational number; x and y are finite.
[[nodiscard]] ExactPoint exact_point(double x, double y);

/// The number of bits of all three integers.
[[nodiscard]] std::size_t bits(const ExactPoint& point);
/// The work of `exact_point` and of a few products and divisors of what it gives.
[[nodiscard]] std::uint64_t exact_point_work(const RationalPoint& point);

/// m² − |n|², positive exactly for points inside the disk.
[[nodiscard]] mpz_class gap(const ExactPoint& point);

/// z ↦ (a z + b)/(b̄ z + ā) with |a| > |b|: an orientation-preserving isometry. Real multiples of (a, b) are the same.
template <class Number>
struct Isometry {
  Number a;
  Number b;
};

using ExactIsometry = Isometry<Gaussian>;

[[nodiscard]] inline ExactIsometry exact_identity() { return {{1, 0}, {0, 0}}; }

/// f ∘ g.
template <class Number>
[[nodiscard]] Isometry<Number> compose(const Isometry<Number>& f, const Isometry<Number>& g) {
  return {f.a * g.a + f.b * conjugate(g.b), f.a * g.b + f.b * conjugate(g.a)};
}

template <class Number>
[[nodiscard]] Isometry<Number> inverse(const Isometry<Number>& f) {
  return {conjugate(f.a), mpz_class(-1) * f.b};
}

/// factor(last − 1) ∘ … ∘ factor(first), first < last, by a balanced tree of products f ∘ g = composed(f, g): exactly,
/// quasi-linear in the size of the result; in balls, with a loss of bits by the logarithm of the number of factors if
/// no product of consecutive ones is large.
template <class Factor, class Composed>
[[nodiscard]] auto compose_range(std::size_t first, std::size_t last, const Factor& factor, const Composed& composed)
    -> std::decay_t<decltype(factor(first))> {
  if (last - first == 1) return factor(first);
  const std::size_t middle = first + (last - first) / 2;
  return composed(compose_range(middle, last, factor, composed), compose_range(first, middle, factor, composed));
}

template <class Factor>
[[nodiscard]] auto compose_range(std::size_t first, std::size_t last, const Factor& factor) {
  return compose_range(first, last, factor, [](const auto& f, const auto& g) { return compose(f, g); });
}

/// z ↦ (z + c)/(1 + c̄z).
[[nodiscard]] ExactIsometry translation_to(const ExactPoint& c);
/// fs.back() ∘ … ∘ fs.front().
[[nodiscard]] ExactIsometry compose_path(std::span<const ExactIsometry* const> fs);
/// The same isometry with the common real divisor of its numbers taken out.
void reduce(ExactIsometry& f);
[[nodiscard]] bool is_identity(const ExactIsometry& f);
/// |a|² − |b|².
[[nodiscard]] mpz_class determinant(const ExactIsometry& f);
/// The number of bits of all four integers.
[[nodiscard]] std::size_t bits(const ExactIsometry& f);

/// The isometry with p ↦ q', q ↦ p', where p ≠ q lie in the disk, p' and q' too, and d(p, q) = d(p', q').
[[nodiscard]] ExactIsometry crossing(const ExactPoint& p, const ExactPoint& q, const ExactPoint& p_other,
                                     const ExactPoint& q_other);

/// The point n/d of the disk, d ≠ 0.
template <class Number>
struct MovedPoint {
  Number n;
  Number d;
};

template <class Number>
[[nodiscard]] MovedPoint<Number> moved(const Isometry<Number>& f, const ExactPoint& z) {
  return {z.n * f.a + z.m * f.b, z.n * conjugate(f.b) + z.m * conjugate(f.a)};
}

[[nodiscard]] inline MovedPoint<Gaussian> moved(const ExactPoint& z) { return {z.n, {z.m, 0}}; }

/// A positive multiple of the point of the hyperboloid model: (2x, 2y, 1 + |z|²).
template <class Real>
struct HyperboloidVector {
  Real x;
  Real y;
  Real t;
};

[[nodiscard]] inline HyperboloidVector<mpz_class> hyperboloid_vector(const ExactPoint& z) {
  return {2 * z.m * z.n.re, 2 * z.m * z.n.im, norm(z.n) + z.m * z.m};
}

template <class Number>
[[nodiscard]] auto hyperboloid_vector(const MovedPoint<Number>& z) {
  const Number product = z.n * conjugate(z.d);
  using Real = decltype(norm(product));
  return HyperboloidVector<Real>{twice_real(product), twice_imaginary(product), norm(z.n) + norm(z.d)};
}

template <class Real>
[[nodiscard]] Real determinant(const HyperboloidVector<Real>& u, const HyperboloidVector<Real>& v,
                               const HyperboloidVector<Real>& w) {
  return u.x * (v.y * w.t - v.t * w.y) - u.y * (v.x * w.t - v.t * w.x) + u.t * (v.x * w.y - v.y * w.x);
}

/// 1 if the hyperbolic triangle is strictly counterclockwise, −1 if strictly clockwise, 0 if a geodesic contains the
/// three points. Determinant of the three points as vectors of the hyperboloid model, up to scale.
template <class Real>
[[nodiscard]] int orientation(const HyperboloidVector<Real>& u, const HyperboloidVector<Real>& v,
                              const HyperboloidVector<Real>& w) {
  return sign(determinant(u, v, w));
}

template <class Number>
[[nodiscard]] int orientation(const MovedPoint<Number>& z0, const MovedPoint<Number>& z1,
                              const MovedPoint<Number>& z2) {
  return orientation(hyperboloid_vector(z0), hyperboloid_vector(z1), hyperboloid_vector(z2));
}

/// The sign of Im (z3−z1)(z2−z0)/((z3−z0)(z2−z1)): the edge z0 z2 with z1 on its right and z3 on its left is not
/// Delaunay if and only if it is positive, and the four points are cocircular if and only if it is 0 (thesis, Theorems
/// I.41 and I.42). The four points are pairwise different except that z1 = z3 is allowed.
template <class Number>
[[nodiscard]] int cross_ratio_sign(const std::array<MovedPoint<Number>, 4>& z) {
  // z_i − z_j = (n_i d_j − n_j d_i)/(d_i d_j), and the denominators cancel in the cross-ratio.
  const auto difference = [&](std::size_t i, std::size_t j) -> Number { return z[i].n * z[j].d - z[j].n * z[i].d; };
  const Number numerator = difference(3, 1) * difference(2, 0);
  const Number denominator = difference(3, 0) * difference(2, 1);
  return sign(twice_imaginary(numerator * conjugate(denominator)));
}

// Polynomials, of which the rings of regular tiles and of number fields are made.

struct PolynomialType {
  using Struct = fmpz_poly_struct;
  static void init(Struct* x) { fmpz_poly_init(x); }
  static void set(Struct* x, const Struct* y) { fmpz_poly_set(x, y); }
  static void swap(Struct* x, Struct* y) { fmpz_poly_swap(x, y); }
  static void clear(Struct* x) { fmpz_poly_clear(x); }
};

/// A polynomial over ℤ.
using Polynomial = Owner<PolynomialType>;

[[nodiscard]] inline bool is_zero(const Polynomial& x) { return fmpz_poly_is_zero(x.get()) != 0; }

[[nodiscard]] inline bool are_equal(const Polynomial& x, const Polynomial& y) {
  return fmpz_poly_equal(x.get(), y.get()) != 0;
}

/// The most bits of a coefficient.
[[nodiscard]] inline std::uint64_t bits_of_coefficients(const Polynomial& x) {
  return static_cast<std::uint64_t>(std::abs(fmpz_poly_max_bits(x.get())));
}

[[nodiscard]] inline Polynomial sum(Polynomial x, Polynomial y) {
  if (is_zero(x)) return y;
  if (!is_zero(y)) fmpz_poly_add(x.get(), x.get(), y.get());
  return x;
}

[[nodiscard]] inline Polynomial negative(Polynomial x) {
  fmpz_poly_neg(x.get(), x.get());
  return x;
}

[[nodiscard]] inline Polynomial multiple(const mpz_class& x, const Polynomial& y) {
  Polynomial result;
  fmpz_poly_scalar_mul_fmpz(result.get(), y.get(), Integer(x).get());
  return result;
}

}  // namespace epsnet::certify
