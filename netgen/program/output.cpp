#include "epsnet/netgen/program/output.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include "epsnet/certify/reader.h"
#include "epsnet/certify/text.h"
#include "epsnet/netgen/atomic_file.h"
#include "epsnet/netgen/surface_file.h"

namespace epsnet::program {

bool is_stdout(const std::string& path) { return path == "-"; }

void write_stdout(const std::function<void(std::ostream&)>& write) {
  write(std::cout);
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) throw JobError("cannot write to standard output");
}

void write_output(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (is_stdout(path)) {
    write_stdout(write);
  } else {
    write_file_atomically(path, write);
  }
}

void check_output_directory(const std::string& path) {
  if (is_stdout(path)) return;
  std::filesystem::path directory = std::filesystem::path(path).parent_path();
  if (directory.empty()) directory = ".";
  std::error_code error;
  if (!std::filesystem::is_directory(directory, error))
    throw JobError("cannot write '" + path + "': no directory '" + directory.string() + "'");
}

void write_report(const std::string& report, bool stdout_taken) {
  if (stdout_taken) {
    std::cerr << report;
  } else {
    write_stdout([&](std::ostream& out) { out << report; });
  }
}

namespace {

/// A guess, made from the first bytes; members of a file may come in any order. The reader decides.
bool looks_like_surface(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head.find("\"epsnet-surface\"") != std::string::npos;
}

}  // namespace

std::variant<Surface, certify::Document> load_surface_or_net(const std::string& path) {
  if (looks_like_surface(path)) return load_surface(path);
  try {
    return certify::read_net(path);
  } catch (const certify::MalformedError& not_a_net) {
    try {
      (void)certify::read_surface(path);
    } catch (const certify::MalformedError&) {
      throw not_a_net;
    }
    return load_surface(path);
  }
}

std::string interval_text(certify::Interval x) {
  return "[" + certify::shortest(x.lower) + ", " + certify::shortest(x.upper) + "]";
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_once_) std::fprintf(stderr, "\r%44s\r", "");
}

void ProgressLine::show(const std::string& text, double share) {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - shown_ < std::chrono::milliseconds(shown_once_ ? 200 : 1000)) return;
  shown_ = now;
  shown_once_ = true;
  std::fprintf(stderr, "\r%-36s %3.0f %%", text.c_str(), 100 * share);
}

}  // namespace epsnet::program
