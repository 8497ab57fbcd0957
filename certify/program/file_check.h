#pragma once

#include <string>

#include "certify/program/options.h"
#include "certify/program/output.h"

namespace epsnet::certify::program {

/// Reads a file once and has both checkers check its bytes. Shows how far it is on a terminal, unless the options say
/// who is told. A fault of this program is reported and no verdict.
[[nodiscard]] FileReport check_file(const Request& request, const std::string& path);

}  // namespace epsnet::certify::program
