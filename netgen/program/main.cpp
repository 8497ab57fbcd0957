#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>
#include <vector>

#include "certify/base/error.h"
#include "netgen/base/atomic_file.h"
#include "netgen/program/command_line.h"
#include "netgen/program/commands.h"
#include "netgen/program/output.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/error.h"

/// The program `epsnet`: makes surfaces, computes and certifies nets, draws them, and describes files.
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
      {"Surfaces", {add_surface_command, add_pants_command, add_dirichlet_command}},
      {"Nets", {add_net_command, add_import_net_command, add_locate_command}},
      {"Lengths and distances",
       {add_systole_command, add_spectrum_command, add_thick_thin_command, add_distance_command, add_distances_command,
        add_eccentricity_command, add_diameter_command, add_radius_command, add_embedded_disk_command}},
      {"Spectrum and symmetries",
       {add_eigenvalues_command, add_isometries_command, add_isometric_command, add_identify_command}},
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
      "Exit codes: 0 success, 1 the job failed, 2 undecided (import-net, isometric, identify), 64 invalid command "
      "line, 70 "
      "internal fault.\n"
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
