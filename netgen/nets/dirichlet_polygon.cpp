#include "netgen/nets/dirichlet_polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/triangulations.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

/// sinh²(d/2) of lengths d that differ by a smaller share of themselves are equal here.
Mp1024 tolerance() { return ldexp(Mp1024(1), -300); }

Mp1024 sinh2_from_0(const Complex<Mp1024>& z) { return sinh2_half_distance(Complex<Mp1024>{}, z); }

}  // namespace

Isometry<Mp1024> isometry_of(const Surface& surface, const Word& word) {
  Isometry<Mp1024> result;
  for (const SideId side : word) result = normalized(surface.crossing_as<Mp1024>(side) * result);
  return result;
}

BasePoint rounded_point(const Surface& surface, TileId tile, const Complex<Mp1024>& z) {
  constexpr int kBits = 100;
  constexpr int kMostTiles = 100'000;
  // The corners of a regular surface's tile are rounded to 256 bits.
  const Mp1024 slack = ldexp(Mp1024(1), -240);
  Complex<Mp1024> here = z;
  for (int tiles = 0; tiles < kMostTiles; ++tiles) {
    const Tile& corners = surface.tile(tile);
    const auto is_beyond = [&](std::uint32_t k) {
      return orientation_determinant(convert<Mp1024>(corners[k]), convert<Mp1024>(corners[(k + 1) % corners.size()]),
                                     here) < -slack;
    };
    std::uint32_t k = 0;
    while (k < corners.size() && !is_beyond(k)) ++k;
    if (k == corners.size()) {
      const auto rounded = [&](const Mp1024& x) {
        return Rational(Mp1024(ldexp(round(Mp1024(ldexp(x, kBits))), -kBits)));
      };
      return in_its_tile(surface, {tile, {rounded(here.x), rounded(here.y)}});
    }
    const SideId side = surface.side_number(tile, k);
    here = surface.crossing_as<Mp1024>(side)(here);
    tile = surface.tile_of_side(surface.partner(side));
  }
  throw SurfaceError("a point is more than " + std::to_string(kMostTiles) + " tiles away from the tile it is given in");
}

DomainFrame::DomainFrame(const Surface& surface, const DirichletPolygon& polygon) {
  const certify::NetDocument& net = polygon.triangulation;
  const certify::NetDocument::Vertex& vertex = net.vertices[0];
  const certify::NetDocument::Chart& chart = net.charts[vertex.chart];
  tile_ = TileId(chart.tile);
  const auto number = [](const mpq_class& x) { return Mp1024(from_gmp(x)); };
  const Complex<Mp1024> centre{number(chart.centre.x), number(chart.centre.y)};
  from_tile_ = normalized(Isometry<Mp1024>::translation(-Complex<Mp1024>{Mp1024(vertex.x), Mp1024(vertex.y)}) *
                          Isometry<Mp1024>::translation(-centre));
  for (const DirichletPolygon::Side& side : polygon.sides) {
    pairings_.push_back(normalized(from_tile_ * isometry_of(surface, side.word) * inverse(from_tile_)));
    partners_.push_back(side.partner);
  }
  const std::size_t n = pairings_.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Complex<Mp1024> origin{};
    const auto centre_of_triangle = circumcentre(origin, pairings_[(k + n - 1) % n](origin), pairings_[k](origin));
    if (!centre_of_triangle) throw NetError("a vertex of the Dirichlet domain is farther away than 1024 bits can tell");
    vertices_.push_back(*centre_of_triangle);
  }
}

std::vector<std::uint32_t> DomainFrame::farthest_vertices() const {
  Mp1024 greatest(0);
  for (const Complex<Mp1024>& z : vertices_) greatest = std::max(greatest, sinh2_from_0(z));
  std::vector<std::uint32_t> result;
  std::vector<bool> done(vertices_.size(), false);
  for (std::uint32_t k = 0; k < vertices_.size(); ++k) {
    if (done[k] || sinh2_from_0(vertices_[k]) < (1 - tolerance()) * greatest) continue;
    result.push_back(k);
    // Side k and its partner are glued end to start.
    for (std::uint32_t same = k; !done[same];) {
      done[same] = true;
      same = (partners_[same] + 1) % static_cast<std::uint32_t>(vertices_.size());
    }
  }
  return result;
}

std::optional<std::uint32_t> DomainFrame::side_towards(const Complex<Mp1024>& z) const {
  std::optional<std::uint32_t> result;
  Mp1024 least = (1 - tolerance()) * sinh2_from_0(z);
  for (std::uint32_t k = 0; k < pairings_.size(); ++k) {
    const Mp1024 own = sinh2_half_distance(pairings_[k](Complex<Mp1024>{}), z);
    if (own >= least) continue;
    least = own;
    result = k;
  }
  return result;
}

std::optional<std::vector<std::uint32_t>> DomainFrame::walk(Complex<Mp1024> z) const {
  constexpr std::size_t kMostSides = 10'000;
  std::vector<std::uint32_t> result;
  while (const std::optional<std::uint32_t> side = side_towards(z)) {
    if (result.size() == kMostSides) return std::nullopt;
    result.push_back(*side);
    z = inverse(pairings_[*side])(z);
  }
  return result;
}

std::vector<BasePoint> farthest_points(const Surface& surface, const DirichletPolygon& polygon) {
  const DomainFrame frame(surface, polygon);
  std::vector<BasePoint> result;
  for (const std::uint32_t k : frame.farthest_vertices()) {
    result.push_back(rounded_point(surface, frame.tile(), inverse(frame.from_tile())(frame.vertices()[k])));
  }
  return result;
}

namespace {

/// Returns the word of the element that takes the start of a dart to its end, composed of verified words without any
/// numbers.
Word word_along(const Triangulation& triangulation, Dart d) {
  const LabelTable& labels = triangulation.atlas().labels();
  const auto word = [&](std::uint32_t corner) {
    const LabelId label = triangulation.corner(triangle_of(d), corner).label;
    return label == kIdentity ? Word{} : labels[label].word;
  };
  const Surface& surface = triangulation.surface();
  return concatenated(surface, word(next(corner_of(d))), reversed(surface, word(corner_of(d))));
}

}  // namespace

DirichletPolygon dirichlet_polygon(const Surface& surface, const std::optional<BasePoint>& base) {
  Triangulation triangulation = delaunay_start_of_point(surface, base).triangulation;
  // The lifts of the base point around 0, counterclockwise: the ends of the darts that leave it.
  const std::vector<Dart> clockwise = triangulation.star(make_dart(TriangleId(0), 0));
  const std::vector<Dart> star(clockwise.rbegin(), clockwise.rend());
  // If closed geodesics are short, 256 bits cannot resolve how close the lifts lie to the boundary of the disk.
  const Complex<Mp1024> origin = convert<Mp1024>(triangulation.vertex(VertexId(0)).z);
  const Isometry<Mp1024> to_origin = Isometry<Mp1024>::translation(-origin);
  std::vector<Complex<Mp1024>> lifts;
  lifts.reserve(star.size());
  for (const Dart d : star) {
    lifts.push_back(to_origin(triangulation.lift_in<Mp1024>({VertexId(0), triangulation.label_along(d)})));
  }
  // Centre k is that of the triangle clockwise of dart k, where its side starts.
  std::vector<Complex<Mp1024>> centres;
  double largest_circumradius = 0;
  const std::size_t n = star.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto centre = circumcentre(Complex<Mp1024>{}, lifts[(k + n - 1) % n], lifts[k]);
    if (!centre) {
      throw NetError("a vertex of the Dirichlet domain is farther away than 1024 bits can tell");
    }
    centres.push_back(*centre);
    largest_circumradius =
        std::max(largest_circumradius, static_cast<double>(distance(Complex<Mp1024>{}, centres.back())));
  }

  DirichletPolygon polygon;
  polygon.triangulation = net_document(triangulation, Length(std::floor(largest_circumradius) + 2));
  const std::vector<std::uint32_t> ties = proof_of(polygon.triangulation).ties;
  polygon.ties = static_cast<std::uint32_t>(ties.size());
  std::map<Dart, std::uint32_t> side_of;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t edge = std::min(document_dart(star[k]), document_dart(triangulation.opposite(star[k])));
    if (std::binary_search(ties.begin(), ties.end(), edge)) {
      continue;
    }
    side_of[star[k]] = static_cast<std::uint32_t>(polygon.sides.size());
    polygon.vertices.push_back(convert<double>(centres[k]));
    polygon.sides.push_back(
        {word_along(triangulation, star[k]), 0, static_cast<double>(distance(Complex<Mp1024>{}, lifts[k])) / 2});
  }
  for (const auto& [dart, side] : side_of) {
    polygon.sides[side].partner = side_of.at(triangulation.opposite(dart));
  }
  return polygon;
}

std::string dirichlet_json(const DirichletPolygon& polygon) {
  std::ostringstream out;
  out << "{\"format\": \"epsnet-dirichlet\", \"version\": 1,\n \"sides\": [";
  const char* separator = "\n  ";
  for (const DirichletPolygon::Side& side : polygon.sides) {
    out << separator << "{\"partner\": " << side.partner << ", \"distance\": " << certify::shortest(side.distance)
        << ", \"word\": [";
    for (std::size_t i = 0; i < side.word.size(); ++i) {
      out << (i == 0 ? "" : ", ") << side.word[i].number();
    }
    out << "]}";
    separator = ",\n  ";
  }
  out << "\n ],\n \"vertices\": [";
  separator = "\n  ";
  for (const Complex<double>& z : polygon.vertices) {
    out << separator << "[" << certify::shortest(z.x) << ", " << certify::shortest(z.y) << "]";
    separator = ",\n  ";
  }
  out << "\n ],\n \"ties\": " << polygon.ties << "}\n";
  return out.str();
}

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse_polygon(std::string_view place, const std::string& problem) {
  throw DirichletFileError(certify::ErrorParts{.place = std::string(place), .problem = problem});
}

const Json& member(const Json& object, const char* name, const std::string& place) {
  if (!object.is_object()) refuse_polygon(place, "expected an object");
  const auto found = object.find(name);
  if (found == object.end()) refuse_polygon(place, std::string("missing member \"") + name + "\"");
  return *found;
}

std::uint32_t index(const Json& value, const std::string& place) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > ~std::uint32_t{0})
    refuse_polygon(place, "expected an integer from 0 to 2^32 - 1");
  return value.get<std::uint32_t>();
}

double number(const Json& value, const std::string& place) {
  if (!value.is_number()) refuse_polygon(place, "expected a number");
  return value.get<double>();
}

const Json& array(const Json& value, std::string_view place) {
  if (!value.is_array()) refuse_polygon(place, "expected an array");
  return value;
}

DirichletPolygon polygon_of(const Json& file) {
  const std::string whole = "Dirichlet domain";
  if (member(file, "format", whole) != "epsnet-dirichlet") refuse_polygon("format", "expected \"epsnet-dirichlet\"");
  if (member(file, "version", whole) != 1) refuse_polygon("version", "expected 1");
  DirichletPolygon polygon;
  const Json& sides = array(member(file, "sides", whole), "sides");
  for (const Json& side : sides) {
    const std::string place = "sides[" + std::to_string(polygon.sides.size()) + "]";
    DirichletPolygon::Side& read = polygon.sides.emplace_back();
    read.partner = index(member(side, "partner", place), place);
    if (read.partner >= sides.size())
      refuse_polygon(place, "the partner " + std::to_string(read.partner) + ", but there are " +
                                std::to_string(sides.size()) + " sides");
    read.distance = number(member(side, "distance", place), place);
    for (const Json& letter : array(member(side, "word", place), place)) read.word.emplace_back(index(letter, place));
  }
  for (const Json& vertex : array(member(file, "vertices", whole), "vertices")) {
    const std::string place = "vertices[" + std::to_string(polygon.vertices.size()) + "]";
    if (array(vertex, place).size() != 2) refuse_polygon(place, "expected [x, y]");
    polygon.vertices.push_back({number(vertex[0], place), number(vertex[1], place)});
  }
  if (polygon.vertices.size() != polygon.sides.size())
    refuse_polygon("vertices", "there are " + std::to_string(polygon.vertices.size()) + ", and " +
                                   std::to_string(polygon.sides.size()) + " sides");
  polygon.ties = index(member(file, "ties", whole), "ties");
  return polygon;
}

}  // namespace

DirichletPolygon parse_dirichlet_json(std::string_view text, const std::string& name) try {
  return polygon_of(Json::parse(text));
} catch (const DirichletFileError& error) {
  certify::ErrorParts parts = error.parts();
  parts.file = name;
  throw DirichletFileError(parts);
} catch (const Json::exception& error) {
  throw DirichletFileError(certify::ErrorParts{.file = name, .problem = std::string("not JSON: ") + error.what()});
}

}  // namespace epsnet
