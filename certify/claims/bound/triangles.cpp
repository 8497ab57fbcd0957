#include "certify/claims/bound/triangles.h"

namespace epsnet::certify {
namespace {

Sides sides_of(std::span<const Ball> h, std::size_t t) { return h.subspan(3 * t).first<3>(); }

/// Whether a triangle's circumradius is at least r: 4abc ≥ K sinh²r.
Tri is_wide(Sides sides, const Ball& k, const Ball& least, slong precision) {
  Ball four_abc, product;
  arb_mul(four_abc.get(), sides[0].get(), sides[1].get(), precision);
  arb_mul(four_abc.get(), four_abc.get(), sides[2].get(), precision);
  arb_mul_2exp_si(four_abc.get(), four_abc.get(), 2);
  arb_mul(product.get(), k.get(), least.get(), precision);
  return !certainly_less(four_abc.get(), product.get());
}

}  // namespace

Tri fits(Sides sides, const Ball& most, slong precision) {
  Tri short_enough = Tri::yes;
  for (const Ball& side : sides) {
    short_enough = both(short_enough, !certainly_less(most.get(), side.get()));
  }
  if (short_enough == Tri::no) return Tri::no;
  // With sides that fit, a triangle that is not acute does.
  Tri acute = Tri::yes;
  Ball excess;
  for (std::size_t i = 0; i < 3; ++i) {
    arb_add(excess.get(), sides[(i + 1) % 3].get(), sides[(i + 2) % 3].get(), precision);
    arb_sub(excess.get(), excess.get(), sides[i].get(), precision);
    acute = both(acute, certainly_positive(excess.get()));
  }
  if (acute == Tri::no) return short_enough;
  // 4abc ≤ sinh²(r) K with K = 4ab − (a + b − c)²; K > 0 follows, as abc > 0 for an acute triangle.
  Ball left, right;
  arb_mul(left.get(), sides[0].get(), sides[1].get(), precision);
  arb_mul_2exp_si(left.get(), left.get(), 2);
  // The last excess is that of side 2.
  arb_sqr(right.get(), excess.get(), precision);
  arb_sub(right.get(), left.get(), right.get(), precision);
  const Tri circumcircle = certainly_positive(right.get());
  arb_mul(left.get(), left.get(), sides[2].get(), precision);
  arb_mul(right.get(), right.get(), most.get(), precision);
  const Tri larger = certainly_less(right.get(), left.get());
  if (circumcircle == Tri::yes && larger == Tri::no) return Tri::yes;
  return acute == Tri::yes && larger == Tri::yes ? Tri::no : Tri::unknown;
}

TriangleMeasures measures(Sides sides, slong precision) {
  TriangleMeasures result;
  for (std::size_t i = 0; i < 3; ++i) {
    arb_ptr excess = result.cotangent[i].get();
    arb_add(excess, sides[(i + 1) % 3].get(), sides[(i + 2) % 3].get(), precision);
    arb_sub(excess, excess, sides[i].get(), precision);
  }
  Ball four_ab, root;
  arb_mul(four_ab.get(), sides[0].get(), sides[1].get(), precision);
  arb_mul_2exp_si(four_ab.get(), four_ab.get(), 2);
  arb_sqr(root.get(), result.cotangent[2].get(), precision);
  arb_sub(result.k.get(), four_ab.get(), root.get(), precision);
  arb_sqrt(root.get(), result.k.get(), precision);
  for (Ball& cotangent : result.cotangent) arb_div(cotangent.get(), cotangent.get(), root.get(), precision);
  // tan(A/2) = √(K + 4abc)/(2 + a + b + c).
  arb_ptr area = result.area.get();
  arb_mul(area, four_ab.get(), sides[2].get(), precision);
  arb_add(area, area, result.k.get(), precision);
  arb_sqrt(area, area, precision);
  arb_set_ui(root.get(), 2);
  for (const Ball& side : sides) arb_add(root.get(), root.get(), side.get(), precision);
  arb_div(area, area, root.get(), precision);
  arb_atan(area, area, precision);
  arb_mul_2exp_si(area, area, 1);
  return result;
}

Tri all_counterclockwise(std::span<const Ball> areas, slong precision) {
  Ball excess, own;
  for (const Ball& area : areas) arb_add(excess.get(), excess.get(), area.get(), precision);
  // The area of the surface is 2π(2g − 2) = π(F − 2).
  arb_const_pi(own.get(), precision);
  arb_mul_ui(own.get(), own.get(), areas.size() - 2, precision);
  arb_sub(excess.get(), excess.get(), own.get(), precision);
  Tri result = Tri::yes;
  for (const Ball& area : areas) result = both(result, certainly_less(excess.get(), area.get()));
  return result;
}

Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Ball> h, const Ball& least,
                         slong precision) {
  const std::size_t count = h.size() / 3;
  std::vector<Ball> areas, cotangent;
  Tri result = Tri::yes;
  Tri wide = Tri::no;
  for (std::size_t t = 0; t < count; ++t) {
    TriangleMeasures triangle = measures(sides_of(h, t), precision);
    result = both(result, certainly_positive(triangle.k.get()));
    wide = either(wide, is_wide(sides_of(h, t), triangle.k, least, precision));
    areas.push_back(std::move(triangle.area));
    for (Ball& side : triangle.cotangent) cotangent.push_back(std::move(side));
  }
  Ball sum;
  for (std::size_t d = 0; d < h.size(); ++d) {
    arb_add(sum.get(), cotangent[d].get(), cotangent[opposite[d]].get(), precision);
    result = both(result, certainly_positive(sum.get()));
  }
  return both(both(result, wide), all_counterclockwise(areas, precision));
}

}  // namespace epsnet::certify
