#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "certify/check.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/pictures/net_pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

namespace epsnet::program {
namespace {

struct ViewRequest {
  std::string net;
  std::string output;
  std::string title;
  std::string geodesics;
  std::string distance;
  bool no_certify = false;
  bool json = false;
  certify::CheckOptions check;
};

/// Returns the distances by which the page colours the net; none if there are none, and then `report` says why.
std::vector<double> page_distances(const certify::NetDocument& net,
                                   const std::optional<certify::Certificate>& certificate, Report& report) {
  try {
    return distances_for_page(net, certificate);
  } catch (const Error& error) {
    report.text += std::string("left out: distances: ") + error.what() + '\n';
    report.json["left_out"]["distances"] = error.what();
    return {};
  }
}

std::string page(const ViewRequest& request, const certify::NetDocument& net,
                 const std::optional<certify::Certificate>& certificate, Report& report) {
  try {
    ViewerOptions options;
    options.title = request.title.empty() ? std::filesystem::path(request.net).filename().string() : request.title;
    options.certificate = certificate;
    options.layers = standard_layers(net);
    if (!request.geodesics.empty()) {
      for (Layer& layer : load_geodesics_layers(request.geodesics, net)) options.layers.push_back(std::move(layer));
    }
    if (!request.distance.empty()) options.layers.push_back(load_distance_layer(request.distance, net));
    for (const Layer& layer : options.layers) {
      if (layer.left_out.empty()) continue;
      report.text += "left out: " + layer.name + ": " + layer.left_out + '\n';
      report.json["left_out"][layer.name] = layer.left_out;
    }
    options.distances = page_distances(net, certificate, report);
    return viewer_page(net, options);
  } catch (const NetGeometryError& error) {
    throw JobError(request.net + ": " + error.what());
  }
}

void view(const ViewRequest& request) {
  check_files({{"NET", request.net}, {"--geodesics", request.geodesics}, {"--distance", request.distance}},
              {{"--output", request.output, FileType::html}});
  const certify::NetDocument net = read_net_input(request.net);
  std::optional<certify::Certificate> certificate;
  Report report{"verdict: not certified (--no-certify): nothing is proved about this net\n",
                Json::object({{"verdict", "not certified"}})};
  if (!request.no_certify) {
    certificate = certify::check(net, request.check);
    report.text = "verdict: " + std::string(certify::name(certificate->verdict)) + '\n';
    report.json["verdict"] = certify::name(certificate->verdict);
    if (!certificate->message.empty()) {
      report.text += certificate->rule + ": " + certificate->message + '\n';
      report.json["rule"] = certificate->rule;
      report.json["message"] = certificate->message;
    }
  }
  const std::string html = page(request, net, certificate, report);
  write_output(request.output, [&](std::ostream& out) { out << html; });
  write_report(report, request.json, is_stdout(request.output));
}

}  // namespace

void add_view_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<ViewRequest>();
  ViewRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "view", "A page to travel in the surface of a net, with its verdict: one HTML file that needs nothing else.");
  add_input(*command, "NET", request.net, "a net file");
  add_output(*command, request.output, "the HTML file to write");
  command->add_option("--title", request.title, "the page's title")->option_text("TEXT [the file's name]");
  add_geodesics(*command, request.geodesics);
  add_distance(*command, request.distance);
  command->add_flag("--no-certify", request.no_certify, "do not check the net; the page says so");
  add_json(*command, request.json);
  add_threads(*command, request.check.threads);
  command->footer(
      "Example:\n  epsnet view net.json -o view.html\n\n"
      "A net that is not verified is shown as well, with the reason.");
  command->callback([&chosen, shared] { chosen = [shared] { view(*shared); }; });
}

}  // namespace epsnet::program
