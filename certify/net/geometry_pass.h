#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <gmpxx.h>
#include <optional>
#include <string>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/filter.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/structure.h"

/// What the rules of geometry ask of a triangle, in balls of one precision or exactly, and what is found: the parts of
/// geometry_check.cpp.
namespace epsnet::certify::geometry {

enum Rule : std::size_t { kOrientation, kDelaunay, kCovering, kPacking, kThick };
constexpr std::array kRules{kOrientation, kDelaunay, kCovering, kPacking, kThick};
constexpr std::array<const char*, 5> kRuleNames{"orientation", "delaunay", "covering", "packing", "thick"};

/// The first triangle of a rule that fails, in file order, with its text.
struct Violation {
  std::size_t triangle;
  std::string text;
};

/// Quantities of which an extreme is enclosed: the largest sinh²R, the others of sinh²(d/2).
enum Measure : std::size_t { kCircumradius, kLongest, kShortestEdge, kShortestLoop };
constexpr std::array kMeasures{kCircumradius, kLongest, kShortestEdge, kShortestLoop};

/// Contains the extreme of all quantities seen; nullopt for what was not seen.
class Extremes {
 public:
  void add(Measure measure, Interval x) {
    std::optional<Interval>& value = values_[measure];
    if (!value) {
      value = x;
    } else if (measure == kCircumradius || measure == kLongest) {
      value = {std::max(value->lower, x.lower), std::max(value->upper, x.upper)};
    } else {
      value = {std::min(value->lower, x.lower), std::min(value->upper, x.upper)};
    }
  }
  void add(const Extremes& other) {
    for (const Measure measure : kMeasures) {
      if (other[measure]) add(measure, *other[measure]);
    }
  }
  [[nodiscard]] const std::optional<Interval>& operator[](Measure measure) const { return values_[measure]; }

 private:
  std::array<std::optional<Interval>, 4> values_;
};

/// What was found in some of the triangles. Combined in file order, so nothing depends on which thread found what.
struct Findings {
  std::array<std::optional<Violation>, 5> refuted;
  std::vector<std::uint32_t> ties;
  Extremes extremes;

  void refute(Rule rule, std::size_t triangle, const std::string& text) {
    if (!refuted[rule] || triangle < refuted[rule]->triangle) refuted[rule] = Violation{triangle, text};
  }

  void add(const Findings& other) {
    for (const Rule rule : kRules) {
      if (other.refuted[rule]) refute(rule, other.refuted[rule]->triangle, other.refuted[rule]->text);
    }
    ties.insert(ties.end(), other.ties.begin(), other.ties.end());
    extremes.add(other.extremes);
  }
};

/// "triangle t (vertices u, v, w)".
[[nodiscard]] std::string triangle_name(const NetDocument& document, std::size_t t);
/// "the edge of dart d from vertex u to vertex v".
[[nodiscard]] std::string edge_name(const NetDocument& document, std::uint32_t dart);

/// The questions about triangle t that belong to a rule.
[[nodiscard]] Questions questions_of(const NetDocument& document, const CollarMembers& collars, Rule rule,
                                     std::uint32_t t);

/// Works on a question of rule `orientation` or `delaunay` without rounding; true if it is decided.
[[nodiscard]] bool examine_exactly(const NetDocument& document, const LabelEvaluator& evaluator, std::uint32_t t,
                                   Questions question, Findings& findings);

/// One run over the open triangles at one precision.
class Pass {
 public:
  Pass(const NetDocument& document, const CollarMembers& collars, const LabelTable& labels, const mpq_class& epsilon,
       slong precision, bool last);

  /// Works on the open questions of triangle t and returns those that stay open.
  [[nodiscard]] Questions examine(std::uint32_t t, Questions open, LiftedTriangle& lifted, Findings& findings) const;

 private:
  [[nodiscard]] Questions examine_orientation(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const;

  [[nodiscard]] Questions examine_covering(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const;

  /// All that rule `covering` asks of a triangle of a collar.
  [[nodiscard]] Questions examine_circumcircle(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const;

  [[nodiscard]] Questions examine_delaunay(std::uint32_t t, std::uint32_t i, LiftedTriangle& lifted,
                                           Findings& findings) const;

  [[nodiscard]] Questions examine_length(std::uint32_t t, std::uint32_t i, LiftedTriangle& lifted,
                                         Findings& findings) const;

  const NetDocument& document_;
  const CollarMembers& collars_;
  const LabelTable& labels_;
  slong precision_;
  bool last_;
  Interval epsilon_{};
  Ball sinh_squared_;
  Ball half_sinh_squared_;
};

}  // namespace epsnet::certify::geometry
