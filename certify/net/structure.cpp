#include "certify/net/structure.h"

#include <cmath>
#include <limits>

#include "certify/base/text.h"

namespace epsnet::certify {
namespace {

using Problem = std::optional<std::string>;

std::string out_of_range(const char* what, std::size_t index, std::size_t size) {
  return std::string(what) + " " + std::to_string(index) + " does not exist, expected less than " +
         std::to_string(size);
}

std::uint64_t digits(const mpq_class& x) {
  const std::uint64_t numerator = mpz_sizeinbase(x.get_num_mpz_t(), 10);
  return x.get_den() == 1 ? numerator : numerator + mpz_sizeinbase(x.get_den_mpz_t(), 10);
}

/// x² + y² < 1, exactly. The binary64 sum is within 2⁻⁵⁰ of the true one while that is at most 2, and above 1 where it
/// is more.
bool inside_disk(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return false;
  const double square = x * x + y * y;
  if (square < 1 - 1e-14) return true;
  const mpq_class exact_x(x);
  const mpq_class exact_y(y);
  return exact_x * exact_x + exact_y * exact_y < 1;
}

Problem gluing_problem(const SurfaceDocument& surface) {
  std::vector<std::vector<bool>> glued;
  glued.reserve(surface.tiles.size());
  std::size_t sides = 0;
  for (std::size_t t = 0; t < surface.tiles.size(); ++t) {
    const std::size_t size = surface.tiles[t].size();
    if (size < 3) return at("surface.tiles", t) + "has " + std::to_string(size) + " vertices, expected at least 3";
    glued.emplace_back(size, false);
    sides += size;
  }
  if (sides == 0) return "surface.tiles: no tile, expected at least one";
  if (sides >= std::numeric_limits<std::uint32_t>::max())
    return "surface.tiles: too many sides, expected less than 2^32";
  for (std::size_t row = 0; row < surface.gluing.size(); ++row) {
    const auto& [tile, side, other_tile, other_side] = surface.gluing[row];
    for (const auto& [t, s] : {std::pair{tile, side}, std::pair{other_tile, other_side}}) {
      if (t >= glued.size()) return at("surface.gluing", row) + out_of_range("tile", t, glued.size());
      if (s >= glued[t].size()) return at("surface.gluing", row) + out_of_range("side", s, glued[t].size());
      if (glued[t][s]) {
        return at("surface.gluing", row) + "side " + std::to_string(s) + " of tile " + std::to_string(t) +
               " occurs twice, expected every side once";
      }
      glued[t][s] = true;
    }
  }
  if (2 * surface.gluing.size() != sides) {
    return "surface.gluing: " + std::to_string(2 * surface.gluing.size()) + " of " + std::to_string(sides) +
           " sides occur, expected every side once";
  }
  return std::nullopt;
}

Problem regular_problem(const SurfaceDocument& surface) {
  if (!surface.tiles.empty()) return "surface.tiles: a regular surface has none";
  if (!surface.gluing.empty()) return "surface.gluing: a regular surface has none";
  if (const auto problem = regular_genus_problem(surface.regular_genus)) return "surface.genus: " + *problem;
  return std::nullopt;
}

Problem label_problem(const NetDocument& document, const SurfaceSides& sides) {
  for (std::size_t row = 0; row < document.labels.size(); ++row) {
    const NetDocument::Label& label = document.labels[row];
    for (const std::uint32_t chart : {label.from, label.to}) {
      if (chart >= document.charts.size())
        return at("labels", row) + out_of_range("chart", chart, document.charts.size());
    }
    if (const auto problem = word_problem(sides, label.word, document.charts[label.from].tile,
                                          document.charts[label.to].tile, "chart " + std::to_string(label.to))) {
      return at("labels", row) + *problem;
    }
  }
  return std::nullopt;
}

/// Needs vertices without problem.
Problem collar_problem(const NetDocument& document, const SurfaceSides& sides) {
  for (std::size_t row = 0; row < document.collars->size(); ++row) {
    const NetDocument::Collar& collar = (*document.collars)[row];
    for (const std::uint32_t v : collar.vertices) {
      if (v >= document.vertices.size())
        return at("collars", row) + out_of_range("vertex", v, document.vertices.size());
    }
    for (const std::uint32_t t : collar.triangles) {
      if (t >= document.triangles.size())
        return at("collars", row) + out_of_range("triangle", t, document.triangles.size());
    }
    const Interval length{collar.length[0], collar.length[1]};
    if (!is_length(length)) {
      return at("collars", row) + "the length " + to_string(length) + " is not an interval of numbers >= 0";
    }
    const std::uint32_t v = collar.vertices[0];
    const std::uint32_t tile = document.charts[document.vertices[v].chart].tile;
    if (const auto problem = word_problem(sides, collar.core, tile, tile, "vertex " + std::to_string(v))) {
      return at("collars", row) + *problem;
    }
  }
  return std::nullopt;
}

Problem triangle_problem(const NetDocument& document) {
  if (document.triangles.size() > (std::size_t{1} << 30)) return "triangles: more than the limit of 2^30 rows";
  const std::size_t darts = 3 * document.triangles.size();
  for (std::size_t row = 0; row < document.triangles.size(); ++row) {
    const NetDocument::Triangle& triangle = document.triangles[row];
    for (const std::uint32_t v : triangle.vertex) {
      if (v >= document.vertices.size())
        return at("triangles", row) + out_of_range("vertex", v, document.vertices.size());
    }
    for (const std::uint32_t dart : triangle.opposite) {
      if (dart >= darts) return at("triangles", row) + out_of_range("dart", dart, darts);
    }
    const std::uint32_t chart = document.vertices[triangle.vertex[0]].chart;
    for (std::size_t i = 1; i < 3; ++i) {
      const std::uint32_t own_chart = document.vertices[triangle.vertex[i]].chart;
      const std::uint32_t number = triangle.label[i - 1];
      if (number > document.labels.size()) {
        return at("triangles", row) + out_of_range("label number", number, document.labels.size() + 1);
      }
      const std::uint32_t from = number == 0 ? chart : document.labels[number - 1].from;
      const std::uint32_t to = number == 0 ? chart : document.labels[number - 1].to;
      if (from != own_chart || to != chart) {
        return at("triangles", row) + "label number " + std::to_string(number) + " of corner " + std::to_string(i) +
               " leads from chart " + std::to_string(from) + " to chart " + std::to_string(to) + ", expected from " +
               std::to_string(own_chart) + " to " + std::to_string(chart);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::string at(const char* member, std::size_t row) { return std::string(member) + "[" + std::to_string(row) + "]: "; }

Problem regular_genus_problem(std::uint32_t genus) {
  if (genus < 2) return "the genus is " + std::to_string(genus) + ", expected at least 2";
  if (genus > kMaxRegularGenus) {
    return "the genus " + std::to_string(genus) + " is more than the limit of " + std::to_string(kMaxRegularGenus);
  }
  return std::nullopt;
}

Problem structure_problem(const SurfaceDocument& surface) {
  if (surface.about.size() > kMaxAboutBytes) return "surface.about: more than the limit of 1 MiB";
  return surface.regular_genus == 0 ? gluing_problem(surface) : regular_problem(surface);
}

Problem structure_problem(const NetDocument& document) {
  if (auto problem = structure_problem(document.surface)) return problem;
  const auto epsilon = parse_decimal(document.epsilon);
  if (!epsilon) return "epsilon: " + in_quotes(document.epsilon) + " is not a decimal, such as \"0.01\"";
  if (*epsilon <= 0) return "epsilon: " + in_quotes(document.epsilon) + " is not positive";
  const std::size_t tiles = number_of_tiles(document.surface);
  for (std::size_t row = 0; row < document.charts.size(); ++row) {
    const NetDocument::Chart& chart = document.charts[row];
    if (chart.tile >= tiles) return at("charts", row) + out_of_range("tile", chart.tile, tiles);
    if (chart.centre.x * chart.centre.x + chart.centre.y * chart.centre.y >= 1) {
      return at("charts", row) + "the centre is not inside the unit disk";
    }
  }
  const SurfaceSides sides(document.surface);
  if (auto problem = label_problem(document, sides)) return problem;
  for (std::size_t row = 0; row < document.vertices.size(); ++row) {
    const NetDocument::Vertex& vertex = document.vertices[row];
    if (vertex.chart >= document.charts.size()) {
      return at("vertices", row) + out_of_range("chart", vertex.chart, document.charts.size());
    }
    if (!inside_disk(vertex.x, vertex.y)) {
      return at("vertices", row) + "(" + shortest(vertex.x) + ", " + shortest(vertex.y) +
             ") is not inside the unit disk";
    }
  }
  if (auto problem = triangle_problem(document)) return problem;
  return document.collars ? collar_problem(document, sides) : std::nullopt;
}

Problem whole_net_problem(const NetDocument& net) {
  if (auto problem = structure_problem(net)) return problem;
  if (net.collars) return "net: collars, a pseudo net; expected a net of the whole surface";
  return std::nullopt;
}

Problem one_vertex_problem(const NetDocument& net) {
  if (auto problem = whole_net_problem(net)) return problem;
  if (net.vertices.size() == 1) return std::nullopt;
  return "net: " + std::to_string(net.vertices.size()) + " vertices, expected one";
}

Problem word_problem(const SurfaceSides& sides, const std::vector<std::uint32_t>& word, std::uint32_t from,
                     std::uint32_t to, const std::string& target) {
  std::uint32_t tile = from;
  for (std::size_t letter = 0; letter < word.size(); ++letter) {
    const std::uint32_t side = word[letter];
    if (side >= sides.partner.size()) return out_of_range("side", side, sides.partner.size());
    if (sides.tile[side] != tile) {
      return "letter " + std::to_string(letter) + " is side " + std::to_string(side) + " of tile " +
             std::to_string(sides.tile[side]) + ", expected a side of tile " + std::to_string(tile);
    }
    tile = sides.tile[sides.partner[side]];
  }
  if (tile == to) return std::nullopt;
  return "the word ends in tile " + std::to_string(tile) + ", expected the tile " + std::to_string(to) + " of " +
         target;
}

bool is_length(Interval x) { return std::isfinite(x.upper) && 0 <= x.lower && x.lower <= x.upper; }

std::uint64_t least_bytes(const RationalPoint& point) { return digits(point.x) + digits(point.y); }

/// A letter and its comma.
std::uint64_t least_bytes(const std::vector<std::uint32_t>& word) { return 2 * word.size(); }

std::uint64_t least_bytes(const NetDocument& document) {
  std::uint64_t bytes = document.epsilon.size();
  for (const SurfaceDocument::Tile& tile : document.surface.tiles) {
    for (const RationalPoint& vertex : tile) bytes += 8 + least_bytes(vertex);
  }
  bytes += 10 * document.surface.gluing.size();
  for (const NetDocument::Chart& chart : document.charts) bytes += 10 + least_bytes(chart.centre);
  for (const NetDocument::Label& label : document.labels) bytes += 9 + least_bytes(label.word);
  bytes += 8 * document.vertices.size() + 18 * document.triangles.size();
  if (document.collars) {
    for (const NetDocument::Collar& collar : *document.collars) bytes += 64 + least_bytes(collar.core);
  }
  return bytes;
}

}  // namespace epsnet::certify
