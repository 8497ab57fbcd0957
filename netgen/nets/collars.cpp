#include "netgen/nets/collars.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mpfr.h>
#include <string>
#include <unordered_set>

#include "kernel/plane.h"
#include "netgen/nets/certified_net.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

/// The core of a translation as seen from z.
Core core_of(ChartId chart, const Isometry<Mp1024>& f, const Mp1024& sinh2, const Complex<Mp1024>& z) {
  const Mp1024 scale = 1 / sqrt(isometry_discriminant(f));
  const LorentzVector<Mp1024> normal = scale * axis_normal(f);
  const LorentzVector<Mp1024> p = on_hyperboloid(z);
  const Mp1024 height = lorentz_product(p, normal);  // sinh of the distance.
  const LorentzVector<Mp1024> foot = Mp1024(1 / sqrt(Mp1024(1 + height * height))) * (p + Mp1024(-height) * normal);
  return {chart, sinh2, foot, lorentz_cross(foot, normal), normal};
}

/// The point at the distance `shift` along the core from its foot, and from there at `height` on one side.
Complex<Mp1024> point_beside(const Core& core, const Mp1024& height, const Mp1024& shift) {
  const LorentzVector<Mp1024> on_core = Mp1024(cosh(shift)) * core.foot + Mp1024(sinh(shift)) * core.along;
  return in_disk(Mp1024(cosh(height)) * on_core + Mp1024(sinh(height)) * core.normal);
}

Mp1024 length_of(const Core& core) { return 2 * asinh(Mp1024(sqrt(core.sinh2))); }

[[noreturn]] void no_place(const Core& core) {
  throw NetError("no place was found for a vertex beside a closed geodesic of length " +
                 std::to_string(static_cast<double>(length_of(core))));
}

}  // namespace

Collars::Collars(Triangulation& triangulation, const Length& epsilon)
    : triangulation_(triangulation), epsilon_(epsilon.value()) {
  const Mp1024 s = sinh(Mp1024(epsilon_ / 2));
  sinh2_half_ = s * s;
}

std::optional<ChartId> Collars::partner_of(VertexId v) const {
  if (sides_.empty()) {
    return std::nullopt;
  }
  const Vertex vertex = triangulation_.vertex(v);
  const auto found = sides_.find(vertex.chart);
  return found != sides_.end() && vertex.z == Complex<double>{} ? std::optional(found->second.partner) : std::nullopt;
}

bool Collars::are_partners(VertexId u, VertexId v) const {
  return partner_of(u) == triangulation_.vertex(v).chart && has_vertex(v);
}

bool Collars::is_short_loop(Dart d) {
  const VertexId v = triangulation_.corner(d).vertex;
  if (triangulation_.corner(next_dart(d)).vertex != v) {
    return false;
  }
  const Complex<double> z = triangulation_.vertex(v).z;
  const Complex<Mp1024> image = triangulation_.lift_in<Mp1024>({v, triangulation_.label_along(d)});
  return sinh2_half_distance(convert<Mp1024>(z), image) <= 2 * sinh2_half_;
}

std::optional<Core> Collars::core_at(Dart d) {
  for (const Dart x : triangulation_.star(d)) {
    if (!is_short_loop(x)) {
      continue;
    }
    const Vertex vertex = triangulation_.vertex(triangulation_.corner(x).vertex);
    const auto& f = triangulation_.isometry_in<Mp1024>(triangulation_.label_along(x));
    const Mp1024 sinh2 = isometry_discriminant(f) / f.determinant();
    if (sinh2 <= sinh2_half_) {
      return core_of(vertex.chart, f, sinh2, convert<Mp1024>(vertex.z));
    }
  }
  return std::nullopt;
}

std::optional<Dart> Collars::loop_of(TriangleId t) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const VertexId v = triangulation_.triangle(t).vertex[i];
    const Dart d = make_dart(t, i);
    if (v == triangulation_.triangle(t).vertex[next(i)] &&
        are_partners(v, triangulation_.triangle(t).vertex[previous(i)]) && is_short_loop(d)) {
      return d;
    }
  }
  return std::nullopt;
}

bool Collars::has_triangle(TriangleId t) { return !sides_.empty() && loop_of(t).has_value(); }

bool Collars::is_handled(const Core& core, TriangleId t, LabelId label) {
  if (sides_.empty()) {
    return false;
  }
  const LiftedPoint foot = point_near(core, in_disk(core.foot));
  const LabelId to_t = triangulation_.product(label, foot.label);
  const Location location = locate(triangulation_, t, {foot.chart, foot.z, to_t}, Walk::visibility, kMostSteps);
  const LabelId to_triangle = triangulation_.product(triangulation_.inverse(location.transition), to_t);
  // If the collar is handled, the foot is in its annulus: two triangles, or more as long as vertices of the start are
  // in it. Every path out of the annulus leads through a triangle with one of its two vertices, so the first vertex of
  // a collar on the path decides.
  const std::vector<Dart> way = way_to_collar(triangle_of(location.dart));
  if (way.empty()) {
    return false;
  }
  LabelId to_last = to_triangle;
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    to_last = triangulation_.product(triangulation_.inverse(triangulation_.transition(way[k])), to_last);
  }
  const Corner corner = triangulation_.corner(way.back());
  const Side& side = sides_.at(triangulation_.vertex(corner.vertex).chart);
  const LabelId to_core =
      triangulation_.product(side.to_core, triangulation_.product(triangulation_.inverse(corner.label), to_last));
  const Complex<Mp1024> z = to_core == kIdentity ? Complex<Mp1024>{} : triangulation_.isometry_in<Mp1024>(to_core)({});
  // Different cores no longer than ε ≤ ln √2 are more than 2 arsinh(1/sinh(ε/2)) > 3 apart (collar theorem).
  return abs(lorentz_product(on_hyperboloid(z), side.normal)) < 0.01;
}

std::vector<Dart> Collars::way_to_collar(TriangleId t) const {
  struct Visit {
    TriangleId triangle;
    std::size_t before;
    Dart through;
  };
  std::vector<Visit> visits{{t, 0, Dart{}}};
  std::unordered_set<TriangleId> seen{t};
  for (std::size_t k = 0; k < visits.size(); ++k) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Dart d = make_dart(visits[k].triangle, i);
      if (has_vertex(triangulation_.corner(visits[k].triangle, i).vertex)) {
        std::vector<Dart> way{d};
        for (std::size_t j = k; j > 0; j = visits[j].before) {
          way.push_back(visits[j].through);
        }
        std::reverse(way.begin(), way.end());
        return way;
      }
      const TriangleId other = triangle_of(triangulation_.opposite(d));
      if (seen.insert(other).second) {
        visits.push_back({other, k, d});
      }
    }
  }
  return {};
}

LiftedPoint Collars::point_near(const Core& core, const Complex<Mp1024>& z) {
  const auto point = triangulation_.lifted_point(core.chart, z, Atlas::Precision::bits_256);
  if (!point) no_place(core);
  return *point;
}

Collars::Inserted Collars::insert(const Core& core, const Complex<Mp1024>& z, TriangleId t, LabelId label,
                                  Journal* journal) {
  const LiftedPoint point = point_near(core, z);
  const auto inserted =
      insert_by_flips(triangulation_, t, {point.chart, point.z, triangulation_.product(label, point.label)},
                      Walk::visibility, kMostSteps, journal);
  if (!inserted) no_place(core);
  const Corner corner = triangulation_.corner(inserted->dart);
  return {inserted->vertex, point.label, triangle_of(inserted->dart),
          triangulation_.product(corner.label, triangulation_.inverse(point.label))};
}

void Collars::insert_pair(const Core& core, TriangleId t, LabelId label, Journal* journal) {
  // A little more than d_ε, for all roundings. Not less than ε/8, so that the diametral disks of the two loops contain
  // no other vertex: with the loop ends at the feet 0 and l, its middle at the height m, tanh m = tanh d/cosh(l/2), the
  // other vertex, at the foot l/32, is outside if 2 tanh d tanh m > cosh(l/2) − cosh(15l/32), and the left side is more
  // than 0.03 ε², the right side less than 0.016 ε². Other vertices are outside of the l_ε-collar, d_lε − d > ε away:
  // for d = d_ε by thesis Lemma III.9, for d = ε/8 as d_lε ≥ arcosh √2 > 0.88.
  const Mp1024 thin = asinh(Mp1024(sqrt(Mp1024((sinh2_half_ - core.sinh2) / core.sinh2))));
  const Mp1024 enough = thin + ldexp(Mp1024(1), -40);
  const Mp1024 least = epsilon_ / 8;
  const Mp1024 height = enough < least ? least : enough;
  const Inserted p = insert(core, point_beside(core, height, Mp1024(0)), t, label, journal);
  // The feet differ, so that the ends of the two loops are not cocircular.
  const Mp1024 shift = length_of(core) / 32;
  const Inserted q = insert(core, point_beside(core, Mp1024(-height), shift), p.triangle, p.label, journal);
  const ChartId chart_p = triangulation_.vertex(p.vertex).chart;
  const ChartId chart_q = triangulation_.vertex(q.vertex).chart;
  sides_[chart_p] = {chart_q, p.to_core, core.normal};
  sides_[chart_q] = {chart_p, q.to_core, core.normal};
}

std::vector<certify::NetDocument::Collar> Collars::documents() {
  // Maps the chart of a vertex to the loop of the triangle that has this vertex twice.
  std::unordered_map<ChartId, Dart> loops;
  std::vector<certify::NetDocument::Collar> result;
  const auto vertex_of = [&](Dart d) { return triangulation_.corner(d).vertex; };
  for (const TriangleId t : triangulation_.triangles()) {
    if (sides_.empty()) break;
    const std::optional<Dart> loop = loop_of(t);
    if (!loop) {
      continue;
    }
    const ChartId chart = triangulation_.vertex(vertex_of(*loop)).chart;
    loops[chart] = *loop;
    const auto other = loops.find(sides_.at(chart).partner);
    if (other == loops.end()) {
      continue;
    }
    const Dart first = other->second;
    const std::optional<Core> core = core_at(first);
    if (!core) {
      continue;
    }
    const auto length = static_cast<double>(length_of(*core));
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    result.push_back({letters_of(triangulation_.atlas().labels()[triangulation_.label_along(first)].word),
                      {std::nextafter(length, 0), std::nextafter(length, kInfinity)},
                      {vertex_of(first).number(), vertex_of(*loop).number()},
                      {triangle_of(first).number(), t.number()}});
  }
  if (result.size() != count()) {
    throw NetError("a collar of a short closed geodesic did not stay an annulus of two triangles");
  }
  return result;
}

bool allows_pseudo_nets(const Length& epsilon) {
  const Rational twice = 2 * epsilon.value();
  // ln 2 is irrational, so enough bits decide.
  for (mpfr_prec_t bits = 128;; bits *= 2) {
    mpfr_t limit;
    mpfr_init2(limit, bits);
    mpfr_const_log2(limit, MPFR_RNDD);
    const bool below = mpfr_cmp_q(limit, twice.backend().data()) >= 0;
    mpfr_const_log2(limit, MPFR_RNDU);
    const bool above = mpfr_cmp_q(limit, twice.backend().data()) <= 0;
    mpfr_clear(limit);
    if (below != above) {
      return below;
    }
  }
}

}  // namespace epsnet
