#include <memory>
#include <optional>
#include <string>

#include "netgen/lifts/info.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

namespace epsnet::program {
namespace {

struct DirichletRequest {
  std::string surface;
  std::string base;
  std::string output;
  std::string svg;
  bool json = false;
};

void make_dirichlet(const DirichletRequest& request) {
  check_files({{"SURFACE", request.surface}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  const SurfaceOrNet input = read_surface_or_net(request.surface);
  const std::optional<BasePoint> base =
      request.base.empty() ? std::nullopt : std::optional(parse_point("--base", request.base, input));
  const DirichletPolygon polygon = dirichlet_polygon(input.surface, base);
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(polygon));
  write_outputs({{request.output, [&](std::ostream& out) { out << dirichlet_json(polygon); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  if (request.json) {
    write_report(facts_report(dirichlet_info(polygon)), true, is_stdout(request.output) || is_stdout(request.svg));
  }
}

}  // namespace

void add_dirichlet_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DirichletRequest>();
  DirichletRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "dirichlet",
      "The Dirichlet domain of a point: its sides with their pairings as words, read off a verified triangulation, and "
      "its vertices, rounded.");
  add_input(*command, "SURFACE", request.surface, kSurfaceHelp);
  command
      ->add_option("--base", request.base,
                   std::string(kPointHelp) + ". Without it the surface's first vertex, the centre of a regular one")
      ->option_text("T[,X,Y]|vN|tN:A,B,C");
  add_output(*command, request.output, "the JSON file to write (docs/format.md)");
  add_file(*command, "--svg", request.svg, "also draw it, with its glued sides; \"-\" is standard output");
  add_json(*command, request.json);
  command->footer("Example:\n  epsnet dirichlet s.json --base 0,0.1,-1/3 -o domain.json --svg domain.svg");
  command->callback([&chosen, shared] { chosen = [shared] { make_dirichlet(*shared); }; });
}

}  // namespace epsnet::program
