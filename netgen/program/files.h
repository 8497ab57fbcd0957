#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "certify/file/file.h"
#include "certify/net/document.h"
#include "certify/numbers/ball.h"
#include "netgen/base/atomic_file.h"
#include "netgen/base/json_text.h"
#include "netgen/exchange/exchange.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/surface.h"

/// What the commands of the program share: files in and out, reports, errors.
namespace epsnet::program {

/// An invalid option value.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The job cannot be done; what() says why.
class JobError : public Error {
 public:
  using Error::Error;
};

/// The job was done, and its question is neither proved nor refuted.
class UndecidedError : public JobError {
 public:
  using JobError::JobError;
};

/// "-" and the names that the system has for it mean standard output.
[[nodiscard]] bool is_stdout(const std::string& path);

/// Throws JobError if standard output takes no more.
void write_stdout(const std::function<void(std::ostream&)>& write);

/// A word in a report: its side numbers, with spaces between them.
[[nodiscard]] std::string word_text(const std::vector<std::uint32_t>& word);
[[nodiscard]] std::string word_text(const Word& word);

/// What a command writes to a file.
enum class FileType { json, compact, text, svg, png, html, off, vtu, npy, msh, mesh, mtx };

/// A file that a command reads. An empty path stands for an option that was not given.
struct InputFile {
  std::string option;
  std::string path;
};

/// A file that a command writes. An empty path stands for an option that was not given.
struct OutputFile {
  std::string option;
  std::string path;
  FileType type;
};

/// Returns the type of a picture by its extension, .svg or .png; svg for standard output and for a name without
/// extension. Throws UsageError for any other extension, and names the two.
[[nodiscard]] FileType picture_type(const std::string& option, const std::string& path);

/// Returns the type of a net file by its extension: compact for .epsn, else JSON.
[[nodiscard]] FileType net_type(const std::string& path);

/// Checks the files of a command; call it before any work. Throws UsageError if two outputs, or an input and an output,
/// are the same file (under any spelling), if the extension of an output is that of another file type, or if a pipe
/// or standard input would be read twice. Throws WriteError if an output cannot be made.
void check_files(const std::vector<InputFile>& inputs, const std::vector<OutputFile>& outputs);

/// Writes complete files, all or none; those without a path are left out.
void write_outputs(std::vector<NewFile> files);
void write_output(const std::string& path, const std::function<void(std::ostream&)>& write);

/// Returns a net as a file of the type that the extension names. Throws JobError if the net cannot be written in that
/// type.
void write_net_file(const certify::NetDocument& net, const std::string& path, std::ostream& out);

/// The report of a command: lines for people, and the same facts for programs.
struct Report {
  std::string text;
  Json json = Json::object();
};

/// Returns the beginning of a report about what is proved.
[[nodiscard]] Report verified_report();

/// Writes what a picture could not show to standard error, one line each.
void write_left_out(const std::vector<std::string>& left_out);

/// Writes a report to standard output. If a file goes to standard output, writes it to standard error instead, so that
/// the file stays intact.
void write_report(const Report& report, bool as_json, bool stdout_taken);

// Input files. Every file is read once (certify::load), so it may be a pipe; "-" is standard input. Errors name the
// path as given. All functions throw certify::FileError, and the exceptions of the readers.

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
