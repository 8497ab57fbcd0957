#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "certify/base/interval.h"
#include "certify/file/writer.h"
#include "netgen/base/gmp.h"
#include "netgen/distances/distances.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "triangulation/surface/atlas.h"

namespace epsnet::program {
namespace {

struct DistanceRequest {
  std::string surface;
  std::string p;
  std::string q;
  std::string output;
  std::string svg;
  std::string width = "1e-12";
  bool json = false;
};

void measure_distance(const DistanceRequest& request) {
  check_files({{"SURFACE", request.surface}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  const Length width = parse_length("--width", request.width);
  const SurfaceOrNet input = read_surface_or_net(request.surface);
  const BasePoint p = parse_point("P", request.p, input);
  const BasePoint q = parse_point("Q", request.q, input);
  const certify::DistanceDocument document =
      distance(input.surface, p, q, {.width = static_cast<double>(width.value())}).document;
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  Report report = verified_report();
  const Report found = distance_report(document);
  report.text += found.text;
  report.json.update(found.json);
  report.json["p"] = point_json(p);
  report.json["q"] = point_json(q);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

Report distance_report(const certify::DistanceDocument& document) {
  Report report{"distance: " + to_string(document.distance) + '\n',
                Json::object({{"distance", interval_json(document.distance)}, {"equal", document.equal}})};
  report.text += "paths: " + std::to_string(document.paths.size());
  if (document.paths.size() > 1) {
    report.text += document.equal ? ", all the shortest ones, of exactly equal length"
                                  : ", all of length at most " + certify::decimal_below(document.distance.upper);
  }
  report.text += '\n';
  report.json["paths"] = Json::array();
  for (const std::vector<std::uint32_t>& word : document.paths) {
    report.text += "word:";
    for (const std::uint32_t side : word) report.text.append(" ").append(std::to_string(side));
    report.text += '\n';
    report.json["paths"].push_back(word);
  }
  return report;
}

void add_distance_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DistanceRequest>();
  DistanceRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "distance",
      "The distance between two points of a surface, enclosed and proved, and all shortest geodesics between them.");
  add_input(*command, "SURFACE", request.surface, kSurfaceHelp);
  add_point(*command, "P", request.p, kPointHelp);
  add_point(*command, "Q", request.q, "the other point");
  add_file(*command, "-o,--output", request.output,
           "the distance file to write, for certify; \"-\" is standard output");
  add_file(*command, "--svg", request.svg,
           "also draw the paths, in the Dirichlet domain of P; \"-\" is standard output");
  command
      ->add_option("--width", request.width,
                   "the largest width of the enclosure, which is as narrow as binary64 allows; an error if it is wider")
      ->option_text("W [1e-12]");
  add_json(*command, request.json);
  command->footer(
      "Example:\n  epsnet distance s.json 0,0.1,-1/3 1,0,0\n  epsnet distance net.json v0 v17 -o d.json && certify "
      "d.json");
  command->callback([&chosen, shared] { chosen = [shared] { measure_distance(*shared); }; });
}

}  // namespace epsnet::program
