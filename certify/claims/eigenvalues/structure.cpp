#include "certify/net/structure.h"

#include <algorithm>
#include <cmath>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/check.h"
#include "certify/claims/eigenvalues/halved_net.h"

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
  for (const Document::Eigenfunctions& row : document.eigenfunctions) {
    bytes += 50;
    for (const Document::Coefficients& coefficients : row.functions) bytes += 2 + 2 * coefficients.size();
  }
  return bytes;
}

}  // namespace epsnet::certify
