#include "netgen/nets/net_document.h"

#include <string>
#include <utility>
#include <vector>

#include "netgen/base/gmp.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/mesh/editor.h"

namespace epsnet {
namespace {

/// Numbers the used members of a large set in the order of their first use.
class Renumbering {
 public:
  explicit Renumbering(std::size_t size) : number_(size, kUnused) {}
  [[nodiscard]] std::uint32_t operator()(std::uint32_t i) {
    if (number_[i] == kUnused) {
      number_[i] = static_cast<std::uint32_t>(used_.size());
      used_.push_back(i);
    }
    return number_[i];
  }
  [[nodiscard]] const std::vector<std::uint32_t>& used() const { return used_; }

 private:
  static constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number_;
  std::vector<std::uint32_t> used_;
};

}  // namespace

certify::NetDocument net_document(const Triangulation& triangulation, const Length& epsilon) {
  const Atlas& atlas = triangulation.atlas();
  certify::NetDocument net;
  net.surface = to_document(triangulation.surface());
  net.epsilon = epsilon.text();
  Renumbering chart_number(atlas.charts().count());
  Renumbering label_number(atlas.labels().count());
  (void)label_number(kIdentity);
  net.vertices.reserve(triangulation.vertex_count());
  for (const VertexId v : triangulation.vertices()) {
    const Vertex& vertex = triangulation.vertex(v);
    net.vertices.push_back({vertex.z.x, vertex.z.y, chart_number(vertex.chart.number())});
  }
  net.triangles.reserve(triangulation.triangle_count());
  for (const TriangleId t : triangulation.triangles()) {
    const Triangle& triangle = triangulation.triangle(t);
    const auto& [a, b, c] = triangle.vertex;
    net.triangles.push_back({{a.number(), b.number(), c.number()},
                             {document_dart(triangle.opposite[0]), document_dart(triangle.opposite[1]),
                              document_dart(triangle.opposite[2])},
                             {label_number(triangle.label(1)), label_number(triangle.label(2))}});
  }
  for (const std::uint32_t c : chart_number.used()) {
    const Chart& chart = atlas.charts()[ChartId(c)];
    net.charts.push_back({chart.tile.number(), to_gmp(chart.centre)});
  }
  for (const LabelId l : label_number.used()) {
    if (l != kIdentity) {
      const LabelTable::Entry& label = atlas.labels()[l];
      net.labels.push_back(
          {chart_number(label.from.number()), chart_number(label.to.number()), letters_of(label.word)});
    }
  }
  return net;
}

namespace {

[[noreturn]] void refuse_net(const std::string& what) { throw TriangulationError(what); }

void add_charts(const certify::NetDocument& net, Atlas& atlas) {
  for (const certify::NetDocument::Chart& chart : net.charts) {
    const std::string name = "chart " + std::to_string(atlas.charts().count());
    if (chart.tile >= atlas.surface().tiles().size()) {
      refuse_net(name + " is in tile " + std::to_string(chart.tile) + ", the surface has " +
                 std::to_string(atlas.surface().tiles().size()));
    }
    const Complex<Rational> centre = from_gmp(chart.centre);
    if (norm(centre) >= 1) refuse_net(name + " has its centre outside of the unit disk");
    (void)atlas.add_chart({TileId(chart.tile), centre});
  }
}

/// Throws TriangulationError unless the word leads from the tile of chart `from` to that of chart `to`.
void check_label(const certify::NetDocument::Label& label, const std::string& name, const Atlas& atlas) {
  for (const std::uint32_t chart : {label.from, label.to}) {
    if (chart >= atlas.charts().count()) {
      refuse_net(name + " names chart " + std::to_string(chart) + ", there are " +
                 std::to_string(atlas.charts().count()));
    }
  }
  const Surface& surface = atlas.surface();
  TileId tile = atlas.charts()[ChartId(label.from)].tile;
  for (const SideId side : word_of_letters(label.word)) {
    if (side.number() >= surface.side_count() || surface.tile_of_side(side) != tile) {
      refuse_net(name + " crosses side " + to_string(side) + ", which tile " + to_string(tile) + " does not have");
    }
    tile = surface.tile_of_side(surface.partner(side));
  }
  if (tile != atlas.charts()[ChartId(label.to)].tile) {
    refuse_net(name + " ends in tile " + to_string(tile) + ", its chart is in tile " +
               to_string(atlas.charts()[ChartId(label.to)].tile));
  }
}

/// Returns the labels of an atlas that are the labels of a document, by their numbers in the document.
std::vector<LabelId> add_labels(const certify::NetDocument& net, Atlas& atlas) {
  std::vector<LabelId> labels{kIdentity};
  for (const certify::NetDocument::Label& label : net.labels) {
    check_label(label, "label " + std::to_string(labels.size()), atlas);
    labels.push_back(atlas.label(ChartId(label.from), ChartId(label.to), word_of_letters(label.word)));
  }
  return labels;
}

/// A triangle of a document of `count` triangles.
Triangle triangle_of(const certify::NetDocument::Triangle& triangle, std::size_t count,
                     const std::vector<LabelId>& labels, const std::string& name) {
  for (const std::uint32_t dart : triangle.opposite) {
    if (dart / 3 >= count) {
      refuse_net(name + " is glued to dart " + std::to_string(dart) + ", there are " + std::to_string(3 * count));
    }
  }
  for (const std::uint32_t label : triangle.label) {
    if (label >= labels.size()) {
      refuse_net(name + " has label " + std::to_string(label) + ", there are " + std::to_string(labels.size()));
    }
    if (labels[label] > kLargestLabel) throw LimitError("more than 2^24 labels");
  }
  const auto& [first, second, third] = triangle.opposite;
  const auto& [a, b, c] = triangle.vertex;
  return {{VertexId(a), VertexId(b), VertexId(c)},
          {triangulation_dart(first), triangulation_dart(second), triangulation_dart(third)},
          Triangle::packed(labels[triangle.label[0]], labels[triangle.label[1]])};
}

}  // namespace

Triangulation triangulation_of(const certify::NetDocument& net) {
  Atlas atlas(from_document(net.surface));
  add_charts(net, atlas);
  const std::vector<LabelId> labels = add_labels(net, atlas);
  std::vector<Vertex> vertices;
  vertices.reserve(net.vertices.size());
  for (const certify::NetDocument::Vertex& vertex : net.vertices) {
    vertices.push_back({{vertex.x, vertex.y}, ChartId(vertex.chart)});
  }
  std::vector<Triangle> triangles;
  triangles.reserve(net.triangles.size());
  for (const certify::NetDocument::Triangle& triangle : net.triangles) {
    triangles.push_back(
        triangle_of(triangle, net.triangles.size(), labels, "triangle " + std::to_string(triangles.size())));
  }
  return assembled(std::move(atlas), vertices, triangles);
}

}  // namespace epsnet
