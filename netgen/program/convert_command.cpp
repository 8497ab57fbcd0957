#include <memory>
#include <string>

#include "certify/file/writer.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "netgen/surfaces/surface_file.h"

namespace epsnet::program {
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
