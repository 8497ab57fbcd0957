#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "certify/numbers/ball_vector.h"
#include "certify/numbers/isometry.h"

/// How far an isometry moves a point (docs/proof.md, section 15).
namespace epsnet::certify {

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

/// Elements of the group of a surface, each kept once wherever balls tell that it comes again, as the same product or
/// another one. Then a long chain of products is no less precise than the shortest way to each of its elements.
class Elements {
 public:
  /// 2k is element k, 2k + 1 its inverse.
  using Id = std::uint32_t;

  /// A point of the surface, and at most sinh²(d/2) of its shortest loop: who moves it less is the identity.
  Elements(BallVector point, Ball shortest_loop, slong precision);

  [[nodiscard]] Id add(BallIsometry g);
  [[nodiscard]] const Element& element(Id id) const;
  [[nodiscard]] BallIsometry isometry(Id id) const;

 private:
  BallVector point_;
  Ball shortest_loop_;
  slong precision_;
  std::vector<Element> elements_;
  std::multimap<double, std::uint32_t> by_number_;  ///< By a number that equal ones have nearly in common.
};

}  // namespace epsnet::certify
