#pragma once

#include <gmpxx.h>
#include <string>

/// Numbers compared with sinh² of rational numbers.
namespace epsnet::exact {

/// What is wrong with the claim.
struct Refutation {
  std::string what;
};

/// A question that is too large for exact numbers, or too close for the digits used.
struct TooLarge {
  std::string what;
};

/// A question that is left to others, for what the file says or for its size.
struct LeftOut {
  std::string what;
};

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
template <class R>
[[nodiscard]] Answer is_less(const R& numerator, const R& denominator, const SquaredSinh& s) {
  if (s.infinite) return Answer::yes;
  const R scaled = mpz_class(mpz_class(1) << s.k) * numerator;
  if (sgn(R(scaled - s.lower * denominator)) < 0) return Answer::yes;
  return sgn(R(scaled - s.upper * denominator)) >= 0 ? Answer::no : Answer::unknown;
}

}  // namespace epsnet::exact
