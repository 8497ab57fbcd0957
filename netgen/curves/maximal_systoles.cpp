#include <ClpSimplex.hpp>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "certify/numbers/interval_arithmetic.h"
#include "netgen/curves/curves.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/pants.h"

namespace epsnet {
namespace {

using certify::GeodesicsDocument;
using certify::Interval;

double middle_of(const Interval& x) { return x.lower + (x.upper - x.lower) / 2; }

/// Maximizes the last variable of a linear programme: at_least ≤ rows · variables ≤ at_most, and variables between
/// `least` and `greatest`. Nothing if there is no solution.
std::optional<std::vector<double>> maximize_last(const std::vector<std::vector<double>>& rows,
                                                 const std::vector<double>& at_least,
                                                 const std::vector<double>& at_most, const std::vector<double>& least,
                                                 const std::vector<double>& greatest) {
  ClpSimplex model;
  model.setLogLevel(0);
  const auto count = static_cast<int>(least.size());
  model.resize(0, count);
  for (int j = 0; j < count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    model.setColumnBounds(j, least[at], greatest[at]);
    model.setObjectiveCoefficient(j, j + 1 == count ? -1 : 0);
  }
  std::vector<int> columns(static_cast<std::size_t>(count));
  for (int j = 0; j < count; ++j) columns[static_cast<std::size_t>(j)] = j;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // What is 0 but for rounding is no pivot.
    constexpr double kNothing = 1e-12;
    std::vector<double> row = rows[i];
    for (double& x : row) {
      if (std::abs(x) < kNothing) x = 0;
    }
    model.addRow(count, columns.data(), row.data(), at_least[i], at_most[i]);
  }
  // Steps near a maximum are small.
  model.setPrimalTolerance(1e-11);
  model.setDualTolerance(1e-11);
  model.primal();
  if (!model.isProvenOptimal()) return std::nullopt;
  return std::vector<double>(model.primalColumnSolution(), model.primalColumnSolution() + count);
}

}  // namespace

// ---- gradients, in binary64 ----

std::optional<std::vector<double>> balance(std::span<const std::vector<Interval>> gradients) {
  const std::size_t count = gradients.size();
  const std::size_t dimension = gradients[0].size();
  std::vector<std::vector<double>> rows(dimension + 1, std::vector<double>(count + 1, 0));
  std::vector<double> values(dimension + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < dimension; ++j) rows[j][i] = middle_of(gradients[i][j]);
    rows[dimension][i] = 1;
  }
  values[dimension] = 1;
  constexpr double kInfinite = std::numeric_limits<double>::max();
  std::vector<double> at_most = values;
  for (std::size_t i = 0; i < count; ++i) {
    auto& row = rows.emplace_back(count + 1, 0);
    row[i] = 1;
    row[count] = -1;
    values.push_back(0);
    at_most.push_back(kInfinite);
  }
  auto found =
      maximize_last(rows, values, at_most, std::vector<double>(count + 1, 0), std::vector<double>(count + 1, 1));
  constexpr double kLeastWeight = 1e-7;  // Less may be rounding.
  if (!found || found->back() < kLeastWeight) return std::nullopt;
  found->pop_back();
  return found;
}

std::vector<std::size_t> independent(std::span<const std::vector<Interval>> gradients) {
  // Of the greatest pivot; less is rounding.
  constexpr double kLeastPivot = 1e-9;
  using Index = Eigen::Index;
  const auto dimension = static_cast<Index>(gradients[0].size());
  Eigen::MatrixXd columns(dimension, static_cast<Index>(gradients.size()));
  for (std::size_t i = 0; i < gradients.size(); ++i) {
    for (Index j = 0; j < dimension; ++j)
      columns(j, static_cast<Index>(i)) = middle_of(gradients[i][static_cast<std::size_t>(j)]);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(columns.rows(), columns.cols());
  decomposition.setThreshold(kLeastPivot);
  decomposition.compute(columns);
  std::vector<std::size_t> result;
  for (Index k = 0; k < decomposition.rank(); ++k)
    result.push_back(static_cast<std::size_t>(decomposition.colsPermutation().indices()[k]));
  return result;
}

// ---- the climb ----

namespace {

/// A point of the climb.
struct Place {
  Surface surface;
  EnclosedCoordinates coordinates;  ///< Exact, but for the surface's rounding.
  double systole = 0;
  std::vector<Word> words;  ///< Of short closed geodesics, and what is known of their lengths.
  std::vector<double> lengths;
  std::vector<std::vector<double>> gradients;
};

class Climb {
 public:
  Climb(PantsGraph graph, const MaximizeOptions& options, std::uint32_t& steps)
      : graph_(std::move(graph)), options_(options), steps_(steps) {}

  [[nodiscard]] Place at(std::vector<double> x) {
    ++steps_;
    if (options_.progress) options_.progress("climbing", static_cast<double>(steps_) / options_.steps);
    const std::size_t edges = graph_.edges().size();
    FenchelNielsen made{graph_, {}, {}};
    for (std::size_t e = 0; e < edges; ++e) {
      // As the surface is glued.
      x[edges + e] -= x[e] * std::floor(x[edges + e] / x[e] + 0.5);
      made.lengths.emplace_back(x[e]);
      made.twists.emplace_back(x[edges + e]);
    }
    Place result{fenchel_nielsen_surface(made), {graph_, {}}, 0, {}, {}, {}};
    for (const double value : x) result.coordinates.values.push_back({value, value});
    GeodesicsOptions geodesics;
    geodesics.threads = options_.threads;
    result.systole = middle_of(unproved::systole(result.surface, geodesics).geodesics[0].length);
    const auto list = unproved::spectrum(result.surface, Length(result.systole + kBeyond), geodesics).geodesics;
    for (const auto& geodesic : list) {
      const Word word = word_of_letters(geodesic.word);
      const LengthDerivatives derivatives = length_derivatives(result.coordinates, word);
      if (std::abs(middle_of(derivatives.length) - middle_of(geodesic.length)) > 1e-8)
        throw NetError("a geodesic has another length than its coordinates say");
      result.words.push_back(word);
      result.lengths.push_back(middle_of(derivatives.length));
      auto& gradient = result.gradients.emplace_back();
      for (const Interval& slope : derivatives.gradient) gradient.push_back(middle_of(slope));
    }
    return result;
  }

  /// To where a step no longer makes the systole longer.
  [[nodiscard]] Place climb(std::vector<double> start) {
    Place here = at(std::move(start));
    double radius = 0.1;
    while (steps_ < options_.steps && radius > kLeastStep) {
      const auto [step, promised] = best_step(here, radius);
      if (promised <= kLeastGain) break;
      std::vector<double> x;
      double longest = 0;
      for (std::size_t i = 0; i < step.size(); ++i) {
        x.push_back(here.coordinates.values[i].lower + step[i]);
        longest = std::max(longest, std::abs(step[i]));
      }
      const bool is_allowed = std::all_of(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2),
                                          [](double length) { return length > 0.01 && length < 50; });
      std::optional<Place> there;
      if (is_allowed) there = at(std::move(x));
      if (there && there->systole > here.systole + 0.1 * promised) {
        const bool is_good = there->systole > here.systole + 0.75 * promised;
        here = *std::move(there);
        radius = is_good ? std::min(2 * radius, 0.5) : radius;
      } else {
        radius = std::min(radius, longest) / 4;
      }
    }
    return here;
  }

 private:
  /// To first order the best one of at most this size, and how much longer the systole gets.
  [[nodiscard]] static std::pair<std::vector<double>, double> best_step(const Place& here, double radius) {
    const std::size_t count = here.coordinates.values.size();
    // Steps are in units of the radius, and so is the gain.
    std::vector<std::vector<double>> rows;
    std::vector<double> bounds;
    for (std::size_t i = 0; i < here.gradients.size(); ++i) {
      rows.push_back(here.gradients[i]);
      rows.back().push_back(-1);
      bounds.push_back((here.systole - here.lengths[i]) / radius);
    }
    constexpr double kInfinite = std::numeric_limits<double>::max();
    std::vector<double> least(count, -1);
    std::vector<double> greatest(count, 1);
    least.push_back(0);
    greatest.push_back(kInfinite);
    auto found = maximize_last(rows, bounds, std::vector<double>(rows.size(), kInfinite), least, greatest);
    if (!found) return {{}, 0};
    const double gain = radius * found->back();
    found->pop_back();
    for (double& x : *found) x *= radius;
    return {*std::move(found), gain};
  }

  static constexpr double kBeyond = 0.5;  ///< Closed geodesics longer than the systole by that may become the shortest.
  static constexpr double kLeastStep = 1e-14;
  static constexpr double kLeastGain = 1e-15;

  PantsGraph graph_;
  const MaximizeOptions& options_;
  std::uint32_t& steps_;
};

// ---- the proof: docs/curves.md, "A local maximum" ----

using DenseMatrix = Eigen::MatrixXd;
using Index = Eigen::Index;
using IntervalMatrix = std::vector<std::vector<Interval>>;

Interval point(double x) { return {x, x}; }
double size_of(const Interval& x) { return std::max(std::abs(x.lower), std::abs(x.upper)); }

/// A bound for the greatest sum of the absolute values of a row.
double norm_of(const IntervalMatrix& matrix) {
  double greatest = 0;
  for (const std::vector<Interval>& row : matrix) {
    Interval sum{0, 0};
    for (const Interval& x : row) sum = sum + point(size_of(x));
    greatest = std::max(greatest, sum.upper);
  }
  return greatest;
}

IntervalMatrix transposed(const IntervalMatrix& matrix) {
  IntervalMatrix result(matrix.size());
  for (const std::vector<Interval>& row : matrix) {
    for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
  }
  return result;
}

/// A bound for the norm of the inverse of a square matrix, by an approximate inverse C: at most ‖C‖/(1 − ‖1 − CA‖).
/// Nothing if it may have none.
std::optional<double> norm_of_inverse(const IntervalMatrix& matrix) {
  const std::size_t size = matrix.size();
  DenseMatrix middle(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      middle(static_cast<Index>(i), static_cast<Index>(j)) = middle_of(matrix[i][j]);
  }
  const DenseMatrix inverse = middle.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  IntervalMatrix approximate(size);
  IntervalMatrix rest(size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      Interval sum = point(i == j ? 1 : 0);
      for (std::size_t k = 0; k < size; ++k)
        sum = sum - point(inverse(static_cast<Index>(i), static_cast<Index>(k))) * matrix[k][j];
      rest[i].push_back(sum);
      approximate[i].push_back(point(inverse(static_cast<Index>(i), static_cast<Index>(j))));
    }
  }
  const Interval left = point(1) - point(norm_of(rest));
  const double bound = (point(norm_of(approximate)) / left).upper;
  return left.lower > 0 && std::isfinite(bound) ? std::optional(bound) : std::nullopt;
}

/// The greatest sum of the absolute values of the second derivatives of a length, in a box around the coordinates;
/// infinite if the box is too wide.
double curvature(EnclosedCoordinates coordinates, double distance, std::span<const Word> words) {
  for (Interval& x : coordinates.values) x = x + Interval{-distance, distance};
  double greatest = 0;
  try {
    for (const Word& word : words) {
      Interval sum{0, 0};
      for (const auto& row : length_derivatives(coordinates, word, true).second) {
        for (const Interval& x : row) sum = sum + point(size_of(x));
      }
      greatest = std::max(greatest, sum.upper);
    }
  } catch (const LimitError&) {
    return std::numeric_limits<double>::infinity();
  }
  return greatest;
}

}  // namespace

std::optional<double> slope_of_least(std::span<const std::vector<Interval>> gradients) {
  if (gradients.empty() || gradients.size() <= gradients[0].size()) return std::nullopt;
  const std::size_t dimension = gradients[0].size();
  const auto weights = balance(gradients);
  if (!weights) return std::nullopt;
  const std::vector<std::size_t> basis = independent(gradients);
  if (basis.size() < dimension) return std::nullopt;
  IntervalMatrix rows;
  for (const std::size_t i : basis) rows.push_back(gradients[i]);
  const auto inverse = norm_of_inverse(rows);
  const auto inverse_of_transposed = norm_of_inverse(transposed(rows));
  if (!inverse || !inverse_of_transposed) return std::nullopt;
  // The weights of the basis are changed so that the sum of all is 0, by no more than that.
  double rest = 0;
  for (std::size_t j = 0; j < dimension; ++j) {
    Interval sum{0, 0};
    for (std::size_t i = 0; i < gradients.size(); ++i) sum = sum + point((*weights)[i]) * gradients[i][j];
    rest = std::max(rest, size_of(sum));
  }
  const Interval change = point(*inverse_of_transposed) * point(rest);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : basis) least = std::min(least, (point((*weights)[i]) - change).lower);
  if (!(least > 0)) return std::nullopt;
  Interval total{0, 0};
  for (const double weight : *weights) total = total + point(weight) + change;
  const Interval others = (point(total.upper) - point(least)) / point(least);
  return (point(1) / (point(*inverse) * point(std::max(others.upper, 1.0)))).lower;
}

std::optional<NearMaximum> near_maximum(const EnclosedCoordinates& coordinates, const Interval& systole,
                                        std::span<const Word> systoles) {
  IntervalMatrix gradients;
  double longest = 0;
  for (const Word& word : systoles) {
    LengthDerivatives derivatives = length_derivatives(coordinates, word);
    longest = std::max(longest, derivatives.length.upper);
    gradients.push_back(std::move(derivatives.gradient));
  }
  const auto slope = slope_of_least(gradients);
  if (!slope) return std::nullopt;
  // Where the distance is δ, some curve is no longer than `longest` − slope·δ + ½ curvature δ².
  const double spread = (point(longest) - point(systole.lower)).upper;
  constexpr int kMostTrials = 8;
  double distance = std::max(2 * spread / *slope, 1e-15);
  for (int i = 0; i < kMostTrials; ++i, distance *= 2) {
    const Interval bend = point(curvature(coordinates, distance, systoles)) * point(distance) * point(distance);
    if ((point(*slope) * point(distance) - bend - point(spread)).lower > 0) return NearMaximum{distance, *slope};
  }
  return std::nullopt;
}

namespace {

/// The middles of the coordinates of a surface, to begin with.
std::vector<double> middles(const PantsDecomposition& pants) {
  std::vector<double> result;
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) result.push_back(middle_of(cuff.length));
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) result.push_back(middle_of(cuff.twist));
  return result;
}

/// The coordinates of a surface in its own pants, with the twists nearest to given ones.
EnclosedCoordinates coordinates_near(const PantsDecomposition& pants, const EnclosedCoordinates& given) {
  EnclosedCoordinates result{pants.graph, {}};
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) result.values.push_back(cuff.length);
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) {
    const double distance = given.values[result.values.size()].lower - cuff.twist.lower;
    const double turns = std::round(distance / cuff.length.lower);
    result.values.push_back(turns == 0 ? cuff.twist : cuff.twist + point(turns) * cuff.length);
  }
  return result;
}

}  // namespace

SystoleMaximum maximize_systole(const Surface& start, const MaximizeOptions& options) {
  PantsOptions of_pants;
  of_pants.threads = options.threads;
  PantsDecomposition pants = pants_decomposition(start, of_pants);
  std::uint32_t steps = 0;
  Climb first(pants.graph, options, steps);
  Place top = first.climb(middles(pants));
  // Cuffs may have become long on the way, which costs digits: once more, along short ones.
  if (steps < options.steps) {
    of_pants.own = false;
    pants = pants_decomposition(top.surface, of_pants);
    Climb second(pants.graph, options, steps);
    top = second.climb(middles(pants));
    of_pants.own = true;
  }
  SystoleMaximum result{top.surface, {top.coordinates.graph, {}}, {}, {}, {}, steps};
  result.coordinates = coordinates_near(pants_decomposition(result.surface, of_pants), top.coordinates);
  GeodesicsOptions geodesics;
  geodesics.threads = options.threads;
  result.systole = systole(result.surface, geodesics).document.geodesics[0].length;
  constexpr double kNear = 1e-9;
  for (std::size_t i = 0; i < top.words.size(); ++i) {
    if (top.lengths[i] <= top.systole + kNear) result.systoles.push_back(top.words[i]);
  }
  try {
    result.proof = near_maximum(result.coordinates, result.systole, result.systoles);
  } catch (const LimitError&) {
    // Along long cuffs coordinates are not known well enough.
  }
  return result;
}

// ---- exact surfaces ----

namespace {

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
