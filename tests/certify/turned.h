#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"

namespace epsnet::certify {

/// The same net with the corners of one triangle begun at the next one: dart 3t + i gets the number 3t + i + 2 mod 3,
/// and what was measured in the chart of corner 0 is measured in that of corner 1.
inline NetDocument turned(NetDocument net, std::uint32_t t) {
  const LabelParts parts{check_surface(net.surface).crossings, chart_frames(net.charts, {}), {}};
  const LabelEvaluator evaluator(net, parts);
  const std::uint32_t first = net.triangles[t].label[0];
  const std::uint32_t second = net.triangles[t].label[1];
  const auto add = [&](std::uint32_t from, const std::vector<SignedLabel>& product) {
    const auto chart = [&](std::uint32_t corner) { return net.vertices[net.triangles[t].vertex[corner]].chart; };
    net.labels.push_back({chart(from), chart(1), evaluator.word(product)});
    return static_cast<std::uint32_t>(net.labels.size());
  };
  const std::uint32_t of_second = add(2, {{first, true}, {second, false}});
  const std::uint32_t of_first = add(0, {{first, true}});
  NetDocument::Triangle& triangle = net.triangles[t];
  triangle.label = {of_second, of_first};
  std::rotate(triangle.vertex.begin(), triangle.vertex.begin() + 1, triangle.vertex.end());
  std::rotate(triangle.opposite.begin(), triangle.opposite.begin() + 1, triangle.opposite.end());
  for (NetDocument::Triangle& other : net.triangles) {
    for (std::uint32_t& dart : other.opposite) dart = dart / 3 == t ? previous_dart(dart) : dart;
  }
  return net;
}

}  // namespace epsnet::certify
