#include "certify/claims/geodesics/candidate_judge.h"

#include "certify/base/text.h"

namespace epsnet::certify {
namespace {

/// Bits of two lengths that agree before they are compared exactly.
constexpr slong kTieBits = 30;
/// Operations of balls that a candidate takes before its chords are looked for.
constexpr std::uint64_t kJudgeOperations = 60;

}  // namespace

CandidateJudge::CandidateJudge(const GeodesicsDocument& document, const LabelEvaluator& evaluator,
                               const LiftedPlane& plane, const ChordTable& table, const Ball& cosh_half)
    : document_(document),
      evaluator_(evaluator),
      plane_(plane),
      table_(table),
      cosh_half_(cosh_half),
      traces_(evaluator),
      first_darts_(first_darts(plane.net())) {
  const Precision scope(plane.precision());
  sinh_epsilon_ = sinh(Ball::rounded(decimal(document.net.epsilon)));
}

CandidateJudge::Judgement CandidateJudge::judge(std::uint32_t v, const BallIsometry& element,
                                                const LabelProduct& product, const BallVector* place) const {
  plane_.spend(kJudgeOperations);
  const Tri shorter = certainly_less(cosh_half_length(element), cosh_half_);
  if (shorter == Tri::no) return {};
  const std::uint32_t chart = plane_.net().vertices[v].chart;
  const Tri trivial = plane_.same(chart, element, identity_isometry());
  if (trivial == Tri::yes) return {};
  if (place != nullptr && is_far(element, *place)) return {};
  if (trivial == Tri::unknown) return {.in_order = Tri::unknown, .is_candidate = false, .text = {}};
  const Tri found = is_systole() ? is_no_shorter(element, shorter, product) : is_listed(v, element, shorter, product);
  return {.in_order = found, .is_candidate = true, .text = found == Tri::no ? missing_text(v, element) : std::string()};
}

bool CandidateJudge::inverse_will_do(const BallIsometry& element) {
  return certainly_positive(real(element.a)) == Tri::yes && certainly_negative(imaginary(element.b)) == Tri::yes;
}

bool CandidateJudge::is_far(const BallIsometry& element, const BallVector& place) const {
  Ball distance;
  dot(distance, axis_row(element, plane_.precision()), place, plane_.precision());
  return certainly_less(sinh_epsilon_, abs(distance)) == Tri::yes;
}

/// Whether lengths that balls do not tell apart are so near that the exact numbers should be asked, not more bits.
bool CandidateJudge::is_near_tie(const BallIsometry& element) const {
  return arb_rel_accuracy_bits(element.a.re()) >= kTieBits && arb_rel_accuracy_bits(cosh_half_.get()) >= kTieBits;
}

/// Whether an element is at least as long as the systole listed; `shorter` is what balls say of the contrary.
Tri CandidateJudge::is_no_shorter(const BallIsometry& element, Tri shorter, const LabelProduct& product) const {
  if (shorter == Tri::yes) return Tri::no;
  if (!is_near_tie(element)) return Tri::unknown;
  const auto first_element = static_cast<std::uint32_t>(document_.net.labels.size()) + 1;
  const auto sign = traces_.compare(evaluator_.word(product()), evaluator_.word(first_element));
  if (!sign) return Tri::unknown;
  return *sign < 0 ? Tri::no : Tri::yes;
}

/// Whether an element is in the list or too long to have to be there; `shorter` is what balls say of the latter.
Tri CandidateJudge::is_listed(std::uint32_t v, const BallIsometry& element, Tri shorter,
                              const LabelProduct& product) const {
  const Tri found = has_chord_in_list(v, element);
  if (found != Tri::no || shorter == Tri::yes) return found;
  // It is missing if it is short enough. An `up_to` is never a length, 2 arsinh 1 may be one.
  if (document_.claim != GeodesicsDocument::Claim::thick_thin || !is_near_tie(element)) return Tri::unknown;
  const auto sign = traces_.compare_with_short(evaluator_.word(product()));
  if (!sign) return Tri::unknown;
  return *sign > 0 ? Tri::yes : Tri::no;
}

Tri CandidateJudge::has_chord_in_list(std::uint32_t v, const BallIsometry& element) const {
  const Interval length = translation_length(element, plane_.precision());
  Tri found = Tri::no;
  const auto list = find_chords(plane_, first_darts_[v], element, [&](const Chord& chord) {
    found = either(found, table_.find(chord, length).found);
    return found != Tri::yes;
  });
  return list ? found : Tri::unknown;
}

std::string CandidateJudge::missing_text(std::uint32_t v, const BallIsometry& element) const {
  return "a closed geodesic near vertex " + std::to_string(v) + " of length in " +
         to_string(translation_length(element, plane_.precision())) +
         (is_systole() ? " is shorter" : " is not in the list");
}

}  // namespace epsnet::certify
