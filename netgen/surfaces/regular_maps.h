#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "netgen/surfaces/surfaces.h"

/// The regular maps of genus 2 to 10: maps with a rotation that takes any dart to any other one.
///
/// docs/isometries.md says how they are found and what their names are.
namespace epsnet {

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
[[nodiscard]] DartMap mirror_image(const DartMap& map);
/// Returns the map with the roles of faces and vertices exchanged.
[[nodiscard]] DartMap dual(const DartMap& map);

/// Returns the map of a surface: its tiles are the faces. Dart s is side s. Requires: regular tiles.
[[nodiscard]] DartMap map_of_surface(const Surface& surface);

}  // namespace epsnet
