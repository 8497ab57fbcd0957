#include "wasm/binding/requests.h"

#include <cstdio>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "certify/base/error.h"
#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/file/compact.h"
#include "certify/file/file.h"
#include "certify/program/output.h"
#include "netgen/base/gmp.h"
#include "netgen/base/options.h"
#include "netgen/curves/curves.h"
#include "netgen/distances/distances.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/exchange/exchange.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/lifts/info.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::wasm {
namespace {

using certify::ClaimDocument;
using certify::NetDocument;

/// The name of a file of a request in messages, and the path at which the checker reads it.
constexpr const char* kFile = "file";

std::string text_of(const ClaimDocument& document) {
  std::ostringstream out;
  std::visit([&](const auto& one) { certify::write_file(one, out); }, document);
  return std::move(out).str();
}

std::string text_of(const Surface& surface) {
  std::ostringstream out;
  certify::write_file(to_document(surface), out);
  return std::move(out).str();
}

/// One request: its members, by kind, each with an error that names it.
class Members {
 public:
  explicit Members(const Request& request) : request_(request), object_(request.what) {}
  Members(const Request& request, const Json& object) : request_(request), object_(object) {}

  [[nodiscard]] bool has(const char* name) const { return object_.contains(name); }
  [[nodiscard]] const Json& at(const char* name) const {
    const auto found = object_.find(name);
    if (found == object_.end()) throw std::invalid_argument(std::string(name) + ": missing");
    return *found;
  }
  template <class T>
  [[nodiscard]] T get(const char* name) const {
    return as<T>(at(name), name);
  }
  template <class T>
  [[nodiscard]] T get(const char* name, T otherwise) const {
    return has(name) ? get<T>(name) : otherwise;
  }
  [[nodiscard]] Members member(const char* name) const {
    if (!at(name).is_object()) throw std::invalid_argument(std::string(name) + ": expected an object");
    return {request_, at(name)};
  }
  /// A length as it is written, "0.1", or a number.
  [[nodiscard]] Length length(const char* name) const {
    const Json& value = at(name);
    if (value.is_number()) return Length(value.get<double>());
    return Length(get<std::string>(name));
  }
  /// The bytes of a file that the member has the number of.
  [[nodiscard]] const std::string& file(const char* name) const { return file(name, get<std::size_t>(name)); }
  /// The bytes of the file with this number, which is one of those that the member lists.
  [[nodiscard]] const std::string& file(const char* name, std::size_t number) const {
    if (number >= request_.files.size()) throw std::invalid_argument(std::string(name) + ": there is no such file");
    return request_.files[number];
  }

 private:
  template <class T>
  [[nodiscard]] static T as(const Json& value, const char* name) {
    try {
      if constexpr (std::is_unsigned_v<T> && !std::is_same_v<T, bool>) {
        if (!value.is_number_unsigned()) throw unexpected(value, name, "a number >= 0");
        if (value.get<std::uint64_t>() > std::numeric_limits<T>::max()) {
          throw unexpected(value, name, "a number up to " + std::to_string(std::numeric_limits<T>::max()));
        }
      } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
        if (!value.is_number_integer()) throw unexpected(value, name, "an integer");
      }
      return value.get<T>();
    } catch (const Json::exception&) {
      throw unexpected(value, name, "another kind of value");
    }
  }
  /// The error for a value, which it quotes.
  [[nodiscard]] static std::invalid_argument unexpected(const Json& value, const char* name,
                                                        const std::string& expected) {
    return std::invalid_argument(std::string(name) + ": expected " + expected + ", not " + value.dump().substr(0, 80));
  }

  const Request& request_;
  const Json& object_;
};

Surface surface_of_file(const std::string& bytes, const std::string& name) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  const bool json = start != std::string::npos && bytes[start] == '{';
  return json || certify::is_compact(bytes) ? parse_surface_file(bytes, name) : import_surface(bytes, name);
}

Rational rational(const Json& value, const char* name) {
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  const auto number = certify::parse_decimal(text);
  if (!number) throw std::invalid_argument(std::string(name) + ": " + certify::in_quotes(text) + " is not a number");
  return Rational(number->get_mpq_t());
}

/// A path, as the numbers of the sides that it crosses.
Word word_of(const Json& letters, const char* name) {
  Word word;
  if (!letters.is_array()) throw std::invalid_argument(std::string(name) + ": expected numbers of sides");
  for (const Json& side : letters) {
    if (!side.is_number_unsigned() || side.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
      throw std::invalid_argument(std::string(name) + ": expected numbers of sides, not " + side.dump().substr(0, 80));
    word.emplace_back(side.get<std::uint32_t>());
  }
  return word;
}

std::vector<Word> words_of(const Members& members, const char* name) {
  const Json& given = members.at(name);
  if (!given.is_array()) throw std::invalid_argument(std::string(name) + ": expected an array of paths");
  std::vector<Word> words;
  for (const Json& word : given) words.push_back(word_of(word, name));
  return words;
}

Surface surface_of(const Members& members, const char* name = "surface");

Surface octagon_of(std::int64_t seed) {
  if (seed < std::numeric_limits<std::int32_t>::min() || seed > std::numeric_limits<std::int32_t>::max())
    throw std::invalid_argument("octagon: the seed " + std::to_string(seed) + " is not a number of 32 bits");
  return random_octagon(static_cast<std::int32_t>(seed));
}

/// A cover by permutations of its sheets, or a random one.
Surface cover_of(const Members& how) {
  const Surface base = surface_of(how);
  if (how.has("permutations")) return cover(base, parse_permutations(how.at("permutations").dump()));
  return cover(base, random_sheets(base, how.get<std::uint32_t>("degree"), how.get<std::uint64_t>("seed")));
}

/// The surface that the member names: an object with one member, which is a way to make it. Ways that begin with
/// another surface have it as their member "surface".
Surface surface_of(const Members& members, const char* name) {
  const Members recipe = members.member(name);
  if (recipe.has("octagon")) return octagon_of(recipe.get<std::int64_t>("octagon"));
  if (recipe.has("named")) {
    return named_surface(recipe.get<std::string>("named"),
                         recipe.has("genus") ? std::optional(recipe.get<std::uint32_t>("genus")) : std::nullopt);
  }
  if (recipe.has("regular")) return Surface::regular(recipe.get<std::uint32_t>("regular"));
  if (recipe.has("fenchel_nielsen")) {
    return fenchel_nielsen_surface(resolve(parse_fenchel_nielsen(recipe.at("fenchel_nielsen").dump())));
  }
  if (recipe.has("map")) return surface_of_map(parse_map(recipe.at("map").dump()));
  if (recipe.has("file")) return surface_of_file(recipe.file("file"), recipe.get<std::string>("name", kFile));
  if (recipe.has("cover")) return cover_of(recipe.member("cover"));
  if (recipe.has("dehn_twist")) {
    const Members how = recipe.member("dehn_twist");
    return dehn_twisted(surface_of(how), word_of(how.at("curve"), "curve"), how.get<std::int32_t>("power", 1));
  }
  if (recipe.has("twist")) {
    const Members how = recipe.member("twist");
    return twisted(surface_of(how), word_of(how.at("curve"), "curve"), rational(how.at("by"), "by"), {.threads = 1});
  }
  throw std::invalid_argument(std::string(name) +
                              ": expected octagon, named, regular, fenchel_nielsen, map, file, cover, dehn_twist or "
                              "twist");
}

NetDocument net_of(const Members& members) { return certify::parse_file<NetDocument>(members.file("net"), kFile); }

// Certificates. They are those of the program `certify`, made by its code from the bytes of the file.

struct CheckRequest {
  std::string name = kFile;  ///< Of the file in the certificate.
  bool exact = false;        ///< Ask the second checker about files of any size.
  certify::CheckOptions options = {};
};

certify::program::FileReport check(const std::string& bytes, const CheckRequest& how, const Progress& progress) {
  std::FILE* file = std::fopen(kFile, "wb");
  const bool written = file != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  if (file == nullptr || std::fclose(file) != 0 || !written) throw std::bad_alloc();
  certify::program::Request request;
  request.exact = how.exact;
  request.options = how.options;
  request.options.threads = 1;
  request.options.progress = progress;
  certify::program::FileReport report = certify::program::check_file(request, kFile);
  std::remove(kFile);
  report.path = how.name;
  report.name = certify::display_name(how.name);
  return report;
}

/// The JSON of `certify --json` without the end of its line, and its text with the verdict.
std::string json_of(const certify::program::FileReport& report) {
  std::string json = as_json(report);
  json.pop_back();
  return json;
}

std::string text_of(const certify::program::FileReport& report) {
  const bool named =
      !report.no_claim.empty() || (report.error.empty() && report.certificate.verdict == certify::Verdict::malformed);
  return as_text(report) + verdict_line(report, named ? report.name : "") + '\n';
}

/// {"certificate": …, MEMBERS}, with the file and the text of the certificate. Throws NetError unless it is verified.
Answer proved(const ClaimDocument& document, Json members, const Progress& progress) {
  std::string text = text_of(document);
  const certify::program::FileReport report = check(text, {.options = own_check()}, progress);
  if (exit_code(report) != certify::program::kExitVerified) {
    throw NetError("not certified: " + (report.error.empty() ? verdict_line(report, "") : report.error));
  }
  std::string json = R"({"certificate": )" + json_of(report);
  for (const auto& [name, value] : members.items()) json += ", " + Json(name).dump() + ": " + json_text(value);
  return {json + "}", {std::move(text), text_of(report)}};
}

// Pictures.

constexpr std::pair<const char*, Colouring> kColourings[] = {{"none", Colouring::none},
                                                             {"circumradius", Colouring::circumradius},
                                                             {"chart", Colouring::chart},
                                                             {"distance", Colouring::values}};

/// The layers of the files that the member "layers" names: of closed geodesics and distances.
std::vector<Layer> layers_of(const Members& members, const NetDocument& net) {
  std::vector<Layer> layers;
  for (const std::size_t number : members.get<std::vector<std::size_t>>("layers", {})) {
    const auto claim = certify::parse_file<ClaimDocument>(members.file("layers", number), kFile);
    if (const auto* distance = std::get_if<certify::DistanceDocument>(&claim)) {
      layers.push_back(distance_layer(net, *distance));
    } else if (const auto* geodesics = std::get_if<certify::GeodesicsDocument>(&claim)) {
      for (Layer& layer : geodesics_layers(net, *geodesics)) layers.push_back(std::move(layer));
    } else {
      throw std::invalid_argument("layers: expected files of closed geodesics or of distances");
    }
  }
  return layers;
}

std::uint32_t picture_size(const Members& members) {
  const auto size = members.get<std::uint32_t>("size", 1000);
  if (size < 50 || size > 20000) throw std::invalid_argument("size: expected 50 to 20000 pixels");
  return size;
}

std::string net_picture(const NetDocument& net, const Members& members) {
  DrawOptions options;
  options.size = picture_size(members);
  options.centre = members.get<std::uint32_t>("centre", 0);
  options.legend = members.get<bool>("legend", false);
  const auto colour = members.get<std::string>("colour", "none");
  bool known = false;
  for (const auto& [name, colouring] : kColourings) {
    if (colour != name) continue;
    options.colouring = colouring;
    known = true;
  }
  if (!known) throw std::invalid_argument("colour: expected none, circumradius, chart or distance");
  if (members.has("show")) {
    const std::map<std::string, bool*> what{
        {"triangles", &options.triangles},  {"vertices", &options.vertices},
        {"dirichlet", &options.dirichlet},  {"combinatorial-dirichlet", &options.combinatorial_dirichlet},
        {"disks", &options.covering_disks}, {"half-disks", &options.packing_disks}};
    for (const auto& [name, shown] : what) *shown = false;
    for (const auto& name : members.get<std::vector<std::string>>("show")) {
      if (name == "tiles") {
        options.layers.push_back(tile_layer(net));
        continue;
      }
      const auto shown = what.find(name);
      if (shown == what.end()) throw std::invalid_argument("show: there is no " + certify::in_quotes(name));
      *shown->second = true;
    }
  }
  for (Layer& layer : collar_layers(net)) options.layers.push_back(std::move(layer));
  for (Layer& layer : layers_of(members, net)) options.layers.push_back(std::move(layer));
  if (options.colouring == Colouring::values) {
    options.values = rounded_distances_from(net, options.centre);
    options.values_name = "distance";
  }
  return draw_svg(net, options);
}

std::string eigenfunction_picture(const certify::EigenvaluesDocument& document, const Members& members) {
  EigenfunctionPictureOptions options;
  options.size = picture_size(members);
  options.centre = members.get<std::uint32_t>("centre", 0);
  try {
    return eigenfunction_svg(document, members.get<std::uint32_t>("eigenfunction"), options);
  } catch (const std::out_of_range& error) {
    throw std::invalid_argument("eigenfunction: " + std::string(error.what()));
  }
}

std::string picture(const Members& members) {
  if (members.has("surface")) return draw_svg(picture_of(surface_of(members)), picture_size(members));
  if (members.has("dirichlet")) {
    return draw_svg(picture_of(parse_dirichlet_json(members.file("dirichlet"), kFile)), picture_size(members));
  }
  const auto claim = certify::parse_file<ClaimDocument>(members.file("file"), kFile);
  if (members.has("eigenfunction")) {
    const auto* eigenvalues = std::get_if<certify::EigenvaluesDocument>(&claim);
    if (eigenvalues == nullptr) throw std::invalid_argument("eigenfunction: only of an eigenvalues file");
    return eigenfunction_picture(*eigenvalues, members);
  }
  return std::visit(
      [&](const auto& document) {
        if constexpr (requires { picture_of(document); }) {
          return draw_svg(picture_of(document), picture_size(members));
        } else if constexpr (requires { document.net; }) {
          return net_picture(document.net, members);
        } else {
          return net_picture(document, members);
        }
      },
      claim);
}

// Points: {"tile": T, "z": ["x", "y"]}, {"vertex": V} or {"triangle": T, "weights": [a, b, c]} of the net of the
// request.

BasePoint point_of(const Members& members, const char* name, const Surface& surface) {
  const Members point = members.member(name);
  if (point.has("vertex")) return point_of_vertex(surface, net_of(members), point.get<std::uint32_t>("vertex"));
  if (point.has("triangle")) {
    const Json& weights = point.at("weights");
    if (!weights.is_array() || weights.size() != 3) throw std::invalid_argument("weights: expected three numbers");
    return point_of_triangle(
        surface, net_of(members), point.get<std::uint32_t>("triangle"),
        {rational(weights[0], "weights"), rational(weights[1], "weights"), rational(weights[2], "weights")});
  }
  const TileId tile(point.get<std::uint32_t>("tile"));
  if (!point.has("z")) return centre_of_tile(surface, tile);
  const Json& z = point.at("z");
  if (!z.is_array() || z.size() != 2) throw std::invalid_argument("z: expected two numbers");
  return {tile, {rational(z[0], "z"), rational(z[1], "z")}};
}

Json point_json(const BasePoint& point) {
  return Json::object({{"tile", point.tile}, {"z", Json::array({point.z.x.str(), point.z.y.str()})}});
}

// The requests.

Answer about_surface(const Members& members) {
  const Surface surface = surface_of(members);
  return {json_text(surface_info(surface).json), {text_of(surface)}};
}

Answer make_net(const Members& members, const Progress& progress) {
  NetOptions options;
  options.threads = 1;
  options.progress = progress;
  options.pseudo = members.get<bool>("pseudo", false);
  options.sparse = members.get<bool>("sparse", false);
  const Surface surface = surface_of(members);
  if (members.has("base")) options.base = point_of(members, "base", surface);
  const UncertifiedNet net = compute_net(surface, members.length("epsilon"), options);
  return proved(net.document, Json::object({{"info", net_info(net.document).json}}), progress);
}

Answer check_file(const Members& members, const Progress& progress) {
  const certify::program::FileReport report = check(
      members.file("file"), {members.get<std::string>("name", kFile), members.get<bool>("exact", false), {}}, progress);
  return {json_of(report), {text_of(report)}};
}

Answer find_geodesics(const Members& members, const Progress& progress) {
  GeodesicsOptions options{.threads = 1, .progress = progress};
  const Surface surface = surface_of(members);
  const auto what = members.get<std::string>("do");
  const certify::GeodesicsDocument found = what == "systole" ? unproved::systole(surface, options)
                                           : what == "spectrum"
                                               ? unproved::spectrum(surface, members.length("up_to"), options)
                                               : unproved::thick_thin(surface, options);
  Json list = Json::array();
  for (const auto& geodesic : found.geodesics) {
    list.push_back(Json::object(
        {{"length", interval_json(geodesic.length)}, {"simple", geodesic.simple}, {"word", geodesic.word}}));
  }
  return proved(found, Json::object({{"geodesics", std::move(list)}}), progress);
}

Answer find_bound(const Members& members, const Progress& progress) {
  const auto what = members.get<std::string>("do");
  BoundOptions options;
  options.width = members.get<double>("width", what == "radius" ? 1e-2 : 1e-6);
  options.progress = progress;
  const Surface surface = surface_of(members);
  const certify::BoundDocument found = what == "diameter" ? unproved::diameter(surface, options)
                                       : what == "radius" ? unproved::radius(surface, options)
                                                          : unproved::largest_embedded_disk(surface, options);
  const BasePoint p = point_of_vertex(surface, found.net, 0);
  return proved(found, Json::object({{"value", interval_json(found.value)}, {"p", point_json(p)}}), progress);
}

Answer measure_distance(const Members& members, const Progress& progress) {
  const Surface surface = surface_of(members);
  const BasePoint p = point_of(members, "p", surface);
  const BasePoint q = point_of(members, "q", surface);
  const certify::DistanceDocument found = unproved::distance(surface, p, q);
  return proved(found,
                Json::object({{"value", interval_json(found.distance)},
                              {"equal", found.equal},
                              {"paths", found.paths},
                              {"p", point_json(p)},
                              {"q", point_json(q)}}),
                progress);
}

Answer find_eigenvalues(const Members& members, const Progress& progress) {
  EigenvaluesOptions options{.threads = 1, .progress = progress};
  if (members.has("count") && members.has("below")) throw std::invalid_argument("below: not together with count");
  options.count = members.get<std::uint32_t>("count", options.count);
  if (members.has("below")) options.below = members.get<double>("below");
  if (members.has("digits")) options.digits = members.get<int>("digits");
  if (members.has("epsilon")) options.epsilon = members.length("epsilon");
  if (members.has("phases")) {
    if (!members.at("phases").is_array()) throw std::invalid_argument("phases: expected an array of numbers of turns");
    for (const Json& phase : members.at("phases")) options.phases.push_back(rational(phase, "phases"));
  }
  const certify::EigenvaluesDocument found = unproved::eigenvalues(surface_of(members), options);
  Json rows = Json::array();
  std::uint64_t first = found.phases.empty() ? 1 : 0;
  for (const auto& [in, count] : found.eigenvalues) {
    rows.push_back(Json::object({{"first", first}, {"count", count}, {"in", interval_json(in)}}));
    first += count;
  }
  return proved(found, Json::object({{"eigenvalues", std::move(rows)}, {"next", found.next}}), progress);
}

Json isometry_json(const SurfaceIsometry& isometry) {
  return Json::object({{"preserves_orientation", isometry.preserves_orientation}, {"images", isometry.images}});
}

Answer find_isometries(const Members& members, const Progress& progress) {
  const IsometryOptions options{.threads = 1, .progress = progress};
  const Surface surface = surface_of(members);
  const IsometryGroup group = isometries(surface, options);
  Json all = Json::array();
  for (std::uint32_t i = 0; i < group.size(); ++i) {
    Json& isometry = all.emplace_back(isometry_json(group.isometry(i)));
    isometry["order"] = group.order(i);
    if (const auto count = group.fixed_points(i)) isometry["fixed_points"] = *count;
  }
  return proved(certified_isometries(surface, group, options).document,
                Json::object({{"order", group.size()},
                              {"orientation_preserving", group.orientation_preserving()},
                              {"name", group.name()},
                              {"words", generator_words(surface)},
                              {"generators", group.generators()},
                              {"isometries", std::move(all)}}),
                progress);
}

Answer compare_surfaces(const Members& members, const Progress& progress) {
  const Surface first = surface_of(members);
  const IsometricAnswer found = isometric(first, surface_of(members, "other"), {.threads = 1, .progress = progress});
  constexpr const char* kKinds[] = {"yes", "no", "undecided"};
  Json json = Json::object({{"isometric", kKinds[static_cast<int>(found.kind)]}, {"reason", found.reason}});
  if (found.isometry) {
    json["words"] = generator_words(first);
    json["isometry"] = isometry_json(*found.isometry);
  }
  return {json_text(json)};
}

Answer find_pants(const Members& members, const Progress& progress) {
  PantsOptions options{.own = !members.get<bool>("find", false), .threads = 1, .progress = progress};
  if (members.has("curves")) options.curves = words_of(members, "curves");
  const PantsDecomposition found = pants_decomposition(surface_of(members), options);
  Json edges = Json::array();
  Json cuffs = Json::array();
  for (std::size_t e = 0; e < found.cuffs.size(); ++e) {
    const auto& [p, q] = found.graph.edges()[e];
    const PantsDecomposition::Cuff& cuff = found.cuffs[e];
    edges.push_back({p.pants, q.pants});
    cuffs.push_back(Json::object({{"ends", {{p.pants, p.cuff}, {q.pants, q.cuff}}},
                                  {"length", interval_json(cuff.length)},
                                  {"twist", interval_json(cuff.twist)},
                                  {"word", cuff.curve},
                                  {"across", cuff.across}}));
  }
  return proved(
      found.document,
      Json::object(
          {{"own", found.own}, {"edges", std::move(edges)}, {"cuffs", std::move(cuffs)}, {"pants", found.pants}}),
      progress);
}

/// The given curves come first in the document, then those of the homology basis.
Answer find_curves(const Members& members, const Progress& progress) {
  const certify::CurvesDocument found =
      unproved::curves(surface_of(members), words_of(members, "curves"), {.threads = 1, .progress = progress});
  Json curves = Json::array();
  for (const auto& curve : found.curves) {
    curves.push_back(Json::object({{"length", interval_json(curve.length)},
                                   {"power", curve.power},
                                   {"self_intersections", curve.self_intersections},
                                   {"homology", curve.homology},
                                   {"word", curve.word}}));
  }
  Json pairs = Json::array();
  for (const auto& pair : found.pairs) {
    pairs.push_back(Json::object({{"first", pair.first},
                                  {"second", pair.second},
                                  {"intersections", pair.intersections},
                                  {"algebraic", pair.algebraic}}));
  }
  return proved(found,
                Json::object({{"curves", std::move(curves)},
                              {"pairs", std::move(pairs)},
                              {"basis", found.basis},
                              {"fill", !found.filling.empty()}}),
                progress);
}

Answer find_dehn_twist_words(const Members& members) {
  const auto words = dehn_twist_words(surface_of(members), word_of(members.at("curve"), "curve"),
                                      members.get<std::int32_t>("power", 1));
  return {json_text(Json::object({{"words", std::vector<Word>(words)}}))};
}

Answer find_generators(const Members& members) {
  return {json_text(Json::object({{"words", generator_words(surface_of(members))}}))};
}

/// The domain as its file; docs/format.md, "Dirichlet domain".
Answer find_dirichlet_domain(const Members& members) {
  const Surface surface = surface_of(members);
  const auto base = members.has("base") ? std::optional(point_of(members, "base", surface)) : std::nullopt;
  return {"{}", {dirichlet_json(dirichlet_polygon(surface, base))}};
}

Answer draw(const Members& members) { return {"{}", {picture(members)}}; }

/// A net, from its file or from any file that is about one, and what is to be shown of it.
struct Shown {
  NetDocument net;
  ViewerOptions options;
};

Shown shown_net(const Members& members, const Progress& progress) {
  auto claim = certify::parse_file<ClaimDocument>(members.file("net"), kFile);
  std::vector<Layer> own;
  NetDocument net = std::visit(
      [&](auto& document) -> NetDocument {
        using Document = std::remove_cvref_t<decltype(document)>;
        if constexpr (std::is_same_v<Document, certify::DistanceDocument>) {
          own.push_back(distance_layer(document.net, document));
        } else if constexpr (std::is_same_v<Document, certify::GeodesicsDocument>) {
          own = geodesics_layers(document.net, document);
        }
        if constexpr (requires { document.net; }) {
          return std::move(document.net);
        } else {
          return std::move(document);
        }
      },
      claim);
  certify::CheckOptions check_options;
  check_options.threads = 1;
  check_options.progress = progress;
  ViewerOptions options{.title = members.get<std::string>("title", ""),
                        .certificate = certify::check(net, check_options),
                        .layers = standard_layers(net)};
  for (Layer& layer : own) options.layers.push_back(std::move(layer));
  for (Layer& layer : layers_of(members, net)) options.layers.push_back(std::move(layer));
  try {
    options.distances = distances_for_page(net, options.certificate);
  } catch (const Error&) {  // The page does without.
  }
  return {std::move(net), std::move(options)};
}

Answer make_page(const Members& members, const Progress& progress) {
  const Shown shown = shown_net(members, progress);
  return {"{}", {viewer_page(shown.net, shown.options)}};
}

Answer make_viewer_data(const Members& members, const Progress& progress) {
  const Shown shown = shown_net(members, progress);
  return {viewer_data(shown.net, shown.options)};
}

Answer about_net(const Members& members) { return {json_text(net_info(net_of(members)).json)}; }

Answer locate_point(const Members& members) {
  const NetDocument net = net_of(members);
  const Surface surface = from_document(net.surface);
  const PointLocation found = Locator(net).locate(point_of(members, "point", surface));
  constexpr const char* kPlaces[] = {"inside", "side", "corner"};
  return {json_text(Json::object({{"place", kPlaces[static_cast<int>(found.place)]},
                                  {"triangle", found.triangle},
                                  {"number", found.number},
                                  {"word", found.word},
                                  {"weights", found.weights},
                                  {"distances", found.distances},
                                  {"nearest", net.triangles[found.triangle].vertex[found.nearest_corner()]}}))};
}

Answer resolve_coordinates(const Members& members) {
  const FenchelNielsen found = resolve(parse_fenchel_nielsen(members.at("fenchel_nielsen").dump()));
  Json edges = Json::array();
  for (const PantsGraph::Edge& edge : found.graph.edges()) edges.push_back({edge[0].pants, edge[1].pants});
  const auto texts = [](const std::vector<Rational>& numbers) {
    Json result = Json::array();
    for (const Rational& x : numbers) result.push_back(x.str());
    return result;
  };
  return {json_text(Json::object({{"genus", found.graph.genus()},
                                  {"edges", std::move(edges)},
                                  {"lengths", texts(found.lengths)},
                                  {"twists", texts(found.twists)}}))};
}

Answer list_names() {
  Json names = Json::array();
  for (const NamedSurface& surface : named_surfaces()) {
    names.push_back(Json::object({{"name", surface.name}, {"description", surface.description}}));
  }
  return {json_text(Json::object({{"version", EPSNET_VERSION}, {"names", std::move(names)}}))};
}

Answer answer_or_throw(const Request& request, const Progress& progress) {
  if (!request.what.is_object()) throw std::invalid_argument("the request is not a JSON object");
  const Members members(request);
  const std::map<std::string, std::function<Answer()>> requests{
      {"about", [] { return list_names(); }},
      {"surface", [&] { return about_surface(members); }},
      {"coordinates", [&] { return resolve_coordinates(members); }},
      {"net", [&] { return make_net(members, progress); }},
      {"info", [&] { return about_net(members); }},
      {"locate", [&] { return locate_point(members); }},
      {"certify", [&] { return check_file(members, progress); }},
      {"systole", [&] { return find_geodesics(members, progress); }},
      {"spectrum", [&] { return find_geodesics(members, progress); }},
      {"thick-thin", [&] { return find_geodesics(members, progress); }},
      {"diameter", [&] { return find_bound(members, progress); }},
      {"radius", [&] { return find_bound(members, progress); }},
      {"embedded-disk", [&] { return find_bound(members, progress); }},
      {"distance", [&] { return measure_distance(members, progress); }},
      {"eigenvalues", [&] { return find_eigenvalues(members, progress); }},
      {"isometries", [&] { return find_isometries(members, progress); }},
      {"isometric", [&] { return compare_surfaces(members, progress); }},
      {"pants", [&] { return find_pants(members, progress); }},
      {"curves", [&] { return find_curves(members, progress); }},
      {"dehn-twist-words", [&] { return find_dehn_twist_words(members); }},
      {"generators", [&] { return find_generators(members); }},
      {"dirichlet", [&] { return find_dirichlet_domain(members); }},
      {"svg", [&] { return draw(members); }},
      {"page", [&] { return make_page(members, progress); }},
      {"viewer", [&] { return make_viewer_data(members, progress); }}};
  const auto what = members.get<std::string>("do");
  const auto found = requests.find(what);
  if (found == requests.end()) throw std::invalid_argument("do: there is no request " + certify::in_quotes(what));
  return found->second();
}

Answer failure(const char* kind, const std::string& message) {
  return {json_text(Json::object({{"error", {{"kind", kind}, {"message", certify::printable(message)}}}}))};
}

}  // namespace

Answer answer(const Request& request, const Progress& progress) {
  try {
    return answer_or_throw(request, progress);
  } catch (const std::bad_alloc&) {
    return failure("MemoryError", "not enough memory: a browser gives a page 4 GiB at most");
  } catch (const SurfaceError& error) {
    return failure("SurfaceError", error.what());
  } catch (const FenchelNielsenRequestError& error) {
    return failure("SurfaceError", error.what());
  } catch (const CurveError& error) {
    return failure("ArgumentError", error.what());
  } catch (const CharacterError& error) {
    return failure("ArgumentError", error.what());
  } catch (const PantsGraphError& error) {
    return failure("SurfaceError", error.what());
  } catch (const NetError& error) {
    return failure("NetError", error.what());
  } catch (const NetGeometryError& error) {
    return failure("NetError", error.what());
  } catch (const LimitError& error) {
    return failure("LimitError", error.what());
  } catch (const ExchangeError& error) {
    return failure("FormatError", error.what());
  } catch (const certify::MalformedError& error) {
    return failure("FormatError", error.what());
  } catch (const DirichletFileError& error) {
    return failure("FormatError", error.what());
  } catch (const certify::Fault& fault) {
    return failure("EpsnetError", fault.what());
  } catch (const Error& error) {
    return failure("EpsnetError", error.what());
  } catch (const std::invalid_argument& error) {
    return failure("ArgumentError", error.what());
  } catch (const std::exception& error) {
    return failure("EpsnetError", error.what());
  }
}

}  // namespace epsnet::wasm
