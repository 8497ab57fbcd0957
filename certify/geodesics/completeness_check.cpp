#include "certify/geodesics/completeness_check.h"

#include <algorithm>
#include <numeric>

#include "certify/document/darts.h"
#include "certify/document/text.h"
#include "certify/geodesics/orbit_search.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

/// Bits of two lengths that agree before they are compared exactly.
constexpr slong kTieBits = 30;
/// Operations of balls that a candidate takes before its chords are looked for.
constexpr std::uint64_t kJudgeOperations = 60;

}  // namespace

/// All vertices at one precision.
class CompletenessCheck::Pass {
 public:
  Pass(const CompletenessCheck& check, const LiftedPlane& plane, const ChordTable& table)
      : check_(check),
        plane_(plane),
        net_(plane.net()),
        table_(table),
        first_darts_(first_darts(net_)),
        cosh_half_(check.cosh_half_bound(plane)) {
    const slong precision = plane.precision();
    Ball cosh_epsilon, squared_sinh;
    set_rational(epsilon_.get(), *parse_decimal(net_.epsilon), precision);
    arb_sinh_cosh(sinh_epsilon_.get(), cosh_epsilon.get(), epsilon_.get(), precision);
    // sinh(D/2) = sinh(L/2) cosh ε; cosh D = 1 + 2 sinh²(D/2).
    arb_sqr(squared_sinh.get(), cosh_half_.get(), precision);
    arb_sub_ui(squared_sinh.get(), squared_sinh.get(), 1, precision);
    arb_sqr(cosh_epsilon.get(), cosh_epsilon.get(), precision);
    arb_mul(squared_sinh.get(), squared_sinh.get(), cosh_epsilon.get(), precision);
    arb_mul_2exp_si(cosh_distance_.get(), squared_sinh.get(), 1);
    arb_add_ui(cosh_distance_.get(), cosh_distance_.get(), 1, precision);
    arb_sqr(sinh_distance_.get(), cosh_distance_.get(), precision);
    arb_sub_ui(sinh_distance_.get(), sinh_distance_.get(), 1, precision);
    arb_sqrtpos(sinh_distance_.get(), sinh_distance_.get(), precision);
  }

  /// Calls tick() now and then.
  template <class Tick>
  void examine(std::uint32_t v, Vertex& vertex, const Tick& tick) const {
    vertex.text.clear();
    if (examine_loops(v, vertex)) return;
    const BallVector place = position(v);
    Tri answer = Tri::yes;
    const auto report = [&](const BallIsometry& element, const LabelProduct& product) {
      tick();
      if (inverse_will_do(element)) return Search::go_on;
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
    Ball least, limit;
    arb_sub_ui(least.get(), cosh_distance_.get(), 2, plane_.precision());
    arb_set_ui(limit.get(), check_.limit_);
    return certainly_less(limit.get(), least.get()) == Tri::yes;
  }

  /// True if the vertex is deep; then its short loop is the only candidate.
  bool examine_loops(std::uint32_t v, Vertex& vertex) const {
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
    const slong precision = plane_.precision();
    Ball half_length, width, distance;
    arb_sqr(half_length.get(), element.a.re(), precision);
    arb_sub_ui(half_length.get(), half_length.get(), 1, precision);
    arb_sqrt(half_length.get(), half_length.get(), precision);
    Ball one;
    arb_one(one.get());
    if (certainly_less(half_length.get(), one.get()) != Tri::yes) return false;
    arb_inv(width.get(), half_length.get(), precision);
    arb_asinh(width.get(), width.get(), precision);
    dot(distance.get(), axis_row(element, precision), position(v), precision);
    arb_abs(distance.get(), distance.get());
    arb_asinh(distance.get(), distance.get(), precision);
    arb_add(distance.get(), distance.get(), epsilon_.get(), precision);
    return certainly_less(distance.get(), width.get()) == Tri::yes;
  }

  /// The vertex in its own chart.
  [[nodiscard]] BallVector position(std::uint32_t v) const {
    return unit_vector(identity_isometry(), net_.vertices[v].x, net_.vertices[v].y, plane_.precision());
  }

  /// Whether another element will be reported for the geodesic, the inverse: it moves the vertex as far, and b changes
  /// its sign. Of each pair at least one is left.
  [[nodiscard]] static bool inverse_will_do(const BallIsometry& element) {
    return certainly_positive(element.a.re()) == Tri::yes && certainly_negative(element.b.im()) == Tri::yes;
  }

  /// Whether the element, in the chart of vertex v, is no geodesic that the list lacks: `yes` if it is too long, the
  /// identity, in the list, or (unless `place` is null) if its axis is further than ε from the vertex at `place`.
  [[nodiscard]] Tri judge(std::uint32_t v, const BallIsometry& element, const LabelProduct& product,
                          const BallVector* place, Vertex& vertex) const {
    plane_.spend(kJudgeOperations);
    const Tri shorter = certainly_less(cosh_half_length(element).get(), cosh_half_.get());
    if (shorter == Tri::no) return Tri::yes;
    const std::uint32_t chart = net_.vertices[v].chart;
    const Tri trivial = plane_.same(chart, element, identity_isometry());
    if (trivial == Tri::yes) return Tri::yes;
    if (place != nullptr && is_far(element, *place)) return Tri::yes;
    if (trivial == Tri::unknown) return Tri::unknown;
    ++vertex.candidates;
    const bool systole = check_.document_.claim == GeodesicsDocument::Claim::systole;
    const Tri found = systole ? is_no_shorter(element, shorter, product) : is_listed(v, element, shorter, product);
    if (found == Tri::no) vertex.text = missing_text(v, element, systole ? "is shorter" : "is not in the list");
    return found;
  }

  /// Whether an element is at least as long as the systole listed; `shorter` is what balls say of the contrary.
  [[nodiscard]] Tri is_no_shorter(const BallIsometry& element, Tri shorter, const LabelProduct& product) const {
    if (shorter == Tri::yes) return Tri::no;
    if (!is_near_tie(element)) return Tri::unknown;
    const auto word = check_.evaluator_.word(product());
    const auto sign = check_.traces_.compare(word, check_.evaluator_.word(check_.first_element()));
    if (!sign) return Tri::unknown;
    return *sign < 0 ? Tri::no : Tri::yes;
  }

  /// Whether lengths that balls do not tell apart are so near that the exact numbers should be asked, not more bits.
  [[nodiscard]] bool is_near_tie(const BallIsometry& element) const {
    return arb_rel_accuracy_bits(element.a.re()) >= kTieBits && arb_rel_accuracy_bits(cosh_half_.get()) >= kTieBits;
  }

  [[nodiscard]] bool is_far(const BallIsometry& element, const BallVector& place) const {
    Ball distance;
    dot(distance.get(), axis_row(element, plane_.precision()), place, plane_.precision());
    arb_abs(distance.get(), distance.get());
    return certainly_less(sinh_epsilon_.get(), distance.get()) == Tri::yes;
  }

  /// Whether an element is in the list or too long to have to be there; `shorter` is what balls say of the latter.
  [[nodiscard]] Tri is_listed(std::uint32_t v, const BallIsometry& element, Tri shorter,
                              const LabelProduct& product) const {
    const Tri found = has_chord_in_list(v, element);
    if (found != Tri::no || shorter == Tri::yes) return found;
    // It is missing if it is short enough. An `up_to` is never a length, 2 arsinh 1 may be one.
    if (check_.document_.claim != GeodesicsDocument::Claim::thick_thin || !is_near_tie(element)) return Tri::unknown;
    const auto sign = check_.traces_.compare_with_short(check_.evaluator_.word(product()));
    if (!sign) return Tri::unknown;
    return *sign > 0 ? Tri::yes : Tri::no;
  }

  [[nodiscard]] Tri has_chord_in_list(std::uint32_t v, const BallIsometry& element) const {
    const Interval length = translation_length(element, plane_.precision());
    Tri found = Tri::no;
    const auto list = find_chords(plane_, first_darts_[v], element, [&](const Chord& chord) {
      found = either(found, table_.find(chord, length).found);
      return found != Tri::yes;
    });
    return list ? found : Tri::unknown;
  }

  [[nodiscard]] std::string missing_text(std::uint32_t v, const BallIsometry& element, const char* what) const {
    return "a closed geodesic near vertex " + std::to_string(v) + " of length in " +
           to_string(translation_length(element, plane_.precision())) + " " + what;
  }

  const CompletenessCheck& check_;
  const LiftedPlane& plane_;
  const NetDocument& net_;
  const ChordTable& table_;
  std::vector<std::uint32_t> first_darts_;
  Ball cosh_half_;
  Ball epsilon_;
  Ball sinh_epsilon_;
  Ball cosh_distance_;
  Ball sinh_distance_;
};

CompletenessCheck::CompletenessCheck(const GeodesicsDocument& document, const LabelEvaluator& evaluator,
                                     const CheckOptions& options)
    : document_(document),
      evaluator_(evaluator),
      traces_(evaluator),
      up_to_(document.claim == GeodesicsDocument::Claim::spectrum ? *parse_decimal(document.up_to) : mpq_class()),
      progress_(options.progress),
      limit_(options.max_visits / std::max<std::size_t>(document.net.vertices.size(), 1)),
      vertices_(document.net.vertices.size()),
      loops_(document.net.vertices.size()) {
  const NetDocument& net = document.net;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t v = start(net, dart);
    if (v == start(net, next_dart(dart)) && dart < opposite(net, dart)) loops_[v].push_back(dart);
  }
}

RuleReport CompletenessCheck::check(const LiftedPlane& plane, const ChordTable& table, unsigned threads) {
  const Pass pass(*this, plane, table);
  std::vector<std::uint32_t> open;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    if (vertices_[v].complete == Tri::unknown && !vertices_[v].limit_reached) open.push_back(v);
  }
  // What is begun is forgotten if the budget ends it, so that the counts do not depend on the number of threads.
  std::vector<Vertex> vertices = vertices_;
  for_each_parallel(open.size(), threads, [&](unsigned worker, std::size_t i) {
    pass.examine(open[i], vertices[open[i]], [&] {
      if (worker == 0 && progress_) progress_("complete", static_cast<double>(i) / static_cast<double>(open.size()));
    });
  });
  vertices_ = std::move(vertices);

  const auto find = [&](Tri wanted) {
    return std::find_if(vertices_.begin(), vertices_.end(), [&](const Vertex& v) { return v.complete == wanted; });
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
  if (document_.claim == GeodesicsDocument::Claim::systole) {
    return {"complete", Verdict::verified, "no closed geodesic is shorter than geodesic 0"};
  }
  return {"complete", Verdict::verified,
          "no primitive closed geodesic of length at most " + bound_name() + " is missing"};
}

bool CompletenessCheck::limit_reached() const {
  return std::any_of(vertices_.begin(), vertices_.end(), [](const Vertex& v) { return v.limit_reached; });
}

std::uint64_t CompletenessCheck::visits() const {
  return std::accumulate(vertices_.begin(), vertices_.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Vertex& v) { return sum + v.visits; });
}

std::uint64_t CompletenessCheck::candidates() const {
  return std::accumulate(vertices_.begin(), vertices_.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Vertex& v) { return sum + v.candidates; });
}

std::uint64_t CompletenessCheck::deep_vertices() const {
  return static_cast<std::uint64_t>(
      std::count_if(vertices_.begin(), vertices_.end(), [](const Vertex& v) { return v.deep; }));
}

Ball CompletenessCheck::cosh_half_bound(const LiftedPlane& plane) const {
  Ball result;
  switch (document_.claim) {
    case GeodesicsDocument::Claim::thick_thin:
      arb_sqrt_ui(result.get(), 2, plane.precision());
      break;
    case GeodesicsDocument::Claim::systole:
      result = cosh_half_length(plane.label(first_element()));
      break;
    case GeodesicsDocument::Claim::spectrum:
      set_rational(result.get(), up_to_, plane.precision());
      arb_mul_2exp_si(result.get(), result.get(), -1);
      arb_cosh(result.get(), result.get(), plane.precision());
      break;
  }
  return result;
}

std::string CompletenessCheck::bound_name() const {
  return document_.claim == GeodesicsDocument::Claim::thick_thin ? "2 arsinh 1" : in_quotes(document_.up_to);
}

}  // namespace epsnet::certify
