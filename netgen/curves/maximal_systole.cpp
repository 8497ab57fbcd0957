#include "netgen/curves/maximal_systole.h"

#include <ClpSimplex.hpp>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "certify/numbers/interval_arithmetic.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/pants.h"

namespace epsnet {
namespace {

using certify::Interval;
using certify::operator+;
using certify::operator-;
using certify::operator*;
using certify::operator/;

double middle_of(const Interval& x) { return x.lower + (x.upper - x.lower) / 2; }

/// Maximize the last variable of a linear programme: rows · variables ≥ bounds, and variables between their ends.
/// Nothing if there is no solution.
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

using Matrix = Eigen::MatrixXd;
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
  Matrix middle(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      middle(static_cast<Index>(i), static_cast<Index>(j)) = middle_of(matrix[i][j]);
  }
  const Matrix inverse = middle.inverse();
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

/// λ ≥ 0 with the sum 1 and Σ λ_i g_i = 0, about, of which the least one is as great as possible.
std::optional<std::vector<double>> balance(const std::vector<LengthDerivatives>& curves) {
  const std::size_t count = curves.size();
  const std::size_t dimension = curves[0].gradient.size();
  std::vector<std::vector<double>> rows(dimension + 1, std::vector<double>(count + 1, 0));
  std::vector<double> values(dimension + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < dimension; ++j) rows[j][i] = middle_of(curves[i].gradient[j]);
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
  if (!found || found->back() <= 0) return std::nullopt;
  found->pop_back();
  return found;
}

/// Curves of which the gradients are a basis.
std::vector<std::size_t> independent(const std::vector<LengthDerivatives>& curves) {
  const auto dimension = static_cast<Index>(curves[0].gradient.size());
  Matrix gradients(dimension, static_cast<Index>(curves.size()));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (Index j = 0; j < dimension; ++j)
      gradients(j, static_cast<Index>(i)) = middle_of(curves[i].gradient[static_cast<std::size_t>(j)]);
  }
  const Eigen::ColPivHouseholderQR<Matrix> decomposition(gradients);
  std::vector<std::size_t> result;
  for (Index k = 0; k < dimension; ++k)
    result.push_back(static_cast<std::size_t>(decomposition.colsPermutation().indices()[k]));
  return result;
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

std::optional<NearMaximum> near_maximum(const EnclosedCoordinates& coordinates, const Interval& systole,
                                        std::span<const Word> systoles) {
  const std::size_t dimension = coordinates.values.size();
  if (systoles.size() <= dimension) return std::nullopt;
  std::vector<LengthDerivatives> curves;
  double longest = 0;
  for (const Word& word : systoles) {
    curves.push_back(length_derivatives(coordinates, word));
    longest = std::max(longest, curves.back().length.upper);
  }
  const auto weights = balance(curves);
  if (!weights) return std::nullopt;
  const std::vector<std::size_t> basis = independent(curves);
  IntervalMatrix rows;
  for (const std::size_t i : basis) rows.push_back(curves[i].gradient);
  const auto inverse = norm_of_inverse(rows);
  const auto inverse_of_transposed = norm_of_inverse(transposed(rows));
  if (!inverse || !inverse_of_transposed) return std::nullopt;
  // The weights of the basis are changed so that the sum of all is 0, by no more than that.
  Interval total{0, 0};
  double rest = 0;
  for (std::size_t j = 0; j < dimension; ++j) {
    Interval sum{0, 0};
    for (std::size_t i = 0; i < curves.size(); ++i) sum = sum + point((*weights)[i]) * curves[i].gradient[j];
    rest = std::max(rest, size_of(sum));
  }
  const Interval change = point(*inverse_of_transposed) * point(rest);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : basis) least = std::min(least, (point((*weights)[i]) - change).lower);
  for (const double weight : *weights) total = total + point(weight) + change;
  if (!(least > 0)) return std::nullopt;
  NearMaximum result;
  result.slope = (point(least) / (point(*inverse) * point(total.upper))).lower;
  // Where the distance is δ, some curve is no longer than `longest` − slope·δ + ½ curvature δ².
  const double spread = (point(longest) - point(systole.lower)).upper;
  constexpr int kMostTrials = 8;
  result.distance = std::max(2 * spread / result.slope, 1e-15);
  for (int i = 0; i < kMostTrials; ++i, result.distance *= 2) {
    const Interval distance = point(result.distance);
    const Interval bend = point(curvature(coordinates, result.distance, systoles)) * distance * distance;
    if ((point(result.slope) * distance - bend - point(spread)).lower > 0) return result;
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
  of_pants.own = false;
  pants = pants_decomposition(top.surface, of_pants);
  Climb second(pants.graph, options, steps);
  top = second.climb(middles(pants));
  of_pants.own = true;
  SystoleMaximum result{std::move(top.surface), {top.coordinates.graph, {}}, {}, {}, {}, steps};
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

}  // namespace epsnet
