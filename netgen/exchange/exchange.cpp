#include "netgen/exchange/exchange.h"

#include <array>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/lifts/lifts.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {

Surface import_surface(std::string_view text, std::string_view name, ExchangeFormat format) {
  if (text.size() > kMaxTextBytes)
    throw ExchangeError(certify::ErrorParts{.file = std::string(name), .problem = "is larger than 256 MiB"});
  const bool guess = format == ExchangeFormat::automatic;
  if (format == ExchangeFormat::triangulation || (guess && is_triangulation_stream(text))) {
    return develop(read_triangulation_stream(text, name), name);
  }
  try {
    return read_domain(text, name);
  } catch (const ExchangeError& error) {
    if (!guess) throw;
    const std::string reading =
        " (read as the domain format: the second token is neither \"yes\" nor \"no\", nor do points of a first "
        "triangle follow, as in the triangulation formats)";
    certify::ErrorParts parts = error.parts();
    parts.problem += reading;
    throw ExchangeError(error.what() + reading, parts);
  }
}

namespace {

constexpr std::size_t kMostLetters = 10'000'000;  // Of all words of a net file (docs/format.md).

// The tiles are triangles, so sides and darts have the same numbers, 3t + i.

/// The direction of a label along a side: from the chart of its end to that of its start, or the reverse.
enum class Way { to_start, to_end };

constexpr Way reverse(Way way) { return way == Way::to_start ? Way::to_end : Way::to_start; }

class Builder {
 public:
  Builder(const Surface& surface, const Length& epsilon) : surface_(surface), path_(surface.side_count()) {
    net_.surface = to_document(surface);
    net_.epsilon = epsilon.text();
  }

  certify::NetDocument net() {
    for (const SideId corner : surface_.side_ids()) {
      if (surface_.vertex_class(corner) == net_.vertices.size()) add_vertex(corner);
    }
    for (const TileId t : surface_.tile_ids()) add_triangle(t);
    return std::move(net_);
  }

 private:
  /// Adds the vertex of a corner, the first one of its class, and finds the words from the corner's tile to the other
  /// tiles around the vertex.
  void add_vertex(SideId corner) {
    const std::uint32_t tile = surface_.tile_of_side(corner).number();
    net_.charts.push_back({tile, net_.surface.tiles[tile][surface_.place_in_tile(corner)]});
    net_.vertices.push_back({0, 0, static_cast<std::uint32_t>(net_.vertices.size())});
    for (SideId c = corner;;) {
      // Moves counterclockwise across the side that ends at the vertex; its partner starts there.
      const SideId side = surface_.previous_side(c);
      const SideId next = surface_.partner(side);
      if (next == corner) return;
      path_[next] = concatenated(surface_, path_[c], {side});
      count_letters(path_[next], path_letters_);
      c = next;
    }
  }

  void add_triangle(TileId t) {
    certify::NetDocument::Triangle& triangle = net_.triangles.emplace_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const SideId side = surface_.side_number(t, i);
      triangle.vertex[i] = surface_.vertex_class(side);
      triangle.opposite[i] = surface_.partner(side).number();
    }
    triangle.label = {label(surface_.side_number(t, 0), Way::to_start), label(surface_.side_number(t, 2), Way::to_end)};
  }

  /// Returns the label along a side. Its word is that of the triangle with the smaller number on either side of it, so
  /// both triangles use the same label.
  std::uint32_t label(SideId side, Way way) {
    const SideId partner = surface_.partner(side);
    if (partner < side) return label(partner, reverse(way));
    // The label leads from `start` to `end`.
    const SideId next = surface_.next_side(side);
    const SideId start = way == Way::to_end ? side : next;
    const SideId end = way == Way::to_end ? next : side;
    const std::uint32_t from = surface_.vertex_class(start);
    const std::uint32_t to = surface_.vertex_class(end);
    const Word word = concatenated(surface_, path_[start], reversed(surface_, path_[end]));
    if (from == to && word.empty()) return 0;
    const auto [known, is_new] =
        labels_.try_emplace({from, to, word}, static_cast<std::uint32_t>(net_.labels.size() + 1));
    if (is_new) {
      count_letters(word, label_letters_);
      net_.labels.push_back({from, to, letters_of(word)});
    }
    return known->second;
  }

  static void count_letters(const Word& word, std::size_t& letters) {
    letters += word.size();
    if (letters > kMostLetters) {
      throw ExchangeError(
          "the triangulation has vertices of so many triangles that its words have more than 10^7 letters, the limit "
          "of a net file");
    }
  }

  const Surface& surface_;
  certify::NetDocument net_;
  /// By corner: the word from the tile of the chart of its vertex to its own tile.
  ById<SideId, Word> path_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, Word>, std::uint32_t> labels_;
  std::size_t path_letters_ = 0;
  std::size_t label_letters_ = 0;
};

}  // namespace

certify::NetDocument net_of_tiles(const Surface& surface, const Length& epsilon) {
  for (const TileId t : surface.tile_ids()) {
    if (!surface.is_rational() || surface.tile(t).size() != 3) {
      throw ExchangeError("tile " + to_string(t) + " has " + std::to_string(surface.tile(t).size()) +
                          " sides, expected triangles: the triangulation is to be that of the tiles");
    }
  }
  return Builder(surface, epsilon).net();
}

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
