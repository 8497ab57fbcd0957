#include "epsnet/netgen/dirichlet_polygon.h"

#include <map>
#include <sstream>

#include "epsnet/certify/text.h"
#include "epsnet/kernel/plane.h"
#include "epsnet/netgen/certified_net.h"
#include "epsnet/netgen/start.h"

namespace epsnet {
namespace {

/// The edge of d is Delaunay, but its other diagonal would be, too.
bool is_tie(Triangulation& triangulation, Dart d) {
  return triangulation.is_delaunay(d) && [&] {
    const Dart e = triangulation.opposite(d);
    const LabelId across = triangulation.transition(d);
    const Corner far = triangulation.corner(triangle_of(e), previous(corner_of(e)));
    const std::uint32_t t = triangle_of(d);
    return triangulation.in_circle(triangulation.corner(t, 0), triangulation.corner(t, 1), triangulation.corner(t, 2),
                                   {far.vertex, triangulation.atlas().product(across, far.label)}) == 0;
  }();
}

}  // namespace

DirichletPolygon dirichlet_polygon(const Surface& surface, const std::optional<BasePoint>& base) try {
  Triangulation triangulation(surface, base);
  (void)triangulation.make_delaunay();
  (void)reduce_to_vertex_0(triangulation);
  Atlas& atlas = triangulation.atlas();
  // The lifts of the base point around 0, counterclockwise: the ends of the darts that leave it.
  const std::vector<Dart> clockwise = triangulation.star(make_dart(0, 0));
  const std::vector<Dart> star(clockwise.rbegin(), clockwise.rend());
  const Complex<Mp256> origin = convert<Mp256>(triangulation.vertex(0).z);
  const Isometry<Mp256> to_origin = Isometry<Mp256>::translation(-origin);
  std::vector<Complex<Mp256>> lifts;
  std::vector<LabelId> labels;
  for (const Dart d : star) {
    labels.push_back(triangulation.label_along(d));
    lifts.push_back(to_origin(atlas.lift<Mp256>(labels.back(), triangulation.vertex(0).z)));
  }

  DirichletPolygon polygon;
  std::map<Dart, std::uint32_t> side_of;
  const std::size_t n = star.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (is_tie(triangulation, star[k])) {
      ++polygon.ties;
      continue;
    }
    // The side starts at the centre of the triangle clockwise of its dart.
    const auto vertex = circumcentre(Complex<Mp256>{}, lifts[(k + n - 1) % n], lifts[k]);
    if (!vertex) {
      throw NetError("a vertex of the Dirichlet domain is farther away than 256 bits can tell");
    }
    side_of[star[k]] = static_cast<std::uint32_t>(polygon.sides.size());
    polygon.vertices.push_back(convert<double>(*vertex));
    polygon.sides.push_back({labels[k] == kIdentity ? Word{} : atlas.word(labels[k]), 0,
                             static_cast<double>(distance(Complex<Mp256>{}, lifts[k])) / 2});
  }
  polygon.ties /= 2;
  for (const auto& [dart, side] : side_of) {
    polygon.sides[side].partner = side_of.at(triangulation.opposite(dart));
  }
  polygon.triangulation = net_document(triangulation, Epsilon("1"));
  return polygon;
} catch (const LimitError& error) {
  throw NetError(error.what());
}

std::string dirichlet_json(const DirichletPolygon& polygon) {
  std::ostringstream out;
  out << "{\"format\": \"epsnet-dirichlet\", \"version\": 1,\n \"sides\": [";
  const char* separator = "\n  ";
  for (const DirichletPolygon::Side& side : polygon.sides) {
    out << separator << "{\"partner\": " << side.partner << ", \"distance\": " << certify::shortest(side.distance)
        << ", \"word\": [";
    for (std::size_t i = 0; i < side.word.size(); ++i) {
      out << (i == 0 ? "" : ", ") << side.word[i];
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

}  // namespace epsnet
