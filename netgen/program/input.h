#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "certify/file/reader.h"
#include "certify/net/document.h"
#include "netgen/exchange/exchange.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/surface.h"

/// Input files. Every file is read once (certify::load), so it may be a pipe; "-" is standard input. Errors name the
/// path as given. All functions throw certify::FileError, and the exceptions of the readers.
namespace epsnet::program {

/// A text that another program wrote, and its name in messages.
struct TextInput {
  std::string name;
  std::string text;
};
[[nodiscard]] TextInput read_text_input(const std::string& path);

/// The surface of a surface file, or of any file about one (parse_surface_file).
[[nodiscard]] Surface read_surface_input(const std::string& path);
[[nodiscard]] certify::NetDocument read_net_input(const std::string& path);

/// A surface, and the net of the same file, if there is one.
struct SurfaceOrNet {
  Surface surface;
  std::optional<certify::NetDocument> net;
};
/// Of a net file both; of any other file that has a surface, the surface.
[[nodiscard]] SurfaceOrNet read_surface_or_net(const std::string& path);

/// A point of a file of points, as on the command line, and its name in messages: "FILE:LINE".
struct PointText {
  std::string name;
  std::string text;
};
/// Reads a file with one point per line; "#" begins a comment, and blank lines are ignored. Throws JobError if there is
/// no point.
[[nodiscard]] std::vector<PointText> read_points(const std::string& path);

/// A surface that was imported from a text of another program.
struct ImportedSurface {
  ExchangeFormat format;
  Surface surface;
};

/// The contents of any file that the program writes or imports.
using Contents = std::variant<Surface, certify::ClaimDocument, DirichletPolygon, ImportedSurface>;
[[nodiscard]] Contents read_any_input(const std::string& path);
/// The net of a net file; null for any other contents.
[[nodiscard]] const certify::NetDocument* net_in(const Contents& contents);

}  // namespace epsnet::program
