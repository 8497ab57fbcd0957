#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/file/writer.h"
#include "netgen/base/progress_line.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

/// The command pants: a pants decomposition of a surface, and its Fenchel–Nielsen coordinates.
namespace epsnet::program {
namespace {

struct PantsRequest {
  std::string surface;
  std::string curves;
  std::string output;
  std::string svg;
  bool find = false;
  bool json = false;
  unsigned threads = 0;
};

Report own_report(const PantsDecomposition& pants) {
  Report report = verified_report();
  Report contents = pants_report(pants.document);
  report.text += contents.text;
  report.json.update(contents.json);
  report.json["own"] = pants.own;
  Json& cuffs = report.json["cuffs"];
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) cuffs[e]["word"] = pants.cuffs[e].curve;
  report.json["pants"] = pants.pants;
  if (pants.own) report.text += "these are the pants of which the surface was made\n";
  return report;
}

void cut_into_pants(const PantsRequest& request) {
  check_files({{"SURFACE", request.surface}, {"--curves", request.curves}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  const Surface surface = read_surface_input(request.surface);
  PantsOptions options;
  options.own = !request.find;
  options.threads = request.threads;
  std::vector<std::string> names;
  if (!request.curves.empty()) {
    for (const LineText& line : read_lines(request.curves, "curves, expected one on each line, as in 0 3 5")) {
      options.curves.push_back(parse_word(line.name, line.text));
      names.push_back(line.name);
    }
  }
  const PantsDecomposition pants = [&] {
    ProgressLine progress;
    options.progress = progress.shower();
    try {
      return pants_decomposition(surface, options);
    } catch (const CurveError& error) {
      throw JobError(names[error.number()] + ": " + error.what());
    }
  }();
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(pants.document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(pants.document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  write_report(own_report(pants), request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

Report pants_report(const certify::PantsDocument& document) {
  Report report;
  Json& json = report.json;
  std::string graph;
  Json cuffs = Json::array();
  std::ostringstream out;
  for (std::size_t e = 0; e < document.cuffs.size(); ++e) {
    const certify::PantsDocument::Cuff& cuff = document.cuffs[e];
    const auto& [p, k] = cuff.ends[0];
    const auto& [q, l] = cuff.ends[1];
    if (e > 0) graph += ' ';
    graph += std::to_string(p) + '-' + std::to_string(q);
    out << "cuff " << e << " (" << p << '.' << k << '-' << q << '.' << l << "): length " << to_string(cuff.length)
        << ", twist " << to_string(cuff.twist) << '\n';
    Json& entry = cuffs.emplace_back(Json::object({{"ends", {{p, k}, {q, l}}},
                                                   {"length", interval_json(cuff.length)},
                                                   {"twist", interval_json(cuff.twist)},
                                                   {"across", cuff.across}}));
    if (cuff.exp_half_length != 0) {
      out << "  exp(length/2) = " << cuff.exp_half_length.get_str() << ", exactly\n";
      entry["exp_half_length"] = cuff.exp_half_length.get_str();
    }
  }
  json["genus"] = document.pants.size() / 2 + 1;
  json["graph"] = graph;
  json["cuffs"] = std::move(cuffs);
  report.text = "pants: " + std::to_string(document.pants.size()) +
                ", cuffs: " + std::to_string(document.cuffs.size()) + "\ngraph: " + graph + '\n' + out.str();
  return report;
}

void add_pants_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<PantsRequest>();
  CLI::App* command = app.add_subcommand(
      "pants",
      "A pants decomposition of a surface, and its Fenchel-Nielsen coordinates, in intervals that are proved.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  CLI::Option* curves = add_file(*command, "--curves", shared->curves,
                                 "disjoint simple closed curves to cut along, one on each line, by the numbers of the "
                                 "sides that it crosses; short ones complete them; \"-\" is standard input");
  command
      ->add_flag("--find", shared->find,
                 "look for short curves, also if surface fenchel-nielsen made the surface and its own cuffs are known")
      ->excludes(curves);
  add_file(*command, "-o,--output", shared->output,
           "the pants file to write, for certify and for surface fenchel-nielsen --from; \"-\" is standard output");
  add_file(*command, "--svg", shared->svg, "also draw the cuffs in a Dirichlet domain; \"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Twists are given modulo the lengths, between -1/2 and 1/2 of them. docs/fenchel-nielsen.md has the "
      "conventions.\n\n"
      "Example:\n  epsnet surface octagon --seed 5 -o s.json\n"
      "  epsnet pants s.json -o pants.json && certify pants.json\n"
      "  epsnet surface fenchel-nielsen --from pants.json -o t.json");
  command->callback([&chosen, shared] { chosen = [shared] { cut_into_pants(*shared); }; });
}

}  // namespace epsnet::program
