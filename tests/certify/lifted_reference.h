#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/document/darts.h"
#include "certify/document/geodesics_document.h"
#include "certify/file/reader.h"
#include "certify/geodesics/chords.h"
#include "certify/surface_check.h"

/// What tests compare certify/geodesics with: the same net in long double, its lifted triangles without any pruning.
namespace epsnet::certify {

/// Charts lie far out, so that binary64 would not do.
using Real = long double;
using Complex = std::complex<Real>;

/// z ↦ (a z + b)/(b̄ z + ā).
using Move = std::pair<Complex, Complex>;
/// A vector of the hyperboloid model.
using Vector = std::array<Real, 3>;

inline Move operator*(const Move& f, const Move& g) {
  return {f.first * g.first + f.second * std::conj(g.second), f.first * g.second + f.second * std::conj(g.first)};
}

inline Move inverted(const Move& f) { return {std::conj(f.first), -f.second}; }

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

inline Real middle(arb_srcptr x) {
  // The nearest binary64, and what it leaves.
  const double most = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  arf_t rest;
  arf_init(rest);
  arf_set_d(rest, most);
  arf_sub(rest, arb_midref(x), rest, ARF_PREC_EXACT, ARF_RND_NEAR);
  const Real result = Real{most} + Real{arf_get_d(rest, ARF_RND_NEAR)};
  arf_clear(rest);
  return result;
}

inline Move middle(const BallIsometry& f) {
  return {{middle(f.a.re()), middle(f.a.im())}, {middle(f.b.re()), middle(f.b.im())}};
}

inline Vector middle(const BallVector& x) { return {middle(x[0]), middle(x[1]), middle(x[2])}; }

inline Vector vector_of(Complex z) {
  const Real gap = 1 - std::norm(z);
  return {2 * z.real() / gap, 2 * z.imag() / gap, (1 + std::norm(z)) / gap};
}

inline Complex point_of(const Vector& x) { return Complex(x[0], x[1]) / (1 + x[2]); }

inline Complex image(const Move& f, Complex z) {
  return (f.first * z + f.second) / (std::conj(f.second) * z + std::conj(f.first));
}

inline Vector image(const Move& f, const Vector& x) { return vector_of(image(f, point_of(x))); }

inline Real lorentz(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] - x[2] * y[2]; }

inline Real distance(Complex z, Complex w) {
  return 2 * std::asinh(std::abs(z - w) / std::sqrt((1 - std::norm(z)) * (1 - std::norm(w))));
}

inline Real determinant(const Vector& x, const Vector& y, const Vector& z) {
  return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
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

/// A triangle of a lifted triangulation: which one it is, and what leads from the chart of the first to its chart.
struct Lift {
  std::uint32_t triangle;
  Move to_chart;
};

/// The net in long double. Labels are asked of the evaluator; all else is worked out from the definitions.
class Reference {
 public:
  explicit Reference(const NetDocument& net) : net_(net) {
    const LiftedNet exact(net);
    labels_.push_back({1, 0});
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t k = 1; k <= net.labels.size(); ++k) numbers.push_back(k);
    for (const BallIsometry& value : exact.evaluator().evaluate(numbers, 128, 1024, 1))
      labels_.push_back(middle(value));
  }

  [[nodiscard]] const NetDocument& net() const { return net_; }
  [[nodiscard]] const Move& label(std::uint32_t number) const { return labels_[number]; }
  [[nodiscard]] Move value(std::span<const SignedLabel> product) const {
    Move result{1, 0};
    for (const SignedLabel& label : product) {
      result = result * (label.inverted ? inverted(labels_[label.number]) : labels_[label.number]);
    }
    return result;
  }

  /// Where the dart starts, in the chart of its triangle.
  [[nodiscard]] Complex corner(std::uint32_t dart) const {
    const NetDocument::Vertex& vertex = net_.vertices[start(net_, dart)];
    return image(labels_[corner_label(net_, dart)], Complex(vertex.x, vertex.y));
  }

  /// To the chart of the triangle across the dart.
  [[nodiscard]] Move transition(std::uint32_t dart) const {
    return labels_[corner_label(net_, next_dart(opposite(net_, dart)))] * inverted(labels_[corner_label(net_, dart)]);
  }

  /// The circumcentre C as a multiple of a unit vector, N = C/cosh R: −⟨N, U⟩ = 1 at the corners.
  [[nodiscard]] Vector circumcentre(std::uint32_t triangle) const {
    std::array<Vector, 3> rows;
    for (std::uint32_t i = 0; i < 3; ++i) {
      rows[i] = vector_of(corner(3 * triangle + i));
      rows[i] = {-rows[i][0], -rows[i][1], rows[i][2]};
    }
    const Real all = determinant(rows[0], rows[1], rows[2]);
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) {
      auto replaced = rows;
      for (Vector& row : replaced) row[k] = 1;
      result[k] = determinant(replaced[0], replaced[1], replaced[2]) / all;
    }
    return result;
  }

  [[nodiscard]] Real circumradius(std::uint32_t triangle) const {
    const Vector n = circumcentre(triangle);
    return std::acosh(1 / std::sqrt(-lorentz(n, n)));
  }

  [[nodiscard]] Real largest_circumradius() const {
    Real result = 0;
    for (std::uint32_t t = 0; t < net_.triangles.size(); ++t) result = std::max(result, circumradius(t));
    return result;
  }

  /// Every lifted triangle with a corner within `radius` of q, a point in the chart of triangle `root`: all that the
  /// segment from q to that corner leads through have a point within `radius`, so a corner within R more.
  [[nodiscard]] std::vector<Lift> lifts(std::uint32_t root, Complex q, Real radius) const {
    const Real least = std::cosh(radius);
    const Real reach = std::cosh(radius + largest_circumradius());
    std::vector<Lift> found;
    std::set<std::array<long, 3>> known;
    std::deque<Lift> open;
    const auto add = [&](const Lift& lift) {
      const Vector x = image(lift.to_chart, vector_of(q));
      const Real nearest = cosh_to_corners(lift.triangle, x);
      if (!(nearest <= reach)) return;
      if (!known.insert({lift.triangle, std::lround(x[0] * 1e5), std::lround(x[1] * 1e5)}).second) return;
      open.push_back(lift);
      if (nearest <= least) found.push_back(lift);
    };
    add({root, {1, 0}});
    for (; !open.empty(); open.pop_front()) {
      const Lift lift = open.front();
      for (std::uint32_t dart = 3 * lift.triangle; dart < 3 * lift.triangle + 3; ++dart) {
        add({opposite(net_, dart) / 3, transition(dart) * lift.to_chart});
      }
    }
    return found;
  }

 private:
  /// cosh of the distance of a point, in the chart of the triangle, from its nearest corner.
  [[nodiscard]] Real cosh_to_corners(std::uint32_t triangle, const Vector& x) const {
    const auto cosh_to = [&](std::uint32_t i) { return -lorentz(x, vector_of(corner(3 * triangle + i))); };
    return std::min({cosh_to(0), cosh_to(1), cosh_to(2)});
  }

  NetDocument net_;
  std::vector<Move> labels_;
};

/// The point q of the reverse search near the start of the dart: the sum of the corners of its triangle with these
/// weights, and the vertex.
inline constexpr Vector kWeights{967, 22, 11};

inline Complex point_near(const Reference& reference, std::uint32_t dart) {
  Vector sum{};
  for (const Real weight : kWeights) {
    const Vector x = vector_of(reference.corner(dart));
    for (std::size_t i = 0; i < 3; ++i) sum[i] += weight * x[i];
    dart = next_dart(dart);
  }
  const Real scale = std::sqrt(-lorentz(sum, sum));
  return point_of({sum[0] / scale, sum[1] / scale, sum[2] / scale});
}

/// The lifted triangles with α(q) ≤ cosh(D' + R)/cosh R, D' = D + d(q, v), R the circumradius of the first.
struct Wanted {
  std::uint64_t triangles = 0;
  std::map<Key, Move> elements;  ///< Of the lifts of the first triangle, in the chart of the vertex.
  Real gap = 1e9;                ///< How near an α comes to the bound, relatively.
};

inline Wanted wanted(const Reference& reference, std::uint32_t dart, Real distance_bound) {
  const Complex q = point_near(reference, dart);
  const Complex v = reference.corner(dart);
  const Real radius = reference.circumradius(dart / 3);
  const Real bound = std::cosh(distance_bound + distance(q, v) + radius) / std::cosh(radius);
  const Move to_root = reference.label(corner_label(reference.net(), dart));
  Wanted result;
  // cosh d(q, C) = α(q) cosh R.
  const Real largest = reference.largest_circumradius();
  for (const Lift& lift : reference.lifts(dart / 3, q, std::acosh(bound * std::cosh(largest)) + largest)) {
    const Vector n = reference.circumcentre(lift.triangle);
    const Real alpha = -lorentz(n, vector_of(image(lift.to_chart, q)));
    result.gap = std::min(result.gap, std::abs(alpha / bound - 1));
    if (alpha > bound) continue;
    ++result.triangles;
    if (lift.triangle != dart / 3) continue;
    const Move element = inverted(to_root) * inverted(lift.to_chart) * to_root;
    result.elements[key_of(element)] = element;
  }
  return result;
}

}  // namespace epsnet::certify
