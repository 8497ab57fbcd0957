#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "triangulation/surface/error.h"

namespace epsnet {

/// The edges are not those of a pants graph: not trivalent, not connected, or too many. what() names the node.
class PantsGraphError : public Error {
 public:
  using Error::Error;
};

/// A connected trivalent graph: 2g − 2 nodes, the pairs of pants, and 3g − 3 edges, the cuffs of a pants decomposition
/// of a surface of genus g ≥ 2. Loops (a one-holed torus) and double edges are allowed. Immutable.
class PantsGraph {
 public:
  /// One of the three cuffs, numbered 0, 1, 2, of a pair of pants.
  struct End {
    std::uint32_t pants;
    std::uint32_t cuff;
    bool operator==(const End&) const = default;
  };
  /// The two cuffs that an edge joins.
  using Edge = std::array<End, 2>;

  /// Takes the two end nodes of every edge. The cuffs of a node are numbered in the order in which the edges name it.
  /// Throws PantsGraphError. The genus is at most 100,000.
  explicit PantsGraph(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges);

  /// Returns a path of nodes joined by single and double edges in turn, with a loop at both ends.
  [[nodiscard]] static PantsGraph chain(std::uint32_t genus);
  /// Returns a cycle of nodes joined by single and double edges in turn.
  [[nodiscard]] static PantsGraph ring(std::uint32_t genus);
  /// Returns a balanced tree with a loop at every leaf.
  [[nodiscard]] static PantsGraph tree(std::uint32_t genus);
  /// Returns a random graph: pairs the 3(2g − 2) ends at random until the graph is connected. A seed gives the same
  /// graph on every machine.
  [[nodiscard]] static PantsGraph random(std::uint32_t genus, std::uint64_t seed);
  /// Reads a list of edges such as "0-1 0-1 0-1"; separators are spaces and commas. Throws PantsGraphError, also for
  /// bad syntax.
  [[nodiscard]] static PantsGraph parse(std::string_view text);

  /// Returns the genus of the surfaces with this graph.
  [[nodiscard]] std::uint32_t genus() const { return static_cast<std::uint32_t>(edges_.size() / 3 + 1); }
  /// The number of nodes, 2g − 2.
  [[nodiscard]] std::uint32_t pants_count() const { return 2 * genus() - 2; }
  /// The edges in the order in which they were given.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// The number of the edge at a cuff.
  [[nodiscard]] std::uint32_t edge_at(std::uint32_t pants, std::uint32_t cuff) const {
    assert(pants < pants_count() && cuff < 3);
    return at_[3 * pants + cuff];
  }

 private:
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> at_;
};

}  // namespace epsnet
