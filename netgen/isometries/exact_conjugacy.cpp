#include "netgen/isometries/exact_conjugacy.h"

#include <cstdint>
#include <utility>

#include "certify/net/crossings.h"
#include "netgen/base/gmp.h"

namespace epsnet {
namespace {

certify::Gaussian to_gaussian(const Complex<Rational>& z) {
  // Integers, as crossings are.
  return {to_gmp(z.x).get_num(), to_gmp(z.y).get_num()};
}

}  // namespace

std::optional<certify::Crossings> joint_crossings(const Surface& first, const Surface& second) {
  if (first.regular_tile() != second.regular_tile()) return std::nullopt;
  const std::uint32_t count = first.side_count();
  if (const auto& tile = first.regular_tile()) {
    std::vector<std::uint32_t> partner;
    for (const SideId s : first.side_ids()) partner.push_back(first.partner(s).number());
    for (const SideId s : second.side_ids()) partner.push_back(count + second.partner(s).number());
    return certify::RegularCrossings({tile->p, tile->q}, std::move(partner));
  }
  std::vector<certify::ExactIsometry> crossings;
  for (const Surface* surface : {&first, &second}) {
    for (const SideId s : surface->side_ids()) {
      const Isometry<Rational>& f = surface->crossing(s);
      crossings.push_back({to_gaussian(f.a), to_gaussian(f.b)});
    }
  }
  return certify::RationalCrossings(std::move(crossings));
}

std::optional<bool> are_conjugate(const Surface& first, const Surface& second, std::span<const ElementPair> pairs) {
  const std::optional<certify::Crossings> crossings = joint_crossings(first, second);
  if (!crossings) return std::nullopt;
  std::vector<ElementPair> shifted(pairs.begin(), pairs.end());
  for (ElementPair& pair : shifted) {
    for (std::uint32_t& side : pair.to) side += first.side_count();
  }
  return certify::are_conjugate(*crossings, shifted, {});
}

}  // namespace epsnet
