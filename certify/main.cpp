#include <epsnet/certify/check.h>
#include <epsnet/certify/geodesics_check.h>
#include <epsnet/certify/reader.h>
#include <epsnet/certify/text.h>
#include <epsnet/certify/writer.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <variant>

/// The program `certify`: reads a net file or a geodesics file, prints what each rule proved and, last, one verdict
/// line.
namespace {

using namespace epsnet::certify;

// Nothing but these is ever returned. 0 if and only if the last line of stdout says VERIFIED.
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

// FLINT's own spelling: for clang, a function type with this attribute differs from one with [[noreturn]].
FLINT_NORETURN void end_on_flint_abort() { end_on_signal(0); }

std::string interval_text(Interval x) {
  return std::string("[").append(shortest(x.lower)).append(", ").append(shortest(x.upper)).append("]");
}

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

std::string verdict_line(const Certificate& certificate) {
  std::string line(name(certificate.verdict));
  if (certificate.verdict == Verdict::verified) return line;
  line += ": ";
  if (certificate.verdict != Verdict::malformed) line += certificate.rule + ": ";
  return line + certificate.message;
}

std::string as_text(const Certificate& certificate) {
  std::ostringstream out;
  for (const RuleReport& report : certificate.rules) {
    out << report.rule << ": " << name(report.verdict) << ": " << report.text << '\n';
  }
  const auto line = [&](const char* key, std::uint64_t value) { out << key << ": " << value << '\n'; };
  visit_counts(certificate.counts, line);
  if (certificate.enclosures) {
    visit_enclosures(*certificate.enclosures,
                     [&](const char* key, Interval value) { out << key << ": " << interval_text(value) << '\n'; });
  }
  if (certificate.geodesics) visit_geodesics_counts(*certificate.geodesics, line);
  if (!certificate.claim.empty()) out << "claim: " << certificate.claim << '\n';
  out << verdict_line(certificate) << '\n';
  return out.str();
}

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    // Our messages are printable ASCII; a file name may not be.
    result += (c >= ' ' && c <= '~') ? c : '?';
  }
  return result + '"';
}

/// JSON has no infinity: an unbounded end is null.
std::string json_number(double x) { return std::isfinite(x) ? shortest(x) : "null"; }

std::string as_json(const Certificate& certificate) {
  std::ostringstream out;
  out << "{\"verdict\": " << json_string(name(certificate.verdict)) << ", \"claim\": " << json_string(certificate.claim)
      << ", \"rule\": " << json_string(certificate.rule) << ", \"message\": " << json_string(certificate.message)
      << ", \"rules\": [";
  const char* separator = "";
  for (const RuleReport& report : certificate.rules) {
    out << separator << "{\"rule\": " << json_string(report.rule)
        << ", \"verdict\": " << json_string(name(report.verdict)) << ", \"text\": " << json_string(report.text) << '}';
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
  std::string file;
  CheckOptions options;
  bool json = false;
  bool print_parsed = false;
};

Certificate read_and_check(Request& request) {
  std::variant<Document, GeodesicsDocument> claim;
  try {
    claim = read_claim(request.file);
  } catch (const MalformedError& error) {
    Certificate malformed;
    malformed.verdict = Verdict::malformed;
    malformed.rule = "structure";
    malformed.message = error.what();
    return malformed;
  }
  const auto* geodesics = std::get_if<GeodesicsDocument>(&claim);
  if (request.print_parsed && geodesics != nullptr) write_geodesics(*geodesics, std::cout);
  if (request.print_parsed && geodesics == nullptr) write_net(std::get<Document>(claim), std::cout);
  Progress progress;
  request.options.progress = [&](std::string_view rule, double share) { progress.show(rule, share); };
  return geodesics != nullptr ? check_geodesics(*geodesics, request.options)
                              : check(std::get<Document>(claim), request.options);
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
  app.add_option("FILE", request.file, "a net file or a geodesics file (docs/format.md)")->required();
  app.add_flag("--json", request.json, "one JSON object instead of lines of text");
  app.add_option("--threads", request.options.threads, "number of threads, 0 for one per core")
      ->check(CLI::Range(0U, 1024U))
      ->capture_default_str();
  app.add_option("--max-precision", request.options.max_precision, "bits after which a comparison is undecided")
      ->check(CLI::Range(64L, 1L << 20))
      ->capture_default_str();
  app.add_option("--max-visits", request.options.max_visits,
                 "lifted triangles visited before a list of geodesics is undecided")
      ->capture_default_str();
  app.add_flag("--print-parsed", request.print_parsed, "first print the document as it was understood");
  app.footer(
      "Example:\n"
      "  certify net.json && echo 'this is an epsilon-net'\n\n"
      "The last line of output is VERIFIED, REFUTED: rule: why, UNDECIDED: rule: why, or MALFORMED: why.\n"
      "Exit codes: 0 verified, 1 refuted, 2 undecided, 3 malformed file, 64 usage, 70 internal fault.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    // --help succeeds as a command, but nothing is verified: it must not look like success to a script.
    app.exit(help);
    std::cout.flush();
    return kExitUsage;
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return kExitUsage;
  }

  Certificate certificate;
  try {
    certificate = read_and_check(request);
  } catch (const FileError& error) {
    std::cerr << "certify: " << error.what() << '\n';
    return kExitUsage;
  }
  std::cout << (request.json ? as_json(certificate) : as_text(certificate));
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) {
    std::cerr << "certify: cannot write to standard output\n";
    return kExitInternal;
  }
  return exit_code(certificate.verdict);
}

}  // namespace

int main(int argc, char** argv) {
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGILL}) std::signal(signal, end_on_signal);
  // A reader that went away shows as a failed write, exit code 70, not as death by signal.
  std::signal(SIGPIPE, SIG_IGN);
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
