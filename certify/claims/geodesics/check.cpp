#include "certify/claims/geodesics/check.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "certify/base/counted.h"
#include "certify/base/text.h"
#include "certify/claims/geodesics/crossing_pass.h"
#include "certify/claims/geodesics/cut_surface.h"
#include "certify/claims/geodesics/exact_traces.h"
#include "certify/claims/geodesics/geodesics_rules.h"
#include "certify/claims/geodesics/list_rules.h"
#include "certify/claims/net/claim.h"
#include "certify/numbers/parallel.h"
#include "certify/numbers/precision.h"
#include "certify/verdict/open_rules.h"

namespace epsnet::certify {
namespace {

/// cosh(x/2) of a binary64.
Ball cosh_half(double x) { return cosh(half(Ball::exactly(x))); }

/// Bits that a list is asked with first: fewer hardly ever suffice for the search.
constexpr slong kFirstPrecisionOfSearch = 128;

constexpr const char* kGeodesics = "geodesics";
constexpr const char* kDistinct = "distinct";
constexpr const char* kSimple = "simple";
constexpr const char* kEqualLengths = "equal";
constexpr const char* kComplete = "complete";
constexpr const char* kPieces = "pieces";

class GeodesicsCheck {
 public:
  GeodesicsCheck(const GeodesicsDocument& document, const Verification& run, Crossings crossings)
      : document_(document),
        options_(run.options()),
        threads_(run.threads()),
        net_(with_geodesics_as_labels(document)),
        parts_(label_parts(std::move(crossings), net_.charts, run.budget())),
        evaluator_(net_, parts_),
        first_darts_(first_darts(net_)),
        elements_(document.geodesics.size()),
        traces_(evaluator_),
        rules_(own_rules(document)) {
    std::iota(elements_.begin(), elements_.end(), static_cast<std::uint32_t>(document.net.labels.size()) + 1);
  }

  void ask(Verification& run) {
    try {
      with_rising_precision(
          options_.max_precision,
          [&](slong precision) {
            precision_ = precision;
            pass(precision);
            return verdict(kGeodesics) == Verdict::refuted || all_decided();
          },
          kFirstPrecisionOfSearch);
      if (verdict(kGeodesics) == Verdict::refuted) rules_.keep_first();
    } catch (const BudgetSpent& spent) {
      rules_.give_up(spent.what());
    }
    rules_.conclude(run);
    run.certificate().geodesics = counts();
  }

  /// The parts of the labels, at the end.
  [[nodiscard]] LabelParts take_parts() && { return std::move(parts_); }

 private:
  [[nodiscard]] GeodesicsCounts counts() const {
    return {.geodesics = document_.geodesics.size(),
            .lifted_triangles = completeness_.visits,
            .candidates = completeness_.candidates,
            .deep_vertices = loops_,
            .max_precision_used = static_cast<std::uint64_t>(precision_)};
  }

  [[nodiscard]] Verdict verdict(const char* rule) const { return rules_.verdict(rule); }
  [[nodiscard]] bool open(const char* rule) const { return rules_.open(rule); }

  /// Whether more bits can change nothing.
  [[nodiscard]] bool all_decided() const {
    if (is_wrong()) return true;
    for (const char* rule : {kGeodesics, kDistinct, kSimple, kPieces}) {
      if (open(rule)) return false;
    }
    return !open(kComplete) || completeness_.limit_reached;
  }

  void report(const char* rule, Verdict verdict, std::string text) { rules_.report({rule, verdict, std::move(text)}); }

  void progress(const char* rule) const {
    if (options_.progress) options_.progress(rule, 0);
  }

  /// All open rules at one precision.
  void pass(slong precision) {
    progress(kGeodesics);
    const LiftedPlane plane(net_, evaluator_, parts_, precision, options_.max_precision, threads_);
    if (open(kGeodesics)) check_lengths(plane);
    if (open(kEqualLengths)) check_equal();
    if (verdict(kGeodesics) != Verdict::verified) return;
    const CrossingPass crossings(
        document_, evaluator_, plane, cosh_half_bound(plane),
        [&](std::size_t i) -> CrossingPass::Member {
          return {first_darts_[document_.geodesics[i].vertex], element(plane, i)};
        },
        threads_);
    if (!crossings.complete()) {
      doubt_all("not decided which edges the geodesics cross, with " + bits());
      return;
    }
    if (open(kDistinct)) rules_.report(distinct_report(crossings.table()));
    if (open(kSimple)) {
      rules_.report(simple_report(document_.geodesics, crossings.meetings(), is_thick_thin(), precision_));
    }
    if (is_wrong()) return;
    if (open(kComplete)) check_complete(crossings);
    if (open(kPieces) && verdict(kSimple) == Verdict::verified && verdict(kDistinct) == Verdict::verified) {
      check_pieces(crossings);
    }
  }

  [[nodiscard]] bool is_wrong() const {
    return verdict(kDistinct) == Verdict::refuted || verdict(kSimple) == Verdict::refuted;
  }

  void doubt_all(const std::string& why) {
    for (const char* rule : {kDistinct, kSimple, kComplete, kPieces}) rules_.doubt(rule, why);
  }

  [[nodiscard]] std::string bits() const { return std::to_string(precision_) + " bits"; }
  [[nodiscard]] bool is_systole() const { return document_.claim == GeodesicsDocument::Claim::systole; }
  [[nodiscard]] bool is_thick_thin() const { return document_.claim == GeodesicsDocument::Claim::thick_thin; }

  /// cosh(L/2).
  [[nodiscard]] Ball cosh_half_bound(const LiftedPlane& plane) const {
    if (is_systole()) return cosh_half_length(plane.label(elements_[0]));
    if (is_thick_thin()) return sqrt(Ball::exactly(2));
    return cosh(half(Ball::rounded(decimal(document_.up_to))));
  }

  /// L in words.
  [[nodiscard]] std::string bound_name() const { return is_thick_thin() ? "2 arsinh 1" : in_quotes(document_.up_to); }

  /// The element that translates along geodesic i in its direction: a path ends where the inverse of its word's value
  /// takes its start.
  [[nodiscard]] BallIsometry element(const LiftedPlane& plane, std::size_t i) const {
    BallIsometry result = inverse(plane.label(elements_[i]));
    choose_sign(result);
    return result;
  }

  // Rule geodesics.

  void check_lengths(const LiftedPlane& plane) {
    struct Answer {
      Tri enclosed = Tri::unknown;
      Tri within = Tri::unknown;
    };
    std::vector<Answer> answers(elements_.size());
    for_each_parallel(answers.size(), threads_, [&](unsigned, std::size_t i) {
      const BallIsometry f = element(plane, i);
      answers[i].enclosed = is_enclosed(f, document_.geodesics[i].length);
      answers[i].within = is_systole() ? Tri::yes : is_within(plane, f, i);
    });
    for (const Tri wanted : {Tri::no, Tri::unknown}) {
      const auto found = std::find_if(answers.begin(), answers.end(), [&](const Answer& answer) {
        return answer.enclosed == wanted || answer.within == wanted;
      });
      if (found == answers.end()) continue;
      const auto i = static_cast<std::size_t>(found - answers.begin());
      const bool wrong = wanted == Tri::no;
      const std::string actual =
          " has a length in " + to_string(translation_length(element(plane, i), plane.precision()));
      const std::string what =
          found->enclosed == wanted
              ? (wrong ? ", not in " : ", not decided whether in ") + to_string(document_.geodesics[i].length)
              : (wrong ? ", more than " : ", not decided whether at most ") + bound_name();
      report(kGeodesics, wrong ? Verdict::refuted : Verdict::undecided,
             geodesic_name(i) + actual + what + (wrong ? "" : ", with " + bits()));
      return;
    }
    report(kGeodesics, Verdict::verified,
           counted(elements_.size(), "closed geodesic has its length in its enclosure",
                   "closed geodesics have lengths in their enclosures"));
  }

  /// lo ≤ l ≤ hi; equality is impossible, as cosh(l/2) is algebraic.
  [[nodiscard]] Tri is_enclosed(const BallIsometry& f, Interval length) const {
    const Ball cosh = cosh_half_length(f);
    const Tri above_lower = certainly_less(cosh_half(length.lower), cosh);
    const Tri below_upper = certainly_less(cosh, cosh_half(length.upper));
    return both(above_lower, below_upper);
  }

  [[nodiscard]] Tri is_within(const LiftedPlane& plane, const BallIsometry& f, std::size_t i) const {
    const Tri less = certainly_less(cosh_half_length(f), cosh_half_bound(plane));
    if (less != Tri::unknown || !is_thick_thin()) return less;
    const auto sign = traces_.compare_with_short(evaluator_.word(elements_[i]));
    if (!sign) return Tri::unknown;
    return *sign > 0 ? Tri::no : Tri::yes;
  }

  // Rule equal.

  void check_equal() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // Said to be of equal length.
    std::size_t claimed = 0;
    for (const GeodesicsDocument::Cluster& cluster : document_.clusters) {
      if (!cluster.equal) continue;
      ++claimed;
      for (std::uint32_t i = cluster.first + 1; i < cluster.first + cluster.count; ++i) {
        pairs.emplace_back(cluster.first, i);
      }
    }
    std::vector<Tri> equal(pairs.size(), Tri::unknown);
    for_each_parallel(pairs.size(), threads_, [&](unsigned, std::size_t k) {
      equal[k] = lengths_equal(elements_[pairs[k].first], elements_[pairs[k].second]);
    });
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (equal[k] == Tri::yes) continue;
      const std::string names = geodesic_name(pairs[k].first) + " and " + geodesic_name(pairs[k].second);
      report(kEqualLengths, equal[k] == Tri::no ? Verdict::refuted : Verdict::undecided,
             equal[k] == Tri::no ? names + " have different lengths in a cluster of equal ones"
                                 : names + ": the words are too long to compare the lengths exactly");
      return;
    }
    report(kEqualLengths, Verdict::verified,
           std::to_string(claimed) + " of " + std::to_string(document_.clusters.size()) +
               " clusters consist of equal lengths, exactly");
  }

  [[nodiscard]] Tri lengths_equal(std::uint32_t number, std::uint32_t other) const {
    const auto sign = traces_.compare(evaluator_.word(number), evaluator_.word(other));
    if (!sign) return Tri::unknown;
    return *sign == 0 ? Tri::yes : Tri::no;
  }

  // Rule complete.

  void check_complete(const CrossingPass& crossings) {
    completeness_ = crossings.search(options_.max_visits, threads_, [&](double share) {
      if (options_.progress) options_.progress(kComplete, share);
    });
    loops_ = crossings.loops();
    if (completeness_.complete == Tri::no) {
      report(kComplete, Verdict::refuted, completeness_.missing);
    } else if (completeness_.limit_reached) {
      report(kComplete, Verdict::undecided,
             "the search crosses more than " + std::to_string(options_.max_visits) + " edges, its limit");
    } else if (completeness_.complete == Tri::unknown) {
      report(kComplete, Verdict::undecided, "not decided whether all geodesics are in the list, with " + bits());
    } else {
      report(kComplete, Verdict::verified,
             is_systole() ? "no closed geodesic is shorter than geodesic 0"
                          : "no primitive closed geodesic of length at most " + bound_name() + " is missing");
    }
  }

  // Rule pieces.

  void check_pieces(const CrossingPass& crossings) {
    const auto found = cut_surface(crossings.net(), crossings.geodesics());
    if (!found) {
      rules_.doubt(kPieces, "not decided how the geodesics cut the triangles, with " + bits());
      return;
    }
    const auto boundaries = [](const GeodesicsDocument::Piece& x, const GeodesicsDocument::Piece& y) {
      return x.boundaries < y.boundaries;
    };
    std::vector<GeodesicsDocument::Piece> actual = *found;
    std::vector<GeodesicsDocument::Piece> claimed = document_.pieces;
    for (GeodesicsDocument::Piece& piece : claimed) std::sort(piece.boundaries.begin(), piece.boundaries.end());
    std::sort(actual.begin(), actual.end(), boundaries);
    std::sort(claimed.begin(), claimed.end(), boundaries);
    if (actual == claimed) {
      report(kPieces, Verdict::verified, counted(actual.size(), "piece", "pieces") + ", as said");
    } else {
      report(kPieces, Verdict::refuted, "the surface cut along the geodesics has " + pieces_text(actual));
    }
  }

  static std::string pieces_text(const std::vector<GeodesicsDocument::Piece>& pieces) {
    constexpr std::size_t kShown = 20;
    std::string result = counted(pieces.size(), "piece", "pieces") + " (genus, boundaries):";
    for (std::size_t i = 0; i < std::min(pieces.size(), kShown); ++i) {
      result += " (" + std::to_string(pieces[i].genus) + ", " + std::to_string(pieces[i].boundaries.size()) + ")";
    }
    return pieces.size() > kShown ? result + " ..." : result;
  }

  const GeodesicsDocument& document_;
  const CheckOptions& options_;
  unsigned threads_;
  NetDocument net_;
  LabelParts parts_;
  LabelEvaluator evaluator_;
  std::vector<std::uint32_t> first_darts_;
  std::vector<std::uint32_t> elements_;  ///< By geodesic: its label number in net_.
  ExactTraces traces_;
  Completeness completeness_;  ///< At the last precision that it was asked with.
  std::size_t loops_ = 0;      ///< In collars, then.
  OpenRules rules_;
  slong precision_ = 64;
};

/// What the document says of its list, in words.
std::string text_of(const GeodesicsDocument& document) {
  const std::string count = std::to_string(document.geodesics.size());
  switch (document.claim) {
    case GeodesicsDocument::Claim::systole:
      return "the systole: no closed geodesic is shorter than geodesic 0, whose length lies in " +
             to_string(document.geodesics[0].length);
    case GeodesicsDocument::Claim::spectrum:
      return "the spectrum: the " + count + " primitive closed geodesics of length at most " +
             in_quotes(document.up_to) + ", up to orientation";
    case GeodesicsDocument::Claim::thick_thin:
      break;
  }
  return "the thick-thin decomposition: the " + count +
         " primitive closed geodesics of length at most 2 arsinh 1, up to orientation, and the pieces without them";
}

}  // namespace

RuleNames own_rules(const GeodesicsDocument& document) {
  if (document.claim == GeodesicsDocument::Claim::systole) return {kGeodesics, kSimple, kComplete};
  RuleNames rules{kGeodesics, kDistinct, kSimple, kEqualLengths, kComplete};
  if (document.claim == GeodesicsDocument::Claim::thick_thin) rules.emplace_back(kPieces);
  return rules;
}

NetDocument with_geodesics_as_labels(const GeodesicsDocument& document) {
  NetDocument net = document.net;
  for (const GeodesicsDocument::ClosedGeodesic& geodesic : document.geodesics) {
    const std::uint32_t chart = net.vertices[geodesic.vertex].chart;
    net.labels.push_back({chart, chart, geodesic.word});
  }
  return net;
}

LabelParts ask_geodesics_rules(const GeodesicsDocument& document, Verification& run, Crossings crossings) {
  GeodesicsCheck check(document, run, std::move(crossings));
  check.ask(run);
  return std::move(check).take_parts();
}

Claim claim_of(const GeodesicsDocument& document) {
  const auto ask = [&](Verification& run, Crossings crossings) {
    (void)ask_geodesics_rules(document, run, std::move(crossings));
  };
  return {document.net, text_of(document), own_rules(document), ask};
}

}  // namespace epsnet::certify
