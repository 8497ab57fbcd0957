#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "certify/numbers/isometry.h"
#include "netgen/base/progress.h"

/// Eigenvalues to many digits, by the method of particular solutions. docs/eigenvalues.md says how.
namespace epsnet {

/// Finds functions around the vertices of a net that nearly fit together to an eigenfunction.
class EigenfunctionSearch {
 public:
  /// `document`, which must outlive the search, has a net and its spectrum, as `spectrum` returns them. 0 threads: as
  /// many as the machine has cores.
  EigenfunctionSearch(const certify::EigenvaluesDocument& document, unsigned threads, Progress progress = {});

  /// An eigenvalue near a guess, with an interval in which its function proves one; nothing if there is none, or if the
  /// net has more than some 25 vertices. Deterministic. Time: the cube of the number of vertices, some seconds for 25.
  [[nodiscard]] std::optional<certify::EigenvaluesDocument::Eigenfunction> near(double lambda) const;

 private:
  using Vector = std::vector<double>;
  /// Two vertices whose functions should agree on a circle: its points in the disks of both.
  struct Pair {
    std::uint32_t first;
    std::uint32_t second;
    std::vector<std::complex<double>> in_first;
    std::vector<std::complex<double>> in_second;
  };

  void add_pairs();
  /// By point of the circle: what each coefficient of the first vertex, and of the second, adds to the difference.
  [[nodiscard]] std::vector<Vector> rows(const Pair& pair, double lambda) const;
  void add_values(double lambda, std::complex<double> z, double sign, double* row) const;
  /// The differences of coefficients on all circles.
  [[nodiscard]] Vector differences(double lambda, const Vector& c) const;
  /// The coefficients with the least differences, of norm 1.
  [[nodiscard]] std::optional<Vector> best(double lambda) const;
  /// The coefficient of an entry of a row.
  [[nodiscard]] std::size_t column(const Pair& pair, std::size_t i) const {
    return i < each_ ? pair.first * each_ + i : pair.second * each_ + (i - each_);
  }
  [[nodiscard]] std::size_t size() const { return each_ * document_.net.vertices.size(); }

  const certify::EigenvaluesDocument& document_;
  unsigned threads_;
  Progress progress_;
  double radius_;
  double scale_;  ///< Coefficients m are scaled with this number to the power m.
  std::uint32_t order_;
  std::size_t each_;  ///< Coefficients of each vertex.
  std::vector<certify::BallIsometry> labels_;
  std::uint32_t genus_ = 0;
  std::vector<Pair> pairs_;
};

}  // namespace epsnet
