#include "netgen/program/help.h"

#include <algorithm>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "netgen/program/commands.h"
#include "netgen/program/output.h"
#include "netgen/program/parse_error.h"

namespace epsnet::program {
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kColumnOfTexts = 30;  // CLI11's.

/// The column in which a line goes on that is too long.
std::size_t continued_at(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const bool is_row = begin == 2 && line[kColumnOfTexts - 1] == ' ';
  return is_row ? kColumnOfTexts : begin;
}

/// Whether a line is the head of an option, with its text on the next lines.
bool is_head(std::string_view line) {
  return line.starts_with("  -") && line[kColumnOfTexts - 1] != ' ' && line.find("  ", 2) == std::string_view::npos;
}

/// A head breaks between choices: cmake/help/rows.awk joins a line that ends in | with the next one.
std::string wrapped_head(std::string_view line) {
  const std::string indent(4, ' ');
  std::string result;
  while (line.size() > kColumns) {
    const std::size_t end = line.rfind('|', kColumns - indent.size() - 1);
    if (end == std::string_view::npos) break;
    result += std::string(line.substr(0, end + 1)) + '\n' + indent;
    line.remove_prefix(end + 1);
  }
  return result + std::string(line);
}

std::string wrapped_line(std::string_view line) {
  if (line.size() <= kColumns) return std::string(line);
  if (is_head(line)) return wrapped_head(line);
  const std::size_t indent = continued_at(line);
  std::string result(line.substr(0, indent));
  std::size_t column = indent;
  std::istringstream words{std::string(line.substr(indent))};
  for (std::string word; words >> word; column += word.size()) {
    if (column == indent) {
      result += word;
    } else if (column + 1 + word.size() <= kColumns) {
      result += ' ' + word;
      ++column;
    } else {
      result += '\n' + std::string(indent, ' ') + word;
      column = indent;
    }
  }
  return result;
}

/// Returns the help of the command of these names, such as {"surface", "octagon"}; that of `app` if there are none.
/// Throws UsageError if there is no such command.
std::string help_of(const CLI::App& app, const std::vector<std::string>& names) {
  const CLI::App* command = &app;
  std::string full_name = app.get_name();
  for (const std::string& name : names) {
    const auto found = command->get_subcommands([&](const CLI::App* inner) { return inner->get_name() == name; });
    if (found.empty()) throw UsageError(unknown_command_message(app, *command, name));
    command = found.front();
    full_name += ' ' + name;
  }
  // Not App::help, which prints the help of the command that is running.
  return app.get_formatter()->make_help(command, full_name, CLI::AppFormatMode::Normal);
}

}  // namespace

std::string wrapped_help(std::string_view help) {
  std::string result;
  bool in_examples = false;
  std::istringstream lines{std::string(help)};
  for (std::string line; std::getline(lines, line);) {
    in_examples = line.starts_with("Example") || (in_examples && !line.empty());
    result += (in_examples ? line : wrapped_line(line)) + '\n';
  }
  return result;
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  return wrapped_help(CLI::Formatter::make_help(app, std::move(name), mode));
}

void add_help_command(CLI::App& app, Job& chosen) {
  const auto names = std::make_shared<std::vector<std::string>>();
  CLI::App* help = app.add_subcommand("help", "Print the help of a command, as COMMAND --help does, or this text.");
  help->add_option("COMMAND", *names, "the command, as in surface octagon")->option_text("...");
  help->footer("Example:\n  epsnet help net\n  epsnet help surface octagon");
  help->callback([&app, &chosen, names] {
    chosen = [&app, names] { write_stdout([&](std::ostream& out) { out << help_of(app, *names); }); };
  });
}

}  // namespace epsnet::program
