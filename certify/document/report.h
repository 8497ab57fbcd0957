#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/document/interval.h"

/// What the checker is asked and what it answers, as plain data.
namespace epsnet::certify {

/// `refuted`: a rule is proved not to hold. `undecided`: neither proved nor refuted within the precision allowed.
/// `malformed`: not a net at all. Only `verified` is success.
enum class Verdict { verified, refuted, undecided, malformed };

/// "VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED".
[[nodiscard]] std::string_view name(Verdict verdict);

/// Bits: the least and the greatest precision that a caller can ask for.
inline constexpr long kLeastPrecision = 64;
inline constexpr long kGreatestPrecision = 1L << 20;

/// What a check is asked for. None of it changes what a verdict means.
struct CheckOptions {
  unsigned threads = 0;       ///< 0: as many as the machine has cores. The result is the same for any number.
  long max_precision = 8192;  ///< Bits; beyond, a comparison is undecided. At least 64, at most 2²⁰.
  /// Units of work (budget.h) after which what is left is undecided; 0: what a file of this size may take.
  std::uint64_t max_work = 0;
  /// Geodesics files only: lifted triangles visited; with more, a list is not decided to be complete.
  std::uint64_t max_visits = 100'000'000;
  /// Claims about the surface of a net only (geodesics, distances, covers): triangles of the net, each of which takes a
  /// kilobyte of memory; of a net with more, nothing is decided. A finer net is no help for any.
  std::size_t max_triangles = std::size_t{1} << 20;
  /// Whether binary64, with bounds for its errors, is asked before balls (proof.md, section 16). Changes only the time.
  bool filter = true;
  /// Called now and then, from the calling thread only, with a rule's name and the share done, 0 to 1.
  std::function<void(std::string_view, double)> progress = {};
};

/// What one rule says about the document.
struct RuleReport {
  std::string rule;
  Verdict verdict = Verdict::undecided;
  std::string text;  ///< What was proved, or the first element in file order that fails, with its numbers. One line.
};

/// The rules of a claim by name, in the order in which they are asked.
using RuleNames = std::vector<std::string_view>;

/// "rule: VERDICT: text".
[[nodiscard]] std::string to_string(const RuleReport& report);

/// Sizes of what was checked, and what it took.
struct Counts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t triangles = 0;
  std::uint64_t genus = 0;
  std::uint64_t tiles = 0;
  std::uint64_t charts = 0;
  std::uint64_t labels = 0;
  std::uint64_t label_identities = 0;  ///< Different group equations that rule `gluing` had to decide.
  std::uint64_t exact_ties = 0;        ///< Edges whose four corners are exactly cocircular.
  std::uint64_t triangles_beyond_64_bits = 0;
  std::uint64_t max_precision_used = 0;  ///< Bits, largest of the rules from gluing on.
  std::uint64_t work = 0;                ///< Units (budget.h) that all rules took; the same for any number of threads.
  std::optional<std::uint64_t> collars;  ///< Of a pseudo net; absent in any other.
};

/// Intervals that contain the true values, ends rounded outward; lengths are hyperbolic.
struct Enclosures {
  Interval epsilon{};
  Interval area{};
  Interval largest_circumradius{};
  Interval longest_edge{};
  std::optional<Interval>
      shortest_edge;  ///< Between different vertices that are not those of one collar; may be absent.
  std::optional<Interval> shortest_loop;  ///< Absent where no edge is a loop.
  std::optional<Interval> shortest_core;  ///< Of the collars of a pseudo net.
};

/// What it took to check a geodesics file.
struct GeodesicsCounts {
  std::uint64_t geodesics = 0;
  std::uint64_t lifted_triangles = 0;    ///< Visited in the search for geodesics that are missing.
  std::uint64_t candidates = 0;          ///< Short elements that were found, each at each vertex near its axis.
  std::uint64_t deep_vertices = 0;       ///< Vertices whose disks lie in collars.
  std::uint64_t max_precision_used = 0;  ///< Bits.
};

/// The answer to `check`. There is no conversion to bool: compare `verdict`.
struct Certificate {
  Verdict verdict = Verdict::undecided;
  std::string claim;    ///< What holds if the verdict is `verified`, in words; empty if malformed. One line.
  std::string rule;     ///< The rule that decided a verdict other than `verified`; "structure" if malformed.
  std::string message;  ///< That rule's text; empty if verified.
  /// The rules that were evaluated, in the order of rules_of. A rule that needs an earlier one which failed is not
  /// evaluated.
  std::vector<RuleReport> rules;
  Counts counts;
  /// The edges whose four corners are exactly cocircular, each by its smaller dart, in order.
  std::vector<std::uint32_t> ties;
  std::optional<Enclosures> enclosures;      ///< Present if the geometry was evaluated.
  std::optional<GeodesicsCounts> geodesics;  ///< Present for a geodesics file whose net is verified.
};

/// That of a document whose structure is broken.
[[nodiscard]] Certificate malformed(const std::string& problem);

/// The verdict and why it is none other, on one line: "VERIFIED", "REFUTED: rule: message", "UNDECIDED: rule: message"
/// or "MALFORMED: message". `subject`, if it is not empty, says of what, after a verdict other than VERIFIED:
/// "REFUTED: subject: rule: message".
[[nodiscard]] std::string verdict_line(const Certificate& certificate, std::string_view subject = {});

}  // namespace epsnet::certify
