#include <memory>
#include <string>

#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

namespace epsnet::program {
namespace {

struct ConvertRequest {
  std::string from;
  std::string to;
};

void convert(const ConvertRequest& request) {
  check_files({{"FROM", request.from}}, {{"TO", request.to, net_type(request.to)}});
  const certify::NetDocument net = read_net_input(request.from);
  write_output(request.to, [&](std::ostream& out) { write_net_file(net, request.to, out); });
}

}  // namespace

void add_convert_command(CLI::App& app, Job& chosen) {
  auto request = std::make_shared<ConvertRequest>();
  CLI::App* command = app.add_subcommand(
      "convert",
      "Writes a net file as JSON or, if the name ends in .epsn, as a compact file of some 55 bytes for each vertex, a "
      "third\nof the JSON. Nothing is lost or rounded either way, and nothing is checked: certify and every command "
      "read both.");
  add_input(*command, "FROM", request->from, "net file, JSON or compact");
  command
      ->add_option("TO", request->to,
                   "file to write, compact if its name ends in .epsn, else JSON; \"-\" is standard output, as JSON")
      ->required()
      ->option_text("REQUIRED");
  command->footer(
      "Examples:\n"
      "  epsnet convert net.json net.epsn && certify net.epsn\n"
      "  epsnet convert net.epsn net.json");
  command->callback([&chosen, request] { chosen = [request] { convert(*request); }; });
}

}  // namespace epsnet::program
