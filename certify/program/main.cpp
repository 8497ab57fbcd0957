#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <flint/flint.h>
#include <iostream>
#include <limits>
#include <nettle/sha2.h>
#include <numeric>
#include <sstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

#include "certify/check.h"
#include "certify/document/text.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"
#include "certify/geodesics/geodesics_check.h"
#include "certify/numbers/ball.h"

/// The program `certify`: reads net files and geodesics files, prints for each what each rule proved and, last, one
/// verdict line.
namespace {

using namespace epsnet::certify;

// Nothing but these is ever returned. 0 if and only if the last line of stdout says VERIFIED, for all files.
constexpr int kExitVerified = 0;
constexpr int kExitRefuted = 1;
constexpr int kExitUndecided = 2;
constexpr int kExitMalformed = 3;
constexpr int kExitUsage = 64;
constexpr int kExitInternal = 70;

int exit_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::verified:
      return kExitVerified;
    case Verdict::refuted:
      return kExitRefuted;
    case Verdict::undecided:
      return kExitUndecided;
    case Verdict::malformed:
      break;
  }
  return kExitMalformed;
}

/// The end for everything that cannot be caught: GMP and FLINT out of memory, std::terminate, a crash.
/// Async-signal-safe.
[[noreturn]] void end_on_signal(int) {
  constexpr std::string_view kText = "certify: internal fault\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kText.data(), kText.size());
  _exit(kExitInternal);
}

/// Every death by signal that can be turned into exit code 70 is. The handler has a stack of its own: the first one may
/// be what has run out.
void catch_signals() {
  alignas(16) static std::array<char, 1 << 16> handler_stack;
  stack_t stack{};
  stack.ss_sp = handler_stack.data();
  stack.ss_size = handler_stack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = end_on_signal;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGILL}) sigaction(signal, &action, nullptr);
  // A reader that went away and a file as large as it may be show as failed writes.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

// FLINT's own spelling: for clang, a function type with this attribute differs from one with [[noreturn]].
FLINT_NORETURN void end_on_flint_abort() { end_on_signal(0); }

/// A list of names and values, for both kinds of output.
template <class Visit>
void visit_counts(const Counts& c, const Visit& visit) {
  visit("vertices", c.vertices);
  visit("edges", c.edges);
  visit("triangles", c.triangles);
  visit("genus", c.genus);
  visit("tiles", c.tiles);
  visit("charts", c.charts);
  visit("labels", c.labels);
  visit("label_identities", c.label_identities);
  visit("exact_ties", c.exact_ties);
  visit("triangles_beyond_64_bits", c.triangles_beyond_64_bits);
  visit("max_precision_used", c.max_precision_used);
  visit("work", c.work);
  if (c.collars) visit("collars", *c.collars);
}

template <class Visit>
void visit_enclosures(const Enclosures& e, const Visit& visit) {
  visit("epsilon", e.epsilon);
  visit("area", e.area);
  visit("largest_circumradius", e.largest_circumradius);
  visit("longest_edge", e.longest_edge);
  if (e.shortest_edge) visit("shortest_edge", *e.shortest_edge);
  if (e.shortest_loop) visit("shortest_loop", *e.shortest_loop);
  if (e.shortest_core) visit("shortest_core", *e.shortest_core);
}

template <class Visit>
void visit_geodesics_counts(const GeodesicsCounts& c, const Visit& visit) {
  visit("geodesics", c.geodesics);
  visit("lifted_triangles", c.lifted_triangles);
  visit("candidates", c.candidates);
  visit("deep_vertices", c.deep_vertices);
  visit("geodesics_max_precision_used", c.max_precision_used);
}

/// What is said of one file.
struct FileReport {
  std::string name = {};         ///< As in messages.
  std::string path = {};         ///< As given.
  std::string sha256 = {};       ///< Of the bytes that were read; empty if none could be.
  std::string error = {};        ///< Why it could not be read; the certificate says nothing then.
  Certificate certificate = {};  ///< Its message begins without the file's name.
};

int exit_code(const FileReport& report) {
  return report.error.empty() ? exit_code(report.certificate.verdict) : kExitUsage;
}

/// The verdict, and why it is none other. `place` names the file, or is empty.
std::string verdict_line(const FileReport& report, const std::string& place) {
  if (report.error.empty()) return verdict_line(report.certificate, place);
  return "ERROR: " + (place.empty() ? "" : place + ": ") + report.error;
}

/// All lines but the verdict. Of a malformed file nothing is counted and nothing claimed.
std::string as_text(const FileReport& report) {
  const Certificate& certificate = report.certificate;
  std::ostringstream out;
  for (const RuleReport& rule : certificate.rules) {
    out << to_string(rule) << '\n';
  }
  const bool read = report.error.empty() && certificate.verdict != Verdict::malformed;
  if (read) {
    const auto line = [&](const char* key, std::uint64_t value) { out << key << ": " << value << '\n'; };
    visit_counts(certificate.counts, line);
    if (certificate.enclosures) {
      visit_enclosures(*certificate.enclosures,
                       [&](const char* key, Interval value) { out << key << ": " << to_string(value) << '\n'; });
    }
    if (certificate.geodesics) visit_geodesics_counts(*certificate.geodesics, line);
  }
  if (!report.sha256.empty()) out << "sha256: " << report.sha256 << '\n';
  if (read) out << "claim: " << certificate.claim << '\n';
  return out.str();
}

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// JSON has no infinity: an unbounded end is null.
std::string json_number(double x) { return std::isfinite(x) ? shortest(x) : "null"; }

/// One object on one line.
std::string as_json(const FileReport& report) {
  const Certificate& certificate = report.certificate;
  const std::string file = ", \"file\": " + json_string(report.path);
  if (!report.error.empty()) return "{\"verdict\": null" + file + ", \"error\": " + json_string(report.error) + "}\n";
  std::ostringstream out;
  out << "{\"verdict\": " << json_string(name(certificate.verdict)) << file;
  if (!report.sha256.empty()) out << ", \"sha256\": " << json_string(report.sha256);
  out << ", \"rule\": " << json_string(certificate.rule) << ", \"message\": " << json_string(certificate.message);
  if (certificate.verdict == Verdict::malformed) return out.str() + "}\n";
  out << ", \"claim\": " << json_string(certificate.claim) << ", \"rules\": [";
  const char* separator = "";
  for (const RuleReport& rule : certificate.rules) {
    out << separator << "{\"rule\": " << json_string(rule.rule) << ", \"verdict\": " << json_string(name(rule.verdict))
        << ", \"text\": " << json_string(rule.text) << '}';
    separator = ", ";
  }
  out << "], \"counts\": {";
  const auto member = [&](const char* key, std::uint64_t value) {
    out << separator << json_string(key) << ": " << value;
    separator = ", ";
  };
  separator = "";
  visit_counts(certificate.counts, member);
  out << '}';
  if (certificate.geodesics) {
    out << ", \"geodesics\": {";
    separator = "";
    visit_geodesics_counts(*certificate.geodesics, member);
    out << '}';
  }
  if (certificate.enclosures) {
    out << ", \"enclosures\": {";
    separator = "";
    visit_enclosures(*certificate.enclosures, [&](const char* key, Interval value) {
      out << separator << json_string(key) << ": [" << json_number(value.lower) << ", " << json_number(value.upper)
          << ']';
      separator = ", ";
    });
    out << '}';
  }
  out << "}\n";
  return out.str();
}

/// Shows how far we are on a terminal, after the first second; wipes its line at the end.
class Progress {
 public:
  void show(std::string_view rule, double share) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now - shown_ < std::chrono::milliseconds(shown_once_ ? 200 : 1000)) return;
    shown_ = now;
    shown_once_ = true;
    std::fprintf(stderr, "\r%-12.*s %3.0f %%", static_cast<int>(rule.size()), rule.data(), 100 * share);
  }
  ~Progress() {
    if (shown_once_) std::fputs("\r                    \r", stderr);
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

struct Request {
  std::vector<std::string> files;
  CheckOptions options;
  bool json = false;
  bool print_parsed = false;
};

std::string sha256(std::string_view bytes) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string text;
  for (const std::uint8_t byte : digest) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += {kDigits[byte / 16U], kDigits[byte % 16U]};
  }
  return text;
}

FileReport check_file(const Request& request, const std::string& path) {
  FileReport report{.name = display_name(path), .path = path};
  const auto without_name = [&](const std::exception& error) {
    const std::string_view text = error.what();
    const std::string prefix = report.name + ": ";
    return std::string(text.starts_with(prefix) ? text.substr(prefix.size()) : text);
  };
  std::variant<NetDocument, GeodesicsDocument> document;
  try {
    std::string bytes = load(path);
    report.sha256 = sha256(bytes);
    document = parse_claim(std::move(bytes), report.name);
  } catch (const FileError& error) {
    report.error = without_name(error);
    return report;
  } catch (const MalformedError& error) {
    report.certificate.verdict = Verdict::malformed;
    report.certificate.rule = "structure";
    report.certificate.message = without_name(error);
    return report;
  }
  const auto* geodesics = std::get_if<GeodesicsDocument>(&document);
  if (request.print_parsed && geodesics != nullptr) write_geodesics(*geodesics, std::cout);
  if (request.print_parsed && geodesics == nullptr) write_net(std::get<NetDocument>(document), std::cout);
  Progress progress;
  CheckOptions options = request.options;
  options.progress = [&](std::string_view rule, double share) { progress.show(rule, share); };
  report.certificate =
      geodesics != nullptr ? check_geodesics(*geodesics, options) : check(std::get<NetDocument>(document), options);
  return report;
}

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
    const bool malformed = report.error.empty() && report.certificate.verdict == Verdict::malformed;
    if (own_code == kExitVerified) ++verified;
    if (code == kExitVerified && own_code != kExitVerified) {
      code = own_code;
      last_line = verdict_line(report, several || malformed ? report.name : "");
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

/// Accepts digits only, where CLI11 also takes signs: -1 as an unsigned number is 2⁶⁴ − 1.
CLI::Validator integer_between(std::uint64_t least, std::uint64_t most) {
  return {[=](const std::string& text) -> std::string {
            std::uint64_t value = 0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && stop == end && least <= value && value <= most) return "";
            return in_quotes(text) + " is not an integer from " + std::to_string(least) + " to " + std::to_string(most);
          },
          ""};
}

/// The number of letters to insert, remove or replace to make the one text the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string unknown_option(const CLI::App& app) {
  std::string unknown = printable(app.remaining().at(0));
  unknown.erase(std::min(unknown.find('='), unknown.size()));
  std::string nearest;
  std::size_t distance = 3;  // More is no slip of the finger.
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& long_name : option->get_lnames()) {
      const std::size_t own = edit_distance(unknown, "--" + long_name);
      if (own < distance) nearest = "--" + long_name;
      distance = std::min(distance, own);
    }
  }
  return unknown + ": no such option" + (nearest.empty() ? "" : ", did you mean " + nearest + "?");
}

int run(int argc, char** argv) {
  Request request;
  CLI::App app(
      "Decides whether a net file proves that its vertices are an epsilon-net of its surface, or of the thick part of "
      "it\n"
      "(a pseudo net), and its triangles a Delaunay triangulation, or a geodesics file that its closed geodesics are "
      "the\n"
      "systole, the spectrum up to a length or the thick-thin decomposition: every number is enclosed in balls, every\n"
      "claim is derived again.",
      "certify");
  app.add_option("FILE", request.files, "net files and geodesics files (docs/format.md); \"-\" is standard input")
      ->required()
      ->option_text("... REQUIRED");
  app.add_flag("--json", request.json, "one JSON object on one line for each file, nothing else");
  app.add_option("--threads", request.options.threads, "number of threads, at most 1024; 0 is one per core")
      ->check(integer_between(0, 1024))
      ->option_text("N [0]");
  app.add_option("--max-precision", request.options.max_precision,
                 "bits after which a comparison is undecided, 64 to 1048576")
      ->check(integer_between(kLeastPrecision, kGreatestPrecision))
      ->option_text("N [8192]");
  app.add_option("--max-visits", request.options.max_visits,
                 "lifted triangles visited before a list of geodesics is undecided, at least 1")
      ->check(integer_between(1, std::numeric_limits<std::uint64_t>::max()))
      ->option_text("N [100000000]");
  app.add_option("--max-work", request.options.max_work,
                 "units of work before the rest is undecided; 0 is as many as a file of this size may take")
      ->check(integer_between(0, std::numeric_limits<std::uint64_t>::max()))
      ->option_text("N [0]");
  app.add_flag("--print-parsed", request.print_parsed, "first print the document as it was understood")
      ->excludes("--json");
  app.set_version_flag("--version", "certify " EPSNET_VERSION);
  app.footer(
      "Examples:\n"
      "  certify net.json && echo 'this is an epsilon-net'\n"
      "  certify results/*.json\n\n"
      "The last line of output is VERIFIED, REFUTED: rule: why, UNDECIDED: rule: why, or MALFORMED: why.\n"
      "Of several files it is VERIFIED if all of them are; else it names the first that is not, and the exit code is\n"
      "that file's. The line sha256 identifies the bytes that were checked.\n"
      "Exit codes: 0 verified, 1 refuted, 2 undecided, 3 malformed file, 64 usage, a file that cannot be read, --help\n"
      "or --version, 70 internal fault.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    // --help succeeds as a command, but nothing is verified: it must not look like success to a script.
    app.exit(help_or_version);
    std::cout.flush();
    return kExitUsage;
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
  return check_files(request);
}

}  // namespace

int main(int argc, char** argv) {
  catch_signals();
  flint_set_abort(end_on_flint_abort);
  std::ios::sync_with_stdio(false);
  try {
    const int code = run(argc, argv);
    flint_cleanup();
    return code;
  } catch (const std::exception& error) {
    std::cerr << "certify: internal fault: " << error.what() << '\n';
  } catch (...) {
    std::cerr << "certify: internal fault\n";
  }
  return kExitInternal;
}
