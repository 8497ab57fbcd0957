#include "netgen/nets/sparse.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "netgen/nets/refine.h"
#include "netgen/nets/relaxation.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

Length times(const Length& length, const Rational& factor) {
  const Rational product = length.value() * factor;
  return Length(product.str());
}

/// Returns `count` sweeps whose exponent grows evenly from the first to the last. A step of 1.4/exponent is nearly the
/// longest with which vertices come to rest.
std::vector<RelaxationSweep> sweeps(unsigned count, unsigned first, unsigned last) {
  std::vector<RelaxationSweep> result;
  for (unsigned k = 0; k < count; ++k) {
    const unsigned exponent = first + k * (last - first) / count;
    result.push_back({exponent, 1.4 / exponent, 0.7});
  }
  return result;
}

/// The numbers below were found by trials, which docs/design.md lists.
class SparseRefinement {
 public:
  SparseRefinement(Triangulation& triangulation, const Length& epsilon, const NetOptions& options)
      : triangulation_(triangulation), epsilon_(epsilon), options_(options), covering_(epsilon.value()) {
    if (options.base) kept_ = VertexId(0);
  }

  [[nodiscard]] NetStatistics run() {
    // 2.15/1.24² = 1.40 times the lower bound of ε.
    refine_for(Rational(124, 100), 0.15);
    // Sweeps pass over all triangles many times, so these should be near each other in memory.
    renumber_by_neighbours(triangulation_);
    relax_with(sweeps(14, 6, 14), 0.5);
    // Some places have a few points too many, others too few; relaxation alone would be slow to even this out.
    const std::array<Rational, 3> factors{Rational(106, 100), Rational(103, 100), Rational(102, 100)};
    for (std::size_t i = 0; i < factors.size() && (i == 0 || are_many_large()); ++i) {
      thin(factors[i]);
      refine_for(factors[i], shown_ + 0.03);
      relax_with(sweeps(8, 16, 16), shown_ + 0.1);
    }
    if (thin(1) > 0) relax_with(sweeps(3, 16, 16), 0.92);
    thin(1);
    refine_for(1, 1);
    return statistics_;
  }

 private:
  /// Refines for a larger ε. `shown` is the share of the progress that is done afterwards.
  void refine_for(const Rational& factor, double shown) {
    NetOptions options = options_;
    if (options_.progress) {
      options.progress = [this, shown](std::string_view what, double share) {
        options_.progress(what, shown_ + (shown - shown_) * share);
      };
    }
    const NetStatistics made = refine(triangulation_, factor == 1 ? epsilon_ : times(epsilon_, factor), options);
    shown_ = shown;
    statistics_.insertions += made.insertions;
    statistics_.flips += made.flips;
    statistics_.removed += made.removed;
    statistics_.located += made.located;
    statistics_.located_at_start += made.located_at_start;
    statistics_.walk_steps += made.walk_steps;
    statistics_.longest_walk = std::max(statistics_.longest_walk, made.longest_walk);
  }

  void relax_with(std::span<const RelaxationSweep> sweeps, double shown) {
    statistics_.flips += relax(triangulation_, covering_, sweeps, kept_);
    shown_ = shown;
    if (options_.progress) {
      options_.progress("net: " + std::to_string(triangulation_.vertex_count()) + " vertices, spread evenly", shown);
    }
  }

  /// Removes vertices that are closer than a multiple of ε to others, and returns how many.
  std::uint32_t thin(const Rational& factor) {
    const Threshold apart(epsilon_.value() * factor / 2);
    const auto contracts = [&](Dart d) {
      const Corner from = triangulation_.corner(d);
      const Corner to = triangulation_.corner(next_dart(d));
      return from.vertex != kept_ && triangulation_.compare_distance(from, to, apart) <= 0;
    };
    const std::uint32_t removed = contract_all(triangulation_, contracts);
    statistics_.removed += removed;
    statistics_.flips += make_delaunay(triangulation_);
    return removed;
  }

  /// Whether more than one percent of the triangles are larger than ε, each of which would lead to a new vertex.
  [[nodiscard]] bool are_many_large() {
    std::uint64_t large = 0;
    for (const TriangleId t : triangulation_.triangles()) {
      if (triangulation_.compare_circumradius(t, covering_) > 0) ++large;
    }
    return 100 * large > triangulation_.triangle_count();
  }

  Triangulation& triangulation_;
  const Length& epsilon_;
  const NetOptions& options_;
  const Threshold covering_;
  std::optional<VertexId> kept_;
  double shown_ = 0;
  NetStatistics statistics_;
};

}  // namespace

NetStatistics refine_sparsely(Triangulation& triangulation, const Length& epsilon, const NetOptions& options) {
  const double least = require_possible(triangulation.surface(), epsilon);
  const Vertex base = triangulation.vertex(VertexId(0));
  Triangulation plain = triangulation.clone();
  NetStatistics statistics = SparseRefinement(triangulation, epsilon, options).run();
  // With few points, or thin parts, the refinement alone may happen to be better. The base may also have moved.
  const Vertex first = triangulation.vertex(VertexId(0));
  const bool base_is_lost = options.base && !(first.z == base.z && first.chart == base.chart);
  if (base_is_lost || triangulation.vertex_count() > 1.5 * least) {
    const NetStatistics plain_statistics = refine(plain, epsilon, options);
    if (base_is_lost || plain.vertex_count() <= triangulation.vertex_count()) {
      triangulation = std::move(plain);
      statistics = plain_statistics;
    }
  }
  return statistics;
}

}  // namespace epsnet
