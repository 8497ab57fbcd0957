#include "netgen/surfaces/matrix_products.h"

#include "netgen/base/gmp.h"

namespace epsnet {

certify::ExactIsometry integral(const Isometry<Rational>& f) {
  const mpq_class parts[] = {to_gmp(f.a.x), to_gmp(f.a.y), to_gmp(f.b.x), to_gmp(f.b.y)};
  mpz_class scale = 1;
  for (const mpq_class& part : parts) scale = lcm(scale, part.get_den());
  const auto whole = [&](const mpq_class& part) { return mpz_class(scale / part.get_den() * part.get_num()); };
  certify::ExactIsometry result{{whole(parts[0]), whole(parts[1])}, {whole(parts[2]), whole(parts[3])}};
  certify::reduce(result);
  return result;
}

Complex<Rational> image(const certify::ExactIsometry& f, const Complex<Rational>& z) {
  const certify::MovedPoint<certify::Gaussian> moved = certify::moved(f, certify::exact_point(to_gmp(z)));
  const certify::Gaussian n = moved.n * certify::conjugate(moved.d);
  const mpz_class d = certify::norm(moved.d);
  mpq_class x(n.re, d);
  mpq_class y(n.im, d);
  x.canonicalize();
  y.canonicalize();
  return {from_gmp(x), from_gmp(y)};
}

namespace {

/// The operator norm of an isometry of determinant 1.
double size_of(const Isometry<MatrixProducts::Number>& f) {
  return static_cast<double>(MatrixProducts::Number(sqrt(norm(f.a)) + sqrt(norm(f.b))));
}

}  // namespace

MatrixProducts::MatrixProducts(const std::vector<Isometry<Number>>& generators, const Complex<Rational>& base,
                               double rounding)
    : generators_(generators.size()) {
  const auto centre = Isometry<Number>::translation(convert<Number>(base));
  for (const Isometry<Number>& f : generators) {
    const Isometry<Number> value = normalized(inverse(centre) * f * centre);
    nodes_.push_back({0, 0, value, 1, rounding * size_of(value)});
  }
}

MatrixProducts::Id MatrixProducts::product(Id x, Id y) {
  const Isometry<Number> left = value(x);
  const Isometry<Number> right = value(y);
  nodes_.push_back({x, y, normalized(left * right), nodes_[index(x)].length + nodes_[index(y)].length,
                    error(x) * size_of(right) + size_of(left) * error(y)});
  return static_cast<Id>(nodes_.size());
}

Isometry<MatrixProducts::Number> MatrixProducts::value(Id x) const {
  const Isometry<Number>& f = nodes_[index(x)].value;
  return x > 0 ? f : inverse(f);
}

std::optional<MatrixProducts::Letters> MatrixProducts::letters(Id x, std::size_t most) const {
  if (nodes_[index(x)].length > static_cast<double>(most)) return std::nullopt;
  Letters result;
  std::vector<Id> rest{x};
  while (!rest.empty()) {
    const Id next = rest.back();
    rest.pop_back();
    const Node& node = nodes_[index(next)];
    if (node.left == 0) {
      result.push_back(next);
    } else if (next > 0) {
      rest.push_back(node.right);
      rest.push_back(node.left);
    } else {
      rest.push_back(-node.left);
      rest.push_back(-node.right);
    }
  }
  return result;
}

}  // namespace epsnet
