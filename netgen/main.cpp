#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>

#include "epsnet/certify/check.h"
#include "epsnet/certify/reader.h"
#include "epsnet/certify/text.h"
#include "epsnet/certify/writer.h"
#include "epsnet/netgen/atomic_file.h"
#include "epsnet/netgen/certified_net.h"
#include "epsnet/netgen/decimal.h"
#include "epsnet/netgen/dirichlet_polygon.h"
#include "epsnet/netgen/domain_format.h"
#include "epsnet/netgen/draw.h"
#include "epsnet/netgen/exchange.h"
#include "epsnet/netgen/fenchel_nielsen_request.h"
#include "epsnet/netgen/info.h"
#include "epsnet/netgen/octagon.h"
#include "epsnet/netgen/surface_file.h"
#include "epsnet/netgen/triangulation_stream.h"

/// The program `epsnet`: makes surfaces, computes and certifies nets, draws them, and says what is in files.
namespace {

using namespace epsnet;

// Nothing but these is ever returned.
constexpr int kExitFine = 0;
constexpr int kExitFailed = 1;
constexpr int kExitUsage = 64;
constexpr int kExitInternal = 70;

/// An option's value that cannot be meant.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The job cannot be done; what() says why.
class JobError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// ---- Output ----

/// "-" means standard output.
bool is_stdout(const std::string& path) { return path == "-"; }

void write_stdout(const std::function<void(std::ostream&)>& write) {
  write(std::cout);
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) throw JobError("cannot write to standard output");
}

/// Writes a complete file or none.
void write_output(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (is_stdout(path)) {
    write_stdout(write);
  } else {
    write_file_atomically(path, write);
  }
}

/// Fails now, rather than after a long computation, if there is no such directory.
void check_output_directory(const std::string& path) {
  if (is_stdout(path)) return;
  std::filesystem::path directory = std::filesystem::path(path).parent_path();
  if (directory.empty()) directory = ".";
  std::error_code error;
  if (!std::filesystem::is_directory(directory, error))
    throw JobError("cannot write '" + path + "': no directory '" + directory.string() + "'");
}

/// One line: no text of a file or of the command line can start another.
std::string one_line(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 32 || code == 127) c = code == '\n' ? ' ' : '?';
  }
  return result;
}

int fail(int code, std::string_view text) {
  std::cerr << "epsnet: " << one_line(text) << '\n';
  return code;
}

/// Shows how far we are on a terminal, after the first second; wipes its line at the end.
class ProgressLine {
 public:
  void show(const std::string& text, double share) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now - shown_ < std::chrono::milliseconds(shown_once_ ? 200 : 1000)) return;
    shown_ = now;
    shown_once_ = true;
    std::fprintf(stderr, "\r%-36s %3.0f %%", text.c_str(), 100 * share);
  }
  ProgressLine() = default;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (shown_once_) std::fprintf(stderr, "\r%44s\r", "");
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

class Stopwatch {
 public:
  /// Seconds since the construction or the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// ---- epsnet surface ----

struct SurfaceRequest {
  std::int32_t seed = 0;
  std::uint32_t genus = 0;
  std::string file;
  ExchangeFormat format = ExchangeFormat::automatic;
  std::string output;
};

void write_surface_file(const Surface& surface, const std::string& output) {
  const certify::Surface document = to_document(surface);
  write_output(output, [&](std::ostream& out) { certify::write_surface(document, out); });
}

struct FenchelNielsenCommand {
  FenchelNielsenRequest request;
  std::string file;
  std::string output;
};

void make_fenchel_nielsen(FenchelNielsenCommand command) {
  if (!command.file.empty()) {
    const FenchelNielsenRequest given = command.request;
    command.request = load_fenchel_nielsen(command.file);
    // The command line comes before the file.
    if (!given.graph.empty()) command.request.graph = given.graph;
    if (given.genus) command.request.genus = given.genus;
    if (given.seed) command.request.seed = given.seed;
    if (!given.lengths.empty()) command.request.lengths = given.lengths;
    if (!given.twists.empty()) command.request.twists = given.twists;
  }
  check_output_directory(command.output);
  const FenchelNielsen coordinates = [&] {
    try {
      return resolve(command.request);
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());
    }
  }();
  write_surface_file(fenchel_nielsen_surface(coordinates), command.output);
}

void make_regular(const SurfaceRequest& request) {
  write_surface_file(Surface::regular(request.genus), request.output);
}

void make_octagon(const SurfaceRequest& request) { write_surface_file(random_octagon(request.seed), request.output); }

void import_surface(const SurfaceRequest& request) {
  write_surface_file(import_surface_file(request.file, request.format), request.output);
}

// ---- epsnet net ----

struct NetRequest {
  std::string surface;
  std::string epsilon;
  std::string output;
  std::string svg;
  std::string base;
  bool no_certify = false;
  bool stats = false;
  NetOptions options;
};

struct PhaseTimes {
  double reading = 0;
  double computing = 0;
  double certifying = 0;
  double drawing = 0;
  double writing = 0;
};

Epsilon parse_epsilon(const std::string& text) {
  try {
    return Epsilon(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--epsilon: ") + error.what());
  }
}

std::string interval_text(certify::Interval x) {
  return "[" + certify::shortest(x.lower) + ", " + certify::shortest(x.upper) + "]";
}

/// "2.41", or "-" where there is nothing to divide by.
std::string ratio_text(double part, double whole) {
  if (whole == 0) return "-";
  std::ostringstream out;
  out.precision(4);
  out << part / whole;
  return out.str();
}

std::string ratio_text(std::uint64_t part, std::uint64_t whole) {
  return ratio_text(static_cast<double>(part), static_cast<double>(whole));
}

/// What the certificate proved, in three lines.
std::string certificate_text(const certify::Certificate& certificate) {
  std::ostringstream out;
  out << "verdict: " << certify::name(certificate.verdict) << '\n'
      << "vertices: " << certificate.counts.vertices << '\n';
  if (certificate.enclosures) {
    out << "largest circumradius: " << interval_text(certificate.enclosures->largest_circumradius) << '\n';
    out << "shortest edge between different vertices: "
        << (certificate.enclosures->shortest_edge ? interval_text(*certificate.enclosures->shortest_edge) : "none")
        << '\n';
  }
  return out.str();
}

/// Walks and flips in the terms of the thesis (IV.6.2, figures IV.11 and IV.12).
std::string walk_text(const NetStatistics& s, Insertion insertion) {
  std::ostringstream out;
  out << "insertions: " << s.insertions << '\n';
  out << "flips per insertion: " << ratio_text(s.flips, s.insertions)
      << (insertion == Insertion::cavity ? " (a cavity of k triangles counts as k - 1 flips)" : "") << '\n';
  if (insertion == Insertion::cavity) {
    out << "triangles visited per location, circumcentres in their own triangle: not measured, a cavity needs no "
           "location; use --insert flips\n";
    return out.str();
  }
  const std::uint64_t elsewhere = s.located - s.located_at_start;
  out << "triangles visited per location: " << ratio_text(s.walk_steps, s.located) << ", where the start is left "
      << ratio_text(s.walk_steps, elsewhere) << ", longest walk " << s.longest_walk << '\n';
  out << "share of circumcentres in their own triangle: " << ratio_text(s.located_at_start, s.located) << '\n';
  return out.str();
}

std::string statistics_text(const UncertifiedNet& net, std::uint32_t genus, double epsilon, const NetRequest& request,
                            const PhaseTimes& times) {
  const NetStatistics& s = net.statistics;
  const auto count = static_cast<double>(net.net.vertices.size());
  const double least = least_vertices(genus, epsilon);
  const double most = most_vertices(genus, epsilon);
  std::ostringstream out;
  out << walk_text(s, request.options.insertion);
  out << "flips of the initial triangulation: " << s.initial_flips << '\n';
  out << "vertices removed from it: " << s.removed << '\n';
  out << "lower bound (g-1)/sinh^2(epsilon/2), Theorem III.2: " << least << ", ratio " << ratio_text(count, least)
      << '\n';
  out << "upper bound 16(g-1)/epsilon^2, Theorem III.1 if the systole is at least epsilon: " << most << ", ratio "
      << ratio_text(count, most) << '\n';
  out << "charts: " << s.charts << '\n' << "labels: " << s.labels << '\n';
  out << "multiprecision predicates: " << s.multiprecision << '\n';
  out << "seconds: reading " << times.reading << ", initial triangulation " << s.start_seconds << ", refinement "
      << s.refine_seconds << ", document " << std::max(0.0, times.computing - s.start_seconds - s.refine_seconds);
  if (!request.no_certify) out << ", certification " << times.certifying;
  if (!request.svg.empty()) out << ", drawing " << times.drawing;
  out << ", writing " << times.writing << '\n';
  return out.str();
}

UncertifiedNet compute(const Surface& surface, const Epsilon& epsilon, NetOptions options) {
  ProgressLine progress;
  options.progress = [&](std::uint64_t vertices, double share) {
    progress.show("net: " + std::to_string(vertices) + " vertices", share);
  };
  return compute_net(surface, epsilon, options);
}

/// The certificate of a verified net. Throws JobError for any other.
certify::Certificate certify_net(const certify::Document& net, certify::CheckOptions options) {
  ProgressLine progress;
  options.progress = [&](std::string_view rule, double share) {
    progress.show("certificate: " + std::string(rule), share);
  };
  certify::Certificate certificate = certify::check(net, options);
  if (certificate.verdict != certify::Verdict::verified) {
    throw JobError("no certified net: " + std::string(certify::name(certificate.verdict)) + ": " + certificate.rule +
                   ": " + certificate.message + "; nothing was written");
  }
  return certificate;
}

/// "tile,x,y", or "tile": the centre of the tile.
BasePoint parse_base(const std::string& text, const Surface& surface) {
  const std::size_t first = std::min(text.find(','), text.size());
  const std::string tile = text.substr(0, first);
  const bool digits = !tile.empty() && tile.size() <= 9 && tile.find_first_not_of("0123456789") == std::string::npos;
  if (digits && first == text.size()) return centre_of_tile(surface, static_cast<std::uint32_t>(std::stoul(tile)));
  const std::size_t second = text.find(',', first + 1);
  if (digits && second != std::string::npos) {
    const auto x = parse_decimal(std::string_view(text).substr(first + 1, second - first - 1));
    const auto y = parse_decimal(std::string_view(text).substr(second + 1));
    if (x && y) return {static_cast<std::uint32_t>(std::stoul(tile)), {*x, *y}};
  }
  throw UsageError("--base: expected a tile and a point of it, as in 0,1/10,-0.25, or a tile alone, not \"" +
                   text.substr(0, 80) + "\"");
}

void make_net(const NetRequest& request) {
  if (is_stdout(request.output) && is_stdout(request.svg))
    throw UsageError("--output and --svg cannot both be standard output");
  const Epsilon epsilon = parse_epsilon(request.epsilon);
  check_output_directory(request.output);
  if (!request.svg.empty()) check_output_directory(request.svg);

  PhaseTimes times;
  Stopwatch watch;
  const Surface surface = load_surface(request.surface);
  times.reading = watch.lap();
  NetOptions options = request.options;
  if (!request.base.empty()) options.base = parse_base(request.base, surface);
  const UncertifiedNet net = compute(surface, epsilon, options);
  times.computing = watch.lap();
  std::string report = request.no_certify
                           ? "verdict: not certified (--no-certify): nothing is proved about this net\nvertices: " +
                                 std::to_string(net.net.vertices.size()) + "\n"
                           : certificate_text(certify_net(net.net, request.options.check));
  times.certifying = watch.lap();
  std::string svg;
  if (!request.svg.empty()) svg = draw_svg(net.net);
  times.drawing = watch.lap();
  write_output(request.output, [&](std::ostream& out) { certify::write_net(net.net, out); });
  if (!request.svg.empty()) write_output(request.svg, [&](std::ostream& out) { out << svg; });
  times.writing = watch.lap();
  if (request.stats)
    report += statistics_text(net, surface.genus(), static_cast<double>(epsilon.value()), request, times);
  // A net on standard output stays a net.
  if (is_stdout(request.output) || is_stdout(request.svg)) {
    std::cerr << report;
  } else {
    write_stdout([&](std::ostream& out) { out << report; });
  }
}

// ---- epsnet dirichlet ----

struct DirichletRequest {
  std::string surface;
  std::string base;
  std::string output;
  std::string svg;
};

void make_dirichlet(const DirichletRequest& request) {
  if (is_stdout(request.output) && is_stdout(request.svg))
    throw UsageError("--output and --svg cannot both be standard output");
  check_output_directory(request.output);
  if (!request.svg.empty()) check_output_directory(request.svg);
  const Surface surface = load_surface(request.surface);
  const std::optional<BasePoint> base =
      request.base.empty() ? std::nullopt : std::optional(parse_base(request.base, surface));
  const DirichletPolygon polygon = dirichlet_polygon(surface, base);
  std::string svg;
  if (!request.svg.empty()) {
    DrawOptions options;
    options.dirichlet = true;
    svg = draw_svg(polygon.triangulation, options);
  }
  write_output(request.output, [&](std::ostream& out) { out << dirichlet_json(polygon); });
  if (!request.svg.empty()) write_output(request.svg, [&](std::ostream& out) { out << svg; });
}

// ---- epsnet draw, epsnet info ----

struct DrawRequest {
  std::string net;
  std::string output;
  DrawOptions options;
};

void draw(const DrawRequest& request) {
  check_output_directory(request.output);
  const certify::Document net = certify::read_net(request.net);
  std::string svg;
  try {
    svg = draw_svg(net, request.options);
  } catch (const NetGeometryError& error) {
    throw JobError(request.net + ": " + error.what());
  }
  write_output(request.output, [&](std::ostream& out) { out << svg; });
}

/// A guess, made from the first bytes; members of a file may come in any order. The reader decides.
bool looks_like_surface(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head.find("\"epsnet-surface\"") != std::string::npos;
}

std::variant<Surface, certify::Document> load_surface_or_net(const std::string& path) {
  if (looks_like_surface(path)) return load_surface(path);
  try {
    return certify::read_net(path);
  } catch (const certify::MalformedError& not_a_net) {
    try {
      (void)certify::read_surface(path);
    } catch (const certify::MalformedError&) {
      throw not_a_net;
    }
    return load_surface(path);
  }
}

std::string info_text(const std::string& path) {
  const auto contents = load_surface_or_net(path);
  if (const auto* surface = std::get_if<Surface>(&contents)) return surface_info(*surface);
  try {
    return net_info(std::get<certify::Document>(contents));
  } catch (const NetGeometryError& error) {
    throw JobError(path + ": " + error.what());
  }
}

void print_info(const std::string& path) {
  const std::string text = info_text(path);
  write_stdout([&](std::ostream& out) { out << text; });
}

// ---- epsnet export ----

struct ExportRequest {
  std::string file;
  ExchangeFormat format = ExchangeFormat::triangulation;
  std::string output;
};

std::string domain_text(const std::variant<Surface, certify::Document>& contents) {
  const auto* surface = std::get_if<Surface>(&contents);
  if (surface == nullptr) throw JobError("the domain format holds a polygon, not a net; use --format triangulation");
  return write_domain(*surface);
}

void export_file(const ExportRequest& request) {
  check_output_directory(request.output);
  const auto contents = load_surface_or_net(request.file);
  try {
    if (request.format == ExchangeFormat::domain) {
      const std::string text = domain_text(contents);
      write_output(request.output, [&](std::ostream& out) { out << text; });
      return;
    }
    const TriangulationStream stream =
        std::visit([](const auto& source) { return triangulation_stream(source); }, contents);
    write_output(request.output, [&](std::ostream& out) { write_triangulation_stream(stream, out); });
  } catch (const std::invalid_argument& error) {
    throw JobError(request.file + ": " + error.what());
  } catch (const TriangulationStreamError& error) {
    throw JobError(request.file + ": " + error.what());
  }
}

// ---- The command line ----

struct Commands {
  SurfaceRequest octagon;
  FenchelNielsenCommand fenchel_nielsen;
  SurfaceRequest regular;
  SurfaceRequest import;
  NetRequest net;
  DirichletRequest dirichlet;
  DrawRequest draw;
  ExportRequest export_;
  std::string info;
  std::function<void()> chosen;
};

void add_output(CLI::App& command, std::string& output, const char* what) {
  command.add_option("-o,--output", output, std::string(what) + "; \"-\" is standard output")
      ->required()
      ->option_text("FILE REQUIRED");
}

void add_surface_commands(CLI::App& app, Commands& commands) {
  CLI::App* surface = app.add_subcommand("surface", "Make a surface file.");
  surface->require_subcommand(0, 1);
  surface->footer("Example:\n  epsnet surface fenchel-nielsen --genus 7 --seed 3 -o s.json");

  CLI::App* octagon = surface->add_subcommand(
      "octagon", "A random surface of genus 2: a symmetric octagon, the same as CGAL 6.1 makes from that seed.");
  octagon->add_option("--seed", commands.octagon.seed, "a 32-bit integer; the same seed gives the same surface")
      ->required()
      ->option_text("N REQUIRED");
  add_output(*octagon, commands.octagon.output, "the surface file to write");
  octagon->footer("Example:\n  epsnet surface octagon --seed 123 -o s.json");
  octagon->callback([&] { commands.chosen = [&] { make_octagon(commands.octagon); }; });

  FenchelNielsenCommand& pants = commands.fenchel_nielsen;
  CLI::App* fenchel = surface->add_subcommand(
      "fenchel-nielsen",
      "A surface of any genus from its Fenchel-Nielsen coordinates, exact and within 2^-50 of them. What is left out "
      "is drawn with the seed: lengths between 1 and 4, any twist.");
  fenchel->add_option("--genus", pants.request.genus, "2 or more; not needed with a list of edges")->option_text("G");
  fenchel->add_option("--seed", pants.request.seed, "the same seed gives the same surface")->option_text("N");
  fenchel
      ->add_option("--pants-graph", pants.request.graph,
                   "a trivalent graph: its edges as in \"0-1 0-1 0-1\", a node for each pair of pants, or one of the "
                   "named ones")
      ->option_text("chain|ring|tree|random|EDGES [random]");
  fenchel->add_option("--lengths", pants.request.lengths, "of the cuffs, in the order of the edges, or one for all")
      ->delimiter(',')
      ->option_text("L,L,...");
  fenchel
      ->add_option("--twists", pants.request.twists, "as hyperbolic lengths, or one for all; a full turn is the length")
      ->delimiter(',')
      ->option_text("T,T,...");
  fenchel
      ->add_option("--from", pants.file,
                   "a JSON object with members graph, genus, seed, lengths, twists; options given here come first")
      ->option_text("FILE");
  add_output(*fenchel, pants.output, "the surface file to write");
  fenchel->footer(
      "Example:\n"
      "  epsnet surface fenchel-nielsen --genus 7 --seed 3 -o s.json\n"
      "  epsnet surface fenchel-nielsen --pants-graph \"0-0 0-1 1-1\" --lengths 1,1e-8,2 --twists 0,0.5,1 -o s.json\n\n"
      "Twist 0: on each cuff of a pair of pants a mark, the foot of the common perpendicular with its next cuff; the\n"
      "two marks meet. docs/fenchel-nielsen.md has the conventions.");
  fenchel->callback([&] { commands.chosen = [&] { make_fenchel_nielsen(commands.fenchel_nielsen); }; });

  CLI::App* regular = surface->add_subcommand(
      "regular", "The regular 4g-gon with opposite sides glued, itself and not a rational neighbour: Bolza for g = 2.");
  regular->add_option("--genus", commands.regular.genus, "2 to 1000")->required()->option_text("G REQUIRED");
  add_output(*regular, commands.regular.output, "the surface file to write");
  regular->footer("Example:\n  epsnet surface regular --genus 2 -o bolza.json");
  regular->callback([&] { commands.chosen = [&] { make_regular(commands.regular); }; });

  CLI::App* import_command = surface->add_subcommand(
      "import",
      "A surface of any genus from a text of CGAL, checked exactly: a polygon with rational vertices (domain) or "
      "triangles with rational cross-ratios and an anchor (triangulation).");
  import_command->add_option("FILE", commands.import.file, "the text (docs/exchange-formats.md)")
      ->required()
      ->option_text("REQUIRED");
  import_command
      ->add_option("--format", commands.import.format,
                   "what FILE is; auto tells by its second word, \"yes\" or \"no\" in a triangulation")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ExchangeFormat>{{"auto", ExchangeFormat::automatic},
                                                {"domain", ExchangeFormat::domain},
                                                {"triangulation", ExchangeFormat::triangulation}}))
      ->option_text("auto|domain|triangulation [auto]");
  add_output(*import_command, commands.import.output, "the surface file to write");
  import_command->footer(
      "Example:\n"
      "  epsnet surface import polygon.txt -o s.json\n"
      "  epsnet surface import triangulation.txt -o s.json");
  import_command->callback([&] { commands.chosen = [&] { import_surface(commands.import); }; });
}

void add_net_command(CLI::App& app, Commands& commands) {
  NetRequest& request = commands.net;
  CLI::App* net = app.add_subcommand("net", "Compute an epsilon-net of a surface, prove it, write it.");
  net->add_option("SURFACE", request.surface, "a surface file")->required()->option_text("REQUIRED");
  net->add_option("--epsilon", request.epsilon, "a positive decimal or fraction: 0.1 is exactly 1/10")
      ->required()
      ->option_text("E REQUIRED");
  add_output(*net, request.output, "the net file to write, only if the net is verified");
  net->add_option("--svg", request.svg, "also draw the net; \"-\" is standard output")->option_text("FILE");
  net->add_option(
         "--base", request.base,
         "start from this point alone: of tile T, strictly inside of it, exact; T alone is the centre of the tile")
      ->option_text("T[,X,Y]");
  net->add_flag("--no-certify", request.no_certify, "write the net without checking it: nothing is proved");
  CLI::Option* insert =
      net->add_option("--insert", request.options.insertion,
                      "how points are inserted: cavity is fast; flips is the way of the thesis, with its statistics")
          ->transform(CLI::CheckedTransformer(
              std::map<std::string, Insertion>{{"cavity", Insertion::cavity}, {"flips", Insertion::flips}}))
          ->option_text("cavity|flips [cavity]");
  CLI::Option* locate = net->add_option("--locate", request.options.walk,
                                        "the walk with which --insert flips, implied by this, finds triangles")
                            ->transform(CLI::CheckedTransformer(std::map<std::string, Walk>{
                                {"visibility", Walk::visibility}, {"straight", Walk::straight}}))
                            ->option_text("visibility|straight [visibility]");
  net->add_flag("--stats", request.stats, "also print what the thesis measures, and times");
  net->add_option("--threads", request.options.check.threads, "of the certificate; 0 is one per core")
      ->check(CLI::Range(0U, 1024U))
      ->option_text("N [0]");
  net->footer(
      "Example:\n"
      "  epsnet net s.json --epsilon 0.1 -o net.json --svg net.svg && certify net.json\n\n"
      "The report goes to standard output, or to standard error if a file goes there.");
  net->callback([&commands, insert, locate] {
    if (locate->count() > 0) {
      if (insert->count() > 0 && commands.net.options.insertion == Insertion::cavity)
        throw CLI::ValidationError("--locate", "a cavity needs no walk; use --insert flips");
      commands.net.options.insertion = Insertion::flips;
    }
    commands.chosen = [&] { make_net(commands.net); };
  });
}

void add_dirichlet_command(CLI::App& app, Commands& commands) {
  DirichletRequest& request = commands.dirichlet;
  CLI::App* command = app.add_subcommand(
      "dirichlet", "The Dirichlet domain of a point: its sides with their pairings as words, and its vertices.");
  command->add_option("SURFACE", request.surface, "a surface file")->required()->option_text("REQUIRED");
  command
      ->add_option("--base", request.base,
                   "the point: of tile T, strictly inside of it, exact; T alone is its centre. Without it the "
                   "surface's first vertex, the "
                   "centre of a regular one")
      ->option_text("T[,X,Y]");
  add_output(*command, request.output, "the JSON file to write (docs/format.md)");
  command->add_option("--svg", request.svg, "also draw it, with the Delaunay triangulation; \"-\" is standard output")
      ->option_text("FILE");
  command->footer("Example:\n  epsnet dirichlet s.json --base 0,0.1,-1/3 -o domain.json --svg domain.svg");
  command->callback([&] { commands.chosen = [&] { make_dirichlet(commands.dirichlet); }; });
}

void add_draw_command(CLI::App& app, Commands& commands) {
  DrawRequest& request = commands.draw;
  CLI::App* draw_command = app.add_subcommand(
      "draw", "Draw a net: one lift of every triangle, with vertex 0 in the centre of the Poincare disk.");
  draw_command->add_option("NET", request.net, "a net file")->required()->option_text("REQUIRED");
  add_output(*draw_command, request.output, "the SVG file to write");
  draw_command
      ->add_option("--order", request.options.order,
                   "which triangle is lifted next: across the edge of least weight, or breadth-first")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, DrawOrder>{{"weight", DrawOrder::weight}, {"bfs", DrawOrder::breadth_first}}))
      ->option_text("weight|bfs [weight]");
  draw_command->add_flag("--dirichlet", request.options.dirichlet, "also draw the Dirichlet domain of vertex 0");
  draw_command->add_option("--size", request.options.size, "width and height in pixels")
      ->check(CLI::Range(50U, 20000U))
      ->option_text("PX [1000]");
  draw_command->footer("Example:\n  epsnet draw net.json -o net.svg --dirichlet");
  draw_command->callback([&] { commands.chosen = [&] { draw(commands.draw); }; });
}

void add_info_command(CLI::App& app, Commands& commands) {
  CLI::App* info = app.add_subcommand("info", "Say what is in a surface file or a net file.");
  info->add_option("FILE", commands.info, "a surface file or a net file")->required()->option_text("REQUIRED");
  info->footer("Example:\n  epsnet info net.json");
  info->callback([&] { commands.chosen = [&] { print_info(commands.info); }; });
}

void add_export_command(CLI::App& app, Commands& commands) {
  ExportRequest& request = commands.export_;
  CLI::App* command = app.add_subcommand("export", "Write a surface or a net as a text that CGAL reads, exactly.");
  command->add_option("FILE", request.file, "a surface file or a net file")->required()->option_text("REQUIRED");
  command
      ->add_option("--format", request.format,
                   "domain: the polygon of a surface of one tile; triangulation: the triangles of a net, or the tiles "
                   "of a surface cut into triangles, with an anchor and cross-ratios")
      ->required()
      ->transform(CLI::CheckedTransformer(std::map<std::string, ExchangeFormat>{
          {"domain", ExchangeFormat::domain}, {"triangulation", ExchangeFormat::triangulation}}))
      ->option_text("domain|triangulation REQUIRED");
  add_output(*command, request.output, "the text to write");
  command->footer(
      "Example:\n"
      "  epsnet export s.json --format domain -o polygon.txt\n"
      "  epsnet export net.json --format triangulation -o triangulation.txt");
  command->callback([&] { commands.chosen = [&] { export_file(commands.export_); }; });
}

// Address sanitizer reserves terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitMemory = false;
#elif defined(__has_feature)
constexpr bool kLimitMemory = !__has_feature(address_sanitizer);
#else
constexpr bool kLimitMemory = true;
#endif

/// Memory that the machine does not have makes std::bad_alloc and one clear line, not the end of other programs.
void limit_memory() {
  if (!kLimitMemory) return;
  struct sysinfo machine = {};
  struct rlimit limit = {};
  if (sysinfo(&machine) != 0 || getrlimit(RLIMIT_AS, &limit) != 0) return;
  rlim_t bytes = (rlim_t{machine.totalram} + machine.totalswap) * machine.mem_unit;
  if (std::ifstream group("/sys/fs/cgroup/memory.max"); group) {
    std::uint64_t allowed = 0;
    if (group >> allowed) bytes = std::min<rlim_t>(bytes, allowed);
  }
  limit.rlim_cur = std::min(limit.rlim_cur, bytes);
  (void)setrlimit(RLIMIT_AS, &limit);
}

int run(int argc, char** argv) {
  Commands commands;
  CLI::App app(
      "Epsilon-nets of closed hyperbolic surfaces, each with a proof.\n"
      "An epsilon-net: every point of the surface is within epsilon of a vertex, and vertices are at least epsilon "
      "apart.",
      "epsnet");
  // 0: an unknown command is then named; a missing one is found below.
  app.require_subcommand(0, 1);
  add_surface_commands(app, commands);
  add_net_command(app, commands);
  add_dirichlet_command(app, commands);
  add_draw_command(app, commands);
  add_info_command(app, commands);
  add_export_command(app, commands);
  app.footer(
      "Example:\n"
      "  epsnet surface octagon --seed 123 -o s.json\n"
      "  epsnet net s.json --epsilon 0.1 -o net.json --svg net.svg\n"
      "  certify net.json\n\n"
      "Exit codes: 0 fine, 1 the job failed, 64 wrong usage, 70 internal fault.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success);  // --help
    std::cout.flush();
    return std::cout ? kExitFine : fail(kExitFailed, "cannot write to standard output");
  } catch (const CLI::ParseError& error) {
    return fail(kExitUsage, std::string(error.what()) + " (try --help)");
  }

  if (!commands.chosen)
    return fail(kExitUsage, app.got_subcommand("surface")
                                ? "surface: which one, octagon, fenchel-nielsen, regular or import? (try --help)"
                                : "which command, surface, net, dirichlet, draw, info or export? (try --help)");

  try {
    commands.chosen();
    return kExitFine;
  } catch (const UsageError& error) {
    return fail(kExitUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kExitFailed, "not enough memory");
  } catch (const JobError& error) {
    return fail(kExitFailed, error.what());
  } catch (const certify::FileError& error) {
    return fail(kExitFailed, error.what());
  } catch (const certify::MalformedError& error) {
    return fail(kExitFailed, error.what());
  } catch (const SurfaceError& error) {
    return fail(kExitFailed, error.what());
  } catch (const FenchelNielsenRequestError& error) {
    return fail(kExitFailed, error.what());
  } catch (const DomainError& error) {
    return fail(kExitFailed, error.what());
  } catch (const TriangulationStreamError& error) {
    return fail(kExitFailed, error.what());
  } catch (const NetError& error) {
    return fail(kExitFailed, error.what());
  } catch (const NetGeometryError& error) {
    return fail(kExitFailed, error.what());
  } catch (const WriteError& error) {
    return fail(kExitFailed, error.what());
  }
}

/// The end for everything that cannot be caught: GMP and FLINT out of memory, std::terminate, a crash.
/// Async-signal-safe.
[[noreturn]] void end_on_signal(int) {
  constexpr std::string_view kText = "epsnet: internal fault\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kText.data(), kText.size());
  _exit(kExitInternal);
}

}  // namespace

int main(int argc, char** argv) {
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGILL}) std::signal(signal, end_on_signal);
  // Errors of writing, then, with a message.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  std::ios::sync_with_stdio(false);
  limit_memory();
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    return fail(kExitInternal, std::string("internal fault: ") + error.what());
  } catch (...) {
    return fail(kExitInternal, "internal fault");
  }
}
