#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/closed_walks.h"

/// Section 21: closed curves. Their lengths by exact numbers, all else by the walks of section 21.1.
namespace epsnet::exact {
namespace {

/// Multiplications of integers for homology: some seconds.
constexpr std::size_t kMostMultiplications = 30'000'000;

using Walk = RadialGraph::Walk;
using Matrix = std::vector<std::vector<mpz_class>>;

std::string curve_name(std::size_t i) { return "curve " + number(i); }

/// The least of all rotations of a closed walk without repetitions.
Walk least_rotation(const Walk& walk) {
  std::size_t best = 0;
  std::size_t other = 1;
  const std::size_t n = walk.size();
  for (std::size_t same = 0; best < n && other < n && same < n;) {
    const auto x = walk[(best + same) % n];
    const auto y = walk[(other + same) % n];
    if (x == y) {
      ++same;
      continue;
    }
    (y < x ? best : other) += same + 1;
    if (best == other) ++other;
    same = 0;
  }
  Walk result(walk);
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(std::min(best, other)), result.end());
  return result;
}

/// How many times a closed walk runs through a shorter one, at most.
std::size_t repetitions(const Walk& walk) {
  const std::size_t n = walk.size();
  for (std::size_t period = 1; 2 * period <= n; ++period) {
    if (n % period == 0 && std::equal(walk.begin() + static_cast<std::ptrdiff_t>(period), walk.end(), walk.begin()))
      return n / period;
  }
  return 1;
}

/// By elimination in which all divisions leave no rest.
mpz_class determinant(Matrix m) {
  mpz_class result = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    const mpz_class before = result;
    std::size_t p = k;
    while (p < m.size() && sgn(m[p][k]) == 0) ++p;
    if (p == m.size()) return 0;
    if (p != k) {
      m[p].swap(m[k]);
      for (mpz_class& x : m[k]) x = -x;
    }
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      for (std::size_t j = k + 1; j < m.size(); ++j) {
        m[i][j] = m[i][j] * m[k][k] - m[i][k] * m[k][j];
        mpz_divexact(m[i][j].get_mpz_t(), m[i][j].get_mpz_t(), before.get_mpz_t());
      }
    }
    result = m[k][k];
  }
  return result;
}

template <class R>
class CurveRules {
 public:
  CurveRules(const CurvesDocument& document, NetRules<R>& net) : document_(document), net_(net) {
    for (const CurvesDocument::Curve& curve : document_.curves) check_structure(curve);
    check_pairs();
    std::vector<bool> seen(document_.curves.size());
    for (const Index i : document_.basis) {
      expect_less(i, seen.size(), "curve");
      if (seen[i]) throw Malformed(curve_name(i) + " is in the basis twice");
      seen[i] = true;
    }
    for (const auto& set : document_.filling) {
      for (const Index i : set) expect_less(i, seen.size(), "curve");
      if (std::adjacent_find(set.begin(), set.end(), std::greater_equal<>()) != set.end())
        throw Malformed("a set of curves is not in ascending order");
    }
  }

  [[nodiscard]] std::vector<Rule> rules() {
    return {{"lengths", [this] { check_lengths(); }, true},
            {"powers", [this] { check_powers(); }},
            {"intersections", [this] { check_intersections(); }},
            {"homology", [this] { check_homology(); }},
            {"filling", [this] { check_filling(); }}};
  }

 private:
  /// What power of which primitive walk, or of its inverse.
  struct Power {
    std::size_t root;
    mpz_class exponent;
    int direction;
  };

  // Structure.

  void check_structure(const CurvesDocument::Curve& curve) const {
    expect_less(curve.vertex, net_.net().vertices.size(), "vertex");
    const Index tile = net_.net().charts[net_.net().vertices[curve.vertex].chart].first;
    net_.expect_path(curve.word, tile, tile);
    if (curve.length[0] <= 0) throw Malformed("a length is not positive");
    if (curve.power == 0) throw Malformed("a power is not positive");
    if (curve.homology.size() != document_.basis.size()) throw Malformed("not one coefficient for each of the basis");
  }

  void check_pairs() const {
    std::size_t row = 0;
    const std::size_t count = document_.curves.size();
    if (2 * document_.pairs.size() != count * count - count) throw Malformed("not one row for each two curves");
    for (Index i = 0; i < count; ++i) {
      for (Index j = i + 1; j < count; ++j) {
        if (document_.pairs[row].first != i || document_.pairs[row].second != j)
          throw Malformed("the pairs are not in order");
        ++row;
      }
    }
  }

  // Rule `lengths`.

  void check_lengths() {
    for (std::size_t i = 0; i < document_.curves.size(); ++i) {
      const CurvesDocument::Curve& curve = document_.curves[i];
      const Index chart = net_.net().vertices[curve.vertex].chart;
      const Isometry<R> g = net_.product(inverse(net_.frame(chart)), net_.value(chart, curve.word));
      // sinh²(l/2) is this quotient.
      const R numerator = norm(g.b) - g.a.im * g.a.im;
      const R denominator = norm(g.a) - norm(g.b);
      for (const bool is_upper : {false, true}) {
        const Answer less = is_less(numerator, denominator, squared_sinh(curve.length[is_upper ? 1 : 0] / 2));
        if (less == Answer::unknown) throw TooLarge{curve_name(i) + " has a length that is nearly a bound"};
        if ((less == Answer::yes) != is_upper) throw Refutation{curve_name(i) + " has another length"};
      }
    }
  }

  // Rule `powers`.

  void check_powers() {
    graph_.emplace(net_, static_cast<long>(net_.euler()));
    std::map<Walk, Power> known;
    for (std::size_t i = 0; i < document_.curves.size(); ++i) {
      const Walk walk = graph_->walk(document_.curves[i].word);
      const Walk forwards = graph_->rightmost(walk);
      if (forwards.empty()) throw Refutation{curve_name(i) + " is null-homotopic"};
      const std::size_t exponent = repetitions(forwards);
      if (exponent != document_.curves[i].power)
        throw Refutation{curve_name(i) + " is the power " + number(exponent) + " of a primitive one"};
      const Walk once = least_rotation(Walk(forwards.begin(), forwards.end() - rest(forwards, exponent)));
      const auto found = known.find(once);
      if (found != known.end()) {
        powers_.push_back({found->second.root, exponent, found->second.direction});
        continue;
      }
      powers_.push_back({roots_.size(), exponent, 1});
      known.insert({once, powers_.back()});
      known.insert({backwards(once), {roots_.size(), 1, -1}});
      roots_.push_back(once);
    }
  }

  /// The steps of all rounds but the first.
  static std::ptrdiff_t rest(const Walk& walk, std::size_t rounds) {
    return static_cast<std::ptrdiff_t>(walk.size() - walk.size() / rounds);
  }

  Walk backwards(const Walk& walk) {
    Walk result(walk.rbegin(), walk.rend());
    for (RadialGraph::Step& e : result) e ^= 1U;
    return least_rotation(graph_->rightmost(result));
  }

  // Rule `intersections`.

  void check_intersections() {
    for (std::size_t i = 0; i < powers_.size(); ++i) {
      const mpz_class& k = powers_[i].exponent;
      if (k * k * self_crossings(powers_[i].root) + k - 1 != document_.curves[i].self_intersections)
        throw Refutation{curve_name(i) + " has another self-intersection number"};
    }
    for (const CurvesDocument::Pair& pair : document_.pairs) {
      const Power& x = powers_[pair.first];
      const Power& y = powers_[pair.second];
      const bool same = x.root == y.root;
      const std::size_t points = same ? 2 * self_crossings(x.root) : crossings(x.root, y.root).steps.size();
      const long signs = (x.root < y.root ? 1 : -1) * crossings(x.root, y.root).signs;
      const mpz_class times = x.exponent * y.exponent;
      const std::string names = curve_name(pair.first) + " and " + curve_name(pair.second);
      if (times * points != pair.intersections) throw Refutation{names + " have another geometric intersection number"};
      if (times * (x.direction * y.direction * signs) != pair.algebraic)
        throw Refutation{names + " have another algebraic intersection number"};
    }
  }

  /// Of the walk with the lesser number and the other one.
  const WalkCrossings& crossings(std::size_t i, std::size_t j) {
    const auto [place, is_new] = crossings_.try_emplace(std::minmax(i, j));
    const auto& [first, other] = place->first;
    if (is_new) place->second = graph_->crossings(roots_[first], roots_[other], first == other);
    return place->second;
  }
  std::size_t self_crossings(std::size_t i) { return crossings(i, i).steps.size() / 2; }

  // Rule `homology`.

  [[nodiscard]] mpz_class algebraic(std::size_t i, std::size_t j) const {
    if (i == j) return 0;
    const std::size_t low = std::min(i, j);
    const std::size_t high = std::max(i, j);
    // The rows of pairs (low, low + 1), … end where those of low + 1 begin.
    const std::size_t rows_from_low = (document_.curves.size() - low) * (document_.curves.size() - low - 1) / 2;
    const mpz_class& value = document_.pairs[document_.pairs.size() - rows_from_low + (high - low - 1)].algebraic;
    return i < j ? value : mpz_class(-value);
  }

  void check_homology() const {
    const std::size_t size = document_.basis.size();
    if (static_cast<std::int64_t>(size) != 2 - net_.euler())
      throw Refutation{"a basis has " + std::to_string(2 - net_.euler()) + " curves, not " + number(size)};
    if (size * size * (size + document_.curves.size()) > kMostMultiplications)
      throw TooLarge{"the matrix of the basis is too large"};
    Matrix matrix(size, std::vector<mpz_class>(size));
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) matrix[j][k] = algebraic(document_.basis[j], document_.basis[k]);
    }
    if (abs(determinant(matrix)) != 1) throw Refutation{"the basis is none: the determinant of its matrix is not 1"};
    for (std::size_t i = 0; i < document_.curves.size(); ++i) {
      for (std::size_t k = 0; k < size; ++k) {
        mpz_class sum = algebraic(i, document_.basis[k]);
        for (std::size_t j = 0; j < size; ++j) sum -= document_.curves[i].homology[j] * matrix[j][k];
        if (sum != 0) throw Refutation{curve_name(i) + " has another class"};
      }
    }
  }

  // Rule `filling`.

  void check_filling() {
    for (std::size_t row = 0; row < document_.filling.size(); ++row) {
      std::vector<std::size_t> roots;
      for (const Index i : document_.filling[row]) roots.push_back(powers_[i].root);
      std::sort(roots.begin(), roots.end());
      roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
      if (!fill(roots)) throw Refutation{"set " + number(row) + " does not fill"};
    }
  }

  bool fill(const std::vector<std::size_t>& roots) {
    std::vector<const Walk*> walks;
    std::vector<RadialGraph::Joint> joints;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      walks.push_back(&roots_[roots[i]]);
      for (std::size_t j = i; j < roots.size(); ++j) {
        for (const auto& [step, other] : crossings(roots[i], roots[j]).steps) joints.push_back({i, step, j, other});
      }
    }
    return graph_->generate(walks, joints);
  }

  const CurvesDocument& document_;
  NetRules<R>& net_;
  std::optional<RadialGraph> graph_;
  std::vector<Walk> roots_;    ///< Primitive walks, rightmost, no two the same or inverse to each other.
  std::vector<Power> powers_;  ///< By curve.
  std::map<std::pair<std::size_t, std::size_t>, WalkCrossings> crossings_;
};

}  // namespace

template <class R>
std::vector<Rule> curve_rules(const CurvesDocument& document, NetRules<R>& net) {
  const auto rules = std::make_shared<CurveRules<R>>(document, net);
  return kept(rules, rules->rules());
}

template std::vector<Rule> curve_rules(const CurvesDocument& document, NetRules<mpz_class>& net);
template std::vector<Rule> curve_rules(const CurvesDocument& document, NetRules<Algebraic>& net);
template std::vector<Rule> curve_rules(const CurvesDocument& document, NetRules<FieldNumber>& net);

}  // namespace epsnet::exact
