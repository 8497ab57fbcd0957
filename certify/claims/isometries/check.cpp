#include <algorithm>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/claims/isometries/conjugation.h"
#include "certify/claims/isometries/fields.h"
#include "certify/claims/isometries/frames.h"
#include "certify/claims/net/claim.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {
namespace {

using Document = IsometriesDocument;

Problem cocycle_problem(const SurfaceSides& sides, const Document& document) {
  if (document.cocycle.size() != sides.partner.size() / 2) {
    return "cocycle: " + std::to_string(document.cocycle.size()) + " numbers, expected one for each pair of sides, " +
           std::to_string(sides.partner.size() / 2);
  }
  const std::vector<std::uint32_t> value = cocycle_by_side(sides, document.cocycle);
  for (const std::uint32_t first : sides.vertices()) {
    std::uint32_t sum = 0;
    std::uint32_t s = first;
    do {
      sum += value[s];
      s = sides.next_around(s);
    } while (s != first);
    if (sum != 0) {
      return "cocycle: the sum around the vertex where side " + std::to_string(first) + " starts is " +
             std::to_string(sum) + ", expected 0 modulo 2^32";
    }
  }
  return std::nullopt;
}

}  // namespace

Problem structure_problem(const Document& document) {
  if (document.claim != GeodesicsDocument::Claim::spectrum) return "claim: expected a spectrum";
  if (auto problem = structure_problem(static_cast<const GeodesicsDocument&>(document))) return problem;
  const SurfaceSides sides(document.net.surface);
  if (document.order == 0) return "order: 0, expected at least 1";
  if (auto problem = isometries_problem(sides, document)) return problem;
  return cocycle_problem(sides, document);
}

std::uint64_t least_bytes(const Document& document) {
  return least_bytes(static_cast<const GeodesicsDocument&>(document)) +
         least_bytes(static_cast<const IsometryRows&>(document)) + least_bytes(document.cocycle);
}

namespace {

constexpr const char* kIsometries = "isometries";
constexpr const char* kLeast = "least";
constexpr const char* kMost = "most";

constexpr slong kFirstBits = 128;

RuleNames rules_beyond_the_spectrum() { return {kIsometries, kLeast, kMost}; }

class IsometriesCheck {
 public:
  IsometriesCheck(const IsometriesDocument& document, Verification& run, const LabelParts& parts)
      : document_(document),
        options_(run.options()),
        threads_(run.threads()),
        parts_(parts),
        budget_(run.budget()),
        sides_(document.net.surface),
        geodesics_(document, parts),
        rules_(rules_beyond_the_spectrum()) {}

  void ask(Verification& run) {
    try {
      run.progress(kIsometries);
      rules_.report(isometries_report(parts_.crossings, sides_, document_, budget_));
      if (rules_.verdict(kIsometries) == Verdict::verified) check_least();
      if (rules_.verdict(kIsometries) == Verdict::verified && rules_.verdict(kLeast) != Verdict::refuted) {
        run.progress(kMost);
        with_rising_precision(
            options_.max_precision,
            [&](slong precision) {
              check_most(precision);
              run.used(static_cast<std::uint64_t>(precision));
              return !rules_.open(kMost);
            },
            kFirstBits);
      }
    } catch (const BudgetSpent& spent) {
      rules_.give_up(so_far_ + spent.what());
    }
    rules_.conclude(run);
  }

 private:
  void report(const char* rule, Verdict verdict, std::string text) { rules_.report({rule, verdict, std::move(text)}); }

  // Rule least.

  void check_least() {
    const std::uint64_t found = orbit_size(sides_, document_, budget_);
    const std::string order = std::to_string(document_.order);
    if (found > document_.order) {
      report(kLeast, Verdict::refuted, "they generate more than " + order);
    } else if (found < document_.order) {
      report(kLeast, Verdict::undecided,
             "they generate at least " + std::to_string(found) + "; not decided whether " + order);
    } else {
      report(kLeast, Verdict::verified, "they generate at least " + order);
    }
  }

  // Rule most.

  void check_most(slong precision) {
    const std::string bits = std::to_string(precision) + " bits";
    const LiftedPlane plane = geodesics_.plane(precision, options_.max_precision, threads_);
    const auto geodesics = geodesics_.crossings(plane, threads_);
    if (!geodesics) return rules_.doubt(kMost, "not decided where the geodesics cross, with " + bits);
    const std::uint64_t most = least_frames(plane, *geodesics);
    if (most == 0) {
      rules_.doubt(kMost, "no two of the geodesics cross");
    } else if (most <= document_.order) {
      // Never less, as there are so many.
      report(kMost, most == document_.order ? Verdict::verified : Verdict::refuted,
             "there are at most " + std::to_string(most));
    } else {
      rules_.doubt(kMost, "there are at most " + std::to_string(most) + ", with " + bits);
    }
  }

  /// The least of the bounds that the geodesics give, as far as they are needed; 0 if there is none. One crossing point
  /// of each is asked: the others have the same frames (Lemma 41).
  [[nodiscard]] std::uint64_t least_frames(const LiftedPlane& plane, const CrossingGeodesics& geodesics) {
    // One geodesic for each length.
    std::vector<std::uint32_t> asked;
    plane.spend(document_.clusters.size(), geodesics.points.size());
    for (const GeodesicsDocument::Cluster& cluster : document_.clusters) {
      if (!geodesics.points[cluster.first].empty()) asked.push_back(cluster.first);
    }
    std::uint64_t least = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      so_far_ = (least == 0 ? "" : "there are at most " + std::to_string(least) + ", ") + "by " + std::to_string(i) +
                " of " + counted(asked.size(), "geodesic", "geodesics") + "; ";
      const std::uint64_t found = possible_frames(plane, geodesics, asked[i], 0);
      if (least == 0 || found < least) least = found;
      if (least <= document_.order) return least;
    }
    so_far_ = "there are at most " + std::to_string(least) + ", by each geodesic; ";
    return std::min(least, followed_frames(plane, geodesics, document_.order));
  }

  const IsometriesDocument& document_;
  const CheckOptions& options_;
  unsigned threads_;
  const LabelParts& parts_;
  const Budget& budget_;
  SurfaceSides sides_;
  GeodesicsInNet geodesics_;
  OpenRules rules_;
  std::string so_far_;  ///< What is known if the work is used up now.
};

std::string text_of(const IsometriesDocument& document) {
  const bool all_preserve = std::all_of(document.isometries.begin(), document.isometries.end(),
                                        [](const auto& isometry) { return isometry.preserves_orientation; });
  return "the surface has exactly " + counted(document.order, "isometry", "isometries") +
         (all_preserve ? ", all of which preserve" : ", half of which preserve") + " the orientation";
}

}  // namespace

RuleNames own_rules(const IsometriesDocument& /*document*/) {
  GeodesicsDocument spectrum;
  spectrum.claim = GeodesicsDocument::Claim::spectrum;
  RuleNames rules = own_rules(spectrum);
  for (const std::string_view rule : rules_beyond_the_spectrum()) rules.push_back(rule);
  return rules;
}

Claim claim_of(const IsometriesDocument& document) {
  const auto ask = [&](Verification& run, Crossings crossings) {
    const LabelParts parts = ask_geodesics_rules(document, run, std::move(crossings));
    if (run.rules().verified_so_far()) IsometriesCheck(document, run, parts).ask(run);
  };
  return {document.net, text_of(document), own_rules(document), ask};
}

}  // namespace epsnet::certify
