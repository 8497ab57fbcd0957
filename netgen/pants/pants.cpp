#include "netgen/pants/pants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "certify/check.h"
#include "certify/numbers/interval_arithmetic.h"
#include "netgen/base/gmp.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/curve_system.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet {
namespace {

/// A pants decomposition before the proof.
struct UnprovedPants {
  PantsGraph graph;
  std::vector<PantsPaths> pants;
  std::vector<Word> across;
  /// In a marking twists are not reduced: by edge, so many lengths less than the path across says. Otherwise empty.
  std::vector<double> turns = {};
};

/// Of the net in a pants file: any net will do.
constexpr double kEpsilon = 1;

PantsDecomposition with_coordinates(const Surface& surface, UnprovedPants found) {
  const std::vector<CuffCoordinates> cuffs =
      cuff_coordinates(surface, found.graph, found.pants, found.across, found.turns.empty());
  PantsDecomposition result{{}, std::move(found.graph), {}, {}};
  for (const auto& [paths] : found.pants) {
    result.pants.push_back({paths[0], paths[1], reversed(surface, concatenated(surface, paths[0], paths[1]))});
  }
  for (std::size_t e = 0; e < cuffs.size(); ++e) {
    const PantsGraph::End& end = result.graph.edges()[e][0];
    const auto& [length, twist, root] = cuffs[e];
    const double turns = found.turns.empty() ? 0 : found.turns[e];
    result.cuffs.push_back({result.pants[end.pants][end.cuff], length,
                            turns == 0 ? twist : certify::operator+(twist, certify::operator*(-turns, length)), root,
                            std::move(found.across[e])});
  }
  return result;
}

certify::PantsDocument document_of(const PantsDecomposition& pants, certify::NetDocument net) {
  certify::PantsDocument result{.net = std::move(net), .pants = {}, .cuffs = {}};
  for (const auto& paths : pants.pants) result.pants.push_back({letters_of(paths[0]), letters_of(paths[1])});
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) {
    const PantsDecomposition::Cuff& cuff = pants.cuffs[e];
    const auto& [first, second] = pants.graph.edges()[e];
    result.cuffs.push_back({.ends = {{{first.pants, first.cuff}, {second.pants, second.cuff}}},
                            .across = letters_of(cuff.across),
                            .length = cuff.length,
                            .twist = cuff.twist,
                            .exp_half_length = cuff.exact_root ? to_gmp(*cuff.exact_root) : mpq_class(0)});
  }
  return result;
}

PantsDecomposition proved_pants(const Surface& surface, UnprovedPants found, const PantsOptions& options) {
  PantsDecomposition result = with_coordinates(surface, std::move(found));
  NetOptions of_net;
  of_net.threads = options.threads;
  Certified<certify::PantsDocument>& file = result;
  file = proved(document_of(result, compute_net(surface, Length(kEpsilon), of_net).document), options.threads);
  return result;
}

// The pants of which fenchel_nielsen_surface makes surfaces: heptagons with side 0 glued to 2, and 3 to 5.

constexpr std::uint32_t kSides = 7;
constexpr std::array<std::uint32_t, 3> kCuffSide{6, 1, 4};

/// Returns the cuff on which a side of a heptagon lies; nothing, if the side is inside of the pants.
std::optional<std::uint32_t> cuff_of_side(std::uint32_t side) {
  const auto* const place = std::find(kCuffSide.begin(), kCuffSide.end(), side);
  return place == kCuffSide.end() ? std::nullopt : std::optional(static_cast<std::uint32_t>(place - kCuffSide.begin()));
}

/// Returns the pants that the tiles are, if they are such heptagons; not proved.
std::optional<UnprovedPants> own_pants(const Surface& surface) {
  if (surface.is_regular()) return std::nullopt;
  const auto count = static_cast<std::uint32_t>(surface.tiles().size());
  std::vector<PantsPaths> pants;
  for (const TileId p : surface.tile_ids()) {
    if (surface.tile(p).size() != kSides) return std::nullopt;
    const auto side = [&](std::uint32_t k) { return surface.side_number(p, k); };
    if (surface.partner(side(0)) != side(2) || surface.partner(side(3)) != side(5)) return std::nullopt;
    pants.push_back({{Word{side(0), side(3)}, Word{side(2)}}});
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> nodes;
  std::vector<PantsGraph::Edge> ends;
  std::vector<Word> across;
  for (const Gluing& g : surface.gluing()) {
    const auto cuff = cuff_of_side(g.side);
    const auto other_cuff = cuff_of_side(g.other_side);
    if (!cuff || !other_cuff) continue;
    nodes.emplace_back(g.tile, g.other_tile);
    ends.push_back({PantsGraph::End{g.tile, *cuff}, PantsGraph::End{g.other_tile, *other_cuff}});
    // The axis of cuff 2 passes the heptagon beyond side 0.
    Word& path = across.emplace_back();
    if (*cuff == 2) path.push_back(surface.side_number(TileId(g.tile), 0));
    path.push_back(surface.side_number(TileId(g.tile), g.side));
    if (*other_cuff == 2) path.push_back(surface.side_number(TileId(g.other_tile), 2));
  }
  if (nodes.size() * 2 != 3 * std::size_t{count}) return std::nullopt;
  PantsGraph graph(nodes);
  // Marks depend on the numbers of cuffs.
  if (graph.edges() != ends) return std::nullopt;
  return UnprovedPants{std::move(graph), std::move(pants), std::move(across)};
}

/// Returns a closed path with its tile.
ClosedPath closed_path(const Surface& surface, std::size_t number, const Word& word) {
  if (word.empty()) throw CurveError(number, "a path without letters is trivial");
  if (const auto problem = closed_path_problem(surface, word)) throw CurveError(number, *problem);
  return {surface.tile_of_side(word.front()), concatenated(surface, {}, word)};
}

/// Adds given curves to a system.
void add_given(const Surface& surface, std::span<const Word> curves, CurveSystem& system) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const ClosedPath path = closed_path(surface, i, curves[i]);
    if (path.word.empty() || system.is_trivial(path)) throw CurveError(i, "null-homotopic");
    if (const auto lift = system.lift_on(path)) {
      throw CurveError(i, "homotopic to curve " + std::to_string(lift->side.curve) + ", or to a power of it");
    }
    const std::uint32_t number = system.add(path);
    if (const std::uint32_t exponent = system.exponent(number); exponent != 1) {
      throw CurveError(i, "power " + std::to_string(exponent) + " of another closed curve");
    }
    if (const auto other = system.crossed(path)) {
      throw CurveError(i, *other == number ? "not simple: its geodesic crosses itself"
                                           : "its geodesic crosses that of curve " + std::to_string(*other));
    }
  }
}

/// Adds short simple closed geodesics that are disjoint, each time the shortest, up to as many as there can be.
void add_short(const Surface& surface, const PantsOptions& options, CurveSystem& system) {
  const std::size_t wanted = 3 * std::size_t{surface.genus()} - 3;
  GeodesicsOptions geodesics;
  geodesics.threads = options.threads;
  geodesics.progress = options.progress;
  const auto add_from = [&](const certify::GeodesicsDocument& document, std::size_t from) {
    for (std::size_t i = from; i < document.geodesics.size() && system.size() < wanted; ++i) {
      const auto& geodesic = document.geodesics[i];
      if (!geodesic.simple) continue;
      const auto& vertex = document.net.vertices[geodesic.vertex];
      const ClosedPath path{TileId(document.net.charts[vertex.chart].tile), word_of_letters(geodesic.word)};
      if (system.crossed(path) || system.lift_on(path)) continue;
      system.add(path);
    }
  };
  const certify::GeodesicsDocument first = unproved::systole(surface, geodesics);
  add_from(first, 0);
  // Longer ones, as long as that does not take seconds. Curves that are made around arcs instead get as long as those
  // before them together, and soon too long for 256 bits.
  constexpr double kMostWork = 3e6;
  std::size_t known = 0;
  for (double length = std::ceil(first.geodesics[0].length.upper + 0.5);
       system.size() < wanted && std::exp(length) * (surface.genus() - 1) <= kMostWork; length += 1) {
    const certify::GeodesicsDocument document = unproved::spectrum(surface, Length(length), geodesics);
    add_from(document, known);
    known = document.geodesics.size();
  }
}

/// The side of a curve of a system that a cuff is, and the path of a pair of pants for it.
struct FoundPants {
  std::array<ClosedPath, 3> cuffs;
  std::array<CurveSystem::Side, 3> sides;
};

/// Returns pants beside all curves, and adds the curves that are missing.
std::vector<FoundPants> complete(const Surface& surface, CurveSystem& system) {
  const std::size_t wanted = 2 * std::size_t{surface.genus()} - 2;
  std::vector<FoundPants> result;
  std::vector<std::array<bool, 2>> taken;
  const auto take = [&](CurveSystem::Side side) {
    taken.resize(system.size());
    bool& mark = taken[side.curve][side.reversed ? 1 : 0];
    if (mark) throw NetError("two pairs of pants overlap");
    mark = true;
  };
  for (std::uint32_t c = 0; c < system.size(); ++c) {
    for (const bool reversed : {false, true}) {
      taken.resize(system.size());
      if (taken[c][reversed ? 1 : 0]) continue;
      if (result.size() == wanted) throw NetError("more than " + std::to_string(wanted) + " pairs of pants");
      const CurveSystem::Side side{c, reversed};
      FoundPants found{system.pants_beside(side), {side, side, side}};
      take(side);
      for (std::size_t k = 1; k < 3; ++k) {
        if (const auto lift = system.lift_on(found.cuffs[k])) {
          found.sides[k] = lift->side;
        } else {
          found.sides[k] = {system.add(found.cuffs[k]), false};
        }
        take(found.sides[k]);
      }
      result.push_back(std::move(found));
    }
  }
  return result;
}

/// Returns the pants with the cuffs in the order that the edges of a graph give them, and paths across the edges.
UnprovedPants assembled(const Surface& surface, const CurveSystem& system, const std::vector<FoundPants>& found,
                        const std::vector<std::uint32_t>& order) {
  // By curve and side: the pants, and the place of the cuff among those found.
  std::vector<std::array<PantsGraph::End, 2>> beside(system.size());
  for (std::uint32_t p = 0; p < found.size(); ++p) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [curve, reversed] = found[p].sides[k];
      beside[curve][reversed ? 1 : 0] = {p, k};
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> nodes;
  nodes.reserve(order.size());
  for (const std::uint32_t c : order) nodes.emplace_back(beside[c][0].pants, beside[c][1].pants);
  PantsGraph graph(nodes);
  // By pants and cuff of the graph: the side of a curve.
  std::vector<std::array<CurveSystem::Side, 3>> sides(found.size());
  std::vector<std::array<std::uint32_t, 3>> places(found.size());
  for (std::size_t e = 0; e < order.size(); ++e) {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [p, cuff] = graph.edges()[e][i];
      sides[p][cuff] = {order[e], i == 1};
      places[p][cuff] = beside[order[e]][i].cuff;
    }
  }
  std::vector<PantsPaths> pants;
  for (std::size_t p = 0; p < found.size(); ++p) {
    // The product of the three in their order is 1, or else conjugates of them are taken for which it is so.
    const auto& cuffs = found[p].cuffs;
    pants.push_back({{cuffs[places[p][0]].word, cuffs[places[p][1]].word}});
  }
  const auto path_of = [&](const PantsGraph::End& end) {
    const auto& [first, second] = pants[end.pants].cuffs;
    const TileId tile = found[end.pants].cuffs[0].tile;
    if (end.cuff < 2) return ClosedPath{tile, end.cuff == 0 ? first : second};
    return ClosedPath{tile, reversed(surface, concatenated(surface, first, second))};
  };
  std::vector<Word> across;
  for (std::size_t e = 0; e < order.size(); ++e) {
    std::array<Word, 2> ways;
    for (std::size_t i = 0; i < 2; ++i) {
      const PantsGraph::End& end = graph.edges()[e][i];
      auto lift = system.lift_on(path_of(end));
      if (!lift || lift->side != sides[end.pants][end.cuff]) throw NetError("a cuff is on another side of its curve");
      ways[i] = std::move(lift->way);
    }
    across.push_back(concatenated(surface, ways[0], reversed(surface, ways[1])));
  }
  return {std::move(graph), std::move(pants), std::move(across)};
}

}  // namespace

FenchelNielsen PantsDecomposition::coordinates() const {
  FenchelNielsen result{graph, {}, {}};
  const auto middle = [](certify::Interval x) { return Rational((Rational(x.lower) + Rational(x.upper)) / 2); };
  for (const Cuff& cuff : cuffs) {
    result.lengths.push_back(middle(cuff.length));
    result.twists.push_back(middle(cuff.twist));
  }
  return result;
}

PantsDecomposition pants_decomposition(const Surface& surface, const PantsOptions& options) {
  if (options.own && options.curves.empty()) {
    if (auto found = own_pants(surface)) {
      PantsDecomposition result = proved_pants(surface, *std::move(found), options);
      result.own = true;
      return result;
    }
  }
  CurveSystem system(surface);
  add_given(surface, options.curves, system);
  const std::uint32_t given = system.size();
  if (given < 3 * surface.genus() - 3) add_short(surface, options, system);
  const std::vector<FoundPants> found = complete(surface, system);
  std::vector<std::uint32_t> order(system.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin() + given, order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return system.length(a) < system.length(b); });
  return proved_pants(surface, assembled(surface, system, found, order), options);
}

PantsDecomposition marked_pants(const Surface& surface, const certify::PantsDocument& marking,
                                const PantsOptions& options) {
  if (certify::check(marking).verdict != certify::Verdict::verified)
    throw SurfaceError("the pants file of the marking is not verified");
  const Surface marked = from_document(marking.net.surface);
  bool alike = marked.side_count() == surface.side_count() && marked.tiles().size() == surface.tiles().size();
  for (const SideId s : surface.side_ids()) {
    alike = alike && marked.partner(s) == surface.partner(s) && marked.tile_of_side(s) == surface.tile_of_side(s);
  }
  if (!alike) throw SurfaceError("the surface of the marking has other tiles, or they are glued otherwise");
  std::vector<std::pair<std::uint32_t, std::uint32_t>> nodes;
  std::vector<PantsGraph::Edge> ends;
  UnprovedPants found{PantsGraph::chain(2), {}, {}};
  for (const auto& paths : marking.pants)
    found.pants.push_back({{word_of_letters(paths[0]), word_of_letters(paths[1])}});
  for (const certify::PantsDocument::Cuff& cuff : marking.cuffs) {
    const auto& [first, second] = cuff.ends;
    nodes.emplace_back(first[0], second[0]);
    ends.push_back({PantsGraph::End{first[0], first[1]}, PantsGraph::End{second[0], second[1]}});
    found.across.push_back(word_of_letters(cuff.across));
  }
  found.graph = PantsGraph(nodes);
  if (found.graph.edges() != ends)
    throw SurfaceError("the cuffs of the marking are numbered otherwise than by its edges");
  // The twists of the file are those of its own surface.
  const std::vector<CuffCoordinates> own = cuff_coordinates(marked, found.graph, found.pants, found.across, false);
  for (std::size_t e = 0; e < own.size(); ++e)
    found.turns.push_back(std::round((own[e].twist.lower - marking.cuffs[e].twist.lower) / own[e].length.lower));
  return proved_pants(surface, std::move(found), options);
}

void require_disjoint_curves(const Surface& surface, std::span<const Word> curves) {
  CurveSystem system(surface);
  add_given(surface, curves, system);
}

std::string graph_text(const PantsGraph& graph) {
  std::string result;
  for (const auto& [first, second] : graph.edges()) {
    if (!result.empty()) result += ' ';
    result += std::to_string(first.pants) + '-' + std::to_string(second.pants);
  }
  return result;
}

}  // namespace epsnet
