#include <array>
#include <memory>
#include <string>
#include <vector>

#include "certify/exact/net_rules.h"

/// Section 2: the rule `surface` for rational tiles.

namespace epsnet::exact {
namespace {

/// Bits of the directions around one corner, which are only multiplied.
constexpr std::size_t kMaxBitsOfDirections = std::size_t{1} << 32;

/// Whether the argument in [0, 2π) is at least π. Any half-plane would do to count full turns: the walk ends in the
/// direction in which it starts.
bool is_below(const Complex<mpz_class>& z) { return sgn(z.im) < 0 || (sgn(z.im) == 0 && sgn(z.re) < 0); }

using RationalIsometry = Isometry<mpz_class>;

class TileRules {
 public:
  TileRules(NetRules<mpz_class>& rules, std::vector<RationalIsometry>& crossings)
      : rules_(rules), crossings_(crossings) {}

  /// (a): in the disk, a left turn at every corner, and seen from vertex 0 in counterclockwise order.
  void check_tile(std::size_t t) const {
    const std::vector<RationalPoint>& v = rules_.net().tiles[t];
    const std::size_t n = v.size();
    const std::string name = "tile " + number(t);
    for (const RationalPoint& z : v) {
      if (gap(z) <= 0) throw Refutation{name + " has a vertex outside of the disk"};
    }
    for (std::size_t k = 0; k < n; ++k) {
      const bool left_turn = orientation(v[k], v[(k + 1) % n], v[(k + 2) % n]) > 0;
      const bool left_of_first = k < 2 || orientation(v[0], v[1], v[k]) > 0;
      const bool in_order = k < 1 || k + 1 >= n || orientation(v[0], v[k], v[k + 1]) > 0;
      if (!left_turn || !left_of_first || !in_order) {
        throw Refutation{name + " is not strictly convex and counterclockwise at its vertex " + number(k)};
      }
    }
  }

  /// (c), and the crossings.
  void check_lengths() {
    crossings_.resize(rules_.sides());
    for (Index s = 0; s < rules_.sides(); ++s) {
      const Index other = rules_.partner(s);
      if (other < s) continue;
      const RationalPoint& p = side_start(s);
      const RationalPoint& q = side_end(s);
      const RationalPoint& p_other = side_start(other);
      const RationalPoint& q_other = side_end(other);
      // sinh² of half the length is |p − q|²/((1 − |p|²)(1 − |q|²)).
      if (squared_difference(p, q) * (gap(p_other) * gap(q_other)) !=
          squared_difference(p_other, q_other) * (gap(p) * gap(q))) {
        throw Refutation{rules_.side_name(s) + " is glued to " + rules_.side_name(other) +
                         ", which is not of equal length"};
      }
      crossings_[s] = crossing(p, q, p_other, q_other);
      crossings_[other] = inverse(crossings_[s]);
    }
  }

  /// (f) and (g): around every cycle of corners the crossings multiply to 1 and the angles add up to one full turn. The
  /// number of cycles.
  std::size_t check_corners() {
    std::vector<bool> seen(rules_.sides());
    std::size_t cycles = 0;
    for (Index first = 0; first < seen.size(); ++first) {
      if (seen[first]) continue;
      ++cycles;
      const std::string name = rules_.corner_name(first);
      std::vector<const RationalIsometry*> path;
      Complex<mpz_class> direction{1, 0};
      int turns = 0;
      std::size_t size = 0;
      Index s = first;
      do {
        seen[s] = true;
        // Each corner turns by less than π: it completes a turn if it leads from the lower half-plane to the upper one.
        const bool was_below = is_below(direction);
        direction = direction * interior_angle(s);
        if (was_below && !is_below(direction)) ++turns;
        size += bits(direction);
        if (size > kMaxBitsOfDirections) throw TooLarge{"too many corners around " + name};
        path.push_back(&crossings_[s]);
        s = rules_.side_after(rules_.partner(s));
      } while (s != first);
      if (!is_identity(rules_.product(path))) throw Refutation{"the corners around " + name + " do not close up"};
      if (turns != 1 || direction.im != 0) {
        throw Refutation{"the angles around " + name + " add up to " + std::to_string(turns) + " full turns"};
      }
    }
    return cycles;
  }

 private:
  [[nodiscard]] const RationalPoint& side_start(Index s) const {
    return rules_.net().tiles[rules_.tile_of(s)][rules_.vertex_of(s)];
  }
  [[nodiscard]] const RationalPoint& side_end(Index s) const { return side_start(rules_.side_after(s)); }

  /// p ↦ q′ and q ↦ p′: p to 0, a turn, 0 to q′.
  RationalIsometry crossing(const RationalPoint& p, const RationalPoint& q, const RationalPoint& p_other,
                            const RationalPoint& q_other) {
    const RationalIsometry first = inverse(translation_to(p));
    const RationalIsometry last = translation_to(q_other);
    const RationalPoint from = rules_.image(first, q);
    const RationalPoint to = rules_.image(inverse(last), p_other);
    // |from| = |to|. The turn by to/from is z ↦ ρz/ρ̄ with ρ = 1 + to/from up to a real factor, or i if that is 0.
    Complex<mpz_class> root = (from.m * to.n + to.m * from.n) * conjugate(from.n);
    if (root.re == 0 && root.im == 0) root = {0, 1};
    RationalIsometry result = compose(last, compose(RationalIsometry{root, {0, 0}}, first));
    rules_.spend(bits(result));
    reduce(result);
    return result;
  }

  /// A number whose argument, between 0 and π, is the interior angle where the side starts.
  Complex<mpz_class> interior_angle(Index s) {
    const RationalIsometry to_origin = inverse(translation_to(side_start(s)));
    const RationalPoint from = rules_.image(to_origin, side_end(s));
    const RationalPoint to = rules_.image(to_origin, side_start(rules_.side_before(s)));
    return to.n * conjugate(from.n);
  }

  NetRules<mpz_class>& rules_;
  std::vector<RationalIsometry>& crossings_;
};

}  // namespace

template <>
const std::vector<RationalIsometry>& NetRules<mpz_class>::crossings() {
  return crossings_;
}

template <>
std::size_t NetRules<mpz_class>::check_tiles() {
  TileRules tiles(*this, crossings_);
  for (std::size_t t = 0; t < net().tiles.size(); ++t) tiles.check_tile(t);
  tiles.check_lengths();
  return tiles.check_corners();
}

// Section 9: the rule `surface` for regular tiles, p-gons with the angles 2π/q, and their crossings.

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
  field_ = std::make_unique<RealField>(p, q, half_turns);
  const auto n = static_cast<long>(field_->n());
  const auto sine = [&](long k) { return field_->cosine(k - n / 4); };
  const Algebraic cosh = sine(n / q);
  const Algebraic sinh = field_->s();
  for (Index s = 0; s < sides(); ++s) {
    const auto [k, l] = k_and_l(s);
    // 2e^{iπm/p}.
    const auto turn = [&, p = static_cast<long>(p)](long m) {
      const long angle = n / 2 * m / p;
      return Complex<Algebraic>{field_->cosine(angle), sine(angle)};
    };
    crossings_.push_back({Complex<Algebraic>{0, -cosh} * turn(l - k), Complex<Algebraic>{0, sinh} * turn(l + k)});
    reduce(crossings_.back());
  }
  return crossings_;
}

}  // namespace epsnet::exact
