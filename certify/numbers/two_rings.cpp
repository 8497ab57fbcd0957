#include "certify/numbers/two_rings.h"

#include <algorithm>
#include <bit>
#include <flint/ulong_extras.h>

namespace epsnet::certify {
namespace {

/// k with Σ |x_i| <= 2^k.
std::uint64_t sum_bits(const Polynomial& x) {
  return bits_of_coefficients(x) +
         static_cast<std::uint64_t>(std::bit_width(static_cast<std::uint64_t>(fmpz_poly_length(x.get()))));
}

/// k such that all complex roots are at most 2^k: 2 max |f_(d−i)|^(1/i), as the polynomial is monic.
std::uint64_t root_bits(const Polynomial& f) {
  const slong degree = fmpz_poly_degree(f.get());
  std::uint64_t most = 0;
  for (slong i = 1; i <= degree; ++i) {
    const auto bits = static_cast<std::uint64_t>(fmpz_bits(fmpz_poly_get_coeff_ptr(f.get(), degree - i)));
    const auto root = static_cast<std::uint64_t>(i);
    most = std::max(most, (bits + root - 1) / root);
  }
  return most + 1;
}

std::uint64_t storage_bits(const Polynomial& x) {
  return (bits_of_coefficients(x) + 8) * static_cast<std::uint64_t>(fmpz_poly_length(x.get()));
}

}  // namespace

RealNumber real_number(const mpz_class& x) {
  const std::uint64_t bits = mpz_sizeinbase(x.get_mpz_t(), 2);
  return {1, 1, bits, bits};
}

RealNumber real_number(const RegularNumber& x) {
  // |ζ| = 1 for all conjugates of ζ, and those of s are roots of the conjugates of s².
  const std::uint64_t s = sum_bits(x.ring->square_of_s()) / 2 + 1;
  const std::uint64_t degree = x.ring->is_zero(x.v) ? 1 : 2;
  return {x.ring->order(), degree, std::max(sum_bits(x.u), sum_bits(x.v) + s) + 1,
          storage_bits(x.u) + storage_bits(x.v)};
}

RealNumber real_number(const FieldNumber& x) {
  const auto degree = static_cast<std::uint64_t>(x.field->degree());
  return {1, degree, sum_bits(x.re) + (degree - 1) * root_bits(x.field->f()), storage_bits(x.re)};
}

std::uint64_t cyclotomic_degree(std::uint64_t order) { return order <= 2 ? 1 : n_euler_phi(order) / 2; }

bool of_one_ring(const RegularNumber& x, const RegularNumber& y) {
  return x.ring->order() == y.ring->order() && are_equal(x.ring->square_of_s(), y.ring->square_of_s());
}

bool of_one_ring(const FieldNumber& x, const FieldNumber& y) {
  return are_equal(x.field->f(), y.field->f()) && x.field->between() == y.field->between();
}

}  // namespace epsnet::certify
