#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "certify/exact/algebraic.h"
#include "certify/exact/document.h"
#include "certify/exact/interval.h"
#include "certify/exact/net_structure.h"
#include "certify/exact/number_field.h"
#include "certify/exact/plane.h"
#include "certify/exact/rough_interval.h"

/// The rules of nets and pseudo nets, in the order of docs/proof.md.
namespace epsnet::exact {

/// A rule and its question, which throws Refutation or TooLarge.
struct Rule {
  const char* name;
  std::function<void()> ask;
  bool may_be_open = false;  ///< The next rule is asked even if this one is not decided.
};

/// A net and its rules. A rule may be asked if those before it are verified. The net must live as long. R is mpz_class
/// if its tiles are rational, Algebraic if they are regular, and FieldNumber if they are over a number field.
template <class R>
class NetRules : public NetStructure {
 public:
  /// Throws Malformed if the structure of the net is broken.
  explicit NetRules(const Net& net);
  NetRules(const NetRules&) = delete;
  NetRules& operator=(const NetRules&) = delete;

  /// The rules of the net. This must live as long as they do.
  [[nodiscard]] std::vector<Rule> rules();

  /// The Euler characteristic of the surface. After rule `surface`.
  [[nodiscard]] std::int64_t euler() const { return euler_; }

  // Exact numbers, as long as they are not too large. After rule `surface`.

  /// Takes so many bits from those that are left. Throws TooLarge.
  void spend(std::size_t bits);
  /// g ∘ f, reduced.
  Isometry<R> product(const Isometry<R>& g, const Isometry<R>& f);
  /// path.back() ∘ … ∘ path.front(), halves first, so that most products are of small numbers.
  Isometry<R> product(std::span<const Isometry<R>* const> path);
  Point<R> image(const Isometry<R>& f, const Point<R>& z);
  /// The value of a label number, F_to⁻¹ ∘ word ∘ F_from.
  const Isometry<R>& label(Index number_of_label);
  /// The value of a word.
  Isometry<R> value(const std::vector<Index>& word) { return value(Isometry<R>(), word); }
  /// The value of a word after F_from, in the coordinates of the tile where it ends.
  Isometry<R> value(Index from, const std::vector<Index>& word) { return value(frame(from), word); }
  /// z ↦ (z + c)/(1 + c̄z), c the centre of the chart.
  [[nodiscard]] Isometry<R> frame(Index chart) const { return translation_to(point<R>(net().charts[chart].second)); }
  /// The corner where the dart starts, in the chart of its triangle.
  Point<R> corner(Index dart);
  /// What takes coordinates of the chart of a dart's end to those of its start's chart, along the dart.
  Isometry<R> element(Index dart) {
    return product(inverse(label(label_number(dart))), label(label_number(next(dart))));
  }
  /// Whether a triangle has a circumcircle.
  bool has_circumcircle(Index t);
  /// Whether the circumradius of a triangle is less than the length whose sinh² is given; no if there is no
  /// circumcircle.
  Answer circumradius_is_less(Index t, const SquaredSinh& s);
  /// Whether half of the edge of a dart is less.
  Answer half_edge_is_less(Index dart, const SquaredSinh& s);

 private:
  Isometry<R> value(const Isometry<R>& first, const std::vector<Index>& word);
  void check_surface();
  /// What the kinds of tiles have to themselves: that they fit around every corner. The number of cycles of corners.
  std::size_t check_tiles();
  /// What takes coordinates of the tile of each side to those of the tile beyond.
  const std::vector<Isometry<R>>& crossings();
  /// (∗): L_a L_b⁻¹ = L_c L_d⁻¹ across every edge, each equation once.
  void check_gluing();
  void check_collars();
  void check_orientation();
  /// The corner of the neighbour across the dart that is not on it, in the chart of the dart's triangle.
  Point<R> far_corner(Index dart);

  // The same in intervals of a few digits. Factors of numbers that belong together do not matter.

  const Isometry<RoughInterval>& rough_label(Index number_of_label);
  Point<RoughInterval> rough_corner(Index dart);
  Point<RoughInterval> rough_far_corner(Index dart);
  void check_delaunay();
  void check_covering();
  void check_packing();
  void check_thick();
  [[nodiscard]] bool are_partners(Index u, Index v) const;
  /// Throws Refutation if the edge of a dart is shorter than twice the length whose sinh² is given.
  void expect_long(Index dart, const SquaredSinh& s);

  std::shared_ptr<void> field_;         ///< To which the numbers belong, unless they are integers.
  std::vector<Isometry<R>> crossings_;  ///< By side.
  std::int64_t euler_ = 0;
  std::map<Index, Isometry<R>> labels_;
  std::map<Index, Isometry<RoughInterval>> rough_labels_;
  std::size_t bits_left_;
  std::vector<bool> in_collar_;      ///< By triangle.
  std::map<Index, Index> partners_;  ///< Of each vertex of a collar, the other one.
};

template <>
std::size_t NetRules<mpz_class>::check_tiles();
template <>
std::size_t NetRules<Algebraic>::check_tiles();
template <>
std::size_t NetRules<FieldNumber>::check_tiles();
template <>
const std::vector<Isometry<Algebraic>>& NetRules<Algebraic>::crossings();

extern template class NetRules<mpz_class>;
extern template class NetRules<Algebraic>;
extern template class NetRules<FieldNumber>;

}  // namespace epsnet::exact
