#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "netgen/base/options.h"
#include "triangulation/surface/surface.h"

/// Closed curves of a surface as closed walks of a graph on it, up to free homotopy: how often two of them meet,
/// decided by their words alone. docs/curves.md says why.
namespace epsnet {

/// A closed walk of the radial graph: the edges that it takes, outward and inward in turn, an outward one first. The
/// empty walk is null-homotopic.
using ClosedWalk = std::vector<std::uint32_t>;

/// A pair of lifts of two closed walks that cross, one of each pair up to the group: they pass through one vertex of
/// the graph, the start of edge `first` of the first walk and of edge `second` of the other one.
struct WalkCrossing {
  std::uint32_t first;
  std::uint32_t second;
  int sign;  ///< 1 if the second one crosses the first one from its right to its left, −1 otherwise.
};

/// The radial graph of a surface of genus g: a polygon with 4g sides and one vertex from which the surface is glued,
/// and in it an edge from its centre to each of its corners. The faces of the graph are quadrilaterals, one around each
/// pair of sides, and all degrees are 4g ≥ 8, so that geodesics of its universal cover are found by counting turns.
///
/// The polygon is that of `polygon_sides`, with a spanning tree of its vertices contracted.
class RadialGraph {
 public:
  /// O(sides).
  explicit RadialGraph(const Surface& surface);

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// The number of edges, 4g; edge k ends in the start of side k of the polygon.
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(partner_.size()); }
  /// By side of the polygon: the one that it is glued to.
  [[nodiscard]] const std::vector<std::uint32_t>& partners() const { return partner_; }
  /// By side of the polygon: a path from tile 0 to itself across it, and across no other side of the polygon.
  [[nodiscard]] Word crossing(std::uint32_t side) const;

  /// The closed walk of a closed path, freely homotopic to it: without spurs and brackets, so that its lifts are
  /// geodesics, and of these the rightmost one, in its least rotation. It depends on the free homotopy class alone.
  /// Throws SurfaceError if the word is not a path from a tile to itself. Quadratic in the letters, at worst.
  [[nodiscard]] ClosedWalk walk_of(const Word& word) const;
  /// That of the curve in the other direction.
  [[nodiscard]] ClosedWalk reversed(const ClosedWalk& walk) const;
  /// The sides of the polygon that a walk crosses, outward, one after the other, from the start of an outward edge on.
  [[nodiscard]] std::vector<std::uint32_t> sides_of(const ClosedWalk& walk, std::size_t start = 0) const;
  /// The sides of the polygon that are crossed, outward, on the way around the vertex from one edge to another, the
  /// shorter way.
  [[nodiscard]] std::vector<std::uint32_t> sides_around(std::uint32_t from, std::uint32_t to) const;
  /// The sides of the polygon that are crossed, outward, once around the vertex, counterclockwise: each once.
  [[nodiscard]] std::vector<std::uint32_t> sides_around_vertex() const;
  /// A path from tile 0 to itself that crosses these sides of the polygon.
  [[nodiscard]] Word path(const std::vector<std::uint32_t>& sides) const;
  /// The greatest k such that a walk is a k-th power. Requires: not empty.
  [[nodiscard]] static std::uint32_t power_of(const ClosedWalk& walk);

  /// Where the closed geodesics of two primitive curves, of different classes up to direction, cross in any hyperbolic
  /// metric. O(nm) and the edges along which lifts are near each other.
  [[nodiscard]] std::vector<WalkCrossing> crossings(const ClosedWalk& first, const ClosedWalk& second) const;
  /// Where the closed geodesic of a primitive curve crosses itself: each crossing once, with the passage first that the
  /// other one crosses from right to left.
  [[nodiscard]] std::vector<WalkCrossing> self_crossings(const ClosedWalk& walk) const;
  /// Closed paths from tile 0 that go once around two walks, so that their axes are lifts that cross as is said.
  struct CrossingPaths {
    Word first;   ///< From the last centre of the first walk that is not after the crossing.
    Word second;  ///< From there,
    Word way;     ///< along this path to the last such centre of the second one, around, and back.
  };
  [[nodiscard]] CrossingPaths crossing_paths(const ClosedWalk& first, const ClosedWalk& second,
                                             const WalkCrossing& crossing) const;

  /// Whether the closed geodesics of primitive curves, no two of one class up to direction, fill the surface: all
  /// components of their complement are disks, in any hyperbolic metric. O(n²) for n edges.
  [[nodiscard]] bool fill(const std::vector<ClosedWalk>& walks) const;

  /// The class of a walk in the first homology group: by pair of sides, the lesser one of each, in their order, the
  /// coefficient of the curve that crosses this side once, outward.
  [[nodiscard]] std::vector<std::int64_t> homology(const ClosedWalk& walk) const;
  /// The lesser side of each pair, in their order: the basis of `homology`.
  [[nodiscard]] const std::vector<std::uint32_t>& basis() const { return basis_; }
  /// By pair of basis curves: their algebraic intersection number, 1 if the second one crosses the first from its right
  /// to its left.
  [[nodiscard]] std::vector<std::vector<std::int64_t>> intersection_form() const;

 private:
  class Lift;
  class Together;
  class Hull;

  /// Edge `count` places counterclockwise of an edge around the vertex where it starts, if it is taken outward or
  /// inward.
  [[nodiscard]] std::uint32_t turned(std::uint32_t edge, bool outward, std::uint32_t count) const;
  /// How many quadrilaterals are on the right between an edge and the next one of a walk, modulo 4g.
  [[nodiscard]] std::uint32_t turn(std::uint32_t edge, bool outward, std::uint32_t next) const;
  /// The edge on the other side of the quadrilateral on the right, or left, of an edge that is taken outward or inward.
  [[nodiscard]] std::uint32_t across(std::uint32_t edge, bool outward, bool right) const;
  /// If a walk of edges from `begin` on, the first one taken outward or not, ends with a spur or a bracket: how many
  /// edges that has. 0 otherwise.
  struct Shortcut {
    std::uint32_t edges = 0;
    bool right = true;
  };
  [[nodiscard]] Shortcut shortcut_at_end(std::span<const std::uint32_t> edges, bool outward) const;
  /// Makes a walk shorter until it is a geodesic.
  template <class Edges>
  void reduce(Edges& edges, bool outward) const;
  [[nodiscard]] ClosedWalk canonical(ClosedWalk walk) const;
  [[nodiscard]] ClosedWalk reduced(ClosedWalk walk) const;
  void push_right(ClosedWalk& walk) const;
  [[nodiscard]] std::vector<WalkCrossing> all_crossings(const ClosedWalk& first, const ClosedWalk& second,
                                                        bool same) const;

  Surface surface_;
  ById<TileId, Word> paths_;  ///< By tile: from tile 0 to it, inside the polygon.
  std::vector<std::uint32_t> partner_;
  std::vector<std::uint32_t> place_;  ///< By edge: its place counterclockwise around the corners' vertex,
  std::vector<std::uint32_t> edges_;  ///< and the edges there by their places.
  std::vector<SideId> crossed_;       ///< By side of the polygon: the side of a tile that it is.
  struct Passage {
    std::uint32_t out;
    std::uint32_t back;
  };
  ById<SideId, std::optional<Passage>> passage_;  ///< By side of a tile: the walk across it; none inside the polygon.
  std::vector<std::uint32_t> basis_;
  std::vector<std::vector<std::int64_t>> potential_;  ///< By edge a: that of out a, back edge 0.
};

}  // namespace epsnet
