#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "certify/claims/geodesics/double_double.h"
#include "certify/claims/geodesics/moved_net.h"

namespace epsnet::certify {

/// What is asked at every closed geodesic that is found, in the order of the search.
enum class Search { go_on, stop };

struct SearchOutcome {
  bool complete = false;  ///< All were reported; false if this precision or `limit` does not suffice.
  bool limit_reached = false;
  std::uint64_t visits = 0;  ///< Darts crossed.
};

/// The closed geodesics of a triangulated surface by the sequences of edges that they cross: the search for least
/// cyclic sequences of darts, one edge to begin at after the other (docs/proof.md, section 11).
class CrossingSearch {
 public:
  /// The net and the order of its darts must outlive the search. Closed geodesics that cross only edges that are last
  /// in the order need not be found. `cosh_half` is cosh(L/2).
  CrossingSearch(const MovedNet& net, const DartOrder& order, const Ball& cosh_half);

  /// A cyclic sequence, by the codes of the darts.
  using Report = std::function<Search(const std::vector<std::uint32_t>&)>;

  /// In how many parts the search is done. The first edges have most of the work, and have a part for each choice of
  /// the first turns.
  [[nodiscard]] std::size_t size() const { return parts_.size(); }

  /// Reports the least sequence of each primitive closed geodesic of length at most L that belongs to a part, in one of
  /// the two directions. Duplicates and other sequences are possible; all are less than their other rotations.
  /// Thread-safe.
  ///
  /// Depth first, with memory proportional to the depth. A visit is a dart crossed.
  [[nodiscard]] SearchOutcome run(std::size_t part, std::uint64_t limit, const Report& report) const;

 private:
  /// The ways from an edge on; the first turns are given, to the left or to the right.
  struct Part {
    std::uint32_t first;  ///< The code of the first dart.
    std::vector<bool> to_left;
  };
  template <class Number>
  class Way;
  struct Limits;

  template <class Number>
  [[nodiscard]] std::optional<Limits> limits(std::uint32_t first, Way<Number>& way) const;
  template <class Number>
  [[nodiscard]] SearchOutcome run_with(const std::vector<std::array<Number, 3>>& beyond, const Part& part,
                                       std::uint64_t limit, const Report& report) const;

  const MovedNet& net_;
  const DartOrder& order_;
  Ball length_;  ///< L
  std::vector<Part> parts_;
  std::vector<std::array<DoubleDouble, 3>> beyond_;  ///< As the net has it, by dart; empty if it has too many bits.
};

}  // namespace epsnet::certify
