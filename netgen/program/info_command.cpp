#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "certify/claims.h"
#include "netgen/lifts/info.h"
#include "netgen/lifts/lifts.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

namespace epsnet::program {
namespace {

struct InfoRequest {
  std::string file;
  bool json = false;
};

/// The report for each kind of claim; of its net, for a kind without a report of its own.
struct ClaimContents {
  Report operator()(const certify::GeodesicsDocument& document) const { return geodesics_report(document); }
  Report operator()(const certify::DistanceDocument& document) const { return distance_report(document); }
  Report operator()(const certify::BoundDocument& document) const { return bound_report(document); }
  Report operator()(const certify::EigenvaluesDocument& document) const { return eigenvalues_report(document); }
  Report operator()(const certify::IsometriesDocument& document) const { return isometries_report(document); }
  Report operator()(const certify::PantsDocument& document) const { return pants_report(document); }
  Report operator()(const certify::NetDocument& net) const { return facts_report(net_info(net)); }
  template <class Document>
  Report operator()(const Document& document) const {
    return (*this)(document.net);
  }
};

/// The report for each kind of contents.
struct InfoOf {
  Report operator()(const Surface& surface) const { return facts_report(surface_info(surface)); }
  Report operator()(const DirichletPolygon& polygon) const { return facts_report(dirichlet_info(polygon)); }
  Report operator()(const ImportedSurface& imported) const {
    const bool polygon = imported.format == ExchangeFormat::domain;
    return facts_report(surface_info(imported.surface, polygon ? "polygon, a text of the domain format"
                                                               : "triangulation, a text with cross-ratios"));
  }
  Report operator()(const certify::ClaimDocument& claim) const {
    if (const auto* net = std::get_if<certify::NetDocument>(&claim)) return facts_report(net_info(*net));
    const certify::AnyClaim any(claim);
    const certify::ClaimKind& kind = certify::kind_of(any);
    const Report contents = std::visit(ClaimContents(), claim);
    const std::string word(kind.format.substr(std::string_view("epsnet-").size()));
    Report report{"file: " + std::string(kind.contents) + " (not verified here: run certify)\n" + contents.text,
                  Json::object({{"file", word}})};
    report.json.update(contents.json);
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
                         "diameter, eigenvalues, isometries, pants, a Dirichlet domain, a text to import.");
  add_input(*info, "FILE", shared->file, "any file that epsnet writes for itself or imports");
  add_json(*info, shared->json);
  info->footer("Example:\n  epsnet info net.json\n  epsnet info --json s.json");
  info->callback([&chosen, shared] { chosen = [shared] { print_info(*shared); }; });
}

}  // namespace epsnet::program
