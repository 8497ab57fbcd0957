#include "certify/claims/geodesics/exact_traces.h"

#include <algorithm>

namespace epsnet::certify {
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

}  // namespace epsnet::certify
