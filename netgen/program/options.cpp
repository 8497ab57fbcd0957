#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "certify/base/text.h"
#include "certify/file/file.h"
#include "netgen/base/gmp.h"
#include "netgen/base/progress_line.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "triangulation/surface/surface.h"

namespace epsnet::program {
namespace {

/// Refuses an empty path, which is a mistake such as an unset shell variable, and an option in place of a path.
CLI::Validator path_given() {
  return {[](const std::string& path) -> std::string {
            if (path.empty()) return "the path is empty";
            if (path.size() > 1 && path.front() == '-')
              return "expected a path, not \"" + path.substr(0, 80) + "\" (a file of that name is ./" +
                     path.substr(0, 80) + ")";
            return "";
          },
          ""};
}

}  // namespace

void add_input(CLI::App& command, const char* name, std::string& path, const char* what) {
  command.add_option(name, path, std::string(what) + "; \"-\" is standard input")
      ->required()
      ->check(path_given())
      ->option_text("REQUIRED");
}

CLI::Option* add_file(CLI::App& command, const char* option, std::string& path, const std::string& what) {
  return command.add_option(option, path, what)->check(path_given())->option_text("FILE");
}

void add_output(CLI::App& command, std::string& output, const char* what) {
  add_file(command, "-o,--output", output, std::string(what) + "; \"-\" is standard output")
      ->required()
      ->option_text("FILE REQUIRED");
}

void add_json(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print the report as one JSON object (docs/exchange-formats.md)");
}

CLI::Validator integer_between(std::int64_t least, std::uint64_t most) {
  return {[=](std::string& text) -> std::string {
            const bool negative = text.starts_with('-');
            std::uint64_t size = 0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data() + (negative ? 1 : 0), end, size);
            const bool in_range = negative ? least <= 0 && size <= std::uint64_t{0} - static_cast<std::uint64_t>(least)
                                           : size <= most && (least <= 0 || static_cast<std::uint64_t>(least) <= size);
            if (error != std::errc() || stop != end || !in_range)
              return "expected an integer from " + std::to_string(least) + " to " + std::to_string(most) + ", not \"" +
                     text.substr(0, 80) + "\"";
            // CLI11 would read 010 as 8.
            text = (negative && size > 0 ? "-" : "") + std::to_string(size);
            return "";
          },
          ""};
}

void add_threads(CLI::App& command, unsigned& threads) {
  command.add_option("--threads", threads, "0 is one per core")
      ->transform(integer_between(0, 1024))
      ->option_text("N [0]");
  add_progress(command);
}

void add_progress(CLI::App& command) {
  command.add_flag("--progress", progress_output().lines,
                   "a line of progress on standard error every ten seconds, also without a terminal");
}

std::string with_leading_zero(const std::string& number) {
  const std::size_t sign = number.starts_with('-') ? 1 : 0;
  if (number.size() < sign + 2 || number[sign] != '.') return number;
  std::string completed = number.substr(0, sign) + "0" + number.substr(sign);
  return parse_decimal(completed) ? completed : number;
}

Length parse_length(const std::string& option, const std::string& text) {
  try {
    // A negative number is quoted as it was given.
    return Length(text.starts_with('-') ? text : with_leading_zero(text));
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
}

std::string svg_of(const PolygonPicture& picture) {
  write_left_out(picture.left_out);
  return draw_svg(picture);
}

void add_geodesics(CLI::App& command, std::string& file) {
  add_file(command, "--geodesics", file,
           "also show the closed geodesics of this file of the same surface (systole, spectrum, thick-thin)");
}

std::vector<Layer> load_geodesics_layers(const std::string& file, const certify::NetDocument& net) {
  const certify::GeodesicsDocument document = certify::read_file<certify::GeodesicsDocument>(file);
  try {
    return geodesics_layers(NetGeometry(net), document);
  } catch (const NetGeometryError& error) {
    throw JobError(file + ": " + error.what());
  }
}

void add_distance(CLI::App& command, std::string& file) {
  add_file(command, "--distance", file, "also show the shortest paths of this file of the same surface (distance)");
}

Layer load_distance_layer(const std::string& file, const certify::NetDocument& net) {
  const certify::DistanceDocument document = certify::read_file<certify::DistanceDocument>(file);
  try {
    return distance_layer(NetGeometry(net), document);
  } catch (const NetGeometryError& error) {
    throw JobError(file + ": " + error.what());
  }
}

namespace {

/// "T,X,Y" or "T".
BasePoint coordinates(const std::string& text, const Surface& surface, const std::string& name) {
  const std::size_t first = std::min(text.find(','), text.size());
  const std::string tile = text.substr(0, first);
  const bool digits = !tile.empty() && tile.size() <= 9 && tile.find_first_not_of("0123456789") == std::string::npos;
  if (digits && first == text.size()) return centre_of_tile(surface, TileId(std::stoul(tile)));
  const std::size_t second = text.find(',', first + 1);
  if (digits && second != std::string::npos) {
    const auto x = parse_decimal(with_leading_zero(text.substr(first + 1, second - first - 1)));
    const auto y = parse_decimal(with_leading_zero(text.substr(second + 1)));
    if (x && y) return {TileId(std::stoul(tile)), {*x, *y}};
  }
  throw UsageError(name + ": expected a tile and a point of it, as in 0,1/10,-0.25, or a tile alone, not \"" +
                   text.substr(0, 80) + "\"");
}

}  // namespace

BasePoint parse_base(const std::string& text, const Surface& surface, const std::string& name) {
  try {
    const BasePoint point = coordinates(text, surface, name);
    BasePoint result = in_its_tile(surface, point);
    if (result.tile != point.tile || result.z != point.z) {
      std::cerr << name << ": outside of tile " << to_string(point.tile) << "; the same point in its own tile is "
                << point_text(result) << '\n';
    }
    return result;
  } catch (const SurfaceError& error) {
    throw JobError(name + ": " + error.what());
  }
}

namespace {

std::string twelve_digits(const Rational& x) {
  std::ostringstream out;
  out << std::setprecision(12) << static_cast<double>(x);
  return out.str();
}

}  // namespace

std::string point_text(const BasePoint& point) {
  const std::string tile = to_string(point.tile) + ',';
  std::string exact = tile + point.z.x.str() + ',' + point.z.y.str();
  constexpr std::size_t kLongest = 24;
  if (exact.size() <= kLongest) return exact;
  return tile + twelve_digits(point.z.x) + ',' + twelve_digits(point.z.y) + ", rounded";
}

Json point_json(const BasePoint& point) {
  return Json::object({{"tile", point.tile}, {"x", point.z.x.str()}, {"y", point.z.y.str()}});
}

void add_point(CLI::App& command, const char* name, std::string& text, const std::string& what) {
  command.add_option(name, text, what)->required()->option_text("T[,X,Y]|vN|tN:A,B,C REQUIRED");
}

std::optional<std::uint32_t> number_after(char letter, std::string_view text) {
  if (!text.starts_with(letter)) return std::nullopt;
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, number);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

namespace {

/// A point given as in "t12:1/3,1/3,1/3".
struct TriangleWeights {
  std::uint32_t triangle;
  std::array<Rational, 3> weights;
};

std::optional<TriangleWeights> parse_weights(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto triangle = number_after('t', text.substr(0, colon));
  if (!triangle || colon == std::string::npos) return std::nullopt;
  TriangleWeights result{*triangle, {}};
  std::size_t begin = colon + 1;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',', begin);
    if ((comma == std::string::npos) != (i == 2)) return std::nullopt;
    const auto weight = parse_decimal(with_leading_zero(text.substr(begin, comma - begin)));
    if (!weight) return std::nullopt;
    result.weights[i] = *weight;
    begin = comma + 1;
  }
  return result;
}

}  // namespace

BasePoint parse_point(const std::string& name, const std::string& text, const SurfaceOrNet& input) try {
  const std::string quoted = "\"" + text.substr(0, 80) + "\"";
  if (!text.starts_with('v') && !text.starts_with('t')) return parse_base(text, input.surface, name);
  const auto vertex = number_after('v', text);
  const auto weights = parse_weights(text);
  if (text.starts_with('v') && !vertex) {
    throw UsageError(name + ": expected v and the number of a vertex, as in v17, not " + quoted);
  }
  if (text.starts_with('t') && !weights) {
    throw UsageError(name + ": expected t, the number of a triangle and three weights, as in t12:1/3,1/3,1/3, not " +
                     quoted);
  }
  if (!input.net) {
    throw UsageError(name + ": " + quoted + " is a " + (vertex ? "vertex" : "point of a triangle") +
                     ", but the file is no net file");
  }
  return vertex ? point_of_vertex(input.surface, *input.net, *vertex)
                : point_of_triangle(input.surface, *input.net, weights->triangle, weights->weights);
} catch (const SurfaceError& error) {
  throw JobError(name + ": " + error.what());
} catch (const NetError& error) {
  throw JobError(name + ": " + error.what());
} catch (const NetGeometryError& error) {
  throw JobError(name + ": " + error.what());
}

}  // namespace epsnet::program
