#include "certify/exact/net_structure.h"

#include <algorithm>

namespace epsnet::exact {
namespace {

/// each_neighbour(i, visit) calls visit for every neighbour of number i.
template <class EachNeighbour>
void expect_connected(std::size_t count, const char* what, const EachNeighbour& each_neighbour) {
  std::vector<bool> reached(count);
  std::vector<Index> open;
  std::size_t seen = 0;
  const auto visit = [&](Index i) {
    if (!reached[i]) open.push_back(i);
    reached[i] = true;
  };
  for (visit(0); !open.empty(); ++seen) {
    const Index i = open.back();
    open.pop_back();
    each_neighbour(i, visit);
  }
  if (seen != count) throw Refutation{std::string("the ") + what + " are not connected"};
}

}  // namespace

void expect_less(std::size_t index, std::size_t size, const char* what) {
  if (index >= size) throw Malformed(std::string(what) + ' ' + number(index) + " does not exist");
}

NetStructure::NetStructure(const Net& net) : net_(net) {
  if (net_.epsilon <= 0) throw Malformed("epsilon is not positive");
  number_sides();
  for (const auto& [tile, centre] : net_.charts) {
    expect_less(tile, net_.tile_count(), "tile");
    if (gap(centre) <= 0) throw Malformed("the centre of a chart is not in the disk");
  }
  for (const Label& label : net_.labels) {
    expect_less(label.from, net_.charts.size(), "chart");
    expect_less(label.to, net_.charts.size(), "chart");
    expect_path(label.word, net_.charts[label.from].first, net_.charts[label.to].first);
  }
  for (const Vertex& vertex : net_.vertices) {
    expect_less(vertex.chart, net_.charts.size(), "chart");
    if (gap(vertex.z) <= 0) throw Malformed("a vertex is not in the disk");
  }
  for (const Triangle& triangle : net_.triangles) check_triangle_structure(triangle);
  for (const Collar& collar : net_.collars.value_or(std::vector<Collar>())) check_collar_structure(collar);
}

void NetStructure::expect_path(const std::vector<Index>& word, Index from, Index to) const {
  Index tile = from;
  for (const Index side : word) {
    expect_less(side, tile_of_.size(), "side");
    if (tile_of_[side] != tile) throw Malformed("a word is no path");
    tile = tile_of_[partner_[side]];
  }
  if (tile != to) throw Malformed("a word ends in a wrong tile");
}

/// As many as words of a file have in all.
constexpr std::size_t kMostLettersOfGenerators = 10'000'000;

void NetStructure::expect_paths(const std::vector<std::vector<Index>>& paths) const {
  if (paths.size() != net_.tile_count()) throw Malformed("paths: not one for each tile");
  for (Index t = 0; t < paths.size(); ++t) expect_path(paths[t], 0, t);
}

void NetStructure::expect_loops(const std::vector<std::vector<Index>>& words, std::size_t size,
                                const char* what) const {
  if (words.size() != size) throw Malformed(std::string(what) + ": another number of words");
  for (const auto& word : words) expect_path(word, 0, 0);
}

void NetStructure::expect_words(const IsometryRows& rows) const {
  expect_paths(rows.paths);
  expect_loops(rows.pair, 2, "pair");
  for (const IsometryRows::Row& row : rows.isometries) expect_loops(row.images, 2 + sides() / 2, "images");
}

std::vector<std::vector<Index>> NetStructure::paths() const {
  std::vector<std::vector<Index>> result(net_.tile_count());
  std::vector<bool> reached(result.size());
  std::vector<Index> tiles{0};
  std::size_t letters = 0;
  reached[0] = true;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Index tile = tiles[i];
    for (Index k = 0; k < net_.sides_of(tile); ++k) {
      const Index beyond = tile_of(partner(side(tile, k)));
      if (reached[beyond]) continue;
      reached[beyond] = true;
      letters += result[tile].size() + 1;
      if (letters > kMostLettersOfGenerators) throw TooLarge{"the paths to all tiles are too long"};
      result[beyond] = result[tile];
      result[beyond].push_back(side(tile, k));
      tiles.push_back(beyond);
    }
  }
  return result;
}

std::vector<std::vector<Index>> NetStructure::generators(const std::vector<std::vector<Index>>& paths) const {
  std::vector<std::vector<Index>> result;
  std::size_t letters = 0;
  for (Index s = 0; s < sides(); ++s) {
    if (partner(s) < s) continue;
    letters += paths[tile_of(s)].size() + paths[tile_of(partner(s))].size();
    if (letters > kMostLettersOfGenerators) throw TooLarge{"the words of the generators are too long"};
    std::vector<Index>& word = result.emplace_back(paths[tile_of(s)]);
    word.push_back(s);
    const std::vector<Index>& back = paths[tile_of(partner(s))];
    std::for_each(back.rbegin(), back.rend(), [&](Index t) { word.push_back(partner(t)); });
  }
  return result;
}

void NetStructure::number_sides() {
  for (Index t = 0; t < net_.tile_count(); ++t) {
    const std::size_t size = net_.sides_of(t);
    if (size < 3) throw Malformed("a tile has less than three vertices");
    first_side_.push_back(static_cast<Index>(tile_of_.size()));
    tile_of_.insert(tile_of_.end(), size, t);
  }
  if (tile_of_.empty()) throw Malformed("there is no tile");
  constexpr Index kNone = 0xFFFFFFFFU;
  partner_.assign(tile_of_.size(), kNone);
  const auto side = [&](Index tile, Index k) {
    expect_less(tile, net_.tile_count(), "tile");
    expect_less(k, net_.sides_of(tile), "side");
    return first_side_[tile] + k;
  };
  for (const auto& [t, k, other_t, other_k] : net_.gluing) {
    const Index s = side(t, k);
    const Index other = side(other_t, other_k);
    if (s == other || partner_[s] != kNone || partner_[other] != kNone) throw Malformed("a side is glued twice");
    partner_[s] = other;
    partner_[other] = s;
  }
  if (std::find(partner_.begin(), partner_.end(), kNone) != partner_.end()) throw Malformed("a side is not glued");
}

void NetStructure::check_triangle_structure(const Triangle& triangle) const {
  for (const Index v : triangle.vertex) expect_less(v, net_.vertices.size(), "vertex");
  for (const Index dart : triangle.opposite) expect_less(dart, 3 * net_.triangles.size(), "dart");
  const Index chart = net_.vertices[triangle.vertex[0]].chart;
  for (const std::size_t i : {1U, 2U}) {
    const Index own = net_.vertices[triangle.vertex[i]].chart;
    const Index label = triangle.label[i];
    expect_less(label, net_.labels.size() + 1, "label number");
    const bool fits =
        label == 0 ? own == chart : net_.labels[label - 1].from == own && net_.labels[label - 1].to == chart;
    if (!fits) throw Malformed("a label does not connect its triangle's charts");
  }
}

void NetStructure::check_collar_structure(const Collar& collar) const {
  for (const Index v : collar.vertices) expect_less(v, net_.vertices.size(), "vertex");
  for (const Index t : collar.triangles) expect_less(t, net_.triangles.size(), "triangle");
  const Index tile = net_.charts[net_.vertices[collar.vertices[0]].chart].first;
  expect_path(collar.core, tile, tile);
}

std::string NetStructure::triangle_name(std::size_t t) const {
  const auto& v = net_.triangles[t].vertex;
  return "triangle " + number(t) + " (vertices " + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + ")";
}

std::string NetStructure::edge_name(Index dart) const {
  return "the edge of dart " + number(dart) + " from vertex " + number(start(dart)) + " to vertex " +
         number(start(next(dart)));
}

Index NetStructure::side_after(Index s) const {
  return vertex_of(s) + 1 < net_.sides_of(tile_of_[s]) ? s + 1 : s - vertex_of(s);
}

Index NetStructure::side_before(Index s) const {
  return vertex_of(s) > 0 ? s - 1 : s + static_cast<Index>(net_.sides_of(tile_of_[s])) - 1;
}

std::string NetStructure::corner_name(Index s) const {
  return "vertex " + number(vertex_of(s)) + " of tile " + number(tile_of_[s]);
}

std::string NetStructure::side_name(Index s) const {
  return "side " + number(vertex_of(s)) + " of tile " + number(tile_of_[s]);
}

void NetStructure::expect_connected_tiles() const {
  expect_connected(net_.tile_count(), "tiles", [&](Index t, const auto& visit) {
    for (std::size_t k = 0; k < net_.sides_of(t); ++k) visit(tile_of_[partner_[first_side_[t] + k]]);
  });
}

void NetStructure::check_map(std::int64_t euler_of_surface) const {
  if (net_.vertices.empty() || net_.triangles.empty()) throw Refutation{"there is no vertex or no triangle"};
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index other = opposite(dart);
    if (other == dart || opposite(other) != dart || start(dart) != start(next(other))) {
      throw Refutation{"dart " + number(dart) + " and dart " + number(other) + " are not opposite to each other"};
    }
  }
  std::vector<bool> seen(darts());
  std::vector<bool> met(net_.vertices.size());
  for (Index first = 0; first < darts(); ++first) {
    if (seen[first]) continue;
    if (met[start(first)]) throw Refutation{"vertex " + number(start(first)) + " has several cycles of darts"};
    met[start(first)] = true;
    for (Index dart = first; !seen[dart]; dart = opposite(previous(dart))) seen[dart] = true;
  }
  const auto lonely = std::find(met.begin(), met.end(), false);
  if (lonely != met.end()) throw Refutation{"vertex " + std::to_string(lonely - met.begin()) + " is in no triangle"};
  expect_connected(net_.triangles.size(), "triangles", [&](Index t, const auto& visit) {
    for (const Index dart : net_.triangles[t].opposite) visit(dart / 3);
  });
  const auto euler =
      static_cast<std::int64_t>(net_.vertices.size() + net_.triangles.size()) - static_cast<std::int64_t>(darts() / 2);
  if (euler != euler_of_surface) throw Refutation{"V - E + F = " + std::to_string(euler) + ", not that of the surface"};
}

}  // namespace epsnet::exact
