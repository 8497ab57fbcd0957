#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/document.h"
#include "kernel/numbers.h"
#include "netgen/base/gmp.h"
#include "netgen/exchange/exchange.h"
#include "triangulation/surface/exact_polygons.h"
#include "triangulation/surface/surface.h"

/// CGAL's text formats for closed hyperbolic surfaces (docs/exchange-formats.md): fundamental polygons, the "domain
/// format", and geometric triangulations.
namespace epsnet {

/// Reads the tokens of a text, separated by white space, one after the other. Throws ExchangeError for anything
/// unexpected.
class TokenReader {
 public:
  /// Keeps a reference to the text, which must outlive the reader. `name` stands for the text in messages.
  TokenReader(std::string_view text, std::string_view name) : rest_(text), name_(name) {}
  template <std::same_as<std::string> Text>
  TokenReader(Text&&, std::string_view) = delete;  // A temporary string would not outlive the reader.

  /// Returns the next token; `expected` completes the message if there is none.
  std::string_view next(const std::string& expected) {
    skip_white_space();
    if (rest_.empty()) fail("the text ends here, expected " + expected);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kWhiteSpace));
    rest_.remove_prefix(word.size());
    return word;
  }

  /// Requires that the text ends here; `last` is the name of what it should have ended with.
  void expect_end(const std::string& last) {
    skip_white_space();
    if (rest_.empty()) return;
    fail(certify::in_quotes(next("")) + " follows " + last + ", expected the end of the text");
  }

  /// Reads an unsigned number of 32 bits.
  std::uint32_t index(const std::string& expected) {
    const std::string_view word = next(expected);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      fail(certify::in_quotes(word) + " found, expected " + expected);
    }
    return value;
  }

  Rational rational(const std::string& expected) {
    const std::string_view word = next(expected);
    const std::optional<mpq_class> value = certify::parse_rational(word);
    if (!value) {
      fail(certify::in_quotes(word) + " found, expected " + expected +
           ": a rational number p/q or p of at most 10^6 digits (decimals are not accepted)");
    }
    return from_gmp(*value);
  }

  /// Returns the line of the last token.
  [[nodiscard]] std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& message) const { fail_at(line_, message); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const {
    const std::string number = std::to_string(line);
    throw ExchangeError(name_ + ":" + number + ": " + message,
                        certify::ErrorParts{.file = name_, .place = number, .problem = message});
  }

 private:
  static constexpr std::string_view kWhiteSpace = " \t\n\v\f\r";

  void skip_white_space() {
    const std::size_t length = std::min(rest_.find_first_not_of(kWhiteSpace), rest_.size());
    line_ +=
        static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
    rest_.remove_prefix(length);
  }

  std::string_view rest_;
  std::string name_;
  std::size_t line_ = 1;
};

// The domain format has the number of sides n; then for every side k the index of the side that it is paired with; then
// the n vertices "x y" counterclockwise, points of the Poincaré disk with rational coordinates `p/q` or `p`. Side k
// goes from vertex k to vertex k + 1. White space separates all of these.

/// The largest number of sides of a polygon that is not convex. Finding out whether it intersects itself takes
/// quadratic time.
inline constexpr std::size_t kMaxNonConvexSides = 4096;

/// Reads a polygon of any genus and with any number of vertex classes, and checks it completely (see `Surface`).
///
/// A strictly convex polygon becomes the one tile of the surface. Any other simple counterclockwise polygon, with
/// reflex or straight angles, is triangulated exactly, by diagonals; the tiles are the triangles, in the coordinates of
/// the polygon. `name` stands for the text in messages. Throws ExchangeError. Whatever numbers the text contains,
/// memory is linear in its length; for convex polygons time is too, up to logarithmic factors: about a second per
/// megabyte in the worst case (coordinates of 10^6 digits).
[[nodiscard]] Surface read_domain(std::string_view text, std::string_view name);

// A triangulation: a combinatorial map, the exact cross-ratio of every edge, and a lift of one triangle, of all, or of
// none.

/// The contents of the text, member by member.
struct TriangulationStream {
  /// A triangle, as its three darts counterclockwise.
  using Triangle = std::array<std::uint32_t, 3>;

  /// Two darts glued to each other, in opposite directions.
  struct Edge {
    std::uint32_t dart;
    std::uint32_t opposite;
    /// [z0, z1, z2, z3] (`cross_ratio` in kernel/plane.h) with z0 and z2 the ends of the edge, z1 the third vertex of
    /// the triangle on its right, z3 that on its left. The same for both directions of the edge.
    Complex<Rational> cross_ratio;
    bool operator==(const Edge&) const = default;
  };

  /// Where a triangle lies in the Poincaré disk: without it a triangulation is known up to Möbius maps of the complex
  /// plane only, and not as points of a disk.
  struct Anchor {
    std::uint32_t dart;
    std::array<Complex<Rational>, 3> points;  ///< The start and the end of the dart, the third vertex.
    bool operator==(const Anchor&) const = default;
  };

  /// None; one; or one for each triangle, in their order, each in a disk of its own.
  std::vector<Anchor> anchors;
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  bool operator==(const TriangulationStream&) const = default;
};

/// Whether the text is a triangulation and not a polygon in the domain format, by its first eleven tokens. No text is
/// both: the second token of a triangulation is `yes` or `no`, or there is a fraction among the six coordinates of the
/// first triangle's anchor (points of the open disk, not all 0), where a polygon with enough sides has indices.
[[nodiscard]] bool is_triangulation_stream(std::string_view text);

/// Reads the text and checks its combinatorics: every dart belongs to one triangle and to one edge. `name` stands for
/// the text in messages. Throws ExchangeError. Memory is linear in the length of the text, whatever numbers it
/// contains.
[[nodiscard]] TriangulationStream read_triangulation_stream(std::string_view text, std::string_view name);

/// Returns the surface of a triangulation: tile t is triangle t in coordinates of its own, and its side i is dart i of
/// the triangle. The tile of an anchor has the coordinates of the anchor; if the stream has no anchor, one is found
/// (anchor_search.h).
///
/// Everything is checked exactly: triangles are counterclockwise and in the disk, cross-ratios are as given, and the
/// angles around every vertex add up to 2π (see `Surface`). Requires: the combinatorics that read_triangulation_stream
/// checks. Throws ExchangeError, also if there is no anchor and none is found, if a coordinate has more than 10^6
/// digits, or if all together have more than a thousand times as many digits as the stream.
[[nodiscard]] Surface develop(const TriangulationStream& stream, std::string_view name);

/// Returns the tiles of a surface as a triangulation; tiles with more than three sides are cut by the diagonals from
/// their vertex 0. Dart 3t + i is side i of triangle t; triangle 0 is the anchor.
[[nodiscard]] TriangulationStream triangulation_stream(const Surface& surface);

/// Returns the exact triangulation of a net: the coordinates of its vertices are dyadic numbers, its charts and labels
/// are rational. Dart 3t + i is dart i of triangle t; triangle 0 is the anchor.
///
/// Nothing is proved (certify does that), but the result is a map of triangles that fit: throws ExchangeError if the
/// document is not well-formed or if two glued sides differ in length.
[[nodiscard]] TriangulationStream triangulation_stream(const certify::NetDocument& net);

/// Writes the text: each number as `p/q` or `p` in lowest terms, each triangle as CGAL writes it: a dart, the previous
/// one, the next one. With an anchor for each triangle it is the format of CGAL's Delaunay class.
void write_triangulation_stream(const TriangulationStream& stream, std::ostream& out);

/// Returns two sides of a hyperbolic polygon that meet, other than consecutive sides in their common vertex; nullopt if
/// the polygon is simple.
///
/// Exact: in the Klein model the sides are straight. O(n²) comparisons of machine integers; exact arithmetic only for
/// sides whose bounding boxes meet.
[[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> crossing_sides(
    std::span<const KleinVector> polygon);

/// A triangulation of a polygon by diagonals: the triangles, counterclockwise and none degenerate, and their gluing.
struct PolygonTriangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Vertices of the polygon.
  std::vector<Gluing> diagonals;                        ///< Triangles glued along the diagonals.
  /// (triangle, side) of every side of the polygon.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> place_of_side;
};

/// Triangulates a simple counterclockwise polygon, straight angles allowed, by ear clipping (Meisters 1975). Exact and
/// deterministic. O(n²).
[[nodiscard]] PolygonTriangulation clip_ears(std::span<const KleinVector> polygon);

}  // namespace epsnet
