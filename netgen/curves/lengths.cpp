#include "netgen/curves/lengths.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "certify/numbers/interval_arithmetic.h"
#include "netgen/curves/balance.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/pants.h"

namespace epsnet {
namespace {

using certify::Ball;

constexpr slong kBitsOfDerivatives = 192;

/// A number with its derivatives. One without any is a constant.
template <class T>
struct Jet {
  T value{};
  std::vector<T> derivatives = {};
};

Ball number(double n, const Ball* /*kind*/) { return Ball::exactly(n); }
Ball reciprocal(const Ball& x) { return 1 / x; }
template <class T>
Jet<T> number(double n, const Jet<T>* /*kind*/) {
  return {number(n, static_cast<const T*>(nullptr)), {}};
}

/// f(x, y), of which the derivative is dx · by_x + dy · by_y.
template <class T>
Jet<T> combined(T value, const Jet<T>& x, const T& by_x, const Jet<T>& y, const T& by_y) {
  Jet<T> result{std::move(value), {}};
  for (std::size_t i = 0; i < std::max(x.derivatives.size(), y.derivatives.size()); ++i) {
    if (y.derivatives.empty()) {
      result.derivatives.push_back(x.derivatives[i] * by_x);
    } else if (x.derivatives.empty()) {
      result.derivatives.push_back(y.derivatives[i] * by_y);
    } else {
      result.derivatives.push_back(x.derivatives[i] * by_x + y.derivatives[i] * by_y);
    }
  }
  return result;
}
/// f(x), of which the derivative is `slope`.
template <class T>
Jet<T> composed(T value, const Jet<T>& x, const T& slope) {
  Jet<T> result{std::move(value), {}};
  for (const T& dx : x.derivatives) result.derivatives.push_back(dx * slope);
  return result;
}

template <class T>
Jet<T> operator+(const Jet<T>& x, const Jet<T>& y) {
  const T one = number(1, static_cast<const T*>(nullptr));
  return combined(T(x.value + y.value), x, one, y, one);
}
template <class T>
Jet<T> operator-(const Jet<T>& x) {
  return composed(T(-x.value), x, number(-1, static_cast<const T*>(nullptr)));
}
template <class T>
Jet<T> operator-(const Jet<T>& x, const Jet<T>& y) {
  return x + (-y);
}
template <class T>
Jet<T> operator*(const Jet<T>& x, const Jet<T>& y) {
  return combined(T(x.value * y.value), x, y.value, y, x.value);
}
template <class T>
Jet<T> reciprocal(const Jet<T>& x) {
  const T value = reciprocal(x.value);
  return composed(value, x, T(-(value * value)));
}
template <class T>
Jet<T> operator/(const Jet<T>& x, const Jet<T>& y) {
  return x * reciprocal(y);
}
template <class T>
Jet<T> sqrt(const Jet<T>& x) {
  const T value = sqrt(x.value);
  return composed(value, x, reciprocal(T(value + value)));
}
template <class T>
Jet<T> exp(const Jet<T>& x) {
  const T value = exp(x.value);
  return composed(value, x, value);
}
template <class T>
Jet<T> acosh(const Jet<T>& x) {
  const T one = number(1, static_cast<const T*>(nullptr));
  return composed(T(acosh(x.value)), x, reciprocal(T(sqrt(T(x.value * x.value - one)))));
}

/// About the value.
double rough(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }
template <class T>
double rough(const Jet<T>& x) {
  return rough(x.value);
}

/// A matrix of positive determinant, which acts on the upper half-plane.
template <class T>
struct HalfPlaneMatrix {
  T a, b, c, d;

  HalfPlaneMatrix operator*(const HalfPlaneMatrix& n) const {
    return {a * n.a + b * n.c, a * n.b + b * n.d, c * n.a + d * n.c, c * n.b + d * n.d};
  }
  [[nodiscard]] T determinant() const { return a * d - b * c; }
};

/// The inverse, but for a factor.
template <class T>
HalfPlaneMatrix<T> adjugate(const HalfPlaneMatrix<T>& m) {
  return {m.d, -m.b, -m.c, m.a};
}

/// The crossings of the sides of heptagons, as docs/fenchel-nielsen.md makes them, but with base points that do not
/// matter: only the products of their heights do.
template <class T>
class Heptagons {
 public:
  using M = HalfPlaneMatrix<T>;

  Heptagons(const PantsGraph& graph, const std::vector<T>& coordinates) {
    const std::size_t edges = graph.edges().size();
    std::vector<T> r;
    for (std::size_t e = 0; e < edges; ++e) r.push_back(exp(coordinates[e] / of(2)));
    std::vector<Pants> pants;
    for (std::uint32_t p = 0; p < graph.pants_count(); ++p) {
      pants.emplace_back(std::array<T, 3>{r[graph.edge_at(p, 0)], r[graph.edge_at(p, 1)], r[graph.edge_at(p, 2)]});
      const auto& [first, second] = pants.back().generators;
      crossings_.resize(crossings_.size() + kSides, M{of(1), of(0), of(0), of(1)});
      crossing(p, 0) = second;
      crossing(p, 2) = adjugate(second);
      crossing(p, 5) = second * first;
      crossing(p, 3) = adjugate(second * first);
    }
    for (std::size_t e = 0; e < edges; ++e) {
      const auto& [one, other] = graph.edges()[e];
      const Cuff& from = pants[one.pants].cuffs[one.cuff];
      const Cuff& to = pants[other.pants].cuffs[other.cuff];
      // The product of the heights of the ends that meet: f f′ e^τ times r² or r⁻², from base points to ends of sides.
      T product = from.mark * to.mark * exp(coordinates[edges + e]);
      const T square = r[e] * r[e];
      if (one.cuff == 0 && other.cuff == 0) product = product / square;
      if (one.cuff != 0 && other.cuff != 0) product = product * square;
      const M across = to.frame * M{of(0), -product, of(1), of(0)} * adjugate(from.frame);
      crossing(one.pants, kCuffSides[one.cuff]) = across;
      crossing(other.pants, kCuffSides[other.cuff]) = adjugate(across);
    }
  }

  /// The length of the closed geodesic of a path.
  ///
  /// Between frames that have the axis for an axis each step is nearly a diagonal matrix, so that errors of steps are
  /// added; in the product of the crossings themselves each would be multiplied by the norms of all others.
  [[nodiscard]] T length(const Word& word) const {
    const std::vector<M> frames = axis_frames(word);
    M product{of(1), of(0), of(0), of(1)};
    T determinant = of(1);
    for (std::size_t i = 0; i < word.size(); ++i) {
      const M step = adjugate(frames[(i + 1) % frames.size()]) * crossings_[word[i].number()] * frames[i];
      determinant = determinant * step.determinant();
      product = step * product;
    }
    const T trace = product.a + product.d;
    return acosh(trace * trace / (of(2) * determinant) - of(1));
  }

 private:
  static constexpr std::uint32_t kSides = 7;
  static constexpr std::array<std::uint32_t, 3> kCuffSides{6, 1, 4};

  static T of(double n) { return number(n, static_cast<const T*>(nullptr)); }

  /// The cuff as seen from the pants: in its frame it runs from 0 to ∞, and the mark is at this height.
  struct Cuff {
    M frame;
    T mark;
  };
  struct Pants {
    explicit Pants(const std::array<T, 3>& r) {
      const auto& [r1, r2, r3] = r;
      const T t2 = r2 + of(1) / r2;
      const T t3 = r3 + of(1) / r3;
      const T a = -(t3 + t2 / r1) / (r1 - of(1) / r1);
      const T d = t2 - a;
      const M first{r1, of(0), of(0), of(1) / r1};
      const M second{a, a * d - of(1), of(1), d};
      const auto axis = [](const T& from, const T& to) { return M{to, from, of(1), of(1)}; };
      const std::array<M, 3> axes{M{of(1), of(0), of(0), of(1)}, axis(of(1) / r2 - d, r2 - d),
                                  axis(-(r1 * r3) - d, -(r1 / r3) - d)};
      for (std::size_t k = 0; k < 3; ++k) {
        const M next = adjugate(axes[k]) * axes[(k + 1) % 3];
        const T mark = sqrt(next.b / next.d * (next.a / next.c));
        cuffs.push_back({k == 2 ? second * axes[k] : axes[k], mark});
      }
      generators = {first, second};
    }

    std::array<M, 2> generators;  ///< D₁ and D₂.
    std::vector<Cuff> cuffs;
  };

  /// By step of a closed path, in the heptagon where it begins: the ends of the axis, roughly, as columns of length 1.
  /// Any constant matrices that have inverses would do.
  [[nodiscard]] std::vector<M> axis_frames(const Word& word) const {
    constexpr int kRounds = 20;
    constexpr double kLeastAngle = 1e-9;
    using Direction = std::array<double, 2>;
    const auto image = [](const HalfPlaneMatrix<double>& m, const Direction& u) {
      const Direction v{m.a * u[0] + m.b * u[1], m.c * u[0] + m.d * u[1]};
      const double size = std::sqrt(v[0] * v[0] + v[1] * v[1]);  // The same on every machine.
      return Direction{v[0] / size, v[1] / size};
    };
    std::vector<HalfPlaneMatrix<double>> steps;
    for (const SideId s : word) {
      const M& m = crossings_[s.number()];
      steps.push_back({rough(m.a), rough(m.b), rough(m.c), rough(m.d)});
    }
    // Whatever goes around and around comes to an end of the axis, and backwards to the other one.
    std::vector<Direction> ahead(word.size());
    std::vector<Direction> behind(word.size());
    Direction u{0.8, 0.6};
    Direction v{0.6, -0.8};
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < steps.size(); ++i) {
        ahead[i] = u;
        u = image(steps[i], u);
      }
      for (std::size_t i = steps.size(); i-- > 0;) behind[i] = v = image(adjugate(steps[i]), v);
    }
    std::vector<M> frames;
    for (std::size_t i = 0; i < word.size(); ++i) {
      const auto& [x, y] = ahead[i];
      const auto& [z, w] = behind[i];
      const bool is_frame = std::abs(x * w - y * z) > kLeastAngle;
      frames.push_back(is_frame ? M{of(x), of(z), of(y), of(w)} : M{of(1), of(0), of(0), of(1)});
    }
    return frames;
  }

  M& crossing(std::uint32_t pants, std::uint32_t side) { return crossings_[std::size_t{kSides} * pants + side]; }

  std::vector<M> crossings_;  ///< By side: from the coordinates of its heptagon to those of the neighbour.
};

template <class T>
Jet<T> variable(T value, std::size_t i, std::size_t count) {
  Jet<T> result{std::move(value), std::vector<T>(count, number(0, static_cast<const T*>(nullptr)))};
  result.derivatives[i] = number(1, static_cast<const T*>(nullptr));
  return result;
}

Ball ball_of_interval(const certify::Interval& x) {
  const Ball middle = certify::half(Ball::exactly(x.lower) + Ball::exactly(x.upper));
  Ball result = middle;
  const Ball radius = certify::half(Ball::exactly(x.upper) - Ball::exactly(x.lower));
  arb_add_error(result.get(), radius.get());
  return result;
}

}  // namespace

EnclosedCoordinates enclosed_coordinates(const PantsDecomposition& pants) {
  if (!pants.own) {
    throw SurfaceError(
        "its tiles are not the heptagons of Fenchel-Nielsen coordinates; surface fenchel-nielsen --from makes them of "
        "a "
        "pants file");
  }
  EnclosedCoordinates result{pants.graph, {}};
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) result.values.push_back(cuff.length);
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) {
    // The sides of the heptagons meet as for a twist of at least −½ and less than ½ of the length.
    const bool is_half = 2 * cuff.twist.upper >= cuff.length.lower;
    result.values.push_back(is_half ? certify::Interval{-cuff.twist.upper, -cuff.twist.lower} : cuff.twist);
  }
  return result;
}

namespace {

using BallJet = Jet<Ball>;

/// The length with its first and second derivatives, at all points of a box.
Jet<BallJet> length_over(const PantsGraph& graph, const std::vector<Ball>& box, const Word& word) {
  std::vector<Jet<BallJet>> variables;
  for (std::size_t i = 0; i < box.size(); ++i)
    variables.push_back(variable(variable(box[i], i, box.size()), i, box.size()));
  return Heptagons<Jet<BallJet>>(graph, variables).length(word);
}

Ball derivative(const BallJet& x, std::size_t i) { return x.derivatives.empty() ? Ball() : x.derivatives[i]; }

certify::Interval checked(const Ball& x) {
  const certify::Interval result = certify::outer_interval(x);
  if (!std::isfinite(result.lower) || !std::isfinite(result.upper))
    throw LimitError("coordinates are not known well enough for a derivative of a length");
  return result;
}

}  // namespace

LengthDerivatives length_derivatives(const EnclosedCoordinates& coordinates, const Word& word, bool second) {
  const certify::Precision scope(kBitsOfDerivatives);
  std::vector<Ball> box;
  std::vector<BallJet> middle;
  std::vector<Ball> errors;
  const std::size_t count = coordinates.values.size();
  for (const certify::Interval& x : coordinates.values) {
    box.push_back(ball_of_interval(x));
    const Ball centre = certify::half(Ball::exactly(x.lower) + Ball::exactly(x.upper));
    errors.push_back(box.back() - centre);
    middle.push_back(variable(centre, middle.size(), count));
  }
  const BallJet at_middle = Heptagons<BallJet>(coordinates.graph, middle).length(word);
  const bool is_point =
      std::all_of(errors.begin(), errors.end(), [](const Ball& x) { return certify::is_exactly_zero(x); });
  LengthDerivatives result;
  if (is_point && !second) {
    result.length = checked(at_middle.value);
    for (std::size_t i = 0; i < count; ++i) result.gradient.push_back(checked(derivative(at_middle, i)));
    return result;
  }
  // By the mean value theorem: products of many matrices over a box would be far too wide.
  const Jet<BallJet> over = length_over(coordinates.graph, box, word);
  const auto second_over = [&](std::size_t i, std::size_t j) {
    return over.derivatives.empty() ? Ball() : derivative(over.derivatives[i], j);
  };
  Ball length = at_middle.value;
  for (std::size_t i = 0; i < count; ++i) {
    length += derivative(over.value, i) * errors[i];
    Ball slope = derivative(at_middle, i);
    auto& row = result.second.emplace_back();
    for (std::size_t j = 0; j < count; ++j) {
      slope += second_over(i, j) * errors[j];
      row.push_back(checked(second_over(i, j)));
    }
    result.gradient.push_back(checked(slope));
  }
  result.length = checked(length);
  if (!second) result.second.clear();
  return result;
}

// ---- the greatest systoles ----

namespace {

using certify::Interval;
using certify::operator+;
using certify::operator-;
using certify::operator*;
using certify::operator/;

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
