#include "netgen/exchange/drawn_mesh.h"

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/disjoint_sets.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"

namespace epsnet {
namespace {

using Triangles = std::vector<certify::NetDocument::Triangle>;

std::uint32_t opposite(const Triangles& triangles, std::uint32_t dart) {
  return triangles[dart / 3].opposite[dart % 3];
}

/// The darts on the boundary, each followed by the one that starts where it ends.
std::vector<std::uint32_t> boundary_cycle(const Triangles& triangles, const std::vector<bool>& on_boundary) {
  const auto first =
      static_cast<std::uint32_t>(std::find(on_boundary.begin(), on_boundary.end(), true) - on_boundary.begin());
  std::vector<std::uint32_t> cycle;
  if (first == on_boundary.size()) return cycle;
  std::uint32_t dart = first;
  do {
    cycle.push_back(dart);
    dart = certify::next_dart(dart);
    while (!on_boundary[dart]) dart = certify::next_dart(opposite(triangles, dart));
  } while (dart != first);
  return cycle;
}

/// Cuts the boundary into sides. Two edges that follow each other are glued by the same element of the group if and
/// only if their opposites follow each other too: the quotient of their elements then fixes a point.
std::vector<DrawnMesh::Side> sides(const Triangles& triangles, const std::vector<bool>& on_boundary) {
  std::vector<std::uint32_t> cycle = boundary_cycle(triangles, on_boundary);
  std::vector<std::uint32_t> place(on_boundary.size());
  for (std::uint32_t i = 0; i < cycle.size(); ++i) place[cycle[i]] = i;
  const auto begins_side = [&](std::uint32_t before, std::uint32_t dart) {
    const std::size_t next = (std::size_t{place[opposite(triangles, dart)]} + 1) % cycle.size();
    return next != place[opposite(triangles, before)];
  };
  std::size_t begin = 0;
  for (std::size_t i = 1; i < cycle.size() && begin == 0; ++i) {
    if (begins_side(cycle[i - 1], cycle[i])) begin = i;
  }
  std::vector<DrawnMesh::Side> result;
  std::vector<std::uint32_t> side_of(on_boundary.size());
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const std::uint32_t dart = cycle[(begin + i) % cycle.size()];
    if (i == 0 || begins_side(result.back().darts.back(), dart)) result.emplace_back();
    result.back().darts.push_back(dart);
    side_of[dart] = static_cast<std::uint32_t>(result.size() - 1);
  }
  for (DrawnMesh::Side& side : result) side.partner = side_of[opposite(triangles, side.darts.front())];
  return result;
}

}  // namespace

DrawnMesh drawn_mesh(const NetGeometry& geometry, const Lifts& lifts) {
  const Triangles& triangles = geometry.document().triangles;
  DrawnMesh result;
  result.on_boundary = boundary_darts(geometry, lifts);
  // Corners, numbered by the darts that start there, are identified across edges inside the drawing.
  DisjointSets corners(3 * triangles.size());
  for (std::uint32_t dart = 0; dart < corners.size(); ++dart) {
    if (result.on_boundary[dart]) continue;
    const std::uint32_t other = opposite(triangles, dart);
    corners.join(dart, certify::next_dart(other));
    corners.join(certify::next_dart(dart), other);
  }
  std::vector<std::uint32_t> number(corners.size());
  for (std::uint32_t dart = 0; dart < corners.size(); ++dart) {
    const std::uint32_t first = corners.find(dart);
    if (first == dart) {
      number[dart] = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(
          {lifts.lifted[lifts.place[dart / 3]].corner[dart % 3], triangles[dart / 3].vertex[dart % 3]});
    }
    number[dart] = number[first];
  }
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    result.triangles.push_back(
        {number[std::size_t{3} * t], number[std::size_t{3} * t + 1], number[std::size_t{3} * t + 2]});
  result.sides = sides(triangles, result.on_boundary);
  return result;
}

namespace {

using certify::shortest;

/// Writes a JSON array row by row.
class Rows {
 public:
  Rows(std::ostream& out, const char* name) : out_(out) { out_ << ",\n\"" << name << "\": ["; }
  void add(const std::string& row) {
    out_ << (is_first_ ? "\n" : ",\n") << row;
    is_first_ = false;
  }
  void end() { out_ << "]"; }

 private:
  std::ostream& out_;
  bool is_first_ = true;
};

/// Writes the isometries that take the drawn neighbour of a boundary side to the place beyond that side.
void write_pairings(const NetGeometry& geometry, const Lifts& lifts, const std::vector<bool>& on_boundary,
                    std::ostream& out) {
  const certify::NetDocument& net = geometry.document();
  Rows rows(out, "pairings");
  for (std::uint32_t dart = 0; dart < on_boundary.size(); ++dart) {
    if (!on_boundary[dart]) continue;
    const std::uint32_t other = net.triangles[dart / 3].opposite[dart % 3];
    const auto placement = [&](std::uint32_t triangle) {
      return lifts.placements[lifts.lifted[lifts.place[triangle]].placement[0]].precise;
    };
    const Placement beyond = neighbour(geometry, {dart / 3, placement(dart / 3)}, dart % 3);
    const auto f = convert<double>(normalized(beyond.isometry * inverse(placement(other / 3))));
    rows.add("[" + std::to_string(dart) + ", " + std::to_string(other) + ", " + point_text(f.a, ", ") + ", " +
             point_text(f.b, ", ") + "]");
  }
  rows.end();
}

}  // namespace

void write_off(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  const DrawnMesh drawn = drawn_mesh(geometry, lift_triangles(geometry, DrawOrder::weight));
  out << "OFF\n" << drawn.points.size() << ' ' << drawn.triangles.size() << " 0\n";
  for (const DrawnMesh::Point& point : drawn.points) out << point_text(point.place, " ") << " 0\n";
  for (const auto& triangle : drawn.triangles) out << "3 " << joined(triangle, " ") << '\n';
}

namespace {

void write_vtu_of(const certify::NetDocument& net, const VertexData* data, std::ostream& out) {
  const NetGeometry geometry(net);
  const DrawnMesh drawn = drawn_mesh(geometry, lift_triangles(geometry, DrawOrder::weight));
  const auto array = [&](const char* type, const std::string& attributes, std::size_t count, const auto& text) {
    out << "<DataArray type=\"" << type << "\" " << attributes << " format=\"ascii\">\n";
    for (std::uint32_t i = 0; i < count; ++i) out << text(i) << '\n';
    out << "</DataArray>\n";
  };
  const std::size_t n = drawn.triangles.size();
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
      << drawn.points.size() << "\" NumberOfCells=\"" << n << "\">\n<PointData Scalars=\"vertex\">\n";
  array("Int64", "Name=\"vertex\"", drawn.points.size(),
        [&](std::uint32_t i) { return std::to_string(drawn.points[i].vertex); });
  array("Float64", "Name=\"weight\"", drawn.points.size(),
        [&](std::uint32_t i) { return shortest(metric_weight(drawn.points[i].place)); });
  if (data != nullptr) {
    array("Float64", "Name=\"" + data->name + "\"", drawn.points.size(),
          [&](std::uint32_t i) { return shortest(data->values[drawn.points[i].vertex]); });
  }
  out << "</PointData>\n<CellData Scalars=\"circumradius\">\n";
  array("Float64", "Name=\"circumradius\"", n, [&](std::uint32_t t) { return circumradius_text(geometry, t); });
  array("Int64", "Name=\"triangle\"", n, [](std::uint32_t t) { return std::to_string(t); });
  array("Int64", "Name=\"vertices\" NumberOfComponents=\"3\"", n,
        [&](std::uint32_t t) { return joined(net.triangles[t].vertex, " "); });
  array("Float64", "Name=\"corners\" NumberOfComponents=\"9\"", n,
        [&](std::uint32_t t) { return corners_text(geometry, t); });
  out << "</CellData>\n<Points>\n";
  array("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", drawn.points.size(),
        [&](std::uint32_t i) { return point_text(drawn.points[i].place, " ") + " 0"; });
  out << "</Points>\n<Cells>\n";
  array("Int64", "Name=\"connectivity\"", n, [&](std::uint32_t t) { return joined(drawn.triangles[t], " "); });
  array("Int64", "Name=\"offsets\"", n, [](std::uint32_t t) { return std::to_string(3 * (std::uint64_t{t} + 1)); });
  array("UInt8", "Name=\"types\"", n, [](std::uint32_t) { return std::string("5"); });
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

void write_vtu(const certify::NetDocument& net, std::ostream& out) { write_vtu_of(net, nullptr, out); }

void write_vtu_with(const VertexData& data, const certify::NetDocument& net, std::ostream& out) {
  if (data.values.size() != net.vertices.size()) {
    throw std::invalid_argument(std::to_string(data.values.size()) + " numbers for " +
                                std::to_string(net.vertices.size()) + " vertices");
  }
  write_vtu_of(net, &data, out);
}

void write_mesh_json(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  const Lifts lifts = lift_triangles(geometry, DrawOrder::weight);
  const DrawnMesh drawn = drawn_mesh(geometry, lifts);
  out << "{\"format\": \"epsnet-mesh\", \"version\": 1, \"epsilon\": " << shortest(geometry.epsilon().get_d())
      << ", \"genus\": " << geometry.genus() << ", \"vertex_count\": " << net.vertices.size();
  Rows points(out, "points");
  for (const DrawnMesh::Point& point : drawn.points)
    points.add("[" + point_text(point.place, ", ") + ", " + std::to_string(point.vertex) + "]");
  points.end();
  Rows triangles(out, "triangles");
  for (const auto& triangle : drawn.triangles) triangles.add("[" + joined(triangle, ", ") + "]");
  triangles.end();
  Rows opposite(out, "opposite");
  for (const certify::NetDocument::Triangle& triangle : net.triangles)
    opposite.add("[" + joined(triangle.opposite, ", ") + "]");
  opposite.end();
  Rows radii(out, "circumradii");
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) radii.add(circumradius_text(geometry, t));
  radii.end();
  write_pairings(geometry, lifts, drawn.on_boundary, out);
  Rows corner_labels(out, "corner_labels");
  for (const certify::NetDocument::Triangle& triangle : net.triangles)
    corner_labels.add("[" + joined(triangle.label, ", ") + "]");
  corner_labels.end();
  Rows labels(out, "labels");
  for (std::uint32_t number = 0; number <= net.labels.size(); ++number) {
    const Isometry<double>& f = geometry.label(number).rounded;
    const std::string word = number == 0 ? "" : joined(net.labels[number - 1].word, ", ");
    labels.add("{\"isometry\": [" + point_text(f.a, ", ") + ", " + point_text(f.b, ", ") + "], \"word\": [" + word +
               "]}");
  }
  labels.end();
  out << "}\n";
}

}  // namespace epsnet
