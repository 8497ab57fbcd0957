#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

/// The group of a surface: words as isometries, exactly and enclosed to any precision; the fundamental polygon, whose
/// side pairings generate it; surfaces from matrices that generate their groups, and the matrices of a surface; its
/// characters.
namespace epsnet {

/// An interval with rational ends that contains a number.
struct EnclosedNumber {
  Rational lower;
  Rational upper;
};

/// Enclosures of the real and imaginary parts of an isometry (a, b) of determinant |a|² − |b|² = 1. Two such pairs
/// exist, (a, b) and (−a, −b); this is one of them.
struct EnclosedIsometry {
  EnclosedNumber a_re;
  EnclosedNumber a_im;
  EnclosedNumber b_re;
  EnclosedNumber b_im;
};

/// The most bits that a caller may request of an enclosure.
inline constexpr unsigned kMostEnclosureBits = 1U << 20;

/// Returns the isometry of a word, from the coordinates of the tile where the path starts to those of the tile where it
/// ends. It is the product of the crossings of its letters, the first one applied first. (a, b) are Gaussian integers
/// without a common integer factor. Throws SurfaceError if the word is not a path, and unless the surface
/// `is_rational`: other crossings are not rational. Quasi-linear in the number of digits of the result.
[[nodiscard]] Isometry<Rational> exact_isometry(const Surface& surface, const Word& word);

/// Returns that isometry scaled to determinant 1, in intervals of width at most 2^−bits·|a|. Ball arithmetic (Arb)
/// proves them, for every surface. The ends are dyadic. Throws SurfaceError if the word is not a path,
/// std::invalid_argument beyond kMostEnclosureBits. Linear in the letters of the word, at fixed precision.
[[nodiscard]] EnclosedIsometry enclosed_isometry(const Surface& surface, const Word& word, unsigned bits);

/// The sides of a fundamental polygon, without coordinates. O(sides) but for the words of paths.
struct PolygonSides {
  std::vector<SideId> side;            ///< By side of the polygon, counterclockwise: its number on the surface.
  std::vector<std::uint32_t> partner;  ///< By side of the polygon: the one that it is glued to.
  std::vector<std::vector<std::uint32_t>> relations;  ///< As in FundamentalPolygon.
};

/// Returns the sides of fundamental_polygon(surface). Every other side of the surface lies inside of the polygon.
[[nodiscard]] PolygonSides polygon_sides(const Surface& surface);

/// Returns by tile the path from tile 0 to it along the tree of fundamental_polygon(surface).
[[nodiscard]] ById<TileId, Word> polygon_paths(const Surface& surface);

/// A fundamental polygon of a surface: its tiles, laid out around tile 0 in the coordinates of tile 0. Each tile is
/// placed next to an earlier one, along a tree of crossed sides. For a surface of one tile it is that tile.
///
/// Let Γ be the group of the surface in these coordinates. The images of the polygon under Γ tile the plane. Its side
/// pairings generate Γ, and the cycles of its vertices are the relations between them (Poincaré's polygon theorem).
struct FundamentalPolygon {
  /// Side k leads from vertex k to vertex k + 1, counterclockwise. Beyond it lies γP for the polygon P; γ is the
  /// isometry of `word` (exact_isometry), from the coordinates of tile 0 to themselves.
  struct Side {
    Word word;
    std::uint32_t partner;  ///< The side to which γ⁻¹ takes this one, end to start.
    SideId side;            ///< The number of this side on the surface.
  };
  std::vector<Side> sides;
  /// vertices[k] is the start of side k. Exact if the surface `is_rational`, else rounded to 256 bits.
  std::vector<Complex<Rational>> vertices;
  /// One relation for each vertex of the surface that is a vertex of the polygon: the sides k₁, k₂, … crossed clockwise
  /// around it, in order. Their isometries have the product γ₁γ₂… = 1.
  std::vector<std::vector<std::uint32_t>> relations;
};

/// Returns the fundamental polygon that a breadth-first search of the tiles gives. Two neighbouring sides that are
/// paired with each other are removed, as the vertex between them is an interior point. Time and size are those of the
/// exact coordinates, whose digits grow with the distance of a tile from tile 0.
[[nodiscard]] FundamentalPolygon fundamental_polygon(const Surface& surface);

// Matrices that generate the group. docs/matrices.md says how and why.

/// Matrices of which no surface is made; what() says why, with the word of the element that shows it.
class MatricesError : public SurfaceError {
 public:
  /// Why.
  enum class Kind {
    text,          ///< The text violates the format, or a matrix has no positive determinant.
    relation,      ///< The relation does not hold.
    torsion,       ///< An element other than 1 has a fixed point in the plane.
    not_compact,   ///< The group is not cocompact: it has a parabolic element, or the domain has infinite area.
    not_discrete,  ///< Arbitrarily small motions.
    undecided      ///< No domain was found within the limits.
  };
  /// An error of a kind, with its text.
  MatricesError(Kind kind, const std::string& message) : SurfaceError(message), kind_(kind) {}
  /// Returns why no surface is made.
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// The groups to which matrices belong.
enum class MatrixModel {
  sl2r,  ///< ((a, b), (c, d)), real, acting on the upper half-plane by z ↦ (az + b)/(cz + d).
  su11   ///< ((a, b), (b̄, ā)), acting on the Poincaré disk in the same way.
};

/// Matrices, up to scale, and perhaps a relation between them.
struct MatrixGenerators {
  MatrixModel model = MatrixModel::sl2r;
  /// As isometries of the disk; w = (z − i)/(z + i) takes the half-plane to it. Not scaled to determinant 1.
  std::vector<Isometry<Rational>> generators;
  /// k + 1 is generator k, −(k + 1) its inverse; their product in this order is 1. Empty, if none was given.
  std::vector<std::int32_t> relation;
  /// The significant digits of the number that has the most of them, if there are decimals: the numbers are rounded.
  std::optional<unsigned> digits;
  /// If it is there, the numbers are exact ones of the ring of these tiles (docs/matrices.md).
  std::optional<RegularTile> tile;
  /// By generator, as texts, if there is a tile or some are in a number field; `generators` is then empty.
  std::vector<std::array<std::string, 4>> numbers;
};

/// Reads matrices: JSON, or plain text with a matrix in each line (docs/exchange-formats.md). Throws MatricesError.
[[nodiscard]] MatrixGenerators parse_matrices(const std::string& text);

/// A surface and how its group is related to some matrices.
struct MatrixSurface {
  Surface surface;
  /// By generator: its word on the surface, from tile 0 to itself (exact_isometry). In the coordinates of tile 0 the
  /// group of the surface is the one that the matrices generate, if `is_exact`.
  std::vector<Word> words;
  /// Whether the group is exactly that of the matrices.
  bool is_exact = true;
  /// The largest difference between an entry of a given matrix, scaled to determinant 1, and of the matrix that the
  /// surface has for it, rounded. 0 if `is_exact`.
  double distance = 0;
};

/// Returns the surface of which the group is generated by matrices. Its tiles are the Delaunay triangles of the orbit
/// of one rational point, dual to the Dirichlet domain; the surface is proved by the constructor of Surface, and that
/// the groups are equal by exact products. If some numbers are decimals and the relations of the domain do not hold
/// exactly, it is a rational surface nearest to the matrices: the sum of the squares of all differences of entries is
/// the least possible one, but for 2⁻⁵⁰. If tiles are given, it is the surface of a map, and the matrices are exact. If
/// some numbers are of a number field, all are exact, and so is the surface, over the least field that has them.
///
/// Throws MatricesError, LimitError for products of too many bits. Elements that prove torsion, parabolic ones and
/// those that violate Jørgensen's inequality are decided exactly, unless numbers are rounded. Cubic in the genus.
[[nodiscard]] MatrixSurface surface_of_matrices(const MatrixGenerators& matrices);

/// Returns 2g matrices that generate the group of a surface in the coordinates of tile 0, those of sides k < partner of
/// fundamental_polygon in their order, and a relation that holds between them and implies all others; as a text that
/// parse_matrices reads, with the words of the generators, and each such side of the polygon as a product of them.
/// Exactly, up to scale, and rounded to determinant 1. Throws SurfaceError if the tiles are regular and lcm(2p, 2q, 4)
/// is more than 100,000.
[[nodiscard]] std::string write_matrices(const Surface& surface, MatrixModel model = MatrixModel::sl2r);

// Characters of a surface: homomorphisms χ of its group to the unit circle, given by phases.
//
// Phases are in turns: θ stands for e^{2πiθ}, and θ + 1 for the same. A function on the plane with f(γz) = χ(γ) f(z)
// is a function f_t in the coordinates of each tile t with f_{t'}(c_s z) = e^{2πiθ_s} f_t(z), where c_s is the
// crossing of side s from tile t to tile t', and θ_s the phase of the side. The sides that are glued to each other
// have opposite phases, and those that are crossed around a vertex of the surface have the sum 0, up to integers.

/// Numbers that are no character of a surface; what() says why.
class CharacterError : public Error {
 public:
  using Error::Error;
};

/// Returns the 2g sides of which the phases determine a character, and may be any numbers: of each pair of sides of
/// fundamental_polygon the first one, in their order, without the pairs of a spanning tree of the graph whose vertices
/// are those of the polygon on the surface and whose edges are the pairs. The tree is that of a breadth-first search.
/// If all corners of the polygon are one vertex, no pair is left out. O(sides).
[[nodiscard]] std::vector<SideId> character_sides(const Surface& surface);

/// Returns the phases of all sides, in (−1/2, 1/2], from those of character_sides, in turns. Sides inside of the
/// fundamental polygon have phase 0. Throws CharacterError if there are not 2g, or if there is no n ≤ 10¹⁸ of which all
/// are multiples of 1/n: files have no such phases. O(sides).
[[nodiscard]] ById<SideId, Rational> phases_of_sides(const Surface& surface, const std::vector<Rational>& turns);

/// Returns the phase of a word, the sum of those of its sides: in (−1/2, 1/2], exact before it is rounded. Requires:
/// the sides are there.
[[nodiscard]] double phase_of_word(const ById<SideId, Rational>& phases, const std::vector<std::uint32_t>& letters);

/// The nodes of a graph on a surface.
enum class GraphNodes {
  vertices,  ///< Joined by edges.
  faces,     ///< Tiles or triangles, joined where they have an edge in common.
};

/// A step along an edge of a graph on a surface: f at its end, in the coordinates of the node `from`, is e^{2πi·turns}
/// times f in those of the node `to`.
struct PhasedStep {
  std::uint32_t from;
  std::uint32_t to;
  Rational turns;  ///< In (−1/2, 1/2].
};

/// Returns the steps along all edges in both directions, by side of a tile: those of tiles across the side; those of
/// vertices along it, from its start to its end. The coordinates of a tile are its own, those of a vertex are those of
/// the first tile that has it. `phases` are those of phases_of_sides. O(sides).
[[nodiscard]] std::vector<PhasedStep> phased_steps(const Surface& surface, GraphNodes nodes,
                                                   const ById<SideId, Rational>& phases);

/// Reads a number of turns, a decimal or a fraction of at most 40 characters: "0.25", "-1/3". Throws CharacterError for
/// any other text.
[[nodiscard]] Rational parse_turns(std::string_view text);

}  // namespace epsnet
