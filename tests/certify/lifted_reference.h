#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/document.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "tests/certify/reference.h"

/// What tests compare certify/geodesics with: a net in long double, its lifted triangles without any pruning.
namespace epsnet::certify {

/// With Re a > 0.
inline Move with_sign(const Move& f) { return f.first.real() < 0 ? Move{-f.first, -f.second} : f; }

/// Four numbers as integers; elements of a group that differ, differ by much more.
using Key = std::array<long, 4>;

inline Key key_of(const Move& f) {
  const Move g = with_sign(f);
  const auto scaled = [](Real x) { return std::lround(x * 1e6); };
  return {scaled(g.first.real()), scaled(g.first.imag()), scaled(g.second.real()), scaled(g.second.imag())};
}

/// The element, known to so many bits.
inline BallIsometry blurred(BallIsometry f, int bits) {
  for (arb_ptr x : {f.a.re(), f.a.im(), f.b.re(), f.b.im()}) {
    mag_t radius;
    mag_init(radius);
    mag_set_ui_2exp_si(radius, 1, -bits);
    mag_add(arb_radref(x), arb_radref(x), radius);
    mag_clear(radius);
  }
  return f;
}

/// The element, of which each number is known to some bits, fewer or more, and is anywhere in its ball.
inline BallIsometry blurred_somehow(BallIsometry f, int bits, std::mt19937& random) {
  for (arb_ptr x : {f.a.re(), f.a.im(), f.b.re(), f.b.im()}) {
    const int here = bits - 4 + static_cast<int>(random() % 20);
    const double shift = static_cast<double>(random() % 1999) / 1000 - 0.999;
    Ball error;
    arb_set_d(error.get(), std::ldexp(shift, -here));
    arb_add(x, x, error.get(), 256);
    arb_add_error_2exp_si(x, -here);
  }
  return f;
}

/// sinh of the distance of a point from the axis of f, positive on the left of the axis directed like f: by the fixed
/// points. A cross-ratio turns the axis into the imaginary axis of the upper half-plane.
inline Real side_of_axis(const Move& f, Complex z) {
  // b̄ z² + (ā − a) z − b = 0; the attracting end is the one with |b̄ z + ā| > 1.
  const auto [a, b] = f;
  const Complex root = std::sqrt(a.real() * a.real() - 1);
  Complex to = (a - std::conj(a) + Real{2} * root) / (Real{2} * std::conj(b));
  Complex from = (a - std::conj(a) - Real{2} * root) / (Real{2} * std::conj(b));
  if (std::abs(std::conj(b) * to + std::conj(a)) < 1) std::swap(from, to);
  // w = (z − from)/(z − to), turned so that the disk is the upper half-plane: from ↦ 0, to ↦ ∞.
  const auto map = [&](Complex x) { return (x - from) / (x - to); };
  // The image of the axis is a ray; a point on it, the middle of a chord of the Klein model.
  const Real stretch = 1 - std::norm((from + to) / Real{2});
  const Complex on_axis = (from + to) / Real{2} / (1 + std::sqrt(stretch));
  const Complex w = map(z) / map(on_axis);
  // Now the axis is the positive real axis and points to ∞; the angle φ from it has tan φ = sinh d.
  return w.imag() / w.real();
}

/// A net with words as further labels, and the plane of the rules at one precision.
class LiftedNet {
 public:
  explicit LiftedNet(NetDocument net, slong precision = 128, slong cap = 1024)
      : LiftedNet(std::move(net), {}, precision, cap) {}

  /// The elements of the geodesics are labels from number `first_element` on.
  LiftedNet(NetDocument net, const std::vector<GeodesicsDocument::ClosedGeodesic>& geodesics, slong precision = 128,
            slong cap = 1024)
      : net_(std::move(net)), first_element_(static_cast<std::uint32_t>(net_.labels.size()) + 1) {
    for (const GeodesicsDocument::ClosedGeodesic& geodesic : geodesics) {
      const std::uint32_t chart = net_.vertices[geodesic.vertex].chart;
      net_.labels.push_back({chart, chart, geodesic.word});
    }
    parts_.crossings = check_surface(net_.surface, 1).crossings;
    for (const NetDocument::Chart& chart : net_.charts)
      parts_.frames.push_back(translation_to(exact_point(chart.centre)));
    evaluator_.emplace(net_, parts_);
    plane_.emplace(net_, *evaluator_, parts_, precision, cap, 1);
  }
  LiftedNet(const LiftedNet&) = delete;
  LiftedNet& operator=(const LiftedNet&) = delete;

  [[nodiscard]] const NetDocument& net() const { return net_; }
  [[nodiscard]] const LabelEvaluator& evaluator() const { return *evaluator_; }
  [[nodiscard]] const LiftedPlane& plane() const { return *plane_; }
  [[nodiscard]] std::uint32_t element_number(std::size_t geodesic) const {
    return first_element_ + static_cast<std::uint32_t>(geodesic);
  }
  /// The element that translates along a geodesic in the direction of its word.
  [[nodiscard]] BallIsometry element(std::size_t geodesic) const {
    BallIsometry result = inverse(plane_->label(element_number(geodesic)));
    choose_sign(result);
    return result;
  }

 private:
  NetDocument net_;
  std::uint32_t first_element_;
  LabelParts parts_;
  std::optional<LabelEvaluator> evaluator_;
  std::optional<LiftedPlane> plane_;
};

}  // namespace epsnet::certify
