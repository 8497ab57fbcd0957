#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "certify/exact/document.h"
#include "certify/exact/plane.h"
#include "certify/exact/squared_sinh.h"

/// The rules of nets and pseudo nets on rational tiles, in the order of docs/proof.md.
namespace epsnet::exact {

/// A question that is too large for exact numbers, or too close for the digits used.
struct TooLarge {
  std::string what;
};

/// What is wrong with the claim.
struct Refutation {
  std::string what;
};

/// A rule and its question, which throws Refutation or TooLarge.
struct Rule {
  const char* name;
  std::function<void()> ask;
};

inline std::string number(std::size_t n) { return std::to_string(n); }

[[nodiscard]] inline Index next(Index dart) { return dart % 3 == 2 ? dart - 2 : dart + 1; }
[[nodiscard]] inline Index previous(Index dart) { return dart % 3 == 0 ? dart + 2 : dart - 1; }

/// Throws Malformed, "WHAT INDEX does not exist", unless the index is less than the size.
void expect_less(std::size_t index, std::size_t size, const char* what);

/// A net and its rules. A rule may be asked if those before it are verified. The net must live as long.
class NetRules {
 public:
  /// Throws Malformed if the structure of the net is broken.
  explicit NetRules(const Net& net);
  NetRules(const NetRules&) = delete;
  NetRules& operator=(const NetRules&) = delete;

  /// The rules of the net. This must live as long as they do.
  [[nodiscard]] std::vector<Rule> rules();

  /// Throws Malformed unless the word is a path from the tile `from` to the tile `to`.
  void expect_path(const std::vector<Index>& word, Index from, Index to) const;

  [[nodiscard]] const Net& net() const { return net_; }
  /// 2 − 2g, after rule `surface`.
  [[nodiscard]] std::int64_t euler() const { return euler_; }

  [[nodiscard]] std::size_t darts() const { return 3 * net_.triangles.size(); }
  [[nodiscard]] Index opposite(Index dart) const { return net_.triangles[dart / 3].opposite[dart % 3]; }
  [[nodiscard]] Index start(Index dart) const { return net_.triangles[dart / 3].vertex[dart % 3]; }
  [[nodiscard]] Index label_number(Index dart) const { return net_.triangles[dart / 3].label[dart % 3]; }

  // Exact numbers, as long as they are not too large. After rule `surface`.

  /// Takes so many bits from those that are left. Throws TooLarge.
  void spend(std::size_t bits);
  /// g ∘ f, reduced.
  Isometry product(const Isometry& g, const Isometry& f);
  Point image(const Isometry& f, const Point& z);
  /// The value of a label number, F_to⁻¹ ∘ word ∘ F_from.
  const Isometry& label(Index number_of_label);
  /// The value of a word after F_from, in the coordinates of the tile where it ends.
  Isometry value(Index from, const std::vector<Index>& word);
  /// The corner where the dart starts, in the chart of its triangle.
  Point corner(Index dart);
  /// Whether the circumradius of a triangle is less than the length whose sinh² is given; no if there is no
  /// circumcircle.
  Answer circumradius_is_less(Index t, const SquaredSinh& s);
  /// Whether half of the edge of a dart is less.
  Answer half_edge_is_less(Index dart, const SquaredSinh& s);

 private:
  /// path.back() ∘ … ∘ path.front(), halves first, so that most products are of small numbers.
  Isometry product(std::span<const Isometry* const> path);

  /// Sides are numbered through all tiles.
  void number_sides();
  void check_triangle_structure(const Triangle& triangle) const;
  void check_collar_structure(const Collar& collar) const;
  [[nodiscard]] std::string triangle_name(std::size_t t) const;
  [[nodiscard]] std::string edge_name(Index dart) const;
  /// The vertex of its tile where a side starts.
  [[nodiscard]] Index vertex_of(Index s) const { return s - first_side_[tile_of_[s]]; }
  [[nodiscard]] const Point& side_start(Index s) const { return net_.tiles[tile_of_[s]][vertex_of(s)]; }
  [[nodiscard]] Index side_after(Index s) const;
  [[nodiscard]] Index side_before(Index s) const;
  [[nodiscard]] const Point& side_end(Index s) const { return side_start(side_after(s)); }
  [[nodiscard]] std::string side_name(Index s) const;
  void check_surface();
  /// (a): in the disk, a left turn at every corner, and seen from vertex 0 in counterclockwise order.
  void check_tile(std::size_t t) const;
  /// (c), and the crossings.
  void check_lengths();
  /// p ↦ q′ and q ↦ p′: p to 0, a turn, 0 to q′.
  Isometry crossing(const Point& p, const Point& q, const Point& p_other, const Point& q_other);
  /// (f) and (g): around every cycle of corners the crossings multiply to 1 and the angles add up to one full turn. The
  /// number of cycles.
  std::size_t check_corners();
  /// Whether the argument in [0, 2π) is at least π. Any half-plane would do to count full turns: the walk ends in the
  /// direction in which it starts.
  static bool is_below(const Gaussian& z) { return sgn(z.im) < 0 || (sgn(z.im) == 0 && sgn(z.re) < 0); }
  /// A number whose argument, between 0 and π, is the interior angle where the side starts.
  [[nodiscard]] Gaussian interior_angle(Index s);
  void check_map();
  /// (∗): L_a L_b⁻¹ = L_c L_d⁻¹ across every edge, each equation once.
  void check_gluing();
  void check_collars();
  /// (b): the dart from p to p of the first triangle.
  [[nodiscard]] Index loop_of(const Collar& collar) const;
  /// The dart of a triangle that goes from `twice` to itself, the third corner being `once`.
  [[nodiscard]] Index loop_dart(Index t, Index twice, Index once) const;
  /// (c) to (g).
  void check_collar(const Collar& collar);
  void check_orientation();
  /// The corner of the neighbour across the dart that is not on it, in the chart of the dart's triangle.
  Point far_corner(Index dart);
  /// Lemma 3.1: the sign of the determinant with the rows (x, y, |z|², 1) of the edge's two ends, the third corner of
  /// the triangle and the far corner; the last one is taken for the origin.
  void check_delaunay();
  void check_covering();
  void check_packing();
  void check_thick();
  [[nodiscard]] bool are_partners(Index u, Index v) const;
  /// Throws Refutation if the edge of a dart is shorter than twice the length whose sinh² is given.
  void expect_long(Index dart, const SquaredSinh& s);

  const Net& net_;
  std::vector<Index> first_side_;  ///< By tile.
  std::vector<Index> tile_of_;     ///< By side.
  std::vector<Index> partner_;     ///< By side.
  std::vector<Isometry> crossings_;
  std::int64_t euler_ = 0;
  std::map<Index, Isometry> labels_;
  std::size_t bits_left_;
  std::vector<bool> in_collar_;      ///< By triangle.
  std::map<Index, Index> partners_;  ///< Of each vertex of a collar, the other one.
};

}  // namespace epsnet::exact
