#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "certify/base/binary64.h"
#include "certify/base/interval.h"
#include "certify/net/collar_members.h"
#include "certify/net/document.h"
#include "certify/net/lanes.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/questions.h"

namespace epsnet::certify {

/// The tests of the filter, for several triangles or edges at once. Coordinates are at most 1 in absolute value. `true`
/// is certain, `false` says nothing.
namespace filter {

struct Points {
  Lanes x;
  Lanes y;
};

struct Intervals {
  Lanes lower;
  Lanes upper;
};

/// Whether the triangle is strictly counterclockwise in the hyperbolic plane.
[[nodiscard]] Mask counterclockwise(const Points& z0, const Points& z1, const Points& z2);

/// Whether Im [(z3−z1)(z2−z0)/((z3−z0)(z2−z1))] is negative.
[[nodiscard]] Mask delaunay(const Points& z0, const Points& z1, const Points& z2, const Points& z3);

/// |p − q|², and whether it is accurate to 2⁻⁴⁶ of itself.
struct Squared {
  Lanes value;
  Mask accurate;
};
[[nodiscard]] Squared squared_distance(const Points& p, const Points& q);

/// 1 − |z|², accurate to 2⁻³⁸ of itself; 0 if that is not certain.
[[nodiscard]] Lanes gap(const Points& z);

/// Contains D/(AB) for D accurate to 2⁻⁴⁶, A and B to 2⁻³⁸ of themselves.
[[nodiscard]] Intervals squared_half_sinh(const Lanes& d, const Lanes& a, const Lanes& b);

/// Contains sinh²R for squared distances accurate to 2⁻⁴⁶ and gaps accurate to 2⁻³⁸ of themselves, D_i between corners
/// i and i + 1; [0, ∞] if nothing is certain.
[[nodiscard]] Intervals squared_sinh_of_circumradius(const std::array<Lanes, 3>& d, const std::array<Lanes, 3>& a);

/// A point, and whether labels moved it: then it is known to 2⁻⁴⁴ after one of them, to 2⁻³⁵ after three.
struct Point {
  double x;
  double y;
  bool moved = false;
};

/// A label (a, b) in binary64, up to 2⁻⁵² of |a| + |b|. Of a point z it moves nothing is certain unless |b̄z + ā|² is
/// more than `least_stretch`.
struct Label {
  Point a{};
  Point b{};
  double least_stretch = std::numeric_limits<double>::infinity();
};
[[nodiscard]] Label label_of(const BallIsometry& f);
/// Of the inverse isometry.
[[nodiscard]] Label inverse(const Label& f);
/// The image; nullopt if it is not known as well as is said above.
[[nodiscard]] std::optional<Point> image(const Label& f, const Point& z);

}  // namespace filter

/// What binary64 settles about triangles, with bounds for all errors (docs/proof.md, section 16; but for labels,
/// scaling and underflow, by machine in certify/net/filter/). It never refutes: what it does not settle is asked in
/// balls.
class Filter {
 public:
  /// The document must outlive the filter. Balls for the labels that it should know, by number, and intervals that
  /// contain sinh²ε and sinh²(ε/2). Where this thread does not round to nearest, nothing is settled; threads that ask
  /// it must round as this one does.
  Filter(const NetDocument& document, const CollarMembers& collars, std::span<const std::uint32_t> numbers,
         const LabelTable& labels, Interval sinh_squared, Interval half_sinh_squared);

  struct Answer {
    Questions settled = 0;             ///< Of those asked, the ones whose rule certainly holds.
    Interval circumradius{};           ///< Contains sinh²R, if the question of covering is settled.
    std::array<Interval, 3> length{};  ///< Contains sinh²(d/2) of the edges whose question of length is settled.
  };

  /// How many triangles may be asked about at once.
  static constexpr std::size_t kMost = 64;

  /// About each of some triangles: answers[k] to the questions asked[k] about triangles[k]. O(1) for each of them,
  /// nothing is allocated.
  void answer(std::span<const std::uint32_t> triangles, std::span<const Questions> asked,
              std::span<Answer> answers) const;

 private:
  /// The corners where the triangle lives; nullopt if they are not known well enough.
  [[nodiscard]] std::optional<std::array<filter::Point, 3>> corners(std::uint32_t t) const;
  /// The far corner of the neighbour across an edge of a triangle, likewise.
  [[nodiscard]] std::optional<filter::Point> far_corner(const NetDocument::Triangle& triangle,
                                                        std::uint32_t edge) const;

  const NetDocument& document_;
  const CollarMembers& collars_;
  std::vector<filter::Label> labels_;  ///< By number; that of the identity is not used.
  double sinh_squared_;                ///< At most sinh²ε.
  double half_sinh_squared_;           ///< At least sinh²(ε/2).
  bool is_proved_;                     ///< Whether arithmetic is what the bounds are proved for.
};

}  // namespace epsnet::certify
