#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/exact/document.h"
#include "certify/exact/loops.h"

namespace epsnet::exact {

/// Lemma 15.4 of docs/proof.md: the components of the surface without closed geodesics, in any order. The geodesics are
/// simple, pairwise disjoint, and given by a loop each, from its start to its end. Throws TooLarge.
template <class R>
[[nodiscard]] std::vector<Piece> pieces(NetRules<R>& net, const Loops<R>& loops,
                                        const std::vector<std::size_t>& geodesics);

/// Section 11.1 of docs/proof.md: a list of closed geodesics, and the loops at all vertices with which it is compared.
/// The net's rules and the document must live as long.
template <class R>
class GeodesicRules {
 public:
  /// The list may ask for so many lifted vertices. Throws Malformed if the structure of the document is broken.
  GeodesicRules(const GeodesicsDocument& document, NetRules<R>& net, long most_lifts);

  /// The rules beyond those of the net. This must live as long as they do.
  [[nodiscard]] std::vector<Rule> rules();

  /// Of the list; after the rule `geodesics`.
  [[nodiscard]] const std::vector<HalfLength<R>>& lengths() const { return lengths_; }
  /// Those of length at most L.
  [[nodiscard]] Loops<R>& loops();

 private:
  /// Of elements that are conjugate, or inverse to that: powers of what root.
  struct Class {
    std::size_t root;
    unsigned exponent = 1;
  };

  void check_lengths();
  void check_distinct();
  void check_simple();
  void check_equal() const;
  void check_complete();
  void check_pieces();
  void check_maximal();

  /// By geodesic of the basis and by shortest one: the derivative of the length of the latter along a twist about the
  /// former, times sinh²(l/2) for the length l of all.
  [[nodiscard]] std::vector<std::vector<Interval>> twist_derivatives();

  [[nodiscard]] bool is_thick_thin() const { return document_.claim == GeodesicsDocument::Claim::thick_thin; }
  void expect_less(std::size_t i, const SquaredSinh& bound, bool wanted);
  void find_powers();
  [[nodiscard]] const Class& class_of(std::size_t i) const { return classes_[loops_->representative(listed_[i])]; }
  /// The loop of an element of the list, moved along edges to where it is shorter.
  [[nodiscard]] std::size_t near_its_axis(std::size_t i);
  /// Whether no two axes of the class cross near a vertex.
  [[nodiscard]] bool is_simple(std::size_t loop);

  const GeodesicsDocument& document_;
  NetRules<R>& net_;
  long most_lifts_;
  std::vector<Isometry<R>> elements_;  ///< Of the list.
  std::vector<HalfLength<R>> lengths_;
  Interval bound_;  ///< sinh²(L/2)
  std::optional<Loops<R>> loops_;
  std::vector<Class> classes_;       ///< By representative.
  std::vector<std::size_t> listed_;  ///< Loops of the elements of the list.
};

extern template class GeodesicRules<mpz_class>;
extern template class GeodesicRules<Algebraic>;
extern template class GeodesicRules<FieldNumber>;

}  // namespace epsnet::exact
