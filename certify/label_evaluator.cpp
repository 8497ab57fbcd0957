#include <epsnet/certify/label_evaluator.h>
#include <epsnet/certify/parallel.h>
#include <epsnet/certify/surface_sides.h>

#include <algorithm>

namespace epsnet::certify {
namespace {

/// The letters of one word times bits that are spent at most: a second or so. Words of a net have a few dozen letters.
constexpr std::size_t kMaxLabelWork = std::size_t{1} << 26;

/// Whether a and b are known to 2^−precision relative to |a| ≥ 1, |b|.
bool accurate(const BallIsometry& f, slong precision) {
  if (!acb_is_finite(f.a.get()) || !acb_is_finite(f.b.get())) return false;
  mag_t largest_error, size, magnitude;
  mag_init(largest_error);
  mag_init(size);
  mag_init(magnitude);
  for (const arb_srcptr part : {f.a.re(), f.a.im(), f.b.re(), f.b.im()}) {
    mag_max(largest_error, largest_error, arb_radref(part));
  }
  acb_get_mag_lower(size, f.a.get());
  mag_mul_2exp_si(magnitude, size, -precision);
  const bool result = mag_cmp(largest_error, magnitude) <= 0;
  mag_clear(largest_error);
  mag_clear(size);
  mag_clear(magnitude);
  return result;
}

}  // namespace

LabelEvaluator::LabelEvaluator(const Document& document, const LabelParts& parts) : document_(document), parts_(parts) {
  exact_bits_.reserve(document.labels.size());
  words_.reserve(document.labels.size());
  partner_ = SurfaceSides(document.surface).partner;
  for (const Label& label : document.labels) {
    std::vector<std::uint32_t> word;
    for (const std::uint32_t side : label.word) append(word, side);
    const std::size_t frame_bits = bits(parts_.frames[label.from]) + bits(parts_.frames[label.to]);
    exact_bits_.push_back(
        std::visit([&](const auto& crossings) { return crossings.product_bits(frame_bits, word); }, parts_.crossings));
    words_.push_back(std::move(word));
  }
}

void LabelEvaluator::append(std::vector<std::uint32_t>& word, std::uint32_t side) const {
  if (!word.empty() && partner_[word.back()] == side) {
    word.pop_back();
  } else {
    word.push_back(side);
  }
}

std::vector<std::uint32_t> LabelEvaluator::word(std::span<const SignedLabel> product) const {
  std::vector<std::uint32_t> result;
  for (auto factor = product.rbegin(); factor != product.rend(); ++factor) {
    const std::span<const std::uint32_t> letters = word(factor->number);
    if (factor->inverted) {
      for (auto side = letters.rbegin(); side != letters.rend(); ++side) append(result, partner_[*side]);
    } else {
      for (const std::uint32_t side : letters) append(result, side);
    }
  }
  return result;
}

std::vector<BallIsometry> LabelEvaluator::evaluate(std::span<const std::uint32_t> numbers, slong precision, slong cap,
                                                   unsigned threads) const {
  std::vector<BallIsometry> results(numbers.size());
  std::vector<char> done(numbers.size(), 0);
  // More bits than the wanted ones from the start: a product of n letters loses about log2(n) bits.
  for (slong working = precision + 32;; working = std::min(2 * working, cap)) {
    // Every crossing and frame in use is rounded once, not once for each letter.
    std::vector<char> side_used(partner_.size(), 0);
    std::vector<char> chart_used(parts_.frames.size(), 0);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (done[i]) continue;
      const Label& label = document_.labels[numbers[i] - 1];
      chart_used[label.from] = chart_used[label.to] = 1;
      for (const std::uint32_t side : words_[numbers[i] - 1]) side_used[side] = 1;
    }
    std::vector<BallIsometry> crossings(side_used.size());
    std::vector<BallIsometry> frames(chart_used.size());
    for_each_parallel(side_used.size(), threads, [&](unsigned, std::size_t s) {
      if (side_used[s]) crossings[s] = ball_crossing(parts_.crossings, static_cast<std::uint32_t>(s), working);
    });
    for_each_parallel(chart_used.size(), threads, [&](unsigned, std::size_t c) {
      if (chart_used[c]) frames[c] = to_balls(parts_.frames[c], working);
    });
    const bool last = working >= cap;
    for_each_parallel(numbers.size(), threads, [&](unsigned, std::size_t i) {
      if (done[i]) return;
      const Label& label = document_.labels[numbers[i] - 1];
      const auto& word = words_[numbers[i] - 1];
      // 96 bits are always spent.
      const auto affordable = static_cast<slong>(std::max<std::size_t>(96, kMaxLabelWork / (word.size() + 1)));
      const slong bits_spent = std::min(working, affordable);
      const auto composed = [&](const BallIsometry& f, const BallIsometry& g) { return compose(f, g, bits_spent); };
      results[i] = frames[label.from];
      if (!word.empty()) {
        const auto crossing = [&](std::size_t k) -> const BallIsometry& { return crossings[word[k]]; };
        results[i] = composed(compose_range(0, word.size(), crossing, composed), results[i]);
      }
      results[i] = composed(inverse(frames[label.to]), results[i]);
      done[i] = last || working >= affordable || accurate(results[i], precision);
    });
    if (std::find(done.begin(), done.end(), 0) == done.end()) return results;
  }
}

}  // namespace epsnet::certify
