#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "netgen/lifts/lifts.h"

/// One lift of every triangle of a net as a planar mesh, and the numbers of meshes as text.
namespace epsnet {

/// The drawn lifts with common corners identified: a triangulated disk whose boundary is glued side to side.
struct DrawnMesh {
  /// A point of the disk.
  struct Point {
    Complex<double> place;
    std::uint32_t vertex;  ///< Of the net: points with the same one are the same point of the surface.
  };
  /// A longest part of the boundary that one element of the group takes to another side.
  struct Side {
    std::vector<std::uint32_t> darts;  ///< Counterclockwise. The opposite of the first is the last one of the partner.
    std::uint32_t partner;             ///< The side that it is glued to, another one.
  };
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< In the order of the document.
  std::vector<bool> on_boundary;                        ///< By dart.
  std::vector<Side> sides;                              ///< Counterclockwise around the disk.

  /// Returns the point where a dart starts.
  [[nodiscard]] std::uint32_t start(std::uint32_t dart) const { return triangles[dart / 3][dart % 3]; }
  /// Returns the point where a dart ends.
  [[nodiscard]] std::uint32_t end(std::uint32_t dart) const { return triangles[dart / 3][(dart + 1) % 3]; }
};

/// Returns the mesh of some lifts. O(triangles).
[[nodiscard]] DrawnMesh drawn_mesh(const NetGeometry& geometry, const Lifts& lifts);

/// Returns the factor w of the hyperbolic metric w (dx² + dy²) at a point of the disk.
[[nodiscard]] inline double metric_weight(const Complex<double>& z) {
  const double s = 1 - norm(z);
  return 4 / (s * s);
}

/// Writes infinity, which JSON does not have, as the largest number.
[[nodiscard]] inline std::string circumradius_text(const NetGeometry& geometry, std::uint32_t triangle) {
  return certify::shortest(std::min(geometry.circumradius(triangle), std::numeric_limits<double>::max()));
}

/// The corners of a triangle in its own coordinates: three points (x, y, 0).
[[nodiscard]] inline std::string corners_text(const NetGeometry& geometry, std::uint32_t triangle) {
  std::string out;
  for (const Complex<double>& z : geometry.centred_corners(triangle)) {
    out += (out.empty() ? "" : " ") + certify::shortest(z.x) + ' ' + certify::shortest(z.y) + " 0";
  }
  return out;
}

/// "a<separator>b<separator>c" of indices.
template <class Indices>
[[nodiscard]] std::string joined(const Indices& indices, const char* separator) {
  std::string out;
  for (const std::uint32_t i : indices) out += (out.empty() ? "" : separator) + std::to_string(i);
  return out;
}

[[nodiscard]] inline std::string point_text(const Complex<double>& z, const char* separator) {
  return certify::shortest(z.x) + separator + certify::shortest(z.y);
}

}  // namespace epsnet
