#include <algorithm>
#include <array>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/exchange/exchange.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/curves.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::mesh_export_test {
namespace {

using Point = Complex<double>;
using Writer = void (*)(const certify::NetDocument&, std::ostream&);

std::string text(Writer write, const certify::NetDocument& net) {
  std::ostringstream out;
  write(net, out);
  return out.str();
}

certify::NetDocument net_of(const char* epsilon) { return compute_net(random_octagon(123), Length(epsilon)).document; }

struct Off {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

Off read_off(const std::string& text) {
  std::istringstream in(text);
  std::string word;
  std::size_t points = 0;
  std::size_t triangles = 0;
  std::size_t zero = 0;
  in >> word >> points >> triangles >> zero;
  EXPECT_EQ(word, "OFF");
  Off result{std::vector<Point>(points), std::vector<std::array<std::size_t, 3>>(triangles)};
  double z = 0;
  for (Point& point : result.points) in >> point.x >> point.y >> z;
  std::size_t corners = 0;
  for (auto& triangle : result.triangles) in >> corners >> triangle[0] >> triangle[1] >> triangle[2];
  EXPECT_TRUE(in);
  in >> word;
  EXPECT_TRUE(in.eof());
  return result;
}

struct Edge {
  std::uint32_t u;
  std::uint32_t v;
  double length;
};

std::vector<Edge> read_edges(const std::string& text) {
  std::istringstream in(text);
  std::string header;
  std::getline(in, header);
  EXPECT_EQ(header, "u\tv\tlength");
  std::vector<Edge> result;
  for (Edge edge{}; in >> edge.u >> edge.v >> edge.length;) result.push_back(edge);
  EXPECT_TRUE(in.eof());
  return result;
}

/// Every edge of the surface is in the drawing, with its length; the drawing is a disk.
TEST(MeshExport, OffHasTheEdgesOfTheTable) {
  for (const char* epsilon : {"0.2", "0.5", "30"}) {
    const certify::NetDocument net = net_of(epsilon);
    const Off off = read_off(text(write_off, net));
    ASSERT_EQ(off.triangles.size(), net.triangles.size());
    std::set<std::pair<std::size_t, std::size_t>> drawn;
    std::vector<double> lengths;
    for (const auto& triangle : off.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto ends = std::minmax(triangle[i], triangle[(i + 1) % 3]);
        drawn.insert(ends);
        lengths.push_back(distance(off.points[ends.first], off.points[ends.second]));
      }
    }
    EXPECT_EQ(off.points.size() + off.triangles.size(), drawn.size() + 1);
    std::vector<double> expected;
    for (const Edge& edge : read_edges(text(write_edges, net))) expected.insert(expected.end(), 2, edge.length);
    std::sort(lengths.begin(), lengths.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_THAT(lengths, ::testing::Pointwise(::testing::DoubleNear(1e-7), expected));
  }
}

TEST(MeshExport, EdgesAgreeWithTheCertificate) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::chain(2), 3);
  coordinates.lengths.front() = 1e-6;
  const certify::NetDocument net = compute_net(fenchel_nielsen_surface(coordinates), Length("0.4")).document;
  const certify::Certificate certificate = certify::check(net);
  ASSERT_EQ(certificate.verdict, certify::Verdict::verified);
  double shortest_edge = 1e9;
  double shortest_loop = 1e9;
  double longest = 0;
  const std::vector<Edge> edges = read_edges(text(write_edges, net));
  EXPECT_EQ(edges.size(), certificate.counts.edges);
  for (const Edge& edge : edges) {
    double& least = edge.u == edge.v ? shortest_loop : shortest_edge;
    least = std::min(least, edge.length);
    longest = std::max(longest, edge.length);
  }
  EXPECT_NEAR(shortest_edge, certificate.enclosures->shortest_edge->lower, 1e-12);
  EXPECT_NEAR(shortest_loop / certificate.enclosures->shortest_loop->lower, 1, 1e-9);
  EXPECT_NEAR(longest, certificate.enclosures->longest_edge.upper, 1e-12);
}

TEST(MeshExport, VtuWithNumbersOfVerticesHasTheirArray) {
  const certify::NetDocument net = compute_net(random_octagon(1), Length("0.9")).document;
  std::ostringstream out;
  write_vtu_with({"distance", std::vector<double>(net.vertices.size(), 0.375)}, net, out);
  EXPECT_THAT(out.str(), ::testing::HasSubstr("Name=\"distance\" format=\"ascii\">\n0.375\n0.375\n"));
  EXPECT_THROW(write_vtu_with({"distance", {1}}, net, out), std::invalid_argument);
}

TEST(MeshExport, VtuCountsWhatIsThere) {
  const certify::NetDocument net = net_of("0.3");
  const std::string vtu = text(write_vtu, net);
  const Off off = read_off(text(write_off, net));
  EXPECT_THAT(vtu, ::testing::HasSubstr("NumberOfPoints=\"" + std::to_string(off.points.size()) +
                                        "\" NumberOfCells=\"" + std::to_string(off.triangles.size()) + "\""));
  const auto lines = static_cast<std::size_t>(std::count(vtu.begin(), vtu.end(), '\n'));
  EXPECT_EQ(lines, 3 * off.points.size() + 7 * off.triangles.size() + 35);
}

/// The text between "$name" and "$Endname".
std::istringstream section(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find("$" + name + "\n");
  const std::size_t end = text.find("$End" + name);
  EXPECT_TRUE(begin != std::string::npos && end != std::string::npos) << name;
  return std::istringstream(text.substr(begin + name.size() + 2, end - begin - name.size() - 2));
}

/// Nodes are the vertices; every element has its triangle in coordinates of its own.
TEST(MeshExport, GluedGmshIsTheSurface) {
  const certify::NetDocument net = net_of("0.3");
  const NetGeometry geometry(net);
  const std::string msh = text(write_gmsh_glued, net);
  std::size_t count = 0;
  section(msh, "Nodes") >> count;
  EXPECT_EQ(count, net.vertices.size());
  std::istringstream elements = section(msh, "Elements");
  elements >> count;
  ASSERT_EQ(count, net.triangles.size());
  std::istringstream data = section(msh, "ElementData");
  std::string line;
  for (int i = 0; i < 8; ++i) std::getline(data, line);
  for (std::uint32_t t = 0; t < count; ++t) {
    std::array<std::uint64_t, 5> kind{};
    for (std::uint64_t& x : kind) elements >> x;
    EXPECT_EQ(kind, (std::array<std::uint64_t, 5>{t + 1, 2, 2, 1, 1}));
    for (const std::uint32_t v : net.triangles[t].vertex) {
      std::uint64_t node = 0;
      elements >> node;
      EXPECT_EQ(node, v + 1);
    }
    std::size_t number = 0;
    data >> number;
    EXPECT_EQ(number, t + 1);
    std::array<Point, 3> corner;
    double zero = 0;
    for (Point& z : corner) data >> z.x >> z.y >> zero;
    EXPECT_TRUE(data && elements);
    for (std::uint32_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(distance(corner[i], corner[(i + 1) % 3]), geometry.edge_length(3 * t + i), 1e-12);
    }
  }
}

/// A planar mesh as Medit's file has it; indices count from 0 on.
struct Medit {
  std::vector<Point> points;
  std::vector<std::size_t> vertex;
  std::vector<std::array<std::size_t, 3>> edges;  ///< Ends and side.
  std::vector<std::array<std::size_t, 3>> triangles;
  std::set<std::pair<std::size_t, std::size_t>> glued;  ///< Sides, the smaller first.
};

Medit read_medit(const std::string& text) {
  Medit result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string comment, is, glued, to;
    std::size_t first = 0;
    std::size_t second = 0;
    if (words >> comment >> is >> first >> glued >> glued >> to >> to >> second && comment == "#")
      result.glued.emplace(first - 1, second - 1);
    std::size_t count = 0;
    if (line == "Vertices") {
      in >> count;
      result.points.resize(count);
      result.vertex.resize(count);
      for (std::size_t i = 0; i < count; ++i) in >> result.points[i].x >> result.points[i].y >> result.vertex[i];
      for (std::size_t& vertex : result.vertex) --vertex;
    } else if (line == "Edges" || line == "Triangles") {
      auto& rows = line == "Edges" ? result.edges : result.triangles;
      in >> count;
      rows.resize(count);
      std::size_t label = 0;
      for (auto& row : rows) {
        for (std::size_t& x : row) {
          in >> x;
          --x;
        }
        if (line == "Triangles") in >> label;
      }
    }
  }
  return result;
}

/// The sides bound the polygon, in this order; one isometry takes a side to its partner, with the same vertices.
TEST(MeshExport, MeditIsAPolygonWithGluedSides) {
  const Surface klein = fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(3), 1));
  for (const certify::NetDocument& net : {net_of("0.3"), net_of("2"), compute_net(klein, Length("0.4")).document}) {
    const Medit mesh = read_medit(text(write_medit, net));
    ASSERT_EQ(mesh.triangles.size(), net.triangles.size());
    ASSERT_FALSE(mesh.edges.empty());
    std::vector<std::vector<std::size_t>> sides;
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
      EXPECT_EQ(mesh.edges[i][1], mesh.edges[(i + 1) % mesh.edges.size()][0]);
      if (sides.size() == mesh.edges[i][2]) sides.push_back({mesh.edges[i][0]});
      ASSERT_EQ(sides.size(), mesh.edges[i][2] + 1);
      sides.back().push_back(mesh.edges[i][1]);
    }
    ASSERT_EQ(mesh.glued.size() * 2, sides.size());
    EXPECT_GE(sides.size(), 4 * NetGeometry(net).genus());
    std::set<std::size_t> seen;
    for (const auto& [first, second] : mesh.glued) {
      seen.insert({first, second});
      const std::vector<std::size_t>& side = sides[first];
      std::vector<std::size_t> partner(sides[second].rbegin(), sides[second].rend());
      ASSERT_EQ(side.size(), partner.size());
      for (std::size_t i = 0; i < side.size(); ++i) {
        EXPECT_EQ(mesh.vertex[side[i]], mesh.vertex[partner[i]]);
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_NEAR(distance(mesh.points[side[i]], mesh.points[side[j]]),
                      distance(mesh.points[partner[i]], mesh.points[partner[j]]), 1e-6);
        }
      }
    }
    EXPECT_EQ(seen.size(), sides.size());
    for (const auto& [a, b, c] : mesh.triangles)
      EXPECT_GT(cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]), 0);
  }
}

/// Gmsh's file has the same mesh: as many nodes of each corner, side and inside, and the nodes of every pair of sides.
TEST(MeshExport, GmshHasTheSidesOfMedit) {
  const certify::NetDocument net = net_of("0.3");
  const Medit mesh = read_medit(text(write_medit, net));
  const std::string msh = text(write_gmsh, net);
  std::size_t corners = 0;
  std::size_t curves = 0;
  section(msh, "Entities") >> corners >> curves;
  EXPECT_EQ(corners, 2 * mesh.glued.size());
  EXPECT_EQ(curves, corners);
  std::size_t blocks = 0;
  std::size_t nodes = 0;
  section(msh, "Nodes") >> blocks >> nodes;
  EXPECT_EQ(nodes, mesh.points.size());
  EXPECT_EQ(blocks, 2 * curves + 1);
  std::size_t elements = 0;
  section(msh, "Elements") >> blocks >> elements;
  EXPECT_EQ(elements, mesh.triangles.size() + mesh.edges.size());
  std::size_t pairs = 0;
  section(msh, "Periodic") >> pairs;
  EXPECT_EQ(pairs, mesh.glued.size());
}

/// Elements have the vertices of the net, and the corners of a lift as nodes of their own.
TEST(MeshExport, MfemIsGluedWithDiscontinuousNodes) {
  const certify::NetDocument net = net_of("0.1");
  const Medit mesh = read_medit(text(write_medit, net));
  const std::string mfem = text(write_mfem, net);
  std::istringstream in(mfem.substr(mfem.find("elements\n") + 9));
  std::size_t count = 0;
  in >> count;
  ASSERT_EQ(count, net.triangles.size());
  for (const certify::NetDocument::Triangle& triangle : net.triangles) {
    std::array<std::size_t, 5> row{};
    for (std::size_t& x : row) in >> x;
    EXPECT_EQ(row, (std::array<std::size_t, 5>{1, 2, triangle.vertex[0], triangle.vertex[1], triangle.vertex[2]}));
  }
  std::istringstream nodes(mfem.substr(mfem.find("Ordering: 1\n") + 12));
  for (const auto& triangle : mesh.triangles) {
    for (const std::size_t point : triangle) {
      Point z;
      nodes >> z.x >> z.y;
      EXPECT_EQ(z, mesh.points[point]);
    }
  }
  EXPECT_TRUE(nodes);
  EXPECT_THROW(text(write_mfem, net_of("2")), ExchangeError);
}

/// Angles of the triangles that finite elements get are at least arcsin(1/(2 cosh(eps/2))).
TEST(MeshExport, CentredCornersHaveNoSmallAngles) {
  for (const char* epsilon : {"0.1", "0.3", "0.5"}) {
    const certify::NetDocument net = net_of(epsilon);
    const NetGeometry geometry(net);
    const double least = 1 / (2 * std::cosh(geometry.epsilon().get_d() / 2));
    for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
      const auto z = geometry.centred_corners(t);
      for (std::uint32_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(std::sqrt(norm(z[i])), std::tanh(geometry.circumradius(t) / 2), 1e-12);
        if (net.triangles[t].vertex[(i + 1) % 3] == net.triangles[t].vertex[(i + 2) % 3]) continue;
        const Point u = z[(i + 1) % 3] - z[i];
        const Point v = z[(i + 2) % 3] - z[i];
        EXPECT_GE(cross(u, v) / std::sqrt(norm(u) * norm(v)), least - 1e-12);
      }
    }
  }
}

TEST(MeshExport, RefusesWhatIsNoNet) {
  certify::NetDocument net = net_of("0.5");
  net.triangles[0].vertex[1] = 1000000;
  for (const Writer write :
       {write_off, write_vtu, write_gmsh, write_gmsh_glued, write_medit, write_mfem, write_edges, write_mesh_json})
    EXPECT_THROW(text(write, net), NetGeometryError);
}

/// The length of what arcs show, each in the chart of its triangle.
double total_length(const Layer& layer) {
  double sum = 0;
  for (const Arc& arc : layer.arcs) sum += distance(arc.from, arc.to);
  return sum;
}

TEST(Curves, TilesAreCutWithoutLoss) {
  const Surface surface = random_octagon(123);
  double perimeter = 0;
  const Tile& tile = surface.tiles()[0];
  for (std::size_t k = 0; k < tile.size(); ++k)
    perimeter += distance(convert<double>(tile[k]), convert<double>(tile[(k + 1) % tile.size()]));
  for (const char* epsilon : {"0.1", "0.5"}) {
    const certify::NetDocument net = compute_net(surface, Length(epsilon)).document;
    const Layer layer = tile_layer(NetGeometry(net));
    EXPECT_NEAR(total_length(layer), perimeter / 2, 1e-9);
    EXPECT_GT(layer.arcs.size(), perimeter / 2 / (2 * std::stod(epsilon)));
  }
}

/// The corners of a triangle in the chart of the corner where a dart starts.
std::array<Point, 3> corners_in_chart_of(const NetGeometry& geometry, std::uint32_t dart) {
  std::array<Point, 3> corners = geometry.corners(dart / 3);
  const Isometry<double> back = inverse(geometry.label(certify::corner_label(geometry.document(), dart)).rounded);
  for (Point& corner : corners) corner = back(corner);
  return corners;
}

TEST(Curves, ArcsAreInTheirTriangles) {
  const certify::NetDocument net = net_of("0.3");
  const NetGeometry geometry(net);
  const Layer layer = dirichlet_layer(geometry, 0);
  EXPECT_FALSE(layer.arcs.empty());
  for (const Arc& arc : layer.arcs) {
    const auto corners = corners_in_chart_of(geometry, arc.dart);
    for (const Point& end : {arc.from, arc.to}) {
      for (std::size_t i = 0; i < 3; ++i) {
        // Seen from the corner a side is straight.
        const Isometry<double> to_corner = Isometry<double>::translation(-corners[i]);
        EXPECT_GT(cross(to_corner(corners[(i + 1) % 3]), to_corner(end)), -1e-9);
      }
    }
  }
}

TEST(Curves, ShortestGeodesicsHaveALayerOfTheirOwn) {
  const certify::GeodesicsDocument spectrum = unproved::spectrum(random_octagon(123), Length("3.5"));
  const std::size_t shortest = spectrum.clusters.at(0).count;
  ASSERT_LT(shortest, spectrum.geodesics.size());
  const std::vector<Layer> layers = geodesics_layers(spectrum.net, spectrum);
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0].name, "shortest closed geodesics");
  EXPECT_EQ(layers[0].parts.size(), shortest);
  EXPECT_EQ(layers[1].parts.size(), spectrum.geodesics.size() - shortest);
  EXPECT_NE(layers[0].colour, layers[1].colour);
  // Numbers are those of the file, and one alone looks the same.
  const std::size_t last = spectrum.geodesics.size() - 1;
  EXPECT_EQ(layers[1].parts.back().name.substr(0, 9 + std::to_string(last).size()), "geodesic " + std::to_string(last));
  const Layer alone = geodesic_layer(spectrum.net, spectrum, last);
  EXPECT_EQ(alone.colour, layers[1].colour);
  ASSERT_EQ(alone.parts.size(), 1U);
  EXPECT_EQ(alone.parts[0].name, layers[1].parts.back().name);
  EXPECT_EQ(geodesic_layer(spectrum.net, spectrum, 0).colour, layers[0].colour);
  const std::vector<Layer> systole = geodesics_layers(spectrum.net, unproved::systole(random_octagon(123)));
  ASSERT_EQ(systole.size(), 1U);
  EXPECT_EQ(systole[0].colour, layers[0].colour);
}

TEST(Curves, AClosedGeodesicIsCutWithoutLossOnAnyNetOfItsSurface) {
  const certify::NetDocument net = net_of("0.3");
  const NetGeometry geometry(net);
  certify::GeodesicsDocument geodesics;
  geodesics.net = net_of("0.7");
  const Parts<Mp256> parts(net, geometry.sides());
  for (std::uint32_t side = 0; side < 8; ++side) {
    // One tile: every side is a loop.
    geodesics.geodesics = {{.vertex = 1, .word = {side}}};
    const Layer layer = geodesics_layers(geometry, geodesics)[0];
    EXPECT_NEAR(total_length(layer), displacement_length(convert<double>(parts.crossings[side])), 1e-9);
  }
  geodesics.geodesics = {{.vertex = 0, .word = {}}};
  EXPECT_THROW((void)geodesics_layers(geometry, geodesics), NetGeometryError);
  geodesics.net = compute_net(random_octagon(1), Length("0.7")).document;
  EXPECT_THROW((void)geodesics_layers(geometry, geodesics), NetGeometryError);
}

}  // namespace
}  // namespace epsnet::mesh_export_test
