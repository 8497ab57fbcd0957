#pragma once

#include "kernel/plane.h"

namespace epsnet {

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
[[nodiscard]] LorentzVector<T> operator*(const T& s, const LorentzVector<T>& v) {
  return {s * v.x, s * v.y, s * v.t};
}

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
