#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "epsnet/certify/reader.h"
#include "epsnet/netgen/decimal.h"
#include "epsnet/netgen/net_geometry.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"

namespace epsnet::program {

void add_output(CLI::App& command, std::string& output, const char* what) {
  command.add_option("-o,--output", output, std::string(what) + "; \"-\" is standard output")
      ->required()
      ->option_text("FILE REQUIRED");
}

void add_threads(CLI::App& command, unsigned& threads) {
  command.add_option("--threads", threads, "of the certificate; 0 is one per core")
      ->check(CLI::Range(0U, 1024U))
      ->option_text("N [0]");
}

Epsilon parse_length(const std::string& option, const std::string& text) {
  try {
    return Epsilon(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
}

void add_geodesics(CLI::App& command, std::string& file) {
  command
      .add_option("--geodesics", file,
                  "also show the closed geodesics of this file of the same surface (systole, spectrum, thick-thin)")
      ->option_text("FILE");
}

std::vector<Layer> load_geodesics_layers(const std::string& file, const certify::Document& net) {
  const certify::GeodesicsDocument document = certify::read_geodesics(file);
  try {
    return geodesics_layers(NetGeometry(net), document);
  } catch (const NetGeometryError& error) {
    throw JobError(file + ": " + error.what());
  }
}

BasePoint parse_base(const std::string& text, const Surface& surface) {
  const std::size_t first = std::min(text.find(','), text.size());
  const std::string tile = text.substr(0, first);
  const bool digits = !tile.empty() && tile.size() <= 9 && tile.find_first_not_of("0123456789") == std::string::npos;
  if (digits && first == text.size()) return centre_of_tile(surface, static_cast<std::uint32_t>(std::stoul(tile)));
  const std::size_t second = text.find(',', first + 1);
  if (digits && second != std::string::npos) {
    const auto x = parse_decimal(std::string_view(text).substr(first + 1, second - first - 1));
    const auto y = parse_decimal(std::string_view(text).substr(second + 1));
    if (x && y) return {static_cast<std::uint32_t>(std::stoul(tile)), {*x, *y}};
  }
  throw UsageError("--base: expected a tile and a point of it, as in 0,1/10,-0.25, or a tile alone, not \"" +
                   text.substr(0, 80) + "\"");
}

}  // namespace epsnet::program
