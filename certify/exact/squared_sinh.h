#pragma once

#include <gmpxx.h>

/// Rational numbers compared with sinh² of rational numbers.
namespace epsnet::exact {

enum class Answer { no, yes, unknown };

[[nodiscard]] inline Answer operator!(Answer x) {
  return x == Answer::unknown ? x : x == Answer::yes ? Answer::no : Answer::yes;
}
[[nodiscard]] inline Answer both(Answer x, Answer y) {
  if (x == Answer::no || y == Answer::no) return Answer::no;
  return x == Answer::yes && y == Answer::yes ? Answer::yes : Answer::unknown;
}
[[nodiscard]] inline Answer either(Answer x, Answer y) { return !both(!x, !y); }

/// Numbers below and above sinh²x, lower/2^k and upper/2^k. Infinite: more than every number.
struct SquaredSinh {
  mpz_class lower;
  mpz_class upper;
  mp_bitcnt_t k = 0;
  bool infinite = false;
};

inline const SquaredSinh kInfiniteSinh{.lower = {}, .upper = {}, .infinite = true};

/// 0 <= x. To 256 bits. Throws TooLarge if x is more than 1000 or close to 0.
[[nodiscard]] SquaredSinh squared_sinh(const mpq_class& x);

/// Whether numerator/denominator < sinh²x. The denominator is positive. The two are equal only if both are 0.
[[nodiscard]] Answer is_less(const mpz_class& numerator, const mpz_class& denominator, const SquaredSinh& s);

}  // namespace epsnet::exact
