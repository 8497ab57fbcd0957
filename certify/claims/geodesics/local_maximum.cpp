#include "certify/claims/geodesics/local_maximum.h"

#include <algorithm>
#include <cstddef>

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

#include "certify/base/error.h"

namespace epsnet::certify {
namespace {

/// What a twist along the line m, as far as the line n crosses it there, adds to the derivative of the length of n's
/// geodesic. Rows of unit normals; the directions of the lines do not matter. Nothing if the sign is not decided.
std::optional<Ball> change_of_length(const BallVector& m, const BallVector& n, slong precision) {
  const int turn = certain_sign(m[0] * n[1] - m[1] * n[0]);
  if (turn == 0) return std::nullopt;
  return turn * lorentz_product(m, n, precision);
}

class DenseMatrix {
 public:
  DenseMatrix(std::size_t rows, std::size_t columns) {
    arb_mat_init(matrix_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~DenseMatrix() { arb_mat_clear(matrix_); }
  DenseMatrix(const DenseMatrix&) = delete;
  DenseMatrix& operator=(const DenseMatrix&) = delete;

  [[nodiscard]] arb_ptr at(std::size_t row, std::size_t column) {
    return arb_mat_entry(matrix_, static_cast<slong>(row), static_cast<slong>(column));
  }
  [[nodiscard]] arb_mat_struct* get() { return matrix_; }

 private:
  arb_mat_t matrix_;
};

}  // namespace

std::optional<std::vector<std::vector<Ball>>> twist_derivatives(const LiftedPlane& plane,
                                                                std::span<const AxisCrossings> geodesics,
                                                                std::span<const std::uint32_t> about) {
  const Precision scope(plane.precision());
  struct TriangleChord {
    std::uint32_t triangle;
    std::size_t geodesic;
    const BallVector* axis;
  };
  const auto is_before = [](const TriangleChord& x, const TriangleChord& y) { return x.triangle < y.triangle; };
  std::vector<TriangleChord> chords;
  for (std::size_t j = 0; j < geodesics.size(); ++j) {
    for (std::size_t i = 0; i < geodesics[j].darts.size(); ++i) {
      chords.push_back({geodesics[j].darts[i] / 3, j, &geodesics[j].axes[i]});
    }
  }
  std::stable_sort(chords.begin(), chords.end(), is_before);
  std::vector<std::vector<Ball>> result(about.size(), std::vector<Ball>(geodesics.size()));
  for (std::size_t k = 0; k < about.size(); ++k) {
    std::vector<Tri> cross(geodesics.size(), Tri::no);
    ensure(about[k] < geodesics.size(), "there is no geodesic to twist along");
    const auto& [darts, axes] = geodesics[about[k]];
    for (std::size_t i = 0; i < darts.size(); ++i) {
      const auto [first, last] =
          std::equal_range(chords.begin(), chords.end(), TriangleChord{darts[i] / 3, 0, nullptr}, is_before);
      plane.spend(8, static_cast<std::uint64_t>(last - first));
      for (auto chord = first; chord != last; ++chord) {
        Tri& known = cross[chord->geodesic];
        // Two of one geodesic do not cross; and those of two that cross do so at one point, wherever it is met.
        if (chord->geodesic == about[k] || known == Tri::yes) continue;
        const Tri here =
            certainly_less(abs(lorentz_product(axes[i], *chord->axis, plane.precision())), Ball::exactly(1));
        known = either(known, here);
        if (here != Tri::yes) continue;
        const auto change = change_of_length(axes[i], *chord->axis, plane.precision());
        if (!change) return std::nullopt;
        result[k][chord->geodesic] = *change;
      }
    }
    if (std::find(cross.begin(), cross.end(), Tri::unknown) != cross.end()) return std::nullopt;
  }
  return result;
}

std::optional<std::vector<Ball>> weights_of_basis(const LiftedPlane& plane,
                                                  const std::vector<std::vector<Ball>>& derivatives,
                                                  const std::vector<std::uint32_t>& basis,
                                                  const std::vector<std::uint32_t>& weights) {
  const Precision scope(plane.precision());
  const std::size_t size = basis.size();
  plane.spend(size * size + weights.size(), size);
  DenseMatrix matrix(size, size);
  DenseMatrix sums(size, 1);
  DenseMatrix solution(size, 1);
  for (std::size_t k = 0; k < size; ++k) {
    Ball sum;
    std::size_t in_basis = 0;
    for (std::size_t j = 0; j < derivatives[k].size(); ++j) {
      if (in_basis < size && basis[in_basis] == j) {
        arb_set(matrix.at(k, in_basis), derivatives[k][j].get());
        ++in_basis;
      } else {
        sum = sum - looked_up(weights, j - in_basis, "there is no weight") * derivatives[k][j];
      }
    }
    arb_set(sums.at(k, 0), sum.get());
  }
  if (arb_mat_solve(solution.get(), matrix.get(), sums.get(), plane.precision()) == 0) return std::nullopt;
  std::vector<Ball> result;
  for (std::size_t k = 0; k < size; ++k) result.emplace_back(solution.at(k, 0));
  return result;
}

}  // namespace epsnet::certify
