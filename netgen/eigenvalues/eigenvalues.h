#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/eigenvalues/document.h"
#include "kernel/numbers.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/group.h"
#include "triangulation/surface/surface.h"

/// The first eigenvalues of the Laplacian of a surface, counted by a net, of functions or with phases; those of the
/// graph of its tiles. docs/eigenvalues.md says how and why.
namespace epsnet {

/// Options of the search for eigenvalues.
struct EigenvaluesOptions {
  std::uint32_t count = 10;  ///< The first so many eigenvalues, and those that cannot be told apart from the last one.
  /// Instead of `count`: how many eigenvalues are less than this number; and these eigenvalues, if `digits` is given.
  std::optional<double> below = {};
  /// About so many significant digits of each eigenvalue, from 1 to 10; 9 by default, and none with `below`. Up to 2,
  /// matrices alone enclose them, which takes much less time than functions.
  std::optional<int> digits = {};
  std::optional<Length> epsilon = {};  ///< Of the net; by default it is chosen, at most 0.6.
  /// Not empty: the character χ of these phases (netgen/surfaces/group.h), 2g numbers of turns. The eigenvalues
  /// are those of functions on the plane with f(γz) = χ(γ) f(z), from λ₀(χ) on, which is 0 for χ = 1 alone; `digits` is
  /// at most 3, and 2 by default.
  std::vector<Rational> phases = {};
  /// With phases: what is found holds for all characters whose phases are at most so many turns from these, each of the
  /// 2g; more than 0 and at most 1/2.
  std::optional<Rational> box = {};
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called occasionally, if given.
};

/// Returns intervals with the first eigenvalues, from λ₁ on, or λ₀(χ) with phases, and what proves them. Deterministic.
/// Functions that take more work than the checker allows are left out: then the intervals are those of two digits.
///
/// Throws NetError if the net cannot be made or the eigenvalues are not found; NotCertifiedError, which is one, if the
/// proof fails; LimitError if the surface is beyond the
/// numbers of the generator, or it takes more than about 10⁷ triangles; CharacterError if there are not 2g phases;
/// std::invalid_argument if an option is out of range.
[[nodiscard]] Certified<certify::EigenvaluesDocument> eigenvalues(const Surface& surface,
                                                                  const EigenvaluesOptions& options = {});

namespace unproved {

/// The document of which the checker is asked first, without its proof: nothing in it is proved.
[[nodiscard]] certify::EigenvaluesDocument eigenvalues(const Surface& surface, const EigenvaluesOptions& options = {});

}  // namespace unproved

// Bands: the eigenvalues λ₀(χ) ≤ λ₁(χ) ≤ … as functions of χ, at points of the torus of all characters.

/// The phases of a character: 2g numbers of turns.
using TorusPoint = std::vector<Rational>;

/// Options of `bands`.
struct BandsOptions {
  std::uint32_t count = 4;             ///< The first so many eigenvalues.
  std::optional<int> digits = {};      ///< About so many significant digits of each, from 1 to 3; 2 by default.
  std::optional<Length> epsilon = {};  ///< Of the net; by default it is chosen.
  unsigned threads = 0;                ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};              ///< Called occasionally, if given.
  /// Called for each point with its number and its document, which is proved, one after the other in any order.
  std::function<void(std::size_t, const certify::EigenvaluesDocument&)> each = {};
};

/// Returns the points of a path through the torus: the corners, and between neighbours so many steps of equal length.
/// Throws std::invalid_argument if there is no corner or no step, or if corners have different numbers of phases.
[[nodiscard]] std::vector<TorusPoint> torus_path(const std::vector<TorusPoint>& corners, std::uint32_t steps);

/// Returns by point an interval that contains λ₀(χ), one that contains λ₁(χ), …, `count` of them. Several are in one
/// interval where they are not told apart. The points share one net, and each has a document that is proved.
/// Deterministic. Throws as `eigenvalues`.
[[nodiscard]] std::vector<std::vector<certify::Interval>> bands(const Surface& surface,
                                                                const std::vector<TorusPoint>& points,
                                                                const BandsOptions& options = {});

/// Options of `gap_outside`.
struct GapOptions {
  std::optional<Length> epsilon = {};  ///< Of the net; 0.4 by default.
  std::size_t most = 1'000'000;        ///< At most so many boxes.
  unsigned threads = 0;                ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};              ///< Called occasionally, if given.
  /// Called for each box with a number of its own and its document, which is proved, one after the other in any order.
  std::function<void(std::size_t, const certify::EigenvaluesDocument&)> each = {};
};

/// Proves λ₀(χ) ≥ bound for all characters χ, but those of which all 2g phases are at most `radius` from an integer: by
/// boxes of characters that cover them, or the inverse ones, which have the same eigenvalues. Each box has a document
/// that is proved. Returns the number of boxes. Deterministic.
///
/// Throws NetError if it is not proved: if it takes too many boxes, or λ₀ seems to be less somewhere, which it names;
/// LimitError for genus 5 and more; std::invalid_argument unless 0 < radius < 1/2 and 0 < bound ≤ 10⁴. Time is that of
/// one matrix for each box, and the number of boxes grows as a power 2g of how near the bound is.
std::size_t gap_outside(const Surface& surface, const Rational& radius, double bound, const GapOptions& options = {});

// Hyperbolic lattices: the graph of the tiles of a surface, with phases, as a Hermitian matrix, and its eigenvalues.

/// A Hermitian matrix, sparse.
struct HermitianMatrix {
  /// On and below the diagonal: column ≤ row.
  struct Entry {
    std::uint32_t row;
    std::uint32_t column;
    std::complex<double> value;
  };
  std::uint32_t size = 0;
  std::vector<Entry> entries{};  ///< By column, then by row; each place once.
  double error = 0;  ///< The matrix that is meant differs from this one by one with no eigenvalue of greater modulus.
};

/// Returns the matrix H with (Hf)(v) = Σ f(w) over the neighbours w of v, for functions at the nodes with
/// f(γz) = χ(γ) f(z), χ the character of 2g numbers of turns (character_sides); the adjacency matrix if `turns` is
/// empty. Parts of entries are rounded to binary64, those of multiples of ¼ turn are exact. Throws CharacterError.
/// O(sides log sides).
[[nodiscard]] HermitianMatrix lattice_matrix(const Surface& surface, GraphNodes nodes,
                                             const std::vector<Rational>& turns = {});

/// A lattice of more nodes has its matrix only.
inline constexpr std::uint32_t kMostLatticeNodes = 1500;

/// Returns for all eigenvalues, in increasing order, with multiplicity, an interval that contains it. They are computed
/// by Eigen, and proved by what the product of the matrix with the computed eigenvectors is, and by how far these are
/// from orthonormal (docs/eigenvalues.md). Ends are multiples of a power of 2, at most 2⁻²⁰. Throws LimitError for more
/// than kMostLatticeNodes, and if no proof is found. O(n³).
[[nodiscard]] std::vector<certify::Interval> eigenvalues(const HermitianMatrix& matrix);

/// Writes a MatrixMarket file: coordinate complex hermitian; integer symmetric if all entries are integers.
void write_matrix_market(const HermitianMatrix& matrix, std::ostream& out);

}  // namespace epsnet
