#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include "certify/net/numbering.h"
#include "netgen/exchange/drawn_mesh.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"

namespace epsnet {
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
