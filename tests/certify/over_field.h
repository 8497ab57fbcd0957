#pragma once

#include <utility>

#include "certify/net/document.h"
#include "certify/numbers/exact.h"

namespace epsnet::certify::test {

/// x(2 + √2), and x√2.
inline SurfaceDocument::FieldNumber stretched(const mpz_class& x) { return {2 * x, x}; }
inline SurfaceDocument::FieldNumber times_root(const mpz_class& x) { return {0, x}; }

/// The same surface over ℚ(√2): its vertices as vectors times 2 + √2, and its crossings times √2. Requires: glued sides
/// of equal length.
inline SurfaceDocument over_field(const SurfaceDocument& surface) {
  SurfaceDocument result;
  result.gluing = surface.gluing;
  result.field.polynomial = {-2, 0, 1};
  result.field.root = {1, 2};
  const auto corner = [&](std::uint32_t tile, std::uint32_t k) {
    return exact_point(surface.tiles[tile][k % surface.tiles[tile].size()]);
  };
  for (std::uint32_t t = 0; t < surface.tiles.size(); ++t) {
    auto& polygon = result.field.polygons.emplace_back();
    for (std::uint32_t k = 0; k < surface.tiles[t].size(); ++k) {
      const auto v = hyperboloid_vector(corner(t, k));
      polygon.push_back({stretched(v.x), stretched(v.y), stretched(v.t)});
    }
  }
  for (const auto& [t, k, u, l] : surface.gluing) {
    const ExactIsometry f = crossing(corner(t, k), corner(t, k + 1), corner(u, l), corner(u, l + 1));
    result.field.crossings.push_back({times_root(f.a.re), times_root(f.a.im), times_root(f.b.re), times_root(f.b.im)});
  }
  return result;
}

/// Whether all corners are in the disk, and glued sides of equal length.
inline bool has_crossings(const SurfaceDocument& surface) {
  struct Side {
    mpz_class square;  ///< |p − q|² over
    mpz_class gaps;    ///< (1 − |p|²)(1 − |q|²).
  };
  const auto side = [&](std::uint32_t tile, std::uint32_t k) {
    const auto& corners = surface.tiles[tile];
    const ExactPoint p = exact_point(corners[k]);
    const ExactPoint q = exact_point(corners[(k + 1) % corners.size()]);
    return gap(p) > 0 && gap(q) > 0 ? Side{norm(q.m * p.n - p.m * q.n), gap(p) * gap(q)} : Side{0, 1};
  };
  for (const auto& [t, k, u, l] : surface.gluing) {
    const Side one = side(t, k);
    const Side other = side(u, l);
    if (one.square == 0 || one.square * other.gaps != other.square * one.gaps) return false;
  }
  return true;
}

}  // namespace epsnet::certify::test
