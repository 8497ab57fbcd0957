#include "triangulation/surface/word_evaluator.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "triangulation/surface/isometry_size.h"
#include "triangulation/surface/turn.h"

namespace epsnet {
namespace {

/// For every factor an upper bound of log2 of the norm of the product of those that come after it, computed in
/// binary64; nothing if binary64 may be off by more than a factor of 2.
template <class T>
std::optional<std::vector<double>> sizes_from_the_end(const std::vector<Isometry<T>>& factors) {
  std::vector<double> sizes(factors.size());
  Isometry<double> product;
  double error = 0;  // Of the product, as a norm.
  for (std::size_t i = factors.size(); i-- > 0;) {
    const double size = size_of(product);
    if (!(error <= size / 2)) {
      return std::nullopt;
    }
    sizes[i] = 1 + std::log2(size);
    const Isometry<double> factor = convert<double>(factors[i]);
    error = (error + 16 * kUnitRoundoff * size) * 1.001 * size_of(factor);
    product = product * factor;
  }
  return sizes;
}

/// How many crossings of a word, from the i-th on, turn around one vertex.
std::size_t turn_length(const Surface& surface, const Word& word, std::size_t i, Turn turn) {
  std::size_t end = i + 1;
  while (end < word.size() && next_crossing(surface, word[end - 1], turn) == word[end]) ++end;
  return end - i;
}

/// A path that turns around a vertex with as many crossings as this is one factor of a product.
constexpr std::uint32_t kLongTurn = 16;

/// The field in which the crossings around a vertex are multiplied up for products in T.
template <class T>
using TurnField = std::conditional_t<std::is_same_v<T, Mp256>, Mp1024, T>;

}  // namespace

WordEvaluator::WordEvaluator(const Surface& surface) : surface_(surface) {
  crossings_.reserve(surface.side_count());
  for (const SideId s : surface.side_ids()) {
    const SideId partner = surface.partner(s);
    crossings_.push_back(partner < s ? epsnet::inverse(crossings_[partner])
                                     : convert<Mp256>(surface.crossing_as<Mp1024>(s)));
  }
  const auto is_long = [&](SideId corner) { return surface.corners_around(corner) >= 2 * kLongTurn; };
  constexpr std::uint32_t kNoRank = ~std::uint32_t{0};
  for (const SideId corner : surface.side_ids()) {
    if (!is_long(corner)) continue;
    if (rank_in_turn_.empty()) rank_in_turn_.assign(surface.side_count(), kNoRank);
    std::uint32_t rank = 0;
    for (SideId s = corner; rank_in_turn_[s] == kNoRank; s = next_crossing(surface, s, Turn::counterclockwise)) {
      rank_in_turn_[s] = rank++;
    }
  }
}

template <class T>
const Isometry<T>& WordEvaluator::crossing(SideId s) const {
  if constexpr (std::is_same_v<T, Mp256>) {
    return crossings_[s];
  } else {
    auto& known = std::get<Known<T>>(known_).crossings;
    const auto found = known.find(s);
    return found != known.end() ? found->second : known.emplace(s, surface_.crossing_as<T>(s)).first->second;
  }
}

template <class T>
const WordEvaluator::FullTurn<T>& WordEvaluator::full_turn(SideId corner) const {
  auto& known = std::get<Known<T>>(known_).full_turns;
  const std::uint32_t vertex = surface_.vertex_class(corner);
  if (const auto found = known.find(vertex); found != known.end()) {
    return found->second;
  }
  SideId s = corner;
  while (rank_in_turn_[s] != 0) s = next_crossing(surface_, s, Turn::counterclockwise);
  FullTurn<T> result{{Isometry<T>{}}, 0};
  double largest_product = 1;
  double largest_crossing = 1;
  for (std::uint32_t i = 1; i < surface_.corners_around(corner); ++i) {
    const Isometry<T>& next = crossing<T>(s);
    result.products.push_back(next * result.products.back());
    largest_product = std::max(largest_product, log2_norm(result.products.back()));
    largest_crossing = std::max(largest_crossing, log2_norm(next));
    s = next_crossing(surface_, s, Turn::counterclockwise);
  }
  factor_count_ += result.products.size();
  // docs/error-bounds.md, E5.
  result.bits_lost =
      4 * largest_product + largest_crossing + std::log2(static_cast<double>(result.products.size())) + 5;
  return known.emplace(vertex, std::move(result)).first->second;
}

template <class T>
double WordEvaluator::append_factors(const Word& word, std::vector<Isometry<T>>& factors) const {
  double missing = 0;
  const auto product_of_turn = [&](SideId first, std::size_t length) {
    const FullTurn<TurnField<T>>& around = full_turn<TurnField<T>>(first);
    const std::size_t n = around.products.size();
    const std::size_t start = rank_in_turn_[first];
    missing = std::max(missing, around.bits_lost + kMantissaBits<T> - kMantissaBits<TurnField<T>>);
    return convert<T>(around.products[(start + length) % n] * epsnet::inverse(around.products[start]));
  };
  for (std::size_t i = 0; i < word.size();) {
    if (!rank_in_turn_.empty()) {
      const std::size_t forward = turn_length(surface_, word, i, Turn::counterclockwise);
      const std::size_t backward = turn_length(surface_, word, i, Turn::clockwise);
      if (forward >= kLongTurn) {
        factors.push_back(product_of_turn(word[i], forward));
        i += forward;
        continue;
      }
      if (backward >= kLongTurn) {
        // The path backwards turns counterclockwise.
        const SideId last = word[i + backward - 1];
        factors.push_back(epsnet::inverse(product_of_turn(surface_.partner(last), backward)));
        i += backward;
        continue;
      }
    }
    factors.push_back(crossing<T>(word[i]));
    ++i;
  }
  return missing;
}

template <class T>
WordEvaluator::Product<T> WordEvaluator::product(const Charts& charts, ChartId from, ChartId to,
                                                 const Word& word) const {
  // The value is a product M_n … M_0; an error in M_i is magnified by the partial products on its two sides. Factors
  // have determinant 1, the product is not normalised again: |a|² − |b|² has lost its bits where |a| is large.
  std::vector<Isometry<T>> factors{charts.unit_frame<T>(from)};
  const double missing = append_factors<T>(word, factors);
  factors.push_back(epsnet::inverse(charts.unit_frame<T>(to)));
  factor_count_ += factors.size();
  Isometry<T> product = factors.front();
  std::vector<double> before{log2_norm(product)};
  double lost = 2 * before.front();
  for (std::size_t i = 1; i < factors.size(); ++i) {
    before.push_back(log2_norm(product) + log2_norm(factors[i]));
    product = factors[i] * product;
    // A product that has come out too small through cancellation has lost as much as went into it.
    lost = std::max(lost, before.back() + log2_norm(product));
  }
  // From the other end only the sizes of the products are needed, which binary64 sees unless the factors cancel.
  const std::optional<std::vector<double>> seen = sizes_from_the_end(factors);
  Isometry<T> after;
  for (std::size_t i = factors.size(); i-- > 0;) {
    lost = std::max(lost, before[i] + (seen ? (*seen)[i] : log2_norm(after)));
    if (!seen) {
      after = after * factors[i];
    }
  }
  // The factors' own rounding, about 8 operations deep, and their number.
  return {product, lost + missing + 8 + std::log2(static_cast<double>(factors.size()))};
}

template <class T>
std::optional<Evaluated<T>> WordEvaluator::value(double bits, const Charts& charts, ChartId from, ChartId to,
                                                 const Word& word) const {
  const auto rounded = [](const auto& value, double field_bits) {
    return Evaluated<T>{convert<T>(value.isometry), std::min(field_bits - value.bits_lost, kMantissaBits<T> - 4.0)};
  };
  if constexpr (kMantissaBits<T> <= 256) {
    if (const auto value = product<Mp256>(charts, from, to, word); value.bits_lost + bits <= 256) {
      return rounded(value, 256);
    }
  }
  if constexpr (kMantissaBits<T> <= 1024) {
    if (const auto value = product<Mp1024>(charts, from, to, word); value.bits_lost + bits <= 1024) {
      return rounded(value, 1024);
    }
  }
  // Where triangles start so far from Delaunay that their words grow and grow, this is where it ends: the paths of nets
  // have a few dozen sides, or as many as a polygon.
  const std::size_t longest = 500 + surface_.side_count();
  if (word.size() <= longest) {
    if (const auto value = product<Mp4096>(charts, from, to, word); value.bits_lost + bits <= 4096) {
      return rounded(value, 4096);
    }
  }
  return std::nullopt;
}

template std::optional<Evaluated<Mp256>> WordEvaluator::value<Mp256>(double, const Charts&, ChartId, ChartId,
                                                                     const Word&) const;
template std::optional<Evaluated<Mp1024>> WordEvaluator::value<Mp1024>(double, const Charts&, ChartId, ChartId,
                                                                       const Word&) const;
template std::optional<Evaluated<Mp4096>> WordEvaluator::value<Mp4096>(double, const Charts&, ChartId, ChartId,
                                                                       const Word&) const;
template const Isometry<Mp1024>& WordEvaluator::crossing<Mp1024>(SideId) const;

}  // namespace epsnet
