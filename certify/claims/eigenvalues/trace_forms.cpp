#include "certify/claims/eigenvalues/trace_forms.h"

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif
#include <bit>
#include <cmath>
#include <utility>

#include "certify/base/counted.h"
#include "certify/base/lookup.h"

namespace epsnet::certify {
namespace {

struct SeriesType {
  using Struct = arb_poly_struct;
  static void init(arb_poly_t x) { arb_poly_init(x); }
  static void set(arb_poly_t x, const arb_poly_t y) { arb_poly_set(x, y); }
  static void swap(arb_poly_t x, arb_poly_t y) { arb_poly_swap(x, y); }
  static void clear(arb_poly_t x) { arb_poly_clear(x); }
};
using Series = Owner<SeriesType>;

/// The first coefficients of 1/sinh(c + x·slope), or of x/sinh(x·slope) for c = 0.
std::vector<Ball> reciprocal_sinh(const Ball& c, const Ball& slope, slong terms) {
  const bool at_zero = is_exactly_zero(c);
  Series series;
  arb_poly_set_coeff_arb(series.get(), 0, c.get());
  arb_poly_set_coeff_arb(series.get(), 1, slope.get());
  arb_poly_sinh_series(series.get(), series.get(), terms + 1, Precision::bits());
  if (at_zero) arb_poly_shift_right(series.get(), series.get(), 1);
  arb_poly_inv_series(series.get(), series.get(), terms, Precision::bits());
  std::vector<Ball> result(static_cast<std::size_t>(terms));
  for (slong i = 0; i < terms; ++i) arb_poly_get_coeff_arb(result[static_cast<std::size_t>(i)].get(), series.get(), i);
  return result;
}

/// A ball around x with this additional error.
Ball widened(Ball x, const Ball& error) {
  arb_add_error(x.get(), error.get());
  return x;
}

/// Σ terms of a geometric series from number `first` on: most·ratio^first/(1 − ratio).
Ball geometric_tail(const Ball& most, const Ball& ratio, slong first) {
  Ball power;
  arb_pow_ui(power.get(), ratio.get(), static_cast<ulong>(first), Precision::bits());
  return most * power / (1 - ratio);
}

/// The integrals of t^i/sinh((j + t)δ/2) over 0 ≤ t ≤ 1, i = 0, …, count − 1; that for j = 0, i = 0, which is infinite,
/// is left 0 and not used (Lemma 33).
std::vector<Ball> piece_integrals(std::uint32_t j, const Ball& step, std::size_t count) {
  const slong bits = Precision::bits();
  std::vector<Ball> result(count);
  if (j == 0) {
    const Ball ratio = step / pi();
    const auto terms = static_cast<slong>(static_cast<double>(bits) / -std::log2(outer_interval(ratio).upper)) + 2;
    const std::vector<Ball> series = reciprocal_sinh(Ball(), half(step), terms);
    const Ball error = geometric_tail(pi() / step, ratio, terms);
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t k = 0; k < series.size(); ++k) result[i] += series[k] / (i + k);
      result[i] = widened(result[i], error);
    }
    return result;
  }
  const slong terms = bits / static_cast<slong>(std::bit_width(j)) + 2;
  std::vector<Ball> series = reciprocal_sinh(j * half(step) + scaled(step, -2), half(step), terms);
  const Ball error = geometric_tail(1 / sinh(scaled(step, -2)), 1 / Ball::exactly(2 * j), terms);
  for (std::size_t i = 0; i < count; ++i) {
    // The integral from −1/2 to 1/2 of the series, which then is multiplied by t = 1/2 + x.
    for (std::size_t k = 0; k < series.size(); k += 2) result[i] += scaled(series[k], -static_cast<slong>(k)) / (k + 1);
    result[i] = widened(result[i], error);
    series.emplace_back();
    for (std::size_t k = series.size(); k-- > 0;)
      series[k] = k == 0 ? half(series[k]) : half(series[k]) + series[k - 1];
  }
  return result;
}

mpz_class factorial(std::uint32_t n) {
  mpz_class result;
  mpz_fac_ui(result.get_mpz_t(), n);
  return result;
}

mpz_class binomial(std::uint32_t n, std::uint32_t k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), n, k);
  return result;
}

/// The centred cardinal B-spline of even order n: row i has the coefficients of the polynomial of t on
/// i − n/2 + t, 0 ≤ t ≤ 1.
std::vector<std::vector<Ball>> spline(std::uint32_t n) {
  std::vector<std::vector<Ball>> result(n, std::vector<Ball>(n));
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t power = 0; power < n; ++power) {
      // (−1)^k C(n, k) (i − k + t)^{n−1} for all k ≤ i.
      mpz_class sum = 0;
      for (std::uint32_t k = 0; k <= i; ++k) {
        mpz_class term;
        mpz_ui_pow_ui(term.get_mpz_t(), i - k, n - 1 - power);
        term *= binomial(n, k) * binomial(n - 1, power);
        sum += k % 2 == 0 ? term : mpz_class(-term);
      }
      result[i][power] = Ball::rounded(mpq_class(sum, factorial(n - 1)));
    }
  }
  return result;
}

/// By piece j and power i: what the trace formula takes of t^i, where u = (j + t)δ, for lengths and integral together.
using Functional = std::vector<std::vector<Ball>>;

/// Adds ℓ/sinh(kℓ/2)·t^i for all multiples kℓ = (j + t)δ of a length on the pieces. False if it is not certain on which
/// piece one lies.
bool add_length(Functional& functional, const Ball& length, const Ball& step, const Budget& budget) {
  const auto operations = functional.front().size() + 4;
  for (slong k = 1;; ++k) {
    budget.spend(2 * function_work(static_cast<std::uint64_t>(Precision::bits())), operations / 8 + 1);
    const Ball multiple = k * length;
    const Ball place = multiple / step;
    Ball floor;
    arb_floor(floor.get(), place.get(), Precision::bits());
    const std::optional<slong> j = only_integer(floor);
    if (!j || *j < 0) return false;
    if (static_cast<std::size_t>(*j) >= functional.size()) return true;
    const Ball t = place - *j;
    Ball term = length / sinh(half(multiple));
    for (Ball& entry : functional[static_cast<std::size_t>(*j)]) {
      entry += term;
      term = term * t;
    }
  }
}

/// τⁿ_m for m = 0, …, count − 1 (Lemma 32).
std::vector<Ball> moments(const Functional& functional, const Ball& step, std::uint32_t order, std::size_t count) {
  const std::vector<std::vector<Ball>> rows = spline(order);
  const auto at = [&](std::size_t m, bool mirrored, std::size_t row) -> const std::vector<Ball>* {
    // The spline around m, or around −m.
    const auto j = static_cast<std::ptrdiff_t>(row) - order / 2 +
                   (mirrored ? -static_cast<std::ptrdiff_t>(m) : static_cast<std::ptrdiff_t>(m));
    return j >= 0 && j < static_cast<std::ptrdiff_t>(functional.size()) ? &functional[static_cast<std::size_t>(j)]
                                                                        : nullptr;
  };
  const Ball quarter = scaled(step, -2);
  Ball at_zero;
  arb_pow_ui(at_zero.get(), (sinh(quarter) / quarter).get(), order, Precision::bits());
  std::vector<Ball> result;
  for (std::size_t m = 0; m < count; ++m) {
    Ball sum;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (const bool mirrored : {false, true}) {
        const std::vector<Ball>* const piece = at(m, mirrored, row);
        for (std::size_t i = 0; piece != nullptr && i < rows[row].size(); ++i) sum += rows[row][i] * (*piece)[i];
      }
    }
    result.push_back(sum / twice(step) - at_zero * cosh(m * half(step)));
  }
  return result;
}

/// τ_m − ½(τ_{m+1} + τ_{m−1}), one term less; τ_{−1} = τ₁.
std::vector<Ball> second_differences(const std::vector<Ball>& tau) {
  std::vector<Ball> result;
  for (std::size_t m = 0; m + 1 < tau.size(); ++m)
    result.push_back(tau[m] - half(tau[m + 1] + tau[m == 0 ? 1 : m - 1]));
  return result;
}

}  // namespace

std::vector<Ball> squared_cosine_sum(std::span<const double> coefficients) {
  std::vector<Ball> result(2 * coefficients.size() - 1);
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      const Ball product = half(Ball::exactly(coefficients[j]) * Ball::exactly(coefficients[k]));
      result[j + k] += product;
      result[j < k ? k - j : j - k] += product;
    }
  }
  return result;
}

std::optional<TraceForms> TraceForms::of(const TestFunctions& functions, std::uint32_t genus,
                                         std::span<const Ball> lengths, const Budget& budget) {
  const auto bits = static_cast<std::uint64_t>(Precision::bits());
  const std::uint32_t order = functions.order;
  const std::size_t count = 2 * std::size_t{functions.degree} + 1;
  budget.spend(ball_work(bits), functions.pieces() * (bits * 64 + 16 * std::uint64_t{order} * order));
  const Ball step = Ball::rounded(functions.step());
  Functional functional(functions.pieces(), std::vector<Ball>(order));
  for (const Ball& length : lengths) {
    if (!add_length(functional, length, step, budget)) return std::nullopt;
  }
  for (std::uint32_t j = 0; j < functions.pieces(); ++j) {
    const std::vector<Ball> integrals = piece_integrals(j, step, order - 1);
    for (std::uint32_t i = 1; i < order; ++i)
      functional[j][i] += Ball::exactly(-2 * (slong{genus} - 1) * i) * integrals[i - 1];
  }
  const std::vector<Ball> tau = moments(functional, step, order, count);
  const std::vector<Ball> first = second_differences(moments(functional, step, order - 2, count + 1));
  const std::vector<Ball> second =
      second_differences(second_differences(moments(functional, step, order - 4, count + 2)));
  const Ball q = 2 / sqr(step);
  std::array<std::vector<Ball>, 3> result;
  for (std::size_t m = 0; m < count; ++m) {
    result[0].push_back(tau[m]);
    result[1].push_back(scaled(tau[m], -2) + q * first[m]);
    result[2].push_back(scaled(tau[m], -4) + half(q) * first[m] + sqr(q) * second[m]);
  }
  return TraceForms(std::move(result));
}

std::array<Ball, 3> TraceForms::operator()(std::span<const double> coefficients) const {
  const std::vector<Ball> squares = squared_cosine_sum(coefficients);
  std::array<Ball, 3> result;
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t m = 0; m < squares.size(); ++m)
      result[p] += squares[m] * looked_up(moments_[p], m, "there is no moment");
  }
  return result;
}

RuleReport traces_report(std::span<const std::array<Ball, 3>> sums) {
  for (const auto& sum : sums) {
    if (certain_sign(sum[0]) < 0) {
      return {"traces", Verdict::refuted,
              "a sum of squares over the eigenvalues would be negative: the list of geodesics cannot be complete"};
    }
  }
  for (const auto& sum : sums) {
    if (certain_sign(sum[0]) == 0) return {"traces", Verdict::undecided, "not decided whether a sum is positive"};
  }
  return {"traces", Verdict::verified,
          counted(sums.size(), "sum of squares is positive", "sums of squares are positive")};
}

}  // namespace epsnet::certify
