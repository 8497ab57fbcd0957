#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/check.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/surfaces/surfaces.h"

/// The program `variant`: makes nets of a surface in one of the ways that the thesis compares, proves each by the rules
/// of `certify`, and prints what the thesis measures, a line (CSV) for each ε.
namespace epsnet::experiments {
namespace {

constexpr int kExitFailed = 1;
constexpr int kExitUsage = 64;

struct Request {
  std::string surface;
  std::vector<std::string> epsilons;
  Variant variant;
};

/// Returns the processor time of the calling thread.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string text(std::uint64_t n) { return std::to_string(n); }

/// Seconds with the digits of microseconds; clocks are no more accurate.
std::string seconds_text(double seconds) {
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, seconds, std::chars_format::fixed, 6).ptr};
}

/// Processor time, in seconds.
struct NetSeconds {
  double net = 0;  ///< From the surface to the net, everything included.
  double certificate = 0;
};

using Columns = std::vector<std::pair<const char*, std::string>>;

/// How a net was made, its counts, the verdict, the thesis' statistics (IV.6), the proved enclosures and the bound for
/// the systole that follows from the net. A value that does not exist is empty, such as the shortest loop of a net
/// without loops. Reals have enough digits to read back as the same number. Only the seconds differ between runs.
Columns columns(const VariantNet& net, const certify::Certificate& certificate, const Variant& variant,
                const NetSeconds& seconds) {
  const RefinementStatistics& s = net.statistics;
  const certify::Enclosures enclosures = certificate.enclosures.value_or(certify::Enclosures{});
  const auto& edge = enclosures.shortest_edge;
  const auto& loop = enclosures.shortest_loop;
  const double loop_or_infinity = loop ? loop->lower : std::numeric_limits<double>::infinity();
  // As a function of epsilon the bound increases and then decreases: on an interval it is least at an end.
  const double systole = std::min(systole_lower_bound(enclosures.epsilon.lower, loop_or_infinity),
                                  systole_lower_bound(enclosures.epsilon.upper, loop_or_infinity));
  const bool by_flips = variant.insertion == Insertion::flips;
  return {{"epsilon", net.document.epsilon},
          {"insertion", std::string(name_in(kInsertionNames, variant.insertion))},
          {"walk", std::string(by_flips ? name_in(kWalkNames, variant.walk) : "")},
          {"list", std::string(name_in(kTriangleListNames, variant.list.value_or(TriangleList::large_back)))},
          {"verdict", std::string(certify::name(certificate.verdict))},
          {"genus", text(certificate.counts.genus)},
          {"vertices", text(certificate.counts.vertices)},
          {"insertions", text(s.insertions)},
          {"flips", text(s.flips)},
          {"initial_flips", text(s.initial_flips)},
          {"removed", text(s.removed)},
          {"located", text(s.located)},
          {"located_at_start", text(s.located_at_start)},
          {"walk_steps", text(s.walk_steps)},
          {"longest_walk", text(s.longest_walk)},
          {"multiprecision", text(s.multiprecision)},
          {"largest_circumradius_upper", certify::decimal_above(enclosures.largest_circumradius.upper)},
          {"shortest_edge_lower", edge ? certify::decimal_below(edge->lower) : ""},
          {"shortest_loop_lower", loop ? certify::decimal_below(loop->lower) : ""},
          {"shortest_loop_upper", loop ? certify::decimal_above(loop->upper) : ""},
          {"systole_lower", certify::decimal_below(systole)},
          {"net_seconds", seconds_text(seconds.net)},
          {"certificate_seconds", seconds_text(seconds.certificate)}};
}

/// Makes and proves a net. Throws NetError.
Columns certified_record(const Surface& surface, const Length& epsilon, const Variant& variant) {
  constexpr unsigned kThreads = 1;
  const double start = processor_seconds();
  const VariantNet net = compute_variant(surface, epsilon, variant, {.threads = kThreads});
  const double computed = processor_seconds();
  const certify::Certificate certificate = certify::check(net.document, {.threads = kThreads});
  if (certificate.verdict != certify::Verdict::verified)
    throw NetError("epsilon " + epsilon.text() + ": the net was not verified: " + certificate.rule + ": " +
                   certificate.message);
  return columns(net, certificate, variant, {computed - start, processor_seconds() - computed});
}

/// Prints one member of each column, separated by commas.
template <class Member>
void print_line(const Columns& record, Member member) {
  const char* separator = "";
  for (const auto& column : record) {
    std::cout << separator << column.*member;
    separator = ",";
  }
  std::cout << '\n';
}

void make(const Request& request) {
  const Surface surface = load_surface(request.surface);
  print_line(columns({}, {}, {}, {}), &Columns::value_type::first);
  for (const std::string& epsilon : request.epsilons) {
    print_line(certified_record(surface, Length(epsilon), request.variant), &Columns::value_type::second);
  }
  if (!std::cout.flush()) throw std::runtime_error("cannot write to standard output");
}

template <class Value, std::size_t N>
CLI::CheckedTransformer one_of(const VariantNames<Value, N>& names) {
  return CLI::CheckedTransformer(std::map<std::string, Value>(names.begin(), names.end()));
}

int run(int argc, char** argv) {
  Request request;
  CLI::App app("Nets of a surface in a way of the thesis, each proved: what the thesis measures, as CSV.", "variant");
  app.add_option("SURFACE", request.surface, "a surface file")->required();
  app.add_option("--epsilons", request.epsilons, "separated by commas")->delimiter(',')->required();
  app.add_option("--insert", request.variant.insertion,
                 "how points are inserted: cavity is fast, flips is the way of the thesis")
      ->transform(one_of(kInsertionNames))
      ->option_text("cavity|flips [cavity]");
  app.add_option("--locate", request.variant.walk, "the walk by which flips find triangles")
      ->transform(one_of(kWalkNames))
      ->option_text("visibility|straight [visibility]");
  app.add_option("--list", request.variant.list,
                 "which triangles the refinement lists, variants of the thesis' Table IV.2: A all, the oldest first; B "
                 "all, the newest first; C large ones, the oldest first; D large ones, the largest first")
      ->transform(one_of(kTriangleListNames))
      ->option_text("A|B|C|D [C]");
  try {
    app.parse(argc, argv);
    for (const std::string& epsilon : request.epsilons) (void)Length(epsilon);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const std::exception& error) {
    std::cerr << "variant: " << error.what() << " (try --help)\n";
    return kExitUsage;
  }
  make(request);
  return 0;
}

}  // namespace
}  // namespace epsnet::experiments

int main(int argc, char** argv) {
  try {
    return epsnet::experiments::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "variant: " << error.what() << '\n';
    return epsnet::experiments::kExitFailed;
  }
}
