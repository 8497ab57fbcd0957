#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <map>
#include <optional>
#include <queue>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pictures/curves.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg.h"
#include "netgen/surfaces/surfaces.h"

/// The pictures of pictures.h that show a polygon: what is in them; and the Dirichlet domain of curves.h.
namespace epsnet {
namespace {

using Point = Complex<Mp1024>;
using Segment = PolygonPicture::Segment;

Complex<double> rounded_to_double(const Point& z) { return convert<double>(z); }

Segment segment(const Point& from, const Point& to) { return {rounded_to_double(from), rounded_to_double(to)}; }

/// The vertex of a net, exactly, in the tile of its chart.
BasePoint first_vertex(const certify::NetDocument& net) {
  const certify::NetDocument::Vertex& vertex = net.vertices[0];
  const certify::NetDocument::Chart& chart = net.charts[vertex.chart];
  return {TileId(chart.tile),
          Isometry<Rational>::translation(from_gmp(chart.centre))({Rational(vertex.x), Rational(vertex.y)})};
}

void add_base(PolygonPicture& picture, const std::string& name, const std::string& label = "p") {
  picture.marks.push_back({name, label, palette::kCentre, {Complex<double>{0, 0}}});
}

/// A domain around a point, with the numbers to draw in it.
struct Domain {
  const Surface& surface;
  DirichletPolygon polygon;
  DomainFrame frame;

  Domain(const Surface& of, const std::optional<BasePoint>& base)
      : surface(of), polygon(dirichlet_polygon(surface, base)), frame(surface, polygon) {}
};

/// The picture of a domain with what `add` adds to it. If it cannot be made, the picture says why.
template <class Add>
PolygonPicture in_domain(const Surface& surface, const std::optional<BasePoint>& base, const std::string& title,
                         const Add& add) {
  constexpr std::uint32_t kMostGenus = 100;
  PolygonPicture result;
  try {
    if (surface.genus() > kMostGenus) {
      throw NetError("drawn up to genus " + std::to_string(kMostGenus) + ", not " + std::to_string(surface.genus()));
    }
    const Domain domain(surface, base);
    result = picture_of(domain.polygon);
    result.marks.clear();
    add(result, domain);
  } catch (const SurfaceError&) {
    throw;
  } catch (const Error& error) {
    result.left_out.push_back(std::string("the Dirichlet domain: ") + error.what());
  }
  result.title = title;
  return result;
}

/// The points that are farthest from the base, as q, and the segments to them.
void add_farthest(PolygonPicture& picture, const Domain& domain) {
  PolygonPicture::Mark ends{"a point farthest from p", "q", palette::kDirichlet, {}};
  PolygonPicture::Curve segments{"a shortest path from p to q", palette::kPaths, {}};
  for (const std::uint32_t k : domain.frame.farthest_vertices()) {
    const Point& z = domain.frame.vertices()[k];
    ends.places.push_back(rounded_to_double(z));
    segments.segments.push_back(segment({}, z));
  }
  if (ends.places.size() > 1) ends.name = std::to_string(ends.places.size()) + " points farthest from p";
  if (ends.places.size() > 1) segments.name = "shortest paths from p to them";
  picture.curves.push_back(std::move(segments));
  picture.marks.push_back(std::move(ends));
}

/// An oriented geodesic of the plane, and a point on it.
struct Axis {
  Isometry<Mp1024> element;
  Point place;
  Point to;  ///< On the unit circle.
};

/// The axis of an element, from its point nearest to 0; nullopt if 1024 bits do not tell that there is one.
std::optional<Axis> axis_of(const Isometry<Mp1024>& element) {
  const auto ends = axis(element);
  if (!ends) return std::nullopt;
  // In Klein coordinates it is a chord of the unit circle.
  return Axis{element, from_klein(Mp1024(0.5) * (ends->from + ends->to)), ends->to};
}

Axis moved(const Isometry<Mp1024>& by, const Axis& line) {
  const Point to = by(line.to);
  return {normalized(by * line.element * inverse(by)), by(line.place), Mp1024(1 / sqrt(norm(to))) * to};
}

/// The segments of a closed geodesic in a domain, one period from the place of a lift; nullopt if they are too many.
std::optional<std::vector<Segment>> traced(const DomainFrame& frame, Axis line) {
  constexpr std::size_t kMostSegments = 1000;
  const auto crossed = frame.walk(line.place);
  if (!crossed) return std::nullopt;
  for (const std::uint32_t side : *crossed) line = moved(inverse(frame.pairings()[side]), line);
  Mp1024 rest = displacement_length(line.element);
  const Mp1024 tiny = ldexp(Mp1024(1), -80);
  std::vector<Segment> result;
  while (rest > tiny && result.size() < kMostSegments) {
    // ⟨X, γ0⟩ = ⟨X, 0⟩ on the line of a side: a line in Klein coordinates, too.
    const Point from = to_klein(line.place);
    const Point direction = line.to - from;
    Mp1024 share(1);
    std::optional<std::uint32_t> exit;
    for (std::uint32_t k = 0; k < frame.pairings().size(); ++k) {
      const LorentzVector<Mp1024> image = on_hyperboloid(frame.pairings()[k](Point{}));
      const Point normal{image.x, image.y};
      const Mp1024 slope = dot(direction, normal);
      if (!(slope > 0)) continue;
      const Mp1024 at = std::max(Mp1024(0), Mp1024((image.t - 1 - dot(from, normal)) / slope));
      if (at >= share) continue;
      share = at;
      exit = k;
    }
    if (!exit) return std::nullopt;
    Point end = from_klein(from + share * direction);
    const Mp1024 length = distance(line.place, end);
    if (length >= rest - tiny) {
      const auto here = Isometry<Mp1024>::translation(line.place);
      const Point way = inverse(here)(end);
      const Mp1024 size = sqrt(norm(way));
      if (size > 0) end = here(Mp1024(tanh(rest / 2) / size) * way);
      result.push_back(segment(line.place, end));
      return result;
    }
    if (length > tiny) result.push_back(segment(line.place, end));
    rest -= length;
    line.place = end;
    line = moved(inverse(frame.pairings()[*exit]), line);
  }
  return rest > tiny ? std::nullopt : std::optional(result);
}

TileId tile_of(const certify::GeodesicsDocument& document, const certify::GeodesicsDocument::ClosedGeodesic& geodesic) {
  return TileId(document.net.charts[document.net.vertices[geodesic.vertex].chart].tile);
}

/// A point of the first geodesic that is not so short that the domain of its points is but a line; the centre of a tile
/// if there is none.
BasePoint point_of_first(const Surface& surface, const certify::GeodesicsDocument& document) {
  constexpr double kShort = 0.2;
  for (const auto& geodesic : document.geodesics) {
    if (geodesic.length.lower < kShort) continue;
    if (const auto line = axis_of(isometry_of(surface, word_of_letters(geodesic.word))))
      return rounded_point(surface, tile_of(document, geodesic), line->place);
  }
  return centre_of_tile(surface, TileId(0));
}

/// The segments in a domain of the closed geodesic of a path that begins in a tile; nullopt if they are too many.
std::optional<std::vector<Segment>> segments_of(const Domain& domain, TileId tile, const Word& word) {
  const Isometry<Mp1024> way =
      domain.frame.from_tile() *
      inverse(isometry_of(domain.surface, path_between_tiles(domain.surface, domain.frame.tile(), tile)));
  const auto line = axis_of(normalized(way * isometry_of(domain.surface, word) * inverse(way)));
  return line ? traced(domain.frame, *line) : std::nullopt;
}

// Colours of curves, one after the other.
constexpr std::array<const char*, 6> kColours{palette::kGeodesics,      palette::kPaths,        palette::kCoveringDisks,
                                              palette::kEpsilonCollars, palette::kPackingDisks, palette::kEdges};

/// A length for a legend.
std::string length_text(double length) {
  if (length >= 0.001) return fixed(length, 4);
  std::ostringstream out;
  out << std::setprecision(3) << length;
  return out.str();
}

/// A path around a cuff of a pants file.
Word word_of_cuff(const certify::PantsDocument& document, const certify::PantsDocument::Cuff& cuff) {
  const auto [pants, number] = cuff.ends[0];
  const certify::PantsDocument::Paths& paths = document.pants[pants];
  Word word = word_of_letters(paths[number == 1 ? 1 : 0]);
  if (number == 2) {
    const Word second = word_of_letters(paths[1]);
    word.insert(word.end(), second.begin(), second.end());
  }
  return word;
}

/// A closed curve with what a legend says of it.
struct NamedCurve {
  std::string name;
  Word word;
};

/// The closed geodesics of curves, which are `kind` together.
void add_named_curves(PolygonPicture& result, const Domain& domain, const std::vector<NamedCurve>& curves,
                      const std::string& kind) {
  constexpr std::size_t kMost = 200;
  // With one colour for each, as long as a legend can list them.
  const bool is_each_named = curves.size() <= kColours.size();
  for (std::size_t i = 0; i < std::min(curves.size(), kMost); ++i) {
    const auto& [name, word] = curves[i];
    if (is_each_named || i == 0) {
      result.curves.push_back(
          {is_each_named ? name : std::to_string(curves.size()) + ' ' + kind, kColours[is_each_named ? i : 0], {}});
    }
    const auto segments = segments_of(domain, domain.surface.tile_of_side(word.front()), word);
    if (!segments) result.left_out.push_back(name + ": it crosses the domain too often");
    if (segments)
      result.curves.back().segments.insert(result.curves.back().segments.end(), segments->begin(), segments->end());
  }
  if (curves.size() > kMost)
    result.left_out.push_back(std::to_string(curves.size() - kMost) + ' ' + kind + ": only 200 are drawn");
}

void add_cuffs(PolygonPicture& result, const Domain& domain, const certify::PantsDocument& document) {
  std::vector<NamedCurve> cuffs;
  for (const certify::PantsDocument::Cuff& cuff : document.cuffs) {
    cuffs.push_back({"cuff " + std::to_string(cuffs.size()) + ", of length " + length_text(cuff.length.upper),
                     word_of_cuff(document, cuff)});
  }
  add_named_curves(result, domain, cuffs, "cuffs");
}

/// Where two geodesic segments cross, or one ends on the other; nullopt also where both are on one line.
std::optional<Complex<double>> crossing_of(const Segment& a, const Segment& b) {
  constexpr double kTiny = 1e-9;  // Of a length in Klein coordinates; rounding is far smaller.
  const auto cross = [](const Complex<double>& u, const Complex<double>& v) { return u.x * v.y - u.y * v.x; };
  const Complex<double> from = to_klein(a[0]);
  const Complex<double> along = to_klein(a[1]) - from;
  const Complex<double> other = to_klein(b[1]) - to_klein(b[0]);
  const Complex<double> between = to_klein(b[0]) - from;
  const double area = cross(along, other);
  if (std::abs(area) < 1e-6 * std::sqrt(norm(along) * norm(other))) return std::nullopt;
  const double at = cross(between, other) / area;
  const double there = cross(between, along) / area;
  const auto is_inside = [](double share, const Complex<double>& way) {
    const double margin = kTiny / std::sqrt(norm(way));
    return share >= -margin && share <= 1 + margin;
  };
  if (!is_inside(at, along) || !is_inside(there, other)) return std::nullopt;
  return from_klein(from + at * along);
}

/// Dots where the curves of a picture cross each other or themselves.
void add_crossings(PolygonPicture& picture) {
  constexpr std::size_t kMostSegments = 4000;
  constexpr double kSame = 1e-7;
  std::vector<Segment> segments;
  for (const PolygonPicture::Curve& curve : picture.curves)
    segments.insert(segments.end(), curve.segments.begin(), curve.segments.end());
  if (segments.size() > kMostSegments) {
    picture.left_out.push_back("where they cross: more than " + std::to_string(kMostSegments) + " segments");
    return;
  }
  std::map<std::pair<std::int64_t, std::int64_t>, Complex<double>> places;  // By place, rounded.
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto z = crossing_of(segments[i], segments[j]);
      if (z) places.try_emplace({std::llround(z->x / kSame), std::llround(z->y / kSame)}, *z);
    }
  }
  PolygonPicture::Mark mark{"where they cross", "", palette::kVertices, {}, 5};
  for (const auto& [rounded, z] : places) mark.places.push_back(z);
  if (!places.empty()) picture.marks.push_back(std::move(mark));
}

/// The curves of a file without its basis, or the basis if there are no others.
void add_closed_curves(PolygonPicture& result, const Domain& domain, const certify::CurvesDocument& document) {
  std::vector<NamedCurve> curves;
  const bool is_all = document.curves.size() == document.basis.size();
  for (std::uint32_t i = 0; i < document.curves.size(); ++i) {
    if (!is_all && std::find(document.basis.begin(), document.basis.end(), i) != document.basis.end()) continue;
    const certify::CurvesDocument::Curve& curve = document.curves[i];
    curves.push_back(
        {"curve " + std::to_string(i) + ", of length " + length_text(curve.length.upper), word_of_letters(curve.word)});
  }
  add_named_curves(result, domain, curves, "closed curves");
  add_crossings(result);
}

/// What a legend says of geodesics first, …, first + count − 1.
std::string cluster_name(const certify::GeodesicsDocument& document, std::size_t first, std::size_t count) {
  const auto middle = [&](std::size_t i) {
    return (document.geodesics[i].length.lower + document.geodesics[i].length.upper) / 2;
  };
  const std::string from = length_text(middle(first));
  const std::string to = length_text(middle(first + count - 1));
  return (count == 1 ? "closed geodesic of length " : std::to_string(count) + " closed geodesics of length ") + from +
         (from == to ? "" : " to " + to);
}

/// The geodesics of a file, one curve for each cluster of lengths, the shortest in front.
void add_geodesics(PolygonPicture& result, const Domain& domain, const certify::GeodesicsDocument& document) {
  constexpr std::size_t kMost = 200;
  std::vector<std::pair<std::size_t, std::size_t>> clusters;
  if (document.clusters.empty() && !document.geodesics.empty()) clusters.emplace_back(0, document.geodesics.size());
  for (const auto& cluster : document.clusters) clusters.emplace_back(cluster.first, cluster.count);
  std::size_t drawn = 0;
  for (const auto& [first, count] : clusters) {
    PolygonPicture::Curve curve{
        cluster_name(document, first, count), kColours[std::min(result.curves.size(), kColours.size() - 1)], {}};
    if (drawn + count > kMost && drawn > 0) {
      result.left_out.push_back(std::to_string(document.geodesics.size() - drawn) + " longer closed geodesics");
      break;
    }
    drawn += count;
    std::size_t missing = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      const auto& geodesic = document.geodesics[i];
      const auto segments = segments_of(domain, tile_of(document, geodesic), word_of_letters(geodesic.word));
      missing += segments ? 0 : 1;
      if (segments) curve.segments.insert(curve.segments.end(), segments->begin(), segments->end());
    }
    if (missing > 0) {
      result.left_out.push_back(std::to_string(missing) + " of " + curve.name + ": they cross the domain too often");
    }
    result.curves.push_back(std::move(curve));
  }
  std::reverse(result.curves.begin(), result.curves.end());
}

}  // namespace

PolygonPicture picture_of(const DirichletPolygon& polygon) {
  PolygonPicture result{.title = "Dirichlet domain with " + std::to_string(polygon.sides.size()) + " sides"};
  const std::size_t n = polygon.sides.size();
  for (std::size_t k = 0; k < n; ++k) {
    result.sides.push_back(
        {{polygon.vertices[k], polygon.vertices[(k + 1) % n]}, polygon.sides[k].partner, std::to_string(k)});
  }
  add_base(result, "base point", "");
  return result;
}

namespace {

/// The tiles of a surface laid out as a tree around tile 0.
struct TileTree {
  ById<TileId, std::optional<Isometry<Mp1024>>> place;  ///< From the coordinates of a tile to those of tile 0.
  ById<TileId, std::optional<SideId>> entry;            ///< The side through which a tile is entered; none for tile 0.
};

/// Lays out the tiles, each time the one whose centre is nearest to that of tile 0.
TileTree nearest_tiles_first(const Surface& surface) {
  TileTree tree{ById<TileId, std::optional<Isometry<Mp1024>>>(surface.tiles().size()),
                ById<TileId, std::optional<SideId>>(surface.tiles().size())};
  const auto centre = [&](TileId tile) {
    return surface.is_regular() ? Point{} : convert<Mp1024>(centre_of_tile(surface, tile).z);
  };
  const Point middle = centre(TileId(0));
  // Of equal distances, up to rounding, first those that are as many steps around their tiles, which keeps symmetries.
  using Candidate = std::tuple<double, std::uint32_t, std::uint32_t, SideId>;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
  std::uint32_t found = 0;
  const auto beyond = [&](SideId side) {
    return normalized(*tree.place[surface.tile_of_side(side)] * inverse(surface.crossing_as<Mp1024>(side)));
  };
  const auto add_sides = [&](TileId tile) {
    SideId side = tree.entry[tile].value_or(surface.side_number(tile, 0));
    for (std::uint32_t steps = 0; steps < surface.tile(tile).size(); ++steps, side = surface.next_side(side)) {
      const TileId next = surface.tile_of_side(surface.partner(side));
      if (tree.place[next]) continue;
      const auto far = distance(middle, beyond(side)(centre(next))).convert_to<double>();
      candidates.emplace(std::round(far * 1e9), steps, found++, side);
    }
  };
  tree.place[TileId(0)] = Isometry<Mp1024>{};
  add_sides(TileId(0));
  while (!candidates.empty()) {
    const SideId side = std::get<SideId>(candidates.top());
    candidates.pop();
    const TileId tile = surface.tile_of_side(surface.partner(side));
    if (tree.place[tile]) continue;
    tree.place[tile] = beyond(side);
    tree.entry[tile] = surface.partner(side);
    add_sides(tile);
  }
  return tree;
}

/// The sides around the tiles of a tree, counterclockwise.
std::vector<SideId> sides_around(const Surface& surface, const TileTree& tree) {
  std::vector<SideId> around;
  std::vector<SideId> waiting;  // Those of tiles on the way, the next one last.
  const auto enter = [&](SideId first, std::size_t count) {
    std::vector<SideId> sides;
    for (SideId side = first; sides.size() < count; side = surface.next_side(side)) sides.push_back(side);
    waiting.insert(waiting.end(), sides.rbegin(), sides.rend());
  };
  enter(surface.side_number(TileId(0), 0), surface.tile(TileId(0)).size());
  while (!waiting.empty()) {
    const SideId side = waiting.back();
    waiting.pop_back();
    const SideId partner = surface.partner(side);
    const TileId tile = surface.tile_of_side(partner);
    if (tree.entry[tile] == partner) {
      enter(surface.next_side(partner), surface.tile(tile).size() - 1);
    } else {
      around.push_back(side);
    }
  }
  return around;
}

}  // namespace

PolygonPicture picture_of(const Surface& surface) {
  const TileTree tree = nearest_tiles_first(surface);
  PolygonPicture result{.title = "surface of genus " + std::to_string(surface.genus()) + ", " +
                                 std::to_string(surface.tiles().size()) +
                                 (surface.tiles().size() == 1 ? " tile" : " tiles")};
  const auto ends_of = [&](SideId side) {
    const TileId tile = surface.tile_of_side(side);
    const Tile& corners = surface.tile(tile);
    const std::uint32_t k = surface.place_in_tile(side);
    const auto corner = [&](std::uint32_t i) {
      return (*tree.place[tile])(convert<Mp1024>(corners[i % corners.size()]));
    };
    return std::pair(corner(k), corner(k + 1));
  };
  // Sides that are glued where they lie are inside; so are those through which tiles were entered.
  const auto lies_on = [&](SideId side, SideId other) {
    if (surface.partner(side) != other) return false;
    const auto here = ends_of(side);
    const auto there = ends_of(other);
    return distance(here.first, there.second) < Mp1024(1e-9) && distance(here.second, there.first) < Mp1024(1e-9);
  };
  std::vector<SideId> inner;
  std::vector<SideId> rim;
  for (const SideId side : sides_around(surface, tree)) {
    if (rim.empty() || !lies_on(rim.back(), side)) {
      rim.push_back(side);
    } else {
      inner.push_back(side);
      rim.pop_back();
    }
  }
  std::size_t first = 0;
  for (; rim.size() > 2 && lies_on(rim[first], rim.back()); ++first) {
    inner.push_back(rim.back());
    rim.pop_back();
  }
  rim.erase(rim.begin(), rim.begin() + static_cast<std::ptrdiff_t>(first));
  for (const TileId tile : surface.tile_ids()) {
    if (tree.entry[tile]) inner.push_back(*tree.entry[tile]);
  }
  // The centre of a regular tile stays in the centre; of other tiles the middle of the corners goes there.
  Isometry<Mp1024> to_centre;
  if (!surface.is_regular()) {
    LorentzVector<Mp1024> sum;
    for (const SideId side : rim) sum = sum + on_hyperboloid(ends_of(side).first);
    const Point middle = in_disk(Mp1024(1 / sqrt(Mp1024(-lorentz_product(sum, sum)))) * sum);
    to_centre = Isometry<Mp1024>::translation(-middle);
  }
  ById<SideId, std::uint32_t> number(surface.side_count());
  for (std::uint32_t k = 0; k < rim.size(); ++k) number[rim[k]] = k;
  const auto drawn = [&](SideId side) {
    const auto [from, to] = ends_of(side);
    return segment(to_centre(from), to_centre(to));
  };
  for (const SideId side : rim) result.sides.push_back({drawn(side), number[surface.partner(side)], to_string(side)});
  for (const SideId side : inner) result.inner.push_back(drawn(side));
  return result;
}

PolygonPicture picture_of(const certify::DistanceDocument& distance) {
  const Surface surface = from_document(distance.net.surface);
  const auto add = [&](PolygonPicture& result, const Domain& domain) {
    PolygonPicture::Mark end{"q", "q", palette::kDirichlet, {}};
    PolygonPicture::Curve paths{"shortest path, of length " + fixed(distance.distance.upper, 4), palette::kPaths, {}};
    if (distance.paths.size() > 1) {
      paths.name =
          std::to_string(distance.paths.size()) + " shortest paths, of length " + fixed(distance.distance.upper, 4);
    }
    const Point q = convert<Mp1024>(from_gmp(distance.point.z));
    for (const std::vector<std::uint32_t>& letters : distance.paths) {
      const Point lift = domain.frame.from_tile()(inverse(isometry_of(domain.surface, word_of_letters(letters)))(q));
      end.places.push_back(rounded_to_double(lift));
      paths.segments.push_back(segment({}, lift));
    }
    result.curves.push_back(std::move(paths));
    add_base(result, "p");
    result.marks.push_back(std::move(end));
  };
  return in_domain(surface, first_vertex(distance.net), "shortest paths between two points", add);
}

PolygonPicture picture_of(const certify::GeodesicsDocument& geodesics) {
  const Surface surface = from_document(geodesics.net.surface);
  const auto add = [&](PolygonPicture& result, const Domain& domain) { add_geodesics(result, domain, geodesics); };
  return in_domain(surface, point_of_first(surface, geodesics), "closed geodesics", add);
}

PolygonPicture picture_of(const certify::PantsDocument& pants) {
  const auto add = [&](PolygonPicture& result, const Domain& domain) { add_cuffs(result, domain, pants); };
  return in_domain(from_document(pants.net.surface), std::nullopt, "pants decomposition", add);
}

PolygonPicture picture_of(const certify::CurvesDocument& curves) {
  const auto add = [&](PolygonPicture& result, const Domain& domain) { add_closed_curves(result, domain, curves); };
  return in_domain(from_document(curves.net.surface), std::nullopt, "closed curves", add);
}

PolygonPicture picture_of(const certify::BoundDocument& bound) {
  using Claim = certify::BoundDocument::Claim;
  const Surface surface = from_document(bound.net.surface);
  if (bound.claim == Claim::diameter) {
    return in_domain(surface, first_vertex(bound.net), "where the diameter is attained",
                     [](PolygonPicture& result, const Domain& domain) {
                       add_farthest(result, domain);
                       add_base(result, "p, one end of the diameter");
                     });
  }
  const bool radius = bound.claim == Claim::radius;
  const double size = radius ? bound.value.upper : bound.value.lower;
  const auto add = [&](PolygonPicture& result, const Domain& domain) {
    result.disks.push_back(
        {(radius ? "the disk that covers the surface, of radius " : "the embedded disk, of radius ") + fixed(size, 4),
         radius ? palette::kCoveringDisks : palette::kPackingDisks, size});
    if (radius) add_farthest(result, domain);
    add_base(result, radius ? "p, the centre of a smallest disk" : "p, the centre of a largest disk");
  };
  return in_domain(surface, first_vertex(bound.net),
                   radius ? "where the radius is attained" : "a largest embedded disk", add);
}

PolygonPicture picture_of_eccentricity(const certify::NetDocument& net) {
  return in_domain(from_document(net.surface), first_vertex(net), "where the eccentricity is attained",
                   [](PolygonPicture& result, const Domain& domain) {
                     add_farthest(result, domain);
                     add_base(result, "p");
                   });
}

namespace {

using Point = Complex<Mp1024>;

/// Returns the surface with the same tiles in the same coordinates, renumbered so that the given corner is corner 0 of
/// tile 0. Its point is then the first vertex of the surface.
certify::SurfaceDocument with_first_corner(certify::SurfaceDocument surface, std::uint32_t tile, std::uint32_t corner) {
  std::swap(surface.tiles[0], surface.tiles[tile]);
  certify::SurfaceDocument::Tile& first = surface.tiles[0];
  const auto size = static_cast<std::uint32_t>(first.size());
  std::rotate(first.begin(), first.begin() + corner, first.end());
  const auto renumber = [&](std::uint32_t& t, std::uint32_t& side) {
    t = t == tile ? 0 : t == 0 ? tile : t;
    if (t == 0) side = (side + size - corner) % size;
  };
  for (certify::SurfaceDocument::Gluing& g : surface.gluing) {
    renumber(g.tile, g.side);
    renumber(g.other_tile, g.other_side);
  }
  return surface;
}

/// Returns the corner of a chart's tile that is the chart's centre, if there is one.
std::optional<std::uint32_t> corner_at(const certify::SurfaceDocument& surface,
                                       const certify::NetDocument::Chart& chart) {
  if (surface.tiles.empty()) return std::nullopt;
  const certify::SurfaceDocument::Tile& tile = surface.tiles[chart.tile];
  const auto found = std::find(tile.begin(), tile.end(), chart.centre);
  if (found == tile.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - tile.begin());
}

/// A point of the surface in the tile that contains it.
struct TilePoint {
  std::uint32_t tile;
  Point z;
  Isometry<Mp1024> from_chart;  ///< From the coordinates of the chart in which the point was given to the tile's.
};

/// Tiles in the Klein model, and the crossings between them.
class Tiles {
 public:
  explicit Tiles(const NetGeometry& geometry)
      : sides_(geometry.sides()), parts_(geometry.document(), geometry.sides()) {
    const certify::SurfaceDocument surface = with_rounded_tiles(geometry.document().surface);
    for (const certify::SurfaceDocument::Tile& tile : surface.tiles) {
      std::vector<Point>& corners = corners_.emplace_back();
      for (const certify::RationalPoint& z : tile) corners.push_back(to_klein(rounded<Mp1024>(z)));
    }
  }

  /// Finds the tile of a point of a chart along the straight line from the middle of the chart's tile.
  [[nodiscard]] TilePoint locate(std::uint32_t chart, std::uint32_t tile, const Point& z) const {
    Isometry<Mp1024> g = parts_.frames[chart];
    Point start = from_klein(middle(tile));
    Point target = g(z);
    constexpr int kMostSteps = 1'000'000;
    for (int steps = 0; steps < kMostSteps; ++steps) {
      const std::optional<std::uint32_t> exit = exit_side(tile, to_klein(start), to_klein(target));
      if (!exit) return {tile, target, g};
      const std::uint32_t side = sides_.first[tile] + *exit;
      const Isometry<Mp1024>& crossing = parts_.crossings[side];
      g = normalized(crossing * g);
      start = crossing(start);
      target = crossing(target);
      tile = sides_.tile[sides_.partner[side]];
    }
    throw NetGeometryError("no tile contains the centre of the Dirichlet domain");
  }

  /// Returns the point itself if it is inside the tile, otherwise a point beside it that is.
  [[nodiscard]] Point inside(const TilePoint& point) const {
    const std::vector<Point>& corners = corners_[point.tile];
    const Point k = to_klein(point.z);
    const Mp1024 tiny = ldexp(Mp1024(1), -200);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point& u = corners[i];
      if (cross(corners[(i + 1) % corners.size()] - u, k - u) > tiny) continue;
      const Mp1024 share = ldexp(Mp1024(1), -60);
      return from_klein(k + share * (middle(point.tile) - k));
    }
    return point.z;
  }

 private:
  [[nodiscard]] Point middle(std::uint32_t tile) const {
    Point sum{};
    for (const Point& k : corners_[tile]) sum = sum + k;
    return Mp1024(1 / Mp1024(corners_[tile].size())) * sum;
  }

  /// Returns the side through which a segment leaves a tile; nullopt if it ends in the tile (Klein model). The segment
  /// starts inside the tile or beyond one of its sides.
  [[nodiscard]] std::optional<std::uint32_t> exit_side(std::uint32_t tile, const Point& from, const Point& to) const {
    static const Mp1024 kTiny = ldexp(Mp1024(1), -300);
    const Point direction = to - from;
    Mp1024 exit_at = 1 - kTiny;
    std::optional<std::uint32_t> exit;
    const std::vector<Point>& corners = corners_[tile];
    for (std::uint32_t side = 0; side < corners.size(); ++side) {
      const Point& u = corners[side];
      const Point along = corners[(side + 1) % corners.size()] - u;
      const Mp1024 slope = cross(along, direction);
      if (!(slope < -kTiny * norm(along))) continue;
      const Mp1024 at = cross(along, from - u) / -slope;
      if (at < exit_at) {
        exit_at = at;
        exit = side;
      }
    }
    return exit;
  }

  const certify::SurfaceSides& sides_;
  Parts<Mp1024> parts_;
  std::vector<std::vector<Point>> corners_;  ///< By tile, Klein model.
};

/// Returns x rounded down to 300 bits after the point.
Rational dyadic(const Mp1024& x) { return Rational(Mp1024(ldexp(floor(ldexp(x, 300)), -300))); }

/// Returns the points rotated by an isometry that fixes 0.
std::vector<Complex<double>> rotated(const Isometry<double>& f, std::vector<Complex<double>> points) {
  const Complex<double> turn = (1 / norm(f.a)) * (f.a * f.a);
  for (Complex<double>& z : points) z = turn * z;
  return points;
}

std::vector<Complex<double>> domain_of_vertex(const NetGeometry& geometry, const certify::NetDocument::Vertex& v) {
  const certify::NetDocument& net = geometry.document();
  const certify::NetDocument::Chart& chart = net.charts[v.chart];
  if (v.x == 0 && v.y == 0) {
    if (const auto corner = corner_at(net.surface, chart)) {
      const Surface surface = from_document(with_first_corner(net.surface, chart.tile, *corner));
      return dirichlet_polygon(surface, std::nullopt).vertices;
    }
    if (certify::regular_tile(net.surface) && chart.centre.x == 0 && chart.centre.y == 0)
      return dirichlet_polygon(from_document(net.surface), BasePoint{TileId(chart.tile), {0, 0}}).vertices;
  }
  const Tiles tiles(geometry);
  const Point z{Mp1024(v.x), Mp1024(v.y)};
  const TilePoint point = tiles.locate(v.chart, chart.tile, z);
  const Point base = tiles.inside(point);
  const BasePoint exact{TileId(point.tile), {dyadic(base.x), dyadic(base.y)}};
  DirichletPolygon polygon = dirichlet_polygon(from_document(net.surface), exact);
  // Both isometries lead from the chart to a disk with the vertex at 0.
  const Isometry<Mp1024> wanted = normalized(Isometry<Mp1024>::translation(-z));
  const Isometry<Mp1024> found = normalized(Isometry<Mp1024>::translation(-point.z) * point.from_chart);
  return rotated(convert<double>(wanted * inverse(found)), std::move(polygon.vertices));
}

}  // namespace

std::vector<Complex<double>> dirichlet_domain(const NetGeometry& geometry, std::uint32_t vertex) {
  constexpr std::uint32_t kMostGenus = 100;
  const std::string name = "the Dirichlet domain of vertex " + std::to_string(vertex);
  if (vertex >= geometry.document().vertices.size())
    throw NetGeometryError("vertex " + std::to_string(vertex) + " does not exist");
  if (geometry.genus() > kMostGenus) {
    throw DomainNotDrawn(name + " is drawn up to genus " + std::to_string(kMostGenus) + ", not " +
                         std::to_string(geometry.genus()));
  }
  try {
    return domain_of_vertex(geometry, geometry.document().vertices[vertex]);
  } catch (const SurfaceError& error) {
    throw NetGeometryError(name + ": " + error.what());
  } catch (const Error& error) {
    throw DomainNotDrawn(name + ": " + error.what());
  }
}

}  // namespace epsnet
