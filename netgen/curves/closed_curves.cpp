#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "certify/numbers/isometry.h"
#include "netgen/curves/curves.h"
#include "netgen/curves/radial_graph.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/curve_system.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/exact_isometries.h"

namespace epsnet {
namespace {

using IntegerVector = std::vector<std::int64_t>;

/// By basis vector: the value of a form at x and this vector.
IntegerVector products(const std::vector<IntegerVector>& form, const IntegerVector& x) {
  IntegerVector result(form.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] == 0) continue;
    for (std::size_t j = 0; j < result.size(); ++j) result[j] += x[i] * form[i][j];
  }
  return result;
}

std::int64_t form_value(const std::vector<IntegerVector>& form, const IntegerVector& x, const IntegerVector& y) {
  const IntegerVector row = products(form, x);
  return std::inner_product(y.begin(), y.end(), row.begin(), std::int64_t{0});
}

/// Sides of the polygon that a closed path crosses, from the polygon to itself.
using Sides = std::vector<std::uint32_t>;

Sides reversed(const RadialGraph& graph, const Sides& sides) {
  Sides result(sides.rbegin(), sides.rend());
  for (std::uint32_t& side : result) side = graph.partners()[side];
  return result;
}

Sides joined(const RadialGraph& graph, std::initializer_list<std::span<const std::uint32_t>> parts) {
  Sides result;
  for (const std::span<const std::uint32_t> part : parts) {
    for (const std::uint32_t side : part) {
      if (!result.empty() && result.back() == graph.partners()[side]) {
        result.pop_back();
      } else {
        result.push_back(side);
      }
    }
  }
  return result;
}

/// Paths a₁, b₁, a₂, b₂, … that generate the group, with [a₁, b₁][a₂, b₂]… = 1.
///
/// The sides that are crossed around the vertex are a relation with each generator and its inverse once. Where it is
/// F x B y C x⁻¹ D y⁻¹ E, it is F K [x′, y′] B E for K = DC, x = Kx′, y′ = ByC: a commutator, conjugated by FK, before
/// FDCBE, which is treated alike. Each time the pair x, y is taken that ends first, so that paths are short.
std::vector<Sides> standard_generators(const RadialGraph& graph) {
  std::vector<Sides> result;
  Sides rest = graph.sides_around_vertex();
  std::vector<std::size_t> at(graph.size());
  while (!rest.empty()) {
    for (std::size_t i = 0; i < rest.size(); ++i) at[rest[i]] = i;
    std::array<std::size_t, 4> place{};
    for (std::size_t last = 3; place[3] == 0; ++last) {
      const std::size_t j = at[graph.partners()[rest[last]]];
      for (std::size_t i = 0; i < j && j < last && place[3] == 0; ++i) {
        const std::size_t k = at[graph.partners()[rest[i]]];
        if (j < k && k < last) place = {i, j, k, last};
      }
    }
    const auto [i, j, k, l] = place;
    const std::span<const std::uint32_t> all(rest);
    const auto part = [&](std::size_t from, std::size_t to) { return all.subspan(from, to - from); };
    const Sides f = joined(graph, {part(0, i)});
    const Sides fk = joined(graph, {f, part(k + 1, l), part(j + 1, k)});
    const Sides back = reversed(graph, fk);
    result.push_back(joined(graph, {f, part(i, i + 1), back}));
    result.push_back(joined(graph, {fk, part(i + 1, k), back}));
    rest = joined(graph, {fk, part(i + 1, j), part(l + 1, rest.size())});
  }
  return result;
}

/// The genus of what is on the left of a simple curve that separates the surface, from the sides that it crosses.
///
/// Up to triple commutators it is a product of commutators [a_i, b_i], one for each handle on its left. The form that
/// belongs to it, Σ a_i ∧ b_i, makes a projection to the homology of that side; of the relation of the group, the
/// identity. So the trace tells, modulo 2g.
std::uint32_t genus_on_the_left(const RadialGraph& graph, const ClosedWalk& walk) {
  const std::vector<IntegerVector> form = graph.intersection_form();
  const std::size_t count = form.size();
  std::vector<std::uint32_t> number(graph.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    number[graph.basis()[k]] = number[graph.partners()[graph.basis()[k]]] = k;
  }
  IntegerVector passed(count);
  std::int64_t trace = 0;
  for (const std::uint32_t side : graph.sides_of(walk)) {
    const std::uint32_t k = number[side];
    const std::int64_t sign = side == graph.basis()[k] ? 1 : -1;
    for (std::size_t i = 0; i < count; ++i) trace += passed[i] * sign * form[k][i];
    passed[k] += sign;
  }
  const auto twice_genus = static_cast<std::int64_t>(count);
  return static_cast<std::uint32_t>(((trace % twice_genus) + twice_genus) % twice_genus / 2);
}

// ---- what balls enclose ----

using certify::Ball;
using certify::BallIsometry;
using BallVector = LorentzVector<Ball>;

constexpr slong kFirstBits = 128;
constexpr slong kMostBits = 1 << 14;

/// The unit normal of the axis of a closed path, positive on its left, if balls tell.
std::optional<BallVector> unit_normal(const Surface& surface, const Word& path) {
  const BallIsometry f = certify::inverse(ball_isometry(surface, path, certify::Precision::current()));
  const int sign = certify::certain_sign(certify::real(f.a));
  const Ball square = certify::sqr(certify::real(f.a)) - 1;
  if (sign == 0 || certify::certain_sign(square) <= 0) return std::nullopt;
  const Ball scale = sign * certify::rsqrt(square);
  return BallVector{-(scale * certify::imaginary(f.b)), scale * certify::real(f.b), scale * certify::imaginary(f.a)};
}

/// The cosine of the angle between two axes that cross, with their directions.
Ball cosine_between(const Surface& surface, const Word& first, const Word& second) {
  constexpr double kWidth = 0x1p-50;
  for (slong precision = kFirstBits; precision <= kMostBits; precision *= 2) {
    const certify::Precision scope(precision);
    const auto u = unit_normal(surface, first);
    const auto v = unit_normal(surface, second);
    if (!u || !v) continue;
    Ball cosine = lorentz_product(*u, *v);
    const certify::Interval ends = certify::outer_interval(cosine);
    if (ends.upper - ends.lower < kWidth && ends.upper < 1 && ends.lower > -1) return cosine;
  }
  throw LimitError("closed curves are too long for an angle with " + std::to_string(kMostBits) + " bits");
}

/// Encloses the length of the closed geodesic of a path.
certify::Interval length_of(const Surface& surface, const Word& path) {
  constexpr double kRelativeWidth = 0x1p-48;
  for (slong precision = kFirstBits; precision <= kMostBits; precision *= 2) {
    const certify::Precision scope(precision);
    const BallIsometry f = ball_isometry(surface, path, precision);
    const Ball length = certify::twice(certify::acosh(certify::abs(certify::real(f.a))));
    if (!certify::is_finite(length)) continue;
    const certify::Interval ends = certify::outer_interval(length);
    if (ends.lower > 0 && ends.upper - ends.lower < kRelativeWidth * ends.lower) return ends;
  }
  throw LimitError("a closed curve is too long for " + std::to_string(kMostBits) + " bits");
}

// ---- the document ----

/// The ε of the net in a curves file: any net will do.
constexpr double kEpsilon = 1;

/// Vertices of a net from which words start.
class Starts {
 public:
  Starts(const Surface& surface, const certify::NetDocument& net)
      : surface_(surface), of_tile_(surface.tiles().size()) {
    for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
      auto& vertex = of_tile_[TileId(net.charts[net.vertices[v].chart].tile)];
      if (!vertex) vertex = v;
    }
  }

  struct Start {
    std::uint32_t vertex;
    Word way;  ///< From its tile to the tile asked for.
  };
  /// A vertex of a tile, or of the nearest one that has a vertex.
  [[nodiscard]] Start nearest(TileId tile) const {
    if (of_tile_[tile]) return {*of_tile_[tile], {}};
    std::optional<Start> best;
    for (const TileId other : surface_.tile_ids()) {
      if (!of_tile_[other]) continue;
      Word way = path_between_tiles(surface_, other, tile);
      if (!best || way.size() < best->way.size()) best = Start{*of_tile_[other], std::move(way)};
    }
    return *best;
  }

 private:
  const Surface& surface_;
  ById<TileId, std::optional<std::uint32_t>> of_tile_;
};

/// Rows of a document.
class Rows {
 public:
  Rows(const Surface& surface, const CurveTopology& topology, const certify::NetDocument& net)
      : surface_(surface), topology_(topology), starts_(surface, net), system_(surface) {}

  [[nodiscard]] certify::CurvesDocument::Curve operator()(const ClosedCurve& curve) const {
    const ClosedPath path = near_geodesic({TileId(0), topology_.word(curve)});
    const auto [vertex, way] = starts_.nearest(path.tile);
    const Word word = concatenated(surface_, concatenated(surface_, way, path.word), reversed(surface_, way));
    return {.vertex = vertex,
            .word = letters_of(word),
            .length = length_of(surface_, word),
            .power = curve.power,
            .self_intersections = curve.self_intersections,
            .homology = curve.homology};
  }

 private:
  /// From a tile through which the geodesic passes, unless the path is too long for 512 bits.
  [[nodiscard]] ClosedPath near_geodesic(const ClosedPath& path) const {
    try {
      return system_.onto_geodesic(path).path;
    } catch (const LimitError&) {
      return path;
    }
  }

  const Surface& surface_;
  const CurveTopology& topology_;
  Starts starts_;
  CurveSystem system_;
};

/// A curve that `curves` is given. Throws CurveError.
ClosedCurve checked_curve(const CurveTopology& topology, std::size_t number, const Word& word) {
  ClosedCurve curve;
  try {
    curve = topology.curve(word);
  } catch (const SurfaceError& error) {
    throw CurveError(number, error.problem());
  }
  if (curve.is_null_homotopic()) throw CurveError(number, "null-homotopic");
  return curve;
}

}  // namespace

CurveTopology::CurveTopology(const Surface& surface) : graph_(std::make_shared<const RadialGraph>(surface)) {
  for (const Sides& sides : standard_generators(*graph_)) {
    basis_.push_back(graph_->path(sides));
    coordinates_.push_back(graph_->homology(graph_->walk_of(basis_.back())));
  }
}

ClosedCurve CurveTopology::curve(const Word& word) const {
  const ClosedWalk walk = graph_->walk_of(word);
  ClosedCurve result;
  result.homology.resize(basis_.size());
  if (walk.empty()) return result;
  result.power = RadialGraph::power_of(walk);
  result.root.assign(walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(walk.size() / result.power));
  const std::uint64_t power = result.power;
  result.self_intersections = power * power * graph_->self_crossings(result.root).size() + (power - 1);
  const std::vector<IntegerVector> form = graph_->intersection_form();
  const IntegerVector homology = graph_->homology(walk);
  for (std::size_t i = 0; i < basis_.size(); i += 2) {
    result.homology[i] = form_value(form, homology, coordinates_[i + 1]);
    result.homology[i + 1] = form_value(form, coordinates_[i], homology);
  }
  const bool bounds = std::all_of(homology.begin(), homology.end(), [](std::int64_t x) { return x == 0; });
  if (result.is_simple() && bounds) result.genus_on_the_left = epsnet::genus_on_the_left(*graph_, walk);
  return result;
}

Word CurveTopology::word(const ClosedCurve& curve) const {
  const Word once = graph_->path(graph_->sides_of(curve.root));
  Word result;
  for (std::uint32_t i = 0; i < curve.power; ++i) result = concatenated(graph_->surface(), std::move(result), once);
  return result;
}

int CurveTopology::same_geodesic(const ClosedCurve& first, const ClosedCurve& second) const {
  if (first.root.size() != second.root.size() || first.is_null_homotopic()) return 0;
  if (first.root == second.root) return 1;
  return graph_->reversed(first.root) == second.root ? -1 : 0;
}

IntersectionNumbers CurveTopology::intersections(const ClosedCurve& first, const ClosedCurve& second) const {
  if (first.is_null_homotopic() || second.is_null_homotopic()) return {};
  const std::uint64_t powers = std::uint64_t{first.power} * second.power;
  if (same_geodesic(first, second) != 0) return {2 * powers * graph_->self_crossings(first.root).size(), 0};
  IntersectionNumbers result;
  for (const WalkCrossing& crossing : graph_->crossings(first.root, second.root)) {
    result.geometric += powers;
    result.algebraic += crossing.sign * static_cast<std::int64_t>(powers);
  }
  return result;
}

namespace {

/// Calls visit(paths, sign) for each crossing of the geodesics of two curves.
template <class Visit>
void for_each_crossing(const RadialGraph& graph, const ClosedCurve& first, const ClosedCurve& second, bool same,
                       const Visit& visit) {
  const ClosedWalk& other = same ? first.root : second.root;
  for (const WalkCrossing& crossing : same ? graph.self_crossings(first.root) : graph.crossings(first.root, other)) {
    visit(graph.crossing_paths(first.root, other, crossing), crossing.sign);
  }
}

}  // namespace

std::vector<GeodesicCrossing> CurveTopology::crossings(const ClosedCurve& first, const ClosedCurve& second) const {
  std::vector<GeodesicCrossing> result;
  if (first.is_null_homotopic() || second.is_null_homotopic()) return result;
  for_each_crossing(*graph_, first, second, same_geodesic(first, second) != 0,
                    [&](const RadialGraph::CrossingPaths& paths, int sign) {
                      const certify::Precision scope(kFirstBits);
                      const Ball cosine = cosine_between(graph_->surface(), paths.first, paths.second);
                      const Ball sine = certify::sqrt(1 - certify::sqr(cosine));
                      result.push_back({certify::outer_interval(sign * certify::atan2(sine, cosine))});
                    });
  return result;
}

certify::Interval CurveTopology::twist_derivative(const ClosedCurve& curve, const ClosedCurve& along) const {
  if (along.is_null_homotopic() || !along.is_simple()) throw SurfaceError("a twist is along a simple closed curve");
  if (curve.is_null_homotopic() || same_geodesic(along, curve) != 0) return {0, 0};
  const certify::Precision scope(kFirstBits);
  Ball sum;
  for_each_crossing(*graph_, along, curve, false, [&](const RadialGraph::CrossingPaths& paths, int sign) {
    sum += sign * cosine_between(graph_->surface(), paths.first, paths.second);
  });
  return certify::outer_interval(-static_cast<std::int64_t>(curve.power) * sum);
}

bool CurveTopology::fill(std::span<const ClosedCurve> curves) const {
  std::vector<ClosedCurve> different;
  std::vector<ClosedWalk> roots;
  for (const ClosedCurve& curve : curves) {
    const auto is_same = [&](const ClosedCurve& other) { return same_geodesic(curve, other) != 0; };
    if (curve.is_null_homotopic() || std::any_of(different.begin(), different.end(), is_same)) continue;
    different.push_back(curve);
    roots.push_back(curve.root);
  }
  return graph_->fill(roots);
}

certify::CurvesDocument unproved::curves(const Surface& surface, std::span<const Word> words,
                                         const CurvesOptions& options) {
  const CurveTopology topology(surface);
  std::vector<ClosedCurve> all;
  for (std::size_t i = 0; i < words.size(); ++i) all.push_back(checked_curve(topology, i, words[i]));
  const std::size_t given = all.size();
  for (const Word& word : topology.homology_basis()) all.push_back(topology.curve(word));

  NetOptions of_net;
  of_net.threads = options.threads;
  of_net.progress = options.progress;
  certify::CurvesDocument result;
  result.net = compute_net(surface, Length(kEpsilon), of_net).document;
  const Rows row(surface, topology, result.net);
  const auto report = [&](const char* what, std::size_t i) {
    if (options.progress) options.progress(what, static_cast<double>(i) / static_cast<double>(all.size()));
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    report("closed curves", i);
    result.curves.push_back(row(all[i]));
  }
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    report("intersections", i);
    for (std::uint32_t j = i + 1; j < all.size(); ++j) {
      const auto [geometric, algebraic] = topology.intersections(all[i], all[j]);
      result.pairs.push_back({i, j, geometric, algebraic});
    }
  }
  result.basis.resize(all.size() - given);
  std::iota(result.basis.begin(), result.basis.end(), static_cast<std::uint32_t>(given));
  if (topology.fill(std::span(all).first(given))) {
    std::vector<std::uint32_t>& set = result.filling.emplace_back(given);
    std::iota(set.begin(), set.end(), 0U);
  }
  return result;
}

Certified<certify::CurvesDocument> curves(const Surface& surface, std::span<const Word> words,
                                          const CurvesOptions& options) {
  return proved(unproved::curves(surface, words, options), options.threads, options.progress);
}

}  // namespace epsnet
