#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace epsnet::program {

/// What is wrong with a command line that `app` could not parse, in one line: an unknown command or option with the one
/// that may have been meant, or what CLI11 says of it.
[[nodiscard]] std::string explained(const CLI::App& app, const CLI::ParseError& error);

/// Of a command line that was parsed, but names no command.
[[nodiscard]] std::string no_command_message(const CLI::App& app);

}  // namespace epsnet::program
