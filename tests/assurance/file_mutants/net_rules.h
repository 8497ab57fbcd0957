#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/assurance/file_mutants/plane.h"
#include "tests/assurance/file_mutants/reference_document.h"

/// The rules of nets over an exact ring F.
namespace epsnet::attack {

/// A rule is broken.
struct Broken {
  const char* rule;
};

/// Rational bounds of sinh²(x), x ≥ 0; for x between 2⁻²⁰⁰ and 300 their relative errors are below 2⁻¹⁰⁰⁰.
struct SinhSquare {
  mpq_class lower;
  mpq_class upper;
  bool bounded = true;  ///< Else there is no upper one.

  explicit SinhSquare(const mpq_class& x) {
    if (x > 300) {
      lower = mpq_class(mpz_class(1) << 800);
      bounded = false;
      return;
    }
    const mpq_class square = x * x;
    if (square < mpq_class(1, mpz_class(1) << 400)) {
      lower = square;
      upper = square * 2;
      return;
    }
    // (cosh 2x − 1)/2: the terms (2x)^(2n)/(2n)!, rounded down and up to multiples of 2⁻¹⁶⁰⁰.
    const mpz_class one = mpz_class(1) << 1600;
    const mpq_class y = 4 * square;
    mpz_class low = one;
    mpz_class high = one;
    mpz_class low_sum = 0;
    mpz_class high_sum = 0;
    for (unsigned long n = 1; high > 1; ++n) {
      const mpz_class divisor = y.get_den() * ((2 * n) * (2 * n - 1));
      low = low * y.get_num();
      high = high * y.get_num();
      mpz_fdiv_q(low.get_mpz_t(), low.get_mpz_t(), divisor.get_mpz_t());
      mpz_cdiv_q(high.get_mpz_t(), high.get_mpz_t(), divisor.get_mpz_t());
      low_sum += low;
      high_sum += high;
    }
    // What follows is less than the last term, 2⁻¹⁶⁰⁰, and that much again.
    lower = mpq_class(low_sum, 2 * one);
    upper = mpq_class(high_sum + 2, 2 * one);
    lower.canonicalize();
    upper.canonicalize();
  }
};

/// −1 if n/d < s, 1 if n/d > s; d > 0.
template <class F>
[[nodiscard]] int compare(const F& n, const F& d, const SinhSquare& s) {
  const auto sign_of_difference = [&](const mpq_class& q) { return sign(F(n * F(q.get_den()) - d * F(q.get_num()))); };
  if (sign_of_difference(s.lower) < 0) return -1;
  if (s.bounded && sign_of_difference(s.upper) > 0) return 1;
  throw Unknown{"a length near a bound"};
}

template <class F>
[[nodiscard]] double ratio(const F& n, const F& d) {
  const mpf_class quotient = approximation(n, 4096) / approximation(d, 4096);
  return quotient.get_d();
}

template <class F>
[[nodiscard]] Point<F> point(const RationalPoint& z) {
  const mpz_class d = lcm(z.x.get_den(), z.y.get_den());
  return {{F(mpz_class(z.x.get_num() * (d / z.x.get_den()))), F(mpz_class(z.y.get_num() * (d / z.y.get_den())))},
          {F(d), F(mpz_class(0))}};
}

/// z ↦ (z − p)/(1 − p̄z) for a p with a real denominator.
template <class F>
[[nodiscard]] Isometry<F> to_origin(const Point<F>& p) {
  return {p.d, -p.n};
}

/// A surface: the crossings of its sides, and its tiles.
template <class F>
struct Tiling {
  std::vector<std::vector<Point<F>>> tiles;
  std::vector<Isometry<F>> crossing;
  long euler = 0;
};

/// Rule `surface` for tiles. Throws Broken.
template <class F>
[[nodiscard]] Tiling<F> rational_tiling(const NetFile& net) {
  const auto expect = [](bool holds) {
    if (!holds) throw Broken{"surface"};
  };
  Tiling<F> result;
  std::vector<Point<F>> start;  // By side.
  for (const auto& polygon : net.tiles) {
    result.tiles.emplace_back();
    for (const RationalPoint& z : polygon) result.tiles.back().push_back(point<F>(z));
    start.insert(start.end(), result.tiles.back().begin(), result.tiles.back().end());
  }
  for (const Point<F>& z : start) expect(sign(gap(z)) > 0);
  // Strictly convex: every other corner is strictly left of every side.
  for (Index s = 0; s < start.size(); ++s) {
    for (Index other = net.next[net.next[s]]; other != s; other = net.next[other]) {
      expect(turn(start[s], start[net.next[s]], start[other]) > 0);
    }
  }
  for (Index s = 0; s < start.size(); ++s) {
    const Index t = net.partner[s];
    const Isometry<F> from = to_origin(start[s]);
    const Isometry<F> to = to_origin(start[net.next[t]]);
    const Point<F> w = from(start[net.next[s]]);
    const Point<F> v = to(start[t]);
    const F product = norm(v.d) * norm(w.n);
    expect(sign(F(norm(v.n) * norm(w.d) - product)) == 0);
    // The rotation by the angle from w to v: its half is that of v/w + 1.
    Complex<F> half = Complex<F>{product, F(0)} + v.n * conj(v.d) * conj(w.n) * w.d;
    if (sign(norm(half)) == 0) half = {F(0), F(1)};
    result.crossing.push_back(inverse(to) * (Isometry<F>{half, {}} * from));
  }
  std::vector<bool> seen(start.size());
  long cycles = 0;
  for (Index s = 0; s < start.size(); ++s) {
    if (seen[s]) continue;
    ++cycles;
    Isometry<F> around;
    double angle = 0;
    for (Index t = s; !seen[t]; t = net.next[net.partner[t]]) {
      seen[t] = true;
      around = result.crossing[t] * around;
      Index before = t;
      while (net.next[before] != t) before = net.next[before];
      const Point<F> u = to_origin(start[t])(start[net.next[t]]);
      const Point<F> v = to_origin(start[t])(start[before]);
      const Complex<F> turned = v.n * conj(v.d) * conj(Complex<F>(u.n * conj(u.d)));
      // The larger part as 1, lest they overflow.
      const bool flat = sign(F(turned.re * turned.re - turned.im * turned.im)) > 0;
      const F scale =
          flat ? (sign(turned.re) > 0 ? turned.re : F(-turned.re)) : (sign(turned.im) > 0 ? turned.im : F(-turned.im));
      angle += std::atan2(ratio(turned.im, scale), ratio(turned.re, scale));
    }
    expect(is_identity(around));
    expect(std::fabs(angle - 2 * std::numbers::pi) < 0.1);
  }
  std::vector<bool> reached(net.tiles.size());
  reached[0] = true;
  for (bool more = true; more;) {
    more = false;
    for (Index s = 0; s < start.size(); ++s) {
      if (!reached[net.tile[s]] || reached[net.tile[net.partner[s]]]) continue;
      reached[net.tile[net.partner[s]]] = more = true;
    }
  }
  expect(std::find(reached.begin(), reached.end(), false) == reached.end());
  result.euler = cycles - static_cast<long>(start.size() / 2) + static_cast<long>(net.tiles.size());
  expect(result.euler <= -2 && result.euler % 2 == 0);
  return result;
}

template <class F>
class NetRules {
 public:
  NetRules(const NetFile& net, const Tiling<F>& tiling) : net_(net), tiling_(tiling) {}

  /// Checks all rules after `surface`, in their order. Throws Broken.
  void check() {
    map();
    evaluate_labels();
    each_edge("gluing", [&](Index d) { return same(step(d), label(next(d)) * inverse(label(across(d)))); });
    if (net_.collars) collars();
    each_dart("orientation", [&](Index d) { return d % 3 != 0 || turn(corner(d), corner(d + 1), corner(d + 2)) > 0; });
    each_edge("delaunay", [&](Index d) {
      const Point<F> far = step(d)(corner(before(across(d))));
      const auto delta = [](const Point<F>& u, const Point<F>& v) { return difference(u, v); };
      const Complex<F> upper = delta(corner(before(d)), far) * delta(corner(next(d)), corner(d));
      const Complex<F> lower = delta(corner(before(d)), corner(d)) * delta(corner(next(d)), far);
      return sign((upper * conj(lower)).im) <= 0;
    });
    const SinhSquare epsilon(net_.epsilon);
    const SinhSquare half(net_.epsilon / 2);
    each_dart("covering", [&](Index d) {
      if (d % 3 != 0) return true;
      const Point<F> u = corner(d);
      const Point<F> v = corner(d + 1);
      const Point<F> w = corner(d + 2);
      const F uv = norm(difference(u, v));
      const F vw = norm(difference(v, w));
      const F wu = norm(difference(w, u));
      const F x = uv * gap(w);
      const F y = vw * gap(u);
      const F z = wu * gap(v);
      const F sum = x + y + z;
      const F k = sum * sum - F(2) * (x * x + y * y + z * z);  // 2(xy + yz + zx) − x² − y² − z²
      if (sign(k) <= 0) return false;
      return in_collar_[d / 3] || compare(F(F(4) * uv * vw * wu), k, epsilon) < 0;
    });
    const auto long_enough = [&](Index d) {
      const Point<F> u = corner(d);
      const Point<F> v = corner(next(d));
      return compare(norm(difference(u, v)), F(gap(u) * gap(v)), half) > 0;
    };
    each_edge("packing", [&](Index d) {
      const Index u = vertex(d);
      const Index v = vertex(next(d));
      return u == v || (partner_[u] == static_cast<long>(v)) || long_enough(d);
    });
    if (!net_.collars) return;
    each_edge("thick",
              [&](Index d) { return vertex(d) != vertex(next(d)) || partner_[vertex(d)] >= 0 || long_enough(d); });
  }

 private:
  [[nodiscard]] Index vertex(Index d) const { return net_.triangles[d / 3].vertex[d % 3]; }
  [[nodiscard]] Index across(Index d) const { return net_.triangles[d / 3].opposite[d % 3]; }
  [[nodiscard]] static Index next(Index d) { return d / 3 * 3 + (d + 1) % 3; }
  [[nodiscard]] static Index before(Index d) { return d / 3 * 3 + (d + 2) % 3; }

  template <class Holds>
  void each_dart(const char* rule, const Holds& holds) const {
    for (Index d = 0; d < 3 * net_.triangles.size(); ++d) {
      if (!holds(d)) throw Broken{rule};
    }
  }

  /// Checks one of the two darts of every edge, as the condition is the same for both.
  template <class Holds>
  void each_edge(const char* rule, const Holds& holds) const {
    each_dart(rule, [&](Index d) { return d > across(d) || holds(d); });
  }

  void map() {
    const auto darts = static_cast<Index>(3 * net_.triangles.size());
    if (darts == 0) throw Broken{"map"};
    each_dart("map", [&](Index d) {
      const Index e = across(d);
      return e != d && across(e) == d && vertex(e) == vertex(next(d)) && vertex(next(e)) == vertex(d);
    });
    std::vector<int> cycles(net_.vertices.size());
    std::vector<bool> turned(darts);
    for (Index first = 0; first < darts; ++first) {
      if (!turned[first]) ++cycles[vertex(first)];
      for (Index d = first; !turned[d]; d = across(before(d))) turned[d] = true;
    }
    std::vector<bool> reached(net_.triangles.size());
    std::vector<Index> open{0};
    reached[0] = true;
    for (std::size_t i = 0; i < open.size(); ++i) {
      for (Index k = 0; k < 3; ++k) {
        const Index t = across(3 * open[i] + k) / 3;
        if (!reached[t]) open.push_back(t);
        reached[t] = true;
      }
    }
    const long euler = static_cast<long>(net_.vertices.size()) - static_cast<long>(darts / 2) +
                       static_cast<long>(net_.triangles.size());
    const bool one_cycle = std::all_of(cycles.begin(), cycles.end(), [](int n) { return n == 1; });
    if (!one_cycle || open.size() != net_.triangles.size() || darts % 2 != 0 || euler != tiling_.euler)
      throw Broken{"map"};
    in_collar_.assign(net_.triangles.size(), false);
    partner_.assign(net_.vertices.size(), -1);
  }

  [[nodiscard]] Isometry<F> frame(Index chart) const { return inverse(to_origin(point<F>(net_.charts[chart].centre))); }
  [[nodiscard]] Isometry<F> value(const std::vector<Index>& word) const {
    Isometry<F> g;
    for (const Index s : word) g = tiling_.crossing[s] * g;
    return g;
  }
  void evaluate_labels() {
    labels_.assign(1, {});
    for (const NetFile::Label& l : net_.labels) {
      labels_.push_back(inverse(frame(l.to)) * (value(l.word) * frame(l.from)));
    }
    corners_.clear();
    for (Index d = 0; d < 3 * net_.triangles.size(); ++d) {
      Point<F> z = label(d)(point<F>(net_.vertices[vertex(d)].z));
      reduce(z.n, z.d);
      corners_.push_back(std::move(z));
    }
  }
  /// Returns the label of the corner where the dart starts: it leads to the chart of the triangle.
  [[nodiscard]] const Isometry<F>& label(Index d) const { return labels_[net_.triangles[d / 3].label[d % 3]]; }
  [[nodiscard]] const Point<F>& corner(Index d) const { return corners_[d]; }
  /// Returns the isometry from the chart of the triangle across a dart to the chart of the dart's triangle.
  [[nodiscard]] Isometry<F> step(Index d) const { return label(d) * inverse(label(next(across(d)))); }

  void collars() {
    const auto expect = [](bool holds) {
      if (!holds) throw Broken{"collars"};
    };
    // ε <= ln √2 if sinh²ε <= 1/8.
    expect(compare(mpz_class(1), mpz_class(8), SinhSquare(net_.epsilon)) > 0);
    for (const NetFile::Collar& c : *net_.collars) {
      for (std::size_t i = 0; i < 2; ++i) {
        expect(!in_collar_[c.triangles[i]] && partner_[c.vertices[i]] < 0);
        in_collar_[c.triangles[i]] = true;
        partner_[c.vertices[i]] = static_cast<long>(c.vertices[1 - i]);
      }
    }
    for (const NetFile::Collar& c : *net_.collars) {
      expect(c.vertices[0] != c.vertices[1]);
      // The darts p → p of t and q → q of u.
      std::array<Index, 2> loop{};
      for (std::size_t i = 0; i < 2; ++i) {
        Index found = ~Index{0};
        for (Index d = 3 * c.triangles[i]; d < 3 * c.triangles[i] + 3; ++d) {
          if (vertex(d) == c.vertices[i] && vertex(next(d)) == c.vertices[i] && vertex(before(d)) == c.vertices[1 - i])
            found = d;
        }
        expect(found != ~Index{0});
        loop[i] = found;
      }
      expect(across(next(loop[0])) == next(loop[1]) && across(before(loop[0])) == before(loop[1]));
      measure(c, loop[0]);
    }
  }

  void measure(const NetFile::Collar& collar, Index loop) const {
    const auto expect = [](bool holds) {
      if (!holds) throw Broken{"collars"};
    };
    const Isometry<F> start = label(loop);
    const Isometry<F> end = label(next(loop));
    const Isometry<F> to_tile = frame(net_.vertices[vertex(loop)].chart);
    const Isometry<F> core = inverse(to_tile) * (value(collar.core) * to_tile);
    const Isometry<F> lambda = inverse(start) * end;
    expect(same(lambda, core) || same(lambda, inverse(core)));
    const Isometry<F> g = end * inverse(start);
    const F det = determinant(g);
    const F sigma = norm(g.b) - g.a.im * g.a.im;
    expect(sign(sigma) > 0);
    const SinhSquare half(net_.epsilon / 2);
    expect(collar.length[0] == 0 || compare(sigma, det, SinhSquare(collar.length[0] / 2)) > 0);
    expect(collar.length[1] != 0 && compare(sigma, det, SinhSquare(collar.length[1] / 2)) < 0);
    expect(compare(sigma, det, half) < 0);
    const Point<F> p = corner(loop);
    const Point<F> q = corner(before(loop));
    const int sides = sign(side_of_axis(g, p)) * sign(side_of_axis(g, q));
    if (sides == 0) throw Unknown{"a vertex on the core"};
    expect(sides < 0);
    for (const Point<F>& z : {p, q}) {
      const F s = side_of_axis(g, z);
      const F below = gap(z);
      // σ + s², over det.
      expect(compare(F(sigma * below * below + s * s), F(det * below * below), half) > 0);
      const double root_sigma = std::sqrt(ratio(sigma, det));
      const double l = 2 * std::asinh(root_sigma);
      const double height = std::asinh(std::sqrt(ratio(F(s * s), F(sigma * below * below))));
      const double e = net_.epsilon.get_d();
      const double e_half = std::sinh(e / 2);
      const double thin = std::asinh(std::sqrt((e_half / root_sigma - 1) * (e_half / root_sigma + 1)));
      const double reach = 2 * std::asinh(std::sinh(l / 4) * std::cosh(height)) + (height - thin);
      if (!(std::fabs(reach - e) > 1e-10)) throw Unknown{"(g) of a collar"};
      expect(reach < e);
    }
  }

  const NetFile& net_;
  const Tiling<F>& tiling_;
  std::vector<Isometry<F>> labels_;
  std::vector<Point<F>> corners_;
  std::vector<bool> in_collar_;
  std::vector<long> partner_;
};

}  // namespace epsnet::attack
