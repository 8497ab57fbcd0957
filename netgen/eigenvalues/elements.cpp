#include "netgen/eigenvalues/elements.h"

#include <Eigen/Eigenvalues>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Spectra/SymGEigsShiftSolver.h>
#include <algorithm>
#include <cmath>
#include <complex>
#include <new>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#ifndef __EMSCRIPTEN__
#include <metis.h>
#endif

#include "certify/net/numbering.h"
#include "certify/numbers/parallel.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/group.h"

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
  /// A function has in corner i, seen from the triangle, its value at the vertex times e^{2πi turns[i]}.
  Triple turns;
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

/// A function has on the side of the dart, seen from the triangle, its value seen from that of the smaller dart times
/// e^{2πi·this}: at the start of the dart both see the same vertex.
double turns_of_side(const std::vector<Triangle>& triangles, std::uint32_t dart) {
  const std::uint32_t across = triangles[dart / 3].opposite[dart % 3];
  if (dart < across) return 0;
  return triangles[dart / 3].turns[dart % 3] - triangles[across / 3].turns[(across % 3 + 1) % 3];
}

std::vector<Triangle> halved(const std::vector<Triangle>& whole, std::uint32_t vertices) {
  const std::vector<std::uint32_t> side = sides_of(whole);
  std::vector<Triangle> result(4 * whole.size());
  for (std::uint32_t t = 0; t < whole.size(); ++t) {
    const auto& [point, vertex, opposite, turns] = whole[t];
    std::array<Triple, 3> middle;
    std::array<std::uint32_t, 3> number;
    Triple turns_of_middle;
    for (std::uint32_t i = 0; i < 3; ++i) {
      middle[i] = midpoint(point[i], point[(i + 1) % 3]);
      number[i] = vertices + side[3 * t + i];
      turns_of_middle[i] = turns_of_side(whole, 3 * t + i);
    }
    const std::uint32_t inner = 4 * t + 3;
    result[inner].point = middle;
    result[inner].vertex = number;
    result[inner].turns = turns_of_middle;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t before = (i + 2) % 3;
      Triangle& small = result[4 * t + i];
      small.point = {point[i], middle[i], middle[before]};
      small.vertex = {vertex[i], number[i], number[before]};
      small.turns = {turns[i], turns_of_middle[i], turns_of_middle[before]};
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

LocalForms local_forms(const FlatTriangle& flat, double energy, double constant, double slope, const Weights& w) {
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

LocalForms lower_forms(const FlatTriangle& flat) {
  const double c = 1 / (1 + flat.radius);
  const double square = flat.cosh * flat.cosh;
  const double kappa = (square + flat.cosh + 1) / (square * (flat.cosh + 1));
  return local_forms(flat, 4 * (c + 1 / flat.mean_of_inverse(c)), flat.cosh, kappa, {1.0 / 3, 0, 7, 3, -1, 1});
}

LocalForms upper_forms(const FlatTriangle& flat) {
  const double mean = 1 + flat.mean_power;
  const double density = flat.cosh / (mean * std::sqrt(mean));
  const double slope = 1.5 / mean;
  return local_forms(flat, flat.mean_of_inverse(0), density * (1 + slope * flat.mean_power), density * slope,
                     {1.0 / 6, 1.0 / 12, 1, 3, 2, 1});
}

/// e^{2πi turns}; exactly for multiples of 1/4.
std::complex<double> unit(double turns) {
  const double quarters = std::round(4 * turns);
  const double angle = 2 * std::numbers::pi * (turns - quarters / 4);
  const std::complex<double> near_one(std::cos(angle), std::sin(angle));
  switch ((static_cast<long>(quarters) % 4 + 4) % 4) {
    case 0:
      return near_one;
    case 1:
      return {-near_one.imag(), near_one.real()};
    case 2:
      return -near_one;
    default:
      return {near_one.imag(), -near_one.real()};
  }
}

}  // namespace

FlatTriangle::FlatTriangle(const std::array<double, 3>& of_sides) : squares(of_sides) {
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

double FlatTriangle::mean_of_inverse(double c) const {
  return 1 / (1 - c) - trace / (2 * cosh * (1 - c) * (cosh - c)) + greater / ((1 - c * cosh) * (cosh - c));
}

std::vector<double> turns_of_labels(const certify::NetDocument& net, const ById<SideId, Rational>& phases) {
  std::vector<double> result{0};
  for (const certify::NetDocument::Label& label : net.labels) result.push_back(phase_of_word(phases, label.word));
  return result;
}

double sigma_for(double tau, double interpolation) {
  const double room = 1 - interpolation * (1 + 1e-10) * tau;
  return room > 0 ? tau / room * (1 + 1e-12) : HUGE_VAL;
}

Elements::Elements(const NetGeometry& geometry, std::uint32_t halvings, const std::vector<double>& turns) {
  const certify::NetDocument& net = geometry.document();
  std::vector<Triangle> triangles;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const auto corners = geometry.centred_corners(t);
    Triple of_corners{};
    for (std::uint32_t i = 0; i < 3 && !turns.empty(); ++i)
      of_corners[i] = turns[certify::corner_label(net, 3 * t + i)];
    triangles.push_back({{on_hyperboloid(corners[0]), on_hyperboloid(corners[1]), on_hyperboloid(corners[2])},
                         net.triangles[t].vertex,
                         net.triangles[t].opposite,
                         of_corners});
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
    const auto& [point, vertex, opposite, of_corners] = triangles[t];
    squares_.push_back({squared_distance(point[1], point[2]), squared_distance(point[2], point[0]),
                        squared_distance(point[0], point[1])});
    corners_.push_back(vertex);
    opposite_sides_.push_back({side[3 * t + 1], side[3 * t + 2], side[3 * t]});
    if (turns.empty()) continue;
    const auto dart = static_cast<std::uint32_t>(3 * t);
    turns_of_corners_.push_back(of_corners);
    turns_of_sides_.push_back(
        {turns_of_side(triangles, dart + 1), turns_of_side(triangles, dart + 2), turns_of_side(triangles, dart)});
  }
}

template <class Local>
ElementMatrices Elements::assembled(const Numbers& numbers, const Turns& turns, std::uint32_t size,
                                    const Local& local) const {
  using Entry = Eigen::Triplet<double>;
  std::vector<Entry> energy;
  std::vector<Entry> mass;
  std::vector<Entry> imaginary_energy;
  std::vector<Entry> imaginary_mass;
  const auto add = [&](std::uint32_t i, std::uint32_t j, double a, double b) {
    const auto row = static_cast<int>(std::max(i, j));
    const auto column = static_cast<int>(std::min(i, j));
    energy.emplace_back(row, column, a);
    mass.emplace_back(row, column, b);
  };
  bool is_real = true;
  for (std::size_t t = 0; t < squares_.size(); ++t) {
    const LocalForms forms = local(FlatTriangle(squares_[t]));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t after = (i + 1) % 3;
      const std::size_t before = (i + 2) % 3;
      const std::uint32_t j = numbers[t][after];
      const std::uint32_t k = numbers[t][before];
      add(numbers[t][i], numbers[t][i], forms.energy_square[i], forms.mass_square[i]);
      const double times = j == k ? 2 : 1;
      const double a = times * forms.energy_product[i];
      const double b = times * forms.mass_product[i];
      if (turns.empty()) {
        add(j, k, a, b);
        continue;
      }
      // x̄y in the form is the entry in the row of x and the column of y.
      const double difference = turns[t][before] - turns[t][after];
      const std::complex<double> phase = unit(j > k ? difference : -difference);
      add(j, k, a * phase.real(), b * phase.real());
      if (j == k) continue;
      imaginary_energy.emplace_back(energy.back().row(), energy.back().col(), a * phase.imag());
      imaginary_mass.emplace_back(mass.back().row(), mass.back().col(), b * phase.imag());
      is_real = is_real && phase.imag() == 0;
    }
  }
  const auto n = static_cast<Eigen::Index>(size);
  const auto matrix = [n](const std::vector<Entry>& entries) {
    Eigen::SparseMatrix<double> result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  };
  if (is_real) return {matrix(energy), matrix(mass)};
  return {matrix(energy), matrix(mass), matrix(imaginary_energy), matrix(imaginary_mass)};
}

ElementMatrices Elements::lower() const {
  return assembled(opposite_sides_, turns_of_sides_, side_count_, lower_forms);
}
ElementMatrices Elements::upper() const { return assembled(corners_, turns_of_corners_, vertex_count_, upper_forms); }

double Elements::interpolation() const {
  double greatest = 0;
  for (const Triple& squares : squares_) {
    const FlatTriangle flat(squares);
    const double longest = std::max({squares[0], squares[1], squares[2]});
    const double here = 0.1893 * 0.1893 * longest * flat.cosh * (1 + flat.radius);
    if (std::isnan(here)) return here;
    greatest = std::max(greatest, here);
  }
  return greatest;
}

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

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

/// The lower half of a symmetric matrix, or of a Hermitian one.
template <class Scalar>
using Half = Eigen::SparseMatrix<Scalar>;

/// With rows and columns in another order.
template <class Scalar>
Half<Scalar> ordered(const Half<Scalar>& lower_half, const Permutation& places) {
  std::vector<Eigen::Triplet<Scalar>> entries;
  entries.reserve(static_cast<std::size_t>(lower_half.nonZeros()));
  for (Eigen::Index column = 0; column < lower_half.cols(); ++column) {
    for (typename Half<Scalar>::InnerIterator entry(lower_half, column); entry; ++entry) {
      const int here = places.indices()[entry.row()];
      const int there = places.indices()[column];
      entries.emplace_back(std::max(here, there), std::min(here, there),
                           here < there ? Eigen::numext::conj(entry.value()) : entry.value());
    }
  }
  Half<Scalar> result(lower_half.rows(), lower_half.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

template <class Scalar>
using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// The matrices of an eigenproblem A x = λ M x.
template <class Scalar>
struct Pencil {
  Half<Scalar> energy;
  Half<Scalar> mass;
};

Pencil<std::complex<double>> hermitian(const ElementMatrices& matrices) {
  const auto of_parts = [](const Matrix& real, const Matrix& imaginary) {
    const std::complex<double> i(0, 1);
    return Half<std::complex<double>>(real.cast<std::complex<double>>() + i * imaginary.cast<std::complex<double>>());
  };
  return {of_parts(matrices.energy, matrices.imaginary_energy), of_parts(matrices.mass, matrices.imaginary_mass)};
}

/// Eigenvalues in increasing order, and the vectors as columns.
template <class Scalar>
struct Eigenpairs {
  std::vector<double> values;
  Columns<Scalar> vectors;
};

/// x ↦ (A − σM)⁻¹ x, by elimination in the order of the rows; 0 on eigenvectors that are known.
template <class Number>
class Inverse {
 public:
  using Scalar = Number;
  explicit Inverse(const Pencil<Scalar>& matrices) : matrices_(matrices), known_(rows(), 0) {}
  [[nodiscard]] Eigen::Index rows() const { return matrices_.energy.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return matrices_.energy.cols(); }
  void set_shift(double sigma) {
    if (sigma == sigma_) return;
    sigma_ = sigma;
    factors_.compute(Half<Scalar>(matrices_.energy - sigma * matrices_.mass));
    if (factors_.info() != Eigen::Success)
      throw NetError(
          "a matrix of finite elements is singular, as around a closed geodesic that is too short for numbers of "
          "binary64");
  }
  void perform_op(const Scalar* x, Scalar* y) const {
    const Eigen::Map<const Column<Scalar>> from(x, rows());
    Eigen::Map<Column<Scalar>> to(y, rows());
    to = factors_.solve(from);
    if (known_.cols() > 0) to -= known_ * weights_.cwiseProduct(known_.adjoint() * from);
  }
  /// Eigenvectors of these values, whose M-norm is 1.
  void set_known(const Eigenpairs<Scalar>& known) {
    known_ = known.vectors;
    weights_ = (Eigen::Map<const Eigen::VectorXd>(known.values.data(), known_.cols()).array() - sigma_)
                   .inverse()
                   .template cast<Scalar>();
  }
  [[nodiscard]] Eigen::Index known() const { return known_.cols(); }

 private:
  const Pencil<Scalar>& matrices_;
  double sigma_ = HUGE_VAL;
  Eigen::SimplicialLDLT<Half<Scalar>, Eigen::Lower, Eigen::NaturalOrdering<int>> factors_;
  Columns<Scalar> known_;
  Column<Scalar> weights_;
};

/// x ↦ M x
template <class Number>
class Mass {
 public:
  using Scalar = Number;
  explicit Mass(const Half<Scalar>& mass) : mass_(mass) {}
  [[nodiscard]] Eigen::Index rows() const { return mass_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return mass_.cols(); }
  void perform_op(const Scalar* x, Scalar* y) const {
    Eigen::Map<Column<Scalar>>(y, rows()) =
        mass_.template selfadjointView<Eigen::Lower>() * Eigen::Map<const Column<Scalar>>(x, rows());
  }
  [[nodiscard]] Column<Scalar> operator()(const Column<Scalar>& x) const {
    return mass_.template selfadjointView<Eigen::Lower>() * x;
  }

 private:
  const Half<Scalar>& mass_;
};

/// In increasing order.
template <class Scalar>
Eigenpairs<Scalar> merged(const Eigenpairs<Scalar>& one, const Eigenpairs<Scalar>& other) {
  Eigenpairs<Scalar> all{one.values, Columns<Scalar>(other.vectors.rows(), one.vectors.cols() + other.vectors.cols())};
  all.values.insert(all.values.end(), other.values.begin(), other.values.end());
  all.vectors << one.vectors, other.vectors;
  std::vector<std::size_t> order(all.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return all.values[i] < all.values[j]; });
  Eigenpairs<Scalar> result{{}, Columns<Scalar>(all.vectors.rows(), all.vectors.cols())};
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.values.push_back(all.values[order[i]]);
    result.vectors.col(static_cast<Eigen::Index>(i)) = all.vectors.col(static_cast<Eigen::Index>(order[i]));
  }
  return result;
}

constexpr double kShift = -0.1;
constexpr double kTolerance = 1e-8;

/// By Lanczos's method, so many of the first eigenvalues of those that are not known.
Eigenpairs<double> more_eigenvalues(Inverse<double>& inverse, Mass<double>& mass, Eigen::Index wanted) {
  constexpr int kMostRestarts = 300;
  Spectra::SymGEigsShiftSolver<Inverse<double>, Mass<double>, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, mass, wanted, std::min(2 * wanted + 20, mass.rows()), kShift);
  solver.init();
  const Eigen::Index found =
      solver.compute(Spectra::SortRule::LargestMagn, kMostRestarts, kTolerance, Spectra::SortRule::SmallestAlge);
  const Eigen::VectorXd values = solver.eigenvalues();
  Eigenpairs<double> result{{values.data(), values.data() + found}, solver.eigenvectors()};
  for (Eigen::Index k = 0; k < found; ++k)
    result.vectors.col(k) /= std::sqrt(result.vectors.col(k).dot(mass(result.vectors.col(k))));
  return result;
}

/// The same for Hermitian matrices, without restarts. Spectra has it for real ones alone; the real matrix of twice the
/// size would have every eigenvalue twice, and take twice the time.
Eigenpairs<std::complex<double>> more_eigenvalues(Inverse<std::complex<double>>& inverse,
                                                  Mass<std::complex<double>>& mass, Eigen::Index wanted) {
  inverse.set_shift(kShift);
  const Eigen::Index size = mass.rows();
  const Eigen::Index most = std::min(size, 20 * wanted + 200);
  // Another start each time: what is orthogonal to it in an eigenspace is not found.
  std::mt19937_64 engine(static_cast<std::uint64_t>(inverse.known()));
  const auto next = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5; };
  Column<std::complex<double>> candidate(size);
  for (std::complex<double>& x : candidate) x = {next(), next()};
  Columns<std::complex<double>> basis(size, std::min(most, 2 * wanted + 20));
  std::vector<double> diagonal;
  std::vector<double> beside;
  double length = std::sqrt(std::real(candidate.dot(mass(candidate))));
  Column<std::complex<double>> image(size);
  for (Eigen::Index steps = 0;;) {
    if (steps == basis.cols()) basis.conservativeResize(Eigen::NoChange, std::min(most, 2 * steps));
    basis.col(steps) = candidate / length;
    image = mass(basis.col(steps));
    inverse.perform_op(image.data(), candidate.data());
    diagonal.push_back(std::real(image.dot(candidate)));
    ++steps;
    candidate -= diagonal.back() * basis.col(steps - 1);
    if (steps > 1) candidate -= beside.back() * basis.col(steps - 2);
    const auto found = basis.leftCols(steps);
    candidate -= found * (found.adjoint() * mass(candidate));
    length = std::sqrt(std::max(0.0, std::real(candidate.dot(mass(candidate)))));
    const bool ends = steps == most || length < 1e-14 * std::abs(diagonal.front());
    constexpr Eigen::Index kBetween = 10;
    if (ends || (steps >= wanted && steps % kBetween == 0)) {
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
      small.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), steps),
                                   Eigen::Map<const Eigen::VectorXd>(beside.data(), steps - 1));
      // The greatest 1/(λ − σ) first.
      Eigen::Index good = 0;
      const auto place = [&](Eigen::Index k) { return steps - 1 - k; };
      while (good < std::min(wanted, steps) && length * std::abs(small.eigenvectors()(steps - 1, place(good))) <=
                                                   kTolerance * std::abs(small.eigenvalues()[place(good)])) {
        ++good;
      }
      if (ends || good == wanted) {
        Eigenpairs<std::complex<double>> result{{}, Columns<std::complex<double>>(size, good)};
        for (Eigen::Index k = 0; k < good; ++k) {
          result.values.push_back(kShift + 1 / small.eigenvalues()[place(k)]);
          result.vectors.col(k) = found * small.eigenvectors().col(place(k));
        }
        return result;
      }
    }
    beside.push_back(length);
  }
}

/// The first `count` eigenpairs, or all if there are fewer. count_below(x, k) is the number of eigenvalues less than x,
/// which is about k.
template <class Scalar, class Count>
Eigenpairs<Scalar> first_pairs(const Pencil<Scalar>& matrices, std::uint32_t count, const Count& count_below) {
  constexpr double kGap = 1e-5;
  constexpr Eigen::Index kMore = 8;
  constexpr int kMostInVain = 3;
  const Eigen::Index size = matrices.energy.rows();
  Inverse<Scalar> inverse(matrices);
  Mass<Scalar> mass(matrices.mass);
  // Of several eigenvalues that are equal, or nearly, the method finds some; counting says whether there are others.
  Eigenpairs<Scalar> known{{}, Columns<Scalar>(size, 0)};
  Eigen::Index missing = count;
  for (int in_vain = 0; in_vain < kMostInVain;) {
    const Eigen::Index wanted = std::min(missing + kMore, size - 2 - known.vectors.cols());
    if (wanted < 1) break;
    const Eigenpairs<Scalar> more = more_eigenvalues(inverse, mass, wanted);
    if (more.values.empty()) break;
    known = merged(known, more);
    inverse.set_known(known);
    // Counted where there is a gap: those that are equal, but for rounding, are not told apart by counting.
    std::size_t gap = count;
    while (gap < known.values.size() && known.values[gap] - known.values[gap - 1] <= kGap * known.values[gap]) ++gap;
    if (gap >= known.values.size()) continue;
    const std::uint32_t below = count_below((known.values[gap - 1] + known.values[gap]) / 2, gap);
    if (below == gap) {
      const auto enough = static_cast<Eigen::Index>(count);
      return {{known.values.begin(), known.values.begin() + enough}, known.vectors.leftCols(enough)};
    }
    const Eigen::Index before = std::exchange(
        missing, std::max<Eigen::Index>(1, static_cast<Eigen::Index>(below) - static_cast<Eigen::Index>(gap)));
    if (missing >= before) ++in_vain;
  }
  throw NetError(
      "Lanczos's method finds too few eigenvalues of a net, as around a closed geodesic that is too short for numbers "
      "of binary64");
}

}  // namespace

std::vector<std::uint32_t> elimination_order(const Matrix& lower_half) {
  const Permutation order = ordering(lower_half.selfadjointView<Eigen::Lower>());
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

certify::Inertia inertia(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order, double sigma,
                         certify::Bound bound, unsigned threads, std::optional<std::uint64_t> wanted) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<certify::MatrixEntry> entries;
  // As the place in the order asks for; it may be above the diagonal, where the entry is the conjugate.
  const auto for_each_entry = [&](const Matrix& lower_half, const auto& add) {
    for (Eigen::Index column = 0; column < lower_half.cols(); ++column) {
      for (Matrix::InnerIterator entry(lower_half, column); entry; ++entry)
        add(place[static_cast<std::size_t>(entry.row())], place[static_cast<std::size_t>(column)], entry.value());
    }
  };
  const Matrix shifted = matrices.energy - sigma * matrices.mass;
  const auto size = static_cast<std::uint32_t>(order.size());
  if (matrices.is_real()) {
    for_each_entry(shifted, [&](std::uint32_t i, std::uint32_t j, double value) {
      entries.push_back({std::max(i, j), std::min(i, j), value, 0});
    });
    const certify::SparseMatrix matrix(size, std::move(entries));
    return matrix.negative_eigenvalues(bound, {}, certify::thread_count(threads), wanted);
  }
  // a + bi is the block (a, −b; b, a).
  for_each_entry(shifted, [&](std::uint32_t i, std::uint32_t j, double value) {
    for (const std::uint32_t part : {0U, 1U})
      entries.push_back({2 * std::max(i, j) + part, 2 * std::min(i, j) + part, value, 0});
  });
  for_each_entry(Matrix(matrices.imaginary_energy - sigma * matrices.imaginary_mass),
                 [&](std::uint32_t i, std::uint32_t j, double value) {
                   const double below_diagonal = i > j ? value : -value;
                   entries.push_back({2 * std::max(i, j), 2 * std::min(i, j) + 1, -below_diagonal, 0});
                   entries.push_back({2 * std::max(i, j) + 1, 2 * std::min(i, j), below_diagonal, 0});
                 });
  const certify::SparseMatrix matrix(2 * size, std::move(entries));
  // The number is a multiple of two: one more than an upper bound, or one less than a lower one, is enough.
  if (wanted) *wanted = bound == certify::Bound::upper ? 2 * *wanted + 1 : std::max<std::uint64_t>(2 * *wanted, 1) - 1;
  certify::Inertia twice = matrix.negative_eigenvalues(bound, {}, certify::thread_count(threads), wanted);
  twice.negative = bound == certify::Bound::upper ? twice.negative / 2 : (twice.negative + 1) / 2;
  return twice;
}

DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order,
                                   std::uint32_t count) {
  const Permutation places = places_of(order);
  const auto count_below = [&](double x, std::uint64_t about) {
    return inertia(matrices, order, x, certify::Bound::upper, 1, about).negative;
  };
  if (!matrices.is_real()) {
    const auto [energy, mass] = hermitian(matrices);
    return {
        first_pairs<std::complex<double>>({ordered(energy, places), ordered(mass, places)}, count, count_below).values,
        {}};
  }
  const auto [values, vectors] =
      first_pairs<double>({ordered(matrices.energy, places), ordered(matrices.mass, places)}, count, count_below);
  return {values, places.transpose() * vectors};
}

}  // namespace epsnet
