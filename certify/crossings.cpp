#include <epsnet/certify/crossings.h>

#include <bit>

namespace epsnet::certify {

std::size_t RationalCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  std::size_t sum = frame_bits;
  for (const std::uint32_t side : word) sum += bits(crossings_[side]);
  return sum;
}

BallIsometry RegularCrossings::balls(std::uint32_t side, slong precision) const {
  const std::uint32_t genus = ring_->genus();
  BallIsometry result;
  Ball sinh;
  set_regular_apothem(result.a.re(), sinh.get(), genus, precision);
  set_regular_direction(result.b.get(), genus, side, precision);
  acb_mul_arb(result.b.get(), result.b.get(), sinh.get(), precision);
  acb_neg(result.b.get(), result.b.get());
  return result;
}

Isometry<RegularNumber> RegularCrossings::exact(std::uint32_t side) const {
  // ζ^(2g) = −1.
  const std::uint32_t half = 2 * ring_->genus();
  Isometry<RegularNumber> result{{ring_.get(), ring_->cotangent(), {}}, {ring_.get(), {}, {}}};
  fmpz_poly_set_coeff_si(result.b.odd.get(), side % half, side < half ? -1 : 1);
  return result;
}

Isometry<RegularNumber> RegularCrossings::embed(const ExactIsometry& f) const {
  return {regular_number(*ring_, f.a), regular_number(*ring_, f.b)};
}

std::size_t RegularCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  // Four polynomials of 2g coefficients; each letter multiplies coefficients by less than 4g.
  const std::size_t sides = size();
  return 2 * sides * (frame_bits + word.size() * static_cast<std::size_t>(std::bit_width(sides)));
}

}  // namespace epsnet::certify
