#include <algorithm>
#include <cmath>
#include <deque>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "certify/check.h"
#include "kernel/plane.h"
#include "netgen/curves/curves.h"
#include "netgen/distances/distances.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/surface/surface.h"

namespace epsnet::polygon_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Point = PolygonPicture::Point;

double length_of(const PolygonPicture::Segment& segment) { return distance(segment[0], segment[1]); }

double length_of(const PolygonPicture::Curve& curve) {
  double length = 0;
  for (const PolygonPicture::Segment& segment : curve.segments) length += length_of(segment);
  return length;
}

/// Sides close up, paired ones are of equal length.
void expect_paired_polygon(const PolygonPicture& picture, const std::string& name) {
  const std::size_t n = picture.sides.size();
  ASSERT_GE(n, 4U) << name;
  for (std::size_t k = 0; k < n; ++k) {
    const PolygonPicture::Side& side = picture.sides[k];
    EXPECT_LT(std::sqrt(norm(side.ends[1] - picture.sides[(k + 1) % n].ends[0])), 1e-9) << name;
    ASSERT_LT(side.partner, n) << name;
    EXPECT_EQ(picture.sides[side.partner].partner, k) << name;
    EXPECT_NEAR(length_of(side.ends), length_of(picture.sides[side.partner].ends), 1e-6) << name;
  }
}

/// Cuffs are drawn with their lengths.
TEST(PolygonPicture, CuffsHaveTheirLengths) {
  for (const Surface& surface :
       {random_octagon(5), fenchel_nielsen_surface(random_coordinates(PantsGraph::ring(3), 1))}) {
    const PantsDecomposition pants = pants_decomposition(surface);
    const PolygonPicture picture = picture_of(pants.document);
    EXPECT_TRUE(picture.left_out.empty());
    ASSERT_EQ(picture.curves.size(), pants.cuffs.size());
    for (std::size_t e = 0; e < pants.cuffs.size(); ++e)
      EXPECT_NEAR(length_of(picture.curves[e]), pants.cuffs[e].length.upper, 1e-9);
  }
}

/// Klein's 24 heptagons lie around one in the centre; no two tiles overlap, and the sides form a polygon.
TEST(PolygonPicture, TilesOfKleinAreLaidOutNearestFirst) {
  const PolygonPicture picture = picture_of(named_surface("klein"));
  expect_paired_polygon(picture, "klein");
  EXPECT_EQ(picture.sides.size() + 2 * picture.inner.size(), 24U * 7);
  EXPECT_GT(picture.inner.size(), 30U);  // More than the 23 of a tree: sides that are glued where they lie.
  const auto turned = [](const PolygonPicture::Segment& segment, int steps) {
    const double angle = steps * 2 * 3.14159265358979323846 / 7;
    return Point{std::cos(angle), std::sin(angle)} * segment[0];
  };
  // The 7 sides of the tile in the centre go to each other when they are turned.
  std::size_t found = 0;
  for (const PolygonPicture::Segment& segment : picture.inner) {
    if (std::sqrt(norm(segment[0])) > 0.32) continue;
    ++found;
    EXPECT_TRUE(std::any_of(picture.inner.begin(), picture.inner.end(), [&](const PolygonPicture::Segment& other) {
      return norm(turned(segment, 1) - other[0]) < 1e-12 || norm(turned(segment, 1) - other[1]) < 1e-12;
    }));
  }
  EXPECT_GE(found, 7U);
}

/// A very short geodesic is not in the centre, where the domain would be a line.
TEST(PolygonPicture, ThinSurfacesShowSomething) {
  const FenchelNielsen thin{PantsGraph::chain(2), {Rational(1, 100'000'000), 2, 1}, {0, 0, 0}};
  const PolygonPicture picture = picture_of(unproved::thick_thin(fenchel_nielsen_surface(thin)));
  double left = 1;
  double right = -1;
  for (const PolygonPicture::Side& side : picture.sides) {
    left = std::min(left, side.ends[0].x);
    right = std::max(right, side.ends[0].x);
  }
  EXPECT_GT(right - left, 0.5);
  EXPECT_THAT(draw_svg(picture), HasSubstr("closed geodesic of length 1e-08"));
}

/// The stroke of each side, and the colour of each label.
struct SideColours {
  std::vector<std::string> strokes;
  std::map<std::string, std::string> labels;
};

SideColours colours_of_sides(const std::string& svg) {
  SideColours result;
  const std::size_t sides = svg.find("<g class=\"sides\"");
  const std::size_t labels = svg.find("<g class=\"labels\"");
  const std::size_t end = svg.find("</g>", labels);
  const std::string strokes = svg.substr(sides, labels - sides);
  const std::regex stroke("<path stroke=\"([^\"]*)\"");
  for (std::sregex_iterator i(strokes.begin(), strokes.end(), stroke), none; i != none; ++i) {
    result.strokes.push_back((*i)[1]);
  }
  const std::string texts = svg.substr(labels, end - labels);
  const std::regex text("fill=\"([^\"]*)\">([^<]*)</text>");
  for (std::sregex_iterator i(texts.begin(), texts.end(), text), none; i != none; ++i) result.labels[(*i)[2]] = (*i)[1];
  return result;
}

TEST(PolygonPicture, OfADirichletDomainHasLabelledSidesWithPairsInOneColour) {
  const DirichletPolygon polygon =
      dirichlet_polygon(random_octagon(123), BasePoint{TileId(0), {Rational(1, 10), Rational(1, 5)}});
  const PolygonPicture picture = picture_of(polygon);
  expect_paired_polygon(picture, "octagon");
  const std::string svg = draw_svg(picture);
  EXPECT_EQ(svg, draw_svg(picture));
  const SideColours colours = colours_of_sides(svg);
  ASSERT_EQ(colours.strokes.size(), polygon.sides.size());
  for (std::size_t k = 0; k < polygon.sides.size(); ++k) {
    const std::size_t partner = polygon.sides[k].partner;
    EXPECT_EQ(colours.strokes[k], colours.strokes[partner]);
    // The legend names all pairs; a side that is shorter than its label has none.
    if (k < partner) {
      EXPECT_THAT(svg, HasSubstr('>' + std::to_string(k) + ' ' + std::to_string(partner) + "</text>"));
    }
    const Point chord = polygon.vertices[(k + 1) % polygon.sides.size()] - polygon.vertices[k];
    if (485 * std::sqrt(norm(chord)) < 13) continue;
    ASSERT_TRUE(colours.labels.contains(std::to_string(k))) << k;
    EXPECT_EQ(colours.labels.at(std::to_string(k)), colours.strokes[k]);
    for (std::size_t other = 0; other < k; ++other) {
      if (other == partner) continue;
      EXPECT_NE(colours.strokes[k], colours.strokes[other]);
    }
  }
  EXPECT_THAT(svg, HasSubstr(">base point</text>"));
  EXPECT_THAT(svg, HasSubstr(">glued sides:</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("class=\"edges\""))) << "no fan of triangles";
}

/// Texts of a group of a picture: from where to where.
struct TextBox {
  double left, right, top, bottom;
};

std::vector<TextBox> texts_of(const std::string& svg, const std::string& group_class) {
  const std::size_t begin = svg.find("<g class=\"" + group_class + "\"");
  if (begin == std::string::npos) return {};
  const std::string group = svg.substr(begin, svg.find("</g>", begin) - begin);
  std::smatch font;
  if (!std::regex_search(group, font, std::regex("font-size=\"([0-9.]+)\""))) return {};
  const double size = std::stod(font[1]);
  const bool is_centred = group.find("text-anchor=\"middle\"") != std::string::npos;
  const std::regex text("<text x=\"(-?[0-9.]+)\" y=\"(-?[0-9.]+)\"[^>]*>([^<]+)</text>");
  std::vector<TextBox> result;
  for (std::sregex_iterator it(group.begin(), group.end(), text), end; it != end; ++it) {
    const double width = 0.56 * size * static_cast<double>((*it)[3].length());
    const double left = std::stod((*it)[1]) - (is_centred ? width / 2 : 0);
    const double bottom = std::stod((*it)[2]);
    result.push_back({left, left + width, bottom - 0.75 * size, bottom});
  }
  return result;
}

bool overlap(const TextBox& a, const TextBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

TEST(PolygonPicture, LabelsAreInThePictureAndDoNotOverlapEachOtherOrTheLegend) {
  std::deque<test::NamedSurface> surfaces = test::tiled_gallery();
  const std::vector<std::string> symmetric{"klein", "bring", "fricke-macbeath"};
  for (const std::string& name : symmetric) surfaces.push_back({name, named_surface(name)});
  const auto is_symmetric = [&](const std::string& name) {
    return std::find(symmetric.begin(), symmetric.end(), name) != symmetric.end();
  };
  FenchelNielsenRequest thin;
  thin.graph = "theta";
  thin.lengths = {"0.01", "2", "3"};
  thin.twists = {"0", "0.5", "1"};
  surfaces.push_back({"thin", fenchel_nielsen_surface(resolve(thin))});
  for (const auto& [name, surface] : surfaces) {
    for (const PolygonPicture& picture : {picture_of(surface), picture_of(dirichlet_polygon(surface, {}))}) {
      for (const std::uint32_t size : {500U, 1000U}) {
        const std::string svg = draw_svg(picture, size);
        const std::vector<TextBox> labels = texts_of(svg, "labels");
        const std::vector<TextBox> legend = texts_of(svg, "legend");
        EXPECT_GE(labels.size(), is_symmetric(name) ? 11U : 2U) << name;
        EXPECT_FALSE(legend.empty()) << name;
        for (std::size_t i = 0; i < labels.size(); ++i) {
          const TextBox& a = labels[i];
          EXPECT_TRUE(a.left >= 0 && a.top >= 0 && a.right <= size && a.bottom <= size) << name << ' ' << i;
          for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(a, labels[j])) << name << ' ' << i << ' ' << j;
          for (const TextBox& row : legend) EXPECT_FALSE(overlap(a, row)) << name << ' ' << i;
        }
      }
    }
  }
  // So many pairs of sides are not listed where the domain is.
  EXPECT_THAT(draw_svg(picture_of(dirichlet_polygon(named_surface("fricke-macbeath"), {}))),
              HasSubstr(">sides of one colour are glued to each other<"));
}

TEST(PolygonPicture, OfASurfaceIsACentredPolygonOfItsTiles) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const PolygonPicture picture = picture_of(named.surface);
    expect_paired_polygon(picture, named.name);
    EXPECT_EQ(picture.sides.size() + 2 * picture.inner.size(), named.surface.side_count()) << named.name;
    EXPECT_EQ(picture.inner.size() + 1, named.surface.tiles().size()) << named.name;
    LorentzVector<double> sum;
    for (const PolygonPicture::Side& side : picture.sides) sum = sum + on_hyperboloid(side.ends[0]);
    EXPECT_LT(std::hypot(sum.x, sum.y) / sum.t, 1e-6) << named.name;
  }
}

TEST(PolygonPicture, OfADistanceShowsThePathsFromTheCentreAndBothEnds) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    if (named.surface.genus() > 2) continue;
    const certify::DistanceDocument document = unproved::distance(
        named.surface, centre_of_tile(named.surface, TileId(0)), {TileId(0), {Rational(1, 10), Rational(1, 20)}});
    const PolygonPicture picture = picture_of(document);
    ASSERT_EQ(picture.curves.size(), 1U) << named.name;
    ASSERT_EQ(picture.curves[0].segments.size(), document.paths.size()) << named.name;
    for (const PolygonPicture::Segment& path : picture.curves[0].segments) {
      EXPECT_EQ(norm(path[0]), 0) << named.name;
      EXPECT_NEAR(length_of(path), document.distance.lower, 1e-9) << named.name;
    }
    const std::string svg = draw_svg(picture);
    for (const char* end : {">p</text>", ">q</text>"}) EXPECT_THAT(svg, HasSubstr(end)) << named.name;
    EXPECT_THAT(svg, HasSubstr(">shortest path")) << named.name;
    // In front of all sides, wide, with a margin.
    EXPECT_GT(svg.find("<g class=\"curve\""), svg.find("<g class=\"labels\"")) << named.name;
    EXPECT_GT(svg.find("<g class=\"mark\""), svg.find("<g class=\"curve\"")) << named.name;
    EXPECT_THAT(svg, HasSubstr(std::string("<path stroke=\"") + palette::kPaths + "\" stroke-width=\"5.00\""));
  }
}

TEST(PolygonPicture, OfClosedGeodesicsHasThemInFullLength) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    if (named.surface.genus() > 3) continue;
    const certify::GeodesicsDocument document = unproved::systole(named.surface);
    const PolygonPicture picture = picture_of(document);
    EXPECT_TRUE(picture.left_out.empty()) << named.name;
    ASSERT_EQ(picture.curves.size(), 1U) << named.name;
    EXPECT_NEAR(length_of(picture.curves[0]), document.geodesics[0].length.lower, 1e-9) << named.name;
    // A point of a very short one would have a domain like a line.
    if (document.geodesics[0].length.lower < 0.2) continue;
    // The centre is a point of it, and no other lift of the point is nearer than its ends.
    double nearest = 1;
    for (const PolygonPicture::Segment& segment : picture.curves[0].segments) {
      nearest = std::min({nearest, norm(segment[0]), norm(segment[1])});
      EXPECT_LT(std::abs(cross(segment[0], segment[1])), 1e-9) << named.name << ": no diameter";
    }
  }
}

TEST(PolygonPicture, OfASpectrumHasACurveForEachCluster) {
  const Surface bolza = Surface::regular(2);
  const certify::GeodesicsDocument document = unproved::spectrum(bolza, Length("5"));
  const PolygonPicture picture = picture_of(document);
  ASSERT_EQ(picture.curves.size(), document.clusters.size());
  EXPECT_TRUE(picture.left_out.empty());
  for (std::size_t i = 0; i < document.clusters.size(); ++i) {
    const auto& cluster = document.clusters[document.clusters.size() - 1 - i];  // The shortest in front.
    EXPECT_NEAR(length_of(picture.curves[i]), cluster.count * document.geodesics[cluster.first].length.lower, 1e-6);
  }
  EXPECT_THAT(draw_svg(picture), HasSubstr(">12 closed geodesics of length 3.0571</text>"));
}

/// The distance of the vertex from each of the points is the eccentricity; no point of the surface is farther.
TEST(FarthestPoints, AreWhereTheEccentricityIsAttained) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    if (named.surface.genus() > 3) continue;
    const BasePoint p = centre_of_tile(named.surface, TileId(0));
    const certify::Certificate certificate = certify::check(unproved::eccentricity_net(named.surface, p));
    ASSERT_EQ(certificate.verdict, certify::Verdict::verified) << named.name;
    const std::vector<BasePoint> points = farthest_points(named.surface, dirichlet_polygon(named.surface, p));
    ASSERT_FALSE(points.empty()) << named.name;
    for (const BasePoint& q : points) {
      EXPECT_NO_THROW(require_on_surface(named.surface, q)) << named.name;
      const certify::Interval found = unproved::distance(named.surface, p, q).distance;
      EXPECT_NEAR(found.lower, certificate.enclosures->largest_circumradius.lower, 1e-10) << named.name;
    }
  }
}

/// Without symmetries no three geodesics meet in a point: there are as many dots as intersections.
TEST(PolygonPicture, ClosedCurvesHaveADotAtEachCrossing) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::ring(3), seed));
    const std::vector<Word> basis = CurveTopology(surface).homology_basis();
    const auto product = [&](std::initializer_list<std::size_t> factors) {
      Word word;
      for (const std::size_t k : factors) word.insert(word.end(), basis[k].begin(), basis[k].end());
      return word;
    };
    const std::vector<Word> words{product({0}), product({0, 1, 1, 2}), product({3, 5, 4, 0})};
    const certify::CurvesDocument document = unproved::curves(surface, words);
    const PolygonPicture picture = picture_of(document);
    std::uint64_t crossings = 0;
    for (std::size_t i = 0; i < words.size(); ++i) crossings += document.curves[i].self_intersections;
    for (const auto& pair : document.pairs)
      if (pair.second < words.size()) crossings += pair.intersections;
    ASSERT_GT(crossings, 3U);
    ASSERT_EQ(picture.marks.size(), 1U);
    EXPECT_EQ(picture.marks[0].places.size(), crossings);
    for (const Point& z : picture.marks[0].places) {
      const auto through = [&](const PolygonPicture::Segment& segment) {
        return std::abs(distance(segment[0], z) + distance(z, segment[1]) - length_of(segment)) < 1e-6;
      };
      std::ptrdiff_t lines = 0;
      for (const PolygonPicture::Curve& curve : picture.curves)
        lines += std::count_if(curve.segments.begin(), curve.segments.end(), through);
      EXPECT_EQ(lines, 2);
    }
  }
}

/// The centre of the regular octagon has one farthest point, the vertex, at the greatest distance of all.
TEST(FarthestPoints, OfTheCentreOfTheBolzaSurfaceIsItsVertex) {
  const Surface bolza = Surface::regular(2);
  const certify::BoundDocument document = unproved::diameter(bolza, {.width = 1e-3});
  const PolygonPicture picture = picture_of(document);
  ASSERT_EQ(picture.marks.size(), 2U);
  for (const PolygonPicture::Segment& path : picture.curves.at(0).segments) {
    EXPECT_GE(length_of(path), document.value.lower - 1e-9);
    EXPECT_LE(length_of(path), document.value.upper + 1e-9);
  }
  EXPECT_EQ(farthest_points(bolza, dirichlet_polygon(bolza, BasePoint{TileId(0), {0, 0}})).size(), 1U);
}

TEST(PolygonPicture, OfAnEmbeddedDiskShowsTheDiskInTheDomain) {
  const certify::BoundDocument document = unproved::largest_embedded_disk(random_octagon(123), {.width = 1e-2});
  const PolygonPicture picture = picture_of(document);
  ASSERT_EQ(picture.disks.size(), 1U);
  EXPECT_EQ(picture.disks[0].radius, document.value.lower);
  // It touches no side: every vertex is outside of it, and the sides are at its radius or farther.
  for (const PolygonPicture::Side& side : picture.sides) {
    EXPECT_GT(distance(Point{}, side.ends[0]), document.value.lower);
  }
}

}  // namespace
}  // namespace epsnet::polygon_test
