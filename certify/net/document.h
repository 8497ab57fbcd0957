#pragma once

#include <array>
#include <cstdint>
#include <gmpxx.h>
#include <optional>
#include <string>
#include <vector>

#include "certify/base/tile.h"

/// The contents of a net file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved. `check` (certify/check.h) decides whether it is
/// true.
namespace epsnet::certify {

/// A surface file: tiles glued side to side, which are listed, or all regular, or have corners over a number field; or
/// a surface known by name.
struct SurfaceDocument {
  /// A strictly convex polygon, vertices counterclockwise; side k goes from vertex k to vertex k + 1.
  using Tile = std::vector<RationalPoint>;

  /// Side `side` of tile `tile` is glued to side `other_side` of tile `other_tile`.
  struct Gluing {
    std::uint32_t tile;
    std::uint32_t side;
    std::uint32_t other_tile;
    std::uint32_t other_side;
    bool operator==(const Gluing&) const = default;
  };

  /// The number e₀ + e₁α + e₂α² + … of a field, by its coefficients.
  using FieldNumber = std::vector<mpz_class>;

  /// The number field ℚ(α), tiles with corners over it, and how each gluing moves them.
  struct Field {
    /// Vectors of Minkowski space, up to positive factors.
    using Polygon = std::vector<std::array<FieldNumber, 3>>;

    /// Of α, from the coefficient of 1 on; the last one is 1. Empty: there is no field.
    std::vector<mpz_class> polynomial;
    std::array<mpq_class, 2> root;  ///< α is the root between these two.
    std::vector<Polygon> polygons;
    /// By gluing: z ↦ (Az + B)/(B̄z + Ā), by Re A, Im A, Re B, Im B.
    std::vector<std::array<FieldNumber, 4>> crossings;
    bool operator==(const Field&) const = default;
  };

  std::vector<Tile> tiles;
  std::vector<Gluing> gluing;
  std::uint32_t regular_genus = 0;  ///< Not 0: the regular 4g-gon of this genus; tiles and gluing are then empty.
  RegularTile map_tile;             ///< p ≠ 0: that of a map, the polygon that every tile is; tiles is then empty.
  Field field;                      ///< With a polynomial: that of the tiles, which it has; tiles is then empty.
  std::string about;                ///< Free text in UTF-8, no part of any claim.
  bool operator==(const SurfaceDocument&) const = default;
};

/// A net file. Label number k ≥ 1 is labels[k − 1].
struct NetDocument {
  /// The disk of a tile with the origin moved to `centre`: z ↦ (z + c)/(1 + c̄z) leads to the tile's coordinates.
  struct Chart {
    std::uint32_t tile;
    RationalPoint centre;
    bool operator==(const Chart&) const = default;
  };

  /// The isometry of a word from the coordinates of chart `from` to those of chart `to`.
  struct Label {
    std::uint32_t from;
    std::uint32_t to;
    std::vector<std::uint32_t> word;
    bool operator==(const Label&) const = default;
  };

  /// The point of the surface with the coordinate x + iy in a chart.
  struct Vertex {
    double x;
    double y;
    std::uint32_t chart;
    bool operator==(const Vertex&) const = default;
  };

  /// Corners counterclockwise in the chart of vertex[0]; opposite[i] is the dart 3t' + j across dart 3t + i;
  /// label[i − 1] is the label number of corner i, 0 for the identity.
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::array<std::uint32_t, 3> opposite;
    std::array<std::uint32_t, 2> label;
    bool operator==(const Triangle&) const = default;
  };

  /// A collar that a pseudo net leaves uncovered; its core is a short closed geodesic. The two triangles form the
  /// annulus between a loop at vertices[0] and a loop at vertices[1], one on each side of the core. vertices[0] is two
  /// corners of triangles[0] and one corner of triangles[1].
  struct Collar {
    std::vector<std::uint32_t> core;  ///< A word from the tile of the chart of vertices[0] to itself.
    std::array<double, 2> length;     ///< Ends of an interval that contains the core's length.
    std::array<std::uint32_t, 2> vertices;
    std::array<std::uint32_t, 2> triangles;
    bool operator==(const Collar&) const = default;
  };

  SurfaceDocument surface;
  std::string epsilon;  ///< A decimal or a rational, exactly as written.
  std::vector<Chart> charts;
  std::vector<Label> labels;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::optional<std::vector<Collar>> collars;  ///< Present, perhaps empty, in a pseudo net.
  bool operator==(const NetDocument&) const = default;
};

}  // namespace epsnet::certify
