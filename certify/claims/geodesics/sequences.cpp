#include "certify/claims/geodesics/sequences.h"

#include <algorithm>
#include <numeric>

#include "certify/base/error.h"

namespace epsnet::certify {
namespace {

/// The way back.
std::vector<std::uint32_t> reversed(std::span<const std::uint32_t> codes) {
  std::vector<std::uint32_t> result(codes.rbegin(), codes.rend());
  for (std::uint32_t& code : result) code ^= 1U;
  return result;
}

/// Turns a cyclic sequence to its least rotation.
std::vector<std::uint32_t> least_rotation(std::vector<std::uint32_t> codes) {
  // Two beginnings are compared. If after k equal codes one has a greater one, it and the k after it are none.
  const std::size_t n = codes.size();
  std::size_t i = 0, j = 1, k = 0;
  while (i < n && j < n && k < n) {
    const std::uint32_t x = codes[(i + k) % n];
    const std::uint32_t y = codes[(j + k) % n];
    if (x == y) {
      ++k;
      continue;
    }
    (x > y ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  std::rotate(codes.begin(), codes.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)), codes.end());
  return codes;
}

}  // namespace

std::size_t period_of(std::span<const std::uint32_t> codes) {
  for (std::size_t period = 1; 2 * period <= codes.size(); ++period) {
    if (codes.size() % period == 0 &&
        std::equal(codes.begin() + static_cast<std::ptrdiff_t>(period), codes.end(), codes.begin()))
      return period;
  }
  return codes.size();
}

LeastSequence least_sequence(std::span<const std::uint32_t> codes) {
  ensure(!codes.empty(), "a closed way across no edge");
  const std::size_t period = period_of(codes);
  const std::span<const std::uint32_t> once = codes.first(period);
  LeastSequence result{least_rotation({once.begin(), once.end()}), static_cast<std::uint32_t>(codes.size() / period)};
  std::vector<std::uint32_t> back = least_rotation(reversed(once));
  if (back < result.root) {
    result.root = std::move(back);
    result.backwards = true;
  }
  return result;
}

SequenceTable::SequenceTable(std::vector<LeastSequence> sequences)
    : sequences_(std::move(sequences)), order_(sequences_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t x, std::uint32_t y) { return sequences_[x].root < sequences_[y].root; });
}

/// The geodesics with this root, in order.
std::span<const std::uint32_t> SequenceTable::with_root(const std::vector<std::uint32_t>& root) const {
  const auto first = std::lower_bound(order_.begin(), order_.end(), root,
                                      [&](std::uint32_t x, const auto& y) { return sequences_[x].root < y; });
  const auto last = std::find_if(first, order_.end(), [&](std::uint32_t x) { return sequences_[x].root != root; });
  return {first, last};
}

bool SequenceTable::contains(const std::vector<std::uint32_t>& root) const {
  const auto found = with_root(root);
  return std::any_of(found.begin(), found.end(), [&](std::uint32_t i) { return sequences_[i].exponent == 1; });
}

std::optional<SequenceTable::Match> SequenceTable::find_other(std::uint32_t geodesic) const {
  const LeastSequence& own = looked_up(sequences_, geodesic, "there is no geodesic");
  for (const std::uint32_t other : with_root(own.root)) {
    const std::uint32_t exponent = sequences_[other].exponent;
    if (other != geodesic && own.exponent % exponent == 0) return Match{other, own.exponent / exponent};
  }
  return std::nullopt;
}

namespace {

template <class CrossingsOfAKind>
[[nodiscard]] bool feasible(const CrossingsOfAKind& crossings, std::span<const std::uint32_t> word) {
  return !word.empty() && crossings.product_bits(0, word) <= CrossingsOfAKind::kMaxExactBits;
}

/// tr² and det of the value of a word.
template <class Real>
struct Trace {
  Real squared;
  Real determinant;
};

template <class CrossingsOfAKind>
[[nodiscard]] auto trace_of(const CrossingsOfAKind& crossings, std::span<const std::uint32_t> word,
                            const Budget& budget) {
  budget.spend(crossings.letter_work(), word.size());
  budget.spend(CrossingsOfAKind::exact_work(crossings.product_bits(0, word)));
  const auto f = crossings.exact(word);
  const auto trace = twice_real(f.a);
  return Trace<std::decay_t<decltype(norm(f.a))>>{trace * trace, norm(f.a) - norm(f.b)};
}

}  // namespace

std::optional<int> ExactTraces::compare(std::span<const std::uint32_t> word,
                                        std::span<const std::uint32_t> other) const {
  if (std::equal(word.begin(), word.end(), other.begin(), other.end())) return 0;
  return std::visit(
      [&](const auto& crossings) -> std::optional<int> {
        if (!feasible(crossings, word) || !feasible(crossings, other)) return std::nullopt;
        const auto f = trace_of(crossings, word, budget_);
        const auto g = trace_of(crossings, other, budget_);
        // Determinants are positive.
        return sign(f.squared * g.determinant - g.squared * f.determinant);
      },
      crossings_);
}

std::optional<int> ExactTraces::compare_with_short(std::span<const std::uint32_t> word) const {
  return std::visit(
      [&](const auto& crossings) -> std::optional<int> {
        if (!feasible(crossings, word)) return std::nullopt;
        const auto f = trace_of(crossings, word, budget_);
        // tr²/det = 4 cosh²(arsinh 1) = 8.
        return sign(f.squared - mpz_class(8) * f.determinant);
      },
      crossings_);
}

std::string geodesic_name(std::size_t i) { return "geodesic " + std::to_string(i); }

RuleReport distinct_report(const SequenceTable& table) {
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    const auto match = table.find_other(i);
    if (!match) continue;
    const std::string power = match->power == 1 ? "" : ", run through " + std::to_string(match->power) + " times";
    return {"distinct", Verdict::refuted,
            geodesic_name(i) + " is " + geodesic_name(match->geodesic) + power + ", up to orientation"};
  }
  return {"distinct", Verdict::verified, "no two are the same and none is a power of another"};
}

RuleReport simple_report(std::span<const GeodesicsDocument::ClosedGeodesic> geodesics,
                         std::span<const Meetings> meetings, bool disjoint, slong precision) {
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const bool simple = geodesics[i].simple;
    if (meetings[i].itself == (simple ? Tri::yes : Tri::no)) {
      return {"simple", Verdict::refuted, geodesic_name(i) + (simple ? " is not simple" : " is simple")};
    }
    if (meetings[i].another == Tri::yes) return {"simple", Verdict::refuted, geodesic_name(i) + " meets another one"};
  }
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    if (meetings[i].itself != Tri::unknown && meetings[i].another != Tri::unknown) continue;
    return {"simple", Verdict::undecided,
            geodesic_name(i) + ": not decided what it crosses, with " + std::to_string(precision) + " bits"};
  }
  const auto simple =
      std::count_if(geodesics.begin(), geodesics.end(), [](const auto& geodesic) { return geodesic.simple; });
  return {"simple", Verdict::verified,
          std::to_string(simple) + " of " + std::to_string(meetings.size()) + " are simple" +
              (disjoint ? ", and they are pairwise disjoint" : "")};
}

}  // namespace epsnet::certify
