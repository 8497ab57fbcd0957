#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/surface/error.h"

namespace epsnet {

/// An invalid request. what() is "MEMBER: PROBLEM" if one member is wrong, else "PROBLEM".
class FenchelNielsenRequestError : public Error {
 public:
  /// An error that belongs to no single member.
  explicit FenchelNielsenRequestError(const std::string& problem) : Error(problem), problem_(problem) {}
  /// An error in a member, with the problem.
  FenchelNielsenRequestError(const std::string& member, const std::string& problem)
      : Error(member + ": " + problem), member_(member), problem_(problem) {}

  /// "graph", "genus", "seed", "lengths", "twists", or empty.
  [[nodiscard]] const std::string& member() const { return member_; }
  /// The problem, without the name of the member.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  std::string member_;
  std::string problem_;
};

/// Fenchel–Nielsen coordinates as given on a command line or in a JSON file. Missing values are drawn with the seed.
struct FenchelNielsenRequest {
  /// "chain", "ring", "tree", "random", or the edges themselves as in "0-1 0-1 0-1". Empty: random.
  std::string graph;
  std::optional<std::uint32_t> genus;
  std::optional<std::uint64_t> seed;
  /// Decimals or rationals, one for each edge, or one for all. Empty: random.
  std::vector<std::string> lengths;
  std::vector<std::string> twists;
};

/// Returns the coordinates of a request. Checks the given values before it requires a seed. Throws
/// FenchelNielsenRequestError.
[[nodiscard]] FenchelNielsen resolve(const FenchelNielsenRequest& request);

/// Reads a request from the text of a JSON object with some of the members "graph", "genus", "seed", "lengths",
/// "twists"; numbers are exact decimals, bare or in strings. Throws FenchelNielsenRequestError.
[[nodiscard]] FenchelNielsenRequest parse_fenchel_nielsen(const std::string& text);

}  // namespace epsnet
