#include "netgen/exchange/exchange.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <ostream>
#include <queue>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/exchange/anchor_search.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/lifts/lifts.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {

Surface import_surface(std::string_view text, std::string_view name, ExchangeFormat format) {
  if (text.size() > kMaxTextBytes)
    throw ExchangeError(certify::ErrorParts{.file = std::string(name), .problem = "is larger than 256 MiB"});
  const bool guess = format == ExchangeFormat::automatic;
  if (format == ExchangeFormat::triangulation || (guess && is_triangulation_stream(text))) {
    return develop(read_triangulation_stream(text, name), name);
  }
  try {
    return read_domain(text, name);
  } catch (const ExchangeError& error) {
    if (!guess) throw;
    const std::string reading =
        " (read as the domain format: the second token is neither \"yes\" nor \"no\", nor do points of a first "
        "triangle follow, as in the triangulation formats)";
    certify::ErrorParts parts = error.parts();
    parts.problem += reading;
    throw ExchangeError(error.what() + reading, parts);
  }
}

namespace {

constexpr std::size_t kMostLetters = 10'000'000;  // Of all words of a net file (docs/format.md).

// The tiles are triangles, so sides and darts have the same numbers, 3t + i.

/// The direction of a label along a side: from the chart of its end to that of its start, or the reverse.
enum class Way { to_start, to_end };

constexpr Way reverse(Way way) { return way == Way::to_start ? Way::to_end : Way::to_start; }

class Builder {
 public:
  Builder(const Surface& surface, const Length& epsilon) : surface_(surface), path_(surface.side_count()) {
    net_.surface = to_document(surface);
    net_.epsilon = epsilon.text();
  }

  certify::NetDocument net() {
    for (const SideId corner : surface_.side_ids()) {
      if (surface_.vertex_class(corner) == net_.vertices.size()) add_vertex(corner);
    }
    for (const TileId t : surface_.tile_ids()) add_triangle(t);
    return std::move(net_);
  }

 private:
  /// Adds the vertex of a corner, the first one of its class, and finds the words from the corner's tile to the other
  /// tiles around the vertex.
  void add_vertex(SideId corner) {
    const std::uint32_t tile = surface_.tile_of_side(corner).number();
    net_.charts.push_back({tile, net_.surface.tiles[tile][surface_.place_in_tile(corner)]});
    net_.vertices.push_back({0, 0, static_cast<std::uint32_t>(net_.vertices.size())});
    for (SideId c = corner;;) {
      // Moves counterclockwise across the side that ends at the vertex; its partner starts there.
      const SideId side = surface_.previous_side(c);
      const SideId next = surface_.partner(side);
      if (next == corner) return;
      path_[next] = concatenated(surface_, path_[c], {side});
      count_letters(path_[next], path_letters_);
      c = next;
    }
  }

  void add_triangle(TileId t) {
    certify::NetDocument::Triangle& triangle = net_.triangles.emplace_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const SideId side = surface_.side_number(t, i);
      triangle.vertex[i] = surface_.vertex_class(side);
      triangle.opposite[i] = surface_.partner(side).number();
    }
    triangle.label = {label(surface_.side_number(t, 0), Way::to_start), label(surface_.side_number(t, 2), Way::to_end)};
  }

  /// Returns the label along a side. Its word is that of the triangle with the smaller number on either side of it, so
  /// both triangles use the same label.
  std::uint32_t label(SideId side, Way way) {
    const SideId partner = surface_.partner(side);
    if (partner < side) return label(partner, reverse(way));
    // The label leads from `start` to `end`.
    const SideId next = surface_.next_side(side);
    const SideId start = way == Way::to_end ? side : next;
    const SideId end = way == Way::to_end ? next : side;
    const std::uint32_t from = surface_.vertex_class(start);
    const std::uint32_t to = surface_.vertex_class(end);
    const Word word = concatenated(surface_, path_[start], reversed(surface_, path_[end]));
    if (from == to && word.empty()) return 0;
    const auto [known, is_new] =
        labels_.try_emplace({from, to, word}, static_cast<std::uint32_t>(net_.labels.size() + 1));
    if (is_new) {
      count_letters(word, label_letters_);
      net_.labels.push_back({from, to, letters_of(word)});
    }
    return known->second;
  }

  static void count_letters(const Word& word, std::size_t& letters) {
    letters += word.size();
    if (letters > kMostLetters) {
      throw ExchangeError(
          "the triangulation has vertices of so many triangles that its words have more than 10^7 letters, the limit "
          "of a net file");
    }
  }

  const Surface& surface_;
  certify::NetDocument net_;
  /// By corner: the word from the tile of the chart of its vertex to its own tile.
  ById<SideId, Word> path_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, Word>, std::uint32_t> labels_;
  std::size_t path_letters_ = 0;
  std::size_t label_letters_ = 0;
};

}  // namespace

certify::NetDocument net_of_tiles(const Surface& surface, const Length& epsilon) {
  for (const TileId t : surface.tile_ids()) {
    if (!surface.is_rational() || surface.tile(t).size() != 3) {
      throw ExchangeError("tile " + to_string(t) + " has " + std::to_string(surface.tile(t).size()) +
                          " sides, expected triangles: the triangulation is to be that of the tiles");
    }
  }
  return Builder(surface, epsilon).net();
}

void write_edges(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  out << "u\tv\tlength\n";
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    if (certify::opposite(net, dart) < dart) continue;
    out << certify::start(net, dart) << '\t' << certify::start(net, certify::next_dart(dart)) << '\t'
        << certify::shortest(geometry.edge_length(dart)) << '\n';
  }
}

void write_edges(const Surface& surface, std::ostream& out) {
  out << "u\tv\tleft\tright\tlength\n";
  for (const SideId side : surface.side_ids()) {
    const SideId partner = surface.partner(side);
    if (partner < side) continue;
    const TileId left = surface.tile_of_side(side);
    const Tile& tile = surface.tile(left);
    const std::size_t k = surface.place_in_tile(side);
    out << surface.vertex_class(side) << '\t' << surface.vertex_class(surface.next_side(side)) << '\t' << left.number()
        << '\t' << surface.tile_of_side(partner).number() << '\t'
        << certify::shortest(distance(convert<double>(tile[k]), convert<double>(tile[(k + 1) % tile.size()]))) << '\n';
  }
}

void write_adjacency(const certify::NetDocument& net, GraphNodes nodes, std::ostream& out) {
  static_cast<void>(NetGeometry(net));  // Throws unless it is a net.
  const bool of_vertices = nodes == GraphNodes::vertices;
  // The lower triangle, column by column. A loop counts twice, so that the sums of rows are degrees.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> entries;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t other = certify::opposite(net, dart);
    if (other < dart) continue;
    const std::uint32_t u = of_vertices ? certify::start(net, dart) : dart / 3;
    const std::uint32_t v = of_vertices ? certify::start(net, certify::next_dart(dart)) : other / 3;
    entries[std::minmax(u, v)] += u == v ? 2 : 1;
  }
  const std::size_t size = of_vertices ? net.vertices.size() : net.triangles.size();
  out << "%%MatrixMarket matrix coordinate integer symmetric\n" << size << ' ' << size << ' ' << entries.size() << '\n';
  for (const auto& [ends, count] : entries) out << ends.second + 1 << ' ' << ends.first + 1 << ' ' << count << '\n';
}

// The surface of a triangulation given by cross-ratios: triangles are placed one after the other, breadth first,
// starting with the anchors.

namespace {

using Point = Complex<Rational>;
using Corners = std::array<Point, 3>;

constexpr std::uint32_t kNoTile = ~std::uint32_t{0};
constexpr std::size_t kMaxBits = 3'321'928;  // 10^6 decimal digits, the limit of surface files.
constexpr std::size_t kMaxGrowth = 1000;
/// Euclid's algorithm takes quadratic time; numbers with such common factors are left as they are.
constexpr std::size_t kMaxReducedBits = 20'000;

using epsnet::bits;
std::size_t bits(const Rational& q) { return bits(Integer(numerator(q))) + bits(Integer(denominator(q))); }
std::size_t bits(const Point& z) { return bits(z.x) + bits(z.y); }
std::size_t bits(const Corners& corners) { return bits(corners[0]) + bits(corners[1]) + bits(corners[2]); }

std::string decimal(const Rational& q) { return certify::shortest(static_cast<double>(Mp256(q))); }
std::string decimal(const Point& z) { return "(" + decimal(z.x) + ", " + decimal(z.y) + ")"; }

bool counterclockwise(const ScaledPoint& a, const ScaledPoint& b, const ScaledPoint& c) {
  return orientation(klein(a), klein(b), klein(c)) > 0;
}

/// Returns a Gaussian integer j such that z times j̄/j is simple: it has the least denominator of all numbers of Q(i)
/// with the modulus of z.
///
/// For z = n/d in lowest terms j is gcd(n, d̄), so that z = j n'/(j̄ d'). All common factors divide gcd(|n|², m²) for z =
/// n/m, which is usually small.
Complex<Integer> simplifying_turn(const ScaledPoint& z) {
  const Integer common = gcd(norm(z.n), Integer(z.m * z.m));
  if (common == 1 || bits(common) > kMaxReducedBits) return {1, 0};
  const Complex<Integer> modulus{common, 0};
  const Complex<Integer> m{z.m, 0};
  const Complex<Integer> factor = gaussian_gcd(gaussian_gcd(modulus, z.n), m);
  const Complex<Integer> n = nearest(z.n, factor);  // Exact.
  const Complex<Integer> d = nearest(m, factor);
  return gaussian_gcd(gaussian_gcd(modulus, n), conj(d));
}

/// Returns the triangle in simple coordinates: corner 0 moved to 0, then rotated.
Corners simplified(const Corners& corners) {
  const ScaledPoint origin = scaled(corners[0]);
  const GaussianFraction first = seen_from(origin, scaled(corners[1]));
  const GaussianFraction second = seen_from(origin, scaled(corners[2]));
  const Complex<Integer> j = simplifying_turn(scaled(value(first)));
  return {Point{0, 0}, value({conj(j) * first.n, j * first.d}), value({conj(j) * second.n, j * second.d})};
}

/// The place of a dart: side `side` of tile `tile`.
struct Place {
  std::uint32_t tile = kNoTile;
  std::uint32_t side = 0;
};

class Development {
 public:
  Development(const TriangulationStream& stream, std::string_view name)
      : stream_(stream),
        name_(name),
        anchors_(stream.anchors),
        tiles_(stream.triangles.size()),
        limit_(stream.triangles.size()),
        place_(3 * stream.triangles.size()),
        edge_(3 * stream.triangles.size()),
        is_used_(stream.edges.size()) {
    for (std::uint32_t t = 0; t < stream.triangles.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) place_[stream.triangles[t][i]] = {t, i};
    }
    for (std::uint32_t e = 0; e < stream.edges.size(); ++e) {
      edge_[stream.edges[e].dart] = edge_[stream.edges[e].opposite] = e;
      room_ += kMaxGrowth * bits(stream.edges[e].cross_ratio);
    }
  }

  Surface surface() {
    place_anchors();
    place_others();
    for (std::uint32_t e = 0; e < stream_.edges.size(); ++e) {
      if (!is_used_[e]) check_edge(stream_.edges[e]);
    }
    std::vector<Gluing> gluing;
    for (const auto& [dart, opposite, ratio] : stream_.edges) {
      const auto [tile, side] = place_[dart];
      const auto [other_tile, other_side] = place_[opposite];
      gluing.push_back({tile, side, other_tile, other_side});
    }
    std::vector<Tile> tiles;
    for (const Corners& corners : tiles_) tiles.emplace_back(corners.begin(), corners.end());
    try {
      return {std::move(tiles), std::move(gluing)};
    } catch (const SurfaceError& error) {
      fail(std::string("not a closed hyperbolic surface: ") + error.what() +
           " (tile t is triangle t of the text, vertex i of it the start of the triangle's dart i counterclockwise)");
    }
  }

 private:
  void place_anchors() {
    is_placed_.assign(tiles_.size(), false);
    if (anchors_.empty()) anchors_.push_back(find_anchor(stream_, name_));
    for (const TriangulationStream::Anchor& anchor : anchors_) place_anchor(anchor);
  }

  void place_anchor(const TriangulationStream::Anchor& anchor) {
    const auto& [dart, points] = anchor;
    const auto [tile, side] = place_[dart];
    const std::string name = anchors_.size() == 1 ? "the anchor" : "the anchor of triangle " + std::to_string(tile);
    for (std::size_t i = 0; i < 3; ++i) {
      room_ += kMaxGrowth * bits(points[i]);
      if (disk_gap(scaled(points[i])) <= 0) {
        fail("point " + std::to_string(i) + " of " + name + ", " + decimal(points[i]) +
             ", lies outside of the open unit disk");
      }
    }
    if (!counterclockwise(scaled(points[0]), scaled(points[1]), scaled(points[2]))) {
      fail("the points of " + name + " are not counterclockwise, expected the start of dart " + std::to_string(dart) +
           ", its end, and a third point on the left");
    }
    for (std::uint32_t i = 0; i < 3; ++i) tiles_[tile][(side + i) % 3] = points[i];
    limit_[tile] = comfortable(tiles_[tile]);
    is_placed_[tile] = true;
  }

  /// Places all other triangles, breadth first from all anchors.
  void place_others() {
    std::queue<std::uint32_t> pending;
    for (const TriangulationStream::Anchor& anchor : anchors_) pending.push(place_[anchor.dart].tile);
    std::size_t placed = pending.size();
    for (; !pending.empty(); pending.pop()) {
      for (const std::uint32_t d : stream_.triangles[pending.front()]) {
        const std::uint32_t neighbour = place_[opposite(d)].tile;
        if (is_placed_[neighbour]) continue;
        place_across(d);
        is_placed_[neighbour] = true;
        is_used_[edge_[d]] = true;
        pending.push(neighbour);
        ++placed;
      }
    }
    if (placed == tiles_.size()) return;
    const auto t = std::find(is_placed_.begin(), is_placed_.end(), false) - is_placed_.begin();
    fail("the surface is not connected: no path of edges leads from the anchor to triangle " + std::to_string(t));
  }

  /// Places the triangle on the other side of a dart from a to b.
  void place_across(std::uint32_t dart) {
    const auto [tile, side] = place_[dart];
    const Corners& own = tiles_[tile];
    const ScaledPoint a = scaled(own[side]);
    const ScaledPoint b = scaled(own[(side + 1) % 3]);
    const GaussianFraction fourth =
        fourth_point(a, b, scaled(own[(side + 2) % 3]), scaled(stream_.edges[edge_[dart]].cross_ratio));
    const auto [other_tile, other_side] = place_[opposite(dart)];
    const std::string third = "the third vertex of triangle " + std::to_string(other_tile) + ", beyond " +
                              edge_name(stream_.edges[edge_[dart]]);
    if (fourth.d == Complex<Integer>{0, 0}) fail(third + ", is the point at infinity" + kExpected);
    const Point d = value(fourth);
    const ScaledPoint scaled_d = scaled(d);
    if (disk_gap(scaled_d) <= 0) {
      fail(third + ", lies outside of the open unit disk, at " + decimal(d) + " as seen from triangle " +
           std::to_string(tile) + kExpected);
    }
    if (!counterclockwise(b, a, scaled_d)) {
      fail("triangle " + std::to_string(other_tile) + " is not counterclockwise: " + third +
           ", is not on the other side of that edge; expected a geometric triangulation");
    }
    Corners corners{own[(side + 1) % 3], own[side], d};
    // The triangle keeps the coordinates of its neighbour as long as its numbers are short there.
    limit_[other_tile] = limit_[tile];
    if (bits(corners) > limit_[tile]) {
      const Corners simple = simplified(corners);
      if (bits(simple) < bits(corners)) corners = simple;
      limit_[other_tile] = comfortable(corners);
    }
    take_room(other_tile, corners);
    for (std::uint32_t i = 0; i < 3; ++i) tiles_[other_tile][(other_side + i) % 3] = std::move(corners[i]);
  }

  /// Returns how many bits the corners of a triangle may have in the coordinates of this one.
  [[nodiscard]] static std::size_t comfortable(const Corners& corners) { return 2 * bits(corners) + 256; }

  void take_room(std::uint32_t tile, const Corners& corners) {
    const std::size_t size = bits(corners);
    for (const Point& z : corners) {
      for (const Rational& q : {z.x, z.y}) {
        if (bits(q) > kMaxBits) {
          fail("a coordinate of triangle " + std::to_string(tile) +
               " has more than 10^6 digits, which no surface file can hold");
        }
      }
    }
    if (size > room_) {
      fail("the coordinates of the triangles as far as triangle " + std::to_string(tile) +
           " have a thousand times as many digits as the cross-ratios, which is the limit");
    }
    room_ -= size;
  }

  /// Checks that the two triangles beside an edge fit together: they give the edge the same length, and the cross-ratio
  /// in the text. Requires: both are placed.
  void check_edge(const TriangulationStream::Edge& edge) const {
    const auto [tile, side] = place_[edge.dart];
    const auto [other_tile, other_side] = place_[edge.opposite];
    const Corners& own = tiles_[tile];
    const Corners& other = tiles_[other_tile];
    const ScaledPoint a = scaled(own[side]);
    const ScaledPoint b = scaled(own[(side + 1) % 3]);
    const ScaledPoint other_b = scaled(other[other_side]);
    const ScaledPoint other_a = scaled(other[(other_side + 1) % 3]);
    if (!equally_long(a, b, other_a, other_b)) {
      fail(edge_name(edge) + " has length " + length_text(own[side], own[(side + 1) % 3]) + " in triangle " +
           std::to_string(tile) + " and " + length_text(other[other_side], other[(other_side + 1) % 3]) +
           " in triangle " + std::to_string(other_tile) + kExpected);
    }
    const GaussianFraction sigma = corner_ratio(a, b, scaled(own[(side + 2) % 3]));
    const GaussianFraction tau = corner_ratio(other_a, other_b, scaled(other[(other_side + 2) % 3]));
    const GaussianFraction ratio = cross_ratio_of_corners(sigma, tau);
    const ScaledPoint expected = scaled(edge.cross_ratio);
    if (expected.m * ratio.n != expected.n * ratio.d) {
      fail(edge_name(edge) + " has the cross-ratio " + decimal(edge.cross_ratio) + " by the text, and by the " +
           (anchors_.size() > 1 ? "anchors " : "other cross-ratios ") + decimal(value(ratio)) + kExpected);
    }
  }

  [[nodiscard]] static std::string length_text(const Point& p, const Point& q) {
    return certify::shortest(static_cast<double>(Mp256(2 * asinh(sqrt(Mp256(sinh2_half_distance(p, q)))))));
  }

  [[nodiscard]] static std::string edge_name(const TriangulationStream::Edge& edge) {
    return "the edge of darts " + std::to_string(edge.dart) + " and " + std::to_string(edge.opposite);
  }

  [[nodiscard]] std::uint32_t opposite(std::uint32_t dart) const {
    const TriangulationStream::Edge& edge = stream_.edges[edge_[dart]];
    return edge.dart == dart ? edge.opposite : edge.dart;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw ExchangeError(certify::ErrorParts{.file = std::string(name_), .problem = message});
  }

  static constexpr const char* kExpected = ": these cross-ratios are not those of a closed hyperbolic surface";

  const TriangulationStream& stream_;
  std::string_view name_;
  std::vector<TriangulationStream::Anchor> anchors_;
  std::vector<Corners> tiles_;
  std::vector<std::size_t> limit_;   ///< How many bits corners may have in the coordinates of a triangle.
  std::vector<Place> place_;         ///< By dart.
  std::vector<std::uint32_t> edge_;  ///< By dart.
  std::vector<bool> is_placed_;
  std::vector<bool> is_used_;  ///< By edge: whether a triangle was placed across it.
  std::size_t room_ = 0;       ///< How many bits all remaining triangles together may have.
};

}  // namespace

Surface develop(const TriangulationStream& stream, std::string_view name) {
  return Development(stream, name).surface();
}

}  // namespace epsnet
