#include "certify/exact/tile_rules.h"

#include <vector>

#include "certify/exact/net_rules.h"

/// Section 2: the rule `surface` for rational tiles.
namespace epsnet::exact {
namespace {

using RationalIsometry = Isometry<mpz_class>;

struct Side {
  const RationalPoint& start;
  const RationalPoint& end;
};

Side ends_of(const NetStructure& net, Index s) {
  const std::vector<RationalPoint>& tile = net.net().tiles[net.tile_of(s)];
  return {tile[net.vertex_of(s)], tile[net.vertex_of(net.side_after(s))]};
}

/// (c): sinh² of half the length is |p − q|²/((1 − |p|²)(1 − |q|²)).
bool are_equally_long(const Side& x, const Side& y) {
  return squared_difference(x.start, x.end) * (gap(y.start) * gap(y.end)) ==
         squared_difference(y.start, y.end) * (gap(x.start) * gap(x.end));
}

/// p ↦ q′ and q ↦ p′ for sides from p to q and from p′ to q′: p to 0, a turn, 0 to q′.
RationalIsometry crossing(NetRules<mpz_class>& rules, const Side& side, const Side& other) {
  const RationalIsometry first = inverse(translation_to(side.start));
  const RationalIsometry last = translation_to(other.end);
  const RationalPoint from = rules.image(first, side.end);
  const RationalPoint to = rules.image(inverse(last), other.start);
  // |from| = |to|. The turn by to/from is z ↦ ρz/ρ̄ with ρ = 1 + to/from up to a real factor, or i if that is 0.
  Complex<mpz_class> root = (from.m * to.n + to.m * from.n) * conjugate(from.n);
  if (is_zero(root)) root = {0, 1};
  RationalIsometry result = compose(last, compose(RationalIsometry{root, {0, 0}}, first));
  rules.spend(bits(result));
  reduce(result);
  return result;
}

}  // namespace

template <>
std::size_t NetRules<mpz_class>::check_tiles() {
  std::vector<std::vector<MinkowskiVector<mpz_class>>> vectors;
  for (std::size_t t = 0; t < net().tiles.size(); ++t) {
    vectors.emplace_back();
    for (const RationalPoint& z : net().tiles[t]) {
      if (gap(z) <= 0) refute_vertex_of(t);  // Its vector would be that of 1/z̄.
      vectors.back().push_back(minkowski_vector(z));
    }
  }
  TileRules<mpz_class> tiles(*this, std::move(vectors));
  tiles.check_convexity();
  crossings_.resize(sides());
  for (Index s = 0; s < sides(); ++s) {
    const Index other = partner(s);
    if (other < s) continue;
    if (!are_equally_long(ends_of(*this, s), ends_of(*this, other))) {
      throw Refutation{side_name(s) + " is glued to " + side_name(other) + ", which is not of equal length"};
    }
    crossings_[s] = crossing(*this, ends_of(*this, s), ends_of(*this, other));
    crossings_[other] = inverse(crossings_[s]);
  }
  return tiles.check_corners(crossings_);
}

}  // namespace epsnet::exact
