#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/distance/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "kernel/numbers.h"
#include "netgen/lifts/lifts.h"

/// Pictures of nets in the Poincaré disk, and a page in which the reader travels. Nothing here is proved. All functions
/// throw NetGeometryError if the structure of the document is not that of a net; they do not check its geometry.
namespace epsnet {

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
