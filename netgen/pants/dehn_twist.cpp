#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "certify/numbers/exact.h"
#include "netgen/base/gmp.h"
#include "netgen/pants/curve_system.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/group.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

using Number = CurveSystem::Number;
using Vector = CurveSystem::Vector;

/// A curve where it passes through the tiles of a surface, to be twisted around.
class TwistCurve {
 public:
  TwistCurve(const Surface& surface, const Word& curve, std::int32_t power) : surface_(surface) {
    if (std::abs(power) > kMostTwists) {
      throw LimitError("a Dehn twist by the power " + std::to_string(power) + ", beyond " +
                       std::to_string(kMostTwists));
    }
    require_disjoint_curves(surface, {&curve, 1});
    CurveSystem system(surface);
    system.add({surface.tile_of_side(curve.front()), curve});
    chords_.resize(surface.tiles().size());
    for (CurveSystem::Chord& chord : system.chords(0)) {
      Word around;
      for (std::int32_t i = 0; i < std::abs(power); ++i) {
        around.insert(around.end(), chord.word.begin(), chord.word.end());
      }
      // Seen by somebody who comes from the curve's right, its direction is to the right.
      chords_[chord.tile].push_back({chord.normal, power > 0 ? reversed(surface, around) : std::move(around)});
    }
  }

  /// What a path in a tile, from one point to another, turns around: a word from the tile to itself.
  [[nodiscard]] Word turns(TileId tile, const Vector& from, const Vector& to) const {
    struct Crossing {
      Number place;
      const Chord* chord;
      bool from_right;
    };
    std::vector<Crossing> crossings;
    for (const Chord& chord : chords_[tile]) {
      const Number start = lorentz_product(chord.normal, from);
      const Number end = lorentz_product(chord.normal, to);
      if (is_left(start) == is_left(end)) continue;
      crossings.push_back({start / (start - end), &chord, !is_left(start)});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.place < b.place; });
    Word result;
    for (const Crossing& crossing : crossings) {
      const Word& word = crossing.chord->around;
      result = concatenated(surface_, std::move(result), crossing.from_right ? word : reversed(surface_, word));
    }
    return result;
  }

 private:
  struct Chord {
    Vector normal;
    Word around;  ///< Of somebody who comes from the right.
  };

  /// The curve is moved a little to its right, from the points that are on it.
  static bool is_left(const Number& height) { return height > boost::multiprecision::ldexp(Number(-1), -100); }

  const Surface& surface_;
  ById<TileId, std::vector<Chord>> chords_;
};

Vector corner(const Surface& surface, TileId tile, std::size_t k) {
  const Tile& corners = surface.tile(tile);
  return on_hyperboloid(convert<Number>(corners[k % corners.size()]));
}

/// A point inside of a tile.
Vector middle(const Surface& surface, TileId tile) {
  Vector sum;
  for (std::size_t k = 0; k < surface.tile(tile).size(); ++k) sum = sum + corner(surface, tile, k);
  return sum;
}

/// The tiles of a surface, twisted: their corners are lifts of the vertices of the surface, by words.
class TwistedTiles {
 public:
  TwistedTiles(const Surface& surface, const TwistCurve& curve)
      : surface_(surface), points_(surface.vertex_class_count()) {
    ById<SideId, Word> to_first(surface.side_count());
    ById<SideId, bool> known(surface.side_count());
    for (const SideId s : surface.side_ids()) {
      if (known[s]) continue;
      // Corners around a vertex, with paths back to the first one.
      Word path;
      for (const SideId c : surface.corner_cycle(s)) {
        known[c] = true;
        to_first[c] = reversed(surface, path);
        path.push_back(c);
      }
      points_[surface.vertex_class(s)] = corner(surface, surface.tile_of_side(s), surface.place_in_tile(s));
    }
    for (const TileId tile : surface.tile_ids()) {
      std::vector<Corner>& corners = corners_.emplace_back();
      Word word;
      for (const SideId c : surface.sides_of(tile)) {
        const std::uint32_t k = surface.place_in_tile(c);
        Word path = concatenated(surface, word, to_first[c]);
        const Isometry<Number> isometry = value_of(surface, path);
        corners.push_back({std::move(path), isometry, surface.vertex_class(c)});
        word = concatenated(surface, std::move(word),
                            curve.turns(tile, corner(surface, tile, k), corner(surface, tile, k + 1)));
      }
    }
  }

  /// Moves the vertices until no triangle turns over. Springs along all edges, in equilibrium, have no such triangle:
  /// that is Tutte's theorem (Y. Colin de Verdière, Comment rendre géodésique une triangulation d'une surface?, 1991).
  void relax() {
    constexpr int kMostSteps = 20'000;
    for (int step = 0; !is_oriented(); ++step) {
      if (step == kMostSteps) throw LimitError("no triangles were found for the twisted surface");
      pull();
    }
    // A little farther, for triangles that are not too thin.
    for (int step = 0; step < 20; ++step) {
      const std::vector<Vector> before = points_;
      pull();
      if (is_oriented()) continue;
      points_ = before;
      return;
    }
  }

  /// The surface of triangles, with vertices rounded to so many bits.
  [[nodiscard]] Surface rounded(unsigned bits) const {
    std::vector<Complex<Rational>> points;
    for (const Vector& p : points_) {
      const Complex<Number> z = in_disk(p);
      const auto round = [&](const Number& x) {
        return Rational(Number(boost::multiprecision::ldexp(
            Number(boost::multiprecision::round(Number(boost::multiprecision::ldexp(x, static_cast<int>(bits))))),
            -static_cast<int>(bits))));
      };
      points.push_back({round(z.x), round(z.y)});
    }
    return surface_.is_rational() ? with_rational_corners(points) : over_field(points);
  }

 private:
  struct Corner {
    Word to_first;              ///< From the tile to that of the first corner of its vertex;
    Isometry<Number> isometry;  ///< back, of determinant 1.
    std::uint32_t vertex;
  };
  using FieldIsometry = certify::Isometry<certify::FieldNumber>;

  static Isometry<Number> value_of(const Surface& surface, const Word& path) {
    return surface.is_rational() ? normalized(convert<Number>(inverse(exact_isometry(surface, path))))
                                 : convert<Number>(inverse(rounded_isometry<Mp1024>(field_isometry(surface, path))));
  }

  [[nodiscard]] Surface with_rational_corners(const std::vector<Complex<Rational>>& points) const {
    std::vector<Tile> tiles;
    for (const std::vector<Corner>& corners : corners_) {
      std::vector<Complex<Rational>> at;
      at.reserve(corners.size());
      for (const Corner& c : corners) at.push_back(inverse(exact_isometry(surface_, c.to_first))(points[c.vertex]));
      for (std::size_t k = 1; k + 1 < at.size(); ++k) tiles.push_back({at[0], at[k], at[k + 1]});
    }
    return {std::move(tiles), gluing()};
  }

  [[nodiscard]] Surface over_field(const std::vector<Complex<Rational>>& points) const {
    certify::SurfaceDocument::Field tiles = surface_.field_tiles()->document;
    tiles.polygons.clear();
    tiles.crossings.clear();
    std::vector<std::vector<FieldIsometry>> isometries;
    for (const std::vector<Corner>& corners : corners_) {
      std::vector<std::array<std::vector<mpz_class>, 3>> at;
      std::vector<FieldIsometry>& of_corners = isometries.emplace_back();
      for (const Corner& c : corners) {
        of_corners.push_back(certify::inverse(field_isometry(surface_, c.to_first)));
        const auto v = certify::hyperboloid_vector(
            certify::moved(of_corners.back(), certify::exact_point(to_gmp(points[c.vertex]))));
        at.push_back({coefficients_of(v.x), coefficients_of(v.y), coefficients_of(v.t)});
      }
      for (std::size_t k = 1; k + 1 < at.size(); ++k) {
        tiles.polygons.push_back({at[0], at[k], at[k + 1]});
        if (k > 1) tiles.crossings.push_back({{{1}, {0}, {0}, {0}}});
      }
    }
    // The start of a side is the end of its partner: both are lifts of one vertex.
    for (const Gluing& g : surface_.gluing()) {
      const std::vector<FieldIsometry>& others = isometries[g.other_tile];
      FieldIsometry crossing =
          certify::compose(others[(g.other_side + 1) % others.size()], certify::inverse(isometries[g.tile][g.side]));
      certify::reduce(crossing);
      const auto part = [&](const certify::Polynomial& x) {
        return coefficients_of({&surface_.field_tiles()->field, x});
      };
      tiles.crossings.push_back({part(crossing.a.re), part(crossing.a.im), part(crossing.b.re), part(crossing.b.im)});
    }
    return surface_over_field(std::move(tiles), gluing());
  }

  /// Of the triangles: the diagonals of each tile, then the sides of the surface in their order.
  [[nodiscard]] std::vector<Gluing> gluing() const {
    std::vector<std::uint32_t> first_triangle{0};
    for (const std::vector<Corner>& corners : corners_) {
      first_triangle.push_back(first_triangle.back() + static_cast<std::uint32_t>(corners.size()) - 2);
    }
    std::vector<Gluing> gluing;
    for (std::uint32_t tile = 0; tile < corners_.size(); ++tile) {
      for (std::uint32_t k = 2; k + 1 < corners_[tile].size(); ++k) {
        const std::uint32_t triangle = first_triangle[tile] + k - 2;
        gluing.push_back({triangle, 2, triangle + 1, 0});
      }
    }
    const auto side_of_triangle = [&](std::uint32_t tile, std::uint32_t side) {
      const auto count = static_cast<std::uint32_t>(corners_[tile].size());
      if (side == 0) return std::pair(first_triangle[tile], 0U);
      if (side == count - 1) return std::pair(first_triangle[tile] + count - 3, 2U);
      return std::pair(first_triangle[tile] + side - 1, 1U);
    };
    for (const Gluing& g : surface_.gluing()) {
      const auto [triangle, side] = side_of_triangle(g.tile, g.side);
      const auto [other, other_side] = side_of_triangle(g.other_tile, g.other_side);
      gluing.push_back({triangle, side, other, other_side});
    }
    return gluing;
  }

  [[nodiscard]] Vector at(const Corner& c) const { return image(c.isometry, points_[c.vertex]); }

  [[nodiscard]] std::vector<Vector> at(const std::vector<Corner>& corners) const {
    std::vector<Vector> result;
    result.reserve(corners.size());
    for (const Corner& c : corners) result.push_back(at(c));
    return result;
  }

  [[nodiscard]] bool is_oriented() const {
    for (const std::vector<Corner>& corners : corners_) {
      const std::vector<Vector> positions = at(corners);
      for (std::size_t k = 1; k + 1 < positions.size(); ++k) {
        const Number volume = lorentz_product(lorentz_cross(positions[0], positions[k]), positions[k + 1]);
        if (!(volume > boost::multiprecision::ldexp(Number(1), -60))) return false;
      }
    }
    return true;
  }

  /// Each vertex goes to the mean of its neighbours, as vectors of the hyperboloid.
  void pull() {
    std::vector<Vector> sums = points_;
    for (const std::vector<Corner>& corners : corners_) {
      const std::vector<Vector> positions = at(corners);
      const auto join = [&](std::size_t i, std::size_t j, const Number& weight) {
        for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)}) {
          sums[corners[a].vertex] =
              sums[corners[a].vertex] + weight * image(inverse(corners[a].isometry), positions[b]);
        }
      };
      const std::size_t count = corners.size();
      // Sides count from both tiles.
      for (std::size_t k = 0; k < count; ++k) join(k, (k + 1) % count, Number(1));
      for (std::size_t k = 2; k + 1 < count; ++k) join(0, k, Number(2));
    }
    for (std::size_t v = 0; v < points_.size(); ++v) {
      points_[v] = Number(1 / sqrt(Number(-lorentz_product(sums[v], sums[v])))) * sums[v];
    }
  }

  const Surface& surface_;
  std::vector<Vector> points_;  ///< By vertex, in the coordinates of the tile of its first corner.
  std::vector<std::vector<Corner>> corners_;
};

}  // namespace

ById<SideId, Word> dehn_twist_words(const Surface& surface, const Word& curve, std::int32_t power) {
  const TwistCurve twist(surface, curve, power);
  ById<SideId, Word> result(surface.side_count());
  for (const SideId s : surface.side_ids()) {
    const SideId other = surface.partner(s);
    const TileId tile = surface.tile_of_side(s);
    const TileId beyond = surface.tile_of_side(other);
    const auto middle_of_side = [&](SideId side) {
      const TileId of = surface.tile_of_side(side);
      const std::uint32_t k = surface.place_in_tile(side);
      return corner(surface, of, k) + corner(surface, of, k + 1);
    };
    Word word = twist.turns(tile, middle(surface, tile), middle_of_side(s));
    word.push_back(s);
    result[s] = concatenated(surface, concatenated(surface, {}, word),
                             twist.turns(beyond, middle_of_side(other), middle(surface, beyond)));
  }
  return result;
}

Surface dehn_twisted(const Surface& surface, const Word& curve, std::int32_t power) {
  if (surface.is_regular())
    throw SurfaceError("a Dehn twist needs tiles with rational corners, or over a number field: not regular ones");
  TwistedTiles tiles(surface, TwistCurve(surface, curve, power));
  tiles.relax();
  constexpr unsigned kMostBits = 240;
  for (unsigned bits = 60;; bits += 60) {
    try {
      return tiles.rounded(bits);
    } catch (const SurfaceError& error) {
      if (bits >= kMostBits) throw LimitError(std::string("the twisted triangles are too thin: ") + error.what());
    }
  }
}

Surface twisted(const Surface& surface, const Word& curve, const Rational& by, const PantsOptions& options) {
  PantsOptions along = options;
  along.curves.insert(along.curves.begin(), curve);
  FenchelNielsen coordinates = pants_decomposition(surface, along).coordinates();
  coordinates.twists[0] += by;
  return fenchel_nielsen_surface(coordinates);
}

}  // namespace epsnet
