#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "certify/document/cover_document.h"
#include "certify/document/distance_document.h"
#include "certify/document/document.h"
#include "certify/document/geodesics_document.h"
#include "netgen/exchange/exchange.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface.h"

/// Files in: every file that a command reads is read once (certify::load), so that it may be a pipe; "-" is standard
/// input. Errors name the path as it was given. All throw certify::FileError, and what the readers of the formats
/// throw.
namespace epsnet::program {

/// A text that another program wrote, and what messages call it.
struct TextInput {
  std::string name;
  std::string text;
};
[[nodiscard]] TextInput read_text_input(const std::string& path);

[[nodiscard]] Surface read_surface_input(const std::string& path);
[[nodiscard]] certify::NetDocument read_net_input(const std::string& path);

/// A surface, and the net in whose file it is.
struct SurfaceOrNet {
  Surface surface;
  std::optional<certify::NetDocument> net;
};
/// A surface file or a net file. Throws JobError for any other.
[[nodiscard]] SurfaceOrNet read_surface_or_net(const std::string& path);

/// A point of a file of points, in words of the command line, and what messages call it: "FILE:LINE".
struct PointText {
  std::string name;
  std::string text;
};
/// A file with a point on each line; blank lines, and what follows "#", are left out. Throws JobError if there is none.
[[nodiscard]] std::vector<PointText> read_points(const std::string& path);

/// A surface that was imported from a text of another program.
struct ImportedSurface {
  ExchangeFormat format;
  Surface surface;
};

/// What any file that the program writes or imports holds.
using Contents = std::variant<Surface, certify::NetDocument, certify::GeodesicsDocument, certify::DistanceDocument,
                              certify::CoverDocument, DirichletPolygon, ImportedSurface>;
[[nodiscard]] Contents read_any_input(const std::string& path);

}  // namespace epsnet::program
