#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

/// What the command line says by itself: help, and what is wrong with it.
namespace epsnet::program {

/// The text of --help with lines of at most 80 columns. A line that is longer is broken at spaces, and goes on below
/// where its text began: that of an option in the column of the texts, any other under its first letter. Lines of
/// examples stay whole, as they are to be copied.
[[nodiscard]] std::string wrapped_help(std::string_view help);

/// Help as CLI11 formats it, wrapped.
class HelpFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

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
