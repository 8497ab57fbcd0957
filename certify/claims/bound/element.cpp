#include "certify/claims/bound/element.h"

#include <cmath>
#include <utility>

#include "certify/base/lookup.h"
#include "certify/lifted/lorentz.h"

namespace epsnet::certify {
namespace {

/// A number of an isometry with Re a > 0 that few others share, and its inverse has with the other sign. NaN if balls
/// do not tell it well.
double number_of(const BallIsometry& g) {
  const Ball number = real(g.b) + Ball::exactly(0.618) * imaginary(g.b) + Ball::exactly(0.377) * imaginary(g.a);
  const Interval x = fast_interval(number);
  constexpr double kNear = 1e-12;
  return x.upper - x.lower < kNear * (1 + std::fabs(x.lower)) ? x.lower : std::nan("");
}

}  // namespace

Element element_of(BallIsometry isometry, slong precision) {
  const Precision scope(precision);
  BallVector row = traceless_row(isometry);
  Ball square = norm(isometry.b) - sqr(imaginary(isometry.a));
  return {std::move(isometry), std::move(row), std::move(square)};
}

Ball displacement(const Element& element, const BallVector& p, slong precision) {
  Ball result;
  dot(result, element.normal_row, p, precision);
  arb_sqr(result.get(), result.get(), precision);
  arb_add(result.get(), result.get(), element.square.get(), precision);
  return result;
}

Elements::Elements(BallVector point, Ball shortest_loop, slong precision)
    : point_(std::move(point)), shortest_loop_(std::move(shortest_loop)), precision_(precision) {}

Elements::Id Elements::add(BallIsometry g) {
  const Precision scope(precision_);
  choose_sign(g);
  double number = number_of(g);
  const bool inverted = number < 0;
  if (inverted) {
    g = inverse(g);
    number = -number;
  }
  const auto known = static_cast<Id>(elements_.size());
  if (!std::isnan(number)) {
    const double reach = 1e-9 * (1 + number);
    // More elements may share the number, by chance or by malice: what is not found is kept twice.
    int looks = 4;
    for (auto found = by_number_.lower_bound(number - reach);
         found != by_number_.end() && found->first < number + reach && looks > 0; ++found, --looks) {
      const BallIsometry quotient = compose(inverse(elements_[found->second].isometry), g, precision_);
      const Ball moved = displacement(element_of(quotient, precision_), point_, precision_);
      if (certainly_less(moved, shortest_loop_) == Tri::yes) return 2 * found->second + (inverted ? 1 : 0);
    }
    by_number_.emplace(number, known);
  }
  elements_.push_back(element_of(std::move(g), precision_));
  return 2 * known + (inverted ? 1 : 0);
}

const Element& Elements::element(Id id) const { return looked_up(elements_, id / 2, "there is no element"); }

BallIsometry Elements::isometry(Id id) const {
  const BallIsometry& g = element(id).isometry;
  return id % 2 == 0 ? g : inverse(g);
}

}  // namespace epsnet::certify
