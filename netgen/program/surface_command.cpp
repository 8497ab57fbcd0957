#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/file/file.h"
#include "netgen/base/gmp.h"
#include "netgen/curves/curves.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/info.h"
#include "netgen/pants/pants.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::program {
namespace {

/// The options that all kinds of surfaces have.
struct SurfaceOutput {
  std::string output;
  bool json = false;
};

void add_surface_output(CLI::App& command, SurfaceOutput& request) {
  add_output(command, request.output, "the surface file to write");
  add_json(command, request.json);
}

/// Lets the command do the work `make(request)`.
template <class Request>
void set_work(CLI::App& command, Job& chosen, const std::shared_ptr<Request>& request, void (*make)(const Request&)) {
  command.callback([&chosen, request, make] { chosen = [request, make] { make(*request); }; });
}

/// Throws as check_files does.
void check_surface_files(const std::vector<InputFile>& inputs, const SurfaceOutput& request) {
  check_files(inputs, {{"--output", request.output, FileType::json}});
}

void write_surface_file(const Surface& surface, const SurfaceOutput& request) {
  const certify::SurfaceDocument document = to_document(surface);
  write_output(request.output, [&](std::ostream& out) { certify::write_file(document, out); });
  if (request.json) write_report(facts_report(surface_info(surface)), true, is_stdout(request.output));
}

// ---- octagon ----

struct OctagonRequest : SurfaceOutput {
  std::optional<std::int32_t> seed;
  std::string coordinates;
};

using Octagon = std::array<Complex<Rational>, 4>;

/// Returns the value of --coordinates. Throws UsageError.
Octagon parse_coordinates(const std::string& text) {
  std::vector<Rational> numbers;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string word = text.substr(start, end - start);
    const auto number = parse_decimal(with_leading_zero(word));
    if (!number) {
      throw UsageError("--coordinates: \"" + word.substr(0, 80) + "\" found, expected " +
                       (numbers.size() % 2 == 0 ? "x" : "y") + std::to_string(numbers.size() / 2) +
                       ", a decimal or a fraction");
    }
    numbers.push_back(*number);
    start = end + 1;
  }
  if (numbers.size() != 8) {
    throw UsageError("--coordinates: " + std::to_string(numbers.size()) +
                     " numbers found, expected 8: x0,y0,x1,y1,x2,y2,x3,y3, the first four vertices counterclockwise");
  }
  return {{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}, {numbers[4], numbers[5]}, {numbers[6], numbers[7]}}};
}

/// Returns a hint: the z3 with which the octagon would close up; empty if there is none.
std::string closing_hint(const Octagon& half) {
  const std::optional<Octagon> closed = closed_up(half);
  if (!closed || *closed == half) return "";
  try {
    static_cast<void>(symmetric_octagon(*closed));
  } catch (const SurfaceError&) {
    return "";
  }
  return "; with these z0, z1, z2 it closes up for x3,y3 = " + (*closed)[3].x.str() + "," + (*closed)[3].y.str();
}

Surface octagon_of(const std::string& coordinates) {
  const Octagon half = parse_coordinates(coordinates);
  try {
    return symmetric_octagon(half);
  } catch (const SurfaceError& error) {
    throw UsageError("--coordinates: not a symmetric octagon of genus 2: " + std::string(error.what()) +
                     closing_hint(half));
  }
}

void make_octagon(const OctagonRequest& request) {
  if (!request.seed && request.coordinates.empty())
    throw UsageError("surface octagon: expected --seed or --coordinates (try --help)");
  check_surface_files({}, request);
  write_surface_file(request.seed ? random_octagon(*request.seed) : octagon_of(request.coordinates), request);
}

void add_octagon(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<OctagonRequest>();
  CLI::App* command = surface.add_subcommand(
      "octagon",
      "A surface of genus 2 from a symmetric octagon: random, the same as CGAL 6.1 makes from that seed, or given.");
  CLI::Option* seed =
      command->add_option("--seed", request->seed, "a 32-bit integer; the same seed gives the same surface")
          ->transform(
              integer_between(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()))
          ->option_text("N");
  command
      ->add_option("--coordinates", request->coordinates,
                   "the octagon z0, z1, z2, z3, -z0, -z1, -z2, -z3, counterclockwise, opposite sides glued; exact "
                   "decimals or fractions. If it does not close up, the error names a z3 for which it does")
      ->excludes(seed)
      ->option_text("X0,Y0,...,X3,Y3");
  add_surface_output(*command, *request);
  command->footer(
      "Example:\n"
      "  epsnet surface octagon --seed 123 -o s.json\n"
      "  epsnet surface octagon --coordinates 5/6,0,3/5,3/5,0,5/6,-3/5,3/5 -o s.json");
  set_work(*command, chosen, request, make_octagon);
}

// ---- fenchel-nielsen ----

struct FenchelNielsenCommand : SurfaceOutput {
  FenchelNielsenRequest coordinates;
  std::string file;
};

/// Runs `make` and attributes its errors to the file, if there is one, otherwise to the command line. `of_file` returns
/// whether a member of the request comes from the file.
template <class Make, class OfFile>
auto blaming_the_source(const std::string& file, const OfFile& of_file, const Make& make) {
  try {
    return make();
  } catch (const FenchelNielsenRequestError& error) {
    if (!file.empty() && of_file(error.member())) throw JobError(file + ": " + error.what());
    if (error.member().empty()) throw UsageError(error.what());
    throw UsageError((error.member() == "graph" ? "--pants-graph" : "--" + error.member()) + ": " + error.problem());
  } catch (const CoordinateError& error) {
    if (!file.empty() && of_file(error.member())) throw JobError(file + ": " + error.what());
    throw UsageError("--" + error.member() + ": " + error.what());
  }
}

/// Numbers that were divided at all commas: those in parentheses, as in root(f,r), belong to a number.
std::vector<std::string> numbers_of(const std::vector<std::string>& pieces) {
  std::vector<std::string> result;
  std::ptrdiff_t depth = 0;
  for (const std::string& piece : pieces) {
    if (depth > 0) {
      result.back() += "," + piece;
    } else {
      result.push_back(with_leading_zero(piece));
    }
    depth += std::count(piece.begin(), piece.end(), '(') - std::count(piece.begin(), piece.end(), ')');
  }
  return result;
}

void make_fenchel_nielsen(const FenchelNielsenCommand& command) {
  check_surface_files({{"--from", command.file}}, command);
  FenchelNielsenRequest request = command.coordinates;
  request.lengths = numbers_of(request.lengths);
  request.twists = numbers_of(request.twists);
  const FenchelNielsenRequest given = request;
  const auto of_file = [&](const std::string& member) {
    return !((member == "graph" && !given.graph.empty()) || (member == "genus" && given.genus) ||
             (member == "seed" && given.seed) || (member == "lengths" && !given.lengths.empty()) ||
             (member == "twists" && !given.twists.empty()));
  };
  const std::string name = command.file == "-" ? "standard input" : command.file;
  const Surface surface = blaming_the_source(name, of_file, [&] {
    if (!command.file.empty()) {
      request = parse_fenchel_nielsen(read_text_input(command.file).text);
      // The command line takes precedence over the file.
      if (!given.graph.empty()) request.graph = given.graph;
      if (given.genus) request.genus = given.genus;
      if (given.seed) request.seed = given.seed;
      if (!given.lengths.empty()) request.lengths = given.lengths;
      if (!given.twists.empty()) request.twists = given.twists;
    }
    const FenchelNielsen coordinates = resolve(request);
    Surface made = fenchel_nielsen_surface(coordinates);
    for (const std::string& remark : symmetry_remarks(coordinates)) std::cerr << remark << '\n';
    return made;
  });
  write_surface_file(surface, command);
}

void add_fenchel_nielsen(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<FenchelNielsenCommand>();
  CLI::App* command = surface.add_subcommand(
      "fenchel-nielsen",
      "A surface of any genus from its Fenchel-Nielsen coordinates, exact and within 2^-50 of them. Missing values "
      "are drawn with the seed: lengths between 1 and 4, any twist.");
  command
      ->add_option("--genus", request->coordinates.genus,
                   "2 or more; not needed with edges or with lists of lengths or twists")
      ->transform(integer_between(2, kLargestGraphGenus))
      ->option_text("G");
  command->add_option("--seed", request->coordinates.seed, "0 to 2^64 - 1; the same seed gives the same surface")
      ->transform(integer_between(0, std::numeric_limits<std::uint64_t>::max()))
      ->option_text("N");
  command
      ->add_option("--pants-graph", request->coordinates.graph,
                   "a trivalent graph: its edges as in \"0-1 0-1 0-1\", a node for each pair of pants, or one of the "
                   "named ones; theta is 0-1 0-1 0-1, of genus 2, the default for three lengths and three twists")
      ->option_text("chain|ring|tree|theta|random|EDGES [random]");
  command
      ->add_option("--lengths", request->coordinates.lengths,
                   "the lengths of the cuffs, in the order of the edges, or one for all: decimals, or exactly as in "
                   "2*arcosh(3/2), 2*arsinh(1), 2*log(3), arcosh(1+sqrt(2))")
      ->delimiter(',')
      ->option_text("L,L,...");
  command
      ->add_option("--twists", request->coordinates.twists,
                   "the twists as hyperbolic lengths, or one for all; a full turn is the length of the cuff; 0, half "
                   "of the length and what is given exactly stay so")
      ->delimiter(',')
      ->option_text("T,T,...");
  add_file(*command, "--from", request->file,
           "a JSON object with members graph, genus, seed, lengths, twists; options take precedence over it; \"-\" is "
           "standard input");
  add_surface_output(*command, *request);
  command->footer(
      "Example:\n"
      "  epsnet surface fenchel-nielsen --genus 7 --seed 3 -o s.json\n"
      "  epsnet surface fenchel-nielsen --pants-graph \"0-0 0-1 1-1\" \\\n"
      "    --lengths 1,1e-8,2 --twists 0,0.5,1 -o s.json\n"
      "  epsnet surface fenchel-nielsen --pants-graph theta --lengths \"2*arcosh(3/2)\" \\\n"
      "    --twists 0 -o s.json\n\n"
      "The foot of the common perpendicular with the next cuff is a mark on each cuff of a pair of pants. With twist 0 "
      "the two marks meet. docs/fenchel-nielsen.md has the conventions.");
  set_work(*command, chosen, request, make_fenchel_nielsen);
}

// ---- regular ----

struct RegularRequest : SurfaceOutput {
  std::uint32_t genus = 0;
};

void make_regular(const RegularRequest& request) {
  check_surface_files({}, request);
  write_surface_file(Surface::regular(request.genus), request);
}

void add_regular(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<RegularRequest>();
  CLI::App* command = surface.add_subcommand(
      "regular", "The regular 4g-gon with opposite sides glued, exactly, without rational rounding: Bolza for g = 2.");
  command->add_option("--genus", request->genus, "2 to 1000")
      ->required()
      ->transform(integer_between(2, 1000))
      ->option_text("G REQUIRED");
  add_surface_output(*command, *request);
  command->footer("Example:\n  epsnet surface regular --genus 2 -o bolza.json");
  set_work(*command, chosen, request, make_regular);
}

// ---- cover ----

struct CoverRequest : SurfaceOutput {
  std::string surface;
  std::string permutations;
  std::optional<std::uint32_t> degree;
  std::optional<std::uint64_t> seed;
};

void make_cover(const CoverRequest& request) {
  if (request.permutations.empty() && !(request.degree && request.seed))
    throw UsageError("surface cover: expected --permutations, or --degree and --seed (try --help)");
  check_surface_files({{"SURFACE", request.surface}, {"--permutations", request.permutations}}, request);
  const Surface base = read_surface_input(request.surface);
  if (request.permutations.empty()) {
    write_surface_file(cover(base, random_sheets(base, *request.degree, *request.seed)), request);
    return;
  }
  const TextInput input = read_text_input(request.permutations);
  try {
    write_surface_file(cover(base, parse_permutations(input.text)), request);
  } catch (const CoverError& error) {
    throw JobError(input.name + ": " + error.what());
  }
}

void add_cover(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<CoverRequest>();
  CLI::App* command = surface.add_subcommand(
      "cover", "An unbranched cover of a surface, connected: given by permutations of its sheets, or random.");
  add_input(*command, "SURFACE", request->surface, kSurfaceHelp);
  CLI::Option* permutations =
      add_file(*command, "--permutations", request->permutations,
               "a JSON array of permutations, one for each pair of sides of the fundamental polygon, as in [[1,0],...] "
               "(docs/covers.md); \"-\" is standard input");
  command
      ->add_option("--degree", request->degree,
                   "the number of sheets of a random cover, 1 to 50; all covers of this degree are equally likely")
      ->excludes(permutations)
      ->transform(integer_between(1, kMostRandomSheets))
      ->option_text("N");
  command->add_option("--seed", request->seed, "0 to 2^64 - 1; the same seed gives the same cover")
      ->excludes(permutations)
      ->transform(integer_between(0, std::numeric_limits<std::uint64_t>::max()))
      ->option_text("K");
  add_surface_output(*command, *request);
  command->footer(
      "Example:\n"
      "  epsnet surface cover s.json --degree 10 --seed 1 -o cover.json\n"
      "  epsnet surface cover s.json --permutations p.json -o cover.json");
  set_work(*command, chosen, request, make_cover);
}

// ---- dehn-twist and twist ----

struct TwistRequest : SurfaceOutput {
  std::string surface;
  std::string curve;
  std::int32_t power = 1;
  std::string product;
  std::string by;
};

constexpr const char* kCurveHelp =
    "a simple closed curve, as the numbers of the sides that it crosses, in quotes or with commas; epsnet spectrum "
    "and epsnet pants print such words";

/// Writes the surface that `twist` makes of a surface and a curve.
template <class Twist>
void make_twisted(const TwistRequest& request, const Twist& twist) {
  check_surface_files({{"SURFACE", request.surface}}, request);
  const Surface surface = read_surface_input(request.surface);
  const Word curve = parse_word("CURVE", request.curve);
  const Surface result = [&] {
    try {
      return twist(surface, curve);
    } catch (const CurveError& error) {
      throw JobError("CURVE: " + error.problem());
    }
  }();
  write_surface_file(result, request);
}

void make_dehn_twist(const TwistRequest& request) {
  if (request.curve.empty() == request.product.empty())
    throw UsageError("surface dehn-twist: expected either CURVE or --word (try --help)");
  if (!request.curve.empty()) {
    return make_twisted(request, [&](const Surface& surface, const Word& curve) {
      return dehn_twisted(surface, curve, request.power);
    });
  }
  check_surface_files({{"SURFACE", request.surface}}, request);
  const Surface surface = read_surface_input(request.surface);
  const MappingClass product = MappingClassGroup(surface).parse(request.product);
  try {
    write_surface_file(with_marking(surface, product), request);
  } catch (const CurveError& error) {
    throw JobError("--word: twist " + std::to_string(error.number()) + ": " + error.problem());
  }
}

void add_dehn_twist(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<TwistRequest>();
  CLI::App* command = surface.add_subcommand(
      "dehn-twist",
      "The same surface with another marking: its tiles as triangles, glued alike, after a Dehn twist along a curve.");
  add_input(*command, "SURFACE", request->surface, kSurfaceHelp);
  command->add_option("CURVE", request->curve, kCurveHelp);
  command->add_option("POWER", request->power, "how often to the left; to the right, if it is negative; -1000 to 1000")
      ->transform(integer_between(-kMostTwists, kMostTwists))
      ->option_text("[1]");
  command->add_option("--word", request->product, std::string("instead of CURVE, ") + kProductHelp)
      ->option_text("PRODUCT")
      ->excludes("CURVE");
  add_surface_output(*command, *request);
  command->footer(
      "A word of side numbers stands for the element that the Dehn twist makes of it. epsnet mapping-class lists the "
      "generators. docs/fenchel-nielsen.md has the "
      "details.\n\n"
      "Example:\n  epsnet surface dehn-twist s.json 6,1 -2 -o t.json\n  epsnet isometric s.json t.json");
  set_work(*command, chosen, request, make_dehn_twist);
}

void make_twist(const TwistRequest& request) {
  const auto by = parse_decimal(with_leading_zero(request.by));
  if (!by) throw UsageError("--by: expected a decimal or a fraction, not " + certify::in_quotes(request.by));
  make_twisted(request, [&](const Surface& surface, const Word& curve) { return twisted(surface, curve, *by); });
}

void add_twist(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<TwistRequest>();
  CLI::App* command = surface.add_subcommand(
      "twist", "The surface cut along a simple closed geodesic and glued anew, one side moved along it.");
  add_input(*command, "SURFACE", request->surface, kSurfaceHelp);
  command->add_option("CURVE", request->curve, kCurveHelp)->required()->option_text("REQUIRED");
  command->add_option("--by", request->by, "the hyperbolic length by which the other side is moved to the left")
      ->required()
      ->option_text("T REQUIRED");
  add_surface_output(*command, *request);
  command->footer(
      "The surface is one of surface fenchel-nielsen, with its rounding.\n\n"
      "Example:\n  epsnet surface twist s.json 6,1 --by 0.1 -o t.json");
  set_work(*command, chosen, request, make_twist);
}

// ---- named ----

struct NamedRequest : SurfaceOutput {
  std::string name;
  std::optional<std::uint32_t> genus;
  bool list = false;
};

void list_named_surfaces() {
  write_stdout([](std::ostream& out) {
    for (const NamedSurface& surface : named_surfaces()) {
      out << surface.name << "\n  " << surface.description << "\n  " << surface.source << ".\n";
    }
    for (const RegularMap& map : regular_maps()) out << map.name << "\n  " << description(map) << '\n';
  });
}

void make_named(const NamedRequest& request) {
  if (request.list) return list_named_surfaces();
  if (request.name.empty()) throw UsageError("surface named: expected NAME or --list (try --help)");
  if (request.output.empty()) throw UsageError("--output is required");
  check_surface_files({}, request);
  const Surface surface = [&] {
    try {
      return named_surface(request.name, request.genus);
    } catch (const SurfaceError& error) {
      throw UsageError(std::string("NAME: ") + error.what());
    }
  }();
  write_surface_file(surface, request);
}

void add_named(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<NamedRequest>();
  CLI::App* command = surface.add_subcommand(
      "named", "A surface that has a name, such as Klein's quartic or the regular map R2.1: regular tiles, exactly.");
  CLI::Option* name =
      command->add_option("NAME", request->name, "a name of --list, a number in place of G")->option_text(" ");
  command->add_option("--genus", request->genus, "of a family: wiman --genus 7 is wiman-7")
      ->transform(integer_between(2, 1000))
      ->option_text("G");
  add_file(*command, "-o,--output", request->output,
           "the surface file to write, needed with NAME; \"-\" is standard output");
  add_json(*command, request->json);
  command->add_flag("--list", request->list, "print all names, with a sentence for each, and a source")
      ->excludes(name)
      ->excludes("--genus")
      ->excludes("--output")
      ->excludes("--json");
  command->footer(
      "Example:\n  epsnet surface named klein -o klein.json\n  epsnet surface named wiman-7 -o wiman.json\n"
      "  epsnet surface named R4.2 -o bring.json");
  set_work(*command, chosen, request, make_named);
}

// ---- map, matrices and import: from a file ----

struct FileRequest : SurfaceOutput {
  std::string file;
};

void make_map(const FileRequest& request) {
  check_surface_files({{"FILE", request.file}}, request);
  const TextInput input = read_text_input(request.file);
  const Surface surface = [&] {
    try {
      return surface_of_map(parse_map(input.text));
    } catch (const SurfaceError& error) {
      throw JobError(input.name + ": " + error.what());
    }
  }();
  write_surface_file(surface, request);
}

void add_map(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<FileRequest>();
  CLI::App* command = surface.add_subcommand(
      "map",
      "The surface of a map of which all faces have p sides and all vertices q corners: its faces are regular, with "
      "equal angles, exactly.");
  add_input(*command, "FILE", request->file,
            "a JSON object with two permutations of the darts, which are numbered from 0: rotation, to the next dart "
            "around the face, counterclockwise, and edges, to the other dart of the edge");
  add_surface_output(*command, *request);
  command->footer("Example:\n  epsnet surface map map.json -o s.json");
  set_work(*command, chosen, request, make_map);
}

void make_from_matrices(const FileRequest& request) {
  check_surface_files({{"FILE", request.file}}, request);
  const TextInput input = read_text_input(request.file);
  const MatrixSurface made = [&] {
    try {
      return surface_of_matrices(parse_matrices(input.text));
    } catch (const MatricesError& error) {
      const std::string message = input.name + ": " + error.what();
      if (error.kind() == MatricesError::Kind::undecided) throw UndecidedError(message);
      throw JobError(message);
    }
  }();
  const certify::SurfaceDocument document = to_document(made.surface);
  write_output(request.output, [&](std::ostream& out) { certify::write_file(document, out); });
  Report report = facts_report(surface_info(made.surface));
  report.json["exact"] = made.is_exact;
  report.json["distance"] = made.distance;
  report.json["words"] = made.words;
  std::ostringstream out;
  out << "genus: " << made.surface.genus() << '\n';
  if (made.is_exact) {
    out << "group: exactly that of the matrices, as this program decides\n";
  } else {
    out << "group: the nearest exact one; entries differ by at most " << certify::shortest(made.distance) << '\n';
  }
  for (std::size_t k = 0; k < made.words.size(); ++k) {
    out << "generator " << k + 1 << ": word " << word_text(made.words[k]) << '\n';
  }
  report.text = out.str();
  write_report(report, request.json, is_stdout(request.output));
}

void add_matrices(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<FileRequest>();
  CLI::App* command = surface.add_subcommand(
      "matrices",
      "The surface of the group that matrices in SL(2,R) or SU(1,1) generate: exactly that of matrices whose entries "
      "are rational or in a real number field, or the nearest exact one to decimals. Torsion, "
      "groups that are not discrete or not cocompact are errors that name an "
      "element.");
  add_input(
      *command, "FILE", request->file,
      "a matrix a b c d in each line, or JSON, with or without a relation; numbers such as 2/3, sqrt(2), cos(pi/7) "
      "and root(x^3-x-1,1.3); with a line \"algebra a b\" quaternions x y z w (docs/exchange-formats.md)");
  add_surface_output(*command, *request);
  command->footer(
      "Exit code 2: undecided, as no fundamental domain was found within the limits, or "
      "the matrices do not take the tiles to themselves.\n\n"
      "Example:\n"
      "  epsnet export s.json --format matrices -o matrices.json\n"
      "  epsnet surface matrices matrices.json -o same.json && epsnet isometric s.json same.json");
  set_work(*command, chosen, request, make_from_matrices);
}

struct ImportRequest : FileRequest {
  ExchangeFormat format = ExchangeFormat::automatic;
};

void import_surface_text(const ImportRequest& request) {
  check_surface_files({{"FILE", request.file}}, request);
  const TextInput input = read_text_input(request.file);
  write_surface_file(import_surface(input.text, input.name, request.format), request);
}

void add_import(CLI::App& surface, Job& chosen) {
  const auto request = std::make_shared<ImportRequest>();
  CLI::App* command = surface.add_subcommand(
      "import",
      "A surface of any genus from a text of CGAL, checked exactly: a polygon with rational vertices (domain) or "
      "triangles with rational cross-ratios, with an anchor, none, or one for each (triangulation).");
  add_input(*command, "FILE", request->file, "the text (docs/exchange-formats.md)");
  command->add_option("--format", request->format, "the format of FILE; auto detects it from the first words")
      ->transform(one_of<ExchangeFormat>({{"auto", ExchangeFormat::automatic},
                                          {"domain", ExchangeFormat::domain},
                                          {"triangulation", ExchangeFormat::triangulation}}))
      ->option_text("auto|domain|triangulation [auto]");
  add_surface_output(*command, *request);
  command->footer(
      "Example:\n"
      "  epsnet surface import polygon.txt -o s.json\n"
      "  epsnet surface import triangulation.txt -o s.json");
  set_work(*command, chosen, request, import_surface_text);
}

}  // namespace

void add_surface_command(CLI::App& app, Job& chosen) {
  CLI::App* surface = app.add_subcommand("surface", "Make a surface file.");
  surface->require_subcommand(0, 1);
  surface->footer("Example:\n  epsnet surface fenchel-nielsen --genus 7 --seed 3 -o s.json");
  add_octagon(*surface, chosen);
  add_fenchel_nielsen(*surface, chosen);
  add_regular(*surface, chosen);
  add_cover(*surface, chosen);
  add_dehn_twist(*surface, chosen);
  add_twist(*surface, chosen);
  add_named(*surface, chosen);
  add_map(*surface, chosen);
  add_matrices(*surface, chosen);
  add_import(*surface, chosen);
}

}  // namespace epsnet::program
