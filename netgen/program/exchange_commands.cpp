#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "certify/check.h"
#include "certify/claims.h"
#include "certify/file/file.h"
#include "netgen/base/progress_line.h"
#include "netgen/distances/distances.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/lifts/lifts.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::program {
namespace {

struct ImportNetRequest {
  std::string file;
  std::string epsilon;
  std::string output;
  bool json = false;
  certify::CheckOptions check;
};

Surface triangles_of(const TextInput& input) {
  try {
    return import_surface(input.text, input.name, ExchangeFormat::triangulation);
  } catch (const ExchangeError& error) {
    if (is_triangulation_stream(input.text)) throw;
    throw JobError(std::string(error.what()) +
                   " (a triangulation is expected; a polygon is read by \"surface import\")");
  }
}

certify::Certificate certificate_of(const certify::NetDocument& net, certify::CheckOptions options) {
  ProgressLine progress;
  options.progress = progress.shower("certificate: rule ");
  return certify::check(net, options);
}

Report import_report(const certify::Certificate& certificate) {
  Report report = certificate_report(certificate);
  if (certificate.verdict != certify::Verdict::verified) {
    report.text += "why: " + certificate.rule + ": " + certificate.message + '\n';
    report.json["rule"] = certificate.rule;
    report.json["message"] = certificate.message;
  }
  report.text += "triangles: " + std::to_string(certificate.counts.triangles) + '\n';
  return report;
}

void import_net(const ImportNetRequest& request) {
  const Length epsilon = parse_epsilon(request.epsilon);
  check_files({{"FILE", request.file}}, {{"--output", request.output, net_type(request.output)}});
  const TextInput input = read_text_input(request.file);
  const Surface surface = triangles_of(input);
  certify::NetDocument net;
  try {
    net = net_of_tiles(surface, epsilon);
  } catch (const ExchangeError& error) {
    throw JobError(input.name + ": " + error.what());
  }
  const certify::Certificate certificate = certificate_of(net, request.check);
  // The file is written whatever the verdict, as the command is for finding the verdict of the file.
  write_output(request.output, [&](std::ostream& out) { write_net_file(net, request.output, out); });
  write_report(import_report(certificate), request.json, is_stdout(request.output));
  const std::string why = input.name + ": " + certify::verdict_line(certificate);
  if (certificate.verdict == certify::Verdict::undecided) throw UndecidedError(why);
  if (certificate.verdict != certify::Verdict::verified) throw JobError(why);
}

}  // namespace

void add_import_net_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<ImportNetRequest>();
  ImportNetRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "import-net",
      "A triangulation of CGAL as a net file, exactly as it is: no vertex is moved, added or removed and no edge "
      "flipped. Says whether it is an epsilon-net.");
  add_input(*command, "FILE", request.file,
            "triangles with rational cross-ratios, with an anchor, none, or one for each triangle "
            "(docs/exchange-formats.md)");
  command->add_option("--epsilon", request.epsilon, "a positive decimal or fraction: 0.1 is exactly 1/10")
      ->required()
      ->option_text("E REQUIRED");
  add_output(*command, request.output, "the net file to write, whatever the verdict");
  add_json(*command, request.json);
  add_threads(*command, request.check.threads);
  command->footer(
      "Example:\n"
      "  epsnet import-net triangulation.txt --epsilon 0.25 -o net.json\n\n"
      "The file is written for every verdict, so that certify, draw and view can show the error.\n"
      "Exit code 0 if and only if the verdict is VERIFIED, 1 if REFUTED, 2 if UNDECIDED.");
  command->callback([&chosen, shared] { chosen = [shared] { import_net(*shared); }; });
}

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
        if (const auto* net = std::get_if<certify::NetDocument>(&contents)) return write_adjacency(*net, nodes, out);
        write_matrix_market(lattice_matrix(std::get<Surface>(contents), nodes), out);
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

namespace {

struct ConvertRequest {
  std::string from;
  std::string to;
  bool surface = false;
};

void convert(const ConvertRequest& request) {
  check_files({{"FROM", request.from}}, {{"TO", request.to, request.surface ? FileType::json : net_type(request.to)}});
  if (request.surface) {
    const certify::SurfaceDocument surface = to_document(read_surface_input(request.from));
    write_output(request.to, [&](std::ostream& out) { certify::write_file(surface, out); });
    return;
  }
  const certify::NetDocument net = read_net_input(request.from);
  write_output(request.to, [&](std::ostream& out) { write_net_file(net, request.to, out); });
}

}  // namespace

void add_convert_command(CLI::App& app, Job& chosen) {
  auto request = std::make_shared<ConvertRequest>();
  CLI::App* command = app.add_subcommand(
      "convert",
      "Write a net file as JSON or, if the name ends in .epsn, as a compact file of some 55 bytes for each vertex, a "
      "third of the JSON; or the surface of any file. Nothing is lost or rounded, and nothing is checked: certify and "
      "every command read both.");
  add_input(*command, "FROM", request->from, "a net file, JSON or compact; with --surface any file that has a surface");
  command
      ->add_option("TO", request->to,
                   "file to write, compact if its name ends in .epsn, else JSON; \"-\" is standard output, as JSON")
      ->required()
      ->option_text("REQUIRED");
  command->add_flag("--surface", request->surface,
                    "write the surface file of a net, of closed geodesics, of a distance, of a diameter");
  command->footer(
      "Examples:\n"
      "  epsnet convert net.json net.epsn && certify net.epsn\n"
      "  epsnet convert net.epsn net.json\n"
      "  epsnet convert net.json s.json --surface");
  command->callback([&chosen, request] { chosen = [request] { convert(*request); }; });
}

}  // namespace epsnet::program
