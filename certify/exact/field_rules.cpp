#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "certify/exact/net_rules.h"
#include "certify/exact/number_field.h"
#include "certify/exact/tile_rules.h"

/// Section 9.1: the rule `surface` for tiles over a number field, whose crossings are given.
namespace epsnet::exact {

template <>
std::size_t NetRules<FieldNumber>::check_tiles() {
  const FieldTiles& given = *net().field;
  const auto field = std::make_shared<NumberField>(given.polynomial, given.root[0], given.root[1]);
  field_ = field;
  const auto number_of = [&](const Polynomial& x) { return FieldNumber(*field, x); };
  std::vector<std::vector<MinkowskiVector<FieldNumber>>> vectors;
  for (const auto& tile : given.tiles) {
    vectors.emplace_back();
    for (const auto& [x, y, t] : tile) {
      vectors.back().push_back({number_of(x), number_of(y), number_of(t)});
      spend(bits(vectors.back().back()));
    }
  }
  TileRules<FieldNumber> tiles(*this, std::move(vectors));
  tiles.check_convexity();
  crossings_.resize(sides());
  for (std::size_t i = 0; i < given.crossings.size(); ++i) {
    const auto& [tile, k, other_tile, other_k] = net().gluing[i];
    const Index s = side(tile, k);
    const Index other = side(other_tile, other_k);
    const auto& [a, a_im, b, b_im] = given.crossings[i];
    const Isometry<FieldNumber> g{{number_of(a), number_of(a_im)}, {number_of(b), number_of(b_im)}};
    spend(bits(g));
    const std::string name = "the crossing of " + side_name(s);
    if (sgn(norm(g.a) - norm(g.b)) <= 0) throw Refutation{name + " is no isometry"};
    // (c′), by which the two sides are of equal length.
    if (!are_parallel(exact::image(g, tiles.side_start(s)), tiles.side_end(other)) ||
        !are_parallel(exact::image(g, tiles.side_end(s)), tiles.side_start(other))) {
      throw Refutation{name + " does not take it to " + side_name(other)};
    }
    crossings_[s] = g;
    crossings_[other] = inverse(g);
  }
  return tiles.check_corners(crossings_);
}

}  // namespace epsnet::exact
