#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "certify/check.h"
#include "certify/claims.h"
#include "certify/file/file.h"
#include "netgen/base/progress_line.h"
#include "netgen/lifts/info.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "netgen/prove/certified.h"

namespace epsnet::program {
namespace {

class Stopwatch {
 public:
  /// Returns the seconds since the construction or the last call.
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
  std::string base;
  std::string points;
  bool no_certify = false;
  bool stats = false;
  bool json = false;
  NetOptions options;
};

/// Reads a point of a file.
BasePoint parse_given_point(const LineText& point, const Surface& surface) {
  try {
    return parse_base(point.text, surface, point.name);
  } catch (const UsageError& error) {
    throw JobError(error.what());
  }
}

/// Returns the message about two points that are too close, without the value of ε at its end.
std::string close_points_message(const ClosePointsError& error, const NetOptions& options,
                                 const std::vector<LineText>& points) {
  const auto name = [&](std::uint32_t vertex) {
    if (options.base && vertex == 0) return std::string("--base");
    const LineText& point = points[vertex - (options.base ? 1 : 0)];
    return point.name + " (" + point.text.substr(0, 80) + ")";
  };
  return name(error.first()) + " and " + name(error.second()) + " are not farther from each other than epsilon = ";
}

struct PhaseTimes {
  double reading = 0;
  double computing = 0;
  double certifying = 0;
  double drawing = 0;
  double writing = 0;
};

/// Returns the quotient of two positive numbers, such as "2.41".
std::string ratio_text(double part, double whole) {
  std::ostringstream out;
  out.precision(4);
  out << part / whole;
  return out.str();
}

Report uncertified_report(const certify::NetDocument& net) {
  return {"verdict: not certified (--no-certify): nothing is proved about this net\nvertices: " +
              std::to_string(net.vertices.size()) + "\n",
          Json::object(
              {{"verdict", "not certified"}, {"vertices", net.vertices.size()}, {"triangles", net.triangles.size()}})};
}

std::string statistics_text(const UncertifiedNet& net, std::uint32_t genus, double epsilon, const NetRequest& request,
                            const PhaseTimes& times) {
  const NetStatistics& s = net.statistics;
  const auto count = static_cast<double>(net.document.vertices.size());
  const double least = least_vertices(genus, epsilon);
  const double most = most_vertices(genus, epsilon);
  std::ostringstream out;
  out << "insertions: " << s.insertions << '\n';
  out << "vertices removed from the initial triangulation: " << s.removed << '\n';
  out << "lower bound (g-1)/sinh^2(epsilon/2), Theorem III.2: about " << least << ", ratio " << ratio_text(count, least)
      << '\n';
  out << "upper bound 16(g-1)/epsilon^2, Theorem III.1 if the systole is at least epsilon: about " << most << ", ratio "
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

/// The same numbers as statistics_text.
Json statistics_json(const UncertifiedNet& net, std::uint32_t genus, double epsilon, const NetRequest& request,
                     const PhaseTimes& times) {
  const NetStatistics& s = net.statistics;
  Json result = Json::object({{"insertions", s.insertions}});
  result["removed"] = s.removed;
  result["vertices_lower_bound"] = least_vertices(genus, epsilon);
  result["vertices_upper_bound"] = most_vertices(genus, epsilon);
  if (request.options.pseudo) result["undone"] = s.undone;
  result["charts"] = s.charts;
  result["labels"] = s.labels;
  result["multiprecision"] = s.multiprecision;
  const double document = std::max(0.0, times.computing - s.start_seconds - s.refine_seconds);
  Json seconds = Json::object({{"reading", times.reading},
                               {"start", s.start_seconds},
                               {"refinement", s.refine_seconds},
                               {"document", document}});
  if (!request.no_certify) seconds["certification"] = times.certifying;
  if (!request.svg.empty()) seconds["drawing"] = times.drawing;
  seconds["writing"] = times.writing;
  result["seconds"] = std::move(seconds);
  return result;
}

UncertifiedNet compute(const Surface& surface, const Length& epsilon, NetOptions options) {
  ProgressLine progress;
  options.progress = progress.shower();
  return compute_net(surface, epsilon, options);
}

certify::Certificate certify_net(const certify::NetDocument& net, unsigned threads) {
  ProgressLine progress;
  return proof_of(net, threads, progress.shower());
}

void check_request(const NetRequest& request) {
  if (request.options.sparse && request.options.pseudo)
    throw UsageError("--sparse and --pseudo: a pseudo net cannot be sparse");
  check_files({{"SURFACE", request.surface}, {"--points", request.points}},
              {{"--output", request.output, net_type(request.output)}, {"--svg", request.svg, FileType::svg}});
}

void make_net(const NetRequest& request) {
  const Length epsilon = parse_epsilon(request.epsilon);
  if (request.options.pseudo && !allows_pseudo_nets(epsilon))
    throw UsageError("--epsilon: " + epsilon.text() + " is more than ln sqrt(2) = 0.34657..., the limit for --pseudo");
  check_request(request);

  PhaseTimes times;
  Stopwatch watch;
  const Surface surface = read_surface_input(request.surface);
  times.reading = watch.lap();
  NetOptions options = request.options;
  if (!request.base.empty()) options.base = parse_base(request.base, surface);
  const std::vector<LineText> points =
      request.points.empty() ? std::vector<LineText>() : read_lines(request.points, kPointLines);
  for (const LineText& point : points) options.points.push_back(parse_given_point(point, surface));
  const UncertifiedNet net = [&] {
    try {
      return compute(surface, epsilon, options);
    } catch (const ClosePointsError& error) {
      throw JobError(close_points_message(error, options, points) + epsilon.text());
    }
  }();
  times.computing = watch.lap();
  certify::Certificate certificate;
  if (!request.no_certify) certificate = certify_net(net.document, request.options.threads);
  Report report = request.no_certify ? uncertified_report(net.document) : certificate_report(certificate);
  times.certifying = watch.lap();
  std::string svg;
  if (!request.svg.empty()) svg = draw_svg(net.document);
  times.drawing = watch.lap();
  write_outputs({{request.output, [&](std::ostream& out) { write_net_file(net.document, request.output, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  times.writing = watch.lap();
  if (request.stats) {
    const auto rounded = static_cast<double>(epsilon.value());
    report.text += statistics_text(net, surface.genus(), rounded, request, times);
    report.json["statistics"] = statistics_json(net, surface.genus(), rounded, request, times);
  }
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

Report certificate_report(const certify::Certificate& certificate) {
  std::ostringstream out;
  Report report;
  out << "verdict: " << certify::name(certificate.verdict) << '\n'
      << "vertices: " << certificate.counts.vertices << '\n';
  report.json = Json::object({{"verdict", certify::name(certificate.verdict)},
                              {"genus", certificate.counts.genus},
                              {"vertices", certificate.counts.vertices},
                              {"edges", certificate.counts.edges},
                              {"triangles", certificate.counts.triangles}});
  if (certificate.counts.collars) {
    out << "pseudo net, collars: " << *certificate.counts.collars << '\n';
    report.json["collars"] = *certificate.counts.collars;
  }
  if (certificate.enclosures) {
    const certify::Interval& circumradius = certificate.enclosures->largest_circumradius;
    const std::optional<certify::Interval>& edge = certificate.enclosures->shortest_edge;
    out << "largest circumradius: " << to_string(circumradius) << '\n'
        << "shortest edge between different vertices: " << (edge ? to_string(*edge) : "none") << '\n';
    report.json["largest_circumradius"] = interval_json(circumradius);
    report.json["shortest_edge"] = edge ? interval_json(*edge) : Json(nullptr);
  }
  report.text = out.str();
  return report;
}

void add_net_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<NetRequest>();
  NetRequest& request = *shared;
  CLI::App* net = app.add_subcommand("net", "Compute an epsilon-net of a surface, prove it, write it.");
  add_input(*net, "SURFACE", request.surface, "a surface file");
  net->add_option("--epsilon", request.epsilon, "a positive decimal or fraction: 0.1 is exactly 1/10")
      ->required()
      ->option_text("E REQUIRED");
  add_output(*net, request.output, "the net file to write, only if the net is verified");
  add_file(*net, "--svg", request.svg, "also draw the net; \"-\" is standard output");
  net->add_option("--base", request.base,
                  "start from this point alone: of tile T, exact; T alone is the centre of the tile")
      ->option_text("T[,X,Y]");
  CLI::Option* points = add_file(*net, "--points", request.points,
                                 "start from the points of this file, after --base if it is given: T,X,Y or T on each "
                                 "line, exact; they are the first vertices. It is an "
                                 "error if two are not farther than epsilon from each other; \"-\" is standard input");
  net->add_flag("--pseudo", request.options.pseudo,
                "a pseudo net: the collars of closed geodesics no longer than epsilon are left empty; "
                "epsilon at most ln sqrt(2)")
      ->excludes(points);
  net->add_flag("--sparse", request.options.sparse,
                "a net with few points: 1.4 to 1.5 times the lower bound of the thesis' Theorem III.2 instead of 2.15 "
                "times, at about eight times the cost; it is proved faster")
      ->excludes(points);
  net->add_flag("--no-certify", request.no_certify, "write the net without checking it: nothing is proved");
  net->add_flag("--stats", request.stats,
                "also print what was counted, the thesis' bounds for the number of points, and times");
  add_json(*net, request.json);
  add_threads(*net, request.options.threads);
  net->footer(
      "Example:\n"
      "  epsnet net s.json --epsilon 0.1 -o net.json --svg net.svg && certify net.json\n\n"
      "The report goes to standard output, or to standard error if a file goes there.");
  net->callback([&chosen, shared] { chosen = [shared] { make_net(*shared); }; });
}

namespace {

struct InfoRequest {
  std::string file;
  bool json = false;
};

/// The report for each kind of claim; of its net, for a kind without a report of its own.
struct ClaimContents {
  Report operator()(const certify::GeodesicsDocument& document) const { return geodesics_report(document); }
  Report operator()(const certify::DistanceDocument& document) const { return distance_report(document); }
  Report operator()(const certify::BoundDocument& document) const { return bound_report(document); }
  Report operator()(const certify::EigenvaluesDocument& document) const { return eigenvalues_report(document); }
  Report operator()(const certify::IsometriesDocument& document) const { return isometries_report(document); }
  Report operator()(const certify::PantsDocument& document) const { return pants_report(document); }
  Report operator()(const certify::ComparisonDocument& document) const { return comparison_report(document); }
  Report operator()(const certify::CurvesDocument& document) const { return curves_report(document); }
  Report operator()(const certify::NetDocument& net) const { return facts_report(net_info(net)); }
  template <class Document>
  Report operator()(const Document& document) const {
    return (*this)(document.net);
  }
};

/// The report for each kind of contents.
struct InfoOf {
  Report operator()(const Surface& surface) const { return facts_report(surface_info(surface)); }
  Report operator()(const DirichletPolygon& polygon) const { return facts_report(dirichlet_info(polygon)); }
  Report operator()(const ImportedSurface& imported) const {
    const bool polygon = imported.format == ExchangeFormat::domain;
    return facts_report(surface_info(imported.surface, polygon ? "polygon, a text of the domain format"
                                                               : "triangulation, a text with cross-ratios"));
  }
  Report operator()(const certify::ClaimDocument& claim) const {
    if (const auto* net = std::get_if<certify::NetDocument>(&claim)) return facts_report(net_info(*net));
    const certify::AnyClaim any(claim);
    const certify::ClaimKind& kind = certify::kind_of(any);
    const Report contents = std::visit(ClaimContents(), claim);
    const std::string word(kind.format.substr(std::string_view("epsnet-").size()));
    Report report{"file: " + std::string(kind.contents) + " (not verified here: run certify)\n" + contents.text,
                  Json::object({{"file", word}})};
    report.json.update(contents.json);
    return report;
  }
};

void print_info(const InfoRequest& request) {
  check_files({{"FILE", request.file}}, {});
  const Contents contents = read_any_input(request.file);
  try {
    write_report(std::visit(InfoOf(), contents), request.json, false);
  } catch (const NetGeometryError& error) {
    throw JobError(request.file + ": " + error.what());
  }
}

}  // namespace

void add_info_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<InfoRequest>();
  CLI::App* info =
      app.add_subcommand("info",
                         "Describe the contents of a file: a surface, a net, closed geodesics, a distance, a "
                         "diameter, eigenvalues, isometries, pants, curves, a Dirichlet domain, a text to import.");
  add_input(*info, "FILE", shared->file, "any file that epsnet writes for itself or imports");
  add_json(*info, shared->json);
  info->footer("Example:\n  epsnet info net.json\n  epsnet info --json s.json");
  info->callback([&chosen, shared] { chosen = [shared] { print_info(*shared); }; });
}

}  // namespace epsnet::program
