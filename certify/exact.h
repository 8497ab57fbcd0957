#pragma once

#include <epsnet/certify/document.h>
#include <gmpxx.h>

#include <array>
#include <span>
#include <vector>

/// The hyperbolic plane over the Gaussian integers Z[i]: points, isometries and predicates without rounding.
///
/// A point of the Poincaré disk is n/m with n ∈ Z[i], m ∈ Z, m > 0; a moved point is n/d with n, d ∈ Z[i]. Nothing is
/// divided, so numbers grow with every product: that is for closing up (once per surface) and for ties (rare).
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

/// The point n/m of the disk, m > 0.
struct ExactPoint {
  Gaussian n;
  mpz_class m;
};

[[nodiscard]] ExactPoint exact_point(const RationalPoint& point);
/// A binary64 is a rational number; x and y are finite.
[[nodiscard]] ExactPoint exact_point(double x, double y);

/// m² − |n|², positive exactly for points inside the disk.
[[nodiscard]] mpz_class gap(const ExactPoint& point);

/// z ↦ (a z + b)/(b̄ z + ā) with |a| > |b|: an orientation-preserving isometry. Real multiples of (a, b) are the same.
struct ExactIsometry {
  Gaussian a{1, 0};
  Gaussian b{0, 0};
};

/// f ∘ g.
[[nodiscard]] ExactIsometry compose(const ExactIsometry& f, const ExactIsometry& g);
[[nodiscard]] ExactIsometry inverse(const ExactIsometry& f);
/// z ↦ (z + c)/(1 + c̄z).
[[nodiscard]] ExactIsometry translation_to(const ExactPoint& c);
/// fs.back() ∘ … ∘ fs.front(), by a balanced tree of products: quasi-linear in the size of the result.
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
struct MovedPoint {
  Gaussian n;
  Gaussian d;
};

[[nodiscard]] MovedPoint moved(const ExactIsometry& f, const ExactPoint& z);
[[nodiscard]] MovedPoint moved(const ExactPoint& z);

/// 1 if the hyperbolic triangle is strictly counterclockwise, −1 if strictly clockwise, 0 if a geodesic contains the
/// three points. Determinant of the three points as vectors (2z, 1 + |z|²) of the hyperboloid model, up to scale.
[[nodiscard]] int orientation(const MovedPoint& z0, const MovedPoint& z1, const MovedPoint& z2);
[[nodiscard]] int orientation(const ExactPoint& z0, const ExactPoint& z1, const ExactPoint& z2);

/// The sign of Im (z3−z1)(z2−z0)/((z3−z0)(z2−z1)): the edge z0 z2 with z1 on its right and z3 on its left is not
/// Delaunay if and only if it is positive, and the four points are cocircular if and only if it is 0 (thesis, Theorems
/// I.41 and I.42). The four points are pairwise different except that z1 = z3 is allowed.
[[nodiscard]] int cross_ratio_sign(const std::array<MovedPoint, 4>& z);

}  // namespace epsnet::certify
