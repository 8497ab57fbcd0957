#include "certify/exact/tile_rules.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/net_rules.h"
#include "certify/exact/number_field.h"

/// The rule `surface` for tiles of each kind.
namespace epsnet::exact {
// Section 2: rational tiles.

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

// Section 9: regular tiles, p-gons with the angles 2π/q, and their crossings.

/// (h): the angles around a corner, q times 2π/q, add up to a full turn.
template <>
std::size_t NetRules<Algebraic>::check_tiles() {
  const auto& [p, q] = *net().regular;
  if ((p - 2) * (q - 2) <= 4) throw Refutation{"there are no such tiles in the hyperbolic plane"};
  std::vector<bool> seen(sides());
  std::size_t cycles = 0;
  for (Index first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    ++cycles;
    std::size_t corners = 0;
    for (Index s = first; !seen[s]; s = side_after(partner(s)), ++corners) seen[s] = true;
    if (corners != q) throw Refutation{number(corners) + " corners, not q, meet at " + corner_name(first)};
  }
  return cycles;
}

/// From side k to side l, with the factor 2 d_p d_q: a = −i 2e^{iπ(l − k)/p} · 2 sin(2π/q), b = i 2e^{iπ(l + k)/p} · s,
/// as d_p cosh ρ = 2cos(π/q).
template <>
const std::vector<Isometry<Algebraic>>& NetRules<Algebraic>::crossings() {
  if (!crossings_.empty()) return crossings_;
  const Index p = net().regular->p;
  const Index q = net().regular->q;
  // Of l, which means the same as l + p, one is taken whose sum with k is even, if there is one.
  const auto k_and_l = [&](Index s) {
    const long k = vertex_of(s);
    const long l = vertex_of(partner(s));
    return std::array<long, 2>{k, (k + l) % 2 == 0 || p % 2 == 0 ? l : l + p};
  };
  bool half_turns = false;
  for (Index s = 0; s < sides(); ++s) {
    const auto [k, l] = k_and_l(s);
    half_turns = half_turns || (k + l) % 2 != 0;
  }
  const auto field = std::make_shared<RealField>(p, q, half_turns);
  field_ = field;
  const auto n = static_cast<long>(field->n());
  const auto sine = [&](long k) { return field->cosine(k - n / 4); };
  const Algebraic cosh = sine(n / q);
  const Algebraic sinh = field->s();
  for (Index s = 0; s < sides(); ++s) {
    const auto [k, l] = k_and_l(s);
    // 2e^{iπm/p}.
    const auto turn = [&, p = static_cast<long>(p)](long m) {
      const long angle = n / 2 * m / p;
      return Complex<Algebraic>{field->cosine(angle), sine(angle)};
    };
    crossings_.push_back({Complex<Algebraic>{0, -cosh} * turn(l - k), Complex<Algebraic>{0, sinh} * turn(l + k)});
    reduce(crossings_.back());
  }
  return crossings_;
}

// Section 9.1: tiles over a number field, whose crossings are given.

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
