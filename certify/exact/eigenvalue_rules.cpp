#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/eigenfunctions.h"
#include "certify/exact/flat_triangles.h"
#include "certify/exact/inertia.h"
#include "certify/exact/net_structure.h"

/// Section 17: eigenvalues of the Laplacian, by inertia and eigenfunctions.

namespace epsnet::exact {
namespace {

using Count = std::int64_t;

/// What the rows say of numbers of eigenvalues, each in logarithmic time.
class Counts {
 public:
  Counts(const EigenvaluesDocument& document, const std::optional<Interval>& distance)
      : document_(document), functions_{0} {
    for (const auto& row : document.eigenfunctions)
      functions_.push_back(functions_.back() + static_cast<Count>(row.functions.size()));
    at_least_.push_back({0, 0, 0});
    for (const auto& row : document.at_least) {
      if (const auto at = least(row.below, distance))
        at_least_.push_back({*at, row.count, row.count - functions_from(row.below)});
    }
    sort(at_least_);
    for (std::size_t i = 1; i < at_least_.size(); ++i) {
      at_least_[i].alone = std::max(at_least_[i].alone, at_least_[i - 1].alone);
      at_least_[i].beside = std::max(at_least_[i].beside, at_least_[i - 1].beside);
    }
    for (const auto& row : document.at_most)
      at_most_.push_back({most(row.below, distance), row.count, row.count - functions_below(row.below)});
    sort(at_most_);
    for (std::size_t i = at_most_.size(); i-- > 1;) {
      at_most_[i - 1].alone = std::min(at_most_[i - 1].alone, at_most_[i].alone);
      at_most_[i - 1].beside = std::min(at_most_[i - 1].beside, at_most_[i].beside);
    }
  }

  /// A(x): of the greatest for y <= x, those with functions from y on to x and those without.
  [[nodiscard]] Count least_up_to(const mpq_class& x) const {
    const auto after =
        std::upper_bound(at_least_.begin(), at_least_.end(), x, [](const auto& z, const Bound& y) { return z < y.at; });
    const Bound& best = *(after - 1);
    return std::max(best.alone, best.beside + functions_up_to(x));
  }

  /// B(x): of the least for y >= x; and B(0) = 0.
  [[nodiscard]] Count most_below(const mpq_class& x) const {
    if (x <= 0) return 0;
    const auto best =
        std::lower_bound(at_most_.begin(), at_most_.end(), x, [](const Bound& y, const auto& z) { return y.at < z; });
    if (best == at_most_.end()) return std::numeric_limits<Count>::max();
    return std::min(best->alone, best->beside + functions_from(x));
  }

 private:
  /// For all numbers up to y, or from y on.
  struct Bound {
    mpq_class at;
    Count alone;
    Count beside;  ///< Less functions on one side.
  };
  /// (√y + distance)², or more; nothing if that is more than any binary64.
  static std::optional<mpq_class> least(const mpq_class& y, const std::optional<Interval>& distance) {
    if (!distance) return y;
    const double upper = square(sqrt(Interval(y)) + *distance).upper();
    return std::isfinite(upper) ? std::optional<mpq_class>(upper) : std::nullopt;
  }
  /// (√y − distance)², or less; 0 if that is not known to be a square of a number that is not negative.
  static mpq_class most(const mpq_class& y, const std::optional<Interval>& distance) {
    if (!distance) return y;
    const Interval root = sqrt(Interval(y)) - *distance;
    return is_less(0, root) == Answer::yes ? mpq_class(square(root).lower()) : mpq_class(0);
  }
  static void sort(std::vector<Bound>& bounds) {
    std::sort(bounds.begin(), bounds.end(), [](const Bound& x, const Bound& y) { return x.at < y.at; });
  }

  /// Of the rows before the first one for which this does not hold.
  template <class Condition>
  [[nodiscard]] Count functions_while(const Condition& holds) const {
    const auto& rows = document_.eigenfunctions;
    const auto end = std::partition_point(rows.begin(), rows.end(), [&](const auto& row) { return holds(row.in); });
    return functions_[static_cast<std::size_t>(end - rows.begin())];
  }
  /// Of rows that are not x <= lo.
  [[nodiscard]] Count functions_from(const mpq_class& x) const {
    return functions_while([&](const Range& in) { return in[0] < x; });
  }
  [[nodiscard]] Count functions_up_to(const mpq_class& x) const {
    return functions_while([&](const Range& in) { return in[1] <= x; });
  }
  [[nodiscard]] Count functions_below(const mpq_class& x) const {
    return functions_while([&](const Range& in) { return in[1] < x; });
  }

  const EigenvaluesDocument& document_;
  std::vector<Count> functions_;  ///< In the rows before.
  std::vector<Bound> at_least_;
  std::vector<Bound> at_most_;
};

}  // namespace

void check_enclosures(const EigenvaluesDocument& document, const std::optional<Interval>& distance) {
  const Counts counts(document, distance);
  Count before = 0;
  for (std::size_t i = 0; i < document.eigenvalues.size(); ++i) {
    const auto& [in, count] = document.eigenvalues[i];
    const std::string name = "row " + number(i) + " of eigenvalues";
    if (counts.most_below(in[0]) > before) throw Refutation{name + " may be less than its interval"};
    before += count;
    if (counts.least_up_to(in[1]) < before) throw Refutation{name + " may be more than its interval"};
  }
  if (counts.most_below(document.next) > before) throw Refutation{"there may be another eigenvalue less than next"};
}

namespace {

using Document = EigenvaluesDocument;

constexpr std::size_t kMostTriangles = 100'000;      ///< Halved ones.
constexpr std::size_t kMostValuesOfBox = 1'000'000;  ///< For each direction corners of triangles and letters.
constexpr std::size_t kTogether = 4;                 ///< Directions of a box of which all signs are tried.
constexpr std::size_t kMultiplications =
    2000;  ///< Of all factorisations of a rule, for each lift that a list may ask for.

// Structure.

void expect(bool holds, const char* what) {
  if (!holds) throw Malformed(what);
}

void check_order(const std::vector<Index>& order, std::size_t size, const char* what) {
  expect(order.size() == size, what);
  std::vector<bool> seen(size);
  for (const Index i : order) {
    expect(i < size && !seen[i], what);
    seen[i] = true;
  }
}

void check_functions(const Document::Eigenfunctions& row, const Net& net) {
  expect(row.in[0] > 0 && row.in[0] <= row.lambda && row.lambda <= row.in[1], "lambda: not in in, or in is from 0 on");
  expect(row.radius > net.epsilon && row.radius < 2, "radius: not more than epsilon and less than 2");
  expect(!row.functions.empty() && row.functions.size() <= 1000, "functions: none, or more than 1000");
  const std::size_t vertices = net.vertices.size();
  const std::size_t size = row.functions[0].size();
  const std::size_t each = vertices == 0 ? 0 : size / vertices;
  for (const Coefficients& function : row.functions) {
    expect(function.size() == size && each * vertices == size && each % 2 == 1 && each >= 3 && each <= 401,
           "not 2M + 1 coefficients for each vertex");
    expect(std::any_of(function.begin(), function.end(), [](const mpq_class& c) { return c != 0; }),
           "all coefficients are 0");
  }
}

/// One for each of so many sides; of absolute value less than 1, multiples of 1/n for some n <= 10^18.
void check_phases(const std::vector<mpq_class>& phases, std::size_t sides) {
  if (phases.empty()) return;
  expect(phases.size() == sides, "phases: not one for each side of the surface");
  const mpz_class most("1000000000000000000");
  mpz_class denominator = 1;
  for (const mpq_class& phase : phases) {
    expect(abs(phase) < 1, "phases: one is not between -1 and 1");
    denominator = lcm(denominator, phase.get_den());
    expect(denominator <= most, "phases: the least common denominator is more than 10^18");
  }
}

void check_box(const Document& document, std::size_t sides) {
  if (!document.box) return;
  expect(!document.phases.empty(), "box: there are no phases");
  expect(document.box->radius > 0, "box: the radius is not positive");
  expect(document.box->directions.size() + document.net.vertices.size() <= 2 + document.net.triangles.size() / 2,
         "box: more than 2g directions");
  for (const Document::Direction& direction : document.box->directions) {
    expect(direction.steps.size() == sides, "steps: not one for each side of the surface");
    for (const mpz_class& step : direction.steps) expect(abs(step) <= 1'000'000, "steps: one is more than 10^6");
    expect(direction.heights.size() == document.net.vertices.size(), "heights: not one for each vertex");
  }
}

void check_structure(const Document& document, std::size_t sides) {
  check_phases(document.phases, sides);
  check_box(document, sides);
  expect(document.phases.empty() || document.eigenfunctions.empty(), "eigenfunctions: there are phases");
  expect(document.next >= 0, "next: negative");
  expect(document.halvings <= 12, "halvings: more than 12");
  const HalvedSize size = halved_size(document.net, document.halvings);
  check_order(document.side_order, document.at_most.empty() ? 0 : size.sides, "side_order: no permutation");
  check_order(document.vertex_order, document.at_least.empty() ? 0 : size.vertices, "vertex_order: no permutation");
  for (const auto& row : document.eigenvalues) expect(row.count > 0, "eigenvalues: a count is 0");
  for (const auto& row : document.at_most)
    expect(row.below > 0 && row.below <= row.sigma, "at_most: not 0 < below <= sigma");
  for (const auto& row : document.at_least)
    expect(row.below > 0 && row.count > 0, "at_least: not 0 < below, or count 0");
  const Document::Eigenfunctions* before = nullptr;
  for (const auto& row : document.eigenfunctions) {
    check_functions(row, document.net);
    expect(before == nullptr || before->in[1] < row.in[0], "eigenfunctions: not disjoint and in order");
    before = &row;
  }
}

template <class R>
class EigenvalueRules {
 public:
  EigenvalueRules(const Document& document, NetRules<R>& net, long most_values)
      : document_(document), net_(net), most_values_(most_values), bundle_(document.phases, net) {
    check_structure(document, net.sides());
  }

  [[nodiscard]] std::vector<Rule> rules() {
    std::vector<Rule> rules{{.name = "most", .ask = [this] { check_most(); }, .may_be_open = true},
                            {.name = "least", .ask = [this] { check_least(); }, .may_be_open = true},
                            {.name = "eigenfunctions", .ask = [this] { check_eigenfunctions(); }, .may_be_open = true},
                            {.name = "enclosures", .ask = [this] { check_enclosures(document_, distance_); }}};
    if (document_.box) rules.insert(rules.begin(), {.name = "box", .ask = [this] { check_box(); }});
    if (has_phases()) rules.insert(rules.begin(), {.name = "phases", .ask = [this] { bundle_.check(); }});
    return rules;
  }

 private:
  [[nodiscard]] bool has_phases() const { return !document_.phases.empty(); }
  /// How many negative eigenvalues there are for a count: with that of the constants, unless there are phases.
  [[nodiscard]] std::size_t expected(Index count) const { return std::size_t{count} + (has_phases() ? 0 : 1); }

  /// Of each dart's triangle the row of what belongs to the dart, `numbers`, in the order of the file.
  [[nodiscard]] Inertia inertia(const std::vector<Index>& numbers, const std::vector<Index>& order,
                                std::size_t factorisations) const {
    std::vector<Index> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<Index>(i);
    std::vector<Inertia::Rows> rows;
    for (std::size_t dart = 0; dart < numbers.size(); dart += 3)
      rows.push_back({place[numbers[dart]], place[numbers[dart + 1]], place[numbers[dart + 2]]});
    const auto multiplications = kMultiplications * static_cast<std::size_t>(most_values_);
    return {std::move(rows), order.size(), multiplications / factorisations, bundle_.values()};
  }
  /// Adds those of a triangle, by phases of what belongs to its darts.
  void add(Inertia& sum, std::size_t triangle, const LocalForms& forms, const std::vector<mpq_class>& phases) {
    if (phases.empty()) return sum.add(triangle, forms);
    const auto turn = [&](std::size_t dart) -> const Inertia::Turn& {
      const auto found = turns_.find(phases[dart]);
      if (found != turns_.end()) return found->second;
      return turns_.emplace(phases[dart], LineBundle::turn(phases[dart])).first->second;
    };
    sum.add(triangle, forms, {turn(3 * triangle), turn(3 * triangle + 1), turn(3 * triangle + 2)});
  }
  [[nodiscard]] HalvedNet halved_net() const {
    if (halved_size(document_.net, document_.halvings).triangles > kMostTriangles)
      throw LeftOut{"so many halved triangles"};
    return halved(net_, document_.halvings);
  }
  /// Calls visit(t, triangle) for all halved triangles.
  template <class Visit>
  void each_triangle(const Visit& visit) {
    for (Index t = 0; t < document_.net.triangles.size(); ++t) {
      Corners corners;
      for (Index i = 0; i < 3; ++i) corners[i] = on_hyperboloid(net_.corner(3 * t + i));
      each_halved(t, corners, document_.halvings,
                  [&](std::size_t small, const Corners& its) { visit(small, FlatTriangle(its)); });
    }
  }
  static Vector on_hyperboloid(const Point<R>& z) {
    const Interval size = enclosure(gap(z));
    return {2 * enclosure(R(z.n.re * z.m)) / size, 2 * enclosure(R(z.n.im * z.m)) / size,
            enclosure(R(z.m * z.m + norm(z.n))) / size};
  }

  /// Lemma 37.10.
  void check_box() {
    std::size_t values = 3 * document_.net.triangles.size();
    for (const auto& label : document_.net.labels) values += label.word.size();
    if (values * document_.box->directions.size() > kMostValuesOfBox) throw LeftOut{"so many directions"};
    std::vector<std::vector<mpz_class>> steps;  // By direction and label.
    for (const Document::Direction& direction : document_.box->directions) {
      const auto sum = [&](const std::vector<Index>& word) {
        mpz_class result;
        for (const Index s : word) result += direction.steps[s];
        return result;
      };
      each_relation(net_, [&](const std::vector<Index>& sides, const std::string& name) {
        if (sum(sides) != 0) throw Refutation{"the steps of " + name + " do not add up to 0"};
      });
      steps.emplace_back(1);
      for (const auto& label : document_.net.labels) steps.back().push_back(sum(label.word));
    }
    Interval slope;
    for (Index t = 0; t < document_.net.triangles.size(); ++t) {
      Corners corners;
      for (Index i = 0; i < 3; ++i) corners[i] = on_hyperboloid(net_.corner(3 * t + i));
      const FlatTriangle triangle(corners);
      std::vector<std::array<Interval, 3>> heights(steps.size());
      for (std::size_t k = 0; k < steps.size(); ++k) {
        for (Index dart = 3 * t; dart < 3 * t + 3; ++dart) {
          heights[k][dart % 3] = Interval(document_.box->directions[k].heights[net_.start(dart)] +
                                          mpq_class(steps[k][net_.label_number(dart)]));
        }
      }
      Interval of_all;
      for (std::size_t first = 0; first < steps.size(); first += kTogether) {
        const std::size_t last = std::min(first + kTogether, steps.size());
        Interval of_group;
        // With all signs, up to the sign of the sum.
        for (unsigned signs = 0; signs < 1U << (last - first - 1); ++signs) {
          std::array<Interval, 3> sum;
          for (std::size_t k = first; k < last; ++k) {
            const bool minus = (signs >> (k - first) & 1U) != 0;
            for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + (minus ? -heights[k][i] : heights[k][i]);
          }
          of_group = max(of_group, triangle.slope(sum));
        }
        of_all = of_all + of_group;
      }
      slope = max(slope, of_all);
    }
    const Interval distance = 2 * Interval::pi() * Interval(document_.box->radius) * slope;
    if (!std::isfinite(distance.upper())) give_up("slopes of a box are too great");
    if (distance.upper() != 0) distance_ = distance;
  }

  /// Lemma 34; λ_0 is one of those that the matrix counts.
  void check_most() {
    if (document_.at_most.empty()) return;
    const HalvedNet net = halved_net();
    // The side opposite to corner 0 is that of the second dart.
    std::vector<Index> opposite_sides;
    for (Index dart = 0; dart < net.side.size(); ++dart) opposite_sides.push_back(net.side[next(dart)]);
    std::vector<mpq_class> phases;
    if (has_phases()) {
      const std::vector<mpq_class> of_sides = bundle_.of_sides(net, document_.halvings);
      for (Index dart = 0; dart < net.side.size(); ++dart) phases.push_back(of_sides[next(dart)]);
    }
    Inertia forms = inertia(opposite_sides, document_.side_order, document_.at_most.size());
    Interval constant;  // H
    each_triangle([&](std::size_t t, const FlatTriangle& triangle) {
      add(forms, t, triangle.lower_forms(), phases);
      constant = max(constant, triangle.interpolation());
    });
    for (std::size_t i = 0; i < document_.at_most.size(); ++i) {
      const auto& [below, count, exact_sigma] = document_.at_most[i];
      const Interval sigma(exact_sigma);
      if (is_less(sigma, Interval(below) * (1 + constant * sigma)) != Answer::no ||
          forms.negative(sigma, Inertia::Bound::at_most) > expected(count))
        give_up("row " + number(i) + " of at_most is not proved");
    }
  }

  /// Lemma 35.
  void check_least() {
    if (document_.at_least.empty()) return;
    const HalvedNet net = halved_net();
    Inertia forms = inertia(net.start, document_.vertex_order, document_.at_least.size());
    std::vector<mpq_class> phases;
    if (has_phases()) phases = bundle_.of_starts(net, document_.halvings);
    each_triangle([&](std::size_t t, const FlatTriangle& triangle) { add(forms, t, triangle.upper_forms(), phases); });
    for (std::size_t i = 0; i < document_.at_least.size(); ++i) {
      const auto& [below, count] = document_.at_least[i];
      if (forms.negative(Interval(below), Inertia::Bound::at_least) < expected(count))
        give_up("row " + number(i) + " of at_least is not proved");
    }
  }

  /// [λ − δ, λ + δ] is a part of the range of each row.
  void check_eigenfunctions() {
    const auto& rows = document_.eigenfunctions;
    if (rows.empty()) return;
    Loops<R> loops(net_, Interval(), most_values_);  // Without any loop: for lifts of vertices.
    const auto minus_euler = static_cast<long>(document_.net.triangles.size() / 2 - document_.net.vertices.size());
    std::vector<NearLifts> near;
    std::size_t values = 0;
    for (const auto& row : rows) {
      near.push_back(near_lifts(loops, row.radius));
      values += values_needed(row, near.back());
      if (values > static_cast<std::size_t>(most_values_)) throw LeftOut{"so many eigenfunctions"};
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Interval error = eigenvalue_error(rows[i], document_.net.epsilon, near[i], minus_euler);
      const Interval lambda(rows[i].lambda);
      if (is_less(lambda - error, Interval(rows[i].in[0])) != Answer::no ||
          is_less(Interval(rows[i].in[1]), lambda + error) != Answer::no)
        give_up("row " + number(i) + " of eigenfunctions does not prove eigenvalues in its interval");
    }
  }

  /// Those nearer than ε + R to a vertex.
  [[nodiscard]] NearLifts near_lifts(Loops<R>& loops, const mpq_class& radius) const {
    const Interval reach = square(sinh(Interval(document_.net.epsilon + radius) / 2));
    NearLifts near(document_.net.vertices.size());
    for (Index v = 0; v < near.size(); ++v) {
      const auto lifts = loops.lifts(v, reach);
      for (auto lift = lifts.begin() + 1; lift != lifts.end(); ++lift) {
        const Motion from_centre = inverse(loops.to_centre(lift->vertex));
        near[v].push_back({lift->vertex, compose(loops.to_centre(v), compose(lift->frame, from_centre))});
      }
    }
    return near;
  }

  const Document& document_;
  NetRules<R>& net_;
  long most_values_;
  LineBundle bundle_;
  std::optional<Interval> distance_;  ///< In a box: of roots of eigenvalues from those in its centre.
  std::map<mpq_class, Inertia::Turn> turns_;
};

}  // namespace

template <class R>
std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<R>& net, long most_values) {
  const auto rules = std::make_shared<EigenvalueRules<R>>(document, net, most_values);
  return kept(rules, rules->rules());
}

template std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<mpz_class>& net, long);
template std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<Algebraic>& net, long);
template std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<FieldNumber>& net, long);

}  // namespace epsnet::exact
