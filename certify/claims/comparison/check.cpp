#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/comparison/fields.h"
#include "certify/claims/isometries/conjugation.h"
#include "certify/claims/isometries/frames.h"
#include "certify/claims/net/claim.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {
namespace {

using Relation = ComparisonDocument::Relation;

constexpr const char* kOther = "other";
constexpr const char* kIsometric = "isometric";
constexpr const char* kDifferent = "different";

/// Of balls of crossing points. What agrees to so many bits is hardly ever different, and all is compared again.
constexpr slong kFirstBitsOfCrossings = 128;
constexpr slong kMostBitsOfCrossings = 512;

bool claims_isometric(const ComparisonDocument& document) { return document.relation == Relation::isometric; }

Problem isometry_problem(const ComparisonDocument& document) {
  const SurfaceSides sides(document.net.surface);
  const SurfaceSides other_sides(document.other.net.surface);
  const ComparisonDocument::Isometry& isometry = document.isometry;
  if (auto problem = paths_problem(sides, isometry.paths)) return problem;
  if (const auto problem = loops_problem(sides, isometry.pair, 2)) return "pair: " + *problem;
  if (const auto problem = loops_problem(other_sides, isometry.images, 2 + sides.partner.size() / 2)) {
    return "images: " + *problem;
  }
  return std::nullopt;
}

Problem spectrum_problem(const GeodesicsDocument& document) {
  if (document.claim != GeodesicsDocument::Claim::spectrum) return "claim: expected a spectrum";
  return structure_problem(document);
}

/// Says where it is.
Problem in_other(const char* member, const Problem& problem) {
  return problem ? std::string(member) + "." + *problem : problem;
}

}  // namespace

Problem structure_problem(const ComparisonDocument& document) {
  if (claims_isometric(document)) {
    if (auto problem = whole_net_problem(document.net)) return problem;
    if (auto problem = in_other("other_net", whole_net_problem(document.other.net))) return problem;
    return isometry_problem(document);
  }
  if (auto problem = spectrum_problem(document)) return problem;
  return in_other("other_spectrum", spectrum_problem(document.other));
}

std::uint64_t least_bytes(const ComparisonDocument& document) {
  std::uint64_t bytes = least_bytes(static_cast<const GeodesicsDocument&>(document)) + least_bytes(document.other);
  for (const auto* words : {&document.isometry.paths, &document.isometry.pair, &document.isometry.images}) {
    for (const ComparisonDocument::Word& word : *words) bytes += 3 + least_bytes(word);
  }
  return bytes;
}

namespace {

/// How many primitive closed geodesics of a surface are at most so long, by its list: certainly, and at most.
class Count {
 public:
  explicit Count(const GeodesicsDocument& spectrum) : up_to_(decimal(spectrum.up_to)) {
    for (const auto& geodesic : spectrum.geodesics) {
      lower_.push_back(geodesic.length.lower);
      upper_.push_back(geodesic.length.upper);
    }
    // Lower ends are in order, by structure_problem.
    std::sort(upper_.begin(), upper_.end());
  }

  /// The greatest lengths that one of the list may have.
  [[nodiscard]] const std::vector<double>& ends() const { return upper_; }
  [[nodiscard]] std::size_t certainly(double length) const { return at_most(upper_, length); }
  /// Nothing, if the list does not go so far.
  [[nodiscard]] std::optional<std::size_t> perhaps(double length) const {
    if (mpq_class(length) > up_to_) return std::nullopt;
    return at_most(lower_, length);
  }

 private:
  static std::size_t at_most(const std::vector<double>& sorted, double length) {
    return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), length) - sorted.begin());
  }

  mpq_class up_to_;
  std::vector<double> lower_;
  std::vector<double> upper_;
};

/// A length up to which one surface certainly has more closed geodesics than another.
std::optional<std::string> more_geodesics(const char* name, const Count& count, const char* other_name,
                                          const Count& other) {
  for (const double length : count.ends()) {
    const auto at_most = other.perhaps(length);
    if (at_most && count.certainly(length) > *at_most) {
      return std::string("the ") + name + " surface has at least " + std::to_string(count.certainly(length)) +
             " primitive closed geodesics of length at most " + shortest(length) + ", the " + other_name +
             " one at most " + std::to_string(*at_most);
    }
  }
  return std::nullopt;
}

class ComparisonCheck {
 public:
  ComparisonCheck(const ComparisonDocument& document, Verification& run)
      : document_(document), run_(run), genus_(run.certificate().counts.genus) {}

  void ask_isometric(const Crossings& crossings) {
    const NetDocument& net = document_.other.net;
    if (net.triangles.size() > run_.options().max_triangles) {
      return run_.give_up("the net has more triangles than the limit, " + std::to_string(run_.options().max_triangles));
    }
    Crossings other_crossings;
    Claim claim = claim_of(net);
    claim.ask = [&](Verification&, Crossings found) { other_crossings = std::move(found); };
    if (!ask_other(claim, least_bytes(net))) return;
    run_.progress(kIsometric);
    run_.report(isometric(crossings, other_crossings));
  }

  void ask_different(const LabelParts& parts) {
    LabelParts other_parts;
    Claim claim = claim_of(document_.other);
    claim.ask = [&](Verification& run, Crossings found) {
      other_parts = ask_geodesics_rules(document_.other, run, std::move(found));
    };
    if (!ask_other(claim, least_bytes(document_.other))) return;
    other_parts.budget = run_.budget();
    run_.progress(kDifferent);
    run_.report(different(parts, other_parts));
  }

 private:
  /// Rule other: the verdict about another document, with what is left of the work.
  bool ask_other(const Claim& claim, std::uint64_t bytes) {
    run_.progress(kOther);
    CheckOptions options = run_.options();
    options.max_work = std::max<std::uint64_t>(run_.budget().left(), 1);
    if (options.progress) options.progress = [&](std::string_view, double) { run_.progress(kOther); };
    const Certificate certificate = verify(claim, bytes, options);
    run_.budget().spend(certificate.counts.work);
    run_.used(certificate.counts.max_precision_used);
    other_genus_ = certificate.counts.genus;
    const bool verified = certificate.verdict == Verdict::verified;
    const std::string text = verified ? certificate.claim : certificate.rule + ": " + certificate.message;
    run_.report({kOther, certificate.verdict, text});
    return verified;
  }

  [[nodiscard]] std::string genera() const {
    return "the genera are " + std::to_string(genus_) + " and " + std::to_string(other_genus_);
  }

  [[nodiscard]] RuleReport isometric(const Crossings& crossings, const Crossings& other) const {
    const auto& [preserves_orientation, paths, pair, images] = document_.isometry;
    if (genus_ != other_genus_) return {kIsometric, Verdict::refuted, genera()};
    const auto sign = crossing_sign(crossings, pair[0], pair[1], run_.budget());
    if (sign == 0) return {kIsometric, Verdict::refuted, "the axes of the pair do not cross"};
    std::vector<ElementPair> pairs;
    pairs.reserve(images.size());
    for (const auto& word : pair) pairs.push_back({word, images[pairs.size()]});
    for (auto& word : generator_words(SurfaceSides(document_.net.surface), paths, run_.budget())) {
      pairs.push_back({std::move(word), images[pairs.size()]});
    }
    const auto conjugate = are_conjugate(crossings, other, pairs, run_.budget());
    const auto other_sign = crossing_sign(other, images[0], images[1], run_.budget());
    if (!sign || !conjugate || !other_sign) {
      return {kIsometric, Verdict::undecided, "the numbers are too large to be compared exactly"};
    }
    if (!*conjugate) return {kIsometric, Verdict::refuted, "traces differ"};
    if ((*other_sign == *sign) != preserves_orientation) {
      return {kIsometric, Verdict::refuted,
              std::string("it ") + (preserves_orientation ? "reverses" : "preserves") + " the orientation"};
    }
    return {kIsometric, Verdict::verified,
            counted(pairs.size() - 2, "generator", "generators") + " and their images, exactly"};
  }

  [[nodiscard]] RuleReport different(const LabelParts& parts, const LabelParts& other_parts) {
    if (genus_ != other_genus_) return {kDifferent, Verdict::verified, genera()};
    const Count first(document_);
    const Count second(document_.other);
    auto found = more_geodesics("first", first, "other", second);
    if (!found) found = more_geodesics("other", second, "first", first);
    if (!found) found = other_crossings(parts, other_parts);
    if (found) return {kDifferent, Verdict::verified, *found};
    return {kDifferent, Verdict::undecided, "the two lists may be of surfaces that are isometric"};
  }

  /// Closed geodesics up to one length that certainly cross in other ways on the two surfaces.
  [[nodiscard]] std::optional<std::string> other_crossings(const LabelParts& parts, const LabelParts& other_parts) {
    if (decimal(document_.up_to) != decimal(document_.other.up_to)) return std::nullopt;
    const GeodesicsInNet here(document_, parts);
    const GeodesicsInNet there(document_.other, other_parts);
    const long cap = std::min(run_.options().max_precision, kMostBitsOfCrossings);
    std::optional<std::string> found;
    const auto attempt = [&](slong precision) {
      const LiftedPlane plane = here.plane(precision, cap, run_.threads());
      const LiftedPlane other_plane = there.plane(precision, cap, run_.threads());
      const auto first = here.crossings(plane, run_.threads());
      const auto other = first ? there.crossings(other_plane, run_.threads()) : std::nullopt;
      run_.used(static_cast<std::uint64_t>(precision));
      if (!other || !no_isometry(plane, *first, *other)) return false;
      found = "no isometry takes the points where closed geodesics of length at most " + in_quotes(document_.up_to) +
              " cross on the first surface to those on the other one";
      return true;
    };
    with_rising_precision(cap, attempt, kFirstBitsOfCrossings);
    return found;
  }

  const ComparisonDocument& document_;
  Verification& run_;
  std::uint64_t genus_;
  std::uint64_t other_genus_ = 0;
};

}  // namespace

RuleNames own_rules(const ComparisonDocument& document) {
  if (claims_isometric(document)) return {kOther, kIsometric};
  RuleNames rules = own_rules(static_cast<const GeodesicsDocument&>(document));
  rules.insert(rules.end(), {kOther, kDifferent});
  return rules;
}

Claim claim_of(const ComparisonDocument& document) {
  if (claims_isometric(document)) {
    const auto ask = [&](Verification& run, const Crossings& crossings) {
      ComparisonCheck(document, run).ask_isometric(crossings);
    };
    return {document.net, "the two surfaces are isometric", own_rules(document), ask};
  }
  const auto ask = [&](Verification& run, Crossings crossings) {
    const LabelParts parts = ask_geodesics_rules(document, run, std::move(crossings));
    if (run.rules().verified_so_far()) ComparisonCheck(document, run).ask_different(parts);
  };
  return {document.net, "the two surfaces are not isometric", own_rules(document), ask};
}

}  // namespace epsnet::certify
