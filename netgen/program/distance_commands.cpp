#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <sys/sysinfo.h>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/check.h"
#include "certify/file/writer.h"
#include "netgen/base/gmp.h"
#include "netgen/base/progress_line.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/atlas.h"

namespace epsnet::program {
namespace {

struct DistanceRequest {
  std::string surface;
  std::string p;
  std::string q;
  std::string output;
  std::string svg;
  std::string width = "1e-12";
  bool json = false;
};

void measure_distance(const DistanceRequest& request) {
  check_files({{"SURFACE", request.surface}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  const Length width = parse_length("--width", request.width);
  const SurfaceOrNet input = read_surface_or_net(request.surface);
  const BasePoint p = parse_point("P", request.p, input);
  const BasePoint q = parse_point("Q", request.q, input);
  const certify::DistanceDocument document =
      distance(input.surface, p, q, {.width = static_cast<double>(width.value())}).document;
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  Report report = verified_report();
  const Report found = distance_report(document);
  report.text += found.text;
  report.json.update(found.json);
  report.json["p"] = point_json(p);
  report.json["q"] = point_json(q);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

Report distance_report(const certify::DistanceDocument& document) {
  Report report{"distance: " + to_string(document.distance) + '\n',
                Json::object({{"distance", interval_json(document.distance)}, {"equal", document.equal}})};
  report.text += "paths: " + std::to_string(document.paths.size());
  if (document.paths.size() > 1) {
    report.text += document.equal ? ", all the shortest ones, of exactly equal length"
                                  : ", all of length at most " + certify::decimal_below(document.distance.upper);
  }
  report.text += '\n';
  report.json["paths"] = Json::array();
  for (const std::vector<std::uint32_t>& word : document.paths) {
    report.text += "word:";
    for (const std::uint32_t side : word) report.text.append(" ").append(std::to_string(side));
    report.text += '\n';
    report.json["paths"].push_back(word);
  }
  return report;
}

void add_distance_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DistanceRequest>();
  DistanceRequest& request = *shared;
  CLI::App* command = app.add_subcommand(
      "distance",
      "The distance between two points of a surface, enclosed and proved, and all shortest geodesics between them.");
  add_input(*command, "SURFACE", request.surface, kSurfaceHelp);
  add_point(*command, "P", request.p, kPointHelp);
  add_point(*command, "Q", request.q, "the other point");
  add_file(*command, "-o,--output", request.output,
           "the distance file to write, for certify; \"-\" is standard output");
  add_file(*command, "--svg", request.svg,
           "also draw the paths, in the Dirichlet domain of P; \"-\" is standard output");
  command
      ->add_option("--width", request.width,
                   "the largest width of the enclosure, which is as narrow as binary64 allows; an error if it is wider")
      ->option_text("W [1e-12]");
  add_json(*command, request.json);
  command->footer(
      "Example:\n  epsnet distance s.json 0,0.1,-1/3 1,0,0\n  epsnet distance net.json v0 v17 -o d.json && certify "
      "d.json");
  command->callback([&chosen, shared] { chosen = [shared] { measure_distance(*shared); }; });
}

namespace {

struct DistancesRequest {
  std::string net;
  std::string output;
  std::string from = "all";
  std::string to = "all";
  bool bounds = false;
  bool json = false;
  unsigned threads = 0;
};

/// Returns the vertices that "all", or a text such as "v0,v5-v9", names, in that order.
std::vector<std::uint32_t> parse_vertices(const std::string& option, const std::string& text,
                                          const certify::NetDocument& net) {
  const std::size_t count = net.vertices.size();
  std::vector<std::uint32_t> result;
  if (text == "all") {
    result.resize(count);
    std::iota(result.begin(), result.end(), 0U);
    return result;
  }
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    const std::size_t dash = item.find('-');
    const auto first = number_after('v', item.substr(0, dash));
    const auto last = dash == std::string::npos ? first : number_after('v', item.substr(dash + 1));
    if (!first || !last || *last < *first) {
      throw UsageError(option + ": expected all, or vertices such as v0,v5,v10-v19, not \"" + text.substr(0, 80) +
                       "\"");
    }
    if (*last >= count) {
      throw JobError(option + ": vertex " + std::to_string(*last) + " does not exist, the net has " +
                     std::to_string(count));
    }
    for (std::uint32_t v = *first; v <= *last; ++v) result.push_back(v);
    begin = end + 1;
  }
  return result;
}

FileType table_type(const std::string& path) {
  if (is_stdout(path) || path.ends_with(".csv")) return FileType::text;
  if (path.ends_with(".npy")) return FileType::npy;
  throw UsageError("--output: " + path + ": a table is .npy or .csv");
}

std::string gigabytes(double bytes) {
  std::ostringstream out;
  out.precision(3);
  out << bytes / 1e9 << " GB";
  return out.str();
}

/// Throws JobError if the table is larger than the machine's memory. Called before the work, not after it.
void require_memory(std::size_t rows, std::size_t columns) {
  struct sysinfo machine = {};
  if (sysinfo(&machine) != 0) return;
  const double memory = static_cast<double>(machine.totalram) * machine.mem_unit;
  const double needed = distance_table_bytes(rows, columns);
  if (needed <= 0.8 * memory) return;
  throw JobError(std::to_string(rows) + " x " + std::to_string(columns) + " distances take " + gigabytes(needed) +
                 ", the machine has " + gigabytes(memory) + "; take a part of them with --from, such as v0-v999");
}

/// Throws JobError unless the triangles are proved to triangulate the surface.
certify::Certificate triangulation_certificate(const DistancesRequest& request, const certify::NetDocument& net) {
  ProgressLine progress;
  certify::CheckOptions options;
  options.threads = request.threads;
  options.progress = progress.shower("certificate: ");
  certify::Certificate certificate = certify::check(net, options);
  for (const char* rule : {"surface", "map", "gluing", "orientation"}) {
    const bool holds =
        std::any_of(certificate.rules.begin(), certificate.rules.end(), [&](const certify::RuleReport& report) {
          return report.rule == rule && report.verdict == certify::Verdict::verified;
        });
    if (!holds) {
      throw JobError(request.net + ": its triangles are not proved to triangulate the surface: " +
                     certify::verdict_line(certificate));
    }
  }
  return certificate;
}

void tabulate(const DistancesRequest& request) {
  const FileType type = table_type(request.output);
  check_files({{"NET", request.net}}, {{"--output", request.output, type}});
  const certify::NetDocument net = read_net_input(request.net);
  const std::vector<std::uint32_t> from = parse_vertices("--from", request.from, net);
  const std::vector<std::uint32_t> to = parse_vertices("--to", request.to, net);
  require_memory(from.size(), to.size());
  const certify::Certificate certificate = triangulation_certificate(request, net);
  DistanceTable table;
  try {
    ProgressLine progress;
    table = vertex_distances(net, from, to, {.threads = request.threads, .progress = progress.shower()});
  } catch (const NetGeometryError& error) {
    throw JobError(request.net + ": " + error.what());
  }
  const TableEntries entries = request.bounds ? TableEntries::bounds : TableEntries::distances;
  write_output(request.output, [&](std::ostream& out) {
    type == FileType::npy ? write_npy(table, entries, out) : write_csv(table, entries, out);
  });
  double greatest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t k = 0; k < to.size(); ++k) greatest = std::max(greatest, table.distance(i, k));
  }
  const double error = table.error();
  std::ostringstream text;
  text << "net: " << certify::verdict_line(certificate) << '\n'
       << "distances: " << from.size() << " x " << to.size() << '\n'
       << "greatest: " << greatest << '\n'
       << "error: at most " << certify::decimal_above(error, 3) << '\n';
  write_report({text.str(), Json::object({{"net", certify::verdict_line(certificate)},
                                          {"rows", from.size()},
                                          {"columns", to.size()},
                                          {"greatest", greatest},
                                          {"error", upper_bound_json(error)}})},
               request.json, is_stdout(request.output));
}

}  // namespace

void add_distances_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<DistancesRequest>();
  DistancesRequest& request = *shared;
  CLI::App* command =
      app.add_subcommand("distances", "A table of the distances between many vertices of a net, rounded or in bounds.");
  add_input(*command, "NET", request.net, "a net file; first its triangles are proved to triangulate the surface");
  add_file(*command, "-o,--output", request.output,
           "the table to write: .npy, an array of NumPy with a row for each vertex of --from and a column for each of "
           "--to; .csv, lines of two vertices and their distance; \"-\" is standard output, .csv")
      ->required()
      ->option_text("FILE REQUIRED");
  constexpr const char* kVertices = "v0,v5-v9|all [all]";
  command->add_option("--from", request.from, "the vertices of the rows")->option_text(kVertices);
  command->add_option("--to", request.to, "the vertices of the columns")->option_text(kVertices);
  command->add_flag("--bounds", request.bounds, "write two numbers that enclose each distance instead of one near it");
  add_json(*command, request.json);
  add_threads(*command, request.threads);
  command->footer(
      "The report gives a bound for the errors of the numbers, some 1e-13. That bound is proved on paper "
      "(docs/distances.md); 'epsnet distance' makes a certificate for one pair. The table takes one search of the net "
      "for each vertex of --from.\n\n"
      "Example:\n"
      "  epsnet distances net.json -o d.npy\n"
      "  epsnet distances net.json --from v0,v17 --bounds -o d.csv");
  command->callback([&chosen, shared] { chosen = [shared] { tabulate(*shared); }; });
}

namespace {

struct LocateRequest {
  std::string net;
  std::vector<std::string> points;
  std::string file;
  bool json = false;
};

/// Returns the points of the command line and of the file, with their names in messages.
std::vector<LineText> points_of(const LocateRequest& request) {
  std::vector<LineText> points;
  for (const std::string& text : request.points) points.push_back({"P", text});
  if (!request.file.empty()) {
    for (LineText& point : read_lines(request.file, kPointLines)) points.push_back(std::move(point));
  }
  return points;
}

Report location_report(const std::string& point, const PointLocation& location, const certify::NetDocument& net) {
  const certify::NetDocument::Triangle& triangle = net.triangles[location.triangle];
  const std::uint32_t nearest = location.nearest_corner();
  std::ostringstream text;
  text << point << ": triangle " << location.triangle;
  std::string place = "inside";
  if (location.place == PointLocation::Place::side) {
    place = "side";
    text << ", on side " << location.number << ", which is also of triangle " << triangle.opposite[location.number] / 3;
  } else if (location.place == PointLocation::Place::corner) {
    place = "corner";
    text << ", at corner " << location.number;
  }
  text << ", nearest corner v" << triangle.vertex[nearest] << " at " << location.distances[nearest] << '\n';
  text << "weights:";
  for (const double weight : location.weights) text << ' ' << weight;
  text << "\nword:";
  for (const SideId side : location.word) text << ' ' << side.number();
  text << '\n';
  return {text.str(), Json::object({{"point", point},
                                    {"triangle", location.triangle},
                                    {"place", place},
                                    {"number", location.number},
                                    {"vertices", triangle.vertex},
                                    {"weights", location.weights},
                                    {"distances", location.distances},
                                    {"word", location.word}})};
}

void locate_points(const LocateRequest& request) {
  if (request.points.empty() && request.file.empty()) throw UsageError("locate: expected a point P, or --points FILE");
  check_files({{"NET", request.net}, {"--points", request.file}}, {});
  const certify::NetDocument net = read_net_input(request.net);
  const SurfaceOrNet input{from_document(net.surface), net};
  const std::vector<LineText> points = points_of(request);
  Locator locator(net);
  Report report;
  report.json["points"] = Json::array();
  for (const LineText& point : points) {
    Report found = [&] {
      try {
        return location_report(point.text, locator.locate(parse_point(point.name, point.text, input)), net);
      } catch (const UsageError& error) {
        if (point.name == "P") throw;
        throw JobError(error.what());  // The point is in a file, so this is not a usage error.
      }
    }();
    report.text += found.text;
    report.json["points"].push_back(std::move(found.json));
  }
  write_report(report, request.json, false);
}

}  // namespace

void add_locate_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<LocateRequest>();
  LocateRequest& request = *shared;
  CLI::App* command =
      app.add_subcommand("locate", "Find the triangles of a net that contain given points of its surface.");
  add_input(*command, "NET", request.net, "a net file");
  command->add_option("P", request.points, kPointHelp)->option_text("T[,X,Y]|vN|tN:A,B,C ...");
  add_file(*command, "--points", request.file,
           "also the points of this file, one per line; # begins a comment; \"-\" is standard input");
  add_json(*command, request.json);
  command->footer(
      "For each point: a triangle that contains it, and whether it is on a side or a corner, decided exactly; "
      "its weights on the corners, as tN:A,B,C takes them; the nearest corner, rounded; and the lift: the sides "
      "that a path crosses from the tile of the point to that of the triangle's chart.\n\n"
      "Example:\n"
      "  epsnet locate net.json 0,0.1,-1/3 v17 t12:1,1,1\n"
      "  epsnet locate net.json --points points.txt --json");
  command->callback([&chosen, shared] { chosen = [shared] { locate_points(*shared); }; });
}

}  // namespace epsnet::program
