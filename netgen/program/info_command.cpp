#include <memory>
#include <string>
#include <variant>

#include "epsnet/netgen/info.h"
#include "epsnet/netgen/net_geometry.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"

namespace epsnet::program {
namespace {

std::string info_text(const std::string& path) {
  const auto contents = load_surface_or_net(path);
  if (const auto* surface = std::get_if<Surface>(&contents)) return surface_info(*surface);
  try {
    return net_info(std::get<certify::Document>(contents));
  } catch (const NetGeometryError& error) {
    throw JobError(path + ": " + error.what());
  }
}

void print_info(const std::string& path) {
  const std::string text = info_text(path);
  write_stdout([&](std::ostream& out) { out << text; });
}

}  // namespace

void add_info_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<std::string>();
  CLI::App* info = app.add_subcommand("info", "Say what is in a surface file or a net file.");
  info->add_option("FILE", *shared, "a surface file or a net file")->required()->option_text("REQUIRED");
  info->footer("Example:\n  epsnet info net.json");
  info->callback([&chosen, shared] { chosen = [shared] { print_info(*shared); }; });
}

}  // namespace epsnet::program
