#include "certify/claims/geodesics/crossing_pass.h"

#include <algorithm>

#include "certify/base/text.h"
#include "certify/claims/geodesics/chords.h"
#include "certify/net/darts.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {

CrossingPass::CrossingPass(const LiftedPlane& plane, const Ball& cosh_half, std::size_t count,
                           const std::function<Member(std::size_t)>& member, unsigned threads)
    : plane_(plane), net_(plane.net()), cosh_half_(cosh_half), moved_(plane), crosses_itself_(count, Tri::unknown) {
  if (!moved_.valid()) return;
  std::vector<bool> inner(3 * net_.triangles.size());
  for (std::uint32_t dart = 0; dart < inner.size(); ++dart) {
    if (start(net_, dart) == start(net_, next_dart(dart)) && dart < opposite(net_, dart)) find_collar(dart, inner);
  }
  order_.emplace(moved_, inner);
  search_.emplace(moved_, *order_, cosh_half);
  std::vector<LeastSequence> sequences(count);
  for_each_parallel(count, threads, [&](unsigned, std::size_t i) {
    const auto [first_dart, element] = member(i);
    std::optional<AxisCrossings> crossings = axis_crossings(moved_, first_dart, element);
    if (!crossings) return;
    sequences[i] = sequence_of(crossings->darts);
    // A power runs through the same chords again and again.
    crossings->darts.resize(crossings->darts.size() / sequences[i].exponent);
    crosses_itself_[i] = certify::crosses_itself(plane_, *crossings);
  });
  if (std::none_of(sequences.begin(), sequences.end(), [](const auto& sequence) { return sequence.root.empty(); })) {
    table_.emplace(std::move(sequences));
  }
}

/// The element of a loop edge in the chart of its vertex.
BallIsometry CrossingPass::element_of_loop(std::uint32_t dart) const {
  BallIsometry element = compose(inverse(plane_.label(corner_label(net_, dart))),
                                 plane_.label(corner_label(net_, next_dart(dart))), plane_.precision());
  choose_sign(element);
  return element;
}

/// If the vertex of a loop edge certainly lies in the collar of its core, of length l with sinh(l/2) < 1, so do the
/// edges there whose other ends are as near to the same lift of the core: sinh of the distance is less than sinh w =
/// 1/sinh(l/2).
void CrossingPass::find_collar(std::uint32_t loop, std::vector<bool>& inner) {
  const slong precision = plane_.precision();
  const BallIsometry element = element_of_loop(loop);
  const Precision scope(precision);
  const Ball sinh_half = sqrt(sqr(real(element.a)) - 1);
  if (certainly_positive(sinh_half) != Tri::yes || certainly_less(sinh_half, Ball::exactly(1)) != Tri::yes) return;
  const Ball width = 1 / sinh_half;
  Ball distance;
  const auto is_inside = [&](const BallVector& axis, std::uint32_t dart) {
    dot(distance, axis, moved_.corner(dart), precision);
    return certainly_less(abs(distance), width) == Tri::yes;
  };
  bool found = false;
  std::uint32_t dart = loop;
  do {
    // The vertex is in one place, seen from whichever triangle; the axis is carried to the chart of this one.
    const BallIsometry& to_triangle = plane_.label(corner_label(net_, dart));
    BallIsometry carried = compose(compose(to_triangle, element, precision), inverse(to_triangle), precision);
    choose_sign(carried);
    const BallVector axis = axis_row(carried, precision);
    if (is_inside(axis, dart) && is_inside(axis, next_dart(dart))) {
      inner[dart] = inner[opposite(net_, dart)] = true;
      found = true;
    }
    dart = next_dart(opposite(net_, dart));
  } while (dart != loop);
  if (found) loops_.push_back(loop);
}

LeastSequence CrossingPass::sequence_of(const std::vector<std::uint32_t>& darts) const {
  std::vector<std::uint32_t> codes(darts.size());
  std::transform(darts.begin(), darts.end(), codes.begin(), [&](std::uint32_t dart) { return order_->code(dart); });
  return least_sequence(codes);
}

SearchPart CrossingPass::examine(std::size_t part, std::uint64_t limit, const std::function<void()>& tick) const {
  SearchPart result;
  if (part < loops_.size()) {
    result.deep = true;
    result.complete = is_in_order(loops_[part], result);
    return result;
  }
  Tri answer = Tri::yes;
  const OrbitOutcome outcome = search_->run(part - loops_.size(), limit, [&](const std::vector<std::uint32_t>& codes) {
    tick();
    answer = is_in_order(codes, result);
    return answer == Tri::yes ? Search::go_on : Search::stop;
  });
  result.visits = outcome.visits;
  result.limit_reached = outcome.limit_reached;
  result.complete = answer == Tri::yes && !outcome.complete ? Tri::unknown : answer;
  return result;
}

/// Whether the geodesic of a loop edge is in the list, or too long.
Tri CrossingPass::is_in_order(std::uint32_t loop, SearchPart& part) const {
  const BallIsometry element = element_of_loop(loop);
  const Tri shorter = certainly_less(cosh_half_length(element), cosh_half_);
  if (shorter == Tri::no) return Tri::yes;
  const auto crossings = axis_crossings(moved_, loop, element);
  if (!crossings) return Tri::unknown;
  ++part.candidates;
  if (table_->contains(sequence_of(crossings->darts).root)) return Tri::yes;
  return shorter == Tri::yes ? missing(loop, element, part) : Tri::unknown;
}

/// Whether a cyclic sequence that is no power is in the list, or not that of a geodesic, or of one that is too long.
Tri CrossingPass::is_in_order(const std::vector<std::uint32_t>& codes, SearchPart& part) const {
  plane_.spend(1, codes.size());
  if (table_->contains(least_sequence(codes).root)) {
    ++part.candidates;
    return Tri::yes;
  }
  std::vector<std::uint32_t> darts(codes.size());
  std::transform(codes.begin(), codes.end(), darts.begin(), [&](std::uint32_t code) { return order_->dart(code); });
  const BallIsometry element = element_across(plane_, darts);
  const Tri shorter = certainly_less(cosh_half_length(element), cosh_half_);
  if (shorter == Tri::no) return Tri::yes;
  const Tri is_sequence = crosses(moved_, element, darts);
  if (is_sequence == Tri::no) return Tri::yes;
  ++part.candidates;
  if (shorter == Tri::unknown || is_sequence == Tri::unknown) return Tri::unknown;
  return missing(darts.front(), element, part);
}

Tri CrossingPass::missing(std::uint32_t dart, const BallIsometry& element, SearchPart& part) const {
  part.text = "a closed geodesic near vertex " + std::to_string(start(net_, dart)) + " of length in " +
              to_string(translation_length(element, plane_.precision())) + " is not in the list";
  return Tri::no;
}

}  // namespace epsnet::certify
