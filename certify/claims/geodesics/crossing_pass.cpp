#include "certify/claims/geodesics/crossing_pass.h"

#include "certify/net/darts.h"

namespace epsnet::certify {

CrossingPass::CrossingPass(const LiftedPlane& plane, const CandidateJudge& judge, const Ball& cosh_half)
    : plane_(plane), net_(plane.net()), judge_(judge), moved_(plane) {
  if (!moved_.valid()) return;
  std::vector<bool> inner(3 * net_.triangles.size());
  for (std::uint32_t dart = 0; dart < inner.size(); ++dart) {
    if (start(net_, dart) == start(net_, next_dart(dart)) && dart < opposite(net_, dart)) find_collar(dart, inner);
  }
  search_.emplace(moved_, inner, cosh_half);
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

SearchPart CrossingPass::examine(std::size_t part, std::uint64_t limit, const std::function<void()>& tick) const {
  SearchPart result;
  if (part < loops_.size()) {
    const std::uint32_t loop = loops_[part];
    result.deep = true;
    result.complete = judge(
        loop, element_of_loop(loop),
        [&] {
          return std::vector<SignedLabel>{{corner_label(net_, loop), true},
                                          {corner_label(net_, next_dart(loop)), false}};
        },
        result);
    return result;
  }
  const std::size_t start = part - loops_.size();
  Tri answer = Tri::yes;
  const OrbitOutcome outcome =
      search_->run(start, limit, [&](const BallIsometry& element, const LabelProduct& product) {
        tick();
        answer = judge(search_->first_dart(start), element, product, result);
        return answer == Tri::yes ? Search::go_on : Search::stop;
      });
  result.visits = outcome.visits;
  result.limit_reached = outcome.limit_reached;
  result.complete = answer == Tri::yes && !outcome.complete ? Tri::unknown : answer;
  return result;
}

Tri CrossingPass::judge(std::uint32_t dart, const BallIsometry& element, const LabelProduct& product,
                        SearchPart& part) const {
  CandidateJudge::Judgement judgement = judge_.judge(start(net_, dart), element, product, nullptr);
  part.candidates += judgement.is_candidate ? 1 : 0;
  if (judgement.in_order == Tri::no) part.text = std::move(judgement.text);
  return judgement.in_order;
}

}  // namespace epsnet::certify
