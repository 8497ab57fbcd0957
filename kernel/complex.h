#pragma once

namespace epsnet {

/// A complex number over any ordered field: binary64, multiprecision or rational.
///
/// std::complex is specified for the built-in floating point types alone; this one has just the field operations, and
/// its product is the textbook formula (no special cases for infinities), so that error bounds can be derived from the
/// source.
template <class T>
struct Complex {
  T x{};  ///< Real part.
  T y{};  ///< Imaginary part.

  bool operator==(const Complex&) const = default;
};

template <class T>
[[nodiscard]] constexpr Complex<T> operator+(const Complex<T>& u, const Complex<T>& v) {
  return {u.x + v.x, u.y + v.y};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator-(const Complex<T>& u, const Complex<T>& v) {
  return {u.x - v.x, u.y - v.y};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator-(const Complex<T>& u) {
  return {-u.x, -u.y};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator*(const Complex<T>& u, const Complex<T>& v) {
  return {u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x};
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator*(const T& s, const Complex<T>& v) {
  return {s * v.x, s * v.y};
}

/// Complex conjugate x − iy.
template <class T>
[[nodiscard]] constexpr Complex<T> conj(const Complex<T>& u) {
  return {u.x, -u.y};
}
/// Squared modulus x² + y².
template <class T>
[[nodiscard]] constexpr T norm(const Complex<T>& u) {
  return u.x * u.x + u.y * u.y;
}
/// Re(ū v), the scalar product of u and v as vectors of the plane.
template <class T>
[[nodiscard]] constexpr T dot(const Complex<T>& u, const Complex<T>& v) {
  return u.x * v.x + u.y * v.y;
}
/// Im(ū v), twice the signed area of the triangle (0, u, v).
template <class T>
[[nodiscard]] constexpr T cross(const Complex<T>& u, const Complex<T>& v) {
  return u.x * v.y - u.y * v.x;
}
template <class T>
[[nodiscard]] constexpr Complex<T> operator/(const Complex<T>& u, const Complex<T>& v) {
  // One division and two products: divisions are expensive in binary64 and beyond, and this quotient is accurate
  // enough.
  const T reciprocal = T(1) / norm(v);
  return {dot(v, u) * reciprocal, cross(v, u) * reciprocal};
}

/// The number with both coordinates converted to another field.
template <class To, class From>
[[nodiscard]] constexpr Complex<To> convert(const Complex<From>& u) {
  return {static_cast<To>(u.x), static_cast<To>(u.y)};
}

}  // namespace epsnet
