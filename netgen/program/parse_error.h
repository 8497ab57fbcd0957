#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace epsnet::program {

/// Returns in one line what is wrong with a command line that `app` could not parse: an unknown command or option with
/// the one that may have been meant, or the message of CLI11.
[[nodiscard]] std::string explained(const CLI::App& app, const CLI::ParseError& error);

/// Returns the message for a command line that was parsed, but names no command.
[[nodiscard]] std::string no_command_message(const CLI::App& app);

}  // namespace epsnet::program
