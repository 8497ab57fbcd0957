#include "certify/lifted/lifted_plane.h"

#include <map>
#include <numeric>

#include "certify/net/numbering.h"
#include "certify/net/surface_check.h"
#include "certify/net/triangulation_check.h"

namespace epsnet::certify {
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
    disks_.back()->base = to_balls(compose(inverse(parts.frames[c]), translation_to(disk.centre)), precision_);
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
