#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "certify/exact/document.h"

/// What has no numbers: the structure of a net's document, and the rule `map`.
namespace epsnet::exact {

inline std::string number(std::size_t n) { return std::to_string(n); }

[[nodiscard]] inline Index next(Index dart) { return dart % 3 == 2 ? dart - 2 : dart + 1; }
[[nodiscard]] inline Index previous(Index dart) { return dart % 3 == 0 ? dart + 2 : dart - 1; }

/// Throws Malformed, "WHAT INDEX does not exist", unless the index is less than the size.
void expect_less(std::size_t index, std::size_t size, const char* what);

/// The sides, words, darts and labels of a net. The net must live as long.
class NetStructure {
 public:
  /// Throws Malformed if the structure of the net is broken.
  explicit NetStructure(const Net& net);

  /// Throws Malformed unless the word is a path from the tile `from` to the tile `to`.
  void expect_path(const std::vector<Index>& word, Index from, Index to) const;
  /// The same of one path from tile 0 to each tile.
  void expect_paths(const std::vector<std::vector<Index>>& paths) const;
  /// The same of `size` paths from tile 0 to itself; `what` they are.
  void expect_loops(const std::vector<std::vector<Index>>& words, std::size_t size, const char* what) const;
  /// A path from tile 0 to each tile.
  [[nodiscard]] std::vector<std::vector<Index>> paths() const;
  /// Of isometries: paths, a pair, and the images of this and of the generators. Throws Malformed.
  void expect_words(const IsometryRows& rows) const;
  /// The generators g_s = paths[t] · s · paths[t′]⁻¹ of the group, by side s less than its partner. Throws TooLarge.
  [[nodiscard]] std::vector<std::vector<Index>> generators(const std::vector<std::vector<Index>>& paths) const;

  [[nodiscard]] const Net& net() const { return net_; }
  [[nodiscard]] std::size_t darts() const { return 3 * net_.triangles.size(); }
  [[nodiscard]] Index opposite(Index dart) const { return net_.triangles[dart / 3].opposite[dart % 3]; }
  [[nodiscard]] Index start(Index dart) const { return net_.triangles[dart / 3].vertex[dart % 3]; }
  [[nodiscard]] Index label_number(Index dart) const { return net_.triangles[dart / 3].label[dart % 3]; }

  [[nodiscard]] std::string triangle_name(std::size_t t) const;
  [[nodiscard]] std::string edge_name(Index dart) const;
  [[nodiscard]] std::string side_name(Index s) const;
  /// The name of the corner where a side starts.
  [[nodiscard]] std::string corner_name(Index s) const;

  /// Sides are numbered through all tiles.
  [[nodiscard]] std::size_t sides() const { return tile_of_.size(); }
  [[nodiscard]] Index side(Index tile, Index k) const { return first_side_[tile] + k; }
  [[nodiscard]] Index tile_of(Index s) const { return tile_of_[s]; }
  [[nodiscard]] Index partner(Index s) const { return partner_[s]; }
  /// The vertex of its tile where a side starts.
  [[nodiscard]] Index vertex_of(Index s) const { return s - first_side_[tile_of_[s]]; }
  [[nodiscard]] Index side_after(Index s) const;
  [[nodiscard]] Index side_before(Index s) const;

  /// Throws Refutation unless the tiles are connected.
  void expect_connected_tiles() const;
  /// The rule `map`. `euler` is that of the surface.
  void check_map(std::int64_t euler) const;

 private:
  void number_sides();
  void check_triangle_structure(const Triangle& triangle) const;
  void check_collar_structure(const Collar& collar) const;

  const Net& net_;
  std::vector<Index> first_side_;  ///< By tile.
  std::vector<Index> tile_of_;     ///< By side.
  std::vector<Index> partner_;     ///< By side.
};

}  // namespace epsnet::exact
