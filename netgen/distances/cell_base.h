#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "netgen/distances/vertex_triangulation.h"

/// Where a search for a bound starts to cut cells (docs/proof/bounds.md, Lemma 21.2).
namespace epsnet {

/// A triangle of unit vectors, with the cosh of its sides' lengths: side i is from corner i to corner i + 1.
struct PlacedTriangle {
  std::array<LorentzVector<EdgeElements::Number>, 3> corner;
  std::array<EdgeElements::Number, 3> cosh;
};

/// The triangulation of a net with one vertex, made less narrow: its edges split at their midpoints and flipped.
///
/// All triangles of the net meet at its vertex, and are narrow there. A cell of this triangulation is as wide as it is
/// long, so fewer of them cover the surface, and few meet at a point.
class CellBase {
 public:
  using Number = EdgeElements::Number;
  using Point = LorentzVector<Number>;

  /// The elements must outlive the object.
  CellBase(VertexTriangulation map, const Point& vertex, EdgeElements& elements);

  /// Splits edges until none is longer than 2, or an eighth of the longest one: along a collar that is long few cells
  /// are enough. Or until another one would make more triangles than these.
  void refine(std::size_t most_triangles);

  [[nodiscard]] std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(start_.size() / 3); }
  [[nodiscard]] PlacedTriangle triangle(std::uint32_t t) const;
  /// As files have them: 2d is a flip of dart d, 2d + 1 a split.
  [[nodiscard]] const std::vector<std::uint32_t>& steps() const { return steps_; }

 private:
  /// The end of a dart, next to the point of the vertex at its start.
  [[nodiscard]] Point end(std::uint32_t dart) const;
  [[nodiscard]] bool locally_delaunay(std::uint32_t dart) const;
  void flip(std::uint32_t dart);
  void split(std::uint32_t dart);
  void measure(std::uint32_t dart);
  /// Flips edges that are not locally Delaunay, those given and whatever follows.
  void make_delaunay(std::vector<std::uint32_t> darts);

  EdgeElements& elements_;
  VertexTriangulation map_;
  std::vector<std::uint32_t> start_;  ///< By dart: its vertex.
  std::vector<Point> points_;         ///< By vertex.
  std::vector<double> side_;          ///< By dart: sinh²(d/2).
  std::vector<std::uint32_t> steps_;
};

}  // namespace epsnet
