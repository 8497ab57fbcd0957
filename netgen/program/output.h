#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <variant>

#include "epsnet/certify/ball.h"
#include "epsnet/certify/document.h"
#include "epsnet/triangulation/error.h"
#include "epsnet/triangulation/surface.h"

/// What the commands of the program share: files in and out, progress, errors.
namespace epsnet::program {

/// An option's value that cannot be meant.
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

/// "-" means standard output.
[[nodiscard]] bool is_stdout(const std::string& path);

/// Throws JobError if standard output takes no more.
void write_stdout(const std::function<void(std::ostream&)>& write);

/// Writes a complete file or none.
void write_output(const std::string& path, const std::function<void(std::ostream&)>& write);

/// Fails now, rather than after a long computation, if there is no such directory.
void check_output_directory(const std::string& path);

/// A report to standard output, or to standard error if a file goes to standard output: a net there stays a net.
void write_report(const std::string& report, bool stdout_taken);

/// A surface file or a net file. Throws as the readers of both.
[[nodiscard]] std::variant<Surface, certify::Document> load_surface_or_net(const std::string& path);

/// "[lower, upper]", digits that round-trip.
[[nodiscard]] std::string interval_text(certify::Interval x);

/// Shows how far we are on a terminal, after the first second; wipes its line at the end.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const std::string& text, double share);

 private:
  bool terminal_;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

}  // namespace epsnet::program
