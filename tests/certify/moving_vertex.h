#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <vector>

#include "certify/net/numbering.h"
#include "tests/certify/reference.h"

/// What tests compare the checks of bounds with: triangulations with one vertex, in long double.
namespace epsnet::certify {

/// A triangulation with one vertex, which may be anywhere: what is across each dart, and the element that leads from
/// its start to its end.
struct Triangulation {
  std::vector<std::uint32_t> opposite;
  std::vector<Move> element;
};

/// Of the triangles abc and bax, with the dart d from a to b, the first becomes xca and the other one cxb.
inline void flip(Triangulation& triangulation, std::uint32_t d) {
  const Triangulation old = triangulation;
  const std::uint32_t e = old.opposite[d];
  const std::map<std::uint32_t, std::uint32_t> moved{{previous_dart(d), next_dart(d)},
                                                     {next_dart(e), previous_dart(d)},
                                                     {previous_dart(e), next_dart(e)},
                                                     {next_dart(d), previous_dart(e)}};
  for (const auto& [from, to] : moved) {
    const auto across = moved.find(old.opposite[from]);
    triangulation.opposite[to] = across == moved.end() ? old.opposite[from] : across->second;
    triangulation.opposite[triangulation.opposite[to]] = to;
    triangulation.element[to] = old.element[from];
  }
  // From c by way of a to x.
  triangulation.element[e] = old.element[previous_dart(d)] * old.element[next_dart(e)];
  triangulation.element[d] = inverted(triangulation.element[e]);
}

/// That of the net after some flips.
inline Triangulation triangulation_of(const Reference& reference, const std::vector<std::uint32_t>& flips = {}) {
  Triangulation result;
  for (std::uint32_t d = 0; d < 3 * reference.net().triangles.size(); ++d) {
    result.opposite.push_back(opposite(reference.net(), d));
    result.element.push_back(reference.element(d));
  }
  for (const std::uint32_t d : flips) flip(result, d);
  return result;
}

/// Half of the way from p to its image by the element of a dart.
inline double half_displacement(const Triangulation& triangulation, std::uint32_t dart, Complex p) {
  return static_cast<double>(distance(p, image(triangulation.element[dart], p)) / 2);
}

/// For each triangle with the one vertex p sinh²(d/2) of its sides.
inline std::vector<std::array<Real, 3>> triangles_at(const Triangulation& triangulation, Complex p) {
  std::vector<std::array<Real, 3>> result(triangulation.element.size() / 3);
  for (std::size_t d = 0; d < triangulation.element.size(); ++d) {
    result[d / 3][d % 3] = squared_half_sinh(p, image(triangulation.element[d], p));
  }
  return result;
}

/// 4abc/K, the sinh² of the circumradius.
inline Real circumradius_squared(const std::array<Real, 3>& a) {
  return 4 * a[0] * a[1] * a[2] / (4 * a[0] * a[1] - std::pow(a[0] + a[1] - a[2], 2));
}

/// Of the triangles with the one vertex p, the greatest radius of a disk that one needs.
inline double radius(const Triangulation& triangulation, Complex p) {
  Real result = 0;
  for (std::array<Real, 3> a : triangles_at(triangulation, p)) {
    std::sort(a.begin(), a.end());
    const Real square = a[2] >= a[0] + a[1] ? a[2] : circumradius_squared(a);
    result = std::max(result, std::asinh(std::sqrt(square)));
  }
  return static_cast<double>(result);
}

/// Of the triangles with the one vertex p, the greatest circumradius.
inline double circumradius(const Triangulation& triangulation, Complex p) {
  Real result = 0;
  for (const std::array<Real, 3>& a : triangles_at(triangulation, p)) {
    result = std::max(result, std::asinh(std::sqrt(circumradius_squared(a))));
  }
  return static_cast<double>(result);
}

/// Whether the triangulation with the one vertex p is Delaunay.
inline bool is_delaunay(const Triangulation& triangulation, Complex p) {
  for (std::uint32_t d = 0; d < triangulation.opposite.size(); ++d) {
    const Complex right = image(triangulation.element[next_dart(triangulation.opposite[d])], p);
    const Complex end = image(triangulation.element[d], p);
    const Complex left = image(inverted(triangulation.element[previous_dart(d)]), p);
    if (std::imag((left - right) * (end - p) * std::conj((left - p) * (end - right))) >= 0) return false;
  }
  return true;
}

/// The parts of a triangle that is cut at the midpoint of a side.
inline std::array<std::array<Complex, 3>, 2> halves(const std::array<Complex, 3>& z, std::uint32_t side) {
  const std::uint32_t end = (side + 1) % 3;
  // The midpoint, from the one of 0 and where the other goes if the first goes to 0.
  const Complex w = (z[end] - z[side]) / (Real{1} - std::conj(z[side]) * z[end]);
  const Complex half = w / (1 + std::sqrt(1 - std::norm(w)));
  const Complex midpoint = (half + z[side]) / (Real{1} + std::conj(z[side]) * half);
  std::array<std::array<Complex, 3>, 2> result{z, z};
  result[0][end] = midpoint;
  result[1][side] = midpoint;
  return result;
}

}  // namespace epsnet::certify
