#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "certify/claims.h"
#include "netgen/distances/distances.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "netgen/surfaces/group.h"

namespace epsnet::program {
namespace {

enum class ExportFormat {
  domain,
  triangulation,
  off,
  vtu,
  gmsh,
  gmsh_glued,
  medit,
  mfem,
  edges,
  adjacency,
  face_adjacency,
  json,
  matrices
};

struct ExportRequest {
  std::string file;
  ExportFormat format = ExportFormat::triangulation;
  std::string output;
  std::string distance_from;
  std::optional<MatrixModel> model;
};

/// The contents of a file that can be exported.
using Exportable = std::variant<Surface, certify::NetDocument>;
Exportable exportable(Contents contents, const std::string& file) {
  if (auto* surface = std::get_if<Surface>(&contents)) return std::move(*surface);
  if (const auto* net = net_in(contents)) return *net;
  if (auto* imported = std::get_if<ImportedSurface>(&contents)) return std::move(imported->surface);
  throw JobError(file + ": expected a surface file or a net file, not " +
                 (std::holds_alternative<DirichletPolygon>(contents)
                      ? "a Dirichlet domain"
                      : certify::kind_of(std::get<certify::ClaimDocument>(contents)).file()));
}

std::string domain_text(const Exportable& contents) {
  const auto* surface = std::get_if<Surface>(&contents);
  if (surface == nullptr)
    throw ExchangeError("the domain format holds a polygon, not a net; use --format triangulation");
  return write_domain(*surface);
}

FileType file_type(ExportFormat format) {
  switch (format) {
    case ExportFormat::off:
      return FileType::off;
    case ExportFormat::vtu:
      return FileType::vtu;
    case ExportFormat::gmsh:
    case ExportFormat::gmsh_glued:
      return FileType::msh;
    case ExportFormat::medit:
    case ExportFormat::mfem:
      return FileType::mesh;
    case ExportFormat::adjacency:
    case ExportFormat::face_adjacency:
      return FileType::mtx;
    case ExportFormat::json:
    case ExportFormat::matrices:
      return FileType::json;
    default:
      return FileType::text;
  }
}

/// Returns the function that writes a net in a rounded format; none for the exact formats.
std::function<void(const certify::NetDocument&, std::ostream&)> mesh_writer(ExportFormat format) {
  switch (format) {
    case ExportFormat::off:
      return write_off;
    case ExportFormat::vtu:
      return write_vtu;
    case ExportFormat::gmsh:
      return write_gmsh;
    case ExportFormat::gmsh_glued:
      return write_gmsh_glued;
    case ExportFormat::medit:
      return write_medit;
    case ExportFormat::mfem:
      return write_mfem;
    case ExportFormat::json:
      return write_mesh_json;
    default:
      return nullptr;
  }
}

/// Returns the function that writes the graph of a surface or a net; none for other formats.
std::function<void(const Exportable&, std::ostream&)> graph_writer(ExportFormat format) {
  switch (format) {
    case ExportFormat::edges:
      return [](const Exportable& contents, std::ostream& out) {
        std::visit([&](const auto& source) { write_edges(source, out); }, contents);
      };
    case ExportFormat::adjacency:
    case ExportFormat::face_adjacency:
      return [format](const Exportable& contents, std::ostream& out) {
        const auto nodes = format == ExportFormat::adjacency ? GraphNodes::vertices : GraphNodes::faces;
        std::visit([&](const auto& source) { write_adjacency(source, nodes, out); }, contents);
      };
    default:
      return nullptr;
  }
}

/// Returns the distances from a vertex of a net to all vertices.
VertexData distances_to_vertices(const ExportRequest& request, const certify::NetDocument& net) {
  const auto vertex = number_after('v', request.distance_from);
  if (!vertex) {
    throw UsageError("--distance-from: expected v and the number of a vertex, as in v17, not \"" +
                     request.distance_from.substr(0, 80) + "\"");
  }
  return {"distance", rounded_distances_from(net, *vertex)};
}

void export_file(const ExportRequest& request) {
  if (!request.distance_from.empty() && request.format != ExportFormat::vtu) {
    throw UsageError("--distance-from is for --format vtu");
  }
  check_files({{"FILE", request.file}}, {{"--output", request.output, file_type(request.format)}});
  if (request.model && request.format != ExportFormat::matrices) throw UsageError("--model is for --format matrices");
  if (request.format == ExportFormat::matrices) {
    const std::string text =
        write_matrices(read_surface_input(request.file), request.model.value_or(MatrixModel::sl2r));
    write_output(request.output, [&](std::ostream& out) { out << text; });
    return;
  }
  const Exportable contents = exportable(read_any_input(request.file), request.file);
  try {
    if (const auto write = mesh_writer(request.format)) {
      const auto* net = std::get_if<certify::NetDocument>(&contents);
      if (net == nullptr) throw JobError(request.file + ": a surface has no triangulation; this format takes a net");
      if (!request.distance_from.empty()) {
        const VertexData distances = distances_to_vertices(request, *net);
        write_output(request.output, [&](std::ostream& out) { write_vtu_with(distances, *net, out); });
        return;
      }
      write_output(request.output, [&](std::ostream& out) { write(*net, out); });
      return;
    }
    if (const auto write = graph_writer(request.format)) {
      write_output(request.output, [&](std::ostream& out) { write(contents, out); });
      return;
    }
    if (request.format == ExportFormat::domain) {
      const std::string text = domain_text(contents);
      write_output(request.output, [&](std::ostream& out) { out << text; });
      return;
    }
    write_output(request.output, [&](std::ostream& out) {
      std::visit([&](const auto& source) { write_triangulation(source, out); }, contents);
    });
  } catch (const ExchangeError& error) {
    throw JobError(request.file + ": " + error.what());
  } catch (const NetGeometryError& error) {
    throw JobError(request.file + ": " + error.what());
  }
}

}  // namespace

void add_export_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<ExportRequest>();
  ExportRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "export", "Write a surface or a net as a text that other programs read: CGAL's, exactly, or a mesh.");
  add_input(*command, "FILE", request.file, "a surface file or a net file");
  command
      ->add_option(
          "--format", request.format,
          "exact, for CGAL: domain, the polygon of a surface of one tile; triangulation, the triangles of a "
          "net, or the tiles of a surface cut into triangles, with an anchor and cross-ratios. Rounded, of a "
          "net: off or vtu, one lift of every triangle; for finite elements gmsh or medit (FreeFEM), one lift whose "
          "sides are glued in pairs, mfem, or gmsh-glued, each triangle in coordinates of its own; json, all of it. Of "
          "a net or of the tiles of a surface: edges, a table of vertices and lengths; adjacency or face-adjacency, "
          "the matrix of the graph of vertices or of faces, for MatrixMarket. Of any file: matrices, generators of the "
          "group of the surface with "
          "their relation, exact and rounded")
      ->required()
      ->transform(one_of<ExportFormat>({{"domain", ExportFormat::domain},
                                        {"triangulation", ExportFormat::triangulation},
                                        {"off", ExportFormat::off},
                                        {"vtu", ExportFormat::vtu},
                                        {"gmsh", ExportFormat::gmsh},
                                        {"gmsh-glued", ExportFormat::gmsh_glued},
                                        {"medit", ExportFormat::medit},
                                        {"mfem", ExportFormat::mfem},
                                        {"edges", ExportFormat::edges},
                                        {"adjacency", ExportFormat::adjacency},
                                        {"face-adjacency", ExportFormat::face_adjacency},
                                        {"json", ExportFormat::json},
                                        {"matrices", ExportFormat::matrices}}))
      ->option_text(
          "domain|triangulation|off|vtu|gmsh|gmsh-glued|medit|mfem|edges|adjacency|face-adjacency|json|matrices "
          "REQUIRED");
  add_output(*command, request.output, "the text to write");
  command
      ->add_option("--distance-from", request.distance_from,
                   "vtu: also the distance of every vertex from this one, as the array distance at points")
      ->option_text("vN");
  command
      ->add_option("--model", request.model,
                   "matrices: sl2r, acting on the half-plane, or su11, acting on the disk, as the numbers Re a, Im a, "
                   "Re b, Im b")
      ->transform(one_of<MatrixModel>({{"sl2r", MatrixModel::sl2r}, {"su11", MatrixModel::su11}}))
      ->option_text("sl2r|su11 [sl2r]");
  command->footer(
      "Example:\n"
      "  epsnet export s.json --format matrices -o matrices.json\n"
      "  epsnet export s.json --format domain -o polygon.txt\n"
      "  epsnet export net.json --format triangulation -o triangulation.txt\n"
      "  epsnet export net.json --format medit -o net.mesh\n"
      "  epsnet export net.json --format vtu --distance-from v0 -o net.vtu");
  command->callback([&chosen, shared] { chosen = [shared] { export_file(*shared); }; });
}

}  // namespace epsnet::program
