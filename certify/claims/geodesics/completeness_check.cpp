#include "certify/claims/geodesics/completeness_check.h"

#include <algorithm>
#include <atomic>

#include "certify/base/text.h"
#include "certify/claims/geodesics/candidate_judge.h"
#include "certify/claims/geodesics/orbit_search.h"
#include "certify/net/darts.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

/// A spectrum from here on is searched for across edges: the search around vertices takes e^L steps for each of them.
const mpq_class kLongLength = 6;
/// Edges crossed by one part of the search before it is given up, and as many more for each geodesic of the list: on
/// usual surfaces 200 for each geodesic are enough for all parts together.
constexpr std::uint64_t kMostCrossings = 20'000'000;
constexpr std::uint64_t kMostCrossingsForEach = 1'000;

}  // namespace

/// All vertices at one precision.
class CompletenessCheck::Pass {
 public:
  Pass(const CompletenessCheck& check, const LiftedPlane& plane, const ChordTable& table)
      : check_(check),
        plane_(plane),
        net_(plane.net()),
        first_darts_(first_darts(net_)),
        cosh_half_(check.cosh_half_bound(plane)),
        judge_(check.document_, check.evaluator_, plane, table, cosh_half_) {
    epsilon_ = Ball::rounded(decimal(net_.epsilon));
    // sinh(D/2) = sinh(L/2) cosh ε; cosh D = 1 + 2 sinh²(D/2).
    cosh_distance_ = twice((sqr(cosh_half_) - 1) * sqr(cosh(epsilon_))) + 1;
    sinh_distance_ = sqrt_of_nonnegative(sqr(cosh_distance_) - 1);
  }

  /// Calls tick() now and then.
  template <class Tick>
  void examine(std::uint32_t v, SearchPart& vertex, const Tick& tick) const {
    vertex.text.clear();
    if (examine_loops(v, vertex)) return;
    const BallVector place = position(v);
    Tri answer = Tri::yes;
    const auto report = [&](const BallIsometry& element, const LabelProduct& product) {
      tick();
      if (CandidateJudge::inverse_will_do(element)) return Search::go_on;
      answer = judge(v, element, product, &place, vertex);
      return answer == Tri::yes ? Search::go_on : Search::stop;
    };
    OrbitOutcome outcome{.limit_reached = is_hopeless()};
    if (!outcome.limit_reached) {
      outcome = search_orbit(plane_, first_darts_[v], cosh_distance_, sinh_distance_, check_.limit_, report);
    }
    vertex.visits += outcome.visits;
    vertex.limit_reached = outcome.limit_reached;
    vertex.complete = answer == Tri::yes && !outcome.complete ? Tri::unknown : answer;
  }

 private:
  /// Whether triangles, each of area less than π, cannot cover within the limit the disk of the radius r with cosh r =
  /// cosh(D)/2: there α ≤ cosh r + sinh r tanh ε < cosh D, so that all that meet it are visited.
  [[nodiscard]] bool is_hopeless() const {
    return certainly_less(Ball::exactly(check_.limit_), cosh_distance_ - 2) == Tri::yes;
  }

  /// True if the vertex is deep; then its short loop is the only candidate.
  bool examine_loops(std::uint32_t v, SearchPart& vertex) const {
    for (const std::uint32_t dart : check_.loops_[v]) {
      BallIsometry element = compose(inverse(plane_.label(corner_label(net_, dart))),
                                     plane_.label(corner_label(net_, next_dart(dart))), plane_.precision());
      choose_sign(element);
      if (!is_deep(v, element)) continue;
      vertex.deep = true;
      const LabelProduct product = [&] {
        return std::vector<SignedLabel>{{corner_label(net_, dart), true}, {corner_label(net_, next_dart(dart)), false}};
      };
      vertex.complete = judge(v, element, product, nullptr, vertex);
      return true;
    }
    return false;
  }

  /// sinh(l/2) < 1 and d + ε < w(l) = arsinh(1/sinh(l/2)), d the distance of the vertex from the axis: certainly.
  [[nodiscard]] bool is_deep(std::uint32_t v, const BallIsometry& element) const {
    const Ball sinh_half_length = sqrt(sqr(real(element.a)) - 1);
    // Implied by d + ε < w(l), as a loop is at most 2ε long (docs/proof.md, Lemma 13).
    if (certainly_less(sinh_half_length, Ball::exactly(1)) != Tri::yes) return false;
    Ball sinh_distance;
    dot(sinh_distance, axis_row(element, plane_.precision()), position(v), plane_.precision());
    return certainly_less(asinh(abs(sinh_distance)) + epsilon_, asinh(1 / sinh_half_length)) == Tri::yes;
  }

  /// The vertex in its own chart.
  [[nodiscard]] BallVector position(std::uint32_t v) const {
    return unit_vector(identity_isometry(), net_.vertices[v].x, net_.vertices[v].y, plane_.precision());
  }

  [[nodiscard]] Tri judge(std::uint32_t v, const BallIsometry& element, const LabelProduct& product,
                          const BallVector* place, SearchPart& vertex) const {
    CandidateJudge::Judgement judgement = judge_.judge(v, element, product, place);
    vertex.candidates += judgement.is_candidate ? 1 : 0;
    if (judgement.in_order == Tri::no) vertex.text = std::move(judgement.text);
    return judgement.in_order;
  }

  const CompletenessCheck& check_;
  const LiftedPlane& plane_;
  const NetDocument& net_;
  std::vector<std::uint32_t> first_darts_;
  Ball cosh_half_;
  CandidateJudge judge_;
  Ball epsilon_;
  Ball cosh_distance_;
  Ball sinh_distance_;
};

CompletenessCheck::CompletenessCheck(const GeodesicsDocument& document, const LabelEvaluator& evaluator,
                                     const CheckOptions& options)
    : document_(document),
      evaluator_(evaluator),
      up_to_(document.claim == GeodesicsDocument::Claim::spectrum ? decimal(document.up_to) : mpq_class()),
      progress_(options.progress),
      max_visits_(options.max_visits),
      limit_(options.max_visits / std::max<std::size_t>(document.net.vertices.size(), 1)),
      vertices_(document.net.vertices.size()),
      crosses_edges_(up_to_ >= kLongLength),
      loops_(document.net.vertices.size()) {
  const NetDocument& net = document.net;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t v = start(net, dart);
    if (v == start(net, next_dart(dart)) && dart < opposite(net, dart)) loops_[v].push_back(dart);
  }
}

RuleReport CompletenessCheck::check(const LiftedPlane& plane, const ChordTable& table, unsigned threads) {
  const Precision scope(plane.precision());
  const Pass pass(*this, plane, table);
  std::vector<std::uint32_t> open;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    if (vertices_[v].complete == Tri::unknown && !vertices_[v].limit_reached) open.push_back(v);
  }
  // What is begun is forgotten if the budget ends it, so that the counts do not depend on the number of threads.
  std::vector<SearchPart> vertices = vertices_;
  for_each_parallel(open.size(), threads, [&](unsigned worker, std::size_t i) {
    pass.examine(open[i], vertices[open[i]], [&] {
      if (worker == 0 && progress_) progress_("complete", static_cast<double>(i) / static_cast<double>(open.size()));
    });
  });
  vertices_ = std::move(vertices);

  const auto find = [&](Tri wanted) {
    return std::find_if(vertices_.begin(), vertices_.end(), [&](const SearchPart& v) { return v.complete == wanted; });
  };
  if (const auto wrong = find(Tri::no); wrong != vertices_.end()) return {"complete", Verdict::refuted, wrong->text};
  if (const auto left = find(Tri::unknown); left != vertices_.end()) {
    const std::string name = "vertex " + std::to_string(left - vertices_.begin());
    return {"complete", Verdict::undecided,
            left->limit_reached
                ? name + " needs more than " + std::to_string(limit_) + " lifted triangles, its share of the limit"
                : name + ": not decided whether all geodesics near it are in the list, with " +
                      std::to_string(plane.precision()) + " bits"};
  }
  return verified();
}

RuleReport CompletenessCheck::verified() const {
  if (document_.claim == GeodesicsDocument::Claim::systole) {
    return {"complete", Verdict::verified, "no closed geodesic is shorter than geodesic 0"};
  }
  return {"complete", Verdict::verified,
          "no primitive closed geodesic of length at most " + bound_name() + " is missing"};
}

void CompletenessCheck::give_up_crossings() {
  crosses_edges_ = false;
  crossings_.clear();
}

std::optional<RuleReport> CompletenessCheck::check(const CrossingPass& crossings, slong precision, unsigned threads) {
  const Precision scope(precision);
  const std::uint64_t limit =
      std::min(kMostCrossings + kMostCrossingsForEach * document_.geodesics.size(), max_visits_);
  std::vector<SearchPart> parts(crossings.size());
  std::atomic<bool> too_many = false;
  for_each_parallel(parts.size(), threads, [&](unsigned worker, std::size_t i) {
    if (too_many) return;
    parts[i] = crossings.examine(i, limit, [&] {
      if (worker == 0 && progress_) progress_("complete", static_cast<double>(i) / static_cast<double>(parts.size()));
    });
    if (parts[i].limit_reached) too_many = true;
  });
  if (too_many) return std::nullopt;
  crossings_ = std::move(parts);
  const auto find = [&](Tri wanted) {
    return std::find_if(crossings_.begin(), crossings_.end(),
                        [&](const auto& part) { return part.complete == wanted; });
  };
  if (const auto wrong = find(Tri::no); wrong != crossings_.end()) return {{"complete", Verdict::refuted, wrong->text}};
  if (find(Tri::unknown) == crossings_.end()) return verified();
  return {{"complete", Verdict::undecided,
           "not decided whether all geodesics are in the list, with " + std::to_string(precision) + " bits"}};
}

bool CompletenessCheck::limit_reached() const {
  return std::any_of(vertices_.begin(), vertices_.end(), [](const SearchPart& v) { return v.limit_reached; });
}

template <class Count>
std::uint64_t CompletenessCheck::sum(const Count& count) const {
  std::uint64_t result = 0;
  for (const SearchPart& part : vertices_) result += count(part);
  for (const SearchPart& part : crossings_) result += count(part);
  return result;
}

std::uint64_t CompletenessCheck::visits() const {
  return sum([](const SearchPart& part) { return part.visits; });
}

std::uint64_t CompletenessCheck::candidates() const {
  return sum([](const SearchPart& part) { return part.candidates; });
}

std::uint64_t CompletenessCheck::deep_vertices() const {
  return sum([](const SearchPart& part) { return std::uint64_t{part.deep}; });
}

Ball CompletenessCheck::cosh_half_bound(const LiftedPlane& plane) const {
  const Precision scope(plane.precision());
  switch (document_.claim) {
    case GeodesicsDocument::Claim::thick_thin:
      return sqrt(Ball::exactly(2));
    case GeodesicsDocument::Claim::systole:
      return cosh_half_length(plane.label(first_element()));
    case GeodesicsDocument::Claim::spectrum:
      return cosh(half(Ball::rounded(up_to_)));
  }
  throw Fault("a claim of geodesics without a name");
}

std::string CompletenessCheck::bound_name() const {
  return document_.claim == GeodesicsDocument::Claim::thick_thin ? "2 arsinh 1" : in_quotes(document_.up_to);
}

}  // namespace epsnet::certify
