#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/claims/bound/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/geodesics/document.h"
#include "kernel/numbers.h"
#include "netgen/nets/dirichlet_polygon.h"

/// Pictures of anything but nets: `picture_of` says what a picture shows, `draw_svg` draws it. Nothing here is proved.
namespace epsnet {

// One polygon of the Poincaré disk whose sides are paired: a Dirichlet domain, or the tiles of a surface, with the
// points and curves that were asked for in front.

/// What such a picture shows. All coordinates are those of the disk.
struct PolygonPicture {
  /// Of the Poincaré disk.
  using Point = Complex<double>;
  /// Both ends of a geodesic segment.
  using Segment = std::array<Point, 2>;
  /// A side of the polygon.
  struct Side {
    Segment ends;           ///< Counterclockwise around the polygon.
    std::uint32_t partner;  ///< An index of `sides`.
    std::string name;       ///< Its label.
  };
  /// A curve in front of the polygon, of geodesic segments.
  struct Curve {
    std::string name;
    std::string colour;
    std::vector<Segment> segments;
  };
  /// Places that are marked by dots.
  struct Mark {
    std::string name;   ///< In the legend.
    std::string label;  ///< Beside each place.
    std::string colour;
    std::vector<Point> places;
  };
  /// A disk about the centre of the picture.
  struct Disk {
    std::string name;
    std::string colour;
    double radius;  ///< Hyperbolic; the centre is 0.
  };
  std::string title{};
  std::vector<Side> sides{};     ///< In order around the polygon: side k ends where side k + 1 starts.
  std::vector<Segment> inner{};  ///< Sides of tiles inside the polygon.
  std::vector<Disk> disks{};
  std::vector<Curve> curves{};
  std::vector<Mark> marks{};
  std::vector<std::string> left_out{};  ///< "name: reason" of what is missing.
};

/// Returns the picture as SVG, `size` pixels wide and high (50 to 20000), with a legend. Sides that are glued to each
/// other have one colour, and their labels, but for sides shorter than a label; sides, curves and marks do not become
/// thinner towards the circle.
[[nodiscard]] std::string draw_svg(const PolygonPicture& picture, std::uint32_t size = 1000);

/// Returns the picture of a Dirichlet domain with its base point in the centre. Sides have their numbers in the
/// polygon.
[[nodiscard]] PolygonPicture picture_of(const DirichletPolygon& polygon);

/// Returns the picture of the tiles of a surface, laid out around a tile as a tree, with the middle of all in the
/// centre. Sides have their numbers on the surface, which are the letters of words.
[[nodiscard]] PolygonPicture picture_of(const Surface& surface);

/// The following have a Dirichlet domain, with its base point in the centre. If it cannot be made, or the genus is more
/// than 100, `left_out` says so. They throw SurfaceError if the document has no surface.

/// Returns the picture of all paths of a distance file, from p in the centre to q.
[[nodiscard]] PolygonPicture picture_of(const certify::DistanceDocument& distance);

/// Returns the picture of the geodesics of a geodesics file, cut by the domain; the centre is a point of the first one.
/// At most 200 are drawn, the shortest.
[[nodiscard]] PolygonPicture picture_of(const certify::GeodesicsDocument& geodesics);

/// Returns the picture of where the bounds of a diameter, a radius or an embedded disk are attained. For a diameter the
/// vertex of the file is in the centre, with the points farthest from it and the segments there; for a radius the disk
/// around the vertex that covers the surface as well; for an embedded disk that disk.
[[nodiscard]] PolygonPicture picture_of(const certify::BoundDocument& bound);

/// Returns the picture of a net with one vertex: the vertex in the centre, the points farthest from it, and the
/// segments there.
[[nodiscard]] PolygonPicture picture_of_eccentricity(const certify::NetDocument& net);

// An eigenvalues file: how many eigenvalues can be where.

/// What such a picture shows, over the axis of eigenvalues.
struct EigenvaluesPicture {
  /// A point of the curve.
  struct Sample {
    double lambda;
    double bound;  ///< I(λ), of netgen/eigenvalues/eigenvalues.h.
  };
  std::string title{};
  double up_to = 0;               ///< What is claimed ends here.
  std::vector<Sample> samples{};  ///< By λ, from 0 to beyond up_to.
  std::vector<certify::EigenvaluesDocument::Window> windows{};
  bool without_known = false;  ///< Whether I(λ) does not count eigenvalues that eigenfunctions of the file show.
};

/// Returns the curve I(λ), with the windows of the file as bands. It is evaluated at some 500 places, and more near the
/// windows. Throws SurfaceError if the document has no surface, LimitError as eigenvalue_bounds. Time: some 0.1 ms for
/// each place, and that of trace_matrices.
[[nodiscard]] EigenvaluesPicture picture_of(const certify::EigenvaluesDocument& document);

/// Returns the picture as SVG, `size` pixels wide (50 to 20000) and 0.62 times as high. Above each band is its number
/// of eigenvalues; on the axis is where they are. Bands and marks are at least as wide as can be seen.
[[nodiscard]] std::string draw_svg(const EigenvaluesPicture& picture, std::uint32_t size = 1000);

}  // namespace epsnet
