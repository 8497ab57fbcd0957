#pragma once

#include <cassert>
#include <cstdint>

namespace epsnet {

/// A dart: the edge of triangle t from corner i to corner i + 1, directed.
///
/// It is a distinct type because files number darts differently (docs/format.md). `document_dart` and
/// `triangulation_dart` (netgen/nets/net_document.h) convert between the two.
enum class Dart : std::uint32_t {};

/// The largest number of a triangle that a dart has room for.
inline constexpr std::uint32_t kLargestTriangle = (1U << 30) - 1;

/// Dart i of a triangle, i < 3.
[[nodiscard]] constexpr Dart make_dart(std::uint32_t triangle, std::uint32_t corner) {
  assert(triangle <= kLargestTriangle && corner < 3);
  return Dart{4 * triangle + corner};
}
/// The triangle of a dart.
[[nodiscard]] constexpr std::uint32_t triangle_of(Dart d) { return static_cast<std::uint32_t>(d) >> 2; }
/// The corner of its triangle at which it starts.
[[nodiscard]] constexpr std::uint32_t corner_of(Dart d) {
  const std::uint32_t corner = static_cast<std::uint32_t>(d) & 3;
  assert(corner < 3);
  return corner;
}
/// Corner i + 1 modulo 3.
[[nodiscard]] constexpr std::uint32_t next(std::uint32_t i) {
  assert(i < 3);
  return i == 2 ? 0 : i + 1;
}
/// Corner i + 2 modulo 3.
[[nodiscard]] constexpr std::uint32_t previous(std::uint32_t i) {
  assert(i < 3);
  return i == 0 ? 2 : i - 1;
}
/// The next dart of the same triangle.
[[nodiscard]] constexpr Dart next_dart(Dart d) { return make_dart(triangle_of(d), next(corner_of(d))); }
/// The dart before it in the same triangle.
[[nodiscard]] constexpr Dart previous_dart(Dart d) { return make_dart(triangle_of(d), previous(corner_of(d))); }

}  // namespace epsnet
