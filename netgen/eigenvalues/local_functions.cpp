#include "netgen/eigenvalues/local_functions.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "certify/claims/eigenvalues/partition.h"
#include "certify/net/darts.h"
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

/// How many waves count where tanh of half the radius is t: the tail of Lemma 37.4 is less than 10^−digits.
std::uint32_t order_for(double t, double lambda, double digits) {
  constexpr std::uint32_t kMost = 150;
  for (std::uint32_t order = 2; order < kMost; ++order) {
    const double sinh_wider = (order + 1) / std::sqrt(lambda);
    const double cosh_wider = std::sqrt(1 + sinh_wider * sinh_wider);
    const double q = t * (1 + cosh_wider) / sinh_wider;
    if (q < 1 &&
        lambda * (cosh_wider - 1) / (order + 1) + order * std::log(q) - std::log(1 - q) < -digits * std::numbers::ln10)
      return order;
  }
  return kMost;
}

/// The same for the largest of the disks.
std::uint32_t order_for(double epsilon, double radius, double lambda, int digits) {
  const double cosh = disk_cosh(epsilon, radius, std::cosh(epsilon / 2));
  return std::max(6U, order_for(std::sqrt((cosh - 1) / (cosh + 1)), lambda, digits));
}

/// Tails of 2⁻⁶² are as small as the rounding of coefficients.
constexpr double kDigitsOfTails = 18.6;

}  // namespace

LocalFunctions::LocalFunctions(const NetGeometry& geometry, double greatest, int digits, unsigned threads)
    : geometry_(geometry),
      threads_(certify::thread_count(threads)),
      epsilon_(geometry.epsilon().get_d()),
      radius_(1.3 * epsilon_),
      // What is compared is multiplied by some 10⁵ in Lemma 37.3; coefficients are some 10² in all, and there are as
      // many tails.
      order_(order_for(epsilon_, radius_, greatest, std::min(digits + 8, 18))),
      each_(2 * std::size_t{order_} + 1),
      points_(2 * std::size_t{order_} + 2) {
  find_lifts();
  inner_ = circle(1.15 * epsilon_);
  // The functions are compared in disks that reach about as far.
  outer_ = circle(radius_ + 0.15 * epsilon_);
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
LocalFunctions::Circle LocalFunctions::circle(double radius) const {
  Circle result{std::tanh(radius / 2), std::vector<std::uint32_t>(lifts_.size() * points_),
                std::vector<Point>(lifts_.size() * points_)};
  certify::for_each_parallel(lifts_.size(), threads_, [&](unsigned, std::size_t vertex) {
    for (std::size_t k = 0; k < points_; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points_);
      const Complex<double> p{result.radius * std::cos(angle), result.radius * std::sin(angle)};
      double least = 1;
      for (const Lift& lift : lifts_[vertex]) {
        const Complex<double> z = inverse(lift.isometry)(p);
        if (norm(z) >= least) continue;
        least = norm(z);
        result.nearest[vertex * points_ + k] = lift.vertex;
        result.points[vertex * points_ + k] = {z.x, z.y};
      }
    }
  });
  return result;
}

void LocalFunctions::set_values(double lambda, Point z, double* row) const {
  std::vector<double> factors;
  set_radial_factors(lambda, std::norm(z), order_, factors);
  row[0] = factors[0];
  Point power = 1;
  for (std::size_t m = 1; m <= order_; ++m) {
    power *= z / inner_.radius;
    row[2 * m - 1] = factors[m] * power.real();
    row[2 * m] = factors[m] * power.imag();
  }
}

/// Functions to those that have, on the circle around each vertex, the values of the function of the nearest other
/// vertex. Those that fit together are fixed.
class LocalFunctions::CircleMap {
 public:
  CircleMap(const LocalFunctions& functions, const Circle& circle, double lambda)
      : functions_(functions),
        circle_(circle),
        values_(circle.nearest.size() * functions.each_),
        fit_(each(), points()) {
    certify::for_each_parallel(functions.lifts_.size(), functions.threads_, [&](unsigned, std::size_t vertex) {
      for (std::size_t k = vertex * functions.points_; k < (vertex + 1) * functions.points_; ++k)
        functions.set_values(lambda, circle.points[k], values_.data() + k * functions.each_);
    });
    std::vector<double> factors;
    set_radial_factors(lambda, circle.radius * circle.radius, functions.order_, factors);
    const auto n = static_cast<double>(functions.points_);
    double power = 1;  // Of the radius, scaled.
    for (std::uint32_t m = 0; m <= functions.order_; ++m) {
      const double scale = (m == 0 ? 1 : 2) / (n * power * factors[m]);
      for (Eigen::Index k = 0; k < points(); ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(m * k % points()) / n;
        const Eigen::Index row = Eigen::Index{2} * m;
        if (m > 0) fit_(row - 1, k) = scale * std::cos(angle);
        fit_(row, k) = m == 0 ? scale : scale * std::sin(angle);
      }
      power *= circle.radius / functions.inner_.radius;
    }
  }

  [[nodiscard]] Block operator()(const Block& block) const {
    Block result(block.rows(), block.cols());
    certify::for_each_parallel(functions_.lifts_.size(), functions_.threads_, [&](unsigned, std::size_t vertex) {
      Block values(points(), block.cols());
      for (Eigen::Index k = 0; k < points(); ++k) {
        const std::size_t at = vertex * functions_.points_ + static_cast<std::size_t>(k);
        const Eigen::Map<const Eigen::RowVectorXd> row(values_.data() + at * functions_.each_, each());
        values.row(k).noalias() = row * block.middleRows(circle_.nearest[at] * each(), each());
      }
      result.middleRows(static_cast<Eigen::Index>(vertex) * each(), each()).noalias() = fit_ * values;
    });
    return result;
  }

 private:
  [[nodiscard]] Eigen::Index each() const { return static_cast<Eigen::Index>(functions_.each_); }
  [[nodiscard]] Eigen::Index points() const { return static_cast<Eigen::Index>(functions_.points_); }

  const LocalFunctions& functions_;
  const Circle& circle_;
  std::vector<double> values_;  ///< By vertex and point, what coefficients of the nearest vertex add.
  Block fit_;                   ///< From values on a circle to coefficients.
};

/// What a map S has nearly as fixed points.
struct LocalFunctions::Fixed {
  Block functions;             ///< Those that S − 1 makes smallest relative to themselves, the smallest first.
  double rest;                 ///< The singular value of S − 1 of the last one that is sought.
  std::vector<double> values;  ///< The eigenvalues of S nearest to 1, as many as are sought, in increasing order.
};

/// In Krylov's space of S and some functions, restarted with the best ones.
LocalFunctions::Fixed LocalFunctions::fixed(const CircleMap& map, Block functions, Eigen::Index count) const {
  constexpr Eigen::Index kMostVectors = 48;
  constexpr int kMostRestarts = 6;
  const Eigen::Index kept = functions.cols();
  const Eigen::Index most = std::min(size(), std::max(kMostVectors, 6 * kept));
  double before = HUGE_VAL;
  for (int restart = 0;; ++restart) {
    Block basis = orthonormal(functions);
    Block images = map(basis);
    while (basis.cols() + kept <= most) {
      Block next = images.rightCols(kept);
      for (int round = 0; round < 2; ++round) {
        next -= basis * (basis.transpose() * next);
        next = orthonormal(next);
      }
      basis.conservativeResize(Eigen::NoChange, basis.cols() + kept);
      basis.rightCols(kept) = next;
      images.conservativeResize(Eigen::NoChange, basis.cols());
      images.rightCols(kept) = map(next);
    }
    const Eigen::HouseholderQR<Block> qr(Block(images - basis));
    const Block triangle = qr.matrixQR().topRows(basis.cols()).template triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Block> svd(triangle, Eigen::ComputeFullV);
    functions = basis * svd.matrixV().rightCols(kept).rowwise().reverse();
    const double rest = svd.singularValues()[basis.cols() - count];
    if (rest < kRounding || rest > before / 3 || restart == kMostRestarts) {
      const Eigen::EigenSolver<Block> solver(Block(basis.transpose() * images), false);
      std::vector<std::complex<double>> all(solver.eigenvalues().data(),
                                            solver.eigenvalues().data() + solver.eigenvalues().size());
      std::sort(all.begin(), all.end(),
                [](const auto& x, const auto& y) { return std::abs(x - 1.0) < std::abs(y - 1.0); });
      Fixed result{std::move(functions), rest, {}};
      for (Eigen::Index i = 0; i < count; ++i) result.values.push_back(all[static_cast<std::size_t>(i)].real());
      std::sort(result.values.begin(), result.values.end());
      return result;
    }
    before = rest;
  }
}

/// An eigenvalue of S at λ is 1 if λ is an eigenvalue of the surface, and grows with λ: by the secant method.
std::vector<LocalFunctions::Task> LocalFunctions::improved(const Task& task, bool& done) const {
  const Fixed found =
      fixed(CircleMap(*this, inner_, task.lambda), task.functions, static_cast<Eigen::Index>(task.count));
  done = found.rest < kRounding;
  if (done) return {{task.lambda, task.count, CircleMap(*this, outer_, task.lambda)(found.functions)}};
  const double greatest = std::max(std::abs(found.values.front() - 1), std::abs(found.values.back() - 1));
  if (found.rest > 3 * greatest) {
    // Not accurate enough to tell where they are.
    Task again = task;
    again.functions = found.functions;
    ++again.steps;
    return {std::move(again)};
  }
  const double mean =
      std::accumulate(found.values.begin(), found.values.end(), 0.0) / static_cast<double>(found.values.size());
  double slope = std::pow(std::atanh(inner_.radius), 2);
  if (task.before && std::abs(mean - task.before->value) > 1e-13)
    slope = (mean - task.before->value) / (task.lambda - task.before->lambda);
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
    Task next{task.lambda + (1 - value) / slope, count, found.functions};
    next.before = {task.lambda, value};
    next.steps = task.steps + 1;
    result.push_back(std::move(next));
  }
  return result;
}

std::optional<std::vector<Eigenfunctions>> LocalFunctions::near(const std::vector<double>& lambdas,
                                                                const Eigen::MatrixXd& values) const {
  constexpr int kMostSteps = 16;
  constexpr double kSame = 1e-9;
  double mean = 0;
  for (const double lambda : lambdas) mean += lambda / static_cast<double>(lambdas.size());
  Task first{.lambda = mean, .count = lambdas.size(), .functions = Block::Zero(size(), values.cols())};
  for (Eigen::Index v = 0; v < values.rows(); ++v)
    first.functions.row(v * static_cast<Eigen::Index>(each_)) = values.row(v);
  std::vector<Task> open{std::move(first)};
  std::vector<Task> found;
  while (!open.empty()) {
    const Task task = std::move(open.back());
    open.pop_back();
    bool done = false;
    std::vector<Task> next = improved(task, done);
    for (Task& part : next) {
      if (!(std::abs(part.lambda - mean) < mean / 2) || part.steps > kMostSteps) return std::nullopt;
      if (!done) {
        open.push_back(std::move(part));
        continue;
      }
      // Parts of one multiple eigenvalue may have been taken for several.
      const auto same = std::find_if(found.begin(), found.end(), [&](const Task& other) {
        return std::abs(other.lambda - part.lambda) < kSame * part.lambda;
      });
      if (same == found.end()) {
        found.push_back(std::move(part));
        continue;
      }
      Task together{
          .lambda = part.lambda, .count = part.count + same->count, .functions = Block(), .steps = part.steps};
      together.functions.resize(size(), same->functions.cols() + part.functions.cols());
      together.functions << same->functions, part.functions;
      found.erase(same);
      open.push_back(std::move(together));
    }
  }
  std::sort(found.begin(), found.end(), [](const Task& x, const Task& y) { return x.lambda < y.lambda; });
  std::vector<Eigenfunctions> result;
  for (const Task& task : found) {
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
  for (std::uint32_t m = 0; m <= order_; ++m) {
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
    const auto m = static_cast<std::size_t>((i % static_cast<Eigen::Index>(each_) + 1) / 2);
    scale[i] = std::pow(inner_.radius, -static_cast<double>(m));
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

double LocalFunctions::error_of(const Task& task, double gram) const {
  const auto count = static_cast<Eigen::Index>(task.count);
  struct Bounds {
    double value = 0;
    double gradient = 0;
  };
  Eigen::MatrixXd totals(static_cast<Eigen::Index>(lifts_.size()), count);
  for (Eigen::Index v = 0; v < totals.rows(); ++v) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto own =
          task.functions.col(j).segment(v * static_cast<Eigen::Index>(each_), static_cast<Eigen::Index>(each_));
      double total = std::abs(own[0]);
      for (std::uint32_t m = 1; m <= order_; ++m)
        total += std::hypot(own[Eigen::Index{2} * m - 1], own[Eigen::Index{2} * m]) *
                 std::pow(inner_.radius, -static_cast<double>(m));
      totals(v, j) = total;
    }
  }
  std::vector<std::vector<Bounds>> greatest(lifts_.size(), std::vector<Bounds>(task.count));
  certify::for_each_parallel(lifts_.size(), threads_, [&](unsigned, std::size_t vertex) {
    std::vector<double> own(each_);
    std::vector<double> other(each_);
    std::vector<double> factors;
    for (const Lift& lift : lifts_[vertex]) {
      const auto& [a, b] = lift.isometry;
      const double length = std::sqrt(norm(a));
      const Complex<double> middle = (1 / (length * (length + 1))) * (a * b);
      const double cosh = disk_cosh(epsilon_, radius_, length);
      const double s = (cosh - 1) / (cosh + 1);
      const double t = std::sqrt(s);
      const std::uint32_t half = std::min(order_, order_for(t, task.lambda, kDigitsOfTails));
      const std::uint32_t n = 2 * half;
      const Isometry<double> from_middle = Isometry<double>::translation(middle);
      Eigen::MatrixXd values(n, count);
      for (std::uint32_t k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        const Complex<double> z = from_middle(Complex<double>{t * std::cos(angle), t * std::sin(angle)});
        const Complex<double> w = inverse(lift.isometry)(z);
        set_values(task.lambda, {z.x, z.y}, own.data());
        set_values(task.lambda, {w.x, w.y}, other.data());
        const auto each = static_cast<Eigen::Index>(each_);
        const Eigen::Map<const Eigen::RowVectorXd> own_row(own.data(), each);
        const Eigen::Map<const Eigen::RowVectorXd> other_row(other.data(), each);
        values.row(k) =
            other_row * task.functions.middleRows(lift.vertex * each, each).leftCols(count) -
            own_row * task.functions.middleRows(static_cast<Eigen::Index>(vertex) * each, each).leftCols(count);
      }
      set_radial_factors(task.lambda, s, order_, factors);
      const double sinh_wider = (half + 1) / std::sqrt(task.lambda);
      const double cosh_wider = std::sqrt(1 + sinh_wider * sinh_wider);
      const double q = t * (1 + cosh_wider) / sinh_wider;
      for (Eigen::Index j = 0; j < count; ++j) {
        const double total = totals(static_cast<Eigen::Index>(vertex), j) + totals(lift.vertex, j);
        const double tail =
            2 * total * std::exp(task.lambda * (cosh_wider - 1) / (half + 1)) * std::pow(q, half) / (1 - q);
        Bounds bounds{tail, tail * ((half + q / (1 - q)) / t + task.lambda * t)};
        for (std::uint32_t m = 0; m < half; ++m) {
          Point sum = 0;
          for (std::uint32_t k = 0; k < n; ++k)
            sum += values(k, j) * std::polar(1.0, 2 * std::numbers::pi * (m * k % n) / n);
          const double once = (std::abs(sum) / n + tail) / std::abs(factors[m]);
          const double both = m == 0 ? once : 2 * once;
          bounds.value += both;
          bounds.gradient += both * (m / t + task.lambda * t);
        }
        Bounds& most = greatest[vertex][static_cast<std::size_t>(j)];
        most.value = std::max(most.value, bounds.value);
        most.gradient = std::max(most.gradient, bounds.gradient);
      }
    }
  });
  std::vector<certify::PartitionBounds> partition(lifts_.size());
  certify::for_each_parallel(lifts_.size(), threads_, [&](unsigned, std::size_t vertex) {
    std::vector<Point> places{0};
    for (const Lift& lift : lifts_[vertex]) {
      const Complex<double> z = lift.isometry(Complex<double>{});
      places.emplace_back(z.x, z.y);
    }
    partition[vertex] = certify::partition_bounds(places, epsilon_, radius_);
  });
  double residuals = 0;
  double errors = 0;
  for (std::size_t j = 0; j < task.count; ++j) {
    double residual = 0;
    double error = 0;
    for (std::size_t v = 0; v < lifts_.size(); ++v) {
      residual = std::max(residual, greatest[v][j].value * partition[v].laplacians +
                                        2 * greatest[v][j].gradient * partition[v].gradients);
      error = std::max(error, greatest[v][j].value);
    }
    residuals += residual * residual;
    errors += error * error;
  }
  const double area = 4 * std::numbers::pi * (geometry_.genus() - 1);
  const double norm = std::sqrt(gram) - std::sqrt(area * errors);
  return norm > 0 ? std::sqrt(area * residuals) / norm : HUGE_VAL;
}

}  // namespace epsnet
