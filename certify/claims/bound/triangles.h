#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certify/numbers/ball.h"
#include "certify/numbers/interval_arithmetic.h"

/// Triangulations with one vertex at a point, by numbers alone: the sinh²(d/2) of their edges (docs/proof.md, section
/// 15). In balls, which round to the precision of the caller, or in intervals of binary64.
namespace epsnet::certify {

// Triangulations as combinatorial data, and what makes one of another (docs/proof.md, section 15).

/// What is across each dart, and the element that leads from the dart's start to its end: 2k for element k and 2k + 1
/// for its inverse.
struct Map {
  std::vector<std::uint32_t> opposite;
  std::vector<std::uint32_t> element;
};

/// Two elements one after the other: what becomes of the diagonal of a flip.
struct Product {
  std::uint32_t first;
  std::uint32_t second;
};

/// Replaces the edge of dart d by the other diagonal, the element of number `diagonal`; its product is returned. The
/// triangles abc and bax, d from a to b, become xca and cxb: d is then from x to c. They are different.
Product flip(Map& map, std::uint32_t d, std::uint32_t diagonal);

/// A triangulation with more vertices than one, which is cut into cells. A dart from a to b with the element g leads
/// from the point of a to g of that of b.
struct Base {
  /// The point of a new vertex: in the middle between that of `from` and what the element makes of that of `to`.
  struct Midpoint {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t element;
  };

  Map map;
  std::vector<std::uint32_t> start;  ///< By dart: its vertex.
  std::vector<Midpoint> midpoints;   ///< Of vertex 1 and so on.
};

Product flip(Base& base, std::uint32_t d, std::uint32_t diagonal);

/// Splits the edge of dart d, `one` the number of the identity: the triangles abc and bax, d from a to b, become amc,
/// bmx and the last ones mbc, max. They are different.
void split(Base& base, std::uint32_t d, std::uint32_t one);

/// sinh²(d/2) of the three sides of a triangle.
template <class Number>
using SidesIn = std::span<const Number, 3>;
using Sides = SidesIn<Ball>;

/// Whether a triangle certainly lies in a disk of radius r, `most` its sinh²: its circumcircle is not larger, or it is
/// not acute and the disk with the longest side as diameter is not. `no` if it certainly does not.
[[nodiscard]] Tri fits(Sides sides, const Ball& most);
[[nodiscard]] Tri fits(SidesIn<Interval> sides, const Interval& most);

/// The measures of a triangle with a circumcircle.
template <class Number>
struct MeasuresIn {
  Number k;  ///< K = 4ab − (a + b − c)²: positive if there is a circumcircle.
  /// Of the angle opposite to each side in the Euclidean triangle with sides √a, √b, √c.
  std::array<Number, 3> cotangent;
  Number area;
};
using TriangleMeasures = MeasuresIn<Ball>;

/// Returns the measures of a triangle. Unless K is certainly positive, all other members are non-finite.
[[nodiscard]] TriangleMeasures measures(Sides sides);
[[nodiscard]] MeasuresIn<Interval> measures(SidesIn<Interval> sides);

/// Whether F triangles with one vertex, of these areas, that cover a closed surface once, if clockwise ones count
/// negatively, certainly are all counterclockwise: ΣA < A + π(F − 2) for each.
[[nodiscard]] Tri all_counterclockwise(std::span<const Ball> areas);
[[nodiscard]] Tri all_counterclockwise(std::span<const Interval> areas);

/// Whether the triangulation is Delaunay at the point, all edges certainly locally so (docs/proof.md, Lemma 25), and
/// its largest circumradius is at least r, `least` its sinh². What is across each dart, and sinh²(d/2) of each.
[[nodiscard]] Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Ball> h,
                                       const Ball& least);
[[nodiscard]] Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Interval> h,
                                       const Interval& least);

}  // namespace epsnet::certify
