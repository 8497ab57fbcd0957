#include <memory>
#include <string>

#include "certify/check.h"
#include "certify/file/writer.h"
#include "netgen/base/progress_line.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/triangulation_stream.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

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
  options.progress = progress.shower("certificate: ");
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

}  // namespace epsnet::program
