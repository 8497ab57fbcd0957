#include "netgen/surfaces/exact_isometries.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/number_field.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

using certify::FieldNumber;
using Field = certify::SurfaceDocument::Field;
using Polygon = Field::Polygon;
using Wide = Mp4096;

constexpr slong kWideBits = kMantissaBits<Wide>;

/// Of numbers that are exactly equal, the square of the difference is less.
Wide tolerance() { return ldexp(Wide(1), -1000); }

std::string named(const char* what, std::size_t k, std::size_t tile) {
  return std::string(what) + " " + std::to_string(k) + " of tile " + std::to_string(tile);
}

/// The midpoint of a ball.
Wide middle_of(const certify::Ball& x) {
  Wide result;
  arf_get_mpfr(result.backend().data(), arb_midref(x.get()), MPFR_RNDN);
  return result;
}

/// Numbers, rounded.
class Rounder {
 public:
  explicit Rounder(const certify::NumberField& field) : field_(field) {}

  [[nodiscard]] Wide operator()(const FieldNumber& x) const {
    const certify::Precision scope(kWideBits + 64);
    return middle_of(certify::real_ball(x));
  }
  [[nodiscard]] Wide operator()(const std::vector<mpz_class>& x) const {
    return (*this)(certify::field_number(field_, x));
  }
  [[nodiscard]] LorentzVector<Wide> operator()(const std::array<std::vector<mpz_class>, 3>& v) const {
    return {(*this)(v[0]), (*this)(v[1]), (*this)(v[2])};
  }

 private:
  const certify::NumberField& field_;
};

void check_root(const Field& tiles) {
  const auto& [lower, upper] = tiles.root;
  if (certify::count_roots(tiles.polynomial, lower, upper).changes != 1) {
    throw SurfaceError("the interval does not isolate a root of the polynomial: give a shorter one around the root");
  }
}

/// The corner as a point of the hyperboloid.
LorentzVector<Wide> corner_of(const Rounder& round, const Polygon& polygon, std::size_t k, std::size_t tile) {
  const LorentzVector<Wide> v = round(polygon[k]);
  const Wide square = -lorentz_product(v, v);
  if (v.t <= 0 || square <= 0) throw SurfaceError(named("vertex", k, tile) + " is not inside the light cone");
  return Wide(1 / sqrt(square)) * v;
}

bool is_near(const Complex<Wide>& z, const Complex<Wide>& w) { return norm(z - w) < tolerance(); }

/// The interior angle at v, to the left of the way to `next`.
double angle_at(const Complex<Wide>& v, const Complex<Wide>& next, const Complex<Wide>& previous) {
  const auto to_origin = Isometry<Wide>::translation(-v);
  const Complex<Wide> quotient = to_origin(previous) * conj(to_origin(next));
  return std::atan2(static_cast<double>(Wide(quotient.y / sqrt(norm(quotient)))),
                    static_cast<double>(Wide(quotient.x / sqrt(norm(quotient)))));
}

/// The corners in the disk, by side that starts there.
using Corners = ById<SideId, Complex<Wide>>;

void check_sides(const Surface& surface, const Corners& corner) {
  for (const SideId s : surface.side_ids()) {
    const SideId other = surface.partner(s);
    const auto f = surface.crossing_as<Wide>(s);
    if (is_near(f(corner[s]), corner[surface.next_side(other)]) &&
        is_near(f(corner[surface.next_side(s)]), corner[other]))
      continue;
    throw SurfaceError("the crossing of " + named("side", surface.place_in_tile(s), surface.tile_of_side(s).number()) +
                       " does not take it to its partner");
  }
}

void check_vertices(const Surface& surface, const Corners& corner) {
  std::vector<bool> done(surface.vertex_class_count());
  for (const SideId first : surface.side_ids()) {
    if (done[surface.vertex_class(first)]) continue;
    done[surface.vertex_class(first)] = true;
    double angles = 0;
    Isometry<Wide> product;
    for (const SideId s : surface.corner_cycle(first)) {
      angles += angle_at(corner[s], corner[surface.next_side(s)], corner[surface.previous_side(s)]);
      product = normalized(surface.crossing_as<Wide>(s) * product);
    }
    const double turns = angles / (2 * std::numbers::pi);
    if (norm(product.b) < tolerance() && product.a.y * product.a.y < tolerance() && std::abs(turns - 1) < 1e-6)
      continue;
    throw SurfaceError("the tiles around vertex " + std::to_string(surface.vertex_class(first)) +
                       " do not close up once around it");
  }
}

}  // namespace

FieldTiles::FieldTiles(Field tiles, const std::vector<Gluing>& gluing)
    : document(std::move(tiles)), field(document.polynomial, document.root) {
  std::vector<std::uint32_t> first{0};
  for (const Polygon& polygon : document.polygons) {
    first.push_back(first.back() + static_cast<std::uint32_t>(polygon.size()));
  }
  crossing.resize(first.back());
  const auto complex_number = [&](const std::vector<mpz_class>& re, const std::vector<mpz_class>& im) {
    return FieldNumber{&field, certify::field_number(field, re).re, certify::field_number(field, im).re};
  };
  for (std::size_t i = 0; i < gluing.size(); ++i) {
    const auto& [a, a_im, b, b_im] = document.crossings[i];
    const SideId s(first[gluing[i].tile] + gluing[i].side);
    crossing[s] = {complex_number(a, a_im), complex_number(b, b_im)};
    crossing[SideId(first[gluing[i].other_tile] + gluing[i].other_side)] = certify::inverse(crossing[s]);
  }
}

Mp1024 FieldTiles::root() const {
  // Modulo f, which is x − α for a rational α.
  certify::Polynomial x;
  fmpz_poly_set_coeff_si(x.get(), 1, 1);
  field.reduce(x);
  return Mp1024(Rounder(field)(FieldNumber{&field, x}));
}

Surface surface_over_field(Field tiles, std::vector<Gluing> gluing) {
  check_root(tiles);
  const auto exact = std::make_shared<const FieldTiles>(std::move(tiles), gluing);
  const Rounder round(exact->field);
  std::vector<Tile> rounded_tiles;
  Corners corner;
  for (const Polygon& polygon : exact->document.polygons) {
    Tile& tile = rounded_tiles.emplace_back();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      corner.push_back(in_disk(corner_of(round, polygon, k, rounded_tiles.size() - 1)));
      tile.push_back({Rational(Mp256(corner.back().x)), Rational(Mp256(corner.back().y))});
    }
  }
  ById<SideId, Isometry<Wide>> crossings;
  for (const SideId s : exact->crossing.ids()) {
    const certify::Isometry<FieldNumber>& f = exact->crossing[s];
    if (certify::sign(certify::determinant(f)) <= 0) throw SurfaceError("a crossing is no isometry");
    crossings.push_back(rounded_isometry<Wide>(f));
  }
  Surface surface = Surface::over_field(exact, std::move(rounded_tiles), std::move(gluing), std::move(crossings));
  check_sides(surface, corner);
  check_vertices(surface, corner);
  return surface;
}

template <class T>
Isometry<T> rounded_isometry(const certify::Isometry<FieldNumber>& f) {
  const certify::BallIsometry value = certify::to_balls(f, certify::determinant(f), kMantissaBits<T> + 64);
  const auto middle = [](const certify::ComplexBall& z) {
    return Complex<T>{T(middle_of(certify::real(z))), T(middle_of(certify::imaginary(z)))};
  };
  return {middle(value.a), middle(value.b)};
}

template Isometry<Mp1024> rounded_isometry<Mp1024>(const certify::Isometry<FieldNumber>&);
template Isometry<Mp4096> rounded_isometry<Mp4096>(const certify::Isometry<FieldNumber>&);

certify::Isometry<FieldNumber> field_isometry(const Surface& surface, const Word& word) {
  const FieldTiles& tiles = *surface.field_tiles();
  if (word.empty()) {
    return {certify::field_number(tiles.field, certify::Gaussian{1, 0}),
            certify::field_number(tiles.field, certify::Gaussian{0, 0})};
  }
  auto result = certify::compose_range(0, word.size(), [&](std::size_t i) { return tiles.crossing[word[i]]; });
  certify::reduce(result);
  return result;
}

std::vector<mpz_class> coefficients_of(const FieldNumber& x) {
  std::vector<mpz_class> result;
  for (slong i = 0; i < fmpz_poly_length(x.re.get()); ++i) {
    certify::Integer coefficient;
    fmpz_poly_get_coeff_fmpz(coefficient.get(), x.re.get(), i);
    result.push_back(coefficient.value());
  }
  if (result.empty()) result.emplace_back(0);
  return result;
}

std::string root_text(const FieldTiles& tiles) {
  const Mp1024 root = tiles.root();
  const auto& [lower, upper] = tiles.document.root;
  const Mp1024 room = std::min(Mp1024(root - rounded<Mp1024>(lower)), Mp1024(rounded<Mp1024>(upper) - root));
  int digits = 1;
  for (Mp1024 error = 1; error > room / 4 && digits < 300; error /= 10) ++digits;
  return "root(" + polynomial_text(tiles.document.polynomial, "x") + "," + root.str(digits, std::ios_base::fixed) + ")";
}

std::vector<std::string> number_texts(const std::vector<certify::FieldNumber>& numbers, const std::string& name) {
  std::vector<std::vector<mpz_class>> coefficients;
  mpz_class divisor;
  for (const certify::FieldNumber& x : numbers) {
    coefficients.push_back(coefficients_of(x));
    for (const mpz_class& c : coefficients.back()) divisor = gcd(divisor, c);
  }
  std::vector<std::string> result;
  for (std::vector<mpz_class>& x : coefficients) {
    for (mpz_class& c : x) c /= divisor;
    result.push_back(polynomial_text(x, name));
  }
  return result;
}

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
