#pragma once

#include <string>
#include <string_view>

/// A second checker of nets, pseudo nets, lists of geodesics, distances, bounds, eigenvalues, isometries, pants
/// decompositions, comparisons of surfaces and closed curves. It computes with integers, of which it makes the
/// algebraic numbers of regular tiles and of tiles over a number field, and with intervals whose ends MPFR rounds where
/// a root or a function is asked.
///
/// It shares nothing with the checker beside it: no ball arithmetic, no JSON library, no threads, no line of code. It
/// is written against docs/format.md and docs/proof.md, in the order of the latter's sections.
namespace epsnet::exact {

/// The values are the exit codes of the program.
enum class Verdict { verified = 0, refuted = 1, undecided = 2, malformed = 3 };

struct Result {
  Verdict verdict = Verdict::undecided;
  std::string rule;     ///< The rule that decided; empty if verified or malformed.
  std::string message;  ///< Of a refuted rule the first culprit; empty if verified.
};

/// What takes the place of a rule where a file is not for this checker; the message says what kind of file it is.
inline constexpr const char* kLeftOut = "document";

/// What a file may ask for.
struct Limits {
  long lifts;                   ///< Lifted vertices for a list of geodesics,
  long lifts_under_isometries;  ///< and if isometries rest on it, which take more time for each loop.
  long values;                  ///< Values of eigenfunctions; and matrices may ask for 2000 multiplications each.
  long bounds;                  ///< Values of sinh² to a few digits, for bounds by cells.
};
/// Some seconds.
inline constexpr Limits kUsualLimits{
    .lifts = 1'000'000, .lifts_under_isometries = 100'000, .values = 100'000, .bounds = 200'000'000};
/// Minutes.
inline constexpr Limits kMostLimits{
    .lifts = 10'000'000, .lifts_under_isometries = 10'000'000, .values = 10'000'000, .bounds = 5'000'000'000};

/// The verdict on a file. Compact files, lists of geodesics that take more lifts, and eigenfunctions and matrices that
/// take more work are undecided, by kLeftOut. Linear time in the size of the file but for the exact numbers of labels,
/// for lists of geodesics, and for eigenvalues. Throws std::bad_alloc only.
[[nodiscard]] Result check(std::string_view text, const Limits& limits = kUsualLimits);

/// Why the text claims nothing, if it is a well-formed surface file, or begins as another kind of file that epsnet
/// writes and that claims nothing, as pictures and meshes. Else empty: then a verdict is asked.
[[nodiscard]] std::string why_no_claim(std::string_view text);

}  // namespace epsnet::exact
