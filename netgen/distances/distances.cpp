#include "netgen/distances/distances.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/lorentz.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/atlas.h"
#include "triangulation/surface/points.h"

namespace epsnet {
namespace {

/// Lengths that agree to this many bits are claimed to be equal; certify decides. On very thin surfaces lengths may
/// agree to a hundred bits without being equal.
constexpr int kEqualBits = 300;

/// The most paths in a document. The 4g-gon of the largest genus has 4000 from its centre to its vertex; across a cuff
/// of length l there are about 10⁻⁷/l whose lengths are too close for binary64.
constexpr std::size_t kMostPaths = 5000;

/// Returns the isometry of a word.
Isometry<Mp1024> value(const Surface& surface, const Word& word) {
  Isometry<Mp1024> result;
  for (const SideId side : word) result = surface.crossing_as<Mp1024>(side) * result;
  return result;
}

/// Walks from lift to lift of q by the neighbours of p: the Dirichlet domain of p contains a nearest lift, and from any
/// lift outside of it a neighbour leads to a nearer one (docs/proof.md, Lemma 17).
class LiftsOfPoint {
 public:
  struct Path {
    Word word;
    Complex<Mp1024> end;  ///< In the disk with p at 0.
    Mp1024 length;
  };

  LiftsOfPoint(const Surface& surface, const BasePoint& p, const DirichletPolygon& polygon) : surface_(surface) {
    const Complex<Mp1024> centre = convert<Mp1024>(p.z);
    from_tile_ = Isometry<Mp1024>::translation(-centre);
    const Isometry<Mp1024> to_tile = Isometry<Mp1024>::translation(centre);
    for (const DirichletPolygon::Side& side : polygon.sides) {
      const Isometry<Mp1024> element = from_tile_ * value(surface, side.word) * to_tile;
      neighbours_.push_back({&side.word, element(Complex<Mp1024>{}), inverse(element)});
    }
  }

  /// Returns the least binary64 enclosure of the distance to a point of the surface, and all paths to it that are no
  /// longer than the upper end.
  [[nodiscard]] std::pair<std::vector<Path>, certify::Interval> shortest(TileId start, const BasePoint& q) const {
    Word word = path_between_tiles(surface_, start, q.tile);
    const Complex<Mp1024> end = from_tile_(inverse(value(surface_, word))(convert<Mp1024>(q.z)));
    const Path nearest = descended({std::move(word), end, distance(Complex<Mp1024>{}, end)});
    const certify::Interval enclosure = enclosing(nearest.length);
    const Mp1024 sinh_of_half = sinh(Mp1024(Mp1024(enclosure.upper) / 2));
    const Mp1024 most = sinh_of_half * sinh_of_half;
    std::vector<Path> paths{nearest};
    // Across a short curve ends are as near to each other as it is short: found again by how far they are from the
    // first.
    const auto end_key = [&](const Path& path) { return static_cast<double>(Mp1024(path.end.x - nearest.end.x)); };
    std::multimap<double, std::size_t> by_end{{0, 0}};
    for (std::size_t i = 0; i < paths.size(); ++i) {
      for (const Neighbour& neighbour : neighbours_) {
        if (sinh2_half_distance(neighbour.place, paths[i].end) > most) continue;
        Path next = moved(paths[i], neighbour);
        const double key = end_key(next);
        const double reach = 1e-14 * std::abs(key) + 1e-200;
        const bool known = std::any_of(by_end.lower_bound(key - reach), by_end.upper_bound(key + reach),
                                       [&](const auto& item) { return same_end(next, paths[item.second]); });
        if (known) continue;
        if (paths.size() == kMostPaths) {
          throw NetError("more than " + std::to_string(kMostPaths) +
                         " paths have lengths that binary64 does not tell apart: they cross a closed geodesic that is "
                         "too short");
        }
        by_end.emplace(key, paths.size());
        paths.push_back(std::move(next));
      }
    }
    std::stable_sort(paths.begin(), paths.end(),
                     [](const Path& a, const Path& b) { return a.length + ldexp(Mp1024(1), -kEqualBits) < b.length; });
    return {std::move(paths), enclosure};
  }

 private:
  struct Neighbour {
    const Word* word;
    Complex<Mp1024> place;  ///< γ0 for its element γ.
    Isometry<Mp1024> back;  ///< γ⁻¹.
  };

  /// Returns the path as seen from a neighbour: first to the neighbour, then along the path.
  [[nodiscard]] Path moved(const Path& path, const Neighbour& neighbour) const {
    const Complex<Mp1024> end = neighbour.back(path.end);
    return {concatenated(surface_, *neighbour.word, path.word), end, distance(Complex<Mp1024>{}, end)};
  }

  [[nodiscard]] Path descended(Path path) const {
    constexpr int kMostSteps = 1'000'000;
    for (int step = 0; step < kMostSteps; ++step) {
      const Neighbour* best = nullptr;
      Mp1024 least = (1 - ldexp(Mp1024(1), -kEqualBits)) * sinh2_half_distance(Complex<Mp1024>{}, path.end);
      for (const Neighbour& neighbour : neighbours_) {
        const Mp1024 own = sinh2_half_distance(neighbour.place, path.end);
        if (own >= least) continue;
        least = own;
        best = &neighbour;
      }
      if (best == nullptr) return path;
      path = moved(path, *best);
    }
    throw NetError("no shortest path was found within " + std::to_string(kMostSteps) + " steps");
  }

  /// Returns the smallest binary64 interval that contains a length and its error.
  [[nodiscard]] static certify::Interval enclosing(const Mp1024& length) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Mp1024 error = ldexp(Mp1024(length > 1 ? length : Mp1024(1)), -kEqualBits);
    if (length < ldexp(error, 60)) return {0, static_cast<double>(ldexp(error, 61))};
    // The error is far below a unit in the last place.
    certify::Interval result{static_cast<double>(length), static_cast<double>(length)};
    while (result.lower > length - error) result.lower = std::nextafter(result.lower, 0.0);
    while (result.upper < length + error) result.upper = std::nextafter(result.upper, kInfinity);
    return result;
  }

  [[nodiscard]] static bool same_end(const Path& a, const Path& b) {
    return sinh2_half_distance(a.end, b.end) < ldexp(Mp1024(1), -kEqualBits);
  }

  const Surface& surface_;
  Isometry<Mp1024> from_tile_;
  std::vector<Neighbour> neighbours_;
};

}  // namespace

BasePoint point_of_vertex(const Surface& surface, const certify::NetDocument& net, std::uint32_t vertex) {
  const std::string name = "vertex " + std::to_string(vertex);
  if (vertex >= net.vertices.size()) {
    throw NetError(name + " does not exist, the net has " + std::to_string(net.vertices.size()));
  }
  const auto& [x, y, c] = net.vertices[vertex];
  const certify::NetDocument::Chart& chart = net.charts[c];
  return in_its_tile(surface, {TileId(chart.tile),
                               Isometry<Rational>::translation(from_gmp(chart.centre))({Rational(x), Rational(y)})});
}

BasePoint point_of_triangle(const Surface& surface, const certify::NetDocument& net, std::uint32_t triangle,
                            const std::array<Rational, 3>& weights) {
  const std::string name = "the point of triangle " + std::to_string(triangle);
  if (triangle >= net.triangles.size()) {
    throw NetError("triangle " + std::to_string(triangle) + " does not exist, the net has " +
                   std::to_string(net.triangles.size()));
  }
  if (*std::min_element(weights.begin(), weights.end()) < 0) throw NetError(name + " has a negative weight");
  const auto zeros = std::count(weights.begin(), weights.end(), 0);
  if (zeros == 3) throw NetError(name + " has no weight but 0");
  const NetGeometry geometry(net);
  LorentzVector<Mp256> sum;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t v = net.triangles[triangle].vertex[i];
    if (zeros == 2 && weights[i] != 0) return point_of_vertex(surface, net, v);
    const Isometry<Mp256>& label = geometry.label(certify::corner_label(net, 3 * triangle + i)).precise;
    const Complex<Mp256> corner = label({Mp256(net.vertices[v].x), Mp256(net.vertices[v].y)});
    sum = sum + Mp256(weights[i]) * on_hyperboloid(corner);
  }
  const certify::NetDocument::Chart& chart = net.charts[certify::chart_of_triangle(net, triangle)];
  const Mp256 length = sqrt(Mp256(-lorentz_product(sum, sum)));
  const Complex<Mp256> z = Isometry<Mp256>::translation(rounded<Mp256>(chart.centre))(
      in_disk(LorentzVector<Mp256>(Mp256(1 / length) * sum)));
  const auto to_rational = [](const Mp256& x) {
    constexpr int kBits = 100;
    mpq_class result;
    mpfr_get_z(result.get_num().get_mpz_t(), Mp256(ldexp(x, kBits)).backend().data(), MPFR_RNDN);
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), kBits);
    return from_gmp(result);
  };
  return in_its_tile(surface, {TileId(chart.tile), {to_rational(z.x), to_rational(z.y)}});
}

certify::DistanceDocument unproved::distance(const Surface& surface, const BasePoint& p, const BasePoint& q,
                                             const DistanceOptions& options) {
  require_on_surface(surface, p);
  require_on_surface(surface, q);
  return unproved::distance(surface, p, dirichlet_polygon(surface, p), q, options);
}

certify::DistanceDocument unproved::distance(const Surface& surface, const BasePoint& p,
                                             const DirichletPolygon& domain_of_p, const BasePoint& q,
                                             const DistanceOptions& options) {
  require_on_surface(surface, q);
  const bool same = is_same_point(surface, p, q);
  const BasePoint& end = same ? p : q;  // In the same coordinates it can be seen.
  auto [paths, enclosure] = LiftsOfPoint(surface, p, domain_of_p).shortest(p.tile, end);
  certify::DistanceDocument result;
  result.net = domain_of_p.triangulation;
  result.point = {end.tile.number(), to_gmp(end.z)};
  result.distance = same ? certify::Interval{0, 0} : enclosure;
  result.equal = paths.back().length - paths.front().length <= ldexp(Mp1024(1), -kEqualBits);
  for (const LiftsOfPoint::Path& path : paths) result.paths.push_back(letters_of(path.word));
  if (result.distance.upper - result.distance.lower > options.width) {
    throw NetError("binary64 encloses the distance in " + to_string(result.distance) + ", which is wider than " +
                   certify::decimal_below(options.width));
  }
  return result;
}

Certified<certify::DistanceDocument> distance(const Surface& surface, const BasePoint& p, const BasePoint& q,
                                              const DistanceOptions& options) {
  return proved(unproved::distance(surface, p, q, options));
}

Certified<certify::DistanceDocument> distance(const Surface& surface, const BasePoint& p,
                                              const DirichletPolygon& domain_of_p, const BasePoint& q,
                                              const DistanceOptions& options) {
  return proved(unproved::distance(surface, p, domain_of_p, q, options));
}

namespace {

void append_number(std::string& bytes, double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>((bits >> (8 * i)) & 0xff);
}

}  // namespace

void write_npy(const DistanceTable& table, TableEntries entries, std::ostream& out) {
  const bool bounds = entries == TableEntries::bounds;
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(table.from.size()) +
                       ", " + std::to_string(table.to.size()) + (bounds ? ", 2" : "") + "), }";
  // Magic, version and length are 10 bytes; all of it, with a line end, is a multiple of 64.
  constexpr std::size_t kBefore = 10;
  constexpr std::size_t kAlignment = 64;
  header.append((kAlignment - (kBefore + header.size() + 1) % kAlignment) % kAlignment, ' ');
  header += '\n';
  out << "\x93NUMPY" << '\x01' << '\x00' << static_cast<char>(header.size() & 0xff)
      << static_cast<char>(header.size() >> 8) << header;
  std::string row;
  for (std::size_t i = 0; i < table.from.size(); ++i) {
    row.clear();
    for (std::size_t k = 0; k < table.to.size(); ++k) {
      if (bounds) {
        append_number(row, table.enclosure(i, k).lower);
        append_number(row, table.enclosure(i, k).upper);
      } else {
        append_number(row, table.distance(i, k));
      }
    }
    out << row;
  }
}

void write_csv(const DistanceTable& table, TableEntries entries, std::ostream& out) {
  const bool bounds = entries == TableEntries::bounds;
  out << (bounds ? "from,to,lower,upper\n" : "from,to,distance\n");
  for (std::size_t i = 0; i < table.from.size(); ++i) {
    for (std::size_t k = 0; k < table.to.size(); ++k) {
      out << table.from[i] << ',' << table.to[k] << ',';
      if (bounds) {
        out << certify::decimal_below(table.enclosure(i, k).lower) << ','
            << certify::decimal_above(table.enclosure(i, k).upper);
      } else {
        out << certify::shortest(table.distance(i, k));
      }
      out << '\n';
    }
  }
}

}  // namespace epsnet
