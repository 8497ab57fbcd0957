#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "kernel/lorentz.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg.h"
#include "netgen/surfaces/surface_file.h"

/// The pictures of pictures.h that show a polygon: what is in them.
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
  constexpr int kMostSteps = 10'000;
  constexpr std::size_t kMostSegments = 1000;
  int steps = 0;
  for (auto side = frame.side_towards(line.place); side; side = frame.side_towards(line.place)) {
    line = moved(inverse(frame.pairings()[*side]), line);
    if (++steps == kMostSteps) return std::nullopt;
  }
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

/// A point of the first geodesic; the surface's default if it cannot be told.
std::optional<BasePoint> point_of_first(const Surface& surface, const certify::GeodesicsDocument& document) {
  if (document.geodesics.empty()) return std::nullopt;
  const auto line = axis_of(isometry_of(surface, word_of_letters(document.geodesics[0].word)));
  if (!line) return std::nullopt;
  return rounded_point(surface, tile_of(document, document.geodesics[0]), line->place);
}

/// What a legend says of geodesics first, …, first + count − 1.
std::string cluster_name(const certify::GeodesicsDocument& document, std::size_t first, std::size_t count) {
  const auto middle = [&](std::size_t i) {
    return (document.geodesics[i].length.lower + document.geodesics[i].length.upper) / 2;
  };
  const std::string from = fixed(middle(first), 4);
  const std::string to = fixed(middle(first + count - 1), 4);
  return (count == 1 ? "closed geodesic of length " : std::to_string(count) + " closed geodesics of length ") + from +
         (from == to ? "" : " to " + to);
}

/// The geodesics of a file, one curve for each cluster of lengths, the shortest in front.
void add_geodesics(PolygonPicture& result, const Domain& domain, const certify::GeodesicsDocument& document) {
  constexpr std::size_t kMost = 200;
  // One colour for each cluster of lengths, the shortest in front.
  constexpr std::array<const char*, 6> kColours{palette::kGeodesics,     palette::kPaths,
                                                palette::kCoveringDisks, palette::kEpsilonCollars,
                                                palette::kPackingDisks,  palette::kEdges};
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
      const Isometry<Mp1024> way =
          domain.frame.from_tile() *
          inverse(isometry_of(domain.surface,
                              path_between_tiles(domain.surface, domain.frame.tile(), tile_of(document, geodesic))));
      const auto line =
          axis_of(normalized(way * isometry_of(domain.surface, word_of_letters(geodesic.word)) * inverse(way)));
      const auto segments = line ? traced(domain.frame, *line) : std::nullopt;
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

PolygonPicture picture_of(const Surface& surface) {
  // Breadth first from tile 0, in its coordinates; the rim is what is not crossed, as in fundamental_polygon.
  ById<TileId, std::optional<Isometry<Mp1024>>> place(surface.tiles().size());
  place[TileId(0)] = Isometry<Mp1024>{};
  std::vector<SideId> rim;
  for (const SideId s : surface.sides_of(TileId(0))) rim.push_back(s);
  PolygonPicture result{.title = "surface of genus " + std::to_string(surface.genus()) + ", " +
                                 std::to_string(surface.tiles().size()) +
                                 (surface.tiles().size() == 1 ? " tile" : " tiles")};
  const auto ends_of = [&](SideId side) {
    const TileId tile = surface.tile_of_side(side);
    const Tile& corners = surface.tile(tile);
    const std::uint32_t k = surface.place_in_tile(side);
    const auto corner = [&](std::uint32_t i) { return (*place[tile])(convert<Mp1024>(corners[i % corners.size()])); };
    return std::pair(corner(k), corner(k + 1));
  };
  std::vector<std::pair<Point, Point>> inner;
  for (bool grown = true; grown;) {
    grown = false;
    std::vector<SideId> next;
    for (const SideId side : rim) {
      const SideId entry = surface.partner(side);
      const TileId tile = surface.tile_of_side(entry);
      if (place[tile]) {
        next.push_back(side);
        continue;
      }
      grown = true;
      place[tile] = normalized(*place[surface.tile_of_side(side)] * inverse(surface.crossing_as<Mp1024>(side)));
      inner.push_back(ends_of(side));
      for (SideId s = surface.next_side(entry); s != entry; s = surface.next_side(s)) next.push_back(s);
    }
    rim = std::move(next);
  }
  // The middle of the corners goes to 0.
  LorentzVector<Mp1024> sum;
  for (const SideId side : rim) sum = sum + on_hyperboloid(ends_of(side).first);
  const Point middle = in_disk(Mp1024(1 / sqrt(Mp1024(-lorentz_product(sum, sum)))) * sum);
  const Isometry<Mp1024> to_centre = Isometry<Mp1024>::translation(-middle);
  ById<SideId, std::uint32_t> number(surface.side_count());
  for (std::uint32_t k = 0; k < rim.size(); ++k) number[rim[k]] = k;
  for (const SideId side : rim) {
    const auto [from, to] = ends_of(side);
    result.sides.push_back({segment(to_centre(from), to_centre(to)), number[surface.partner(side)], to_string(side)});
  }
  for (const auto& [from, to] : inner) result.inner.push_back(segment(to_centre(from), to_centre(to)));
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

}  // namespace epsnet
