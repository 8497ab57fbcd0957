#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "certify/net/numbering.h"
#include "certify/numbers/parallel.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/eigenvalues/elements.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;

/// More than what rounding changes of a distance.
constexpr double kRoomOfDistances = 1 + 1e-9;

/// The steps of a character, by side: whole numbers, 1 for the side with this number in character_sides, 0 for others.
std::vector<std::int64_t> steps_of(const Surface& surface, std::size_t direction) {
  // More than twice any of them: what flows along an edge comes from one cycle.
  constexpr std::int64_t kParts = 1 << 20;
  std::vector<Rational> turns(std::size_t{2} * surface.genus(), Rational(0));
  turns[direction] = Rational(1, kParts);
  std::vector<std::int64_t> result;
  for (const Rational& phase : phases_of_sides(surface, turns))
    result.push_back(static_cast<std::int64_t>(numerator(Rational(phase * kParts))));
  return result;
}

/// By dart: the step from the chart of the vertex where it starts to that of its triangle.
std::vector<double> steps_at_corners(const certify::NetDocument& net, const std::vector<std::int64_t>& steps) {
  std::vector<double> of_label{0};
  for (const certify::NetDocument::Label& label : net.labels) {
    std::int64_t sum = 0;
    for (const std::uint32_t side : label.word) sum += steps[side];
    of_label.push_back(static_cast<double>(sum));
  }
  std::vector<double> result;
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart)
    result.push_back(of_label[certify::corner_label(net, dart)]);
  return result;
}

/// Functions of least energy: for each triangle and side the cotangent of the opposite angle times the square of the
/// difference of the ends, in the triangle's chart.
class LeastEnergy {
 public:
  LeastEnergy(const certify::NetDocument& net, const std::vector<FlatTriangle>& triangles)
      : net_(net), triangles_(triangles) {
    std::vector<Eigen::Triplet<double>> entries;
    each_side([&](std::uint32_t i, std::uint32_t j, std::uint32_t /*dart*/, double weight) {
      const auto add = [&](std::uint32_t row, std::uint32_t column, double value) {
        if (row > 0 && column > 0) entries.emplace_back(static_cast<int>(row - 1), static_cast<int>(column - 1), value);
      };
      add(i, i, weight);
      add(j, j, weight);
      add(i, j, -weight);
      add(j, i, -weight);
    });
    const auto size = static_cast<Eigen::Index>(net.vertices.size() - 1);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (size > 0) solver_.compute(matrix);
  }

  /// By vertex, the heights of the function with these steps at the corners, that of vertex 0 being 0. Files have six
  /// decimals of them.
  [[nodiscard]] std::vector<double> heights(const std::vector<double>& steps) const {
    std::vector<double> result(net_.vertices.size(), 0);
    if (result.size() == 1) return result;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(result.size() - 1));
    each_side([&](std::uint32_t i, std::uint32_t j, std::uint32_t dart, double weight) {
      const double rise = steps[certify::next_dart(dart)] - steps[dart];
      if (i > 0) right[i - 1] += weight * rise;
      if (j > 0) right[j - 1] -= weight * rise;
    });
    const Eigen::VectorXd solution = solver_.solve(right);
    constexpr double kParts = 1e6;
    for (std::size_t v = 1; v < result.size(); ++v)
      result[v] = std::round(solution[static_cast<Eigen::Index>(v - 1)] * kParts) / kParts;
    return result;
  }

 private:
  /// Calls visit(i, j, dart, weight) for the darts from a vertex i to another one, j.
  template <class Visit>
  void each_side(const Visit& visit) const {
    for (std::uint32_t dart = 0; dart < 3 * triangles_.size(); ++dart) {
      const std::uint32_t i = certify::start(net_, dart);
      const std::uint32_t j = certify::start(net_, certify::next_dart(dart));
      if (i != j) visit(i, j, dart, triangles_[dart / 3].cotangent[(dart + 2) % 3]);
    }
  }

  const certify::NetDocument& net_;
  const std::vector<FlatTriangle>& triangles_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// The values of a function in the corners of a triangle.
using Heights = std::array<double, 3>;

/// The slope of a function on a triangle is at most that.
double slope(const FlatTriangle& triangle, const Heights& h) {
  double twice_energy = 0;
  for (std::size_t i = 0; i < 3; ++i)
    twice_energy += triangle.cotangent[i] * std::pow(h[(i + 1) % 3] - h[(i + 2) % 3], 2);
  return triangle.cosh * std::sqrt(std::max(0.0, twice_energy / (2 * triangle.area)));
}

/// Of Σ ±h_k with any signs, the greatest: in groups of four, of which the slopes are added up.
double greatest_slope(const FlatTriangle& triangle, const std::vector<Heights>& heights) {
  constexpr std::size_t kInGroup = 4;
  double result = 0;
  for (std::size_t first = 0; first < heights.size(); first += kInGroup) {
    const std::size_t last = std::min(first + kInGroup, heights.size());
    double greatest = 0;
    for (std::size_t signs = 0; signs < std::size_t{1} << (last - first); ++signs) {
      Heights sum{};
      for (std::size_t k = first; k < last; ++k) {
        for (std::size_t i = 0; i < 3; ++i) sum[i] += (signs >> (k - first) & 1) != 0 ? -heights[k][i] : heights[k][i];
      }
      greatest = std::max(greatest, slope(triangle, sum));
    }
    result += greatest;
  }
  return result;
}

}  // namespace

CharacterDirections::CharacterDirections(const Surface& surface, const NetGeometry& geometry) {
  const certify::NetDocument& net = geometry.document();
  const std::vector<FlatTriangle> triangles = Elements(geometry, 0).triangles();
  const LeastEnergy energy(net, triangles);
  std::vector<std::vector<Heights>> at_corners(triangles.size());
  for (std::size_t k = 0; k < std::size_t{2} * surface.genus(); ++k) {
    std::vector<std::int64_t> steps = steps_of(surface, k);
    const std::vector<double> of_darts = steps_at_corners(net, steps);
    std::vector<double> heights = energy.heights(of_darts);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      Heights& h = at_corners[t].emplace_back();
      for (std::uint32_t i = 0; i < 3; ++i) h[i] = heights[certify::start(net, 3 * t + i)] + of_darts[3 * t + i];
    }
    directions_.push_back({std::move(steps), std::move(heights)});
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const double of_triangle = greatest_slope(triangles[t], at_corners[t]);
    if (!std::isfinite(of_triangle)) throw NetError("triangles are too thin for functions on them");
    slope_ = std::max(slope_, of_triangle);
  }
}

EigenvaluesDocument::Box CharacterDirections::box(const Rational& radius) const { return {radius.str(), directions_}; }

double CharacterDirections::distance(const Rational& radius) const {
  return 2 * std::numbers::pi * static_cast<double>(radius) * slope_ * kRoomOfDistances;
}

void widen(EigenvaluesDocument& document, const CharacterDirections& directions, const Rational& radius) {
  const double distance = directions.distance(radius);
  const auto least = [&](double x) { return std::pow(std::max(0.0, std::sqrt(x) - distance), 2) / kRoomOfDistances; };
  for (auto& [in, count] : document.eigenvalues)
    in = {least(in.lower), std::pow(std::sqrt(in.upper) + distance, 2) * kRoomOfDistances};
  document.next = least(document.next);
  document.box = directions.box(radius);
}

namespace {

/// A part of the torus of characters: a cube with its centre.
struct Cube {
  TorusPoint centre;
  Rational radius;
};

/// The halves in all directions.
std::vector<Cube> halves(const Cube& cube) {
  std::vector<Cube> result;
  const Rational radius = cube.radius / 2;
  for (std::uint64_t part = 0; part < std::uint64_t{1} << cube.centre.size(); ++part) {
    Cube& half = result.emplace_back(Cube{cube.centre, radius});
    for (std::size_t k = 0; k < cube.centre.size(); ++k)
      half.centre[k] += (part >> k & 1) != 0 ? radius : Rational(-radius);
  }
  return result;
}

bool is_outside(const TorusPoint& point, const Rational& radius) {
  return std::any_of(point.begin(), point.end(), [&](const Rational& turns) { return abs(turns) > radius; });
}

bool is_near_0(const Cube& cube, const Rational& radius) {
  return std::all_of(cube.centre.begin(), cube.centre.end(),
                     [&](const Rational& turns) { return abs(turns) + cube.radius <= radius; });
}

/// What proves that λ₀ is at least a number in a cube.
class CubeProofs {
 public:
  CubeProofs(const Surface& surface, const NetGeometry& geometry, double bound)
      : surface_(surface), geometry_(geometry), directions_(surface, geometry), bound_(bound) {
    constexpr double kGreatestErrorOfMatrix = 0.08;  // Relative, of eigenvalues.
    constexpr std::uint32_t kMostHalvings = 5;
    for (;; ++halvings_) {
      const Elements elements(geometry, halvings_);
      interpolation_ = elements.interpolation();
      if (halvings_ < kMostHalvings && interpolation_ > kGreatestErrorOfMatrix) continue;
      order_ = elimination_order(elements.lower().energy);
      return;
    }
  }

  /// The document; nothing if eigenvalues near the centre may be too small.
  [[nodiscard]] std::optional<EigenvaluesDocument> proof(const Cube& cube) const {
    const ById<SideId, Rational> phases = phases_of_sides(surface_, cube.centre);
    const double below = std::pow(std::sqrt(bound_) + directions_.distance(cube.radius), 2) * kRoomOfDistances;
    const auto sigma = counted(phases, below);
    if (!sigma) return std::nullopt;
    EigenvaluesDocument result;
    result.net = geometry_.document();
    for (const Rational& phase : phases) result.phases.push_back(phase.str());
    result.box = directions_.box(cube.radius);
    result.next = bound_;
    result.halvings = halvings_;
    result.side_order = order_;
    result.at_most.push_back({below, 0, *sigma});
    return result;
  }

  /// Whether this much is so in the centre.
  [[nodiscard]] bool holds_in_centre(const Cube& cube) const {
    return counted(phases_of_sides(surface_, cube.centre), bound_).has_value();
  }

 private:
  /// σ, if there are no eigenvalues below a number.
  [[nodiscard]] std::optional<double> counted(const ById<SideId, Rational>& phases, double below) const {
    const double sigma = sigma_for(below, interpolation_);
    if (!std::isfinite(sigma)) return std::nullopt;
    const Elements elements(geometry_, halvings_, turns_of_labels(geometry_.document(), phases));
    const certify::Inertia found = inertia(elements.lower(), order_, sigma, certify::Bound::upper, 1, 0);
    return found.proved && found.negative == 0 ? std::optional(sigma) : std::nullopt;
  }

  const Surface& surface_;
  const NetGeometry& geometry_;
  CharacterDirections directions_;
  double bound_;
  std::uint32_t halvings_ = 0;
  double interpolation_ = 0;  ///< H
  std::vector<std::uint32_t> order_;
};

std::string text_of(const TorusPoint& point) {
  std::string result;
  for (const Rational& turns : point) result += (result.empty() ? "" : ",") + turns.str();
  return result;
}

}  // namespace

std::size_t gap_outside(const Surface& surface, const Rational& radius, double bound, const GapOptions& options) {
  if (radius <= 0 || radius >= Rational(1, 2)) throw std::invalid_argument("radius is not between 0 and 1/2");
  if (!(bound > 0 && bound <= 1e4)) throw std::invalid_argument("bound is not a positive number of at most 10000");
  constexpr std::uint32_t kMostGenus = 4;
  if (surface.genus() > kMostGenus) throw LimitError("the characters of a surface of genus 5 or more are too many");
  constexpr const char* kEpsilon = "0.4";
  NetOptions of_net;
  of_net.threads = options.threads;
  of_net.progress = options.progress;
  const certify::NetDocument net = compute_net(surface, options.epsilon.value_or(Length(kEpsilon)), of_net).document;
  const NetGeometry geometry(net);
  const CubeProofs proofs(surface, geometry, bound);
  // λ₀ is the same at the inverse character: half of the torus is enough.
  std::vector<Cube> open = halves({TorusPoint(std::size_t{2} * surface.genus(), Rational(0)), Rational(1, 2)});
  std::erase_if(open, [](const Cube& cube) { return cube.centre.front() < 0; });
  const unsigned threads = certify::thread_count(options.threads);
  std::mutex mutex;
  std::size_t boxes = 0;
  std::size_t before = 0;  // So many cubes were looked at.
  double left = 1;         // Of that half, the part that is not done.
  const auto is_done = [&](const Cube& cube) {
    left -= 2 * std::pow(2 * static_cast<double>(cube.radius), 2.0 * surface.genus());
    if (options.progress) options.progress("boxes", 1 - std::max(left, 0.0));
  };
  while (!open.empty()) {
    enum class Cubes : char { proved, halved, refused };
    std::vector<Cubes> found(open.size(), Cubes::proved);
    certify::for_each_parallel(open.size(), threads, [&](unsigned, std::size_t i) {
      const auto document = proofs.proof(open[i]);
      if (!document) {
        const bool fails = is_outside(open[i].centre, radius) && !proofs.holds_in_centre(open[i]);
        found[i] = fails ? Cubes::refused : Cubes::halved;
        return;
      }
      (void)proof_of(*document, 1);
      const std::lock_guard lock(mutex);
      if (options.each) options.each(before + i, *document);
      ++boxes;
      is_done(open[i]);
    });
    before += open.size();
    std::vector<Cube> next;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (found[i] == Cubes::refused) throw NetError("not proved at the phases " + text_of(open[i].centre));
      if (found[i] == Cubes::proved) continue;
      for (Cube& half : halves(open[i])) is_near_0(half, radius) ? is_done(half) : next.push_back(std::move(half));
      if (boxes + next.size() > options.most) {
        throw NetError("it takes more than " + std::to_string(options.most) +
                       " boxes: the bound is near the least value, or the radius small");
      }
    }
    open = std::move(next);
  }
  return boxes;
}

}  // namespace epsnet
