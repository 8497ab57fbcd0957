#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/integers.h"
#include "certify/exact/net_rules.h"
#include "certify/exact/plane.h"

/// Elements of groups, of which traces say whether isometries take them to each other (docs/proof.md, Lemmas 38, 39).
namespace epsnet::exact {

/// The value of a word, with a trace that is not negative.
template <class R>
Isometry<R> positive_element(NetRules<R>& net, const std::vector<Index>& word) {
  Isometry<R> g = net.value(word);
  return sgn(g.a.re) < 0 ? Isometry<R>{-g.a, -g.b} : g;
}

/// 1, x, y, xy for two words: a basis of the matrices if the axes of x and y have no end in common.
template <class R>
std::array<Isometry<R>, 4> basis_of_matrices(NetRules<R>& net, const std::vector<Index>& x_word,
                                             const std::vector<Index>& y_word) {
  const Isometry<R> x = positive_element(net, x_word);
  const Isometry<R> y = positive_element(net, y_word);
  return {Isometry<R>(), x, y, net.product(x, y)};
}

/// Lemma 39: 0 if the axes do not cross, else the sign of Im p, p = 2i Im(b b̄′) of xy − yx.
template <class R>
int crossing_sign(const Isometry<R>& x, const Isometry<R>& y) {
  const R p = (x.b * conjugate(y.b)).im;
  const Complex<R> q = x.a.im * y.b - y.a.im * x.b;
  return sgn(R(p * p - norm(q))) > 0 ? sgn(p) : 0;
}

/// Whether the traces are equal up to their signs, and the product of these.
template <class R>
std::pair<bool, int> compare_traces(const Isometry<R>& f, const Isometry<R>& g) {
  const R difference = f.a.re * f.a.re * (norm(g.a) - norm(g.b)) - g.a.re * g.a.re * (norm(f.a) - norm(f.b));
  return {sgn(difference) == 0, sgn(f.a.re) * sgn(g.a.re)};
}

/// Lemma 38, for one sign of the image.
template <class R>
bool has_traces_of(NetRules<R>& net, const Isometry<R>& g, const std::array<Isometry<R>, 4>& from,
                   const Isometry<R>& image, const std::array<Isometry<R>, 4>& to) {
  int sign = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [equal, product] = compare_traces(net.product(from.at(k), g), net.product(to.at(k), image));
    if (!equal || sign * product < 0) return false;
    if (product != 0) sign = product;
  }
  return true;
}

/// The rule `isometries`. Throws Refutation.
template <class R>
void expect_isometries(NetRules<R>& net, const IsometryRows& rows) {
  const auto from = basis_of_matrices(net, rows.pair[0], rows.pair[1]);
  const int sign = crossing_sign(from[1], from[2]);
  if (sign == 0) throw Refutation{"the axes of the pair do not cross"};
  std::vector<Isometry<R>> elements;
  for (const auto& word : net.generators(rows.paths)) elements.push_back(positive_element(net, word));
  for (std::size_t i = 0; i < rows.isometries.size(); ++i) {
    const auto& [preserves_orientation, images] = rows.isometries[i];
    const std::string name = "isometry " + number(i);
    const auto to = basis_of_matrices(net, images[0], images[1]);
    for (std::size_t k = 1; k < 4; ++k) {
      if (compare_traces(from.at(k), to.at(k)) != std::pair(true, 1)) throw Refutation{name + " changes traces"};
    }
    for (std::size_t n = 0; n < elements.size(); ++n) {
      if (!has_traces_of(net, elements[n], from, positive_element(net, images[n + 2]), to))
        throw Refutation{name + " changes traces of generator " + number(n)};
    }
    if ((crossing_sign(to[1], to[2]) == sign) != preserves_orientation)
      throw Refutation{name + (preserves_orientation ? " reverses the orientation" : " preserves the orientation")};
  }
}

/// Half of the trace of a matrix, its square, and the determinant.
struct Trace {
  RealNumber square;
  RealNumber determinant;
  int sign;
};

/// What Lemma 38 asks of two elements x, y and of others.
struct Traces {
  int crossing_sign;
  std::vector<Trace> traces;  ///< Of x, y, xy; and of g, xg, yg, xyg for each other element g.
};

/// Of words, x and y first.
template <class R>
Traces traces_of(NetRules<R>& net, const std::vector<std::vector<Index>>& words) {
  const auto basis = basis_of_matrices(net, words.at(0), words.at(1));
  Traces result{crossing_sign(basis[1], basis[2]), {}};
  const auto add = [&](const Isometry<R>& g) {
    result.traces.push_back({real_number(R(g.a.re * g.a.re)), real_number(R(norm(g.a) - norm(g.b))), sgn(g.a.re)});
  };
  for (std::size_t i = 1; i < 4; ++i) add(basis.at(i));
  for (std::size_t n = 2; n < words.size(); ++n) {
    const Isometry<R> g = positive_element(net, words[n]);
    for (const Isometry<R>& f : basis) add(net.product(f, g));
  }
  return result;
}

/// Lemma 38 for elements of two surfaces, whose numbers may be of different fields (Lemma 45). Throws Refutation if no
/// isometry of the plane takes the first ones to the others, and TooLarge.
void expect_conjugate(const Traces& from, const Traces& to);

}  // namespace epsnet::exact
