#include <cstddef>
#include <cstdint>
#include <optional>

#include "fuzz/nets.h"

namespace {

using epsnet::Complex;
using epsnet::Rational;
using fuzz::Bytes;

Rational coordinate(Bytes& bytes) { return Rational(bytes.integer(), 32768); }

/// Returns a symmetric octagon z0, …, z3, −z0, …, −z3 with z0 > 0 and opposite sides glued; z3 is moved along a
/// hyperbolic line through −z0 until the area is 4π. In the frame f(z) = (z + z0)/(1 + z0 z) the condition Im[(1 − z0
/// z̄1)(1 − z1 z̄2)(1 − z2 z̄3)(1 + z3 z̄0)] = 0 is linear in the factor by which f(z3) is scaled. Returns nullopt if it
/// has no solution, or if the octagon is not a fundamental polygon.
std::optional<epsnet::Surface> octagon(Bytes& bytes) {
  const Complex<Rational> one{1, 0};
  const Complex<Rational> z0{coordinate(bytes), 0};
  const Complex<Rational> z1{coordinate(bytes), coordinate(bytes)};
  const Complex<Rational> z2{coordinate(bytes), coordinate(bytes)};
  const Complex<Rational> start{coordinate(bytes), coordinate(bytes)};
  for (const auto& z : {z0, z1, z2, start}) {
    if (norm(z) >= 1) return std::nullopt;
  }
  const Complex<Rational> w = (start + z0) / (one + z0 * start);
  const Complex<Rational> k = (one - z0 * conj(z1)) * (one - z1 * conj(z2));
  const Rational slope = (k * conj(w) * (z0 + z2)).y;
  if (slope == 0) return std::nullopt;
  const Rational factor = (k * (one + z0 * z2)).y / slope;
  const Complex<Rational> moved = factor * w;
  if (norm(moved) >= 1) return std::nullopt;
  const Complex<Rational> z3 = (moved - z0) / (one - z0 * moved);
  try {
    return epsnet::Surface({{z0, z1, z2, z3, -z0, -z1, -z2, -z3}},
                           {{0, 0, 0, 4}, {0, 1, 0, 5}, {0, 2, 0, 6}, {0, 3, 0, 7}});
  } catch (const epsnet::SurfaceError&) {
    return std::nullopt;
  }
}

}  // namespace

/// For every octagon and every ε a net is found and proved.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  if (const auto surface = octagon(bytes)) fuzz::require_net(*surface, 0.2, bytes);
  return 0;
}
