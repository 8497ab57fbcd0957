#include "netgen/surfaces/exact_isometries.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "netgen/base/gmp.h"
#include "netgen/surfaces/field_tiles.h"
#include "netgen/surfaces/group.h"
#include "triangulation/surface/error.h"

namespace epsnet {
namespace {

void require_path(const Surface& surface, const Word& word) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    const std::string name = "letter " + std::to_string(i) + " of the word is side " + to_string(word[i]);
    if (word[i].number() >= surface.side_count()) {
      throw SurfaceError(name + ", the surface has " + std::to_string(surface.side_count()) + " sides");
    }
    if (i > 0 && surface.tile_of_side(word[i]) != surface.tile_of_side(surface.partner(word[i - 1]))) {
      throw SurfaceError(name + ", no side of tile " + to_string(surface.tile_of_side(surface.partner(word[i - 1]))) +
                         ", where the letters before it lead");
    }
  }
}

certify::Gaussian to_gaussian(const Complex<Rational>& z) {
  // Integers, as crossings are.
  return {to_gmp(z.x).get_num(), to_gmp(z.y).get_num()};
}

/// The crossing of a side that is not rational.
certify::BallIsometry ball_crossing(const Surface& surface, SideId side, slong precision) {
  if (const auto& tiles = surface.field_tiles()) {
    const certify::Isometry<certify::FieldNumber>& f = tiles->crossing[side];
    return certify::to_balls(f, certify::determinant(f), precision);
  }
  const auto [p, q] = *surface.regular_tile();
  return certify::regular_crossing({p, q}, surface.place_in_tile(side), surface.place_in_tile(surface.partner(side)),
                                   precision);
}

certify::BallIsometry ball_product(const Surface& surface, const Word& word, slong precision) {
  if (word.empty()) return certify::identity_isometry();
  return certify::compose_range(
      0, word.size(), [&](std::size_t i) { return ball_crossing(surface, word[i], precision); },
      [&](const certify::BallIsometry& f, const certify::BallIsometry& g) {
        return certify::compose(f, g, precision);
      });
}

/// Returns the end of an interval as a dyadic number.
Rational dyadic(const arf_t end) {
  fmpz_t mantissa;
  fmpz_t exponent;
  fmpz_init(mantissa);
  fmpz_init(exponent);
  arf_get_fmpz_2exp(mantissa, exponent, end);
  mpz_class digits;
  fmpz_get_mpz(digits.get_mpz_t(), mantissa);
  const slong shift = fmpz_get_si(exponent);
  fmpz_clear(mantissa);
  fmpz_clear(exponent);
  mpq_class result(digits);
  if (shift >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(shift));
  } else {
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-shift));
  }
  return from_gmp(result);
}

EnclosedNumber ends(arb_srcptr x, slong precision) {
  arf_t end;
  arf_init(end);
  EnclosedNumber result;
  arb_get_lbound_arf(end, x, precision);
  result.lower = dyadic(end);
  arb_get_ubound_arf(end, x, precision);
  result.upper = dyadic(end);
  arf_clear(end);
  return result;
}

/// Returns an n ≥ 0 with |a| ≥ 2^n. Requires: |a| ≥ 1.
slong least_exponent(const certify::ComplexBall& a) {
  mag_t lower;
  mag_init(lower);
  acb_get_mag_lower(lower, a.get());
  const double log2 = std::floor(mag_get_d_log2_approx(lower));
  mag_clear(lower);
  return static_cast<slong>(std::max(log2 - 1, 0.0));
}

/// Whether the ball is at most 2^(size − bits) wide.
bool is_narrow(arb_srcptr x, slong size, slong bits) {
  return arb_is_finite(x) != 0 && mag_cmp_2exp_si(arb_radref(x), size - bits - 1) <= 0;
}

}  // namespace

certify::ExactIsometry integer_crossing(const Surface& surface, SideId side) {
  const Isometry<Rational>& f = surface.crossing(side);
  return {to_gaussian(f.a), to_gaussian(f.b)};
}

certify::ExactIsometry integer_isometry(const Surface& surface, const Word& word) {
  if (word.empty()) return certify::exact_identity();
  certify::ExactIsometry result =
      certify::compose_range(0, word.size(), [&](std::size_t i) { return integer_crossing(surface, word[i]); });
  certify::reduce(result);
  return result;
}

mpq_class squared_trace(const Surface& surface, const Word& word) {
  const certify::ExactIsometry f = integer_isometry(surface, word);
  mpq_class result(4 * f.a.re * f.a.re, certify::determinant(f));
  result.canonicalize();
  return result;
}

certify::BallIsometry ball_isometry(const Surface& surface, const Word& word, slong precision) {
  return surface.is_rational() ? certify::to_balls(integer_isometry(surface, word), precision)
                               : ball_product(surface, word, precision);
}

Isometry<Rational> exact_isometry(const Surface& surface, const Word& word) {
  require_path(surface, word);
  if (!surface.is_rational()) throw SurfaceError("the isometries of these tiles are not rational");
  const certify::ExactIsometry f = integer_isometry(surface, word);
  const auto rational = [](const mpz_class& x) { return from_gmp(mpq_class(x)); };
  return {{rational(f.a.re), rational(f.a.im)}, {rational(f.b.re), rational(f.b.im)}};
}

EnclosedIsometry enclosed_isometry(const Surface& surface, const Word& word, unsigned bits) {
  require_path(surface, word);
  if (bits > kMostEnclosureBits) {
    throw std::invalid_argument("an enclosure may be asked for with at most " + std::to_string(kMostEnclosureBits) +
                                " bits, not " + std::to_string(bits));
  }
  const certify::ExactIsometry exact =
      surface.is_rational() ? integer_isometry(surface, word) : certify::exact_identity();
  const slong wanted = static_cast<slong>(bits) + 4;
  for (slong precision = wanted + 32;; precision *= 2) {
    const certify::BallIsometry f =
        surface.is_rational() ? certify::to_balls(exact, precision) : ball_product(surface, word, precision);
    const slong size = least_exponent(f.a);
    if (is_narrow(f.a.re(), size, wanted) && is_narrow(f.a.im(), size, wanted) && is_narrow(f.b.re(), size, wanted) &&
        is_narrow(f.b.im(), size, wanted)) {
      return {ends(f.a.re(), precision), ends(f.a.im(), precision), ends(f.b.re(), precision),
              ends(f.b.im(), precision)};
    }
  }
}

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
