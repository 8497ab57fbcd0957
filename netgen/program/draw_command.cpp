#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/file/reader.h"
#include "netgen/distances/vertex_distances.h"
#include "netgen/lifts/net_geometry.h"
#include "netgen/pictures/draw.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "netgen/program/png.h"

namespace epsnet::program {
namespace {

struct DrawRequest {
  std::string net;
  std::string output;
  std::string geodesics;
  std::string distance;
  std::vector<std::string> show = {"triangles", "vertices"};
  bool dirichlet = false;
  bool png = false;
  DrawOptions options;
};

/// The options that --show names.
DrawOptions shown(const DrawRequest& request, const certify::NetDocument& net) {
  DrawOptions options = request.options;
  const auto has = [&](const char* name) {
    return std::find(request.show.begin(), request.show.end(), name) != request.show.end();
  };
  options.triangles = has("triangles");
  options.vertices = has("vertices");
  options.dirichlet = has("dirichlet") || request.dirichlet;
  options.combinatorial_dirichlet = has("combinatorial-dirichlet");
  options.covering_disks = has("disks");
  options.packing_disks = has("half-disks");
  if (has("tiles")) options.layers.push_back(tile_layer(NetGeometry(net)));
  for (Layer& layer : collar_layers(NetGeometry(net))) options.layers.push_back(std::move(layer));
  if (!request.geodesics.empty()) {
    for (Layer& layer : load_geodesics_layers(request.geodesics, net)) options.layers.push_back(std::move(layer));
  }
  if (options.colouring == Colouring::values) {
    const DistanceTable table = distances_from(net, {options.centre});
    for (std::size_t v = 0; v < table.to.size(); ++v) options.values.push_back(table.distance(0, v));
    options.values_name = "distance";
  }
  if (!request.distance.empty()) {
    try {
      options.layers.push_back(
          distance_layer(NetGeometry(net), certify::read_file<certify::DistanceDocument>(request.distance)));
    } catch (const NetGeometryError& error) {
      throw JobError(request.distance + ": " + error.what());
    }
  }
  return options;
}

void draw(const DrawRequest& request) {
  const FileType type = request.png ? FileType::png : picture_type("--output", request.output);
  check_files({{"NET", request.net}, {"--geodesics", request.geodesics}, {"--distance", request.distance}},
              {{"--output", request.output, type}});
  const certify::NetDocument net = read_net_input(request.net);
  std::string svg;
  std::vector<std::string> left_out;
  try {
    svg = draw_svg(net, shown(request, net), &left_out);
  } catch (const NetGeometryError& error) {
    throw JobError(request.net + ": " + error.what());
  }
  const std::string picture = type == FileType::png ? png_of_svg(svg, request.options.size) : std::move(svg);
  write_output(request.output, [&](std::ostream& out) { out << picture; });
  write_left_out(left_out);
}

}  // namespace

void add_draw_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DrawRequest>();
  DrawRequest& request = *shared;
  CLI::App* draw_command = app.add_subcommand(
      "draw", "Draw a net: one lift of every triangle, with one vertex in the centre of the Poincare disk.");
  add_input(*draw_command, "NET", request.net, "a net file");
  add_output(*draw_command, request.output,
             "the picture to write, SVG or PNG as its name ends in .svg or .png, SVG without an extension");
  draw_command
      ->add_option("--order", request.options.order,
                   "which triangle is lifted next: across the edge of least weight, or breadth-first")
      ->transform(one_of<DrawOrder>({{"weight", DrawOrder::weight}, {"bfs", DrawOrder::breadth_first}}))
      ->option_text("weight|bfs [weight]");
  draw_command
      ->add_option("--show", request.show,
                   "what is drawn: triangles, vertices, dirichlet (the Dirichlet domain of the centre), "
                   "combinatorial-dirichlet (the outline of the triangles lifted breadth first), tiles (the sides of "
                   "the fundamental tiles), disks (of radius epsilon), half-disks (of radius epsilon/2)")
      ->delimiter(',')
      ->check(CLI::IsMember(
          {"triangles", "vertices", "dirichlet", "combinatorial-dirichlet", "tiles", "disks", "half-disks"}))
      ->option_text("WHAT,... [triangles,vertices]");
  draw_command->add_flag("--dirichlet", request.dirichlet, "also draw the Dirichlet domain of the centre");
  draw_command
      ->add_option("--colour,--color", request.options.colouring,
                   "how triangles are filled: circumradius is pale at epsilon/2 and dark at epsilon; chart is a "
                   "colour for each chart of the file; distance is that from the centre, pale to dark")
      ->transform(one_of<Colouring>({{"none", Colouring::none},
                                     {"circumradius", Colouring::circumradius},
                                     {"chart", Colouring::chart},
                                     {"distance", Colouring::values}}))
      ->option_text("none|circumradius|chart|distance [none]");
  draw_command->add_flag("--legend", request.options.legend, "explain the colours in a corner");
  draw_command->add_option("--centre,--center", request.options.centre, "the vertex in the centre")
      ->option_text("V [0]");
  add_geodesics(*draw_command, request.geodesics);
  add_file(*draw_command, "--distance", request.distance,
           "also show the shortest paths of this file of the same surface (distance)");
  draw_command->add_flag("--png", request.png, "write a PNG picture, to standard output too");
  draw_command->add_option("--size", request.options.size, "width and height in pixels")
      ->check(integer_between(50, 20000))
      ->option_text("PX [1000]");
  draw_command->footer(
      "Example:\n"
      "  epsnet draw net.json -o net.svg --dirichlet\n"
      "  epsnet draw net.json -o net.png --show triangles,half-disks --colour circumradius --legend");
  draw_command->callback([&chosen, shared] { chosen = [shared] { draw(*shared); }; });
}

}  // namespace epsnet::program
