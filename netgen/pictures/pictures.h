#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/bound/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/pants/document.h"
#include "kernel/numbers.h"
#include "netgen/lifts/lifts.h"
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
/// other have one colour, and their labels, but for sides shorter than a label and labels that would lie on others;
/// sides, curves and marks do not become thinner towards the circle.
[[nodiscard]] std::string draw_svg(const PolygonPicture& picture, std::uint32_t size = 1000);

/// Returns the picture of a Dirichlet domain with its base point in the centre. Sides have their numbers in the
/// polygon.
[[nodiscard]] PolygonPicture picture_of(const DirichletPolygon& polygon);

/// Returns the picture of the tiles of a surface, laid out around tile 0, the nearest first; regular tiles with the
/// centre of tile 0 in the centre, others with the middle of all corners. Sides that are glued where they lie are
/// inside. The others have their numbers on the surface, which are the letters of words.
[[nodiscard]] PolygonPicture picture_of(const Surface& surface);

/// The following have a Dirichlet domain, with its base point in the centre. If it cannot be made, or the genus is more
/// than 100, `left_out` says so. They throw SurfaceError if the document has no surface.

/// Returns the picture of all paths of a distance file, from p in the centre to q.
[[nodiscard]] PolygonPicture picture_of(const certify::DistanceDocument& distance);

/// Returns the picture of the geodesics of a geodesics file, cut by the domain; the centre is a point of the first one
/// that is not very short. At most 200 are drawn, the shortest.
[[nodiscard]] PolygonPicture picture_of(const certify::GeodesicsDocument& geodesics);

/// Returns the picture of the cuffs of a pants file, cut by the domain of the surface's default point; at most 200.
[[nodiscard]] PolygonPicture picture_of(const certify::PantsDocument& pants);

/// Returns the picture of where the bounds of a diameter, a radius or an embedded disk are attained. For a diameter the
/// vertex of the file is in the centre, with the points farthest from it and the segments there; for a radius the disk
/// around the vertex that covers the surface as well; for an embedded disk that disk.
[[nodiscard]] PolygonPicture picture_of(const certify::BoundDocument& bound);

/// Returns the picture of a net with one vertex: the vertex in the centre, the points farthest from it, and the
/// segments there.
[[nodiscard]] PolygonPicture picture_of_eccentricity(const certify::NetDocument& net);

// An eigenvalues file: where eigenvalues are, how many there are below each place, and the eigenfunctions.

/// What an eigenvalues file says of a number x; nothing, if `most` has no value, of how many there are at most.
struct EigenvalueCount {
  std::uint32_t least = 0;                 ///< At least so many eigenvalues are less than x,
  std::optional<std::uint32_t> most = {};  ///< and at most so many.
};

/// Returns how many eigenvalues are less than x, without the eigenvalue 0 of the constants, as rows of the document
/// say.
[[nodiscard]] EigenvalueCount eigenvalues_below(const certify::EigenvaluesDocument& document, double x);

/// What a picture of an eigenvalues file shows, over the axis of eigenvalues.
struct EigenvaluesPicture {
  /// From `lambda` on there are at least `count`; or up to `lambda` there are at most `count`.
  struct Step {
    double lambda;
    std::uint32_t count;
  };
  std::string title{};
  std::vector<certify::EigenvaluesDocument::Enclosure> eigenvalues{};
  double next = 0;            ///< All others are at least that.
  double end = 1;             ///< Of the axis, beyond `next`.
  double weyl = 0;            ///< g − 1: by Weyl's law there are about so many times λ eigenvalues below λ.
  std::vector<Step> least{};  ///< By λ and count.
  std::vector<Step> most{};   ///< By λ and count.
};

/// Returns the staircases of the counts that the rows of the document say, with its intervals.
[[nodiscard]] EigenvaluesPicture picture_of(const certify::EigenvaluesDocument& document);

/// Returns the picture as SVG, `size` pixels wide (50 to 20000) and 0.62 times as high. Above each interval is its
/// number of eigenvalues. Intervals are at least as wide as can be seen.
[[nodiscard]] std::string draw_svg(const EigenvaluesPicture& picture, std::uint32_t size = 1000);

/// An eigenfunction of an eigenvalues file.
struct EigenfunctionPlace {
  std::size_t row;       ///< Of `eigenfunctions`.
  std::size_t function;  ///< Of the row.
  std::uint32_t first;   ///< The eigenvalues of its interval are λ_first and others,
  std::uint32_t count;   ///< so many in all.
};

/// Returns the eigenfunction of λ_index, from 1 on. In an interval with several eigenvalues the functions have no order
/// of their own, and index counts them as they are in the file. Throws std::out_of_range if there is none; its what()
/// says of which eigenvalues there are.
[[nodiscard]] EigenfunctionPlace eigenfunction_place(const certify::EigenvaluesDocument& document, std::size_t index);

/// Returns, by vertex of the net, the values of the function of λ_index. Throws as eigenfunction_place.
[[nodiscard]] std::vector<double> eigenfunction_at_vertices(const certify::EigenvaluesDocument& document,
                                                            std::size_t index);

/// Options of the picture of an eigenfunction.
struct EigenfunctionPictureOptions {
  DrawOrder order = DrawOrder::weight;  ///< Which lifts of the triangles are drawn.
  std::uint32_t centre = 0;             ///< The vertex in the centre.
  std::uint32_t size = 1000;            ///< Width and height in pixels, 50 to 20000.
};

/// Returns the function of λ_index on one lift of every triangle of the net, as SVG: colours in bands from blue, −, to
/// red, +, with the nodal lines, where it is 0. Equal arguments give equal bytes. Throws as eigenfunction_place, and
/// NetGeometryError if the document has no net or no such vertex. O(pixels · coefficients of a vertex).
[[nodiscard]] std::string eigenfunction_svg(const certify::EigenvaluesDocument& document, std::size_t index,
                                            const EigenfunctionPictureOptions& options = {});

}  // namespace epsnet
