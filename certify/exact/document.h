#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <gmpxx.h>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/exact/document.h"
#include "certify/exact/json.h"
#include "certify/exact/number_field.h"
#include "certify/exact/plane.h"

/// The document of a net (docs/format.md).
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

/// Of a surface over a number field.
struct FieldTiles {
  Polynomial polynomial;
  std::array<mpq_class, 2> root;
  std::vector<std::vector<std::array<Polynomial, 3>>> tiles;
  std::vector<std::array<Polynomial, 4>> crossings;  ///< By row of the gluing.
};

struct Net {
  std::vector<std::vector<RationalPoint>> tiles;  ///< Of rational tiles; the other two kinds have what follows.
  std::optional<RegularTiles> regular;
  std::optional<FieldTiles> field;
  std::vector<std::array<Index, 4>> gluing;
  mpq_class epsilon;
  std::vector<std::pair<Index, RationalPoint>> charts;
  std::vector<Label> labels;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::optional<std::vector<Collar>> collars;

  [[nodiscard]] std::size_t tile_count() const {
    if (regular) return 2 * gluing.size() / regular->p;
    return field ? field->tiles.size() : tiles.size();
  }
  [[nodiscard]] std::size_t sides_of(std::size_t tile) const {
    if (regular) return regular->p;
    return field ? field->tiles[tile].size() : tiles[tile].size();
  }
};

/// Members, kinds and ranges of numbers. Throws Malformed. Indices may name what is not there.
[[nodiscard]] Net read_net(const Json& root);

/// The same of a surface file, of which nothing is kept.
void read_surface_file(const Json& root);

// For readers of other documents. Each throws Malformed, and names `what` is wrong.

/// Words of at most 10⁶ letters, 10⁷ in all.
class Words {
 public:
  std::vector<Index> read(const Json& value);

 private:
  std::size_t letters_ = 0;
};

[[nodiscard]] Net read_net(const Json& root, Words& words);
[[nodiscard]] RationalPoint read_rational_point(const Json& x, const Json& y);
[[nodiscard]] mpq_class read_binary64(const Json& value);
/// 0 <= lower <= upper.
[[nodiscard]] std::array<mpq_class, 2> read_length(const Json& value, const char* what);
[[nodiscard]] std::vector<Index> read_indices(const Json& value, const char* what);

void expect_members(const Json& value, std::initializer_list<std::string_view> names);
void expect_version(const Json& root);
[[nodiscard]] const std::vector<Json>& array(const Json& value, const char* what);
[[nodiscard]] const std::vector<Json>& tuple(const Json& value, std::size_t size, const char* what);
/// The member of an object, if it has one of this name.
[[nodiscard]] const Json* find(const Json& object, const char* name);
/// The same, which must be there. Throws Malformed.
[[nodiscard]] const Json& member(const Json& object, const char* name);
[[nodiscard]] bool is_text(const Json& value, std::string_view text);
/// Throws Malformed, of `what`, if the value is not this text.
void expect_text(const Json& value, std::string_view text, const char* what);

// The documents of claims (docs/format.md).

struct DistanceDocument {
  Net net;
  Index tile;
  RationalPoint point;
  std::array<mpq_class, 2> distance;
  std::vector<std::vector<Index>> paths;
  bool equal;
};

/// Isometries of a surface, by the images of a pair of elements and of the generators of its group.
struct IsometryRows {
  using Word = std::vector<Index>;
  struct Row {
    bool preserves_orientation;
    std::vector<Word> images;
  };

  std::vector<Row> isometries;
  std::vector<Word> paths;
  std::vector<Word> pair;
};

struct BoundDocument {
  enum class Claim { diameter, radius, embedded_disk };
  struct Symmetry {
    RationalPoint centre;
    IsometryRows rows;
  };
  struct Triangulation {
    Index parent;
    std::vector<Index> flips;
  };

  Net net;
  Claim claim;
  std::array<mpq_class, 2> value;
  std::vector<Triangulation> triangulations;
  std::vector<Index> base;
  std::optional<Symmetry> symmetry;
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
  enum class Claim { systole, spectrum, thick_thin, local_maximum };

  Claim claim;
  Net net;
  mpq_class up_to{};  ///< If has_up_to().
  std::vector<ClosedGeodesic> geodesics{};
  std::vector<Cluster> clusters{};  ///< Unless it is a systole.
  std::vector<Piece> pieces{};      ///< Of a thick-thin decomposition.
  std::vector<Index> basis{};       ///< Of a local maximum,
  std::vector<Index> weights{};     ///< and of those of the first cluster that are not in the basis.

  [[nodiscard]] bool has_up_to() const { return claim == Claim::spectrum || claim == Claim::local_maximum; }
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

  struct Direction {
    std::vector<mpz_class> steps;    ///< By side.
    std::vector<mpq_class> heights;  ///< By vertex.
  };
  struct Box {
    mpq_class radius;
    std::vector<Direction> directions;
  };

  Net net;
  std::vector<mpq_class> phases;  ///< By side, in turns; none: of functions.
  std::optional<Box> box;
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
  GeodesicsDocument spectrum;
  Index order;
  IsometryRows rows;
  std::vector<Index> cocycle;
};

/// Two surfaces.
struct ComparisonDocument {
  using Word = std::vector<Index>;
  enum class Claim { isometric, different };

  Claim claim;
  GeodesicsDocument first;  ///< If they are isometric, only the nets of both.
  GeodesicsDocument other;
  // Only if they are isometric.
  bool preserves_orientation = true;
  std::vector<Word> paths;
  std::vector<Word> pair;
  std::vector<Word> images;
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

/// Closed curves, what each two have in common, and sets of them.
struct CurvesDocument {
  struct Curve {
    Index vertex;
    std::vector<Index> word;
    Range length;
    Index power;
    mpz_class self_intersections;
    std::vector<mpz_class> homology;
  };
  struct Pair {
    Index first;
    Index second;
    mpz_class intersections;
    mpz_class algebraic;
  };

  Net net;
  std::vector<Curve> curves;
  std::vector<Pair> pairs;
  std::vector<Index> basis;
  std::vector<std::vector<Index>> filling;
};

// Members, kinds and ranges of numbers. Each throws Malformed. Indices may name what is not there.

[[nodiscard]] DistanceDocument read_distance(const Json& root);
[[nodiscard]] BoundDocument read_bound(const Json& root);
[[nodiscard]] GeodesicsDocument read_geodesics(const Json& root);
[[nodiscard]] EigenvaluesDocument read_eigenvalues(const Json& root);
[[nodiscard]] IsometriesDocument read_isometries(const Json& root);
[[nodiscard]] ComparisonDocument read_comparison(const Json& root);
[[nodiscard]] PantsDocument read_pants(const Json& root);
[[nodiscard]] CurvesDocument read_curves(const Json& root);

}  // namespace epsnet::exact
