#include "netgen/program/files.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims.h"
#include "certify/file/compact.h"
#include "certify/file/document_reader.h"
#include "certify/file/file.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::program {

bool is_stdout(const std::string& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

std::string word_text(const std::vector<std::uint32_t>& word) {
  std::string result;
  for (const std::uint32_t side : word) result += (result.empty() ? "" : " ") + std::to_string(side);
  return result;
}

std::string word_text(const Word& word) { return word_text(letters_of(word)); }

void write_stdout(const std::function<void(std::ostream&)>& write) {
  write(std::cout);
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) throw JobError("cannot write to standard output");
}

namespace {

namespace fs = std::filesystem;

struct TypeOfFile {
  FileType type;
  std::vector<std::string> extensions;  ///< The first is the usual one. Empty: any that is not of another type.
  std::string what;
};

const std::vector<TypeOfFile>& types_of_files() {
  static const std::vector<TypeOfFile> types{
      {FileType::json, {}, "JSON"},
      {FileType::compact, {".epsn"}, "a compact net file"},
      {FileType::text, {}, "plain text"},
      {FileType::svg, {".svg"}, "an SVG picture"},
      {FileType::png, {".png"}, "a PNG picture"},
      {FileType::html, {".html", ".htm", ".xhtml"}, "an HTML page"},
      {FileType::off, {".off"}, "OFF"},
      {FileType::vtu, {".vtu"}, "VTU"},
      {FileType::npy, {".npy"}, "a NumPy array"},
      {FileType::msh, {".msh"}, "Gmsh's MSH"},
      {FileType::mesh, {".mesh"}, "a mesh of Medit or MFEM"},
      {FileType::mtx, {".mtx"}, "a MatrixMarket matrix"},
  };
  return types;
}

const TypeOfFile& type_of_file(FileType type) {
  const auto& types = types_of_files();
  return *std::find_if(types.begin(), types.end(), [&](const TypeOfFile& t) { return t.type == type; });
}

/// Returns the extension in lower case; none for a directory, which is refused for being one.
std::string extension_of(const std::string& path) {
  std::error_code error;
  if (is_stdout(path) || fs::is_directory(path, error)) return "";
  std::string result = fs::path(path).extension().string();
  for (char& c : result) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

/// Returns the type of an extension that belongs to only one type.
const TypeOfFile* type_of_extension(const std::string& extension) {
  for (const TypeOfFile& type : types_of_files()) {
    if (std::find(type.extensions.begin(), type.extensions.end(), extension) != type.extensions.end()) return &type;
  }
  return nullptr;
}

void check_extension(const OutputFile& output) {
  const TypeOfFile& type = type_of_file(output.type);
  const std::string extension = extension_of(output.path);
  if (extension.empty()) return;
  const TypeOfFile* other = type_of_extension(extension);
  if (other == &type) return;
  const bool is_picture = output.type == FileType::svg || output.type == FileType::png;
  if (other == nullptr && !is_picture) return;
  throw UsageError(output.option + ": " + output.path + ": this is " + type.what +
                   (type.extensions.empty() ? "" : ", so the name must end in " + type.extensions.front()) +
                   (other != nullptr ? "; " + extension + " is for " + other->what : ""));
}

/// The identity of the file at a path, however the path is spelled.
struct Identity {
  struct stat status = {};
  bool exists = false;
  fs::path would_be;  ///< Where a file would be made.
};

Identity identity_of(const std::string& path, int standard_stream) {
  Identity result;
  if (path == "-" || (standard_stream == STDOUT_FILENO && is_stdout(path))) {
    result.exists = ::fstat(standard_stream, &result.status) == 0;
    return result;
  }
  result.exists = ::stat(path.c_str(), &result.status) == 0;
  std::error_code error;
  if (!result.exists) result.would_be = fs::weakly_canonical(followed_links(path), error);
  return result;
}

bool are_one(const Identity& a, const Identity& b) {
  if (a.exists && b.exists) return a.status.st_dev == b.status.st_dev && a.status.st_ino == b.status.st_ino;
  return !a.exists && !b.exists && !a.would_be.empty() && a.would_be == b.would_be;
}

/// Returns a name such as "--output (x.json)".
std::string named(const std::string& option, const std::string& path) {
  return option + (path == "-" ? "" : " (" + path + ")");
}

}  // namespace

FileType picture_type(const std::string& option, const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension.empty() || extension == ".svg") return FileType::svg;
  if (extension == ".png") return FileType::png;
  throw UsageError(option + ": " + path + ": a picture is .svg or .png, not " + extension);
}

FileType net_type(const std::string& path) {
  return extension_of(path) == ".epsn" ? FileType::compact : FileType::json;
}

void write_net_file(const certify::NetDocument& net, const std::string& path, std::ostream& out) {
  if (net_type(path) == FileType::json) {
    certify::write_file(net, out);
    return;
  }
  try {
    certify::write_compact_net(net, out);
  } catch (const std::invalid_argument& error) {
    throw JobError(path + ": " + error.what());
  }
}

void check_files(const std::vector<InputFile>& inputs, const std::vector<OutputFile>& all_outputs) {
  std::vector<OutputFile> outputs;
  bool stdout_taken = false;
  for (const OutputFile& output : all_outputs) {
    if (output.path.empty()) continue;
    outputs.push_back(output);
    stdout_taken = stdout_taken || is_stdout(output.path);
    check_extension(output);
  }
  // The report goes to standard output, unless a file does.
  if (!stdout_taken) outputs.push_back({"standard output", "-", FileType::text});

  std::vector<Identity> written;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    written.push_back(identity_of(outputs[i].path, STDOUT_FILENO));
    for (std::size_t k = 0; k < i; ++k) {
      if (is_stdout(outputs[i].path) && is_stdout(outputs[k].path))
        throw UsageError(outputs[k].option + " and " + outputs[i].option + " cannot both be standard output");
      // Several outputs may go to a device such as /dev/null.
      if (are_one(written[i], written[k]) && !S_ISCHR(written[i].status.st_mode))
        throw UsageError(named(outputs[k].option, outputs[k].path) + " and " +
                         named(outputs[i].option, outputs[i].path) + " are one file");
    }
  }
  std::vector<Identity> read;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    read.push_back(inputs[i].path.empty() ? Identity() : identity_of(inputs[i].path, STDIN_FILENO));
    if (inputs[i].path.empty()) continue;
    for (std::size_t k = 0; k < i; ++k) {
      // A file that is standard input goes on where it was read to.
      const bool both_standard = inputs[i].path == "-" && inputs[k].path == "-";
      if (both_standard || (are_one(read[i], read[k]) && !S_ISREG(read[i].status.st_mode)))
        throw UsageError(named(inputs[k].option, inputs[k].path) + " and " + named(inputs[i].option, inputs[i].path) +
                         " are one stream, which can be read only once");
    }
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      if (are_one(read[i], written[k]) && (!read[i].exists || S_ISREG(read[i].status.st_mode)))
        throw UsageError(named(outputs[k].option, outputs[k].path) + " would overwrite the input, " +
                         named(inputs[i].option, inputs[i].path));
    }
  }
  for (const OutputFile& output : outputs) {
    if (!is_stdout(output.path)) check_writable(output.path);
  }
}

void write_outputs(std::vector<NewFile> files) {
  std::erase_if(files, [](const NewFile& file) { return file.path.empty(); });
  const auto standard = std::stable_partition(files.begin(), files.end(),
                                              [](const NewFile& file) { return !is_stdout(file.path.string()); });
  const std::vector<NewFile> to_stdout(standard, files.end());
  files.erase(standard, files.end());
  write_files_atomically(files, [&] {
    for (const NewFile& file : to_stdout) write_stdout(file.write);
  });
}

void write_output(const std::string& path, const std::function<void(std::ostream&)>& write) {
  write_outputs({{path, write}});
}

Report verified_report() { return {"verdict: VERIFIED\n", Json::object({{"verdict", "VERIFIED"}})}; }

void write_left_out(const std::vector<std::string>& left_out) {
  for (const std::string& what : left_out) std::cerr << "left out: " << what << '\n';
}

void write_report(const Report& report, bool as_json, bool stdout_taken) {
  const std::string text = as_json ? json_text(report.json) + '\n' : report.text;
  if (stdout_taken) {
    std::cerr << text;
  } else {
    write_stdout([&](std::ostream& out) { out << text; });
  }
}

namespace {

bool is_json(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && (text[first] == '{' || text[first] == '[');
}

std::optional<std::string> format_in(const std::string& text) {
  certify::ByteStream bytes(text);
  return certify::format_of(bytes);
}

/// Returns the name of a file for readers of texts, which add the line: "NAME:LINE: ".
std::string text_name(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace

TextInput read_text_input(const std::string& path) { return {text_name(path), certify::load(path)}; }

namespace {

Surface surface_of_text(const std::string& text, const std::string& name) {
  if (!is_json(text) && !certify::is_compact(text)) {
    throw JobError(name +
                   ": neither JSON nor compact, expected a surface file, or one about a surface; 'epsnet surface "
                   "import' makes one of a text");
  }
  return parse_surface_file(text, name);
}

}  // namespace

Surface read_surface_input(const std::string& path) {
  return surface_of_text(certify::load(path), certify::display_name(path));
}

certify::NetDocument read_net_input(const std::string& path) {
  const std::string text = certify::load(path);
  const std::string name = certify::display_name(path);
  if (!is_json(text) && !certify::is_compact(text))
    throw JobError(name + ": neither JSON nor compact, expected a net file, made by 'epsnet net'");
  return certify::parse_file<certify::NetDocument>(text, name);
}

Contents read_any_input(const std::string& path) {
  const std::string text = certify::load(path);
  if (certify::is_compact(text)) return certify::parse_file<certify::NetDocument>(text, certify::display_name(path));
  if (!is_json(text)) {
    const ExchangeFormat format =
        is_triangulation_stream(text) ? ExchangeFormat::triangulation : ExchangeFormat::domain;
    return ImportedSurface{format, import_surface(text, text_name(path))};
  }
  const std::string name = certify::display_name(path);
  const std::optional<std::string> named = format_in(text);
  const std::string format = named.value_or("");
  if (format == "epsnet-surface") return parse_surface_file(text, name);
  std::string formats = "epsnet-surface, ";
  for (const certify::ClaimKind& kind : certify::kClaimKinds) {
    if (format == kind.format) return certify::parse_file<certify::ClaimDocument>(text, name);
    formats.append(kind.format).append(", ");
  }
  if (format == "epsnet-dirichlet") return parse_dirichlet_json(text, name);
  throw JobError(name + ": " +
                 (named ? "the member \"format\" is " + certify::in_quotes(format) : "no member \"format\"") +
                 ", expected " + formats + "or epsnet-dirichlet");
}

const certify::NetDocument* net_in(const Contents& contents) {
  const auto* claim = std::get_if<certify::ClaimDocument>(&contents);
  return claim == nullptr ? nullptr : std::get_if<certify::NetDocument>(claim);
}

SurfaceOrNet read_surface_or_net(const std::string& path) {
  const std::string text = certify::load(path);
  const std::string name = certify::display_name(path);
  if (certify::is_compact(text) || (is_json(text) && format_in(text) == "epsnet-net")) {
    certify::NetDocument net = certify::parse_file<certify::NetDocument>(text, name);
    const Surface surface = from_document(net.surface, name);
    return {surface, std::move(net)};
  }
  return {surface_of_text(text, name), std::nullopt};
}

std::vector<LineText> read_lines(const std::string& path, const std::string& expected) {
  std::vector<LineText> result;
  std::istringstream lines(certify::load(path));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.resize(std::min(line.find('#'), line.size()));
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    const std::size_t end = line.find_last_not_of(" \t\r");
    result.push_back({text_name(path) + ":" + std::to_string(number), line.substr(begin, end - begin + 1)});
  }
  if (result.empty()) throw JobError(text_name(path) + ": no " + expected);
  return result;
}

Word parse_word(const std::string& name, const std::string& text) {
  constexpr const char* kSeparators = " \t,";
  Word result;
  for (std::size_t begin = text.find_first_not_of(kSeparators); begin != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, begin), text.size());
    std::uint32_t side = 0;
    const auto [last, error] = std::from_chars(text.data() + begin, text.data() + end, side);
    if (error != std::errc() || last != text.data() + end) {
      throw JobError(name + ": expected numbers of sides, as in 0 3 5, not " +
                     certify::in_quotes(text.substr(begin, end - begin)));
    }
    result.emplace_back(side);
    begin = text.find_first_not_of(kSeparators, end);
  }
  return result;
}

}  // namespace epsnet::program
