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
std::uint32_t crossings_around(const Surface& surface, std::uint32_t s, Turn turn) {
  return surface.corners_around(turn == Turn::counterclockwise ? s : surface.next_side(s));
}

}  // namespace

Word reversed(const Surface& surface, const Word& word) {
  Word result(word.rbegin(), word.rend());
  for (std::uint32_t& s : result) {
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
        std::uint32_t s = word.back();
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

Word path_between_tiles(const Surface& surface, std::uint32_t from, std::uint32_t to) {
  assert(from < surface.tiles().size() && to < surface.tiles().size());
  // By tile: the side through which it was reached.
  std::vector<std::optional<std::uint32_t>> entered(surface.tiles().size());
  std::vector<std::uint32_t> queue{to};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t tile = queue[i];
    for (std::uint32_t k = 0; k < surface.tiles()[tile].size(); ++k) {
      const std::uint32_t partner = surface.partner(surface.side_number(tile, k));
      const std::uint32_t next = surface.tile_of_side(partner);
      if (next == to || entered[next]) continue;
      entered[next] = partner;
      queue.push_back(next);
    }
  }
  Word word;
  for (std::uint32_t tile = from; tile != to; tile = surface.tile_of_side(surface.partner(word.back()))) {
    word.push_back(*entered[tile]);
  }
  return word;
}

bool is_path(const Surface& surface, std::uint32_t from, std::uint32_t to, const Word& word) {
  std::uint32_t tile = from;
  for (const std::uint32_t s : word) {
    if (s >= surface.side_count() || surface.tile_of_side(s) != tile) return false;
    tile = surface.tile_of_side(surface.partner(s));
  }
  return tile == to;
}

}  // namespace epsnet
