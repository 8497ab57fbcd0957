#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <optional>
#include <rapidcheck/gtest.h>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/lifts/info.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/nets/refine.h"
#include "netgen/pictures/curves.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"
#include "tests/support/triangulations.h"

namespace epsnet::draw_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

using Point = Complex<double>;

certify::NetDocument verified(const char* name) {
  return certify::read_file<certify::NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

certify::NetDocument octagon_net(std::int32_t seed, const char* epsilon) {
  return compute_net(random_octagon(seed), Length(epsilon)).document;
}

certify::NetDocument polygon_net(const char* name, const char* epsilon) {
  return compute_net(test::imported(std::string(EPSNET_TEST_DATA) + "/polygons/" + name), Length(epsilon)).document;
}

// What keeps a reference cannot be made from a temporary.
static_assert(std::is_constructible_v<NetGeometry, const certify::NetDocument&>);
static_assert(!std::is_constructible_v<NetGeometry, certify::NetDocument>);
static_assert(!std::is_constructible_v<NetGeometry, const certify::NetDocument>);

double euclidean(const Point& u, const Point& v) { return std::sqrt(norm(u - v)); }

/// The area of a hyperbolic triangle by its angles.
double area(const std::array<Point, 3>& z) {
  double angles = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Isometry<double> to_corner = Isometry<double>::translation(-z[i]);
    const Point u = to_corner(z[(i + 1) % 3]);
    const Point v = to_corner(z[(i + 2) % 3]);
    angles += std::atan2(cross(u, v), dot(u, v));
  }
  return std::numbers::pi - angles;
}

/// Checks what must hold for the lifts of any verified net.
void expect_good_lifts(const certify::NetDocument& net, DrawOrder order) {
  const NetGeometry geometry(net);
  const Lifts lifts = lift_triangles(geometry, order);
  ASSERT_EQ(lifts.lifted.size(), net.triangles.size());
  double total = 0;
  std::size_t at_centre = 0;
  for (std::size_t i = 0; i < lifts.lifted.size(); ++i) {
    const auto& [triangle, placement, corner] = lifts.lifted[i];
    EXPECT_EQ(lifts.place[triangle], i);
    total += area(corner);
    const auto in_chart = geometry.corners(triangle);
    bool attached = i == 0;
    for (std::size_t k = 0; k < 3; ++k) {
      // Lifting is an isometry.
      EXPECT_NEAR(
          sinh2_half_distance(corner[k], corner[(k + 1) % 3]) / sinh2_half_distance(in_chart[k], in_chart[(k + 1) % 3]),
          1, 1e-6);
      // Every triangle but the first shares an edge with an earlier one.
      const std::uint32_t other = net.triangles[triangle].opposite[k];
      const auto& neighbour = lifts.lifted[lifts.place[other / 3]].corner;
      if (lifts.place[other / 3] < i && euclidean(neighbour[other % 3], corner[(k + 1) % 3]) < 1e-9 &&
          euclidean(neighbour[(other + 1 - other / 3 * 3) % 3], corner[k]) < 1e-9) {
        attached = true;
      }
      at_centre += net.triangles[triangle].vertex[k] == 0 && norm(corner[k]) < 1e-20 ? 1 : 0;
    }
    EXPECT_TRUE(attached) << "triangle " << triangle;
  }
  EXPECT_GE(at_centre, 1U);
  EXPECT_NEAR(total, 4 * std::numbers::pi * (geometry.genus() - 1.0), 1e-6);
}

TEST(Lifts, AreConnectedIsometricAndFillTheSurface) {
  for (const DrawOrder order : {DrawOrder::weight, DrawOrder::breadth_first}) {
    expect_good_lifts(verified("octagon-1-vertex.json"), order);
    expect_good_lifts(verified("octagon-33-vertices.json"), order);
    expect_good_lifts(verified("square-of-cocircular-vertices.json"), order);
    expect_good_lifts(octagon_net(123, "0.2"), order);
  }
}

TEST(Lifts, SurviveThinPartsAndHighGenus) {
  expect_good_lifts(polygon_net("polygon-g2-thin-1e-4.txt", "0.5"), DrawOrder::weight);
  expect_good_lifts(polygon_net("polygon-g10-rnd0.txt", "0.7"), DrawOrder::weight);
}

TEST(Lifts, ByWeightTakeTheEdgeOfLeastWeight) {
  const certify::NetDocument net = octagon_net(5, "0.4");
  const NetGeometry geometry(net);
  const Lifts lifts = lift_triangles(geometry, DrawOrder::weight);
  for (std::size_t i = 1; i < lifts.lifted.size(); ++i) {
    // The next triangle is across the lightest of all edges between a lifted triangle and one that is not.
    double least = 2;
    double taken = 2;
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [triangle, placement, corner] = lifts.lifted[j];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = net.triangles[triangle].opposite[k] / 3;
        if (lifts.place[other] < i) continue;
        const double weight = norm(corner[k]) + norm(corner[(k + 1) % 3]);
        least = std::min(least, weight);
        if (lifts.place[other] == i) taken = std::min(taken, weight);
      }
    }
    EXPECT_DOUBLE_EQ(taken, least) << "lift " << i;
  }
}

TEST(Lifts, BreadthFirstOrderIsByEdgesCrossed) {
  const certify::NetDocument net = octagon_net(5, "0.4");
  const Lifts lifts = lift_triangles(NetGeometry(net), DrawOrder::breadth_first);
  std::vector<std::uint32_t> depth(net.triangles.size(), 0xffffffff);
  depth[lifts.lifted[0].triangle] = 0;
  for (const auto& lifted : lifts.lifted) {
    for (const std::uint32_t opposite : net.triangles[lifted.triangle].opposite)
      depth[opposite / 3] = std::min(depth[opposite / 3], depth[lifted.triangle] + 1);
  }
  EXPECT_TRUE(std::is_sorted(lifts.lifted.begin(), lifts.lifted.end(),
                             [&](const auto& s, const auto& t) { return depth[s.triangle] < depth[t.triangle]; }));
}

/// The vertices of a Dirichlet domain are the circumcentres of the Delaunay triangles around the base point (thesis
/// IV.5), in the triangulation whose only vertex it is; so the distances to the base are circumradii, each three times.
void expect_circumcentres(const certify::NetDocument& net) {
  ASSERT_EQ(net.vertices.size(), 1U);
  const NetGeometry geometry(net);
  std::vector<double> expected;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const auto z = geometry.corners(t);
    const auto radius = sinh2_circumradius(z[0], z[1], z[2]);
    expected.insert(expected.end(), 3, radius.numerator / radius.denominator);
  }
  std::vector<double> found;
  for (const Point& z : dirichlet_domain(geometry, 0)) {
    const double s = sinh2_half_distance(Point{}, z);
    found.push_back(4 * s * (1 + s));  // sinh² d
  }
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i] / expected[i], 1, 1e-5);
}

TEST(DirichletDomain, VerticesAreCircumcentres) {
  expect_circumcentres(verified("octagon-1-vertex.json"));
  expect_circumcentres(verified("g2-small-1-vertex.json"));
  for (const std::int32_t seed : {1, 2, 3, 123, 321}) expect_circumcentres(octagon_net(seed, "20"));
  expect_circumcentres(polygon_net("polygon-g3-rnd0.txt", "20"));
  expect_circumcentres(polygon_net("polygon-g10-rnd0.txt", "30"));
}

/// The area of a polygon around 0, counterclockwise.
double area_of_polygon(const std::vector<Point>& corners) {
  double total = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    // For a triangle with corners 0, u, v: tan(area/2) = Im(ūv)/(1 − Re(ūv)).
    const Point& u = corners[i];
    const Point& v = corners[(i + 1) % corners.size()];
    total += 2 * std::atan2(cross(u, v), 1 - dot(u, v));
  }
  return total;
}

/// Some lifts of a vertex, around one of them at 0 with directions as in its chart, none of these at 0: the images of
/// 0 under the isometries that glue the sides of the drawn triangles.
std::vector<Point> other_lifts(const NetGeometry& geometry, std::uint32_t vertex) {
  const certify::NetDocument& net = geometry.document();
  const Lifts lifts = lift_triangles(geometry, DrawOrder::weight, vertex);
  const std::vector<bool> on_boundary = boundary_darts(geometry, lifts);
  const auto placement = [&](std::uint32_t triangle) {
    return lifts.placements[lifts.lifted[lifts.place[triangle]].placement[0]].precise;
  };
  std::vector<Point> result;
  for (std::uint32_t dart = 0; dart < on_boundary.size(); ++dart) {
    if (!on_boundary[dart]) continue;
    const Placement beyond = neighbour(geometry, {dart / 3, placement(dart / 3)}, dart % 3);
    const Isometry<Mp256> g = beyond.isometry * inverse(placement(certify::opposite(net, dart) / 3));
    result.push_back(convert<double>(g(Complex<Mp256>{})));
  }
  return result;
}

/// A polygon of the area of the surface whose corners are nowhere nearer to other lifts of the vertex than to 0 is its
/// Dirichlet domain, turned the right way.
void expect_dirichlet_domain(const certify::NetDocument& net, std::uint32_t vertex) {
  const NetGeometry geometry(net);
  const std::vector<Point> domain = dirichlet_domain(geometry, vertex);
  EXPECT_NEAR(area_of_polygon(domain), 4 * std::numbers::pi * (geometry.genus() - 1.0), 1e-6);
  for (std::size_t i = 0; i < domain.size(); ++i) EXPECT_GE(cross(domain[i], domain[(i + 1) % domain.size()]), 0);
  const std::vector<Point> lifts = other_lifts(geometry, vertex);
  EXPECT_GE(lifts.size(), 8U);
  for (const Point& z : domain) {
    for (const Point& lift : lifts)
      EXPECT_LE(sinh2_half_distance(Point{}, z), sinh2_half_distance(lift, z) * (1 + 1e-6)) << "vertex " << vertex;
  }
}

TEST(DirichletDomain, IsNearestToItsVertexForAnyVertex) {
  for (const certify::NetDocument& net :
       {octagon_net(123, "0.5"), polygon_net("polygon-g3-rnd0.txt", "0.8"),
        compute_net(fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(3), 1)), Length("0.8")).document,
        compute_net(Surface::regular(2), Length("0.8")).document}) {
    // The corners of tiles come first; the last vertices may lie in any tile.
    const auto count = static_cast<std::uint32_t>(net.vertices.size());
    for (const std::uint32_t vertex : {0U, 1U, 2U, 3U, count / 2, count - 1}) expect_dirichlet_domain(net, vertex);
  }
}

TEST(DirichletDomain, HasTheAreaOfTheSurfaceForAnyVertex) {
  for (const char* name : {"polygon-g2-thin-1e-4.txt", "polygon-g2-thin-1e-8.txt", "polygon-g4-treeloops.txt"}) {
    const certify::NetDocument net = polygon_net(name, "0.6");
    const NetGeometry geometry(net);
    for (const std::uint32_t vertex : {0U, static_cast<std::uint32_t>(net.vertices.size() / 2)}) {
      const std::vector<Point> domain = dirichlet_domain(geometry, vertex);
      EXPECT_NEAR(area_of_polygon(domain), 4 * std::numbers::pi * (geometry.genus() - 1.0), 1e-6) << name;
      for (std::size_t i = 0; i < domain.size(); ++i) EXPECT_GE(cross(domain[i], domain[(i + 1) % domain.size()]), 0);
    }
  }
}

TEST(DirichletDomain, OfASurfaceThatIsNoneIsRefused) {
  certify::NetDocument net = octagon_net(123, "0.5");
  net.surface.tiles[0][2].x += mpq_class(1, 1000);
  const NetGeometry geometry(net);
  EXPECT_THAT([&] { return dirichlet_domain(geometry, 0); }, ThrowsMessage<NetGeometryError>(HasSubstr("side")));
  EXPECT_THROW((void)dirichlet_domain(geometry, 1'000'000), NetGeometryError);
}

TEST(DirichletDomain, OfAHighGenusIsRefused) {
  const certify::NetDocument net =
      compute_net(fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(101), 1)), Length("2")).document;
  EXPECT_THAT([&] { return dirichlet_domain(NetGeometry(net), 0); },
              ThrowsMessage<NetGeometryError>(HasSubstr("up to genus 100")));
}

RC_GTEST_PROP(DirichletDomainProperty, ClosesForAnyVertexOfAnyOctagon, ()) {
  const certify::NetDocument net = octagon_net(*rc::gen::inRange(1, 1000), "0.5");
  const auto vertex = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(net.vertices.size()));
  const NetGeometry geometry(net);
  const std::vector<Point> domain = dirichlet_domain(geometry, vertex);
  RC_ASSERT(std::abs(area_of_polygon(domain) - 4 * std::numbers::pi) < 1e-6);
  RC_ASSERT(domain.size() >= 8 && domain.size() <= 18);
}

// ---- The picture ----

/// Numbers of an SVG path whose letters are m, l, a, h, z, in absolute coordinates: for each arc its ends, radius and
/// sweep.
struct SvgArc {
  std::complex<double> from;
  std::complex<double> to;
  double radius;
  bool sweep;
};

class PathReader {
 public:
  explicit PathReader(const std::string& data) : data_(data) {}

  std::vector<SvgArc> arcs() {
    std::vector<SvgArc> result;
    char command = ' ';
    std::complex<double> start;
    while (at_ < data_.size()) {
      if (std::isalpha(static_cast<unsigned char>(data_[at_])) != 0) command = data_[at_++];
      if (command == 'z') {
        pen_ = start;
      } else if (command == 'h') {
        pen_ += number();
      } else if (command == 'a') {
        const double radius = number();
        EXPECT_EQ(number(), radius);
        EXPECT_EQ(number(), 0);  // rotation
        EXPECT_EQ(number(), 0);  // geodesics are the smaller arcs
        const bool sweep = number() == 1;
        const std::complex<double> from = pen_;
        pen_ += pair();
        result.push_back({from, pen_, radius, sweep});
      } else {
        pen_ += pair();
        if (command == 'm') {
          start = pen_;
          command = 'l';
        }
      }
    }
    return result;
  }

 private:
  double number() {
    std::size_t length = 0;
    const double x = std::stod(data_.substr(at_, 30), &length);
    at_ += length;
    return x;
  }
  std::complex<double> pair() {
    const double x = number();
    return {x, number()};
  }

  const std::string& data_;
  std::size_t at_ = 0;
  std::complex<double> pen_;
};

std::vector<SvgArc> arcs_of(const std::string& svg) {
  std::vector<SvgArc> result;
  for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 1)) {
    const std::string data = svg.substr(at + 4, svg.find('"', at + 4) - at - 4);
    const std::vector<SvgArc> arcs = PathReader(data).arcs();
    result.insert(result.end(), arcs.begin(), arcs.end());
  }
  return result;
}

TEST(Draw, ArcsAreOrthogonalToTheBoundaryCircle) {
  const DrawOptions options{.order = DrawOrder::weight, .dirichlet = true, .size = 1000};
  const std::vector<SvgArc> arcs = arcs_of(draw_svg(verified("octagon-33-vertices.json"), options));
  ASSERT_GT(arcs.size(), 100U);
  std::size_t tested = 0;
  for (const SvgArc& arc : arcs) {
    const std::complex<double> chord = arc.to - arc.from;
    if (std::abs(chord) < 20) continue;  // Places are rounded to hundredths of a pixel.
    const double height = std::sqrt(arc.radius * arc.radius - std::norm(chord) / 4);
    // In these coordinates y points down, so sweep 1 means positive angles, with the centre to the left of the chord.
    const std::complex<double> to_centre = chord / std::abs(chord) * std::complex<double>(0, arc.sweep ? 1 : -1);
    const std::complex<double> centre = (arc.from + arc.to) / 2.0 + height * to_centre - std::complex<double>(500, 500);
    EXPECT_NEAR(std::norm(centre) / (485.0 * 485 + arc.radius * arc.radius), 1, 0.02);
    ++tested;
  }
  EXPECT_GT(tested, 50U);
}

TEST(Draw, IsDeterministicAndDependsOnItsOptions) {
  const certify::NetDocument net = octagon_net(123, "0.3");
  std::set<std::string> pictures;
  for (const DrawOrder order : {DrawOrder::weight, DrawOrder::breadth_first}) {
    for (const bool dirichlet : {false, true}) {
      for (const std::uint32_t size : {300U, 1000U}) {
        const DrawOptions options{.order = order, .dirichlet = dirichlet, .size = size};
        const std::string picture = draw_svg(net, options);
        EXPECT_EQ(picture, draw_svg(net, options));
        EXPECT_THAT(picture, HasSubstr("width=\"" + std::to_string(size) + "\""));
        EXPECT_EQ(picture.find("nan"), std::string::npos);
        EXPECT_EQ(picture.find("inf"), std::string::npos);
        pictures.insert(picture);
      }
    }
  }
  EXPECT_EQ(pictures.size(), 8U);
}

TEST(Draw, ValuesColourTrianglesInBands) {
  const certify::NetDocument net = octagon_net(123, "0.3");
  DrawOptions options{.colouring = Colouring::values, .legend = true};
  EXPECT_THROW((void)draw_svg(net, options), std::invalid_argument);
  options.values.assign(net.vertices.size(), 0.0);
  options.values_name = "height";
  const auto colours = [&] {
    const std::string picture = draw_svg(net, options);
    const std::size_t first = picture.find("<g class=\"colours\"");
    const std::string group = picture.substr(first, picture.find("</g>", first) - first);
    std::size_t count = 0;
    for (std::size_t at = group.find("<path"); at != std::string::npos; at = group.find("<path", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(colours(), 1U);
  options.values[0] = 2;  // Around one vertex, of which every other corner is 0: a third of the greatest.
  EXPECT_EQ(colours(), 2U);
  EXPECT_THAT(draw_svg(net, options), HasSubstr(">height 1.50<"));
  for (std::size_t v = 0; v < options.values.size(); ++v) options.values[v] = static_cast<double>(v);
  std::set<std::size_t> bands;  // 24, by the mean of a triangle's corners as a share of the greatest value.
  for (const certify::NetDocument::Triangle& triangle : net.triangles) {
    const std::size_t sum = std::size_t{triangle.vertex[0]} + triangle.vertex[1] + triangle.vertex[2];
    bands.insert(24 * sum / (3 * (net.vertices.size() - 1)));
  }
  EXPECT_EQ(colours(), bands.size());
}

TEST(Draw, ShowsWhatIsAskedFor) {
  const certify::NetDocument net = octagon_net(123, "0.3");
  const std::string plain = draw_svg(net);
  const auto expect_changed = [&](const char* what, const char* mark, const auto& change) {
    DrawOptions options;
    change(options);
    const std::string picture = draw_svg(net, options);
    EXPECT_NE(picture, plain) << what;
    EXPECT_THAT(picture, HasSubstr(mark));
    EXPECT_EQ(picture.find("nan"), std::string::npos) << what;
  };
  expect_changed("combinatorial", "class=\"combinatorial-dirichlet\"",
                 [](DrawOptions& o) { o.combinatorial_dirichlet = true; });
  expect_changed("covering", "class=\"covering\"", [](DrawOptions& o) { o.covering_disks = true; });
  expect_changed("packing", "class=\"packing\"", [](DrawOptions& o) { o.packing_disks = true; });
  expect_changed("radii", "class=\"colours\"", [](DrawOptions& o) { o.colouring = Colouring::circumradius; });
  expect_changed("charts", "class=\"colours\"", [](DrawOptions& o) { o.colouring = Colouring::chart; });
  expect_changed("legend", "class=\"legend\"", [](DrawOptions& o) { o.legend = true; });
  expect_changed("tiles", "<title>fundamental tiles</title>",
                 [&](DrawOptions& o) { o.layers.push_back(tile_layer(net)); });
  expect_changed("escapes", "<title>a&lt;b&amp;c</title>",
                 [](DrawOptions& o) { o.layers.push_back({.name = "a<b&c", .colour = "#123456", .triangles = {0}}); });
  EXPECT_THAT(plain, HasSubstr("class=\"edges\""));
  EXPECT_THAT(plain, HasSubstr("class=\"vertices\""));
  EXPECT_THAT(draw_svg(net, {.triangles = false}), Not(HasSubstr("class=\"edges\"")));
  EXPECT_THAT(draw_svg(net, {.vertices = false}), Not(HasSubstr("class=\"vertices\"")));
}

/// The values of an attribute, in the order of the text.
std::vector<std::string> values_of(const std::string& text, const std::string& attribute) {
  std::vector<std::string> result;
  const std::string mark = attribute + "=\"";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1))
    result.push_back(text.substr(at + mark.size(), text.find('"', at + mark.size()) - at - mark.size()));
  return result;
}

std::string legend_of(const std::string& picture) {
  const std::size_t from = picture.find("<g class=\"legend\">");
  EXPECT_NE(from, std::string::npos);
  return picture.substr(from);
}

/// Returns CIELAB coordinates of "#rrggbb" (sRGB, D65); distances are about proportional to visible differences.
std::array<double, 3> lab(const std::string& colour) {
  std::array<double, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    rgb[i] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  }
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.95047);
  const double y = f(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
  const double z = f((0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// A pseudo net with a collar, its small curves and every other layer.
struct EverythingShown {
  EverythingShown() {
    FenchelNielsen coordinates = random_coordinates(PantsGraph::chain(2), 1);
    test::set_cuff_length(coordinates, 0, Rational(1, 10));
    const Surface surface = fenchel_nielsen_surface(coordinates);
    net = compute_net(surface, Length("0.3"), {.pseudo = true}).document;
    const NetGeometry geometry(net);
    options.dirichlet = options.combinatorial_dirichlet = true;
    options.covering_disks = options.packing_disks = true;
    options.legend = true;
    options.layers = collar_layers(geometry);
    options.layers.push_back(tile_layer(geometry));
    for (Layer& layer : geodesics_layers(geometry, unproved::thick_thin(surface))) options.layers.push_back(layer);
    options.layers.push_back(geodesics_layers(geometry, unproved::systole(surface))[0]);
  }
  certify::NetDocument net;
  DrawOptions options;
};

TEST(Draw, IsOnWhiteSoThatItCanBeReadOnADarkPage) {
  const std::string picture = draw_svg(octagon_net(123, "0.3"), {.size = 300});
  const std::size_t background =
      picture.find("<rect class=\"background\" width=\"300\" height=\"300\" fill=\"#ffffff\"/>");
  ASSERT_NE(background, std::string::npos);
  for (const char* drawn : {"<circle", "<path"}) EXPECT_GT(picture.find(drawn), background) << drawn;
}

TEST(Draw, ColoursOfALegendDiffer) {
  const EverythingShown shown;
  const std::string legend = legend_of(draw_svg(shown.net, shown.options));
  const std::string marks = legend.substr(0, legend.find("<g font"));
  std::vector<std::string> colours = values_of(marks, "fill");
  for (const std::string& colour : values_of(marks, "stroke")) colours.push_back(colour);
  ASSERT_GE(colours.size(), 12U) << legend;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto a = lab(colours[i]);
      const auto b = lab(colours[j]);
      EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 15) << colours[i] << " and " << colours[j];
    }
  }
}

TEST(Draw, WhatALegendNamesIsDrawnInItsColour) {
  const EverythingShown shown;
  const std::string picture = draw_svg(shown.net, shown.options);
  const std::string legend = legend_of(picture);
  const std::string drawn = picture.substr(0, picture.size() - legend.size());
  const std::string marks = legend.substr(0, legend.find("<g font"));
  for (const char* attribute : {"fill", "stroke"}) {
    for (const std::string& colour : values_of(marks, attribute))
      EXPECT_THAT(drawn, HasSubstr('"' + colour + '"')) << "nothing is drawn in " << colour;
  }
}

TEST(Draw, ALegendCountsGeodesicsAndSaysHowLongTheyAre) {
  const EverythingShown shown;
  const Layer& geodesics = *std::find_if(shown.options.layers.begin(), shown.options.layers.end(),
                                         [](const Layer& layer) { return layer.name == "closed geodesics"; });
  const std::size_t count = geodesics.parts.size();
  ASSERT_GT(count, 0U);
  EXPECT_THAT(legend_of(draw_svg(shown.net, shown.options)),
              HasSubstr(">closed geodesics: " + std::to_string(count) + " of length"));
  EXPECT_THAT(legend_of(draw_svg(shown.net, shown.options)), HasSubstr(" 0.1000"));
}

TEST(Draw, ALegendHasTheColoursOfCharts) {
  const certify::NetDocument net =
      compute_net(fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(3), 1)), Length("0.3")).document;
  const std::string picture = draw_svg(net, {.colouring = Colouring::chart, .legend = true});
  const std::string legend = legend_of(picture);
  std::set<std::string> charts;
  for (const certify::NetDocument::Triangle& triangle : net.triangles)
    charts.insert(std::to_string(net.vertices[triangle.vertex[0]].chart));
  ASSERT_GT(charts.size(), 2U);
  ASSERT_LE(charts.size(), 16U);
  for (const std::string& chart : charts) EXPECT_THAT(legend, HasSubstr('>' + chart + "</text>"));
  const std::string drawn = picture.substr(0, picture.size() - legend.size());
  std::set<std::string> hues;
  for (const std::string& colour : values_of(legend, "fill")) {
    if (!colour.starts_with("hsl(")) continue;
    EXPECT_THAT(drawn, HasSubstr("fill=\"" + colour + '"'));
    hues.insert(colour);
  }
  EXPECT_EQ(hues.size(), charts.size());
}

TEST(Draw, ALegendOfManyChartsStaysShort) {
  const certify::NetDocument net =
      compute_net(fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(12), 1)), Length("0.6")).document;
  std::set<std::uint32_t> charts;
  for (const certify::NetDocument::Triangle& triangle : net.triangles)
    charts.insert(net.vertices[triangle.vertex[0]].chart);
  ASSERT_GT(charts.size(), 16U);
  const std::string legend = legend_of(draw_svg(net, {.colouring = Colouring::chart, .legend = true}));
  EXPECT_THAT(legend, HasSubstr("and " + std::to_string(charts.size() - 16) + " more charts"));
}

TEST(Viewer, ListsTheGeodesicsWithTheirArcs) {
  const EverythingShown shown;
  const std::string page = viewer_page(shown.net, {.title = "net", .layers = shown.options.layers});
  const Layer& geodesics = *std::find_if(shown.options.layers.begin(), shown.options.layers.end(),
                                         [](const Layer& layer) { return layer.name == "closed geodesics"; });
  EXPECT_THAT(page, HasSubstr("\"parts\": [[\"geodesic 0, simple\", 0.1"));
  EXPECT_THAT(page, HasSubstr(viewer_data(shown.net, {.title = "net", .layers = shown.options.layers})));
  for (std::size_t i = 0; i < geodesics.parts.size(); ++i) {
    const std::size_t end = i + 1 < geodesics.parts.size() ? geodesics.parts[i + 1].first_arc : geodesics.arcs.size();
    ASSERT_LT(geodesics.parts[i].first_arc, end);
    double length = 0;
    for (std::size_t k = geodesics.parts[i].first_arc; k < end; ++k)
      length += 2 * std::asinh(std::sqrt(sinh2_half_distance(geodesics.arcs[k].from, geodesics.arcs[k].to)));
    EXPECT_NEAR(length, geodesics.parts[i].length, 1e-9) << geodesics.parts[i].name;
  }
}

TEST(Viewer, WritesAFiniteEpsilon) {
  certify::NetDocument net = verified("octagon-1-vertex.json");
  net.epsilon = "1" + std::string(400, '0');
  EXPECT_THAT(viewer_data(net, {.title = "net"}), HasSubstr("\"epsilon\": 1e+300,"));
}

TEST(Draw, CentresTheVertexAskedFor) {
  const certify::NetDocument net = octagon_net(123, "0.3");
  const Lifts lifts = lift_triangles(NetGeometry(net), DrawOrder::weight, 5);
  const Lifts::LiftedTriangle& first = lifts.lifted.front();
  bool found = false;
  for (std::size_t i = 0; i < 3; ++i)
    found = found || (net.triangles[first.triangle].vertex[i] == 5 && norm(first.corner[i]) < 1e-20);
  EXPECT_TRUE(found);
  EXPECT_THAT([&] { return draw_svg(net, {.centre = 1000000}); },
              ThrowsMessage<NetGeometryError>(HasSubstr("no vertex 1000000")));
}

/// A pseudo net of a surface of genus 2 with a cuff of this length.
certify::NetDocument thin_net(const Rational& cuff, std::uint64_t seed) {
  FenchelNielsen coordinates = random_coordinates(seed % 2 == 0 ? PantsGraph::chain(2) : PantsGraph::ring(2), seed);
  test::set_cuff_length(coordinates, seed % 3, cuff);
  return compute_net(fenchel_nielsen_surface(coordinates), Length("0.34"), {.pseudo = true}).document;
}

TEST(Draw, DrawsEveryLayerOfPseudoNetsHoweverThin) {
  std::uint64_t seed = 0;
  for (const double cuff : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 3e-8, 1e-8, 3e-9, 1e-9}) {
    const certify::NetDocument net = thin_net(Rational(cuff), seed++);
    const std::vector<Layer> layers = standard_layers(net);
    ASSERT_EQ(layers.size(), 5U);
    for (const Layer& layer : layers) {
      EXPECT_EQ(layer.left_out, "") << cuff << ' ' << layer.name;
      EXPECT_FALSE(layer.arcs.empty() && layer.darts.empty() && layer.triangles.empty()) << cuff << ' ' << layer.name;
    }
    for (const std::uint32_t centre : {0U, net.collars->front().vertices[0], net.collars->front().vertices[1]}) {
      const DrawOptions options{.centre = centre,
                                .dirichlet = true,
                                .combinatorial_dirichlet = true,
                                .covering_disks = true,
                                .packing_disks = true,
                                .legend = true,
                                .layers = layers};
      std::vector<std::string> left_out;
      const std::string picture = draw_svg(net, options, &left_out);
      EXPECT_THAT(left_out, testing::IsEmpty()) << cuff;
      EXPECT_THAT(picture, Not(HasSubstr("nan"))) << cuff;
    }
    EXPECT_EQ(viewer_page(net, {.title = "thin", .layers = layers}).find("left out"), std::string::npos) << cuff;
  }
}

TEST(Draw, NamesWhatCannotBeDrawnOfTheThinnestNets) {
  for (const double cuff : {1e-12, 1e-17, 1e-22}) {
    const certify::NetDocument net = thin_net(Rational(cuff), 0);
    const std::vector<Layer> layers = standard_layers(net);
    ASSERT_EQ(layers.size(), 5U);
    for (const Layer& layer : layers) {
      EXPECT_NE(layer.left_out.empty(), layer.arcs.empty() && layer.darts.empty() && layer.triangles.empty())
          << cuff << ' ' << layer.name;
    }
    std::vector<std::string> left_out;
    (void)draw_svg(net, {.dirichlet = true, .layers = layers}, &left_out);
    EXPECT_THAT(left_out, testing::Each(HasSubstr(": "))) << cuff;
    EXPECT_NE(viewer_page(net, {.title = "thin", .layers = layers}), "");
  }
}

TEST(Draw, CutsTheTilesOfThinSurfacesWithoutLoss) {
  std::uint64_t seed = 0;
  for (const double cuff : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const certify::NetDocument net = thin_net(Rational(cuff), seed++);
    double perimeter = 0;
    for (const certify::SurfaceDocument::Tile& tile : net.surface.tiles) {
      for (std::size_t k = 0; k < tile.size(); ++k) {
        perimeter +=
            distance(rounded<Mp256>(tile[k]), rounded<Mp256>(tile[(k + 1) % tile.size()])).convert_to<double>();
      }
    }
    double length = 0;
    for (const Arc& arc : tile_layer(net).arcs) length += distance(arc.from, arc.to);
    EXPECT_NEAR(length, perimeter / 2, 1e-6) << cuff;
  }
}

TEST(Draw, ACurveThatWindsAroundAShortOneTooOftenIsNotFollowed) {
  const certify::NetDocument net = thin_net(Rational(1e-6), 0);
  const NetGeometry geometry(net);
  // From a vertex of the collar to its image under a power of the core: once around for every triangle of an annulus.
  const certify::NetDocument::Collar& collar = net.collars->front();
  const certify::NetDocument::Vertex& v = net.vertices[collar.vertices[0]];
  const Parts<Mp256> parts(net, geometry.sides());
  const Isometry<Mp256> frame = parts.frames[v.chart];
  Isometry<Mp256> power;
  for (const std::uint32_t side : collar.core) power = normalized(parts.crossings[side] * power);
  const Complex<Mp256> p = frame({Mp256(v.x), Mp256(v.y)});
  const Placement near = placement_at(geometry, collar.vertices[0], frame);
  const std::optional<CutSegment> once = cut_segment(geometry, near, p, power(p));
  ASSERT_TRUE(once.has_value());
  EXPECT_FALSE(once->arcs.empty());
  for (int i = 0; i < 20; ++i) power = normalized(power * power);
  EXPECT_FALSE(cut_segment(geometry, near, p, power(p)).has_value());
}

TEST(Draw, WhatIsLeftOutIsNamed) {
  const certify::NetDocument net = octagon_net(123, "0.5");
  const std::vector<Layer> layers{{.name = "a curve", .colour = "#123456", .left_out = "it is <long>"}};
  std::vector<std::string> left_out;
  const std::string picture = draw_svg(net, {.legend = true, .layers = layers}, &left_out);
  EXPECT_THAT(left_out, testing::ElementsAre("a curve: it is <long>"));
  EXPECT_THAT(picture, HasSubstr(" Left out: a curve: it is &lt;long>.</desc>"));
  EXPECT_THAT(legend_of(picture), HasSubstr(">left out: a curve: it is &lt;long></text>"));
  EXPECT_THAT(legend_of(picture), Not(HasSubstr("#123456")));
  const std::string page = viewer_page(net, {.title = "net", .layers = layers});
  EXPECT_THAT(page, HasSubstr("[\"left out\", \"a curve: it is \\u003clong\\u003e\"]"));
  EXPECT_THAT(page, Not(HasSubstr("#123456")));
}

TEST(Draw, TakesAtMost100BytesForAVertex) {
  const certify::NetDocument net = octagon_net(123, "0.03");
  const std::string picture = draw_svg(net);
  EXPECT_LE(picture.size(), 100 * net.vertices.size());
}

TEST(Draw, WritesNoUnboundedTextOfTheDocument) {
  certify::NetDocument net = verified("octagon-1-vertex.json");
  net.epsilon = "1" + std::string(100000, '0');
  EXPECT_LT(draw_svg(net).size(), 20000U);
}

TEST(Draw, RefusesWhatIsNoNet) {
  const certify::NetDocument good = verified("octagon-9-vertices.json");
  const auto draw_changed = [&](const auto& change) {
    return [&, change] {
      certify::NetDocument net = good;
      change(net);
      return draw_svg(net);
    };
  };
  EXPECT_THAT(draw_changed([](auto& net) { net.triangles[3].opposite[1] = 3 * 3 + 1; }),
              ThrowsMessage<NetGeometryError>(HasSubstr("triangles[")));
  EXPECT_THAT(draw_changed([](auto& net) { net.triangles[0].vertex[2] = 9; }),
              ThrowsMessage<NetGeometryError>(HasSubstr("vertex 9")));
  EXPECT_THAT(draw_changed([](auto& net) { net.triangles.clear(); }),
              ThrowsMessage<NetGeometryError>(HasSubstr("vertex 0")));
  EXPECT_THAT(draw_changed([](auto& net) {
                // A second copy of all triangles, connected within itself only.
                const auto n = static_cast<std::uint32_t>(net.triangles.size());
                for (std::uint32_t t = 0; t < n; ++t) {
                  certify::NetDocument::Triangle copy = net.triangles[t];
                  for (std::uint32_t& dart : copy.opposite) dart += 3 * n;
                  net.triangles.push_back(copy);
                }
              }),
              ThrowsMessage<NetGeometryError>(HasSubstr("connected")));
}

// ---- Information ----

TEST(Info, BoundsAreThoseOfTheThesis) {
  // Table IV.3: lower bounds 100 and 1,600, upper bounds 400 and 6,400 for ε = 0.2 and 0.05 in genus 2.
  EXPECT_EQ(std::lround(least_vertices(2, 0.2)), 100);
  EXPECT_EQ(std::lround(least_vertices(2, 0.05)), 1600);
  EXPECT_EQ(std::lround(most_vertices(2, 0.2)), 400);
  EXPECT_EQ(std::lround(most_vertices(2, 0.05)), 6400);
}

TEST(Info, SystoleBoundImpliesLemmaIII15) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (double epsilon = 0.01; epsilon < std::asinh(1.0); epsilon += 0.01)
    EXPECT_GE(systole_lower_bound(epsilon, infinity), epsilon);
  EXPECT_LT(systole_lower_bound(0.1, 1e-4), 1e-4);
  EXPECT_GT(systole_lower_bound(0.1, 1e-4), 0.99e-4);
  EXPECT_GE(systole_lower_bound(2000, infinity), 0);
}

TEST(Info, SystoleBoundHoldsOnSurfacesWithKnownShortCurves) {
  // The short curve of these surfaces has the length in the name, to within a few percent, by construction; the upper
  // bound is a loop edge of the net.
  const certify::NetDocument net = polygon_net("polygon-g2-thin-1e-4.txt", "0.3");
  const std::string text = net_info(net).text;
  const std::size_t at = text.find("(run certify): at least about ");
  ASSERT_NE(at, std::string::npos) << text;
  const double lower = std::stod(text.substr(at + 30));
  const double upper = std::stod(text.substr(text.find("at most about ", at) + 14));
  EXPECT_LE(lower, 1.04e-4);
  EXPECT_GE(lower, 0.9e-4);
  EXPECT_GE(upper, 0.99e-4);
  EXPECT_LE(upper, 1.1e-4);
}

TEST(Info, CountsWhatIsThere) {
  const std::string net = net_info(verified("octagon-33-vertices.json")).text;
  EXPECT_THAT(net, HasSubstr("vertices: 33\n"));
  EXPECT_THAT(net, HasSubstr("edges: 105\n"));
  EXPECT_THAT(net, HasSubstr("triangles: 70\n"));
  EXPECT_THAT(net, HasSubstr("genus: 2\n"));
  const std::string surface = surface_info(random_octagon(1)).text;
  EXPECT_THAT(surface, HasSubstr("genus: 2\n"));
  EXPECT_THAT(surface, HasSubstr("sides: 8\n"));
  EXPECT_THAT(surface, HasSubstr("area 4 pi (g-1): 12.5664\n"));
}

}  // namespace
}  // namespace epsnet::draw_test
