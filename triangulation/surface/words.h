#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// A chart: the Poincaré disk of a tile with the origin moved to `centre`; the point z of the chart has the coordinate
/// (z + centre)/(1 + conj(centre) z) in the tile.
struct Chart {
  TileId tile;
  Complex<Rational> centre;
};

/// No point of a chart that is used as a vertex is farther from the origin than this (Euclidean, Poincaré disk).
inline constexpr double kChartRadius = 0.7;

/// The charts of a surface, numbered from 0.
class Charts {
 public:
  /// A disk (its interior) that meets none of its images under the group: an isometry of the group other than 1 moves
  /// its centre by twice its radius or more.
  struct Disk {
    Complex<double> centre;
    double sinh_radius;  ///< 0 where binary64 does not see such a disk.
  };

  /// No charts yet.
  explicit Charts(const Surface& surface);

  /// The surface whose charts these are.
  [[nodiscard]] const Surface& surface() const { return surface_; }

  /// Appends a chart without checking for duplicates; returns its number. Requires: its centre is in the open disk.
  ChartId add(Chart chart);
  /// Returns the number of charts.
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(entries_.size()); }
  [[nodiscard]] const Chart& operator[](ChartId c) const { return entry(c).chart; }

  /// The isometry from the coordinates of chart c to those of its tile, in T (Mp256, Mp1024, Mp4096).
  template <class T>
  [[nodiscard]] Isometry<T> frame(ChartId c) const;
  /// `frame` scaled to determinant 1.
  template <class T>
  [[nodiscard]] Isometry<T> unit_frame(ChartId c) const;
  /// A disk of the chart's tile, in the coordinates of the chart.
  [[nodiscard]] const Disk& disk(ChartId c) const { return entry(c).disk; }

  /// The chart of a tile whose origin is nearest to the point z of the tile, if that is near.
  [[nodiscard]] std::optional<ChartId> nearest(TileId tile, const Complex<Mp1024>& z) const;
  /// A side of a tile on whose right z lies, other than `entered`, the one through which a walk came; nullopt if z is
  /// in the tile.
  [[nodiscard]] std::optional<SideId> side_before(TileId tile, const Complex<Mp1024>& z,
                                                  std::optional<SideId> entered) const;

 private:
  struct Entry {
    Chart chart;
    Complex<double> centre;  ///< chart.centre, rounded.
    Disk disk;
    Isometry<Mp256> unit_frame;
  };
  [[nodiscard]] const Entry& entry(ChartId c) const {
    assert(c.number() < count());
    return entries_[c];
  }
  /// A disk inside of a tile, from its corners, in its coordinates.
  [[nodiscard]] static Disk disk_inside(std::span<const Complex<double>> tile);

  Surface surface_;
  ById<SideId, Complex<double>> corners_;  ///< Of all tiles, rounded.
  ById<TileId, Disk> disks_;
  ById<ChartId, Entry> entries_;
  std::unordered_map<TileId, std::vector<ChartId>> of_tile_;
};

/// A path that turns around a vertex crosses one side after the other of those that end there.
enum class Turn { counterclockwise, clockwise };

/// The crossing that continues a turn after side s: next to the partner of s in its tile.
[[nodiscard]] inline SideId next_crossing(const Surface& surface, SideId s, Turn turn) {
  const SideId partner = surface.partner(s);
  return turn == Turn::counterclockwise ? surface.next_side(partner) : surface.previous_side(partner);
}

// How large isometries and their entries are, for bounds of errors (docs/error-bounds.md, E5).

/// The integer e with 2^e ≤ |x| < 2^(e+1); a very small one for 0.
template <class T>
[[nodiscard]] double binary_exponent(const T& x) {
  return x == 0 ? -1e18 : static_cast<double>(mpfr_get_exp(x.backend().data()) - 1);
}

/// An upper bound of log2 of the operator norm |a| + |b| ≤ 2|a| of a normalised isometry, at most 2.5 too large. No
/// arithmetic, exponents only.
template <class T>
[[nodiscard]] double log2_norm(const Isometry<T>& f) {
  return 2.5 + std::max(binary_exponent(f.a.x), binary_exponent(f.a.y));
}

/// ν(f) = |a| + |b|.
[[nodiscard]] inline double size_of(const Isometry<double>& f) { return std::sqrt(norm(f.a)) + std::sqrt(norm(f.b)); }

/// An isometry that is within 2^−accuracy, relative to its entries.
template <class T>
struct Evaluated {
  Isometry<T> isometry;
  double accuracy;
};

/// Multiplies up the crossings of words, with a bound of the bits that this loses (docs/error-bounds.md, E5). Keeps
/// what was computed once: not for several threads.
class WordEvaluator {
 public:
  /// Rounds the crossings. O(sides).
  explicit WordEvaluator(const Surface& surface);

  /// The isometry of a word from the coordinates of chart `from` to those of chart `to`, to within 2^−accuracy relative
  /// to its entries, accuracy ≥ bits, computed in a field that is large enough; nullopt if no field is. T is Mp256,
  /// Mp1024 or Mp4096.
  template <class T>
  [[nodiscard]] std::optional<Evaluated<T>> value(double bits, const Charts& charts, ChartId from, ChartId to,
                                                  const Word& word) const;
  /// The crossing of side s, of determinant 1.
  template <class T>
  [[nodiscard]] const Isometry<T>& crossing(SideId s) const;
  /// The number of isometries multiplied so far.
  [[nodiscard]] std::uint64_t factor_count() const { return factor_count_; }

 private:
  /// The value of a word, computed in a field, and how many of the field's bits it lost.
  template <class T>
  struct Product {
    Isometry<T> isometry;
    double bits_lost;
  };
  template <class T>
  [[nodiscard]] Product<T> product(const Charts& charts, ChartId from, ChartId to, const Word& word) const;
  /// The crossings around a vertex, multiplied up: products[i] is the product of the first i of them.
  template <class T>
  struct FullTurn {
    std::vector<Isometry<T>> products;
    double bits_lost;  ///< A quotient of two of them is within 2^(bits_lost − bits of T).
  };
  /// That around the vertex of a corner.
  template <class T>
  [[nodiscard]] const FullTurn<T>& full_turn(SideId corner) const;
  /// Appends the crossings of a word to a list of factors; where the word turns around a vertex with many of them, one
  /// factor for all. Returns by how many bits the worst factor misses the accuracy of a rounded one.
  template <class T>
  [[nodiscard]] double append_factors(const Word& word, std::vector<Isometry<T>>& factors) const;

  /// What was asked for in one field above Mp256.
  template <class T>
  struct Known {
    std::unordered_map<SideId, Isometry<T>> crossings;
    std::unordered_map<std::uint32_t, FullTurn<T>> full_turns;  ///< By vertex class.
  };

  Surface surface_;
  ById<SideId, Isometry<Mp256>> crossings_;
  /// By side: which one it is of those that are crossed one after the other around its vertex. Empty if there is no
  /// vertex with so many that paths turn far around it.
  ById<SideId, std::uint32_t> rank_in_turn_;
  mutable std::uint64_t factor_count_ = 0;
  mutable std::tuple<Known<Mp1024>, Known<Mp4096>> known_;
};

}  // namespace epsnet
