#pragma once

#include <cmath>
#include <optional>

#include "kernel/isometry.h"
#include "kernel/numbers.h"

/// The formulas of the hyperbolic plane in the Poincaré disk, over any field. Signs are not certified here;
/// predicates.h certifies them.
namespace epsnet {

/// sinh²(d/2) for the hyperbolic distance d of two points of the disk: |p − q|²/((1 − |p|²)(1 − |q|²)), half of δ in
/// thesis Theorem I.2.
template <class T>
[[nodiscard]] T sinh2_half_distance(const Complex<T>& p, const Complex<T>& q) {
  return norm(p - q) / ((T(1) - norm(p)) * (T(1) - norm(q)));
}

/// The hyperbolic distance of two points of the disk. Accurate for close points: no 1 + δ is formed.
template <class T>
[[nodiscard]] T distance(const Complex<T>& p, const Complex<T>& q) {
  using std::asinh;
  using std::sqrt;
  return T(2) * asinh(sqrt(sinh2_half_distance(p, q)));
}

/// Positive, zero or negative if c lies to the left of, on or to the right of the geodesic from a to b.
///
/// A quarter of the determinant of the points (2x, 2y, 1 + |z|²) of the hyperboloid (up to scale), with a's row
/// subtracted from the others, so that it is accurate for close points.
template <class T>
[[nodiscard]] T orientation_determinant(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c) {
  const Complex<T> u = b - a;
  const Complex<T> v = c - a;
  return (T(1) + norm(a)) * cross(u, v) + dot(v, a + c) * cross(a, u) - dot(u, a + b) * cross(a, v);
}

/// Positive, zero or negative if d lies inside, on or outside the circle through a, b, c (counterclockwise as points of
/// the plane).
///
/// Hyperbolic circles are Euclidean circles of the Poincaré disk, so this is the Euclidean determinant, with d as
/// origin.
template <class T>
[[nodiscard]] T in_circle_determinant(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                      const Complex<T>& d) {
  const Complex<T> u = a - d;
  const Complex<T> v = b - d;
  const Complex<T> w = c - d;
  return norm(u) * cross(v, w) + norm(v) * cross(w, u) + norm(w) * cross(u, v);
}

/// A point of the Poincaré disk in Klein coordinates, where geodesics are straight: 2z/(1 + |z|²).
template <class T>
[[nodiscard]] Complex<T> to_klein(const Complex<T>& z) {
  return T(T(2) / (T(1) + norm(z))) * z;
}

/// A point given by Klein coordinates in the Poincaré disk: k/(1 + √(1 − |k|²)). Needs square roots in T.
template <class T>
[[nodiscard]] Complex<T> from_klein(const Complex<T>& k) {
  using std::sqrt;
  return T(T(1) / (T(1) + T(sqrt(T(T(1) - norm(k)))))) * k;
}

/// The cross-ratio [z1, z2, z3, z4] = (z4 − z2)(z3 − z1)/((z4 − z1)(z3 − z2)) (thesis Definition I.40). For z1, z2, z3,
/// z4 counterclockwise the edge (z1, z3) is not Delaunay if and only if the imaginary part is positive (Theorem I.42).
template <class T>
[[nodiscard]] Complex<T> cross_ratio(const Complex<T>& z1, const Complex<T>& z2, const Complex<T>& z3,
                                     const Complex<T>& z4) {
  return ((z4 - z2) * (z3 - z1)) / ((z4 - z1) * (z3 - z2));
}

/// The square of sinh R, R the hyperbolic circumradius, as a fraction numerator/denominator without division or
/// cancellation: the chords 2 sinh(d/2) of the hyperboloid lie on a circle of radius sinh R, so it is Heron's formula
/// for the circumradius. A denominator ≤ 0 means that the three points lie on no hyperbolic circle (a horocycle or a
/// hypercycle).
template <class T>
struct Sinh2Circumradius {
  T numerator;
  T denominator;
  T scale;  ///< x² + y² + z² + …, the size of the terms whose difference the denominator is: |denominator| ≤ scale.
};

/// From the squared Euclidean distances of a, b, c and the height 1 − |z|² of each.
template <class T>
[[nodiscard]] Sinh2Circumradius<T> sinh2_circumradius(const T& ab, const T& bc, const T& ca, const T& height_a,
                                                      const T& height_b, const T& height_c) {
  const T x = ab * height_c;
  const T y = bc * height_a;
  const T z = ca * height_b;
  const T sum = x + y;
  const T rest = sum - z;
  return {T(4) * ab * bc * ca, T(4) * x * y - rest * rest, (sum + z) * (sum + z)};
}

/// Computed from the points.
template <class T>
[[nodiscard]] Sinh2Circumradius<T> sinh2_circumradius(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c) {
  return sinh2_circumradius<T>(norm(a - b), norm(b - c), norm(c - a), T(1) - norm(a), T(1) - norm(b), T(1) - norm(c));
}

/// Returns the centre of the hyperbolic circle through three points of the disk; nullopt if none is found in the
/// precision of the field.
///
/// a is moved to 0; the Euclidean centre m of the circle through 0, b', c' lies on the ray of the hyperbolic one, which
/// is 2m/(1 + √(1 − 4|m|²)) because the diameter from 0 ends in 2m.
template <class T>
[[nodiscard]] std::optional<Complex<T>> circumcentre(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c) {
  using std::sqrt;
  const Complex<T> one{T(1), T(0)};
  const Complex<T> u = (b - a) / (one - conj(a) * b);
  const Complex<T> v = (c - a) / (one - conj(a) * c);
  const T area = T(2) * cross(u, v);
  if (area == 0) {
    return std::nullopt;
  }
  // m = i(u|v|² − v|u|²)/(2 Im(ū v)).
  const T uu = norm(u);
  const T vv = norm(v);
  const Complex<T> m{(u.y * vv - v.y * uu) / -area, (v.x * uu - u.x * vv) / -area};
  const T rest = T(1) - T(4) * norm(m);
  if (!(rest > 0)) {
    return std::nullopt;
  }
  const T scale = T(2) / (T(1) + T(sqrt(rest)));
  return Isometry<T>::translation(a)(scale * m);
}

/// Like `circumcentre`, for small circles near the origin, with two divisions. Its accuracy is absolute. The Euclidean
/// circle has a centre m and a radius r; the hyperbolic centre of that circle lies on the ray of m.
template <class T>
[[nodiscard]] std::optional<Complex<T>> circumcentre_near_origin(const Complex<T>& a, const Complex<T>& b,
                                                                 const Complex<T>& c) {
  using std::sqrt;
  const Complex<T> u = b - a;
  const Complex<T> v = c - a;
  const T uu = norm(u);
  const T vv = norm(v);
  const T scale = T(0.5) / cross(u, v);
  const Complex<T> from_a{(v.y * uu - u.y * vv) * scale, (u.x * vv - v.x * uu) * scale};
  const Complex<T> m = a + from_a;
  const T mm = norm(m);
  const T sum = T(1) + mm - norm(from_a);
  const T rest = sum * sum - T(4) * mm;
  // ((1 + |m|)² − r²)((1 − |m|)² − r²): small where the circle comes near the unit circle.
  if (!(rest > T(0.01))) {
    return std::nullopt;
  }
  return T(2) / (sum + T(sqrt(rest))) * m;
}

}  // namespace epsnet
