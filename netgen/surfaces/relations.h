#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "certify/numbers/exact.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/surfaces/group.h"

/// Relations of the generators of a surface's group: one that is left, and matrices that fulfil it.
namespace epsnet {

/// Sides of the polygon to be crossed one after the other; a word of the group.
using SidesOfPolygon = std::vector<std::uint32_t>;

[[nodiscard]] SidesOfPolygon inverse_of(const PolygonSides& polygon, SidesOfPolygon word);

/// The group of a surface with the generators that one relation leaves: one relation after the other is used up to
/// express a generator, until one is left, in which each generator occurs once in each direction.
struct OneRelator {
  explicit OneRelator(const PolygonSides& polygon);

  struct Expressed {
    std::uint32_t side;
    SidesOfPolygon word;
  };
  SidesOfPolygon relation;           ///< The product of their isometries is 1.
  std::vector<Expressed> expressed;  ///< Each by generators that are free or come later.
};

/// A relation in which every generator occurs twice, once in each direction, and which makes a polygon with these sides
/// a closed surface with one vertex: k + 1 is generator k, −(k + 1) its inverse.
using SurfaceRelation = std::vector<std::int32_t>;

/// Returns rational isometries of which the relation holds exactly, and that agree with the given ones to about `bits`
/// bits, if these fulfil it to about as many.
///
/// All but two are rounded. The relation is x u x⁻¹ v = 1 with y in u and y⁻¹ in v, after a rotation and perhaps the
/// inverse of a generator. That u and v have equal traces is a linear equation for y, as tr(y⁻¹B) = tr(yB⁻¹); and then
/// xu = v⁻¹x are linear equations for x of rank 2. Both have solutions near by, which are rational.
[[nodiscard]] std::vector<certify::ExactIsometry> rational_solution(const std::vector<Isometry<Mp256>>& generators,
                                                                    const SurfaceRelation& relation, unsigned bits);

/// Returns the solution of the relation for which the elements that `words` computes from generators are nearest to
/// `targets`, in the sum of the squares of the differences of their numbers: Newton's method from approximate
/// generators. All have determinant 1. Cubic in the number of generators.
[[nodiscard]] std::vector<Isometry<Mp256>> nearest_solution(
    std::vector<Isometry<Mp256>> generators, const SurfaceRelation& relation,
    const std::vector<Isometry<Mp256>>& targets,
    const std::function<std::vector<Isometry<Mp256>>(const std::vector<Isometry<Mp256>>&)>& words);

}  // namespace epsnet
