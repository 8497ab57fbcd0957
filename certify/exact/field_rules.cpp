#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/net_rules.h"
#include "certify/exact/number_field.h"
#include "certify/exact/tile_rules.h"

/// Section 9.1: the rule `surface` for tiles over a number field, whose crossings are given.
namespace epsnet::exact {
namespace {

using FieldVector = MinkowskiVector<FieldNumber>;
using FieldIsometry = Isometry<FieldNumber>;

/// (a′): the vertices, which are in the disk.
std::vector<std::vector<FieldVector>> vectors_of(const FieldTiles& given, const NumberField& field,
                                                 NetRules<FieldNumber>& rules) {
  std::vector<std::vector<FieldVector>> vectors;
  for (std::size_t t = 0; t < given.tiles.size(); ++t) {
    vectors.emplace_back();
    for (const auto& [x, y, last] : given.tiles[t]) {
      const FieldVector v{{field, x}, {field, y}, {field, last}};
      rules.spend(bits(v));
      if (sgn(v.t) <= 0 || sgn(lorentz_product(v, v)) >= 0) refute_vertex_of(t);
      vectors.back().push_back(v);
    }
  }
  return vectors;
}

/// (c′): an isometry that takes side s to the other one, so that they are of equal length.
void expect_crossing(const FieldIsometry& g, Index s, Index other, const TileRules<FieldNumber>& tiles,
                     const NetStructure& net) {
  const std::string name = "the crossing of " + net.side_name(s);
  if (sgn(norm(g.a) - norm(g.b)) <= 0) throw Refutation{name + " is no isometry"};
  if (!are_parallel(image(g, tiles.side_start(s)), tiles.side_end(other)) ||
      !are_parallel(image(g, tiles.side_end(s)), tiles.side_start(other))) {
    throw Refutation{name + " does not take it to " + net.side_name(other)};
  }
}

}  // namespace

template <>
std::size_t NetRules<FieldNumber>::check_tiles() {
  const FieldTiles& given = *net().field;
  const auto field =
      std::make_shared<NumberField>(given.polynomial, given.root[0], given.root[1],
                                    NumberField::kUsualWork + NumberField::kWorkOfATriangle * net().triangles.size());
  field_ = field;
  TileRules<FieldNumber> tiles(*this, vectors_of(given, *field, *this));
  tiles.check_convexity();
  crossings_.resize(sides());
  for (std::size_t i = 0; i < given.crossings.size(); ++i) {
    const auto& [tile, k, other_tile, other_k] = net().gluing[i];
    const Index s = side(tile, k);
    const Index other = side(other_tile, other_k);
    const auto& [a, a_im, b, b_im] = given.crossings[i];
    const FieldIsometry g{{{*field, a}, {*field, a_im}}, {{*field, b}, {*field, b_im}}};
    spend(bits(g));
    expect_crossing(g, s, other, tiles, *this);
    crossings_[s] = g;
    crossings_[other] = inverse(g);
  }
  return tiles.check_corners(crossings_);
}

}  // namespace epsnet::exact
