#include <memory>
#include <optional>
#include <string>

#include "epsnet/netgen/dirichlet_polygon.h"
#include "epsnet/netgen/draw.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"
#include "epsnet/netgen/surface_file.h"

namespace epsnet::program {
namespace {

struct DirichletRequest {
  std::string surface;
  std::string base;
  std::string output;
  std::string svg;
};

void make_dirichlet(const DirichletRequest& request) {
  if (is_stdout(request.output) && is_stdout(request.svg))
    throw UsageError("--output and --svg cannot both be standard output");
  check_output_directory(request.output);
  if (!request.svg.empty()) check_output_directory(request.svg);
  const Surface surface = load_surface(request.surface);
  const std::optional<BasePoint> base =
      request.base.empty() ? std::nullopt : std::optional(parse_base(request.base, surface));
  const DirichletPolygon polygon = dirichlet_polygon(surface, base);
  std::string svg;
  if (!request.svg.empty()) {
    DrawOptions options;
    options.dirichlet = true;
    svg = draw_svg(polygon.triangulation, options);
  }
  write_output(request.output, [&](std::ostream& out) { out << dirichlet_json(polygon); });
  if (!request.svg.empty()) write_output(request.svg, [&](std::ostream& out) { out << svg; });
}

}  // namespace

void add_dirichlet_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DirichletRequest>();
  DirichletRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "dirichlet",
      "The Dirichlet domain of a point: its sides with their pairings as words, proved, and its vertices, rounded.");
  command->add_option("SURFACE", request.surface, "a surface file")->required()->option_text("REQUIRED");
  command
      ->add_option("--base", request.base,
                   "the point: of tile T, strictly inside of it, exact; T alone is its centre. Without it the "
                   "surface's first vertex, the "
                   "centre of a regular one")
      ->option_text("T[,X,Y]");
  add_output(*command, request.output, "the JSON file to write (docs/format.md)");
  command->add_option("--svg", request.svg, "also draw it, with the Delaunay triangulation; \"-\" is standard output")
      ->option_text("FILE");
  command->footer("Example:\n  epsnet dirichlet s.json --base 0,0.1,-1/3 -o domain.json --svg domain.svg");
  command->callback([&chosen, shared] { chosen = [shared] { make_dirichlet(*shared); }; });
}

}  // namespace epsnet::program
