#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/plane.h"
#include "netgen/geodesics/axis_catalogue.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// The lifts of a Delaunay triangulation around one of its vertices, in binary64.
///
/// Triangles are visited by reverse search (Avis, Fukuda): the parent of a lifted triangle is the one across the first
/// of its edges whose line separates it from the vertex. Only the way back is stored. In a Delaunay triangulation the
/// chain of parents ends at the vertex (the visibility walk, thesis Theorem II.1), and the power of the vertex with
/// respect to their circumcircles does not increase on the way there, which bounds the search. The visited triangle
/// stays in its chart, and the vertex is moved into that chart; most steps are between triangles of one chart.
class Unfolding {
 public:
  /// Keeps a reference to the triangulation, and evaluates everything once. `largest_circumradius` bounds the
  /// circumradii (hyperbolic). O(triangles).
  Unfolding(Triangulation& triangulation, double largest_circumradius);

  struct Search {
    double displacement;  ///< Lifts within this hyperbolic distance are reported,
    double translation;   ///< if their element has at most this translation length.
  };

  /// Returns paths to all lifts of a vertex that `search` asks for, except to the vertex itself. Of each pair of
  /// inverse elements mostly one is reported; a lift may be reported twice. Bounds are taken a little larger than
  /// given, so that rounding misses none. The time is about the number of triangles in a disk whose radius is
  /// `displacement` plus two circumradii. Thread-safe. `tick`, if given, is called occasionally.
  [[nodiscard]] std::vector<ReturnPath> returns(VertexId vertex, const Search& search,
                                                const std::function<void()>& tick = {}) const;

 private:
  struct Cell {
    std::array<LorentzVector<double>, 3> corner;
    std::array<LorentzVector<double>, 3> line;  ///< By dart: the unit normal of the edge, positive inside.
    LorentzVector<double> power;  ///< ⟨power, X⟩ = cosh d(X, C)/cosh R for the circumcentre C and the circumradius R.
    std::array<std::uint32_t, 3> step;  ///< By dart: which isometry leads to the chart of the triangle across.
  };
  struct Visit;

  [[nodiscard]] static Cell make_cell(Triangulation& triangulation, TriangleId t);
  [[nodiscard]] bool is_child(const Visit& parent, std::uint32_t edge, const LorentzVector<double>& carried) const;
  [[nodiscard]] Isometry<double> element(const std::vector<Visit>& way, std::uint32_t corner) const;
  void report(const std::vector<Visit>& way, const Search& search, std::vector<ReturnPath>& found) const;

  const Triangulation& triangulation_;
  double largest_circumradius_;
  ById<TriangleId, Cell> cells_;
  std::vector<Isometry<double>> isometries_{{}};  ///< Number 0 is the identity.
  ById<VertexId, Dart> dart_of_vertex_;
};

}  // namespace epsnet
