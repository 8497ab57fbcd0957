#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <librsvg/rsvg.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "certify/check.h"
#include "netgen/base/progress_line.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/info.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"

namespace epsnet::program {
namespace {

/// Owns an object of a C library.
template <class T, auto release>
struct Releaser {
  void operator()(T* object) const { release(object); }
};
template <class T, auto release>
using Owned = std::unique_ptr<T, Releaser<T, release>>;

[[noreturn]] void fail(GError* error) {
  std::string message = "cannot make a PNG picture: ";
  message += error == nullptr ? "unknown error" : error->message;
  g_clear_error(&error);
  throw JobError(message);
}

/// Returns the PNG file of an SVG picture of a width in pixels, and as high as the picture, on white (librsvg). Throws
/// JobError.
std::string png_of_svg(const std::string& svg, std::uint32_t width) {
  GError* error = nullptr;
  const Owned<GInputStream, g_object_unref> stream(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
  // No limit, as a path of a fine net is a text node of more than 10 MB.
  const Owned<RsvgHandle, g_object_unref> picture(
      rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
  if (!picture) fail(error);
  double own_width = 1;
  double own_height = 1;
  rsvg_handle_get_intrinsic_size_in_pixels(picture.get(), &own_width, &own_height);
  const double height = std::round(own_height / own_width * width);
  const Owned<cairo_surface_t, cairo_surface_destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  const Owned<cairo_t, cairo_destroy> pen(cairo_create(surface.get()));
  cairo_set_source_rgb(pen.get(), 1, 1, 1);
  cairo_paint(pen.get());
  const RsvgRectangle viewport{0, 0, static_cast<double>(width), height};
  if (rsvg_handle_render_document(picture.get(), pen.get(), &viewport, &error) == 0) fail(error);
  std::string result;
  const auto append = [](void* out, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &result);
  if (status != CAIRO_STATUS_SUCCESS)
    throw JobError(std::string("cannot make a PNG picture: ") + cairo_status_to_string(status));
  return result;
}

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
      ->transform(integer_between(1, 1'000'000))
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
      ->transform(integer_between(50, 20000))
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
  const DirichletPolygon polygon = [&] {
    const ProgressLine progress("Dirichlet domain");
    return dirichlet_polygon(input.surface, base);
  }();
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
  add_progress(*command);
  command->footer("Example:\n  epsnet dirichlet s.json --base 0,0.1,-1/3 -o domain.json --svg domain.svg");
  command->callback([&chosen, shared] { chosen = [shared] { make_dirichlet(*shared); }; });
}

namespace {

struct ViewRequest {
  std::string net;
  std::string output;
  std::string title;
  std::string geodesics;
  std::string distance;
  bool no_certify = false;
  bool json = false;
  certify::CheckOptions check;
};

/// Returns the distances by which the page colours the net; none if there are none, and then `report` says why.
std::vector<double> page_distances(const certify::NetDocument& net,
                                   const std::optional<certify::Certificate>& certificate, Report& report) {
  try {
    return distances_for_page(net, certificate);
  } catch (const Error& error) {
    report.text += std::string("left out: distances: ") + error.what() + '\n';
    report.json["left_out"]["distances"] = error.what();
    return {};
  }
}

std::string page(const ViewRequest& request, const certify::NetDocument& net,
                 const std::optional<certify::Certificate>& certificate, Report& report) {
  try {
    ViewerOptions options;
    options.title = request.title.empty() ? std::filesystem::path(request.net).filename().string() : request.title;
    options.certificate = certificate;
    options.layers = standard_layers(net);
    if (!request.geodesics.empty()) {
      for (Layer& layer : load_geodesics_layers(request.geodesics, net)) options.layers.push_back(std::move(layer));
    }
    if (!request.distance.empty()) options.layers.push_back(load_distance_layer(request.distance, net));
    for (const Layer& layer : options.layers) {
      if (layer.left_out.empty()) continue;
      report.text += "left out: " + layer.name + ": " + layer.left_out + '\n';
      report.json["left_out"][layer.name] = layer.left_out;
    }
    options.distances = page_distances(net, certificate, report);
    return viewer_page(net, options);
  } catch (const NetGeometryError& error) {
    throw JobError(request.net + ": " + error.what());
  }
}

void view(const ViewRequest& request) {
  check_files({{"NET", request.net}, {"--geodesics", request.geodesics}, {"--distance", request.distance}},
              {{"--output", request.output, FileType::html}});
  const certify::NetDocument net = read_net_input(request.net);
  std::optional<certify::Certificate> certificate;
  Report report{"verdict: not certified (--no-certify): nothing is proved about this net\n",
                Json::object({{"verdict", "not certified"}})};
  if (!request.no_certify) {
    certificate = certify::check(net, request.check);
    report.text = "verdict: " + std::string(certify::name(certificate->verdict)) + '\n';
    report.json["verdict"] = certify::name(certificate->verdict);
    if (!certificate->message.empty()) {
      report.text += certificate->rule + ": " + certificate->message + '\n';
      report.json["rule"] = certificate->rule;
      report.json["message"] = certificate->message;
    }
  }
  const std::string html = page(request, net, certificate, report);
  write_output(request.output, [&](std::ostream& out) { out << html; });
  write_report(report, request.json, is_stdout(request.output));
}

}  // namespace

void add_view_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<ViewRequest>();
  ViewRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "view", "A page to travel in the surface of a net, with its verdict: one HTML file that needs nothing else.");
  add_input(*command, "NET", request.net, "a net file");
  add_output(*command, request.output, "the HTML file to write");
  command->add_option("--title", request.title, "the page's title")->option_text("TEXT [the file's name]");
  add_geodesics(*command, request.geodesics);
  add_distance(*command, request.distance);
  command->add_flag("--no-certify", request.no_certify, "do not check the net; the page says so");
  add_json(*command, request.json);
  add_threads(*command, request.check.threads);
  command->footer(
      "Example:\n  epsnet view net.json -o view.html\n\n"
      "A net that is not verified is shown as well, with the reason.");
  command->callback([&chosen, shared] { chosen = [shared] { view(*shared); }; });
}

}  // namespace epsnet::program
