#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/numbers.h"
#include "triangulation/surface/surface.h"

/// Fenchel–Nielsen coordinates: pants graphs, the surfaces, and requests as text.
namespace epsnet {

// Lengths that are given exactly, as 2*arcosh(3/2).

/// The length times·arcosh(cosh).
struct ExactLength {
  std::string cosh;      ///< At least 1; a text of NumberFieldReader.
  Rational times;        ///< Its denominator is a power of 2.
  Rational approximate;  ///< The length, to about 1,000 bits.

  bool operator==(const ExactLength&) const = default;
};

/// Reads n*arcosh(x), n*arsinh(x) or n*log(x) with n a fraction, also in front of or behind it as in arcosh(x)/2, of
/// which the denominator is a power of 2. Returns nullopt if none of the three functions is in the text. Throws
/// SurfaceError, which says what is wrong.
[[nodiscard]] std::optional<ExactLength> parse_exact_length(std::string_view given);

/// cosh(factor·length) as a text of NumberFieldReader. Requires: a denominator of the factor that is a power of 2.
[[nodiscard]] std::string cosh_text(const ExactLength& length, const Rational& factor);

/// The value of a text of NumberFieldReader, if it is rational.
[[nodiscard]] std::optional<Rational> rational_value(const std::string& text);
/// The value of such a text, to 1,024 bits.
[[nodiscard]] Mp1024 real_value(const std::string& text);

// Coordinates, and surfaces.

/// The edges are not those of a pants graph: not trivalent, not connected, or too many. what() names the node.
class PantsGraphError : public Error {
 public:
  using Error::Error;
};

/// The largest genus of a pants graph.
inline constexpr std::uint32_t kLargestGraphGenus = 100'000;

/// A connected trivalent graph: 2g − 2 nodes, the pairs of pants, and 3g − 3 edges, the cuffs of a pants decomposition
/// of a surface of genus g ≥ 2. Loops (a one-holed torus) and double edges are allowed. Immutable.
class PantsGraph {
 public:
  /// One of the three cuffs, numbered 0, 1, 2, of a pair of pants.
  struct End {
    std::uint32_t pants;
    std::uint32_t cuff;
    bool operator==(const End&) const = default;
  };
  /// The two cuffs that an edge joins.
  using Edge = std::array<End, 2>;

  /// Takes the two end nodes of every edge. The cuffs of a node are numbered in the order in which the edges name it.
  /// Throws PantsGraphError. The genus is at most 100,000.
  explicit PantsGraph(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges);

  /// Returns a path of nodes joined by single and double edges in turn, with a loop at both ends.
  [[nodiscard]] static PantsGraph chain(std::uint32_t genus);
  /// Returns a cycle of nodes joined by single and double edges in turn.
  [[nodiscard]] static PantsGraph ring(std::uint32_t genus);
  /// Returns a balanced tree with a loop at every leaf.
  [[nodiscard]] static PantsGraph tree(std::uint32_t genus);
  /// Returns a random graph: pairs the 3(2g − 2) ends at random until the graph is connected. A seed gives the same
  /// graph on every machine.
  [[nodiscard]] static PantsGraph random(std::uint32_t genus, std::uint64_t seed);
  /// Reads a list of edges such as "0-1 0-1 0-1"; separators are spaces and commas. Throws PantsGraphError, also for
  /// bad syntax.
  [[nodiscard]] static PantsGraph parse(std::string_view text);

  /// Returns the genus of the surfaces with this graph.
  [[nodiscard]] std::uint32_t genus() const { return static_cast<std::uint32_t>(edges_.size() / 3 + 1); }
  /// The number of nodes, 2g − 2.
  [[nodiscard]] std::uint32_t pants_count() const { return 2 * genus() - 2; }
  /// The edges in the order in which they were given.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// The number of the edge at a cuff.
  [[nodiscard]] std::uint32_t edge_at(std::uint32_t pants, std::uint32_t cuff) const {
    assert(pants < pants_count() && cuff < 3);
    return at_[3 * pants + cuff];
  }

 private:
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> at_;
};

/// Fenchel–Nielsen coordinates: for every edge of a pants graph the hyperbolic length of its cuff, and the twist with
/// which the two sides are glued, which is also a hyperbolic length.
///
/// On cuff k of a pair of pants, the foot of its common perpendicular with cuff k + 1 (modulo 3) is a mark. With twist
/// 0 the marks of the two sides meet. A positive twist moves the other side's mark to the left, as seen from either
/// side. A twist by the length of the cuff is a Dehn twist: another marking of the same surface.
struct FenchelNielsen {
  PantsGraph graph;
  std::vector<Rational> lengths;
  std::vector<Rational> twists;
  /// By edge, those that are exact, of which the numbers above are approximations; empty, if none is.
  std::vector<std::optional<ExactLength>> exact_lengths = {};
  std::vector<std::optional<ExactLength>> exact_twists = {};
};

/// A length or a twist is out of range; what() names its edge.
class CoordinateError : public SurfaceError {
 public:
  /// An error in a member, with the problem.
  CoordinateError(std::string member, const std::string& problem) : SurfaceError(problem), member_(std::move(member)) {}
  /// "lengths" or "twists".
  [[nodiscard]] const std::string& member() const { return member_; }

 private:
  std::string member_;
};

/// Returns the exact surface with these coordinates. It has 2g − 2 convex heptagons, each a pair of pants cut open. Its
/// lengths differ from the given ones by a factor within 1 ± 2⁻⁵⁰. Its twists, taken modulo the lengths, differ by at
/// most 2⁻⁵⁰ lengths; equal lengths stay equal, lengths and twists that are given exactly are exact, and so are twists
/// by 0 or half of the length but for those that rounded_symmetric_twists lists.
///
/// Scheme: r = exp(length/2) is rounded to a rational number. Then the axes of the cuffs have rational ends, and every
/// pair of pants and every gluing is a rational matrix. Where twists or exact lengths need it, cosh(length/2) and what
/// exact_pants.h names are numbers of a field instead; the heptagons are over it if they are not rational.
/// docs/fenchel-nielsen.md derives both. Linear in the genus. Throws SurfaceError unless there are as many lengths and
/// twists as edges, and for exact numbers in a field of more than degree 64 or of too many bits. Throws CoordinateError
/// for a length outside [1e-25, 100].
[[nodiscard]] Surface fenchel_nielsen_surface(const FenchelNielsen& coordinates);

/// The edges with a twist of 0 or half of the length, modulo the length, that the surface has only up to rounding:
/// symmetries that it owes to them may be lost. None if exact_pants.h has numbers for them. Throws as
/// fenchel_nielsen_surface does.
[[nodiscard]] std::vector<std::size_t> rounded_symmetric_twists(const FenchelNielsen& coordinates);

/// An automorphism of the graph that keeps lengths and twists, but not everywhere the order of cuffs around pairs of
/// pants, which decides where marks are; by edge, the edge that it takes it to. So the surface need not have this
/// symmetry, though one with another order of edges may. Nothing if there is none, or none is found in 100,000 steps,
/// or for more than 1000 pairs of pants. One with a loop looks the same in both orders. Throws as
/// fenchel_nielsen_surface.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> symmetry_lost_by_order(const FenchelNielsen& coordinates);

/// Says in a line each what both functions above find: symmetries of the coordinates that the surface may not have.
[[nodiscard]] std::vector<std::string> symmetry_remarks(const FenchelNielsen& coordinates);

/// Returns random coordinates on a graph: lengths uniform in [1, 4], twists uniform in [0, length). A seed gives the
/// same coordinates on every machine.
[[nodiscard]] FenchelNielsen random_coordinates(PantsGraph graph, std::uint64_t seed);

/// An invalid request. what() is "MEMBER: PROBLEM" if one member is wrong, else "PROBLEM".
class FenchelNielsenRequestError : public Error {
 public:
  /// An error that belongs to no single member.
  explicit FenchelNielsenRequestError(const std::string& problem) : Error(problem) {}
  /// An error in a member, with the problem.
  FenchelNielsenRequestError(const std::string& member, const std::string& problem)
      : Error(certify::ErrorParts{.place = member, .problem = problem}) {}

  /// "graph", "genus", "seed", "lengths", "twists", or empty.
  [[nodiscard]] const std::string& member() const { return place(); }
};

/// Fenchel–Nielsen coordinates as given on a command line or in a JSON file. Missing values are drawn with the seed.
struct FenchelNielsenRequest {
  /// "chain", "ring", "tree", "theta" (0-1 0-1 0-1, of genus 2), "random", or the edges themselves as in "0-1 0-1 0-1".
  /// Empty: theta for genus 2 if lengths and twists are given without a seed, otherwise random.
  std::string graph;
  /// Not needed with edges, nor with lists of lengths or twists, which have 3g - 3 numbers.
  std::optional<std::uint32_t> genus;
  std::optional<std::uint64_t> seed;
  /// Decimals, rationals, or texts of parse_exact_length, one for each edge, or one for all. Empty: random.
  std::vector<std::string> lengths;
  std::vector<std::string> twists;
};

/// Returns the coordinates of a request. Checks the given values before it requires a seed. Throws
/// FenchelNielsenRequestError.
[[nodiscard]] FenchelNielsen resolve(const FenchelNielsenRequest& given);

/// Reads a request from the text of a JSON object with some of the members "graph", "genus", "seed", "lengths",
/// "twists"; numbers are exact decimals, bare or in strings. Or from a pants file (docs/format.md), of which the
/// middles of the intervals are taken. Throws FenchelNielsenRequestError.
[[nodiscard]] FenchelNielsenRequest parse_fenchel_nielsen(const std::string& text);

}  // namespace epsnet
