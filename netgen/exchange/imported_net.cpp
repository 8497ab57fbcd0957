#include "netgen/exchange/imported_net.h"

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "netgen/surfaces/surface_file.h"
#include "triangulation/atlas.h"

namespace epsnet {
namespace {

constexpr std::size_t kMostLetters = 10'000'000;  // Of all words of a net file (docs/format.md).

/// The next side of the same triangle, or the next corner: both have the same numbers.
constexpr std::uint32_t next_side(std::uint32_t s) { return s - s % 3 + (s % 3 + 1) % 3; }
constexpr std::uint32_t previous_side(std::uint32_t s) { return next_side(next_side(s)); }

class Builder {
 public:
  Builder(const Surface& surface, const Length& epsilon) : surface_(surface), path_(surface.side_count()) {
    net_.surface = to_document(surface);
    net_.epsilon = epsilon.text();
  }

  certify::NetDocument net() {
    for (std::uint32_t corner = 0; corner < surface_.side_count(); ++corner) {
      if (surface_.vertex_class(corner) == net_.vertices.size()) add_vertex(corner);
    }
    for (std::uint32_t t = 0; t < surface_.tiles().size(); ++t) add_triangle(t);
    return std::move(net_);
  }

 private:
  /// The vertex of a corner, the first one of its class, and the words from the corner's tile to the others around it.
  void add_vertex(std::uint32_t corner) {
    const std::uint32_t tile = surface_.tile_of_side(corner);
    net_.charts.push_back({tile, net_.surface.tiles[tile][corner % 3]});
    net_.vertices.push_back({0, 0, static_cast<std::uint32_t>(net_.vertices.size())});
    for (std::uint32_t c = corner;;) {
      // Counterclockwise, across the side that ends here; its partner starts here.
      const std::uint32_t side = previous_side(c);
      const std::uint32_t next = surface_.partner(side);
      if (next == corner) return;
      path_[next] = concatenated(surface_, path_[c], {side});
      count_letters(path_[next], path_letters_);
      c = next;
    }
  }

  void add_triangle(std::uint32_t t) {
    certify::NetDocument::Triangle& triangle = net_.triangles.emplace_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      triangle.vertex[i] = surface_.vertex_class(3 * t + i);
      triangle.opposite[i] = surface_.partner(3 * t + i);
    }
    triangle.label = {label(3 * t, false), label(3 * t + 2, true)};
  }

  /// The label along a side from the chart of its end to that of its start, or the other way. The word is that of the
  /// side's triangle or of the one beyond, whichever has the smaller number: both then use the same label.
  std::uint32_t label(std::uint32_t side, bool forward) {
    const std::uint32_t partner = surface_.partner(side);
    if (partner < side) return label(partner, !forward);
    const std::uint32_t start = forward ? side : next_side(side);
    const std::uint32_t end = forward ? next_side(side) : side;
    const std::uint32_t from = surface_.vertex_class(start);
    const std::uint32_t to = surface_.vertex_class(end);
    Word word = concatenated(surface_, path_[start], reversed(surface_, path_[end]));
    if (from == to && word.empty()) return 0;
    const auto [known, is_new] =
        labels_.try_emplace({from, to, word}, static_cast<std::uint32_t>(net_.labels.size() + 1));
    if (is_new) {
      count_letters(word, label_letters_);
      net_.labels.push_back({from, to, std::move(word)});
    }
    return known->second;
  }

  static void count_letters(const Word& word, std::size_t& letters) {
    letters += word.size();
    if (letters > kMostLetters) {
      throw ImportedNetError(
          "the triangulation has vertices of so many triangles that its words have more than 10^7 letters, the limit "
          "of a net file");
    }
  }

  const Surface& surface_;
  certify::NetDocument net_;
  /// By corner: from the tile of the chart of its vertex to its own.
  std::vector<Word> path_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, Word>, std::uint32_t> labels_;
  std::size_t path_letters_ = 0;
  std::size_t label_letters_ = 0;
};

}  // namespace

certify::NetDocument net_of_tiles(const Surface& surface, const Length& epsilon) {
  for (std::size_t t = 0; t < surface.tiles().size(); ++t) {
    if (surface.is_regular() || surface.tiles()[t].size() != 3) {
      throw ImportedNetError("tile " + std::to_string(t) + " has " + std::to_string(surface.tiles()[t].size()) +
                             " sides, expected triangles: the triangulation is to be that of the tiles");
    }
  }
  return Builder(surface, epsilon).net();
}

}  // namespace epsnet
