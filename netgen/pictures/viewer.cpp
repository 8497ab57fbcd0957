#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <string_view>
#include <utility>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/numbers.h"
#include "netgen/lifts/lifts.h"
#include "netgen/pictures/curves.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg.h"

namespace epsnet {

/// The text of viewer/viewer.html with the files that it names: the page, with places for its data (cmake/embed.cmake).
extern const std::string_view kViewerPage;

namespace {

/// Returns a text as a JSON string for a script of an HTML page, where "<" must be escaped as it would start a tag.
std::string json_string(std::string_view text) {
  constexpr std::string_view kHexadecimal = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7f || c == '<' || c == '>' || c == '&' || c == '"' || c == '\\') {
      result += "\\u00";
      result += kHexadecimal[code / 16];
      result += kHexadecimal[code % 16];
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// Returns the bytes of numbers, least significant first, in base 64 (RFC 4648), as a JSON string.
template <class Number>
std::string base64(const std::vector<Number>& numbers) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes(numbers.size() * sizeof(Number));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  std::string result = "\"";
  result.reserve(bytes.size() / 3 * 4 + 8);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) result += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return result + '"';
}

/// The labels of edges: by dart, the isometry from the chart of its end to that of its start.
struct EdgeLabels {
  std::vector<double> isometries{1, 0, 0, 0};  ///< Four numbers each: a, b of determinant 1. The first is the identity.
  std::vector<std::uint32_t> pairs;            ///< Dart and number, for all that are not the identity.
};

EdgeLabels edge_labels(const NetGeometry& geometry) {
  EdgeLabels result;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  const std::size_t darts = 3 * geometry.document().triangles.size();
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    const std::uint32_t at_start = certify::corner_label(geometry.document(), dart);
    const std::uint32_t at_end = certify::corner_label(geometry.document(), certify::next_dart(dart));
    if (at_start == at_end) continue;
    const auto [entry, is_new] =
        numbers.try_emplace({at_start, at_end}, static_cast<std::uint32_t>(result.isometries.size() / 4));
    if (is_new) {
      const auto f =
          convert<double>(normalized(inverse(geometry.label(at_start).precise) * geometry.label(at_end).precise));
      result.isometries.insert(result.isometries.end(), {f.a.x, f.a.y, f.b.x, f.b.y});
    }
    result.pairs.insert(result.pairs.end(), {dart, entry->second});
  }
  return result;
}

std::string layer_json(const Layer& layer) {
  std::string out = "{\"name\": " + json_string(layer.name) + ", \"colour\": " + json_string(layer.colour) +
                    ", \"on\": " + (layer.on ? "true" : "false");
  if (!layer.arcs.empty()) {
    std::vector<std::uint32_t> darts;
    std::vector<double> ends;
    for (const Arc& arc : layer.arcs) {
      darts.push_back(arc.dart);
      ends.insert(ends.end(), {arc.from.x, arc.from.y, arc.to.x, arc.to.y});
    }
    out += ", \"arcs\": " + base64(darts) + ", \"ends\": " + base64(ends);
  }
  if (!layer.darts.empty()) out += ", \"darts\": " + base64(layer.darts);
  if (!layer.triangles.empty()) out += ", \"triangles\": " + base64(layer.triangles);
  if (!layer.parts.empty()) {
    std::string parts;
    for (const Layer::Part& part : layer.parts) {
      parts += (parts.empty() ? "[" : ", [") + json_string(part.name) + ", " + certify::shortest(part.length) + ", " +
               std::to_string(part.first_arc) + "]";
    }
    out += ", \"parts\": [" + parts + "]";
  }
  return out + "}";
}

/// The colours of everything that a page can show.
std::string palette_json() {
  return "{\"edges\": " + json_string(palette::kEdges) + ", \"vertices\": " + json_string(palette::kVertices) +
         ", \"centre\": " + json_string(palette::kCentre) + ", \"covering\": " + json_string(palette::kCoveringDisks) +
         ", \"packing\": " + json_string(palette::kPackingDisks) +
         ", \"dirichlet\": " + json_string(palette::kDirichlet) + "}";
}

/// Returns a margin to be read by people: a lower bound of the difference, in four digits.
std::string margin(double greater, double less) {
  const Mp256 difference = Mp256(greater) - Mp256(less);
  const auto rounded = static_cast<double>(difference);
  const double below = rounded <= difference ? rounded : std::nextafter(rounded, -HUGE_VAL);
  return certify::decimal_below(below, 4);
}

/// Rows of names and values.
class Facts {
 public:
  void add(std::string_view name, std::string_view value) {
    out_ += (out_.empty() ? "[" : ", [") + json_string(name) + ", " + json_string(value) + "]";
  }
  [[nodiscard]] std::string json() const { return "[" + out_ + "]"; }

 private:
  std::string out_;
};

std::string facts_json(const NetGeometry& geometry, const ViewerOptions& options) {
  const std::optional<certify::Certificate>& certificate = options.certificate;
  const certify::NetDocument& document = geometry.document();
  Facts facts;
  facts.add("ε", geometry.epsilon_text());
  facts.add("genus", std::to_string(geometry.genus()));
  facts.add("vertices", std::to_string(document.vertices.size()));
  facts.add("triangles", std::to_string(document.triangles.size()));
  for (const Layer& layer : options.layers) {
    if (!layer.left_out.empty()) facts.add("left out", layer.name + ": " + layer.left_out);
  }
  if (!certificate || !certificate->enclosures) return facts.json();
  const certify::Enclosures& enclosures = *certificate->enclosures;
  facts.add("circumradii ≤", certify::decimal_above(enclosures.largest_circumradius.upper));
  facts.add("margin to ε ≥", margin(enclosures.epsilon.lower, enclosures.largest_circumradius.upper));
  if (enclosures.shortest_edge) {
    facts.add("edges, no loops, ≥", certify::decimal_below(enclosures.shortest_edge->lower));
    facts.add("margin to ε ≥", margin(enclosures.shortest_edge->lower, enclosures.epsilon.upper));
  }
  if (enclosures.shortest_loop) facts.add("loops ≥", certify::decimal_below(enclosures.shortest_loop->lower));
  return facts.json();
}

/// JSON has no infinity, and a net of one vertex may have any ε.
constexpr double kLargestEpsilon = 1e300;

std::string net_json(const NetGeometry& geometry, const ViewerOptions& options) {
  const certify::NetDocument& document = geometry.document();
  const std::optional<certify::Certificate>& certificate = options.certificate;
  std::vector<std::uint32_t> opposite;
  std::vector<std::uint32_t> vertex_darts(document.vertices.size(), 0);
  for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      opposite.push_back(document.triangles[t].opposite[i]);
      vertex_darts[document.triangles[t].vertex[i]] = 3 * t + i;
    }
  }
  std::vector<double> points;
  std::vector<std::uint32_t> charts;
  for (const certify::NetDocument::Vertex& v : document.vertices) {
    points.insert(points.end(), {v.x, v.y});
    charts.push_back(v.chart);
  }
  const EdgeLabels labels = edge_labels(geometry);
  std::string layers;
  for (const Layer& layer : options.layers) {
    if (layer.left_out.empty()) layers += (layers.empty() ? "" : ",\n") + layer_json(layer);
  }
  return "{\"title\": " + json_string(options.title) +
         ", \"verdict\": " + json_string(certificate ? certify::name(certificate->verdict) : "not certified") +
         ", \"message\": " +
         json_string(!certificate || certificate->message.empty() ? ""
                                                                  : certificate->rule + ": " + certificate->message) +
         ",\n\"epsilon\": " + certify::shortest(std::min(geometry.epsilon().get_d(), kLargestEpsilon)) +
         ", \"facts\": " + facts_json(geometry, options) + ",\n\"palette\": " + palette_json() +
         ",\n\"opposite\": " + base64(opposite) + ",\n\"vertex_darts\": " + base64(vertex_darts) +
         ",\n\"points\": " + base64(points) + ",\n\"charts\": " + base64(charts) +
         ",\n\"isometries\": " + base64(labels.isometries) + ",\n\"edge_labels\": " + base64(labels.pairs) +
         ",\n\"distances\": " + base64(std::vector<float>(options.distances.begin(), options.distances.end())) +
         ",\n\"layers\": [" + layers + "]}\n";
}

}  // namespace

std::vector<Layer> standard_layers(const certify::NetDocument& document) {
  const NetGeometry geometry(document);
  std::vector<Layer> layers;
  const auto add = [&](const char* name, const auto& make) {
    try {
      layers.push_back(make());
    } catch (const NetGeometryError& error) {
      layers.push_back({.name = name, .colour = "", .left_out = error.what()});
    }
    layers.back().on = false;
  };
  add("fundamental tiles", [&] { return tile_layer(geometry); });
  add("Dirichlet domain", [&] { return dirichlet_layer(geometry, 0); });
  add("combinatorial Dirichlet domain", [&] { return combinatorial_dirichlet_layer(geometry, 0); });
  for (Layer& layer : collar_layers(geometry)) layers.push_back(std::move(layer));
  return layers;
}

std::string viewer_data(const certify::NetDocument& document, const ViewerOptions& options) {
  return net_json(NetGeometry(document), options);
}

std::string viewer_page(const certify::NetDocument& document, const ViewerOptions& options) {
  std::string page(kViewerPage);
  const auto put = [&](std::string_view mark, const std::string& text) {
    page.replace(page.find(mark), mark.size(), text);
  };
  put("@DATA@", viewer_data(document, options));
  put("@TITLE@", html_text(options.title));
  return page;
}

}  // namespace epsnet
