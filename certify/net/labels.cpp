#include "certify/net/labels.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

using Powers = std::vector<PowerOfZeta>;

Powers operator*(const Powers& x, const Powers& y) {
  Powers result;
  for (const PowerOfZeta& f : x) {
    for (const PowerOfZeta& g : y) result.push_back({f.coefficient * g.coefficient, f.power + g.power});
  }
  return result;
}

/// 4 sin²(π/q), for the power ξ = e^{iπ/q}.
Powers square_of_twice_sine(std::int64_t xi) { return {{2, 0}, {-1, 2 * xi}, {-1, -2 * xi}}; }

}  // namespace

ExactIsometry RationalCrossings::exact(std::span<const std::uint32_t> word) const {
  if (word.empty()) return exact_identity();
  return compose_range(0, word.size(), [&](std::size_t i) { return crossings_[word[i]]; });
}

std::size_t RationalCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  std::size_t sum = frame_bits;
  for (const std::uint32_t side : word) sum += bits(crossings_[side]);
  return sum;
}

RegularCrossings::RegularCrossings(RegularTile tile, std::vector<std::uint32_t> partner, const Budget& budget)
    : tile_(tile), partner_(std::move(partner)) {
  const std::int64_t p = tile.p;
  const std::int64_t q = tile.q;
  const std::int64_t order = std::lcm(std::lcm(2 * p, 2 * q), std::int64_t{4});
  at_p_ = order / (2 * p);
  at_q_ = order / (2 * q);
  // If all crossings, and with them their products, have even powers only, these are enough.
  bool even = order % 8 == 0 && (at_p_ + at_q_) % 2 == 0;
  for (std::uint32_t s = 0; even && s < partner_.size(); ++s) {
    even = at_p_ % 2 == 0 || (s % tile.p + partner_[s] % tile.p) % 2 == 0;
  }
  step_ = even ? 2 : 1;
  // s = 2 sin(π/q)·2 sin(π/p) sinh ρ, and (2 sin(π/p) sinh ρ)² = 2 cos(2π/p) + 2 cos(2π/q).
  Powers square =
      square_of_twice_sine(at_q_) * Powers{{1, 2 * at_p_}, {1, -2 * at_p_}, {1, 2 * at_q_}, {1, -2 * at_q_}};
  for (PowerOfZeta& term : square) term.power /= step_;
  ring_ = std::make_unique<RegularRing>(static_cast<std::uint32_t>(order / step_), square, budget);
}

RegularCrossings::CornerTurn RegularCrossings::crossing_of(std::uint32_t side) const {
  CornerTurn result{Turn::clockwise, 0, side % tile_.p, 0};
  result.last = result.first - 1;
  go_on(result, side);
  return result;
}

std::uint32_t RegularCrossings::following(std::uint32_t side, Turn turn) const {
  const std::uint32_t p = tile_.p;
  const std::uint32_t other = partner_[side];
  return other - other % p + (other % p + (turn == Turn::clockwise ? 1 : p - 1)) % p;
}

void RegularCrossings::go_on(CornerTurn& turn, std::uint32_t side) const {
  const std::uint32_t p = tile_.p;
  turn.last += turn.turn == Turn::clockwise ? 1 : -1;
  turn.last += (partner_[side] % p + p - side % p) % p;
  ++turn.count;
}

std::vector<RegularCrossings::CornerTurn> RegularCrossings::turns_of(std::span<const std::uint32_t> word) const {
  std::vector<CornerTurn> turns;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const auto goes_on = [&](Turn turn) {
      if (i == 0 || following(word[i - 1], turn) != word[i]) return false;
      return turns.back().count == 1 || turns.back().turn == turn;
    };
    const bool clockwise = goes_on(Turn::clockwise);
    if (!clockwise && !goes_on(Turn::counterclockwise)) {
      turns.push_back(crossing_of(word[i]));
      continue;
    }
    turns.back().turn = clockwise ? Turn::clockwise : Turn::counterclockwise;
    go_on(turns.back(), word[i]);
  }
  return turns;
}

Isometry<RegularNumber> RegularCrossings::exact(std::span<const std::uint32_t> word) const {
  if (word.empty()) return embed(exact_identity());
  const std::vector<CornerTurn> turns = turns_of(word);
  return compose_range(0, turns.size(), [&](std::size_t i) { return product(turns[i]); });
}

Isometry<RegularNumber> RegularCrossings::turn(std::uint32_t side, std::uint32_t count, Turn turn) const {
  CornerTurn result = crossing_of(side);
  result.turn = turn;
  while (result.count < count) {
    side = following(side, turn);
    go_on(result, side);
  }
  return product(result);
}

Isometry<RegularNumber> RegularCrossings::product(const CornerTurn& turn) const {
  const bool clockwise = turn.turn == Turn::clockwise;
  const std::int64_t j = turn.count;
  const std::int64_t xi = clockwise ? at_q_ : -at_q_;
  const std::int64_t eta = clockwise ? at_p_ : -at_p_;
  const std::int64_t sign = clockwise && j % 2 != 0 ? -1 : 1;
  const Powers to_a{{sign, at_p_ * (turn.last - turn.first)}};
  const Powers to_b{{sign, at_p_ * (turn.last + turn.first)}};
  Powers a = to_a * square_of_twice_sine(at_q_) *
             Powers{{1, (j + 1) * xi}, {-1, -(j + 1) * xi}, {1, 2 * eta + (j - 1) * xi}, {-1, 2 * eta - (j - 1) * xi}};
  // i = e^{iπ/2}; clockwise −2 sin(π/q)·(e^{iπj/q} − e^{−iπj/q}), otherwise the conjugate.
  const std::int64_t quarter = at_p_ * tile_.p / 2;
  Powers b =
      to_b * Powers{{clockwise ? 1 : -1, quarter}} * Powers{{1, xi}, {-1, -xi}} * Powers{{1, j * xi}, {-1, -j * xi}};
  for (Powers* powers : {&a, &b}) {
    for (PowerOfZeta& term : *powers) term.power /= step_;
  }
  return {regular_number(*ring_, a, {}), regular_number(*ring_, {}, b)};
}

Isometry<RegularNumber> RegularCrossings::embed(const ExactIsometry& f) const {
  return {regular_number(*ring_, f.a), regular_number(*ring_, f.b)};
}

std::size_t RegularCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  // A turn adds some four bits to each coefficient. Many turns of few bits take as long as few of many.
  const std::size_t order = ring_->order();
  const std::size_t turn_bits = std::max<std::size_t>(2048, 4 * order);
  return 2 * order * frame_bits + turn_bits * turns_of(word).size();
}

FieldCrossings::FieldCrossings(std::unique_ptr<const NumberField> field, std::vector<Isometry<FieldNumber>> crossings)
    : field_(std::move(field)), crossings_(std::move(crossings)) {
  determinants_.reserve(crossings_.size());
  for (const Isometry<FieldNumber>& f : crossings_) determinants_.push_back(determinant(f));
}

Isometry<FieldNumber> FieldCrossings::exact(std::span<const std::uint32_t> word) const {
  if (word.empty()) return embed(exact_identity());
  return compose_range(0, word.size(), [&](std::size_t i) { return crossings_[word[i]]; });
}

Isometry<FieldNumber> FieldCrossings::embed(const ExactIsometry& f) const {
  return {field_number(*field_, f.a), field_number(*field_, f.b)};
}

std::size_t FieldCrossings::product_bits(std::size_t frame_bits, std::span<const std::uint32_t> word) const {
  std::size_t sum = field_->degree() * frame_bits;
  for (const std::uint32_t side : word) sum += bits(crossings_[side]);
  return sum;
}

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
    const std::uint32_t chart = chart_of_core(document, collar);
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
    const auto& [from, to, path] = label_at(numbers[i]);
    const auto composed = [&](const BallIsometry& f, const BallIsometry& g) { return compose(f, g, precision); };
    const auto crossing = [&, &way = path](std::size_t k) -> const BallIsometry& {
      return crossings[place_of(way[k], sides)];
    };
    results[i] = frames[place_of(from, charts)];
    if (!path.empty()) results[i] = composed(compose_range(0, path.size(), crossing, composed), results[i]);
    results[i] = composed(inverse(frames[place_of(to, charts)]), results[i]);
  });
  return results;
}

}  // namespace epsnet::certify
