#pragma once

#include <optional>
#include <string>

#include "certify/net/document.h"

/// What a document must satisfy before any rule of check.h makes sense: indices point somewhere, every side is glued
/// once, words compose, labels are used in the charts they belong to, coordinates are finite and inside the disk.
///
/// A document without these is not a wrong net but no net: MALFORMED. O(size of the document), exact.
namespace epsnet::certify {

/// The largest genus of a surface known by name, and the largest length of its free text in bytes.
inline constexpr std::uint32_t kMaxRegularGenus = 1000;
inline constexpr std::size_t kMaxAboutBytes = std::size_t{1} << 20;

/// The place of a row, at the beginning of a problem: "MEMBER[ROW]: ".
[[nodiscard]] std::string at(const char* member, std::size_t row);

/// What is wrong with the genus of a regular 4g-gon; nullopt if it is in range.
[[nodiscard]] std::optional<std::string> regular_genus_problem(std::uint32_t genus);

/// The first problem, "PLACE: what is wrong, what was expected"; nullopt if there is none. Corners of tiles are not
/// examined (that is rule `surface`).
[[nodiscard]] std::optional<std::string> structure_problem(const SurfaceDocument& surface);

/// As above, for the whole document.
[[nodiscard]] std::optional<std::string> structure_problem(const NetDocument& document);

}  // namespace epsnet::certify
