#pragma once

#include "certify/check.h"
#include "certify/label_evaluator.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace epsnet::certify {

/// Which triangles and vertices the collars of a pseudo net name; nothing in any other net.
class CollarMembers {
 public:
  /// Needs a document without structure problem. O(number of triangles) if there is a collar.
  explicit CollarMembers(const Document& document);

  /// Whether the net is a pseudo net.
  [[nodiscard]] bool pseudo() const { return pseudo_; }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return !triangles_.empty() && triangles_[t]; }
  [[nodiscard]] bool has_vertex(std::uint32_t v) const { return partners_.contains(v); }
  /// Whether two vertices are those of one collar.
  [[nodiscard]] bool are_partners(std::uint32_t u, std::uint32_t v) const {
    const auto found = partners_.find(u);
    return found != partners_.end() && found->second == v;
  }

 private:
  bool pseudo_;
  std::vector<bool> triangles_;
  std::unordered_map<std::uint32_t, std::uint32_t> partners_;
};

struct CollarsOutcome {
  RuleReport report;
  std::uint64_t max_precision = 0;        ///< Bits.
  std::optional<Interval> shortest_core;  ///< Of those collars that hold; absent without any.
};

/// Rule `collars` of a pseudo net: ε ≤ ln √2; collars share no triangle and no vertex; each is an annulus of two
/// triangles around a closed geodesic that is no longer than ε and has the length that the file says; its two vertices
/// lie on the two sides of that geodesic, in the ε-thick part and near enough to cover what the annulus has of it
/// (docs/proof.md, section 10, clauses (a) to (g)).
///
/// Combinatorics exactly, lengths by balls of more and more bits. Needs rules `surface`, `map` and `gluing`. O(n).
[[nodiscard]] CollarsOutcome check_collars(const Document& document, const LabelEvaluator& evaluator,
                                           const LabelParts& parts, long max_precision);

}  // namespace epsnet::certify
