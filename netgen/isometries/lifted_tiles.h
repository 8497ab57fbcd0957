#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/plane.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// An isometry of the plane that may reverse orientation, as a linear map of Minkowski space: the images of the three
/// unit vectors.
template <class T>
struct Motion {
  LorentzVector<T> x{T(1), T(0), T(0)};
  LorentzVector<T> y{T(0), T(1), T(0)};
  LorentzVector<T> t{T(0), T(0), T(1)};

  [[nodiscard]] LorentzVector<T> operator()(const LorentzVector<T>& v) const { return v.x * x + v.y * y + v.t * t; }
};

/// Requires: f has determinant 1.
template <class T>
[[nodiscard]] Motion<T> motion(const Isometry<T>& f) {
  const Motion<T> units;
  return {image(f, units.x), image(f, units.y), image(f, units.t)};
}

/// f ∘ g.
template <class T>
[[nodiscard]] Motion<T> operator*(const Motion<T>& f, const Motion<T>& g) {
  return {f(g.x), f(g.y), f(g.t)};
}

template <class T>
[[nodiscard]] Motion<T> inverse(const Motion<T>& f) {
  return {{f.x.x, f.y.x, T(-f.t.x)}, {f.x.y, f.y.y, T(-f.t.y)}, {T(-f.x.t), T(-f.y.t), f.t.t}};
}

template <class T>
[[nodiscard]] bool preserves_orientation(const Motion<T>& f) {
  return lorentz_product(lorentz_cross(f.x, f.y), f.t) > 0;
}

/// f ∘ g ∘ f⁻¹. Requires: g has determinant 1.
template <class T>
[[nodiscard]] Isometry<T> conjugated(const Motion<T>& f, const Isometry<T>& g) {
  const LorentzVector<T> n = f(axis_normal(g));
  const T sign(preserves_orientation(f) ? 1 : -1);
  return {{g.a.x, T(sign * n.t)}, {T(sign * n.y), T(-sign * n.x)}};
}

/// The isometry f with f ∘ x ∘ f⁻¹ = x' and f ∘ y ∘ f⁻¹ = y'. Requires: hyperbolic elements of determinant 1 with Re a
/// > 0, of which x and y have no end of their axes in common; x and x' have the same trace, y and y', xy and x'y'.
template <class T>
[[nodiscard]] Motion<T> motion_of_pairs(const Isometry<T>& x, const Isometry<T>& y, const Isometry<T>& x2,
                                        const Isometry<T>& y2) {
  // The traceless parts n of elements move like vectors, up to the sign of the orientation. The three vectors u, v and
  // w = u × v are a basis; its dual one is (v × w, w × u, w)/⟨w, w⟩.
  const LorentzVector<T> u = axis_normal(x);
  const LorentzVector<T> v = axis_normal(y);
  const LorentzVector<T> w = lorentz_cross(u, v);
  const LorentzVector<T> dual_u = lorentz_cross(v, w);
  const LorentzVector<T> dual_v = lorentz_cross(w, u);
  const LorentzVector<T> u2 = axis_normal(x2);
  const LorentzVector<T> v2 = axis_normal(y2);
  const LorentzVector<T> w2 = lorentz_cross(u2, v2);
  const T scale = T(1) / lorentz_product(w, w);
  const auto moved = [&](const LorentzVector<T>& p) {
    return scale * (lorentz_product(dual_u, p) * u2 + lorentz_product(dual_v, p) * v2 + lorentz_product(w, p) * w2);
  };
  const Motion<T> units;
  const Motion<T> result{moved(units.x), moved(units.y), moved(units.t)};
  const T minus(-1);
  return result.t.t > 0 ? result : Motion<T>{minus * result.x, minus * result.y, minus * result.t};
}

/// The tiles of a surface as they tile the plane, evaluated once: words as isometries, and walks to a point. Numbers
/// have 512 bits where nothing else is said. Read-only, so threads may share it.
class LiftedTiles {
 public:
  using Number = Multiprecision<512>;
  using Vector = LorentzVector<Number>;

  /// O(sides).
  explicit LiftedTiles(const Surface& surface);

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// The value of a word (group.h), of determinant 1.
  [[nodiscard]] Isometry<Number> value(const Word& word) const;
  /// The tile where a path from a tile ends.
  [[nodiscard]] TileId end_of(TileId start, const Word& way) const {
    return way.empty() ? start : surface_.tile_of_side(surface_.partner(way.back()));
  }
  /// A point inside of a tile.
  [[nodiscard]] const Vector& centre(TileId tile) const { return centres_[tile]; }

  /// The unit normal of a side, in the coordinates of its tile: positive inside.
  [[nodiscard]] const Vector& line(SideId side) const { return sides_[side].line; }
  /// From the coordinates of the tile of a side to those of the tile across.
  [[nodiscard]] const Isometry<Number>& crossing(SideId side) const { return sides_[side].crossing; }

  /// Returns a path from a tile to the one that contains a point, which is given in the coordinates of the first tile.
  /// Throws LimitError if it is too long.
  [[nodiscard]] Word walk(TileId tile, Vector point) const;

 private:
  struct Side {
    Vector line;  ///< Its unit normal, positive inside of the tile.
    LorentzVector<double> rounded_line;
    Isometry<Number> crossing;
  };

  Surface surface_;
  ById<SideId, Side> sides_;
  ById<TileId, Vector> centres_;
};

/// The same vector, rounded.
[[nodiscard]] inline LorentzVector<double> rounded(const LiftedTiles::Vector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.t)};
}

/// Finds the elements of the group of a surface that move a point not far. Read-only, so threads may share it.
///
/// They are found in the plane tiled by cells: by the tiles, or by a Dirichlet domain if tiles are much longer than
/// that. After some Dehn twists millions of tiles meet a small disk.
class ElementSearch {
 public:
  using Number = LiftedTiles::Number;
  using Vector = LiftedTiles::Vector;

  /// No closed geodesic is shorter than `shortest`, or none goes through the middle of a cell that is. O(sides), and a
  /// Dirichlet domain if there are long tiles.
  ElementSearch(const Surface& surface, double shortest);

  [[nodiscard]] const LiftedTiles& tiles() const { return tiles_; }

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

    /// A lift of a tile within the distance R of the point.
    struct TileLift {
      Isometry<double> frame;  ///< From the coordinates of the tile; determinant 1.
      std::uint32_t lift;      ///< For `way`.
    };
    /// By tile: its lifts near the point. Nothing if cells are not tiles.
    [[nodiscard]] std::optional<ById<TileId, std::vector<TileLift>>> tile_lifts() const;
    /// The path to a lift, from the tile that the point was given in.
    [[nodiscard]] Word way(std::uint32_t lift) const;

   private:
    friend class ElementSearch;
    struct Lift {
      Isometry<DoubleDouble> frame;  ///< From the coordinates of the cell.
      std::uint32_t cell;
      std::uint32_t before;  ///< The lift from which it was reached,
      std::uint32_t side;    ///< and the side crossed.
    };
    const ElementSearch* search_ = nullptr;
    Word start_;  ///< From the tile that the point was given in to the cell that contains it.
    std::vector<Lift> lifts_;
    std::vector<Element> list_;
  };
  /// Returns all elements that move a point, given in the coordinates of a tile, by at most `radius`, and perhaps some
  /// that move it a little more. Refers to this object. Frames have some 100 bits. Throws LimitError if more than
  /// `most` lifts of cells have to be visited. About 2π cosh(radius)/(area of a cell) steps.
  [[nodiscard]] Elements elements(TileId tile, const Vector& point, double radius, std::uint64_t most) const;

 private:
  struct Cell {
    LorentzVector<double> centre;
    std::uint32_t first_side;
    std::uint32_t end_side;
  };
  struct CellSide {
    LorentzVector<double> line;  ///< Its unit normal, positive inside.
    LorentzVector<double> start;
    double cosh_length = 1;
    std::uint32_t across = 0;     ///< The cell there.
    Isometry<DoubleDouble> back;  ///< From the coordinates of that cell.
    Word way;                     ///< From tile to tile, to that cell.
  };

  void add_cell(const Vector& centre, const std::vector<Vector>& corners);
  void add_tiles();
  /// The Dirichlet domain of the first vertex, if it is much smaller than some tile.
  void find_domain();
  /// A path to the domain that contains a point, which is given in the coordinates of a tile.
  [[nodiscard]] Word way_to_domain(TileId tile, const Complex<Mp1024>& point) const;

  LiftedTiles tiles_;
  double shortest_;
  std::optional<DomainFrame> domain_;  ///< If cells are not tiles.
  std::vector<Cell> cells_;
  std::vector<CellSide> cell_sides_;
};

}  // namespace epsnet
