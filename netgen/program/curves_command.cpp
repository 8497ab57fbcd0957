#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/file/file.h"
#include "netgen/base/progress_line.h"
#include "netgen/curves/curves.h"
#include "netgen/isometries/isometries.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"

/// The commands curves and mapping-class: how closed curves meet, their classes in homology, and whether they fill the
/// surface; what products of Dehn twists do to them. And maximize, which makes their lengths greatest.
namespace epsnet::program {
namespace {

using certify::CurvesDocument;

struct CurvesRequest {
  std::string surface;
  std::vector<std::string> words;
  std::string file;
  std::string output;
  std::string svg;
  bool angles = false;
  bool json = false;
  unsigned threads = 0;
};

/// The curves asked about, with what messages call them.
struct NamedWords {
  std::vector<std::string> names;
  std::vector<Word> words;
};

NamedWords words_of(const CurvesRequest& request) {
  NamedWords result;
  const auto add = [&](const std::string& name, const std::string& text) {
    result.words.push_back(parse_word(name, text));
    result.names.push_back(name);
  };
  for (std::size_t i = 0; i < request.words.size(); ++i) add("WORD " + std::to_string(i), request.words[i]);
  if (!request.file.empty()) {
    for (const LineText& line : read_lines(request.file, "curves, expected one on each line, as in 0 3 5")) {
      add(line.name, line.text);
    }
  }
  if (result.words.empty()) throw UsageError("curves: expected WORD or --curves FILE (try --help)");
  return result;
}

/// "a1 + 2 b3": the class of a curve in the basis a1, b1, a2, b2, … that epsnet writes, or in that of a file.
std::string class_text(const std::vector<std::int64_t>& homology) {
  std::string text;
  for (std::size_t i = 0; i < homology.size(); ++i) {
    const std::int64_t x = homology[i];
    if (x == 0) continue;
    text += text.empty() ? (x < 0 ? "-" : "") : (x < 0 ? " - " : " + ");
    if (std::abs(x) != 1) text += std::to_string(std::abs(x)) + ' ';
    text += (i % 2 == 0 ? 'a' : 'b') + std::to_string(i / 2 + 1);
  }
  return text.empty() ? "0" : text;
}

bool is_zero_class(const std::vector<std::int64_t>& homology) {
  return std::all_of(homology.begin(), homology.end(), [](std::int64_t x) { return x == 0; });
}

std::string kind_text(const CurvesDocument::Curve& curve) {
  std::string text;
  if (curve.power != 1) text += "power " + std::to_string(curve.power) + ", ";
  if (curve.self_intersections != 0) return text + "self-intersections " + std::to_string(curve.self_intersections);
  return text + "simple, " + (is_zero_class(curve.homology) ? "separating" : "not separating");
}

Json curve_json(const CurvesDocument::Curve& curve) {
  const bool simple = curve.self_intersections == 0;
  return Json::object({{"vertex", curve.vertex},
                       {"word", curve.word},
                       {"length", interval_json(curve.length)},
                       {"power", curve.power},
                       {"self_intersections", curve.self_intersections},
                       {"simple", simple},
                       {"separating", simple && is_zero_class(curve.homology)},
                       {"homology", curve.homology}});
}

/// What is known of angles and of pieces, which a file does not say.
Report computed_report(const Surface& surface, const NamedWords& given, bool angles, bool fill) {
  const CurveTopology topology(surface);
  std::vector<ClosedCurve> curves;
  for (const Word& word : given.words) curves.push_back(topology.curve(word));
  Report report;
  std::ostringstream out;
  Json genera = Json::array();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i].is_separating()) continue;
    const std::uint32_t left = *curves[i].genus_on_the_left;
    out << "curve " << i << " has genus " << left << " on its left, " << surface.genus() - left << " on its right\n";
    genera.push_back(Json::object({{"curve", i}, {"left", left}, {"right", surface.genus() - left}}));
  }
  report.json["genera"] = genera;
  report.json["fill"] = fill;
  if (!fill) out << "the curves do not fill the surface\n";
  if (angles) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < curves.size(); ++i) {
      for (std::size_t j = i; j < curves.size(); ++j) {
        for (const GeodesicCrossing& crossing : topology.crossings(curves[i], curves[j])) {
          const double degrees = (crossing.angle.lower + crossing.angle.upper) * 90 / std::numbers::pi;
          out << "angle " << i << ' ' << j << ": " << to_string(crossing.angle) << " (" << degrees << " degrees)\n";
          rows.push_back(Json::object({{"first", i}, {"second", j}, {"angle", interval_json(crossing.angle)}}));
        }
      }
    }
    report.json["angles"] = rows;
  }
  report.text = out.str();
  return report;
}

void examine_curves(const CurvesRequest& request) {
  check_files({{"SURFACE", request.surface}, {"--curves", request.file}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  const Surface surface = read_surface_input(request.surface);
  const NamedWords given = words_of(request);
  const auto found = [&] {
    ProgressLine progress;
    try {
      return curves(surface, given.words, {.threads = request.threads, .progress = progress.shower()});
    } catch (const CurveError& error) {
      throw JobError(given.names[error.number()] + ": " + error.problem());
    }
  }();
  Report report = verified_report();
  for (const Report& part : {curves_report(found.document),
                             computed_report(surface, given, request.angles, !found.document.filling.empty())}) {
    report.text += part.text;
    report.json.update(part.json);
  }
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(found.document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(found.document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

// ---- mapping-class ----

struct MappingClassRequest {
  std::string surface;
  std::string product;
  std::vector<std::string> words;
  bool json = false;
  unsigned threads = 0;
};

Report generators_report(const MappingClassGroup& group) {
  Report report;
  Json rows = Json::object();
  for (const NamedCurve& one : group.generators()) {
    report.text += one.name + ": " + word_text(letters_of(one.curve)) + '\n';
    rows[one.name] = letters_of(one.curve);
  }
  report.json["generators"] = rows;
  return report;
}

/// A closed curve of the command line.
ClosedCurve checked(const CurveTopology& topology, const std::string& name, const Word& word) {
  try {
    return topology.curve(word);
  } catch (const SurfaceError& error) {
    throw JobError(name + ": " + error.problem());
  }
}

/// The number of the isometry of which it is the mapping class, if there is one.
std::optional<std::uint32_t> isometry_of(const Surface& surface, const MappingClassGroup& group, const MappingClass& f,
                                         std::uint32_t order, unsigned threads) {
  ProgressLine progress;
  const IsometryGroup isometries = epsnet::isometries(surface, {.threads = threads, .progress = progress.shower()});
  for (std::uint32_t i = 0; i < isometries.size(); ++i) {
    if (isometries.order(i) == order && group.is_isometry(f, isometries.isometry(i))) return i;
  }
  return std::nullopt;
}

void examine_mapping_class(const MappingClassRequest& request) {
  if (request.product.empty() && !request.words.empty())
    throw UsageError(
        "mapping-class: --on needs PRODUCT, in front of it: all that follows --on are curves (try --help)");
  const Surface surface = read_surface_input(request.surface);
  const MappingClassGroup group(surface);
  if (request.product.empty()) return write_report(generators_report(group), request.json, false);
  const MappingClass f = group.parse(request.product);
  Report report;
  std::ostringstream out;
  try {
    Json images = Json::array();
    for (std::size_t i = 0; i < request.words.size(); ++i) {
      const std::string name = "--on " + std::to_string(i);
      const ClosedCurve curve = checked(group.topology(), name, parse_word(name, request.words[i]));
      const std::vector<std::uint32_t> image = letters_of(group.topology().word(group.image(f, curve)));
      out << "image of curve " << i << ": " << word_text(image) << '\n';
      images.push_back(image);
    }
    report.json["images"] = images;
    const auto matrix = group.homology(f);
    out << "in homology, in the basis a1, b1, ...:\n";
    Json rows = Json::array();
    for (const std::vector<mpz_class>& row : matrix) {
      Json entries = Json::array();
      for (const mpz_class& x : row) {
        out << ' ' << x;
        entries.push_back(x.get_str());
      }
      out << '\n';
      rows.push_back(entries);
    }
    report.json["homology"] = rows;
    const std::optional<std::uint32_t> order = group.order(f);
    out << "order " << (order ? std::to_string(*order) : "infinite") << '\n';
    report.json["order"] = order ? Json(*order) : Json();
    if (order) {
      const auto isometry = isometry_of(surface, group, f, *order, request.threads);
      out << (isometry ? "the mapping class of isometry " + std::to_string(*isometry) + " of epsnet isometries"
                       : std::string("of no isometry of this surface"))
          << '\n';
      report.json["isometry"] = isometry ? Json(*isometry) : Json();
    }
  } catch (const CurveError& error) {
    throw JobError("PRODUCT: twist " + std::to_string(error.number()) + ": " + error.problem());
  }
  report.text = out.str();
  write_report(report, request.json, false);
}

// ---- maximize systole ----

struct MaximizeRequest {
  std::string surface;
  std::string output;
  std::uint32_t steps = MaximizeOptions().steps;
  bool json = false;
  unsigned threads = 0;
};

void climb_to_systole(const MaximizeRequest& request) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, FileType::json}});
  const Surface surface = read_surface_input(request.surface);
  const SystoleMaximum found = [&] {
    ProgressLine progress;
    return maximize_systole(surface,
                            {.steps = request.steps, .threads = request.threads, .progress = progress.shower()});
  }();
  Report report;
  std::ostringstream out;
  const std::size_t edges = found.coordinates.values.size() / 2;
  Json curves = Json::array();
  out << "systole: " << to_string(found.systole)
      << ", proved\nclosed geodesics as long as it, to 9 digits: " << found.systoles.size() << '\n';
  for (const Word& word : found.systoles) {
    out << "  " << word_text(letters_of(word)) << '\n';
    curves.push_back(letters_of(word));
  }
  Json lengths = Json::array();
  Json twists = Json::array();
  out << "pants graph: " << graph_text(found.coordinates.graph) << '\n';
  for (std::size_t e = 0; e < edges; ++e) {
    const certify::Interval& length = found.coordinates.values[e];
    const certify::Interval& twist = found.coordinates.values[edges + e];
    out << "edge " << e << ": length " << to_string(length) << ", twist " << to_string(twist) << '\n';
    lengths.push_back(interval_json(length));
    twists.push_back(interval_json(twist));
  }
  report.json = Json::object({{"systole", interval_json(found.systole)},
                              {"systoles", curves},
                              {"graph", graph_text(found.coordinates.graph)},
                              {"lengths", lengths},
                              {"twists", twists},
                              {"surfaces", found.steps},
                              {"maximum_within", nullptr}});
  if (found.proof) {
    const std::string distance = certify::decimal_above(found.proof->distance, 3);
    out << "a local maximum of the systole is nearer than " << distance
        << " in all coordinates; this program alone proves it, in interval arithmetic\n";
    report.json["maximum_within"] = found.proof->distance;
  } else {
    out << "not proved: that a local maximum of the systole is near\n";
  }
  report.text = out.str();
  const certify::SurfaceDocument document = to_document(found.surface);
  write_output(request.output, [&](std::ostream& stream) { certify::write_file(document, stream); });
  write_report(report, request.json, is_stdout(request.output));
}

}  // namespace

Report curves_report(const CurvesDocument& document) {
  Report report;
  Json& json = report.json;
  std::ostringstream out;
  json["curves"] = Json::array();
  for (std::size_t i = 0; i < document.curves.size(); ++i) {
    const CurvesDocument::Curve& curve = document.curves[i];
    out << "curve " << i << ": length " << to_string(curve.length) << ", " << kind_text(curve) << ", class "
        << class_text(curve.homology) << "\n  " << word_text(curve.word) << '\n';
    json["curves"].push_back(curve_json(curve));
  }
  json["pairs"] = Json::array();
  for (const CurvesDocument::Pair& pair : document.pairs) {
    json["pairs"].push_back(Json::object({{"first", pair.first},
                                          {"second", pair.second},
                                          {"intersections", pair.intersections},
                                          {"algebraic", pair.algebraic}}));
    if (pair.intersections == 0) continue;
    out << "curves " << pair.first << ' ' << pair.second << ": intersections " << pair.intersections << ", algebraic "
        << pair.algebraic << '\n';
  }
  json["basis"] = document.basis;
  json["filling"] = document.filling;
  out << "basis of homology a1, b1, ...: curves " << word_text(document.basis) << '\n';
  for (const std::vector<std::uint32_t>& set : document.filling) {
    out << "these fill the surface: curves " << word_text(set) << '\n';
  }
  report.text = out.str();
  return report;
}

void add_curves_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<CurvesRequest>();
  CLI::App* command = app.add_subcommand("curves",
                                         "How closed curves meet, proved: intersection numbers, which are simple or "
                                         "separating, their classes in homology, "
                                         "and whether they fill the surface.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  command
      ->add_option("WORD", shared->words,
                   "closed curves, each as the numbers of the sides that it crosses, in quotes or with commas; epsnet "
                   "spectrum and epsnet pants print such words")
      ->option_text("...");
  add_file(*command, "--curves", shared->file, "more of them, one on each line; \"-\" is standard input");
  command->add_flag("--angles", shared->angles, "also the angles at which the geodesics cross");
  add_file(*command, "-o,--output", shared->output, "the curves file to write, for certify; \"-\" is standard output");
  add_file(*command, "--svg", shared->svg, "also draw their geodesics in a Dirichlet domain; \"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Curves are taken up to free homotopy. The file ends with 2g curves more, a symplectic basis of the homology, in "
      "which classes are given. The algebraic number counts 1 where the second curve crosses the first from right to "
      "left, else -1. Genera of pieces and angles are computed, not in the file. docs/curves.md says how.\n\n"
      "Example:\n  epsnet surface octagon --seed 5 -o s.json\n"
      "  epsnet curves s.json 0 1,2 -o curves.json && certify curves.json");
  command->callback([&chosen, shared] { chosen = [shared] { examine_curves(*shared); }; });
}

void add_mapping_class_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<MappingClassRequest>();
  CLI::App* command = app.add_subcommand("mapping-class",
                                         "What a product of Dehn twists does to curves and to homology; its order, and "
                                         "whether it is that of an isometry.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  command->add_option("PRODUCT", shared->product, kProductHelp);
  command->add_option("--on", shared->words, "closed curves of which to print the images, each as a word of sides")
      ->option_text("WORD ...");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Without PRODUCT it lists the generators: b_i meets a_i once, and c_i meets b_i and b_(i+1) once. Twists along "
      "a1, "
      "a2, all b_i and all c_i generate the mapping class group (Humphries). docs/curves.md has the conventions.\n\n"
      "Example:\n  epsnet surface octagon --seed 5 -o s.json\n"
      "  epsnet mapping-class s.json \"a1 b1 c1 b2\" --on 0 1,2\n"
      "  epsnet surface dehn-twist s.json --word \"a1 B1 c1^2\" -o t.json");
  command->callback([&chosen, shared] { chosen = [shared] { examine_mapping_class(*shared); }; });
}

void add_maximize_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<MaximizeRequest>();
  CLI::App* maximize = app.add_subcommand("maximize", "Climb from a surface to one that is extreme.");
  maximize->require_subcommand(0, 1);
  maximize->footer("Example:\n  epsnet maximize systole s.json -o t.json");
  CLI::App* command = maximize->add_subcommand(
      "systole", "To a local maximum of the systole, with a proof that one is near: the surface and its systoles.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  add_output(*command, shared->output, "the surface file to write");
  command->add_option("--steps", shared->steps, "look at no more surfaces than that")
      ->transform(integer_between(1, 100000))
      ->option_text("N [" + std::to_string(shared->steps) + "]");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "It changes Fenchel-Nielsen coordinates: each time a linear programme says how all short closed geodesics get "
      "longer together. docs/curves.md says how, and why the proof is one.\n\n"
      "Example:\n  epsnet surface octagon --seed 5 -o s.json\n  epsnet maximize systole s.json -o t.json");
  command->callback([&chosen, shared] { chosen = [shared] { climb_to_systole(*shared); }; });
}

}  // namespace epsnet::program
