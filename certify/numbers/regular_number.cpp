#include "certify/numbers/regular_number.h"

#include <algorithm>
#include <array>
#include <bit>
#include <flint/fmpq.h>
#include <flint/ulong_extras.h>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "certify/numbers/precision.h"

namespace epsnet::certify {

struct RegularExpression {
  enum class Kind : std::uint8_t {
    integer,        ///< `value`.
    power,          ///< ζ^exponent, 0 ≤ exponent < 4g.
    geometric_sum,  ///< 1 + ζ + … + ζ^(count − 1), count > 0.
    s,
    conjugate,
    sum,
    difference,
    product,
    turn_a,  ///< `left`, which is the entry a, or b, of a product of `count` crossings that turn around a corner.
    turn_b,
  };
  Kind kind;
  mpz_class value = {};
  std::uint32_t exponent = 0;
  std::uint32_t count = 0;
  std::shared_ptr<const RegularExpression> left = {};
  std::shared_ptr<const RegularExpression> right = {};
};

namespace {

using Kind = RegularExpression::Kind;
using ExpressionPointer = std::shared_ptr<const RegularExpression>;

ExpressionPointer make(RegularExpression expression) {
  return std::make_shared<const RegularExpression>(std::move(expression));
}

ExpressionPointer make(Kind kind, ExpressionPointer left, ExpressionPointer right) {
  return make({.kind = kind, .left = std::move(left), .right = std::move(right)});
}

/// 1 + ζ + … + ζ^(count − 1).
RegularNumber geometric_sum(const RegularRing& ring, std::uint32_t count) {
  if (count == 0) return {&ring, nullptr};
  return {&ring, make({.kind = Kind::geometric_sum, .count = count})};
}

/// An upper bound of the logarithm of |value| ≠ 0.
std::int64_t log_of(const mpz_class& value) {
  const auto bits = static_cast<std::int64_t>(mpz_sizeinbase(value.get_mpz_t(), 2));
  const bool power_of_two = mpz_scan1(value.get_mpz_t(), 0) + 1 == static_cast<mp_bitcnt_t>(bits);
  return RegularRing::kLogScale * (power_of_two ? bits - 1 : bits);
}

/// The logarithm of x > 0, rounded up.
std::int64_t log_rounded_up(arb_srcptr x) {
  constexpr slong kPrecision = 64;
  Ball log, scale;
  arf_t upper;
  arf_init(upper);
  arb_const_log2(scale.get(), kPrecision);
  arb_log(log.get(), x, kPrecision);
  arb_div(log.get(), log.get(), scale.get(), kPrecision);
  arb_mul_si(log.get(), log.get(), RegularRing::kLogScale, kPrecision);
  arb_get_ubound_arf(upper, log.get(), kPrecision);
  const std::int64_t result = arf_get_si(upper, ARF_RND_CEIL);
  arf_clear(upper);
  return result;
}

/// Bounds of |b| and |a| in one embedding, (a, b) the product of `count` crossings that turn around a corner: |b| = |s
/// sin(count θ/2)/sin(θ/2)|, and |a|² is 1 + |b|² or 1 − |b|², as s is real or imaginary.
std::int64_t turn_b_bound(const RegularRing::Embeddings& at, std::uint32_t count) {
  const std::int64_t bound = at.log_s + std::min(log_of(count), at.log_inverse_sine);
  return at.s_is_real ? bound : std::min<std::int64_t>(bound, 0);
}
std::int64_t turn_a_bound(const RegularRing::Embeddings& at, std::uint32_t count) {
  constexpr std::int64_t kRootOfTwo = RegularRing::kLogScale / 2;
  return at.s_is_real ? kRootOfTwo + std::max<std::int64_t>(turn_b_bound(at, count), 0) : 0;
}

/// An expression as a list in which everything comes after what it is made of.
struct Step {
  const RegularExpression* expression;
  std::uint32_t left;
  std::uint32_t right;
};

std::vector<Step> steps_of(const RegularExpression& root) {
  std::vector<Step> steps;
  std::unordered_map<const RegularExpression*, std::uint32_t> number;
  std::vector<const RegularExpression*> open{&root};
  while (!open.empty()) {
    const RegularExpression* top = open.back();
    bool ready = true;
    for (const RegularExpression* part : {top->right.get(), top->left.get()}) {
      if (part != nullptr && !number.contains(part)) {
        open.push_back(part);
        ready = false;
      }
    }
    if (!ready) continue;
    open.pop_back();
    const auto known = [&](const ExpressionPointer& part) { return part ? number.at(part.get()) : 0; };
    if (number.emplace(top, static_cast<std::uint32_t>(steps.size())).second) {
      steps.push_back({top, known(top->left), known(top->right)});
    }
  }
  return steps;
}

/// The value of the last step; an algebra says what the leaves are and how to calculate.
template <class Algebra>
typename Algebra::Value evaluate(const std::vector<Step>& steps, const Algebra& algebra) {
  std::vector<typename Algebra::Value> values;
  values.reserve(steps.size());
  for (const auto& [expression, left, right] : steps) {
    switch (expression->kind) {
      case Kind::integer:
        values.push_back(algebra.integer(expression->value));
        break;
      case Kind::power:
        values.push_back(algebra.power(expression->exponent));
        break;
      case Kind::geometric_sum:
        values.push_back(algebra.geometric_sum(expression->count));
        break;
      case Kind::s:
        values.push_back(algebra.s());
        break;
      case Kind::conjugate:
        values.push_back(algebra.conjugate(values[left]));
        break;
      case Kind::sum:
        values.push_back(algebra.sum(values[left], values[right]));
        break;
      case Kind::difference:
        values.push_back(algebra.difference(values[left], values[right]));
        break;
      case Kind::product:
        values.push_back(algebra.product(values[left], values[right]));
        break;
      case Kind::turn_a:
        values.push_back(algebra.turn_a(values[left], expression->count));
        break;
      case Kind::turn_b:
        values.push_back(algebra.turn_b(values[left], expression->count));
        break;
    }
  }
  return values.back();
}

/// Upper bounds of the absolute values in all embeddings, as logarithms.
class Bounds {
 public:
  using Value = std::vector<std::int64_t>;

  explicit Bounds(const RegularRing& ring) : embeddings_(ring.embeddings()) {}

  [[nodiscard]] Value integer(const mpz_class& value) const { return Value(embeddings_.size(), log_of(value)); }
  [[nodiscard]] Value power(std::uint32_t /*exponent*/) const { return Value(embeddings_.size(), 0); }
  [[nodiscard]] Value geometric_sum(std::uint32_t count) const {
    // |ζ^count − 1|/|ζ − 1| = |sin(count θ/2)|/sin(θ/2).
    return each([&](const RegularRing::Embeddings& at) { return std::min(log_of(count), at.log_inverse_sine); });
  }
  [[nodiscard]] Value s() const {
    return each([](const RegularRing::Embeddings& at) { return at.log_s; });
  }
  [[nodiscard]] static Value conjugate(const Value& x) { return x; }
  [[nodiscard]] static Value sum(const Value& x, const Value& y) {
    Value result(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) result[k] = std::max(x[k], y[k]) + RegularRing::kLogScale;
    return result;
  }
  [[nodiscard]] static Value difference(const Value& x, const Value& y) { return sum(x, y); }
  [[nodiscard]] static Value product(const Value& x, const Value& y) {
    Value result(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) result[k] = x[k] + y[k];
    return result;
  }
  [[nodiscard]] Value turn_a(const Value& /*x*/, std::uint32_t count) const {
    return each([&](const RegularRing::Embeddings& at) { return turn_a_bound(at, count); });
  }
  [[nodiscard]] Value turn_b(const Value& /*x*/, std::uint32_t count) const {
    return each([&](const RegularRing::Embeddings& at) { return turn_b_bound(at, count); });
  }

 private:
  template <class Bound>
  [[nodiscard]] Value each(const Bound& bound) const {
    Value result;
    result.reserve(embeddings_.size());
    for (const RegularRing::Embeddings& at : embeddings_) result.push_back(bound(at));
    return result;
  }

  const std::vector<RegularRing::Embeddings>& embeddings_;
};

/// The value itself.
class Balls {
 public:
  using Value = ComplexBall;

  Balls(const RegularRing& ring, slong precision) : genus_(ring.genus()), precision_(precision) {}

  [[nodiscard]] Value integer(const mpz_class& value) const {
    Value result;
    set_integer(result.re(), value, precision_);
    return result;
  }
  [[nodiscard]] Value power(std::uint32_t exponent) const {
    Value result;
    set_regular_direction(result.get(), genus_, exponent, precision_);
    return result;
  }
  [[nodiscard]] Value geometric_sum(std::uint32_t count) const {
    Value result = power(count % (4 * genus_));
    Value divisor = power(1);
    acb_sub_ui(result.get(), result.get(), 1, precision_);
    acb_sub_ui(divisor.get(), divisor.get(), 1, precision_);
    acb_div(result.get(), result.get(), divisor.get(), precision_);
    return result;
  }
  [[nodiscard]] Value s() const {
    Value result;
    Ball cosh;
    set_regular_apothem(cosh.get(), result.re(), genus_, precision_);
    return result;
  }
  [[nodiscard]] static Value conjugate(const Value& x) {
    Value result;
    acb_conj(result.get(), x.get());
    return result;
  }
  [[nodiscard]] Value sum(const Value& x, const Value& y) const {
    Value result;
    acb_add(result.get(), x.get(), y.get(), precision_);
    return result;
  }
  [[nodiscard]] Value difference(const Value& x, const Value& y) const {
    Value result;
    acb_sub(result.get(), x.get(), y.get(), precision_);
    return result;
  }
  [[nodiscard]] Value product(const Value& x, const Value& y) const {
    Value result;
    acb_mul(result.get(), x.get(), y.get(), precision_);
    return result;
  }
  [[nodiscard]] static Value turn_a(const Value& x, std::uint32_t /*count*/) { return x; }
  [[nodiscard]] static Value turn_b(const Value& x, std::uint32_t /*count*/) { return x; }

 private:
  std::uint32_t genus_;
  slong precision_;
};

}  // namespace

/// Images of a number and of its conjugate.
class RegularRing::Residues {
 public:
  struct Value {
    ulong x;
    ulong conjugate;
  };

  /// The field of p elements, p prime, p − 1 divisible by 4g; not of use if a² − 1 has no root.
  Residues(std::uint32_t genus, ulong p) : order_(4 * genus), p_(p), inverse_(n_preinvert_limb(p)) {
    // A root of unity of order 4g, any one: the cyclotomic polynomial is 0 of it.
    const auto has_order = [&](ulong z) {
      for (std::uint32_t q = 2; q <= order_; ++q) {
        if (order_ % q == 0 && n_powmod2_preinv(z, order_ / q, p_, inverse_) == 1) return false;
      }
      return true;
    };
    ulong zeta = 0;
    for (ulong base = 2; zeta == 0 || !has_order(zeta); ++base) {
      zeta = n_powmod2_preinv(base, static_cast<slong>((p - 1) / order_), p_, inverse_);
    }
    ulong step = 1;
    for (std::uint32_t k = 0; k < kBlock; ++k, step = times(step, zeta)) small_.push_back(step);
    ulong block = 1;
    for (std::uint32_t k = 0; k <= order_ / kBlock; ++k, block = times(block, step)) large_.push_back(block);
    inverse_step_ = n_invmod(minus(zeta, 1), p_);
    const ulong a = negative(times(at(genus + 1), geometric_sum_at(2 * genus - 1)));
    const ulong square = minus(times(a, a), 1);
    s_ = n_sqrtmod(square, p_);
    useful_ = times(s_, s_) == square;
  }

  [[nodiscard]] bool useful() const { return useful_; }
  [[nodiscard]] ulong prime() const { return p_; }

  [[nodiscard]] Value integer(const mpz_class& value) const {
    const ulong x = mpz_fdiv_ui(value.get_mpz_t(), p_);
    return {x, x};
  }
  [[nodiscard]] Value power(std::uint32_t exponent) const { return {at(exponent), at(order_ - exponent)}; }
  [[nodiscard]] Value geometric_sum(std::uint32_t count) const {
    // 1 + … + ζ^−(count − 1) is ζ^−(count − 1) (1 + … + ζ^(count − 1)).
    const ulong x = geometric_sum_at(count);
    return {x, times(x, at(order_ - (count - 1) % order_))};
  }
  [[nodiscard]] Value s() const { return {s_, s_}; }
  [[nodiscard]] static Value conjugate(const Value& x) { return {x.conjugate, x.x}; }
  [[nodiscard]] Value sum(const Value& x, const Value& y) const {
    return {n_addmod(x.x, y.x, p_), n_addmod(x.conjugate, y.conjugate, p_)};
  }
  [[nodiscard]] Value difference(const Value& x, const Value& y) const {
    return {minus(x.x, y.x), minus(x.conjugate, y.conjugate)};
  }
  [[nodiscard]] Value product(const Value& x, const Value& y) const {
    return {times(x.x, y.x), times(x.conjugate, y.conjugate)};
  }
  [[nodiscard]] static Value turn_a(const Value& x, std::uint32_t /*count*/) { return x; }
  [[nodiscard]] static Value turn_b(const Value& x, std::uint32_t /*count*/) { return x; }

 private:
  static constexpr std::uint32_t kBlock = 64;

  [[nodiscard]] ulong times(ulong x, ulong y) const { return n_mulmod2_preinv(x, y, p_, inverse_); }
  [[nodiscard]] ulong minus(ulong x, ulong y) const { return n_submod(x, y, p_); }
  [[nodiscard]] ulong negative(ulong x) const { return n_negmod(x, p_); }
  /// ζ^k, 0 ≤ k ≤ 4g.
  [[nodiscard]] ulong at(std::uint32_t k) const { return times(small_[k % kBlock], large_[k / kBlock]); }
  [[nodiscard]] ulong geometric_sum_at(std::uint32_t count) const {
    return times(minus(at(count % order_), 1), inverse_step_);
  }

  std::uint32_t order_;
  ulong p_;
  ulong inverse_;
  std::vector<ulong> small_;  ///< ζ^k, k < kBlock.
  std::vector<ulong> large_;  ///< ζ^(k kBlock).
  ulong inverse_step_;        ///< 1/(ζ − 1).
  ulong s_;
  bool useful_;
};

RegularRing::RegularRing(std::uint32_t genus, Budget budget) : genus_(genus), budget_(std::move(budget)) {
  constexpr slong kPrecision = 64;
  Ball sine, square;
  for (std::uint32_t k = 1; k < 2 * genus; k += 2) {
    if (std::gcd(k, 4 * genus) != 1) continue;
    // s² = cot²(θ/2) − 1 = cos θ/sin²(θ/2), positive exactly for θ < π/2.
    ComplexBall direction;
    set_regular_direction(direction.get(), 2 * genus, k, kPrecision);
    arb_set(sine.get(), direction.im());
    set_regular_direction(direction.get(), genus, k, kPrecision);
    arb_abs(square.get(), direction.re());
    arb_sqrt(square.get(), square.get(), kPrecision);
    arb_div(square.get(), square.get(), sine.get(), kPrecision);
    arb_inv(sine.get(), sine.get(), kPrecision);
    embeddings_.push_back({log_rounded_up(square.get()), log_rounded_up(sine.get()), k < genus});
  }
}

RegularRing::~RegularRing() = default;

const RegularRing::Residues& RegularRing::residues(std::size_t i) const {
  const std::lock_guard lock(mutex_);
  // Primes 1 + 4g m from 2^62 down.
  const ulong step = 4 * ulong{genus_};
  ulong p = residues_.empty() ? (ulong{1} << 62) / step * step + 1 : residues_.back().prime();
  while (residues_.size() <= i) {
    budget_.spend(100'000 + 20 * step);
    do p -= step;
    while (!n_is_prime(p));
    Residues next(genus_, p);
    if (next.useful()) residues_.push_back(std::move(next));
  }
  return residues_[i];
}

RegularNumber regular_number(const RegularRing& ring, const Gaussian& x) {
  const auto integer = [&](const mpz_class& value) -> RegularNumber {
    if (value == 0) return {&ring, nullptr};
    return {&ring, make({.kind = Kind::integer, .value = value})};
  };
  return integer(x.re) + power_of_zeta(ring, ring.genus()) * integer(x.im);
}

RegularNumber power_of_zeta(const RegularRing& ring, std::int64_t k) {
  const std::int64_t order = 4 * std::int64_t{ring.genus()};
  const auto exponent = static_cast<std::uint32_t>((k % order + order) % order);
  return {&ring, make({.kind = Kind::power, .exponent = exponent})};
}

RegularNumber regular_s(const RegularRing& ring) { return {&ring, make({.kind = Kind::s})}; }

Isometry<RegularNumber> regular_turn(const RegularRing& ring, std::uint32_t side, std::uint32_t count, Turn turn) {
  const std::int64_t g = ring.genus();
  const std::int64_t direction = turn == Turn::counterclockwise ? 1 : -1;
  const std::int64_t step = direction * (2 * g + 1);
  // (±i)^(j − 1)(1 + ζ^∓1 + … + ζ^∓(j − 1)).
  const auto chebyshev = [&](std::int64_t j) {
    const std::int64_t exponent = direction > 0 ? (g - 1) * (j - 1) : -g * (j - 1);
    return power_of_zeta(ring, exponent) * geometric_sum(ring, static_cast<std::uint32_t>(j));
  };
  const RegularNumber minus_cotangent =
      power_of_zeta(ring, g + 1) * geometric_sum(ring, static_cast<std::uint32_t>(2 * g - 1));
  const RegularNumber all = chebyshev(count);
  const RegularNumber a = power_of_zeta(ring, 2 * g + (std::int64_t{count} - 1) * step) *
                          (minus_cotangent * all + chebyshev(std::int64_t{count} - 1));
  const RegularNumber b = power_of_zeta(ring, 2 * g + side + (std::int64_t{count} - 1) * step) * regular_s(ring) * all;
  return {{&ring, make({.kind = Kind::turn_a, .count = count, .left = a.expression})},
          {&ring, make({.kind = Kind::turn_b, .count = count, .left = b.expression})}};
}

std::size_t regular_turn_bits(const RegularRing& ring, std::uint32_t count) {
  std::int64_t sum = 0;
  for (const RegularRing::Embeddings& at : ring.embeddings()) {
    sum += std::max<std::int64_t>(turn_a_bound(at, count), 0);
  }
  return static_cast<std::size_t>(2 * sum / RegularRing::kLogScale);
}

RegularNumber operator+(const RegularNumber& x, const RegularNumber& y) {
  if (!x.expression) return y;
  if (!y.expression) return x;
  return {x.ring, make(Kind::sum, x.expression, y.expression)};
}

RegularNumber operator-(const RegularNumber& x, const RegularNumber& y) {
  if (!y.expression) return x;
  if (!x.expression) return mpz_class(-1) * y;
  return {x.ring, make(Kind::difference, x.expression, y.expression)};
}

RegularNumber operator*(const RegularNumber& x, const RegularNumber& y) {
  if (!x.expression || !y.expression) return {x.ring, nullptr};
  return {x.ring, make(Kind::product, x.expression, y.expression)};
}

RegularNumber operator*(const mpz_class& x, const RegularNumber& y) {
  return x == 1 ? y : regular_number(*y.ring, {x, 0}) * y;
}

RegularNumber operator*(const Gaussian& x, const RegularNumber& y) { return regular_number(*y.ring, x) * y; }

RegularNumber conjugate(const RegularNumber& x) {
  if (!x.expression) return x;
  return {x.ring, make(Kind::conjugate, x.expression, nullptr)};
}

RegularNumber norm(const RegularNumber& x) { return x * conjugate(x); }

RegularNumber twice_real(const RegularNumber& x) { return x + conjugate(x); }

RegularNumber twice_imaginary(const RegularNumber& x) {
  return power_of_zeta(*x.ring, x.ring->genus()) * (conjugate(x) - x);
}

std::int64_t log_rounded_down(std::uint64_t x) {
  return RegularRing::kLogScale * (static_cast<std::int64_t>(std::bit_width(x)) - 1);
}

std::vector<std::int64_t> log_bounds(const RegularNumber& x) {
  return evaluate(steps_of(*x.expression), Bounds(*x.ring));
}

int sign(const RegularNumber& x) {
  if (!x.expression) return 0;
  const std::vector<Step> steps = steps_of(*x.expression);
  const Budget& budget = x.ring->budget();
  // Each step was made, put in a list and gets a bound for each embedding.
  budget.spend(200 + 4 * x.ring->embeddings().size(), steps.size());
  const Bounds::Value bounds = evaluate(steps, Bounds(*x.ring));
  // Of the norm over the field of the real numbers among those of Q(ζ, s), of which every embedding counted is two.
  const std::int64_t log_norm = 2 * std::accumulate(bounds.begin(), bounds.end(), std::int64_t{0});
  bool zero = true;
  std::int64_t log_primes = 0;
  for (std::size_t i = 0; zero && log_primes <= log_norm; ++i) {
    budget.spend(10, steps.size());
    const RegularRing::Residues& residues = x.ring->residues(i);
    zero = evaluate(steps, residues).x == 0;
    log_primes += log_rounded_down(residues.prime());
  }
  if (zero) return 0;
  // The number is not 0, so some precision tells its sign.
  Tri positive = Tri::unknown;
  const auto attempt = [&](slong precision) {
    const auto bits = static_cast<std::uint64_t>(precision);
    budget.spend(function_work(bits) + memory_work(bits / 4), steps.size());
    const ComplexBall value = evaluate(steps, Balls(*x.ring, precision));
    positive = certainly_positive(value.re());
    return positive != Tri::unknown;
  };
  with_rising_precision(std::numeric_limits<slong>::max() / 2, attempt, 128);
  return positive == Tri::yes ? 1 : -1;
}

void set_regular_apothem(arb_ptr cosh, arb_ptr sinh, std::uint32_t genus, slong precision) {
  arb_const_pi(cosh, precision);
  arb_div_ui(cosh, cosh, 4 * static_cast<ulong>(genus), precision);
  arb_cot(cosh, cosh, precision);
  arb_sqr(sinh, cosh, precision);
  arb_sub_ui(sinh, sinh, 1, precision);
  arb_sqrt(sinh, sinh, precision);
}

void set_regular_direction(acb_ptr result, std::uint32_t genus, std::uint32_t k, slong precision) {
  fmpq_t turns;
  fmpq_init(turns);
  fmpq_set_si(turns, k, 2 * static_cast<ulong>(genus));
  arb_sin_cos_pi_fmpq(acb_imagref(result), acb_realref(result), turns, precision);
  fmpq_clear(turns);
}

}  // namespace epsnet::certify
