#include "netgen/surfaces/fenchel_nielsen.h"

#include <algorithm>
#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <charconv>
#include <string>
#include <utility>

#include "netgen/base/disjoint_sets.h"
#include "netgen/surfaces/exact_pants.h"
#include "triangulation/surface/exact_polygons.h"

namespace epsnet {
namespace {

/// A matrix of PGL₂(Q) with positive determinant, acting on the upper half-plane.
struct Matrix {
  Rational a, b, c, d;

  [[nodiscard]] Complex<Rational> operator()(const Complex<Rational>& z) const {
    const Complex<Rational> numerator{a * z.x + b, a * z.y};
    const Complex<Rational> denominator{c * z.x + d, c * z.y};
    return numerator / denominator;
  }
};

Matrix operator*(const Matrix& m, const Matrix& n) {
  return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c, m.c * n.b + m.d * n.d};
}

/// Returns the inverse up to a factor.
Matrix inverse(const Matrix& m) { return {m.d, -m.b, -m.c, m.a}; }

/// A pair of pants in the upper half-plane: the generators D_k of its group are translations along the boundary, the
/// pants on their left, D1 D2 D3 = 1; N_k takes the axis from 0 to ∞ to that of D_k.
struct Pants {
  std::array<Matrix, 3> generator;
  std::array<Matrix, 3> axis;
};

Pants pants(const std::array<Rational, 3>& r) {
  const auto& [r1, r2, r3] = r;
  const Rational t2 = r2 + 1 / r2;
  const Rational t3 = r3 + 1 / r3;
  // D1 = diag(r1, 1/r1), D2 = (a b; c d) with determinant 1, tr D2 = t2 and tr D1 D2 = −t3: the sign makes it a pair of
  // pants. c is free; it scales the picture, and this one has the pants around i.
  const Rational a = -(t3 + t2 / r1) / (r1 - 1 / r1);
  const Rational d = t2 - a;
  const Mp1024 size = sqrt(Mp1024(Rational((d - r2) * (d + r1 * r3))));
  const Rational c = simplest_near(size, 3);
  const Matrix first{r1, 0, 0, 1 / r1};
  const Matrix second{a, (a * d - 1) / c, c, d};
  const auto axis = [](const Rational& from, const Rational& to) { return Matrix{to, from, 1, 1}; };
  return {{first, second, inverse(first * second)},
          {Matrix{1, 0, 0, 1}, axis((1 / r2 - d) / c, (r2 - d) / c), axis((-r1 * r3 - d) / c, (-r1 / r3 - d) / c)}};
}

/// Returns the square of the height f of the mark of cuff k: N_k(i f) is the foot of the common perpendicular with cuff
/// k + 1. It is the product of the ends of the axis of cuff k + 1 in the coordinates where that of cuff k runs from 0
/// to ∞.
Rational squared_mark(const Pants& p, std::uint32_t k) {
  const Matrix other = inverse(p.axis[k]) * p.axis[(k + 1) % 3];
  return (other.b / other.d) * (other.a / other.c);
}

Complex<Rational> to_disk(const Complex<Rational>& z) {
  const Complex<Rational> i{0, 1};
  return (z - i) / (z + i);
}

/// Returns the pants cut open along two arcs between the base points P_k = N_k(i y_k): the convex heptagon P1, P2,
/// D2 P2, D2 P1, D2 P3, D1⁻¹ P3, D1⁻¹ P1.
Tile heptagon(const Pants& p, const std::array<Rational, 3>& y) {
  std::array<Complex<Rational>, 3> base;
  for (std::size_t k = 0; k < 3; ++k) {
    base[k] = p.axis[k]({0, y[k]});
  }
  const Matrix& second = p.generator[1];
  const Matrix back = inverse(p.generator[0]);
  Tile tile{base[0], base[1], second(base[1]), second(base[0]), second(base[2]), back(base[2]), back(base[0])};
  for (Complex<Rational>& vertex : tile) {
    vertex = to_disk(vertex);
  }
  return tile;
}

/// The sides of the heptagon that lie on the cuffs.
constexpr std::array<std::uint32_t, 3> kCuffSide{6, 1, 4};

std::string edge_name(const FenchelNielsen& coordinates, std::size_t e) {
  const auto& [first, second] = coordinates.graph.edges()[e];
  return "edge " + std::to_string(e) + " (" + std::to_string(first.pants) + "-" + std::to_string(second.pants) + ")";
}

void check(const FenchelNielsen& coordinates) {
  const std::size_t n = coordinates.graph.edges().size();
  const auto require_count = [n](const char* what, std::size_t count) {
    if (count != n) {
      throw SurfaceError(std::to_string(count) + " " + what + " for a pants graph with " + std::to_string(n) +
                         " edges");
    }
  };
  require_count("lengths", coordinates.lengths.size());
  require_count("twists", coordinates.twists.size());
  const Rational shortest(1, boost::multiprecision::pow(Integer(10), 25));
  const Rational longest = 100;
  const Rational largest_twist = boost::multiprecision::pow(Integer(10), 100);
  for (std::size_t e = 0; e < n; ++e) {
    const Rational& length = coordinates.lengths[e];
    if (length < shortest || length > longest) {
      throw CoordinateError("lengths", edge_name(coordinates, e) +
                                           ": a length must be at least 1e-25 and at most 100, not " +
                                           (length <= 0         ? "zero or negative"
                                            : length < shortest ? "less"
                                                                : "more"));
    }
    if (abs(coordinates.twists[e]) > largest_twist) {
      throw CoordinateError("twists", edge_name(coordinates, e) + ": a twist must be at most 1e100");
    }
  }
}

/// All pairs of pants, and r = exp(length/2) of each edge.
struct Construction {
  std::vector<Rational> r;
  std::vector<Pants> pieces;
};

bool is_exact(const std::vector<std::optional<ExactLength>>& lengths, std::size_t e) {
  return !lengths.empty() && lengths[e];
}

/// exp(length/2) of an exact length, if it is rational.
std::optional<Rational> rational_exponential(const FenchelNielsen& coordinates, std::size_t e) {
  if (!is_exact(coordinates.exact_lengths, e)) return std::nullopt;
  const std::optional<Rational> cosh = rational_value(cosh_text(*coordinates.exact_lengths[e], Rational(1, 2)));
  const std::optional<Rational> sinh = cosh ? rational_root(Rational(*cosh * *cosh - 1)) : std::nullopt;
  return sinh ? std::optional(Rational(*cosh + *sinh)) : std::nullopt;
}

/// Requires: `check`.
Construction construction(const FenchelNielsen& coordinates) {
  Construction result;
  const PantsGraph& graph = coordinates.graph;
  std::vector<Rational>& r = result.r;
  for (std::size_t e = 0; e < coordinates.lengths.size(); ++e) {
    if (const std::optional<Rational> exact = rational_exponential(coordinates, e)) {
      r.push_back(*exact);
      continue;
    }
    // Rounding r − 1 keeps the relative accuracy of short lengths: d ln r ≤ dr and r − 1 ≤ ½ length · r.
    r.push_back(1 + simplest_near(expm1(Mp1024(Rational(coordinates.lengths[e] / 2))), 52));
  }
  for (std::uint32_t p = 0; p < graph.pants_count(); ++p)
    result.pieces.push_back(pants({r[graph.edge_at(p, 0)], r[graph.edge_at(p, 1)], r[graph.edge_at(p, 2)]}));
  return result;
}

/// The product of heights that gives a symmetric twist exactly, f f′ or f f′/r, if it is rational, as it is between
/// equal cuffs of equal pants.
std::optional<Rational> exact_product(const Construction& made, const PantsGraph::Edge& edge, const Rational& r,
                                      const Rational& share) {
  const auto& [first, second] = edge;
  std::optional<Rational> product = rational_root(squared_mark(made.pieces[first.pants], first.cuff) *
                                                  squared_mark(made.pieces[second.pants], second.cuff));
  if (product && share != 0) *product /= r;
  return product;
}

/// The edges with a symmetric twist that is not exact.
std::vector<std::size_t> rounded_twists(const FenchelNielsen& coordinates, const Construction& made) {
  std::vector<std::size_t> result;
  for (std::size_t e = 0; e < made.r.size(); ++e) {
    const Rational share = share_of_twist(coordinates, e);
    if (is_symmetric_share(share) && !exact_product(made, coordinates.graph.edges()[e], made.r[e], share))
      result.push_back(e);
  }
  return result;
}

/// Whether all that is given exactly is exact: lengths of which exp(length/2) is rational, and symmetric twists.
bool has_all_that_is_exact(const FenchelNielsen& coordinates) {
  for (std::size_t e = 0; e < coordinates.lengths.size(); ++e) {
    if (is_exact(coordinates.exact_lengths, e) && !rational_exponential(coordinates, e)) return false;
    if (is_exact(coordinates.exact_twists, e) && !is_symmetric_share(share_of_twist(coordinates, e))) return false;
  }
  return true;
}

/// The numbers of the surface, if exp(length/2) and rounded twists do not do.
std::optional<PantsNumbers> numbers_of_exact_pants(const FenchelNielsen& coordinates, const Construction& made) {
  if (has_all_that_is_exact(coordinates) && rounded_twists(coordinates, made).empty()) return std::nullopt;
  return pants_numbers(coordinates);
}

}  // namespace

Rational share_of_twist(const FenchelNielsen& coordinates, std::size_t e) {
  Rational turns = coordinates.twists[e] / coordinates.lengths[e];
  if (is_exact(coordinates.exact_lengths, e) && is_exact(coordinates.exact_twists, e) &&
      coordinates.exact_lengths[e]->cosh == coordinates.exact_twists[e]->cosh) {
    turns = coordinates.exact_twists[e]->times / coordinates.exact_lengths[e]->times;
  }
  turns += Rational(1, 2);
  Integer whole = numerator(turns) / denominator(turns);
  if (Rational(whole) > turns) --whole;
  return turns - Rational(whole) - Rational(1, 2);
}

std::vector<std::size_t> rounded_symmetric_twists(const FenchelNielsen& coordinates) {
  check(coordinates);
  const Construction made = construction(coordinates);
  if (numbers_of_exact_pants(coordinates, made)) return {};
  return rounded_twists(coordinates, made);
}

namespace {

/// Looks for an automorphism of a pants graph that keeps lengths and twists, and that keeps the order of cuffs at one
/// end of an edge and reverses it at the other end.
class LostSymmetrySearch {
 public:
  explicit LostSymmetrySearch(const FenchelNielsen& coordinates)
      : graph_(coordinates.graph), image_(graph_.pants_count()), is_taken_(graph_.pants_count()) {
    for (std::size_t e = 0; e < graph_.edges().size(); ++e) {
      turns_.push_back(share_of_twist(coordinates, e));
      lengths_.push_back(coordinates.lengths[e]);
    }
    // Each pair of pants after one that it is glued to.
    std::vector<bool> seen(graph_.pants_count());
    seen[0] = true;
    order_.push_back(0);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      for (std::uint32_t cuff = 0; cuff < 3; ++cuff) {
        const std::uint32_t next = across({order_[i], cuff}).pants;
        if (!seen[next]) order_.push_back(next);
        seen[next] = true;
      }
    }
  }

  std::optional<std::vector<std::uint32_t>> find() {
    if (!place(0)) return std::nullopt;
    std::vector<std::uint32_t> images;
    for (const PantsGraph::Edge& edge : graph_.edges()) images.push_back(edge_at(image(edge[0])));
    return images;
  }

 private:
  using End = PantsGraph::End;
  struct Image {
    std::uint32_t pants;
    std::array<std::uint32_t, 3> cuffs;
    bool reverses;
  };

  [[nodiscard]] std::uint32_t edge_at(const End& end) const { return graph_.edge_at(end.pants, end.cuff); }
  [[nodiscard]] End image(const End& end) const {
    return {image_[end.pants]->pants, image_[end.pants]->cuffs[end.cuff]};
  }
  [[nodiscard]] End across(const End& end) const {
    const PantsGraph::Edge& edge = graph_.edges()[edge_at(end)];
    return edge[0] == end ? edge[1] : edge[0];
  }
  [[nodiscard]] bool has_loop(std::uint32_t pants) const {
    const auto edge = [&](std::uint32_t cuff) { return graph_.edge_at(pants, cuff); };
    return edge(0) == edge(1) || edge(1) == edge(2) || edge(2) == edge(0);
  }

  /// Whether edges go to edges with the same numbers, as far as both of their ends have images.
  [[nodiscard]] bool fits(std::uint32_t pants) const {
    for (std::uint32_t cuff = 0; cuff < 3; ++cuff) {
      const std::uint32_t edge = edge_at({pants, cuff});
      const std::uint32_t other = edge_at(image({pants, cuff}));
      if (lengths_[edge] != lengths_[other] || turns_[edge] != turns_[other]) return false;
      const End there = across({pants, cuff});
      if (image_[there.pants] && across(image({pants, cuff})) != image(there)) return false;
    }
    return true;
  }

  [[nodiscard]] bool loses_order() const {
    return std::any_of(graph_.edges().begin(), graph_.edges().end(), [&](const PantsGraph::Edge& edge) {
      const auto& [one, other] = edge;
      return !has_loop(one.pants) && !has_loop(other.pants) &&
             image_[one.pants]->reverses != image_[other.pants]->reverses;
    });
  }

  /// The pairs of pants that one may go to: any, if it is the first, else the one across from an image.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> range_for(std::uint32_t pants) const {
    for (std::uint32_t cuff = 0; cuff < 3; ++cuff) {
      const End there = across({pants, cuff});
      if (!image_[there.pants]) continue;
      const std::uint32_t to = across(image(there)).pants;
      return {to, to + 1};
    }
    return {0, graph_.pants_count()};
  }

  /// Tries all images of the pairs of pants from number i of `order_` on.
  bool place(std::size_t i) {
    constexpr std::uint64_t kMostSteps = 100'000;
    if (i == order_.size()) return loses_order();
    std::optional<Image>& here = image_[order_[i]];
    const auto [begin, end] = range_for(order_[i]);
    for (std::uint32_t to = begin; to < end; ++to) {
      if (is_taken_[to]) continue;
      is_taken_[to] = true;
      for (const bool reverses : {false, true}) {
        for (std::uint32_t first = 0; first < 3; ++first) {
          if (++steps_ > kMostSteps) return false;
          const std::uint32_t step = reverses ? 2 : 1;
          here = Image{to, {first, (first + step) % 3, (first + 2 * step) % 3}, reverses};
          if (fits(order_[i]) && place(i + 1)) return true;
        }
      }
      here.reset();
      is_taken_[to] = false;
    }
    return false;
  }

  const PantsGraph& graph_;
  std::vector<Rational> turns_;
  std::vector<Rational> lengths_;
  std::vector<std::uint32_t> order_;
  std::vector<std::optional<Image>> image_;
  std::vector<bool> is_taken_;
  std::uint64_t steps_ = 0;
};

}  // namespace

std::optional<std::vector<std::uint32_t>> symmetry_lost_by_order(const FenchelNielsen& coordinates) {
  check(coordinates);
  constexpr std::uint32_t kMostPants = 1000;
  if (coordinates.graph.pants_count() > kMostPants) return std::nullopt;
  return LostSymmetrySearch(coordinates).find();
}

std::vector<std::string> symmetry_remarks(const FenchelNielsen& coordinates) {
  std::vector<std::string> remarks;
  if (const std::vector<std::size_t> edges = rounded_symmetric_twists(coordinates); !edges.empty()) {
    std::string text = edges.size() > 1 ? "rounded: the twists of edges " : "rounded: the twist of edge ";
    for (std::size_t i = 0; i < edges.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(edges[i]);
    remarks.push_back(text + (edges.size() > 1 ? " are" : " is") +
                      " 0 or half of the length only up to 2^-50 lengths: reflections may be lost");
  }
  if (const std::optional<std::vector<std::uint32_t>> images = symmetry_lost_by_order(coordinates)) {
    constexpr std::size_t kMostNamed = 6;
    std::string text = "note: the pants graph, lengths and twists stay the same if edges";
    std::size_t moved = 0;
    for (std::size_t e = 0; e < images->size(); ++e) {
      if ((*images)[e] == e || ++moved > kMostNamed) continue;
      text += (moved == 1 ? " " : ", ") + std::to_string(e) + " -> " + std::to_string((*images)[e]);
    }
    remarks.push_back(text + (moved > kMostNamed ? ", ..." : "") +
                      " are exchanged, but the order of cuffs around pairs of pants does not: the surface may lack "
                      "this symmetry, and with another order of edges be another one (docs/fenchel-nielsen.md)");
  }
  return remarks;
}

Surface fenchel_nielsen_surface(const FenchelNielsen& coordinates) {
  check(coordinates);
  const PantsGraph& graph = coordinates.graph;
  const std::size_t n = graph.edges().size();
  const Construction made = construction(coordinates);
  if (const auto numbers = numbers_of_exact_pants(coordinates, made)) return surface_of_pants(coordinates, *numbers);
  const auto& [r, pieces] = made;

  std::vector<std::array<Rational, 3>> y(pieces.size());
  std::vector<Gluing> gluing;
  for (std::uint32_t p = 0; p < graph.pants_count(); ++p) {
    gluing.push_back({p, 0, p, 2});
    gluing.push_back({p, 3, p, 5});
  }
  // A file has room for 1 MiB of text (docs/format.md), a few thousand edges.
  constexpr std::size_t kMostText = (std::size_t{1} << 20) - 64;
  std::size_t left_out = 0;
  std::string about = "Fenchel-Nielsen, exactly: per edge the two pants with their cuffs, r = exp(length/2), s";
  for (std::size_t e = 0; e < n; ++e) {
    const auto& [first, second] = graph.edges()[e];
    const Rational& length = coordinates.lengths[e];
    const Rational share = share_of_twist(coordinates, e);
    const Rational twist = share * length;
    // The base points lie at the heights y on the two sides; gluing them gives the twist ln(y y'/(f f')). Only the
    // product matters, so the first height may be rough, as long as its error is small compared with the cuff.
    const int cuff_bits = std::max(3, 3 - static_cast<int>(ilogb(Mp1024(length))));
    const Mp1024 half_turn = exp(Mp1024(Rational(twist / 2)));
    const Mp1024 f = sqrt(Mp1024(squared_mark(pieces[first.pants], first.cuff)));
    const Mp1024 f2 = sqrt(Mp1024(squared_mark(pieces[second.pants], second.cuff)));
    const Rational own = simplest_near(f * half_turn, cuff_bits);
    const std::optional<Rational> exact =
        is_symmetric_share(share) ? exact_product(made, graph.edges()[e], r[e], share) : std::nullopt;
    const Rational other =
        exact ? *exact / own : simplest_near(f * f2 * half_turn * half_turn / Mp1024(own), cuff_bits + 49);
    y[first.pants][first.cuff] = own;
    y[second.pants][second.cuff] = other;
    gluing.push_back({first.pants, kCuffSide[first.cuff], second.pants, kCuffSide[second.cuff]});
    const std::string used = "; " + std::to_string(first.pants) + "." + std::to_string(first.cuff) + "-" +
                             std::to_string(second.pants) + "." + std::to_string(second.cuff) + " r=" + r[e].str() +
                             " s=" + Rational(own * other).str();
    if (left_out > 0 || about.size() + used.size() > kMostText) {
      ++left_out;
    } else {
      about += used;
    }
  }
  if (left_out > 0) about += "; and " + std::to_string(left_out) + " more edges";
  std::vector<Tile> tiles;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    tiles.push_back(heptagon(pieces[p], y[p]));
  }
  Surface surface(std::move(tiles), std::move(gluing));
  surface.set_about(std::move(about));
  return surface;
}

FenchelNielsen random_coordinates(PantsGraph graph, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  // Multiples of a millionth are fine enough, and exact.
  constexpr std::uint32_t kSteps = 1'000'000;
  const auto uniform = [&](const Rational& from, const Rational& to) {
    const auto step = boost::random::uniform_int_distribution<std::uint32_t>(0, kSteps - 1)(engine);
    return Rational(from + (to - from) * Rational(step, kSteps));
  };
  std::vector<Rational> lengths, twists;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    lengths.push_back(uniform(1, 4));
    twists.push_back(uniform(0, lengths.back()));
  }
  return {std::move(graph), std::move(lengths), std::move(twists)};
}

namespace {

using NodePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void require_genus(std::uint32_t genus) {
  if (genus < 2 || genus > kLargestGraphGenus) {
    throw PantsGraphError("the genus must be at least 2 and at most " + std::to_string(kLargestGraphGenus) + ", not " +
                          std::to_string(genus));
  }
}

/// Returns the number of nodes reached from node 0.
std::size_t reached(const NodePairs& edges, std::size_t nodes) {
  DisjointSets components(nodes);
  for (const auto& [a, b] : edges) components.join(a, b);
  std::size_t count = 0;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    count += components.find(node) == 0 ? 1 : 0;
  }
  return count;
}

/// Adds a node of `tree` with `leaves` leaves below it; returns its number. The caller adds the edge to its parent.
std::uint32_t grow(std::uint32_t leaves, std::uint32_t& nodes, NodePairs& edges) {
  const std::uint32_t node = nodes++;
  if (leaves == 1) {
    edges.emplace_back(node, node);
    return node;
  }
  for (const std::uint32_t part : {leaves / 2, leaves - leaves / 2}) {
    const std::uint32_t child = grow(part, nodes, edges);
    edges.emplace_back(node, child);
  }
  return node;
}

}  // namespace

PantsGraph::PantsGraph(const NodePairs& edges) {
  if (edges.size() < 3 || edges.size() % 3 != 0) {
    throw PantsGraphError("a trivalent graph of genus g has 3g - 3 edges, g at least 2, not " +
                          std::to_string(edges.size()));
  }
  require_genus(static_cast<std::uint32_t>(std::min<std::size_t>(edges.size() / 3 + 1, kLargestGraphGenus + 1)));
  const std::size_t nodes = edges.size() / 3 * 2;
  std::vector<std::uint32_t> cuffs(nodes, 0);
  at_.resize(3 * nodes);
  for (const auto& [a, b] : edges) {
    Edge edge{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::uint32_t node = i == 0 ? a : b;
      if (node >= nodes) {
        throw PantsGraphError("node " + std::to_string(node) + ": a trivalent graph with " +
                              std::to_string(edges.size()) + " edges has the nodes 0 to " + std::to_string(nodes - 1));
      }
      if (cuffs[node] == 3) {
        throw PantsGraphError("node " + std::to_string(node) + " has more than three edges; a loop counts twice");
      }
      edge[i] = {node, cuffs[node]++};
      at_[3 * std::size_t{node} + edge[i].cuff] = static_cast<std::uint32_t>(edges_.size());
    }
    edges_.push_back(edge);
  }
  if (const std::size_t count = reached(edges, nodes); count != nodes) {
    throw PantsGraphError("the graph is not connected: " + std::to_string(count) + " of " + std::to_string(nodes) +
                          " nodes are reached from node 0");
  }
}

PantsGraph PantsGraph::chain(std::uint32_t genus) {
  require_genus(genus);
  const std::uint32_t last = 2 * genus - 3;
  NodePairs edges{{0, 0}};
  for (std::uint32_t node = 0; node < last; ++node) {
    for (std::uint32_t k = 0; k < 1 + node % 2; ++k) {
      edges.emplace_back(node, node + 1);
    }
  }
  edges.emplace_back(last, last);
  return PantsGraph(edges);
}

PantsGraph PantsGraph::ring(std::uint32_t genus) {
  require_genus(genus);
  const std::uint32_t nodes = 2 * genus - 2;
  NodePairs edges;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    for (std::uint32_t k = 0; k < 2 - node % 2; ++k) {
      edges.emplace_back(node, (node + 1) % nodes);
    }
  }
  return PantsGraph(edges);
}

PantsGraph PantsGraph::tree(std::uint32_t genus) {
  require_genus(genus);
  NodePairs edges;
  std::uint32_t nodes = 0;
  // Two halves, joined by an edge.
  const std::uint32_t left = grow(genus / 2, nodes, edges);
  const std::uint32_t right = grow(genus - genus / 2, nodes, edges);
  edges.emplace_back(left, right);
  return PantsGraph(edges);
}

PantsGraph PantsGraph::random(std::uint32_t genus, std::uint64_t seed) {
  require_genus(genus);
  const std::uint32_t nodes = 2 * genus - 2;
  boost::random::mt19937_64 engine(seed);
  std::vector<std::uint32_t> ends;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    ends.insert(ends.end(), 3, node);
  }
  for (;;) {
    for (std::size_t i = ends.size(); i > 1; --i) {
      std::swap(ends[i - 1], ends[boost::random::uniform_int_distribution<std::size_t>(0, i - 1)(engine)]);
    }
    NodePairs edges;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      edges.emplace_back(ends[i], ends[i + 1]);
    }
    if (reached(edges, nodes) == nodes) {
      return PantsGraph(edges);
    }
  }
}

PantsGraph PantsGraph::parse(std::string_view text) {
  NodePairs edges;
  const auto number = [&](std::string_view digits, std::string_view edge) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) {
      throw PantsGraphError("an edge of a pants graph is two nodes as in \"0-1\", not \"" +
                            std::string(edge.substr(0, 40)) + "\"");
    }
    return value;
  };
  constexpr std::string_view kSeparators = " ,\t\n";
  for (std::size_t start = text.find_first_not_of(kSeparators); start != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, start), text.size());
    const std::string_view edge = text.substr(start, end - start);
    const std::size_t dash = std::min(edge.find('-'), edge.size());
    const std::string_view second = dash < edge.size() ? edge.substr(dash + 1) : std::string_view();
    edges.emplace_back(number(edge.substr(0, dash), edge), number(second, edge));
    start = text.find_first_not_of(kSeparators, end);
  }
  return PantsGraph(edges);
}

}  // namespace epsnet
