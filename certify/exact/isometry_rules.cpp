#include "certify/exact/isometry_rules.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/geodesic_rules.h"
#include "certify/exact/pair_search.h"

/// Isometries of a surface, and from one surface to another.
namespace epsnet::exact {

// Section 18: isometries, and by section 18.1 that there are no others.

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
    std::vector<bool> seen(net_.sides());
    for (Index first = 0; first < net_.sides(); ++first) {
      std::uint32_t sum = 0;
      for (Index s = first; !seen[s]; s = net_.side_after(net_.partner(s))) {
        seen[s] = true;
        sum += c[s];
      }
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

// Section 20: two surfaces that are isometric, or not.

namespace {

/// Numbers of two fields are compared with so many bits at most, and with so many in all: some seconds.
constexpr std::size_t kMostBitsOfAComparison = std::size_t{1} << 18;
constexpr std::size_t kMostBitsOfAll = std::size_t{1} << 33;

/// Lemma 45, for numbers that take no more than so many bits in all.
class Comparison {
 public:
  /// Whether xy = x′y′, x and x′ of one field, y and y′ of another. Throws TooLarge.
  bool agree(const RealNumber& x, const RealNumber& y, const RealNumber& other_x, const RealNumber& other_y) {
    const std::size_t bits = std::max(x.bits + y.bits, other_x.bits + other_y.bits) + 1;
    const std::size_t degree = degree_of_both(x, y, other_x, other_y);
    if (bits > kMostBitsOfAComparison / degree) throw TooLarge{"the numbers are too large to be compared exactly"};
    for (std::size_t k = 2 * bits + 64;; k *= 2) {
      const std::size_t cost = k * (work_of(x) + work_of(y) + work_of(other_x) + work_of(other_y));
      if (cost > bits_left_) throw TooLarge{"the numbers take too much work to be compared exactly"};
      bits_left_ -= cost;
      const Approximation p = product(x.approximation(k), y.approximation(k));
      const Approximation q = product(other_x.approximation(k), other_y.approximation(k));
      const mpz_class size = abs(p.value - q.value);
      const mpz_class error = p.error + q.error;
      if (size > error) return false;
      // A number that is not 0 is at least 2^(−bits (degree − 1)).
      if (2 * k > bits * (degree - 1) && size + error < mpz_class(1) << (2 * k - bits * (degree - 1))) return true;
    }
  }

 private:
  static std::size_t degree_of_both(const RealNumber& x, const RealNumber& y, const RealNumber& other_x,
                                    const RealNumber& other_y) {
    // Integers are in every field.
    const RealNumber& from = x.field.empty() ? other_x : x;
    const RealNumber& to = y.field.empty() ? other_y : y;
    const std::size_t of_x = std::max(x.degree, other_x.degree);
    const std::size_t of_y = std::max(y.degree, other_y.degree);
    return degree_of_cosines(std::lcm(from.n, to.n)) * (from.field == to.field ? std::max(of_x, of_y) : of_x * of_y);
  }

  static std::size_t work_of(const RealNumber& x) { return degree_of_cosines(x.n) * x.degree + 1; }

  /// Of numbers times 2^k, so that the product is times 2^2k.
  static Approximation product(const Approximation& x, const Approximation& y) {
    return {x.value * y.value, abs(x.value) * y.error + abs(y.value) * x.error + x.error * y.error};
  }

  std::size_t bits_left_ = kMostBitsOfAll;
};

/// The lower ends of the lengths of a list, or the upper ones, in order.
std::vector<mpq_class> ends(const GeodesicsDocument& list, std::size_t which) {
  std::vector<mpq_class> result;
  for (const ClosedGeodesic& geodesic : list.geodesics) result.push_back(geodesic.length.at(which));
  std::sort(result.begin(), result.end());
  return result;
}

/// How many of them are not greater.
auto at_most(const std::vector<mpq_class>& ends, const mpq_class& length) {
  return std::upper_bound(ends.begin(), ends.end(), length) - ends.begin();
}

/// Whether a surface certainly has more closed geodesics up to some length than another one.
bool has_more(const GeodesicsDocument& a, const GeodesicsDocument& b) {
  const std::vector<mpq_class> certain = ends(a, 1);
  const std::vector<mpq_class> possible = ends(b, 0);
  return std::any_of(certain.begin(), certain.end(), [&](const mpq_class& length) {
    return length <= b.up_to && at_most(certain, length) > at_most(possible, length);
  });
}

}  // namespace

void expect_conjugate(const Traces& from, const Traces& to) {
  Comparison comparison;
  int sign = 1;  // Of the images of x, y and xy; then of that of a generator, as soon as it is known.
  for (std::size_t i = 0; i < from.traces.size(); ++i) {
    if (i >= 3 && (i - 3) % 4 == 0) sign = 0;
    const Trace& s = from.traces[i];
    const Trace& t = to.traces.at(i);
    const int product = s.sign * t.sign;
    if (sign * product < 0 || !comparison.agree(s.square, t.determinant, s.determinant, t.square))
      throw Refutation{"it changes traces of " + (i < 3 ? "the pair" : "generator " + number((i - 3) / 4))};
    if (product != 0) sign = product;
  }
}

bool counts_differ(const GeodesicsDocument& first, const GeodesicsDocument& other) {
  return has_more(first, other) || has_more(other, first);
}

}  // namespace epsnet::exact
