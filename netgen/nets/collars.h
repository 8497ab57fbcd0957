#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "certify/net/document.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/base/options.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// A closed geodesic no longer than ε as seen from a vertex near it.
struct Core {
  ChartId chart;                 ///< The vertex's chart, whose coordinates are used below.
  Mp1024 sinh2;                  ///< sinh²(length/2).
  LorentzVector<Mp1024> foot;    ///< The point of the lifted core, a line, that is nearest to the vertex;
  LorentzVector<Mp1024> along;   ///< the unit vector along the line there,
  LorentzVector<Mp1024> normal;  ///< and that orthogonal to the line, the same everywhere.
};

/// The collars of short closed geodesics that a pseudo ε-net leaves empty (thesis III.5).
///
/// A collar is handled by inserting two vertices p and q at the distance d = max(d_ε, ε/8) from the core, one on each
/// side. At the distance d_ε curves around the core are ε long: sinh(ε/2) = sinh(length/2) cosh d_ε. Both vertices have
/// loops, and the annulus between these consists of two triangles. p and q are recognised by their charts, since each
/// is the origin of its own chart, which keeps its number when vertices and triangles are renumbered; the triangles are
/// recognised by their corners.
class Collars {
 public:
  /// Keeps a reference to the triangulation.
  Collars(Triangulation& triangulation, const Length& epsilon);

  /// Returns the core of a loop shorter than l_ε, sinh(l_ε/2) = √2 sinh(ε/2), at the start of d; nullopt if there is no
  /// such loop or its core is longer than ε. If the vertices are an ε-packing and the triangulation is Delaunay, every
  /// vertex in the l_ε-collar of such a core has such a loop (thesis Lemma III.8).
  [[nodiscard]] std::optional<Core> core_at(Dart d);
  /// Whether insert_pair was called for this core. `label` leads from its chart to the chart of triangle t, where the
  /// search starts.
  [[nodiscard]] bool is_handled(const Core& core, TriangleId t, LabelId label);
  /// Inserts the two vertices of a core and makes the triangulation Delaunay again. Throws NetError if no place is
  /// found for them.
  void insert_pair(const Core& core, TriangleId t, LabelId label, Journal* journal);

  [[nodiscard]] std::size_t count() const { return sides_.size() / 2; }
  /// Whether insert_pair made this vertex.
  [[nodiscard]] bool has_vertex(VertexId v) const { return partner_of(v).has_value(); }
  /// Whether one call of insert_pair made both vertices.
  [[nodiscard]] bool are_partners(VertexId u, VertexId v) const;
  /// Whether a triangle is one of the two in the annulus of a collar.
  [[nodiscard]] bool has_triangle(TriangleId t);

  /// The collars as a net file has them. Throws NetError if one is not an annulus of two triangles. O(n).
  [[nodiscard]] std::vector<certify::NetDocument::Collar> documents();

 private:
  /// The chart of the other vertex of the collar of v.
  [[nodiscard]] std::optional<ChartId> partner_of(VertexId v) const;
  /// A dart from a vertex to itself that is shorter than l_ε.
  [[nodiscard]] bool is_short_loop(Dart d);
  /// The dart of a triangle of an annulus that is its loop.
  [[nodiscard]] std::optional<Dart> loop_of(TriangleId t);
  /// A vertex of a collar.
  struct Side {
    ChartId partner;               ///< The chart of the other vertex of the collar.
    LabelId to_core;               ///< From its chart to the chart of the core.
    LorentzVector<Mp1024> normal;  ///< Of the core.
  };
  struct Inserted {
    VertexId vertex;
    LabelId to_core;      ///< From its chart to the chart of the core.
    TriangleId triangle;  ///< A triangle at the vertex.
    LabelId label;        ///< From the chart of the core to the chart of this triangle.
  };
  /// Makes a point of a core's chart the origin of a chart of its own. Throws NetError.
  [[nodiscard]] LiftedPoint point_near(const Core& core, const Complex<Mp1024>& z);
  [[nodiscard]] Inserted insert(const Core& core, const Complex<Mp1024>& z, TriangleId t, LabelId label,
                                Journal* journal);
  /// The darts to cross from a triangle to the nearest one with a vertex of a collar, and last the dart that leaves
  /// that vertex there; empty if there is no such vertex. O(n).
  [[nodiscard]] std::vector<Dart> way_to_collar(TriangleId t) const;

  /// Limit for a walk to a point beside a core, which may cross many triangles that wind around it. Walks end by thesis
  /// Theorem II.1.
  static constexpr std::uint32_t kMostSteps = 1'000'000;

  Triangulation& triangulation_;
  Mp1024 epsilon_;
  Mp1024 sinh2_half_;                        ///< sinh²(ε/2).
  std::unordered_map<ChartId, Side> sides_;  ///< By the chart of the vertex.
};

}  // namespace epsnet
