#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/base/interval.h"

/// The options of the checker and its results, as plain data.
namespace epsnet::certify {

/// `refuted`: a rule is proved to fail. `undecided`: neither proved nor refuted within the precision and work allowed.
/// `malformed`: the document is not well-formed. Only `verified` is success.
enum class Verdict { verified, refuted, undecided, malformed };

/// Returns "VERIFIED", "REFUTED", "UNDECIDED" or "MALFORMED".
[[nodiscard]] std::string_view name(Verdict verdict);

/// The least and the greatest precision that a caller may choose, in bits.
inline constexpr long kLeastPrecision = 64;
inline constexpr long kGreatestPrecision = 1L << 20;

/// Options of a check. None of them changes the meaning of a verdict.
struct CheckOptions {
  unsigned threads = 0;       ///< 0: as many as the machine has cores. The result is the same for any number.
  long max_precision = 8192;  ///< Bits; beyond, a comparison is undecided. At least 64, at most 2²⁰.
  /// Units of work (budget.h) after which all remaining questions are undecided; 0: a limit chosen by the size of the
  /// file.
  std::uint64_t max_work = 0;
  /// Files with closed geodesics only: the most lifted triangles visited. If the search for missing geodesics needs
  /// more, the rule `complete` is undecided.
  std::uint64_t max_visits = 1'000'000'000;
  /// All claims but that of a net: the most triangles of the net, each of which takes a kilobyte of memory. Claims
  /// about a larger net are undecided. No such claim needs a finer net.
  std::size_t max_triangles = std::size_t{1} << 20;
  /// Whether questions are tried in binary64, with bounds for its errors, before ball arithmetic (proof.md, section
  /// 16). Changes only the time.
  bool filter = true;
  /// Called occasionally, from the calling thread only, with a rule's name and the share done, 0 to 1.
  std::function<void(std::string_view, double)> progress = {};
};

/// The result of one rule.
struct RuleReport {
  std::string rule;
  Verdict verdict = Verdict::undecided;
  std::string text;  ///< What was proved, or the first element in file order that fails, with its numbers. One line.
};

/// The names of a claim's rules in the order of evaluation.
using RuleNames = std::vector<std::string_view>;

/// Returns "rule: VERDICT: text".
[[nodiscard]] std::string to_string(const RuleReport& report);

/// The sizes of the document, and the cost of the check.
struct Counts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t triangles = 0;
  std::uint64_t genus = 0;
  std::uint64_t tiles = 0;
  std::uint64_t charts = 0;
  std::uint64_t labels = 0;
  std::uint64_t label_identities = 0;  ///< Distinct group equations decided by the rule `gluing`.
  std::uint64_t exact_ties = 0;        ///< Edges whose four corners are exactly cocircular.
  std::uint64_t triangles_beyond_64_bits = 0;
  std::uint64_t max_precision_used = 0;  ///< In bits; the maximum over the rules from gluing on.
  std::uint64_t work = 0;                ///< Units (budget.h), all rules; the same for any number of threads.
  std::optional<std::uint64_t> collars;  ///< The number of collars; only for a pseudo net.
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

/// The cost of checking a geodesics file.
struct GeodesicsCounts {
  std::uint64_t geodesics = 0;
  std::uint64_t lifted_triangles = 0;    ///< Entered in the search for missing geodesics.
  std::uint64_t candidates = 0;          ///< Sequences of edges of perhaps short geodesics.
  std::uint64_t deep_vertices = 0;       ///< Loop edges there inside collars.
  std::uint64_t max_precision_used = 0;  ///< Bits.
};

/// The answer to `check`. There is no conversion to bool: compare `verdict`.
struct Certificate {
  Verdict verdict = Verdict::undecided;
  std::string claim;    ///< The statement proved by the verdict `verified`; empty if malformed. One line.
  std::string rule;     ///< The rule that decided a verdict other than `verified`; "structure" if malformed.
  std::string message;  ///< That rule's text; empty if verified.
  /// The rules that were evaluated, in the order of rules_of. A rule is not evaluated if it depends on a failed one.
  std::vector<RuleReport> rules;
  Counts counts;
  /// The edges whose four corners are exactly cocircular, each by its smaller dart, in order.
  std::vector<std::uint32_t> ties;
  std::optional<Enclosures> enclosures;      ///< Present if the geometry was evaluated.
  std::optional<GeodesicsCounts> geodesics;  ///< Present for a geodesics file whose net is verified.
};

/// Returns the certificate of a document whose structure is broken.
[[nodiscard]] Certificate malformed(const std::string& problem);

/// Returns the verdict and its reason on one line: "VERIFIED", "REFUTED: rule: message", "UNDECIDED: rule: message" or
/// "MALFORMED: message". A non-empty `subject` names the document after a verdict other than VERIFIED: "REFUTED:
/// subject: rule: message".
[[nodiscard]] std::string verdict_line(const Certificate& certificate, std::string_view subject = {});

}  // namespace epsnet::certify
