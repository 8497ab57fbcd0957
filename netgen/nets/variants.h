#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "netgen/nets/certified_net.h"
#include "triangulation/mesh/operations.h"

/// The variants of the refinement that the thesis compares, and what it counts: for experiments/ and for the tests of
/// these variants. Nothing of it is public.
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

}  // namespace epsnet
