#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <unordered_map>

#include "certify/claims/bound/element.h"
#include "certify/lifted/lorentz.h"
#include "certify/numbers/interval_arithmetic.h"

/// Displacements in intervals of binary64 (docs/proof.md, section 15). Far from the centre of the disk they would have
/// few digits; so points and elements are moved to where the points are near it.
namespace epsnet::certify {

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

}  // namespace epsnet::certify
