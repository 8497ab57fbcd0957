#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/crossing_search.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/geodesics/sequences.h"

namespace epsnet::certify {

/// What is known of the closed geodesics that a list lacks.
struct Completeness {
  Tri complete = Tri::unknown;
  bool limit_reached = false;
  std::uint64_t visits = 0;
  std::uint64_t candidates = 0;  ///< Sequences of closed geodesics that are perhaps short enough.
  std::string missing;           ///< Of one that is missing, in words.
};

/// A list of closed geodesics at one precision, by the edges that they cross (docs/proof.md, section 11).
class CrossingPass {
 public:
  /// One geodesic's element, in the chart of the vertex that the dart leaves.
  struct Member {
    std::uint32_t first_dart;
    BallIsometry element;
  };

  /// All must outlive the pass. The evaluator's document is the net with the words of the list as further labels.
  /// `cosh_half` is cosh(L/2), `member(i)` makes member i of the document's list. Several threads work.
  CrossingPass(const GeodesicsDocument& document, const LabelEvaluator& evaluator, const LiftedPlane& plane,
               const Ball& cosh_half, const std::function<Member(std::size_t)>& member, unsigned threads);

  /// Whether it is known which edges each geodesic of the list crosses, and which edges lie in collars; otherwise
  /// nothing of what follows may be asked.
  [[nodiscard]] bool complete() const { return table_.has_value(); }

  /// The list.
  [[nodiscard]] const SequenceTable& table() const { return *table_; }
  /// By geodesic: whether it crosses itself; and, for a thick-thin decomposition, another one.
  [[nodiscard]] const std::vector<Meetings>& meetings() const { return meetings_; }
  /// The geodesics of a thick-thin decomposition; nothing else is kept.
  [[nodiscard]] const std::vector<AxisCrossings>& geodesics() const { return geodesics_; }
  [[nodiscard]] const MovedNet& net() const { return moved_; }
  /// How many loop edges are inside the collars of their cores.
  [[nodiscard]] std::size_t loops() const { return loops_.size(); }

  /// Searches for what the list lacks, across at most `limit` edges. Calls progress(share done) now and then, from the
  /// calling thread. The result does not depend on the number of threads.
  [[nodiscard]] Completeness search(std::uint64_t limit, unsigned threads,
                                    const std::function<void(double)>& progress) const;

 private:
  [[nodiscard]] bool find_collar(std::uint32_t loop, std::vector<bool>& inner);
  [[nodiscard]] BallIsometry element_of_loop(std::uint32_t dart) const;
  [[nodiscard]] std::vector<std::uint32_t> codes_of(const std::vector<std::uint32_t>& darts) const;
  [[nodiscard]] std::vector<std::uint32_t> codes_of_loop(std::uint32_t loop) const;
  [[nodiscard]] Tri is_in_order(const std::vector<std::uint32_t>& codes, Completeness& part) const;
  [[nodiscard]] Tri is_to_be_listed(const BallIsometry& element, const std::vector<std::uint32_t>& darts) const;

  const GeodesicsDocument& document_;
  const LabelEvaluator& evaluator_;
  std::uint32_t first_element_;  ///< The label number of the first geodesic's word.
  const LiftedPlane& plane_;
  const NetDocument& net_;
  ExactTraces traces_;
  Ball cosh_half_;
  MovedNet moved_;
  std::vector<std::uint32_t> loops_;  ///< One dart of each loop edge that is inside the collar of its core.
  std::optional<DartOrder> order_;
  std::optional<CrossingSearch> search_;
  std::optional<SequenceTable> table_;
  std::vector<Meetings> meetings_;
  std::vector<AxisCrossings> geodesics_;
};

}  // namespace epsnet::certify
