#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "certify/exact/checker.h"
#include "certify/verdict/report.h"

/// The parts of the program certify: its command line, the check of a file by both checkers, what is said of it.
namespace epsnet::certify::program {

// The second checker's part: certify-exact's function, asked about the same bytes as the first one.

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

// What the program says of a file, in words and in JSON.

// Nothing but these is ever returned. 0 if and only if the last line of stdout says VERIFIED, for all files.
inline constexpr int kExitVerified = 0;
inline constexpr int kExitRefuted = 1;
inline constexpr int kExitUndecided = 2;
inline constexpr int kExitMalformed = 3;
inline constexpr int kExitDisagreement = 4;  ///< The two checkers contradict each other.
inline constexpr int kExitNoClaim = 5;       ///< A file of a kind that claims nothing, as of a surface.
inline constexpr int kExitUsage = 64;
inline constexpr int kExitInternal = 70;  ///< The machine failed: memory, a crash, output that cannot be written.
inline constexpr int kExitFault = 71;     ///< The checker found itself to be wrong (Fault).

/// What is said of one file.
struct FileReport {
  std::string name = {};                     ///< As in messages.
  std::string path = {};                     ///< As given.
  std::string sha256 = {};                   ///< Of the bytes that were read; empty if none could be.
  std::string error = {};                    ///< Why there is no verdict; the certificate says nothing then.
  bool fault = false;                        ///< The error is a fault of this program; else it could not be read.
  std::string no_claim = {};                 ///< Why the file claims nothing; the certificate says nothing then.
  bool is_claim = false;                     ///< Whether it was understood, so that there is something to count.
  Certificate certificate = {};              ///< Of both checkers. Its message begins without the file's name.
  std::optional<SecondOpinion> second = {};  ///< Absent if the second checker was not asked.
  std::string not_asked = {};                ///< Why not, if the file was understood.
};

[[nodiscard]] int exit_code(const FileReport& report);

/// The verdict, and why it is none other. `place` names the file, or is empty.
[[nodiscard]] std::string verdict_line(const FileReport& report, const std::string& place);

/// All lines but the verdict. Of a malformed file nothing is counted and nothing claimed.
[[nodiscard]] std::string as_text(const FileReport& report);

/// One object on one line.
[[nodiscard]] std::string as_json(const FileReport& report);

// The command line, and the check.

/// What the command line asks for.
struct Request {
  std::vector<std::string> files;
  CheckOptions options;
  bool exact = false;  ///< Ask the second checker about nets of any size.
  bool json = false;
  bool print_parsed = false;
};

/// The request; or the exit code, after the help, the version or what is wrong was printed.
[[nodiscard]] std::variant<Request, int> parse_command_line(int argc, char** argv);

/// Reads a file once and has both checkers check its bytes. Shows how far it is on a terminal, unless the options say
/// who is told. A fault of this program is reported and no verdict.
[[nodiscard]] FileReport check_file(const Request& request, const std::string& path);

}  // namespace epsnet::certify::program
