#pragma once

#include <cmath>

#include "epsnet/kernel/complex.h"

namespace epsnet {

/// An orientation-preserving isometry z ↦ (a z + b)/(b̄ z + ā) of the Poincaré disk, |a| > |b| (thesis Theorem I.8).
///
/// (a, b) is defined up to a real factor, so that isometries between rational points stay in Q(i); `normalized` scales
/// to |a|² − |b|² = 1.
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

template <class T>
[[nodiscard]] constexpr Isometry<T> inverse(const Isometry<T>& f) {
  return {conj(f.a), -f.b};
}

/// The same isometry with |a|² − |b|² = 1 and, of the two such pairs, the one with Re a > 0, or Re a = 0 and Im a > 0.
/// Needs square roots in T.
template <class T>
[[nodiscard]] Isometry<T> normalized(const Isometry<T>& f) {
  using std::sqrt;
  const T scale = T(1) / sqrt(f.determinant());
  const T s = f.a.x < 0 || (f.a.x == 0 && f.a.y < 0) ? T(-scale) : scale;
  return {s * f.a, s * f.b};
}

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

}  // namespace epsnet
