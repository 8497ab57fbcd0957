#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace epsnet::program {

/// Returns in one line what is wrong with a command line that `app` could not parse: an unknown command or option with
/// the one that may have been meant, or the message of CLI11.
[[nodiscard]] std::string explained(const CLI::App& app, const CLI::ParseError& error);

/// Returns the message for a word in the place of a command of `command`, which is `app` or one of its commands, if
/// there is none of that name: with the one that may have been meant, or a list.
[[nodiscard]] std::string unknown_command_message(const CLI::App& app, const CLI::App& command,
                                                  const std::string& word);

/// Returns the message for a command line that was parsed, but names no command.
[[nodiscard]] std::string no_command_message(const CLI::App& app);

}  // namespace epsnet::program
