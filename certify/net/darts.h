#pragma once

#include <cstdint>

#include "certify/base/lookup.h"
#include "certify/net/document.h"

/// Darts of a document: dart 3t + i is the edge of triangle t from corner i to corner i + 1 (modulo 3). Fault, if what
/// is asked about is not there.
namespace epsnet::certify {

[[nodiscard]] inline std::uint32_t next_dart(std::uint32_t dart) { return dart % 3 == 2 ? dart - 2 : dart + 1; }
[[nodiscard]] inline std::uint32_t previous_dart(std::uint32_t dart) { return dart % 3 == 0 ? dart + 2 : dart - 1; }

[[nodiscard]] inline const NetDocument::Triangle& triangle_at(const NetDocument& document, std::uint32_t triangle) {
  return looked_up(document.triangles, triangle, "there is no triangle");
}

[[nodiscard]] inline std::uint32_t opposite(const NetDocument& document, std::uint32_t dart) {
  return triangle_at(document, dart / 3).opposite[dart % 3];
}

/// The vertex that the dart leaves.
[[nodiscard]] inline std::uint32_t start(const NetDocument& document, std::uint32_t dart) {
  return triangle_at(document, dart / 3).vertex[dart % 3];
}

/// The label number at the corner where the dart starts: from its vertex's chart to its triangle's. Corner 0 has 0.
[[nodiscard]] inline std::uint32_t corner_label(const NetDocument& document, std::uint32_t dart) {
  const NetDocument::Triangle& triangle = triangle_at(document, dart / 3);
  return dart % 3 == 0 ? 0 : triangle.label[dart % 3 - 1];
}

/// The chart in which the corners of the triangle are measured.
[[nodiscard]] inline std::uint32_t chart_of_triangle(const NetDocument& document, std::uint32_t triangle) {
  return looked_up(document.vertices, triangle_at(document, triangle).vertex[0], "there is no vertex").chart;
}

}  // namespace epsnet::certify
