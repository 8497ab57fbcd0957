#pragma once

#include <cmath>
#include <complex>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <tuple>

#include "tests/assurance/file_mutants/net_rules.h"

/// The rules of geodesics files over an exact ring F. A closed geodesic is identified by the sides of tiles that it
/// crosses, in cyclic order and up to direction. The vertices of the tiles are moved a little, in a way compatible with
/// the group, so that no geodesic runs through a vertex. The crossings stay the same, and any tiles with these
/// crossings will do.
namespace epsnet::attack {

template <class F>
class GeodesicRules {
 public:
  GeodesicRules(const GeodesicsFile& file, Tiling<F> tiling)
      : tiles_(file.net.tiles),
        genus_(file.net.genus),
        next_(file.net.next),
        partner_(file.net.partner),
        tile_(file.net.tile),
        tiling_(std::move(tiling)),
        claim_(file.claim) {
    move_vertices();
    for (const auto& polygon : tiling_.tiles) {
      std::complex<double> mean = 0;  // In the Klein model, where the polygon is convex.
      for (const Point<F>& z : polygon) {
        const Complex<F> n = z.n * conj(z.d);
        const F size = norm(z.d) + norm(z.n);
        mean +=
            std::complex<double>(2 * ratio(n.re, size), 2 * ratio(n.im, size)) / static_cast<double>(polygon.size());
      }
      mean /= 1 + std::sqrt(1 - std::norm(mean));
      centre_.push_back(point<F>({mpq_class(mean.real()), mpq_class(mean.imag())}));
    }
    learn(file);
  }

  [[nodiscard]] bool same_surface(const NetFile& net) const {
    return net.genus == genus_ && net.tiles == tiles_ && net.partner == partner_ && net.next == next_;
  }

  /// The rules after those of the net. Throws Broken.
  void check(const GeodesicsFile& file) const {
    std::vector<Class> classes;
    for (const GeodesicsFile::Geodesic& g : file.geodesics) {
      classes.push_back(class_of(file, g));
      const Class& c = classes.back();
      if (compare(c.sinh_square, c.determinant, SinhSquare(g.length[0] / 2)) < 0) throw Broken{"geodesics"};
      if (compare(c.sinh_square, c.determinant, SinhSquare(g.length[1] / 2)) > 0) throw Broken{"geodesics"};
      if (!within(c, file)) throw Broken{"geodesics"};
    }
    std::set<std::vector<Index>> found;
    for (const Class& c : classes) {
      if (file.claim != "systole" && !found.insert(c.sides).second) throw Broken{"distinct"};
    }
    for (std::size_t i = 0; i < classes.size(); ++i) {
      if ((classes[i].simple && classes[i].power == 1) != file.geodesics[i].simple) throw Broken{"simple"};
    }
    for (const GeodesicsFile::Cluster& cluster : file.clusters) {
      for (Index i = cluster.first + 1; cluster.equal && i < cluster.first + cluster.count; ++i) {
        if (difference_of_lengths(classes[i - 1], classes[i]) != 0) throw Broken{"equal"};
      }
    }
    complete(file, classes);
    if (file.claim == "thick-thin") pieces(file, classes);
  }

 private:
  struct Class {
    std::vector<Index> sides;  ///< Crossed by one primitive period: the least of all ways to write them.
    bool forward;              ///< So directed, and not the other way.
    int power;                 ///< How often the element runs through the period.
    bool simple;               ///< The primitive one.
    F sinh_square;             ///< sinh² of half the length, times the determinant.
    F determinant;
  };

  void move_vertices() {
    std::vector<Index> first(tiling_.tiles.size(), ~Index{0});
    for (Index s = 0; s < tile_.size(); ++s) first[tile_[s]] = std::min(first[tile_[s]], s);
    const auto old = tiling_.tiles;
    for (long part = 60; part < 1'000'000'000; part *= 8) {
      std::vector<bool> seen(tile_.size());
      for (Index s = 0; s < tile_.size(); ++s) {
        if (seen[s]) continue;
        const Point<F> shift{{F(mpz_class(7 + 3 * (s % 5))), F(mpz_class(2 + s % 7))}, {F(mpz_class(11 * part)), F(0)}};
        Point<F> z = inverse(to_origin(old[tile_[s]][s - first[tile_[s]]]))(shift);
        for (Index t = s; !seen[t]; t = next_[partner_[t]]) {
          seen[t] = true;
          reduce(z.n, z.d);
          tiling_.tiles[tile_[t]][t - first[tile_[t]]] = z;
          z = tiling_.crossing[t](z);
        }
      }
      if (convex()) break;
    }
    if (!convex()) throw std::runtime_error("the vertices of the tiles cannot be moved");
    first_ = first;
  }
  [[nodiscard]] bool convex() const {
    for (const auto& polygon : tiling_.tiles) {
      const std::size_t n = polygon.size();
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 2; j < n; ++j) {
          if (turn(polygon[i], polygon[(i + 1) % n], polygon[(i + j) % n]) <= 0) return false;
        }
      }
    }
    return true;
  }

  [[nodiscard]] Class class_of(const GeodesicsFile& file, const GeodesicsFile::Geodesic& g) const {
    return class_of(file.net.charts[file.net.vertices[g.vertex].chart].tile, g.word);
  }

  [[nodiscard]] Class class_of(Index tile, const std::vector<Index>& word) const {
    const std::lock_guard lock(*mutex_);
    const auto known = memory_.find({tile, word});
    if (known != memory_.end()) return known->second;
    Isometry<F> g;
    for (const Index s : word) g = tiling_.crossing[s] * g;
    Class result = classify(tile, std::move(g));
    if (memory_.size() < 100'000) memory_.emplace(std::make_pair(tile, word), result);
    return result;
  }

  /// Returns for each vertex of a tile −1 or 1 if it is right or left of the axis.
  [[nodiscard]] std::vector<int> sides_of_axis(Index tile, const Isometry<F>& g) const {
    std::vector<int> result;
    for (const Point<F>& z : tiling_.tiles[tile]) {
      result.push_back(sign(side_of_axis(g, z)));
      if (result.back() == 0) throw Unknown{"an axis through a vertex"};
    }
    return result;
  }
  [[nodiscard]] static Isometry<F> directed(Isometry<F> g) { return sign(g.a.re) < 0 ? Isometry<F>{-g.a, -g.b} : g; }
  void cross(Index s, Index& tile, Isometry<F>& g) const {
    g = directed(tiling_.crossing[s] * (g * inverse(tiling_.crossing[s])));
    tile = tile_[partner_[s]];
  }
  /// Returns the side through which the perpendicular from a point to the axis leaves a tile that it meets.
  [[nodiscard]] Index towards_axis(Index tile, const Isometry<F>& g, const Point<F>& from) const {
    const auto vector = [](const Point<F>& z) {
      const Complex<F> n = z.n * conj(z.d);
      return std::array<F, 3>{F(n.re + n.re), F(n.im + n.im), F(norm(z.d) + norm(z.n))};
    };
    const std::array<F, 3> n{F(-g.b.im), g.b.re, g.a.im};
    const std::array<F, 3> x = vector(from);
    const int start = sign(side_of_axis(g, from));
    std::vector<int> sides;  // By vertex: left or right of the perpendicular.
    for (const Point<F>& z : tiling_.tiles[tile]) {
      const std::array<F, 3> y = vector(z);
      const F det = n[0] * F(x[1] * y[2] - x[2] * y[1]) + n[1] * F(x[2] * y[0] - x[0] * y[2]) +
                    n[2] * F(x[0] * y[1] - x[1] * y[0]);
      sides.push_back(start * sign(det));
      if (sides.back() == 0) throw Unknown{"a perpendicular through a vertex"};
    }
    return exit(tile, sides);
  }
  /// Returns the side through which a line leaves the tile: counterclockwise, its start is right of the line and its
  /// end left.
  [[nodiscard]] Index exit(Index tile, const std::vector<int>& sides) const {
    for (Index s = first_[tile]; s < tile_.size() && tile_[s] == tile; ++s) {
      if (sides[s - first_[tile]] < 0 && sides[next_[s] - first_[tile]] > 0) return s;
    }
    throw Unknown{"a line that does not meet its tile"};
  }

  [[nodiscard]] Class classify(Index tile, Isometry<F> g) const {
    const F det = determinant(g);
    const F square = g.a.re * g.a.re - det;
    if (sign(square) <= 0) throw Broken{"geodesics"};  // The identity: there is nothing elliptic or parabolic.
    g = directed(std::move(g));
    Point<F> from = centre_[tile];
    for (int steps = 0;; ++steps) {
      const std::vector<int> sides = sides_of_axis(tile, g);
      if (std::find(sides.begin(), sides.end(), -sides[0]) != sides.end()) break;
      if (steps == 5000) throw Unknown{"an axis that is not found"};
      const Index s = towards_axis(tile, g, from);
      from = tiling_.crossing[s](from);
      reduce(from.n, from.d);
      cross(s, tile, g);
    }
    struct Visit {
      Index tile;
      Isometry<F> g;
    };
    const Visit start{tile, g};
    std::vector<Visit> visits;
    std::vector<Index> word;
    Isometry<F> period;
    do {
      if (visits.size() == 2000) throw Unknown{"a long geodesic"};
      visits.push_back({tile, g});
      const Index s = exit(tile, sides_of_axis(tile, g));
      word.push_back(s);
      period = tiling_.crossing[s] * period;
      cross(s, tile, g);
    } while (tile != start.tile || !same(g, start.g));
    Class result{{}, true, 1, true, square, det};
    const auto length = [](const F& sinh_square, const F& d) {
      return 2 * std::asinh(std::sqrt(ratio(sinh_square, d)));
    };
    const F det1 = determinant(period);
    result.power =
        static_cast<int>(std::lround(length(square, det) / length(F(period.a.re * period.a.re - det1), det1)));
    for (std::size_t i = 0; i < visits.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        result.simple = result.simple && !(visits[i].tile == visits[j].tile && cross(visits[i].g, visits[j].g));
    }
    for (const bool forward : {true, false}) {
      std::vector<Index> sides = word;
      if (!forward) {
        std::reverse(sides.begin(), sides.end());
        for (Index& s : sides) s = partner_[s];
      }
      for (std::size_t i = 0; i < sides.size(); ++i) {
        std::rotate(sides.begin(), sides.begin() + 1, sides.end());
        if (!result.sides.empty() && !(sides < result.sides)) continue;
        result.sides = sides;
        result.forward = forward;
      }
    }
    return result;
  }
  /// Whether the axes cross: |⟨m, n⟩|² < ⟨m, m⟩⟨n, n⟩ for the normals (−Im b, Re b, Im a).
  [[nodiscard]] static bool cross(const Isometry<F>& f, const Isometry<F>& g) {
    const auto product = [](const Isometry<F>& x, const Isometry<F>& y) {
      return F(x.b.im * y.b.im + x.b.re * y.b.re - x.a.im * y.a.im);
    };
    const F mixed = product(f, g);
    return sign(F(mixed * mixed - product(f, f) * product(g, g))) < 0;
  }

  [[nodiscard]] static int difference_of_lengths(const Class& x, const Class& y) {
    return sign(F(x.sinh_square * y.determinant - y.sinh_square * x.determinant));
  }
  /// Whether a geodesic is no longer than the bound of the file's claim.
  [[nodiscard]] static bool within(const Class& c, const GeodesicsFile& file) {
    if (file.claim == "systole") return true;
    if (file.claim == "thick-thin") return sign(F(c.sinh_square - c.determinant)) <= 0;
    return compare(c.sinh_square, c.determinant, SinhSquare(file.up_to / 2)) < 0;
  }

  void complete(const GeodesicsFile& file, const std::vector<Class>& classes) const {
    if (file.claim == "systole") {
      for (const Class& c : known_) {
        if (difference_of_lengths(c, classes[0]) < 0) throw Broken{"complete"};
      }
      if (known_.empty()) throw Unknown{"no systole is known"};
      return;
    }
    std::set<std::vector<Index>> found;
    for (const Class& c : classes) {
      found.insert(c.sides);
      if (c.power != 1) throw Broken{"complete"};
    }
    for (const Class& c : known_) {
      if (within(c, file) && !found.contains(c.sides)) throw Broken{"complete"};
    }
    if (file.claim == "spectrum" && file.up_to > bound_) throw Unknown{"lengths up to here are not known"};
    if (file.claim == "thick-thin" && claim_ != "thick-thin" && bound_ < mpq_class(18, 10))
      throw Unknown{"lengths up to 1.77 are not known"};
  }

  using Pieces = std::multiset<std::pair<Index, std::set<std::pair<std::vector<Index>, bool>>>>;
  /// Returns the pieces, their boundaries given by geodesic and side; each geodesic has a fixed direction.
  [[nodiscard]] static Pieces pieces_of(const GeodesicsFile& file, const std::vector<Class>& classes) {
    Pieces result;
    for (const GeodesicsFile::Piece& piece : file.pieces) {
      std::set<std::pair<std::vector<Index>, bool>> boundaries;
      for (const auto& [geodesic, side] : piece.boundaries) {
        boundaries.emplace(classes[geodesic].sides, (side == 1) == classes[geodesic].forward);
      }
      result.emplace(piece.genus, std::move(boundaries));
    }
    return result;
  }
  void pieces(const GeodesicsFile& file, const std::vector<Class>& classes) const {
    if (claim_ != "thick-thin") throw Unknown{"the pieces are not known"};
    if (pieces_of(file, classes) != pieces_) throw Broken{"pieces"};
  }

  void learn(const GeodesicsFile& file) {
    std::vector<Class> listed;
    for (const GeodesicsFile::Geodesic& g : file.geodesics) listed.push_back(class_of(file, g));
    pieces_ = pieces_of(file, listed);
    bound_ = file.claim == "spectrum"  ? file.up_to
             : file.claim == "systole" ? file.geodesics[0].length[1]
                                       : mpq_class(17627, 10000);
    if (search(bound_.get_d() + 0.1)) {
      bound_ += mpq_class(99, 1000);
      check(file);
    } else {
      known_ = std::move(listed);
    }
  }

  /// Finds all geodesics up to a length. The search is in binary64, the elements found are exact. False if there are
  /// too many.
  [[nodiscard]] bool search(double longest) {
    struct Copy {
      Index tile;
      std::array<double, 4> g;  // Re a, Im a, Re b, Im b of determinant 1, from the copy's tile to the first one.
      std::size_t parent;
      Index side;
    };
    const auto numbers = [](const Isometry<F>& f) {
      const F det = determinant(f);
      const auto part = [&](const F& x) {
        const int s = sign(x);
        return s == 0 ? 0.0 : s * std::sqrt(ratio(F(x * x), det));
      };
      return std::array<double, 4>{part(f.a.re), part(f.a.im), part(f.b.re), part(f.b.im)};
    };
    const auto times = [](const std::array<double, 4>& f, const std::array<double, 4>& g) {
      const std::complex<double> fa(f[0], f[1]), fb(f[2], f[3]), ga(g[0], g[1]), gb(g[2], g[3]);
      const std::complex<double> a = fa * ga + fb * std::conj(gb);
      const std::complex<double> b = fa * gb + fb * std::conj(ga);
      return std::array<double, 4>{a.real(), a.imag(), b.real(), b.imag()};
    };
    std::vector<std::array<double, 4>> back;  // Of every side: from the tile across.
    for (const Isometry<F>& f : tiling_.crossing) back.push_back(numbers(inverse(f)));
    const auto at = [&](const Point<F>& z) {
      const Complex<F> n = z.n * conj(z.d);
      return std::complex<double>(ratio(n.re, norm(z.d)), ratio(n.im, norm(z.d)));
    };
    const auto moved = [](const std::array<double, 4>& g, std::complex<double> z) {
      const std::complex<double> a(g[0], g[1]), b(g[2], g[3]);
      return (a * z + b) / (std::conj(b) * z + std::conj(a));
    };
    const auto distance = [](std::complex<double> z, std::complex<double> w) {
      return 2 * std::asinh(std::sqrt(std::norm(z - w) / ((1 - std::norm(z)) * (1 - std::norm(w)))));
    };
    double radius = 0;
    for (std::size_t t = 0; t < tiling_.tiles.size(); ++t) {
      for (const Point<F>& z : tiling_.tiles[t]) radius = std::max(radius, distance(at(centre_[t]), at(z)));
    }
    const double displacement = 2 * std::asinh(std::sinh(longest / 2) * std::cosh(radius)) + 0.01;
    if (!(displacement + radius < 11.5)) return false;
    std::set<std::vector<Index>> found;
    for (Index t0 = 0; t0 < tiling_.tiles.size(); ++t0) {
      const std::complex<double> centre = at(centre_[t0]);
      std::vector<Copy> copies{{t0, {1, 0, 0, 0}, 0, 0}};
      std::set<std::tuple<Index, long, long>> seen;
      for (std::size_t i = 0; i < copies.size(); ++i) {
        const Index tile = copies[i].tile;
        if (i > 0 && tile == t0) {
          const double half = std::fabs(copies[i].g[0]);
          if (half > 1 && 2 * std::acosh(half) < longest + 1e-6) {
            std::vector<Index> word;  // The copy is reached from the first tile; the element leads back.
            for (std::size_t k = i; k != 0; k = copies[k].parent) word.push_back(partner_[copies[k].side]);
            const Class c = class_of(t0, word);
            if (c.power == 1 && found.insert(c.sides).second) known_.push_back(c);
          }
        }
        for (Index s = first_[tile]; s < tile_.size() && tile_[s] == tile; ++s) {
          Copy child{tile_[partner_[s]], times(copies[i].g, back[s]), i, s};
          const std::complex<double> z = moved(child.g, at(centre_[child.tile]));
          if (distance(centre, z) > displacement + radius) continue;
          const double scale = 16 / (1 - std::norm(z));
          if (seen.emplace(child.tile, std::lround(z.real() * scale), std::lround(z.imag() * scale)).second)
            copies.push_back(child);
        }
      }
    }
    return true;
  }

  std::vector<std::vector<RationalPoint>> tiles_;
  Index genus_;
  std::vector<Index> next_;
  std::vector<Index> partner_;
  std::vector<Index> tile_;
  std::vector<Index> first_;  ///< Side of a tile.
  Tiling<F> tiling_;
  std::vector<Point<F>> centre_;
  std::string claim_;
  mpq_class bound_;  ///< All geodesics up to this length are known.
  std::vector<Class> known_;
  Pieces pieces_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  mutable std::map<std::pair<Index, std::vector<Index>>, Class> memory_;
};

}  // namespace epsnet::attack
