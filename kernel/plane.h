#pragma once

#include <cmath>
#include <optional>

#include "kernel/numbers.h"

/// The hyperbolic plane in the Poincaré disk, over any field: its isometries and its formulas. Signs are not certified
/// here; predicates.h certifies them.
namespace epsnet {

/// An orientation-preserving isometry z ↦ (a z + b)/(b̄ z + ā) of the Poincaré disk, |a| > |b| (thesis Theorem I.8).
///
/// (a, b) is defined up to a real factor, so isometries between rational points stay in Q(i). `normalized` scales to
/// |a|² − |b|² = 1.
template <class T>
struct Isometry {
  Complex<T> a{T(1), T(0)};
  Complex<T> b{T(0), T(0)};

  /// The image of a point of the disk. One division.
  [[nodiscard]] constexpr Complex<T> operator()(const Complex<T>& z) const {
    return (a * z + b) / (conj(b) * z + conj(a));
  }

  /// The translation along the line through 0 and c that takes 0 to c: z ↦ (z + c)/(1 + c̄ z).
  [[nodiscard]] static constexpr Isometry translation(const Complex<T>& c) { return {{T(1), T(0)}, c}; }

  /// |a|² − |b|², positive for an isometry.
  [[nodiscard]] constexpr T determinant() const { return norm(a) - norm(b); }
};

/// Composition: (f * g)(z) = f(g(z)).
template <class T>
[[nodiscard]] constexpr Isometry<T> operator*(const Isometry<T>& f, const Isometry<T>& g) {
  return {f.a * g.a + f.b * conj(g.b), f.a * g.b + f.b * conj(g.a)};
}

/// The inverse, (ā, −b).
template <class T>
[[nodiscard]] constexpr Isometry<T> inverse(const Isometry<T>& f) {
  return {conj(f.a), -f.b};
}

/// Returns the same isometry with |a|² − |b|² = 1. Of the two such pairs it is the one with Re a > 0, or Re a = 0 and
/// Im a > 0. Needs square roots in T.
template <class T>
[[nodiscard]] Isometry<T> normalized(const Isometry<T>& f) {
  using std::sqrt;
  const T scale = T(1) / sqrt(f.determinant());
  const T s = f.a.x < 0 || (f.a.x == 0 && f.a.y < 0) ? T(-scale) : scale;
  return {s * f.a, s * f.b};
}

/// The isometry with its coefficients converted to another field.
template <class To, class From>
[[nodiscard]] constexpr Isometry<To> convert(const Isometry<From>& f) {
  return {convert<To>(f.a), convert<To>(f.b)};
}

/// The isometry that takes p to p2 and q to q2. Stays in the field of the coordinates. Requires d(p, q) = d(p2, q2) >
/// 0.
template <class T>
[[nodiscard]] Isometry<T> segment_to_segment(const Complex<T>& p, const Complex<T>& q, const Complex<T>& p2,
                                             const Complex<T>& q2) {
  // With p and p2 moved to 0 the segments end in w and w2, |w| = |w2|. The rotation z ↦ (a/ā) z takes w to w2 when arg
  // a is half the angle from w to w2. Both w + w2 and i(w2 − w) bisect that angle (modulo π, which a/ā does not see);
  // the longer one does it without a square root.
  const Complex<T> one{T(1), T(0)};
  const Complex<T> w = (q - p) / (one - conj(p) * q);
  const Complex<T> w2 = (q2 - p2) / (one - conj(p2) * q2);
  const Complex<T> sum = w + w2;
  const Complex<T> a = norm(sum) * T(4) > norm(w) ? conj(w) * sum : Complex<T>{T(0), T(1)} * (conj(w) * (w2 - w));
  return Isometry<T>::translation(p2) * Isometry<T>{a, {}} * Isometry<T>::translation(-p);
}

/// The kinds of orientation-preserving isometries, by their fixed points in the closed disk (thesis I.1.1).
enum class IsometryKind {
  identity,    ///< Every point.
  elliptic,    ///< One, inside the disk: a rotation about it.
  parabolic,   ///< One, on the unit circle.
  hyperbolic,  ///< Two, on the unit circle: a translation along its axis, the geodesic that joins them.
};

/// |b|² − (Im a)² = (Re a)² − (|a|² − |b|²): positive for a hyperbolic isometry, zero for a parabolic one and the
/// identity, negative for an elliptic one. For |a|² − |b|² = 1 it is sinh²(ℓ/2), ℓ the displacement length.
///
/// No square of a is formed: for a short translation along a line near the origin all terms are small.
template <class T>
[[nodiscard]] constexpr T isometry_discriminant(const Isometry<T>& f) {
  return f.b.x * f.b.x + (f.b.y - f.a.y) * (f.b.y + f.a.y);
}

/// Returns the kind of an isometry. It is exact over an exact field such as `Rational`. Over other fields it is the
/// kind of the rounded discriminant, and is parabolic only by accident.
template <class T>
[[nodiscard]] constexpr IsometryKind classify(const Isometry<T>& f) {
  const T discriminant = isometry_discriminant(f);
  if (discriminant > 0) {
    return IsometryKind::hyperbolic;
  }
  if (discriminant < 0) {
    return IsometryKind::elliptic;
  }
  return f.a.y == 0 && f.b == Complex<T>{} ? IsometryKind::identity : IsometryKind::parabolic;
}

/// The displacement length ℓ (hyperbolic length, thesis I.1.1) of an isometry: the distance by which it moves the
/// points of its axis. It moves all other points farther. Returns 0 for isometries that are not hyperbolic.
///
/// By sinh(ℓ/2) = √(|b|² − (Im a)²)/√(|a|² − |b|²). cosh(ℓ/2) = |Re a|/√(|a|² − |b|²) is the textbook's form
/// (ℓ = 2 arcosh(|Tr|/2)), but loses half of the digits of a short ℓ. For entries of relative accuracy u the relative
/// error of ℓ is about u((|b|² + (Im a)²)/(|b|² − (Im a)²) + |a|²/(|a|² − |b|²)). In binary64 ℓ below 1e-153
/// underflows to 0. Needs square roots in T.
template <class T>
[[nodiscard]] T displacement_length(const Isometry<T>& f) {
  using std::asinh;
  using std::sqrt;
  const T discriminant = isometry_discriminant(f);
  return discriminant > 0 ? T(T(2) * asinh(T(sqrt(discriminant / f.determinant())))) : T(0);
}

/// The axis of a hyperbolic isometry: the geodesic from `from` to `to`, ideal points (|z| = 1), along which it
/// translates.
template <class T>
struct Axis {
  Complex<T> from;  ///< The repelling fixed point.
  Complex<T> to;    ///< The attracting fixed point: images of points of the disk under powers converge to it.
};

/// Returns the axis of an isometry; nullopt if it is not hyperbolic. Needs square roots in T.
///
/// The fixed points z solve b̄z² + (ā − a)z − b = 0: z = (i Im a ± √(|b|² − (Im a)²)) b/|b|². The isometry contracts
/// near the one with the larger |b̄z + ā| = |Re a ± √…|.
template <class T>
[[nodiscard]] std::optional<Axis<T>> axis(const Isometry<T>& f) {
  using std::sqrt;
  const T discriminant = isometry_discriminant(f);
  if (!(discriminant > 0)) {
    return std::nullopt;
  }
  const T root = f.a.x < 0 ? T(-sqrt(discriminant)) : T(sqrt(discriminant));
  const Complex<T> direction = (T(1) / norm(f.b)) * f.b;
  return Axis<T>{Complex<T>{T(-root), f.a.y} * direction, Complex<T>{root, f.a.y} * direction};
}

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

// The hyperboloid model.

/// A vector (x, y, t) of Minkowski space with the product xx' + yy' − tt' (hyperboloid model).
///
/// Points of the plane are vectors of square −1, t > 0; unit vectors (square 1) are oriented lines, by their normals.
/// What is a quotient in the disk is linear here: ⟨X, Y⟩ = −cosh d for points, ⟨n, X⟩ = sinh d for a unit normal and a
/// point, positive on the left of the line.
template <class T>
struct LorentzVector {
  T x{};
  T y{};
  T t{};
};

template <class T>
[[nodiscard]] LorentzVector<T> operator+(const LorentzVector<T>& u, const LorentzVector<T>& v) {
  return {u.x + v.x, u.y + v.y, u.t + v.t};
}
template <class T>
[[nodiscard]] LorentzVector<T> operator-(const LorentzVector<T>& u, const LorentzVector<T>& v) {
  return {u.x - v.x, u.y - v.y, u.t - v.t};
}
template <class T>
[[nodiscard]] LorentzVector<T> operator*(const T& s, const LorentzVector<T>& v) {
  return {s * v.x, s * v.y, s * v.t};
}

/// Returns ⟨u, v⟩ = u_x v_x + u_y v_y − u_t v_t.
template <class T>
[[nodiscard]] T lorentz_product(const LorentzVector<T>& u, const LorentzVector<T>& v) {
  return u.x * v.x + u.y * v.y - u.t * v.t;
}

/// The vector c with ⟨c, w⟩ = det(u, v, w) for all w, orthogonal to u and v: for two points the normal of the line from
/// the first to the second, not of length 1.
template <class T>
[[nodiscard]] LorentzVector<T> lorentz_cross(const LorentzVector<T>& u, const LorentzVector<T>& v) {
  return {u.y * v.t - u.t * v.y, u.t * v.x - u.x * v.t, u.y * v.x - u.x * v.y};
}

/// The point of the hyperboloid that the point z of the Poincaré disk stands for.
template <class T>
[[nodiscard]] LorentzVector<T> on_hyperboloid(const Complex<T>& z) {
  const T scale = T(1) / (T(1) - norm(z));
  return {T(2) * scale * z.x, T(2) * scale * z.y, scale * (T(1) + norm(z))};
}

/// The point of the Poincaré disk that a point of the hyperboloid stands for.
template <class T>
[[nodiscard]] Complex<T> in_disk(const LorentzVector<T>& v) {
  const T scale = T(1) / (T(1) + v.t);
  return {scale * v.x, scale * v.y};
}

/// The image of a vector under an isometry of determinant 1: with x + iy = 2uv̄ and t = |u|² + |v|² for the pair (u, v)
/// = (z, 1)/√(1 − |z|²), on which the isometry acts as a matrix.
template <class T>
[[nodiscard]] LorentzVector<T> image(const Isometry<T>& f, const LorentzVector<T>& v) {
  const Complex<T> w{v.x, v.y};
  const Complex<T> moved = f.a * f.a * w + f.b * f.b * conj(w) + T(T(2) * v.t) * (f.a * f.b);
  return {moved.x, moved.y, (norm(f.a) + norm(f.b)) * v.t + T(2) * dot(f.b, f.a * w)};
}

/// The normal of the axis of a hyperbolic isometry with Re a > 0, on whose left, along the translation, it is positive.
/// Its square is isometry_discriminant(f). The fixed points z, |z| = 1, solve Im(b̄z) = Im a.
template <class T>
[[nodiscard]] LorentzVector<T> axis_normal(const Isometry<T>& f) {
  return {T(-f.b.y), f.b.x, f.a.y};
}

}  // namespace epsnet
