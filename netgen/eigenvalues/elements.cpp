#include "netgen/eigenvalues/elements.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Spectra/SymGEigsShiftSolver.h>
#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <utility>

#ifndef __EMSCRIPTEN__
#include <metis.h>
#endif

#include "certify/numbers/parallel.h"
#include "netgen/nets/certified_net.h"

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

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

using Factors = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// By place, what is eliminated there. Nested dissection by METIS, which takes a third or less of the operations that
/// minimum degree takes.
Permutation ordering(const Matrix& symmetric) {
  Permutation order;
#ifdef __EMSCRIPTEN__
  Eigen::AMDOrdering<int>()(symmetric, order);
#else
  auto size = static_cast<idx_t>(symmetric.rows());
  std::vector<idx_t> first{0};
  std::vector<idx_t> neighbours;
  for (Eigen::Index column = 0; column < size; ++column) {
    for (Matrix::InnerIterator entry(symmetric, column); entry; ++entry) {
      if (entry.row() != column) neighbours.push_back(static_cast<idx_t>(entry.row()));
    }
    first.push_back(static_cast<idx_t>(neighbours.size()));
  }
  std::vector<idx_t> by_place(static_cast<std::size_t>(size));
  std::vector<idx_t> places(by_place.size());
  if (METIS_NodeND(&size, first.data(), neighbours.data(), nullptr, nullptr, by_place.data(), places.data()) !=
      METIS_OK) {
    throw std::bad_alloc();
  }
  order.resize(size);
  std::copy(by_place.begin(), by_place.end(), order.indices().data());
#endif
  return order;
}

/// By number its place in an order.
Permutation places_of(const std::vector<std::uint32_t>& order) {
  Permutation result(static_cast<Eigen::Index>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) result.indices()[order[i]] = static_cast<int>(i);
  return result;
}

/// With rows and columns in another order.
Matrix ordered(const Matrix& lower_half, const Permutation& places) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(lower_half.nonZeros()));
  for (Eigen::Index column = 0; column < lower_half.cols(); ++column) {
    for (Matrix::InnerIterator entry(lower_half, column); entry; ++entry) {
      const auto [first, second] = std::minmax(places.indices()[entry.row()], places.indices()[column]);
      entries.emplace_back(second, first, entry.value());
    }
  }
  Matrix result(lower_half.rows(), lower_half.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// x ↦ (A − σM)⁻¹ x, by elimination in the order of the rows; 0 on eigenvectors that are known.
class Inverse {
 public:
  using Scalar = double;
  explicit Inverse(const ElementMatrices& matrices) : matrices_(matrices), known_(rows(), 0) {}
  [[nodiscard]] Eigen::Index rows() const { return matrices_.energy.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return matrices_.energy.cols(); }
  void set_shift(double sigma) {
    if (sigma == sigma_) return;
    sigma_ = sigma;
    factors_.compute(Matrix(matrices_.energy - sigma * matrices_.mass));
    if (factors_.info() != Eigen::Success) throw NetError("a matrix of finite elements is singular");
  }
  void perform_op(const double* x, double* y) const {
    const Eigen::Map<const Eigen::VectorXd> from(x, rows());
    Eigen::Map<Eigen::VectorXd> to(y, rows());
    to = factors_.solve(from);
    if (known_.cols() > 0) to -= known_ * weights_.cwiseProduct(known_.transpose() * from);
  }
  /// Eigenvectors of these values, whose M-norm is 1.
  void set_known(const std::vector<double>& values, const Eigen::MatrixXd& vectors) {
    known_ = vectors;
    weights_ = (Eigen::Map<const Eigen::VectorXd>(values.data(), known_.cols()).array() - sigma_).inverse();
  }

 private:
  const ElementMatrices& matrices_;
  double sigma_ = HUGE_VAL;
  Factors factors_;
  Eigen::MatrixXd known_;
  Eigen::VectorXd weights_;
};

/// x ↦ M x
class Mass {
 public:
  using Scalar = double;
  explicit Mass(const Matrix& mass) : mass_(mass) {}
  [[nodiscard]] Eigen::Index rows() const { return mass_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return mass_.cols(); }
  void perform_op(const double* x, double* y) const {
    Eigen::Map<Eigen::VectorXd>(y, rows()) =
        mass_.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(x, rows());
  }

 private:
  const Matrix& mass_;
};

/// In increasing order.
DiscreteSpectrum merged(const DiscreteSpectrum& one, const DiscreteSpectrum& other) {
  DiscreteSpectrum all{one.values, Eigen::MatrixXd(other.vectors.rows(), one.vectors.cols() + other.vectors.cols())};
  all.values.insert(all.values.end(), other.values.begin(), other.values.end());
  all.vectors << one.vectors, other.vectors;
  std::vector<std::size_t> order(all.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return all.values[i] < all.values[j]; });
  DiscreteSpectrum result{{}, Eigen::MatrixXd(all.vectors.rows(), all.vectors.cols())};
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.values.push_back(all.values[order[i]]);
    result.vectors.col(static_cast<Eigen::Index>(i)) = all.vectors.col(static_cast<Eigen::Index>(order[i]));
  }
  return result;
}

/// By Lanczos's method, so many of the first eigenvalues of those that are not known.
DiscreteSpectrum more_eigenvalues(Inverse& inverse, Mass& mass, Eigen::Index wanted) {
  constexpr double kShift = -0.1;
  constexpr double kTolerance = 1e-8;
  constexpr int kMostRestarts = 300;
  Spectra::SymGEigsShiftSolver<Inverse, Mass, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, mass, wanted, std::min(2 * wanted + 20, mass.rows()), kShift);
  solver.init();
  const Eigen::Index found =
      solver.compute(Spectra::SortRule::LargestMagn, kMostRestarts, kTolerance, Spectra::SortRule::SmallestAlge);
  const Eigen::VectorXd values = solver.eigenvalues();
  DiscreteSpectrum result{{values.data(), values.data() + found}, solver.eigenvectors()};
  for (Eigen::Index k = 0; k < found; ++k) {
    Eigen::VectorXd image(mass.rows());
    mass.perform_op(result.vectors.col(k).data(), image.data());
    result.vectors.col(k) /= std::sqrt(result.vectors.col(k).dot(image));
  }
  return result;
}

}  // namespace

std::vector<std::uint32_t> elimination_order(const Matrix& lower_half) {
  const Permutation order = ordering(lower_half.selfadjointView<Eigen::Lower>());
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

certify::Inertia inertia(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order, double sigma,
                         certify::Bound bound, unsigned threads, std::optional<std::uint64_t> wanted) {
  const Matrix shifted = matrices.energy - sigma * matrices.mass;
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<certify::MatrixEntry> entries;
  for (Eigen::Index column = 0; column < shifted.cols(); ++column) {
    for (Matrix::InnerIterator entry(shifted, column); entry; ++entry) {
      const auto [first, second] =
          std::minmax(place[static_cast<std::size_t>(entry.row())], place[static_cast<std::size_t>(column)]);
      entries.push_back({second, first, entry.value(), 0});
    }
  }
  const certify::SparseMatrix matrix(static_cast<std::uint32_t>(order.size()), std::move(entries));
  return matrix.negative_eigenvalues(bound, {}, certify::thread_count(threads), wanted);
}

DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order,
                                   std::uint32_t count) {
  constexpr double kGap = 1e-5;
  constexpr Eigen::Index kMore = 8;
  constexpr int kMostInVain = 3;
  const Permutation places = places_of(order);
  const ElementMatrices in_order{ordered(matrices.energy, places), ordered(matrices.mass, places)};
  const Eigen::Index size = matrices.energy.rows();
  Inverse inverse(in_order);
  Mass mass(in_order.mass);
  // Of several eigenvalues that are equal, or nearly, the method finds some; counting says whether there are others.
  DiscreteSpectrum known{{}, Eigen::MatrixXd(size, 0)};
  Eigen::Index missing = count;
  for (int in_vain = 0; in_vain < kMostInVain;) {
    const Eigen::Index wanted = std::min(missing + kMore, size - 2 - known.vectors.cols());
    if (wanted < 1) break;
    known = merged(known, more_eigenvalues(inverse, mass, wanted));
    inverse.set_known(known.values, known.vectors);
    // Counted where there is a gap: those that are equal, but for rounding, are not told apart by counting.
    std::size_t gap = count;
    while (gap < known.values.size() && known.values[gap] - known.values[gap - 1] <= kGap * known.values[gap]) ++gap;
    if (gap >= known.values.size()) continue;
    const double between = (known.values[gap - 1] + known.values[gap]) / 2;
    const std::uint32_t below = inertia(matrices, order, between, certify::Bound::upper, 1, gap).negative;
    if (below == gap) {
      const auto enough = static_cast<Eigen::Index>(count);
      return {{known.values.begin(), known.values.begin() + enough},
              places.transpose() * known.vectors.leftCols(enough)};
    }
    const Eigen::Index before = std::exchange(
        missing, std::max<Eigen::Index>(1, static_cast<Eigen::Index>(below) - static_cast<Eigen::Index>(gap)));
    if (missing >= before) ++in_vain;
  }
  throw NetError(
      "Lanczos's method finds too few eigenvalues of a net, as around a closed geodesic that is too short for numbers "
      "of "
      "binary64");
}

}  // namespace epsnet
