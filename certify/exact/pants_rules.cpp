#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"

/// Section 19: pants decompositions, by the exact numbers of section 19.1.
namespace epsnet::exact {
namespace {

/// Of one exact number that is not brought to lowest terms: a second for what is made of it.
constexpr std::size_t kMostBits = std::size_t{1} << 22;
/// Times that a path goes around a cuff, for which its exact numbers are computed.
constexpr double kMostTurns = 1000;
/// Integers up to this one are binary64 numbers.
constexpr double kMostIntegers = 0x1p52;

using Word = PantsDocument::Word;
using Cuff = PantsDocument::Cuff;
using End = PantsDocument::End;

std::string pants_name(std::size_t p) { return "pair of pants " + number(p); }
std::string cuff_name(std::size_t i) { return "cuff " + number(i); }

/// A positive multiple of the normal of an axis.
template <class R>
using AxisNormal = MinkowskiVector<R>;

/// Of a motion with a positive trace: its axis, with the left of it.
template <class R>
AxisNormal<R> normal_of(const Isometry<R>& g) {
  return {-g.b.im, g.b.re, g.a.im};
}

/// The sign of a motion for which its trace is not negative.
template <class R>
Isometry<R> positive(const Isometry<R>& g) {
  return sgn(g.a.re) < 0 ? Isometry<R>{-g.a, -g.b} : g;
}

/// sinh² of half of the length of a motion.
template <class R>
struct SquaredSinhOfHalf {
  explicit SquaredSinhOfHalf(const Isometry<R>& g)
      : numerator(norm(g.b) - g.a.im * g.a.im), denominator(norm(g.a) - norm(g.b)) {}

  [[nodiscard]] Interval length() const { return 2 * arsinh(sqrt(enclosure(numerator) / enclosure(denominator))); }

  R numerator;
  R denominator;
};

Answer is_between(const Interval& x, const Interval& lo, const Interval& hi) {
  return both(!is_less(x, lo), !is_less(hi, x));
}

/// Whether x + m·length is between lo and hi for an integer m.
Answer is_between_modulo(const Interval& length, const Interval& x, const Interval& lo, const Interval& hi) {
  if (is_less(hi - lo, length) == Answer::no) return Answer::yes;
  // Before the first of these numbers, all are less than lo.
  const double first = std::floor(((lo - x) / length).lower());
  if (!(std::abs(first) < kMostIntegers)) return Answer::unknown;
  Answer found = Answer::no;
  for (long i = 0; i < 4; ++i) {
    const Interval y = x + Interval(static_cast<long>(first) + i) * length;
    if (is_less(hi, y) == Answer::yes) return found;
    found = either(found, is_between(y, lo, hi));
    if (found == Answer::yes) return found;
  }
  return Answer::unknown;
}

template <class R>
class PantsRules {
 public:
  PantsRules(const PantsDocument& document, NetRules<R>& net) : document_(document), net_(net) {
    for (std::size_t p = 0; p < document_.pants.size(); ++p) check_paths(p);
    check_ends();
    for (const Cuff& cuff : document_.cuffs) check_numbers(cuff);
  }

  [[nodiscard]] std::vector<Rule> rules() {
    return {{"pants", [this] { check_pants(); }},
            {"glued", [this] { check_glued(); }},
            {"lengths", [this] { check_lengths(); }},
            {"twists", [this] { check_twists(); }}};
  }

 private:
  // Structure.

  void check_paths(std::size_t p) {
    const auto& [first, second] = document_.pants[p];
    if (first.empty()) throw Malformed(pants_name(p) + ": its first path is empty");
    expect_less(first[0], net_.sides(), "side");
    tiles_.push_back(net_.tile_of(first[0]));
    net_.expect_path(first, tiles_[p], tiles_[p]);
    net_.expect_path(second, tiles_[p], tiles_[p]);
  }

  void check_ends() const {
    std::vector<bool> seen(3 * document_.pants.size());
    for (const Cuff& cuff : document_.cuffs) {
      for (const auto& [p, k] : cuff.ends) {
        expect_less(p, document_.pants.size(), "pair of pants");
        expect_less(k, 3, "cuff");
        if (seen[3 * std::size_t{p} + k]) throw Malformed(cuff_name(k) + " of " + pants_name(p) + " is an end twice");
        seen[3 * std::size_t{p} + k] = true;
      }
      net_.expect_path(cuff.across, tiles_[cuff.ends[0][0]], tiles_[cuff.ends[1][0]]);
    }
    const auto missing = static_cast<std::size_t>(std::find(seen.begin(), seen.end(), false) - seen.begin());
    if (missing < seen.size())
      throw Malformed(cuff_name(missing % 3) + " of " + pants_name(missing / 3) + " is no end");
  }

  static void check_numbers(const Cuff& cuff) {
    if (cuff.length[0] <= 0) throw Malformed("a length is not positive");
    if (cuff.exp_half_length != 0 && cuff.exp_half_length <= 1)
      throw Malformed("exp_half_length is neither 0 nor more than 1");
  }

  // Exact numbers.

  /// Before numbers of so many bits are computed.
  void spend(const std::string& what, std::size_t needed) {
    if (needed > kMostBits)
      throw TooLarge{what + " takes exact numbers of " + number(needed) + " bits, and those of this checker have " +
                     number(kMostBits)};
    net_.spend(needed);
  }

  /// [path] of section 19, from the coordinates of the tile where the path ends to those where it begins.
  Isometry<R> element(const Word& path) { return inverse(net_.value(path)); }
  Isometry<R> conjugated(const Isometry<R>& h, const Isometry<R>& g) {
    return net_.product(net_.product(h, g), inverse(h));
  }
  [[nodiscard]] const Isometry<R>& element_of(const End& end) const { return elements_[end[0]][end[1]]; }
  [[nodiscard]] const Isometry<R>& next_element(const End& end) const { return elements_[end[0]][(end[1] + 1) % 3]; }

  SquaredSinhOfHalf<R> half_length(const std::string& what, const Isometry<R>& g) {
    spend(what, 2 * bits(g));
    return SquaredSinhOfHalf<R>(g);
  }

  // Rule `pants`.

  void check_pants() {
    // V − E + F = 2 − 2g, and 2E = 3F.
    const std::size_t expected = net_.net().triangles.size() / 2 - net_.net().vertices.size();
    if (document_.pants.size() != expected)
      throw Refutation{"the surface has " + number(expected) + " pairs of pants, not " +
                       number(document_.pants.size())};
    for (std::size_t p = 0; p < document_.pants.size(); ++p) elements_.push_back(elements_of(p));
  }

  /// D₀, D₁, D₂, with positive traces.
  std::array<Isometry<R>, 3> elements_of(std::size_t p) {
    const auto& [first, second] = document_.pants[p];
    std::array<Isometry<R>, 3> d{positive(element(first)), positive(element(second)), {}};
    const Isometry<R> ab = net_.product(d[0], d[1]);
    d[2] = positive(inverse(ab));
    // If a path is null-homotopic as well.
    if (sgn(ab.a.re) > 0) throw Refutation{pants_name(p) + ": its paths go around no three cuffs, for their traces"};
    if (!is_on_left(pants_name(p), normal_of(d[0]), normal_of(d[1])))
      throw Refutation{pants_name(p) + " is on the right of its paths"};
    return d;
  }

  /// Section 19.1, of normals n and m with ⟨n, m⟩ < 0 of axes that are disjoint: whether each axis is on the left of
  /// the other. If not, each is on the right.
  bool is_on_left(const std::string& what, const AxisNormal<R>& n, const AxisNormal<R>& m) {
    spend(what, 3 * (bits(n) + bits(m)));
    return sgn(R(lorentz_product(n, n) * m.t - lorentz_product(n, m) * n.t)) < 0;
  }

  // Rule `glued`.

  void check_glued() {
    for (std::size_t i = 0; i < document_.cuffs.size(); ++i) {
      const Cuff& cuff = document_.cuffs[i];
      across_.push_back(element(cuff.across));
      const Isometry<R> beyond = conjugated(across_[i], element_of(cuff.ends[1]));
      if (!is_identity(net_.product(element_of(cuff.ends[0]), beyond)))
        throw Refutation{cuff_name(i) + ": its two ends are not inverse to each other along the path across"};
    }
  }

  // Rule `lengths`.

  void check_lengths() {
    for (std::size_t i = 0; i < document_.cuffs.size(); ++i) {
      const Cuff& cuff = document_.cuffs[i];
      const SquaredSinhOfHalf<R> half = half_length(cuff_name(i), element_of(cuff.ends[0]));
      lengths_.push_back(half.length());
      const Answer between = is_between(lengths_[i], Interval(cuff.length[0]), Interval(cuff.length[1]));
      if (between == Answer::no) throw Refutation{cuff_name(i) + " has another length"};
      if (between == Answer::unknown) throw TooLarge{cuff_name(i) + ": its length is nearly an end of its interval"};
      if (cuff.exp_half_length != 0 && !is_exactly(cuff_name(i), half, cuff.exp_half_length))
        throw Refutation{cuff_name(i) + ": exp_half_length is not that of its length"};
    }
  }

  /// Whether 2 sinh(l/2) = r − 1/r.
  bool is_exactly(const std::string& what, const SquaredSinhOfHalf<R>& half, const mpq_class& r) {
    const mpz_class& p = r.get_num();
    const mpz_class& q = r.get_den();
    spend(what, 4 * bits(p) + bits(half.numerator) + bits(half.denominator));
    const mpz_class n = p * p - q * q;
    const mpz_class d = 2 * p * q;
    return sgn(R(R(mpz_class(d * d)) * half.numerator - R(mpz_class(n * n)) * half.denominator)) == 0;
  }

  // Rule `twists`.

  void check_twists() {
    for (std::size_t i = 0; i < document_.cuffs.size(); ++i) {
      const Answer between = has_its_twist(i);
      if (between == Answer::no) throw Refutation{cuff_name(i) + " has another twist"};
      if (between == Answer::unknown) throw TooLarge{cuff_name(i) + ": its twist is nearly an end of its interval"};
    }
  }

  Answer has_its_twist(std::size_t i) {
    const Interval lo(document_.cuffs[i].twist[0]);
    const Interval hi(document_.cuffs[i].twist[1]);
    const Interval found = twist(i, across_[i]);
    const Answer between = is_between_modulo(lengths_[i], found, lo, hi);
    if (between != Answer::unknown) return between;
    // Multiples of the length are not known exactly; the twist along a path that makes them is.
    const double turns = std::round((((lo + hi) / 2 - found) / lengths_[i]).lower());
    if (turns == 0 || !(std::abs(turns) <= kMostTurns)) return between;
    const Isometry<R>& forwards = element_of(document_.cuffs[i].ends[0]);
    const Isometry<R> turn = turns > 0 ? forwards : inverse(forwards);
    Isometry<R> across = across_[i];
    for (int n = 0; n < std::abs(turns); ++n) across = net_.product(turn, across);
    return is_between_modulo(lengths_[i], twist(i, across), lo, hi);
  }

  /// Section 19.1: tanh² of it is s/c² with s = ⟨n, n⟩ det(n, u, v)², and so sinh² is s/(c² − s).
  Interval twist(std::size_t i, const Isometry<R>& across) {
    const auto& [here, there] = document_.cuffs[i].ends;
    const AxisNormal<R> n = normal_of(element_of(here));
    const AxisNormal<R> u = normal_of(next_element(here));
    const AxisNormal<R> v = normal_of(conjugated(across, next_element(there)));
    spend("the twist of " + cuff_name(i), 4 * bits(n) + 2 * bits(u) + 2 * bits(v));
    const R nn = lorentz_product(n, n);
    const R sine = determinant(n, u, v);
    const R c = lorentz_product(u, n) * lorentz_product(v, n) - lorentz_product(u, v) * nn;
    const R s = nn * sine * sine;
    const Interval size = arsinh(sqrt(enclosure(s) / enclosure(R(c * c - s))));
    return sgn(sine) < 0 ? -size : size;
  }

  const PantsDocument& document_;
  NetRules<R>& net_;
  std::vector<Index> tiles_;                          ///< By pair of pants: of its paths.
  std::vector<std::array<Isometry<R>, 3>> elements_;  ///< By pair of pants.
  std::vector<Isometry<R>> across_;                   ///< By row of cuffs.
  std::vector<Interval> lengths_;                     ///< By row of cuffs.
};

}  // namespace

template <class R>
std::vector<Rule> pants_rules(const PantsDocument& document, NetRules<R>& net) {
  const auto rules = std::make_shared<PantsRules<R>>(document, net);
  return kept(rules, rules->rules());
}

template std::vector<Rule> pants_rules(const PantsDocument& document, NetRules<mpz_class>& net);
template std::vector<Rule> pants_rules(const PantsDocument& document, NetRules<Algebraic>& net);
template std::vector<Rule> pants_rules(const PantsDocument& document, NetRules<FieldNumber>& net);

}  // namespace epsnet::exact
