#pragma once

#include <string>
#include <variant>
#include <vector>

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

}  // namespace epsnet::certify::program
