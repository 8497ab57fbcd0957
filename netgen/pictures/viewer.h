#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/document/document.h"
#include "certify/document/report.h"
#include "netgen/pictures/draw.h"

/// A net as a page to look at and to travel in.
namespace epsnet {

/// What a page says and shows.
struct ViewerOptions {
  std::string title;  ///< Plain text in UTF-8.
  /// What the page says of the net; without one, "not certified".
  std::optional<certify::Certificate> certificate = {};
  std::vector<Layer> layers = {};      ///< Shown on top of the triangulation, each with a switch.
  std::vector<double> distances = {};  ///< By vertex, from vertex 0, as a colouring; none, if it is empty.
};

/// One HTML page that needs nothing else: the triangulation of the net, unfolded afresh around a point of view that can
/// be moved without end, its numbers and its verdict (netgen/pictures/viewer.html is the page).
///
/// The page computes in binary64, but in coordinates around the point of view, which keep it exact to the eye wherever
/// it goes; edges longer than about 60 are beyond it. Equal arguments give equal bytes. About 75 bytes per vertex.
/// Throws NetGeometryError if the document is not a net. O(triangles).
[[nodiscard]] std::string viewer_page(const certify::NetDocument& document, const ViewerOptions& options);

}  // namespace epsnet
