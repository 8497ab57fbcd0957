#include "certify/claims/bound/triangles.h"

#include <array>

#include "certify/net/numbering.h"

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

namespace {

/// π in the arithmetic of the caller.
template <class Number>
Number half_turn() {
  return pi();
}
template <>
Interval half_turn<Interval>() {
  return {0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1};
}

template <class Number>
SidesIn<Number> sides_of(std::span<const Number> h, std::size_t t) {
  return h.subspan(3 * t).template first<3>();
}

/// Whether a triangle's circumradius is at least r: 4abc ≥ K sinh²r.
template <class Number>
Tri is_wide(SidesIn<Number> sides, const Number& k, const Number& least) {
  return !certainly_less(4 * (sides[0] * sides[1] * sides[2]), k * least);
}

/// The sides a, b, c: b + c − a, c + a − b, a + b − c, whose signs are those of the cosines of the opposite angles.
template <class Number>
std::array<Number, 3> excesses(SidesIn<Number> sides) {
  return {sides[1] + sides[2] - sides[0], sides[2] + sides[0] - sides[1], sides[0] + sides[1] - sides[2]};
}

template <class Number>
Tri fits_in(SidesIn<Number> sides, const Number& most) {
  Tri short_enough = Tri::yes;
  for (const Number& side : sides) short_enough = both(short_enough, !certainly_less(most, side));
  if (short_enough == Tri::no) return Tri::no;
  // With sides that fit, a triangle that is not acute does.
  const std::array<Number, 3> excess = excesses(sides);
  Tri acute = Tri::yes;
  for (const Number& x : excess) acute = both(acute, certainly_positive(x));
  if (acute == Tri::no) return short_enough;
  // 4abc ≤ sinh²(r) K with K = 4ab − (a + b − c)²; K > 0 follows, as abc > 0 for an acute triangle.
  const Number four_ab = 4 * (sides[0] * sides[1]);
  const Number k = four_ab - sqr(excess[2]);
  const Tri larger = certainly_less(k * most, four_ab * sides[2]);
  if (certainly_positive(k) == Tri::yes && larger == Tri::no) return Tri::yes;
  return acute == Tri::yes && larger == Tri::yes ? Tri::no : Tri::unknown;
}

template <class Number>
MeasuresIn<Number> measures_in(SidesIn<Number> sides) {
  MeasuresIn<Number> result;
  result.cotangent = excesses(sides);
  const Number four_ab = 4 * (sides[0] * sides[1]);
  result.k = four_ab - sqr(result.cotangent[2]);
  const Number root = sqrt(result.k);
  for (Number& cotangent : result.cotangent) cotangent = cotangent / root;
  // tan(A/2) = √(K + 4abc)/(2 + a + b + c).
  result.area = 2 * atan(sqrt(four_ab * sides[2] + result.k) / (2 + (sides[0] + sides[1] + sides[2])));
  return result;
}

template <class Number>
Tri all_counterclockwise_in(std::span<const Number> areas) {
  // The area of the surface is 2π(2g − 2) = π(F − 2).
  Number excess = -(static_cast<int>(areas.size() - 2) * half_turn<Number>());
  for (const Number& area : areas) excess = excess + area;
  Tri result = Tri::yes;
  for (const Number& area : areas) result = both(result, certainly_less(excess, area));
  return result;
}

template <class Number>
Tri is_delaunay_and_wide_in(std::span<const std::uint32_t> opposite, std::span<const Number> h, const Number& least) {
  std::vector<Number> areas, cotangent;
  Tri result = Tri::yes;
  Tri wide = Tri::no;
  for (std::size_t t = 0; t < h.size() / 3; ++t) {
    MeasuresIn<Number> triangle = measures_in(sides_of(h, t));
    result = both(result, certainly_positive(triangle.k));
    wide = either(wide, is_wide(sides_of(h, t), triangle.k, least));
    areas.push_back(std::move(triangle.area));
    for (Number& side : triangle.cotangent) cotangent.push_back(std::move(side));
  }
  for (std::size_t d = 0; d < h.size(); ++d) {
    result = both(result, certainly_positive(cotangent[d] + cotangent[opposite[d]]));
  }
  return both(both(result, wide), all_counterclockwise_in<Number>(areas));
}

}  // namespace

Tri fits(Sides sides, const Ball& most) { return fits_in(sides, most); }
Tri fits(SidesIn<Interval> sides, const Interval& most) { return fits_in(sides, most); }

TriangleMeasures measures(Sides sides) { return measures_in(sides); }
MeasuresIn<Interval> measures(SidesIn<Interval> sides) { return measures_in(sides); }

Tri all_counterclockwise(std::span<const Ball> areas) { return all_counterclockwise_in(areas); }
Tri all_counterclockwise(std::span<const Interval> areas) { return all_counterclockwise_in(areas); }

Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Ball> h, const Ball& least) {
  return is_delaunay_and_wide_in(opposite, h, least);
}
Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Interval> h, const Interval& least) {
  return is_delaunay_and_wide_in(opposite, h, least);
}

}  // namespace epsnet::certify
