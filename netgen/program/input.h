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

/// A line of a file, as on the command line, and its name in messages: "FILE:LINE".
struct LineText {
  std::string name;
  std::string text;
};
/// Reads a file with one point, or the like, per line; "#" begins a comment, and blank lines are ignored. Throws
/// JobError if there is none: "no " and what was expected.
[[nodiscard]] std::vector<LineText> read_lines(const std::string& path, const std::string& expected);
/// What is expected of a file of points.
inline constexpr const char* kPointLines = "points, expected one on each line, as in 0,1/10,-0.25";
/// Reads a word: the numbers of sides, with spaces or commas between them. Throws JobError; the message begins with
/// `name`.
[[nodiscard]] Word parse_word(const std::string& name, const std::string& text);

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
