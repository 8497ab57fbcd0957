#include <memory>
#include <vector>

#include "certify/exact/net_rules.h"

/// Section 9: the rule `surface` for regular tiles, p-gons with the angles 2π/q, and their crossings.
namespace epsnet::exact {

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

}  // namespace epsnet::exact
