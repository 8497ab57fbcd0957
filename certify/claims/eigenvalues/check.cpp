#include "certify/claims/eigenvalues/check.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "certify/base/counted.h"
#include "certify/base/text.h"
#include "certify/claims/eigenvalues/counting.h"
#include "certify/claims/eigenvalues/eigenfunction.h"
#include "certify/claims/eigenvalues/test_function.h"
#include "certify/claims/eigenvalues/trace_forms.h"
#include "certify/claims/geodesics/check.h"
#include "certify/claims/geodesics/geodesics_rules.h"
#include "certify/claims/net/claim.h"
#include "certify/lifted/lorentz.h"
#include "certify/numbers/precision.h"
#include "certify/verdict/open_rules.h"

namespace epsnet::certify {
namespace {

using AtMost = EigenvaluesDocument::AtMost;
using AtLeast = EigenvaluesDocument::AtLeast;
using Eigenfunction = EigenvaluesDocument::Eigenfunction;
using Forms = std::array<Ball, 3>;

constexpr const char* kTraces = "traces";
constexpr const char* kMost = "most";
constexpr const char* kLeast = "least";
constexpr const char* kEigenfunctions = "eigenfunctions";
constexpr const char* kWindows = "windows";

/// Test functions grow with L to some 10¹⁰ times their values at the eigenvalues.
constexpr slong kFirstBits = 192;
/// Coefficients of eigenfunctions have the 53 bits of binary64, and little is lost: many more bits prove no more.
constexpr slong kFirstBitsOfFunctions = 128;
constexpr slong kMostBitsOfFunctions = 512;

RuleNames rules_beyond_the_spectrum() { return {kTraces, kMost, kLeast, kEigenfunctions, kWindows}; }

/// Sum of P(λ) f̂(λ)² over all eigenvalues: P = ρ − λ for σ = 0, otherwise (ρ − λ)(λ − σ).
Ball weighted_sum(const Forms& forms, Interval in) {
  const Ball rho = Ball::exactly(in.upper);
  if (in.lower == 0) return rho * forms[0] - forms[1];
  const Ball sigma = Ball::exactly(in.lower);
  return (rho + sigma) * forms[1] - forms[2] - rho * sigma * forms[0];
}

/// P on an interval.
Ball weight(Interval in, Interval lambda) {
  const Ball x = ball_of(arb_union, Ball::exactly(lambda.lower), Ball::exactly(lambda.upper));
  const Ball below = Ball::exactly(in.upper) - x;
  return in.lower == 0 ? below : below * (x - Ball::exactly(in.lower));
}

class EigenvaluesCheck {
 public:
  EigenvaluesCheck(const EigenvaluesDocument& document, Verification& run, const LabelParts& parts)
      : document_(document),
        options_(run.options()),
        threads_(run.threads()),
        budget_(run.budget()),
        genus_(static_cast<std::uint32_t>(run.certificate().counts.genus)),
        functions_(test_functions(document)),
        net_(with_geodesics_as_labels(document)),
        evaluator_(net_, parts),
        rules_(rules_beyond_the_spectrum()) {}

  void ask(Verification& run) {
    try {
      check_windows();
      with_rising_precision(
          options_.max_precision,
          [&](slong precision) {
            pass(precision);
            run.used(static_cast<std::uint64_t>(precision));
            return !rules_.open(kTraces) && !rules_.open(kMost) && !rules_.open(kLeast);
          },
          kFirstBits);
      with_rising_precision(
          std::min(options_.max_precision, kMostBitsOfFunctions),
          [&](slong precision) {
            run.used(static_cast<std::uint64_t>(precision));
            return check_eigenfunctions(precision);
          },
          kFirstBitsOfFunctions);
    } catch (const BudgetSpent& spent) {
      rules_.give_up(spent.what());
    }
    rules_.conclude(run);
  }

 private:
  void check_windows() {
    const std::uint64_t statements =
        document_.at_most.size() + document_.at_least.size() + document_.eigenfunctions.size() + 1;
    budget_.spend(10 * (document_.windows.size() + 1) * statements, statements * statements);
    const auto problem = Counting(document_).problem();
    rules_.report({kWindows, problem ? Verdict::refuted : Verdict::verified,
                   problem ? *problem
                           : counted(document_.windows.size(), "window", "windows") +
                                 ", and no eigenvalue elsewhere up to " + shortest(document_.eigenvalues_up_to)});
  }

  /// All open rules at one precision.
  void pass(slong precision) {
    if (options_.progress) options_.progress(kTraces, 0);
    const std::string bits = std::to_string(precision) + " bits";
    const auto trace_forms = TraceForms::of(functions_, genus_, lengths(precision), budget_);
    if (!trace_forms) return rules_.doubt(kTraces, "not decided where multiples of lengths lie, with " + bits);
    check_traces(*trace_forms);
    if (rules_.verdict(kTraces) != Verdict::verified) return;
    check(kMost, document_.at_most, bits,
          [&](const AtMost& row) { return at_most(row, (*trace_forms)(row.coefficients)); });
    check(kLeast, document_.at_least, bits,
          [&](const AtLeast& row) { return at_least(row, (*trace_forms)(row.coefficients)); });
  }

  /// False if more bits may help.
  bool check_eigenfunctions(slong precision) {
    const std::vector<Eigenfunction>& rows = document_.eigenfunctions;
    const std::vector<BallIsometry> labels = elements(1, document_.net.labels.size(), precision);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (options_.progress)
        options_.progress(kEigenfunctions, static_cast<double>(i) / static_cast<double>(rows.size()));
      const std::string function = "function " + std::to_string(i);
      const auto error = eigenvalue_error(document_, rows[i], labels, genus_, budget_, threads_);
      if (!error) {
        rules_.doubt(kEigenfunctions, function + " is not decided, with " + std::to_string(precision) + " bits");
        return false;
      }
      if (!is_finite(*error)) {
        rules_.doubt(kEigenfunctions, function + " proves no eigenvalue");
        return true;
      }
      const Ball lambda = Ball::exactly(rows[i].lambda);
      const auto below = [](const Ball& x, const Ball& y) { return certainly_less(y, x) == Tri::no; };
      if (!below(Ball::exactly(rows[i].in.lower), lambda - *error) ||
          !below(lambda + *error, Ball::exactly(rows[i].in.upper))) {
        rules_.doubt(kEigenfunctions, function + " proves an eigenvalue only within " +
                                          shortest(outer_interval(*error).upper) + " of its lambda");
        return true;
      }
    }
    rules_.report({kEigenfunctions, Verdict::verified, counted(rows.size(), "function", "functions")});
    return true;
  }

  /// The values of labels from this number on: those of the net from 1 on, and then the geodesics.
  [[nodiscard]] std::vector<BallIsometry> elements(std::size_t first, std::size_t count, slong precision) const {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(first));
    return evaluator_.evaluate(numbers, precision, 4 * precision, threads_);
  }

  /// Of the geodesics, from their words.
  [[nodiscard]] std::vector<Ball> lengths(slong precision) const {
    std::vector<Ball> result;
    for (const BallIsometry& element : elements(document_.net.labels.size() + 1, document_.geodesics.size(), precision))
      result.push_back(twice(acosh(cosh_half_length(element))));
    return result;
  }

  void check_traces(const TraceForms& trace_forms) {
    std::vector<Forms> forms;
    for (const AtMost& row : document_.at_most) forms.push_back(trace_forms(row.coefficients));
    for (const AtLeast& row : document_.at_least) forms.push_back(trace_forms(row.coefficients));
    rules_.report(traces_report(forms));
  }

  template <class Row, class Holds>
  void check(const char* rule, const std::vector<Row>& rows, const std::string& bits, const Holds& holds) {
    if (!rules_.open(rule)) return;
    std::string doubt;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (options_.progress) options_.progress(rule, static_cast<double>(i) / static_cast<double>(rows.size()));
      const Tri answer = holds(rows[i]);
      if (answer == Tri::yes) continue;
      const std::string statement = "statement " + std::to_string(i);
      if (answer == Tri::no)
        return rules_.report({rule, Verdict::refuted, statement + " does not follow from its coefficients"});
      if (doubt.empty()) doubt = statement + " is not decided, with " + bits;
    }
    if (!doubt.empty()) return rules_.doubt(rule, doubt);
    rules_.report({rule, Verdict::verified, counted(rows.size(), "statement", "statements")});
  }

  /// F₀ < (count + 1)·f̂² on the interval, where F₀ is without what known eigenvalues elsewhere add to it.
  [[nodiscard]] Tri at_most(const AtMost& row, const Forms& forms) const {
    const SquaredTestFunction square(functions_, row.coefficients);
    Ball sum = forms[0];
    for (const Interval& known : known_outside(row.in)) {
      spend(square);
      sum = sum - square.on(known);
    }
    return is_positive_on(row.in, [&](Interval part) {
      spend(square);
      return (std::uint64_t{row.count} + 1) * square.on(part) - sum;
    });
  }

  /// Disjoint intervals of eigenfunctions outside of this one, in which test functions can be enclosed.
  [[nodiscard]] std::vector<Interval> known_outside(Interval in) const {
    const mpq_class greatest = greatest_eigenvalue(functions_);
    std::vector<Interval> result;
    for (const Eigenfunction& row : document_.eigenfunctions) {
      const bool outside = row.in.upper < in.lower || in.upper < row.in.lower;
      if (outside && mpq_class(row.in.upper) <= greatest) result.push_back(row.in);
    }
    budget_.spend(10, document_.eigenfunctions.size());
    return disjoint(std::move(result));
  }

  /// The sum of P f̂² is more than (count − 1)·P f̂² on the interval `within`.
  [[nodiscard]] Tri at_least(const AtLeast& row, const Forms& forms) const {
    const SquaredTestFunction square(functions_, row.coefficients);
    const Ball sum = weighted_sum(forms, row.in);
    return is_positive_on(row.within, [&](Interval part) {
      spend(square);
      return sum - (row.count - 1) * weight(row.in, part) * square.on(part);
    });
  }

  void spend(const SquaredTestFunction& square) const {
    budget_.spend(ball_work(static_cast<std::uint64_t>(Precision::bits())), square.operations());
  }

  const EigenvaluesDocument& document_;
  const CheckOptions& options_;
  unsigned threads_;
  const Budget& budget_;
  std::uint32_t genus_;
  TestFunctions functions_;
  NetDocument net_;
  LabelEvaluator evaluator_;
  OpenRules rules_;
};

std::string text_of(const EigenvaluesDocument& document) {
  std::uint64_t least = 0;
  std::uint64_t most = 0;
  for (const EigenvaluesDocument::Window& window : document.windows) {
    least += window.least;
    most += window.most;
  }
  return "eigenvalues of the Laplacian: " + (least == most ? "" : "from " + std::to_string(least) + " to ") +
         std::to_string(most) + " in (0, " + shortest(document.eigenvalues_up_to) + "], with multiplicity, in " +
         counted(document.windows.size(), "interval", "intervals");
}

}  // namespace

RuleNames own_rules(const EigenvaluesDocument& /*document*/) {
  GeodesicsDocument spectrum;
  spectrum.claim = GeodesicsDocument::Claim::spectrum;
  RuleNames rules = own_rules(spectrum);
  for (const std::string_view rule : rules_beyond_the_spectrum()) rules.push_back(rule);
  return rules;
}

Claim claim_of(const EigenvaluesDocument& document) {
  const auto ask = [&](Verification& run, Crossings crossings) {
    const LabelParts parts = ask_geodesics_rules(document, run, std::move(crossings));
    if (run.rules().verified_so_far()) EigenvaluesCheck(document, run, parts).ask(run);
  };
  return {document.net, text_of(document), own_rules(document), ask};
}

}  // namespace epsnet::certify
