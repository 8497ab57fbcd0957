#include "certify/lifted/lifted_plane.h"

#include <map>
#include <numeric>

#include "certify/net/numbering.h"
#include "certify/net/rules.h"

namespace epsnet::certify {

BallMatrix lorentz_matrix(const BallIsometry& f, slong precision) {
  // With w = 2z and t = 1 + |z|²: w' = a² w + b² w̄ + 2ab t, t' = 2 Re(a b̄ w) + (|a|² + |b|²) t.
  ComplexBall a2, b2, ab, a_conj_b;
  acb_sqr(a2.get(), f.a.get(), precision);
  acb_sqr(b2.get(), f.b.get(), precision);
  acb_mul(ab.get(), f.a.get(), f.b.get(), precision);
  acb_conj(a_conj_b.get(), f.b.get());
  acb_mul(a_conj_b.get(), a_conj_b.get(), f.a.get(), precision);
  BallMatrix m;
  arb_add(m[0][0].get(), a2.re(), b2.re(), precision);
  arb_sub(m[0][1].get(), b2.im(), a2.im(), precision);
  arb_mul_2exp_si(m[0][2].get(), ab.re(), 1);
  arb_add(m[1][0].get(), a2.im(), b2.im(), precision);
  arb_sub(m[1][1].get(), a2.re(), b2.re(), precision);
  arb_mul_2exp_si(m[1][2].get(), ab.im(), 1);
  arb_mul_2exp_si(m[2][0].get(), a_conj_b.re(), 1);
  arb_mul_2exp_si(m[2][1].get(), a_conj_b.im(), 1);
  arb_neg(m[2][1].get(), m[2][1].get());
  // |a|² + |b|² = 1 + 2|b|².
  arb_ptr last = m[2][2].get();
  half_displacement_squared(last, f, precision);
  arb_mul_2exp_si(last, last, 1);
  arb_add_ui(last, last, 1, precision);
  return m;
}

BallVector apply(const BallMatrix& m, const BallVector& x, slong precision) {
  BallVector result;
  for (std::size_t i = 0; i < 3; ++i) dot(result[i], m[i], x, precision);
  return result;
}

BallVector unit_vector(const BallIsometry& label, double x, double y, slong precision) {
  const Precision scope(precision);
  const Ball re = Ball::exactly(x);
  const Ball im = Ball::exactly(y);
  const Ball norm = sqr(re) + sqr(im);
  const Ball gap = 1 - norm;
  return apply(lorentz_matrix(label, precision), {twice(re) / gap, twice(im) / gap, (norm + 1) / gap}, precision);
}

void choose_sign(BallIsometry& f) {
  if (certainly_negative(real(f.a)) == Tri::yes) f = {-f.a, -f.b};
}

Ball cosh_half_length(const BallIsometry& f) { return abs(real(f.a)); }

BallVector traceless_row(const BallIsometry& f) { return {-imaginary(f.b), real(f.b), -imaginary(f.a)}; }

BallVector axis_row(const BallIsometry& f, slong precision) {
  // Of Lorentz square sinh²(l/2) = (Re a)² − 1.
  const Precision scope(precision);
  const Ball scale = rsqrt(sqr(real(f.a)) - 1);
  BallVector row = traceless_row(f);
  for (Ball& x : row) x = x * scale;
  return row;
}

namespace {

/// Whether (a, b) certainly differ; only if their signs are chosen does this mean different isometries.
bool disjoint(const BallIsometry& f, const BallIsometry& g) {
  return certainly_different(f.a, g.a) || certainly_different(f.b, g.b);
}

}  // namespace

LiftedPlane::LiftedPlane(const NetDocument& net, const LabelEvaluator& evaluator, const LabelParts& parts,
                         slong precision, slong cap, unsigned threads)
    : net_(net), budget_(evaluator.budget()), precision_(precision) {
  const std::size_t triangles = net.triangles.size();
  spend(250, triangles);
  keep(21, triangles);
  evaluate_labels(evaluator, cap, threads);
  corners_.resize(3 * triangles);
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const NetDocument::Vertex& vertex = net.vertices[start(net, dart)];
    corners_[dart] = unit_vector(labels_[corner_label(net, dart)], vertex.x, vertex.y, precision);
  }
  find_transitions();
  find_disks(parts, cap);
}

void LiftedPlane::evaluate_labels(const LabelEvaluator& evaluator, slong cap, unsigned threads) {
  std::vector<std::uint32_t> numbers(net_.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  std::vector<BallIsometry> values =
      evaluator.evaluate(numbers, precision_, std::min(4 * precision_, 2 * cap), threads);
  labels_.push_back(identity_isometry());
  for (BallIsometry& value : values) labels_.push_back(std::move(value));
}

void LiftedPlane::find_transitions() {
  // Placed through the corner that the dart leaves: L_{t',j+1} L_{t,i}⁻¹. Most darts share their two labels with
  // others.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  transition_of_.resize(3 * net_.triangles.size());
  for (std::uint32_t dart = 0; dart < transition_of_.size(); ++dart) {
    const std::uint32_t here = corner_label(net_, dart);
    const std::uint32_t there = corner_label(net_, next_dart(opposite(net_, dart)));
    // Equal numbers cancel; number 0 is the identity of one and the same chart, that of the common vertex.
    if (here == there) continue;
    const auto [found, is_new] = numbers.try_emplace({here, there}, transitions_.size() + 1);
    transition_of_[dart] = found->second;
    if (!is_new) continue;
    spend(40);
    keep(13);
    BallIsometry isometry = compose(labels_[there], inverse(labels_[here]), precision_);
    BallMatrix matrix = lorentz_matrix(isometry, precision_);
    transitions_.push_back({std::move(isometry), std::move(matrix)});
  }
}

void LiftedPlane::find_disks(const LabelParts& parts, slong cap) {
  std::map<std::uint32_t, std::optional<InscribedDisk>> by_tile;
  for (std::uint32_t c = 0; c < net_.charts.size(); ++c) {
    const std::uint32_t tile = net_.charts[c].tile;
    const auto [found, is_new] = by_tile.try_emplace(tile);
    if (is_new) found->second = inscribed_disk(net_.surface, tile, cap, budget_);
    disks_.emplace_back();
    if (!found->second) continue;
    const InscribedDisk& disk = *found->second;
    budget_.spend(to_balls_work(bits(parts.frames[c]) + bits(disk.centre), static_cast<std::uint64_t>(precision_)));
    keep(5);
    disks_.back().emplace();
    disks_.back()->base = base_of(disk, parts.frames[c], precision_);
    disks_.back()->sinh_radius = disk.sinh_radius;
  }
}

Tri LiftedPlane::same(std::uint32_t chart, const BallIsometry& f, const BallIsometry& g) const {
  if (disjoint(f, g)) {
    // The signs mean something only where they could be chosen.
    const bool signs = certainly_positive(real(f.a)) == Tri::yes && certainly_positive(real(g.a)) == Tri::yes;
    return signs ? Tri::no : Tri::unknown;
  }
  const auto& disk = looked_up(disks_, chart, "there is no chart");
  if (!disk) return Tri::unknown;
  const BallIsometry quotient = compose(compose(inverse(f), g, precision_), disk->base, precision_);
  return is_identity(compose(inverse(disk->base), quotient, precision_), disk->sinh_radius, precision_);
}

}  // namespace epsnet::certify
