#include "triangulation/mesh/editor.h"

namespace epsnet {

void Editor::require_room(std::size_t count, std::size_t triangles) {
  if (count + triangles > kMostTriangles) {
    throw LimitError("2^30 triangles or more");
  }
}

void Editor::set(TriangleId t, Corner c0, Corner c1, Corner c2) const {
  record(t);
  std::uint64_t labels = 0;
  if ((c0.label | c1.label | c2.label) != kIdentity) {
    const LabelId back = triangulation_.inverse(c0.label);
    const LabelId l1 = triangulation_.product(back, c1.label);
    const LabelId l2 = triangulation_.product(back, c2.label);
    if (l1 > kLargestLabel || l2 > kLargestLabel) {
      throw LimitError("more than 2^24 labels");
    }
    labels = Triangle::packed(l1, l2);
  }
  Triangle& triangle = triangles()[t];
  triangle.vertex = {c0.vertex, c1.vertex, c2.vertex};
  triangle.labels_and_mark = labels;
}

Journal open_journal(const Triangulation& triangulation) {
  return {triangulation.vertex_count(), triangulation.triangle_count(), {}};
}

void undo(Triangulation& triangulation, const Journal& journal) {
  const Editor editor(triangulation);
  for (auto it = journal.overwritten.rbegin(); it != journal.overwritten.rend(); ++it) {
    editor.triangles()[it->first] = it->second;
  }
  editor.triangles().resize(journal.triangles);
  editor.points().resize(journal.vertices);
  editor.charts().resize(journal.vertices);
}

}  // namespace epsnet
