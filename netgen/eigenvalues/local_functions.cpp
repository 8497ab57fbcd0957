#include "netgen/eigenvalues/local_functions.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "certify/net/numbering.h"
#include "certify/numbers/parallel.h"

namespace epsnet {
namespace {

using Eigenfunctions = certify::EigenvaluesDocument::Eigenfunctions;

/// Singular values of rounding errors alone are less.
constexpr double kRounding = 3e-14;

double squared_sinh(const Isometry<double>& f) { return norm(f.b); }

/// ₂F₁(½ − ir, ½ + ir; m + 1; −s/(1 − s)), λ = ¼ + r², by its series.
double radial_factor(double lambda, double s, std::uint32_t m) {
  const double x = s / (1 - s);
  double sum = 1;
  double term = 1;
  for (double i = 0; i < 500 && std::abs(term) > 1e-18; ++i) {
    term *= -x * (i * (i + 1) + lambda) / ((m + 1 + i) * (i + 1));
    sum += term;
  }
  return sum;
}

/// By m = 0, …, order (docs/proof.md, Lemma 37.1 (b)).
void set_radial_factors(double lambda, double s, std::uint32_t order, std::vector<double>& factors) {
  factors.resize(order + 2);
  factors[order + 1] = radial_factor(lambda, s, order + 1);
  factors[order] = radial_factor(lambda, s, order);
  for (std::uint32_t m = order; m > 0; --m)
    factors[m - 1] = (1 + s) * factors[m] - s * (1 + lambda / (m * (m + 1.0))) * factors[m + 1];
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

/// sinh of half the greatest radius of the disks in which functions are compared, by its cosh.
double disk_cosh(double epsilon, double radius, double half_distance_cosh) {
  return (std::cosh(epsilon) + std::cosh(radius)) / (2 * half_distance_cosh);
}

/// By m, about how wrong the factors are for `certify`, in multiples of 2⁻⁶¹ (docs/proof.md, Lemma 37.7 (b)).
std::vector<double> errors_of_factors(double lambda, double s, std::uint32_t order) {
  constexpr double kOfSeries = 12;
  std::vector<double> errors(order + 2, kOfSeries);
  double difference = 2 * kOfSeries;
  for (std::uint32_t m = order; m > 0; --m) {
    const double weight = lambda / (m * (m + 1.0));
    difference = s * (difference + weight * errors[m + 1] + lambda) + weight + 3;
    errors[m - 1] = errors[m] + difference;
  }
  return errors;
}

constexpr std::uint32_t kMostOrder = 150;

/// How many waves count where tanh of half the radius is t: the tail of Lemma 37.4 is less than 10^−digits.
std::uint32_t order_for(double t, double lambda, double digits) {
  for (std::uint32_t order = 2; order < kMostOrder; ++order) {
    const double sinh_wider = (order + 1) / std::sqrt(lambda);
    const double cosh_wider = std::sqrt(1 + sinh_wider * sinh_wider);
    const double q = t * (1 + cosh_wider) / sinh_wider;
    if (q < 1 &&
        lambda * (cosh_wider - 1) / (order + 1) + order * std::log(q) - std::log(1 - q) < -digits * std::numbers::ln10)
      return order;
  }
  return kMostOrder;
}

/// The same for the largest of the disks.
std::uint32_t order_for(double epsilon, double radius, double lambda, int digits) {
  const double cosh = disk_cosh(epsilon, radius, std::cosh(epsilon / 2));
  return std::max(6U, order_for(std::sqrt((cosh - 1) / (cosh + 1)), lambda, digits));
}

/// Radius of the circles of the search, in ε.
constexpr double kInner = 1.15;
/// Waves of the coarse search are so many that tails are less than 10⁻⁸; it ends when S moves functions by 10⁻⁹ of
/// themselves, which its waves allow.
constexpr int kCoarseDigits = 8;
constexpr double kCoarse = 1e-9;
/// Tails of 2⁻⁶² are as small as the rounding of coefficients.
constexpr double kDigitsOfTails = 18.6;

}  // namespace

LocalFunctions::LocalFunctions(const NetGeometry& geometry, double greatest, int digits, unsigned threads)
    : geometry_(geometry),
      threads_(certify::thread_count(threads)),
      epsilon_(geometry.epsilon().get_d()),
      radius_(1.3 * epsilon_) {
  find_lifts();
  const double bits = -std::log2(std::tanh(kInner * epsilon_ / 2));
  for (double m = 0; m <= kMostOrder; ++m) scales_.push_back(std::exp2(std::round(m * bits)));
  coarse_ = resolution(order_for(epsilon_, radius_, greatest, kCoarseDigits));
  // What is compared is multiplied by some 10⁵ in Lemma 37.3; coefficients are some 10² in all, and there are as many
  // tails.
  fine_ = resolution(order_for(epsilon_, radius_, greatest, std::min(digits + 8, 18)));
  partition_.resize(lifts_.size());
  certify::for_each_parallel(lifts_.size(), threads_, [&](unsigned, std::size_t vertex) {
    std::vector<Point> places{0};
    for (const Lift& lift : lifts_[vertex]) {
      const Complex<double> z = lift.isometry(Complex<double>{});
      places.emplace_back(z.x, z.y);
    }
    partition_[vertex] = partition_sums(places, epsilon_, radius_);
  });
}

LocalFunctions::Resolution LocalFunctions::resolution(std::uint32_t order) const {
  Resolution result{order, 2 * std::size_t{order} + 1, 2 * std::size_t{order} + 2, {}, {}};
  result.inner = circle(kInner * epsilon_, result.points);
  // The functions are compared in disks that reach about as far.
  result.outer = circle(radius_ + 0.15 * epsilon_, result.points);
  return result;
}

std::vector<std::vector<LocalFunctions::Lift>> LocalFunctions::neighbours() const {
  const certify::NetDocument& net = geometry_.document();
  std::vector<Isometry<Mp256>> centres;  // From the disk around a vertex to its chart.
  for (const certify::NetDocument::Vertex& v : net.vertices)
    centres.push_back(normalized(Isometry<Mp256>::translation({Mp256(v.x), Mp256(v.y)})));
  const auto placed = [&](std::uint32_t dart) {
    const std::uint32_t label = certify::corner_label(net, dart);
    const Isometry<Mp256>& centre = centres[certify::start(net, dart)];
    return label == 0 ? centre : geometry_.label(label).precise * centre;
  };
  std::vector<std::vector<Lift>> result(net.vertices.size());
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t next = certify::next_dart(dart);
    const auto isometry = convert<double>(normalized(inverse(placed(dart)) * placed(next)));
    result[certify::start(net, dart)].push_back({certify::start(net, next), isometry, squared_sinh(isometry)});
  }
  return result;
}

/// From each vertex along edges to all lifts that are not too far.
void LocalFunctions::find_lifts() {
  const auto edges = neighbours();
  const double near = std::pow(std::sinh((epsilon_ + radius_) / 2), 2);
  const double far = std::pow(std::sinh((3 * epsilon_ + radius_) / 2), 2);
  double shortest = far;
  for (const auto& ends : edges) {
    for (const Lift& end : ends) shortest = std::min(shortest, end.sinh_squared);
  }
  lifts_.resize(edges.size());
  certify::for_each_parallel(edges.size(), threads_, [&](unsigned, std::size_t centre) {
    std::vector<Lift> found{{static_cast<std::uint32_t>(centre), {}, 0}};
    std::multimap<std::uint32_t, std::size_t> of_vertex{{static_cast<std::uint32_t>(centre), 0}};
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const Lift& edge : edges[found[i].vertex]) {
        const Isometry<double> isometry = found[i].isometry * edge.isometry;
        const double distance = squared_sinh(isometry);
        if (distance > far) continue;
        const auto [first, last] = of_vertex.equal_range(edge.vertex);
        // Two lifts are the same, or as far apart as the shortest edge is long.
        const bool known = std::any_of(first, last, [&](const auto& other) {
          return squared_sinh(inverse(found[other.second].isometry) * isometry) < shortest / 4;
        });
        if (known) continue;
        of_vertex.emplace(edge.vertex, found.size());
        found.push_back({edge.vertex, normalized(isometry), distance});
      }
    }
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (found[i].sinh_squared <= near) lifts_[centre].push_back(found[i]);
    }
  });
}

/// `radius` is more than ε, so each point of such a circle is within ε of another lift.
LocalFunctions::Circle LocalFunctions::circle(double radius, std::size_t points) const {
  Circle result{std::tanh(radius / 2), std::vector<std::uint32_t>(lifts_.size() * points),
                std::vector<Point>(lifts_.size() * points)};
  certify::for_each_parallel(lifts_.size(), threads_, [&](unsigned, std::size_t vertex) {
    for (std::size_t k = 0; k < points; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
      const Complex<double> p{result.radius * std::cos(angle), result.radius * std::sin(angle)};
      double least = 1;
      for (const Lift& lift : lifts_[vertex]) {
        const Complex<double> z = inverse(lift.isometry)(p);
        if (norm(z) >= least) continue;
        least = norm(z);
        result.nearest[vertex * points + k] = lift.vertex;
        result.points[vertex * points + k] = {z.x, z.y};
      }
    }
  });
  return result;
}

void LocalFunctions::set_values(double lambda, Point z, std::uint32_t order, double* row) const {
  std::vector<double> factors;
  set_radial_factors(lambda, std::norm(z), order, factors);
  row[0] = factors[0];
  Point power = 1;
  for (std::size_t m = 1; m <= order; ++m) {
    power *= z;
    row[2 * m - 1] = scale(m) * factors[m] * power.real();
    row[2 * m] = scale(m) * factors[m] * power.imag();
  }
}

/// Functions to those that have, on the circle around each vertex, the values of the function of the nearest other
/// vertex. Those that fit together are fixed.
class LocalFunctions::CircleMap {
 public:
  CircleMap(const LocalFunctions& functions, const Resolution& resolution, const Circle& circle, double lambda)
      : functions_(functions),
        resolution_(resolution),
        circle_(circle),
        values_(circle.nearest.size() * resolution.each),
        fit_(each(), points()) {
    certify::for_each_parallel(functions.lifts_.size(), functions.threads_, [&](unsigned, std::size_t vertex) {
      for (std::size_t k = vertex * resolution.points; k < (vertex + 1) * resolution.points; ++k)
        functions.set_values(lambda, circle.points[k], resolution.order, values_.data() + k * resolution.each);
    });
    std::vector<double> factors;
    set_radial_factors(lambda, circle.radius * circle.radius, resolution.order, factors);
    const auto n = static_cast<double>(resolution.points);
    double power = 1;  // Of the radius.
    for (std::uint32_t m = 0; m <= resolution.order; ++m) {
      const double scale = (m == 0 ? 1 : 2) / (n * functions.scale(m) * power * factors[m]);
      for (Eigen::Index k = 0; k < points(); ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(m * k % points()) / n;
        const Eigen::Index row = Eigen::Index{2} * m;
        if (m > 0) fit_(row - 1, k) = scale * std::cos(angle);
        fit_(row, k) = m == 0 ? scale : scale * std::sin(angle);
      }
      power *= circle.radius;
    }
  }

  [[nodiscard]] Block operator()(const Block& block) const {
    Block result(block.rows(), block.cols());
    certify::for_each_parallel(functions_.lifts_.size(), functions_.threads_, [&](unsigned, std::size_t vertex) {
      Block values(points(), block.cols());
      for (Eigen::Index k = 0; k < points(); ++k) {
        const std::size_t at = vertex * resolution_.points + static_cast<std::size_t>(k);
        const Eigen::Map<const Eigen::RowVectorXd> row(values_.data() + at * resolution_.each, each());
        values.row(k).noalias() = row * block.middleRows(circle_.nearest[at] * each(), each());
      }
      result.middleRows(static_cast<Eigen::Index>(vertex) * each(), each()).noalias() = fit_ * values;
    });
    return result;
  }

 private:
  [[nodiscard]] Eigen::Index each() const { return static_cast<Eigen::Index>(resolution_.each); }
  [[nodiscard]] Eigen::Index points() const { return static_cast<Eigen::Index>(resolution_.points); }

  const LocalFunctions& functions_;
  const Resolution& resolution_;
  const Circle& circle_;
  std::vector<double> values_;  ///< By vertex and point, what coefficients of the nearest vertex add.
  Block fit_;                   ///< From values on a circle to coefficients.
};

/// What a map S has nearly as fixed points.
struct LocalFunctions::Fixed {
  Block functions;             ///< Those that S − 1 makes smallest relative to themselves, the smallest first.
  double rest;                 ///< The singular value of S − 1 of the last one that is sought.
  std::vector<double> values;  ///< The eigenvalues of S nearest to 1, as many as are sought, in increasing order,
  double residual;             ///< and about how wrong they may be.
};

/// The eigenvalues of S nearest to 1 by Krylov's space, and how far from eigenvectors their vectors are.
struct LocalFunctions::RitzValues {
  /// Of the basis' images.
  RitzValues(const Block& basis, const Block& images, std::size_t count) {
    const Eigen::EigenSolver<Block> solver(Block(basis.transpose() * images));
    const auto& all = solver.eigenvalues();
    std::vector<Eigen::Index> order(static_cast<std::size_t>(all.size()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::sort(order.begin(), order.end(),
              [&](Eigen::Index i, Eigen::Index j) { return std::abs(all[i] - 1.0) < std::abs(all[j] - 1.0); });
    order.resize(count);
    for (const Eigen::Index i : order) {
      const Eigen::VectorXcd y = solver.eigenvectors().col(i);
      const Eigen::VectorXcd z = all[i] * y;
      const double squared =
          (images * y.real() - basis * z.real()).squaredNorm() + (images * y.imag() - basis * z.imag()).squaredNorm();
      residual = std::max(residual, std::sqrt(squared) / y.norm());
      values.push_back(all[i].real());
      farthest = std::max(farthest, std::abs(all[i] - 1.0));
    }
    std::sort(values.begin(), values.end());
  }

  std::vector<double> values;
  double farthest = 0;  ///< From 1.
  double residual = 0;
};

/// In Krylov's space of S and some functions, restarted with the best ones.
LocalFunctions::Fixed LocalFunctions::fixed(const CircleMap& map, const Block& functions, std::size_t sought,
                                            bool from_all, double enough) const {
  constexpr Eigen::Index kMoreVectors = 30;
  constexpr int kMostRestarts = 6;
  // Relative to their distance from 1: the next λ is as much nearer.
  constexpr double kResidual = 0.1;
  const auto count = static_cast<Eigen::Index>(sought);
  const Eigen::Index kept = functions.cols();
  const Eigen::Index block = from_all ? kept : count;
  const Eigen::Index most = std::min(functions.rows(), kept + std::max(kMoreVectors, 6 * block));
  Block basis(functions.rows(), most);
  Block images(functions.rows(), most);
  basis.leftCols(kept) = orthonormal(functions);
  images.leftCols(kept) = map(basis.leftCols(kept));
  double before = HUGE_VAL;
  for (int restart = 0;; ++restart) {
    Eigen::Index size = kept;
    Block next = images.leftCols(block);
    while (size + block <= most) {
      for (int round = 0; round < 2; ++round) {
        next -= basis.leftCols(size) * (basis.leftCols(size).transpose() * next);
        next = orthonormal(next);
      }
      basis.middleCols(size, block) = next;
      next = map(next);
      images.middleCols(size, block) = next;
      size += block;
    }
    const Eigen::HouseholderQR<Block> qr(Block(images.leftCols(size) - basis.leftCols(size)));
    const Block triangle = qr.matrixQR().topRows(size).template triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Block> svd(triangle, Eigen::ComputeFullV);
    const Block best = svd.matrixV().rightCols(kept).rowwise().reverse();
    const double rest = svd.singularValues()[size - count];
    RitzValues ritz(basis.leftCols(size), images.leftCols(size), sought);
    if (rest < enough || ritz.residual < kResidual * ritz.farthest || rest > before / 3 || restart == kMostRestarts)
      return {basis.leftCols(size) * best, rest, std::move(ritz.values), ritz.residual};
    before = rest;
    basis.leftCols(kept) = basis.leftCols(size) * best;
    images.leftCols(kept) = images.leftCols(size) * best;
  }
}

/// An eigenvalue of S at λ is 1 if λ is an eigenvalue of the surface, and grows with λ: by the secant method.
std::vector<LocalFunctions::Task> LocalFunctions::improved(const Task& task, const Resolution& resolution,
                                                           double enough, bool& done) const {
  const Fixed found = fixed(CircleMap(*this, resolution, resolution.inner, task.lambda), task.functions, task.count,
                            task.from_all, enough);
  Task better = task;
  better.functions = found.functions;
  ++better.steps;
  done = found.rest < enough;
  const double greatest = std::max(std::abs(found.values.front() - 1), std::abs(found.values.back() - 1));
  // Not accurate enough to tell where they are.
  better.from_all = !done && found.rest > 3 * greatest;
  if (better.from_all) return {std::move(better)};
  const double mean =
      std::accumulate(found.values.begin(), found.values.end(), 0.0) / static_cast<double>(found.values.size());
  constexpr double kCertain = 20;
  if (task.before && std::abs(mean - task.before->value) > kCertain * std::max(found.residual, task.before->error))
    better.slope = (mean - task.before->value) / (task.lambda - task.before->lambda);
  if (done) return {std::move(better)};
  std::vector<Task> result;
  for (std::size_t i = 0; i < found.values.size();) {
    double sum = 0;
    const std::size_t first = i;
    do {
      sum += found.values[i++];
      // Equal eigenvalues are equally far from 1, but for what is still wrong.
    } while (i < found.values.size() && found.values[i] - found.values[i - 1] < std::max(0.2 * greatest, 1e-10));
    const std::size_t count = i - first;
    const double value = sum / static_cast<double>(count);
    Task next = better;
    next.lambda = task.lambda + (1 - value) / better.slope;
    next.count = count;
    next.before = {task.lambda, value, std::max(found.residual, kRounding)};
    result.push_back(std::move(next));
  }
  return result;
}

/// Nothing if one of them is lost.
std::optional<std::vector<LocalFunctions::Task>> LocalFunctions::found_from(std::vector<Task> open,
                                                                            const Resolution& resolution,
                                                                            double enough) const {
  constexpr int kMostSteps = 16;
  const double same = std::max(1e-9, enough);
  std::vector<Task> found;
  for (Task& task : open) task.steps = 0;
  while (!open.empty()) {
    const Task task = std::move(open.back());
    open.pop_back();
    bool done = false;
    for (Task& part : improved(task, resolution, enough, done)) {
      if (!(std::abs(part.lambda - part.start) < part.start / 2) || part.steps > kMostSteps) return std::nullopt;
      if (!done) {
        open.push_back(std::move(part));
        continue;
      }
      // Parts of one multiple eigenvalue may have been taken for several.
      const auto other = std::find_if(found.begin(), found.end(), [&](const Task& task_before) {
        return std::abs(task_before.lambda - part.lambda) < same * part.lambda;
      });
      if (other == found.end()) {
        found.push_back(std::move(part));
        continue;
      }
      Block functions(part.functions.rows(), other->functions.cols() + part.functions.cols());
      functions << other->functions, part.functions;
      part.functions = std::move(functions);
      part.count += other->count;
      part.before.reset();
      found.erase(other);
      open.push_back(std::move(part));
    }
  }
  return found;
}

/// The same functions with more waves, whose coefficients are 0. By vertex, α_0, α_1, β_1, …
LocalFunctions::Block LocalFunctions::with_order(const Block& functions, std::uint32_t order, std::uint32_t wider) {
  const Eigen::Index each = 2 * Eigen::Index{order} + 1;
  const Eigen::Index more = 2 * Eigen::Index{wider} + 1;
  const Eigen::Index vertices = functions.rows() / each;
  Block result = Block::Zero(vertices * more, functions.cols());
  for (Eigen::Index v = 0; v < vertices; ++v)
    result.middleRows(v * more, std::min(each, more)) = functions.middleRows(v * each, std::min(each, more));
  return result;
}

std::optional<std::vector<Eigenfunctions>> LocalFunctions::near(const std::vector<double>& lambdas,
                                                                const Eigen::MatrixXd& values) const {
  double mean = 0;
  for (const double lambda : lambdas) mean += lambda / static_cast<double>(lambdas.size());
  Task first{.start = mean,
             .lambda = mean,
             .count = lambdas.size(),
             .functions = with_order(values, 0, coarse_.order),
             // That of the wave 0, whose weight is the greatest, would be the square.
             .slope = 0.8 * std::pow(kInner * epsilon_ / 2, 2)};
  auto found = found_from({std::move(first)}, coarse_, kCoarse);
  if (!found) return std::nullopt;
  for (Task& task : *found) {
    task.functions = with_order(task.functions, coarse_.order, fine_.order);
    task.before.reset();
  }
  found = found_from(*std::move(found), fine_, kRounding);
  if (!found) return std::nullopt;
  std::sort(found->begin(), found->end(), [](const Task& x, const Task& y) { return x.lambda < y.lambda; });
  std::vector<Eigenfunctions> result;
  for (Task& task : *found) {
    task.functions = CircleMap(*this, fine_, fine_.outer, task.lambda)(task.functions);
    result.push_back(row_of(task));
    if (!std::isfinite(result.back().in.upper) || result.back().in.lower <= 0) return std::nullopt;
    // Found twice: there are others.
    if (result.size() > 1 && result.back().in.lower <= result[result.size() - 2].in.upper) return std::nullopt;
  }
  return result;
}

/// η of Lemma 37.5.
double LocalFunctions::disk_radius(double lambda) const {
  double squared_sinh = std::min(std::pow(std::sinh(epsilon_), 2), 1 / lambda);
  for (const auto& lifts : lifts_) {
    for (const Lift& lift : lifts) squared_sinh = std::min(squared_sinh, lift.sinh_squared);
  }
  return std::asinh(std::sqrt(squared_sinh));
}

/// By m: what the squares of coefficients are multiplied with in Lemma 37.5.
std::vector<double> LocalFunctions::gram_weights(double lambda) const {
  const double cosh = std::cosh(disk_radius(lambda));
  const double s = (cosh - 1) / (cosh + 1);
  std::vector<double> result;
  for (std::uint32_t m = 0; m <= fine_.order; ++m) {
    result.push_back((m == 0 ? 2 : 1) * std::numbers::pi * std::exp(-2 * lambda * (cosh - 1) / (m + 1)) * 2 *
                     std::pow(s, m + 1) / (m + 1));
  }
  return result;
}

Eigenfunctions LocalFunctions::row_of(const Task& task) const {
  const auto count = static_cast<Eigen::Index>(task.count);
  const std::vector<double> weights = gram_weights(task.lambda);
  Eigen::VectorXd weight(size());  // Of the scaled coefficients.
  Eigen::VectorXd scale(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const auto m = static_cast<std::size_t>((i % static_cast<Eigen::Index>(fine_.each) + 1) / 2);
    scale[i] = this->scale(m);
    weight[i] = weights[m] * scale[i] * scale[i];
  }
  Task normal = task;
  const Block sought = task.functions.leftCols(count);
  const Block gram = sought.transpose() * weight.asDiagonal() * sought;
  const Block factor = gram.llt().matrixL();
  normal.functions = factor.triangularView<Eigen::Lower>().solve(sought.transpose()).transpose();

  Eigenfunctions row{{}, task.lambda, radius_, {}};
  for (Eigen::Index j = 0; j < count; ++j) {
    const Eigen::VectorXd coefficients = normal.functions.col(j).cwiseProduct(scale);
    row.functions.emplace_back(coefficients.data(), coefficients.data() + coefficients.size());
  }
  const double margin = 1.1 * error_of(normal, 1);
  row.in = {task.lambda - margin, task.lambda + margin};
  return row;
}

/// Lemma 37.6 in binary64, with about the errors that `certify` adds for its values.
double LocalFunctions::error_of(const Task& task, double gram) const {
  const auto count = static_cast<Eigen::Index>(task.count);
  const auto each = static_cast<Eigen::Index>(fine_.each);
  const auto vertices = static_cast<Eigen::Index>(lifts_.size());
  const double reach = std::cosh(epsilon_) + std::cosh(radius_);
  const double greatest_s = (reach - 2) / reach;
  const std::vector<double> factor_errors = errors_of_factors(task.lambda, greatest_s, fine_.order);
  Eigen::MatrixXd totals = Eigen::MatrixXd::Zero(vertices, count);
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(count);  // Of differences of values.
  for (Eigen::Index j = 0; j < count; ++j) {
    double most = 0;
    double weighted = 0;
    for (Eigen::Index v = 0; v < vertices; ++v) {
      const auto own = task.functions.col(j).segment(v * each, each);
      double sum = 0;
      double with_errors = 0;
      for (std::uint32_t m = 0; m <= fine_.order; ++m) {
        const double alpha = own[m == 0 ? 0 : Eigen::Index{2} * m - 1];
        const double beta = m == 0 ? 0 : own[Eigen::Index{2} * m];
        totals(v, j) += std::hypot(alpha, beta) * scale(m);
        const double size = (std::abs(alpha) + std::abs(beta)) * scale(m) * std::pow(greatest_s, m / 2.0);
        sum += size;
        with_errors += size * (1.5 * m + 2 * factor_errors[m]);
      }
      most = std::max(most, sum);
      weighted = std::max(weighted, with_errors);
    }
    const double unit = std::exp2(std::ceil(std::log2(most)));
    errors[j] = 2 * 0x1p-62 * (unit * 3 * (fine_.order + 1) + weighted);
  }
  struct Bounds {
    double value = 0;
    double gradient = 0;
  };
  struct Pair {
    std::uint32_t vertex;
    const Lift* lift;
    std::vector<Bounds> bounds;
  };
  std::vector<Pair> pairs;
  for (std::uint32_t vertex = 0; vertex < lifts_.size(); ++vertex) {
    for (const Lift& lift : lifts_[vertex]) {
      if (vertex <= lift.vertex) pairs.push_back({vertex, &lift, {}});
    }
  }
  certify::for_each_parallel(pairs.size(), threads_, [&](unsigned, std::size_t i) {
    const std::uint32_t vertex = pairs[i].vertex;
    const Lift& lift = *pairs[i].lift;
    std::vector<double> own(fine_.each);
    std::vector<double> other(fine_.each);
    std::vector<double> factors;
    const auto& [a, b] = lift.isometry;
    const double length = std::sqrt(norm(a));
    const Complex<double> middle = (1 / (length * (length + 1))) * (a * b);
    const double cosh = disk_cosh(epsilon_, radius_, length);
    const double s = (cosh - 1) / (cosh + 1);
    const double t = std::sqrt(s);
    const std::uint32_t half = std::min(fine_.order, order_for(t, task.lambda, kDigitsOfTails));
    const std::uint32_t n = 2 * half;
    const Isometry<double> from_middle = Isometry<double>::translation(middle);
    Eigen::MatrixXd values(n, count);
    for (std::uint32_t k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n;
      const Complex<double> z = from_middle(Complex<double>{t * std::cos(angle), t * std::sin(angle)});
      const Complex<double> w = inverse(lift.isometry)(z);
      set_values(task.lambda, {z.x, z.y}, fine_.order, own.data());
      set_values(task.lambda, {w.x, w.y}, fine_.order, other.data());
      const Eigen::Map<const Eigen::RowVectorXd> own_row(own.data(), each);
      const Eigen::Map<const Eigen::RowVectorXd> other_row(other.data(), each);
      values.row(k) = other_row * task.functions.middleRows(lift.vertex * each, each).leftCols(count) -
                      own_row * task.functions.middleRows(vertex * each, each).leftCols(count);
    }
    set_radial_factors(task.lambda, s, fine_.order, factors);
    const double sinh_wider = (half + 1) / std::sqrt(task.lambda);
    const double cosh_wider = std::sqrt(1 + sinh_wider * sinh_wider);
    const double q = t * (1 + cosh_wider) / sinh_wider;
    for (Eigen::Index j = 0; j < count; ++j) {
      const double total = totals(vertex, j) + totals(lift.vertex, j);
      const double tail =
          2 * total * std::exp(task.lambda * (cosh_wider - 1) / (half + 1)) * std::pow(q, half) / (1 - q);
      Bounds bounds{tail, tail * ((half + q / (1 - q)) / t + task.lambda * t)};
      Bounds squares;
      for (std::uint32_t m = 0; m < half; ++m) {
        Point sum = 0;
        for (std::uint32_t k = 0; k < n; ++k)
          sum += values(k, j) * std::polar(1.0, 2 * std::numbers::pi * (m * k % n) / n);
        const double times = m == 0 ? 1 : 2;
        const double weight = 1 / std::abs(factors[m]);
        const double slope = weight * (m / t + task.lambda * t);
        const double size = std::abs(sum) / n + tail;
        bounds.value += times * weight * size;
        bounds.gradient += times * slope * size;
        squares.value += times * weight * weight;
        squares.gradient += times * slope * slope;
      }
      bounds.value += std::sqrt(squares.value) * errors[j];
      bounds.gradient += std::sqrt(squares.gradient) * errors[j];
      pairs[i].bounds.push_back(bounds);
    }
  });
  // By vertex, of the squares of the bounds of all functions.
  std::vector<double> residuals(lifts_.size());
  std::vector<double> wrong(lifts_.size());
  for (std::size_t j = 0; j < task.count; ++j) {
    std::vector<Bounds> greatest(lifts_.size());
    for (const Pair& pair : pairs) {
      for (const std::uint32_t vertex : {pair.vertex, pair.lift->vertex}) {
        greatest[vertex].value = std::max(greatest[vertex].value, pair.bounds[j].value);
        greatest[vertex].gradient = std::max(greatest[vertex].gradient, pair.bounds[j].gradient);
      }
    }
    for (std::size_t v = 0; v < lifts_.size(); ++v) {
      const auto& [value, gradient] = greatest[v];
      residuals[v] += std::pow(value * partition_[v].laplacians + 2 * gradient * partition_[v].gradients, 2);
      wrong[v] += value * value;
    }
  }
  const double norm = std::sqrt(gram) - std::sqrt(integral(std::move(wrong)));
  return norm > 0 ? std::sqrt(integral(std::move(residuals))) / norm : HUGE_VAL;
}

/// At most, of what is at most the k-th of these values in the Dirichlet cell of vertex k.
double LocalFunctions::integral(std::vector<double> values) const {
  std::sort(values.begin(), values.end(), std::greater<>());
  const double disk = 2 * std::numbers::pi * (std::cosh(epsilon_) - 1);
  double left = 4 * std::numbers::pi * (geometry_.genus() - 1);
  double result = 0;
  for (const double value : values) {
    result += std::min(disk, left) * value;
    left = std::max(0.0, left - disk);
  }
  return result;
}

}  // namespace epsnet
