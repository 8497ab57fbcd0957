#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/document.h"
#include "certify/net/labels.h"
#include "certify/verdict/report.h"

/// Closed ways across edges, given by the codes of the darts crossed (DartOrder). That which crosses the opposite darts
/// in the opposite order is the way back; the code of the opposite dart of code c is c ^ 1.
namespace epsnet::certify {

/// A cyclic sequence, up to rotation and to the way back.
struct LeastSequence {
  std::vector<std::uint32_t> root;  ///< The least of all rotations of the way and of the way back, without repetitions.
  std::uint32_t exponent = 1;       ///< How many times the root is run through.
  bool backwards = false;           ///< Whether the root is a rotation of the way back.
};

/// The least period of a cyclic sequence that is not empty: a divisor of its length.
[[nodiscard]] std::size_t period_of(std::span<const std::uint32_t> codes);

/// O(n) but for the divisors of n.
[[nodiscard]] LeastSequence least_sequence(std::span<const std::uint32_t> codes);

/// The least sequences of a list of geodesics.
class SequenceTable {
 public:
  explicit SequenceTable(std::vector<LeastSequence> sequences);

  [[nodiscard]] std::size_t size() const { return sequences_.size(); }

  /// Whether a geodesic has this root, which it runs through once.
  [[nodiscard]] bool contains(const std::vector<std::uint32_t>& root) const;

  struct Match {
    std::uint32_t geodesic = 0;
    std::uint32_t power = 0;
  };
  /// Another geodesic, of which this one is a power.
  [[nodiscard]] std::optional<Match> find_other(std::uint32_t geodesic) const;

 private:
  [[nodiscard]] std::span<const std::uint32_t> with_root(const std::vector<std::uint32_t>& root) const;

  std::vector<LeastSequence> sequences_;
  std::vector<std::uint32_t> order_;  ///< Geodesics by their roots.
};

/// Compares translation lengths without rounding: 4 cosh²(l/2) = tr²/det, and traces and determinants are numbers of
/// the ring of the surface's crossings.
///
/// A word here leads from a tile to itself, is freely reduced, and does not evaluate to the identity: an element of the
/// group that is hyperbolic. An element and its conjugates have one length, so frames of charts do not matter. Nothing
/// is returned where a word is too long to be evaluated exactly; BudgetSpent, if that is too much work.
class ExactTraces {
 public:
  /// The evaluator must outlive the traces.
  explicit ExactTraces(const LabelEvaluator& evaluator)
      : crossings_(evaluator.crossings()), budget_(evaluator.budget()) {}
  explicit ExactTraces(const LabelEvaluator&& evaluator) = delete;

  /// The sign of l(word) − l(other).
  [[nodiscard]] std::optional<int> compare(std::span<const std::uint32_t> word,
                                           std::span<const std::uint32_t> other) const;

  /// The sign of l(word) − 2 arsinh 1.
  [[nodiscard]] std::optional<int> compare_with_short(std::span<const std::uint32_t> word) const;

 private:
  const Crossings& crossings_;
  const Budget& budget_;
};

// What is known of each geodesic of a list, and what follows for the rules `distinct` and `simple` (docs/proof.md,
// section 11).

/// "geodesic i".
[[nodiscard]] std::string geodesic_name(std::size_t i);

/// Rule `distinct`: whether one of the geodesics is another one or a power of it.
[[nodiscard]] RuleReport distinct_report(const SequenceTable& table);

/// Rule `simple`: each is simple or not, as the document says, and crosses no other if they are said to be `disjoint`.
[[nodiscard]] RuleReport simple_report(std::span<const GeodesicsDocument::ClosedGeodesic> geodesics,
                                       std::span<const Meetings> meetings, bool disjoint, slong precision);

}  // namespace epsnet::certify
