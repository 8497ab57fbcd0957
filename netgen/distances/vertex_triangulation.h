#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/distances/vertex_triangulation.h"
#include "triangulation/mesh/triangulation.h"

/// Triangulations with one vertex, which can be at any point: triangles whose edges are elements of the group.
///
/// If the vertex is the point p of the disk of one chart, the edge with the element g leads from p to gp. So one
/// combinatorial triangulation is a triangulation at many p, and its functions of p are evaluated without any label.
namespace epsnet {

/// The elements of the group that edges have. Each is stored once, together with its inverse.
class EdgeElements {
 public:
  using Number = Mp1024;
  /// An element or the inverse of it: 2k or 2k + 1 for element k.
  using Id = std::uint32_t;
  [[nodiscard]] static Id inverse(Id id) { return id ^ 1U; }

  /// Returns the id of a hyperbolic isometry of determinant 1, or of the identity.
  [[nodiscard]] Id add(const Isometry<Number>& g);
  [[nodiscard]] Isometry<Number> isometry(Id id) const;
  [[nodiscard]] Id product(Id f, Id g) { return add(isometry(f) * isometry(g)); }
  [[nodiscard]] std::size_t size() const { return elements_.size(); }
  /// sinh²(d/2), d the distance of p, a unit vector, and gp: sinh²(l/2) + ⟨n, p⟩², l the translation length of g and n
  /// the normal of its axis, of square sinh²(l/2).
  [[nodiscard]] Number displacement(Id id, const LorentzVector<Number>& p) const;

  struct Element {
    Isometry<Number> isometry;
    LorentzVector<Number> normal;
    Number square;
  };
  [[nodiscard]] const Element& element(std::size_t k) const {
    assert(k < elements_.size());
    return elements_[k];
  }

 private:
  std::vector<Element> elements_;
  std::map<std::array<Number, 3>, std::uint32_t> numbers_;
};

/// A point of the disk near which elements are evaluated in binary64, with a relative error of about e^2d times the
/// unit roundoff at the distance d from it.
class Frame {
 public:
  /// A point of the plane in the coordinates of the frame, a unit vector.
  using Point = LorentzVector<double>;

  /// `origin` has square −1. The elements must outlive the frame.
  Frame(const EdgeElements& elements, const LorentzVector<EdgeElements::Number>& origin);
  [[nodiscard]] const EdgeElements& elements() const { return elements_; }
  [[nodiscard]] Point point(const LorentzVector<EdgeElements::Number>& p) const;
  /// The cosh of the distance of a point from the origin; much cheaper than the point.
  [[nodiscard]] double cosh_distance(const LorentzVector<EdgeElements::Number>& p) const;
  /// Like the function of the elements.
  [[nodiscard]] double displacement(EdgeElements::Id id, const Point& p);

 private:
  struct Axis {
    Point normal;
    double square = -1;  ///< Negative: not evaluated yet.
  };
  /// Elements that are near each other in their order are used at the same places: most pages are in few frames.
  using Page = std::array<Axis, 64>;

  /// A vector in the coordinates of the frame.
  [[nodiscard]] Point moved(const LorentzVector<EdgeElements::Number>& v) const;

  const EdgeElements& elements_;
  LorentzVector<EdgeElements::Number> origin_;
  /// What becomes of the vectors of the axes.
  std::array<LorentzVector<EdgeElements::Number>, 3> axes_;
  std::vector<std::unique_ptr<Page>> pages_;
};

/// Darts as net files number them: 3t + i leaves corner i of triangle t.
struct VertexTriangulation {
  std::vector<std::uint32_t> opposite;    ///< By dart.
  std::vector<EdgeElements::Id> element;  ///< By dart: from its start to its end.

  /// Returns the edges' elements, sorted: they are the same for equal triangulations and for no others.
  [[nodiscard]] std::vector<std::uint32_t> key() const;
  /// Replaces the edge of dart d, which has two different triangles, by the other diagonal of its quadrilateral, as
  /// docs/format.md says: d and its opposite become the new edge, turned counterclockwise.
  void flip(EdgeElements& elements, std::uint32_t d);
  /// Splits the edge of dart d, which has two different triangles, by a new vertex, as docs/format.md says. There are
  /// two triangles more, at the end.
  void split(EdgeElements& elements, std::uint32_t d);
};

/// A triangulation with its vertex at a point: the lengths of edges, as sinh²(d/2) by dart, and what follows from
/// these. Where binary64 does not suffice, the numbers of the elements are used.
class PlacedTriangulation {
 public:
  using Number = EdgeElements::Number;

  /// Places the vertex at a unit vector p. Near the frame's origin binary64 numbers are used. The triangulation and the
  /// frame must outlive the object.
  PlacedTriangulation(const VertexTriangulation& triangulation, Frame& frame, const LorentzVector<Number>& p);

  [[nodiscard]] double displacement(std::uint32_t dart) const { return displacement_[dart]; }
  /// Returns sinh²ρ, where ρ is the greatest radius of the smallest disks that contain the corners of a triangle.
  [[nodiscard]] double largest_enclosure() const;
  /// Returns sinh²(d/2) of the shortest edge.
  [[nodiscard]] double shortest_edge() const;
  /// Whether all triangles are counterclockwise.
  [[nodiscard]] bool counterclockwise() const;
  /// Returns darts of edges that are not locally Delaunay, no two of them of one triangle, the longest edges first.
  /// None if the triangulation is Delaunay. All of them flipped at once: a new edge is then a product of few others.
  [[nodiscard]] std::vector<std::uint32_t> flips() const;
  /// Whether all edges are locally Delaunay and none is nearly a tie.
  [[nodiscard]] bool is_strictly_delaunay() const;

 private:
  [[nodiscard]] Number exact_displacement(std::uint32_t dart) const;
  [[nodiscard]] bool counterclockwise(std::uint32_t triangle) const;
  /// Whether cot γ + cot γ' ≥ 0 for the angles opposite to the edge of a dart, with a tolerance of the share `tie` of
  /// the squares of the sides. For `tie` = 0 this means that the edge is locally Delaunay.
  [[nodiscard]] bool locally_delaunay(std::uint32_t dart, double tie) const;

  const VertexTriangulation& triangulation_;
  const EdgeElements& elements_;
  LorentzVector<Number> point_;
  std::vector<double> displacement_;
};

/// The elements and triangles of a triangulation with one vertex, in the chart of that vertex, dart by dart as in its
/// document.
[[nodiscard]] VertexTriangulation vertex_triangulation(Triangulation& triangulation, EdgeElements& elements);

// Where a search for a bound starts to cut cells (docs/proof/bounds.md, Lemma 21.2).

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
