#include "certify/numbers/exact.h"

namespace epsnet::certify {

Gaussian operator+(const Gaussian& x, const Gaussian& y) { return {x.re + y.re, x.im + y.im}; }
Gaussian operator-(const Gaussian& x, const Gaussian& y) { return {x.re - y.re, x.im - y.im}; }
Gaussian operator*(const Gaussian& x, const Gaussian& y) {
  return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}
Gaussian operator*(const mpz_class& x, const Gaussian& y) { return {x * y.re, x * y.im}; }
Gaussian conjugate(const Gaussian& x) { return {x.re, -x.im}; }
mpz_class norm(const Gaussian& x) { return x.re * x.re + x.im * x.im; }

ExactPoint exact_point(const RationalPoint& point) {
  // Often the denominators are equal, and then no gcd is needed.
  if (point.x.get_den() == point.y.get_den()) return {{point.x.get_num(), point.y.get_num()}, point.x.get_den()};
  mpz_class m;
  mpz_lcm(m.get_mpz_t(), point.x.get_den().get_mpz_t(), point.y.get_den().get_mpz_t());
  const mpz_class x = point.x.get_num() * (m / point.x.get_den());
  const mpz_class y = point.y.get_num() * (m / point.y.get_den());
  return {{x, y}, m};
}

ExactPoint exact_point(double x, double y) { return exact_point(RationalPoint{mpq_class(x), mpq_class(y)}); }

std::size_t bits(const ExactPoint& point) {
  std::size_t sum = 0;
  for (const mpz_class* number : {&point.n.re, &point.n.im, &point.m}) sum += mpz_sizeinbase(number->get_mpz_t(), 2);
  return sum;
}

std::uint64_t exact_point_work(const RationalPoint& point) {
  std::size_t sum = 0;
  for (const mpq_class* number : {&point.x, &point.y}) {
    sum += mpz_sizeinbase(number->get_num_mpz_t(), 2) + mpz_sizeinbase(number->get_den_mpz_t(), 2);
  }
  return 32 * product_work(sum);
}

mpz_class gap(const ExactPoint& point) { return point.m * point.m - norm(point.n); }

ExactIsometry translation_to(const ExactPoint& c) { return {{c.m, 0}, c.n}; }

ExactIsometry compose_path(std::span<const ExactIsometry* const> fs) {
  if (fs.empty()) return exact_identity();
  return compose_range(0, fs.size(), [&](std::size_t i) { return *fs[i]; });
}

void reduce(ExactIsometry& f) {
  const mpz_class divisor = gcd(gcd(f.a.re, f.a.im), gcd(f.b.re, f.b.im));
  for (mpz_class* number : {&f.a.re, &f.a.im, &f.b.re, &f.b.im}) {
    mpz_divexact(number->get_mpz_t(), number->get_mpz_t(), divisor.get_mpz_t());
  }
}

bool is_identity(const ExactIsometry& f) { return f.b.re == 0 && f.b.im == 0 && f.a.im == 0; }

mpz_class determinant(const ExactIsometry& f) { return norm(f.a) - norm(f.b); }

std::size_t bits(const ExactIsometry& f) {
  std::size_t sum = 0;
  for (const mpz_class* number : {&f.a.re, &f.a.im, &f.b.re, &f.b.im}) {
    sum += mpz_sizeinbase(number->get_mpz_t(), 2);
  }
  return sum;
}

ExactIsometry crossing(const ExactPoint& p, const ExactPoint& q, const ExactPoint& p_other, const ExactPoint& q_other) {
  // Take p to 0 and q to w = n/d; take q' to 0 and p' to w' = n'/d'. Equal lengths mean |w| = |w'|, so w' = u w, |u| =
  // 1, and the crossing is: p to 0, turn by u, 0 to q'.
  const Gaussian n = p.m * q.n - q.m * p.n;
  const Gaussian d = Gaussian{p.m * q.m, 0} - conjugate(p.n) * q.n;
  const Gaussian n_other = q_other.m * p_other.n - p_other.m * q_other.n;
  const Gaussian d_other = Gaussian{p_other.m * q_other.m, 0} - conjugate(q_other.n) * p_other.n;
  // The turn as a matrix diag(a, ā) with a/ā = u. With k = |n d'|² = |n' d|², c = k u is in Z[i]. Then a = k + c will
  // do, and so will a = i(k − c); the one that is not small cannot vanish.
  const Gaussian divisor = n * d_other;
  const mpz_class k = norm(divisor);
  const Gaussian c = n_other * d * conjugate(divisor);
  ExactIsometry turn{c.re >= 0 ? Gaussian{k, 0} + c : Gaussian{0, 1} * (Gaussian{k, 0} - c), {0, 0}};
  reduce(turn);
  ExactIsometry result = compose(compose(translation_to(q_other), turn), inverse(translation_to(p)));
  reduce(result);
  return result;
}

}  // namespace epsnet::certify
