#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <utility>
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

/// The sides of a tile between `entry` and `exit` in the direction of a turn, if they are one or two and three tiles
/// meet at each of their ends; none otherwise.
std::vector<SideId> sides_between(const Surface& surface, SideId entry, SideId exit, Turn turn) {
  std::vector<SideId> sides;
  for (SideId s = entry; sides.size() <= 2; sides.push_back(s)) {
    if (crossings_around(surface, surface.partner(s), turn) != 3) return {};
    s = turn == Turn::counterclockwise ? surface.next_side(s) : surface.previous_side(s);
    if (s == exit) return sides;
  }
  return {};
}

/// The word with one letter less, where the path passes a row of tiles that are side by side with the tiles of a
/// shorter one: at the first and the last tile it leaves one side on one hand, at those between two. Nothing if it does
/// not.
///
/// Where three tiles meet at a vertex, a path may go around a tile again and again, and no vertex is on it for long.
std::optional<Word> straightened(const Surface& surface, const Word& word) {
  // Across the vertex at which a path turns with this crossing and the one before: one crossing instead of both.
  const auto shortcut = [&](SideId second, Turn turn) { return surface.partner(next_crossing(surface, second, turn)); };
  for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
    std::optional<std::size_t> start;
    Word row;
    for (std::size_t k = 0; k + 1 < word.size(); ++k) {
      const std::vector<SideId> sides = sides_between(surface, surface.partner(word[k]), word[k + 1], turn);
      if (sides.size() == 1 && start) {
        row.push_back(shortcut(word[k + 1], turn));
        row.insert(row.begin(), word.data(), word.data() + *start);
        row.insert(row.end(), word.data() + k + 2, word.data() + word.size());
        return row;
      }
      if (sides.size() == 1) {
        start = k;
        row = {shortcut(sides[0], turn)};
      } else if (sides.size() == 2 && start) {
        row.push_back(shortcut(sides[1], turn));
      } else {
        start.reset();
      }
    }
  }
  return std::nullopt;
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

namespace {

/// Dehn's algorithm.
Word shortened(const Surface& surface, Word word, const Word& then) {
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
  return word;
}

}  // namespace

Word concatenated(const Surface& surface, Word first, const Word& then) {
  // Short words are left as they are: nothing is gained there.
  constexpr std::size_t kLong = 64;
  Word word = shortened(surface, std::move(first), then);
  while (word.size() > kLong) {
    const std::optional<Word> shorter = straightened(surface, word);
    if (!shorter) break;
    word = shortened(surface, {}, *shorter);
  }
  return word;
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
