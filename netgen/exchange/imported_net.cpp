#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "netgen/exchange/exchange.h"
#include "netgen/surfaces/surface_file.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {
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

}  // namespace epsnet
