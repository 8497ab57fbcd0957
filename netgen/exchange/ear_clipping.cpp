#include "netgen/exchange/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace epsnet {
namespace {

KleinVector swapped(const KleinVector& p) { return {p.y, p.x, p.t}; }

/// Returns the position of each point in the lexicographic order; equal points have the same position.
std::vector<std::uint32_t> ranks(std::span<const KleinVector> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(points[i], points[j]); });
  std::vector<std::uint32_t> rank(points.size());
  for (std::size_t k = 1; k < order.size(); ++k) {
    rank[order[k]] = rank[order[k - 1]] + (lexicographically_less(points[order[k - 1]], points[order[k]]) ? 1 : 0);
  }
  return rank;
}

/// The vertices of a polygon, and ranks that show without arithmetic that bounding boxes are disjoint.
///
/// The points of a segment lie between its ends in both lexicographic orders (x, y) and (y, x).
class Polygon {
 public:
  explicit Polygon(std::span<const KleinVector> points) : points_(points), rank_{ranks(points), {}} {
    std::vector<KleinVector> mirrored;
    for (const KleinVector& p : points) {
      mirrored.push_back(swapped(p));
      const Mp256 t(p.t);
      rounded_.push_back({static_cast<double>(Mp256(p.x) / t), static_cast<double>(Mp256(p.y) / t)});
    }
    rank_[1] = ranks(mirrored);
  }

  /// Returns the sign of the turn a, b, c, by doubles if they can decide it.
  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    // Coordinates are off by 2⁻⁵³, differences, at most 2, by 2⁻⁵¹, products by 2⁻⁴⁹ + 2⁻⁵¹, the determinant by less
    // than 2⁻⁴⁷.
    const double determinant = cross(rounded_[b] - rounded_[a], rounded_[c] - rounded_[a]);
    if (std::fabs(determinant) > 0x1p-47) return sign(determinant);
    return orientation(points_[a], points_[b], points_[c]);
  }

  /// Whether v lies on the closed segment ab.
  [[nodiscard]] bool on_segment(std::uint32_t v, std::uint32_t a, std::uint32_t b) const {
    return in_box(v, {a, b}) && turn(a, b, v) == 0;
  }

  /// Whether the closed segments ab and cd have a common point.
  [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    for (const auto& rank : rank_) {
      if (std::max(rank[a], rank[b]) < std::min(rank[c], rank[d])) return false;
      if (std::max(rank[c], rank[d]) < std::min(rank[a], rank[b])) return false;
    }
    if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    return on_segment(c, a, b) || on_segment(d, a, b) || on_segment(a, c, d) || on_segment(b, c, d);
  }

  /// Whether v lies in the closed triangle abc, which is counterclockwise.
  [[nodiscard]] bool in_triangle(std::uint32_t v, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return in_box(v, {a, b, c}) && turn(a, b, v) >= 0 && turn(b, c, v) >= 0 && turn(c, a, v) >= 0;
  }

 private:
  [[nodiscard]] bool in_box(std::uint32_t v, std::initializer_list<std::uint32_t> corners) const {
    return std::all_of(rank_.begin(), rank_.end(), [&](const std::vector<std::uint32_t>& rank) {
      const auto [low, high] = std::minmax_element(corners.begin(), corners.end(),
                                                   [&](std::uint32_t i, std::uint32_t j) { return rank[i] < rank[j]; });
      return rank[*low] <= rank[v] && rank[v] <= rank[*high];
    });
  }

  std::span<const KleinVector> points_;
  std::vector<Complex<double>> rounded_;
  std::array<std::vector<std::uint32_t>, 2> rank_;
};

/// The polygon while its ears are being clipped: a circular list of the remaining vertices.
class Clipping {
 public:
  explicit Clipping(std::span<const KleinVector> points)
      : polygon_(points),
        size_(static_cast<std::uint32_t>(points.size())),
        next_(size_),
        previous_(size_),
        edge_(size_) {
    for (std::uint32_t v = 0; v < size_; ++v) {
      next_[v] = v + 1 == size_ ? 0 : v + 1;
      previous_[next_[v]] = v;
    }
    result_.place_of_side.resize(size_);
  }

  PolygonTriangulation run() {
    std::vector<bool> ear(size_);
    for (std::uint32_t v = 0; v < size_; ++v) ear[v] = is_ear(v);
    std::uint32_t v = 0;
    for (std::uint32_t left = size_; left > 3; --left) {
      // There are always two ears (a clipped ear leaves a simple polygon without degenerate parts). Clipping one only
      // affects the two neighbours: other ears are blocked only by vertices that are not strictly convex, and such a
      // vertex is never clipped.
      std::uint32_t steps = 0;
      while (!ear[v]) {
        if (++steps > left) throw std::logic_error("no ear was found in a simple polygon");
        v = next_[v];
      }
      const std::uint32_t before = previous_[v];
      const std::uint32_t after = next_[v];
      const std::uint32_t triangle = add_triangle(before, v, after);
      next_[before] = after;
      previous_[after] = before;
      edge_[before] = {triangle, 2};
      ear[before] = is_ear(before);
      ear[after] = is_ear(after);
      // Skipping the neighbour avoids fans.
      v = next_[after];
    }
    const std::uint32_t triangle = add_triangle(previous_[v], v, next_[v]);
    attach(next_[v], triangle, 2);
    return std::move(result_);
  }

 private:
  /// The triangle, and its side, beyond the edge from a remaining vertex to the next one; nullopt for a side of the
  /// polygon.
  using Beyond = std::optional<std::pair<std::uint32_t, std::uint32_t>>;

  [[nodiscard]] bool is_ear(std::uint32_t v) const {
    const std::uint32_t a = previous_[v];
    const std::uint32_t b = next_[v];
    if (polygon_.turn(a, v, b) <= 0) return false;
    for (std::uint32_t u = next_[b]; u != a; u = next_[u]) {
      if (polygon_.in_triangle(u, a, v, b)) return false;
    }
    return true;
  }

  std::uint32_t add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto triangle = static_cast<std::uint32_t>(result_.triangles.size());
    result_.triangles.push_back({a, b, c});
    attach(a, triangle, 0);
    attach(b, triangle, 1);
    return triangle;
  }

  /// Makes the edge that starts at v the side `side` of the triangle.
  void attach(std::uint32_t v, std::uint32_t triangle, std::uint32_t side) {
    if (edge_[v]) {
      result_.diagonals.push_back({edge_[v]->first, edge_[v]->second, triangle, side});
    } else {
      result_.place_of_side[v] = {triangle, side};
    }
  }

  Polygon polygon_;
  std::uint32_t size_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> previous_;
  std::vector<Beyond> edge_;
  PolygonTriangulation result_;
};

}  // namespace

std::optional<std::pair<std::uint32_t, std::uint32_t>> crossing_sides(std::span<const KleinVector> polygon) {
  const Polygon vertices(polygon);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  const auto next = [n](std::uint32_t v) { return v + 1 == n ? 0 : v + 1; };
  for (std::uint32_t i = 0; i < n; ++i) {
    // Consecutive sides share a vertex; they must not turn back on one another.
    const std::uint32_t j = next(i);
    if (vertices.on_segment(i, j, next(j)) || vertices.on_segment(next(j), i, j)) return std::pair{i, j};
    for (std::uint32_t k = i + 2; k < n; ++k) {
      if (next(k) != i && vertices.meet(i, j, k, next(k))) return std::pair{i, k};
    }
  }
  return std::nullopt;
}

PolygonTriangulation clip_ears(std::span<const KleinVector> polygon) { return Clipping(polygon).run(); }

}  // namespace epsnet
