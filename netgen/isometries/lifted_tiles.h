#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/isometry.h"
#include "kernel/lorentz.h"
#include "netgen/isometries/motion.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// The tiles of a surface as they tile the plane, evaluated once: walks to a point, and the elements of the group that
/// move a point not far. Numbers have 256 bits where nothing else is said. Read-only, so threads may
/// share it.
class LiftedTiles {
 public:
  using Number = Mp256;
  using Vector = LorentzVector<Number>;

  /// No closed geodesic is shorter than `shortest`, or none goes through the middle of a tile that is. O(sides).
  LiftedTiles(const Surface& surface, double shortest);

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// The value of a word (group.h), of determinant 1.
  [[nodiscard]] Isometry<Number> value(const Word& word) const;
  /// A point inside of a tile.
  [[nodiscard]] const Vector& centre(TileId tile) const { return centres_[tile]; }

  /// Returns a path from a tile to the one that contains a point, which is given in the coordinates of the first tile.
  /// Throws LimitError if it is too long.
  [[nodiscard]] Word walk(TileId tile, Vector point) const;

  /// An element of the group that moves a point by a distance of at most R.
  struct Element {
    Isometry<double> isometry;  ///< In coordinates that a translation has moved to the point. Determinant 1.
    std::uint32_t lift;         ///< For `word`.
  };
  /// The elements that move one point not far.
  class Elements {
   public:
    [[nodiscard]] const std::vector<Element>& list() const { return list_; }
    /// The word of an element, from the tile that the point was given in to itself.
    [[nodiscard]] Word word(const Element& element) const;

   private:
    friend class LiftedTiles;
    struct Lift {
      Isometry<DoubleDouble> frame;  ///< From the coordinates of the tile.
      TileId tile;
      std::uint32_t before;  ///< The lift from which it was reached,
      SideId side;           ///< and the side crossed.
    };
    const Surface* surface_ = nullptr;
    Word start_;  ///< To the tile that contains the point.
    std::vector<Lift> lifts_;
    std::vector<Element> list_;
  };
  /// Returns all elements that move a point, given in the coordinates of a tile, by at most `radius`, and perhaps some
  /// that move it a little more. Frames have some 100
  /// bits. Throws LimitError if more than `most` lifts of
  /// tiles have to be visited. About 2π cosh(radius)/(area of a tile) steps.
  [[nodiscard]] Elements elements(TileId tile, const Vector& point, double radius, std::uint64_t most) const;

 private:
  struct Side {
    Vector line;  ///< Its unit normal, positive inside of the tile.
    LorentzVector<double> rounded_line;
    Isometry<Number> crossing;
    Isometry<DoubleDouble> back;  ///< From the coordinates of the tile across.
    LorentzVector<double> start;
    double cosh_length;
  };

  Surface surface_;
  double shortest_;
  ById<SideId, Side> sides_;
  ById<TileId, Vector> centres_;
};

}  // namespace epsnet
