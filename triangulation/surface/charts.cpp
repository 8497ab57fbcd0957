#include "triangulation/surface/charts.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "kernel/lorentz.h"
#include "kernel/plane.h"
#include "kernel/predicates.h"

namespace epsnet {
namespace {

/// The points p, q of the disk, rounded to nearest, have certainly |z|² > square, z being q with p moved to the origin.
bool certainly_farther(const Complex<double>& p, const Complex<double>& q, double square) {
  // |z|²/(1 − |z|²) = |p − q|²/((1 − |p|²)(1 − |q|²)). Each rounded point is within u of the true one, so the
  // distance is off by less than 2u, and by 4u with its own rounding, and a factor of the denominator by less than 5u.
  constexpr double kError = 8 * kUnitRoundoff;
  const double distance = std::sqrt(norm(p - q)) - kError;
  const double heights = (1 - norm(p) + kError) * (1 - norm(q) + kError);
  constexpr double kMargin = 1.001;  // For the roundings that are relative.
  return distance > 0 && distance * distance * (1 - square) > kMargin * square * heights;
}

}  // namespace

Charts::Charts(const Surface& surface) : surface_(surface) {
  disks_.reserve(surface.tiles().size());
  for (const Tile& tile : surface.tiles()) {
    const std::size_t first = corners_.size();
    for (const Complex<Rational>& corner : tile) {
      corners_.push_back(convert<double>(corner));
    }
    disks_.push_back(disk_inside(std::span(corners_).subspan(first)));
  }
}

Charts::Disk Charts::disk_inside(std::span<const Complex<double>> tile) {
  std::vector<LorentzVector<double>> corners;  // In the Klein model, t = 1.
  LorentzVector<double> sum;
  for (const Complex<double>& z : tile) {
    const double scale = 2 / (1 + norm(z));
    corners.push_back({scale * z.x, scale * z.y, 1});
    sum = sum + corners.back();
  }
  const double square = -lorentz_product(sum, sum);
  const double height = sum.t * sum.t;
  // Far from the origin, and for sides whose ends are near each other and the unit circle, binary64 has lost too much.
  if (!(square > 1e-4 * height)) {
    return {{}, 0};
  }
  const LorentzVector<double> centre = 1 / std::sqrt(square) * sum;
  double sinh_radius = 1;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const LorentzVector<double> normal = lorentz_cross(corners[k], corners[k + 1 < corners.size() ? k + 1 : 0]);
    const double normal_square = lorentz_product(normal, normal);
    if (!(normal_square > std::max(1e-12, 1e-8 * normal.t * normal.t))) {
      return {{}, 0};
    }
    sinh_radius = std::min(sinh_radius, lorentz_product(normal, centre) / std::sqrt(normal_square));
  }
  // Half of it makes up for all rounding, which is below a thousandth of it: products and normals are off by a few
  // 1e-16 times sizes below 100, squares by 1e-5 of themselves.
  return {in_disk(centre), sinh_radius > 1e-4 ? sinh_radius / 2 : 0};
}

ChartId Charts::add(Chart chart) {
  assert(chart.tile.number() < surface_.tiles().size() && norm(chart.centre) < 1);
  const ChartId c = entries_.end_id();
  of_tile_[chart.tile].push_back(c);
  Disk disk = disks_[chart.tile];
  const Complex<double> centre = convert<double>(chart.centre);
  disk.centre = epsnet::inverse(Isometry<double>::translation(centre))(disk.centre);
  constexpr double kFarthest = 0.999;
  if (!(norm(disk.centre) < kFarthest)) {
    disk.sinh_radius = 0;
  }
  entries_.push_back({std::move(chart), centre, disk, {}});
  entries_.back().unit_frame = normalized(frame<Mp256>(c));
  return c;
}

template <class T>
Isometry<T> Charts::frame(ChartId c) const {
  return Isometry<T>::translation(convert<T>(entry(c).chart.centre));
}

template <class T>
Isometry<T> Charts::unit_frame(ChartId c) const {
  if constexpr (std::is_same_v<T, Mp256>) {
    return entry(c).unit_frame;
  } else {
    return normalized(frame<T>(c));
  }
}

std::optional<ChartId> Charts::nearest(TileId tile, const Complex<Mp1024>& z) const {
  const auto charts = of_tile_.find(tile);
  if (charts == of_tile_.end()) {
    return std::nullopt;
  }
  std::optional<ChartId> nearest;
  double best = 0.6 * 0.6;
  // Most charts are seen in binary64 to be farther than that.
  const Complex<double> seen = convert<double>(z);
  for (const ChartId candidate : charts->second) {
    if (certainly_farther(entries_[candidate].centre, seen, best)) {
      continue;
    }
    const double distance2 = static_cast<double>(norm(epsnet::inverse(frame<Mp1024>(candidate))(z)));
    if (distance2 < best) {
      best = distance2;
      nearest = candidate;
    }
  }
  return nearest;
}

std::optional<SideId> Charts::side_before(TileId tile, const Complex<Mp1024>& z, std::optional<SideId> entered) const {
  const Tile& vertices = surface_.tile(tile);
  // Most sides are seen in binary64 to have the point on their left.
  const auto is_left_of = [&](SideId s) {
    const SideId next = surface_.next_side(s);
    constexpr double kRounding = 2 * kUnitRoundoff;
    const StageSign seen = orientation_stage<double>(corners_[s], corners_[next], convert<double>(z), kRounding);
    if (seen.certain) return seen.sign > 0;
    const auto corner = [&](SideId c) { return convert<Mp1024>(vertices[surface_.place_in_tile(c)]); };
    return orientation_determinant(corner(s), corner(next), z) >= 0;
  };
  for (const SideId s : surface_.sides_of(tile)) {
    if (entered != s && !is_left_of(s)) {
      return s;
    }
  }
  return std::nullopt;
}

template Isometry<Mp256> Charts::frame<Mp256>(ChartId) const;
template Isometry<Mp1024> Charts::frame<Mp1024>(ChartId) const;
template Isometry<Mp4096> Charts::frame<Mp4096>(ChartId) const;
template Isometry<Mp256> Charts::unit_frame<Mp256>(ChartId) const;
template Isometry<Mp1024> Charts::unit_frame<Mp1024>(ChartId) const;
template Isometry<Mp4096> Charts::unit_frame<Mp4096>(ChartId) const;

}  // namespace epsnet
