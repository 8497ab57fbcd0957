#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>

#include "epsnet/netgen/domain_format.h"
#include "epsnet/netgen/exchange.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"
#include "epsnet/netgen/triangulation_stream.h"

namespace epsnet::program {
namespace {

struct ExportRequest {
  std::string file;
  ExchangeFormat format = ExchangeFormat::triangulation;
  std::string output;
};

std::string domain_text(const std::variant<Surface, certify::Document>& contents) {
  const auto* surface = std::get_if<Surface>(&contents);
  if (surface == nullptr) throw JobError("the domain format holds a polygon, not a net; use --format triangulation");
  return write_domain(*surface);
}

void export_file(const ExportRequest& request) {
  check_output_directory(request.output);
  const auto contents = load_surface_or_net(request.file);
  try {
    if (request.format == ExchangeFormat::domain) {
      const std::string text = domain_text(contents);
      write_output(request.output, [&](std::ostream& out) { out << text; });
      return;
    }
    const TriangulationStream stream =
        std::visit([](const auto& source) { return triangulation_stream(source); }, contents);
    write_output(request.output, [&](std::ostream& out) { write_triangulation_stream(stream, out); });
  } catch (const std::invalid_argument& error) {
    throw JobError(request.file + ": " + error.what());
  } catch (const TriangulationStreamError& error) {
    throw JobError(request.file + ": " + error.what());
  }
}

}  // namespace

void add_export_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<ExportRequest>();
  ExportRequest& request = *shared;
  CLI::App* command = app.add_subcommand("export", "Write a surface or a net as a text that CGAL reads, exactly.");
  command->add_option("FILE", request.file, "a surface file or a net file")->required()->option_text("REQUIRED");
  command
      ->add_option("--format", request.format,
                   "domain: the polygon of a surface of one tile; triangulation: the triangles of a net, or the tiles "
                   "of a surface cut into triangles, with an anchor and cross-ratios")
      ->required()
      ->transform(CLI::CheckedTransformer(std::map<std::string, ExchangeFormat>{
          {"domain", ExchangeFormat::domain}, {"triangulation", ExchangeFormat::triangulation}}))
      ->option_text("domain|triangulation REQUIRED");
  add_output(*command, request.output, "the text to write");
  command->footer(
      "Example:\n"
      "  epsnet export s.json --format domain -o polygon.txt\n"
      "  epsnet export net.json --format triangulation -o triangulation.txt");
  command->callback([&chosen, shared] { chosen = [shared] { export_file(*shared); }; });
}

}  // namespace epsnet::program
