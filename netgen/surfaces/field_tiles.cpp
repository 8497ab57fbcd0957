#include "netgen/surfaces/field_tiles.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "kernel/lorentz.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/number_field.h"

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

}  // namespace epsnet
