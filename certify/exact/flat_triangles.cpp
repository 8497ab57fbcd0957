#include "certify/exact/flat_triangles.h"

#include <utility>

#include "certify/exact/loops.h"

namespace epsnet::exact {
namespace {

/// Sides are numbered in the order of the smaller of their two darts.
std::vector<Index> numbers_of_sides(const std::vector<Index>& opposite) {
  std::vector<Index> side(opposite.size());
  Index sides = 0;
  for (std::size_t dart = 0; dart < opposite.size(); ++dart)
    side[dart] = opposite[dart] < dart ? side[opposite[dart]] : sides++;
  return side;
}

}  // namespace

HalvedSize halved_size(const Net& net, Index halvings) {
  HalvedSize size{net.triangles.size(), 3 * net.triangles.size() / 2, net.vertices.size()};
  for (Index i = 0; i < halvings; ++i) {
    size.vertices += size.sides;
    size.triangles *= 4;
    size.sides = 3 * size.triangles / 2;
  }
  return size;
}

HalvedNet halved(const NetStructure& net, Index halvings) {
  HalvedNet result;
  std::vector<Index> opposite;
  for (Index dart = 0; dart < net.darts(); ++dart) {
    opposite.push_back(net.opposite(dart));
    result.start.push_back(net.start(dart));
  }
  result.side = numbers_of_sides(opposite);
  auto vertices = static_cast<Index>(net.net().vertices.size());
  for (; halvings > 0; --halvings) {
    std::vector<Index> start(4 * opposite.size());
    std::vector<Index> beyond(start.size());
    for (Index dart = 0; dart < opposite.size(); ++dart) {
      const Index own = first_half(dart);
      const Index inner = 12 * (dart / 3) + 9 + previous(dart) % 3;
      start[own] = result.start[dart];
      start[own + 1] = vertices + result.side[dart];
      start[own + 2] = start[inner] = vertices + result.side[previous(dart)];
      beyond[own] = second_half(opposite[dart]);
      beyond[own + 2] = first_half(opposite[previous(dart)]);
      beyond[own + 1] = inner;
      beyond[inner] = own + 1;
    }
    vertices += static_cast<Index>(opposite.size() / 2);
    result = {.side = numbers_of_sides(beyond), .start = std::move(start), .opposite = {}};
    opposite = std::move(beyond);
  }
  result.opposite = std::move(opposite);
  return result;
}

FlatTriangle::FlatTriangle(const Corners& corners) {
  for (std::size_t k = 0; k < 3; ++k) {
    Vector side;
    for (std::size_t i = 0; i < 3; ++i) side[i] = corners[(k + 2) % 3][i] - corners[(k + 1) % 3][i];
    squares_[k] = lorentz_product(side, side);
  }
  const auto& [a, b, c] = squares_;
  const Interval sixteen_squared_areas = 4 * a * b - square(a + b - c);
  if (is_less(0, sixteen_squared_areas) != Answer::yes) give_up("a triangle may have no circumscribed circle");
  area_ = sqrt(sixteen_squared_areas) / 4;
  radius_ = sqrt(a * b * c / sixteen_squared_areas);
  cosh_ = sqrt(1 + square(radius_));
  mean_square_ = square(radius_) - (a + b + c) / 12;
  Interval sum;
  for (std::size_t k = 0; k < 3; ++k) {
    cotangents_[k] = (a + b + c - 2 * squares_[k]) / (4 * area_);
    sum = sum + square(squares_[k] * cotangents_[k] / 4);
  }
  spread_ = mean_square_ / 2 + sqrt(square(mean_square_) / 4 - (4 * sum - square(area_)) / 36);
}

Interval FlatTriangle::slope(const std::array<Interval, 3>& values) const {
  Interval sum;
  for (std::size_t k = 0; k < 3; ++k) sum = sum + cotangents_[k] * square(values[(k + 1) % 3] - values[(k + 2) % 3]);
  return cosh_ * sqrt(sum / (2 * area_));
}

Interval FlatTriangle::interpolation() const {
  const Interval constant(mpq_class(1893, 10000));
  return square(constant) * max(max(squares_[0], squares_[1]), squares_[2]) * cosh_ * (1 + radius_);
}

LocalForms FlatTriangle::lower_forms() const {
  const Interval& big = cosh_;
  const Interval small = 1 / (1 + radius_);  // c
  const Interval mean = 1 / (1 - small) - mean_square_ / (2 * big * (1 - small) * (big - small)) +
                        spread_ / ((1 - small * big) * (big - small));
  const Interval kappa = (square(big) + big + 1) / (square(big) * (big + 1));
  LocalForms forms{gradients(4 * (small + 1 / mean)), omega({.own = 7, .other = 3, .without = -1, .with = 1})};
  for (std::size_t i = 0; i < 3; ++i) {
    for (Interval& entry : forms.mass[i]) entry = -kappa * entry;
    forms.mass[i][i] = forms.mass[i][i] + big * area_ / 3;
  }
  return forms;
}

LocalForms FlatTriangle::upper_forms() const {
  const Interval mean = 1 + (squares_[0] + squares_[1] + squares_[2]) / 12;  // 1 + ω̄
  const Interval scale = cosh_ / (mean * sqrt(mean));
  LocalForms forms{gradients(1 - mean_square_ / (2 * square(cosh_)) + spread_ / cosh_),
                   omega({.own = 1, .other = 3, .without = 2, .with = 1})};
  // 1 − (3/2)(ω − ω̄)/(1 + ω̄) = 5/2 − (3/2)(1 + ω)/(1 + ω̄)
  const Interval slope = Interval(3) / 2 / mean;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Interval product = area_ * (i == j ? 2 : 1) / 12;
      forms.mass[i][j] = scale * ((Interval(5) / 2 - slope) * product - slope * forms.mass[i][j]);
    }
  }
  return forms;
}

LocalForms::Matrix FlatTriangle::omega(const Moments& moments) const {
  LocalForms::Matrix result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        const long diagonal = k == i ? moments.own : moments.other;
        const long moment = i == j ? diagonal : k == i || k == j ? moments.with : moments.without;
        result[i][j] = result[i][j] + moment * squares_[k] * area_ / 180;
      }
    }
  }
  return result;
}

LocalForms::Matrix FlatTriangle::gradients(const Interval& factor) const {
  LocalForms::Matrix result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    result[k][k] = factor / 2 * (cotangents_[i] + cotangents_[j]);
    result[i][j] = result[j][i] = -factor / 2 * cotangents_[k];
  }
  return result;
}

}  // namespace epsnet::exact
