#pragma once

#include <array>
#include <cstdint>

#include "certify/base/binary64.h"
#include "certify/base/interval.h"
#include "certify/net/collar_members.h"
#include "certify/net/document.h"
#include "certify/net/questions.h"

namespace epsnet::certify {

/// What binary64 settles about triangles whose labels are the identity, with bounds for all errors (docs/proof.md,
/// section 16; but for scaling and underflow, by machine in certify/net/filter/). It never refutes: what it does not
/// settle is asked in balls.
class Filter {
 public:
  /// The document must outlive the filter. Intervals that contain sinh²ε and sinh²(ε/2). Where this thread does not
  /// round to nearest, nothing is settled; threads that ask it must round as this one does.
  Filter(const NetDocument& document, const CollarMembers& collars, Interval sinh_squared, Interval half_sinh_squared)
      : document_(document),
        collars_(collars),
        sinh_squared_(sinh_squared.lower),
        half_sinh_squared_(half_sinh_squared.upper),
        is_proved_(rounds_to_nearest()) {}

  struct Answer {
    Questions settled = 0;             ///< Of those asked, the ones whose rule certainly holds.
    Interval circumradius{};           ///< Contains sinh²R, if the question of covering is settled.
    std::array<Interval, 3> length{};  ///< Contains sinh²(d/2) of the edges whose question of length is settled.
  };

  /// About triangle t. O(1), nothing is allocated.
  [[nodiscard]] Answer answer(std::uint32_t t, Questions asked) const;

 private:
  const NetDocument& document_;
  const CollarMembers& collars_;
  double sinh_squared_;       ///< At most sinh²ε.
  double half_sinh_squared_;  ///< At least sinh²(ε/2).
  bool is_proved_;            ///< Whether arithmetic is what the bounds are proved for.
};

/// The tests of the filter for given corners, each coordinate at most 1 in absolute value. `true` is certain, `false`
/// says nothing.
namespace filter {

struct Point {
  double x;
  double y;
};

/// Whether the triangle is strictly counterclockwise in the hyperbolic plane.
[[nodiscard]] bool counterclockwise(Point z0, Point z1, Point z2);

/// Whether Im [(z3−z1)(z2−z0)/((z3−z0)(z2−z1))] is negative.
[[nodiscard]] bool delaunay(Point z0, Point z1, Point z2, Point z3);

/// |p − q|², and whether it is accurate to 2⁻⁴⁶ of itself.
struct Squared {
  double value;
  bool accurate;
};
[[nodiscard]] Squared squared_distance(Point p, Point q);

/// 1 − |z|², accurate to 2⁻³⁸ of itself; 0 if that is not certain.
[[nodiscard]] double gap(Point z);

/// Contains D/(AB) for D accurate to 2⁻⁴⁶, A and B to 2⁻³⁸ of themselves.
[[nodiscard]] Interval squared_half_sinh(double d, double a, double b);

/// Contains sinh²R for squared distances accurate to 2⁻⁴⁶ and gaps accurate to 2⁻³⁸ of themselves, D_i between corners
/// i and i + 1; [0, ∞] if nothing is certain.
[[nodiscard]] Interval squared_sinh_of_circumradius(const std::array<double, 3>& d, const std::array<double, 3>& a);

}  // namespace filter

}  // namespace epsnet::certify
