#include "certify/net/label_evaluator.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

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

std::vector<ExactIsometry> chart_frames(const std::vector<NetDocument::Chart>& charts, const Budget& budget) {
  std::vector<ExactIsometry> frames;
  frames.reserve(charts.size());
  for (const NetDocument::Chart& chart : charts) {
    budget.spend(exact_point_work(chart.centre));
    frames.push_back(translation_to(exact_point(chart.centre)));
  }
  return frames;
}

LabelParts label_parts(Crossings crossings, const std::vector<NetDocument::Chart>& charts, const Budget& budget) {
  return {std::move(crossings), chart_frames(charts, budget), budget};
}

LabelEvaluator::LabelEvaluator(const NetDocument& document, const LabelParts& parts)
    : parts_(parts), first_core_(document.labels.size() + 1), partner_(SurfaceSides(document.surface).partner) {
  ensure(parts.frames.size() == document.charts.size(), "frames and charts are not as many");
  ensure(std::visit([](const auto& kind) { return kind.size(); }, parts.crossings) == partner_.size(),
         "crossings and sides are not as many");
  for (const NetDocument::Label& label : document.labels) add(label.from, label.to, label.word);
  if (!document.collars) return;
  for (const NetDocument::Collar& collar : *document.collars) {
    const std::uint32_t chart = document.vertices[collar.vertices[0]].chart;
    add(chart, chart, collar.core);
  }
}

void LabelEvaluator::add(std::uint32_t from, std::uint32_t to, const std::vector<std::uint32_t>& word) {
  std::vector<std::uint32_t> reduced;
  for (const std::uint32_t side : word) append(reduced, side);
  const std::size_t frame_bits = bits(parts_.frames[from]) + bits(parts_.frames[to]);
  exact_bits_.push_back(std::visit(
      [&](const auto& crossings) {
        parts_.budget.spend(crossings.letter_work(), reduced.size());
        return crossings.product_bits(frame_bits, reduced);
      },
      parts_.crossings));
  labels_.push_back({from, to, std::move(reduced)});
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
  std::vector<std::size_t> pending(numbers.size());
  std::iota(pending.begin(), pending.end(), std::size_t{0});
  // More bits than the wanted ones from the start: a product of n letters loses about log2(n) bits.
  for (slong working = precision + 32;; working = std::min(2 * working, cap)) {
    std::vector<std::uint32_t> asked;
    asked.reserve(pending.size());
    for (const std::size_t i : pending) asked.push_back(numbers[i]);
    std::vector<BallIsometry> values = multiplied(asked, working, threads);
    for (std::size_t k = 0; k < pending.size(); ++k) results[pending[k]] = std::move(values[k]);
    std::erase_if(pending, [&](std::size_t i) { return working >= cap || accurate(results[i], precision); });
    if (pending.empty()) return results;
  }
}

std::vector<BallIsometry> LabelEvaluator::multiplied(std::span<const std::uint32_t> numbers, slong precision,
                                                     unsigned threads) const {
  // Every crossing and frame in use is rounded once, not once for each letter.
  std::size_t letters = 0;
  const std::vector<std::uint32_t> sides = increasing(numbers, [&](std::uint32_t number, auto& all) {
    const std::vector<std::uint32_t>& word = label_at(number).word;
    all.insert(all.end(), word.begin(), word.end());
    letters += word.size();
  });
  const std::vector<std::uint32_t> charts = increasing(numbers, [&](std::uint32_t number, auto& all) {
    all.insert(all.end(), {label_at(number).from, label_at(number).to});
  });
  const auto wide = static_cast<std::uint64_t>(precision);
  budget().spend(28 * ball_work(wide), letters + 3 * numbers.size());
  budget().spend(memory_work(200 + wide / 2), numbers.size());
  for (const std::uint32_t side : sides) {
    budget().spend(std::visit([&](const auto& kind) { return kind.ball_work(side, wide); }, parts_.crossings));
  }
  for (const std::uint32_t chart : charts) budget().spend(to_balls_work(bits(parts_.frames[chart]), wide));
  std::vector<BallIsometry> crossings(sides.size());
  std::vector<BallIsometry> frames(charts.size());
  std::vector<BallIsometry> results(numbers.size());
  for_each_parallel(sides.size(), threads, [&](unsigned, std::size_t k) {
    crossings[k] = ball_crossing(parts_.crossings, sides[k], precision);
  });
  for_each_parallel(charts.size(), threads,
                    [&](unsigned, std::size_t k) { frames[k] = to_balls(parts_.frames[charts[k]], precision); });
  for_each_parallel(numbers.size(), threads, [&](unsigned, std::size_t i) {
    const auto& [from, to, word] = label_at(numbers[i]);
    const auto composed = [&](const BallIsometry& f, const BallIsometry& g) { return compose(f, g, precision); };
    const auto crossing = [&, &word = word](std::size_t k) -> const BallIsometry& {
      return crossings[place_of(word[k], sides)];
    };
    results[i] = frames[place_of(from, charts)];
    if (!word.empty()) results[i] = composed(compose_range(0, word.size(), crossing, composed), results[i]);
    results[i] = composed(inverse(frames[place_of(to, charts)]), results[i]);
  });
  return results;
}

}  // namespace epsnet::certify
