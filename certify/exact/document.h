#pragma once

#include <array>
#include <cstdint>
#include <gmpxx.h>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/exact/json.h"
#include "certify/exact/plane.h"

/// The documents that this checker knows (docs/format.md).
namespace epsnet::exact {

using Index = std::uint32_t;
using RationalPoint = Point<mpz_class>;

struct Label {
  Index from;
  Index to;
  std::vector<Index> word;
};

struct Vertex {
  Index chart;
  RationalPoint z;
};

struct Triangle {
  std::array<Index, 3> vertex;
  std::array<Index, 3> opposite;
  std::array<Index, 3> label;  ///< By corner; corner 0 has the identity.
};

/// Of a pseudo net.
struct Collar {
  std::vector<Index> core;
  std::array<mpq_class, 2> length;
  std::array<Index, 2> vertices;
  std::array<Index, 2> triangles;
};

/// Of a regular surface or a map: p-gons with the angles 2π/q.
struct RegularTiles {
  Index p;
  Index q;
};

struct Net {
  std::vector<std::vector<RationalPoint>> tiles;  ///< Unless they are regular.
  std::optional<RegularTiles> regular;
  std::vector<std::array<Index, 4>> gluing;
  mpq_class epsilon;
  std::vector<std::pair<Index, RationalPoint>> charts;
  std::vector<Label> labels;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::optional<std::vector<Collar>> collars;

  [[nodiscard]] std::size_t tile_count() const { return regular ? 2 * gluing.size() / regular->p : tiles.size(); }
  [[nodiscard]] std::size_t sides_of(std::size_t tile) const { return regular ? regular->p : tiles[tile].size(); }
};

struct DistanceDocument {
  Net net;
  Index tile;
  RationalPoint point;
  std::array<mpq_class, 2> distance;
  std::vector<std::vector<Index>> paths;
  bool equal;
};

struct BoundDocument {
  enum class Claim { diameter, radius, embedded_disk };
  struct Triangulation {
    Index parent;
    std::vector<Index> flips;
  };

  Net net;
  Claim claim;
  std::array<mpq_class, 2> value;
  std::vector<Triangulation> triangulations;
  std::vector<std::vector<Index>> cells;
};

struct ClosedGeodesic {
  Index vertex;
  std::vector<Index> word;
  std::array<mpq_class, 2> length;
  bool simple;
};

struct Cluster {
  Index first;
  Index count;
  bool equal;
};

/// A systole, or a spectrum, which has a bound.
struct GeodesicsDocument {
  Net net;
  std::optional<mpq_class> up_to;
  std::vector<ClosedGeodesic> geodesics;
  std::vector<Cluster> clusters;
};

// Members, kinds and ranges of numbers. Each throws Malformed. Indices may name what is not there.

[[nodiscard]] Net read_net(const Json& root);
[[nodiscard]] DistanceDocument read_distance(const Json& root);
[[nodiscard]] BoundDocument read_bound(const Json& root);
[[nodiscard]] GeodesicsDocument read_geodesics(const Json& root);

/// The member of an object, if it has one of this name.
[[nodiscard]] const Json* find(const Json& object, const char* name);
/// The same, which must be there. Throws Malformed.
[[nodiscard]] const Json& member(const Json& object, const char* name);
[[nodiscard]] bool is_text(const Json& value, std::string_view text);
/// Throws Malformed, of `what`, if the value is not this text.
void expect_text(const Json& value, std::string_view text, const char* what);

}  // namespace epsnet::exact
