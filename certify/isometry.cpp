#include <epsnet/certify/isometry.h>
#include <epsnet/certify/parallel.h>
#include <epsnet/certify/surface_sides.h>

#include <algorithm>

namespace epsnet::certify {
namespace {

/// The letters of one word times bits that are spent at most: a second or so. Words of a net have a few dozen letters.
constexpr std::size_t kMaxLabelWork = std::size_t{1} << 26;

/// a·b + c·conj(d).
void multiply_add(acb_ptr result, acb_srcptr a, acb_srcptr b, acb_srcptr c, acb_srcptr d, slong precision) {
  ComplexBall conjugate_d;
  acb_conj(conjugate_d.get(), d);
  acb_mul(result, a, b, precision);
  acb_addmul(result, c, conjugate_d.get(), precision);
}

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

BallIsometry identity_isometry() {
  BallIsometry f;
  acb_one(f.a.get());
  return f;
}

BallIsometry compose(const BallIsometry& f, const BallIsometry& g, slong precision) {
  BallIsometry result;
  multiply_add(result.a.get(), f.a.get(), g.a.get(), f.b.get(), g.b.get(), precision);
  multiply_add(result.b.get(), f.a.get(), g.b.get(), f.b.get(), g.a.get(), precision);
  return result;
}

BallIsometry inverse(const BallIsometry& f) {
  BallIsometry result;
  acb_conj(result.a.get(), f.a.get());
  acb_neg(result.b.get(), f.b.get());
  return result;
}

BallIsometry to_balls(const ExactIsometry& f, slong precision) {
  BallIsometry result;
  Ball scale;
  set_integer(scale.get(), determinant(f), precision);
  arb_rsqrt(scale.get(), scale.get(), precision);
  set_integer(result.a.re(), f.a.re, precision);
  set_integer(result.a.im(), f.a.im, precision);
  set_integer(result.b.re(), f.b.re, precision);
  set_integer(result.b.im(), f.b.im, precision);
  acb_mul_arb(result.a.get(), result.a.get(), scale.get(), precision);
  acb_mul_arb(result.b.get(), result.b.get(), scale.get(), precision);
  return result;
}

void half_displacement_squared(arb_ptr result, const BallIsometry& f, slong precision) {
  // arb_sqr squares one ball, so the result is never below 0 by more than rounding.
  Ball square;
  arb_sqr(result, f.b.re(), precision);
  arb_sqr(square.get(), f.b.im(), precision);
  arb_add(result, result, square.get(), precision);
}

LabelEvaluator::LabelEvaluator(const Document& document, const ExactParts& parts) : document_(document), parts_(parts) {
  std::vector<std::size_t> crossing_bits;
  crossing_bits.reserve(parts.crossings.size());
  for (const ExactIsometry& crossing : parts.crossings) crossing_bits.push_back(bits(crossing));
  exact_bits_.reserve(document.labels.size());
  words_.reserve(document.labels.size());
  const SurfaceSides sides(document.surface);
  for (const Label& label : document.labels) {
    std::vector<std::uint32_t> word;
    for (const std::uint32_t side : label.word) {
      if (!word.empty() && sides.partner[word.back()] == side) {
        word.pop_back();
      } else {
        word.push_back(side);
      }
    }
    std::size_t sum = bits(parts_.frames[label.from]) + bits(parts_.frames[label.to]);
    for (const std::uint32_t side : word) sum += crossing_bits[side];
    exact_bits_.push_back(sum);
    words_.push_back(std::move(word));
  }
}

std::vector<BallIsometry> LabelEvaluator::evaluate(std::span<const std::uint32_t> numbers, slong precision, slong cap,
                                                   unsigned threads) const {
  std::vector<BallIsometry> results(numbers.size());
  std::vector<char> done(numbers.size(), 0);
  // More bits than the wanted ones from the start: a product of n letters loses about log2(n) bits.
  for (slong working = precision + 32;; working = std::min(2 * working, cap)) {
    // Every crossing and frame in use is rounded once, not once for each letter.
    std::vector<char> side_used(parts_.crossings.size(), 0);
    std::vector<char> chart_used(parts_.frames.size(), 0);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (done[i]) continue;
      const Label& label = document_.labels[numbers[i] - 1];
      chart_used[label.from] = chart_used[label.to] = 1;
      for (const std::uint32_t side : words_[numbers[i] - 1]) side_used[side] = 1;
    }
    std::vector<BallIsometry> crossings(side_used.size());
    std::vector<BallIsometry> frames(chart_used.size());
    for (std::size_t s = 0; s < side_used.size(); ++s) {
      if (side_used[s]) crossings[s] = to_balls(parts_.crossings[s], working);
    }
    for (std::size_t c = 0; c < chart_used.size(); ++c) {
      if (chart_used[c]) frames[c] = to_balls(parts_.frames[c], working);
    }
    const bool last = working >= cap;
    for_each_parallel(numbers.size(), threads, [&](unsigned, std::size_t i) {
      if (done[i]) return;
      const Label& label = document_.labels[numbers[i] - 1];
      BallIsometry result = frames[label.from];
      const auto& word = words_[numbers[i] - 1];
      // 96 bits are always spent.
      const auto affordable = static_cast<slong>(std::max<std::size_t>(96, kMaxLabelWork / (word.size() + 1)));
      const slong bits_spent = std::min(working, affordable);
      for (const std::uint32_t side : word) result = compose(crossings[side], result, bits_spent);
      results[i] = compose(inverse(frames[label.to]), result, bits_spent);
      done[i] = last || working >= affordable || accurate(results[i], precision);
    });
    if (std::find(done.begin(), done.end(), 0) == done.end()) return results;
  }
}

ExactIsometry LabelEvaluator::evaluate_exactly(std::uint32_t number) const {
  const Label& label = document_.labels[number - 1];
  const ExactIsometry last = inverse(parts_.frames[label.to]);
  std::vector<const ExactIsometry*> path;
  const auto& word = words_[number - 1];
  path.reserve(word.size() + 2);
  path.push_back(&parts_.frames[label.from]);
  for (const std::uint32_t side : word) path.push_back(&parts_.crossings[side]);
  path.push_back(&last);
  ExactIsometry result = compose_path(path);
  reduce(result);
  return result;
}

}  // namespace epsnet::certify
