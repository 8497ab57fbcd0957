#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/net/darts.h"
#include "certify/net/surface_sides.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/lifts/lifts.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

/// The labels of a document at one precision.
template <class T>
class Evaluator {
 public:
  Evaluator(const certify::NetDocument& document, const certify::SurfaceSides& sides) : parts_(document, sides) {}

  /// Returns the label to 120 bits; nullopt if this precision does not suffice for that.
  [[nodiscard]] std::optional<Isometry<Mp256>> label(const certify::NetDocument::Label& label) const {
    // With determinants 1 a product of k factors is off by at most about k 2^−p times the product of their sizes; a
    // factor itself, made from points as far out as its size says, loses twice its size. The bound is this sum and not
    // the size of the result, as a path may lead far away and return.
    double bits = std::log2(static_cast<double>(label.word.size() + 2)) + 8;
    double largest = 0;
    const auto count = [&](const Isometry<T>& f) {
      const double size = size_in_bits(f);
      bits += size;
      largest = std::max(largest, size);
    };
    Isometry<T> result = parts_.frames[label.from];
    count(result);
    for (const std::uint32_t side : label.word) {
      count(parts_.crossings[side]);
      result = parts_.crossings[side] * result;
    }
    count(parts_.frames[label.to]);
    constexpr double kWanted = 120;
    if (!(bits + 4 * largest + kWanted < kMantissaBits<T>)) return std::nullopt;
    return normalized(convert<Mp256>(inverse(parts_.frames[label.to]) * result));
  }

 private:
  Parts<T> parts_;
};

/// Returns the document if it is sound enough for NetGeometry.
const certify::NetDocument& checked(const certify::NetDocument& document) {
  if (const auto problem = certify::malformation(document)) throw NetGeometryError(*problem);
  if (const auto dart = unpaired_dart(document)) {
    throw NetGeometryError("triangles[" + std::to_string(*dart / 3) + "]: dart " + std::to_string(*dart) +
                           " and its opposite " + std::to_string(certify::opposite(document, *dart)) +
                           " do not belong together");
  }
  return document;
}

/// Returns the genus; 0 if V − E + F gives none.
std::uint32_t genus_of(const certify::SurfaceSides& sides) {
  // Corner s is where side s starts. Across the side before it, the same point is where the partner starts. This is a
  // permutation, whose cycles are the points of the surface.
  std::vector<bool> seen(sides.partner.size(), false);
  std::int64_t points = 0;
  for (std::uint32_t start = 0; start < seen.size(); ++start) {
    if (seen[start]) continue;
    ++points;
    for (std::uint32_t corner = start; !seen[corner]; corner = sides.partner[sides.previous[corner]])
      seen[corner] = true;
  }
  const std::int64_t characteristic =
      points - static_cast<std::int64_t>(seen.size() / 2) + static_cast<std::int64_t>(sides.first.size());
  return characteristic <= 2 && characteristic % 2 == 0 ? static_cast<std::uint32_t>((2 - characteristic) / 2) : 0;
}

/// Evaluates the labels with more and more bits, each with no more than it needs.
class StagedEvaluator {
 public:
  StagedEvaluator(const certify::NetDocument& document, const certify::SurfaceSides& sides)
      : document_(document), sides_(sides), at_256_(document, sides) {}

  [[nodiscard]] Isometry<Mp256> label(std::size_t row) {
    const certify::NetDocument::Label& label = document_.labels[row];
    if (const auto result = at_256_.label(label)) return *result;
    if (!at_1024_) at_1024_.emplace(document_, sides_);
    if (const auto result = at_1024_->label(label)) return *result;
    if (!at_4096_) at_4096_.emplace(document_, sides_);
    if (const auto result = at_4096_->label(label)) return *result;
    throw NetGeometryError("labels[" + std::to_string(row) + "]: needs more than 4096 bits");
  }

 private:
  const certify::NetDocument& document_;
  const certify::SurfaceSides& sides_;
  Evaluator<Mp256> at_256_;
  std::optional<Evaluator<Mp1024>> at_1024_;
  std::optional<Evaluator<Mp4096>> at_4096_;
};

}  // namespace

namespace {

Surface regular_surface(const certify::SurfaceDocument& document) {
  if (document.regular_genus != 0) return Surface::regular(document.regular_genus);
  std::vector<Gluing> gluing;
  for (const auto& [t, k, other_t, other_k] : document.gluing) gluing.push_back({t, k, other_t, other_k});
  return Surface::map({document.map_tile.p, document.map_tile.q}, std::move(gluing));
}

}  // namespace

certify::SurfaceDocument with_rounded_tiles(const certify::SurfaceDocument& surface) {
  if (!certify::regular_tile(surface)) return surface;
  const Surface regular = regular_surface(surface);
  certify::SurfaceDocument result;
  for (const Tile& tile : regular.tiles()) {
    certify::SurfaceDocument::Tile& copy = result.tiles.emplace_back();
    for (const Complex<Rational>& z : tile) copy.push_back(to_gmp(z));
  }
  for (const Gluing& g : regular.gluing()) result.gluing.push_back({g.tile, g.side, g.other_tile, g.other_side});
  return result;
}

std::optional<std::uint32_t> unpaired_dart(const certify::NetDocument& document) {
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    const std::uint32_t other = certify::opposite(document, dart);
    assert(other < 3 * document.triangles.size());
    if (other == dart || certify::opposite(document, other) != dart) return dart;
  }
  return std::nullopt;
}

template <class T>
double size_in_bits(const Isometry<T>& f) {
  const double size = std::sqrt(static_cast<double>(norm(f.a))) + std::sqrt(static_cast<double>(norm(f.b)));
  return std::isfinite(size) ? std::log2(size) : std::numeric_limits<double>::infinity();
}

template <class T>
Parts<T>::Parts(const certify::NetDocument& document, const certify::SurfaceSides& sides) {
  std::optional<Surface> regular;
  if (certify::regular_tile(document.surface)) regular = regular_surface(document.surface);
  for (std::uint32_t side = 0; side < sides.partner.size(); ++side) {
    if (regular) {
      crossings.push_back(regular->crossing_as<T>(SideId(side)));
      continue;
    }
    // The isometry takes side k, from p to q, to side j, from p' to q': p to q' and q to p'.
    const auto corner = [&](std::uint32_t s, std::uint32_t offset) {
      const certify::SurfaceDocument::Tile& corners = document.surface.tiles[sides.tile[s]];
      return rounded<T>(corners[(sides.corner[s] + offset) % corners.size()]);
    };
    const std::uint32_t other = sides.partner[side];
    crossings.push_back(
        normalized(segment_to_segment(corner(side, 0), corner(side, 1), corner(other, 1), corner(other, 0))));
  }
  for (const certify::NetDocument::Chart& chart : document.charts)
    frames.push_back(normalized(Isometry<T>::translation(rounded<T>(chart.centre))));
}

template struct Parts<Mp256>;
template struct Parts<Mp1024>;
template struct Parts<Mp4096>;
template double size_in_bits(const Isometry<Mp256>& f);
template double size_in_bits(const Isometry<Mp1024>& f);
template double size_in_bits(const Isometry<Mp4096>& f);

NetGeometry::NetGeometry(const certify::NetDocument& document)
    : document_(&checked(document)),
      sides_(std::make_shared<const certify::SurfaceSides>(document.surface)),
      genus_(genus_of(*sides_)),
      epsilon_(*certify::parse_decimal(document.epsilon)) {
  StagedEvaluator evaluator(document, *sides_);
  labels_.resize(document.labels.size() + 1);
  for (std::size_t row = 0; row < document.labels.size(); ++row)
    labels_[row + 1] = PreciseIsometry(evaluator.label(row));
}

std::array<Complex<double>, 3> NetGeometry::corners(std::uint32_t triangle) const {
  assert(triangle < document_->triangles.size());
  std::array<Complex<double>, 3> result;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const certify::NetDocument::Vertex& v = document_->vertices[document_->triangles[triangle].vertex[i]];
    const std::uint32_t number = certify::corner_label(*document_, 3 * triangle + i);
    result[i] = number == 0 ? Complex<double>{v.x, v.y} : labels_[number].rounded({v.x, v.y});
  }
  return result;
}

std::array<Complex<double>, 3> NetGeometry::centred_corners(std::uint32_t triangle) const {
  std::array<Complex<double>, 3> z = corners(triangle);
  const std::optional<Complex<double>> centre = circumcentre(z[0], z[1], z[2]);
  const Isometry<double> move = Isometry<double>::translation(-centre.value_or(z[0]));
  for (Complex<double>& corner : z) corner = move(corner);
  const double radius = std::sqrt(norm(z[0]));
  if (radius == 0) return z;
  const Complex<double> turn = (1 / radius) * conj(z[0]);
  for (Complex<double>& corner : z) corner = turn * corner;
  z[0] = {radius, 0};
  return z;
}

double NetGeometry::circumradius(std::uint32_t triangle) const {
  const auto z = corners(triangle);
  const auto sinh2 = sinh2_circumradius(z[0], z[1], z[2]);
  return sinh2.denominator > 0 ? std::asinh(std::sqrt(sinh2.numerator / sinh2.denominator))
                               : std::numeric_limits<double>::infinity();
}

double NetGeometry::edge_length(std::uint32_t dart) const {
  assert(dart < 3 * document_->triangles.size());
  const certify::NetDocument::Vertex& u = document_->vertices[certify::start(*document_, dart)];
  const certify::NetDocument::Vertex& v = document_->vertices[certify::start(*document_, certify::next_dart(dart))];
  const std::uint32_t at_u = certify::corner_label(*document_, dart);
  const std::uint32_t at_v = certify::corner_label(*document_, certify::next_dart(dart));
  if (at_u == at_v) return distance(Complex<double>{u.x, u.y}, Complex<double>{v.x, v.y});
  // More bits are used if the ends are in different charts, which may be far from each other.
  const Isometry<Mp256> label = inverse(labels_[at_u].precise) * labels_[at_v].precise;
  return static_cast<double>(distance(Complex<Mp256>{Mp256(u.x), Mp256(u.y)}, label({Mp256(v.x), Mp256(v.y)})));
}

std::string NetGeometry::epsilon_text() const {
  constexpr std::size_t kShort = 40;
  return document_->epsilon.size() <= kShort ? document_->epsilon : "about " + certify::shortest(epsilon_.get_d());
}

}  // namespace epsnet
