#pragma once

#include <gmpxx.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Text of the file format (docs/format.md, "Numbers") and text for messages.
namespace epsnet::certify {

/// What is wrong, in words; nullopt if nothing is.
using Problem = std::optional<std::string>;

/// The largest number of digits of one rational, numerator and denominator together, or of one decimal, before and
/// after the point together and without the exponent. Leading zeros count.
inline constexpr std::size_t kMaxRationalDigits = 1'000'000;

/// The value of a `rational`: -?[0-9]+ or -?[0-9]+/[0-9]+, in lowest terms. Returns nullopt if the text is anything
/// else, if the denominator is zero, or if there are more than kMaxRationalDigits digits. Subquadratic in the number of
/// digits.
[[nodiscard]] std::optional<mpq_class> parse_rational(std::string_view text);

/// The value of a `decimal`, exactly: "0.1" is 1/10. Returns nullopt if the text is not a decimal.
[[nodiscard]] std::optional<mpq_class> parse_decimal(std::string_view text);
/// Returns the value of a decimal. Throws Fault if the text is not a decimal.
[[nodiscard]] mpq_class decimal(std::string_view text);

/// The binary64 number nearest to a JSON number, ties to even; "-0" is −0, and what rounds to 0 keeps its sign. Nothing
/// if the text is not a number as JSON has it, all of it, or if it rounds to infinity. Linear in the length of the
/// text.
[[nodiscard]] std::optional<double> parse_binary64(std::string_view text);

/// The text in quotation marks, on one line, printable ASCII only, shortened. No text of a file can then pass for a
/// line of our own output.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Whether the text is UTF-8 (RFC 3629): no surrogates, no character in more bytes than it needs.
[[nodiscard]] bool is_utf8(std::string_view text);

/// Returns the text with each byte that is not part of printable UTF-8 replaced by a question mark.
[[nodiscard]] std::string printable(std::string_view text);

/// A path in quotation marks, all of it, printable on one line.
[[nodiscard]] std::string path_in_quotes(std::string_view path);

/// Shortest decimal that reads back as the same binary64.
[[nodiscard]] std::string shortest(double value);

/// Returns a number and its noun: "1 tile", "2 tiles".
[[nodiscard]] inline std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count).append(" ").append(count == 1 ? one : many);
}

/// Returns the name that was probably meant by one that is unknown, for messages: the nearest by letters that are
/// inserted, deleted, replaced, or swapped with the next one, of at most a third of the letters and one; or one that
/// begins like it. Dashes in front do not count. Empty if there is none.
[[nodiscard]] std::string nearest_name(const std::string& typed, const std::vector<std::string>& names);

}  // namespace epsnet::certify
