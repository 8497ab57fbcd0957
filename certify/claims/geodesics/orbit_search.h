#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "certify/lifted/lifted_plane.h"

/// The elements of the surface's group that move a vertex little, by reverse search (docs/proof.md, section 11).
namespace epsnet::certify {

/// What is asked at every lift of the vertex that is found, in the order of the search.
enum class Search { go_on, stop };

/// An element as a product of labels, the last one applied first. It leads from the chart of the vertex to itself, and
/// is computed only when called.
using LabelProduct = std::function<std::vector<SignedLabel>()>;

struct OrbitOutcome {
  bool complete = false;  ///< Every element wanted was reported; false if this precision or `limit` does not suffice.
  bool limit_reached = false;
  std::uint64_t visits = 0;  ///< Lifted triangles, some perhaps twice.
};

/// Reports every element g of the group with d(ṽ, gṽ) ≤ D, including the identity; duplicates and extra elements are
/// possible. The dart leaves the vertex v, and g is written in the chart of v. `cosh_distance` and `sinh_distance` are
/// cosh D and sinh D.
///
/// The lifted triangles are a tree whose root Δ, that of the dart, contains a point q near ṽ: the parent of a triangle
/// is its neighbour across the first edge whose line separates it from q. The tree is walked without memory of what was
/// seen, and left where cosh d(q, C)/cosh R, which does not decrease from parent to child, is too large. Each gΔ that
/// is visited is a report of g. Time is proportional to the visits, memory to the depth.
[[nodiscard]] OrbitOutcome search_orbit(const LiftedPlane& plane, std::uint32_t dart, const Ball& cosh_distance,
                                        const Ball& sinh_distance, std::uint64_t limit,
                                        const std::function<Search(const BallIsometry&, const LabelProduct&)>& report);

}  // namespace epsnet::certify
