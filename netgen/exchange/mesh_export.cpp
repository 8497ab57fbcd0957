#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/exchange/drawn_mesh.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"

namespace epsnet {
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
