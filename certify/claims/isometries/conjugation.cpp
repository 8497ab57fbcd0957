#include "certify/claims/isometries/conjugation.h"

#include <array>
#include <numeric>
#include <set>
#include <type_traits>
#include <utility>

namespace epsnet::certify {
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

/// Whether two traces agree up to their sign, and whether they have the same one: `any` if both are 0.
enum class Ratio { different, same, opposite, any };

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

/// Of two elements, scaled to determinant 1.
template <class Real>
Ratio trace_ratio(const ScaledTrace<Real>& f, const ScaledTrace<Real>& g) {
  const Real difference(f.trace * f.trace * g.determinant - g.trace * g.trace * f.determinant);
  if (sign(difference) != 0) return Ratio::different;
  const int product = sign(f.trace) * sign(g.trace);
  return product == 0 ? Ratio::any : (product > 0 ? Ratio::same : Ratio::opposite);
}

}  // namespace

std::optional<bool> are_conjugate(const Crossings& crossings, std::span<const ElementPair> pairs,
                                  const Budget& budget) {
  return std::visit(
      [&](const auto& kind) -> std::optional<bool> {
        const Evaluator evaluator(kind, budget);
        for (const ElementPair& pair : pairs) {
          if (!evaluator.feasible(pair.from) || !evaluator.feasible(pair.to)) return std::nullopt;
        }
        const auto from = evaluator.basis(pairs[0].from, pairs[1].from);
        const auto to = evaluator.basis(pairs[0].to, pairs[1].to);
        using Element = std::decay_t<decltype(from[0])>;
        std::array<RealOf<Element>, 4> from_determinant;
        std::array<RealOf<Element>, 4> to_determinant;
        for (std::size_t i = 0; i < 4; ++i) {
          from_determinant[i] = determinant_of(from[i]);
          to_determinant[i] = determinant_of(to[i]);
        }
        for (std::size_t i = 1; i < 4; ++i) {
          const Ratio ratio = trace_ratio<RealOf<Element>>({twice_real(from[i].a), from_determinant[i]},
                                                           {twice_real(to[i].a), to_determinant[i]});
          if (ratio == Ratio::different || ratio == Ratio::opposite) return false;
        }
        for (const ElementPair& pair : pairs.subspan(2)) {
          const auto f = evaluator.element(pair.from);
          const auto g = evaluator.element(pair.to);
          const auto f_determinant = determinant_of(f);
          const auto g_determinant = determinant_of(g);
          Ratio sign = Ratio::any;
          for (std::size_t i = 0; i < 4; ++i) {
            const Ratio ratio = trace_ratio(trace_of_product(from[i], from_determinant[i], f, f_determinant),
                                            trace_of_product(to[i], to_determinant[i], g, g_determinant));
            if (ratio == Ratio::different) return false;
            if (ratio == Ratio::any) continue;
            if (sign != Ratio::any && ratio != sign) return false;
            sign = ratio;
          }
        }
        return true;
      },
      crossings);
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
