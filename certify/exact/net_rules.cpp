#include "certify/exact/net_rules.h"

#include <array>
#include <set>
#include <string>
#include <type_traits>

#include "certify/exact/interval.h"

namespace epsnet::exact {
namespace {

/// Bits of one number that is brought to lowest terms, and of all of them, with some more for each triangle: half a
/// minute, also of bits that are counted as often as the degree of their field says.
constexpr std::size_t kMaxBits = std::size_t{1} << 22;
template <class R>
constexpr std::size_t kMaxBitsInAll = std::size_t{1} << (std::is_same_v<R, mpz_class> ? 26 : 31);
constexpr std::size_t kBitsOfATriangle = std::size_t{1} << 13;

}  // namespace

template <class R>
NetRules<R>::NetRules(const Net& net)
    : NetStructure(net),
      bits_left_(kMaxBitsInAll<R> + kBitsOfATriangle * net.triangles.size()),
      in_collar_(net.triangles.size()) {}

template <class R>
std::vector<Rule> NetRules<R>::rules() {
  std::vector<Rule> rules{{"surface", [this] { check_surface(); }},
                          {"map", [this] { check_map(euler_); }},
                          {"gluing", [this] { check_gluing(); }}};
  if (net().collars) rules.push_back({"collars", [this] { check_collars(); }});
  rules.push_back({"orientation", [this] { check_orientation(); }});
  rules.push_back({"delaunay", [this] { check_delaunay(); }});
  rules.push_back({"covering", [this] { check_covering(); }});
  rules.push_back({"packing", [this] { check_packing(); }});
  if (net().collars) rules.push_back({"thick", [this] { check_thick(); }});
  return rules;
}

template <class R>
void NetRules<R>::spend(std::size_t bits) {
  if (bits > kMaxBits || bits > bits_left_) throw TooLarge{"its exact numbers are too large"};
  bits_left_ -= bits;
}

template <class R>
Point<R> NetRules<R>::image(const Isometry<R>& f, const Point<R>& z) {
  spend(bits(f) + bits(z));
  const Complex<R> n = f.a * z.n + z.m * f.b;
  const Complex<R> d = conjugate(f.b) * z.n + z.m * conjugate(f.a);
  return lowest_terms(n * conjugate(d), norm(d));
}

template <class R>
Isometry<R> NetRules<R>::product(std::span<const Isometry<R>* const> path) {
  if (path.empty()) return {};
  if (path.size() == 1) return *path[0];
  const Isometry<R> first = product(path.first(path.size() / 2));
  Isometry<R> result = compose(product(path.subspan(path.size() / 2)), first);
  spend(bits(result));
  reduce(result);
  return result;
}

template <class R>
Isometry<R> NetRules<R>::product(const Isometry<R>& g, const Isometry<R>& f) {
  const std::array<const Isometry<R>*, 2> path{&f, &g};
  return product(path);
}

template <class R>
Isometry<R> NetRules<R>::value(const Isometry<R>& first, const std::vector<Index>& word) {
  std::vector<const Isometry<R>*> path{&first};
  for (const Index side : word) path.push_back(&crossings()[side]);
  return product(path);
}

template <class R>
const std::vector<Isometry<R>>& NetRules<R>::crossings() {
  return crossings_;
}

template <class R>
void NetRules<R>::check_surface() {
  expect_connected_tiles();  // (d)
  const std::size_t cycles = check_tiles();
  const auto euler = static_cast<std::int64_t>(cycles + net().tile_count()) - static_cast<std::int64_t>(sides() / 2);
  // Implied by the angles around the corners, with Gauss–Bonnet (docs/proof.md, section 12).
  if (euler >= 0 || euler % 2 != 0) throw Refutation{"the Euler characteristic is " + std::to_string(euler)};
  euler_ = euler;
}

template <class R>
const Isometry<R>& NetRules<R>::label(Index number_of_label) {
  const auto found = labels_.find(number_of_label);
  if (found != labels_.end()) return found->second;
  if (number_of_label == 0) return labels_[0];
  const Label& l = net().labels[number_of_label - 1];
  return labels_.emplace(number_of_label, product(inverse(frame(l.to)), value(l.from, l.word))).first->second;
}

template <class R>
void NetRules<R>::check_gluing() {
  std::set<std::array<Index, 4>> known;
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index other = opposite(dart);
    if (other < dart) continue;
    const std::array<Index, 4> equation{label_number(dart), label_number(next(other)), label_number(next(dart)),
                                        label_number(other)};
    const auto& [a, b, c, d] = equation;
    if ((a == c && b == d) || (a == b && c == d) || !known.insert(equation).second) continue;
    // Labels are multiplied once for each equation, however large they are.
    for (const Index number_of_label : equation) spend(bits(label(number_of_label)));
    const Isometry<R> left = compose(label(a), inverse(label(b)));
    const Isometry<R> right = compose(label(c), inverse(label(d)));
    if (!are_equal(left, right)) throw Refutation{edge_name(dart) + ": the labels differ"};
  }
}

template <class R>
Point<R> NetRules<R>::corner(Index dart) {
  const Point<R> z = point<R>(net().vertices[start(dart)].z);
  return label_number(dart) == 0 ? z : image(label(label_number(dart)), z);
}

template <class R>
const Isometry<RoughInterval>& NetRules<R>::rough_label(Index number_of_label) {
  const auto found = rough_labels_.find(number_of_label);
  if (found != rough_labels_.end()) return found->second;
  if (number_of_label == 0) return rough_labels_[0];
  return rough_labels_.emplace(number_of_label, rough(label(number_of_label))).first->second;
}

template <class R>
Point<RoughInterval> NetRules<R>::rough_corner(Index dart) {
  const Point<RoughInterval> z = rough(net().vertices[start(dart)].z);
  return label_number(dart) == 0 ? z : exact::image(rough_label(label_number(dart)), z);
}

template <class R>
void NetRules<R>::check_orientation() {
  for (Index t = 0; t < net().triangles.size(); ++t) {
    if (certain_sign(area(rough_corner(3 * t), rough_corner(3 * t + 1), rough_corner(3 * t + 2))) > 0) continue;
    if (sgn(area(corner(3 * t), corner(3 * t + 1), corner(3 * t + 2))) <= 0) {
      throw Refutation{triangle_name(t) + " is not strictly counterclockwise"};
    }
  }
}

template <class R>
Point<R> NetRules<R>::far_corner(Index dart) {
  const Index other = opposite(dart);
  const Index far = previous(other);
  const Index here = label_number(dart);
  const Index there = label_number(next(other));
  if (here == there) return corner(far);
  const Isometry<R> step = product(label(here), inverse(label(there)));
  return image(product(step, label(label_number(far))), point<R>(net().vertices[start(far)].z));
}

template <class R>
Point<RoughInterval> NetRules<R>::rough_far_corner(Index dart) {
  const Index other = opposite(dart);
  const Point<RoughInterval> far = rough_corner(previous(other));
  const Index here = label_number(dart);
  const Index there = label_number(next(other));
  if (here == there) return far;
  return exact::image(compose(rough_label(here), inverse(rough_label(there))), far);
}

namespace {

/// Lemma 3.1: the determinant with the rows (x, y, |z|², 1) of the ends p and q of an edge, the third corner r of the
/// triangle and the far corner; the last one is taken for the origin. Not positive if the edge is Delaunay.
template <class R>
R delaunay_determinant(const Point<R>& p, const Point<R>& q, const Point<R>& r, const Point<R>& far) {
  struct Row {
    Complex<R> z;
    R square;
  };
  // The row of z times (z.m far.m)², but x and y without one factor far.m, which they have in all rows.
  const auto row = [&](const Point<R>& z) {
    const Complex<R> difference = far.m * z.n - z.m * far.n;
    return Row{z.m * difference, norm(difference)};
  };
  const auto minor = [](const Row& u, const Row& v) { return R(u.z.re * v.z.im - u.z.im * v.z.re); };
  const Row u = row(p);
  const Row v = row(q);
  const Row w = row(r);
  return minor(u, v) * w.square + minor(v, w) * u.square + minor(w, u) * v.square;
}

/// Of a triangle: (∗∗), 4 d₀ d₁ d₂/discriminant is sinh² of the circumradius if the discriminant is positive, and if
/// not there is no circumcircle.
template <class R>
struct CircumradiusQuotient {
  R numerator;
  R discriminant;

  explicit CircumradiusQuotient(const std::array<Point<R>, 3>& z) {
    const std::array<R, 3> d{squared_difference(z[0], z[1]), squared_difference(z[1], z[2]),
                             squared_difference(z[2], z[0])};
    const R x = d[0] * gap(z[2]);
    const R y = d[1] * gap(z[0]);
    const R w = d[2] * gap(z[1]);
    const R sum = x + y - w;
    discriminant = 4 * x * y - sum * sum;
    numerator = 4 * d[0] * d[1] * d[2];
  }
};

}  // namespace

template <class R>
void NetRules<R>::check_delaunay() {
  for (Index dart = 0; dart < darts(); ++dart) {
    if (opposite(dart) < dart) continue;
    if (certain_sign(delaunay_determinant(rough_corner(dart), rough_corner(next(dart)), rough_corner(previous(dart)),
                                          rough_far_corner(dart))) < 0) {
      continue;
    }
    if (sgn(delaunay_determinant(corner(dart), corner(next(dart)), corner(previous(dart)), far_corner(dart))) > 0) {
      throw Refutation{edge_name(dart) + " is not Delaunay"};
    }
  }
}

template <class R>
bool NetRules<R>::has_circumcircle(Index t) {
  return sgn(CircumradiusQuotient<R>({corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)}).discriminant) > 0;
}

template <class R>
Answer NetRules<R>::circumradius_is_less(Index t, const SquaredSinh& s) {
  const CircumradiusQuotient<RoughInterval> rough_quotient(
      {rough_corner(3 * t), rough_corner(3 * t + 1), rough_corner(3 * t + 2)});
  const Answer answer = is_less(rough_quotient.numerator, rough_quotient.discriminant, rough(s));
  if (answer != Answer::unknown) return answer;
  const CircumradiusQuotient<R> quotient({corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)});
  return is_less(quotient.numerator, quotient.discriminant, s);
}

template <class R>
Answer NetRules<R>::half_edge_is_less(Index dart, const SquaredSinh& s) {
  const Point<RoughInterval> rough_p = rough_corner(dart);
  const Point<RoughInterval> rough_q = rough_corner(next(dart));
  const Answer answer = is_less(squared_difference(rough_p, rough_q), gap(rough_p) * gap(rough_q), rough(s));
  if (answer != Answer::unknown) return answer;
  const Point<R> p = corner(dart);
  const Point<R> q = corner(next(dart));
  return is_less(squared_difference(p, q), R(gap(p) * gap(q)), s);
}

template <class R>
void NetRules<R>::check_covering() {
  const SquaredSinh s = squared_sinh(net().epsilon);
  for (Index t = 0; t < net().triangles.size(); ++t) {
    if (in_collar_[t]) {
      if (!has_circumcircle(t)) throw Refutation{triangle_name(t) + " has no circumcircle"};
      continue;
    }
    const Answer less = circumradius_is_less(t, s);
    if (less == Answer::no) throw Refutation{triangle_name(t) + " has a circumradius greater than epsilon"};
    if (less == Answer::unknown) throw TooLarge{triangle_name(t) + " has a circumradius that is nearly epsilon"};
  }
}

template <class R>
bool NetRules<R>::are_partners(Index u, Index v) const {
  const auto found = partners_.find(u);
  return found != partners_.end() && found->second == v;
}

template <class R>
void NetRules<R>::expect_long(Index dart, const SquaredSinh& s) {
  const Answer less = half_edge_is_less(dart, s);
  if (less == Answer::yes) throw Refutation{edge_name(dart) + " is shorter than epsilon"};
  if (less == Answer::unknown) throw TooLarge{edge_name(dart) + " is nearly epsilon long"};
}

template <class R>
void NetRules<R>::check_packing() {
  const SquaredSinh s = squared_sinh(net().epsilon / 2);
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index p = start(dart);
    const Index q = start(next(dart));
    if (dart < opposite(dart) && p != q && !are_partners(p, q)) expect_long(dart, s);
  }
}

template <class R>
void NetRules<R>::check_thick() {
  const SquaredSinh s = squared_sinh(net().epsilon / 2);
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index p = start(dart);
    if (dart < opposite(dart) && p == start(next(dart)) && !partners_.contains(p)) expect_long(dart, s);
  }
}

template class NetRules<mpz_class>;
template class NetRules<Algebraic>;
template class NetRules<FieldNumber>;

// Section 10: the rule `collars` of pseudo nets.

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
