#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "certify/exact/document.h"
#include "certify/exact/interval.h"
#include "certify/exact/net_rules.h"

/// The rules of claims about a net, to be asked after those of the net, which are verified then. Each
/// function throws Malformed if the structure of the document is broken; the net's rules and the document must live as
/// long as what it returns. A list of geodesics may ask for `most_lifts` lifted vertices,
/// eigenfunctions for `most_values` values, and matrices for 2000 times as many multiplications.
namespace epsnet::exact {

/// Section 11.1 of docs/proof.md: a list of geodesics.
template <class R>
[[nodiscard]] std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<R>& net, long most_lifts);
/// Section 14.
template <class R>
[[nodiscard]] std::vector<Rule> distance_rules(const DistanceDocument& document, NetRules<R>& net);
/// Section 15.
template <class R>
[[nodiscard]] std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<R>& net, long most_work);
/// Lemma 20 there: whether three points lie in a disk of radius R, by sinh²(d/2) of the distances between them and
/// sinh²R.
template <class Number>
[[nodiscard]] Answer fits_in_disk(const Number& a, const Number& b, const Number& c, const Number& most);
/// Lemma 25 there, for a triangulation with one vertex at a point: whether it is Delaunay, all edges certainly locally
/// so, and has a circumradius R with sinh²R >= `least`. By what is across each dart, and sinh²(d/2) of each.
template <class Number>
[[nodiscard]] Answer is_delaunay_and_wide(const std::vector<Index>& opposite, const std::vector<Number>& h,
                                          const Number& least);
/// Section 17.
template <class R>
[[nodiscard]] std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<R>& net,
                                                 long most_values);
/// Section 18.
template <class R>
[[nodiscard]] std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<R>& net, long most_lifts);
/// Section 19.
template <class R>
[[nodiscard]] std::vector<Rule> pants_rules(const PantsDocument& document, NetRules<R>& net);

/// Section 21.
template <class R>
[[nodiscard]] std::vector<Rule> curve_rules(const CurvesDocument& document, NetRules<R>& net);

/// The rules of a net, then some of its own.
template <class R>
std::vector<Rule> joined(NetRules<R>& net, std::vector<Rule> own_rules) {
  std::vector<Rule> rules = net.rules();
  for (Rule& rule : own_rules) rules.push_back(std::move(rule));
  return rules;
}

/// Rules that keep their owner alive.
template <class Owner>
std::vector<Rule> kept(const std::shared_ptr<Owner>& owner, std::vector<Rule> rules) {
  for (Rule& rule : rules) rule.ask = [owner, ask = std::move(rule.ask)] { ask(); };
  return rules;
}

/// Section 17.1 of docs/proof.md: the rule `enclosures`. Throws Refutation. Intervals of eigenfunctions are disjoint
/// and in order. In a box roots of eigenvalues are at most that far from those in its centre.
void check_enclosures(const EigenvaluesDocument& document, const std::optional<Interval>& distance = {});

}  // namespace epsnet::exact
