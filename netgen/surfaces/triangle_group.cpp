#include "netgen/surfaces/triangle_group.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace epsnet {
namespace {

using certify::PowerOfZeta;
using Number = TriangleGroup::Number;
using ExactElement = TriangleGroup::ExactElement;

constexpr std::int64_t kMostOrder = 100'000;

std::int64_t order_of(RegularTile tile) {
  return std::lcm(std::lcm(std::int64_t{2} * tile.p, std::int64_t{2} * tile.q), std::int64_t{4});
}

Number pi() { return boost::math::constants::pi<Number>(); }

/// The turn around 0 by an angle.
Isometry<Number> turned(const Number& angle) {
  const Number half = angle / 2;
  return {{cos(half), sin(half)}, {Number(0), Number(0)}};
}

std::unique_ptr<const certify::RegularRing> ring_of(RegularTile tile, const certify::Budget& budget) {
  if (tile.p < 3 || tile.q < 3 || 2 * (std::uint64_t{tile.p} + tile.q) >= std::uint64_t{tile.p} * tile.q) {
    throw SurfaceError("tiles " + std::to_string(tile.p) + " " + std::to_string(tile.q) +
                       ": expected p and q of at least 3, with 1/p + 1/q < 1/2");
  }
  const std::int64_t order = order_of(tile);
  if (order > kMostOrder) {
    throw SurfaceError("tiles: lcm(2p, 2q, 4) is " + std::to_string(order) + ", expected at most " +
                       std::to_string(kMostOrder));
  }
  // s² = (2 sin(π/q))² (2 cos(2π/p) + 2 cos(2π/q)).
  const std::int64_t p = order / tile.p;
  const std::int64_t q = order / tile.q;
  std::vector<PowerOfZeta> square;
  for (const PowerOfZeta& x : {PowerOfZeta{2, 0}, PowerOfZeta{-1, q}, PowerOfZeta{-1, -q}}) {
    for (const std::int64_t power : {p, -p, q, -q}) square.push_back({x.coefficient, x.power + power});
  }
  return std::make_unique<certify::RegularRing>(static_cast<std::uint32_t>(order), square, budget);
}

bool is_zero(const certify::RegularNumber& x) {
  return certify::sign(certify::twice_real(x)) == 0 && certify::sign(certify::twice_imaginary(x)) == 0;
}

/// Glues tiles as walks and vertices say. A side is a number: its tile times p and its place there.
class CosetTiles {
 public:
  using Side = std::uint32_t;

  explicit CosetTiles(RegularTile tile) : p_(tile.p), q_(tile.q) { add_tile(); }

  /// Whether it ends within the limit.
  bool enumerate(const std::vector<TileWalk>& walks) {
    for (const TileWalk& walk : walks) {
      if (!close(walk, 0)) return false;
    }
    TileWalk around_vertex{std::vector<std::uint32_t>(q_, 1), 1};
    around_vertex.turns.front() = 0;
    std::vector<bool> closed;  // The vertex where a side starts.
    for (std::uint32_t t = 0; t < parents_.size(); ++t) {
      for (std::uint32_t k = 0; k < p_ && parents_[t].tile == t; ++k) {
        closed.resize(partners_.size());
        if (closed[t * p_ + k]) continue;
        if (!close(around_vertex, t * p_ + k)) return false;
        closed.resize(partners_.size());
        for (Side side = canonical(t * p_ + k); !closed[side]; side = turned(canonical(partners_[side]), 1))
          closed[side] = true;
      }
    }
    return true;
  }

  /// With the tiles that are left numbered anew.
  SubgroupTiles result(const std::vector<TileWalk>& walks) {
    std::vector<std::uint32_t> numbers(parents_.size());
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < parents_.size(); ++t) {
      if (parents_[t].tile == t) numbers[t] = count++;
    }
    const auto numbered = [&](Side side) { return numbers[side / p_] * p_ + side % p_; };
    SubgroupTiles result;
    for (std::uint32_t t = 0; t < parents_.size(); ++t) {
      for (std::uint32_t k = 0; k < p_ && parents_[t].tile == t; ++k) {
        const Side side = numbered(t * p_ + k);
        const Side other = numbered(canonical(partners_[t * p_ + k]));
        if (side == other) throw SurfaceError("the group has torsion: half a turn about the midpoint of a side");
        if (side < other) result.gluing.push_back({side / p_, side % p_, other / p_, other % p_});
      }
    }
    expect_whole_vertices();
    for (const TileWalk& walk : walks) {
      Side side = 0;
      result.paths.emplace_back();
      for (const std::uint32_t turn : walk.turns) {
        side = turned(side, turn);
        result.paths.back().push_back(numbered(side));
        side = canonical(partners_[side]);
      }
    }
    return result;
  }

 private:
  static constexpr Side kNone = std::numeric_limits<Side>::max();
  static constexpr std::size_t kMostSides = std::size_t{1} << 20;

  void add_tile() {
    parents_.push_back({static_cast<std::uint32_t>(parents_.size()), 0});
    partners_.resize(partners_.size() + p_, kNone);
  }

  [[nodiscard]] Side turned(Side side, std::uint32_t by) const {
    return side - side % p_ + static_cast<Side>((std::uint64_t{side} % p_ + by) % p_);
  }

  /// The side of a tile that is left.
  [[nodiscard]] Side canonical(Side side) const {
    while (parents_[side / p_].tile != side / p_) {
      const Parent& parent = parents_[side / p_];
      side = turned(parent.tile * p_ + side % p_, parent.turn);
    }
    return side;
  }

  void expect_whole_vertices() {
    std::vector<bool> seen(partners_.size());
    for (Side first = 0; first < partners_.size(); ++first) {
      if (canonical(first) != first || seen[first]) continue;
      std::uint32_t corners = 0;
      for (Side side = first; !seen[side]; side = turned(canonical(partners_[side]), 1), ++corners) seen[side] = true;
      if (corners != q_) throw SurfaceError("the group has torsion: a turn about a vertex of the tiles");
    }
  }

  /// A walk from a side that is left ends where it starts: its two ends are followed as far as tiles are known, and
  /// what is between them is one crossing, or takes new tiles. False beyond the limit.
  bool close(const TileWalk& walk, Side base) {
    Side ahead = base;                                // After `done` crossings.
    Side behind = turned(base, p_ - walk.last_turn);  // Before all but `left` of them are taken back.
    std::size_t done = 0;
    std::size_t left = walk.turns.size();
    while (true) {
      for (; done < left; ++done) {
        const Side partner = partners_[turned(ahead, walk.turns[done])];
        if (partner == kNone) break;
        ahead = canonical(partner);
      }
      for (; done < left && partners_[behind] != kNone; --left)
        behind = turned(canonical(partners_[behind]), p_ - walk.turns[left - 1]);
      if (done == left) {
        identify(ahead, behind);
        return true;
      }
      const Side side = turned(ahead, walk.turns[done]);
      if (done + 1 == left) {
        glue(side, behind);
        return true;
      }
      if (partners_.size() + p_ > kMostSides) return false;
      add_tile();
      glue(side, static_cast<Side>(partners_.size()) - p_);
    }
  }

  void glue(Side side, Side other) {
    partners_[side] = other;
    partners_[other] = side;
  }

  /// Two sides are one, and so are their tiles, and what is across.
  void identify(Side first, Side second) {
    std::vector<std::pair<Side, Side>> open{{first, second}};
    while (!open.empty()) {
      Side kept = canonical(open.back().first);
      Side other = canonical(open.back().second);
      open.pop_back();
      if (kept == other) continue;
      if (kept / p_ == other / p_) throw SurfaceError("the group has torsion: a turn about the centre of a tile");
      if (kept > other) std::swap(kept, other);
      const std::uint32_t tile = other / p_;
      parents_[tile] = {kept / p_, (kept % p_ + p_ - other % p_) % p_};
      for (Side side = tile * p_; side < (tile + 1) * p_; ++side) {
        const Side partner = partners_[side];
        if (partner == kNone) continue;
        Side& known = partners_[canonical(side)];
        if (known == kNone) {
          known = partner;
        } else {
          open.emplace_back(known, partner);
        }
      }
    }
  }

  /// A tile that is the same as another one, turned.
  struct Parent {
    std::uint32_t tile;  ///< Its own number, if it is not.
    std::uint32_t turn;  ///< Side k is side k + turn there.
  };

  std::uint32_t p_;
  std::uint32_t q_;
  std::vector<Parent> parents_;
  std::vector<Side> partners_;  ///< By side; not canonical.
};

}  // namespace

TileWalk walk_of(const Surface& surface, const Word& word) {
  const std::uint32_t p = surface.regular_tile()->p;
  TileWalk result;
  std::uint32_t ahead = 0;
  for (const SideId s : word) {
    result.turns.push_back((surface.place_in_tile(s) + p - ahead) % p);
    ahead = surface.place_in_tile(surface.partner(s));
  }
  result.last_turn = (p - ahead) % p;
  return result;
}

TriangleGroup::TriangleGroup(RegularTile tile, const certify::Budget& budget)
    : tile_(tile), ring_(ring_of(tile, budget)) {
  const Number square = 2 * cos(Number(2 * pi() / tile.p)) + 2 * cos(Number(2 * pi() / tile.q));
  s_ = 2 * sin(Number(pi() / tile.q)) * sqrt(square);
}

std::optional<TileWalk> TriangleGroup::walk(const Isometry<Number>& element) const {
  constexpr std::size_t kMostSteps = 10'000;
  constexpr double kTiny = 1e-30;
  const std::uint32_t p = tile_.p;
  const Isometry<Number> back = inverse(element);
  // Half a turn about the midpoint of side 0.
  const Isometry<Number> half_turn =
      normalized(Isometry<Number>{{Number(0), Number(2 * sin(Number(2 * pi() / tile_.q)))}, {Number(0), Number(-s_)}});
  TileWalk result;
  Number farthest(1e200);
  Isometry<Number> from_start{{Number(1), Number(0)}, {Number(0), Number(0)}};
  // The number of the side in a direction, and how far the direction is from it, in sides.
  const auto side_ahead = [&](const Complex<Number>& direction) {
    const Number sides = atan2(direction.y, direction.x) * p / (2 * pi());
    const Number nearest = round(sides);
    const auto k = static_cast<std::int64_t>(nearest);
    return std::pair(static_cast<std::uint32_t>((k + p) % p), Number(abs(Number(sides - nearest))));
  };
  for (std::size_t step = 0; step <= kMostSteps; ++step) {
    const Isometry<Number> rest = from_start * back;  // Takes 0 to the goal, as seen from here.
    // Each crossing leads nearer to the centre of another tile. The first one bounds what is rounded off.
    const Number far = norm(rest.a);
    if (!(far < farthest)) return std::nullopt;
    farthest = far;
    if (sqrt(Number(norm(rest.b) / norm(rest.a))) < kTiny) {
      // A turn by the angle 2 arg a: the element turns back by it at last.
      const auto [sides, distance] =
          side_ahead({Number(rest.a.x * rest.a.x - rest.a.y * rest.a.y), Number(2 * rest.a.x * rest.a.y)});
      if (distance > kTiny) return std::nullopt;
      result.last_turn = sides;
      return result;
    }
    // The goal is b/ā.
    const std::uint32_t side = side_ahead({Number(rest.b.x * rest.a.x - rest.b.y * rest.a.y),
                                           Number(rest.b.x * rest.a.y + rest.b.y * rest.a.x)})
                                   .first;
    result.turns.push_back(side);
    from_start = normalized(half_turn * turned(Number(-2 * pi() * side / p)) * from_start);
  }
  return std::nullopt;
}

ExactElement TriangleGroup::element(const TileWalk& walk) const {
  const std::int64_t order = ring_->order();
  // e^{−iπk/p}, which turns by k sides clockwise.
  const auto turn = [&](std::uint32_t k) {
    return ExactElement{
        certify::regular_number(
            *ring_, std::array{PowerOfZeta{1, -std::int64_t{k} * (order / (std::int64_t{2} * tile_.p))}}, {}),
        certify::regular_number(*ring_, {}, {})};
  };
  // 2i sin(2π/q) and −is.
  const std::int64_t q = order / tile_.q;
  const ExactElement half_turn{certify::regular_number(*ring_, std::array{PowerOfZeta{1, q}, PowerOfZeta{-1, -q}}, {}),
                               certify::regular_number(*ring_, {}, std::array{PowerOfZeta{-1, order / 4}})};
  ExactElement last = turn(walk.last_turn);
  if (walk.turns.empty()) return last;
  return certify::compose(last, certify::compose_range(0, walk.turns.size(), [&](std::size_t i) {
                            return certify::compose(half_turn, turn(walk.turns[i]));
                          }));
}

bool TriangleGroup::same(const ExactElement& f, const ExactElement& g) {
  return certify::sign(certify::twice_imaginary(f.a * certify::conjugate(g.a))) == 0 && is_zero(f.a * g.b - f.b * g.a);
}

std::optional<SubgroupTiles> subgroup_tiles(RegularTile tile, const std::vector<TileWalk>& walks) {
  CosetTiles tiles(tile);
  if (!tiles.enumerate(walks)) return std::nullopt;
  return tiles.result(walks);
}

}  // namespace epsnet
