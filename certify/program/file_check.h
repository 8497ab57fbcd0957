#pragma once

#include <string>
#include <variant>
#include <vector>

#include "certify/program/output.h"
#include "certify/verdict/report.h"

namespace epsnet::certify::program {

/// What the command line asks for.
struct Request {
  std::vector<std::string> files;
  CheckOptions options;
  bool exact = false;  ///< Ask the second checker about nets of any size.
  bool json = false;
  bool print_parsed = false;
};

/// The request; or the exit code, after the help, the version or what is wrong was printed.
[[nodiscard]] std::variant<Request, int> parse_command_line(int argc, char** argv);

/// Reads a file once and has both checkers check its bytes. Shows how far it is on a terminal, unless the options say
/// who is told. A fault of this program is reported and no verdict.
[[nodiscard]] FileReport check_file(const Request& request, const std::string& path);

}  // namespace epsnet::certify::program
