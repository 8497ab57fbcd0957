#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <exception>
#include <flint/flint.h>
#include <iostream>
#include <limits>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims.h"
#include "certify/file/file.h"
#include "certify/numbers/ball.h"
#include "certify/program/output.h"

namespace epsnet::certify::program {
namespace {

/// The end for everything that cannot be caught: GMP and FLINT out of memory, std::terminate, a crash.
/// Async-signal-safe.
[[noreturn]] void end_on_signal(int) {
  constexpr std::string_view kText = "certify: internal fault\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kText.data(), kText.size());
  _exit(kExitInternal);
}

// FLINT's own spelling: for clang, a function type with this attribute differs from one with [[noreturn]].
FLINT_NORETURN void end_on_flint_abort() { end_on_signal(0); }

}  // namespace

void catch_signals() {
  // The handler has a stack of its own: the first one may be what has run out.
  alignas(16) static std::array<char, 1 << 16> handler_stack;
  stack_t stack{};
  stack.ss_sp = handler_stack.data();
  stack.ss_size = handler_stack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = end_on_signal;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGILL}) sigaction(signal, &action, nullptr);
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  flint_set_abort(end_on_flint_abort);
}

namespace {

/// Accepts digits only, where CLI11 also takes signs: -1 as an unsigned number is 2⁶⁴ − 1.
CLI::Validator integer_between(std::uint64_t least, std::uint64_t most) {
  return {[=](std::string& text) -> std::string {
            std::uint64_t value = 0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error != std::errc() || stop != end || value < least || most < value)
              return in_quotes(text) + " is not an integer from " + std::to_string(least) + " to " +
                     std::to_string(most);
            text = std::to_string(value);  // CLI11 would read 010 as 8.
            return "";
          },
          ""};
}

std::string unknown_option(const CLI::App& app) {
  std::string unknown = printable(app.remaining().at(0));
  unknown.erase(std::min(unknown.find('='), unknown.size()));
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& long_name : option->get_lnames()) names.push_back("--" + long_name);
  }
  const std::string nearest = nearest_name(unknown, names);
  return unknown + ": no such option" + (nearest.empty() ? "" : ", did you mean " + nearest + "?");
}

// Lines of --help have at most 80 columns; texts of options begin in column 30.

std::string description() {
  std::string text =
      "Checks the claim of each file. Numbers are exact, enclosed in balls, or binary64\n"
      "with bounds for their errors; nothing is taken from the generator.";
  for (const ClaimKind& kind : kClaimKinds) text.append("\n").append(kind.says);
  return text;
}

/// "net, geodesics, … and …", the kinds of files, three on a line.
std::string names_of_files() {
  std::string text;
  for (std::size_t i = 0; i < kClaimKinds.size(); ++i) {
    const char* comma = i % 3 == 0 ? ",\n" : ", ";
    text.append(i == 0 ? "" : i + 1 < kClaimKinds.size() ? comma : " and ").append(kClaimKinds[i].name);
  }
  return text;
}

void add_options(CLI::App& app, Request& request) {
  app.add_option("FILE", request.files, names_of_files() + " files\n(docs/format.md); \"-\" is standard input")
      ->required()
      ->option_text("... REQUIRED");
  app.add_flag("--exact", request.exact,
               "use the second checker (certify-exact) for nets of\nany size and longer lists of geodesics; without\n"
               "this option up to " +
                   std::to_string(kTrianglesCheckedTwice) + " triangles and 4 MB");
  app.add_flag("--json", request.json, "print only one JSON object per file, on one line");
  app.add_option("--threads", request.options.threads, "number of threads, at most 1024; 0 is one per core")
      ->transform(integer_between(0, 1024))
      ->option_text("N [0]");
  app.add_option("--max-precision", request.options.max_precision,
                 "bits after which a comparison is undecided, 64 to\n1048576")
      ->transform(integer_between(kLeastPrecision, kGreatestPrecision))
      ->option_text("N [8192]");
  app.add_option("--max-visits", request.options.max_visits,
                 "lifted triangles visited before a list of\ngeodesics is undecided, at least 1")
      ->transform(integer_between(1, std::numeric_limits<std::uint64_t>::max()))
      ->option_text("N [1000000000]");
  app.add_option("--max-work", request.options.max_work,
                 "units of work before the rest is undecided; 0\nchooses a limit by the size of the file")
      ->transform(integer_between(0, std::numeric_limits<std::uint64_t>::max()))
      ->option_text("N [0]");
  app.add_flag_callback(
      "--no-filter", [&request] { request.options.filter = false; },
      "use ball arithmetic for everything, without the\nfilter in binary64: the same answer, some ten\ntimes slower");
  app.add_flag("--print-parsed", request.print_parsed, "first print the document as it was read")->excludes("--json");
  app.set_version_flag("--version", "certify " EPSNET_VERSION);
  app.footer(
      "Examples:\n"
      "  certify net.json && echo 'this is an epsilon-net'\n"
      "  certify results/*.json\n\n"
      "The last line of output is VERIFIED, REFUTED: rule: why, UNDECIDED: rule: why,\n"
      "or MALFORMED: why; of a file that claims nothing, as one of a surface,\n"
      "NO CLAIM: why.\n"
      "Of several files it is VERIFIED if all of them are; else it names the first that\n"
      "is not, and the exit code is that file's. The line sha256 identifies the bytes\n"
      "that were checked.\n"
      "Files within the limits of the second checker are checked twice: in balls, and\n"
      "by integers. The line second checker says what it found, or why it was not\n"
      "asked, the line verified by who verified the file. If one verifies what the\n"
      "other refutes, the verdict is UNDECIDED: the two checkers disagree.\n"
      "Exit codes: 0 verified, or --help or --version, 1 refuted, 2 undecided,\n"
      "3 malformed file, 4 the two checkers disagree, 5 no claim,\n"
      "64 usage or a file that cannot be read, 70 the machine failed\n"
      "(memory, output that cannot be written), 71 a fault of this program: no verdict,\n"
      "please report it.");
}

}  // namespace

std::variant<Request, int> parse_command_line(int argc, char** argv) {
  Request request;
  CLI::App app(description(), "certify");
  add_options(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version);
    if (std::cout.flush()) return 0;
    std::cerr << "certify: cannot write to standard output\n";
    return kExitInternal;
  } catch (const CLI::ParseError& error) {
    if (app.remaining().empty()) {
      app.exit(error);
    } else {
      std::cerr << unknown_option(app) << "\nRun with --help for more information.\n";
    }
    return kExitUsage;
  }
  if (std::count(request.files.begin(), request.files.end(), "-") > 1) {
    std::cerr << "FILE: standard input can be read only once, expected one \"-\"\n";
    return kExitUsage;
  }
  return request;
}

}  // namespace epsnet::certify::program

/// The program `certify`: reads files of every claim, prints for each what each rule proved and, last, one verdict
/// line.
namespace {

using namespace epsnet::certify;
using namespace epsnet::certify::program;

/// Checks all files and prints what is said of each. The last line and the exit code are those of the first file that
/// is not verified.
int check_files(const Request& request) {
  const bool several = request.files.size() > 1;
  int code = kExitVerified;
  std::string last_line(name(Verdict::verified));
  std::size_t verified = 0;
  const char* separator = "";
  for (const std::string& path : request.files) {
    if (several && !request.json) std::cout << separator << "file: " << display_name(path) << '\n';
    separator = "\n";
    const FileReport report = check_file(request, path);
    const int own_code = exit_code(report);
    const bool named =
        !report.no_claim.empty() || (report.error.empty() && report.certificate.verdict == Verdict::malformed);
    if (own_code == kExitVerified) ++verified;
    if (code == kExitVerified && own_code != kExitVerified) {
      code = own_code;
      last_line = verdict_line(report, several || named ? report.name : "");
    }
    if (!report.error.empty()) std::cerr << "certify: " << report.name << ": " << report.error << '\n';
    if (request.json) {
      std::cout << as_json(report);
    } else {
      std::cout << as_text(report);
      // Not alone on its line, and not at the beginning: the last line of all is the only one to say VERIFIED so.
      if (several) std::cout << report.name << ": " << verdict_line(report, "") << '\n';
    }
    if (!std::cout.flush()) break;
  }
  if (!request.json) {
    if (several) std::cout << "\nverified: " << verified << " of " << request.files.size() << " files\n";
    if (several || code != kExitUsage) std::cout << last_line << '\n';
  }
  if (!std::cout.flush() || std::fflush(stdout) != 0) {
    std::cerr << "certify: cannot write to standard output\n";
    return kExitInternal;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  catch_signals();
  std::ios::sync_with_stdio(false);
  try {
    const auto request = parse_command_line(argc, argv);
    const int code =
        std::holds_alternative<int>(request) ? std::get<int>(request) : check_files(std::get<Request>(request));
    flint_cleanup();
    return code;
  } catch (const std::exception& error) {
    std::cerr << "certify: internal fault: " << error.what() << '\n';
  } catch (...) {
    std::cerr << "certify: internal fault\n";
  }
  return kExitInternal;
}
