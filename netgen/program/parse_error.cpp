#include "netgen/program/parse_error.h"

#include "certify/base/text.h"

namespace epsnet::program {
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
