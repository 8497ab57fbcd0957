#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/net/document.h"
#include "triangulation/surface/surface.h"

/// Surfaces that have a name or a short description, octagons, regular maps and covers; and surface files.
namespace epsnet {

/// Returns the genus-2 surface of the symmetric octagon z0, z1, z2, z3, −z0, −z1, −z2, −z3 with opposite sides glued
/// (side k to side k + 4).
///
/// Throws SurfaceError unless the octagon is strictly convex, counterclockwise, in the unit disk, and of area 4π, so
/// that its angles add up to 2π. The area is 4π if Im[(1−z0 z̄1)(1−z1 z̄2)(1−z2 z̄3)(1+z3 z̄0)] = 0 (Aigon-Dupuy,
/// Buser, Cibils, Künzle, Steiner, "Hyperbolic octagons and Teichmüller space in genus 2", 2005).
[[nodiscard]] Surface symmetric_octagon(const std::array<Complex<Rational>, 4>& half);

/// Returns the points with z3 moved along the line through z3 and −z0 so that the octagon has the area 4π; nullopt if
/// that is impossible. The new z3 may lie outside the disk, and the octagon may fail to be convex.
[[nodiscard]] std::optional<std::array<Complex<Rational>, 4>> closed_up(const std::array<Complex<Rational>, 4>& half);

/// Returns the random symmetric octagon of the thesis (IV.2.1) for a seed, with rational vertices.
///
/// The surface is exactly the one that `Hyperbolic_fundamental_domain_factory_2` of CGAL 6.1 makes for the same seed
/// when built with GCC for x86-64: the thesis' seeds 123 and 321 are these surfaces. Takes about a
/// millisecond.
[[nodiscard]] Surface random_octagon(std::int32_t seed);

/// Returns the surface as plain data of a surface file or net file (docs/format.md). O(size).
[[nodiscard]] certify::SurfaceDocument to_document(const Surface& surface);

/// Returns the surface that a document describes, checked completely. Throws SurfaceError.
[[nodiscard]] Surface from_document(const certify::SurfaceDocument& surface);

/// Like from_document; messages begin with the name of the file that the document is from.
[[nodiscard]] Surface from_document(const certify::SurfaceDocument& surface, const std::string& name);

/// Reads the surface of a surface file, or of any file that `certify` checks: a net file, compact or not, a file of
/// closed geodesics, of a distance, of a diameter, a radius or an embedded disk. What such a file says of the surface
/// is not checked. Throws certify::FileError, certify::MalformedError, or SurfaceError if the file is well-formed but
/// not a surface; what() is one line that starts with the path.
[[nodiscard]] Surface load_surface(const std::filesystem::path& path);

/// Like load_surface, from memory; `name` stands for the file in messages. Throws certify::MalformedError,
/// SurfaceError.
[[nodiscard]] Surface parse_surface_file(const std::string& text, const std::string& name);

// Surfaces that permutations describe: those of regular maps, among them many with the most symmetries or the longest
// systoles, which have names; and unbranched covers of a surface.

/// A permutation of 0, …, n − 1, which takes i to entry i.
using Permutation = std::vector<std::uint32_t>;

/// First p, then q: two permutations of the same degree.
[[nodiscard]] inline Permutation composed(const Permutation& p, const Permutation& q) {
  Permutation result(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) result[i] = q[p[i]];
  return result;
}

// Maps.

/// Permutations that are no map; what() says which one is wrong, and where.
class MapError : public SurfaceError {
 public:
  using SurfaceError::SurfaceError;
};

/// A map on a surface, by its darts: a dart is a side of a face, as seen from that face.
struct DartMap {
  Permutation rotation;  ///< To the next dart around the face, counterclockwise.
  Permutation edges;     ///< To the dart on the other side of the edge.
  bool operator==(const DartMap&) const = default;
};

/// Returns the surface on which all faces of a map are regular and all angles around vertices equal. Face 0 is that of
/// dart 0, and so on in the order of the first darts; side k is k steps after the first dart. Throws MapError unless
/// these are permutations of the same darts, `edges` is an involution without fixed points, all faces have the same
/// number of sides, all vertices the same number of corners, and 1/p + 1/q < 1/2; SurfaceError if it is not connected,
/// or p or q is more than 10,000.
[[nodiscard]] Surface surface_of_map(const DartMap& map);

/// Reads a map: a JSON object with the members "rotation" and "edges", arrays of dart numbers from 0. Throws MapError.
[[nodiscard]] DartMap parse_map(const std::string& text);

/// A surface that has a name, or a family of them, one for each genus.
struct NamedSurface {
  std::string_view name;         ///< "klein"; of a family "wiman-G", where G stands for a genus.
  std::string_view description;  ///< One sentence.
  std::string_view source;       ///< An article or a book that describes it.
};

/// All surfaces that have names.
[[nodiscard]] std::span<const NamedSurface> named_surfaces();

/// Returns the surface of a name, such as "klein" or "wiman-7", or of the name of a regular map, such as "R2.1"
/// (regular_maps); `about` says which it is. Throws SurfaceError if there is none of that name, or if
/// its genus is out of range: 2 to 1000 in the families. A family's name alone, "wiman", needs the genus; with another
/// name it must be that of the surface.
[[nodiscard]] Surface named_surface(const std::string& name, std::optional<std::uint32_t> genus = {});

/// Returns the names of surfaces of a genus, in the order of named_surfaces, of families with the genus: "klein",
/// "fermat-quartic", "wiman-3" and others for genus 3.
[[nodiscard]] std::vector<std::string> names_of_genus(std::uint32_t genus);

/// Returns the map of which the rotation group is generated by x and y, permutations of the same numbers: the darts are
/// the elements of the group, x turns a face by one side, y turns an edge by half a turn. So the faces have as many
/// sides as x has the order. Requires: y has the order 2. O(elements × numbers).
[[nodiscard]] DartMap map_of_group(const Permutation& x, const Permutation& y);

// Covers, given by how the group of the surface permutes the sheets. docs/covers.md has the conventions.

/// Permutations that do not describe a connected cover; what() names the generator or relation, and the sheets.
class CoverError : public SurfaceError {
 public:
  using SurfaceError::SurfaceError;
};

/// The largest degree of random_sheets.
inline constexpr std::uint32_t kMostRandomSheets = 50;

/// Returns the permutations of an array of arrays of integers, a JSON text. Throws CoverError.
[[nodiscard]] std::vector<Permutation> parse_permutations(const std::string& text);

/// Returns the cover of a surface that the permutations describe, one for each pair of sides of its fundamental polygon
/// (polygon_sides), in the order of their first sides: from sheet i across the first side of pair k one gets to sheet
/// permutations[k][i]. Copy i of tile t is tile iT + t, for T tiles: a copy has the coordinates of its tile, so that
/// the surface is exact, and a closed geodesic of the cover goes to one of the base.
///
/// Throws CoverError if there are not as many permutations as pairs, if they are no permutations of the same numbers,
/// if their product around a vertex of the polygon is not the identity, if the cover is not connected, or if it would
/// have more than 2^20 sides. The time is that of the constructor of Surface. The cover of a map is a map.
[[nodiscard]] Surface cover(const Surface& base, const std::vector<Permutation>& permutations);

/// Returns permutations for `cover`, drawn uniformly from all those that describe a connected cover of this degree with
/// numbered sheets; the same ones for a seed on every machine. Draws about p(degree)/2 times, where p counts
/// partitions: tenths of a second for 50 sheets of genus 2. Throws CoverError unless 1 ≤ degree ≤ kMostRandomSheets.
[[nodiscard]] std::vector<Permutation> random_sheets(const Surface& base, std::uint32_t degree, std::uint64_t seed);

// The regular maps of genus 2 to 10: maps with a rotation that takes any dart to any other one. docs/isometries.md says
// how they are found and what their names are.

/// A regular map. Its dual and its mirror image have the same name: they are maps of the same surface.
struct RegularMap {
  std::string_view name;  ///< "R3.1"; with a C if no reflection is an automorphism.
  std::uint32_t genus;
  RegularTile type;           ///< Faces and vertices, p <= q.
  std::string_view relators;  ///< Of its group of rotations, besides xᵖ, y², (xy)^q: words in x, y, and X for x⁻¹.
  std::string_view surface;   ///< The name of the map with the most rotations of the same surface.
};

/// Returns all of them up to duality and mirror images: by genus, those with reflections first, then by type.
[[nodiscard]] std::span<const RegularMap> regular_maps();

/// Returns the number of rotations, which is that of darts.
[[nodiscard]] std::uint32_t rotations(const RegularMap& map);
/// Whether reflections are automorphisms.
[[nodiscard]] bool is_reflexible(const RegularMap& map);
/// Returns one sentence.
[[nodiscard]] std::string description(const RegularMap& map);
/// Returns the map by its darts, the elements of the group of rotations: a coset enumeration.
[[nodiscard]] DartMap darts(const RegularMap& map);

/// Returns a map with its darts numbered by a breadth-first search from dart 0, around faces and across edges. Two
/// regular maps have the same standard form if and only if an isomorphism that preserves the orientation takes one to
/// the other. Requires: the map is connected. O(darts).
[[nodiscard]] DartMap standard_form(const DartMap& map);
/// Returns the map with the other orientation.
[[nodiscard]] DartMap mirror_image(const DartMap& map);
/// Returns the map with the roles of faces and vertices exchanged.
[[nodiscard]] DartMap dual(const DartMap& map);

/// Returns the map of a surface: its tiles are the faces. Dart s is side s. Requires: regular tiles.
[[nodiscard]] DartMap map_of_surface(const Surface& surface);

}  // namespace epsnet
