#include "netgen/distances/distances.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/atlas.h"
#include "triangulation/surface/surface.h"

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

// Loops at a point, points along geodesics, fixed points of isometries: what elements of the group do with points.

namespace {

using DiskPoint = Complex<Mp1024>;
using Move = Isometry<Mp1024>;

constexpr std::size_t kMostDomainElements = 200'000;

/// An element of the group, in the frame of a Dirichlet domain.
struct Element {
  Move move;
  std::vector<std::uint32_t> sides;  ///< The element is the product of their pairings.
  double length;                     ///< How far it moves the base point.
};

/// Where an element takes the base point, to 2^-30: no two elements take it to points so near to each other.
using ImageKey = std::array<double, 2>;

ImageKey key_of(const Move& move) {
  // Coordinates of the hyperboloid, which the plane stretches everywhere. The constant keeps 0 away from a jump.
  const LorentzVector<Mp1024> image = on_hyperboloid(move(DiskPoint{}));
  const auto cell = [](const Mp1024& x) { return std::floor(std::ldexp(x.convert_to<double>(), 30) + 0.37); };
  return {cell(image.x), cell(image.y)};
}

/// The elements that move the base point by at most `up_to`, the identity first. They are connected by side pairings: a
/// geodesic from the base point to its image passes through images of the domain whose base points are nearer.
std::vector<Element> elements_up_to(const DomainFrame& frame, double up_to) {
  const double limit = up_to + 1e-9;  // Ways through corners of domains.
  std::vector<Element> elements{{Move{}, {}, 0}};
  std::set<ImageKey> found{key_of(Move{})};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::uint32_t side = 0; side < frame.pairings().size(); ++side) {
      Element next{normalized(elements[i].move * frame.pairings()[side]), {}, 0};
      next.length = distance(DiskPoint{}, next.move(DiskPoint{})).convert_to<double>();
      if (next.length > limit || !found.insert(key_of(next.move)).second) continue;
      if (elements.size() == kMostDomainElements) {
        throw LimitError("more than " + std::to_string(kMostDomainElements) +
                         " elements of the group move the point by " + std::to_string(up_to) + " or less");
      }
      next.sides = elements[i].sides;
      next.sides.push_back(side);
      elements.push_back(std::move(next));
    }
  }
  return elements;
}

/// The path of a product of side pairings: that of the last factor comes first.
Word word_of(const DirichletPolygon& polygon, const std::vector<std::uint32_t>& sides) {
  Word word;
  for (auto side = sides.rbegin(); side != sides.rend(); ++side) {
    const Word& part = polygon.sides[*side].word;
    word.insert(word.end(), part.begin(), part.end());
  }
  return word;
}

/// The image of a point in the domain, and the element that takes it there, after `move`.
void reduce(const DomainFrame& frame, Move& move, DiskPoint& z) {
  const auto way = frame.walk(z);
  if (!way) throw LimitError("a point is too far from the Dirichlet domain");
  for (const std::uint32_t side : *way) {
    const Move back = inverse(frame.pairings()[side]);
    z = back(z);
    move = normalized(back * move);
  }
}

/// The square root of a complex number of modulus 1, up to the sign.
DiskPoint root_of_unit(const DiskPoint& u) {
  const DiskPoint sum = DiskPoint{Mp1024(1), Mp1024(0)} + u;
  const Mp1024 size = sqrt(norm(sum));
  if (size < Mp1024(1e-100)) return {Mp1024(0), Mp1024(1)};
  return Mp1024(1 / size) * sum;
}

/// The isometry that takes three points of the unit circle to three others in the same cyclic order.
Move from_circle_points(const std::array<DiskPoint, 3>& from, const std::array<DiskPoint, 3>& to) {
  // As matrices (p q; r s): z -> (z - z0)(z1 - z2)/((z - z2)(z1 - z0)), the second one inverted.
  const auto matrix = [](const std::array<DiskPoint, 3>& z) {
    const DiskPoint u = z[1] - z[2];
    const DiskPoint v = z[1] - z[0];
    return std::array<DiskPoint, 4>{u, -(u * z[0]), v, -(v * z[2])};
  };
  const auto m = matrix(from);
  const auto n = matrix(to);
  const DiskPoint p = n[3] * m[0] - n[1] * m[2];
  const DiskPoint q = n[3] * m[1] - n[1] * m[3];
  const DiskPoint s = n[0] * m[3] - n[2] * m[1];
  const DiskPoint c = q / p;
  DiskPoint turn = p / s;
  turn = Mp1024(1 / sqrt(norm(turn))) * turn;
  const DiskPoint a = root_of_unit(turn);
  return normalized(Move{a, a * c});
}

/// A lift of the isometry f with fwf^-1 = image for all words: elements have the ends of their axes on the circle.
Move lift_of(const Surface& surface, const std::vector<Word>& words, const std::vector<Word>& images) {
  std::array<DiskPoint, 3> from;
  std::array<DiskPoint, 3> to;
  std::size_t known = 0;
  for (std::size_t i = 0; i < words.size() && known < 3; ++i) {
    const auto before = axis(isometry_of(surface, words[i]));
    const auto after = axis(isometry_of(surface, images[i]));
    if (!before || !after) throw LimitError("the generators are too large to follow the isometry");
    const auto is_end = [&](const DiskPoint& z) { return norm(before->to - z) < Mp1024(1e-60); };
    if (known == 2 && (is_end(from[0]) || is_end(from[1]))) continue;  // The same axis: the group is discrete.
    if (known == 0) {
      from = {before->from, before->to, {}};
      to = {after->from, after->to, {}};
      known = 2;
    } else {
      from[2] = before->to;
      to[2] = after->to;
      known = 3;
    }
  }
  if (known < 3) throw LimitError("the generators have one axis");
  return from_circle_points(from, to);
}

/// The point that an isometry fixes, if it turns the plane around one.
std::optional<DiskPoint> centre_of(const Move& f) {
  const Mp1024 square = 1 - f.a.x * f.a.x;
  if (!(square > Mp1024(1e-60))) return std::nullopt;
  const Mp1024 root = sqrt(square);
  const Mp1024 below = f.a.y < 0 ? Mp1024(f.a.y - root) : Mp1024(f.a.y + root);
  return DiskPoint{Mp1024(-f.b.y / below), Mp1024(f.b.x / below)};
}

}  // namespace

std::vector<PointLoop> loops_at(const Surface& surface, const BasePoint& point, double up_to) {
  require_inside(surface, point);
  const DirichletPolygon polygon = dirichlet_polygon(surface, point);
  const DomainFrame frame(surface, polygon);
  std::vector<PointLoop> loops;
  for (const Element& element : elements_up_to(frame, up_to)) {
    if (element.sides.empty() || element.length > up_to) continue;
    // A loop and the same backwards are one.
    if (key_of(inverse(element.move)) < key_of(element.move)) continue;
    loops.push_back({word_of(polygon, element.sides), element.length});
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const PointLoop& a, const PointLoop& b) { return a.length < b.length; });
  return loops;
}

BasePoint point_along(const Surface& surface, const BasePoint& from, double direction, double length) {
  const Mp1024 angle(direction);
  const Mp1024 radius = tanh(Mp1024(length) / 2);
  const DiskPoint z{Mp1024(radius * cos(angle)), Mp1024(radius * sin(angle))};
  return rounded_point(surface, from.tile, Move::translation(convert<Mp1024>(from.z))(z));
}

std::vector<BasePoint> fixed_points(const Surface& surface, const std::vector<Word>& words,
                                    const std::vector<Word>& images) {
  const DirichletPolygon polygon = dirichlet_polygon(surface, centre_of_tile(surface, TileId(0)));
  const DomainFrame frame(surface, polygon);
  Move lift = normalized(frame.from_tile() * lift_of(surface, words, images) * inverse(frame.from_tile()));
  DiskPoint image = lift(DiskPoint{});
  reduce(frame, lift, image);
  Mp1024 radius(0);
  for (const DiskPoint& vertex : frame.vertices()) radius = std::max(radius, distance(DiskPoint{}, vertex));
  // A fixed point in the domain is at most `radius` from the base point and from its image.
  const double most = 2 * radius.convert_to<double>() + distance(DiskPoint{}, image).convert_to<double>();
  const std::vector<Element> elements = elements_up_to(frame, most);
  std::vector<Isometry<double>> rounded;
  for (const Element& element : elements) {
    if (element.length <= 2 * radius + 1e-6) rounded.push_back(convert<double>(element.move));
  }
  std::vector<DiskPoint> found;
  for (const Element& element : elements) {
    const auto centre = centre_of(normalized(element.move * lift));
    if (!centre || distance(DiskPoint{}, *centre) > radius + 1e-6 || frame.side_towards(Mp1024(1 - 1e-12) * *centre))
      continue;
    const auto z = convert<double>(*centre);
    const bool is_known = std::any_of(found.begin(), found.end(), [&](const DiskPoint& other) {
      const auto w = convert<double>(other);
      return std::any_of(rounded.begin(), rounded.end(),
                         [&](const Isometry<double>& g) { return distance(g(w), z) < 1e-5; });
    });
    if (!is_known) found.push_back(*centre);
  }
  std::vector<BasePoint> points;
  points.reserve(found.size());
  for (const DiskPoint& z : found)
    points.push_back(rounded_point(surface, frame.tile(), inverse(frame.from_tile())(z)));
  return points;
}

}  // namespace epsnet
