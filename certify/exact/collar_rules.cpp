#include <array>
#include <set>

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

}  // namespace

void NetRules::check_collar_structure(const Collar& collar) const {
  for (const Index v : collar.vertices) expect_less(v, net_.vertices.size(), "vertex");
  for (const Index t : collar.triangles) expect_less(t, net_.triangles.size(), "triangle");
  const Index tile = net_.charts[net_.vertices[collar.vertices[0]].chart].first;
  expect_path(collar.core, tile, tile);
}

void NetRules::check_collars() {
  expect(is_less(2 * Interval(net_.epsilon), log(Interval(2))), "epsilon is greater than ln sqrt(2)");
  for (const Collar& collar : *net_.collars) {
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
    check_collar(collar);
  }
}

Index NetRules::loop_dart(Index t, Index twice, Index once) const {
  for (Index dart = 3 * t; dart < 3 * t + 3; ++dart) {
    if (start(dart) == twice && start(next(dart)) == twice && start(previous(dart)) == once) return dart;
  }
  throw Refutation{triangle_name(t) + " has not two corners at " + vertex_name(twice) + ", one at " +
                   vertex_name(once)};
}

Index NetRules::loop_of(const Collar& collar) const {
  const auto& [p, q] = collar.vertices;
  const Index at_p = loop_dart(collar.triangles[0], p, q);
  const Index at_q = loop_dart(collar.triangles[1], q, p);
  if (opposite(next(at_p)) != next(at_q) || opposite(previous(at_p)) != previous(at_q)) {
    throw Refutation{triangle_name(at_p / 3) + " and " + triangle_name(at_q / 3) + " are not an annulus"};
  }
  return at_p;
}

void NetRules::check_collar(const Collar& collar) {
  const Index at_p = loop_of(collar);
  const Isometry from = label(label_number(at_p));
  const Isometry to = label(label_number(next(at_p)));
  // (c): the loop at p, in the chart of p.
  const Isometry loop = product(inverse(from), to);
  const Index chart = net_.vertices[collar.vertices[0]].chart;
  const Isometry core = product(inverse(translation_to(net_.charts[chart].second)), value(chart, collar.core));
  if (!is_identity(compose(core, loop)) && !is_identity(compose(inverse(core), loop))) {
    throw Refutation{"the loop at " + vertex_name(collar.vertices[0]) + " is not the core"};
  }
  // (d): γ = (a, b) up to the root of D = |a|² − |b|², in the chart of the triangle; σ = S/D = sinh²(l/2).
  const auto& [a, b] = product(to, inverse(from));
  const mpz_class d = norm(a) - norm(b);
  const mpz_class s = norm(b) - a.im * a.im;
  if (s <= 0) throw Refutation{"the core is no closed geodesic"};
  const auto& [least, most] = collar.length;
  expect(!is_less(s, d, squared_sinh(least / 2)), "the length of the core is less than the file says");
  expect(is_less(s, d, squared_sinh(most / 2)), "the length of the core is more than the file says");
  // (e)
  const SquaredSinh half_epsilon = squared_sinh(net_.epsilon / 2);
  expect(is_less(s, d, half_epsilon), "the length of the core is greater than epsilon");
  // (f): s(z) = h/(1 − |z|²) up to the root of D, with z = n/m.
  std::array<mpq_class, 2> squares;  // s(z)².
  int signs = 1;
  for (const std::size_t i : {0U, 1U}) {
    const Point z = corner(i == 0 ? at_p : previous(at_p));
    const mpz_class h = 2 * z.m * (conjugate(b) * z.n).im - (z.m * z.m + norm(z.n)) * a.im;
    signs *= sgn(h);
    squares[i] = mpq_class(h * h, gap(z) * gap(z) * d);
    squares[i].canonicalize();
  }
  if (signs >= 0) throw Refutation{"the two vertices are not on different sides of the core"};
  // (g)
  mpq_class sigma(s, d);
  sigma.canonicalize();
  const Interval epsilon(net_.epsilon);
  const Interval half_length = arsinh(sqrt(Interval(sigma)));
  const Interval thin_width = arsinh(sqrt((square(sinh(epsilon / 2)) - Interval(sigma)) / Interval(sigma)));
  for (const std::size_t i : {0U, 1U}) {
    const mpq_class h = sigma + squares[i];
    expect(!is_less(h.get_num(), h.get_den(), half_epsilon),
           vertex_name(collar.vertices[i]) + " is in the epsilon-thin part");
    // cosh² d_v = 1 + s²/σ.
    const mpq_class ratio = squares[i] / sigma;
    const Interval distance = arsinh(sqrt(Interval(ratio)));
    const Interval along = 2 * arsinh(sinh(half_length / 2) * sqrt(Interval(ratio + 1)));
    expect(is_less(along + distance - thin_width, epsilon),
           vertex_name(collar.vertices[i]) + " does not cover the thick part of its side of the annulus");
  }
}

}  // namespace epsnet::exact
