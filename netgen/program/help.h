#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

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

}  // namespace epsnet::program
