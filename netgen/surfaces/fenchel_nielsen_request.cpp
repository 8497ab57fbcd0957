#include "netgen/surfaces/fenchel_nielsen_request.h"

#include <algorithm>
#include <set>
#include <simdjson.h>
#include <utility>

#include "netgen/base/gmp.h"

namespace epsnet {
namespace {

using RequestError = FenchelNielsenRequestError;

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 40;
  return "\"" + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "...\"" : "\"");
}

std::uint64_t seed_of(const FenchelNielsenRequest& request, const char* what) {
  if (!request.seed) {
    throw RequestError("seed", std::string("needed to draw the ") + what);
  }
  return *request.seed;
}

/// Returns the result of `make`; attributes its errors to a member.
template <class Make>
auto blaming(const char* member, const Make& make) {
  try {
    return make();
  } catch (const PantsGraphError& error) {
    throw RequestError(member, error.what());
  }
}

/// Returns the genus of a request whose graph does not determine it. Throws if it is missing or out of range.
std::uint32_t genus_of(const FenchelNielsenRequest& request) {
  if (!request.genus) {
    throw RequestError("genus", "needed for the pants graph " +
                                    in_quotes(request.graph.empty() ? std::string("random") : request.graph));
  }
  (void)blaming("genus", [&] { return PantsGraph::chain(*request.genus); });
  return *request.genus;
}

/// Returns the graph; nullopt for a random one, which is drawn later.
std::optional<PantsGraph> graph_of(const FenchelNielsenRequest& request) {
  const std::string& graph = request.graph;
  if (graph.empty() || graph == "random") {
    return std::nullopt;
  }
  if (graph == "chain") {
    return PantsGraph::chain(genus_of(request));
  }
  if (graph == "ring") {
    return PantsGraph::ring(genus_of(request));
  }
  if (graph == "tree") {
    return PantsGraph::tree(genus_of(request));
  }
  if (graph.find_first_of("0123456789") == std::string::npos) {
    throw RequestError("graph",
                       "expected chain, ring, tree, random or edges such as \"0-1 0-1 0-1\", not " + in_quotes(graph));
  }
  PantsGraph edges = blaming("graph", [&] { return PantsGraph::parse(graph); });
  if (request.genus && *request.genus != edges.genus()) {
    throw RequestError(
        "genus", std::to_string(*request.genus) + ", but the pants graph has genus " + std::to_string(edges.genus()));
  }
  return edges;
}

/// Returns one number for each edge; a single text stands for all.
std::vector<Rational> numbers(const std::vector<std::string>& texts, const char* what, std::size_t edges) {
  std::vector<Rational> result;
  for (const std::string& text : texts) {
    const std::optional<Rational> value = parse_decimal(text);
    if (!value) {
      throw RequestError(what, "expected a number such as 0.5, -1e-3 or 1/3, not " + in_quotes(text));
    }
    result.push_back(*value);
  }
  if (result.size() == 1) {
    result.resize(edges, result.front());
  }
  if (result.size() != edges) {
    throw RequestError(what, "expected 1 or " + std::to_string(edges) + ", one for each edge of the graph, not " +
                                 std::to_string(result.size()));
  }
  return result;
}

/// Reads a request with simdjson.
class Reader {
 public:
  FenchelNielsenRequest read(simdjson::ondemand::document& document) {
    FenchelNielsenRequest request;
    std::set<std::string> seen;
    for (auto field : object(document)) {
      const std::string key(take(field.unescaped_key(), "a member's name"));
      if (!seen.insert(key).second) {
        throw RequestError("member " + in_quotes(key) + " occurs twice");
      }
      simdjson::ondemand::value value = take(field.value(), key);
      if (key == "graph") {
        request.graph = std::string(take(value.get_string(), "graph: a string"));
      } else if (key == "genus") {
        const std::uint64_t genus = take(value.get_uint64(), "genus: an integer");
        request.genus = static_cast<std::uint32_t>(std::min<std::uint64_t>(genus, ~std::uint32_t{0}));
      } else if (key == "seed") {
        request.seed = take(value.get_uint64(), "seed: an integer");
      } else if (key == "lengths") {
        request.lengths = texts(value, key);
      } else if (key == "twists") {
        request.twists = texts(value, key);
      } else {
        throw RequestError("unknown member " + in_quotes(key) + ", expected graph, genus, seed, lengths or twists");
      }
    }
    if (document.current_location().error() != simdjson::OUT_OF_BOUNDS) {
      throw RequestError("something follows the object");
    }
    return request;
  }

 private:
  static simdjson::ondemand::object object(simdjson::ondemand::document& document) {
    return take(document.get_object(), "an object with members graph, genus, seed, lengths, twists");
  }

  template <class T>
  static T take(simdjson::simdjson_result<T> result, std::string_view expected) {
    T value;
    if (const auto error = std::move(result).get(value)) {
      throw RequestError("expected " + std::string(expected) + " (" + simdjson::error_message(error) + ")");
    }
    return value;
  }

  /// Returns decimals as written, whether as bare numbers or as strings.
  static std::vector<std::string> texts(simdjson::ondemand::value value, const std::string& key) {
    std::vector<std::string> result;
    for (auto item : take(value.get_array(), key + ": an array of numbers")) {
      simdjson::ondemand::value element = take<simdjson::ondemand::value>(item, key + ": a number");
      std::string_view text;
      if (element.get_string().get(text)) {
        text = element.raw_json_token();
        while (!text.empty() &&
               (text.back() == ' ' || text.back() == '\n' || text.back() == '\t' || text.back() == '\r')) {
          text.remove_suffix(1);
        }
      }
      result.emplace_back(text);
    }
    return result;
  }
};

}  // namespace

FenchelNielsen resolve(const FenchelNielsenRequest& request) {
  std::optional<PantsGraph> graph = graph_of(request);
  const std::size_t edges = graph ? graph->edges().size() : 3 * std::size_t{genus_of(request)} - 3;
  const bool draw_lengths = request.lengths.empty();
  const bool draw_twists = request.twists.empty();
  std::vector<Rational> lengths, twists;
  if (!draw_lengths) lengths = numbers(request.lengths, "lengths", edges);
  if (!draw_twists) twists = numbers(request.twists, "twists", edges);
  // All given values are valid; the missing ones are drawn.
  if (!graph) graph = PantsGraph::random(genus_of(request), seed_of(request, "pants graph"));
  if (draw_lengths || draw_twists) {
    const char* what = !draw_lengths ? "twists" : !draw_twists ? "lengths" : "lengths and twists";
    FenchelNielsen drawn = random_coordinates(*graph, seed_of(request, what));
    if (draw_twists) {
      twists = std::move(drawn.twists);
      // Twists are drawn as shares of the length.
      for (std::size_t e = 0; e < edges && !draw_lengths; ++e) twists[e] *= lengths[e] / drawn.lengths[e];
    }
    if (draw_lengths) lengths = std::move(drawn.lengths);
  }
  return {*std::move(graph), std::move(lengths), std::move(twists)};
}

FenchelNielsenRequest parse_fenchel_nielsen(const std::string& text) {
  const simdjson::padded_string padded(text);
  simdjson::ondemand::parser parser;
  simdjson::ondemand::document document;
  if (const auto problem = parser.iterate(padded).get(document)) {
    throw RequestError(std::string("not JSON: ") + simdjson::error_message(problem));
  }
  return Reader().read(document);
}

}  // namespace epsnet
