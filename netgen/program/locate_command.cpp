#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "netgen/lifts/lifts.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"
#include "netgen/surfaces/surface_file.h"

namespace epsnet::program {
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
