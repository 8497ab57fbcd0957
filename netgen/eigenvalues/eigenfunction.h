#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "certify/numbers/isometry.h"
#include "netgen/base/options.h"

/// Eigenvalues to many digits, by the method of particular solutions. docs/eigenvalues.md says how.
namespace epsnet {

/// Finds functions around the vertices of a net that nearly fit together to an eigenfunction.
class EigenfunctionSearch {
 public:
  /// `document`, which must outlive the search, has a net and its spectrum, as `spectrum` returns them. 0 threads: as
  /// many as the machine has cores.
  EigenfunctionSearch(const certify::EigenvaluesDocument& document, unsigned threads, Progress progress = {});

  /// About where the eigenvalues around λ are, the nearest ones, the nearest first. An eigenvalue of some multiplicity
  /// may occur as often. Some tenths of a second for 10 vertices; the time is proportional to their number.
  [[nodiscard]] std::vector<double> around(double lambda) const;

  /// The eigenvalue nearest to a guess, with an interval in which its function proves one; nothing if there is none, or
  /// if the net has more than 150 vertices. Deterministic. About a second for 10 vertices; proportional to their
  /// number.
  [[nodiscard]] std::optional<certify::EigenvaluesDocument::Eigenfunction> near(double lambda) const;

 private:
  using Vector = std::vector<double>;
  using Point = std::complex<double>;
  class Differences;
  /// Coefficients whose differences are small relative to them.
  struct Candidate {
    Vector coefficients;
    double differences;  ///< Their norm; that of the coefficients is 1.
    double lambda;       ///< Where they would be least, by their derivatives.
  };

  void add_circles();
  /// What each coefficient adds to the value at a point of the disk of its vertex.
  void set_values(double lambda, Point z, double* row) const;
  /// So many with the least differences, the least first, at most 10. The search begins at coefficients `c`.
  [[nodiscard]] std::vector<Candidate> best(double lambda, Vector c, std::size_t count) const;
  [[nodiscard]] Vector any_coefficients() const;
  [[nodiscard]] std::size_t size() const { return each_ * document_.net.vertices.size(); }

  const certify::EigenvaluesDocument& document_;
  unsigned threads_;
  Progress progress_;
  double epsilon_;
  double radius_;
  double scale_;  ///< Coefficients m are scaled with this number to the power m.
  std::uint32_t order_;
  std::size_t each_;  ///< Coefficients of each vertex.
  std::vector<certify::BallIsometry> labels_;
  std::uint32_t genus_ = 0;
  std::vector<Point> points_;             ///< Of circles in the disk around a vertex.
  std::vector<std::uint32_t> nearest_;    ///< By vertex and point: the other vertex that is nearest,
  std::vector<Point> points_of_nearest_;  ///< and the point in its disk.
};

}  // namespace epsnet
