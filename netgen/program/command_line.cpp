#include "netgen/program/command_line.h"

#include <algorithm>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/program/commands.h"
#include "netgen/program/output.h"

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

namespace {

/// Returns "; did you mean NAME?" if there is such a name.
std::string suggestion(const std::string& typed, const std::vector<std::string>& names) {
  const std::string nearest = certify::nearest_name(typed, names);
  return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Returns the innermost command that was named.
const CLI::App& innermost(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : innermost(*commands.front());
}

/// Returns a prefix such as "net: "; empty for the program itself.
std::string place(const CLI::App& app, const CLI::App& command) {
  std::string result;
  for (const CLI::App* at = &command; at != &app; at = at->get_parent()) result = at->get_name() + ' ' + result;
  if (!result.empty()) result.back() = ':';
  return result.empty() ? "" : result + ' ';
}

std::string in_double_quotes(const std::string& text) {
  constexpr std::size_t kShown = 80;
  return '"' + text.substr(0, kShown) + (text.size() > kShown ? "..." : "") + '"';
}

/// Returns a list such as "net, surface or info".
std::string listed(const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i)
    result += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return result;
}

constexpr const char* kHelp = " (try --help)";

}  // namespace

std::string unknown_command_message(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const std::vector<std::string> commands = command_names(command);
  const std::string where = place(app, command);
  if (commands.empty()) return where + "one argument too many, " + in_double_quotes(word) + kHelp;
  const std::string meant = suggestion(word, commands);
  return where + "unknown command " + in_double_quotes(word) +
         (meant.empty() ? "; expected " + listed(commands) : meant) + kHelp;
}

std::string explained(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = innermost(app);
  const std::string where = place(app, command);
  // Unknown names are reported first, as a mistyped option is also a missing one.
  const bool has_commands = !command_names(command).empty();
  for (const std::string& word : command.remaining()) {
    if (has_commands && !word.starts_with('-')) return unknown_command_message(app, command, word);
  }
  for (const std::string& word : command.remaining()) {
    if (word.size() > 1 && word.front() == '-' && word != "--") {
      const std::string name = word.substr(0, word.find('='));
      return where + "unknown option " + in_double_quotes(name) + suggestion(name, option_names(command)) + kHelp;
    }
  }
  // An option that was taken for the value of another.
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.size() > 1 && value.front() == '-' && command.get_option_no_throw(value) != nullptr)
        return where + option->get_name() + ": a value is missing, " + in_double_quotes(value) + " follows" + kHelp;
    }
  }
  for (const std::string& word : command.remaining()) {
    if (word != "--") return where + "one argument too many, " + in_double_quotes(word) + kHelp;
  }
  std::string text = error.what();
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    // "Could not convert: OPTION = TEXT": only whole numbers are converted.
    const std::size_t colon = text.find(": ");
    if (colon != std::string::npos) text = text.substr(colon + 2);
    text += ": not a whole number that the option can take";
  } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    // "OPTION: 1 required TEXT missing", with the text of the help, or "OPTION: At Most 1 required but received 2".
    const bool many = text.find("At Most") != std::string::npos;
    text = text.substr(0, text.find(':')) + (many ? ": given more than once" : ": a value is missing");
  }
  return where + text + kHelp;
}

std::string no_command_message(const CLI::App& app) {
  const CLI::App& command = innermost(app);
  return place(app, command) + "which command, " + listed(command_names(command)) + "?" + kHelp;
}

}  // namespace epsnet::program
