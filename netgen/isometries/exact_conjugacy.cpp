#include "netgen/isometries/exact_conjugacy.h"

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

#include "certify/net/crossings.h"
#include "netgen/base/gmp.h"

namespace epsnet {
namespace {

certify::Gaussian to_gaussian(const Complex<Rational>& z) {
  // Integers, as crossings are.
  return {to_gmp(z.x).get_num(), to_gmp(z.y).get_num()};
}

/// The crossings of both surfaces, those of the second one after those of the first, in one ring. Nothing, if there is
/// no such ring here.
std::optional<certify::Crossings> joint_crossings(const Surface& first, const Surface& second) {
  if (first.regular_tile() != second.regular_tile()) return std::nullopt;
  const std::uint32_t count = first.side_count();
  if (const auto& tile = first.regular_tile()) {
    std::vector<std::uint32_t> partner;
    for (std::uint32_t s = 0; s < count; ++s) partner.push_back(first.partner(s));
    for (std::uint32_t s = 0; s < second.side_count(); ++s) partner.push_back(count + second.partner(s));
    return certify::RegularCrossings({tile->p, tile->q}, std::move(partner));
  }
  std::vector<certify::ExactIsometry> crossings;
  for (const Surface* surface : {&first, &second}) {
    for (std::uint32_t s = 0; s < surface->side_count(); ++s) {
      const Isometry<Rational>& f = surface->crossing(s);
      crossings.push_back({to_gaussian(f.a), to_gaussian(f.b)});
    }
  }
  return certify::RationalCrossings(std::move(crossings));
}

/// Whether two numbers agree up to their sign, and whether they have the same one: `any` if both are 0.
enum class Ratio { different, same, opposite, any };

/// The ratio of the traces of two elements, scaled to determinant 1.

template <class Element>
Ratio trace_ratio(const Element& f, const Element& g) {
  using Real = std::decay_t<decltype(certify::norm(f.a))>;
  const Real t = certify::twice_real(f.a);
  const Real u = certify::twice_real(g.a);
  const Real f_determinant = certify::norm(f.a) - certify::norm(f.b);
  const Real g_determinant = certify::norm(g.a) - certify::norm(g.b);
  const Real difference = t * t * g_determinant - u * u * f_determinant;
  if (certify::sign(difference) != 0) return Ratio::different;
  const int product = certify::sign(t) * certify::sign(u);
  return product == 0 ? Ratio::any : (product > 0 ? Ratio::same : Ratio::opposite);
}

template <class Element>
Element with_positive_trace(Element f) {
  if (certify::sign(certify::twice_real(f.a)) >= 0) return f;
  const mpz_class minus(-1);
  return {minus * f.a, minus * f.b};
}

template <class CrossingsOfAKind>
std::optional<bool> are_conjugate(const CrossingsOfAKind& crossings, std::span<const ElementPair> pairs) {
  for (const ElementPair& pair : pairs) {
    for (const Word* word : {&pair.from, &pair.to}) {
      if (crossings.product_bits(0, *word) > CrossingsOfAKind::kMaxExactBits / 8) return std::nullopt;
    }
  }
  using Element = decltype(crossings.exact(pairs[0].from));
  // 1, x, y and xy of the first two elements x and y: a basis of the matrices.
  const auto basis = [&](const Word& x_word, const Word& y_word) {
    const Element x = with_positive_trace(crossings.exact(x_word));
    const Element y = with_positive_trace(crossings.exact(y_word));
    return std::array<Element, 4>{crossings.embed(certify::exact_identity()), x, y, certify::compose(x, y)};
  };
  const std::array<Element, 4> from = basis(pairs[0].from, pairs[1].from);
  const std::array<Element, 4> to = basis(pairs[0].to, pairs[1].to);
  for (std::size_t i = 1; i < 4; ++i) {
    if (const Ratio ratio = trace_ratio(from[i], to[i]); ratio == Ratio::different || ratio == Ratio::opposite) {
      return false;
    }
  }
  for (const ElementPair& pair : pairs.subspan(2)) {
    const Element f = crossings.exact(pair.from);
    const Element g = crossings.exact(pair.to);
    Ratio sign = Ratio::any;
    for (std::size_t i = 0; i < 4; ++i) {
      const Ratio ratio = trace_ratio(certify::compose(from[i], f), certify::compose(to[i], g));
      if (ratio == Ratio::different) return false;
      if (ratio == Ratio::any) continue;
      if (sign != Ratio::any && ratio != sign) return false;
      sign = ratio;
    }
  }
  return true;
}

}  // namespace

std::optional<bool> are_conjugate(const Surface& first, const Surface& second, std::span<const ElementPair> pairs) {
  const std::optional<certify::Crossings> crossings = joint_crossings(first, second);
  if (!crossings) return std::nullopt;
  std::vector<ElementPair> shifted(pairs.begin(), pairs.end());
  for (ElementPair& pair : shifted) {
    for (std::uint32_t& side : pair.to) side += first.side_count();
  }
  return std::visit([&](const auto& kind) { return are_conjugate(kind, shifted); }, *crossings);
}

}  // namespace epsnet
