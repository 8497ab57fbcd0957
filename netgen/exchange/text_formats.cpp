#include "netgen/exchange/text_formats.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/net/numbering.h"
#include "netgen/base/gmp.h"
#include "netgen/exchange/anchor_search.h"
#include "netgen/lifts/lifts.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/exact_polygons.h"

/// Surfaces and nets as triangulations given by cross-ratios.
namespace epsnet {
namespace {

constexpr std::size_t kManySides = 256;

struct Domain {
  Tile polygon;
  std::vector<Gluing> gluing;
};

std::vector<Gluing> read_pairing(TokenReader& words, std::uint32_t size) {
  std::vector<std::uint32_t> partner;
  std::vector<std::size_t> line;
  const std::string range =
      ", from 0 to " + std::to_string(size - 1) + " (the text claims " + std::to_string(size) + " sides)";
  // The vectors grow with the text, not with the number of sides that it claims.
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::string expected = "the index of the side paired with side " + std::to_string(k) + range;
    partner.push_back(words.index(expected));
    line.push_back(words.line());
    if (partner[k] >= size) words.fail(std::to_string(partner[k]) + " found, expected " + expected);
    if (partner[k] == k) words.fail("side " + std::to_string(k) + " is paired with itself");
  }
  std::vector<Gluing> gluing;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (partner[partner[k]] != k) {
      words.fail_at(line[k], "side " + std::to_string(k) + " is paired with side " + std::to_string(partner[k]) +
                                 ", but side " + std::to_string(partner[k]) + " with side " +
                                 std::to_string(partner[partner[k]]));
    }
    if (k < partner[k]) gluing.push_back({0, k, 0, partner[k]});
  }
  return gluing;
}

Domain parse(std::string_view text, std::string_view name) {
  TokenReader words(text, name);
  const std::uint32_t size = words.index("the number of sides, an even number from 8 to 2^32 - 2");
  if (size < 8 || size % 2 != 0) {
    words.fail(std::to_string(size) + " sides found, expected an even number, at least 8 (genus 2)");
  }
  Domain domain;
  domain.gluing = read_pairing(words, size);
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::string vertex = "vertex " + std::to_string(k);
    const Complex<Rational> z{words.rational("the x coordinate of " + vertex),
                              words.rational("the y coordinate of " + vertex)};
    if (disk_gap(scaled(z)) <= 0) {
      words.fail(vertex + " lies outside of the open unit disk, expected |z| < 1, found |z|^2 = " +
                 certify::shortest(static_cast<double>(Mp256(norm(z)))));
    }
    domain.polygon.push_back(z);
  }
  words.expect_end("the last vertex");
  return domain;
}

Surface make_surface(Domain domain) {
  std::vector<Tile> tiles{std::move(domain.polygon)};
  std::vector<Gluing> gluing;
  {
    GluedPolygons polygon(tiles, domain.gluing);
    polygon.check_vertices();
    const std::optional<std::string> problem = polygon.convexity_problem();
    if (!problem) return {std::move(tiles), std::move(domain.gluing)};
    if (tiles[0].size() > kMaxNonConvexSides) {
      throw SurfaceError(*problem + "; polygons that are not convex may have at most " +
                         std::to_string(kMaxNonConvexSides) + " sides");
    }
    // "Intersects itself" is a better message than "lengths differ", so that test comes first. For large polygons the
    // quick tests come first, so that junk does not reach the quadratic one.
    if (tiles[0].size() > kManySides) {
      polygon.check_lengths();
      polygon.check_angles();
    }
    if (const auto pair = crossing_sides(polygon.klein_points())) {
      throw SurfaceError("the polygon intersects itself: side " + std::to_string(pair->first) + " meets side " +
                         std::to_string(pair->second));
    }
    if (polygon.clockwise(TileId(0))) throw SurfaceError(*problem);
    polygon.check_lengths();
    polygon.check_angles();
    PolygonTriangulation triangulation = clip_ears(polygon.klein_points());
    const Tile vertices = std::move(tiles[0]);
    tiles.clear();
    for (const auto& [a, b, c] : triangulation.triangles) tiles.push_back({vertices[a], vertices[b], vertices[c]});
    gluing = std::move(triangulation.diagonals);
    for (const Gluing& pair : domain.gluing) {
      const auto [tile, side] = triangulation.place_of_side[pair.side];
      const auto [other_tile, other_side] = triangulation.place_of_side[pair.other_side];
      gluing.push_back({tile, side, other_tile, other_side});
    }
  }
  return {std::move(tiles), std::move(gluing)};
}

}  // namespace

Surface read_domain(std::string_view text, std::string_view name) {
  Domain domain = parse(text, name);
  try {
    return make_surface(std::move(domain));
  } catch (const SurfaceError& error) {
    throw ExchangeError(certify::ErrorParts{.file = std::string(name), .problem = error.what()});
  }
}

std::string write_domain(const Surface& surface) {
  if (!surface.is_rational()) {
    throw ExchangeError(
        "a polygon over a number field or a regular one has no rational vertices, so the domain format cannot hold it");
  }
  if (surface.tiles().size() != 1) {
    throw ExchangeError("the domain format holds one polygon, the surface has " +
                        std::to_string(surface.tiles().size()) + " tiles; the triangulation format holds them");
  }
  std::string text = std::to_string(surface.side_count()) + "\n";
  for (const SideId s : surface.side_ids()) text += to_string(surface.partner(s)) + "\n";
  const auto fraction = [](const Rational& value) { return numerator(value).str() + "/" + denominator(value).str(); };
  for (const auto& [x, y] : surface.tiles()[0]) text += fraction(x) + " " + fraction(y) + "\n";
  return text;
}

namespace {

constexpr std::uint32_t kUnset = ~std::uint32_t{0};

class Reader {
 public:
  Reader(std::string_view text, std::string_view name) : text_size_(text.size()), words_(text, name) {}

  TriangulationStream read() {
    read_dart_count();
    const bool all_anchored = read_anchor();
    read_triangles(all_anchored);
    read_edges();
    words_.expect_end("the last edge");
    return std::move(stream_);
  }

 private:
  void read_dart_count() {
    darts_ = words_.index("the number of darts, a positive multiple of 6 below 2^32");
    if (darts_ == 0 || darts_ % 6 != 0) {
      words_.fail(std::to_string(darts_) +
                  " darts found, expected a positive multiple of 6 (triangles have three, edges two)");
    }
    // The sizes of tables below are proportional to this number, so it may not exceed the length of the text.
    if (darts_ > text_size_) {
      words_.fail("the text claims " + std::to_string(darts_) + " darts, but has only " + std::to_string(text_size_) +
                  " bytes");
    }
    range_ = ", from 0 to " + std::to_string(darts_ - 1) + " (the text claims " + std::to_string(darts_) + " darts)";
  }

  /// Reads the anchor, if there is one here. Returns true if a dart comes instead: then each triangle has its own
  /// anchor.
  bool read_anchor() {
    const std::string expected =
        "\"yes\" or \"no\": whether there is an anchor, or the first dart of triangle 0" + range_;
    const std::string_view word = TokenReader(words_).next(expected);
    if (word.find_first_not_of("0123456789") == std::string_view::npos) return true;
    static_cast<void>(words_.next(expected));
    if (word == "no") return false;
    if (word != "yes") words_.fail(certify::in_quotes(word) + " found, expected " + expected);
    read_lift("the anchor");
    return false;
  }

  /// Reads a dart and the points of its triangle.
  void read_lift(const std::string& name) {
    TriangulationStream::Anchor& anchor = stream_.anchors.emplace_back();
    anchor.dart = dart("the dart of " + name);
    if (!stream_.triangles.empty()) {
      const TriangulationStream::Triangle& triangle = stream_.triangles.back();
      if (std::find(triangle.begin(), triangle.end(), anchor.dart) == triangle.end()) {
        words_.fail("dart " + std::to_string(anchor.dart) + " found, expected the dart of " + name +
                    ", one of this triangle");
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      anchor.points[i] = complex("point " + std::to_string(i) + " of " + name, "x coordinate", "y coordinate");
    }
  }

  void read_triangles(bool all_anchored) {
    std::vector<std::uint32_t> triangle_of(darts_, kUnset);
    for (std::uint32_t t = 0; t < darts_ / 3; ++t) {
      const std::string place = " of triangle " + std::to_string(t);
      const auto next_dart = [&](const char* which) {
        const std::uint32_t d = dart(which + place);
        claim(triangle_of, d, t, "triangle");
        return d;
      };
      const std::uint32_t first = next_dart("the first dart");
      const std::uint32_t last = next_dart("the dart before the first one");
      const std::uint32_t second = next_dart("the dart after the first one");
      stream_.triangles.push_back({first, second, last});
      if (all_anchored) read_lift("the anchor" + place);
    }
  }

  void read_edges() {
    std::vector<std::uint32_t> edge_of(darts_, kUnset);
    for (std::uint32_t e = 0; e < darts_ / 2; ++e) {
      const std::string place = " of edge " + std::to_string(e);
      const std::uint32_t first = dart("the first dart" + place);
      claim(edge_of, first, e, "edge");
      const std::uint32_t second = dart("the second dart" + place);
      claim(edge_of, second, e, "edge");
      stream_.edges.push_back({first, second, complex("the cross-ratio" + place, "real part", "imaginary part")});
    }
  }

  std::uint32_t dart(const std::string& what) {
    const std::string expected = what + range_;
    const std::uint32_t d = words_.index(expected);
    if (d >= darts_) words_.fail(std::to_string(d) + " found, expected " + expected);
    return d;
  }

  /// Records the triangle or edge to which a dart belongs. Fails if it belongs to two, or twice to one.
  void claim(std::vector<std::uint32_t>& owner, std::uint32_t d, std::uint32_t by, const std::string& kind) {
    if (owner[d] == by) {
      words_.fail("dart " + std::to_string(d) + " occurs twice in " + kind + " " + std::to_string(by));
    }
    if (owner[d] != kUnset) {
      words_.fail("dart " + std::to_string(d) + " belongs to " + kind + " " + std::to_string(owner[d]) + " and to " +
                  kind + " " + std::to_string(by));
    }
    owner[d] = by;
  }

  Complex<Rational> complex(const std::string& what, const char* x, const char* y) {
    Rational first = words_.rational("the " + (x + (" of " + what)));
    return {std::move(first), words_.rational("the " + (y + (" of " + what)))};
  }

  std::size_t text_size_;
  TokenReader words_;
  std::uint32_t darts_ = 0;
  std::string range_;
  TriangulationStream stream_;
};

}  // namespace

bool is_triangulation_stream(std::string_view text) {
  constexpr std::string_view kWhiteSpace = " \t\n\v\f\r";
  const auto next = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(kWhiteSpace), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(kWhiteSpace));
    text.remove_prefix(word.size());
    return word;
  };
  const std::string_view count = next();
  const std::string_view second = next();
  if (second == "yes" || second == "no") return true;
  std::uint32_t darts = 0;
  if (std::from_chars(count.data(), count.data() + count.size(), darts).ec != std::errc() || darts % 6 != 0)
    return false;
  for (std::size_t i = 2; i < 5; ++i) static_cast<void>(next());
  bool has_fraction = false;
  for (std::size_t i = 5; i < 11; ++i) has_fraction |= next().find('/') != std::string_view::npos;
  return has_fraction;
}

TriangulationStream read_triangulation_stream(std::string_view text, std::string_view name) {
  return Reader(text, name).read();
}

void write_triangulation_stream(const TriangulationStream& stream, std::ostream& out) {
  const bool all_anchored = stream.anchors.size() > 1;
  out << 3 * stream.triangles.size() << '\n';
  if (!all_anchored) out << (stream.anchors.empty() ? "no" : "yes") << '\n';
  if (stream.anchors.size() == 1) {
    out << stream.anchors[0].dart << '\n';
    for (const auto& [x, y] : stream.anchors[0].points) out << x.str() << ' ' << y.str() << '\n';
  }
  for (std::size_t t = 0; t < stream.triangles.size(); ++t) {
    const auto& [first, second, last] = stream.triangles[t];
    out << first << '\n' << last << '\n' << second << '\n';
    if (!all_anchored) continue;
    out << stream.anchors[t].dart << '\n';
    for (const auto& [x, y] : stream.anchors[t].points) out << x.str() << '\n' << y.str() << '\n';
  }
  for (const auto& [dart, opposite, ratio] : stream.edges) {
    out << dart << '\n' << opposite << '\n' << ratio.x.str() << '\n' << ratio.y.str() << '\n';
  }
}

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
    require_tiles(surface.is_rational());
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

namespace {

KleinVector swapped(const KleinVector& p) { return {p.y, p.x, p.t}; }

/// Returns the position of each point in the lexicographic order; equal points have the same position.
std::vector<std::uint32_t> ranks(std::span<const KleinVector> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(points[i], points[j]); });
  std::vector<std::uint32_t> rank(points.size());
  for (std::size_t k = 1; k < order.size(); ++k) {
    rank[order[k]] = rank[order[k - 1]] + (lexicographically_less(points[order[k - 1]], points[order[k]]) ? 1 : 0);
  }
  return rank;
}

/// The vertices of a polygon, and ranks that show without arithmetic that bounding boxes are disjoint.
///
/// The points of a segment lie between its ends in both lexicographic orders (x, y) and (y, x).
class Polygon {
 public:
  explicit Polygon(std::span<const KleinVector> points) : points_(points), rank_{ranks(points), {}} {
    std::vector<KleinVector> mirrored;
    for (const KleinVector& p : points) {
      mirrored.push_back(swapped(p));
      const Mp256 t(p.t);
      rounded_.push_back({static_cast<double>(Mp256(p.x) / t), static_cast<double>(Mp256(p.y) / t)});
    }
    rank_[1] = ranks(mirrored);
  }

  /// Returns the sign of the turn a, b, c, by doubles if they can decide it.
  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    // Coordinates are off by 2⁻⁵³, differences, at most 2, by 2⁻⁵¹, products by 2⁻⁴⁹ + 2⁻⁵¹, the determinant by less
    // than 2⁻⁴⁷.
    const double determinant = cross(rounded_[b] - rounded_[a], rounded_[c] - rounded_[a]);
    if (std::fabs(determinant) > 0x1p-47) return sign(determinant);
    return orientation(points_[a], points_[b], points_[c]);
  }

  /// Whether v lies on the closed segment ab.
  [[nodiscard]] bool on_segment(std::uint32_t v, std::uint32_t a, std::uint32_t b) const {
    return in_box(v, {a, b}) && turn(a, b, v) == 0;
  }

  /// Whether the closed segments ab and cd have a common point.
  [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    for (const auto& rank : rank_) {
      if (std::max(rank[a], rank[b]) < std::min(rank[c], rank[d])) return false;
      if (std::max(rank[c], rank[d]) < std::min(rank[a], rank[b])) return false;
    }
    if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    return on_segment(c, a, b) || on_segment(d, a, b) || on_segment(a, c, d) || on_segment(b, c, d);
  }

  /// Whether v lies in the closed triangle abc, which is counterclockwise.
  [[nodiscard]] bool in_triangle(std::uint32_t v, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return in_box(v, {a, b, c}) && turn(a, b, v) >= 0 && turn(b, c, v) >= 0 && turn(c, a, v) >= 0;
  }

 private:
  [[nodiscard]] bool in_box(std::uint32_t v, std::initializer_list<std::uint32_t> corners) const {
    return std::all_of(rank_.begin(), rank_.end(), [&](const std::vector<std::uint32_t>& rank) {
      const auto [low, high] = std::minmax_element(corners.begin(), corners.end(),
                                                   [&](std::uint32_t i, std::uint32_t j) { return rank[i] < rank[j]; });
      return rank[*low] <= rank[v] && rank[v] <= rank[*high];
    });
  }

  std::span<const KleinVector> points_;
  std::vector<Complex<double>> rounded_;
  std::array<std::vector<std::uint32_t>, 2> rank_;
};

/// The polygon while its ears are being clipped: a circular list of the remaining vertices.
class Clipping {
 public:
  explicit Clipping(std::span<const KleinVector> points)
      : polygon_(points),
        size_(static_cast<std::uint32_t>(points.size())),
        next_(size_),
        previous_(size_),
        edge_(size_) {
    for (std::uint32_t v = 0; v < size_; ++v) {
      next_[v] = v + 1 == size_ ? 0 : v + 1;
      previous_[next_[v]] = v;
    }
    result_.place_of_side.resize(size_);
  }

  PolygonTriangulation run() {
    std::vector<bool> ear(size_);
    for (std::uint32_t v = 0; v < size_; ++v) ear[v] = is_ear(v);
    std::uint32_t v = 0;
    for (std::uint32_t left = size_; left > 3; --left) {
      // There are always two ears (a clipped ear leaves a simple polygon without degenerate parts). Clipping one only
      // affects the two neighbours: other ears are blocked only by vertices that are not strictly convex, and such a
      // vertex is never clipped.
      std::uint32_t steps = 0;
      while (!ear[v]) {
        if (++steps > left) throw std::logic_error("no ear was found in a simple polygon");
        v = next_[v];
      }
      const std::uint32_t before = previous_[v];
      const std::uint32_t after = next_[v];
      const std::uint32_t triangle = add_triangle(before, v, after);
      next_[before] = after;
      previous_[after] = before;
      edge_[before] = {triangle, 2};
      ear[before] = is_ear(before);
      ear[after] = is_ear(after);
      // Skipping the neighbour avoids fans.
      v = next_[after];
    }
    const std::uint32_t triangle = add_triangle(previous_[v], v, next_[v]);
    attach(next_[v], triangle, 2);
    return std::move(result_);
  }

 private:
  /// The triangle, and its side, beyond the edge from a remaining vertex to the next one; nullopt for a side of the
  /// polygon.
  using Beyond = std::optional<std::pair<std::uint32_t, std::uint32_t>>;

  [[nodiscard]] bool is_ear(std::uint32_t v) const {
    const std::uint32_t a = previous_[v];
    const std::uint32_t b = next_[v];
    if (polygon_.turn(a, v, b) <= 0) return false;
    for (std::uint32_t u = next_[b]; u != a; u = next_[u]) {
      if (polygon_.in_triangle(u, a, v, b)) return false;
    }
    return true;
  }

  std::uint32_t add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto triangle = static_cast<std::uint32_t>(result_.triangles.size());
    result_.triangles.push_back({a, b, c});
    attach(a, triangle, 0);
    attach(b, triangle, 1);
    return triangle;
  }

  /// Makes the edge that starts at v the side `side` of the triangle.
  void attach(std::uint32_t v, std::uint32_t triangle, std::uint32_t side) {
    if (edge_[v]) {
      result_.diagonals.push_back({edge_[v]->first, edge_[v]->second, triangle, side});
    } else {
      result_.place_of_side[v] = {triangle, side};
    }
  }

  Polygon polygon_;
  std::uint32_t size_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> previous_;
  std::vector<Beyond> edge_;
  PolygonTriangulation result_;
};

}  // namespace

std::optional<std::pair<std::uint32_t, std::uint32_t>> crossing_sides(std::span<const KleinVector> polygon) {
  const Polygon vertices(polygon);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  const auto next = [n](std::uint32_t v) { return v + 1 == n ? 0 : v + 1; };
  for (std::uint32_t i = 0; i < n; ++i) {
    // Consecutive sides share a vertex; they must not turn back on one another.
    const std::uint32_t j = next(i);
    if (vertices.on_segment(i, j, next(j)) || vertices.on_segment(next(j), i, j)) return std::pair{i, j};
    for (std::uint32_t k = i + 2; k < n; ++k) {
      if (next(k) != i && vertices.meet(i, j, k, next(k))) return std::pair{i, k};
    }
  }
  return std::nullopt;
}

PolygonTriangulation clip_ears(std::span<const KleinVector> polygon) { return Clipping(polygon).run(); }

}  // namespace epsnet
