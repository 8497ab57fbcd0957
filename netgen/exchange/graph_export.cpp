#include <array>
#include <cstdint>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"

namespace epsnet {
namespace {

/// A graph with loops and several edges between two nodes.
struct Multigraph {
  std::size_t nodes;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

Multigraph graph_of(const Surface& surface, GraphNodes nodes) {
  const bool of_vertices = nodes == GraphNodes::vertices;
  Multigraph graph{of_vertices ? surface.vertex_class_count() : surface.tiles().size(), {}};
  for (const SideId side : surface.side_ids()) {
    const SideId partner = surface.partner(side);
    if (partner < side) continue;
    if (of_vertices) {
      graph.edges.push_back({surface.vertex_class(side), surface.vertex_class(surface.next_side(side))});
    } else {
      graph.edges.push_back({surface.tile_of_side(side).number(), surface.tile_of_side(partner).number()});
    }
  }
  return graph;
}

Multigraph graph_of(const certify::NetDocument& net, GraphNodes nodes) {
  const bool of_vertices = nodes == GraphNodes::vertices;
  Multigraph graph{of_vertices ? net.vertices.size() : net.triangles.size(), {}};
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t other = certify::opposite(net, dart);
    if (other < dart) continue;
    if (of_vertices) {
      graph.edges.push_back({certify::start(net, dart), certify::start(net, certify::next_dart(dart))});
    } else {
      graph.edges.push_back({dart / 3, other / 3});
    }
  }
  return graph;
}

/// Writes the lower triangle, column by column. A loop counts twice, so that the sums of rows are degrees.
void write_matrix(const Multigraph& graph, std::ostream& out) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> entries;
  for (const auto& [u, v] : graph.edges) entries[std::minmax(u, v)] += u == v ? 2 : 1;
  out << "%%MatrixMarket matrix coordinate integer symmetric\n"
      << graph.nodes << ' ' << graph.nodes << ' ' << entries.size() << '\n';
  for (const auto& [ends, count] : entries) out << ends.second + 1 << ' ' << ends.first + 1 << ' ' << count << '\n';
}

}  // namespace

void write_edges(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  out << "u\tv\tlength\n";
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    if (certify::opposite(net, dart) < dart) continue;
    out << certify::start(net, dart) << '\t' << certify::start(net, certify::next_dart(dart)) << '\t'
        << certify::shortest(geometry.edge_length(dart)) << '\n';
  }
}

void write_edges(const Surface& surface, std::ostream& out) {
  out << "u\tv\tleft\tright\tlength\n";
  for (const SideId side : surface.side_ids()) {
    const SideId partner = surface.partner(side);
    if (partner < side) continue;
    const TileId left = surface.tile_of_side(side);
    const Tile& tile = surface.tile(left);
    const std::size_t k = surface.place_in_tile(side);
    out << surface.vertex_class(side) << '\t' << surface.vertex_class(surface.next_side(side)) << '\t' << left.number()
        << '\t' << surface.tile_of_side(partner).number() << '\t'
        << certify::shortest(distance(convert<double>(tile[k]), convert<double>(tile[(k + 1) % tile.size()]))) << '\n';
  }
}

void write_adjacency(const Surface& surface, GraphNodes nodes, std::ostream& out) {
  write_matrix(graph_of(surface, nodes), out);
}

void write_adjacency(const certify::NetDocument& net, GraphNodes nodes, std::ostream& out) {
  static_cast<void>(NetGeometry(net));  // Throws unless it is a net.
  write_matrix(graph_of(net, nodes), out);
}

}  // namespace epsnet
