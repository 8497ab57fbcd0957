#pragma once

#include <cstdint>
#include <gmpxx.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// The JSON of epsnet's files (docs/format.md), read without any library but GMP.
///
/// Numbers are kept as they are written until somebody says what kind they are; nothing is rounded in between.
namespace epsnet::exact {

/// The text is not a document of this format; what() says where and why.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A JSON value. Members of an object have different names.
struct Json {
  enum class Kind { object, array, string, number, literal };
  struct Member;

  Kind kind = Kind::literal;
  std::string text;            ///< Of a string, decoded; of a number or literal, as written.
  std::vector<Json> elements;  ///< Of an array.
  std::vector<Member> members;
};

struct Json::Member {
  std::string name;
  Json value;
};

/// Throws Malformed. No deeper than eight arrays and objects. Linear time and memory.
[[nodiscard]] Json parse_json(std::string_view text);

/// An integer 0 ≤ n < 2³² without sign, fraction or exponent.
[[nodiscard]] std::uint32_t to_index(const Json& value);

/// An integer of at most 2⁵³ in absolute value, without fraction or exponent, as a number.
[[nodiscard]] mpz_class to_small_integer(const Json& value);

/// "-?[0-9]+" or "-?[0-9]+/[0-9]+", of at most 10⁶ digits.
[[nodiscard]] mpq_class to_rational(const Json& value);

/// "-?[0-9]+", of at most 10⁶ digits.
[[nodiscard]] mpz_class to_integer(const Json& value);

/// A rational, or "-?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]{1,4})?".
[[nodiscard]] mpq_class to_decimal(const Json& value);

/// The binary64 nearest to the number, ties to even, as the rational number that it is: mantissa · 2^exponent.
struct Binary64 {
  mpz_class mantissa;
  long exponent = 0;
};
[[nodiscard]] Binary64 to_binary64(const Json& value);

}  // namespace epsnet::exact
