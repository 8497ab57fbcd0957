#include "epsnet/netgen/dirichlet_polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "epsnet/certify/check.h"
#include "epsnet/certify/text.h"
#include "epsnet/kernel/plane.h"
#include "epsnet/netgen/certified_net.h"
#include "epsnet/netgen/start.h"

namespace epsnet {
namespace {

certify::Certificate verified(const certify::Document& triangulation) {
  certify::Certificate certificate = certify::check(triangulation);
  if (certificate.verdict != certify::Verdict::verified) {
    throw NetError("the triangulation dual to the Dirichlet domain was not verified: " +
                   std::string(certify::name(certificate.verdict)) + ": " + certificate.rule + ": " +
                   certificate.message);
  }
  return certificate;
}

/// The word of the element that takes the start of a dart to its end, made of the words that were verified by steps
/// which need no numbers.
Word word_along(const Triangulation& triangulation, Dart d) {
  const Atlas& atlas = triangulation.atlas();
  const auto word = [&](std::uint32_t corner) {
    const LabelId label = triangulation.corner(triangle_of(d), corner).label;
    return label == kIdentity ? Word{} : atlas.word(label);
  };
  const Surface& surface = triangulation.surface();
  return concatenated(surface, word(next(corner_of(d))), reversed(surface, word(corner_of(d))));
}

}  // namespace

DirichletPolygon dirichlet_polygon(const Surface& surface, const std::optional<BasePoint>& base) try {
  Triangulation triangulation = delaunay_start(surface, base);
  (void)reduce_to_vertex_0(triangulation);
  Atlas& atlas = triangulation.atlas();
  // The lifts of the base point around 0, counterclockwise: the ends of the darts that leave it.
  const std::vector<Dart> clockwise = triangulation.star(make_dart(0, 0));
  const std::vector<Dart> star(clockwise.rbegin(), clockwise.rend());
  // Where closed geodesics are short, the lifts lie closer to the boundary of the disk than 256 bits can tell.
  const Complex<Mp1024> origin = convert<Mp1024>(triangulation.vertex(0).z);
  const Isometry<Mp1024> to_origin = Isometry<Mp1024>::translation(-origin);
  std::vector<Complex<Mp1024>> lifts;
  lifts.reserve(star.size());
  for (const Dart d : star) {
    lifts.push_back(to_origin(atlas.lift<Mp1024>(triangulation.label_along(d), triangulation.vertex(0).z)));
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
  polygon.triangulation = net_document(triangulation, Epsilon(std::floor(largest_circumradius) + 2));
  const std::vector<std::uint32_t> ties = verified(polygon.triangulation).ties;
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
