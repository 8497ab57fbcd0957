#include "certify/claims/bound/base.h"

#include <array>

#include "certify/net/darts.h"

namespace epsnet::certify {

Product flip(Map& map, std::uint32_t d, std::uint32_t diagonal) {
  const std::uint32_t e = map.opposite[d];
  const std::array<std::uint32_t, 4> from{previous_dart(d), next_dart(e), previous_dart(e), next_dart(d)};
  const std::array<std::uint32_t, 4> to{next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)};
  const Map old = {{map.opposite[from[0]], map.opposite[from[1]], map.opposite[from[2]], map.opposite[from[3]]},
                   {map.element[from[0]], map.element[from[1]], map.element[from[2]], map.element[from[3]]}};
  for (std::size_t i = 0; i < 4; ++i) {
    std::uint32_t across = old.opposite[i];
    for (std::size_t k = 0; k < 4; ++k) {
      if (old.opposite[i] == from[k]) across = to[k];
    }
    map.opposite[to[i]] = across;
    map.opposite[across] = to[i];
    map.element[to[i]] = old.element[i];
  }
  map.element[e] = 2 * diagonal;
  map.element[d] = 2 * diagonal + 1;
  // From c to a, and on to x.
  return {old.element[0], old.element[1]};
}

Product flip(Base& base, std::uint32_t d, std::uint32_t diagonal) {
  const std::uint32_t e = base.map.opposite[d];
  const std::uint32_t a = base.start[d];
  const std::uint32_t b = base.start[e];
  const std::uint32_t c = base.start[previous_dart(d)];
  const std::uint32_t x = base.start[previous_dart(e)];
  base.start[d] = base.start[next_dart(e)] = x;
  base.start[e] = base.start[next_dart(d)] = c;
  base.start[previous_dart(d)] = a;
  base.start[previous_dart(e)] = b;
  return flip(base.map, d, diagonal);
}

void split(Base& base, std::uint32_t d, std::uint32_t one) {
  std::vector<std::uint32_t>& opposite = base.map.opposite;
  std::vector<std::uint32_t>& element = base.map.element;
  const std::uint32_t e = opposite[d];
  const auto m = static_cast<std::uint32_t>(base.midpoints.size()) + 1;
  base.midpoints.push_back({base.start[d], base.start[e], element[d]});
  // The darts of mbc and max, and those of abc and bax whose edges they take over: bc and ax.
  const auto mbc = static_cast<std::uint32_t>(opposite.size());
  const std::uint32_t max = mbc + 3;
  const std::uint32_t bc = next_dart(d);
  const std::uint32_t ax = next_dart(e);
  opposite.resize(mbc + 6);
  element.resize(mbc + 6);
  base.start.insert(base.start.end(), {m, base.start[e], base.start[previous_dart(d)],  //
                                       m, base.start[d], base.start[previous_dart(e)]});
  base.start[bc] = base.start[ax] = m;
  const auto glue = [&](std::uint32_t dart, std::uint32_t other, std::uint32_t along) {
    opposite[dart] = other;
    opposite[other] = dart;
    element[dart] = along;
    element[other] = along ^ 1U;
  };
  // One of the two edges may be opposite to the other.
  const auto moved = [&](std::uint32_t dart) { return dart == bc ? mbc + 1 : dart == ax ? max + 1 : dart; };
  const std::array<std::uint32_t, 2> across{moved(opposite[bc]), moved(opposite[ax])};
  const std::array<std::uint32_t, 2> along{element[bc], element[ax]};
  const std::uint32_t to_b = element[d];
  glue(mbc + 1, across[0], along[0]);
  glue(max + 1, across[1], along[1]);
  glue(mbc, e, to_b);
  glue(d, max, one);
  // The new vertex is next to a: from it to c as from a, and likewise to x.
  glue(mbc + 2, bc, element[previous_dart(d)]);
  glue(ax, max + 2, along[1]);
}

}  // namespace epsnet::certify
