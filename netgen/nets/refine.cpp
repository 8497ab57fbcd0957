#include "netgen/nets/refine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "kernel/numbers.h"
#include "netgen/nets/triangulations.h"
#include "triangulation/mesh/insertion.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {

double least_vertices(std::uint32_t genus, double epsilon) {
  const double s = std::sinh(epsilon / 2);
  return (static_cast<double>(genus) - 1) / (s * s);
}

double most_vertices(std::uint32_t genus, double epsilon) {
  return 16 * (static_cast<double>(genus) - 1) / (epsilon * epsilon);
}

double systole_lower_bound(double epsilon, double shortest_loop) {
  // In these numbers sinh and cosh of a large ε do not overflow and are as accurate as binary64.
  const Mp256 at_thin_loops = sqrt(Mp256(2)) * sinh(Mp256(epsilon) / 2);
  const Mp256 at_loops =
      std::isinf(shortest_loop) ? at_thin_loops : std::min(at_thin_loops, Mp256(sinh(Mp256(shortest_loop) / 2)));
  const auto bound = static_cast<double>(2 * asinh(Mp256(at_loops / cosh(Mp256(epsilon)))));
  return std::isfinite(bound) ? std::nextafter(bound, 0.0) : 0;
}

namespace {

template <TriangleList kList>
using ListOf =
    std::conditional_t<kList == TriangleList::all_front, TriangleStack,
                       std::conditional_t<kList == TriangleList::largest_first, TriangleHeap, TriangleQueue>>;

/// A triangle on the list is marked for as long as it occupies its slot.
template <TriangleList kList>
class Refinement {
 public:
  Refinement(Triangulation& triangulation, const Length& epsilon, const NetOptions& options, const Variant& variant,
             Collars* collars)
      : triangulation_(triangulation),
        options_(options),
        variant_(variant),
        collars_(collars),
        large_(epsilon.value()),
        apart_(epsilon.value() / 2),
        known_labels_(triangulation.atlas()) {
    const double least = require_possible(triangulation.surface(), epsilon);
    // An empirical factor (thesis IV.6.2).
    expected_ = 2.17 * least + 1;
    triangulation_.reserve(static_cast<std::size_t>(1.1 * expected_ + 1000));
    if (!variant.list && variant.insertion == Insertion::cavity && expected_ >= kLeastInParts) {
      parts_from_ = expected_ / kCoarser;
    }
  }

  [[nodiscard]] RefinementStatistics run() {
    statistics_.removed += reduce_to_packing(triangulation_, apart_);
    if (collars_ != nullptr) {
      statistics_.removed += clear_collars(triangulation_, apart_, *collars_);
    }
    for (const TriangleId t : triangulation_.triangles()) {
      enter(t);
    }
    initial_triangles_ = triangulation_.triangle_count();
    std::uint64_t count = 0;
    while (list_.size() > 0) {
      if (triangulation_.vertex_count() >= parts_from_) {
        refine_parts();
        continue;
      }
      const TriangleId t = list_.pop();
      // Memory is fetched while earlier entries are processed, which saves a fifth of the time for nets larger than the
      // caches. (This is not a function of its own, as g++ 12 removes calls of functions that only prefetch.)
      if constexpr (std::is_same_v<ListOf<kList>, TriangleQueue>) {
        if (list_.size() > 12) {
          prefetch_triangle(triangulation_, list_[12]);
          prefetch_neighbours(triangulation_, list_[7]);
          prefetch_second_neighbours(triangulation_, list_[3]);
        }
      }
      // In the thesis the list has darts, which outlive their triangles (IV.4.7). Likewise, whatever triangle is in the
      // slot now is taken, if it is marked. Taking only the original triangle gives 1.5% fewer points, but is not the
      // algorithm that the thesis measured.
      if (!triangulation_.triangle(t).marked()) {
        continue;
      }
      if (!kLargeAlone && !needs_its_centre(t)) {
        unmark(triangulation_, t);
        continue;
      }
      insert_circumcentre(t);
      ++statistics_.insertions;
      constexpr std::uint64_t kReportEvery = 1 << 14;
      if (++count % kReportEvery == 0) {
        report(triangulation_.vertex_count());
      }
    }
    return statistics_;
  }

 private:
  /// Nets with fewer vertices are made in the thesis' order. Larger ones are made in parts once they have the part
  /// 1/kCoarser of their vertices.
  static constexpr double kLeastInParts = 100'000;
  static constexpr double kCoarser = 64;
  /// If this share of the vertices is missing after the parts (because labels were not known yet), parts are tried
  /// again after a quarter of the large triangles has been processed.
  static constexpr double kShareForMore = 0.05;
  static constexpr bool kLargeAlone = kList == TriangleList::large_back || kList == TriangleList::largest_first;

  [[nodiscard]] bool is_large(TriangleId t) { return triangulation_.compare_circumradius(t, large_) > 0; }

  /// Whether the circumcentre of t is to be inserted: t is large and not in the annulus of a collar.
  [[nodiscard]] bool needs_its_centre(TriangleId t) {
    return is_large(t) && !(collars_ != nullptr && collars_->has_triangle(t));
  }

  /// Puts a new triangle on the list; if the list is for large triangles only, just those that `needs_its_centre`
  /// accepts.
  void enter(TriangleId t) {
    if (!kLargeAlone || needs_its_centre(t)) {
      mark(triangulation_, t);
      push({&t, 1});
    }
  }

  /// The same for the triangles of insert_locally, which has marked the large ones.
  void enter(const NewTriangles& made) {
    if constexpr (kLargeAlone) {
      push({made.large_slots.data(), made.large_count});
      for (const TriangleId t : std::span(made.unsure_slots.data(), made.unsure_count)) {
        enter(t);
      }
    } else {
      for (const TriangleId t : std::span(made.slots.data(), made.count)) {
        enter(t);
      }
    }
  }

  void push(std::span<const TriangleId> triangles) {
    if constexpr (kList == TriangleList::largest_first) {
      for (const TriangleId t : triangles) {
        list_.push(t, circumradius_order(t));
      }
    } else {
      list_.push(triangles);
    }
  }

  /// Returns sinh²(R/2), where R is the circumradius; infinity if binary64 cannot compute the centre.
  [[nodiscard]] double circumradius_order(TriangleId t) const {
    const auto centre = circumcentre_fast(triangulation_.mesh(), triangulation_.atlas(), t);
    if (!centre || norm(*centre) >= 1) {
      return std::numeric_limits<double>::infinity();
    }
    const Complex<double> corner = triangulation_.vertex(triangulation_.triangle(t).vertex[0]).z;
    return norm(*centre - corner) / ((1 - norm(corner)) * (1 - norm(*centre)));
  }

  /// Reports the number of vertices so far, and per second.
  void report(std::size_t vertices) const {
    if (!options_.progress) return;
    std::string text = "net: " + std::to_string(vertices) + " vertices";
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
    if (seconds.count() > 1) {
      const auto thousands = static_cast<std::uint64_t>(static_cast<double>(vertices) / (1000 * seconds.count()));
      text += ", " + std::to_string(thousands) + " thousand/s";
    }
    options_.progress(text, std::min(0.99, static_cast<double>(vertices) / expected_));
  }

  /// Continues in parts, on all cores. The triangles still pending afterwards are on the list.
  void refine_parts() {
    parts_from_ = std::numeric_limits<double>::infinity();
    std::vector<TriangleId> pending;
    pending.reserve(list_.size());
    while (list_.size() > 0) {
      const TriangleId t = list_.pop();
      if (triangulation_.triangle(t).marked()) pending.push_back(t);
    }
    const PartResult result = refine_in_parts(triangulation_, std::move(pending), apart_, large_,
                                              {expected_, options_.threads, [this](std::size_t n) { report(n); }});
    statistics_.insertions += result.insertions;
    statistics_.flips += result.flips;
    for (const TriangleId t : result.pending) {
      if (needs_its_centre(t)) {
        push({&t, 1});
      } else {
        unmark(triangulation_, t);
      }
    }
    const double vertices = triangulation_.vertex_count();
    if (expected_ - vertices > kShareForMore * expected_) {
      parts_from_ = vertices + static_cast<double>(list_.size()) / 4;
    }
  }

  void insert_circumcentre(TriangleId t) {
    // Nearly always binary64 computes the centre accurately, and it stays in the triangle's chart.
    const auto centre_in_chart = circumcentre_fast(triangulation_.mesh(), triangulation_.atlas(), t);
    const Atlas& atlas = triangulation_.atlas();
    if (centre_in_chart && norm(*centre_in_chart) < 0.95) {
      const LiftedPoint near = in_nearest_chart(triangulation_.mesh(), atlas, t, *centre_in_chart);
      if (norm(near.z) <= kChartRadius * kChartRadius) {
        if (variant_.insertion == Insertion::cavity &&
            insert_locally(Editor(triangulation_).mesh(), known_labels_, t, near, apart_, large_, new_triangles_)) {
          enter(new_triangles_);
          statistics_.flips += new_triangles_.count - 3;
          return;
        }
        if (insert(t, near, InCircle::known)) {
          return;
        }
      } else {
        const ChartId chart = triangulation_.chart_of(t);
        std::optional<LiftedPoint> point = atlas.lifted_point_nearby(chart, *centre_in_chart);
        if (!point)
          point = triangulation_.lifted_point(chart, convert<Mp1024>(*centre_in_chart), Atlas::Precision::binary64);
        if (point && insert(t, *point, InCircle::unknown)) {
          return;
        }
      }
    }
    // Binary64 cannot compute the centre, or the rounded centre is too close to a vertex: more bits are used, and in
    // the end the centre becomes the origin of a chart of its own.
    if (insert_precise(t, circumcentre_precise<Mp256>(triangulation_, t)) ||
        insert_precise(t, circumcentre_precise<Mp1024>(triangulation_, t))) {
      return;
    }
    throw NetError("no point near the circumcentre of a triangle with vertices " +
                   to_string(triangulation_.triangle(t).vertex[0]) + ", " +
                   to_string(triangulation_.triangle(t).vertex[1]) + ", " +
                   to_string(triangulation_.triangle(t).vertex[2]) +
                   " could be proved to be at least epsilon away from all vertices");
  }

  /// Makes a centre the next vertex, rounded to binary64 or, if that is too close to a vertex, as the origin of a chart
  /// of its own. False, with nothing changed, if neither works.
  [[nodiscard]] bool insert_precise(TriangleId t, const std::optional<Complex<Mp1024>>& centre) {
    return centre &&
           (insert_at(t, *centre, Atlas::Precision::binary64) || insert_at(t, *centre, Atlas::Precision::bits_256));
  }

  [[nodiscard]] bool insert_at(TriangleId t, const Complex<Mp1024>& centre, Atlas::Precision precision) {
    // A centre that seems too far away may turn out to be near when it is computed with more bits.
    const auto point = triangulation_.lifted_point(triangulation_.chart_of(t), centre, precision);
    return point && insert(t, *point, InCircle::unknown);
  }

  /// Whether a point is known to lie in the circumcircle of a triangle.
  enum class InCircle { known, unknown };

  /// Makes a point the next vertex. False, with nothing changed, if it is not in the circumcircle of t or cannot be
  /// proved to be at distance ε from all vertices.
  [[nodiscard]] bool insert(TriangleId t, const LiftedPoint& point, InCircle in_circle) {
    const VertexId v = add_vertex(triangulation_, {point.z, point.chart});
    const Corner p{v, point.label};
    const bool in_conflict = in_circle == InCircle::known ||
                             triangulation_.in_circle(triangulation_.corner(t, 0), triangulation_.corner(t, 1),
                                                      triangulation_.corner(t, 2), p) > 0;
    if (in_conflict && variant_.insertion == Insertion::cavity) {
      const auto is_apart = [&](const Cavity::Edge& e) {
        return triangulation_.compare_distance(e.from, p, apart_) > 0;
      };
      if (cavity_.find(triangulation_, t, p) && std::ranges::all_of(cavity_.boundary(), is_apart)) {
        const std::span<const TriangleId> fan = cavity_.fill(triangulation_, p, nullptr);
        for (const TriangleId s : fan) {
          enter(s);
        }
        // A cavity of k triangles has k + 2 edges, as many as splitting one triangle and k − 1 flips give.
        statistics_.flips += fan.size() - 3;
        return true;
      }
    }
    pop_vertex(triangulation_);
    return in_conflict && insert_with_flips(t, point);
  }

  /// Walk, split, flip (thesis IV.4.3 to IV.4.5). False, with nothing changed, if the point turns out too close to a
  /// vertex, or too far from t.
  [[nodiscard]] bool insert_with_flips(TriangleId t, const LiftedPoint& point) {
    Journal journal = open_journal(triangulation_);
    // A circumcentre is a few steps away from its triangle; at first perhaps as many as there are triangles (the fan of
    // a regular polygon). It is farther away only if rounding has moved it around a very short curve.
    const std::uint32_t most_steps = 40 + initial_triangles_;
    const auto inserted = insert_by_flips(triangulation_, t, point, variant_.walk, most_steps, &journal);
    if (!inserted) {
      return false;
    }
    const std::vector<TriangleId> changed = changed_triangles(journal);
    const VertexId v = inserted->vertex;
    const auto is_new = [v](VertexId a, VertexId b) { return a == v || b == v; };
    if (short_edge(changed, is_new)) {
      undo(triangulation_, journal);
      return false;
    }
    if (leads_to_collar(t, point, inserted->dart, journal)) {
      return true;
    }
    for (const TriangleId s : changed) {
      enter(s);
    }
    statistics_.flips += inserted->flips;
    if (variant_.insertion == Insertion::flips) {
      ++statistics_.located;
      statistics_.located_at_start += inserted->steps == 0 ? 1 : 0;
      statistics_.walk_steps += inserted->steps;
      statistics_.longest_walk = std::max<std::uint64_t>(statistics_.longest_walk, inserted->steps);
    }
    return true;
  }

  /// Returns the first dart of the given triangles that leads from one vertex to a different one, satisfies
  /// `counts(from, to)` and is not proved to be longer than ε; nullopt if there is none.
  template <class Counts>
  [[nodiscard]] std::optional<Dart> short_edge(std::span<const TriangleId> triangles, const Counts& counts) {
    for (const TriangleId s : triangles) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner a = triangulation_.corner(s, i);
        const Corner b = triangulation_.corner(s, next(i));
        if (a.vertex != b.vertex && counts(a.vertex, b.vertex) && triangulation_.compare_distance(a, b, apart_) <= 0) {
          return make_dart(s, i);
        }
      }
    }
    return std::nullopt;
  }

  /// Whether the vertex that insert_by_flips has just inserted, the start of d, is in the l_ε-collar of a core no
  /// longer than ε whose collar was not handled before. If so, undoes the insertion and handles the collar (Algorithm
  /// III.10, step 2).
  ///
  /// It is enough to test this here: a vertex in such a collar has a loop (Lemma III.8), and a cavity makes no loops,
  /// as it joins its new vertex to old ones only (Cavity::find returns false if lifts of the cavity meet).
  [[nodiscard]] bool leads_to_collar(TriangleId t, const LiftedPoint& point, Dart d, const Journal& journal) {
    if (collars_ == nullptr) {
      return false;
    }
    const std::optional<Core> core = collars_->core_at(d);
    if (!core || collars_->is_handled(*core, triangle_of(d), triangulation_.corner(d).label)) {
      return false;
    }
    undo(triangulation_, journal);
    ++statistics_.undone;
    handle_collar(t, point.label, *core);
    return true;
  }

  /// Inserts the two vertices of a core. The two triangles of its annulus are never refined, and no other large
  /// triangle has its centre in the annulus between the two loops, or between a loop pp' and its diametral circle. For
  /// such a centre would be nearer than ε to a vertex, or its circle would cross the loop pp'; the vertices that the
  /// loop cuts off would then lie in the disk with diameter pp', nearer than ε to p, as the loop is shorter than l_ε
  /// (Lemma III.11). And no later vertex lies in the circumdisk of a triangle of the annulus, as the part of it outside
  /// of the annulus is in the same disks. So these triangles stay. Collars::documents and the certifier check this.
  void handle_collar(TriangleId t, LabelId label, const Core& core) {
    Journal journal = open_journal(triangulation_);
    collars_->insert_pair(core, t, label, &journal);
    const std::vector<TriangleId> changed = changed_triangles(journal);
    const auto no_partners = [this](VertexId a, VertexId b) { return !collars_->are_partners(a, b); };
    if (const std::optional<Dart> d = short_edge(changed, no_partners)) {
      const VertexId near = std::min(triangulation_.corner(*d).vertex, triangulation_.corner(next_dart(*d)).vertex);
      throw NetError("a vertex beside a short closed geodesic is closer than epsilon to vertex " + to_string(near));
    }
    for (const TriangleId s : changed) {
      enter(s);
    }
    // t was taken from the list, but may be as large as before.
    if (triangulation_.triangle(t).marked() && std::find(changed.begin(), changed.end(), t) == changed.end()) {
      push({&t, 1});
    }
  }

  /// Returns the slots whose triangle has changed, or lost its mark, since the journal was opened, in the order in
  /// which they first changed.
  [[nodiscard]] std::vector<TriangleId> changed_triangles(const Journal& journal) const {
    std::vector<TriangleId> result;
    for (const auto& [t, before] : journal.overwritten) {
      const Triangle& now = triangulation_.triangle(t);
      if ((now.vertex != before.vertex || now.labels_and_mark != before.labels_and_mark) &&
          std::find(result.begin(), result.end(), t) == result.end()) {
        result.push_back(t);
      }
    }
    for (TriangleId t(journal.triangles); t.number() < triangulation_.triangle_count(); ++t) {
      result.push_back(t);
    }
    return result;
  }

  Triangulation& triangulation_;
  const NetOptions& options_;
  const Variant& variant_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  RefinementStatistics statistics_;
  Collars* collars_;  ///< Null unless the net is a pseudo net.
  Threshold large_;
  Threshold apart_;
  double expected_;
  double parts_from_ = std::numeric_limits<double>::infinity();  ///< Number of vertices from which parts are used.
  std::uint32_t initial_triangles_ = 0;
  ListOf<kList> list_;
  Cavity cavity_;
  NewTriangles new_triangles_;
  KnownLabels known_labels_;
};

}  // namespace

double require_possible(const Surface& surface, const Length& epsilon) {
  const Threshold apart(epsilon.value() / 2);
  const double s = std::sqrt(apart.high());
  const double least = (surface.genus() - 1.0) / (s * s);
  constexpr double kMostVertices = 0x1p29;
  if (!(least < kMostVertices)) {
    throw NetError("epsilon = " + epsilon.text() + " needs more than " + std::to_string(std::uint64_t{1} << 29) +
                   " vertices, the limit (thesis Theorem III.2)");
  }
  return least;
}

RefinementStatistics refine(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                            const Variant& variant, Collars* collars) {
  switch (variant.list.value_or(TriangleList::large_back)) {
    case TriangleList::all_back:
      return Refinement<TriangleList::all_back>(triangulation, epsilon, options, variant, collars).run();
    case TriangleList::all_front:
      return Refinement<TriangleList::all_front>(triangulation, epsilon, options, variant, collars).run();
    case TriangleList::largest_first:
      return Refinement<TriangleList::largest_first>(triangulation, epsilon, options, variant, collars).run();
    case TriangleList::large_back:
      break;
  }
  return Refinement<TriangleList::large_back>(triangulation, epsilon, options, variant, collars).run();
}

}  // namespace epsnet
