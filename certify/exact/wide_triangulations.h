#pragma once

#include <vector>

#include "certify/exact/interval.h"
#include "certify/exact/net_structure.h"

namespace epsnet::exact {

/// Lemma 25 for a triangulation with one vertex at a point: whether it is Delaunay, all edges certainly locally so, and
/// has a circumradius R with sinh²R >= `least`. By what is across each dart, and sinh²(d/2) of each.
[[nodiscard]] Answer is_delaunay_and_wide(const std::vector<Index>& opposite, const std::vector<Interval>& h,
                                          const Interval& least);

}  // namespace epsnet::exact
