#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "certify/exact/net_structure.h"

/// Section 21.1 of docs/proof.md: closed curves of a surface as closed walks in its radial graph. Without numbers.
namespace epsnet::exact {

/// Where two closed walks cross.
struct WalkCrossings {
  /// Steps of the two at the beginning of which is the first vertex that they have in common before they cross, one
  /// pair for each crossing.
  std::vector<std::pair<std::size_t, std::size_t>> steps;
  long signs = 0;  ///< The number of those from the right of the first one to its left, less the others.
};

/// The sides of the tiles, but for some, cut the surface into a polygon with 4g sides whose corners are one vertex. The
/// radial graph has an edge from the centre of the polygon to each of its corners; its faces are quadrangles.
class RadialGraph {
 public:
  /// 2j for edge number j from the centre to corner j, 2j + 1 for its way back.
  using Step = Index;
  using Walk = std::vector<Step>;

  /// The tiles are connected, and are a surface of this Euler characteristic, less than 0.
  RadialGraph(const NetStructure& net, long euler);

  // All that follows throws TooLarge if it takes too many steps, for all walks together.

  /// The closed walk of a closed path of letters, as it stands but for turning back.
  [[nodiscard]] Walk walk(const std::vector<Index>& word);
  /// The rightmost one of the shortest closed walks in the free homotopy class of a closed walk; empty if that is
  /// trivial.
  [[nodiscard]] Walk rightmost(Walk walk);
  /// Where a walk and another one cross as few times as possible: two rightmost walks of primitive classes that are
  /// neither the same nor inverse to each other; or a walk and itself, `same`, with each crossing twice.
  [[nodiscard]] WalkCrossings crossings(const Walk& a, const Walk& b, bool same);
  /// Whether walks, joined at steps of two of them, can be deformed to any closed walk: they are joined so that they
  /// are connected, and every closed walk is homotopic to one that runs along them.
  struct Joint {
    std::size_t walk;
    std::size_t step;
    std::size_t other_walk;
    std::size_t other_step;
  };
  [[nodiscard]] bool generate(const std::vector<const Walk*>& walks, const std::vector<Joint>& joints);

 private:
  void find_polygon(const NetStructure& net);
  void contract();
  void spend(std::size_t steps);

  [[nodiscard]] Index plus(Index j, std::size_t n) const { return static_cast<Index>((j + n) % corners_); }
  /// Where a step leaves its start, counterclockwise there.
  [[nodiscard]] Index leaves(Step e) const { return e % 2 == 0 ? e / 2 : place_[e / 2]; }
  /// From behind the first step counterclockwise to the second one.
  [[nodiscard]] Index turn(Step e, Step f) const { return plus(leaves(f), corners_ - leaves(e ^ 1U)); }
  [[nodiscard]] Index left(Index turn) const { return turn == 0 ? 0 : static_cast<Index>(corners_) - turn; }
  /// The step that leaves the same vertex, so many edges counterclockwise.
  [[nodiscard]] Step turned(Step e, std::size_t n) const {
    return e % 2 == 0 ? 2 * plus(e / 2, n) : 2 * edge_at_[plus(place_[e / 2], n)] + 1;
  }
  /// The opposite step in the quadrangle on the right, or on the left.
  [[nodiscard]] Step across(Step e, bool on_right) const {
    const bool outward = e % 2 == 0;
    const Index j = e / 2;
    // Beside the side of the polygon that the quadrangle contains.
    return outward == on_right ? beside(plus(partner_[plus(j, corners_ - 1)], 1), outward)
                               : beside(partner_[j], outward);
  }
  static Step beside(Index j, bool outward) { return 2 * j + (outward ? 1 : 0); }

  void push(Walk& walk, Step e);
  [[nodiscard]] bool shorten(Walk& walk);
  [[nodiscard]] bool take_away(Walk& walk, std::size_t first, std::size_t last);
  void shift_right(Walk& walk, std::size_t i);
  [[nodiscard]] std::size_t last_common(const Walk& a, std::size_t i, bool a_forwards, const Walk& b, std::size_t j,
                                        bool b_forwards);

  class Hull;

  std::size_t steps_left_;
  std::vector<Index> side_of_;  ///< By side of a tile: the side of the polygon, or kNone.
  std::size_t corners_ = 0;     ///< Of the polygon; then of that without the sides that are contracted.
  std::vector<Index> partner_;  ///< By side of it.
  std::vector<Index> corner_;   ///< By side of the polygon: the corner where it starts, when others are contracted.
  std::vector<Index> beyond_;   ///< By side of the polygon: that where it starts, seen from beyond.
  std::vector<Index> place_;    ///< By edge: where it is around the vertex.
  std::vector<Index> edge_at_;  ///< The other way round.
  Walk pending_;
  Walk between_;
  Walk next_;
};

}  // namespace epsnet::exact
