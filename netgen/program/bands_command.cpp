#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/file/file.h"
#include "netgen/base/progress_line.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "netgen/surfaces/group.h"

/// The commands bands, gap and lattice: eigenvalues with phases, of functions on the plane along a path through the
/// torus of characters, each point with its proof; a lower bound away from 0, by boxes; and of functions at the nodes
/// of a graph.

namespace epsnet::program {
namespace {

constexpr std::uint32_t kMostPoints = 10'000;
constexpr const char* kPhaseLines = "points, expected the phases of one on each line, as in 0 1/3 0.25 -1/2";

struct BandsRequest {
  std::string surface;
  std::string between;
  std::uint32_t steps = 10;
  std::string path;
  std::uint32_t count = 4;
  int digits = 0;
  std::optional<std::string> epsilon;
  std::string output;
  std::string svg;
  std::string keep;
  bool json = false;
  unsigned threads = 0;
};

/// The texts between separators, without empty ones.
std::vector<std::string> parts_of(const std::string& text, const char* separators) {
  std::vector<std::string> result;
  for (std::size_t begin = text.find_first_not_of(separators); begin != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    result.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return result;
}

/// The points of a path, and names of some of them.
struct TorusPath {
  std::vector<TorusPoint> points;
  std::vector<BandsPicture::Mark> marks;
};

TorusPath path_of(const BandsRequest& request, const Surface& surface) {
  TorusPath result;
  if (!request.path.empty()) {
    for (const LineText& line : read_lines(request.path, kPhaseLines)) {
      try {
        result.points.push_back(parse_torus_point(line.name, line.text));
      } catch (const UsageError& error) {
        throw JobError(error.what());
      }
    }
  } else {
    std::vector<TorusPoint> corners;
    for (const std::string& text : parts_of(request.between, ",")) {
      const std::size_t step = corners.size() * request.steps;
      if (text == "G") {
        corners.emplace_back(2 * surface.genus(), Rational(0));
        result.marks.push_back({step, "\u0393"});
      } else {
        corners.push_back(parse_torus_point("--between", text));
        result.marks.push_back({step, text});
      }
    }
    if (corners.empty()) throw UsageError("--between: expected points with commas between them, as in G,1/2:0:0:0");
    for (const TorusPoint& corner : corners) {
      if (corner.size() == 2 * std::size_t{surface.genus()}) continue;
      throw JobError("--between: expected " + std::to_string(2 * surface.genus()) + " phases for each point, not " +
                     std::to_string(corner.size()));
    }
    result.points = torus_path(corners, request.steps);
  }
  if (result.points.size() > kMostPoints)
    throw JobError("the path has more than " + std::to_string(kMostPoints) + " points");
  return result;
}

std::string bands_csv(const std::vector<TorusPoint>& points, const std::vector<std::vector<certify::Interval>>& bands) {
  std::ostringstream out;
  out << "step";
  for (std::size_t j = 0; j < points.front().size(); ++j) out << ",phase_" << j;
  out << ",band,lo,hi\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::string phases;
    for (const Rational& phase : points[i]) phases += ',' + phase.str();
    for (std::size_t band = 0; band < bands[i].size(); ++band) {
      const auto [lower, upper] = bands[i][band];
      out << i << phases << ',' << band << ',' << certify::shortest(lower) << ',' << certify::shortest(upper) << '\n';
    }
  }
  return out.str();
}

Json bands_json(const std::vector<TorusPoint>& points, const std::vector<std::vector<certify::Interval>>& bands) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    Json row = Json::object({{"phases", Json::array()}, {"bands", Json::array()}});
    for (const Rational& phase : points[i]) row["phases"].push_back(phase.str());
    for (const certify::Interval& in : bands[i]) row["bands"].push_back(interval_json(in));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string bands_text(const std::vector<TorusPoint>& points,
                       const std::vector<std::vector<certify::Interval>>& bands) {
  std::ostringstream out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    out << i << ": phases";
    for (const Rational& phase : points[i]) out << ' ' << phase.str();
    for (std::size_t band = 0; band < bands[i].size(); ++band)
      out << ", lambda_" << band << " in " << to_string(bands[i][band]);
    out << '\n';
  }
  return out.str();
}

/// What adds each document to the files to be written, into a folder.
std::function<void(std::size_t, const certify::EigenvaluesDocument&)> keeper(const std::string& folder,
                                                                             const std::string& name,
                                                                             std::vector<NewFile>& files) {
  if (!std::filesystem::is_directory(folder)) throw JobError("--keep: there is no folder " + folder);
  return [=, &files](std::size_t i, const certify::EigenvaluesDocument& document) {
    std::ostringstream text;
    certify::write_file(document, text);
    files.push_back({std::filesystem::path(folder) / (name + std::to_string(i) + ".json"),
                     [text = std::move(text).str()](std::ostream& out) { out << text; }});
  };
}

void find_bands(const BandsRequest& request) {
  check_files({{"SURFACE", request.surface}, {"--path", request.path}},
              {{"--output", request.output, FileType::text}, {"--svg", request.svg, FileType::svg}});
  if (request.between.empty() == request.path.empty())
    throw UsageError("which points? Either --between or --path is needed");
  const Surface surface = read_surface_input(request.surface);
  const TorusPath path = path_of(request, surface);
  BandsOptions options{.count = request.count, .threads = request.threads};
  if (request.digits > 0) options.digits = request.digits;
  if (request.epsilon) options.epsilon = parse_epsilon(*request.epsilon);
  std::vector<NewFile> files;
  if (!request.keep.empty()) options.each = keeper(request.keep, "point-", files);
  std::vector<std::vector<certify::Interval>> found;
  {
    ProgressLine progress;
    options.progress = progress.shower();
    found = bands(surface, path.points, options);
  }
  const auto add = [&](const std::string& file, std::string text) {
    files.push_back({file, [text = std::move(text)](std::ostream& out) { out << text; }});
  };
  if (!request.output.empty()) add(request.output, bands_csv(path.points, found));
  if (!request.svg.empty()) add(request.svg, draw_svg(BandsPicture{found, path.marks}));
  write_outputs(std::move(files));
  Report report = verified_report();
  report.text += bands_text(path.points, found);
  report.json["points"] = bands_json(path.points, found);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

TorusPoint parse_torus_point(const std::string& name, const std::string& text) {
  TorusPoint result;
  try {
    for (const std::string& part : parts_of(text, " \t,:")) result.push_back(parse_turns(with_leading_zero(part)));
  } catch (const CharacterError& error) {
    throw UsageError(name + ": " + error.what());
  }
  if (result.empty()) throw UsageError(name + ": expected phases in turns, as in 0,1/3,0.25,-1/2");
  return result;
}

Rational parse_turn_distance(const std::string& name, const std::string& text) {
  const TorusPoint numbers = parse_torus_point(name, text);
  if (numbers.size() == 1 && numbers[0] > 0 && numbers[0] <= Rational(1, 2)) return numbers[0];
  throw UsageError(name + ": expected one number of turns, more than 0 and at most 1/2, not " +
                   certify::in_quotes(text));
}

double parse_eigenvalue(const std::string& name, const std::string& text) {
  constexpr double kGreatest = 10'000;
  const std::optional<double> value = certify::parse_binary64(with_leading_zero(text));
  if (value && *value > 0 && *value <= kGreatest) return *value;
  throw UsageError(name + ": expected a positive decimal of at most 10000, not " + certify::in_quotes(text));
}

void add_bands_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<BandsRequest>();
  CLI::App* command = app.add_subcommand("bands",
                                         "The first eigenvalues with phases, lambda_0 and so on, in proved intervals "
                                         "at points of a path through the torus "
                                         "of characters: hyperbolic bands.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  CLI::Option* between =
      command
          ->add_option(
              "--between", shared->between,
              "the corners of the path, with commas between them: each 2g numbers of turns with colons between "
              "them, or G, where all are 0; as in G,1/2:0:0:0,G")
          ->option_text("A,B,...");
  CLI::Option* steps = command->add_option("--steps", shared->steps, "so many between two corners, at most 10000")
                           ->transform(integer_between(1, 10'000))
                           ->option_text("N [10]");
  add_file(*command, "--path", shared->path,
           "instead: a file with the 2g numbers of a point on each line; \"#\" begins a comment")
      ->excludes(between)
      ->excludes(steps);
  command->add_option("--count", shared->count, "so many bands, at most 1000")
      ->transform(integer_between(1, 1000))
      ->option_text("N [4]");
  command->add_option("--digits", shared->digits, "about so many digits of each eigenvalue, from 1 to 3")
      ->transform(integer_between(1, 3))
      ->option_text("D [2]");
  command->add_option("--epsilon", shared->epsilon, "of the net; by default it is chosen")->option_text("E");
  add_file(*command, "-o,--output", shared->output,
           "a table to write, .csv: step, phases, band, and the ends of the interval; \"-\" is standard output");
  add_file(*command, "--svg", shared->svg, "also draw the bands; \"-\" is standard output");
  command
      ->add_option("--keep", shared->keep,
                   "write the eigenvalues file of each point into this folder, which exists, for certify")
      ->option_text("FOLDER");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "The 2g numbers are the phases of the first sides of the pairs of the fundamental polygon, in the order of "
      "epsnet "
      "surface cover --permutations; if its corners are several vertices of the surface, without the pairs of a "
      "spanning "
      "tree. An error for another number of phases lists the sides.\n\n"
      "Example:\n  epsnet surface regular --genus 2 -o s.json\n"
      "  epsnet bands s.json --between G,1/2:0:0:0,1/2:1/2:1/2:1/2,G --steps 10 -o bands.csv --svg bands.svg\n"
      "  mkdir files && epsnet bands s.json --path points.txt --count 8 --keep files\n"
      "  certify files/point-0.json");
  command->callback([&chosen, shared] { chosen = [shared] { find_bands(*shared); }; });
}

namespace {

struct GapRequest {
  std::string surface;
  std::string outside;
  std::string at_least;
  std::size_t most = GapOptions().most;
  std::optional<std::string> epsilon;
  std::string keep;
  bool json = false;
  unsigned threads = 0;
};

void find_gap(const GapRequest& request) {
  check_files({{"SURFACE", request.surface}}, {});
  const Rational radius = parse_turn_distance("--outside", request.outside);
  if (radius == Rational(1, 2)) throw UsageError("--outside: no phase is farther than 1/2 from an integer");
  const double bound = parse_eigenvalue("--at-least", request.at_least);
  const Surface surface = read_surface_input(request.surface);
  GapOptions options{.most = request.most, .threads = request.threads};
  if (request.epsilon) options.epsilon = parse_epsilon(*request.epsilon);
  std::vector<NewFile> files;
  if (!request.keep.empty()) {
    constexpr std::size_t kMostFiles = 100'000;  // They are written together, at the end.
    options.most = std::min(options.most, kMostFiles);
    options.each = keeper(request.keep, "box-", files);
  }
  std::size_t boxes = 0;
  {
    ProgressLine progress;
    options.progress = progress.shower();
    boxes = gap_outside(surface, radius, bound, options);
  }
  write_outputs(std::move(files));
  Report report = verified_report();
  report.text += "lambda_0 is at least " + certify::shortest(bound) +
                 " for all phases but those that are all at most " + radius.str() + " from an integer\n" +
                 std::to_string(boxes) +
                 " boxes of phases cover half of the torus of characters, the others are inverse\n";
  report.json["outside"] = radius.str();
  report.json["at_least"] = bound;
  report.json["boxes"] = boxes;
  write_report(report, request.json, false);
}

}  // namespace

void add_gap_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<GapRequest>();
  CLI::App* command = app.add_subcommand("gap",
                                         "That lambda_0 with phases is at least a number, wherever one of the phases "
                                         "is far from 0: by boxes of phases, each proved.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  command
      ->add_option("--outside", shared->outside, "wherever one of the 2g phases is farther than that from an integer")
      ->option_text("R")
      ->required();
  command->add_option("--at-least", shared->at_least, "lambda_0 is at least that")->option_text("X")->required();
  command->add_option("--most", shared->most, "with no more boxes than that")
      ->transform(integer_between(1, 100'000'000))
      ->option_text("N [" + std::to_string(shared->most) + "]");
  command->add_option("--epsilon", shared->epsilon, "of the net [0.4]")->option_text("E");
  command
      ->add_option("--keep", shared->keep,
                   "write the eigenvalues file of each box into this folder, which exists, for certify; at most 100000")
      ->option_text("FOLDER");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "The phases are those of epsnet bands --help. The number of boxes grows as a power 2g of how near X is to the "
      "least value. That the boxes cover the torus is the program's own count; certify verifies each of them.\n\n"
      "Example:\n  epsnet surface regular --genus 2 -o s.json\n"
      "  epsnet gap s.json --outside 1/4 --at-least 0.001");
  command->callback([&chosen, shared] { chosen = [shared] { find_gap(*shared); }; });
}

namespace {

struct LatticeRequest {
  std::string surface;
  GraphNodes nodes = GraphNodes::vertices;
  std::optional<std::string> phases;
  std::string output;
  bool json = false;
};

/// Of a lattice of which only the matrix is wanted, if it is that large.
Report lattice_report(const HermitianMatrix& matrix, bool only_matrix) {
  Report report;
  std::ostringstream out;
  out << "nodes: " << matrix.size << '\n';
  if (only_matrix) {
    report.text =
        out.str() + "eigenvalues: left out, as there are more than " + std::to_string(kMostLatticeNodes) + " nodes\n";
    report.json = {{"nodes", matrix.size}};
    return report;
  }
  const std::vector<certify::Interval> found = eigenvalues(matrix);
  Json rows = Json::array();
  for (std::size_t first = 0, next = 0; first < found.size(); first = next) {
    while (next < found.size() && found[next] == found[first]) ++next;
    out << next - first << (next - first == 1 ? " eigenvalue in " : " eigenvalues in ") << to_string(found[first])
        << '\n';
    rows.push_back({{"in", interval_json(found[first])}, {"count", next - first}});
  }
  report.text = out.str();
  report.json = {{"nodes", matrix.size}, {"eigenvalues", std::move(rows)}};
  return report;
}

void find_lattice(const LatticeRequest& request) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, FileType::mtx}});
  const Surface surface = read_surface_input(request.surface);
  std::vector<Rational> turns;
  if (request.phases) turns = parse_torus_point("--phases", *request.phases);
  const HermitianMatrix matrix = lattice_matrix(surface, request.nodes, turns);
  const Report report = [&] {
    const ProgressLine progress("eigenvalues of the matrix");
    return lattice_report(matrix, !request.output.empty() && matrix.size > kMostLatticeNodes);
  }();
  write_output(request.output, [&](std::ostream& out) { write_matrix_market(matrix, out); });
  write_report(report, request.json, is_stdout(request.output));
}

}  // namespace

void add_lattice_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<LatticeRequest>();
  CLI::App* command = app.add_subcommand(
      "lattice",
      "The graph of the tiles of a surface as a matrix, with phases a Hermitian one, and all of its eigenvalues in "
      "intervals that epsnet proves: hyperbolic lattices.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  command
      ->add_option(
          "--nodes", shared->nodes,
          "vertices of the tiles, joined by sides; or faces, the tiles, joined where they have a side in common")
      ->transform(one_of<GraphNodes>({{"vertices", GraphNodes::vertices}, {"faces", GraphNodes::faces}}))
      ->option_text("vertices|faces [vertices]");
  command
      ->add_option("--phases", shared->phases,
                   "of functions f with f(gz) = c(g)f(z): the phases of c, 2g numbers of turns with commas between "
                   "them, as for epsnet bands")
      ->option_text("T,...");
  add_file(*command, "-o,--output", shared->output,
           "also write the matrix, for MatrixMarket (.mtx); \"-\" is standard output");
  add_json(*command, shared->json);
  add_progress(*command);
  command->footer(
      "The matrix takes f to the sum of f over the neighbours of each node; a loop counts twice. Beyond 1500 nodes "
      "only the matrix is written. "
      "The proof is the program's own; no file has it.\n\n"
      "Example:\n  epsnet surface named klein -o klein.json && epsnet lattice klein.json\n"
      "  epsnet surface regular --genus 2 -o s.json\n"
      "  epsnet lattice s.json --nodes faces --phases 0,1/3,0,1/2 -o matrix.mtx");
  command->callback([&chosen, shared] { chosen = [shared] { find_lattice(*shared); }; });
}

}  // namespace epsnet::program
