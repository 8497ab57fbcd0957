#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

/// Numbers in the order of the first request.
template <class I>
class Order {
 public:
  explicit Order(std::size_t size) : number_(size) { order_.reserve(size); }
  void meet(I i) {
    if (number_[i]) return;
    number_[i] = order_.end_id();
    order_.push_back(i);
  }
  [[nodiscard]] I number(I i) const { return *number_[i]; }
  /// What has been met, in order.
  [[nodiscard]] const ById<I, I>& met() const { return order_; }

  /// The values by their new numbers.
  template <class T>
  [[nodiscard]] ById<I, T> applied(const ById<I, T>& values) const {
    ById<I, T> result;
    result.reserve(values.capacity());
    for (const I i : order_) result.push_back(values[i]);
    return result;
  }

 private:
  ById<I, std::optional<I>> number_;
  ById<I, I> order_;
};

}  // namespace

void renumber_by_neighbours(Triangulation& triangulation) {
  Order<VertexId> vertices(triangulation.vertex_count());
  Order<TriangleId> triangles(triangulation.triangle_count());
  vertices.meet(VertexId(0));
  TriangleId first(0);
  while (std::ranges::count(triangulation.triangle(first).vertex, VertexId(0)) == 0) ++first;
  triangles.meet(first);
  // The surface is connected: all are met.
  for (std::size_t i = 0; i < triangles.met().size(); ++i) {
    const Triangle& triangle = triangulation.triangle(triangles.met()[TriangleId(i)]);
    for (const VertexId v : triangle.vertex) vertices.meet(v);
    for (const Dart d : triangle.opposite) triangles.meet(triangle_of(d));
  }
  const Editor editor(triangulation);
  editor.points() = vertices.applied(editor.points());
  editor.charts() = vertices.applied(editor.charts());
  editor.triangles() = triangles.applied(editor.triangles());
  for (Triangle& triangle : editor.triangles()) {
    for (VertexId& v : triangle.vertex) v = vertices.number(v);
    for (Dart& d : triangle.opposite) d = make_dart(triangles.number(triangle_of(d)), corner_of(d));
  }
}

}  // namespace epsnet
