#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/conjugation.h"
#include "certify/exact/geodesic_rules.h"
#include "certify/exact/pair_search.h"

/// Section 18: isometries, and by section 18.1 that there are no others.
namespace epsnet::exact {
namespace {

using Word = IsometryRows::Word;

/// Letters that are read for the orbit of the cocycle: some seconds.
constexpr std::size_t kMostLetters = 100'000'000;

template <class R>
class IsometryRules {
 public:
  IsometryRules(const IsometriesDocument& document, NetRules<R>& net, long most_lifts)
      : document_(document), net_(net), spectrum_(document.spectrum, net, most_lifts) {
    check_structure();
  }

  [[nodiscard]] std::vector<Rule> rules() {
    std::vector<Rule> rules = spectrum_.rules();
    rules.push_back({"isometries", [this] { expect_isometries(net_, document_.rows); }});
    rules.push_back({"least", [this] { check_least(); }, true});
    rules.push_back({"most", [this] { check_most(); }});
    return rules;
  }

 private:
  using Values = std::vector<std::uint32_t>;  ///< By pair of sides; modulo 2³².

  void check_structure() const {
    if (document_.order == 0) throw Malformed("the order is 0");
    net_.expect_words(document_.rows);
    if (document_.cocycle.size() != net_.sides() / 2) throw Malformed("cocycle: another number of values");
    const Values c = by_side(document_.cocycle);
    for (Index first = 0; first < net_.sides(); ++first) {
      std::uint32_t sum = 0;
      Index s = first;
      do {
        sum += c[s];
        s = net_.side_after(net_.partner(s));
      } while (s != first);
      if (sum != 0) throw Malformed("cocycle: the sum around a vertex is not 0");
    }
  }

  /// c(s), with c(s′) = −c(s) for the partner s′ of s.
  [[nodiscard]] Values by_side(const Values& values) const {
    Values result(net_.sides());
    std::size_t next = 0;
    for (Index s = 0; s < result.size(); ++s)
      result[s] = s < net_.partner(s) ? values[next++] : 0 - result[net_.partner(s)];
    return result;
  }

  // Rule `least`.

  void check_least() const {
    std::size_t letters = 1;
    for (const auto& row : document_.rows.isometries) {
      for (const Word& word : row.images) letters += word.size() + 1;
    }
    const auto sum = [](const Values& c, const Word& word) {
      return std::accumulate(word.begin(), word.end(), std::uint32_t{0}, [&](auto n, Index s) { return n + c[s]; });
    };
    Values first;
    const Values given = by_side(document_.cocycle);
    for (const Word& word : net_.generators(document_.rows.paths)) first.push_back(sum(given, word));
    std::set<Values> orbit{first};
    std::vector<Values> reached{first};
    for (std::size_t i = 0; i < reached.size() && orbit.size() <= document_.order; ++i) {
      if (i * letters > kMostLetters) give_up("the group is too large for this checker");
      const Values c = by_side(reached[i]);
      for (const auto& row : document_.rows.isometries) {
        Values moved;
        std::for_each(row.images.begin() + 2, row.images.end(), [&](const Word& w) { moved.push_back(sum(c, w)); });
        if (orbit.insert(moved).second) reached.push_back(std::move(moved));
      }
    }
    if (orbit.size() > document_.order) throw Refutation{"they generate more than " + number(document_.order)};
    if (orbit.size() < document_.order) give_up("they generate at least " + number(orbit.size()));
  }

  // Rule `most`.

  void check_most() {
    PairSearch<R> search(net_, spectrum_.loops());
    const std::size_t most = possible_isometries(net_, search, document_.rows.paths, search, document_.order);
    const std::string found = "there are at most " + number(most);
    if (most > document_.order) give_up(found);
    if (most < document_.order) throw Refutation{found};
  }

  const IsometriesDocument& document_;
  NetRules<R>& net_;
  GeodesicRules<R> spectrum_;
};

}  // namespace

template <class R>
std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<R>& net, long most_lifts) {
  const auto rules = std::make_shared<IsometryRules<R>>(document, net, most_lifts);
  return kept(rules, rules->rules());
}

template std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<mpz_class>& net, long);
template std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<Algebraic>& net, long);
template std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<FieldNumber>& net, long);

}  // namespace epsnet::exact
