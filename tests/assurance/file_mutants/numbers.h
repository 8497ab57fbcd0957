#pragma once

#include <cmath>
#include <gmpxx.h>
#include <utility>
#include <vector>

/// Exact numbers for the reference checker: integers, and towers of square roots over them. The rules only need signs,
/// and the sign of u + v√r follows from those of u, v and u² − v²r.
namespace epsnet::attack {

/// The reference cannot answer the question.
struct Unknown {
  const char* why;
};

[[nodiscard]] inline int sign(const mpz_class& x) { return sgn(x); }
[[nodiscard]] inline bool is_zero(const mpz_class& x) { return sgn(x) == 0; }
/// A number to binary64 accuracy in the range of long double, and the sum of the moduli of its terms, which bounds its
/// error.
struct Estimate {
  long double value;
  long double size;
};
[[nodiscard]] inline Estimate estimate(const mpz_class& x) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, x.get_mpz_t());
  const long double value =
      exponent > 16000 ? NAN : std::ldexp(static_cast<long double>(mantissa), static_cast<int>(exponent));
  return {value, std::fabs(value)};
}
inline void take_content(const mpz_class& x, mpz_class& content) { content = gcd(content, x); }
inline void divide(mpz_class& x, const mpz_class& content) {
  mpz_divexact(x.get_mpz_t(), x.get_mpz_t(), content.get_mpz_t());
}
[[nodiscard]] inline mpf_class approximation(const mpz_class& x, mp_bitcnt_t bits) { return mpf_class(x, bits); }

/// u + v√r with r = Radicand::value() > 0, no square of a B.
template <class B, class Radicand>
struct Root {
  B u{0};
  B v{0};

  Root() = default;
  explicit Root(long n) : u(n) {}
  explicit Root(const mpz_class& n) : u(n) {}
  Root(B u_, B v_) : u(std::move(u_)), v(std::move(v_)) {}

  friend Root operator+(const Root& x, const Root& y) { return {B(x.u + y.u), B(x.v + y.v)}; }
  friend Root operator-(const Root& x, const Root& y) { return {B(x.u - y.u), B(x.v - y.v)}; }
  friend Root operator-(const Root& x) { return {B(-x.u), B(-x.v)}; }
  friend Root operator*(const Root& x, const Root& y) {
    if (is_zero(y.v)) return {B(x.u * y.u), B(x.v * y.u)};
    if (is_zero(x.v)) return {B(x.u * y.u), B(x.u * y.v)};
    return {B(x.u * y.u + Radicand::value() * B(x.v * y.v)), B(x.u * y.v + x.v * y.u)};
  }
};

template <class B, class Radicand>
[[nodiscard]] bool is_zero(const Root<B, Radicand>& x) {
  return is_zero(x.u) && is_zero(x.v);
}
template <class B, class Radicand>
[[nodiscard]] Estimate estimate(const Root<B, Radicand>& x) {
  static const long double root = std::sqrt(estimate(Radicand::value()).value);
  const Estimate u = estimate(x.u);
  const Estimate v = estimate(x.v);
  return {u.value + v.value * root, u.size + v.size * root};
}
/// The exact sign; long double decides it for numbers far enough from 0.
template <class B, class Radicand>
[[nodiscard]] int sign(const Root<B, Radicand>& x) {
  const Estimate e = estimate(x);
  if (std::isfinite(e.size) && std::fabs(e.value) > std::ldexp(e.size, -45)) return e.value > 0 ? 1 : -1;
  const int u = sign(x.u);
  const int v = sign(x.v);
  if (u == v || v == 0) return u;
  if (u == 0) return v;
  return u * sign(B(x.u * x.u - Radicand::value() * B(x.v * x.v)));
}
template <class B, class Radicand>
void take_content(const Root<B, Radicand>& x, mpz_class& content) {
  take_content(x.u, content);
  take_content(x.v, content);
}
template <class B, class Radicand>
void divide(Root<B, Radicand>& x, const mpz_class& content) {
  divide(x.u, content);
  divide(x.v, content);
}
template <class B, class Radicand>
[[nodiscard]] mpf_class approximation(const Root<B, Radicand>& x, mp_bitcnt_t bits) {
  return approximation(x.u, bits) + approximation(x.v, bits) * sqrt(approximation(B(Radicand::value()), bits));
}

/// The fields of regular surfaces: K ∋ a = cot(π/4g) and the numbers 2 cos(kπ/2g), and F = K(s), s² = a² − 1.
template <int Genus>
struct Field;
template <int Genus>
struct SquareOfS {
  static const auto& value() {
    static const auto s2 = Field<Genus>::a() * Field<Genus>::a() - typename Field<Genus>::K(1);
    return s2;
  }
};

template <int N>
struct Number {
  static const mpz_class& value() {
    static const mpz_class n(N);
    return n;
  }
};
template <>
struct Field<2> {
  using K = Root<mpz_class, Number<2>>;
  static K a() { return {1, 1}; }
  static std::vector<K> cosines() { return {{2, 0}, {0, 1}, {0, 0}}; }  // k = 0, …, g
};
template <>
struct Field<3> {
  using K = Root<mpz_class, Number<3>>;
  static K a() { return {2, 1}; }
  static std::vector<K> cosines() { return {{2, 0}, {0, 1}, {1, 0}, {0, 0}}; }
};
/// √(2 + √2) = 2 cos(π/8).
struct TwoPlusRootTwo {
  static const Root<mpz_class, Number<2>>& value() {
    static const Root<mpz_class, Number<2>> r{2, 1};
    return r;
  }
};
template <>
struct Field<4> {
  using K = Root<Root<mpz_class, Number<2>>, TwoPlusRootTwo>;
  static K a() { return {{1, 1}, {0, 1}}; }
  static std::vector<K> cosines() {
    return {{{2, 0}, {0, 0}}, {{0, 0}, {1, 0}}, {{0, 1}, {0, 0}}, {{0, 0}, {-1, 1}}, {{0, 0}, {0, 0}}};
  }
};
template <int Genus>
using RegularNumber = Root<typename Field<Genus>::K, SquareOfS<Genus>>;

}  // namespace epsnet::attack
