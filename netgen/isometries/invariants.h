#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/comparison/document.h"
#include "certify/claims/geodesics/document.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// What isometries preserve: the homology of a surface, and the lengths of its closed geodesics.
namespace epsnet {

/// The first homology of a surface, over the field of p = 2³¹ − 1 elements: that of the side pairings of its
/// fundamental polygon, up to the relations.
class Homology {
 public:
  /// Numbers modulo p, from 0 on.
  using Vector = std::vector<std::uint64_t>;
  static constexpr std::uint64_t kPrime = (std::uint64_t{1} << 31) - 1;

  /// O(sides × genus).
  explicit Homology(const Surface& surface);

  /// 2 × genus.
  [[nodiscard]] std::size_t dimension() const { return basis_.size(); }
  /// The numbers of pairs of sides k < partner of fundamental_polygon, in order, of which the classes are the basis.
  [[nodiscard]] const std::vector<std::size_t>& basis() const { return basis_; }
  /// Returns the class of a word from tile 0 to itself. O(letters + pairs × genus).
  [[nodiscard]] Vector class_of(const Word& word) const;

 private:
  ById<SideId, std::int64_t> sign_;  ///< 1 or −1 if a side of the surface is a side of the polygon, else 0,
  ById<SideId, std::size_t> pair_;   ///< and of which pair.
  std::vector<std::size_t> basis_;
  std::vector<Vector> coordinates_;  ///< By pair.
};

/// A linear map of the homology of a surface to itself.
class HomologyMap {
 public:
  /// Of the isometry that takes some words to their images. Requires: words of all pairs of sides, in order.
  HomologyMap(const Homology& homology, const std::vector<Word>& words, const std::vector<Word>& images);

  /// The image of a class. O(genus²).
  [[nodiscard]] Homology::Vector operator()(const Homology::Vector& vector) const;
  /// The trace. Requires: it is less than 10⁹.
  [[nodiscard]] std::int64_t trace() const;

 private:
  std::vector<Homology::Vector> columns_;
};

/// What tells two surfaces apart, in words: a length ℓ such that one of them certainly has more primitive closed
/// geodesics that are at most as long than the other one. Nothing, if there is none.
///
/// Requires: spectra. The statement follows from them (docs/isometries.md); they are not checked here. O(n log n).
[[nodiscard]] std::optional<std::string> certain_difference(const certify::GeodesicsDocument& first,
                                                            const certify::GeodesicsDocument& second);

/// That the surfaces of two spectra are not isometric, proved by these; nothing, if certify does not verify it. Time is
/// that of both certificates, and that of comparing where closed geodesics cross, if their numbers do not differ.
[[nodiscard]] std::optional<Certified<certify::ComparisonDocument>> proved_difference(
    const certify::GeodesicsDocument& first, const certify::GeodesicsDocument& other, unsigned threads,
    const Progress& progress = {});

}  // namespace epsnet
