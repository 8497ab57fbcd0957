#include "certify/net/structure.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/check.h"
#include "certify/claims/eigenvalues/test_function.h"
#include "certify/claims/geodesics/check.h"

namespace epsnet::certify {
namespace {

using Document = EigenvaluesDocument;

Problem functions_problem(const Document& document) {
  if (document.order < 8 || document.order > 16 || document.order % 2 != 0) {
    return "order: " + std::to_string(document.order) + " is not an even number from 8 to 16";
  }
  if (document.degree < 1 || document.degree > 64) {
    return "degree: " + std::to_string(document.degree) + " is not a number from 1 to 64";
  }
  const TestFunctions functions = test_functions(document);
  if (functions.support <= functions.pieces()) return std::nullopt;
  return "degree: " + std::to_string(document.degree) + " is too small for lengths up to " + in_quotes(document.up_to) +
         ", expected up_to <= 2 degree + order/2";
}

/// Whether x and y, both finite, are the ends of an interval in [0, ∞).
bool in_order(double x, double y) { return std::isfinite(x) && std::isfinite(y) && 0 <= x && x <= y; }

Problem values_problem(const Document::Coefficients& coefficients) {
  if (!std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return std::isfinite(c); }))
    return "a coefficient is not finite";
  if (std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return c == 0; }))
    return "all coefficients are 0";
  return std::nullopt;
}

Problem eigenfunction_problem(const Document& document, const Document::Eigenfunction& row) {
  constexpr std::size_t kGreatestOrder = 200;
  const auto& [in, lambda, radius, coefficients] = row;
  if (!in_order(in.lower, lambda) || !in_order(lambda, in.upper) || in.lower == 0)
    return "lambda is not in in, or in is not 0 < lo <= hi";
  if (!std::isfinite(radius) || radius >= 2 || mpq_class(radius) <= decimal(document.net.epsilon))
    return "radius is not more than epsilon and less than 2";
  const std::size_t vertices = document.net.vertices.size();
  const std::size_t each = coefficients.size() / std::max<std::size_t>(vertices, 1);
  if (coefficients.size() != each * vertices || each % 2 == 0 || each < 3 || each > 2 * kGreatestOrder + 1) {
    return std::to_string(coefficients.size()) + " coefficients, expected 2M + 1 for each of " +
           std::to_string(vertices) + " vertices, M from 1 to " + std::to_string(kGreatestOrder);
  }
  return values_problem(coefficients);
}

/// Says what is wrong with intervals of eigenvalues and with coefficients.
class Statements {
 public:
  explicit Statements(const Document& document)
      : document_(document), greatest_(greatest_eigenvalue(test_functions(document))) {}

  [[nodiscard]] Problem interval_problem(const char* name, Interval x) const {
    if (!in_order(x.lower, x.upper)) return std::string(name) + " is not 0 <= lo <= hi";
    if (mpq_class(x.upper) <= greatest_) return std::nullopt;
    return std::string(name) + " reaches beyond 1/4 + 9/step^2, step = up_to/(2 degree + order/2)";
  }

  [[nodiscard]] Problem coefficients_problem(const Document::Coefficients& coefficients) const {
    if (coefficients.size() != std::size_t{document_.degree} + 1) {
      return std::to_string(coefficients.size()) + " coefficients, expected degree + 1, " +
             std::to_string(document_.degree + 1);
    }
    return values_problem(coefficients);
  }

 private:
  const Document& document_;
  mpq_class greatest_;
};

Problem at_most_problem(const Statements& statements, const Document::AtMost& row) {
  if (auto problem = statements.interval_problem("in", row.in)) return problem;
  return statements.coefficients_problem(row.coefficients);
}

Problem at_least_problem(const Statements& statements, const Document::AtLeast& row) {
  if (auto problem = statements.interval_problem("in", row.in)) return problem;
  if (auto problem = statements.interval_problem("within", row.within)) return problem;
  if (row.in.lower == row.in.upper) return "in is a single point";
  if (row.within.lower < row.in.lower || row.in.upper < row.within.upper) return "within is not a part of in";
  if (row.count == 0) return "the count is 0";
  return statements.coefficients_problem(row.coefficients);
}

Problem window_problem(const Document& document, std::size_t i) {
  const auto& [in, least, most, smallest, greatest] = document.windows[i];
  if (!in_order(in.lower, in.upper)) return "in is not 0 <= lo <= hi";
  if (i > 0 && in.lower <= document.windows[i - 1].in.upper) return "in does not begin after the window before";
  if (in.upper > document.eigenvalues_up_to) return "in reaches beyond up_to";
  if (most == 0 || most < least) return "expected 0 <= least <= most and most >= 1";
  if (least < most && (smallest != in || greatest != in))
    return "smallest and greatest are not in, although least < most";
  if (!in_order(smallest.lower, smallest.upper) || smallest.lower != in.lower || in.upper < smallest.upper)
    return "smallest is not the lower part of in";
  if (!in_order(greatest.lower, greatest.upper) || greatest.upper != in.upper || greatest.lower < in.lower)
    return "greatest is not the upper part of in";
  return std::nullopt;
}

template <class Row, class RowProblem>
Problem rows_problem(const char* name, const std::vector<Row>& rows, const RowProblem& row_problem) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (const auto problem = row_problem(rows[i])) return at(name, i) + *problem;
  }
  return std::nullopt;
}

}  // namespace

Problem structure_problem(const Document& document) {
  if (document.claim != GeodesicsDocument::Claim::spectrum) return "claim: expected a spectrum";
  if (auto problem = structure_problem(static_cast<const GeodesicsDocument&>(document))) return problem;
  if (auto problem = functions_problem(document)) return problem;
  const Statements statements(document);
  if (auto problem = rows_problem("at_most", document.at_most,
                                  [&](const auto& row) { return at_most_problem(statements, row); })) {
    return problem;
  }
  if (auto problem = rows_problem("at_least", document.at_least,
                                  [&](const auto& row) { return at_least_problem(statements, row); })) {
    return problem;
  }
  if (auto problem = rows_problem("eigenfunctions", document.eigenfunctions,
                                  [&](const auto& row) { return eigenfunction_problem(document, row); })) {
    return problem;
  }
  if (!std::isfinite(document.eigenvalues_up_to) || document.eigenvalues_up_to <= 0)
    return "eigenvalues_up_to: not a positive number";
  for (std::size_t i = 0; i < document.windows.size(); ++i) {
    if (const auto problem = window_problem(document, i)) return at("windows", i) + *problem;
  }
  return std::nullopt;
}

std::uint64_t least_bytes(const Document& document) {
  std::uint64_t bytes = least_bytes(static_cast<const GeodesicsDocument&>(document)) + 80 * document.windows.size();
  for (const Document::AtMost& row : document.at_most) bytes += 35 + 2 * row.coefficients.size();
  for (const Document::AtLeast& row : document.at_least) bytes += 50 + 2 * row.coefficients.size();
  for (const Document::Eigenfunction& row : document.eigenfunctions) bytes += 50 + 2 * row.coefficients.size();
  return bytes;
}

}  // namespace epsnet::certify
