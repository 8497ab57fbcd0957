#include "netgen/program/parse_error.h"

#include <algorithm>
#include <cstddef>

namespace epsnet::program {
namespace {

/// Returns how many letters must be inserted, deleted, replaced or swapped with the next one (optimal string
/// alignment).
std::size_t typing_errors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        d[i][k] = i + k;
        continue;
      }
      d[i][k] = std::min({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        d[i][k] = std::min(d[i][k], d[i - 2][k - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// Returns "; did you mean NAME?" if one of the names is near, or starts with the typed text.
std::string suggestion(const std::string& typed, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 40;
  if (typed.empty() || typed.size() > kLongest) return "";
  const auto bare = [](const std::string& name) {
    return name.substr(std::min(name.find_first_not_of('-'), name.size()));
  };
  const std::string meant = bare(typed);
  std::size_t least = meant.size() / 3 + 1;
  std::string nearest;
  for (const std::string& name : names) {
    const std::string candidate = bare(name);
    const std::size_t errors = meant.size() > 1 && candidate.starts_with(meant) ? 0 : typing_errors(meant, candidate);
    if (errors < least || (errors == least && nearest.empty() && errors < candidate.size())) {
      least = errors;
      nearest = name;
    }
  }
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
