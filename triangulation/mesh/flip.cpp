#include <array>
#include <cassert>
#include <utility>

#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/plausible.h"

namespace epsnet {

Dart flip(Triangulation& triangulation, Dart d, Journal* journal) {
  const Editor editor(triangulation, journal);
  const Dart e = triangulation.opposite(d);
  const TriangleId t = triangle_of(d);
  const TriangleId s = triangle_of(e);
  const LabelId across = triangulation.transition(d);
  const Corner a = triangulation.corner(d);
  const Corner b = triangulation.corner(next_dart(d));
  const Corner c = triangulation.corner(previous_dart(d));
  const Corner f = triangulation.moved(across, triangulation.corner(previous_dart(e)));
  assert(may_be_left(triangulation, c, a, f) && may_be_left(triangulation, f, b, c));
  // The four outer darts move; where the two triangles share more edges, their opposites move along.
  const std::array<std::pair<Dart, Dart>, 4> moves{{{next_dart(d), make_dart(s, 1)},
                                                    {previous_dart(d), make_dart(t, 0)},
                                                    {next_dart(e), make_dart(t, 1)},
                                                    {previous_dart(e), make_dart(s, 0)}}};
  std::array<Dart, 4> outer{};
  for (std::size_t i = 0; i < 4; ++i) {
    outer[i] = triangulation.opposite(moves[i].first);
    for (const auto& [from, to] : moves) {
      if (triangulation.opposite(moves[i].first) == from) {
        outer[i] = to;
      }
    }
  }
  editor.set(t, c, a, f);
  editor.set(s, f, b, c);
  for (std::size_t i = 0; i < 4; ++i) {
    editor.link(moves[i].second, outer[i]);
  }
  editor.link(make_dart(t, 2), make_dart(s, 2));
  return make_dart(t, 2);
}

std::uint64_t restore_delaunay(Triangulation& triangulation, std::vector<Dart>& pending, Journal* journal) {
  std::uint64_t flips = 0;
  while (!pending.empty()) {
    const Dart d = pending.back();
    pending.pop_back();
    if (!triangulation.is_delaunay(d)) {
      const bool untwisted = untwist(triangulation, d, journal);
      const Dart f = untwisted ? d : flip(triangulation, d, journal);
      const Dart g = triangulation.opposite(f);
      ++flips;
      if (untwisted) pending.push_back(d);
      for (const Dart side : {next_dart(f), previous_dart(f), next_dart(g), previous_dart(g)}) {
        pending.push_back(side);
      }
    }
  }
  return flips;
}

std::uint64_t make_delaunay(Triangulation& triangulation) {
  std::vector<Dart> pending;
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (const Dart d = make_dart(t, i); d < triangulation.opposite(d)) {
        pending.push_back(d);
      }
    }
  }
  return restore_delaunay(triangulation, pending);
}

}  // namespace epsnet
