#include "netgen/curves/radial_graph.h"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <limits>
#include <stdexcept>
#include <utility>

#include "netgen/base/disjoint_sets.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

/// A polygon from which a surface is glued, with one vertex.
struct OneVertexPolygon {
  std::vector<std::uint32_t> kept;    ///< Its sides, as sides of the polygon that was contracted,
  std::vector<std::uint32_t> number;  ///< By corner of that: the corner that it becomes.
};

/// Contracts sides that are a spanning tree of the vertices.
OneVertexPolygon with_one_vertex(const std::vector<std::uint32_t>& partner) {
  const auto count = static_cast<std::uint32_t>(partner.size());
  DisjointSets points(count);
  for (std::uint32_t k = 0; k < count; ++k) points.join(k, (partner[k] + 1) % count);
  std::vector<bool> contracted(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (points.find(k) == points.find((k + 1) % count)) continue;
    points.join(k, (k + 1) % count);
    contracted[k] = contracted[partner[k]] = true;
  }
  OneVertexPolygon result;
  for (std::uint32_t k = 0; k < count; ++k) {
    result.number.push_back(static_cast<std::uint32_t>(result.kept.size()));
    if (!contracted[k]) result.kept.push_back(k);
  }
  for (std::uint32_t& number : result.number) number %= static_cast<std::uint32_t>(result.kept.size());
  return result;
}

bool is_even(std::size_t i) { return i % 2 == 0; }

}  // namespace

RadialGraph::RadialGraph(const Surface& surface)
    : surface_(surface), paths_(polygon_paths(surface)), passage_(surface.side_count()) {
  const PolygonSides polygon = polygon_sides(surface);
  const OneVertexPolygon contracted = with_one_vertex(polygon.partner);
  const auto old_count = static_cast<std::uint32_t>(polygon.side.size());
  for (std::uint32_t k = 0; k < old_count; ++k) {
    passage_[polygon.side[k]] = Passage{contracted.number[k], contracted.number[(polygon.partner[k] + 1) % old_count]};
  }
  for (const std::uint32_t k : contracted.kept) {
    partner_.push_back(contracted.number[polygon.partner[k]]);
    crossed_.push_back(polygon.side[k]);
  }
  const std::uint32_t count = size();
  if (count != 4 * surface.genus()) throw std::logic_error("the polygon has another genus than the surface");
  place_.resize(count);
  potential_.resize(count);
  std::vector<std::uint32_t> coefficient(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (k > partner_[k]) continue;
    coefficient[k] = coefficient[partner_[k]] = static_cast<std::uint32_t>(basis_.size());
    basis_.push_back(k);
  }
  // Counterclockwise around the vertex; the quadrilateral around side k says what is between two edges there.
  std::vector<std::int64_t> potential(count / 2);
  std::uint32_t edge = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    place_[edge] = i;
    edges_.push_back(edge);
    potential_[edge] = potential;
    edge = partner_[(edge + count - 1) % count];
    potential[coefficient[edge]] += edge < partner_[edge] ? 1 : -1;
  }
  if (edge != 0) throw std::logic_error("the polygon has more than one vertex");
}

Word RadialGraph::crossing(std::uint32_t side) const {
  const SideId s = crossed_[side];
  Word word = paths_[surface_.tile_of_side(s)];
  word.push_back(s);
  return concatenated(surface_, std::move(word),
                      epsnet::reversed(surface_, paths_[surface_.tile_of_side(surface_.partner(s))]));
}

std::uint32_t RadialGraph::turned(std::uint32_t edge, bool outward, std::uint32_t count) const {
  if (outward) return (edge + count) % size();
  return edges_[(place_[edge] + count) % size()];
}

std::uint32_t RadialGraph::turn(std::uint32_t edge, bool outward, std::uint32_t next) const {
  const std::uint32_t difference = outward ? place_[next] + size() - place_[edge] : next + size() - edge;
  return difference % size();
}

std::uint32_t RadialGraph::across(std::uint32_t edge, bool outward, bool right) const {
  if (outward == right) return (partner_[(edge + size() - 1) % size()] + 1) % size();
  return partner_[edge];
}

RadialGraph::Shortcut RadialGraph::shortcut_at_end(std::span<const std::uint32_t> edges, bool outward) const {
  if (edges.size() < 2) return {};
  const auto turn_before = [&](std::size_t i) { return turn(edges[i - 1], outward == is_even(i - 1), edges[i]); };
  const std::uint32_t last = turn_before(edges.size() - 1);
  if (last == 0) return {2, true};
  if (last != 1 && last != size() - 1) return {};
  const bool right = last == 1;
  for (std::size_t i = edges.size() - 2; i > 0; --i) {
    const std::uint32_t here = turn_before(i);
    if (here == last) return {static_cast<std::uint32_t>(edges.size() - i + 1), right};
    if (here != (right ? 2 : size() - 2)) return {};
  }
  return {};
}

template <class Edges>
void RadialGraph::reduce(Edges& edges, bool outward) const {
  Edges rest(edges.rbegin(), edges.rend());
  edges.clear();
  while (!rest.empty()) {
    edges.push_back(rest.back());
    rest.pop_back();
    const Shortcut shortcut = shortcut_at_end({edges.data(), edges.size()}, outward);
    if (shortcut.edges == 0) continue;
    // A spur has no edges between its first and its last one.
    const std::size_t first = edges.size() - shortcut.edges;
    for (std::size_t i = edges.size() - 2; i > first; --i) {
      rest.push_back(across(edges[i], outward == is_even(i), shortcut.right));
    }
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(first), edges.end());
  }
}

ClosedWalk RadialGraph::reduced(ClosedWalk walk) const {
  reduce(walk, true);
  // What is left are shortcuts across the beginning.
  for (bool changed = true; changed && !walk.empty();) {
    changed = false;
    const std::size_t count = walk.size();
    const auto edge = [&](std::size_t i) { return walk[i % count]; };
    const auto turn_after = [&](std::size_t i) { return turn(edge(i), is_even(i), edge(i + 1)); };
    for (std::size_t i = 0; i < count && !changed; ++i) {
      const std::uint32_t here = turn_after(i);
      if (here != 0 && here != 1 && here != size() - 1) continue;
      const bool right = here == 1;
      std::size_t last = i + 1;  // The last edge of a spur.
      if (here != 0) {
        while (last < i + count && turn_after(last) == (right ? 2 : size() - 2)) ++last;
        // If the next turn of this kind is beside this one on the other side, that is a shorter bracket.
        if (turn_after(last) != here || last + 1 == i + count) continue;
        ++last;
      }
      ClosedWalk shorter;
      if (last == i + count + 1) {
        // One turn alone is not 2: the edges at it are two of one quadrilateral.
        for (std::size_t k = i + 2; k < i + count; ++k) shorter.push_back(across(edge(k), is_even(k), right));
      } else {
        for (std::size_t k = i + 1; k < last; ++k) shorter.push_back(across(edge(k), is_even(k), right));
        for (std::size_t k = last + 1; k < i + count; ++k) shorter.push_back(edge(k));
      }
      // The first one is outward if edge i is, or in the special case if the edge two later is not.
      const bool outward = last == i + count + 1 ? !is_even(i) : is_even(i);
      if (!outward && !shorter.empty()) std::rotate(shorter.begin(), shorter.begin() + 1, shorter.end());
      walk = std::move(shorter);
      reduce(walk, true);
      changed = true;
    }
  }
  return walk;
}

void RadialGraph::push_right(ClosedWalk& walk) const {
  const std::size_t count = walk.size();
  const auto outward = [](std::size_t i) { return is_even(i); };
  const auto turn_after = [&](std::size_t i) { return turn(walk[i % count], outward(i), walk[(i + 1) % count]); };
  // Until no turn of all is 1, from the last one that was changed on.
  for (std::size_t i = 0, unchanged = 0; unchanged < count;) {
    if (turn_after(i) != 1) {
      i = (i + 1) % count;
      ++unchanged;
      continue;
    }
    // Indices from 2 · count on, so that none is negative.
    const std::size_t middle = i + 2 * count;
    std::size_t first = middle;
    while (turn_after(first - 1) == 2) --first;
    std::size_t last = middle + 1;
    while (turn_after(last) == 2) ++last;
    ClosedWalk pushed{turned(walk[first % count], outward(first), size() - 1)};
    for (std::size_t k = first; k < middle; ++k) pushed.push_back(across(walk[k % count], outward(k), true));
    for (std::size_t k = middle + 2; k <= last; ++k) pushed.push_back(across(walk[k % count], outward(k), true));
    pushed.push_back(turned(walk[last % count], !outward(last), 1));
    for (std::size_t k = first; k <= last; ++k) walk[k % count] = pushed[k - first];
    i = (first - 1) % count;
    unchanged = 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (turn_after(i) != 2) return;
  }
  for (std::size_t i = 0; i < count; ++i) walk[i] = across(walk[i], outward(i), true);
  if (count > 0) std::rotate(walk.begin(), walk.begin() + 1, walk.end());
}

ClosedWalk RadialGraph::canonical(ClosedWalk walk) const {
  walk = reduced(std::move(walk));
  push_right(walk);
  ClosedWalk least = walk;
  for (std::size_t i = 2; i < walk.size(); i += 2) {
    std::rotate(walk.begin(), walk.begin() + 2, walk.end());
    least = std::min(least, walk);
  }
  return least;
}

ClosedWalk RadialGraph::walk_of(const Word& word) const {
  if (const auto problem = closed_path_problem(surface_, word)) throw SurfaceError(*problem);
  ClosedWalk walk;
  for (const SideId s : word) {
    if (!passage_[s]) continue;
    walk.push_back(passage_[s]->out);
    walk.push_back(passage_[s]->back);
  }
  return canonical(std::move(walk));
}

ClosedWalk RadialGraph::reversed(const ClosedWalk& walk) const { return canonical({walk.rbegin(), walk.rend()}); }

std::vector<std::uint32_t> RadialGraph::sides_around(std::uint32_t from, std::uint32_t to) const {
  std::vector<std::uint32_t> sides;
  const bool clockwise = turn(from, true, to) > size() / 2;
  for (std::uint32_t corner = from; corner != to; corner = turned(corner, false, clockwise ? size() - 1 : 1)) {
    sides.push_back(clockwise ? corner : (corner + size() - 1) % size());
  }
  return sides;
}

std::vector<std::uint32_t> RadialGraph::sides_around_vertex() const {
  std::vector<std::uint32_t> sides;
  for (const std::uint32_t corner : edges_) sides.push_back((corner + size() - 1) % size());
  return sides;
}

std::vector<std::uint32_t> RadialGraph::sides_of(const ClosedWalk& walk, std::size_t start) const {
  std::vector<std::uint32_t> sides;
  for (std::size_t i = start; i < start + walk.size(); i += 2) {
    const std::vector<std::uint32_t> some = sides_around(walk[i % walk.size()], walk[(i + 1) % walk.size()]);
    sides.insert(sides.end(), some.begin(), some.end());
  }
  return sides;
}

Word RadialGraph::path(const std::vector<std::uint32_t>& sides) const {
  Word word;
  for (const std::uint32_t side : sides) word = concatenated(surface_, std::move(word), crossing(side));
  return word;
}

RadialGraph::CrossingPaths RadialGraph::crossing_paths(const ClosedWalk& first, const ClosedWalk& second,
                                                       const WalkCrossing& crossing) const {
  const std::size_t i = crossing.first - crossing.first % 2;
  const std::size_t j = crossing.second - crossing.second % 2;
  Word way = is_even(crossing.first) ? Word() : path(sides_around(first[i], second[j]));
  const Word other = concatenated(surface_, way, path(sides_of(second, j)));
  return {path(sides_of(first, i)), concatenated(surface_, other, epsnet::reversed(surface_, way)), std::move(way)};
}

std::uint32_t RadialGraph::power_of(const ClosedWalk& walk) {
  for (std::size_t period = 2; period < walk.size(); period += 2) {
    if (walk.size() % period != 0) continue;
    if (std::equal(walk.begin() + static_cast<std::ptrdiff_t>(period), walk.end(), walk.begin())) {
      return static_cast<std::uint32_t>(walk.size() / period);
    }
  }
  return 1;
}

/// A lift of a closed walk, followed from one of its vertices in one direction. Vertex i is the start of edge i; those
/// of even number are centres.
class RadialGraph::Lift {
 public:
  Lift(const ClosedWalk& walk, std::size_t vertex, bool forward) : walk_(walk), vertex_(vertex), forward_(forward) {}

  /// The edge along which it leaves the vertex.
  [[nodiscard]] std::uint32_t edge() const { return forward_ ? walk_[vertex_] : walk_[before(vertex_)]; }
  void go() { vertex_ = forward_ ? (vertex_ + 1) % walk_.size() : before(vertex_); }
  [[nodiscard]] std::size_t vertex() const { return vertex_; }
  [[nodiscard]] bool at_centre() const { return is_even(vertex_); }

 private:
  [[nodiscard]] std::size_t before(std::size_t i) const { return (i + walk_.size() - 1) % walk_.size(); }

  const ClosedWalk& walk_;
  std::size_t vertex_;
  bool forward_;
};

/// Two lifts that are followed from a common vertex as long as they are near each other.
class RadialGraph::Together {
 public:
  Together(const RadialGraph& graph, Lift first, Lift second) : graph_(graph), first_(first), second_(second) {}

  /// Goes on to the next common vertex, and returns whether there is one. The lifts have different ends.
  [[nodiscard]] bool meet_again() {
    do {
      // From the vertex of the first one to that of the second one. Geodesics that meet again are at most 2 apart.
      between_.insert(between_.begin(), first_.edge());
      between_.push_back(second_.edge());
      first_.go();
      second_.go();
      graph_.reduce(between_, first_.at_centre());
    } while (!between_.empty() && between_.size() <= 2);
    return between_.empty();
  }
  [[nodiscard]] const Lift& first() const { return first_; }
  [[nodiscard]] const Lift& second() const { return second_; }

 private:
  const RadialGraph& graph_;
  Lift first_;
  Lift second_;
  boost::container::static_vector<std::uint32_t, 4> between_;
};

std::vector<WalkCrossing> RadialGraph::all_crossings(const ClosedWalk& first, const ClosedWalk& second,
                                                     bool same) const {
  // Whether an edge of the second lift at a vertex is on the left of the first one there.
  const auto is_left = [&](std::size_t vertex, std::uint32_t other) {
    const bool centre = is_even(vertex);
    const std::uint32_t out = first[vertex];
    const std::uint32_t in = first[(vertex + first.size() - 1) % first.size()];
    return turn(out, !centre, other) < turn(out, !centre, in);
  };
  std::vector<WalkCrossing> result;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = i % 2; j < second.size(); j += 2) {
      if (same && i == j) continue;
      const auto together = [&](bool forward, bool second_forward) {
        return Together(*this, Lift(first, i, forward), Lift(second, j, second_forward));
      };
      // Each pair of lifts is counted at their first common vertex along the second one.
      if (together(true, false).meet_again() || together(false, false).meet_again()) continue;
      std::size_t last_of_first = i;
      std::size_t last_of_second = j;
      for (const bool forward : {true, false}) {
        for (Together both = together(forward, true); both.meet_again();) {
          last_of_first = both.first().vertex();
          last_of_second = both.second().vertex();
        }
      }
      const bool from_left = is_left(i, second[(j + second.size() - 1) % second.size()]);
      const bool to_left = is_left(last_of_first, second[last_of_second]);
      if (from_left == to_left) continue;
      result.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), to_left ? 1 : -1});
    }
  }
  return result;
}

std::vector<WalkCrossing> RadialGraph::crossings(const ClosedWalk& first, const ClosedWalk& second) const {
  return all_crossings(first, second, false);
}

std::vector<WalkCrossing> RadialGraph::self_crossings(const ClosedWalk& walk) const {
  std::vector<WalkCrossing> result = all_crossings(walk, walk, true);
  std::erase_if(result, [](const WalkCrossing& crossing) { return crossing.sign < 0; });
  return result;
}

/// A graph with a map to the radial graph, which is made larger until it is convex in the universal cover: where two
/// edges at a vertex go to one edge, their ends are joined, and where two go to neighbouring ones, there is the
/// quadrilateral between them. Neither changes which closed walks are homotopic to some of it (docs/proof.md, Lemma
/// 54).
class RadialGraph::Hull {
 public:
  explicit Hull(const RadialGraph& graph) : graph_(graph) {}

  std::uint32_t add_vertex(bool is_centre) {
    vertices_.push_back({is_centre, std::vector<std::uint32_t>(graph_.size(), kNone)});
    joined_to_.push_back(static_cast<std::uint32_t>(joined_to_.size()));
    return joined_to_.back();
  }

  void add_edge(std::uint32_t x, std::uint32_t edge, std::uint32_t y) {
    for (const auto& [from, to] : {std::pair(x, y), std::pair(y, x)}) {
      std::uint32_t& end = vertices_[find(from)].ends[edge];
      if (end == kNone) {
        end = to;
        to_visit_.push_back(find(from));
      } else {
        join(end, to);
      }
    }
  }

  void join(std::uint32_t first, std::uint32_t second) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs{{first, second}};
    while (!pairs.empty()) {
      const auto [kept, gone] = std::minmax({find(pairs.back().first), find(pairs.back().second)});
      pairs.pop_back();
      if (kept == gone) continue;
      joined_to_[gone] = kept;
      for (std::uint32_t edge = 0; edge < graph_.size(); ++edge) {
        const std::uint32_t end = vertices_[gone].ends[edge];
        std::uint32_t& other = vertices_[kept].ends[edge];
        if (other == kNone) other = end;
        if (end != kNone && other != end) pairs.emplace_back(other, end);
      }
      to_visit_.push_back(kept);
    }
  }

  /// Adds quadrilaterals until none is missing.
  void close() {
    while (!to_visit_.empty()) {
      const std::uint32_t x = find(to_visit_.back());
      to_visit_.pop_back();
      for (std::uint32_t side = 0; side < graph_.size(); ++side) {
        // Neighbours at a centre are the edges to both ends of a side; the others are those at one end of it.
        const std::uint32_t partner = graph_.partner_[side];
        const std::uint32_t after = (side + 1) % graph_.size();
        const std::uint32_t after_partner = (partner + 1) % graph_.size();
        if (vertices_[x].is_centre) {
          add_quadrilateral(x, {side, after_partner, partner, after});
        } else {
          add_quadrilateral(x, {side, after, partner, after_partner});
        }
      }
    }
  }

  /// Whether it is the radial graph itself. Requires: closed.
  [[nodiscard]] bool is_everything() {
    std::uint32_t count = 0;
    for (std::uint32_t x = 0; x < joined_to_.size(); ++x) {
      if (find(x) != x) continue;
      ++count;
      if (std::count(vertices_[x].ends.begin(), vertices_[x].ends.end(), kNone) != 0) return false;
    }
    return count == 2;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] std::uint32_t find(std::uint32_t x) {
    while (joined_to_[x] != x) x = joined_to_[x] = joined_to_[joined_to_[x]];
    return x;
  }
  /// The end of an edge, kNone if the vertex has none.
  [[nodiscard]] std::uint32_t end(std::uint32_t x, std::uint32_t edge) {
    const std::uint32_t y = vertices_[find(x)].ends[edge];
    return y == kNone ? kNone : find(y);
  }
  /// That with these edges from a vertex on, if the vertex has the first and the last of them.
  void add_quadrilateral(std::uint32_t x, const std::array<std::uint32_t, 4>& edges) {
    const std::uint32_t y = end(x, edges[0]);
    const std::uint32_t w = end(x, edges[3]);
    if (y == kNone || w == kNone) return;
    const std::uint32_t from_y = end(y, edges[1]);
    const std::uint32_t from_w = end(w, edges[2]);
    if (from_y != kNone && from_w == from_y) return;
    const std::uint32_t z = from_y != kNone   ? from_y
                            : from_w != kNone ? from_w
                                              : add_vertex(vertices_[find(x)].is_centre);
    add_edge(y, edges[1], z);
    add_edge(w, edges[2], z);
  }

  struct Vertex {
    bool is_centre;
    std::vector<std::uint32_t> ends;  ///< By edge.
  };

  const RadialGraph& graph_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> joined_to_;  ///< By vertex: one that it was joined to, or itself.
  std::vector<std::uint32_t> to_visit_;
};

bool RadialGraph::fill(const std::vector<ClosedWalk>& walks) const {
  Hull hull(*this);
  std::vector<std::vector<std::uint32_t>> vertices;
  for (const ClosedWalk& walk : walks) {
    std::vector<std::uint32_t>& own = vertices.emplace_back();
    for (std::size_t i = 0; i < walk.size(); ++i) own.push_back(hull.add_vertex(is_even(i)));
    for (std::size_t i = 0; i < walk.size(); ++i) hull.add_edge(own[i], walk[i], own[(i + 1) % walk.size()]);
  }
  for (std::size_t a = 0; a < walks.size(); ++a) {
    for (const WalkCrossing& crossing : self_crossings(walks[a])) {
      hull.join(vertices[a][crossing.first], vertices[a][crossing.second]);
    }
    for (std::size_t b = 0; b < a; ++b) {
      for (const WalkCrossing& crossing : crossings(walks[a], walks[b])) {
        hull.join(vertices[a][crossing.first], vertices[b][crossing.second]);
      }
    }
  }
  hull.close();
  return hull.is_everything();
}

std::vector<std::int64_t> RadialGraph::homology(const ClosedWalk& walk) const {
  std::vector<std::int64_t> result(basis_.size());
  for (std::size_t i = 0; i < walk.size(); ++i) {
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += (is_even(i) ? 1 : -1) * potential_[walk[i]][k];
  }
  return result;
}

std::vector<std::vector<std::int64_t>> RadialGraph::intersection_form() const {
  const auto is_left = [&](std::uint32_t of, std::uint32_t place) {
    const std::uint32_t count = size();
    return (place + count - of) % count < (partner_[of] + count - of) % count;
  };
  std::vector<std::vector<std::int64_t>> form;
  for (const std::uint32_t x : basis_) {
    std::vector<std::int64_t>& row = form.emplace_back();
    for (const std::uint32_t y : basis_) {
      row.push_back(x == y ? 0 : std::int64_t{is_left(x, y)} - std::int64_t{is_left(x, partner_[y])});
    }
  }
  return form;
}

}  // namespace epsnet
