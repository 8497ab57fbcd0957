#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/conjugation.h"
#include "certify/exact/document.h"
#include "certify/exact/geodesic_rules.h"
#include "certify/exact/net_rules.h"
#include "certify/exact/pair_search.h"

/// Section 20 of docs/proof.md: two surfaces that are isometric, or not.
namespace epsnet::exact {

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
