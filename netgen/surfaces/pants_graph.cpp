#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <charconv>
#include <string>

#include "netgen/base/disjoint_sets.h"
#include "netgen/surfaces/fenchel_nielsen.h"

namespace epsnet {
namespace {

using NodePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

constexpr std::uint32_t kLargestGenus = 100'000;

void require_genus(std::uint32_t genus) {
  if (genus < 2 || genus > kLargestGenus) {
    throw PantsGraphError("the genus must be at least 2 and at most " + std::to_string(kLargestGenus) + ", not " +
                          std::to_string(genus));
  }
}

/// Returns the number of nodes reached from node 0.
std::size_t reached(const NodePairs& edges, std::size_t nodes) {
  DisjointSets components(nodes);
  for (const auto& [a, b] : edges) components.join(a, b);
  std::size_t count = 0;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    count += components.find(node) == 0 ? 1 : 0;
  }
  return count;
}

/// Adds a node of `tree` with `leaves` leaves below it; returns its number. The caller adds the edge to its parent.
std::uint32_t grow(std::uint32_t leaves, std::uint32_t& nodes, NodePairs& edges) {
  const std::uint32_t node = nodes++;
  if (leaves == 1) {
    edges.emplace_back(node, node);
    return node;
  }
  for (const std::uint32_t part : {leaves / 2, leaves - leaves / 2}) {
    const std::uint32_t child = grow(part, nodes, edges);
    edges.emplace_back(node, child);
  }
  return node;
}

}  // namespace

PantsGraph::PantsGraph(const NodePairs& edges) {
  if (edges.size() < 3 || edges.size() % 3 != 0) {
    throw PantsGraphError("a trivalent graph of genus g has 3g - 3 edges, g at least 2, not " +
                          std::to_string(edges.size()));
  }
  require_genus(static_cast<std::uint32_t>(std::min<std::size_t>(edges.size() / 3 + 1, kLargestGenus + 1)));
  const std::size_t nodes = edges.size() / 3 * 2;
  std::vector<std::uint32_t> cuffs(nodes, 0);
  at_.resize(3 * nodes);
  for (const auto& [a, b] : edges) {
    Edge edge{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::uint32_t node = i == 0 ? a : b;
      if (node >= nodes) {
        throw PantsGraphError("node " + std::to_string(node) + ": a trivalent graph with " +
                              std::to_string(edges.size()) + " edges has the nodes 0 to " + std::to_string(nodes - 1));
      }
      if (cuffs[node] == 3) {
        throw PantsGraphError("node " + std::to_string(node) + " has more than three edges; a loop counts twice");
      }
      edge[i] = {node, cuffs[node]++};
      at_[3 * std::size_t{node} + edge[i].cuff] = static_cast<std::uint32_t>(edges_.size());
    }
    edges_.push_back(edge);
  }
  if (const std::size_t count = reached(edges, nodes); count != nodes) {
    throw PantsGraphError("the graph is not connected: " + std::to_string(count) + " of " + std::to_string(nodes) +
                          " nodes are reached from node 0");
  }
}

PantsGraph PantsGraph::chain(std::uint32_t genus) {
  require_genus(genus);
  const std::uint32_t last = 2 * genus - 3;
  NodePairs edges{{0, 0}};
  for (std::uint32_t node = 0; node < last; ++node) {
    for (std::uint32_t k = 0; k < 1 + node % 2; ++k) {
      edges.emplace_back(node, node + 1);
    }
  }
  edges.emplace_back(last, last);
  return PantsGraph(edges);
}

PantsGraph PantsGraph::ring(std::uint32_t genus) {
  require_genus(genus);
  const std::uint32_t nodes = 2 * genus - 2;
  NodePairs edges;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    for (std::uint32_t k = 0; k < 2 - node % 2; ++k) {
      edges.emplace_back(node, (node + 1) % nodes);
    }
  }
  return PantsGraph(edges);
}

PantsGraph PantsGraph::tree(std::uint32_t genus) {
  require_genus(genus);
  NodePairs edges;
  std::uint32_t nodes = 0;
  // Two halves, joined by an edge.
  const std::uint32_t left = grow(genus / 2, nodes, edges);
  const std::uint32_t right = grow(genus - genus / 2, nodes, edges);
  edges.emplace_back(left, right);
  return PantsGraph(edges);
}

PantsGraph PantsGraph::random(std::uint32_t genus, std::uint64_t seed) {
  require_genus(genus);
  const std::uint32_t nodes = 2 * genus - 2;
  boost::random::mt19937_64 engine(seed);
  std::vector<std::uint32_t> ends;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    ends.insert(ends.end(), 3, node);
  }
  for (;;) {
    for (std::size_t i = ends.size(); i > 1; --i) {
      std::swap(ends[i - 1], ends[boost::random::uniform_int_distribution<std::size_t>(0, i - 1)(engine)]);
    }
    NodePairs edges;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      edges.emplace_back(ends[i], ends[i + 1]);
    }
    if (reached(edges, nodes) == nodes) {
      return PantsGraph(edges);
    }
  }
}

PantsGraph PantsGraph::parse(std::string_view text) {
  NodePairs edges;
  const auto number = [&](std::string_view digits, std::string_view edge) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) {
      throw PantsGraphError("an edge of a pants graph is two nodes as in \"0-1\", not \"" +
                            std::string(edge.substr(0, 40)) + "\"");
    }
    return value;
  };
  constexpr std::string_view kSeparators = " ,\t\n";
  for (std::size_t start = text.find_first_not_of(kSeparators); start != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, start), text.size());
    const std::string_view edge = text.substr(start, end - start);
    const std::size_t dash = std::min(edge.find('-'), edge.size());
    const std::string_view second = dash < edge.size() ? edge.substr(dash + 1) : std::string_view();
    edges.emplace_back(number(edge.substr(0, dash), edge), number(second, edge));
    start = text.find_first_not_of(kSeparators, end);
  }
  return PantsGraph(edges);
}

}  // namespace epsnet
