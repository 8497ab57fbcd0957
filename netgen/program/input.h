#pragma once

#include <string>
#include <variant>

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
