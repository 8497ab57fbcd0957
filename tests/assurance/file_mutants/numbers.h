#pragma once

#include <gmpxx.h>

/// Exact numbers for the reference checker: integers.
namespace epsnet::attack {

/// The reference cannot answer the question.
struct Unknown {
  const char* why;
};

[[nodiscard]] inline int sign(const mpz_class& x) { return sgn(x); }
inline void take_content(const mpz_class& x, mpz_class& content) { content = gcd(content, x); }
inline void divide(mpz_class& x, const mpz_class& content) {
  mpz_divexact(x.get_mpz_t(), x.get_mpz_t(), content.get_mpz_t());
}
[[nodiscard]] inline mpf_class approximation(const mpz_class& x, mp_bitcnt_t bits) { return mpf_class(x, bits); }

}  // namespace epsnet::attack
