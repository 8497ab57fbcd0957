#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <vector>

#include "triangulation/surface/surface.h"
#include "triangulation/surface/turn.h"

namespace epsnet {
namespace {

constexpr std::size_t turn_index(Turn turn) { return turn == Turn::clockwise ? 1 : 0; }

/// The crossings of one full turn that goes on from side s.
std::uint32_t crossings_around(const Surface& surface, SideId s, Turn turn) {
  return surface.corners_around(turn == Turn::counterclockwise ? s : surface.next_side(s));
}

}  // namespace

Word word_of_letters(const std::vector<std::uint32_t>& letters) {
  Word word;
  word.reserve(letters.size());
  for (const std::uint32_t letter : letters) word.emplace_back(letter);
  return word;
}

std::vector<std::uint32_t> letters_of(const Word& word) {
  std::vector<std::uint32_t> letters;
  letters.reserve(word.size());
  for (const SideId s : word) letters.push_back(s.number());
  return letters;
}

Word reversed(const Surface& surface, const Word& word) {
  Word result(word.rbegin(), word.rend());
  for (SideId& s : result) {
    s = surface.partner(s);
  }
  return result;
}

Word concatenated(const Surface& surface, Word first, const Word& then) {
  Word& word = first;
  // For every letter and both turns, how many letters up to this one turn around one vertex.
  std::vector<std::array<std::uint32_t, 2>> runs;
  const auto append_runs = [&] {
    const std::size_t i = runs.size();
    runs.push_back({1, 1});
    for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
      if (i > 0 && next_crossing(surface, word[i - 1], turn) == word[i]) {
        runs[i][turn_index(turn)] = runs[i - 1][turn_index(turn)] + 1;
      }
    }
  };
  while (runs.size() < word.size()) append_runs();
  // Letters still to come, the next one last.
  Word rest(then.rbegin(), then.rend());
  while (!rest.empty()) {
    word.push_back(rest.back());
    append_runs();
    rest.pop_back();
    if (word.size() >= 2 && word[word.size() - 2] == surface.partner(word.back())) {
      word.resize(word.size() - 2);
      runs.resize(word.size());
      continue;
    }
    for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
      // The end of the word that turns around one vertex, and the crossings that complete the turn.
      const std::uint32_t run = runs.back()[turn_index(turn)];
      const std::uint32_t all = crossings_around(surface, word.back(), turn);
      const std::uint32_t completion = (all - run % all) % all;
      if (completion < run) {
        // More than half of the way around: go around the other way.
        SideId s = word.back();
        for (std::uint32_t k = 0; k < completion; ++k) {
          s = next_crossing(surface, s, turn);
          rest.push_back(surface.partner(s));
        }
        word.resize(word.size() - run);
        runs.resize(word.size());
        break;
      }
    }
  }
  return first;
}

Word path_between_tiles(const Surface& surface, TileId from, TileId to) {
  assert(from.number() < surface.tiles().size() && to.number() < surface.tiles().size());
  // The side through which a tile was reached.
  ById<TileId, std::optional<SideId>> entered(surface.tiles().size());
  std::vector<TileId> queue{to};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const TileId tile = queue[i];
    for (const SideId s : surface.sides_of(tile)) {
      const SideId partner = surface.partner(s);
      const TileId next = surface.tile_of_side(partner);
      if (next == to || entered[next]) continue;
      entered[next] = partner;
      queue.push_back(next);
    }
  }
  Word word;
  for (TileId tile = from; tile != to; tile = surface.tile_of_side(surface.partner(word.back()))) {
    word.push_back(*entered[tile]);
  }
  return word;
}

bool is_path(const Surface& surface, TileId from, TileId to, const Word& word) {
  TileId tile = from;
  for (const SideId s : word) {
    if (s.number() >= surface.side_count() || surface.tile_of_side(s) != tile) return false;
    tile = surface.tile_of_side(surface.partner(s));
  }
  return tile == to;
}

}  // namespace epsnet
