#pragma once

#include <cstdint>
#include <filesystem>
#include <rapidcheck.h>
#include <string>
#include <vector>

#include "triangulation/surface/surface.h"

/// Polygons for tests, and changes to them that keep the surface.
namespace epsnet::test {

std::string file_text(const std::filesystem::path& path);

std::vector<std::filesystem::path> data_files(const std::string& folder);

/// The surface of a file that another program wrote (import_surface).
Surface imported(const std::filesystem::path& path);

/// One polygon and the partner of each of its sides.
struct PairedPolygon {
  Tile vertices;
  std::vector<std::uint32_t> partner;

  [[nodiscard]] std::vector<Gluing> gluing() const {
    std::vector<Gluing> pairs;
    for (std::uint32_t s = 0; s < partner.size(); ++s) {
      if (s < partner[s]) pairs.push_back({0, s, 0, partner[s]});
    }
    return pairs;
  }
  [[nodiscard]] Surface surface() const { return {{vertices}, gluing()}; }
};

PairedPolygon paired_polygon(const Surface& surface);

/// Returns CGAL's text format of a polygon, which need not be valid.
std::string domain_text(const PairedPolygon& polygon);

/// Returns the polygon with side `first` as side 0.
PairedPolygon rotated(const PairedPolygon& polygon, std::uint32_t first);

Tile moved(const Isometry<Rational>& isometry, const Tile& tile);

/// A random isometry with small rational coefficients.
rc::Gen<Isometry<Rational>> isometries();

/// Returns the same surface cut differently: the triangle of the sides k and k + 1 is cut off and glued to the partner
/// of side k.
///
/// Requires: these two sides are not glued to each other. If the polygon is convex, the result is simple, though it
/// need not be convex.
PairedPolygon cut_and_pasted(const PairedPolygon& polygon, std::uint32_t k);

/// Returns the same polygon with one more vertex on side k and one on its partner. Both have straight angles, and
/// together they are one more vertex of the surface.
PairedPolygon with_vertex_on_side(const PairedPolygon& polygon, std::uint32_t k, const Rational& share);

}  // namespace epsnet::test
