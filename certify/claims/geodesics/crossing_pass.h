#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/crossing_search.h"
#include "certify/claims/geodesics/least_sequence.h"

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

/// A list of closed geodesics at one precision, by the edges that they cross (docs/proof.md, section 11, Lemmas 15.1
/// to 15.5).
class CrossingPass {
 public:
  /// One geodesic's element, in the chart of the vertex that the dart leaves.
  struct Member {
    std::uint32_t first_dart;
    BallIsometry element;
  };

  /// The plane must outlive the pass. `cosh_half` is cosh(L/2), `member(i)` makes member i of `count`. Several threads
  /// work.
  CrossingPass(const LiftedPlane& plane, const Ball& cosh_half, std::size_t count,
               const std::function<Member(std::size_t)>& member, unsigned threads);

  /// Whether the vertices could be moved; otherwise nothing else may be asked.
  [[nodiscard]] bool valid() const { return search_.has_value(); }
  /// Whether it is known which edges each geodesic of the list crosses; otherwise nothing of what follows may be asked.
  [[nodiscard]] bool complete() const { return table_.has_value(); }

  /// The list.
  [[nodiscard]] const SequenceTable& table() const { return *table_; }
  /// By geodesic: whether it crosses itself.
  [[nodiscard]] const std::vector<Tri>& crosses_itself() const { return crosses_itself_; }

  /// How many parts the search for what the list lacks has: the loop edges of collars, and then those of the
  /// search across edges. If every part is complete, the list lacks nothing.
  [[nodiscard]] std::size_t size() const { return loops_.size() + search_->size(); }
  /// Calls tick() now and then. Crosses at most `limit` edges. Thread-safe.
  [[nodiscard]] SearchPart examine(std::size_t part, std::uint64_t limit, const std::function<void()>& tick) const;

 private:
  void find_collar(std::uint32_t loop, std::vector<bool>& inner);
  [[nodiscard]] BallIsometry element_of_loop(std::uint32_t dart) const;
  [[nodiscard]] LeastSequence sequence_of(const std::vector<std::uint32_t>& darts) const;
  [[nodiscard]] Tri is_in_order(std::uint32_t loop, SearchPart& part) const;
  [[nodiscard]] Tri is_in_order(const std::vector<std::uint32_t>& codes, SearchPart& part) const;
  [[nodiscard]] Tri missing(std::uint32_t dart, const BallIsometry& element, SearchPart& part) const;

  const LiftedPlane& plane_;
  const NetDocument& net_;
  Ball cosh_half_;
  MovedNet moved_;
  std::vector<std::uint32_t> loops_;  ///< One dart of each loop edge that is inside the collar of its core.
  std::optional<DartOrder> order_;
  std::optional<CrossingSearch> search_;
  std::optional<SequenceTable> table_;
  std::vector<Tri> crosses_itself_;
};

}  // namespace epsnet::certify
