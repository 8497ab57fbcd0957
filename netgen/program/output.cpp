#include "netgen/program/output.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "certify/file/writer.h"

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
      if (are_one(read[i], read[k]) && !S_ISREG(read[i].status.st_mode))
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

}  // namespace epsnet::program
