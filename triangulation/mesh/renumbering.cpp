#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Numbers in the order of the first request.
class Order {
 public:
  explicit Order(std::size_t size) : number_(size, kNone) { order_.reserve(size); }
  void meet(std::uint32_t i) {
    if (number_[i] != kNone) return;
    number_[i] = static_cast<std::uint32_t>(order_.size());
    order_.push_back(i);
  }
  [[nodiscard]] std::uint32_t number(std::uint32_t i) const { return number_[i]; }
  /// What has been met, in order.
  [[nodiscard]] const std::vector<std::uint32_t>& met() const { return order_; }

  /// The values by their new numbers.
  template <class T>
  [[nodiscard]] std::vector<T> applied(const std::vector<T>& values) const {
    std::vector<T> result;
    result.reserve(values.capacity());
    for (const std::uint32_t i : order_) result.push_back(values[i]);
    return result;
  }

 private:
  std::vector<std::uint32_t> number_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

void renumber_by_neighbours(Triangulation& triangulation) {
  Order vertices(triangulation.vertex_count());
  Order triangles(triangulation.triangle_count());
  vertices.meet(0);
  std::uint32_t first = 0;
  while (std::ranges::count(triangulation.triangle(first).vertex, 0U) == 0) ++first;
  triangles.meet(first);
  // The surface is connected: all are met.
  for (std::size_t i = 0; i < triangles.met().size(); ++i) {
    const Triangle& triangle = triangulation.triangle(triangles.met()[i]);
    for (const std::uint32_t v : triangle.vertex) vertices.meet(v);
    for (const Dart d : triangle.opposite) triangles.meet(triangle_of(d));
  }
  const Editor editor(triangulation);
  editor.points() = vertices.applied(editor.points());
  editor.charts() = vertices.applied(editor.charts());
  editor.triangles() = triangles.applied(editor.triangles());
  for (Triangle& triangle : editor.triangles()) {
    for (std::uint32_t& v : triangle.vertex) v = vertices.number(v);
    for (Dart& d : triangle.opposite) d = make_dart(triangles.number(triangle_of(d)), corner_of(d));
  }
}

}  // namespace epsnet
