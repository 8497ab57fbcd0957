#pragma once

#include <functional>
#include <string>
#include <vector>

#include "certify/claims/geodesics/candidate_judge.h"
#include "certify/claims/geodesics/crossing_search.h"

namespace epsnet::certify {

/// What is known of one part of the search for geodesics that a list lacks.
struct SearchPart {
  Tri complete = Tri::unknown;
  bool deep = false;  ///< A short loop was looked at instead of a search.
  bool limit_reached = false;
  std::uint64_t visits = 0;
  std::uint64_t candidates = 0;
  std::string text;  ///< Of what is missing.
};

/// All closed geodesics at one precision, by the edges that they cross (docs/proof.md, section 11, Lemmas 15.1
/// to 15.3).
///
/// If every part is complete, the list lacks none. The parts are the loop edges of collars, and then the edges that are
/// not inside one collar.
class CrossingPass {
 public:
  /// The judge's plane is the one given; both must outlive the pass. `cosh_half` is cosh(L/2).
  CrossingPass(const LiftedPlane& plane, const CandidateJudge& judge, const Ball& cosh_half);

  /// How many parts there are; 0 if this precision does not suffice for any.
  [[nodiscard]] std::size_t size() const { return search_ ? loops_.size() + search_->starts() : 0; }

  /// Calls tick() now and then. Crosses at most `limit` edges. Thread-safe.
  [[nodiscard]] SearchPart examine(std::size_t part, std::uint64_t limit, const std::function<void()>& tick) const;

 private:
  void find_collar(std::uint32_t loop, std::vector<bool>& inner);
  [[nodiscard]] BallIsometry element_of_loop(std::uint32_t dart) const;
  [[nodiscard]] Tri judge(std::uint32_t dart, const BallIsometry& element, const LabelProduct& product,
                          SearchPart& part) const;

  const LiftedPlane& plane_;
  const NetDocument& net_;
  const CandidateJudge& judge_;
  MovedNet moved_;
  std::vector<std::uint32_t> loops_;  ///< One dart of each loop edge that is inside the collar of its core.
  std::optional<CrossingSearch> search_;
};

}  // namespace epsnet::certify
