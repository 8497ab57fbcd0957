#pragma once

#include <string>

#include "certify/claims/geodesics/chord_table.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/geodesics/exact_traces.h"
#include "certify/claims/geodesics/orbit_search.h"

namespace epsnet::certify {

/// What one precision says of elements that may be closed geodesics which a list lacks (docs/proof.md, section 11).
///
/// An element is written in the chart of a vertex, which is where its axis is looked for.
class CandidateJudge {
 public:
  /// All must outlive the judge. `cosh_half` is cosh(L/2) for the bound L of the claim, at the precision of the plane;
  /// the table has the chords of the list; the evaluator's document is the net with the words of the list as further
  /// labels.
  CandidateJudge(const GeodesicsDocument& document, const LabelEvaluator& evaluator, const LiftedPlane& plane,
                 const ChordTable& table, const Ball& cosh_half);

  struct Judgement {
    Tri in_order = Tri::yes;    ///< Whether it is no geodesic that the list lacks.
    bool is_candidate = false;  ///< Whether the list was asked.
    std::string text;           ///< Of what is missing.
  };

  /// Whether an element is no geodesic that the list lacks: `yes` if it is too long, the identity, in the list, or
  /// (unless `place` is null) if its axis is further than ε from the vertex at `place`. For a systole, which is a list
  /// of one, `yes` also if it is no shorter than that. `product` is the element as one of labels, for exact numbers.
  [[nodiscard]] Judgement judge(std::uint32_t v, const BallIsometry& element, const LabelProduct& product,
                                const BallVector* place) const;

  /// Whether this element may be skipped because its inverse is reported too: the inverse moves the vertex as far, and
  /// b changes its sign. At least one element of each pair is kept.
  [[nodiscard]] static bool inverse_will_do(const BallIsometry& element);

 private:
  [[nodiscard]] bool is_systole() const { return document_.claim == GeodesicsDocument::Claim::systole; }
  [[nodiscard]] bool is_far(const BallIsometry& element, const BallVector& place) const;
  [[nodiscard]] bool is_near_tie(const BallIsometry& element) const;
  [[nodiscard]] Tri is_no_shorter(const BallIsometry& element, Tri shorter, const LabelProduct& product) const;
  [[nodiscard]] Tri is_listed(std::uint32_t v, const BallIsometry& element, Tri shorter,
                              const LabelProduct& product) const;
  [[nodiscard]] Tri has_chord_in_list(std::uint32_t v, const BallIsometry& element) const;
  [[nodiscard]] std::string missing_text(std::uint32_t v, const BallIsometry& element) const;

  const GeodesicsDocument& document_;
  const LabelEvaluator& evaluator_;
  const LiftedPlane& plane_;
  const ChordTable& table_;
  const Ball& cosh_half_;
  ExactTraces traces_;
  std::vector<std::uint32_t> first_darts_;
  Ball sinh_epsilon_;
};

}  // namespace epsnet::certify
