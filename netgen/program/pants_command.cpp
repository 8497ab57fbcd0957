#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/base/progress_line.h"
#include "netgen/pants/pants.h"
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
  bool find = false;
  bool json = false;
  unsigned threads = 0;
};

/// The middle of a narrow interval, as a decimal that reads back as the same binary64.
std::string middle_text(certify::Interval x) { return certify::shortest(x.lower + (x.upper - x.lower) / 2); }

/// Returns the coordinates as `surface fenchel-nielsen --from` reads them.
Json coordinates_json(const PantsDecomposition& pants) {
  Json lengths = Json::array();
  Json twists = Json::array();
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) {
    lengths.push_back(middle_text(cuff.length));
    twists.push_back(middle_text(cuff.twist));
  }
  return Json::object(
      {{"graph", graph_text(pants.graph)}, {"lengths", std::move(lengths)}, {"twists", std::move(twists)}});
}

Report pants_report(const PantsDecomposition& pants) {
  Report report;
  report.json["genus"] = pants.graph.genus();
  report.json["graph"] = graph_text(pants.graph);
  report.json["own"] = pants.own;
  Json& cuffs = report.json["cuffs"] = Json::array();
  std::ostringstream out;
  out << "pants: " << pants.graph.pants_count() << ", cuffs: " << pants.cuffs.size()
      << (pants.own ? ", those of which the surface was made" : "") << '\n';
  out << "graph: " << graph_text(pants.graph) << '\n';
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) {
    const PantsDecomposition::Cuff& cuff = pants.cuffs[e];
    const auto& [first, second] = pants.graph.edges()[e];
    out << "cuff " << e << " (" << first.pants << '.' << first.cuff << '-' << second.pants << '.' << second.cuff
        << "): length " << to_string(cuff.length) << ", twist " << to_string(cuff.twist) << ", word "
        << word_text(cuff.curve) << '\n';
    Json& entry = cuffs.emplace_back(Json::object({{"ends", {{first.pants, first.cuff}, {second.pants, second.cuff}}},
                                                   {"length", interval_json(cuff.length)},
                                                   {"twist", interval_json(cuff.twist)},
                                                   {"word", cuff.curve},
                                                   {"across", cuff.across}}));
    if (cuff.exact_root) {
      out << "  exp(length/2) = " << cuff.exact_root->str() << ", exactly\n";
      entry["exp_half_length"] = cuff.exact_root->str();
    }
  }
  report.json["pants"] = pants.pants;
  out << "proved: the surface is glued of these pants with these lengths and twists, modulo the lengths\n";
  report.text = out.str();
  return report;
}

void cut_into_pants(const PantsRequest& request) {
  check_files({{"SURFACE", request.surface}, {"--curves", request.curves}},
              {{"--output", request.output, FileType::json}});
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
  write_output(request.output, [&](std::ostream& out) { out << coordinates_json(pants).dump() << '\n'; });
  write_report(pants_report(pants), request.json, is_stdout(request.output));
}

}  // namespace

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
           "the coordinates to write, for surface fenchel-nielsen --from; \"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Twists are given modulo the lengths, between -1/2 and 1/2 of them. docs/fenchel-nielsen.md has the "
      "conventions.\n\n"
      "Example:\n  epsnet surface octagon --seed 5 -o s.json\n"
      "  epsnet pants s.json -o coordinates.json\n"
      "  epsnet surface fenchel-nielsen --from coordinates.json -o t.json");
  command->callback([&chosen, shared] { chosen = [shared] { cut_into_pants(*shared); }; });
}

}  // namespace epsnet::program
