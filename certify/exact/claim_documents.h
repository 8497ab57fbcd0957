#pragma once

#include <array>
#include <compare>
#include <gmpxx.h>
#include <vector>

#include "certify/exact/document.h"

/// The documents of claims (docs/format.md).
namespace epsnet::exact {

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
  std::vector<Index> base;
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

/// Of the surface cut along geodesics.
struct Piece {
  Index genus;
  std::vector<std::array<Index, 2>> boundaries;  ///< A geodesic, and 0 for its left side, 1 for its right one.

  friend auto operator<=>(const Piece&, const Piece&) = default;
};

struct GeodesicsDocument {
  enum class Claim { systole, spectrum, thick_thin };

  Claim claim;
  Net net;
  mpq_class up_to;  ///< Of a spectrum.
  std::vector<ClosedGeodesic> geodesics;
  std::vector<Cluster> clusters;  ///< Unless it is a systole.
  std::vector<Piece> pieces;      ///< Of a thick-thin decomposition.
};

using Range = std::array<mpq_class, 2>;
using Coefficients = std::vector<mpq_class>;

struct EigenvaluesDocument {
  struct Enclosure {
    Range in;
    Index count;
  };
  struct AtMost {
    mpq_class below;
    Index count;
    mpq_class sigma;
  };
  struct AtLeast {
    mpq_class below;
    Index count;
  };
  struct Eigenfunctions {
    Range in;
    mpq_class lambda;
    mpq_class radius;
    std::vector<Coefficients> functions;
  };

  Net net;
  std::vector<Enclosure> eigenvalues;
  mpq_class next;
  Index halvings;
  std::vector<Index> side_order;
  std::vector<Index> vertex_order;
  std::vector<AtMost> at_most;
  std::vector<AtLeast> at_least;
  std::vector<Eigenfunctions> eigenfunctions;
};

struct IsometriesDocument {
  using Word = std::vector<Index>;
  struct Row {
    bool preserves_orientation;
    std::vector<Word> images;
  };

  GeodesicsDocument spectrum;
  Index order;
  std::vector<Row> isometries;
  std::vector<Word> paths;
  std::vector<Word> pair;
  std::vector<Index> cocycle;
};

/// A pants decomposition.
struct PantsDocument {
  using Word = std::vector<Index>;
  using End = std::array<Index, 2>;  ///< A pair of pants, and which of its cuffs.
  struct Cuff {
    std::array<End, 2> ends;
    Word across;
    Range length;
    Range twist;
    mpq_class exp_half_length;  ///< Or 0.
  };

  Net net;
  std::vector<std::array<Word, 2>> pants;
  std::vector<Cuff> cuffs;
};

// Members, kinds and ranges of numbers. Each throws Malformed. Indices may name what is not there.

[[nodiscard]] DistanceDocument read_distance(const Json& root);
[[nodiscard]] BoundDocument read_bound(const Json& root);
[[nodiscard]] GeodesicsDocument read_geodesics(const Json& root);
[[nodiscard]] EigenvaluesDocument read_eigenvalues(const Json& root);
[[nodiscard]] IsometriesDocument read_isometries(const Json& root);
[[nodiscard]] PantsDocument read_pants(const Json& root);

}  // namespace epsnet::exact
