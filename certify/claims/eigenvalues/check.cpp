#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/eigenfunction.h"
#include "certify/claims/eigenvalues/enclosures.h"
#include "certify/claims/eigenvalues/fields.h"
#include "certify/claims/eigenvalues/forms.h"
#include "certify/claims/net/claim.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/inertia.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

using Document = EigenvaluesDocument;

constexpr std::uint32_t kMostHalvings = 12;
constexpr std::size_t kMostFunctions = 1000;
constexpr std::size_t kGreatestOrder = 200;

bool is_positive(double x) { return std::isfinite(x) && x > 0; }

/// Whether x and y, both finite, are the ends of an interval in [0, ∞).
bool in_order(double x, double y) { return std::isfinite(x) && std::isfinite(y) && 0 <= x && x <= y; }

Problem order_problem(const std::string& name, const Document::Order& order, bool is_needed, std::uint64_t size) {
  const std::uint64_t expected = is_needed ? size : 0;
  if (order.size() != expected)
    return name + ": " + std::to_string(order.size()) + " elements, expected " + std::to_string(expected);
  std::vector<bool> seen(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] >= order.size() || seen[order[i]]) {
      return at(name.c_str(), i) + std::to_string(order[i]) +
             (order[i] < order.size() ? " occurs twice" : " does not exist") + ", expected a permutation of 0 to " +
             std::to_string(order.size() - 1);
    }
    seen[order[i]] = true;
  }
  return std::nullopt;
}

Problem enclosure_problem(const Document::Enclosure& row) {
  if (!in_order(row.in.lower, row.in.upper)) return "in is not 0 <= lo <= hi";
  if (row.count == 0) return "the count is 0";
  return std::nullopt;
}

Problem at_most_problem(const Document::AtMost& row) {
  if (!is_positive(row.below) || !std::isfinite(row.sigma) || row.sigma < row.below)
    return "below and sigma are not 0 < below <= sigma";
  return std::nullopt;
}

Problem at_least_problem(const Document::AtLeast& row) {
  if (!is_positive(row.below)) return "below is not positive";
  if (row.count == 0) return "the count is 0";
  return std::nullopt;
}

Problem function_problem(const Document::Coefficients& coefficients, std::size_t size) {
  if (coefficients.size() != size) return "another number of coefficients than the first function of the row";
  if (!std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return std::isfinite(c); }))
    return "a coefficient is not finite";
  if (std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return c == 0; }))
    return "all coefficients are 0";
  return std::nullopt;
}

Problem eigenfunctions_problem(const NetDocument& net, const Document::Eigenfunctions& row) {
  const auto& [in, lambda, radius, functions] = row;
  if (!in_order(in.lower, lambda) || !in_order(lambda, in.upper) || in.lower == 0)
    return "lambda is not in in, or in is not 0 < lo <= hi";
  if (!std::isfinite(radius) || radius >= 2 || mpq_class(radius) <= decimal(net.epsilon))
    return "radius is not more than epsilon and less than 2";
  if (functions.empty() || functions.size() > kMostFunctions)
    return std::to_string(functions.size()) + " functions, expected 1 to " + std::to_string(kMostFunctions);
  const std::size_t vertices = net.vertices.size();
  const std::size_t size = functions.front().size();
  const std::size_t each = size / std::max<std::size_t>(vertices, 1);
  if (size != each * vertices || each % 2 == 0 || each < 3 || each > 2 * kGreatestOrder + 1) {
    return std::to_string(size) + " coefficients, expected 2M + 1 for each of " + std::to_string(vertices) +
           " vertices, M from 1 to " + std::to_string(kGreatestOrder);
  }
  return first_row_problem("functions", functions,
                           [&](const Document::Coefficients& c) { return function_problem(c, size); });
}

}  // namespace

Problem structure_problem(const Document& document) {
  if (auto problem = whole_net_problem(document.net)) return problem;
  if (document.halvings > kMostHalvings) {
    return "halvings: " + std::to_string(document.halvings) + " is not a number from 0 to " +
           std::to_string(kMostHalvings);
  }
  if (!document.phases.empty()) {
    if (auto problem = phases_problem(document.phases, SurfaceSides(document.net.surface).partner.size()))
      return problem;
    if (!document.eigenfunctions.empty()) return "eigenfunctions: not empty, although there are phases";
  }
  if (document.box) {
    if (document.phases.empty()) return "box: there are no phases";
    if (auto problem = box_problem(*document.box, document.net, document.phases.size())) return problem;
  }
  const HalvedSizes sizes = halved_sizes(document.net, document.halvings);
  if (auto problem = order_problem("side_order", document.side_order, !document.at_most.empty(), sizes.sides))
    return problem;
  if (auto problem = order_problem("vertex_order", document.vertex_order, !document.at_least.empty(), sizes.vertices))
    return problem;
  if (auto problem = first_row_problem("eigenvalues", document.eigenvalues, enclosure_problem)) return problem;
  if (!in_order(0, document.next)) return "next: not a number of at least 0";
  if (auto problem = first_row_problem("at_most", document.at_most, at_most_problem)) return problem;
  if (auto problem = first_row_problem("at_least", document.at_least, at_least_problem)) return problem;
  const auto& rows = document.eigenfunctions;
  if (auto problem = first_row_problem("eigenfunctions", rows, [&](const Document::Eigenfunctions& row) {
        return eigenfunctions_problem(document.net, row);
      })) {
    return problem;
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].in.lower <= rows[i - 1].in.upper)
      return at("eigenfunctions", i) + "in does not begin after that of the row before";
  }
  return std::nullopt;
}

std::uint64_t least_bytes(const Document& document) {
  std::uint64_t bytes = least_bytes(document.net) + 100 + 20 * document.eigenvalues.size() +
                        2 * (document.side_order.size() + document.vertex_order.size()) + 35 * document.at_most.size() +
                        20 * document.at_least.size();
  for (const std::string& phase : document.phases) bytes += 3 + phase.size();
  if (document.box) {
    bytes += document.box->radius.size();
    for (const Document::Direction& direction : document.box->directions)
      bytes += 20 + 2 * (direction.steps.size() + direction.heights.size());
  }
  for (const Document::Eigenfunctions& row : document.eigenfunctions) {
    bytes += 50;
    for (const Document::Coefficients& coefficients : row.functions) bytes += 2 + 2 * coefficients.size();
  }
  return bytes;
}

namespace {

using AtMost = EigenvaluesDocument::AtMost;
using AtLeast = EigenvaluesDocument::AtLeast;
using Eigenfunctions = EigenvaluesDocument::Eigenfunctions;

constexpr const char* kPhases = "phases";
constexpr const char* kBox = "box";
constexpr const char* kMost = "most";
constexpr const char* kLeast = "least";
constexpr const char* kEigenfunctions = "eigenfunctions";
constexpr const char* kEnclosures = "enclosures";

/// Entries of matrices have errors far below those of binary64.
constexpr slong kBitsOfMatrices = 128;
/// Coefficients of eigenfunctions have the 53 bits of binary64, and little is lost: many more bits prove no more.
constexpr slong kFirstBitsOfFunctions = 128;
constexpr slong kMostBitsOfFunctions = 512;

struct RoundedForm {
  explicit RoundedForm(const SymmetricForm& form)
      : square{Rounded(form.square[0]), Rounded(form.square[1]), Rounded(form.square[2])},
        product{Rounded(form.product[0]), Rounded(form.product[1]), Rounded(form.product[2])} {}
  std::array<Rounded, 3> square;
  std::array<Rounded, 3> product;
};

/// A triangle's part of a matrix 𝒜 − σ𝒩.
struct TriangleForms {
  RoundedForm energy;
  RoundedForm mass;
};

/// The entries of the real symmetric matrix of a Hermitian form (docs/proof.md, section 17.3): of as many rows if all
/// phases are multiples of ½, otherwise of two for each.
class HermitianForm {
 public:
  /// A sum over so many triangles.
  HermitianForm(const LineBundle& bundle, const Budget& budget, std::size_t triangles)
      : bundle_(bundle), budget_(budget) {
    const std::uint64_t entries = multiple_of_rows() == 1 ? 6 : 18;
    budget.require(memory_work(sizeof(MatrixEntry) * entries), triangles);
    entries_.reserve(entries * triangles);
  }

  /// By how much there are more rows, and more negative eigenvalues, than of the form.
  [[nodiscard]] std::uint32_t multiple_of_rows() const { return bundle_.denominator() <= 2 ? 1 : 2; }

  /// Adds x e^{2πiφ} at the place of x, and its conjugate at the opposite one; on the diagonal its real part.
  void add(const MatrixEntry& x, Phase phase) {
    if (multiple_of_rows() == 1) {
      entries_.push_back(x);
      if (phase != 0) entries_.back().value = -x.value;  // Half a turn.
      return;
    }
    const Turn& turn = turn_of(phase);
    if (turn.cosine) add_twice(multiple_of(x, *turn.cosine));
    if (turn.sine && x.row != x.column) add_across(multiple_of(x, *turn.sine));
  }

  /// Of so many rows.
  [[nodiscard]] SparseMatrix matrix(std::size_t rows) && {
    return {multiple_of_rows() * static_cast<std::uint32_t>(rows), std::move(entries_)};
  }

 private:
  /// Nothing: exactly 0.
  struct Turn {
    std::optional<Rounded> cosine;
    std::optional<Rounded> sine;
  };

  static std::optional<Rounded> unless_zero(const Ball& x) {
    return is_exactly_zero(x) ? std::nullopt : std::optional<Rounded>(x);
  }

  const Turn& turn_of(Phase phase) {
    const auto found = turns_.find(phase);
    if (found != turns_.end()) return found->second;
    budget_.spend(function_work(static_cast<std::uint64_t>(Precision::bits())) + memory_work(100));
    const ComplexBall turn = bundle_.turn(phase);
    return turns_.emplace(phase, Turn{unless_zero(real(turn)), unless_zero(imaginary(turn))}).first->second;
  }

  void add_twice(const MatrixEntry& x) {
    for (const std::uint32_t part : {0U, 1U})
      entries_.push_back({2 * x.row + part, 2 * x.column + part, x.value, x.error});
  }
  void add_across(const MatrixEntry& x) {
    entries_.push_back({2 * x.row + 1, 2 * x.column, x.value, x.error});
    entries_.push_back({2 * x.row, 2 * x.column + 1, -x.value, x.error});
  }

  const LineBundle& bundle_;
  const Budget& budget_;
  std::map<Phase, Turn> turns_;
  std::vector<MatrixEntry> entries_;
};

class EigenvaluesCheck {
 public:
  EigenvaluesCheck(const EigenvaluesDocument& document, Verification& run, Crossings crossings)
      : document_(document),
        run_(run),
        threads_(run.threads()),
        budget_(run.budget()),
        parts_(label_parts(std::move(crossings), document.net.charts, run.budget())),
        evaluator_(document.net, parts_),
        bundle_(document.phases),
        left_out_(document.phases.empty() ? 1 : 0) {}

  void ask() {
    // Of no line bundle there are no eigenvalues.
    if (!document_.phases.empty() && run_.report(check_phases()) != Verdict::verified) return;
    if (document_.box && run_.report(check_box()) != Verdict::verified) return;
    run_.report(check_most());
    run_.report(check_least());
    run_.report(check_eigenfunctions());
    const auto problem = CountedEigenvalues(document_, distance_).problem();
    run_.report(problem ? RuleReport{kEnclosures, Verdict::refuted, *problem}
                        : RuleReport{kEnclosures, Verdict::verified,
                                     counted(document_.eigenvalues.size(), "interval", "intervals")});
  }

 private:
  using Numbers = std::vector<std::array<std::uint32_t, 3>>;
  using Phases = std::vector<std::array<Phase, 3>>;

  [[nodiscard]] RuleReport check_phases() const {
    if (const auto problem = bundle_.problem(SurfaceSides(document_.net.surface)))
      return {kPhases, Verdict::refuted, *problem};
    return {kPhases, Verdict::verified,
            "a flat line bundle, phases in multiples of 1/" + std::to_string(bundle_.denominator())};
  }

  RuleReport check_box() {
    if (const auto problem = homomorphism_problem(*document_.box, SurfaceSides(document_.net.surface)))
      return {kBox, Verdict::refuted, *problem};
    const Precision scope(kBitsOfMatrices);
    const auto distance = root_distance(document_, evaluated_labels(), budget_);
    if (!distance) return no_triangle(kBox);
    distance_ = upper_end(*distance);
    if (!std::isfinite(distance_)) return {kBox, Verdict::undecided, "the slopes are not known"};
    return {kBox, Verdict::verified,
            "roots of eigenvalues are at most " + decimal_above(distance_, 3) + " from those in the centre"};
  }

  RuleReport check_most() {
    if (document_.at_most.empty()) return nothing_to_count(kMost);
    const Precision scope(kBitsOfMatrices);
    Ball interpolation;
    std::vector<std::vector<Ball>> constants(document_.net.triangles.size());
    const auto forms = triangle_forms([&](std::size_t t, const FlatTriangle& triangle) {
      constants[t].push_back(triangle.interpolation_constant());
      return TriangleForms{RoundedForm(triangle.least_energy()), RoundedForm(triangle.greatest_mass())};
    });
    if (!forms) return no_triangle(kMost);
    for (const std::vector<Ball>& of_triangle : constants) {
      for (const Ball& constant : of_triangle) interpolation = max(interpolation, constant);
    }
    const HalvedNet halved = halved_net(document_.net, document_.halvings, bundle_);
    const auto& rows = document_.at_most;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      progress(kMost, i, rows.size());
      const Ball sigma = Ball::exactly(rows[i].sigma);
      const Ball reached = sigma / (1 + interpolation * sigma);
      if (certainly_less(reached, Ball::exactly(rows[i].below)) != Tri::no) {
        return undecided(
            kMost, i,
            "the eigenvalues that are counted are those less than " + decimal_below(outer_interval(reached).lower));
      }
      const std::uint64_t most = std::uint64_t{rows[i].count} + left_out_;
      const auto negative =
          negative_eigenvalues(*forms, opposite_to_corners(halved.sides), opposite_to_corners(halved.side_phases),
                               document_.side_order, rows[i].sigma, Bound::upper, most);
      if (!negative) return undecided(kMost, i, kTooNear);
      if (*negative > most) return undecided(kMost, i, "at most " + std::to_string(*negative - left_out_) + " follows");
    }
    return {kMost, Verdict::verified, counted(rows.size(), "count", "counts")};
  }

  RuleReport check_least() {
    if (document_.at_least.empty()) return nothing_to_count(kLeast);
    const Precision scope(kBitsOfMatrices);
    const auto forms = triangle_forms([&](std::size_t, const FlatTriangle& triangle) {
      return TriangleForms{RoundedForm(triangle.greatest_energy()), RoundedForm(triangle.least_mass())};
    });
    if (!forms) return no_triangle(kLeast);
    const HalvedNet halved = halved_net(document_.net, document_.halvings, bundle_);
    const auto& rows = document_.at_least;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      progress(kLeast, i, rows.size());
      const std::uint64_t least = std::uint64_t{rows[i].count} + left_out_;
      const auto negative = negative_eigenvalues(*forms, halved.vertices, halved.vertex_phases, document_.vertex_order,
                                                 rows[i].below, Bound::lower, least);
      if (!negative) return undecided(kLeast, i, kTooNear);
      if (*negative < least) {
        return undecided(kLeast, i,
                         *negative <= left_out_ ? "nothing follows"
                                                : "at least " + std::to_string(*negative - left_out_) + " follows");
      }
    }
    return {kLeast, Verdict::verified, counted(rows.size(), "count", "counts")};
  }

  RuleReport check_eigenfunctions() {
    const auto& rows = document_.eigenfunctions;
    std::string doubt;
    for (slong bits = kFirstBitsOfFunctions; bits <= kMostBitsOfFunctions; bits *= 2) {
      const auto open = open_eigenfunction(bits, doubt);
      if (!open) return {kEigenfunctions, Verdict::verified, counted(rows.size(), "row", "rows")};
      if (*open == Tri::no) break;
    }
    return {kEigenfunctions, Verdict::undecided, doubt};
  }

  /// Nothing if all rows are proved; `unknown` if more bits may help.
  std::optional<Tri> open_eigenfunction(slong bits, std::string& doubt) {
    const Precision scope(bits);
    const auto& rows = document_.eigenfunctions;
    const std::vector<BallIsometry> labels = evaluated_labels();
    std::optional<Overlaps> overlaps;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      progress(kEigenfunctions, i, rows.size());
      const std::string row = "eigenfunctions[" + std::to_string(i) + "]: ";
      if (i == 0 || !same_disks(rows[i], rows[i - 1])) overlaps = overlaps_from(i, labels);
      const auto error = overlaps
                             ? eigenvalue_error(*overlaps, rows[i], run_.certificate().counts.genus, budget_, threads_)
                             : std::nullopt;
      if (!error) {
        doubt = row + "not decided, with " + std::to_string(bits) + " bits";
        return Tri::unknown;
      }
      if (!std::isfinite(*error)) {
        doubt = row + "no eigenvalue follows";
        return Tri::no;
      }
      const Ball lambda = Ball::exactly(rows[i].lambda);
      const auto at_most = [](const Ball& x, const Ball& y) { return certainly_less(y, x) == Tri::no; };
      if (!at_most(Ball::exactly(rows[i].in.lower), lambda - Ball::exactly(*error)) ||
          !at_most(lambda + Ball::exactly(*error), Ball::exactly(rows[i].in.upper))) {
        doubt = row + "eigenvalues are proved only within " + decimal_above(*error, 11) + " of lambda";
        return Tri::no;
      }
    }
    return std::nullopt;
  }

  static bool same_disks(const Eigenfunctions& x, const Eigenfunctions& y) {
    return x.radius == y.radius && x.functions.front().size() == y.functions.front().size();
  }

  /// For this row and all that follow with the same disks.
  [[nodiscard]] std::optional<Overlaps> overlaps_from(std::size_t first,
                                                      const std::vector<BallIsometry>& labels) const {
    const auto& rows = document_.eigenfunctions;
    double lambda = 0;
    for (std::size_t i = first; i < rows.size() && same_disks(rows[i], rows[first]); ++i)
      lambda = std::max(lambda, rows[i].lambda);
    const std::size_t each = rows[first].functions.front().size() / document_.net.vertices.size();
    return Overlaps::make(document_.net, labels, rows[first].radius, static_cast<std::uint32_t>(each / 2), lambda,
                          budget_, threads_);
  }

  /// make(t, triangle) for the parts of each triangle t of the net, one after the other; nothing if one is certainly no
  /// triangle, to the precision.
  template <class Make>
  [[nodiscard]] std::optional<std::vector<TriangleForms>> triangle_forms(const Make& make) {
    const std::size_t triangles = document_.net.triangles.size();
    const std::uint64_t parts = std::uint64_t{1} << (2 * document_.halvings);
    budget_.spend(400 * ball_work(kBitsOfMatrices) + memory_work(600), triangles * parts);
    const std::vector<BallIsometry> labels = evaluated_labels();
    std::vector<std::vector<TriangleForms>> of_triangle(triangles);
    for_each_parallel(triangles, threads_, [&](unsigned, std::size_t t) {
      const auto sides = flat_sides(document_.net, labels, static_cast<std::uint32_t>(t), document_.halvings);
      for (const std::array<Ball, 3>& squares : sides) {
        const auto triangle = FlatTriangle::of(squares);
        if (!triangle) return;
        of_triangle[t].push_back(make(t, *triangle));
      }
    });
    std::vector<TriangleForms> result;
    for (const auto& forms : of_triangle) {
      if (forms.size() != parts) return std::nullopt;
      result.insert(result.end(), forms.begin(), forms.end());
    }
    return result;
  }

  /// A bound for how many negative eigenvalues 𝒜 − σ𝒩 has, for values with these numbers, eliminated in this order, in
  /// frames from which these phases lead to those of the triangles; nothing if a pivot is too near to 0. `wanted` is a
  /// bound that is enough.
  [[nodiscard]] std::optional<std::uint64_t> negative_eigenvalues(const std::vector<TriangleForms>& forms,
                                                                  const Numbers& numbers, const Phases& phases,
                                                                  const EigenvaluesDocument::Order& order, double sigma,
                                                                  Bound bound, std::uint64_t wanted) const {
    HermitianForm form(bundle_, budget_, forms.size());
    const std::uint64_t multiple = form.multiple_of_rows();
    const SparseMatrix matrix = summed(std::move(form), forms, numbers, phases, order, sigma);
    // The number is a multiple: 2n + 1 proves as much as 2n if it is an upper bound, 2n − 1 if it is a lower one.
    const std::uint64_t enough =
        bound == Bound::upper ? multiple * wanted + (multiple - 1) : multiple * wanted - (multiple - 1);
    const Inertia inertia = matrix.negative_eigenvalues(bound, budget_, threads_, enough);
    if (!inertia.proved) return std::nullopt;
    return bound == Bound::upper ? inertia.negative / multiple : (inertia.negative + multiple - 1) / multiple;
  }

  [[nodiscard]] SparseMatrix summed(HermitianForm form, const std::vector<TriangleForms>& forms, const Numbers& numbers,
                                    const Phases& phases, const EigenvaluesDocument::Order& order, double sigma) const {
    budget_.spend(form.multiple_of_rows() == 1 ? 500 : 1500, forms.size());
    std::vector<std::uint32_t> place(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    for (std::size_t t = 0; t < forms.size(); ++t) {
      const auto& [energy, mass] = forms[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t own = place[numbers[t][i]];
        form.add(difference_entry(own, own, energy.square[i], sigma, mass.square[i]), 0);
        const std::size_t second = (i + 1) % 3;
        const std::size_t third = (i + 2) % 3;
        const std::uint32_t j = place[numbers[t][second]];
        const std::uint32_t k = place[numbers[t][third]];
        // In the row of the conjugate of one value, the column of the other: from the row's frame to the column's.
        const Phase phase = j > k ? bundle_.difference(phases[t][third], phases[t][second])
                                  : bundle_.difference(phases[t][second], phases[t][third]);
        const MatrixEntry product = difference_entry(j, k, energy.product[i], sigma, mass.product[i]);
        form.add(product, phase);
        // Both products of two values of one number are on the diagonal.
        if (j == k) form.add(product, phase);
      }
    }
    return std::move(form).matrix(order.size());
  }

  /// By triangle, what is said of the sides, of the side opposite to each corner.
  template <class Value>
  [[nodiscard]] static std::vector<std::array<Value, 3>> opposite_to_corners(
      const std::vector<std::array<Value, 3>>& of_sides) {
    std::vector<std::array<Value, 3>> result;
    result.reserve(of_sides.size());
    for (const auto& [first, second, third] : of_sides) result.push_back({second, third, first});
    return result;
  }

  [[nodiscard]] std::vector<BallIsometry> evaluated_labels() const {
    std::vector<std::uint32_t> numbers(document_.net.labels.size());
    std::iota(numbers.begin(), numbers.end(), 1U);
    return evaluator_.evaluate(numbers, Precision::bits(), 4 * Precision::bits(), threads_);
  }

  void progress(const char* rule, std::size_t row, std::size_t rows) const {
    if (run_.options().progress) run_.options().progress(rule, static_cast<double>(row) / static_cast<double>(rows));
  }

  static constexpr const char* kTooNear = "not decided: a pivot is too near to 0 for binary64";

  static RuleReport nothing_to_count(const char* rule) { return {rule, Verdict::verified, "no counts"}; }
  static RuleReport no_triangle(const char* rule) {
    return {rule, Verdict::undecided, "the corners of a part of a triangle are too near to a line"};
  }
  static RuleReport undecided(const char* rule, std::size_t row, const std::string& why) {
    return {rule, Verdict::undecided, (rule == kMost ? "at_most[" : "at_least[") + std::to_string(row) + "]: " + why};
  }

  const EigenvaluesDocument& document_;
  Verification& run_;
  unsigned threads_;
  const Budget& budget_;
  LabelParts parts_;
  LabelEvaluator evaluator_;
  LineBundle bundle_;
  double distance_ = 0;     ///< Of roots of eigenvalues from those that are counted: in a box.
  std::uint64_t left_out_;  ///< How many eigenvalues of the matrices are not counted: the 0 of the constants.
};

std::string text_of(const EigenvaluesDocument& document) {
  std::uint64_t count = 0;
  for (const EigenvaluesDocument::Enclosure& row : document.eigenvalues) count += row.count;
  const std::string rest = " at least " + decimal_below(document.next);
  if (!document.phases.empty()) {
    const std::string which =
        " of the Laplacian on sections of the flat line bundle of these phases" +
        (document.box ? ", or of any within " + in_quotes(document.box->radius) + " turns of them in " +
                            counted(document.box->directions.size(), "direction", "directions")
                      : "");
    if (count == 0) return "all eigenvalues" + which + " are" + rest;
    return "the first " + counted(count, "eigenvalue", "eigenvalues") + which + ", with multiplicity, lie in " +
           counted(document.eigenvalues.size(), "interval", "intervals") + ", all others are" + rest;
  }
  if (count == 0) return "eigenvalues of the Laplacian, but 0, are" + rest;
  return "the first " + counted(count, "eigenvalue", "eigenvalues") +
         " of the Laplacian after 0, with multiplicity, lie in " +
         counted(document.eigenvalues.size(), "interval", "intervals") + ", all others are" + rest;
}

}  // namespace

RuleNames own_rules(const EigenvaluesDocument& document) {
  if (document.phases.empty()) return {kMost, kLeast, kEigenfunctions, kEnclosures};
  if (!document.box) return {kPhases, kMost, kLeast, kEigenfunctions, kEnclosures};
  return {kPhases, kBox, kMost, kLeast, kEigenfunctions, kEnclosures};
}

Claim claim_of(const EigenvaluesDocument& document) {
  const auto ask = [&](Verification& run, Crossings crossings) {
    EigenvaluesCheck(document, run, std::move(crossings)).ask();
  };
  return {document.net, text_of(document), own_rules(document), ask};
}

}  // namespace epsnet::certify
