#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "epsnet/certify/check.h"
#include "epsnet/certify/writer.h"
#include "epsnet/netgen/certified_net.h"
#include "epsnet/netgen/draw.h"
#include "epsnet/netgen/info.h"
#include "epsnet/netgen/net_record.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"
#include "epsnet/netgen/surface_file.h"

namespace epsnet::program {
namespace {

class Stopwatch {
 public:
  /// Seconds since the construction or the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct NetRequest {
  std::string surface;
  std::string epsilon;
  std::string output;
  std::string svg;
  std::string record;
  std::string base;
  bool no_certify = false;
  bool stats = false;
  NetOptions options;
};

/// Processor time of all threads so far.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct PhaseTimes {
  double reading = 0;
  double computing = 0;
  double certifying = 0;
  double drawing = 0;
  double writing = 0;
};

/// "2.41", or "-" where there is nothing to divide by.
std::string ratio_text(double part, double whole) {
  if (whole == 0) return "-";
  std::ostringstream out;
  out.precision(4);
  out << part / whole;
  return out.str();
}

std::string ratio_text(std::uint64_t part, std::uint64_t whole) {
  return ratio_text(static_cast<double>(part), static_cast<double>(whole));
}

/// What the certificate proved, in three lines.
std::string certificate_text(const certify::Certificate& certificate) {
  std::ostringstream out;
  out << "verdict: " << certify::name(certificate.verdict) << '\n'
      << "vertices: " << certificate.counts.vertices << '\n';
  if (certificate.counts.collars) out << "pseudo net, collars: " << *certificate.counts.collars << '\n';
  if (certificate.enclosures) {
    out << "largest circumradius: " << interval_text(certificate.enclosures->largest_circumradius) << '\n';
    out << "shortest edge between different vertices: "
        << (certificate.enclosures->shortest_edge ? interval_text(*certificate.enclosures->shortest_edge) : "none")
        << '\n';
  }
  return out.str();
}

/// Walks and flips in the terms of the thesis (IV.6.2, figures IV.11 and IV.12).
std::string walk_text(const NetStatistics& s, Insertion insertion) {
  std::ostringstream out;
  out << "insertions: " << s.insertions << '\n';
  out << "flips per insertion: " << ratio_text(s.flips, s.insertions)
      << (insertion == Insertion::cavity ? " (a cavity of k triangles counts as k - 1 flips)" : "") << '\n';
  if (insertion == Insertion::cavity) {
    out << "triangles visited per location, circumcentres in their own triangle: not measured, a cavity needs no "
           "location; use --insert flips\n";
    return out.str();
  }
  const std::uint64_t elsewhere = s.located - s.located_at_start;
  out << "triangles visited per location: " << ratio_text(s.walk_steps, s.located) << ", where the start is left "
      << ratio_text(s.walk_steps, elsewhere) << ", longest walk " << s.longest_walk << '\n';
  out << "share of circumcentres in their own triangle: " << ratio_text(s.located_at_start, s.located) << '\n';
  return out.str();
}

std::string statistics_text(const UncertifiedNet& net, std::uint32_t genus, double epsilon, const NetRequest& request,
                            const PhaseTimes& times) {
  const NetStatistics& s = net.statistics;
  const auto count = static_cast<double>(net.net.vertices.size());
  const double least = least_vertices(genus, epsilon);
  const double most = most_vertices(genus, epsilon);
  std::ostringstream out;
  out << walk_text(s, request.options.insertion);
  out << "flips of the initial triangulation: " << s.initial_flips << '\n';
  out << "vertices removed from it: " << s.removed << '\n';
  out << "lower bound (g-1)/sinh^2(epsilon/2), Theorem III.2: " << least << ", ratio " << ratio_text(count, least)
      << '\n';
  out << "upper bound 16(g-1)/epsilon^2, Theorem III.1 if the systole is at least epsilon: " << most << ", ratio "
      << ratio_text(count, most) << '\n';
  if (request.options.pseudo) out << "insertions undone for a collar: " << s.undone << '\n';
  out << "charts: " << s.charts << '\n' << "labels: " << s.labels << '\n';
  out << "multiprecision predicates: " << s.multiprecision << '\n';
  out << "seconds: reading " << times.reading << ", initial triangulation " << s.start_seconds << ", refinement "
      << s.refine_seconds << ", document " << std::max(0.0, times.computing - s.start_seconds - s.refine_seconds);
  if (!request.no_certify) out << ", certification " << times.certifying;
  if (!request.svg.empty()) out << ", drawing " << times.drawing;
  out << ", writing " << times.writing << '\n';
  return out.str();
}

UncertifiedNet compute(const Surface& surface, const Epsilon& epsilon, NetOptions options) {
  ProgressLine progress;
  options.progress = [&](std::uint64_t vertices, double share) {
    progress.show("net: " + std::to_string(vertices) + " vertices", share);
  };
  return compute_net(surface, epsilon, options);
}

/// The certificate of a verified net. Throws JobError for any other.
certify::Certificate certify_net(const certify::Document& net, certify::CheckOptions options) {
  ProgressLine progress;
  options.progress = [&](std::string_view rule, double share) {
    progress.show("certificate: " + std::string(rule), share);
  };
  certify::Certificate certificate = certify::check(net, options);
  if (certificate.verdict != certify::Verdict::verified) {
    throw JobError("no certified net: " + std::string(certify::name(certificate.verdict)) + ": " + certificate.rule +
                   ": " + certificate.message + "; nothing was written");
  }
  return certificate;
}

void check_request(const NetRequest& request) {
  if (is_stdout(request.output) && is_stdout(request.svg))
    throw UsageError("--output and --svg cannot both be standard output");
  if (is_stdout(request.record)) throw UsageError("--record cannot be standard output");
  if (request.no_certify && !request.record.empty()) throw UsageError("--record is for certified nets");
  for (const std::string& file : {request.output, request.svg, request.record})
    if (!file.empty()) check_output_directory(file);
}

void write_record(const NetRequest& request, const UncertifiedNet& net, const certify::Certificate& certificate,
                  const NetSeconds& seconds) {
  const std::string name = std::filesystem::path(request.surface).stem().string();
  const std::string line = net_record(name, net, certificate, request.options, seconds);
  write_output(request.record, [&](std::ostream& out) { out << net_record_columns() << '\n' << line << '\n'; });
}

void make_net(const NetRequest& request) {
  const Epsilon epsilon = parse_epsilon(request.epsilon);
  if (request.options.pseudo && !epsilon.allows_pseudo_nets())
    throw UsageError("--epsilon: " + epsilon.text() + " is more than ln sqrt(2) = 0.34657..., the limit for --pseudo");
  check_request(request);

  PhaseTimes times;
  Stopwatch watch;
  const Surface surface = load_surface(request.surface);
  times.reading = watch.lap();
  NetOptions options = request.options;
  if (!request.base.empty()) options.base = parse_base(request.base, surface);
  const double start = processor_seconds();
  const UncertifiedNet net = compute(surface, epsilon, options);
  const double computed = processor_seconds();
  times.computing = watch.lap();
  certify::Certificate certificate;
  if (!request.no_certify) certificate = certify_net(net.net, request.options.check);
  std::string report = request.no_certify
                           ? "verdict: not certified (--no-certify): nothing is proved about this net\nvertices: " +
                                 std::to_string(net.net.vertices.size()) + "\n"
                           : certificate_text(certificate);
  const NetSeconds seconds{computed - start, processor_seconds() - computed};
  times.certifying = watch.lap();
  std::string svg;
  if (!request.svg.empty()) svg = draw_svg(net.net);
  times.drawing = watch.lap();
  write_output(request.output, [&](std::ostream& out) { certify::write_net(net.net, out); });
  if (!request.svg.empty()) write_output(request.svg, [&](std::ostream& out) { out << svg; });
  if (!request.record.empty()) write_record(request, net, certificate, seconds);
  times.writing = watch.lap();
  if (request.stats)
    report += statistics_text(net, surface.genus(), static_cast<double>(epsilon.value()), request, times);
  write_report(report, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

void add_net_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<NetRequest>();
  NetRequest& request = *shared;
  CLI::App* net = app.add_subcommand("net", "Compute an epsilon-net of a surface, prove it, write it.");
  net->add_option("SURFACE", request.surface, "a surface file")->required()->option_text("REQUIRED");
  net->add_option("--epsilon", request.epsilon, "a positive decimal or fraction: 0.1 is exactly 1/10")
      ->required()
      ->option_text("E REQUIRED");
  add_output(*net, request.output, "the net file to write, only if the net is verified");
  net->add_option("--svg", request.svg, "also draw the net; \"-\" is standard output")->option_text("FILE");
  net->add_option("--record", request.record, "also write what the thesis measures as a table of one line (CSV)")
      ->option_text("FILE");
  net->add_option(
         "--base", request.base,
         "start from this point alone: of tile T, strictly inside of it, exact; T alone is the centre of the tile")
      ->option_text("T[,X,Y]");
  net->add_flag("--pseudo", request.options.pseudo,
                "a pseudo net: the collars of closed geodesics no longer than epsilon are left empty; "
                "epsilon at most ln sqrt(2)");
  net->add_flag("--no-certify", request.no_certify, "write the net without checking it: nothing is proved");
  CLI::Option* insert =
      net->add_option("--insert", request.options.insertion,
                      "how points are inserted: cavity is fast; flips is the way of the thesis, with its statistics")
          ->transform(one_of<Insertion>({{"cavity", Insertion::cavity}, {"flips", Insertion::flips}}))
          ->option_text("cavity|flips [cavity]");
  CLI::Option* locate = net->add_option("--locate", request.options.walk,
                                        "the walk with which --insert flips, implied by this, finds triangles")
                            ->transform(one_of<Walk>({{"visibility", Walk::visibility}, {"straight", Walk::straight}}))
                            ->option_text("visibility|straight [visibility]");
  net->add_option("--list", request.options.list,
                  "the triangles listed to be looked at, variants A to D of the thesis' Table IV.2: A all, the oldest "
                  "first; B all, the newest first; C large ones, the oldest first; D large ones, the largest first")
      ->transform(one_of<TriangleList>({{"A", TriangleList::all_back},
                                        {"B", TriangleList::all_front},
                                        {"C", TriangleList::large_back},
                                        {"D", TriangleList::largest_first}}))
      ->option_text("A|B|C|D [C]");
  net->add_flag("--stats", request.stats, "also print what the thesis measures, and times");
  add_threads(*net, request.options.check.threads);
  net->footer(
      "Example:\n"
      "  epsnet net s.json --epsilon 0.1 -o net.json --svg net.svg && certify net.json\n\n"
      "The report goes to standard output, or to standard error if a file goes there.");
  net->callback([&chosen, shared, insert, locate] {
    if (locate->count() > 0) {
      if (insert->count() > 0 && shared->options.insertion == Insertion::cavity)
        throw CLI::ValidationError("--locate", "a cavity needs no walk; use --insert flips");
      shared->options.insertion = Insertion::flips;
    }
    chosen = [shared] { make_net(*shared); };
  });
}

}  // namespace epsnet::program
