#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/document/distance_document.h"
#include "certify/document/document.h"
#include "certify/document/geodesics_document.h"
#include "kernel/complex.h"
#include "netgen/lifts/layout.h"

/// Pictures of nets in the Poincaré disk. Nothing here is proved; all functions throw NetGeometryError if the document
/// is not a net (its structure is checked, its geometry is not).
namespace epsnet {

/// What the triangles of a picture are filled with.
enum class Colouring {
  none,          ///< Nothing.
  circumradius,  ///< From pale, ε/2 or less, to dark, ε.
  chart,         ///< By the chart of the triangle: where in the net file's coordinates it lies.
  values,        ///< By DrawOptions::values, in bands from pale, 0, to dark, the greatest.
};

/// A piece of a geodesic within one triangle, in the chart of the triangle's corner 0.
struct Arc {
  std::uint32_t triangle;  ///< Its number in the document.
  Complex<double> from;    ///< Where it starts.
  Complex<double> to;      ///< Where it ends.
};

/// What a picture shows beside the triangulation: arcs, edges or triangles, all in one colour.
struct Layer {
  /// A closed geodesic: the arcs from `first_arc` on, up to the next part's, one after the other along it.
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
};

/// The sides of the tiles of the surface. O(triangles + arcs), as all functions that make layers.
[[nodiscard]] Layer tile_layer(const certify::NetDocument& net);

/// The boundary of the Dirichlet domain of a vertex: the points that are nearer to one lift of the vertex than to its
/// other lifts. It is computed from the exact surface, and its sides are proved; see dirichlet_polygon.h. Throws
/// NetGeometryError also where the document's surface is none, and beyond genus 100.
[[nodiscard]] Layer dirichlet_layer(const certify::NetDocument& net, std::uint32_t vertex);

/// The edges on the boundary of the combinatorial Dirichlet domain of a vertex: of the triangles lifted breadth first.
[[nodiscard]] Layer combinatorial_dirichlet_layer(const certify::NetDocument& net, std::uint32_t vertex);

/// Of a pseudo net: the triangles of its collars, and the boundaries of its ε-collars (the bananas of thesis figure
/// III.9), which these triangles do not quite fill. Nothing for other nets.
[[nodiscard]] std::vector<Layer> collar_layers(const certify::NetDocument& net);

/// Closed geodesics, once around each, of a geodesics file about the same surface, with the same net or another one,
/// each a part of the first layer, in the file's order; of a thick-thin decomposition also the boundaries of the
/// collars of the small curves. A document as certify::read_geodesics returns it. Throws NetGeometryError also if the
/// surface is another one, or a word does not stand for a closed geodesic.
[[nodiscard]] std::vector<Layer> geodesics_layers(const certify::NetDocument& net,
                                                  const certify::GeodesicsDocument& geodesics);

/// The paths of a distance file about the same surface, with the same net or another one. A document as
/// certify::read_distance returns it. Throws NetGeometryError also if the surface is another one.
[[nodiscard]] Layer distance_layer(const certify::NetDocument& net, const certify::DistanceDocument& distance);

/// What a picture shows, and how.
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
  std::string values_name = {};           ///< What they are, for the legend.
  bool legend = false;                    ///< What the colours mean, in a corner.
  std::vector<Layer> layers = {};         ///< Drawn on top, within the lifts of the triangles.
  std::uint32_t size = 1000;              ///< Width and height in pixels, 50 to 20000.
};

/// The net as an SVG picture: the edges of one lift of every triangle as geodesic arcs, the vertices as dots, the
/// boundary circle, on white.
///
/// Strokes and dots shrink with the hyperbolic metric towards the circle; edges and dots too small to see (a tenth of a
/// pixel) are left out, and `<desc>` says so. Arcs that a chord follows to within 0.01 pixel are written as chords.
/// Equal documents and options give equal bytes. Throws NetGeometryError, and std::invalid_argument if there is not a
/// value for each vertex where these colour the triangles. O(n log n) for n triangles.
[[nodiscard]] std::string draw_svg(const certify::NetDocument& document, const DrawOptions& options = {});

struct DirichletPolygon;

/// A Dirichlet domain (dirichlet_polygon.h), itself and no other, around the one vertex of its Delaunay triangulation,
/// which is drawn as well.
[[nodiscard]] std::string draw_svg(const DirichletPolygon& polygon, const DrawOptions& options = {});

}  // namespace epsnet
