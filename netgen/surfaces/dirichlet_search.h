#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "kernel/plane.h"
#include "netgen/surfaces/exact_isometries.h"

namespace epsnet {

/// The generators are known to too few digits: an element may be 1, or not; 0 stands for their relation.
struct CoarseNumbers {
  MatrixProducts::Id element;
  double error;
};

/// Finds the Dirichlet domain of the base point of a group of matrices, with rounded numbers: of all sides that are
/// known, and with new ones as long as one that is moved to another one does not fit (J. Voight, Computing fundamental
/// domains for Fuchsian groups, J. Théor. Nombres Bordeaux 21, 2009). Nothing is proved here.
///
/// In the Klein model the points nearer to 0 than to f(0) are those u with u·P ≤ 1, P = a/b̄: the domain is dual to the
/// convex hull of the points P.
class DirichletSearch {
 public:
  using Id = MatrixProducts::Id;
  using Number = Mp256;

  /// Numbers that differ by less than `tolerance` count as equal. `examine` is called for every element other than 1
  /// that is found, and may throw.
  DirichletSearch(MatrixProducts& products, double tolerance, std::function<void(Id)> examine);

  /// How the search ended.
  enum class End {
    compact,     ///< The domain is compact, and its sides are paired; three lifts of it meet at every vertex.
    cusp,        ///< It has a vertex on the circle at infinity: `element()` fixes that vertex.
    free_side,   ///< It has a part of the circle at infinity as a side.
    torsion,     ///< `element()`, other than 1, fixes a vertex.
    degenerate,  ///< A vertex where more lifts than three meet, so that another base point is needed.
    limit        ///< Too many elements.
  };
  /// Throws CoarseNumbers.
  [[nodiscard]] End run();

  /// The elements whose bisectors are the sides, counterclockwise.
  [[nodiscard]] const std::vector<Id>& sides() const { return ids_; }
  /// By side: that of the inverse.
  [[nodiscard]] const std::vector<std::uint32_t>& partner() const { return partner_; }
  [[nodiscard]] Id element() const { return element_; }

  /// Returns sides f₁, f₂, … of which the product f₁f₂… is an element; nothing if it is no such product. Requires:
  /// run() has returned `compact`.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> factors(Id x) const;

 private:
  struct Side {
    Id id;                     ///< 0 for a tangent of the circle, which stands for nothing.
    Isometry<Number> element;  ///< Of determinant 1.
    Complex<Number> pole;      ///< P.
  };
  using Vector = LorentzVector<Number>;

  [[nodiscard]] bool is_identity(const Isometry<MatrixProducts::Number>& f) const;
  /// As far as its error tells. Throws CoarseNumbers.
  [[nodiscard]] bool is_identity(Id x) const;
  void add(Id x);
  void make_hull();
  void reduce_pending();
  [[nodiscard]] Vector vertex(std::size_t i) const;
  [[nodiscard]] std::optional<std::size_t> violated(const Vector& point) const;
  [[nodiscard]] std::vector<Vector> ends_of_side(std::size_t i) const;
  [[nodiscard]] std::vector<Id> misfits() const;
  [[nodiscard]] End classify();

  MatrixProducts& products_;
  Number tolerance_;
  std::function<void(Id)> examine_;
  /// Tangents of the circle, which keep the polygon bounded as long as its sides do not.
  std::vector<Side> tangents_;
  std::vector<Side> hull_;
  std::vector<Id> pending_;
  std::vector<Id> ids_;
  std::vector<std::uint32_t> partner_;
  Id element_ = 0;
  int in_vain_ = 0;  ///< How often a side was added since there was a new product.
  std::size_t products_before_ = 0;
};

}  // namespace epsnet
