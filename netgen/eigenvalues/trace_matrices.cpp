#include "netgen/eigenvalues/trace_matrices.h"

#include <cmath>
#include <utility>

#include "kernel/isometry.h"

namespace epsnet {
namespace {

/// The nodes and weights of Gauss and Legendre on [0, 1].
std::vector<std::pair<Real, Real>> gauss_legendre(int count) {
  const Real pi = boost::multiprecision::acos(Real(-1));
  std::vector<std::pair<Real, Real>> result;
  for (int i = 0; i < count; ++i) {
    Real x = boost::multiprecision::cos(pi * (i + Real(3) / 4) / (count + Real(1) / 2));
    Real slope = 1;
    for (int round = 0; round < 8; ++round) {
      Real last = 1;
      Real value = x;
      for (int k = 2; k <= count; ++k) last = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * last) / k);
      slope = count * (x * value - last) / (x * x - 1);
      x -= value / slope;
    }
    result.emplace_back((1 + x) / 2, 1 / ((1 - x * x) * slope * slope));
  }
  return result;
}

/// Sums of the splines β_n(x − m) + β_n(x + m), m = 0, 1, …, at weighted points x ≥ 0; and of their derivatives.
class SplineSums {
 public:
  SplineSums(std::uint32_t order, std::size_t count) : order_(order), sums_(count) {}

  void add(const Real& x, const Real& weight) { add(x, weight, splines(order_, fraction(x))); }
  void add_derivative(const Real& x, const Real& weight) {
    const RealVector lower = splines(order_ - 1, fraction(x));
    RealVector slopes(order_);
    for (std::size_t i = 0; i < order_; ++i)
      slopes[i] = (i < lower.size() ? lower[i] : Real(0)) - (i > 0 ? lower[i - 1] : Real(0));
    add(x, weight, slopes);
  }
  [[nodiscard]] const RealVector& sums() const { return sums_; }

 private:
  static Real fraction(const Real& x) { return x - boost::multiprecision::floor(x); }

  /// The B-spline of knots 0, 1, …, order, at t + i for all i.
  static RealVector splines(std::uint32_t order, const Real& t) {
    RealVector result{1};
    for (std::uint32_t n = 2; n <= order; ++n) {
      RealVector next(n);
      for (std::uint32_t i = 0; i < n; ++i) {
        if (i + 1 < n) next[i] += (t + i) * result[i];
        if (i > 0) next[i] += (n - i - t) * result[i - 1];
        next[i] /= n - 1;
      }
      result = std::move(next);
    }
    return result;
  }

  void add(const Real& x, const Real& weight, const RealVector& values) {
    const auto piece = static_cast<std::int64_t>(boost::multiprecision::floor(x)) + order_ / 2;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::int64_t shift = piece - static_cast<std::int64_t>(i);
      const auto m = static_cast<std::size_t>(std::abs(shift));
      if (m < sums_.size()) sums_[m] += (m == 0 ? 2 : 1) * weight * values[i];
    }
  }

  std::uint32_t order_;
  RealVector sums_;
};

/// The sums over λ ≠ 0 of sinc(δr/2)ⁿ cos(mδr), m = 0, …, count − 1.
RealVector cosine_sums(const TestSpace& space, std::uint32_t order, std::size_t count, std::uint32_t genus,
                       const RealVector& lengths) {
  using boost::multiprecision::cosh;
  using boost::multiprecision::sinh;
  constexpr int kNodes = 48;
  const Real step = space.step();
  SplineSums sums(order, count);
  for (const Real& length : lengths) {
    for (Real multiple = length; multiple < space.support; multiple += length)
      sums.add(multiple / step, length / sinh(multiple / 2));
  }
  const Real area = -2 * (Real(genus) - 1);
  for (const auto& [node, weight] : gauss_legendre(kNodes)) {
    for (std::uint32_t j = 0; j < 2 * space.degree + space.order / 2; ++j) {
      const Real x = j + node;
      sums.add_derivative(x, area * weight / sinh(x * step / 2));
    }
  }
  const Real at_zero = boost::multiprecision::pow(sinh(step / 4) / (step / 4), order);
  RealVector result;
  for (std::size_t m = 0; m < count; ++m) result.push_back(sums.sums()[m] / (2 * step) - at_zero * cosh(m * step / 2));
  return result;
}

RealVector differences(const RealVector& x) {
  RealVector result;
  for (std::size_t m = 0; m + 1 < x.size(); ++m) result.push_back(x[m] - (x[m + 1] + x[m == 0 ? 1 : m - 1]) / 2);
  return result;
}

}  // namespace

RealVector lengths_of(const Surface& surface, const certify::GeodesicsDocument& spectrum) {
  std::vector<Isometry<Real>> crossings;
  for (const SideId s : surface.side_ids()) crossings.push_back(surface.crossing_as<Real>(s));
  RealVector result;
  for (const auto& geodesic : spectrum.geodesics) {
    Isometry<Real> product = crossings[geodesic.word.front()];
    for (std::size_t i = 1; i < geodesic.word.size(); ++i) product = crossings[geodesic.word[i]] * product;
    result.push_back(displacement_length(product));
  }
  return result;
}

RealVector TestSpace::values(const Real& lambda) const {
  using boost::multiprecision::abs;
  using boost::multiprecision::sqrt;
  const Real square = lambda - Real(1) / 4;
  const Real x = step() * sqrt(abs(square));
  const bool real = square >= 0;
  const Real half = x / 2;
  const Real cosine = real ? boost::multiprecision::cos(x) : boost::multiprecision::cosh(x);
  Real sinc = 1;
  if (x != 0) sinc = (real ? boost::multiprecision::sin(half) : boost::multiprecision::sinh(half)) / half;
  const Real factor = boost::multiprecision::pow(sinc, order / 2);
  RealVector result{factor, factor * cosine};
  for (std::uint32_t k = 2; k <= degree; ++k) result.push_back(2 * cosine * result[k - 1] - result[k - 2]);
  result.resize(degree + 1);
  return result;
}

std::vector<RealMatrix> trace_matrices(const TestSpace& space, std::uint32_t genus, const RealVector& lengths) {
  const std::size_t count = 2 * std::size_t{space.degree} + 1;
  const RealVector tau = cosine_sums(space, space.order, count, genus, lengths);
  const RealVector first = differences(cosine_sums(space, space.order - 2, count + 1, genus, lengths));
  const RealVector second = differences(differences(cosine_sums(space, space.order - 4, count + 2, genus, lengths)));
  const Real q = 2 / (space.step() * space.step());
  std::vector<RealVector> moments(3);
  for (std::size_t m = 0; m < count; ++m) {
    moments[0].push_back(tau[m]);
    moments[1].push_back(tau[m] / 4 + q * first[m]);
    moments[2].push_back(tau[m] / 16 + q / 2 * first[m] + q * q * second[m]);
  }
  std::vector<RealMatrix> result;
  for (const RealVector& moment : moments) {
    RealMatrix& matrix = result.emplace_back(space.degree + 1, RealVector(space.degree + 1));
    for (std::size_t j = 0; j <= space.degree; ++j) {
      for (std::size_t k = 0; k <= space.degree; ++k)
        matrix[j][k] = (moment[j < k ? k - j : j - k] + moment[j + k]) / 2;
    }
  }
  return result;
}

}  // namespace epsnet
