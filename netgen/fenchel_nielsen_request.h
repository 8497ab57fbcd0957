#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "epsnet/netgen/fenchel_nielsen.h"
#include "epsnet/triangulation/error.h"

namespace epsnet {

/// A request that cannot be meant; what() names the option or member.
class FenchelNielsenRequestError : public Error {
 public:
  using Error::Error;
};

/// Fenchel–Nielsen coordinates as somebody writes them down, on a command line or in a JSON file. What is left out is
/// drawn with the seed.
struct FenchelNielsenRequest {
  /// "chain", "ring", "tree", "random", or the edges themselves as in "0-1 0-1 0-1". Empty: random.
  std::string graph;
  std::optional<std::uint32_t> genus;
  std::optional<std::uint64_t> seed;
  /// Decimals or rationals, one for each edge, or one for all. Empty: random.
  std::vector<std::string> lengths;
  std::vector<std::string> twists;
};

/// The coordinates that are meant. Throws FenchelNielsenRequestError, PantsGraphError.
[[nodiscard]] FenchelNielsen resolve(const FenchelNielsenRequest& request);

/// Reads a request from a JSON object with some of the members "graph", "genus", "seed", "lengths", "twists"; numbers
/// are exact decimals, bare or in strings. Throws FenchelNielsenRequestError, which starts with the path.
[[nodiscard]] FenchelNielsenRequest load_fenchel_nielsen(const std::filesystem::path& path);

}  // namespace epsnet
