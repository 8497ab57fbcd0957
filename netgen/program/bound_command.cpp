#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "certify/check.h"
#include "certify/file/writer.h"
#include "netgen/base/progress_line.h"
#include "netgen/distances/bound.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

namespace epsnet::program {
namespace {

struct BoundRequest {
  std::string surface;
  std::string output;
  std::string width;
  bool json = false;
};

using MakeBound = certify::BoundDocument (*)(const Surface&, const BoundOptions&);

void enclose(const BoundRequest& request, MakeBound make) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, FileType::json}});
  const auto width = static_cast<double>(parse_length("--width", request.width).value());
  if (!(width >= kLeastBoundWidth)) throw UsageError("--width: less than the least width, 1e-12");
  const Surface surface = read_surface_input(request.surface);
  certify::BoundDocument document;
  certify::Certificate certificate;
  {
    ProgressLine progress;
    BoundOptions options;
    options.width = width;
    options.progress = progress.shower();
    document = make(surface, options);
  }
  {
    ProgressLine progress;
    certify::CheckOptions options;
    options.max_work = std::numeric_limits<std::uint64_t>::max();  // No limit, as the document was made here.
    options.progress = progress.shower("certificate: ");
    certificate = certify::check(document, options);
  }
  if (certificate.verdict != certify::Verdict::verified) {
    throw JobError("not certified: " + certify::verdict_line(certificate) + "; nothing was written");
  }
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }}});
  Report report{"verdict: VERIFIED\n", Json::object({{"verdict", "VERIFIED"}})};
  const Report bounds = bound_report(document);
  report.text += bounds.text;
  report.json.update(bounds.json);
  write_report(report, request.json, is_stdout(request.output));
}

void add_bound_command(CLI::App& app, Job& chosen, const char* name, const char* what, MakeBound make,
                       const char* width = "1e-6") {
  const auto shared = std::make_shared<BoundRequest>();
  shared->width = width;
  CLI::App* command = app.add_subcommand(name, what);
  add_input(*command, "SURFACE", shared->surface, "a surface file");
  command->add_option("--width", shared->width, "the width of the enclosure, a length of at least 1e-12")
      ->option_text(std::string("W [") + width + "]");
  add_file(*command, "-o,--output", shared->output, "the bound file to write, for certify; \"-\" is standard output");
  add_json(*command, shared->json);
  command->footer(std::string("Example:\n  epsnet ") + name +
                  " s.json --width 1e-3 -o bound.json && certify bound.json");
  command->callback([&chosen, shared, make] { chosen = [shared, make] { enclose(*shared, make); }; });
}

struct EccentricityRequest {
  std::string surface;
  std::string p;
  std::string output;
  bool json = false;
};

void measure_eccentricity(const EccentricityRequest& request) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, net_type(request.output)}});
  const SurfaceOrNet input = read_surface_or_net(request.surface);
  const certify::NetDocument net = eccentricity_net(input.surface, parse_point("P", request.p, input));
  const certify::Certificate certificate = certify::check(net);
  if (certificate.verdict != certify::Verdict::verified) {
    throw JobError("not certified: " + certify::verdict_line(certificate) + "; nothing was written");
  }
  write_outputs({{request.output, [&](std::ostream& out) { write_net_file(net, request.output, out); }}});
  const certify::Interval found = certificate.enclosures->largest_circumradius;
  write_report({"verdict: VERIFIED\neccentricity: " + to_string(found) + '\n',
                Json::object({{"verdict", "VERIFIED"}, {"eccentricity", interval_json(found)}})},
               request.json, is_stdout(request.output));
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
  add_input(*command, "SURFACE", shared->surface, "a surface file, or a net file");
  add_point(*command, "P", shared->p, std::string(kPointHelp) + ". It must be strictly inside its tile");
  add_file(*command, "-o,--output", shared->output,
           "the net file with the one vertex P to write, for certify: its largest circumradius is the eccentricity; "
           "\"-\" is standard output");
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
                    &largest_embedded_disk);
}

}  // namespace epsnet::program
