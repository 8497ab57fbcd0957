#include "certify/claims/eigenvalues/local_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epsnet::certify {
namespace {

__extension__ using Wide = __int128;

constexpr int kBits = 61;       ///< Of radial factors, after the point;
constexpr int kValueBits = 62;  ///< of values and z.
/// For all that bounds of errors leave out: products of two of them, and their own rounding.
constexpr double kLeftOut = 1 + 0x1p-15;
constexpr double kGreatestError = 0x1p20;

/// x·2^bits, less than 1 away; nothing if x is not known so well, or too large.
std::optional<std::int64_t> in_units(const Ball& x, slong bits) {
  if (!is_finite(x) || arf_cmpabs_2exp_si(arb_midref(x.get()), 64 - bits) >= 0) return std::nullopt;
  if (mag_cmp_2exp_si(arb_radref(x.get()), -bits - 2) > 0) return std::nullopt;
  const Ball units = scaled(x, bits);
  Integer result;
  arf_get_fmpz(result.get(), arb_midref(units.get()), ARF_RND_NEAR);
  return fmpz_fits_si(result.get()) != 0 ? std::optional<std::int64_t>(fmpz_get_si(result.get())) : std::nullopt;
}

/// x·2^−bits, at most ½ away.
std::int64_t shifted(Wide x, int bits) { return static_cast<std::int64_t>((x + (Wide{1} << (bits - 1))) >> bits); }

/// ₂F₁(½ − ir, ½ + ir; m + 1; −x), λ = ¼ + r², for x ≤ X ≤ 1, as a polynomial of x/X, which is at most
/// `greatest_ratio`. The terms alternate and, from (i + 1)(m + 1) ≥ λ on, decrease, so what is left is less than the
/// first term that is left out.
std::optional<std::vector<std::int64_t>> series(const Ball& lambda, std::uint32_t m, const Ball& most,
                                                const Ball& greatest_ratio) {
  constexpr std::uint64_t kMostTerms = 500;
  std::vector<std::int64_t> result;
  Ball term = Ball::exactly(1);
  Ball power = Ball::exactly(1);  // Of the greatest ratio.
  double sum = 0;
  for (std::uint64_t i = 0; i < kMostTerms; ++i) {
    const bool decreasing = certainly_less(lambda, Ball::exactly(i * (std::uint64_t{m} + 1))) == Tri::yes;
    if (decreasing && certainly_less(abs(term) * power, scaled(Ball::exactly(1), -kBits)) == Tri::yes) return result;
    const auto coefficient = in_units(term, kBits);
    if (!coefficient) return std::nullopt;
    sum += std::abs(std::ldexp(static_cast<double>(*coefficient), -kBits));
    if (!(sum < 2.9)) return std::nullopt;
    result.push_back(*coefficient);
    power = power * greatest_ratio;
    term = -(term * most) * (lambda + i * (i + 1)) / ((i + 1) * (std::uint64_t{m} + 1 + i));
  }
  return std::nullopt;
}

/// In units: ½ for the rounding of each step, 1 for its coefficient, 3 for x/X, with which sums of at most 3 are
/// multiplied; and 1 for what is left.
double error_of_series(std::size_t terms, double greatest_ratio) {
  double error = 0;
  for (std::size_t i = 0; i < terms; ++i) error = error * greatest_ratio + 4.5;
  return error + 1;
}

/// X for points with this s₀.
Ball greatest_argument(const Ball& greatest) { return min(Ball::exactly(1), twice(greatest / (1 - greatest))); }

std::int64_t value(const std::vector<std::int64_t>& polynomial, std::int64_t x) {
  std::int64_t sum = 0;
  for (std::size_t i = polynomial.size(); i-- > 0;) sum = shifted(Wide{sum} * x, kBits) + polynomial[i];
  return sum;
}

}  // namespace

std::optional<LocalPoint> LocalPoint::of(const ComplexBall& z, const Ball& greatest) {
  const Ball s = norm(z);
  if (certainly_less(greatest, s) != Tri::no) return std::nullopt;
  const Ball scale = rsqrt(greatest);
  const auto x = in_units(real(z) * scale, kValueBits);
  const auto y = in_units(imaginary(z) * scale, kValueBits);
  const auto units = in_units(s, kBits);
  const auto ratio = in_units(s / (1 - s) / greatest_argument(greatest), kBits);
  if (!x || !y || !units || !ratio) return std::nullopt;
  return LocalPoint{*x, *y, *units, *ratio};
}

std::optional<RadialFactors> RadialFactors::make(const Ball& lambda, std::uint32_t order, const Ball& greatest) {
  const auto less = [](const Ball& x, const Ball& y) { return certainly_less(x, y) == Tri::yes; };
  if (certainly_less(half(Ball::exactly(1)), greatest) != Tri::no) return std::nullopt;
  if (!less(lambda, Ball::exactly(65'536)) || !less(lambda * greatest, Ball::exactly(7))) return std::nullopt;
  const Ball most = greatest_argument(greatest);
  const Ball greatest_ratio = greatest / (1 - greatest) / most;
  auto last = series(lambda, order, most, greatest_ratio);
  auto next = series(lambda, order + 1, most, greatest_ratio);
  if (!last || !next) return std::nullopt;
  RadialFactors result;
  result.last_ = *std::move(last);
  result.next_ = *std::move(next);
  const double lambda_above = outer_interval(lambda).upper;
  result.weight_bits_ = kBits;
  while (std::ldexp(lambda_above, result.weight_bits_) >= 0x1p62) --result.weight_bits_;
  for (std::uint64_t m = 1; m <= order; ++m) {
    const auto weight = in_units(lambda / (m * (m + 1)), result.weight_bits_);
    if (!weight) return std::nullopt;
    result.weights_.push_back(*weight);
  }
  // Of F_m, F_{m + 1}, and F_m − F_{m + 1}.
  const double ratio = outer_interval(greatest_ratio).upper;
  double own = error_of_series(result.last_.size(), ratio);
  double after = error_of_series(result.next_.size(), ratio);
  double difference = own + after;
  const double s = outer_interval(greatest).upper;
  std::vector<double> errors{own};
  for (double m = order; m > 0; --m) {
    const double weight = lambda_above / (m * (m + 1));
    const double of_product = weight + s * std::ldexp(1, kBits - result.weight_bits_) + 0.5;
    difference = (s * difference + 2 + s * weight * after + of_product + 0.5) * kLeftOut;
    after = own;
    own = (own + difference) * kLeftOut;
    errors.push_back(own);
    if (!(own <= kGreatestError)) return std::nullopt;
  }
  result.errors_.assign(errors.rbegin(), errors.rend());
  return result;
}

void RadialFactors::set(const LocalPoint& point, std::vector<std::int64_t>& factors) const {
  const std::size_t order = weights_.size();
  factors.resize(order + 1);
  std::int64_t after = value(next_, point.ratio);
  std::int64_t own = value(last_, point.ratio);
  std::int64_t difference = own - after;
  factors[order] = own;
  for (std::size_t m = order; m > 0; --m) {
    const std::int64_t product = shifted(Wide{point.s} * weights_[m - 1], weight_bits_);
    difference = shifted(Wide{point.s} * difference - Wide{product} * after, kBits);
    after = own;
    own += difference;
    factors[m - 1] = own;
  }
}

std::optional<LocalValues> LocalValues::make(const EigenvaluesDocument::Eigenfunctions& row, std::size_t vertices,
                                             const Ball& greatest) {
  const std::size_t each = row.functions.front().size() / vertices;
  const std::size_t order = each / 2;
  auto factors = RadialFactors::make(Ball::exactly(row.lambda), static_cast<std::uint32_t>(order), greatest);
  if (!factors) return std::nullopt;
  LocalValues result(*std::move(factors));
  std::vector<Ball> powers{Ball::exactly(1)};
  std::vector<double> powers_above{1};
  for (std::size_t m = 1; m <= order; ++m) {
    powers.push_back(powers.back() * sqrt(greatest));
    powers_above.push_back(outer_interval(powers.back()).upper);
  }
  const std::size_t count = row.functions.size();
  result.coefficients_.resize(vertices * count * (order + 1));
  for (std::size_t j = 0; j < count; ++j) {
    const EigenvaluesDocument::Coefficients& given = row.functions[j];
    const auto alpha = [&](std::size_t vertex, std::size_t m) {
      return given[vertex * each + (m == 0 ? 0 : 2 * m - 1)];
    };
    const auto beta = [&](std::size_t vertex, std::size_t m) { return m == 0 ? 0 : given[vertex * each + 2 * m]; };
    // So that the sum of the sizes of a vertex's coefficients is less than 1.
    double most = 0;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
      double sum = 0;
      for (std::size_t m = 0; m <= order; ++m)
        sum += (std::abs(alpha(vertex, m)) + std::abs(beta(vertex, m))) * powers_above[m];
      most = std::max(most, sum * kLeftOut);
    }
    if (!(most < 0x1p500)) return std::nullopt;
    const int exponent = std::ilogb(std::max(most, 0x1p-500)) + 1;
    Scale scale{std::ldexp(1, exponent - kValueBits), {}};
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
      double error = 3 * (static_cast<double>(order) + 1);
      for (std::size_t m = 0; m <= order; ++m) {
        const auto in = [&](double x) { return in_units(Ball::exactly(x) * powers[m], kValueBits - exponent); };
        const auto real = in(alpha(vertex, m));
        const auto imaginary = in(-beta(vertex, m));
        if (!real || !imaginary) return std::nullopt;
        result.coefficients_[(vertex * count + j) * (order + 1) + m] = {*real, *imaginary};
        const double size = std::ldexp(
            std::abs(static_cast<double>(*real)) + std::abs(static_cast<double>(*imaginary)) + 2, -kValueBits);
        error += size * (1.5 * static_cast<double>(m) + 2 * result.factors_.errors()[m]);
      }
      scale.errors.push_back(error * kLeftOut);
    }
    result.scales_.push_back(std::move(scale));
  }
  return result;
}

void LocalValues::set(std::size_t vertex, const LocalPoint& point, const std::vector<std::int64_t>& factors,
                      std::vector<std::int64_t>& values) const {
  const std::size_t each = factors.size();
  values.resize(count());
  for (std::size_t j = 0; j < values.size(); ++j) {
    const Coefficient* own = coefficients_.data() + (vertex * values.size() + j) * each;
    std::int64_t real = 0;
    std::int64_t imaginary = 0;
    for (std::size_t m = each; m-- > 0;) {
      // A factor has one bit less after the point.
      const Wide factor = Wide{factors[m]} << (kValueBits - kBits);
      const Wide next = Wide{real} * point.x - Wide{imaginary} * point.y + factor * own[m].real;
      imaginary = shifted(Wide{real} * point.y + Wide{imaginary} * point.x + factor * own[m].imaginary, kValueBits);
      real = shifted(next, kValueBits);
    }
    values[j] = real;
  }
}

}  // namespace epsnet::certify
