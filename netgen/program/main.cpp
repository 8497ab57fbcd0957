#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <new>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "certify/base/error.h"
#include "certify/base/text.h"
#include "netgen/base/atomic_file.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// The program `epsnet`: makes surfaces, computes and certifies nets, draws them, and describes files.
namespace epsnet::program {
namespace {

// What the command line says by itself: help,

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

/// The text of --help with lines of at most 80 columns. A line that is longer is broken at spaces, and goes on below
/// where its text began: that of an option in the column of the texts, any other under its first letter. Lines of
/// examples stay whole, as they are to be copied.
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

/// Help as CLI11 formats it, wrapped.
class HelpFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    return wrapped_help(CLI::Formatter::make_help(app, std::move(name), mode));
  }
};

// and what is wrong with it.

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

/// Returns the message for a word in the place of a command of `command`, which is `app` or one of its commands, if
/// there is none of that name: with the one that may have been meant, or a list.
std::string unknown_command_message(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const std::vector<std::string> commands = command_names(command);
  const std::string where = place(app, command);
  if (commands.empty()) return where + "one argument too many, " + in_double_quotes(word) + kHelp;
  const std::string meant = suggestion(word, commands);
  return where + "unknown command " + in_double_quotes(word) +
         (meant.empty() ? "; expected " + listed(commands) : meant) + kHelp;
}

/// Returns in one line what is wrong with a command line that `app` could not parse: an unknown command or option with
/// the one that may have been meant, or the message of CLI11.
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

/// Returns the message for a command line that was parsed, but names no command.
std::string no_command_message(const CLI::App& app) {
  const CLI::App& command = innermost(app);
  return place(app, command) + "which command, " + listed(command_names(command)) + "?" + kHelp;
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

namespace {

using namespace epsnet;
using namespace epsnet::program;

// The only exit codes.
constexpr int kExitFine = 0;
constexpr int kExitFailed = 1;
constexpr int kExitUndecided = 2;
constexpr int kExitUsage = 64;
constexpr int kExitInternal = 70;

/// Returns a text on one line, so that no text of a file or of the command line can start another line.
std::string one_line(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 32 || code == 127) c = code == '\n' ? ' ' : '?';
  }
  return result;
}

int fail(int code, std::string_view text) {
  std::cerr << "epsnet: " << one_line(text) << '\n';
  return code;
}

// Address sanitizer reserves terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitMemory = false;
#elif defined(__has_feature)
constexpr bool kLimitMemory = !__has_feature(address_sanitizer);
#else
constexpr bool kLimitMemory = true;
#endif

/// Limits memory to that of the machine, so that a lack of it gives std::bad_alloc and one clear line, and does not end
/// other programs.
void limit_memory() {
  if (!kLimitMemory) return;
  struct sysinfo machine = {};
  struct rlimit limit = {};
  if (sysinfo(&machine) != 0 || getrlimit(RLIMIT_AS, &limit) != 0) return;
  rlim_t bytes = (rlim_t{machine.totalram} + machine.totalswap) * machine.mem_unit;
  if (std::ifstream group("/sys/fs/cgroup/memory.max"); group) {
    std::uint64_t allowed = 0;
    if (group >> allowed) bytes = std::min<rlim_t>(bytes, allowed);
  }
  limit.rlim_cur = std::min(limit.rlim_cur, bytes);
  (void)setrlimit(RLIMIT_AS, &limit);
}

/// Adds the commands, in groups and in the order of --help.
void add_commands(CLI::App& app, Job& chosen) {
  struct Group {
    const char* name;
    std::vector<void (*)(CLI::App&, Job&)> commands;
  };
  const std::vector<Group> groups = {
      {"Surfaces", {add_surface_command, add_pants_command, add_dirichlet_command, add_maximize_command}},
      {"Nets", {add_net_command, add_import_net_command, add_locate_command}},
      {"Lengths and distances",
       {add_systole_command, add_spectrum_command, add_thick_thin_command, add_local_maximum_command,
        add_curves_command, add_mapping_class_command, add_distance_command, add_distances_command,
        add_eccentricity_command, add_diameter_command, add_radius_command, add_embedded_disk_command}},
      {"Spectrum and symmetries",
       {add_eigenvalues_command, add_bands_command, add_gap_command, add_lattice_command, add_isometries_command,
        add_isometric_command, add_identify_command}},
      {"Files and pictures",
       {add_info_command, add_draw_command, add_view_command, add_export_command, add_convert_command,
        add_help_command}},
  };
  for (const Group& group : groups) {
    for (const auto add : group.commands) {
      add(app, chosen);
      app.get_subcommands([](const CLI::App*) { return true; }).back()->group(group.name);
    }
  }
}

int run(int argc, char** argv) {
  Job chosen;
  CLI::App app(
      "Epsilon-nets of closed hyperbolic surfaces, each with a proof.\n"
      "In an epsilon-net every point of the surface is within epsilon of a vertex, and the vertices are at least "
      "epsilon apart.",
      "epsnet");
  app.formatter(std::make_shared<HelpFormatter>());
  // 0: an unknown command is then named; a missing one is found below.
  app.require_subcommand(0, 1);
  add_commands(app, chosen);
  app.set_version_flag("--version", "epsnet " EPSNET_VERSION);
  app.footer(
      "Example:\n"
      "  epsnet surface octagon --seed 123 -o s.json\n"
      "  epsnet net s.json --epsilon 0.1 -o net.json --svg net.svg\n"
      "  certify net.json\n\n"
      "Exit codes: 0 success, 1 the job failed, 2 undecided (import-net, isometric, identify, isometries, "
      "local-maximum, surface matrices), 64 invalid command line, 70 internal fault.\n"
      "An interrupted command leaves no files behind.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success);  // --help, --version
    std::cout.flush();
    return std::cout ? kExitFine : fail(kExitFailed, "cannot write to standard output");
  } catch (const CLI::ParseError& error) {
    return fail(kExitUsage, explained(app, error));
  }
  if (!chosen) return fail(kExitUsage, no_command_message(app));

  try {
    chosen();
    return kExitFine;
  } catch (const UsageError& error) {
    return fail(kExitUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kExitFailed, "not enough memory");
  } catch (const UndecidedError& error) {
    return fail(kExitUndecided, error.what());
  } catch (const NotCertifiedError& error) {
    return fail(kExitFailed, std::string(error.what()) + "; nothing was written");
  } catch (const certify::LocatedError& error) {
    return fail(kExitFailed, error.what());
  }
}

/// Ends the program after what cannot be caught: GMP and FLINT out of memory, std::terminate, a crash.
/// Async-signal-safe.
[[noreturn]] void end_on_signal(int) {
  remove_temporary_files();
  constexpr std::string_view kText = "epsnet: internal fault\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kText.data(), kText.size());
  _exit(kExitInternal);
}

/// Ends the program after an interrupt: no temporary file stays behind, and a process that waits for this one sees the
/// signal. Async-signal-safe.
void end_interrupted(int signal) {
  remove_temporary_files();
  std::signal(signal, SIG_DFL);
  static_cast<void>(raise(signal));  // Delivered when this handler returns.
}

}  // namespace

int main(int argc, char** argv) {
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGILL}) std::signal(signal, end_on_signal);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM}) {
    // Ignored signals stay ignored, for nohup.
    if (std::signal(signal, end_interrupted) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  // With these signals ignored, writing fails with an error, which gives a message.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  std::ios::sync_with_stdio(false);
  limit_memory();
  try {
    return run(argc, argv);
  } catch (const certify::Fault& fault) {
    return fail(kExitInternal, fault.what());
  } catch (const std::exception& error) {
    return fail(kExitInternal, std::string("internal fault: ") + error.what());
  } catch (...) {
    return fail(kExitInternal, "internal fault");
  }
}
