#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/id.h"
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

}  // namespace epsnet
