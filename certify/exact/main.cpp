#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "certify/exact/checker.h"

/// The program `certify-exact FILE`: reads a file (`-` is standard input) and prints one verdict line.
namespace {

constexpr int kExitNoClaim = 5;
constexpr int kExitUsage = 64;
constexpr int kExitInternal = 70;
constexpr std::size_t kMaxBytes = std::size_t{1} << 32;
constexpr const char* kUsage =
    "Usage: certify-exact FILE | --version\n\n"
    "Checks a net, a pseudo net, a geodesics, distance, bound, eigenvalues, isometries, pants,\n"
    "comparison or curves file: a second opinion beside certify, by integers and MPFR.\n"
    "FILE is read completely; - is standard input. Example: certify-exact net.json\n\n"
    "The line of output is VERIFIED, REFUTED: rule: why, UNDECIDED: rule: why, or\n"
    "MALFORMED: why; of a file that claims nothing, as one of a surface, NO CLAIM: why.\n"
    "Exit codes: 0 verified, --help or --version, 1 refuted, 2 undecided, 3 malformed file,\n"
    "5 no claim, 64 usage, 70 internal fault.\n";

/// No text of a file can then pass for a line of output.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
  return text;
}

/// The code, if all that was printed is written.
int ended(int code) {
  if (std::cout.flush()) return code;
  std::cerr << "certify-exact: cannot write to standard output\n";
  return kExitInternal;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << kUsage;
    return kExitUsage;
  }
  const std::string path = argv[1];
  if (path == "--help" || path == "-h") {
    std::cout << kUsage;
    return ended(0);
  }
  if (path == "--version") {
    std::cout << "certify-exact " EPSNET_VERSION "\n";
    return ended(0);
  }
  std::ifstream file(path, std::ios::binary);
  std::istream& in = path == "-" ? std::cin : file;
  std::string text;
  for (std::string chunk(std::size_t{1} << 20, '\0'); in && text.size() <= kMaxBytes;) {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad() || text.size() > kMaxBytes || (path != "-" && !file.is_open())) {
    std::cerr << "certify-exact: cannot read \"" << path << "\", or it is larger than 4 GiB\n";
    return kExitUsage;
  }
  const epsnet::exact::Result result = epsnet::exact::check(text);
  if (result.verdict == epsnet::exact::Verdict::malformed) {
    const std::string why = epsnet::exact::why_no_claim(text);
    if (!why.empty()) {
      std::cout << "NO CLAIM: " << on_one_line(why) << '\n';
      return ended(kExitNoClaim);
    }
  }
  constexpr const char* kNames[] = {"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  const auto code = static_cast<int>(result.verdict);
  std::cout << kNames[code] << (result.rule.empty() ? "" : ": ") << result.rule;
  if (!result.message.empty()) std::cout << ": " << on_one_line(result.message);
  std::cout << '\n';
  return ended(code);
} catch (const std::exception& error) {
  std::cerr << "certify-exact: internal fault: " << error.what() << '\n';
  return kExitInternal;
}
