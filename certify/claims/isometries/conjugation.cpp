#include "certify/claims/isometries/conjugation.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <set>
#include <type_traits>
#include <utility>

#include "certify/base/text.h"
#include "certify/numbers/two_rings.h"

namespace epsnet::certify {

Problem paths_problem(const SurfaceSides& sides, const std::vector<SideWord>& paths) {
  if (paths.size() != sides.first.size()) {
    return "paths: " + std::to_string(paths.size()) + " words, expected one for each tile, " +
           std::to_string(sides.first.size());
  }
  for (std::uint32_t t = 0; t < paths.size(); ++t) {
    if (const auto problem = word_problem(sides, paths[t], 0, t, "this row")) return at("paths", t) + *problem;
  }
  return std::nullopt;
}

Problem loops_problem(const SurfaceSides& sides, const std::vector<SideWord>& words, std::size_t count) {
  if (words.size() != count) {
    return std::to_string(words.size()) + " words, expected " + std::to_string(count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto problem = word_problem(sides, words[i], 0, 0, "its start")) {
      return "word " + std::to_string(i) + ": " + *problem;
    }
  }
  return std::nullopt;
}

std::vector<SideWord> generator_words(const SurfaceSides& sides, const std::vector<SideWord>& paths,
                                      const Budget& budget) {
  std::vector<SideWord> result;
  for (std::uint32_t s = 0; s < sides.partner.size(); ++s) {
    if (s > sides.partner[s]) continue;
    const SideWord& back = paths[sides.tile[sides.partner[s]]];
    // Callers may copy them once.
    budget.spend(memory_work(2 * sizeof(std::uint32_t)), paths[sides.tile[s]].size() + 1 + back.size());
    SideWord& word = result.emplace_back(paths[sides.tile[s]]);
    word.push_back(s);
    std::transform(back.rbegin(), back.rend(), std::back_inserter(word), [&](auto t) { return sides.partner[t]; });
  }
  return result;
}

namespace {

using Letters = std::span<const std::uint32_t>;

/// Evaluates words exactly, of the crossings of one kind.
template <class CrossingsOfAKind>
class Evaluator {
 public:
  using Element = Isometry<typename CrossingsOfAKind::Number>;

  Evaluator(const CrossingsOfAKind& crossings, const Budget& budget) : crossings_(crossings), budget_(budget) {}

  /// Whether products of four such elements are not too large.
  [[nodiscard]] bool feasible(Letters word) const {
    return crossings_.product_bits(0, word) <= CrossingsOfAKind::kMaxExactBits / 8;
  }

  /// With a trace that is not negative.
  [[nodiscard]] Element element(Letters word) const {
    budget_.spend(crossings_.letter_work(), word.size());
    budget_.spend(CrossingsOfAKind::exact_work(crossings_.product_bits(0, word)), 16);
    Element f = crossings_.exact(word);
    if (sign(twice_real(f.a)) >= 0) return f;
    const mpz_class minus(-1);
    return {minus * f.a, minus * f.b};
  }

  /// 1, x, y and xy: a basis of the matrices.
  [[nodiscard]] std::array<Element, 4> basis(Letters x_word, Letters y_word) const {
    const Element x = element(x_word);
    const Element y = element(y_word);
    return {crossings_.embed(exact_identity()), x, y, compose(x, y)};
  }

 private:
  const CrossingsOfAKind& crossings_;
  const Budget& budget_;
};

/// Whether two traces, which are not 0, agree up to their sign, and whether they have the same one.
enum class Ratio { different, same, opposite };

template <class Element>
using RealOf = std::decay_t<decltype(norm(Element().a))>;

/// The trace of an element, with its determinant.
template <class Real>
struct ScaledTrace {
  Real trace;
  Real determinant;
};

template <class Element>
RealOf<Element> determinant_of(const Element& f) {
  return norm(f.a) - norm(f.b);
}

/// Of f ∘ g, from the determinants of f and g.
template <class Element>
ScaledTrace<RealOf<Element>> trace_of_product(const Element& f, const RealOf<Element>& f_determinant, const Element& g,
                                              const RealOf<Element>& g_determinant) {
  return {twice_real(f.a * g.a + f.b * conjugate(g.b)), RealOf<Element>(f_determinant * g_determinant)};
}

/// Of two elements, scaled to determinant 1: of one ring, or of two; nothing if that takes too many bits.
template <class Real, class OtherReal>
std::optional<Ratio> trace_ratio(const ScaledTrace<Real>& f, const ScaledTrace<OtherReal>& g, bool one_ring,
                                 const Budget& budget) {
  const Real square(f.trace * f.trace);
  const OtherReal other_square(g.trace * g.trace);
  std::optional<bool> agree;
  if constexpr (std::is_same_v<Real, OtherReal>) {
    if (one_ring) agree = sign(Real(square * g.determinant - other_square * f.determinant)) == 0;
  }
  if (!one_ring) {
    agree = products_agree(ProductPair<Real, OtherReal>{square, g.determinant, f.determinant, other_square}, budget);
  }
  if (!agree) return std::nullopt;
  if (!*agree) return Ratio::different;
  return sign(f.trace) == sign(g.trace) ? Ratio::same : Ratio::opposite;
}

/// A basis of the matrices with its determinants.
template <class CrossingsOfAKind>
struct Basis {
  Basis(const Evaluator<CrossingsOfAKind>& evaluator, Letters x, Letters y) : elements(evaluator.basis(x, y)) {
    std::transform(elements.begin(), elements.end(), determinants.begin(),
                   [](const auto& f) { return determinant_of(f); });
  }

  using Element = typename Evaluator<CrossingsOfAKind>::Element;
  std::array<Element, 4> elements;
  std::array<RealOf<Element>, 4> determinants;
};

/// The traces of an element with a basis.
template <class CrossingsOfAKind>
auto traces_with(const Basis<CrossingsOfAKind>& basis, const typename Basis<CrossingsOfAKind>::Element& f) {
  std::array<ScaledTrace<RealOf<typename Basis<CrossingsOfAKind>::Element>>, 4> result;
  const auto determinant = determinant_of(f);
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = trace_of_product(basis.elements[i], basis.determinants[i], f, determinant);
  }
  return result;
}

/// As are_conjugate, of crossings of two kinds, which are those of one ring or not.
template <class From, class To>
std::optional<bool> are_conjugate_of(const From& from_crossings, const To& to_crossings, bool one_ring,
                                     std::span<const ElementPair> pairs, const Budget& budget) {
  const Evaluator from_evaluator(from_crossings, budget);
  const Evaluator to_evaluator(to_crossings, budget);
  for (const ElementPair& pair : pairs) {
    if (!from_evaluator.feasible(pair.from) || !to_evaluator.feasible(pair.to)) return std::nullopt;
  }
  const Basis<From> from(from_evaluator, pairs[0].from, pairs[1].from);
  const Basis<To> to(to_evaluator, pairs[0].to, pairs[1].to);
  for (std::size_t i = 1; i < 4; ++i) {
    const auto trace = [i](const auto& basis) {
      return ScaledTrace<RealOf<std::decay_t<decltype(basis.elements[0])>>>{twice_real(basis.elements[i].a),
                                                                            basis.determinants[i]};
    };
    const auto ratio = trace_ratio(trace(from), trace(to), one_ring, budget);
    if (!ratio) return std::nullopt;
    if (*ratio != Ratio::same) return false;
  }
  for (const ElementPair& pair : pairs.subspan(2)) {
    const auto from_traces = traces_with(from, from_evaluator.element(pair.from));
    const auto to_traces = traces_with(to, to_evaluator.element(pair.to));
    std::optional<Ratio> first;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto ratio = trace_ratio(from_traces[i], to_traces[i], one_ring, budget);
      if (!ratio) return std::nullopt;
      if (!first) first = ratio;
      if (*ratio == Ratio::different || *ratio != *first) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<bool> are_conjugate(const Crossings& crossings, std::span<const ElementPair> pairs,
                                  const Budget& budget) {
  return std::visit([&](const auto& kind) { return are_conjugate_of(kind, kind, true, pairs, budget); }, crossings);
}

std::optional<bool> are_conjugate(const Crossings& from, const Crossings& to, std::span<const ElementPair> pairs,
                                  const Budget& budget) {
  return std::visit(
      [&](const auto& kind, const auto& other) { return are_conjugate_of(kind, other, false, pairs, budget); }, from,
      to);
}

std::optional<int> crossing_sign(const Crossings& crossings, Letters word, Letters other, const Budget& budget) {
  return std::visit(
      [&](const auto& kind) -> std::optional<int> {
        const Evaluator evaluator(kind, budget);
        if (!evaluator.feasible(word) || !evaluator.feasible(other)) return std::nullopt;
        const auto x = evaluator.element(word);
        const auto y = evaluator.element(other);
        // xy − yx turns around the point where the axes cross: it has a positive determinant only if they do.
        const auto f = compose(x, y);
        const auto g = compose(y, x);
        const auto a = f.a - g.a;
        if (sign(norm(a) - norm(f.b - g.b)) <= 0) return 0;
        return sign(twice_imaginary(a));
      },
      crossings);
}

namespace {

/// Of a function of words, by generator; modulo 2³².
using Values = std::vector<std::uint32_t>;

}  // namespace

Problem isometries_problem(const SurfaceSides& sides, const IsometryRows& rows) {
  if (auto problem = paths_problem(sides, rows.paths)) return problem;
  if (const auto problem = loops_problem(sides, rows.pair, 2)) return "pair: " + *problem;
  const std::size_t images = 2 + sides.partner.size() / 2;
  return first_row_problem("isometries", rows.isometries, [&](const IsometryRows::Isometry& isometry) {
    return loops_problem(sides, isometry.images, images);
  });
}

std::uint64_t least_bytes(const IsometryRows& rows) {
  std::uint64_t bytes = 0;
  const auto add = [&](const std::vector<SideWord>& words) {
    for (const SideWord& word : words) bytes += 3 + least_bytes(word);
  };
  add(rows.paths);
  add(rows.pair);
  for (const IsometryRows::Isometry& isometry : rows.isometries) add(isometry.images);
  return bytes;
}

RuleReport isometries_report(const Crossings& crossings, const SurfaceSides& sides, const IsometryRows& rows,
                             const Budget& budget) {
  constexpr const char* kRule = "isometries";
  const auto sign = crossing_sign(crossings, rows.pair[0], rows.pair[1], budget);
  if (!sign) return {kRule, Verdict::undecided, "the numbers of the pair are too large"};
  if (sign == 0) return {kRule, Verdict::refuted, "the axes of the pair do not cross"};
  std::vector<SideWord> generators = rows.pair;
  for (SideWord& word : generator_words(sides, rows.paths, budget)) generators.push_back(std::move(word));
  for (std::size_t i = 0; i < rows.isometries.size(); ++i) {
    const auto& [preserves_orientation, images] = rows.isometries[i];
    std::vector<ElementPair> pairs;
    for (std::size_t k = 0; k < images.size(); ++k) pairs.push_back({generators[k], images[k]});
    const auto conjugate = are_conjugate(crossings, pairs, budget);
    const auto image_sign = crossing_sign(crossings, images[0], images[1], budget);
    const std::string name = "isometry " + std::to_string(i);
    if (!conjugate || !image_sign) {
      return {kRule, Verdict::undecided, name + ": its numbers are too large to be compared exactly"};
    }
    if (!*conjugate) return {kRule, Verdict::refuted, name + " is none: traces differ"};
    if ((*image_sign == *sign) != preserves_orientation) {
      return {kRule, Verdict::refuted,
              name + (preserves_orientation ? " reverses the orientation" : " preserves the orientation")};
    }
  }
  return {kRule, Verdict::verified, counted(rows.isometries.size(), "isometry", "isometries") + ", exactly"};
}

std::vector<std::uint32_t> cocycle_by_side(const SurfaceSides& sides, const std::vector<std::uint32_t>& values) {
  std::vector<std::uint32_t> result(sides.partner.size());
  auto value = values.begin();
  for (std::uint32_t s = 0; s < result.size(); ++s) {
    const std::uint32_t partner = sides.partner[s];
    result[s] = s < partner ? *value++ : 0 - result[partner];
  }
  return result;
}

std::uint64_t orbit_size(const SurfaceSides& sides, const IsometriesDocument& document, const Budget& budget) {
  std::uint64_t letters = document.cocycle.size();
  for (const auto& isometry : document.isometries) {
    for (const auto& word : isometry.images) letters += word.size() + 1;
  }
  const auto sum = [](const Values& by_side, const IsometriesDocument::Word& word) {
    return std::accumulate(word.begin(), word.end(), std::uint32_t{0},
                           [&](std::uint32_t value, std::uint32_t s) { return value + by_side[s]; });
  };
  // Of g_s, of which the path is closed.
  Values first;
  const Values by_side = cocycle_by_side(sides, document.cocycle);
  for (std::uint32_t s = 0; s < by_side.size(); ++s) {
    if (s > sides.partner[s]) continue;
    first.push_back(sum(by_side, document.paths[sides.tile[s]]) + by_side[s] -
                    sum(by_side, document.paths[sides.tile[sides.partner[s]]]));
  }
  std::set<Values> known{first};
  std::vector<const Values*> reached{&*known.begin()};
  for (std::size_t i = 0; i < reached.size() && known.size() <= document.order; ++i) {
    budget.spend(5, letters);
    const Values here = cocycle_by_side(sides, *reached[i]);
    for (const auto& isometry : document.isometries) {
      Values moved;
      for (auto word = isometry.images.begin() + 2; word != isometry.images.end(); ++word) {
        moved.push_back(sum(here, *word));
      }
      budget.spend(memory_work(4 * moved.size() + 64));
      const auto [place, is_new] = known.insert(std::move(moved));
      if (is_new) reached.push_back(&*place);
    }
  }
  return known.size();
}

}  // namespace epsnet::certify
