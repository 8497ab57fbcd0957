#include "certify/net/map_check.h"

#include <string>

#include "certify/base/counted.h"
#include "certify/net/connection.h"
#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

using Problem = std::optional<std::string>;

std::string dart_name(std::size_t dart) {
  return "dart " + std::to_string(dart) + " (triangle " + std::to_string(dart / 3) + ", edge " +
         std::to_string(dart % 3) + ")";
}

Problem opposite_problem(const NetDocument& document) {
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    const std::uint32_t other = opposite(document, dart);
    if (other == dart) return dart_name(dart) + " is its own opposite";
    if (opposite(document, other) != dart) {
      return dart_name(dart) + " has the opposite dart " + std::to_string(other) + ", whose opposite is dart " +
             std::to_string(opposite(document, other));
    }
    if (start(document, dart) != start(document, next_dart(other))) {
      return dart_name(dart) + " starts at vertex " + std::to_string(start(document, dart)) +
             ", but its opposite dart " + std::to_string(other) + " ends at vertex " +
             std::to_string(start(document, next_dart(other)));
    }
  }
  return std::nullopt;
}

/// The darts that leave a vertex, each followed by the next one around it, form exactly one cycle.
Problem vertex_problem(const NetDocument& document) {
  std::vector<bool> visited(3 * document.triangles.size());
  std::vector<bool> met(document.vertices.size());
  for (std::uint32_t first = 0; first < visited.size(); ++first) {
    if (visited[first]) continue;
    const std::uint32_t vertex = start(document, first);
    if (met[vertex]) return "the darts leaving vertex " + std::to_string(vertex) + " form more than one cycle";
    met[vertex] = true;
    for (std::uint32_t dart = first; !visited[dart]; dart = opposite(document, previous_dart(dart)))
      visited[dart] = true;
  }
  for (std::size_t v = 0; v < met.size(); ++v) {
    if (!met[v]) return "vertex " + std::to_string(v) + " belongs to no triangle";
  }
  return std::nullopt;
}

Problem connection_problem(const NetDocument& document) {
  const auto missing = first_unreached(document.triangles.size(), [&](std::uint32_t t, const auto& visit) {
    for (const std::uint32_t dart : document.triangles[t].opposite) visit(dart / 3);
  });
  if (!missing) return std::nullopt;
  return "not connected: no path of edges leads from triangle 0 to triangle " + std::to_string(*missing);
}

Problem euler_problem(const NetDocument& document, std::uint64_t genus) {
  const auto vertices = static_cast<std::int64_t>(document.vertices.size());
  const auto triangles = static_cast<std::int64_t>(document.triangles.size());
  const std::int64_t edges = 3 * triangles / 2;
  const std::int64_t expected = 2 - 2 * static_cast<std::int64_t>(genus);
  if (vertices - edges + triangles == expected) return std::nullopt;
  return "V - E + F = " + std::to_string(vertices) + " - " + std::to_string(edges) + " + " + std::to_string(triangles) +
         " = " + std::to_string(vertices - edges + triangles) + ", expected " + std::to_string(expected) +
         " for genus " + std::to_string(genus);
}

}  // namespace

RuleReport check_map(const NetDocument& document, std::uint64_t genus) {
  Problem problem;
  if (document.vertices.empty()) problem = "there is no vertex";
  if (!problem && document.triangles.empty()) problem = "there is no triangle";
  if (!problem) problem = opposite_problem(document);
  if (!problem) problem = vertex_problem(document);
  if (!problem) problem = connection_problem(document);
  if (!problem) problem = euler_problem(document, genus);
  if (problem) return {"map", Verdict::refuted, *problem};
  const std::size_t triangles = document.triangles.size();
  return {"map", Verdict::verified,
          "a connected closed oriented surface of genus " + std::to_string(genus) + " made of " +
              counted(document.vertices.size(), "vertex", "vertices") + ", " + std::to_string(3 * triangles / 2) +
              " edges, " + std::to_string(triangles) + " triangles"};
}

}  // namespace epsnet::certify
