#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/crossing_search.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/claims/geodesics/local_maximum.h"
#include "certify/claims/geodesics/sequences.h"
#include "certify/claims/net/claim.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {
namespace {

Problem geodesics_problem(const GeodesicsDocument& document) {
  const SurfaceSides sides(document.net.surface);
  const auto& rows = document.geodesics;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].vertex >= document.net.vertices.size()) {
      return at("geodesics", i) + "vertex " + std::to_string(rows[i].vertex) + " does not exist";
    }
    const auto& [vertex, word, length, simple] = rows[i];
    const std::uint32_t tile = document.net.charts[document.net.vertices[vertex].chart].tile;
    if (const auto problem = word_problem(sides, word, tile, tile, "vertex " + std::to_string(vertex))) {
      return at("geodesics", i) + *problem;
    }
    if (!is_length(length) || length.lower == 0) {
      return at("geodesics", i) + "the length " + to_string(length) + " is not 0 < lo <= hi";
    }
    if (i > 0 && rows[i].length.lower < rows[i - 1].length.lower) {
      return at("geodesics", i) + "lo is less than that of the element before";
    }
  }
  return std::nullopt;
}

Problem systole_problem(const GeodesicsDocument& document) {
  if (!document.clusters.empty() || !document.pieces.empty() || !document.up_to.empty() || !document.basis.empty() ||
      !document.weights.empty()) {
    return "claim: a systole has neither up_to nor clusters nor pieces nor basis nor weights";
  }
  if (document.geodesics.size() != 1) {
    return "geodesics: " + std::to_string(document.geodesics.size()) + " elements, expected one, a systole";
  }
  const Interval length = document.geodesics[0].length;
  if (length.upper / 2 < length.lower) return std::nullopt;
  return "geodesics[0]: the length is not enclosed, expected hi < 2 lo";
}

Problem up_to_problem(const GeodesicsDocument& document) {
  if (!document.has_up_to()) {
    if (document.up_to.empty()) return std::nullopt;
    return "up_to: only a spectrum or a local maximum has it";
  }
  const auto up_to = parse_decimal(document.up_to);
  if (!up_to) return "up_to: " + in_quotes(document.up_to) + " is not a decimal, such as \"2.5\"";
  if (*up_to <= 0) return "up_to: " + in_quotes(document.up_to) + " is not positive";
  return std::nullopt;
}

/// The runs that the enclosures make, of which only `equal` is free.
std::vector<GeodesicsDocument::Cluster> runs(const std::vector<GeodesicsDocument::ClosedGeodesic>& geodesics) {
  std::vector<GeodesicsDocument::Cluster> result;
  double end = 0;
  for (std::uint32_t i = 0; i < geodesics.size(); ++i) {
    const Interval length = geodesics[i].length;
    if (result.empty() || length.lower > end) result.push_back({i, 0, false});
    ++result.back().count;
    end = std::max(end, length.upper);
  }
  return result;
}

Problem clusters_problem(const GeodesicsDocument& document) {
  const std::vector<GeodesicsDocument::Cluster> expected = runs(document.geodesics);
  const auto& rows = document.clusters;
  for (std::size_t i = 0; i < std::max(rows.size(), expected.size()); ++i) {
    if (i < rows.size() && i < expected.size() && rows[i].first == expected[i].first &&
        rows[i].count == expected[i].count) {
      continue;
    }
    return at("clusters", i) + "is not the run that the lengths make, expected " +
           (i < expected.size()
                ? "the " + std::to_string(expected[i].count) + " elements from " + std::to_string(expected[i].first)
                : "no more");
  }
  return std::nullopt;
}

Problem pieces_problem(const GeodesicsDocument& document) {
  if (document.claim != GeodesicsDocument::Claim::thick_thin) {
    if (document.pieces.empty()) return std::nullopt;
    return "pieces: only a thick-thin decomposition has them";
  }
  std::vector<bool> used(2 * document.geodesics.size());
  std::size_t sides = 0;
  for (std::size_t row = 0; row < document.pieces.size(); ++row) {
    for (const auto& [geodesic, side] : document.pieces[row].boundaries) {
      if (geodesic >= document.geodesics.size() || side > 1) {
        return at("pieces", row) + "side " + std::to_string(side) + " of geodesic " + std::to_string(geodesic) +
               " does not exist";
      }
      if (used[2 * std::size_t{geodesic} + side]) {
        return at("pieces", row) + "side " + std::to_string(side) + " of geodesic " + std::to_string(geodesic) +
               " occurs twice";
      }
      used[2 * std::size_t{geodesic} + side] = true;
      ++sides;
    }
  }
  if (sides == used.size()) return std::nullopt;
  return "pieces: " + std::to_string(sides) + " of " + std::to_string(used.size()) + " sides of geodesics occur";
}

Problem maximum_problem(const GeodesicsDocument& document) {
  const auto& [basis, weights] = std::tie(document.basis, document.weights);
  if (document.claim != GeodesicsDocument::Claim::local_maximum) {
    if (basis.empty() && weights.empty()) return std::nullopt;
    return "basis: only a local maximum has it, and weights";
  }
  if (document.clusters.empty() || !document.clusters[0].equal) {
    return "clusters: the first ones of a local maximum are of equal length";
  }
  // 6g − 6 = −3χ, and twice χ is twice the number of vertices less that of triangles.
  const std::uint32_t shortest = document.clusters[0].count;
  if (2 * basis.size() + 6 * document.net.vertices.size() != 3 * document.net.triangles.size()) {
    return "basis: " + counted(basis.size(), "element", "elements") + ", expected 6g - 6";
  }
  for (std::size_t k = 0; k < basis.size(); ++k) {
    if (basis[k] >= shortest || (k > 0 && basis[k] <= basis[k - 1])) {
      return at("basis", k) + std::to_string(basis[k]) + " is not one of the first " + std::to_string(shortest) +
             " geodesics after the one before";
    }
  }
  if (basis.size() + weights.size() != shortest) {
    return "weights: " + counted(weights.size(), "element", "elements") + ", expected one for each of the first " +
           std::to_string(shortest) + " geodesics that is not in the basis";
  }
  const auto zero = std::find(weights.begin(), weights.end(), 0U);
  if (zero == weights.end()) return std::nullopt;
  return at("weights", static_cast<std::size_t>(zero - weights.begin())) + "0, expected at least 1";
}

}  // namespace

Problem structure_problem(const GeodesicsDocument& document) {
  // The search relies on vertices near every point of the surface.
  if (auto problem = whole_net_problem(document.net)) return problem;
  if (auto problem = geodesics_problem(document)) return problem;
  if (document.claim == GeodesicsDocument::Claim::systole) return systole_problem(document);
  if (auto problem = up_to_problem(document)) return problem;
  if (auto problem = clusters_problem(document)) return problem;
  if (auto problem = pieces_problem(document)) return problem;
  return maximum_problem(document);
}

std::uint64_t least_bytes(const GeodesicsDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + document.up_to.size();
  for (const GeodesicsDocument::ClosedGeodesic& row : document.geodesics) bytes += 52 + least_bytes(row.word);
  bytes += 34 * document.clusters.size();
  for (const GeodesicsDocument::Piece& piece : document.pieces) bytes += 26 + 6 * piece.boundaries.size();
  return bytes + 2 * (document.basis.size() + document.weights.size());
}

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
constexpr const char* kMaximal = "maximal";

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
    if (open(kComplete)) return completeness_.limit_reached;
    return !open(kMaximal) || !lists_shortest();
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
    if (open(kMaximal) && lists_shortest()) check_maximal(crossings);
  }

  /// Whether the first cluster is known to have the shortest closed geodesics.
  [[nodiscard]] bool lists_shortest() const {
    for (const char* rule : {kDistinct, kSimple, kEqualLengths, kComplete}) {
      if (verdict(rule) != Verdict::verified) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_wrong() const {
    return verdict(kDistinct) == Verdict::refuted || verdict(kSimple) == Verdict::refuted;
  }

  void doubt_all(const std::string& why) {
    for (const char* rule : {kDistinct, kSimple, kComplete, kPieces, kMaximal}) rules_.doubt(rule, why);
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
    // Once for all geodesics: up_to may have many digits.
    const Ball bound = is_systole() ? Ball() : cosh_half_bound(plane);
    for_each_parallel(answers.size(), threads_, [&](unsigned, std::size_t i) {
      const BallIsometry f = element(plane, i);
      answers[i].enclosed = is_enclosed(f, document_.geodesics[i].length);
      answers[i].within = is_systole() ? Tri::yes : is_within(bound, f, i);
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

  [[nodiscard]] Tri is_within(const Ball& bound, const BallIsometry& f, std::size_t i) const {
    const Tri less = certainly_less(cosh_half_length(f), bound);
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

  // Rule maximal.

  void check_maximal(const CrossingPass& crossings) {
    const std::vector<AxisCrossings>& shortest = crossings.geodesics();
    const auto derivatives = twist_derivatives(crossings.net().plane(), shortest, document_.basis);
    if (!derivatives) {
      rules_.doubt(kMaximal, "not decided which of the shortest geodesics cross, with " + bits());
      return;
    }
    const auto weights = weights_of_basis(crossings.net().plane(), *derivatives, document_.basis, document_.weights);
    if (!weights) {
      rules_.doubt(kMaximal, "not decided whether the gradients of the basis span, with " + bits());
      return;
    }
    for (const Tri wanted : {Tri::no, Tri::unknown}) {
      for (std::size_t k = 0; k < weights->size(); ++k) {
        if (certainly_positive((*weights)[k]) != wanted) continue;
        const bool wrong = wanted == Tri::no;
        report(kMaximal, wrong ? Verdict::refuted : Verdict::undecided,
               geodesic_name(document_.basis[k]) + " has a weight in " + to_string(outer_interval((*weights)[k])) +
                   (wrong ? ", not positive" : ", not decided whether positive, with " + bits()));
        return;
      }
    }
    report(kMaximal, Verdict::verified,
           "near the surface all others have a lesser systole: the gradients of the " +
               std::to_string(shortest.size()) + " shortest geodesics span, and with positive weights their sum is 0");
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
    case GeodesicsDocument::Claim::local_maximum:
      return "a local maximum of the systole: surfaces near this one have a lesser systole; it has " +
             std::to_string(document.clusters[0].count) + " shortest closed geodesics, of length in " +
             to_string(document.geodesics[0].length) + ", among the " + count + " primitive ones of length at most " +
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
  if (document.claim == GeodesicsDocument::Claim::local_maximum) rules.emplace_back(kMaximal);
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
