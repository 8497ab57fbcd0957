#include "certify/net/label_evaluator.h"

#include <algorithm>
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
  std::vector<char> done(numbers.size(), 0);
  // More bits than the wanted ones from the start: a product of n letters loses about log2(n) bits.
  for (slong working = precision + 32;; working = std::min(2 * working, cap)) {
    // Every crossing and frame in use is rounded once, not once for each letter.
    std::vector<std::uint32_t> sides;
    std::vector<std::uint32_t> charts;
    std::size_t pending = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (done[i]) continue;
      const NetDocument::Label& label = label_at(numbers[i]);
      charts.insert(charts.end(), {label.from, label.to});
      sides.insert(sides.end(), label.word.begin(), label.word.end());
      ++pending;
    }
    const auto wide = static_cast<std::uint64_t>(working);
    budget().spend(28 * ball_work(wide), sides.size() + 3 * pending);
    budget().spend(memory_work(200 + wide / 2), pending);
    for (std::vector<std::uint32_t>* used : {&sides, &charts}) {
      std::sort(used->begin(), used->end());
      used->erase(std::unique(used->begin(), used->end()), used->end());
    }
    for (const std::uint32_t side : sides) {
      budget().spend(std::visit([&](const auto& kind) { return kind.ball_work(side, wide); }, parts_.crossings));
    }
    for (const std::uint32_t chart : charts) budget().spend(to_balls_work(bits(parts_.frames[chart]), wide));
    std::vector<BallIsometry> crossings(sides.size());
    std::vector<BallIsometry> frames(charts.size());
    for_each_parallel(sides.size(), threads, [&](unsigned, std::size_t k) {
      crossings[k] = ball_crossing(parts_.crossings, sides[k], working);
    });
    for_each_parallel(charts.size(), threads,
                      [&](unsigned, std::size_t k) { frames[k] = to_balls(parts_.frames[charts[k]], working); });
    const bool last = working >= cap;
    for_each_parallel(numbers.size(), threads, [&](unsigned, std::size_t i) {
      if (done[i]) return;
      const NetDocument::Label& label = label_at(numbers[i]);
      const auto composed = [&](const BallIsometry& f, const BallIsometry& g) { return compose(f, g, working); };
      results[i] = frames[place_of(label.from, charts)];
      if (!label.word.empty()) {
        const auto crossing = [&](std::size_t k) -> const BallIsometry& {
          return crossings[place_of(label.word[k], sides)];
        };
        results[i] = composed(compose_range(0, label.word.size(), crossing, composed), results[i]);
      }
      results[i] = composed(inverse(frames[place_of(label.to, charts)]), results[i]);
      done[i] = last || accurate(results[i], precision);
    });
    if (std::find(done.begin(), done.end(), 0) == done.end()) return results;
  }
}

}  // namespace epsnet::certify
