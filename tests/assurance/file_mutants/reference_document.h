#pragma once

#include <array>
#include <cstdint>
#include <gmpxx.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The files of docs/format.md as the reference checker reads them: with a library other than that of certify, into its
/// own documents, with checks in a different order.
namespace epsnet::attack {

using Index = std::uint32_t;

/// A text is not a file of the format.
struct Malformed {
  std::string why;
};

struct RationalPoint {
  mpq_class x;
  mpq_class y;
  bool operator==(const RationalPoint&) const = default;
};

struct NetFile {
  struct Chart {
    Index tile;
    RationalPoint centre;
  };
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
    std::array<Index, 3> label;
  };
  struct Collar {
    std::vector<Index> core;
    std::array<mpq_class, 2> length;
    std::array<Index, 2> vertices;
    std::array<Index, 2> triangles;
  };
  Index genus = 0;  ///< Of a regular surface.
  std::vector<std::vector<RationalPoint>> tiles;
  mpq_class epsilon;
  std::vector<Chart> charts;
  std::vector<Label> labels;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::optional<std::vector<Collar>> collars;
  // For every side, by its number: its tile, the next side of the tile, and the side that it is glued to.
  std::vector<Index> tile;
  std::vector<Index> next;
  std::vector<Index> partner;
};

struct GeodesicsFile {
  struct Geodesic {
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
  struct Piece {
    Index genus;
    std::vector<std::pair<Index, Index>> boundaries;
  };
  std::string claim;
  NetFile net;
  mpq_class up_to;
  std::vector<Geodesic> geodesics;
  std::vector<Cluster> clusters;
  std::vector<Piece> pieces;
};

/// Reads a net file or a geodesics file with a sound structure. Throws Malformed.
struct File {
  NetFile net;
  std::optional<GeodesicsFile> geodesics;
};
[[nodiscard]] File read_file(std::string_view text);

}  // namespace epsnet::attack
