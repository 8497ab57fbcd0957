#include "certify/exact/trace_formula.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epsnet::exact {
namespace {

constexpr double kBits = 260;  ///< Series are summed until the rest is so much smaller.

/// C = cos(δr) and s = sinc(δr/2) for λ = ¼ + r²; both decrease in λ, as δr < π (Lemma 34).
struct Factors {
  Interval cosine;
  Interval sinc;
};
Factors factors(const Interval& step, const mpq_class& lambda) {
  const mpq_class square = lambda - mpq_class(1, 4);
  if (square == 0) return {1, 1};
  const Interval x = step * sqrt(Interval(abs(square)));
  const Interval half = x / 2;
  return square < 0 ? Factors{cosh(x), sinh(half) / half} : Factors{cos(x), sin(half) / half};
}

/// The coefficients of the polynomial in another variable, x = middle + y.
std::vector<Interval> shifted(std::vector<Interval> polynomial, const Interval& middle) {
  for (std::size_t i = 0; i + 1 < polynomial.size(); ++i) {
    for (std::size_t k = polynomial.size() - 1; k-- > i;) {
      polynomial[k] = polynomial[k] + middle * polynomial[k + 1];
    }
  }
  return polynomial;
}

/// Piece i of the centred cardinal B-spline of order n: the coefficients of the powers of x, where the spline is asked
/// at i − n/2 + centre + x. It is Σ (−1)^k C(n, k) (i − k + centre + x)^(n−1)/(n − 1)!, k <= i.
std::vector<Interval> spline_piece(unsigned long n, unsigned long i, const mpq_class& centre) {
  std::vector<Interval> result;
  const mpz_class factorial = mpz_class::factorial(n - 1);
  for (unsigned long power = 0; power < n; ++power) {
    mpq_class sum = 0;
    for (unsigned long k = 0; k <= i; ++k) {
      mpz_class choices;
      mpz_bin_uiui(choices.get_mpz_t(), n, k);
      mpq_class term = k % 2 == 0 ? choices : mpz_class(-choices);
      for (unsigned long e = power; e < n - 1; ++e) term *= i - k + centre;
      sum += term;
    }
    mpz_class choices;
    mpz_bin_uiui(choices.get_mpz_t(), n - 1, power);
    result.emplace_back(mpq_class(sum * choices / factorial));
  }
  return result;
}

/// Σ c_k T_k, by powers.
std::vector<Interval> by_powers(const Coefficients& coefficients) {
  std::vector<mpz_class> t{1};  // T_k, and the next one.
  std::vector<mpz_class> next{0, 1};
  std::vector<mpq_class> sum(coefficients.size());
  for (const mpq_class& c : coefficients) {
    for (std::size_t i = 0; i < t.size(); ++i) sum[i] += c * t[i];
    std::vector<mpz_class> after(next.size() + 1);
    for (std::size_t i = 0; i < next.size(); ++i) after[i + 1] = 2 * next[i];
    for (std::size_t i = 0; i < t.size(); ++i) after[i] -= t[i];
    t = std::move(next);
    next = std::move(after);
  }
  return {sum.begin(), sum.end()};
}

/// a_0, …, a_2K with (Σ c_k cos kx)² = Σ a_m cos mx.
std::vector<Interval> squared(const Coefficients& coefficients) {
  std::vector<mpq_class> sum(2 * coefficients.size() - 1);
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      const mpq_class half = coefficients[j] * coefficients[k] / 2;
      sum[j + k] += half;
      sum[std::max(j, k) - std::min(j, k)] += half;
    }
  }
  return {sum.begin(), sum.end()};
}

/// ¼ G − G″/δ², of a polynomial of u/δ.
std::vector<Interval> times_lambda(const std::vector<Interval>& polynomial, const Interval& squared_step) {
  std::vector<Interval> result;
  for (std::size_t i = 0; i < polynomial.size(); ++i) {
    result.push_back(polynomial[i] / 4);
    if (i + 2 < polynomial.size()) {
      const auto factor = static_cast<long>((i + 1) * (i + 2));
      result.back() = result.back() - factor * polynomial[i + 2] / squared_step;
    }
  }
  return result;
}

/// The coefficients of 1/Σ series[k] x^k.
std::vector<Interval> reciprocal(const std::vector<Interval>& series) {
  std::vector<Interval> result{1 / series[0]};
  for (std::size_t k = 1; k < series.size(); ++k) {
    Interval sum;
    for (std::size_t i = 1; i <= k; ++i) sum = sum + series[i] * result[k - i];
    result.push_back(-sum / series[0]);
  }
  return result;
}

}  // namespace

mpq_class step_of(const EigenvaluesDocument& document) {
  return document.spectrum.up_to / (2 * document.degree + document.order / 2);
}

TestFunction::TestFunction(const EigenvaluesDocument& document, const Coefficients& coefficients)
    : step_(step_of(document)), order_(document.order), polynomial_(by_powers(coefficients)) {}

Interval TestFunction::squared_on(const Range& lambda) const {
  const Factors low = factors(step_, lambda[0]);
  const Factors high = factors(step_, lambda[1]);
  const Interval x = hull(low.cosine, high.cosine);
  const Interval centre = middle(x);
  const std::vector<Interval> polynomial = shifted(polynomial_, centre);
  Interval value;
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * (x - centre) + polynomial[i];
  return power(hull(low.sinc, high.sinc), order_) * square(value);
}

TraceFormula::TraceFormula(const EigenvaluesDocument& document, const std::vector<Interval>& lengths, long minus_euler)
    : document_(document),
      step_(step_of(document)),
      pieces_(2 * document.degree + document.order / 2),
      form_(pieces_, std::vector<Interval>(document.order)) {
  for (unsigned long i = 0; i < document.order; ++i) {
    splines_[0].push_back(spline_piece(document.order, i, 0));
    splines_[1].push_back(spline_piece(document.order, i, mpq_class(1, 2)));
  }
  for (const Interval& length : lengths) add_length(length);
  for (std::size_t j = 0; j < pieces_; ++j) add_integral(j, minus_euler);
}

/// ℓ/sinh(kℓ/2)·G(kℓ) for all multiples up to L.
void TraceFormula::add_length(const Interval& length) {
  const auto end = static_cast<long>(pieces_);
  for (long k = 1;; ++k) {
    if (--terms_left_ < 0) throw TooLarge{"too many multiples of closed geodesics are not longer than L"};
    const Interval place = k * length / step_;
    if (is_less(end, place) == Answer::yes) return;
    const double lower = place.lower();
    const long j = lower >= 0 && lower < static_cast<double>(end) ? static_cast<long>(lower) : -1;
    if (j < 0 || both(is_less(j, place), is_less(place, j + 1)) != Answer::yes)
      throw TooLarge{"a length is nearly one where a spline has a knot"};
    const Interval x = j == 0 ? place : place - j - Interval(1) / 2;
    Interval term = length / sinh(k * length / 2);
    for (Interval& entry : form_[static_cast<std::size_t>(j)]) {
      entry = entry + term;
      term = term * x;
    }
  }
}

/// −2(g − 1) ∫ G′(u)/sinh(u/2) du over a piece (Lemma 33).
void TraceFormula::add_integral(std::size_t j, long minus_euler) {
  const bool at_zero = j == 0;
  // The series of 1/sinh((j + ½ + x)δ/2), |x| <= ½, or of x/sinh(xδ/2), 0 <= x <= 1, if j = 0. Its terms are at most
  // most·ratio^k.
  const Interval most = at_zero ? Interval::pi() / step_ : 1 / sinh(step_ / 4);
  const Interval ratio = at_zero ? step_ / Interval::pi() : Interval(1) / static_cast<long>(2 * j);
  const auto terms = static_cast<long>(kBits / -std::log2(ratio.upper())) + 2;
  const Interval slope = step_ / 2;
  const Interval centre = static_cast<long>(2 * j + 1) * step_ / 4;
  const std::array<Interval, 2> derivatives{at_zero ? slope : sinh(centre), at_zero ? Interval() : cosh(centre)};
  std::vector<Interval> denominator;
  Interval factor = 1;
  for (long k = 0; k < terms; ++k) {
    denominator.push_back(factor * derivatives.at(static_cast<std::size_t>(k % 2)));
    factor = factor * slope / (at_zero ? k + 2 : k + 1);
  }
  const std::vector<Interval> series = reciprocal(denominator);
  const Interval rest = most * power(ratio, static_cast<unsigned long>(terms)) / (1 - ratio);
  // ∫ x^i times it.
  const auto integral = [&](long i) {
    Interval sum = hull(-rest, rest);
    Interval scale = at_zero ? Interval(1) : power(Interval(1) / 2, static_cast<unsigned long>(i));
    for (long k = 0; k < terms; ++k) {
      if (at_zero || (i + k) % 2 == 0) sum = sum + series[static_cast<std::size_t>(k)] * scale / (i + k + 1);
      if (!at_zero) scale = scale / 2;
    }
    return sum;
  };
  // The derivative of x^i is i x^(i−1). G is even: around 0 it has no term for i = 1.
  const long first = at_zero ? 2 : 1;
  for (long i = first; i < static_cast<long>(document_.order); ++i) {
    Interval& entry = form_[j][static_cast<std::size_t>(i)];
    entry = entry - minus_euler * i * integral(i - first);
  }
}

TraceFormula::Piecewise TraceFormula::transform(const Coefficients& coefficients) const {
  Piecewise result(pieces_, std::vector<Interval>(document_.order));
  const std::vector<Interval> a = squared(coefficients);
  const long half_order = static_cast<long>(document_.order) / 2;
  for (std::size_t m = 0; m < a.size(); ++m) {
    const Interval weight = a[m] / (2 * step_);
    for (const long centre : {static_cast<long>(m), -static_cast<long>(m)}) {
      for (long i = 0; i < 2 * half_order; ++i) {
        const long j = centre - half_order + i;
        if (j < 0) continue;
        const std::vector<Interval>& spline = splines_.at(j == 0 ? 0 : 1)[static_cast<std::size_t>(i)];
        std::vector<Interval>& piece = result[static_cast<std::size_t>(j)];
        for (std::size_t power = 0; power < spline.size(); ++power)
          piece[power] = piece[power] + weight * spline[power];
      }
    }
  }
  return result;
}

std::array<Interval, 3> TraceFormula::sums(const Coefficients& coefficients) const {
  Piecewise function = transform(coefficients);
  std::array<Interval, 3> result;
  for (Interval& sum : result) {
    for (std::size_t j = 0; j < pieces_; ++j) {
      for (std::size_t i = 0; i < document_.order; ++i) sum = sum + form_[j][i] * function[j][i];
      function[j] = times_lambda(function[j], square(step_));
    }
  }
  // λ = 0 belongs to the formula.
  result[0] = result[0] - TestFunction(document_, coefficients).squared_on({0, 0});
  return result;
}

}  // namespace epsnet::exact
