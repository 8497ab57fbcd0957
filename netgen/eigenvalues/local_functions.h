#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "netgen/base/options.h"
#include "netgen/eigenvalues/eigenfunctions.h"
#include "netgen/lifts/lifts.h"

/// Eigenfunctions to many digits, as functions around the vertices of a net that nearly fit together.
/// docs/eigenvalues.md says how.
namespace epsnet {

/// Vertices of a net that are near each other, and the search for functions around them. All numbers are rounded.
class LocalFunctions {
 public:
  /// For eigenvalues up to about `greatest`, to about so many significant digits. `geometry` must outlive it. O(number
  /// of vertices).
  LocalFunctions(const NetGeometry& geometry, double greatest, int digits, unsigned threads);

  /// Eigenfunctions of eigenvalues near these, which are in increasing order and near each other. By vertex and
  /// function, `values` are about their values, and those of some other eigenfunctions behind them. Rows in increasing
  /// order, each with an interval that is a little wider than what its functions seem to prove; nothing if fewer than
  /// there should be are found.
  ///
  /// Time: some seconds for 10⁴ vertices.
  [[nodiscard]] std::optional<std::vector<certify::EigenvaluesDocument::Eigenfunctions>> near(
      const std::vector<double>& lambdas, const Eigen::MatrixXd& values) const;

  [[nodiscard]] double radius() const { return radius_; }

 private:
  using Point = std::complex<double>;
  using Block = Eigen::MatrixXd;  ///< Coefficients as columns, those of each vertex together, scaled.
  class CircleMap;
  /// A lift of a vertex, as it is seen from another one: z ↦ (az + b)/(b̄z + ā) leads to the other's disk.
  struct Lift {
    std::uint32_t vertex;
    Isometry<double> isometry;
    double sinh_squared;  ///< sinh²(d/2)
  };
  /// What is sought: so many eigenvalues near λ, and functions that are about theirs.
  struct Task {
    double start;
    double lambda;
    std::size_t count;
    Block functions;
    double slope;  ///< About how fast the eigenvalues nearest to 1 grow with λ.
    struct Before {
      double lambda;
      double value;  ///< The mean of the eigenvalues nearest to 1 there,
      double error;  ///< and about how wrong it is.
    };
    std::optional<Before> before = {};
    int steps = 0;
    bool from_all = false;  ///< Whether Krylov's space begins with all functions, which takes longer.
  };
  struct Fixed;
  struct RitzValues;

  void find_lifts();
  /// Circles around the vertices.
  struct Circle {
    double radius = 0;                   ///< In the disks of the vertices: tanh of half the radius.
    std::vector<std::uint32_t> nearest;  ///< By vertex and point: the other vertex that is nearest,
    std::vector<Point> points;           ///< and the point in its disk.
  };
  [[nodiscard]] Circle circle(double radius, std::size_t points) const;
  /// With how many waves functions are sought.
  struct Resolution {
    std::uint32_t order = 0;
    std::size_t each = 0;    ///< Coefficients of each vertex.
    std::size_t points = 0;  ///< Of each circle.
    Circle inner;            ///< On which functions are compared in the search,
    Circle outer;            ///< and by which they are determined at the end.
  };
  [[nodiscard]] Resolution resolution(std::uint32_t order) const;
  [[nodiscard]] std::vector<std::vector<Lift>> neighbours() const;
  /// What each coefficient adds to the value at a point of the disk of its vertex.
  void set_values(double lambda, Point z, std::uint32_t order, double* row) const;
  /// As many functions as are given, which the search begins with, `sought` of them to be found, until S moves them by
  /// `enough` of themselves or it is clear where the eigenvalues of S are.
  [[nodiscard]] Fixed fixed(const CircleMap& map, const Block& functions, std::size_t sought, bool from_all,
                            double enough) const;
  /// One step for a task: what is sought after it, one or more. If it is done, the task with better functions.
  [[nodiscard]] std::vector<Task> improved(const Task& task, const Resolution& resolution, double enough,
                                           bool& done) const;
  [[nodiscard]] std::optional<std::vector<Task>> found_from(std::vector<Task> open, const Resolution& resolution,
                                                            double enough) const;
  [[nodiscard]] static Block with_order(const Block& functions, std::uint32_t order, std::uint32_t wider);
  /// As a row of a file.
  [[nodiscard]] certify::EigenvaluesDocument::Eigenfunctions row_of(const Task& task) const;
  /// About what Lemma 37.6 of docs/proof.md proves.
  [[nodiscard]] double error_of(const Task& task, double gram) const;
  [[nodiscard]] double disk_radius(double lambda) const;
  [[nodiscard]] std::vector<double> gram_weights(double lambda) const;
  /// What the scaled coefficients of wave m are multiplied with: about radius^−m of the circles of the search, and a
  /// power of 2, so that nothing is rounded.
  [[nodiscard]] double scale(std::size_t m) const { return scales_[m]; }
  [[nodiscard]] double integral(std::vector<double> values) const;
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(fine_.each * lifts_.size()); }

  const NetGeometry& geometry_;
  unsigned threads_;
  double epsilon_;
  double radius_;
  std::vector<std::vector<Lift>> lifts_;  ///< By vertex: all others within ε + R.
  std::vector<PartitionSums> partition_;
  std::vector<double> scales_;  ///< By m.
  Resolution coarse_;
  Resolution fine_;
};

}  // namespace epsnet
