#include "netgen/pictures/dirichlet.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <tuple>

#include "kernel/plane.h"
#include "netgen/base/gmp.h"

namespace epsnet {
namespace {

using Point = Complex<double>;

/// The convex polygon of the points that are nearer to 0 than to given points, in the Klein model.
///
/// Vertices have 256 bits, as binary64 runs out of Klein coordinates 18 from the centre; their roundings answer most
/// questions.
template <class T>
class VoronoiCell {
 public:
  using PrecisePoint = Complex<T>;

  VoronoiCell() {
    // A square around the disk, with sides that are no geodesics: "no bisector yet".
    for (const auto& [x, y] : {std::pair{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}) add_corner(corners_, {x, y}, {});
  }

  /// Cuts off what is nearer to the point p of the Poincaré disk than to 0. True if that was anything.
  bool cut(const PrecisePoint& p) {
    // k is nearer to 0 if and only if k·p ≤ |p|²: the scalar product of (k, 1) with the difference of the two points on
    // the hyperboloid.
    if (!may_cut(convert<double>(p))) return false;
    const T pp = norm(p);
    const std::size_t n = corners_.size();
    std::vector<T> excess(n);
    bool any = false;
    // A bisector that comes again must not cut slivers off by rounding; 2⁻¹²⁰ is far above the error of p and far below
    // what a picture shows.
    static const T kTolerance = ldexp(T(1), -120);
    const T tolerance = kTolerance * pp;
    for (std::size_t i = 0; i < n; ++i) {
      excess[i] = dot(p, corners_[i].k) - pp;
      any = any || excess[i] > tolerance;
    }
    if (!any) return false;
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const bool in = excess[i] <= tolerance;
      const bool next_in = excess[j] <= tolerance;
      if (in) kept.push_back(corners_[i]);
      if (in == next_in) continue;
      const T share = excess[i] / (excess[i] - excess[j]);
      const PrecisePoint k = corners_[i].k + share * (corners_[j].k - corners_[i].k);
      // Leaving the half plane the new side starts; coming back the old side goes on.
      add_corner(kept, k, in ? p : corners_[i].bisected);
    }
    corners_ = std::move(kept);
    return true;
  }

  /// The point of the segment from u to v (Klein) inside of the cell that is nearest to 0, as its distance from 0 in
  /// the Klein model; infinite if the segment misses the cell by more than rounding.
  [[nodiscard]] double nearest_on_segment(const Point& u, const Point& v) const {
    constexpr double kSlack = 1e-13;
    double from = 0;
    double to = 1;
    const Point direction = v - u;
    for (const Corner& corner : corners_) {
      // From the points bisected, not from the corners: these may be too close to each other for a direction.
      const Point& p = corner.rounded_bisected;
      const double reach = std::sqrt(norm(p));
      if (reach == 0) continue;
      const double at_start = reach - dot(p, u) / reach + kSlack;
      const double slope = -dot(p, direction) / reach;
      if (at_start < 0 && at_start + slope < 0) return std::numeric_limits<double>::infinity();
      if (at_start < 0) from = std::max(from, -at_start / slope);
      if (at_start + slope < 0) to = std::min(to, at_start / -slope);
    }
    if (from > to) return std::numeric_limits<double>::infinity();
    const double square = norm(direction);
    const double nearest = square > 0 ? std::clamp(-dot(u, direction) / square, from, to) : from;
    return std::sqrt(norm(u + nearest * direction));
  }

  /// By the sum of the interior angles; infinite while the cell is unbounded.
  [[nodiscard]] T area() const {
    const std::size_t n = corners_.size();
    T angles = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (norm(corners_[i].k) >= 1) return std::numeric_limits<T>::infinity();
      angles += angle(corners_[(i + n - 1) % n].bisected, corners_[i].bisected);
    }
    return T(n - 2) * boost::math::constants::pi<T>() - angles;
  }

  [[nodiscard]] std::vector<Point> vertices() const {
    std::vector<Point> result;
    for (const Corner& corner : corners_) result.push_back(convert<double>(from_klein(corner.k)));
    return result;
  }

 private:
  struct Corner {
    PrecisePoint k;
    Point rounded;
    PrecisePoint bisected;  ///< The side that starts here bisects 0 and this point (Poincaré); 0 for the square.
    Point rounded_bisected;
  };

  static void add_corner(std::vector<Corner>& corners, const PrecisePoint& k, const PrecisePoint& bisected) {
    corners.push_back({k, convert<double>(k), bisected, convert<double>(bisected)});
  }

  /// False only if the half plane of p contains the cell for sure.
  [[nodiscard]] bool may_cut(const Point& p) const {
    const double pp = norm(p);
    return std::any_of(corners_.begin(), corners_.end(),
                       [&](const Corner& corner) { return dot(p, corner.rounded) - pp > -1e-13; });
  }

  /// The angle between two sides. The normals (p, |p|²) of the sides have the square |p|² − |p|⁴ in Minkowski space.
  static T angle(const PrecisePoint& p, const PrecisePoint& q) {
    const T pp = norm(p);
    const T qq = norm(q);
    const T cosine = (pp * qq - dot(p, q)) / sqrt(T((pp - pp * pp) * (qq - qq * qq)));
    return acos(cosine > 1 ? T(1) : cosine < -1 ? T(-1) : cosine);
  }

  std::vector<Corner> corners_;
};

/// A copy of a tile: the isometry takes the coordinates of the tile to the screen. Determinant 1.
template <class T>
struct TileCopy {
  std::uint32_t tile;
  Isometry<T> isometry;
  std::vector<Complex<T>> corners;  ///< Klein model.
};

/// The search over copies of tiles, which cuts the cell.
template <class T>
class Search {
 public:
  using PrecisePoint = Complex<T>;
  using Copy = TileCopy<T>;

  Search(const NetGeometry& geometry, const Parts<T>& parts, std::uint32_t max_copies)
      : geometry_(geometry),
        parts_(parts),
        area_(4 * boost::math::constants::pi<T>() * (T(geometry.sides().genus) - 1)),
        max_copies_(max_copies),
        by_tile_(geometry.sides().first_side.size() - 1) {
    const certify::SurfaceDocument& surface = geometry.document().surface;
    const certify::SurfaceDocument regular =
        surface.regular_genus != 0 ? rounded_polygon(surface.regular_genus) : certify::SurfaceDocument();
    for (const certify::SurfaceDocument::Tile& tile : surface.regular_genus != 0 ? regular.tiles : surface.tiles) {
      std::vector<PrecisePoint>& corners = tiles_.emplace_back();
      for (const certify::RationalPoint& z : tile) corners.push_back(rounded<T>(z));
    }
  }

  [[nodiscard]] DirichletDomain run(std::uint32_t tile, const Isometry<T>& isometry) {
    visit(copy_at_origin(copy(tile, isometry)));
    while (!complete(kSameArea) && !entries_.empty()) {
      const Entry entry = entries_.top();
      entries_.pop();
      const Copy& from = copies_[entry.copy];
      const double distance = entry_distance(from, entry.side);
      if (std::isinf(distance)) continue;
      if (distance > entry.distance + 1e-12) {  // The cell has shrunk since.
        entries_.push({distance, entry.copy, entry.side});
        continue;
      }
      visit(neighbour(from, entry.side));
    }
    if (!complete(kFineForPictures))
      throw NetGeometryError("the Dirichlet domain is not closed by the surface's tiles: its area is " +
                             std::to_string(static_cast<double>(cell_area_)) + ", the surface's is " +
                             std::to_string(static_cast<double>(area_)));
    return {cell_.vertices(), static_cast<double>(cell_area_), static_cast<std::uint32_t>(copies_.size())};
  }

 private:
  /// A side of a visited copy, and how far from 0 the cell can be left or entered through it (Klein model).
  struct Entry {
    double distance;
    std::uint32_t copy;
    std::uint32_t side;  ///< Within the tile.
    bool operator>(const Entry& other) const {
      return std::tie(distance, copy, side) > std::tie(other.distance, other.copy, other.side);
    }
  };
  /// Below this no side is missing that a picture could show.
  static constexpr double kSameArea = 1e-15;
  static constexpr double kFineForPictures = 1e-6;
  using Key = std::tuple<std::uint32_t, T, T>;

  [[nodiscard]] bool complete(double tolerance) const { return abs(T(cell_area_ - area_)) < tolerance; }

  [[nodiscard]] Copy copy(std::uint32_t tile, const Isometry<T>& isometry) const {
    Copy result{tile, normalized(isometry), {}};
    for (const PrecisePoint& z : tiles_[tile]) result.corners.push_back(to_klein(result.isometry(z)));
    return result;
  }

  [[nodiscard]] Copy neighbour(const Copy& from, std::uint32_t side) const {
    const std::uint32_t partner = geometry_.sides().partner[geometry_.sides().first_side[from.tile] + side];
    return copy(geometry_.sides().tile_of_side[partner], from.isometry * parts_.crossings[partner]);
  }

  /// Walks to a copy that contains 0, along the straight line from the middle of the copy given.
  [[nodiscard]] Copy copy_at_origin(Copy current) const {
    static const T kTiny = ldexp(T(1), -80);
    PrecisePoint start{};
    for (const PrecisePoint& k : current.corners) start = start + k;
    start = T(1 / T(current.corners.size())) * start;
    const PrecisePoint direction = -start;
    for (std::uint32_t steps = 0; steps < 1000000; ++steps) {
      T exit_at = 1 - kTiny;
      std::optional<std::uint32_t> exit;
      for (std::uint32_t side = 0; side < current.corners.size(); ++side) {
        const PrecisePoint& u = current.corners[side];
        const PrecisePoint along = current.corners[(side + 1) % current.corners.size()] - u;
        const T slope = cross(along, direction);
        if (!(slope < -kTiny * norm(along))) continue;
        const T at = cross(along, start - u) / -slope;
        if (at < exit_at) {
          exit_at = at;
          exit = side;
        }
      }
      if (!exit) return current;
      current = neighbour(current, *exit);
    }
    throw NetGeometryError("no copy of a tile contains the centre of the Dirichlet domain");
  }

  /// Where the tile's origin goes, on a grid of 2⁻¹²⁰: different copies are farther apart than that up to a distance of
  /// 40 from the centre, and copies computed in two ways are not that far apart. The grid is shifted, as the values
  /// themselves like to be round; a copy taken for two would cost time, no more.
  [[nodiscard]] static Key key(const Copy& copy) {
    const PrecisePoint z = copy.isometry(PrecisePoint{});
    const auto index = [](const T& x) { return T(floor(T(ldexp(x, 120) + 0.3819))); };
    return {copy.tile, index(z.x), index(z.y)};
  }

  [[nodiscard]] double entry_distance(const Copy& copy, std::uint32_t side) const {
    return cell_.nearest_on_segment(convert<double>(copy.corners[side]),
                                    convert<double>(copy.corners[(side + 1) % copy.corners.size()]));
  }

  /// Cuts the cell with what the copy and the copies of the same tile visited before lead to, and queues the copy's
  /// sides.
  void visit(Copy copy) {
    if (!(norm(copy.isometry.b) >= 0)) throw NetGeometryError("a side pairing of the tiles is no isometry");
    if (!seen_.insert(key(copy)).second) return;
    if (copies_.size() >= max_copies_)
      throw NetGeometryError("the Dirichlet domain meets more than " + std::to_string(max_copies_) +
                             " copies of the tiles");
    bool changed = false;
    for (const std::uint32_t other : by_tile_[copy.tile]) {
      const Isometry<T> g = copy.isometry * inverse(copies_[other].isometry);
      const T scale = 1 / norm(g.a);
      changed |= cell_.cut(scale * (g.b * g.a));           // g(0) = b/ā
      changed |= cell_.cut(-(scale * (g.b * conj(g.a))));  // g⁻¹(0) = −b/a
    }
    if (changed) cell_area_ = cell_.area();
    const auto number = static_cast<std::uint32_t>(copies_.size());
    for (std::uint32_t side = 0; side < copy.corners.size(); ++side) {
      const double distance = entry_distance(copy, side);
      if (!std::isinf(distance)) entries_.push({distance, number, side});
    }
    by_tile_[copy.tile].push_back(number);
    copies_.push_back(std::move(copy));
  }

  const NetGeometry& geometry_;
  const Parts<T>& parts_;
  T area_;  ///< Of the surface.
  std::uint32_t max_copies_;
  std::vector<std::vector<PrecisePoint>> tiles_;  ///< Poincaré model.
  std::vector<std::vector<std::uint32_t>> by_tile_;
  std::deque<Copy> copies_;
  std::set<Key> seen_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> entries_;
  VoronoiCell<T> cell_;
  T cell_area_ = std::numeric_limits<T>::infinity();
};

template <class T>
DirichletDomain search(const NetGeometry& geometry, std::uint32_t vertex, const Parts<T>& parts,
                       std::uint32_t max_copies) {
  const certify::NetDocument::Vertex& v = geometry.document().vertices[vertex];
  const std::uint32_t tile = geometry.document().charts[v.chart].tile;
  const Isometry<T> to_screen = normalized(Isometry<T>::translation({T(-v.x), T(-v.y)}));
  return Search<T>(geometry, parts, max_copies).run(tile, to_screen * inverse(parts.frames[v.chart]));
}

/// True if T has bits enough for copies of these tiles.
template <class T>
bool fits(const Parts<T>& parts) {
  // Crossings lose four times their size; copies far out, and returning from there, as much again at most.
  const auto small = [](const Isometry<T>& f) { return 4 * size_in_bits(f) < 0.5 * kMantissaBits<T>; };
  return std::all_of(parts.crossings.begin(), parts.crossings.end(), small) &&
         std::all_of(parts.frames.begin(), parts.frames.end(), small);
}

}  // namespace

DirichletDomain dirichlet_domain(const NetGeometry& geometry, std::uint32_t vertex, std::uint32_t max_copies) {
  if (vertex >= geometry.document().vertices.size())
    throw NetGeometryError("vertex " + std::to_string(vertex) + " does not exist");
  if (const Parts<Mp256> parts(geometry.document(), geometry.sides()); fits(parts))
    return search(geometry, vertex, parts, max_copies);
  if (const Parts<Mp1024> parts(geometry.document(), geometry.sides()); fits(parts))
    return search(geometry, vertex, parts, max_copies);
  return search(geometry, vertex, Parts<Mp4096>(geometry.document(), geometry.sides()), max_copies);
}

}  // namespace epsnet
