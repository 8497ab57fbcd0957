#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/file/file.h"
#include "certify/file/json.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/number_field.h"
#include "triangulation/surface/exact_polygons.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

/// Of the multiple of a length, and of the denominator.
constexpr unsigned kMostTimes = 64;

[[noreturn]] void fail_length(std::string_view text) {
  throw SurfaceError(
      "expected a length such as 0.5, 2*arcosh(3/2), 2*arsinh(1) or log(3)/2, the multiple at most 64 "
      "and its denominator a power of 2, not " +
      certify::in_quotes(text));
}

/// Where the parenthesis that is open before `first` is closed; npos, if it is not.
std::size_t closing(std::string_view text, std::size_t first) {
  int depth = 1;
  for (std::size_t i = first; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i;
  }
  return std::string_view::npos;
}

/// The fraction in front of a function, as in "2*", "-", "1/2*" or "".
std::optional<Rational> fraction_before(std::string_view text) {
  if (text.empty()) return 1;
  if (text == "-") return -1;
  if (!text.ends_with('*')) return std::nullopt;
  return parse_decimal(text.substr(0, text.size() - 1));
}

/// The fraction behind a function, as in "/2", "*3" or "".
std::optional<Rational> fraction_after(std::string_view text) {
  if (text.empty()) return 1;
  std::optional<Rational> number = parse_decimal(text.substr(1));
  if (!number || *number == 0 || (text[0] != '*' && text[0] != '/')) return std::nullopt;
  return text[0] == '*' ? *number : Rational(1 / *number);
}

bool is_power_of_2(const Integer& x) { return x > 0 && boost::multiprecision::lsb(x) == boost::multiprecision::msb(x); }

/// The coefficients of the Chebyshev polynomial, from that of 1 on: cosh(nx) = T(cosh x).
std::vector<Integer> chebyshev(unsigned n) {
  std::vector<Integer> before{1};
  std::vector<Integer> now{0, 1};
  if (n == 0) return before;
  for (unsigned i = 1; i < n; ++i) {
    std::vector<Integer> next(now.size() + 1);
    for (std::size_t k = 0; k < now.size(); ++k) next[k + 1] += 2 * now[k];
    for (std::size_t k = 0; k < before.size(); ++k) next[k] -= before[k];
    before = std::exchange(now, std::move(next));
  }
  return now;
}

}  // namespace

std::optional<ExactLength> parse_exact_length(std::string_view given) {
  std::string text;
  for (const char c : given) {
    if (c != ' ') text += c;
  }
  for (const std::string_view name : {"arcosh(", "arsinh(", "log("}) {
    const std::size_t start = text.find(name);
    if (start == std::string::npos) continue;
    const std::size_t first = start + name.size();
    const std::size_t end = closing(text, first);
    if (end == std::string::npos) fail_length(given);
    const std::string x = "(" + text.substr(first, end - first) + ")";
    const auto before = fraction_before(std::string_view(text).substr(0, start));
    const auto after = fraction_after(std::string_view(text).substr(end + 1));
    if (!before || !after) fail_length(given);
    ExactLength result{x, *before * *after, 0};
    // 2 arsinh(x) = arcosh(1 + 2x²), and log(x) = arcosh((x + 1/x)/2).
    if (name == "arsinh(") {
      result.cosh = "(1+2*" + x + "^2)";
      result.times /= 2;
    } else if (name == "log(") {
      result.cosh = "((" + x + "+1/" + x + ")/2)";
    }
    if (!is_power_of_2(denominator(result.times)) || denominator(result.times) > kMostTimes ||
        abs(result.times) > kMostTimes) {
      fail_length(given);
    }
    const Mp1024 sign = name == "arcosh(" ? Mp1024(1) : real_value(x) - (name == "log(" ? 1 : 0);
    const Mp1024 cosh = real_value(result.cosh);
    if (name == "log(" && sign <= -1) {
      throw SurfaceError("the log of a number that is not positive in " + certify::in_quotes(given));
    }
    if (cosh < 1) throw SurfaceError("the arcosh of a number that is less than 1 in " + certify::in_quotes(given));
    if (sign < 0) result.times = -result.times;
    result.approximate = result.times * Rational(Mp1024(acosh(cosh)));
    return result;
  }
  return std::nullopt;
}

std::string cosh_text(const ExactLength& length, const Rational& factor) {
  const Rational times = abs(Rational(length.times * factor));
  std::string x = length.cosh;
  for (Integer halves = denominator(times); halves > 1; halves /= 2) x = "(sqrt(2*" + x + "+2)/2)";
  const auto n = static_cast<unsigned>(numerator(times));
  if (n == 1) return x;
  const std::vector<Integer> coefficients = chebyshev(n);
  std::string result;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    if (coefficients[k] == 0) continue;
    if (!result.empty()) result += '+';
    result += "(" + coefficients[k].str() + ")*" + x + "^" + std::to_string(k);
  }
  return "(" + result + ")";
}

std::optional<Rational> rational_value(const std::string& text) {
  NumberFieldReader reader;
  reader.add(text);
  const RationalPolynomial& x = reader.numbers().back();
  if (fmpq_poly_degree(x.get()) > 0) return std::nullopt;
  if (fmpq_poly_length(x.get()) == 0) return 0;
  certify::Integer above;
  fmpz_set(above.get(), fmpq_poly_numref(x.get()));
  mpq_class result(above.value(), denominator_of(x));
  result.canonicalize();
  return from_gmp(result);
}

Mp1024 real_value(const std::string& text) {
  NumberFieldReader reader;
  reader.add(text);
  const certify::Ball value = reader.value(reader.numbers().back());
  Mp1024 result;
  arf_get_mpfr(result.backend().data(), arb_midref(value.get()), MPFR_RNDN);
  return result;
}

namespace {

using RequestError = FenchelNielsenRequestError;

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 40;
  return "\"" + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "...\"" : "\"");
}

/// The seed, which draws all that is not given.
std::uint64_t seed_of(const FenchelNielsenRequest& request) {
  if (request.seed) return *request.seed;
  std::string missing;
  const auto add = [&](const char* what) { missing += (missing.empty() ? "" : " and ") + std::string(what); };
  if (request.graph.empty() || request.graph == "random") add("a pants graph");
  if (request.lengths.empty()) add("lengths");
  if (request.twists.empty()) add("twists");
  throw RequestError("seed", "needed to draw " + missing + ", or give them");
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

bool has_edges(const std::string& graph) { return graph.find_first_of("0123456789") != std::string::npos; }

bool has_all_coordinates(const FenchelNielsenRequest& request) {
  return !request.lengths.empty() && !request.twists.empty();
}

/// Adds what lists and graph imply: the genus, of which lists have 3g - 3 numbers, and theta has 2; for genus 2 the
/// graph theta, if nothing is to be drawn.
FenchelNielsenRequest completed(FenchelNielsenRequest request) {
  const std::size_t edges = std::max(request.lengths.size(), request.twists.size());
  if (!request.genus && !has_edges(request.graph) && edges > 1 && edges % 3 == 0)
    request.genus = static_cast<std::uint32_t>(edges / 3 + 1);
  if (!request.genus && request.graph == "theta") request.genus = 2;
  if (request.graph.empty() && !request.seed && request.genus == 2 && has_all_coordinates(request))
    request.graph = "theta";
  return request;
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
  if (graph == "theta") {
    if (genus_of(request) != 2) throw RequestError("graph", "theta is a graph for genus 2; for others there is ring");
    return PantsGraph({{0, 1}, {0, 1}, {0, 1}});
  }
  if (!has_edges(graph)) {
    throw RequestError(
        "graph", "expected chain, ring, tree, theta, random or edges such as \"0-1 0-1 0-1\", not " + in_quotes(graph));
  }
  PantsGraph edges = blaming("graph", [&] { return PantsGraph::parse(graph); });
  if (request.genus && *request.genus != edges.genus()) {
    throw RequestError(
        "genus", std::to_string(*request.genus) + ", but the pants graph has genus " + std::to_string(edges.genus()));
  }
  return edges;
}

/// Reads an exact length, if it is one.
std::optional<ExactLength> exact_length(const std::string& text, const char* what) {
  try {
    return parse_exact_length(text);
  } catch (const SurfaceError& error) {
    throw RequestError(what, error.what());
  }
}

/// Lengths or twists: their values, and those that are exact.
struct Lengths {
  std::vector<Rational> values;
  std::vector<std::optional<ExactLength>> exact;  ///< Empty, if none is.
};

/// Returns one length for each edge; a single text stands for all.
Lengths read_lengths(const std::vector<std::string>& texts, const char* what, std::size_t edges) {
  Lengths result;
  for (const std::string& text : texts) {
    const std::optional<ExactLength> exact = exact_length(text, what);
    const std::optional<Rational> value = exact ? exact->approximate : parse_decimal(text);
    if (!value) {
      throw RequestError(what, "expected a number such as 0.5, -1e-3 or 1/3, or 2*arcosh(3/2), not " + in_quotes(text));
    }
    result.values.push_back(*value);
    result.exact.push_back(exact);
  }
  if (result.values.size() == 1) {
    result.values.resize(edges, result.values.front());
    result.exact.resize(edges, result.exact.front());
  }
  if (result.values.size() != edges) {
    throw RequestError(what, "expected 1 or " + std::to_string(edges) + ", one for each edge of the graph, not " +
                                 std::to_string(result.values.size()));
  }
  if (std::none_of(result.exact.begin(), result.exact.end(), [](const auto& x) { return x.has_value(); }))
    result.exact.clear();
  return result;
}

/// Thrown by the reader where a text is no request, but a file that names its format.
struct IsPantsFile {};

/// Reads a request and nothing else. Throws RequestError, or JsonError.
class Reader {
 public:
  explicit Reader(certify::ByteStream& text) : json_(text) {}

  FenchelNielsenRequest read() {
    FenchelNielsenRequest request;
    std::set<std::string> seen;
    take('{', "an object with members graph, genus, seed, lengths, twists");
    json_.members([&](std::string_view name) {
      const auto [place, is_new] = seen.emplace(name);
      const std::string& member = *place;
      if (!is_new) throw RequestError("member " + in_quotes(member) + " occurs twice");
      if (member == "graph") {
        if (json_.next() != '"') fail_to_find("graph: a string");
        request.graph = json_.string();
      } else if (member == "genus") {
        request.genus = static_cast<std::uint32_t>(std::min<std::uint64_t>(integer(member), ~std::uint32_t{0}));
      } else if (member == "seed") {
        request.seed = integer(member);
      } else if (member == "lengths") {
        request.lengths = decimals(member);
      } else if (member == "twists") {
        request.twists = decimals(member);
      } else if (member == "format") {
        throw IsPantsFile();
      } else {
        throw RequestError("unknown member " + in_quotes(member) + ", expected graph, genus, seed, lengths or twists");
      }
    });
    if (!json_.at_end()) throw RequestError("something follows the object");
    return request;
  }

 private:
  [[noreturn]] void fail_to_find(const std::string& expected) {
    throw RequestError("expected " + expected + ", not " + json_.found());
  }

  void take(char mark, const std::string& expected) {
    if (!json_.take(mark)) fail_to_find(expected);
  }

  /// A number or literal. Not empty.
  std::string token(const std::string& expected) {
    const std::string_view token = json_.token();
    if (token.empty()) fail_to_find(expected);
    return std::string(token);
  }

  std::uint64_t integer(const std::string& member) {
    const std::string text = token(member + ": an integer");
    std::uint64_t value = 0;
    const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && last == text.data() + text.size();
    if (whole && (text.front() != '0' || text.size() == 1)) return value;
    throw RequestError("expected " + member + ": an integer from 0 to 2^64 - 1, not " + in_quotes(text));
  }

  /// Returns decimals as written, whether as bare numbers or as strings.
  std::vector<std::string> decimals(const std::string& member) {
    std::vector<std::string> result;
    take('[', member + ": an array of numbers");
    json_.elements([&](std::size_t) {
      const bool bare = json_.next() != '"';
      result.push_back(bare ? token(member + ": a number") : std::string(json_.string()));
    });
    return result;
  }

  certify::Json json_;
};

/// The coordinates in a pants file: the middles of its intervals.
FenchelNielsenRequest request_of(const certify::PantsDocument& document) {
  FenchelNielsenRequest result;
  const auto middle = [](certify::Interval x) { return certify::shortest(x.lower + (x.upper - x.lower) / 2); };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const certify::PantsDocument::Cuff& cuff : document.cuffs) {
    edges.emplace_back(cuff.ends[0][0], cuff.ends[1][0]);
    if (!result.graph.empty()) result.graph += ' ';
    result.graph += std::to_string(edges.back().first) + '-' + std::to_string(edges.back().second);
    result.lengths.push_back(middle(cuff.length));
    result.twists.push_back(middle(cuff.twist));
  }
  const PantsGraph graph = blaming("graph", [&] { return PantsGraph(edges); });
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& [pants, cuff] = graph.edges()[e][i];
      if (document.cuffs[e].ends[i] == certify::PantsDocument::End{pants, cuff}) continue;
      throw RequestError("cuffs[" + std::to_string(e) + "]", "cuffs of a pair of pants are not in the order 0, 1, 2");
    }
  }
  return result;
}

}  // namespace

FenchelNielsen resolve(const FenchelNielsenRequest& given) {
  const FenchelNielsenRequest request = completed(given);
  std::optional<PantsGraph> graph = graph_of(request);
  const std::size_t edges = graph ? graph->edges().size() : 3 * std::size_t{genus_of(request)} - 3;
  const bool draw_lengths = request.lengths.empty();
  const bool draw_twists = request.twists.empty();
  Lengths lengths, twists;
  if (!draw_lengths) lengths = read_lengths(request.lengths, "lengths", edges);
  if (!draw_twists) twists = read_lengths(request.twists, "twists", edges);
  // All given values are valid; the missing ones are drawn.
  if (request.graph.empty() && !request.seed && has_all_coordinates(request)) {
    throw RequestError("graph",
                       "needed for these lengths and twists: chain, ring, tree, edges such as \"0-1 0-1 0-1\", or "
                       "random, with a seed");
  }
  if (!graph) graph = PantsGraph::random(genus_of(request), seed_of(request));
  if (draw_lengths || draw_twists) {
    FenchelNielsen drawn = random_coordinates(*graph, seed_of(request));
    if (draw_twists) {
      twists.values = std::move(drawn.twists);
      // Twists are drawn as shares of the length.
      for (std::size_t e = 0; e < edges && !draw_lengths; ++e) twists.values[e] *= lengths.values[e] / drawn.lengths[e];
    }
    if (draw_lengths) lengths.values = std::move(drawn.lengths);
  }
  return {*std::move(graph), std::move(lengths.values), std::move(twists.values), std::move(lengths.exact),
          std::move(twists.exact)};
}

FenchelNielsenRequest parse_fenchel_nielsen(const std::string& text) {
  certify::ByteStream bytes(text);
  try {
    return Reader(bytes).read();
  } catch (const certify::JsonError& error) {
    throw RequestError(std::string("not JSON: ") + error.what());
  } catch (const IsPantsFile&) {
    try {
      return request_of(certify::parse_file<certify::PantsDocument>(text, ""));
    } catch (const certify::MalformedError& error) {
      throw RequestError(error.what());  // Without the name of the file, which whoever read it knows.
    }
  }
}

}  // namespace epsnet
