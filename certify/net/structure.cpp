#include "certify/net/structure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/base/text.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

std::string out_of_range(const char* what, std::size_t index, std::size_t size) {
  return std::string(what) + " " + std::to_string(index) + " does not exist, expected less than " +
         std::to_string(size);
}

std::uint64_t digits(const mpq_class& x) {
  const std::uint64_t numerator = mpz_sizeinbase(x.get_num_mpz_t(), 10);
  return x.get_den() == 1 ? numerator : numerator + mpz_sizeinbase(x.get_den_mpz_t(), 10);
}

/// Every side occurs once; none of those that `glued` has, by tile, has occurred so far. There are `sides` of them.
Problem gluing_problem(const SurfaceDocument& surface, std::vector<std::vector<bool>> glued, std::size_t sides) {
  const auto row_problem = [&](const SurfaceDocument::Gluing& row) -> Problem {
    for (const auto& [t, s] : {std::pair{row.tile, row.side}, std::pair{row.other_tile, row.other_side}}) {
      if (t >= glued.size()) return out_of_range("tile", t, glued.size());
      if (s >= glued[t].size()) return out_of_range("side", s, glued[t].size());
      if (glued[t][s]) {
        return "side " + std::to_string(s) + " of tile " + std::to_string(t) +
               " occurs twice, expected every side once";
      }
      glued[t][s] = true;
    }
    return std::nullopt;
  };
  if (auto problem = first_row_problem("surface.gluing", surface.gluing, row_problem)) return problem;
  if (2 * surface.gluing.size() == sides) return std::nullopt;
  return "surface.gluing: " + std::to_string(2 * surface.gluing.size()) + " of " + std::to_string(sides) +
         " sides occur, expected every side once";
}

/// Of tiles that are listed, in the member named: each has three vertices or more, of which none has a problem, and
/// every side is glued once.
template <class Polygon, class ProblemOfVertices>
Problem tiles_problem(const SurfaceDocument& surface, const char* member, const std::vector<Polygon>& tiles,
                      const ProblemOfVertices& vertices_problem) {
  std::vector<std::vector<bool>> glued;
  glued.reserve(tiles.size());
  std::size_t sides = 0;
  const auto tile_problem = [&](const Polygon& tile) -> Problem {
    if (tile.size() < 3) return "has " + std::to_string(tile.size()) + " vertices, expected at least 3";
    glued.emplace_back(tile.size(), false);
    sides += tile.size();
    return vertices_problem(tile);
  };
  if (auto problem = first_row_problem(member, tiles, tile_problem)) return problem;
  if (sides == 0) return std::string(member) + ": no tile, expected at least one";
  if (sides >= std::numeric_limits<std::uint32_t>::max()) {
    return std::string(member) + ": too many sides, expected less than 2^32";
  }
  return gluing_problem(surface, std::move(glued), sides);
}

Problem field_problem(const SurfaceDocument& surface) {
  const auto& [polynomial, root, polygons, crossings] = surface.field;
  if (!surface.tiles.empty() || surface.regular_genus != 0 || surface.map_tile.p != 0) {
    return "surface: tiles of two kinds, expected one";
  }
  if (const auto problem = polynomial_problem(polynomial)) return "surface.polynomial: " + *problem;
  if (root[0] >= root[1]) return "surface.root: the ends of the interval are not in order";
  const std::size_t degree = polynomial.size() - 1;
  const auto numbers_problem = [&](const auto& numbers) -> Problem {
    for (const SurfaceDocument::FieldNumber& number : numbers) {
      if (number.empty() || number.size() > degree) {
        return "a number of the field has " + std::to_string(number.size()) + " coefficients, expected 1 to " +
               std::to_string(degree);
      }
    }
    return std::nullopt;
  };
  const auto vertices_problem = [&](const SurfaceDocument::Field::Polygon& tile) -> Problem {
    for (const auto& vertex : tile) {
      if (auto problem = numbers_problem(vertex)) return problem;
    }
    return std::nullopt;
  };
  if (auto problem = tiles_problem(surface, "surface.polygons", polygons, vertices_problem)) return problem;
  if (crossings.size() != surface.gluing.size()) {
    return "surface.crossings: " + std::to_string(crossings.size()) + " rows, expected " +
           std::to_string(surface.gluing.size()) + ", as gluing has";
  }
  return first_row_problem("surface.crossings", crossings, numbers_problem);
}

/// There are as many tiles as the rows of `gluing` have sides for.
Problem map_problem(const SurfaceDocument& surface) {
  if (!surface.tiles.empty()) return "surface.tiles: a map has none";
  const auto [p, q] = surface.map_tile;
  if (const auto problem = map_number_problem(p)) return "surface.p: " + *problem;
  if (const auto problem = map_number_problem(q)) return "surface.q: " + *problem;
  const std::size_t sides = 2 * surface.gluing.size();
  if (sides == 0) return "surface.gluing: no row, expected at least one";
  if (sides >= std::numeric_limits<std::uint32_t>::max()) {
    return "surface.gluing: too many sides, expected less than 2^32";
  }
  if (sides % p != 0) {
    return "surface.gluing: " + std::to_string(sides) + " sides occur, expected a multiple of " + std::to_string(p);
  }
  return gluing_problem(surface, std::vector(sides / p, std::vector<bool>(p)), sides);
}

Problem regular_problem(const SurfaceDocument& surface) {
  if (!surface.tiles.empty()) return "surface.tiles: a regular surface has none";
  if (!surface.gluing.empty()) return "surface.gluing: a regular surface has none";
  if (const auto problem = regular_genus_problem(surface.regular_genus)) return "surface.genus: " + *problem;
  return std::nullopt;
}

/// `found` and `expected` are the charts from which and to which the label leads.
std::string wrong_label(std::size_t number, std::size_t corner, const std::array<std::uint32_t, 2>& found,
                        const std::array<std::uint32_t, 2>& expected) {
  return "label number " + std::to_string(number) + " of corner " + std::to_string(corner) + " leads from chart " +
         std::to_string(found[0]) + " to chart " + std::to_string(found[1]) + ", expected from " +
         std::to_string(expected[0]) + " to " + std::to_string(expected[1]);
}

/// What is wrong with one row of a net. The rows before it, and those of the members before its own, have no problem.
class NetRows {
 public:
  explicit NetRows(const NetDocument& net) : net_(net), sides_(net.surface) {}

  [[nodiscard]] Problem operator()(const NetDocument::Chart& chart) const {
    if (chart.tile >= sides_.first.size()) return out_of_range("tile", chart.tile, sides_.first.size());
    const auto& [x, y] = chart.centre;
    if (x * x + y * y >= 1) return "the centre is not inside the unit disk";
    return std::nullopt;
  }

  [[nodiscard]] Problem operator()(const NetDocument::Label& label) const {
    for (const std::uint32_t chart : {label.from, label.to}) {
      if (chart >= net_.charts.size()) return out_of_range("chart", chart, net_.charts.size());
    }
    return word_problem(sides_, label.word, net_.charts[label.from].tile, net_.charts[label.to].tile,
                        "chart " + std::to_string(label.to));
  }

  [[nodiscard]] Problem operator()(const NetDocument::Vertex& vertex) const {
    if (vertex.chart >= net_.charts.size()) return out_of_range("chart", vertex.chart, net_.charts.size());
    if (inside_disk(vertex.x, vertex.y)) return std::nullopt;
    return "(" + shortest(vertex.x) + ", " + shortest(vertex.y) + ") is not inside the unit disk";
  }

  [[nodiscard]] Problem operator()(const NetDocument::Triangle& triangle) const {
    for (const std::uint32_t v : triangle.vertex) {
      if (v >= vertices_) return out_of_range("vertex", v, vertices_);
    }
    for (const std::uint32_t dart : triangle.opposite) {
      if (dart >= darts_) return out_of_range("dart", dart, darts_);
    }
    // The label of a corner leads from the chart of its vertex to that of corner 0.
    const std::uint32_t chart = net_.vertices[triangle.vertex[0]].chart;
    for (std::size_t i = 1; i < 3; ++i) {
      const std::uint32_t own_chart = net_.vertices[triangle.vertex[i]].chart;
      const std::uint32_t number = triangle.label[i - 1];
      if (number > net_.labels.size()) return out_of_range("label number", number, net_.labels.size() + 1);
      const std::uint32_t from = number == 0 ? chart : net_.labels[number - 1].from;
      const std::uint32_t to = number == 0 ? chart : net_.labels[number - 1].to;
      if (from == own_chart && to == chart) continue;
      return wrong_label(number, i, {from, to}, {own_chart, chart});
    }
    return std::nullopt;
  }

  [[nodiscard]] Problem operator()(const NetDocument::Collar& collar) const {
    for (const std::uint32_t v : collar.vertices) {
      if (v >= net_.vertices.size()) return out_of_range("vertex", v, net_.vertices.size());
    }
    for (const std::uint32_t t : collar.triangles) {
      if (t >= net_.triangles.size()) return out_of_range("triangle", t, net_.triangles.size());
    }
    const Interval length{collar.length[0], collar.length[1]};
    if (!is_length(length)) return "the length " + to_string(length) + " is not an interval of numbers >= 0";
    const std::uint32_t tile = net_.charts[chart_of_core(net_, collar)].tile;
    return word_problem(sides_, collar.core, tile, tile, "vertex " + std::to_string(collar.vertices[0]));
  }

 private:
  const NetDocument& net_;
  SurfaceSides sides_;
  std::size_t vertices_ = net_.vertices.size();
  std::size_t darts_ = 3 * net_.triangles.size();
};

/// As first_row_problem, shared out among threads.
template <class Row>
Problem first_net_problem(const char* member, const std::vector<Row>& rows, const NetRows& net, unsigned threads) {
  const auto problems = results_of_blocks(rows.size(), threads, [&](std::size_t first, std::size_t last) -> Problem {
    for (std::size_t row = first; row < last; ++row) {
      if (const auto found = net(rows[row])) return at(member, row) + *found;
    }
    return std::nullopt;
  });
  const auto found = std::find_if(problems.begin(), problems.end(), [](const Problem& x) { return x.has_value(); });
  return found == problems.end() ? std::nullopt : *found;
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

Problem map_number_problem(std::uint32_t number) {
  if (3 <= number && number <= kMaxRegularSides) return std::nullopt;
  return std::to_string(number) + " found, expected at least 3 and at most " + std::to_string(kMaxRegularSides);
}

Problem polynomial_problem(const std::vector<mpz_class>& polynomial) {
  if (polynomial.size() < 2 || polynomial.size() > kMaxFieldDegree + 1) {
    return std::to_string(polynomial.size()) + " coefficients, expected 2 to " + std::to_string(kMaxFieldDegree + 1);
  }
  if (polynomial.back() != 1) return "the last coefficient is not 1";
  return std::nullopt;
}

Problem structure_problem(const SurfaceDocument& surface) {
  if (surface.about.size() > kMaxAboutBytes) return "surface.about: more than the limit of 1 MiB";
  if (is_over_field(surface)) return field_problem(surface);
  if (surface.map_tile.p != 0) return map_problem(surface);
  if (surface.regular_genus != 0) return regular_problem(surface);
  return tiles_problem(surface, "surface.tiles", surface.tiles, [](const auto&) { return std::nullopt; });
}

Problem structure_problem(const NetDocument& document, unsigned threads) {
  if (auto problem = structure_problem(document.surface)) return problem;
  const auto epsilon = parse_decimal(document.epsilon);
  if (!epsilon) return "epsilon: " + in_quotes(document.epsilon) + " is not a decimal, such as \"0.01\"";
  if (*epsilon <= 0) return "epsilon: " + in_quotes(document.epsilon) + " is not positive";
  const NetRows rows(document);
  if (auto problem = first_row_problem("charts", document.charts, rows)) return problem;
  if (auto problem = first_row_problem("labels", document.labels, rows)) return problem;
  if (auto problem = first_net_problem("vertices", document.vertices, rows, threads)) return problem;
  if (document.triangles.size() > (std::size_t{1} << 30)) return "triangles: more than the limit of 2^30 rows";
  if (auto problem = first_net_problem("triangles", document.triangles, rows, threads)) return problem;
  return document.collars ? first_row_problem("collars", *document.collars, rows) : std::nullopt;
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

bool inside_disk(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return false;
  // The binary64 sum is within 2⁻⁵⁰ of the true one while that is at most 2, and above 1 where it is more.
  const double square = x * x + y * y;
  if (square < 1 - 1e-14) return true;
  const mpq_class exact_x(x);
  const mpq_class exact_y(y);
  return exact_x * exact_x + exact_y * exact_y < 1;
}

bool is_length(Interval x) { return std::isfinite(x.upper) && 0 <= x.lower && x.lower <= x.upper; }

std::uint64_t least_bytes(const RationalPoint& point) { return digits(point.x) + digits(point.y); }

/// A letter and its comma.
std::uint64_t least_bytes(const std::vector<std::uint32_t>& word) { return 2 * word.size(); }

namespace {

std::uint64_t least_bytes(const SurfaceDocument::Field& field) {
  std::uint64_t bytes = 0;
  const auto add = [&](const std::vector<mpz_class>& integers) {
    bytes += 4;
    for (const mpz_class& integer : integers) bytes += mpz_sizeinbase(integer.get_mpz_t(), 10);
  };
  add(field.polynomial);
  for (const auto& polygon : field.polygons) {
    for (const auto& vertex : polygon) std::for_each(vertex.begin(), vertex.end(), add);
  }
  for (const auto& crossing : field.crossings) std::for_each(crossing.begin(), crossing.end(), add);
  return bytes;
}

}  // namespace

std::uint64_t least_bytes(const NetDocument& document) {
  std::uint64_t bytes = document.epsilon.size() + least_bytes(document.surface.field);
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
