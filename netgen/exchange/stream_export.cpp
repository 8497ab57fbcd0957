#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

#include "certify/check.h"
#include "certify/net/numbering.h"
#include "netgen/base/gmp.h"
#include "netgen/exchange/gaussian_fraction.h"
#include "netgen/exchange/triangulation_stream.h"
#include "netgen/lifts/lifts.h"
#include "netgen/surfaces/surface_file.h"

/// Surfaces and nets as triangulations given by cross-ratios.
namespace epsnet {
namespace {

using Point = Complex<Rational>;
using Corners = std::array<Point, 3>;

/// Throws for a surface that is given by a construction instead of by tiles with rational vertices.
void require_tiles(bool has_tiles) {
  if (!has_tiles) {
    throw ExchangeError(
        "the surface has no rational tiles, so its cross-ratios are not rational; only surfaces with rational vertices "
        "can be written as a triangulation");
  }
}

/// Returns the corners rotated so that the start of the dart comes first.
Corners seen_along(std::uint32_t dart, Corners corners) {
  std::rotate(corners.begin(), corners.begin() + dart % 3, corners.end());
  return corners;
}

/// Returns the cross-ratio of the edge of two glued darts, each given with the corners of its triangle.
Complex<Rational> cross_ratio_of_edge(std::uint32_t dart, const Corners& corners, std::uint32_t opposite,
                                      const Corners& opposite_corners) {
  const Corners own = seen_along(dart, corners);
  const Corners other = seen_along(opposite, opposite_corners);
  const ScaledPoint a = scaled(own[0]);
  const ScaledPoint b = scaled(own[1]);
  const ScaledPoint c = scaled(own[2]);
  const ScaledPoint d = scaled(other[2]);
  // Most triangles already have the edge in common.
  if (own[0] == other[1] && own[1] == other[0]) return value(cross_ratio(a, d, b, c));
  const ScaledPoint other_b = scaled(other[0]);
  const ScaledPoint other_a = scaled(other[1]);
  if (!equally_long(a, b, other_a, other_b)) {
    throw ExchangeError("the triangles do not fit: darts " + std::to_string(dart) + " and " + std::to_string(opposite) +
                        " are glued, but differ in length");
  }
  return value(cross_ratio_of_corners(corner_ratio(a, b, c), corner_ratio(other_a, other_b, d)));
}

/// Returns the stream of `count` triangles, each in its own coordinates (`corners`), glued by darts 3t + i
/// (`opposite`).
template <class Triangles>
TriangulationStream stream_of(Triangles triangles) {
  TriangulationStream stream;
  for (std::uint32_t t = 0; t < triangles.count(); ++t) {
    const auto [a, b, c] = triangles.corners(t);
    if (orientation(klein(scaled(a)), klein(scaled(b)), klein(scaled(c))) <= 0) {
      throw ExchangeError("triangle " + std::to_string(t) + " is not strictly counterclockwise");
    }
    stream.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  for (std::uint32_t d = 0; d < 3 * triangles.count(); ++d) {
    const std::uint32_t e = triangles.opposite(d);
    if (d > e) continue;
    stream.edges.push_back({d, e, cross_ratio_of_edge(d, triangles.corners(d / 3), e, triangles.corners(e / 3))});
  }
  stream.anchors = {{0, triangles.corners(0)}};
  return stream;
}

/// The tiles of a surface, cut by the diagonals from their vertex 0.
class TriangulatedTiles {
 public:
  explicit TriangulatedTiles(const Surface& surface) : surface_(surface) {
    require_tiles(!surface.is_regular());
    ById<SideId, std::uint32_t> dart_of_side;
    for (const TileId tile : surface.tile_ids()) cut(tile, dart_of_side);
    for (const SideId s : dart_of_side.ids()) {
      opposite_[dart_of_side[s]] = dart_of_side[surface.partner(s)];
    }
  }

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(triangles_.size()); }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t dart) const { return opposite_[dart]; }
  [[nodiscard]] Corners corners(std::uint32_t t) {
    const auto [tile, second] = triangles_[t];
    const Tile& vertices = surface_.tile(tile);
    return {vertices[0], vertices[second], vertices[second + 1]};
  }

 private:
  void cut(TileId tile, ById<SideId, std::uint32_t>& dart_of_side) {
    const auto size = static_cast<std::uint32_t>(surface_.tile(tile).size());
    const std::uint32_t first = count();
    const std::uint32_t last = first + size - 3;
    dart_of_side.push_back(3 * first);
    for (std::uint32_t t = first; t <= last; ++t) {
      triangles_.push_back({tile, t - first + 1});
      dart_of_side.push_back(3 * t + 1);
      // Darts 0 and 2 of a triangle are diagonals, except for the very first and the very last one, which are sides.
      opposite_.insert(opposite_.end(), {3 * (t - 1) + 2, 0, 3 * (t + 1)});
    }
    dart_of_side.push_back(3 * last + 2);
  }

  struct Piece {
    TileId tile;
    std::uint32_t second;  ///< The corners are the vertices 0, `second` and the next one.
  };

  const Surface& surface_;
  std::vector<Piece> triangles_;
  std::vector<std::uint32_t> opposite_;
};

/// Returns the same isometry; its coefficients are Gaussian integers without a common integer factor.
Isometry<Rational> integral(const Isometry<Rational>& f) {
  Integer denominators = 1;
  Integer content = 0;
  for (const Rational& q : {f.a.x, f.a.y, f.b.x, f.b.y}) denominators = lcm(denominators, Integer(denominator(q)));
  const Rational scale(denominators);
  const Isometry<Rational> scaled{scale * f.a, scale * f.b};
  for (const Rational& q : {scaled.a.x, scaled.a.y, scaled.b.x, scaled.b.y})
    content = gcd(content, Integer(numerator(q)));
  const Rational reciprocal = Rational(1) / Rational(content);
  return {reciprocal * scaled.a, reciprocal * scaled.b};
}

/// The triangles of a net document, in the charts of their first corners.
class NetTriangles {
 public:
  explicit NetTriangles(const certify::NetDocument& net) : net_(net) {
    if (const auto problem = certify::malformation(net)) throw ExchangeError("not a net: " + *problem);
    require_tiles(!net.surface.tiles.empty());
    if (net.triangles.empty()) throw ExchangeError("not a net: there are no triangles");
    check_darts();
    evaluate_labels();
  }

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(net_.triangles.size()); }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t dart) const { return certify::opposite(net_, dart); }
  [[nodiscard]] Corners corners(std::uint32_t t) {
    const certify::NetDocument::Triangle& triangle = net_.triangles[t];
    if (triangle.label[0] == 0 && triangle.label[1] == 0) return computed_corners(triangle);
    const auto [known, is_new] = labelled_.try_emplace(t);
    if (is_new) known->second = computed_corners(triangle);
    return known->second;
  }

 private:
  /// Checks that darts are paired, and that paired darts join the same vertices in opposite directions.
  void check_darts() const {
    std::optional<std::uint32_t> wrong = unpaired_dart(net_);
    for (std::uint32_t d = 0; d < 3 * count() && !wrong; ++d) {
      if (certify::start(net_, d) != certify::start(net_, certify::next_dart(opposite(d)))) wrong = d;
    }
    if (!wrong) return;
    throw ExchangeError("not a net: dart " + std::to_string(*wrong) + " and its opposite " +
                        std::to_string(opposite(*wrong)) + " do not belong together");
  }

  void evaluate_labels() {
    if (net_.labels.empty()) return;
    const Surface surface = from_document(net_.surface);
    for (const certify::NetDocument::Label& label : net_.labels) {
      Isometry<Rational> path;
      for (const SideId side : word_of_letters(label.word)) path = surface.crossing(side) * path;
      const auto to = Isometry<Rational>::translation(from_gmp(net_.charts[label.to].centre));
      const auto from = Isometry<Rational>::translation(from_gmp(net_.charts[label.from].centre));
      labels_.push_back(integral(inverse(to) * path * from));
    }
  }

  [[nodiscard]] Corners computed_corners(const certify::NetDocument::Triangle& triangle) const {
    return {corner(triangle.vertex[0], 0), corner(triangle.vertex[1], triangle.label[0]),
            corner(triangle.vertex[2], triangle.label[1])};
  }
  [[nodiscard]] Point corner(std::uint32_t v, std::uint32_t label) const {
    const Point z{Rational(net_.vertices[v].x), Rational(net_.vertices[v].y)};
    return label == 0 ? z : labels_[label - 1](z);
  }

  const certify::NetDocument& net_;
  std::vector<Isometry<Rational>> labels_;
  /// Corners of triangles that have labels. They are kept, as they are few and their numbers are large.
  std::unordered_map<std::uint32_t, Corners> labelled_;
};

}  // namespace

TriangulationStream triangulation_stream(const Surface& surface) { return stream_of(TriangulatedTiles(surface)); }

TriangulationStream triangulation_stream(const certify::NetDocument& net) {
  try {
    return stream_of(NetTriangles(net));
  } catch (const SurfaceError& error) {
    throw ExchangeError(std::string("not a net: ") + error.what());
  }
}

void write_triangulation(const Surface& surface, std::ostream& out) {
  write_triangulation_stream(triangulation_stream(surface), out);
}

void write_triangulation(const certify::NetDocument& net, std::ostream& out) {
  write_triangulation_stream(triangulation_stream(net), out);
}

}  // namespace epsnet
