#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/claims/bound/document.h"
#include "certify/claims/comparison/document.h"
#include "certify/claims/curves/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/isometries/document.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/lifts/info.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/curves.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/files.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/surface.h"

/// The commands of the program `epsnet`, a file for each or for some that are alike: their options, and their work.
namespace epsnet::program {

/// The work of a command, to be run after the command line is read.
using Job = std::function<void()>;

// Each adds a command to the program, whose callback sets `chosen`.
void add_surface_command(CLI::App& app, Job& chosen);
void add_net_command(CLI::App& app, Job& chosen);
void add_import_net_command(CLI::App& app, Job& chosen);
void add_dirichlet_command(CLI::App& app, Job& chosen);
void add_distance_command(CLI::App& app, Job& chosen);
void add_locate_command(CLI::App& app, Job& chosen);
void add_distances_command(CLI::App& app, Job& chosen);
void add_eccentricity_command(CLI::App& app, Job& chosen);
void add_diameter_command(CLI::App& app, Job& chosen);
void add_radius_command(CLI::App& app, Job& chosen);
void add_embedded_disk_command(CLI::App& app, Job& chosen);
void add_systole_command(CLI::App& app, Job& chosen);
void add_spectrum_command(CLI::App& app, Job& chosen);
void add_thick_thin_command(CLI::App& app, Job& chosen);
void add_local_maximum_command(CLI::App& app, Job& chosen);
void add_curves_command(CLI::App& app, Job& chosen);
void add_mapping_class_command(CLI::App& app, Job& chosen);
void add_maximize_command(CLI::App& app, Job& chosen);
void add_eigenvalues_command(CLI::App& app, Job& chosen);
void add_bands_command(CLI::App& app, Job& chosen);
void add_gap_command(CLI::App& app, Job& chosen);
void add_lattice_command(CLI::App& app, Job& chosen);
void add_isometries_command(CLI::App& app, Job& chosen);
void add_isometric_command(CLI::App& app, Job& chosen);
void add_identify_command(CLI::App& app, Job& chosen);
void add_pants_command(CLI::App& app, Job& chosen);
void add_draw_command(CLI::App& app, Job& chosen);
void add_view_command(CLI::App& app, Job& chosen);
void add_info_command(CLI::App& app, Job& chosen);
void add_export_command(CLI::App& app, Job& chosen);
void add_convert_command(CLI::App& app, Job& chosen);
void add_help_command(CLI::App& app, Job& chosen);

// Options that several commands have.

/// The help text for a file whose surface is used.
inline constexpr const char* kSurfaceHelp = "a surface file, or any file that has a surface, such as a net file";
/// The help text for a product of Dehn twists.
inline constexpr const char* kProductHelp =
    "a product of Dehn twists, the last one first, as in \"a1 b2^-1 C1 (1 6)^2\": generators, in upper case their "
    "inverses, or simple closed curves as words of sides in parentheses";
/// Adds a required argument, a file to read. `name` is that of the argument, such as NET.
void add_input(CLI::App& command, const char* name, std::string& path, const char* what);
/// Adds an option with a file to read or to write.
CLI::Option* add_file(CLI::App& command, const char* option, std::string& path, const std::string& what);
/// Adds the required option -o FILE. `what` describes the file.
void add_output(CLI::App& command, std::string& output, const char* what);
/// Adds --json: the report as one JSON object.
void add_json(CLI::App& command, bool& json);
/// Adds --threads N and --progress.
void add_threads(CLI::App& command, unsigned& threads);
/// Adds --progress.
void add_progress(CLI::App& command);
/// Returns the point that --base, or another option or argument, names: "tile,x,y", or "tile": the centre of the tile.
/// One that is outside of its tile is brought to the tile that contains it, with a line on standard error that says so.
/// Throws UsageError if the text names no point, JobError if the surface has none there.
[[nodiscard]] BasePoint parse_base(const std::string& text, const Surface& surface, const std::string& name = "--base");
/// Returns a point as parse_base reads it, exactly, if that is short. Else its coordinates have 12 digits, and
/// ", rounded" follows: where a walk led, around short curves, they may have thousands.
[[nodiscard]] std::string point_text(const BasePoint& point);
/// Returns the same as an object: the tile, and the coordinates as texts of rationals.
[[nodiscard]] Json point_json(const BasePoint& point);
/// The help text for a point of a surface file or a net file.
inline constexpr const char* kPointHelp =
    "a point: T,X,Y of tile T, exact, or T alone for its centre; for a net file also vN, vertex N, or tN:A,B,C, the "
    "point of triangle N with these weights on its corners in the hyperboloid model";
/// Adds a required argument that is a point.
void add_point(CLI::App& command, const char* name, std::string& text, const std::string& what);
/// Returns the point named by an argument or by a line of a file. Throws UsageError if the text names no point,
/// JobError if the file has no such tile, vertex or triangle. Both messages begin with `name`.
[[nodiscard]] BasePoint parse_point(const std::string& name, const std::string& text, const SurfaceOrNet& input);
/// Returns the number in "v17", for the letter v; nullopt for any other text.
[[nodiscard]] std::optional<std::uint32_t> number_after(char letter, std::string_view text);
/// Returns a number of the command line in the form of files: "0.5" for ".5" and "-0.5" for "-.5". Any other text is
/// returned unchanged.
[[nodiscard]] std::string with_leading_zero(const std::string& number);
/// Returns the value of an option that is a positive length. Throws UsageError, which names the option.
[[nodiscard]] Length parse_length(const std::string& option, const std::string& text);
/// Returns the phases of a character: numbers of turns with commas, colons or spaces between them. Throws UsageError,
/// whose message begins with `name`.
[[nodiscard]] TorusPoint parse_torus_point(const std::string& name, const std::string& text);
/// Reads one number of turns, more than 0 and at most 1/2. Throws UsageError likewise.
[[nodiscard]] Rational parse_turn_distance(const std::string& name, const std::string& text);
/// Reads a positive decimal of at most 10000, rounded to binary64. Throws UsageError likewise.
[[nodiscard]] double parse_eigenvalue(const std::string& name, const std::string& text);
/// Returns a picture as SVG; writes what it could not show to standard error.
[[nodiscard]] std::string svg_of(const PolygonPicture& picture);
/// Adds --geodesics FILE.
void add_geodesics(CLI::App& command, std::string& file);
/// Adds --distance FILE.
void add_distance(CLI::App& command, std::string& file);
/// Returns facts of info.h as a report.
[[nodiscard]] inline Report facts_report(const Facts& facts) { return {facts.text, facts.json}; }
/// Returns the facts proved by the certificate of a net.
[[nodiscard]] Report certificate_report(const certify::Certificate& certificate);
/// Returns the contents of a geodesics file, as lines and as an object.
[[nodiscard]] Report geodesics_report(const certify::GeodesicsDocument& document);
/// Returns the contents of a bound file, as lines and as an object.
[[nodiscard]] Report bound_report(const certify::BoundDocument& document);
/// Returns the contents of an eigenvalues file, as lines and as an object.
[[nodiscard]] Report eigenvalues_report(const certify::EigenvaluesDocument& document);
/// Returns the contents of an isometries file, as lines and as an object.
[[nodiscard]] Report isometries_report(const certify::IsometriesDocument& document);
[[nodiscard]] Report comparison_report(const certify::ComparisonDocument& document);
/// Returns the contents of a pants file, as lines and as an object.
[[nodiscard]] Report pants_report(const certify::PantsDocument& document);
/// Returns the contents of a curves file, as lines and as an object.
[[nodiscard]] Report curves_report(const certify::CurvesDocument& document);
/// Returns the contents of a distance file, as lines and as an object.
[[nodiscard]] Report distance_report(const certify::DistanceDocument& document);
/// Returns the closed geodesics of a geodesics file about the net's surface, as layers of a picture. Throws JobError,
/// and the exceptions of the reader.
[[nodiscard]] std::vector<Layer> load_geodesics_layers(const std::string& file, const certify::NetDocument& net);
/// Returns the same for the paths of a distance file.
[[nodiscard]] Layer load_distance_layer(const std::string& file, const certify::NetDocument& net);
/// Returns a transform for a whole number from least to most, both included, least above -2⁶³: in decimal, also with
/// leading zeros, which CLI11 would read as octal. Its own ranges have messages that differ between versions, and let
/// numbers that are too large become the largest one.
[[nodiscard]] CLI::Validator integer_between(std::int64_t least, std::uint64_t most);
/// Returns a validator for an option with named values, in the order in which an error lists them.
template <class T>
[[nodiscard]] CLI::Validator one_of(std::vector<std::pair<std::string, T>> choices) {
  return {[choices = std::move(choices)](std::string& text) {
            std::string expected;
            for (const auto& [name, value] : choices) {
              if (text == name) {
                text = std::to_string(static_cast<int>(value));  // CLI11 reads a T from this.
                return std::string();
              }
              expected += (expected.empty() ? "" : ", ") + name;
            }
            return "expected one of " + expected + ", not \"" + text.substr(0, 80) + "\"";
          },
          ""};
}
/// Returns the value of --epsilon.
[[nodiscard]] inline Length parse_epsilon(const std::string& text) { return parse_length("--epsilon", text); }

}  // namespace epsnet::program
