#pragma once

/// The colours of pictures and pages, "#rrggbb". Colours that can be seen together differ clearly (a test measures it).
namespace epsnet::palette {

inline constexpr const char* kPaper = "#ffffff";
inline constexpr const char* kEdges = "#33475b";
inline constexpr const char* kVertices = "#10202f";
inline constexpr const char* kCentre = "#0a6fe0";  ///< The vertex in the centre of a picture.
inline constexpr const char* kDirichlet = "#d0402b";
inline constexpr const char* kCombinatorialDirichlet = "#e08a00";
inline constexpr const char* kCoveringDisks = "#2f9468";
inline constexpr const char* kPackingDisks = "#8a6bb0";
inline constexpr const char* kTiles = "#00909e";
inline constexpr const char* kCollarTriangles = "#e8c000";
inline constexpr const char* kEpsilonCollars = "#85510f";
inline constexpr const char* kGeodesics = "#b5197f";
inline constexpr const char* kSmallCurveCollars = "#7fae00";
inline constexpr const char* kPaths = "#5a2ee0";

}  // namespace epsnet::palette
