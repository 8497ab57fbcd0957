#include "netgen/eigenvalues/elements.h"

#include <algorithm>
#include <cmath>

namespace epsnet {
namespace {

using Triple = std::array<double, 3>;

double minkowski(const Triple& v, const Triple& w) { return v[0] * w[0] + v[1] * w[1] - v[2] * w[2]; }
Triple difference(const Triple& v, const Triple& w) { return {v[0] - w[0], v[1] - w[1], v[2] - w[2]}; }
double squared_distance(const Triple& v, const Triple& w) {
  const Triple d = difference(v, w);
  return minkowski(d, d);
}
Triple midpoint(const Triple& v, const Triple& w) {
  const double scale = 1 / std::sqrt(4 + squared_distance(v, w));
  return {scale * (v[0] + w[0]), scale * (v[1] + w[1]), scale * (v[2] + w[2])};
}
Triple on_hyperboloid(const Complex<double>& z) {
  const double scale = 1 / (1 - norm(z));
  return {2 * z.x * scale, 2 * z.y * scale, (1 + norm(z)) * scale};
}

struct Triangle {
  std::array<Triple, 3> point;
  std::array<std::uint32_t, 3> vertex;
  std::array<std::uint32_t, 3> opposite;  ///< By dart.
};

std::vector<std::uint32_t> sides_of(const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> side(3 * triangles.size());
  std::uint32_t count = 0;
  for (std::uint32_t dart = 0; dart < side.size(); ++dart) {
    const std::uint32_t across = triangles[dart / 3].opposite[dart % 3];
    side[dart] = dart < across ? count++ : side[across];
  }
  return side;
}

std::vector<Triangle> halved(const std::vector<Triangle>& whole, std::uint32_t vertices) {
  const std::vector<std::uint32_t> side = sides_of(whole);
  std::vector<Triangle> result(4 * whole.size());
  for (std::uint32_t t = 0; t < whole.size(); ++t) {
    const auto& [point, vertex, opposite] = whole[t];
    std::array<Triple, 3> middle;
    std::array<std::uint32_t, 3> number;
    for (std::uint32_t i = 0; i < 3; ++i) {
      middle[i] = midpoint(point[i], point[(i + 1) % 3]);
      number[i] = vertices + side[3 * t + i];
    }
    const std::uint32_t inner = 4 * t + 3;
    result[inner].point = middle;
    result[inner].vertex = number;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t before = (i + 2) % 3;
      Triangle& small = result[4 * t + i];
      small.point = {point[i], middle[i], middle[before]};
      small.vertex = {vertex[i], number[i], number[before]};
      const std::uint32_t across = opposite[i];
      const std::uint32_t back = opposite[before];
      // `across` ends where this dart begins; `back` begins where the dart before ends.
      small.opposite = {3 * (4 * (across / 3) + (across % 3 + 1) % 3) + 2, 3 * inner + before,
                        3 * (4 * (back / 3) + back % 3)};
      result[inner].opposite[before] = 3 * (4 * t + i) + 1;
    }
  }
  return result;
}

/// A flat triangle by the squares of its sides.
struct Flat {
  explicit Flat(const Triple& of_sides) : squares(of_sides) {
    area = std::sqrt(4 * squares[0] * squares[1] - std::pow(squares[0] + squares[1] - squares[2], 2)) / 4;
    const double squared_radius = squares[0] * squares[1] * squares[2] / (16 * area * area);
    radius = std::sqrt(squared_radius);
    cosh = std::sqrt(1 + squared_radius);
    mean_power = (squares[0] + squares[1] + squares[2]) / 12;
    trace = squared_radius - mean_power;
    double parts = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      cotangent[k] = (squares[(k + 1) % 3] + squares[(k + 2) % 3] - squares[k]) / (4 * area);
      parts += std::pow(squares[k] * cotangent[k] / 4, 2);
    }
    greater = trace / 2 + std::sqrt(std::max(0.0, trace * trace / 4 - (4 * parts - area * area) / 36));
  }

  [[nodiscard]] double mean_of_inverse(double c) const {
    return 1 / (1 - c) - trace / (2 * cosh * (1 - c) * (cosh - c)) + greater / ((1 - c * cosh) * (cosh - c));
  }

  Triple squares;
  double area;
  double radius;
  double cosh;
  double mean_power;
  double trace;
  double greater;
  Triple cotangent{};
};

/// What a triangle adds: for the squares of three values, and for the products of the other two.
struct LocalForms {
  Triple energy_square;
  Triple energy_product;
  Triple mass_square;
  Triple mass_product;
};

/// Energy factor·∫|∇v|² of values in corners; mass ∫(constant − slope·ω)v², where ∫v² has these means of squares and
/// products, and ∫ωv² the integrals of docs/proof.md.
struct Weights {
  double square;
  double product;
  double square_opposite;
  double square_beside;
  double product_beside;
  double product_across;
};

LocalForms local_forms(const Flat& flat, double energy, double constant, double slope, const Weights& w) {
  LocalForms result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double others = flat.squares[(i + 1) % 3] + flat.squares[(i + 2) % 3];
    result.energy_square[i] = energy * (flat.cotangent[(i + 1) % 3] + flat.cotangent[(i + 2) % 3]) / 2;
    result.energy_product[i] = -energy * flat.cotangent[i] / 2;
    const double power = slope * flat.area / 180;
    result.mass_square[i] =
        constant * flat.area * w.square - power * (w.square_opposite * flat.squares[i] + w.square_beside * others);
    result.mass_product[i] =
        constant * flat.area * w.product - power * (w.product_beside * flat.squares[i] + w.product_across * others);
  }
  return result;
}

LocalForms lower_forms(const Flat& flat) {
  const double c = 1 / (1 + flat.radius);
  const double square = flat.cosh * flat.cosh;
  const double kappa = (square + flat.cosh + 1) / (square * (flat.cosh + 1));
  return local_forms(flat, 4 * (c + 1 / flat.mean_of_inverse(c)), flat.cosh, kappa, {1.0 / 3, 0, 7, 3, -1, 1});
}

LocalForms upper_forms(const Flat& flat) {
  const double mean = 1 + flat.mean_power;
  const double density = flat.cosh / (mean * std::sqrt(mean));
  const double slope = 1.5 / mean;
  return local_forms(flat, flat.mean_of_inverse(0), density * (1 + slope * flat.mean_power), density * slope,
                     {1.0 / 6, 1.0 / 12, 1, 3, 2, 1});
}

}  // namespace

Elements::Elements(const NetGeometry& geometry, std::uint32_t halvings) {
  const certify::NetDocument& net = geometry.document();
  std::vector<Triangle> triangles;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const auto corners = geometry.centred_corners(t);
    triangles.push_back({{on_hyperboloid(corners[0]), on_hyperboloid(corners[1]), on_hyperboloid(corners[2])},
                         net.triangles[t].vertex,
                         net.triangles[t].opposite});
  }
  vertex_count_ = static_cast<std::uint32_t>(net.vertices.size());
  for (std::uint32_t i = 0; i < halvings; ++i) {
    const auto sides = static_cast<std::uint32_t>(3 * triangles.size() / 2);
    triangles = halved(triangles, vertex_count_);
    vertex_count_ += sides;
  }
  side_count_ = static_cast<std::uint32_t>(3 * triangles.size() / 2);
  const std::vector<std::uint32_t> side = sides_of(triangles);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [point, vertex, opposite] = triangles[t];
    squares_.push_back({squared_distance(point[1], point[2]), squared_distance(point[2], point[0]),
                        squared_distance(point[0], point[1])});
    corners_.push_back(vertex);
    opposite_sides_.push_back({side[3 * t + 1], side[3 * t + 2], side[3 * t]});
  }
}

template <class Local>
ElementMatrices Elements::assembled(const Numbers& numbers, std::uint32_t size, const Local& local) const {
  using Entry = Eigen::Triplet<double>;
  std::vector<Entry> energy;
  std::vector<Entry> mass;
  const auto add = [&](std::uint32_t i, std::uint32_t j, double a, double b) {
    const auto row = static_cast<int>(std::max(i, j));
    const auto column = static_cast<int>(std::min(i, j));
    energy.emplace_back(row, column, a);
    mass.emplace_back(row, column, b);
  };
  for (std::size_t t = 0; t < squares_.size(); ++t) {
    const LocalForms forms = local(Flat(squares_[t]));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t j = numbers[t][(i + 1) % 3];
      const std::uint32_t k = numbers[t][(i + 2) % 3];
      add(numbers[t][i], numbers[t][i], forms.energy_square[i], forms.mass_square[i]);
      const double times = j == k ? 2 : 1;
      add(j, k, times * forms.energy_product[i], times * forms.mass_product[i]);
    }
  }
  const auto n = static_cast<Eigen::Index>(size);
  ElementMatrices result{Eigen::SparseMatrix<double>(n, n), Eigen::SparseMatrix<double>(n, n)};
  result.energy.setFromTriplets(energy.begin(), energy.end());
  result.mass.setFromTriplets(mass.begin(), mass.end());
  return result;
}

ElementMatrices Elements::lower() const { return assembled(opposite_sides_, side_count_, lower_forms); }
ElementMatrices Elements::upper() const { return assembled(corners_, vertex_count_, upper_forms); }

double Elements::interpolation() const {
  double greatest = 0;
  for (const Triple& squares : squares_) {
    const Flat flat(squares);
    const double longest = std::max({squares[0], squares[1], squares[2]});
    greatest = std::max(greatest, 0.1893 * 0.1893 * longest * flat.cosh * (1 + flat.radius));
  }
  return greatest;
}

}  // namespace epsnet
