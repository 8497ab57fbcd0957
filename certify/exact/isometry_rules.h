#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/algebraic.h"
#include "certify/exact/claim_rules.h"
#include "certify/exact/document.h"
#include "certify/exact/geodesic_rules.h"
#include "certify/exact/net_rules.h"
#include "certify/exact/pair_search.h"
#include "certify/exact/plane.h"

/// Isometries of a surface, and from one surface to another (docs/proof.md, sections 18 and 20).
namespace epsnet::exact {

// Elements of groups, of which traces say whether isometries take them to each other (Lemmas 38, 39).

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

// Two surfaces that are isometric, or not.

/// Asks rules in their order, and throws Refutation or TooLarge unless they are verified.
using AskRules = std::function<void(const std::vector<Rule>&)>;

/// Whether one of two surfaces certainly has more closed geodesics up to some length than the other one. O(n log n).
[[nodiscard]] bool counts_differ(const GeodesicsDocument& first, const GeodesicsDocument& other);

template <class R, class Q>
std::string different_genera(const NetRules<R>& net, const NetRules<Q>& other) {
  if (net.euler() == other.euler()) return "";
  const auto genus = [](std::int64_t euler) { return std::to_string(1 - euler / 2); };
  return "the genera are " + genus(net.euler()) + " and " + genus(other.euler());
}

/// Rule `different`, after those of both spectra.
template <class R, class Q>
void check_different(const ComparisonDocument& document, NetRules<R>& net, GeodesicRules<R>& spectrum,
                     NetRules<Q>& other, GeodesicRules<Q>& other_spectrum) {
  if (!different_genera(net, other).empty() || counts_differ(document.first, document.other)) return;
  const std::string why = "the two lists may be of surfaces that are isometric";
  if (document.first.up_to != document.other.up_to) throw TooLarge{why};
  PairSearch<R> from(net, spectrum.loops());
  PairSearch<Q> to(other, other_spectrum.loops());
  if (possible_isometries(net, from, net.paths(), to, 0) != 0) throw TooLarge{why};
}

/// The rules of the two surfaces after those of the first net.
template <class R, class Q>
std::vector<Rule> different_rules(const ComparisonDocument& document, NetRules<R>& net, NetRules<Q>& other,
                                  const AskRules& ask, long most_lifts) {
  const auto spectrum = std::make_shared<GeodesicRules<R>>(document.first, net, most_lifts);
  const auto other_spectrum = std::make_shared<GeodesicRules<Q>>(document.other, other, most_lifts);
  std::vector<Rule> rules = spectrum->rules();
  rules.push_back({"other", [&other, &ask, other_spectrum] { ask(joined(other, other_spectrum->rules())); }});
  rules.push_back({"different", [&document, &net, spectrum, &other, other_spectrum] {
                     check_different(document, net, *spectrum, other, *other_spectrum);
                   }});
  return rules;
}

/// Likewise.
template <class R, class Q>
std::vector<Rule> isometric_rules(const ComparisonDocument& document, NetRules<R>& net, NetRules<Q>& other,
                                  const AskRules& ask) {
  net.expect_paths(document.paths);
  net.expect_loops(document.pair, 2, "pair");
  other.expect_loops(document.images, 2 + net.sides() / 2, "images");
  std::vector<Rule> rules;
  rules.push_back({"other", [&] { ask(other.rules()); }});
  rules.push_back({"isometric", [&] {
                     if (const std::string why = different_genera(net, other); !why.empty()) throw Refutation{why};
                     std::vector<std::vector<Index>> words = document.pair;
                     for (auto& word : net.generators(document.paths)) words.push_back(std::move(word));
                     const Traces from = traces_of(net, words);
                     if (from.crossing_sign == 0) throw Refutation{"the axes of the pair do not cross"};
                     const Traces to = traces_of(other, document.images);
                     expect_conjugate(from, to);
                     if ((from.crossing_sign == to.crossing_sign) != document.preserves_orientation)
                       throw Refutation{"the orientation is not that of the file"};
                   }});
  return rules;
}

}  // namespace epsnet::exact
