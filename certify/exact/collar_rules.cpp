#include <array>
#include <string>

#include "certify/exact/interval.h"
#include "certify/exact/net_rules.h"

/// Section 10: the rule `collars` of pseudo nets.
namespace epsnet::exact {
namespace {

void expect(Answer holds, const std::string& otherwise) {
  if (holds == Answer::no) throw Refutation{otherwise};
  if (holds == Answer::unknown) throw TooLarge{"it is not decided whether " + otherwise};
}

std::string vertex_name(Index v) { return "vertex " + number(v); }

/// The dart of a triangle that goes from `twice` to itself, the third corner being `once`.
Index loop_dart(const NetStructure& net, Index t, Index twice, Index once) {
  for (Index dart = 3 * t; dart < 3 * t + 3; ++dart) {
    if (net.start(dart) == twice && net.start(next(dart)) == twice && net.start(previous(dart)) == once) return dart;
  }
  throw Refutation{net.triangle_name(t) + " has not two corners at " + vertex_name(twice) + ", one at " +
                   vertex_name(once)};
}

/// (b): the dart from p to p of the first triangle.
Index loop_of(const NetStructure& net, const Collar& collar) {
  const auto& [p, q] = collar.vertices;
  const Index at_p = loop_dart(net, collar.triangles[0], p, q);
  const Index at_q = loop_dart(net, collar.triangles[1], q, p);
  if (net.opposite(next(at_p)) != next(at_q) || net.opposite(previous(at_p)) != previous(at_q)) {
    throw Refutation{net.triangle_name(at_p / 3) + " and " + net.triangle_name(at_q / 3) + " are not an annulus"};
  }
  return at_p;
}

/// (c) to (g).
template <class R>
void check_collar(NetRules<R>& net, const Collar& collar) {
  const Index at_p = loop_of(net, collar);
  const Isometry<R> from = net.label(net.label_number(at_p));
  const Isometry<R> to = net.label(net.label_number(next(at_p)));
  // (c): the loop at p, in the chart of p.
  const Isometry<R> loop = net.element(at_p);
  const Index chart = net.net().vertices[collar.vertices[0]].chart;
  const Isometry<R> core = net.product(inverse(net.frame(chart)), net.value(chart, collar.core));
  if (!are_equal(core, loop) && !are_equal(inverse(core), loop)) {
    throw Refutation{"the loop at " + vertex_name(collar.vertices[0]) + " is not the core"};
  }
  // (d): γ = (a, b) up to the root of D = |a|² − |b|², in the chart of the triangle; σ = S/D = sinh²(l/2).
  const auto& [a, b] = net.product(to, inverse(from));
  const R d = norm(a) - norm(b);
  const R s = norm(b) - a.im * a.im;
  if (sgn(s) <= 0) throw Refutation{"the core is no closed geodesic"};
  const auto& [least, most] = collar.length;
  expect(!is_less(s, d, squared_sinh(least / 2)), "the length of the core is less than the file says");
  expect(is_less(s, d, squared_sinh(most / 2)), "the length of the core is more than the file says");
  // (e)
  const SquaredSinh half_epsilon = squared_sinh(net.net().epsilon / 2);
  expect(is_less(s, d, half_epsilon), "the length of the core is greater than epsilon");
  // (f): s(z) = h/(1 − |z|²) up to the root of D, with z = n/m.
  std::array<R, 2> h, g;
  for (const std::size_t i : {0U, 1U}) {
    const Point<R> z = net.corner(i == 0 ? at_p : previous(at_p));
    h[i] = 2 * z.m * (conjugate(b) * z.n).im - (z.m * z.m + norm(z.n)) * a.im;
    g[i] = gap(z);
  }
  if (sgn(h[0]) * sgn(h[1]) >= 0) throw Refutation{"the two vertices are not on different sides of the core"};
  // (g)
  const Interval sigma = enclosure(s) / enclosure(d);
  const Interval epsilon(net.net().epsilon);
  const Interval half_length = arsinh(sqrt(sigma));
  const Interval thin_width = arsinh(sqrt((square(sinh(epsilon / 2)) - sigma) / sigma));
  for (const std::size_t i : {0U, 1U}) {
    const R square_of_gap = g[i] * g[i];
    const R square_of_h = h[i] * h[i];
    expect(!is_less(R(s * square_of_gap + square_of_h), R(d * square_of_gap), half_epsilon),
           vertex_name(collar.vertices[i]) + " is in the epsilon-thin part");
    // cosh² d_v = 1 + s²/σ.
    const Interval ratio = enclosure(square_of_h) / enclosure(R(s * square_of_gap));
    const Interval distance = arsinh(sqrt(ratio));
    const Interval along = 2 * arsinh(sinh(half_length / 2) * sqrt(ratio + 1));
    expect(is_less(along + distance - thin_width, epsilon),
           vertex_name(collar.vertices[i]) + " does not cover the thick part of its side of the annulus");
  }
}

}  // namespace

template <class R>
void NetRules<R>::check_collars() {
  expect(is_less(2 * Interval(net().epsilon), log(Interval(2))), "epsilon is greater than ln sqrt(2)");
  for (const Collar& collar : *net().collars) {
    // (a)
    for (const Index t : collar.triangles) {
      if (in_collar_[t]) throw Refutation{"triangle " + number(t) + " is named twice"};
      in_collar_[t] = true;
    }
    for (const std::size_t i : {0U, 1U}) {
      if (!partners_.try_emplace(collar.vertices[i], collar.vertices[1 - i]).second) {
        throw Refutation{vertex_name(collar.vertices[i]) + " is named twice"};
      }
    }
    check_collar(*this, collar);
  }
}

template void NetRules<mpz_class>::check_collars();
template void NetRules<Algebraic>::check_collars();
template void NetRules<FieldNumber>::check_collars();

}  // namespace epsnet::exact
