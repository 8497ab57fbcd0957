#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/net/document.h"

/// The files of surfaces and nets.
namespace epsnet::certify {

template <>
struct Fields<SurfaceDocument::Gluing> {
  static constexpr const char* kExpected = "[t, k, t', k'], four indices";
  static auto elements(auto& g) { return std::tie(g.tile, g.side, g.other_tile, g.other_side); }
};

template <>
struct Fields<std::array<mpq_class, 2>> {
  static constexpr const char* kExpected = "[l, u], two rationals";
  static auto elements(auto& pair) { return std::tie(pair[0], pair[1]); }
};

template <>
struct Fields<std::array<SurfaceDocument::FieldNumber, 3>> {
  static constexpr const char* kExpected = "[X, Y, T], three numbers of the field";
  static auto elements(auto& vertex) { return std::tie(vertex[0], vertex[1], vertex[2]); }
};

template <>
struct Fields<std::array<SurfaceDocument::FieldNumber, 4>> {
  static constexpr const char* kExpected = "[a, a', b, b'], four numbers of the field";
  static auto elements(auto& crossing) { return std::tie(crossing[0], crossing[1], crossing[2], crossing[3]); }
};

enum class SurfaceKind { tiles, regular, map, field };

template <>
struct Fields<SurfaceKind> {
  static constexpr std::array<std::string_view, 4> kNames{"tiles", "regular", "map", "field"};
};

/// A surface as it is in files, which say of what kind it is. `Surface` is SurfaceDocument, const or not.
template <class Surface>
struct SurfaceObject {
  Surface& surface;
  SurfaceKind kind;
};

template <class Surface>
struct Fields<SurfaceObject<Surface>> {
  static constexpr const char* kName = "surface";
  static constexpr const char* kPrefix = "surface.";
  static auto members(auto& object) {
    auto& surface = object.surface;
    const bool tiles = object.kind == SurfaceKind::tiles;
    const bool regular = object.kind == SurfaceKind::regular;
    const bool map = object.kind == SurfaceKind::map;
    const bool field = object.kind == SurfaceKind::field;
    const char* of_kind = tiles     ? " in a surface of the kind \"tiles\""
                          : regular ? " in a surface of the kind \"regular\""
                          : map     ? " in a surface of the kind \"map\""
                                    : " in a surface of the kind \"field\"";
    return std::tuple(
        member("kind", object.kind),  //
        member("p", surface.map_tile.p).only_if(map, of_kind), member("q", surface.map_tile.q).only_if(map, of_kind),
        member("polynomial", surface.field.polynomial).only_if(field, of_kind),
        member("root", surface.field.root).only_if(field, of_kind),
        member("polygons", surface.field.polygons).only_if(field, of_kind),
        member("tiles", surface.tiles).only_if(tiles, of_kind),
        member("gluing", surface.gluing).only_if(!regular, of_kind),
        member("crossings", surface.field.crossings).only_if(field, of_kind),
        member("genus", surface.regular_genus).only_if(regular, of_kind), member("about", surface.about).optional());
  }
};

/// A surface as the contents of a file of its own.
template <class Surface>
struct SurfaceFile {
  Surface& surface;
};

template <class Surface>
struct Fields<SurfaceFile<Surface>> {
  static constexpr const char* kName = "surface file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& file) {
    return std::tuple_cat(format_and_version("epsnet-surface"), std::tuple(member("surface", file.surface)));
  }
};

template <>
struct Fields<NetDocument::Chart> {
  static constexpr const char* kExpected = "[t, x, y], a tile and two rationals";
  static auto elements(auto& chart) { return std::tie(chart.tile, chart.centre.x, chart.centre.y); }
};

template <>
struct Fields<NetDocument::Label> {
  static constexpr const char* kExpected = "[from, to, word], two charts and an array of sides";
  static auto elements(auto& label) { return std::tie(label.from, label.to, label.word); }
};

template <>
struct Fields<NetDocument::Vertex> {
  static constexpr const char* kExpected = "[c, x, y], a chart and two numbers";
  static auto elements(auto& vertex) { return std::tie(vertex.chart, vertex.x, vertex.y); }
};

template <>
struct Fields<NetDocument::Triangle> {
  static constexpr const char* kExpected = "[v0, v1, v2, o0, o1, o2, l1, l2], eight indices";
  static auto elements(auto& triangle) {
    auto& [vertex, opposite, label] = triangle;
    return std::tie(vertex[0], vertex[1], vertex[2], opposite[0], opposite[1], opposite[2], label[0], label[1]);
  }
};

template <>
struct Fields<NetDocument::Collar> {
  static auto members(auto& collar) {
    return std::tuple(member("core", collar.core), member("length", collar.length), member("vertices", collar.vertices),
                      member("triangles", collar.triangles));
  }
};

template <>
struct Fields<NetDocument> {
  static constexpr ClaimKind kKind{"net", "epsnet-net", "a net",
                                   "A net file claims that its vertices are an epsilon-net of the surface, or of the\n"
                                   "thick part (a pseudo net), and that its triangles are a Delaunay triangulation.",
                                   2};
  static constexpr const char* kName = "net";
  static constexpr const char* kPrefix = "";
  static auto members(auto& net) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("surface", net.surface),
                   member("epsilon", net.epsilon).expecting("a decimal in a string, such as \"0.01\""),
                   member("charts", net.charts),      //
                   member("labels", net.labels),      //
                   member("vertices", net.vertices),  //
                   member("triangles", net.triangles).of_about(2 * net.vertices.size() + 1000),
                   member("collars", net.collars).optional()));
  }
};

}  // namespace epsnet::certify
