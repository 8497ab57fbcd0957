#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "certify/file/reader.h"

/// The table of claims. What a message or a test needs to know of each kind of file that can be checked is a row of it.
namespace epsnet::certify {

/// One kind of claim.
struct ClaimKind {
  std::string_view name;      ///< A file of this kind is a NAME file, and has a section with this title in format.md.
  std::string_view format;    ///< The member `format` of its files.
  std::string_view contents;  ///< What is in a file: "closed geodesics".
  std::string_view says;  ///< What such a file claims, one sentence of a few lines of 80 columns for `certify --help`.
  int section;            ///< The section of docs/proof.md with its theorem or its rules.

  /// Returns "a NAME file".
  [[nodiscard]] std::string file() const { return "a " + std::string(name) + " file"; }
};

/// In the order of the alternatives of ClaimDocument.
inline constexpr std::array<ClaimKind, std::variant_size_v<ClaimDocument>> kClaimKinds{{
    {"net", "epsnet-net", "a net",
     "A net file claims that its vertices are an epsilon-net of the surface, or of the\n"
     "thick part (a pseudo net), and that its triangles are a Delaunay triangulation.",
     2},
    {"geodesics", "epsnet-geodesics", "closed geodesics",
     "A geodesics file claims to list the systole, the spectrum up to a length, or the\n"
     "thick-thin decomposition.",
     11},
    {"distance", "epsnet-distance", "a distance",
     "A distance file claims to list the shortest paths between two points.", 14},
    {"bound", "epsnet-cover", "bounds",
     "A bound file claims two bounds for the diameter, the radius, or the radius of\n"
     "the largest embedded disk.",
     15},
}};

[[nodiscard]] inline const ClaimKind& kind_of(const ClaimDocument& document) { return kClaimKinds[document.index()]; }

}  // namespace epsnet::certify
