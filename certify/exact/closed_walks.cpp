#include "certify/exact/closed_walks.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "certify/exact/interval.h"

namespace epsnet::exact {
namespace {

constexpr Index kNoSide = 0xFFFFFFFFU;
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
/// Some seconds.
constexpr std::size_t kMostSteps = 300'000'000;

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  for (; parent[i] != i; i = parent[i]) parent[i] = parent[parent[i]];
  return i;
}

/// Whether they were two.
bool join_sets(std::vector<std::size_t>& parent, std::size_t i, std::size_t j) {
  const std::size_t x = root_of(parent, i);
  const std::size_t y = root_of(parent, j);
  parent[x] = y;
  return x != y;
}

std::vector<std::size_t> single_sets(std::size_t count) {
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  return parent;
}

}  // namespace

RadialGraph::RadialGraph(const NetStructure& net, long euler) : steps_left_(kMostSteps) {
  find_polygon(net);
  contract();
  if (static_cast<long>(corners_) != 4 - 2 * euler) throw TooLarge{"the tiles make no polygon of 4g sides"};
  edge_at_.clear();
  place_.assign(corners_, kNoSide);
  for (Index j = 0; place_[j] == kNoSide; j = partner_[plus(j, corners_ - 1)]) {
    place_[j] = static_cast<Index>(edge_at_.size());
    edge_at_.push_back(j);
  }
  if (edge_at_.size() != corners_) throw TooLarge{"the corners of the polygon are more than one vertex"};
}

/// All tiles, glued along sides that make a tree of them.
void RadialGraph::find_polygon(const NetStructure& net) {
  std::vector<std::size_t> tiles = single_sets(net.net().tile_count());
  std::vector<bool> is_inside(net.sides());
  for (Index s = 0; s < net.sides(); ++s) {
    if (join_sets(tiles, net.tile_of(s), net.tile_of(net.partner(s)))) is_inside[s] = is_inside[net.partner(s)] = true;
  }
  side_of_.assign(net.sides(), kNoSide);
  const auto first = static_cast<Index>(std::find(is_inside.begin(), is_inside.end(), false) - is_inside.begin());
  std::vector<Index> sides;
  for (Index s = first; s < net.sides() && side_of_[s] == kNoSide;) {
    side_of_[s] = static_cast<Index>(sides.size());
    sides.push_back(s);
    for (s = net.side_after(s); is_inside[s];) s = net.side_after(net.partner(s));
  }
  corners_ = sides.size();
  for (const Index s : sides) partner_.push_back(side_of_[net.partner(s)]);
}

/// Sides that make a tree of all vertices become points.
void RadialGraph::contract() {
  std::vector<std::size_t> vertices = single_sets(corners_);
  for (Index k = 0; k < corners_; ++k) join_sets(vertices, k, plus(partner_[k], 1));
  std::vector<bool> is_point(corners_);
  for (Index k = 0; k < corners_; ++k) {
    if (join_sets(vertices, k, plus(k, 1))) is_point[k] = is_point[partner_[k]] = true;
  }
  // The first side from here on that is none, by its new number.
  std::vector<Index> renumbered(corners_);
  Index left = 0;
  for (Index k = 0; k < corners_; ++k) {
    renumbered[k] = left;
    if (!is_point[k]) ++left;
  }
  std::vector<Index> partner;
  for (Index k = 0; k < corners_; ++k) {
    corner_.push_back(renumbered[k] % std::max(left, Index{1}));
    if (!is_point[k]) partner.push_back(renumbered[partner_[k]]);
  }
  for (Index k = 0; k < corners_; ++k) beyond_.push_back(corner_[plus(partner_[k], 1)]);
  corners_ = left;
  partner_ = std::move(partner);
}

void RadialGraph::spend(std::size_t steps) {
  if (steps > steps_left_) throw TooLarge{"the walks of the curves take too many steps"};
  steps_left_ -= steps;
}

RadialGraph::Walk RadialGraph::walk(const std::vector<Index>& word) {
  Walk result;
  for (const Index s : word) {
    if (side_of_[s] == kNoSide) continue;
    push(result, 2 * corner_[side_of_[s]]);
    push(result, 2 * beyond_[side_of_[s]] + 1);
  }
  return result;
}

/// Goes one step on, and takes away what then is a spur or a bracket, of which there is none before.
void RadialGraph::push(Walk& walk, Step e) {
  pending_.assign(1, e);
  while (!pending_.empty()) {
    const Step next = pending_.back();
    pending_.pop_back();
    spend(1);
    if (walk.empty()) {
      walk.push_back(next);
      continue;
    }
    const Index last = turn(walk.back(), next);
    if (last == 0) {
      walk.pop_back();
      continue;
    }
    const bool on_right = last == 1;
    bool is_bracket = false;
    std::size_t begin = walk.size() - 1;  // Of the part with turns of two quadrangles.
    if (on_right || left(last) == 1) {
      Index before = 2;
      while (begin > 0 && before == 2) {
        spend(1);
        before = turn(walk[begin - 1], walk[begin]);
        if (!on_right) before = left(before);
        if (before == 1) is_bracket = true;
        if (before == 2) --begin;
      }
    }
    if (!is_bracket) {
      walk.push_back(next);
      continue;
    }
    for (std::size_t i = walk.size(); i > begin; --i) pending_.push_back(across(walk[i - 1], on_right));
    walk.resize(begin - 1);
  }
}

/// Takes something away from a closed walk that has spurs and brackets at most where it closes, if it has one there;
/// false if it has none.
bool RadialGraph::shorten(Walk& walk) {
  const std::size_t n = walk.size();
  if (n == 0) return false;
  for (const bool on_right : {true, false}) {
    spend(2 * n);
    std::size_t twos = 0;
    std::size_t ones = 0;
    std::size_t last_one = kNowhere;  // If all turns are of two quadrangles since then.
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const Index right = turn(walk[i % n], walk[(i + 1) % n]);
      const Index found = on_right ? right : left(right);
      const bool is_bracket = found == 1 && last_one != kNowhere && i - last_one + 2 <= n;
      if (found == 0 || is_bracket) {
        return take_away(walk, is_bracket ? last_one : i, i + 1);
      }
      if (found == 1) last_one = i;
      if (found > 2) last_one = kNowhere;
      if (i < n) ones += found == 1 ? 1 : 0;
      if (i < n) twos += found == 2 ? 1 : 0;
    }
    if (ones != 1 || twos + 1 != n) continue;
    Walk shorter;
    for (std::size_t i = 2; i < n; ++i) shorter.push_back(across(walk[(last_one + i) % n], on_right));
    walk = std::move(shorter);
    return true;
  }
  return false;
}

/// Turns a closed walk so that steps `first` to `last` are in its middle, and takes spurs and brackets away.
bool RadialGraph::take_away(Walk& walk, std::size_t first, std::size_t last) {
  const std::size_t n = walk.size();
  const std::size_t start = first + n - (n - (last - first + 1)) / 2;
  Walk shorter;
  for (std::size_t i = 0; i < n; ++i) push(shorter, walk[(start + i) % n]);
  if (shorter.size() >= n) throw TooLarge{"a closed walk does not get shorter"};
  walk = std::move(shorter);
  return true;
}

/// Shifts a walk to the right at the turn of one quadrangle after step i, and beside it as far as turns are two.
void RadialGraph::shift_right(Walk& walk, std::size_t i) {
  const std::size_t n = walk.size();
  const auto at = [&](std::size_t k) -> Step& { return walk[k % n]; };
  std::size_t before = 0;
  while (before + 2 < n && turn(at(i + n - before - 1), at(i + n - before)) == 2) ++before;
  std::size_t after = 0;
  while (before + after + 2 < n && turn(at(i + 1 + after), at(i + 2 + after)) == 2) ++after;
  spend(before + after + 2);
  Walk shifted{turned(at(i + n - before), corners_ - 1)};
  for (std::size_t k = before; k > 0; --k) shifted.push_back(across(at(i + n - k), true));
  for (std::size_t k = 1; k <= after; ++k) shifted.push_back(across(at(i + 1 + k), true));
  shifted.push_back(turned(at(i + 1 + after) ^ 1U, 1) ^ 1U);
  for (std::size_t k = 0; k < shifted.size(); ++k) at(i + n - before + k) = shifted[k];
}

RadialGraph::Walk RadialGraph::rightmost(Walk walk) {
  while (shorten(walk)) {
  }
  const std::size_t n = walk.size();
  if (n == 0) return walk;
  const auto turn_at = [&](std::size_t i) { return turn(walk[i], walk[(i + 1) % n]); };
  for (std::size_t i = 0, straight = 0; straight < n; i = (i + 1) % n) {
    spend(1);
    straight = turn_at(i) == 1 ? 0 : straight + 1;
    if (straight == 0) shift_right(walk, i);
  }
  bool is_parallel = true;
  for (std::size_t i = 0; i < n; ++i) is_parallel = is_parallel && turn_at(i) == 2;
  if (is_parallel) {
    for (Step& e : walk) e = across(e, true);
  }
  return walk;
}

/// The greatest k for which the walks have step k in one vertex, if they go on from a common vertex, at which step i of
/// the one and step j of the other begin, as they run forever in the plane.
std::size_t RadialGraph::last_common(const Walk& a, std::size_t i, bool a_forwards, const Walk& b, std::size_t j,
                                     bool b_forwards) {
  const auto step_of = [](const Walk& walk, std::size_t from, bool forwards, std::size_t k) {
    const std::size_t n = walk.size();
    return forwards ? walk[(from + k) % n] : walk[(from + n - 1 - k % n) % n] ^ 1U;
  };
  std::size_t result = 0;
  between_.clear();
  for (std::size_t k = 0;; ++k) {
    // From the vertex of the first walk to that of the other one, reduced.
    next_.clear();
    push(next_, step_of(a, i, a_forwards, k) ^ 1U);
    for (const Step e : between_) push(next_, e);
    push(next_, step_of(b, j, b_forwards, k));
    if (next_.size() > 2) return result;
    if (next_.empty()) result = k + 1;
    std::swap(between_, next_);
  }
}

WalkCrossings RadialGraph::crossings(const Walk& a, const Walk& b, bool same) {
  const std::size_t n = a.size();
  const std::size_t m = b.size();
  spend(n * m);
  // Whether a step from a vertex of the first walk leaves it on the left.
  const auto is_left = [&](std::size_t i, Step e) {
    const Index out = leaves(a[i % n]);
    const Index in = leaves(a[(i + n - 1) % n] ^ 1U);
    return plus(leaves(e), corners_ - out) < plus(in, corners_ - out);
  };
  WalkCrossings result;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      if (a[i] % 2 != b[j] % 2 || (same && i == j)) continue;
      if (last_common(a, i, true, b, j, false) > 0 || last_common(a, i, false, b, j, false) > 0) continue;
      const std::size_t along = last_common(a, i, true, b, j, true);
      const std::size_t against = last_common(a, i, false, b, j, true);
      const std::size_t last = std::max(along, against);
      const bool from_left = is_left(i, b[(j + m - 1) % m] ^ 1U);
      const bool to_left = is_left(along > 0 ? i + along : i + n - against % n, b[(j + last) % m]);
      if (from_left == to_left) continue;
      result.steps.emplace_back(i, j);
      result.signs += to_left ? 1 : -1;
    }
  }
  return result;
}

/// A graph with a map to the radial graph that takes no two edges at a vertex to one. It grows by quadrangles, each
/// with two edges that are there.
class RadialGraph::Hull {
 public:
  explicit Hull(RadialGraph& graph) : graph_(graph) {}

  /// A lift of the centre, or of the vertex.
  Index add_vertex(bool is_centre) {
    graph_.spend(4 * graph_.corners_);  // With its memory.
    is_centre_.push_back(is_centre);
    parent_.push_back(parent_.size());
    ends_.resize(ends_.size() + graph_.corners_, kNoSide);
    return static_cast<Index>(parent_.size() - 1);
  }

  /// Edge number j, between a lift of the centre and one of the vertex.
  void add_edge(Index centre, Index j, Index vertex) {
    set_end(centre, j, vertex);
    set_end(vertex, j, centre);
    merge_all();
  }

  void identify(Index x, Index y) {
    equal_.emplace_back(x, y);
    merge_all();
  }

  /// Adds quadrangles until each two edges that are neighbours at a vertex are in one.
  void complete() {
    while (!changed_.empty()) {
      const std::size_t x = root_of(parent_, changed_.back());
      changed_.pop_back();
      for (Index k = 0; k < graph_.corners_; ++k) complete(x, k);
    }
  }

  /// Whether it is the radial graph itself.
  [[nodiscard]] bool is_all() {
    std::size_t vertices = 0;
    for (std::size_t x = 0; x < parent_.size(); ++x) {
      if (parent_[x] != x) continue;
      ++vertices;
      for (Index j = 0; j < graph_.corners_; ++j) {
        if (end(x, j) == kNoSide) return false;
      }
    }
    return vertices == 2;
  }

 private:
  [[nodiscard]] Index& end(std::size_t x, Index j) { return ends_[x * graph_.corners_ + j]; }

  void set_end(Index x, Index j, Index other) {
    const std::size_t root = root_of(parent_, x);
    Index& found = end(root, j);
    graph_.spend(1);
    if (found != kNoSide) {
      equal_.emplace_back(found, other);
      return;
    }
    found = other;
    changed_.push_back(static_cast<Index>(root));
  }

  /// What edges with one end and one image lead to is one vertex.
  void merge_all() {
    while (!equal_.empty()) {
      const std::size_t x = root_of(parent_, equal_.back().first);
      const std::size_t y = root_of(parent_, equal_.back().second);
      equal_.pop_back();
      if (x == y) continue;
      graph_.spend(graph_.corners_);
      parent_[y] = x;
      for (Index j = 0; j < graph_.corners_; ++j) {
        if (end(y, j) != kNoSide) set_end(static_cast<Index>(x), j, end(y, j));
      }
    }
  }

  [[nodiscard]] Index end_of(Index x, Index j) {
    const Index found = end(root_of(parent_, x), j);
    return found == kNoSide ? kNoSide : static_cast<Index>(root_of(parent_, found));
  }

  /// The quadrangle of side k of the polygon that has vertex x as a corner, if two edges there are its.
  void complete(std::size_t x, Index k) {
    graph_.spend(1);
    const Index next = graph_.plus(k, 1);
    const Index partner = graph_.partner_[k];
    const Index beyond = graph_.plus(partner, 1);
    const auto here = static_cast<Index>(x);
    if (is_centre_[here]) {
      // Corners: the centre, where the side starts, the centre beyond, where the side ends.
      const Index start = end_of(here, k);
      const Index stop = end_of(here, next);
      if (start == kNoSide || stop == kNoSide) return;
      close(start, beyond, stop, partner);
    } else {
      // The vertex where the side starts.
      const Index centre = end_of(here, k);
      const Index other = end_of(here, beyond);
      if (centre == kNoSide || other == kNoSide) return;
      close(centre, next, other, partner);
    }
  }

  /// Lets an edge of one vertex and one of another vertex have the same end.
  void close(Index x, Index j, Index y, Index k) {
    Index common = end_of(x, j);
    if (common == kNoSide) common = add_vertex(!is_centre_[x]);
    join(x, j, common);
    join(y, k, common);
  }

  void join(Index x, Index j, Index y) {
    if (is_centre_[x]) {
      add_edge(x, j, y);
    } else {
      add_edge(y, j, x);
    }
  }

  RadialGraph& graph_;
  std::vector<std::size_t> parent_;  ///< Of a vertex, in a set of those that are one.
  std::vector<bool> is_centre_;      ///< By vertex: whether it is a lift of the centre.
  std::vector<Index> ends_;          ///< By vertex and edge.
  std::vector<std::pair<Index, Index>> equal_;
  std::vector<Index> changed_;  ///< Vertices that have got an edge since their quadrangles were added.
};

bool RadialGraph::generate(const std::vector<const Walk*>& walks, const std::vector<Joint>& joints) {
  spend(walks.size() * walks.size() + joints.size());  // The caller has looked at all pairs of walks.
  Hull hull(*this);
  std::vector<std::vector<Index>> vertices;
  for (const Walk* walk : walks) {
    auto& own = vertices.emplace_back();
    for (const Step e : *walk) own.push_back(hull.add_vertex(e % 2 == 0));
  }
  for (std::size_t i = 0; i < walks.size(); ++i) {
    const std::size_t n = walks[i]->size();
    for (std::size_t k = 0; k < n; ++k) {
      const Step e = (*walks[i])[k];
      const Index start = vertices[i][k];
      const Index stop = vertices[i][(k + 1) % n];
      if (e % 2 == 0) {
        hull.add_edge(start, e / 2, stop);
      } else {
        hull.add_edge(stop, e / 2, start);
      }
    }
  }
  for (const Joint& joint : joints) {
    hull.identify(vertices[joint.walk][joint.step], vertices[joint.other_walk][joint.other_step]);
  }
  hull.complete();
  return hull.is_all();
}

}  // namespace epsnet::exact
