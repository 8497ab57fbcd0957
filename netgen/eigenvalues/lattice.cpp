#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "kernel/numbers.h"
#include "netgen/eigenvalues/eigenvalues.h"

namespace epsnet {
namespace {

/// e^{2πi·turns}, nearest parts.
std::complex<double> on_unit_circle(const Rational& turns) {
  const Rational quarters = 4 * turns;
  if (denominator(quarters) == 1) {
    // From −1 to 2, as turns are in (−1/2, 1/2].
    constexpr std::array<std::complex<double>, 4> kUnits{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    return kUnits.at(static_cast<std::size_t>(Rational(quarters + 1)));
  }
  const Mp256 angle = boost::math::constants::two_pi<Mp256>() * Mp256(turns);
  return {static_cast<double>(Mp256(cos(angle))), static_cast<double>(Mp256(sin(angle)))};
}

/// A number that all eigenvalues of the matrix are within, in their order, of the sorted numbers `values`, for any
/// matrix of vectors. Let V = QS be its polar decomposition, δ ≥ ‖VᴴV − 1‖, ρ ≥ ‖HV − VΛ‖. Then ‖S − 1‖ ≤ δ, and
/// QᴴHQ − Λ = (SΛ − ΛS + Qᴴ(HV − VΛ))S⁻¹ has norm at most (2δ‖Λ‖ + ρ)/(1 − δ); by Weyl's theorem eigenvalues differ by
/// no more. Norms are bounded by Frobenius norms; infinite if δ ≥ 1/2.
template <class Matrix>
double distance_of_eigenvalues(const Matrix& h, const Matrix& vectors, const Eigen::VectorXd& values) {
  const auto n = static_cast<double>(h.rows());
  // Of a sum of products, and one more operation, relatively to the sum of moduli; complex ones are four real ones.
  const double rounding = 8 * (n + 8) * kUnitRoundoff;
  const double slack = 1 + 1e-6;  // For rounding errors in norms and in this bound, relatively.
  const double size = vectors.norm() * slack;
  const double greatest = values.cwiseAbs().maxCoeff();
  const double row_sums = h.cwiseAbs().rowwise().sum().maxCoeff();  // At least the norm of the matrix of moduli.
  const Matrix gram = vectors.adjoint() * vectors - Matrix::Identity(h.rows(), h.cols());
  const double skew = (gram.norm() + rounding * (size * size + std::sqrt(n))) * slack;
  const Matrix rest = h * vectors - vectors * values.asDiagonal();
  const double residual = (rest.norm() + rounding * (row_sums + greatest) * size) * slack;
  if (!(skew < 0.5)) return HUGE_VAL;
  return (2 * skew * greatest + residual) / (1 - skew) * slack;
}

template <class Matrix>
std::vector<certify::Interval> proved_eigenvalues(const Matrix& h, double error) {
  const Eigen::SelfAdjointEigenSolver<Matrix> found(h);
  if (found.info() != Eigen::Success) throw LimitError("the eigenvalues of the matrix were not found");
  const double within =
      (distance_of_eigenvalues<Matrix>(h, found.eigenvectors(), found.eigenvalues()) + error) * (1 + 1e-6);
  // Coarse ends do not depend on rounding, which may differ between machines.
  double step = 0x1p-30;
  while (step < 0x1p-19 && step < 16 * within) step *= 2;
  if (!(16 * within <= step)) throw LimitError("the eigenvalues of the matrix were not proved");
  std::vector<certify::Interval> result;
  for (const double value : found.eigenvalues()) {
    result.push_back({std::floor((value - within) / step) * step, std::ceil((value + within) / step) * step});
  }
  return result;
}

}  // namespace

HermitianMatrix lattice_matrix(const Surface& surface, GraphNodes nodes, const std::vector<Rational>& turns) {
  const ById<SideId, Rational> phases =
      turns.empty() ? ById<SideId, Rational>(surface.side_count()) : phases_of_sides(surface, turns);
  HermitianMatrix result{.size = nodes == GraphNodes::vertices ? surface.vertex_class_count()
                                                               : std::uint32_t(surface.tiles().size())};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::complex<double>> lower;  // By column and row.
  std::vector<std::uint32_t> degree(result.size);
  for (const auto& [from, to, turn] : phased_steps(surface, nodes, phases)) {
    ++degree[from];
    // The step back has the opposite phase, and its entry above the diagonal is the conjugate one.
    if (to <= from) lower[{to, from}] += on_unit_circle(turn);
  }
  for (const auto& [place, value] : lower) {
    // Both directions of a loop are on the diagonal: their sum is real.
    const auto [column, row] = place;
    result.entries.push_back({row, column, row == column ? std::complex<double>(value.real()) : value});
  }
  // Parts of e^{2πi·turns} are rounded, and d sums of at most d of them; the norm is at most a sum of a row.
  const double greatest = result.size == 0 ? 0 : *std::max_element(degree.begin(), degree.end());
  if (!turns.empty()) result.error = 4 * greatest * (greatest + 1) * kUnitRoundoff;
  return result;
}

std::vector<certify::Interval> eigenvalues(const HermitianMatrix& matrix) {
  if (matrix.size > kMostLatticeNodes) {
    throw LimitError("eigenvalues of a lattice of " + std::to_string(matrix.size) + " nodes: at most " +
                     std::to_string(kMostLatticeNodes) + " are possible");
  }
  if (matrix.size == 0) return {};
  const auto is_real = [](const HermitianMatrix::Entry& entry) { return entry.value.imag() == 0; };
  const auto n = static_cast<Eigen::Index>(matrix.size);
  if (std::all_of(matrix.entries.begin(), matrix.entries.end(), is_real)) {
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [row, column, value] : matrix.entries) h(row, column) = h(column, row) = value.real();
    return proved_eigenvalues(h, matrix.error);
  }
  Eigen::MatrixXcd h = Eigen::MatrixXcd::Zero(n, n);
  for (const auto& [row, column, value] : matrix.entries) {
    h(row, column) = value;
    h(column, row) = std::conj(value);
  }
  return proved_eigenvalues(h, matrix.error);
}

void write_matrix_market(const HermitianMatrix& matrix, std::ostream& out) {
  const auto is_integer = [](const HermitianMatrix::Entry& entry) {
    return entry.value.imag() == 0 && entry.value.real() == std::round(entry.value.real());
  };
  const bool integers = std::all_of(matrix.entries.begin(), matrix.entries.end(), is_integer);
  out << "%%MatrixMarket matrix coordinate " << (integers ? "integer symmetric" : "complex hermitian") << '\n'
      << matrix.size << ' ' << matrix.size << ' ' << matrix.entries.size() << '\n';
  for (const auto& [row, column, value] : matrix.entries) {
    out << row + 1 << ' ' << column + 1 << ' ';
    if (integers) {
      out << std::llround(value.real()) << '\n';
    } else {
      out << certify::shortest(value.real()) << ' ' << certify::shortest(value.imag()) << '\n';
    }
  }
}

}  // namespace epsnet
