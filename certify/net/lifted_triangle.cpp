#include "certify/net/lifted_triangle.h"

#include <algorithm>
#include <cmath>

#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify {
namespace {

/// x² + y²: the parts of a complex ball are an array of two.
void norm(arb_ptr result, acb_srcptr z, slong precision) {
  arb_srcptr parts = acb_realref(z);
  arb_dot(result, nullptr, 0, parts, 1, parts, 1, 2, precision);
}

/// Im(x̄ y) = x.re y.im − x.im y.re.
void cross(arb_ptr result, arb_ptr scratch, acb_srcptr x, acb_srcptr y, slong precision) {
  arb_mul(result, acb_realref(x), acb_imagref(y), precision);
  arb_mul(scratch, acb_imagref(x), acb_realref(y), precision);
  arb_sub(result, result, scratch, precision);
}

/// The point of a vertex in its chart, exactly.
void read(ComplexBall& z, const NetDocument::Vertex& vertex) {
  arb_set_d(z.re(), vertex.x);
  arb_set_d(z.im(), vertex.y);
}

}  // namespace

void LiftedTriangle::move(ComplexBall& z, const BallIsometry& label, Way way, slong precision) {
  // With a and b of the label's inverse, ā and −b, where it is the way back. The image is n e/|e|² with n = a z + b and
  // e, the conjugate of b̄ z + ā, = b z̄ + a.
  acb_ptr n = product_.get();
  acb_ptr e = other_product_.get();
  acb_conj(e, z.get());
  acb_mul(e, e, label.b.get(), precision);
  if (way == Way::forth) {
    acb_mul(n, z.get(), label.a.get(), precision);
    acb_add(n, n, label.b.get(), precision);
    acb_add(e, e, label.a.get(), precision);
  } else {
    acb_conj(to_far_.get(), label.a.get());
    acb_mul(n, z.get(), to_far_.get(), precision);
    acb_sub(n, n, label.b.get(), precision);
    acb_sub(e, to_far_.get(), e, precision);
  }
  norm(stretch_.get(), e, precision);
  acb_mul(z.get(), n, e, precision);
  acb_div_arb(z.get(), z.get(), stretch_.get(), precision);
}

void LiftedTriangle::load(const NetDocument& document, const LabelTable& labels, std::uint32_t t, slong precision) {
  const NetDocument::Triangle& triangle = triangle_at(document, t);
  triangle_ = t;
  for (std::size_t i = 0; i < 3; ++i) {
    ComplexBall& z = corner_[i];
    read(z, document.vertices[triangle.vertex[i]]);
    norm(gap_[i].get(), z.get(), precision);
    arb_sub_ui(gap_[i].get(), gap_[i].get(), 1, precision);
    arb_neg(gap_[i].get(), gap_[i].get());
    const std::uint32_t number = i == 0 ? 0 : triangle.label[i - 1];
    if (number == 0) continue;
    move(z, labels[number], Way::forth, precision);
    arb_div(gap_[i].get(), gap_[i].get(), stretch_.get(), precision);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    acb_sub(side_[i].get(), corner_[i == 2 ? 0 : i + 1].get(), corner_[i].get(), precision);
    norm(squared_difference_[i].get(), side_[i].get(), precision);
  }
}

const Ball& LiftedTriangle::measure_orientation(slong precision) {
  ensure_loaded();
  arb_ptr result = orientation_.get();
  arb_ptr term = t_[0].get();
  arb_ptr scratch = t_[1].get();
  // Rows (x, y, (1+|z|²)/2); subtract row 0 from the others: |z_i|² − |z_0|² = A_0 − A_i =: f_i. With the sides
  // s = z_1 − z_0 and u = z_0 − z_2 the determinant is half of
  //   (2 − A_0) (−s×u) + x_0 (s.y f_2 + u.y f_1) − y_0 (s.x f_2 + u.x f_1).
  acb_srcptr s = side_[0].get();
  acb_srcptr u = side_[2].get();
  arb_ptr f1 = t_[2].get();
  arb_ptr f2 = t_[3].get();
  arb_sub(f1, gap_[0].get(), gap_[1].get(), precision);
  arb_sub(f2, gap_[0].get(), gap_[2].get(), precision);
  cross(result, scratch, u, s, precision);
  arb_sub_ui(term, gap_[0].get(), 2, precision);
  arb_neg(term, term);
  arb_mul(result, result, term, precision);
  arb_mul(term, acb_imagref(s), f2, precision);
  arb_addmul(term, acb_imagref(u), f1, precision);
  arb_addmul(result, term, corner_[0].re(), precision);
  arb_mul(term, acb_realref(s), f2, precision);
  arb_addmul(term, acb_realref(u), f1, precision);
  arb_submul(result, term, corner_[0].im(), precision);
  return orientation_;
}

const LiftedTriangle::Circumradius& LiftedTriangle::measure_circumradius(arb_srcptr sinh_squared, slong precision) {
  ensure_loaded();
  arb_ptr x = t_[0].get();
  arb_ptr y = t_[1].get();
  arb_ptr z = t_[2].get();
  // Each side's squared difference times the gap of the opposite corner.
  arb_mul(x, squared_difference_[0].get(), gap_[2].get(), precision);
  arb_mul(y, squared_difference_[1].get(), gap_[0].get(), precision);
  arb_mul(z, squared_difference_[2].get(), gap_[1].get(), precision);
  // 2(xy + yz + zx) − x² − y² − z² = 4xy − (x + y − z)².
  arb_ptr denominator = circumradius_.denominator.get();
  arb_mul(denominator, x, y, precision);
  arb_mul_2exp_si(denominator, denominator, 2);
  arb_add(x, x, y, precision);
  arb_sub(x, x, z, precision);
  arb_sqr(x, x, precision);
  arb_sub(denominator, denominator, x, precision);
  arb_ptr numerator = circumradius_.numerator.get();
  arb_mul(numerator, squared_difference_[0].get(), squared_difference_[1].get(), precision);
  arb_mul(numerator, numerator, squared_difference_[2].get(), precision);
  arb_mul_2exp_si(numerator, numerator, 2);
  arb_mul(circumradius_.slack.get(), sinh_squared, denominator, precision);
  arb_sub(circumradius_.slack.get(), circumradius_.slack.get(), numerator, precision);
  return circumradius_;
}

const LiftedTriangle::Edge& LiftedTriangle::measure_edge(arb_srcptr half_sinh_squared, std::uint32_t edge,
                                                         slong precision) {
  ensure_loaded(edge);
  arb_mul(edge_.gap_product.get(), gap_[edge].get(), gap_[edge == 2 ? 0 : edge + 1].get(), precision);
  arb_mul(edge_.lack.get(), edge_.gap_product.get(), half_sinh_squared, precision);
  arb_sub(edge_.lack.get(), edge_.lack.get(), squared_difference_[edge].get(), precision);
  return edge_;
}

const Ball& LiftedTriangle::measure_cross_ratio(const NetDocument& document, const LabelTable& labels,
                                                std::uint32_t edge, slong precision) {
  ensure_loaded(edge);
  const std::uint32_t dart = 3 * *triangle_ + edge;
  const std::uint32_t other = opposite(document, dart);
  const std::uint32_t far = previous_dart(other);
  read(far_, document.vertices[start(document, far)]);
  // From the neighbour's chart to that of t, through the corner that the dart leaves: L_{t,i} L_{t',j+1}⁻¹ L_{t',far}.
  const std::uint32_t here = corner_label(document, dart);
  const std::uint32_t there = corner_label(document, next_dart(other));
  const std::uint32_t last = corner_label(document, far);
  const auto lift = [&](std::uint32_t number, Way way) {
    if (number != 0) move(far_, labels[number], way, precision);
  };
  if (here == there) {
    lift(last, Way::forth);
  } else {
    if (there != last) {
      lift(last, Way::forth);
      lift(there, Way::back);
    }
    lift(here, Way::forth);
  }
  const std::uint32_t before = edge == 0 ? 2 : edge - 1;
  acb_sub(to_far_.get(), corner_[edge == 2 ? 0 : edge + 1].get(), far_.get(), precision);
  acb_sub(across_.get(), corner_[before].get(), far_.get(), precision);
  // side_[edge] = z2 − z0; the side before it in the triangle is z0 − z3, so the sign of the denominator is turned.
  acb_mul(product_.get(), across_.get(), side_[edge].get(), precision);
  acb_mul(other_product_.get(), side_[before].get(), to_far_.get(), precision);
  // Im(N/D) has the sign of Im(conj(D) N); here D is minus other_product_.
  cross(cross_ratio_.get(), t_[0].get(), product_.get(), other_product_.get(), precision);
  return cross_ratio_;
}

Interval quotient(const Ball& numerator, const Ball& denominator) {
  return quotient(fast_interval(numerator), fast_interval(denominator));
}

Interval quotient(Interval n, Interval d) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(d.upper > 0)) return {0, kInfinity};
  // NaN where an end is, or two infinite ones are divided: nothing is known.
  const double lower = std::max(below(n.lower / d.upper), 0.0);
  const double upper = d.lower > 0 ? above(std::max(n.upper, 0.0) / d.lower) : kInfinity;
  return {std::isnan(lower) ? 0 : lower, std::isnan(upper) ? kInfinity : upper};
}

Interval length_interval(Interval squared_sinh, slong factor) {
  const Precision scope(128);
  const auto end = [&](double value) {
    return outer_interval(factor * asinh(sqrt(Ball::exactly(std::max(value, 0.0)))));
  };
  return {end(squared_sinh.lower).lower, end(squared_sinh.upper).upper};
}

namespace {

/// The corners of triangles over the ring of one kind of crossings.
template <class CrossingsOfAKind>
class ExactCorners {
 public:
  using Number = typename CrossingsOfAKind::Number;

  ExactCorners(const NetDocument& document, const LabelEvaluator& evaluator, const CrossingsOfAKind& crossings)
      : document_(document), evaluator_(evaluator), crossings_(crossings) {}

  /// The corner where the dart starts, in the chart of its triangle.
  [[nodiscard]] MovedPoint<Number> corner(std::uint32_t dart) const { return lift(label(dart), dart); }

  /// The corner opposite to the edge of the dart in the neighbour, in the chart of the dart's triangle.
  [[nodiscard]] MovedPoint<Number> far_corner(std::uint32_t dart) const {
    const std::uint32_t other = opposite(document_, dart);
    const std::uint32_t far = previous_dart(other);
    const std::uint32_t there = next_dart(other);
    if (corner_label(document_, dart) == corner_label(document_, there)) return corner(far);
    return lift(compose(label(dart), compose(inverse(label(there)), label(far))), far);
  }

 private:
  [[nodiscard]] Isometry<Number> label(std::uint32_t dart) const {
    return evaluator_.evaluate_exactly(crossings_, corner_label(document_, dart));
  }

  [[nodiscard]] MovedPoint<Number> lift(const Isometry<Number>& isometry, std::uint32_t dart) const {
    const NetDocument::Vertex& vertex = document_.vertices[start(document_, dart)];
    const ExactPoint point = exact_point(vertex.x, vertex.y);
    // Products of up to six numbers of each of the corners are compared.
    evaluator_.budget().spend(CrossingsOfAKind::exact_work(8 * bits(point)));
    return moved(isometry, point);
  }

  const NetDocument& document_;
  const LabelEvaluator& evaluator_;
  const CrossingsOfAKind& crossings_;
};

/// sign(corners) over the ring of the crossings; nullopt if the labels of these triangles have too many bits together.
template <class Sign>
std::optional<int> exact_sign(const NetDocument& document, const LabelEvaluator& evaluator,
                              std::initializer_list<std::uint32_t> triangles, const Sign& sign) {
  std::size_t bits = 0;
  for (const std::uint32_t t : triangles) {
    for (const std::uint32_t number : document.triangles[t].label) bits += evaluator.exact_bits(number);
  }
  return std::visit(
      [&](const auto& crossings) -> std::optional<int> {
        if (bits > crossings.kMaxExactBits) return std::nullopt;
        return sign(ExactCorners(document, evaluator, crossings));
      },
      evaluator.crossings());
}

}  // namespace

std::optional<int> exact_orientation(const NetDocument& document, const LabelEvaluator& evaluator, std::uint32_t t) {
  return exact_sign(document, evaluator, {t}, [&](const auto& corners) {
    return orientation(corners.corner(3 * t), corners.corner(3 * t + 1), corners.corner(3 * t + 2));
  });
}

std::optional<int> exact_cross_ratio_sign(const NetDocument& document, const LabelEvaluator& evaluator,
                                          std::uint32_t dart) {
  return exact_sign(document, evaluator, {dart / 3, opposite(document, dart) / 3}, [&](const auto& corners) {
    return cross_ratio_sign(std::array{corners.corner(dart), corners.far_corner(dart), corners.corner(next_dart(dart)),
                                       corners.corner(previous_dart(dart))});
  });
}

}  // namespace epsnet::certify
