#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <sys/sysinfo.h>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/check.h"
#include "certify/file/file.h"
#include "netgen/base/gmp.h"
#include "netgen/base/progress_line.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "netgen/prove/certified.h"
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
  const certify::DistanceDocument document = [&] {
    const ProgressLine progress("distance");
    return distance(input.surface, p, q, {.width = static_cast<double>(width.value())}).document;
  }();
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
  add_progress(*command);
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
  options.progress = progress.shower("certificate: rule ");
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
  Locator locator = [&] {
    const ProgressLine progress("laying out the net");
    return Locator(net);
  }();
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
  add_progress(*command);
  command->footer(
      "For each point: a triangle that contains it, and whether it is on a side or a corner, decided exactly; "
      "its weights on the corners, as tN:A,B,C takes them; the nearest corner, rounded; and the lift: the sides "
      "that a path crosses from the tile of the point to that of the triangle's chart.\n\n"
      "Example:\n"
      "  epsnet locate net.json 0,0.1,-1/3 v17 t12:1,1,1\n"
      "  epsnet locate net.json --points points.txt --json");
  command->callback([&chosen, shared] { chosen = [shared] { locate_points(*shared); }; });
}

namespace {

struct BoundRequest {
  std::string surface;
  std::string output;
  std::string ends;
  std::string svg;
  std::string width;
  unsigned threads = 0;
  bool json = false;
};

/// Where a bound is attained: a point, and the points that are farthest from it, if they are of interest and can be
/// had. The distance of the first of them is proved.
struct Where {
  BasePoint p;
  std::vector<BasePoint> farthest = {};
  std::optional<certify::DistanceDocument> distance = std::nullopt;
};

/// The vertex of a net of one vertex, which is certified, and the points farthest from it. Says on standard error if
/// they cannot be had.
Where where(const certify::NetDocument& net, bool with_farthest) {
  const Surface surface = from_document(net.surface);
  Where result{point_of_vertex(surface, net, 0)};
  if (!with_farthest) return result;
  try {
    const ProgressLine progress("points farthest from p");
    const DirichletPolygon domain = dirichlet_polygon(surface, result.p);
    result.farthest = farthest_points(surface, domain);
    result.distance = distance(surface, result.p, domain, result.farthest.front()).document;
  } catch (const NotCertifiedError& error) {
    write_left_out({std::string("the distance of p and q: ") + error.what()});
  } catch (const Error& error) {
    write_left_out({std::string("the points farthest from p: ") + error.what()});
  }
  return result;
}

/// In JSON p is exact and q is rounded to multiples of 2⁻¹⁰⁰; everything else is an interval.
void add_where(Report& report, const Where& where) {
  report.text += "p: " + point_text(where.p) + '\n';
  report.json["p"] = point_json(where.p);
  if (where.farthest.empty()) return;
  report.json["q"] = Json::array();
  for (const BasePoint& q : where.farthest) {
    report.text += "q: " + point_text(q) + '\n';
    report.json["q"].push_back(point_json(q));
  }
  if (!where.distance) return;
  report.text += "distance of p and q: " + to_string(where.distance->distance) + '\n';
  report.json["distance_of_p_and_q"] = interval_json(where.distance->distance);
}

/// The option for a distance file from p to the first q.
void add_ends(CLI::App& command, std::string& ends) {
  add_file(command, "--ends", ends,
           "also write the distance file of p, where the bound is attained, and q, a point farthest from it, for "
           "certify; \"-\" is standard output");
}

/// The file of --ends; throws JobError if there is none although it was asked for.
NewFile ends_file(const std::string& path, const Where& where) {
  if (!path.empty() && !where.distance)
    throw JobError("--ends: the distance of p and q is not proved; nothing was written");
  return {path, [&where](std::ostream& out) { certify::write_file(*where.distance, out); }};
}

using MakeBound = Certified<certify::BoundDocument> (*)(const Surface&, const BoundOptions&);

void enclose(const BoundRequest& request, MakeBound make) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, FileType::json},
                                               {"--ends", request.ends, FileType::json},
                                               {"--svg", request.svg, FileType::svg}});
  const auto width = static_cast<double>(parse_length("--width", request.width).value());
  if (!(width >= kLeastBoundWidth)) throw UsageError("--width: less than the least width, 1e-12");
  const Surface surface = read_surface_input(request.surface);
  certify::BoundDocument document;
  {
    ProgressLine progress;
    BoundOptions options;
    options.width = width;
    options.threads = request.threads;
    options.progress = progress.shower();
    document = make(surface, options).document;
  }
  const Where found = where(document.net, document.claim != certify::BoundDocument::Claim::embedded_disk);
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }},
                 ends_file(request.ends, found),
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  Report report = verified_report();
  const Report bounds = bound_report(document);
  report.text += bounds.text;
  report.json.update(bounds.json);
  add_where(report, found);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.ends) || is_stdout(request.svg));
}

void add_bound_command(CLI::App& app, Job& chosen, const char* name, const char* what, MakeBound make,
                       const char* width = "1e-6", bool with_ends = true) {
  const auto shared = std::make_shared<BoundRequest>();
  shared->width = width;
  CLI::App* command = app.add_subcommand(name, what);
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  command->add_option("--width", shared->width, "the width of the enclosure, a length of at least 1e-12")
      ->option_text(std::string("W [") + width + "]");
  add_file(*command, "-o,--output", shared->output, "the bound file to write, for certify; \"-\" is standard output");
  add_threads(*command, shared->threads);
  if (with_ends) add_ends(*command, shared->ends);
  add_file(*command, "--svg", shared->svg, "also draw where the bound is attained; \"-\" is standard output");
  add_json(*command, shared->json);
  command->footer(std::string("Example:\n  epsnet ") + name +
                  " s.json --width 1e-3 -o bound.json && certify bound.json\n\n"
                  "The points that are printed have 12 digits; those of --json are fractions.");
  command->callback([&chosen, shared, make] { chosen = [shared, make] { enclose(*shared, make); }; });
}

struct EccentricityRequest {
  std::string surface;
  std::string p;
  std::string output;
  std::string ends;
  std::string svg;
  bool json = false;
};

void measure_eccentricity(const EccentricityRequest& request) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, net_type(request.output)},
                                               {"--ends", request.ends, FileType::json},
                                               {"--svg", request.svg, FileType::svg}});
  const SurfaceOrNet input = read_surface_or_net(request.surface);
  const BasePoint p = parse_point("P", request.p, input);
  const auto [net, certificate] = [&] {
    const ProgressLine progress("eccentricity");
    return eccentricity_net(input.surface, p);
  }();
  const Where found = where(net, true);
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of_eccentricity(net));
  write_outputs(
      {{request.output, [&, &document = net](std::ostream& out) { write_net_file(document, request.output, out); }},
       ends_file(request.ends, found),
       {request.svg, [&](std::ostream& out) { out << svg; }}});
  const certify::Interval value = certificate.enclosures->largest_circumradius;
  Report report = verified_report();
  report.text += "eccentricity: " + to_string(value) + '\n';
  report.json["eccentricity"] = interval_json(value);
  add_where(report, found);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.ends) || is_stdout(request.svg));
}

}  // namespace

Report bound_report(const certify::BoundDocument& document) {
  using Claim = certify::BoundDocument::Claim;
  const std::string name = document.claim == Claim::diameter ? "diameter"
                           : document.claim == Claim::radius ? "radius"
                                                             : "embedded_disk_radius";
  std::size_t cells = 0;
  for (const auto& row : document.cells) {
    for (const std::uint32_t entry : row) cells += entry >= 3 ? 1 : 0;
  }
  const std::size_t triangulations = document.triangulations.size() + 1;
  return {name + ": " + to_string(document.value) + "\ncells: " + std::to_string(cells) +
              "\ntriangulations: " + std::to_string(triangulations) + '\n',
          Json::object({{name, interval_json(document.value)}, {"cells", cells}, {"triangulations", triangulations}})};
}

void add_eccentricity_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<EccentricityRequest>();
  CLI::App* command = app.add_subcommand(
      "eccentricity", "The greatest distance of a point of the surface from a given one, enclosed and proved.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  add_point(*command, "P", shared->p, kPointHelp);
  add_file(*command, "-o,--output", shared->output,
           "the net file with the one vertex P to write, for certify: its largest circumradius is the eccentricity; "
           "\"-\" is standard output");
  add_ends(*command, shared->ends);
  add_file(*command, "--svg", shared->svg, "also draw P and the points farthest from it; \"-\" is standard output");
  add_json(*command, shared->json);
  add_progress(*command);
  command->footer("Example:\n  epsnet eccentricity s.json 0,0.1,-1/3\n  epsnet eccentricity net.json v17");
  command->callback([&chosen, shared] { chosen = [shared] { measure_eccentricity(*shared); }; });
}

void add_diameter_command(CLI::App& app, Job& chosen) {
  add_bound_command(app, chosen, "diameter", "The diameter, the greatest distance of two points, enclosed and proved.",
                    &diameter);
}

void add_radius_command(CLI::App& app, Job& chosen) {
  add_bound_command(
      app, chosen, "radius",
      "The radius of the smallest disk that covers the surface (the least eccentricity), enclosed and proved.", &radius,
      "1e-2");
}

void add_embedded_disk_command(CLI::App& app, Job& chosen) {
  add_bound_command(app, chosen, "embedded-disk",
                    "The radius of the largest embedded disk, the greatest injectivity radius, enclosed and proved.",
                    &largest_embedded_disk, "1e-6", false);
}

}  // namespace epsnet::program
