#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/base/interval.h"
#include "kernel/plane.h"
#include "netgen/isometries/lifted_tiles.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// A closed curve with a direction: a path from a tile to itself, which is not null-homotopic. Its element is the
/// isometry from the lift of the tile at the end of the path to the one at its start; it translates along the path.
struct ClosedPath {
  TileId tile;
  Word word;
};

/// Disjoint simple closed geodesics of a surface, and what is near them, computed with 512 bits.
///
/// Nothing here is proved. Whoever uses the results asks certify::check.
class CurveSystem {
 public:
  using Number = LiftedTiles::Number;
  using Vector = LiftedTiles::Vector;

  explicit CurveSystem(const Surface& surface);

  /// A curve with one of its directions; its pair of pants, if that is what is meant, lies on the left.
  struct Side {
    std::uint32_t curve;
    bool reversed;
    bool operator==(const Side&) const = default;
  };
  /// A lift of a curve of the system, as seen from a closed path: the one that the element of `way` · curve · `way`⁻¹
  /// translates along, for a path from the tile of the closed path to that of the curve.
  struct Lift {
    Side side;
    Word way;
  };

  /// How many curves there are.
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(curves_.size()); }
  /// A curve, by a path from a tile through which its geodesic passes.
  [[nodiscard]] const ClosedPath& curve(std::uint32_t number) const { return curves_[number].path; }
  [[nodiscard]] const Number& length(std::uint32_t number) const { return curves_[number].length; }
  /// With one of its directions.
  [[nodiscard]] ClosedPath directed(Side side) const;
  /// The same closed geodesic by a path that starts at a tile through which it passes, and a path to that tile. Throws
  /// LimitError.
  struct Moved {
    ClosedPath path;
    Word way;
  };
  [[nodiscard]] Moved onto_geodesic(const ClosedPath& path) const;

  /// Whether the element of a path is 1, rather than a translation.
  [[nodiscard]] bool is_trivial(const ClosedPath& path) const;
  /// Adds a curve; returns its number. Requires: it is not trivial, and none of the system.
  std::uint32_t add(const ClosedPath& path);
  /// The number of a curve of the system that a closed geodesic crosses, perhaps itself.
  [[nodiscard]] std::optional<std::uint32_t> crossed(const ClosedPath& path) const;
  /// How many times a curve goes around its geodesic: 1 unless it is a power of another one.
  [[nodiscard]] std::uint32_t exponent(std::uint32_t number) const;
  /// The curve of the system that is the closed geodesic of a path, with its direction.
  [[nodiscard]] std::optional<Lift> lift_on(const ClosedPath& path) const;

  /// Where a curve passes through a tile, or touches it.
  struct Chord {
    TileId tile;
    Vector normal;  ///< Of the curve, positive on its left, in the coordinates of the tile.
    Word word;      ///< A path from the tile to itself: the curve once around, from there.
  };
  /// All of a curve, each once. Throws LimitError.
  [[nodiscard]] std::vector<Chord> chords(std::uint32_t number) const;

  /// The pair of pants on the left of a side: the elements of its cuffs, all as paths from one tile, the first one that
  /// of directed(side). The pants are on the left of all three, and the product of the three is 1. It contains the
  /// shortest arc that leaves the curve on this side and ends at a curve of the system. Throws LimitError.
  [[nodiscard]] std::array<ClosedPath, 3> pants_beside(Side side) const;

 private:
  /// A place on a curve.
  struct Sample {
    std::uint32_t curve;
    TileId tile;
    Word way;  ///< From the tile of the curve.
    Vector point;
    Vector normal;  ///< Of the curve; of length 1.
  };
  struct Curve {
    ClosedPath path;
    Number length;
  };
  /// A closed geodesic that the surroundings are explored of.
  struct Axis {
    ClosedPath path;
    Isometry<Number> element;
    Number length;
    Vector normal;   ///< Positive on the left; of length 1.
    Vector point;    ///< On the axis,
    Vector forward;  ///< and the direction there.
  };
  /// A lift of a sample that was met.
  struct Meeting {
    std::uint32_t sample;
    std::uint32_t lift;
    Vector point;
    Vector normal;
    Number product;  ///< Of the two normals.
    Number height;   ///< sinh of the distance of the point from the axis, positive on the left.
  };
  class Exploration;

  [[nodiscard]] Isometry<Number> element(const Word& word) const { return inverse(tiles_.value(word)); }
  [[nodiscard]] Axis axis_of(const ClosedPath& path) const;
  [[nodiscard]] bool is_same_axis(const Meeting& meeting) const;

  Surface surface_;
  LiftedTiles tiles_;
  ById<TileId, std::vector<Vector>> corners_;
  ById<SideId, Isometry<Number>> back_;  ///< The inverse of a side's crossing.
  std::vector<Curve> curves_;
  std::vector<Sample> samples_;
  ById<TileId, std::vector<std::uint32_t>> samples_in_;
};

// Fenchel–Nielsen coordinates, in balls.

/// A pair of pants, by the elements of its cuffs 0 and 1: paths from a tile to itself. That of cuff 2 is the inverse of
/// the path of cuff 0 and then that of cuff 1.
struct PantsPaths {
  std::array<Word, 2> cuffs;
};

/// The length of a cuff and the twist there, in intervals.
struct CuffCoordinates {
  certify::Interval length{};
  certify::Interval twist{};  ///< Reduced: between −½ and ½ of the length, but for the width of the interval.
  /// e^{length/2}, if that is rational.
  std::optional<Rational> root;
};

/// Returns by edge the Fenchel–Nielsen coordinates of a surface that is glued of these pairs of pants, by paths across
/// the edges, each from the tile of the pants of its first end to that of its second end. That the surface is glued of
/// them is taken for granted: certify::check decides it (docs/proof.md, section 19). Throws LimitError if the
/// coordinates are not known with many bits, as for paths that are no cuffs. Twists that are not reduced are real
/// numbers, which the paths across the edges determine.
///
/// Time: that of some products of all letters of each path.
[[nodiscard]] std::vector<CuffCoordinates> cuff_coordinates(const Surface& surface, const PantsGraph& graph,
                                                            const std::vector<PantsPaths>& pants,
                                                            const std::vector<Word>& across, bool reduced = true);

}  // namespace epsnet
