#pragma once

#include <cmath>
#include <optional>

#include "kernel/numbers.h"

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

}  // namespace epsnet
