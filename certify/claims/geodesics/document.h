#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/document.h"

/// The contents of a geodesics file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved. `check` (certify/check.h) decides
/// whether it is true. Lengths are hyperbolic.
namespace epsnet::certify {

/// A geodesics file.
struct GeodesicsDocument {
  /// The claim about the list of geodesics.
  ///
  /// `systole`: one closed geodesic, and none is shorter. `spectrum`: all primitive closed geodesics of length at most
  /// `up_to`, up to orientation. `thick_thin`: all of length at most 2 arsinh 1, with the pieces of the surface cut
  /// along them. `local_maximum`: a spectrum of which the first cluster has the shortest closed geodesics, and the
  /// systole of any other surface near this one is less.
  enum class Claim { systole, spectrum, thick_thin, local_maximum };
  /// By claim, what files call it.
  static constexpr std::array<std::string_view, 4> kClaimNames{"systole", "spectrum", "thick-thin", "local-maximum"};

  /// The closed geodesic in the free homotopy class of a loop at a vertex.
  ///
  /// The loop starts and ends in the tile of the vertex's chart and crosses the sides of the word, in this order; the
  /// geodesic is directed like the loop.
  struct ClosedGeodesic {
    std::uint32_t vertex = 0;
    std::vector<std::uint32_t> word;
    Interval length{};  ///< Contains the length; 0 < lower ≤ upper.
    bool simple = false;
    bool operator==(const ClosedGeodesic&) const = default;
  };

  /// geodesics[first], …, geodesics[first + count − 1]: a run of lengths that the enclosures cannot distinguish.
  struct Cluster {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool equal = false;  ///< All lengths of the run are claimed to be exactly equal; false claims nothing.
    bool operator==(const Cluster&) const = default;
  };

  /// A component of the surface minus the geodesics.
  struct Piece {
    std::uint32_t genus = 0;
    /// Pairs (index of a geodesic, side of it that bounds the piece); 0 is left, 1 is right.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> boundaries;
    bool operator==(const Piece&) const = default;
  };

  Claim claim = Claim::systole;
  NetDocument net;
  std::string up_to;  ///< A decimal as written; only if `has_up_to()`, else empty.
  std::vector<ClosedGeodesic> geodesics;
  std::vector<Cluster> clusters;  ///< Empty for a systole.
  std::vector<Piece> pieces;      ///< Only for thick_thin.

  // Only for local_maximum.
  std::vector<std::uint32_t> basis;    ///< Shortest closed geodesics, of which the gradients are a basis.
  std::vector<std::uint32_t> weights;  ///< Of the other shortest ones, in order.

  /// What files call the claim.
  [[nodiscard]] std::string_view claim_name() const { return kClaimNames.at(static_cast<std::size_t>(claim)); }
  /// Whether the list goes up to the length `up_to`.
  [[nodiscard]] bool has_up_to() const { return claim == Claim::spectrum || claim == Claim::local_maximum; }
  bool operator==(const GeodesicsDocument&) const = default;
};

}  // namespace epsnet::certify
