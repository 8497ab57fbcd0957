#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/eigenfunctions.h"
#include "certify/exact/geodesic_rules.h"
#include "certify/exact/trace_formula.h"

/// Sections 17 and 17.1: eigenvalues of the Laplacian, by the trace formula and eigenfunctions.
namespace epsnet::exact {
namespace {

using Document = EigenvaluesDocument;
using Function = Document::Eigenfunction;

bool contains(const Range& x, const Range& y) { return x[0] <= y[0] && y[1] <= x[1]; }
bool are_apart(const Range& x, const Range& y) { return x[1] < y[0] || y[1] < x[0]; }

/// Of the intervals of eigenfunctions for which that holds, in the order of their upper ends, or lower ends if these
/// are equal, each one that has no point in common with those taken before.
template <class Condition>
std::vector<Range> disjoint(const Document& document, const Condition& holds) {
  std::vector<Range> known;
  for (const Function& row : document.eigenfunctions) {
    if (holds(row.in)) known.push_back({row.in[1], row.in[0]});
  }
  std::sort(known.begin(), known.end());
  std::vector<Range> result;
  for (const auto& [upper, lower] : known) {
    if (result.empty() || result.back()[1] < lower) result.push_back({lower, upper});
  }
  return result;
}

mpq_class greatest_eigenvalue(const Document& document) {
  const mpq_class step = step_of(document);
  return mpq_class(1, 4) + 9 / (step * step);
}

// Structure.

void expect(bool holds, const char* what) {
  if (!holds) throw Malformed(what);
}

void expect_coefficients(const Coefficients& coefficients) {
  expect(std::any_of(coefficients.begin(), coefficients.end(), [](const mpq_class& c) { return c != 0; }),
         "all coefficients are 0");
}

void check_structure(const Document& document) {
  expect(document.order >= 8 && document.order <= 16 && document.order % 2 == 0, "order: not 8, 10, …, 16");
  expect(document.degree >= 1 && document.degree <= 64, "degree: not from 1 to 64");
  expect(step_of(document) <= 1, "degree: too small for lengths up to up_to");
  const mpq_class greatest = greatest_eigenvalue(document);
  const auto expect_statement = [&](const Range& in, const Coefficients& coefficients) {
    expect(in[1] <= greatest, "in: reaches too far");
    expect(coefficients.size() == document.degree + 1, "not degree + 1 coefficients");
    expect_coefficients(coefficients);
  };
  for (const auto& row : document.at_most) expect_statement(row.in, row.coefficients);
  for (const auto& row : document.at_least) {
    expect_statement(row.in, row.coefficients);
    expect(row.in[0] < row.in[1], "in: a single point");
    expect(contains(row.in, row.within), "within: not a part of in");
    expect(row.count > 0, "a count is 0");
  }
  const std::size_t vertices = document.spectrum.net.vertices.size();
  for (const Function& row : document.eigenfunctions) {
    expect(row.in[0] > 0 && row.in[0] <= row.lambda && row.lambda <= row.in[1],
           "lambda: not in in, or in is from 0 on");
    expect(row.radius > document.spectrum.net.epsilon && row.radius < 2,
           "radius: not more than epsilon and less than 2");
    const std::size_t each = vertices == 0 ? 0 : row.coefficients.size() / vertices;
    expect(each * vertices == row.coefficients.size() && each % 2 == 1 && each >= 3 && each <= 401,
           "not 2M + 1 coefficients for each vertex");
    expect_coefficients(row.coefficients);
  }
  expect(document.up_to > 0, "eigenvalues_up_to: not positive");
  const Document::Window* before = nullptr;
  for (const Document::Window& window : document.windows) {
    expect(before == nullptr || before->in[1] < window.in[0], "windows: not disjoint and in order");
    expect(window.in[1] <= document.up_to, "windows: one reaches beyond eigenvalues_up_to");
    expect(window.most > 0 && window.least <= window.most, "windows: not least <= most, most >= 1");
    expect(window.least == window.most || (window.smallest == window.in && window.greatest == window.in),
           "windows: an eigenvalue is enclosed although their number is not known");
    expect(window.smallest[0] == window.in[0] && window.smallest[1] <= window.in[1],
           "smallest: not the lower part of in");
    expect(window.greatest[1] == window.in[1] && window.greatest[0] >= window.in[0],
           "greatest: not the upper part of in");
    before = &window;
  }
}

/// Whether a function is positive on a range: on parts of it that are halved until that is certain, or until it
/// certainly is not in some point. `enclose` contains its values on a part.
template <class Enclose>
Answer is_positive(const Range& range, const Enclose& enclose) {
  constexpr int kMostParts = 4000;
  const auto positive_on = [&](const Range& part) { return is_less(0, enclose(part)); };
  std::vector<Range> open{range};
  for (int parts = 0; !open.empty(); ++parts) {
    if (parts == kMostParts) return Answer::unknown;
    const Range part = std::move(open.back());
    open.pop_back();
    if (positive_on(part) == Answer::yes) continue;
    const mpq_class centre = (part[0] + part[1]) / 2;
    for (const mpq_class& point : {part[0], centre, part[1]}) {
      if (positive_on({point, point}) == Answer::no) return Answer::no;
    }
    if (part[0] == part[1]) return Answer::unknown;
    open.push_back({centre, part[1]});
    open.push_back({part[0], centre});
  }
  return Answer::yes;
}

/// What follows for windows from statements that are true (Lemma 37).
class Counting {
 public:
  explicit Counting(const Document& document) : document_(document), by_end_(document.at_most) {
    std::sort(by_end_.begin(), by_end_.end(), [](const auto& x, const auto& y) { return x.in[1] < y.in[1]; });
  }

  void check() const {
    mpq_class end = 0;
    for (std::size_t i = 0; i < document_.windows.size(); ++i) {
      const Document::Window& window = document_.windows[i];
      const std::string name = "window " + number(i);
      if (!none_between(end, window.in[0])) throw Refutation{"no statement says that nothing lies before " + name};
      check(window, name);
      end = window.in[1];
    }
    if (!none_between(end, document_.up_to)) throw Refutation{"no statement says that nothing lies behind the windows"};
  }

 private:
  void check(const Document::Window& window, const std::string& name) const {
    const auto& [in, least, most, smallest, greatest] = window;
    if (!at_most(in, most)) throw Refutation{name + " may have more eigenvalues"};
    if (least > 0 && !at_least(in, least)) throw Refutation{name + " may have fewer eigenvalues"};
    if (smallest[1] < in[1] && !not_all_in({smallest[1], in[1]}, in, most))
      throw Refutation{name + ": the smallest eigenvalue may be greater"};
    if (in[0] < greatest[0] && !not_all_in({in[0], greatest[0]}, in, most))
      throw Refutation{name + ": the greatest eigenvalue may be smaller"};
  }

  /// Whether statements that cover the range allow at most so many.
  [[nodiscard]] bool at_most(const Range& range, std::uint64_t count) const {
    // Covered from the lower end of the range to where, and the least sum of counts for that.
    std::vector<std::pair<mpq_class, std::uint64_t>> covered{{range[0], 0}};
    for (const Document::AtMost& row : by_end_) {
      std::optional<std::uint64_t> least;
      for (const auto& [end, sum] : covered) {
        if (row.in[0] <= end && (!least || sum < *least)) least = sum;
      }
      if (!least) continue;
      if (row.in[1] >= range[1] && *least + row.count <= count) return true;
      covered.emplace_back(row.in[1], *least + row.count);
    }
    return false;
  }
  [[nodiscard]] bool none_between(const mpq_class& lower, const mpq_class& upper) const {
    return lower >= upper || at_most({lower, upper}, 0);
  }
  [[nodiscard]] bool at_least(const Range& window, Index count) const {
    if (count <= disjoint(document_, [&](const Range& in) { return contains(window, in); }).size()) return true;
    return std::any_of(document_.at_least.begin(), document_.at_least.end(), [&](const Document::AtLeast& row) {
      return row.count >= count && contains(window, row.within) && none_between(row.in[0], row.within[0]) &&
             none_between(row.within[1], row.in[1]);
    });
  }
  /// Whether not all of the `count` eigenvalues in the window are in this part of it.
  [[nodiscard]] bool not_all_in(const Range& part, const Range& window, Index count) const {
    return at_most(part, std::uint64_t{count} - 1) ||
           !disjoint(document_, [&](const Range& in) { return contains(window, in) && are_apart(in, part); }).empty() ||
           std::any_of(document_.at_least.begin(), document_.at_least.end(), [&](const Document::AtLeast& row) {
             return row.count > count && contains(row.within, part) && none_between(row.in[0], window[0]) &&
                    none_between(window[1], row.in[1]);
           });
  }

  const Document& document_;
  std::vector<Document::AtMost> by_end_;
};

template <class R>
class EigenvalueRules {
 public:
  EigenvalueRules(const Document& document, NetRules<R>& net, long most_lifts)
      : document_(document), spectrum_(document.spectrum, net, most_lifts), values_left_(most_lifts) {
    check_structure(document);
  }

  [[nodiscard]] std::vector<Rule> rules() {
    std::vector<Rule> rules = spectrum_.rules();
    rules.push_back({"traces", [this] { check_traces(); }});
    rules.push_back({"most", [this] { check_most(); }});
    rules.push_back({"least", [this] { check_least(); }});
    rules.push_back({.name = "eigenfunctions", .ask = [this] { check_eigenfunctions(); }, .may_be_open = true});
    rules.push_back({"windows", [this] { Counting(document_).check(); }});
    return rules;
  }

 private:
  using Sums = std::array<Interval, 3>;

  static void expect_yes(Answer answer, std::size_t row) {
    const std::string name = "statement " + number(row);
    if (answer == Answer::no) throw Refutation{name + " does not follow from its coefficients"};
    if (answer == Answer::unknown) throw TooLarge{name + " is not decided by the digits used"};
  }

  void check_traces() {
    std::vector<Interval> lengths;
    for (const HalfLength<R>& x : spectrum_.lengths())
      lengths.push_back(2 * arsinh(sqrt(enclosure(x.numerator) / enclosure(x.denominator))));
    const TraceFormula formula(document_, lengths, minus_euler());
    for (const auto& row : document_.at_most) of_at_most_.push_back(formula.sums(row.coefficients));
    for (const auto& row : document_.at_least) of_at_least_.push_back(formula.sums(row.coefficients));
    for (const std::vector<Sums>& rows : {of_at_most_, of_at_least_}) {
      for (const Sums& sums : rows) {
        if (!decided(is_less(0, sums[0]), "whether a sum of squares is positive"))
          throw Refutation{"a sum of squares over all eigenvalues would be negative"};
      }
    }
  }

  /// 2g − 2
  [[nodiscard]] long minus_euler() const {
    const Net& net = document_.spectrum.net;
    return static_cast<long>(net.triangles.size() / 2) - static_cast<long>(net.vertices.size());
  }

  /// F_0, without what known eigenvalues elsewhere add, < (count + 1) f² in the whole range.
  void check_most() const {
    for (std::size_t i = 0; i < document_.at_most.size(); ++i) {
      const auto& [in, count, coefficients] = document_.at_most[i];
      const TestFunction function(document_, coefficients);
      Interval sum = of_at_most_[i][0];
      const mpq_class greatest = greatest_eigenvalue(document_);
      const auto counts = [&, &range = in](const Range& known) {
        return are_apart(known, range) && known[1] <= greatest;
      };
      for (const Range& known : disjoint(document_, counts)) sum = sum - function.squared_on(known);
      const auto margin = [&, most = static_cast<long>(count)](const Range& part) {
        return (most + 1) * function.squared_on(part) - sum;
      };
      expect_yes(is_positive(in, margin), i);
    }
  }

  /// The sum of P f² is more than (count − 1) P f² in the whole range.
  void check_least() const {
    for (std::size_t i = 0; i < document_.at_least.size(); ++i) {
      const auto& [in, within, count, coefficients] = document_.at_least[i];
      const Sums& f = of_at_least_[i];
      const Interval sigma(in[0]);
      const Interval rho(in[1]);
      const Interval sum = in[0] == 0 ? rho * f[0] - f[1] : (rho + sigma) * f[1] - f[2] - rho * sigma * f[0];
      const TestFunction function(document_, coefficients);
      const bool from_zero = in[0] == 0;
      const auto margin = [&, least = static_cast<long>(count)](const Range& part) {
        const Interval lambda = hull(Interval(part[0]), Interval(part[1]));
        const Interval weight = from_zero ? rho - lambda : (rho - lambda) * (lambda - sigma);
        return sum - (least - 1) * weight * function.squared_on(part);
      };
      expect_yes(is_positive(within, margin), i);
    }
  }

  /// [λ − δ, λ + δ] is a part of the range of each function.
  void check_eigenfunctions() {
    const std::vector<Function>& rows = document_.eigenfunctions;
    std::vector<NearLifts> near;
    for (const Function& row : rows) {
      near.push_back(near_lifts(row.radius));
      values_left_ -= static_cast<long>(values_needed(row, near.back()));
      if (values_left_ < 0) throw LeftOut{"so many eigenfunctions"};
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Function& row = rows[i];
      const Interval error = eigenvalue_error(row, document_.spectrum.net.epsilon, near[i], minus_euler());
      const Interval lambda(row.lambda);
      if (is_less(lambda - error, Interval(row.in[0])) != Answer::no ||
          is_less(Interval(row.in[1]), lambda + error) != Answer::no)
        give_up("function " + number(i) + " does not prove an eigenvalue in its interval");
    }
  }

  /// Those nearer than ε + R to a vertex.
  [[nodiscard]] NearLifts near_lifts(const mpq_class& radius) {
    Loops<R>& loops = spectrum_.loops();
    const Interval reach = square(sinh(Interval(document_.spectrum.net.epsilon + radius) / 2));
    NearLifts near(document_.spectrum.net.vertices.size());
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
  GeodesicRules<R> spectrum_;
  long values_left_;  ///< Of eigenfunctions.
  std::vector<Sums> of_at_most_;
  std::vector<Sums> of_at_least_;
};

}  // namespace

template <class R>
std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<R>& net, long most_lifts) {
  const auto rules = std::make_shared<EigenvalueRules<R>>(document, net, most_lifts);
  return kept(rules, rules->rules());
}

template std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<mpz_class>& net, long);
template std::vector<Rule> eigenvalue_rules(const EigenvaluesDocument& document, NetRules<Algebraic>& net, long);

}  // namespace epsnet::exact
