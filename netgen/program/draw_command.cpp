#include <map>
#include <memory>
#include <string>

#include "epsnet/certify/reader.h"
#include "epsnet/netgen/draw.h"
#include "epsnet/netgen/net_geometry.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"

namespace epsnet::program {
namespace {

struct DrawRequest {
  std::string net;
  std::string output;
  DrawOptions options;
};

void draw(const DrawRequest& request) {
  check_output_directory(request.output);
  const certify::Document net = certify::read_net(request.net);
  std::string svg;
  try {
    svg = draw_svg(net, request.options);
  } catch (const NetGeometryError& error) {
    throw JobError(request.net + ": " + error.what());
  }
  write_output(request.output, [&](std::ostream& out) { out << svg; });
}

}  // namespace

void add_draw_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DrawRequest>();
  DrawRequest& request = *shared;
  CLI::App* draw_command = app.add_subcommand(
      "draw", "Draw a net: one lift of every triangle, with vertex 0 in the centre of the Poincare disk.");
  draw_command->add_option("NET", request.net, "a net file")->required()->option_text("REQUIRED");
  add_output(*draw_command, request.output, "the SVG file to write");
  draw_command
      ->add_option("--order", request.options.order,
                   "which triangle is lifted next: across the edge of least weight, or breadth-first")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, DrawOrder>{{"weight", DrawOrder::weight}, {"bfs", DrawOrder::breadth_first}}))
      ->option_text("weight|bfs [weight]");
  draw_command->add_flag("--dirichlet", request.options.dirichlet, "also draw the Dirichlet domain of vertex 0");
  draw_command->add_option("--size", request.options.size, "width and height in pixels")
      ->check(CLI::Range(50U, 20000U))
      ->option_text("PX [1000]");
  draw_command->footer("Example:\n  epsnet draw net.json -o net.svg --dirichlet");
  draw_command->callback([&chosen, shared] { chosen = [shared] { draw(*shared); }; });
}

}  // namespace epsnet::program
