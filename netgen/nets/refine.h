#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "netgen/nets/certified_net.h"
#include "netgen/nets/collars.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/surface.h"

/// The refinement that makes nets, its variants that the thesis compares, and what it counts: for the commands, for
/// experiments/ and for the tests. Nothing of it is public.
namespace epsnet {

/// How a circumcentre enters the triangulation. Both give the same Delaunay triangulation for the same point, exact
/// ties aside.
enum class Insertion {
  cavity,  ///< Bowyer–Watson from the large triangle itself; the fast way.
  flips,   ///< The thesis' way (IV.4.3 to IV.4.5): walk, split, flip.
};

/// Which triangles enter the list of the refinement, and in which order (thesis IV.4.7; the variants of Table IV.2). A
/// triangle is large if its circumradius is more than ε. All variants give ε-nets, but different ones.
enum class TriangleList {
  large_back,     ///< Variant C: large triangles alone, first in, first out. The fastest of the four here.
  all_back,       ///< Variant A, the thesis' choice: all new triangles, first in, first out; measured when taken.
  all_front,      ///< Variant B: all new triangles, last in, first out.
  largest_first,  ///< Variant D: large triangles alone, the largest first.
};

struct Variant {
  Insertion insertion = Insertion::cavity;
  Walk walk = Walk::visibility;  ///< How `Insertion::flips` finds the triangle that contains a circumcentre.
  /// If set, one thread makes the net in this order. Otherwise the order is the fastest one, large_back, and nets of
  /// 100,000 vertices or more are made in parts, on all cores, unless points are inserted by flips.
  std::optional<TriangleList> list = {};
};

/// The statistics of the thesis (IV.6.2), beside those of every net.
struct RefinementStatistics : NetStatistics {
  std::uint64_t flips = 0;             ///< Of the insertions. A cavity of k triangles counts as k − 1 flips.
  std::uint64_t initial_flips = 0;     ///< To make the input's triangulation Delaunay.
  std::uint64_t located = 0;           ///< Walks (`Insertion::flips` only).
  std::uint64_t located_at_start = 0;  ///< Circumcentres that lie in their own triangle.
  std::uint64_t walk_steps = 0;        ///< Triangles entered by all walks.
  std::uint64_t longest_walk = 0;
};

/// A net that is not proved, with the statistics of the thesis.
struct VariantNet {
  certify::NetDocument document;
  RefinementStatistics statistics;
};

/// Like compute_net (certified_net.h), by a variant.
[[nodiscard]] VariantNet compute_variant(const Surface& surface, const Length& epsilon, const Variant& variant,
                                         const NetOptions& options = {});

/// The values of a variant with their names on command lines and in records.
template <class Value, std::size_t N>
using VariantNames = std::array<std::pair<std::string_view, Value>, N>;
inline constexpr VariantNames<Insertion, 2> kInsertionNames{
    {{"cavity", Insertion::cavity}, {"flips", Insertion::flips}}};
inline constexpr VariantNames<Walk, 2> kWalkNames{{{"visibility", Walk::visibility}, {"straight", Walk::straight}}};
/// The letters of the thesis' Table IV.2.
inline constexpr VariantNames<TriangleList, 4> kTriangleListNames{{{"A", TriangleList::all_back},
                                                                   {"B", TriangleList::all_front},
                                                                   {"C", TriangleList::large_back},
                                                                   {"D", TriangleList::largest_first}}};

/// Returns the name of a value.
template <class Value, std::size_t N>
[[nodiscard]] constexpr std::string_view name_in(const VariantNames<Value, N>& names, Value value) {
  for (const auto& [name, known] : names) {
    if (known == value) return name;
  }
  return {};
}

// The lists of triangles still to be processed (thesis IV.4.7): numbers of slots, which may occur more than once.

/// First in, first out; a ring that doubles when it is full.
class TriangleQueue {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The i-th from the front.
  [[nodiscard]] TriangleId operator[](std::size_t i) const {
    assert(i < size_);
    return ring_[(first_ + i) & (ring_.size() - 1)];
  }
  /// Appends at most 1024 values.
  void push(std::span<const TriangleId> values) {
    assert(values.size() <= 1024);
    if (size_ + values.size() > ring_.size()) {
      std::rotate(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(first_), ring_.end());
      first_ = 0;
      ring_.resize(2 * ring_.size());
    }
    for (const TriangleId value : values) {
      ring_[(first_ + size_++) & (ring_.size() - 1)] = value;
    }
  }
  TriangleId pop() {
    const TriangleId value = (*this)[0];
    first_ = (first_ + 1) & (ring_.size() - 1);
    --size_;
    return value;
  }

 private:
  std::vector<TriangleId> ring_ = std::vector<TriangleId>(1024);
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// Last in, first out.
class TriangleStack {
 public:
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  void push(std::span<const TriangleId> values) { values_.insert(values_.end(), values.begin(), values.end()); }
  TriangleId pop() {
    assert(!values_.empty());
    const TriangleId value = values_.back();
    values_.pop_back();
    return value;
  }

 private:
  std::vector<TriangleId> values_;
};

/// The largest first; among equal ones the lowest number first.
class TriangleHeap {
 public:
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  void push(TriangleId value, double size) { heap_.emplace(size, ~value.number()); }
  TriangleId pop() {
    assert(!heap_.empty());
    const TriangleId value(~heap_.top().second);
    heap_.pop();
    return value;
  }

 private:
  std::priority_queue<std::pair<double, std::uint32_t>> heap_;
};

// The thesis' bounds for all nets of a surface, in floating point: nothing here is proved.

/// (g − 1)/sinh²(ε/2): no ε-covering of a surface of genus g has fewer points (thesis Theorem III.2).
[[nodiscard]] double least_vertices(std::uint32_t genus, double epsilon);

/// 16 (g − 1)/ε²: no ε-packing of a surface of genus g whose systole is at least ε has more points (thesis Theorem
/// III.1).
[[nodiscard]] double most_vertices(std::uint32_t genus, double epsilon);

/// Returns a lower bound, rounded down, for the systole of a surface. Requires: the surface has an ε-net whose Delaunay
/// triangulation has no loop shorter than `shortest_loop` (infinity if it has no loops).
///
/// If a geodesic from a vertex p to itself is shorter than l_ε, sinh(l_ε/2) = √2 sinh(ε/2), the shortest one is an edge
/// (thesis Lemma III.8). So each of them, for all p, has length at least m = min(l_ε, shortest_loop). A closed geodesic
/// of length σ comes within ε of a vertex p; the geodesic from p to p that follows it has the length ℓ with
/// sinh(ℓ/2) = sinh(σ/2) cosh d(p, σ) ≤ sinh(σ/2) cosh ε (Theorem I.24). Hence sinh(σ/2) ≥ sinh(m/2)/cosh ε. For nets
/// without loops and ε < arsinh 1 this is more than ε, the bound of Lemma III.15. It is a little less than l_ε, the
/// bound of III.5.5 for ε < ln √2. We do not claim the latter, since a systole between ε and l_ε need not have a vertex
/// in its l_ε-collar.
[[nodiscard]] double systole_lower_bound(double epsilon, double shortest_loop);

/// Returns the lower bound for the number of vertices of a net of the surface (thesis Theorem III.2). Throws NetError
/// if it is more than 2²⁹, the limit of `refine`.
double require_possible(const Surface& surface, const Length& epsilon);

/// Refines a Delaunay triangulation whose vertices are an ε-packing until they are an ε-net (thesis Algorithm IV.4.1
/// with a list of IV.4.7).
///
/// Even before the certifier checks it, every inserted point is proved to be at least ε away from the others, and every
/// remaining triangle to have a circumradius of at most ε. With `collars` the result is a pseudo ε-net (Algorithm
/// III.10): collars of cores no longer than ε are emptied, and the triangles in them are not refined. Throws NetError
/// if this fails. Returns the statistics, except for `initial_flips`, `collars` and those of the document.
RefinementStatistics refine(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                            const Variant& variant = {}, Collars* collars = nullptr);

/// A net as a triangulation, not proved.
struct TriangulatedNet {
  Triangulation triangulation;
  RefinementStatistics statistics;
  std::optional<std::vector<certify::NetDocument::Collar>> collars;  ///< Of a pseudo net.
};

/// Like compute_variant, as a triangulation.
[[nodiscard]] TriangulatedNet triangulated_net(const Surface& surface, const Length& epsilon,
                                               const NetOptions& options = {}, const Variant& variant = {});

// Refinement on all cores.

/// Options of a refinement in parts.
struct PartOptions {
  double expected_vertices;                          ///< Approximately, of the whole net.
  unsigned threads;                                  ///< 0: as many as there are cores.
  std::function<void(std::size_t vertices)> report;  ///< Gets the number so far; called on the calling thread only.
};

/// The result of a refinement in parts.
struct PartResult {
  std::uint64_t insertions = 0;
  std::uint64_t flips = 0;          ///< As RefinementStatistics counts them.
  std::vector<TriangleId> pending;  ///< Triangles still marked; some may turn out not to be large.
};

/// Inserts the circumcentres of large triangles in many parts of a Delaunay triangulation concurrently, with
/// insert_locally only. Triangles that it cannot decide, or that are near the boundary of a part, stay `pending` in
/// the result. Requires: `pending` are all large triangles, and they are marked. The result depends on the
/// triangulation only, not on `threads` (docs/design.md, "On all cores"). Throws LimitError and what `report` throws;
/// the triangulation is then unusable.
[[nodiscard]] PartResult refine_in_parts(Triangulation& triangulation, std::vector<TriangleId> pending,
                                         const Threshold& apart, const Threshold& large, const PartOptions& options);

// Sparse nets.

/// How one sweep moves vertices (`relax`).
struct RelaxationSweep {
  unsigned exponent;  ///< n: a circumcentre weighs as the area of its triangle times (sinh R)²ⁿ.
  double step;        ///< The share of the way to the weighted mean by which a vertex moves.
  double momentum;    ///< The share of the last sweep's move that is added.
};

/// Moves the vertices of a Delaunay triangulation so that its circumradii become more equal: each sweep moves every
/// vertex towards a mean of the circumcentres around it, in which large circles weigh most, and flips edges until the
/// triangulation is Delaunay again. With a step much larger than 2/exponent the vertices do not come to rest.
///
/// The vertices of a triangle stay for a sweep if it would turn over, or if binary64 cannot compute its circumcircle.
/// `kept` never moves. `size` is sinh²R of a typical triangle, which keeps weights from overflowing. The result is the
/// same on every machine, as only + − × ÷ √ are used. O(n) for each sweep. Returns the number of flips.
///
/// Exponent 0, step 1 and no momentum give the smoothing of optimal Delaunay triangulations (Chen, Xu, 2004).
std::uint64_t relax(Triangulation& triangulation, const Threshold& size, std::span<const RelaxationSweep> sweeps,
                    std::optional<VertexId> kept = std::nullopt);

/// Turns a Delaunay triangulation into that of an ε-net with few points (docs/design.md, "Sparse nets"): refines it for
/// a larger ε, relaxes it (`relax`), removes vertices that are too close and inserts circumcentres of triangles that
/// are too large. It ends with `refine`, so everything that `refine` proves holds here as well.
///
/// If the result has more than 1.5 times the lower bound for the number of points, the ordinary refinement (`refine`)
/// is made as well, and is the result if it has no more points. A vertex 0 that is the base point (`options.base`)
/// stays in its place; the other vertices are renumbered. Throws as `refine` does. Returns the statistics; `removed`
/// counts all vertices removed on the way.
RefinementStatistics refine_sparsely(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                                     const Variant& variant);

}  // namespace epsnet
