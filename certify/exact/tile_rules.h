#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/interval.h"
#include "certify/exact/net_rules.h"

/// Sections 2 and 9.1: what rule `surface` asks of tiles whose vertices are given, whatever numbers they have.
namespace epsnet::exact {

[[noreturn]] inline void refute_vertex_of(std::size_t tile) {
  throw Refutation{"tile " + number(tile) + " has a vertex outside of the disk"};
}

template <class R>
class TileRules {
 public:
  /// Vectors of points of the disk, by tile.
  TileRules(NetRules<R>& rules, std::vector<std::vector<MinkowskiVector<R>>> tiles)
      : rules_(rules), tiles_(std::move(tiles)) {}

  [[nodiscard]] const MinkowskiVector<R>& side_start(Index s) const {
    return tiles_[rules_.tile_of(s)][rules_.vertex_of(s)];
  }
  [[nodiscard]] const MinkowskiVector<R>& side_end(Index s) const { return side_start(rules_.side_after(s)); }

  /// (a), of vertices in the disk.
  void check_convexity() const {
    for (std::size_t t = 0; t < tiles_.size(); ++t) check_tile(t);
  }

  /// (f) and (g): around every cycle of corners the crossings multiply to 1 and the angles add up to one full turn. The
  /// number of cycles.
  std::size_t check_corners(const std::vector<Isometry<R>>& crossings) {
    std::vector<bool> seen(rules_.sides());
    std::size_t cycles = 0;
    for (Index first = 0; first < seen.size(); ++first) {
      if (seen[first]) continue;
      ++cycles;
      const std::string name = rules_.corner_name(first);
      std::vector<const Isometry<R>*> path;
      Interval angles;
      for (Index s = first; !seen[s]; s = rules_.side_after(rules_.partner(s))) {
        seen[s] = true;
        path.push_back(&crossings[s]);
        angles = angles + interior_angle(s);
      }
      if (!is_identity(rules_.product(path))) throw Refutation{"the corners around " + name + " do not close up"};
      // By (f) they are full turns.
      const Answer is_more = is_less(3 * Interval::pi(), angles);
      if (is_more == Answer::unknown) throw TooLarge{"the angles around " + name + " are not known well enough"};
      if (is_more == Answer::yes) {
        const double turns = (angles / (2 * Interval::pi())).lower();
        throw Refutation{"the angles around " + name + " add up to " + std::to_string(std::lround(turns)) +
                         " full turns"};
      }
    }
    return cycles;
  }

 private:
  /// A left turn at every corner, and seen from vertex 0 in counterclockwise order.
  void check_tile(std::size_t t) const {
    const std::vector<MinkowskiVector<R>>& v = tiles_[t];
    const std::size_t n = v.size();
    const std::string name = "tile " + number(t);
    const auto is_left = [&](std::size_t i, std::size_t j, std::size_t k) {
      return sgn(determinant(v[i], v[j % n], v[k % n])) > 0;
    };
    for (std::size_t k = 0; k < n; ++k) {
      rules_.spend(bits(v[0]) + bits(v[1]));  // The others are used three times each.
      const bool left_of_first = k < 2 || is_left(0, 1, k);
      const bool in_order = k < 1 || k + 1 >= n || is_left(0, k, k + 1);
      if (!is_left(k, k + 1, k + 2) || !left_of_first || !in_order) {
        throw Refutation{name + " is not strictly convex and counterclockwise at its vertex " + number(k)};
      }
    }
  }

  /// Where the side starts, between 0 and π.
  [[nodiscard]] Interval interior_angle(Index s) const {
    const MinkowskiVector<R>& v = side_start(s);
    const MinkowskiVector<R>& n = side_end(s);
    const MinkowskiVector<R>& p = side_start(rules_.side_before(s));
    const R square = -lorentz_product(v, v);
    const R cosine = square * lorentz_product(n, p) + lorentz_product(v, n) * lorentz_product(v, p);
    const Interval sine = sqrt(enclosure(square)) * enclosure(determinant(v, n, p));
    return Interval::pi() / 2 - arctan(enclosure(cosine) / sine);
  }

  NetRules<R>& rules_;
  std::vector<std::vector<MinkowskiVector<R>>> tiles_;
};

}  // namespace epsnet::exact
