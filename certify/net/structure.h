#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/net/document.h"
#include "certify/net/numbering.h"

/// What a document must satisfy before any rule makes sense: indices point somewhere, every side is glued
/// once, words compose, labels are used in the charts they belong to, coordinates are finite and inside the disk.
///
/// A document without these is not a wrong net but no net: MALFORMED. O(size of the document), exact.
namespace epsnet::certify {

/// The largest genus of a surface known by name, and the largest length of its free text in bytes.
inline constexpr std::uint32_t kMaxRegularGenus = 1000;
inline constexpr std::size_t kMaxAboutBytes = std::size_t{1} << 20;

/// The place of a row, at the beginning of a problem: "MEMBER[ROW]: ".
[[nodiscard]] std::string at(const char* member, std::size_t row);

/// The first problem among problem(row) of the rows of a member, with its place; nullopt if there is none.
template <class Rows, class ProblemOfRow>
[[nodiscard]] Problem first_row_problem(const char* member, const Rows& rows, const ProblemOfRow& problem) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (const auto found = problem(rows[row])) return at(member, row) + *found;
  }
  return std::nullopt;
}

/// The largest numbers of sides and of corners around a vertex of the tiles of a map.
inline constexpr std::uint32_t kMaxRegularSides = 10'000;

/// What is wrong with the genus of a regular 4g-gon; nullopt if it is in range.
[[nodiscard]] Problem regular_genus_problem(std::uint32_t genus);

/// What is wrong with one of the two numbers of a map's tile; nullopt if it is in range.
[[nodiscard]] Problem map_number_problem(std::uint32_t number);

/// The largest degree of a number field.
inline constexpr std::size_t kMaxFieldDegree = 64;

/// What is wrong with the polynomial of a number field; nullopt if it is monic, and its degree in range.
[[nodiscard]] Problem polynomial_problem(const std::vector<mpz_class>& polynomial);

/// The first problem, "PLACE: what is wrong, what was expected"; nullopt if there is none. Corners of tiles are not
/// examined (that is rule `surface`).
[[nodiscard]] Problem structure_problem(const SurfaceDocument& surface);

/// As above, for the whole document, by up to so many threads.
[[nodiscard]] Problem structure_problem(const NetDocument& document, unsigned threads = 1);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits"): of a net, a point, a word.
[[nodiscard]] std::uint64_t least_bytes(const NetDocument& document);
[[nodiscard]] std::uint64_t least_bytes(const RationalPoint& point);
[[nodiscard]] std::uint64_t least_bytes(const std::vector<std::uint32_t>& word);

// What claims ask of their own members.

/// As structure_problem, for the net of a claim about the whole surface: it has no collars either.
[[nodiscard]] Problem whole_net_problem(const NetDocument& net);

/// As whole_net_problem, for a claim about the one vertex of the net.
[[nodiscard]] Problem one_vertex_problem(const NetDocument& net);

/// What is wrong with a word that should lead from one tile to another, that of `target`. Requires: sides of a surface
/// without problem.
[[nodiscard]] Problem word_problem(const SurfaceSides& sides, const std::vector<std::uint32_t>& word,
                                   std::uint32_t from, std::uint32_t to, const std::string& target);

/// x² + y² < 1, exactly.
[[nodiscard]] bool inside_disk(double x, double y);

/// Whether both ends are finite, not negative, and in order.
[[nodiscard]] bool is_length(Interval x);

/// Which triangles and vertices the collars of a pseudo net name; nothing in any other net.
class CollarMembers {
 public:
  /// Needs a document without structure problem. O(number of triangles) if there is a collar.
  explicit CollarMembers(const NetDocument& document) : pseudo_(document.collars.has_value()) {
    if (!pseudo_ || document.collars->empty()) return;
    triangles_.resize(document.triangles.size());
    for (const NetDocument::Collar& collar : *document.collars) {
      for (const std::uint32_t t : collar.triangles) triangles_[t] = true;
      partners_[collar.vertices[0]] = collar.vertices[1];
      partners_[collar.vertices[1]] = collar.vertices[0];
    }
  }

  /// Whether the net is a pseudo net.
  [[nodiscard]] bool pseudo() const { return pseudo_; }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return !triangles_.empty() && triangles_[t]; }
  [[nodiscard]] bool has_vertex(std::uint32_t v) const { return partners_.contains(v); }
  /// Whether two vertices are those of one collar.
  [[nodiscard]] bool are_partners(std::uint32_t u, std::uint32_t v) const {
    const auto found = partners_.find(u);
    return found != partners_.end() && found->second == v;
  }

 private:
  bool pseudo_;
  std::vector<bool> triangles_;
  std::unordered_map<std::uint32_t, std::uint32_t> partners_;
};

/// The first of `count` ≥ 1 nodes to which no path leads from node 0; nullopt if there is none. neighbours(node, visit)
/// calls visit(other) for each neighbour. O(count + neighbours).
///
/// What is found first is left first, so that nodes stay near in memory whose neighbours are.
template <class Neighbours>
[[nodiscard]] std::optional<std::size_t> first_unreached(std::size_t count, const Neighbours& neighbours) {
  std::vector<bool> reached(count);
  std::vector<std::uint32_t> found{0};
  found.reserve(count);
  reached[0] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    neighbours(found[i], [&](std::uint32_t other) {
      if (reached[other]) return;
      reached[other] = true;
      found.push_back(other);
    });
  }
  for (std::size_t node = 0; node < count; ++node) {
    if (!reached[node]) return node;
  }
  return std::nullopt;
}

}  // namespace epsnet::certify
