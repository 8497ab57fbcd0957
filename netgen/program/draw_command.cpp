#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/pictures/net_pictures.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "netgen/program/png.h"

namespace epsnet::program {
namespace {

struct DrawRequest {
  std::string file;
  std::string output;
  std::string geodesics;
  std::string distance;
  std::uint64_t eigenfunction = 0;  ///< 0: none is asked for.
  std::vector<std::string> show = {"triangles", "vertices"};
  bool dirichlet = false;
  bool png = false;
  DrawOptions options;
  std::vector<const CLI::Option*> of_nets;  ///< Options that only the picture of a net has.
  const CLI::Option* centre = nullptr;
  const CLI::Option* order = nullptr;
};

/// The vertex in the centre where none was asked for: beside the middle of the first curve that was, so that it is not
/// drawn small.
std::uint32_t centre_for(const certify::NetDocument& net, const DrawOptions& options) {
  for (const Layer& layer : options.layers) {
    if (!layer.in_front || layer.arcs.empty()) continue;
    const std::size_t end = layer.parts.size() > 1 ? layer.parts[1].first_arc : layer.arcs.size();
    const std::uint32_t dart = layer.arcs[end / 2].dart;
    return net.triangles[dart / 3].vertex[dart % 3];
  }
  return options.centre;
}

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
  if (!request.distance.empty()) options.layers.push_back(load_distance_layer(request.distance, net));
  if (request.centre->count() == 0) options.centre = centre_for(net, options);
  if (options.colouring == Colouring::values) {
    options.values = rounded_distances_from(net, options.centre);
    options.values_name = "distance";
  }
  return options;
}

struct Drawn {
  std::string svg;
  std::vector<std::string> left_out;
};

/// What is drawn of each kind of contents.
struct DrawingOf {
  const DrawRequest& request;

  Drawn operator()(const certify::NetDocument& net) const {
    Drawn result;
    result.svg = draw_svg(net, shown(request, net), &result.left_out);
    return result;
  }
  Drawn operator()(const ImportedSurface& imported) const { return (*this)(imported.surface); }
  Drawn operator()(const certify::ClaimDocument& claim) const { return std::visit(*this, claim); }
  Drawn operator()(const certify::EigenvaluesDocument& document) const {
    if (request.eigenfunction == 0) return of_claim(document);
    for (const CLI::Option* option : request.of_nets) {
      if (option->count() > 0 && option != request.centre && option != request.order)
        throw UsageError(option->get_name() + ": not with --eigenfunction");
    }
    const DrawOptions& options = request.options;
    try {
      return {eigenfunction_svg(document, request.eigenfunction,
                                {.order = options.order, .centre = options.centre, .size = options.size}),
              {}};
    } catch (const std::out_of_range& error) {
      throw JobError("--eigenfunction: " + std::string(error.what()));
    }
  }
  template <class T>
  Drawn operator()(const T& contents) const {
    return of_claim(contents);
  }
  template <class T>
  [[nodiscard]] Drawn of_claim(const T& contents) const {
    if constexpr (requires { picture_of(contents); }) {
      for (const CLI::Option* option : request.of_nets) {
        if (option->count() > 0) throw UsageError(option->get_name() + ": only for a net file");
      }
      const auto picture = picture_of(contents);
      Drawn result{draw_svg(picture, request.options.size), {}};
      if constexpr (requires { picture.left_out; }) result.left_out = picture.left_out;
      return result;
    } else {
      return (*this)(contents.net);
    }
  }
};

void draw(const DrawRequest& request) {
  const FileType type = request.png ? FileType::png : picture_type("--output", request.output);
  check_files({{"FILE", request.file}, {"--geodesics", request.geodesics}, {"--distance", request.distance}},
              {{"--output", request.output, type}});
  const Contents contents = read_any_input(request.file);
  if (request.eigenfunction > 0) {
    const auto* claim = std::get_if<certify::ClaimDocument>(&contents);
    if (claim == nullptr || !std::holds_alternative<certify::EigenvaluesDocument>(*claim))
      throw UsageError("--eigenfunction: only for an eigenvalues file");
  }
  Drawn drawn;
  try {
    drawn = std::visit(DrawingOf{request}, contents);
  } catch (const NetGeometryError& error) {
    throw JobError(request.file + ": " + error.what());
  }
  const std::string picture =
      type == FileType::png ? png_of_svg(drawn.svg, request.options.size) : std::move(drawn.svg);
  write_output(request.output, [&](std::ostream& out) { out << picture; });
  write_left_out(drawn.left_out);
}

}  // namespace

void add_draw_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DrawRequest>();
  DrawRequest& request = *shared;
  CLI::App* draw_command = app.add_subcommand(
      "draw",
      "Draw a file in the Poincare disk. Of a net one lift of every triangle, with one vertex in the centre; of a "
      "surface its tiles, laid out as one polygon; of eigenvalues their intervals and their number below each place, "
      "or an eigenfunction; of anything else a Dirichlet domain with what the file claims.");
  add_input(*draw_command, "FILE", request.file, "a net file, or any file that epsnet writes for itself or imports");
  add_output(*draw_command, request.output,
             "the picture to write, SVG or PNG as its name ends in .svg or .png, SVG without an extension");
  draw_command
      ->add_option(
          "--eigenfunction", request.eigenfunction,
          "of an eigenvalues file: the eigenfunction of its eigenvalue lambda_K, with the lines where it is 0, on "
          "the triangles of the net")
      ->check(integer_between(1, 1'000'000))
      ->option_text("K");
  request.order = draw_command
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
  request.centre = draw_command
                       ->add_option("--centre,--center", request.options.centre,
                                    "the vertex in the centre; by default 0, or a vertex beside the first curve of "
                                    "--distance or --geodesics")
                       ->option_text("V");
  add_geodesics(*draw_command, request.geodesics);
  add_distance(*draw_command, request.distance);
  for (const char* name :
       {"--order", "--show", "--dirichlet", "--colour", "--legend", "--centre", "--geodesics", "--distance"}) {
    request.of_nets.push_back(draw_command->get_option(name));
  }
  draw_command->add_flag("--png", request.png, "write a PNG picture, to standard output too");
  draw_command->add_option("--size", request.options.size, "width and height in pixels")
      ->check(integer_between(50, 20000))
      ->option_text("PX [1000]");
  draw_command->footer(
      "Example:\n"
      "  epsnet draw net.json -o net.svg --dirichlet\n"
      "  epsnet draw net.json -o net.png --show triangles,half-disks \\\n"
      "    --colour circumradius --legend\n"
      "  epsnet draw eigenvalues.json -o second.svg --eigenfunction 2\n"
      "  epsnet draw s.json -o s.svg");
  draw_command->callback([&chosen, shared] { chosen = [shared] { draw(*shared); }; });
}

}  // namespace epsnet::program
