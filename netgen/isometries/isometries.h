#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/comparison/document.h"
#include "certify/claims/isometries/document.h"
#include "certify/net/document.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/surface.h"

/// The isometries of a surface, and from one surface to another. docs/isometries.md says how and why.
///
/// That they are isometries is decided exactly. That there is no other one is computed with numbers of 512 bits;
/// `certified_isometries` proves it. `isometric` proves that two surfaces are isometric, or that they are not, by their
/// closed geodesics. `identify` finds which known surface one is.
namespace epsnet {

/// An isometry between two surfaces S and T, as what it does with the group of S: f lifts to an isometry of the plane,
/// from the coordinates of tile 0 of S to those of tile 0 of T.
struct SurfaceIsometry {
  bool preserves_orientation;
  /// By generator γ of S: a word of T, from tile 0 to itself, for f ∘ γ ∘ f⁻¹. The generators are the sides k of
  /// fundamental_polygon(S) with k < partner, in order.
  std::vector<Word> images;
};

/// The words of these generators: paths from tile 0 to itself. O(sides) but for the letters.
[[nodiscard]] std::vector<Word> generator_words(const Surface& surface);

struct IsometryLifts;

/// The isometries of a surface, a group. Copies share what does not change.
class IsometryGroup {
 public:
  /// The order of the group. Isometry 0 is the identity.
  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  /// An isometry, by its number. It is computed here: a walk through the tiles for each generator of the surface's
  /// group. Throws LimitError if its numbers are too large.
  [[nodiscard]] SurfaceIsometry isometry(std::uint32_t i) const;
  /// Whether it preserves the orientation.
  [[nodiscard]] bool preserves_orientation(std::uint32_t i) const { return preserves_[i]; }
  /// How many preserve the orientation.
  [[nodiscard]] std::size_t orientation_preserving() const;
  /// The numbers of isometries that generate all.
  [[nodiscard]] const std::vector<std::uint32_t>& generators() const { return generators_; }
  /// The number of the isometry i after j. O(size) at worst.
  [[nodiscard]] std::uint32_t product(std::uint32_t i, std::uint32_t j) const;
  /// By isometry j: product(i, j). These permutations are a group isomorphic to that of the isometries. O(size) for
  /// each of the generators that i is a product of.
  [[nodiscard]] Permutation permutation(std::uint32_t i) const;
  /// The least n > 0 for which the n-th power is the identity.
  [[nodiscard]] std::uint32_t order(std::uint32_t i) const;
  /// How many points an isometry other than the identity leaves where they are; nothing for those that reverse the
  /// orientation, as they may fix curves, and for the identity.
  [[nodiscard]] std::optional<std::uint64_t> fixed_points(std::uint32_t i) const { return fixed_points_[i]; }
  /// "C6" for a cyclic group, "D4" for the symmetries of a square, "C2 x C2"; empty for other groups.
  [[nodiscard]] std::string name() const;
  /// The closed geodesics from which they were told.
  [[nodiscard]] const certify::GeodesicsDocument& geodesics() const { return geodesics_; }

 private:
  friend IsometryGroup isometries(const Surface& surface, const struct IsometryOptions& options);
  friend class DomainSearch;
  class Builder;

  /// The places of generators of which an isometry is the product, the first one applied first.
  [[nodiscard]] std::vector<std::uint32_t> factors(std::uint32_t i) const;

  std::shared_ptr<const IsometryLifts> lifts_;
  std::vector<std::uint32_t> generators_;
  std::vector<std::vector<std::uint32_t>> action_;  ///< By generator g and isometry j: g after j.
  /// By isometry other than the identity: it is a generator, by its place, after another isometry.
  struct Step {
    std::uint32_t generator;
    std::uint32_t then;
  };
  std::vector<Step> steps_;
  std::vector<bool> preserves_;
  std::vector<std::optional<std::uint64_t>> fixed_points_;
  certify::GeodesicsDocument geodesics_;
};

/// How isometries are computed.
struct IsometryOptions {
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called occasionally, if given.
};

/// Returns all isometries of a surface. Throws NetError, or LimitError if the search would be too long: if the systole
/// is less than 0.01.
///
/// Time is about that of the spectrum up to the length of the systole, or 4, and some e^d steps for each closed
/// geodesic that is as long as the one that is chosen, up to symmetries of the tiles, where d is the length of a
/// shortest loop across it.
[[nodiscard]] IsometryGroup isometries(const Surface& surface, const IsometryOptions& options = {});

/// Returns the isometry group of a surface as a file, proved: with the closed geodesics from which the isometries were
/// told, or longer ones until they leave room for no other isometry. Throws NotCertifiedError if closed geodesics that
/// are 4 longer do not suffice, or take too much work, and as `isometries`. Time is that of the spectrum and its
/// certificate, and the exact examination of the group's generators.
[[nodiscard]] Certified<certify::IsometriesDocument> certified_isometries(const Surface& surface,
                                                                          const IsometryGroup& group,
                                                                          const IsometryOptions& options = {});

/// Returns what files say of isometries of a surface; not proved. O(letters of the images). Throws LimitError if no
/// elements are found of which the axes cross.
[[nodiscard]] certify::IsometryRows isometry_rows(const Surface& surface,
                                                  const std::vector<SurfaceIsometry>& isometries);

/// What comes near to an isometry between two surfaces, as where the numbers of one of them are rounded: an isomorphism
/// of their groups that hardly changes traces. Computed with 512 bits, not proved.
struct NearIsometry {
  SurfaceIsometry marking;  ///< The isomorphism.
  /// By how much traces differ at most: those of generators and of products of two, from those of their images.
  double difference;
};

/// The answer to whether two surfaces are isometric.
struct IsometricAnswer {
  /// What is known.
  enum class Kind {
    yes,       ///< Decided exactly: here, or by `proof`.
    no,        ///< Proved, by `proof`.
    undecided  ///< No isometry is found with 512 bits and no proof that there is none; or `isometry` is one to 100
               ///< bits, but the numbers of the surfaces cannot be compared exactly.
  };
  Kind kind = Kind::undecided;
  std::optional<SurfaceIsometry> isometry;
  std::string reason;  ///< Of a `no`: what tells the surfaces apart, in words; of `undecided`, why.
  /// The answer as a file, VERIFIED. Absent if it is undecided, or if an isometry is decided here alone, as its numbers
  /// are too large for the checker.
  std::optional<Certified<certify::ComparisonDocument>> proof;
  /// If there is no `isometry`: what is nearest to one, if traces differ by some thousandths at most.
  std::optional<NearIsometry> near;
};

/// Returns what a comparison file says of an isometry from one surface to another, given a net of each; not proved.
/// O(letters of the images). Throws LimitError if no elements are found of which the axes cross.
[[nodiscard]] certify::ComparisonDocument isometry_document(const Surface& first, const Surface& second,
                                                            const SurfaceIsometry& isometry, certify::NetDocument net,
                                                            certify::NetDocument other_net);

/// Returns an isometry from one surface to another, if there is one: one that preserves the orientation, if there is
/// one of those. Otherwise it looks for numbers of closed geodesics that differ, or for closed geodesics that cross
/// otherwise, up to lengths that are 2 longer than those that `isometries` needs. Throws as `isometries`; time is about
/// that of `isometries` for the first surface, with two spectra and their certificate.
[[nodiscard]] IsometricAnswer isometric(const Surface& first, const Surface& second,
                                        const IsometryOptions& options = {});

// Which surface is this?

/// A surface that has names, and whether it is isometric to a given one.
struct NamedAnswer {
  std::vector<std::string> names;  ///< For named_surface; the first one is the one to say.
  std::string compared;            ///< The one of them with which the surface was compared at last.
  IsometricAnswer answer;          ///< From the given surface to named_surface(compared).
};

/// Returns the names of the known surfaces of a genus, those of each surface together: names_of_genus, then those of
/// its regular maps, the map with the most rotations first.
[[nodiscard]] std::vector<std::vector<std::string>> known_surfaces(std::uint32_t genus);

/// Compares a surface with the known ones of its genus, up to the one to which it is isometric, which is then the last
/// of the list: first with those that have as many closed geodesics of the length of its systole, and as many
/// isometries. Throws as `isometric`; the time is about that of one comparison with a surface to which it is isometric,
/// and a verified list of systoles for each known surface if there is none.
[[nodiscard]] std::vector<NamedAnswer> identify(const Surface& surface, const IsometryOptions& options = {});

}  // namespace epsnet
