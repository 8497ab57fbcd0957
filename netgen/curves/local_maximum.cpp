#include "netgen/curves/local_maximum.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/curves/balance.h"
#include "netgen/curves/closed_curves.h"

namespace epsnet {
namespace {

using certify::GeodesicsDocument;
using certify::Interval;

constexpr const char* kNotProved = "not proved to be a local maximum of the systole: ";

/// A decimal a little greater than a length.
Length length_above(double length) {
  constexpr std::uint64_t kParts = 10'000;
  const auto parts = static_cast<std::uint64_t>(std::ceil(length * static_cast<double>(kParts))) + 1;
  const std::string rest = std::to_string(kParts + parts % kParts);
  return Length(std::to_string(parts / kParts) + "." + rest.substr(1));
}

/// By curve: the derivatives of its length along twists about each of them.
std::vector<std::vector<Interval>> twist_derivatives(const CurveTopology& topology,
                                                     const std::vector<ClosedCurve>& curves) {
  std::vector<std::vector<Interval>> result(curves.size(), std::vector<Interval>(curves.size(), {0, 0}));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Interval derivative = topology.twist_derivative(curves[i], curves[j]);
      result[i][j] = derivative;
      result[j][i] = {-derivative.upper, -derivative.lower};
    }
  }
  return result;
}

/// Integers about proportional to numbers between 0 and 1.
std::vector<std::uint32_t> integers_like(const std::vector<double>& numbers) {
  constexpr double kGreatest = 1e6;
  const double greatest = *std::max_element(numbers.begin(), numbers.end());
  std::vector<std::uint32_t> result;
  std::uint32_t divisor = 0;
  for (const double number : numbers) {
    result.push_back(static_cast<std::uint32_t>(std::max(1.0, std::round(number / greatest * kGreatest))));
    divisor = std::gcd(divisor, result.back());
  }
  for (std::uint32_t& integer : result) integer /= divisor;
  return result;
}

}  // namespace

GeodesicsDocument unproved::local_maximum(const Surface& surface, const GeodesicsOptions& options) {
  const double systole = unproved::systole(surface, options).geodesics[0].length.upper;
  GeodesicsDocument result = unproved::spectrum(surface, length_above(systole), options);
  result.claim = GeodesicsDocument::Claim::local_maximum;
  const GeodesicsDocument::Cluster shortest = result.clusters[0];
  const std::size_t dimension = 6 * std::size_t{surface.genus()} - 6;
  if (shortest.count <= dimension) {
    throw NotMaximalError(kNotProved +
                          certify::counted(shortest.count, "shortest closed geodesic", "shortest closed geodesics") +
                          ", fewer than 6g - 5 = " + std::to_string(dimension + 1));
  }
  if (!shortest.equal) {
    throw NotMaximalError(kNotProved + std::to_string(shortest.count) +
                          " closed geodesics are shortest to 15 digits, but not of exactly equal length");
  }
  const CurveTopology topology(surface);
  std::vector<ClosedCurve> curves;
  for (std::uint32_t i = 0; i < shortest.count; ++i) {
    curves.push_back(topology.curve(word_of_letters(result.geodesics[i].word)));
  }
  const std::vector<std::vector<Interval>> derivatives = twist_derivatives(topology, curves);
  std::vector<std::size_t> basis = independent(derivatives);
  if (basis.size() != dimension) {
    throw NotMaximalError(kNotProved + std::string("the gradients of the ") + std::to_string(shortest.count) +
                          " shortest closed geodesics span " + std::to_string(basis.size()) +
                          " of 6g - 6 = " + std::to_string(dimension) + " dimensions");
  }
  std::sort(basis.begin(), basis.end());
  // Twists along the basis are one of the tangent vectors.
  std::vector<std::vector<Interval>> gradients;
  for (const std::vector<Interval>& row : derivatives) {
    auto& gradient = gradients.emplace_back();
    for (const std::size_t i : basis) gradient.push_back(row[i]);
  }
  const auto weights = balance(gradients);
  if (!weights) {
    throw NotMaximalError(kNotProved + std::string("no sum of the gradients with positive weights was found to be 0"));
  }
  const std::vector<std::uint32_t> rounded = integers_like(*weights);
  for (std::uint32_t i = 0; i < shortest.count; ++i) {
    if (std::binary_search(basis.begin(), basis.end(), i)) {
      result.basis.push_back(i);
    } else {
      result.weights.push_back(rounded[i]);
    }
  }
  return result;
}

Certified<GeodesicsDocument> local_maximum(const Surface& surface, const GeodesicsOptions& options) {
  return proved(unproved::local_maximum(surface, options), options.threads, options.progress);
}

}  // namespace epsnet
