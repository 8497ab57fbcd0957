#include "netgen/surfaces/surfaces.h"

#include <algorithm>
#include <boost/random/linear_congruential.hpp>
#include <boost/random/uniform_01.hpp>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "certify/claims.h"
#include "certify/file/compact.h"
#include "certify/file/document_reader.h"
#include "certify/file/file.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/exact_isometries.h"

namespace epsnet {
namespace {

// Every rounding to float can change which candidates are accepted, and the digits of the coordinates.
static_assert(FLT_EVAL_METHOD == 0 && std::numeric_limits<float>::is_iec559,
              "floats must be rounded to float after each operation");

using Half = std::array<Complex<Rational>, 4>;

/// The stream of random numbers of one seed.
class Draws {
 public:
  /// CGAL's generator draws an integer of [0, 2¹⁵ − 1] when it is constructed. This always takes one step, as the range
  /// divides that of rand48.
  explicit Draws(std::int32_t seed) : engine_(static_cast<std::uint32_t>(seed)) { engine_.discard(1); }

  /// Draws a point of the upper half of the unit disk, uniformly distributed.
  Complex<float> point() {
    // In the first attempt the compiled program draws the imaginary part first (order of evaluation of arguments),
    // later the real part.
    Complex<float> z;
    z.y = uniform();
    z.x = 2 * uniform() - 1;
    while (norm(z) >= 1) {
      z.x = 2 * uniform() - 1;
      z.y = uniform();
    }
    return z;
  }

 private:
  float uniform() { return boost::random::uniform_01<float>()(engine_); }

  boost::random::rand48 engine_;
};

/// z0, z1, z2, z3 in floats. In an acceptable candidate z0 ∈ (0, 1), and the octagon has area 4π up to rounding.
struct Candidate {
  float z0;
  std::array<Complex<float>, 3> z;
};

/// Draws z1, z2, z3 until their arguments increase and the area condition, a quadratic equation a x² + b x + c = 0 for
/// z0, is negative at 1. z0 is one of its roots; it may be anything, even NaN.
Candidate draw_candidate(Draws& draws) {
  for (;;) {
    std::array<Complex<float>, 3> z;
    for (Complex<float>& point : z) point = draws.point();
    const auto& [z1, z2, z3] = z;
    if (!((z2 / z1).y > 0 && (z3 / z2).y > 0)) continue;
    const Complex<float> one{1, 0};
    const Complex<float> u = (one - conj(z1 * z2)) * (one - conj(z2 * z3));
    const float a = -(conj(u * z1) * z3).y;
    const float b = (u * conj(z3 - z1)).y;
    const float c = u.y;
    if (a + b + c > -1e-5F) continue;
    return {2 * c / (std::sqrt(b * b - 4 * a * c) - b), z};
  }
}

/// Returns the first four digits after the point, as an exact number with the sign of x. The digits before the point
/// are dropped, as in CGAL's program, which for example takes z0 = 2.9986 for 0.9986 (seed 50). Returns nullopt for NaN
/// and for numbers too large to have digits after the point.
std::optional<Rational> four_digits(float x) {
  const float shifted = 10000 * std::fabs(x);
  if (!(shifted < 0x1p24F)) return std::nullopt;
  const int digits = static_cast<int>(shifted) % 10000;
  return Rational(x < 0 ? -digits : digits, 10000);
}

std::optional<Half> truncated(const Candidate& candidate) {
  Half half;
  const std::optional<Rational> z0 = four_digits(candidate.z0);
  if (!z0) return std::nullopt;
  half[0] = {*z0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    half[i + 1] = {*four_digits(candidate.z[i].x), *four_digits(candidate.z[i].y)};
  }
  return half;
}

/// Whether the points lie in the upper half of the disk, except for z0, which is real, and their arguments increase.
bool well_placed(const Half& half) {
  for (std::size_t i = 0; i < half.size(); ++i) {
    if (norm(half[i]) >= 1 || (i > 0 && half[i].y <= 0)) return false;
    if (i > 0 && cross(half[i - 1], half[i]) <= 0) return false;
  }
  return true;
}

}  // namespace

std::optional<std::array<Complex<Rational>, 4>> closed_up(const std::array<Complex<Rational>, 4>& half) {
  const auto& [z0, z1, z2, z3] = half;
  const Complex<Rational> one{1, 0};
  // With w = (z3 + z0)/(1 + z̄0 z3), the condition is Im[A (1 + z̄0 z2 − (z0 + z2) w̄)] = 0 up to a positive factor, where
  // A is the product of the first two factors.
  const Complex<Rational> seen = one + conj(z0) * z3;
  if (norm(seen) == 0) return std::nullopt;
  const Complex<Rational> w = (z3 + z0) / seen;
  const Complex<Rational> first = (one - z0 * conj(z1)) * (one - z1 * conj(z2));
  const Rational slope = (first * (z0 + z2) * conj(w)).y;
  if (slope == 0) return std::nullopt;
  const Rational lambda = (first * (one + conj(z0) * z2)).y / slope;
  const Complex<Rational> moved = lambda * w;
  const Complex<Rational> scale = one - conj(z0) * moved;
  if (norm(scale) == 0) return std::nullopt;
  return Half{z0, z1, z2, (moved - z0) / scale};
}

Surface symmetric_octagon(const std::array<Complex<Rational>, 4>& half) {
  Tile tile(half.begin(), half.end());
  for (const Complex<Rational>& z : half) tile.push_back(-z);
  return {{std::move(tile)}, {{0, 0, 0, 4}, {0, 1, 0, 5}, {0, 2, 0, 6}, {0, 3, 0, 7}}};
}

Surface random_octagon(std::int32_t seed) {
  Draws draws(seed);
  for (;;) {
    const std::optional<Half> half = truncated(draw_candidate(draws));
    // `well_placed` implies z0 > 0; this is tested first, as most rejected candidates fail it.
    if (!half || (*half)[0].x <= 0) continue;
    const std::optional<Half> closed = closed_up(*half);
    if (closed && well_placed(*closed)) return symmetric_octagon(*closed);
  }
}

certify::SurfaceDocument to_document(const Surface& surface) {
  certify::SurfaceDocument document;
  document.about = surface.about();
  if (surface.is_regular_polygon()) {
    document.regular_genus = surface.genus();
    return document;
  }
  if (const auto& regular = surface.regular_tile()) {
    document.map_tile = {regular->p, regular->q};
  } else if (surface.field_tiles()) {
    document.field = surface.field_tiles()->document;
  } else {
    for (const Tile& tile : surface.tiles()) {
      certify::SurfaceDocument::Tile& copy = document.tiles.emplace_back();
      for (const Complex<Rational>& z : tile) copy.push_back(to_gmp(z));
    }
  }
  for (const auto& [tile, side, other_tile, other_side] : surface.gluing()) {
    document.gluing.push_back({tile, side, other_tile, other_side});
  }
  return document;
}

Surface from_document(const certify::SurfaceDocument& surface) {
  if (surface.regular_genus != 0) {
    Surface regular = Surface::regular(surface.regular_genus);
    regular.set_about(surface.about);
    return regular;
  }
  std::vector<Tile> tiles;
  for (const certify::SurfaceDocument::Tile& tile : surface.tiles) {
    Tile& copy = tiles.emplace_back();
    for (const certify::RationalPoint& z : tile) copy.push_back(from_gmp(z));
  }
  std::vector<Gluing> gluing;
  for (const auto& [tile, side, other_tile, other_side] : surface.gluing) {
    gluing.push_back({tile, side, other_tile, other_side});
  }
  const auto [p, q] = surface.map_tile;
  Surface result = p != 0                              ? Surface::map({p, q}, std::move(gluing))
                   : !surface.field.polynomial.empty() ? surface_over_field(surface.field, std::move(gluing))
                                                       : Surface(std::move(tiles), std::move(gluing));
  result.set_about(surface.about);
  return result;
}

Surface from_document(const certify::SurfaceDocument& surface, const std::string& name) {
  try {
    return from_document(surface);
  } catch (const SurfaceError& error) {
    throw SurfaceError(certify::ErrorParts{.file = name, .problem = error.what()});
  }
}

namespace {

/// The surface that a file is about.
certify::SurfaceDocument surface_of(certify::ClaimDocument&& claim) {
  return std::visit(
      []<class Document>(Document& document) {
        if constexpr (std::is_same_v<Document, certify::NetDocument>) {
          return std::move(document.surface);
        } else {
          return std::move(document.net.surface);
        }
      },
      claim);
}

bool is_claim(const std::string& text) {
  if (certify::is_compact(text)) return true;
  certify::ByteStream bytes(text);
  const std::string format = certify::format_of(bytes).value_or("");
  return std::any_of(certify::kClaimKinds.begin(), certify::kClaimKinds.end(),
                     [&](const certify::ClaimKind& kind) { return kind.format == format; });
}

certify::SurfaceDocument surface_in(const std::string& text, const std::string& name) {
  return is_claim(text) ? surface_of(certify::parse_file<certify::ClaimDocument>(text, name))
                        : certify::parse_file<certify::SurfaceDocument>(text, name);
}

}  // namespace

Surface load_surface(const std::filesystem::path& path) {
  return from_document(surface_in(certify::load(path), certify::display_name(path)), path.string());
}

Surface parse_surface_file(const std::string& text, const std::string& name) {
  return from_document(surface_in(text, name), name);
}

}  // namespace epsnet
