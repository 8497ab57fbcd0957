#pragma once

#include <cstdint>

#include "certify/document/document.h"

/// Darts of a document: dart 3t + i is the edge of triangle t from corner i to corner i + 1 (modulo 3).
namespace epsnet::certify {

[[nodiscard]] inline std::uint32_t next_dart(std::uint32_t dart) { return dart % 3 == 2 ? dart - 2 : dart + 1; }
[[nodiscard]] inline std::uint32_t previous_dart(std::uint32_t dart) { return dart % 3 == 0 ? dart + 2 : dart - 1; }

[[nodiscard]] inline std::uint32_t opposite(const NetDocument& document, std::uint32_t dart) {
  return document.triangles[dart / 3].opposite[dart % 3];
}

/// The vertex that the dart leaves.
[[nodiscard]] inline std::uint32_t start(const NetDocument& document, std::uint32_t dart) {
  return document.triangles[dart / 3].vertex[dart % 3];
}

/// The label number at the corner where the dart starts: from its vertex's chart to its triangle's. Corner 0 has 0.
[[nodiscard]] inline std::uint32_t corner_label(const NetDocument& document, std::uint32_t dart) {
  return dart % 3 == 0 ? 0 : document.triangles[dart / 3].label[dart % 3 - 1];
}

/// The chart in which the corners of the triangle are measured.
[[nodiscard]] inline std::uint32_t chart_of_triangle(const NetDocument& document, std::uint32_t triangle) {
  return document.vertices[document.triangles[triangle].vertex[0]].chart;
}

}  // namespace epsnet::certify
