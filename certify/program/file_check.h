#pragma once

#include <string>

#include "certify/program/options.h"
#include "certify/program/output.h"

namespace epsnet::certify::program {

/// Reads a file once and has both checkers check its bytes. Shows how far it is on a terminal.
[[nodiscard]] FileReport check_file(const Request& request, const std::string& path);

}  // namespace epsnet::certify::program
