#include <memory>
#include <string>
#include <variant>

#include "netgen/lifts/info.h"
#include "netgen/lifts/net_geometry.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

namespace epsnet::program {
namespace {

struct InfoRequest {
  std::string file;
  bool json = false;
};

/// The report for each kind of contents.
struct InfoOf {
  Report operator()(const Surface& surface) const { return facts_report(surface_info(surface)); }
  Report operator()(const certify::NetDocument& net) const { return facts_report(net_info(net)); }
  Report operator()(const DirichletPolygon& polygon) const { return facts_report(dirichlet_info(polygon)); }
  Report operator()(const ImportedSurface& imported) const {
    const bool polygon = imported.format == ExchangeFormat::domain;
    return facts_report(surface_info(imported.surface, polygon ? "polygon, a text of the domain format"
                                                               : "triangulation, a text with cross-ratios"));
  }
  Report operator()(const certify::GeodesicsDocument& document) const {
    Report list = geodesics_report(document);
    Report report{"file: closed geodesics (not verified here: run certify)\n" + list.text,
                  Json::object({{"file", "geodesics"}})};
    report.json.update(list.json);
    return report;
  }
  Report operator()(const certify::DistanceDocument& document) const {
    Report list = distance_report(document, document.paths);
    Report report{"file: a distance (not verified here: run certify)\n" + list.text,
                  Json::object({{"file", "distance"}})};
    report.json.update(list.json);
    return report;
  }
  Report operator()(const certify::BoundDocument& document) const {
    Report bounds = bound_report(document);
    Report report{"file: a cover (not verified here: run certify)\n" + bounds.text, Json::object({{"file", "cover"}})};
    report.json.update(bounds.json);
    return report;
  }
};

void print_info(const InfoRequest& request) {
  check_files({{"FILE", request.file}}, {});
  const Contents contents = read_any_input(request.file);
  try {
    write_report(std::visit(InfoOf(), contents), request.json, false);
  } catch (const NetGeometryError& error) {
    throw JobError(request.file + ": " + error.what());
  }
}

}  // namespace

void add_info_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<InfoRequest>();
  CLI::App* info =
      app.add_subcommand("info",
                         "Describe the contents of a file: a surface, a net, closed geodesics, a distance, a "
                         "diameter, a Dirichlet domain, a text to import.");
  add_input(*info, "FILE", shared->file, "any file that epsnet writes for itself or imports");
  add_json(*info, shared->json);
  info->footer("Example:\n  epsnet info net.json\n  epsnet info --json s.json");
  info->callback([&chosen, shared] { chosen = [shared] { print_info(*shared); }; });
}

}  // namespace epsnet::program
