#include <cstdio>
#include <exception>
#include <flint/flint.h>
#include <iostream>
#include <string>
#include <variant>

#include "certify/file/reader.h"
#include "certify/numbers/ball.h"
#include "certify/program/file_check.h"
#include "certify/program/options.h"
#include "certify/program/output.h"
#include "certify/program/signals.h"

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
    const bool named = report.is_surface || (report.error.empty() && report.certificate.verdict == Verdict::malformed);
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
