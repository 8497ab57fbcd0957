#include "netgen/distances/cell_base.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "certify/net/numbering.h"

namespace epsnet {
namespace {

using certify::next_dart;
using certify::previous_dart;

CellBase::Number cosh_distance(const CellBase::Point& p, const CellBase::Point& q) { return -lorentz_product(p, q); }

CellBase::Point midpoint(const CellBase::Point& p, const CellBase::Point& q) {
  const CellBase::Number half = sqrt(CellBase::Number((1 + cosh_distance(p, q)) / 2));
  return CellBase::Number(1 / (2 * half)) * (p + q);
}

}  // namespace

CellBase::CellBase(VertexTriangulation map, const Point& vertex, EdgeElements& elements)
    : elements_(elements), map_(std::move(map)), start_(map_.opposite.size()), points_{vertex}, side_(start_.size()) {
  for (std::uint32_t d = 0; d < start_.size(); ++d) measure(d);
}

CellBase::Point CellBase::end(std::uint32_t dart) const {
  return image(elements_.isometry(map_.element[dart]), points_[start_[next_dart(dart)]]);
}

void CellBase::measure(std::uint32_t dart) {
  const Number side = (cosh_distance(points_[start_[dart]], end(dart)) - 1) / 2;
  side_[dart] = side_[map_.opposite[dart]] = static_cast<double>(side);
}

PlacedTriangle CellBase::triangle(std::uint32_t t) const {
  const std::uint32_t d = 3 * t;
  const Isometry<Number> back = elements_.isometry(EdgeElements::inverse(map_.element[d + 2]));
  PlacedTriangle result{{points_[start_[d]], end(d), image(back, points_[start_[d + 2]])}, {}};
  for (std::size_t i = 0; i < 3; ++i) result.cosh[i] = cosh_distance(result.corner[i], result.corner[(i + 1) % 3]);
  return result;
}

bool CellBase::locally_delaunay(std::uint32_t dart) const {
  // The cosine of the angle opposite to a dart in the Euclidean triangle with the sides sinh(d/2), at most: the two
  // angles are at most π together. What rounding does not tell stays as it is.
  const auto cosine = [&](std::uint32_t d) {
    constexpr double kRounding = 1e-13;
    const double a = side_[next_dart(d)];
    const double b = side_[previous_dart(d)];
    const double c = side_[d];
    return (a + b - c + kRounding * (a + b + c)) / (2 * std::sqrt(a * b));
  };
  return cosine(dart) + cosine(map_.opposite[dart]) >= 0;
}

void CellBase::flip(std::uint32_t dart) {
  const std::uint32_t d = dart;
  const std::uint32_t e = map_.opposite[d];
  const std::uint32_t a = start_[d];
  const std::uint32_t b = start_[e];
  const std::uint32_t c = start_[previous_dart(d)];
  const std::uint32_t x = start_[previous_dart(e)];
  map_.flip(elements_, d);
  // The triangles xca and cxb.
  start_[d] = x;
  start_[next_dart(d)] = c;
  start_[previous_dart(d)] = a;
  start_[e] = c;
  start_[next_dart(e)] = x;
  start_[previous_dart(e)] = b;
  for (const std::uint32_t k : {d, next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)}) measure(k);
  steps_.push_back(2 * d);
}

void CellBase::split(std::uint32_t dart) {
  const std::uint32_t d = dart;
  const std::uint32_t e = map_.opposite[d];
  const auto n = static_cast<std::uint32_t>(start_.size());
  points_.push_back(midpoint(points_[start_[d]], end(d)));
  map_.split(elements_, d);
  // The triangles amc, bmx, mbc, max.
  const auto m = static_cast<std::uint32_t>(points_.size() - 1);
  start_.insert(start_.end(), {m, start_[e], start_[previous_dart(d)], m, start_[d], start_[previous_dart(e)]});
  start_[next_dart(d)] = start_[next_dart(e)] = m;
  side_.resize(start_.size());
  for (const std::uint32_t k : {d, next_dart(d), previous_dart(d), e, next_dart(e), previous_dart(e), n + 1, n + 4})
    measure(k);
  steps_.push_back(2 * d + 1);
}

void CellBase::make_delaunay(std::vector<std::uint32_t> darts) {
  constexpr int kMostFlips = 1000;
  for (int flips = 0; !darts.empty() && flips < kMostFlips;) {
    const std::uint32_t d = darts.back();
    darts.pop_back();
    const std::uint32_t e = map_.opposite[d];
    if (d / 3 == e / 3 || locally_delaunay(d)) continue;
    flip(d);
    ++flips;
    darts.insert(darts.end(), {next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)});
  }
}

void CellBase::refine(std::size_t most_triangles) {
  const double longest = 2 * std::asinh(std::sqrt(*std::max_element(side_.begin(), side_.end())));
  const double most = std::pow(std::sinh(std::max(2.0, longest / 8) / 2), 2);
  constexpr std::size_t kMostTriangles = 10'000;
  while (triangle_count() + 2 <= std::min(most_triangles, kMostTriangles)) {
    const auto top = std::max_element(side_.begin(), side_.end());
    if (*top <= most) return;
    auto d = static_cast<std::uint32_t>(top - side_.begin());
    std::uint32_t e = map_.opposite[d];
    if (d / 3 == e / 3) return;
    // The midpoint is stored next to the start of the dart: near the net's vertex, where few bits are lost.
    if (cosh_distance(points_[0], points_[start_[e]]) < cosh_distance(points_[0], points_[start_[d]])) std::swap(d, e);
    split(d);
    make_delaunay({next_dart(d), previous_dart(d), next_dart(e), previous_dart(e), triangle_count() * 3 - 5,
                   triangle_count() * 3 - 2});
  }
}

}  // namespace epsnet
