#include "tests/netgen/unfolding.h"

#include <cassert>
#include <cmath>
#include <unordered_map>

namespace epsnet {
namespace {

// Bounds are widened by this share. Rounding grows with the number of triangles crossed, but stays far below it even 20
// units away.
constexpr double kSlack = 1e-9;

}  // namespace

/// A triangle on the way back, the vertex moved into its chart, and the edges that are still to be crossed there.
struct Unfolding::Visit {
  TriangleId triangle;
  std::uint32_t
      entered;  ///< The corner whose dart was crossed on the way in; in the first triangle that of the vertex.
  std::uint32_t next_edge;  ///< The first edge across which the search has not gone yet.
  LorentzVector<double> vertex;
};

Unfolding::Unfolding(Triangulation& triangulation, double largest_circumradius)
    : triangulation_(triangulation),
      largest_circumradius_(largest_circumradius),
      dart_of_vertex_(triangulation.vertex_count()) {
  std::unordered_map<LabelId, std::uint32_t> number{{kIdentity, 0}};
  cells_.reserve(triangulation.triangle_count());
  for (const TriangleId t : triangulation.triangles()) {
    cells_.push_back(make_cell(triangulation, t));
    for (std::uint32_t i = 0; i < 3; ++i) {
      dart_of_vertex_[triangulation.corner(t, i).vertex] = make_dart(t, i);
      const LabelId label = triangulation.inverse(triangulation.transition(make_dart(t, i)));
      const auto [entry, is_new] = number.try_emplace(label, static_cast<std::uint32_t>(isometries_.size()));
      if (is_new) isometries_.push_back(triangulation.atlas().isometry(label));
      cells_[t].step[i] = entry->second;
    }
  }
}

Unfolding::Cell Unfolding::make_cell(Triangulation& triangulation, TriangleId t) {
  Cell cell{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    // These are computed precisely and rounded once, as corners may be far away in a triangle as long as a collar.
    const auto [vertex, label] = triangulation.corner(t, i);
    const LorentzVector<double> x = on_hyperboloid(triangulation.vertex(vertex).z);
    cell.corner[i] = label == kIdentity ? x : image(triangulation.atlas().isometry(label), x);
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    const LorentzVector<double> line = lorentz_cross(cell.corner[i], cell.corner[next(i)]);
    cell.line[i] = (1 / std::sqrt(std::max(lorentz_product(line, line), 1e-300))) * line;
    cell.power = cell.power + line;
  }
  const double determinant = lorentz_product(lorentz_cross(cell.corner[0], cell.corner[1]), cell.corner[2]);
  cell.power = (1 / determinant) * cell.power;
  return cell;
}

bool Unfolding::is_child(const Visit& parent, std::uint32_t edge, const LorentzVector<double>& carried) const {
  const Dart across = triangulation_.opposite(make_dart(parent.triangle, edge));
  const Cell& cell = cells_[triangle_of(across)];
  const double slack = kSlack * carried.t;
  // If binary64 cannot decide, the answer is yes here and no there: a triangle may be visited twice, but is not missed.
  for (std::uint32_t k = 0; k < corner_of(across); ++k) {
    if (lorentz_product(cell.line[k], carried) < -slack) return false;
  }
  return lorentz_product(cell.line[corner_of(across)], carried) < slack;
}

Isometry<double> Unfolding::element(const std::vector<Visit>& way, std::uint32_t corner) const {
  const auto label = [&](TriangleId t, std::uint32_t i) {
    const LabelId l = triangulation_.corner(t, i).label;
    return l == kIdentity ? Isometry<double>{} : triangulation_.atlas().isometry(l);
  };
  Isometry<double> result = label(way.back().triangle, corner);
  for (std::size_t i = way.size() - 1; i-- > 0;) {
    const std::uint32_t step = cells_[way[i].triangle].step[way[i].next_edge - 1];
    if (step != 0) result = inverse(isometries_[step]) * result;
  }
  return inverse(label(way.front().triangle, way.front().entered)) * result;
}

void Unfolding::report(const std::vector<Visit>& way, const Search& search, std::vector<ReturnPath>& found) const {
  const Visit& here = way.back();
  const Cell& cell = cells_[here.triangle];
  const VertexId vertex = triangulation_.corner(way.front().triangle, way.front().entered).vertex;
  const double farthest = std::cosh(search.displacement) * (1 + kSlack);
  const double slack = kSlack * here.vertex.t;
  for (std::uint32_t j = 0; j < 3; ++j) {
    if (triangulation_.corner(here.triangle, j).vertex != vertex) continue;
    // A lift is reported by the triangle around it through which it is seen; of two triangles beside an edge that leads
    // to it, by the one on the left.
    const bool seen = way.size() == 1 ? j == next(here.entered)
                                      : lorentz_product(cell.line[j], here.vertex) >= -slack &&
                                            lorentz_product(cell.line[previous(j)], here.vertex) >= -slack;
    const LorentzVector<double>& lift = cell.corner[j];
    if (!seen || -lorentz_product(lift, here.vertex) > farthest) continue;
    const Isometry<double> g = element(way, j);
    const bool inverse_comes = g.b.y < -kSlack * (std::abs(g.b.x) + std::abs(g.b.y));
    if (inverse_comes || std::abs(g.a.x) > std::cosh(search.translation / 2) * (1 + kSlack)) continue;
    ReturnPath path{make_dart(way.front().triangle, way.front().entered), {}, make_dart(here.triangle, j)};
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      path.darts.push_back(make_dart(way[i].triangle, way[i].next_edge - 1));
    }
    found.push_back(std::move(path));
  }
}

std::vector<ReturnPath> Unfolding::returns(VertexId vertex, const Search& search,
                                           const std::function<void()>& tick) const {
  assert(vertex.number() < dart_of_vertex_.size());
  constexpr std::uint64_t kTickEvery = 1U << 16;
  std::uint64_t visits = 0;
  // A triangle with a corner within D of the vertex has its circumcentre within D + R, and cosh(D + R)/cosh R grows
  // with R.
  const double most_power =
      (std::cosh(search.displacement) + std::sinh(search.displacement) * std::tanh(largest_circumradius_)) *
      (1 + kSlack);
  std::vector<ReturnPath> found;
  std::vector<Visit> way;
  for (const Dart d : triangulation_.star(dart_of_vertex_[vertex])) {
    way.assign(1, {triangle_of(d), corner_of(d), 0, cells_[triangle_of(d)].corner[corner_of(d)]});
    report(way, search, found);
    while (!way.empty()) {
      Visit& here = way.back();
      if (here.next_edge == 3) {
        way.pop_back();
        continue;
      }
      const std::uint32_t edge = here.next_edge++;
      if (way.size() == 1 ? edge != next(here.entered) : edge == here.entered) continue;
      const std::uint32_t step = cells_[here.triangle].step[edge];
      const LorentzVector<double> carried = step == 0 ? here.vertex : image(isometries_[step], here.vertex);
      const Dart across = triangulation_.opposite(make_dart(here.triangle, edge));
      if (lorentz_product(cells_[triangle_of(across)].power, carried) > most_power || !is_child(here, edge, carried))
        continue;
      if (tick && ++visits % kTickEvery == 0) tick();
      way.push_back({triangle_of(across), corner_of(across), 0, carried});
      report(way, search, found);
    }
  }
  return found;
}

}  // namespace epsnet
