#pragma once

#include <array>
#include <vector>

#include "certify/claims/bound/document.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/labels.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"

/// A domain of the plane that has a point of every orbit of a surface's isometries (docs/proof/bounds.md, Lemma 21.3).
namespace epsnet::certify {

/// The points that are not farther from a centre than from its images under some isometries, in the coordinates of the
/// chart of a net's one vertex: triangles around the centre, at any precision.
class Domain {
 public:
  /// The isometries are some (see isometries_report), and the net is valid. The parts, those of the net, must outlive
  /// the object. O(letters) memory, times those of a path; BudgetSpent, if that is too much.
  Domain(const NetDocument& net, const BoundSymmetry& symmetry, const LabelParts& parts);
  Domain(const NetDocument&, const BoundSymmetry&, const LabelParts&&) = delete;

  /// Its triangles at one precision: triangle i has the centre as corner 0, and the points that are as far from it as
  /// from its images under isometries i and i + 1, and under i + 1 and i + 2.
  struct Placed {
    Tri surrounds = Tri::yes;  ///< Whether there are such points, and they lie counterclockwise around the centre.
    std::size_t row = 0;       ///< If they certainly do not, or that is open: where not, the first such isometry.
    std::vector<std::array<BallVector, 3>> triangles;  ///< If they do.
  };
  [[nodiscard]] Placed place(slong precision, slong cap, unsigned threads) const;

 private:
  const BoundSymmetry& symmetry_;
  NetDocument words_;  ///< Charts, and as labels from the vertex' chart to itself: the pair, and its images.
  LabelEvaluator evaluator_;
};

}  // namespace epsnet::certify
