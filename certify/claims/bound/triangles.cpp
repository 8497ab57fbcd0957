#include "certify/claims/bound/triangles.h"

namespace epsnet::certify {
namespace {

Sides sides_of(std::span<const Ball> h, std::size_t t) { return h.subspan(3 * t).first<3>(); }

/// Whether a triangle's circumradius is at least r: 4abc ≥ K sinh²r.
Tri is_wide(Sides sides, const Ball& k, const Ball& least) {
  return !certainly_less(scaled(sides[0] * sides[1] * sides[2], 2), k * least);
}

/// The sides a, b, c: b + c − a, c + a − b, a + b − c, whose signs are those of the cosines of the opposite angles.
std::array<Ball, 3> excesses(Sides sides) {
  return {sides[1] + sides[2] - sides[0], sides[2] + sides[0] - sides[1], sides[0] + sides[1] - sides[2]};
}

}  // namespace

Tri fits(Sides sides, const Ball& most) {
  Tri short_enough = Tri::yes;
  for (const Ball& side : sides) short_enough = both(short_enough, !certainly_less(most, side));
  if (short_enough == Tri::no) return Tri::no;
  // With sides that fit, a triangle that is not acute does.
  const std::array<Ball, 3> excess = excesses(sides);
  Tri acute = Tri::yes;
  for (const Ball& x : excess) acute = both(acute, certainly_positive(x));
  if (acute == Tri::no) return short_enough;
  // 4abc ≤ sinh²(r) K with K = 4ab − (a + b − c)²; K > 0 follows, as abc > 0 for an acute triangle.
  const Ball four_ab = scaled(sides[0] * sides[1], 2);
  const Ball k = four_ab - sqr(excess[2]);
  const Tri larger = certainly_less(k * most, four_ab * sides[2]);
  if (certainly_positive(k) == Tri::yes && larger == Tri::no) return Tri::yes;
  return acute == Tri::yes && larger == Tri::yes ? Tri::no : Tri::unknown;
}

TriangleMeasures measures(Sides sides) {
  TriangleMeasures result;
  result.cotangent = excesses(sides);
  const Ball four_ab = scaled(sides[0] * sides[1], 2);
  result.k = four_ab - sqr(result.cotangent[2]);
  const Ball root = sqrt(result.k);
  for (Ball& cotangent : result.cotangent) cotangent = cotangent / root;
  // tan(A/2) = √(K + 4abc)/(2 + a + b + c).
  result.area = twice(atan(sqrt(four_ab * sides[2] + result.k) / (2 + sides[0] + sides[1] + sides[2])));
  return result;
}

Tri all_counterclockwise(std::span<const Ball> areas) {
  Ball excess;
  for (const Ball& area : areas) excess += area;
  // The area of the surface is 2π(2g − 2) = π(F − 2).
  excess = excess - (areas.size() - 2) * pi();
  Tri result = Tri::yes;
  for (const Ball& area : areas) result = both(result, certainly_less(excess, area));
  return result;
}

Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Ball> h, const Ball& least) {
  std::vector<Ball> areas, cotangent;
  Tri result = Tri::yes;
  Tri wide = Tri::no;
  for (std::size_t t = 0; t < h.size() / 3; ++t) {
    TriangleMeasures triangle = measures(sides_of(h, t));
    result = both(result, certainly_positive(triangle.k));
    wide = either(wide, is_wide(sides_of(h, t), triangle.k, least));
    areas.push_back(std::move(triangle.area));
    for (Ball& side : triangle.cotangent) cotangent.push_back(std::move(side));
  }
  for (std::size_t d = 0; d < h.size(); ++d) {
    result = both(result, certainly_positive(cotangent[d] + cotangent[opposite[d]]));
  }
  return both(both(result, wide), all_counterclockwise(areas));
}

}  // namespace epsnet::certify
