#include "certify/net/filter.h"

#include <algorithm>
#include <cmath>

#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify {
namespace filter {
namespace {

// Differences of coordinates are rounded once, so they are as accurate as numbers can be, however close the points.
Points minus(const Points& p, const Points& q) { return {p.x - q.x, p.y - q.y}; }
inline Lanes norm(const Points& z) { return max(abs(z.x), abs(z.y)); }
Lanes cross(const Points& p, const Points& q) { return p.x * q.y - p.y * q.x; }
Points times(const Points& p, const Points& q) { return {p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x}; }

/// Below, products might underflow (proof.md, Lemma 26).
constexpr double kLeastNorm = 0x1p-100;
constexpr double kLeastGap = 0x1p-12;
/// What quotients of measures are widened by.
constexpr double kWider = 1 + 0x1p-30;
constexpr double kNarrower = 1 - 0x1p-30;
/// Below, points that labels moved are not known well enough (proof.md, Lemmas 30.1 and 30.2).
constexpr double kLeastMovedNorm = 0x1p-14;
constexpr double kLeastMovedGap = 0x1p-8;
/// What measures of points that were moved are widened by, in their place.
constexpr double kMovedError = 0x1p-19;

bool known_apart(const Point& p, const Point& q) {
  return std::abs(p.x - q.x) > kLeastMovedNorm || std::abs(p.y - q.y) > kLeastMovedNorm;
}

}  // namespace

// Bounds are larger than those for rounding alone, for points that labels moved.

Mask counterclockwise(const Points& z0, const Points& z1, const Points& z2) {
  const Points s = minus(z1, z0);
  const Points v = minus(z2, z0);
  // det(x, y, 1 + |z|²), the first row subtracted from the others: |z1|² − |z0|² = s·(z0 + z1).
  const Lanes f = s.x * (z0.x + z1.x) + s.y * (z0.y + z1.y);
  const Lanes g = v.x * (z0.x + z2.x) + v.y * (z0.y + z2.y);
  const Lanes middle = (1 + (z0.x * z0.x + z0.y * z0.y)) * cross(s, v);
  const Lanes determinant = (middle + z0.x * (s.y * g - v.y * f)) - z0.y * (s.x * g - v.x * f);
  return norm(s) > kLeastNorm && norm(v) > kLeastNorm && determinant > 0x1p-23 * (norm(s) * norm(v));
}

Mask delaunay(const Points& z0, const Points& z1, const Points& z2, const Points& z3) {
  const Points a = minus(z3, z1);
  const Points b = minus(z2, z0);
  const Points c = minus(z3, z0);
  const Points d = minus(z2, z1);
  return norm(a) > kLeastNorm && norm(b) > kLeastNorm && norm(c) > kLeastNorm && norm(d) > kLeastNorm &&
         cross(times(c, d), times(a, b)) < -0x1p-16 * ((norm(a) * norm(b)) * (norm(c) * norm(d)));
}

Squared squared_distance(const Points& p, const Points& q) {
  const Points s = minus(p, q);
  return {s.x * s.x + s.y * s.y, norm(s) > kLeastNorm};
}

Lanes gap(const Points& z) {
  const Lanes a = 1 - (z.x * z.x + z.y * z.y);
  return select(a > kLeastGap, a, 0);
}

Intervals squared_half_sinh(const Lanes& d, const Lanes& a, const Lanes& b) {
  const Lanes quotient = d / (a * b);
  return {quotient * kNarrower, quotient * kWider};
}

Intervals squared_sinh_of_circumradius(const std::array<Lanes, 3>& d, const std::array<Lanes, 3>& a) {
  const Lanes x = d[0] * a[2];
  const Lanes y = d[1] * a[0];
  const Lanes z = d[2] * a[1];
  const Lanes w = x + y - z;
  const Lanes k = 4 * (x * y) - w * w;
  const Lanes greatest = max(max(x, y), z);
  const Lanes error = 0x1p-29 * (greatest * greatest);
  const Lanes numerator = 4 * ((d[0] * d[1]) * d[2]);
  // Balls are better for a flat triangle.
  const Mask certain = k > 0x1p-4 * (greatest * greatest);
  return {select(certain, numerator / (k + error) * kNarrower, 0),
          select(certain, numerator / (k - error) * kWider, std::numeric_limits<double>::infinity())};
}

Label label_of(const BallIsometry& f) {
  double size = 0;
  double error = 0;
  const auto part = [&](arb_srcptr x) {
    const double middle = arf_get_d(arb_midref(x), ARF_RND_NEAR);
    size += std::abs(middle);
    error = std::max(error, above(mag_get_d(arb_radref(x))));
    return middle;
  };
  Label result{.a = {part(f.a.re()), part(f.a.im())}, .b = {part(f.b.re()), part(f.b.im())}};
  if (error <= 0x1p-64 * size && size < 0x1p100) result.least_stretch = std::max(0x1p-10 * (size * size), 0x1p-4);
  return result;
}

Label inverse(const Label& f) {
  return {.a = {f.a.x, -f.a.y}, .b = {-f.b.x, -f.b.y}, .least_stretch = f.least_stretch};
}

std::optional<Point> image(const Label& f, const Point& z) {
  // n/d = n e/|e|² with n = a z + b and e, the conjugate of d = b̄ z + ā, = b z̄ + a.
  const Point n{(f.a.x * z.x - f.a.y * z.y) + f.b.x, (f.a.x * z.y + f.a.y * z.x) + f.b.y};
  const Point e{(f.b.x * z.x + f.b.y * z.y) + f.a.x, (f.b.y * z.x - f.b.x * z.y) + f.a.y};
  const double stretch = e.x * e.x + e.y * e.y;
  const Point w{(n.x * e.x - n.y * e.y) / stretch, (n.x * e.y + n.y * e.x) / stretch, true};
  if (!(stretch > f.least_stretch && 1 - (w.x * w.x + w.y * w.y) > kLeastMovedGap)) return std::nullopt;
  return w;
}

namespace {

/// Coordinates of `kPoints` points of each of up to `kCount` triangles or edges, to be read in lanes.
template <std::size_t kPoints, std::size_t kCount>
class Columns {
 public:
  void add(const std::array<Point, kPoints>& z) {
    for (std::size_t i = 0; i < kPoints; ++i) {
      x_[i][size_] = z[i].x;
      y_[i][size_] = z[i].y;
    }
    ++size_;
  }
  /// Repeats the last row until lanes are full.
  void fill() {
    for (std::size_t row = size_; row > 0 && row % Lanes::size() != 0; ++row) {
      for (std::size_t i = 0; i < kPoints; ++i) {
        x_[i][row] = x_[i][size_ - 1];
        y_[i][row] = y_[i][size_ - 1];
      }
    }
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Point i of the rows from `row` on.
  [[nodiscard]] Points points(std::size_t i, std::size_t row) const { return {Lanes(&x_[i][row]), Lanes(&y_[i][row])}; }

 private:
  static_assert(kCount % Lanes::size() == 0);
  using Column = std::array<double, kCount>;
  std::array<Column, kPoints> x_;
  std::array<Column, kPoints> y_;
  std::size_t size_ = 0;
};

Interval interval(const Intervals& x, std::size_t lane, bool moved) {
  const double lower = x.lower[lane];
  const double upper = x.upper[lane];
  return moved ? Interval{lower * (1 - kMovedError), upper * (1 + kMovedError)} : Interval{lower, upper};
}

/// What a row of columns is about.
struct Row {
  std::size_t place;  ///< Of the triangle, among those asked about.
  std::uint32_t edge;
  bool moved;
  bool has_length;
};

}  // namespace
}  // namespace filter

Filter::Filter(const NetDocument& document, const CollarMembers& collars, std::span<const std::uint32_t> numbers,
               const LabelTable& labels, Interval sinh_squared, Interval half_sinh_squared)
    : document_(document),
      collars_(collars),
      labels_(document.labels.size() + 1),
      sinh_squared_(sinh_squared.lower),
      half_sinh_squared_(half_sinh_squared.upper),
      is_proved_(rounds_to_nearest()) {
  for (const std::uint32_t number : numbers) labels_[number] = filter::label_of(labels[number]);
}

std::optional<std::array<filter::Point, 3>> Filter::corners(std::uint32_t t) const {
  const NetDocument::Triangle& triangle = document_.triangles[t];
  std::array<filter::Point, 3> z{};
  for (std::size_t i = 0; i < 3; ++i) {
    const NetDocument::Vertex& vertex = document_.vertices[triangle.vertex[i]];
    z[i] = {vertex.x, vertex.y};
  }
  if (triangle.label[0] == 0 && triangle.label[1] == 0) return z;
  for (std::size_t i = 1; i < 3; ++i) {
    if (triangle.label[i - 1] == 0) continue;
    const auto image = filter::image(labels_[triangle.label[i - 1]], z[i]);
    if (!image) return std::nullopt;
    z[i] = *image;
  }
  if (!(filter::known_apart(z[0], z[1]) && filter::known_apart(z[1], z[2]) && filter::known_apart(z[2], z[0]))) {
    return std::nullopt;
  }
  return z;
}

std::optional<filter::Point> Filter::far_corner(const NetDocument::Triangle& triangle, std::uint32_t edge) const {
  const std::uint32_t other = triangle.opposite[edge];
  const NetDocument::Triangle& neighbour = triangle_at(document_, other / 3);
  const std::uint32_t far = previous_dart(other) % 3;
  const NetDocument::Vertex& vertex = document_.vertices[neighbour.vertex[far]];
  std::optional<filter::Point> z = filter::Point{vertex.x, vertex.y};
  const auto label_at = [](const NetDocument::Triangle& one, std::uint32_t corner) {
    return corner == 0 ? 0 : one.label[corner - 1];
  };
  // L_{t,i} L_{t',j+1}⁻¹ L_{t',far}, where equal labels cancel.
  const std::uint32_t here = label_at(triangle, edge);
  const std::uint32_t there = label_at(neighbour, next_dart(other) % 3);
  const std::uint32_t last = label_at(neighbour, far);
  const auto move = [&](std::uint32_t number, bool back) {
    if (number != 0 && z) z = filter::image(back ? inverse(labels_[number]) : labels_[number], *z);
  };
  if (there != last || there == here) move(last, false);
  if (there != last && there != here) move(there, true);
  if (there != here) move(here, false);
  return z;
}

void Filter::answer(std::span<const std::uint32_t> triangles, std::span<const Questions> asked,
                    std::span<Answer> answers) const {
  using namespace filter;
  std::fill(answers.begin(), answers.end(), Answer());
  if (!is_proved_) return;
  Columns<3, kMost> corner_columns;
  Columns<4, 3 * kMost> edge_columns;
  std::array<Row, kMost> triangle_rows;
  std::array<Row, 3 * kMost> edge_rows;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const std::uint32_t t = triangles[k];
    if (asked[k] == 0 || collars_.has_triangle(t)) continue;
    const auto z = corners(t);
    if (!z) continue;
    const bool moved = (*z)[1].moved || (*z)[2].moved;
    triangle_rows[corner_columns.size()] = {k, 0, moved, false};
    corner_columns.add(*z);
    const NetDocument::Triangle& triangle = document_.triangles[t];
    for (std::uint32_t i = 0; i < 3; ++i) {
      if ((asked[k] & (delaunay_bit(i) | length_bit(i))) == 0) continue;
      const std::uint32_t from = triangle.vertex[i];
      const std::uint32_t to = triangle.vertex[(i + 1) % 3];
      const Point& z0 = (*z)[i];
      const Point& z2 = (*z)[(i + 1) % 3];
      const Point& z3 = (*z)[(i + 2) % 3];
      std::optional<Point> z1 = far_corner(triangle, i);
      if (z1 && (moved || z1->moved) &&
          !(known_apart(z3, *z1) && known_apart(z2, z0) && known_apart(z3, z0) && known_apart(z2, *z1))) {
        z1.reset();
      }
      edge_rows[edge_columns.size()] = {k, i, moved, from != to && !collars_.are_partners(from, to)};
      // Of two points that are the same nothing is said.
      edge_columns.add({z0, z1 ? *z1 : z3, z2, z3});
    }
  }
  const auto settle = [&](std::size_t k, Questions question) {
    answers[k].settled = static_cast<Questions>(answers[k].settled | (asked[k] & question));
  };
  corner_columns.fill();
  for (std::size_t row = 0; row < corner_columns.size(); row += Lanes::size()) {
    const std::array z{corner_columns.points(0, row), corner_columns.points(1, row), corner_columns.points(2, row)};
    const std::array a{gap(z[0]), gap(z[1]), gap(z[2])};
    const std::array s{squared_distance(z[0], z[1]), squared_distance(z[1], z[2]), squared_distance(z[2], z[0])};
    const Mask oriented = counterclockwise(z[0], z[1], z[2]);
    const Mask accurate = a[0] > 0 && a[1] > 0 && a[2] > 0 && s[0].accurate && s[1].accurate && s[2].accurate;
    const Intervals radius = squared_sinh_of_circumradius({s[0].value, s[1].value, s[2].value}, a);
    const std::size_t end = std::min(Lanes::size(), corner_columns.size() - row);
    for (std::size_t lane = 0; lane < end; ++lane) {
      const auto& [k, edge, moved, has_length] = triangle_rows[row + lane];
      if (oriented[lane]) settle(k, kOrientationBit);
      if (!accurate[lane]) continue;
      answers[k].circumradius = interval(radius, lane, moved);
      if (answers[k].circumradius.upper < sinh_squared_) settle(k, kCoveringBit);
    }
  }
  edge_columns.fill();
  for (std::size_t row = 0; row < edge_columns.size(); row += Lanes::size()) {
    const Points z0 = edge_columns.points(0, row);
    const Points z2 = edge_columns.points(2, row);
    const Lanes a = gap(z0);
    const Lanes b = gap(z2);
    const auto [d, is_accurate] = squared_distance(z0, z2);
    const Mask accurate = a > 0 && b > 0 && is_accurate;
    const Intervals length = squared_half_sinh(d, a, b);
    const Mask delaunay_edges = delaunay(z0, edge_columns.points(1, row), z2, edge_columns.points(3, row));
    const std::size_t end = std::min(Lanes::size(), edge_columns.size() - row);
    for (std::size_t lane = 0; lane < end; ++lane) {
      const auto& [k, edge, moved, has_length] = edge_rows[row + lane];
      if (delaunay_edges[lane]) settle(k, delaunay_bit(edge));
      if (!has_length || !accurate[lane]) continue;
      answers[k].length[edge] = interval(length, lane, moved);
      if (answers[k].length[edge].lower > half_sinh_squared_) settle(k, length_bit(edge));
    }
  }
}

}  // namespace epsnet::certify
