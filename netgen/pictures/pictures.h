#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/bound/document.h"
#include "certify/claims/curves/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/pants/document.h"
#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "kernel/numbers.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/dirichlet_polygon.h"

/// Pictures: `picture_of` says what a picture shows, `draw_svg` draws it; and a page in which the reader travels in a
/// net. Nothing here is proved.
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
    double radius = 8;  ///< Of a dot, in thousandths of the width.
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

/// Returns the picture of the closed geodesics of a curves file, without those of its basis if there are others, cut by
/// the domain of the surface's default point, with dots where they cross each other or themselves; at most 200.
[[nodiscard]] PolygonPicture picture_of(const certify::CurvesDocument& curves);

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

/// Returns how many eigenvalues are less than x, as rows of the document say: without phases, those that are not 0.
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

/// Bands along a path: at each step intervals that contain λ₀, λ₁, ….
struct BandsPicture {
  /// A step with a name, such as that of a corner of the path.
  struct Mark {
    std::size_t step;
    std::string name;
  };
  std::vector<std::vector<certify::Interval>> bands{};  ///< By step and index.
  std::vector<Mark> marks{};
};

/// Returns the picture as SVG, `size` pixels wide (50 to 20000) and 0.62 times as high: an upright bar for each
/// interval, at least as long as can be seen, and a line through the middles of those with the same index.
[[nodiscard]] std::string draw_svg(const BandsPicture& picture, std::uint32_t size = 1000);

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

// Pictures of nets in the Poincaré disk. All functions throw NetGeometryError if the structure of the document is not
// that of a net; they do not check its geometry.

/// The colouring of the triangles of a picture.
enum class Colouring {
  none,          ///< Nothing.
  circumradius,  ///< From pale, ε/2 or less, to dark, ε.
  chart,         ///< By the chart of the triangle in the net file.
  values,        ///< By DrawOptions::values, in bands from pale, 0, to dark, the greatest.
};

/// A piece of a geodesic within one triangle, in the chart of one of the triangle's corners.
struct Arc {
  std::uint32_t dart;    ///< 3t + i: in triangle t of the document, in the chart of corner i.
  Complex<double> from;  ///< Where it starts.
  Complex<double> to;    ///< Where it ends.
};

/// A point in a triangle, in the chart of one of the triangle's corners, as in Arc.
struct Spot {
  std::uint32_t dart;
  Complex<double> z;
};

/// An addition to a picture of a triangulation: arcs, edges or triangles, all in one colour.
struct Layer {
  /// A closed geodesic: its arcs in order, from `first_arc` up to the first arc of the next part.
  struct Part {
    std::string name;       ///< Plain text in UTF-8.
    double length;          ///< Hyperbolic, rounded.
    std::size_t first_arc;  ///< An index of `arcs`.
  };

  std::string name;                           ///< Plain text in UTF-8.
  std::string colour;                         ///< "#rrggbb".
  bool on = true;                             ///< Whether a viewer shows it at first.
  std::vector<Arc> arcs = {};                 ///< Curves.
  std::vector<std::uint32_t> darts = {};      ///< Edges of the triangulation, each as one or both of its darts.
  std::vector<std::uint32_t> triangles = {};  ///< Filled.
  std::vector<Part> parts = {};               ///< Only of closed geodesics, one for each.
  std::vector<Spot> spots = {};               ///< Points, marked by dots.
  bool in_front = false;                      ///< What was asked for: in front of all else, wide and with a margin.
  std::string left_out = {};                  ///< Why curves of it are missing; nothing if none is.
};

// All functions that make layers leave a curve out if it takes very many steps to follow, as it winds around a very
// short closed geodesic; `Layer::left_out` then has the reason. They take O(triangles + arcs) time.

/// Returns the sides of the tiles of the surface.
[[nodiscard]] Layer tile_layer(const certify::NetDocument& net);

/// Returns the boundary of the Dirichlet domain of a vertex: the points that are nearer to one lift of the vertex than
/// to its other lifts. It is computed from the exact surface, and has its sides; see dirichlet_polygon. Also
/// throws NetGeometryError if the document's surface is invalid, or beyond genus 100.
[[nodiscard]] Layer dirichlet_layer(const certify::NetDocument& net, std::uint32_t vertex);

/// Returns the edges on the boundary of the combinatorial Dirichlet domain of a vertex, which consists of the triangles
/// lifted breadth first.
[[nodiscard]] Layer combinatorial_dirichlet_layer(const certify::NetDocument& net, std::uint32_t vertex);

/// Returns the triangles of a pseudo net's collars and the boundaries of its ε-collars (the bananas of thesis figure
/// III.9). The triangles do not quite fill the ε-collars. Returns no layers for other nets.
[[nodiscard]] std::vector<Layer> collar_layers(const certify::NetDocument& net);

/// Returns the closed geodesics of a geodesics file: each is a part, in the file's order. The shortest ones of the
/// surface have a layer and a colour of their own, the first, if the file says which these are: that of a systole, or
/// those of a spectrum. For a thick-thin decomposition there are also the boundaries of the collars of the small
/// curves. Requires: `geodesics` was read from a file. The two documents have the same surface, but may have different
/// nets. Also throws NetGeometryError if the surfaces differ, or if a word is not that of a closed geodesic.
[[nodiscard]] std::vector<Layer> geodesics_layers(const certify::NetDocument& net,
                                                  const certify::GeodesicsDocument& geodesics);

/// Returns one of them alone, in the colour that it has there. Requires and throws likewise.
[[nodiscard]] Layer geodesic_layer(const certify::NetDocument& net, const certify::GeodesicsDocument& geodesics,
                                   std::size_t number);

/// Returns the paths of a distance file, with their ends. Requires: `distance` was read from a file. The two documents
/// have the same surface, but may have different nets. Also throws NetGeometryError if the surfaces differ.
[[nodiscard]] Layer distance_layer(const certify::NetDocument& net, const certify::DistanceDocument& distance);

/// Options of a picture.
struct DrawOptions {
  DrawOrder order = DrawOrder::weight;    ///< Which lifts of the triangles are drawn.
  std::uint32_t centre = 0;               ///< The vertex in the centre.
  bool triangles = true;                  ///< The edges of the triangles.
  bool vertices = true;                   ///< A dot for each.
  bool dirichlet = false;                 ///< The Dirichlet domain of the centre (dirichlet_layer).
  bool combinatorial_dirichlet = false;   ///< The outline of the triangles lifted breadth first from the centre.
  bool covering_disks = false;            ///< Disks of radius ε around the vertices: they cover the surface.
  bool packing_disks = false;             ///< Disks of radius ε/2: they do not overlap.
  Colouring colouring = Colouring::none;  ///< Of the triangles.
  std::vector<double> values = {};        ///< By vertex, not negative; a triangle has the mean of its corners.
  std::string values_name = {};           ///< The name of the values in the legend.
  bool legend = false;                    ///< A legend of the colours, in a corner.
  std::vector<Layer> layers = {};         ///< Drawn on top, within the lifts of the triangles.
  std::uint32_t size = 1000;              ///< Width and height in pixels, 50 to 20000.
};

/// Returns the net as an SVG picture on white: the edges of one lift of every triangle as geodesic arcs, the vertices
/// as dots, and the boundary circle.
///
/// Strokes and dots shrink with the hyperbolic metric towards the circle; edges and dots too small to see (a tenth of a
/// pixel) are left out, and `<desc>` says so. Arcs that a chord follows to within 0.01 pixel are written as chords.
/// What cannot be drawn of a net, curves of layers or the Dirichlet domain, is left out by name: `<desc>` and the
/// legend name it, and `left_out`, if given, gets a line "name: reason" for each. Equal documents and options give
/// equal bytes. Throws NetGeometryError. Throws std::invalid_argument for Colouring::values unless there is one value
/// per vertex. O(n log n) for n triangles.
[[nodiscard]] std::string draw_svg(const certify::NetDocument& document, const DrawOptions& options = {},
                                   std::vector<std::string>* left_out = nullptr);

// An HTML page that shows a net and lets the reader travel in it.

/// Options of a page.
struct ViewerOptions {
  std::string title;  ///< Plain text in UTF-8.
  /// The certificate that the page shows; without one it says "not certified".
  std::optional<certify::Certificate> certificate = {};
  std::vector<Layer> layers = {};      ///< Shown on top of the triangulation, each with a switch.
  std::vector<double> distances = {};  ///< By vertex: its distance from vertex 0, as a colouring; none if empty.
};

/// Returns the layers of every page: the tiles of the surface, the Dirichlet domain of vertex 0 and the combinatorial
/// one, all switched off, and the collars of a pseudo net. A layer that cannot be computed is empty, and its `left_out`
/// has the reason. Throws NetGeometryError if the document is not a net.
[[nodiscard]] std::vector<Layer> standard_layers(const certify::NetDocument& document);

/// Returns what a viewer shows, as a JSON object for the class `Net` of netgen/pictures/viewer/unfolding.js: the
/// triangulation of the net, its numbers and its verdict. Equal arguments give equal bytes. Throws NetGeometryError if
/// the document is not a net. O(triangles).
[[nodiscard]] std::string viewer_data(const certify::NetDocument& document, const ViewerOptions& options);

/// Returns one self-contained HTML page (netgen/pictures/viewer/viewer.html) with the data of `viewer_data`. The page
/// unfolds the triangulation around a point of view that can move without end.
///
/// The page computes in binary64, in coordinates around the point of view, so errors stay invisible wherever it moves.
/// Edges longer than about 60 are beyond it. The facts name layers that are left out. Equal arguments give equal bytes.
/// About 75 bytes per vertex. Throws NetGeometryError if the document is not a net. O(triangles).
[[nodiscard]] std::string viewer_page(const certify::NetDocument& document, const ViewerOptions& options);

}  // namespace epsnet
