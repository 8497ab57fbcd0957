#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
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

/// One lift of every triangle of a net as a planar mesh, and the formats of meshes.
namespace epsnet {
namespace {

/// The drawn lifts with common corners identified: a triangulated disk whose boundary is glued side to side.
struct DrawnMesh {
  /// A point of the disk.
  struct Point {
    Complex<double> place;
    std::uint32_t vertex;  ///< Of the net: points with the same one are the same point of the surface.
  };
  /// A longest part of the boundary that one element of the group takes to another side.
  struct Side {
    std::vector<std::uint32_t> darts;  ///< Counterclockwise. The opposite of the first is the last one of the partner.
    std::uint32_t partner;             ///< The side that it is glued to, another one.
  };
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< In the order of the document.
  std::vector<bool> on_boundary;                        ///< By dart.
  std::vector<Side> sides;                              ///< Counterclockwise around the disk.

  /// Returns the point where a dart starts.
  [[nodiscard]] std::uint32_t start(std::uint32_t dart) const { return triangles[dart / 3][dart % 3]; }
  /// Returns the point where a dart ends.
  [[nodiscard]] std::uint32_t end(std::uint32_t dart) const { return triangles[dart / 3][(dart + 1) % 3]; }
};

/// Returns the factor w of the hyperbolic metric w (dx² + dy²) at a point of the disk.
double metric_weight(const Complex<double>& z) {
  const double s = 1 - norm(z);
  return 4 / (s * s);
}

/// Writes infinity, which JSON does not have, as the largest number.
std::string circumradius_text(const NetGeometry& geometry, std::uint32_t triangle) {
  return certify::shortest(std::min(geometry.circumradius(triangle), std::numeric_limits<double>::max()));
}

/// The corners of a triangle in its own coordinates: three points (x, y, 0).
std::string corners_text(const NetGeometry& geometry, std::uint32_t triangle) {
  std::string out;
  for (const Complex<double>& z : geometry.centred_corners(triangle)) {
    out += (out.empty() ? "" : " ") + certify::shortest(z.x) + ' ' + certify::shortest(z.y) + " 0";
  }
  return out;
}

/// "a<separator>b<separator>c" of indices.
template <class Indices>
std::string joined(const Indices& indices, const char* separator) {
  std::string out;
  for (const std::uint32_t i : indices) out += (out.empty() ? "" : separator) + std::to_string(i);
  return out;
}

std::string point_text(const Complex<double>& z, const char* separator) {
  return certify::shortest(z.x) + separator + certify::shortest(z.y);
}

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

/// Returns the mesh of some lifts. O(triangles).
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

namespace {

using certify::shortest;

DrawnMesh drawn(const NetGeometry& geometry) {
  return drawn_mesh(geometry, lift_triangles(geometry, DrawOrder::weight));
}

/// What every file says of itself: lines, each after `prefix`.
std::string about(const NetGeometry& geometry, const std::string& prefix, const std::vector<std::string>& lines) {
  std::string out = prefix + "An epsilon-net of a closed hyperbolic surface of genus " +
                    std::to_string(geometry.genus()) + ", rounded: triangles of the Poincare disk.\n" + prefix +
                    "The metric is weight * (dx^2 + dy^2), weight = 4/(1 - x^2 - y^2)^2.\n";
  for (const std::string& line : lines) out += prefix + line + '\n';
  return out;
}

/// The lines that say which sides are glued.
std::vector<std::string> gluing(const DrawnMesh& mesh) {
  std::vector<std::string> lines;
  for (std::uint32_t k = 0; k < mesh.sides.size(); ++k) {
    const std::uint32_t partner = mesh.sides[k].partner;
    if (k < partner)
      lines.push_back("side " + std::to_string(k + 1) + " is glued to side " + std::to_string(partner + 1));
  }
  return lines;
}

/// Points along a side, counterclockwise.
std::vector<std::uint32_t> points_of(const DrawnMesh& mesh, const DrawnMesh::Side& side) {
  std::vector<std::uint32_t> points{mesh.start(side.darts.front())};
  for (const std::uint32_t dart : side.darts) points.push_back(mesh.end(dart));
  return points;
}

std::size_t edges_on_boundary(const DrawnMesh& mesh) {
  std::size_t count = 0;
  for (const DrawnMesh::Side& side : mesh.sides) count += side.darts.size();
  return count;
}

/// "a b c", with indices from 1 on.
template <class Indices>
std::string from_one(Indices indices) {
  for (auto& i : indices) ++i;
  return joined(indices, " ");
}

/// Writes data of Gmsh's nodes or elements, by their numbers from 1 on. The text of a row has `components` numbers.
template <class Text>
void write_gmsh_data(std::ostream& out, const std::string& section, const char* name, int components, std::size_t count,
                     const Text& text) {
  // One string, the name; one real, the time; three integers: the time step and the two sizes.
  out << '$' << section << "\n1\n\"" << name << "\"\n1\n0\n3\n0\n" << components << '\n' << count << '\n';
  for (std::uint32_t i = 0; i < count; ++i) out << std::uint64_t{i} + 1 << ' ' << text(i) << '\n';
  out << "$End" << section << '\n';
}

void write_gmsh_header(std::ostream& out, const char* version, const std::string& comments) {
  out << "$MeshFormat\n" << version << " 0 8\n$EndMeshFormat\n$Comments\n" << comments << "$EndComments\n";
}

/// The drawn lifts as a model of Gmsh: the corners between sides, the sides, and the surface, all with numbers from 1
/// on. Corner k is where side k begins.
class GmshModel {
 public:
  explicit GmshModel(const DrawnMesh& mesh) : mesh_(mesh), number_(mesh.points.size()) {
    blocks_.resize(2 * mesh.sides.size() + 1);
    for (std::uint32_t k = 0; k < mesh.sides.size(); ++k) {
      for (const std::uint32_t dart : mesh.sides[k].darts) add(mesh.start(dart), corner_or_side(dart, k));
    }
    for (std::uint32_t i = 0; i < number_.size(); ++i) {
      if (number_[i] == 0) add(i, blocks_.size() - 1);
    }
    // Nodes have their numbers in the order in which they are written, which some readers require.
    std::uint64_t next = 1;
    for (const auto& block : blocks_) {
      for (const std::uint32_t point : block) number_[point] = next++;
    }
  }

  void write_entities(std::ostream& out) const {
    const std::size_t n = mesh_.sides.size();
    out << "$Entities\n" << n << ' ' << n << " 1 0\n";
    for (std::size_t k = 0; k < n; ++k) out << k + 1 << ' ' << place(blocks_[k][0]) << " 0\n";
    for (std::size_t k = 0; k < n; ++k) {
      out << k + 1 << ' ' << box(points_of(mesh_, mesh_.sides[k])) << " 1 " << k + 1 << " 2 " << k + 1 << " -"
          << (k + 1) % n + 1 << '\n';
    }
    std::vector<std::uint32_t> all(mesh_.points.size());
    std::iota(all.begin(), all.end(), std::uint32_t{0});
    out << "1 " << box(all) << " 1 1 " << n;
    for (std::size_t k = 0; k < n; ++k) out << ' ' << k + 1;
    out << "\n$EndEntities\n";
  }

  void write_nodes(std::ostream& out) const {
    out << "$Nodes\n" << blocks_.size() << ' ' << number_.size() << " 1 " << number_.size() << '\n';
    const std::size_t n = mesh_.sides.size();
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      const std::vector<std::uint32_t>& points = blocks_[block];
      out << block / n << ' ' << block % n + 1 << " 0 " << points.size() << '\n';
      for (const std::uint32_t i : points) out << number_[i] << '\n';
      for (const std::uint32_t i : points) out << place(i) << '\n';
    }
    out << "$EndNodes\n";
  }

  /// Writes the triangles, with the numbers that they have in the net and 1, and the edges of sides.
  void write_elements(std::ostream& out) const {
    std::size_t element = mesh_.triangles.size();
    for (const DrawnMesh::Side& side : mesh_.sides) element += side.darts.size();
    out << "$Elements\n" << mesh_.sides.size() + 1 << ' ' << element << " 1 " << element << '\n';
    element = 0;
    out << "2 1 2 " << mesh_.triangles.size() << '\n';
    for (const auto& [a, b, c] : mesh_.triangles)
      out << ++element << ' ' << number_[a] << ' ' << number_[b] << ' ' << number_[c] << '\n';
    for (std::size_t k = 0; k < mesh_.sides.size(); ++k) {
      const std::vector<std::uint32_t>& darts = mesh_.sides[k].darts;
      out << "1 " << k + 1 << " 1 " << darts.size() << '\n';
      for (const std::uint32_t dart : darts)
        out << ++element << ' ' << number_[mesh_.start(dart)] << ' ' << number_[mesh_.end(dart)] << '\n';
    }
    out << "$EndElements\n";
  }

  /// Writes which nodes of the second side of each pair are which of the first one.
  void write_periodic(std::ostream& out) const {
    out << "$Periodic\n" << mesh_.sides.size() / 2 << '\n';
    for (std::uint32_t k = 0; k < mesh_.sides.size(); ++k) {
      const std::uint32_t partner = mesh_.sides[k].partner;
      if (k < partner) continue;
      const std::vector<std::uint32_t> points = points_of(mesh_, mesh_.sides[k]);
      const std::vector<std::uint32_t> others = points_of(mesh_, mesh_.sides[partner]);
      out << "1 " << k + 1 << ' ' << partner + 1 << "\n0\n" << points.size() << '\n';
      for (std::size_t i = 0; i < points.size(); ++i)
        out << number_[points[i]] << ' ' << number_[others[points.size() - 1 - i]] << '\n';
    }
    out << "$EndPeriodic\n";
  }

  /// Writes a number for each node; `text` returns that of a point.
  template <class Text>
  void write_data(std::ostream& out, const char* name, const Text& text) const {
    std::vector<std::uint32_t> order;
    for (const auto& block : blocks_) order.insert(order.end(), block.begin(), block.end());
    write_gmsh_data(out, "NodeData", name, 1, order.size(),
                    [&](std::uint32_t i) { return text(mesh_.points[order[i]]); });
  }

 private:
  std::size_t corner_or_side(std::uint32_t dart, std::uint32_t side) const {
    return dart == mesh_.sides[side].darts.front() ? side : mesh_.sides.size() + side;
  }
  void add(std::uint32_t point, std::size_t block) {
    blocks_[block].push_back(point);
    number_[point] = 1;
  }
  std::string place(std::uint32_t point) const { return point_text(mesh_.points[point].place, " ") + " 0"; }

  /// The least and greatest coordinates of points.
  std::string box(const std::vector<std::uint32_t>& points) const {
    Complex<double> least = mesh_.points[points.front()].place;
    Complex<double> greatest = least;
    for (const std::uint32_t i : points) {
      const Complex<double>& z = mesh_.points[i].place;
      least = {std::min(least.x, z.x), std::min(least.y, z.y)};
      greatest = {std::max(greatest.x, z.x), std::max(greatest.y, z.y)};
    }
    return point_text(least, " ") + " 0 " + point_text(greatest, " ") + " 0";
  }

  const DrawnMesh& mesh_;
  std::vector<std::uint64_t> number_;               ///< By point: that of its node.
  std::vector<std::vector<std::uint32_t>> blocks_;  ///< Points of each corner, of each side, and inside.
};

/// Throws ExchangeError if two edges have the same ends, or an edge is a loop.
void require_edges_by_their_ends(const certify::NetDocument& net) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    if (certify::opposite(net, dart) < dart) continue;
    const auto [u, v] = std::minmax({certify::start(net, dart), certify::start(net, certify::next_dart(dart))});
    if (u == v) throw ExchangeError("an edge of the net is a loop, which MFEM does not have: take a smaller epsilon");
    edges.push_back({u, v});
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    throw ExchangeError("two edges of the net have the same ends; for MFEM they are one: take a smaller epsilon");
}

}  // namespace

void write_gmsh(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  const DrawnMesh mesh = drawn(geometry);
  const GmshModel model(mesh);
  write_gmsh_header(out, "4.1",
                    about(geometry, "",
                          {"Sides are glued in pairs: Periodic has their nodes.",
                           "Nodes with the same number in the data vertex are one point of the surface."}));
  out << "$PhysicalNames\n" << mesh.sides.size() + 1 << '\n';
  for (std::uint32_t k = 0; k < mesh.sides.size(); ++k)
    out << "1 " << k + 1 << " \"side " << k + 1 << ", glued to side " << mesh.sides[k].partner + 1 << "\"\n";
  out << "2 1 \"surface\"\n$EndPhysicalNames\n";
  model.write_entities(out);
  model.write_nodes(out);
  model.write_elements(out);
  model.write_periodic(out);
  model.write_data(out, "weight", [](const DrawnMesh::Point& point) { return shortest(metric_weight(point.place)); });
  model.write_data(out, "vertex", [](const DrawnMesh::Point& point) { return std::to_string(point.vertex); });
}

void write_gmsh_glued(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  write_gmsh_header(out, "2.2",
                    about(geometry, "",
                          {"The glued surface does not fit into the disk: all nodes are at 0, and mean nothing.",
                           "The data corners has each triangle in coordinates of its own."}));
  out << "$Nodes\n" << net.vertices.size() << '\n';
  for (std::size_t v = 0; v < net.vertices.size(); ++v) out << v + 1 << " 0 0 0\n";
  const std::size_t n = net.triangles.size();
  out << "$EndNodes\n$Elements\n" << n << '\n';
  for (std::size_t t = 0; t < n; ++t) out << t + 1 << " 2 2 1 1 " << from_one(net.triangles[t].vertex) << '\n';
  out << "$EndElements\n";
  write_gmsh_data(out, "ElementData", "corners", 9, n, [&](std::uint32_t t) { return corners_text(geometry, t); });
  write_gmsh_data(out, "ElementData", "circumradius", 1, n,
                  [&](std::uint32_t t) { return circumradius_text(geometry, t); });
}

void write_medit(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  const DrawnMesh mesh = drawn(geometry);
  std::vector<std::string> lines = gluing(mesh);
  lines.insert(lines.begin(), {"Vertices with the same label are one point of the surface.",
                               "Labels of edges are the numbers of sides:"});
  out << "MeshVersionFormatted 2\n\nDimension 2\n\n"
      << about(geometry, "# ", lines) << "\nVertices\n"
      << mesh.points.size() << '\n';
  for (const DrawnMesh::Point& point : mesh.points)
    out << point_text(point.place, " ") << ' ' << std::uint64_t{point.vertex} + 1 << '\n';
  out << "\nEdges\n" << edges_on_boundary(mesh) << '\n';
  for (std::uint32_t k = 0; k < mesh.sides.size(); ++k) {
    for (const std::uint32_t dart : mesh.sides[k].darts)
      out << mesh.start(dart) + 1 << ' ' << mesh.end(dart) + 1 << ' ' << k + 1 << '\n';
  }
  out << "\nTriangles\n" << mesh.triangles.size() << '\n';
  for (const auto& triangle : mesh.triangles) out << from_one(triangle) << " 1\n";
  out << "\nEnd\n";
}

void write_mfem(const certify::NetDocument& net, std::ostream& out) {
  const NetGeometry geometry(net);
  require_edges_by_their_ends(net);
  const DrawnMesh mesh = drawn(geometry);
  out << "MFEM mesh v1.0\n\n"
      << about(geometry, "# ", {"The elements are glued; their nodes are those of one lift to the disk."})
      << "\ndimension\n2\n\nelements\n"
      << net.triangles.size() << '\n';
  for (const certify::NetDocument::Triangle& triangle : net.triangles)
    out << "1 2 " << joined(triangle.vertex, " ") << '\n';
  out << "\nboundary\n0\n\nvertices\n"
      << net.vertices.size()
      << "\n\nnodes\nFiniteElementSpace\nFiniteElementCollection: L2_T1_2D_P1\nVDim: 2\nOrdering: 1\n\n";
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t point : triangle) out << point_text(mesh.points[point].place, " ") << '\n';
  }
}

}  // namespace epsnet
