#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "certify/exact/checker.h"
#include "certify/verdict/report.h"

/// The second checker's part: certify-exact's function, asked about the same bytes as the first one.
namespace epsnet::certify::program {

/// Nets of so many triangles at most, in files of so many bytes at most, are checked twice as a matter of course. The
/// second limit is for words of millions of letters, and for malformed files, where no triangles are counted.
inline constexpr std::uint64_t kTrianglesCheckedTwice = 20'000;
inline constexpr std::uint64_t kBytesCheckedTwice = 4'000'000;

/// What the second checker says, in the words of the first.
struct SecondOpinion {
  Verdict verdict = Verdict::undecided;
  std::string rule;     ///< Empty if verified or malformed; exact::kLeftOut if the file is not for it.
  std::string message;  ///< Empty if verified. One printable line.
};

/// Never throws but for want of memory. The time is bounded by what the checker takes for numbers of labels, and for
/// lists of geodesics, which may be longer if `exact`.
[[nodiscard]] SecondOpinion ask_second_checker(std::string_view bytes, bool exact);

/// "VERIFIED", "REFUTED: rule: message", …
[[nodiscard]] std::string verdict_line(const SecondOpinion& opinion);

/// Whether what one proves contradicts what the other proves: one verifies, the other refutes or finds malformed.
[[nodiscard]] bool disagree(Verdict first, Verdict second);

/// What takes the place of a rule where the two disagree.
inline constexpr const char* kAgreement = "agreement";

/// The certificate, unless the two disagree: then it is undecided by kAgreement, whatever the first one proved.
[[nodiscard]] Certificate agreed(Certificate first, const SecondOpinion& second);

}  // namespace epsnet::certify::program
