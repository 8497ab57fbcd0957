#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/curves/fields.h"
#include "certify/claims/net/claim.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {
namespace {

/// Programs that keep all numbers in binary64 read integers up to this one exactly.
constexpr std::int64_t kMostInteger = std::int64_t{1} << 53;

Problem integer_problem(const char* member, std::int64_t value) {
  if (-kMostInteger <= value && value <= kMostInteger) return std::nullopt;
  return std::string(member) + ": " + std::to_string(value) + " is larger than 2^53";
}

Problem integer_problem(const char* member, std::uint64_t value) {
  if (value <= static_cast<std::uint64_t>(kMostInteger)) return std::nullopt;
  return std::string(member) + ": " + std::to_string(value) + " is larger than 2^53";
}

Problem curve_problem(const CurvesDocument& document, const SurfaceSides& sides, const CurvesDocument::Curve& curve) {
  const auto& [vertex, word, length, power, self_intersections, homology] = curve;
  if (vertex >= document.net.vertices.size()) return "vertex " + std::to_string(vertex) + " does not exist";
  const std::uint32_t tile = document.net.charts[document.net.vertices[vertex].chart].tile;
  if (auto problem = word_problem(sides, word, tile, tile, "vertex " + std::to_string(vertex))) return problem;
  if (!is_length(length) || length.lower == 0) {
    return "the length " + to_string(length) + " is not 0 < lo <= hi";
  }
  if (power == 0) return "power: 0, expected at least 1";
  if (auto problem = integer_problem("self_intersections", self_intersections)) return problem;
  if (homology.size() != document.basis.size()) {
    return "homology: " + counted(homology.size(), "integer", "integers") +
           ", expected one for each curve of the basis, " + std::to_string(document.basis.size());
  }
  for (const std::int64_t coefficient : homology) {
    if (auto problem = integer_problem("homology", coefficient)) return problem;
  }
  return std::nullopt;
}

Problem pairs_problem(const CurvesDocument& document) {
  const std::size_t count = document.curves.size();
  const std::size_t expected = count * (count - (count == 0 ? 0 : 1)) / 2;
  if (document.pairs.size() != expected) {
    return "pairs: " + counted(document.pairs.size(), "row", "rows") + ", expected one for each two curves, " +
           std::to_string(expected);
  }
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  return first_row_problem("pairs", document.pairs, [&](const CurvesDocument::Pair& pair) -> Problem {
    if (++second == count) second = ++first + 1;
    if (pair.first != first || pair.second != second) {
      return "curves " + std::to_string(pair.first) + " and " + std::to_string(pair.second) + ", expected " +
             std::to_string(first) + " and " + std::to_string(second);
    }
    if (auto problem = integer_problem("intersections", pair.intersections)) return problem;
    return integer_problem("algebraic", pair.algebraic);
  });
}

Problem basis_problem(const CurvesDocument& document) {
  std::vector<bool> seen(document.curves.size());
  return first_row_problem("basis", document.basis, [&](std::uint32_t curve) -> Problem {
    const std::string name = "curve " + std::to_string(curve);
    if (curve >= seen.size()) return name + " does not exist";
    if (seen[curve]) return name + " occurs twice";
    seen[curve] = true;
    return std::nullopt;
  });
}

Problem filling_problem(const CurvesDocument& document) {
  return first_row_problem("filling", document.filling, [&](const std::vector<std::uint32_t>& set) -> Problem {
    for (std::size_t k = 0; k < set.size(); ++k) {
      const std::string name = "curve " + std::to_string(set[k]);
      if (set[k] >= document.curves.size()) return name + " does not exist";
      if (k > 0 && set[k] <= set[k - 1])
        return name + " follows " + std::to_string(set[k - 1]) + ", expected ascending order";
    }
    return std::nullopt;
  });
}

}  // namespace

Problem structure_problem(const CurvesDocument& document) {
  if (auto problem = whole_net_problem(document.net)) return problem;
  const SurfaceSides sides(document.net.surface);
  if (auto problem = first_row_problem("curves", document.curves, [&](const CurvesDocument::Curve& curve) {
        return curve_problem(document, sides, curve);
      })) {
    return problem;
  }
  if (auto problem = pairs_problem(document)) return problem;
  if (auto problem = basis_problem(document)) return problem;
  return filling_problem(document);
}

std::uint64_t least_bytes(const CurvesDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + 54 * document.pairs.size() + 2 * document.basis.size();
  for (const CurvesDocument::Curve& curve : document.curves) {
    bytes += 80 + least_bytes(curve.word) + 2 * curve.homology.size();
  }
  for (const auto& set : document.filling) bytes += 3 + 2 * set.size();
  return bytes;
}

namespace {

constexpr const char* kCurveLengths = "lengths";
constexpr const char* kPowers = "powers";
constexpr const char* kIntersections = "intersections";
constexpr const char* kHomology = "homology";
constexpr const char* kFilling = "filling";

}  // namespace

RuleNames own_rules(const CurvesDocument& /*document*/) {
  return {kCurveLengths, kPowers, kIntersections, kHomology, kFilling};
}

Claim claim_of(const CurvesDocument& document) {
  const auto ask = [&document](Verification& run, const Crossings& /*crossings*/) {
    OpenRules rules(own_rules(document));
    rules.give_up("not checked");
    rules.conclude(run);
  };
  return {document.net,
          counted(document.curves.size(), "closed curve", "closed curves") +
              " with their intersection numbers and their classes in a basis of the first homology",
          own_rules(document), ask};
}

}  // namespace epsnet::certify
