#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/isometry.h"

/// What follows from the numbers of a file: how far eigenvalues in its box of characters may be from those in the
/// centre (docs/proof.md, section 17.3), and which enclosures its counts and functions prove (section 17.1).
namespace epsnet::certify {

/// What is wrong with a box of a net, on a surface of so many sides: nullopt if the radius is a decimal > 0, there are
/// at most 2g directions, as the triangles and vertices of the net say, and each direction has a step of absolute value
/// at most 10⁶ for each side and a finite height for each vertex.
[[nodiscard]] Problem box_problem(const EigenvaluesDocument::Box& box, const NetDocument& net, std::size_t sides);

/// The first direction whose steps are no homomorphism of the group: those of two sides that are glued, or of the sides
/// that are crossed around a vertex, do not add up to 0. Exact, O(directions · sides).
[[nodiscard]] Problem homomorphism_problem(const EigenvaluesDocument::Box& box, const SurfaceSides& sides);

/// ρ of Lemma 37.10: the roots of eigenvalues are at most that far from those in the centre. Nothing if the corners of
/// a triangle are too near to a line. `labels` are the values of the net's labels, number k ≥ 1 at k − 1; balls round
/// to the precision of the caller. O(directions · (triangles + letters of the labels)), taken off the budget. Requires:
/// a box without problems; the rule `map` is verified.
[[nodiscard]] std::optional<Ball> root_distance(const EigenvaluesDocument& document,
                                                const std::vector<BallIsometry>& labels, const Budget& budget);

/// A number y ≥ 0 for which √y is at most √x − distance; 0 if there is no other. x for distance 0.
[[nodiscard]] double least_beside(double x, double distance);
/// A number y for which √y is at least √x + distance; x for distance 0.
[[nodiscard]] double greatest_beside(double x, double distance);

/// What the counts and functions of a document say of the numbers of eigenvalues, if they are true (docs/proof.md,
/// section 17.1). Comparisons of binary64 and sums of integers alone, but for distances other than 0: exact.
class CountedEigenvalues {
 public:
  /// Roots of eigenvalues are at most `distance` from those that are counted. O(n log n) for n rows. The document must
  /// outlive it. Requires: the distance is 0 if there are eigenfunctions.
  explicit CountedEigenvalues(const EigenvaluesDocument& document, double distance = 0);

  /// At least so many eigenvalues are ≤ x. O(log n).
  [[nodiscard]] std::int64_t least_up_to(double x) const;
  /// At most so many are < x; the greatest number if nothing is said. O(log n).
  [[nodiscard]] std::int64_t most_below(double x) const;

  /// The first claim of the document that does not follow; nullopt if all do.
  [[nodiscard]] Problem problem() const;

 private:
  /// Of the rows of `at_least` up to one of them, or of those of `at_most` from one of them on.
  struct Extremes {
    double below;
    std::int64_t count;    ///< The greatest (least) count,
    std::int64_t without;  ///< and that of a count less the functions before `below`.
  };

  /// How many functions have intervals that begin before x; that end at x or before; that end before x.
  [[nodiscard]] std::int64_t beginning_before(double x) const;
  [[nodiscard]] std::int64_t ending_up_to(double x) const;
  [[nodiscard]] std::int64_t ending_before(double x) const;

  const EigenvaluesDocument& document_;
  std::vector<std::int64_t> functions_;  ///< By number of rows: the functions of the first so many.
  std::vector<Extremes> at_least_;       ///< By `below`, ascending.
  std::vector<Extremes> at_most_;
};

}  // namespace epsnet::certify
