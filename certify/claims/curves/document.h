#pragma once

#include <cstdint>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/document.h"

/// The contents of a curves file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved. `check` (certify/check.h) decides whether
/// it is true. Lengths are hyperbolic.
namespace epsnet::certify {

/// A curves file: closed curves of a surface up to free homotopy, and what topology says of them.
struct CurvesDocument {
  /// The free homotopy class of a loop at a vertex, given as in a geodesics file.
  struct Curve {
    std::uint32_t vertex = 0;
    std::vector<std::uint32_t> word;
    Interval length{};                     ///< Contains that of the closed geodesic; 0 < lower ≤ upper.
    std::uint32_t power = 1;               ///< The greatest k for which it is a k-th power.
    std::uint64_t self_intersections = 0;  ///< The least number of double points of a curve in general position.
    std::vector<std::int64_t> homology;    ///< Its class in H₁(S; ℤ) is Σ homology[j] [curve basis[j]].
    bool operator==(const Curve&) const = default;
  };

  /// Two curves of the list.
  struct Pair {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint64_t intersections = 0;  ///< The geometric intersection number.
    /// Crossings of the second one from the right of the first one to its left count 1, others −1.
    std::int64_t algebraic = 0;
    bool operator==(const Pair&) const = default;
  };

  NetDocument net;
  std::vector<Curve> curves;
  std::vector<Pair> pairs;           ///< All, first < second, in lexicographic order.
  std::vector<std::uint32_t> basis;  ///< Curves whose classes are a basis of H₁(S; ℤ).
  /// Sets of curves, each ascending, that fill: all components of the complement of their geodesics are disks.
  std::vector<std::vector<std::uint32_t>> filling;
  bool operator==(const CurvesDocument&) const = default;
};

}  // namespace epsnet::certify
