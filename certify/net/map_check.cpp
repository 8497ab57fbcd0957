#include "certify/net/map_check.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "certify/base/counted.h"
#include "certify/base/text.h"
#include "certify/net/connection.h"
#include "certify/net/darts.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

std::string dart_name(std::size_t dart) {
  return "dart " + std::to_string(dart) + " (triangle " + std::to_string(dart / 3) + ", edge " +
         std::to_string(dart % 3) + ")";
}

/// Whether the opposite of dart 3t + i is another dart, with the opposite 3t + i, which ends where that one begins.
bool has_opposite(const NetDocument& document, std::uint32_t t, std::uint32_t i) {
  const NetDocument::Triangle& triangle = document.triangles[t];
  const std::uint32_t other = triangle.opposite[i];
  const NetDocument::Triangle& neighbour = triangle_at(document, other / 3);
  return other != 3 * t + i && neighbour.opposite[other % 3] == 3 * t + i &&
         neighbour.vertex[next_dart(other) % 3] == triangle.vertex[i];
}

/// Of a dart that has no such opposite.
std::string wrong_opposite(const NetDocument& document, std::uint32_t dart) {
  const std::uint32_t other = opposite(document, dart);
  if (other == dart) return dart_name(dart) + " is its own opposite";
  if (opposite(document, other) != dart) {
    return dart_name(dart) + " has the opposite dart " + std::to_string(other) + ", whose opposite is dart " +
           std::to_string(opposite(document, other));
  }
  return dart_name(dart) + " starts at vertex " + std::to_string(start(document, dart)) + ", but its opposite dart " +
         std::to_string(other) + " ends at vertex " + std::to_string(start(document, next_dart(other)));
}

Problem opposite_problem(const NetDocument& document, unsigned threads) {
  const auto problems =
      results_of_blocks(document.triangles.size(), threads, [&](std::size_t first, std::size_t last) -> Problem {
        for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
          for (std::uint32_t i = 0; i < 3; ++i) {
            if (!has_opposite(document, t, i)) return wrong_opposite(document, 3 * t + i);
          }
        }
        return std::nullopt;
      });
  const auto found = std::find_if(problems.begin(), problems.end(), [](const Problem& x) { return x.has_value(); });
  return found == problems.end() ? std::nullopt : *found;
}

using AtomicNumbers = std::vector<std::atomic<std::uint32_t>>;

/// Whether the darts that leave a vertex form exactly one cycle, for all vertices: whether every vertex has a dart, and
/// the cycles of one dart of each, which have no dart in common, have all darts. Opposite darts have their ends
/// exchanged.
bool has_no_vertex_problem(const NetDocument& document, unsigned threads) {
  const std::size_t triangles = document.triangles.size();
  AtomicNumbers after_dart(document.vertices.size());  // Of each vertex some dart that leaves it, plus 1.
  for_each_block(triangles, threads, [&](std::size_t, std::size_t first, std::size_t last) {
    for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        after_dart[document.triangles[t].vertex[i]].store(3 * t + i + 1, std::memory_order_relaxed);
      }
    }
  });
  std::atomic<std::size_t> visited = 0;
  std::atomic<bool> all_met = true;
  for_each_block(after_dart.size(), threads, [&](std::size_t, std::size_t first, std::size_t last) {
    std::size_t here = 0;
    for (std::size_t v = first; v < last; ++v) {
      const std::uint32_t after = after_dart[v].load(std::memory_order_relaxed);
      if (after == 0) {
        all_met = false;
        return;
      }
      std::uint32_t dart = after - 1;
      do {
        dart = opposite(document, previous_dart(dart));
        ++here;
      } while (dart != after - 1);
    }
    visited += here;
  });
  return all_met && visited == 3 * triangles;
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

/// Disjoint sets of numbers, united by several threads (R. J. Anderson and H. Woll, Wait-free parallel algorithms for
/// the union-find problem, STOC 1991). Parents are less than their children, so there are no cycles.
class Sets {
 public:
  /// parent(i) ≤ i is in the same set as i.
  template <class Parent>
  Sets(std::size_t count, unsigned threads, const Parent& parent) : parents_(count), threads_(threads) {
    for_each_block(count, threads_, [&](std::size_t, std::size_t first, std::size_t last) {
      for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
        parents_[i].store(parent(i), std::memory_order_relaxed);
      }
    });
  }

  void unite(std::uint32_t x, std::uint32_t y) {
    // Nearly always, as parents are nearly always roots.
    if (parents_[x].load(std::memory_order_relaxed) == parents_[y].load(std::memory_order_relaxed)) return;
    for (;;) {
      x = root(x);
      y = root(y);
      if (x == y) return;
      if (x < y) std::swap(x, y);
      if (std::uint32_t expected = x; parents_[x].compare_exchange_weak(expected, y, std::memory_order_relaxed)) return;
    }
  }

  /// When all are united.
  [[nodiscard]] bool is_one() const {
    std::atomic<std::size_t> roots = 0;
    for_each_block(parents_.size(), threads_, [&](std::size_t, std::size_t first, std::size_t last) {
      std::size_t here = 0;
      for (std::size_t i = first; i < last; ++i) here += parents_[i].load(std::memory_order_relaxed) == i ? 1 : 0;
      roots += here;
    });
    return roots == 1;
  }

 private:
  /// Halves the way for the next one.
  [[nodiscard]] std::uint32_t root(std::uint32_t x) {
    for (;;) {
      const std::uint32_t parent = parents_[x].load(std::memory_order_relaxed);
      const std::uint32_t above = parents_[parent].load(std::memory_order_relaxed);
      if (parent == above) return parent;
      // Whatever other threads do, x is no root any more, and `above` is one of those that it leads to.
      parents_[x].store(above, std::memory_order_relaxed);
      x = above;
    }
  }

  AtomicNumbers parents_;
  unsigned threads_;
};

bool is_connected(const NetDocument& document, unsigned threads) {
  Sets sets(document.triangles.size(), threads, [&](std::uint32_t t) {
    std::uint32_t least = t;
    for (const std::uint32_t dart : document.triangles[t].opposite) least = std::min(least, dart / 3);
    return least;
  });
  for_each_block(document.triangles.size(), threads, [&](std::size_t, std::size_t first, std::size_t last) {
    for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
      for (const std::uint32_t dart : document.triangles[t].opposite) {
        if (dart / 3 < t) sets.unite(t, dart / 3);
      }
    }
  });
  return sets.is_one();
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

RuleReport check_map(const NetDocument& document, std::uint64_t genus, unsigned threads) {
  Problem problem;
  if (document.vertices.empty()) problem = "there is no vertex";
  if (!problem && document.triangles.empty()) problem = "there is no triangle";
  if (!problem) problem = opposite_problem(document, threads);
  // What is wrong is looked for by one thread, in the order of the file.
  if (!problem && !has_no_vertex_problem(document, threads)) problem = vertex_problem(document);
  if (!problem && !is_connected(document, threads)) problem = connection_problem(document);
  if (!problem) problem = euler_problem(document, genus);
  if (problem) return {"map", Verdict::refuted, *problem};
  const std::size_t triangles = document.triangles.size();
  return {"map", Verdict::verified,
          "a connected closed oriented surface of genus " + std::to_string(genus) + " made of " +
              counted(document.vertices.size(), "vertex", "vertices") + ", " + std::to_string(3 * triangles / 2) +
              " edges, " + std::to_string(triangles) + " triangles"};
}

}  // namespace epsnet::certify
