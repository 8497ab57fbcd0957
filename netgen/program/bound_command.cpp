#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/file/writer.h"
#include "netgen/base/progress_line.h"
#include "netgen/distances/distances.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::program {
namespace {

struct BoundRequest {
  std::string surface;
  std::string output;
  std::string ends;
  std::string svg;
  std::string width;
  unsigned threads = 0;
  bool json = false;
};

/// Where a bound is attained: a point, and the points that are farthest from it, if they are of interest and can be
/// had. The distance of the first of them is proved.
struct Where {
  BasePoint p;
  std::vector<BasePoint> farthest = {};
  std::optional<certify::DistanceDocument> distance = std::nullopt;
};

/// The vertex of a net of one vertex, which is certified, and the points farthest from it. Says on standard error if
/// they cannot be had.
Where where(const certify::NetDocument& net, bool with_farthest) {
  const Surface surface = from_document(net.surface);
  Where result{point_of_vertex(surface, net, 0)};
  if (!with_farthest) return result;
  try {
    const DirichletPolygon domain = dirichlet_polygon(surface, result.p);
    result.farthest = farthest_points(surface, domain);
    result.distance = distance(surface, result.p, domain, result.farthest.front()).document;
  } catch (const NotCertifiedError& error) {
    write_left_out({std::string("the distance of p and q: ") + error.what()});
  } catch (const Error& error) {
    write_left_out({std::string("the points farthest from p: ") + error.what()});
  }
  return result;
}

/// p is exact, q is rounded to multiples of 2⁻¹⁰⁰; everything else is an interval.
void add_where(Report& report, const Where& where) {
  report.text += "p: " + point_text(where.p) + '\n';
  report.json["p"] = point_json(where.p);
  if (where.farthest.empty()) return;
  report.json["q"] = Json::array();
  for (const BasePoint& q : where.farthest) {
    report.text += "q: " + point_text(q) + '\n';
    report.json["q"].push_back(point_json(q));
  }
  if (!where.distance) return;
  report.text += "distance of p and q: " + to_string(where.distance->distance) + '\n';
  report.json["distance_of_p_and_q"] = interval_json(where.distance->distance);
}

/// The option for a distance file from p to the first q.
void add_ends(CLI::App& command, std::string& ends) {
  add_file(command, "--ends", ends,
           "also write the distance file of p, where the bound is attained, and q, a point farthest from it, for "
           "certify; \"-\" is standard output");
}

/// The file of --ends; throws JobError if there is none although it was asked for.
NewFile ends_file(const std::string& path, const Where& where) {
  if (!path.empty() && !where.distance)
    throw JobError("--ends: the distance of p and q is not proved; nothing was written");
  return {path, [&where](std::ostream& out) { certify::write_file(*where.distance, out); }};
}

using MakeBound = Certified<certify::BoundDocument> (*)(const Surface&, const BoundOptions&);

void enclose(const BoundRequest& request, MakeBound make) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, FileType::json},
                                               {"--ends", request.ends, FileType::json},
                                               {"--svg", request.svg, FileType::svg}});
  const auto width = static_cast<double>(parse_length("--width", request.width).value());
  if (!(width >= kLeastBoundWidth)) throw UsageError("--width: less than the least width, 1e-12");
  const Surface surface = read_surface_input(request.surface);
  certify::BoundDocument document;
  {
    ProgressLine progress;
    BoundOptions options;
    options.width = width;
    options.threads = request.threads;
    options.progress = progress.shower();
    document = make(surface, options).document;
  }
  const Where found = where(document.net, document.claim != certify::BoundDocument::Claim::embedded_disk);
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }},
                 ends_file(request.ends, found),
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  Report report = verified_report();
  const Report bounds = bound_report(document);
  report.text += bounds.text;
  report.json.update(bounds.json);
  add_where(report, found);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.ends) || is_stdout(request.svg));
}

void add_bound_command(CLI::App& app, Job& chosen, const char* name, const char* what, MakeBound make,
                       const char* width = "1e-6", bool with_ends = true) {
  const auto shared = std::make_shared<BoundRequest>();
  shared->width = width;
  CLI::App* command = app.add_subcommand(name, what);
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  command->add_option("--width", shared->width, "the width of the enclosure, a length of at least 1e-12")
      ->option_text(std::string("W [") + width + "]");
  add_file(*command, "-o,--output", shared->output, "the bound file to write, for certify; \"-\" is standard output");
  add_threads(*command, shared->threads);
  if (with_ends) add_ends(*command, shared->ends);
  add_file(*command, "--svg", shared->svg, "also draw where the bound is attained; \"-\" is standard output");
  add_json(*command, shared->json);
  command->footer(std::string("Example:\n  epsnet ") + name +
                  " s.json --width 1e-3 -o bound.json && certify bound.json");
  command->callback([&chosen, shared, make] { chosen = [shared, make] { enclose(*shared, make); }; });
}

struct EccentricityRequest {
  std::string surface;
  std::string p;
  std::string output;
  std::string ends;
  std::string svg;
  bool json = false;
};

void measure_eccentricity(const EccentricityRequest& request) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, net_type(request.output)},
                                               {"--ends", request.ends, FileType::json},
                                               {"--svg", request.svg, FileType::svg}});
  const SurfaceOrNet input = read_surface_or_net(request.surface);
  const auto [net, certificate] = eccentricity_net(input.surface, parse_point("P", request.p, input));
  const Where found = where(net, true);
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of_eccentricity(net));
  write_outputs({{request.output, [&, &net = net](std::ostream& out) { write_net_file(net, request.output, out); }},
                 ends_file(request.ends, found),
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  const certify::Interval value = certificate.enclosures->largest_circumradius;
  Report report = verified_report();
  report.text += "eccentricity: " + to_string(value) + '\n';
  report.json["eccentricity"] = interval_json(value);
  add_where(report, found);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.ends) || is_stdout(request.svg));
}

}  // namespace

Report bound_report(const certify::BoundDocument& document) {
  using Claim = certify::BoundDocument::Claim;
  const std::string name = document.claim == Claim::diameter ? "diameter"
                           : document.claim == Claim::radius ? "radius"
                                                             : "embedded_disk_radius";
  std::size_t cells = 0;
  for (const auto& row : document.cells) {
    for (const std::uint32_t entry : row) cells += entry >= 3 ? 1 : 0;
  }
  const std::size_t triangulations = document.triangulations.size() + 1;
  return {name + ": " + to_string(document.value) + "\ncells: " + std::to_string(cells) +
              "\ntriangulations: " + std::to_string(triangulations) + '\n',
          Json::object({{name, interval_json(document.value)}, {"cells", cells}, {"triangulations", triangulations}})};
}

void add_eccentricity_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<EccentricityRequest>();
  CLI::App* command = app.add_subcommand(
      "eccentricity", "The greatest distance of a point of the surface from a given one, enclosed and proved.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  add_point(*command, "P", shared->p, kPointHelp);
  add_file(*command, "-o,--output", shared->output,
           "the net file with the one vertex P to write, for certify: its largest circumradius is the eccentricity; "
           "\"-\" is standard output");
  add_ends(*command, shared->ends);
  add_file(*command, "--svg", shared->svg, "also draw P and the points farthest from it; \"-\" is standard output");
  add_json(*command, shared->json);
  command->footer("Example:\n  epsnet eccentricity s.json 0,0.1,-1/3\n  epsnet eccentricity net.json v17");
  command->callback([&chosen, shared] { chosen = [shared] { measure_eccentricity(*shared); }; });
}

void add_diameter_command(CLI::App& app, Job& chosen) {
  add_bound_command(app, chosen, "diameter", "The diameter, the greatest distance of two points, enclosed and proved.",
                    &diameter);
}

void add_radius_command(CLI::App& app, Job& chosen) {
  add_bound_command(
      app, chosen, "radius",
      "The radius of the smallest disk that covers the surface (the least eccentricity), enclosed and proved.", &radius,
      "1e-2");
}

void add_embedded_disk_command(CLI::App& app, Job& chosen) {
  add_bound_command(app, chosen, "embedded-disk",
                    "The radius of the largest embedded disk, the greatest injectivity radius, enclosed and proved.",
                    &largest_embedded_disk, "1e-6", false);
}

}  // namespace epsnet::program
