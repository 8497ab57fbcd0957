#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "certify/claims/bound/document.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/labels.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/interval_arithmetic.h"
#include "certify/numbers/isometry.h"

/// Triangulations with one vertex at a point, by numbers alone: the sinh²(d/2) of their edges (docs/proof.md, section
/// 15). In balls, which round to the precision of the caller, or in intervals of binary64.
namespace epsnet::certify {

// How far an isometry moves a point (docs/proof.md, section 15).

/// An element g at one precision: sinh²(d(p, gp)/2) = square + ⟨normal, p⟩² for unit vectors p, as the normal of the
/// axis has the square sinh²(l/2).
struct Element {
  BallIsometry isometry;
  BallVector normal_row;
  Ball square;
};

/// Contains what is true of every isometry in the ball.
[[nodiscard]] Element element_of(BallIsometry isometry, slong precision);

/// sinh²(d(p, gp)/2), p a unit vector of the hyperboloid.
[[nodiscard]] Ball displacement(const Element& element, const BallVector& p, slong precision);

/// sinh²(d(p, gp)/2) of the element g that moves p least. Requires: there is one.
[[nodiscard]] Ball least_displacement(const std::vector<BallIsometry>& elements, const BallVector& p, slong precision);

/// Elements of the group of a surface, each kept once wherever balls tell that it comes again, as the same product or
/// another one. One that has lost bits is enclosed anew, where balls tell a path to it along the edges of a Delaunay
/// triangulation. Then a long chain of products is about as precise as the way straight to each of its elements.
class Elements {
 public:
  /// 2k is element k, 2k + 1 its inverse.
  using Id = std::uint32_t;

  /// A point of the surface, and at most sinh²(d/2) of its shortest loop: who moves it less is the identity. The edges
  /// at it are for paths, one dart of each, better enclosed with path_precision(precision) bits; without them there are
  /// no paths.
  Elements(BallVector point, Ball shortest_loop, const std::vector<BallIsometry>& edges, slong precision,
           Budget budget = {});

  /// Products of long edges to ends that are near lose bits, and paths are made of few such products.
  [[nodiscard]] static slong path_precision(slong precision) { return 2 * precision; }

  [[nodiscard]] Id add(BallIsometry g);
  /// Whether balls told so far of each element whether it is known.
  [[nodiscard]] bool all_told() const { return all_told_; }
  [[nodiscard]] const Element& element(Id id) const;
  [[nodiscard]] BallIsometry isometry(Id id) const;
  /// The same, enclosed anew: it has lost few of path_precision bits, unless there are no paths.
  [[nodiscard]] BallIsometry along_edges(Id id) const { return enclosed_along_edges(isometry(id)); }

 private:
  /// A step along an edge, and where it leads from the point.
  struct Step {
    BallIsometry isometry;
    BallVector end;
    std::array<double, 3> nearly;  ///< The end, rounded.
  };

  /// Whether balls tell that two elements are equal.
  [[nodiscard]] bool are_equal(const BallIsometry& f, const BallIsometry& g) const;
  /// The product of steps to an element, each to the end that is nearest to the image of the point; g itself if balls
  /// do not tell that they lead there.
  [[nodiscard]] BallIsometry enclosed_along_edges(const BallIsometry& g) const;

  BallVector point_;
  Ball shortest_loop_;
  std::vector<Step> steps_;
  slong precision_;
  Budget budget_;
  std::vector<Element> elements_;
  bool all_told_ = true;
  std::multimap<double, std::uint32_t> by_number_;  ///< By a number that equal ones have nearly in common.
};

// Displacements in intervals of binary64 (docs/proof.md, section 15). Far from the centre of the disk they would have
// few digits; so points and elements are moved to where the points are near it.

/// Coordinates with a point of the hyperboloid as the centre.
class Frame {
 public:
  using Point = std::array<Interval, 3>;

  Frame(const BallVector& origin, slong precision);

  /// The cosh of the distance of a point from the centre.
  [[nodiscard]] Interval cosh_distance(const BallVector& p) const;
  [[nodiscard]] Point point(const BallVector& p) const;
  /// sinh²(d(p, gp)/2) of element g, whose number is k in all calls.
  [[nodiscard]] Interval displacement(std::uint32_t k, const Element& element, const Point& p);
  /// Elements that were moved here so far.
  [[nodiscard]] std::size_t elements() const { return elements_.size(); }

 private:
  struct Axis {
    Point row;
    Interval square;
  };

  slong precision_;
  BallMatrix to_frame_;
  BallMatrix from_frame_;
  std::unordered_map<std::uint32_t, Axis> elements_;  ///< By number.
};

/// The frames of some cells, made where points are.
class Frames {
 public:
  explicit Frames(slong precision) : precision_(precision) {}

  /// A frame near the point, the same until the next call.
  [[nodiscard]] Frame& near(const BallVector& p);
  [[nodiscard]] std::size_t size() const { return frames_.size(); }

 private:
  slong precision_;
  std::deque<Frame> frames_;
  std::size_t last_ = 0;
};

// Triangulations as combinatorial data, and what makes one of another (docs/proof.md, section 15).

/// What is across each dart, and the element that leads from the dart's start to its end: 2k for element k and 2k + 1
/// for its inverse.
struct Map {
  std::vector<std::uint32_t> opposite;
  std::vector<std::uint32_t> element;
};

/// Two elements one after the other: what becomes of the diagonal of a flip.
struct Product {
  std::uint32_t first;
  std::uint32_t second;
};

/// Replaces the edge of dart d by the other diagonal, the element of number `diagonal`; its product is returned. The
/// triangles abc and bax, d from a to b, become xca and cxb: d is then from x to c. They are different.
Product flip(Map& map, std::uint32_t d, std::uint32_t diagonal);

/// A triangulation with more vertices than one, which is cut into cells. A dart from a to b with the element g leads
/// from the point of a to g of that of b.
struct Base {
  /// The point of a new vertex: in the middle between that of `from` and what the element makes of that of `to`.
  struct Midpoint {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t element;
  };

  Map map;
  std::vector<std::uint32_t> start;  ///< By dart: its vertex.
  std::vector<Midpoint> midpoints;   ///< Of vertex 1 and so on.
};

Product flip(Base& base, std::uint32_t d, std::uint32_t diagonal);

/// Splits the edge of dart d, `one` the number of the identity: the triangles abc and bax, d from a to b, become amc,
/// bmx and the last ones mbc, max. They are different.
void split(Base& base, std::uint32_t d, std::uint32_t one);

/// sinh²(d/2) of the three sides of a triangle.
template <class Number>
using SidesIn = std::span<const Number, 3>;
using Sides = SidesIn<Ball>;

/// Whether a triangle certainly lies in a disk of radius r, `most` its sinh²: its circumcircle is not larger, or it is
/// not acute and the disk with the longest side as diameter is not. `no` if it certainly does not.
[[nodiscard]] Tri fits(Sides sides, const Ball& most);
[[nodiscard]] Tri fits(SidesIn<Interval> sides, const Interval& most);

/// The measures of a triangle with a circumcircle.
template <class Number>
struct MeasuresIn {
  Number k;  ///< K = 4ab − (a + b − c)²: positive if there is a circumcircle.
  /// Of the angle opposite to each side in the Euclidean triangle with sides √a, √b, √c.
  std::array<Number, 3> cotangent;
  Number area;
};
using TriangleMeasures = MeasuresIn<Ball>;

/// Returns the measures of a triangle. Unless K is certainly positive, all other members are non-finite.
[[nodiscard]] TriangleMeasures measures(Sides sides);
[[nodiscard]] MeasuresIn<Interval> measures(SidesIn<Interval> sides);

/// Whether F triangles with one vertex, of these areas, that cover a closed surface once, if clockwise ones count
/// negatively, certainly are all counterclockwise: ΣA < A + π(F − 2) for each.
[[nodiscard]] Tri all_counterclockwise(std::span<const Ball> areas);
[[nodiscard]] Tri all_counterclockwise(std::span<const Interval> areas);

/// Whether the triangulation is Delaunay at the point, all edges certainly locally so (docs/proof.md, Lemma 25), and
/// its largest circumradius is at least r, `least` its sinh². What is across each dart, and sinh²(d/2) of each.
[[nodiscard]] Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Ball> h,
                                       const Ball& least);
[[nodiscard]] Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Interval> h,
                                       const Interval& least);

// A domain of the plane that has a point of every orbit of a surface's isometries (docs/proof/bounds.md, Lemma 21.3).

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
