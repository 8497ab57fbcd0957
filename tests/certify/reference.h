#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <deque>
#include <gmpxx.h>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "certify/net/document.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/numbers/exact.h"
#include "certify/numbers/isometry.h"

/// What tests compare the checks of nets, geodesics and bounds with: the hyperbolic plane and a net in long double.
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

/// With the determinant 1, and either sign.
inline Move rounded(const ExactIsometry& f) {
  constexpr mp_bitcnt_t kBits = 256;
  const mpf_class root = sqrt(mpf_class(norm(f.a) - norm(f.b), kBits));
  const auto part = [&](const mpz_class& x) {
    const mpf_class quotient(mpf_class(x, kBits) / root, kBits);
    const double most = quotient.get_d();
    return Real{most} + Real{mpf_class(quotient - most, kBits).get_d()};
  };
  return {{part(f.a.re), part(f.a.im)}, {part(f.b.re), part(f.b.im)}};
}

inline Vector middle(const BallVector& x) { return {middle(x[0].get()), middle(x[1].get()), middle(x[2].get())}; }

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

/// sinh² of half the distance.
inline Real squared_half_sinh(Complex z, Complex w) {
  return std::norm(z - w) / ((1 - std::norm(z)) * (1 - std::norm(w)));
}

inline Real distance(Complex z, Complex w) { return 2 * std::asinh(std::sqrt(squared_half_sinh(z, w))); }

inline Real determinant(const Vector& x, const Vector& y, const Vector& z) {
  return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
}

/// The triangles of a net again and again: no net, but every triangle and edge is what it was.
inline NetDocument copies(const NetDocument& document, std::uint32_t count) {
  NetDocument result = document;
  const auto darts = static_cast<std::uint32_t>(3 * document.triangles.size());
  for (std::uint32_t k = 1; k < count; ++k) {
    for (NetDocument::Triangle triangle : document.triangles) {
      for (std::uint32_t& dart : triangle.opposite) dart += k * darts;
      result.triangles.push_back(triangle);
    }
  }
  return result;
}

/// A triangle of a lifted triangulation: which one it is, and what leads from the chart of the first to its chart.
struct Lift {
  std::uint32_t triangle;
  Move to_chart;
};

/// A net in long double: what tests of the checkers compare them with. All is worked out from the definitions; labels
/// are rounded from exact numbers, on regular surfaces from balls.
class Reference {
 public:
  explicit Reference(const NetDocument& net)
      : net_(net),
        parts_{check_surface(net.surface, 1).crossings, chart_frames(net.charts, {}), {}},
        evaluator_(net_, parts_),
        labels_{{1, 0}} {
    for (std::uint32_t k = 1; k <= net.labels.size(); ++k) {
      if (const auto* crossings = std::get_if<RationalCrossings>(&parts_.crossings)) {
        labels_.push_back(rounded(evaluator_.evaluate_exactly(*crossings, k)));
      } else {
        labels_.push_back(middle(evaluator_.evaluate(std::array{k}, 128, 1024, 1).front()));
      }
    }
  }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  [[nodiscard]] const NetDocument& net() const { return net_; }
  [[nodiscard]] const LabelEvaluator& evaluator() const { return evaluator_; }
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
  [[nodiscard]] std::array<Complex, 3> corners(std::uint32_t triangle) const {
    return {corner(3 * triangle), corner(3 * triangle + 1), corner(3 * triangle + 2)};
  }
  /// The corner beyond the edge of a dart, in the chart of its triangle.
  [[nodiscard]] Complex far_corner(std::uint32_t dart) const {
    return image(inverted(transition(dart)), corner(previous_dart(opposite(net_, dart))));
  }
  /// To the chart of the vertex where the dart starts from that where it ends. If there is one vertex, it moves to the
  /// end of the dart.
  [[nodiscard]] Move element(std::uint32_t dart) const {
    return inverted(labels_[corner_label(net_, dart)]) * labels_[corner_label(net_, next_dart(dart))];
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
  LabelParts parts_;
  LabelEvaluator evaluator_;
  std::vector<Move> labels_;  ///< By number; 0 is the identity.
};

}  // namespace epsnet::certify
