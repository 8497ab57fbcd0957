#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/claims/bound/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/net/document.h"

/// What files consist of (docs/format.md), said once for the reader and the writer.
///
/// `Fields<T>` says how a T stands in a file: as an array of these `elements`, as an object of these `members`, in the
/// order in which they are written, or as one of these `kNames`. Elements and members are references into a T, and what
/// they are in a file follows from their type:
///
/// | type | in a file |
/// | --- | --- |
/// | std::uint32_t | an index |
/// | double | a binary64 |
/// | mpq_class | a rational |
/// | std::string | a string |
/// | bool | true or false |
/// | std::vector<std::uint32_t> | a word, of which the length is limited |
/// | std::vector<T> | an array of T; each has a line, unless it is part of another one |
/// | Format, Version, List | see below |
namespace epsnet::certify {

template <class T>
struct Fields;

/// A member that is `optional` is written unless it is empty.
enum class Presence { required, optional, forbidden };

/// A member of an object. `Value` is a reference, or List, Format, Version.
template <class Value>
struct Member {
  std::string_view name;
  Value value;
  Presence presence = Presence::required;
  const char* condition = "";         ///< Words for what decides whether a member that is not optional is there.
  const char* expected = "a string";  ///< Words for what a string says.
  std::size_t rows = 0;               ///< A guess of how many elements an array has.

  [[nodiscard]] Member optional() && {
    presence = Presence::optional;
    return *this;
  }
  [[nodiscard]] Member only_if(bool wanted, const char* words) && {
    presence = wanted ? Presence::required : Presence::forbidden;
    condition = words;
    return *this;
  }
  [[nodiscard]] Member expecting(const char* words) && {
    expected = words;
    return *this;
  }
  [[nodiscard]] Member of_about(std::size_t guess) && {
    rows = guess;
    return *this;
  }
};

template <class Value>
Member<Value> member(std::string_view name, Value&& value) {
  return {name, std::forward<Value>(value)};
}

/// Indices that are no word and have no limits of their own. As an element: all elements that follow.
template <class Indices>
struct List {
  Indices& indices;
};
template <class Indices>
List(Indices&) -> List<Indices>;

/// The member `format` of the files of one kind.
struct Format {
  std::string_view name;
};
/// The member `version` of all files.
struct Version {
  std::uint32_t number = 1;
};

template <class Document>
auto format_and_version() {
  return std::tuple(member("format", Format{Fields<Document>::kFormat}), member("version", Version()));
}

template <>
struct Fields<RationalPoint> {
  static constexpr const char* kExpected = "[x, y], two rationals";
  static auto elements(auto& point) { return std::tie(point.x, point.y); }
};

template <>
struct Fields<SurfaceDocument::Gluing> {
  static constexpr const char* kExpected = "[t, k, t', k'], four indices";
  static auto elements(auto& g) { return std::tie(g.tile, g.side, g.other_tile, g.other_side); }
};

enum class SurfaceKind { tiles, regular };

template <>
struct Fields<SurfaceKind> {
  static constexpr std::array<std::string_view, 2> kNames{"tiles", "regular"};
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
    const bool regular = object.kind == SurfaceKind::regular;
    const char* of_kind = regular ? " in a surface of the kind \"regular\"" : " in a surface of the kind \"tiles\"";
    return std::tuple(member("kind", object.kind),  //
                      member("tiles", surface.tiles).only_if(!regular, of_kind),
                      member("gluing", surface.gluing).only_if(!regular, of_kind),
                      member("genus", surface.regular_genus).only_if(regular, of_kind),
                      member("about", surface.about).optional());
  }
};

template <>
struct Fields<SurfaceDocument> {
  static constexpr const char* kFormat = "epsnet-surface";
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
    return std::tuple_cat(format_and_version<SurfaceDocument>(), std::tuple(member("surface", file.surface)));
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
struct Fields<std::array<std::uint32_t, 2>> {
  static constexpr const char* kExpected = "two indices";
  static auto elements(auto& pair) { return std::tie(pair[0], pair[1]); }
};

template <>
struct Fields<std::array<double, 2>> {
  static constexpr const char* kExpected = "[lo, hi], two numbers";
  static auto elements(auto& pair) { return std::tie(pair[0], pair[1]); }
};

template <>
struct Fields<Interval> {
  static constexpr const char* kExpected = "[lo, hi], two numbers";
  static auto elements(auto& interval) { return std::tie(interval.lower, interval.upper); }
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
  static constexpr const char* kFormat = "epsnet-net";
  static constexpr const char* kName = "net";
  static constexpr const char* kPrefix = "";
  static auto members(auto& net) {
    return std::tuple_cat(
        format_and_version<NetDocument>(),
        std::tuple(member("surface", net.surface),
                   member("epsilon", net.epsilon).expecting("a decimal in a string, such as \"0.01\""),
                   member("charts", net.charts),      //
                   member("labels", net.labels),      //
                   member("vertices", net.vertices),  //
                   member("triangles", net.triangles).of_about(2 * net.vertices.size() + 1000),
                   member("collars", net.collars).optional()));
  }
};

template <>
struct Fields<GeodesicsDocument::Claim> {
  static constexpr std::array<std::string_view, 3> kNames{"systole", "spectrum", "thick-thin"};
};

template <>
struct Fields<GeodesicsDocument::ClosedGeodesic> {
  static auto members(auto& geodesic) {
    return std::tuple(member("vertex", geodesic.vertex), member("word", geodesic.word),
                      member("length", geodesic.length), member("simple", geodesic.simple));
  }
};

template <>
struct Fields<GeodesicsDocument::Cluster> {
  static auto members(auto& cluster) {
    return std::tuple(member("first", cluster.first), member("count", cluster.count), member("equal", cluster.equal));
  }
};

template <>
struct Fields<std::pair<std::uint32_t, std::uint32_t>> {
  static constexpr const char* kExpected = "[geodesic, side], two indices";
  static auto elements(auto& boundary) { return std::tie(boundary.first, boundary.second); }
};

template <>
struct Fields<GeodesicsDocument::Piece> {
  static auto members(auto& piece) {
    return std::tuple(member("genus", piece.genus), member("boundaries", piece.boundaries));
  }
};

template <>
struct Fields<GeodesicsDocument> {
  static constexpr const char* kFormat = "epsnet-geodesics";
  static constexpr const char* kName = "geodesics file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    using Claim = GeodesicsDocument::Claim;
    const Claim claim = document.claim;
    const char* for_claim = " for this claim";
    return std::tuple_cat(format_and_version<GeodesicsDocument>(),
                          std::tuple(member("claim", document.claim), member("net", document.net),
                                     member("up_to", document.up_to)
                                         .only_if(claim == Claim::spectrum, for_claim)
                                         .expecting("a decimal in a string"),
                                     member("geodesics", document.geodesics),
                                     member("clusters", document.clusters).only_if(claim != Claim::systole, for_claim),
                                     member("pieces", document.pieces).only_if(claim == Claim::thick_thin, for_claim)));
  }
};

template <>
struct Fields<DistanceDocument::Point> {
  static constexpr const char* kExpected = "[t, x, y], a tile and two rationals";
  static auto elements(auto& point) { return std::tie(point.tile, point.z.x, point.z.y); }
};

template <>
struct Fields<DistanceDocument> {
  static constexpr const char* kFormat = "epsnet-distance";
  static constexpr const char* kName = "distance file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version<DistanceDocument>(),
        std::tuple(member("net", document.net), member("point", document.point), member("distance", document.distance),
                   member("paths", document.paths), member("equal", document.equal)));
  }
};

template <>
struct Fields<BoundDocument::Claim> {
  static constexpr std::array<std::string_view, 3> kNames{"diameter", "radius", "embedded-disk"};
};

template <>
struct Fields<BoundDocument::Triangulation> {
  static constexpr const char* kExpected = "[k, d, …], a triangulation and darts";
  static auto elements(auto& t) { return std::tuple_cat(std::tie(t.parent), std::tuple(List{t.flips})); }
};

template <>
struct Fields<BoundDocument> {
  static constexpr const char* kFormat = "epsnet-cover";
  static constexpr const char* kName = "bound file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version<BoundDocument>(),
        std::tuple(member("claim", document.claim), member("net", document.net), member("value", document.value),
                   member("triangulations", document.triangulations), member("cells", List{document.cells})));
  }
};

}  // namespace epsnet::certify
