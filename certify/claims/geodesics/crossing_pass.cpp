#include "certify/claims/geodesics/crossing_pass.h"

#include <algorithm>
#include <atomic>

#include "certify/base/text.h"
#include "certify/net/darts.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

/// Bits of two lengths that agree before they are compared exactly.
constexpr slong kTieBits = 30;

}  // namespace

CrossingPass::CrossingPass(const GeodesicsDocument& document, const LabelEvaluator& evaluator, const LiftedPlane& plane,
                           const Ball& cosh_half, const std::function<Member(std::size_t)>& member, unsigned threads)
    : document_(document),
      evaluator_(evaluator),
      first_element_(static_cast<std::uint32_t>(document.net.labels.size()) + 1),
      plane_(plane),
      net_(plane.net()),
      traces_(evaluator),
      cosh_half_(cosh_half),
      moved_(plane) {
  if (!moved_.valid()) return;
  std::vector<bool> inner(3 * net_.triangles.size());
  for (std::uint32_t dart = 0; dart < inner.size(); ++dart) {
    const bool is_loop = start(net_, dart) == start(net_, next_dart(dart)) && dart < opposite(net_, dart);
    if (is_loop && !find_collar(dart, inner)) return;
  }
  order_.emplace(moved_, inner);
  search_.emplace(moved_, *order_, cosh_half);
  const std::size_t count = document.geodesics.size();
  const bool together = document.claim == GeodesicsDocument::Claim::thick_thin;
  std::vector<LeastSequence> sequences(count);
  meetings_.resize(count);
  geodesics_.resize(together ? count : 0);
  for_each_parallel(count, threads, [&](unsigned, std::size_t i) {
    const auto [first_dart, element] = member(i);
    std::optional<AxisCrossings> crossings = axis_crossings(moved_, first_dart, element);
    if (!crossings) return;
    sequences[i] = least_sequence(codes_of(crossings->darts));
    // A power runs through the same chords again and again.
    crossings->darts.resize(crossings->darts.size() / sequences[i].exponent);
    if (together) {
      geodesics_[i] = *std::move(crossings);
    } else {
      meetings_[i] = find_meetings(plane_, {&*crossings, 1})[0];
    }
  });
  if (std::any_of(sequences.begin(), sequences.end(), [](const auto& sequence) { return sequence.root.empty(); })) {
    return;
  }
  if (together) meetings_ = find_meetings(plane_, geodesics_);
  table_.emplace(std::move(sequences));
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
/// 1/sinh(l/2). False if the precision is too low to tell a very short core from none.
bool CrossingPass::find_collar(std::uint32_t loop, std::vector<bool>& inner) {
  const slong precision = plane_.precision();
  const BallIsometry element = element_of_loop(loop);
  const Precision scope(precision);
  const Ball sinh_half = sqrt(sqr(real(element.a)) - 1);
  if (certainly_positive(sinh_half) != Tri::yes) return false;
  if (certainly_less(sinh_half, Ball::exactly(1)) != Tri::yes) return true;
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
  return true;
}

std::vector<std::uint32_t> CrossingPass::codes_of(const std::vector<std::uint32_t>& darts) const {
  std::vector<std::uint32_t> codes(darts.size());
  std::transform(darts.begin(), darts.end(), codes.begin(), [&](std::uint32_t dart) { return order_->code(dart); });
  return codes;
}

Completeness CrossingPass::search(std::uint64_t limit, unsigned threads,
                                  const std::function<void(double)>& progress) const {
  std::vector<Completeness> parts(loops_.size() + search_->size());
  std::atomic<std::uint64_t> visits = 0;
  for_each_parallel(parts.size(), threads, [&](unsigned worker, std::size_t i) {
    Completeness& part = parts[i];
    if (i < loops_.size()) {
      const std::vector<std::uint32_t> codes = codes_of_loop(loops_[i]);
      if (!codes.empty()) part.complete = is_in_order(codes, part);
      return;
    }
    const std::uint64_t done = std::min<std::uint64_t>(visits, limit);
    Tri answer = Tri::yes;
    const SearchOutcome outcome = search_->run(i - loops_.size(), limit - done, [&](const auto& codes) {
      if (worker == 0) progress(static_cast<double>(i) / static_cast<double>(parts.size()));
      answer = is_in_order(codes, part);
      return answer == Tri::yes ? Search::go_on : Search::stop;
    });
    visits += outcome.visits;
    part.complete = answer == Tri::yes && !outcome.complete ? Tri::unknown : answer;
  });
  Completeness result;
  result.visits = std::min<std::uint64_t>(visits, limit);
  result.limit_reached = visits > limit;
  if (result.limit_reached) return result;
  result.complete = Tri::yes;
  for (const Completeness& part : parts) {
    result.candidates += part.candidates;
    if (result.complete == Tri::no) continue;
    if (part.complete == Tri::no) result.missing = part.missing;
    result.complete = both(result.complete, part.complete);
  }
  return result;
}

/// The sequence of a loop edge's geodesic; empty if the precision is too low.
std::vector<std::uint32_t> CrossingPass::codes_of_loop(std::uint32_t loop) const {
  const auto crossings = axis_crossings(moved_, loop, element_of_loop(loop));
  return crossings ? codes_of(crossings->darts) : std::vector<std::uint32_t>();
}

/// Whether a cyclic sequence that is no power is in the list, or not that of a geodesic, or of one that is too long.
Tri CrossingPass::is_in_order(const std::vector<std::uint32_t>& codes, Completeness& part) const {
  plane_.spend(1, codes.size());
  if (table_->contains(least_sequence(codes).root)) {
    ++part.candidates;
    return Tri::yes;
  }
  std::vector<std::uint32_t> darts(codes.size());
  std::transform(codes.begin(), codes.end(), darts.begin(), [&](std::uint32_t code) { return order_->dart(code); });
  const BallIsometry element = element_across(plane_, darts);
  if (certainly_less(cosh_half_length(element), cosh_half_) == Tri::no) return Tri::yes;
  const Tri is_sequence = crosses(moved_, element, darts);
  if (is_sequence == Tri::no) return Tri::yes;
  ++part.candidates;
  const Tri listed = is_to_be_listed(element, darts);
  if (listed == Tri::no) return Tri::yes;
  if (listed == Tri::unknown || is_sequence == Tri::unknown) return Tri::unknown;
  part.missing = "a closed geodesic near vertex " + std::to_string(start(net_, darts.front())) + " of length in " +
                 to_string(translation_length(element, plane_.precision())) +
                 (document_.claim == GeodesicsDocument::Claim::systole ? " is shorter" : " is not in the list");
  return Tri::no;
}

/// Whether a closed geodesic is so short that it should be in the list: shorter than the systole listed, or at most as
/// long as the list goes. Where balls do not tell, exact numbers do, if the two lengths are near enough.
Tri CrossingPass::is_to_be_listed(const BallIsometry& element, const std::vector<std::uint32_t>& darts) const {
  const Tri shorter = certainly_less(cosh_half_length(element), cosh_half_);
  const bool is_near_tie =
      arb_rel_accuracy_bits(element.a.re()) >= kTieBits && arb_rel_accuracy_bits(cosh_half_.get()) >= kTieBits;
  // An `up_to` is never a length, 2 arsinh 1 may be one.
  if (shorter != Tri::unknown || document_.claim == GeodesicsDocument::Claim::spectrum || !is_near_tie) return shorter;
  std::vector<SignedLabel> product;
  for (const std::uint32_t dart : darts) {
    product.push_back({corner_label(net_, dart), false});
    product.push_back({corner_label(net_, next_dart(opposite(net_, dart))), true});
  }
  const std::vector<std::uint32_t> word = evaluator_.word(product);
  const bool is_systole = document_.claim == GeodesicsDocument::Claim::systole;
  const auto sign =
      is_systole ? traces_.compare(word, evaluator_.word(first_element_)) : traces_.compare_with_short(word);
  if (!sign) return Tri::unknown;
  return *sign < (is_systole ? 0 : 1) ? Tri::yes : Tri::no;
}

}  // namespace epsnet::certify
