#include "netgen/geodesics/cut_surface.h"

#include <array>

#include "netgen/base/disjoint_sets.h"

namespace epsnet {
namespace {

/// The cells of the triangles when they are cut along arcs, and which of them are connected.
class Cells {
 public:
  Cells(const Triangulation& triangulation, const std::vector<std::vector<CornerArc>>& curves)
      : triangulation_(triangulation), arcs_(triangulation.triangle_count()), first_(triangulation.triangle_count()) {
    for (const auto& curve : curves) {
      for (const CornerArc& arc : curve) ++arcs_[arc.triangle][arc.corner];
    }
    std::uint32_t count = 0;
    for (const TriangleId t : triangulation.triangles()) {
      first_[t] = count;
      count += arcs_[t][0] + arcs_[t][1] + arcs_[t][2] + 1;
    }
    components_ = DisjointSets(count);
    for_each_segment([&](std::uint32_t cell, std::uint32_t beyond) { components_.join(cell, beyond); });
  }

  [[nodiscard]] std::uint32_t size() const { return components_.size(); }
  [[nodiscard]] std::uint32_t component(std::uint32_t cell) { return components_.find(cell); }

  /// Returns the cell with `rank` arcs between it and a corner. The central cell is the last one of every corner.
  [[nodiscard]] std::uint32_t at_corner(TriangleId t, std::uint32_t corner, std::uint32_t rank) const {
    if (rank == arcs_[t][corner]) return first_[t] + arcs_[t][0] + arcs_[t][1] + arcs_[t][2];
    std::uint32_t cell = first_[t] + rank;
    for (std::uint32_t i = 0; i < corner; ++i) cell += arcs_[t][i];
    return cell;
  }

  /// Calls visit(cell, cell beyond) for each of the segments into which arcs cut the edges.
  template <class Visit>
  void for_each_segment(const Visit& visit) const {
    for (const TriangleId t : triangulation_.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Dart d = make_dart(t, i);
        const Dart e = triangulation_.opposite(d);
        if (e < d) continue;
        const std::uint32_t crossings = arcs_[t][i] + arcs_[t][next(i)];
        for (std::uint32_t s = 0; s <= crossings; ++s) visit(along(d, s), along(e, crossings - s));
      }
    }
  }

 private:
  /// Returns the cell beside segment s of a dart.
  [[nodiscard]] std::uint32_t along(Dart d, std::uint32_t s) const {
    const TriangleId t = triangle_of(d);
    const std::uint32_t i = corner_of(d);
    return s <= arcs_[t][i] ? at_corner(t, i, s) : at_corner(t, next(i), arcs_[t][i] + arcs_[t][next(i)] - s);
  }

  const Triangulation& triangulation_;
  ById<TriangleId, std::array<std::uint32_t, 3>> arcs_;  ///< By triangle and corner: how many arcs cut it off.
  ById<TriangleId, std::uint32_t> first_;
  DisjointSets components_{0};
};

}  // namespace

std::vector<certify::GeodesicsDocument::Piece> cut_surface(const Triangulation& triangulation,
                                                           const std::vector<std::vector<CornerArc>>& curves) {
  Cells cells(triangulation, curves);
  // The curves are circles, of characteristic 0, so the characteristic of a piece is that of its interior.
  std::vector<int> characteristic(cells.size());
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) ++characteristic[cells.component(cell)];
  cells.for_each_segment([&](std::uint32_t cell, std::uint32_t) { --characteristic[cells.component(cell)]; });
  ById<VertexId, bool> counted(triangulation.vertex_count());
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const VertexId v = triangulation.corner(t, i).vertex;
      if (!counted[v]) ++characteristic[cells.component(cells.at_corner(t, i, 0))];
      counted[v] = true;
    }
  }

  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> piece_of(cells.size(), kNone);
  std::vector<std::uint32_t> component_of;
  std::vector<certify::GeodesicsDocument::Piece> pieces;
  const auto piece = [&](std::uint32_t cell) -> certify::GeodesicsDocument::Piece& {
    const std::uint32_t component = cells.component(cell);
    if (piece_of[component] == kNone) {
      piece_of[component] = static_cast<std::uint32_t>(pieces.size());
      pieces.emplace_back();
      component_of.push_back(component);
    }
    return pieces[piece_of[component]];
  };
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    const CornerArc& arc = curves[c].front();
    for (const std::uint32_t side : {0U, 1U}) {
      const bool at_corner = arc.corner_is_left == (side == 0);
      piece(cells.at_corner(arc.triangle, arc.corner, at_corner ? arc.rank : arc.rank + 1))
          .boundaries.emplace_back(c, side);
    }
  }
  if (curves.empty()) (void)piece(0);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const int boundaries = static_cast<int>(pieces[p].boundaries.size());
    pieces[p].genus = static_cast<std::uint32_t>((2 - characteristic[component_of[p]] - boundaries) / 2);
  }
  return pieces;
}

}  // namespace epsnet
