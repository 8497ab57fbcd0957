#include "certify/claims/eigenvalues/line_bundle.h"

#include <array>
#include <gmpxx.h>

#include "certify/base/lookup.h"
#include "certify/net/structure.h"

namespace epsnet::certify {
namespace {

constexpr std::size_t kMostCharacters = 40;

/// Of a number less than 2⁶⁴, also where `unsigned long` is shorter.
std::uint64_t to_uint64(const mpz_class& x) { return std::stoull(x.get_str()); }

mpq_class in_turns(Phase phase, std::uint64_t denominator) {
  mpq_class turns(std::to_string(phase) + "/" + std::to_string(denominator));
  turns.canonicalize();
  return turns;
}

std::string sum_text(Phase sum, std::uint64_t denominator) {
  return " add up to " + in_turns(sum, denominator).get_str() + " modulo 1, not to an integer";
}

}  // namespace

Problem phases_problem(const std::vector<std::string>& phases, std::size_t sides) {
  if (phases.size() != sides)
    return "phases: " + std::to_string(phases.size()) + " elements, expected one for each of " +
           counted(sides, "side", "sides");
  const mpz_class most("1000000000000000000");
  mpz_class denominator = 1;
  return first_row_problem("phases", phases, [&](const std::string& text) -> Problem {
    const bool plain = text.size() <= kMostCharacters && text.find_first_of("eE") == std::string::npos;
    const auto phase = plain ? parse_decimal(text) : std::nullopt;
    if (!phase) return in_quotes(text) + " is not a decimal without exponent or a rational of at most 40 characters";
    if (abs(*phase) >= 1) return in_quotes(text) + " is not between -1 and 1";
    denominator = lcm(denominator, phase->get_den());
    if (denominator > most) return "the least common denominator is more than 10^18";
    return std::nullopt;
  });
}

LineBundle::LineBundle(const std::vector<std::string>& phases) {
  std::vector<mpq_class> values;
  mpz_class denominator = 1;
  for (const std::string& text : phases) denominator = lcm(denominator, values.emplace_back(decimal(text)).get_den());
  denominator_ = to_uint64(denominator);
  for (const mpq_class& value : values) {
    mpz_class numerator = value.get_num() * (denominator / value.get_den());
    if (numerator < 0) numerator += denominator;
    phases_.push_back(to_uint64(numerator));
  }
}

ComplexBall LineBundle::turn(Phase phase) const {
  const mpq_class half_turns = 2 * in_turns(phase, denominator_);
  ComplexBall result;
  fmpq_t exact;
  fmpq_init(exact);
  fmpq_set_mpq(exact, half_turns.get_mpq_t());
  arb_sin_cos_pi_fmpq(result.im(), result.re(), exact, Precision::bits());
  fmpq_clear(exact);
  return result;
}

Phase LineBundle::of(std::span<const std::uint32_t> word) const {
  Phase result = 0;
  if (phases_.empty()) return result;
  for (const std::uint32_t side : word) result = sum(result, looked_up(phases_, side, "there is no side"));
  return result;
}

Problem LineBundle::problem(const SurfaceSides& sides) const {
  const auto name = [&](const char* what, std::uint32_t side) {
    return what + std::to_string(sides.corner[side]) + " of tile " + std::to_string(sides.tile[side]);
  };
  for (std::uint32_t side = 0; side < sides.partner.size(); ++side) {
    const std::uint32_t other = sides.partner[side];
    if (const Phase both = of(std::array{side, other}); both != 0)
      return "those of " + name("side ", side) + " and " + name("side ", other) + sum_text(both, denominator_);
  }
  for (const std::uint32_t first : sides.vertices()) {
    Phase around = 0;
    std::uint32_t side = first;
    do {
      around = sum(around, of(std::array{side}));
      side = sides.next_around(side);
    } while (side != first);
    if (around != 0)
      return "those of the sides crossed around " + name("vertex ", first) + sum_text(around, denominator_);
  }
  return std::nullopt;
}

}  // namespace epsnet::certify
