#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "certify/base/text.h"
#include "certify/claims/net/claim.h"
#include "certify/claims/pants/fields.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/isometry.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {
namespace {

/// What is wrong with the paths of a pair of pants.
Problem paths_problem(const SurfaceSides& sides, const PantsDocument::Paths& paths) {
  if (paths[0].empty()) return "the first path has no letters";
  if (paths[0][0] >= sides.tile.size()) return "side " + std::to_string(paths[0][0]) + " does not exist";
  const std::uint32_t tile = sides.tile[paths[0][0]];
  for (const PantsDocument::Word& path : paths) {
    if (auto problem = word_problem(sides, path, tile, tile, "its start")) return problem;
  }
  return std::nullopt;
}

Problem cuff_problem(const PantsDocument& document, const SurfaceSides& sides, const PantsDocument::Cuff& cuff,
                     std::vector<bool>& seen) {
  for (const auto& [p, k] : cuff.ends) {
    const std::string name = "cuff " + std::to_string(k) + " of pair of pants " + std::to_string(p);
    if (p >= document.pants.size() || k > 2) return name + " does not exist";
    if (seen[3 * p + k]) return name + " occurs twice";
    seen[3 * p + k] = true;
  }
  const auto tile = [&](const PantsDocument::End& end) { return sides.tile[document.pants[end[0]][0][0]]; };
  if (auto problem = word_problem(sides, cuff.across, tile(cuff.ends[0]), tile(cuff.ends[1]), "the second end")) {
    return "across: " + *problem;
  }
  if (!is_length(cuff.length) || cuff.length.lower == 0) {
    return "length: " + to_string(cuff.length) + " is not 0 < lo <= hi";
  }
  const bool finite = std::isfinite(cuff.twist.lower) && std::isfinite(cuff.twist.upper);
  if (!finite || cuff.twist.lower > cuff.twist.upper) return "twist: " + to_string(cuff.twist) + " is not lo <= hi";
  if (cuff.exp_half_length != 0 && cuff.exp_half_length <= 1) {
    return "exp_half_length: " + cuff.exp_half_length.get_str() + ", expected 0 or more than 1";
  }
  return std::nullopt;
}

}  // namespace

Problem structure_problem(const PantsDocument& document) {
  if (auto problem = whole_net_problem(document.net)) return problem;
  const SurfaceSides sides(document.net.surface);
  if (auto problem = first_row_problem(
          "pants", document.pants, [&](const PantsDocument::Paths& paths) { return paths_problem(sides, paths); })) {
    return problem;
  }
  if (2 * document.cuffs.size() != 3 * document.pants.size()) {
    return "cuffs: " + std::to_string(document.cuffs.size()) + " rows for " + std::to_string(document.pants.size()) +
           " pairs of pants, expected three for two";
  }
  std::vector<bool> seen(3 * document.pants.size());
  return first_row_problem("cuffs", document.cuffs,
                           [&](const PantsDocument::Cuff& cuff) { return cuff_problem(document, sides, cuff, seen); });
}

std::uint64_t least_bytes(const PantsDocument& document) {
  std::uint64_t bytes = least_bytes(document.net);
  for (const auto& [first, second] : document.pants) bytes += 6 + least_bytes(first) + least_bytes(second);
  for (const PantsDocument::Cuff& cuff : document.cuffs) {
    bytes += 90 + least_bytes(cuff.across) + least_bytes(RationalPoint{cuff.exp_half_length, 0});
  }
  return bytes;
}

namespace {

using Word = PantsDocument::Word;
using End = PantsDocument::End;

constexpr const char* kPants = "pants";
constexpr const char* kGlued = "glued";
constexpr const char* kLengths = "lengths";
constexpr const char* kTwists = "twists";

constexpr slong kFirstBitsOfPaths = 128;

/// The three elements of a pair of pants, with positive traces where balls tell; the first two and their product.
struct Elements {
  std::array<BallIsometry, 3> cuffs;
  BallIsometry product;
};

/// The normal of the axis of an element with Re a > 0, positive on its left; its square is sinh²(l/2).
BallVector axis_normal(const BallIsometry& f) { return {-imaginary(f.b), real(f.b), imaginary(f.a)}; }

Ball product(const BallVector& u, const BallVector& v) { return lorentz_product(u, v, Precision::bits()); }

Ball determinant(const BallVector& u, const BallVector& v, const BallVector& w) {
  Ball result;
  dot(result, cross_product(u, v, Precision::bits()), w, Precision::bits());
  return result;
}

/// Whether these are elements of a pair of pants on their left (Lemma 42). If so, signs are as they should be.
Tri are_of_pants(const Elements& elements) {
  const Ball one = Ball::exactly(1);
  const BallIsometry& first = elements.cuffs[0];
  const BallIsometry& second = elements.cuffs[1];
  // A ball on both sides of 0 may have the wrong sign, and then says nothing.
  if (certain_sign(real(first.a)) != 1 || certain_sign(real(second.a)) != 1) return Tri::unknown;
  // The first two follow from the third: elements of the group are hyperbolic or 1.
  const Tri traces = both(both(certainly_less(one, real(first.a)), certainly_less(one, real(second.a))),
                          certainly_less(real(elements.product.a), -one));
  const BallVector n = axis_normal(first);
  const BallVector m = axis_normal(second);
  // A multiple of the point of the second axis that is nearest to the first one.
  const Ball nearest = product(n, m) * m[2] - product(m, m) * n[2];
  return both(traces, certainly_positive(nearest));
}

/// lo < x < hi.
Tri is_inside(const Ball& x, Interval interval) {
  return both(certainly_less(Ball::exactly(interval.lower), x), certainly_less(x, Ball::exactly(interval.upper)));
}

/// Whether x, or a number that differs from it by a multiple of the period, is in the interval.
Tri is_inside_modulo(const Ball& x, const Ball& period, Interval interval) {
  const Ball width = Ball::exactly(interval.upper) - Ball::exactly(interval.lower);
  if (certainly_less(period, width) == Tri::yes) return Tri::yes;
  const Ball middle = half(Ball::exactly(interval.lower) + Ball::exactly(interval.upper));
  const Ball periods = (middle - x) / period;
  if (!is_finite(periods)) return Tri::unknown;
  // The one that is nearest to the middle, or hardly farther from it than another one: if that is outside and the
  // neighbours on both sides as well, all are.
  const double nearest = std::nearbyint(lower_end(periods));
  if (!(std::abs(nearest) < 0x1p53)) return Tri::unknown;
  Tri result = Tri::no;
  for (const double count : {nearest - 1, nearest, nearest + 1}) {
    result = either(result, is_inside(x + Ball::exactly(count) * period, interval));
  }
  if (result != Tri::no) return result;
  // No number lies between neighbours, and these are on different sides of the interval.
  const Tri below = certainly_less(x + Ball::exactly(nearest - 1) * period, Ball::exactly(interval.lower));
  const Tri above = certainly_less(Ball::exactly(interval.upper), x + Ball::exactly(nearest + 1) * period);
  return both(below, above) == Tri::yes ? Tri::no : Tri::unknown;
}

/// Evaluates paths: [w] of section 19.
class Paths {
 public:
  Paths(const Crossings& crossings, const Budget& budget) : crossings_(crossings), budget_(budget) {}

  [[nodiscard]] BallIsometry balls(const Word& word, slong precision) const {
    if (word.empty()) return identity_isometry();
    const auto bits = static_cast<std::uint64_t>(precision);
    return std::visit(
        [&](const auto& kind) {
          for (const std::uint32_t s : word) budget_.spend(kind.ball_work(s, bits) + 8 * ball_work(bits));
          return inverse(compose_range(
              0, word.size(), [&](std::size_t i) { return kind.balls(word[i], precision); },
              [&](const BallIsometry& f, const BallIsometry& g) { return compose(f, g, precision); }));
        },
        crossings_);
  }

  /// Whether a path is null-homotopic: only 1 leaves the centre of a tile, or any other point, where it is. Nothing, if
  /// its numbers are too large.
  [[nodiscard]] std::optional<bool> is_trivial(const Word& word) const {
    return exactly(word, [](const auto& f) { return sign(norm(f.b)) == 0; });
  }

  /// Whether e^{l/2} = R for the length l of the element of a path: tr²/det = (R + 1/R)².
  [[nodiscard]] std::optional<bool> has_root(const Word& word, const mpq_class& root) const {
    budget_.spend(20 * product_work(mpz_sizeinbase(root.get_num_mpz_t(), 2)));
    const mpz_class& n = root.get_num();
    const mpz_class& d = root.get_den();
    const mpz_class product = n * d;
    const mpz_class sum = n * n + d * d;
    return exactly(word, [&](const auto& f) {
      const auto trace = twice_real(f.a);
      const mpz_class product_squared = product * product;
      const mpz_class sum_squared = sum * sum;
      return sign(product_squared * (trace * trace) - sum_squared * (norm(f.a) - norm(f.b))) == 0;
    });
  }

 private:
  template <class Question>
  std::optional<bool> exactly(const Word& word, const Question& question) const {
    return std::visit(
        [&](const auto& kind) -> std::optional<bool> {
          using Kind = std::decay_t<decltype(kind)>;
          if (word.empty()) return std::nullopt;
          budget_.spend(kind.letter_work(), word.size());
          const std::size_t bits = kind.product_bits(0, word);
          if (bits > Kind::kMaxExactBits) return std::nullopt;
          budget_.spend(Kind::exact_work(bits));
          if constexpr (std::is_same_v<Kind, RegularCrossings>) {
            // Numbers of the ring take off their own work, which for small coefficients is mostly that of moving them.
            budget_.spend(
                std::uint64_t{20} * kind.ring().order() * static_cast<std::uint64_t>(std::bit_width(word.size())),
                word.size());
          }
          return question(kind.exact(word));
        },
        crossings_);
  }

  const Crossings& crossings_;
  const Budget& budget_;
};

class PantsCheck {
 public:
  PantsCheck(const PantsDocument& document, Verification& run, const Crossings& crossings)
      : document_(document),
        run_(run),
        sides_(document.net.surface),
        paths_(crossings, run.budget()),
        rules_(own_rules(document)) {}

  void ask() {
    try {
      run_.progress(kPants);
      count_pants();
      if (rules_.verdict(kPants) != Verdict::refuted) {
        check_glued();
        if (rules_.verdict(kGlued) == Verdict::verified) check_roots();
        with_rising_precision(
            run_.options().max_precision,
            [&](slong precision) {
              run_.used(static_cast<std::uint64_t>(precision));
              pass(precision);
              return is_decided();
            },
            kFirstBitsOfPaths);
      }
    } catch (const BudgetSpent& spent) {
      rules_.give_up(spent.what());
    }
    rules_.conclude(run_);
  }

 private:
  [[nodiscard]] Word backwards(const Word& word) const {
    Word result(word.rbegin(), word.rend());
    for (std::uint32_t& side : result) side = sides_.partner[side];
    return result;
  }

  static void append(Word& word, const Word& then) { word.insert(word.end(), then.begin(), then.end()); }

  /// The path of a cuff.
  [[nodiscard]] Word path(const End& end) const {
    const auto& [p, k] = end;
    if (k < 2) return document_.pants[p][k];
    Word both = document_.pants[p][0];
    append(both, document_.pants[p][1]);
    return backwards(both);
  }

  // Rule pants.

  void count_pants() {
    const std::uint64_t expected = 2 * run_.certificate().counts.genus - 2;
    if (document_.pants.size() == expected) return;
    rules_.report(
        {kPants, Verdict::refuted,
         counted(document_.pants.size(), "pair", "pairs") + " of pants, expected " + std::to_string(expected)});
  }

  [[nodiscard]] std::vector<Elements> elements(slong precision) const {
    std::vector<Elements> result;
    for (const PantsDocument::Paths& paths : document_.pants) {
      BallIsometry first = paths_.balls(paths[0], precision);
      BallIsometry second = paths_.balls(paths[1], precision);
      choose_sign(first);
      choose_sign(second);
      BallIsometry product = compose(first, second, precision);
      BallIsometry third = inverse(product);
      choose_sign(third);
      result.push_back({{std::move(first), std::move(second), std::move(third)}, std::move(product)});
    }
    return result;
  }

  // Rule glued.

  void check_glued() {
    for (std::size_t e = 0; e < document_.cuffs.size(); ++e) {
      const PantsDocument::Cuff& cuff = document_.cuffs[e];
      Word around = path(cuff.ends[0]);
      append(around, cuff.across);
      append(around, path(cuff.ends[1]));
      append(around, backwards(cuff.across));
      const auto trivial = paths_.is_trivial(around);
      if (trivial && *trivial) continue;
      rules_.report({kGlued, trivial ? Verdict::refuted : Verdict::undecided,
                     cuff_name(e) + (trivial ? " is not the same closed geodesic from both sides, by the path across"
                                             : ": the numbers of its words are too large to be compared exactly")});
      return;
    }
    rules_.report({kGlued, Verdict::verified,
                   counted(document_.cuffs.size(), "cuff is", "cuffs are") +
                       " the same closed geodesic from both sides, exactly"});
  }

  // Rule lengths, what is exact.

  void check_roots() {
    for (std::size_t e = 0; e < document_.cuffs.size(); ++e) {
      const PantsDocument::Cuff& cuff = document_.cuffs[e];
      if (cuff.exp_half_length == 0) continue;
      const auto equal = paths_.has_root(path(cuff.ends[0]), cuff.exp_half_length);
      if (!equal) {
        rules_.doubt(kLengths, cuff_name(e) + ": the numbers of its word are too large for its exact length");
        roots_undecided_ = true;
      } else if (!*equal) {
        rules_.report({kLengths, Verdict::refuted, cuff_name(e) + " is not as long as its exp_half_length says"});
        return;
      }
    }
  }

  // With balls.

  void pass(slong precision) {
    const auto work = static_cast<std::uint64_t>(precision);
    run_.budget().spend(200 * ball_work(work) + 2 * function_work(work),
                        document_.pants.size() + document_.cuffs.size());
    const std::vector<Elements> elements = this->elements(precision);
    const std::string bits = std::to_string(precision) + " bits";
    decide(
        kPants, elements.size(), bits, [&](std::size_t p) { return are_of_pants(elements[p]); },
        [&](std::size_t p) {
          return "pair of pants " + std::to_string(p) + ": the paths are not those of cuffs on whose left it is";
        });
    const bool certain = std::all_of(elements.begin(), elements.end(),
                                     [](const Elements& one) { return are_of_pants(one) == Tri::yes; });
    if (!certain || rules_.verdict(kPants) != Verdict::verified || rules_.verdict(kGlued) != Verdict::verified) return;
    if (!roots_undecided_) {
      decide(
          kLengths, document_.cuffs.size(), bits,
          [&](std::size_t e) { return is_inside(length_of(elements, e), document_.cuffs[e].length); },
          [&](std::size_t e) {
            return cuff_name(e) + " has a length in " + to_string(outer_interval(length_of(elements, e))) +
                   ", not in " + to_string(document_.cuffs[e].length);
          });
    }
    if (rules_.verdict(kLengths) == Verdict::refuted) return;
    decide(
        kTwists, document_.cuffs.size(), bits,
        [&](std::size_t e) {
          return is_inside_modulo(twist_of(elements, e, precision), length_of(elements, e), document_.cuffs[e].twist);
        },
        [&](std::size_t e) {
          return cuff_name(e) + " has a twist in " + to_string(outer_interval(twist_of(elements, e, precision))) +
                 ", modulo the length not in " + to_string(document_.cuffs[e].twist);
        });
  }

  /// Asks a rule of all its rows, if it is open: `holds` of row i gives an answer, `wrong` says what is wrong with it.
  template <class Holds, class Wrong>
  void decide(const char* rule, std::size_t rows, const std::string& bits, const Holds& holds, const Wrong& wrong) {
    if (!rules_.open(rule)) return;
    std::optional<std::size_t> open;
    for (std::size_t i = 0; i < rows; ++i) {
      const Tri answer = holds(i);
      if (answer == Tri::no) return rules_.report({rule, Verdict::refuted, wrong(i)});
      if (answer == Tri::unknown && !open) open = i;
    }
    if (open) return rules_.doubt(rule, "row " + std::to_string(*open) + " is not decided with " + bits);
    rules_.report({rule, Verdict::verified, verified_text(rule)});
  }

  [[nodiscard]] std::string verified_text(std::string_view rule) const {
    if (rule == kPants) return counted(document_.pants.size(), "pair", "pairs") + " of pants";
    const std::string cuffs = counted(document_.cuffs.size(), "cuff", "cuffs");
    if (rule == kTwists) return cuffs + " with twists in their intervals, modulo the lengths";
    const auto exact = std::count_if(document_.cuffs.begin(), document_.cuffs.end(),
                                     [](const PantsDocument::Cuff& cuff) { return cuff.exp_half_length != 0; });
    return cuffs + " with lengths in their intervals, " + std::to_string(exact) + " of them exactly known";
  }

  /// Whether more bits can change nothing.
  [[nodiscard]] bool is_decided() const {
    if (rules_.verdict(kPants) == Verdict::refuted || rules_.verdict(kTwists) == Verdict::refuted) return true;
    if (rules_.verdict(kPants) == Verdict::verified && rules_.verdict(kGlued) != Verdict::verified) return true;
    if (rules_.verdict(kPants) == Verdict::verified && rules_.verdict(kLengths) == Verdict::refuted) return true;
    return !rules_.open(kPants) && (!rules_.open(kLengths) || roots_undecided_) && !rules_.open(kTwists);
  }

  [[nodiscard]] Ball length_of(const std::vector<Elements>& elements, std::size_t e) const {
    const auto& [p, k] = document_.cuffs[e].ends[0];
    const BallVector n = axis_normal(elements[p].cuffs[k]);
    return twice(asinh(sqrt(product(n, n))));
  }

  /// Lemma 44.
  [[nodiscard]] Ball twist_of(const std::vector<Elements>& elements, std::size_t e, slong precision) const {
    const PantsDocument::Cuff& cuff = document_.cuffs[e];
    const auto& [p, k] = cuff.ends[0];
    const auto& [q, l] = cuff.ends[1];
    const BallIsometry h = paths_.balls(cuff.across, precision);
    const BallIsometry other = compose(compose(h, elements[q].cuffs[(l + 1) % 3], precision), inverse(h), precision);
    const BallVector n = axis_normal(elements[p].cuffs[k]);
    const BallVector u = axis_normal(elements[p].cuffs[(k + 1) % 3]);
    const BallVector v = axis_normal(other);
    const Ball nn = product(n, n);
    const auto squared = [&](const BallVector& w) { return sqr(product(w, n)) / nn - product(w, w); };
    return asinh(determinant(n, u, v) * rsqrt(nn * squared(u) * squared(v)));
  }

  [[nodiscard]] static std::string cuff_name(std::size_t e) { return "cuff " + std::to_string(e); }

  const PantsDocument& document_;
  Verification& run_;
  SurfaceSides sides_;
  Paths paths_;
  OpenRules rules_;
  bool roots_undecided_ = false;
};

}  // namespace

RuleNames own_rules(const PantsDocument& /*document*/) { return {kPants, kGlued, kLengths, kTwists}; }

Claim claim_of(const PantsDocument& document) {
  const auto ask = [&](Verification& run, const Crossings& crossings) { PantsCheck(document, run, crossings).ask(); };
  return {document.net,
          "the surface is cut into " + counted(document.pants.size(), "pair", "pairs") + " of pants by " +
              counted(document.cuffs.size(), "simple closed geodesic", "simple closed geodesics") +
              ", whose lengths and twists are in their intervals",
          own_rules(document), ask};
}

}  // namespace epsnet::certify
