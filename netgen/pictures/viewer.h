#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "netgen/pictures/draw.h"

/// An HTML page that shows a net and lets the reader travel in it.
namespace epsnet {

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
