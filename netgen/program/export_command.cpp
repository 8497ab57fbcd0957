#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "epsnet/netgen/domain_format.h"
#include "epsnet/netgen/mesh_export.h"
#include "epsnet/netgen/net_geometry.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"
#include "epsnet/netgen/triangulation_stream.h"

namespace epsnet::program {
namespace {

enum class ExportFormat { domain, triangulation, off, vtu, edges, json };

struct ExportRequest {
  std::string file;
  ExportFormat format = ExportFormat::triangulation;
  std::string output;
};

std::string domain_text(const std::variant<Surface, certify::Document>& contents) {
  const auto* surface = std::get_if<Surface>(&contents);
  if (surface == nullptr) throw JobError("the domain format holds a polygon, not a net; use --format triangulation");
  return write_domain(*surface);
}

/// What writes the format of a net, rounded; none for the exact formats.
std::function<void(const certify::Document&, std::ostream&)> mesh_writer(ExportFormat format) {
  switch (format) {
    case ExportFormat::off:
      return write_off;
    case ExportFormat::vtu:
      return write_vtu;
    case ExportFormat::edges:
      return write_edges;
    case ExportFormat::json:
      return write_mesh_json;
    default:
      return nullptr;
  }
}

void export_file(const ExportRequest& request) {
  check_output_directory(request.output);
  const auto contents = load_surface_or_net(request.file);
  try {
    if (const auto write = mesh_writer(request.format)) {
      const auto* net = std::get_if<certify::Document>(&contents);
      if (net == nullptr) throw JobError(request.file + ": a surface has no triangulation; this format takes a net");
      write_output(request.output, [&](std::ostream& out) { write(*net, out); });
      return;
    }
    if (request.format == ExportFormat::domain) {
      const std::string text = domain_text(contents);
      write_output(request.output, [&](std::ostream& out) { out << text; });
      return;
    }
    const TriangulationStream stream =
        std::visit([](const auto& source) { return triangulation_stream(source); }, contents);
    write_output(request.output, [&](std::ostream& out) { write_triangulation_stream(stream, out); });
  } catch (const DomainError& error) {
    throw JobError(request.file + ": " + error.what());
  } catch (const NetGeometryError& error) {
    throw JobError(request.file + ": " + error.what());
  } catch (const TriangulationStreamError& error) {
    throw JobError(request.file + ": " + error.what());
  }
}

}  // namespace

void add_export_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<ExportRequest>();
  ExportRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "export", "Write a surface or a net as a text that other programs read: CGAL's, exactly, or a mesh.");
  command->add_option("FILE", request.file, "a surface file or a net file")->required()->option_text("REQUIRED");
  command
      ->add_option("--format", request.format,
                   "exact, for CGAL: domain, the polygon of a surface of one tile; triangulation, the triangles of a "
                   "net, or the tiles of a surface cut into triangles, with an anchor and cross-ratios. Rounded, of a "
                   "net: off or vtu, one lift of every triangle; edges, a table of vertices and lengths; json, all of "
                   "it")
      ->required()
      ->transform(one_of<ExportFormat>({{"domain", ExportFormat::domain},
                                        {"triangulation", ExportFormat::triangulation},
                                        {"off", ExportFormat::off},
                                        {"vtu", ExportFormat::vtu},
                                        {"edges", ExportFormat::edges},
                                        {"json", ExportFormat::json}}))
      ->option_text("domain|triangulation|off|vtu|edges|json REQUIRED");
  add_output(*command, request.output, "the text to write");
  command->footer(
      "Example:\n"
      "  epsnet export s.json --format domain -o polygon.txt\n"
      "  epsnet export net.json --format triangulation -o triangulation.txt\n"
      "  epsnet export net.json --format vtu -o net.vtu");
  command->callback([&chosen, shared] { chosen = [shared] { export_file(*shared); }; });
}

}  // namespace epsnet::program
