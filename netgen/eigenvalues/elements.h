#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "certify/net/document.h"
#include "certify/numbers/inertia.h"
#include "kernel/numbers.h"
#include "netgen/lifts/lifts.h"
#include "triangulation/surface/surface.h"

#ifndef EIGEN_NO_CPUID  // Sums as long as the processor's caches would make files differ between machines.
#error "compile with EIGEN_NO_CPUID: link the target epsnet_eigen"
#endif

/// Finite elements on the flat triangles with the corners of a net's triangles, which are halved: the matrices of
/// docs/proof.md, section 17.1, rounded, and their eigenvalues.
namespace epsnet {

/// The energy and the mass of functions as forms of their values: the lower halves of symmetric matrices, or, with
/// phases, of Hermitian ones.
struct ElementMatrices {
  Eigen::SparseMatrix<double> energy;
  Eigen::SparseMatrix<double> mass;
  Eigen::SparseMatrix<double> imaginary_energy = {};  ///< The imaginary parts; empty if all are 0.
  Eigen::SparseMatrix<double> imaginary_mass = {};

  [[nodiscard]] bool is_real() const { return imaginary_energy.size() == 0; }
};

/// A flat triangle by the squares of its sides, the one opposite to corner i at i.
struct FlatTriangle {
  explicit FlatTriangle(const std::array<double, 3>& of_sides);

  /// m of Lemma 32.
  [[nodiscard]] double mean_of_inverse(double c) const;

  std::array<double, 3> squares;
  double area;
  double radius;                    ///< R
  double cosh;                      ///< C
  double mean_power;                ///< ω̄
  double trace;                     ///< X
  double greater;                   ///< Λ
  std::array<double, 3> cotangent;  ///< By corner.
};

/// By label, 0 the identity: the phase of its word, from those of the sides (netgen/surfaces/group.h).
[[nodiscard]] std::vector<double> turns_of_labels(const certify::NetDocument& net,
                                                  const ById<SideId, Rational>& phases);

/// σ for which the eigenvalues that a matrix counts are those less than τ, with this constant H; infinity if there is
/// none.
[[nodiscard]] double sigma_for(double tau, double interpolation);

/// The halved triangles, numbered as in docs/format.md.
class Elements {
 public:
  /// With phases `turns` are those of turns_of_labels. The
  /// value of a function in a corner, seen from the triangle, is that in the chart of the vertex, times the phase of
  /// the label; the value in the midpoint of a side is that seen from the triangle of the smaller dart. Nothing: no
  /// phases. O(triangles · 4^halvings).
  Elements(const NetGeometry& geometry, std::uint32_t halvings, const std::vector<double>& turns = {});

  [[nodiscard]] std::uint32_t sides() const { return side_count_; }
  [[nodiscard]] std::uint32_t vertices() const { return vertex_count_; }

  /// For values in the midpoints of the sides, functions that need not be continuous: K and N, of which the eigenvalues
  /// μ are such that μ/(1 + Hμ) is at most the eigenvalue of the surface.
  [[nodiscard]] ElementMatrices lower() const;
  /// For values in the corners, continuous functions: the eigenvalues are at least those of the surface.
  [[nodiscard]] ElementMatrices upper() const;
  /// H; not a number if a triangle is so large that its flat triangle has no circumscribed circle.
  [[nodiscard]] double interpolation() const;
  /// All of them, by number.
  [[nodiscard]] std::vector<FlatTriangle> triangles() const { return {squares_.begin(), squares_.end()}; }

 private:
  using Numbers = std::vector<std::array<std::uint32_t, 3>>;
  using Turns = std::vector<std::array<double, 3>>;

  template <class Local>
  [[nodiscard]] ElementMatrices assembled(const Numbers& numbers, const Turns& turns, std::uint32_t size,
                                          const Local& local) const;

  std::vector<std::array<double, 3>> squares_;  ///< By triangle: of the flat sides, the one opposite to corner i at i.
  Numbers opposite_sides_;                      ///< By triangle and corner.
  Numbers corners_;                             ///< By triangle: the vertices.
  Turns turns_of_sides_;                        ///< Of the phases of the values, likewise; empty without phases.
  Turns turns_of_corners_;
  std::uint32_t side_count_ = 0;
  std::uint32_t vertex_count_ = 0;
};

// Eigenvalues of large sparse matrices, rounded.

/// An order of elimination with little fill, for a matrix of which the lower half is given: nested dissection.
[[nodiscard]] std::vector<std::uint32_t> elimination_order(const Eigen::SparseMatrix<double>& lower_half);

/// The inertia of energy − σ mass, by this order of elimination: a bound for how many eigenvalues of energy·x = μ
/// mass·x, 0 included, are less than σ, and whether `certify` can prove it by this order. If a number is wanted, more
/// is done to prove that it is at most, or at least, so many.
[[nodiscard]] certify::Inertia inertia(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order,
                                       double sigma, certify::Bound bound, unsigned threads,
                                       std::optional<std::uint64_t> wanted = std::nullopt);

/// Eigenvalues in increasing order, and the vectors as columns, if the matrices are real.
struct DiscreteSpectrum {
  std::vector<double> values;
  Eigen::MatrixXd vectors;
};

/// The first `count` of them, 0 included, or all if there are fewer, by Lanczos's method with a shift below 0, with
/// this order of elimination. Throws NetError if it does not converge.
[[nodiscard]] DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices,
                                                 const std::vector<std::uint32_t>& order, std::uint32_t count);

// Characters near one of a surface, and how far eigenvalues with phases may be from those at it (docs/proof.md, Lemma
// 37.10), rounded.

/// The directions of the torus of all characters, those of character_sides (netgen/surfaces/group.h), each with a
/// function h of least energy that is linear on the flat triangles of a net.
class CharacterDirections {
 public:
  /// Of the net of the geometry, which is of the surface. Solves 2g systems of linear equations with a row for each
  /// vertex.
  CharacterDirections(const Surface& surface, const NetGeometry& geometry);

  /// All directions.
  [[nodiscard]] certify::EigenvaluesDocument::Box box(const Rational& radius) const;
  /// In it the roots of eigenvalues are at most that far from those in its centre: a little more than what is proved.
  [[nodiscard]] double distance(const Rational& radius) const;

 private:
  std::vector<certify::EigenvaluesDocument::Direction> directions_;
  double slope_ = 0;  ///< Of the sums of all ±h, the greatest.
};

/// Makes intervals so wide that they hold in the whole box.
void widen(certify::EigenvaluesDocument& document, const CharacterDirections& directions, const Rational& radius);

}  // namespace epsnet
