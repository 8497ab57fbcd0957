#include "netgen/pants/exact_crossings.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "netgen/base/gmp.h"

namespace epsnet {
namespace {

certify::Gaussian to_gaussian(const Complex<Rational>& z) {
  // Integers, as crossings are.
  return {to_gmp(z.x).get_num(), to_gmp(z.y).get_num()};
}

}  // namespace

certify::Crossings crossings_of(const Surface& surface) {
  if (const auto& tile = surface.regular_tile()) {
    std::vector<std::uint32_t> partner;
    for (const SideId s : surface.side_ids()) partner.push_back(surface.partner(s).number());
    return certify::RegularCrossings({tile->p, tile->q}, std::move(partner));
  }
  std::vector<certify::ExactIsometry> crossings;
  for (const SideId s : surface.side_ids()) {
    const Isometry<Rational>& f = surface.crossing(s);
    crossings.push_back({to_gaussian(f.a), to_gaussian(f.b)});
  }
  return certify::RationalCrossings(std::move(crossings));
}

}  // namespace epsnet
