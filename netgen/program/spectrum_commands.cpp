#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "certify/file/file.h"
#include "netgen/base/progress_line.h"
#include "netgen/curves/curves.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "netgen/prove/certified.h"

/// The commands systole, spectrum, thick-thin and local-maximum: lists of closed geodesics, each with its proof.

namespace epsnet::program {
namespace {

using ClosedGeodesic = certify::GeodesicsDocument::ClosedGeodesic;
using certify::GeodesicsDocument;

struct GeodesicsRequest {
  std::string surface;
  std::string up_to;
  std::string epsilon = "1";
  std::string output;
  std::string svg;
  bool no_certify = false;
  bool json = false;
  unsigned threads = 0;
};

/// Finds geodesics; they are not proved yet.
using Find = std::function<GeodesicsDocument(const Surface&, const GeodesicsOptions&)>;

/// Returns "name: value" lines for a systole, otherwise a row for each geodesic.
std::string geodesics_text(const GeodesicsDocument& document) {
  std::ostringstream out;
  if (document.claim == certify::GeodesicsDocument::Claim::systole) {
    const ClosedGeodesic& shortest = document.geodesics.front();
    out << "systole: " << to_string(shortest.length) << '\n'
        << "simple: " << (shortest.simple ? "yes" : "no") << '\n'
        << "word: " << word_text(shortest.word) << '\n';
    return out.str();
  }
  const bool small = document.claim == certify::GeodesicsDocument::Claim::thick_thin;
  if (document.claim == certify::GeodesicsDocument::Claim::local_maximum) {
    out << "a local maximum of the systole: " << document.clusters[0].count << " shortest closed geodesics of length "
        << to_string(document.geodesics[0].length) << '\n';
  }
  out << "closed geodesics: " << document.geodesics.size() << ", primitive, up to orientation, of length at most "
      << (small ? "2 arsinh 1" : document.up_to) << '\n';
  for (const certify::GeodesicsDocument::Cluster& cluster : document.clusters) {
    for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
      const ClosedGeodesic& geodesic = document.geodesics[i];
      out << i << ": length " << to_string(geodesic.length);
      if (small) out << ", collar of half-width " << to_string(collar_half_width(geodesic.length));
      if (!small) out << (geodesic.simple ? ", simple" : ", not simple");
      if (cluster.count > 1) {
        out << ", one of " << cluster.count << (cluster.equal ? " of equal length" : " of lengths that overlap");
      }
      out << ", word " << word_text(geodesic.word) << '\n';
    }
  }
  for (std::size_t p = 0; p < document.pieces.size(); ++p) {
    const certify::GeodesicsDocument::Piece& piece = document.pieces[p];
    out << "piece " << p << ": genus " << piece.genus << ", " << piece.boundaries.size()
        << (piece.boundaries.size() == 1 ? " boundary" : " boundaries");
    for (const auto& [geodesic, side] : piece.boundaries)
      out << ", " << (side == 0 ? "left" : "right") << " of " << geodesic;
    out << '\n';
  }
  return out.str();
}

Json geodesics_json(const GeodesicsDocument& document) {
  const bool small = document.claim == certify::GeodesicsDocument::Claim::thick_thin;
  Json result = Json::object();
  result["claim"] = document.claim_name();
  if (document.has_up_to()) result["up_to"] = document.up_to;
  result["geodesics"] = Json::array();
  for (const ClosedGeodesic& geodesic : document.geodesics) {
    Json& entry = result["geodesics"].emplace_back(Json::object());
    entry["length"] = interval_json(geodesic.length);
    if (small) entry["collar_half_width"] = interval_json(collar_half_width(geodesic.length));
    entry["simple"] = geodesic.simple;
    entry["word"] = geodesic.word;
  }
  if (document.claim != certify::GeodesicsDocument::Claim::systole) {
    result["clusters"] = Json::array();
    for (const certify::GeodesicsDocument::Cluster& cluster : document.clusters) {
      result["clusters"].push_back(
          Json::object({{"first", cluster.first}, {"count", cluster.count}, {"equal", cluster.equal}}));
    }
  }
  if (document.claim == certify::GeodesicsDocument::Claim::local_maximum) {
    result["basis"] = document.basis;
    result["weights"] = document.weights;
  }
  if (small) {
    result["pieces"] = Json::array();
    for (const certify::GeodesicsDocument::Piece& piece : document.pieces) {
      Json& entry = result["pieces"].emplace_back(Json::object({{"genus", piece.genus}}));
      entry["boundaries"] = Json::array();
      for (const auto& [geodesic, side] : piece.boundaries) {
        entry["boundaries"].push_back(Json::object({{"geodesic", geodesic}, {"side", side == 0 ? "left" : "right"}}));
      }
    }
  }
  return result;
}

void list_geodesics(const GeodesicsRequest& request, const Find& find) {
  check_files({{"SURFACE", request.surface}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  const Surface surface = read_surface_input(request.surface);
  GeodesicsDocument document;
  {
    ProgressLine progress;
    GeodesicsOptions options{.epsilon = parse_epsilon(request.epsilon), .threads = request.threads};
    options.progress = progress.shower();
    document = find(surface, options);
    if (!request.no_certify) document = proved(std::move(document), options.threads, options.progress).document;
  }
  Report report = request.no_certify ? Report{"verdict: not certified (--no-certify): nothing is proved\n",
                                              Json::object({{"verdict", "not certified"}})}
                                     : verified_report();
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  // Of long lists each takes as much memory as the list or more.
  if (request.json) {
    report.json.update(geodesics_json(document));
  } else {
    report.text += geodesics_text(document);
  }
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

/// The options that these commands share.
void add_common(CLI::App& command, GeodesicsRequest& request) {
  add_input(command, "SURFACE", request.surface, kSurfaceHelp);
  add_file(command, "-o,--output", request.output,
           "the geodesics file to write, for certify; \"-\" is standard output");
  add_file(command, "--svg", request.svg,
           "also draw them, in the Dirichlet domain of a point of the first one; \"-\" is standard output");
  command
      .add_option("--epsilon", request.epsilon,
                  "the epsilon of the net from which the search starts: any value gives the same list, but a small one "
                  "takes long, and may leave the list undecided")
      ->option_text("E [1]");
  command.add_flag("--no-certify", request.no_certify, "do not check the list: nothing is proved");
  add_json(command, request.json);
  add_threads(command, request.threads);
}

}  // namespace

Report geodesics_report(const GeodesicsDocument& document) {
  return {geodesics_text(document), geodesics_json(document)};
}

void add_systole_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<GeodesicsRequest>();
  CLI::App* command =
      app.add_subcommand("systole", "The length of a shortest closed geodesic, enclosed and proved, and its word.");
  add_common(*command, *shared);
  command->footer("Example:\n  epsnet systole s.json\n  epsnet systole s.json -o systole.json && certify systole.json");
  command->callback([&chosen, shared] { chosen = [shared] { list_geodesics(*shared, unproved::systole); }; });
}

void add_spectrum_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<GeodesicsRequest>();
  CLI::App* command = app.add_subcommand(
      "spectrum",
      "All primitive closed geodesics up to a length: lengths, words, which are simple; the list is proved complete.");
  add_common(*command, *shared);
  command
      ->add_option("--up-to", shared->up_to,
                   "a length, a positive decimal or fraction; about e^L/(2L) geodesics, in time proportional to e^L")
      ->required()
      ->option_text("L REQUIRED");
  command->footer(
      "Example:\n  epsnet spectrum s.json --up-to 6\n  epsnet spectrum s.json --up-to 6 -o spectrum.json && certify "
      "spectrum.json");
  command->callback([&chosen, shared] {
    chosen = [shared] {
      const Length up_to = parse_length("--up-to", shared->up_to);
      list_geodesics(*shared, [&](const Surface& surface, const GeodesicsOptions& options) {
        return unproved::spectrum(surface, up_to, options);
      });
    };
  });
}

void add_thick_thin_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<GeodesicsRequest>();
  CLI::App* command =
      app.add_subcommand("thick-thin",
                         "The small curves, of length at most 2 arsinh 1, their collars, and the pieces "
                         "into which they cut the surface.");
  add_common(*command, *shared);
  command->footer("Example:\n  epsnet thick-thin s.json\n  epsnet thick-thin s.json -o thin.json && certify thin.json");
  command->callback([&chosen, shared] { chosen = [shared] { list_geodesics(*shared, unproved::thick_thin); }; });
}

void add_local_maximum_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<GeodesicsRequest>();
  CLI::App* command = app.add_subcommand(
      "local-maximum",
      "That the systole is greater than that of any other surface nearby, proved: for surfaces whose shortest closed "
      "geodesics are of exactly equal length, as no rounded coordinates make them.");
  add_common(*command, *shared);
  command->footer(
      "Example:\n  epsnet surface named klein -o s.json\n  epsnet local-maximum s.json -o maximum.json && certify "
      "maximum.json");
  command->callback([&chosen, shared] {
    chosen = [shared] {
      list_geodesics(*shared, [](const Surface& surface, const GeodesicsOptions& options) {
        try {
          return unproved::local_maximum(surface, options);
        } catch (const NotMaximalError& error) {
          throw UndecidedError(error.what());
        }
      });
    };
  });
}

// The command eigenvalues: the first eigenvalues of the Laplacian in intervals, with their proof.

namespace {

using certify::EigenvaluesDocument;

struct EigenvaluesRequest {
  std::string surface;
  std::uint32_t count = 0;
  std::optional<std::string> below;
  int digits = 0;
  std::optional<std::string> epsilon;
  std::optional<std::string> phases;
  std::optional<std::string> box;
  std::string output;
  std::string svg;
  bool json = false;
  unsigned threads = 0;
};

/// The index of the first eigenvalue of a document: without phases 0, of the constants, is left out.
std::uint64_t first_index(const EigenvaluesDocument& document) { return document.phases.empty() ? 1 : 0; }

std::string lambdas_text(std::uint64_t first, std::uint32_t count) {
  const std::string text = "lambda_" + std::to_string(first);
  return count == 1 ? text : text + " to lambda_" + std::to_string(first + count - 1);
}

/// Whether all other eigenvalues are outside of the interval of a row.
bool is_apart(const EigenvaluesDocument& document, std::size_t row) {
  const auto& rows = document.eigenvalues;
  const double next = row + 1 < rows.size() ? rows[row + 1].in.lower : document.next;
  return rows[row].in.upper < next && (row == 0 || rows[row - 1].in.upper < rows[row].in.lower);
}

std::string count_text(const EigenvalueCount& count) {
  if (!count.most) return count.least == 0 ? "not counted" : "at least " + std::to_string(count.least);
  if (count.least < *count.most) return "from " + std::to_string(count.least) + " to " + std::to_string(*count.most);
  return count.least == 0 ? "none" : std::to_string(count.least);
}

Json count_json(const EigenvalueCount& count) {
  Json result = Json::object({{"least", count.least}, {"most", nullptr}});
  if (count.most) result["most"] = *count.most;
  return result;
}

/// What is counted below a number.
std::string below_text(const EigenvaluesDocument& document, const std::string& bound) {
  return document.phases.empty() ? "eigenvalues in (0, " + bound + ")" : "eigenvalues less than " + bound;
}

std::string eigenvalues_text(const EigenvaluesDocument& document) {
  std::ostringstream out;
  if (!document.phases.empty()) {
    out << "phases of the sides, in turns:";
    for (const std::string& phase : document.phases) out << ' ' << phase;
    out << '\n';
  }
  if (document.box)
    out << "and all that are at most " << certify::in_quotes(document.box->radius) << " away in each of "
        << certify::counted(document.box->directions.size(), "direction", "directions") << '\n';
  std::uint64_t first = first_index(document);
  for (std::size_t row = 0; row < document.eigenvalues.size(); ++row) {
    const auto& [in, count] = document.eigenvalues[row];
    out << lambdas_text(first, count) << " in " << to_string(in);
    if (count > 1) out << ": " << count;
    if (count == 1 && is_apart(document, row)) out << ", simple";
    out << '\n';
    first += count;
  }
  out << "all " << (document.eigenvalues.empty() ? "" : "others ") << "are at least "
      << certify::shortest(document.next) << '\n'
      << below_text(document, "1/4") << ": " << count_text(eigenvalues_below(document, 0.25)) << '\n';
  return out.str();
}

Json eigenvalues_json(const EigenvaluesDocument& document) {
  Json result = Json::object();
  if (!document.phases.empty()) result["phases"] = document.phases;
  if (document.box) result["box"] = document.box->radius;
  result["eigenvalues"] = Json::array();
  std::uint64_t first = first_index(document);
  for (const auto& [in, count] : document.eigenvalues) {
    result["eigenvalues"].push_back(Json::object({{"first", first}, {"count", count}, {"in", interval_json(in)}}));
    first += count;
  }
  result["next"] = document.next;
  result["below_quarter"] = count_json(eigenvalues_below(document, 0.25));
  return result;
}

/// How many eigenvalues are less than the bound that was asked about.
Report below_report(const EigenvaluesDocument& document, double below) {
  const EigenvalueCount count = eigenvalues_below(document, below);
  Json json = count_json(count);
  json["bound"] = below;
  return {below_text(document, certify::shortest(below)) + ": " + count_text(count) + '\n',
          Json::object({{"below", std::move(json)}})};
}

EigenvaluesOptions options_of(const EigenvaluesRequest& request) {
  EigenvaluesOptions options{.threads = request.threads};
  if (request.count > 0) options.count = request.count;
  if (request.below) options.below = parse_eigenvalue("--below", *request.below);
  if (request.digits > 0) options.digits = request.digits;
  if (request.epsilon) options.epsilon = parse_epsilon(*request.epsilon);
  if (!request.phases) return options;
  options.phases = parse_torus_point("--phases", *request.phases);
  if (request.box) options.box = parse_turn_distance("--box", *request.box);
  if (request.digits > 3) throw UsageError("--digits: at most 3 with --phases, not " + std::to_string(request.digits));
  return options;
}

void find_eigenvalues(const EigenvaluesRequest& request) {
  check_files({{"SURFACE", request.surface}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  EigenvaluesOptions options = options_of(request);
  const Surface surface = read_surface_input(request.surface);
  EigenvaluesDocument document;
  {
    ProgressLine progress;
    options.progress = progress.shower();
    document = eigenvalues(surface, options).document;
  }
  const std::string svg = request.svg.empty() ? "" : draw_svg(picture_of(document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  Report report = verified_report();
  const auto add = [&](const Report& more) {
    report.text += more.text;
    report.json.update(more.json);
  };
  add(eigenvalues_report(document));
  if (options.below) add(below_report(document, *options.below));
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

Report eigenvalues_report(const EigenvaluesDocument& document) {
  return {eigenvalues_text(document), eigenvalues_json(document)};
}

void add_eigenvalues_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<EigenvaluesRequest>();
  CLI::App* command = app.add_subcommand("eigenvalues",
                                         "The first eigenvalues of the Laplacian, with multiplicity, in proved "
                                         "intervals, and from where on all others are.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  CLI::Option* count = command
                           ->add_option("--count", shared->count,
                                        "the first so many, at most 1000, and those that cannot be told apart from the "
                                        "last one")
                           ->transform(integer_between(1, 1000))
                           ->option_text("N [10]");
  command
      ->add_option(
          "--below", shared->below,
          "instead: all eigenvalues less than this number, at most 10000, and how many there are; nothing more "
          "precise than their number needs, unless --digits is given")
      ->option_text("X")
      ->excludes(count);
  command
      ->add_option("--digits", shared->digits,
                   "about so many digits of each eigenvalue, from 1 to 10. Up to 2 take much less time, and more find "
                   "eigenfunctions, which epsnet draw shows [9; none with --below]")
      ->transform(integer_between(1, 10))
      ->option_text("D");
  command->add_option("--epsilon", shared->epsilon, "of the net on which they are counted; by default at most 0.6")
      ->option_text("E");
  CLI::Option* phases =
      command
          ->add_option(
              "--phases", shared->phases,
              "of functions f on the plane with f(gz) = c(g)f(z): the phases of c, 2g numbers of turns with commas "
              "between them, such as 0,1/3,0.25,-1/2, those of the sides that epsnet bands --help says; from "
              "lambda_0 on, with up to 3 digits, 2 by default")
          ->option_text("T,...");
  command
      ->add_option("--box", shared->box,
                   "intervals that hold for all phases at most so many turns from these, each of the 2g")
      ->option_text("R")
      ->needs(phases);
  add_file(*command, "-o,--output", shared->output,
           "the eigenvalues file to write, for certify; \"-\" is standard output");
  add_file(*command, "--svg", shared->svg,
           "also draw the intervals, and how many eigenvalues are below each place; \"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Example:\n  epsnet eigenvalues s.json\n"
      "  epsnet eigenvalues s.json --count 30 --digits 6 -o e.json && certify e.json\n"
      "  epsnet eigenvalues s.json --below 0.25\n"
      "  epsnet eigenvalues s.json --count 4 --phases 0,1/3,0,1/2\n"
      "  epsnet draw e.json --eigenfunction 3 -o e3.svg");
  command->callback([&chosen, shared] { chosen = [shared] { find_eigenvalues(*shared); }; });
}

}  // namespace epsnet::program
