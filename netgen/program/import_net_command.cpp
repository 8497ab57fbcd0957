#include <memory>
#include <string>

#include "epsnet/certify/check.h"
#include "epsnet/certify/writer.h"
#include "epsnet/netgen/imported_net.h"
#include "epsnet/netgen/program/commands.h"
#include "epsnet/netgen/program/output.h"
#include "epsnet/netgen/triangulation_stream.h"
#include "epsnet/netgen/words.h"

namespace epsnet::program {
namespace {

struct ImportNetRequest {
  std::string file;
  std::string epsilon;
  std::string output;
  certify::CheckOptions check;
};

TriangulationStream load_stream(const std::string& file) {
  const std::string text = read_text_file<TriangulationStreamError>(file);
  try {
    return read_triangulation_stream(text, file);
  } catch (const TriangulationStreamError& error) {
    if (is_triangulation_stream(text)) throw;
    throw JobError(std::string(error.what()) +
                   " (a triangulation is expected; a polygon is read by \"surface import\")");
  }
}

certify::Certificate certificate_of(const certify::Document& net, certify::CheckOptions options) {
  ProgressLine progress;
  options.progress = [&](std::string_view rule, double share) {
    progress.show("certificate: " + std::string(rule), share);
  };
  return certify::check(net, options);
}

std::string report_text(const certify::Document& net, const certify::Certificate& certificate) {
  std::string report = "verdict: " + std::string(certify::name(certificate.verdict)) + '\n';
  if (certificate.verdict != certify::Verdict::verified)
    report += "why: " + certificate.rule + ": " + certificate.message + '\n';
  report += "vertices: " + std::to_string(net.vertices.size()) + '\n';
  report += "triangles: " + std::to_string(net.triangles.size()) + '\n';
  if (certificate.enclosures) {
    report += "largest circumradius: " + interval_text(certificate.enclosures->largest_circumradius) + '\n';
    if (certificate.enclosures->shortest_edge)
      report +=
          "shortest edge between different vertices: " + interval_text(*certificate.enclosures->shortest_edge) + '\n';
  }
  return report;
}

void import_net(const ImportNetRequest& request) {
  const Epsilon epsilon = parse_epsilon(request.epsilon);
  check_output_directory(request.output);
  certify::Document net;
  try {
    net = net_of_tiles(develop(load_stream(request.file), request.file), epsilon);
  } catch (const ImportedNetError& error) {
    throw JobError(request.file + ": " + error.what());
  }
  const certify::Certificate certificate = certificate_of(net, request.check);
  // Whatever the verdict: to know it is what the command is for, and the file is what it is about.
  write_output(request.output, [&](std::ostream& out) { certify::write_net(net, out); });
  write_report(report_text(net, certificate), is_stdout(request.output));
  const std::string why = request.file + ": " + std::string(certify::name(certificate.verdict)) + ": " +
                          certificate.rule + ": " + certificate.message;
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
  command
      ->add_option("FILE", request.file,
                   "triangles with rational cross-ratios, with an anchor, none, or one for each triangle "
                   "(docs/exchange-formats.md)")
      ->required()
      ->option_text("REQUIRED");
  command->add_option("--epsilon", request.epsilon, "a positive decimal or fraction: 0.1 is exactly 1/10")
      ->required()
      ->option_text("E REQUIRED");
  add_output(*command, request.output, "the net file to write, whatever the verdict");
  add_threads(*command, request.check.threads);
  command->footer(
      "Example:\n"
      "  epsnet import-net triangulation.txt --epsilon 0.25 -o net.json\n\n"
      "The file is written for every verdict, so that certify, draw and view can show what is wrong.\n"
      "Exit code 0 if and only if the verdict is VERIFIED, 1 if REFUTED, 2 if UNDECIDED.");
  command->callback([&chosen, shared] { chosen = [shared] { import_net(*shared); }; });
}

}  // namespace epsnet::program
